"""Quantities over time, and maps of a workspace, as pictures."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure as Canvas

from kinetruss.display import COLOURS, scale
from kinetruss.display.ranks import largest_first, order_of
from kinetruss.errors import InputError
from kinetruss.model import nearest
from kinetruss.report.comparisons import run_labels
from kinetruss.report.pictures.draw import SCREEN, SUFFIXES, draw, write
from kinetruss.report.pictures.picture import width_of
from kinetruss.report.pictures.quantities import COMPONENTS, Curve, curves, quantities
from kinetruss.report.pictures.specs import RC, Histories, Panel

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.results import Result
    from kinetruss.runs import RunResult


QUANTITIES = {
    "reach": "what stops the pose",
    "stroke": "share of the stroke used",
    "serial": "smallest singular value of the task (0: border of the workspace)",
    "parallel": "smallest singular value, drives held (0: singular)",
    "conditioning": "smallest over largest singular value, drives held",
    "drive_position": "drive position, m or rad",
}


def map_picture(workspace: xr.Dataset, file: str | Path, quantity: str = "reach", drive: str | None = None) -> Path:
    """Draw a map of a workspace.

    Parameters
    ----------
    workspace : from `kinematics.workspace`, over two axes. file : ``.png``, ``.svg`` or ``.pdf``.
    quantity : ``reach`` (free, or the limit that stops the pose), ``stroke``, ``serial``, ``parallel``, ``conditioning`` or
        ``drive_position``.
    drive : of ``stroke`` and ``drive_position``; by default the stroke of the drive that is nearest to one of its limits.

    Raises
    ------
    InputError : an unknown quantity, drive or suffix. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> bay = kt.library.vgt.double_octahedral(limits=(0.9, 1.6))
    >>> tilts = [-0.2, 0.0, 0.2]  # rad
    >>> found = kt.kinematics.workspace(bay, "bay", ("bay.beta", tilts), ("bay.gamma", tilts))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.map_picture(found, f"{folder}/reach.svg").name
    'reach.svg'
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: pictures end in {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    if quantity not in QUANTITIES:
        raise InputError(f"No map of {quantity!r}. {nearest(quantity, QUANTITIES)}")
    if len(axes := [str(name) for name in workspace["reachable"].dims]) != 2:
        raise InputError(f"The map has the axes {', '.join(axes)}. Draw one slice of it, e.g. found.isel({{{axes[0]!r}: 0}}).")
    values, names = _values(workspace, quantity, drive)
    with mpl.rc_context(RC):
        write(_drawn(workspace, values, names, f"{QUANTITIES[quantity]}{f': {drive}' if drive else ''}"), path)
    return path


def _values(data: xr.Dataset, quantity: str, drive: str | None) -> tuple[NDArray[np.float64], list[str]]:
    """Numbers of the map (along, across), NaN where there are none; of the reach the words that the numbers count."""
    if quantity == "reach":
        words = data["limit"].values
        names = ["free", *sorted({str(one) for one in words.flat} - {""})]
        return np.vectorize(lambda word: float(names.index(str(word) or "free")), otypes=[float])(words), names
    if quantity not in ("stroke", "drive_position"):
        return np.asarray(data[quantity].values, float), []
    drives = [str(one) for one in data["drive"].values]
    if drive is not None and drive not in drives:
        raise InputError(f"No drive called {drive!r}. {nearest(drive, drives)}")
    if drive is not None:
        return np.asarray(data[quantity].sel(drive=drive).values, float), []
    if quantity == "drive_position":
        raise InputError(f"Name the drive, one of {', '.join(drives[:6])}.")
    share = data["stroke"].values
    if np.isnan(share).all():
        raise InputError("No drive has limits, so there is no stroke. Give limits to the active members, or to workspace(...).")
    off = np.where(np.isnan(share), -1.0, np.abs(share - 0.5))
    found: NDArray[np.float64] = np.take_along_axis(share, off.argmax(axis=2)[..., None], axis=2)[..., 0]
    return found, []


def _drawn(data: xr.Dataset, values: NDArray[np.float64], names: list[str], title: str) -> Canvas:
    along, across = (str(name) for name in data["reachable"].dims)
    canvas = Canvas(figsize=(6.4, 5.2), layout="constrained")
    FigureCanvasAgg(canvas)
    axes: Any = canvas.subplots()
    options: dict[str, Any] = {"shading": "nearest", "rasterized": True}
    if names:
        colours = ["#e8f1e4", *(COLOURS[k % len(COLOURS)] for k in range(len(names) - 1))]
        options |= {"cmap": ListedColormap(colours), "vmin": -0.5, "vmax": len(names) - 0.5}
    (x, of_x), (y, of_y) = (scale(1.0, data[name].attrs["units"]) for name in (across, along))
    mesh = axes.pcolormesh(data[across].values * x, data[along].values * y, values, **options)
    bar = canvas.colorbar(mesh, ax=axes, ticks=range(len(names)) if names else None)
    if names:
        bar.ax.set_yticklabels(names)
    if of_x == of_y:
        axes.set_aspect("equal")
    axes.set_xlabel(f"{across}, {of_x}")
    axes.set_ylabel(f"{along}, {of_y}")
    axes.set_title(title[:1].upper() + title[1:])
    return canvas


# The curves of one result as SVG: for notebooks, which show a result without its run.

SHOWN = {
    "member_force": "member force",
    "drive_force": "drive force",
    "drive_position": "drive position",
    "position": "position",
    "utilisation": "utilisation",
    "current": "current",
}
"""Histories that a result is drawn by -> their words; the first that it has, and drives below members."""
CURVES = 6


def histories_svg(result: Result) -> str | None:
    """The most important histories of a result as an SVG picture; None without histories.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.mechanisms.four_bar()
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 1.0}, duration=0.5), samples=3)
    >>> histories_svg(motion)[:5]
    '<?xml'
    """
    data = result.arrays
    time = data["time"].values if "time" in data else np.zeros(0)
    if len(time) < 2 or "pose" in data:
        return None
    panels = tuple(panel for name in SHOWN if (panel := _panel_of_result(result, name)) is not None)[:2]
    if not panels:
        return None
    from kinetruss.report.pictures.draw import draw

    held = io.StringIO()
    figure = draw(Histories(name="histories", title="", time=time, panels=panels))
    figure.savefig(held, format="svg", metadata={"Date": None})
    return held.getvalue()


def _panel_of_result(result: Result, name: str) -> Panel | None:
    """The curves with the largest values of one quantity; None if the result does not have it along time."""
    if name not in result.arrays or result.arrays[name].dims[:1] != ("time",) or not result.arrays[name].values.size:
        return None
    from kinetruss.results.wide_tables import flat, labels, units_of

    array: Any = result.whole[name]
    values = np.asarray(flat(array), float)
    size = np.nan_to_num(np.abs(values)).max(axis=0)
    moving = np.ptp(np.nan_to_num(values), axis=0) > 0 if name == "position" else size > 0
    if not moving.any():
        return None
    chosen = sorted(order_of(np.where(moving, size, -1))[: min(CURVES, int(moving.sum()))])
    own = list(units_of(array))
    # of drives with other units, those of the first
    chosen = [k for k in chosen if own[k] == own[chosen[0]]]
    factor, unit = scale(float(size[chosen].max()), own[chosen[0]])
    names = list(labels(array))
    return Panel(quantity=SHOWN[name], unit=unit, lines={" ".join(names[k]): factor * values[:, k] for k in chosen})


# Quantities of one or more runs over time.

MOST = 14
"""Largest number of curves in one panel that can be distinguished."""

LIMITS = {"motor_torque": "max_torque", "current": "max_current", "voltage": "max_voltage", "motor_speed": "max_speed"}


def plot(
    runs: RunResult | Sequence[RunResult],
    quantity: str | Sequence[str],
    file: str | Path,
    *,
    members: Sequence[str] = (),
    case: str | None = None,
    station: float | None = None,
    width: str | float | None = None,
) -> Path:
    """Draw quantities over time, for one run or several in the same picture; dashed: the same poses at rest.

    Parameters
    ----------
    runs : one or several.
    quantity : a result by name, e.g. ``von_mises``, ``member_force``, ``drive_position``, ``current``; several give panels
    above each other, as do ``motion``, ``components`` and ``drive``.
    file : ``.png``, ``.svg`` or ``.pdf``.
    members : members, nodes, drives or supports to show; by default those with the largest values.
    case : load case; by default the first.
    station : fraction of a member's length from its end towards A, for stresses and section forces; by default stresses
        take their largest value along the member, signed ones the station where they are largest.
    width : mm, or ``column`` (90 mm), ``page`` (190 mm): for print, with letters of 7 and 8 points, the legend below and no
        title; by default for a screen.

    Raises
    ------
    InputError : a name that no run has (the message offers the nearest), or an unknown suffix.
    StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.plot([kt.run(model)], "member_force", f"{folder}/forces.svg", members=["coupler"]).name
    'forces.svg'
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: pictures end in {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    figure = specification(runs if isinstance(runs, Sequence) else [runs], quantity, members, case, station)
    if width is not None:
        figure = replace(figure, width=width_of(width))
    write(draw(figure), path, dots=SCREEN if width is None else 300)
    return path


def plot_node(run: RunResult, nodes: Sequence[str], folder: str | Path, formats: Sequence[str] = ("png", "svg")) -> list[Path]:
    """Draw where nodes go: their paths with the mechanism at the start, and position, speed and acceleration over time.

    Parameters
    ----------
    folder : made if needed, for ``path_NODE.FORMAT`` and ``motion_NODE.FORMAT``. formats : of ``png``, ``svg``, ``pdf``.

    Raises
    ------
    InputError : unknown nodes; a run that has no motion over time. StoreError : the folder cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> run = kt.run(kt.read(kt.library.example_files()["wiper"][0]))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     [path.name for path in kt.report.plot_node(run, ["T"], folder, formats=["svg"])]
    ['path_T.svg', 'motion_T.svg']
    """
    from kinetruss.report.mechanism_data import node_paths
    from kinetruss.report.mechanism_figures import path_figure, speed_figure
    from kinetruss.report.pictures.draw import save

    node_paths(run, nodes)  # refuses unknown nodes, and runs without a motion
    name = "_".join(nodes)
    drawn = path_figure(run, nodes, f"path_{name}"), speed_figure(run, nodes, f"motion_{name}", places=True)
    return save(drawn, Path(folder), formats)


def specification(
    runs: Sequence[RunResult],
    quantity: str | Sequence[str],
    members: Sequence[str] = (),
    case: str | None = None,
    station: float | None = None,
) -> Histories:
    """The specification of `plot`. Curves keep their own times; the axis covers the longest."""
    wanted = quantities([quantity] if isinstance(quantity, str) else quantity)
    labels = run_labels(runs)
    panels, shown = [], []
    for name in wanted:
        try:
            found = [curves(run, name, members, case, station) for run in runs]
        except InputError:
            if name in COMPONENTS and len(wanted) > 1 and name != COMPONENTS[0]:
                continue  # in the plane there are three of the five components
            raise
        shown.append([_largest(one, len(runs)) for one in found])
        panels.append(_panel(runs, labels, name, shown[-1]))
    longest = max((one.time for group in shown for found in group for one in found), key=lambda time: float(time[-1]))
    return Histories(name="_".join(wanted), title=_title(runs, wanted, shown), time=longest, panels=tuple(panels))


def _panel(runs: Sequence[RunResult], labels: Sequence[str], name: str, found: Sequence[Sequence[Curve]]) -> Panel:
    alone = _of(found) is not None
    lines: dict[str, Any] = {}
    dashed: dict[str, Any] = {}
    times: dict[str, Any] = {}
    for run_label, group in zip(labels, found, strict=True):
        for one in group:
            label = _label(run_label, one.of, len(runs) > 1, alone)
            lines[label], times[label] = one.values, one.time
            if one.static is not None:
                dashed[label] = one.static
    return Panel(
        quantity=name.replace("_", " ").replace("mises", "Mises"),
        unit=found[0][0].unit,
        lines=lines,
        dashed=dashed,
        times=times,
        limit=_limit(runs, name, {one.of for group in found for one in group}),
    )


def _label(run: str, of: str, several: bool, alone: bool) -> str:
    if several:
        return run if alone else f"{run}: {of}"
    return of or run


def _title(runs: Sequence[RunResult], wanted: Sequence[str], found: Sequence[Sequence[Sequence[Curve]]]) -> str:
    """The quantity, and its subject if all panels have the same."""
    names = {_of(group) for group in found}
    of = next(iter(names)) if len(names) == 1 else None
    titles = {run.model.title or run.name for run in runs}
    what = found[0][0][0].words[:1].upper() + found[0][0][0].words[1:] if len(wanted) == 1 else ""
    title = next(iter(titles)) if len(titles) == 1 and not (what and of) else ""
    parts = [what or title, of or "", title if what else ""]
    return ": ".join(part for part in parts if part)


def _of(found: Sequence[Sequence[Curve]]) -> str | None:
    """The subject of all curves, if they have the same."""
    names = {one.of for group in found for one in group}
    return next(iter(names)) if len(names) == 1 else None


def _largest(found: list[Curve], runs: int) -> list[Curve]:
    """The largest curves, as many as can be distinguished, in their original order."""
    most = max(1, MOST // runs)
    if len(found) <= most:
        return found
    ranked = largest_first(found, lambda one: float(abs(one.values).max(initial=0)))[:most]
    return [one for one in found if one in ranked]


def _limit(runs: Sequence[RunResult], name: str, members: set[str]) -> float | None:
    """The limit of the motors shown, if it is the same for all."""
    if name not in LIMITS:
        return None
    found = set()
    for run in runs:
        for member in members & set(run.model.actuators):
            motor = run.model.actuators[member].motor
            record = run.model.motors[motor] if isinstance(motor, str) else motor
            found.add(None if record is None else getattr(record, LIMITS[name]))
    return found.pop() if len(found) == 1 else None
