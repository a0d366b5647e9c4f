"""Kill runs at random moments without warning, go on, and compare every number and byte with runs that were never interrupted.

    .venv/bin/python tests/acceptance/kill_resume.py [--seed N] [--kills N] [--only NAME ...]

First a long simulation in processes of its own, so that kills fall into the start too. Then one of every way of integration,
a given motion, motors and a mission, forked from a process with warm kernels, so that most kills fall into the work: after each
kill what is there is read and summarised. Prints what it did; exit code 1 where one bit differs or a file is left over.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import xarray as xr

import kinetruss as kt
from kinetruss.report import summary
from kinetruss.results.folder import ARCHIVE
from kinetruss.results.store import open_store
from kinetruss.runs import load, resume, run

T_END, SAMPLES, BLOCK = 600.0, 60_001, 500
CHILD = """
import sys
from kinetruss import read
from kinetruss.runs import resume, run
out, block = sys.argv[1], int(sys.argv[3])
resume(out) if sys.argv[2] == "resume" else run(read(sys.argv[2]), out=out, block=block)
"""
REFUSED = ("no good sample", "no pair that is done", "is damaged: [Errno 2]", "is not a kinetruss run")
"""What a reader may be told of a run that was killed before its first block."""


def model(t_end: float = T_END, samples: int = SAMPLES, **changes: object) -> kt.Model:
    """A chaotic double pendulum with a damped spring and a watched passage: one wrong bit would show."""
    run = kt.Run(
        analysis="dynamics.simulate", t_end=t_end, samples=samples,
        events={"under": kt.Event(coordinate="B.x", value=0, stop=False)},
    )  # fmt: skip
    return kt.Model(
        title="Double pendulum on a spring",
        nodes={"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=0.5), "B": kt.Node(at=(0.8, 0.1), mass=0.5), "C": (0.8, 0.8)},
        fixed=("O", "C"),
        bars={"upper": ("O", "A"), "lower": ("A", "B"), "spring": kt.Bar(ends=("C", "B"), kind="elastic", stiffness=20.0)},
        gravity=(0, -9.81),
        runs={"fall": run.with_(**changes)},
    )


def warm_models() -> Iterator[tuple[str, kt.Model, str, int]]:
    """Name, model, run and samples of a block."""
    methods = {
        "taylor": (kt.Taylor(), 200), "dop853": (kt.DOP853(), 100), "energy_momentum": (kt.EnergyMomentum(step=2e-3), 60),
        "rattle": (kt.Rattle(step=5e-4), 40), "generalized_alpha": (kt.GeneralizedAlpha(step=2e-3), 60),
    }  # fmt: skip
    for name, (method, t_end) in methods.items():
        yield name, model(t_end, 4001, method=method), "fall", 100
    four = kt.read(kt.library.example_files()["four_bar"][0])
    name, turn = next(iter(four.runs.items()))
    yield "inverse", four.with_(runs={name: turn.with_(samples=12_001)}), name, 300
    bay = kt.read(kt.library.example_files()["driven_bay"][0])
    name, driven = next(one for one in bay.runs.items() if one[1].analysis == "dynamics.simulate")
    yield "motors", bay.with_(runs={name: driven.with_(samples=1001)}), name, 50
    many = {f"turn{k}": turn.with_(samples=2001 + k) for k in range(12)}
    mission = kt.Run(analysis="mission", motions=tuple(many), samples=2001)
    yield "mission", four.with_(runs=many | {"all": mission}), "all", 1


# -- a long simulation, in processes of their own ------------------------------------------------------------------------


def start(out: Path, what: str, block: int) -> subprocess.Popen[bytes]:
    """A process that does the run, or goes on with it."""
    return subprocess.Popen([sys.executable, "-c", CHILD, str(out), what, str(block)])


def wait_for(out: Path, more_than: int, process: subprocess.Popen[bytes]) -> None:
    """Until the run has more good samples than this, or ended."""
    while process.poll() is None and (not (out / "kinetruss.json").exists() or load_count(out) <= more_than):
        time.sleep(0.002)


def load_count(out: Path) -> int:
    """Good samples of a run, also of one that is being made."""
    return int(json.loads((out / "kinetruss.json").read_text("utf-8"))["committed"])


def kill_and_resume(file: Path, out: Path, block: int, kills: int, pace: float, seed: int) -> list[int]:
    """Good samples at each kill; the run in `out` is whole in the end. pace : seconds within which a kill comes."""
    dice, counts = random.Random(seed), []
    process = start(out, str(file), block)
    for _ in range(kills):
        wait_for(out, counts[-1] if counts else 0, process)
        time.sleep(dice.uniform(0.0, pace))
        process.send_signal(signal.SIGKILL)
        process.wait()
        counts.append(load_count(out))
        process = start(out, "resume", block)
    if process.wait() != 0:
        raise SystemExit(f"the resumed run failed with exit code {process.returncode}")
    return counts


def long_run(kills: int, seed: int, home: Path) -> list[str]:
    """What is wrong after so many kills of the long simulation."""
    kt.write(model(), home / "model.yaml")
    began = time.perf_counter()
    if start(home / "whole", str(home / "model.yaml"), BLOCK).wait() != 0:
        return ["the unbroken run failed"]
    took = time.perf_counter() - began
    print(f"unbroken run: {SAMPLES} samples, {load(home / 'whole').simulation.steps[-1].item():.0f} steps, {took:.1f} s")
    counts = kill_and_resume(home / "model.yaml", home / "broken", BLOCK, kills, 0.8 * took / (kills + 1), seed)
    print(f"killed with {counts} good samples (seed {seed}), resumed each time", flush=True)
    return differences(home / "whole", home / "broken")


# -- forked from a process with warm kernels -----------------------------------------------------------------------------


def forked(work: Callable[[], object], note: Path) -> int:
    """A copy of this process that does some work; what went wrong is in its note."""
    sys.stdout.flush()
    pid = os.fork()
    if pid:
        return pid
    code = 1
    try:
        work()
        code = 0
    except BaseException:  # noqa: BLE001 - the parent tells it
        note.write_text(traceback.format_exc())
    os._exit(code)


def half(out: Path) -> list[str]:
    """What is wrong with a killed run as it is read."""
    try:
        found = load(out)
    except kt.KinetrussError as error:
        return [] if any(words in str(error) for words in REFUSED) else [f"half read: {error}"]
    told = summary(found).record
    return [f"half told as whole: {told['state']}"] if told["whole"] and found.state != "finished" else []


def warm_run(given: tuple[str, kt.Model, str, int], kills: int, dice: random.Random, home: Path) -> list[str]:
    """What is wrong after so many kills of one run."""
    name, what, chosen, block = given
    whole, out, note = home / "whole", home / "out", home / "note"
    run(what, chosen, home / "warm", block=block)
    began = time.perf_counter()
    run(what, chosen, whole, block=block)
    pace = time.perf_counter() - began
    counts: list[int] = []
    bad: list[str] = []
    code = None
    while code is None and not bad:
        begun = open_to_resume(out)
        work = (lambda: resume(out)) if begun else (lambda: run(what, chosen, out, block=block, overwrite=True))
        pid = forked(work, note)
        if len(counts) < kills:
            time.sleep(dice.uniform(0.0, pace * (0.5 if len(counts) % 3 else 0.15)))
            os.kill(pid, signal.SIGKILL)
        status = os.waitpid(pid, 0)[1]
        if os.WIFSIGNALED(status):
            counts.append(load_count(out) if (out / "kinetruss.json").exists() else -1)
            bad = half(out)
            code = (
                0 if open_to_resume(out) and open_store(out).ledger.state == "finished" else None
            )  # killed after its last word
        else:
            code = os.WEXITSTATUS(status)
    bad = bad or ([note.read_text()] if code else differences(whole, out))
    print(f"{name}: {len(counts)} kills with {counts} good samples, {'; '.join(bad) or 'the same'}", flush=True)
    return [f"{name}: {one}" for one in bad]


def open_to_resume(out: Path) -> bool:
    """True where a run can be gone on with; one that was killed before its model stood is begun anew."""
    try:
        return bool(open_store(out))
    except kt.StoreError:
        return False


# -- what must be the same -----------------------------------------------------------------------------------------------


def differences(one: Path, other: Path) -> list[str]:
    """Arrays of two run folders that differ in a single bit, or in their names; their archives; files that are left over."""
    found = []
    a, b = open_store(one), open_store(other)
    if a.groups != b.groups or a.ledger.committed != b.ledger.committed or a.ledger.message != b.ledger.message:
        return [f"what is there: {a.groups} {a.ledger.committed}, {b.groups} {b.ledger.committed}"]
    for group in a.groups:
        left, right = a.read(group), b.read(group)
        if set(left.variables) != set(right.variables):
            found.append(f"{group}: variables")
            continue
        found += [f"{group}/{name}" for name in left.variables if not same(left.variables[name], right.variables[name])]
    if (one / ARCHIVE).read_bytes() != (other / ARCHIVE).read_bytes():
        found.append(f"bytes of {ARCHIVE}")
    left_over = {path.name for path in other.iterdir()} ^ {path.name for path in one.iterdir()}
    return found + [f"left over: {name}" for name in sorted(left_over)]


def same(one: xr.Variable, other: xr.Variable) -> bool:
    """True for equal bits."""
    x, y = one.values, other.values
    if x.shape != y.shape or x.dtype.kind != y.dtype.kind:
        return False
    return bool(np.array_equal(x.view(np.uint64), y.view(np.uint64)) if x.dtype == float else np.array_equal(x, y))


def main() -> int:
    """Run, kill, resume, compare."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--seed", type=int, default=int(time.time()))
    options.add_argument("--kills", type=int, default=3, help="of the long simulation, and of each of the others")
    options.add_argument("--only", nargs="*", help="names of runs; the long simulation is 'long'")
    chosen = options.parse_args()
    dice, bad = random.Random(chosen.seed), []
    with tempfile.TemporaryDirectory() as folder:
        if not chosen.only or "long" in chosen.only:
            (Path(folder) / "long").mkdir()
            bad += long_run(chosen.kills, chosen.seed, Path(folder) / "long")
        for one in warm_models():
            if not chosen.only or one[0] in chosen.only:
                (Path(folder) / one[0]).mkdir()
                bad += warm_run(one, chosen.kills, dice, Path(folder) / one[0])
    print("every array and every byte is the same" if not bad else "DIFFERENT: " + ", ".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
