"""What the README and the documentation say is so."""

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").glob("*.md")])


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


def test_the_first_example_prints_what_it_says(capsys):
    (code,) = blocks("python")
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out.splitlines() == re.findall(r"^print\(.*# (.*)$", code, re.MULTILINE)


def test_the_file_is_the_same_model_as_the_first_example(tmp_path):
    (text,) = blocks("yaml")
    (tmp_path / "fourbar.yaml").write_text(text)
    (code,) = blocks("python")
    names: dict[str, object] = {}
    exec(compile(code, "README.md", "exec"), names)
    read = kt.read(tmp_path / "fourbar.yaml")
    made = names["fourbar"]
    assert isinstance(made, kt.Model)
    assert (read.nodes, read.bars, read.fixed, read.drives) == (made.nodes, made.bars, made.fixed, made.drives)


def test_every_command_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fourbar.yaml").write_text(blocks("yaml")[0])
    commands = [line for block in blocks("console") for line in block.splitlines()]
    assert len(commands) > 10
    for line in commands:
        prompt, program, *arguments = shlex.split(line, comments=True)
        assert (prompt, program) == ("$", "kinetruss")
        done = CliRunner().invoke(main, arguments)
        assert done.exit_code == 0, f"{line}\n{done.output}"


def test_every_verb_is_named_in_the_readme():
    for verb in main.commands:
        assert f"kinetruss {verb}" in README


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_and_pictures_are_there(page):
    for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", page.read_text(encoding="utf-8")):
        assert (page.parent / target).exists(), target


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_modules_that_pages_name_are_there(page):
    for target in re.findall(r"`(kinetruss/[\w/.]+)`", page.read_text(encoding="utf-8")):
        assert (ROOT / "src" / target).exists(), target


def test_result_names_of_the_notation_are_real():
    short = kt.Run(trajectory=kt.Quintic(moves={"M7": (1.17, 1.18)}, duration=1.0), samples=5, load_cases=("loaded",))
    run = kt.runs.run(kt.read(kt.library.example_files()["measured_slew"][0]).with_(runs={"short": short}))
    case = run.forces["loaded"]
    known = {str(name) for data in (run.motion.data, case.data, run.sections["loaded"].data) for name in data.data_vars}
    known |= {str(name) for name in run.verdict.data.data_vars} | set(kt.LeadScrew.model_fields)
    lin = kt.dynamics.linearise(kt.library.mechanisms.rhombus_with_spring(), inputs="spring")
    loop = kt.dynamics.feedback(lin, poles=[-1, -2])
    path = kt.statics.path(kt.library.mechanisms.von_mises(load=1.0), "load", points=3)
    order = kt.kinematics.transfer_functions(kt.library.mechanisms.rhombus_with_spring())
    known |= {str(name) for data in (lin.data, loop.data, path.data, order) for name in data.data_vars}
    known.add(lin.transmissibility(1.0).name)
    table = (ROOT / "docs" / "notation.md").read_text(encoding="utf-8")
    first = [line.split("|")[1] for line in table.splitlines() if line.startswith("| `")]
    for name in re.findall(r"`([a-z]\w+)`", " ".join(first)):
        assert name in known, name
