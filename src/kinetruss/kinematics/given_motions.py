"""Motions from arrays of node histories, and from a node-history table."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from kinetruss.arrays import array_of
from kinetruss.errors import InputError, ModelError, few
from kinetruss.io import NodeHistory, read_history
from kinetruss.io.histories import history_faults
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics.motions import Course, instants, motion_of
from kinetruss.kinematics.own_motion import OWN, lengths_of, misfits
from kinetruss.kinematics.turns import refuse_uncounted
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.arguments import refuse_without_inner
from kinetruss.mechanics.positions import drive_values
from kinetruss.model import Model
from kinetruss.results import Motion, Status

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def from_arrays(model: Model, time: ArrayLike, position: ArrayLike, velocity: ArrayLike, acceleration: ArrayLike) -> Motion:
    """A Motion from node histories measured or computed elsewhere.

    Parameters
    ----------
    time : (times,) s, increasing. position, velocity, acceleration : (times, n_nodes, dim), nodes in the model's order; SI.

    Returns
    -------
    Motion; its message names rigid bars whose length changes by more than 1e-6 of itself, the worst first, and fixed places
    and couplings that are not kept; ``data.attrs["stretched"]`` lists the bars, ``data.attrs["misfit"]`` is the largest misfit.
    It also names drives whose samples are too far apart to count whole turns.

    Raises
    ------
    InputError : wrong shapes, numbers that are not finite, times that do not increase, a bar whose ends are at one place.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import numpy as np
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    >>> time, still = np.array([0.0, 1.0]), np.zeros((2, 2, 2))
    >>> motion = kt.kinematics.from_arrays(model, time, still + [[0, 0], [2, 0]], still, still)
    >>> motion.length.sel(member="b").values.tolist(), motion.data.attrs["misfit"]
    ([2.0, 2.0], 0.0)
    """
    system = compile(model)
    t = instants(0.0, 2, time)
    x, v, a = (
        _full(system, len(t), values, name)
        for values, name in ((position, "position"), (velocity, "velocity"), (acceleration, "acceleration"))
    )
    if len(flat := np.argwhere((lengths_of(system, x) == 0.0) & (system.length0 > 0.0))):
        k, i = flat[0]
        raise InputError(
            f"position: {system.members[i]!r} has no length at t = {t[k]:g} s; its ends are at one place. Part them."
        )
    shaped = [y.reshape(len(t), -1, 3) for y in (x, v, a)]
    course = Course(t=t, x=x, v=v, a=a, drive=drive_values(system, *shaped))
    motion = motion_of(system, course, "given", Status.COMPLETED, "")
    return _with_uncounted(system, _with_misfit(system, motion, x))


def _with_uncounted(system: System, motion: Motion) -> Motion:
    """The motion; its message names drives of angles that may turn too far between two samples to count whole turns."""
    angles = system.row_drive[(system.row_drive >= 0) & (system.row_kind != LENGTH)]
    t, rate = motion.arrays["time"].values, motion.arrays["drive_velocity"].values
    try:
        for d in angles:
            refuse_uncounted(t, rate[:, d], f"Drive {system.drives[d]!r}")
    except InputError as error:
        return motion.with_(message=f"{motion.message} {error}".strip())
    return motion


def _full(system: System, count: int, values: ArrayLike, name: str) -> NDArray[np.float64]:
    refuse_without_inner(system, values, name)
    full = np.zeros((count, len(system.nodes), 3))
    full[:, :, : system.dim] = array_of(values, name, {"times": count, "n_nodes": system.nodes, "dim": system.dim})
    return full.reshape(count, -1)


def _with_misfit(system: System, motion: Motion, x: NDArray[np.float64]) -> Motion:
    """The motion with a message on rigid lengths, places and couplings that it does not keep, worst first."""
    bad = sorted(misfits(system, x, motion.arrays["length"].values, OWN), key=lambda one: -one.share)
    bars = [one for one in bad if one.kind == "length"]
    motion.attrs.update({"stretched": [one.what for one in bars], "misfit": bad[0].share if bad else 0.0})
    if not bad:
        return motion
    rest = [one.text for one in bad if one.kind != "length"]
    said = []
    if bars:
        named = few([f"{one.what} by {one.share:.2g}" for one in bars], 6)
        said.append(f"Rigid bars change their length in the given motion (fraction of the length): {named}.")
    if rest:
        more = f"; and {len(rest) - 3} more" if len(rest) > 3 else ""
        said.append(f"The given motion does not keep to the model: {'; '.join(rest[:3])}{more}.")
    return motion.with_(message=" ".join(said))


# A motion from a node-history table.


def from_csv(model: Model, path: str | Path) -> Motion:
    r"""A Motion from a CSV of node histories measured or computed elsewhere.

    Parameters
    ----------
    path : columns ``t``, ``NODE.x``, ``NODE.y``[, ``NODE.z``], ``NODE.vx`` .., ``NODE.ax`` ..; SI, or a unit in the header as
        in ``N4.x [mm]``. Nodes fixed in all axes may be left out: they are at their positions in the model.

    Returns
    -------
    Motion, as from `from_arrays`.

    Raises
    ------
    ModelError : faults of the table, each with its place; a missing moving node, no velocities or accelerations, a fixed node
        at another position.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    >>> table = "t,B.x [mm],B.y [mm],B.vx,B.vy,B.ax,B.ay\n0,2000,0,0,0,0,0\n1,2000,0,0,0,0,0\n"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "motion.csv")
    ...     _ = file.write_text(table)
    ...     motion = kt.kinematics.from_csv(model, file)
    >>> motion.length.sel(member="b").values.tolist()
    [2.0, 2.0]
    """
    nodes = model.whole.nodes
    history = read_history(path, dim=model.dim, nodes=nodes)
    if found := history_faults(model, history):
        raise ModelError(found)
    rates = (
        cast("NDArray[np.float64]", one) for one in (history.velocity, history.acceleration)
    )  # without them there are faults
    x, v, a = (_filled(model, history, one) for one in (history.position, *rates))
    for k, (name, node) in enumerate(nodes.items()):
        if name not in history.nodes:
            x[:, k] = node.at
    return from_arrays(model, history.times, x, v, a)


def _filled(model: Model, history: NodeHistory, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values in the order of the model's nodes; zero for those that are not in the table."""
    nodes = model.whole.nodes
    found = np.zeros((len(history.times), len(nodes), model.dim))
    for k, name in enumerate(nodes):
        if name in history.nodes:
            found[:, k] = values[:, history.nodes.index(name)]
    return found
