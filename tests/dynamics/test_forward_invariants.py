"""What forward dynamics must leave unchanged: energy, momenta, the way of looking at it, the direction of time."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.integrate import solve_ivp

import kinetruss as kt
from kinetruss.library import mechanisms

FEW = settings(max_examples=12)
ANGLE = st.floats(-3.1, 3.1)
RATE = st.floats(-3, 3)
METHOD = kt.DOP853(rtol=1e-10, atol=1e-11)


def rhombus(angle: float, rate: float) -> kt.Model:
    """A rhombus on its spring, which is damped by nothing; the side rods turn at `rate`."""
    model = mechanisms.rhombus_with_spring(angle=angle)
    v = (-rate * math.sin(angle), rate * math.cos(angle))
    return model.with_(velocities={"B0": v, "B1": v})


def cage(first: tuple[float, ...], second: tuple[float, ...], gravity: tuple[float, ...] | None = None) -> kt.Model:
    """Two tetrahedra that share node S and turn about it at these rates, with a spring between them; free in space."""
    one = {"A1": (1.0, 0.1, 0.0), "A2": (0.3, 0.9, 0.2), "A3": (0.4, 0.2, 1.0)}
    two = {"B1": (-0.9, 0.0, 0.2), "B2": (-0.2, -0.8, 0.1), "B3": (-0.3, -0.4, 0.9)}
    bars = {}
    for body in (("S", *one), ("S", *two)):
        bars |= {f"{a}{b}": kt.Bar(ends=(a, b), mass=1.0) for i, a in enumerate(body) for b in body[i + 1 :]}
    bars["spring"] = kt.Bar(ends=("A1", "B1"), kind="elastic", strain="green", stiffness=60.0, natural_length=1.5, mass=0.0)
    velocities = {name: np.cross(first, at) for name, at in one.items()} | {
        name: np.cross(second, at) for name, at in two.items()
    }
    return kt.Model(
        nodes={"S": (0.0, 0.0, 0.0)} | one | two,
        bars=bars,
        velocities={name: tuple(v.tolist()) for name, v in velocities.items()},
        gravity=gravity,
    )


BUILD = {
    "double_pendulum": lambda a, b, w: mechanisms.double_pendulum(angles=(a, b), rates=(w, -w), masses=(0.5, 0.3)),
    "slider_crank": lambda a, b, w: mechanisms.slider_crank(angle=a, rate=w, offset=0.1 * math.sin(b)).with_(drives={}),
    "four_bars": lambda a, b, w: mechanisms.n_four_bar(loops=3, angle=a, rate=w),
    "rhombus": lambda a, b, w: rhombus(0.6 + 0.2 * math.sin(a), w),
    "spatial": lambda a, b, w: mechanisms.spatial_slider_crank(angle=a, rate=3 * w),
    "cage": lambda a, b, w: cage((w, a, b), (b, -w, a), (0.0, 0.0, -9.81)),
}


def energy(run: kt.results.Simulation) -> np.ndarray:
    return run.kinetic_energy.values + run.potential_energy.values


@pytest.mark.slow
@pytest.mark.parametrize("name", BUILD)
@FEW
@given(a=ANGLE, b=ANGLE, w=RATE)
def test_energy_is_kept(name, a, b, w):
    run = kt.dynamics.simulate(BUILD[name](a, b, w), 2.0, samples=41, method=METHOD)
    scale = np.abs(run.kinetic_energy.values).max() + np.ptp(run.potential_energy.values)
    assert np.ptp(energy(run)) < 1e-7 * scale + 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("loops", [1, 3, 5])
@pytest.mark.parametrize("beside", [1e-4, 1e-3, 3e-3, 1e-2])
@pytest.mark.parametrize("rate", [0.0, 0.01, 0.3])
def test_energy_is_kept_where_a_mechanism_turns_back_right_behind_a_singular_position(loops, beside, rate):
    """Four-bars let go within a degree of the flat position swing over to the other one, pass it, turn and pass it again."""
    run = kt.dynamics.simulate(mechanisms.n_four_bar(loops=loops, angle=math.pi / 2 - beside, rate=rate), 2.5, samples=251)
    assert np.ptp(energy(run)) < 1e-6 * run.kinetic_energy.values.max()
    # the angle's own equation, as of a pendulum: angle'' = (weight/inertia) sin(angle)
    pull = 9.81 * ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)
    found = solve_ivp(
        lambda _, y: [y[1], pull * math.sin(y[0])], (0.0, 2.5), [math.pi / 2 - beside, rate], "DOP853",
        run.motion.time.values, rtol=1e-12, atol=1e-12, max_step=2e-3, events=lambda _, y: math.cos(y[0]),
    )  # fmt: skip
    angle, flat = found.y[0], found.t_events[0]
    at = run.motion.position.sel(node="B0").values
    np.testing.assert_allclose(at, np.stack([np.sin(angle), np.cos(angle)], axis=1), atol=1e-5)
    if beside >= 1e-3:  # else it never leaves what counts as the singular position between two passages
        np.testing.assert_allclose([one.time for one in run.passages], flat, atol=2e-4)


@pytest.mark.slow
@FEW
@given(first=st.tuples(RATE, RATE, RATE), second=st.tuples(RATE, RATE, RATE))
def test_momenta_of_a_free_structure_are_kept(first, second):
    run = kt.dynamics.simulate(cage(first, second), 2.0, samples=21, method=METHOD)
    speed = math.sqrt(2 * run.kinetic_energy.values.max() / 12)
    for name in ("momentum", "angular_momentum"):
        change = run.data[name].values - run.data[name].values[0]
        assert np.abs(change).max() < 1e-7 * 12 * speed + 1e-10


@pytest.mark.slow
@FEW
@given(turn=ANGLE, shift=st.tuples(st.floats(-9, 9), st.floats(-9, 9)), a=ANGLE, b=ANGLE)
def test_a_problem_turned_moved_and_mirrored_has_the_motion_turned_moved_and_mirrored(turn, shift, a, b):
    model = mechanisms.double_pendulum(angles=(a, b), rates=(1.0, 0.0), masses=(0.5, 0.0))
    Q = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]]) @ np.diag([1.0, -1.0])

    def seen(vector):
        return tuple((Q @ vector).tolist())

    other = model.with_(
        nodes={name: node.with_(at=tuple(np.add(seen(node.at), shift).tolist())) for name, node in model.nodes.items()},
        velocities={name: seen(v) for name, v in model.velocities.items()},
        gravity=seen(model.gravity),
    )
    one, two = (kt.dynamics.simulate(each, 1.0, samples=11, method=METHOD) for each in (model, other))
    np.testing.assert_allclose(two.motion.position.values, one.motion.position.values @ Q.T + shift, atol=2e-6)
    force = one.forces.member_force.values
    np.testing.assert_allclose(two.forces.member_force.values, force, atol=1e-5 * np.abs(force).max())


@pytest.mark.slow
@pytest.mark.parametrize("name", ["double_pendulum", "four_bars", "rhombus", "spatial", "cage"])
@settings(max_examples=6)
@given(a=st.floats(0.2, 1.2), b=ANGLE, w=st.floats(0.3, 2))
def test_a_motion_run_backwards_comes_home(name, a, b, w):
    model = BUILD[name](a, b, w)
    away = kt.dynamics.simulate(model, 1.0, samples=2, method=METHOD)
    end = away.motion.data.isel(time=-1)
    back = kt.dynamics.simulate(
        model, 1.0, samples=2, method=METHOD, positions=end.position.values, velocities=-end.velocity.values
    )
    home = back.motion.data.isel(time=-1)
    start = away.motion.data.isel(time=0)
    np.testing.assert_allclose(home.position.values, start.position.values, atol=1e-6)
    np.testing.assert_allclose(-home.velocity.values, start.velocity.values, atol=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("name", BUILD)
def test_inverse_dynamics_along_the_motion_finds_the_same_forces(name):
    model = BUILD[name](0.4, 0.9, 1.3)
    run = kt.dynamics.simulate(model, 1.0, samples=21)
    again = kt.dynamics.inverse(model, run.motion, static=False)
    for what in ("member_force", "end_force", "joint_force", "reaction"):
        expected = again.data[what].values
        size = np.abs(expected).max(initial=0.0)
        np.testing.assert_allclose(run.forces.data[what].values, expected, atol=1e-8 * size, err_msg=what)


@pytest.mark.slow
def test_forces_of_a_driven_motion_given_back_reproduce_it():
    """Inverse dynamics of a crank that is turned; its torque as a table turns the crank let go in the same way."""
    model = mechanisms.four_bar(gravity=None)
    turn = kt.Quintic(moves={"motor": (math.pi / 2, math.pi / 2 + 3.0)}, duration=1.0)
    motion = kt.kinematics.follow(model, turn, samples=4001)
    torque = kt.dynamics.inverse(model, motion, static=False).drive_force.values[:, 0]
    given_back = kt.GivenForce(times=motion.time.values, torques=torque)
    run = kt.dynamics.simulate(model, 1.0, samples=11, tasks={"motor": given_back})
    np.testing.assert_allclose(run.motion.position.values, motion.position.values[::400], atol=1e-7)
    np.testing.assert_allclose(run.forces.drive_force.values[:, 0], torque[::400], atol=1e-12)


@pytest.mark.slow
def test_forces_of_driven_active_members_given_back_reproduce_the_motion():
    """The same through base rods, tubes and their convective terms, in the triangular truss with gravity."""
    model = kt.library.vgt.triangular()
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"actuator": (2.5, 3.2)}, duration=1.0), samples=4001)
    thrust = kt.dynamics.inverse(model, motion, static=False).drive_force.values[:, 0]
    given_back = kt.GivenForce(times=motion.time.values, forces=thrust)
    run = kt.dynamics.simulate(model, 1.0, samples=11, tasks={"actuator": given_back})
    np.testing.assert_allclose(run.motion.length.values, motion.length.values[::400], atol=1e-6)


@pytest.mark.slow
def test_a_trajectory_in_a_simulation_is_the_motion_of_follow():
    model = mechanisms.four_bar()
    turn = kt.Quintic(moves={"motor": (math.pi / 2, math.pi / 2 + 3.0)}, duration=1.0)
    motion = kt.kinematics.follow(model, turn, samples=11)
    run = kt.dynamics.simulate(model, 1.0, samples=11, trajectory=turn)
    np.testing.assert_allclose(run.motion.position.values, motion.position.values, atol=1e-10)
    np.testing.assert_allclose(run.motion.acceleration.values, motion.acceleration.values, atol=1e-6)
    wanted = kt.dynamics.inverse(model, motion, static=False).drive_force.values
    np.testing.assert_allclose(run.forces.drive_force.values, wanted, atol=1e-6 * np.abs(wanted).max())
