"""The least of an objective on the surface of tasks: against closed forms, other methods, and along motions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize, minimize_scalar

import kinetruss as kt
from kinetruss.kinematics.objectives import bounded_least
from kinetruss.library import cells

BAYS = 10
TOP, BASE = (f"B{BAYS}.N7", f"B{BAYS}.N9", f"B{BAYS}.N8"), ("B1.N1", "B1.N2", "B1.N3")


@pytest.mark.parametrize("seed", range(6))
def test_quadratic_functions_within_bounds_against_another_method(seed):
    rng = np.random.default_rng(seed)
    n, m = 9, (0, 2, 4)[seed % 3]
    root, g, A = rng.normal(size=(n, n)), 3 * rng.normal(size=n), rng.normal(size=(m, n))
    B = root @ root.T + 0.1 * np.eye(n)
    low, high = -rng.uniform(0.0, 0.5, n), rng.uniform(0.0, 0.5, n)
    low[0], high[1] = 0.0, 0.0
    p = bounded_least(B, g, A, low, high)
    rows = [{"type": "eq", "fun": lambda u: A @ u, "jac": lambda u: A}] if m else []
    other = minimize(
        lambda u: 0.5 * u @ B @ u + g @ u, np.zeros(n), jac=lambda u: B @ u + g, bounds=np.stack([low, high], axis=1),
        constraints=rows, method="SLSQP", options={"ftol": 1e-15, "maxiter": 300},
    )  # fmt: skip
    assert np.all((low <= p) & (p <= high))
    assert np.abs(A @ p).max(initial=0.0) < 1e-12
    assert p == pytest.approx(other.x, abs=1e-6)


def arm(angles, lengths):
    """A chain of links in the plane, each turned by an angle of its own."""
    places = np.vstack([np.zeros(2), np.cumsum(np.stack([np.cos(angles), np.sin(angles)], axis=1) * np.c_[lengths], axis=0)])
    count = len(lengths)
    return kt.Model(
        nodes={f"P{k}": tuple(at) for k, at in enumerate(places)}, fixed=["P0"],
        bars={f"link{k}": kt.Bar(ends=(f"P{k}", f"P{k + 1}"), mass=0) for k in range(count)},
        drives={f"turn{k}": kt.AngleDrive(f"link{k}") for k in range(count)},
    )  # fmt: skip


def test_an_arm_at_a_height_is_farthest_from_singular_as_one_variable_says():
    """Tip height a sin p + b sin q given: the derivatives are a cos p and b cos q, and their root sum of squares is largest."""
    a, b, height = 1.0, 0.7, 0.9

    def short(p):
        q = np.arcsin((height - a * np.sin(p)) / b)
        return -np.hypot(a * np.cos(p), b * np.cos(q))

    exact = minimize_scalar(short, bounds=(0.25, 1.3), method="bounded", options={"xatol": 1e-12}).x
    task = kt.Positioning(node="P2", moves={"y": height}, free=["x"], objective="conditioning")
    found = kt.kinematics.reach(arm(np.radians([40.0, 20.0]), [a, b]), task)
    assert found.drive_position.sel(drive="turn0").item() == pytest.approx(exact, abs=1e-6)


def test_a_planar_arm_has_the_manipulability_of_a_fine_grid():
    """Three links, tip held: one freedom is left, the angle of the last link."""
    lengths, start = np.array([1.0, 0.8, 0.5]), np.radians([70.0, 20.0, -30.0])
    tip = (lengths * [np.cos(start), np.sin(start)]).sum(axis=1)

    def area(last):
        wrist = tip - lengths[2] * np.array([np.cos(last), np.sin(last)])
        r = np.hypot(*wrist)
        between = np.arccos((lengths[0] ** 2 + r**2 - lengths[1] ** 2) / (2 * lengths[0] * r))
        first = np.arctan2(wrist[1], wrist[0]) + between
        second = np.arctan2(*(wrist - lengths[0] * np.array([np.cos(first), np.sin(first)]))[::-1])
        J = lengths * np.array(
            [[-np.sin(first), -np.sin(second), -np.sin(last)], [np.cos(first), np.cos(second), np.cos(last)]]
        )
        return -np.sqrt(np.linalg.det(J @ J.T))

    exact = minimize_scalar(area, bounds=start[2] + np.array([-1.4, 1.4]), method="bounded", options={"xatol": 1e-12}).x
    task = kt.Positioning(node="P3", moves={}, objective="conditioning")
    found = kt.kinematics.reach(arm(start, lengths), task)
    assert found.drive_position.sel(drive="turn2").item() == pytest.approx(exact, abs=1e-6)


@pytest.mark.slow
def test_ten_bays_stay_within_their_strokes_all_the_way_though_most_drives_end_there():
    mast = kt.library.vgt.double_octahedral(bays=BAYS, limits=(0.9, 1.4))
    task = kt.Gimbal(
        platform=TOP, base=BASE, moves={"beta": "40 deg", "gamma": "20 deg"}, duration=3.0, objective="conditioning"
    )
    motion = kt.kinematics.inverse(mast, task, samples=51)
    q = motion.drive_position.values
    assert motion.status.ok
    assert q.min() >= 0.9 - 1e-9
    assert q.max() <= 1.4 + 1e-9
    assert np.count_nonzero(np.abs(q[-1] - 1.4) < 1e-6) >= 10
    end = kt.kinematics.platform(mast, motion, TOP, base=BASE).isel(time=-1)
    assert np.degrees([end.beta, end.gamma]) == pytest.approx([40, 20], abs=1e-8)


@pytest.mark.slow
def test_beyond_a_fold_of_the_least_change_the_drives_next_to_those_before_go_on():
    """The least change ends in a fold although the task can be done there; the path of the platform is as asked."""
    arm6 = cells.stack(
        [cells.double_octahedron(base=1.2 * 0.95**k, top=1.2 * 0.95 ** (k + 1), longeron=0.9 * 0.95**k) for k in range(6)]
    )
    rng = np.random.default_rng(3)
    lengths = {name: length * (1 + 0.05 * rng.uniform(-1, 1)) for name, length in drawn(arm6).items()}
    x = kt.kinematics.assemble(arm6, lengths)
    bent = arm6.with_(
        nodes={name: node.with_(at=tuple(at)) for (name, node), at in zip(arm6.nodes.items(), x.tolist(), strict=True)},
        active={name: one.with_(length=None) for name, one in arm6.active.items()},
    )
    top = ("B6.N7", "B6.N9", "B6.N8")
    place = np.mean([bent.nodes[name].at for name in top], axis=0)
    moves = {"x": place[0] + 0.15, "roll": "5 deg", "pitch": "-8 deg", "yaw": "6 deg"}
    task = kt.Docking(platform=top, moves=moves, duration=2.0)
    motion = kt.kinematics.inverse(bent, task, samples=401)
    assert motion.status.ok
    assert "end in a fold after t = 1.48 s" in motion.message
    q, t = motion.drive_position.values, motion.time.values
    rate = (q[2:] - q[:-2]) / (t[2:] - t[:-2])[:, None]
    assert rate == pytest.approx(motion.drive_velocity.values[1:-1], abs=2e-4)
    s = t / 2.0
    wanted = place[0] + 0.15 * s**3 * (10 + s * (6 * s - 15))
    assert motion.position.sel(node=list(top), axis="x").mean("node").values == pytest.approx(wanted, abs=1e-10)


def drawn(model):
    """Lengths of the drives as drawn."""
    ends = {name: model.members[name].ends for name in model.all_drives}
    return {name: float(np.linalg.norm(np.subtract(model.nodes[a].at, model.nodes[b].at))) for name, (a, b) in ends.items()}
