"""Elastic structures along motions: closed forms of one mass and of a chain, the rigid limit, corrected poses."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

E, AREA = 70e9, 1e-4
SOFT, MASS = 3.5e6, 3.0
"""N/m and kg of the single mass."""


def _section() -> kt.General:
    return kt.General(area=AREA, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)


def _mass_on_a_bar() -> kt.Model:
    """A mass at the end of a driven bar, on a line."""
    return kt.Model(
        nodes={"A": (0, 0), "B": {"at": (2, 0), "mass": MASS}},
        fixed={"A": "xy", "B": "y"},
        bars={"b": kt.Bar(ends=("A", "B"), kind="driven")},
        section=_section(),
        material=kt.Material(E=E, density=0.0),
    )


def mass_on_a_bar() -> dict[str, float]:
    """Its frequency, and the displacement from the rigid motion in and after a quintic of 0.1 m in 50 ms."""
    model = _mass_on_a_bar()
    move = kt.Quintic(moves={"b": (2.0, 2.1)}, duration=0.05)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, move, samples=101), static=False)
    frequency = kt.flexible.frequencies(model, forces, 1, stiffness={"b": SOFT}).frequency.values[0, 0]
    shaken = kt.flexible.vibration(model, forces, rest=0.025, stiffness={"b": SOFT}, tolerance=1e-6)
    run = kt.flexible.simulate(model, move, 0.05, stiffness={"b": SOFT}, samples=101)
    off = run.motion.position.sel(node="B", axis="x").values - forces.motion.position.sel(node="B", axis="x").values
    u = shaken.displacement.sel(node="B", axis="x").values
    return {
        "frequency": frequency,
        "vibration_20ms": u[40],
        "vibration_50ms": u[100],
        "vibration_75ms": u[150],
        "simulation_20ms": off[40],
        "simulation_50ms": off[100],
    }


def chain(bars: int) -> dict[str, float]:
    """Axial frequencies of a clamped rod of equal bars with consistent masses, 1 m each."""
    names = [f"N{k}" for k in range(bars + 1)]
    model = kt.Model(
        nodes={name: (float(k), 0) for k, name in enumerate(names)},
        fixed={"N0": "xy"} | dict.fromkeys(names[1:], "y"),
        bars={f"b{k}": (names[k], names[k + 1]) for k in range(bars)},
        section=_section(),
        material=kt.Material(E=E, density=2700.0),
    )
    still = np.array([[(float(k), 0.0) for k in range(bars + 1)]])
    forces = kt.statics.at_poses(model, still)
    found = kt.flexible.frequencies(model, forces, bars).frequency.values[0]
    return {f"mode_{k + 1}": value for k, value in enumerate(found)}


def rigid_limit() -> dict[str, float]:
    """Order in 1/E of the largest displacement of a bay from its rigid motion, and of the change of its member forces."""
    sizes = []
    for E in (71e9, 71e10, 71e11):
        model = kt.library.vgt.double_octahedral(
            gravity=(0, 0, -9.81), payload_mass=5.0, material=kt.Material(E=E, density=2711.5)
        )
        slew = kt.library.vgt.slew(beta=(-math.radians(10), math.radians(10)), duration=0.5)
        forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, slew, samples=11), static=False)
        settled = kt.statics.deflection(model, forces)
        fixed = kt.flexible.corrected(model, forces, ("N7.z", "N8.z", "N9.z"))
        sizes.append([float(np.abs(settled.displacement.values).max()), float(np.abs(fixed.change.values).max())])
    orders = np.log10(np.array(sizes[:-1]) / sizes[1:])
    return {"deflection": float(orders[1, 0]), "corrected": float(orders[1, 1]), "corrected_soft": float(orders[0, 1])}


def vibration_limit() -> dict[str, float]:
    """The same of the vibration: order in 1/k of the displacement, the motion being slow against the mode."""
    model = _mass_on_a_bar()
    move = kt.Quintic(moves={"b": (2.0, 2.1)}, duration=0.05)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, move, samples=101), static=False)
    size = [
        float(np.abs(kt.flexible.vibration(model, forces, stiffness={"b": k}).displacement.values).max()) for k in (1e8, 1e9)
    ]
    return {"order": math.log10(size[0] / size[1])}


def crane() -> dict[str, float]:
    """A soft planar crane: its tip with the corrected lengths, by the equilibrium of another, elastic model."""
    bars = {"boom": ("A", "C"), "tie": ("B", "C"), "jib": ("C", "D"), "stay": ("B", "D")}
    driven = ("tie", "stay")
    nodes = {"A": (0.0, 0.0), "B": (0.0, 2.0), "C": (2.0, 0.5), "D": {"at": (3.0, 1.5), "mass": 200.0}}
    of = {name: kt.Bar(ends=ends, kind="driven" if name in driven else "rigid") for name, ends in bars.items()}
    common = {"fixed": ("A", "B"), "section": _section(), "material": kt.Material(E=1e10, density=0.0), "gravity": (0.0, -9.81)}
    model = kt.Model(nodes=nodes, bars=of, **common)
    forces = kt.statics.at_poses(model, [{}, {"tie": 2.6, "stay": 3.2}])
    found = kt.flexible.corrected(model, forces, ("D.x", "D.y"))
    gone = {}
    for i, pose in enumerate(("drawn", "moved")):
        x = forces.motion.position.values[i]
        lengths = {name: float(forces.motion.length.sel(member=name).values[i]) for name in bars}
        natural = lengths | {str(d): float(found.drive_length.sel(drive=d).values[i]) for d in found.drive.values}
        soft = {
            name: kt.Bar(ends=ends, kind="elastic", stiffness=1e10 * AREA / lengths[name], natural_length=natural[name])
            for name, ends in bars.items()
        }
        at = {name: {"at": tuple(x[k]), "mass": 200.0 if name == "D" else 0.0} for k, name in enumerate(nodes)}
        rest = kt.statics.equilibrium(kt.Model(nodes=at, bars=soft, **common))
        gone[pose] = float(np.abs(rest.position.sel(node="D").values - x[3]).max())
    return gone


def damped() -> dict[str, float]:
    """A mass between an actuator and a bar, on a line: damping ratios by both feedbacks."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}, "C": (2, 0)},
        fixed={"A": "xy", "B": "y", "C": "xy"},
        bars={"act": kt.Bar(ends=("A", "B"), kind="driven"), "side": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=1e6)},
        section=_section(),
        material=kt.Material(E=E, density=0.0),
    )
    forces = kt.statics.at_poses(model, [{}])
    w, z = math.sqrt(4e6 / 2.0), math.sqrt(1e6 / 2.0)
    gains = (100.0, w * math.sqrt(w / z))
    methods: Any = (("force", gains), ("rate", (1000.0,)))
    by_force, by_rate = (
        kt.flexible.active_damping(model, forces, gain, kind=kind, stiffness={"act": 3e6}, modes=1).damping.values[:, 0]
        for kind, gain in methods
    )
    return {"force_100": by_force[0], "force_best": by_force[1], "rate_1000": by_rate[0]}
