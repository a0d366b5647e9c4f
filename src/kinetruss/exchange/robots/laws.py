"""Springs and couplings of joints, and lengths between points, on the coordinates of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from kinetruss.exchange.robots.closing import frames_at_rest
from kinetruss.exchange.robots.draft import Draft
from kinetruss.exchange.robots.parts import Connection
from kinetruss.exchange.robots.records import LeftOut, Robot
from kinetruss.model import Bar, Coupling, LengthDrive, Model, Spring

__all__ = ["with_laws", "with_spans"]


def with_laws(model: Model, draft: Draft, connections: Sequence[Connection], robot: Robot) -> Model:
    """The model with the springs of its joints, and their couplings at their values in the pose."""
    springs, couplings = {}, {}
    for one in connections:
        if one.sprung and one.name in draft.coordinates:
            stiffness, rest, damping = one.spring
            springs[f"{one.name}.spring"] = Spring(
                coordinate=draft.coordinates[one.name],
                stiffness=stiffness,
                rest=rest + draft.offsets[one.name],
                damping=damping,
            )
    for each in robot.couplings:
        if lost := [name for name in each.factors if name not in draft.coordinates]:
            draft.left.append(LeftOut("coupling", each.where, f"joint {lost[0]!r} is not part of the model"))
            continue
        terms = tuple((draft.coordinates[name], factor) for name, factor in each.factors.items())
        couplings[each.name] = Coupling(terms=terms)
    return model.with_(springs=springs, couplings=couplings) if springs or couplings else model


def with_spans(model: Model, ends: Mapping[str, Sequence[str]], robot: Robot) -> Model:
    """The model with driven bars and springs between points. ends : span -> its two nodes."""
    bars, springs = dict(model.bars), dict(model.springs)
    resting = {
        point: (frame @ np.append(place, 1.0))[:3]
        for link, frame in (frames_at_rest(robot) if robot.spans else {}).items()
        for point, place in robot.links[link].points.items()
    }
    for one in robot.spans:
        first, second = ends[one.name]
        bars[one.name] = Bar(ends=(first, second), kind="driven" if one.driven else "free", mass=0.0)
        if one.spring is not None:
            stiffness, rest, damping = one.spring
            if rest is None:
                rest = float(np.linalg.norm(resting[one.points[1]] - resting[one.points[0]]))
            springs[f"{one.name}.spring"] = Spring(
                coordinate=LengthDrive(one.name), stiffness=stiffness, rest=rest, damping=damping
            )
    return model.with_(bars=bars, springs=springs) if robot.spans else model
