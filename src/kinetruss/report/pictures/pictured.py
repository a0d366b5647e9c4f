"""The data of a drawing: positions over time and forces of load cases, from a model, a result or a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError, InputError
from kinetruss.model import Model
from kinetruss.model.beams import FRAME, shown_kinds
from kinetruss.results import Forces, Motion, Result, Simulation
from kinetruss.results.records import check_samples
from kinetruss.runs import RunResult
from kinetruss.runs.missions import check_histories

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["Pictured", "arrows", "curves_of", "pictured"]

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
        from kinetruss.strength.verdict import middle_forces

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
    from kinetruss.mechanics.assembly import case_loads

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
    from kinetruss.mechanics.configuration import beam_curves

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
