"""Ready-made trusses and mechanisms, materials, sections, drive trains; examples. The parts are imported at first use."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.library import (
        bodies as bodies,
        cells as cells,
        drives as drives,
        joints as joints,
        materials as materials,
        mechanisms as mechanisms,
        meshes as meshes,
        sections as sections,
        vgt as vgt,
    )
    from kinetruss.library.building import build as build, builders as builders, parametric as parametric
    from kinetruss.library.example_texts import example_files as example_files, example_text as example_text

__getattr__, __dir__, __all__ = late(__name__)
