"""All faults of the data of a model at once, and the library records that it names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, get_args, get_origin

from pydantic import ValidationError

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.model.record import Record
from kinetruss.model.references import Ref, kinds
from kinetruss.model.words import Path, faults_of, nearest
from kinetruss.shelves import shelf, shelves


def with_library_records(record: type[Record], data: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a model with the library records that it names, but does not define, added to its tables."""
    added: dict[str, dict[str, Any]] = {}
    for table, name in dict.fromkeys(_named(record, data)):
        own = data.get(table)
        if (own is None or (isinstance(own, Mapping) and name not in own)) and name in (records := shelf(table)):
            added.setdefault(table, {})[name] = records[name]
    return dict(data) | {table: {**(data.get(table) or {}), **records} for table, records in added.items()}


def from_library(value: Any, table: str) -> Any:
    """The library's record of this name for a table; other values unchanged."""
    if not isinstance(value, str):
        return value
    if (found := shelf(table).get(value)) is None:
        raise ValueError(f"no {table[:-1]} called {shown(value)} in the library. {nearest(value, shelf(table))}")
    return found


def _named(record: type[Record], data: Any) -> Iterator[tuple[str, str]]:
    """Table and name of every entry that the data of a record name and the library may have."""
    for field, table, below, tabled in _naming(record):
        value = data.get(field) if isinstance(data, Mapping) else getattr(data, field, None)
        if isinstance(value, str):
            if table:
                yield table, value
        elif value is not None:
            for kind in below:
                for one in value.values() if tabled and isinstance(value, Mapping) else (value,):
                    yield from _named(kind, one)


@cache
def _naming(record: type[Record]) -> tuple[tuple[str, str, tuple[type[Record], ...], bool], ...]:
    """The fields of a record that can name entries of the library: the table, the records in which such fields are, and
    whether the field is a table of these.
    """
    found = []
    for name, field in record.model_fields.items():
        tabled = get_origin(field.annotation) is dict
        types = [*kinds(get_args(field.annotation)[1] if tabled else field.annotation, field.metadata)]
        tables = [mark.tables[0] for _, marks in types for mark in marks if isinstance(mark, Ref)]
        table = next((one for one in tables if one in shelves()), "")
        below = () if table else tuple(one for one, _ in types if isinstance(one, type) and issubclass(one, Record))
        found += [(name, table, below, tabled)] if table or below else []
    return tuple(found)


# All faults of the data of a model at once: field faults, then cross-faults of the model without the faulty fields.

Place = tuple[str, ...]

_ROUNDS = 20  # each round removes at least one level; models are less than ten levels deep


def collect(record: Any, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
    """Field faults of `error`, then the cross faults of the model without the faulty fields.

    Faulty fields are left out, then the entries that need them, until the remaining data can be checked as a model. A
    cross-fault that depends on an entry left out would only repeat a reported fault, so it is dropped.
    """
    found = faults_of(error, data, record)
    draft, lost = _Draft(data), Lost()
    stood: set[Path] = set()
    faulty = found
    for _ in range(_ROUNDS):
        if any(not fault.path for fault in faulty):
            break  # a fault of the model as a whole: no part of it can be left out
        for fault in faulty:
            if fault.path in lost and fault.path not in stood:
                # a required field that is faulty and left out: a number in its place lets the rest of its record be checked
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
    """Data with entries removed; a table is copied at its first change."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = dict(data)
        self._own = {id(self.data)}

    def put(self, path: Path, value: Any) -> None:
        """Set the entry at a path, unless what it belongs to has been taken out by another fault."""
        if len(self._there(path[:-1])) == len(path) - 1:
            self._table(path[:-1])[path[-1]] = value

    def take_out(self, path: Path) -> Place:
        """Remove the deepest named entry on a path, and return its place.

        If the last name is not in the data, the entry that lacks it is removed.
        """
        keys = self._there(path)
        if keys:
            del self._table(keys[:-1])[keys[-1]]
        return tuple(map(str, keys))

    def _there(self, path: Path) -> list[Any]:
        """The names on a path as far as they are in the data."""
        keys: list[Any] = []
        here: Any = self.data
        for part in path:
            if not isinstance(here, dict) or part not in here:
                break
            keys.append(part)
            here = here[part]
        return keys

    def _table(self, keys: Sequence[str | int]) -> dict[Any, Any]:
        here: dict[Any, Any] = self.data
        for key in keys:
            if id(here[key]) not in self._own:
                here[key] = dict(here[key])
                self._own.add(id(here[key]))
            here = here[key]
        return here


class Lost:
    """Places of removed entries."""

    def __init__(self, places: Iterable[Place] = ()) -> None:
        self._places: set[Path] = set()
        self._above: set[Path] = set()  # all places that contain one of them
        for place in places:
            self.add(place)

    def __contains__(self, place: Path) -> bool:
        return place in self._places

    def add(self, place: Path) -> None:
        """Add a place."""
        self._places.add(place)
        self._above |= {place[:k] for k in range(len(place) + 1)}

    def touches(self, place: Path) -> bool:
        """True if a place is inside a removed one, or contains one."""
        return place in self._above or any(place[:k] in self._places for k in range(len(place) + 1))


def rests_on(fault: Fault, lost: Lost) -> bool:
    """True if a place that the fault depends on is removed in whole or in part.

    >>> import kinetruss as kt
    >>> fault = kt.Fault(("bars", "b"), "has no end B.", "Add the node.", about=(("nodes", "B"),))
    >>> [kt.model.rests_on(fault, kt.model.Lost([place])) for place in (("nodes", "B"), ("loads", "f"))]
    [True, False]
    """
    return any(lost.touches(place) for place in fault.about)
