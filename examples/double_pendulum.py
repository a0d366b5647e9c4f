"""A double pendulum let go from level: when its tip passes the hinge, what its bars carry, how well energy is kept."""

import kinetruss as kt

model = kt.Model(
    nodes={"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=0.5), "B": kt.Node(at=(0.8, 0), mass=0.5)},
    fixed=("O",),
    bars={"upper": ("O", "A"), "lower": ("A", "B")},
    section=kt.Rectangle(width=0.020, height=0.005),
    material=kt.library.materials.STEEL_S235,
    gravity=(0, -9.81),
)
fall = kt.dynamics.simulate(model, 5.0, samples=501, events={"under": kt.Event(coordinate="B.x", value=0, stop=False)})
print(fall.status.value)
for event in fall.events[:3]:
    print(event)

tension = fall.forces.member_force.sel(member="upper")
print(f"upper bar: at most {tension.max().item():.2f} N, {tension.max().item() / (9.81 * 2.57):.1f} times the weight of it all")
worst = kt.strength.check(model, fall.forces).table()[0]
print(worst.part, worst.rule, f"{worst.utilisation:.4f}")

drift = abs(fall.energy - fall.energy[0]).max() / fall.kinetic_energy.max()
print(f"energy is kept to {drift.item():.1e} of the largest kinetic energy")
assert drift < 1e-8

again = kt.dynamics.simulate(model, 5.0, samples=501, method=kt.EnergyMomentum(1e-3))
print(f"with fixed steps of 1 ms to {(abs(again.energy - again.energy[0]).max() / again.kinetic_energy.max()).item():.1e}")
