"""What a probe answers: arrays whose places have names, the size that a difference is measured by, and files of them."""

from __future__ import annotations

import gzip
import hashlib
import pickle
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

BATCH = 50
ASSEMBLED = 1e-13
"""Allowed difference of what is assembled, of the sum of the absolute values of its terms."""
SOLVED = 1e-10
"""The same of what is solved, of an estimate of its condition."""


@dataclass(frozen=True, eq=False)
class Part:
    """One quantity. places : names along every axis of value. scale : of its shape, or one number.

    allowed : difference that is none, of the scale.
    """

    value: np.ndarray
    places: tuple[tuple[str, ...], ...] = ()
    scale: Any = None
    allowed: float = ASSEMBLED


@dataclass(frozen=True)
class Refused:
    """A quantity that ended in an error of this kind."""

    error: str


@dataclass(eq=False)
class Answer:
    """All that a probe says of a case. covers : kinds of elements, loads, drives and laws in it."""

    number: int
    name: str
    fingerprint: str
    covers: tuple[str, ...] = ()
    parts: dict[str, Part | Refused] = field(default_factory=dict)

    def refuse(self, name: str, error: Exception) -> None:
        """Note a quantity that ended in an error."""
        self.parts[name] = Refused(type(error).__name__)


def asked(answer: Answer, name: str, question: Callable[[], Part]) -> None:
    """Put a question; an error of the package's own is an answer too, and so is any other."""
    try:
        answer.parts[name] = question()
    except Exception as error:  # noqa: BLE001 - compared by its kind
        answer.refuse(name, error)


def write(path: Path, answers: list[Answer]) -> None:
    """Keep answers; the file takes its name when it is whole."""
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_suffix(".part")
    with gzip.open(draft, "wb", compresslevel=1) as file:
        pickle.dump(answers, file)
    draft.replace(path)


def read(path: Path) -> list[Answer]:
    """Answers of a file that `write` made."""
    with gzip.open(path, "rb") as file:
        found: list[Answer] = pickle.load(file)
    return found


def batches(count: int) -> Iterator[tuple[int, int]]:
    """First and last case of every batch."""
    for first in range(0, count, BATCH):
        yield first, min(first + BATCH, count)


def answer_all(folder: Path, kind: str, count: int, answer: Callable[[int], Answer]) -> None:
    """Answer cases 0:count in files of a folder, batch by batch; what is there already is kept."""
    began = time.monotonic()
    for first, last in batches(count):
        path = folder / f"{kind}-{first}-{last}.answers"
        if not path.exists():
            write(path, [answer(number) for number in range(first, last)])
        print(f"{time.monotonic() - began:.0f} s: {kind} {last} of {count}", file=sys.stderr, flush=True)


def state_of(files: list[Path], *more: Any) -> str:
    """A name for what answers depend on beside the revision: files, versions, numbers."""
    parts = [file.read_bytes() for file in sorted(files)] + [repr((np.__version__, *more)).encode()]
    return hashlib.sha256(b" ".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()[:12]
