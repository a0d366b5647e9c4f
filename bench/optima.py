"""Published optima from random starts: how many searches arrive, and after how many analyses (``--json`` for one object).

Every search begins at a point uniform between the bounds (NumPy's generator, ``--seed``) and ends with its certificate. It has
arrived if the certificate holds and the objective is within 1e-4 of the best known. Frequencies have fewer starts: a search
takes some seconds. The choice from lists is proven by branch and bound, from nothing. Seconds are those of the processor.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from typing import Any

import numpy as np

from kinetruss.design.model_function import ModelFunction
from kinetruss.design.optimum.evaluations import Evaluations
from kinetruss.design.optimum.solvers import METHODS
from kinetruss.design.optimum.working_limits import optimum
from kinetruss.verification import optima

KNOWN = {  # task, best known, unit, what is taken off the objective
    "ten_bars.displacements": (lambda: optima.ten_bar_task("displacements"), 5060.8537, optima.POUND, 0.0),
    "ten_bars.stresses": (lambda: optima.ten_bar_task("stresses"), 1593.1805, optima.POUND, 0.0),
    "twenty_five_bars": (optima.twenty_five_bar_task, 545.1627, optima.POUND, 0.0),
    "ten_bars.frequencies.68.9": (lambda: optima.frequency_task(68.9e9), 532.2117, 1.0, 1816.0),
    "ten_bars.frequencies.69.8": (lambda: optima.frequency_task(69.8e9), 524.6293, 1.0, 1816.0),
}
ARRIVED = 1e-4


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--cases", nargs="+", choices=[*KNOWN, "ten_bars.sections"], default=[*KNOWN, "ten_bars.sections"])
    parser.add_argument("--starts", type=int, help="of each case (default: 30, of frequencies 10)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--method", choices=METHODS, default="slsqp")
    options = parser.parse_args()
    rows = []
    for case in options.cases:
        rows.append(sections() if case == "ten_bars.sections" else searched(case, options))
        if not options.json:
            print(", ".join(f"{name} {value}" for name, value in rows[-1].items()), flush=True)
    if options.json:
        json.dump({"seed": options.seed, "method": options.method, "rows": rows}, sys.stdout, indent=2)
        sys.stdout.write("\n")


def searched(case: str, options: Any) -> dict[str, Any]:
    """Searches from random starts."""
    make, best, unit, off = KNOWN[case]
    function = ModelFunction(*make())
    problem, rng = function.problem, np.random.default_rng(options.seed)
    ends, analyses, certified, arrived = Counter(), [], 0, 0
    starts, began = options.starts or (10 if "frequencies" in case else 30), time.process_time()
    for _ in range(starts):
        asked = Evaluations(problem)
        start = rng.uniform(problem.lower, problem.upper)
        found = optimum(asked, start, options.method, 500, 1e-9)
        value = (asked.values(found.p)[0] - off) / unit
        certified += found.certificate.first_order
        arrived += found.certificate.first_order and abs(value / best - 1) < ARRIVED
        ends[round(value, 2)] += 1
        analyses.append(asked.analyses)
    return {
        "case": case, "best_known": best, "arrived": arrived, "certified": certified, "of": starts,
        "median_analyses": float(np.median(analyses)), "most_analyses": max(analyses),
        "ends": dict(sorted(ends.items())), "seconds": round(time.process_time() - began, 1),
    }  # fmt: skip


def sections() -> dict[str, Any]:
    """The choice from the 42 sections, proven."""
    began = time.process_time()
    found = optima.ten_bar_sections()
    return {"case": "ten_bars.sections", **found, "seconds": round(time.process_time() - began, 1)}


if __name__ == "__main__":
    main()
