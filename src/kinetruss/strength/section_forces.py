"""Section forces along members, stresses as components, and their equivalent."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.dynamics import NotOnBars, not_on_bars
from kinetruss.errors import InputError, few
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.sections.peaks import section_von_mises
from kinetruss.kernels.sections.sections import section_forces
from kinetruss.limits import MOST_STATIONS, whole
from kinetruss.model import BodyCouple, Model
from kinetruss.results import Arrays, Axes, Forces, Sections, provenance, variable
from kinetruss.strength.parts import Parts, histories, parts_of, shear_of_torsion, torsion_of, with_torsion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


MOST = 6


def not_held(model: Model, cases: Iterable[str]) -> tuple[NotOnBars, ...]:
    """Actions on nodes of members with a section, once over all load cases, with these members only."""
    judged = set(parts_of(model).judged)
    found = {}
    for case in cases:
        for one in not_on_bars(model, case):
            if members := tuple(name for name in one.members if name in judged or name in model.bending):
                found[one.kind, one.source, one.nodes] = NotOnBars(
                    source=one.source, kind=one.kind, nodes=one.nodes, members=members
                )
    return tuple(found.values())


def screws_not_held(model: Model, cases: Iterable[str]) -> list[str]:
    """A sentence on screws whose torque hubs hold, but which no load of one of the cases brings there."""
    if model.dim == 2 or not model.hubs:
        return []
    every = {name: load.member for name, load in model.loads.items() if isinstance(load, BodyCouple) and load.member}
    given = [{every[name] for name in _loads_of(model, case) if name in every} for case in cases]
    armed = {arm.member for arms in model.whole.inner.arms.values() for arm in arms}
    names = [
        name
        for name, one in model.active.items()
        if one.screw is not None and name in armed and not all(name in own for own in given)
    ]
    screws = "screw" if len(names) == 1 else "screws"
    sentence = (
        f"Not included: the torque of the {screws} of {few(names, MOST)} about the axis, which twists base, tube and arms of "
        "hubs; actuators.screw_couples gives it as loads."
    )
    return [sentence] if names else []


def _loads_of(model: Model, case: str) -> Iterable[str]:
    chosen = model.cases[case].loads if case in model.cases else None
    return model.loads if chosen is None else chosen


def sentences(found: tuple[NotOnBars, ...]) -> list[str]:
    """One sentence for each: the action, its nodes, and the members that it may bend."""
    return [
        f"Not included: bending by {one.kind} {one.source!r}, which acts on nodes {few(one.nodes, MOST)} and not on one bar; "
        f"it may bend {few(one.members, MOST)}."
        for one in found
    ]


def add_to_notes(
    found: tuple[NotOnBars, ...], members: list[str], utilisation: NDArray[np.float64], said: NDArray[np.object_]
) -> None:
    """Add the note to the entries (subjects, rules) of these members that depend on bending: yield and beam-column."""
    for i, member in enumerate(members):
        by = list(dict.fromkeys(f"{one.kind} {one.source!r}" for one in found if member in one.members))
        for rule in (0, 2) if by else ():
            if said[i, rule] or utilisation[i, rule] == utilisation[i, rule]:
                said[i, rule] = "; ".join(filter(None, (said[i, rule], f"without bending by {few(by, MOST)}")))


# Section forces along members.


def sections(model: Model, forces: Forces, stations: int | ArrayLike = 7) -> Sections:
    """Axial force, shear and bending moment at stations along every bar, base rod and tube.

    Parameters
    ----------
    forces : from `dynamics.inverse` of the same model; ``forces.static`` gives the sections at rest.
    stations : how many, equally spaced with both ends; or fractions of the part's length from its end towards A, ascending.

    Returns
    -------
    Sections, exerted by the B-side part on the A-side part. ``section_T`` (time, part, station) N, tension positive;
    ``section_V`` (time, part, station, transverse) N; ``section_M`` (time, part, station, moment) N m; with couples that enter
    hubs through members (`BodyCouple.member`, `actuators.screw_couples`) ``torsion`` (time, part, station) N m; ``part_start``,
    ``part_length`` (time, part) m: where the part begins, from end A, and how long it is. Parts are the bars by name and
    ``NAME.base``, ``NAME.tube`` of active members; coordinate ``member`` holds the member of each part.

    Raises
    ------
    InputError : forces of another model, stations that are not fractions in ascending order.

    Notes
    -----
    Member axes: 1 from A to B. In the plane 2 is 1 turned by +90 deg and 3 is z. In space 3 = 1 x h and 2 = 3 x 1, where h
    points from A to the `orientation` node, or is global z (global x for members within 18 deg of z at the start); so 2 is the
    most upward direction across the member. Give an `orientation` node to a member that swings through its h.
    M3' = -V2 and M2' = V3 without rotary inertia; stress at (y, z) along 2 and 3 is T/A + M2 z/I2 - M3 y/I3.
    Where the couple of a drive acts at an end of a bar, the moment there is that couple: ``section_M`` at station 0 is taken
    just inside the end. The table of actions and their places is in docs/strength.md; ``message`` names actions that are not
    included. Up to the interface (the free end of the tube), sections of the base of an active member follow from the part on
    the side of A; beyond it, from the part on the side of its free end. A station at the interface belongs to the side of A.
    ``NAME.tube`` at station 0 is its clamped end. A planar body has no sections, since the distribution of its mass is
    unknown: NaN.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.strength.sections(model, forces, stations=3)
    >>> found.section_T.sel(part="strut").values[0].round(6).tolist()  # N, at 0, 1/2 and 1 of the length
    [-1000.0, -1000.0, -1000.0]
    """
    given = histories(model, forces)
    parts, xi = parts_of(model), fractions_of(stations)
    count, across = len(given.histories.position), 1 if model.dim == 2 else 2
    shape = (count, len(parts.names), len(xi))
    T, V, M = allocate(shape, (*shape, across), (*shape, across))
    section_forces(given.members, given.histories, given.allocate(1), xi, T, V, M)
    length, twist = forces.motion.arrays["length"].values, torsion_of(model, forces)
    station = ("time", "part", "station")
    data = {
        "section_T": variable(station, T, "N", "axial force, tension positive"),
        "section_V": variable((*station, "transverse"), V, "N", "shear force along 2, 3"),
        "section_M": variable((*station, "moment"), M, "N m", "bending moment about 2, 3"),
        "part_start": variable(("time", "part"), parts.starts(length), "m", "distance of the part from end A"),
        "part_length": variable(("time", "part"), parts.lengths(length), "m", "length of the part"),
    }
    if twist is not None:
        along = np.repeat(twist[:, :, None], len(xi), axis=2)
        data["torsion"] = variable(station, along, "N m", "torque about 1")
    axes = _axes(parts.names, parts.members, tuple(xi.tolist()), across)
    attrs = {"kind": "sections", "load_case": forces.load_case, "at_rest": int(forces.attrs.get("at_rest", 0))}
    found: Any = Arrays(axes, forces.arrays["time"].values, data, attrs)
    if "pose" in forces.arrays:  # names of poses at rest
        found = found.dataset.assign_coords(pose=forces.whole["pose"].variable).set_xindex("pose")
    return Sections(
        data=found,
        status=forces.status,
        message=" ".join([forces.message, *sentences(not_held(model, [forces.load_case]))]).strip(),
        provenance=provenance(model, load_case=forces.load_case),
    )


@lru_cache(maxsize=32)
def _axes(names: tuple[str, ...], members: tuple[str, ...], xi: tuple[float, ...], across: int) -> Axes:
    """Axes that do not change from call to call; indexing them takes as long as the forces of a short motion."""
    coords = {
        "part": np.array(names, dtype=object).astype(str),
        "member": ("part", np.array(members, dtype=object).astype(str)),
        "station": variable(("station",), np.array(xi), "", "fraction of the part's length from its end towards A"),
        "transverse": ["2", "3"][:across],
        "moment": ["2", "3"][-across:],
    }
    return Axes(coords)


def fractions_of(stations: int | ArrayLike) -> NDArray[np.float64]:
    """Stations as fractions of the length in ascending order, from their number or themselves."""
    if isinstance(stations, (int, np.integer)) and not isinstance(stations, bool):
        return np.linspace(0.0, 1.0, whole(stations, "stations", least=2, most=MOST_STATIONS))
    xi = array_of(stations, "stations", {}, {"stations": None}).reshape(-1)
    if not len(xi) or not np.all(np.diff(xi) >= 0) or not np.all((xi >= 0) & (xi <= 1)):
        raise InputError(f"stations {xi.tolist()} are not fractions from 0 to 1 in ascending order, e.g. [0, 0.25, 0.5, 1].")
    return xi


# Axial, bending and shear stresses as components.

_WORDS = {
    "axial": "mean axial stress T/A",
    "bending_2": "extreme fibre stress of M2",
    "bending_3": "extreme fibre stress of M3",
    "shear_2": "largest shear stress of V2",
    "shear_3": "largest shear stress of V3",
}


def components(model: Model, sections: Sections) -> xr.Dataset:
    """The five stress components at every station, in Pa and in microstrain.

    Returns
    -------
    Dataset over (time, part, station): ``axial`` = T/A, ``bending_2`` = M2 c3/I2, ``bending_3`` = M3 c2/I3, ``shear_2`` =
    k V2/A, ``shear_3`` = k V3/A, Pa, with the sign of the force or moment; the same with ``_microstrain``: stress/E, and
    stress/G for shear. In the plane ``axial``, ``bending_3``, ``shear_2``. NaN for parts without section (or material).

    Notes
    -----
    c2, c3 are the extreme fibres along axes 2, 3 and k the section's shear factor (largest over mean shear stress: 2 for
    a thin tube, 4/3 for a rod, 3/2 for a rectangle).

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.strength.components(model, kt.strength.sections(model, forces, stations=2))
    >>> found.axial.sel(part="strut").values.round(-3).tolist()  # Pa: -1000 N/314 mm^2
    [[-3183000.0, -3183000.0]]
    """
    parts = matching_parts(model, sections)
    stress = {"axial": sections.data["section_T"].values * _along(1 / parts.area)}
    for axis, modulus in (("2", parts.I2 / parts.c3), ("3", parts.I3 / parts.c2)):
        if axis in sections.data["moment"].values:
            stress[f"bending_{axis}"] = sections.data["section_M"].sel(moment=axis).values * _along(1 / modulus)
    for axis in sections.data["transverse"].values:
        stress[f"shear_{axis}"] = sections.data["section_V"].sel(transverse=axis).values * _along(parts.factor / parts.area)
    over = ("time", "part", "station")
    data = {name: variable(over, values, "Pa", _WORDS[name]) for name, values in stress.items()}
    for name, values in stress.items():
        stiffness = parts.G if name.startswith("shear") else parts.E
        strain = 1e6 * values / _along(stiffness)
        data[f"{name}_microstrain"] = variable(over, strain, "1e-6", f"strain of the {_WORDS[name]}")
    return xr.Dataset(data, coords=sections.data["section_T"].coords, attrs=sections.data.attrs | {"kind": "components"})


def matching_parts(model: Model, sections: Sections) -> Parts:
    """The parts of a model, after a check that the sections are of the same ones."""
    parts = parts_of(model)
    if list(sections.data["part"].values) != list(parts.names):
        raise InputError("The sections belong to a model with other members. Compute them for this model.")
    return parts


def _along(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (parts,) against (time, part, station)."""
    return values[None, :, None]


# Equivalent stresses of a section: the two classical points and the true maximum.


def stresses(
    model: Model,
    sections: Sections,
    *,
    bending: Literal["resultant", "2", "3"] = "resultant",
    shear_factor: float | None = None,
) -> xr.Dataset:
    """Equivalent stresses at every station, Pa, over (time, part, station).

    Parameters
    ----------
    bending : ``"resultant"``; or ``"2"`` or ``"3"`` to use only one bending moment in S2 (Lacy, 1991, planar points).
    shear_factor : for S1, instead of the section's own (Lacy: 2 everywhere).

    Returns
    -------
    ``S1``: von Mises stress on the neutral axis, sqrt((T/A)^2 + 3 (k V/A)^2) with the resultant V.
    ``S2``: outer fibre, |T|/A + |M| c/I with the resultant M of a round section, else the corner
    |T|/A + |M2| c3/I2 + |M3| c2/I3.
    ``von_mises``: the largest over the section, never below S1 and S2. NaN for parts without section. Torsion adds its
    largest shear stress tau to all three, to ``von_mises`` as a bound: sqrt(s^2 + 3 (2 k V/A tau + tau^2)), s without torsion,
    which is exact where V = 0; NaN for a section that does not know its shear stress of torsion.

    Notes
    -----
    The maximum over the section: round sections over the outer circle with the shear stress k V/A sin of the angle from V
    (exact for a thin tube, beam theory for a solid rod, between them on the safe side); rectangles over the whole section
    with parabolic shear; general sections by a bound (all bending and all shear at one point).
    Source: Lacy (1991, eq. 2.20 to 2.24); Timoshenko & Gere, Mechanics of Materials. S2 with one moment of two is up to 8 %
    too small in a double-octahedral bay; the resultant gives the stress of the fibre.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.strength.stresses(model, kt.strength.sections(model, forces, stations=2))
    >>> found.von_mises.sel(part="strut").values.round(-3).tolist()  # Pa: 1000 N/314 mm^2, nothing bends it
    [[3183000.0, 3183000.0]]
    """
    parts = matching_parts(model, sections)
    if bending not in ("resultant", "2", "3"):
        raise InputError(f"bending {bending!r} is not known. Write 'resultant', '2' or '3'.")
    nominal = components(model, sections)
    axial = np.abs(nominal["axial"].values)
    none = np.zeros_like(axial)
    b2, b3 = (np.abs(nominal[name].values) if name in nominal else none for name in ("bending_2", "bending_3"))
    k2, k3 = (nominal[name].values if name in nominal else none for name in ("shear_2", "shear_3"))
    shear = np.hypot(k2, k3)
    if shear_factor is not None:
        shear = shear * (shear_factor / parts.factor)[None, :, None]
    is_round = (parts.shape == 0)[None, :, None]
    fibre = {"resultant": np.where(is_round, np.hypot(b2, b3), b2 + b3), "2": b2, "3": b3}[bending]
    worst = np.empty_like(axial)
    T, V, M = (np.ascontiguousarray(sections.data[f"section_{name}"].values) for name in "TVM")
    section_von_mises(parts.shape, parts.scale, T, V, M, worst)
    twist = (
        shear_of_torsion(model, sections.data["torsion"].values[:, :, 0])[:, :, None] if "torsion" in sections.data else none
    )
    worst = with_torsion(worst, np.abs(shear), twist)
    over = ("time", "part", "station")
    data = {
        "S1": variable(over, np.sqrt(axial**2 + 3 * (shear + twist) ** 2), "Pa", "von Mises stress on the neutral axis"),
        "S2": variable(over, np.sqrt((axial + fibre) ** 2 + 3 * twist**2), "Pa", "stress in the outer fibre"),
        "von_mises": variable(over, worst, "Pa", "largest von Mises stress over the section"),
    }
    return xr.Dataset(data, coords=nominal.coords, attrs=sections.data.attrs | {"kind": "stresses"})
