"""Elastic beams in a verdict: their highest von Mises stress along the length, and their largest compression."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display.ranks import place_of_largest
from kinetruss.mechanics import System, cached, compile
from kinetruss.results import Forces
from kinetruss.strength.beam_stresses import beams, known_positions, loads_of, on_beams

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Result


SECTIONS = 97
"""Sections at which a beam is judged at least, besides those where loads begin, end or act: a parabola is at most 1.1e-4 higher
between them."""
BEAM_QUANTITIES = ("tension", "compression", "bending", "stress")
STABILITY = "not checked: a beam buckles with the whole structure, by an analysis of its own (statics.buckling)"
UNKNOWN = "not checked: the positions are not those of a structure in balance, so beams have no forces (statics.equilibrium)"


def beam_parts(model: Model) -> tuple[str, ...]:
    """Names of the elastic beams, which follow the bars in a verdict."""
    return _names(compile(model))


@cached()
def _names(system: System) -> tuple[str, ...]:
    return tuple(name for name, beam in system.model.beams.items() if beam.kind == "elastic")


def chord_of(name: str) -> str:
    """The bar that shows a beam in pictures."""
    return f"{name}.chord"


def beam_histories(model: Model, forces: Forces, stations: int = SECTIONS) -> dict[str, tuple[NDArray[np.float64], ...]]:
    """Of each of `BEAM_QUANTITIES` its largest value along the beams, and the fraction of the length where, (times, beams).

    tension, compression N (negative if the other sign holds throughout), bending N m (resultant), stress Pa (von Mises).
    NaN of positions that are not in balance.
    """
    shape = (len(forces.arrays["time"].values), len(beam_parts(model)))
    if not all(shape) or not known_positions(forces):
        nothing = np.full(shape, np.nan)
        return dict.fromkeys(BEAM_QUANTITIES, (nothing, nothing))
    found = beams(model, forces, stations=_stations(compile(model), forces.load_case, max(stations, SECTIONS)))
    xi, T = found["station"].values, found["section_T"].values
    M = np.linalg.norm(found["section_M"].values, axis=-1)
    along = dict(zip(BEAM_QUANTITIES, (T, -T, M, found["von_mises"].values), strict=True))
    return {name: _largest(values, xi) for name, values in along.items()}


def middle_forces(model: Model, result: Forces | Result) -> NDArray[np.float64]:
    """Axial forces ((times,) members), N, of forces or of an equilibrium; on the chords of elastic beams those in their middle,
    NaN where they are not known, and on those of rigid beams.
    """
    data = result.arrays if isinstance(result, Forces) else result.whole
    found, names = np.array(data["member_force"].values, float), beam_parts(model)
    members = list(model.whole.members)
    found[..., [members.index(chord_of(beam)) for beam in model.beams]] = np.nan
    if names:
        columns = [members.index(chord_of(name)) for name in names]
        if not isinstance(result, Forces) or known_positions(result):
            found[..., columns] = beams(model, result, stations=[0.5])["section_T"].values[..., 0]
    return found


def beam_sections(model: Model, result: Forces | Result, stations: int) -> NDArray[np.float64]:
    """Section forces (times, beams, stations, values) of forces or of an equilibrium, at equal distances along elastic beams:
    T, V2, M3 in the plane, T, V2, V3, M2, M3 and the torsion in space, N and N m, then von Mises' stress, Pa; NaN where they
    are not known.
    """
    shape = (-1, len(beam_parts(model)), stations, 4 if model.dim == 2 else 7)
    if isinstance(result, Forces) and not known_positions(result):
        return np.full((len(result.arrays["time"].values), *shape[1:]), np.nan)
    found = beams(model, result, stations=stations)
    names = ("section_T", "section_V", "section_M", "torsion", "von_mises")
    parts = [found[name].values for name in names if name in found]
    several = [one if one.ndim > parts[0].ndim else one[..., None] for one in parts]
    return np.asarray(np.concatenate(several, axis=-1)).reshape(shape)


@cached()
def _stations(system: System, case: str, count: int) -> NDArray[np.float64]:
    """Sections at equal distances, and on both sides of the places where loads begin, end or act."""
    cases = case if case in system.model.cases else None
    places = {float(s) for name in loads_of(system, cases) for one in on_beams(system, name) for s in (one.begin, one.end)}
    sides = [side for s in places for side in (s, min(1.0, np.nextafter(s, 2.0)))]
    return np.unique(np.clip([*np.linspace(0.0, 1.0, count), *sides], 0.0, 1.0))


def _largest(values: NDArray[np.float64], xi: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    at = np.asarray(place_of_largest(values, axis=-1))
    return np.take_along_axis(values, at[..., None], axis=-1)[..., 0], xi[at]


@cached()
def _limits(system: System) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Allowed stress, Pa, NaN if it is not known, and length, m, of each elastic beam."""
    model, strength, length = system.model, [], []
    for name in _names(system):
        beam = model.beams[name]
        material = model.material_of(beam)
        known = None if material is None else material.yield_strength
        strength.append(np.nan if known is None else known / model.safety.yielding)
        length.append(math.dist(*(model.nodes[end].at for end in beam.ends)))
    return np.array(strength), np.array(length)


def beam_limits(model: Model) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Allowed stress (beams,), Pa, NaN if it is not known, and length, m."""
    return _limits(compile(model))


def beam_notes(model: Model, stress: NDArray[np.float64], compression: NDArray[np.float64]) -> NDArray[np.object_]:
    """Notes over (beam, rule) of the largest stress and compression (beams,), NaN if they are not known."""
    names = beam_parts(model)
    found = np.full((len(names), 3), "", dtype=object)
    for k, name in enumerate(names):
        if np.isnan(compression[k]):
            found[k, :2] = UNKNOWN
            continue
        if np.isnan(beam_limits(model)[0][k]):
            found[k, 0] = "not checked: no yield strength"
        elif np.isnan(stress[k]):
            section = model.section_of(model.beams[name])
            found[k, 0] = f"not checked: no shear stress of torsion of a {getattr(section, 'kind', '')} section"
        found[k, 1] = STABILITY if compression[k] > 0 else "never in compression"
    return found
