"""What a notebook shows, in a browser: the picture of a run, and a live model with the front end of its widget."""

from __future__ import annotations

import base64
import json
import time
from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import dynamics, kinematics
from samples import tripod

pytestmark = pytest.mark.slow

WAIT = 60_000  # ms

HOST = """
<!doctype html><html><body><div id="cell"></div><script type="module">
const module = await import("data:text/javascript;base64,FRONT");
const heard = [];
const model = {
  get: (name) => ({ page: window.given.page, height: 600 })[name],
  on: (_, action) => heard.push(action),
  off: () => {},
  send: async (message) => {
    const [content, bytes] = JSON.parse(await window.kernel(JSON.stringify(message)));
    const buffers = bytes === null ? [] : [new DataView(Uint8Array.from(atob(bytes), (sign) => sign.charCodeAt(0)).buffer)];
    for (const action of heard) action(content, buffers);
  },
};
window.start = (page) => {
  window.given = { page };
  module.default.render({ model, el: document.getElementById("cell") });
};
window.loaded = true;
</script></body></html>
"""


@pytest.fixture
def tab(browser):
    context = browser.new_context(viewport={"width": 1100, "height": 700})
    page = context.new_page()
    page.complaints = []
    page.on("console", lambda message: page.complaints.append(message.text))
    page.on("pageerror", lambda error: page.complaints.append(str(error)))
    yield page
    context.close()


def inside(page):
    """The frame in which the picture is, once it is ready."""
    handle = page.wait_for_selector("iframe", timeout=WAIT)
    frame = handle.content_frame()
    frame.wait_for_selector("#kinetruss[data-state=ready]", timeout=WAIT)
    return frame


def until(page, true) -> None:
    end = time.monotonic() + WAIT / 1000
    while not true():
        assert time.monotonic() < end
        page.wait_for_timeout(20)


def test_the_picture_of_a_run_moves_in_its_frame(tab, lift, tmp_path: Path):
    path = tmp_path / "cell.html"
    path.write_text(f"<!doctype html><html><body>{kt.notebook.show(lift)._repr_html_()}</body></html>", encoding="utf-8")
    tab.goto(path.as_uri())
    frame = inside(tab)
    assert frame.evaluate("kinetruss.app.lead.frames") == len(lift.motion.time)
    frame.evaluate("kinetruss.app.goTo(10)")
    told = frame.evaluate("kinetruss.app.views[0].scene.value('force', 10, 0)")
    assert told == pytest.approx(float(lift.forces["standing"].data["member_force"].values[10, 0]), rel=1e-6)
    assert tab.complaints == []


def test_a_live_model_answers_its_sliders(tab, tmp_path: Path):
    widget = kt.notebook.live(tripod())
    sent = []
    widget.send = lambda content, buffers=None: sent.append((content, buffers or []))

    def kernel(text: str) -> str:
        widget._handle_custom_msg(json.loads(text), [])
        content, buffers = sent.pop()
        return json.dumps([content, base64.b64encode(buffers[0]).decode() if buffers else None])

    tab.expose_function("kernel", kernel)
    path = tmp_path / "host.html"
    path.write_text(HOST.replace("FRONT", base64.b64encode(widget._esm.encode()).decode()), encoding="utf-8")
    tab.goto(path.as_uri())
    until(tab, lambda: tab.evaluate("window.loaded || false"))
    tab.evaluate("(page) => start(page)", widget.page)
    frame = inside(tab)
    slider = frame.locator('[data-drive="LA"] input[type=range]')
    slider.evaluate("(node) => { node.value = 1.2; node.dispatchEvent(new Event('input', { bubbles: true })); }")
    until(tab, lambda: frame.evaluate("!kinetruss.live.waiting && !kinetruss.live.wanted"))
    assert widget.values["LA"] == pytest.approx(1.2, abs=3e-4)
    x = kinematics.assemble(tripod(), widget.values)
    motion = kinematics.from_arrays(tripod(), [0.0], x[None], 0 * x[None], 0 * x[None])
    wanted = dynamics.inverse(tripod(), motion, static=False).data["member_force"].values[0]
    told = frame.evaluate(
        "kinetruss.app.views[0].scene.members.map((_, k) => kinetruss.app.views[0].scene.value('force', 0, k))"
    )
    np.testing.assert_allclose(told, wanted, rtol=1e-6)
    assert tab.complaints == []
