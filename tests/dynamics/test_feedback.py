"""State feedback: closed forms, Riccati against known cases, sampled loops, simulations, refusals."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import kinetruss as kt
from kinetruss.dynamics.state_feedback import not_reached
from kinetruss.errors import InputError

G = 9.81


def inverted(**fields):
    """A uniform rod of 1 m and 1 kg that stands on its hinge: theta'' = 1.5 g sin(theta) + 3 T."""
    return kt.Model(**{"nodes": {"A": (0, 0), "B": (0, 1.0)}, "fixed": ["A"], "gravity": (0, -G),
                       "bars": {"rod": kt.Bar(ends=("A", "B"), mass=1.0)}} | fields)  # fmt: skip


def upright(**fields):
    return kt.dynamics.linearise(inverted(), dofs="rod.angle", inputs="rod.angle", outputs="B.x", **fields)


def oscillator(inputs=("B.x", "A.x"), **bar):
    spring = kt.Bar(ends=("A", "B"), kind="elastic", **{"stiffness": 50.0, "damping": 1.0} | bar)
    nodes = {"A": (0, 0), "B": kt.Node(at=(1, 0), mass=2.0)}
    model = kt.Model(nodes=nodes, fixed={"A": "xy", "B": "y"}, bars={"s": spring})
    return kt.dynamics.linearise(model, inputs=list(inputs), outputs=["B.x", "B.x'", "A.x.force"], dofs="B.x")


def test_poles_are_where_they_are_wanted():
    lin = upright()
    assert not lin.stable
    found = kt.dynamics.feedback(lin, poles=[-5, -6])
    # theta'' = (1.5 g - 3 g1) theta - 3 g2 theta'
    np.testing.assert_allclose(found.gains.values, [[(30 + 1.5 * G) / 3, 11 / 3]], rtol=1e-12)
    np.testing.assert_allclose(np.sort(found.poles.real), [-6, -5], rtol=1e-9)
    assert found.stable and found.message == "" and found.period is None
    pair = kt.dynamics.feedback(lin, poles=[-2 + 3j, -2 - 3j])
    np.testing.assert_allclose(pair.pole_damping, 2 / np.sqrt(13), rtol=1e-9)


def test_gains_given():
    lin = upright()
    found = kt.dynamics.feedback(lin, gains={"rod.angle": {"rod.angle": 14.905, "rod.angle'": 11 / 3}})
    np.testing.assert_allclose(np.sort(found.poles.real), [-6, -5], rtol=1e-6)
    weak = kt.dynamics.feedback(lin, gains=[[1.0, 0.0]])
    assert not weak.stable and "not asymptotically stable" in weak.message


@pytest.mark.slow
def test_least_cost_of_a_free_mass():
    """x'' = f/m, cost q^2 x^2 + f^2: closed-loop poles sqrt(q/m) (-1 +- i)/sqrt(2)."""
    mass = kt.Model(nodes={"B": kt.Node(at=(0, 0), mass=2.0)}, fixed={"B": "y"})
    lin = kt.dynamics.linearise(mass, inputs="B.x", dofs="B.x")
    for cost in ({"B.x": 100.0**2}, [100.0**2, 0], np.diag([100.0**2, 0.0])):
        found = kt.dynamics.feedback(lin, state_cost=cost)
        np.testing.assert_allclose(np.sort_complex(found.poles), np.sqrt(25) * np.array([-1 - 1j, -1 + 1j]), rtol=1e-12)
    np.testing.assert_allclose(found.gains.values, [[100.0, np.sqrt(2 * 2 * 100)]], rtol=1e-12)
    # four times the price of a force, half the gain
    dear = kt.dynamics.feedback(lin, state_cost={"B.x": 100.0**2}, input_cost={"B.x": 4.0})
    assert dear.gains.values[0, 0] == pytest.approx(50.0)
    # a fine sampled loop comes to the same
    sampled = kt.dynamics.feedback(lin, state_cost={"B.x": 100.0**2}, period=1e-5)
    np.testing.assert_allclose(sampled.gains.values, [[100.0, 20.0]], rtol=1e-3)


def test_sampled_loops_place_the_same_poles():
    lin, period = upright(), 0.02
    found = kt.dynamics.feedback(lin, poles=[-5, -6], period=period)
    np.testing.assert_allclose(np.sort(found.poles.real), [-6, -5], rtol=1e-9)
    np.testing.assert_allclose(np.sort(found.multipliers.real), np.exp([-0.12, -0.1]), rtol=1e-10)
    a = np.sqrt(1.5 * G)
    Ad = np.array([[np.cosh(a * period), np.sinh(a * period) / a], [a * np.sinh(a * period), np.cosh(a * period)]])
    Bd = 3 / a**2 * np.array([[np.cosh(a * period) - 1], [a * np.sinh(a * period)]])
    np.testing.assert_allclose(found.closed_loop, Ad - Bd @ found.gains.values, rtol=1e-10)


@pytest.mark.slow
def test_transmissibility_with_the_loop_closed():
    """Feedback of the absolute rate (a skyhook): |x/u| = |k + i w c|/|k - m w^2 + i w (c + s)|."""
    lin, w = oscillator(), np.geomspace(0.3, 80, 11)
    sky = kt.dynamics.feedback(lin, gains={"B.x": {"B.x'": 15.0}})
    exact = np.abs((50 + 1j * w) / (50 - 2 * w**2 + 16j * w))
    np.testing.assert_allclose(sky.transmissibility(w, of="B.x", wrt="A.x")[:, 0, 0], exact, rtol=1e-11)
    # what reaches the ground: the spring and the damper alone
    np.testing.assert_allclose(
        sky.transmissibility(w, of="A.x.force", wrt="B.x")[:, 0, 0],
        np.abs((50 + 1j * w) / (50 - 2 * w**2 + 16j * w)),
        rtol=1e-10,
    )
    # of a force of the actuator between ground and mass, the ground feels the reaction too
    both = oscillator(inputs=("s", "A.x"))
    found = kt.dynamics.feedback(both, inputs="s", gains=[[0.0, 15.0]])
    H = found.frequency_response(w, of=["B.x", "A.x.force"], wrt="A.x").values[:, :, 0]
    np.testing.assert_allclose(H[:, 0], (50 + 1j * w) / (50 - 2 * w**2 + 16j * w), rtol=1e-11)
    np.testing.assert_allclose(H[:, 1], -2 * w**2 * H[:, 0], rtol=1e-9)


@pytest.mark.slow
def test_sampled_response_is_that_of_a_long_run_in_time():
    """Steady state of the exact sampled equations under a sine, its part at the frequency of the sine."""
    lin, period = oscillator(), 0.05
    found = kt.dynamics.feedback(lin, gains={"B.x": {"B.x": 20.0, "B.x'": 12.0}}, inputs="B.x", period=period)
    A, B = lin.A.values, lin.B.values
    G_ = found.gains.values
    w = 2 * np.pi * 8 / (64 * period)  # eight turns in 64 samples
    sub = 40
    h = period / sub
    # the ground moves as e^(i w t): value, rate and second rate drive the states
    big = np.block([[A, B[:, [0]], B[:, 1:] @ (1j * w) ** np.arange(3)[:, None]],
                    [np.zeros((1, 4))], [np.zeros((1, 3)), np.full((1, 1), 1j * w)]])  # fmt: skip
    step = expm(h * big)
    z, record = np.zeros(2, complex), []
    for k in range(64 * 40):
        t = k * period
        full = np.concatenate([z, -(G_ @ z), [np.exp(1j * w * t)]])
        for _ in range(sub):
            if k >= 64 * 39:
                record.append(full[0] * np.exp(-1j * w * (t + len(record) % sub * h)))
            full = step @ full
        z = full[:2]
    assert found.frequency_response(w, of="B.x", wrt="A.x").item() == pytest.approx(np.mean(record), rel=2e-3)
    # fast sampling comes to the continuous loop
    quick, slow = (
        kt.dynamics.feedback(lin, gains={"B.x": {"B.x'": 12.0}}, inputs="B.x", period=one).frequency_response([0.0, 3.0, 9.0])
        for one in (1e-5, None)
    )
    np.testing.assert_allclose(quick, slow, rtol=1e-3, atol=1e-6)


@pytest.mark.slow
def test_a_simulated_loop_falls_onto_the_closed_form():
    model = inverted()
    loop = kt.dynamics.feedback(upright(), poles=[-5, -6])
    start = [(0, 0), (np.sin(1e-4), np.cos(1e-4))]
    run = kt.dynamics.simulate(model, 1.0, positions=start, user_force=loop.user_force(), samples=11)
    theta = np.arctan2(run.motion.position.sel(node="B", axis="x"), run.motion.position.sel(node="B", axis="y"))
    exact = [(expm(loop.closed_loop.values * t) @ [1e-4, 0])[0] for t in np.linspace(0, 1, 11)]
    np.testing.assert_allclose(theta, exact, rtol=1e-5, atol=1e-10)


@pytest.mark.slow
def test_a_simulated_sampled_loop():
    """Against the rod's own equation with a torque that stands still over each period."""
    model, period = inverted(), 0.05
    loop = kt.dynamics.feedback(upright(), poles=[-5, -6], period=period)
    start = [(0, 0), (np.sin(0.2), np.cos(0.2))]
    run = kt.dynamics.simulate(model, 0.5, positions=start, user_force=loop.user_force(), samples=11)
    theta = np.arctan2(run.motion.position.sel(node="B", axis="x"), run.motion.position.sel(node="B", axis="y"))
    z, exact = np.array([0.2, 0.0]), [0.2]
    for _ in range(10):
        torque = -(loop.gains.values @ z)[0]
        z = solve_ivp(lambda t, y, T=torque: [y[1], 1.5 * G * np.sin(y[0]) + 3 * T], (0, period), z, rtol=1e-11, atol=1e-13).y[
            :, -1
        ]
        exact.append(z[0])
    np.testing.assert_allclose(theta, exact, atol=1e-8)


@pytest.mark.slow
def test_drives_let_go_push_with_what_holds_them():
    model = kt.library.vgt.double_octahedral(payload_mass=4.0)
    lin = kt.dynamics.linearise(model, dofs=["M7", "M9", "M11"], inputs=["M7", "M9", "M11"])
    loop = kt.dynamics.feedback(lin, poles=[-8, -9, -10, -11, -12, -13])
    tasks = loop.tasks()
    assert list(tasks) == ["M7", "M9", "M11"]
    start = kt.kinematics.assemble(model, {"M7": model.active["M7"].length or 1.1684 + 0.004})
    run = kt.dynamics.simulate(model, 1.0, positions=start, tasks=tasks, user_force=loop.user_force(), samples=5)
    off = run.motion.length.sel(member=["M7", "M9", "M11"]).values - 1.1684
    assert np.abs(off[0]).max() == pytest.approx(0.004) and np.abs(off[-1]).max() < 1e-4


@pytest.mark.slow
def test_refusals():
    lin = oscillator()
    for fields, text in (
        ({}, "Give one of gains, poles and state_cost"),
        ({"gains": [[1, 1]], "poles": [-1, -2]}, "Give one of"),
        ({"poles": [-1]}, "1 poles are given, but the structure has 2 states"),
        ({"poles": [-1, -1]}, "cannot be placed"),
        ({"gains": [[1, 2, 3]]}, r"gains: shape \(1, 3\), expected \(inputs = 1, states = 2\) or \(states = 2,\)"),
        ({"gains": {"B.y": {}}}, "No force input called 'B.y'"),
        ({"gains": {"B.x": {"B.z": 1}}}, "No state called 'B.z'"),
        ({"state_cost": {"Q": 1.0}}, "No state or output called 'Q'"),
        ({"state_cost": 1.0, "input_cost": 0.0}, "input_cost must be positive"),
        ({"state_cost": [1, 2, 3]}, r"state_cost: shape \(3,\), expected one number or \(weights = 2,\)"),
        ({"state_cost": 1.0, "period": -0.1}, "period is -0.1 s"),
        ({"inputs": "A.x", "state_cost": 1.0}, "No force input called 'A.x'"),
        ({"state_cost": 1.0, "input_cost": {"Q": 1.0}}, "No force input called 'Q'"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=text):
            kt.dynamics.feedback(lin, **fields)
    with pytest.raises(InputError, match="has no force input"):
        kt.dynamics.feedback(oscillator(inputs=["A.x"]), state_cost=1.0)
    two = kt.Model(nodes={"A": kt.Node(at=(0, 0), mass=1.0), "B": kt.Node(at=(1, 0), mass=1.0)}, fixed={"A": "y", "B": "y"})
    alone = kt.dynamics.linearise(two, inputs="A.x")
    with pytest.raises(InputError, match="the inputs do not reach"):
        kt.dynamics.feedback(alone, state_cost=1.0)


@pytest.mark.slow
@pytest.mark.parametrize("drive", [kt.AngleDrive("rod"), kt.HingeDrive(axis="A", start="F", end="B")])
def test_a_hinge_let_go_is_held_by_a_torque_in_a_simulation(drive):
    """A rod at 45 degrees, held by the torque m g/2 cos(45 deg) about its hinge."""
    rod = inverted(
        nodes={"A": (0, 0), "B": (np.sqrt(0.5), np.sqrt(0.5)), "F": (1.0, 0.0)}, fixed=["A", "F"], drives={"turn": drive}
    )
    torque = 0.5 * G * np.sqrt(0.5)
    let_go = {"turn": kt.GivenForce(torque=torque)}
    lin = kt.dynamics.linearise(rod, tasks=let_go, dofs="turn", inputs="turn", outputs="B.x")
    found = kt.dynamics.feedback(lin, poles=[-5, -6])
    (task,) = found.tasks().values()
    assert task.torque == pytest.approx(torque, rel=1e-9)
    run = kt.dynamics.simulate(rod, 0.5, samples=3, tasks=found.tasks(), user_force=found.user_force())
    np.testing.assert_allclose(run.motion.position.values[-1], run.motion.position.values[0], atol=1e-9)


def masses(**stiffness):
    """Masses of 1 kg on the x axis, each with a spring to a fixed node of its own (or none)."""
    nodes, bars, fixed = {}, {}, {}
    for k, (name, value) in enumerate(stiffness.items()):
        nodes |= {f"{name}0": (0, k), name: {"at": (1, k), "mass": 1.0}}
        fixed |= {f"{name}0": "xy", name: "y"}
        if value:
            bars[f"s{name}"] = kt.Bar(ends=(f"{name}0", name), kind="elastic", stiffness=value)
    return kt.Model(nodes=nodes, bars=bars, fixed=fixed)


@pytest.mark.slow
def test_a_motion_that_no_input_reaches_stays_and_is_named():
    """The reached mass has the gains that it has alone."""
    alone = kt.dynamics.linearise(masses(A=9.0), inputs="A.x", dofs="A.x")
    both = kt.dynamics.linearise(masses(A=9.0, B=25.0), inputs="A.x", dofs=("A.x", "B.x"))
    wanted = kt.dynamics.feedback(alone, state_cost=1.0).gains.values[0]
    found = kt.dynamics.feedback(both, state_cost=1.0)
    assert_allclose(found.gains.sel(state=["A.x", "A.x'"]).values[0], wanted, rtol=1e-10)
    assert_allclose(found.gains.sel(state=["B.x", "B.x'"]).values[0], 0, atol=1e-10)
    assert (
        found.message == "No input reaches the undamped motion of 5 rad/s: it stays, and the cost is that of all other motions."
    )


def test_of_two_equal_oscillators_under_one_force_their_difference_is_not_reached():
    model = masses(A=9.0, B=9.0)
    lin = kt.dynamics.linearise(model, inputs=("A.x", "B.x"), dofs=("A.x", "B.x"))
    A, B = lin.A.values, lin.B.values @ [[1.0], [1.0]]
    W, stay = not_reached(A, B)
    states = list(lin.data["state"].values)
    assert W.shape == (4, 2)
    assert_allclose(np.sort(stay.imag), [-3, 3], atol=1e-12)
    assert_allclose(W[states.index("A.x")], -W[states.index("B.x")], atol=1e-12)
    assert_allclose(W.T @ B, 0, atol=1e-12)


def test_a_free_mass_that_no_input_reaches_is_a_chain_of_two_equal_poles():
    A, B = np.array([[0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1], [0, 0, -4e6, 0]], float), np.array([[0], [0], [0], [1]], float)
    W, stay = not_reached(A, B)
    assert_allclose(stay, 0, atol=1e-12)
    assert_allclose(np.abs(W[:2]).sum(axis=0), 1)
    assert_allclose(W[2:], 0, atol=1e-12)
    assert not_reached(A, np.array([[0], [1], [0], [1]], float))[0].shape[1] == 0


def test_of_an_unstable_motion_that_no_input_reaches_there_is_no_feedback():
    nodes = {"O": (0, 0), "P": {"at": (0, 1), "mass": 1.0}, "Q": (2, 0), "R": {"at": (3, 0), "mass": 1.0}}
    bars = {"up": kt.Bar(ends=("O", "P"), mass=1.0), "s": kt.Bar(ends=("Q", "R"), kind="elastic", stiffness=4.0)}
    model = kt.Model(nodes=nodes, bars=bars, fixed={"O": "xy", "Q": "xy", "R": "y"}, gravity=(0, -9.81))
    lin = kt.dynamics.linearise(model, inputs="R.x", dofs=("P.x", "R.x"))
    with pytest.raises(InputError, match="do not reach an unstable or free motion"):
        kt.dynamics.feedback(lin, state_cost=1.0)
