"""An arm balanced by springs: what its motors need with and without them, and the torque at rest by virtual work."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["balanced_arm"][0])
bars = {name: bar for name, bar in model.bars.items() if bar.kind != "elastic"}
bare = model.with_(bars=bars, quantities={})
for word, each in (("with springs", model), ("without", bare)):
    run = kt.run(each)
    peak = max(np.abs(forces.drive_force).max().item() for forces in run.forces.values())
    print(f"{word}: up to {peak:.1f} N m. {run.finding.sentence}")
    assert run.finding.state == ("ok" if each is model else "over")

# at rest the torque of a drive is the change of the potential of weights and springs by its angle
run = kt.run(model)
rest = run.forces["loaded"].static.drive_force
potential = 9.81 * 8 * run.motion.position.sel(node="T", axis="y").values
density = kt.library.materials.ALUMINIUM_6061_T6.density
for bar in model.bars.values():
    ends = run.motion.position.sel(node=list(bar.ends)).values
    long = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    if bar.kind == "elastic":
        potential += bar.stiffness * (long - bar.natural_length) ** 2 / 2
    mass = density * model.section_of(bar).area * long if bar.mass is None else bar.mass
    potential += 9.81 * mass * ends[:, :, 1].mean(axis=1)
angle = run.motion.drive_position.values
work = ((rest.values[1:] + rest.values[:-1]) / 2 * np.diff(angle, axis=0)).sum(axis=1)
print(f"work of the drives at rest pose by pose, against the potential: {np.abs(work - np.diff(potential)).max():.3f} J apart")
assert np.abs(work - np.diff(potential)).max() < 0.02 * np.abs(np.diff(potential)).max()
