"""Joints that slide, from hinges: one chain of three parallel hinges (planar), or two at right angles (Sarrus)."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from kinetruss.library._arguments import own_arguments
from kinetruss.library.joints.joining import Draft, anchored, direction, hinge, pair_of, sized, start
from kinetruss.library.joints.slides import prismatic_in_plane
from kinetruss.library.mechanisms.sarrus import CHAINS, SARRUS_BARS, chain_bars, sarrus_places
from kinetruss.model import GROUND, Hinge, Model

__all__ = ["cylindrical", "planar", "prismatic"]

APEX = 0.7
"""Height of the apex of a plate as a fraction of its length: best conditioned with hinges as long as the plates."""


@own_arguments
def prismatic(
    model: Model,
    name: str,
    *,
    bodies: Sequence[str],
    at: Any,
    axis: Any,
    size: float | None = None,
    across: Any = None,
    form: Literal["linkage", "direct"] = "linkage",
) -> Model:
    """A slider: the second body moves along the axis and does not turn. One relative freedom.

    In space a Sarrus linkage: 29 bars and 8 free nodes of its own, three nodes on each body. The distance of the nodes
    ``NAME.B`` (first body, at the place given) and ``NAME.G`` (second body), `slide` of its record, starts at `size` and can go
    from near 0 to near 2 `size`; a driven bar between them is the actuator.

    In the plane two of Peaucellier's cells side by side, whose points ``NAME.P1`` and ``NAME.P2`` on the second body run on
    one straight line of the first: 14 bars, 6 free nodes, a stroke of `size` to either side. The slide is the distance of
    ``NAME.P1`` from ``NAME.F`` on that line, at first 2 `size`. Or directly, without bars: two couplings keep the offsets
    of ``NAME.P1`` and ``NAME.P2`` from the line at 0.

    Parameters
    ----------
    model, name, bodies : as of `spherical`. at : of the corner of the linkage on the first body, in the plane of the point on
        the line, m. axis : of the slide, a letter or numbers, from the first body to the second.
    size : length of the plates and of their hinges, in the plane half the stroke, m; by default the best conditioned of some
        fractions of the size of the smaller body.
    across : direction of the hinges of the first chain, normal to the axis; by default any.
    form : in the plane ``linkage`` or ``direct``.

    Raises
    ------
    ModelError : unknown or equal bodies, a name that is in use, a place far from a body, an axis without direction. Warns
        `JointWarning` if the size makes it ill-conditioned.

    Source
    ------
    P. F. Sarrus, Comptes rendus de l'Academie des Sciences 36 (1853) 1036; C.-N. Peaucellier, Nouvelles annales de
    mathematiques 12 (1873) 71-78.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> slider = kt.library.joints.prismatic(block, "slide", bodies=("ground", "block"), at="O", axis="z")
    >>> kt.kinematics.mobility(slider).degrees_of_freedom
    1
    """
    if model.dim == 2:
        return prismatic_in_plane(model, name, bodies=bodies, at=at, axis=axis, size=size, form=form)
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 3)
    frame = _frame(name, axis, across)
    low, high = [f"{name}.{key}" for key in "BEF"], [f"{name}.{key}" for key in "GHK"]

    def draft(_: Model, length: float) -> Draft:
        places, bars = _sarrus(name, place, frame, length)
        bars.remove((f"{name}.N2", f"{name}.K"))  # with a rigid triangle on top, one of the 32 bars is redundant
        return Draft(kind="prismatic", places=places, first=low, second=high, bars=bars, slide=(low[0], high[0]))

    return sized(model, name, pair, size, draft)


@own_arguments
def cylindrical(
    model: Model, name: str, *, bodies: Sequence[str], at: Any, axis: Any, size: float | None = None, across: Any = None
) -> Model:
    """A sliding and turning joint: a Sarrus linkage whose upper end is hinged to the second body on the axis. Two freedoms.

    34 bars. Parameters and errors as of `prismatic`; the axis runs through the place. `slide` of its record is the distance of
    the nodes ``NAME.B`` and ``NAME.G`` on the axis, its hinge the angle from the upper end, which does not turn, to the second
    body.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> free = kt.library.joints.cylindrical(block, "bush", bodies=("ground", "block"), at="O", axis="z")
    >>> kt.kinematics.mobility(free).degrees_of_freedom  # along the axis and about it
    2
    """
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 3)
    frame = _frame(name, axis, across)
    low, turning = [f"{name}.{key}" for key in "BEF"], [f"{name}.G", f"{name}.T"]

    def draft(now: Model, length: float) -> Draft:
        places, bars = _sarrus(name, place, frame, length)
        places[turning[1]] = places[turning[0]] + length * frame[:, 1]
        (_, end), more = anchored(now, name, pair, place, frame[:, 1], length)
        return Draft(
            kind="cylindrical",
            places=places | (more if pair[1] == GROUND else {}),
            first=low,
            second=turning,
            bars=[*bars, (turning[1], f"{name}.H"), (turning[1], f"{name}.K")],
            hinges=hinge((turning[0], turning[1]), f"{name}.H", end),
            slide=(low[0], turning[0]),
            ground=list(more) if pair[1] == GROUND else (),
        )

    return sized(model, name, pair, size, draft)


@own_arguments
def planar(
    model: Model, name: str, *, bodies: Sequence[str], at: Any, axis: Any, size: float | None = None, across: Any = None
) -> Model:
    """Motion in a plane: a chain of three parallel hinges along its normal. Three relative freedoms.

    17 bars, 6 nodes of its own with those of the hinges. The hinges on the two bodies start 1.4 `size` apart about the place
    given and can go from near 0 to near 2 `size`; stretched out the chain is singular.

    Parameters
    ----------
    axis : normal of the plane. across : direction from the first body's hinge to the second's; by default any in the plane.
        The others as of `prismatic`.

    Raises
    ------
    ModelError, JointWarning : as of `prismatic`.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> puck = kt.library.joints.planar(block, "table", bodies=("ground", "block"), at="O", axis="z")
    >>> kt.kinematics.mobility(puck).degrees_of_freedom  # two displacements and a rotation
    3
    """
    pair = pair_of(bodies)
    place, _ = start(model, name, pair, at, 3)
    u = direction(name, "axis", axis, 3)
    frame = _frame(name, u, across)
    ends = [[f"{name}.{k}1", f"{name}.{k}2"] for k in "AMB"]

    def draft(_: Model, length: float) -> Draft:
        # the first chain of a Sarrus linkage: slide along `across`, hinges along the normal
        own = np.column_stack([u, frame[:, 0], np.cross(u, frame[:, 0])])
        local = sarrus_places(np.sqrt(2) * length, length, length, APEX * length)
        middle = (local["G"] + local["H"]) / 2 - local["G"] / 2
        roles = dict(zip([*CHAINS[0][0], *CHAINS[0][1], *CHAINS[0][2]], itertools.chain(*ends), strict=True))
        roles |= dict(zip(CHAINS[0][3], (f"{name}.Q1", f"{name}.Q2"), strict=True))
        places = {key: place + own @ (local[role] - middle) for role, key in roles.items()}
        bars = [(roles[a], roles[b]) for a, b in chain_bars(*CHAINS[0]) if (a, b) != CHAINS[0][2]]
        hinges = [
            Hinge(axis=tuple(ends[0]), start=f"{name}.B1", end=f"{name}.M1"),
            Hinge(axis=tuple(ends[1]), start=f"{name}.A1", end=f"{name}.B1"),
            Hinge(axis=tuple(ends[2]), start=f"{name}.M1", end=f"{name}.A1"),
        ]
        return Draft(kind="planar", places=places, first=ends[0], second=ends[2], bars=bars, hinges=hinges)

    return sized(model, name, pair, size, draft)


def _frame(name: str, axis: Any, across: Any) -> Any:
    """Columns: across, along the axis, the third, right-handed."""
    y = direction(name, "axis", axis, 3)
    given = np.eye(3)[int(np.argmin(np.abs(y)))] if across is None else direction(name, "across", across, 3)
    x = direction(name, "across", given - (given @ y) * y, 3)
    return np.column_stack([x, y, np.cross(x, y)])


def _sarrus(name: str, place: Any, frame: Any, length: float) -> tuple[dict[str, Any], list[tuple[str, str]]]:
    """Nodes and bars of the linkage; the bars between the nodes of the second body are left to it."""
    local = sarrus_places(length, length, length, APEX * length)
    places = {f"{name}.{key}": place + frame @ at for key, at in local.items()}
    return places, [(f"{name}.{a}", f"{name}.{b}") for a, b in SARRUS_BARS]
