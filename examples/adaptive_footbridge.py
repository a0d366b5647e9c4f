"""A footbridge under all combinations of EN 1990: strength, deflection, and the stroke that keeps it level under a crowd."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["adaptive_footbridge"][0])
run = kt.run(model, "stand")
low = min(run.quantities[case].value.item() for case in run.quantities if case.startswith("sls"))
print(f"largest deflection of serviceability: {-1e3 * low:.1f} mm")
print(run.finding.sentence)
assert run.finding.state == "ok"

# three hinges: the crowd puts q l^2/8 over the depth of 1.5 m into the actuator
pull = {case: run.forces[f"sls.{case}"].member_force.sel(member="actuator").item() for case in ("G", "crowd.G+crowd")}
print(f"force of the actuator by the crowd: {(pull['crowd.G+crowd'] - pull['G']) / 1e3:.1f} kN")
assert np.isclose(pull["crowd.G+crowd"] - pull["G"], 6250 * 24**2 / 8 / 1.5, rtol=1e-9)

# the halves turn about their bearings: 12 m across and 1.5 m down, twice
motion = kt.kinematics.follow(model, kt.Quintic(moves={"actuator": (4.0, 4.0)}, duration=10.0), samples=2)
stroke = {
    case: kt.flexible.corrected(model, kt.dynamics.inverse(model, motion, load_case=f"sls.{case}"), at="D3.y").change.values[
        0, 0
    ]
    for case in pull
}
print(f"stroke that keeps the bridge level as the crowd comes: {1e3 * (stroke['G'] - stroke['crowd.G+crowd']):.2f} mm")
for case, change in stroke.items():
    assert np.isclose(change, run.quantities[f"sls.{case}"].value.item() * 2 * 1.5 / 12, rtol=0.01)
