"""One code in a process of its own: reads questions (one JSON object a line), runs, answers the same way.

    python _worker.py CODE      # a module _CODE.py beside this one, or in ../driven

    {"do": "hello"}                                    -> {"version": ...}
    {"do": "settings", "case", "n"}                    -> {"settings": [...]}  {} where the code cannot do the case
    {"do": "run", "case", "n", "setting", "repeats"}   -> {"seconds": median, "steps": ..., "state": [...]}

A module has VERSION, settings(case, n) -> list of dicts with "name" and "steps", and prepare(case, n, setting) -> run, a
function without arguments that puts the system back to its start, then steps it to the end and returns
(seconds of the stepping alone, steps, state).
"""

from __future__ import annotations

import importlib
import json
import os
import statistics
import sys
import time
from pathlib import Path

KEPT = 24
LEAST = 0.05  # seconds that short runs are repeated for, for one median


def main(code: str) -> None:
    out = os.fdopen(os.dup(1), "w")  # whatever a code writes to the terminal goes nowhere
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    here = Path(__file__).resolve().parent
    sys.path[:0] = [str(here), str(here.parent / "driven")]
    module = None
    for line in sys.stdin:
        question = json.loads(line)
        try:
            module = module or importlib.import_module(f"_{code}")
            answer = _answer(module, question)
        except Exception as error:  # noqa: BLE001 - a code that fails is one answer among others
            answer = {"failed": f"{type(error).__name__}: {error}"[:300]}
        out.write(json.dumps(answer) + "\n")
        out.flush()


def _answer(module, question: dict) -> dict:
    if question["do"] == "hello":
        return {"version": module.VERSION}
    case, n = question["case"], question["n"]
    if question["do"] == "settings":
        return {"settings": module.settings(case, n)}
    key = json.dumps([case, n, question["setting"]], sort_keys=True)
    run = _prepared(module, key, case, n, question["setting"])
    began, times = time.perf_counter(), []
    while len(times) < question["repeats"]:
        seconds, steps, state = run()
        times.append(seconds)
        if time.perf_counter() - began > LEAST and len(times) >= 3:
            break
    return {"seconds": statistics.median(times), "steps": int(steps), "state": [float(x) for x in state.reshape(-1)]}


_KEPT: dict = {}


def _prepared(module, key: str, case: str, n: int, setting: dict):
    """The prepared run, from before if it was asked already."""
    if key not in _KEPT:
        if len(_KEPT) >= KEPT:
            _KEPT.clear()
        _KEPT[key] = module.prepare(case, n, setting)
    return _KEPT[key]


if __name__ == "__main__":
    main(sys.argv[1])
