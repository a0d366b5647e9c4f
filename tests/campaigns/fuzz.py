"""Read, check and shortly run model files that are put wrong at random; each gets an answer or an error of kinetruss' own.

    .venv/bin/python tests/campaigns/fuzz.py [--work DIR] [--count N] [--runs N] [--seed N]

--count files are read and checked, then --runs of those that pass are run, shortly. Case k of a seed is always the same file.
Files that fail stay in DIR, beside them what happened. Progress goes to stderr; exit code 1 for a traceback, a case that
takes too long or too much memory, a process that dies, a number that is none in a result shown as good, or too few cases.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import select
import shutil
import signal
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))  # a script finds what stands beside it

import kinetruss as kt
from campaigns.mutations import Mutant, as_bytes, bases, damaged, vocabulary

LONGEST = 10.0
"""Seconds of processor time of a case."""
MEMORY = 2 << 30
"""Bytes of data of a process above what it starts with."""
BATCH = 50
SHORT = 0.1
"""Seconds of a simulation, at most."""


@dataclass(frozen=True)
class Case:
    """A file to be made from a number."""

    number: int
    runs: bool

    @property
    def name(self) -> str:
        """Of its file, without suffix."""
        return f"{'run' if self.runs else 'file'}{self.number}"


@dataclass(frozen=True)
class Outcome:
    """What became of a case; `bad` where it must not be so."""

    case: Case
    what: str
    bad: bool = False
    details: str = ""


class Mill:
    """Makes the file of a case; the same from one process to the next."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for file in (file for paths in kt.library.example_files().values() for file in paths if file.suffix == ".csv"):
            shutil.copy(file, folder)  # tables that the models name
        self.trees = bases()
        self.words = vocabulary(list(self.trees.values()))

    def warm(self) -> None:
        """Run every model as it is, so that no case pays for compiling; processes share what is compiled."""
        for name, tree in self.trees.items():
            path = self.folder / "warm.json"
            path.write_bytes(as_bytes(tree, ".json"))
            if (outcome := ran(Case(0, True), kt.read(path))).bad:
                raise RuntimeError(f"{name} fails as it is: {outcome.what}: {outcome.details}")
            path.unlink()

    def file(self, case: Case) -> Path:
        """The file of a case."""
        dice = Random(case.number)
        others = list(self.trees.values())
        mutant = Mutant(dice, dice.choice(others), others, self.words)
        for _ in range(dice.choice([1, 1, 2] if case.runs else [1, 1, 2, 3])):
            mutant.change(mild=case.runs)
        suffix = ".json" if dice.random() < 0.3 else ".yaml"
        data = as_bytes(mutant.tree, suffix)
        if not case.runs and dice.random() < 0.25:
            data = damaged(data, dice)
        path = self.folder / f"{case.name}{suffix}"
        path.write_bytes(data)
        return path


def judged(case: Case, path: Path) -> Outcome:
    """Read and check the file, and run what passes if that is asked."""
    try:
        model = kt.read(path)
        faults = kt.check(path)
    except kt.ModelError as error:
        model, faults = None, error.faults
    for fault in faults:
        if fault.line is None or len(str(fault)) > 2500 or not str(fault).isprintable() or not fault.mend:
            return Outcome(case, "fault without place or mend, or that cannot be printed", True, str(fault)[:500])
    if model is None or faults:
        return Outcome(case, "refused")
    return ran(case, model) if case.runs else Outcome(case, "passes")


def ran(case: Case, model: kt.Model) -> Outcome:
    """Every run of a model, with few samples and for a short time."""
    for name, run in model.runs.items():
        short: dict[str, Any] = {"samples": min(run.samples, 7)}
        if run.t_end is not None:
            short["t_end"] = min(run.t_end, SHORT, 100 * (getattr(run.method, "step", None) or 1.0))
        try:
            result = kt.run(model.with_(runs={name: run.with_(**short)}), name)
        except kt.KinetrussError as error:
            if "Traceback" in str(error) or "array(" in str(error):
                return Outcome(case, "odd message", True, str(error)[:500])
            continue
        if found := [f"{name}: {one}" for one in not_numbers(result)]:
            return Outcome(case, "NaN shown as good", True, "; ".join(found))
        str(kt.report.summary(result).text)
    return Outcome(case, "ran")


def not_numbers(result: Any) -> Iterator[str]:
    """Values that must be finite at every sample that a result holds: motion, forces, energy."""
    for values in (result.motion, *result.forces.values()):
        for key in ("position", "velocity", "acceleration", "length", "member_force", "drive_force", "reaction"):
            if key in values.data and not np.isfinite(values.data[key].values).all():
                yield f"{key} ({result.status.name})"


class Late(BaseException):
    """The alarm went off."""


def _alarm(*_: Any) -> None:
    raise Late


def attempt(case: Case, mill: Mill) -> Outcome:
    """A case under an alarm, in this process; its file stays where it is bad."""
    signal.signal(signal.SIGPROF, _alarm)
    path = mill.file(case)
    signal.setitimer(signal.ITIMER_PROF, LONGEST)
    try:
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            outcome = judged(case, path)
        if told and not outcome.bad and issubclass(told[0].category, RuntimeWarning):
            outcome = replace(outcome, what="warning of NumPy", bad=True, details=f"{told[0].filename}: {told[0].message}")
    except Late:
        outcome = Outcome(case, "takes too long", True, traceback.format_exc()[-1500:])
    except MemoryError:
        outcome = Outcome(case, "takes too much memory", True, traceback.format_exc()[-1500:])
    except Exception as error:  # noqa: BLE001 - what it looks for
        outcome = Outcome(case, f"traceback: {type(error).__name__}", True, traceback.format_exc()[-1500:])
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    if not outcome.bad:
        path.unlink()
    return outcome


def batch(cases: list[Case], mill: Mill) -> Iterator[Outcome]:
    """Cases in a process of their own; one that kills it is told as such, and the others are done in another."""
    left = list(cases)
    while left:
        answers, pipe = os.pipe()
        if (child := os.fork()) == 0:
            _work(left, mill, answers, pipe)
        os.close(pipe)
        for outcome in _heard(answers, child, left):
            left.remove(outcome.case)
            yield outcome
        os.close(answers)
        _, status = os.waitpid(child, 0)
        if status and left:
            yield Outcome(left.pop(0), "process died", True, f"status {status}")


def _work(cases: list[Case], mill: Mill, answers: int, pipe: int) -> None:
    """In the child: an answer a case."""
    os.close(answers)
    code = 1
    try:
        used = int(Path("/proc/self/statm").read_text().split()[5]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_DATA, (used + MEMORY, used + MEMORY))
        for case in cases:
            one = attempt(case, mill)
            os.write(pipe, json.dumps([case.number, one.what, one.bad, one.details]).encode() + b"\n")
        code = 0
    finally:
        os._exit(code)


def _heard(answers: int, child: int, cases: list[Case]) -> Iterator[Outcome]:
    """Answers of the child as they come; it is killed where it is deaf to its own alarm."""
    by_number = {case.number: case for case in cases}
    text = b""
    while True:
        if not select.select([answers], [], [], 20 * LONGEST)[0]:
            os.kill(child, signal.SIGKILL)
        if not (got := os.read(answers, 1 << 16)):
            return
        *lines, text = (text + got).split(b"\n")
        for line in lines:
            number, what, bad, details = json.loads(line)
            yield Outcome(by_number[number], what, bad, details)


def campaign(folder: Path, count: int, runs: int, seed: int, tell: Any = sys.stderr) -> tuple[Counter[str], list[Outcome]]:
    """All cases of a seed: how often what came, and what must not be. What is unfinished is among the latter."""
    mill = Mill(folder)
    if runs:
        mill.warm()
    counts: Counter[str] = Counter()
    bad: list[Outcome] = []
    began = time.monotonic()
    first, ran_now = seed * 10_000_000, 0
    todo = [[Case(first + k, False) for k in range(n, min(n + BATCH, count))] for n in range(0, count, BATCH)]
    # few mutants pass: as many more are tried, within reason
    more = iter(range(first + 5_000_000, first + 5_000_000 + 12 * runs, BATCH))
    while todo or ran_now < runs:
        start = 0 if todo else next(more, None)
        if start is None:
            bad.append(Outcome(Case(first, True), "unfinished", True, f"{ran_now} of {runs} runs"))
            break
        cases = todo.pop(0) if todo else [Case(n, True) for n in range(start, start + BATCH)]
        for outcome in batch(cases, mill):
            counts[outcome.what] += 1
            ran_now += outcome.case.runs and outcome.what != "refused"
            if outcome.bad:
                bad.append(outcome)
                (folder / f"{outcome.case.name}.txt").write_text(f"{outcome.what}\n{outcome.details}\n")
        print(f"{time.monotonic() - began:.0f} s {dict(counts)}", file=tell, flush=True)
    return counts, bad


def main() -> int:
    """The campaign of the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, default=None)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    folder = given.work or Path(tempfile.mkdtemp(prefix="fuzz"))
    folder.mkdir(parents=True, exist_ok=True)
    counts, bad = campaign(folder, given.count, given.runs, given.seed)
    for outcome in bad:
        print(f"{outcome.case.name}: {outcome.what}: {outcome.details.splitlines()[-1] if outcome.details else ''}")
    print(f"{dict(counts)}; {len(bad)} bad, kept in {folder}" if bad else f"{dict(counts)}; none bad")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
