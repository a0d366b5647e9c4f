"""Bending that a verdict does not include: by actions on nodes that cannot be assigned to one bar."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from kinetruss.dynamics import NotOnBars, not_on_bars
from kinetruss.errors import few
from kinetruss.model import BodyCouple, Model
from kinetruss.model.hubs import hub_of
from kinetruss.strength.members.parts import parts_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["add_to_notes", "not_held", "screws_not_held", "sentences"]

MOST = 6


def not_held(model: Model, cases: Iterable[str]) -> tuple[NotOnBars, ...]:
    """Actions on nodes of members with a section, once over all load cases, with these members only."""
    judged = set(parts_of(model).judged)
    found = {}
    for case in cases:
        for one in not_on_bars(model, case):
            if members := tuple(name for name in one.members if name in judged or name in model.beams):
                found[one.kind, one.source, one.nodes] = NotOnBars(
                    source=one.source, kind=one.kind, nodes=one.nodes, members=members
                )
    return tuple(found.values())


def screws_not_held(model: Model, cases: Iterable[str]) -> list[str]:
    """A sentence on screws whose torque hubs hold, but which no load of one of the cases brings there."""
    if model.dim == 2 or not model.hubs:
        return []
    every = {name: load.member for name, load in model.loads.items() if isinstance(load, BodyCouple) and load.member}
    given = [{every[name] for name in _loads_of(model, case) if name in every} for case in cases]
    names = [
        name
        for name, one in model.active.items()
        if one.screw is not None and any(hub_of(model, end, name) for end in one.ends) and not all(name in own for own in given)
    ]
    screws = "screw" if len(names) == 1 else "screws"
    sentence = (
        f"Not held: the torque of the {screws} of {few(names, MOST)} about the axis, which twists base, tube and arms of "
        "hubs; actuators.screw_couples gives it as loads."
    )
    return [sentence] if names else []


def _loads_of(model: Model, case: str) -> Iterable[str]:
    chosen = model.load_cases[case].loads if case in model.load_cases else None
    return model.loads if chosen is None else chosen


def sentences(found: tuple[NotOnBars, ...]) -> list[str]:
    """One sentence for each: the action, its nodes, and the members that it may bend."""
    return [
        f"Not held: bending by {one.kind} {one.source!r}, which acts on nodes {few(one.nodes, MOST)} and not on one bar; "
        f"it may bend {few(one.members, MOST)}."
        for one in found
    ]


def add_to_notes(
    found: tuple[NotOnBars, ...], members: list[str], utilisation: NDArray[np.float64], said: NDArray[np.object_]
) -> None:
    """Add the note to the entries (subjects, rules) of these members that depend on bending: yield and beam-column."""
    for i, member in enumerate(members):
        by = list(dict.fromkeys(f"{one.kind} {one.source!r}" for one in found if member in one.members))
        for rule in (0, 2) if by else ():
            if said[i, rule] or utilisation[i, rule] == utilisation[i, rule]:
                said[i, rule] = "; ".join(filter(None, (said[i, rule], f"without bending by {few(by, MOST)}")))
