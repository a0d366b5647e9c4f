"""Forces of single poses at rest, without any motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.dynamics.prescribed import at_rest
from kinetruss.errors import AnalysisError, InputError, ModelError
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics import from_arrays, sample
from kinetruss.kinematics.motions import Course, motion_of
from kinetruss.kinematics.positions import assembled
from kinetruss.kinematics.sampling import start_values
from kinetruss.mechanics import System, arrange, cached, compile
from kinetruss.mechanics.arguments import number_of, refuse_without_inner
from kinetruss.mechanics.beam_shapes import shaped
from kinetruss.mechanics.positions import row_values, shortest
from kinetruss.model import Model, Quintic, trajectory_faults
from kinetruss.results import Forces, Motion, Result, Status, variable
from kinetruss.statics.small_displacements import Weight, loads_at, weight_word
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray


EPS = float(np.finfo(float).eps)

SAME = 4 * EPS
"""Relative difference up to which a value counts as that of the model."""


@one_thread
def at_poses(
    model: Model,
    poses: Any,
    weight: Weight = True,
    load_case: str | None = None,
    *,
    time: float = 0.0,
) -> Forces:
    """Member forces, reactions and drive forces of poses at rest.

    Parameters
    ----------
    poses : a sequence of mappings from drives or pose coordinates to values (``[{"bay.beta": 0.1}, {"M7": "1.2 m"}]``; what is
        not named stands as in the model), or a mapping from names to such mappings (``{"stowed": {...}, "open": {...}}``), or
        one mapping alone; or an array of drive values (poses, drives), m or rad, in the order of ``model.all_drives``; or an
        array of node positions (poses, n_nodes, dim), m, or the result that has them.
    weight : True: members and lumped masses weigh; ``"lumped"``: massless members; False: nothing weighs.
    load_case : name; None takes all loads of the model with factor 1. Loads in time are taken at `time`, s.

    Returns
    -------
    Forces, as from `dynamics.inverse`, for the same uses (``strength.check``, ``strength.sections``, ...). The dimension
    is ``time`` there too, but counts poses: 0, 1, 2, ...; the coordinate ``pose`` beside it holds their names, so that
    ``forces.member_force.sel(pose="open")`` selects one.

    Raises
    ------
    InputError : an unknown coordinate, or one of another kind; a wrong shape; drives that contradict each other or leave
        freedoms.
    AnalysisError : a pose that cannot be reached; ``error.result`` is the Forces of the poses before it, or None.

    Notes
    -----
    Each pose is reached separately from the model's own configuration, by step-limited continuation, so that it does not
    depend on other poses or their order. Forces as in `dynamics.inverse` with v = a = 0, the weight of members included by
    their equivalent end forces.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(tip_force=(0, -98.1))
    >>> forces = kt.statics.at_poses(model, [{"actuator": 2.5}, {"actuator": 3.0}], weight=False)
    >>> forces.member_force.sel(member="actuator").values.round(4).tolist()
    [-27.49, 18.5392]
    """
    system = compile(model)
    word, load_time = weight_word(weight), number_of(time, "time", "s")
    names, given = _listed(system, poses)
    stopped = ""
    closed: NDArray[np.bool_] | None
    if isinstance(given, np.ndarray) and given.ndim == 3:
        still = np.zeros_like(given)
        motion, closed = from_arrays(model, np.arange(len(given), dtype=float), given, still, still), None
    else:
        values = given if isinstance(given, np.ndarray) else _drives(model, given)
        motion, closed, stopped = _reached(system, values, names)
    forces = _forces(system, motion, names, load_case, word, load_time, closed) if motion.whole.sizes["time"] else None
    if stopped:
        raise AnalysisError(stopped, forces)
    if forces is None:
        raise InputError("No pose is given. Give one at least.")
    return forces


def _listed(system: System, poses: Any) -> tuple[list[str], Any]:
    """Names of the poses, and a list of mappings or an array (poses, drives) or (poses, nodes, dim)."""
    if isinstance(poses, Result):
        at = poses.whole["position"].values
        return _listed(system, at[None] if at.ndim == 2 else at)
    if isinstance(poses, Mapping):
        if poses and all(isinstance(one, Mapping) for one in poses.values()):
            return [str(name) for name in poses], list(poses.values())
        poses = [poses]
    if isinstance(poses, Sequence) and all(isinstance(one, Mapping) for one in poses):
        return [str(k) for k in range(len(poses))], list(poses)
    if isinstance(poses, Sequence) and any(isinstance(one, Mapping) for one in poses):
        raise InputError("poses are mappings of coordinates to values, or an array of numbers, not a mix of both.")
    refuse_without_inner(system, poses, "position")
    positions = {"poses": None, "n_nodes": system.nodes, "dim": system.dim}
    given = array_of(poses, "poses", {"poses": None, "drives": system.drives}, positions)
    return [str(k) for k in range(len(given))], given


def _drives(model: Model, poses: list[Mapping[str, Any]]) -> NDArray[np.float64]:
    """Drive values (poses, drives) of mappings of drives and pose coordinates."""
    found = np.tile(np.fromiter(start_values(model).values(), float, len(model.all_drives)), (len(poses), 1))
    for i, pose in enumerate(poses):
        if not pose:
            continue
        # a move from a value to itself: names, units and reach are checked as for trajectories
        standing = Quintic(moves={name: (value, value) for name, value in pose.items()}, duration=1.0)
        if faults := list(trajectory_faults(model, standing, ("poses", i))):
            raise ModelError(faults)
        try:
            found[i] = sample(model, standing, [0.0]).value[0]
        except AnalysisError as error:
            raise InputError(f"Pose {i}: {str(error).partition(': ')[2] or error}") from None
    return found


def _reached(system: System, values: NDArray[np.float64], names: list[str]) -> tuple[Motion, NDArray[np.bool_], str]:
    """The poses as a motion at rest, up to the first that cannot be reached; whether they were computed from lengths (poses,);
    and the message for the first that cannot be reached.
    """
    x = np.empty((len(values), system.x0.size))
    good, stopped, moved = len(values), "", np.zeros(len(values), np.bool_)
    solved = shaped(system)
    for i, value in enumerate(values):
        found, share = _geometry(solved, value.tobytes())
        moved[i] = not np.array_equal(found, system.x0)
        if share < 1:
            good = i
            stopped = (
                f"Pose {names[i]!r} cannot be reached: {share:.1%} of the way from the model's own configuration was. "
                "Give values nearer to it."
            )
            break
        _refuse_contradiction(solved, found, _rows(solved, value), names[i])
        x[i] = found.reshape(-1)
    still = np.zeros((good, system.x0.size))
    drives = (values[:good], np.zeros((good, values.shape[1])), np.zeros((good, values.shape[1])))
    course = Course(t=np.arange(good, dtype=float), x=x[:good], v=still, a=still, drive=drives)
    motion = motion_of(system, course, "poses", Status.COMPLETED, "")
    return motion, moved[:good], stopped


@cached(256)
def _geometry(system: System, value: bytes) -> tuple[NDArray[np.float64], float]:
    """Positions (n, 3) at drive values, and the fraction of the way that was reached: the same for every load case.

    If all values are those of the model, the positions are the model's own: solving again would only add round-off.
    """
    drives = np.frombuffer(value)
    wanted, pushed = _rows(system, drives), drives[system.coordinate_drive[:, 1]]
    away = np.abs(row_values(system, system.x0) - wanted)
    aside = np.abs(system.x0.reshape(-1)[system.coordinate_drive[:, 0]] - pushed)
    if np.all(away <= SAME * np.abs(wanted)) and np.all(aside <= SAME * np.abs(pushed)):
        return system.x0, 1.0
    found, share = assembled(system, wanted, pushed)
    found.setflags(write=False)
    return found, share


def _rows(system: System, value: NDArray[np.float64]) -> NDArray[np.float64]:
    """Prescribed values of the rows at drive values (drives,)."""
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = value[system.row_drive[driven]]
    if np.any(wanted[system.row_kind == LENGTH] <= 0):
        raise InputError("Every length must be greater than 0.")
    return wanted


def _refuse_contradiction(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], name: str) -> None:
    """Refuse redundant rows that contradict the others."""
    for r in arrange(system).redundant:
        miss = abs(row_values(system, x)[r] - wanted[r])
        if system.row_kind[r] == LENGTH and miss > 1e-8 * shortest(system):
            raise InputError(
                f"Pose {name!r}: the drives contradict each other: the others fix {system.part_of(r)!r}, "
                f"which is off by {miss:.3g} m. Drive one of them less."
            )


def _forces(
    system: System,
    motion: Motion,
    names: list[str],
    load_case: str | None,
    word: str,
    time: float,
    closed: NDArray[np.bool_] | None,
) -> Forces:
    """Forces of the poses, the time axis counting them; closed (poses,) : positions that were computed from lengths."""
    count = motion.whole.sizes["time"]
    loads = loads_at(system, np.full(count, time), load_case, word, rotating=True)
    if loads.base is not None and loads.base.turns:
        raise InputError("Poses have no time, so gravity cannot turn with it. Leave out gravity_turns, or give a motion.")
    motion = motion.with_(data=_counted(motion.whole, names[:count]))
    forces = at_rest(system, motion, loads, closed)
    forces.whole.attrs |= {"weight": word, "load_time": time}
    return forces.with_(data=_counted(forces.whole, names[:count]))


def _counted(data: xr.Dataset, names: list[str]) -> xr.Dataset:
    """The dataset with a time axis that counts poses, and with their names as a coordinate."""
    count = variable(("time",), np.arange(len(names), dtype=float), "", "pose")
    label = variable(("time",), np.array(names, dtype=object).astype(str), "", "name of the pose")
    return data.assign_coords(time=count, pose=label).set_xindex("pose")
