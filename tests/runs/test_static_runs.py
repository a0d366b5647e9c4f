"""Static analyses as runs: the numbers are those of the analysis itself, stored, read again and reported."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report
from shows import shown

STEEL = kt.library.materials.STEEL_S235
TILT = kt.Quintic(moves={"bay.beta": (0.0, 0.1)}, duration=1.0)


@pytest.fixture(scope="module")
def frame():
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (1, 1.5), "D": (1, 0.7)},
        fixed=["A", "B"],
        bars={"left": ("A", "C"), "right": ("B", "C"), "tie": ("C", "D"), "low": ("A", "D")},
        section=kt.Tube(outer=0.03, inner=0.026),
        material=STEEL,
        gravity=(0, -9.81),
        loads={"push": kt.NodalForce(node="C", force=(100, -1000))},
        load_cases={"one": kt.LoadCase(loads={"push": 1}), "two": kt.LoadCase(loads={"push": 2})},
        runs={
            "small": kt.Run(analysis="statics.linear"),
            "large": kt.Run(analysis="statics.equilibrium", load_cases=("two",)),
        },
    )


@pytest.fixture(scope="module")
def bay():
    model = kt.library.vgt.double_octahedral(bays=1, gravity=(0, 0, -9.81))
    return model.with_(
        runs={
            "listed": kt.Run(analysis="statics.at_poses", poses={"rest": {}, "tilt": {"bay.beta": "5 deg"}}),
            "along": kt.Run(analysis="statics.at_poses", trajectory=TILT, samples=11),
            "bent": kt.Run(analysis="statics.deflection", trajectory=TILT, samples=11),
        }
    )


@pytest.mark.slow
def test_a_linear_run_has_the_displacements_forces_and_utilisation_of_the_analysis(frame, tmp_path):
    run = kt.run(frame, "small", tmp_path / "run")
    for one in (run, kt.runs.load(tmp_path / "run")):
        for case in ("one", "two"):
            alone = kt.statics.linear(frame, load_case=case)
            assert np.array_equal(one.statics[case].displacement.values[0], alone.displacement.values)
            assert np.array_equal(one.forces[case].member_force.values[0], alone.member_force.values)
        rest = kt.strength.check(frame, [kt.statics.at_poses(frame, [{}], load_case=case) for case in ("one", "two")])
        wanted = {(row.part, row.rule): row.utilisation for row in rest.table() if row.checked}
        found = {(row.part, row.rule): row.utilisation for row in one.verdict.table() if row.checked}
        assert found == pytest.approx(wanted, rel=1e-9, abs=1e-12)
    assert run.whole


def test_joint_forces_of_the_stiffness_method_balance_the_weight_of_every_member(frame):
    found = kt.statics.linear(frame, load_case="one")
    total = found.joint_force.sum("end").values
    length = np.array(
        [np.hypot(*np.subtract(frame.nodes[b.ends[1]].at, frame.nodes[b.ends[0]].at)) for b in frame.bars.values()]
    )
    weight = STEEL.density * frame.section.area * length * 9.81
    assert total == pytest.approx(np.stack([0 * weight, weight], axis=1), rel=1e-12, abs=1e-9)


@pytest.mark.slow
def test_an_equilibrium_run_has_the_place_and_forces_of_the_analysis(tmp_path):
    hanging = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}, "C": {"at": (2, 0), "mass": 1.0}},
        fixed=["A"],
        bars={"b": ("A", "B"), "s": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=500)},
        gravity=(0, -9.81),
        runs={"hang": kt.Run(analysis="statics.equilibrium")},
    )
    run, alone = kt.run(hanging, out=tmp_path / "run"), kt.statics.equilibrium(hanging)
    assert run.motion.position.values[0] == pytest.approx(alone.position.values, abs=1e-12)
    assert run.forces["all"].member_force.values[0] == pytest.approx([3 * 9.81, 9.81], rel=1e-9)
    assert alone.member_force.values == pytest.approx([3 * 9.81, 9.81], rel=1e-9)
    assert "stable" in report.summary(kt.runs.load(tmp_path / "run")).text


@pytest.mark.slow
def test_listed_poses_are_those_of_at_poses_and_keep_their_names(bay, tmp_path):
    run = kt.run(bay, "listed", tmp_path / "run")
    alone = kt.statics.at_poses(bay, {"rest": {}, "tilt": {"bay.beta": "5 deg"}})
    for one in (run, kt.runs.load(tmp_path / "run")):
        assert np.array_equal(one.forces["all"].member_force.values, alone.member_force.values)
        assert list(one.motion.data["pose"].values) == ["rest", "tilt"]
    assert "poses rest, tilt" in report.summary(run).text


def test_poses_along_a_trajectory_are_the_forces_at_rest_of_its_motion(bay):
    run = kt.run(bay, "along")
    still = kt.dynamics.inverse(bay, kt.kinematics.follow(bay, TILT, samples=11)).static
    assert run.forces["all"].member_force.values == pytest.approx(still.member_force.values, rel=1e-12)
    assert not run.motion.velocity.values.any() and not run.motion.drive_velocity.values.any()


@pytest.mark.slow
def test_a_deflection_run_has_the_motion_its_forces_and_the_displacements(bay, tmp_path):
    run = kt.run(bay, "bent", tmp_path / "run", block=4)
    forces = kt.dynamics.inverse(bay, kt.kinematics.follow(bay, TILT, samples=11))
    wanted = kt.statics.deflection(bay, forces)
    assert run.statics["all"].displacement.values == pytest.approx(wanted.displacement.values, rel=1e-9, abs=1e-15)
    assert run.forces["all"].member_force.values == pytest.approx(forces.member_force.values, rel=1e-9)


def test_a_deflection_run_takes_the_compliance_of_an_actuator(tmp_path):
    rod = {"mass": 0.0, "section": kt.Tube(outer=0.02, inner=0.016), "material": STEEL}
    act = {"base": kt.Part(length=0.5, **rod), "tube": kt.Part(length=0.4, **rod)}
    soft = kt.Compliance(screw=2.5e6, nut=3e7, base=8e6)
    lift = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (0, 0.6), "mass": 40.0}},
        fixed={"A": "xy", "B": "x"},
        active={"lift": kt.Active(ends=("A", "B"), compliance=soft, **act)},
        gravity=(0, -9.81),
        runs={
            "up": kt.Run(
                analysis="statics.deflection", trajectory=kt.Quintic(moves={"lift": (0.6, 0.9)}, duration=1.0), samples=5
            )
        },
    )
    run = kt.run(lift, out=tmp_path / "run")
    length = run.motion.length.sel(member="lift").values
    N = run.forces["all"].member_force.sel(member="lift").values
    f = (length - 0.4) / 2.5e6 + 0.4 / (STEEL.E * rod["section"].area) + 1 / 3e7 + 1 / 8e6
    sunk = run.statics["all"].displacement.sel(node="B", axis="y").values
    assert sunk == pytest.approx(N * f, rel=1e-9) and np.all(sunk < -1e-4)


def test_an_unreachable_pose_ends_the_run_with_the_poses_before_it(bay):
    model = bay.with_(runs={"r": kt.Run(analysis="statics.at_poses", poses={"rest": {}, "far": {"M7": 40.0}})})
    run = kt.run(model)
    assert run.good == 1 and not run.whole
    assert "'far' cannot be reached" in run.message


@pytest.mark.slow
@pytest.mark.parametrize("name", ["small", "large", "listed", "along", "bent"])
@pytest.mark.usefixtures("undrawn")
def test_every_command_shows_a_static_run(frame, bay, name, tmp_path):
    kt.run(frame if name in frame.runs else bay, name, tmp_path / "out")
    page, _ = shown(tmp_path / "out", tmp_path)
    assert "Static analysis" in page


@pytest.mark.parametrize(
    ("fields", "said"),
    [
        ({"analysis": "statics.linear", "samples": 3}, "has samples, which statics.linear does not use"),
        ({"analysis": "statics.at_poses"}, "has no poses. Give one"),
        ({"analysis": "statics.at_poses", "poses": {"a": {}}, "motion": "m.csv"}, "has motion and poses. Give one"),
        ({"analysis": "statics.deflection"}, "has neither trajectory nor motion"),
        ({"analysis": "statics.equilibrium", "load_cases": ("a", "b")}, "an equilibrium has one place"),
    ],
)
def test_what_a_static_run_cannot_use_is_a_fault(fields, said):
    with pytest.raises(kt.ModelError, match=said.replace(".", r"\.")):
        kt.Run(**fields)


def test_poses_name_drives_and_pose_coordinates(bay):
    with pytest.raises(kt.ModelError, match="no drive or pose coordinate called 'M77'"):
        bay.with_(runs={"r": kt.Run(analysis="statics.at_poses", poses={"a": {"M77": 1.0}})})
