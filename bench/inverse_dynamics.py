"""Time, memory and error of inverse dynamics of a chain of double-octahedral bays (``--json`` for one object).

From the pose trajectory on: kinematics, inverse dynamics (total forces), section forces of all members at 7 stations;
1,000 samples, one thread. Each number of bays runs in a process of its own, so that its peak memory is its own.
"""

from __future__ import annotations

import argparse
import itertools
import json
import math
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

BAYS = (1, 3, 10, 50)
SAMPLES = 1000
STATIONS = 7
DURATION = 3.0
TILT = math.radians(10)
CHECKED = (137, 500, 871)
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS", "BLIS_NUM_THREADS")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--bays", type=int, nargs="+", default=BAYS, help="numbers of bays (default: 1 3 10 50)")
    parser.add_argument("--row", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.row:
        json.dump(row(options.row), sys.stdout)
        return
    _child(1)  # compiled kernels are cached before anything is measured
    rows = [_child(bays) for bays in options.bays]
    if options.json:
        kept = ("bays", "us_per_sample", "peak_mb", "max_relative_error")
        json.dump({"rows": [{name: r[name] for name in kept} for r in rows], "exponent": exponent(rows)}, sys.stdout, indent=2)
        sys.stdout.write("\n")
    else:
        _table(rows)


def exponent(rows: list[dict]) -> float | None:
    """Slope of log time over log bays, least squares, from 3 bays on."""
    points = [(math.log(r["bays"]), math.log(r["us_per_sample"])) for r in rows if r["bays"] >= 3]
    if len(points) < 2:
        return None
    x, y = (statistics.fmean(values) for values in zip(*points, strict=True))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)


def _child(bays: int) -> dict:
    command = [sys.executable, __file__, "--row", str(bays)]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=os.environ | dict.fromkeys(THREADS, "1"))
    return json.loads(done.stdout)


def row(bays: int) -> dict:
    """Median time of several runs after a warm-up, peak memory above the level after import, error of the forces."""
    import kinetruss as kt

    _ = kt.kinematics.follow, kt.dynamics.inverse, kt.strength.sections, kt.library.vgt.double_octahedral
    level = _resident()
    model = kt.library.vgt.double_octahedral(bays=bays, payload_mass=2.0, gravity=(0.0, 0.0, -9.81))
    trajectory = motion_of(kt, model)
    runs = []
    for _ in range(1 + max(5, 30 // bays)):
        seconds, forces = _timed(kt, model, trajectory)
        runs.append(seconds)
    peak = _peak()
    stages = [statistics.median(stage) / SAMPLES * 1e6 for stage in zip(*runs[1:], strict=True)]
    total = statistics.median(sum(run) for run in runs[1:]) / SAMPLES * 1e6
    return {
        "bays": bays, "us_per_sample": total, "peak_mb": (peak - level) / 1e6,
        "max_relative_error": largest_error(model, forces, bays), "stages": stages,
    }  # fmt: skip


def motion_of(kt, model):
    """Every bay tilts about both axes at once, 0 to 10 degrees, quintic in time."""
    moves = {f"{pose}.{angle}": (0.0, TILT) for pose in model.poses for angle in ("beta", "gamma")}
    return kt.Quintic(moves=moves, duration=DURATION)


def _timed(kt, model, trajectory):
    """Seconds of kinematics, inverse dynamics and section forces."""
    marks = [time.perf_counter()]
    motion = kt.kinematics.follow(model, trajectory, samples=SAMPLES)
    marks.append(time.perf_counter())
    forces = kt.dynamics.inverse(model, motion, static=False)
    marks.append(time.perf_counter())
    kt.strength.sections(model, forces, stations=STATIONS)
    marks.append(time.perf_counter())
    return [b - a for a, b in itertools.pairwise(marks)], forces


def largest_error(model, forces, bays: int) -> float:
    """Largest difference of any joint force from the dense Newton-Euler form, over its largest force.

    The oracle's motion is the closed form of each bay, so an error of the kinematics counts as well.
    """
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
    import numpy as np

    from reference import newton_euler, recursive_bays
    from reference.octahedral import MEMBERS, Bay, quintic
    from reference.taylor import Taylor

    bay, worst = Bay(), 0.0
    truss = recursive_bays.chain_truss(bay, bays, np.array([0, 0, -9.81]), tip_mass=2.0)
    names = member_names(model, bays, MEMBERS)
    height = Taylor(np.array(1.1218253458835146), np.array(0.0), np.array(0.0))
    for index in CHECKED:
        angle = quintic(float(forces.data["time"][index]), DURATION, 0.0, TILT)
        motions = recursive_bays.bay_motions(bay, [(angle, angle, height)] * bays)
        oracle = newton_euler.solve(truss, *recursive_bays.chain_motion(motions))
        expected = np.stack([oracle.force_a, oracle.force_b], 1)
        found = forces.joint_force.isel(time=index).sel(member=names).values
        worst = max(worst, float(np.abs(found - expected).max() / np.abs(expected).max()))
    return worst


def member_names(model, bays: int, thesis: dict) -> list[str]:
    """The model's names of the members, bay by bay in the thesis' order."""
    return [name if bays == 1 and name in model.members else f"B{k + 1}.{name}" for k in range(bays) for name in thesis]


def _resident() -> int:
    """Bytes held now."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def _peak() -> int:
    """Most bytes ever held."""
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def _table(rows: list[dict]) -> None:
    titles = ("us/sample", "us/bay", "kinematics", "forces", "sections", "peak MB", "error")
    print("  bays" + "".join(f"{title:>12}" for title in titles))
    for r in rows:
        numbers = [r["us_per_sample"], r["us_per_sample"] / r["bays"], *r["stages"], r["peak_mb"]]
        print(f"{r['bays']:6d}" + "".join(f"{number:12.2f}" for number in numbers) + f"{r['max_relative_error']:12.1e}")
    slope = exponent(rows)
    if slope is not None:
        print(f"time grows as bays^{slope:.3f} (from 3 bays on)")


if __name__ == "__main__":
    main()
