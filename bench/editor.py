"""How many edits a second the drawing of the studio takes: a node moved, the model checked, closed, mobility and forces anew.

    python bench/editor.py [--json] [--edits N]

One edit is what a page sends while a node is dragged, from the text of its message to the text of the answer, on the server's
side without the network. Medians of wall time and of processor time (what it takes on a machine without other load), after a
warm-up. One thread of linear algebra, as in the studio.
"""

from __future__ import annotations

import os

os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1")  # before NumPy is loaded

import argparse
import json
import statistics
import time

import kinetruss as kt
from kinetruss.studio import Session

BAYS = 50


def truss(*, braced: int = 0, lengths: bool = False, driven: bool = False) -> kt.Model:
    """A planar truss of 50 bays and 200 bars, one more for each bay with both diagonals; with given lengths or driven bars."""
    nodes = {f"{row}{k}": (float(k), float(height)) for k in range(BAYS + 1) for row, height in (("b", 0), ("t", 1))}
    pairs = [(f"b{k}", f"t{k}") for k in range(1, BAYS + 1)]
    for k in range(BAYS):
        pairs += [(f"b{k}", f"b{k + 1}"), (f"t{k}", f"t{k + 1}"), (f"b{k}", f"t{k + 1}")]
        pairs += [(f"t{k}", f"b{k + 1}")] * (k < braced)
    bars = {f"m{k}": kt.Bar(ends=ends) for k, ends in enumerate(pairs)}
    if lengths:
        size = {True: 1.0, False: 2**0.5}
        bars = {
            name: bar if "t7" in bar.ends else kt.Bar(ends=bar.ends, length=size[len({end[1:] for end in bar.ends}) < 2
                                                                                or bar.ends[0][0] == bar.ends[1][0]])
            for name, bar in bars.items()
        }  # fmt: skip
    if driven:
        bars |= {f"m{k}": kt.Bar(ends=bars[f"m{k}"].ends, kind="driven") for k in range(BAYS, BAYS + 12, 3)}
    return kt.Model(
        nodes=nodes, fixed={"b0": "xy", "t0": "xy"}, bars=bars, gravity=(0, -9.81), section="tube_lacy_planar",
        material="aluminium_lacy",
    )  # fmt: skip


def measure(name: str, model: kt.Model, edits: int) -> dict[str, object]:
    desk = Session(model, draw=True)
    times = []
    for k in range(edits + 10):
        message = json.dumps({"do": "move", "places": {"t7": [7 + 0.001 * (k % 50), 1.0 + 0.002 * (k % 30)]}, "drag": 1})
        began, computed = time.perf_counter(), time.process_time()
        answer = desk.answer(message)
        text = json.dumps(answer)
        times.append((time.perf_counter() - began, time.process_time() - computed))
        assert answer["kind"] == "moved", answer
        assert answer["force"] is not None, answer["why"]
        assert answer["mobility"]["undriven"] == 0
    wall, own = (statistics.median(column) for column in zip(*times[10:], strict=True))
    row = {"case": name, "bars": len(model.bars), "ms": 1e3 * wall, "per_second": 1 / wall}
    return row | {"processor_ms": 1e3 * own, "per_processor_second": 1 / own, "kB": len(text) / 1e3}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--edits", type=int, default=300)
    options = parser.parse_args()
    cases = {
        "determinate": truss(),
        "four driven bars": truss(driven=True),
        "given lengths": truss(lengths=True),
        "2 redundant bars": truss(braced=2),
        "50 redundant bars": truss(braced=50),
    }
    rows = [measure(name, model, options.edits) for name, model in cases.items()]
    if options.json:
        print(json.dumps(rows))
        return
    for row in rows:
        print(
            f"{row['case']:18} {row['bars']:4} bars {row['ms']:7.1f} ms, {row['per_second']:5.0f} edits a second; "
            f"{row['processor_ms']:6.1f} ms of the processor, {row['per_processor_second']:4.0f} a second; {row['kB']:5.1f} kB"
        )


if __name__ == "__main__":
    main()
