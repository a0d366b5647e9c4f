"""Forward dynamics against formulations in angles that know of no bars."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.library import mechanisms
from reference import andrews, linkages, pendulums

TIGHT = kt.DOP853(rtol=1e-12, atol=1e-13)


@pytest.mark.slow
@settings(max_examples=10)
@given(
    angles=st.tuples(st.floats(-3, 3), st.floats(-3, 3)),
    rates=st.tuples(st.floats(-2, 2), st.floats(-2, 2)),
    lengths=st.tuples(st.floats(0.3, 1.5), st.floats(0.3, 1.5)),
    masses=st.tuples(st.floats(0.1, 2), st.floats(0.1, 2)),
    bobs=st.tuples(*2 * [st.just(0.0) | st.floats(1e-6, 2)]),
)
def test_double_pendulum(angles, rates, lengths, masses, bobs):
    model = mechanisms.double_pendulum(angles=angles, rates=rates, lengths=lengths, masses=masses, bobs=bobs)
    chain = pendulums.Chain(lengths, masses, bobs)
    times = np.linspace(0, 1.0, 6)
    run = kt.dynamics.simulate(model, 1.0, times=times, method=TIGHT)
    theta, rate = chain.run(np.array(angles), np.array(rates), times)
    for i in range(len(times)):
        x, v, a = chain.joints(theta[i], rate[i])
        now = run.motion.data.isel(time=i)
        np.testing.assert_allclose(now.position.values[1:], x, atol=1e-8)
        np.testing.assert_allclose(now.velocity.values[1:], v, atol=1e-7)
        np.testing.assert_allclose(now.acceleration.values[1:], a, atol=1e-6 * np.abs(a).max() + 1e-9)
        pins = chain.pin_forces(theta[i], rate[i])
        found = run.forces.joint_force.isel(time=i).sel(end="A").values
        # a bob at P1 belongs to the first rod in the oracle and to the node in the model
        np.testing.assert_allclose(found, pins, atol=1e-6 * np.abs(pins).max() + 1e-9)
        kinetic = chain.energy(theta[i], rate[i])[0]
        assert run.kinetic_energy.values[i] == pytest.approx(kinetic, abs=1e-7 * (1 + kinetic))


@pytest.mark.slow
def test_triple_pendulum_with_every_solver():
    chain = pendulums.Chain((1, 1, 1), (1, 1, 1), (0, 0, 0))
    theta, rate = chain.run(np.full(3, np.pi / 2), np.zeros(3), np.array([0.0, 1.0]))
    x, v, _ = chain.joints(theta[-1], rate[-1])
    for solver in ("dense", "sparse", "sweep"):
        run = kt.dynamics.simulate(mechanisms.n_pendulum(links=3), 1.0, samples=2, method=TIGHT.with_(solver=solver))
        end = run.motion.data.isel(time=-1)
        np.testing.assert_allclose(end.position.values[1:], x, atol=1e-10, err_msg=solver)
        np.testing.assert_allclose(end.velocity.values[1:], v, atol=1e-9, err_msg=solver)


@pytest.mark.slow
def test_torque_on_a_pendulum():
    """A constant torque of a motor at the pin, as the couple of an angle drive."""
    model = mechanisms.pendulum(mass=0.5, angle=0.0).with_(drives={"motor": kt.AngleDrive("link1")})
    run = kt.dynamics.simulate(model, 2.0, samples=5, tasks={"motor": kt.GivenForce(torque=2.0)}, method=TIGHT)
    chain = pendulums.Chain((1.0,), (0.5,), (1.0,), torques=(2.0,))
    theta, rate = chain.run(np.zeros(1), np.zeros(1), run.motion.time.values)
    np.testing.assert_allclose(run.motion.drive_position.values[:, 0], theta[:, 0] - np.pi / 2, atol=1e-10)
    np.testing.assert_allclose(run.motion.drive_velocity.values[:, 0], rate[:, 0], atol=1e-10)
    np.testing.assert_allclose(run.forces.drive_force.values, 2.0, atol=1e-14)


@pytest.mark.slow
def test_andrews_along_the_way():
    times = np.linspace(0, andrews.END, 16)
    run = kt.dynamics.simulate(
        mechanisms.andrews(), andrews.END, times=times, tasks={"motor": kt.GivenForce(torque=andrews.TORQUE)}, method=TIGHT
    )
    for i, (q, v) in enumerate(zip(*andrews.run(times), strict=True)):
        x, rate, second = andrews.nodes(q, v)
        now = run.motion.data.isel(time=i)
        for name in "FEDGH":
            np.testing.assert_allclose(now.position.sel(node=name).values, x[name], atol=1e-11)
            np.testing.assert_allclose(now.velocity.sel(node=name).values, rate[name], atol=1e-8)
            np.testing.assert_allclose(now.acceleration.sel(node=name).values, second[name], atol=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("loops", [1, 2, 5, 40])
def test_row_of_four_bars_by_default_settings(loops):
    run = kt.dynamics.simulate(mechanisms.n_four_bar(loops=loops), 10.0, samples=101)
    theta, _ = linkages.row_of_four_bars(loops, run.motion.time.values)
    for k in (0, loops):
        x = run.motion.position.sel(node=f"B{k}").values - [k, 0]
        np.testing.assert_allclose(x, np.stack([np.sin(theta), np.cos(theta)], 1), atol=1e-7)
    assert len(run.passages) == int(theta[-1] / np.pi + 0.5)


@pytest.mark.slow
def test_row_of_four_bars_let_go_where_it_lies_flat():
    """It starts in a singular position; the velocities say which way it goes."""
    times = np.linspace(0, 2, 9)
    run = kt.dynamics.simulate(mechanisms.n_four_bar(loops=2, angle=np.pi / 2, rate=2.0), 2.0, times=times)
    theta, _ = _row_from(np.pi / 2, 2.0, times)
    x = run.motion.position.sel(node="B1").values - [1, 0]
    np.testing.assert_allclose(x, np.stack([np.sin(theta), np.cos(theta)], 1), atol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("loops", [1, 2])
@pytest.mark.parametrize(
    "method", [kt.EnergyMomentum(0.001), kt.Rattle(0.001), kt.GeneralizedAlpha(0.001)], ids=lambda m: m.kind
)
def test_fixed_steps_stay_on_the_branch(method, loops):
    """The posts of the row stay parallel; where they lie flat, each could fold back."""
    run = kt.dynamics.simulate(mechanisms.n_four_bar(loops=loops, rate=3.3), 3.0, samples=31, method=method)
    theta, _ = linkages.row_of_four_bars(loops, run.motion.time.values, rate=3.3)
    for k in range(loops + 1):
        x = run.motion.position.sel(node=f"B{k}").values - [k, 0]
        np.testing.assert_allclose(x, np.stack([np.sin(theta), np.cos(theta)], 1), atol=1e-3)


def _row_from(theta: float, rate: float, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    from scipy.integrate import solve_ivp

    k = 9.81 * (1.5 + 2) / (1 + 2)
    found = solve_ivp(
        lambda _, y: [y[1], k * np.sin(y[0])], (0, times[-1]), [theta, rate], "DOP853", times, rtol=1e-12, atol=1e-12
    )
    return found.y


@pytest.mark.slow
@settings(max_examples=6)
@given(angle=st.floats(-3, 3), rate=st.floats(-8, 8))
def test_spatial_slider_crank(angle, rate):
    run = kt.dynamics.simulate(mechanisms.spatial_slider_crank(angle=angle, rate=rate), 1.0, samples=5, method=TIGHT)
    crank = linkages.SlidingCrank()
    theta, turning = crank.run(run.motion.time.values, angle, rate)
    slide = np.array([crank.slide(each)[:2] for each in theta])
    np.testing.assert_allclose(run.motion.position.sel(node="S", axis="x").values, slide[:, 0], atol=1e-10)
    np.testing.assert_allclose(run.motion.velocity.sel(node="S", axis="x").values, slide[:, 1] * turning, atol=1e-8)
