"""All faults of the data of a model at once: those of single fields, and those of what is left without them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydantic import ValidationError

from kinetruss.errors import Fault, ModelError
from kinetruss.model._words import Path, faults_of

__all__ = ["collect", "rests_on"]

_ROUNDS = 20  # each round removes one level at least; models are less than ten levels deep


def collect(record: Any, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
    """Field faults of `error`, then the cross faults of the model without the faulty fields.

    Fields that are wrong are left out, then the entries that lack them, until the rest can be checked as a model. A cross
    fault that rests on something left out would only repeat what is said already, so it is dropped.
    """
    found = faults_of(error, data, record)
    lost: list[tuple[str, ...]] = []
    stood: set[Path] = set()
    faulty = found
    for _ in range(_ROUNDS):
        if any(not fault.path for fault in faulty):
            break  # about the model as a whole: no part of it can be left out
        for fault in faulty:
            if fault.path in lost and fault.path not in stood:
                # needed, but faulty and therefore left out: a number in its place lets the rest of its record be checked
                stood.add(fault.path)
                data = _replaced(data, [str(key) for key in fault.path], {fault.path[-1]: 1})
                continue
            data, place = _without(data, fault.path)
            lost.append(place)
        try:
            record.model_validate(data)
        except ModelError as crossed:
            return found + [fault for fault in crossed.faults if not rests_on(fault, lost)]
        except ValidationError as again:
            faulty = faults_of(again, data, record)
            if any(fault.path == ("nodes",) for fault in faulty):
                break
        else:
            break
    return found


def _without(data: dict[str, Any], path: Path) -> tuple[dict[str, Any], tuple[str, ...]]:
    """The data without the deepest named thing on a path, and its place.

    A name that is not in the data is missing there: then the thing that lacks it goes.
    """
    keys: list[str] = []
    here: Any = data
    for part in path:
        if not isinstance(here, dict) or part not in here:
            break
        keys.append(str(part))
        here = here[part]
    return (_replaced(data, keys, {}) if keys else data), tuple(keys)


def _replaced(data: dict[str, Any], keys: list[str], last: dict[Any, Any]) -> dict[str, Any]:
    """The data with the entry at the end of a path of keys taken out and `last` put in."""
    key, *rest = keys
    if not rest:
        return {name: value for name, value in data.items() if name != key} | last
    return data | {key: _replaced(data[key], rest, last)}


def rests_on(fault: Fault, lost: Sequence[tuple[str, ...]]) -> bool:
    """True where a place the fault is about lies inside a lost one, or the other way round."""
    return any(place[: len(gone)] == gone[: len(place)] for place in fault.about for gone in lost)
