"""``kinetruss view``."""

import json
import webbrowser
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from kinetruss import io, runs
from kinetruss.cli import main
from samples import fourbar


def call(*arguments: object) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A model file, and two runs of it."""
    path = tmp_path_factory.mktemp("view")
    io.write(fourbar(), path / "model.yaml")
    for name in ("one", "two"):
        runs.run(fourbar(), "turn", path / name / "out")
    return path


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Addresses that a browser was asked to open."""
    found: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda address: found.append(address) or True)
    return found


@pytest.mark.slow
def test_a_model_or_a_run_is_written(place, opened):
    for what in (place / "model.yaml", place / "one" / "out"):
        done = call("view", what, "-o", place / "view.html", "--no-open")
        assert (done.exit_code, done.stdout) == (0, f"{place / 'view.html'}\n")
        assert "four-bar" in (place / "view.html").read_text()
    assert opened == []


@pytest.mark.slow
def test_without_a_file_it_is_opened_from_a_temporary_place(place, opened):
    done = call("view", place / "one" / "out", "--json")
    record = json.loads(done.stdout)
    assert (record["schema"], record["opened"]) == ("kinetruss.view/1", True)
    assert opened == [Path(record["file"]).as_uri()]
    assert Path(record["file"]).stat().st_size == record["bytes"]


def test_where_no_browser_starts_the_file_is_named(place, monkeypatch):
    monkeypatch.setattr(webbrowser, "open", lambda _: False)
    done = call("view", place / "model.yaml", "-o", place / "kept.html")
    assert done.exit_code == 0
    assert f"{place / 'kept.html'}\nNo browser" in done.stdout


@pytest.mark.slow
def test_two_runs_beside_each_other_keep_names_that_differ(place):
    done = call("view", place / "one" / "out", "--beside", place / "two" / "out", "-o", place / "both.html", "--no-open")
    assert done.exit_code == 0
    text = (place / "both.html").read_text()
    assert 'data-label="one/out"' in text
    assert 'data-label="two/out"' in text


def test_vibrations_of_a_model_file(place):
    io.write(fourbar(drives={}, runs={}, gravity=(0, -9.81)), place / "free.yaml")
    done = call("view", place / "free.yaml", "--modes", "-o", place / "modes.html", "--no-open")
    assert done.exit_code == 0, done.output
    again = call("view", place / "model.yaml", "--modes", "-o", place / "modes.html", "--no-open")
    assert again.exit_code == 2
    assert "Nothing can move" in again.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("model.yaml", "--no-open"), "-o FILE"),
        (("one/out", "-o", "x.html", "--modes"), "--modes goes with"),
        (("one/out", "-o", "x.html", "--no-open", "--case", "al"), "No load case called 'al'"),
        (("nowhere", "-o", "x.html"), "does not exist"),
        (("one", "-o", "x.html", "--no-open"), "not a kinetruss run"),
        (("model.yaml", "-o", "model.yaml/x.html", "--no-open"), "cannot be written"),
    ],
)
def test_what_cannot_be_done_is_said(place, monkeypatch, arguments, words):
    monkeypatch.chdir(place)
    done = call("view", *arguments)
    assert done.exit_code in (1, 2)
    assert words in done.stderr
