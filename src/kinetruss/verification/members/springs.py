"""Springs about hinges: swings, friction, play, columns that buckle, moments that a motor must give."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)
STIFF = kt.Radau(rtol=1e-9, atol=1e-10)
MASS, ARM, STIFFNESS = 2.0, 1.5, 30.0
"""kg, m, N m/rad."""
TIMES = (0.5, 1.0, 2.5, 5.0)
RATE = math.sqrt(STIFFNESS / (MASS * ARM**2))
HINGE = kt.HingeDrive(axis="O", start="G", end="P")


def _arm(start: float, gravity: float = 0.0, **law: Any) -> kt.Model:
    """A mass on an arm about O, at an angle from +x, with a spring about O; gravity along +x."""
    return kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "P": kt.Node(at=(ARM * math.cos(start), ARM * math.sin(start)), mass=MASS)},
        fixed=["O", "G"],
        bars={"arm": kt.Bar(ends=("O", "P"), mass=0.0)},
        gravity=(gravity, 0.0),
        springs={"hinge": kt.Spring(**({"coordinate": HINGE, "stiffness": STIFFNESS, "rest": 0.0} | law))},
    )


def _angles(run: kt.results.Simulation) -> list[float]:
    return [float(angle) for angle in run.forces.spring_value.sel(spring="hinge").values]


def swing(damping: float) -> dict[str, float]:
    """Angle of the arm at `TIMES`, from rest at 1 rad."""
    run = kt.dynamics.simulate(_arm(1.0, damping=damping), TIMES[-1], times=[0.0, *TIMES], method=FINE)
    return {f"{t:g}s": angle for t, angle in zip(TIMES, _angles(run)[1:], strict=True)}


def crossing(start: float, gravity: float, play: float) -> dict[str, float]:
    """When the arm first passes its rest."""
    passed = {"rest": kt.Event(coordinate="P.y", value=0.0, direction="falling")}
    run = kt.dynamics.simulate(_arm(start, gravity, play=play), 5.0, method=FINE, events=passed)
    return {"time": run.events[0].time}


def friction() -> dict[str, float]:
    """Angles at the turns of an arm that friction of 1.5 N m slows down."""
    half = math.pi / RATE
    model = _arm(1.0, friction=1.5, slip=1e-5)
    run = kt.dynamics.simulate(model, 4 * half, times=[half * k for k in range(5)], method=STIFF)
    return {f"turn_{k}": angle for k, angle in enumerate(_angles(run)) if k}


def torque() -> dict[str, float]:
    """Torque of a motor about the hinge against spring, damper and friction, from rest to rest and back."""
    model = _arm(0.0, damping=0.7, friction=0.4).with_(drives={"motor": HINGE})
    found: dict[str, float] = {}
    for name, move in (("out", (0.0, 1.0)), ("back", (1.0, 0.0))):
        motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": move}, duration=1.0), samples=5)
        forces = kt.dynamics.inverse(model, motion)
        found |= {f"{name}.{t:g}s": forces.drive_force.sel(time=t, drive="motor").item() for t in (0.25, 0.5)}
        found[f"{name}.power"] = float(np.abs(forces.energy_balance.values).max())
    return found


def small() -> dict[str, float]:
    """Frequency and damping about the lowest place."""
    found = kt.dynamics.linearise(_arm(0.0, 9.81, damping=1.2))
    return {"frequency": found.angular_frequency.item(), "damping": found.modal_damping.item()}


def column(links: int) -> dict[str, float]:
    """Loads at which a column of links of 0.5 m buckles; springs of 12 N m/rad between them, or about the foot of one."""
    foot = {"foot": kt.Spring(coordinate=kt.HingeDrive(axis="N0", start="W", end="N1"), stiffness=12.0)}
    inner = {
        f"s{k}": kt.Spring(coordinate=kt.HingeDrive(axis=f"N{k}", start=f"N{k - 1}", end=f"N{k + 1}"), stiffness=12.0)
        for k in range(1, links)
    }
    model = kt.Model(
        nodes={f"N{k}": (0.0, 0.5 * k) for k in range(links + 1)} | {"W": (1.0, 0.0)},
        fixed={"N0": "xy", "W": "xy"} | ({f"N{links}": "x"} if links > 1 else {}),
        bars={f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(links)},
        springs=inner or foot,
        loads={"P": kt.NodalForce(node=f"N{links}", force=(0.0, -1.0))},
    )
    factors = kt.statics.buckling(model, "P").load_factor.values
    return {f"mode_{k + 1}": float(factor) for k, factor in enumerate(factors)}


def post_buckled() -> dict[str, float]:
    """Lean of a column of 2 m on a spring of 100 N m/rad, from 0.02 rad on, under the load that leans it by 1 rad."""
    k, length, lean = 100.0, 2.0, 0.02
    load = k * (1.0 - lean) / (length * math.sin(1.0))
    model = kt.Model(
        nodes={"A": (0, 0), "B": (length * math.sin(0.9), length * math.cos(0.9)), "G": (1, 0)},
        fixed=["A", "G"],
        bars={"a": ("A", "B")},
        springs={"s": kt.Spring(coordinate=kt.HingeDrive(axis="A", start="G", end="B"), stiffness=k, rest=math.pi / 2 - lean)},
        loads={"P": kt.NodalForce(node="B", force=(0.0, -load))},
    )
    found = kt.statics.equilibrium(model)
    x, y = found.position.sel(node="B").values
    return {"lean": math.atan2(x, y), "moment": found.spring_force.item()}


def elastica() -> dict[str, float]:
    """Slope at the tip of a clamped chain of links under a load across it, by the number of links; the order of its error."""
    slopes = {count: _tip(count) for count in (8, 16, 32)}
    return {
        "order": math.log2((slopes[8] - slopes[16]) / (slopes[16] - slopes[32])),
        "slope": (4 * slopes[32] - slopes[16]) / 3,
    }


def _tip(count: int) -> float:
    """Slope of the last link of an elastic line of length 1 and E I = 1 under 2 N, as `count` links."""
    h = 1.0 / count
    ends = [("W", "N0", "N1", 2.0 / h)] + [(f"N{k - 1}", f"N{k}", f"N{k + 1}", 1.0 / h) for k in range(1, count)]
    model = kt.Model(
        nodes={f"N{k}": (k * h, 0.0) for k in range(count + 1)} | {"W": (-h, 0.0)},
        fixed=["N0", "W"],
        bars={f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(count)},
        springs={at: kt.Spring(coordinate=kt.HingeDrive(axis=at, start=a, end=b), stiffness=k) for a, at, b, k in ends},
        loads={"tip": kt.NodalForce(node=f"N{count}", force=(0.0, 2.0))},
    )
    x = kt.statics.equilibrium(model).position
    dx, dy = (x.sel(node=f"N{count}") - x.sel(node=f"N{count - 1}")).values
    return math.atan2(dy, dx)


def folding() -> dict[str, float]:
    """Two free triangles with a spring about their common edge: what energy and momenta change by in 10 s."""
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0.4, 0.8, 0.1), "D": (0.5, -0.3, 0.7)}
    masses, speeds = (1.0, 0.7, 1.3, 0.9), ((0.1, 0.7, -0.2), (0.0, -0.4, 0.9), (0.3, 0.2, 1.1), (-0.5, 0.6, 0.4))
    model = kt.Model(
        nodes={name: kt.Node(at=at, mass=mass) for (name, at), mass in zip(nodes.items(), masses, strict=True)},
        bars={one + two: kt.Bar(ends=(one, two), mass=0.0) for one, two in ("AB", "AC", "BC", "AD", "BD")},
        velocities=dict(zip(nodes, speeds, strict=True)),
        springs={"fold": kt.Spring(coordinate=kt.HingeDrive(axis=("A", "B"), start="C", end="D"), stiffness=40.0, play=0.05)},
    )
    run = kt.dynamics.simulate(model, 10.0, method=FINE, samples=51)
    changes = {
        name: float(np.abs(run.data[name].values - run.data[name].values[0]).max()) for name in ("momentum", "angular_momentum")
    }
    again = kt.dynamics.inverse(model, run.motion)
    force = float(np.abs(again.spring_force.values - run.forces.spring_force.values).max())
    return {"energy": float(np.ptp(run.energy.values))} | changes | {"inverse": force}
