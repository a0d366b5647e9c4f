"""Models and motions under operating conditions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError, InputError, ModelError
from kinetruss.kinematics.motions import follow_path, path_of
from kinetruss.kinematics.positions import assemble
from kinetruss.kinematics.redundant import LEAST
from kinetruss.kinematics.sampling import Sampled, sample, start_values
from kinetruss.kinematics.turns import halved
from kinetruss.mechanics import System, cached, compile
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Bar, Condition, LengthDrive, LoadCase, Model, NodalForce, condition_faults, natural_length, nearest
from kinetruss.model.links import bends
from kinetruss.model.references import names_in
from kinetruss.results import Motion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def without_arms(model: Model, changes: Mapping[str, Any], failed: set[str]) -> dict[str, Any]:
    """The tables without the arms, hinges, clamps and bearings of members that are gone; a hub without any is a node again.

    changes : the tables ``bars`` and ``drives`` without these members and what drives them.
    """
    if not (failed and (model.hubs or model.bearings)):
        return {}
    arms = tuple(f"{hub}.{member}" for hub in model.hubs for member in failed)

    def left(record: Any) -> bool:
        return not any(name == arm or name.startswith(f"{arm}.") for _, name, _ in names_in(record) for arm in arms)

    return {
        "hubs": _hubs(model, failed),
        "bars": {name: one for name, one in changes["bars"].items() if left(one)},
        "drives": {name: one for name, one in changes["drives"].items() if left(one)},
        "bearings": {name: one for name, one in model.bearings.items() if not {one.member, one.against} & failed},
    }


def _hubs(model: Model, failed: set[str]) -> dict[str, Any]:
    """Hubs without these members."""
    found = {}
    for name, hub in model.hubs.items():
        arms, hinges = (
            {member: one for member, one in table.items() if member not in failed} for table in (hub.arms, hub.hinges)
        )
        clamped = tuple(member for member in hub.clamped if member not in failed)
        if arms or clamped or hub.reach:
            found[name] = hub.with_(arms=arms, hinges=hinges, clamped=clamped)
    return found


# A model under an operating condition, as a model.


def under(model: Model, condition: str | Condition) -> Model:
    """The model under a condition: another model, for any analysis.

    Parameters
    ----------
    condition : a `Condition`, or the name of one of the model's.

    Returns
    -------
    Model, without runs and conditions. Gravity, masses and loads are changed; members and drives that are gone are taken out,
    and if drives are gone, all trajectories and the poses that need them; under a temperature,
    rigid bars and elastic ones have their new lengths without force, and nodes stand where these close, with the drives as
    they were. `locked` drives stay drives: who computes a motion holds them (runs do).

    Raises
    ------
    ModelError : the condition names what the model does not have, or what is left is no model.
    InputError : rigid bars that cannot have their new lengths together; a released active member.

    Notes
    -----
    A bar of length L with the coefficient alpha has the length L (1 + alpha dT) without force.

    >>> import kinetruss as kt
    >>> mast = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                 material=kt.library.materials.STEEL_S235, conditions={"hot": kt.Condition(temperature=50)})
    >>> round(kt.under(mast, "hot").nodes["B"].at[0], 6)
    2.0012
    """
    if isinstance(condition, str) and condition in model.conditions:
        return _under(compile(model), condition)
    return _changed(model, named_condition(model, condition))


@cached()
def _under(system: System, name: str) -> Model:
    """The model under one of its own conditions: the same for all its runs."""
    return _changed(system.given, system.given.conditions[name])


def _changed(model: Model, chosen: Condition) -> Model:
    if faults := list(condition_faults(model, chosen, ("condition",))):
        raise ModelError(faults)
    found = _laden(model.with_(runs={}, conditions={}), chosen)
    found = _warm_gauges(_without(found, chosen), chosen)
    return _warmed(found, chosen)


def named_condition(model: Model, condition: str | Condition) -> Condition:
    """The record of a condition.

    Raises
    ------
    InputError : no such condition.
    """
    if isinstance(condition, Condition):
        return condition
    if condition not in model.conditions:
        raise InputError(f"No condition called {condition!r}. {nearest(str(condition), model.conditions)}")
    return model.conditions[condition]


def _laden(model: Model, condition: Condition) -> Model:
    """Gravity, base acceleration, payloads and forces."""
    shift = np.zeros(model.dim) if condition.base_acceleration is None else np.array(condition.base_acceleration)

    def felt(gravity: Any) -> tuple[float, ...]:
        return tuple((np.array(gravity) - shift).tolist())

    changes: dict[str, Any] = {}
    if condition.base_rotation is not None:
        changes["base_rotation"] = condition.base_rotation
    own = condition.gravity or model.gravity or (0.0,) * model.dim
    if condition.gravity is not None or shift.any():
        changes["gravity"] = felt(own)
    nodes = dict(model.nodes)
    for name, node in nodes.items():
        more: dict[str, Any] = {}
        if name in condition.payloads:
            more["mass"] = node.mass + condition.payloads[name]
        if node.gravity is not None and shift.any():
            more["gravity"] = felt(node.gravity)
        nodes[name] = node.with_(**more) if more else node
    if nodes != model.nodes:
        changes["nodes"] = nodes
    added = {_free_name(f"condition.{node}", model.loads): (node, force) for node, force in condition.forces.items()}
    if added:
        changes["loads"] = {
            **model.loads,
            **{name: NodalForce(node=node, force=force) for name, (node, force) in added.items()},
        }
    cases = {name: _case(case, added, condition, felt, bool(model.combinations)) for name, case in model.load_cases.items()}
    if cases != model.load_cases:
        changes["load_cases"] = cases
    return model.with_(**changes) if changes else model


def _case(case: LoadCase, added: Mapping[str, Any], condition: Condition, felt: Any, combined: bool) -> LoadCase:
    """A load case with the forces of the condition, and with its gravity."""
    loads = case.loads if case.loads is None or not added else {**case.loads, **dict.fromkeys(added, 1.0)}
    gravity = case.gravity
    if gravity is not None and not (combined and not any(gravity)):  # a case that brings no weight into combinations
        gravity = None if condition.gravity is not None else felt(gravity)
    return case.with_(loads=loads, gravity=gravity)


def _free_name(name: str, taken: Iterable[str]) -> str:
    names = set(taken)
    while name in names:
        name += "_"
    return name


def _without(model: Model, condition: Condition) -> Model:
    """Failed members and released drives taken out."""
    if not (condition.failed or condition.released):
        return model
    failed, released = set(condition.failed), set(condition.released)
    if slack := sorted(released & set(model.active)):
        raise InputError(
            f"Active member {slack[0]!r} is released: its rods slide as the forces on them make them, so its motion cannot be "
            "prescribed. Simulate it (analysis: dynamics.simulate), or find its equilibrium (statics.equilibrium)."
        )
    drives = {
        name: drive
        for name, drive in model.drives.items()
        if name not in released and getattr(drive, "bar", None) not in failed
    }
    let_go = {
        getattr(model.all_drives[name], "bar", "") for name in released if isinstance(model.all_drives[name], LengthDrive)
    }
    bars = {
        name: Bar(**{**_fields(bar), "kind": "free", "length": None}) if name in let_go else bar
        for name, bar in model.bars.items()
        if name not in failed
    }
    active = {name: member for name, member in model.active.items() if name not in failed}
    changes: dict[str, Any] = {"drives": drives, "bars": bars, "active": active}
    changes |= without_arms(model, changes, failed)
    if any(getattr(load, "member", None) in failed for load in model.loads.values()):
        changes["loads"] = {name: load for name, load in model.loads.items() if getattr(load, "member", None) not in failed}
        changes["load_cases"] = {name: _without_gone(case, changes["loads"]) for name, case in model.load_cases.items()}
    changes["gauges"] = {name: gauge for name, gauge in model.gauges.items() if gauge.member not in failed}
    kept = {*drives, *active, *(name for name, bar in bars.items() if bar.kind == "driven")}
    if set(model.all_drives) - kept:
        changes |= {"trajectories": {}, "gauge_zero": None}
        changes["poses"] = {name: pose for name, pose in model.poses.items() if set(pose.drives) <= kept}
    return model.with_(**changes)


def _without_gone(case: LoadCase, loads: Mapping[str, Any]) -> LoadCase:
    """A load case without the loads that are gone."""
    return case if case.loads is None else case.with_(loads={name: one for name, one in case.loads.items() if name in loads})


def _fields(record: Any) -> dict[str, Any]:
    return {name: getattr(record, name) for name in type(record).model_fields}


def _warmed(model: Model, condition: Condition) -> Model:
    """New lengths without force, and the place in which they close."""
    if not (condition.temperature or any(condition.temperatures.values())):
        return model
    beams = {name: one for name, one in model.bending.items() if bends(model, one)}
    if without := next(iter({**model.membranes, **model.solids, **beams}), None):
        what, mend = (
            ("a beam or a link", ", or model it by elastic bars") if without in beams else ("a membrane or a solid", "")
        )
        raise InputError(f"{without!r} is {what}, which has no thermal strain here. Leave out the temperature{mend}.")
    system = compile(model)
    length, mass = (dict(zip(system.members, of.tolist(), strict=True)) for of in (system.length0, system.rods[:, 0]))
    bars, stretched, unknown = {}, {}, []

    def factor(name: str, bar: Bar) -> float:
        """How much longer it becomes."""
        warmer = condition.temperatures.get(name, condition.temperature)
        if not warmer or bar.body is not None or bar.kind in ("driven", "free"):
            return 1.0
        material = model.material_of(bar)
        if material is None or material.thermal_expansion is None:
            unknown.append(name)
            return 1.0
        return 1 + material.thermal_expansion * warmer

    for name, bar in model.bars.items():
        bars[name], more = bar, factor(name, bar)
        if more != 1.0 and bar.kind == "rigid":
            bars[name] = bar.with_(length=length[name] * more)
            stretched[name] = length[name] * more
        elif more != 1.0:
            bars[name] = bar.with_(pretension=None, natural_length=more * natural_length(model, bar, length[name]))
    hubs = _warmed_hubs(system, factor)
    if unknown:
        more_of = f" and {len(unknown) - 1} more" if len(unknown) > 1 else ""
        raise InputError(
            f"{unknown[0]!r}{more_of}: no thermal expansion is known. Give thermal_expansion to its material, 1/K "
            "(0 if it keeps its length)."
        )
    if not stretched and hubs == model.hubs:
        return model.with_(bars=bars)
    active = {name: one.with_(length=length[name]) for name, one in model.active.items()}

    def keeping(bars: Mapping[str, Bar]) -> Model:
        kept = {name: _of_mass(_of_length(bar, length[name]), mass[name]) for name, bar in bars.items()}
        return model.with_(bars=kept, active=active, hubs=hubs)

    place = _closed(model if hubs == model.hubs else keeping(model.bars), stretched)
    nodes = {name: node.with_(at=tuple(at)) for (name, node), at in zip(model.nodes.items(), place.tolist(), strict=False)}
    return keeping(bars).with_(nodes=nodes)


def _warm_gauges(model: Model, condition: Condition) -> Model:
    """Gauges with the temperature of their members."""
    warmer = {name: condition.temperatures.get(one.member, condition.temperature) for name, one in model.gauges.items()}
    if not any(warmer.values()):
        return model
    gauges = {name: one.with_(temperature=one.temperature + warmer[name]) for name, one in model.gauges.items()}
    return model.with_(gauges=gauges)


def _warmed_hubs(system: System, factor: Callable[[str, Bar], float]) -> dict[str, Any]:
    """Hubs whose rigid arms are longer by these factors."""
    found = dict(system.given.hubs)
    for name, arms in system.inner.arms.items():
        more = {arm.member: factor(arm.name, system.model.bars[arm.name]) for arm in arms}
        if any(one != 1.0 for one in more.values()):
            hub = found[name]
            longer = {one: (by * np.array(hub.arms.get(one, hub.reach), float)).tolist() for one, by in more.items()}
            found[name] = hub.with_(arms={**hub.arms, **longer})
    return found


def _of_mass(bar: Bar, mass: float) -> Bar:
    """A bar that keeps the mass, kg, of its section when it becomes longer."""
    return bar if bar.mass is not None or bar.body is not None or not mass else bar.with_(mass=mass)


def _of_length(bar: Bar, length: float) -> Bar:
    """A bar that keeps its prescribed or natural length when its nodes are moved."""
    if bar.kind in ("rigid", "driven"):
        return bar if bar.length is not None else bar.with_(length=length)
    if bar.kind == "free" or bar.natural_length is not None or bar.pretension is not None:
        return bar
    return bar.with_(natural_length=length)


def _closed(model: Model, lengths: Mapping[str, float]) -> NDArray[np.float64]:
    try:
        return assemble(model, lengths)
    except (AnalysisError, InputError) as error:
        raise InputError(
            f"The bars cannot take their lengths under this temperature: {error} Make bars that are held against each other "
            "elastic (kind: elastic)."
        ) from None


# A commanded motion of drives, done by a structure under a condition.


def commanded(
    model: Model,
    changed: Model,
    condition: Condition,
    trajectory: Any,
    times: NDArray[np.float64],
    *,
    start: ArrayLike | None = None,
    least: float = LEAST,
) -> Motion:
    """The motion of `changed` (the model under the condition) by the commands of the trajectory to the drives of the model.

    Drives get the values that they have without the condition; locked ones stay as in the model; those that are gone get
    none. Poses of a trajectory are thus not corrected for temperature or failures.

    Raises
    ------
    InputError : fewer drives than freedoms; samples between which something turns too far.
    """
    commands, system = sample(model, trajectory, times), compile(changed)
    column = {name: k for k, name in enumerate(commands.drives)}
    pick = [column[name] for name in system.drives]
    laws = [np.ascontiguousarray(one[:, pick]) for one in (commands.value, commands.rate, commands.acceleration)]
    standing = start_values(model)
    for name in condition.locked:
        k = system.drives.index(name)
        laws[0][:, k], laws[1][:, k], laws[2][:, k] = standing[name], 0.0, 0.0
    sampled = Sampled(
        drives=system.drives, times=commands.times, value=laws[0], rate=laws[1], acceleration=laws[2], space="lengths"
    )
    motion = follow_path(system, path_of(system, commands.times, sampled), "lengths", start=start, least=least)
    x, v = (flat_positions(system, motion.arrays[name].values) for name in ("position", "velocity"))
    if (more := len(halved(system, x, v, commands.times, sampled))) > len(commands.times):
        raise InputError(f"Something turns too far between two of {len(commands.times)} samples. Take {more} or more samples.")
    return motion
