"""The nodes and the frame of a body given by name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError, shown
from kinetruss.mechanics.configuration import names_of
from kinetruss.model import Body, Frame, Model, nearest
from kinetruss.model.parts import placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["nodes_of", "start_frame"]


def nodes_of(model: Model, body: str | Sequence[str]) -> tuple[str, ...]:
    """Names of a body's nodes, or the given names; of ``ground`` the nodes that are fixed in all directions; in the plane also
    the ends of a bar.

    Raises
    ------
    InputError : no such body.
    """
    if not isinstance(body, str):
        return tuple(names_of(body, "a body, or nodes that move as one, e.g. ('P1', 'P2', 'P3')"))
    if body == "ground" and body not in model.bodies:
        return tuple(name for name, axes in model.fixed.items() if set(axes) >= set("xyz"[: model.dim]))
    if body not in model.bodies and model.dim == 2 and body in model.members:
        return model.members[body].ends
    if body not in model.bodies:
        hint = nearest(body, model.bodies) if model.bodies else "The model has no bodies: name nodes, e.g. ('P1', 'P2', 'P3')."
        raise InputError(f"No body called {body!r}. {hint}")
    return model.bodies[body].nodes


def start_frame(
    model: Model, body: str | Sequence[str], frame: Frame | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Origin (3,) m and axes (3, 3), rows, of the frame of a body in the start configuration (see `pose`)."""
    named = model.bodies.get(body) if isinstance(body, str) else None
    if frame is not None and not isinstance(frame, Frame):
        raise InputError(f"frame is {shown(frame)}. Give kt.Frame(origin=..), or leave it out.")
    own = named.frame if frame is None and named is not None else frame
    origin, axes = np.zeros(3), np.eye(3)
    place, turned = placed(own, model.dim)
    if own is None or own.origin is None:
        place = _centre(model, named) if named is not None else _middle(model, nodes_of(model, body))
    origin[: model.dim], axes[: model.dim, : model.dim] = place, turned
    return origin, axes


def _centre(model: Model, body: Body) -> NDArray[np.float64]:
    """Centre of mass of a body (dim,), m; the centroid of the carriers if none is given (even mass)."""
    if body.center is None:
        return _middle(model, body.carried_by(model.dim))
    origin, axes = placed(body.frame, model.dim)
    return np.asarray(origin + axes.T @ np.array(body.center, float))


def _middle(model: Model, names: Sequence[str]) -> NDArray[np.float64]:
    return np.asarray(np.mean([model.nodes[name].at for name in names], axis=0))
