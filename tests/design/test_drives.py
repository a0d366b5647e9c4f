"""The smallest motor, screw and gear that carry the demand."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.design.drive_choice import core_stress

SCREWS = {
    "fast": {"lead": "20 mm/rev", "mean_diameter": "10 mm", "friction": 0.1},
    "thin": {"lead": "2 mm/rev", "mean_diameter": "9 mm", "core_diameter": "1.5 mm", "friction": 0.1},
    "stout": {"lead": "4 mm/rev", "mean_diameter": "14 mm", "core_diameter": "11.5 mm", "friction": 0.1},
}
GEARS = {"g1": {"ratio": 1}, "g4": {"ratio": 4, "efficiency": 0.9}, "g16": {"ratio": 16, "efficiency": 0.8}}
MOTORS = {
    name: {"inertia": f"{1e-6 * k**5} kg m^2", "resistance": f"{2 / k} ohm", "torque_constant": f"{0.04 * k} N m/A",
           "emf_constant": f"{0.04 * k} V s/rad", "max_voltage": "24 V", "max_current": "4 A", "max_speed": "5000 rpm",
           "max_torque": f"{0.08 * k**3} N m"}
    for name, k in (("small", 0.4), ("middle", 1.0), ("large", 2.0))
}  # fmt: skip


def lift(load: float = 100.0, duration: float = 10.0) -> kt.Model:
    """One upright active member that lifts a mass by 0.2 m."""
    part = {"section": kt.Tube(outer=0.03, inner=0.026), "material": kt.library.materials.ALUMINIUM_6061_T6}
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0, 0.8), mass=load / 9.81)}, fixed={"A": "xy", "B": "x"},
        active={
            "leg": kt.Active(ends=("A", "B"), base=kt.Part(length=0.6, mass=1.0, **part), tube=kt.Part(length=0.5, **part))
        },
        gravity=(0, -9.81),
        runs={"lift": kt.Run(trajectory=kt.Quintic(moves={"leg": (0.8, 1.0)}, duration=duration), samples=81)},
    )  # fmt: skip


def mission(**changes: object) -> kt.Mission:
    stock = kt.Catalogue(source="made up", material="steel_s355", screws=SCREWS, gears=GEARS, motors=MOTORS)
    fields = {"catalogues": dict.fromkeys(("screws", "gears", "motors"), stock), "safety": {"yielding": 1.5}}
    return kt.Mission(**fields | changes)


def carries(model: kt.Model, names: tuple[str, str, str], margin: float, locking: bool) -> bool:
    """By `actuators.evaluate` and the core's stress alone."""
    motor, screw, gear = names
    stock = mission().catalogues.screws
    one = stock.screws[screw].screw
    active = model.active["leg"].with_(screw=one, gear=stock.gears[gear], motor=stock.motors[motor])
    sized = model.with_(active={"leg": active})
    motion = kt.kinematics.follow(sized, sized.runs["lift"].trajectory, samples=81)
    forces = kt.dynamics.inverse(sized, motion)
    rows = [row for row in kt.actuators.evaluate(sized, motion, forces).table() if row.checked and row.rule != "stroke"]
    most = max(row.utilisation for row in rows)
    if (core := stock.screws[screw].core_diameter) is not None:
        thrust = float(np.abs(forces.member_force.sel(member="leg")).max())
        most = max(most, core_stress(core, thrust, kt.actuators.raising_torque(one, thrust)) * 1.5 / 355e6)
    return most * margin <= 1 and (not locking or kt.actuators.is_self_locking(one))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("margin", "locking", "duration"), [(1.0, False, 10.0), (1.0, True, 10.0), (1.3, True, 10.0), (1.0, True, 3.0)]
)
def test_the_first_of_all_combinations_that_carries(margin, locking, duration):
    model = lift(duration=duration)
    combinations = itertools.product(MOTORS, SCREWS, GEARS)
    expected = next(names for names in combinations if carries(model, names, margin, locking))
    sizing = kt.design.size(model, mission(margin=margin, self_locking=locking))
    (row,) = sizing.drives
    assert (row.motor, row.screw, row.gear) == expected
    assert row.utilisation * margin <= 1
    assert row.self_locking or not locking
    assert row.before == ("", "", "")
    assert kt.check(sizing.model) == []
    assert sizing.model.motors.keys() == {expected[0]}
    assert max(r.utilisation for r in sizing.demand["all"].table() if r.checked) == pytest.approx(row.utilisation)
    assert sizing.mass_saved == 0
    assert sizing.groups == ()


def test_why_no_smaller_motor():
    (row,) = kt.design.size(lift(), mission(margin=1.3, self_locking=True)).drives
    assert row.motor != "small"
    assert row.against.startswith("small, ")
    assert "times the limit" in row.against


def test_no_drive_carries():
    with pytest.raises(kt.AnalysisError) as caught:
        kt.design.size(lift(load=40_000.0), mission())
    said = str(caught.value)
    assert said.startswith("No drive of the catalogues carries group 'drives' (27 combinations tried). Closest is ")
    assert "of leg reaches" in said


def test_none_locks_itself():
    stock = kt.Catalogue(source="made up", screws={"fast": SCREWS["fast"]})
    with pytest.raises(kt.AnalysisError, match="No screw holds by itself and can be turned"):
        kt.design.size(lift(), mission(catalogues={"screws": stock}, self_locking=True))


def test_a_screw_that_jams_is_passed_over():
    jams = {"lead": "60 mm/rev", "mean_diameter": "2 mm", "friction": 0.9}
    stock = kt.Catalogue(source="made up", screws={"jams": jams, "stout": SCREWS["stout"]})
    (row,) = kt.design.size(lift(), mission(catalogues={"screws": stock})).drives
    assert (row.screw, row.motor) == ("stout", "")


def test_what_is_not_in_the_mission_stays():
    gear, motor = kt.Gear(ratio=4), kt.Motor(**MOTORS["large"])
    model = lift()
    model = model.with_(active={"leg": model.active["leg"].with_(gear=gear, motor=motor, screw=kt.LeadScrew(**SCREWS["fast"]))})
    stock = kt.Catalogue(source="made up", screws=SCREWS)
    sizing = kt.design.size(model, mission(catalogues={"screws": stock}, self_locking=True))
    leg = sizing.model.active["leg"]
    assert (leg.gear, leg.motor) == (gear, motor)
    assert leg.screw == "stout"


def test_a_motor_needs_a_screw():
    stock = kt.Catalogue(source="made up", motors=MOTORS)
    with pytest.raises(kt.ModelError, match="active.leg: has no screw"):
        kt.design.size(lift(), mission(catalogues={"motors": stock}))


def test_core_stress_by_mohr():
    """Principal stresses of thrust and torque in a round bar give the same von Mises stress."""
    d, F, T = 0.008, 1500.0, 2.0
    sigma, tau = F / (math.pi / 4 * d**2), T * (d / 2) / (math.pi / 32 * d**4)
    a, b = np.linalg.eigvalsh([[sigma, tau], [tau, 0.0]])
    assert core_stress(d, F, T) == pytest.approx(math.sqrt(a * a - a * b + b * b), rel=1e-12)
