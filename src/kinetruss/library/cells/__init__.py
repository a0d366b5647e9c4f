"""Trusses from cells: ready cells and one's own, stacked, mirrored, branched, closed into rings."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.library.cells.assemblies import (
        assemble as assemble,
        branch as branch,
        cell as cell,
        chain as chain,
        ring as ring,
        stack as stack,
        stacked as stacked,
    )
    from kinetruss.library.cells.fittings import Actuator as Actuator
    from kinetruss.library.cells.joining import mirror as mirror
    from kinetruss.library.cells.octahedra import (
        Rods as Rods,
        double_octahedron as double_octahedron,
        quadruple_octahedron as quadruple_octahedron,
    )
    from kinetruss.library.cells.records import Cell as Cell, Face as Face
    from kinetruss.library.cells.shapes import (
        cube as cube,
        decahedron as decahedron,
        octahedron as octahedron,
        panel as panel,
        prism as prism,
        tetrahedron as tetrahedron,
        triangle as triangle,
    )

__getattr__, __dir__, __all__ = late(__name__)
