"""Short labels that distinguish runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import quantity
from kinetruss.io.models import resolved
from kinetruss.model import Of, Record
from kinetruss.runs.many import short_paths
from kinetruss.units import EITHER, NUMBER, unit_of

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.runs import RunResult

__all__ = ["run_labels"]

MOST = 2
"""Largest number of differences in a label; if models differ more, the name of the run's folder is used."""


def run_labels(runs: Sequence[RunResult]) -> list[str]:
    """One label per run: settings that differ, else differences of the models, else names of folders or runs."""
    if len(runs) == 1:
        return [runs[0].path.name if runs[0].path else runs[0].name]
    found = _by_values(runs, [run.settings for run in runs]) if all(run.settings for run in runs) else None
    if found is None:
        found = _by_values(runs, [_leaves(run.model.model_dump(exclude={"title"})) for run in runs], MOST)
    return found or _numbered([run.path.name if run.path else run.name for run in runs])


def _by_values(runs: Sequence[RunResult], tables: Sequence[Mapping[str, Any]], most: int = 10) -> list[str] | None:
    """Labels from the values that differ between tables; None if they do not distinguish the runs."""
    if len({tuple(table) for table in tables}) > 1:
        return None
    differing = [path for path in tables[0] if len({str(table[path]) for table in tables}) > 1]
    if not 0 < len(differing) <= most:
        return None
    keys = short_paths(differing)
    labels = [
        ", ".join(f"{keys[path].replace('_', ' ')} {_with_unit(run.model, path, str(table[path]))}" for path in differing)
        for run, table in zip(runs, tables, strict=True)
    ]
    return labels if len(set(labels)) == len(labels) else None


def _with_unit(model: Model, path: str, value: str) -> str:
    """A bare number with the SI unit of its field."""
    if not NUMBER.fullmatch(value):
        return value
    here: Any = model
    unit = ""
    try:
        for key in resolved(model, path):
            if isinstance(here, Record):
                rules = [rule for rule in type(here).model_fields[str(key)].metadata if isinstance(rule, Of)]
                unit = unit_of(rules[0].quantity) if rules and rules[0].quantity not in EITHER else ""
                here = getattr(here, str(key))
            else:
                here = here[key]
    except (KeyError, IndexError, ValueError):
        return value  # a parameter of a library model: the value as it was given
    return quantity(float(value), unit, 6)


def _leaves(value: Any, path: str = "") -> dict[str, Any]:
    """Every value of nested tables by its dotted path."""
    if isinstance(value, Mapping):
        items: Any = value.items()
    elif isinstance(value, (list, tuple)) and len(value) <= 10:
        items = enumerate(value)
    else:
        return {path: value}
    found: dict[str, Any] = {}
    for key, below in items:
        found |= _leaves(below, f"{path}.{key}" if path else str(key))
    return found


def _numbered(names: Sequence[str]) -> list[str]:
    """Names, with a number if one occurs more than once."""
    return [f"{name} ({k + 1})" if names.count(name) > 1 else name for k, name in enumerate(names)]
