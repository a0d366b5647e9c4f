"""Kill a simulation at random moments without warning, go on, and compare every number with a run that was never interrupted.

    .venv/bin/python tests/acceptance/kill_resume.py [--seed N] [--kills N]

Prints what it did; exit code 1 where one bit differs.
"""

from __future__ import annotations

import argparse
import json
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import xarray as xr

import kinetruss as kt
from kinetruss.results.store import open_store
from kinetruss.runs import load

T_END, SAMPLES, BLOCK = 600.0, 60_001, 500
CHILD = """
import sys
from kinetruss import read
from kinetruss.runs import resume, run
out, block = sys.argv[1], int(sys.argv[3])
resume(out) if sys.argv[2] == "resume" else run(read(sys.argv[2]), out=out, block=block)
"""


def model(t_end: float = T_END, samples: int = SAMPLES) -> kt.Model:
    """A chaotic double pendulum with a damped spring and a watched passage: one wrong bit would show."""
    return kt.Model(
        title="Double pendulum on a spring",
        nodes={"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=0.5), "B": kt.Node(at=(0.8, 0.1), mass=0.5), "C": (0.8, 0.8)},
        fixed=("O", "C"),
        bars={"upper": ("O", "A"), "lower": ("A", "B"), "spring": kt.Bar(ends=("C", "B"), kind="elastic", stiffness=20.0)},
        gravity=(0, -9.81),
        runs={
            "fall": kt.Run(
                analysis="dynamics.simulate", t_end=t_end, samples=samples,
                events={"under": kt.Event(coordinate="B.x", value=0, stop=False)},
            )
        },
    )  # fmt: skip


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


def differences(one: Path, other: Path) -> list[str]:
    """Arrays of two run folders that differ in a single bit, or in their names."""
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
    return found


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
    options.add_argument("--kills", type=int, default=3)
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        kt.write(model(), home / "model.yaml")
        began = time.perf_counter()
        if start(home / "whole", str(home / "model.yaml"), BLOCK).wait() != 0:
            print("the unbroken run failed")
            return 1
        took = time.perf_counter() - began
        print(f"unbroken run: {SAMPLES} samples, {load(home / 'whole').simulation.steps[-1].item():.0f} steps, {took:.1f} s")
        pace = 0.8 * took / (chosen.kills + 1)
        counts = kill_and_resume(home / "model.yaml", home / "broken", BLOCK, chosen.kills, pace, chosen.seed)
        print(f"killed with {counts} good samples (seed {chosen.seed}), resumed each time")
        bad = differences(home / "whole", home / "broken")
    print("every array is the same, bit for bit" if not bad else "DIFFERENT: " + ", ".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
