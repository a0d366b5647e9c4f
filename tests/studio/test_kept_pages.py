"""What a slider page has changed outlives its studio."""

from __future__ import annotations

import json
import signal

import numpy as np
import pytest
from websockets.sync.client import connect

import kinetruss as kt
from drawn import drawing
from kinetruss.studio import Session
from samples import tripod
from served import WAIT, serve, start

FRAMES = [{"time": 0.0, "values": {"LA": 1.0}}, {"time": 2.0, "values": {"LA": 1.2}}]


def header(answer) -> dict:
    if isinstance(answer, dict):
        return answer
    size = int.from_bytes(answer[:4], "little")
    return json.loads(answer[4 : 4 + size])


def ask(session: Session, **command) -> dict:
    return header(session.answer(json.dumps(command)))


def page(path, key: str = "", desk: Session | None = None) -> Session:
    """A page of a studio of a file, by default of a studio that has just been started."""
    desk = desk or drawing(kt.read(path), path, path.parent)
    return Session(desk.model, path, path.parent, text=desk.opened()[1], drafts=desk.drafts, key=key)


def changed(session: Session) -> dict:
    """Everything that a page can change, and all numbers after it."""
    ask(session, do="mass", node="T", mass=35.0)
    ask(session, do="load", name="side", node="T", force=[30.0, 0, 0])
    ask(session, do="gravity", value=[0, 9.81, 0])
    ask(session, do="switch", member="LB", to="rigid")
    ask(session, do="case", name="standing")
    assert ask(session, do="frames", frames=FRAMES) == {"kind": "kept"}
    ask(session, do="move", values={"LA": 1.1, "LC": 0.96})
    session.rest()
    return ask(session, do="query")


@pytest.fixture
def path(tmp_path):
    return kt.write(tripod(), tmp_path / "a.yaml")


@pytest.mark.slow
def test_the_next_studio_offers_all_changes_and_goes_on_with_them(path):
    first = page(path)
    wanted = changed(first)
    again = page(path)
    setup = header(again.first())["setup"]
    assert setup["offer"] == pytest.approx(first.drafts.path(f"page-{first.key}.json").stat().st_mtime)
    assert again.model == tripod()  # nothing is taken up before it is asked for
    taken = ask(again, do="draft", keep=True)["setup"]
    assert (taken["offer"], taken["frames"], taken["case"], taken["lost"]) == (None, FRAMES, "standing", first.lost)
    assert again.model == first.model
    found = ask(again, do="query")
    assert found["values"] == wanted["values"]
    for name in ("position", "member_force", "reaction"):
        np.testing.assert_allclose(found[name], wanted[name], rtol=0, atol=1e-12 * np.abs(wanted[name]).max())
    assert ask(again, do="reset")["setup"]["members"][1]["role"] == "driven"
    third = page(path)  # of that page key frames are left, the first page has gone
    assert [key for key, _ in third.drafts.left] == [again.key]


@pytest.mark.slow
def test_a_page_that_lost_its_studio_goes_on_and_other_pages_do_not_get_its_changes(path):
    desk = drawing(kt.read(path), path, path.parent)
    one, two = page(path, desk=desk), page(path, desk=desk)
    wanted = changed(one)
    ask(two, do="mass", node="T", mass=3.0)
    desk = drawing(kt.read(path), path, path.parent)
    again, other = page(path, one.key, desk), page(path, two.key, desk)
    assert (again.key, header(again.first())["setup"]["offer"]) == (one.key, None)
    assert ask(again, do="query")["member_force"] == pytest.approx(wanted["member_force"], rel=1e-9, abs=1e-9)
    assert other.model.nodes["T"].mass == 3.0
    assert page(path, "../../a").key != "../../a"


@pytest.mark.slow
def test_removed_saved_and_reset_changes_are_not_offered(path):
    changed(page(path))
    second = page(path)
    assert ask(second, do="draft", keep=False)["setup"]["offer"] is None
    assert "no changes" in ask(second, do="draft", keep=True)["message"]
    assert second.model == tripod()
    third = page(path)
    assert third.drafts.left == []
    changed(third)
    ask(third, do="save", name="b.yaml")
    assert page(path).drafts.left == []
    ask(third, do="frames", frames=[])
    ask(third, do="reset")
    assert page(path).drafts.left == []


def test_changes_of_a_file_that_has_changed_keep_their_model_and_never_replace_it_in_silence(path):
    one = page(path)
    ask(one, do="mass", node="T", mass=35.0)
    newer = tripod().with_(title="newer")
    kt.write(newer, path)
    again = page(path)
    state = ask(again, do="draft", keep=True)["state"]
    assert "The file has changed since" in state["note"]
    assert again.model == one.model
    assert ask(again, do="save", name="a.yaml")["kind"] == "exists"
    assert kt.read(path) == newer


@pytest.mark.slow
@pytest.mark.parametrize(("field", "value"), [("model", {}), ("position", [[0, 0, 0]]), ("values", 3), ("frames", [{}])])
def test_a_spoilt_record_is_refused_in_a_sentence(path, field, value):
    one = page(path)
    ask(one, do="mass", node="T", mass=35.0)
    file = one.drafts.path(f"page-{one.key}.json")
    record = json.loads(file.read_text())
    file.write_text(json.dumps(record | {field: value}))
    again = page(path)
    assert "cannot be shown" in ask(again, do="draft", keep=True)["message"]
    assert again.model == tripod()


def test_a_folder_that_cannot_be_written_is_reported_and_the_page_goes_on(path):
    (path.parent / ".kinetruss").write_text("a file in the way")
    state = ask(page(path), do="mass", node="T", mass=35.0)["state"]
    assert "cannot be kept beside the file" in state["note"]


@pytest.mark.slow
def test_a_killed_studio_comes_back_at_its_address_with_the_pose(tmp_path):
    served = serve(tripod(), tmp_path)
    options = {"origin": served.origin, "max_size": 2**24, "open_timeout": WAIT, "compression": None, "proxy": None}

    def say(line, **command) -> dict:
        line.send(json.dumps(command))
        return header_of(line)

    def header_of(line) -> dict:
        answer = line.recv(WAIT)
        return header(json.loads(answer) if isinstance(answer, str) else answer)

    with connect(served.live, **options) as line:
        key = header_of(line)["setup"]["page"]
        say(line, do="mass", node="T", mass=12.0)
        say(line, do="move", values={"LA": 1.1})
        side = tmp_path / ".kinetruss" / f"model.page-{key}.json"
        while json.loads(side.read_text())["values"]["LA"] != 1.1:  # kept when the slider rests
            line.ping().wait(0.1)
        served.process.send_signal(signal.SIGKILL)
        served.process.communicate()
    assert side.stat().st_mode & 0o077 == 0
    again = start(tmp_path, str(tmp_path / "model.yaml"))
    try:
        assert again.address == served.address
        with connect(f"{again.live}?page={key}", **options) as line:
            first = header_of(line)
            assert (first["setup"]["page"], first["setup"]["masses"]["T"], first["state"]["values"]["LA"]) == (key, 12.0, 1.1)
    finally:
        again.process.kill()
        again.process.communicate()
