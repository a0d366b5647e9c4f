"""Cross-checks of bodies: their nodes, the place of the mass, possible moments of inertia."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.bracing import ROUND, place_faults
from kinetruss.model.common_faults import a_bar, components
from kinetruss.model.drives import LengthDrive

if TYPE_CHECKING:
    from kinetruss.model.bodies import Body
    from kinetruss.model.data import ModelData


_DILATES = "A body that stretches with its bar is kt.Body(nodes=({!r}, {!r}), kind='straining', mass=..), beside the bar."


def body_faults(model: ModelData, dim: int) -> Iterator[Fault]:
    """Faults of the bodies of a model."""
    members: dict[str, Any] = {**model.bars, **model.active}  # the braces of the model are not built yet
    driven: dict[str, list[tuple[str, str]]] = {}
    for name in sorted(model.driven_members & members.keys()) if model.bodies else ():
        driven.setdefault(members[name].ends[0], []).append((name, members[name].ends[1]))
    for name, body in model.bodies.items():
        path = ("bodies", name)
        found = [*_names(model, body, path, dim), *_numbers(body, path, dim)]
        yield from found
        nodes = [model.nodes.get(node) for node in (*body.nodes, *(body.carriers or ()))]
        if not found and all(node is not None and len(node.at) == dim for node in nodes):
            yield from place_faults(model, body, path, dim, driven)


def planar_body_faults(model: ModelData) -> Iterator[Fault]:
    """Faults of planar bodies: only rigid bars of planar models have one, without other mass."""
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
            mend = f"{_DILATES.format(*bar.ends)} Or make the bar rigid."
            yield Fault(path, f"is given for {a_bar(bar.kind)}, whose length changes.", mend, about=(("bars", name, "kind"),))
        elif name in driven:
            mend = f"{_DILATES.format(*bar.ends)} Or drive another bar."
            message = f"is given for a bar whose length {driven[name]!r} drives."
            yield Fault(path, message, mend, about=(("drives", driven[name]),))
        for field in ("mass", "rotary_inertia", "section", "material"):
            if getattr(bar, field) not in (None, False):
                mend = f"Remove {field}: the body has all of the bar's mass, and is rigid."
                yield Fault(path, f"is given together with {field}.", mend, about=(("bars", name, field),))


def _names(model: ModelData, body: Body, path: tuple[str, str], dim: int) -> Iterator[Fault]:
    for field in ("nodes", "carriers"):
        names: Sequence[str] = getattr(body, field) or ()
        for index, node in enumerate(names):
            if node in names[:index]:
                yield Fault((*path, field, index), f"names {node!r} twice.", "Name each node once.")
            elif field == "carriers" and node in model.nodes and node not in body.nodes:
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

    from kinetruss.model.bodies import principal

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
    found = impossible(moments)
    if found:
        yield Fault(path, found, _possible(given, moments))


def impossible(moments: Any) -> str:
    """The fault of principal moments (1,), (2,) or (3,), kg m^2, least first; nothing if they are possible."""
    shown, slack = ", ".join(f"{m:.6g}" for m in moments), ROUND * float(abs(moments).max())
    if moments[0] < -slack:
        return f"has a negative principal moment: {shown} kg m^2."
    if len(moments) == 3 and moments[2] > moments[0] + moments[1] + slack:
        share = f"{moments[2]:.6g} > {moments[0] + moments[1]:.6g}"
        return f"is impossible: its largest principal moment exceeds the sum of the others ({shown} kg m^2: {share})."
    return ""


def _possible(given: Any, moments: Any) -> str:
    if moments[0] < 0:
        if given.ndim == 2:
            return "Check the signs off the diagonal: they are minus the integrals of the products of the coordinates."
        return "Give moments of 0 or more."
    return (
        f"Give moments about the centre of mass of which none exceeds the sum of the others, here the largest at most "
        f"{moments[0] + moments[1]:.6g} kg m^2; about a point at a distance d from the centre they are larger by m d^2."
    )
