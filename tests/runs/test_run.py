"""Runs: dispatch, blocks against the whole, statuses, resuming."""

import numpy as np
import pytest
import xarray as xr

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.results.store import open_store
from kinetruss.runs import load, resume, run
from kinetruss.runs.plans import block_size
from samples import FOURBAR_MOVES, fourbar, tripod

LOOSE = ["time_of", "margin", "station", "position", "singularity"]
"""Places of a maximum may swap where two samples agree to round-off; the gauge is refined from sample to sample."""


@pytest.fixture(scope="module")
def whole() -> kt.runs.RunResult:
    return run(tripod())


def assert_same(one: kt.runs.RunResult, other: kt.runs.RunResult) -> None:
    def close(a: xr.Dataset, b: xr.Dataset) -> None:
        kept = [name for name in a.data_vars if name not in LOOSE and a[name].dtype.kind == "f"]
        assert set(a.variables) == set(b.variables)
        xr.testing.assert_allclose(a[kept].drop_attrs(), b[kept].load().drop_attrs(), rtol=1e-8, atol=1e-9)

    close(one.motion.data, other.motion.data)
    assert list(one.forces) == list(other.forces)
    for case, forces in one.forces.items():
        close(forces.data, other.forces[case].data)
        close(forces.static.data, other.forces[case].static.data)
        close(one.sections[case].data, other.sections[case].data)
        close(one.demand[case].data, other.demand[case].data)
    close(one.verdict.data, other.verdict.data)


def test_a_run_answers_every_question(whole):
    assert whole.whole
    assert list(whole.forces) == ["standing", "pushed"]
    assert whole.forces["pushed"].static is not None
    assert {row.part for row in whole.verdict.table()} >= {"LA.base", "LA.tube"}
    assert whole.demand["standing"].data["electrical_energy"].sizes == {"active": 3}


@pytest.mark.slow
def test_blocks_give_what_the_whole_gives(whole):
    assert_same(whole, run(tripod(), block=7))


@pytest.mark.slow
def test_a_stored_run_gives_what_memory_gives(whole, tmp_path):
    seen = []
    stored = run(tripod(), out=tmp_path / "run", block=10, progress=lambda done, total: seen.append((done, total)))
    assert seen == [(10, 41), (20, 41), (30, 41), (40, 41), (41, 41)]
    assert_same(whole, stored)
    assert_same(whole, load(tmp_path / "run"))
    assert load(tmp_path / "run").model == tripod()


@pytest.mark.slow
def test_an_interrupted_run_goes_on_to_the_same_end(whole, tmp_path):
    path = tmp_path / "run"

    def stop(done: int, total: int) -> None:
        if done == 20:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(tripod(), out=path, block=10, progress=stop)
    half = load(path)
    assert (half.state, half.whole, half.good) == ("incomplete", False, 20)
    assert half.verdict is None  # the worst of half a motion is not the worst
    assert_same(whole, resume(path))
    assert load(path).whole
    with pytest.raises(InputError, match="nothing to resume"):
        resume(path)


@pytest.mark.slow
def test_a_crank_may_turn_more_than_once_across_blocks():
    turns = kt.ConstantRate(rates={"motor": 10.0}, duration=2.0)
    model = fourbar(runs={"turn": kt.Run(trajectory=turns, samples=101)})
    one, other = run(model), run(model, block=13)
    np.testing.assert_allclose(one.motion.position.values, other.motion.position.values, atol=1e-12)
    np.testing.assert_allclose(one.motion.drive_position.values, other.motion.drive_position.values, atol=1e-12)
    assert float(one.motion.drive_position[-1, 0]) > 6 * np.pi


def test_motion_only(tmp_path):
    model = fourbar(runs={"turn": kt.Run(analysis="kinematics.follow", trajectory=FOURBAR_MOVES, samples=11)})
    found = run(model, out=tmp_path / "run")
    assert found.whole
    assert found.forces == {}
    assert found.verdict is None
    assert open_store(tmp_path / "run").groups == ("motion",)


def overreaching(**run_fields: object) -> kt.Model:
    """Two legs of 1 m on a base of 1.2 m; one shrinks until the triangle cannot close."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (1.2, 0), "T": (0.6, 0.8)}, fixed=["A", "B"],
        bars={"a": {"ends": ("A", "T"), "kind": "driven", "mass": 1.0}, "b": {"ends": ("B", "T"), "mass": 1.0}},
        runs={"shrink": kt.Run(trajectory=kt.ConstantRate(rates={"a": -1.0}, duration=0.95), samples=96, **run_fields)},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("block", [200, 9])
def test_a_path_that_ends_early_is_data(tmp_path, block):
    found = run(overreaching(), out=tmp_path / "run", block=block)
    assert not found.status.ok
    assert not found.whole
    assert 70 <= found.good <= 81  # closes down to a = 0.2 m, at t = 0.8 s
    assert "good up to t = " in found.message
    assert np.isfinite(found.motion.position.values).all()
    again = load(tmp_path / "run")
    assert (again.status, again.message, again.good) == (found.status, found.message, found.good)
    assert again.state == "finished"


def test_a_model_with_several_runs_wants_a_name():
    model = fourbar(runs={"slow": kt.Run(trajectory=FOURBAR_MOVES), "fast": kt.Run(trajectory=FOURBAR_MOVES)})
    with pytest.raises(InputError, match=r"has 2 runs; name one\. There are: slow, fast"):
        run(model)
    with pytest.raises(InputError, match=r"no run called .quick.\. There are: slow, fast"):
        run(model, "quick")
    with pytest.raises(InputError, match="has none"):
        run(fourbar(runs={}))


@pytest.mark.slow
def test_nothing_is_touched_where_the_run_is_refused(tmp_path):
    good = run(fourbar(), out=tmp_path / "run")
    loose = fourbar(drives={}, runs={"turn": kt.Run(trajectory=kt.Quintic(moves={"p": (1, 2)}, duration=1.0))},
                    bars={"p": {"ends": ("A", "B"), "kind": "driven"}, "q": ("B", "C")})  # fmt: skip
    with pytest.raises(InputError):
        run(loose, out=tmp_path / "run", overwrite=True)
    assert load(tmp_path / "run").good == good.good
    with pytest.raises(InputError, match="holds a run already"):
        run(fourbar(), out=tmp_path / "run")
    assert run(fourbar(11), out=tmp_path / "run", overwrite=True).good == 11


def test_large_models_take_smaller_blocks():
    assert block_size(fourbar()) == 2000
    many = {f"n{i}": (float(i), 0.0) for i in range(1001)}
    chain = kt.Model(nodes=many, bars={f"b{i}": (f"n{i}", f"n{i + 1}") for i in range(1000)})
    assert block_size(chain) == 100


def test_a_wrong_name_in_a_mapping_of_results_says_which_there_are():
    """In memory and from a folder, of runs and of variants; a quantity in place of a load case is told where it is."""
    model = kt.read(kt.library.example_files()["four_bar"][0]).with_(quantities={"middle": "B.x"})
    run = kt.run(model, "turn")
    for table in (run.forces, run.sections, run.demand, run.statics, run.settings):
        with pytest.raises(KeyError, match="'al' is not in this table"):
            table["al"]
    with pytest.raises(KeyError, match="Did you mean 'all'"):
        run.forces["al"]
    with pytest.raises(KeyError, match=r"run\.quantities\['all'\]\.value\.sel\(quantity='middle'\)"):
        run.quantities["middle"]
    with pytest.raises(KeyError, match="neither a load case nor a quantity. Did you mean 'middle'"):
        run.quantities["midle"]
    with pytest.raises(KeyError, match="Did you mean 'member_force'"):
        run.forces["all"].arrays["member_forces"]
    several = kt.runs.run_variants(model, {"nodes.C.mass": [0.5, 1.0]}, "turn")
    for table in (several, several.status, several.settings):
        with pytest.raises(KeyError, match=r"Did you mean 'mass=0\.5'"):
            table["mass=0,5"]
