"""Drive motions for wanted node or platform motions; motions from elsewhere; single configurations."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt


def stewart() -> kt.Model:
    """Six driven legs; the platform is an octahedron's worth of rigid bars, so some are redundant once its nodes are given."""
    feet = {f"f{i}": (np.cos(a), np.sin(a), 0.0) for i, a in enumerate(np.deg2rad([-10, 10, 110, 130, 230, 250]))}
    tops = {f"p{i}": (0.6 * np.cos(a), 0.6 * np.sin(a), 0.9) for i, a in enumerate(np.deg2rad([-50, 50, 70, 170, 190, 290]))}
    apex = {"apex": (0.0, 0.0, 1.3)}
    ring = {f"r{i}": (f"p{i}", f"p{(i + 1) % 6}") for i in range(6)}
    spokes = {f"s{i}": (f"p{i}", "apex") for i in range(6)}
    brace = {"b0": ("p0", "p2"), "b1": ("p2", "p4"), "b2": ("p4", "p0")}
    legs = {f"leg{i}": {"ends": (f"f{i}", f"p{i}"), "kind": "driven"} for i in range(6)}
    return kt.Model(nodes=feet | tops | apex, fixed=list(feet), bars=ring | spokes | brace | legs)


PLATFORM = [f"p{i}" for i in range(6)]


def rotation(roll: float, pitch: float, yaw: float) -> np.ndarray:
    c, s = np.cos, np.sin
    Rx = np.array([[1, 0, 0], [0, c(roll), -s(roll)], [0, s(roll), c(roll)]])
    Ry = np.array([[c(pitch), 0, s(pitch)], [0, 1, 0], [-s(pitch), 0, c(pitch)]])
    Rz = np.array([[c(yaw), -s(yaw), 0], [s(yaw), c(yaw), 0], [0, 0, 1]])
    return Rz @ Ry @ Rx


def test_stewart_platform_counts() -> None:
    found = kt.kinematics.mobility(stewart())
    assert (found.degrees_of_freedom, found.drives, found.undriven, found.self_stress) == (6, 6, 0, 0)


@pytest.mark.slow
def test_stewart_legs_in_closed_form() -> None:
    model = stewart()
    moves = {"x": (0, 0.1), "y": (0, -0.05), "z": (0, 0.08), "roll": (0, 0.1), "pitch": (0, -0.15), "yaw": (0, 0.2)}
    motion = kt.kinematics.inverse(model, kt.Quintic(moves=moves, duration=2.0), platform=PLATFORM, samples=9)
    end = {name: move[1] for name, move in moves.items()}
    tops = np.array([model.nodes[name].at for name in PLATFORM])
    feet = np.array([model.nodes[f"f{i}"].at for i in range(6)])
    centre = tops.mean(axis=0)
    moved = (tops - centre) @ rotation(end["roll"], end["pitch"], end["yaw"]).T + centre + [end[a] for a in "xyz"]
    np.testing.assert_allclose(motion.drive_position.values[-1], np.linalg.norm(moved - feet, axis=1), rtol=1e-13)


@pytest.mark.slow
@settings(max_examples=6, deadline=None)
@given(st.lists(st.floats(-0.12, 0.12), min_size=6, max_size=6))
def test_forward_after_inverse(ends) -> None:
    """Driving the legs by what inverse asks for brings every node back to the wanted motion."""
    model = stewart()
    names = ("x", "y", "z", "roll", "pitch", "yaw")
    wanted = kt.kinematics.inverse(
        model,
        kt.Quintic(moves={n: (0.0, e) for n, e in zip(names, ends, strict=True)}, duration=1.0),
        platform=PLATFORM,
        samples=31,
    )
    legs = {name: tuple(wanted.drive_position.sel(drive=name).values) for name in wanted.drive.values}
    table = kt.Spline(times=tuple(wanted.time.values), values=legs)
    back = kt.kinematics.follow(model, table, samples=31)
    np.testing.assert_allclose(back.position.values, wanted.position.values, atol=1e-12)
    # between: the spline through 31 points differs from the quintic by its own error only
    np.testing.assert_allclose(back.velocity.values, wanted.velocity.values, atol=2e-4)


def test_node_target_in_the_plane() -> None:
    """A two-link arm: the elbow angle from the law of cosines."""
    arm = kt.Model(
        nodes={"O": (0, 0), "E": (1, 0), "H": (1, 1)}, fixed=["O"], bars={"upper": ("O", "E"), "fore": ("E", "H")},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.AngleDrive("fore")},
    )  # fmt: skip
    reach = kt.Quintic(moves={"H.x": (1.0, 0.5), "H.y": (1.0, 1.2)}, duration=1.0)
    motion = kt.kinematics.inverse(arm, reach, samples=21)
    bend = motion.drive_position.sel(drive="elbow") - motion.drive_position.sel(drive="shoulder")
    square = (motion.position.sel(node="H") ** 2).sum("axis")
    np.testing.assert_allclose(np.cos(bend), (square - 2) / 2, atol=1e-13)
    rate = np.gradient(motion.drive_position.sel(drive="elbow").values, motion.time.values, edge_order=2)
    np.testing.assert_allclose(motion.drive_velocity.sel(drive="elbow").values[5:-5], rate[5:-5], atol=0.02)


def test_targets_that_do_not_hold_the_mechanism() -> None:
    arm = kt.Model(nodes={"O": (0, 0), "E": (1, 0), "H": (1, 1)}, fixed=["O"], bars={"u": ("O", "E"), "f": ("E", "H")})
    with pytest.raises(kt.InputError, match="fix 1 of the 2 freedoms of the structure; 1 is left"):
        kt.kinematics.inverse(arm, kt.Quintic(moves={"H.x": (1, 0.9)}, duration=1))
    with pytest.raises(kt.InputError, match="O.x is fixed"):
        kt.kinematics.inverse(arm, kt.Quintic(moves={"O.x": (0, 0.9), "H.x": (1, 1), "H.y": (1, 1)}, duration=1))
    with pytest.raises(kt.InputError, match=r"no coordinate 'H.q'"):
        kt.kinematics.inverse(arm, kt.Quintic(moves={"H.q": (1, 0.9)}, duration=1))


def test_given_motion_reports_a_rigid_bar_that_stretches() -> None:
    model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    t = np.linspace(0, 1, 5)
    x = np.zeros((5, 2, 2))
    x[:, 1, 0] = 1 + 1e-3 * t
    zero = np.zeros_like(x)
    motion = kt.kinematics.from_arrays(model, t, x, zero, zero)
    assert motion.data.attrs["stretched"] == ["b"]
    assert "b by 0.001" in motion.message
    with pytest.raises(kt.InputError, match=r"expected \(times = 5, n_nodes = 2, dim = 2\)"):
        kt.kinematics.from_arrays(model, t, x[:, :1], zero, zero)
    x[2, 1, 1] = np.nan
    with pytest.raises(kt.InputError, match=r"\[2, 'B', \d\]: "):
        kt.kinematics.from_arrays(model, t, x, zero, zero)


def test_assemble_two_bars_and_refuse_what_cannot_close() -> None:
    two = kt.Model(nodes={"A": (0, 0), "B": (4, 0), "C": (2, 1)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")})
    for a, b in ((2.5, 2.5), (3.0, 2.0), (5.0, 4.2)):
        x, y = kt.kinematics.assemble(two, {"a": a, "b": b})[2]
        assert x == pytest.approx((a**2 - b**2 + 16) / 8, abs=1e-12)
        assert y == pytest.approx(np.sqrt(a**2 - x**2), abs=1e-12)
    with pytest.raises(kt.AnalysisError, match="cannot be closed") as caught:
        kt.kinematics.assemble(two, {"a": 1.0, "b": 1.0})
    assert np.isfinite(caught.value.result).all()
    with pytest.raises(kt.InputError, match="greater than 0"):
        kt.kinematics.assemble(two, {"a": -1.0})
    with pytest.raises(kt.InputError, match="No prescribed length called 'q'"):
        kt.kinematics.assemble(two, {"q": 1.0})
