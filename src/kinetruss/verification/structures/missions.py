"""Missions and conditions: virtual work of every load case, closed forms, the envelope against single runs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

STEEL = kt.Material(E=210e9, density=7850.0, yield_strength=235e6, thermal_expansion=12e-6)
TUBE = kt.Tube(outer=0.03, inner=0.026)
TILT = kt.Quintic(moves={"B1.beta": (0.0, 0.1), "B2.gamma": (0.0, -0.08), "B3.beta": (0.0, 0.05)}, duration=2.0)


def chain() -> kt.Model:
    """Three bays with a load at the tip in each direction, two conditions, and a mission."""
    model = kt.library.vgt.double_octahedral(bays=3, payload_mass=1.0, gravity=(0, 0, -9.81), section=TUBE, material=STEEL)
    tip = list(model.nodes)[-1]
    return model.with_(
        loads={f"tip_{axis}": kt.NodalForce(node=tip, force=tuple(40.0 * np.eye(3)[k])) for k, axis in enumerate("xyz")},
        load_cases={axis: kt.LoadCase(loads={f"tip_{axis}": 1.0}) for axis in "xyz"},
        trajectories={"tilt": TILT},
        conditions={
            "plain": kt.Condition(),
            "laden": kt.Condition(payloads={tip: 5.0}, gravity=(0, -9.81, 0)),
            "shaken": kt.Condition(base_acceleration=(2.0, 0, 1.0)),
        },
        runs={"all": kt.Run(analysis="mission", motions=("tilt",), conditions=("plain", "laden", "shaken"), samples=21)},
    )


def virtual_work() -> dict[str, float]:
    """Work of loads, weight and inertia less the strain energy, over the latter, of every load case under every condition."""
    model, found = chain(), {}
    for condition in model.conditions:
        changed = kt.under(model, condition)
        motion = kt.kinematics.follow(changed, TILT, samples=9)
        for case in model.load_cases:
            bent = kt.statics.deflection(changed, kt.dynamics.inverse(changed, motion, case))
            found[f"{condition}.{case}"] = float(np.abs(bent.work_balance.values).max() / bent.energy.values.max())
    return found


def envelope() -> dict[str, float]:
    """Highest utilisation and drive force of a mission over those of its pairs, done one by one as runs."""
    model = chain()
    mission: Any = kt.run(model, "all")
    used, force = 0.0, 0.0
    for condition in model.conditions:
        one = kt.run(model.with_(runs={"one": kt.Run(trajectory="tilt", samples=21, condition=condition)}))
        rows = [] if one.verdict is None else one.verdict.table()
        used = max([used, *(row.utilisation for row in rows if row.checked)])
        force = max([force, *(float(np.abs(forces.drive_force.values).max()) for forces in one.forces.values())])
    rows = [] if mission.verdict is None else mission.verdict.table()
    most = max(row.utilisation for row in rows if row.checked)
    largest = float(mission.drives["value"].sel(quantity="force").max())
    return {"utilisation": most / used, "drive_force": largest / force}


def conditions() -> dict[str, float]:
    """A determinate truss warmed by 80 K, a bar clamped and warmed by 45 K, and a mass pushed by its support."""
    nodes = {"A": (0, 0), "B": (2, 0), "C": (1, 1.5)}
    bars = {"ab": ("A", "B"), "bc": ("B", "C"), "ac": ("A", "C")}
    truss = kt.Model(nodes=nodes, fixed={"A": "xy", "B": "y"}, bars=bars, section=TUBE, material=STEEL)
    warm = kt.under(truss, kt.Condition(temperature=80.0))
    row = {"nodes": {"A": (0, 0), "B": (2, 0)}, "section": TUBE, "material": STEEL}
    clamped = kt.Model(**row, fixed=["A", "B"], bars={"b": kt.Bar(ends=("A", "B"), kind="elastic")})
    held = kt.statics.linear(kt.under(clamped, kt.Condition(temperature=45.0))).member_force.item()
    row["nodes"] = {"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}}
    rod = kt.Model(**row | {"section": None}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")})
    pushed = kt.under(rod, kt.Condition(base_acceleration=(3.0, 0)))
    return {
        "shift_C_x": (warm.nodes["C"].at[0] - 1) / (12e-6 * 80),
        "shift_C_y": (warm.nodes["C"].at[1] - 1.5) / (12e-6 * 80),
        "strain_free": float(np.abs(kt.statics.at_poses(warm, [{}]).member_force.values).max()),
        "clamped": held / (STEEL.E * TUBE.area * 12e-6 * 45.0),
        "pushed": kt.statics.at_poses(pushed, [{}]).member_force.item(),
    }


def rotating_base() -> dict[str, float]:
    """A uniform bar, a slider, a lever that starts to turn, and gravity that turns as seen from a wheel, in closed form."""
    L, m, w, alpha, g = 1.2, STEEL.density * TUBE.area * 1.2, 9.0, 7.0, 9.81
    fields = {"section": TUBE, "material": STEEL}
    arm = kt.Model(nodes={"O": (0, 0), "P": (L, 0)}, fixed={"O": "xy", "P": "y"}, bars={"b": ("O", "P")}, **fields)
    spun = _under(arm, angular_velocity=[w])
    forces = kt.statics.at_poses(spun, [{}])
    middle = kt.strength.sections(spun, forces, stations=[0.5]).section_T.values.item()
    lever = kt.Model(nodes={"O": (0, 0), "P": (L, 0)}, fixed=["O"], bars={"b": ("O", "P")}, gravity=(0, -g),
                     drives={"turn": kt.AngleDrive("b")}, **fields)  # fmt: skip
    started = _under(lever.with_(gravity=None), angular_acceleration=[alpha])
    wheel = _under(lever, angular_velocity=[w], gravity_turns=True)
    held = kt.Quintic(moves={"turn": (0.0, 0.0)}, duration=1.0)
    turned = kt.dynamics.inverse(wheel, kt.kinematics.follow(wheel, held, times=[0.0, 0.3]))
    slide = kt.Model(nodes={"O": (0, 0), "S": {"at": (0.5, 0), "mass": 2.0}}, fixed={"O": "xy", "S": "y"},
                     bars={"b": kt.Bar(ends=("O", "S"), kind="driven", mass=0.0)})  # fmt: skip
    moving = _under(slide, angular_velocity=[w])
    outwards = kt.kinematics.follow(moving, kt.ConstantRate(rates={"b": 0.4}, duration=0.5), samples=2)
    sliding = kt.dynamics.inverse(moving, outwards)
    return {
        "root": forces.end_force.sel(member="b", end="A").item() / (m * w**2 * L / 2),
        "middle": middle / (m * w**2 * L * 3 / 8),
        "euler": kt.statics.at_poses(started, [{}]).drive_force.item() / (m * L**2 / 3 * alpha),
        "coriolis": sliding.reaction.sel(support="S", axis="y").values[-1] / (2 * 2.0 * w * 0.4),
        "centrifugal": sliding.drive_force.values[-1, 0] / (-2.0 * w**2 * 0.7),
        "gravity": turned.drive_force.values[1, 0] / (m * g * L / 2),
    }


def _under(model: kt.Model, **base: Any) -> kt.Model:
    return kt.under(model, kt.Condition(base_rotation=kt.BaseRotation(**base)))


def arm_map() -> dict[str, float]:
    """The map of an arm of two bars, 0.4 m and 0.3 m: its border, and the least singular value at three radii."""
    a, b = 0.4, 0.3
    elbow = (a * math.cos(0.6), a * math.sin(0.6))
    arm = kt.Model(
        nodes={"O": (0, 0), "E": elbow, "T": (elbow[0] + b * math.cos(-0.7), elbow[1] + b * math.sin(-0.7))},
        fixed=["O"], bars={"upper": ("O", "E"), "fore": ("E", "T")},
        drives={"first": kt.AngleDrive("upper"), "second": kt.AngleDrive("fore")},
    )  # fmt: skip
    radii = np.array([0.08, 0.12, 0.3, 0.5, 0.69, 0.71])
    found = kt.kinematics.workspace(arm, "T", ("x", radii), ("y", [0.0, 0.02]))
    line = found.isel(y=0)
    values = {f"serial_{round(1000 * r)}": float(line.serial.sel(x=r)) for r in (0.12, 0.3, 0.5)}
    return {"reached": float(line.reachable.sum()), "beyond": float(line.reachable.sel(x=0.71)), **values}
