"""The arms, hinges and bearings of members that are taken out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.model import Model

__all__ = ["without_arms"]


def without_arms(model: Model, changes: Mapping[str, Any], failed: set[str]) -> dict[str, Any]:
    """The tables without the arms, hinges, clamps and bearings of members that are gone; a hub without any is a node again.

    changes : the tables ``bars`` and ``drives`` without these members and what drives them.
    """
    if not (failed and (model.hubs or model.bearings)):
        return {}
    starts = tuple(f"{hub}.{member}" for hub in model.hubs for member in failed)

    def gone(name: Any) -> bool:
        return any(str(name) == one or str(name).startswith(f"{one}.") for one in starts)

    def left(table: Mapping[str, Any]) -> dict[str, Any]:
        return {name: record for name, record in table.items() if not gone(name)}

    hubs = _hubs(model, failed)
    bodies = {}
    for name, body in model.bodies.items():
        of_hub = name.endswith(".hub") and name.removesuffix(".hub") in model.hubs
        # the body of a hub that loses an arm is made anew from the hub
        if (
            name.removesuffix(".hub") in hubs and not any(map(gone, body.nodes))
            if of_hub
            else name.removesuffix(".hinges") not in failed
        ):
            bodies[name] = body
    return {
        "hubs": hubs,
        "bodies": bodies,
        "bars": {name: bar for name, bar in left(changes["bars"]).items() if not any(map(gone, bar.ends))},
        "drives": {name: one for name, one in changes["drives"].items() if not any(map(gone, _values(one.model_dump())))},
        "nodes": left(model.nodes),
        "fixed": left(model.fixed),
        "support_motion": left(model.support_motion),
        "couplings": left(model.couplings),
        "bearings": {name: one for name, one in model.bearings.items() if not {one.member, one.against} & failed},
    }


def _hubs(model: Model, failed: set[str]) -> dict[str, Any]:
    """Hubs without these members."""
    found = {}
    for name, hub in model.hubs.items():
        arms, hinges = (
            {member: one for member, one in table.items() if member not in failed} for table in (hub.arms, hub.hinges)
        )
        clamped = tuple(member for member in hub.clamped if member not in failed)
        if arms or clamped or hub.reach:
            found[name] = hub.with_(arms=arms, hinges=hinges, clamped=clamped)
    return found


def _values(value: Any) -> Iterable[Any]:
    """All values within mappings and sequences."""
    if isinstance(value, Mapping):
        value = list(value.values())
    if isinstance(value, (list, tuple)):
        for one in value:
            yield from _values(one)
    else:
        yield value
