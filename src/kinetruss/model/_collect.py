"""All faults of the data of a model at once: those of single fields, and those of what is left without them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from pydantic import ValidationError

from kinetruss.errors import Fault, ModelError
from kinetruss.model._words import Path, faults_of

__all__ = ["Lost", "collect", "rests_on"]

Place = tuple[str, ...]

_ROUNDS = 20  # each round removes one level at least; models are less than ten levels deep


def collect(record: Any, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
    """Field faults of `error`, then the cross faults of the model without the faulty fields.

    Fields that are wrong are left out, then the entries that lack them, until the rest can be checked as a model. A cross
    fault that rests on something left out would only repeat what is said already, so it is dropped.
    """
    found = faults_of(error, data, record)
    draft, lost = _Draft(data), Lost()
    stood: set[Path] = set()
    faulty = found
    for _ in range(_ROUNDS):
        if any(not fault.path for fault in faulty):
            break  # about the model as a whole: no part of it can be left out
        for fault in faulty:
            if fault.path in lost and fault.path not in stood:
                # needed, but faulty and therefore left out: a number in its place lets the rest of its record be checked
                stood.add(fault.path)
                draft.put(fault.path, 1)
            else:
                lost.add(draft.take_out(fault.path))
        try:
            record.model_validate(draft.data)
        except ModelError as crossed:
            return found + [fault for fault in crossed.faults if not rests_on(fault, lost)]
        except ValidationError as again:
            faulty = faults_of(again, draft.data, record)
            if any(fault.path == ("nodes",) for fault in faulty):
                break
        else:
            break
    return found


class _Draft:
    """Data with entries taken out; a table is copied when it is first touched."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = dict(data)
        self._own = {id(self.data)}

    def put(self, path: Path, value: Any) -> None:
        """Set the entry at a path whose tables are there."""
        self._table(path[:-1])[path[-1]] = value

    def take_out(self, path: Path) -> Place:
        """Take out the deepest named thing on a path; returns its place.

        A name that is not in the data is missing there: then the thing that lacks it goes.
        """
        keys: list[Any] = []
        here: Any = self.data
        for part in path:
            if not isinstance(here, dict) or part not in here:
                break
            keys.append(part)
            here = here[part]
        if keys:
            del self._table(keys[:-1])[keys[-1]]
        return tuple(map(str, keys))

    def _table(self, keys: Sequence[str | int]) -> dict[Any, Any]:
        here: dict[Any, Any] = self.data
        for key in keys:
            if id(here[key]) not in self._own:
                here[key] = dict(here[key])
                self._own.add(id(here[key]))
            here = here[key]
        return here


class Lost:
    """Places that were left out of the data."""

    def __init__(self, places: Iterable[Place] = ()) -> None:
        self._places: set[Path] = set()
        self._above: set[Path] = set()  # all places that one of them lies in
        for place in places:
            self.add(place)

    def __contains__(self, place: Path) -> bool:
        return place in self._places

    def add(self, place: Path) -> None:
        """One more."""
        self._places.add(place)
        self._above |= {place[:k] for k in range(len(place) + 1)}

    def touches(self, place: Path) -> bool:
        """True where a place lies inside a lost one, or the other way round."""
        return place in self._above or any(place[:k] in self._places for k in range(len(place) + 1))


def rests_on(fault: Fault, lost: Lost) -> bool:
    """True where a place that the fault is about is lost, or part of it."""
    return any(lost.touches(place) for place in fault.about)
