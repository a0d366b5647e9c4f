"""Section forces and deflections as curves over a structure: on which side of members they are drawn, and their extremes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.dynamics.bar_actions import actions_of
from kinetruss.elements.loads.load import Spread
from kinetruss.elements.local_axes import local_axes
from kinetruss.errors import InputError, few
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.beam_forces import beam_frames
from kinetruss.model import nearest
from kinetruss.model.beam_frames import owner_of
from kinetruss.model.links import bends
from kinetruss.results import Forces
from kinetruss.strength.beam_stresses import along_elements, known_positions
from kinetruss.strength.beam_verdict import SECTIONS, chord_of, stations_of
from kinetruss.strength.parts import parts_of
from kinetruss.strength.section_forces import sections

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Result

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Quantity:
    """What a curve shows: words, unit, sign in words; of a section force the array and its component, and axis 2 or 3 of the
    member along which positive values are drawn, or against which (`side` -1).
    """

    words: str
    unit: str
    sign: str
    array: str = ""
    component: int = 0
    axis: int = 2
    side: int = 1


TWO, THREE = (f"drawn on the side of axis {axis} of the member if it is positive" for axis in (2, 3))
LEFT = "the left of the member as seen from its first end"
N = Quantity(
    words="axial force N", unit="N", sign="tension is positive (orange), compression negative (blue)", array="section_T"
)
PLANE = {
    "N": N,
    "V": Quantity(words="shear force V", unit="N", array="section_V",
                  sign=f"drawn to {LEFT} if it is positive, where the part behind a section pushes the part before it"),
    "M": Quantity(words="bending moment M", unit="N m", array="section_M", side=-1,
                  sign="drawn on the side in tension; positive if that is the right of the member as seen from its first end"),
}  # fmt: skip
SPACE = {
    "N": N,
    "V2": Quantity(words="shear force V₂", unit="N", array="section_V", sign=TWO),
    "V3": Quantity(words="shear force V₃", unit="N", array="section_V", component=1, axis=3,
                   sign=THREE),
    "M2": Quantity(words="bending moment M₂", unit="N m", array="section_M", axis=3,
                   sign="drawn on the side in tension: that of axis 3 of the member if it is positive"),
    "M3": Quantity(words="bending moment M₃", unit="N m", array="section_M", component=1, side=-1,
                   sign="drawn on the side in tension: opposite to axis 2 of the member if it is positive"),
    "torque": Quantity(words="torque", unit="N m", array="torsion", sign=TWO),
}  # fmt: skip
DEFLECTION = Quantity(words="deflection", unit="m", sign="its size from the structure without loads")
ALSO = {"T": "torque", "Vy": "V2", "Vz": "V3", "My": "M2", "Mz": "M3"}
"""Other names, with which the axes 2, 3 of a member are called y, z."""
MANY, FEWER = 60, 49
"""Number of parts above which curves have fewer stations, and these."""
ROUND_OFF = 1e-9
"""Share of the largest force, and of that force on the length of the structure, up to which a value is 0."""
NEXT = 1e-9
"""Distance of two stations, of the length, up to which they are the two sides of one place."""
SAME = 1e-6
"""Relative difference up to which a curve is a constant."""
HIGHEST = 0.13
"""Height of the largest value over the structure, of its size."""
SMALL = 0.02
"""Share of the largest value of all up to which an extreme is not one that is written."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Curve:
    """A quantity along one part: name of the part, and its member as an index; places x (s,), m from end A of the member; base
    (s, dim), m, its axis; shift (s, dim), the value as a vector across it (of a deflection the displacement); values (s,);
    extremes : the indices of the least and the largest value that are written.
    """

    part: str
    member: int
    x: Array
    base: Array
    shift: Array
    values: Array
    extremes: tuple[int, ...]

    def tips(self, factor: float) -> Array:
        """The curve (s, dim), m, with m a unit of the quantity, or of a deflection how many times as large it is drawn."""
        return self.base + factor * self.shift


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Curves:
    """A quantity along all members at one instant. show : its name; unknown : parts without values."""

    show: str
    quantity: Quantity
    curves: tuple[Curve, ...]
    unknown: tuple[str, ...]

    @property
    def largest(self) -> float:
        """The largest magnitude."""
        return max((float(np.abs(one.values).max()) for one in self.curves), default=0.0)


def only(forces: Forces, sample: int) -> Forces:
    """Forces of one sample, with their motion."""
    here = {"time": [sample]}
    motion = forces.motion.with_(data=forces.motion.whole.isel(here))
    return forces.with_(data=forces.whole.isel(here), motion=motion, static=None)


def quantities_shown(dim: int) -> dict[str, Quantity]:
    """What can be drawn over a structure: N, V, M in the plane; N, V2, V3, M2, M3, torque in space; deflection."""
    return (PLANE if dim == 2 else SPACE) | {"deflection": DEFLECTION}


def curves(model: Model, forces: Forces, show: str, *, from_model: bool = False) -> Curves:
    """N, V, M or the deflection along all members at one instant, with their largest values.

    Parameters
    ----------
    forces : of one sample. show : in the plane ``N``, ``V``, ``M``; in space ``N``, ``V2`` and ``V3`` (also ``Vy``, ``Vz``)
    along the axes 2 and 3 of members, ``M2`` and ``M3`` (``My``, ``Mz``) about them, ``torque`` (``T``); or ``deflection``.
    from_model : the loads alone have moved the positions of the forces away from the model, as in an equilibrium; else
    deflections are known only of `statics.linear`.

    Returns
    -------
    Curves. Values are those of `strength.sections` and `strength.beams`, N, N m and m, with their signs. Extremes between
    stations are those of parabolas: exact under uniform loads, else to 1e-5. Values that are round-off are 0.

    Raises
    ------
    InputError : an unknown quantity; no member with section forces; deflections that are not known.

    Examples
    --------
    >>> import kinetruss as kt
    >>> beam = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, beams={"b": ("A", "B")}, material="steel_s235",
    ...     section=kt.Rod(diameter=0.1), loads={"q": kt.MemberLoad(member="b", force=(0, -800))}, gravity=(0, 0),
    ...     runs={"rest": kt.Run(analysis="statics.linear")},
    ... )
    >>> run = kt.run(beam)
    >>> (found,) = curves(run.model, run.forces["all"], "M").curves
    >>> [(round(found.x[k].item(), 9), round(found.values[k].item(), 9)) for k in found.extremes]
    [(1.0, 400.0)]
    """
    known = quantities_shown(model.dim)
    show = {"V2": "V", "M3": "M", "Vy": "V", "Mz": "M"}.get(show, show) if model.dim == 2 else ALSO.get(show, show)
    if show not in known:
        raise InputError(f"Nothing called {show!r} can be drawn over the structure. {nearest(show, known)}")
    deflected, quantity = show == "deflection", known[show]
    if deflected and not from_model and "displacement" not in forces.arrays:
        raise InputError(
            "The deflection is not known: these are forces of given positions. Run statics.linear or statics.equilibrium; "
            "along a motion statics.deflection has that of the nodes."
        )
    system = compile(model)
    found = [*_of_beams(model, system, forces, deflected=deflected), *_of_bars(model, system, forces, deflected=deflected)]
    if not found:
        raise InputError("No member has section forces: there are no bars, beams or links with a section.")
    force = max((float(np.abs(one.get(name, 0.0)).max()) for *_, one in found for name in ("section_T", "section_V")
                 if not np.isnan(one.get(name, 0.0)).any()), default=0.0)  # fmt: skip
    reach = float(np.ptp(system.x0, axis=0).max())
    least = {"N": ROUND_OFF * force, "N m": ROUND_OFF * force * reach, "m": 0.0}[quantity.unit]
    made = []
    unknown = [name for name, one in model.bending.items() if not bends(model, one)]
    for part, member, x, edges, base, axes, values in found:
        if deflected:
            shift, size = values["displacement"], np.linalg.norm(values["displacement"], axis=1)
        else:
            size = _component(values, quantity)
            size = np.where(np.abs(size) <= least, 0.0, size)
            shift = size[:, None] * (quantity.side * axes[quantity.axis - 1])[: model.dim]
        if np.isnan(size).any():
            unknown.append(part)
            continue
        made.append(_curve(part, member, x, base, shift, size, edges))
    largest = max((float(np.abs(one.values).max()) for one in made), default=0.0)
    written = tuple(_written(one, SMALL * largest) for one in made)
    return Curves(show=show, quantity=quantity, curves=written, unknown=tuple(dict.fromkeys(unknown)))


Found = tuple[str, int, "Array", "Array", "Array", "Array", dict[str, "Array"]]
"""Part, member, x (s,), places where loads begin, end or act, base (s, dim), axes (3, 3), values (s, ..) by array."""


def _component(values: dict[str, Array], quantity: Quantity) -> Array:
    if quantity.array not in values:  # bars without a couple about their axes
        return np.zeros(len(values["section_T"]))
    array = values[quantity.array]
    return array if array.ndim == 1 else array[:, quantity.component]


def _count(system: System) -> int:
    return SECTIONS if len(system.members) <= MANY else FEWER


def _edges(system: System, xi: Array) -> Array:
    """Those of the fractions xi at which loads on beams begin, end or act."""
    return np.setdiff1d(xi, np.linspace(0.0, 1.0, _count(system)))


def _of_beams(model: Model, system: System, forces: Forces, *, deflected: bool) -> Iterator[Found]:
    """Each elastic beam, and each part of a link between two pins."""
    beams: Any = None if system.continua is None else system.continua.beams
    if beams is None:
        return
    xi = stations_of(system, forces.load_case, _count(system))
    edges = _edges(system, xi)
    known = known_positions(forces)
    values = along_elements(model, forces, xi, deflected=deflected)[0] if known else {}
    at = np.zeros((1, *system.x0.shape))
    # deflections are drawn from the place without loads
    at[..., : model.dim] = system.x0[:, : model.dim] if deflected else forces.motion.whole["position"].values
    base = np.einsum("kgv,kvc->kgc", beams.along(xi), at[0][beams.nodes])[..., : model.dim]
    frame = beam_frames(beams, at)[0]
    for k, name in enumerate(beams.names):
        own = {key: one[0, k] for key, one in values.items() if one.ndim >= 3 and one.shape[2] == len(xi)}
        own = own or {key: np.full(len(xi), np.nan) for key in ("section_T", "section_V", "section_M", "torsion")}
        member, owner = system.members.index(chord_of(name)), owner_of(name, model.whole.beams[name]).name
        yield owner, member, xi * float(beams.length[k]), edges * float(beams.length[k]), base[k], frame[k], own


def _of_bars(model: Model, system: System, forces: Forces, *, deflected: bool) -> Iterator[Found]:
    """Bars, and the rods and tubes of active members."""
    parts = parts_of(model)
    inner = model.whole.inner.bars
    names = [name for name in parts.names if name.rpartition(".")[0] not in model.bending and name not in inner]
    if not names:
        return
    ends = {s for one in actions_of(system, forces.load_case).actions if isinstance(one.place, Spread) for s in one.place[:2]}
    if "action_place" in forces.arrays:
        ends |= {float(s) for s in forces.arrays["action_place"].values[0] if not np.isnan(s)}
    sides = [side for s in ends for side in (s, np.nextafter(s, 2.0))]
    xi = np.unique(np.clip([*np.linspace(0.0, 1.0, _count(system)), *sides], 0.0, 1.0))
    data = sections(model, forces, stations=xi).arrays
    place_of = forces.motion.whole["position"].values[0]
    moved = forces.arrays["displacement"].values[0] if deflected and "displacement" in forces.arrays else None
    if deflected and moved is None:
        moved, place_of = place_of - system.x0[:, : model.dim], system.x0[:, : model.dim]
    p, q = place_of[system.p], place_of[system.q]
    axes = local_axes(system, forces.motion.whole["position"].values)[0]
    place = {name: k for k, name in enumerate(map(str, data["part"].values))}
    for name in names:
        k, member = place[name], system.members.index(str(data["member"].values[place[name]]))
        start, length = (float(data[key].values[0, k]) for key in ("part_start", "part_length"))
        x = start + xi * length
        share = (x / np.linalg.norm(q[member] - p[member]))[:, None]
        base = (1.0 - share) * p[member] + share * q[member]
        own = {key: data[key].values[0, k] for key in ("section_T", "section_V", "section_M", "torsion") if key in data}
        if moved is not None:
            own["displacement"] = (1.0 - share) * moved[system.p[member]] + share * moved[system.q[member]]
        yield name, member, x, start + np.array(sorted(ends)) * length, base, axes[member], own


def extremes(x: Array, values: Array, edges: Array) -> Array:
    """Least value, its place, largest value, its place, (.., 4), of values (.., s) at places x (s,).

    Each is at a station, or at the top of the parabola through three stations next to each other, between which no load begins,
    ends or acts (edges).
    """
    found = []
    width, whole = np.minimum(x[1:-1] - x[:-2], x[2:] - x[1:-1]), x[-1] - x[0]
    within = np.searchsorted(edges, x[2:], "left") - np.searchsorted(edges, x[:-2], "right")  # edges between both outer ones
    smooth: Any = (width > NEXT * whole) & (within == 0)
    for sign in (-1.0, 1.0):
        f = sign * np.nan_to_num(values)
        k = f.argmax(axis=-1)
        best, place = np.take_along_axis(f, k[..., None], axis=-1)[..., 0], x[k]
        settled = np.zeros(k.shape, bool)
        for before in (1, 2, 0):  # beside the station only where a load begins, ends or acts there
            at = np.clip(k - before, 0, len(smooth) - 1)
            a, b, c = (x[at + step] for step in (0, 1, 2))
            fa, fb, fc = (np.take_along_axis(f, (at + step)[..., None], axis=-1)[..., 0] for step in (0, 1, 2))
            with np.errstate(divide="ignore", invalid="ignore"):
                rise = (fb - fa) / (b - a)
                curved = ((fc - fb) / (c - b) - rise) / (c - a)
                top = (a + b) / 2 - rise / (2 * curved)
                value = fa + rise * (top - a) + curved * (top - a) * (top - b)
            better = ~settled & smooth[at] & (curved < 0) & (top > a) & (top < c) & (value > best + SAME**2 * np.abs(best))
            best, place = np.where(better, value, best), np.where(better, top, place)
            settled = settled | ((before == 1) & smooth[at] & (k > 0) & (k < len(x) - 1))
        found += [sign * best, place]
    every = np.stack(found, axis=-1)
    return np.where(np.isnan(values).any(axis=-1, keepdims=True), np.nan, every)


def _curve(part: str, member: int, x: Array, base: Array, shift: Array, values: Array, edges: Array) -> Curve:
    """The curve with its least and largest value among its places."""
    every = extremes(x, values, edges)
    for value, at in every.reshape(2, 2).tolist():
        if at in x:
            continue
        k = int(np.searchsorted(x, at))
        share = (at - x[k - 1]) / (x[k] - x[k - 1])
        between = [one[k - 1] + share * (one[k] - one[k - 1]) for one in (base, shift, values)]
        x, values = np.insert(x, k, at), np.insert(values, k, value)
        base = np.insert(base, k, between[0], axis=0)
        shift = np.insert(shift, k, between[1] * (value / between[2] if between[2] else 1.0), axis=0)
    found = tuple(int(np.abs(x - at).argmin()) for at in every[1::2])
    return Curve(part=part, member=member, x=x, base=base, shift=shift, values=values, extremes=found)


def beam_tables(model: Model, result: Forces | Result, stations: int, *, deflected: bool) -> dict[str, Array]:
    """What a scene has of elastic beams and the parts of links; NaN where it is not known.

    ``section`` (times, beams, stations, values) at equal distances, their number less 1 a divisor of 48: N, V, M in the plane,
    N, V2, V3, M2, M3, torque in space, N and N m, then von Mises' stress, Pa. ``extreme`` (times, beams, quantities, 4) :
    least value, its place, largest value, its place, as fractions, of the same but the stress, if `deflected` also of the size
    of the displacement, m; then also ``moved`` (times, beams, stations, dim), m, the displacement.
    """
    system = compile(model)
    beams: Any = cast(Any, system.continua).beams
    case = getattr(result, "load_case", None) or str(result.provenance.get("load_case"))
    xi, own = stations_of(system, case, _count(system)), [one for one in quantities_shown(model.dim).values() if one.array]
    if isinstance(result, Forces) and not known_positions(result):
        shape = result.whole.sizes["time"], len(beams.names)
        found = {"section": np.full((*shape, stations, len(own) + 1), np.nan)}
        return found | {"extreme": np.full((*shape, len(own) + deflected, 4), np.nan)}
    values = along_elements(model, result, xi, deflected=deflected)[0]
    rows = [values[one.array] if values[one.array].ndim == 3 else values[one.array][..., one.component] for one in own]
    few = np.searchsorted(xi, np.linspace(0.0, 1.0, stations) - NEXT)
    found = {"section": np.stack([*rows, values["von_mises"]], axis=-1)[:, :, few]}
    if deflected:
        rows.append(np.linalg.norm(values["displacement"], axis=-1))
        found["moved"] = values["displacement"][:, :, few]
    return found | {"extreme": extremes(xi, np.stack(rows, axis=2), _edges(system, xi))}


def _written(one: Curve, least: float) -> Curve:
    """The curve with those extremes that are written: the larger of two with one sign, in the middle of a constant, none that
    is small.
    """
    chosen = [k for k in dict.fromkeys(one.extremes) if abs(one.values[k]) > least]
    if len(chosen) == 2 and one.values[chosen[0]] * one.values[chosen[1]] > 0:
        chosen = [max(chosen, key=lambda k: abs(one.values[k]))]
        if np.ptp(one.values) <= SAME * abs(one.values[chosen[0]]):
            chosen = [int(np.abs(one.x - (one.x[0] + one.x[-1]) / 2).argmin())]
    return replace(one, extremes=tuple(chosen))


def sentence(found: Curves) -> str:
    """What a picture of curves says of itself: the quantity with its sign, and parts without values."""
    words = f"{found.quantity.words[0].upper()}{found.quantity.words[1:]}: {found.quantity.sign}"
    return f"{words}; not known of {few(list(found.unknown), 4)}" if found.unknown else words


def factor_of(found: Sequence[Curves], extent: float) -> float:
    """How much of the structure, m, a unit of the quantity takes: the same in all pictures, so that they can be compared; a
    round number of deflections.
    """
    largest = max((one.largest for one in found), default=0.0)
    if not largest > 0:
        return 0.0
    factor = HIGHEST * (extent or 1.0) / largest
    if found[0].show != "deflection":
        return factor
    power = 10.0 ** np.floor(np.log10(factor))
    return float(power * max(step for step in (1, 2, 5) if step * power <= factor * (1 + 1e-9)))
