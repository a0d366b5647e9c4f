"""Hinge and axis angles: against rotations, derivatives by complex steps, kinematics and inverse dynamics."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from hinge_models import Arm, DoublePendulum, turn
from kinetruss.mechanics import compile, measure_gradients, measure_hessian, measure_turning, measured

STEP = 1e-30


def sums_of(seed):
    """A compiled model with every kind of coordinate in one coupling, drawn at random."""
    rng = np.random.default_rng(seed)
    at = rng.standard_normal((6, 3))
    terms = (
        (kt.HingeDrive(axis=("A", "B"), start="C", end="D"), 1.0),
        (kt.AngleDrive("de", axis=tuple(rng.standard_normal(3))), -2.0),
        (kt.LengthDrive("ef"), 0.7),
        (kt.CoordinateDrive(node="F", axis="y"), 1.3),
    )
    return compile(kt.Model(
        nodes=dict(zip("ABCDEF", at, strict=True)), fixed=["A"],
        bars={"de": ("D", "E"), "ef": ("E", "F"), "ab": ("A", "B")},
        couplings={"all": kt.Coupling(terms=terms)},
    ))  # fmt: skip


def value(system, x):
    """The coordinate for complex x (n, 3); angles by the arc tangent, so only its derivatives count."""
    total = 0.0
    for t in range(len(system.term_kind)):
        P, one, two, begin = (int(flat) // 3 for flat in system.term_at[t])
        factor, e1, e2 = system.term_data[t, 0], system.term_data[t, 1:4], system.term_data[t, 4:]
        r, b = x[P] - x[one], x[two] - x[one]
        kind = ("along", "fixed", "around", "offset", "node")[system.term_kind[t]]
        if kind == "along":
            total = total + factor * np.sqrt(r @ r)
        elif kind == "fixed":
            total = total + factor * np.arctan((e2 @ r) / (e1 @ r))
        elif kind == "node":
            total = total + factor * (e1 @ x[P])
        elif begin * 3 >= 0 and system.term_at[t, 3] >= 0:
            p, q = np.cross(b, x[begin] - x[one]), np.cross(b, r)
            total = total + factor * np.arctan((b @ np.cross(p, q)) / np.sqrt(b @ b) / (p @ q))
    return total


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_gradients_and_their_rates_are_derivatives(seed):
    system = sums_of(seed)
    x, n = system.x0, system.x0.size
    units = np.eye(n).reshape(n, *x.shape)
    g = measure_gradients(system, 0, x[None])[0]
    stepped = np.array([value(system, x + 1j * STEP * unit).imag / STEP for unit in units])
    size = np.abs(g).max()
    assert np.abs(g - stepped).max() < 1e-11 * size
    # Hessian: differences of the gradient, itself exact
    flats, H = measure_hessian(system, 0, x)
    h = 1e-6
    rows = [(measure_gradients(system, 0, x[None] + h * u)[0] - measure_gradients(system, 0, x[None] - h * u)[0]) / (2 * h)
            for u in units]  # fmt: skip
    full = np.zeros((n, n))
    full[np.ix_(flats, flats)] = H
    assert np.abs(full - np.array(rows)).max() < 1e-6 * max(np.abs(H).max(), size**3)


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_rates_along_a_motion_agree_with_those_of_gradients(seed):
    system = sums_of(seed)
    rng = np.random.default_rng(seed + 1)
    x, v, a = system.x0, rng.standard_normal(system.x0.shape), rng.standard_normal(system.x0.shape)
    _, rate, second = measured(system, 0, x[None], v[None], a[None])[0]
    g = measure_gradients(system, 0, x[None])[0]
    g1, g2 = measure_turning(system, 0, x, v, a)
    _, H = measure_hessian(system, 0, x)
    assert rate == pytest.approx(g @ v.ravel(), rel=0, abs=1e-13 * (np.abs(g) @ np.abs(v.ravel())))
    assert second == pytest.approx(g @ a.ravel() + g1 @ v.ravel(), rel=1e-9, abs=1e-9 * np.abs(H).max())

    def slope(h):
        along = [measure_turning(system, 0, x + s * h * v + 0.5 * h * h * a, v + s * h * a, a)[0] for s in (1, -1)]
        return (along[0] - along[1]) / (2 * h)

    # Richardson's extrapolation: where a hinge is short, an error of second order alone would depend on the seed
    assert np.abs((4 * slope(0.5e-4) - slope(1e-4)) / 3 - g2).max() < 1e-6 * max(1.0, np.abs(g2).max())


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**6), angle=st.floats(-3.1, 3.1))
def test_hinge_angle_is_that_of_the_rotation(seed, angle):
    rng = np.random.default_rng(seed)
    A, B, C = rng.standard_normal((3, 3))
    e = (B - A) / np.linalg.norm(B - A)
    along, out = rng.standard_normal(), 0.2 + rng.random()
    D = A + turn(e, angle) @ (out * (C - A)) + along * e
    if np.linalg.norm(np.cross(C - A, e)) < 1e-2:
        return
    model = kt.Model(
        nodes={"A": A, "B": B, "C": C, "D": D}, fixed=["A"], bars={"ab": ("A", "B")},
        drives={"h": kt.HingeDrive(axis=("A", "B"), start="C", end="D")},
    )  # fmt: skip
    assert compile(model).drive_start[0] == pytest.approx(angle, abs=1e-12)


def test_axis_angle_has_the_reference_it_is_given():
    def at(axis, end, **more):
        model = kt.Model(nodes={"O": (0, 0, 0), "P": end}, fixed=["O"], bars={"b": ("O", "P")},
                         drives={"d": kt.AngleDrive("b", axis=axis, **more)})  # fmt: skip
        return compile(model).drive_start[0]

    assert at("z", (0, 1, 5)) == pytest.approx(np.pi / 2)
    assert at("z", (1, 0, 5), reference=(0, 1, 3)) == pytest.approx(-np.pi / 2)
    assert at("x", (5, 0, 1)) == pytest.approx(np.pi / 2)
    assert at("y", (1, 5, 0)) == pytest.approx(np.pi / 2)
    assert at((1, 1, 1), (3, -1, 0)) == pytest.approx(0.0, abs=1e-15)


def arm_path():
    arm = Arm()
    model = arm.model()
    start = compile(model).drive_start
    path = kt.Quintic(moves={"base": (start[0], start[0] + 7.0), "elbow": (start[1], start[1] - 8.0)}, duration=1.5)
    motion = kt.kinematics.follow(model, path, samples=101)
    q, qd, qdd = (motion.data[f"drive_{name}"].values for name in ("position", "velocity", "acceleration"))
    return arm, model, motion, q - start, qd, qdd


def test_arm_with_moving_axis_follows_products_of_rotations():
    arm, model, motion, q, qd, qdd = arm_path()
    mine = [motion.data[name].sel(node=["S1", "S2", "P"]).values for name in ("position", "velocity", "acceleration")]
    for k in range(len(q)):
        x, v, a, _ = arm.state(q[k], qd[k], qdd[k])
        for found, exact in zip(mine, (x, v, a), strict=True):
            assert np.abs(found[k] - exact).max() < 1e-10
    # the elbow makes more than a full turn: nothing is singular on the way
    assert float(motion.data["singularity"].min()) > 0.1
    forces = kt.dynamics.inverse(model, motion)
    torque = np.array([arm.torque(*one) for one in zip(q, qd, qdd, strict=True)])
    assert np.abs(forces.data["drive_force"].values - torque).max() < 1e-10 * np.abs(torque).max()
    assert np.abs(forces.data["energy_balance"].values).max() < 1e-9 * np.abs(forces.data["power"].values).max()


def test_double_pendulum_with_a_relative_angle_has_textbook_torques():
    one = DoublePendulum()
    model = one.model()
    path = kt.Quintic(moves={"shoulder": (0.0, 6.5), "elbow": (np.pi, np.pi - 9.0)}, duration=1.0)
    motion = kt.kinematics.follow(model, path, samples=81)
    found = kt.dynamics.inverse(model, motion).data["drive_force"].values
    q, qd, qdd = (motion.data[f"drive_{name}"].values for name in ("position", "velocity", "acceleration"))
    for k in range(len(q)):
        M, h = one.terms(q[k] - [0.0, np.pi], qd[k])
        assert found[k] == pytest.approx(M @ qdd[k] + h, abs=1e-10 * np.abs(found).max())


def test_a_drive_without_a_task_is_held():
    model = Arm().model()
    part = kt.Quintic(moves={"base": (compile(model).drive_start[0], 0.5)}, duration=1.0)
    moved = kt.kinematics.follow(model, part, samples=11)
    assert np.ptp(moved.data["drive_position"].sel(drive="elbow").values) < 1e-12


def test_inverse_kinematics_finds_the_angles():
    arm, model, motion, _, _, _ = arm_path()
    held = motion.data.isel(time=slice(0, 30))
    tip = held["position"].sel(node="P").values
    targets = kt.Spline(times=held["time"].values, values={"P.x": tip[:, 0], "P.y": tip[:, 1]})
    found = kt.kinematics.inverse(model, targets, times=held["time"].values).data
    assert np.abs(found["position"].sel(node="P").values[:, :2] - tip[:, :2]).max() < 1e-12
    start = compile(model).drive_start
    q, qd, qdd = (found[f"drive_{name}"].values for name in ("position", "velocity", "acceleration"))
    for k in range(len(q)):
        for name, exact in zip(
            ("position", "velocity", "acceleration"), arm.state(q[k] - start, qd[k], qdd[k])[:3], strict=True
        ):
            mine = found[name].sel(node="P").values[k]
            assert np.abs(mine - exact[2]).max() < 1e-9 * max(1.0, np.abs(exact).max())


def test_transfer_functions_and_jacobian_by_hinges():
    arm, model, _, _, _, _ = arm_path()
    found = kt.kinematics.transfer_functions(model, ("base", "elbow"))
    q = np.zeros(2)
    _, _, _, D = arm.state(q, q, q)
    assert np.abs(found["first"].sel(node=["S1", "S2", "P"]).values - D.transpose(1, 2, 0)).max() < 1e-13
    second = found["second"].sel(node=["S1", "S2", "P"]).values
    for i in range(2):
        for j in range(2):
            rate = (np.eye(2)[i] + np.eye(2)[j]) / 2
            less = (np.eye(2)[i] - np.eye(2)[j]) / 2
            # a at q'' = 0 is quadratic in q': its polar form
            exact = arm.state(q, rate, q)[2] - arm.state(q, less, q)[2]
            assert np.abs(second[..., i, j] - exact).max() < 1e-12
    jacobian = kt.kinematics.jacobian(model, of="P", wrt=["base", "elbow"])
    assert np.abs(np.asarray(jacobian.values).squeeze() - D[:, 2].T).max() < 1e-12


def faults_of(**fields):
    with pytest.raises(kt.ModelError) as caught:
        kt.Model(**fields)
    return str(caught.value)


SPACE = {"nodes": {"A": (0, 0, 0), "B": (0, 0, 1), "C": (1, 0, 0), "D": (0, 1, 0), "E": (0, 0, 3)}, "fixed": ["A", "B"],
         "bars": {"a": ("A", "C"), "b": ("B", "C"), "ae": ("A", "E")}}  # fmt: skip


@pytest.mark.parametrize(
    ("drive", "says"),
    [
        (kt.HingeDrive(axis=("A", "B"), start="C", end="E"), "'E' stands on the axis"),
        (kt.HingeDrive(axis=("A", "B"), start="C", end="X"), "no node called 'X'"),
        (kt.HingeDrive(axis=("A", "B"), start="C", end="C"), "names a node twice"),
        (kt.HingeDrive(axis="A", start="C", end="D"), "in space a hinge turns about two nodes"),
        (kt.AngleDrive("a"), "without an axis"),
        (kt.AngleDrive("ae", axis="z"), "points along the axis"),
        (kt.AngleDrive("zz", axis="z"), "no member called 'zz'"),
        (kt.AngleDrive("a", axis="z", reference=(0, 0, 2)), "reference: points along the axis"),
    ],
)
def test_faults_of_drives_in_space(drive, says):
    assert says in faults_of(**SPACE, drives={"d": drive})


def test_fault_of_a_hinge_between_fixed_nodes():
    said = faults_of(**(SPACE | {"fixed": list("ABCD")}), drives={"d": kt.HingeDrive(axis=("A", "B"), start="C", end="D")})
    assert "cannot change" in said


def test_drives_that_fight_are_named():
    model = kt.Model(
        **SPACE | {"fixed": ["A", "B", "D", "E"], "bars": {"a": ("A", "C"), "b": ("B", "C")}},
        drives={"one": kt.HingeDrive(axis=("A", "B"), start="D", end="C"), "two": kt.AngleDrive("a", axis="z")},
    )
    assert "1 state of self-stress" in str(kt.kinematics.mobility(model))
    with pytest.raises(kt.InputError, match="contradict each other"):
        kt.kinematics.follow(model, kt.ConstantRate(rates={"one": 1.0}, duration=1.0), samples=5)
