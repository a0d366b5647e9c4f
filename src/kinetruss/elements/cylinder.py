"""Hydraulic cylinders: force p_A A_A - p_B A_B along the line of two nodes, pressures in time and by the flow.

Q_A = A_A L' enters A and Q_B = A_B L' leaves B. Of a given flow Q, p_A = (Q - A_A L')/leak; H. E. Merritt, Hydraulic Control
Systems, 1967, chapter 6, with rigid oil.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.on_nodes import Part
from kinetruss.kernels.coordinates.node_laws import NodeLaw, Value
from kinetruss.kernels.coordinates.programs import Vector, above, choice, dot, minus, unit

if TYPE_CHECKING:
    from kinetruss.mechanics.system import System

FIXED = 6
"""Numbers before the tables: areas A and B, 1/flow_limit, 1/leak, relief, 1 where the flow is given."""
NONE = 1e30
"""Relief pressure of a cylinder without one, Pa."""


class State(NamedTuple):
    """Direction, forces and flows of an instant."""

    along: Vector
    p_A: Any
    p_B: Any
    Q_A: Any
    Q_B: Any
    thrust: Any


def in_time(t: Any, table: Sequence[Any]) -> Any:
    """A table (value at the start, then times and changes of slope): linear between its times, constant outside."""
    total = table[0]
    for time, change in zip(table[1::2], table[2::2], strict=True):
        total = total + change * above(t - time)
    return total


def state(t: Any, nodes: Sequence[Vector], rates: Sequence[Vector], numbers: Sequence[Any]) -> State:
    """Pressures of both ports, and what follows from them."""
    A, B, drop, ease, relief, by_flow = numbers[:FIXED]
    size = (len(numbers) - FIXED) // 3
    first, second, given = (in_time(t, numbers[FIXED + k * size : FIXED + (k + 1) * size]) for k in range(3))
    along = unit(minus(nodes[1], nodes[0]))
    rate = dot(minus(rates[1], rates[0]), along)
    Q_A, Q_B = A * rate, B * rate
    # behind the orifice of the supply: only a port that draws loses pressure
    supplied = first * above(1.0 - above(Q_A * drop, 2.0)), second * above(1.0 - above(-1.0 * Q_B * drop, 2.0))
    into, out = above(given), above(-1.0 * given)
    # an open port has the pressure of the tank
    trapped = choice(out, 0.0, above((into - Q_A) * ease)), choice(into, 0.0, above((out + Q_B) * ease))
    p_A, p_B = (choice(by_flow, kept - above(kept - relief), fed) for kept, fed in zip(trapped, supplied, strict=True))
    return State(along, p_A, p_B, Q_A, Q_B, p_A * A - p_B * B)


def pushed(t: Any, nodes: Sequence[Vector], rates: Sequence[Vector], numbers: Sequence[Any]) -> list[Vector]:
    """The forces on both nodes."""
    now = state(t, nodes, rates, numbers)
    x, y, z = (now.thrust * one for one in now.along)
    return [(-1.0 * x, -1.0 * y, -1.0 * z), (x, y, z)]


def _value(name: str, unit_: str, words: str) -> Value:
    return Value(lambda *given: getattr(state(*given), name), unit_, words)


LAW = NodeLaw(
    force=pushed,
    values={
        "thrust": _value("thrust", "N", "thrust of the piston"),
        "pressure_A": _value("p_A", "Pa", "pressure on the bore"),
        "pressure_B": _value("p_B", "Pa", "pressure on the side of the rod"),
        "flow_A": _value("Q_A", "m^3/s", "flow into A that the piston takes"),
        "flow_B": _value("Q_B", "m^3/s", "flow out of B that the piston gives"),
        "power": Value(lambda *given: (one := state(*given)).p_A * one.Q_A - one.p_B * one.Q_B, "W", "power to the piston"),
    },
)


def cylinders(system: System) -> Part | None:
    """The cylinders of a model."""
    own: dict[str, Any] = system.model.cylinders
    if not own:
        return None
    bore, rod, limit, leak, relief = np.moveaxis(
        system.numbers("cylinder", "bore", "rod", "flow_limit", "leak", "relief"), -1, 0
    )
    ends = system.p, system.q
    nodes = [
        [system.node_index(name) for name in one.nodes]
        if one.nodes is not None
        else [int(end[system.members.index(one.member)]) for end in ends]
        for one in own.values()
    ]
    A, B = math.pi / 4 * bore**2, math.pi / 4 * (bore**2 - rod**2)
    drop, ease = (np.where(np.isnan(one), 0.0, 1.0 / np.where(np.isnan(one), 1.0, one)) for one in (limit, leak))
    by_flow = np.broadcast_to([float(one.by_flow) for one in own.values()], bore.shape)
    plain = np.stack([A, B, drop, ease, np.where(np.isnan(relief), NONE, relief), by_flow], axis=-1)
    size = 1 + 2 * max(len(one.times or ()) for one in own.values())
    tables = np.array([[_table(one, name, size) for name in ("pressure_A", "pressure_B", "flow")] for one in own.values()])
    flat = np.broadcast_to(tables.reshape(len(own), -1), (*bore.shape, 3 * size))
    numbers = np.concatenate([plain, flat], axis=-1)
    return Part("cylinder", tuple(own), LAW, nodes, numbers, feeds=True, says="force on the first node")


def _table(one: Any, name: str, size: int) -> list[float]:
    """As `in_time`, of this size."""
    many = getattr(one, name.replace("pressure", "pressures") if name != "flow" else "flows")
    if many is None:
        return [getattr(one, name) or 0.0, *[0.0] * (size - 1)]
    slope = np.diff(many) / np.diff(one.times)
    changes = np.diff([0.0, *slope, 0.0])
    found = [many[0], *np.column_stack([one.times, changes]).reshape(-1).tolist()]
    return found + [0.0] * (size - len(found))
