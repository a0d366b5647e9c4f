"""A model or a run into a file of another program; the suffix says which."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.exchange.robots import LeftOut
from kinetruss.exchange.tables_out import not_carried
from kinetruss.limits import hold
from kinetruss.model import Model
from kinetruss.results.folder import whole_file
from kinetruss.runs.mission_results import check_histories

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.runs import RunResult


MOST_FILES = 100_000
"""Largest number of instants of a PVD."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Written:
    """The files that were written, what of the model they do not have (what, where, why), and drives: their value, rad or m,
    where the joint of the file is at 0.
    """

    files: Sequence[Path]
    left_out: Sequence[LeftOut] = ()
    offsets: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Pose:
    model: Model
    x: NDArray[np.float64]
    vectors: Mapping[str, Any]
    forces: Any


def write(what: Model | RunResult, path: str | Path, *, time: float | None = None, overwrite: bool = False) -> Written:
    """Write a model, or the pose of a run at an instant, for another program.

    Parameters
    ----------
    path : ``.xml`` (MJCF), ``.urdf`` (its closures in ``NAME.closures.yaml``), ``.dxf``, ``.stl``, ``.vtu``, or ``.pvd``
        (all instants of a run, one VTU each, in a folder beside it).
    time : s, of a run: the nearest sample; by default the first. overwrite : replace files that are there.

    Returns
    -------
    Written. A file appears completely or not at all.

    Raises
    ------
    InputError : another suffix; a file that is there; a time without a run, or outside of it; a model that the format cannot
        have; a package of the extra ``exchange`` that is not installed. StoreError : a file that cannot be written.

    Examples
    --------
    >>> from pathlib import Path
    >>> import kinetruss as kt
    >>> found = kt.exchange.write(kt.library.mechanisms.delta(), "delta.xml", overwrite=True)
    >>> Path("delta.xml").read_text().count("<connect")
    5
    >>> Path("delta.xml").unlink()
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise InputError(f"{path} has the suffix {path.suffix!r}. Files that are written: {', '.join(FORMATS)}.")
    if not isinstance(what, Model):
        check_histories(what)
    written = FORMATS[suffix](what, path, time, overwrite)
    model = what if isinstance(what, Model) else what.model
    return replace(written, left_out=(*written.left_out, *not_carried(model, suffix, written.left_out)))


def _free(path: Path, overwrite: bool) -> Path:
    if path.exists() and not overwrite:
        raise InputError(f"{path} is there already. Name another file, or give --overwrite (overwrite=True).")
    return path


def _pose(what: Any, time: float | None) -> _Pose:
    """The model and its nodes at one instant."""
    if isinstance(what, Model):
        if time is not None:
            raise InputError("A model has one pose only. Leave out the time, or give a run.")
        return _at(what, None, None)
    times = what.motion.time.values
    index = 0 if time is None else int(np.argmin(np.abs(times - time)))
    if time is not None and not times[0] - 1e-9 <= time <= times[-1] + 1e-9:
        raise InputError(f"The run has the times {times[0]:g} to {times[-1]:g} s, not {time:g} s. Give one of these.")
    return _at(what.model, what, index)


def _at(model: Model, run: Any, index: int | None) -> _Pose:
    nodes = model.whole.nodes
    x = np.zeros((len(nodes), 3))
    if run is None:
        x[:, : model.dim] = [node.at for node in nodes.values()]
        return _Pose(model=model, x=x, vectors={}, forces=None)
    motion = run.motion
    x[:, : model.dim] = motion.whole["position"].isel(time=index).values
    vectors = {name: motion.whole[name].isel(time=index).values for name in ("velocity", "acceleration")}
    case = next(iter(run.forces.values()), None)
    forces = None if case is None else case.whole["member_force"].isel(time=index).values
    return _Pose(model=model, x=x, vectors=vectors, forces=forces)


def _mjcf(what: Any, path: Path, time: float | None, overwrite: bool) -> Written:
    from kinetruss.exchange.mjcf_out import mjcf_text
    from kinetruss.exchange.of_model import robot_of_model

    pose, target = _pose(what, time), _free(path, overwrite)
    drawn = robot_of_model(pose.model, pose.x)
    text, left = mjcf_text(drawn)
    with whole_file(target) as draft:
        draft.write_text(text, encoding="utf-8")
    return Written(files=(target,), left_out=left, offsets=drawn.offsets)


def _urdf(what: Any, path: Path, time: float | None, overwrite: bool) -> Written:
    from kinetruss.exchange.of_model import robot_of_model
    from kinetruss.exchange.urdf_out import urdf_texts

    pose, target, beside = _pose(what, time), _free(path, overwrite), _free(path.with_suffix(".closures.yaml"), overwrite)
    drawn = robot_of_model(pose.model, pose.x)
    text, closures, left = urdf_texts(drawn)
    with whole_file(target) as one, whole_file(beside) as two:
        one.write_text(text, encoding="utf-8")
        two.write_text(closures, encoding="utf-8")
    return Written(files=(target, beside), left_out=left, offsets=drawn.offsets)


def _dxf(what: Any, path: Path, time: float | None, overwrite: bool) -> Written:
    from kinetruss.exchange.drawings import write_dxf

    pose = _pose(what, time)
    with whole_file(_free(path, overwrite)) as draft:
        left = write_dxf(draft, pose.model, pose.x)
    return Written(files=(path,), left_out=left)


def _stl(what: Any, path: Path, time: float | None, overwrite: bool) -> Written:
    from kinetruss.exchange.meshes import stl_bytes

    pose = _pose(what, time)
    data, left = stl_bytes(pose.model, pose.x)
    with whole_file(_free(path, overwrite)) as draft:
        draft.write_bytes(data)
    return Written(files=(path,), left_out=left)


def _vtu(what: Any, path: Path, time: float | None, overwrite: bool) -> Written:
    from kinetruss.exchange.meshes import write_vtu

    pose = _pose(what, time)
    with whole_file(_free(path, overwrite)) as draft:
        left = write_vtu(draft, pose.model, pose.x, vectors=pose.vectors, forces=pose.forces)
    return Written(files=(path,), left_out=left)


def _pvd(what: Any, path: Path, time: float | None, overwrite: bool) -> Written:
    """Instants first, the collection that names them last."""
    from kinetruss.exchange.meshes import pvd_text, write_vtu

    if isinstance(what, Model) or time is not None:
        raise InputError(f"{path}: a .pvd holds all instants of a run. For one pose write .vtu.")
    times = what.motion.time.values
    hold(len(times), f"{path}", "Run it with fewer samples.", most=MOST_FILES, of="files")
    folder, digits = path.with_suffix(""), len(str(len(times) - 1))
    names = [f"{path.stem}_{k:0{digits}d}.vtu" for k in range(len(times))]
    for target in (path, *(folder / name for name in names)):
        _free(target, overwrite)
    left: list[LeftOut] = []
    for index, name in enumerate(names):
        pose = _at(what.model, what, index)
        with whole_file(folder / name) as draft:
            left = write_vtu(draft, pose.model, pose.x, vectors=pose.vectors, forces=pose.forces)
    with whole_file(path) as draft:
        draft.write_text(pvd_text(times, [f"{folder.name}/{name}" for name in names]), encoding="utf-8")
    return Written(files=(path, *(folder / name for name in names)), left_out=left)


FORMATS: Mapping[str, Callable[[Any, Path, float | None, bool], Written]] = {
    ".xml": _mjcf,
    ".urdf": _urdf,
    ".dxf": _dxf,
    ".stl": _stl,
    ".vtu": _vtu,
    ".pvd": _pvd,
}
"""Suffix -> writer."""
