"""Scenes hold what the results hold, in any form they are packed in."""

import json
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st
from hypothesis.extra.numpy import arrays

import kinetruss as kt
from kinetruss import runs, viewer
from kinetruss.errors import InputError
from kinetruss.results import Forces, Motion, Verdict
from kinetruss.runs import RunResult
from samples import fourbar


def again(scene: viewer.Scene) -> viewer.Scene:
    return viewer.unpack(viewer.pack(scene))


def test_a_run_comes_back_as_float32(lift):
    found = again(viewer.scene(lift, case="pushed"))
    forces, motion = lift.forces["pushed"].data, lift.motion.data
    for name in ("position", "velocity", "acceleration", "drive_position"):
        assert np.array_equal(found.arrays[name], motion[name].values.astype("f4")), name
    for name in ("member_force", "joint_force", "reaction", "drive_force", "energy"):
        assert np.array_equal(found.arrays[name], forces[name].values.astype("f4")), name
    assert np.array_equal(found.arrays["rest_force"], lift.forces["pushed"].static.data["member_force"].values.astype("f4"))
    assert np.array_equal(found.arrays["time"], motion["time"].values.astype("f4"))
    assert found.header["units"]["member_force"] == "N"
    assert found.header["nodes"] == list(lift.model.nodes)
    assert found.header["members"] == list(lift.model.members)
    assert found.header["load_case"] == "pushed"


def test_all_load_cases_are_kept_while_they_fit(lift):
    found = again(viewer.scene(lift))
    assert [one["load_case"] for one in found.header["cases"]] == ["standing", "pushed"]
    assert [one["loads"] for one in found.header["cases"]] == [[], [{"name": "push", "node": 3}]]
    for name in ("member_force", "joint_force", "drive_force"):
        for key, case in ((name, "standing"), (f"1:{name}", "pushed")):
            assert np.array_equal(found.arrays[key], lift.forces[case].data[name].values.astype("f4")), key
    assert "1:stress" in found.arrays
    assert [one["load_case"] for one in viewer.scene(lift, case="pushed").header["cases"]] == ["pushed"]


def test_strength_is_that_of_the_verdict(lift):
    """The largest over time and load cases of what colours the members is what the run found."""
    scenes = [viewer.scene(lift, case=case) for case in lift.forces]
    data = lift.verdict.data
    rules = list(data["rule"].values)
    for name, rule in (("stress", "yield"), ("buckling", "buckling")):
        largest = np.nanmax([one.arrays[name].max(axis=0) for one in scenes], axis=0)
        key = "value" if name == "stress" else "utilisation"
        for k, member in enumerate(lift.model.members):
            of = data["member"].values == member
            assert largest[k] == pytest.approx(np.nanmax(data[key].values[of, rules.index(rule)]), rel=1e-12)


def test_supports_loads_drives_and_kinds(lift, turn):
    header = viewer.scene(lift, case="pushed").header
    assert header["supports"] == [{"node": k, "axes": "xyz", "clamped": False} for k in range(3)]
    assert header["loads"] == [{"name": "push", "node": 3}]
    assert header["kinds"] == ["active"] * 3
    assert header["two_rods"] == [0, 1, 2]
    assert [drive["member"] for drive in header["drives"]] == [0, 1, 2]
    assert viewer.scene(lift, case="standing").header["loads"] == []
    flat = viewer.scene(turn).header
    assert flat["dim"] == 2
    assert flat["drives"] == [{"name": "motor", "kind": "angle", "unit": "rad", "member": 0}]
    assert [one["id"] for one in flat["channels"]] == ["force", "stress", "utilisation", "buckling", "speed"]


def test_a_model_stands_in_one_frame_with_what_can_move():
    free = fourbar(drives={}, runs={})
    found = again(viewer.scene(free))
    assert found.arrays["position"].shape == (1, 4, 2)
    (mode,) = found.header["modes"]
    shape = found.arrays[mode["array"]]
    ends = found.arrays["ends"]
    along = found.arrays["position"][0][ends[:, 1]] - found.arrays["position"][0][ends[:, 0]]
    stretch = ((shape[ends[:, 1]] - shape[ends[:, 0]]) * along).sum(axis=1)
    assert np.abs(stretch).max() < 1e-6
    assert np.abs(shape).max() > 0.1
    assert found.header["channels"] == []
    assert viewer.scene(fourbar()).header["modes"] == []


def test_modes_given_are_shown_after_its_own():
    shape = np.ones((4, 2))
    found = viewer.scene(fourbar(), modes=[viewer.Mode(name="first", shape=shape, frequency=2.5)])
    assert found.header["modes"] == [{"name": "first", "frequency": 2.5, "array": "mode_0"}]
    assert np.array_equal(found.arrays["mode_0"], shape)


def test_vibrations_come_with_their_frequencies():
    rod = kt.Bar(ends=("A", "B"), mass=1.0)
    hung = kt.Model(nodes={"A": (0, 0), "B": (0, -2.0)}, fixed=["A"], bars={"b": rod}, gravity=(0, -9.81))
    found = viewer.scene(kt.dynamics.linearise(hung), model=hung)
    (mode,) = found.header["modes"]
    assert mode["frequency"] == pytest.approx(np.sqrt(1.5 * 9.81 / 2) / (2 * np.pi))
    assert np.abs(found.arrays["mode_0"]) == pytest.approx(np.array([[0, 0], [1, 0]]), abs=1e-12)
    upward = hung.with_(gravity=(0, 9.81))
    (mode,) = viewer.scene(kt.dynamics.linearise(upward), model=upward).header["modes"]
    assert mode == {"name": "mode 1, runs away", "frequency": None, "array": "mode_0"}


def test_motion_and_forces_need_their_model(turn):
    motion = viewer.scene(turn.motion, model=turn.model)
    assert [one["id"] for one in motion.header["channels"]] == ["speed"]
    forces = viewer.scene(turn.forces["all"], model=turn.model)
    assert np.array_equal(forces.arrays["stress"], viewer.scene(turn).arrays["stress"])
    with pytest.raises(InputError, match="model="):
        viewer.scene(turn.motion)
    with pytest.raises(InputError, match="A dict cannot be drawn"):
        viewer.scene({})
    with pytest.raises(InputError, match="No load case called 'al'.*all"):
        viewer.scene(turn, case="al")


def test_long_runs_keep_equal_steps_and_the_worst_samples(turn):
    found = viewer.scene(turn, frames=10)
    time = turn.motion.data["time"].values
    worst = turn.verdict.data["time_of"].values
    assert {time[0], time[-1]} < set(found.arrays["time"])
    assert set(found.arrays["time"]) & set(worst[np.isfinite(worst)])
    assert found.header["samples"]["all"] == 41
    assert found.header["samples"]["shown"] == len(found.arrays["time"]) < 15
    with pytest.raises(InputError, match="at least 2"):
        viewer.scene(turn, frames=1)


def test_only_its_own_version_is_read(turn):
    scene = viewer.scene(turn.model)
    later = viewer.pack(replace(scene, header={**scene.header, "version": viewer.VERSION + 1}))
    with pytest.raises(InputError, match="not known here"):
        viewer.unpack(later)
    with pytest.raises(InputError, match="no kinetruss scene"):
        viewer.unpack(b"PK something else")


HEADER = {"format": viewer.FORMAT, "version": viewer.VERSION, "histories": ["position", "other"]}
CURVES = arrays(
    float,
    st.tuples(st.integers(1, 9), st.integers(0, 4)),
    elements=st.floats(-(2.0**100), 2.0**100, width=32, allow_subnormal=False),
)


@given(CURVES)
def test_any_history_comes_back(values):
    found = again(viewer.Scene(header={**HEADER, "rounded": False}, arrays={"position": values}))
    assert np.array_equal(found.arrays["position"], values.astype("f4"))


@given(CURVES)
def test_rounded_histories_miss_by_half_a_step_at_most(values):
    found = again(viewer.Scene(header={**HEADER, "rounded": True}, arrays={"position": values, "other": values}))
    for name, levels in (("position", 2**16), ("other", 2**12)):
        missed = np.abs(found.arrays[name] - values)
        if missed.size:
            # a step is a power of two at most twice what is wanted; float32 adds its own rounding
            # and what is below 2^-30 of the largest of all curves is round-off
            step = 2 * np.maximum(np.ptp(values, axis=0) / (levels - 2), np.abs(values).max() * 2.0**-30)
            assert (missed <= 0.5 * step + 1e-7 * np.abs(values).max(axis=0) + 1e-37).all()


def large_run(members: int = 5000, frames: int = 300) -> RunResult:
    """A row of triangles that swings, with forces that come and go in each bar at a pace of its own."""
    count = members // 2 + 2
    at = np.stack([np.arange(count) * 0.5, (np.arange(count) % 2) * 0.8, np.zeros(count)], axis=1)
    nodes = {f"N{k}": tuple(row) for k, row in enumerate(at.tolist())}
    bars = {f"M{k}": (f"N{k // 2}", f"N{k // 2 + 1 + k % 2}") for k in range(members)}
    tube, steel = kt.Tube(outer=0.02, inner=0.018), kt.library.materials.STEEL_S235
    model = kt.Model(nodes=nodes, bars=bars, fixed=("N0",), section=tube, material=steel)
    t = np.linspace(0, 3, frames)
    rng = np.random.default_rng(1)
    angle = 0.3 * np.sin(2 * t)
    turn = np.moveaxis(
        np.array([[np.cos(angle), 0 * t, np.sin(angle)], [0 * t, 1 + 0 * t, 0 * t], [-np.sin(angle), 0 * t, np.cos(angle)]]),
        2,
        0,
    )
    x = at @ turn
    v, a = np.gradient(x, t, axis=0), np.gradient(np.gradient(x, t, axis=0), t, axis=0)
    pace, phase, size = rng.uniform(1, 12, members), rng.uniform(0, 6, members), rng.lognormal(5, 1, members)
    force = size * np.sin(np.outer(t, pace) + phase)
    names = {"node": list(nodes), "axis": ["x", "y", "z"], "member": list(bars), "time": t}
    place = ("time", "node", "axis")
    moved = xr.Dataset({"position": (place, x), "velocity": (place, v), "acceleration": (place, a)}, coords=names)
    data = {"member_force": (("time", "member"), force), "reaction": (("time", "support", "axis"), np.zeros((frames, 1, 3)))}
    pulled = xr.Dataset(data, coords={**names, "support": ["N0"]}, attrs={"gravity": [0.0, 0.0, -9.81]})
    rules = {"rule": ["yield", "buckling", "beam-column"], "part": list(bars), "member": ("part", list(bars))}
    worst = np.abs(force).max(axis=0)[:, None] * [1e3, 1e-4, 2e-4]
    judged = dict.fromkeys(("value", "utilisation"), (("part", "rule"), worst))
    judged["time_of"] = (("part", "rule"), np.full((members, 3), 1.5))
    motion = Motion(data=moved)
    verdict = Verdict(data=xr.Dataset(judged, coords=rules))
    forces = {"all": Forces(data=pulled, motion=motion)}
    return RunResult(model=model, name="swing", motion=motion, forces=forces, verdict=verdict, samples=frames)


@pytest.mark.slow
def test_sizes(tmp_path):
    """21 bars stay below 1 MB; 5,000 bars by 300 frames below 5 MB (how fast it is written: bench/viewer.py)."""
    model = kt.library.vgt.double_octahedral(bays=1)
    moves = {"bay.beta": (0.0, 0.1)}
    small = model.with_(runs={"lean": kt.Run(trajectory=kt.Quintic(moves=moves, duration=1.0), samples=300)})
    assert viewer.write(runs.run(small, "lean"), tmp_path / "small.html").stat().st_size < 1e6
    large = large_run()
    assert viewer.write(large, tmp_path / "large.html").stat().st_size < 5e6
    header = viewer.scene(large).header
    assert header["rounded"]
    assert header["over_run"] == ["stress", "utilisation", "buckling"]


def test_the_page_holds_no_address_and_no_markup_of_names(tmp_path, turn):
    """Names of a model cannot become part of the page; nothing is to be loaded from anywhere."""
    evil = "</script><img/src=x>"
    model = fourbar(title=evil)
    text = viewer.page(viewer.scene(model))
    assert evil not in text
    assert "<title>&lt;/script&gt;" in text
    assert "http" not in text.split("<body>")[1].replace("http://www.w3.org", "")
    assert "default-src 'none'" in text
    assert "Permission is hereby granted" in text
    with pytest.raises(InputError, match="one, or two"):
        viewer.page([])


def test_the_header_is_plain_json(lift):
    header = viewer.scene(lift).header
    assert json.loads(json.dumps(header, allow_nan=False)) == header


def test_a_place_that_cannot_be_written_is_told(tmp_path, turn):
    (tmp_path / "file").write_text("")
    with pytest.raises(kt.errors.StoreError, match="cannot be written"):
        viewer.write(turn.model, tmp_path / "file" / "view.html")


def test_bodies_are_faces():
    corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1), "M": (0.2, 0.2, 0.2)}
    solid = kt.Model(nodes=corners, bodies={"b": kt.Body(nodes=tuple(corners), mass=2.0)})
    faces = viewer.scene(solid).header["solids"]
    assert sorted(map(sorted, faces)) == [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]  # M is inside
    square = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    plate = viewer.scene(kt.Model(nodes=square, bodies={"b": kt.Body(nodes=tuple(square), mass=1.0)}))
    x = plate.arrays["position"][0][np.array(plate.header["solids"])]
    sides = x[:, 1:] - x[:, :1]
    assert np.abs(np.linalg.det(sides)).sum() / 2 == pytest.approx(1.0)  # the faces are the square, once
    link = kt.Body(nodes=("A", "C"), mass=3.0, center=(1.0, 0.5), inertia=0.1)
    header = viewer.scene(kt.Model(nodes={"A": (0, 0), "C": (1, 1)}, bodies={"b": link})).header
    (body,) = header["bodies"]
    assert body["center"] == pytest.approx([1.5 / np.sqrt(2), -0.5 / np.sqrt(2)])
    assert (header["solids"], body["mass"]) == ([], 3.0)
