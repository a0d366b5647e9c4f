"""The report on paper, measured: pages are filled, numbers of pages and references are right, fonts are embedded."""

from __future__ import annotations

import html
import re
from dataclasses import dataclass

import pypdf
import pytest

import kinetruss as kt
from kinetruss import report
from kinetruss.report.document import writing as _print
from kinetruss.report.document.writing import read_paper
from kinetruss.runs import load, run
from samples import tripod
from shipped import stored

pytestmark = pytest.mark.slow

SIZES = {"a4": (595.0, 842.0), "letter": (612.0, 792.0)}
TOP, BOTTOM = 16 / 25.4 * 72, 18 / 25.4 * 72
FULL = 0.2
"""Least share of a page that is used."""


@dataclass(frozen=True)
class Printed:
    """A printed report: texts of its pages, the lowest place of text on each above the footer (points), and its HTML."""

    paper: str
    pdf: pypdf.PdfReader
    texts: list[str]
    lowest: list[float]
    page: str


@pytest.fixture(scope="module", params=["a4", "letter"])
def sheets(request, tmp_path_factory) -> Printed:
    if _print.chromium() is None:
        pytest.skip("no chromium on this machine (apt-get install chromium)")
    done = run(tripod()) if request.param == "letter" else load(stored("double_octahedral_slew", "slew"))
    folder = tmp_path_factory.mktemp(request.param)
    block = kt.TitleBlock(project="Tower", author="An Author")
    written = report.write_document(done, folder, paper=request.param, block=block, date="2026-01-02")
    assert written.note == ""
    pdf = pypdf.PdfReader(written.paper)
    texts, lowest = zip(*map(read, pdf.pages), strict=True)
    return Printed(request.param, pdf, list(texts), list(lowest), written.page.read_text("utf-8"))


def read(page: pypdf.PageObject) -> tuple[str, float]:
    """Text of a page, without ligatures, and the lowest place of text above the footer."""
    places = [float(page.mediabox.height)]

    def visit(text: str, cm: list[float], tm: list[float], *_: object) -> None:
        y = cm[1] * tm[4] + cm[3] * tm[5] + cm[5]
        if text.strip() and y > BOTTOM:
            places.append(y)

    text = page.extract_text(visitor_text=visit)
    return text.replace("ﬁ", "fi").replace("ﬂ", "fl").replace("ﬃ", "ffi").replace("ﬀ", "ff"), min(places)


def test_every_page_is_used(sheets):
    height = float(sheets.pdf.pages[0].mediabox.height)
    shares = [(height - TOP - lowest) / (height - TOP - BOTTOM) for lowest in sheets.lowest]
    assert len(shares) > 5
    assert min(shares) > FULL, shares
    assert sum(shares) / len(shares) > 0.7


def test_the_paper_is_that_which_was_asked_for(sheets):
    for page in sheets.pdf.pages:
        assert (float(page.mediabox.width), float(page.mediabox.height)) == pytest.approx(SIZES[sheets.paper], abs=1.5)


def test_contents_name_the_right_pages(sheets):
    listed = re.findall(r'<li><a href="#([^"]*)">(\d+) ([^<]*)</a>', sheets.page)
    assert len(listed) >= 10
    named = sheets.pdf.named_destinations
    for key, count, name in listed:
        number = sheets.pdf.get_destination_page_number(named.get(f"/{key}") or named[key])
        title = html.unescape(name)
        assert re.search(rf"^{count} {re.escape(title)}\s+{number + 1}$", sheets.texts[0], re.MULTILINE), (title, number + 1)
        assert title in sheets.texts[number]


@pytest.mark.slow
def test_fonts_are_embedded(sheets):
    fonts = [font.get_object() for page in sheets.pdf.pages for font in page["/Resources"].get("/Font", {}).values()]
    assert fonts
    for font in fonts:
        inner = font["/DescendantFonts"][0].get_object() if "/DescendantFonts" in font else font
        if font["/Subtype"] == "/Type3":  # drawn by the file itself
            continue
        assert {"/FontFile", "/FontFile2", "/FontFile3"} & set(inner["/FontDescriptor"]), font["/BaseFont"]


def test_figures_and_tables_are_numbered_and_referred_to(sheets):
    page = sheets.page
    for word, kind in (("Table", "table"), ("Figure", "picture")):
        captions = re.findall(rf'<span class="label">{word} (\d+)\. ', page)
        assert captions == [str(k) for k in range(1, len(captions) + 1)]
        assert len(captions) >= 5
        told: set[int] = set()
        for first, link, last in re.findall(
            rf'{word}s? <a href="#{kind}-(\d+)">\1</a>(?:( and | to )<a href="#{kind}-(\d+)">)?', page
        ):
            told |= set(range(int(first), int(last if link else first) + 1))
        assert told == set(map(int, captions))


def test_text_has_one_minus_sign(sheets):
    prose = "\n".join(sheets.texts).partition("The model file (SI units")[0]
    assert "−" in prose
    assert re.findall(r"(?<![\w.)\]-])-\d", prose) == []


def test_the_title_block_has_lines_for_what_is_not_known(sheets):
    front = sheets.texts[0].replace("\n", " ")
    for words in ("Tower", "An Author", "2026-01-02", "signature of the checker"):
        assert words in front
    assert sheets.page.count('class="fill"') == 7  # client, document, revision, checker, date of the check, two signatures


def test_the_result_is_first(sheets):
    lines = [html.unescape(re.sub("<.*?>", "", line)) for line in re.findall('<p class="line">(.*?)</p>', sheets.page)]
    assert len(lines) == 3
    assert lines[0].startswith("Governing: ")
    front = sheets.texts[0].replace("\n", " ")
    place = front.index("1 Result")
    assert front[place : place + 400].replace("1 Result", "").strip().startswith(lines[0][:40])


def test_a_file_written_in_another_way_has_no_pages():
    assert read_paper(b"%PDF-1.7\n1 0 obj\n<</Type /ObjStm>>\nendobj\n%%EOF") == read_paper(b"")
