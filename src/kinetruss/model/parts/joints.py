"""Joints by name: which nodes and bars make one between two bodies, and what can be measured at it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field

from kinetruss.errors import Fault
from kinetruss.model._record import Name, Record, Series
from kinetruss.model._words import nearest
from kinetruss.model.checks.common import unknown

if TYPE_CHECKING:
    from kinetruss.model._model import Model

__all__ = ["FREEDOMS", "GROUND", "Hinge", "Joint", "joint_faults"]

GROUND = "ground"
"""Stands for what is fixed, in the place of a body."""

Kind = Literal[
    "spherical", "revolute", "prismatic", "cylindrical", "planar", "universal", "screw", "weld", "pin", "parallelogram",
    "double_parallelogram",
]  # fmt: skip

FREEDOMS = {
    "spherical": 3, "revolute": 1, "prismatic": 1, "cylindrical": 2, "planar": 3, "universal": 2, "screw": 1, "weld": 0,
    "pin": 1, "parallelogram": 1, "double_parallelogram": 2,
}  # fmt: skip
"""Relative degrees of freedom that a joint leaves."""

SHARED = {"spherical": 1, "pin": 1, "revolute": 2}
"""Nodes that the bodies of a joint must share; of a weld as many as there are axes."""

Names = Annotated[tuple[Name, ...], Series]


class Hinge(Record):
    """An angle at a joint: about the axis (two nodes, in the plane one) from node `start` to node `end`."""

    axis: Annotated[tuple[Name, ...], Field(min_length=1, max_length=2), Series]
    start: Name
    end: Name


class Joint(Record):
    """A joint between two bodies, as `library.joints` makes it from nodes and bars.

    kind : what it is. bodies : the two, either may be ``ground``. nodes : that came with it or are shared in it.
    bars, couplings : that came with it; the bars of the bodies to its nodes are not among them.
    hinges : angles at it. slide : two nodes whose distance is the slide.

    The record only names what is there: nodes, bars and couplings do the work.
    """

    kind: Kind
    bodies: tuple[Name, Name]
    nodes: Names
    bars: Names = ()
    couplings: Names = ()
    hinges: Annotated[tuple[Hinge, ...], Series] = ()
    slide: tuple[Name, Name] | None = None

    @property
    def freedoms(self) -> int:
        """Relative degrees of freedom that it leaves."""
        return FREEDOMS[self.kind]


def joint_faults(model: Model) -> Iterator[Fault]:
    """Names that are not there; bodies that are the same; nodes that do not belong to them."""
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


def _bodies(model: Model, joint: Joint, path: tuple[Any, ...]) -> Iterator[Fault]:
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
