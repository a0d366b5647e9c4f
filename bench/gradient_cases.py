"""Cases of `bench/gradients.py --json`: what a gradient costs beside its value, and how far it is from differences.

A case is a name, a response and the numbers by which it is differentiated. Both times are of a model that is changed a little
each time, as a search does it: value, of that model and its whole analysis; gradient, of value and derivatives. Times are
processor times, medians in one run; the error is the largest of some derivatives, each in a change of its number by its size,
of the largest. ``--quick`` leaves out the large ones.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import partial
from statistics import median
from typing import Any, NamedTuple

import numpy as np

import kinetruss as kt
from kinetruss.gradients.varied import varied
from statics import grid

ROUNDS, LEAST, CHECKED = 5, 0.2, 4
"""Calls of which the median is taken, the time in s after which two are enough, numbers that are checked."""


class Case(NamedTuple):
    """name, response, numbers, and the step of the differences to compare with (0: not compared)."""

    name: str
    of: kt.Response
    wrt: list[str]
    step: float = 1e-5


def four_bar() -> list[Case]:
    """Forces, and a whole run, by lengths, sections and places."""
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
    rms = f"rms(drive_force[{next(iter(model.active))}])"
    return [Case(f"{bays} bays, rms of a force, 10", kt.Response(rms, kt.run, model), few)] + [
        Case(f"{bays} bays, {name}, {what}", kt.Response(text, kt.run, model), wrt, 1e-4 if what == "sections" else 1e-5)
        for name, text in (("utilisation", "max(utilisation)"), ("torque", "max(motor_torque)"))
        for what, wrt in (("10", few), ("places", places), ("sections", sections))
    ]


def sized(side: int) -> list[Case]:
    """A grid of bars at rest by the sections of all of them."""
    model = grid(side)[0]
    model = model.with_(bars={name: bar.with_(section=model.section) for name, bar in model.bars.items()})
    text = f"displacement[n{side}_{side}, y]"
    return [Case(f"{len(model.bars)} bars at rest, sections", kt.Response(text, kt.statics.linear, model), SIZES)]


def tower(bays: int) -> kt.Model:
    """Bays of elastic bars one above the other, pushed from above."""
    nodes = {f"{row}{i}": (x, float(i)) for i in range(bays + 1) for row, x in (("l", 0.0), ("r", 1.0 - 0.02 * i))}
    pairs = [(f"{row}{i}", f"{row}{i + 1}") for i in range(bays) for row in "lr"]
    pairs += [(f"{a}{i + j}", f"{b}{i + 1}") for i in range(bays) for a, b, j in (("l", "r", 0), ("r", "l", 0), ("l", "r", 1))]
    return kt.Model(
        nodes=nodes, fixed=["l0", "r0"], material="steel_s235", gravity=(0, -9.81),
        bars={a + b: kt.Bar(ends=(a, b), kind="elastic", section=kt.Rod(diameter=0.02)) for a, b in pairs},
        loads={"push": kt.NodalForce(node=f"l{bays}", force=(0, -100.0))},
    )  # fmt: skip


def at_rest() -> list[Case]:
    """Equilibrium, frequencies and buckling of a tower of fifty bars by their sections."""
    model = tower(10)
    factor = kt.Response("load_factor[1]", kt.statics.buckling, model, load="push")
    return [
        Case("50 bars, equilibrium, sections", kt.Response("position[l10, x]", kt.statics.equilibrium, model), SIZES, 1e-3),
        Case("50 bars, frequency, sections", kt.Response("frequency[1]", kt.flexible.frequencies, model), SIZES, 1e-3),
        Case("50 bars, buckling, sections", factor, SIZES, 1e-3),
    ]


def hanging(links: int, t_end: float, text: str, rtol: float, step: float = 1e-4) -> list[Case]:
    """A chain that swings, by its lengths and masses."""
    names = [f"P{i}" for i in range(links + 1)]
    nodes: dict[str, Any] = {"P0": (0.0, 0.0)}
    nodes |= {name: kt.Node(at=(0.6 * i, 0.1 * i * i), mass=1.0 + 0.1 * i) for i, name in enumerate(names) if i}
    model = kt.Model(nodes=nodes, fixed=["P0"], gravity=(0, -9.81),
                     bars={f"b{i}": (names[i], names[i + 1]) for i in range(links)})  # fmt: skip
    of = kt.Response(text, kt.dynamics.simulate, model, t_end=t_end, samples=201, method=kt.DOP853(rtol=rtol, atol=rtol))
    wrt = [f"nodes.{name}.{what}" for name in names[1:] for what in ("at.0", "at.1", "mass")][:10]
    return [Case(f"{links} links, run of {t_end:g} s, {text.partition('(')[0]}, {len(wrt)}", of, wrt, step)]


SIZES = ["bars.*.section.diameter"]
QUICK: list[Callable[[], list[Case]]] = [four_bar, partial(chain, 1), partial(sized, 4), at_rest,
                                         partial(hanging, 3, 2.0, "final(position[P3, x])", 1e-9)]  # fmt: skip
LONG: list[Callable[[], list[Case]]] = [
    partial(chain, 10), partial(sized, 29), partial(sized, 50), partial(hanging, 3, 2.0, "rms(position[P3, x])", 1e-9),
    partial(hanging, 1, 300.0, "final(position[P1, x])", 1e-13, 3e-6),
]  # fmt: skip


def measured(chosen: str = "", *, quick: bool = False) -> Iterator[dict[str, Any]]:
    """Rows of all cases whose name has `chosen` in it."""
    for make in QUICK if quick else QUICK + LONG:
        yield from (_row(case) for case in make() if chosen in case.name)


def _row(case: Case) -> dict[str, Any]:
    by = varied(case.of.model, case.wrt)
    moved = iter(1e-6 * (k + 1) for k in range(100))

    def model() -> kt.Model:
        return by.model_at(next(moved) * by.scale)

    def value(model: kt.Model) -> None:
        _ = kt.run(model) if case.of.analysis is kt.run else case.of.at(model).value

    own, slope = _time(model, value), _time(model, lambda model: kt.value_and_gradient(case.of.at(model), case.wrt))
    found = {"case": case.name, "numbers": len(by.names), "value_ms": own, "gradient_ms": slope, "ratio": slope / own}
    return found | {"error": _error(case, by)}


def _error(case: Case, by: Any) -> float | None:
    """Of some numbers beside differences of fourth order of the whole analysis."""
    if not case.step:
        return None
    every = kt.gradient(case.of, case.wrt).values * by.scale
    some = np.unique(np.linspace(0, len(every) - 1, CHECKED).astype(int))
    beside = kt.check_gradient(case.of, [list(by.paths[k]) for k in some], case.step)
    return float(np.abs(beside.gradient * by.scale[some] - beside.differences * by.scale[some]).max() / np.abs(every).max())


def _time(model: Callable[[], kt.Model], work: Callable[[kt.Model], Any]) -> float:
    """Median of processor times, ms, after a first call."""
    work(model())
    times: list[float] = []
    while len(times) < ROUNDS and (len(times) < 2 or sum(times) < 1e3 * LEAST * ROUNDS):
        given, start = model(), time.process_time()
        work(given)
        times.append(1e3 * (time.process_time() - start))
    return median(times)
