"""Variants a second and core of studies of a small mechanism (``--json`` for one object).

A four-bar turns, 101 samples, with a mass and a place of its own in every variant; of each the largest member force is kept.
`run_variants` does runs of other masses alone and keeps them, in memory and in folders. `one_by_one` is a study that may not do
variants together, `study` one as it is, with its ledger in memory; `checked` keeps the highest utilisation. All on one core, in
turns; medians of processor time, kernels loaded. `large` is one study of many variants on all processors, with its folder, from
start to end.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1")  # before NumPy is loaded

import kinetruss as kt
from kinetruss.studies import evaluating

SAMPLES, VARIANTS, REPEATS, LARGE = 101, 512, 5, 10_000
FORCE = {"peak": "peak_member_force"}


def study_of(count: int, results: dict[str, str]) -> kt.studies.Study:
    """The study of so many variants (a power of two)."""
    model = kt.io.set_value(kt.read(kt.library.example_files()["four_bar"][0]), "runs.turn.samples", SAMPLES)
    return kt.studies.Study(
        model=model,
        run="turn",
        variables={"nodes.C.mass": {"between": ["0.2 kg", "1 kg"]}, "nodes.C.at.0": {"between": ["0.29 m", "0.31 m"]}},
        sample={"latin_hypercube": count, "seed": 1},
        results=results,
    )


def timed(work: Callable[[], object]) -> float:
    """Processor seconds."""
    began = time.process_time()
    work()
    return time.process_time() - began


def one_by_one(study: kt.studies.Study) -> None:
    """A study in which no variants are done together."""
    least, evaluating.LEAST = evaluating.LEAST, sys.maxsize
    try:
        kt.studies.run_study(study, workers=0)
    finally:
        evaluating.LEAST = least


def rows(count: int, repeats: int) -> list[dict]:
    """The cases in turns."""
    study, few = study_of(count, FORCE), 32
    masses = {"nodes.C.mass": [f"{0.2 + 0.02 * k:.3f} kg" for k in range(few)]}
    checked = study_of(few * 4, {"worst": "peak_utilisation"})
    with tempfile.TemporaryDirectory() as folder:
        number = iter(range(10**6))
        cases: dict[str, tuple[int, Callable[[], object]]] = {
            "run_variants, in memory": (few, lambda: kt.runs.run_variants(study.model, masses, "turn")),
            "run_variants, in folders": (
                few,
                lambda: [
                    kt.runs.run_variants(study.model, {"nodes.C.mass": [mass]}, "turn", Path(folder, str(next(number))))
                    for mass in masses["nodes.C.mass"]
                ],
            ),
            "one_by_one": (count, lambda: one_by_one(study)),
            "study": (count, lambda: kt.studies.run_study(study, workers=0)),
            "checked": (few * 4, lambda: kt.studies.run_study(checked, workers=0)),
        }
        for _, work in cases.values():
            work()
        taken: dict[str, list[float]] = {name: [] for name in cases}
        for _ in range(repeats):
            for name, (_, work) in cases.items():
                taken[name].append(timed(work))
    per = {name: statistics.median(taken[name]) / cases[name][0] for name in cases}
    base = per["run_variants, in memory"]
    return [
        {"case": name, "variants": cases[name][0], "ms": 1e3 * one, "per_second_and_core": 1 / one, "ratio": base / one}
        for name, one in per.items()
    ]


def processor_seconds() -> float:
    """Of this process and of those that it has ended."""
    return sum(use.ru_utime + use.ru_stime for use in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


def large(count: int) -> dict:
    """One study on all processors, from the call to its Parquet file."""
    with tempfile.TemporaryDirectory() as folder:
        began, spent = time.perf_counter(), processor_seconds()
        found = kt.studies.run_study(study_of(count, FORCE), Path(folder, "study"))
        seconds, spent = time.perf_counter() - began, processor_seconds() - spent
        assert found.good.all()
        size = (Path(folder, "study", "study.sqlite").stat().st_size, Path(folder, "study", "results.parquet").stat().st_size)
    cores = len(os.sched_getaffinity(0))
    return {
        "variants": count, "processors": cores, "seconds": seconds, "processor_seconds": spent,
        "per_second_and_core": count / spent, "ledger_bytes": size[0], "parquet_bytes": size[1],
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--variants", type=int, default=VARIANTS)
    parser.add_argument("--large", type=int, default=LARGE, help="variants of the large study; 0: none")
    parser.add_argument("--repeats", type=int, default=REPEATS)
    options = parser.parse_args()
    found = {"samples": SAMPLES, "rows": rows(options.variants, options.repeats)}
    if options.large:
        found["large"] = large(options.large)
    if options.json:
        print(json.dumps(found))
        return
    print("case                        ms  variants/s/core  ratio")
    for row in found["rows"]:
        print(f"{row['case']:25}{row['ms']:8.2f}{row['per_second_and_core']:15.0f}{row['ratio']:9.1f}")
    if options.large:
        one = found["large"]
        spent = f"{one['seconds']:.1f} s, {one['processor_seconds']:.1f} s of a processor"
        print(f"{one['variants']} variants on {one['processors']} processors: {spent}")


if __name__ == "__main__":
    main()
