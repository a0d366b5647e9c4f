"""Cases of `bench/gradients.py --json`: what a gradient costs beside its value, and how far it is from differences.

A case is a name, a response and the numbers by which it is differentiated. Value: a changed model and its whole analysis, as a
search would do it. Times are processor times, medians in one run; the error is that of `check_gradient` for up to ten numbers.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from statistics import median
from typing import Any, NamedTuple

import kinetruss as kt
from kinetruss.gradients.varied import varied

ROUNDS, CHECKED = 5, 10


class Case(NamedTuple):
    """name, response, numbers, and the step of the differences to compare with."""

    name: str
    of: kt.Response
    wrt: list[str]
    step: float = 1e-5


def four_bar() -> list[Case]:
    """By its lengths and masses: forces; and a whole run by the places of its nodes."""
    bars = {"crank": (("A", "B"), 0.1), "coupler": (("B", "C"), 0.3), "rocker": (("D", "C"), 0.25)}
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.1, 0), "C": (0.3, 0.225), "D": (0.28, 0)}, fixed=["A", "D"], gravity=(0, -9.81),
        bars={name: kt.Bar(ends=ends, length=length, section=kt.Rod(diameter=0.01), material="steel_s235")
              for name, (ends, length) in bars.items()},
        drives={"motor": kt.AngleDrive("crank")},
        runs={"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": 6.0}, duration=1.0), samples=361)},
    )  # fmt: skip
    numbers = [*(f"bars.{name}.length" for name in bars), "nodes.D.at.0", "gravity.1"]
    numbers += [*(f"bars.{name}.section.diameter" for name in bars), "runs.turn.trajectory.rates.motor", "nodes.D.at.1"]
    turn = model.runs["turn"].trajectory
    return [
        Case("four-bar, torque, 10", kt.Response("max(drive_force)", kt.dynamics.inverse, model, trajectory=turn), numbers),
        Case("four-bar, run, 10", kt.Response("max(utilisation)", kt.run, model), numbers),
    ]


def chain(bays: int) -> list[Case]:
    """Of double-octahedral bays by sections and places of nodes."""
    model = kt.library.vgt.double_octahedral(bays=bays, screw="screw_lacy_spatial", gear="gear_lacy", motor="motor_lacy")
    first = kt.kinematics.follow(model, kt.ConstantRate(rates={next(iter(model.active)): 0.01}, duration=0.1), samples=2)
    length = {name: first.length.sel(member=name).values[0].item() for name in model.active}
    moves = {name: (one, one + 0.02 + 0.001 * (k % 5)) for k, (name, one) in enumerate(length.items())}
    own = {name: bar.with_(section=model.sections["bar"]) for name, bar in model.bars.items()}
    run = kt.Run(trajectory=kt.Quintic(moves=moves, duration=2.0), samples=101)
    model = model.with_(bars=own, runs={"extend": run}, gravity=(0, 0, -9.81))
    nodes, bars = list(model.nodes)[4:7], list(model.bars)[:5]
    few = [f"nodes.{node}.at.2" for node in nodes] + [f"bars.{bar}.section.outer" for bar in bars]
    few += ["gravity.2", "runs.extend.trajectory.duration"]
    places = [f"nodes.*.at.{axis}" for axis in range(3)]
    sections = ["bars.*.section.outer", "bars.*.section.inner"]
    return [
        Case(f"{bays} bays, {name}, {what}", kt.Response(text, kt.run, model), wrt, 1e-4 if what == "sections" else 1e-5)
        for name, text in (("utilisation", "max(utilisation)"), ("torque", "max(motor_torque)"))
        for what, wrt in (("10", few), ("places", places), ("sections", sections))
    ]


CASES: list[Callable[[], list[Case]]] = [four_bar, lambda: chain(1), lambda: chain(10)]


def measured(chosen: str = "") -> list[dict[str, Any]]:
    """Rows of all cases whose name has `chosen` in it."""
    return [_row(case) for make in CASES for case in make() if chosen in case.name]


def _row(case: Case) -> dict[str, Any]:
    by = varied(case.of.model, case.wrt)

    def value() -> None:
        model = by.model_at(1e-6 * by.scale)
        if case.of.analysis is kt.run:
            kt.run(model)
        else:
            case.of.at(model).value  # noqa: B018

    own, slope = _time(value), _time(lambda: kt.gradient(case.of, case.wrt))
    checked = list(by.names)[:: max(1, len(by.names) // CHECKED)][:CHECKED]
    error = kt.check_gradient(case.of, checked, case.step).error
    found = {"case": case.name, "numbers": len(by.names), "value_ms": own, "gradient_ms": slope, "ratio": slope / own}
    return found | {"error": error}


def _time(work: Callable[[], Any]) -> float:
    """Median of processor times, ms, after a first call."""
    work()
    times = []
    for _ in range(ROUNDS):
        start = time.process_time()
        work()
        times.append(1e3 * (time.process_time() - start))
    return median(times)
