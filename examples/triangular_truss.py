"""The triangular truss of Lacy (1991): the actuator pushes a 10 kg load out in 3 s; what the members carry."""

import kinetruss as kt

model = kt.library.vgt.triangular()
motion = kt.kinematics.follow(model, kt.library.vgt.lacy_step(), samples=3001)
forces = kt.dynamics.inverse(model, motion)

speed = motion.drive_velocity.sel(drive="actuator").max().item()
follower = forces.end_force.sel(member="follower", end="A")
worst = follower.argmin("time").item()
print(f"fastest extension          {speed:.4f} m/s")
print(f"compression of the follower {-follower[worst].item():.2f} N at {motion.time[worst].item():.3f} s")
print(f"of it from the motion       {-forces.difference().end_force.sel(member='follower', end='A')[worst].item():.2f} N")

# exact physics, on a 1 ms grid: 304.6716 N at 1.735 s
assert abs(follower[worst].item() + 304.6716) < 1e-3
assert abs(motion.time[worst].item() - 1.735) < 1e-9
