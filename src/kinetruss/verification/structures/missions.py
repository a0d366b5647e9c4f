"""Missions and conditions: virtual work of every load case, closed forms, the envelope against single runs."""

from __future__ import annotations

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
    mission = kt.run(model, "all")
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
