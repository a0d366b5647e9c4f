"""Masses between the nodes that carry bodies and rigid beams."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.numbers import apart, chosen
from kinetruss.model.beam_frames import rigid_beams, sound_beams
from kinetruss.model.bodies import body_mass, fixed_vector, placed, uniform

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.matter import Matter
    from kinetruss.elements.numbers import Array, Numbers
    from kinetruss.model import Body, WholeModel


THIN = 1e-10
"""Eigenvalues of m_ij below this fraction of the largest count as zero: the body lies in a plane or on a line."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Bodies:
    """The bodies with mass, then the rigid beams: nodes (k,) that carry each; names and records of bodies, and which numbers
    are those of their centres and inertias; lines : of each beam, its section and material, or None where its mass is given.
    """

    dim: int
    names: tuple[str, ...]
    nodes: tuple[list[int], ...]
    records: tuple[Body, ...]
    centers: tuple[slice, ...]
    inertias: tuple[slice, ...]
    lines: tuple[tuple[int, int] | None, ...]
    matter: Matter


def bodies_of(model: WholeModel, index: dict[str, int], matter: Matter) -> tuple[Bodies, dict[str, Any]]:
    """The bodies with mass, and their numbers."""
    names = tuple(name for name, body in model.bodies.items() if body.mass)
    bodies = [model.bodies[name] for name in names]
    beams = [beam for _, beam in sound_beams(model) if beam.kind == "rigid"] if model.beams else []
    heavy = [(beam, body) for beam, body in zip(beams, rigid_beams(model), strict=True) if body.mass] if beams else []
    if not (bodies or heavy):
        return Bodies(
            dim=model.dim, names=(), nodes=(), records=(), centers=(), inertias=(), lines=(), matter=matter
        ), _NO_NUMBERS
    centers, inertias = ([_flat(getattr(body, name)) for body in bodies] for name in ("center", "inertia"))
    found = Bodies(
        dim=model.dim,
        names=names,
        nodes=tuple([index[name] for name in body.carried_by(model.dim)] for body in [*bodies, *(body for _, body in heavy)]),
        records=tuple(bodies),
        centers=_slices(centers),
        inertias=_slices(inertias),
        lines=tuple(None if beam.mass is not None else matter.of(beam) for beam, _ in heavy),
        matter=matter,
    )
    return found, {
        "body_mass": np.array(
            [*(body.mass for body in bodies), *(one.mass for one, _ in heavy if one.mass is not None)], float
        ),
        "body_center": np.concatenate([*centers, np.zeros(0)]),
        "body_inertia": np.concatenate([*inertias, np.zeros(0)]),
    }


_NOWHERE = np.zeros(0, np.int32)
_NO_NUMBERS = dict.fromkeys(("body_mass", "body_center", "body_inertia"), np.zeros(0))


def _flat(given: Any) -> NDArray[np.float64]:
    return np.zeros(0) if given is None else np.array(given, float).reshape(-1)


def _slices(parts: list[NDArray[np.float64]]) -> tuple[slice, ...]:
    ends = np.cumsum([0, *map(len, parts)]).tolist()
    return tuple(slice(*pair) for pair in pairwise(ends))


def centers_of(bodies: Bodies, numbers: Numbers) -> dict[str, Array]:
    """Centres (dim,) of the bodies for which one is given, in their frames, as "body NAME center"."""
    given = zip(bodies.names, bodies.centers, strict=True)
    return {f"body {name} center": numbers["body_center"][..., at] for name, at in given if at.start < at.stop}


def pair_arrays(bodies: Bodies, numbers: Numbers, x0: Array) -> dict[str, Any]:
    """pair_p, pair_q, pair_mass, pair_skew and thin of `System`, at places x0 (n, 3)."""
    pairs: list[tuple[int, int]] = []
    mass, turn = [numbers.full(0)], [numbers.full(0)]
    thin = np.zeros(x0.shape[-2], np.bool_)
    if not bodies.nodes:
        return {"pair_p": _NOWHERE, "pair_q": _NOWHERE, "pair_mass": mass[0], "pair_skew": turn[0], "thin": thin}
    for nodes, (m, skew) in zip(bodies.nodes, _masses(bodies, numbers, x0), strict=True):
        i, j = np.triu_indices(len(nodes))
        between = m[..., i, j]
        turning = np.where(i != j, skew[..., None], 0.0)
        kept = np.flatnonzero(chosen((between != 0.0) | (turning != 0.0), "masses of bodies that are 0"))
        pairs += [(nodes[a], nodes[b]) for a, b in zip(i[kept], j[kept], strict=True)]
        mass.append(between[..., kept])
        turn.append(turning[..., kept])
        first = (0,) * (m.ndim - 2)
        thin[nodes] |= _is_thin(m[first].real, skew[first].real)
    p, q = np.array(pairs, np.int32).reshape(-1, 2).T
    return {
        "pair_p": np.ascontiguousarray(p),
        "pair_q": np.ascontiguousarray(q),
        "pair_mass": np.concatenate(mass, axis=-1),
        "pair_skew": np.concatenate(turn, axis=-1),
        "thin": thin,
    }


def _masses(bodies: Bodies, numbers: Numbers, x0: Array) -> list[tuple[Array, Array]]:
    """Masses (copies, k, k) between the nodes of each body, and the skew part of two of the plane, kg."""
    given, found = iter(numbers.each("body_mass")), []
    count = len(bodies.records)
    for nodes, body, *own in zip(bodies.nodes[:count], bodies.records, bodies.centers, bodies.inertias, strict=True):
        center, inertia = (numbers[name][..., at] for name, at in zip(("body_center", "body_inertia"), own, strict=True))
        points = x0[..., nodes, : bodies.dim]
        mass: Any = np.asarray(next(given))
        m, skew = numbers.full(len(nodes), len(nodes)), numbers.full()
        for k in np.ndindex(numbers.lead):
            m[k], skew[k] = _mass(body, mass[k], center[k], inertia[k], points[k])
        found.append((m, skew))
    shapes = bodies.matter.shapes(numbers) if any(bodies.lines) else []
    for nodes, line in zip(bodies.nodes[count:], bodies.lines, strict=True):
        if line is None:
            mass = next(given)
        else:
            length = apart(*(x0[..., node, : bodies.dim] for node in nodes))
            mass = numbers["density"][..., line[1]] * shapes[line[0]].area * length
        mass = np.asarray(mass)[..., None, None]
        found.append((uniform(mass, len(nodes)), numbers.full()))
    return found


def _mass(body: Body, mass: Any, center: Array, inertia: Array, points: Array) -> tuple[Array, Any]:
    """m_ij and the skew part of a body with these numbers.

    Of complex numbers, to first order: the masses are linear in mass and inertia, and shifts of the carriers against the body
    change the coordinates L of its points by -E L, so that m_ij = int L_i L_j dm changes by -(E m + m E^T).
    """
    given = (mass, center, inertia, points)
    m, skew = _real_mass(body, *(one.real for one in given))
    if not any(one.imag.any() for one in given):
        return m, skew
    dm, dskew = _real_mass(body, mass.imag, center.real, inertia.imag, points.real)
    if body.center is not None:
        # what the carriers move against the centre
        moved = points.imag - placed(body.frame, points.shape[1])[1].T @ center.imag
        if points.shape[1] == 2 == len(points):
            # complex coordinates of the plane, z = L_1 z_1 + L_2 z_2, of which the skew part is the imaginary one
            (a, b), shift = points.real @ (1, 1j), moved @ (1, 1j)
            E, H = np.outer((-1, 1), shift / (b - a)), m + 1j * np.array([[0, skew], [-skew, 0]])
            dH = -(E.conj() @ H + H @ E.T)
            dm, dskew = dm + dH.real, dskew + dH[0, 1].imag
        else:
            E = np.stack([fixed_vector(points.real, one)[0] for one in moved], axis=1)
            dm = dm - (E @ m + m @ E.T)
    return m + 1j * dm, skew + 1j * dskew


def _real_mass(body: Body, mass: Any, center: Array, inertia: Array, points: Array) -> tuple[Array, float]:
    """`body_mass` of a body with other numbers."""
    own = SimpleNamespace(
        mass=float(mass),
        center=None if body.center is None else center,
        inertia=None if body.inertia is None else inertia.reshape(np.shape(body.inertia)),
        frame=body.frame,
        carried_by=lambda dim: range(len(points)),  # noqa: ARG005
    )
    return body_mass(SimpleNamespace(dim=points.shape[1], nodes=[SimpleNamespace(at=one) for one in points]), own)  # type: ignore[arg-type]


def _is_thin(m: NDArray[np.float64], skew: float) -> bool:
    """True if the matrix of a body has a direction without inertia."""
    values = np.linalg.eigvalsh(m + 1j * np.triu(np.full_like(m, skew), 1) - 1j * np.tril(np.full_like(m, skew), -1))
    return bool(values[0] <= THIN * values[-1])
