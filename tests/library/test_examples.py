"""The examples that are shipped: every script holds its own numbers. `shipped` has the runs of model files."""

import runpy
from pathlib import Path

import pytest

import kinetruss as kt
from kinetruss.library import example_files

SCRIPTS = sorted((Path(__file__).parents[2] / "examples").rglob("*.py"))


@pytest.mark.slow
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_script(script, capsys, tmp_path):
    left = runpy.run_path(str(script), run_name="__main__")
    assert capsys.readouterr().out
    for name, model in left.items():
        if isinstance(model, kt.Model):  # what a script builds can be written, read, shown and drawn
            path = tmp_path / f"{name}.yaml"
            again = kt.read(kt.io.write(model, path))
            assert kt.viewer.scene(again).header["nodes"] == list(model.whole.nodes)
            assert kt.report.picture(again, tmp_path / f"{name}.svg").is_file()


def test_model_files_come_with_scripts():
    """Scripts on mechanisms of the library need no file."""
    shelf = example_files()
    assert len({path.stem for path in SCRIPTS}) == len(SCRIPTS)
    assert set(shelf) <= {path.stem for path in SCRIPTS}
    assert {path.stem for path in SCRIPTS if path.parent.name != "mechanisms"} <= set(shelf)
    for model in (kt.read(paths[0]) for paths in shelf.values()):
        assert model.title
        assert model.runs
    assert [path.name for path in shelf["measured_slew"]] == ["measured_slew.yaml", "measured_slew.csv"]


def test_companions_are_read_by_their_readers():
    """What stands beside a model under its name is of it: a mission, the task of an optimum, a study."""
    read = {
        ".mission": lambda file, model: kt.io.read_mission(file, kt.read(model)),
        ".optimum": lambda file, _: kt.io.read_optimum(file).model,
        ".study": lambda file, _: kt.studies.read_study(file).model,
    }
    found = [(model, file) for model, *others in example_files().values() for file in others if file.suffix == ".yaml"]
    assert {Path(file.stem).suffix for _, file in found} == set(read)
    for model, file in found:
        of = read[Path(file.stem).suffix](file, model)
        assert of == str(model) or isinstance(of, kt.model.Mission), file.name


def test_written_out_bay_is_the_bay_of_the_library():
    written = kt.read(example_files()["measured_slew"][0])
    built = kt.library.vgt.double_octahedral()
    assert {name: member.ends for name, member in written.members.items()} == {
        name: member.ends for name, member in built.members.items()
    }
    for name, node in written.nodes.items():
        assert node.at == pytest.approx(built.nodes[name].at, abs=1e-6)


def test_slew_of_the_model_file_is_that_of_the_script():
    model = kt.io.set_values(kt.read(example_files()["double_octahedral_slew"][0]), {"trajectories.tilt.duration": 1.0})
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, "tilt", samples=5))
    # independent computation of the slew in 1 s, at 0.25 s
    assert forces.end_force.sel(time=0.25, member="M6", end="B").item() == pytest.approx(58.25112815, rel=1e-9)
