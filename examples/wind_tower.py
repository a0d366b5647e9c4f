"""A tower bends in wind, and its actuators straighten it: lengths, forces, work, motors."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["wind_tower"][0])
top = ["B8.N4", "B8.N5", "B8.N6"]

# %% Wind without actuation: elastic members, actuators locked.
standing = kt.statics.at_poses(model, [{}], load_case="wind")
bent = kt.statics.deflection(model, standing)
lean = bent.displacement.isel(time=0).sel(node=top)
print(f"wind pushes the top {1e3 * lean.sel(axis='y').mean().item():.2f} mm aside,", end=" ")
print(f"strain energy {bent.energy.item():.1f} J")

# %% Six lengths for six coordinates: all of the place and attitude of the top.
fixed = kt.flexible.corrected(model, standing, at=("B8.N4", "B8.N5.y", "B8.N5.z", "B8.N6.z"))
for drive, change in zip(fixed.drive.values, fixed.change.values[0], strict=True):
    print(f"{drive}: {1e3 * change:+.3f} mm")
away = np.abs(fixed.displacement.isel(time=0).sel(node=top)).max().item()
print(f"the top is back to {1e6 * away:.1f} micrometres: what its own battens give way")

# %% What the members bear before and after.
before, after = standing.member_force.isel(time=0), fixed.member_force.isel(time=0)
most = str(before.member.values[np.abs(before.values).argmax()])
print(f"{most}: {before.sel(member=most).item():.0f} N before, {after.sel(member=most).item():.0f} N after;", end=" ")
print(f"no force changes by more than {np.abs(after - before).max().item():.0f} N")

# %% The actuators do it in 10 s, against the wind.
run = kt.run(model, "straighten")
motion, forces = run.motion, run.forces["wind"]
for word, state in (("before", standing), ("under way", forces)):
    worst = kt.strength.check(model, state).table()[0]
    print(f"{word}: {worst.part} governs, {100 * worst.utilisation:.1f} % of {worst.rule}")
    assert worst.utilisation < 1
power = (forces.drive_force * motion.drive_velocity).sum("drive")
work = np.trapezoid(power.values, motion.time.values)
moved = motion.position.isel(time=-1) - motion.position.isel(time=0)
wind = -sum(np.array(load.force) @ moved.sel(node=load.node).values for load in model.loads.values())
demand = kt.actuators.evaluate(model, motion, forces)
print(f"they push with up to {forces.drive_force.max().item() / 1e3:.1f} kN and do {work:.1f} J,", end=" ")
print(f"{wind:.1f} J of it against the wind")
print(f"motors draw {demand.drawn_energy.sum().item():.0f} J, up to {np.abs(demand.current).max().item():.1f} A;", end=" ")
print(f"screws lock: {bool(demand.self_locking.all())}")
assert np.abs(fixed.error).max() < 1e-12
assert away < 1e-3 * np.abs(lean).max()
assert np.abs(after - before).max() < 1e-3 * np.abs(before).max()  # determinate: forces follow from equilibrium
assert not kt.actuators.exceeded(demand)
assert demand.self_locking.all()  # it stays straight without current
