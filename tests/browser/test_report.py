"""The report of a run in a browser and on paper."""

from __future__ import annotations

import io
import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from pypdf import PdfReader

from kinetruss import report, viewer
from kinetruss.display import aligned, quantity
from kinetruss.display.browser import PAPER, Browser, chromium
from kinetruss.display.tables import PLAIN
from kinetruss.results import Status
from kinetruss.runs import RunResult

pytestmark = pytest.mark.slow

WAIT = 60.0  # s, for a machine that is busy with other things


@pytest.fixture(scope="module")
def written(tmp_path_factory, lift):
    """A report with its view, on paper too."""
    view = viewer.page(viewer.scene(lift))
    return report.write_document(lift, tmp_path_factory.mktemp("report"), view=view, date="today")


class Opened:
    """A report in a page; what it asked the network for, and what it complained about."""

    def __init__(self, browser, path: Path, width: int, scheme: str) -> None:
        self.requests: list[str] = []
        self.complaints: list[str] = []
        self.context = browser.new_context(viewport={"width": width, "height": 800}, color_scheme=scheme)
        self.page = self.context.new_page()
        self.page.on("console", lambda message: self.complaints.append(message.text))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.route("**/*", lambda route: self._judge(route, path.as_uri()))
        self.page.goto(path.as_uri())

    def _judge(self, route, address: str) -> None:
        if route.request.url == address:
            route.continue_()
        else:
            self.requests.append(route.request.url)
            route.abort()

    def viewed(self):
        """The frame of the view, when it is ready."""
        self.page.locator("iframe").scroll_into_view_if_needed()
        frame = self.page.locator("iframe").element_handle().content_frame()
        frame.wait_for_selector("#kinetruss[data-state]", timeout=1000 * WAIT)
        return frame

    def pixels(self, **options) -> np.ndarray:
        return np.asarray(Image.open(io.BytesIO(self.page.screenshot(**options))).convert("RGB")).astype(int)


@pytest.fixture
def opened(browser):
    found = []

    def given(path: Path, width: int = 1000, scheme: str = "light") -> Opened:
        found.append(Opened(browser, path, width, scheme))
        return found[-1]

    yield given
    for one in found:
        one.context.close()


def test_nothing_leaves_the_page_and_the_view_shows_the_run(opened, written, lift):
    shown = opened(written.page)
    frame = shown.viewed()
    assert frame.locator("#kinetruss").get_attribute("data-state") == "ready"
    force = frame.evaluate("[...window.kinetruss.app.views[0].scene.arrays.member_force.data]")
    assert force == lift.forces["standing"].data["member_force"].values.astype("f4").reshape(-1).astype(float).tolist()
    canvas = shown.page.locator("iframe").bounding_box()
    picture = shown.pixels(clip=canvas)
    assert (np.abs(picture - picture[5, 5]).max(axis=2) > 40).mean() > 0.01  # not blank
    record = json.loads(shown.page.locator("#kinetruss-report").text_content())
    assert record == report.document_page(lift).record
    assert (shown.requests, shown.complaints) == ([], [])


def test_figures_are_drawn_in_the_ink_of_the_page(opened, written):
    for scheme, dark in (("light", False), ("dark", True)):
        shown = opened(written.page, scheme=scheme)
        assert shown.page.locator("figure.picture svg").count() >= 5
        for figure in shown.page.locator("#forces figure.picture svg, #drives figure.picture svg").all():
            figure.scroll_into_view_if_needed()
            box = figure.bounding_box()
            picture = shown.pixels(clip={**box, "height": min(box["height"], 300)})
            paper = picture[2, 2]
            assert (paper.mean() < 60) == dark
            assert (np.abs(picture - paper).max(axis=2) > 60).mean() > 0.01
            text = figure.locator("text").first
            assert text.evaluate("(one) => getComputedStyle(one).fill") == ("rgb(228, 230, 233)" if dark else "rgb(34, 34, 34)")


@pytest.mark.parametrize("width", [1280, 700, 360])
def test_nothing_overlaps_or_sticks_out(opened, written, width):
    shown = opened(written.page, width)
    page = shown.page
    assert page.evaluate("document.scrollingElement.scrollWidth") <= width
    boxes = page.evaluate(
        "[...document.querySelectorAll('main > *, section > *')].filter((one) => one.offsetParent && !one.querySelector('h2'))"
        ".map((one) => one.getBoundingClientRect()).map((box) => [box.left, box.top, box.right, box.bottom])"
    )
    assert all(left >= 0 and right <= width for left, _, right, _ in boxes)
    order = sorted(boxes, key=lambda box: box[1])
    assert all(below[1] >= above[3] - 0.5 for above, below in pairwise(order))
    outside = page.evaluate(
        "[...document.querySelectorAll('td, th')].filter((one) => one.scrollWidth > one.clientWidth + 1)"
        ".map((one) => one.innerText)"
    )
    assert outside == []


def test_on_paper_are_all_tables_and_a_still_picture(written, lift):
    assert written.note == ""
    paper = PdfReader(written.paper)
    pages = [one.extract_text() for one in paper.pages]
    text = " ".join(" ".join(pages).split())
    box = paper.pages[0].mediabox
    assert (float(box.width), float(box.height)) == pytest.approx((595, 842), abs=1)  # A4
    assert len(pages) > 4
    for k, one in enumerate(pages):
        assert f"{k + 1} / {len(pages)}" in one
    record = report.document_page(lift).record
    captions = (
        "What was computed", "Mobility of the model", "Envelope of member forces, load case pushed",
        "Worst members, each by its governing rule",
        "Demands on the actuators against their limits", "What was checked", "Provenance",
    )  # fmt: skip
    for caption in captions:
        assert caption in text
    squeezed = text.replace(" ", "").replace("−", "-")
    for case in record["envelopes"].values():
        for least in aligned([quantity(one["least"], "N") for one in case]):
            assert least.translate(PLAIN).split()[0] in squeezed  # the unit stands in the heading
    assert record["model_sha256"] in squeezed
    assert "shape, driven members green" in text
    assert "press ? for its keys" not in text
    assert "time (s)" in text  # words of pictures are words


def test_heads_of_long_tables_come_again_on_each_page(tmp_path, lift):
    text = report.document_page(lift).html
    row = text[text.index("<tr><td") : text.index("</tr>", text.index("<tr><td")) + 5]
    head = "<table><thead><tr><th>REPEATED</th></tr></thead><tbody>"
    long = f'<figure class="table"><div class="scroll">{head}{row * 200}</tbody></table></div></figure>'
    (tmp_path / "long.html").write_text(text.replace("</main>", f"{long}</main>"))
    with Browser(chromium(), PAPER) as printer:
        pages = [one.extract_text() for one in PdfReader(io.BytesIO(printer.paper(tmp_path / "long.html"))).pages]
    assert sum("REPEATED" in one for one in pages) >= 3


def test_a_run_that_is_not_whole_says_so_on_every_page(tmp_path, lift):
    half = lift.motion.with_(data=lift.motion.data.isel(time=slice(0, 10)))
    early = RunResult(model=lift.model, name="lift", motion=half, samples=41, status=Status.SINGULAR, message="It was flat.")
    done = report.write_document(early, tmp_path)
    for one in PdfReader(done.paper).pages:
        assert "NOT COMPLETE" in one.extract_text()
