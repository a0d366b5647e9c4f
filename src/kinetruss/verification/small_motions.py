"""Small motions and elastic structures: frequencies, transfer functions, feedback, vibration, corrected drive lengths."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, modes
from kinetruss.verification.thesis_bay import TILT, double_octahedral

linearise, mechanisms = kt.dynamics.linearise, kt.library.mechanisms

SOFT = 3.5e6
"""N/m, of the bar of the single mass."""


def rhombus() -> Numbers:
    """Angular frequency of a rhombus on its spring about rest, rad/s."""
    hung = mechanisms.rhombus_with_spring()
    return {"frequency": linearise(hung, kt.statics.equilibrium(hung)).angular_frequency[0]}


def ten_bars(masses: str) -> Numbers:
    """Frequencies, Hz, of the ten-bar truss with masses along the bars, or half of each in its nodes."""
    truss = model("ten_bars")
    if masses == "lumped":
        carried = dict.fromkeys(truss.nodes, 0.0)
        for bar in truss.bars.values():
            for end in bar.ends:
                carried[end] += 2700 * 0.001 * math.dist(*(truss.nodes[name].at for name in bar.ends)) / 2
        nodes = {name: node.with_(mass=carried[name]) for name, node in truss.nodes.items()}
        truss = truss.with_(nodes=nodes, material=kt.Material(E=70e9, density=0.0))
    return modes(linearise(truss).frequency)


def hanging() -> Numbers:
    """Angular frequencies, rad/s, of a rod and of two bobs."""
    rod = mechanisms.pendulum(angle=0.0, mass=1.0, bob=0.0)
    slow, fast = linearise(mechanisms.double_pendulum(angles=(0.0, 0.0))).angular_frequency
    return {"rod": linearise(rod).angular_frequency[0], "slow": slow, "fast": fast}


def andrews() -> Numbers:
    """Components of F' and F'' of Andrews' mechanism at the start, and the reduced mass."""
    squeezer = mechanisms.andrews()
    found = kt.kinematics.transfer_functions(squeezer, "OF.angle")
    values: Numbers = {"mass": linearise(squeezer, dofs="OF.angle").mass.item()}
    for order, functions in (("first", found.first[..., 0]), ("second", found.second[..., 0, 0])):
        places = functions.sel(node=list("FEDGH"))
        values |= {f"{order}_{node}{axis}": places.sel(node=node)[k] for node in "FEDGH" for k, axis in enumerate("xy")}
    return values


def oscillator() -> Numbers:
    """Transmissibility at twice the natural frequency, damping ratio 0.1; poles of feedback of least cost on a free mass."""
    lin = linearise(model("oscillator"), inputs="A.x", outputs="B.x")
    free = linearise(model("free_mass"), inputs="B.x", dofs="B.x")
    pole = kt.dynamics.feedback(free, state_cost={"B.x": 16.0**2}).poles[0]
    return {"transmissibility": lin.transmissibility(10.0).item(), "pole_real": pole.real, "pole_imag": abs(pole.imag)}


def _moved(of: kt.Model) -> tuple[kt.Quintic, kt.results.Forces]:
    """A quintic of 0.1 m in 50 ms, and the forces of the rigid motion."""
    move = kt.Quintic(moves={"b": (2.0, 2.1)}, duration=0.05)
    return move, kt.dynamics.inverse(of, kt.kinematics.follow(of, move, samples=101), static=False)


def mass_on_a_bar() -> Numbers:
    """Frequency of a mass at the end of a driven bar, and its displacement from the rigid motion in and after a quintic."""
    bar, stiffness = model("mass_on_a_bar"), {"b": SOFT}
    move, forces = _moved(bar)
    shaken = kt.flexible.vibration(bar, forces, rest=0.025, stiffness=stiffness, tolerance=1e-6)
    run = kt.flexible.simulate(bar, move, 0.05, stiffness=stiffness, samples=101)
    u, off = (one.sel(node="B", axis="x") for one in (shaken.displacement, run.motion.position - forces.motion.position))
    found = {f"vibration_{t}ms": u[2 * t] for t in (20, 50, 75)} | {f"simulation_{t}ms": off[2 * t] for t in (20, 50)}
    return found | {"frequency": kt.flexible.frequencies(bar, forces, 1, stiffness=stiffness).frequency[0, 0]}


def chain(bars: int) -> Numbers:
    """Axial frequencies of a clamped rod of equal bars with consistent masses, 1 m each."""
    names = [f"N{k}" for k in range(bars + 1)]
    rod = kt.Model(
        nodes={name: (float(k), 0) for k, name in enumerate(names)},
        fixed={"N0": "xy"} | dict.fromkeys(names[1:], "y"),
        bars={f"b{k}": (names[k], names[k + 1]) for k in range(bars)},
        section=kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
        material=kt.Material(E=70e9, density=2700.0),
    )
    return modes(kt.flexible.frequencies(rod, kt.statics.at_poses(rod, [{}]), bars).frequency[0])


def rigid_limit() -> Numbers:
    """Order in 1/E of the largest displacement of a bay from its rigid motion, and of the change of its member forces."""
    sizes = []
    for E in (71e9, 71e10, 71e11):
        bay = double_octahedral(payload_mass=5.0, material=kt.Material(E=E, density=2711.5))
        slew = kt.library.vgt.slew(beta=(-TILT, TILT), duration=0.5)
        forces = kt.dynamics.inverse(bay, kt.kinematics.follow(bay, slew, samples=11), static=False)
        settled = kt.statics.deflection(bay, forces).displacement
        sizes.append([abs(one).max() for one in (settled, kt.flexible.corrected(bay, forces, ("N7.z", "N8.z", "N9.z")).change)])
    orders = np.log10(np.array(sizes[:-1]) / sizes[1:])
    return {"deflection": orders[1, 0], "corrected": orders[1, 1], "corrected_soft": orders[0, 1]}


def vibration_limit() -> Numbers:
    """The same of the vibration: order in 1/k of the displacement, the motion being slow against the mode."""
    bar = model("mass_on_a_bar")
    _, forces = _moved(bar)
    soft, hard = (abs(kt.flexible.vibration(bar, forces, stiffness={"b": k}).displacement).max() for k in (1e8, 1e9))
    return {"order": np.log10(soft / hard)}


def crane() -> Numbers:
    """A soft planar crane: its tip with the corrected lengths, by the equilibrium of another, elastic model."""
    drawn = model("soft_crane")
    forces = kt.statics.at_poses(drawn, {"drawn": {}, "moved": {"tie": 2.6, "stay": 3.2}})
    found, gone = kt.flexible.corrected(drawn, forces, ("D.x", "D.y")), {}
    for i, pose in enumerate(("drawn", "moved")):
        x, lengths = forces.motion.position[i], {name: forces.motion.length.sel(member=name)[i].item() for name in drawn.bars}
        natural = lengths | {name: found.drive_length.sel(drive=name)[i].item() for name in ("tie", "stay")}
        elastic = {
            name: kt.Bar(ends=bar.ends, kind="elastic", stiffness=1e6 / lengths[name], natural_length=natural[name])
            for name, bar in drawn.bars.items()
        }
        nodes = {name: node.with_(at=tuple(x.sel(node=name).values)) for name, node in drawn.nodes.items()}
        rest = kt.statics.equilibrium(drawn.with_(nodes=nodes, bars=elastic)).position
        gone[pose] = abs(rest.sel(node="D").values - x.sel(node="D").values).max()
    return gone


def damped() -> Numbers:
    """A mass between an actuator and a bar, on a line: damping ratios by both feedbacks."""
    mass = model("damped_mass")
    forces, w, z = kt.statics.at_poses(mass, [{}]), math.sqrt(4e6 / 2.0), math.sqrt(1e6 / 2.0)
    methods: Any = (("force", (100.0, w * math.sqrt(w / z))), ("rate", (1000.0,)))
    by_force, by_rate = (
        kt.flexible.active_damping(mass, forces, gain, kind=kind, stiffness={"act": 3e6}, modes=1).damping[:, 0]
        for kind, gain in methods
    )
    return {"force_100": by_force[0], "force_best": by_force[1], "rate_1000": by_rate[0]}
