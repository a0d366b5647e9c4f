"""Cross-checks of bodies: their nodes, where the mass is, whether such a mass can be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, islice
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model._common_faults import a_bar, components, unknown
from kinetruss.model._drives import LengthDrive

if TYPE_CHECKING:
    from kinetruss.model._bodies import Body
    from kinetruss.model._model import Model

__all__ = ["FLAT", "body_faults", "planar_body_faults"]

FLAT = 1e-6
"""Normalised volume up to which points count as lying in a plane or on a line; 1 of a regular simplex."""
ROUND = 1e-6
"""Of moments of inertia, axes and distances from a plane, as a share of the largest."""
THIN = 1e-10
"""Least principal moment, as a share of the largest, that still slows a turn."""
_TRIED = 5000
_SHAPE = {2: "on one line", 3: "on one line", 4: "in one plane"}


def body_faults(model: Model, dim: int) -> Iterator[Fault]:
    """Faults of the bodies of a model."""
    for name, body in model.bodies.items():
        path = ("bodies", name)
        found = [*_names(model, body, path, dim), *_numbers(body, path, dim)]
        yield from found
        if not found and all(len(model.nodes[node].at) == dim for node in body.nodes):
            yield from _places(model, body, path, dim)


def planar_body_faults(model: Model) -> Iterator[Fault]:
    """Faults of planar bodies: only rigid bars of planar models have one, and then no other mass."""
    planar = all(len(node.at) == 2 for node in model.nodes.values())
    driven = {drive.bar: name for name, drive in model.drives.items() if isinstance(drive, LengthDrive)}
    for name, bar in model.bars.items():
        if bar.body is None:
            continue
        path = ("bars", name, "body")
        if not planar:
            mend = "Use a planar model (two coordinates), or lumped and bar masses."
            yield Fault(path, "is a planar body in space.", mend, about=(("nodes",),))
        if bar.kind != "rigid":
            mend = "Make it rigid, and let another bar drive or spring it."
            yield Fault(path, f"is given for {a_bar(bar.kind)}, whose length changes.", mend, about=(("bars", name, "kind"),))
        elif name in driven:
            mend = "Drive another bar."
            message = f"is given for a bar whose length {driven[name]!r} drives."
            yield Fault(path, message, mend, about=(("drives", driven[name]),))
        for field in ("mass", "rotary_inertia", "section", "material"):
            if getattr(bar, field) not in (None, False):
                mend = f"Remove {field}: the body has all of the bar's mass, and is rigid."
                yield Fault(path, f"is given together with {field}.", mend, about=(("bars", name, field),))


def _names(model: Model, body: Body, path: tuple[str, str], dim: int) -> Iterator[Fault]:
    for field in ("nodes", "carriers"):
        names: Sequence[str] = getattr(body, field) or ()
        for index, node in enumerate(names):
            if node not in model.nodes:
                yield unknown("node", node, model.nodes, (*path, field, index))
            elif node in names[:index]:
                yield Fault((*path, field, index), f"names {node!r} twice.", "Name each node once.")
            elif field == "carriers" and node not in body.nodes:
                mend = f"Add it to the body's nodes, or take of {', '.join(body.nodes)}."
                yield Fault((*path, field, index), f"{node!r} is no node of the body.", mend)
    about = ((*path, "nodes"),)
    if len(body.nodes) < 2:
        mend = f"Give {dim + 1} nodes, or give the node itself the mass: nodes: {{{body.nodes[0]}: {{at: [..], mass: ..}}}}."
        yield Fault((*path, "nodes"), "is one node, which has no direction.", mend)
    elif not 2 <= len(body.carried_by(dim)) <= dim + 1:
        count = len(body.carried_by(dim))
        message = f"names {count} nodes; a body is carried by 2 to {dim + 1}."
        yield Fault((*path, "carriers"), message, f"Name {dim + 1} of the body's nodes.", about=about)


def _numbers(body: Body, path: tuple[str, str], dim: int) -> Iterator[Fault]:
    if (body.center is None) != (body.inertia is None):
        has, lacks = ("center", "inertia") if body.inertia is None else ("inertia", "center")
        mend = f"Give {lacks} too, or neither for a mass spread evenly."
        yield Fault(path, f"has {has} but no {lacks}.", mend, about=((*path, lacks),))
    if body.inertia is not None and not body.mass:
        yield Fault((*path, "mass"), "is 0, but an inertia is given.", "Give the mass, kg.")
    frame = body.frame
    for field, vector in (("center", body.center), ("frame", None if frame is None else frame.origin)):
        yield from components(vector, dim, (*path, field))
    if frame is not None and frame.axes is not None:
        axes = list(_axes(frame.axes, (*path, "frame", "axes"), dim))
        yield from axes
        if axes:
            return
    yield from _inertia(body, (*path, "inertia"), dim)


def _axes(axes: Any, path: tuple[str, ...], dim: int) -> Iterator[Fault]:
    import numpy as np

    if len(axes) != dim or any(len(row) != dim for row in axes):
        shape = f"{len(axes)} rows of {', '.join(str(len(row)) for row in axes)} numbers"
        yield Fault(path, f"has {shape}.", f"Give {dim} rows of {dim}: the unit vectors of the frame.", about=(("nodes",),))
        return
    given = np.array(axes, float)
    if not np.isfinite(given).all() or np.abs(given @ given.T - np.eye(dim)).max() > ROUND:
        lengths, (i, j) = np.linalg.norm(given, axis=1), (0, 1)
        worst = f"the rows have lengths {', '.join(f'{l:.6g}' for l in lengths)}"
        for a, b in combinations(range(dim), 2):
            i, j = (a, b) if abs(given[a] @ given[b]) >= abs(given[i] @ given[j]) else (i, j)
        message = f"is not a set of unit vectors at right angles: {worst}, rows {i + 1} and {j + 1} the product "
        yield Fault(path, f"{message}{given[i] @ given[j]:.3g}.", "Give unit vectors, each normal to the others.")
    elif np.linalg.det(given) < 0:
        rows = ["x", "y", "z"][:dim]
        mend = f"Turn the last axis round ({rows[-1]}: {[float(-v) + 0.0 for v in given[-1]]}), or swap two."
        yield Fault(path, "is a left-handed frame.", mend)


def _inertia(body: Body, path: tuple[str, ...], dim: int) -> Iterator[Fault]:
    import numpy as np

    from kinetruss.model._body_mass import principal

    if body.inertia is None:
        return
    given = np.array(body.inertia, float)
    allowed = {2: ((), (2, 2)), 3: ((3,), (3, 3))}[dim]
    if given.shape not in allowed:
        got = {(): "one number", (3,): "three moments", (2, 2): "a 2 x 2 matrix", (3, 3): "a 3 x 3 matrix"}[given.shape]
        wanted = "the one moment of the plane" if dim == 2 else "three principal moments, or a 3 x 3 matrix"
        yield Fault(path, f"is {got} in a model of dimension {dim}.", f"Give {wanted}.", about=(("nodes",),))
        return
    largest = float(np.abs(given).max(initial=0.0))
    if given.ndim == 2 and np.abs(given - given.T).max() > ROUND * largest:
        i, j = np.unravel_index(int(np.abs(given - given.T).argmax()), given.shape)
        message = f"is not symmetric: entries {i + 1},{j + 1} and {j + 1},{i + 1} are {given[i, j]:g} and {given[j, i]:g}."
        yield Fault(path, message, "Give both the same value, minus the integral of the product of the coordinates.")
        return
    moments = principal(body, dim) if dim == 3 else np.linalg.eigvalsh(given) if given.ndim == 2 else given.reshape(1)
    shown = ", ".join(f"{m:.6g}" for m in moments)
    if moments[0] < -ROUND * largest:
        yield Fault(path, f"has a negative principal moment: {shown} kg m^2.", "Check the signs off the diagonal.")
    elif dim == 3 and moments[2] > (moments[0] + moments[1]) + ROUND * largest:
        message = f"is impossible: its largest principal moment exceeds the sum of the others ({shown} kg m^2)."
        yield Fault(path, message, "No mass has such moments; are they about the centre, and in order?")


def _places(model: Model, body: Body, path: tuple[str, str], dim: int) -> Iterator[Fault]:
    """The carriers span what they must, the mass lies in it, and bars can hold the nodes."""
    import numpy as np

    from kinetruss.model._body_mass import inertia_of, on_carriers, placed, principal, quality, second_moments

    about = (*((("nodes", name)) for name in body.nodes), (*path, "frame"), (*path, "center"), (*path, "inertia"))
    at = {name: np.array(model.nodes[name].at, float) for name in body.nodes}
    for one, two in combinations(body.nodes, 2):
        if np.array_equal(at[one], at[two]):
            yield Fault((*path, "nodes"), f"{one!r} and {two!r} stand at one place.", "Keep one of them.", about=about)
            return
    carriers = body.carried_by(dim)
    points = np.array([at[name] for name in carriers])
    if (found := quality(points)) <= FLAT:
        message = f"{', '.join(map(repr, carriers))} lie {_SHAPE[len(carriers)]} (normalised volume {found:.1e}, 1 is best)."
        yield Fault((*path, "carriers" if body.carriers else "nodes"), message, _others(body, at, dim), about=about)
        return
    if body.center is not None and body.mass and len(carriers) <= dim and not (dim == 2 and len(carriers) == 2):
        origin, axes = placed(body.frame, dim)
        S = second_moments(inertia_of(body, dim))
        _, off = on_carriers(points, body.mass, origin + axes.T @ np.array(body.center), S)
        if off > ROUND:
            where = "the line of its two carriers" if len(carriers) == 2 else "the plane of its three carriers"
            message = f"has mass off {where} ({off:.1e} of its moments)."
            mend = "Give four nodes that are not in one plane, or a centre and moments in it: the moment about its normal is "
            mend += "the sum of the other two." if len(carriers) == 3 else "0 about the line."
            yield Fault(path, message, mend, about=about)
    if body.kind == "rigid" and body.mass and dim == 3 and len(carriers) > 2 and body.inertia is not None:
        moments = principal(body, dim)
        if moments[0] <= THIN * moments[2]:
            message = f"has no moment of inertia about its own line, about which its nodes turn ({moments[0]:.3g} kg m^2)."
            mend = "Let two nodes of that line carry it: carriers: [.., ..]; or give it a small moment."
            yield Fault((*path, "inertia"), message, mend, about=about)
    if body.kind == "rigid":
        yield from _held(model, body, at, path, dim)


def _others(body: Body, at: dict[str, Any], dim: int) -> str:
    """Other carriers, or where a further node would do."""
    import numpy as np

    from kinetruss.model._body_mass import quality

    tried = islice(combinations(body.nodes, dim + 1), _TRIED)
    best = max(tried, key=lambda names: quality([at[name] for name in names]), default=())
    if best and quality([at[name] for name in best]) > FLAT:
        return f"Take others: carriers: [{', '.join(best)}]."
    place = ", ".join(f"{float(v):.4g}" for v in _apex(np.array(list(at.values()))))
    flat = " A flat body has three carriers." if dim == 3 and len(body.carried_by(dim)) == 4 else ""
    return f"Add a node beside them to the body, e.g. at ({place}).{flat}"


def _apex(points: Any) -> Any:
    """A place beside points that lie in a plane or on a line: off their middle by their mean distance from it."""
    import numpy as np

    middle = points.mean(axis=0)
    normal = np.linalg.svd(points - middle)[2][-1]
    return middle + normal * np.sqrt(np.mean(np.sum((points - middle) ** 2, axis=1))) + 0.0


def _held(model: Model, body: Body, at: dict[str, Any], path: tuple[str, str], dim: int) -> Iterator[Fault]:
    """No bar between nodes of a rigid body may change its length; more nodes than a simplex must not be flat."""
    import numpy as np

    members: dict[str, Any] = {**model.bars, **model.active}  # the model's own table waits for braces
    for name, member in members.items():
        if name in model.driven_members and set(member.ends) <= set(body.nodes):
            mend = "Take one of its ends out of the body, or make the body kind: straining."
            message = f"is rigid, but {name!r} drives the distance of its nodes {member.ends[0]!r} and {member.ends[1]!r}."
            yield Fault(path, message, mend, about=(("bars", name), ("active", name)))
    points = np.array(list(at.values()))
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    span = int(np.sum(spread > FLAT * spread[0]))
    if body.brace and len(points) > span + 1 and span < dim:
        place = ", ".join(f"{float(v):.4g}" for v in _apex(points))
        where = "in one plane" if span == 2 else "on one line"
        message = f"has {len(points)} nodes {where}, which bars between them hold to second order only."
        mend = f"Add a node beside them to its nodes, e.g. at ({place}); it needs no mass."
        yield Fault((*path, "nodes"), message, mend, about=(*(("nodes", name) for name in body.nodes),))
