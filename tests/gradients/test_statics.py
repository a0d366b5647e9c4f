"""Gradients of statics and of eigenvalues: closed forms, complex steps of an own stiffness method, differences, refusals."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError
from kinetruss.io import set_value
from kinetruss.io.values import number_at, resolved

LEFT_OUT = ("stiffness", "mode_shape")
GENERAL = kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)
GRID = {f"N{i}{j}": (i + 0.05 * j, j + 0.03 * i * i) for i in range(3) for j in range(3)}
PAIRS = [(a, b) for a in GRID for b in GRID if a < b and math.dist(GRID[a], GRID[b]) < 1.6]


def redundant():
    """A truss of nine nodes, all bars with a section of their own."""
    return kt.Model(
        nodes=GRID, fixed=["N00", "N01", "N02"], material=kt.Material(E=70e9, density=2700.0), gravity=(0, -9.81),
        bars={f"{a}{b}": kt.Bar(ends=(a, b), section=GENERAL) for a, b in PAIRS},
        loads={"tip": kt.NodalForce(node="N20", force=(100.0, -1e3))},
    )  # fmt: skip


def tip_by_stiffness(places, areas):
    """The displacement of N20 along y by the textbook's method of displacements, of complex places (9, 2) and areas."""
    index = {name: i for i, name in enumerate(GRID)}
    K, f = np.zeros((18, 18), complex), np.zeros(18, complex)
    for (a, b), area in zip(PAIRS, areas, strict=True):
        i, j = index[a], index[b]
        d = places[j] - places[i]
        length = np.sqrt((d * d).sum())
        k = 70e9 * area / length * np.outer(d, d) / length**2
        for p, q, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
            K[2 * p : 2 * p + 2, 2 * q : 2 * q + 2] += sign * k
        f[[2 * i + 1, 2 * j + 1]] -= 0.5 * 2700.0 * area * length * 9.81
    f[2 * index["N20"] : 2 * index["N20"] + 2] += (100.0, -1e3)
    return np.linalg.solve(K[6:, 6:], f[6:])[2 * index["N20"] + 1 - 6]


def test_a_displacement_by_complex_steps_of_another_program():
    model = redundant()
    places, areas = np.array([*GRID.values()], complex), np.full(len(PAIRS), 1e-4, complex)
    value, by = kt.value_and_gradient(
        kt.Response("displacement[N20, y]", kt.statics.linear, model), ["bars.*.section.area", "nodes.N1?.at.0"]
    )
    assert value == pytest.approx(tip_by_stiffness(places, areas).real, rel=1e-12)
    expected = []
    for k in range(len(PAIRS)):
        areas[k] += 1e-30j
        expected.append(tip_by_stiffness(places, areas).imag / 1e-30)
        areas[k] -= 1e-30j
    for name in ("N10", "N11", "N12"):
        places[list(GRID).index(name), 0] += 1e-30j
        expected.append(tip_by_stiffness(places, areas).imag / 1e-30)
        places[list(GRID).index(name), 0] -= 1e-30j
    assert by.values == pytest.approx(expected, rel=1e-8, abs=1e-10 * max(map(abs, expected)))


def test_a_bar_with_the_section_of_the_model_gets_one_of_its_own():
    model = redundant().with_(section=GENERAL, bars={f"{a}{b}": kt.Bar(ends=(a, b)) for a, b in PAIRS})
    own = redundant()
    for text in ("energy", "mass"):
        one, other = (kt.gradient(kt.Response(text, kt.statics.linear, of), "bars.*.section.area") for of in (model, own))
        assert one.values == pytest.approx(other.values, rel=1e-9)
    wider = set_value(model, "bars.N00N10.section.area", 2e-4)
    assert wider.bars["N00N10"].section.area == 2e-4
    assert wider.section.area == 1e-4
    assert wider.bars["N10N20"].section is None


def test_numbers_that_do_nothing_have_no_effect():
    model = redundant().with_(safety=kt.Safety(yielding=1.0, buckling=2.0))
    by = kt.gradient(
        kt.Response("energy", kt.statics.linear, model), ["safety.yielding", "material.poisson", "bars.N00N10.section.I2"]
    )
    assert (by.values == 0.0).all()


def test_the_utilisation_of_a_strut_by_its_section_and_load():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")}, section=kt.Rod(diameter=0.02),
        material="steel_s235", loads={"push": kt.NodalForce(node="B", force=(-500.0, 0))}, safety=kt.Safety(buckling=2.0),
    )  # fmt: skip
    wrt = ["bars.b.section.diameter", "loads.push.force.0", "nodes.B.at.0", "material.E", "safety.buckling"]
    value, by = kt.value_and_gradient(kt.Response("utilisation[b, buckling]", kt.statics.linear, model), wrt)
    euler = math.pi**2 * 210e9 * math.pi * 0.02**4 / 64 / 4.0
    assert value == pytest.approx(2.0 * 500.0 / euler, rel=1e-9)
    assert by.values == pytest.approx([-4 * value / 0.02, -value / 500, 2 * value / 2, -value / 210e9, value / 2], rel=1e-8)
    whole = kt.Response("max(utilisation)", kt.statics.linear, model)
    assert kt.check_gradient(whole, wrt[:4]).error < 1e-8


def test_supports_that_turn_are_read_from_records():
    # the force along a turned support is that of the load over its cosine; no array of the system has the angle of reactions
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"], section=GENERAL, material="steel_s235",
        supports={"B": kt.Support(y="held", turned=0.3)}, loads={"f": kt.NodalForce(node="B", force=(0.0, -100.0))},
    )  # fmt: skip
    value, by = kt.value_and_gradient(kt.Response("reaction[B, x]", kt.statics.linear, model), ["supports.B.turned"])
    assert value == pytest.approx(-100.0 * math.tan(0.3), rel=1e-9)
    assert by.item() == pytest.approx(-100.0 / math.cos(0.3) ** 2, rel=1e-8)


def test_a_frequency_by_its_stiffness_and_mass():
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
        bars={"rod": kt.Bar(ends=("O", "A"), mass=0, kind="elastic", stiffness=200.0)},
    )  # fmt: skip
    value, by = kt.value_and_gradient(
        kt.Response("frequency[1]", kt.flexible.frequencies, model), ["bars.rod.stiffness", "nodes.A.mass"]
    )
    assert value == pytest.approx(10.0 / (2 * math.pi), rel=1e-12)
    assert by.values == pytest.approx([value / 400.0, -value / 4.0], rel=1e-9)


def pendulum():
    """A mass on two equal springs at right angles: both frequencies are sqrt(k/m)/(2 pi)."""
    spring = {"kind": "elastic", "stiffness": 100.0, "mass": 0.0}
    return kt.Model(
        nodes={"A": (-1, 0), "B": (0, -1), "C": kt.Node(at=(0, 0), mass=4.0)}, fixed=["A", "B"],
        bars={"x": kt.Bar(ends=("A", "C"), **spring), "y": kt.Bar(ends=("B", "C"), **spring)},
    )  # fmt: skip


def test_repeated_frequencies_are_named_and_their_mean_has_a_gradient():
    model, wrt = pendulum(), ["bars.x.stiffness", "bars.y.stiffness", "nodes.C.mass"]
    with pytest.raises(AnalysisError, match=r"same of modes 1, 2"):
        kt.gradient(kt.Response("frequency[1]", kt.flexible.frequencies, model), wrt)
    f = 5.0 / (2 * math.pi)
    for text in ("mean(frequency)", "-ks(-frequency, 2*s)"):
        by = kt.gradient(kt.Response(text, kt.flexible.frequencies, model), wrt)
        assert by.values == pytest.approx([f / 400.0, f / 400.0, -f / 8.0], rel=1e-9)


def test_frequencies_of_redundant_members_that_loads_stiffen():
    model = redundant().with_(loads={"tip": kt.NodalForce(node="N20", force=(2e4, -3e4))})
    check = kt.check_gradient(
        kt.Response("frequency[2]", kt.flexible.frequencies, model),
        ["loads.tip.force.0", "bars.N00N10.section.area", "nodes.N11.at.0", "material.E", "gravity.1"],
    )
    assert check.error < 1e-7


def test_the_factor_of_a_column_by_its_spring_and_length():
    # two links of 1 m and a spring k at the hinge between: P = k a b/(a + b)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (0, 2), "W": (1, 1)}, fixed={"A": "xy", "C": "x", "W": "xy"},
        bars={"a": ("A", "B"), "b": ("B", "C"), "s": kt.Bar(ends=("B", "W"), kind="elastic", stiffness=10.0)},
        loads={"P": kt.NodalForce(node="C", force=(0, -1.0))},
    )  # fmt: skip
    factor = kt.Response("load_factor[1]", kt.statics.buckling, model, load="P")
    value, by = kt.value_and_gradient(factor, ["bars.s.stiffness", "loads.P.force.1", "nodes.C.at.1"])
    assert value == pytest.approx(5.0, rel=1e-9)
    assert by.values == pytest.approx([0.5, 5.0, 2.5], rel=1e-8)


def test_the_factor_of_a_stiff_tower():
    # what the load adds to the stiffness is 1e-5 of it
    nodes = {f"{row}{i}": (x, float(i)) for i in range(6) for row, x in (("l", 0.0), ("r", 1.0 - 0.02 * i))}
    pairs = [(f"{row}{i}", f"{row}{i + 1}") for i in range(5) for row in "lr"]
    pairs += [(f"{a}{i + j}", f"{b}{i + 1}") for i in range(5) for a, b, j in (("l", "r", 0), ("r", "l", 0), ("l", "r", 1))]
    model = kt.Model(
        nodes=nodes, fixed=["l0", "r0"], material="steel_s235", gravity=(0, -9.81),
        bars={a + b: kt.Bar(ends=(a, b), kind="elastic", section=kt.Rod(diameter=0.02)) for a, b in pairs},
        loads={"push": kt.NodalForce(node="l5", force=(0, -100.0))},
    )  # fmt: skip
    factor = kt.Response("load_factor[1]", kt.statics.buckling, model, load="push")
    assert kt.check_gradient(factor, [f"bars.{one}.section.diameter" for one in ("l0l1", "r4r5", "l2r3")], 1e-3).error < 1e-7


@pytest.mark.parametrize("analysis", [kt.statics.linear, kt.flexible.frequencies])
def test_what_is_known_of_other_models_changes_no_gradient(analysis):
    model, wrt = redundant(), ["bars.*.section.area", "nodes.N1?.at.0", "loads.tip.force.0"]
    text = "energy" if analysis is kt.statics.linear else "frequency[1]"
    chance = np.random.default_rng(5)
    for changes in (["nodes.N11.at.0"], ["loads.tip.force.0"], ["nodes.N10.at.0"], ["nodes.N11.at.1"], ["material.E"]):
        changes += [f"bars.{a}{b}.section.area" for a, b in PAIRS[:5]]
        was = {path: number_at(model, path, resolved(model, path)) for path in changes}
        model = kt.io.set_values(model, {path: one * chance.uniform(0.9, 1.1) for path, one in was.items()})
        known, alone = (kt.value_and_gradient(kt.Response(text, analysis, one), wrt) for one in (model, model.with_()))
        assert known[0] == pytest.approx(alone[0], rel=1e-12)
        assert known[1].values == pytest.approx(alone[1].values, rel=1e-9, abs=1e-12 * np.abs(alone[1].values).max())


def sagging():
    """A mass on two elastic bars."""
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(1, 0.0), mass=2.0), "C": (2, 0)}, fixed=["A", "C"], gravity=(0, -9.81),
        bars={n: kt.Bar(ends=e, kind="elastic", stiffness=1000.0, mass=0.0) for n, e in (("a", ("A", "B")), ("b", ("B", "C")))},
    )  # fmt: skip


def test_an_equilibrium_of_two_bars_and_its_energy():
    # 2 k (L - l) s/L = m g at the sag s; at fixed s dE = 0, so dE/dm = g ds m ... by the equation itself
    model = sagging()
    sag = kt.Response("-position[B, y]", kt.statics.equilibrium, model)
    value, by = kt.value_and_gradient(sag, ["nodes.B.mass", "bars.a.stiffness", "gravity.1"])
    L = math.hypot(1.0, value)
    stiff = 2000.0 * (1.0 - 1.0 / L + value**2 / L**3)
    assert 2000.0 * (L - 1.0) * value / L == pytest.approx(2.0 * 9.81, rel=1e-10)
    assert by.values == pytest.approx([9.81 / stiff, -(L - 1.0) * value / L / stiff, -2.0 / stiff], rel=1e-8)
    energy = kt.gradient(kt.Response("energy", kt.statics.equilibrium, model), "nodes.B.mass")
    assert energy.item() == pytest.approx(2.0 * 9.81 * by.values[0], rel=1e-8)


def test_states_without_a_gradient_are_refused():
    slack = redundant().with_(
        gravity=None, loads={}, bars=redundant().bars | {"c": kt.Bar(ends=("N00", "N22"), kind="cable", section=GENERAL)}
    )
    slack = slack.with_(loads={"tip": kt.NodalForce(node="N20", force=(0.0, 0.0))})
    with pytest.raises(AnalysisError, match="kink: c"):
        kt.gradient(kt.Response("displacement[N20, y]", kt.statics.linear, slack), "loads.tip.force.1")
    rolling = sagging().with_(bars={"a": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=1000.0)}, gravity=None)
    with pytest.raises(AnalysisError, match="without stiffness"):
        kt.gradient(kt.Response("position[B, y]", kt.statics.equilibrium, rolling), "bars.a.stiffness")
    with pytest.raises(AnalysisError, match="size of 0"):
        kt.gradient(kt.Response("size(displacement[N00])", kt.statics.linear, redundant()), "gravity.1")


@settings(max_examples=5, deadline=None, derandomize=True)
@given(st.lists(st.floats(-0.2, 0.2), min_size=18, max_size=18), st.lists(st.floats(0.5, 2.0), min_size=2, max_size=2))
def test_gradients_of_random_trusses_are_those_of_differences(moves, sizes):
    model = redundant()
    nodes = {name: tuple(np.add(GRID[name], moves[2 * k : 2 * k + 2])) for k, name in enumerate(GRID)}
    model = model.with_(nodes=nodes, loads={"tip": kt.NodalForce(node="N20", force=(100.0 * sizes[0], -1e3 * sizes[1]))})
    check = kt.check_gradient(
        kt.Response("pnorm(axial_stress/MPa, 6)", kt.statics.linear, model),
        ["nodes.N11.at.0", "nodes.N20.at.1", "bars.N00N10.section.area", "loads.tip.force.1", "gravity.1"],
    )
    assert check.error < 1e-7


def framed():
    """A clamped frame of beams, with a bar, a turned support that settles, and a spring."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0.2, 2), "C": (2, 2.1), "D": (2.1, 0.1)}, clamped=["A"], material="steel_s235",
        beams={"ab": ("A", "B"), "bc": ("B", "C"), "cd": ("C", "D")}, section=kt.Rectangle(width=0.05, height=0.08),
        supports={"D": kt.Support(y="held", turned=0.2)}, gravity=(0, -9.81), bars={"stay": kt.Bar(ends=("A", "C"))},
        springs={"s": kt.Spring(coordinate=kt.DistanceCoordinate(("B", "D")), stiffness=1e5)},
        loads={"f": kt.NodalForce(node="B", force=(3e3, -5e3)), "on": kt.NodalForce(node="A", force=(100.0, 200.0))},
    )  # fmt: skip


@pytest.mark.parametrize("analysis", [kt.statics.linear, kt.statics.equilibrium])
@pytest.mark.parametrize("model", [redundant(), framed(), sagging()], ids=["truss", "frame", "sagging"])
def test_responses_read_what_the_analysis_tells(analysis, model):
    if analysis is kt.statics.linear and len(model.nodes) == 3:
        model = model.with_(fixed={"A": "xy", "C": "xy", "B": "y"})  # flat, it sags only with large displacements
    told = analysis(model).data
    known = [name for name, one in told.data_vars.items() if one.dtype.kind == "f" and one.size and name not in LEFT_OUT]
    for name in known:
        size = float(np.abs(told[name].values).max(initial=0.0))
        for text, wanted in (
            (f"rms({name})", np.sqrt((told[name] ** 2).mean().item())),
            (f"max({name})", told[name].max().item()),
        ):
            found = kt.Response(text, analysis, model)
            assert found.value == pytest.approx(wanted, rel=1e-9, abs=1e-9 * size + 1e-12), (name, text)


def test_reactions_of_a_frame_and_a_number_that_makes_other_parts():
    pull = kt.Response("reaction[A, x]", kt.statics.linear, framed())
    assert kt.check_gradient(pull, ["supports.D.turned", "section.height", "nodes.B.at.0", "loads.on.force.0"]).error < 1e-8
    flat = framed().with_(supports={"D": kt.Support(y="held", turned=0.0)})
    with pytest.raises(InputError, match="turned is 0"):
        kt.gradient(kt.Response("energy", kt.statics.linear, flat), ["supports.D.turned", "gravity.1"])
