"""Time and memory of a mission of 100 pairs, and of docking inverse kinematics (``--json`` for one object).

The mission: a chain of ten double-octahedral bays, 10 motions x 5 load cases x 2 conditions, 500 samples a pair, kept in
memory. It runs in a process of its own; the second of two missions counts (the first loads the kernels). `peak_mb` is the peak
resident memory above that before the first pair.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

BAYS, MOTIONS, CASES, SAMPLES = 10, 10, 5, 500
TILT, PULL = 0.08, 20.0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--pairs", type=int, default=MOTIONS * CASES * 2, help="pairs of the mission (default: 100)")
    parser.add_argument("--row", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.row:
        json.dump(row(options.pairs), sys.stdout)
        return
    command = [sys.executable, __file__, "--row", "--pairs", str(options.pairs)]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    rows = [json.loads(done.stdout), *docking()]
    if options.json:
        json.dump({"rows": rows}, sys.stdout, indent=2)
        sys.stdout.write("\n")
        return
    for one in rows:
        speed = f"{one['poses']} poses, {one['us_per_pose']:.1f} us each"
        print(f"{one['case']}: {one['seconds']:.2f} s, {speed}, {one['peak_mb']:.0f} MB")


def row(pairs: int) -> dict[str, Any]:
    """One mission, timed."""
    import kinetruss as kt

    model = task(kt, max(1, pairs // (CASES * 2)))
    kt.run(task(kt, 1))
    before = _peak()
    start = time.perf_counter()
    mission = kt.run(model)
    seconds = time.perf_counter() - start
    poses = int(mission.pairs["samples"].values.sum())
    return {
        "case": f"mission of {mission.good} pairs", "seconds": seconds, "poses": poses, "us_per_pose": 1e6 * seconds / poses,
        "peak_mb": _peak() - before,
    }  # fmt: skip


def task(kt: Any, motions: int) -> Any:
    """The chain and its mission."""
    chain = kt.library.vgt.double_octahedral(
        bays=BAYS, payload_mass=0.5, gravity=(0.0, 0.0, -9.81), material="aluminium_6061_t6"
    )
    tip = list(chain.nodes)[-1]
    names = [f"{pose}.{angle}" for pose in chain.poses for angle in ("beta", "gamma")]
    moves = {
        f"move{k}": {name: (0.0, TILT * (1 - 2 * ((3 * k + 5 * i) % 7) / 6)) for i, name in enumerate(names)}
        for k in range(motions)
    }
    pulls = {f"pull{k}": (PULL * (k - 2), PULL * ((2 * k) % 5 - 2), -PULL * k) for k in range(CASES)}
    return chain.with_(
        trajectories={name: kt.Quintic(moves=move, duration=5.0) for name, move in moves.items()},
        loads={name: kt.NodalForce(node=tip, force=force) for name, force in pulls.items()},
        load_cases={name: kt.LoadCase(loads={name: 1.0}) for name in pulls},
        conditions={"standing": kt.Condition(), "lying": kt.Condition(gravity=(0.0, -9.81, 0.0), payloads={tip: 3.0})},
        runs={"mission": kt.Run(analysis="mission", motions=tuple(moves), conditions=("standing", "lying"), samples=SAMPLES)},
    )


def docking() -> list[dict[str, Any]]:
    """The rows of the bench of docking inverse kinematics beside this file, if it is there."""
    file = Path(__file__).with_name("docking.py")
    if not file.is_file():
        return []
    spec: Any = importlib.util.spec_from_file_location("docking", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found: list[dict[str, Any]] = module.rows()
    return found


def _peak() -> float:
    """Peak resident memory, MB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3


if __name__ == "__main__":
    main()
