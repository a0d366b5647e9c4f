"""The stiffness method: closed forms, reciprocity, energy theorems, equilibrium, mechanisms by name."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.mechanics import compile

AREA, E = 2e-4, 70e9
SECTION = kt.General(area=AREA, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)
METAL = kt.Material(E=E, density=2700.0)

forces = st.floats(-1e3, 1e3)


def fan(angle, load=(0.0, -1000.0), **changes):
    """A vertical bar of length 1 between two at `angle` to it, hung from a ceiling, loaded where they meet."""
    t = np.tan(angle)
    fields = {
        "nodes": {"L": (-t, 1), "M": (0, 1), "R": (t, 1), "P": (0, 0)},
        "fixed": ["L", "M", "R"],
        "bars": {"left": ("L", "P"), "middle": ("M", "P"), "right": ("R", "P")},
        "section": SECTION,
        "material": METAL,
        "loads": {"load": kt.NodalForce(node="P", force=load)},
    }
    return kt.Model(**fields | changes)


def tower(loads=None, random=None):
    """A redundant spatial tower: two storeys, every face crossed."""
    shift = np.zeros((8, 3)) if random is None else np.array(random).reshape(8, 3)
    at = [(x, y, z) for z in (0.0, 1.0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    nodes = {f"N{k}": tuple(np.array(p) + s) for k, (p, s) in enumerate(zip(at, shift, strict=True))}
    pairs = [(i, j) for i in range(8) for j in range(i + 1, 8) if j > 3]
    bars = {f"b{i}{j}": (f"N{i}", f"N{j}") for i, j in pairs}
    return kt.Model(
        nodes=nodes,
        fixed=[f"N{k}" for k in range(4)],
        bars=bars,
        section=SECTION,
        material=METAL,
        loads={f"l{k}": kt.NodalForce(node=node, force=force) for k, (node, force) in enumerate((loads or {}).items())},
    )


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(st.floats(0.1, 1.3))
def test_timoshenko_three_bars(angle):
    """N = P/(1 + 2 cos^3 a), sides N cos^2 a (Timoshenko, Strength of Materials I)."""
    found = kt.statics.linear(fan(angle), weight=False)
    middle = 1000 / (1 + 2 * np.cos(angle) ** 3)
    expected = [middle * np.cos(angle) ** 2, middle, middle * np.cos(angle) ** 2]
    np.testing.assert_allclose(found.member_force, expected, rtol=1e-11)
    np.testing.assert_allclose(found.displacement.sel(node="P"), [0, -middle / (E * AREA)], rtol=1e-11, atol=1e-18)
    assert found.work.item() == pytest.approx(found.energy.item(), rel=1e-12)
    np.testing.assert_allclose(found.strain, found.member_force / (E * AREA), rtol=1e-12)


def test_symmetric_truss_under_a_side_load():
    """The side load goes into the two inclined bars alone, half and half."""
    found = kt.statics.linear(fan(0.7, load=(500.0, 0.0)), weight=False)
    half = 250 / np.sin(0.7)
    np.testing.assert_allclose(found.member_force, [half, 0.0, -half], rtol=1e-12, atol=1e-11)


def test_own_weight_of_a_hanging_bar():
    """Tension W at the top, 0 at the foot, W/2 on average; the foot sinks by W l/(2 E A)."""
    model = kt.Model(nodes={"A": (0, 2), "B": (0, 0)}, fixed={"A": "xy", "B": "x"}, bars={"b": ("A", "B")}, section=SECTION,
                     material=METAL, gravity=(0, -9.81))  # fmt: skip
    found = kt.statics.linear(model)
    W = 2700 * AREA * 2 * 9.81
    np.testing.assert_allclose(found.end_force.values[0], [W, 0], atol=1e-13)
    assert found.member_force.item() == pytest.approx(W / 2, rel=1e-14)
    assert found.displacement.sel(node="B", axis="y").item() == pytest.approx(-W * 2 / (2 * E * AREA), rel=1e-13)
    assert kt.statics.linear(model, weight="lumped").member_force.item() == 0.0


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(
    st.lists(st.floats(-0.2, 0.2), min_size=24, max_size=24),
    st.tuples(forces, forces, forces),
    st.tuples(forces, forces, forces),
)
def test_maxwell_betti(shifts, first, second):
    """The first loads do the same work along the second displacements as the second along the first."""
    one = kt.statics.linear(tower({"N4": first, "N6": second}, shifts), weight=False)
    two = kt.statics.linear(tower({"N5": second, "N7": first}, shifts), weight=False)
    there = np.array(first) @ two.displacement.sel(node="N4").values + np.array(second) @ two.displacement.sel(node="N6").values
    back = np.array(second) @ one.displacement.sel(node="N5").values + np.array(first) @ one.displacement.sel(node="N7").values
    scale = np.abs(one.displacement.values).max() + np.abs(two.displacement.values).max()
    assert abs(there - back) <= 1e-11 * scale * (1 + np.abs(first).max() + np.abs(second).max())


def test_castigliano_on_a_redundant_tower():
    """Deflection is dU/dF; U is quadratic in F, so central differences are exact but for round-off."""
    base = {"N4": (300.0, 0.0, -500.0), "N6": (0.0, 200.0, -100.0)}
    found = kt.statics.linear(tower(base), weight=False).displacement.sel(node="N6").values
    h = 50.0
    for k in range(3):
        energies = []
        for sign in (1, -1):
            load = np.array(base["N6"])
            load[k] += sign * h
            energies.append(kt.statics.linear(tower(base | {"N6": tuple(load)}), weight=False).energy.item())
        assert (energies[0] - energies[1]) / (2 * h) == pytest.approx(found[k], rel=1e-10, abs=1e-15)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(st.lists(st.floats(-0.2, 0.2), min_size=24, max_size=24), st.tuples(forces, forces, forces))
def test_forces_and_reactions_of_a_redundant_tower_balance(shifts, load):
    model = tower({"N5": load}, shifts).with_(gravity=(0.0, 1.0, -9.81))
    found = kt.statics.linear(model)
    system = compile(model)
    weight = system.rods[:, 0].sum() * np.array([0, 1.0, -9.81])
    size = np.abs(found.reaction.values).max() + 1
    np.testing.assert_allclose(found.reaction.sum(dim="support").values + load + weight, 0, atol=1e-10 * size)
    at = np.array([node.at for node in model.nodes.values()])
    middles = 0.5 * (at[system.p] + at[system.q])
    moments = np.cross(at[:4], found.reaction.values).sum(axis=0) + np.cross(at[5], load)
    moments += np.cross(middles, system.rods[:, :1] * np.array([0, 1.0, -9.81])).sum(axis=0)
    np.testing.assert_allclose(moments, 0, atol=1e-10 * size)
    # compatible: every elongation is that of the displaced ends
    u = (at[system.q] - at[system.p]) / np.linalg.norm(at[system.q] - at[system.p], axis=1, keepdims=True)
    apart = found.displacement.values[system.q] - found.displacement.values[system.p]
    np.testing.assert_allclose(found.elongation, np.einsum("mc,mc->m", u, apart), atol=1e-15)


def test_redundant_share_is_that_of_inverse_dynamics():
    model = tower({"N5": (100.0, -200.0, -300.0), "N7": (50.0, 0.0, 0.0)}).with_(gravity=(0, 0, -9.81))
    found, shared = kt.statics.linear(model), kt.statics.at_poses(model, [{}])
    size = np.abs(found.member_force.values).max()
    np.testing.assert_allclose(shared.member_force.values[0], found.member_force, atol=1e-11 * size)
    np.testing.assert_allclose(shared.reaction.values[0], found.reaction, atol=1e-11 * size)
    assert "not unique" in shared.message


@pytest.mark.parametrize("weight", [True, "lumped", False])
def test_determinate_bays_agree_with_inverse_dynamics(weight):
    model = kt.library.vgt.double_octahedral(3, beta=0.12, gamma=-0.08, tip_force=(20, -10, 45), payload_mass=2.0)
    forces = kt.statics.at_poses(model, [{"B2.beta": 0.05}, {"B1.M7": 1.2}], weight=weight)
    for i, position in enumerate(forces.motion.position.values):
        found = kt.statics.linear(model, position, weight=weight)
        size = np.abs(found.member_force.values).max()
        for name in ("member_force", "end_force", "reaction"):
            np.testing.assert_allclose(forces.data[name].values[i], found.data[name].values, atol=1e-10 * size)
        assert found.work.item() == pytest.approx(found.energy.item(), rel=1e-11)


def test_angles_coordinate_drives_and_inextensible_bars():
    """A crank held by its angle drive: a cantilever that does not bend, carried by the drive."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0.5), "D": (3, 0)}, fixed={"A": "xy", "D": "y"},
        bars={"a": ("A", "B"), "b": {"ends": ("B", "C"), "section": SECTION, "material": METAL}, "c": ("C", "D")},
        drives={"turn": kt.AngleDrive("a"), "slide": kt.CoordinateDrive(node="D", axis="x")},
        loads={"l": kt.NodalForce(node="C", force=(0.0, -100.0))},
    )  # fmt: skip
    found, forces = kt.statics.linear(model), kt.statics.at_poses(model, [{}])
    np.testing.assert_allclose(found.member_force, forces.member_force.values[0], atol=1e-11)
    assert found.message == "Kept inextensible, since they have no section or no material: a, c."
    assert found.elongation.values[[0, 2]].tolist() == [0.0, 0.0]


def test_rigid_members_on_request():
    soft, stiff = kt.statics.linear(fan(0.6), weight=False), kt.statics.linear(fan(0.6), weight=False, rigid=["middle"])
    assert stiff.member_force.sel(member="middle").item() == pytest.approx(1000)
    np.testing.assert_allclose(stiff.displacement.values, 0, atol=1e-20)
    assert soft.energy > stiff.energy
    with pytest.raises(InputError, match="No member called 'midle' to keep rigid. Did you mean 'middle'"):
        kt.statics.linear(fan(0.6), rigid=["midle"])


def test_prestressed_elastic_bars():
    """Two springs pull against each other; a load between them shifts the balance by F/(k1 + k2)."""
    k = E * AREA
    model = kt.Model(
        nodes={"A": (0, 0), "M": (1, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "xy", "M": "y"},
        bars={"a": kt.Bar(ends=("A", "M"), kind="elastic", natural_length=0.999),
              "b": kt.Bar(ends=("M", "B"), kind="elastic", natural_length=0.999)},
        section=SECTION, material=METAL, loads={"l": kt.NodalForce(node="M", force=(1000.0, 0.0))},
    )  # fmt: skip
    found = kt.statics.linear(model)
    assert found.displacement.sel(node="M", axis="x").item() == pytest.approx(1000 * 0.999 / (2 * k), rel=1e-12)
    np.testing.assert_allclose(found.member_force, k * 0.001 / 0.999 + np.array([500, -500]), rtol=1e-12)
    assert found.energy.item() == pytest.approx(found.work.item(), rel=1e-12)


def test_mechanisms_are_named():
    square = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    bars = {"b": ("B", "C"), "c": ("C", "D"), "d": ("D", "A")}
    model = kt.Model(nodes=square, fixed=["A", "B"], bars=bars, section=SECTION, material=METAL)
    with pytest.raises(InputError, match=r"mechanism here.*1 freedom\): C moves along x .*D moves along x"):
        kt.statics.linear(model)
    # two bars in one line hold nothing across it, at least not to first order
    flat = kt.Model(nodes={"A": (0, 0), "M": (1, 0), "B": (2, 0)}, fixed=["A", "B"], bars={"a": ("A", "M"), "b": ("M", "B")},
                    section=SECTION, material=METAL)  # fmt: skip
    with pytest.raises(InputError, match="M moves along y"):
        kt.statics.linear(flat)
    loose = model.with_(nodes=square | {"X": (3, 3)}, bars=bars | {"e": ("A", "C")})
    with pytest.raises(InputError, match=r"2 freedoms\): X moves"):
        kt.statics.linear(loose)


def test_inextensible_bars_that_share_a_force():
    with pytest.raises(InputError, match="inextensible bars are not unique: .*Give them a section"):
        kt.statics.linear(fan(0.6, section=None))


def test_bad_arguments():
    with pytest.raises(InputError, match="No load case called 'x'"):
        kt.statics.linear(fan(0.6), load_case="x")
    with pytest.raises(InputError, match="weight='members': give True"):
        kt.statics.linear(fan(0.6), weight="members")
    with pytest.raises(InputError, match=r"position: shape \(3, 2\), expected \(n_nodes = "):
        kt.statics.linear(fan(0.6), np.zeros((3, 2)))


def test_load_in_time_and_load_case():
    table = kt.NodalForce(node="P", times=(0.0, 1.0), forces=((0.0, 0.0), (0.0, -100.0)))
    model = fan(0.6).with_(loads={"t": table}, load_cases={"twice": kt.LoadCase(loads={"t": 2.0})})
    one = kt.statics.linear(model, time=0.5)
    two = kt.statics.linear(model, load_case="twice", time=0.25)
    np.testing.assert_allclose(one.member_force, two.member_force, rtol=1e-14)
    assert one.reaction.sel(axis="y").sum().item() == pytest.approx(50)
