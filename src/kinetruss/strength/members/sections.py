"""Section forces along members."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.arrays import array_of
from kinetruss.errors import InputError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.sections.sections import section_forces
from kinetruss.limits import MOST_STATIONS, whole
from kinetruss.model import Model
from kinetruss.results import Arrays, Axes, Forces, Sections, provenance, variable
from kinetruss.strength.members.inputs import histories
from kinetruss.strength.members.parts import parts_of
from kinetruss.strength.members.torsion import torsion_of
from kinetruss.strength.verdict.not_held import not_held, sentences

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["fractions_of", "sections"]


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
        found = found.dataset.assign_coords(pose=forces.data["pose"].variable).set_xindex("pose")
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
