"""A toggle press: force of the ram along its stroke, and 3 degrees before the dead point by hand."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["press"][0])
run = kt.run(model)
found = run.quantities["all"].value
for at in (0, 43, 86, 129):
    knee, press = (found.sel(quantity=name).values[at] for name in ("knee", "press"))
    print(f"{np.degrees(knee):4.1f} deg before the dead point: {press:4.1f} kN")
print(f"torque for the workpiece: {run.forces['all'].drive_force.sel(drive='motor').values[-1]:.0f} N m")
print(run.finding.sentence)
assert run.finding.state == "ok"

# of the arms l at the angle a: R = 2 l (1 - cos a); pin and knee have one speed along the link: r c = l a' k
K, C, O = (run.motion.position.sel(node=name).values[-1] for name in "KCO")
a = found.sel(quantity="knee").values[-1]
along = (C - K) / np.linalg.norm(C - K)
crank = np.array([-(C - O)[1], (C - O)[0]]) @ along  # m, speed of the pin along the link for 1 rad/s
knee = 0.3 * np.array([np.cos(a), np.sin(a)]) @ along
press = 200 / abs(2 * 0.3 * np.sin(a) * crank / knee)
assert np.isclose(np.degrees(a), 3, atol=1e-3)
assert np.isclose(found.sel(quantity="press").values[-1], press / 1e3, rtol=1e-10)
# near the dead point about M/(2 r a), as the crank stands across the link
assert np.isclose(press, 200 / (2 * 0.06 * a), rtol=0.01)
