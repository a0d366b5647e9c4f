"""How long it takes to write the page of a run, and how large it gets, by the number of members.

    python bench/viewer.py [--json] [--rounds N]

Chains of double-octahedral bays, 300 samples of motion, forces and utilisation in memory; medians of all rounds.
"""

from __future__ import annotations

import argparse
import json
import statistics
import tempfile
import time
from pathlib import Path

import kinetruss as kt
from kinetruss.mechanics import compile

BAYS = (1, 50, 250)
SAMPLES = 300


def measure(bays: int, rounds: int) -> dict[str, float]:
    model = kt.library.vgt.double_octahedral(bays=bays)
    start = dict(zip(model.all_drives, compile(model).drive_start, strict=True))
    moves = {name: (value, 1.01 * value) for name, value in start.items()}
    run = kt.Run(trajectory=kt.Quintic(moves=moves, duration=1.0), samples=SAMPLES)
    result = kt.run(model.with_(runs={"lift": run}), "lift")
    took = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(rounds):
            begun = time.perf_counter()
            path = kt.viewer.write(result, Path(folder) / "view.html")
            took.append(time.perf_counter() - begun)
        size = path.stat().st_size
    return {"members": len(model.members), "samples": SAMPLES, "seconds": statistics.median(took), "megabytes": size / 1e6}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    rows = [measure(bays, options.rounds) for bays in BAYS]
    if options.json:
        print(json.dumps({"rows": rows}))
        return
    for row in rows:
        print(f"{row['members']:6d} members x {row['samples']}: {row['seconds']:.3f} s, {row['megabytes']:.2f} MB")


if __name__ == "__main__":
    main()
