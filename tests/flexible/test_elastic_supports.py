"""Flexible structures on supports that yield: closed forms of beams and bars on springs."""

import numpy as np
import pytest
from scipy.optimize import brentq

import kinetruss as kt

E, DENSITY = 210e9, 7850.0
SPAN, WIDTH, HEIGHT = 4.0, 0.05, 0.04
EI, PER_LENGTH = E * WIDTH * HEIGHT**3 / 12, DENSITY * WIDTH * HEIGHT
SOFT = 40e3
"""Stiffness of the supports, N/m: less than that of the beam, 48 EI/L^3 = 42 kN/m at its middle."""


def beam(parts=16, **more):
    """A beam on a spring at each end."""
    ends = {"N0": kt.Support(x="held", y=SOFT), f"N{parts}": kt.Support(y=SOFT)}
    return kt.Model(
        nodes={f"N{i}": (SPAN * i / parts, 0) for i in range(parts + 1)},
        beams={f"b{i}": kt.Beam(ends=(f"N{i}", f"N{i + 1}"), kind="elastic") for i in range(parts)},
        section=kt.Rectangle(width=WIDTH, height=HEIGHT),
        material="steel_s235",
        supports=ends,
        **more,
    )


def test_a_beam_on_springs_has_its_frequency_and_its_deflection():
    """EI b^3 (tanh z + tan z) = 2 k with z = b L/2, from the shear at the ends of a symmetric mode; and half the weight over k
    beside 5 q L^4/(384 EI). Rotary inertia and shear lower the frequency by about 1e-5.
    """

    def off(z):
        return EI * (z / (SPAN / 2)) ** 3 * (np.tanh(z) + np.tan(z)) - 2 * SOFT

    z = brentq(off, 1e-3, np.pi / 2 - 1e-9)
    exact = (z / (SPAN / 2)) ** 2 * np.sqrt(EI / PER_LENGTH) / (2 * np.pi)
    still = beam()
    found = kt.flexible.frequencies(still, kt.statics.at_poses(still, [{}]), 1)
    assert found.frequency.item() == pytest.approx(exact, rel=5e-5)
    assert kt.dynamics.linearise(still).frequency[0].item() == pytest.approx(found.frequency.item(), rel=1e-9)
    heavy = beam(gravity=(0, -9.81))
    weight = PER_LENGTH * 9.81
    sunk = -(weight * SPAN / 2 / SOFT + 5 * weight * SPAN**4 / (384 * EI))
    assert kt.statics.linear(heavy).displacement.sel(node="N8", axis="y").item() == pytest.approx(sunk, rel=1e-9)
    rest = kt.statics.equilibrium(heavy)
    settled = kt.flexible.frequencies(heavy, kt.statics.at_poses(heavy, rest), 1)
    assert settled.frequency.item() == pytest.approx(exact, rel=1e-3)


def truss(**more):
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0.5, 1)},
        fixed={"A": "xy", "B": "y"},
        bars={"ab": ("A", "B"), "ac": kt.Bar(ends=("A", "C"), kind="driven"), "bc": ("B", "C")},
        section=kt.Rod(diameter=0.02),
        material="steel_s235",
        loads={"P": kt.NodalForce(node="C", force=(0, -1e3))},
        **more,
    )


def test_a_support_that_yields_is_the_spring_that_it_is():
    """In every flexible analysis; and the small displacements of the deflection are those of linear statics."""
    ground = truss(supports={"C": kt.Support(y="50 MN/m")})
    spring = kt.Spring(coordinate=kt.CoordinateDrive(node="C", axis="y"), stiffness="50 MN/m")
    same, without = truss(springs={"s": spring}), truss()
    found = []
    for model in (ground, same, without):
        forces = kt.runs.forces_at_rest(model)
        at = kt.flexible.corrected(model, forces, at="C.x")
        sunk = kt.statics.deflection(model, forces).displacement
        np.testing.assert_allclose(sunk[0], kt.statics.linear(model).displacement, rtol=1e-9, atol=1e-15)
        found.append([at.change.item(), *sunk.values.flat, *kt.flexible.frequencies(model, forces, 3).frequency.values.flat])
    np.testing.assert_allclose(found[0], found[1], rtol=1e-12)
    assert not np.allclose(found[0], found[2], rtol=0.1)


def foot(**more):
    """An actuator on a spring, with a load on top."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 1)},
        fixed={"B": "x"},
        supports={"A": kt.Support(x="held", y="1 MN/m")},
        bars={"act": kt.Bar(ends=("A", "B"), kind="driven", section=kt.Rod(diameter=0.02), material="steel_s235")},
        loads={"P": kt.NodalForce(node="B", force=(0, -1e3))},
        **more,
    )


def test_an_actuator_makes_up_for_the_ground_that_yields():
    """By P/k of the ground and P L/(E A) of itself."""
    model = foot()
    forces = kt.statics.at_poses(model, [{}])
    assert "springs in these positions leave up to 5e+02 N" in forces.message
    found = kt.flexible.corrected(model, forces, at="B.y")
    own = 1e3 / (E * np.pi * 1e-4)
    assert found.change.item() == pytest.approx(1e3 / 1e6 + own, rel=1e-4)
    # of the equilibrium, on the ground as it has yielded, only what it yields itself
    rest = kt.statics.at_poses(model, kt.statics.equilibrium(model))
    assert rest.message == ""
    assert rest.reaction.sel(support="A", axis="y").item() == pytest.approx(1e3)
    assert kt.flexible.corrected(model, rest, at="B.y").change.item() == pytest.approx(own, rel=1e-4)


def test_what_drives_do_not_hold_is_named_with_the_supports_that_yield():
    model = foot()
    for work in (
        lambda: kt.kinematics.follow(model, kt.ConstantRate(rates={"act": 0.1}, duration=1.0)),
        lambda: kt.runs.forces_at_rest(model),
    ):
        with pytest.raises(kt.InputError, match=r"they yield or have a gap: supports A \(y\)\. .*Hold them for it"):
            work()
    # a foundation as a bar with a stiffness stands in a motion, and yields in flexible analyses
    ground = {"G": (0, -0.5), "A": (0, 0), "B": (0, 1)}
    bars = {"bed": kt.Bar(ends=("G", "A")), **model.bars}
    stood = kt.Model(
        nodes=ground,
        fixed={"G": "xy", "A": "x", "B": "x"},
        bars=bars,
        loads=model.loads,
        section=kt.Rod(diameter=0.02),
        material="steel_s235",
    )
    motion = kt.kinematics.follow(stood, kt.ConstantRate(rates={"act": 0.0}, duration=1.0), samples=2)
    forces = kt.dynamics.inverse(stood.with_(gravity=None), motion)
    assert forces.drive_force[0].item() == pytest.approx(1e3)
    found = kt.flexible.corrected(stood, forces, at="B.y", stiffness={"bed": 1e6})
    assert found.change[0].item() == pytest.approx(1e3 / 1e6 + 1e3 / (E * np.pi * 1e-4), rel=1e-4)


def test_poses_in_which_a_load_moves_a_mechanism_are_refused():
    """A pendulum held out: nothing turns it back. Where it hangs it is in balance."""
    arm = {"nodes": {"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1)}, "fixed": ["O"], "bars": {"r": ("O", "A")}}
    out = kt.Model(**arm, gravity=(0, -9.81))
    with pytest.raises(kt.InputError, match=r"leave 1 freedom .* 9\.81 N act along it, which nothing holds"):
        kt.statics.at_poses(out, [{}])
    hung = out.with_(gravity=(9.81, 0))
    assert kt.statics.at_poses(hung, [{}]).reaction.sel(axis="x").item() == pytest.approx(-9.81)
