"""Summaries of one or two sheets, and logos: what is in them, what is refused."""

from __future__ import annotations

import base64
import re
import struct
import zlib

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss import report
from kinetruss.cli import main
from kinetruss.errors import InputError
from kinetruss.report.document.writing import chromium, read_paper
from samples import tripod

SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 9 3">{}</svg>'
GOOD = SVG.format('<defs><linearGradient id="g"/></defs><rect width="9" height="3" fill="url(#g)"/>')


def part(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png(width: int = 4, height: int = 3, rows: int = 3) -> bytes:
    dots = zlib.compress(b"".join(b"\0" + bytes(3 * width) for _ in range(rows)))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", header) + part(b"IDAT", dots) + part(b"IEND", b"")


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_summary_has_result_figure_calculation_and_assumptions(lift):
    page = report.document_page(lift, summary=True, view="<p>three dimensions</p>")
    names = re.findall(r'<h2><span class="count">\d+ </span>(.*?)</h2>', page.html)
    assert names == ["Result", "Structure and loads", "Governing calculation", "Assumptions, and what was not checked"]
    whole = report.document_page(lift)
    assert page.record == whole.record
    assert len(re.findall(r"<h3>Calculation \d", page.html)) == 1 < len(re.findall(r"<h3>Calculation \d", whole.html))
    assert all(line.split(":")[0] in page.html for line in page.record["result"])
    assert "<nav" not in page.html
    assert "three dimensions" not in page.html
    assert 'id="loaded' not in page.html
    assert page.html.count("<figure") >= 3


@pytest.mark.slow
@pytest.mark.parametrize("paper", ["a4", "letter"])
@pytest.mark.skipif(chromium() is None, reason="needs Chromium")
def test_a_summary_takes_at_most_two_sheets(lift, tmp_path, paper):
    written = report.write_document(lift, tmp_path, summary=True, paper=paper, date="2026-11-21")
    assert (written.page.name, written.paper.name) == ("summary.html", "summary.pdf")
    assert 1 <= read_paper(written.paper.read_bytes()).pages <= 2


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_summary_and_report_lie_beside_each_other(lift, tmp_path):
    kt.run(tripod(), "lift", out=tmp_path / "run")
    logo = tmp_path / "logo.svg"
    logo.write_text(GOOD, "utf-8")
    for more in ((), ("--summary", "--logo", str(logo))):
        done = CliRunner().invoke(main, ["report", str(tmp_path / "run"), "--no-open", "--no-pdf", "--no-view", *more])
        assert done.exit_code == 0, done.output
    assert {path.name for path in (tmp_path / "run" / "report").iterdir()} == {"report.html", "summary.html"}
    text = (tmp_path / "run" / "report" / "summary.html").read_text("utf-8")
    assert f"data:image/svg+xml;base64,{base64.b64encode(GOOD.encode()).decode()}" in text
    assert str(tmp_path) not in text


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_png_is_embedded(lift, tmp_path):
    file = tmp_path / "logo.png"
    file.write_bytes(png())
    page = report.document_page(lift, logo=file).html
    assert f'src="data:image/png;base64,{base64.b64encode(png()).decode()}"' in page


BAD = {
    "is neither PNG nor SVG": b"GIF89a....",
    "no SVG": b"<html/>",
    "has no size": b'<svg xmlns="http://www.w3.org/2000/svg"/>',
    "a script element": SVG.format("<script>1</script>").encode(),
    "has the script 'onload'": SVG.format('<g onload="x()"/>').encode(),
    "refers to 'https://x": SVG.format('<image href="https://x.org/a.png"/>').encode(),
    "refers to 'file:": SVG.format('<use xlink:href="file:///etc/passwd#a"/>').encode(),
    "refers to another file": SVG.format('<rect fill="url(https://x.org/#a)"/>').encode(),
    "has a style": SVG.format("<style>@import 'a.css';</style>").encode(),
    "declares entities": b'<!DOCTYPE svg [<!ENTITY a "b">]>' + GOOD.encode(),
    "another checksum": png().replace(b"IDAT", b"IDAU"),
    "dots are missing": png(rows=2),
    "is not complete": png()[:-12],
    "has 0 bytes": b"",
    "has 1,000,001 bytes": bytes(1_000_001),
    "5000 by 1 dots": png(5000, 1, 1),
}


@pytest.mark.parametrize("words", BAD)
def test_a_logo_that_cannot_be_used_is_refused(words, lift, tmp_path):
    file = tmp_path / "logo"
    file.write_bytes(BAD[words])
    with pytest.raises(InputError, match=re.escape(words)):
        report.document_page(lift, logo=file)


def test_a_logo_that_is_not_there(lift, tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        report.document_page(lift, logo=tmp_path / "none.png")
