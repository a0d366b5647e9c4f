"""Cross-checks of loads on bodies."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault, few
from kinetruss.model.beam_frames import carriers_of
from kinetruss.model.hub_arms import arm_through
from kinetruss.model.in_time import moment_faults, vector_faults
from kinetruss.model.loads import FAULTS, BodyCouple, BodyForce, Pressure
from kinetruss.model.words import nearest

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData
    from kinetruss.model.whole import WholeModel


OFF = 1e-6


def load_faults(model: WholeModel, dim: int) -> Iterator[Fault]:
    """Faults of all loads of a model."""
    for name, load in model.loads.items():
        yield from CHECKS[type(load)](load, model, dim, ("loads", name))


def _face(load: Pressure, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: ARG001
    if len(load.face) != dim or len(set(load.face)) != len(load.face):
        wanted = "two nodes of an edge" if dim == 2 else "three nodes of a face"
        yield Fault((*path, "face"), f"names {len(set(load.face))} nodes.", f"Name {wanted}.", about=(("nodes",),))


def loads_along_beams(model: ModelData) -> Iterator[Fault]:
    """Pressures on edges along beams, which analyses refuse: forces at their nodes would not bend them between the ends. An
    element on the edge takes its pressure.

    >>> import kinetruss as kt
    >>> beam = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], beams={"arm": ("A", "B")}, material="steel_s235",
    ...                 section=kt.Rod(diameter=0.02), loads={"wind": kt.Pressure(face=("A", "B"), pressure=10.0)})
    >>> [fault.path for fault in loads_along_beams(beam)]
    [('loads', 'wind', 'face')]
    """
    if model.dim == 2 and model.beams:
        for name, load in model.loads.items():
            if isinstance(load, Pressure):
                yield from _along_beams(model, load, ("loads", name))


def _along_beams(model: ModelData, load: Pressure, path: tuple[Any, ...]) -> Iterator[Fault]:
    if any(set(load.face) <= set(one.nodes) for one in model.membranes.values()):
        return
    a, b = (model.nodes[node].at for node in load.face)
    along = [name for name, beam in model.beams.items() if _within(model, beam.ends, a, b)]
    if along:
        which = f"beam {along[0]}" if len(along) == 1 else f"the beams {few(along, 4)}"
        message = f"acts along {which}: its forces at {' and '.join(load.face)} alone would bend nothing between the ends."
        mend = (
            f"Give each beam its load: {{member: {along[0]}, force: [0, 1 kN/m], axes: member}}, the pressure times the depth, "
            "to the left of the way from the first end of the beam to the second."
        )
        yield Fault((*path, "face"), message, mend, about=tuple(("beams", name) for name in along))


def _within(model: ModelData, ends: tuple[str, str], a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    """Whether both ends lie on the line from a to b, and are not one place."""
    length = math.dist(a, b)
    shares = []
    for end in ends:
        if end not in model.nodes or len(model.nodes[end].at) != 2 or not length:
            return False
        (x, y), (u, v) = (model.nodes[end].at[k] - a[k] for k in (0, 1)), (b[k] - a[k] for k in (0, 1))
        if abs(x * v - y * u) > OFF * length**2:
            return False
        shares.append((x * u + y * v) / length**2)
    return min(shares) > -OFF and max(shares) < 1 + OFF and abs(shares[0] - shares[1]) > OFF


def _on_body(load: BodyForce | BodyCouple, model: WholeModel, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:
    through = getattr(load, "member", None)
    if through is not None and arm_through(model, load.body, through) is None:
        message = f"enters through {through!r}, but {load.body!r} is no body of a hub in space with an arm for it."
        mend = f"Give the node a hub with an arm for {through!r}, and name the body NODE.hub; or leave out member."
        yield Fault((*path, "member"), message, mend, about=(("hubs",), ("bodies", load.body)))
        return
    if through is None and carriers_of(model, load.body) is None and (dim == 3 or load.body not in model.bars):
        known = [*model.bodies, *model.inner.frames, *(model.bars if dim == 2 else ())]
        about = (("bodies", load.body), ("bars", load.body))
        yield Fault((*path, "body"), f"no body called {load.body!r}.", nearest(load.body, known), about=about)
        return
    wide: tuple[tuple[str, ...], ...] = (("bodies", load.body), ("bars", load.body), ("nodes",))
    if isinstance(load, BodyCouple):
        if wrong := list(moment_faults(load, dim, path, wide)):
            yield from wrong
            return
    else:
        found = list(vector_faults(load, model, dim, path))
        if load.at is not None and len(load.at) != dim:
            found.append(Fault((*path, "at"), f"has {len(load.at)} components.", f"Give {dim}.", about=(("nodes",),)))
        yield from found
        if found:
            return
    if load.body in model.bodies:
        yield from _reach(model, load, dim, path, wide)


def _reach(model: ModelData, load: BodyForce | BodyCouple, dim: int, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    """A rod or a flat body accepts forces at points in its line or plane only; a rod accepts no couple."""
    import numpy as np

    from kinetruss.model.bodies import barycentric

    body = model.bodies[load.body]
    carriers = [node for node in body.carried_by(dim) if node in model.nodes]
    if len(carriers) != len(body.carried_by(dim)) or len(carriers) == dim + 1 or dim == 2:
        return
    points = np.array([model.nodes[node].at for node in carriers], float)
    mend = "Let the body be carried by four nodes: carriers."
    if len(carriers) == 2 and (isinstance(load, BodyCouple) or load.follows):
        what = "is a couple on" if isinstance(load, BodyCouple) else "turns with"
        yield Fault(path, f"{what} a rod of two nodes, which has no plane.", mend, about=about)
    elif isinstance(load, BodyForce) and load.at is not None:
        off = barycentric(points, np.array(load.at, float))[1]
        if off > OFF:
            message = f"is {off:.3g} m off the {'line' if len(carriers) == 2 else 'plane'} of the nodes that carry the body."
            yield Fault((*path, "at"), message, mend, about=about)


CHECKS = {**FAULTS, BodyForce: _on_body, BodyCouple: _on_body, Pressure: _face}
"""Faults of loads by their kinds."""
