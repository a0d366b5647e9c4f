"""Time of statics.linear and kinematics.mobility against the number of bars, and how exact the forces are (``--json``).

Cantilevers of four bars a panel (determinate: the exact forces are known), the same with both diagonals, a wide grid of bars;
frames of beams, in the plane and in space, up to 10,000 of them.
"""

from __future__ import annotations

import argparse
import json
import sys
import time

import numpy as np

BARS = (1_000, 10_000, 30_000, 100_000)
BEAMS = 10_000
"""Largest number of beams."""
METAL = {"E": 210e9, "density": 0.0}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--bars", type=int, nargs="+", default=list(BARS), help=f"numbers of bars, about (default: {BARS})")
    options = parser.parse_args()
    found = measured(options.bars)
    if options.json:
        json.dump(found, sys.stdout, indent=2)
        sys.stdout.write("\n")
        return
    print(
        f"{'case':12s} {'bars':>7s} {'compile':>9s} {'mobility':>9s} {'linear':>9s} {'force error':>12s} {'energy/work':>12s}"
    )
    for row in found["rows"]:
        error = "-" if row["force_error"] is None else f"{row['force_error']:.1e}"
        times = " ".join(f"{row[name]:8.3f}s" for name in ("compile", "mobility", "linear"))
        print(f"{row['case']:12s} {row['bars']:7d} {times} {error:>12s} {row['unbalanced']:12.1e}")
    for case, one in found["exponents"].items():
        print(f"{case}: time grows as n^{one['mobility']:.2f} (mobility), n^{one['linear']:.2f} (linear)")


def measured(sizes: list[int] | tuple[int, ...] = BARS) -> dict:
    """Rows of seconds by case and size; slopes of log time over log bars from the smallest to the largest size."""
    import kinetruss as kt
    from kinetruss.mechanics import compile

    kt.statics.linear(cantilever(3)[0])  # imports
    kt.kinematics.mobility(cantilever(3)[0])
    rows = []
    cases = (
        ("cantilever", cantilever, lambda size: size // 4),
        ("crossed", crossed, lambda size: size // 5),
        ("grid", grid, lambda size: max(2, round((size / 4) ** 0.5))),
        ("frame", frame, lambda size: max(1, round((size / 2) ** 0.5))),
        ("space", space, lambda size: max(1, round((size / 3) ** (1 / 3)))),
    )
    for case, make, count in cases:
        for size in sizes:
            if case in ("frame", "space") and size > BEAMS:
                continue
            model, exact = make(count(size))
            marks = [time.perf_counter()]
            compile(model)
            marks.append(time.perf_counter())
            kt.kinematics.mobility(model)
            marks.append(time.perf_counter())
            found = kt.statics.linear(model)
            marks.append(time.perf_counter())
            force, energy, work = found.member_force.values, found.energy.item(), found.work.item()
            error = None if exact is None else float(np.abs(np.abs(force) - exact).max() / exact.max())
            rows.append(
                {"case": case, "bars": len(model.bars) + len(model.beams)}
                | dict(zip(("compile", "mobility", "linear"), np.diff(marks).tolist(), strict=True))
                | {"force_error": error, "unbalanced": abs(energy - work) / energy, "message": found.message}
            )
    return {"rows": rows, "exponents": _exponents(rows)}


def _exponents(rows: list[dict]) -> dict:
    found = {}
    for case in dict.fromkeys(row["case"] for row in rows):
        own = [row for row in rows if row["case"] == case]
        first, last = own[0], own[-1]
        if first["bars"] < last["bars"]:
            span = np.log(last["bars"] / first["bars"])
            found[case] = {name: float(np.log(last[name] / first[name]) / span) for name in ("mobility", "linear")}
    return found


def cantilever(panels: int, *, both: bool = False):
    """Square panels under 1 N at the tip, and the sizes of the forces: chords n - i and n - i - 1, diagonals sqrt(2)."""
    nodes = {f"{row}{i}": (float(i), y) for i in range(panels + 1) for row, y in (("b", 0.0), ("t", 1.0))}
    bars = {}
    for i in range(panels):
        bars |= {f"B{i}": (f"b{i}", f"b{i + 1}"), f"T{i}": (f"t{i}", f"t{i + 1}")}
        bars |= {f"D{i}": (f"b{i}", f"t{i + 1}"), f"V{i}": (f"b{i + 1}", f"t{i + 1}")}
        if both:
            bars[f"E{i}"] = (f"t{i}", f"b{i + 1}")
    i = np.arange(panels)
    sizes = np.stack([panels - i - 1.0, panels - i, np.full(panels, 2**0.5), np.where(i < panels - 1, 1.0, 0.0)], axis=1)
    return _model(nodes, bars, ["b0", "t0"], f"t{panels}"), None if both else sizes.reshape(-1)


def crossed(panels: int):
    """The same with both diagonals: one redundant bar a panel."""
    return cantilever(panels, both=True)


def grid(side: int):
    """side x side crossed cells with nodes a little off their places, held along one edge."""
    chance = np.random.default_rng(0)
    nodes = {
        f"n{i}_{j}": tuple(np.array([i, j]) + 0.1 * chance.standard_normal(2)) for i in range(side + 1) for j in range(side + 1)
    }
    bars = {}
    for i in range(side + 1):
        for j in range(side + 1):
            for k, (a, b) in enumerate(((i + 1, j), (i, j + 1), (i + 1, j + 1))):
                if a <= side and b <= side:
                    bars[f"b{i}_{j}_{k}"] = (f"n{i}_{j}", f"n{a}_{b}")
            if i < side and j < side:
                bars[f"b{i}_{j}_3"] = (f"n{i + 1}_{j}", f"n{i}_{j + 1}")
    return _model(nodes, bars, [f"n0_{j}" for j in range(side + 1)], f"n{side}_{side}"), None


def frame(side: int):
    """side bays by side storeys of beams, clamped at its feet, pushed at one side."""
    nodes = {f"n{i}_{j}": (4.0 * i, 3.0 * j) for i in range(side + 1) for j in range(side + 1)}
    beams = {f"c{i}_{j}": (f"n{i}_{j}", f"n{i}_{j + 1}") for i in range(side + 1) for j in range(side)}
    beams |= {f"b{i}_{j}": (f"n{i}_{j}", f"n{i + 1}_{j}") for i in range(side) for j in range(1, side + 1)}
    return _beams(nodes, beams, [f"n{i}_0" for i in range(side + 1)], {f"n0_{j}": (1e3, 0.0) for j in range(1, side + 1)}), None


def space(side: int):
    """The same in space, side bays by side bays by side storeys."""
    every = range(side + 1)
    nodes = {f"n{i}_{k}_{j}": (4.0 * i, 4.0 * k, 3.0 * j) for i in every for k in every for j in every}
    beams = {}
    for i, k, j in ((i, k, j) for i in every for k in every for j in every):
        for name, ends, there in (
            ("c", (i, k, j + 1), j < side),
            ("x", (i + 1, k, j), j and i < side),
            ("y", (i, k + 1, j), j and k < side),
        ):
            if there:
                beams[f"{name}{i}_{k}_{j}"] = (f"n{i}_{k}_{j}", "n{}_{}_{}".format(*ends))
    feet = [f"n{i}_{k}_0" for i in every for k in every]
    return _beams(nodes, beams, feet, {f"n0_0_{j}": (1e3, 0.0, 0.0) for j in range(1, side + 1)}), None


def _beams(nodes: dict, beams: dict, feet: list[str], forces: dict):
    import kinetruss as kt

    return kt.Model(
        nodes=nodes, beams=beams, clamped=feet, section=kt.Rectangle(width=0.2, height=0.3),
        material=kt.Material(poisson=0.3, **METAL),
        loads={node: kt.NodalForce(node=node, force=force) for node, force in forces.items()},
    )  # fmt: skip


def _model(nodes: dict, bars: dict, fixed: list[str], loaded: str):
    import kinetruss as kt

    return kt.Model(
        nodes=nodes, fixed=fixed, bars={name: kt.Bar(ends=ends, mass=0) for name, ends in bars.items()},
        section=kt.Rod(diameter=0.1), material=kt.Material(**METAL), loads={"p": kt.NodalForce(node=loaded, force=(0.0, -1.0))},
    )  # fmt: skip


if __name__ == "__main__":
    main()
