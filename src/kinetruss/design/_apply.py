"""A model with the chosen tubes and drives."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from kinetruss.design._plan import Plan
from kinetruss.model import Active, Gear, LeadScrew, Model

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["with_drives", "with_tubes"]


def with_tubes(model: Model, plan: Plan, choice: NDArray[np.int64]) -> Model:
    """The model with a tube for every group; the masses of its members are those of the tubes."""
    bars, active = dict(model.bars), dict(model.active)
    sections, materials = dict(model.sections), dict(model.materials)
    for group, index in zip(plan.groups, choice, strict=True):
        section = _entry(sections, group.tube_name(int(index)), group.tube(int(index)))
        changes: dict[str, Any] = {"section": section, "mass": None}
        if group.material is not None:
            changes["material"] = _entry(materials, "sized", group.material)
        for name in group.members:
            if name in active:
                active[name] = active[name].with_(tube=active[name].tube.with_(**changes))
            else:
                bars[name] = bars[name].with_(**changes)
    changed: dict[str, Any] = {"bars": bars, "active": active, "safety": plan.safety}
    changed["sections"] = _used(model, sections, bars, active, "section")
    changed["materials"] = _used(model, materials, bars, active, "material")
    return model.with_(**changed)


def with_drives(model: Model, chosen: Mapping[str, tuple[tuple[str, Any], ...]]) -> Model:
    """The model with screws, gears and motors: member -> (name, record) of each chosen one."""
    tables: dict[str, dict[str, Any]] = {kind: dict(getattr(model, kind)) for kind in ("screws", "gears", "motors")}
    active = dict(model.active)
    for member, records in chosen.items():
        changes = {}
        for name, one in records:
            kind = "screw" if isinstance(one, LeadScrew) else "gear" if isinstance(one, Gear) else "motor"
            changes[kind] = _entry(tables[f"{kind}s"], name, one)
        active[member] = active[member].with_(**changes)
    for kind, table in tables.items():
        named = {getattr(member, kind[:-1]) for member in active.values()}
        tables[kind] = {name: one for name, one in table.items() if name in named or name not in _named_before(model, kind)}
    return model.with_(active=active, **tables)


def _named_before(model: Model, kind: str) -> set[Any]:
    return {getattr(member, kind[:-1]) for member in model.active.values()}


def _entry(table: dict[str, Any], name: str, record: Any) -> str:
    """The name of a record in a table; the record is added under a free name if the table does not have it."""
    while name in table and table[name] != record:
        name += "_"
    table[name] = record
    return name


def _used(model: Model, table: dict[str, Any], bars: dict[str, Any], active: dict[str, Active], field: str) -> dict[str, Any]:
    """The table without entries that only sized members used before."""

    def names(some_bars: Mapping[str, Any], some_active: Mapping[str, Active]) -> set[Any]:
        parts = [*some_bars.values(), *(part for one in some_active.values() for part in (one.base, one.tube))]
        return {getattr(part, field) for part in parts if isinstance(getattr(part, field), str)}

    before, now = names(model.bars, model.active), names(bars, active)
    default = getattr(model, field)
    return {name: one for name, one in table.items() if name in now or name not in before or name == default}
