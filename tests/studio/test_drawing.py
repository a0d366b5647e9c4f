"""Drawing a model edit by edit, without any network: commands, undo, the text both ways, what is missing, files."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import Phase, settings, strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

import kinetruss as kt
from drawn import drawing
from kinetruss import dynamics, kinematics
from kinetruss.library import example_files
from kinetruss.studio import Session


def ask(desk: Session, **command) -> dict:
    found = desk.answer(json.dumps(command))
    return json.loads(json.dumps(found, allow_nan=False))


def done(desk: Session, **command) -> dict:
    found = ask(desk, **command)
    assert found["kind"] in ("drawing", "moved"), found
    return found


def triangle(desk: Session) -> dict:
    """Two struts and a tie on a pin and a roller, loaded at the apex."""
    for at in ([0, 0], [2, 0], [1, "1500 mm"]):
        done(desk, do="add", at=at)
    for ends in ("AC", "BC", "AB"):
        done(desk, do="bar", ends=list(ends))
    done(desk, do="set", path=["fixed", "A"], value="xy")
    done(desk, do="set", path=["fixed", "B"], value="y")
    return done(desk, do="set", path=["loads", "push"], value={"node": "C", "force": [0, "-2 kN"]})


def test_an_empty_drawing_says_how_to_begin_and_has_no_faults():
    desk = drawing()
    for found in (done(desk, do="show"), done(desk, do="add", at=[0, 0]), done(desk, do="delete", nodes=["A"], members=[])):
        assert found["faults"] == []
    assert found["nodes"] == [] and "Nothing is drawn yet" in json.dumps(found)


def test_a_triangle_is_drawn_and_has_the_forces_of_statics_by_hand():
    found = triangle(drawing())
    strut = -1000 * math.hypot(1, 1.5) / 1.5  # vertical balance at the apex
    assert found["force"] == pytest.approx([strut, strut, 1000 / 1.5], rel=1e-12)
    assert found["reaction"] == {"A": pytest.approx([0, 1000], abs=1e-9), "B": pytest.approx([0, 1000], abs=1e-9)}
    assert "C: [1, 1500 mm]" in found["text"]  # the unit stays as it was typed
    assert found["mobility"]["undriven"] == found["mobility"]["self_stress"] == 0


@pytest.mark.slow
def test_what_is_missing_is_said_at_every_step_and_drawing_goes_on():
    desk = drawing()
    assert "Drag from point to point" in desk.first()["missing"][0]
    found = done(desk, do="add", at=[0, 0])
    assert [words.split(":")[0] for words in found["missing"]] == ["No bar yet", "No support yet"]
    found = done(desk, do="add", at=[1, 0], bar_from="A")
    assert found["made"] == {"node": "B", "member": "b1"}
    found = done(desk, do="set", path=["fixed", "A"], value="xy")
    assert found["missing"][-1].startswith("No load yet")
    assert found["why"].startswith("No forces yet: 1 mechanism is left")
    assert found["warnings"] == [{"kind": "mechanism", "text": "Mechanism 1: B moves along y (+1.000)"}]
    found = done(desk, do="set", path=["drives", "turn"], value={"kind": "angle", "bar": "b1"})
    assert found["warnings"] == []
    assert found["drives"][0]["name"] == "turn"


@pytest.mark.slow
def test_a_drive_that_acts_against_the_bars_and_redundancy_are_named():
    desk = drawing()
    triangle(desk)
    found = done(desk, do="set", path=["fixed", "B"], value="xy")
    assert [row["kind"] for row in found["warnings"]] == ["redundant"]
    done(desk, do="set", path=["fixed", "B"], value="y")
    found = done(desk, do="set", path=["bars", "b3", "kind"], value="driven")
    assert found["warnings"] == []  # the drive takes the place of the tie
    found = done(desk, do="set", path=["drives", "spin"], value={"kind": "angle", "bar": "b1"})
    kinds = {row["kind"]: row["text"] for row in found["warnings"]}
    assert "spin" in kinds["drive"]
    assert "act against the bars" in kinds["drive"]
    assert found["unsure"]


@pytest.mark.slow
def test_undo_and_redo_go_through_all_states_and_a_drag_is_one_step():
    desk = drawing()
    texts = [desk.first()["text"], triangle(desk)["text"]]
    for k in range(20):
        found = done(desk, do="move", places={"C": [1 + 0.01 * k, 1.5]}, drag=7)
        assert found["kind"] == "moved"
    dragged = done(desk, do="show")
    assert dragged["undo"] == "moving C"
    assert done(desk, do="undo")["text"] == texts[1]
    while (found := done(desk, do="undo"))["undo"]:
        pass
    assert found["text"] == texts[0]
    assert "nothing to undo" in ask(desk, do="undo")["message"]
    while (found := done(desk, do="redo"))["redo"]:
        pass
    assert found["text"] == dragged["text"]


def test_the_text_changes_the_drawing_and_faults_have_their_line():
    desk = drawing()
    text = triangle(desk)["text"]
    found = done(desk, do="text", text=text.replace("[1, 1500 mm]", "[1, 3]  # higher"))
    assert found["places"][2] == [1, 3]
    assert "# higher" in found["text"]
    broken = ask(desk, do="text", text=text.replace("B: [2, 0]", "B: [2"))
    assert (broken["kind"], broken["faults"][0]["line"] > 1) == ("faults", True)
    assert done(desk, do="show")["places"][2] == [1, 3]  # the drawing is that of the last good text
    lost = done(desk, do="text", text=text.replace("push: {node: C", "push: {node: Q"))
    line = next(k for k, row in enumerate(text.splitlines(), 1) if "push" in row)
    assert [(row["where"], row["line"]) for row in lost["faults"]] == [("loads.push.node", line)]
    assert lost["valid"] is False
    assert len(lost["members"]) == 3  # it is still drawn
    again = done(desk, do="move", places={"C": [1, 2]})  # and can be drawn on
    assert again["places"][2] == [1, 2]
    assert again["faults"]
    assert done(desk, do="set", path=["loads", "push", "node"], value="C")["faults"] == []


def test_a_value_that_the_model_refuses_changes_nothing():
    desk = drawing()
    before = triangle(desk)
    for path, value, words in (
        (["nodes", "C", "mass"], "heavy", "heavy"),
        (["bars", "b1", "length"], "5 kg", "5 kg"),
        (["bars", "b9", "length"], 1, "b9"),
        (["fixed", "A"], "q", "q"),
        (["loads", "push", "force"], [1], "force"),
        (["drives", "w"], {"kind": "angle", "bar": "nope"}, "nope"),
    ):
        found = ask(desk, do="set", path=path, value=value)
        assert found["kind"] == "error"
        assert words in found["message"]
    assert "already" in ask(desk, do="bar", ends=["B", "A"])["message"]
    assert done(desk, do="show")["text"] == before["text"]


def test_lengths_are_closed_and_what_cannot_close_is_said_and_has_no_forces():
    desk = drawing()
    triangle(desk)
    found = done(desk, do="set", path=["bars", "b1", "length"], value="1.3 m")
    a, b, c = map(np.array, found["places"])
    assert np.linalg.norm(c - a) == pytest.approx(1.3, abs=1e-12)
    assert np.linalg.norm(c - b) == pytest.approx(math.hypot(1, 1.5), abs=1e-12)
    read = kt.Model(**desk.drawing.state.data)
    np.testing.assert_allclose(kinematics.assemble(read), found["places"], atol=1e-12)
    far = done(desk, do="set", path=["bars", "b1", "length"], value="9 m")
    assert far["force"] is None
    assert "b1 is drawn 1.3 m long and given as 9 m" in far["why"]
    assert far["apart"]["b1"] == pytest.approx([1.3, 9])
    assert done(desk, do="undo")["force"] is not None


def test_a_length_between_supports_that_does_not_fit_is_named():
    desk = drawing()
    triangle(desk)
    done(desk, do="delete", nodes=["C"])
    done(desk, do="set", path=["fixed"], value=["A", "B"])
    found = done(desk, do="set", path=["bars", "b3", "length"], value=0.5)
    assert found["apart"] == {"b3": [2, 0.5]}


def test_entries_are_renamed_and_deleted_with_what_refers_to_them():
    desk = drawing()
    triangle(desk)
    done(desk, do="set", path=["drives", "turn"], value={"kind": "angle", "bar": "b3"})
    done(desk, do="set", path=["fixed", "B"], value=None)
    found = done(desk, do="rename", table="nodes", old="C", new="apex")
    assert found["data"]["loads"]["push"]["node"] == "apex"
    assert found["members"][0]["ends"] == ["A", "apex"]
    found = done(desk, do="rename", table="bars", old="b3", new="base")
    assert found["data"]["drives"]["turn"]["bar"] == "base"
    assert "there already" in ask(desk, do="rename", table="nodes", old="apex", new="A")["message"]
    found = done(desk, do="delete", nodes=["apex"], members=["base"])
    assert found["made"]["lost"] == ["drives.turn", "loads.push"]
    assert [found["nodes"], found["members"], found["faults"]] == [["A", "B"], [], []]


def test_a_renamed_node_keeps_the_hinge_about_it():
    desk = drawing()
    triangle(desk)
    hinge = {"kind": "hinge", "axis": ["A"], "start": "B", "end": "C"}
    done(desk, do="set", path=["drives", "fold"], value=hinge)
    done(desk, do="set", path=["springs", "coil"], value={"terms": [[hinge, 1]], "stiffness": 5})
    found = done(desk, do="rename", table="nodes", old="A", new="pin")["data"]
    assert found["drives"]["fold"]["axis"] == ["pin"]
    assert found["springs"]["coil"]["terms"][0][0]["axis"] == ["pin"]


@pytest.mark.slow
def test_copies_mirror_images_and_stacks():
    desk = drawing()
    triangle(desk)
    found = done(desk, do="mirror", nodes=["A", "B", "C"], axis="x", at="2 m")
    assert len(found["nodes"]) == 5  # B lies in the plane
    assert len(found["members"]) == 6
    assert found["fixed"] == {"A": "xy", "B": "y", found["nodes"][3]: "xy"}
    done(desk, do="undo")
    found = done(desk, do="copy", nodes=["A", "B", "C"], by=["2 m", 0], count=3)
    assert len(found["nodes"]) == 3 + 3 * 2
    assert len(found["members"]) == 12
    space = drawing(dim=3)
    found = done(space, do="stack", cell="octahedron", count=2)
    assert len(found["members"]) == 12 + 9
    found = done(space, do="stack", cell="prism", count=1)
    assert found["nodes"][9] == "C1.N1"
    assert min(place[0] for place in found["places"][9:]) > max(place[0] for place in found["places"][:9])
    assert found["mobility"]["undriven"] == 6  # the second one is free
    assert "planar" in ask(desk, do="stack", cell="octahedron")["message"]


def test_the_coupler_curve_is_the_circle_of_a_crank_and_its_torque_is_that_of_the_weight():
    desk = drawing()
    done(desk, do="add", at=[0, 0])
    done(desk, do="add", at=["50 cm", 0], bar_from="A")
    done(desk, do="set", path=["fixed", "A"], value="xy")
    done(desk, do="set", path=["drives", "motor"], value={"kind": "angle", "bar": "b1"})
    done(desk, do="set", path=["nodes", "B", "mass"], value="2 kg")
    found = ask(desk, do="curve", node="B", drive="motor")
    path, angle = np.array(found["path"]), np.array(found["values"])
    assert angle[-1] - angle[0] == pytest.approx(2 * math.pi)
    np.testing.assert_allclose(path, 0.5 * np.c_[np.cos(angle), np.sin(angle)], atol=1e-12)
    np.testing.assert_allclose(found["force"], 2 * 9.81 * 0.5 * np.cos(angle), atol=1e-9)


OPENED = ("bricard", "docking", "double_octahedral_slew", "isolator_beam", "robot", "triangular_truss")


@pytest.mark.slow
@pytest.mark.parametrize("name", OPENED)
def test_an_example_opens_as_its_model_and_a_drag_checks_all_that_follows_from_places(name):
    path = example_files()[name][0]
    desk = drawing(kt.read(path), path)
    assert kt.Model(**desk.drawing.state.data) == kt.read(path)
    assert desk.first()["faults"] == []
    moved = next(iter(set(desk.drawing.state.data["nodes"]) - set(desk.drawing.found.model.fixed)))
    place = np.array(desk.drawing.found.model.nodes[moved].at) + 1e-3
    for shift in (0, 1e-4):
        ask(desk, do="move", places={moved: list(place + shift)}, drag=3)
        if desk.drawing.found.model is not None and not desk.drawing.found.moved:
            assert desk.drawing.found.model == kt.Model(**desk.drawing.state.data)


def test_a_typed_text_reads_files_of_the_folder_only(tmp_path):
    (tmp_path / "in").mkdir()
    (tmp_path / "push.csv").write_text("t [s],x [N],y [N]\n0,1,2\n1,3,4\n")
    (tmp_path / "in" / "push.csv").write_text((tmp_path / "push.csv").read_text())
    desk = drawing(None, None, tmp_path / "in")
    text = triangle(desk)["text"]
    for file, taken in (
        ("push.csv", True),
        ("../push.csv", False),
        (str(tmp_path / "push.csv"), False),
        ("C:\\\\push.csv", False),
    ):
        found = ask(desk, do="text", text=f"{text}\n".replace("loads:", f'loads:\n  wind: {{node: C, file: "{file}"}}', 1))
        assert (found["kind"] == "drawing") == taken, found
        assert taken or "not in the folder" in found["faults"][0]["text"]


def test_nothing_is_written_unasked_and_versions_lead_back(tmp_path):
    desk = drawing(None, None, tmp_path)
    text = triangle(desk)["text"]
    assert [one.name for one in tmp_path.iterdir()] == [".kinetruss"]  # the side files
    (tmp_path / "mine.yaml").write_text("years of work")
    assert ask(desk, do="save", name="mine.yaml")["kind"] == "exists"
    assert (tmp_path / "mine.yaml").read_text() == "years of work"
    assert "device" in ask(desk, do="save", name="CON.yaml")["message"]
    assert done(desk, do="save", name="new.yaml")["dirty"] is False
    assert (tmp_path / "new.yaml").read_text() == text
    done(desk, do="delete", nodes=["C"])
    assert done(desk, do="save", name="new.yaml")["file"] == "new.yaml"
    rows = ask(desk, do="versions")["rows"]
    assert [row["words"] for row in rows] == ["saved as new.yaml"] * 2
    assert done(desk, do="restore", number=rows[0]["number"])["text"] == text
    assert done(desk, do="undo")["nodes"] == ["A", "B"]


def test_edits_outlive_the_studio_and_are_offered(tmp_path):
    first = drawing(None, None, tmp_path)
    first.drafts.address = ("a-token", 4711)
    text = triangle(first)["text"]
    second = drawing(None, None, tmp_path)
    assert second.drafts.last_address() == ("a-token", 4711)
    assert second.first()["offer"]["ago"] < 60
    assert second.first()["nodes"] == []
    assert done(second, do="draft", keep=True)["text"] == text
    assert drawing(None, None, tmp_path).first()["offer"]
    assert done(drawing(None, None, tmp_path), do="draft", keep=False)["nodes"] == []
    assert drawing(None, None, tmp_path).first()["offer"] is None


PLACES = st.integers(-30, 30).map(lambda k: k / 10)


class Edits(RuleBasedStateMachine):
    """Any edits in any order: answers are sentences, the text is the drawing, and no open pose has forces."""

    def __init__(self) -> None:
        super().__init__()
        self.desk = drawing()
        self.last = triangle(self.desk)

    def ask(self, **command) -> None:
        before = self.desk.drawing.state.data
        found = ask(self.desk, **command)
        if found["kind"] == "error":
            assert found["message"].rstrip().endswith((".", "?", ")", '"', "'", "}")), found["message"]
            assert self.desk.drawing.state.data is before
        else:
            self.last = ask(self.desk, do="show")

    def name(self, k: int, table: str = "nodes") -> str:
        names = list(self.desk.drawing.state.data.get(table) or {"none": 0})
        return names[k % len(names)]

    @rule(x=PLACES, y=PLACES)
    def add(self, x: float, y: float) -> None:
        self.ask(do="add", at=[x, y], bar_from=self.name(int(9 * abs(x))))

    @rule(i=st.integers(0, 9), j=st.integers(0, 9))
    def join(self, i: int, j: int) -> None:
        self.ask(do="bar", ends=[self.name(i), self.name(j)])

    @rule(i=st.integers(0, 9), x=PLACES, drag=st.sampled_from([None, 1]))
    def move(self, i: int, x: float, drag: int | None) -> None:
        self.ask(do="move", places={self.name(i): [x, 0.5]}, drag=drag)

    @rule(i=st.integers(0, 9), axes=st.sampled_from(["x", "y", "xy", None]))
    def hold(self, i: int, axes: str | None) -> None:
        self.ask(do="set", path=["fixed", self.name(i)], value=axes)

    @rule(i=st.integers(0, 9), length=st.sampled_from([None, 0.5, 1.0, "2 m", "x"]))
    def stretch(self, i: int, length: object) -> None:
        self.ask(do="set", path=["bars", self.name(i, "bars"), "length"], value=length)

    @rule(i=st.integers(0, 9), kind=st.sampled_from(["rigid", "driven", "elastic"]))
    def kind(self, i: int, kind: str) -> None:
        self.ask(do="set", path=["bars", self.name(i, "bars"), "kind"], value=kind)

    @rule(i=st.integers(0, 9))
    def drive(self, i: int) -> None:
        self.ask(do="set", path=["drives", "turn"], value={"kind": "angle", "bar": self.name(i, "bars")})

    @rule(i=st.integers(0, 9), node=st.booleans())
    def delete(self, i: int, node: bool) -> None:
        self.ask(do="delete", nodes=[self.name(i)] if node else [], members=[] if node else [self.name(i, "bars")])

    @rule(back=st.booleans())
    def step(self, back: bool) -> None:
        self.ask(do="undo" if back else "redo")

    @invariant()
    def the_text_is_the_drawing_and_forces_are_those_of_the_interface(self) -> None:
        other = drawing()
        done(other, do="text", text=self.last["text"])
        assert other.drawing.state.data == self.desk.drawing.state.data
        model = self.desk.drawing.found.model
        if self.last["force"] is None or any(bar.kind == "elastic" for bar in model.bars.values()):
            return
        x = np.array(self.last["places"])
        for name, bar in model.bars.items():
            a, b = (x[list(model.nodes).index(end)] for end in bar.ends)
            if bar.length is not None:
                assert np.linalg.norm(b - a) == pytest.approx(bar.length, abs=1e-9), name
        motion = kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])
        wanted = dynamics.inverse(model, motion, static=False).arrays["member_force"].values[0]
        np.testing.assert_allclose(self.last["force"], wanted, rtol=1e-12, atol=1e-12 * np.abs(wanted).max(initial=1e-300))


TestEdits = Edits.TestCase
TestEdits.pytestmark = [pytest.mark.slow]
TestEdits.settings = settings(max_examples=8, stateful_step_count=10, deadline=None, phases=(Phase.generate,))
