"""A facade opens its shades: what the actuators must bear in calm air and in wind."""

import math

import kinetruss as kt

model = kt.read(kt.library.example_files()["facade"][0])
run = model.runs["open"]
motion = kt.kinematics.follow(model, run.trajectory, samples=run.samples)
hinge, edge = (motion.position.sel(node=f"B1.{node}").values for node in ("C2", "T2"))
angle = [math.degrees(math.atan2(y, -z)) for _, y, z in (edge - hinge)[[0, -1]]]
print(f"shades from {angle[0]:.2f} to {angle[1]:.2f} degrees")

thrust = {}
for case in model.load_cases:
    forces = kt.dynamics.inverse(model, motion, load_case=case)
    worst = kt.strength.check(model, forces).table()[0]
    demand = kt.actuators.evaluate(model, motion, forces)
    thrust[case] = forces.drive_force.isel(time=0).sel(drive=["B1.lift2", "B1.lift3"]).sum().item()
    largest = forces.drive_force.max().item()
    print(f"{case}: thrust up to {largest:.1f} N, {worst.part} governs with {100 * worst.utilisation:.1f} % of {worst.rule}")
    assert worst.utilisation < 1
    assert not kt.actuators.exceeded(demand)

# The wind of 225 N at each of two corners turns the shade about its hinge; both struts together hold it.
rise = -(edge - hinge)[0, 2]
foot = motion.position.sel(node="B1.A2").values[0]
u = (edge[0] - foot) / math.dist(edge[0], foot)
lever = (edge - hinge)[0, 1] * u[2] - (edge - hinge)[0, 2] * u[1]
print(f"the wind adds {thrust['wind'] - thrust['calm']:.3f} N at the start, moments about the hinge {450 * rise / lever:.3f} N")
assert abs(angle[0] - 40) < 0.01
assert abs(angle[1] - 90) < 0.01
assert math.isclose(thrust["wind"] - thrust["calm"], 450 * rise / lever, rel_tol=1e-9)
