"""What a newcomer types in vain is answered with what to type."""

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main


@pytest.fixture
def leg(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(main, ["new", "leg", "--like", "four_bar"]).exit_code == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        ("info leg", "'leg' does not exist. Did you mean 'leg.yaml'?"),
        ("view lge.yaml", "'lge.yaml' does not exist. Did you mean 'leg.yaml'?"),
        (
            "report leg.yaml",
            "not a run. Run it first: kinetruss run leg.yaml -o runs/leg; kinetruss report runs/leg",
        ),
        ("run leg.yaml -o out --set duration=2", "Did you mean runs.turn.trajectory.duration?"),
        ("run leg.yaml -o out --set trajectory.samples=2", "'trajectory' is not known here. Did you mean 'trajectories'?"),
        ("help", "No such command 'help'. Write kinetruss -h, or kinetruss COMMAND -h."),
        ("solve leg.yaml", "The analyses of a model are its runs: kinetruss run MODEL -o OUT."),
        ("exmaples", "No such command 'exmaples'."),
    ],
)
def test_a_mistake_is_answered_with_what_to_type(leg, typed, answer):
    done = CliRunner().invoke(main, typed.split())
    assert done.exit_code == 2
    assert answer in done.output


def test_a_mapping_is_no_file():
    with pytest.raises(kt.InputError, match=r"A mapping is no file. Make the model of it: kt.Model\(\*\*data\)"):
        kt.read({"nodes": {}})


@pytest.mark.parametrize(
    ("change", "answer"),
    [
        ({"material": "S235"}, "no material called 'S235'. Did you mean 'steel_s235'?"),
        ({"bars": {"b": ("a", "B")}}, "no node called 'a'. Did you mean 'A'?"),
        ({"bars": {"b": ("A", "B", "A")}}, "expected at most 2. Give at most 2.$"),
        ({"gravity": (0, "\N{MINUS SIGN}9.81")}, r"its minus is another character. Write '-9.81'."),
        ({"loads": {"p": {"node": "A", "F": [0, 1]}}}, "There are: node, force, times, forces.$"),
    ],
)
def test_faults_of_newcomers(change, answer):
    with pytest.raises(kt.ModelError, match=answer):
        kt.Model(**{"nodes": {"A": (0, 0), "B": (1, 0)}, **change})


def test_a_short_package_lists_its_names():
    with pytest.raises(AttributeError, match="no attribute 'solve'. It has: .*at_poses"):
        _ = kt.statics.solve


def test_the_shell_completes_commands_and_options():
    """The line of docs/installation.md prints a script; with the words typed so far the program prints what may follow."""
    typed = {"COMP_WORDS": "kinetruss re", "COMP_CWORD": "1"}
    done = CliRunner().invoke(main, prog_name="kinetruss", env={"_KINETRUSS_COMPLETE": "bash_complete", **typed})
    assert {line.partition(",")[2] for line in done.output.split()} == {"render", "report"}
    typed = {"COMP_WORDS": "kinetruss run --res", "COMP_CWORD": "2"}
    done = CliRunner().invoke(main, prog_name="kinetruss", env={"_KINETRUSS_COMPLETE": "bash_complete", **typed})
    assert done.output.split() == ["plain,--resume"]
