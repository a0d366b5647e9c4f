"""A double-octahedral bay as active vibration isolator, standing and hanging: soft legs with feedback on absolute rates."""

import math

import numpy as np

import kinetruss as kt

BASE, TOP, LEGS = ("N1", "N2", "N3"), ("N7", "N8", "N9"), ("M7", "M9", "M11")


def isolator(gravity: float) -> kt.Model:
    """The active members replaced by springs with dampers, prestressed so that they carry the payload of 60 kg."""
    bay = kt.library.vgt.double_octahedral(payload_mass=20.0, gravity=(0, 0, gravity))
    pull = kt.statics.at_poses(bay, [{}]).member_force.isel(time=0)
    soft = {"kind": "elastic", "stiffness": 2e4, "damping": 40.0, "mass": 4.0}
    legs = {name: kt.Bar(ends=bay.active[name].ends, pretension=pull.sel(member=name).item(), **soft) for name in LEGS}
    return bay.with_(active={}, poses={}, bars=bay.bars | legs)


found = {}
for word, gravity in (("standing", -9.81), ("hanging", 9.81)):
    model = isolator(gravity)
    rest = kt.statics.equilibrium(model)
    lin = kt.dynamics.linearise(
        model, rest, dofs=[f"{node}.z" for node in TOP],
        inputs={"shake": {f"{node}.z": 1.0 for node in BASE}} | dict(zip(LEGS, LEGS, strict=True)),
        outputs={"top": {f"{node}.z": 1 / 3 for node in TOP}},
    )  # fmt: skip
    # forces of the legs against the absolute rates of the payload, at the least cost of 4e5 v^2 + f^2
    loop = kt.dynamics.feedback(lin, inputs=LEGS, state_cost={f"{node}.z'": 4e5 for node in TOP})
    sampled = kt.dynamics.feedback(lin, inputs=LEGS, gains=loop.gains.values, period=2e-3)
    tilt, _, bounce = lin.frequency.values
    print(f"{word}: tilts at {tilt:.4f} Hz, bounces at {bounce:.4f} Hz, damping ratio {lin.modal_damping.values[-1]:.4f}")
    print(f"  with feedback damping ratios {sorted(set(loop.pole_damping.values.round(4).tolist()))}")
    frequencies = np.array([bounce, 30.0])
    shares = [one.transmissibility(2 * np.pi * frequencies, "top", "shake").values.ravel() for one in (lin, loop, sampled)]
    for frequency, passive, active, stepped in zip(frequencies, *shares, strict=True):
        print(
            f"  shaken at {frequency:.4f} Hz: {passive:.4f} of it arrive, with feedback {active:.4f}, at 500 Hz {stepped:.4f}"
        )
    found[word] = tilt, bounce, shares

# hanging, the base shaken at 5 Hz by 1 mm, in time: once the start has died away, as the linear response says
t = np.linspace(0, 4.0, 801)
s = np.clip(t, 0, 1)
w = 2 * math.pi * 5.0
moves = np.stack([0 * t, 0 * t, 1e-3 * s**3 * (10 - 15 * s + 6 * s**2) * np.sin(w * t)], axis=1)
shaken = model.with_(support_motion={node: kt.History(times=t, displacements=moves) for node in BASE})
late = np.linspace(3.0, 4.0, 101)
run = kt.dynamics.simulate(shaken, times=late, positions=rest.position.values, user_force=loop.user_force())
height = run.motion.position.sel(node=list(TOP), axis="z").mean("node").values
waves = np.stack([np.cos(w * late), np.sin(w * late), np.ones_like(late)], axis=1)
amplitude = np.hypot(*np.linalg.lstsq(waves, height, rcond=None)[0][:2]) / 1e-3
linear = loop.transmissibility(w, "top", "shake").item()
print(f"simulated: {amplitude:.5f} of the shake arrive, linear response {linear:.5f}")

for word, (tilt, bounce, (passive, active, _)) in found.items():
    assert passive[0] > 10 and active[0] < 1.1, word  # the resonance is gone
    assert active[1] < passive[1] < 0.04, word  # and nothing is lost above it
    assert abs(bounce - {"standing": 6.96199, "hanging": 7.09041}[word]) < 1e-4
    assert abs(tilt - {"standing": 2.25337, "hanging": 2.37875}[word]) < 1e-4  # weight that stands softens, hanging stiffens
assert abs(amplitude / linear - 1) < 1e-3
