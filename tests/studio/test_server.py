"""The studio over the network of this machine: who is let in, what is refused, how it ends."""

from __future__ import annotations

import http.client
import json
import re
import socket

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from kinetruss import dynamics, io, kinematics, library
from samples import tripod
from served import WAIT, Served, serve, start

pytestmark = pytest.mark.slow  # a studio in a process of its own


def live(served: Served, **changes) -> ClientConnection:
    options = {"origin": served.origin, "max_size": 2**24, "open_timeout": WAIT, "compression": None, "proxy": None}
    return connect(changes.pop("uri", served.live), **options | changes)


def heard(socket_: ClientConnection) -> dict:
    answer = socket_.recv(WAIT)
    if isinstance(answer, str):
        return json.loads(answer)
    size = int.from_bytes(answer[:4], "little")
    return json.loads(answer[4 : 4 + size])


def ask(socket_: ClientConnection, **command) -> dict:
    socket_.send(json.dumps(command))
    return heard(socket_)


def status(served: Served, path: str | None = None, host: str | None = None, **headers: str) -> tuple[int, str]:
    where, port = served.host.split(":")
    connection = http.client.HTTPConnection(where, int(port), timeout=WAIT)
    given = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request("GET", path or "/" + served.address.split("/", 3)[3], headers={"Host": host or served.host} | given)
    answer = connection.getresponse()
    text = answer.read().decode()
    connection.close()
    return answer.status, text


def test_the_page_comes_with_its_policy_and_nothing_else_is_served(studio):
    code, text = status(studio)
    assert code == 200
    assert f"connect-src ws://{studio.host} ws://localhost:" in text
    assert "default-src 'none'" in text
    for path in ("/", "/docs", "/openapi.json", "/wrong/", "/%2e%2e/", studio.address.split(studio.host)[1] + "model.yaml"):
        assert status(studio, path)[0] == 404, path
    stale = status(studio, "/an-earlier-token/")[1]  # the link of an earlier start
    assert "Each start of the studio has a new one" in stale
    assert studio.address.split("/")[3] not in stale


@pytest.mark.parametrize("host", ["example.com", "127.0.0.1", "127.0.0.1:1", "evil.localhost:80"])
def test_a_wrong_host_is_refused(studio, host):
    assert status(studio, host=host)[0] == 403
    where, port = studio.host.split(":")
    with socket.create_connection((where, int(port)), timeout=WAIT) as line:
        path = "/" + studio.live.split("/", 3)[3]
        line.sendall(
            f"GET {path} HTTP/1.1\r\nHost: {host}\r\nOrigin: {studio.origin}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
            "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n".encode()
        )
        assert b" 403 " in line.recv(200)


@pytest.mark.parametrize("origin", ["http://example.com", "null", "http://127.0.0.1:1", "https://127.0.0.1", None])
def test_a_wrong_origin_is_refused(studio, origin):
    if origin is not None:
        assert status(studio, Origin=origin)[0] == 403
    with pytest.raises(InvalidStatus) as refused:
        live(studio, origin=origin)
    assert refused.value.response.status_code == 403


def test_a_wrong_token_is_refused(studio):
    for wrong in ("wrong", studio.address.split("/")[3][:-1], "%00", "é"):
        with pytest.raises(InvalidStatus) as refused:
            live(studio, uri=f"ws://{studio.host}/{wrong}/live")
        assert refused.value.response.status_code in (403, 404)


def test_forces_over_the_network_are_those_of_the_python_interface(studio):
    with live(studio) as page:
        assert heard(page)["kind"] == "scene"
        assert ask(page, do="move", values={"LA": 1.15, "LC": 0.97})["state"]["stopped"] == ""
        found = ask(page, do="query")
    model = tripod()
    x = kinematics.assemble(model, found["values"])
    motion = kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])
    forces = dynamics.inverse(model, motion, static=False).data
    for name in ("member_force", "reaction", "drive_force"):
        wanted = forces[name].values[0]
        np.testing.assert_allclose(found[name], wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())


def test_two_pages_do_not_disturb_each_other(studio):
    with live(studio) as one, live(studio) as two:
        heard(one), heard(two)
        ask(one, do="move", values={"LA": 1.2})
        ask(two, do="move", values={"LB": 0.9})
        ask(two, do="switch", member="LC", to="rigid")
        assert ask(one, do="query")["values"]["LA"] == 1.2
        assert ask(one, do="query")["values"]["LB"] == pytest.approx(1.029563, abs=1e-6)
        assert list(ask(two, do="query")["values"]) == ["LA", "LB"]


def test_a_large_message_ends_its_page_and_the_server_lives(studio):
    with live(studio) as page:
        heard(page)
        with pytest.raises(ConnectionClosed):
            page.send("x" * 10_000_000)
            page.recv(WAIT)
    with live(studio) as page:
        assert heard(page)["kind"] == "scene"


@pytest.mark.parametrize(
    "text", ["", "{", b"\x00\x01", '{"do": "save", "name": "../x.yaml"}', '{"do": "move", "values": {"LA": null}}']
)
def test_a_malformed_message_is_answered_and_the_page_lives(studio, text):
    with live(studio) as page:
        heard(page)
        page.send(text)
        assert heard(page)["kind"] == "error"
        assert ask(page, do="query")["kind"] == "numbers"


def test_saving_goes_into_the_folder_only(studio):
    with live(studio) as page:
        heard(page)
        assert ask(page, do="save", name="mine.yaml")["message"].startswith("Written: mine.yaml")
    assert (studio.folder / "mine.yaml").is_file()
    assert {path.name for path in studio.folder.iterdir()} - {".kinetruss"} == {"model.yaml", "mine.yaml"}


def test_ctrl_c_ends_it_with_pages_open(tmp_path):
    served = serve(tripod(), tmp_path)
    with live(served) as page:
        heard(page)
        assert served.stop() == 0
        with pytest.raises(ConnectionClosed):
            page.recv(WAIT)
    rest = served.process.communicate()[0]
    assert "Stopped." in rest
    assert "Traceback" not in rest


def test_ctrl_c_ends_it_while_a_file_and_a_motion_are_made(tmp_path):
    model = io.read(library.example_files()["driven_bay"][0])
    served = serve(model, tmp_path)
    with live(served, uri=served.live.removesuffix("live") + "draw/live") as page:
        heard(page)
        assert ask(page, do="take", form="page", run=next(iter(model.runs)))["kind"] in ("running", "taken")
        assert ask(page, do="sweep", drives=[next(iter(model.all_drives))])["kind"] in ("computing", "sweep")
        assert served.stop() == 0
    assert "Stopped." in served.process.communicate()[0]


def test_a_port_that_is_taken_is_named(studio, tmp_path):
    import subprocess
    import sys

    from kinetruss import io

    path = io.write(tripod(), tmp_path / "a.yaml")
    command = [sys.executable, "-c", "from kinetruss.cli import main; main()", "studio", str(path), "--no-open", "--port"]
    found = subprocess.run([*command, studio.host.split(":")[1]], capture_output=True, text=True, timeout=WAIT)
    assert found.returncode == 2
    assert re.search(r"Port \d+ of 127.0.0.1 cannot be used", found.stderr)


def drawing(served: Served) -> ClientConnection:
    base = served.live.removesuffix("live").removesuffix("draw/")
    return live(served, uri=f"{base}draw/live")


def test_drawing_pages_share_one_drawing_and_the_live_page_operates_it(tmp_path):
    served = start(tmp_path, "--new", "--space")
    assert served.address.endswith("/draw/")
    try:
        assert status(served)[0] == 200
        with drawing(served) as one, drawing(served) as two:
            assert heard(one)["dim"] == heard(two)["dim"] == 3
            with live(served, uri=served.live.replace("draw/", "")) as page:
                failed = heard(page)
                assert (failed["kind"], "no model yet" in failed["message"]) == ("failed", True)
            assert ask(one, do="stack", cell="tetrahedron")["nodes"] == heard(two)["nodes"]
            assert ask(two, do="delete", members=["B1.batten1"])["undo"] == heard(one)["undo"] == "deleting B1.batten1"
            one.send("[" * 100_000)
            assert heard(one)["kind"] == "error"
            ask(one, do="undo")
            assert heard(two)["redo"]
            with live(served, uri=served.live.replace("draw/", "")) as page:
                assert len(heard(page)["setup"]["members"]) == 6
        with pytest.raises(InvalidStatus, match="403"), live(served, uri=served.live, origin="http://evil.example"):
            pass
    finally:
        served.process.kill()
        served.process.communicate()
    last = start(tmp_path)
    assert last.address == served.address  # a drawing that was kept keeps its address
    other = start(tmp_path)  # at the same time: another drawing
    with drawing(other) as page:
        assert heard(page)["offer"] is None
        ask(page, do="add", at=[0, 0])
    other.process.kill()
    other.process.communicate()
    assert (tmp_path / ".kinetruss" / "untitled-2.autosave.yaml").is_file()
    assert (tmp_path / ".kinetruss" / "untitled.address.json").stat().st_mode & 0o077 == 0
    last.process.kill()
    last.process.communicate()


def test_an_empty_drawing_is_not_asked_for_with_a_model(tmp_path):
    import subprocess
    import sys

    command = [sys.executable, "-c", "from kinetruss.cli import main; main()", "studio", "--new", "a.yaml", "--no-open"]
    found = subprocess.run(command, capture_output=True, text=True, timeout=WAIT, cwd=tmp_path)
    assert found.returncode == 2
    assert "--new opens an empty drawing" in found.stderr
