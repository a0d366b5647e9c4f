"""A folding solar array: when it is open, the blow on its stop; and without dampers the blow by hand, from the energy."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["folding_array"][0])
run = kt.run(model)
found, time = run.quantities["all"].value, run.motion.time.values
angle, blow = (found.sel(quantity=name).values for name in ("root_angle", "blow"))
first = next(iter(run.simulation.events))
print(f"the panels meet the stop at {first.time:.2f} s; the blow is {blow.max():.1f} N m")
print(f"within 0.1 degrees of open from {time[np.abs(angle) > np.radians(0.1)].max():.1f} s on")
print(run.finding.sentence)
assert run.finding.state == "ok"

# without dampers the springs' energy goes into the stop: (K + k) f^2/2 - M f = E, where the springs have
# k = 4.5 N m/rad and M = 1 N m on panel 1
free = model.with_(springs={name: one.with_(damping=0.0) for name, one in model.springs.items()})
start = np.radians(88)
energy = sum(0.25 * (n * start) ** 2 + 0.2 * n * start for n in (1, 2, 2))
push = np.max(np.roots([0.5 * 2004.5, -1.0, -energy]))
hit = kt.dynamics.simulate(free, 4.2, samples=4201)
deepest = -kt.kinematics.quantities(free, hit).value.sel(quantity="root_angle").min().item()
print(f"without dampers: {2000 * deepest:.1f} N m, by hand {2000 * push:.1f} N m")
assert np.isclose(deepest, push, rtol=1e-4)
