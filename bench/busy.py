"""Time of analyses whose dense solves are small, with the threads of BLAS that the machine gives, idle and busy (``--json``).

Other processes take the processor while a thread of BLAS waits for another: on such a machine a solve of a few dozen unknowns
by two threads takes many times as long as by one.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import jointed

SPIN = "while True: pass"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--repeat", type=int, default=3, help="calls of a case (default: 3)")
    options = parser.parse_args()
    rows = measured(options.repeat)
    if options.json:
        print(json.dumps({"processors": os.cpu_count(), "rows": rows}, indent=2))
        return
    for row in rows:
        print(f"{row['case']:12s} idle {row['idle']:8.3f} s   busy {row['busy']:8.3f} s")


def measured(repeat: int) -> list[dict[str, object]]:
    """Medians of the seconds of a call by case: idle, and beside a process on every processor that does nothing but spin."""
    cases = {name: make() for name, make in CASES.items()}
    for work in cases.values():
        work()
    rows: list[dict[str, object]] = [{"case": name, "idle": _median(work, repeat)} for name, work in cases.items()]
    with spinning(os.cpu_count() or 1):
        for row, work in zip(rows, cases.values(), strict=True):
            row["busy"] = _median(work, repeat)
    return rows


def _median(work: Callable[[], object], repeat: int) -> float:
    taken = []
    for _ in range(repeat):
        begin = time.perf_counter()
        work()
        taken.append(time.perf_counter() - begin)
    return statistics.median(taken)


@contextmanager
def spinning(count: int) -> Iterator[None]:
    """So many processes that spin."""
    running = [subprocess.Popen([sys.executable, "-c", SPIN]) for _ in range(count)]
    try:
        yield
    finally:
        for one in running:
            one.kill()
            one.wait()


def lee(parts: int) -> Callable[[], object]:
    """25 points of the path of Lee's frame: two legs of 1.2 m, hinged at their ends, a load at a fifth of the upper one."""
    import kinetruss as kt

    at = [1.2 * i / parts for i in range(parts + 1)]
    nodes = {f"C{i}": (0.0, y) for i, y in enumerate(at)} | {f"B{i}": (x, 1.2) for i, x in enumerate(at) if i}
    names = [f"C{i}" for i in range(parts + 1)] + [f"B{i}" for i in range(1, parts + 1)]
    beams = {f"e{i}": pair for i, pair in enumerate(pairwise(names))}
    model = kt.Model(
        nodes=nodes, fixed=(names[0], names[-1]), beams=beams,
        section=kt.Rectangle(width=0.03, height=0.02), material={"E": 7.2e9, "density": 0.0},
        loads={"push": kt.NodalForce(node=f"B{max(1, parts // 5)}", force=(0.0, -1.0))},
    )  # fmt: skip
    return lambda: kt.statics.path(model, "push", points=25)


def frame(storeys: int, large: bool) -> Callable[[], object]:
    """A frame of beams at rest."""
    import kinetruss as kt

    model = jointed.frame(storeys)
    return lambda: kt.statics.equilibrium(model) if large else kt.statics.linear(model)


def linearise() -> Callable[[], object]:
    """Small motions of a frame about its drawing."""
    import kinetruss as kt

    model = jointed.frame(4)
    return lambda: kt.dynamics.linearise(model)


CASES = {"lee": lambda: lee(10), "at rest": lambda: frame(4, True), "linear": lambda: frame(8, False), "linearise": linearise}

if __name__ == "__main__":
    main()
