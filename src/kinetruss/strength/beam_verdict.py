"""Elastic beams and links in a verdict: their highest von Mises stress along the length, and their largest compression."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display.ranks import place_of_largest
from kinetruss.mechanics import System, cached, compile
from kinetruss.model import Piece
from kinetruss.results import Forces
from kinetruss.strength.beam_spans import Spans, spans_of
from kinetruss.strength.beam_stresses import along_elements, known_positions, loads_of, on_beams
from kinetruss.strength.link_columns import columns_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Result


SECTIONS = 97
SECTIONS = 97
"""Sections at which a beam is judged at least, besides those where loads begin, end or act: a parabola is at most 1.1e-4 higher
between them."""
BEAM_QUANTITIES = ("tension", "compression", "bending", "stress", "combined")
BENT = "not checked: a bent link buckles with the whole structure, by an analysis of its own (statics.buckling)"
STABILITY = "not checked: a beam buckles with the whole structure, by an analysis of its own (statics.buckling)"
BARE = "not checked: no section, or no material"
UNKNOWN = (
    "not checked: the positions are not those that the loads bend it to, and balance alone does not decide the forces of a "
    "redundant structure; elastic statics has them (in the model file: statics.linear)"
)


def beam_parts(model: Model) -> tuple[str, ...]:
    """Names of the elastic beams and of links, which follow the bars in a verdict."""
    return _names(compile(model))


@cached()
def _names(system: System) -> tuple[str, ...]:
    return (*spans_of(system).names, *spans_of(system).bare)


def chord_of(name: str) -> str:
    """The bar that shows a beam in pictures."""
    return f"{name}.chord"


def chords_of(model: Model, name: str) -> list[str]:
    """The bars that show a beam or a link in pictures: of a link one between each two pins."""
    whole = model.whole
    return [chord_of(one) for one, beam in whole.beams.items() if name == (beam.link if isinstance(beam, Piece) else one)]


def beam_histories(model: Model, forces: Forces, stations: int = SECTIONS) -> dict[str, tuple[NDArray[np.float64], ...]]:
    """Of each of `BEAM_QUANTITIES` its largest value along the beams, and the fraction of the length where, (times, beams).

    tension, compression N (negative if the other sign holds throughout), bending N m (resultant), stress Pa (von Mises),
    combined compression and bending of straight links, of 1.
    NaN of positions that are not in balance.
    """
    shape = (len(forces.arrays["time"].values), len(beam_parts(model)))
    spans = spans_of(compile(model))
    if not shape[0] or not spans.names or not known_positions(forces):
        nothing = np.full(shape, np.nan)
        return dict.fromkeys(BEAM_QUANTITIES, (nothing, nothing))
    xi = stations_of(compile(model), forces.load_case, max(stations, SECTIONS))
    found, _, _ = along_elements(model, forces, xi)
    T, M = found["section_T"], np.linalg.norm(found["section_M"], axis=-1)
    along = dict(zip(BEAM_QUANTITIES[:4], (T, -T, M, found["von_mises"]), strict=True))
    of_spans = {name: _of_spans(spans, *_largest(values, xi)) for name, values in along.items()}
    of_spans["combined"] = _combined(model, found["section_M"], of_spans["compression"][0], xi)
    more = ((0, 0), (0, len(spans.bare)))
    return {
        name: (np.pad(values, more, constant_values=np.nan), np.pad(place, more)) for name, (values, place) in of_spans.items()
    }


def _combined(
    model: Model, M: NDArray[np.float64], push: NDArray[np.float64], xi: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Compression with bending of the columns among beams and links, and the fraction of the length where, (times, spans), from
    moments M (times, elements, stations, axes) and largest compressions (times, spans).
    """
    system = compile(model)
    spans, columns, safety = spans_of(system), columns_of(system), model.safety.buckling
    value, place = np.full(M.shape[:3], np.nan), np.zeros(M.shape[:2])
    for k, of in enumerate(spans.of.tolist()):
        if columns.ends[of]:
            value[:, k] = columns.combined(of, push[:, of], M[:, k], safety)
    worst, place = _largest(np.nan_to_num(value, nan=-np.inf, posinf=np.inf), xi)
    return _of_spans(spans, np.where(np.isneginf(worst), np.nan, worst), place)


def _of_spans(
    spans: Spans, values: NDArray[np.float64], place: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Values (times, elements) and their fractions of the element as those of whole beams and links."""
    if not spans.parted:
        return values, place
    place = (spans.start + place * spans.length) / spans.total[spans.of]
    worst = []
    for name in spans.names:
        own = spans.elements(name)
        worst.append(own[np.nan_to_num(values[:, own], nan=-np.inf).argmax(axis=1)])
    at = np.stack(worst, axis=1)
    return np.take_along_axis(values, at, axis=1), np.take_along_axis(place, at, axis=1)


def middle_forces(model: Model, result: Forces | Result) -> NDArray[np.float64]:
    """Axial forces ((times,) members), N, of forces or of an equilibrium; on the chords of elastic beams those in their middle,
    NaN where they are not known, and on those of rigid beams.
    """
    data = result.arrays if isinstance(result, Forces) else result.whole
    found, beams = np.array(data["member_force"].values, float), model.whole.beams
    members = list(model.whole.members)
    found[..., [members.index(chord_of(beam)) for beam in beams]] = np.nan
    columns = [members.index(chord_of(name)) for name, beam in beams.items() if beam.kind == "elastic"]
    if columns and (not isinstance(result, Forces) or known_positions(result)):
        values = along_elements(model, result, np.array([0.5]))[0]["section_T"][..., 0]
        found[..., columns] = values if found.ndim > 1 else values[0]
    return found


@cached()
def stations_of(system: System, case: str, count: int) -> NDArray[np.float64]:
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
    model, strength = system.model, []
    spans = spans_of(system)
    for record in spans.records:
        material = model.material_of(record)
        known = None if material is None else material.yield_strength
        strength.append(np.nan if known is None else known / model.safety.yielding)
    bare = [*spans.bare.values()]
    return np.append(strength, np.full(len(bare), np.nan)), np.append(spans.total, bare)


def beam_limits(model: Model) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Allowed stress (beams,), Pa, NaN if it is not known, and length, m."""
    return _limits(compile(model))


def beam_notes(
    model: Model, stress: NDArray[np.float64], compression: NDArray[np.float64], combined: NDArray[np.float64]
) -> NDArray[np.object_]:
    """Notes over (beam, rule) of the largest stress and compression, and of both in one rule, (beams,); NaN if not known."""
    columns = columns_of(compile(model))
    names = beam_parts(model)
    found = np.full((len(names), 3), "", dtype=object)
    for k, name in enumerate(names):
        if name in spans_of(compile(model)).bare:
            found[k, :2] = BARE
            continue
        if np.isnan(compression[k]):
            found[k, :2] = UNKNOWN
            continue
        if np.isnan(beam_limits(model)[0][k]):
            found[k, 0] = "not checked: no yield strength"
        elif np.isnan(stress[k]):
            section = model.section_of(spans_of(compile(model)).records[k])
            found[k, 0] = f"not checked: no shear stress of torsion of a {getattr(section, 'kind', '')} section"
        found[k, 1] = (BENT if name in model.links else STABILITY) if compression[k] > 0 else "never in compression"
        if compression[k] > 0 and columns.ends[k]:
            found[k, 1] = f"{'Johnson' if columns.johnson[k] else 'Euler'}, {columns.ends[k]}, over the whole length"
            if np.isnan(combined[k]):
                found[k, 2] = "not checked: no yield strength"
    return found
