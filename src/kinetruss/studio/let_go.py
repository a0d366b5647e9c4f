"""A drawing that is let go: what nothing holds falls and swings under gravity, loads and springs; and what is kept of it."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss import dynamics
from kinetruss.display import instant
from kinetruss.errors import InputError, KinetrussError
from kinetruss.mechanics import compile
from kinetruss.model import Free
from kinetruss.results import Status
from kinetruss.statics.search import projected
from kinetruss.studio.drawing import model_of
from kinetruss.studio.edits import at_pose, entry_of
from kinetruss.studio.poses import CLOSED, reason
from kinetruss.studio.sweeps import SAMPLES, TURN, Film, Swept, packed

if TYPE_CHECKING:
    from collections.abc import Callable

    from kinetruss.kernels.compiled.record import Floats
    from kinetruss.model import Model
    from kinetruss.studio.edits import Data

SAME = 1e-6
"""Largest difference of accelerations (m/s^2) and forces (N) of a pose that is kept, as a fraction of the largest, and of 1."""

BRIEF = 1e-6
"""Seconds of the motion from which the forces of a pose are taken."""

STILL = 1e-12
"""Distance by which a node has not moved, as a fraction of the size of the drawing."""

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

    run = dynamics.simulate(
        model, duration, samples=SAMPLES, tasks=_tasks(model, held), positions=position, progress=look, raise_on_failure=False
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


def _tasks(model: Model, held: bool) -> dict[str, Free]:
    return {} if held else dict.fromkeys(model.all_drives, Free())


def kept(data: Data, model: Model, film: Film, sample: int) -> Data:
    """The data of a model with its nodes where they are at a sample of its motion, with all lengths, masses and free lengths.

    Raises
    ------
    InputError : it was not let go; its parts would push otherwise if they were drawn so, as beams do, which are straight where
        they are drawn.
    """
    if "drives_hold" not in film.header:
        raise InputError("Keep a pose of this motion by the values of its drives.")
    motion, system = film.forces.motion.whole, compile(model)
    size = float(np.ptp(system.x0, axis=0).max()) or 1.0
    x, wanted, driven = system.x0.copy(), system.row_value.copy(), system.row_drive >= 0
    there = motion["position"].values[sample]
    moves = np.abs(there - x[:, : system.dim]).max(axis=1) > STILL * size
    x[moves, : system.dim] = there[moves]
    values = motion["drive_position"].sel(drive=list(system.drives)).values[sample]
    wanted[driven] = values[system.row_drive[driven]]
    x, worst = projected(system, x, wanted, size) if len(wanted) else (x, 0.0)
    if not worst <= CLOSED * size:
        raise InputError("This pose is not kept: its lengths do not close.")
    found = at_pose(data, model, x[:, : system.dim])
    try:
        found = _with_masses(found, model)
        poses = ((model, x[:, : system.dim]), (drawn := model_of(found, Path()), compile(drawn).x0[:, : system.dim]))
        then, now = (_at_rest(one, place, film.header["drives_hold"]) for one, place in poses)
    except KinetrussError as error:
        raise InputError(f"This pose is not kept: {error}") from None
    if any(not np.abs(b - a).max(initial=0.0) <= SAME * np.abs(a).max(initial=1.0) for a, b in zip(then, now, strict=True)):
        raise InputError(
            "This pose is not kept: drawn so, parts that bend or stretch would have other forces, because their shape without "
            "force is the one that is drawn."
        )
    return found


def _at_rest(model: Model, position: Floats, held: bool) -> tuple[Floats, Floats]:
    """Accelerations of the nodes, m/s^2, and forces of the members, N, of a model that is let go in a pose."""
    still = np.zeros_like(position)
    run = dynamics.simulate(model, BRIEF, samples=2, tasks=_tasks(model, held), positions=position, velocities=still)
    return run.motion.arrays["acceleration"].values[0], run.forces.arrays["member_force"].values[0]


def _with_masses(data: Data, model: Model) -> Data:
    """The data with the masses of bars of a model that are longer or shorter there."""
    old, new = (
        dict(zip(one.members, one.rods[:, 0].tolist(), strict=True))
        for one in (compile(model), compile(model_of(data, Path())))
    )
    rows = dict(data.get("bars") or {})
    for name in rows:
        if model.bars[name].mass is None and abs(new[name] - old[name]) > STILL * old[name]:
            rows[name] = {**entry_of(rows[name]), "mass": old[name]}
    return {**data, "bars": rows} if rows else data
