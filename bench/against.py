"""Time of the main calls beside another revision: medians of both and their ratio (``--json`` for one object).

    python bench/against.py REV [--rounds N] [--cases NAME ...] [--json]

A round is a process of each revision; they take turns at every call, so that a slow spell of the machine, which makes calls
1.6 times slower for seconds, meets both alike. Times are processor seconds of one call with compiled kernels. Two processes of
the same code differ by up to a fifth for as long as they live: the ratio is the median over the rounds. Exit code 1 where it is
above 1.1.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import jointed
from revision import checkout

HERE = Path(__file__).resolve().parents[1]
LARGEST = 1.10
LEAST, FEWEST = 0.3, 5
"""Processor seconds that a case is repeated for in a round, once warm, and calls."""
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("revision", metavar="REV", help="what to compare with")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--rounds", type=int, default=5, help="processes of each revision (default: 5)")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES), help="which (default: all)")
    parser.add_argument("--measure", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.measure:
        return answer()
    with tempfile.TemporaryDirectory() as folder:
        checkout(options.revision, Path(folder), "src")
        rows = measured({"now": HERE / "src", "then": Path(folder) / "src"}, options.rounds, options.cases)
    if options.json:
        print(json.dumps({"revision": options.revision, "rounds": options.rounds, "rows": rows}, indent=2))
    else:
        for row in rows:
            print(f"{row['case']:18s} {1e3 * row['now']:10.3f} ms {1e3 * row['then']:10.3f} ms   ratio {row['ratio']:.3f}")
    return 1 if any(row["ratio"] > LARGEST for row in rows) else 0


def measured(sources: dict[str, Path], rounds: int, cases: list[str]) -> list[dict[str, Any]]:
    """Medians of the calls of a round, s, and of their ratio, over the rounds."""
    taken: dict[str, dict[str, list[float]]] = {case: {side: [] for side in sources} for case in cases}
    for turn in range(rounds):
        running = {side: _child(source) for side, source in sources.items()}
        for case in cases:
            for one in running.values():
                call(one, case)  # makes it ready and calls it once, which compiles
            for side, times in _in_turns(running, first=turn % 2).items():
                taken[case][side].append(statistics.median(times))
        for one in running.values():
            one.communicate()
    rows = []
    for case, found in taken.items():
        now, then = (statistics.median(found[side]) for side in ("now", "then"))
        ratio = statistics.median(one / other for one, other in zip(found["now"], found["then"], strict=True))
        rows.append({"case": case, "now": now, "then": then, "ratio": ratio})
    return rows


def _in_turns(running: dict[str, subprocess.Popen[str]], first: int) -> dict[str, list[float]]:
    """Times of single calls; the sides go by turns, and so does which of them is first."""
    taken: dict[str, list[float]] = {side: [] for side in running}
    count = 0
    while count < FEWEST or min(map(sum, taken.values())) < LEAST:
        for side in list(running)[:: 1 if (first + count) % 2 else -1]:
            taken[side].append(call(running[side]))
        count += 1
    return taken


def _child(source: Path) -> subprocess.Popen[str]:
    command = [sys.executable, __file__, "-", "--measure"]
    environment = os.environ | {"PYTHONPATH": str(source)} | dict.fromkeys(THREADS, "1")
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)


def call(process: subprocess.Popen[str], case: str = "") -> float:
    """Seconds of a call of the present case, or of the first one of another."""
    assert process.stdin is not None
    assert process.stdout is not None
    print(case, file=process.stdin, flush=True)
    if not (line := process.stdout.readline()):
        raise subprocess.CalledProcessError(process.wait(), process.args)
    return float(line)


def answer() -> int:
    """Call what each line of the input names, or again what the last one named; its processor seconds, line by line."""
    for line in sys.stdin:
        if name := line.strip():
            work = CASES[name]()
        before = time.process_time()
        work()
        print(time.process_time() - before, flush=True)
    return 0


def follow(bays: int, samples: int) -> Callable[[], object]:
    """The motion of a chain of bays, or of a four-bar (0)."""
    import kinetruss as kt

    model, path = _driven(bays)
    return lambda: kt.kinematics.follow(model, path, samples=samples)


def inverse(bays: int, samples: int) -> Callable[[], object]:
    """The forces of that motion."""
    import kinetruss as kt

    model, path = _driven(bays)
    motion = kt.kinematics.follow(model, path, samples=samples)
    return lambda: kt.dynamics.inverse(model, motion)


def _driven(bays: int) -> tuple[Any, Any]:
    import kinetruss as kt
    from kinetruss.library import vgt

    if bays:
        tilt = (0.0, 0.17)
        return vgt.double_octahedral(bays), vgt.slew(bays, beta=tilt, gamma=tilt, duration=3.0)
    nodes = {"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)}
    bars = {"crank": kt.Bar(ends=("A", "B"), mass=0.2), "coupler": kt.Bar(ends=("B", "C"), mass=0.5),
            "rocker": kt.Bar(ends=("C", "D"), mass=0.3)}  # fmt: skip
    model = kt.Model(nodes=nodes, fixed=("A", "D"), bars=bars, gravity=(0, -9.81), drives={"motor": kt.AngleDrive("crank")})
    return model, kt.ConstantRate(rates={"motor": 10.0}, duration=0.6283)


def simulate(loops: int, t_end: float) -> Callable[[], object]:
    """Windows of links that fall."""
    import kinetruss as kt
    from kinetruss.library import mechanisms

    model = mechanisms.n_four_bar(loops, angle=0.4)
    return lambda: kt.dynamics.simulate(model, t_end, samples=3, method=kt.DOP853(rtol=1e-6, atol=1e-6))


def springs(bays: int, steps: int) -> Callable[[], object]:
    """A chain of bays whose drives are let go, in implicit steps."""
    import kinetruss as kt
    from kinetruss.library import vgt

    model = vgt.double_octahedral(bays)
    tasks, method = {name: kt.Free() for name in model.all_drives}, kt.GeneralizedAlpha(step=1e-4)
    return lambda: kt.dynamics.simulate(model, steps * 1e-4, samples=3, method=method, tasks=tasks)


def linear(panels: int) -> Callable[[], object]:
    """A cantilever of square panels with both diagonals."""
    import kinetruss as kt

    nodes = {f"{row}{i}": (float(i), float(row == "T")) for i in range(panels + 1) for row in "BT"}
    bars = {f"c{row}{i}": (f"{row}{i}", f"{row}{i + 1}") for i in range(panels) for row in "BT"}
    bars |= {f"d{i}": (f"B{i}", f"T{i + 1}") for i in range(panels)} | {f"e{i}": (f"T{i}", f"B{i + 1}") for i in range(panels)}
    bars |= {f"v{i}": (f"B{i}", f"T{i}") for i in range(1, panels + 1)}
    model = kt.Model(nodes=nodes, bars=bars, fixed=("B0", "T0"), section=kt.Rod(diameter=0.02), material="steel_s235",
                     loads={"tip": kt.NodalForce(node=f"T{panels}", force=(0.0, -1.0))})  # fmt: skip
    return lambda: kt.statics.linear(model)


def linearise(bays: int) -> Callable[[], object]:
    """Small motions of a chain of bays whose drives are let go."""
    import kinetruss as kt
    from kinetruss.library import vgt

    model = vgt.double_octahedral(bays)
    return lambda: kt.dynamics.linearise(model, free=model.all_drives, dofs=list(model.all_drives))


def frame(storeys: int, large: bool) -> Callable[[], object]:
    """A frame of beams at rest, with small displacements or large ones."""
    import kinetruss as kt

    model = jointed.frame(storeys)
    return lambda: kt.statics.equilibrium(model) if large else kt.statics.linear(model)


def swinging_frame(storeys: int, steps: int) -> Callable[[], object]:
    """The same let go from its drawing, in implicit steps."""
    import kinetruss as kt

    model, method = jointed.frame(storeys), kt.GeneralizedAlpha(step=1e-3)
    return lambda: kt.dynamics.simulate(model, steps * 1e-3, samples=3, method=method)


def stiff(bays: int, t_end: float) -> Callable[[], object]:
    """A chain of bays on springs, let go, by Radau."""
    import kinetruss as kt
    from kinetruss.library import vgt

    model = vgt.double_octahedral(bays)
    tasks = {name: kt.Free() for name in model.all_drives}
    return lambda: kt.dynamics.simulate(model, t_end, samples=3, method=kt.Radau(), tasks=tasks)


def turned(model: Any, samples: int) -> Callable[[], object]:
    """Motion and forces of a model whose drives turn."""
    import kinetruss as kt

    path = kt.ConstantRate(rates=dict.fromkeys(model.all_drives, 0.5), duration=0.5)
    return lambda: kt.dynamics.inverse(model, kt.kinematics.follow(model, path, samples=samples))


def let_go(model: Any, t_end: float) -> Callable[[], object]:
    """A model that moves by itself, its drives free."""
    import kinetruss as kt

    tasks, method = {name: kt.Free() for name in model.all_drives}, kt.DOP853(rtol=1e-6, atol=1e-6)
    return lambda: kt.dynamics.simulate(model, t_end, samples=3, tasks=tasks, method=method)


CASES: dict[str, Callable[[], Callable[[], object]]] = {
    "follow small": lambda: follow(0, 1000), "follow large": lambda: follow(50, 100),
    "inverse small": lambda: inverse(0, 1000), "inverse large": lambda: inverse(50, 100),
    "simulate small": lambda: simulate(1, 1.0), "simulate large": lambda: simulate(1000, 0.05),
    "implicit large": lambda: springs(10, 20), "radau": lambda: stiff(5, 0.02),
    "linear small": lambda: linear(10), "linear large": lambda: linear(2000),
    "linearise": lambda: linearise(5),
    "beams linear": lambda: frame(40, large=False), "beams at rest": lambda: frame(4, large=True),
    "beams implicit": lambda: swinging_frame(4, 20), "beams driven": lambda: turned(jointed.elastic_crank(4), 200),
    "hinges in space": lambda: turned(jointed.hinged_arm(), 200), "hubs": lambda: turned(jointed.crank_in_space(), 200),
    "bearings": lambda: let_go(jointed.crank_in_space(0.2), 0.02), "springs": lambda: let_go(jointed.sprung_links(8), 0.5),
}  # fmt: skip


if __name__ == "__main__":
    sys.exit(main())
