"""Forward dynamics: time to reach an error, beside Exudyn, MuJoCo and Pinocchio (``--peers``; ``--json`` for one object).

Every code is a process of its own and steps a system that is set up; codes take turns. A row is one setting of one code,
the median of its runs and its error at the end; nothing between settings is interpolated. A ratio compares, for a case
and an error, the fastest setting of any peer that is as exact with the fastest of kinetruss that is.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "peers"))

from _ask import Worker  # noqa: E402 - lives beside the peers

OWN = ("kinetruss", "kinetruss.simulate")
PEERS = ("exudyn", "mujoco", "pinocchio")
SIZES = {"n_four_bar": (1, 10, 100, 1000), "andrews": (1,), "chain": (1, 3, 10, 50), "chain_lumped": (1, 3, 10, 50)}
ERRORS = {"n_four_bar": (1e-4, 1e-6, 1e-8), "andrews": (1e-4, 1e-6, 1e-8), "chain": (1e-3, 1e-4, 1e-5, 1e-6)}
GROWTH = {"n_four_bar": (10, 30, 100, 300, 1000), "chain": (3, 10, 30, 100, 200)}
GROWTH_SETTING = {"code": "kinetruss", "name": "DOP853", "rtol": 1e-6, "steps": 50}
MANY_BARS = 100_000
SHORT = 1.0  # s; longer runs are measured twice only


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument(
        "--peers", action="store_true", help="Exudyn, MuJoCo and Pinocchio as well (pip install kinetruss[peers])"
    )
    parser.add_argument("--python", default=sys.executable, help="interpreter that has the peers (default: this one)")
    parser.add_argument("--cases", nargs="+", choices=SIZES, default=list(SIZES), help="only these")
    parser.add_argument("--sizes", type=int, nargs="+", help="only these numbers of loops or bays")
    parser.add_argument("--rounds", type=int, default=5, help="measurements of a short run; the median counts (default: 5)")
    parser.add_argument("--longest", type=float, default=10.0, help="seconds beyond which no setting is refined (default: 10)")
    parser.add_argument("--no-growth", action="store_true", help="without cost per step and memory over size")
    parser.add_argument("--memory", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.memory:
        json.dump(memory(options.memory), sys.stdout)
        return
    found = measured(options)
    if not options.no_growth:
        found |= growth(options)
    if options.json:
        json.dump(found, sys.stdout, indent=2)
        sys.stdout.write("\n")
    else:
        _table(found)


def measured(options) -> dict:
    """All rows and ratios."""
    workers, skipped, versions = {}, {}, {}
    for code in ("kinetruss", *(PEERS if options.peers else ())):
        worker = Worker(code, sys.executable if code == OWN[0] else options.python, max(300.0, 6 * options.longest))
        answer = worker.ask(do="hello")
        if "failed" in answer:
            skipped[code] = answer["failed"]
            worker.close()
        else:
            workers[code], versions[code] = worker, answer["version"]
    rows, ratios = [], []
    for case in options.cases:
        for n in SIZES[case]:
            if options.sizes is None or n in options.sizes:
                some = _case(workers, case, n, options)
                rows += some
                ratios += [ratio(some, case, n, error) for error in ERRORS[case.removesuffix("_lumped")]]
    for worker in workers.values():
        worker.close()
    return {"rows": rows, "ratios": ratios, "skipped": skipped, "versions": versions}


def _case(workers: dict, case: str, n: int, options) -> list[dict]:
    """Every setting of every code once, then all of them again in turn."""
    from _reference import end_of, error_of

    right, rows, questions = end_of(case, n), [], []
    for code, worker in workers.items():
        for setting in _affordable(worker, case, n, options.longest):
            question, answer = setting
            error = error_of(case, answer["state"], right)
            own = question["setting"]
            rows.append({
                "case": case, "n": n, "code": own.get("code", code), "setting": _words(own, answer["steps"]), "error": error,
                "seconds": answer["seconds"], "steps": answer["steps"],
            })  # fmt: skip
            questions.append((worker, question, [answer["seconds"]]))
            _note(rows[-1])
    for turn in range(options.rounds):
        for worker, question, times in questions:
            if times[0] < SHORT or turn == 0:
                answer = worker.ask(**question)
                times += [answer["seconds"]] if "seconds" in answer else []
    for row, (_, _, times) in zip(rows, questions, strict=True):
        row["seconds"] = statistics.median(times[1:] if len(times) > 2 else times)
    return rows


def _affordable(worker: Worker, case: str, n: int, longest: float):
    """Settings of a code that run in time, with their first answers; each method from coarse to fine."""
    stopped = set()
    for setting in worker.ask(do="settings", case=case, n=n).get("settings", []):
        method = setting.get("code", ""), setting["name"]
        if method in stopped:
            continue
        question = {"do": "run", "case": case, "n": n, "setting": setting, "repeats": 50}
        began = time.perf_counter()
        answer = worker.ask(**(question | {"repeats": 3 if "code" in setting else 1}))
        if "failed" in answer:
            sys.stderr.write(f"{case} {n} {worker.code} {setting}: {answer['failed']}\n")
        else:
            yield question, answer
        waited = 0.0 if worker.code == OWN[0] else time.perf_counter() - began  # the first run may compile
        if max(waited, 2.5 * answer.get("seconds", 0.0)) > longest:
            stopped.add(method)


def ratio(rows: list[dict], case: str, n: int, error: float) -> dict:
    """How many times faster than the fastest peer that reaches the error; None without one, 0 where kinetruss does not."""
    reach = [row for row in rows if row["error"] <= error]
    own = min((row for row in reach if row["code"] == OWN[0]), key=_seconds, default=None)
    public = min((row for row in reach if row["code"] == OWN[1]), key=_seconds, default=None)
    peer = min((row for row in reach if row["code"] not in OWN), key=_seconds, default=None)
    times = None if peer is None else 0.0 if own is None else peer["seconds"] / own["seconds"]
    return {
        "case": case, "n": n, "error": error, "fastest_peer": peer and peer["code"], "times_faster": times,
        "peer_setting": peer and peer["setting"], "peer_seconds": peer and peer["seconds"],
        "seconds": own and own["seconds"], "setting": own and own["setting"], "simulate_seconds": public and public["seconds"],
    }  # fmt: skip


def growth(options) -> dict:
    """Cost per step over size, its exponents, and the peak memory of a model of many bars."""
    worker, rows = Worker("kinetruss", sys.executable, 600.0), []
    for case in (case for case in GROWTH if case in options.cases):
        for n in GROWTH[case]:
            question = {"do": "run", "case": case, "n": n, "setting": GROWTH_SETTING, "repeats": 50}
            answers = [worker.ask(**question) for _ in range(3)]
            good = [1e6 * answer["seconds"] / answer["steps"] for answer in answers if "seconds" in answer]
            if good:
                rows.append({"case": case, "n": n, "us_per_step": min(good)})
            else:
                sys.stderr.write(f"{case} {n}: {answers[0]['failed']}\n")
    worker.close()
    exponents = {case: exponent([row for row in rows if row["case"] == case]) for case in GROWTH if case in options.cases}
    command = [sys.executable, __file__, "--memory", str(MANY_BARS)]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    large = json.loads(done.stdout) if done.returncode == 0 else None
    return {"exponents": exponents, "per_step": rows, "memory": large}


def exponent(rows: list[dict]) -> float | None:
    """Slope of log time a step over log size, least squares."""
    if len(rows) < 2:
        return None
    points = [(math.log(row["n"]), math.log(row["us_per_step"])) for row in rows]
    x, y = (statistics.fmean(values) for values in zip(*points, strict=True))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)


def memory(bars: int) -> dict:
    """Peak memory of a chain of at least so many bars: model, set-up and some steps."""
    import resource

    from _cases import chain_bars
    from _kinetruss import model_of_bars

    import kinetruss as kt

    bays = math.ceil(bars / 18)
    began = time.perf_counter()
    model = model_of_bars(chain_bars(bays, lumped=False))
    found = kt.dynamics.prepare(model, 0.01, method=kt.DOP853(rtol=1e-4, atol=1e-4)).run(0.01)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    seconds = time.perf_counter() - began
    return {"bars": 18 * bays, "peak_gb": peak / 1e9, "steps": found.steps, "seconds": seconds, "status": found.status.name}


def _seconds(row: dict) -> float:
    return row["seconds"]


def _words(setting: dict, steps: int) -> str:
    fine = f"rtol {setting['rtol']:g}, " if "rtol" in setting else ""
    return f"{setting['name']}, {fine}{steps} steps"


def _note(row: dict) -> None:
    sys.stderr.write(f"{row['case']} {row['n']} {row['code']} {row['setting']}: {row['error']:.1e} {row['seconds']:.3g} s\n")


def _table(found: dict) -> None:
    for row in found["rows"]:
        head = f"{row['case']:13s}{row['n']:5d}  {row['code']:19s}{row['setting']:48s}"
        print(f"{head}{row['error']:10.1e}{1e3 * row['seconds']:12.3f} ms")
    print("\ncase             n    error  fastest peer      ms   kinetruss ms  simulate ms   times faster")
    for r in found["ratios"]:
        values = [r["peer_seconds"], r["seconds"], r["simulate_seconds"]]
        texts = "".join(f"{'-' if v is None else f'{1e3 * v:.3f}':>13}" for v in values)
        times = "-" if r["times_faster"] is None else f"{r['times_faster']:.1f}"
        print(f"{r['case']:13s}{r['n']:5d}{r['error']:9.0e}  {r['fastest_peer'] or '-':12s}{texts}{times:>13}")
    for name in ("exponents", "memory", "skipped"):
        if found.get(name):
            print(f"{name}: {found[name]}")


if __name__ == "__main__":
    main()
