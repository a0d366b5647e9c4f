"""Units of public results: each number has one; it is a unit of physics, and that of a drive is decided by its kind."""

import re

import numpy as np
import pytest

import kinetruss as kt
from shipped import stored

RUNS = [("four_bar", "turn"), ("double_octahedral_slew", None), ("planar_crane", "lift"), ("drive_train", None),
        ("double_pendulum", None), ("wind_tower", None), ("isolator_beam", None)]  # fmt: skip
"""Examples with all kinds of results: motion, forces, simulation, sections, verdict, demand."""

SYMBOLS = {"m", "s", "kg", "rad", "N", "J", "W", "V", "A", "Pa", "Hz", "K"}
WORDS = {"of the states", "of the states per input", "of the outputs per state", "of the outputs per input"}
"""Units of state matrices, whose entries differ in both directions."""


def faults_of(data, where):
    """Variables of numbers without a unit or a name, and units that are none."""
    for name, one in data.data_vars.items():
        if one.dtype.kind != "f":
            continue
        unit = one.attrs.get("units")
        if unit is None or not one.attrs.get("long_name"):
            yield f"{where}.{name} has no unit or no name"
            continue
        if unit in WORDS:
            continue
        for token in re.findall(r"[A-Za-z_]+", unit):
            if token.endswith("_unit"):
                if token not in data.variables:
                    yield f"{where}.{name}: {unit!r} names no coordinate"
            elif token not in SYMBOLS and token != "per":
                yield f"{where}.{name}: {unit!r} is no unit"


def results_of(run):
    yield "motion", run.motion.data
    for kind in ("forces", "sections", "demand", "statics"):
        for case, one in getattr(run, kind).items():
            yield f"{kind}/{case}", one.data
    for kind in ("simulation", "verdict"):
        if (one := getattr(run, kind)) is not None:
            yield kind, one.data


@pytest.mark.slow
@pytest.mark.parametrize(("name", "run"), RUNS)
def test_each_number_of_a_run_has_a_unit(name, run):
    run = run or next(iter(kt.read(kt.library.example_files()[name][0]).runs))
    found = kt.runs.load(stored(name, run))
    assert [fault for where, data in results_of(found) for fault in faults_of(data, where)] == []


def mixed():
    """A crank turned by a motor, and a slide."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0), "D": (3, 0)}, fixed={"A": "xy", "C": "xy", "D": "y"},
        bars={"a": ("A", "B"), "b": ("C", "D")}, drives={"turn": kt.AngleDrive("a"), "push": kt.LengthDrive("b")},
        gravity=(0, -9.81), section=kt.Rod(diameter=0.02), material="steel_s235",
    )  # fmt: skip


def results_of_a_model(model, one):
    road = kt.ConstantRate(rates=dict.fromkeys(model.all_drives, 0.1), duration=1.0)
    motion = kt.kinematics.follow(model, road, samples=3)
    forces = kt.dynamics.inverse(model, motion)
    task = kt.Coordinates(moves={one: kt.kinematics.jacobian(model, of=one).sizes["of"] * 0.1 + 1.0})
    sections = kt.strength.sections(model, forces)
    yield from {
        "motion": motion.data,
        "forces": forces.data,
        "equilibrium": kt.statics.equilibrium(model).data,
        "linearise": kt.dynamics.linearise(model, free=[next(iter(model.all_drives))]).data,
        "reduced": kt.dynamics.reduced_equations(model, free=[next(iter(model.all_drives))]),
        "transfer": kt.kinematics.transfer_functions(model, free=[next(iter(model.all_drives))]),
        "freedoms": kt.kinematics.freedoms(model, motion),
        "member_rates": kt.kinematics.member_rates(model, motion),
        "sections": sections.data,
        "stresses": kt.strength.stresses(model, sections),
        "verdict": kt.strength.check(model, forces).data,
        "reach": kt.kinematics.reach(model, task),
        "jacobian": kt.kinematics.platform_jacobian(model, ("B", "D"), motion),
        "stiffness": kt.statics.platform_stiffness(model, ("B", "D"), 1e5, motion),
    }.items()


def test_units_of_other_results():
    assert [fault for where, data in results_of_a_model(mixed(), "push") for fault in faults_of(data, where)] == []


def test_drives_of_one_kind_share_a_unit_and_others_have_their_own():
    model = mixed()
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 0.1, "push": 0.1}, duration=1.0), samples=3)
    forces = kt.dynamics.inverse(model, motion)
    assert motion.drive_velocity.attrs["units"] == "drive_unit/s"
    assert motion.data["drive_unit"].values.tolist() == ["rad", "m"]
    assert forces.drive_force.sel(drive="turn")["drive_force_unit"].item() == "N m"
    one = model.with_(drives={"turn": kt.AngleDrive("a")})
    motion = kt.kinematics.follow(one, kt.ConstantRate(rates={"turn": 0.1}, duration=1.0), samples=3)
    assert motion.drive_velocity.attrs["units"] == "rad/s" and "drive_unit" not in motion.data.coords
    assert kt.dynamics.inverse(one, motion).drive_force.attrs["units"] == "N m"
    run = kt.run(model.with_(runs={"go": kt.Run(trajectory=kt.ConstantRate(rates={"turn": 0.1}, duration=1.0), samples=3)}))
    assert [(one.of, one.unit) for one in kt.report.curves(run, "drive_force")] == [("turn", "N m"), ("push", "N")]


def test_a_wrong_unit_is_found():
    data = mixed_motion().data.copy()
    data["drive_velocity"] = data["drive_velocity"].assign_attrs(units="m/s or rad/s")
    data["length"] = (("time", "member"), np.zeros((data.sizes["time"], data.sizes["member"])))
    assert list(faults_of(data, "m")) == [
        "m.length has no unit or no name",
        "m.drive_velocity: 'm/s or rad/s' is no unit",
    ]


def mixed_motion():
    return kt.kinematics.follow(mixed(), kt.ConstantRate(rates={"turn": 0.1}, duration=1.0), samples=2)
