"""Motions are computed beside what else is done: an edit is not kept waiting, and nothing of an earlier drawing is shown."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import kinetruss as kt
from drawn import asked, drawing, unpacked
from four_bars import four_bar
from kinetruss.studio import Session, films, let_go, sweeps

LONGEST = 60.0  # s, after which a test that waits for another thread goes on and fails


class Gate:
    """A computation that waits at its beginning until it is let through; it counts how often it has begun and ended."""

    def __init__(self, work: Callable[..., Any]) -> None:
        self.work, self.began, self.ended, self.open = work, 0, 0, threading.Event()
        self.inside = threading.Event()

    def __call__(self, *given: Any, **named: Any) -> Any:
        self.began += 1
        self.inside.set()
        assert self.open.wait(LONGEST)
        found = self.work(*given, **named)
        self.ended += 1
        return found


@pytest.fixture
def gate(monkeypatch) -> Gate:
    """Before the sweep of every motion."""
    found = Gate(sweeps.swept)
    monkeypatch.setattr(films.sweeps, "swept", found)
    return found


def sent(session: Session, **message: Any) -> Any:
    """The answer that comes at once."""
    return session.answer(json.dumps(message))


def test_an_edit_is_answered_while_a_motion_is_computed_and_that_motion_is_neither_shown_nor_kept(gate):
    session = drawing(four_bar((0.1, 0.35, 0.3), 0.4))
    first = sent(session, do="sweep", drives=["motor"])
    assert first["kind"] == "computing"
    assert first["text"].startswith("Comp")
    assert gate.inside.wait(LONGEST)
    edit = sent(session, do="set", path=["loads", "F", "force"], value=[0, -50])
    assert (edit["kind"], gate.ended) == ("drawing", 0)
    gate.open.set()
    late = asked(session, do="motion", number=first["number"])
    assert late == {"kind": "replaced", "message": "The drawing has changed since this motion was asked for. Play it again."}
    answer = asked(session, do="over", show="N", sample=0)
    assert answer["why"] == "The motion is not known any more. Play it again."
    header, arrays = unpacked(asked(session, do="sweep", drives=["motor"]))
    assert header["revision"] == session.drawing.revision
    alone = sweeps.film(sweeps.swept(session.model, session.closed()[1], ["motor"]), session.model)
    np.testing.assert_array_equal(arrays["drive_force"], alone.arrays["drive_force"].astype("<f4"))
    assert session.motions.of(session.drawing.revision) is not None
    assert session.motions.of(edit["revision"] - 1) is None


def test_a_newer_request_takes_the_place_of_the_one_before(gate):
    session = drawing(four_bar((0.1, 0.35, 0.3), 0.4))
    first = sent(session, do="sweep", drives=["motor"], rate=1.0)
    assert gate.inside.wait(LONGEST)
    second = sent(session, do="sweep", drives=["motor"], rate=2.0)
    third = sent(session, do="sweep", drives=["motor"], rate=3.0)
    same = sent(session, do="sweep", drives=["motor"], rate=3.0)  # as another page
    assert same["number"] == third["number"]
    gate.open.set()
    header, _ = unpacked(asked(session, do="motion", number=third["number"]))
    assert header["rate"] == 3.0
    for one in (first, second):
        late = asked(session, do="motion", number=one["number"])
        assert late == {"kind": "replaced", "message": "Another motion was asked for since. Play it again."}
    assert (gate.began, gate.ended) == (2, 2)  # the second was given up before it began
    assert unpacked(asked(session, do="motion", number=third["number"]))[0]["rate"] == 3.0


def test_what_is_let_go_is_given_up_in_the_midst_of_its_computation(monkeypatch):
    free = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2)}, fixed={"A": "xy"}, bars={"b": ("A", "B")}, gravity=(0, -9.81)
    )
    session, progress, changed, went_on = drawing(free), threading.Event(), threading.Event(), []
    monotonic = let_go.time.monotonic

    def clock() -> float:  # is read at each step
        progress.set()
        assert changed.wait(LONGEST)
        went_on.append(monotonic())
        return went_on[-1]

    monkeypatch.setattr(let_go, "time", type("Clock", (), {"monotonic": staticmethod(clock)}))
    first = sent(session, do="let_go")
    assert first["kind"] == "computing"
    assert progress.wait(LONGEST)
    assert sent(session, do="move", places={"B": [0.6, 0]})["kind"] == "drawing"
    changed.set()
    assert asked(session, do="motion", number=first["number"])["kind"] == "replaced"
    assert session.motions._last.done.wait(LONGEST)
    assert len(went_on) == 1
    header, arrays = unpacked(asked(session, do="let_go"))
    assert header["ends"] == ["", ""]
    np.testing.assert_allclose(arrays["position"][0, 1], [0.6, 0], atol=1e-7)


def test_errors_of_a_motion_are_its_answer_and_are_not_kept(monkeypatch):
    session = drawing(four_bar((0.1, 0.35, 0.3), 0.4))
    assert "No drive called 'moter'" in asked(session, do="sweep", drives=["moter"])["message"]
    assert sent(session, do="motion", number=77) == {
        "kind": "replaced",
        "message": "Another motion was asked for since. Play it again.",
    }

    def broken(*_given: Any, **_named: Any) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(films.sweeps, "film", broken)
    answer = asked(session, do="sweep", drives=["motor"])
    assert answer == {"kind": "error", "message": "This could not be done: ZeroDivisionError. The model is unchanged."}
    monkeypatch.undo()
    assert unpacked(asked(session, do="sweep", drives=["motor"]))[0]["kind"] == "sweep"


def test_the_end_of_a_studio_gives_up_a_motion_and_waits_for_its_step(gate):
    session = drawing(four_bar((0.1, 0.35, 0.3), 0.4))
    first = sent(session, do="sweep", drives=["motor"])
    assert gate.inside.wait(LONGEST)
    session.motions.close(0.0)
    gate.open.set()
    session.motions.close(LONGEST)
    assert not session.motions._thread.is_alive()
    assert gate.ended == 1
    assert session.motions.of(session.drawing.revision) is None
    assert sent(session, do="motion", number=first["number"])["kind"] == "replaced"
