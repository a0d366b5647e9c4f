"""Gauge readings and joint forces as text, as data and as tables."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, number, quantity
from kinetruss.elements.local_axes import local_axes
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.report.page import Page
from kinetruss.report.run_data import pose_at
from kinetruss.runs.mission_results import check_histories

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult


READING = ("gauge", "on", "start", "end", "least", "at", "largest", "at")
COMPARED = ("column", "rows", "offset", "scale", "rms", "scatter", "correlation", "lag", "largest", "at", "error")


def gauges(strains: xr.Dataset, compared: xr.Dataset | None = None) -> Page:
    """Readings of each gauge and group; with a comparison, the difference of a measured record.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["strain_gauges"][0])
    >>> page = kt.report.gauges(kt.runs.gauge_strains(model, "experiment_1"))
    >>> [line.split()[0] for line in page.text.splitlines()[2:]]
    ['G1', 'G2', 'G3', 'M6.axial', 'M6.bending_2', 'M6.bending_3']
    """
    return Page(
        found=strains,
        as_record=partial(_record, compared=compared),
        as_entries=partial(_entries, compared=compared),
        as_rows=partial(_rows, compared=compared),
    )


def _entries(strains: xr.Dataset, compared: xr.Dataset | None = None) -> Iterator[Entry]:
    """What the page says: readings of each gauge and group; with a comparison, the difference of the measured record."""
    rows = []
    for name, place, values in _curves(strains):
        entry = _extremes(strains["time"].values, values)
        if entry is not None:
            cells = [number(entry[key], 5) for key in ("start", "end", "least")]
            when = [instant(entry[key]) for key in ("least_time", "largest_time")]
            rows.append((name, place, *cells, when[0], number(entry["largest"], 5), when[1]))
    yield Table(READING, rows, f"Strain (1e-6), load case {strains.attrs['load_case']}{_zeroed(strains)}")
    if compared is not None:
        rows = [
            (
                name,
                str(compared.sizes["time"]),
                *(number(entry[key], 4) for key in ("offset", "scale", "rms", "scatter", "correlation")),
                instant(entry["shift"]) if math.isfinite(entry["shift"]) else "-",
                number(entry["largest"], 4),
                instant(entry["largest_time"]),
                number(entry["standard_error"], 3) if math.isfinite(entry["standard_error"]) else "-",
            )
            for name, entry in _comparison(compared).items()
        ]
        yield Table(COMPARED, rows, f"Measured minus simulated (1e-6), {compared.attrs['measured']}")


def _zeroed(strains: xr.Dataset) -> str:
    return ", zeroed" if np.any(strains["zero"].values) else ""


def _curves(strains: xr.Dataset) -> list[tuple[str, str, NDArray[np.float64]]]:
    """Name, place and history of every gauge and part of a group."""
    found = [
        (str(name), str(strains["part"].values[k]), strains["strain"].values[:, k])
        for k, name in enumerate(strains["gauge"].values)
    ]
    if "group_strain" in strains:
        for i, group in enumerate(strains["group"].values):
            for j, component in enumerate(strains["component"].values):
                found.append((f"{group}.{component}", "", strains["group_strain"].values[:, i, j]))
    return found


def _extremes(times: NDArray[np.float64], values: NDArray[np.float64]) -> dict[str, float] | None:
    if not np.isfinite(values).all():
        return None
    low, high = int(values.argmin()), int(values.argmax())
    numbers = {"start": values[0], "end": values[-1], "least": values[low], "largest": values[high]}
    numbers |= {"least_time": times[low], "largest_time": times[high]}
    return {key: float(value) for key, value in numbers.items()}


def _comparison(compared: xr.Dataset) -> dict[str, dict[str, float]]:
    keys = ("offset", "scale", "rms", "scatter", "correlation", "shift", "largest", "largest_time", "standard_error")
    return {
        str(name): {key: float(compared[key].values[k]) for key in keys} for k, name in enumerate(compared["column"].values)
    }


def _record(strains: xr.Dataset, compared: xr.Dataset | None = None) -> dict[str, Any]:
    """The page as plain data, strains in 1e-6."""
    times = strains["time"].values
    readings = {name: _extremes(times, values) for name, _, values in _curves(strains)}
    record: dict[str, Any] = {
        "load_case": strains.attrs["load_case"],
        "samples": len(times),
        "strain": readings,
        "zero": dict(zip(map(str, strains["gauge"].values), strains["zero"].values.tolist(), strict=True)),
        "measured": None,
    }
    if compared is not None:
        columns = {
            name: {key: value if math.isfinite(value) else None for key, value in entry.items()}
            for name, entry in _comparison(compared).items()
        }
        record["measured"] = {"file": compared.attrs["measured"], "rows": compared.sizes["time"], "columns": columns}
    return record


def _rows(strains: xr.Dataset, compared: xr.Dataset | None = None) -> list[list[Any]]:
    """Histories as a table for `io.read_strains`; for a comparison the measured and simulated ones and their difference."""
    if compared is None:
        kept = [(name, values) for name, _, values in _curves(strains) if np.isfinite(values).all()]
        times = strains["time"].values
    else:
        kinds = ("measured", "simulated", "difference")
        kept = [
            (f"{name} {kind}", compared[kind].values[:, k])
            for k, name in enumerate(compared["column"].values)
            for kind in kinds
        ]
        times = compared["time"].values
    head = ["t", *(f"{name} [microstrain]" for name, _ in kept)]
    columns = [times, *(values for _, values in kept)]
    return [head, *(list(map(float, row)) for row in zip(*columns, strict=True))]


def gauges_picture(strains: xr.Dataset, compared: xr.Dataset | None, file: str | Path, title: str = "") -> Path:
    """Draw gauges and groups over time; with a comparison, measured over simulated, and their difference below.

    Raises
    ------
    InputError : not the suffix of a picture. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> model = kt.read(kt.library.example_files()["strain_gauges"][0])
    >>> strains = kt.runs.gauge_strains(model, "experiment_1")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.gauges_picture(strains, None, f"{folder}/gauges.svg").name
    'gauges.svg'
    """
    from kinetruss.report.pictures.draw import SUFFIXES, draw, write
    from kinetruss.report.pictures.specs import Histories, Panel

    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: write to a table, .csv, or a picture, {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    if compared is None:
        lines = {name: values for name, _, values in _curves(strains) if np.isfinite(values).all()}
        panels = [Panel(quantity="strain", unit="1e-6", lines=lines)]
        times = strains["time"].values
    else:
        times = compared["time"].values
        lines, misses = {}, {}
        for k, name in enumerate(map(str, compared["column"].values)):
            lines[f"{name} measured"] = compared["measured"].values[:, k]
            lines[f"{name} simulated"] = compared["simulated"].values[:, k]
            misses[f"{name} difference"] = compared["difference"].values[:, k]
        panels = [Panel(quantity="strain", unit="1e-6", lines=lines)]
        panels.append(Panel(quantity="measured - simulated", unit="1e-6", lines=misses))
    figure = Histories(name="gauges", title=title or "Strain gauges", time=times, panels=tuple(panels))
    write(draw(figure), path)
    return path


# Joint forces at one instant, by member, node and axis.


@dataclass(frozen=True, kw_only=True, eq=False)
class JointForces:
    """Forces at the joints at one instant.

    rows : (member, end, node, force in global axes, force in member axes), N: the force on the member from its joint.
    supports : (node, force in global axes), N: the force on the structure from the ground.
    pose : name of the pose of a run of poses, whose time is its number.

    Bars that the model adds itself, as the frames of beams, are left out.
    """

    time: float
    load_case: str
    axes: tuple[str, ...]
    local_axes: tuple[str, ...]
    rows: tuple[tuple[str, str, str, NDArray[np.float64], NDArray[np.float64]], ...]
    supports: tuple[tuple[str, NDArray[np.float64]], ...]
    pose: str = ""


def joints(
    run: RunResult,
    *,
    member: str | None = None,
    node: str | None = None,
    axis: str | None = None,
    time: float | None = None,
    case: str | None = None,
) -> Page:
    """The force on every member at both its ends, in global and member axes, and on every support (a `JointForces`).

    Parameters
    ----------
    member, node, axis : only this one. time : the nearest sample, s; by default that of the largest member force.
    case : load case; by default the first.

    Raises
    ------
    InputError : a name that is not in the model, or a run without forces.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.joints(kt.run(model), member="coupler", time=0.5)
    >>> [line.split()[:3] for line in page.text.splitlines()[2:]]
    [['member', 'end', 'node'], ['coupler', 'A', 'B'], ['coupler', 'B', 'C']]
    """
    check_histories(run)
    if not run.forces:
        raise InputError("The run has no forces: its analysis is kinematics.follow. Do a run of dynamics.inverse.")
    case = next(iter(run.forces)) if case is None else case
    whole = run.model.whole
    for what, name, known in (
        ("load case", case, run.forces),
        ("member", member, whole.members),
        ("node", node, whole.nodes),
        ("axis", axis, "xyz"[: run.model.dim]),
    ):
        if name is not None and name not in known:
            raise InputError(f"No {what} called {name!r}. There are: {', '.join(known)}.")
    data = run.forces[case].whole
    at = _instant(data, time)
    axes = [str(a) for a in data["axis"].values]
    shown = [axes.index(axis)] if axis else list(range(len(axes)))
    force = data["joint_force"].isel(time=at).values
    dim = run.model.dim
    frames = local_axes(compile(run.model), run.motion.whole["position"].values[at : at + 1])[0, :, :dim, :dim]
    rows = [
        (name, end, bar.ends[e], force[i, e, shown], frames[i] @ force[i, e])
        for i, (name, bar) in enumerate({**whole.members, **run.model.members}.items())
        for e, end in enumerate("AB")
        if node in (None, bar.ends[e]) and (name == member or (member is None and name in run.model.members))
    ]
    reaction = zip(map(str, data["support"].values), data["reaction"].values[at], strict=True)
    supports = [(name, force[shown]) for name, force in reaction if member is None and node in (None, name)]
    found = JointForces(
        time=float(data["time"].values[at]),
        pose=pose_at(run.forces[case], at),
        load_case=case,
        axes=tuple(axes[k] for k in shown),
        rows=tuple(rows),
        local_axes=("axial", "shear_2", "shear_3")[: len(axes)],
        supports=tuple(supports),
    )
    return Page(found=found, as_record=_joint_record, as_entries=_joint_entries)


def _instant(data: Any, time: float | None) -> int:
    if time is None:
        return int(np.argmax(np.max(np.abs(data["member_force"].values), axis=1, initial=0.0)))
    if not math.isfinite(time):
        raise InputError(f"time is {time}. Give a finite number of seconds.")
    return int(np.argmin(np.abs(data["time"].values - time)))


def _joint_entries(found: JointForces) -> Iterator[Entry]:
    """The tables of joints and of supports."""
    when = f"pose {found.pose}" if found.pose else f"t = {instant(found.time)}"
    yield f"{when}, load case {found.load_case}; force on the member from its joint"
    rows = [(m, e, n, *(quantity(x, "N") for x in (*world, *local))) for m, e, n, world, local in found.rows]
    yield Table(("member", "end", "node", *found.axes, *found.local_axes), rows)
    supports = ((n, *(quantity(x, "N") for x in world)) for n, world in found.supports)
    yield Table(("node", *found.axes), supports, "force of the supports on the structure")


def _joint_record(found: JointForces) -> dict[str, Any]:
    """The table as plain data."""
    return {
        "time": found.time,
        "pose": found.pose,
        "load_case": found.load_case,
        "joint_force": [
            {
                "member": m,
                "end": e,
                "node": n,
                "global": dict(zip(found.axes, world.tolist(), strict=True)),
                "member_axes": dict(zip(found.local_axes, local.tolist(), strict=True)),
            }
            for m, e, n, world, local in found.rows
        ],
        "reaction": [{"node": n, "global": dict(zip(found.axes, world.tolist(), strict=True))} for n, world in found.supports],
    }
