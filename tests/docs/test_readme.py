"""What the README and the documentation say is so."""

import os
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml
from click.testing import CliRunner
from pydantic import TypeAdapter

import kinetruss as kt
from kinetruss.cli import main

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
SITE = sorted(page for page in (ROOT / "docs").rglob("*.md") if "made" not in page.parts)
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *SITE]


def named(page: Path) -> str:
    """A page by its path."""
    return str(page.relative_to(ROOT))


def blocks(language: str, text: str = README) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


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


@pytest.mark.parametrize("page", ["README.md", "docs/commands.md"])
def test_every_command_runs_as_printed(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fourbar.yaml").write_text(blocks("yaml")[0])
    text = (ROOT / page).read_text(encoding="utf-8")
    lines = [line.removeprefix("$ ") for block in blocks("console", text) for line in block.splitlines()]
    assert len(lines) > 10
    for line in lines:
        command, *arguments = shlex.split(line, comments=True)
        assert command == "kinetruss"
        done = CliRunner().invoke(main, arguments)
        assert done.exit_code == 0, f"{line}\n{done.output[-2000:]}"


def test_the_activation_that_the_readme_prints_makes_the_command_known(tmp_path):
    """In a plain shell, where nothing else does."""
    (tmp_path / ".venv").symlink_to(sys.prefix)
    (activation,) = set(re.findall(r"\. \.venv/bin/activate", README))
    script, home = f"set -e\n{activation}\nkinetruss --version\n", {"HOME": str(tmp_path), "PATH": os.defpath}
    done = subprocess.run(["sh", "-c", script], cwd=tmp_path, env=home, capture_output=True, text=True, check=False)
    assert done.stdout.startswith("kinetruss"), done.stderr


def test_what_is_printed_after_make_demo_needs_the_activation_that_is_printed_with_it():
    first = re.search(r"^    make demo\b(?:.*\n)((?:    .*\n)+)", README, re.MULTILINE)
    assert first is not None
    assert "kinetruss " in first[1]
    assert ". .venv/bin/activate" in first[0][: first[0].index("kinetruss ")]
    installation = (ROOT / "docs" / "installation.md").read_text(encoding="utf-8")
    for word in (". .venv/bin/activate", "make shell", ".venv/bin/kinetruss"):
        assert word in installation
    assert re.search(r"^shell:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)


def test_every_verb_is_named_on_the_page_of_commands():
    text = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    for verb in main.commands:
        assert f"kinetruss {verb}" in text


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_links_and_pictures_are_there(page):
    for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", page.read_text(encoding="utf-8")):
        assert "made/" in target or (page.parent / target).exists(), target  # `make docs` checks links to what it makes


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_modules_that_pages_name_are_there(page):
    for target in re.findall(r"`(kinetruss/[\w/.]+)`", page.read_text(encoding="utf-8")):
        assert (ROOT / "src" / target).exists(), target


def test_result_names_of_the_notation_are_real():
    short = kt.Run(trajectory=kt.Quintic(moves={"M7": (1.17, 1.18)}, duration=1.0), samples=5, load_cases=("loaded",))
    run = kt.runs.run(kt.read(kt.library.example_files()["measured_slew"][0]).with_(runs={"short": short}))
    case = run.forces["loaded"]
    known = {str(name) for data in (run.motion.data, case.data, run.sections["loaded"].data) for name in data.data_vars}
    known |= {str(name) for name in run.verdict.data.data_vars} | set(kt.LeadScrew.model_fields)
    cranked = kt.runs.run(kt.read(kt.library.example_files()["four_bar"][0]))  # its motor turns a bar
    known |= {str(name) for name in cranked.forces["all"].data.data_vars}
    lin = kt.dynamics.linearise(kt.library.mechanisms.rhombus_with_spring(), inputs="spring")
    loop = kt.dynamics.feedback(lin, poles=[-1, -2])
    path = kt.statics.path(kt.library.mechanisms.von_mises(load=1.0), "load", points=3)
    order = kt.kinematics.transfer_functions(kt.library.mechanisms.rhombus_with_spring())
    known |= {str(name) for data in (lin.data, loop.data, path.data, order) for name in data.data_vars}
    known.add(lin.transmissibility(1.0).name)
    turned = kt.read(kt.library.example_files()["four_bar"][0])
    known |= {str(name) for name in kt.statics.at_poses(turned, [{}]).data.data_vars}
    sprung = kt.Spring(coordinate=kt.LengthDrive("b"), stiffness=2.0)
    hung = kt.Model(
        nodes={"A": (0, 0), "B": (0, -1)}, fixed={"A": "xy", "B": "x"}, springs={"s": sprung},
        bars={"b": kt.Bar(ends=("A", "B"), kind="free", mass=1.0)}, gravity=(0, -9.81),
    )  # fmt: skip
    known |= {str(name) for name in kt.statics.equilibrium(hung).data.data_vars}
    cantilever = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], beams={"b": ("A", "B")}, section=kt.Rod(diameter=0.01),
        material="steel_s235", loads={"F": kt.NodalForce(node="B", force=(0, -1))},
    )  # fmt: skip
    known |= {str(name) for name in kt.statics.linear(cantilever).data.data_vars}
    clamp = kt.Support(x="held", y="held", z="held", rotation="held", along=(1, 1, 0))
    leaning = cantilever.with_(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0)}, clamped=[], supports={"A": clamp},
        loads={"F": kt.NodalForce(node="B", force=(0, -1, 0))},
    )  # fmt: skip
    known |= {str(name) for name in kt.statics.linear(leaning).data.data_vars}
    table = (ROOT / "docs" / "notation.md").read_text(encoding="utf-8")
    first = [line.split("|")[1] for line in table.splitlines() if line.startswith("| `")]
    for name in re.findall(r"`([a-z]\w+)`", " ".join(first)):
        assert name in known, name


def code_of(page: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_verbs_and_options_that_pages_name_are_there(page):
    for line in re.findall(r"(?:^|`|\$ |    )(kinetruss [a-z][^\n`]*)", page.read_text(encoding="utf-8"), re.MULTILINE):
        verb = main.commands[line.split()[1]]
        known = {"-h", "--help"}.union(*(parameter.opts + parameter.secondary_opts for parameter in verb.params))
        for option in re.findall(r"(?<![\w-])--?[a-z][\w-]*", line.partition("#")[0]):
            assert option in known, line


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_names_in_python_that_pages_name_are_there(page):
    for name in re.findall(r"\bkt\.([A-Za-z_][\w.]*\w)", page.read_text(encoding="utf-8")):
        found = kt
        for part in name.split("."):
            found = getattr(found, part)


OTHER = ("kinetruss", "source:")
"""How whole models and missions, and catalogues, can be told from parts of models."""
FRAGMENTS = [(page, text) for page in PAGES for text in code_of(page, "yaml") if not any(word in text for word in OTHER)]


@pytest.mark.parametrize(("page", "text"), FRAGMENTS, ids=[f"{page.stem}-{k}" for k, (page, _) in enumerate(FRAGMENTS)])
def test_parts_of_model_files_in_pages_are_sound(page, text):
    """Each table by itself: what its entries rest on stands in other tables."""
    for table, entries in yaml.load(text, yaml.BaseLoader).items():
        TypeAdapter(kt.Model.model_fields[table].rebuild_annotation()).validate_python(entries)


def test_the_mission_of_the_page_on_design_is_sound():
    mission, _ = code_of(ROOT / "docs" / "design.md", "yaml")
    assert kt.Mission(**yaml.load(mission, yaml.BaseLoader)).margin == 1.25


def test_the_catalogue_of_the_page_on_design_is_sound(tmp_path):
    _, text = code_of(ROOT / "docs" / "design.md", "yaml")
    (tmp_path / "own.yaml").write_text(text, encoding="utf-8")
    found = kt.io.read_catalogue(tmp_path / "own.yaml")
    assert set(found.tubes) and found.source.startswith("Price list")


def test_the_layers_of_contributing_are_those_of_the_contract():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    (line,) = re.findall(r"^    (cli.*errors.*)$", text, re.MULTILINE)
    contract = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"][0]
    told = [sorted(one.strip() for one in layer.split(",")) for layer in line.split("|")]
    assert told == [sorted(re.findall(r"\w+", layer)) for layer in contract["layers"]]
