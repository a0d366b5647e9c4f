"""Small motions: a rhombus on its spring, the ten-bar truss, hanging pendulums."""

from __future__ import annotations

import math

import kinetruss as kt
from kinetruss.verification._cases import stored


def rhombus() -> dict[str, float]:
    """Angular frequency about rest, rad/s."""
    model = kt.library.mechanisms.rhombus_with_spring()
    found = kt.dynamics.linearise(model, kt.statics.equilibrium(model))
    return {"frequency": found.angular_frequency.values[0].item()}


def ten_bars(masses: str) -> dict[str, float]:
    """Frequencies, Hz, of the ten-bar truss with masses along the bars, or half of each in its nodes."""
    data = stored("structures")["exact"]["ten_bars"]
    length, area, density = data["bay"], data["area"], data["density"]
    at = {str(k): (length * x, length * y) for k, (x, y) in enumerate(data["nodes"], start=1)}
    ends = {f"{a}-{b}": (str(a), str(b)) for a, b in data["bars"]}
    lumped = masses == "lumped"
    carried = dict.fromkeys(at, 0.0)
    for a, b in ends.values():
        for node in (a, b):
            carried[node] += density * area * math.dist(at[a], at[b]) / 2
    model = kt.Model(
        nodes={name: kt.Node(at=place, mass=carried[name] if lumped else 0.0) for name, place in at.items()},
        fixed=["5", "6"],
        section=kt.General(area=area, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
        material=kt.Material(E=data["E"], density=0.0 if lumped else density),
        bars={name: kt.Bar(ends=pair, kind="elastic") for name, pair in ends.items()},
    )
    values = kt.dynamics.linearise(model).frequency.values
    return {f"mode_{k}": float(value) for k, value in enumerate(values, start=1)}


def hanging() -> dict[str, float]:
    """Angular frequencies, rad/s, of a rod and of two bobs."""
    rod = kt.library.mechanisms.pendulum(angle=0.0, mass=1.0, bob=0.0)
    two = kt.library.mechanisms.double_pendulum(angles=(0.0, 0.0))
    slow, fast = kt.dynamics.linearise(two).angular_frequency.values
    return {"rod": kt.dynamics.linearise(rod).angular_frequency.values[0].item(), "slow": float(slow), "fast": float(fast)}
