"""Models and runs in a notebook."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import dynamics, kinematics
from kinetruss.report import histories_svg
from samples import fourbar, tripod

CELLS = (
    "%load_ext kinetruss",
    "import kinetruss as kt\n"
    "two = kt.Model(nodes={'A': (0, 0), 'B': (4, 0), 'C': (2, 1)}, fixed=['A', 'B'],\n"
    "               bars={'a': kt.Bar(ends=('A', 'C'), kind='driven'), 'b': ('B', 'C')}, gravity=(0, -9.81))\n"
    "two",
    "live = kt.notebook.live(two)\nlive",
    "live.session.move({'a': 2.5}); live.session.pose.values",
)
# in a process of its own: what a kernel's client warns of is not ours
EXECUTE = """
import json, sys
import nbclient, nbformat
book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in json.loads(sys.argv[1])])
nbclient.NotebookClient(book, timeout=120, kernel_name="python3").execute()
json.dump([cell.outputs for cell in book.cells], sys.stdout)
"""


@pytest.mark.slow
def test_a_notebook_shows_a_model_and_a_live_one():
    found = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", EXECUTE, json.dumps(CELLS)], capture_output=True, text=True, timeout=240
    )
    assert found.returncode == 0, found.stderr
    none, picture, widget, values = json.loads(found.stdout)
    assert none == []
    html = picture[0]["data"]["text/html"]
    assert html.startswith("<iframe sandbox=")
    assert "kinetruss-scene" in html
    # a still for pages without a kernel stands by itself, since the widget is preferred to it where both are one output
    still, shown = widget
    assert "kinetruss-scene" in still["data"]["text/html"]
    assert "data-still" in still["data"]["text/html"]
    assert "application/vnd.jupyter.widget-view+json" in shown["data"]
    assert "text/html" not in shown["data"]
    assert values[0]["data"]["text/plain"] == "{'a': 2.5}"


class Spoken:
    """A live model and what it sends."""

    def __init__(self, model: kt.Model, **options: object) -> None:
        self.widget = kt.notebook.live(model, **options)
        self.sent: list[tuple[dict, list]] = []
        self.widget.send = lambda content, buffers=None: self.sent.append((content, buffers or []))

    def ask(self, **command: object) -> tuple[dict, list]:
        self.widget._handle_custom_msg({"id": "one", "text": json.dumps(command)}, [])
        return self.sent.pop()


def test_a_live_model_answers_through_its_messages():
    spoken = Spoken(tripod())
    content, buffers = spoken.ask(do="move", values={"LA": 1.1})
    assert content == {"id": "one"}
    assert len(buffers) == 1
    assert spoken.widget.values["LA"] == 1.1
    found = json.loads(spoken.ask(do="query")[0]["text"])
    x = kinematics.assemble(tripod(), found["values"])
    motion = kinematics.from_arrays(tripod(), [0.0], x[None], 0 * x[None], 0 * x[None])
    wanted = dynamics.inverse(tripod(), motion, static=False).data["member_force"].values[0]
    np.testing.assert_allclose(found["member_force"], wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())


def test_what_is_no_message_is_ignored():
    spoken = Spoken(fourbar())
    for content in (None, "x", {}, {"text": 1}):
        spoken.widget._handle_custom_msg(content, [])
    assert spoken.sent == []
    assert json.loads(spoken.ask(do="nope")[0]["text"])["kind"] == "error"


def test_a_live_model_writes_only_where_it_was_told(tmp_path):
    assert json.loads(Spoken(fourbar()).ask(do="save", name="a.yaml")[0]["text"])["kind"] == "error"
    spoken = Spoken(fourbar(), folder=tmp_path)
    assert json.loads(spoken.ask(do="save", name="a.yaml")[0]["text"])["kind"] == "saved"
    assert [path.name for path in tmp_path.iterdir()] == ["a.yaml"]
    with pytest.raises(kt.InputError, match="no folder"):
        kt.notebook.live(fourbar(), folder=tmp_path / "none")


def test_a_run_is_a_picture_and_what_cannot_be_shown_stays_text():
    from IPython.core.interactiveshell import InteractiveShell

    shell = InteractiveShell()
    kt.load_ipython_extension(shell)
    run = kt.run(fourbar(), "turn")
    data, _ = shell.display_formatter.format(run)
    assert data["text/html"].startswith("<iframe")
    assert "text/plain" in data
    data, _ = shell.display_formatter.format(run.motion)
    assert "iframe" not in data.get("text/html", "")
    assert "<iframe" in kt.notebook.show(run.motion, model=run.model, height=300)._repr_html_()


def test_importing_the_library_loads_no_notebook():
    code = "import sys, kinetruss as kt; kt.Model; assert not {'IPython', 'anywidget', 'fastapi'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


def test_motions_and_forces_are_drawn():
    from IPython.core.interactiveshell import InteractiveShell

    shell = InteractiveShell()
    kt.load_ipython_extension(shell)
    model = fourbar()
    turn = kinematics.follow(model, kt.ConstantRate(rates={"motor": 1.0}, duration=0.2), samples=11)
    rest = kinematics.follow(model, kt.ConstantRate(rates={"motor": 0.0}, duration=0.2), samples=11)
    for result in (turn, dynamics.inverse(model, turn)):
        html = shell.display_formatter.format(result)[0]["text/html"]
        assert html.count("<svg") == 1
        assert f">{type(result).__name__}: " in html
    alone = kinematics.follow(model, kt.ConstantRate(rates={"motor": 0.0}, duration=1.0), times=[0.0])
    assert "<svg" not in shell.display_formatter.format(alone)[0]["text/html"]
    assert histories_svg(rest).count("<svg") == 1  # the drive's position, although nothing moves
