"""A drop test of a landing gear: load factor, stroke and stops; and the forces after it has come to rest, by hand."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["landing_gear"][0])
run = kt.run(model)
found = run.quantities["all"].value
for name, unit in (("load_factor", ""), ("stroke", " m"), ("tyre", " m")):
    values = found.sel(quantity=name)
    print(f"largest {name}: {values.max().item():.3f}{unit} at {run.motion.time.values[values.values.argmax()]:.3f} s")
print(run.finding.sentence)
assert run.finding.state == "ok"

# at rest the ground carries all that the wings do not; moments about the pin of the arm give the strut
rest = kt.dynamics.simulate(model, 10.0, samples=2)
at = {name: rest.motion.position.sel(node=name).values[-1] for name in model.nodes}
arm = 7850 * 0.05 * 0.08 * np.hypot(0.5, 0.35)
ground = 9.81 * (400 + 12 + 6 + arm) - 2616
assert np.isclose(ground, 150e3 * (0.2 - at["W"][1]), rtol=1e-4)
along = (at["K"] - at["S"]) / np.linalg.norm(at["K"] - at["S"])
foot = at["K"] - at["Q"]
lever = foot[0] * along[1] - foot[1] * along[0]
moment = ground * at["W"][0] - 9.81 * (12 * at["W"][0] + arm * at["W"][0] / 2 + 3 * at["K"][0])
push = -moment / lever
print(f"at rest: ground {ground:.0f} N, strut {push:.0f} N")
assert np.isclose(rest.forces.member_force.sel(member="strut").values[-1], -push, rtol=1e-4)
