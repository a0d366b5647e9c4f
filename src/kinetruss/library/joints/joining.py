"""Common parts of all joints: checks of arguments, the model with nodes and bars added, conditioning."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, cast

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.library.building import own_arguments
from kinetruss.library.placing import bars_between, point
from kinetruss.model import GROUND, Coupling, Hinge, Joint, Model, Node, nearest

FAR = 2.0
"""A joint farther from a body than this multiple of the size of the body is refused as a mistake."""
SAME = 1e-9
"""Distance below which two nodes are at one place, m."""
POOR = 1e-3
"""A joint is ill-conditioned if the smallest singular value of its unit rows is below this."""
SIZES = (0.25, 0.35, 0.5, 0.7, 1.0)
"""Sizes of a joint that are tried, as fractions of the size of its bodies."""


NODES = ("line", "point", "node", "axis", "start", "end")
"""Fields of a coordinate that name nodes."""


class JointWarning(UserWarning):
    """An ill-conditioned joint: nearly flat, or much smaller than its bodies."""


@dataclass(frozen=True, kw_only=True)
class Draft:
    """The plan of a joint: places of its nodes, nodes for each body, bars, hinges and slide; `given`: existing nodes."""

    kind: str
    places: Mapping[str, Any]
    first: Sequence[str]
    second: Sequence[str]
    bars: Iterable[tuple[str, str]] = ()
    hinges: Sequence[Hinge] = ()
    slide: tuple[str, str] | None = None
    couplings: Mapping[str, Coupling] = field(default_factory=dict)
    given: str | None = None
    ground: Sequence[str] = ()


def pair_of(bodies: Sequence[str]) -> tuple[str, str]:
    """The names of the two bodies; `start` reports their faults."""
    return cast("tuple[str, str]", tuple(bodies))


def start(model: Model, name: str, bodies: tuple[str, str], at: Any, dim: int) -> tuple[Any, str | None]:
    """The place of a joint (dim,), m, and the node that `at` names, if it does; all faults of the arguments at once."""
    found: list[Fault] = []
    if model.dim != dim:
        other = "joints.pin, parallelogram or weld" if model.dim == 2 else "a joint of space, e.g. joints.revolute"
        mend = f"Use {other}."
        found.append(Fault(("joints", name), f"is a joint of dimension {dim} in a model of dimension {model.dim}.", mend))
    if name in model.joints:
        found.append(Fault(("joints", name), "is there already.", "Give the joint another name."))
    bodies = pair_of(bodies)
    if len(bodies) != 2:
        raise ModelError([Fault(("joints", name, "bodies"), f"names {len(bodies)} bodies.", "Name two.")])
    if bodies[0] == bodies[1]:
        mend = "Name two different bodies, or ground."
        found.append(Fault(("joints", name, "bodies"), f"joins {bodies[0]!r} to itself.", mend))
    for index, body in enumerate(bodies):
        if body != GROUND and body not in model.bodies:
            mend = nearest(body, [*model.bodies, GROUND])
            found.append(Fault(("joints", name, "bodies", index), f"no body called {body!r}.", mend))
    place, node = _place(model, name, at, found)
    if not found:
        found += [fault for body in bodies if (fault := _far(model, name, body, place))]
    if found:
        raise ModelError(found)
    return place, node


def _place(model: Model, name: str, at: Any, found: list[Fault]) -> tuple[Any, str | None]:
    if isinstance(at, str):
        if at not in model.nodes:
            found.append(Fault(("joints", name, "at"), f"no node called {at!r}.", nearest(at, model.nodes)))
            return None, None
        return np.array(model.nodes[at].at), at
    place = np.array(Node(at=at).at)
    if place.shape != (model.dim,):
        found.append(Fault(("joints", name, "at"), f"has {len(place)} coordinates.", f"Give {model.dim}, m, or a node's name."))
    return place, None


def _far(model: Model, name: str, body: str, place: Any) -> Fault | None:
    """Refuse a joint far from a body, which is usually a mistake."""
    if body == GROUND:
        return None
    own = np.array([model.nodes[node].at for node in model.bodies[body].nodes])
    apart, size = np.linalg.norm(own - place, axis=1), extent(model, body)
    away, near = float(apart.min()), model.bodies[body].nodes[int(apart.argmin())]
    if away <= FAR * size:
        return None
    where, there = (", ".join(f"{value:.4g}" for value in spot) for spot in (place, model.nodes[near].at))
    text = f"stands at ({where}) m, {away:.4g} m from body {body!r}, whose size is {size:.4g} m: they do not meet there."
    mend = (
        f"Move the joint to within {FAR * size:.4g} m of the body, whose nearest node {near!r} is at ({there}), or first give "
    )
    return Fault(("joints", name, "at"), text, f"{mend}{body!r} a node nearer to it.")


def extent(model: Model, *bodies: str) -> float:
    """Size of the smallest of some bodies, m: the largest distance of two of its nodes."""
    sizes = []
    for body in bodies:
        if body != GROUND:
            own = np.array([model.nodes[node].at for node in model.bodies[body].nodes])
            sizes.append(float(np.linalg.norm(own[:, None] - own[None], axis=2).max()))
    return min((size for size in sizes if size > 0), default=1.0)


def direction(name: str, parameter: str, axis: Any, dim: int) -> Any:
    """A unit vector from a letter or numbers; ModelError if it has no direction."""
    if isinstance(axis, str) and axis in "xyz"[:dim]:
        return np.eye(dim)["xyz".index(axis)]
    values = np.asarray(axis, float) if not isinstance(axis, str) else np.zeros(0)
    if values.shape != (dim,):
        mend = f"Give {dim} numbers, or one of {', '.join('xyz'[:dim])}."
        raise ModelError([Fault(("joints", name, parameter), f"{axis!r} is no direction.", mend)])
    size = float(np.linalg.norm(values))
    if not 0 < size < math.inf:
        raise ModelError([Fault(("joints", name, parameter), "has no length, so no direction.", "Give for example (0, 0, 1).")])
    return values / size


def anchored(
    model: Model, name: str, bodies: tuple[str, str], place: Any, along: Any, length: float
) -> tuple[tuple[str | None, str | None], dict[str, Any]]:
    """For each body, the node at angle 0 about an axis; None if all nodes lie on the axis.

    along : unit vector of the axis; None in the plane. Ground without a node off the axis gets one, ``NAME.g``, at `length`
    from the place: the second result.
    """
    ends = [_off_axis(model, body, place, along) for body in bodies]
    if GROUND not in bodies or ends[bodies.index(GROUND)] is not None:
        return (ends[0], ends[1]), {}
    aside = np.eye(model.dim)[0 if along is None else int(np.argmin(np.abs(along)))]
    if along is not None:
        aside = aside - (aside @ along) * along
    ends[bodies.index(GROUND)] = f"{name}.g"
    return (ends[0], ends[1]), {f"{name}.g": place + length * aside / np.linalg.norm(aside)}


def _off_axis(model: Model, body: str, place: Any, along: Any) -> str | None:
    """The node of a body farthest from an axis, relative to its distance from the place."""
    names = (
        [node for node, axes in model.fixed.items() if len(axes) == model.dim] if body == GROUND else model.bodies[body].nodes
    )
    best, found = 1e-3, None
    for name in names:
        way = np.array(model.nodes[name].at) - place
        far = float(np.linalg.norm(way))
        off = 0.0 if far == 0 else 1.0 if along is None else float(np.linalg.norm(way - (way @ along) * along)) / far
        if off > best * (1 + 1e-9):
            best, found = off, name
    return found


def hinge(axis: tuple[str, ...], first: str | None, second: str | None) -> list[Hinge]:
    """The angle about an axis from one node to another; none if one of them is missing."""
    return [] if first is None or second is None else [Hinge(axis=axis, start=first, end=second)]


def sized(
    model: Model, name: str, bodies: tuple[str, str], size: float | None, draft: Callable[[Model, float], Draft]
) -> Model:
    """The model with a joint of a size (m), by default the best conditioned one of `SIZES`. Warns if it is ill-conditioned."""
    if size is None:
        size = _best_size(model, name, bodies, draft)
    elif not 0 < float(size) < math.inf:
        raise ModelError([Fault(("joints", name, "size"), f"{size!r} is no size.", "Give metres, or leave it out.")])
    made = joined(model, name, bodies, draft(model, float(size)))
    value = conditioning(made, name)
    if value < POOR:
        text = (
            f"Joint {name!r} holds badly: its smallest singular value is {value:.1e}. Choose another size (its bodies measure "
            f"{extent(model, *bodies):.3g} m), or leave the size out."
        )
        warnings.warn(text, JointWarning, stacklevel=3)
    return made


def _best_size(model: Model, name: str, bodies: tuple[str, str], draft: Callable[[Model, float], Draft]) -> float:
    """Conditioning with the two bodies alone, so that it takes little time in a large model."""
    own = {body: model.bodies[body] for body in bodies if body != GROUND}
    nodes = {node for body in own.values() for node in body.nodes} | (set(model.fixed) if GROUND in bodies else set())
    part = Model(
        nodes={node: model.nodes[node] for node in nodes},
        fixed={node: axes for node, axes in model.fixed.items() if node in nodes},
        bars={key: bar for key, bar in model.bars.items() if set(bar.ends) <= nodes},
        bodies=own,
    )
    whole = extent(model, *bodies)
    found = {one * whole: conditioning(joined(part, name, bodies, draft(part, one * whole)), name) for one in SIZES}
    return max(found, key=lambda one: round(found[one], 6))


def joined(model: Model, name: str, bodies: tuple[str, str], draft: Draft) -> Model:
    """The model with the nodes, bars and couplings of a joint, and its record."""
    taken = [node for node in draft.places if node in model.nodes and node != draft.given]
    if taken:
        raise ModelError([Fault(("joints", name), f"needs a node {taken[0]!r}, which is there.", "Give it another name.")])
    same = _standing(model, bodies, name, draft)
    new = {node: place for node, place in draft.places.items() if node not in same and node != draft.given}
    nodes = {node: Node(at=point(place), coincident=True) for node, place in new.items()}
    # bars between nodes of one body are added by its bracing
    own = [pair for pair in draft.bars if not any(set(pair) <= set(shared) for shared in (draft.first, draft.second))]
    bars = bars_between((same.get(a, a), same.get(b, b)) for a, b in own)
    joint = Joint(
        kind=draft.kind,
        bodies=bodies,
        nodes=tuple(same.get(node, node) for node in draft.places),
        bars=tuple(bars),
        couplings=tuple(draft.couplings),
        hinges=tuple(_renamed(hinge, same) for hinge in draft.hinges),
        slide=None
        if draft.slide is None
        else (same.get(draft.slide[0], draft.slide[0]), same.get(draft.slide[1], draft.slide[1])),
    )
    kept = {key: _with_renamed(coupling, same) for key, coupling in draft.couplings.items()}
    couplings = {"couplings": model.couplings | kept} if kept else {}
    return model.with_(
        nodes=model.nodes | nodes,
        bars=model.bars | bars,
        joints=model.joints | {name: joint},
        **_with_nodes(model, bodies, draft, same),
        **couplings,
    )


def _renamed(hinge: Hinge, same: Mapping[str, str]) -> Hinge:
    axis = tuple(same.get(node, node) for node in hinge.axis)
    return Hinge(axis=axis, start=same.get(hinge.start, hinge.start), end=same.get(hinge.end, hinge.end))


def _with_renamed(coupling: Coupling, same: Mapping[str, str]) -> Coupling:
    """The coupling with existing nodes in place of those that are not created."""

    def named(value: Any) -> Any:
        return tuple(same.get(one, one) for one in value) if isinstance(value, tuple) else same.get(value, value)

    terms = []
    for one, factor in coupling.terms:
        nodes = {key: named(getattr(one, key)) for key in NODES if key in type(one).model_fields}
        terms.append((one.with_(**nodes), factor))
    return coupling.with_(terms=tuple(terms))


def _standing(model: Model, bodies: tuple[str, str], name: str, draft: Draft) -> dict[str, str]:
    """Nodes of the joint at places where one of the bodies has a node already."""
    found: dict[str, str] = {}
    for node, place in draft.places.items():
        there = [node] if node in model.nodes else []
        for body, shared in zip(bodies, (draft.first, draft.second), strict=True):
            own = model.fixed if body == GROUND else model.bodies[body].nodes
            if node in shared and node not in own:
                there += [other for other in own if np.allclose(model.nodes[other].at, place, rtol=0, atol=SAME)]
        if len(set(there)) > 1:
            text = f"bodies {bodies[0]!r} and {bodies[1]!r} have nodes of their own there, {there[0]!r} and {there[1]!r}."
            raise ModelError([Fault(("joints", name, "at"), text, f"Make them one: name {there[0]!r} in both bodies.")])
        if there and there[0] != node:
            found[node] = there[0]
    return found


def _with_nodes(model: Model, bodies: tuple[str, str], draft: Draft, same: Mapping[str, str]) -> dict[str, Any]:
    """Bodies and fixed nodes, each with its nodes of the joint."""
    held, grown = dict(model.fixed), dict(model.bodies)
    for body, shared in zip(bodies, (draft.first, draft.second), strict=True):
        nodes = [same.get(node, node) for node in (*shared, *(draft.ground if body == GROUND else ()))]
        if body == GROUND:
            held |= dict.fromkeys(nodes, "xyz"[: model.dim])
        else:
            own = grown[body]
            carriers = own.carried_by(model.dim)  # new nodes must not become carriers
            more = tuple(node for node in nodes if node not in own.nodes)
            grown[body] = own.with_(
                nodes=(*own.nodes, *more), carriers=carriers if own.carriers or len(own.nodes) > 1 else None
            )
    return {"fixed": held, "bodies": grown}


@own_arguments
def conditioning(model: Model, name: str) -> float:
    """Smallest singular value of the bars of a joint and its two bodies, rows of unit length: 0 if they are dependent.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> model = kt.Model(nodes=corners, bodies={"top": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> hinged = kt.library.joints.revolute(model, "hinge", bodies=("ground", "top"), at=(0, 0, 0), axis="z")
    >>> conditioning(hinged, "hinge") > 0.1
    True
    """
    if name not in model.joints:
        raise InputError(f"no joint called {name!r}. {nearest(name, model.joints)}")
    joint = model.joints[name]
    whole = model.whole
    parts = [set(joint.nodes)] + [set(model.bodies[body].nodes) for body in joint.bodies if body != GROUND]
    nodes = set().union(*parts)
    rigid = [bar.ends for bar in whole.bars.values() if bar.kind == "rigid" and any(set(bar.ends) <= part for part in parts)]
    moving = [node for node in whole.nodes if node in nodes and node not in whole.fixed]
    column = {node: model.dim * k for k, node in enumerate(moving)}
    J = np.zeros((len(rigid), model.dim * len(moving)))
    for row, ends in enumerate(rigid):
        u = np.subtract(whole.nodes[ends[1]].at, whole.nodes[ends[0]].at)
        for end, sign in zip(ends, (-1, 1), strict=True):
            if end in column:
                J[row, column[end] : column[end] + model.dim] = sign * u / np.linalg.norm(u)
    J = J[np.abs(J).max(axis=1, initial=0) > 0]
    if not J.size:
        return 1.0
    return float(np.linalg.svd(J, compute_uv=False)[-1]) if len(J) <= J.shape[1] else 0.0
