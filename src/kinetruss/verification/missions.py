"""Missions, conditions, sizes and error budgets: virtual work, closed forms, envelopes of single runs, the lightest truss."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, share

TILT = kt.Quintic(moves={"B1.beta": (0.0, 0.1), "B2.gamma": (0.0, -0.08), "B3.beta": (0.0, 0.05)}, duration=2.0)
E, AREA, EXPANSION, DENSITY = 210e9, math.pi / 4 * (0.03**2 - 0.026**2), 12e-6, 7850.0
"""Of the warmed and spun models."""
SIZES = {"14x1": (14, 1), "16x1": (16, 1), "18x1.5": (18, 1.5), "20x1.5": (20, 1.5), "25x2": (25, 2)}
"""Tubes of the small case of sizing by name: outer diameter and wall, mm."""


def chain() -> kt.Model:
    """Three bays with a load at the tip in each direction, two conditions, and a mission."""
    like: Any = model("warmed_truss")
    bays = kt.library.vgt.double_octahedral(3, payload_mass=1.0, section=like.section, material=like.material)
    tip = list(bays.nodes)[-1]
    return bays.with_(
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


def virtual_work() -> Numbers:
    """Work of loads, weight and inertia less the strain energy, over the latter, of every load case under every condition."""
    bays, found = chain(), {}
    for condition in bays.conditions:
        changed = kt.under(bays, condition)
        motion = kt.kinematics.follow(changed, TILT, samples=9)
        for case in bays.load_cases:
            bent = kt.statics.deflection(changed, kt.dynamics.inverse(changed, motion, case))
            found[f"{condition}.{case}"] = share(bent.work_balance, bent.energy)
    return found


def envelope() -> Numbers:
    """Highest utilisation and drive force of a mission over those of its pairs, done one by one as runs."""
    bays = chain()
    mission: Any = kt.run(bays, "all")
    runs = [
        kt.run(bays.with_(runs={"one": kt.Run(trajectory="tilt", samples=21, condition=condition)}))
        for condition in bays.conditions
    ]
    force = max(abs(forces.drive_force).max() for one in runs for forces in one.forces.values())
    most, *used = (max(row.utilisation for row in one.verdict.table() if row.checked) for one in (mission, *runs))
    return {"utilisation": most / max(used), "drive_force": mission.drives["value"].sel(quantity="force").max() / force}


def conditions() -> Numbers:
    """A determinate truss warmed by 80 K, a bar clamped and warmed by 45 K, and a mass pushed by its support."""
    warm = kt.under(model("warmed_truss"), kt.Condition(temperature=80.0))
    held = kt.statics.linear(kt.under(model("warmed_bar"), kt.Condition(temperature=45.0))).member_force
    pushed = kt.under(model("pushed_mass"), kt.Condition(base_acceleration=(3.0, 0)))
    x, y = warm.nodes["C"].at
    return {
        "shift_C_x": (x - 1) / (EXPANSION * 80),
        "shift_C_y": (y - 1.5) / (EXPANSION * 80),
        "strain_free": abs(kt.statics.at_poses(warm, [{}]).member_force).max(),
        "clamped": held[0] / (E * AREA * EXPANSION * 45.0),
        "pushed": kt.statics.at_poses(pushed, [{}]).member_force[0, 0],
    }


def rotating_base() -> Numbers:
    """A uniform bar, a slider, a lever that starts to turn, and gravity that turns as seen from a wheel, in closed form."""
    L, w, alpha, g = 1.2, 9.0, 7.0, 9.81
    m = DENSITY * AREA * L
    spun = _on(model("spun_arm"), angular_velocity=[w])
    forces = kt.statics.at_poses(spun, [{}])
    middle = kt.strength.sections(spun, forces, stations=[0.5]).section_T.item()
    started = _on(model("lever"), angular_acceleration=[alpha])
    wheel = _on(model("lever").with_(gravity=(0.0, -g)), angular_velocity=[w], gravity_turns=True)
    held = kt.Quintic(moves={"turn": (0.0, 0.0)}, duration=1.0)
    turned = kt.dynamics.inverse(wheel, kt.kinematics.follow(wheel, held, times=[0.0, 0.3]))
    moving = _on(model("slide"), angular_velocity=[w])
    outwards = kt.ConstantRate(rates={"b": 0.4}, duration=0.5)
    sliding = kt.dynamics.inverse(moving, kt.kinematics.follow(moving, outwards, samples=2))
    return {
        "root": forces.end_force.sel(member="b", end="A")[0] / (m * w**2 * L / 2),
        "middle": middle / (m * w**2 * L * 3 / 8),
        "euler": kt.statics.at_poses(started, [{}]).drive_force.item() / (m * L**2 / 3 * alpha),
        "coriolis": sliding.reaction.sel(support="S", axis="y")[-1] / (2 * 2.0 * w * 0.4),
        "centrifugal": sliding.drive_force[-1, 0] / (-2.0 * w**2 * 0.7),
        "gravity": turned.drive_force[1, 0] / (m * g * L / 2),
    }


def _on(still: kt.Model, **base: Any) -> kt.Model:
    """A model on a base that rotates."""
    return kt.under(still, kt.Condition(base_rotation=kt.BaseRotation(**base)))


def two_bars() -> Numbers:
    """Sensitivities of the foot of two hanging bars to the length of one; worst case and root of squares for 0.1 mm each."""
    found = kt.runs.budget(model("hanging_bars"), ["C.x", "C.y"], {"*.length": 1e-4}, samples=4).data
    x, y = found["sensitivity"].sel(parameter="left.length")
    return {"x": x, "y": y, "worst_case": found["worst_case"][1], "root_sum_square": found["root_sum_square"][1]}


def monte_carlo() -> Numbers:
    """Largest difference of Monte Carlo and root of squares, in standard errors, over pose and forces of a bay."""
    bay = kt.library.vgt.double_octahedral(gravity=(0, 0, 9.81), tip_force=(0, 0, 46))
    of = ["bay.beta", "bay.gamma", "bay.height", "M6.force", "M7.drive_force"]
    found = kt.runs.budget(bay, of, {"M*.length": 1e-4}, at={"bay.beta": 0.1}, samples=2000, seed=1).data
    off = abs(found["monte_carlo"] - found["root_sum_square"]) / found["monte_carlo_error"]
    return {"within_four_standard_errors": off.max() < 4}


def chain_task(duration: float = 0.6) -> tuple[kt.Model, kt.Mission]:
    """Two bays that slew so fast that their own masses rule the forces; three groups, five tubes."""
    slew = kt.library.vgt.slew(2, beta=(0.0, math.radians(14)), gamma=(0.0, math.radians(9)), duration=duration)
    bays = kt.library.vgt.double_octahedral(2, payload_mass=3.0, base_mass=0.5, material="aluminium_6061_t6")
    groups = {
        "lower": ["B1.M[1-6]", "B1.M1[3-8]"],
        "upper": ["B1.M19", "B1.M2[01]", "B2.M[1-6]", "B2.M1[3-9]", "B2.M2[01]"],
        "actuators": ["B?.M7", "B?.M9", "B?.M11"],
    }
    tubes = {name: {"outer": f"{outer} mm", "wall": f"{wall} mm"} for name, (outer, wall) in SIZES.items()}
    mission = _mission(groups, tubes, 3.0, material="aluminium_6061_t6")
    return bays.with_(runs={"slew": kt.Run(trajectory=slew, samples=21)}), mission


def bracket_task(force: float = 3000.0) -> tuple[kt.Model, kt.Mission]:
    """Two massless struts of 1 m in an equilateral triangle that bear a force at the top; tubes of 1 mm wall."""
    still = kt.Spline(times=(0.0, 0.5, 0.8, 1.0), values={"left": (1.0,) * 4})
    loads, runs = {"push": kt.NodalForce(node="C", force=(0, -force))}, {"stand": kt.Run(trajectory=still, samples=2)}
    tubes = {f"{outer}x1": {"outer": f"{outer} mm", "wall": "1 mm"} for outer in range(8, 31)}
    return model("bracket").with_(loads=loads, runs=runs), _mission({"struts": ["left", "right"]}, tubes, 2.0)


def _mission(groups: Any, tubes: Any, buckling: float, **catalogue: Any) -> kt.Mission:
    made_up = kt.Catalogue(source="made up for this case", tubes=tubes, **catalogue)
    safety = kt.Safety(yielding=1.5, buckling=buckling)
    return kt.Mission(groups=groups, catalogues={"tubes": made_up}, safety=safety)


def sized_chain() -> Numbers:
    """What the sizing of the small case says."""
    found = kt.design.size(*chain_task())
    rows = {
        row.name: {"outer": SIZES[row.tube][0] / 1e3, "one_size_smaller_fails": row.smaller_utilisation > 1}
        for row in found.groups
    }
    carries = max(row.utilisation for row in found.groups) <= 1
    return rows | {"mass": found.mass_after, "carries": carries, "settled": found.settled}


def bracket() -> Numbers:
    """Outer diameter (mm) and utilisation of the struts, and by how much the tube one size smaller buckles."""
    (row,) = kt.design.size(*bracket_task()).groups
    return {"outer": row.tube.split("x")[0], "utilisation": row.utilisation, "one_size_smaller": row.smaller_utilisation}
