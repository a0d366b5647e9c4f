"""Statics: the stiffness method, equilibrium with large displacements, free bodies and their equations, strain gauges."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, share, standing
from kinetruss.verification.thesis_bay import POSES, bay_of, double_octahedral, pose, slew_of
from kinetruss.verification.thesis_triangle import SAMPLES, analysed, massless, triangular

mechanisms = kt.library.mechanisms


def agreement(geometry: str, weight: bool) -> Numbers:
    """Largest difference of stiffness method and inverse dynamics at rest, of the largest force."""
    if geometry == "table_3_2":
        truss, lengths = triangular() if weight else massless(), {"actuator": 2.5}
    else:
        truss, lengths = bay_of("A", density=2711.5, gravity=9.81), pose(POSES[geometry])
    forces = kt.statics.at_poses(truss, [lengths], weight=weight)
    found, largest = kt.statics.linear(truss, forces.motion.position.values[0], weight=weight), forces.member_force
    names = ("member_force", "end_force", "reaction")
    return {name: share(found.data[name].values - forces.data[name].values[0], largest) for name in names}


def along() -> Numbers:
    """The same along a slew: inverse dynamics at rest and its deflection against the stiffness method at each pose."""
    truss = bay_of("A", density=2711.5, gravity=9.81)
    motion = kt.kinematics.follow(truss, kt.library.vgt.slew(beta=(-0.17, 0.17), gamma=(0.0, 0.09)), samples=5)
    forces = kt.dynamics.inverse(truss, motion)
    still: Any = forces.static
    bent, moving = kt.statics.deflection(truss, still), kt.statics.deflection(truss, forces)
    found = [kt.statics.linear(truss, position) for position in motion.position.values]
    return {
        "member_force": share(np.array([one.member_force for one in found]) - still.member_force, still.member_force),
        "displacement": share(np.array([one.displacement for one in found]) - bent.displacement, bent.displacement),
        "virtual_work": share(moving.work_balance, moving.energy),
    }


def three_bars() -> Numbers:
    """Forces, of the load, in a vertical bar between two at 45 degrees that hang from one ceiling; sag of their node."""
    bars, load = model("three_bars"), 1000.0
    found, shared = kt.statics.linear(bars, load_case="load"), kt.statics.at_poses(bars, [{}])
    return {
        "middle": found.member_force.sel(member="middle") / load,
        "side": found.member_force.sel(member="left") / load,
        "sag": -found.displacement.sel(node="P", axis="y") * 100e9 * 1e-4 / load,
        "shared_middle": shared.member_force.sel(member="middle")[0] / load,
    }


def rhombus() -> Numbers:
    """Angle of the side rods of a rhombus on its spring, and how far top and sides differ from a rhombus."""
    at = kt.statics.equilibrium(mechanisms.rhombus_with_spring()).position
    x, y = at.sel(node="B0").values
    return {"angle": math.atan2(y, x), "top": abs(at.sel(node="B1").values - [1 + x, y]).max()}


def leaning(strain: Any, load: float) -> Numbers:
    """Height and vertical stiffness of the von Mises truss under a load, N."""
    found = kt.statics.equilibrium(mechanisms.von_mises(rise=0.3, load=load, strain=strain))
    shape = abs(found.mode_shape.sel(node="T", axis="y").values)
    return {"height": found.position.sel(node="T", axis="y"), "stiffness": found.stiffness[int(shape.argmax())]}


def path(strain: Any, rise: float = 0.3) -> Numbers:
    """Load, N, and height, m, of the first limit point and bifurcation of its path from rest."""
    found = kt.statics.path(mechanisms.von_mises(rise=rise, load=1.0, strain=strain), "load", points=40)
    values: Numbers = {}
    events = (found.event_kind, found.event_factor, found.event_position.sel(node="T", axis="y"))
    for kind, load, height in zip(*(one.values for one in events), strict=True):
        values = {f"{kind}_load": load, f"{kind}_height": height} | values
    return values


def crown() -> Numbers:
    """Linear deflection of a star dome's crown, in: stiffness method, response of the linearisation, start of the path."""
    dome, inch = model("star_dome"), 0.0254
    by_path = kt.statics.path(dome, "crown", to=1e-5, step=1e-7, points=9)
    lin = kt.dynamics.linearise(dome, inputs="1.z", outputs="1.z")
    return {
        "stiffness_method": kt.statics.linear(dome, weight=False).displacement.sel(node="1", axis="z") / inch,
        "linearised": -220.46 * 4.4482216152605 * lin.frequency_response(0.0).item().real / inch,
        "path": (by_path.position.sel(node="1", axis="z")[-1] / inch - 3.2346) / by_path.load_factor[-1],
    }


def prism() -> Numbers:
    """Twist, deg, and force densities over that of the verticals, of a prism released 10 degrees off."""
    starts, cable = {"L": (0.0, 0.0), "H": (140.0, 1.2)}, {"kind": "cable", "stiffness": 5e4, "pretension": 8e3}
    turns = {f"{s}{k}": (math.radians(start + 120 * k), z) for s, (start, z) in starts.items() for k in range(3)}
    bars: dict[str, Any] = {f"{s}{k}": {"ends": (f"{s}{k}", f"{s}{(k + 1) % 3}"), **cable} for s in "LH" for k in range(3)}
    bars |= {f"strut{k}": (f"L{k}", f"H{k}") for k in range(3)}
    bars |= {f"vertical{k}": {"ends": (f"L{k}", f"H{(k + 2) % 3}"), **cable} for k in range(3)}
    nodes = {name: (math.cos(a), math.sin(a), z) for name, (a, z) in turns.items()}
    found = kt.statics.equilibrium(kt.Model(nodes=nodes, fixed=["L0"], bars=bars))
    low, high = (found.position.sel(node=[f"{s}{k}" for k in range(3)]).values for s in "LH")
    axis = high.mean(axis=0) - low.mean(axis=0)
    one, two = low[0] - low.mean(axis=0), high[0] - high.mean(axis=0)
    density = found.member_force / found.length
    return {
        "twist": abs(np.degrees(np.arctan2(np.cross(one, two) @ axis / np.linalg.norm(axis), one @ two))),
        "strut": density.sel(member="strut1") / density.sel(member="vertical0"),
        "horizontal": density.sel(member="H2") / density.sel(member="vertical0"),
        "left_free": found.data.attrs["neutral"],
    }


def equations_of_bay(duration: float, times: list[float]) -> Numbers:
    """The slew of one bay at the given times: what its 117 equations and its free bodies say."""
    return _equations(*slew_of(duration, times))


def equations_of_triangle() -> Numbers:
    """The motion of the triangular truss at the samples: what its 11 equations and its free bodies say."""
    return _equations(*analysed(SAMPLES)[:2])


def _equations(truss: kt.Model, forces: kt.results.Forces) -> Numbers:
    """Unknowns by name as the system's own solution gives them, size, misses; tension at B of every member."""
    found, directions = {}, kt.kinematics.member_rates(truss, forces.motion).direction
    for t in forces.motion.time.values:
        system = kt.dynamics.newton_euler(truss, forces.motion, forces, time=t)
        names = (name.replace(" reaction ", " ").replace(" ", ".") for name in system.unknowns)
        at = dict(zip(names, system.solution.tolist(), strict=True))
        for name in truss.members:
            force = [at[f"{name}.B.{axis}"] for axis in "xyz"[: truss.dim]]
            at[f"{name}.tension_B"] = directions.sel(time=t, member=name).values @ force
        cut = partial(kt.dynamics.free_body, truss, forces.motion, forces, time=t)
        at |= {"equations": len(system.equations), "unknowns": len(system.unknowns), "difference": system.difference}
        at["residual_of_members"] = max(cut(member=name).residual for name in truss.members)
        at["residual_of_nodes"] = max(cut(node=name).residual for name in truss.nodes)
        found[f"t={t:g}"] = at
    return found


def condition(lengths: list[float]) -> Numbers:
    """Condition number of the 117 equations in a pose."""
    truss = double_octahedral(tip_force=(0.0, 0.0, 46.0), gravity=(0.0, 0.0, 9.81))
    forces = kt.statics.at_poses(truss, [pose(lengths)])
    return {"condition": kt.dynamics.newton_euler(truss, forces.motion, forces).condition}


def level_bar() -> Numbers:
    """Readings of gauges on a horizontal bar in tension that bends under its weight."""
    bar = model("level_bar")
    motion = standing(bar, kt.kinematics.assemble(bar))
    found = kt.strength.gauges(bar, kt.dynamics.inverse(bar, motion, static=False)).isel(time=0)
    parts = found["group_strain"].sel(group="mid", component=["axial", "bending_3"])
    readings = {name: found["strain"].sel(gauge=name) for name in bar.gauges}
    return readings | dict(zip(("axial", "bending_3"), parts, strict=True)) | {"bridge": found["bridge"].sel(gauge="low")}


def rosette() -> Numbers:
    """Principal strains of a rosette at 0, 45, 90 degrees that reads 500, 350, -100, and their angle."""
    found = kt.strength.rosette([500.0, 350.0, -100.0], np.radians([0, 45, 90]))
    return {"largest": found.principal[0], "least": found.principal[1], "tangent": np.tan(2 * found.angle)}


def shunt() -> Numbers:
    """Reading of a 120 ohm gauge, factor 2, with a resistor of 59,880 ohm across it, from the voltage of its bridge."""
    arm = 120 * 59880 / (120 + 59880)
    return {"strain": kt.strength.bridge_strain(10 * (arm / (arm + 120) - 0.5), kt.Bridge(excitation=10), 2.0)}
