"""All exceptions that kinetruss raises.

KinetrussError
├── InputError            invalid input; nothing was computed (exit 2)
│   ├── ArgumentError     an unknown or a missing argument of a function or record; also a TypeError
│   ├── ModelError        one or more faults of a model, reported together
│   ├── UnitError         a text that is not `number unit` of the expected quantity
│   └── FrozenError       an attempt to change a record or one of its tables in place
├── AnalysisError         an analysis failed; carries the best result so far (exit 1)
│   └── InfeasibleError   no design keeps all limits of an optimum
└── StoreError            a run folder or file that cannot be read or written (exit 1)

Interrupted               Ctrl-C during an analysis; a KeyboardInterrupt that carries the result so far
KernelCacheWarning        compiled kernels cannot be stored on disk
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

__all__ = [
    "AnalysisError",
    "ArgumentError",
    "Fault",
    "FrozenError",
    "InfeasibleError",
    "InputError",
    "Interrupted",
    "KernelCacheWarning",
    "KinetrussError",
    "ModelError",
    "StoreError",
    "UnitError",
    "few",
    "one_line",
    "plain",
    "shown",
]

LONGEST_VALUE = 80
"""Largest number of characters of a value in a message."""

LONGEST_TEXT = 1000
"""Largest number of characters of the message, and of the fix, of one fault."""

MOST_LINES = 200
"""Largest number of faults in the text of a `ModelError`."""

LONGEST_MESSAGE = 4000
"""Largest number of characters of any other message."""

# control characters, and characters that change the direction of text or are invisible
_UNPRINTED = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ud800-\udfff]")


def plain(text: str, most: int = LONGEST_TEXT) -> str:
    r"""Text that is safe to print: control characters are written as escapes, and long text is cut in its middle.

    >>> import kinetruss as kt
    >>> print(kt.errors.plain("a bell \a rings"))
    a bell \x07 rings
    """
    if len(text) > most:
        last = max(most // 3 - 5, 0)
        text = f"{text[: most * 2 // 3]} ... {text[len(text) - last :]}"
    return _UNPRINTED.sub(lambda found: ascii(found[0])[1:-1], text)


def one_line(text: str, most: int = LONGEST_VALUE) -> str:
    r"""A name for a message or a table: safe to print, on one line, cut if it is long.

    >>> import kinetruss as kt
    >>> kt.errors.one_line("a name\nof two lines")
    'a name\\nof two lines'
    """
    return plain(text, most).replace("\n", "\\n").replace("\t", "\\t")


def shown(value: object) -> str:
    """A value for a message: on one line, safe to print, cut if it is long.

    >>> import kinetruss as kt
    >>> print(kt.errors.shown("crank"), kt.errors.shown([1, 2]))
    'crank' [1, 2]
    """
    if isinstance(value, (str, bytes)) and len(value) > LONGEST_VALUE:
        value = value[:LONGEST_VALUE]  # the rest would be cut anyway
        return f"{one_line(repr(value))[: LONGEST_VALUE - 3]}..."
    try:
        text = one_line(repr(value), 2 * LONGEST_VALUE)
    except ValueError:  # Python refuses to print integers of thousands of digits
        text = f"{type(value).__name__} too long to show"
    return text if len(text) <= LONGEST_VALUE else f"{text[: LONGEST_VALUE - 3]}..."


def few(texts: Sequence[str], most: int, between: str = ", ") -> str:
    """The first `most` of some names or sentences, and the number of those that are left out.

    >>> import kinetruss as kt
    >>> kt.errors.few(["A", "B", "C", "D"], 2)
    'A, B and 2 more'
    """
    return between.join(texts[:most]) + (f" and {len(texts) - most} more" if len(texts) > most else "")


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of the input: where it is, what is wrong, and the fix.

    `path` is the place in the model, e.g. ``("bars", "M7", "section")``; `line` and `column` (from 1)
    are filled in by the reader of a file; `file` names another file than the one read, e.g. a table it uses. `about` lists
    places that this fault depends on: if one of them is faulty itself, this fault is not reported.
    """

    path: tuple[str | int, ...]
    message: str
    mend: str
    line: int | None = None
    column: int | None = None
    file: str | None = None
    about: tuple[tuple[str, ...], ...] = ()

    def __post_init__(self) -> None:
        # values in a message may hold characters that a terminal cannot show
        object.__setattr__(self, "message", plain(self.message))
        object.__setattr__(self, "mend", plain(self.mend))

    @property
    def where(self) -> str:
        """The place in the model as text, e.g. ``bars.M7.section``."""
        return ".".join(one_line(str(part)) for part in self.path) or "model"

    def __str__(self) -> str:
        return f"{self.where}: {self.message} {self.mend}".rstrip()


class KinetrussError(Exception):
    """Base of all errors of kinetruss."""

    exit_code = 1

    def __init__(self, message: str = "") -> None:
        super().__init__(plain(str(message), LONGEST_MESSAGE))


class InputError(KinetrussError):
    """Invalid input; nothing was computed."""

    exit_code = 2


class ArgumentError(InputError, TypeError):
    """An unknown or a missing argument of a function or record."""


class UnitError(InputError, ValueError):
    """A text that is not `number unit` of the expected quantity."""


class FrozenError(InputError, TypeError):
    """An attempt to change a record, or a table in it, in place; `with_` returns a changed copy."""


class ModelError(InputError):
    """A model with faults; `faults` lists them all."""

    def __init__(self, faults: list[Fault], source: str | None = None) -> None:
        self.faults = list(faults)
        self.source = source
        Exception.__init__(self, "\n".join(self.lines()))

    def lines(self) -> list[str]:
        """One line for each fault, ``file:line:column: path: message mend`` if the file is known; at most `MOST_LINES`."""
        lines = [_placed(fault, self.source) for fault in self.faults[:MOST_LINES]]
        more = len(self.faults) - MOST_LINES
        return [*lines, f"... and {more:,} faults more."] if more > 0 else lines

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.faults, self.source)


class AnalysisError(KinetrussError):
    """An analysis that failed; `result` holds the valid results so far (or None)."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


class InfeasibleError(AnalysisError):
    """No design within its bounds keeps all limits of an optimum, as far as a search shows."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during an analysis; `result` holds the valid results so far. It is not an `Exception`."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)


class StoreError(KinetrussError):
    """A run folder or file that cannot be read or written."""


class KernelCacheWarning(UserWarning):
    """Compiled kernels cannot be stored on disk: every process compiles its own."""


def _placed(fault: Fault, source: str | None) -> str:
    source = fault.file or source
    if source is None:
        return str(fault)
    source = plain(source)
    place = source if fault.line is None else f"{source}:{fault.line}:{fault.column or 1}"
    return f"{place}: {fault}"
