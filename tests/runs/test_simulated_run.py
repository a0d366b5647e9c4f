"""Simulations as runs: blocks, checkpoints, kills, interrupts, the way they are read and gone on with."""

import importlib.util
import json
import os
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError, StoreError
from kinetruss.results import Status
from kinetruss.results.store import open_store, write_state
from kinetruss.runs import RunResult, forces_at, load, resume, run
from samples import fourbar

_SCRIPT = Path(__file__).parents[1] / "acceptance" / "kill_resume.py"
_SPEC = importlib.util.spec_from_file_location("kill_resume", _SCRIPT)
assert _SPEC is not None
assert _SPEC.loader is not None
acceptance = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(acceptance)


def model(t_end: float = 2.0, samples: int = 101, **changes: object) -> kt.Model:
    """The model of the acceptance run, with sections, so that there is a verdict."""
    steel = {"section": kt.Rectangle(width=0.02, height=0.005), "material": kt.library.materials.STEEL_S235}
    return acceptance.model(t_end, samples).with_(**steel | changes)


@pytest.fixture(scope="module")
def whole() -> RunResult:
    return run(model())


@pytest.mark.slow
def test_a_run_is_what_simulate_gives(whole):
    events = {"under": kt.Event(coordinate="B.x", value=0, stop=False)}
    direct = kt.dynamics.simulate(model(), 2.0, samples=101, events=events)
    for name in ("position", "velocity", "acceleration"):
        np.testing.assert_array_equal(whole.motion.data[name], direct.motion.data[name])
    np.testing.assert_array_equal(whole.forces["all"].member_force, direct.forces.member_force)
    assert whole.whole
    assert whole.simulation is not None
    assert whole.simulation.events == direct.events
    assert whole.verdict is not None
    assert whole.verdict.table()[0].checked
    assert whole.forces["all"].static is None


@pytest.mark.slow
def test_blocks_and_the_store_change_no_bit(whole, tmp_path):
    blocks = run(model(), block=7)
    stored = run(model(), out=tmp_path / "run", block=10)
    for found in (blocks, stored, load(tmp_path / "run")):
        assert found.whole
        assert found.simulation.events == whole.simulation.events
        assert found.simulation.passages == whole.simulation.passages
        for one, other in ((found.motion, whole.motion), (found.forces["all"], whole.forces["all"]),
                           (found.simulation, whole.simulation)):  # fmt: skip
            for name, values in other.data.data_vars.items():
                np.testing.assert_array_equal(one.data[name].values, values.values, err_msg=str(name))
    assert not (tmp_path / "run" / "state").exists()  # nothing is left to go on from


@pytest.mark.slow
def test_an_interrupted_run_is_readable_and_goes_on_bit_for_bit(tmp_path):
    def stop(done: int, total: int) -> None:
        if done == 80:
            raise KeyboardInterrupt

    run(model(20.0), out=tmp_path / "whole", block=10)
    with pytest.raises(KeyboardInterrupt):
        run(model(20.0), out=tmp_path / "half", block=10, progress=stop)
    half = load(tmp_path / "half")
    assert (half.status, half.state, half.good) == (Status.INTERRUPTED, "incomplete", 80)
    assert half.simulation.events == load(tmp_path / "whole").simulation.events[: len(half.simulation.events)]
    assert half.simulation.events
    assert [path.name for path in (tmp_path / "half" / "state").iterdir()] == ["80.npz"]
    assert resume(tmp_path / "half").whole
    assert acceptance.differences(tmp_path / "whole", tmp_path / "half") == []


@pytest.mark.slow
def test_a_state_without_units_of_events_is_read_and_resumed(tmp_path):
    """The states of earlier versions have none: they come from the events of the run."""

    def stop(done: int, total: int) -> None:
        if done == 80:
            raise KeyboardInterrupt

    events = {
        "under": kt.Event(coordinate="B.x", value=0, stop=False),
        "slack": kt.Event(force="lower", value=0, stop=False),
    }
    falls = model(runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=20.0, samples=101, events=events)})
    with pytest.raises(KeyboardInterrupt):
        run(falls, out=tmp_path / "run", block=10, progress=stop)
    before = load(tmp_path / "run").simulation
    store = open_store(tmp_path / "run")
    write_state(store.path, 80, {name: values for name, values in store.state().items() if name != "event_units"})
    old = load(tmp_path / "run").simulation
    assert set(old.data["event_unit"].values) == {"m", "N"}
    assert old.data["event_unit"].identical(before.data["event_unit"])
    assert old.events == before.events
    done = resume(tmp_path / "run")
    assert done.whole
    assert done.simulation.events[: len(old.events)] == old.events


@pytest.mark.slow
def test_an_interrupt_within_a_block_loses_that_block_only(tmp_path, monkeypatch):
    from kinetruss.dynamics.stepping import KernelStepper

    run(model(), out=tmp_path / "whole", block=10)
    march, calls = KernelStepper._integrate, []

    def interrupted(self, samples, done, budget):
        calls.append(1)
        if len(calls) == 5:
            raise KeyboardInterrupt
        return march(self, samples, done, budget)

    monkeypatch.setattr(KernelStepper, "_integrate", interrupted)
    with pytest.raises(KeyboardInterrupt):
        run(model(), out=tmp_path / "half", block=10)
    monkeypatch.undo()
    assert load(tmp_path / "half").status is Status.INTERRUPTED
    assert load(tmp_path / "half").good == 40
    assert resume(tmp_path / "half").whole
    assert acceptance.differences(tmp_path / "whole", tmp_path / "half") == []


@pytest.mark.slow
def test_an_interrupt_while_files_are_written_takes_nothing_back(tmp_path, monkeypatch):
    """Ctrl-C is noticed when a call of the system returns: after each of those that write the run, one run after the other."""
    run(model(), out=tmp_path / "whole", block=40)
    calls = {"left": 0, "committed": 0}

    def then_interrupted(call):
        def called(*args, **kwargs):
            result = call(*args, **kwargs)
            half = tmp_path / f"half_{first}"
            if (ledger := half / "kinetruss.json").exists() and (half / "model.json").exists():
                calls["committed"] = max(calls["committed"], json.loads(ledger.read_text())["committed"])
                calls["left"] -= 1
                if calls["left"] == 0:
                    raise KeyboardInterrupt
            return result

        return called

    first = again = 0
    while calls["left"] <= 0:
        first += 1
        calls |= {"left": first, "committed": 0}
        with monkeypatch.context() as patched:
            patched.setattr("os.fsync", then_interrupted(os.fsync))
            patched.setattr(Path, "replace", then_interrupted(Path.replace))
            with suppress(KeyboardInterrupt):
                run(model(), out=tmp_path / f"half_{first}", block=40)
        store = open_store(tmp_path / f"half_{first}")
        assert store.ledger.committed >= calls["committed"]
        if store.ledger.state != "finished":
            again += 1
            assert resume(tmp_path / f"half_{first}").whole
        assert acceptance.differences(tmp_path / "whole", tmp_path / f"half_{first}") == []
    assert again > 10


@pytest.mark.slow
def test_a_run_with_all_samples_and_without_its_end_gets_it(tmp_path, monkeypatch):
    """As earlier versions left it, which wrote the end after the last block."""
    from kinetruss.runs import running

    def stop(done: int, total: int) -> None:
        if done == total:
            raise KeyboardInterrupt

    run(model(20.0), out=tmp_path / "whole", block=10)
    blocks = running.blocks
    monkeypatch.setattr(running, "blocks", lambda *given, **how: (one.with_(last=False) for one in blocks(*given, **how)))
    with pytest.raises(KeyboardInterrupt):
        run(model(20.0), out=tmp_path / "half", block=10, progress=stop)
    monkeypatch.undo()
    assert (load(tmp_path / "half").good, load(tmp_path / "half").state) == (101, "incomplete")
    assert resume(tmp_path / "half").whole
    assert acceptance.differences(tmp_path / "whole", tmp_path / "half") == []
    assert load(tmp_path / "half").simulation.events


@pytest.mark.slow
def test_a_kill_between_state_and_ledger_is_no_harm(tmp_path, monkeypatch):
    """The state behind the block is written, the ledger does not count it yet."""
    from kinetruss.results import store as _store

    run(model(), out=tmp_path / "whole", block=10)
    written = _store.write_ledger

    def dies(path, ledger):
        if ledger.committed == 30:
            raise SystemExit
        written(path, ledger)

    monkeypatch.setattr(_store, "write_ledger", dies)
    with pytest.raises(SystemExit):
        run(model(), out=tmp_path / "half", block=10)
    monkeypatch.undo()
    assert {path.name for path in (tmp_path / "half" / "state").iterdir()} == {"20.npz", "30.npz"}
    assert load(tmp_path / "half").good == 20
    assert resume(tmp_path / "half").whole
    assert acceptance.differences(tmp_path / "whole", tmp_path / "half") == []


@pytest.mark.slow
def test_a_process_killed_at_random_moments_goes_on_bit_for_bit(tmp_path):
    kt.write(acceptance.model(60.0, 3001), tmp_path / "model.yaml")
    assert acceptance.start(tmp_path / "whole", str(tmp_path / "model.yaml"), 50).wait() == 0
    counts = acceptance.kill_and_resume(tmp_path / "model.yaml", tmp_path / "broken", 50, 2, 0.1, 7)
    assert max(counts) < 3001
    assert acceptance.differences(tmp_path / "whole", tmp_path / "broken") == []


@pytest.mark.slow
def test_a_lost_or_damaged_state_is_said(tmp_path):
    def stop(done: int, total: int) -> None:
        raise KeyboardInterrupt

    path = tmp_path / "run"
    with pytest.raises(KeyboardInterrupt):
        run(model(), out=path, block=10, progress=stop)
    state = path / "state" / "10.npz"
    good = state.read_bytes()
    state.write_bytes(good[:100])
    with pytest.raises(StoreError, match="damaged"):
        resume(path)
    state.unlink()
    with pytest.raises(StoreError, match="state of the integration is not in the run folder"):
        resume(path)
    state.write_bytes(good)
    assert resume(path).whole


@pytest.mark.slow
def test_an_event_ends_a_stored_run_as_whole(tmp_path):
    watched = {"low": kt.Event(coordinate="B.y", value=-0.3, direction="falling")}
    ends = model(runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=5.0, samples=501, events=watched)})
    found = run(ends, out=tmp_path / "run", block=10)
    assert found.whole
    assert found.status is Status.EVENT
    assert found.good < 501
    assert found.motion.position.sel(node="B", axis="y")[-1].item() == pytest.approx(-0.3, abs=1e-9)
    again = load(tmp_path / "run")
    assert (again.whole, again.good, again.simulation.events[-1].name) == (True, found.good, "low")
    with pytest.raises(InputError, match="nothing to resume"):
        resume(tmp_path / "run")


@pytest.mark.slow
def test_a_run_that_ends_early_keeps_what_is_good(tmp_path):
    few = kt.DOP853(max_steps=60)
    short = model(runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=5.0, samples=501, method=few)})
    found = run(short, out=tmp_path / "run", block=10)
    assert (found.status, found.whole, found.state) == (Status.TOO_MANY_STEPS, False, "finished")
    assert 0 < found.good < 501
    assert "Raise max_steps" in load(tmp_path / "run").message


def test_a_run_refused_touches_nothing(tmp_path):
    nodes = {"O": (0, 0), "A": (0.4, 0), "B": (0.8, 0.1), "C": (0.8, 0.8)}
    bad = model(nodes=nodes, section=None, material=None)
    with pytest.raises(InputError, match="no mass"):
        run(bad, out=tmp_path / "run")
    assert not (tmp_path / "run").exists()


@pytest.mark.slow
def test_a_simulation_under_one_load_case(tmp_path):
    pushed = model(
        loads={"push": kt.NodalForce(node="B", force=(1.0, 0))},
        load_cases={"still": kt.LoadCase(loads={}), "pushed": kt.LoadCase()},
        runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=0.5, samples=11, load_cases=("pushed",))},
    )
    found = run(pushed, out=tmp_path / "run", block=5)
    assert list(found.forces) == ["pushed"]
    free = pushed.with_(runs={"fall": pushed.runs["fall"].with_(load_cases=("still",))})
    assert abs(run(free).motion.position - found.motion.position).max() > 1e-3


def test_forces_at_an_instant_of_a_simulation(whole):
    at = forces_at(model(), None, [0.5])
    np.testing.assert_array_equal(at.member_force[0], whole.forces["all"].member_force.sel(time=0.5))


@pytest.mark.slow
def test_variants_of_a_simulation(tmp_path):
    found = kt.runs.run_variants(model(0.5, 11), {"runs.fall.t_end": ["0.25 s", "0.5 s"]}, out=tmp_path / "runs")
    assert list(found.whole.values()) == [True, True]
    ends = [float(one.motion.time[-1]) for one in found.values()]
    assert ends == [0.25, 0.5]


def test_drives_and_simulations_may_stand_in_one_model(tmp_path):
    both = fourbar(11).with_(runs={
        "turn": fourbar(11).runs["turn"],
        "loose": kt.Run(analysis="dynamics.simulate", t_end=0.2, samples=11, tasks={"motor": kt.GivenForce(torque=0.1)}),
    })  # fmt: skip
    assert run(both, "turn").whole
    loose = run(both, "loose", out=tmp_path / "run")
    assert loose.whole
    np.testing.assert_allclose(loose.forces["all"].drive_force, 0.1, atol=1e-9)
    balance = loose.forces["all"].energy_balance
    np.testing.assert_allclose(balance, 0, atol=1e-8 * float(abs(loose.forces["all"].power).max()))
