"""Whatever is done to a live model: what is shown has every length, angle and support that the model asks for."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import settings, strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

import kinetruss as kt
from kinetruss.library import example_files
from kinetruss.studio import Session
from samples import fourbar, tripod

pytestmark = pytest.mark.slow

ROLES = ("rigid", "driven", "elastic", "cut", "own", "own")  # "own": put back


def told(answer) -> dict:
    if isinstance(answer, dict):
        return answer
    size = int.from_bytes(answer[:4], "little")
    return json.loads(answer[4 : 4 + size])


def largest_miss(session: Session) -> float:
    """Of all lengths, angles of driven bars and supports, in parts of the size, from the model's own records."""
    model, values = session.model, session.pose.values
    place = dict(zip(model.nodes, session.pose.position, strict=True))
    drawn = {name: np.array(node.at) for name, node in model.nodes.items()}
    driven = {drive.bar: values[name] for name, drive in model.all_drives.items() if isinstance(drive, kt.LengthDrive)}
    misses = []
    for name, member in model.members.items():
        a, b = member.ends
        if name in driven:
            wanted = driven[name]
        elif getattr(member, "kind", "active") == "rigid":
            wanted = member.length or np.linalg.norm(drawn[b] - drawn[a])
        else:
            continue
        misses.append(abs(np.linalg.norm(place[b] - place[a]) - wanted))
    for name, drive in model.all_drives.items():
        if isinstance(drive, kt.AngleDrive) and model.dim == 2:
            x, y = np.subtract(*(place[end] for end in model.members[drive.bar].ends[::-1]))
            apart = math.atan2(y, x) - values[name]
            misses.append(math.hypot(x, y) * abs(math.remainder(apart, 2 * math.pi)))
    for node, axes in model.fixed.items():
        misses += [abs(place[node]["xyz".index(axis)] - drawn[node]["xyz".index(axis)]) for axis in axes]
    return max(misses) / np.ptp(session.pose.position, axis=0).max()


def bay() -> kt.Model:
    return kt.read(example_files()["double_octahedral_slew"][0])


class Edits(RuleBasedStateMachine):
    """Cut, put back, fix, drive, move, load, turn gravity, start anew, in any order."""

    make = staticmethod(tripod)

    def __init__(self) -> None:
        super().__init__()
        self.session = Session(self.make())
        self.members = list(self.session.original.model.members)

    def ask(self, **command) -> dict:
        found = told(self.session.answer(json.dumps(command)))
        assert found["kind"] in ("scene", "state", "error")
        if found["kind"] == "error":
            assert found["message"].rstrip().endswith((".", "?", ")")), found["message"]
        return found

    @rule(which=st.integers(0, 99), to=st.sampled_from(ROLES))
    def switch(self, which: int, to: str) -> None:
        before = self.session.model
        found = self.ask(do="switch", member=self.members[which % len(self.members)], to=to)
        assert (found["kind"] == "error") == (self.session.model is before)

    @precondition(lambda self: self.session.pose.values)
    @rule(which=st.integers(0, 99), share=st.floats(0, 1))
    def slide(self, which: int, share: float) -> None:
        names = list(self.session.pose.values)
        name = names[which % len(names)]
        low, high, _ = self.session.limits(name)
        wanted = low + share * (high - low)
        state = self.ask(do="move", values={name: wanted})["state"]
        assert state["stopped"] or state["values"][name] == pytest.approx(wanted, abs=1e-9)
        assert " t = " not in state["stopped"]  # a slider has no time
        assert state["stopped"].count("(") == state["stopped"].count(")")

    @rule(pull=st.lists(st.floats(-20, 20), min_size=2, max_size=2))
    def turn_gravity(self, pull: list[float]) -> None:
        self.ask(do="gravity", value=[*pull, -9.81][: self.session.model.dim])

    @rule()
    def start_anew(self) -> None:
        self.ask(do="reset")

    @invariant()
    def nothing_open_is_shown(self) -> None:
        assert largest_miss(self.session) < 1e-9
        found = self.ask_numbers()
        assert np.isfinite(found["member_force"]).all()

    def ask_numbers(self) -> dict:
        return told(self.session.answer(json.dumps({"do": "query"})))


class BayEdits(Edits):
    make = staticmethod(bay)


class FourbarEdits(Edits):
    make = staticmethod(lambda: fourbar(gravity=(0, -9.81)))


FEW = settings(max_examples=12, stateful_step_count=10, deadline=None)
TestTripod, TestBay, TestFourbar = Edits.TestCase, BayEdits.TestCase, FourbarEdits.TestCase
TestTripod.settings = TestBay.settings = TestFourbar.settings = FEW


@pytest.mark.parametrize("member", list(bay().members))
def test_a_member_that_is_cut_and_put_back_has_its_length_again(member):
    session = Session(bay())
    before = told(session.answer(json.dumps({"do": "query"})))
    for to in ("cut", "own"):
        assert told(session.answer(json.dumps({"do": "switch", "member": member, "to": to})))["kind"] == "scene"
    assert largest_miss(session) < 1e-12
    for name, value in before["values"].items():
        state = told(session.answer(json.dumps({"do": "move", "values": {name: value + 0.003}})))["state"]
        assert not state["stopped"]
        assert state["values"][name] == pytest.approx(value + 0.003)


def test_a_member_that_cannot_be_closed_again_is_refused_with_the_whole_reason_and_nothing_changes():
    """With one strut of a flat triangle cut, the other is driven too short for the two to span the supports."""
    nodes = {"A": (0, 0), "B": (1, 0), "C": (0.5, 0.1)}
    bars = {"a": kt.Bar(ends=("A", "C"), kind="driven"), "b": ("B", "C")}
    session = Session(kt.Model(nodes=nodes, fixed=("A", "B"), bars=bars, gravity=(0, -9.81)))

    def ask(**command) -> dict:
        return told(session.answer(json.dumps(command)))

    assert ask(do="switch", member="b", to="cut")["kind"] == "scene"
    assert ask(do="move", values={"a": 0.35})["state"]["stopped"] == ""
    before, place = session.model, session.pose.position
    answer = ask(do="switch", member="b", to="own")
    assert answer["kind"] == "error"
    assert "cannot be closed from the pose shown, where 'b' is off by" in answer["message"]
    assert answer["message"].endswith(".")
    assert session.model is before
    assert session.pose.position is place
    assert ask(do="move", values={"a": 0.6})["kind"] == "state"
    assert ask(do="switch", member="b", to="own")["kind"] == "scene"
    assert largest_miss(session) < 1e-12
