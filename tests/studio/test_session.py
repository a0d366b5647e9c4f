"""What a page of the studio talks to, without any network."""

from __future__ import annotations

import json

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import dynamics, kinematics
from kinetruss.studio import Session
from kinetruss.studio.files import Drafts, seen_now
from kinetruss.studio.session import SMALL
from samples import fourbar, tripod


def told(answer) -> dict:
    """The header of an answer."""
    if isinstance(answer, dict):
        return answer
    size = int.from_bytes(answer[:4], "little")
    return json.loads(answer[4 : 4 + size])


def ask(session: Session, **command) -> dict:
    return told(session.answer(json.dumps(command)))


def forces_at(model, values, case=None):
    """Positions and forces of a pose by the Python interface, reached from the model's own pose in one go."""
    x = kinematics.assemble(model, values)
    motion = kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])
    return x, dynamics.inverse(model, motion, case, static=False)


@pytest.mark.parametrize(
    ("model", "way"),
    [
        (tripod(), [{"LA": 1.1}, {"LB": 0.95, "LC": 1.2}, {"LA": 0.9}]),
        (fourbar(gravity=(0, -9.81)), [{"motor": 0.7}, {"motor": 4.0}]),
    ],
)
def test_forces_are_those_of_the_python_interface(model, way):
    session = Session(model)
    for values in way:
        assert ask(session, do="move", values=values)["state"]["stopped"] == ""
        found = ask(session, do="query")
        x, wanted = forces_at(model, found["values"])
        np.testing.assert_allclose(found["position"], x, rtol=0, atol=1e-12)
        for name in ("member_force", "reaction", "drive_force"):
            values_of = wanted.data[name].values[0]
            np.testing.assert_allclose(found[name], values_of, rtol=0, atol=1e-12 * np.abs(values_of).max())


def test_the_state_holds_positions_and_forces_as_float32():
    session = Session(tripod())
    answer = session.answer(json.dumps({"do": "move", "values": {"LA": 1.1}}))
    size = int.from_bytes(answer[:4], "little")
    body, at, found = answer[4 + size :], 0, {}
    for name, count in told(answer)["arrays"]:
        found[name] = np.frombuffer(body, "<f4", count, at)
        at += 4 * count
    assert at == len(body)
    exact = ask(session, do="query")
    np.testing.assert_array_equal(found["member_force"], np.float32(exact["member_force"]))
    np.testing.assert_array_equal(found["position"], np.float32(exact["position"]).ravel())


def lying_low():
    """Legs that may become too short to reach each other: flat is singular."""
    foot = {"LA": (0.5, 0, 0), "LB": (-0.25, 0.4330127, 0), "LC": (-0.25, -0.4330127, 0)}
    nodes = dict(zip("ABC", foot.values(), strict=True)) | {"T": kt.Node(at=(0, 0, 0.9), mass=20.0)}
    bars = {name: kt.Bar(ends=(end, "T"), kind="driven") for name, end in zip(foot, "ABC", strict=True)}
    return kt.Model(nodes=nodes, fixed=("A", "B", "C"), bars=bars, gravity=(0, 0, -9.81))


def test_a_slider_stops_before_a_singular_pose_and_says_why():
    session = Session(lying_low())
    state = ask(session, do="move", values=dict.fromkeys(("LA", "LB", "LC"), 0.45))["state"]
    assert "singular" in state["stopped"]
    assert "t =" not in state["stopped"]
    found = ask(session, do="query")
    lengths = [np.linalg.norm(np.subtract(found["position"][k], found["position"][3])) for k in range(3)]
    assert lengths == pytest.approx(list(found["values"].values()), abs=1e-12)
    assert 0.5 < found["values"]["LA"] < 0.52  # flat at 0.5
    assert 1e-3 <= found["gauge"] < 0.3
    assert found["position"][3][2] > 0  # the same side
    again = ask(session, do="move", values={}, fine=True)["state"]
    assert (again["stopped"], again["values"]) == (state["stopped"], state["values"])
    back = ask(session, do="move", values=dict.fromkeys(("LA", "LB", "LC"), 1.0))["state"]
    assert back["stopped"] == ""


def test_a_way_that_cannot_be_closed_is_followed_as_far_as_it_goes():
    session = Session(fourbar(nodes={"A": (0, 0), "B": (0.2, 0), "C": (0.3, 0.25), "D": (0.40, 0)}))
    state = ask(session, do="move", values={"motor": 3.1})["state"]
    assert state["stopped"]
    assert 0.1 < state["values"]["motor"] < 3.1
    model = session.model
    for name, bar in model.bars.items():
        a, b = (session.pose.position[list(model.nodes).index(end)] for end in bar.ends)
        own = np.linalg.norm(np.subtract(model.nodes[bar.ends[0]].at, model.nodes[bar.ends[1]].at))
        assert np.linalg.norm(a - b) == pytest.approx(own, abs=1e-12), name


def test_limits_of_a_drive_hold():
    state = ask(Session(tripod()), do="move", values={"LA": 9.0})["state"]
    assert state["values"]["LA"] == 1.3
    assert "limit" in state["note"]


def test_gravity_payload_and_loads_are_edited():
    session = Session(tripod())
    ask(session, do="gravity", value=[0, 9.81, 0])
    ask(session, do="mass", node="T", mass=35.0)
    ask(session, do="load", name="pull", node="T", force=[0, 0, -50.0])
    setup = ask(session, do="load", name="push", node="T", force=[0, 0, 0])["setup"]
    assert [load["name"] for load in setup["loads"]] == ["pull"]
    wanted = tripod(gravity=(0, 9.81, 0), loads={"pull": kt.NodalForce(node="T", force=(0, 0, -50.0))}, load_cases={}, runs={})
    wanted = wanted.with_(nodes={**wanted.nodes, "T": kt.Node(at=(0, 0, 0.9), mass=35.0)})
    _, forces = forces_at(wanted, {})
    np.testing.assert_allclose(ask(session, do="query")["member_force"], forces.data["member_force"].values[0], atol=1e-9)


def test_a_load_case_is_chosen():
    session = Session(tripod())
    assert ask(session, do="case", name="standing")["setup"]["case"] == "standing"
    _, forces = forces_at(session.model, {}, "standing")
    np.testing.assert_allclose(ask(session, do="query")["member_force"], forces.data["member_force"].values[0], atol=1e-10)
    assert "No load case" in ask(session, do="case", name="nope")["message"]


@pytest.mark.slow
def test_members_are_switched_and_come_back():
    session = Session(tripod())
    ask(session, do="move", values={"LB": 1.1})
    before = ask(session, do="query")["member_force"]
    setup = ask(session, do="switch", member="LB", to="elastic")["setup"]
    assert [one["role"] for one in setup["members"]] == ["driven", "elastic", "driven"]
    assert setup["lost"] == ["runs.lift"]
    found = ask(session, do="query")
    rest = kt.statics.equilibrium(session.model, found["position"], lengths=found["values"])
    np.testing.assert_allclose(found["position"], rest.data["position"].values, atol=1e-9)
    ask(session, do="switch", member="LB", to="cut")
    assert ask(session, do="query")["members"] == ["LA", "LC"]
    found = ask(session, do="query")["position"][3]
    assert found[2] < 0  # it hangs from two legs
    ask(session, do="reset")
    ask(session, do="move", values={"LB": 1.1})
    assert ask(session, do="query")["member_force"] == pytest.approx(before, abs=1e-9)


def test_a_change_that_cannot_stand_changes_nothing():
    session = Session(fourbar(section=None, material=None))
    before = session.model
    assert "elastic" in ask(session, do="switch", member="coupler", to="elastic")["message"]
    assert session.model is before
    assert ask(session, do="move", values={"motor": 1.0})["kind"] == "state"


def test_edits_of_every_page_work_on_a_live_model_and_are_undone():
    session = Session(tripod())
    ask(session, do="move", values={"LA": 1.1})
    forces = ask(session, do="query")["member_force"]
    assert ask(session, do="mass", node="T", mass=35.0)["setup"]["undo"] == "the change of the mass of T"
    for command in (
        {"do": "set", "path": ["nodes", "T", "mass"], "value": "20 kg"},
        {"do": "add", "at": [0, 0, 2], "bar_from": "T"},
        {"do": "delete", "nodes": ["D"]},
    ):
        found = ask(session, **command)
        assert found["kind"] in ("scene", "error"), found
    while ask(session, do="undo")["kind"] == "scene":
        pass
    assert session.model == tripod()
    assert ask(session, do="redo")["setup"]["masses"]["T"] == 35.0
    assert ask(session, do="reset")["setup"]["undo"]
    ask(session, do="move", values={"LA": 1.1})
    assert ask(session, do="query")["member_force"] == pytest.approx(forces, abs=1e-9)


def test_a_live_model_has_what_was_removed_again_after_undo_and_its_lost_entries_after_redo():
    session = Session(tripod())
    assert ask(session, do="switch", member="LB", to="rigid")["setup"]["lost"] == ["runs.lift"]
    assert ask(session, do="undo")["setup"]["lost"] == []
    assert "lift" in session.model.runs
    assert ask(session, do="redo")["setup"]["lost"] == ["runs.lift"]
    assert ask(session, do="switch", member="LB", to="own")["setup"]["lost"] == []
    assert session.model == tripod()


def test_a_member_is_switched_by_the_names_of_its_nodes_after_nodes_came_and_went():
    session = Session(tripod())
    assert ask(session, do="delete", members=["LB"], nodes=["B"])["kind"] == "scene"
    found = ask(session, do="switch", member="LB", to="elastic")
    assert (found["kind"], "'B', which is not in the model any more" in found["message"]) == ("error", True)
    before = ask(session, do="query")
    length = np.linalg.norm(np.subtract(*(before["position"][before["nodes"].index(end)] for end in ("C", "T"))))
    assert ask(session, do="switch", member="LC", to="rigid")["kind"] == "scene"
    assert session.model.bars["LC"].length == pytest.approx(length, abs=1e-12)


def test_no_message_reads_a_file_outside_the_folder(tmp_path):
    (tmp_path / "in").mkdir()
    (tmp_path / "push.csv").write_text("t [s],x [N],y [N],z [N]\n0,1,2,3\n1,3,4,5\n")
    path = kt.write(tripod(), tmp_path / "in" / "a.yaml")
    session = Session(kt.read(path), path, tmp_path / "in", text=path.read_text())
    for file in ("../push.csv", str(tmp_path / "push.csv")):
        wind = {"node": "T", "file": file}
        assert ask(session, do="set", path=["loads", "wind"], value=wind)["kind"] == "error"
        text = path.read_text() + f"support_motion: {{A: {{file: '{file}'}}}}\n"
        assert "not in the folder" in ask(session, do="text", text=text)["faults"][0]["text"]
    assert session.model == tripod()


def test_a_save_of_a_live_model_is_a_version_and_is_done_where_none_can_be_kept(tmp_path):
    path = kt.write(tripod(), tmp_path / "a.yaml")
    drafts = Drafts(tmp_path, "a")
    session = Session(kt.read(path), path, tmp_path, text=path.read_text(), drafts=drafts)
    ask(session, do="mass", node="T", mass=35.0)
    assert ask(session, do="save", name="b.yaml")["message"] == "Written: b.yaml."
    assert [row["words"] for row in ask(session, do="versions")["rows"]] == ["saved as b.yaml"]
    assert drafts.version(1) == (tmp_path / "b.yaml").read_text()
    other = tmp_path / "other"
    other.mkdir()
    (other / ".kinetruss").write_text("a file in the way")
    session = Session(kt.read(path), None, other, text=path.read_text(), drafts=Drafts(other, "a"))
    assert "no version was kept" in ask(session, do="save", name="b.yaml")["message"]
    assert kt.read(other / "b.yaml") == tripod()


def test_the_drawing_refuses_what_only_a_pose_has():
    session = Session(tripod(), draw=True)
    for command in (
        {"do": "move", "values": {"LA": 1.1}},
        {"do": "query"},
        {"do": "case", "name": None},
        {"do": "frames", "frames": []},
        {"do": "switch", "member": "LA", "to": "cut"},
    ):
        found = ask(session, **command)
        assert (found["kind"], found["message"].endswith("Use the page with sliders.")) == ("error", True)


def test_key_frames_become_a_run_with_its_worst_instants():
    session = Session(tripod())
    frames = [{"time": t, "values": {"LA": value}} for t, value in ((0, 1.0), (1, 1.2), (2.5, 1.1), (3, 1.0))]
    found = ask(session, do="run", frames=frames, samples=51)
    assert found["kind"] == "run"
    model = session.model.with_(
        runs={"all": kt.Run(trajectory=kt.Spline(times=(0, 1, 2.5, 3), values={"LA": (1.0, 1.2, 1.1, 1.0)}), samples=51)}
    )
    wanted = kt.run(model, "all").verdict.table()[0]
    worst = next(row for row in found["worst"] if row["what"] == wanted.rule and row["member"] == wanted.member)
    assert worst["used"] == pytest.approx(wanted.utilisation, rel=1e-9)
    assert worst["time"] == pytest.approx(wanted.time)
    assert "at least two" in ask(session, do="run", frames=frames[:1])["message"]
    assert ask(session, do="show")["kind"] == "scene"


def test_what_is_saved_is_what_is_shown(tmp_path):
    session = Session(tripod(), tmp_path / "a.yaml", tmp_path)
    ask(session, do="move", values={"LA": 1.1, "LB": 0.95})
    ask(session, do="mass", node="T", mass=12.0)
    frames = [{"time": 0, "values": {"LA": 1.1}}, {"time": 2, "values": {"LA": 1.2}}]
    assert ask(session, do="save", name="b.yaml", pose=True, frames=frames)["kind"] == "saved"
    model = kt.read(tmp_path / "b.yaml")
    again = Session(model)
    assert again.pose.values == session.pose.values
    np.testing.assert_allclose(again.pose.position, session.pose.position, atol=1e-12)
    np.testing.assert_allclose(ask(again, do="query")["member_force"], ask(session, do="query")["member_force"], atol=1e-9)
    assert kt.run(model, "studio").status.ok


@pytest.mark.parametrize(
    "name", ["../b.yaml", "/tmp/b.yaml", "a/b.yaml", ".b.yaml", "b.txt", "b.yaml\x00", "..", "link.yaml", "a\\b.yaml"]
)
def test_nothing_is_written_elsewhere(tmp_path, name):
    folder = tmp_path / "in"
    folder.mkdir()
    (folder / "link.yaml").symlink_to(tmp_path / "out.yaml")
    session = Session(tripod(), None, folder)
    assert ask(session, do="save", name=name)["kind"] == "error"
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["in", "link.yaml"]


@pytest.mark.parametrize("name", ["CON.yaml", "nul.yml", "Com1.json", "lpt9.yaml", "aux.b.yaml", "PRN .yaml", "COM\u00b2.yaml"])
def test_names_of_devices_are_refused(tmp_path, name):
    found = ask(Session(tripod(), None, tmp_path), do="save", name=name, replace=True)
    assert (found["kind"], "device on Windows" in found["message"]) == ("error", True)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["icon.yaml", "CON1.yaml", "auxiliary.yaml", "com.yaml", "lpt10.yaml"])
def test_names_that_only_look_like_devices_are_taken(tmp_path, name):
    assert ask(Session(tripod(), None, tmp_path), do="save", name=name)["kind"] == "saved"


def test_another_file_is_replaced_only_when_that_is_confirmed(tmp_path):
    (tmp_path / "thesis.yaml").write_text("years of work")
    session = Session(tripod(), kt.write(tripod(), tmp_path / "a.yaml"), tmp_path)
    found = ask(session, do="save", name="thesis.yaml")
    assert found["kind"] == "exists"
    assert "thesis.yaml exists already, and is not the file that was opened. Overwrite it, or" in found["message"]
    assert (tmp_path / "thesis.yaml").read_text() == "years of work"
    assert ask(session, do="save", name="thesis.yaml", replace=True)["kind"] == "saved"
    assert kt.read(tmp_path / "thesis.yaml") == kt.read(tmp_path / "a.yaml")
    # its own files: the one opened, and those it wrote
    for name in ("thesis.yaml", "a.yaml", "a.yaml"):
        assert ask(session, do="save", name=name)["kind"] == "saved"
    assert ask(Session(tripod(), tmp_path / "a.yaml", tmp_path), do="save", name="thesis.yaml")["kind"] == "exists"


@pytest.mark.slow
def test_a_file_that_something_else_changed_is_not_replaced_in_silence(tmp_path):
    path = kt.write(tripod(), tmp_path / "a.yaml")
    seen = seen_now(path)  # as the studio does before it reads the file
    path.write_text(path.read_text() + "# a note made in an editor\n")
    for session in (Session(tripod(), path, tmp_path, seen), Session(tripod(), path, tmp_path, seen)):
        found = ask(session, do="save", name="a.yaml")
        assert (found["kind"], "was changed by another program since" in found["message"]) == ("exists", True)
    assert "a note made in an editor" in path.read_text()
    assert ask(session, do="save", name="a.yaml", replace=True)["kind"] == "saved"
    other = Session(tripod(), path, tmp_path)
    ask(other, do="mass", node="T", mass=3.0)
    assert ask(other, do="save", name="a.yaml")["kind"] == "saved"
    assert ask(session, do="save", name="a.yaml")["kind"] == "exists"  # two pages


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "words"),
    [
        ({"do": "mass", "node": "T", "mass": 1e15}, "1e+15 kg at T"),
        ({"do": "gravity", "value": [0, 0, -1e15]}, "1e+15 m/s^2"),
        ({"do": "load", "name": "push", "node": "T", "force": [1e15, 0, 0]}, "1e+15 N on T"),
        ({"do": "mass", "node": "T", "mass": 1e5}, ""),
        ({"do": "gravity", "value": [0, 0, -24.79]}, ""),
    ],
)
def test_values_that_are_hardly_meant_are_asked_about(command, words):
    note = ask(Session(tripod()), **command)["state"]["note"]
    assert (words in note and "Is it meant so?" in note) if words else "meant so" not in note


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    ["", "{", "[]", "null", "{}", '{"do": "rm"}', '{"do": "move"}', '{"do": "move", "values": {"LA": NaN}}', b"\xff\xfe",
     '{"do": "move", "values": {"LA": 1e400}}', '{"do": "move", "values": {"nope": 1}}',
     '{"do": "move", "values": {"LA": "x"}}',
     '{"do": "gravity", "value": [1]}', '{"do": "gravity", "value": [1, 2]}', '{"do": "mass", "node": "T", "mass": -1}',
     '{"do": "switch", "member": "nope", "to": "cut"}', '{"do": "show", "more": 1}', "[" * 100_000, "x" * (SMALL + 1)],
)  # fmt: skip
def test_what_is_not_understood_is_refused_in_a_sentence(text):
    session = Session(tripod())
    found = session.answer(text)
    assert found["kind"] == "error"
    assert found["message"].endswith((".", "?")) or "\n" in found["message"]
    assert ask(session, do="query")["values"]["LA"] == pytest.approx(1.029563, abs=1e-6)
