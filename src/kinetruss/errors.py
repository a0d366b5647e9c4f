"""Everything kinetruss raises on purpose.

KinetrussError
├── InputError            what the user gave cannot be used; nothing was computed (exit 2)
│   ├── ModelError        one or more faults of a model, all named at once
│   └── UnitError         a text that is not `number unit` of the wanted quantity
├── AnalysisError         found while working; carries the best result so far (exit 1)
└── StoreError            a run folder or file that cannot be read or written (exit 1)

Interrupted               Ctrl-C on the way; a KeyboardInterrupt that carries the result up to there
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of the input: where it is, what is wrong, how to mend it.

    `path` is the place in the model, e.g. ``("bars", "M7", "section")``; `line` and `column` (from 1)
    are filled in by the reader of a file; `file` names another file than the one read, e.g. a table it uses.
    `about` are places this fault rests on: where one of them is faulty itself, this fault is not told.
    """

    path: tuple[str | int, ...]
    message: str
    mend: str
    line: int | None = None
    column: int | None = None
    file: str | None = None
    about: tuple[tuple[str, ...], ...] = ()

    def __str__(self) -> str:
        where = ".".join(str(part) for part in self.path) or "model"
        return f"{where}: {self.message} {self.mend}".rstrip()


class KinetrussError(Exception):
    """Base of all errors raised on purpose."""

    exit_code = 1


class InputError(KinetrussError):
    """What the user gave cannot be used; nothing was computed."""

    exit_code = 2


class UnitError(InputError, ValueError):
    """A text that is not `number unit` of the wanted quantity."""


class ModelError(InputError):
    """A model with faults; `faults` lists them all."""

    def __init__(self, faults: list[Fault], source: str | None = None) -> None:
        self.faults = list(faults)
        self.source = source
        super().__init__("\n".join(self.lines()))

    def lines(self) -> list[str]:
        """One line a fault, ``file:line:column: path: message mend`` where the file is known."""
        return [_placed(fault, self.source) for fault in self.faults]


class AnalysisError(KinetrussError):
    """An analysis that could not go on; `result` holds what is good up to there (or None)."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during an analysis; `result` holds what is good up to there. No `Exception`: it stops what calls it too."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


class StoreError(KinetrussError):
    """A run folder or file that cannot be read or written."""


def _placed(fault: Fault, source: str | None) -> str:
    source = fault.file or source
    if source is None:
        return str(fault)
    place = source if fault.line is None else f"{source}:{fault.line}:{fault.column or 1}"
    return f"{place}: {fault}"
