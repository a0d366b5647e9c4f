"""Elastic deflection along a motion: closed forms, virtual work, Castigliano, agreement with the stiffness method."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.mechanics import compile

NODES = ["N4", "N5", "N8"]


@pytest.fixture(scope="module")
def slewed():
    model = kt.library.vgt.double_octahedral(2, tip_force=(5, 0, 46), payload_mass=2.0)
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(2, beta=(-0.15, 0.15), gamma=(0, 0.1)), samples=9)
    return model, kt.dynamics.inverse(model, motion)


def test_virtual_work_closes_along_a_fast_motion(slewed):
    model, forces = slewed
    found = kt.statics.deflection(model, forces)
    assert np.abs(found.work_balance).max() < 1e-12 * found.energy.max()
    at_rest = kt.statics.deflection(model, forces.static)
    assert np.abs(at_rest.work_balance).max() < 1e-12 * at_rest.energy.max()
    assert np.abs(found.displacement - at_rest.displacement).max() > 1e-3 * np.abs(at_rest.displacement).max()


def test_at_rest_it_is_the_stiffness_method(slewed):
    model, forces = slewed
    found = kt.statics.deflection(model, forces.static)
    for i in (0, 4, 8):
        linear = kt.statics.linear(model, forces.motion.position.values[i])
        size = np.abs(linear.displacement.values).max()
        np.testing.assert_allclose(found.displacement.values[i], linear.displacement.values, atol=1e-11 * size)
        np.testing.assert_allclose(found.strain_energy.values[i], linear.strain_energy.values, rtol=1e-9, atol=1e-18)


def test_elongations_are_those_of_the_displaced_ends(slewed):
    model, forces = slewed
    found = kt.statics.deflection(model, forces)
    system = compile(model)
    u = kt.kinematics.member_rates(model, forces.motion).direction.values
    apart = found.displacement.values[:, system.q] - found.displacement.values[:, system.p]
    np.testing.assert_allclose(found.elongation.values, np.einsum("tmc,tmc->tm", u, apart), atol=1e-18)
    flexible = system.compliance * forces.motion.length.values
    np.testing.assert_allclose(found.elongation.values, forces.member_force.values * flexible, atol=1e-19)


def test_energy_of_a_bent_beam_is_the_work_of_its_load():
    """F^2 l^3/(6 E I) of a cantilever under F at its end."""
    model = kt.Model(
        nodes={"O": (0, 0), "B": (1.5, 0)}, fixed=["O"], clamped=["O"], beams={"e": kt.Beam(ends=("O", "B"), mass=0.0)},
        section=kt.Rod(diameter=0.02), material="steel_s235", loads={"tip": kt.NodalForce(node="B", force=(0, -20.0))},
    )  # fmt: skip
    found = kt.statics.deflection(model, kt.statics.at_poses(model, [{}]))
    energy = 20.0**2 * 1.5**3 / (6 * 210e9 * np.pi * 0.02**4 / 64)
    assert found.energy.item() == pytest.approx(energy, rel=1e-12)
    assert found.work.item() == pytest.approx(energy, rel=1e-12)


def test_castigliano_in_motion(slewed):
    """Displacement of a node along an added force is the slope of the strain energy by it, inertia forces held."""
    model, forces = slewed
    found = kt.statics.deflection(model, forces)
    h = 1.0
    for axis, k in (("x", 0), ("z", 2)):
        energies = []
        for sign in (1, -1):
            extra = kt.NodalForce(node="B1.N5", force=tuple(sign * h * np.eye(3)[k]))
            other = model.with_(loads=dict(model.loads) | {"extra": extra})
            energies.append(kt.statics.deflection(other, kt.dynamics.inverse(other, forces.motion)).energy.values)
        slope = (energies[0] - energies[1]) / (2 * h)
        expected = found.displacement.sel(node="B1.N5", axis=axis).values
        np.testing.assert_allclose(slope, expected, atol=1e-9 * np.abs(expected).max())


def test_a_bar_that_is_shaken_in_closed_form():
    """A mass on a driven strut that accelerates: e = -m (x'' + g) l/(E A) with the strut's own share m_s/2."""
    E, A = 70e9, 1e-4
    part = {"section": kt.General(area=A, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), "material": kt.Material(E=E, density=2700.0)}
    model = kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(0, 1), mass=5.0)}, fixed={"A": "xy", "B": "x"}, gravity=(0, -9.81),
                     bars={"s": kt.Bar(ends=("A", "B"), kind="driven", mass=0.4, **part)})  # fmt: skip
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"s": (1.0, 1.3)}, duration=0.3), samples=13)
    found = kt.statics.deflection(model, kt.dynamics.inverse(model, motion))
    a, length = motion.length_acceleration.values[:, 0], motion.length.values[:, 0]
    mean = -(5.0 * (a + 9.81) + 0.4 * (a / 3 + 9.81 / 2))
    np.testing.assert_allclose(found.elongation.values[:, 0], mean * length / (E * A), rtol=1e-12)
    np.testing.assert_allclose(found.displacement.sel(node="B", axis="y"), mean * length / (E * A), rtol=1e-12)
    np.testing.assert_allclose(found.energy, 0.5 * mean**2 * length / (E * A), rtol=1e-12)


def redundant():
    bay = kt.library.vgt.double_octahedral(tip_force=(5, 3, 46))
    return bay.with_(bars=dict(bay.bars) | {"X": kt.Bar(ends=("N1", "N9"), section="bar", material="bar")})


def test_redundant_structures():
    model = redundant()
    forces = kt.statics.at_poses(model, [{}])
    found = kt.statics.deflection(model, forces)
    np.testing.assert_allclose(found.displacement.values[0], kt.statics.linear(model).displacement.values, atol=1e-17)
    assert np.abs(found.work_balance).max() < 1e-12 * found.energy.max()
    bare = kt.Model(nodes={"L": (-1, 1), "M": (0, 1), "R": (1, 1), "P": (0, 0)}, fixed=["L", "M", "R"],
                    bars={"l": ("L", "P"), "m": ("M", "P"), "r": ("R", "P")})  # fmt: skip
    with pytest.raises(InputError, match="inextensible bars are not unique"):
        kt.statics.deflection(bare, kt.statics.at_poses(bare, [{}]))


def test_elastic_bars_beside_driven_ones():
    """A spring of the model shares what the mast takes: both give way together."""
    E, A = 70e9, 1e-4
    part = {"section": kt.General(area=A, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), "material": kt.Material(E=E, density=0.0)}
    model = kt.Model(nodes={"A": (0, 0), "B": (0, 1), "C": (0, 2)}, fixed={"A": "xy", "B": "x", "C": "xy"},
                     bars={"mast": kt.Bar(ends=("A", "B"), **part), "spring": kt.Bar(ends=("B", "C"), kind="elastic", **part)},
                     loads={"l": kt.NodalForce(node="B", force=(0.0, -700.0))})  # fmt: skip
    found = kt.statics.deflection(model, kt.statics.at_poses(model, [{}]))
    np.testing.assert_allclose(found.displacement.sel(node="B", axis="y"), -700 / (2 * E * A), rtol=1e-12)
    np.testing.assert_allclose(found.elongation.values[0], [-350 / (E * A), 350 / (E * A)], rtol=1e-12)


def test_poses_keep_their_names_and_weights():
    model = kt.library.vgt.double_octahedral(payload_mass=3.0)
    forces = kt.statics.at_poses(model, {"up": {}, "over": {"bay.beta": 0.1}}, weight="lumped")
    found = kt.statics.deflection(model, forces)
    assert found.energy.sel(pose="over").item() == found.energy.values[1]
    assert np.abs(found.work_balance).max() < 1e-12 * found.energy.max()


def test_members_without_material_do_not_give_way():
    model = kt.library.vgt.double_octahedral(tip_force=(0, 0, 46))
    stiff = {name: (bar if name != "M6" else kt.Bar(ends=bar.ends, mass=0.1)) for name, bar in model.bars.items()}
    found = kt.statics.deflection(model.with_(bars=stiff), kt.statics.at_poses(model.with_(bars=stiff), [{}]))
    assert found.elongation.sel(member="M6").item() == 0.0


def test_forces_of_another_model(slewed):
    with pytest.raises(InputError, match="other members"):
        kt.statics.deflection(kt.library.vgt.double_octahedral(), slewed[1])
