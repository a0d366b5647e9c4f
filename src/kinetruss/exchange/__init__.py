"""Files of other programs: robots, drawings, meshes in; models and runs out. What cannot be carried is listed."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.exchange.file_reading import read as read
    from kinetruss.exchange.file_writing import FORMATS as FORMATS, Written as Written, write as write
    from kinetruss.exchange.imported import Imported as Imported
    from kinetruss.exchange.robots import LeftOut as LeftOut

__getattr__, __dir__, __all__ = late(__name__)
