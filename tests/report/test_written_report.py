"""A report as files."""

import sys
from pathlib import Path

import pytest

from kinetruss import report
from kinetruss.display import browser
from kinetruss.errors import StoreError
from kinetruss.report.document import writing
from kinetruss.results.folder import REPORT
from kinetruss.runs import run
from samples import fourbar

PDF = b"%PDF-1.4\n...\n%%EOF\n"


ANSWERS = """#!{python}
import base64, json, os, sys
open("{folder}/words", "w").write(" ".join(sys.argv))
def tell(message):
    os.write(4, json.dumps(message).encode() + b"\\0")
asked = b""
while piece := os.read(3, 65536):
    *whole, asked = (asked + piece).split(b"\\0")
    for one in map(json.loads, whole):
        data = base64.b64encode({printed!r}).decode()
        tell({{"id": one["id"], "result": {{"targetId": "a", "sessionId": "b", "data": data}}}})
        if one["method"] == "Page.navigate":
            tell({{"method": "Page.loadEventFired"}})
"""
"""A program that stands in for Chromium: it answers every request, and prints always the same."""


def program(folder: Path, script: str) -> str:
    path = folder / "browser"
    path.write_text(script)
    path.chmod(0o755)
    return str(path)


def printing(folder: Path, printed: bytes) -> str:
    return program(folder, ANSWERS.format(python=sys.executable, folder=folder, printed=printed))


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_page_and_paper_are_written_whole(turn, tmp_path, monkeypatch):
    found = printing(tmp_path, PDF)
    monkeypatch.setattr(writing, "chromium", lambda: found)
    done = report.write_document(turn, tmp_path / "deep" / "report", view="<p>view", date="today")
    assert (done.page.name, done.paper, done.note) == ("report.html", tmp_path / "deep" / "report" / "report.pdf", "")
    assert done.page.read_text() == report.document_page(turn, view="<p>view", date="today").html
    assert done.paper.read_bytes() == PDF
    assert sorted(path.name for path in done.page.parent.iterdir()) == ["report.html", "report.pdf"]
    assert "--host-resolver-rules" in (tmp_path / "words").read_text()  # no network while printing


@pytest.mark.slow
@pytest.mark.parametrize(
    ("script", "words"),
    [
        ("#!/bin/sh\nexit 3", "failed (it ended)"),
        ("#!/bin/sh\necho no screen >&2; exit 1", "failed (no screen)"),
        ("", "failed (what it printed is not whole)"),
        ("#!/bin/sh\nexec sleep 30", "did not answer within 0.2 s"),
    ],
)
@pytest.mark.usefixtures("undrawn")
def test_paper_that_is_not_whole_is_not_kept(turn, tmp_path, monkeypatch, script, words):
    found = program(tmp_path, script) if script else printing(tmp_path, b"%PDF-1.4 half")
    monkeypatch.setattr(writing, "chromium", lambda: found)
    if "sleep" in script:
        monkeypatch.setattr(browser, "PATIENCE", 0.2)
        monkeypatch.setattr(browser, "LEAVE", 0.1)
    place = tmp_path / "report"
    place.mkdir()
    (place / "report.pdf").write_bytes(PDF)  # of an earlier run
    done = report.write_document(turn, place)
    assert done.paper is None
    assert words in done.note
    assert "Print" in done.note
    assert [path.name for path in place.iterdir()] == ["report.html"]


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_without_chromium_the_page_is_written_all_the_same(turn, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(browser, "PLACES", ())
    done = report.write_document(turn, tmp_path)
    assert done.paper is None
    assert "no Chromium was found" in done.note
    assert "apt-get install chromium" in done.note
    assert done.page.is_file()


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_program_that_cannot_be_started_is_told(turn, tmp_path, monkeypatch):
    (tmp_path / "browser").write_text("no program")
    monkeypatch.setattr(writing, "chromium", lambda: str(tmp_path / "browser"))
    assert "cannot be started" in report.write_document(turn, tmp_path).note


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_an_old_report_stays_when_the_new_one_fails(turn, tmp_path, monkeypatch):
    report.write_document(turn, tmp_path, pdf=False)
    before = (tmp_path / "report.html").read_bytes()

    def failing(draft: Path, text: str, **_: object) -> None:
        draft.write_bytes(text[:1000].encode())
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_text", failing)
    with pytest.raises(StoreError, match="cannot be written"):
        report.write_document(turn, tmp_path, pdf=False)
    assert (tmp_path / "report.html").read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]


@pytest.mark.slow
def test_a_place_that_is_a_file_is_refused(turn, tmp_path):
    (tmp_path / "taken").write_text("")
    with pytest.raises(StoreError, match="taken"):
        report.write_document(turn, tmp_path / "taken", pdf=False)


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_run_done_again_has_no_old_report(tmp_path):
    for _ in range(2):
        run(fourbar(), out=tmp_path / "run", overwrite=True)
        assert not (tmp_path / "run" / REPORT).exists()
        report.write_document(run(fourbar()), tmp_path / "run" / REPORT, pdf=False)
