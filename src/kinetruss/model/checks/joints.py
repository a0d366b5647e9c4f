"""Cross-checks of joints: their names must be known, and their bodies must share the nodes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model._words import nearest
from kinetruss.model.checks.common import unknown
from kinetruss.model.parts.joints import GROUND, SHARED

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData
    from kinetruss.model.parts.joints import Joint

__all__ = ["joint_faults"]


def joint_faults(model: ModelData) -> Iterator[Fault]:
    """Unknown names; equal bodies; nodes that do not belong to them."""
    for name, joint in model.joints.items():
        path = ("joints", name)
        yield from _bodies(model, joint, path)
        measured = [node for hinge in joint.hinges for node in (*hinge.axis, hinge.start, hinge.end)]
        for table, names in (
            ("nodes", (*joint.nodes, *measured, *(joint.slide or ()))),
            ("bars", joint.bars),
            ("couplings", joint.couplings),
        ):
            known = getattr(model, table)
            for missing in dict.fromkeys(one for one in names if one not in known):
                yield Fault((*path, table), f"no {table[:-1]} called {missing!r}.", nearest(missing, known))


def _bodies(model: ModelData, joint: Joint, path: tuple[Any, ...]) -> Iterator[Fault]:
    first, second = joint.bodies
    sets: list[set[str]] = []
    if first == second:
        yield Fault((*path, "bodies"), f"joins {first!r} to itself.", "Name two different bodies, or ground.")
    for index, body in enumerate(joint.bodies):
        if body == GROUND:
            own = set(model.fixed)
        elif body in model.bodies:
            own = set(model.bodies[body].nodes)
        else:
            yield unknown("body", body, [*model.bodies, GROUND], (*path, "bodies", index))
            continue
        sets.append(own)
        if not own & set(joint.nodes):
            named = ", ".join(joint.nodes) or "none"
            there = ", ".join(sorted(own)[:6]) or "none"
            mend = f"Add the joint's nodes ({named}) to those of {body!r}, {there} (of ground: fix them)."
            yield Fault((*path, "nodes"), f"none of them belongs to {body!r}: the bodies do not meet there.", mend)
            return
    need = model.dim if joint.kind == "weld" else SHARED.get(joint.kind, 0)
    if len(sets) == 2 and need and len(both := sets[0] & sets[1] & set(joint.nodes)) < need:
        message = f"the bodies share {_listed(both)}; {joint.kind} needs {need}, or they do not meet there."
        mend = f"Name {need} node{'s' if need > 1 else ''} in the joint and in both bodies (of ground: fixed), "
        mend += "or let library.joints make it."
        yield Fault((*path, "nodes"), message, mend)


def _listed(nodes: set[str]) -> str:
    return f"of its nodes only {', '.join(sorted(nodes))}" if nodes else "none of its nodes"
