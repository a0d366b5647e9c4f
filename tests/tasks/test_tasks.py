"""Tasks of structures: what is asked for is what the motion does, measured by other means than the task's own program."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.interpolate import make_interp_spline

import kinetruss as kt

TOP = ("B3.N7", "B3.N9", "B3.N8")
BASE = ("B1.N1", "B1.N2", "B1.N3")
MAST = kt.library.vgt.double_octahedral(bays=3)
SMALL = st.floats(-0.04, 0.04)
SEEDS = st.integers(0, 50)


def bent(seed: int, spread: float = 0.06, model: kt.Model = MAST) -> kt.Model:
    """The model drawn with other lengths of its drives."""
    rng = np.random.default_rng(seed)
    ends = {name: model.members[name].ends for name in model.all_drives}
    lengths = {name: float(np.linalg.norm(np.subtract(model.nodes[b].at, model.nodes[a].at))) for name, (a, b) in ends.items()}
    x = kt.kinematics.assemble(model, {name: one + rng.uniform(-spread, spread) for name, one in lengths.items()})
    nodes = zip(model.nodes.items(), x.tolist(), strict=True)
    return model.with_(nodes={name: node.with_(at=tuple(at)) for (name, node), at in nodes})


def end(model: kt.Model, task, samples: int = 21):
    """The motion of a task, and the positions that its drive lengths give by themselves."""
    motion = kt.kinematics.inverse(model, task, samples=samples)
    assert motion.status.ok, motion.message
    lengths = dict(zip(model.all_drives, motion.drive_position.values[-1].tolist(), strict=True))
    there = kt.kinematics.assemble(model, lengths)
    assert np.abs(there - motion.position.values[-1]).max() < 1e-9
    return motion


@pytest.mark.slow
@settings(max_examples=15)
@given(SEEDS, st.tuples(SMALL, SMALL))
def test_gimbal(seed, change):
    model = bent(seed)
    now = kt.kinematics.platform(model, _still(model), TOP, base=BASE)
    wanted = [float(now[name].values[0]) + 3 * one for name, one in zip(("beta", "gamma"), change, strict=True)]
    motion = end(model, kt.Gimbal(platform=TOP, base=BASE, moves={"beta": wanted[0], "gamma": wanted[1]}))
    found = kt.kinematics.platform(model, motion, TOP, base=BASE)
    assert [found.beta.values[-1], found.gamma.values[-1]] == pytest.approx(wanted, abs=1e-10)


@pytest.mark.slow
@settings(max_examples=15)
@given(SEEDS, st.tuples(SMALL, SMALL, SMALL))
def test_positioning_of_a_tool_point(seed, change):
    model = bent(seed)
    tool = np.mean([model.nodes[name].at for name in TOP], axis=0) + np.array([0.1, -0.2, 0.5])
    task = kt.Positioning(nodes=TOP, point=tuple(tool), moves=dict(zip("xyz", (tool + change).tolist(), strict=True)))
    found = kt.kinematics.pose(model, end(model, task), TOP, frame=kt.Frame(origin=tuple(tool)))
    assert found.position.values[-1] == pytest.approx(tool + change, abs=1e-10)


@pytest.mark.slow
@settings(max_examples=10)
@given(SEEDS, st.tuples(*[st.floats(-0.01, 0.01)] * 6))
def test_docking_of_a_frame(seed, change):
    model = bent(seed)
    tool = kt.Frame(origin=(0.1, 0.2, 3.9), axes=((0, 1, 0), (-1, 0, 0), (0, 0, 1)))
    before = kt.kinematics.pose(model, _still(model), TOP, frame=tool)
    start = [*before.position.values[0], *before.euler.values[0][::-1]]
    names = ("x", "y", "z", "roll", "pitch", "yaw")
    wanted = [float(a + b) for a, b in zip(start, change, strict=True)]
    found = kt.kinematics.reach(
        model, kt.Docking(platform=TOP, frame=tool), {name: [one] for name, one in zip(names, wanted, strict=True)}
    )
    if not bool(found.reached[0]):
        assert "nearest pose" in str(found.message.values[0])
        return
    at = dict(zip(model.all_drives, found.drive_position.values[0].tolist(), strict=True))
    x = kt.kinematics.assemble(model, at)
    moved = kt.kinematics.pose(
        model, kt.kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None]), TOP, frame=tool
    )
    assert [*moved.position.values[0], *moved.euler.values[0][::-1]] == pytest.approx(wanted, abs=1e-9)


@pytest.mark.slow
@settings(max_examples=10)
@given(SEEDS, st.tuples(SMALL, SMALL, SMALL))
def test_reflecting_throws_the_light_from_source_to_target(seed, change):
    model, source, target = bent(seed), np.array([1.0, 2.0, 12.0]), np.array([-3.0, 1.0, 11.0])
    place = np.add(np.mean([model.nodes[name].at for name in TOP], axis=0), change)
    task = kt.Reflecting(
        platform=TOP, source=tuple(source), target=tuple(target), moves=dict(zip("xyz", place.tolist(), strict=True))
    )
    found = kt.kinematics.platform(model, end(model, task), TOP)
    centre, normal = found.centroid.values[-1], found.normal.values[-1]
    assert centre == pytest.approx(place, abs=1e-10)
    ray = (centre - source) / np.linalg.norm(centre - source)
    mirrored = ray - 2 * (ray @ normal) * normal
    assert np.cross(mirrored, target - centre) == pytest.approx(np.zeros(3), abs=1e-9)
    assert mirrored @ (target - centre) > 0


@pytest.mark.slow
@settings(max_examples=10)
@given(SEEDS, st.tuples(SMALL, SMALL, SMALL))
def test_pointing_at_a_place_that_moves(seed, change):
    model, at = bent(seed), np.array([0.5, -0.4, 12.0]) + 20 * np.array(change)
    task = kt.Pointing(platform=TOP, at=(0.5, -0.4, 12.0), moves=dict(zip("xyz", at.tolist(), strict=True)))
    found = kt.kinematics.platform(model, end(model, task), TOP)
    away = at - found.centroid.values[-1]
    assert found.normal.values[-1] == pytest.approx(away / np.linalg.norm(away), abs=1e-10)


@pytest.mark.slow
@settings(max_examples=8)
@given(st.integers(0, 30), st.floats(-0.02, 0.02))
def test_coordinates_of_every_kind(seed, change):
    model = bent(seed)
    still = _still(model)
    b2 = kt.kinematics.platform(model, still, ("B2.N7", "B2.N9", "B2.N8"), base=("B1.N7", "B1.N9", "B1.N8"))
    moves = {
        "B3.N8.x": model.nodes["B3.N8"].at[0] + change,
        "B2.beta": float(b2.beta.values[0]) + change,
        "B2.height": float(b2.height.values[0]) - abs(change),
        "B1.M9": float(still.length.sel(member="B1.M9").values[0]) + change,
    }
    motion = end(model, kt.Coordinates(moves=moves))
    after = kt.kinematics.platform(model, motion, ("B2.N7", "B2.N9", "B2.N8"), base=("B1.N7", "B1.N9", "B1.N8"))
    assert motion.position.sel(node="B3.N8", axis="x").values[-1] == pytest.approx(moves["B3.N8.x"], abs=1e-10)
    assert after.beta.values[-1] == pytest.approx(moves["B2.beta"], abs=1e-10)
    assert after.height.values[-1] == pytest.approx(moves["B2.height"], abs=1e-10)
    assert motion.length.sel(member="B1.M9").values[-1] == pytest.approx(moves["B1.M9"], abs=1e-10)


def test_angle_of_a_follower_gives_the_length_by_the_law_of_cosines():
    model = kt.library.vgt.triangular(base_length=1.0, tube_length=1.0)
    start = float(np.arctan2(*(np.subtract(model.nodes["B"].at, model.nodes["O1"].at)[::-1])))
    motion = kt.kinematics.inverse(model, kt.Quintic(moves={"follower.angle": (start, 2.3)}, duration=1.0), samples=31)
    t = motion.time.values
    s = t**3 * (10 - 15 * t + 6 * t**2)
    angle = start + (2.3 - start) * s
    exact = np.sqrt(2.0**2 + 2.0**2 - 2 * 2.0 * 2.0 * np.cos(np.pi - angle))
    assert motion.drive_position.values[:, 0] == pytest.approx(exact, abs=1e-11)


def test_hinge_angle_is_a_coordinate_of_the_general_mechanism():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1.8, 0.6)}, fixed=["A"],
        bars={"ab": ("A", "B"), "bc": ("B", "C")},
        drives={"shoulder": kt.AngleDrive("ab"), "elbow": kt.HingeDrive(axis="B", start="A", end="C")},
    )  # fmt: skip
    motion = kt.kinematics.inverse(model, kt.Positioning(node="C", moves={"x": 1.2, "y": 1.1}, duration=2.0), samples=201)
    assert motion.position.sel(node="C").values[-1] == pytest.approx([1.2, 1.1], abs=1e-10)
    assert _rates_fit(motion) < 1e-6


def _still(model: kt.Model):
    x = np.array([node.at for node in model.nodes.values()], float)
    zero = np.zeros((2, *x.shape))
    return kt.kinematics.from_arrays(model, [0.0, 1.0], np.stack([x, x]), zero, zero)


def _rates_fit(motion) -> float:
    """Largest difference of rates and accelerations from those of a spline of degree 7 through the drives."""
    t, q = motion.time.values, motion.drive_position.values
    curve, inner = make_interp_spline(t, q, k=7), slice(20, -20)
    found = [np.abs(curve(t, 1) - motion.drive_velocity.values)[inner].max() / np.abs(motion.drive_velocity.values).max()]
    found.append(
        np.abs(curve(t, 2) - motion.drive_acceleration.values)[inner].max() / np.abs(motion.drive_acceleration.values).max()
    )
    return max(found)


@pytest.mark.slow
@pytest.mark.parametrize("law", ["quintic", "spline"])
def test_rates_and_accelerations_are_those_of_the_drives(law):
    model = bent(4)
    moves = {"x": [float(np.mean([model.nodes[n].at[0] for n in TOP])) + one for one in (0.0, 0.05, 0.02, 0.1)]}
    motion = kt.kinematics.inverse(model, kt.Positioning(nodes=TOP, moves=moves, law=law, duration=3.0), samples=1801)
    t, q = motion.time.values, motion.drive_position.values
    # within one leg, as the third derivative jumps where a quintic leg ends
    leg = slice(0, 600)
    curve = make_interp_spline(t[leg], q[leg], k=7)
    for order, found in ((1, motion.drive_velocity.values), (2, motion.drive_acceleration.values)):
        near = np.abs(curve(t[leg], order) - found[leg])[30:-30].max()
        assert near < 1e-5 * np.abs(found).max()


def test_functions_of_time_and_circles_are_followed_exactly():
    model = bent(2)
    centre = np.mean([model.nodes[name].at for name in TOP], axis=0)
    wave = kt.Positioning(nodes=TOP, moves={"x": lambda t: centre[0] + 0.03 * np.sin(2 * t)}, duration=3.0)
    motion = kt.kinematics.inverse(model, wave, samples=61)
    t, top = motion.time.values, motion.data.sel(node=list(TOP), axis="x").mean("node")
    assert top.position.values == pytest.approx(centre[0] + 0.03 * np.sin(2 * t), abs=1e-10)
    assert top.velocity.values == pytest.approx(0.06 * np.cos(2 * t), abs=1e-9)
    assert top.acceleration.values == pytest.approx(-0.12 * np.sin(2 * t), abs=1e-7)
    ring = kt.Circle(centre=tuple(centre - (0.05, 0, 0)), turns=2, rise=0.02)
    motion = kt.kinematics.inverse(model, kt.Positioning(nodes=TOP, path=ring, duration=3.0), samples=61)
    top = motion.data.sel(node=list(TOP)).mean("node").position.values
    assert np.linalg.norm(top[:, :2] - (centre - (0.05, 0, 0))[:2], axis=1) == pytest.approx(np.full(61, 0.05), abs=1e-10)
    assert top[-1] == pytest.approx(np.add(centre, (0, 0, 0.02)), abs=1e-10)


def test_straight_masts_cannot_yaw():
    for bays in (2, 3):
        model = kt.library.vgt.double_octahedral(bays=bays)
        top = [f"B{bays}.N{k}" for k in (7, 9, 8)]
        with pytest.raises(kt.InputError, match=r"cannot yaw \(turn about z\).*rank 5"):
            kt.kinematics.inverse(model, kt.Docking(platform=top, moves={"yaw": "2 deg"}))
        motion = kt.kinematics.inverse(
            model, kt.Docking(platform=top, moves={"z": 0.99 * bays * 1.1218}, free=["yaw"]), samples=5
        )
        assert motion.status.ok


@pytest.mark.slow
def test_gimbal_of_three_bays_exact_even_and_by_equal_division():
    moves = {"beta": "30 deg", "gamma": "30 deg"}
    ends = {}
    for division in ("exact", "even", "equal"):
        motion = kt.kinematics.inverse(MAST, kt.Gimbal(platform=TOP, base=BASE, moves=moves, division=division), samples=5)
        found = kt.kinematics.platform(MAST, motion, TOP, base=BASE).isel(time=-1)
        bay = kt.kinematics.platform(MAST, motion, ("B2.N7", "B2.N9", "B2.N8"), base=("B1.N7", "B1.N9", "B1.N8")).isel(time=-1)
        ends[division] = np.degrees([float(one) for one in (found.beta, found.gamma, bay.beta, bay.gamma)])
    assert ends["exact"][:2] == pytest.approx([30, 30], abs=1e-9)
    assert ends["even"] == pytest.approx([30, 30, 9.13704276, 10.39046384], abs=6e-9)
    assert ends["equal"] == pytest.approx([32.5737, 28.6650, 10, 10], abs=6e-5)
    assert "reaches beta 32.5737 deg (wanted 30, off by 2.57), gamma 28.665 deg (wanted 30, off by -1.34)" in motion.message


def _gradients(model: kt.Model, x: np.ndarray, of: list[str]) -> np.ndarray:
    return kt.kinematics.jacobian(model, x, of=of).values


@pytest.mark.parametrize("weights", [{}, {"B1.M7": 50.0, "B3.M9": 0.1}])
def test_least_change_is_least(weights):
    model = bent(7)
    task = kt.Positioning(node="B3.N8", moves={"x": model.nodes["B3.N8"].at[0] + 0.1}, weights=weights)
    motion = end(model, task)
    A = _gradients(model, motion.position.values[-1], ["B3.N8"])
    change = motion.drive_position.values[-1] - motion.drive_position.values[0]
    pull = change * [weights.get(name, 1.0) for name in model.all_drives]
    # w (q - r) lies in the row space of A: no motion along the task's surface lessens the sum
    left = pull - A.T @ np.linalg.lstsq(A.T, pull, rcond=None)[0]
    assert np.abs(left).max() < 1e-10 * np.abs(pull).max()


def test_strokes_are_kept_and_what_holds_a_drive_there_is_needed():
    free = bent(3)
    task = kt.Positioning(node="B3.N8", moves={"x": free.nodes["B3.N8"].at[0] + 0.2})
    wide = end(free, task).drive_position.values
    d = int(np.argmax(wide[-1] - wide[0]))
    name, high = list(free.all_drives)[d], float(0.5 * (wide[-1, d] + wide[0, d]))
    model = free.with_(active=free.active | {name: free.active[name].with_(limits=(1.0, high))})
    motion = end(model, task, samples=101)
    q = motion.drive_position.values
    assert q[:, d].max() <= high + 1e-9
    assert q[-1, d] == pytest.approx(high, abs=1e-12)
    assert f"ends of their strokes: {name} at" in motion.message
    # the others are the best for the task, and the one at its end would go on if it could
    A = _gradients(model, motion.position.values[-1], ["B3.N8"])
    others, change = np.arange(9) != d, q[-1] - q[0]
    s = np.linalg.lstsq(A[:, others].T, change[others], rcond=None)[0]
    assert np.abs(change[others] - A[:, others].T @ s).max() < 1e-9
    assert change[d] - A[:, d] @ s < 0


@pytest.mark.slow
def test_objectives_lower_what_they_say():
    model = kt.library.vgt.double_octahedral(bays=2, gravity=(0, 0, -9.81), tip_force=(300, 0, 0), limits=("1.0 m", "1.35 m"))
    top = ("B2.N7", "B2.N9", "B2.N8")
    found = {}
    for objective in ("least_change", "least_effort", "stroke_ends"):
        task = kt.Positioning(nodes=top, moves={"x": 0.1}, objective=objective)
        motion = end(model, task)
        forces = kt.dynamics.inverse(model, motion).static.drive_force.values[-1]
        q = motion.drive_position.values[-1]
        found[objective] = float((forces**2).sum()), float(((q - 1.175) ** 2).sum())
        assert motion.position.sel(node=list(top), axis="x").mean("node").values[-1] == pytest.approx(0.1, abs=1e-10)
    assert found["least_effort"][0] < 0.9 * found["least_change"][0]
    assert found["stroke_ends"][1] <= found["least_change"][1] + 1e-12


def test_held_drives_stand_still():
    motion = end(
        bent(5), kt.Positioning(node="B3.N8", moves={"x": bent(5).nodes["B3.N8"].at[0] + 0.05}, hold=["B1.M7", "B2.M9"])
    )
    assert np.ptp(motion.drive_position.sel(drive=["B1.M7", "B2.M9"]).values, axis=0) == pytest.approx([0, 0], abs=1e-14)


def test_several_tasks_at_once_with_timing_of_their_own():
    model = bent(6)
    place = np.mean([model.nodes[name].at for name in TOP], axis=0)
    first = kt.Positioning(nodes=TOP, moves={"x": place[0] + 0.05, "y": kt.Way(values=[place[1] - 0.03], start=0.5, end=1.0)},
                           free=["z"], duration=2.0)  # fmt: skip
    second = kt.Gimbal(platform=TOP, moves={"beta": "4 deg"}, law="trapezoid", duration=1.5)
    motion = kt.kinematics.inverse(model, kt.Combined(tasks=[first, second]), samples=41)
    at = motion.position.sel(node=list(TOP)).mean("node")
    assert at.sel(time=0.5, axis="y").values == pytest.approx(place[1], abs=1e-10)
    assert at.sel(time=1.0, axis="y").values == pytest.approx(place[1] - 0.03, abs=1e-10)
    assert at.sel(axis="x").values[-1] == pytest.approx(place[0] + 0.05, abs=1e-10)
    beta = kt.kinematics.platform(model, motion, TOP).beta.sel(time=1.5, method="nearest").values
    assert np.degrees(beta) == pytest.approx(4, abs=1e-8)


@pytest.mark.slow
def test_out_of_reach_reports_the_nearest_pose():
    task = kt.Positioning(nodes=TOP, moves={"z": 9.0})
    limited = kt.library.vgt.double_octahedral(bays=3, limits=("1.0 m", "1.35 m"))
    with pytest.raises(
        kt.AnalysisError, match=r"out of reach.*nearest pose found .best of 16 starts, .*has z .* \(wanted 9\).*strokes"
    ) as caught:
        kt.kinematics.inverse(limited, task)
    assert 0 < len(caught.value.result.time) < 201
    found = kt.kinematics.reach(limited, task)
    assert not found.reached.values[0]
    assert found.position.sel(node=list(TOP), axis="z").mean("node").values[0] > 3.6
    # nothing nearer: the miss has no part along what the drives can still do
    q = found.drive_position.values[0]
    assert ((q > 1.0 - 1e-9) & (q < 1.35 + 1e-9)).all()


@pytest.mark.slow
def test_random_poses_of_a_ten_bay_chain_are_reached_from_where_it_stands_straight():
    model = kt.library.vgt.double_octahedral(bays=10, limits=("42 in", "50 in"))
    top, rng = tuple(f"B10.N{k}" for k in (7, 9, 8)), np.random.default_rng(8)
    lengths = rng.uniform(1.0668, 1.27, (8, 30))
    wanted = {name: [] for name in ("x", "y", "z", "roll", "pitch", "yaw")}
    for row in lengths:
        x = kt.kinematics.assemble(model, dict(zip(model.all_drives, row.tolist(), strict=True)))
        pose = kt.kinematics.pose(model, kt.kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None]), top)
        for name, value in zip(wanted, [*pose.position.values[0], *pose.euler.values[0][::-1]], strict=True):
            wanted[name].append(float(value))
    found = kt.kinematics.reach(model, kt.Docking(platform=top), wanted)
    assert found.reached.values.all()
    q = found.drive_position.values
    assert q.min() > 1.0668 - 1e-9
    assert q.max() < 1.27 + 1e-9


@pytest.mark.parametrize(
    ("task", "words"),
    [
        (lambda: kt.Positioning(node="XX"), "no node called"),
        (lambda: kt.Positioning(node="B3.N8", hold=["no"]), "no drive called"),
        (lambda: kt.Gimbal(platform=("B3.N7", "B3.N9")), "3 at least"),
        (lambda: kt.Gimbal(platform=BASE), "fixed"),
        (lambda: kt.Coordinates(moves={"B1.N1.x": 1.0}), "is fixed"),
        (lambda: kt.Combined(tasks=[kt.Positioning(nodes=TOP), kt.Positioning(nodes=TOP)]), "as task 1 does"),
        (lambda: kt.Positioning(node="B3.N8", hold=list(MAST.all_drives)), "holds all drives"),
        (lambda: kt.Positioning(node="B3.N8", moves={"w": 1.0}), "coordinates of this task are x, y, z"),
        (lambda: kt.Positioning(node="B3.N8", moves={"x": 1.0}, free=["x"]), "is free and moves"),
        (lambda: kt.Positioning(node="B3.N8", nodes=TOP), "one point"),
        (lambda: kt.Way(values=[1, 2], times=[0, 0]), "must increase"),
        (lambda: kt.Pointing(platform=TOP, at=(0, 0, 9), moves={"beta": 0.1}), "points at a place"),
        (lambda: kt.Positioning(node="B1.N1", moves={"x": 1.0}), "'B1.N1' is fixed in x and cannot move there"),
        (lambda: kt.Positioning(node="B1.N1", free=["x", "z"]), r"is fixed in y.*Give free: \[y\]"),
        (lambda: kt.Gimbal(platform=TOP, moves={"beta": "5 cm"}), "is given as a length, but 'beta' is an angle"),
        (lambda: kt.Positioning(nodes=TOP, moves={"x": ["1 m", "3 deg"]}), "is given as an angle, but 'x' is a length"),
        (lambda: kt.Coordinates(moves={"B1.M7": kt.Way(values=["3 deg"])}), "is given as an angle, but 'B1.M7' is a length"),
        (lambda: kt.Gimbal(platform=TOP, moves={"beta": kt.Way(values=[0, 0.1], end=3)}), "ends at 3 s, but the task at 1 s"),
        (lambda: kt.Gimbal(platform=TOP, moves={"beta": kt.Way(values=[0, 0.1], times=[0, 4])}), "Give duration: 4"),
    ],
)
def test_faults_are_told_before_any_work(task, words):
    with pytest.raises(kt.ModelError, match=words):
        kt.kinematics.inverse(MAST, task())


def test_functions_of_time_that_fail_are_named_with_the_instant():
    task = kt.Gimbal(platform=TOP, moves={"beta": lambda t: 0.1 / (t - 0.0)})
    with pytest.raises(kt.InputError, match="course of 'beta' fails at t = 0 s: ZeroDivisionError"):
        kt.kinematics.inverse(MAST, task)


def test_equal_division_needs_the_poses_of_all_bays():
    cells = kt.library.cells
    mast = cells.stack(
        [cells.double_octahedron(base=1.2, top=1.1, longeron=0.9), cells.double_octahedron(base=1.1, longeron=0.9)]
    )
    task = kt.Gimbal(platform=("B2.N7", "B2.N9", "B2.N8"), moves={"beta": 0.1}, division="equal")
    with pytest.raises(kt.InputError, match="'B1.M7' belongs to none"):
        kt.kinematics.inverse(mast, task)


def test_a_path_through_a_hole_of_the_reach_says_that_its_end_is_within_reach():
    """An arm of 1 m and 0.7 m does not reach places nearer than 0.3 m to its root."""
    arm = kt.Model(
        nodes={"O": (0, 0), "E": (1, 0), "T": (1.0, 0.7)}, fixed=["O"],
        bars={"upper": kt.Bar(ends=("O", "E"), mass=0), "fore": kt.Bar(ends=("E", "T"), mass=0)},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.AngleDrive("fore")},
    )  # fmt: skip
    with pytest.raises(kt.AnalysisError, match="though its end is within reach. Go round by way points"):
        kt.kinematics.inverse(arm, kt.Positioning(node="T", moves={"x": -1.0, "y": -0.7}), samples=51)


def test_a_task_whose_bars_do_not_close_is_refused(tmp_path):
    """A crane with longerons a million times too long: its drawing and its lengths do not agree to any digit."""
    text = (Path(kt.library.__file__).parent / "examples" / "space_crane.yaml").read_text()
    file = tmp_path / "crane.yaml"
    file.write_text(text.replace("longeron: 1.8 m", "longeron: 1800000 m"))
    task = kt.Positioning(node="B5.N8", moves={"z": 4.8}, duration=60.0)
    with pytest.raises(kt.KinetrussError, match=r"cannot start \(t = 0 s\): the bars do not close"):
        kt.kinematics.inverse(kt.read(file), task, samples=11)
