"""What the tab key offers, as the scripts of the shells ask for it."""

import json

import pytest
from click.shell_completion import get_completion_class
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.report.pictures import quantities
from samples import tripod

SHELLS = ("bash", "zsh", "fish")


def offered(*words: str) -> list[str]:
    """Completions of the last word."""
    shell = get_completion_class("bash")(main, {}, "kinetruss", "_KINETRUSS_COMPLETE")
    return [one.value for one in shell.get_completions(list(words[:-1]), words[-1])]


@pytest.fixture
def model(tmp_path):
    return str(kt.write(tripod(), tmp_path / "tripod.yaml"))


def test_models_to_begin_with_are_the_examples_and_the_mechanisms_of_the_library():
    assert offered("new", "x", "--like", "st") == ["stewart", "strain_gauges", "stephenson_six_bar"]
    every = offered("new", "x", "--like", "")
    assert set(kt.library.example_files()) <= set(every)
    for name in ("slider_crank", "watt_six_bar"):
        assert name in every
    assert offered("examples", "double_oct") == ["double_octahedral_slew"]


def test_quantities_are_those_that_are_drawn():
    for verb in ("plot", "compare"):
        assert offered(verb, "run", "--quantity", "mem") == ["member_force"]
    assert set(offered("plot", "run", "--quantity", "")) >= {*quantities.QUANTITIES, *quantities.ALIASES, *quantities.BUNDLES}


def test_names_are_those_of_the_model_on_the_line(model, tmp_path):
    given = tripod()
    assert offered("run", model, "") == list(given.runs)
    assert offered("run", model, "-o", "out", "") == list(given.runs)
    assert offered("explain", model, "--run", "") == list(given.runs)
    assert offered("explain", model, "--member", "") == list(given.members)
    assert offered("info", model, "--node", "T") == ["T"]
    assert offered("view", model, "--case", "") == list(given.load_cases)
    assert offered("picture", model, "-o", "x.png", "--path", "A") == ["A"]
    assert offered("plot", model, "--member", "L") == ["LA", "LB", "LC"]
    assert offered("budget", model, "--of", "LA") == ["LA.force", "LA.drive_force"]
    assert offered("budget", model, "--at", "") == list(given.all_drives)
    assert "runs.lift.samples" in offered("run", model, "--set", "runs.lift.")


def test_names_of_a_run_are_those_of_its_model(model, tmp_path):
    done = CliRunner().invoke(main, ["run", model, "-o", str(tmp_path / "out" / "one"), "--json"])
    assert json.loads(done.stdout)["status"] == "COMPLETED"
    for folder in (tmp_path / "out", tmp_path / "out" / "one"):
        assert offered("plot", str(folder), "--member", "L") == ["LA", "LB", "LC"]
        assert offered("plot", str(folder), "--case", "") == list(tripod().load_cases)


def test_fixed_values_are_all_offered():
    assert offered("picture", "m.yaml", "--view", "") == ["iso", "front", "side", "top"]
    assert offered("picture", "m.yaml", "--colour", "s") == ["stress"]
    assert offered("plot", "run", "--width", "") == ["column", "page"]
    assert offered("render", "m.yaml", "--camera", "") == ["iso", "front", "side", "top"]
    assert offered("export", "run", "--group", "") == ["motion", "forces", "sections", "verdict", "demand"]
    assert offered("info", "run", "--axis", "") == ["x", "y", "z"]
    assert offered("import", "a.vtu", "--material", "steel_s2") == ["steel_s235", "steel_s275"]
    assert offered("import", "a.vtu", "--unit", "m") == ["m", "mm"]
    assert "closed-form" in offered("verify", "--filter", "")


@pytest.mark.parametrize("text", ["", "nodes: [", "runs: 3"])
def test_where_nothing_can_be_read_nothing_is_offered(tmp_path, text):
    path = tmp_path / "model.yaml"
    assert offered("run", str(path), "") == []
    path.write_text(text)
    assert offered("run", str(path), "") == []


def test_all_shells_ask_in_their_own_way(model):
    for shell in SHELLS:
        environment = {
            "_KINETRUSS_COMPLETE": f"{shell}_complete",
            "COMP_WORDS": f"kinetruss explain {model} --member L",
            "COMP_CWORD": "L" if shell == "fish" else "4",  # fish gives the word itself
        }
        done = CliRunner().invoke(main, [], env=environment, prog_name="kinetruss", complete_var="_KINETRUSS_COMPLETE")
        assert [word for word in done.stdout.replace(",", "\n").splitlines() if word.startswith("L")] == ["LA", "LB", "LC"]


def test_every_option_with_a_set_of_values_is_completed():
    """Options that take a text: those that are not in this list have values that cannot be known."""
    free = {("import", one) for one in ("at", "tolerance", "skip", "active", "motor", "fixed", "thickness")} | {
        ("budget", "tolerances"),
        ("render", "size"),
        ("render", "at"),
        ("picture", "at"),
        ("picture", "title"),
        ("new", "name"),
        ("study", "cluster"),
    }
    free |= {(verb, "max_size") for verb in main.commands} | {(verb, "time") for verb in main.commands}
    titles = {"project", "client", "number", "author", "checker", "revision", "date"}
    for verb, command in main.commands.items():
        for one in command.params:
            if type(one.type).__name__ != "StringParamType" or one._custom_shell_complete is not None:
                continue
            assert (verb, one.name) in free or (verb == "report" and one.name in titles), (verb, one.name)
