"""Robots along paths and under given forces, beside closed forms, minimal coordinates and rigid-body codes (``--json``).

Paths of 1,000 samples (inverse kinematics and inverse dynamics in one call), forward dynamics as the time to 1e-8, and the
elements of a solid. One thread; medians; a code that is not installed has no rows.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import os
import statistics
import sys
import time
from pathlib import Path

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS", "BLIS_NUM_THREADS")
os.environ.update(dict.fromkeys(THREADS, "1"))
sys.path[:0] = [str(Path(__file__).resolve().parent / "peers"), str(Path(__file__).resolve().parent)]

import numpy as np  # noqa: E402 - after the number of threads

SAMPLES = 1000
WANTED = 1e-8
OWN_TOLERANCES = (1e-6, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9, 1e-10)
STEWART = {"mass": 12.0, "leg": 1.0, "push": 40.0, "t_end": 0.5}
PLATFORM = ("P1", "P2", "P3", "P4", "P5", "P6", "Q")
PEERS = ("pinocchio", "mujoco")
CASES = ("models", "conventional", "delta_path", "stewart_path", "robot_forward", "stewart_forward", "solid")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES), help="only these")
    parser.add_argument("--rounds", type=int, default=15, help="measurements; the median counts (default: 15)")
    parser.add_argument("--elements", type=int, default=100_000, help="tetrahedra of the solid (default: 100000)")
    parser.add_argument("--python", help="interpreter that has the peers (default: this one)")
    options = parser.parse_args()
    if options.python:
        _go_on_in(options.python)
    rows = []
    for case in options.cases:
        rows += globals()[f"_{case}"](options)
    skipped = [code for code in PEERS if not importlib.util.find_spec(code)] if "robot_forward" in options.cases else []
    if options.json:
        json.dump({"rows": rows, "skipped": skipped}, sys.stdout, indent=2)
        sys.stdout.write("\n")
        return
    for r in rows:
        texts = [
            f"{'-' if r[key] is None else format(r[key], '.4g'):>12}" for key in ("us_per_sample", "seconds", "error", "ratio")
        ]
        print(f"{r['case']:44s}{''.join(texts)}")
    if skipped:
        print(f"Not installed, so not compared: {', '.join(skipped)} (make bench-peers).")


def _go_on_in(python: str) -> None:
    """Replace this process by the same command in another interpreter, which finds kinetruss and its packages here."""
    import sysconfig

    own = [str(Path(__file__).resolve().parents[1] / "src"), sysconfig.get_paths()["purelib"]]
    at = next(k for k, word in enumerate(sys.argv) if word.startswith("--python"))
    rest = sys.argv[:at] + sys.argv[at + (1 if "=" in sys.argv[at] else 2) :]
    os.execve(python, [python, *rest], {**os.environ, "PYTHONPATH": os.pathsep.join(own)})


def _row(case: str, *, us=None, seconds=None, error=None, ratio=None) -> dict:
    values = {"us_per_sample": us, "seconds": seconds, "error": error, "ratio": ratio}
    return {"case": case} | {key: None if value is None else float(value) for key, value in values.items()}


def _in_turn(runs: dict, rounds: int, clock=time.perf_counter) -> dict[str, float]:
    """Median seconds of each, after one run of each that counts for nothing; they take turns."""
    times: dict[str, list[float]] = {name: [] for name in runs}
    for turn in range(rounds + 1):
        for name, run in runs.items():
            began = clock()
            run()
            if turn:
                times[name].append(clock() - began)
    return {name: statistics.median(found) for name, found in times.items()}


def _path_rows(case: str, call, closed, error: float, rounds: int) -> list[dict]:
    """`ratio`: time of the closed form in NumPy, vectorised over the path, over that of the call."""
    seconds = _in_turn({"call": call, "closed": closed}, rounds)
    per = 1e6 / SAMPLES
    return [
        _row(f"{case}: inverse_along", us=per * seconds["call"], seconds=seconds["call"], error=error,
             ratio=seconds["closed"] / seconds["call"]),
        _row(f"{case}: closed form, NumPy", us=per * seconds["closed"], seconds=seconds["closed"]),
    ]  # fmt: skip


def _stepping(model, t_end: float, rtol: float, atol: float, tasks: dict):
    """Prepared with power series where the motion has one, else with DOP853."""
    import kinetruss as kt

    try:
        return kt.dynamics.prepare(model, t_end, method=kt.Taylor(rtol=rtol, atol=atol), tasks=tasks)
    except kt.errors.InputError:
        return kt.dynamics.prepare(model, t_end, method=kt.DOP853(rtol=rtol, atol=atol), tasks=tasks)


def _models(options) -> list[dict]:
    """The mechanisms of the method's proofs, each at the loosest of some tolerances whose error is below `WANTED`, taking
    turns in one process; then their error at 1e-11. Errors in m of places, of the robot in its coordinates."""
    from _robot_bars import robot, robot_coordinates
    from _robots import END, robot_end

    import kinetruss as kt
    from kinetruss.library import mechanisms
    from kinetruss.verification.cases import cases
    from kinetruss.verification.mechanisms import CORNERS, P

    expected = {case.id: case.expected for case in cases()}
    points = {node: [expected[f"forward.andrews.{node}.{axis}"] for axis in "xy"] for node in "FEDGH"}
    fallen = [expected[f"delta.fall.{axis}"] for axis in "xyz"]

    def andrews(form):
        model = mechanisms.andrews(form=form)
        motor = {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
        nodes, right = [list(model.nodes).index(name) for name in points], np.array(list(points.values()))

        def made(rtol):
            prepared = _stepping(model, 0.03, rtol, 0.01 * rtol, motor)
            return lambda: np.abs(prepared.run(0.03).position[-1][nodes][:, :2] - right).max()

        return made

    def delta(rtol):
        model = mechanisms.delta(at=tuple(P))
        nodes = [list(model.nodes).index(name) for name in CORNERS]
        prepared = _stepping(model, 0.15, rtol, 0.01 * rtol, dict.fromkeys(model.drives, kt.Free()))
        return lambda: np.abs(prepared.run(0.15).position[-1][nodes].mean(axis=0) - fallen).max()

    end = robot_end(1e-13)[0]

    def tree(rtol):
        prepared = robot(rtol)
        return lambda: np.abs(robot_coordinates(prepared.run(END).position[-1]) - end).max()

    made = {"andrews, ten bars": andrews("bars"), "andrews, rigid beam": andrews("beam"), "robot": tree, "delta": delta}
    chosen, errors, rows = {}, {}, []
    for name, make in made.items():
        for rtol in OWN_TOLERANCES:
            run = make(rtol)
            if (error := float(run())) <= WANTED:
                chosen[f"{name}: to {WANTED:g}, rtol {rtol:g}"], errors[name] = run, error
                break
    for (case, seconds), error in zip(_in_turn(chosen, options.rounds).items(), errors.values(), strict=True):
        rows.append(_row(f"models, {case}", seconds=seconds, error=error))
    return rows + [_row(f"models, {name}: rtol 1e-11", error=float(make(1e-11)())) for name, make in made.items()]


def _conventional(options) -> list[dict]:
    """Each mechanism as bars, and as rigid beams with rotations, in turn; processor time. Along one motion of the drives
    (`follow`, `inverse`), simulated to `WANTED`, and an evaluation of such a simulation by each solver, all by DOP853.
    `error`: largest difference of the models along the motion, relative, and of the end from a run at 1e-12, m. `ratio`: time
    of the conventional model over that of the bars.
    """
    import kinetruss as kt
    from kinetruss.library import mechanisms

    crank = kt.Quintic(moves={"motor": (-0.0617138900142764, 6.0)}, duration=0.03)
    motor = {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
    pushes = {"lift": kt.GivenForce(3550.0), "reach": kt.GivenForce(-80.0)}
    turns = {"swing": 60.0, "shoulder": -60.0, "wrist": 78.0}
    tasks = {"robot": pushes | {name: kt.GivenForce(torque=torque) for name, torque in turns.items()}, "andrews": motor}
    rows = []
    for name, t_end in (("andrews", 0.03), ("robot", 0.8), ("delta", 0.15)):
        models = {form: getattr(mechanisms, name)(form=form) for form in ("bars", "conventional")}
        path = crank if name == "andrews" else models["bars"].runs["move"].trajectory
        given = tasks.get(name, dict.fromkeys(models["bars"].all_drives, kt.Free()))
        motions = {form: kt.kinematics.follow(model, path, samples=SAMPLES) for form, model in models.items()}
        forces = [kt.dynamics.inverse(models[form], motions[form], static=False).drive_force.values for form in models]
        common = [node for node in models["bars"].nodes if node in models["conventional"].nodes]
        at = {form: [list(model.whole.nodes).index(node) for node in common] for form, model in models.items()}

        def prepared(form, rtol, solver="auto", models=models, given=given, t_end=t_end):
            method = kt.DOP853(rtol=rtol, atol=0.01 * rtol, solver=solver)
            run = kt.dynamics.prepare(models[form], t_end, tasks=given, method=method)
            return lambda: run.run(t_end)

        exact = prepared("bars", 1e-12)().position[-1][at["bars"]]
        runs, errors, counts = {}, {}, {}
        for form, model in models.items():
            runs["follow", form] = lambda model=model, path=path: kt.kinematics.follow(model, path, samples=SAMPLES)
            runs["inverse", form] = lambda model=model, motion=motions[form]: kt.dynamics.inverse(model, motion, static=False)
            for rtol in OWN_TOLERANCES:
                run = prepared(form, rtol)
                if (error := float(np.abs(run().position[-1][at[form]] - exact).max())) <= WANTED:
                    runs[f"simulate to {WANTED:g}", form], errors[f"simulate to {WANTED:g}", form] = run, error
                    break
            for solver in ("dense", "sparse", "sweep"):
                try:
                    run = prepared(form, 1e-8, solver)
                except kt.errors.InputError:
                    continue  # not for couplings
                runs[f"evaluation, {solver}", form], counts[f"evaluation, {solver}", form] = run, run().evaluations
        places = [motion.position.sel(node=common).values for motion in motions.values()]
        for what, (one, other) in (("follow", places), ("inverse", forces)):
            errors[what, "conventional"] = np.abs(other - one).max() / np.abs(one).max()
        seconds = _in_turn(runs, options.rounds, time.process_time)
        for key, time_of in seconds.items():
            what, form = key
            each = time_of / counts.get(key, SAMPLES)
            same = seconds.get((what, "bars"))
            rows.append(
                _row(
                    f"{name}, {form}: {what}",
                    us=None if what.startswith("simulate") else 1e6 * each,
                    seconds=time_of,
                    error=errors.get(key),
                    ratio=None if form == "bars" else each * counts.get((what, "bars"), SAMPLES) / same,
                )
            )
    return rows


def _delta_path(options) -> list[dict]:
    """The platform turns and sinks; angles (rad) and torques against virtual work in the three coordinates."""
    from _robots import delta_closed_form

    import kinetruss as kt

    model = kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7))
    path = kt.Quintic(moves={"x": (0.0, 0.15), "y": (0.0, -0.1), "z": (0.0, -0.12)}, duration=0.4)
    nodes = [name for name in model.nodes if name[0] in "PQ"]

    def call():
        return kt.dynamics.inverse_along(model, path, platform=nodes, samples=SAMPLES, static=False)

    found = call()
    data = found.motion.data.sel(node="Q")
    P, V, A = (data[name].values for name in ("position", "velocity", "acceleration"))
    P = P + np.array([0.0, 0.0, 0.05])
    angles, torques = delta_closed_form(P, V, A)
    error = max(
        np.abs(found.motion.drive_position.values - angles).max(),
        np.abs(found.drive_force.values - torques).max() / np.abs(torques).max(),
    )
    return _path_rows("delta path", call, lambda: delta_closed_form(P, V, A), error, options.rounds)


def _stewart(kt):
    """Model, feet, heads from the middle of all nodes of the platform, its place."""
    model = kt.library.mechanisms.stewart(platform_mass=STEWART["mass"], leg_mass=STEWART["leg"])
    ends = [[np.array(model.nodes[end].at) for end in model.bars[f"leg{k}"].ends] for k in range(1, 7)]
    feet, heads = (np.array(points) for points in zip(*ends, strict=True))
    home = np.mean([model.nodes[name].at for name in PLATFORM], axis=0)
    return model, feet, heads - home, home


def _stewart_path(options) -> list[dict]:
    """All six coordinates of the platform move; lengths (m) and forces of the legs against virtual work."""
    from _robots import stewart_closed_form

    import kinetruss as kt

    model, feet, heads, home = _stewart(kt)
    ends = {"x": 0.1, "y": -0.08, "z": 0.12, "roll": 0.15, "pitch": -0.2, "yaw": 0.3}
    path = kt.Quintic(moves={name: (0.0, end) for name, end in ends.items()}, duration=0.5)

    def call():
        return kt.dynamics.inverse_along(model, path, platform=PLATFORM, samples=SAMPLES, static=False)

    s = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    rise = (s**3 * (10 - 15 * s + 6 * s**2), 30 * s**2 * (1 - s) ** 2 / 0.5, 60 * s * (1 - s) * (1 - 2 * s) / 0.25)
    moves = [each * np.array(list(ends.values())) for each in rise]

    def closed():
        return stewart_closed_form(feet, heads, home, STEWART["mass"], STEWART["leg"], moves)

    found, (lengths, forces) = call(), closed()
    error = max(
        np.abs(found.motion.drive_position.values - lengths).max(),
        np.abs(found.drive_force.values - forces).max() / np.abs(forces).max(),
    )
    return _path_rows("stewart path", call, closed, error, options.rounds)


def _forward_rows(case: str, codes: dict, right, rounds: int) -> list[dict]:
    """The fastest measured setting of each code that is as exact as wanted; `ratio`: its time over that of kinetruss."""
    chosen = {}
    for code, settings in codes.items():
        good = []
        for name, run in settings:
            run()
            began = time.perf_counter()
            error = float(np.abs(run() - right).max())
            seconds = time.perf_counter() - began
            sys.stderr.write(f"{case}, {code}, {name}: {error:.1e} {1e3 * seconds:.2f} ms\n")
            if error <= WANTED:
                good.append((seconds, f"{case}: {code}, {name}", run, error))
        if good:
            chosen[code] = min(good, key=lambda one: one[0])
    seconds = _in_turn({code: one[2] for code, one in chosen.items()}, rounds)
    own = seconds.get("kinetruss")
    return [
        _row(chosen[code][1], seconds=time_of, error=chosen[code][3], ratio=None if own is None else time_of / own)
        for code, time_of in seconds.items()
    ]


def _robot_forward(options) -> list[dict]:
    import _robot_trees as trees
    from _robot_bars import robot, robot_coordinates
    from _robots import END, robot_end

    def own(rtol: float):
        prepared = robot(rtol)
        return lambda: robot_coordinates(prepared.run(END).position[-1])

    codes = {
        "kinetruss": [(f"DOP853 rtol {rtol:g}", own(rtol)) for rtol in OWN_TOLERANCES],
        "minimal coordinates, NumPy": [
            (f"{method} rtol {rtol:g}", lambda rtol=rtol, method=method: robot_end(rtol, method)[0])
            for method in ("DOP853", "RK45", "LSODA")
            for rtol in (1e-7, 1e-8, 3e-9, 1e-9, 1e-10)
        ],
    }
    for code in PEERS:
        if importlib.util.find_spec(code):
            codes[code] = [(f"{method} {fine:g}", trees.prepared(code, method, fine)) for method, fine in trees.settings()]
    return _forward_rows("robot forward", codes, robot_end(1e-13)[0], options.rounds)


def _stewart_forward(options) -> list[dict]:
    """Every leg pushes with a constant force, from rest; places of the platform's nodes, m."""
    from _robots import stewart_end

    import kinetruss as kt

    model, feet, heads, home = _stewart(kt)
    nodes = [list(model.nodes).index(model.bars[f"leg{k}"].ends[1]) for k in range(1, 7)]
    t_end, loads = STEWART["t_end"], (STEWART["mass"], STEWART["leg"], STEWART["push"])
    tasks = {f"leg{k}": kt.GivenForce(STEWART["push"]) for k in range(1, 7)}

    def own(rtol: float):
        prepared = _stepping(model, t_end, rtol, rtol, tasks)
        return lambda: prepared.run(t_end).position[-1][nodes]

    codes = {
        "kinetruss": [(f"rtol {rtol:g}", own(rtol)) for rtol in OWN_TOLERANCES],
        "Newton-Euler, NumPy": [
            (f"DOP853 rtol {rtol:g}", lambda rtol=rtol: stewart_end(feet, heads, home, *loads, t_end, rtol)[0])
            for rtol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10)
        ],
    }
    right = stewart_end(feet, heads, home, *loads, t_end, 1e-13)[0]
    return _forward_rows("stewart forward", codes, right, options.rounds)


def _solid(options) -> list[dict]:
    """A sample is an element, `seconds` one evaluation of the mesh; `ratio`: the time to copy what it touches over its own."""
    import solids

    found = solids.measured(options.elements, options.rounds)
    return [
        _row(
            f"solid of {found['elements']} tetrahedra: {row['case']}",
            us=1e-3 * row["ns_per_element"],
            seconds=1e-9 * row["ns_per_element"] * found["elements"],
            ratio=1 / row["ratio"],
        )
        for row in found["rows"]
    ]


if __name__ == "__main__":
    main()
