"""Quantities of a run over time, by name: stored results, stresses, motor demands; each with its values at rest."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import nearest
from kinetruss.report.mechanism_data import angle_histories, moves
from kinetruss.results.wide_tables import units_of
from kinetruss.runs.mission_results import check_histories

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]

__all__ = ["ALIASES", "BUNDLES", "Curve", "QUANTITIES", "curves", "quantities"]

STRESSES = ("von_mises", "S1", "S2")
COMPONENTS = ("axial", "bending_2", "bending_3", "shear_2", "shear_3")
MOTION = (
    "drive_position",
    "drive_velocity",
    "drive_acceleration",
    "length",
    "length_rate",
    "length_acceleration",
    "position",
    "velocity",
    "acceleration",
    "singularity",
)
FORCES = (
    "member_force",
    "end_force",
    "joint_force",
    "reaction",
    "drive_force",
    "drive_power",
    "interface_force",
    "interface_moment",
    "energy",
    "energy_rate",
    "power",
    "energy_balance",
)
POWERS = FORCES[-4:]
"""Quantities that poses at rest do not have."""
SIMULATION = (
    "kinetic_energy",
    "potential_energy",
    "momentum",
    "angular_momentum",
    "step_size",
    "smallest_pivot",
    "constraint_error",
    "steps",
    "rejected",
    "evaluations",
)
FED = (
    "motor_command",
    "motor_voltage",
    "motor_current",
    "motor_angle",
    "motor_direction",
    "electrical_energy",
    "copper_energy",
    "motor_loss",
    "gear_loss",
    "screw_loss",
    "actuator_work",
    "motor_stored_energy",
    "motor_energy_balance",
)
"""Quantities of a simulation with motors."""
SECTIONS = ("section_T", "section_V", "section_M")
DEMAND = (
    "thrust", "actuator_power", "screw_torque", "screw_speed", "motor_speed", "motor_torque", "current", "voltage",
    "screw_torque_frictionless", "motor_torque_frictionless", "holding_torque", "breakaway_torque", "mechanical_power",
    "electrical_power", "stroke", "drive_torque", "angle_rate", "axis_torque",
)  # fmt: skip
ELASTIC = (
    "displacement", "settled", "elongation", "difference", "frequency", "actuator_share", "mac", "drive_length",
    "change", "error",
)  # fmt: skip
"""Quantities of statics and of elastic members along a motion."""
TURNING = ("drive_torque", "angle_rate")
_STRAINS = tuple(f"{name}_microstrain" for name in COMPONENTS)
QUANTITIES = (*STRESSES, *COMPONENTS, *_STRAINS, *MOTION, *SIMULATION, *FORCES, *SECTIONS, *DEMAND, *ELASTIC)

ALIASES = {
    "x": "drive_position",
    "xd": "drive_velocity",
    "xdd": "drive_acceleration",
    "stress": "von_mises",
    "force": "member_force",
    "actuator_force": "thrust",
    "torque": "motor_torque",
    "speed": "motor_speed",
    "tension": "section_T",
    "shear": "section_V",
    "moment": "section_M",
}
BUNDLES = {
    "motion": ("drive_position", "drive_velocity", "drive_acceleration"),
    "components": COMPONENTS,
    "drive": ("thrust", "motor_torque", "current", "voltage"),
    "energies": ("energy", "kinetic_energy", "potential_energy"),
}
"""Groups of quantities for one picture, by name."""
TURNS = ("angle", "angular_velocity", "angular_acceleration")
"""Of members along a motion."""
MEASURED = {"quantity": "value", "quantity_rate": "rate", "quantity_second_rate": "second_rate"}
"""Of the quantities that the model defines; each of them is also one by its own name."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Curve:
    """One curve of a run: its subject, values (times,) in `unit` at `time` (s), and those of the same poses at rest."""

    of: str
    words: str
    unit: str
    time: Array
    values: Array
    static: Array | None = None


def quantities(names: Sequence[str]) -> list[str]:
    """The quantities of some names, with synonyms and groups resolved. Unknown names are returned unchanged."""
    found: list[str] = []
    for name in names:
        found += BUNDLES.get(name, (ALIASES.get(name, name),))
    return list(dict.fromkeys(found))


def curves(
    run: RunResult, quantity: str, members: Sequence[str] = (), case: str | None = None, station: float | None = None
) -> list[Curve]:
    """The curves of one quantity; without `members`, all that have values.

    Parameters
    ----------
    members : members, parts of them, nodes, drives or supports.
    station : fraction of a part's length from its end towards A. By default stresses take their largest value along the part
        at every instant, signed quantities the station where they are largest.

    Raises
    ------
    InputError : no such quantity, member or load case (the message offers the nearest names); a member without this quantity.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> [curve] = kt.report.curves(kt.run(model), "member_force", ["coupler"])
    >>> curve.of, curve.unit, len(curve.time)
    ('coupler', 'N', 361)
    """
    check_histories(run)
    chosen = _case(run, case)
    total, still = _found(run, quantity, chosen)
    total = total.transpose("time", ...)
    names = _names(total)
    if missing := [str(axis) for axis, size in total.sizes.items() if not size]:
        raise InputError(f"There is no {quantity}: the model has no {missing[0]}. Show another quantity.")
    _check_members(total, names, members, quantity)
    stations = _stations(total, quantity, station)
    time = total["time"].values
    found = []
    for label, index in names:
        if members and not _is_named(total, label, members):
            continue
        cut = _cut(_at(total, index), stations, quantity)
        if np.isnan(cut[0]).all():
            continue
        rest = None if still is None else _cut(_at(still, index), cut[1], quantity)[0]
        of = " ".join(label)
        found.append(Curve(of=of, words=_words(total), unit=_unit(total, index), time=time, values=cut[0], static=rest))
    if not found:
        raise InputError(_nothing(quantity, members))
    return found


def _nothing(quantity: str, members: Sequence[str]) -> str:
    angle = dict.fromkeys(TURNING, "a drive of an angle with a motor")
    need = (angle | {"thrust": "an active member", "stroke": "limits"}).get(quantity)
    need = need or ("a section and a material" if quantity not in DEMAND else "a screw, a gear and a motor")
    return f"There is no {quantity} of {', '.join(members) or 'any member'}: it needs {need}. Add them to the model."


def _case(run: RunResult, case: str | None) -> str | None:
    if case is not None and case not in run.forces:
        raise InputError(f"No load case called {case!r}. {nearest(case, run.forces)}")
    return case or next(iter(run.forces), None)


def _found(run: RunResult, quantity: str, case: str | None) -> tuple[xr.DataArray, xr.DataArray | None]:
    """The variable with that name, and the same at rest."""
    for values, rest in _sources(run, quantity, case):
        data = values()
        if quantity in data and data[quantity].dims[:1] == ("time",):
            still = rest()
            return data[quantity], None if still is None else still[quantity]
    known = [name for name in (*QUANTITIES, *FED, *ALIASES, *BUNDLES) if _is_there(run, name)]
    known += [*run.model.quantities, *(MEASURED if run.quantities else ()), *(TURNS if moves(run) else ())]
    why, fix = "", nearest(quantity, known)
    if quantity in POWERS and any(one.attrs.get("at_rest") for one in run.forces.values()):
        why = " (its poses are at rest)"
    elif quantity in (*DEMAND, *FED):  # of a motor that the model does not have
        fix = "It needs an active member or a drive with a motor; drive_force is the force or torque of every drive."
    raise InputError(f"The run has no quantity called {quantity!r}{why}. {fix}")


Source = tuple[Callable[[], Any], Callable[[], Any]]


def _sources(run: RunResult, quantity: str, case: str | None) -> Iterator[Source]:
    """Datasets that may have it, with those at rest; computed ones are last, and only if they are needed."""
    if (measured := run.quantities) and (quantity in MEASURED or quantity in run.model.quantities):
        found = measured.get(case or "", next(iter(measured.values())))
        yield lambda: _measured(found), lambda: None
    if quantity in TURNS and moves(run):
        yield lambda: _turned(run), lambda: None
    yield lambda: run.motion.whole, lambda: None
    simulation = run.simulation
    if simulation is not None:
        yield lambda: simulation.data, lambda: None
    if case is None:
        return
    forces = run.forces[case]
    # at rest all powers are zero
    static = None if quantity.startswith(("power", "energy")) else forces.static
    if quantity == "drive_power":
        yield lambda: _powers(forces), lambda: None
    yield lambda: forces.whole, lambda: None if static is None else static.whole
    if case in run.statics:
        yield lambda: run.statics[case].data, lambda: None
    if case in run.demand:
        demand = run.demand[case].data
        yield lambda: demand, lambda: None if static is None else _demand_at_rest(run, quantity, static, demand)
    if quantity in SECTIONS:
        yield lambda: run.sections[case].data, lambda: None if static is None else _at_rest(run, static).data
    if quantity in STRESSES or quantity.removesuffix("_microstrain") in COMPONENTS:
        from kinetruss import strength

        work = strength.stresses if quantity in STRESSES else strength.components
        yield (
            lambda: work(run.model, run.sections[case]),
            lambda: None if static is None else work(run.model, _at_rest(run, static)),
        )


def _powers(forces: Forces) -> dict[str, Any]:
    """The power of every drive, W."""
    if "drive_force" not in forces.whole:
        return {}
    power = forces.whole["drive_force"] * forces.motion.whole["drive_velocity"].values
    return {"drive_power": power.rename("drive_power").assign_attrs(units="W", long_name="power of the drive")}


def _measured(found: xr.Dataset) -> dict[str, Any]:
    """The quantities of the model: all of them, and one by one."""
    if "time" not in found.coords:
        return {}
    every = {name: found[key].rename(name) for name, key in MEASURED.items() if key in found}
    for k, name in enumerate(map(str, found["quantity"].values)):
        one = found["value"][:, k : k + 1].rename(name)
        words = str(found["words"].values[k]) or name.replace("_", " ")
        every.setdefault(name, one.assign_attrs(units=str(found["quantity_unit"].values[k]), long_name=words))
    return every


def _turned(run: RunResult) -> dict[str, Any]:
    """Angles of members, and their rates."""
    import xarray as xr

    names = [*run.model.members, *run.model.bending]
    series = np.array(angle_histories(run, names))
    over = {"time": run.motion.whole["time"], "member": np.array(names, dtype=object).astype(str)}
    words = {"angle": "rad", "angular_velocity": "rad/s", "angular_acceleration": "rad/s^2"}
    return {
        name: xr.DataArray(series[:, k].T, over, ("time", "member"), name, {"units": unit, "long_name": name.replace("_", " ")})
        for k, (name, unit) in enumerate(words.items())
    }


def _at_rest(run: RunResult, static: Any) -> Any:
    from kinetruss import strength

    return strength.sections(run.model, static, stations=run.definition.stations)


def _demand_at_rest(run: RunResult, quantity: str, static: Any, demand: Any) -> Any:
    """Actuator force and motor torque of the same poses at rest; the other quantities are not known there."""
    if quantity == "motor_torque" and "holding_torque" in demand:
        return {"motor_torque": demand["holding_torque"]}
    if quantity == "drive_torque":
        turned = static.whole["drive_force"].rename(drive="active")
        return {quantity: turned.reindex(active=demand["active"].values).where(demand["drive_torque"].notnull().any("time"))}
    if quantity != "thrust":
        return None
    held = -static.whole["member_force"].sel(member=list(run.model.active)).rename(member="active")
    return {"thrust": held.reindex(active=demand["active"].values)}


def _is_there(run: RunResult, name: str) -> bool:
    name = BUNDLES.get(name, (ALIASES.get(name, name),))[0]
    if name in MOTION:
        return name in run.motion.whole
    if name in (*SIMULATION, *FED):
        return run.simulation is not None and name in run.simulation.data
    if name in ELASTIC:
        return any(name in one.data for one in run.statics.values())
    if name in TURNING:
        return any(name in demand.data for demand in run.demand.values())
    if name == "drive_power":
        return any("drive_force" in forces.whole and forces.whole.sizes["drive"] for forces in run.forces.values())
    if name in FORCES:
        return any(name in forces.whole for forces in run.forces.values())
    return bool(run.demand) if name in DEMAND else bool(run.forces)


Label = tuple[str, ...]
Names = list[tuple[Label, tuple[Any, ...]]]


def _names(data: xr.DataArray) -> Names:
    """Labels of all curves with their index in the array; stations have no names. ``end A`` is no node A."""
    dims = [dim for dim in data.dims[1:] if dim != "station"]
    shape = tuple(data.sizes[dim] for dim in dims)
    texts = [[f"end {name}" if dim == "end" else str(name) for name in data[dim].values] for dim in dims]
    found: Names = []
    for place in np.ndindex(shape):
        where = iter(place)
        index = tuple(slice(None) if dim == "station" else next(where) for dim in data.dims[1:])
        found.append((tuple(text[k] for text, k in zip(texts, place, strict=True)), index))
    return found


def _is_named(data: xr.DataArray, label: Label, members: Sequence[str]) -> bool:
    return bool(label) and (label[0] in members or (data.dims[1] == "part" and label[0].rpartition(".")[0] in members))


def _check_members(data: xr.DataArray, names: Names, members: Sequence[str], what: str) -> None:
    first = list(dict.fromkeys(label[0] for label, _ in names if label))
    wholes = [name.rpartition(".")[0] for name in first] if data.dims[1:2] == ("part",) else []
    for member in members:
        if member not in first and member not in wholes:
            whose = f"There are no names in {what}; leave out --member." if not first else nearest(member, [*first, *wholes])
            raise InputError(f"{member!r} is not in {what}. {whose}")


def _stations(data: xr.DataArray, quantity: str, station: float | None) -> int | None:
    """The index of the requested station."""
    if station is None:
        return None
    if "station" not in data.dims:
        raise InputError(f"{quantity} has no stations along the members. Leave out the station.")
    if not 0 <= station <= 1:
        raise InputError(f"station {station:g} is not a fraction from 0 to 1 of the part's length.")
    return int(np.argmin(np.abs(data["station"].values - station)))


def _cut(values: Array, station: int | None, quantity: str) -> tuple[Array, int | None]:
    """Values along time (times,) out of (times,) or (times, stations), and the station taken (None: the largest at any)."""
    if values.ndim == 1:
        return values, None
    if station is None and quantity in STRESSES:
        return values.max(axis=1), None
    if station is None:
        station = int(np.argmax(np.nan_to_num(np.abs(values)).max(axis=0)))
    return values[:, station], station


def _at(data: xr.DataArray, index: tuple[Any, ...]) -> Array:
    found: Array = data.transpose("time", ...).values[(slice(None), *index)]
    return found


def _words(data: xr.DataArray) -> str:
    return str(data.attrs.get("long_name") or str(data.name).replace("_", " "))


def _unit(data: xr.DataArray, index: tuple[Any, ...]) -> str:
    """The unit of one curve; the name of a coordinate stands for its entries."""
    return next(units_of(data[(slice(0, 1), *(slice(k, k + 1) if isinstance(k, int) else slice(0, 1) for k in index))]))
