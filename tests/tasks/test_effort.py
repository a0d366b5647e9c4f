"""The least effort of redundant drives: a true minimum within the strokes, or words that there is none."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

import kinetruss as kt
from kinetruss.kinematics.drive_limits import holding, holding_rates
from kinetruss.mechanics import compile

TOP = ("B2.N7", "B2.N9", "B2.N8")
LIMITS = ("1.0 m", "1.35 m")


def mast(bays=2, limits=LIMITS, force=(300.0, 0.0, 0.0), gravity=(0.0, 0.0, -9.81)):
    """A mast whose tip is pushed sideways."""
    return kt.library.vgt.double_octahedral(bays=bays, gravity=gravity, tip_force=force, limits=limits)


def effort(model, q):
    """Sum of squares of the drive forces at rest, with the drives at q."""
    x = kt.kinematics.assemble(model, dict(zip(model.all_drives, np.asarray(q).tolist(), strict=True)))
    still = kt.kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])
    return float((kt.dynamics.inverse(model, still).static.drive_force.values ** 2).sum())


def best(model, **task):
    """Drives of least effort with the top at x = 0.1 m."""
    wanted = kt.Positioning(nodes=TOP, moves={"x": 0.1}, objective="least_effort", **task)
    found = kt.kinematics.reach(model, wanted)
    assert found.reached.values.all()
    return found.drive_position.values[0]


@pytest.mark.slow
def test_an_arm_that_lifts_a_load_to_a_height_has_the_least_torques_of_one_variable():
    """Torques of a massless arm with links of 1 m and 0.8 m under a weight: P x_tip and P (x_tip - x_elbow)."""
    a, b, P, height = 1.0, 0.8, 50.0, 1.2
    start = np.radians([80.0, 30.0])
    elbow = np.array([a * np.cos(start[0]), a * np.sin(start[0])])
    tip = elbow + b * np.array([np.cos(start[1]), np.sin(start[1])])
    arm = kt.Model(
        nodes={"O": (0, 0), "E": tuple(elbow), "T": tuple(tip)}, fixed=["O"],
        bars={"upper": kt.Bar(ends=("O", "E"), mass=0), "fore": kt.Bar(ends=("E", "T"), mass=0)},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.HingeDrive(axis="E", start="O", end="T")},
        loads={"weight": kt.NodalForce(node="T", force=(0, -P))},
    )  # fmt: skip

    def squares(first):
        second = np.arcsin((height - a * np.sin(first)) / b)
        reach = b * np.cos(second)
        return (P * (a * np.cos(first) + reach)) ** 2 + (P * reach) ** 2

    exact = minimize_scalar(squares, bounds=np.radians([40.0, 150.0]), method="bounded", options={"xatol": 1e-12}).x
    task = kt.Positioning(node="T", moves={"y": height}, free=["x"], objective="least_effort")
    found = kt.kinematics.reach(arm, task)
    assert found.drive_position.sel(drive="shoulder").item() == pytest.approx(exact, abs=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("hold", [(), ("B2.M9",)])
def test_no_motion_that_keeps_task_and_strokes_lessens_the_effort(hold):
    model = mast()
    q = best(model, hold=list(hold))
    least, rng = effort(model, q), np.random.default_rng(3)
    for _ in range(12):
        # drives near by that meet the task: the nearest to changed ones
        near = np.clip(q + rng.uniform(-0.01, 0.01, len(q)), 1.0, 1.35)
        x = kt.kinematics.assemble(model, dict(zip(model.all_drives, near.tolist(), strict=True)))
        nodes = zip(model.nodes.items(), x.tolist(), strict=True)
        moved = model.with_(
            nodes={name: node.with_(at=tuple(at)) for (name, node), at in nodes},
            active={name: one.with_(length=None) for name, one in model.active.items()},
        )
        place = np.mean([model.nodes[name].at for name in TOP], axis=0)
        wanted = kt.Positioning(nodes=TOP, moves={"x": 0.1, "y": place[1], "z": place[2]})
        if hold:
            wanted = kt.Combined(tasks=[wanted, kt.Coordinates(moves=dict.fromkeys(hold, 1.1684))])
        other = kt.kinematics.reach(moved, wanted)
        if bool(other.reached[0]):
            assert effort(model, other.drive_position.values[0]) > least * (1 - 1e-9)


@pytest.mark.slow
def test_the_least_effort_does_not_depend_on_the_unit_of_force_nor_on_the_side():
    one = best(mast(gravity=(0, 0, 0), force=(300.0, 0, 0)))
    thousand = best(mast(gravity=(0, 0, 0), force=(3e5, 0, 0)))
    assert thousand == pytest.approx(one, abs=1e-6)
    # the start does not matter where there is one minimum
    model = mast()
    first = best(model)
    motion = kt.kinematics.inverse(model, kt.Positioning(nodes=TOP, moves={"x": 0.1}, objective="least_effort"), samples=21)
    assert effort(model, motion.drive_position.values[-1]) == pytest.approx(effort(model, first), rel=1e-3)


@pytest.mark.slow
def test_drives_without_limits_that_would_run_off_are_named():
    model = mast(bays=3, limits=None)
    task = kt.Positioning(nodes=("B3.N7", "B3.N9", "B3.N8"), moves={"x": 0.1}, hold=["B2.M9"], objective="least_effort")
    with pytest.raises(
        kt.InputError, match=r"'least_effort' has no minimum near by: it still falls at B1\.M7 .*Give the drives limits"
    ):
        kt.kinematics.inverse(model, task, samples=5)
    limited = mast(bays=3)
    motion = kt.kinematics.inverse(limited, task, samples=5)
    assert motion.status.ok
    q = motion.drive_position
    assert q.values.min() >= 1.0 - 1e-9
    assert q.values.max() <= 1.35 + 1e-9
    assert np.ptp(q.sel(drive="B2.M9").values) < 1e-14


def test_derivatives_of_holding_forces_are_differences_of_them():
    system = compile(mast(gravity=(1.0, 2.0, -9.81)))
    at, rates = holding(system), holding_rates(system)
    rng, q = np.random.default_rng(0), system.drive_start
    q = q * (1.0 + 0.03 * rng.standard_normal(len(q)))

    def place(values):
        return kt.kinematics.assemble(system.given, dict(zip(system.drives, values.tolist(), strict=True))).reshape(1, -1)

    def forces(values):
        return at(place(values))[0]

    F, change = rates(place(q)[0])
    assert pytest.approx(forces(q), rel=1e-12) == F
    step = 1e-5
    differences = np.stack([(forces(q + step * e) - forces(q - step * e)) / (2 * step) for e in np.eye(len(q))], axis=1)
    np.testing.assert_allclose(change, differences, atol=1e-9 * np.abs(change).max())
