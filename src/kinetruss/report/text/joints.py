"""Joint forces at one instant, by member, node and axis."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, quantity
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.mechanics.structure import local_axes
from kinetruss.model import inner_parts
from kinetruss.report._page import Page
from kinetruss.report.run_text.drives import pose_at
from kinetruss.runs.missions import check_histories

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Owner
    from kinetruss.runs import RunResult

__all__ = ["JointForces", "joints"]


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
    for what, name, known in (
        ("load case", case, run.forces),
        ("member", member, run.model.members),
        ("node", node, run.model.nodes),
        ("axis", axis, "xyz"[: run.model.dim]),
    ):
        if name is not None and name not in known:
            raise InputError(f"No {what} called {name!r}. There are: {', '.join(known)}.")
    data = run.forces[case].data
    at = _instant(data, time)
    axes = [str(a) for a in data["axis"].values]
    shown = [axes.index(axis)] if axis else list(range(len(axes)))
    force = data["joint_force"].isel(time=at).values
    dim, inner = run.model.dim, inner_parts(run.model)
    frames = local_axes(compile(run.model), run.motion.data["position"].values[at : at + 1])[0, :, :dim, :dim]
    rows = [
        (name, end, bar.ends[e], force[i, e, shown], frames[i] @ force[i, e])
        for i, (name, bar) in enumerate(run.model.members.items())
        for e, end in enumerate("AB")
        if node in (None, bar.ends[e]) and (name == member or (member is None and name not in inner.bars))
    ]
    supports = [] if member is not None else _supports(data, at, inner.nodes, node, shown)
    found = JointForces(
        time=float(data["time"].values[at]),
        pose=pose_at(run.forces[case], at),
        load_case=case,
        axes=tuple(axes[k] for k in shown),
        rows=tuple(rows),
        local_axes=("axial", "shear_2", "shear_3")[: len(axes)],
        supports=tuple(supports),
    )
    return Page(found=found, as_record=_record, as_text=_text)


def _instant(data: Any, time: float | None) -> int:
    if time is None:
        return int(np.argmax(np.max(np.abs(data["member_force"].values), axis=1, initial=0.0)))
    if not math.isfinite(time):
        raise InputError(f"time is {time}. Give a finite number of seconds.")
    return int(np.argmin(np.abs(data["time"].values - time)))


def _supports(
    data: Any, at: int, inner: dict[str, Owner], node: str | None, shown: list[int]
) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """The force of each support; that of a clamp is the sum over the node and its frame."""
    reaction = data["reaction"].isel(time=at).values
    names = list(map(str, data["support"].values))
    of = [inner[name].at if name in inner else name for name in names]
    for name in dict.fromkeys(of):
        if node in (None, name):
            yield name, reaction[[one == name for one in of]].sum(axis=0)[shown]


def _text(found: JointForces) -> str:
    """The table as text."""
    when = f"pose {found.pose}" if found.pose else f"t = {instant(found.time)}"
    parts = [f"{when}, load case {found.load_case}; force on the member from its joint"]
    rows = [(m, e, n, *(quantity(x, "N") for x in (*world, *local))) for m, e, n, world, local in found.rows]
    parts.append(Table(("member", "end", "node", *found.axes, *found.local_axes), rows).text)
    if found.supports:
        rows = [(n, *(quantity(x, "N") for x in world)) for n, world in found.supports]
        parts.append("force of the supports on the structure\n" + Table(("node", *found.axes), rows).text)
    return "\n\n".join(parts)


def _record(found: JointForces) -> dict[str, Any]:
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
