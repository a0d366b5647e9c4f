"""The active isolator with a flexible beam on it: frequencies, how much of a shake reaches the beam, damping by the legs."""

import numpy as np

import kinetruss as kt

BASE, TOP, LEGS = ("N1", "N2", "N3"), ("N7", "N8", "N9"), ("M7", "M9", "M11")
model = kt.read(kt.library.example_files()["isolator_beam"][0])
truss = {name: node for name, node in model.nodes.items() if name.startswith("N")}
bare = model.with_(nodes=truss, beams={}, bodies={}, clamped={})


def linearised(one: kt.Model) -> kt.dynamics.Linearisation:
    """Small motions about the equilibrium: base shaken vertically, forces of the legs; plate and tip of the beam."""
    tip = {"tip": "left2.z"} if "left2" in one.nodes else {}
    return kt.dynamics.linearise(
        one, kt.statics.equilibrium(one),
        inputs={"shake": {f"{node}.z": 1.0 for node in BASE}} | dict(zip(LEGS, LEGS, strict=True)),
        outputs={"plate": {f"{node}.z": 1 / 3 for node in TOP}} | tip,
    )  # fmt: skip


def damping(one: kt.dynamics.Linearisation | kt.dynamics.Feedback, low: float, high: float) -> float:
    """Largest damping ratio of the poles between two frequencies, Hz."""
    poles = np.asarray(one.poles)
    near = poles[(poles.imag > 0) & (np.abs(poles) > 2 * np.pi * low) & (np.abs(poles) < 2 * np.pi * high)]
    return float((-near.real / np.abs(near)).max())


alone, whole = linearised(bare), linearised(model)
print("without beam:", ", ".join(f"{f:.3f}" for f in alone.frequency.values), "Hz")
print("with beam:   ", ", ".join(f"{f:.3f}" for f in whole.frequency.values[:5]), "Hz, ..")

# %% Feedback designed without the beam: forces of the legs against the absolute rates of the plate.
designed = kt.dynamics.feedback(alone, inputs=LEGS, state_cost={f"{node}.z'": 4e5 for node in TOP})
states = [str(name) for name in designed.gains.state.values]


def closed(share: float) -> kt.dynamics.Feedback:
    """The feedback on the isolator with its beam, with a share of the gains."""
    table = {leg: dict(zip(states, share * row, strict=True)) for leg, row in zip(LEGS, designed.gains.values, strict=True)}
    return kt.dynamics.feedback(whole, inputs=LEGS, gains=table)


found = {}
for share in (0.0, 0.5, 1.0, 2.0, 4.0):
    found[share] = damping(closed(share), 11, 12.5)
    print(f"{share:.1f} of the gains: damping ratio of the beam's first mode {found[share]:.4f}")

# %% A base that shakes from 1 to 20 Hz.
w = 2 * np.pi * np.linspace(1, 20, 3801)
loop = closed(1.0)
for part in ("plate", "tip"):
    largest = [float(one.transmissibility(w, part, "shake").max()) for one in (whole, loop)]
    print(f"{part}: up to {largest[0]:.2f} of the shake arrives, with feedback {largest[1]:.2f}")
    assert largest[1] < 0.25 * largest[0]
assert found[1.0] > 5 * found[0.0]
assert found[4.0] < found[1.0]  # too much feedback clamps the plate in space, and the beam vibrates on it undamped
