"""Two geared motors turn an arm in the vertical plane: closed loops bring it up, a worm then holds it without current."""

import numpy as np

import kinetruss as kt

MOTOR = kt.Motor(
    inertia="0.2 kg cm^2", resistance=1.3, torque_constant=0.06, emf_constant=0.06, friction_torque=0.002, max_voltage=36,
    max_current=12,
)  # fmt: skip
WORM = kt.Gear(ratio=120, efficiency=0.45, back_efficiency=-0.2, inertia="0.1 kg cm^2")  # holds by itself
SPUR = kt.Gear(ratio=60, efficiency=0.9, inertia="0.1 kg cm^2")

arm = kt.Model(
    nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2.0), "C": kt.Node(at=(0.9, 0), mass=1.0)}, fixed=["A"],
    bars={"upper": kt.Bar(ends=("A", "B"), mass=0), "lower": kt.Bar(ends=("B", "C"), mass=0)}, gravity=(0, -9.81),
    drives={
        "shoulder": kt.AngleDrive("upper", gear=WORM, motor=MOTOR),
        "elbow": kt.HingeDrive(axis="B", start="A", end="C", gear=SPUR, motor=MOTOR),
    },
)  # fmt: skip

# %% Up in a second: the shoulder to 60 degrees, the elbow from 180 to 240
loops = {
    "shoulder": kt.PositionLoop(times=(0, 1), targets=(0, "60 deg"), settling_time=0.1),
    "elbow": kt.PositionLoop(times=(0, 1), targets=("180 deg", "240 deg"), settling_time=0.1),
}
up = kt.dynamics.simulate(arm, 1.3, tasks=loops, samples=131)
angles = np.degrees(up.motion.drive_position.values[-1])
print(f"shoulder at {angles[0]:.2f} deg, elbow at {angles[1]:.2f} deg, up to {np.abs(up.motor_current).max().item():.1f} A")
assert abs(angles[0] - 60) < 1
assert abs(angles[1] - 240) < 1  # friction and weight leave an error: there is no integral part

# %% What the sources gave is in windings, frictions, gears, rotors, and in the height of the masses
lifted = up.energy.values[-1] - up.energy.values[0]
print(f"{up.electrical_energy.values[-1].sum():.1f} J drawn, {lifted:.2f} J of them in the arm")
assert abs(up.actuator_work.values[-1].sum() - lifted) < 1e-7 * lifted
assert np.abs(up.motor_energy_balance).max() < 1e-7 * lifted

# %% Backwards: the motion asks for the currents that flowed
forces = kt.dynamics.inverse(arm, up.motion, static=False)
demand = kt.actuators.evaluate(arm, up.motion, forces)
moving = np.abs(up.motion.drive_velocity.values) > 1e-6
off = np.abs(demand.current.values - up.motor_current.values)[moving].max()
print(f"currents of the demand and of the simulation differ by {off:.1e} A")
assert off < 1e-6

# %% Without voltage the worm holds the shoulder; the elbow's spur gear runs back against its shorted motor
start = up.motion.position.isel(time=-1).values
off = {"shoulder": kt.StepInput(voltage=0), "elbow": kt.StepInput(voltage=0)}
down = kt.dynamics.simulate(arm, 1.0, tasks=off, positions=start, samples=11)
turned = np.degrees(np.ptp(down.motion.drive_position.values, axis=0))
print(f"without voltage: shoulder turns {turned[0]:.1g} deg, elbow {turned[1]:.1f} deg")
assert turned[0] < 1e-9
assert turned[1] > 5
