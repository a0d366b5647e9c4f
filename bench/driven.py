"""Inverse dynamics of a driven truss beside other programs: time of a sample and error of the bar forces (``--json``).

A chain of double-octahedral bays, 1,000 steps in 1 s, three driven lengths a bay. Every code is a process of its own on one
thread, and codes take turns; times are medians. Exudyn and MuJoCo simulate the driven truss; OpenSeesPy, PyNite and one row of
MuJoCo get the motion from elsewhere, without its time. The right forces come from dense algebra in `driven/_case.py`.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "peers"), str(HERE / "driven")]

from _ask import Worker  # noqa: E402 - lives beside the peers
from _case import error_of  # noqa: E402

OWN = "kinetruss"
PEERS = ("exudyn", "mujoco", "opensees", "pynite")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--peers", action="store_true", help="the other programs as well (make bench-peers)")
    parser.add_argument("--python", default=sys.executable, help="interpreter that has the peers (default: this one)")
    parser.add_argument("--bays", type=int, nargs="+", default=(1, 3, 10), help="numbers of bays (default: 1 3 10)")
    parser.add_argument("--rounds", type=int, default=5, help="measurements; the median counts (default: 5)")
    options = parser.parse_args()
    found = measured(options)
    if options.json:
        json.dump(found, sys.stdout, indent=2)
        sys.stdout.write("\n")
    else:
        _table(found)


def measured(options) -> dict:
    """All rows, and the codes that could not be asked."""
    workers, skipped, versions = {}, {}, {}
    for code in (OWN, *(PEERS if options.peers else ())):
        worker = Worker(f"driven_{code}", sys.executable if code == OWN else options.python, 300.0)
        answer = worker.ask(do="hello")
        if "failed" in answer:
            skipped[code] = answer["failed"]
        else:
            workers[code], versions[code] = worker, answer["version"]
    rows = [row for bays in options.bays for row in _rows(workers, bays, options.rounds)]
    for worker in workers.values():
        worker.close()
    return {"rows": rows, "skipped": skipped, "versions": versions}


def _rows(workers: dict, bays: int, rounds: int) -> list[dict]:
    """Every setting of every code, in turn, `rounds` times after one that may compile."""
    asked = []
    for code, worker in workers.items():
        for setting in worker.ask(do="settings", case="driven", n=bays)["settings"]:
            question = {"do": "run", "case": "driven", "n": bays, "setting": setting, "repeats": 1}
            asked.append((code, setting["name"], worker, question, [worker.ask(**question)]))
    for _ in range(rounds):
        for _, _, worker, question, answers in asked:
            if "failed" not in answers[0]:
                answers.append(worker.ask(**question))
    return [{"bays": bays, "code": code, "way": name} | _row(bays, answers) for code, name, _, _, answers in asked]


def _row(bays: int, answers: list[dict]) -> dict:
    """Time and error of all answers but the first."""
    if "failed" in answers[0]:
        return {"us_per_sample": None, "error": None, "failed": answers[0]["failed"]}
    seconds = statistics.median(answer["seconds"] for answer in answers[1:])
    return {"us_per_sample": 1e6 * seconds / answers[-1]["steps"], "error": error_of(bays, answers[-1]["state"])}


def _table(found: dict) -> None:
    print(f"{'bays':>5}  {'code':10}{'way':64}{'us/sample':>12}{'error':>10}")
    for row in found["rows"]:
        head = f"{row['bays']:5d}  {row['code']:10}{row['way']:64}"
        print(head + (row["failed"] if "failed" in row else f"{row['us_per_sample']:12.1f}{row['error']:10.1e}"))
    for code, why in found["skipped"].items():
        print(f"{code}: not compared: {why}")


if __name__ == "__main__":
    main()
