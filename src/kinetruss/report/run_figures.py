"""The pictures of a run: collects the data of each from the results, and draws them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant, moment
from kinetruss.display.ranks import largest_first, order_of
from kinetruss.model.bracing import CHORD
from kinetruss.report.mechanism_figures import mechanism_figures
from kinetruss.report.pictures.specs import Bars, Drawing, Figure, Histories, Panel
from kinetruss.report.pictures.stands import drawing, shown_at
from kinetruss.report.run_data import worst
from kinetruss.runs.doubts import poses_of
from kinetruss.runs.mission_results import check_histories
from kinetruss.strength.beam_verdict import middle_forces
from kinetruss.viewer.places import Places
from kinetruss.viewer.scenes import snapshots

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

__all__ = ["figures", "specifications"]

CURVES = 7
"""Largest number of curves in one panel: the number of colours that all readers can distinguish."""
BARS = 14
POSES, ALIKE, APART = 101, 0.02, 0.25
"""Samples among which the poses of a shape are chosen; distances of two, as shares of the way from the first, that make them
alike, and that extremes have from the others.
"""


def figures(run: RunResult, folder: str | Path, formats: Iterable[str] = ("png", "svg")) -> list[Path]:
    """Draw the pictures of a run: shape, lengths, paths, angles, forces of members and drives, stresses and utilisation, motor
    demands, quantities of the model.

    Parameters
    ----------
    folder : made if needed. formats : of ``png``, ``svg``, ``pdf``.

    Returns
    -------
    The paths written, ``folder/NAME.FORMAT``.

    Raises
    ------
    StoreError : the folder cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> import tempfile
    >>> run = kt.run(model)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     " ".join(sorted(path.stem for path in kt.report.figures(run, folder, formats=["svg"])))
    'drives forces lengths paths shape speeds stresses turning utilisation'
    """
    from kinetruss.report.pictures.draw import save

    if run.good:
        check_histories(run)
    return save(specifications(run), Path(folder), formats)


def specifications(run: RunResult) -> list[Figure]:
    """The figures of a run; empty if no sample is good."""
    if not run.good:
        return []
    found: list[Figure] = [_shape(run), *_lengths(run), *mechanism_figures(run)]
    if run.simulation is not None:
        found.append(_energies(run.simulation.data))
    for case, forces in run.forces.items():
        found += _of_case("forces", case, run, _forces(run.model, forces))
        found += _of_case("drives", case, run, _drives(run, case, forces))
    if run.verdict is not None:
        found += _utilisation(run)
    for case, demand in run.demand.items():
        found += _of_case("motors", case, run, _motors(run.model, demand.data))
    return found


def _of_case(name: str, case: str, run: RunResult, drawn: Histories | None) -> Iterator[Histories]:
    """A figure of one load case, named after it if there are several."""
    if drawn is None:
        return
    several = len(run.forces) > 1
    title = f"{drawn.title}, load case {case}" if several else drawn.title
    yield Histories(name=f"{name}_{case}" if several else name, title=title, time=drawn.time, panels=drawn.panels)


SHAPE, LEAST_SHAPE = 210.0, 90.0
"""Width of three poses of a shape beside each other, and of one, mm."""


def _shape(run: RunResult) -> Drawing:
    position = run.motion.whole["position"].values
    poses = poses_of(run)
    shown = list(range(len(run.model.nodes)))
    chosen = _apart(position[:, shown])
    scene = snapshots(run, case=next(iter(run.forces), None), samples=chosen)
    stands = shown_at(scene, [moment(time, poses) for time in scene.arrays["time"]], "iso")
    places = Places(scene)
    words = ["shape", *["driven members green"] * any(kind in ("driven", "active") for kind in places.kinds)]
    words += ["supports as triangles"] * bool(run.model.whole.fixed)
    words += ["loads violet"] * any(one.arrows for one in stands)
    title = f"{run.model.title or run.name}: {', '.join(words)}"
    return drawing(scene, stands, width=max(LEAST_SHAPE, SHAPE * len(chosen) / 3), name="shape", title=title)


def _apart(position: NDArray[np.float64]) -> list[int]:
    """At most three samples of positions (t, n, dim) that show different poses: first, middle and last; or where two of them
    are alike (after a full turn, a way back) the first and the extremes of the motion along its main direction, or what is
    farthest from those chosen.
    """
    few = np.unique(np.linspace(0, len(position) - 1, min(len(position), POSES)).round().astype(int))
    reach = float(np.abs(position[few] - position[0]).max(initial=0.0))

    def far(k: int, others: Sequence[int]) -> float:
        return min(float(np.abs(position[k] - position[i]).max(initial=0.0)) for i in others)

    chosen = sorted({0, len(position) // 2, len(position) - 1})
    if all(far(k, [i for i in chosen if i != k]) > ALIKE * reach for k in chosen[1:]):
        return chosen
    # the main direction of all positions as vectors, from their products with each other
    flat = (position[few] - position[few].mean(axis=0)).reshape(len(few), -1)
    main = np.linalg.eigh(flat @ flat.T)[1][:, -1]
    chosen = [0]
    for extreme in (int(few[main.argmin()]), int(few[main.argmax()])):
        if reach and far(extreme, chosen) > APART * reach:
            chosen.append(extreme)
    while reach and len(chosen) < 3:
        best = max(few.tolist(), key=lambda k: far(k, chosen))
        if far(best, chosen) <= ALIKE * reach:
            break
        chosen.append(best)
    return sorted(chosen)


def _lengths(run: RunResult) -> Iterator[Histories]:
    data = run.motion.whole
    kinds = drive_kinds(run.model)
    panels = []
    for kind, unit in (("length", "m"), ("angle", "rad"), ("coordinate", "m")):
        chosen = [k for k, drive in enumerate(data["drive"].values) if kinds[str(drive)] == kind][:CURVES]
        if chosen:
            names = [str(data["drive"].values[k]) for k in chosen]
            for what, variable, per in ((kind, "drive_position", ""), ("rate", "drive_velocity", "/s")):
                lines = {name: data[variable].values[:, k] for name, k in zip(names, chosen, strict=True)}
                panels.append(Panel(quantity=what, unit=unit + per, lines=lines))
    if not panels and data.sizes["member"]:
        panels = [Panel(quantity="length", unit="m", lines=_most_moving(data))]
    if panels:
        yield Histories(name="lengths", title="Driven lengths and angles", time=data["time"].values, panels=tuple(panels))


def _energies(data: Any) -> Histories:
    """Kinetic, potential and total energy; below, the change of the total."""
    names = {"kinetic": "kinetic_energy", "potential": "potential_energy", "whole": "energy"}
    lines = {label: data[name].values for label, name in names.items()}
    change = {"whole": lines["whole"] - lines["whole"][0]}
    panels = (Panel(quantity="energy", unit="J", lines=lines), Panel(quantity="change of energy", unit="J", lines=change))
    return Histories(name="energies", title="Energies", time=data["time"].values, panels=panels)


def drive_kinds(model: Model) -> dict[str, str]:
    """Drive -> ``length``, ``angle`` or ``coordinate``."""
    return {name: drive.kind for name, drive in model.all_drives.items()}


def _most_moving(data: Any) -> dict[str, NDArray[np.float64]]:
    """Lengths of the members whose length changes most."""
    length = data["length"].values
    order = order_of(np.ptp(length, axis=0))[:CURVES]
    return {str(data["member"].values[k]): length[:, k] for k in order}


def _forces(model: Model, forces: Forces) -> Histories | None:
    """The members with the largest forces, of beams in their middle, and the band of all; dotted: the same poses at rest. None
    without members.
    """
    data, beams = forces.whole, {f"{name}{CHORD}": name for name in model.whole.beams}
    values, every = middle_forces(model, forces), list(map(str, data["member"].values))
    real = np.array([name in beams or name in model.whole.real_members for name in every], np.bool_)
    kept = np.flatnonzero(real & ~np.isnan(values).any(axis=0))
    if not len(kept):
        return None
    order = kept[order_of(np.max(np.abs(values[:, kept]), axis=0))[: CURVES - 1]]
    names = [beams.get(every[k], every[k]) for k in order]
    lines = {name: values[:, k] for name, k in zip(names, order, strict=True)}
    still: dict[str, NDArray[np.float64]] = {}
    if forces.static is not None:
        rest = middle_forces(model, forces.static)
        still = {name: rest[:, k] for name, k in zip(names, order, strict=True)}
    band = values[:, kept].min(axis=1), values[:, kept].max(axis=1)
    panel = Panel(quantity="member force", unit="N", lines=lines, dashed=still, band=band)
    title = "Largest member forces (mean axial force, tension positive)"
    return Histories(name="forces", title=title, time=data["time"].values, panels=(panel,))


def _drives(run: RunResult, case: str, forces: Forces) -> Histories | None:
    """Force or torque, and power, of the drives that have no motor; dashed: at rest. None without any, or without motion."""
    if run.good < 2 or "pose" in run.motion.whole.coords:
        return None
    data, kinds = forces.whole, drive_kinds(run.model)
    with_motor = set(run.demand[case].data["active"].values) if case in run.demand else set()
    names = [str(name) for name in data["drive"].values] if "drive_force" in data else []
    still = forces.static.whole["drive_force"].values if forces.static is not None else None
    panels, chosen = [], []
    for what, unit, turning in (("drive force", "N", False), ("torque", "N m", True)):
        own = [k for k, name in enumerate(names) if name not in with_motor and (kinds[name] == "angle") == turning]
        own = [k for k in own if np.isfinite(data["drive_force"].values[:, k]).all()][:CURVES]
        if own:
            lines = {names[k]: data["drive_force"].values[:, k] for k in own}
            rest = {} if still is None else {names[k]: still[:, k] for k in own}
            panels.append(Panel(quantity=what, unit=unit, lines=lines, dashed=rest))
            chosen += own
    if not panels:
        return None
    rates = forces.motion.arrays["drive_velocity"].values
    power = {names[k]: data["drive_force"].values[:, k] * rates[:, k] for k in chosen[:CURVES]}
    panels.append(Panel(quantity="power", unit="W", lines=power))
    return Histories(name="drives", title="Forces, torques and power of drives", time=data["time"].values, panels=tuple(panels))


def _when(run: RunResult, time: float) -> str:
    """The instant of a value, after it; nothing for a single position."""
    return f", t = {instant(time)}" if run.good > 1 else ""


def _utilisation(run: RunResult) -> Iterator[Figure]:
    rows = worst(run)[:BARS]
    if rows:
        notes = tuple(f"{row['rule']}{_when(run, row['time'])}" for row in rows)
        yield Bars(
            name="utilisation",
            title="Utilisation of the worst members by their governing rule",
            quantity="utilisation (demand over capacity)",
            unit="%",
            labels=tuple(row["part"] for row in rows),
            values=np.array([row["utilisation"] for row in rows]),
            notes=notes,
        )
    stressed: dict[str, Any] = {}
    for row in run.verdict.table() if run.verdict is not None else ():
        if row.unit == "Pa" and np.isfinite(row.value) and (row.part not in stressed or stressed[row.part].value < row.value):
            stressed[row.part] = row
    ranked = largest_first(stressed.values(), lambda row: row.value)
    highest = ranked[:BARS]
    if highest:
        notes = tuple(f"{_when(run, row.time)}{'' if row.checked else ', no yield strength'}" for row in highest)
        yield Bars(
            name="stresses",
            title="Highest stress of each part"
            if ranked == highest
            else f"Highest stress: the first {BARS} of {len(ranked)} parts",
            quantity="stress",
            unit="Pa",
            labels=tuple(row.part for row in highest),
            values=np.array([row.value for row in highest]),
            notes=notes,
            limit=np.inf,
        )


def _motors(model: Model, data: Any) -> Histories | None:
    """Torque, current and voltage of every motor, with their common limits."""
    panels = []
    for what, variable, unit, field in (
        ("thrust", "thrust", "N", None),
        ("drive torque", "drive_torque", "N m", None),
        ("motor torque", "motor_torque", "N m", "max_torque"),
        ("current", "current", "A", "max_current"),
        ("voltage", "voltage", "V", "max_voltage"),
    ):
        values = data[variable].values if variable in data else np.empty((0, 0))
        known = [k for k in range(values.shape[1]) if not np.isnan(values[:, k]).all()][:CURVES]
        if known:
            lines = {str(data["active"].values[k]): values[:, k] for k in known}
            panels.append(Panel(quantity=what, unit=unit, lines=lines, limit=_limit(model, list(lines), field)))
    if len(panels) < 2:
        return None
    return Histories(name="motors", title="Motor demands", time=data["time"].values, panels=tuple(panels))


def _limit(model: Model, names: list[str], field: str | None) -> float | None:
    """The smallest limit of the motors shown, or None."""
    if field is None:
        return None
    motors = [model.actuators[name].motor for name in names]
    records = [model.motors[motor] if isinstance(motor, str) else motor for motor in motors]
    known = [limit for record in records if record is not None and (limit := getattr(record, field)) is not None]
    return min(known, default=None)
