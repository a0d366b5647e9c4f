"""A mast of twenty bays raises an antenna: mobility, what governs it, work of its sixty drives."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["mast"][0])
mobility = kt.kinematics.mobility(model)
print(
    f"{len(model.driven_members)} drives, {mobility.undriven} freedoms that no drive holds, {mobility.self_stress} self-stress"
)

run = model.runs["deploy"]
motion = kt.kinematics.follow(model, run.trajectory, samples=run.samples)
top = motion.position.sel(node=["B20.N7", "B20.N8", "B20.N9"], axis="z").mean("node").values
print(f"antenna from {top[0]:.2f} m to {top[-1]:.2f} m")

for case in model.load_cases:
    forces = kt.dynamics.inverse(model, motion, load_case=case)
    work = np.trapezoid((forces.drive_force * motion.drive_velocity).values, motion.time, axis=0).sum()
    worst = kt.strength.check(model, forces).table()[0]
    demand = kt.actuators.evaluate(model, motion, forces)
    print(f"{case}: {worst.part} governs, {100 * worst.utilisation:.1f} % of {worst.rule} at {worst.time:.0f} s;", end=" ")
    print(f"drives do {work / 1e3:.2f} kJ, motors draw up to {abs(demand.current).max().item():.2f} A")
    assert worst.utilisation < 1
    assert not kt.actuators.exceeded(demand)

assert mobility.undriven == mobility.self_stress == 0
assert np.allclose(top[[0, -1]], [20 * 0.49, 20 * 1.26])
