"""Forces, moments and stresses along elastic beams and links."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np
import xarray as xr

from kinetruss.elements.kinds import LOADS
from kinetruss.elements.loads.along import units_on_beam
from kinetruss.errors import InputError
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.beam_forces import deflections, section_forces
from kinetruss.mechanics.loads import case_loads
from kinetruss.model import Model, Piece
from kinetruss.model.links import bends
from kinetruss.results import Forces, Result, variable
from kinetruss.strength.beam_spans import Spans, spans_of
from kinetruss.strength.element_stresses import positions_of
from kinetruss.strength.section_forces import fractions_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.elements.loads.load import OnBeam
    from kinetruss.mechanics import BeamElements


def beams(
    model: Model, result: Result | ArrayLike, *, stations: int | ArrayLike = 13, load_case: str | None = None
) -> xr.Dataset:
    """Section forces, stress and end forces of the elastic beams of a model, and of its links.

    Parameters
    ----------
    result : anything with positions or displacements (a simulation, forces, a motion, an equilibrium, `statics.linear`), or
        positions (n_nodes, dim) or (times, n_nodes, dim), m, at rest. stations : fractions of the length, or the number of
        equal ones, to which the pins of links between their ends are added.
    load_case : whose gravity acts along the beams; by default that of the result, else the model's gravity. Beams of a result
        without weight of members (``weight=False`` or ``"lumped"``) have none.

    Returns
    -------
    Dataset over (time,) beam, station: ``section_T`` N, tension positive; ``section_V`` N along local axes 2 (, 3);
    ``section_M`` N m about (2,) 3; in space ``torsion`` N m: as in `sections`, exerted by the part behind the section.
    ``stress`` Pa: largest normal stress |T|/A + bending. ``von_mises`` Pa: with the largest shear stress of V and of torsion
    taken at the same point, a bound; NaN where the section does not know its torsion. ``utilisation``: of the yield strength
    over its safety factor, NaN without one. ``end_force`` N and ``end_moment`` N m (beam, end, axis), by the nodes on the beam,
    along global axes (moment in the plane: about z). ``displacement`` (beam, station, axis) m: of the axis from the model's
    straight beam, global axes; ``deflection`` (beam, station, transverse) m: of the axis from the line of both ends, of a link
    from that of two pins that follow each other, along local axes 2 (, 3). Both are exact for small displacements under any
    load between the ends; NaN of beams that keep their shape. Stations of a link count along it from
    its first node; at a pin it has the side with the larger stress. With links ``pin_force`` (pin, axis) N, by the nodes on
    links, global axes; pins are called ``LINK.NODE``.

    Raises
    ------
    InputError : no elastic beams, positions of another model, an unknown load case; forces that are not in balance.

    Notes
    -----
    Closed form: the deformation modes of each beam give its forces without load between its ends; weight and inertia, spread
    along it as its mass is, add those of a beam clamped at both ends (`mechanics.beam_forces`). In a pose, and along a motion
    of drives, beams keep their shape; statically determinate ones have the forces of rigid beams. Bending by an axial force is
    counted between the ends of beams only as far as their nodes move: divide a slender beam under compression.

    >>> import kinetruss as kt
    >>> steel = kt.Material(E=200e9, density=7800.0)
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], material=steel, section=kt.Rod(diameter=0.01),
    ...                  beams={"arm": ("A", "B")}, loads={"P": kt.NodalForce(node="B", force=(0, -10))})
    >>> found = kt.strength.beams(model, kt.statics.linear(model), stations=[0.0, 0.5])
    >>> found.section_M.sel(beam="arm", moment="3").values.round(9).tolist()
    [-10.0, -5.0]
    """
    system = compile(model)
    elements = None if system.continua is None else system.continua.beams
    if elements is None:
        raise InputError(
            "The model has no elastic beams, and no links with a section and a material. "
            "Give it some: beams={'arm': ('A', 'B')}."
        )
    spans, xi = spans_of(system), fractions_of(stations)
    if np.ndim(stations) == 0 and spans.parted:
        xi = np.union1d(xi, spans.pins)
    local = spans.places(xi)
    values, data, timed = along_elements(model, result, local, load_case, deflected=True)
    if spans.parted:
        values = _merged(spans, values, xi, local)
    if model.links:
        values["pin_force"] = _on_pins(system, values)
    values = {name: one for name, one in values.items() if name not in ("element_force", "element_moment")}
    return _dataset(values if timed else {name: array[0] for name, array in values.items()}, timed, data, system, xi)


def along_elements(
    model: Model, result: Result | ArrayLike, xi: NDArray[np.float64], load_case: str | None = None, *, deflected: bool = False
) -> tuple[dict[str, NDArray[np.float64]], xr.Dataset | None, bool]:
    """The values of `beams` at the fractions xi (s,) of each elastic element of a beam or link, (times, k, s, ..), with
    displacements if `deflected`; the data of the positions; whether these are over time.
    """
    system, dim = compile(model), model.dim
    elements: BeamElements = cast(Any, system.continua).beams
    data = _data(result)
    x, timed = positions_of(system, result if data is None else cast("Result", result).with_(data=data, **_no_motion(result)))
    linear = data is not None and "position" not in data
    case = load_case if load_case is not None else _case_of(model, result)
    load = _gravity(system, result, case, load_case is None) - _history(system, result, data, x, "acceleration")
    given = result.arrays["mode_force"].values if isinstance(result, Forces) and "mode_force" in result.arrays else None
    v = _history(system, result, data, x, "velocity") if elements.damping.any() else None
    loads = _along(system, case, np.broadcast_to(system.x0, x.shape) if linear else x, data)
    known: dict[str, Any] = {"linear": linear, "given": given, "v": v, "loads": loads}
    found = section_forces(elements, x, system.x0, load, xi, **known)
    values = _sections(found, dim) | _stresses(system, elements, found) | _ends(found, dim)
    if deflected:
        moved, bent = deflections(elements, x, system.x0, load, xi, **known)
        values |= {"displacement": moved[..., :dim], "deflection": bent[..., : dim - 1]}
    return values, data, timed


def _merged(
    spans: Spans, values: dict[str, NDArray[np.float64]], xi: NDArray[np.float64], local: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Values of elements (times, k, p, ..) as those of beams and links at xi; those of the ends of elements stay too."""
    element, place = spans.chosen(xi, local, values["von_mises"])
    times = np.arange(len(element))[:, None, None]
    ends = {name: values[name] for name in ("end_force", "end_moment")}
    found = {name: one[times, element, place] for name, one in values.items() if name not in ends}
    first, last = ([own[at] for own in map(spans.elements, spans.names)] for at in (0, -1))
    for name, one in ends.items():
        found[name] = np.stack([one[:, first, 0], one[:, last, 1]], axis=2)
    return found | {"element_force": ends["end_force"]}


def _on_pins(system: System, values: dict[str, NDArray[np.float64]]) -> NDArray[np.float64]:
    """Forces of nodes on links (times, pins, dim), N."""
    ends = values.get("element_force", values["end_force"])
    place = {name: k for k, name in enumerate(pins_of(system))}
    found = np.zeros((len(ends), len(place), system.dim))
    for k, beam in enumerate(beam for beam in system.model.beams.values() if beam.kind == "elastic"):
        if isinstance(beam, Piece):
            for end, node in enumerate(beam.ends):
                found[:, place[f"{beam.link}.{node}"]] += ends[:, k, end]
    return found


def pins_of(system: System) -> list[str]:
    """The pins of links that have section forces: ``LINK.NODE``."""
    links = {name: one for name, one in system.model.links.items() if bends(system.model, one)}
    return [f"{name}.{node}" for name, one in links.items() for node in dict.fromkeys(one.nodes)]


def _elastic(system: System) -> list[tuple[str, Any]]:
    return [(name, beam) for name, beam in system.model.beams.items() if beam.kind == "elastic"]


def known_positions(forces: Forces) -> bool:
    """False for forces of positions in which beams are not deformed by their loads, and balance alone does not decide what they
    carry.
    """
    return not (forces.attrs.get("not_balanced", 0) or forces.attrs.get("undecided", ()))


def _data(result: Any) -> xr.Dataset | None:
    """The data of a result that has the positions; of the stiffness method the displacements."""
    if not isinstance(result, Result):
        return None
    if isinstance(result, Forces) and not known_positions(result):
        raise InputError(
            "The positions of these forces are not in balance: beams are not deformed by their loads, and balance alone does "
            "not decide their forces. Give the result of statics.linear, statics.equilibrium or dynamics.simulate."
        )
    if isinstance(result, Forces) and "displacement" not in result.arrays:
        return result.motion.whole
    return cast("Result", (None if isinstance(result, Forces) else getattr(result, "motion", None)) or result).whole


def _no_motion(result: Any) -> dict[str, Any]:
    """The change that lets the data of a result count before those of its motion."""
    return {"motion": None} if hasattr(result, "motion") else {}


def _case_of(model: Model, result: Any) -> str | None:
    name = getattr(result, "load_case", None) or (result.attrs.get("load_case") if isinstance(result, Result) else None)
    return name if name in model.cases else None


def _gravity(system: System, result: Any, case: str | None, own: bool) -> NDArray[np.float64]:
    """Of the result itself if it tells it, else of the load case, (3,); 0 of a result whose members have no weight."""
    found = case_loads(system, np.zeros(1), case).gravity
    if isinstance(result, Result):
        if result.attrs.get("weight", "all") != "all":
            return np.zeros_like(found)
        if own and (listed := result.attrs.get("gravity")) is not None:
            found = np.zeros_like(found)
            found[..., : system.dim] = listed
    return found


def _along(
    system: System, case: str | None, x: NDArray[np.float64], data: xr.Dataset | None
) -> list[tuple[OnBeam, NDArray[np.float64], NDArray[np.float64]]]:
    """Loads on beams of a case, with their history (times, 3) and their forces (times, v, 3), N, on the nodes of the beam, with
    all nodes at x (times, n, 3).
    """
    found = [(name, one) for name in loads_of(system, case) for one in on_beams(system, name)]
    if not found:
        return []
    t = np.zeros(len(x)) if data is None or "time" not in data.coords else data["time"].values
    amounts, elements = case_loads(system, t, case, rotating=True).amounts, cast("Any", system.continua).beams
    several = []
    for name, one in found:
        nodes, forces = elements.nodes[one.beam].tolist(), np.zeros((len(x), elements.nodes.shape[1], 3))
        for unit, amount in zip(units_on_beam(system, system.model.loads[name], one), amounts[name].T, strict=True):
            forces[:, [nodes.index(node) for node in unit.nodes]] += amount[:, None, None] * unit.forces(x[:, unit.nodes])
        first = 2 if one.couple and system.dim == 2 else 0
        history = np.zeros((len(x), 3))
        history[:, first : first + amounts[name].shape[1]] = amounts[name]
        several.append((one, history, forces))
    return several


def loads_of(system: System, case: str | None) -> tuple[str, ...]:
    """Names of the loads of a case; of all if it is None."""
    chosen = system.model.cases[case].loads if case is not None else None
    return tuple(system.model.loads if chosen is None else chosen)


def on_beams(system: System, name: str) -> list[OnBeam]:
    """Where a load acts on elastic beams."""
    load = system.model.loads[name]
    return list(LOADS[type(load)].on_beams(system, load))


def _history(system: System, result: Any, data: xr.Dataset | None, x: NDArray[np.float64], name: str) -> NDArray[np.float64]:
    """Velocities or accelerations (times, n, 3); 0 at rest."""
    found, still = np.zeros_like(x), isinstance(result, Forces) and result.attrs.get("at_rest", 0)
    if data is not None and name in data and not still:
        found[..., : system.dim] = data[name].values
    return found


def _sections(found: dict[str, NDArray[np.float64]], dim: int) -> dict[str, NDArray[np.float64]]:
    """T, V, M and torsion, (times, k, s, ..)."""
    force, moment = found["force"], found["moment"]
    values = {"section_T": force[..., 0], "section_V": force[..., 1:dim], "section_M": moment[..., 4 - dim :]}
    return values | ({"torsion": moment[..., 0]} if dim == 3 else {})


def _stresses(system: System, elements: BeamElements, found: dict[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    """Normal stress, a bound of von Mises' stress, and the utilisation of the yield strength, (times, k, s)."""
    force, moment, model = found["force"], found["moment"], system.model
    normal, whole, used = (np.empty(force.shape[:-1]) for _ in range(3))
    for k, name in enumerate(elements.names):
        section, material = model.section_of(model.beams[name]), cast(Any, model.material_of(model.beams[name]))
        (I2, I3), (c2, c3) = section.second_moments, section.extreme_fibres
        b2, b3 = np.abs(moment[:, k, :, 1]) * c3 / I2, np.abs(moment[:, k, :, 2]) * c2 / I3
        # a round section bends about the resultant, another one worst at a corner
        bending = np.hypot(b2, b3) if section.round else b2 + b3
        normal[:, k] = np.abs(force[:, k, :, 0]) / section.area + bending
        shear = section.shear_factor * np.hypot(force[:, k, :, 1], force[:, k, :, 2]) / section.area
        if model.dim == 3:
            known = section.torsion_arm is not None
            shear = shear + np.abs(moment[:, k, :, 0]) * (section.torsion_arm / section.torsion_constant if known else np.nan)
        whole[:, k] = np.sqrt(normal[:, k] ** 2 + 3 * shear**2)
        strength = material.yield_strength
        used[:, k] = np.nan if strength is None else whole[:, k] * model.safety.yielding / strength
    return {"stress": normal, "von_mises": whole, "utilisation": used}


def _ends(found: dict[str, NDArray[np.float64]], dim: int) -> dict[str, NDArray[np.float64]]:
    """What the nodes exert on the beam at its ends, along global axes, (times, k, 2, ..)."""
    turned = []
    for name in ("force", "moment"):
        ends = np.stack([-found[f"{name}_ends"][:, :, 0], found[f"{name}_ends"][:, :, 1]], axis=2)
        turned.append(np.einsum("tkea,tkac->tkec", ends, found["frame"]))
    return {"end_force": turned[0][..., :dim], "end_moment": turned[1][..., 2:] if dim == 2 else turned[1]}


def _dataset(
    values: dict[str, NDArray[np.float64]], timed: bool, data: Any, system: System, xi: NDArray[np.float64]
) -> xr.Dataset:
    dim = system.dim
    words = {
        "section_T": (("station",), "N", "axial force, tension positive"),
        "section_V": (("station", "transverse"), "N", "shear force along 2, 3"),
        "section_M": (("station", "moment"), "N m", "bending moment about 2, 3"),
        "torsion": (("station",), "N m", "torque about 1"),
        "stress": (("station",), "Pa", "largest normal stress"),
        "von_mises": (("station",), "Pa", "bound of von Mises' stress"),
        "utilisation": (("station",), "", "of the yield strength"),
        "displacement": (("station", "axis"), "m", "displacement of the axis"),
        "deflection": (("station", "transverse"), "m", "distance of the axis from the line of both ends, along 2, 3"),
        "end_force": (("end", "axis"), "N", "force of the node on the beam"),
        "end_moment": (("end", "about"), "N m", "moment of the node on the beam"),
    }
    first = ("time", "beam") if timed else ("beam",)
    found = {
        name: variable((*first, *words[name][0]), array, *words[name][1:]) for name, array in values.items() if name in words
    }
    coords: dict[str, Any] = {"beam": list(spans_of(system).names), "station": xi, "end": ["A", "B"]}
    coords |= {"transverse": ["2", "3"][: dim - 1], "moment": ["2", "3"][-(dim - 1) :], "axis": ["x", "y", "z"][:dim]}
    coords["about"] = ["z"] if dim == 2 else ["x", "y", "z"]
    if "pin_force" in values:
        found["pin_force"] = variable((*first[:-1], "pin", "axis"), values["pin_force"], "N", "force of the node on the link")
        coords["pin"] = pins_of(system)
    if timed and data is not None and "time" in data.coords:
        coords["time"] = data["time"].values
    return xr.Dataset(found, coords=coords, attrs={"kind": "beams"})
