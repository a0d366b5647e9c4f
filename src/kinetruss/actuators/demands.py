"""Demand on the screws, gears and motors of all active members and geared angles along a motion, and the couples of screws."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.demand_summary import current_rate, summarised
from kinetruss.actuators.screws import breakaway_torque, holding_torque, screw_torque
from kinetruss.actuators.shafts import Parts, at_motor, motor_demand, parts_of
from kinetruss.errors import InputError
from kinetruss.mechanics import RIGID, compile
from kinetruss.model import Active, BodyCouple, Model, Motor
from kinetruss.results import Demand, Forces, Motion, provenance, variable
from kinetruss.results.records import check_samples

if TYPE_CHECKING:
    from numpy.typing import NDArray


def screw_couples(model: Model, motion: Motion, demand: Demand) -> dict[str, BodyCouple]:
    """The couples of screws on the hubs at the ends of active members, as loads.

    Parameters
    ----------
    motion, demand : of the same instants; the demand from `evaluate`.

    Returns
    -------
    Loads by name, ``MEMBER.torque.A`` and ``MEMBER.torque.B``: on the hub at end A the `axis_torque` along the member's axis,
    on the hub at end B its opposite; N m, in global axes. They enter through the member (`BodyCouple.member`), so that they
    twist it and twist and bend its arms. A node fixed to the ground, without hub, needs none.
    ``model.with_(loads=model.loads | couples)`` is the model for `dynamics.inverse`. The couples change the thrust, and with it
    the torque, by a share of about lead/(distance of the hub's joints): evaluate again for more digits.

    Raises
    ------
    InputError : a planar model; instants of another motion; an end that is no hub, which passes no moment.

    Examples
    --------
    >>> import kinetruss as kt
    >>> from math import cos, pi, sin
    >>> def ring(letter: str, radius: float, turn: float) -> dict[str, tuple[float, float, float]]:
    ...     angles = [k * pi / 3 + turn * (-1) ** k for k in range(6)]
    ...     return {f"{letter}{k}": (radius * cos(a), radius * sin(a), 0.0) for k, a in enumerate(angles)}
    >>> part = kt.Part(length=0.5, section=kt.Tube(outer=0.02, inner=0.016), material="steel_s235")
    >>> screw = kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.1)
    >>> leg = kt.Active(ends=("F0", "C"), base=part, tube=part, screw=screw)
    >>> model = kt.Model(
    ...     nodes={"C": kt.Node(at=(0, 0, 0.8), mass=20.0), **ring("F", 0.5, 0.4)}, fixed=list(ring("F", 0.5, 0.4)),
    ...     bars={f"L{k}": kt.Bar(ends=(f"F{k}", "C"), kind="driven", mass=0) for k in range(1, 6)}, active={"L0": leg},
    ...     hubs={"C": kt.Hub(arms=ring("L", 0.2, -0.4))}, gravity=(0, 0, -9.81),
    ... )
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"L0": 0.01}, duration=1.0), samples=5)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> couples = kt.actuators.screw_couples(model, motion, demand)
    >>> list(couples), couples["L0.torque.B"].body  # the other end is on the ground
    (['L0.torque.B'], 'C.hub')
    """
    if model.dim == 2:
        raise InputError("A planar model has no torque about the axis of a member. Make the model spatial.")
    time, position = motion.arrays["time"].values, motion.arrays["position"].values
    check_samples(motion)
    if not np.array_equal(time, demand.arrays["time"].values):
        raise InputError("Motion and demand have other instants. Evaluate the demand along this motion.")
    whole, found = model.whole, {}
    nodes = list(whole.nodes)
    for k, name in enumerate(demand.arrays["active"].values.tolist()):
        torque = demand.arrays["axis_torque"].values[:, k]
        if name not in model.active or np.isnan(torque).any():
            continue
        ends = whole.active[name].ends
        d = position[:, nodes.index(ends[1])] - position[:, nodes.index(ends[0])]
        along = torque[:, None] * d / np.linalg.norm(d, axis=1)[:, None]
        for which, end, sign in (("A", ends[0], 1.0), ("B", ends[1], -1.0)):
            hub = whole.inner.nodes.get(end)
            if hub is None and len(whole.fixed.get(end, "")) == 3:
                continue
            if hub is None:
                raise InputError(
                    f"{name!r} ends at node {end!r}, which passes no moment: nothing holds the torque of its screw. Give the "
                    f"node a hub with an arm for it: hubs={{{end!r}: kt.Hub(arms={{{name!r}: 0.05}})}}."
                )
            moments = tuple(map(tuple, (sign * along).tolist()))
            # of one instant: a constant couple
            table = {"times": tuple(time.tolist()), "moments": moments} if len(time) > 1 else {"moment": moments[0]}
            found[f"{name}.torque.{which}"] = BodyCouple(body=f"{hub.name}.hub", member=name, **table)
    return found


STANDSTILL = 1e-9
"""Rates below this (m/s, rad/s) count as standing still."""

UNMOVED = 1e-6
"""Accelerations below this (m/s^2, rad/s^2) at standstill count as none."""

HISTORIES = {
    "thrust": ("N", "actuator force, positive pushing the ends apart"),
    "length_rate": ("m/s", "rate of length"),
    "stroke": ("m", "length from the middle between its limits"),
    "actuator_power": ("W", "power of the thrust"),
    "screw_torque": ("N m", "torque on the screw, positive when it drives the member longer"),
    "screw_torque_frictionless": ("N m", "torque on the screw if it had no friction"),
    "axis_torque": ("N m", "torque about the member's axis from A to B, of the joint at B on the tube; at A the opposite"),
    "screw_speed": ("rad/s", "speed of the screw"),
    "motor_speed": ("rad/s", "speed of the motor"),
    "motor_torque": ("N m", "motor torque (torque constant x current)"),
    "motor_torque_frictionless": ("N m", "motor torque if the screw had no friction"),
    "holding_torque": ("N m", "motor torque that holds the load at standstill; 0 where the screw is self-locking"),
    "breakaway_torque": ("N m", "motor torque that starts the screw from rest here"),
    "current": ("A", "motor current"),
    "voltage": ("V", "motor voltage"),
    "mechanical_power": ("W", "motor torque x speed"),
    "electrical_power": ("W", "voltage x current"),
}
ROTARY = {
    "drive_torque": ("N m", "torque on the angle of a drive, positive when it turns it on"),
    "angle_rate": ("rad/s", "rate of that angle"),
}
AMPLIFIED = {"amplifier_input": ("V", "input of the amplifier")}


def evaluate(model: Model, motion: Motion, forces: Forces) -> Demand:
    """What the screw, gear and motor of every active member must deliver, and the gear and motor of every geared angle.

    Parameters
    ----------
    motion, forces : from `kinematics.follow` and `dynamics.inverse` of the same model. For ``forces.static`` the members
        stand still: the result holds the load at every pose.

    Returns
    -------
    Demand. Over (time, active): ``thrust`` N, ``length_rate`` m/s, ``stroke`` m, ``actuator_power`` W, ``screw_torque`` N m and
    ``screw_torque_frictionless``, ``axis_torque``, ``screw_speed`` rad/s, ``motor_speed``, ``motor_torque`` and
    ``motor_torque_frictionless``,
    ``holding_torque`` and ``breakaway_torque`` at the motor, ``current``, ``voltage``, ``mechanical_power``,
    ``electrical_power``, and ``amplifier_input`` V where there are amplifiers; NaN where a member has no screw or no motor.
    Drives of angles with a gear or a motor stand behind the active members (`Model.actuators`). They have ``drive_torque`` N m
    and ``angle_rate`` rad/s in place of thrust, length, stroke and screw, and `actuator_power` is that of their torque.
    Then the summary of `summarise`. ``.table()`` lists peaks against limits, worst first; `exceeded` tells when they are too
    high, and by how much.

    Notes
    -----
    The joints of a member must hold its screw: ``axis_torque`` is the torque about the axis from A to B that the joint at B
    exerts on the tube, and the joint at A the opposite on the base. A right-handed screw that drives the member longer turns in
    the negative sense about this axis, and the friction of its thread is included: the sign is that of ``screw_torque``,
    reversed for a left-handed thread. Pins and ball joints do not hold it; see `screw_couples`.

    A screw raises its load where the thrust does positive work (thrust x rate > 0), lowers it where it does negative work,
    and holds at standstill (rates below 1e-9 m/s); see `screw_torque` and `motor_demand`. Break-away is counted in the
    direction of the motion, at standstill in that of the acceleration, and where there is none against the load. Where a
    motor has an inductance, L i' counts; i' is the derivative of a spline through the samples of the current between two of
    its jumps (reversals of the motion or of the thrust): choose the samples accordingly.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"actuator": 0.01}, duration=1.0), samples=11)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> demand.motor_speed.sel(active="actuator").values[0].round(3).item()  # rad/s: G L'/lead = 5.2 * 0.01/0.003
    17.333
    >>> worst = demand.table()[0]
    >>> worst.part, worst.rule, worst.utilisation < 1
    ('actuator', 'voltage', True)
    """
    time = motion.arrays["time"].values
    columns = columns_of(model, motion, forces)
    every = model.actuators
    kept = HISTORIES | (ROTARY if len(every) > len(model.active) else {})
    kept |= AMPLIFIED if any(one.amplifier is not None for one in every.values()) else {}
    data = {
        key: variable(("time", "active"), _stacked(columns, key, len(time)), unit, words) for key, (unit, words) in kept.items()
    }
    attrs = {"kind": "demand", "load_case": forces.load_case}
    return Demand(
        data=summarised(model, time, data, attrs).later,
        status=forces.status,
        message=forces.message,
        provenance=provenance(model, load_case=forces.load_case),
    )


def _belongs(model: Model, motion: Motion, forces: Forces) -> None:
    """InputError unless motion and forces are of the same instants and places, and of the model's members and drives."""
    for what, found in (("motion", motion), ("forces", forces)):
        if found.arrays["member"].values.tolist() != list(model.whole.members):
            raise InputError(f"The {what} and the model have other members. Compute the {what} for this model.")
    if not np.array_equal(motion.arrays["time"].values, forces.arrays["time"].values):
        raise InputError("Motion and forces have other instants. Cut both alike.")
    length, along, system = motion.arrays["length"].values, forces.motion.arrays["length"].values, compile(model)
    if along.shape == length.shape and not np.array_equal(along, length):
        raise InputError("The forces were found along another motion than this. Compute them along it.")
    given = motion.attrs.get("trajectory_space") == "given"
    allowed = max(1e-6, 1.5 * motion.attrs.get("misfit", 1e-2)) if given else 1e-6
    off = np.abs(length - system.length0).max(axis=0, initial=0.0) > allowed * system.length0
    if (bad := np.flatnonzero(off & (system.kind == RIGID))).size:
        name, wanted = system.members[bad[0]], system.length0[bad[0]]
        raise InputError(
            f"The motion is not of this model: {name!r} is not {wanted:.6g} m long in it. Follow this model's own."
        )


def columns_of(model: Model, motion: Motion, forces: Forces) -> list[dict[str, NDArray[np.float64]]]:
    """Histories of each of `Model.actuators`, as far as its train is known: what `evaluate` puts together and sums up."""
    _belongs(model, motion, forces)
    names = list(model.active)
    still = bool(forces.attrs.get("at_rest", 0))
    pick = [list(motion.arrays["member"].values).index(name) for name in names]
    thrust = -forces.arrays["member_force"].values[:, pick]
    time = motion.arrays["time"].values
    length, rate, acceleration = (
        motion.arrays[name].values[:, pick] for name in ("length", "length_rate", "length_acceleration")
    )
    if still:
        rate, acceleration = np.zeros_like(rate), np.zeros_like(acceleration)
    found = [
        _member(parts_of(model, active), active, time, thrust[:, k], length[:, k], rate[:, k], acceleration[:, k])
        for k, active in enumerate(model.active.values())
    ]
    for name in list(model.actuators)[len(names) :]:
        torque, turning, change = (
            data[kind].values[:, list(data["drive"].values).index(name)]
            for data, kind in (
                (forces.arrays, "drive_force"),
                (motion.arrays, "drive_velocity"),
                (motion.arrays, "drive_acceleration"),
            )
        )
        nothing = np.zeros_like(turning)
        parts = parts_of(model, model.actuators[name])
        found.append(_angle(parts, time, torque, *(nothing, nothing) if still else (turning, change)))
    return found


def _member(
    parts: Parts,
    active: Active,
    time: NDArray[np.float64],
    thrust: NDArray[np.float64],
    length: NDArray[np.float64],
    rate: NDArray[np.float64],
    acceleration: NDArray[np.float64],
) -> dict[str, NDArray[np.float64]]:
    """Histories of one active member, as far as its drive train is known."""
    screw, gear, motor, _ = parts
    found = {"thrust": thrust, "length_rate": rate, "actuator_power": thrust * rate}
    if active.limits is not None:
        found["stroke"] = length - sum(active.limits) / 2
    if screw is None:
        return found
    moving = np.where(np.abs(rate) < STANDSTILL, 0.0, rate)
    torque, bare = screw_torque(screw, thrust, moving), thrust * screw.lead
    hand = 1.0 if screw.hand == "right" else -1.0
    found |= {
        "screw_torque": torque,
        "axis_torque": hand * torque,
        "screw_torque_frictionless": bare,
        "screw_speed": rate / screw.lead,
    }
    if motor is None:
        return found
    demand = _at_motor(parts, motor, time, torque, thrust, moving, acceleration)
    without = demand["motor_torque"] - at_motor(gear, torque, moving) + at_motor(gear, bare, moving)
    found |= demand | {"motor_torque_frictionless": without, "holding_torque": at_motor(gear, holding_torque(screw, thrust), 0)}
    heading = _heading(moving, acceleration, thrust)
    start = at_motor(gear, breakaway_torque(screw, thrust, heading), heading) + motor.friction_torque * heading
    found["breakaway_torque"] = start
    return found


def _angle(
    parts: Parts,
    time: NDArray[np.float64],
    torque: NDArray[np.float64],
    rate: NDArray[np.float64],
    acceleration: NDArray[np.float64],
) -> dict[str, NDArray[np.float64]]:
    """Histories of one drive of an angle: no screw, so no friction but that of motor and gear."""
    _, gear, motor, _ = parts
    found = {"drive_torque": torque, "angle_rate": rate, "actuator_power": torque * rate}
    if motor is None:
        return found
    moving = np.where(np.abs(rate) < STANDSTILL, 0.0, rate)
    demand = _at_motor(parts, motor, time, torque, torque, moving, acceleration)
    heading = _heading(moving, acceleration, torque)
    start = at_motor(gear, torque, heading) + motor.friction_torque * heading
    return (
        found
        | demand
        | {
            "motor_torque_frictionless": demand["motor_torque"],
            "holding_torque": at_motor(gear, torque, 0),
            "breakaway_torque": start,
        }
    )


def _at_motor(
    parts: Parts,
    motor: Motor,
    time: NDArray[np.float64],
    torque: NDArray[np.float64],
    load: NDArray[np.float64],
    moving: NDArray[np.float64],
    acceleration: NDArray[np.float64],
) -> dict[str, NDArray[np.float64]]:
    """What `motor_demand` tells, with the inductance, and the input of the amplifier; load : whose sign tells jumps."""
    screw, gear, _, amplifier = parts
    demand = motor_demand(screw, gear, motor, torque, moving, acceleration)
    if motor.inductance:
        change = current_rate(time, demand["current"], moving, load)
        demand = motor_demand(screw, gear, motor, torque, moving, acceleration, change)
    if amplifier is not None:
        driven = demand["voltage"] if amplifier.current_gain is None else demand["current"]
        demand["amplifier_input"] = driven / amplifier.gain
    return demand


def _heading(moving: NDArray[np.float64], acceleration: NDArray[np.float64], load: NDArray[np.float64]) -> NDArray[np.float64]:
    """Direction (1, -1) in which it starts: that of the motion, of the acceleration, or against the load."""
    way = np.sign(np.where(moving == 0, np.where(np.abs(acceleration) < UNMOVED, 0.0, acceleration), moving))
    return np.where(way == 0, np.where(load < 0, -1.0, 1.0), way)


def _stacked(columns: list[dict[str, NDArray[np.float64]]], key: str, count: int) -> NDArray[np.float64]:
    nothing = np.full(count, np.nan)
    return np.stack([column.get(key, nothing) for column in columns], axis=1) if columns else np.empty((count, 0))
