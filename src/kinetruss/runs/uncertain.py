"""The uncertain parameters of a model, and standard errors of forces along a measured motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss import actuators, dynamics, kinematics
from kinetruss.errors import InputError, UnitError, shown
from kinetruss.model import LengthDrive, Measured, Model, Record, nearest
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Parameter:
    """An uncertain number. tolerance : half the width of its range. lengths : change of every member's length (members,), m,
    for a change of 1; zero for a number at a `path`, which has the value `nominal`.
    """

    name: str
    tolerance: float
    lengths: NDArray[np.float64]
    path: str | None = None
    nominal: float = 0.0


def parameters(model: Model, tolerances: Mapping[str, Any], expansion: float | None) -> list[Parameter]:
    """The parameters that the keys of `tolerances` stand for; see `budget`.

    Raises
    ------
    InputError : a key that fits nothing, a tolerance that is no positive number of its unit, a parameter named twice.
    """
    found: list[Parameter] = []
    for key, given in tolerances.items():
        name, _, last = key.rpartition(".")
        if key == "temperature":
            found.append(_temperature(model, given, expansion))
        elif last == "length" and _names(model, name, model.members):
            found += _lengths(model, key, given)
        elif last == "play" and _names(model, name, model.nodes):
            found += _play(model, key, given)
        else:
            found += _paths(model, key, given)
    names = [one.name for one in found]
    if twice := [name for name in names if names.count(name) > 1]:
        raise InputError(f"{twice[0]} has two tolerances. Give one: patterns must not overlap.")
    if not found:
        raise InputError("No tolerance is given. Give for example tolerances={'M*.length': '0.1 mm'}.")
    return found


def _names(model: Model, pattern: str, known: Mapping[str, Any]) -> bool:
    """Whether a pattern is one of members or nodes, whose names may have dots, and no path of the model."""
    return pattern.partition(".")[0] not in type(model).model_fields or any(fnmatchcase(name, pattern) for name in known)


def _supported(model: Model, member: str) -> bool:
    """Whether a member joins two fixed nodes, so that an error of its length moves nothing."""
    axes, whole = set("xyz"[: model.dim]), model.whole
    return all(axes <= set(whole.fixed.get(node, "")) for node in whole.members[member].ends)


def driven_lengths(model: Model, chosen: list[Parameter]) -> tuple[Model, list[str | None]]:
    """The model with every uncertain length driven, and the drive of each member (None: its length is certain)."""
    moved = np.any([one.lengths != 0 for one in chosen], axis=0)
    own = {drive.bar: name for name, drive in model.all_drives.items() if isinstance(drive, LengthDrive)}
    bars, drives = dict(model.bars), []
    for name, uncertain in zip(model.members, moved, strict=True):
        if uncertain and name not in own:
            if bars[name].kind != "rigid":
                raise InputError(f"The length of {name!r} is no parameter: it is {bars[name].kind}. Leave it out.")
            bars[name] = bars[name].with_(kind="driven")
        drives.append(own.get(name, name) if uncertain else None)
    return model.with_(bars=bars), drives


def _half_width(given: Any, quantity: str, key: str) -> float:
    try:
        value = float(parse(given, quantity))
    except UnitError as error:
        raise InputError(f"Tolerance of {key}: {error}") from None
    if value <= 0:
        raise InputError(f"Tolerance of {key}: {value:g}, expected a positive number. Leave it out if it is exact.")
    return value


def _one_length(model: Model, name: str) -> NDArray[np.float64]:
    return np.array([float(name == one) for one in model.members])


def _lengths(model: Model, key: str, given: Any) -> list[Parameter]:
    pattern, tolerance = key.removesuffix(".length"), _half_width(given, "length", key)
    fits = [name for name in model.members if fnmatchcase(name, pattern)]
    if not fits:
        raise InputError(f"No member fits {key!r}. {nearest(pattern, list(model.members))}".rstrip())
    if any(mark in pattern for mark in "*?["):
        fits = [name for name in fits if getattr(model.members[name], "kind", "driven") in ("rigid", "driven")]
        fits = [name for name in fits if not _supported(model, name)]
    elif _supported(model, pattern):
        raise InputError(f"{pattern!r} joins two fixed nodes, so an error of its length moves nothing. Leave it out.")
    return [Parameter(name=f"{name}.length", tolerance=tolerance, lengths=_one_length(model, name)) for name in fits]


def _play(model: Model, key: str, given: Any) -> list[Parameter]:
    """Play of a joint: every member at the node may sit off it by the play, along its own axis."""
    pattern, tolerance = key.removesuffix(".play"), _half_width(given, "length", key)
    fits = [name for name in model.nodes if fnmatchcase(name, pattern)]
    if not fits:
        raise InputError(f"No node fits {key!r}. {nearest(pattern, list(model.nodes))}".rstrip())
    return [
        Parameter(name=f"{node}.play of {name}", tolerance=tolerance, lengths=_one_length(model, name))
        for node in fits
        for name, member in model.members.items()
        if node in member.ends and not _supported(model, name)
    ]


def _temperature(model: Model, given: Any, expansion: float | None) -> Parameter:
    tolerance = _half_width(given, "number", "temperature (K)")
    whole = model.whole
    if rigid := [owner for name, owner in whole.inner.bars.items() if whole.bars[name].kind == "rigid"]:
        raise InputError(f"The thermal strain of {rigid[0].text} is not known. Leave out the temperature.")
    at = {name: np.array(node.at) for name, node in whole.nodes.items()}
    change = []
    for name in model.members:
        member = whole.members[name]
        parts = [member] if not hasattr(member, "tube") else [member.tube]
        own = [getattr(model.material_of(part), "thermal_expansion", None) for part in parts]
        share = own[0] if own[0] is not None else expansion
        if share is None:
            raise InputError(f"{name!r} has no thermal expansion. Give its material one, or expansion=12e-6 (1/K).")
        length = member.length or float(np.linalg.norm(at[member.ends[1]] - at[member.ends[0]]))
        kept = getattr(member, "kind", "driven") in ("rigid", "driven") and not _supported(model, name)
        change.append(share * length if kept else 0.0)
    return Parameter(name="temperature", tolerance=tolerance, lengths=np.array(change))


def _paths(model: Model, key: str, given: Any) -> list[Parameter]:
    found = []
    for path in _expanded(model, key.split(".")):
        nominal = _value(model, path, key)
        text = given.strip() if isinstance(given, str) else None
        if text is not None and text.endswith("%"):
            tolerance = _half_width(text[:-1].strip(), "number", key) / 100 * abs(nominal)
        else:
            tolerance = _half_width(given, "number", key)
        if tolerance == 0:
            raise InputError(f"{'.'.join(path)} is 0: a tolerance in percent of it is nothing. Give a number.")
        none = np.zeros(len(model.members))
        found.append(Parameter(name=".".join(path), tolerance=tolerance, lengths=none, path=".".join(path), nominal=nominal))
    return found


def _expanded(model: Model, keys: list[str]) -> list[list[str]]:
    """The paths of a pattern: ``*`` stands for every name of a table; names may have dots."""
    paths: list[tuple[list[str], Any, int]] = [([], model, 0)]
    while open_ones := [one for one in paths if one[2] < len(keys)]:
        path, place, k = open_ones[0]
        names, taken = _named(place, keys[k:])
        at = paths.index(open_ones[0])
        paths[at : at + 1] = [([*path, name], _entry(place, name), k + taken) for name in names]
    return [path for path, _, _ in paths]


def _named(place: Any, keys: list[str]) -> tuple[list[str], int]:
    """The names in a place that the first keys stand for, and how many keys these are."""
    if isinstance(place, Mapping):
        for taken in range(len(keys), 0, -1):
            if found := [one for one in place if fnmatchcase(one, ".".join(keys[:taken]))]:
                return found, taken
        if "*" in keys[0]:
            return [], 1
    return [keys[0]], 1


def _entry(place: Any, key: str) -> Any:
    if isinstance(place, Mapping):
        return place.get(key)
    if isinstance(place, Record):
        return getattr(place, key, None)
    return place[int(key)] if isinstance(place, tuple) and key.isdigit() and int(key) < len(place) else None


def _value(model: Model, path: list[str], key: str) -> float:
    place: Any = model
    for k, name in enumerate(path):
        if isinstance(place, str):
            so_far = ".".join(path[:k])
            raise InputError(f"{key}: {so_far} names {place!r}. Give the path of that record, e.g. sections.{place}.{name}.")
        place = _entry(place, name)
    if isinstance(place, bool) or not isinstance(place, float | int):
        raise InputError(
            f"{key!r} is no number of the model (found {shown(place)}). Give NAME.length, NODE.play, temperature, or a dotted "
            "path such as materials.tube.density."
        )
    return float(place)


# Standard errors of forces and motor currents along a measured motion.

_FIELDS = ("values", "rates", "accelerations")
_DEMANDS = ("motor_torque", "current", "voltage")


def standard_errors(model: Model, record: Measured, *, load_case: str | None = None) -> xr.Dataset:
    """Positions, forces and motor demands along a measured motion, with their standard errors.

    Parameters
    ----------
    record : lengths, angles or pose coordinates; smoothed as by `kinematics.measured`. What the record gives (rates,
        accelerations) counts as exact. load_case : None takes all loads of the model.

    Returns
    -------
    Dataset. ``position`` (time, node, axis) m, ``member_force`` (time, member) N, ``drive_force`` (time, drive) N or N m and,
    with drive trains, ``motor_torque`` N m, ``current`` A, ``voltage`` V (time, active), each with ``NAME_error``. The
    attribute ``curvature`` is the part of the changes that is not linear in the errors, as a fraction of the largest error.

    Raises
    ------
    InputError, ModelError : faults of the record or of its coordinates. AnalysisError : the motion ends early.

    Notes
    -----
    Each of value, rate and acceleration of each coordinate is moved by plus and minus its own standard error, and half the
    difference of the two results is its share; the shares of one coordinate are added with the covariance of the smoother,
    those of different coordinates as independent: variance = sum_k d_k^T R_k d_k. Forces are linear in accelerations and
    quadratic in rates, so that these shares are exact; those of the values are exact to the third order.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")},
    ... )
    >>> times = [0.05 * k for k in range(21)]
    >>> record = kt.Measured(times=times, values={"turn": [t**2 + (-1) ** k * 1e-3 for k, t in enumerate(times)]})
    >>> found = kt.runs.standard_errors(crank, record)
    >>> bool((found.position_error.sel(node="B").max("axis") > 0).all())  # m
    True
    """
    smooth = kinematics.measured(record)
    base = _outputs(model, smooth.trajectory, load_case)
    plain = {name: np.zeros(one.shape) for name, one in base.items()}
    bent = dict.fromkeys(base, 0.0)
    covariance = smooth.data["covariance"].values
    for k, name in enumerate(record.values):
        deviation = np.sqrt(np.einsum("rii->ri", covariance[:, k]))
        moved = [order for order in range(3) if deviation[:, order].any()]
        shares: dict[int, dict[str, NDArray[np.float64]]] = {}
        for order in moved:
            up, down = (
                _outputs(model, _moved(smooth.trajectory, name, order, s * deviation[:, order]), load_case) for s in (1, -1)
            )
            shares[order] = {key: (up[key].values - down[key].values) / 2 for key in base}
            for key, one in base.items():
                off = np.abs(up[key].values + down[key].values - 2 * one.values).max(initial=0.0) / 2
                bent[key] = max(bent[key], float(off))
        for a in moved:
            for b in moved:
                both = deviation[:, a] * deviation[:, b]
                R = np.divide(covariance[:, k, a, b], both, out=np.zeros(len(both)), where=both > 0)
                for key, variance in plain.items():
                    variance += R.reshape(-1, *[1] * (variance.ndim - 1)) * shares[a][key] * shares[b][key]
    data: dict[str, xr.DataArray] = {}
    for key, one in base.items():
        attrs = {"units": one.attrs["units"], "long_name": f"standard error of {one.attrs['long_name']}"}
        data |= {key: one, f"{key}_error": one.copy(data=np.sqrt(np.maximum(plain[key], 0.0))).assign_attrs(attrs)}
    largest = {key: float(data[f"{key}_error"].max()) for key in base}
    round_off = {key: 1e-12 * float(np.abs(one).max()) for key, one in base.items()}
    curvature = max((bent[key] / size for key, size in largest.items() if size > round_off[key]), default=0.0)
    return xr.Dataset(data, attrs={"kind": "standard_errors", "curvature": curvature, "message": smooth.message})


def _moved(record: Measured, name: str, order: int, by: NDArray[np.float64]) -> Measured:
    """The smoothed record with one column of one coordinate moved."""
    field = _FIELDS[order]
    columns = getattr(record, field)
    return record.with_(**{field: {**columns, name: tuple(np.array(columns[name]) + by)}})


def _outputs(model: Model, record: Measured, load_case: str | None) -> dict[str, xr.DataArray]:
    """Positions, forces and demands at the rows of a record."""
    times = np.array(record.times) - record.times[0]
    motion = kinematics.follow(model, record, times=times)
    forces = dynamics.inverse(model, motion, load_case, static=False)
    found = {"position": motion.whole["position"]}
    found |= {name: forces.whole[name] for name in ("member_force", "drive_force")}
    if model.actuators:
        demand = actuators.evaluate(model, motion, forces).data
        found |= {name: demand[name].reset_coords(drop=True) for name in _DEMANDS if np.isfinite(demand[name].values).any()}
    return found
