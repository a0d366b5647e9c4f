"""Numbers printed in the thesis, each with its class, its note and the inputs that were inferred."""

from __future__ import annotations

from dataclasses import dataclass

from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["Printed", "printed"]


@dataclass(frozen=True)
class Printed:
    """A printed number: the id says where it stands and what it is."""

    id: str
    reference: Reference
    expected: float
    tolerance: float


def printed(part: str) -> tuple[Printed, ...]:
    """The printed numbers of a part, ``"triangle"`` or ``"bay"``."""
    data = load("printed")
    found = []
    for entry in data[part]:
        inferred = tuple(data["inferred"][key] for key in entry.get("inferred", ()))
        reference = Reference(entry["class"], entry["source"], entry.get("note", ""), inferred)
        found.append(Printed(entry["id"], reference, entry["expected"], entry["tolerance"]))
    return tuple(found)
