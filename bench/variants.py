"""Time of a run in many variants (``--json`` for one object).

A double-octahedral bay slews in durations of its own, all results of 500 samples stored: motion, forces in motion and at
rest, utilisation, motor demands. `seconds` is the call from Python with the kernels loaded, `command_seconds` the command
line from its start to its end.
"""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SAMPLES = 500
VARIANTS = (1, 100)
REPEATS = 5
START = "from kinetruss.cli import main; main()"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--variants", type=int, nargs="+", default=VARIANTS, help="numbers of variants (default: 1 100)")
    parser.add_argument("--repeats", type=int, default=REPEATS, help="measurements; the median counts (default: 5)")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [row(count, Path(folder), options.repeats) for count in options.variants]
    if options.json:
        json.dump({"rows": rows}, sys.stdout, indent=2)
        sys.stdout.write("\n")
    else:
        print("variants  seconds  ms/variant  command")
        for r in rows:
            per = 1e3 * r["seconds"] / r["variants"]
            print(f"{r['variants']:8d}{r['seconds']:9.2f}{per:12.1f}{r['command_seconds']:9.2f}")


def row(count: int, folder: Path, repeats: int) -> dict:
    """Median times of one number of variants."""
    import kinetruss as kt

    model = Path(kt.library.example_files()["double_octahedral_slew"][0])
    settings = {
        "runs.slew.trajectory.duration": [f"{6 + 0.06 * k:.2f} s" for k in range(count)],
        "runs.slew.samples": [str(SAMPLES)],
    }
    kt.runs.run_variants(model, settings, out=folder / f"warm{count}")
    inside, outside = [], []
    for k in range(repeats):
        start = time.perf_counter()
        found = kt.runs.run_variants(model, settings, out=folder / f"call{count}_{k}")
        inside.append(time.perf_counter() - start)
        assert len(found) == count and all(found.whole.values())
    for k in range(max(1, repeats // 2)):
        start = time.perf_counter()
        texts = [part for path, values in settings.items() for part in ("--set", f"{path}={','.join(values)}")]
        command = [sys.executable, "-c", START, "run", str(model), *texts, "-q", "-o", str(folder / f"line{count}_{k}")]
        subprocess.run(command, check=True)
        outside.append(time.perf_counter() - start)
    return {
        "variants": count, "samples": SAMPLES, "seconds": statistics.median(inside),
        "command_seconds": statistics.median(outside),
    }  # fmt: skip


if __name__ == "__main__":
    main()
