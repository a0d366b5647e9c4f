"""What a public call costs beside its compiled kernels.

    python bench/calls.py [--json] [--rounds N] [--only WORD]

Small models, 201 samples. Milliseconds of the public call; of the compiled kernels that it calls, called again with the same
arguments in turn with it; the difference (`beside_ms`); and the ratio of call to kernels. Then one update of the live editor
and the prepared forms. Medians of processor time, warm, in one process with one thread.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1")  # before NumPy is loaded

from numba.core.dispatcher import Dispatcher

import kinetruss as kt
from kinetruss.studio import Session

Call = Callable[[], Any]
Case = tuple[str, str, Call, Call | None]
"""Model, name, public call, and what runs its kernels alone where calling them again is not the same work."""

PLATFORM = ("P1", "P2", "P3", "P4", "P5", "P6")


def four_bar() -> kt.Model:
    """A crank-rocker of steel bars."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)},
        fixed=("A", "D"),
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        section=kt.Rectangle(width=0.020, height=0.005),
        material=kt.library.materials.STEEL_S235,
        drives={"motor": kt.AngleDrive("crank")},
        gravity=(0, -9.81),
    )


def cases() -> Iterator[Case]:
    """All calls."""
    turn = kt.ConstantRate(rates={"motor": 10.0}, duration=0.6283)
    yield from along("four_bar", four_bar(), turn)
    yield from let_go("four_bar", four_bar(), {"motor": kt.Free()})
    back = kt.Quintic(moves={"C.x": (0.30, 0.32)}, duration=1.0)
    linkage = four_bar()
    yield "four_bar", "kinematics.inverse", lambda: kt.kinematics.inverse(linkage, back), None
    bay = kt.library.vgt.double_octahedral(bays=1)
    longer = {name: (value, 1.05 * value) for name, value in Session(bay).pose.values.items()}
    yield from along("bay", bay, kt.Quintic(moves=longer, duration=1.0))
    yield from on_a_path("stewart", kt.library.mechanisms.stewart(platform_mass=12.0))
    robot = kt.library.mechanisms.robot()
    yield "four_bar", "studio.move", moved(four_bar()), None
    yield "bay", "studio.move", moved(bay), None
    yield "robot", "studio.move", moved(robot), None


def many(name: str, model: kt.Model, trajectory: Any) -> Iterator[Case]:
    """The prepared form of `along`."""
    ready = kt.prepare(model)
    places = ready.follow(trajectory)
    yield name, "prepared.follow", lambda: ready.follow(trajectory), None
    yield name, "prepared.forces", lambda: ready.forces(places), None


def along(name: str, model: kt.Model, trajectory: Any) -> Iterator[Case]:
    """The calls of a model along a trajectory."""
    motion = kt.kinematics.follow(model, trajectory)
    forces = kt.dynamics.inverse(model, motion)
    yield name, "kinematics.follow", lambda: kt.kinematics.follow(model, trajectory), None
    yield name, "dynamics.inverse", lambda: kt.dynamics.inverse(model, motion), None
    yield name, "strength.check", lambda: kt.strength.check(model, forces), None
    yield from many(name, model, trajectory)


def let_go(name: str, model: kt.Model, tasks: dict[str, Any]) -> Iterator[Case]:
    """Half a second of free motion; its kernels are those of the prepared form."""
    ready = kt.dynamics.prepare(model, 0.5, tasks=tasks)
    yield name, "dynamics.simulate", lambda: kt.dynamics.simulate(model, 0.5, tasks=tasks), lambda: ready.run(0.5, samples=201)


def on_a_path(name: str, model: kt.Model) -> Iterator[Case]:
    """A platform lifted by a tenth of a metre."""
    up = kt.Quintic(moves={"z": (0.0, 0.1)}, duration=1.0)
    lifted = kt.kinematics.inverse(model, up, platform=PLATFORM)
    yield name, "kinematics.inverse", lambda: kt.kinematics.inverse(model, up, platform=PLATFORM), None
    yield name, "dynamics.inverse", lambda: kt.dynamics.inverse(model, lifted), None


def moved(model: kt.Model) -> Call:
    """One update of the live editor: all drives to and fro by a hundredth, forces, stresses, motors, packing."""
    session, count = Session(model), 0
    start = dict(session.pose.values)

    def update() -> None:
        nonlocal count
        count += 1
        session.move({name: value + 0.01 * (count % 2) for name, value in start.items()})

    return update


class Recorder:
    """A kernel that keeps its arguments when it is called."""

    def __init__(self, kernel: Any, calls: list[tuple[Any, tuple[Any, ...]]]) -> None:
        self.kernel, self.calls = kernel, calls

    def __call__(self, *arguments: Any) -> Any:
        self.calls.append((self.kernel, arguments))
        return self.kernel(*arguments)


def kernels_of(call: Call) -> Call:
    """The kernels that a warm call calls, with its arguments, as a call of their own."""
    calls: list[tuple[Any, tuple[Any, ...]]] = []
    modules = [one for name, one in list(sys.modules.items()) if name.startswith("kinetruss") and isinstance(one, ModuleType)]
    places = [(one, name, value) for one in modules for name, value in vars(one).items() if isinstance(value, Dispatcher)]
    for module, name, kernel in places:
        setattr(module, name, Recorder(kernel, calls))
    try:
        call()
    finally:
        for module, name, kernel in places:
            setattr(module, name, kernel)

    def again() -> None:
        for kernel, arguments in calls:
            kernel(*arguments)

    return again


def measured(case: Case, rounds: int) -> dict[str, Any]:
    """One row: the call and its kernels in turn."""
    model, name, call, kernels = case
    call()
    call()
    both = (call, kernels or kernels_of(call))
    taken: tuple[list[float], list[float]] = ([], [])
    for _ in range(rounds):
        for one, times in zip(both, taken, strict=True):
            began = time.process_time()
            one()
            times.append(1e3 * (time.process_time() - began))
    whole, alone = (statistics.median(times) for times in taken)
    return {"model": model, "call": name, "ms": whole, "kernel_ms": alone, "beside_ms": whole - alone, "ratio": whole / alone}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--rounds", type=int, default=100)
    parser.add_argument("--only", default="", help="only the rows with this word in their model or call")
    options = parser.parse_args()
    rows = [measured(case, options.rounds) for case in cases() if options.only in f"{case[0]} {case[1]}"]
    if options.json:
        print(json.dumps({"rows": rows}))
        return
    for row in rows:
        numbers = f"{row['ms']:8.3f} ms, kernels {row['kernel_ms']:7.3f}, beside {row['beside_ms']:7.3f}, x {row['ratio']:.1f}"
        print(f"{row['model']:10} {row['call']:20} {numbers}")


if __name__ == "__main__":
    main()
