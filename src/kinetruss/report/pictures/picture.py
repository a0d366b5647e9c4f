"""A line drawing of a model, a result or a run for print: PNG, SVG or PDF."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant
from kinetruss.errors import InputError
from kinetruss.model import Model, nearest
from kinetruss.report.pictures.draw import SUFFIXES, write
from kinetruss.report.pictures.drawing import drawn
from kinetruss.report.pictures.over_structure import areas, note, of_run, written
from kinetruss.report.pictures.specs import WIDTHS, Colouring
from kinetruss.report.pictures.stands import VIEWS, drawing, projected, shown_at
from kinetruss.results import Forces, Motion, Result, Simulation
from kinetruss.results.records import check_samples
from kinetruss.runs import RunResult
from kinetruss.runs.mission_results import check_histories
from kinetruss.strength.curves import Curves, curves, factor_of, only
from kinetruss.units import parse
from kinetruss.viewer.places import Places
from kinetruss.viewer.scenes import snapshots

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.viewer import Scene

    Array = NDArray[np.float64]


def picture(
    what: Model | Result | RunResult,
    file: str | Path,
    *,
    model: Model | None = None,
    at: Sequence[float | str] | float | str = (),
    colour: str | None = None,
    show: str | None = None,
    case: str | None = None,
    width: str | float = "column",
    view: str = "iso",
    ghost: bool = False,
    paths: Sequence[str] = (),
    loads: bool = True,
    names: bool | None = None,
    title: str = "",
) -> Path:
    """Draw a model, a result or a run, at one or more instants side by side, for print.

    Parameters
    ----------
    file : ``.png`` (300 dots per inch), ``.svg`` or ``.pdf``; in the last two text stays text.
    model : for a motion, forces, a simulation or an equilibrium; models and runs have their own.
    at : instants of a run, s or text with a unit; by default the start. The nearest computed samples are shown.
    colour : ``force``, ``stress`` or ``utilisation``; by default members are coloured by kind. The scale covers the whole
    run.
    show : draw over the structure, to one scale and with the largest values: in the plane ``N``, ``V``, ``M``; in space ``N``,
    ``V2``, ``V3``, ``M2``, ``M3``, ``torque`` (also ``Vy``, ``Vz``, ``My``, ``Mz``, ``T``) in member axes; or
    ``deflection``.
    case : load case, by default the first.
    width : mm, or ``column`` (90 mm), ``page`` (190 mm). view : ``iso``, ``front``, ``side``, ``top``; parallel projection.
    ghost : the start pose in grey. paths : nodes whose path is drawn. loads : arrows of nodal forces. names : of nodes and
    members, by default for up to 24 nodes and 40 members. title : above; journals use a caption instead.

    Raises
    ------
    InputError : an unknown suffix, name, instant or width. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.picture(kt.library.vgt.triangular(), f"{folder}/truss.svg", view="front").name
    'truss.svg'
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: drawings end in {', '.join('.' + one for one in SUFFIXES)}. (Films: kinetruss render)")
    if view not in VIEWS:
        raise InputError(f"No view called {view!r}. {nearest(view, VIEWS)}")
    instants = [parse(one, "time") for one in ([at] if isinstance(at, (int, float, str)) else at)]
    millimetres = width_of(width)
    motion = _motion(what)
    time = np.zeros(1) if motion is None else motion.arrays["time"].values
    frames = _frames(time, instants, timed=motion is not None)
    scene = snapshots(what, model=model, case=case, samples=frames, colour=colour)
    over = [] if show is None else _over(what, model, frames, show, case)
    factor = factor_of(over, scene.header["extent"])
    known = {name: k for k, name in enumerate(scene.header["nodes"]) if k not in scene.header["directors"]}
    for name in paths:
        if name not in known:
            raise InputError(f"No node called {name!r}. {nearest(name, known)}")
    whole = scene.arrays["position"] if motion is None else motion.arrays["position"].values
    members, unique = Places(scene).members, scene.header["not_unique"]
    figure = drawing(
        scene,
        shown_at(
            scene,
            [f"t = {instant(time[k])}" if len(time) > 1 else "" for k in frames],
            view,
            loads=loads,
            names=names,
            over=[(areas(one, factor, view), written(one, factor, view)) for one in over],
        ),
        width=millimetres,
        title=title,
        note=note(over, factor) if over else "",
        colouring=_colouring(scene),
        unsure=[k for k, member in enumerate(members) if colour is not None and scene.header["members"][member] in unique],
        ghost=[projected(line, view) for line in Places(scene, x=whole[0]).lines] if ghost else (),
        ways=[projected(whole[:, known[name]], view) for name in paths],
    )
    write(drawn(figure), path, dots=300)
    return path


def _over(what: Any, model: Model | None, frames: Sequence[int], show: str, case: str | None) -> list[Curves]:
    """The curves of each instant.

    Raises
    ------
    InputError : nothing that has section forces; an unknown quantity.
    """
    if isinstance(what, RunResult):
        return [of_run(what, show, case, k) for k in frames]
    forces = what.forces if isinstance(what, Simulation) else what
    if not isinstance(forces, Forces) or model is None:
        raise InputError(
            f"{show} cannot be drawn of a {type(what).__name__}. Give a run with forces, or forces with their model."
        )
    return [curves(model, only(forces, k), show) for k in frames]


def _motion(what: Any) -> Motion | None:
    """The motion of a run or a result, or None of what stands still; without a sample it is refused."""
    if isinstance(what, RunResult):
        check_histories(what)
        return what.motion
    motion = what.motion if isinstance(what, (Simulation, Forces)) else what
    if not isinstance(motion, Motion):
        return None
    check_samples(motion)
    return motion


def _colouring(scene: Scene) -> Colouring | None:
    """The colours of the channel of a scene, and what the marks of members without a value mean."""
    if not scene.header["channels"]:
        return None
    (channel,) = scene.header["channels"]
    notes = []
    if channel["id"] == "utilisation" and channel["largest"] > 1:
        notes.append("red: over capacity")
    if channel["gaps"] and channel["id"] != "stress":
        notes.append("grey, broken: not checked" if channel["id"] == "utilisation" else "grey, broken: not known")
    return Colouring(
        label=channel["label"],
        unit=channel["unit"],
        words=(channel["low"], channel["high"]),
        limits=tuple(channel["limits"]),
        diverging=channel["scale"] == "diverging",
        missing="; ".join(notes),
    )


def width_of(width: str | float) -> float:
    """A width in mm.

    Raises
    ------
    InputError : no such name; less than 30 mm or more than 1000 mm.
    """
    if isinstance(width, str):
        if width not in WIDTHS:
            raise InputError(f"No width called {width!r}: give {' or '.join(WIDTHS)}, or millimetres.")
        return WIDTHS[width]
    if not 30 <= width <= 1000:
        raise InputError(f"width {width:g} mm: give 30 to 1000 mm.")
    return float(width)


def _frames(time: Array, instants: Sequence[float], *, timed: bool) -> list[int]:
    apart = 1e-9 * float(time[-1] - time[0])
    for at in instants:
        if not timed:
            raise InputError("A model at rest has no instants. Give a run or a motion, or omit `at`.")
        if not time[0] - apart <= at <= time[-1] + apart:
            raise InputError(f"at={at:g} s: the run goes from {time[0]:g} to {time[-1]:g} s.")
    return [int(np.abs(time - at).argmin()) for at in instants] or [0]
