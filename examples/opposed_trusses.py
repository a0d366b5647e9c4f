"""Two trusses hold a beam between them: with all drives the loop is overdetermined, with one drive less it moves freely."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["opposed_trusses"][0])
every = model.with_(bars={**model.bars, "R.B3.M7": model.bars["R.B3.M7"].with_(kind="driven")})
for word, each in (("all drives", every), ("R.B3.M7 free", model)):
    found = kt.kinematics.mobility(each)
    print(
        f"{word}: {len(each.driven_members)} drives, freedoms that none holds {found.undriven}, self-stress {found.self_stress}"
    )
    assert (found.undriven, found.self_stress) == (0, int(word == "all drives"))

run = model.runs["lift"]
motion = kt.kinematics.follow(model, run.trajectory, samples=run.samples)
ends = motion.position.sel(node=["L.B3.N8", "R.B3.N8"]).values
rise, follows = ends[-1, :, 2] - ends[0, :, 2], motion.length.sel(member="R.B3.M7").values
print(f"the ends of the beam rise by {rise[0]:.4f} and {rise[1]:.4f} m")
print(f"R.B3.M7 follows: {follows[0]:.4f} m, at most {follows.max():.4f} m, {follows[-1]:.4f} m at the end")

forces = kt.dynamics.inverse(model, motion)
worst = kt.strength.check(model, forces).table()[0]
demand = kt.actuators.evaluate(model, motion, forces)
print(f"{worst.part} governs: {100 * worst.utilisation:.1f} % of {worst.rule}")
assert abs(np.diff(rise)).item() < 1e-3  # the beam stays level at the end
assert abs(forces.member_force.sel(member="R.B3.M7")).max() < 1e-9
assert worst.utilisation < 1
assert not kt.actuators.exceeded(demand)
