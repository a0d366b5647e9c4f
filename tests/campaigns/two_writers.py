"""Several processes at one run folder, at random moments: the second is refused, and nothing is lost, mixed or half shown.

    .venv/bin/python tests/campaigns/two_writers.py --work DIR [--rounds 60] [--seed 1]

Every round does one of five things to a folder that a run is being written to: start others on it, start several at once, kill
the first and let several go on, read it all the time, take it away. Whatever can be read in the end, and at any time between,
must be the first samples of a run that nobody disturbed, bit for bit. Exit code 1 where it is not, or at any traceback.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import random
import shutil
import signal
import socket
import sys
import time
import traceback
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

import kinetruss as kt
from kinetruss.io import export
from kinetruss.report import summary
from kinetruss.runs import load, resume, run, run_variants

SAMPLES, BLOCK, T_END = 1201, 25, 12.0
DONE, REFUSED, BROKEN = 0, 3, 4
PASSING = ("Read it again", "no good sample", "has just been started", "is not a kinetruss run", "is damaged: [Errno 2]")
"""What a reader may be told at the moment in which a run takes the place of another."""
Work = Callable[[Path], object]


def model(**changes: object) -> kt.Model:
    """A chaotic double pendulum: one wrong bit would show."""
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=0.5), "B": kt.Node(at=(0.8, 0.1), mass=0.5)}, fixed=("O",),
        bars={"upper": kt.Bar(ends=("O", "A"), mass=0), "lower": kt.Bar(ends=("A", "B"), mass=0)}, gravity=(0, -9.81),
        runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=T_END, samples=SAMPLES).with_(**changes)},
    )  # fmt: skip


class Campaign:
    """The rounds. faults : what was wrong. counts : what happened."""

    def __init__(self, work: Path, seed: int) -> None:
        self.work, self.dice = work, random.Random(seed)
        self.faults: list[str] = []
        self.counts: Counter[str] = Counter()
        shutil.rmtree(work / "gone", ignore_errors=True)  # of a campaign that was cut off
        work.mkdir(parents=True, exist_ok=True)
        self.wanted = run(model(), block=BLOCK).motion.position.values
        self.short = run(model(samples=3), block=BLOCK).motion.position.values
        self.ways: dict[str, Work] = {
            "plain": lambda out: run(model(), out=out, block=BLOCK),
            "overwrite": lambda out: run(model(), out=out, block=BLOCK, overwrite=True),
            "resume": resume,
            "variants": lambda out: run_variants(model(), {"runs.fall.samples": [3, 4]}, out=out, overwrite=True),
            "one variant": lambda out: run_variants(model(), {"runs.fall.samples": [3]}, out=out, overwrite=True),
        }

    # -- processes -------------------------------------------------------------------------------------------------

    def child(self, work: Work, out: Path) -> int:
        """A copy of this process that does some work on a folder; kernels are loaded already."""
        sys.stdout.flush()
        pid = os.fork()
        if pid:
            return pid
        code = BROKEN
        try:
            work(out)
            code = DONE
        except kt.KinetrussError as error:
            self.note(os.getpid()).write_text(f"{type(error).__name__}: {error}")
            code = REFUSED
        except BaseException:  # noqa: BLE001 - the parent tells it
            self.note(os.getpid()).write_text(traceback.format_exc())
        os._exit(code)

    def note(self, pid: int) -> Path:
        return self.work / f"{pid}.txt"

    def ended(self, pid: int, what: str) -> tuple[int, str]:
        """Exit code and words of a child; a traceback is a fault."""
        status = os.waitpid(pid, 0)[1]
        code = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
        text = self.note(pid).read_text() if self.note(pid).exists() else ""
        self.note(pid).unlink(missing_ok=True)
        self.counts[f"{what}: {({DONE: 'done', REFUSED: 'refused', BROKEN: 'traceback'}).get(code, 'killed')}"] += 1
        if code == BROKEN or code not in (DONE, REFUSED, -signal.SIGKILL):
            self.fault(f"{what} ended with {code}: {text}")
        return code, text

    def fault(self, text: str) -> None:
        self.faults.append(text)
        print(f"FAULT {text}", file=sys.stderr, flush=True)

    def wait(self, out: Path, pid: int) -> bool:
        """Until a run has some good samples; False where it has ended before."""
        least = BLOCK * self.dice.randrange(0, SAMPLES // BLOCK // 2)
        while committed(out) < least:
            if os.waitid(os.P_PID, pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None:
                return False
            time.sleep(0.001)
        time.sleep(self.dice.uniform(0.0, 0.01))
        return True

    # -- what must hold --------------------------------------------------------------------------------------------

    def check(self, out: Path, what: str, *, whole: bool) -> None:
        """The run in a folder, or the variants in it, are the first samples of an undisturbed one."""
        for path in [out] if (out / "kinetruss.json").exists() else sorted(item for item in out.iterdir() if item.is_dir()):
            try:
                found = load(path)
                self.compare(found, what)
                if whole and not found.whole:
                    self.fault(f"{what}: {path} is {found.state}, {found.good} of {found.samples}")
            except kt.KinetrussError as error:
                self.fault(f"{what}: {path} cannot be read: {error}")
        left = [item.name for item in out.rglob("*") if item.suffix in (".part", ".lock")]
        if whole and left:
            self.fault(f"{what}: left over: {left}")

    def compare(self, found: kt.runs.RunResult, what: str) -> None:
        positions = found.motion.position.values
        if found.samples == SAMPLES:
            good = np.array_equal(positions, self.wanted[: found.good])
        else:  # few samples of the same motion, at other instants
            good = bool(np.isfinite(positions).all()) and len(positions) == found.good
            good &= found.samples != len(self.short) or np.array_equal(positions, self.short[: found.good])
        if not good:
            self.fault(f"{what}: positions are not those of an undisturbed run ({found.good} of {found.samples} samples)")

    def refused(self, text: str, holders: Sequence[int], what: str) -> None:
        """A refusal names a process that holds the folder; or the folder is found as the first left it."""
        if "being written" in text:
            if not any(f"process {pid} on {socket.gethostname()}, since " in text for pid in holders):
                self.fault(f"{what}: the refusal names none of {list(holders)}: {text}")
        elif not any(
            words in text for words in ("holds a run already", "has ended", "is not a kinetruss run", "is not empty", *PASSING)
        ):
            self.fault(f"{what}: refused for another reason: {text}")

    # -- rounds ----------------------------------------------------------------------------------------------------

    def second(self, out: Path) -> None:
        """One comes while another writes."""
        way = self.dice.choice(list(self.ways))
        first = self.child(self.ways["plain"], out)
        busy = self.wait(out, first)
        other = self.child(self.ways[way], out)
        code, text = self.ended(other, way)
        if code == REFUSED:
            self.refused(text, [first], way)
        elif busy and os.waitid(os.P_PID, first, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None:
            self.fault(f"{way} was let in while the first was writing")
        if self.ended(first, "first")[0] != DONE:
            self.fault(f"the first did not end well against {way}")
        self.check(out, way, whole=True)

    def at_once(self, out: Path) -> None:
        """Several begin at the same moment, in an empty folder or over a run."""
        if self.dice.random() < 0.5:
            run(model(samples=3), out=out)
        ways = [self.dice.choice(["plain", "overwrite"]) for _ in range(self.dice.randrange(2, 5))] + ["overwrite"]
        pids = [self.child(self.ways[way], out) for way in ways]
        codes = []
        for way, pid in zip(ways, pids, strict=True):
            code, text = self.ended(pid, f"at once, {way}")
            codes.append(code)
            if code == REFUSED:
                self.refused(text, pids, f"at once, {way}")
        if DONE not in codes:
            self.fault("of several at once none was let in")
        self.check(out, "at once", whole=True)

    def killed(self, out: Path) -> None:
        """The first is killed; several want to go on, or to begin anew."""
        first = self.child(self.ways["plain"], out)
        self.wait(out, first)
        os.kill(first, signal.SIGKILL)
        self.ended(first, "first")
        ways = [self.dice.choice(["resume", "resume", "overwrite"]) for _ in range(3)]
        pids = [self.child(self.ways[way], out) for way in ways]
        for way, pid in zip(ways, pids, strict=True):
            code, text = self.ended(pid, f"after a kill, {way}")
            if code == REFUSED and "damaged" not in text:
                self.refused(text, [*pids, first], f"after a kill, {way}")
        if not (out / "kinetruss.json").exists():  # it was killed before it had begun
            run(model(), out=out, block=BLOCK)
        self.check(out, f"after a kill, {'/'.join(ways)}", whole=True)

    def read(self, out: Path) -> None:
        """Others read all the time, while runs are written and replaced."""
        first = self.child(lambda path: [run(model(), out=path, block=BLOCK, overwrite=True) for _ in range(2)], out)
        reads = 0
        while os.waitid(os.P_PID, first, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None or not reads:
            try:
                found = load(out)
                if self.dice.random() < 0.7:
                    self.compare(found, "read")
                elif self.dice.random() < 0.5:
                    told = summary(found).record
                    if found.state != "finished" and (told["whole"] or told["state"] == "finished"):
                        self.fault(f"read: an unfinished run is told as whole: {told['state']}")
                else:
                    self.exported(out)
                reads += 1
            except kt.KinetrussError as error:
                self.counts["read: refused"] += 1
                time.sleep(0.002)
                if not any(words in str(error) for words in PASSING):
                    self.fault(f"read: refused for another reason: {error}")
        self.counts["read: read"] += reads
        if self.ended(first, "first, read")[0] != DONE:
            self.fault("a run that was read did not end well")
        self.check(out, "read", whole=True)

    def exported(self, out: Path) -> None:
        file = self.work / "read.csv"
        export(out, file, groups=("motion",))
        with file.open(newline="", encoding="utf-8") as text:
            head, *rows = csv.reader(text)
        columns = [k for k, name in enumerate(head) if name.startswith("motion.position[")]
        found = np.array([[float(row[k]) for k in columns] for row in rows])
        if not np.array_equal(found, self.wanted[: len(found)].reshape(len(found), -1)):
            self.fault(f"read: {len(found)} exported rows are not those of an undisturbed run")

    def gone(self, out: Path) -> None:
        """The folder is taken away, and perhaps another run put there."""
        first = self.child(self.ways["plain"], out)
        self.wait(out, first)
        out.rename(out.with_name("gone"))
        replaced = self.dice.random() < 0.5
        if replaced:
            run(model(), out=out, block=BLOCK)
        code, text = self.ended(first, "gone")
        if code == REFUSED and not any(
            words in text for words in ("was removed or replaced", "changed by another program", "is not a kinetruss run")
        ):
            self.fault(f"gone: {text}")
        if replaced:
            self.check(out, "gone", whole=True)
        elif out.exists():
            self.fault("gone: the writer has made its folder again")
        shutil.rmtree(out.with_name("gone"))


def committed(out: Path) -> int:
    """Good samples of a run that may not be there yet."""
    try:
        return int(json.loads((out / "kinetruss.json").read_text("utf-8"))["committed"])
    except (OSError, ValueError):
        return -1


def campaign(work: Path, rounds: int, seed: int) -> Campaign:
    """So many rounds; the kinds take turns."""
    found = Campaign(work, seed)
    kinds = (found.second, found.killed, found.at_once, found.read, found.gone)
    for k in range(rounds):
        out = work / "out"
        shutil.rmtree(out, ignore_errors=True)
        kinds[k % len(kinds)](out)
        if (k + 1) % 10 == 0 or k + 1 == rounds:
            print(f"{k + 1} of {rounds} rounds, {len(found.faults)} faults", file=sys.stderr, flush=True)
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the campaign; 1 at a fault."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--work", type=Path, required=True, help="folder for the runs")
    options.add_argument("--rounds", type=int, default=60)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args(arguments)
    found = campaign(chosen.work, chosen.rounds, chosen.seed)
    print(json.dumps({"rounds": chosen.rounds, "seed": chosen.seed, "faults": len(found.faults), "counts": found.counts}))
    return 1 if found.faults else 0


if __name__ == "__main__":
    sys.exit(main())
