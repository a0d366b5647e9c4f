"""Stiff runs: time and error of every method at several settings (``--json`` for one object).

governor: a flyball governor whose springs have strong dampers (tests/reference/governor.py), 10 s; the error is the largest
difference of turn, spread (rad) and slider (m) from its equations in three coordinates. chain: double-octahedral bays of steel
tubes, all elastic with E A/l and 2 % of critical damping, springs in their middle triangles, let go under weight and a side
load, 5 s; chain_undamped: the same with undamped tubes, whose vibration is part of the motion, 1 s. Their error is the largest
difference of a place (m) at the samples from DOP853 at 1e-12.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

WANTED = {"governor": (1e-4, 1e-6, 1e-7), "chain": (1e-4, 1e-5, 1e-6), "chain_undamped": (1e-4, 1e-5, 1e-6)}
"""Errors at which methods are compared."""
SPANS = {"governor": 10.0, "chain": 5.0, "chain_undamped": 1.0}
SAMPLES = 51
OUTER, INNER = 0.04, 0.034
"""m, diameters of the tubes."""
LONG = 1.0
"""s; longer runs are measured once."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--cases", nargs="+", choices=SPANS, default=list(SPANS), help="only these")
    parser.add_argument("--bays", type=int, default=3, help="bays of the chains (default: 3)")
    parser.add_argument("--rounds", type=int, default=3, help="measurements of a short run; the median counts (default: 3)")
    options = parser.parse_args()
    rows = [row for case in options.cases for row in measured(case, options)]
    found = {"rows": rows, "fastest": [fastest(rows, case, error) for case in options.cases for error in WANTED[case]]}
    if options.json:
        json.dump(found, sys.stdout, indent=2)
        sys.stdout.write("\n")
        return
    for row in rows:
        print("{case:15} {method:16} {setting:10} error {error:9.2e}  {seconds:8.4f} s  {steps} steps".format(**row))
    for one in found["fastest"]:
        seconds = ", ".join(f"{method} {value:.3g} s" for method, value in one["seconds"].items())
        print(f"{one['case']} to {one['error']:g}: {seconds}")


def methods() -> list[tuple[str, object]]:
    """Settings that are measured, with their words."""
    import kinetruss as kt

    chosen = [
        (kt.Radau, (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9)),
        (kt.DOP853, (1e-4, 1e-6, 1e-8)),
        (kt.Taylor, (1e-4, 1e-6, 1e-8)),
    ]
    found = [(f"rtol {rtol:g}", made(rtol=rtol, atol=0.1 * rtol)) for made, values in chosen for rtol in values]
    fixed = [(kt.EnergyMomentum, (1e-2, 1e-3, 1e-4)), (kt.GeneralizedAlpha, (1e-2, 1e-3, 1e-4))]
    return found + [(f"step {step:g}", made(step)) for made, values in fixed for step in values]


def measured(case: str, options) -> list[dict]:
    """Every setting of every method."""
    import kinetruss as kt

    model, error_of = CASES[case](options.bays)
    rows = []
    for words, method in methods():
        prepared = kt.dynamics.prepare(model, SPANS[case], method=method)
        prepared.run(1e-2 * SPANS[case])
        seconds: list[float] = []
        while len(seconds) < (1 if seconds and seconds[0] > LONG else options.rounds):
            began = time.perf_counter()
            run = prepared.run(SPANS[case], samples=SAMPLES)
            seconds.append(time.perf_counter() - began)
        error = error_of(run) if run.status.ok else math.inf
        rows.append({
            "case": case, "method": method.kind, "setting": words, "error": error, "seconds": statistics.median(seconds),
            "steps": run.steps, "rejected": run.rejected,
        })  # fmt: skip
        print(json.dumps(rows[-1]), file=sys.stderr)
    return rows


def fastest(rows: list[dict], case: str, error: float) -> dict:
    """The least time of every method with which the error is reached; a method that does not reach it is left out."""
    seconds: dict[str, float] = {}
    for row in rows:
        if row["case"] == case and row["error"] <= error:
            seconds[row["method"]] = min(row["seconds"], seconds.get(row["method"], math.inf))
    return {"case": case, "error": error, "seconds": seconds}


def _governor(_bays: int):
    import numpy as np

    from reference import governor

    model = governor.governor(4e4)
    exact = governor.reference(np.linspace(0.0, SPANS["governor"], SAMPLES), 4e4, governor.AXIAL)
    ball, slider = (list(model.nodes).index(name) for name in "RS")

    def error_of(run) -> float:
        x, y, z = run.position[:, ball].T
        turn, spread = np.unwrap(np.arctan2(-z, x)), np.arctan2(np.hypot(x, z), 1 - y)
        turn += 2 * math.pi * np.rint((exact[0] - turn) / (2 * math.pi))
        return float(np.abs(np.array([turn, spread, run.position[:, slider, 1]]) - exact).max())

    return model, error_of


def _chain(damping: float, case: str):
    def made(bays: int):
        import numpy as np

        import kinetruss as kt

        model = chain(bays, damping)
        tight = kt.DOP853(rtol=1e-12, atol=1e-13)
        exact = kt.dynamics.prepare(model, SPANS[case], method=tight).run(SPANS[case], samples=SAMPLES)
        return model, lambda run: float(np.abs(run.position - exact.position).max())

    return made


def chain(bays: int, damping: float):
    """Bays of elastic steel tubes with E A/l.

    damping : of a tube between two halves of its mass, in parts of the critical one.
    """
    import numpy as np

    import kinetruss as kt
    from kinetruss.library import materials, vgt

    tube, steel = kt.Tube(outer=OUTER, inner=INNER), materials.STEEL_S235
    model, bars = vgt.double_octahedral(bays, section=tube, material=steel), {}
    for name, bar in model.bars.items():
        first, second = (np.array(model.nodes[end].at) for end in bar.ends)
        length = float(np.linalg.norm(second - first))
        stiffness, mass = steel.E * tube.area / length, steel.density * tube.area * length
        damper = 2.0 * damping * math.sqrt(0.25 * stiffness * mass)
        bars[name] = kt.Bar(ends=bar.ends, kind="elastic", section="bar", material="bar", damping=damper)
    for name, active in model.active.items():
        bars[name] = kt.Bar(ends=active.ends, kind="elastic", stiffness=3e4, damping=300.0, mass=4.0)
    side = kt.NodalForce(node=list(model.nodes)[-1], force=(300.0, 0.0, 0.0))
    return model.with_(bars=bars, active={}, poses={}, loads={"side": side})


CASES = {"governor": _governor, "chain": _chain(0.02, "chain"), "chain_undamped": _chain(0.0, "chain_undamped")}

if __name__ == "__main__":
    main()
