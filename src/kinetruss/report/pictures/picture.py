"""A line drawing of a model, a result or a run for print: its data, and the picture in PNG, SVG or PDF."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant, limits_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.mechanics.continua import body_faces, skin_of
from kinetruss.model import AngleDrive, Bar, HingeDrive, Model, nearest
from kinetruss.model.beam_frames import FRAME, shown_kinds, shown_names
from kinetruss.report.pictures.draw import SUFFIXES
from kinetruss.report.pictures.drawing import MEMBERS, VIEWS, eye, names_of, projected
from kinetruss.report.pictures.specs import WIDTHS, Colouring, Drawing, Stand
from kinetruss.results import Forces, Motion, Result, Simulation
from kinetruss.results.records import check_samples
from kinetruss.runs import RunResult
from kinetruss.runs.mission_results import check_histories
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


LONGEST, LEAST = 0.16, 0.01
"""Length of the longest arrow of all times, and below which none is drawn, as fractions of the structure."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Pictured:
    """time (t,), s; position (t, n, dim), m; forces by load case; member_force (members,), N, of a state at rest."""

    model: Model
    time: Array
    position: Array
    forces: Mapping[str, Forces] = field(default_factory=dict)
    member_force: Array | None = None
    not_unique: tuple[str, ...] = ()


def pictured(what: Any, model: Model | None = None) -> Pictured:
    """The data of a model or a run; or of a motion, forces, a simulation or an equilibrium with its model.

    Raises
    ------
    InputError : something else, a result without its model, or a run without a good sample.
    """
    if isinstance(what, Model):
        return Pictured(model=what, time=np.zeros(1), position=_standing(what)[None])
    if isinstance(what, RunResult):
        check_histories(what)
        return _moving(what.model, what.motion, what.forces)
    if isinstance(what, Simulation):
        what = what.forces
    rest = isinstance(what, Result) and {"position", "member_force"} <= set(what.data) and what.data["position"].ndim == 2
    if not rest and not isinstance(what, (Motion, Forces)):
        raise InputError(f"A {type(what).__name__} cannot be drawn. Give a model, a motion, forces, an equilibrium or a run.")
    if model is None:
        raise InputError(f"A {type(what).__name__} alone has no bars. Give its model too: model=...")
    if rest:
        from kinetruss.strength.beam_verdict import middle_forces

        position, force = what.data["position"].values, middle_forces(model, what)
        return Pictured(model=model, time=np.zeros(1), position=position[None], member_force=force)
    check_samples(what)
    if isinstance(what, Forces):
        return _moving(model, what.motion, {what.load_case: what})
    return _moving(model, what, {})


def _moving(model: Model, motion: Motion, forces: Mapping[str, Forces]) -> Pictured:
    names = dict.fromkeys(name for one in forces.values() for name in one.data.attrs.get("not_unique", []))
    data = motion.data
    return Pictured(
        model=model,
        time=data["time"].values,
        position=data["position"].values,
        forces=forces,
        not_unique=tuple(map(str, names)),
    )


def arrows(
    model: Model, time: Array, position: Array, case: str | None, frames: Sequence[int]
) -> list[list[tuple[Array, Array]]]:
    """Start and end of the arrow of each load, m, at some samples; nodes at position (times, n, dim)."""
    from kinetruss.mechanics import compile
    from kinetruss.mechanics.loads import case_loads

    found = case_loads(compile(model), time, case if case in model.load_cases else None, rotating=True)
    force = found.force[:, :, : model.dim]
    size = float(np.linalg.norm(np.ptp(position.reshape(-1, model.dim), axis=0)))
    largest = float(np.linalg.norm(force, axis=2).max(initial=0.0))
    along = force * (LONGEST * size / largest if largest else 0.0)
    return [
        [(x[n], x[n] + one) for n, one in zip(found.node, vectors, strict=True) if np.linalg.norm(one) > LEAST * size]
        for x, vectors in ((position[k], along[k]) for k in frames)
    ]


def curves_of(model: Model, x: Array) -> dict[int, Array]:
    """By place among the members that are drawn the points (g, dim), m, of elastic beams with nodes at x (n, dim)."""
    from kinetruss.mechanics import compile
    from kinetruss.mechanics.beam_forces import beam_curves

    if not model.beams or (found := beam_curves(compile(model))) is None:
        return {}
    drawn = np.cumsum([kind != FRAME for kind in shown_kinds(model).values()]) - 1
    return {int(drawn[member]): points for member, points in zip(found.member, found.at(x), strict=True)}


def _standing(model: Model) -> Array:
    from kinetruss.kinematics import assemble

    try:
        return assemble(model)
    except (AnalysisError, InputError):
        return np.array([node.at for node in model.nodes.values()], float)


# A line drawing of a model or a run for print: PNG, SVG, PDF.

COLOURED = {
    "force": ("Axial force", "N", ("compression", "tension")),
    "stress": ("Stress", "Pa", ("none", "largest")),
    "utilisation": ("Utilisation", "%", ("unused", "full at 100 %")),
}
"""Quantities that colour members: label, unit, labels at the ends of the scale."""
NAMES = 24
"""Number of nodes up to which names are shown by default."""


def picture(
    what: Model | Result | RunResult,
    file: str | Path,
    *,
    model: Model | None = None,
    at: Sequence[float | str] | float | str = (),
    colour: str | None = None,
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
    run. case : load case, by default the first.
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
    shown = pictured(what, model)
    model, time, position = shown.model, shown.time, shown.position
    instants = [parse(one, "time") for one in ([at] if isinstance(at, (int, float, str)) else at)]
    colouring, values = _coloured(shown, colour, case)
    frames = _frames(time, instants, timed=bool(shown.forces) or len(time) > 1)
    # nodes and bars of the frames of beams are left out
    seen = np.array([not node.director for node in model.nodes.values()], bool)
    index = {name: k for k, name in enumerate(name for name, node in model.nodes.items() if not node.director)}
    kinds = {name: kind for name, kind in _kinds(model).items() if kind != FRAME}
    position = position[:, seen]
    figure = Drawing(
        title=title,
        width=width_of(width),
        nodes=tuple(index),
        ends=tuple((index[one.ends[0]], index[one.ends[1]]) for one in map(model.members.__getitem__, kinds)),
        kinds=tuple(kinds.values()),
        joined=_joined(model, index),
        held=tuple(index[node] for node, axes in model.fixed.items() if len(axes) == model.dim and node in index),
        guided=tuple(index[node] for node, axes in model.fixed.items() if len(axes) < model.dim and node in index),
        stands=tuple(_stands(shown, frames, case, values, view, loads, colour)),
        colouring=colouring,
        unsure=tuple(k for k, name in enumerate(kinds) if colour is not None and name in shown.not_unique),
        ghost=projected(position[0], view) if ghost else None,
        ways=tuple(projected(position[:, index[_known(name, index)]], view) for name in paths),
        names=len(index) <= NAMES if names is None else names,
        members=names_of(len(kinds), MEMBERS, names, map(shown_names(model).__getitem__, kinds)),
    )
    from kinetruss.report.pictures.draw import write
    from kinetruss.report.pictures.drawing import drawn

    write(drawn(figure), path, dots=300)
    return path


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


def _coloured(what: Pictured, colour: str | None, case: str | None) -> tuple[Colouring | None, Array | None]:
    """The colour quantity of members, and its values (times, members that are drawn)."""
    if (colour is not None or case is not None) and not what.forces and what.member_force is None:
        raise InputError("There are no forces to colour by. Give a run, forces or an equilibrium.")
    if case is not None and case not in what.forces:
        raise InputError(f"No load case called {case!r}. {nearest(case, what.forces)}")
    if colour is None:
        return None, None
    if colour not in COLOURED:
        raise InputError(f"No colour called {colour!r}. {nearest(colour, COLOURED)}")
    values, faces = _values(what, colour, case)
    drawn = [kind != FRAME for kind in shown_kinds(what.model).values()]
    values = np.asarray(values)[:, drawn]
    label, unit, words = COLOURED[colour]
    several = np.concatenate([values.ravel(), np.zeros(0) if faces is None else faces.ravel()])
    limits = limits_of({"force": "diverging", "stress": "sequential", "utilisation": "capacity"}[colour], several)
    if colour == "stress" or not np.isnan(values).any():
        missing = ""
    else:
        missing = "grey, broken: not checked" if colour == "utilisation" else "grey, broken: not known"
    if colour == "utilisation" and np.nanmax(values, initial=0.0) > 1:
        missing = "; ".join(filter(None, ["red: over capacity", missing]))
    found = Colouring(label=label, unit=unit, words=words, limits=limits, diverging=colour == "force", missing=missing)
    return found, values


def _values(what: Pictured, colour: str, case: str | None) -> tuple[Array, Array | None]:
    """Values (times, members) of the colour quantity, and for stress those of faces."""
    if what.member_force is not None:
        if colour != "force":
            raise InputError(f"There is no {colour} of a state at rest. Colour it by force.")
        return np.asarray(what.member_force, float)[None], None
    from kinetruss.strength.beam_verdict import middle_forces
    from kinetruss.strength.verdict import strength_histories

    forces = what.forces[case or next(iter(what.forces))]
    if colour == "force":
        return middle_forces(what.model, forces), None

    found = strength_histories(what.model, forces)
    faces = _stress(what.model, what.position) if colour == "stress" else None
    if colour not in found and faces is None:
        raise InputError(f"There is no {colour}: it needs a section and a material. Add them to the model.")
    return found.get(colour, np.full((len(what.time), len(what.model.members)), np.nan)), faces


def _stands(
    what: Pictured, frames: Sequence[int], case: str | None, values: Array | None, view: str, loads: bool, colour: str | None
) -> Iterator[Stand]:
    model, time, position = what.model, what.time, what.position
    first = next(iter(what.forces), None) if case is None else case
    pairs = arrows(model, time, position, first, frames) if loads else [[]] * len(frames)
    skin = skin_of(model)
    seen = np.array([not node.director for node in model.nodes.values()], bool)
    stress = _stress(model, position) if colour == "stress" else None
    for k, some in zip(frames, pairs, strict=True):
        x = position[k]
        faces, light, order = _lit(skin.nodes, x, view)
        yield Stand(
            faces=faces,
            light=light,
            hinges=projected(_hinges(model, x), view),
            face_values=None if stress is None else stress[k][order],
            caption=f"t = {instant(time[k])}" if len(time) > 1 else "",
            points=projected(x[seen], view),
            curves={member: projected(points, view) for member, points in curves_of(model, x).items()},
            values=None if values is None else values[k],
            bodies=projected(_bodies(model, x), view),
            loads=tuple((projected(start, view), projected(end, view)) for start, end in some),
        )


def _bodies(model: Model, x: Array) -> Array:
    """Corners (k, 3, dim): of planar bodies the ends of the bar and the centre of mass, of others their hull."""
    index = {name: k for k, name in enumerate(model.nodes)}
    found = []
    for bar in model.bars.values():
        if isinstance(bar, Bar) and bar.body is not None and model.dim == 2:
            p, q = (x[index[end]] for end in bar.ends)
            u = (q - p) / np.linalg.norm(q - p)
            e, f = bar.body.center
            found.append([p, q, p + e * u + f * np.array([-u[1], u[0]])])
    start = np.array([node.at for node in model.nodes.values()], float)
    found += list(x[np.array(body_faces(model, start), int).reshape(-1, 3)])
    return np.array(found, float).reshape(-1, 3, model.dim)


def _lit(nodes: NDArray[np.int64], x: Array, view: str) -> tuple[Array, Array, NDArray[np.int64]]:
    """Faces (f, 3, 2) on paper, from back to front; their brightness (f,), 0 to 1; and their order."""
    corners = x[nodes]
    if x.shape[1] == 2 or not len(nodes):
        return projected(corners, view), np.ones(len(nodes)), np.arange(len(nodes))
    toward = eye(view)
    order = np.argsort(corners.mean(axis=1) @ toward)
    corners = corners[order]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normal, axis=1)
    return projected(corners, view), np.abs(normal @ toward) / np.where(size > 0, size, 1.0), order


def _stress(model: Model, position: Array) -> Array | None:
    """Von Mises stress (times, f) at the faces of membranes and solids."""
    from kinetruss.strength.element_stresses import skin_stress

    return skin_stress(model, skin_of(model), position)


def _hinges(model: Model, x: Array) -> Array:
    """Places (h, dim) of motors that turn: midpoints of the axes of hinge drives, first ends of bars whose angle is driven."""
    index, drives = {name: k for k, name in enumerate(model.nodes)}, model.all_drives.values()
    places = [drive.axis for drive in drives if isinstance(drive, HingeDrive)]
    places += [model.members[drive.bar].ends[:1] for drive in drives if isinstance(drive, AngleDrive)]
    return np.array([x[[index[one] for one in nodes]].mean(axis=0) for nodes in places]).reshape(-1, model.dim)


def _joined(model: Model, index: dict[str, int]) -> tuple[int, ...]:
    """Nodes of members and bodies: all except those of meshes only."""
    given = [*(one.ends for one in model.members.values()), *(one.nodes for one in model.bodies.values())]
    return tuple(sorted({index[node] for nodes in given for node in nodes if node in index}))


def _kinds(model: Model) -> dict[str, str]:
    turned = {getattr(drive, "bar", None) for drive in model.all_drives.values()}
    return {name: "driven" if kind != "active" and name in turned else kind for name, kind in shown_kinds(model).items()}


def _known(name: str, index: dict[str, int]) -> str:
    if name not in index:
        raise InputError(f"No node called {name!r}. {nearest(name, index)}")
    return name
