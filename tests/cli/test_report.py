"""``kinetruss report``."""

import json
import re
import webbrowser
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from kinetruss import runs
from kinetruss.cli import main
from kinetruss.report.document import writing as _print
from kinetruss.results.folder import REPORT
from samples import fourbar


def call(*arguments: object) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture(scope="module")
def turn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("report") / "turn"
    runs.run(fourbar(), "turn", path)
    return path


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Addresses that a browser was asked to open."""
    found: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda address: found.append(address) or True)
    return found


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_report_holds_the_view_and_is_named(turn, tmp_path, opened):
    done = call("report", turn, "-o", tmp_path / "out", "--no-open", "--no-pdf")
    page = tmp_path / "out" / "report.html"
    assert (done.exit_code, done.stderr) == (0, "")
    first, over, checked, *rest = done.stdout.splitlines()
    assert first.startswith("Governing: yield of crank, ")
    assert over.startswith("None of the ")
    assert checked == "Strength checked by every rule: all 3 parts."
    assert rest == [str(page)]
    text = page.read_text()
    assert [re.sub("<.*?>", "", line) for line in re.findall('<p class="line">(.*?)</p>', text)] == [first, over, checked]
    assert "kinetruss-scene" in text
    assert "four-bar" in text
    assert opened == []


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_without_a_folder_it_goes_into_the_run_and_opens(turn, opened):
    done = call("report", turn, "--no-pdf", "--no-view", "--json")
    record = json.loads(done.stdout)
    page = turn / REPORT / "report.html"
    assert len(record.pop("result")) == 3
    assert record == {"schema": "kinetruss.report/1", "html": str(page), "pdf": None, "note": "", "whole": True, "opened": True}
    assert opened == [page.as_uri()]
    assert "kinetruss-scene" not in page.read_text()


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_without_chromium_it_says_why_there_is_no_paper(turn, tmp_path, monkeypatch):
    monkeypatch.setattr(_print, "chromium", lambda: None)
    done = call("report", turn, "-o", tmp_path, "--no-view", "--no-open")
    assert done.exit_code == 0
    assert done.stdout.splitlines()[3:] == [f"{tmp_path / 'report.html'}"]
    assert "No PDF: no Chromium was found" in done.stderr


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_where_no_browser_starts_it_says_so(turn, tmp_path, monkeypatch):
    monkeypatch.setattr(webbrowser, "open", lambda _: False)
    done = call("report", turn, "-o", tmp_path, "--no-view", "--no-pdf")
    assert done.exit_code == 0
    assert "No browser could be started" in done.stderr


def test_what_is_no_run_is_refused(tmp_path):
    assert call("report", tmp_path / "none").exit_code == 2
    done = call("report", tmp_path, "--no-open", "--json")
    assert done.exit_code == 1
    assert json.loads(done.stdout)["schema"] == "kinetruss.error/1"
