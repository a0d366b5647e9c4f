"""Driven lengths as sliders: two links on the line between two points, one turning about each end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from kinetruss.exchange.robots.records import Closure, DrivenLength, Link, Pivot, RobotOfModel, placement

__all__ = ["with_sliders"]


def with_sliders(drawn: RobotOfModel, lengths: Sequence[DrivenLength]) -> RobotOfModel:
    """The robot with some driven lengths as sliders: a cardan joint at the first end, a closure of the other end."""
    robot = drawn.robot
    links, pivots, closures = dict(robot.links), list(robot.pivots), list(robot.closures)
    for driven in lengths:
        start, end = driven.points
        line = (end - start) / np.linalg.norm(end - start)
        one = np.cross(line, np.eye(3)[int(np.argmin(np.abs(line)))])
        one /= np.linalg.norm(one)
        cross, low, high = (f"{driven.name}.{word}" for word in ("cross", "low", "high"))
        base, tube = driven.properties or (None, None)
        links |= {cross: Link(name=cross), low: Link(name=low, properties=base), high: Link(name=high, properties=tube)}
        ends: dict[str, Any] = {"origin": placement(None, start), "after": placement(None, -start)}
        pivots += [
            Pivot(name=f"{driven.name}.1", kind="revolute", parent=driven.links[0], child=cross, axis=one, **ends),
            Pivot(name=f"{driven.name}.2", kind="revolute", parent=cross, child=low, axis=np.cross(line, one), **ends),
            Pivot(name=driven.name, kind="prismatic", parent=low, child=high, axis=line, drive=driven.name, **ends),
        ]
        place = placement(None, end)
        closures.append(Closure(name=f"{driven.name}.tip", kind="ball", links=(high, driven.links[1]), frames=(place, place)))
    left = [one for one in drawn.lengths if one not in lengths]
    return replace(drawn, robot=replace(robot, links=links, pivots=pivots, closures=closures), lengths=left)
