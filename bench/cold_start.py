"""Seconds of a first start, with an empty cache of kernels: processor and wall time (``--json`` for one object).

Two starts of a four-bar, each in a process of its own: `follow`, `dynamics.inverse` and `strength.check`; `simulate` alone. Two
of a crank in space with hubs, hinges and a bearing, and of links with springs and a coupling; one of a frame of beams.
``--against REV`` measures another revision too, checked out into a temporary folder, in turn with this one.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))  # also where it is run as a module

from revision import checkout

HERE = Path(__file__).resolve().parents[1]
FOUR_BAR = """
import kinetruss as kt
model = kt.Model(
    nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)}, fixed=("A", "D"), gravity=(0, -9.81),
    bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
    section=kt.Rectangle(width=0.020, height=0.005), material=kt.library.materials.STEEL_S235,
    drives={"motor": kt.AngleDrive("crank")},
)
"""
JOINTED = f"""
import sys
sys.path.insert(0, {str(Path(__file__).resolve().parent)!r})
import jointed
import kinetruss as kt
"""
STARTS = {
    "inverse": FOUR_BAR
    + """
motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 10.0}, duration=0.6283))
kt.strength.check(model, kt.dynamics.inverse(model, motion))
""",
    "simulate": FOUR_BAR
    + """
kt.dynamics.simulate(model, t_end=1.0, tasks={"motor": kt.Free()})
""",
    "hubs": JOINTED
    + """
model = jointed.crank_in_space(0.2)
kt.dynamics.inverse(model, kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 0.5}, duration=0.5), samples=11))
""",
    "springs": JOINTED
    + """
kt.dynamics.simulate(jointed.sprung_links(4), t_end=0.2)
""",
    "beams": JOINTED
    + """
kt.statics.equilibrium(jointed.frame(2))
""",
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--against", metavar="REV", help="another revision, measured in turn with this one")
    parser.add_argument("--rounds", type=int, default=1, help="starts of each kind; medians are told (default: 1)")
    parser.add_argument("--starts", nargs="+", choices=STARTS, default=list(STARTS), help="which starts (default: all)")
    options = parser.parse_args()
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        # without what lies beside the sources of this checkout: kernels compiled before
        shutil.copytree(HERE / "src", folder / "here" / "src", ignore=shutil.ignore_patterns("__pycache__"))
        sources = {"here": folder / "here" / "src"}
        if options.against:
            checkout(options.against, folder / "there", "src")
            sources[options.against] = folder / "there" / "src"
        rows = measured(sources, options.starts, options.rounds)
    if options.json:
        print(json.dumps({"rows": rows}))
        return
    for row in rows:
        print(f"{row['start']:10s} {row['revision']:12s} {row['cpu_s']:7.1f} s processor {row['wall_s']:7.1f} s wall")


def measured(sources: dict[str, Path], starts: list[str], rounds: int) -> list[dict[str, Any]]:
    """Medians over the rounds; revisions take turns, so that a slow spell of the machine meets all of them."""
    taken: dict[tuple[str, str], list[tuple[float, float]]] = {}
    for _ in range(rounds):
        for start in starts:
            for name, source in sources.items():
                taken.setdefault((start, name), []).append(first_start(source, start))
    return [
        {
            "start": start,
            "revision": name,
            "cpu_s": statistics.median(c for c, _ in found),
            "wall_s": statistics.median(w for _, w in found),
        }
        for (start, name), found in taken.items()
    ]


def first_start(source: Path, start: str) -> tuple[float, float]:
    """Processor and wall seconds of one start with an empty cache."""
    with tempfile.TemporaryDirectory() as cache:
        environment = os.environ | {"PYTHONPATH": str(source), "NUMBA_CACHE_DIR": cache}
        before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run([sys.executable, "-c", STARTS[start]], env=environment, check=True)
        wall, after = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


if __name__ == "__main__":
    main()
