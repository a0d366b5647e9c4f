"""Readings of strain gauges on members, simulated, and rosettes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss import dynamics, kinematics
from kinetruss.arrays import array_of
from kinetruss.errors import InputError
from kinetruss.model import GaugeZero, Model, Quintic
from kinetruss.results import Forces, variable
from kinetruss.strength.gauge_records import bridge_reading
from kinetruss.strength.parts import Parts, parts_of
from kinetruss.strength.section_forces import sections

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.model import Material


def gauges(model: Model, forces: Forces, *, zeroed: bool = True, zero_of: Model | None = None) -> xr.Dataset:
    """Strain at every gauge of the model, its split into axial and bending strain by groups, and the output of its bridge.

    Parameters
    ----------
    forces : from `dynamics.inverse` of the same model; ``forces.static`` gives the readings of the same poses at rest.
    zeroed : subtract the readings at ``model.gauge_zero``, if the model has one. zero_of : the model in which the gauges were
        set to zero, as it was before a condition; by default `model`.

    Returns
    -------
    Dataset. ``strain`` (time, gauge), 1e-6; ``bridge`` (time, gauge), V/V: output of a quarter bridge over its excitation;
    ``group_strain`` (time, group, component), 1e-6: ``axial``, ``bending_2``, ``bending_3`` (in the plane without 2), as in
    `components`: bending at the extreme fibre, with the sign of its moment; NaN where the gauges do not determine it.
    ``group_force`` (time, group, inner): the section forces ``T`` N, ``M2``, ``M3`` N m, ``V2``, ``V3`` N that a group measures
    (shear by gauges with a direction); NaN likewise. ``zero`` (gauge), 1e-6: the subtracted reading.

    Raises
    ------
    InputError : a model without gauges, forces of another model, a zero at a time outside the motion, gauges of a group that
        do not separate axial strain from bending, a zero of a warm elastic model without `zero_of`.

    Notes
    -----
    At (y, z) along member axes 2 and 3: strain e = (T/A + M2 z/I2 - M3 y/I3)/E, with T and M at the gauge's own section (T is
    not the mean over the length). A gauge in the direction d reads e (cos^2 d - nu sin^2 d) + g sin d cos d, with the shear
    strain g = tau/G of V2 and V3 along the surface: as in the stresses, exact for a thin tube. Groups by least squares; three
    gauges 120 degrees apart: axial = their mean. Quarter bridge: output = k e/(4 + 2 k e), k the gauge factor. Set to zero at
    rest, at the sample nearest to a time given as zero.
    Under a temperature T a gauge reads the thermal strain t = (alpha of the part - alpha that it is matched to) T besides: in
    a quarter bridge e + t, in others what the bridge makes of it (`bridge_reading`). A zero at a time of the run has it too.
    Source: Lacy (1991, section 5.4: three gauges on M6); Window, Strain Gauge Technology (1992), for the bridge.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> gauged = model.with_(gauges={"G1": kt.Gauge(member="tie", at=0.5, factor=2.0)})
    >>> kt.strength.gauges(gauged, kt.runs.forces_at_rest(gauged)).strain.values.round(2).tolist()  # 1e-6
    [[21.44]]
    """
    if not model.gauges:
        raise InputError("The model has no gauges. Add some, e.g. gauges: {G1: {member: M6, angle: 0 deg, factor: 2.1}}.")
    places = _places(model)
    strain, zero = _read(model, _strain(model, forces, places)), np.zeros(len(model.gauges))
    record = (zero_of or model).gauge_zero
    if zeroed and record is not None:
        zero = _zero(model, forces, record, zero_of)
    strain = strain - zero
    factor = np.array([gauge.factor for gauge in model.gauges.values()])
    change = 1e-6 * strain * factor
    data = {
        "strain": variable(("time", "gauge"), strain, "1e-6", "strain at the gauge"),
        "bridge": variable(("time", "gauge"), change / (4 + 2 * change), "V/V", "output of a quarter bridge over excitation"),
        "zero": variable(("gauge",), zero, "1e-6", "strain at the reference pose, taken off"),
    }
    parts, k = places.parts, places.part
    coords: dict[str, Any] = {
        "time": forces.whole["time"].variable,
        "gauge": list(model.gauges),
        "member": ("gauge", [parts.members[i] for i in k]),
        "part": ("gauge", [parts.names[i] for i in k]),
    }
    groups = list(dict.fromkeys(gauge.group for gauge in model.gauges.values() if gauge.group is not None))
    if groups:
        of_groups, named = _of_groups(model, groups, places, strain)
        data |= of_groups
        coords |= named
    return xr.Dataset(data, coords=coords, attrs={"kind": "gauges", "load_case": forces.load_case})


def _of_groups(model: Model, groups: list[str], places: _Places, strain: NDArray[np.float64]) -> tuple[Any, dict[str, Any]]:
    """Axial and bending strains of groups and the section forces that they measure, and the coordinates of both."""
    across = ["bending_3"] if model.dim == 2 else ["bending_2", "bending_3"]
    inner = ["T", "M3", "V2"] if model.dim == 2 else ["T", "M2", "M3", "V2", "V3"]
    split = np.stack([_split(model, group, places, strain) for group in groups], axis=1)
    first = [next(i for i, one in enumerate(model.gauges.values()) if one.group == group) for group in groups]
    per_force = np.stack([_per_force(places.parts, int(places.part[i]), model.dim) for i in first])
    axial, force, of_group = split[..., : 1 + len(across)], 1e-6 * split / per_force, ("time", "group")
    data = {
        "group_strain": variable((*of_group, "component"), axial, "1e-6", "axial and bending strain of a group"),
        "group_force": variable((*of_group, "inner"), force, "N, N m", "section forces that a group measures"),
    }
    return data, {"group": groups, "component": ["axial", *across], "inner": inner}


class _Places:
    """Places of the gauges: part (gauges,), fraction of its length xi, (y, z) along axes 2 and 3, m; what a gauge reads of the
    axial strain at its place (gauges,), and of the largest shear strains of V2 and V3 (gauges, 2).
    """

    def __init__(self, model: Model, parts: Parts) -> None:
        self.parts = parts
        records = model.gauges.values()
        names = [gauge.member if gauge.part is None else f"{gauge.member}.{gauge.part}" for gauge in records]
        self.part = np.array([parts.names.index(name) for name in names], np.int64)
        length = parts.lengths(_lengths(model)[None])[0, self.part]
        self.xi = np.array([_fraction(gauge, l) for gauge, l in zip(records, length, strict=True)])
        c = np.stack([parts.c2, parts.c3], axis=1)[self.part]
        sections = [model.section_of(_owner(model, gauge)) for gauge in records]
        round_ = [getattr(section, "round", True) for section in sections]
        self.y, self.z = np.array([_point(gauge, c[k, 0], c[k, 1], round_[k]) for k, gauge in enumerate(records)]).T
        turn = np.array([gauge.direction for gauge in records])
        nu = parts.E[self.part] / (2 * parts.G[self.part]) - 1
        self.along = np.cos(turn) ** 2 - nu * np.sin(turn) ** 2
        flow = np.array([_flow(gauge, c[k], round_[k]) for k, gauge in enumerate(records)])
        self.shear = (np.sin(turn) * np.cos(turn))[:, None] * flow


def _places(model: Model) -> _Places:
    return _Places(model, parts_of(model))


def _owner(model: Model, gauge: Any) -> Any:
    member = model.whole.members[gauge.member]
    return member if gauge.part is None else getattr(member, gauge.part)


def _lengths(model: Model) -> NDArray[np.float64]:
    """Lengths of the members in the model's own pose, m."""
    at = {name: np.array(node.at) for name, node in model.whole.nodes.items()}
    members = model.whole.members.values()
    return np.array([one.length or float(np.linalg.norm(at[one.ends[1]] - at[one.ends[0]])) for one in members])


def _fraction(gauge: Any, length: float) -> float:
    if gauge.distance is not None:
        return float(min(1.0, gauge.distance / length))
    return 0.5 if gauge.at is None else float(gauge.at)


def _point(gauge: Any, c2: float, c3: float, is_round: bool) -> tuple[float, float]:
    """(y, z) of a gauge on the surface of a round or rectangular section, or at its own radius, m."""
    cosine, sine = np.cos(gauge.angle), np.sin(gauge.angle)
    if gauge.radius is not None:
        radius = gauge.radius
    elif is_round:
        radius = c2
    else:
        radius = min(c / abs(part) for c, part in ((c2, cosine), (c3, sine)) if abs(part) > 1e-12)
    return radius * cosine, radius * sine


def _flow(gauge: Any, c: NDArray[np.float64], is_round: bool) -> tuple[float, float]:
    """Shear stress towards growing angle at a gauge, over the largest ones of V2 and V3 alone."""
    cosine, sine = np.cos(gauge.angle), np.sin(gauge.angle)
    if is_round:
        return -float(sine), float(cosine)
    y, z = _point(gauge, c[0], c[1], is_round)
    if abs(y) >= abs(z) * c[0] / c[1]:  # on the face across axis 2
        return 0.0, float(np.sign(cosine) * (1 - (z / c[1]) ** 2))
    return -float(np.sign(sine) * (1 - (y / c[0]) ** 2)), 0.0


def _strain(model: Model, forces: Forces, places: _Places) -> NDArray[np.float64]:
    """(times, gauges), 1e-6."""
    stations = np.unique(places.xi)
    found, parts, k = sections(model, forces, stations).data, places.parts, places.part
    # T/A - M3 y/I3 + M2 z/I2 at each gauge
    at = np.searchsorted(stations, places.xi)
    stress = found["section_T"].values[:, k, at] / parts.area[k]
    M, V = found["section_M"].values[:, k, at], found["section_V"].values[:, k, at]
    stress = stress - M[..., -1] * places.y / parts.I3[k]
    if M.shape[-1] == 2:
        stress = stress + M[..., 0] * places.z / parts.I2[k]
    strain = places.along * stress / parts.E[k]
    if places.shear.any():
        # shear strain k V/(A G) along the surface
        per = (parts.factor / parts.area / parts.G)[k]
        V = V[..., -2:] if V.shape[-1] > 1 else V
        strain = strain + per * (V * places.shear[:, : V.shape[-1]]).sum(axis=-1)
    return np.asarray(1e6 * strain)


def _read(model: Model, strain: NDArray[np.float64]) -> NDArray[np.float64]:
    """What gauges read of strains by forces (times, gauges), 1e-6: with that by their temperature, as their bridge takes it."""
    found = strain.copy()
    for k, gauge in enumerate(model.gauges.values()):
        material = model.material_of(_owner(model, gauge))
        expansion = None if material is None else material.thermal_expansion
        if not gauge.temperature or gauge.matched_expansion is None or expansion is None:
            continue  # warm on a material without expansion: a fault
        thermal = (expansion - gauge.matched_expansion) * gauge.temperature
        if gauge.bridge is None:
            found[:, k] += 1e6 * thermal
        else:
            found[:, k] = 1e6 * bridge_reading(1e-6 * strain[:, k], thermal, gauge.bridge, gauge.factor)
    return found


def _zero(model: Model, forces: Forces, record: GaugeZero, zero_of: Model | None) -> NDArray[np.float64]:
    """The readings (gauges,) at the reference pose, 1e-6: at a time of the run as they are then, else without temperature."""
    if record.time is not None:
        return np.asarray(_read(model, _strain(model, _reference(model, forces, record), _places(model)))[0])
    warm = any(gauge.temperature for gauge in model.gauges.values())
    if zero_of is None and warm and any(bar.kind in ("elastic", "cable") for bar in model.bars.values()):
        raise InputError(
            "The gauges are warm, and elastic bars may have forces by the temperature, which the zero must not take off. "
            "Give the model as it was when they were set to zero: zero_of=model."
        )
    set_in = model if zero_of is None else zero_of
    there = dict(zip(set_in.gauges, _strain(set_in, _reference(set_in, forces, record), _places(set_in))[0], strict=True))
    return np.array([there[name] for name in model.gauges])


def _per_force(parts: Parts, k: int, dim: int) -> NDArray[np.float64]:
    """Largest strain of a part for a unit of T, M2, M3, V2, V3 (in the plane T, M3, V2)."""
    axial, shear = 1 / (parts.E[k] * parts.area[k]), parts.factor[k] / (parts.area[k] * parts.G[k])
    M2, M3 = parts.c3[k] / (parts.E[k] * parts.I2[k]), parts.c2[k] / (parts.E[k] * parts.I3[k])
    return np.array([axial, M3, shear] if dim == 2 else [axial, M2, M3, shear, shear])


def _reference(model: Model, forces: Forces, zero: GaugeZero) -> Forces:
    """Forces at rest in the pose where the gauges read zero."""
    times = forces.arrays["time"].values
    if zero.time is not None:
        slack = 1e-9 * max(abs(times[-1]), 1.0)
        if not times[0] - slack <= zero.time <= times[-1] + slack:
            span = f"{times[0]:g} s to {times[-1]:g} s"
            raise InputError(f"gauge_zero.time {zero.time:g} s is outside the motion, {span}. Choose one inside, or a pose.")
        position = forces.motion.arrays["position"].values[np.argmin(np.abs(times - zero.time))]
    elif zero.at:
        there = Quintic(moves={name: (value, value) for name, value in zero.at.items()}, duration=1.0)
        position = kinematics.follow(model, there, times=[0.0]).data["position"].values[0]
    else:
        position = kinematics.assemble(model)
    still = np.zeros((1, *position.shape))
    # without a load case named, gravity alone acts
    bare = model if zero.load_case is not None else model.with_(loads={}, load_cases={}, combinations={}, runs={})
    motion = kinematics.from_arrays(bare, [0.0], position[None], still, still)
    return dynamics.inverse(bare, motion, zero.load_case, static=False)


def _split(model: Model, group: str, places: _Places, strain: NDArray[np.float64]) -> NDArray[np.float64]:
    """Strains (times, k) of a group by T, M2, M3 (extreme fibre), V2, V3 (largest shear), in the plane by T, M3, V2: by least
    squares; NaN for those that its gauges do not determine.
    """
    chosen = [k for k, gauge in enumerate(model.gauges.values()) if gauge.group == group]
    parts, part = places.parts, places.part[chosen[0]]
    along, shear = places.along[chosen], places.shear[chosen]
    columns = [along, -along * places.y[chosen] / parts.c2[part], shear[:, 0]]
    if model.dim == 3:
        columns = [columns[0], along * places.z[chosen] / parts.c3[part], columns[1], shear[:, 0], shear[:, 1]]
    # e = D (axial, bending, shear); an unknown is determined where D^+ D = 1
    design = np.stack(columns, axis=1)
    inverse = np.linalg.pinv(design, rcond=1e-9)
    unseen = np.abs(np.eye(design.shape[1]) - inverse @ design).max(axis=1) > 1e-9
    if unseen[0] and not shear.any():
        raise InputError(
            f"The gauges of group {group!r} lie on one line, so axial strain cannot be separated from bending. Spread them."
        )
    if unseen.all():
        raise InputError(
            f"The gauges of group {group!r} determine no single section force. Add gauges, e.g. pairs at +-45 deg."
        )
    found = strain[:, chosen] @ inverse.T
    found[:, unseen] = np.nan
    return np.asarray(found)


# Rosettes: strain, principal strain and stress at a point from gauges in three or more directions.

MAKERS_POISSON = 0.285
"""Poisson's ratio of the beams on which makers find gauge factors."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Rosette:
    """Strain at a point, all arrays of one shape (readings,).

    x, y, shear : strain along and across the axis from which angles count, and shear strain gamma_xy, 1e-6. principal :
    (..., 2), the larger first, 1e-6. angle : of the first principal direction, rad. stress : (..., 2) principal, Pa, and
    von_mises, Pa; None without a material (plane stress).
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    shear: NDArray[np.float64]
    principal: NDArray[np.float64]
    angle: NDArray[np.float64]
    stress: NDArray[np.float64] | None
    von_mises: NDArray[np.float64] | None


def rosette(strains: ArrayLike, angles: ArrayLike, *, material: Material | None = None, transverse: float = 0.0) -> Rosette:
    """Strain and stress at a point from the readings of a rosette.

    Parameters
    ----------
    strains : (..., gauges), 1e-6. angles : (gauges,), rad, of each gauge from the x axis: three or more different directions,
        0/45/90 and 0/60/120 degrees for instance. material : for stresses. transverse : transverse sensitivity of the gauges
        (their response to strain across over that along), as a fraction.

    Returns
    -------
    Rosette. More than three gauges: least squares.

    Raises
    ------
    InputError : another number of readings than angles; directions that do not determine the strain.

    Notes
    -----
    e(a) = x cos^2 a + y sin^2 a + shear sin a cos a; with a transverse sensitivity K a gauge reads (e(a) + K e(a + 90 deg))/
    (1 - 0.285 K). Source: Window, Strain Gauge Technology (1992), rosettes.

    >>> found = rosette([500.0, 350.0, -100.0], np.radians([0, 45, 90]))
    >>> found.principal.round(3).tolist(), round(float(found.shear), 3)
    ([535.41, -135.41], 300.0)
    """
    turns = array_of(angles, "angles", {"gauges": None}, unit="rad")
    readings = array_of(strains, "strains", {"...": None, "gauges": len(turns)}, unit="1e-6")
    c, s = np.cos(turns), np.sin(turns)
    along, across = np.stack([c * c, s * s, s * c], axis=1), np.stack([s * s, c * c, -s * c], axis=1)
    design = (along + transverse * across) / (1 - MAKERS_POISSON * transverse)
    if len(turns) < 3 or np.linalg.svd(design, compute_uv=False)[-1] < 1e-6:
        shown = ", ".join(f"{np.degrees(one):g}" for one in turns)
        raise InputError(f"Gauges at {shown} deg do not determine the strain. Give three different directions, e.g. 0, 45, 90.")
    found = readings @ np.linalg.pinv(design).T
    x, y, shear = (found[..., k] for k in range(3))
    middle, radius = (x + y) / 2, np.hypot(x - y, shear) / 2
    principal = np.stack([middle + radius, middle - radius], axis=-1)
    stress = von_mises = None
    if material is not None:
        nu = material.poisson
        stress = 1e-6 * material.E / (1 - nu**2) * (principal + nu * principal[..., ::-1])
        von_mises = np.sqrt(stress[..., 0] ** 2 - stress[..., 0] * stress[..., 1] + stress[..., 1] ** 2)
    angle = np.arctan2(shear, x - y) / 2
    return Rosette(x=x, y=y, shear=shear, principal=principal, angle=angle, stress=stress, von_mises=von_mises)
