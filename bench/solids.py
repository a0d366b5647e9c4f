"""Internal force and tangent of a mesh of tetrahedra, per element, against the bandwidth of the memory (``--json``).

The bound is the time in which the bytes that an evaluation must touch once could be copied, at the rate of a STREAM-like copy
measured in the same process, between the evaluations. One thread.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time

import numpy as np

COPIED = 16_000_000  # doubles; far beyond any cache


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--elements", type=int, default=100_000, help="at least so many tetrahedra (default: 100000)")
    parser.add_argument("--rounds", type=int, default=15, help="measurements; medians count (default: 15)")
    options = parser.parse_args()
    found = measured(options.elements, options.rounds)
    if options.json:
        json.dump(found, sys.stdout, indent=2)
        sys.stdout.write("\n")
        return
    print(f"{found['elements']} tetrahedra, {found['edges']} edges, copy {found['copy_gb_per_s']:.1f} GB/s")
    for row in found["rows"]:
        print(f"{row['case']:8s} {row['ns_per_element']:8.1f} ns  bound {row['bound_ns']:6.1f} ns  ratio {row['ratio']:.2f}")


def measured(least: int = 100_000, rounds: int = 15) -> dict:
    """Rows of force and tangent: time per element (ns), bytes per element, bound (ns), ratio; medians of the rounds.

    `ratio` is the median of the ratios of each round to the copy beside it, so that a busy machine spoils both alike.
    """
    import kinetruss as kt
    from kinetruss.elements.continua import edge_blocks, force
    from kinetruss.mechanics import compile

    start = time.perf_counter()
    cells = int(np.ceil((least / 6) ** (1 / 3)))
    grid = kt.library.meshes.box(size=(1.0, 1.0, 1.0), cells=(cells, cells, cells))
    steel = kt.Material(E=210e9, density=7850.0)
    model = kt.Model(nodes=grid.nodes, fixed=grid.at(x=0.0), solids={"block": grid.solid(material=steel)})
    made = time.perf_counter()
    system = compile(model)
    compiled = time.perf_counter()
    body = system.continua
    x = (system.x0 + 1e-3 * np.random.default_rng(0).standard_normal(system.x0.shape)).reshape(-1)
    table, A, B = body.record, body.record.A, body.record.B
    s, q, f, v, blocks = np.empty(len(A)), np.zeros(len(A)), np.zeros(x.size), np.zeros(x.size), np.empty((len(A), 9))
    run = {
        "force": lambda: force(table, 0.0, x, v, f),
        "tangent": lambda: edge_blocks(table, q, x, blocks),
    }
    edge, stiff = table.tetrahedron_edge, table.tetrahedron
    ends = A.nbytes + B.nbytes
    touched = {
        # ends, stretches and densities written and read, the elements, positions now and at the start, forces
        "force": 2 * ends + 4 * s.nbytes + edge.nbytes + stiff.nbytes + 3 * x.nbytes + 2 * f.nbytes,
        # ends, densities, the elements, positions; edges' differences written and read, blocks written and read
        "tangent": ends + q.nbytes + edge.nbytes + stiff.nbytes + x.nbytes + 6 * s.nbytes + 2 * blocks.nbytes,
    }
    for one in run.values():
        one()
    source, target = np.ones(COPIED), np.empty(COPIED)
    target[:] = source
    count, times, copies = len(edge), {name: [] for name in run}, []
    for _ in range(rounds):
        copies.append(_timed(lambda: np.copyto(target, source)) / (2 * source.nbytes))
        for name, one in run.items():
            times[name].append(_timed(one))
    rows = []
    for name in run:
        bounds = [touched[name] * copy for copy in copies]
        rows.append({
            "case": name, "ns_per_element": 1e9 * statistics.median(times[name]) / count,
            "bytes_per_element": touched[name] / count, "bound_ns": 1e9 * statistics.median(bounds) / count,
            "ratio": statistics.median(t / bound for t, bound in zip(times[name], bounds, strict=True)),
        })  # fmt: skip
    return {
        "elements": count, "edges": len(A), "nodes": len(system.nodes), "model_seconds": made - start,
        "compile_seconds": compiled - made, "copy_gb_per_s": 1e-9 / statistics.median(copies), "rows": rows,
    }  # fmt: skip


def _timed(work) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
