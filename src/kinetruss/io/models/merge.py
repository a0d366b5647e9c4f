"""Merges the keys of a model file into a library model, by name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinetruss.model import GROUND, Model, Record

__all__ = ["fields", "merged"]

AXES = "xyz"


def fields(record: Record) -> dict[str, Any]:
    """The given fields of a record by name, including its kind; values are not converted."""
    given = {name: getattr(record, name) for name in type(record).model_fields if name in record.model_fields_set}
    return {"kind": record.kind, **given} if "kind" in type(record).model_fields else given  # type: ignore[attr-defined]


def merged(model: Model, over: Mapping[str, Any]) -> dict[str, Any]:
    """Data of `model`, changed by `over`.

    Tables merge name by name and records field by field, to any depth; the value ~ removes an entry. Any other value
    replaces the old one, and so does a record of another kind. A list under ``fixed`` or ``clamped`` adds its nodes.
    """
    over = dict(over)
    fixed = over.get("fixed")
    if isinstance(fixed, list) and all(isinstance(name, str) for name in fixed):
        over["fixed"] = dict.fromkeys(fixed, AXES[: model.dim])
    clamped = over.get("clamped")
    if isinstance(clamped, list) and all(isinstance(name, str) for name in clamped):
        over["clamped"] = dict.fromkeys(clamped, GROUND)
    base = fields(model)
    return base | {key: _laid(base.get(key), value) for key, value in over.items()}


def _laid(base: Any, over: Any) -> Any:
    if not isinstance(over, Mapping) or base is None:
        return over
    if isinstance(base, Record):
        known = fields(base)
        if over.get("kind", known.get("kind")) != known.get("kind"):
            return over
        return known | {key: _laid(known.get(key), value) for key, value in over.items()}
    if isinstance(base, Mapping):
        laid = {**base, **{key: _laid(base.get(key), value) for key, value in over.items()}}
        return {key: value for key, value in laid.items() if value is not None}
    return over
