"""Models and runs in a notebook: ``%load_ext kinetruss`` shows them as pictures, `live` shows a model with sliders.

Parts are imported when first used. No other package depends on notebooks.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.notebook._live import live as live
    from kinetruss.notebook._register import register as register
    from kinetruss.notebook._show import show as show

__getattr__, __dir__, __all__ = late(__name__)
