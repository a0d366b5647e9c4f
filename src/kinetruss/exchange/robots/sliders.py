"""Driven lengths as sliders: two links on the line between two points, one turning about each end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from kinetruss.exchange.robots.records import Closure, Drawn, Link, Pivot, Pull, placement

__all__ = ["with_sliders"]


def with_sliders(drawn: Drawn, pulls: Sequence[Pull]) -> Drawn:
    """The robot with some driven lengths as sliders: a cardan joint at the first end, a closure of the other end."""
    robot = drawn.robot
    links, pivots, closures = dict(robot.links), list(robot.pivots), list(robot.closures)
    for pull in pulls:
        start, end = pull.points
        line = (end - start) / np.linalg.norm(end - start)
        one = np.cross(line, np.eye(3)[int(np.argmin(np.abs(line)))])
        one /= np.linalg.norm(one)
        cross, low, high = (f"{pull.name}.{word}" for word in ("cross", "low", "high"))
        base, tube = pull.properties or (None, None)
        links |= {cross: Link(name=cross), low: Link(name=low, properties=base), high: Link(name=high, properties=tube)}
        ends: dict[str, Any] = {"origin": placement(None, start), "after": placement(None, -start)}
        pivots += [
            Pivot(name=f"{pull.name}.1", kind="revolute", parent=pull.links[0], child=cross, axis=one, **ends),
            Pivot(name=f"{pull.name}.2", kind="revolute", parent=cross, child=low, axis=np.cross(line, one), **ends),
            Pivot(name=pull.name, kind="prismatic", parent=low, child=high, axis=line, drive=pull.name, **ends),
        ]
        place = placement(None, end)
        closures.append(Closure(name=f"{pull.name}.tip", kind="ball", links=(high, pull.links[1]), frames=(place, place)))
    left = [one for one in drawn.pulls if one not in pulls]
    return replace(drawn, robot=replace(robot, links=links, pivots=pivots, closures=closures), pulls=left)
