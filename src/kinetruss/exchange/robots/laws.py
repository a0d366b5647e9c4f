"""Springs, rotors and couplings of joints, and lengths between points, on the coordinates of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from kinetruss.exchange.robots.closing import frames_at_rest
from kinetruss.exchange.robots.draft import Draft
from kinetruss.exchange.robots.parts import Connection
from kinetruss.exchange.robots.records import LeftOut, Robot
from kinetruss.model import Bar, Body, Coupling, HingeDrive, LengthDrive, Model, Node, Spring

__all__ = ["with_laws", "with_rotors", "with_spans"]

RADIUS = 0.05
"""Of the wheels of rotors, as a fraction of the size of the robot."""
GYRATION = 100.0
"""Radius of gyration of such a wheel over the size of the robot: its weight does not count, its inertia does."""


def with_laws(model: Model, draft: Draft, connections: Sequence[Connection], robot: Robot) -> Model:
    """The model with the springs of its joints, and their couplings at their values in the pose."""
    springs, couplings = {}, {}
    for one in connections:
        if one.sprung and one.name in draft.coordinates:
            stiffness, rest, damping, friction = one.spring
            springs[f"{one.name}.spring"] = Spring(
                coordinate=draft.coordinates[one.name],
                stiffness=stiffness,
                rest=rest + draft.offsets[one.name],
                damping=damping,
                friction=friction,
            )
    for each in robot.couplings:
        if lost := [name for name in each.factors if name not in draft.coordinates]:
            draft.left.append(LeftOut("coupling", each.where, f"joint {lost[0]!r} is not part of the model"))
            continue
        terms = tuple((draft.coordinates[name], factor) for name, factor in each.factors.items())
        couplings[each.name] = Coupling(terms=terms)
    return model.with_(springs=springs, couplings=couplings) if springs or couplings else model


def with_rotors(model: Model, draft: Draft, connections: Sequence[Connection]) -> Model:
    """The model with a wheel on the ground for each joint with `armature`, coupled to its angle one to one, or to its length.

    The wheel turns at the rate of the joint itself, so its energy is armature/2 times the square of this rate.
    """
    nodes, bodies, couplings, fixed = dict(model.nodes), dict(model.bodies), dict(model.couplings), dict(model.fixed)
    for one in connections:
        if not one.armature or one.name not in draft.coordinates:
            continue
        name, axis, radius = f"{one.name}.rotor", one.axis, RADIUS * draft.size
        side = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
        side /= np.linalg.norm(side)
        ahead = np.cross(axis, side)
        ways = {"1": 0.0 * axis, "2": axis, "3": side, "4": ahead, "zero": -ahead}
        nodes |= {
            f"{name}.{key}": Node(at=tuple((one.place + radius * way).tolist()), coincident=True) for key, way in ways.items()
        }
        ends = [f"{name}.{key}" for key in "1234"]
        fixed |= dict.fromkeys([*ends[:2], f"{name}.zero"], "xyz")
        bodies[name] = Body(
            nodes=tuple(ends),
            carriers=(ends[0], *ends[2:]),
            mass=one.armature / (GYRATION * draft.size) ** 2,
            center=tuple(one.place.tolist()),
            inertia=(0.5 * one.armature * (np.eye(3) + np.outer(axis, axis))).tolist(),
        )
        turning = HingeDrive(axis=tuple(ends[:2]), start=f"{name}.zero", end=ends[2])
        couplings[name] = Coupling(terms=((turning, 1.0), (draft.coordinates[one.name], -1.0)))
    return (
        model.with_(nodes=nodes, fixed=fixed, bodies=bodies, couplings=couplings) if len(bodies) > len(model.bodies) else model
    )


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
            stiffness, rest, damping, friction = one.spring
            if rest is None:
                rest = float(np.linalg.norm(resting[one.points[1]] - resting[one.points[0]]))
            springs[f"{one.name}.spring"] = Spring(
                coordinate=LengthDrive(one.name), stiffness=stiffness, rest=rest, damping=damping, friction=friction
            )
    return model.with_(bars=bars, springs=springs) if robot.spans else model
