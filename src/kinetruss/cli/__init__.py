"""The command line: each command calls the Python interface."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.cli.commands import main as main

__getattr__, __dir__, __all__ = late(__name__)
