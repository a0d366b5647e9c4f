"""Feedback of drives along a trajectory, as one run."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.report.run_summary import summary_record

MASS = 2.0


def slider(**changes):
    """A mass on a line, moved by the length of a bar."""
    fields = {
        "nodes": {"A": (0, 0), "B": kt.Node(at=(1, 0), mass=MASS)},
        "fixed": {"A": "xy", "B": "y"},
        "bars": {"jack": kt.Bar(ends=("A", "B"), kind="driven", mass=0)},
    }
    return kt.Model(**(fields | changes))


AWAY = kt.ConstantRate(rates={"jack": 0.2}, duration=2.0)


def test_the_error_is_that_of_an_oscillator():
    K, D, r = 50.0, 4.0, 0.2
    run = kt.dynamics.simulate(
        slider(), 2.0, trajectory=AWAY, feedback=kt.Tracking(stiffness=K, damping=D, feedforward=False), samples=21
    )
    t = run.data["time"].values
    decay, w = D / (2 * MASS), math.sqrt(K / MASS - (D / (2 * MASS)) ** 2)
    error = -r / w * np.exp(-decay * t) * np.sin(w * t)
    rate = -r * np.exp(-decay * t) * (np.cos(w * t) - decay / w * np.sin(w * t))
    np.testing.assert_allclose(run.data["tracking_error"].values[:, 0], error, rtol=0, atol=1e-9)
    np.testing.assert_allclose(run.data["feedback_force"].values[:, 0], -K * error - D * rate, rtol=0, atol=1e-7)
    # the force is that of the drive, inside the bar, not a load on its ends
    np.testing.assert_allclose(run.forces.drive_force.values, run.data["feedback_force"].values, rtol=0, atol=1e-12)
    np.testing.assert_allclose(run.forces.member_force.values, -run.forces.drive_force.values, rtol=0, atol=1e-12)
    assert np.abs(run.forces.data["energy_balance"].values).max() < 1e-12


def test_gains_of_least_cost_are_those_of_a_double_integrator():
    q, s, u, r = 30.0, 0.5, 0.01, 0.2
    tracking = kt.Tracking(error_cost=q, rate_cost=s, force_cost=u, feedforward=False, instants=2)
    run = kt.dynamics.simulate(slider(), 1.0, trajectory=AWAY, feedback=tracking, samples=11)
    K = math.sqrt(q / u)
    D = math.sqrt(s / u + 2 * MASS * K)
    given = kt.Tracking(stiffness=K, damping=D, feedforward=False)
    same = kt.dynamics.simulate(slider(), 1.0, trajectory=AWAY, feedback=given, samples=11)
    assert np.abs(same.data["tracking_error"].values).max() > 1e-3 * r
    np.testing.assert_allclose(run.data["tracking_error"].values, same.data["tracking_error"].values, rtol=0, atol=1e-9)


def test_the_force_stays_within_its_limit():
    limit, r = 0.3, 5.0
    fast = kt.ConstantRate(rates={"jack": r}, duration=1.0)
    tracking = kt.Tracking(damping=10.0, limits={"jack": limit}, feedforward=False)
    run = kt.dynamics.simulate(slider(), 1.0, trajectory=fast, feedback=tracking, samples=6)
    t = run.data["time"].values
    np.testing.assert_allclose(run.motion.position.sel(node="B", axis="x").values, 1 + 0.5 * limit / MASS * t**2, atol=1e-10)
    np.testing.assert_allclose(run.data["feedback_force"].values[:, 0], limit, atol=1e-12)
    asked = 10.0 * (r - limit / MASS * t)
    np.testing.assert_allclose(run.data["feedback_asked"].values[:, 0], asked, atol=1e-8)


def test_a_motor_limits_the_force():
    motor = kt.Motor(
        inertia=1e-5, resistance=1, torque_constant=0.05, emf_constant=0.05, max_current=4, friction_torque=0.02, max_torque=1
    )
    arm = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=1.0)},
        fixed=["O"],
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        drives={"turn": kt.AngleDrive("arm", gear=kt.Gear(ratio=10, efficiency=0.8), motor=motor)},
    )
    move = kt.ConstantRate(rates={"turn": 50.0}, duration=0.1)
    run = kt.dynamics.simulate(arm, 0.1, trajectory=move, feedback=kt.Tracking(damping=1e3, feedforward=False), samples=3)
    torque = (4 * 0.05 - 0.02) * 10 * 0.8
    np.testing.assert_allclose(run.data["feedback_force"].values, torque, rtol=1e-12)
    free = kt.Tracking(damping=1e3, feedforward=False, motor_limits=False)
    without = kt.dynamics.simulate(arm, 0.1, trajectory=move, feedback=free, samples=3)
    assert without.data["feedback_force"].values[0, 0] == pytest.approx(5e4)


def test_a_slew_under_feedback_is_the_prescribed_one_if_nothing_disturbs_it():
    bay = kt.library.vgt.double_octahedral()
    slew = kt.Quintic(moves={"bay.beta": ("0 deg", "20 deg"), "bay.gamma": ("0 deg", "-10 deg")}, duration=1.0)
    run = kt.dynamics.simulate(bay, 1.0, trajectory=slew, feedback=kt.Tracking(stiffness=2e3, damping=100.0), samples=11)
    motion = kt.kinematics.follow(bay, slew, samples=11)
    forces = kt.dynamics.inverse(bay, motion)
    np.testing.assert_allclose(run.motion.position.values, motion.position.values, rtol=0, atol=2e-6)
    largest = float(np.abs(forces.member_force.values).max())
    np.testing.assert_allclose(run.forces.member_force.values, forces.member_force.values, rtol=0, atol=2e-3 * largest)
    assert kt.strength.check(bay, run.forces).table()


def test_a_floating_structure_under_feedback_turns_as_its_momentum_says():
    nodes = {"O": (0, 0), "P": (1, 0), "Q": (0, 1)}
    bodies = {
        "one": kt.Body(nodes=("O", "P"), mass=3.0, center=(0.4, 0), inertia=0.2),
        "two": kt.Body(nodes=("O", "Q"), mass=2.0, center=(0, 0.6), inertia=0.5),
    }
    model = kt.Model(nodes=nodes, bodies=bodies, drives={"turn": kt.HingeDrive(axis="O", start="P", end="Q")})
    move = kt.Quintic(moves={"turn": (math.pi / 2, math.pi / 2 + 2 * math.pi)}, duration=3.0)
    stiff = kt.Tracking(stiffness=500.0, damping=60.0)
    run = kt.dynamics.simulate(model, 3.0, trajectory=move, feedback=stiff, samples=7)
    motion = kt.kinematics.follow(model, move, samples=7)
    np.testing.assert_allclose(run.motion.position.values, motion.position.values, rtol=0, atol=1e-6)
    assert np.abs(run.data["angular_momentum"].values).max() < 1e-9


FILE = """
kinetruss: 1
nodes: {A: [0, 0], B: {at: [1 m, 0], mass: 2 kg}}
fixed: {A: xy, B: y}
bars: {jack: {ends: [A, B], kind: driven, mass: 0}}
trajectories:
  away: {kind: quintic, moves: {jack: [1 m, 1.4 m]}, duration: 1 s}
runs:
  slew:
    analysis: dynamics.simulate
    trajectory: away
    t_end: 1.2 s
    samples: 13
    feedback: {stiffness: 200 N/m, damping: 40 N s/m, limits: 15 N}
"""


def test_a_run_of_a_file_has_feedback_and_its_results(tmp_path):
    file = tmp_path / "model.yaml"
    file.write_text(FILE)
    assert kt.check(file) == []
    model = kt.read(file)
    result = kt.run(model, "slew", out=tmp_path / "out", block=5)
    error = result.simulation.data["tracking_error"].values
    direct = kt.dynamics.simulate(
        model, 1.2, trajectory="away", feedback=model.runs["slew"].feedback, times=np.linspace(0, 1.2, 13)
    )
    np.testing.assert_array_equal(error, direct.data["tracking_error"].values)
    assert np.abs(error).max() < 1e-6
    assert np.abs(result.simulation.data["feedback_force"].values).max() < 15
    (row,) = summary_record(result)["simulation"]["feedback"]
    assert row["drive"] == "jack" and row["force_unit"] == "N" and abs(row["error"]) == np.abs(error).max()


@pytest.mark.parametrize(
    "given, said",
    [
        ({"feedback": {"stiffness": 1.0, "error_cost": 1.0}}, "both gains and error_cost"),
        ({"feedback": {}}, "neither stiffness nor error_cost"),
        ({"feedback": {"stiffness": 1.0}, "trajectory": None}, "the run has none"),
        ({"feedback": {"stiffness": 1.0}, "tasks": {"jack": kt.Free()}}, "all have a task"),
        ({"feedback": {"stiffness": {"rod": 1.0}}}, "rod"),
    ],
)
def test_feedback_that_cannot_be_is_refused(given, said):
    fields = {"analysis": "dynamics.simulate", "t_end": 1.0, "trajectory": AWAY} | given
    with pytest.raises(kt.ModelError, match=said):
        slider(runs={"go": kt.Run(**fields)})


def test_gains_of_least_cost_need_drives_that_are_the_freedoms():
    nodes = {"O": (0, 0), "P": (1, 0), "Q": (0, 1)}
    bodies = {"one": kt.Body(nodes=("O", "P"), mass=3.0), "two": kt.Body(nodes=("O", "Q"), mass=2.0)}
    model = kt.Model(nodes=nodes, bodies=bodies, drives={"turn": kt.HingeDrive(axis="O", start="P", end="Q")})
    move = kt.Quintic(moves={"turn": (math.pi / 2, 2.0)}, duration=1.0)
    with pytest.raises(kt.InputError, match="freedom"):
        kt.dynamics.simulate(model, 1.0, trajectory=move, feedback=kt.Tracking(error_cost=1.0))
