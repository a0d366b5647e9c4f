"""Screws, gears and motors: closed forms, energy, a train alone against one in a structure, forwards against backwards."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, change, missed, off, share

simulate, simulate_drive = kt.dynamics.simulate, kt.actuators.simulate_drive

FINE = kt.DOP853(rtol=1e-11, atol=1e-12)
LACY, SCREW, PLANAR = (getattr(kt.library.drives, name) for name in ("TRAIN_LACY", "SCREW_LACY_SPATIAL", "SCREW_LACY_PLANAR"))
LOSSY = LACY.with_(
    gear=kt.Gear(ratio=5.2, efficiency=0.8, inertia=1e-6), motor=LACY.motor.with_(friction_torque=1e-3, inductance=2e-2)
)
STEEP = kt.LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1)
TRAINS: dict[str, tuple[kt.DriveTrain, Any]] = {
    "pulse": (LACY, kt.StepInput(voltage=12.0, start=0.1, end=0.4)),
    "reversals": (LOSSY, kt.SineInput(voltage=20.0, period=0.25)),
    "driven_back": (LOSSY.with_(screw=STEEP), kt.StepInput(voltage=0.0)),
    "sticking": (LACY.with_(screw=SCREW.with_(static_friction=0.35)), kt.SineInput(voltage=8.0, period=0.4)),
    "saturated_loop": (
        LACY.with_(amplifier=kt.Amplifier(voltage_gain=3.0, max_voltage=9.0)),
        kt.PositionLoop(target=1.002, settling_time=0.2),
    ),
}
MASS, ARM = 1.7, 0.4
"""kg and m of the crank."""
GEAR, MOTOR = kt.Gear(ratio=12.0, inertia=3e-6), kt.Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06)
USED, RUBBING = GEAR.with_(efficiency=0.85), MOTOR.with_(friction_torque=0.004)
WORM = kt.Gear(ratio=40.0, efficiency=0.4, back_efficiency=-0.1, inertia=1e-5)
CRANKS: dict[str, tuple[kt.Gear, kt.Motor, Any]] = {
    "efficiency": (USED, RUBBING.with_(inductance=2e-3), kt.SineInput(voltage=20.0, period=0.25)),
    "worm": (WORM, RUBBING, kt.SineInput(voltage=15.0, period=0.6)),
    "torque": (USED, RUBBING, kt.SineInput(torque=0.2, period=0.5)),
}


def cylinder(train: kt.DriveTrain, mass: float, push: float = 0.0) -> kt.Model:
    """An active member on a line, 1 m long, that moves a mass (kg) against a force (N); half a kilogram moves with it."""
    rods = {"base": kt.Part(length=0.6, mass=2.0), "tube": kt.Part(length=0.4, mass=0.5)}
    parts = {"screw": train.screw, "gear": train.gear, "motor": train.motor, "amplifier": train.amplifier}
    return kt.Model(
        nodes={"A": (0.0, 0.0), "B": kt.Node(at=(1.0, 0.0), mass=mass)},
        fixed={"A": "xy", "B": "y"},
        active={"M": kt.Active(ends=("A", "B"), **rods, **parts)},
        loads={"push": kt.NodalForce(node="B", force=(-push, 0.0))},
    )


def turning(kind: str, gear: kt.Gear, motor: kt.Motor) -> kt.Model:
    """A point mass on a crank: driven at the angle of its bar in the plane, or at a hinge in space."""
    plain = model(f"crank.{kind}")
    return plain.with_(drives={"turn": plain.drives["turn"].with_(gear=gear, motor=motor)})


def demands() -> Numbers:
    """Torques at 74.5 N, voltages at standstill as the thesis has them (load not divided by the gear) and right, back-emf.

    The forces are those of M8 at both ends of the slew in section 5.7, whose mean rate the last number takes.
    """
    raised, lesser = (kt.actuators.raising_torque(SCREW, force) for force in (74.5, 29.5))

    def voltage(gear: kt.Gear, torque: Any, rate: float = 0.0) -> Any:
        return kt.actuators.motor_demand(SCREW, gear, LACY.motor, torque, rate, 0.0)["voltage"]

    return {
        "torque_with_load": -kt.actuators.screw_torque(SCREW, 74.5, -1.0),
        "torque_against_load": kt.actuators.screw_torque(SCREW, 74.5, 1.0),
        "voltage_without_gear_74.5N": voltage(kt.Gear(ratio=1.0), raised),
        "voltage_without_gear_29.5N": voltage(kt.Gear(ratio=1.0), lesser),
        "voltage_74.5N": voltage(kt.library.drives.GEAR_LACY, raised),
        "back_emf_per_speed": voltage(kt.library.drives.GEAR_LACY, 0.0, 1.0),
        "back_emf_of_slew": voltage(kt.library.drives.GEAR_LACY, 0.0, 0.1212 / 5.5),
        "torque_at_the_self_locking_limit": kt.actuators.lowering_torque(PLANAR, 100.0),
    }


def locking() -> Numbers:
    """Lowering torque at the limit, square and trapezoidal thread; difference it makes to a drive that lowers a load."""
    flank = math.radians(15)
    acme = kt.LeadScrew(lead=0.1 * 0.006 / math.cos(flank), mean_diameter=0.012, friction=0.1, flank=flank)
    train, back = kt.DriveTrain(screw=PLANAR, motor=LACY.motor), kt.StepInput(voltage=-1.0)
    loaded, empty = (simulate_drive(train, back, load=load, duration=0.5, samples=11).length.values for load in (100.0, 0.0))
    torques = {"square_thread": PLANAR, "trapezoidal_thread": acme}
    found = {name: kt.actuators.lowering_torque(screw, 1.0) for name, screw in torques.items()}
    return found | {"lowering_a_load": np.abs(loaded - empty).max()}


def energy() -> Numbers:
    """Errors of the balance: forwards as a fraction of the energy, backwards of the largest power."""
    found, lossy = {}, LOSSY.with_(motor=LOSSY.motor.with_(inductance=2e-3))
    load, history = kt.DriveLoad(thrust=100.0, mass=10.0), kt.SineInput(voltage=20.0, period=0.5)
    for name, train in (("self_locking", lossy), ("driven_back", lossy.with_(screw=STEEP))):
        run = simulate_drive(train, history, load=load, duration=1.0, samples=201)
        found[f"forward_{name}"] = share(run.energy_balance.values, run.electrical_energy.values)
        moved = cylinder(train, 12.0, 300.0)
        motion = kt.kinematics.follow(moved, kt.Cyclic(moves={"M": (1.0, 1.05)}, period=1.0), samples=201)
        flow = kt.actuators.power_flow(moved, motion, _demand(moved, motion))
        found[f"inverse_{name}"] = share(flow["balance"], flow["electrical"])
    return found


def _demand(of: kt.Model, motion: kt.results.Motion) -> kt.results.Demand:
    return kt.actuators.evaluate(of, motion, kt.dynamics.inverse(of, motion, static=False))


def round_trip() -> Numbers:
    """Largest differences of voltage and current, as fractions of the largest: sample by sample, and through a whole model."""
    history, load = kt.ExponentialInput(voltage=(0.0, 12.0), time_constant=0.3), kt.DriveLoad(thrust=300.0, mass=12.5)
    run = simulate_drive(LACY, history, load=load, duration=1.0, samples=1001)
    rate, times = run.length_rate.values, run.time.values
    torque = kt.actuators.screw_torque(SCREW, run.thrust.values, rate)
    by_sample = kt.actuators.motor_demand(SCREW, LACY.gear, LACY.motor, torque, rate, run.length_acceleration.values)
    moved = cylinder(LACY, 12.0, 300.0)
    whole = _demand(moved, kt.kinematics.follow(moved, run.trajectory("M"), times=times)).data
    moving, away = rate != 0, times > run.episodes[0].end + 0.02
    found: dict[str, float] = {}
    for name in ("voltage", "current"):
        given = run.data[name].values
        found[f"{name}_by_sample"] = share((by_sample[name] - given)[moving], given)
        found[f"{name}_by_model"] = share((whole[name].values[:, 0] - given)[away], given)
    return found


def poles() -> Numbers:
    """Lengths of a position loop without friction after a step of 1 mm, as fractions of the step, by kinds of amplifiers."""
    found: Numbers = {}
    times = (0.05, 0.1, 0.2, 0.3, 0.5)
    smooth = LACY.with_(screw=SCREW.with_(friction=0.0), motor=LACY.motor.with_(max_voltage=None))
    loop = kt.PositionLoop(target=1.001, settling_time=0.5, damping=0.8)
    for name, amplifier in (("current", kt.Amplifier(current_gain=1.8)), ("voltage", kt.Amplifier(voltage_gain=3.0))):
        train = smooth.with_(amplifier=amplifier)
        run = simulate_drive(train, loop, load=kt.DriveLoad(mass=12.0), duration=0.5, times=times)
        found |= {f"{name}_at_{t:g}s": (x - 1) * 1e3 for t, x in zip(times, run.length.values, strict=True)}
    return found


def crank() -> Numbers:
    """A geared crank in the vertical plane from 0.2 to 2.6 rad: the motor lifts it, and after the top it drives the motor."""
    raised = turning("angle", USED, RUBBING).with_(gravity=(0.0, -9.81))
    motion = kt.kinematics.follow(raised, kt.Quintic(moves={"turn": (0.2, 2.6)}, duration=1.5), samples=301)
    found = _demand(raised, motion)
    flow = kt.actuators.power_flow(raised, motion, found)
    names = ("drive_torque", "motor_speed", "motor_torque", "current", "voltage", "electrical_power")
    at = {place: {name: found.data[name][k, 0] for name in names} for place, k in (("driving", 90), ("driven", 240))}
    return at | {"balance": share(flow["balance"], flow["electrical"])}


def delta() -> Numbers:
    """Power of the three motors of a Delta robot less their losses and stored energy, against the rate of its energy."""
    plain = kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7))
    drives = {name: drive.with_(gear=USED, motor=RUBBING) for name, drive in plain.drives.items()}
    robot, s = plain.with_(drives=drives, gravity=(0.0, 0.0, -9.81)), np.linspace(0.0, 1.0, 201)
    way = np.add([[0.0], [0.0], [-0.7]], np.outer((0.15, -0.1, -0.12), 10 * s**3 - 15 * s**4 + 6 * s**5))
    path = kt.Spline(times=tuple(0.4 * s), values={f"Q.{axis}": tuple(row) for axis, row in zip("xyz", way, strict=True)})
    motion = kt.kinematics.inverse(robot, path, samples=201)
    forces = kt.dynamics.inverse(robot, motion)
    flow = kt.actuators.power_flow(robot, motion, kt.actuators.evaluate(robot, motion, forces))
    supplied = flow["electrical"].sum(axis=1)
    spent = sum(flow[name].sum(axis=1) for name in ("copper", "motor", "gear", "stored"))
    return {"power": share(supplied - spent - forces.data["energy_rate"], supplied)}


def pushed() -> Numbers:
    """Length after 1 s under 50 N."""
    method = kt.DOP853(rtol=1e-12, atol=1e-13)
    run = simulate(cylinder(LACY, 12.0), 1.0, samples=3, tasks={"M": kt.GivenForce(force=50.0)}, method=method)
    return {"force": run.motion.length.values[-1, 0]}


def alone(name: str) -> Numbers:
    """Largest differences of lengths and currents from the train alone, of their ranges; `default`: by default settings."""
    if name == "default":
        return _beside(cylinder(LACY, 12.0), kt.StepInput(voltage=6.0), kt.DriveLoad(mass=12.5), 1.0, 101, None, 1e-9)[1]
    train, history = TRAINS[name]
    return _beside(cylinder(train, 12.0, 60.0), history, kt.DriveLoad(thrust=60.0, mass=12.5), 0.5, 26)[1]


def crank_alone(name: str) -> Numbers:
    """The same of angles, on the crank; error of the energy balance."""
    gear, motor, history = CRANKS[name]
    run, found = _beside(turning("angle", gear, motor), history, kt.DriveLoad(inertia=MASS * ARM**2), 0.6, 31)
    return found | {"energy": _unbalanced(run)}


def _beside(
    of: kt.Model, history: Any, load: kt.DriveLoad, end: float, samples: int, method: Any = FINE, rtol: float = 1e-11
) -> tuple[kt.results.Simulation, dict[str, float]]:
    """A run with the drive in the structure; its differences from a run of the train alone."""
    (drive,) = of.all_drives
    key = "length" if drive in of.active else "angle"
    run = simulate(of, end, samples=samples, tasks={drive: history}, method=method)
    train, length = kt.actuators.train_of(of, drive), 1.0 if drive in of.active else None
    same = simulate_drive(train, history, load=load, duration=end, samples=samples, rtol=rtol, length=length)
    current = missed(run.data.motor_current.values[:, 0], same.current.values)
    return run, {key: missed(run.motion.drive_position.values[:, 0], same.data[key].values), "current": current}


def _unbalanced(run: kt.results.Simulation) -> float:
    """Error of the energy balance of all motors, of the largest energy taken."""
    return share(run.data.motor_energy_balance.values, run.data.electrical_energy.values)


def run_up() -> Numbers:
    """Largest difference of lengths from the closed form, as a fraction of the stroke."""
    train = LACY.with_(screw=SCREW.with_(friction=0.0))
    task = {"M": kt.StepInput(voltage=10.0)}
    run = simulate(cylinder(train, 12.0, 60.0), 0.3, samples=31, tasks=task, method=FINE)
    way, *_ = _closed(run, LACY.motor, LACY.gear, LACY.gear.ratio / SCREW.lead, 12.5, 10.0, 60.0)
    return {"run_up": missed(run.motion.length.values[:, 0], 1 + way)}


def _closed(run: Any, motor: kt.Motor, gear: kt.Gear, n: float, mass: float, voltage: float, push: float = 0.0) -> Any:
    """Way and rate of a mass or inertia behind a motor that turns n rad for each unit, current, and force on the mass."""
    R, K, t = motor.resistance, motor.torque_constant, run.motion.time.values
    tau = R * (mass + (motor.inertia + gear.inertia) * n**2) / (K * n) ** 2
    last, decay = (voltage - push / n * R / K) / (K * n), np.exp(-t / tau)
    return last * (t - tau * (1 - decay)), last * (1 - decay), voltage / R * decay, mass * last / tau * decay


def crank_run_up(kind: str) -> Numbers:
    """Largest differences of angle, rate, current and torque on the crank from the closed form, as fractions of the largest."""
    task = {"turn": kt.StepInput(voltage=12.0)}
    run = simulate(turning(kind, GEAR, MOTOR), 0.6, samples=31, tasks=task, method=FINE)
    exact = _closed(run, MOTOR, GEAR, GEAR.ratio, MASS * ARM**2, 12.0)
    own = (run.motion.drive_position, run.motion.drive_velocity, run.data.motor_current, run.forces.drive_force)
    values = (off(one.values[:, 0], right) for one, right in zip(own, exact, strict=True))
    return dict(zip(("angle", "rate", "current", "torque"), values, strict=True))


def loop() -> Numbers:
    """A position loop turns a hinge: largest difference from the closed form, as a fraction of the target."""
    asked = kt.PositionLoop(target=1.2, settling_time=0.4)
    run = simulate(turning("hinge", GEAR, MOTOR), 0.8, samples=41, tasks={"turn": asked}, method=FINE)
    w, zeta, t = asked.natural_frequency, asked.damping, run.motion.time.values
    wd = w * math.sqrt(1 - zeta**2)
    exact = 1.2 * (1 - np.exp(-zeta * w * t) * (np.cos(wd * t) + zeta * w / wd * np.sin(wd * t)))
    return {"angle": float(np.abs(run.motion.drive_position.values[:, 0] - exact).max() / 1.2)}


def bay() -> Numbers:
    """Three motors of a bay in closed loop: current and voltage backwards; energy; one of them without voltage."""
    gear, motor = kt.library.drives.GEAR_LACY, LACY.motor
    truss = kt.library.vgt.double_octahedral(tip_force=(0.0, 0.0, -46.0), screw=SCREW, gear=gear, motor=motor)
    run, found = _closed_loops(truss, {"M7": 1.160, "M9": 1.175, "M11": 1.172}, 0.4, 0.6, 61, 1e-8)
    tasks = {"M7": kt.StepInput(voltage=20.0), "M9": kt.StepInput(voltage=0.0)}
    locked = simulate(truss, 0.2, samples=3, tasks=tasks).motion.length.sel(member="M9").values
    return found | {"energy": _unbalanced(run), "locked": change(locked)}


def robot() -> Numbers:
    """Three motors of the robot of five freedoms in closed loop: current and voltage backwards, energy of all."""
    plain, targets = kt.library.mechanisms.robot(gravity=(0.0, 0.0, -9.81)), {"swing": 0.6, "shoulder": -0.3, "wrist": -1.0}
    motor = RUBBING.with_(inertia=1e-4, torque_constant=0.1, emf_constant=0.1, resistance=0.5)
    train = {"gear": kt.Gear(ratio=80.0, efficiency=0.8, inertia=1e-5), "motor": motor}
    drives = {name: one.with_(**train) if name in targets else one for name, one in plain.drives.items()}
    run, found = _closed_loops(plain.with_(drives=drives), targets, 0.3, 0.4, 21, 1e-6)
    total, work = run.data.energy.values, run.data.actuator_work.values.sum(axis=1)
    return found | {"energy": float(np.abs(total - total[0] - work).max() / np.ptp(total))}


def _closed_loops(
    of: kt.Model, targets: dict[str, float], settling: float, end: float, samples: int, least: float
) -> tuple[kt.results.Simulation, dict[str, float]]:
    """A run by position loops; current and voltage backwards from its motion, where drives move, of the largest."""
    tasks = {name: kt.PositionLoop(target=target, settling_time=settling) for name, target in targets.items()}
    run = simulate(of, end, samples=samples, tasks=tasks)
    demand, names = _demand(of, run.motion).data, list(targets)
    moving = np.abs(run.motion.drive_velocity.sel(drive=names).values) > least
    found = {}
    for name in ("current", "voltage"):
        given = run.data[f"motor_{name}"].values
        found[name] = share((demand[name].sel(active=names).values - given)[moving], given)
    return run, found
