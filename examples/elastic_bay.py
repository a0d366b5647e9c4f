"""How elastic a bay is: printed strains pose by pose, a brace too many, the tip in motion, and what moves the tip."""

import math

import numpy as np

import kinetruss as kt

TILT = math.radians(9)
model = kt.library.vgt.double_octahedral(longeron=35.5 * 0.0254, beta=-TILT, gravity=(0, 0, 9.81), tip_force=(0, 0, 45))

# %% Strains of M6 in three poses, without any motion. They were measured from the unloaded truss, so weight is left out.
poses = {
    "level": {"M7": 1.1684, "M9": 1.1684, "M11": 1.1684},
    "M7 long": {"M7": 1.2289, "M9": 1.1077, "M11": 1.1077},
    "M7 short": {"M7": 1.1077, "M9": 1.2289, "M11": 1.2289},
}
forces = kt.statics.at_poses(model, poses, weight=False)
strain = kt.statics.deflection(model, forces).strain.sel(member="M6") * 1e6
printed = [5.8631, 5.2094, 6.8197]  # Lacy (1991), table 5.5
for name, value, other in zip(poses, strain.values, printed, strict=True):
    print(f"{name:8s} strain of M6 {value:.4f} microstrain, printed {other}")
np.testing.assert_allclose(strain, printed, rtol=2e-4)

# %% The stiffness method finds the same forces, and those of a bay with one brace too many.
upright = kt.library.vgt.double_octahedral(longeron=35.5 * 0.0254, gravity=(0, 0, 9.81), tip_force=(0, 0, 45))
braced = upright.with_(bars=dict(upright.bars) | {"brace": kt.Bar(ends=("N1", "N9"), section="bar", material="bar")})
energy = []
for one in (upright, braced):
    linear, dynamic = kt.statics.linear(one), kt.statics.at_poses(one, [{}])
    assert abs(linear.member_force - dynamic.member_force.isel(time=0)).max() < 1e-10 * abs(linear.member_force).max()
    energy.append(linear.energy.item())
print(f"a brace from N1 to N9 takes {linear.member_force.sel(member='brace').item():.3f} N")
assert energy[1] < energy[0]  # one bar more makes the truss stiffer

# %% The tip gives way by hundredths of a millimetre; moving fast costs a little more than standing there.
motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-TILT, TILT), duration=1.0), samples=101)
moving = kt.dynamics.inverse(model, motion)
tip, still = (kt.statics.deflection(model, one) for one in (moving, moving.static))
size = 1e6 * tip.size.sel(node="N8")
print(f"the tip gives way by {size.min().item():.2f} to {size.max().item():.2f} micrometres,", end=" ")
print(f"strain energy up to {tip.energy.max().item():.3e} J")
assert abs(tip.work_balance).max() < 1e-12 * tip.energy.max()
assert 0 < abs(tip.size - still.size).max() < 0.2 * still.size.max()

# %% How the top turns, and what each actuator does to it.
top = kt.kinematics.platform(model, motion, ("N7", "N9", "N8"), base=("N1", "N2", "N3"))
print(f"the top turns at up to {abs(top.angular_velocity).max().item():.4f} rad/s about x")
assert abs(top.angular_velocity.sel(rotation="x").max() - 2 * TILT * 1.875) < 1e-12  # the quintic's largest rate
J = kt.kinematics.jacobian(model, of=["bay.beta", "bay.gamma", "bay.height"])
print("angles and height by lengths, at the start:")
for name, row in zip(J.of.values, J.values, strict=True):
    print(f"  {name:10s}", "".join(f"{value:9.4f}" for value in row))
prediction = kt.kinematics.first_order(model, motion)
print(f"predicted to first order from the start, nodes are up to {1e3 * prediction.largest_error.max().item():.1f} mm off")
halfway = kt.kinematics.first_order(model, kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-TILT, 0.0)), samples=3))
assert 3 < prediction.largest_error[-1] / halfway.largest_error[-1] < 5  # twice the step, about four times the error
