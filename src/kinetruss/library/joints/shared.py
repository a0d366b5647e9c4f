"""Joints that are nodes shared by two bodies: one, two on an axis, three; and Hooke's joint with an additional bar."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from kinetruss.errors import Fault, ModelError
from kinetruss.library.building import own_arguments
from kinetruss.library.joints.joining import Draft, anchored, direction, extent, hinge, pair_of, sized, start
from kinetruss.model import Model

Bodies = Sequence[str]


@own_arguments
def spherical(model: Model, name: str, *, bodies: Bodies, at: Any) -> Model:
    """A ball joint: the bodies share one node, called after the joint. Three relative freedoms.

    Parameters
    ----------
    model : in space. name : of the joint. bodies : two names, either may be ``ground``. at : its place, m, or a node's name.

    Returns
    -------
    Model : with the node added to both bodies, and the joint in `Model.joints`.

    Raises
    ------
    ModelError : unknown or equal bodies, a name that is taken, a place far off a body.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> top = kt.Model(nodes=corners, bodies={"top": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> kt.kinematics.mobility(spherical(top, "ball", bodies=("ground", "top"), at="O")).degrees_of_freedom
    3
    """
    pair = pair_of(bodies)
    place, node = start(model, name, pair, at, 3)
    return _at_one_node(
        model, name, pair, Draft(kind="spherical", places={node or name: place}, first=(), second=(), given=node)
    )


@own_arguments
def pin(model: Model, name: str, *, bodies: Bodies, at: Any) -> Model:
    """The hinge of the plane: the bodies share one node, called after the joint. One relative freedom, the angle.

    Parameters, returns and errors as of `spherical`, in a planar model.

    >>> import kinetruss as kt
    >>> corners = {"A": (0, 0), "B": (1, 0), "C": (0, 1)}
    >>> plate = kt.Model(nodes=corners, bodies={"plate": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> hung = kt.library.joints.pin(plate, "hinge", bodies=("ground", "plate"), at="A")
    >>> kt.kinematics.mobility(hung).degrees_of_freedom
    1
    """
    pair = pair_of(bodies)
    place, node = start(model, name, pair, at, 2)
    ends, more = anchored(model, name, pair, place, None, extent(model, *pair))
    hinges = hinge((node or name,), *ends)
    draft = Draft(
        kind="pin", places={node or name: place} | more, first=(), second=(), given=node, hinges=hinges, ground=list(more)
    )
    return _at_one_node(model, name, pair, draft)


def _at_one_node(model: Model, name: str, pair: tuple[str, str], draft: Draft) -> Model:
    node = [draft.given or name]
    return sized(model, name, pair, 1.0, lambda *_: replace(draft, first=node, second=node))


@own_arguments
def revolute(model: Model, name: str, *, bodies: Bodies, at: Any, axis: Any, size: float | None = None) -> Model:
    """A hinge: the bodies share two nodes ``NAME.1`` and ``NAME.2`` on its axis, an edge of both. One relative freedom.

    Parameters
    ----------
    model, name, bodies, at : as of `spherical`. With a node's name that node is the first of the axis, else the axis extends
        equally to either side of the place.
    axis : x, y, z or three numbers; the angle is right-handed about it.
    size : distance of the two nodes, m; by default the best conditioned of some fractions of the size of the smaller body.

    Raises
    ------
    ModelError : as of `spherical`; an axis without direction. Warns `JointWarning` if the size makes it ill-conditioned.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> door = kt.Model(nodes=corners, bodies={"door": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> hung = revolute(door, "hinge", bodies=("ground", "door"), at=(0, 0, 0.5), axis="z")
    >>> kt.kinematics.mobility(hung).degrees_of_freedom
    1
    """
    pair = pair_of(bodies)
    place, node = start(model, name, pair, at, 3)
    u = direction(name, "axis", axis, 3)
    one, two = node or f"{name}.1", f"{name}.2"

    def draft(now: Model, length: float) -> Draft:
        ends, more = anchored(now, name, pair, place, u, length)
        places = {one: place if node else place - length / 2 * u, two: place + (1.0 if node else 0.5) * length * u}
        return Draft(
            kind="revolute",
            places=places | more,
            first=[one, two],
            second=[one, two],
            hinges=hinge((one, two), *ends),
            given=node,
            ground=list(more),
        )

    return sized(model, name, pair, size, draft)


@own_arguments
def weld(model: Model, name: str, *, bodies: Bodies, at: Any, size: float | None = None) -> Model:
    """No relative freedom: the bodies share three nodes in space, two in the plane, ``NAME.1`` ...

    Parameters
    ----------
    model : in space or in the plane. name, bodies, at : as of `spherical`. size : distance of the nodes, m, by default as of
        `revolute`.

    Raises
    ------
    ModelError, JointWarning : as of `revolute`.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> held = kt.library.joints.weld(block, "weld", bodies=("ground", "block"), at="O")
    >>> kt.kinematics.mobility(held).degrees_of_freedom
    0
    """
    pair = pair_of(bodies)
    place, node = start(model, name, pair, at, model.dim)
    names = [f"{name}.{k + 1}" for k in range(model.dim)]
    if node:
        names[0] = node

    def draft(_: Model, length: float) -> Draft:
        corners = length * np.eye(model.dim)
        corners -= corners[0] if node else corners.mean(axis=0)
        places = {one: place + corner for one, corner in zip(names, corners, strict=True)}
        return Draft(kind="weld", places=places, first=names, second=names, given=node)

    return sized(model, name, pair, size, draft)


@own_arguments
def universal(model: Model, name: str, *, bodies: Bodies, at: Any, axes: tuple[Any, Any], size: float | None = None) -> Model:
    """Hooke's joint: a cross that turns in the first body about the first axis, in the second about the second. Two freedoms.

    The bodies share the centre ``NAME.0``; ``NAME.1`` on the first axis belongs to the first body, ``NAME.2`` on the second
    axis to the second; a bar between those two keeps the angle of the axes. Its hinges are the angle from the first body to the
    cross and from the cross to the second body.

    Parameters
    ----------
    model, name, bodies, at : as of `spherical`. axes : of the first and the second body, usually at right angles.
    size : distance of the nodes from the centre, m; by default as of `revolute`.

    Raises
    ------
    ModelError, JointWarning : as of `revolute`; axes that are parallel.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> hung = kt.library.joints.universal(block, "cross", bodies=("ground", "block"), at="O", axes=("x", "y"))
    >>> kt.kinematics.mobility(hung).degrees_of_freedom
    2
    """
    pair = pair_of(bodies)
    place, node = start(model, name, pair, at, 3)
    u, v = direction(name, "axes", axes[0], 3), direction(name, "axes", axes[1], 3)
    if np.linalg.norm(np.cross(u, v)) < 0.05:
        raise ModelError([Fault(("joints", name, "axes"), "the axes are parallel.", "Give two at right angles, e.g. x and y.")])
    centre, one, two = node or f"{name}.0", f"{name}.1", f"{name}.2"

    def draft(now: Model, length: float) -> Draft:
        (start_, _), more = anchored(now, name, pair, place, u, length)
        (_, end), also = anchored(now, name, pair, place, v, length)
        more |= also
        hinges = [*hinge((centre, one), start_, two), *hinge((centre, two), one, end)]
        places = {centre: place, one: place + length * u, two: place + length * v} | more
        return Draft(
            kind="universal",
            places=places,
            first=[centre, one],
            second=[centre, two],
            bars=[(one, two)],
            hinges=hinges,
            given=node,
            ground=list(more),
        )

    return sized(model, name, pair, size, draft)
