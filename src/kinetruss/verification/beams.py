"""Beams: cantilever, torsion, circle, elastica, the bend of 45 degrees, frequencies, buckling, a frame, motion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, change, off

STEEL = kt.Material(E=200e9, density=7800.0)
SQUARE, STRIP = kt.Rectangle(width=0.02, height=0.02), kt.Rectangle(width=0.1, height=5e-4)
LOAD, TORQUE = 10.0, 7.0


def row(places: Any, **more: Any) -> dict[str, Any]:
    """Beams of steel from place to place, clamped at the first, as arguments of a model."""
    names = [f"N{i}" for i in range(len(places))]
    return {
        "nodes": {name: tuple(map(float, place)) for name, place in zip(names, places, strict=True)},
        "beams": {f"b{i}": (names[i], names[i + 1]) for i in range(len(names) - 1)},
        "clamped": names[:1],
        "material": STEEL,
        **more,
    }


def line(count: int, dim: int = 2) -> list[tuple[float, ...]]:
    """Places along x, over 1 m."""
    return [(i / count, 0.0, 0.0)[:dim] for i in range(count + 1)]


def cantilever(dim: int) -> Numbers:
    """One beam under an end load and under its weight: deflection and moments, of their closed forms; twist in space."""
    side = {"orientation": (0.0, 1.0, 0.0)} if dim == 3 else {}
    base = row(line(1, dim), section=SQUARE, beams={"b0": kt.Beam(ends=("N0", "N1"), **side)})
    EI, weight = STEEL.E * SQUARE.second_moments[1], STEEL.density * SQUARE.area * 9.81
    loaded = kt.Model(**base, loads={"P": kt.NodalForce(node="N1", force=(0.0, -LOAD, 0.0)[:dim])})
    heavy = kt.Model(**base, gravity=(0.0, -9.81, 0.0)[:dim])
    bent, hung = kt.statics.linear(loaded), kt.statics.linear(heavy)
    M, own = (
        kt.strength.beams(beam, one, stations=3).section_M.sel(moment="3")[0] for beam, one in ((loaded, bent), (heavy, hung))
    )
    found = {"deflection": -bent.displacement.sel(node="N1", axis="y") * 3 * EI / LOAD}
    found |= {"clamp": -M[0] / LOAD, "middle": -M[1] / LOAD, "end": M[2] / LOAD}
    found |= {"weight.clamp": -2 * own[0] / weight, "weight.middle": -8 * own[1] / weight}
    if dim == 3:
        twisted = kt.Model(**base, loads={"T": kt.BodyCouple(body="N1", moment=(TORQUE, 0.0, 0.0))})
        moved = kt.statics.linear(twisted).whole["displacement"].sel(axis="z")
        turn = (moved.sel(node="N1.d2") - moved.sel(node="N1")) / twisted.whole.nodes["N1.d2"].at[1]
        found["twist"] = turn * STEEL.E / 2.6 * SQUARE.torsion_constant / TORQUE
    return found


def _end(places: Any, load: Any, **more: Any) -> Any:
    """Places of nodes in equilibrium under a load at the last of a row of beams."""
    return kt.statics.equilibrium(kt.Model(**row(places, loads={"load": load}, **more))).whole["position"]


def circle(count: int) -> Numbers:
    """A thin strip under the end moment 2 pi E I/L: distance of its ends (L = 1) and rotation over 2 pi."""
    moment = kt.BodyCouple(body=f"N{count}", moment=2 * math.pi * STEEL.E * STRIP.second_moments[1])
    found = _end(line(count), moment, section=STRIP)
    at = found.sel(node=f"N{count}").values
    x, y = found.sel(node=f"N{count}.d1").values - at
    return {"gap": np.linalg.norm(at), "turn": math.atan2(y, x) / (2 * math.pi) + 1.0}


def elastica(count: int, load: float) -> Numbers:
    """Tip of a slender cantilever under the end load `load` E I/L^2, L = 1: deflection and shortening."""
    push = kt.NodalForce(node=f"N{count}", force=(0.0, load * STEEL.E * STRIP.second_moments[1]))
    x, y = _end(line(count), push, section=STRIP).sel(node=f"N{count}")
    return {"deflection": y, "shortening": 1 - x}


def bend(count: int, load: float) -> Numbers:
    """Tip of the 45-degree bend of radius 100 under a load across its plane; the coordinates are those of the source."""
    section = kt.General(area=1.0, I2=1 / 12, I3=1 / 12, c2=0.5, c3=0.5, J=1 / 6)
    material = kt.Material(E=1e7, density=1.0, poisson=0.0)
    places = [(100 * math.sin(a), 100 * (1 - math.cos(a)), 0.0) for a in np.linspace(0.0, math.pi / 4, count + 1)]
    push = kt.NodalForce(node=f"N{count}", force=(0.0, 0.0, load))
    x, y, z = _end(places, push, section=section, material=material).sel(node=f"N{count}")
    return {"x": y, "y": x, "z": z}


def frequencies(count: int) -> Numbers:
    """First angular frequencies over sqrt(E I/(rho A L^4)): clamped-free, clamped-clamped, free-free."""
    wire = kt.Rod(diameter=1e-3)
    scale, found = math.sqrt(STEEL.E * wire.second_moments[1] / (STEEL.density * wire.area)), {}
    for name, clamped in (("clamped_free", ["N0"]), ("clamped_clamped", ["N0", f"N{count}"]), ("free_free", [])):
        modes = kt.dynamics.linearise(kt.Model(**row(line(count), section=wire) | {"clamped": clamped}))
        values = modes.angular_frequency.values / scale
        found[name] = values[values > 1e-3][0]
    return found


def frequency_order() -> Numbers:
    """Order of the clamped-free frequency, from 2 to 4 elements."""
    exact = 1.8751040687119611**2
    coarse, fine = (abs(frequencies(count)["clamped_free"] / exact - 1) for count in (2, 4))
    return {"order": math.log2(coarse / fine)}


def buckling(count: int) -> Numbers:
    """Load factor of a clamped-free column over pi^2 E I/(4 L^2)."""
    rod = kt.Rod(diameter=0.01)
    push = kt.NodalForce(node=f"N{count}", force=(-(math.pi**2) * STEEL.E * rod.second_moments[1] / 4, 0.0))
    column = kt.Model(**row(line(count), section=rod, loads={"P": push}))
    return {"factor": kt.statics.buckling(column, "P", modes=1).load_factor[0]}


def portal() -> Numbers:
    """Moments of a portal frame with clamped feet under a side load P, over P h: at the foot and the head of a column."""
    frame = model("portal_frame")
    foot, head = kt.strength.beams(frame, kt.statics.linear(frame), stations=2).section_M.sel(beam="left", moment="3")
    return {"foot": abs(foot) / 3000.0, "head": abs(head) / 3000.0}


def motion() -> Numbers:
    """A free beam that bends and tumbles: changes of its energy and momenta, of the largest."""
    soft, section = kt.Material(E=2e8, density=7800.0), kt.Rectangle(width=0.02, height=0.01)
    parts = row(line(2, 3), section=section) | {"clamped": [], "material": soft}
    run = kt.dynamics.simulate(kt.Model(**parts, velocities={"N0": (0, -2, 0), "N2": (0, 2, 1)}), 0.05, samples=11)
    values = {name: run.data[name].values for name in ("energy", "momentum", "angular_momentum")}
    return {name: change(one) / np.abs(one).max() for name, one in values.items()}


def damped(dim: int) -> Numbers:
    """Damping ratios of the first modes of a cantilever over w b/2; work that its damping takes over the energy it loses."""
    delay = 1e-4
    beams = {f"b{i}": kt.Beam(ends=(f"N{i}", f"N{i + 1}"), damping=delay) for i in range(2)}
    beam = kt.Model(**row(line(2, dim), section=SQUARE) | {"beams": beams})
    modes = kt.dynamics.linearise(beam)
    ratio = modes.modal_damping[:3] / (math.pi * modes.frequency[:3] * delay)
    start = {name: (0.0, 1.0, 0.5)[:dim] for name in beam.whole.nodes if name.startswith("N2")}
    run = kt.dynamics.simulate(beam.with_(velocities=start), 2e-3, samples=401)
    taken = kt.dynamics.inverse(beam, run.motion).dissipation.values
    # Simpson's rule
    work = run.time.values[1] / 3 * (taken[0] + taken[-1] + 4 * taken[1:-1:2].sum() + 2 * taken[2:-1:2].sum())
    energy = run.energy.values
    return {"ratio": abs(ratio - 1).max() + 1, "energy": work / (energy[0] - energy[-1])}


def hinged() -> Numbers:
    """Deflection in the middle of a beam, clamped but for a hinge about axis 2 at one end, over P L^3/(E I): along 2 and 3."""
    plain, found = model("beam_with_a_hinge"), {}
    I2, I3 = kt.Rectangle(width=0.02, height=0.03).second_moments
    for name, axis, I in (("along_2", "y", I3), ("along_3", "z", I2)):
        force = kt.NodalForce(node="M", force=tuple(LOAD * (axis == one) for one in "xyz"))
        moved = kt.statics.linear(plain.with_(loads={"P": force})).displacement.sel(node="M", axis=axis)
        found[name] = moved * STEEL.E * I / LOAD
    return found


def driven() -> Numbers:
    """A beam without mass on a crank that turns half around: its moment at the crank over that of the mass at its tip."""
    arm, mass, radius, gravity = model("beam_on_a_crank"), 2.0, 1.5, np.array([0.0, -9.81])
    motion = kt.kinematics.follow(arm, kt.Quintic(moves={"turn": (0.0, math.pi)}, duration=0.4), samples=21)
    forces = kt.dynamics.inverse(arm, motion)
    moment = kt.strength.beams(arm, forces, stations=[0.0]).section_M.sel(beam="arm", moment="3", station=0.0).values
    # over the arm of 1 m, the weight and inertia of the mass across it
    angle, second = motion.drive_position.values[:, 0], motion.drive_acceleration.values[:, 0]
    exact = mass * (gravity[1] * np.cos(angle) - radius * second)
    light = arm.with_(gravity=(0.0, 0.0))
    still: Any = kt.dynamics.inverse(light, motion).static
    shaken = kt.flexible.frequencies(light, still, rigid=("crank",), modes=1).frequency[-1, 0]
    stiffness = 3 * STEEL.E * SQUARE.second_moments[1]
    return {"moment": off(moment, exact), "frequency": (2 * math.pi * shaken) ** 2 * mass / stiffness}
