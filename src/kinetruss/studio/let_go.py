"""A drawing that is let go: what nothing holds falls and swings under gravity, loads and springs."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from kinetruss import dynamics
from kinetruss.display import instant
from kinetruss.errors import InputError
from kinetruss.model import Free
from kinetruss.results import Status
from kinetruss.studio.poses import reason
from kinetruss.studio.sweeps import SAMPLES, TURN, Film, Swept, packed

if TYPE_CHECKING:
    from collections.abc import Callable

    from kinetruss.kernels.compiled.record import Floats
    from kinetruss.model import Model

PATIENCE = 10.0
"""Seconds of computation after which a motion is shown as far as it has got; they count once kernels are compiled."""


def let_go(model: Model, position: Floats, held: bool, stop: Callable[[], object] = bool, duration: float = TURN) -> Film:
    """The motion from a closed pose (n_nodes, dim), m, for so long (s): as `sweeps.film`, with energies over time, J.

    It starts with the velocities of the model's nodes, at rest if it gives none.

    held : drives stay where they are; else they are free and give no force. stop : called now and then, ends it by an error.

    Raises
    ------
    InputError : a structure that cannot move so, such as one whose free nodes have no mass.
    """
    began: list[float] = []

    def look(_done: int, _total: int) -> None:
        stop()
        began.append(time.monotonic())
        if began[-1] > began[0] + PATIENCE:
            raise KeyboardInterrupt

    tasks = {} if held else dict.fromkeys(model.all_drives, Free())
    run = dynamics.simulate(
        model, duration, samples=SAMPLES, tasks=tasks, positions=position, progress=look, raise_on_failure=False
    )
    motion = run.motion.whole
    times = motion["time"].values
    if len(times) < 2:
        raise InputError(f"It does not move: {reason(run.message)}.")
    end = "" if run.status.ok else f"It stops at {instant(times[-1])}: {reason(run.message)}."
    if run.status is Status.INTERRUPTED:
        end = f"Shown up to {instant(times[-1])}: this motion takes long to compute. A run of its own goes on."
    found = Swept(
        drives=tuple(map(str, motion["drive"].values)), values=motion["drive_position"].values, time=times,
        position=motion["position"].values, velocity=motion["velocity"].values, acceleration=motion["acceleration"].values,
        here=0, rate=0.0, whole=False, ends=("", end),
    )  # fmt: skip
    header, arrays, forces = packed(found, model, run.forces)
    energies = {name: run.data[name].values for name in ("kinetic_energy", "potential_energy")}
    return Film(header | {"swept": [], "drives_hold": held}, arrays | energies, forces)
