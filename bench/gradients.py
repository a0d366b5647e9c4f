"""What gradients cost beside values (the cases of `gradient_cases`), and a gradient by hand through the tables of a system.

By hand: of a displacement of a truss of 20 bars by all of its 43 numbers (E, areas, places of nodes).

Small displacements, K u = f with K from the laws and places of the bars; g is a displacement of the tip. With K a = e_tip,
dg = -a . d(K u), of all numbers by one complex step of the tables. Errors against a complex step of the whole and against
differences of `statics.linear`, of the largest entry; processor times, best of 9.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from gradient_cases import measured

import kinetruss as kt
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.numbers import numbers_of, tables_at

BAYS, STEP = 5, 1e-30


def truss(numbers: Any) -> kt.Model:
    """Five bays and a tip, held at two nodes, from E, 20 areas and 22 coordinates."""
    rails = [(2 * i + side, 2 * i + 2 + side) for side in (0, 1) for i in range(BAYS - 1)]
    across = [(2 * i, 2 * i + 3) for i in range(BAYS - 1)] + [(2 * i, 2 * i + 1) for i in range(1, BAYS)]
    ends = [*rails, *across, (8, 10), (9, 10), (1, 2), (5, 6)]
    sections = [kt.General(area=area, I2=1e-8, I3=1e-8, c2=0.1, c3=0.1) for area in numbers[1:21]]
    bars = {f"b{k}": kt.Bar(ends=(f"n{a}", f"n{b}"), kind="elastic", section=sections[k]) for k, (a, b) in enumerate(ends)}
    return kt.Model(
        nodes={f"n{i}": tuple(numbers[21 + 2 * i :][:2]) for i in range(11)}, fixed=("n0", "n1"), bars=bars,
        material=kt.Material(E=numbers[0], density=7850.0), loads={"tip": kt.NodalForce(node="n10", force=(3e3, -1e4))},
    )  # fmt: skip


def steps(system: System) -> tuple[dict[str, Any], np.ndarray]:
    """E, areas and places in 43 copies, one more by a complex step for its size in each; the sizes."""
    one = {name: numbers_of(system)[name] for name in ("E", "section", "place")}
    chosen = [("E", (0,)), *(("section", (k,)) for k in range(0, 120, 6)), *(("place", k) for k in np.ndindex(11, 2))]
    sizes = np.array([max(abs(one[name][k]), float(name == "place")) for name, k in chosen])
    made = {name: np.repeat(value[None].astype(complex), len(chosen), axis=0) for name, value in one.items()}
    for copy, (name, k) in enumerate(chosen):
        made[name][(copy, *k)] += 1j * STEP * sizes[copy]
    return made, sizes


def push(system: System, tables: Mapping[str, Any], u: Any) -> Any:
    """K u (..., 3 n) of displacements u (..., n, 3)."""
    x, k = tables["x0"], tables["structure law"][..., 0]
    one = x[..., system.q, :] - x[..., system.p, :]
    one = one / np.sqrt((one * one).sum(-1))[..., None]
    N = (k * ((u[..., system.q, :] - u[..., system.p, :]) * one).sum(-1))[..., None] * one
    found = np.zeros(np.broadcast_shapes(x.shape, u.shape), N.dtype)
    np.add.at(found, (..., system.q, slice(None)), N)
    np.subtract.at(found, (..., system.p, slice(None)), N)
    return found.reshape(*found.shape[:-2], -1)


def solved(system: System, tables: Mapping[str, Any]) -> tuple[Any, Any]:
    """K (..., free, free) and the displacements (..., 3 n)."""
    free, size = system.free, system.x0.size
    units = np.eye(size)[free].reshape(len(free), -1, 3)
    K = np.stack([push(system, tables, one)[..., free] for one in units], axis=-2)
    f = np.zeros(size)
    f[30:32] = 3e3, -1e4
    u = np.zeros((*K.shape[:-2], size), K.dtype)
    u[..., free] = np.linalg.solve(K, np.broadcast_to(f[free], K.shape[:-1])[..., None])[..., 0]
    return K, u


def gradient(system: System) -> Any:
    """Its derivatives (43,) by all numbers, each for its size, m."""
    K, u = solved(system, tables_at(system, {}))
    a = np.zeros(system.x0.size)
    a[system.free] = np.linalg.solve(K, (system.free == 31).astype(float))
    return -(push(system, tables_at(system, steps(system)[0]), u.reshape(-1, 3)).imag / STEP) @ a


def through_tables() -> dict[str, float]:
    """Errors and times, ms."""
    grid = np.array([*((i, j) for i in range(BAYS) for j in (0.0, 1.0)), (5.0, 0.5)])
    own = np.concatenate([[2.1e11], 1e-3 * (1 + np.random.default_rng(0).random(20)), grid.reshape(-1)])
    system = compile(truss(own))
    made, sizes = steps(system)
    found = gradient(system)
    whole = solved(system, tables_at(system, made))[1][:, 31].imag / STEP
    differences = []
    for k, size in enumerate(sizes):
        h = 1e-4 * size * np.eye(43)[k]
        up, down = (kt.statics.linear(truss(one)).displacement.sel(node="n10", axis="y").item() for one in (own + h, own - h))
        differences.append((up - down) / 2e-4)
    largest = np.abs(whole).max()
    one, copies = best(lambda: tables_at(system, {})), best(lambda: tables_at(system, made))
    return {
        "error_complex": float(np.abs(found - whole).max() / largest),
        "error_differences": float(np.abs(found - differences).max() / largest),
        "tables_ms": one, "tables_of_43_copies_ms": copies, "ratio": copies / one,
        "value_ms": best(lambda: solved(system, tables_at(system, {}))), "gradient_ms": best(lambda: gradient(system)),
    }  # fmt: skip


def best(work: Callable[[], Any]) -> float:
    """Least processor time of 9, ms."""
    times = []
    for _ in range(9):
        start = time.process_time()
        for _ in range(20):
            work()
        times.append(50 * (time.process_time() - start))
    return min(times)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object: rows of all cases of gradient_cases")
    parser.add_argument("--quick", action="store_true", help="the small cases alone")
    parser.add_argument("--case", default="", help="only cases with this in their name")
    options = parser.parse_args()
    rows = []
    for row in measured(options.case, quick=options.quick):
        rows.append(row)
        if not options.json:
            error = "-" if row["error"] is None else f"{row['error']:.0e}"
            times = f"{row['value_ms']:10.2f} {row['gradient_ms']:10.2f} {row['ratio']:6.2f}"
            print(f"{row['case']:42s} {row['numbers']:6d} {times} {error:>7s}", flush=True)
    if options.json:
        print(json.dumps({"rows": rows, "through_tables": through_tables()}, indent=1))


if __name__ == "__main__":
    main()
