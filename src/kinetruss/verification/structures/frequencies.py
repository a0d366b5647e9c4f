"""Small motions: a rhombus on its spring, the ten-bar truss, hanging pendulums."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kinetruss import dynamics, statics
from kinetruss.library import mechanisms
from kinetruss.model import Bar, General, Material, Model, Node
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

RHOMBUS = Reference("closed-form", "w^2 = V''/(5 m s^2/3), V = 2 m g s sin t + k (2 s sin(t/2) - l0)^2/2, at rest")
FREQUENCY = 4.251519555206327
"""rad/s."""
HANGING = Reference("closed-form", "w^2 = (2 -+ sqrt 2) g/l, two like bobs on like massless rods")
ROD = Reference("closed-form", "w^2 = 3 g/(2 l), a uniform rod")


def rhombus() -> dict[str, float]:
    """Angular frequency about rest, rad/s."""
    model = mechanisms.rhombus_with_spring()
    found = dynamics.linearise(model, statics.equilibrium(model))
    return {"frequency": found.angular_frequency.values[0].item()}


def ten_bars(masses: str) -> dict[str, float]:
    """Frequencies, Hz, of the ten-bar truss with masses along the bars, or half of each in its nodes."""
    data = load("frequencies")["ten_bars"]
    length, area, density = data["bay"], data["area"], data["density"]
    at = {str(k): (length * x, length * y) for k, (x, y) in enumerate(data["nodes"], start=1)}
    ends = {f"{a}-{b}": (str(a), str(b)) for a, b in data["bars"]}
    lumped = masses == "lumped"
    carried = dict.fromkeys(at, 0.0)
    for a, b in ends.values():
        for node in (a, b):
            carried[node] += density * area * math.dist(at[a], at[b]) / 2
    model = Model(
        nodes={name: Node(at=place, mass=carried[name] if lumped else 0.0) for name, place in at.items()},
        fixed=["5", "6"],
        section=General(area=area, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
        material=Material(E=data["E"], density=0.0 if lumped else density),
        bars={name: Bar(ends=pair, kind="elastic") for name, pair in ends.items()},
    )
    values = dynamics.linearise(model).frequency.values
    return {f"mode_{k}": float(value) for k, value in enumerate(values, start=1)}


def hanging() -> dict[str, float]:
    """Angular frequencies, rad/s, of a rod and of two bobs."""
    rod = mechanisms.pendulum(angle=0.0, mass=1.0, bob=0.0)
    two = mechanisms.double_pendulum(angles=(0.0, 0.0))
    slow, fast = dynamics.linearise(two).angular_frequency.values
    return {"rod": dynamics.linearise(rod).angular_frequency.values[0].item(), "slow": float(slow), "fast": float(fast)}


def cases() -> Iterator[Case]:
    """Exact to round-off; ten bars as far as the reference has digits."""
    yield Case("frequencies.rhombus", RHOMBUS, FREQUENCY, 1e-12, rhombus, (), ("frequency",))
    data = load("frequencies")["ten_bars"]
    reference = Reference("independent", data["source"])
    for masses in ("consistent", "lumped"):
        for k, value in enumerate(data[masses], start=1):
            name = f"mode_{k}"
            yield Case(f"frequencies.ten_bars.{masses}.{name}", reference, value, 1e-12, ten_bars, (masses,), (name,))
    g = 9.81
    closed = {"rod": (ROD, 1.5 * g), "slow": (HANGING, (2 - math.sqrt(2)) * g), "fast": (HANGING, (2 + math.sqrt(2)) * g)}
    for name, (source, square) in closed.items():
        yield Case(f"frequencies.hanging.{name}", source, math.sqrt(square), 1e-12, hanging, (), (name,))
