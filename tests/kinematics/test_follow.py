"""Motions: closed forms, invariance, supports, and paths that end."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt

MOTOR = kt.ConstantRate(rates={"motor": 10.0}, duration=0.6)


def fourbar(**changes) -> kt.Model:
    fields = {
        "nodes": {"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)},
        "fixed": ("A", "D"),
        "bars": {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        "drives": {"motor": kt.AngleDrive("crank")},
    }
    return kt.Model(**fields | changes)


def circles(B: np.ndarray, D: np.ndarray, r: float, s: float) -> np.ndarray:
    """The upper intersection of two circles."""
    d = D - B
    size = np.hypot(*d)
    along = (r**2 - s**2 + size**2) / (2 * size)
    return B + along * d / size + np.sqrt(r**2 - along**2) * np.array([-d[1], d[0]]) / size


@pytest.mark.slow
def test_four_bar_positions_in_closed_form() -> None:
    model = fourbar()
    motion = kt.kinematics.follow(model, MOTOR, samples=97)
    theta = np.pi / 2 + 10.0 * motion.time.values
    r, s = np.hypot(0.30, 0.15), np.hypot(0.10, 0.25)
    D = np.array([0.4, 0.0])
    for i, angle in enumerate(theta):
        B = 0.1 * np.array([np.cos(angle), np.sin(angle)])
        np.testing.assert_allclose(motion.position.sel(node="B").values[i], B, atol=1e-15)
        np.testing.assert_allclose(motion.position.sel(node="C").values[i], circles(B, D, r, s), atol=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("spacing", [1, 7, 48])
def test_sample_spacing_does_not_change_the_result(spacing: int) -> None:
    fine = kt.kinematics.follow(fourbar(), MOTOR, samples=97)
    coarse = kt.kinematics.follow(fourbar(), MOTOR, times=fine.time.values[::spacing])
    for name in ("position", "velocity", "acceleration"):
        scale = np.abs(fine.data[name].values).max()
        np.testing.assert_allclose(coarse.data[name].values, fine.data[name].values[::spacing], atol=1e-12 * scale)


def test_rates_are_derivatives_with_measured_order() -> None:
    """Central differences of order 4 of positions and velocities meet the exact rates at order 4."""
    model, t0 = fourbar(), 0.21
    errors = []
    for h in (4e-3, 2e-3):
        motion = kt.kinematics.follow(model, MOTOR, times=[0.0, *(t0 + h * np.array([-2, -1, 0, 1, 2]))])
        stencil = np.array([1, -8, 0, 8, -1]) / (12 * h)
        pairs = (("position", "velocity"), ("velocity", "acceleration"))
        errors.append([
            np.abs(np.einsum("t,tnc->nc", stencil, motion.data[a].values[1:]) - motion.data[b].values[3]).max()
            for a, b in pairs
        ])  # fmt: skip
    slopes = np.log2(np.array(errors[0]) / errors[1])
    np.testing.assert_allclose(slopes, 4.0, atol=0.2)


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(st.floats(-3, 3), st.floats(-2, 2), st.randoms())
def test_turned_and_shuffled_models_move_alike(angle: float, shift: float, random) -> None:
    """Rigid motion of the whole model and another order of nodes and bars give the same motion."""
    plain = kt.kinematics.follow(fourbar(), MOTOR, samples=9)
    R = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    nodes = [(name, tuple(R @ node.at + shift)) for name, node in fourbar().nodes.items()]
    bars = list(fourbar().bars.items())
    random.shuffle(nodes)
    random.shuffle(bars)
    turned = kt.kinematics.follow(fourbar(nodes=dict(nodes), bars=dict(bars)), MOTOR, samples=9)
    same = turned.data.sel(node=plain.node.values)
    np.testing.assert_allclose(same.position.values, plain.position.values @ R.T + shift, atol=1e-13)
    np.testing.assert_allclose(same.acceleration.values, plain.acceleration.values @ R.T, atol=1e-10)


def test_angle_drive_turns_through_many_turns() -> None:
    motion = kt.kinematics.follow(fourbar(), kt.ConstantRate(rates={"motor": -20.0}, duration=2.0), samples=801)
    assert motion.drive_position.values[-1, 0] == pytest.approx(np.pi / 2 - 40)
    assert np.ptp(motion.length.values, axis=0).max() < 1e-13


def test_an_arm_that_turns_and_grows_has_the_accelerations_of_polar_coordinates() -> None:
    arm = kt.Model(
        nodes={"O": (0, 0), "P": (1, 0)}, fixed=["O"], bars={"r": {"ends": ("O", "P"), "kind": "driven"}},
        drives={"turn": kt.AngleDrive("r")},
    )  # fmt: skip
    motion = kt.kinematics.follow(arm, kt.Quintic(moves={"r": (1.0, 2.5), "turn": (0.0, 2.0)}, duration=1.5), samples=16)
    (r, angle), (rate, w), (second, alpha) = (
        motion.data[f"drive_{name}"].sel(drive=["r", "turn"]).values.T for name in ("position", "velocity", "acceleration")
    )
    out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    left = np.stack([-out[:, 1], out[:, 0]], axis=1)
    wanted = (second - r * w**2)[:, None] * out + (r * alpha + 2 * rate * w)[:, None] * left
    np.testing.assert_allclose(motion.acceleration.sel(node="P").values, wanted, atol=1e-12)


def test_coordinate_drive_is_a_slider() -> None:
    """A ladder on a wall: y = sqrt(l^2 - x^2)."""
    ladder = kt.Model(
        nodes={"foot": (0.6, 0), "top": (0, 0.8)}, fixed={"foot": "y", "top": "x"}, bars={"ladder": ("foot", "top")},
        drives={"pull": kt.CoordinateDrive(node="foot", axis="x")},
    )  # fmt: skip
    motion = kt.kinematics.follow(ladder, kt.Quintic(moves={"pull": (0.6, 0.9)}, duration=1), samples=11)
    x, v = motion.drive_position.values[:, 0], motion.drive_velocity.values[:, 0]
    np.testing.assert_allclose(motion.position.sel(node="top", axis="y"), np.sqrt(1 - x**2), atol=1e-14)
    np.testing.assert_allclose(motion.velocity.sel(node="top", axis="y"), -x * v / np.sqrt(1 - x**2), atol=1e-13)


def test_moving_support_carries_the_whole_truss() -> None:
    t = np.linspace(0, 1, 21)
    shake = 0.01 * np.stack([np.sin(3 * t), t**3], axis=1)
    histories = {name: kt.History(times=t, displacements=shake) for name in "AD"}
    still = kt.Quintic(moves={"motor": (np.pi / 2, np.pi / 2)}, duration=1)
    motion = kt.kinematics.follow(fourbar(support_motion=histories), still, times=t)
    moved = motion.position.values - motion.position.values[0]
    np.testing.assert_allclose(moved, np.broadcast_to(shake[:, None], moved.shape), atol=1e-13)
    assert np.ptp(motion.acceleration.values, axis=1).max() < 1e-11


def test_path_into_a_singular_position_keeps_the_last_good_state() -> None:
    """Two bars pulled straight: the flat position is singular, beyond it nothing closes."""
    arch = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (1, 1)}, fixed=["A", "B"],
        bars={"a": {"ends": ("A", "C"), "kind": "driven"}, "b": ("B", "C")},
    )  # fmt: skip
    path = kt.ConstantRate(rates={"a": -1.0}, duration=1.2)
    with pytest.raises(
        kt.AnalysisError, match=r"Out of reach between t = 0.8.* the nearest .* is a 0.58\d+ m of 0.58\d+ m"
    ) as caught:
        kt.kinematics.follow(arch, path, samples=121)
    motion = caught.value.result
    assert motion.status is kt.Status.OUT_OF_REACH
    last = motion.time.values[-1]
    assert 0.8 < last < np.sqrt(2) - (2 - np.sqrt(2))
    assert motion.singularity.values[-1] < 0.3 * motion.singularity.values[0]
    assert kt.kinematics.follow(arch, path, samples=121, raise_on_failure=False).status is kt.Status.OUT_OF_REACH


def test_start_that_cannot_close() -> None:
    with pytest.raises(kt.AnalysisError, match="at the start of the path"):
        arch = kt.Model(
            nodes={"A": (0, 0), "B": (2, 0), "C": (1, 1)}, fixed=["A", "B"],
            bars={"a": {"ends": ("A", "C"), "kind": "driven"}, "b": ("B", "C")},
        )  # fmt: skip
        kt.kinematics.follow(arch, kt.Quintic(moves={"a": (0.3, 0.4)}, duration=1))


def test_too_few_drives_say_which_node_moves_where() -> None:
    with pytest.raises(kt.InputError, match=r"leave 1 freedom of the mechanism: B moves along x"):
        kt.kinematics.follow(fourbar(drives={}, bars={**fourbar().bars, "free": {"ends": ("A", "C"), "kind": "free"}}), idle())


def idle() -> kt.Spline:
    """A trajectory that names nothing of the model cannot exist; this one is refused later than the mechanism."""
    return kt.Quintic.model_construct(kind="quintic", moves={}, duration=1.0)


def test_drives_that_fight_are_refused() -> None:
    model = fourbar(bars={**fourbar().bars, "rocker": {"ends": ("C", "D"), "kind": "driven"},
                          "extra": {"ends": ("A", "C"), "kind": "driven"}})  # fmt: skip
    with pytest.raises(kt.InputError, match="drives contradict each other"):
        kt.kinematics.follow(model, MOTOR)


def test_agreeing_redundant_bars_are_followed() -> None:
    """A parallelogram with a third parallel crank has one bar too many that never disagrees."""
    cranks = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0), "a": (0, 1), "b": (1, 1), "c": (2, 1)}, fixed=["A", "B", "C"],
        bars={"1": ("A", "a"), "2": ("B", "b"), "3": ("C", "c"), "ab": ("a", "b"), "bc": ("b", "c")},
        drives={"motor": kt.AngleDrive("1")},
    )  # fmt: skip
    assert kt.kinematics.mobility(cranks).self_stress == 0
    both = cranks.with_(bars={**cranks.bars, "ac": ("a", "c")})
    assert kt.kinematics.mobility(both).self_stress == 1
    motion = kt.kinematics.follow(both, kt.Quintic(moves={"motor": (np.pi / 2, 2.2)}, duration=1), samples=21)
    np.testing.assert_allclose(
        motion.position.sel(node="c", axis="x"), 2 + np.cos(motion.drive_position.values[:, 0]), atol=1e-13
    )


def test_resuming_from_a_position_gives_the_same_motion() -> None:
    whole = kt.kinematics.follow(fourbar(), MOTOR, samples=41)
    rest = kt.kinematics.follow(fourbar(), MOTOR, times=whole.time.values[20:], start=whole.position.values[20])
    np.testing.assert_allclose(rest.position.values, whole.position.values[20:], atol=1e-14)


def test_rigid_lengths_that_differ_from_the_sketch_are_assembled() -> None:
    model = fourbar(bars={**fourbar().bars, "coupler": {"ends": ("B", "C"), "length": 0.34}})
    motion = kt.kinematics.follow(model, MOTOR, samples=5)
    np.testing.assert_allclose(motion.length.sel(member="coupler"), 0.34, rtol=1e-14)


def test_wrong_arguments() -> None:
    with pytest.raises(kt.ModelError, match="no drive or pose coordinate called 'moter'"):
        kt.kinematics.follow(fourbar(), kt.ConstantRate(rates={"moter": 1.0}, duration=1))
    with pytest.raises(kt.InputError, match=r"times\[2\]: 0.1 s is not after 0.2 s"):
        kt.kinematics.follow(fourbar(), MOTOR, times=[0, 0.2, 0.1])
    with pytest.raises(kt.InputError, match="No trajectory called 'turn'"):
        kt.kinematics.follow(fourbar(), "turn")


def test_singular_start_names_what_moves() -> None:
    """Two bars in line hold their middle node by count, not by rank."""
    flat = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0), "D": (1, 1), "E": (0, 1)}, fixed=["A", "C", "E"],
        bars={"l": ("A", "B"), "r": ("B", "C"), "d": ("E", "D"), "m": {"ends": ("C", "D"), "kind": "driven"}},
    )  # fmt: skip
    with pytest.raises(kt.InputError, match=r"B moves along y"):
        kt.kinematics.follow(flat, kt.Quintic(moves={"m": (np.sqrt(2), 1.5)}, duration=1))


@pytest.mark.slow
@pytest.mark.parametrize("samples", [9, 33, 101])
@pytest.mark.parametrize("turn", [-2.3, 3.0, 2 * np.pi])
def test_a_parallelogram_does_not_change_to_its_crossed_form_in_silence(turn, samples):
    """Where all four pins lie on one line two motions cross, and the crossed one has the same sign of the determinant."""
    x, y = 0.5 * np.cos(1.0), 0.5 * np.sin(1.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (x, y), "C": (1 + x, y), "D": (1, 0)}, fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("D", "C")}, drives={"motor": kt.AngleDrive("crank")},
    )  # fmt: skip
    law = kt.Quintic(moves={"motor": (1.0, 1.0 + turn)}, duration=1.0)
    motion = kt.kinematics.follow(model, law, samples=samples, raise_on_failure=False)
    assert motion.status in (kt.Status.SINGULAR, kt.Status.OUT_OF_REACH) and 1 < len(motion.position.time) < samples
    B, C = (motion.position.sel(node=name).values for name in "BC")
    np.testing.assert_allclose(C - B, np.tile((1.0, 0.0), (len(B), 1)), atol=1e-9)


def test_a_link_is_as_near_to_a_singular_position_as_a_bar_in_its_place():
    """A garage door on an arm, its top in a level track: the measure is that of the track, sqrt(1 - (1 + cos a)^2/4)."""
    door = kt.Model(
        nodes={"P": (0, 1.4), "B": (0, 0), "M": (0, 0.7), "T": (0, 2.1)}, fixed={"P": "xy", "T": "y"},
        bars={"arm": kt.Bar(ends=("P", "M"), mass=0)}, links={"door": kt.Link(nodes=("B", "M", "T"), mass=60)},
        drives={"lift": kt.AngleDrive("arm")}, gravity=(0, -9.81),
    )  # fmt: skip
    lift = kt.Quintic(moves={"lift": ("-80 deg", "0 deg")}, duration=1.0)
    motion = kt.kinematics.follow(door, lift, samples=5)
    a = motion.drive_position.values[:, 0] + np.pi / 2
    np.testing.assert_allclose(motion.singularity, np.sqrt(1 - (1 + np.cos(a)) ** 2 / 4), rtol=1e-10)
    np.testing.assert_allclose(kt.dynamics.inverse(door, motion).drive_force[-1], 60 * 9.81 * 0.525, rtol=1e-12)
    with pytest.raises(kt.errors.InputError, match=r"The drives leave 1 freedom of the mechanism: T moves along x"):
        kt.kinematics.follow(door, kt.Quintic(moves={"lift": ("-90 deg", "0 deg")}, duration=1.0), samples=5)
