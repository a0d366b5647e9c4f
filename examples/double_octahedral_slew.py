"""A double-octahedral bay, hanging with 46 N at each top node, tilts from -10 to +10 degrees: forces, margins, motors."""

import math

import kinetruss as kt

TILT = math.radians(10)

model = kt.library.vgt.double_octahedral(
    beta=-TILT,
    gravity=(0, 0, 9.81),  # z points from the base to the top
    tip_force=(0, 0, 46),
    material=kt.library.materials.ALUMINIUM_LACY.with_(yield_strength=240e6),  # that of EN AW-6061 T6
    screw="screw_lacy_spatial",
    gear="gear_lacy",
    motor="motor_lacy",
)

for duration in (1, 12):
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-TILT, TILT), duration=duration), samples=241)
    forces = kt.dynamics.inverse(model, motion)
    demand = kt.actuators.evaluate(model, motion, forces)
    voltage = abs(demand.voltage).max().item()
    print(f"in {duration:2d} s: tension of M6 up to {forces.member_force.sel(member='M6').max().item():.3f} N,", end=" ")
    print(f"thrust of M7 up to {forces.drive_force.sel(drive='M7').max().item():.3f} N, motor voltage up to {voltage:.1f} V")
    verdict = kt.strength.check(model, forces)
    worst = verdict.table()[0]
    print(f"         highest utilisation {worst.utilisation:.4f}: {worst.part}, {worst.rule}, at {worst.time:.2f} s")
    if duration == 1:
        quarter = forces.end_force.sel(time=0.25, member="M6", end="B").item()

assert abs(quarter - 58.25112815) < 1e-7  # independent computation of the slew in 1 s
assert verdict.utilisation.max() < 1
assert voltage < 25  # what the motors bear
