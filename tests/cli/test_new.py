"""``kinetruss new``, and ``kinetruss`` alone."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main


def call(*arguments: object):
    return CliRunner().invoke(main, [str(one) for one in arguments])


def test_alone_it_says_what_to_try_first():
    done = call()
    assert done.exit_code == 0
    assert "kinetruss new leg --like four_bar" in done.stdout
    for line in done.stdout.splitlines():
        if line.startswith("  kinetruss ") and "-h" not in line:
            assert line.split()[1] in main.commands


@pytest.mark.slow
@pytest.mark.parametrize("name", kt.library.example_files())
def test_a_new_model_is_the_example_under_its_own_title(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert call("new", "mine", "--like", name).exit_code == 0
    made = kt.read("mine.yaml")
    example = kt.read(kt.library.example_files()[name][0])
    assert made.with_(title=example.title) == example
    assert made.title == "mine"
    text = Path("mine.yaml").read_text("utf-8")
    assert all(field.description is None or text.count(field.description) <= 1 for field in kt.Model.model_fields.values())


def test_every_table_has_a_comment(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    call("new", "leg")
    lines = Path("leg.yaml").read_text("utf-8").splitlines()
    tables = [k for k, line in enumerate(lines) if line[:1].isalpha()]
    assert len(tables) >= 9
    assert all(lines[k - 1].startswith("#") for k in tables)


def test_no_file_is_replaced(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("leg.yaml").write_text("mine")
    done = call("new", "leg")
    assert done.exit_code == 2
    assert "exists already" in done.stderr
    assert Path("leg.yaml").read_text() == "mine"
    assert "No example or mechanism called 'leeg'" in call("new", "other", "--like", "leeg").stderr
    assert "Did you mean 'four_bar'" in call("new", "other", "--like", "fourbar").stderr
    assert not Path("other.yaml").exists()


def test_a_mechanism_of_the_library_becomes_a_model_that_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert call("new", "press", "--like", "slider_crank").exit_code == 0
    made = kt.read("press.yaml")
    built = kt.library.mechanisms.slider_crank()
    assert made.with_(title="Slider-crank", runs={}, nodes=built.nodes) == built
    turned = kt.run(made).motion.drive_position.sel(drive="motor")
    assert float(turned[-1] - turned[0]) == pytest.approx(6.283185307179586, abs=1e-9)
    assert call("new", "hook", "--like", "mechanisms.bricard").exit_code == 0


MECHANISMS = [name for name in kt.library.builders() if name.startswith("mechanisms.")]


@pytest.mark.slow
@pytest.mark.parametrize("name", MECHANISMS)
def test_round_off_of_a_mechanism_is_written_as_zero(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert call("new", "mine", "--like", name).exit_code == 0
    assert not re.search(r"\de-1[3-9]", Path("mine.yaml").read_text("utf-8"))
    made, built = kt.read("mine.yaml"), kt.library.build(name)
    assert made.with_(title=built.title, runs=built.runs, nodes=built.nodes) == built
    for node, one in built.nodes.items():
        assert made.nodes[node].at == pytest.approx(one.at, rel=1e-15, abs=1e-14)
        assert made.nodes[node].with_(at=one.at) == one


def test_as_json(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = json.loads(call("new", "gauges", "--like", "strain_gauges", "--json").stdout)
    assert all(Path(file).is_file() for file in done["files"])
    assert len(done["files"]) == 3


def test_editors_find_the_schema(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    call("new", "leg")
    call("examples", "delta", "--copy", ".")
    for file in ("leg.yaml", "delta.yaml"):
        first = Path(file).read_text("utf-8").splitlines()[0]
        address = first.removeprefix("# yaml-language-server: $schema=")
        assert (
            Path.from_uri(address) == kt.io.schema_file()
            if hasattr(Path, "from_uri")
            else address == kt.io.schema_file().as_uri()
        )
    for name, (file, *_) in kt.library.example_files().items():
        first = file.read_text("utf-8").splitlines()[0]
        assert (file.parent / first.removeprefix("# yaml-language-server: $schema=")).resolve() == kt.io.schema_file(), name
