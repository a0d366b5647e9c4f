"""The scene as a record, and its parts that change in time: motion, forces, channels, animated shapes."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import xarray as xr

from kinetruss.elements.continua_arrays import skin_of
from kinetruss.errors import InputError
from kinetruss.mechanics.rotating_base import rates_in_space
from kinetruss.model import ALONG, Pressure
from kinetruss.viewer.loads_along import EACH, FEW, MANY, drawn_along

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces, Motion, Result
    from kinetruss.runs import RunResult

    Described = tuple[dict[str, Any], dict[str, NDArray[Any]]]


FORMAT = "kinetruss.scene"
VERSION = 1
"""Version of the format; it increases if old readers would show new scenes wrongly, but not for additions."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Mode:
    """An animated shape: a mechanism, a vibration mode.

    name : text shown. shape : (n_nodes, dim) displacements, any scale. frequency : Hz, or None for a mechanism.
    """

    name: str
    shape: NDArray[Any]
    frequency: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Scene:
    """A model, alone or along a motion, as plain data.

    header : JSON data: names, kinds, supports, units of the arrays, channels; ``format`` and ``version`` name its
        form. The keys are listed in the documentation of the viewer.
    arrays : by name. Over time first, then nodes or members, then axes, as in results.
    """

    header: Mapping[str, Any]
    arrays: Mapping[str, NDArray[Any]]


# Channels that colour members: values over time, or for a large scene the worst of the whole run.

CHANNELS: dict[str, dict[str, str]] = {
    "force": {"label": "Axial force", "unit": "N", "scale": "diverging", "low": "compression", "high": "tension",
              "array": "member_force"},
    "stress": {"label": "Stress", "unit": "Pa", "scale": "sequential", "low": "none", "high": "largest of the run",
               "array": "stress", "faces": "skin_stress"},
    "utilisation": {"label": "Utilisation", "unit": "%", "scale": "capacity", "low": "unused", "high": "full at 100 %",
                    "array": "utilisation"},
    "buckling": {"label": "Buckling margin", "unit": "", "scale": "margin", "low": "no compression", "high": "buckles",
                 "array": "buckling"},
    "speed": {"label": "Speed of the middle", "unit": "m/s", "scale": "sequential", "low": "at rest",
              "high": "largest of the run"},
}  # fmt: skip
"""Channels a scene may have. ``array`` is absent if the page computes it from others; ``faces`` colours faces."""


# The parts of a scene that change in time: motion, forces of the load cases, channels.


EXACT = 600_000
"""Largest count of numbers over time that a scene keeps as float32; above it curves are rounded."""

ARROWS = 24
"""Largest number of pressure arrows: they show its direction, the panel and the legend its size."""

STATIONS, MOST_SECTIONS = 13, 200_000
"""Stations along a beam at which a scene has its section forces, and the largest count of these numbers over time."""

UNITS = {
    "time": "s", "position": "m", "velocity": "m/s", "acceleration": "m/s^2", "drive_position": "m or rad", "member_force": "N",
    "joint_force": "N", "action_force": "N", "action_place": "", "reaction": "N", "drive_force": "N or N m",
    "load_force": "N", "rest_force": "N",
    "stress": "Pa", "utilisation": "", "buckling": "", "energy": "J", "skin_stress": "Pa", "beam_section": "N, N m or Pa",
    "quantity": "that of each",
}  # fmt: skip


def moving(
    model: Model, motion: Motion, forces: Sequence[Forces], run: RunResult | None, most: int, instants: Sequence[float] = ()
) -> Described:
    """Header fields and arrays of a motion and of the forces along it, one entry of `forces` a load case.

    The arrays of the first load case have their plain names, those of the next begin with ``1:``, ``2:``, .. ``cases`` holds
    the header fields of each: as many as fit without rounding, at least one.
    """
    count = int(motion.whole.sizes["time"])
    quantities, measured = quantities_of(model, run, count)
    keep = _chosen_samples(count, most, motion.whole["time"].values, run, instants)
    if len(keep) < count:
        motion = motion.with_(data=motion.whole.isel(time=keep))
        forces = [_cut(one, keep, motion) for one in forces]
    time = motion.whole["time"].values
    names = ("time", "position", "velocity", "acceleration", "drive_position")
    found = {name: motion.whole[name].values for name in names if name in motion.whole.variables}
    if forces:  # the page computes section forces from them
        rates = rates_in_space(forces[0].attrs, time, found["position"], found["velocity"], found["acceleration"])
        found["velocity"], found["acceleration"] = rates
    found["position"] = scalars_placed(model, found["position"])
    found |= {name: values[keep] for name, values in measured.items()}
    moved, each = 3 * found["position"].size, len(time) * len(model.whole.members) * (4 + 2 * model.dim)
    rounded = moved + min(1, len(forces)) * each > EXACT
    fitting = 1 if rounded else (EXACT - moved) // max(each, 1)
    described: list[dict[str, Any]] = []
    over_run: list[str] = []
    for k, one in enumerate(forces[:fitting]):
        fields, arrays, over_run = _forces(model, one, run, rounded)
        described.append(fields)
        found |= {f"{k}:{name}" if k else name: values for name, values in arrays.items()}
    found |= stress_of_faces(model, motion.whole["position"].values)
    channels = [{**one, "over_run": one["id"] in over_run} for one in channels_of(found, bool(model.whole.members))]
    more = {
        "rounded": rounded,
        "samples": {"all": count, "shown": len(time)},
        "status": motion.status.value,
        "message": " ".join(filter(None, [motion.message, "" if run else motion.unchecked, *_not_held(run)])),
        "channels": channels,
        "shows": shown_over(model, found, rounded=rounded),
        "over_run": over_run,
        "cases": described,
        "quantities": quantities,
        **(described[0] if described else {}),
    }
    return more, found


def quantities_of(model: Model, run: RunResult | None, count: int) -> tuple[list[dict[str, Any]], dict[str, NDArray[Any]]]:
    """Names, words, units and limits of the quantities of a model; and ``quantity``, their values (samples, quantities)."""
    found = {} if run is None else run.quantities
    data = next(iter(found.values()), None)
    if data is None or "time" not in data.coords or data.sizes["time"] != count:
        return [], {}
    units = map(str, data["quantity_unit"].values)
    described = [
        {"name": name, "words": one.words, "unit": unit, "limits": None if one.limits is None else list(one.limits)}
        for unit, (name, one) in zip(units, model.quantities.items(), strict=True)
    ]
    return described, {"quantity": data["value"].values}


def scalars_placed(model: Model, position: NDArray[np.float64]) -> NDArray[np.float64]:
    """Positions (times, n, dim) with scalar coordinates, which have none, at the first node."""
    scalars = [k for k, node in enumerate(model.nodes.values()) if node.scalar]
    if not scalars:
        return position
    position = position.copy()
    position[:, scalars] = position[:, :1]
    return position


def load_times(result: Forces | Result, time: NDArray[np.float64]) -> NDArray[np.float64]:
    """The instants (times,), s, of which the loads act: of poses at rest and of equilibria one for all, not their numbers."""
    held = result.whole.attrs.get("load_time")
    return time if held is None else np.full(len(time), float(held))


def _not_held(run: RunResult | None) -> list[str]:
    """Sentences on the checks that the verdict of a run could not make."""
    return [] if run is None or run.verdict is None else list(run.verdict.data.attrs.get("not_held", []))


def channels_of(found: Collection[str], members: bool) -> list[dict[str, Any]]:
    """Header fields of the channels for the given arrays; without members only channels of faces."""
    return [
        {"id": name, **channel, "over_run": False}
        for name, channel in CHANNELS.items()
        if (members and channel.get("array", "velocity") in found) or channel.get("faces") in found
    ]


def stress_of_faces(model: Model, position: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """``skin_stress`` of membranes and solids, if it is fast to compute."""
    if not model.membranes and not model.solids:
        return {}
    from kinetruss.strength.element_stresses import skin_stress

    found = skin_stress(model, skin_of(model.whole), position)
    return {} if found is None else {"skin_stress": found}


def in_equilibrium(run: RunResult, case: str) -> bool:
    """Whether the loads alone have moved the positions of a run from those of its model."""
    return case in run.statics and run.statics[case].attrs.get("kind") == "equilibrium"


def sections_of_beams(model: Model, result: Forces | Result, *, at_rest: bool = False) -> dict[str, NDArray[np.float64]]:
    """``beam_section`` and ``beam_extreme``, the `beam_tables` of elastic beams; nothing where they are many. Of what its loads
    have moved from the model (`at_rest`, `statics.linear`) also ``moved``, displacements of nodes from ``unmoved``, and
    ``beam_moved``, those along beams at the same stations, m.
    """
    from kinetruss.mechanics import compile
    from kinetruss.strength.curves import beam_tables

    count = sum(beam.kind == "elastic" for beam in model.whole.beams.values())
    if not count or result.whole.sizes.get("time", 1) * count * STATIONS * 7 > MOST_SECTIONS:
        return {}
    linear = "displacement" in result.whole
    found = {f"beam_{name}": one for name, one in beam_tables(model, result, STATIONS, deflected=linear or at_rest).items()}
    if "beam_moved" in found:
        start = compile(model).x0[None, :, : model.dim]
        place = result.whole if linear or "position" in result.whole else cast("Forces", result).motion.whole
        moved = place["displacement"].values if linear else place["position"].values - start
        found |= {"unmoved": start, "moved": moved.reshape(-1, *start.shape[1:])}
    return found


def shown_over(model: Model, found: Collection[str], *, rounded: bool) -> list[dict[str, Any]]:
    """What the page can draw over the structure: `quantities_shown` of the arrays that are there; none of rounded curves."""
    from kinetruss.strength.curves import quantities_shown

    if rounded or "member_force" not in found or not ("joint_force" in found or "beam_section" in found):
        return []
    return [
        {
            "id": name,
            "label": one.words[0].upper() + one.words[1:],
            "unit": one.unit,
            "sign": one.sign,
            "axis": one.axis,
            "side": one.side,
        }
        for name, one in quantities_shown(model.dim).items()
        if ("moved" in found if name == "deflection" else name != "torque" or ("beam_section" in found and not model.hubs))
    ]


def _cut(forces: Forces, keep: NDArray[np.int64], motion: Motion) -> Forces:
    static = None if forces.static is None else forces.static.with_(data=forces.static.whole.isel(time=keep), motion=motion)
    return forces.with_(data=forces.whole.isel(time=keep), motion=motion, static=static)


def _forces(
    model: Model, forces: Forces, run: RunResult | None, rounded: bool
) -> tuple[dict[str, Any], dict[str, NDArray[Any]], list[str]]:
    """Header fields and arrays of one load case, and names of arrays with the worst of the run (in a large scene)."""
    from kinetruss.strength.beam_verdict import middle_forces
    from kinetruss.strength.verdict import strength_histories, worst_of

    data = forces.whole
    case = forces.load_case if forces.load_case in model.cases else None
    when = load_times(forces, data["time"].values)
    loads, load_force = loads_of(model, when, case, forces.motion.whole["position"].values)
    names = ("reaction", "drive_force", "energy", *(() if rounded else ("joint_force",)))
    found = {"member_force": middle_forces(model, forces)}
    found |= {name: data[name].values for name in names if name in data} | {"load_force": load_force}
    found |= sections_of_beams(model, forces, at_rest=run is not None and in_equilibrium(run, forces.load_case))
    worst = worst_of(model, run.verdict) if rounded and run is not None and run.verdict is not None else {}
    found |= worst if rounded else strength_histories(model, forces)
    actions, acting = _actions(model, forces)
    found |= acting
    if forces.static is not None and not rounded:
        found["rest_force"] = middle_forces(model, forces.static)
    described = {
        "load_case": forces.load_case,
        "loads": loads,
        "actions": actions,
        "gravity": [float(g) for g in data.attrs["gravity"]],
        "supported": [str(name) for name in data["support"].values],
        "not_unique": [str(name) for name in data.attrs.get("not_unique", [])],
    }
    return described, found, list(worst)


def _actions(model: Model, forces: Forces) -> tuple[list[dict[str, Any]], dict[str, NDArray[Any]]]:
    """Actions on members other than weight: sources, members and arrays; `mean` if mean forces include them."""
    return _described_actions(model, forces.whole, forces.load_case)


def actions_at_rest(model: Model, rest: Result) -> tuple[list[dict[str, Any]], dict[str, NDArray[Any]]]:
    """The same for an equilibrium. It has no forces of couplings, so their actions are NaN."""
    from kinetruss.dynamics.bar_actions import acting_along, action_coordinates, action_variables
    from kinetruss.kernels.structure.structure import States
    from kinetruss.mechanics import compile
    from kinetruss.mechanics.loads import case_loads

    system, data = compile(model), rest.whole
    x = np.zeros((1, *system.x0.shape))
    x[:, :, : model.dim] = data["position"].values
    case = rest.provenance.get("load_case")
    loads = case_loads(system, load_times(rest, np.zeros(1)), case if case in model.cases else None).at(x)
    coupling = np.full((1, len(system.model.couplings)), np.nan)
    drive = data["drive_force"].values[None] if "drive_force" in data else np.full((1, len(system.drives)), np.nan)
    still = np.zeros((1, system.x0.size))
    found, acting = acting_along(system, loads, States(x.reshape(1, -1), still, still), drive, coupling)
    data = xr.Dataset(action_variables(system, acting), action_coordinates(system, found))
    return _described_actions(model, data, loads.name)


def _described_actions(model: Model, data: xr.Dataset, case: str) -> tuple[list[dict[str, Any]], dict[str, NDArray[Any]]]:
    from kinetruss.dynamics.bar_actions import TENSING, actions_of
    from kinetruss.elements.loads.load import Spread
    from kinetruss.mechanics import compile

    if "action" not in data.coords:
        return [], {}
    members = {name: k for k, name in enumerate(model.whole.members)}
    place = data["action_place"].values
    places = [one.place for one in actions_of(compile(model), case).actions]
    spread = [dict(one._asdict()) if isinstance(one, Spread) else False for one in places]
    described = []
    pairs = zip(data["action_source"].values.tolist(), data["action_member"].values.tolist(), spread, strict=True)
    for source, member, along in pairs:
        kind, _, name = source.partition(" ")
        described.append(
            {
                "source": name,
                "kind": kind,
                "member": members[member],
                "spread": along,
                "mean": kind in TENSING,
            }
        )
    return described, {"action_force": data["action_force"].values, "action_place": np.where(np.isnan(place), 0.5, place)}


def loads_of(
    model: Model, time: NDArray[Any], case: str | None, position: NDArray[np.float64] | None = None
) -> tuple[list[dict[str, Any]], NDArray[np.float64]]:
    """Forces of a load case: where they act, and (times, loads, dim), N, with nodes at position (times, n, dim)."""
    from kinetruss.mechanics import compile
    from kinetruss.mechanics.loads import case_loads

    system = compile(model)
    full = np.broadcast_to(system.x0, (len(time), *system.x0.shape)).copy()
    if position is not None:
        full[:, :, : model.dim] = position
    loads = case_loads(system, time, case, rotating=True).at(full)
    pressing = np.array([isinstance(model.loads[name], Pressure) for name in loads.loads], np.bool_)
    # loads between the ends of members are drawn there, and not as forces on nodes
    several = [name for name in dict.fromkeys(loads.loads) if isinstance(model.loads[name], ALONG)]
    single = np.flatnonzero(~pressing & ~np.isin(loads.loads, several))
    where = [{"name": loads.loads[k], "node": int(loads.node[k])} for k in single]
    # pressure: one arrow per node for all faces at it, and at most as many arrows as can be distinguished
    nodes, of = np.unique(loads.node[pressing], return_inverse=True)
    about = (np.arange(len(nodes))[:, None] == of).astype(float)
    force = np.einsum("nk,tki->tni", about, loads.force[:, pressing])
    drawn = _spread(full[0, nodes], ARROWS)
    where += [{"name": "pressure", "node": int(node), "pressure": True, "drawn": k in drawn} for k, node in enumerate(nodes)]
    found = [loads.force[:, single], force]
    for name in several:
        own = loads.force[:, [k for k, one in enumerate(loads.loads) if one == name]].sum(axis=1)
        entries, forces = drawn_along(system, name, own, EACH if len(several) <= MANY else FEW)
        where += entries
        found += [one[:, None] for one in forces]
    return where, np.concatenate(found, axis=1)[:, :, : model.dim]


def _spread(points: NDArray[np.float64], most: int) -> set[int]:
    """Indices of at most so many points (n, 3), each the farthest from those before it."""
    if len(points) <= most:
        return set(range(len(points)))
    chosen = [0]
    near = np.linalg.norm(points - points[0], axis=1)
    while len(chosen) < most:
        chosen.append(int(near.argmax()))
        near = np.minimum(near, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return set(chosen)


def _chosen_samples(
    count: int, most: int, time: NDArray[Any], run: RunResult | None, instants: Sequence[float]
) -> NDArray[np.int64]:
    """Indices of the samples that are kept."""
    if most < 2:
        raise InputError(f"frames={most}: give at least 2.")
    if count <= most:
        return np.arange(count)
    chosen = np.linspace(0, count - 1, most).round().astype(np.int64)
    if run is not None and run.verdict is not None:
        worst = run.verdict.data["time_of"].values
        worst = np.unique(worst[np.isfinite(worst)])
        chosen = np.append(chosen, np.abs(time[:, None] - worst[: most // 4]).argmin(axis=0))
    chosen = np.append(chosen, np.abs(time[:, None] - np.asarray(instants, float)).argmin(axis=0))
    return np.unique(chosen)


# Animated shapes: mechanisms of a model, vibration modes of a linearisation.

DENSE = 300
"""Number of nodes up to which mechanisms are computed, since they need a dense rank decision."""

MOST = 24
"""Largest number of shapes in a scene."""


def mechanisms(model: Model) -> list[Mode]:
    """Mechanisms with all drives fixed; none for larger models."""
    from kinetruss.kinematics import mobility

    if len(model.whole.nodes) > DENSE:
        return []
    return [Mode(name=f"mechanism {k + 1}", shape=shape) for k, shape in enumerate(mobility(model).mechanisms[:MOST])]


def vibrations(linearisation: Result) -> list[Mode]:
    """The undamped modes of a linearisation, slowest first."""
    data = linearisation.data
    found = []
    for k, (frequency, shape) in enumerate(zip(data["frequency"].values[:MOST], data["mode_shape"].values, strict=False)):
        away = math.isnan(frequency)
        name = f"mode {k + 1}, runs away" if away else f"mode {k + 1}"
        found.append(Mode(name=name, shape=shape, frequency=None if away else float(frequency)))
    return found
