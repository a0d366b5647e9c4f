"""Parts made from what is picked, forms of all records, typed values, runs from the drawing."""

from __future__ import annotations

import json
import time

import numpy as np
import pytest

import kinetruss as kt
from drawn import drawing
from kinetruss import kinematics, runs
from kinetruss.io import schema
from kinetruss.studio import Session
from kinetruss.studio.new_parts import forms


def ask(desk: Session, **command) -> dict:
    return json.loads(json.dumps(desk.answer(json.dumps(command)), allow_nan=False))


def done(desk: Session, **command) -> dict:
    found = ask(desk, **command)
    assert found["kind"] == "drawing", found
    return found


@pytest.fixture
def desk() -> Session:
    """A triangle on a pin and a roller."""
    found = drawing()
    for at in ([0, 0], [1, 0], [0.5, 0.75]):
        done(found, do="add", at=at)
    for ends in ("AC", "BC", "AB"):
        done(found, do="bar", ends=list(ends))
    done(found, do="set", path=["fixed"], value={"A": "xy", "B": "y"})
    return found


@pytest.mark.slow
def test_forms_have_every_table_record_and_field_of_the_schema():
    made = schema()
    found = forms()
    tables = {name for name, one in made["else"]["properties"].items() if isinstance(one.get("additionalProperties"), dict)}
    assert set(found["tables"]) == tables
    assert set(found["records"]) == set(made["$defs"])
    for name, record in found["records"].items():
        one = made["$defs"][name]
        one = one if "properties" in one else one["anyOf"][0]
        assert set(record["fields"]) | ({"kind"} if record["kind"] else set()) == set(one["properties"]), name
        assert all(set(spec["of"]) <= set(made["$defs"]) for spec in record["fields"].values() if spec["type"] == "record")
    run = found["records"]["Run"]["fields"]
    assert "statics.equilibrium" in run["analysis"]["of"]
    assert found["records"]["Spring"]["fields"]["stiffness"]["unit"] == "N/m, or N m/rad"
    assert found["records"]["Active"]["fields"]["motor"] == {
        "type": "record", "of": ["Motor"], "names": ["motors"], "needed": False}  # fmt: skip


@pytest.mark.slow
def test_a_bar_becomes_an_active_member_or_a_beam_and_a_bar_again(desk):
    bars = desk.drawing.state.data["bars"]
    found = done(desk, do="make", what="active", members=["b1"])
    assert found["made"] == {"entry": ["active", "b1"], "member": "b1"}
    assert "b1" not in found["data"]["bars"]
    record = kt.Model(**found["data"]).active["b1"]
    assert record.limits[0] < kt.Model(**found["data"]).nodes["C"].at[0] / 0.5 * 0.9013878 < record.limits[1]
    assert record.base.length < record.limits[0] < record.limits[1] < record.base.length + record.tube.length
    assert record.motor == "motor_lacy_slewing"
    done(desk, do="set", path=["active", "b1", "limits"], value="[80 cm, 1.1]", typed=True)
    assert desk.drawing.state.data["active"]["b1"]["limits"] == ["80 cm", 1.1]
    assert "limits" in ask(desk, do="set", path=["active", "b1", "limits"], value="[1.1, 0.8]", typed=True)["message"]
    found = done(desk, do="make", what="beam", members=["b1"])
    assert kt.Model(**found["data"]).beams["b1"].ends == ("A", "C")
    assert [one["kind"] for one in found["members"] if one["name"] == "b1"] == ["beam"]
    assert set(found["nodes"]) == {"A", "B", "C"}  # without those that the beam adds
    done(desk, do="undo")
    done(desk, do="undo")
    assert done(desk, do="undo")["data"]["bars"] == bars


@pytest.mark.slow
def test_bodies_springs_and_runs_are_made_from_what_is_picked(desk):
    found = done(desk, do="make", what="angle_spring", members=["b1", "b2"])
    assert found["data"]["springs"]["spring1"]["coordinate"] == {"kind": "hinge", "axis": ["C"], "start": "A", "end": "B"}
    assert "meet" in ask(desk, do="make", what="angle_spring", members=["b1", "b2", "b3"])["message"]
    assert "Pick the nodes" in ask(desk, do="make", what="body", nodes=["A"])["message"]
    found = done(desk, do="make", what="body", members=["b1", "b2"])
    assert found["data"]["bodies"] == {"body1": {"nodes": ["A", "C", "B"], "mass": "1 kg"}}
    done(desk, do="undo")
    done(desk, do="make", what="active", members=["b3"])
    found = done(desk, do="make", what="run")
    assert found["data"]["runs"]["run1"]["trajectory"]["moves"] == {"b3": [1.0, 1.1]}
    before = desk.drawing.state
    answer = ended(desk, ask(desk, do="run", name="run1"))
    assert answer["kind"] == "ran"
    assert answer["revision"] == desk.drawing.revision
    assert answer["words"].startswith("101 of 101 samples.")
    assert "kinetruss-scene" in desk.results.pages[answer["number"]]
    assert desk.drawing.state is before
    assert "No run called" in ask(desk, do="run", name="other")["message"]
    found = done(desk, do="set", path=["runs", "run1", "analysis"], value="kinematics.follow")
    assert len(found["data"]["runs"]["run1"]["trajectory"]["moves"]) == 1
    found = done(desk, do="set", path=["runs", "run1", "analysis"], value="statics.equilibrium")
    assert "trajectory" not in found["data"]["runs"]["run1"]
    done(desk, do="set", path=["runs", "run1"], value={"motion": "/etc/hosts"})
    assert "reads a file" in ask(desk, do="run", name="run1")["message"]


@pytest.mark.parametrize("lift", [0.0, 0.4, 1e-4])
def test_a_platform_in_space_becomes_a_body(lift):
    """Six nodes in a plane, or nearly; only the last one may be above it."""
    desk = drawing(dim=3)
    names = []
    for k in range(6):
        at = [np.cos(k * np.pi / 3), np.sin(k * np.pi / 3), 1.0 + lift * (k == 5)]
        names.append(done(desk, do="add", at=at)["made"]["node"])
    found = done(desk, do="make", what="body", nodes=names)
    model = kt.Model(**found["data"])
    assert len(model.bodies["body1"].carriers or ()) == (4 if lift > 0.1 else 3)
    middle = np.mean([model.nodes[name].at for name in model.bodies["body1"].carriers], axis=0)
    assert np.hypot(*middle[:2]) < 0.26  # the mass is near the middle, in it where the platform is regular
    assert lift or np.hypot(*middle[:2]) < 1e-12
    assert len(model.bodies["body1"].nodes) == (6 if lift > 0.1 else 7)
    assert kinematics.mobility(model).degrees_of_freedom == 6  # of the whole body: nothing moves within it


def ended(desk: Session, answer: dict) -> dict:
    """The end of a run, from the answer to its start."""
    while answer["kind"] == "running":
        assert 0 <= answer["done"] <= answer["total"]
        time.sleep(0.02)
        answer = ask(desk, do="running")
    return answer


@pytest.mark.slow
def test_a_run_tells_how_far_it_is_and_can_be_stopped(desk):
    done(desk, do="make", what="active", members=["b3"])
    done(desk, do="make", what="run")
    done(desk, do="set", path=["runs", "run1", "samples"], value="400000", typed=True)
    assert ask(desk, do="running") == {"kind": "stopped"}
    assert "No run" in ask(desk, do="stop")["message"]
    answer = ask(desk, do="run", name="run1")
    assert (answer["kind"], answer["total"]) == ("running", 400_000)
    assert "is being computed" in ask(desk, do="run", name="run1")["message"]
    place = done(desk, do="move", places={"C": [0.3, 0.4]})["places"][2]  # drawing goes on
    assert place == [0.3, 0.4]
    end = time.monotonic() + 60
    while not (answer := ask(desk, do="running"))["done"]:
        assert time.monotonic() < end
    assert answer["kind"] == "running"
    assert json.loads(json.dumps(desk.first()))["running"]["name"] == "run1"  # a page that comes later knows of it
    (work,) = [desk.results.work]
    assert ask(desk, do="stop")["done"] < 400_000
    assert ask(desk, do="running") == {"kind": "stopped"}
    work.thread.join(60)
    assert not work.thread.is_alive()
    assert not desk.results.pages
    done(desk, do="set", path=["runs", "run1", "samples"], value="11", typed=True)
    answer = ended(desk, ask(desk, do="run", name="run1"))
    assert answer["words"].startswith("11 of 11 samples.")
    done(desk, do="move", places={"C": [0.3, 0.5]})
    assert ask(desk, do="running")["revision"] < desk.drawing.revision  # the result is of an earlier drawing


@pytest.mark.slow
def test_a_mission_is_made_and_done_from_its_form(desk):
    done(desk, do="make", what="active", members=["b3"])
    done(desk, do="make", what="run")
    refused = ask(desk, do="set", path=["runs", "run1", "analysis"], value="mission")
    assert "motions of other runs" in refused["message"]
    done(desk, do="make", what="run")
    found = done(desk, do="set", path=["runs", "run2", "analysis"], value="mission")
    assert found["data"]["runs"]["run2"]["motions"] == ["run1"]
    found = done(desk, do="set", path=["conditions"], value={"light": {}, "laden": {"payloads": {"C": "50 kg"}}})
    done(desk, do="set", path=["runs", "run2", "conditions"], value=["light", "laden"])
    answer = ended(desk, ask(desk, do="run", name="run2"))
    assert answer["words"].startswith("2 of 2 pairs"), answer
    mission = runs.run(kt.Model(**desk.drawing.state.data), "run2")
    assert (mission.finding.state, mission.finding.kind) == ("over", "drive")  # the members alone were OK
    for words in (mission.finding.text, mission.finding.governs, *mission.finding.more):
        assert words in answer["words"].splitlines()
    assert "laden" in desk.results.pages[answer["number"]]


@pytest.mark.slow
@pytest.mark.parametrize("analysis", ["dynamics.simulate", "flexible.corrected", "kinematics.follow", "statics.at_poses"])
def test_a_run_gets_what_its_analysis_needs(desk, analysis):
    done(desk, do="make", what="active", members=["b3"])
    done(desk, do="make", what="run")
    found = done(desk, do="set", path=["runs", "run1", "analysis"], value=analysis)
    assert (found["data"]["runs"]["run1"]["analysis"], found["faults"]) == (analysis, [])
    assert done(desk, do="set", path=["runs", "run1", "analysis"], value="statics.equilibrium")["faults"] == []


def test_a_spring_of_an_angle_in_space_needs_an_axis():
    desk = drawing(dim=3)
    for at in ([0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 0, 1]):
        done(desk, do="add", at=at)
    for ends in ("AB", "BC"):
        done(desk, do="bar", ends=list(ends))
    assert "from B to it" in ask(desk, do="make", what="angle_spring", members=["b1", "b2"])["message"]
    found = done(desk, do="make", what="angle_spring", members=["b1", "b2"], nodes=["D"])
    assert found["data"]["springs"]["spring1"]["coordinate"]["axis"] == ["B", "D"]


@pytest.mark.slow
def test_a_clamp_goes_with_the_last_beam_of_its_node(desk):
    done(desk, do="make", what="beam", members=["b3"])
    done(desk, do="set", path=["clamped"], value=["A", "B"])
    assert "clamped" not in done(desk, do="make", what="bar", members=["b3"])["data"]
    done(desk, do="undo")
    done(desk, do="make", what="beam", members=["b1"])
    found = done(desk, do="delete", nodes=["B"])
    assert (found["data"]["clamped"], found["faults"]) == (["A"], [])
    assert "clamped" not in done(desk, do="delete", members=["b1"])["data"]


@pytest.mark.slow
@pytest.mark.parametrize(("dim", "hinged"), [(2, False), (3, False), (3, True)])
def test_a_clamp_has_the_moment_of_its_load(dim, hinged):
    pad, tip = [0.0] * (dim - 2), [-10.0 if k == dim - 1 else 0.0 for k in range(dim)]
    desk = drawing(dim=dim)
    for x in (1.0, 1.5):
        done(desk, do="add", at=[x, 2.0, *pad])
    done(desk, do="bar", ends=["A", "B"])
    done(desk, do="make", what="beam", members=["b1"])
    done(desk, do="set", path=["clamped"], value=["A"])
    done(desk, do="set", path=["fixed"], value=["A"])
    done(desk, do="set", path=["gravity"])
    if hinged:  # about the vertical: it carries the load
        done(desk, do="set", path=["beams", "b1", "hinges"], value={"A": [0, 0, 1]})
        done(desk, do="set", path=["fixed"], value={"A": "xyz", "B": "y"})
    found = done(desk, do="set", path=["loads"], value={"tip": {"node": "B", "force": tip}})
    arm = kt.statics.equilibrium(desk.drawing.found.model).data["position"].values
    lever = np.zeros(3)
    lever[:dim] = arm[1] - arm[0]
    wanted = -np.cross(lever, [*tip, 0.0][:3])
    assert found["reaction"]["A"] == pytest.approx([-one for one in tip], abs=1e-8)
    assert found["reaction_moment"] == {"A": pytest.approx(wanted[-1:] if dim == 2 else wanted, abs=1e-8)}
    assert np.linalg.norm(wanted) == pytest.approx(5.0, rel=1e-2)


def test_the_picture_to_trace_is_kept_beside_the_drawing_and_its_file(tmp_path, desk):
    text = desk.drawing.state.text
    first = drawing(None, None, tmp_path)
    done(first, do="text", text=text)
    place = {"width": 4, "turn": [0.1, 0], "opacity": 0.5}
    assert ask(first, do="picture", place=place, source="data:image/png;base64,AAAA")["kept"] is True
    assert drawing(None, None, tmp_path).first()["picture"] == {"place": place, "source": "data:image/png;base64,AAAA"}
    done(first, do="save", name="mine.yaml")
    assert "picture" not in (tmp_path / "mine.yaml").read_text()
    second = drawing(kt.read(tmp_path / "mine.yaml"), tmp_path / "mine.yaml", tmp_path)
    assert second.first()["picture"]["place"] == place
    assert ask(first, do="picture", place={**place, "opacity": 1})["kept"] is True  # moved: the same picture
    assert second.first()["picture"]["source"].endswith("AAAA")
    assert ask(second, do="picture", place=None)["kept"] is True
    assert second.first()["picture"] is None
    (tmp_path / ".kinetruss" / "untitled.picture.txt").write_text("<script>")
    assert drawing(None, None, tmp_path).first()["picture"] is None
