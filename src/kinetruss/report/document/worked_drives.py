"""Worked demands on drives: stroke, or screw torque, efficiency, motor torque, speed, current and voltage, step by step."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators
from kinetruss.actuators.demand_summary import current_rate
from kinetruss.actuators.demands import STANDSTILL, UNMOVED
from kinetruss.report.document.sheets import Sheet

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Demand, Motion, Row


SCREW = "Shigley, Mechanical Engineering Design, power screws; Lacy (1991), eq. 2.36 to 2.38"
FINE = 8
"""Significant digits of lengths whose difference counts."""
LISTED = 121
"""Number of samples up to which those of an integral are listed."""
MOTOR = "Lacy (1991), eq. 2.40 and 4.78"
ENGINE = "of the run at this instant"
TRAIN = "drive train of the model"
RAISED, LOWERED = "d/2*abs(F)*(t + f)/(1 - f*t)", "d/2*abs(F)*(f - t)/(1 + f*t)"
"""Torque on a screw that raises, and that lowers its load."""
RESULTS = {
    "speed": ("omega", "rad/s"),
    "torque": ("T_m", "N m"),
    "current": ("i", "A"),
    "voltage": ("U", "V"),
    "break-away": ("T_0", "N m"),
    "input": ("U_in", "V"),
    "rms current": ("i_rms", "A"),
    "rms torque": ("T_rms", "N m"),
}
"""Quantity -> symbol and unit of its demand."""


def drive_sheet(model: Model, motion: Motion, demand: Demand, row: Row) -> Sheet:
    """The demand of one entry of a demand table, worked from the thrust or torque of its drive at its instant."""
    sheet = Sheet(title=f"{row.part}: {row.rule}", row=row)
    if row.rule == "stroke":
        return _stroke(sheet, model, motion, row)
    column = _Column(demand, row.part)
    symbol, unit = RESULTS[row.rule]
    if row.rule.startswith("rms "):
        _rms(sheet, column, row.rule, symbol, unit)
    elif row.rule == "break-away":
        _from_rest(sheet, model, motion, column, column.sample(row.time), row.part)
    else:
        _chain(sheet, model, motion, column, column.sample(row.time), row.part)
        if row.rule == "input":
            _input(sheet, model, row.part)
    limit = symbol.partition("_")[0] + "_max"
    sheet.give(limit, f"limit of {row.rule}", row.limit, unit, "motor or amplifier of the model")
    return sheet.close(symbol, limit)


class _Column:
    """Histories of one drive."""

    def __init__(self, demand: Demand, name: str) -> None:
        self.data, self.time = demand.data, demand.data["time"].values
        self.k = demand.data["active"].values.tolist().index(name)

    def of(self, name: str) -> Any:
        return self.data[name].values[:, self.k]

    def sample(self, time: float) -> int:
        return int(np.flatnonzero(self.time == time)[0])


def _stroke(sheet: Sheet, model: Model, motion: Motion, row: Row) -> Sheet:
    sheet.digits = FINE  # the stroke is a small difference of lengths
    least, most = model.active[row.part].limits or (math.nan, math.nan)
    k = int(np.flatnonzero(motion.whole["time"].values == row.time)[0])
    length = motion.whole["length"].values[k, list(model.members).index(row.part)]
    sheet.give("L", "length of the member", float(length), "m", ENGINE)
    sheet.give("L_1", "shortest length", least, "m", TRAIN)
    sheet.give("L_2", "greatest length", most, "m", TRAIN)
    sheet.step("s", "stroke from the middle", "L - (L_1 + L_2)/2", "m")
    sheet.step("s_allow", "allowed stroke", "(L_2 - L_1)/2", "m")
    return sheet.close("s", "s_allow")


def _chain(sheet: Sheet, model: Model, motion: Motion, column: _Column, k: int, name: str) -> None:
    """From the load of the drive to motor torque, speed, current and voltage."""
    train = actuators.train_of(model, name)
    linear = name in model.active
    moving, change = _rates(model, motion, column, k, name)
    load = _screw(sheet, train.screw, float(column.of("thrust")[k]), moving) if linear else _torque(sheet, column, k)
    rate = "v" if linear else "omega_a"
    unit = "m/s" if linear else "rad/s"
    lead = "/lead" if linear else ""
    sheet.give(rate, f"rate of the {'length' if linear else 'angle'}", moving, unit, ENGINE)
    sheet.give("a", f"acceleration of the {'length' if linear else 'angle'}", change, f"{unit}²", ENGINE)
    gear, motor = train.gear, train.motor
    sheet.give("G", "gear ratio", gear.ratio, "", TRAIN)
    sheet.step("omega", "speed of the motor", f"G*{rate}{lead}", "rad/s", MOTOR)
    sheet.step("omega_dot", "its acceleration", f"G*a{lead}", "rad/s²", MOTOR)
    _at_motor(sheet, gear, load, moving, "T_s" if linear else "T_a", "T_g", "torque at the motor")
    sheet.give("J_m", "inertia of motor and gear at the motor", motor.inertia + gear.inertia, "kg m²", motor.source or TRAIN)
    sheet.give("T_f", "friction torque of the motor", motor.friction_torque, "N m", motor.source or TRAIN)
    sheet.step("T_m", "torque of the motor", "T_g + J_m*omega_dot + T_f*sign(omega)", "N m", MOTOR)
    if linear and train.screw is not None and train.screw.static_friction is not None:
        _break_away(sheet, train, _heading(moving, change, float(column.of("thrust")[k])))
    sheet.give("K_t", "torque constant", motor.torque_constant, "N m/A", motor.source or TRAIN)
    sheet.give("K_b", "back-emf constant", motor.emf_constant, "V s/rad", motor.source or TRAIN)
    sheet.give("R", "resistance of the winding", motor.resistance, "ohm", motor.source or TRAIN)
    sheet.step("i", "current", "T_m/K_t", "A", MOTOR)
    voltage = "R*i + K_b*omega"
    if motor.inductance:
        rates = current_rate(column.time, column.of("motor_torque") / motor.torque_constant, *_signs(model, column, name))
        sheet.give("L", "inductance of the winding", motor.inductance, "H", motor.source or TRAIN)
        sheet.give("i_dot", "rate of the current, of a spline through its samples", float(rates[k]), "A/s", ENGINE)
        voltage += " + L*i_dot"
    sheet.step("U", "voltage", voltage, "V", MOTOR)
    sheet.step("P_el", "electrical power", "U*i", "W")


def _rates(model: Model, motion: Motion, column: _Column, k: int, name: str) -> tuple[float, float]:
    """Rate and acceleration of the length or angle of a drive; rates near standstill are 0."""
    if name in model.active:
        member = list(model.members).index(name)
        rate, change = column.of("length_rate")[k], motion.whole["length_acceleration"].values[k, member]
    else:
        drive = motion.whole["drive"].values.tolist().index(name)
        rate, change = column.of("angle_rate")[k], motion.whole["drive_acceleration"].values[k, drive]
    return 0.0 if abs(rate) < STANDSTILL else float(rate), float(change)


def _signs(model: Model, column: _Column, name: str) -> tuple[Any, Any]:
    """Rates and loads whose signs tell where the current jumps."""
    rate = column.of("length_rate" if name in model.active else "angle_rate")
    return np.where(np.abs(rate) < STANDSTILL, 0.0, rate), column.of("thrust" if name in model.active else "drive_torque")


def _torque(sheet: Sheet, column: _Column, k: int) -> float:
    """Torque on a driven angle."""
    return sheet.give("T_a", "torque on the angle, positive when it turns it on", column.of("drive_torque")[k], "N m", ENGINE)


def _thread(sheet: Sheet, screw: Any, thrust: float) -> None:
    """Thrust, and the data of the thread."""
    sheet.give("F", "thrust, positive pushing the ends apart", thrust, "N", "minus the tension of the member at this instant")
    sheet.give("lead", "lead of the screw", screw.lead, "m/rad", TRAIN)
    sheet.give("d", "mean diameter of the thread", screw.mean_diameter, "m", TRAIN)
    sheet.give("alpha", "half-angle of the thread", screw.flank, "rad", TRAIN)
    sheet.step("t", "slope of the thread", "2*lead/d", "", SCREW)


def _screw(sheet: Sheet, screw: Any, thrust: float, moving: float) -> float:
    """Torque on the screw; its efficiency where it raises its load."""
    _thread(sheet, screw, thrust)
    sheet.give("mu", "friction coefficient", screw.friction, "", TRAIN)
    sheet.step("f", "friction at its flank", "mu*sec(alpha)", "", SCREW)
    if moving == 0:
        held = "0*F" if screw.lead <= screw.mean_diameter / 2 * sheet.values["f"] * (1 + 1e-12) else f"-sign(F)*{LOWERED}"
        return sheet.step("T_s", "torque that holds the screw", held, "N m", SCREW)
    raises = thrust * moving >= 0
    sign = "" if moving > 0 else "-"
    words = "raises its load" if raises else "lowers its load"
    found = sheet.step("T_s", f"torque on the screw, which {words}", sign + (RAISED if raises else LOWERED), "N m", SCREW)
    if raises and thrust:
        sheet.step("eta_s", "efficiency of the screw", "abs(F)*lead/abs(T_s)", "%", SCREW)
    return found


def _at_motor(sheet: Sheet, gear: Any, load: float, moving: float, behind: str, symbol: str, words: str) -> None:
    """A torque behind the gear at the motor."""
    power = load * moving
    if power > 0:
        if "eta" not in sheet.values:
            sheet.give("eta", "efficiency of the gear, towards the load", gear.efficiency, "", TRAIN)
        sheet.step(symbol, words, f"{behind}/(G*eta)", "N m", MOTOR)
    elif power < 0:
        if "eta_b" not in sheet.values:
            sheet.give("eta_b", "efficiency of the gear, back to the motor", gear.backwards, "", TRAIN)
        sheet.step(symbol, words, f"{behind}*eta_b/G", "N m", MOTOR)
    else:
        holds = gear.self_locking
        sheet.step(symbol, f"{words}, held by the gear" if holds else words, f"{'0*' if holds else ''}{behind}/G", "N m", MOTOR)


def _from_rest(sheet: Sheet, model: Model, motion: Motion, column: _Column, k: int, name: str) -> None:
    """The torque at the motor that starts the drive from rest in the pose of a sample."""
    train = actuators.train_of(model, name)
    linear = name in model.active
    heading = _heading(*_rates(model, motion, column, k, name), float(column.of("thrust" if linear else "drive_torque")[k]))
    if linear:
        _thread(sheet, train.screw, float(column.of("thrust")[k]))
    else:
        _torque(sheet, column, k)
    sheet.give("G", "gear ratio", train.gear.ratio, "", TRAIN)
    sheet.give("T_f", "friction torque of the motor", train.motor.friction_torque, "N m", train.motor.source or TRAIN)
    _break_away(sheet, train, heading)


def _heading(moving: float, change: float, load: float) -> float:
    """Direction in which a drive starts: that of the motion, of the acceleration, or against the load."""
    way = moving or (change if abs(change) >= UNMOVED else 0.0) or load
    return -1.0 if way < 0 else 1.0


def _break_away(sheet: Sheet, train: Any, heading: float) -> None:
    """From thrust, or torque on the angle, to the torque at the motor that starts the drive from rest."""
    behind, load = "T_a", sheet.values.get("T_a", 0.0)
    if train.screw is not None:
        at_rest = train.screw.static_friction
        words = "friction coefficient at rest" + (", that of the running screw" if at_rest is None else "")
        sheet.give("mu_0", words, train.screw.friction if at_rest is None else at_rest, "", TRAIN)
        sheet.step("f_0", "friction at the flank, at rest", "mu_0*sec(alpha)", "", SCREW)
        raises = sheet.values["F"] * heading >= 0
        torque = RAISED.replace("f", "f_0") if raises else LOWERED.replace("f", "f_0")
        sign, behind = "" if heading > 0 else "-", "T_s0"
        words = f"torque that starts the screw, which {'raises' if raises else 'lowers'} its load"
        load = sheet.step(behind, words, sign + torque, "N m", SCREW)
    _at_motor(sheet, train.gear, load, heading, behind, "T_g0", "the same at the motor")
    sign = "+" if heading > 0 else "-"
    sheet.step("T_0", "break-away torque at the motor", f"T_g0 {sign} T_f", "N m", MOTOR)


def _input(sheet: Sheet, model: Model, name: str) -> None:
    amplifier: Any = actuators.train_of(model, name).amplifier
    current = amplifier.current_gain is not None
    sheet.give("g", "gain of the amplifier", amplifier.gain, "A/V" if current else "V/V", amplifier.source or TRAIN)
    sheet.step("U_in", "input of the amplifier", "i/g" if current else "U/g", "V")


def _rms(sheet: Sheet, column: _Column, rule: str, symbol: str, unit: str) -> None:
    """Root mean square over the run, by the trapezoidal rule over its samples."""
    values = column.of("current" if rule == "rms current" else "motor_torque") ** 2
    span = float(column.time[-1] - column.time[0]) if len(column.time) > 1 else 0.0
    total = float(np.sum(np.diff(column.time) * (values[1:] + values[:-1])) / 2) if span else float(values.sum())
    letter = "i" if rule == "rms current" else "T_m"
    sheet.give("Q", f"integral of {letter}² over the run, trapezoidal rule", total, f"{unit.replace(' ', '·')}² s", ENGINE)
    sheet.give("t_e", "duration of the run", span or 1.0, "s", ENGINE)
    if len(values) <= LISTED:
        sheet.samples = [
            ("t", "s", list(column.time)),
            (letter, unit, list(column.of("current" if letter == "i" else "motor_torque"))),
        ]
    sheet.step(symbol, f"root mean square of {'the current' if letter == 'i' else 'the motor torque'}", "sqrt(Q/t_e)", unit)
