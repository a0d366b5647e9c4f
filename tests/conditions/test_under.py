"""Models under operating conditions, against closed forms and against models written by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235
ALPHA = 12e-6
TUBE = kt.Tube(outer=0.03, inner=0.026)
NODES = {"A": (0, 0), "B": (2, 0), "C": (1, 1.5), "D": (3, 1.5)}
TRUSS = {"ab": ("A", "B"), "ac": ("A", "C"), "bc": ("B", "C"), "cd": ("C", "D"), "bd": ("B", "D")}
vectors = st.tuples(*[st.floats(-20, 20, allow_subnormal=False).map(lambda value: round(value, 6))] * 2)


def truss(**changes):
    fields = {
        "nodes": NODES,
        "fixed": {"A": "xy", "B": "y"},
        "bars": TRUSS,
        "section": TUBE,
        "material": STEEL,
        "gravity": (0, -9.81),
        "loads": {"push": kt.NodalForce(node="D", force=(100, -1000))},
        "load_cases": {"all": kt.LoadCase(), "twice": kt.LoadCase(loads={"push": 2}, gravity=(0, -5))},
    }
    return kt.Model(**fields | changes)


def at_rest(model, case=None):
    return kt.statics.at_poses(model, [{}], load_case=case)


def test_heat_stretches_a_determinate_truss_in_shape_and_strains_no_bar():
    cold, hot = truss(gravity=None, loads={}, load_cases={}), 80.0
    warm = kt.under(cold, kt.Condition(temperature=hot))
    grown = {name: np.array(node.at) for name, node in warm.nodes.items()}
    for name, at in NODES.items():
        assert grown[name] == pytest.approx(np.array(at) * (1 + ALPHA * hot), rel=1e-12, abs=1e-14)
    assert np.abs(at_rest(warm).member_force.values).max() < 1e-9
    moved = kt.statics.linear(warm)
    assert np.abs(moved.member_force.values).max() < 1e-9


def test_a_warm_truss_weighs_what_the_cold_one_does():
    """Density times area times the cold lengths; a given mass."""
    bars = TRUSS | {"bd": kt.Bar(ends=("B", "D"), mass=3.0)}
    model, forces = truss(bars=bars, loads={}, load_cases={}), {}
    for name, one in {"cold": model, "hot": kt.under(model, kt.Condition(temperature=200.0))}.items():
        forces[name] = sum(at_rest(one).reaction.values[0])
    area, lengths = np.pi / 4 * (0.03**2 - 0.026**2), [2, np.hypot(1, 1.5), np.hypot(1, 1.5), 2]
    weight = 9.81 * (STEEL.density * area * sum(lengths) + 3.0)
    for found in forces.values():
        assert found[1] == pytest.approx(weight, rel=1e-12)


def test_heat_in_one_bar_moves_the_nodes_by_its_lengthening():
    warm = kt.under(truss(), kt.Condition(temperatures={"ab": 100.0}))
    assert warm.nodes["B"].at[0] == pytest.approx(2 * (1 + ALPHA * 100), rel=1e-12)
    lengths = {name: np.hypot(*np.subtract(warm.nodes[q].at, warm.nodes[p].at)) for name, (p, q) in TRUSS.items()}
    for name, (p, q) in TRUSS.items():
        if name != "ab":
            assert lengths[name] == pytest.approx(np.hypot(*np.subtract(NODES[q], NODES[p])), rel=1e-12)


@pytest.mark.parametrize("hot", [-60.0, 45.0])
def test_a_clamped_elastic_bar_has_the_thermal_force(hot):
    """N = E A (L - l0)/l0 with l0 = L (1 + alpha dT), the ends held."""
    held = truss(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A", "B"], gravity=None, loads={}, load_cases={},
                 bars={"b": kt.Bar(ends=("A", "B"), kind="elastic")})  # fmt: skip
    warm = kt.under(held, kt.Condition(temperature=hot))
    wanted = -STEEL.E * TUBE.area * ALPHA * hot / (1 + ALPHA * hot)
    assert kt.statics.equilibrium(warm).member_force.item() == pytest.approx(wanted, rel=1e-9)
    assert kt.statics.linear(warm).member_force.item() == pytest.approx(wanted, rel=1e-9)


def test_two_elastic_bars_in_a_row_share_the_heat_of_one():
    """Row of bars of equal k between walls, one heated: N = -k alpha L dT/2 to first order."""
    row = truss(nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, fixed={"A": "xy", "B": "y", "C": "xy"}, gravity=None, loads={},
                load_cases={}, bars={"one": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=1e6),
                                     "two": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=1e6)})  # fmt: skip
    found = kt.statics.linear(kt.under(row, kt.Condition(temperatures={"one": 50.0})))
    assert found.member_force.values == pytest.approx([-0.5e6 * ALPHA * 50] * 2, rel=1e-9)
    assert found.displacement.sel(node="B", axis="x").item() == pytest.approx(0.5 * ALPHA * 50, rel=1e-9)


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(vectors, vectors)
def test_base_acceleration_is_gravity_shifted(gravity, acceleration):
    asked = truss(gravity=gravity, nodes={**NODES, "D": {"at": NODES["D"], "mass": 3.0, "gravity": (1, 2)}})
    shaken = kt.under(asked, kt.Condition(base_acceleration=acceleration))
    shift = np.array(acceleration)
    by_hand = truss(
        gravity=tuple(np.array(gravity) - shift),
        nodes={**NODES, "D": {"at": NODES["D"], "mass": 3.0, "gravity": tuple(np.array((1, 2)) - shift)}},
    )
    for case in (None, "all"):
        assert at_rest(shaken, case).member_force.values == pytest.approx(at_rest(by_hand, case).member_force.values, abs=1e-9)
    left = at_rest(shaken, "twice").reaction.sum("support").values[0]
    right = at_rest(asked, "twice").reaction.sum("support").values[0]
    mass = sum(STEEL.density * TUBE.area * np.hypot(*np.subtract(NODES[q], NODES[p])) for p, q in TRUSS.values()) + 3.0
    assert left - right == pytest.approx(mass * shift, rel=1e-9, abs=1e-8)  # supports give all nodes the acceleration


def test_a_bar_pushed_by_its_support_is_compressed_by_the_mass_before_it():
    rod = kt.Model(nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")})
    shaken = kt.under(rod, kt.Condition(base_acceleration=(3.0, 0)))
    assert at_rest(shaken).member_force.item() == pytest.approx(-2.0 * 3.0, rel=1e-12)


def test_gravity_payload_and_forces_are_those_written_by_hand():
    turned = kt.under(truss(), kt.Condition(gravity=(9.81, 0), payloads={"C": 4.0}, forces={"D": (0, 50)}))
    by_hand = truss(
        gravity=(9.81, 0),
        nodes={**NODES, "C": {"at": NODES["C"], "mass": 4.0}},
        loads={"push": kt.NodalForce(node="D", force=(100, -1000)), "tip": kt.NodalForce(node="D", force=(0, 50))},
        load_cases={"all": kt.LoadCase(), "twice": kt.LoadCase(loads={"push": 2, "tip": 1})},
    )
    for case in (None, "all", "twice"):
        assert at_rest(turned, case).member_force.values == pytest.approx(at_rest(by_hand, case).member_force.values, rel=1e-12)


def test_a_failed_member_is_gone_and_a_redundant_truss_goes_on_without_it():
    braced = truss(bars={**TRUSS, "ad": ("A", "D")})
    left = kt.under(braced, kt.Condition(failed=("ad",)))
    assert at_rest(left).member_force.values == pytest.approx(at_rest(truss()).member_force.values, rel=1e-9)


def test_a_driven_bar_let_go_keeps_its_mass_and_carries_nothing():
    lift = {"ab": ("A", "B"), "ac": ("A", "C"), "bc": ("B", "C"), "cd": ("C", "D"), "bd": ("B", "D")}
    model = truss(bars={**lift, "ad": kt.Bar(ends=("A", "D"), kind="driven")})
    free = kt.under(model, kt.Condition(released=("ad",)))
    assert free.bars["ad"].kind == "free" and not free.all_drives
    forces = at_rest(free)
    assert forces.member_force.sel(member="ad").item() == 0.0
    weight = kt.statics.at_poses(model, [{}]).reaction.sum("support").values
    assert forces.reaction.sum("support").values == pytest.approx(weight, rel=1e-9)


@pytest.mark.parametrize(
    ("condition", "said"),
    [
        ({"payloads": {"Z": 1}}, "no node called 'Z'"),
        ({"forces": {"C": (1, 2, 3)}}, "has 3 components"),
        ({"gravity": (0, 0, -9.81)}, "has 3 components"),
        ({"failed": ("zz",)}, "no member called 'zz'"),
        ({"locked": ("zz",)}, "no drive called 'zz'"),
        ({"temperatures": {"zz": 1}}, "no member called 'zz'"),
    ],
)
def test_unknown_names_are_faults_of_the_model(condition, said):
    with pytest.raises(kt.ModelError, match=said):
        truss(conditions={"odd": kt.Condition(**condition)})


def test_what_cannot_be_is_told_with_its_mend():
    with pytest.raises(kt.ModelError, match="'b' is locked and failed. Name it once"):
        kt.Condition(locked=("b",), failed=("b",))
    with pytest.raises(kt.InputError, match="no thermal expansion is known"):
        kt.under(truss(material=STEEL.with_(thermal_expansion=None)), kt.Condition(temperature=1))
    walled = truss(fixed=["A", "B"])
    with pytest.raises(kt.InputError, match=r"\(kind: elastic\)"):
        kt.under(walled, kt.Condition(temperature=50))
    with pytest.raises(kt.ModelError, match="no coefficient of expansion"):
        STEEL.with_(thermal_expansion=12.0)
    bay = kt.library.vgt.double_octahedral(bays=1)
    with pytest.raises(kt.InputError, match="Simulate it"):
        kt.under(bay, kt.Condition(released=("M7",)))
