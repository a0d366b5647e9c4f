"""Combinations of load cases: counted by hand, by EN 1990 and ASCE 7-16, and how analyses, runs and verdicts take them."""

from typing import get_args

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.kinematics.conditions import under
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import case_loads
from kinetruss.model.load_cases import Category, acting_cases, sets_of
from kinetruss.model.load_codes import ASCE, DEAD, PERMANENT, PSI, together

STEEL = kt.Material(E=200e9, density=7850.0, yield_strength=235e6)


def truss(cases, combinations, gravity=None, **more):
    """Two bars that carry forces at their joint."""
    pushes = {"dead": (0, -10e3), "floor": (0, -6e3), "snow": (0, -4e3), "west": (6e3, 0), "east": (-5e3, 0)}
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (1, 1)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")},
        section=kt.Rod(diameter=0.03), material=STEEL, gravity=gravity, load_cases=cases, combinations=combinations,
        loads={name: kt.NodalForce(node="C", force=push) for name, push in pushes.items()}, **more,
    )  # fmt: skip


def case(load, category=None, **more):
    return kt.LoadCase(loads={load: 1}, category=category, **more)


EUROPE = {
    "G": case("dead", "permanent"), "Q": case("floor", "imposed B"), "S": case("snow", "snow"), "W": case("west", "wind"),
}  # fmt: skip
AMERICA = {"D": case("dead", "D"), "L": case("floor", "L"), "S": case("snow", "S"), "W": case("west", "W")}


def factors(model, name="uls"):
    """The factors of all combinations of a set, read from the loads of the cases that they are."""
    of = {load: key for key, one in model.load_cases.items() for load in one.loads}
    return [{of[load]: value for load, value in model.cases[key].loads.items()} for key in sets_of(model)[name]]


def test_categories_are_those_of_the_standards():
    assert set(get_args(Category)) == {PERMANENT, *PSI, DEAD, *ASCE}


# By hand.


def test_a_combination_is_a_load_case():
    model = truss(EUROPE, {"both": {"G": 1.35, "W": 1.5}})
    found = case_loads(compile(model), np.zeros(1), "both").force[0].sum(axis=0)
    np.testing.assert_allclose(found, [9e3, -13.5e3, 0], rtol=1e-12)
    forces = kt.runs.forces_at_rest(model, load_case="both")
    np.testing.assert_allclose(forces.data.reaction.sum("support").values[0], [-9e3, 13.5e3], rtol=1e-12)
    alone = [kt.runs.forces_at_rest(model, load_case=name).data.member_force.values for name in "GW"]
    np.testing.assert_allclose(forces.data.member_force, 1.35 * alone[0] + 1.5 * alone[1], rtol=1e-12)
    assert model.cases["both"].title == "1.35 G + 1.5 W"


def test_loads_in_several_cases_add_up():
    cases = {"one": kt.LoadCase(loads={"dead": 1, "floor": 2}), "two": kt.LoadCase(loads={"floor": 0.5}), "all": kt.LoadCase()}
    model = truss(cases, {"sum": {"one": 2, "two": 4, "all": -1}})
    assert dict(model.cases["sum"].loads) == {"dead": 1, "floor": 5, "snow": -1, "west": -1, "east": -1}


def test_weight_counts_once():
    """The permanent case brings it; without one, the only case that does not give its own."""
    model = truss(EUROPE, {"uls": {"G": 1.35, "Q": 1.5}}, gravity=(0, -10))
    np.testing.assert_allclose(model.cases["uls"].gravity, (0, -13.5))
    still = {"one": case("dead"), "two": case("floor", gravity=(0, 0))}
    np.testing.assert_allclose(truss(still, {"uls": {"one": 1.2, "two": 1.5}}, gravity=(0, -10)).cases["uls"].gravity, (0, -12))
    moon = {"one": case("dead", gravity=(0, -2)), "two": case("floor", gravity=(1, 0))}
    np.testing.assert_allclose(truss(moon, {"uls": {"one": 1.5, "two": 2}}).cases["uls"].gravity, (2, -3))
    assert truss(EUROPE, {"uls": {"G": 1.35, "Q": 1.5}}).cases["uls"].gravity is None


# EN 1990, by hand: permanent G, imposed B (0.7, 0.5, 0.3), snow (0.5, 0.2, 0), wind (0.6, 0.2, 0).


def by_hand_610(sup=1.35):
    """Of G and the subsets of Q, S, W, each leading in turn."""
    found = []
    for g in (sup, 1.0):
        found += [
            {"G": g},
            {"G": g, "Q": 1.5}, {"G": g, "S": 1.5}, {"G": g, "W": 1.5},
            {"G": g, "Q": 1.5, "S": 0.75}, {"G": g, "Q": 1.05, "S": 1.5},
            {"G": g, "Q": 1.5, "W": 0.9}, {"G": g, "Q": 1.05, "W": 1.5},
            {"G": g, "S": 1.5, "W": 0.9}, {"G": g, "S": 0.75, "W": 1.5},
            {"G": g, "Q": 1.5, "S": 0.75, "W": 0.9}, {"G": g, "Q": 1.05, "S": 1.5, "W": 0.9},
            {"G": g, "Q": 1.05, "S": 0.75, "W": 1.5},
        ]  # fmt: skip
    return found


def same(found, wanted):
    assert {frozenset(one.items()) for one in found} == {frozenset(one.items()) for one in wanted}
    assert len(found) == len(wanted)


def test_equation_610():
    model = truss(EUROPE, {"uls": kt.En1990()})
    same(factors(model), by_hand_610())
    name = "uls.W.1.35G+1.05Q+0.75S+1.5W"
    assert model.cases[name].title == "1.35 G + 1.05 Q + 0.75 S + 1.5 W (EN 1990 6.10, leading W)"


def test_equations_610a_and_b():
    """6.10a: G and all variable actions with psi_0; 6.10b: as 6.10 with 0.85 x 1.35 G = 1.1475 G."""
    model = truss(EUROPE, {"uls": kt.En1990(equations=["6.10ab"])})
    psi = {"Q": 1.05, "S": 0.75, "W": 0.9}
    a = [{"G": g} | {name: psi[name] for name in some} for g in (1.35, 1.0) for some in together("QSW", [])]
    same(factors(model), a + [one for one in by_hand_610(1.1475) if one != {"G": 1.0}])


def test_serviceability():
    """6.14b: first whole, others psi_0; 6.15b: first psi_1, others psi_2; 6.16b: all psi_2."""
    cases = {name: EUROPE[name] for name in "GQW"}
    found = {one: factors(truss(cases, {"uls": kt.En1990(equations=[one])})) for one in ("6.14b", "6.15b", "6.16b")}
    G = {"G": 1.0}
    same(found["6.14b"], [G, G | {"Q": 1.0}, G | {"W": 1.0}, G | {"Q": 1.0, "W": 0.6}, G | {"Q": 0.7, "W": 1.0}])
    same(found["6.15b"], [G, G | {"Q": 0.5}, G | {"W": 0.2}, G | {"Q": 0.3, "W": 0.2}])
    same(found["6.16b"], [G, G | {"Q": 0.3}])


def test_national_values():
    own = kt.En1990(unfavourable=1.2, variable=1.4, psi={"wind": (0.5, 0.2, 0)}, cases=["G", "Q", "W"])
    found = factors(truss(EUROPE, {"uls": own}))
    assert {"G": 1.2, "Q": 1.4, "W": 0.7} in found
    assert max(one["G"] for one in found) == 1.2


def test_cases_that_exclude_each_other():
    cases = {"G": EUROPE["G"], "west": case("west", "wind"), "east": case("east", "wind")}
    found = factors(truss(cases, {"uls": kt.En1990(exclusive=[["west", "east"]])}))
    G = [{"G": g} | more for g in (1.35, 1.0) for more in ({}, {"west": 1.5}, {"east": 1.5})]
    same(found, G)


def test_permanent_actions_are_favourable_by_themselves():
    cases = {"G": EUROPE["G"], "H": case("floor", "permanent")}
    same(factors(truss(cases, {"uls": kt.En1990()})), [{"G": g, "H": h} for g in (1.35, 1.0) for h in (1.35, 1.0)])


# ASCE 7-16, by hand: D, L, S, W.


def test_strength_design():
    """2.3.1, equations 1 to 5, with every companion acting or not."""
    model = truss(AMERICA, {"uls": kt.Asce7()})
    wanted = [{"D": 1.4}]
    wanted += [{"D": 1.2, "L": 1.6}, {"D": 1.2, "L": 1.6, "S": 0.5}]
    wanted += [{"D": 1.2, "S": 1.6}, {"D": 1.2, "S": 1.6, "L": 1.0}, {"D": 1.2, "S": 1.6, "W": 0.5}]
    wanted += [{"D": 1.2, "W": 1.0} | L | S for L in ({}, {"L": 1.0}) for S in ({}, {"S": 0.5})]
    wanted += [{"D": 0.9, "W": 1.0}]
    same(factors(model), wanted)
    assert model.cases["uls.W.1.2D+L+0.5S+W"].title.endswith("(ASCE 7-16 2.3.1-4, leading W)")


def test_allowable_stress_design():
    """2.4.1, equations 1 to 7."""
    wanted = [{"D": 1.0}, {"D": 1.0, "L": 1.0}, {"D": 1.0, "S": 1.0}]
    wanted += [{"D": 1.0, "L": 0.75}, {"D": 1.0, "L": 0.75, "S": 0.75}]
    wanted += [{"D": 1.0, "W": 0.6}]
    wanted += [{"D": 1.0, "W": 0.45} | L | S for L in ({}, {"L": 0.75}) for S in ({}, {"S": 0.75})]
    wanted += [{"D": 0.6, "W": 0.6}]
    same(factors(truss(AMERICA, {"uls": kt.Asce7(method="ASD")})), wanted)


def test_seismic_effects():
    """2.3.6, equations 6 and 7: the vertical effect acts against the dead load in 7."""
    cases = {"D": AMERICA["D"], "E": case("west", "E"), "V": case("snow", "Ev")}
    found = factors(truss(cases, {"uls": kt.Asce7()}))
    assert {"D": 1.2, "E": 1.0, "V": 1.0} in found
    assert {"D": 0.9, "E": 1.0, "V": -1.0} in found
    found = factors(truss(cases, {"uls": kt.Asce7(method="ASD")}))
    for one in ({"D": 1.0, "E": 0.7, "V": 0.7}, {"D": 1.0, "E": 0.525, "V": 0.525}, {"D": 0.6, "E": 0.7, "V": -0.7}):
        assert one in found


def test_one_roof_load_at_a_time():
    cases = {"D": AMERICA["D"], "Lr": case("floor", "Lr"), "S": AMERICA["S"], "R": case("west", "R")}
    found = factors(truss(cases, {"uls": kt.Asce7()}))
    assert all(len({"Lr", "S", "R"} & set(one)) <= 1 for one in found)


# In files, runs and verdicts.

FILE = """
nodes: {A: [0, 0], B: [2, 0], C: [1, 1]}
fixed: [A, B]
bars: {a: [A, C], b: [B, C]}
section: {kind: rod, diameter: 30 mm}
material: steel_s235
gravity: [0, -9.81]
loads:
  dead: {node: C, force: [0, -10 kN]}
  wind: {node: C, force: [15 kN, 0]}
load_cases:
  G: {loads: {dead: 1}, category: permanent, title: dead load}
  W: {loads: {wind: 1}, category: wind}
combinations: {kind: en1990, equations: ["6.10", 6.14b]}
runs:
  rest: {analysis: statics.linear}
"""


def test_a_file_with_combinations(tmp_path):
    (tmp_path / "roof.yaml").write_text(FILE, encoding="utf-8")
    model = kt.read(tmp_path / "roof.yaml")
    assert list(model.combinations) == ["en1990"]
    assert len(sets_of(model)["en1990"]) == 5
    kt.io.write(model, tmp_path / "again.yaml")
    assert kt.read(tmp_path / "again.yaml").combinations == model.combinations


def test_runs_take_all_combinations_and_the_verdict_names_the_governing_one():
    runs = {"rest": kt.Run(analysis="statics.linear")}
    model = truss(EUROPE, {"uls": kt.En1990()}, gravity=(0, -9.81), runs=runs)
    block = kt.run(model, "rest")
    assert set(block.forces) == set(sets_of(model)["uls"])
    # by hand: bar b is pressed by the vertical force and by the wind from the left
    down, side = 1.35 * 10e3 + 1.05 * 6e3 + 0.75 * 4e3, 1.5 * 6e3
    worst = {name: abs(one.data.member_force.sel(member="b").values[0]) for name, one in block.forces.items()}
    governing = max(worst, key=worst.get)
    assert governing == "uls.W.1.35G+1.05Q+0.75S+1.5W"
    weight = 1.35 * 9.81 * 7850 * np.pi * 0.015**2 * np.sqrt(2)  # half of each bar at the joint
    np.testing.assert_allclose(worst[governing], (down + side) / np.sqrt(2) + weight / np.sqrt(2), rtol=1e-9)
    row = block.verdict.table()[0]
    assert row.load_case == governing
    assert governing in block.finding.sentence


def test_a_run_may_name_a_set_a_combination_or_a_case():
    model = truss(EUROPE, {"uls": kt.En1990(cases=["G", "W"]), "mine": {"G": 1, "Q": 1}})
    assert acting_cases(model, ["mine", "G"]) == ("mine", "G")
    assert acting_cases(model, ["uls"]) == sets_of(model)["uls"]
    assert acting_cases(model, None) == (*sets_of(model)["uls"], "mine")
    assert acting_cases(model.with_(combinations={}), None) == ("G", "Q", "S", "W")
    simulated = kt.Run(analysis="dynamics.simulate", t_end=1.0, load_cases=["uls"])
    with pytest.raises(kt.ModelError, match=r"runs\.r\.load_cases: names 4 combinations by 'uls'"):
        kt.check(model.with_(runs={"r": simulated}))


def test_conditions_keep_the_factor_of_the_weight():
    """On the moon the combination has 1.35 times the gravity of the moon; a case without weight stays without."""
    cases = EUROPE | {"Q": case("floor", "imposed B", gravity=(0, 0))}
    moon = {"moon": kt.Condition(gravity=(0, -1.62))}
    model = truss(cases, {"uls": {"G": 1.35, "Q": 1.5}}, gravity=(0, -9.81), conditions=moon)
    np.testing.assert_allclose(under(model, "moon").cases["uls"].gravity, (0, -1.35 * 1.62))


@pytest.mark.parametrize(
    ("cases", "combinations", "gravity", "words"),
    [
        (EUROPE, {"uls": {"G": 1.35, "P": 1}}, None, r"combinations\.uls\.cases\.P: no load case called 'P'"),
        (EUROPE, {"G": {"Q": 1.0}}, None, r"combinations\.G: is also the name of a load case"),
        (EUROPE, {"uls": {"Q": 1.5, "W": 1.5}}, (0, -9.81), r"has the weight of the model in 2 of its cases: Q, W"),
        (
            EUROPE | {"H": case("floor", "permanent")}, {"uls": kt.En1990()}, (0, -9.81),
            r"has the weight of the model in 2 of its cases: G, H.*Give gravity: 0",
        ),
        (EUROPE | {"X": case("east")}, {"uls": kt.En1990()}, None, r"load_cases\.X\.category: has no category"),
        (AMERICA, {"uls": kt.En1990()}, None, r"load_cases\.D\.category: 'D' is no category of EN 1990"),
        (EUROPE, {"uls": kt.Asce7()}, None, r"load_cases\.G\.category: 'permanent' is no category of ASCE 7-16"),
        ({"Q": EUROPE["Q"]}, {"uls": kt.En1990()}, (0, -9.81), r"has no case of category permanent, so no weight"),
        ({}, {"uls": kt.En1990()}, None, r"combinations\.uls: combines no load cases"),
        (
            EUROPE, {"uls": kt.En1990(exclusive=[["G", "W"]])}, None,
            r"combinations\.uls\.exclusive\[?\.?0\]?: 'G' is permanent",
        ),
        (
            {f"Q{k}": case("floor", "imposed A") for k in range(12)}, {"uls": kt.En1990()}, None,
            r"makes some 24,576 combinations of 12 cases; 2,000 at most",
        ),
    ],
)  # fmt: skip
def test_faults(cases, combinations, gravity, words):
    with pytest.raises(kt.ModelError, match=words):
        kt.check(truss(cases, combinations, gravity))


def test_faults_of_records():
    with pytest.raises(kt.ModelError, match="is not known"):
        kt.Model(nodes={"A": (0, 0)}, combinations={"kind": "en1991"})
    with pytest.raises(kt.ModelError, match="no category of variable actions"):
        kt.En1990(psi={"permanent": (1, 1, 1)})
    with pytest.raises(kt.ModelError, match="category"):
        kt.LoadCase(category="imposed Z")
    forced = {"gale": kt.Condition(forces={"C": (1, 0)})}
    with pytest.raises(kt.ModelError, match=r"conditions\.gale\.forces: would act in every load case"):
        kt.check(truss(EUROPE, {"uls": {"G": 1.35}}, conditions=forced))
    own = {"A": (0, 0), "B": (2, 0), "C": kt.Node(at=(1, 1), mass=2.0, gravity=(0, -1))}
    with pytest.raises(kt.ModelError, match=r"nodes with a gravity of their own \(C\)"):
        kt.check(truss(EUROPE, {"uls": {"G": 1.35}}).with_(nodes=own))


def test_missions_take_all_combinations():
    """A crank that turns under all combinations: one pair each, and the verdict names that of the largest forces."""
    loads = {"dead": kt.NodalForce(node="B", force=(0, -300.0)), "wind": kt.NodalForce(node="B", force=(400.0, 0))}
    cases = {"G": kt.LoadCase(loads={"dead": 1}, category="permanent"), "W": kt.LoadCase(loads={"wind": 1}, category="wind")}
    turn = kt.ConstantRate(rates={"motor": 1.0}, duration=1.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"bar": ("A", "B")}, drives={"motor": kt.AngleDrive("bar")},
        section=kt.Rod(diameter=0.03), material=STEEL, loads=loads, load_cases=cases, combinations={"uls": kt.En1990()},
        runs={
            "turn": kt.Run(trajectory=turn, samples=5),
            "all": kt.Run(analysis="mission", motions=["turn"], load_cases=["uls"]),
        },
    )  # fmt: skip
    found = kt.run(model, "all")
    assert [str(one) for one in found.pairs["load_case"].values] == list(sets_of(model)["uls"])
    single = kt.run(model, "turn")
    assert set(single.forces) == set(sets_of(model)["uls"])
    assert found.verdict.table()[0].utilisation == pytest.approx(single.verdict.table()[0].utilisation, rel=1e-9)
    assert single.verdict.table()[0].load_case == "uls.W.1.35G+1.5W"
    assert "uls.W.1.35G+1.5W" in found.verdict.table()[0].load_case
    for one in (found, single):
        assert "uls.W.1.35G+1.5W" in one.finding.sentence
