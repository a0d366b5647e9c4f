"""Maps of a workspace as pictures: what can be reached, strokes, distance from singular positions."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure as Canvas

from kinetruss.display import COLOURS, scale
from kinetruss.errors import InputError
from kinetruss.model import nearest
from kinetruss.report.pictures.draw import SUFFIXES, write
from kinetruss.report.pictures.style import RC

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

__all__ = ["map_picture"]

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
