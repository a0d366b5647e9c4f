"""Limits of deflections in the verdict: closed forms of beams and trusses, load cases, and what is not checked."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.runs.quantity_limits import unchecked_rows

E, I, A, L, Q = 200e9, 2e-5, 4e-3, 6.0, 4e3
SECTION = kt.General(area=A, I2=1e-5, I3=I, c2=0.1, c3=0.1, J=1e-5)
STEEL = kt.Material(E=E, density=0.0, poisson=0.3)
SAG = 5 * Q * L**4 / (384 * E * I)
REST = {"rest": kt.Run(analysis="statics.linear")}


def girder(parts=1, angle=0.0, backwards=(), **more):
    """A girder on two supports, divided into beams, under a uniform load across it."""
    along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    nodes = {f"N{k}": tuple(L * k / parts * along) for k in range(parts + 1)}
    beams = {f"b{k}": (f"N{k + 1}", f"N{k}") if k in backwards else (f"N{k}", f"N{k + 1}") for k in range(parts)}
    last = {"fixed": {"N0": "xy", f"N{parts}": "y"}}
    if angle:
        ends = (f"N{parts}", "G")
        nodes["G"] = tuple(np.array(nodes[f"N{parts}"]) - 1000 * across)
        last = {
            "fixed": ["N0", "G"],
            "bars": {"stiff": kt.Bar(ends=ends, section=kt.General(area=1e9, I2=1, I3=1, c2=1, c3=1))},
        }
    loads = {name: kt.MemberLoad(member=name, force=tuple(-Q * across)) for name in beams}
    limit = {"girder": kt.DeflectionLimit(tuple(beams), "span/300")}
    given = {"section": SECTION, "material": STEEL, "loads": loads, "deflections": limit, "runs": REST} | last
    return kt.Model(**{"nodes": nodes, "beams": beams} | given | more)


def cantilever(**more):
    given = {"loads": {"P": kt.NodalForce(node="B", force=(0, -Q))}, "section": SECTION, "material": STEEL, "runs": REST}
    return kt.Model(nodes={"A": (0, 0), "B": (L, 0)}, clamped=["A"], beams={"arm": ("A", "B")}, **given | more)


@pytest.mark.parametrize("angle", [0.0, 0.6])
@pytest.mark.parametrize(("parts", "backwards"), [(1, ()), (2, ()), (3, (1,)), (3, (0, 2))])
def test_the_sag_of_a_girder_however_it_is_divided(angle, parts, backwards):
    run = kt.run(girder(parts, angle, backwards))
    (row,) = run.finding.quantities
    assert (row.part, row.rule, row.unit, row.status) == ("deflection of girder", "span/300", "m", "kept")
    assert row.utilisation == pytest.approx(SAG / (L / 300), rel=2e-8)
    assert row.limit == pytest.approx(L / 300, rel=1e-15)
    assert row.position == pytest.approx(L / 2, rel=1e-6)


def test_a_girder_on_springs_sags_as_much_and_is_displaced_more():
    soft = girder(2, fixed={}, supports={"N0": kt.Support(x="held", y=1e6), "N2": kt.Support(y=5e5)})
    both = {one: kt.DeflectionLimit(("b0", "b1"), "40 mm", measured_from=one) for one in ("ends", "start")}
    sag, whole = sorted(kt.run(soft.with_(deflections=both)).finding.quantities, key=lambda row: row.part)
    assert sag.value == pytest.approx(SAG, rel=1e-8)
    x = np.linspace(0.0, L, 100001)
    beam = Q * x * (L**3 - 2 * L * x**2 + x**3) / (24 * E * I)
    sinking = Q * L / 2 * ((1 - x / L) / 1e6 + x / L / 5e5)
    assert whole.value == pytest.approx((beam + sinking).max(), rel=1e-7)
    assert whole.position == pytest.approx(x[(beam + sinking).argmax()], abs=1e-2)


def test_a_cantilever_is_measured_from_its_start():
    limits = {
        "tip": kt.DeflectionLimit("arm", "span/150", measured_from="start"),
        "bow": kt.DeflectionLimit("arm", 0.02),
    }
    rows = {row.part: row for row in kt.run(cantilever(deflections=limits)).finding.quantities}
    tip, bow = rows["deflection of tip"], rows["deflection of bow"]
    assert tip.utilisation == pytest.approx(Q * L**3 / (3 * E * I) / (L / 150), rel=1e-10)
    assert (tip.status, tip.position, tip.station) == ("exceeded", L, 1.0)
    s = 1 - 1 / np.sqrt(3)  # of w(x) - x/L w(L), w = P (3 L x^2 - x^3)/(6 E I)
    assert bow.value == pytest.approx(Q * L**3 / (6 * E * I) * (2 * s - 3 * s**2 + s**3), rel=2e-6)  # a parabola at the top
    assert bow.position == pytest.approx(s * L, rel=1e-2)


def test_both_directions_across_a_girder_in_space_count():
    nodes = {"A": (0, 0, 0), "M": (2.0, 0, 0), "B": (L, 0, 0)}
    loads = {f"q{k}": kt.MemberLoad(member=name, force=(0, Q, -Q)) for k, name in enumerate(("a", "b"))}
    model = kt.Model(nodes=nodes, clamped=["A", "B"], beams={"a": ("A", "M"), "b": ("M", "B")}, section=SECTION,
                     material=STEEL, loads=loads, deflections={"g": kt.DeflectionLimit(("a", "b"), "10 mm")})  # fmt: skip
    (row,) = kt.strength.deflections(model, kt.statics.linear(model))
    assert row.value == pytest.approx(Q * L**4 / (384 * E) * np.hypot(1 / I, 1 / SECTION.I2), rel=1e-7)
    assert (row.member, row.position) == ("b", pytest.approx(L / 2, rel=1e-5))


def test_the_chord_of_a_truss_and_a_link_through_three_pins():
    truss = kt.Model(
        nodes={"A": (0, 0), "M": (3, 0), "B": (6, 0), "T": (3, 2)}, fixed={"A": "xy", "B": "y"},
        section=SECTION, material=STEEL,
        bars={"l": ("A", "M"), "r": ("M", "B"), "p": ("M", "T"), "a": ("A", "T"), "b": ("T", "B")},
        loads={"P": kt.NodalForce(node="M", force=(0, -1e5))}, runs=REST,
        deflections={"chord": kt.DeflectionLimit(("l", "r"), "span/500")},
    )  # fmt: skip
    (row,) = kt.run(truss).finding.quantities
    assert row.note == "bars count by their nodes, between which they stay straight"
    assert row.value == pytest.approx(-kt.statics.linear(truss).displacement.sel(node="M", axis="y").item(), rel=1e-12)
    link = girder(2, beams={}, links={"boom": ("N0", "N1", "N2")}, deflections={"boom": kt.DeflectionLimit("boom", "20 mm")},
                  loads={"q": kt.MemberLoad(member="boom", force=(0, -Q))})  # fmt: skip
    (row,) = kt.run(link).finding.quantities
    assert row.value == pytest.approx(SAG, rel=1e-8)


def test_an_equilibrium_has_nearly_the_deflection_of_small_displacements():
    light = {"runs": {"rest": kt.Run(analysis="statics.equilibrium")}}
    loads = {f"b{k}": kt.MemberLoad(member=f"b{k}", force=(0, -Q / 100)) for k in range(2)}
    (row,) = kt.run(girder(2, loads=loads, **light)).finding.quantities
    assert row.value == pytest.approx(SAG / 100, rel=1e-6)
    (row,) = kt.run(
        cantilever(deflections={"tip": kt.DeflectionLimit("arm", "1 m", measured_from="start")}, **light)
    ).finding.quantities
    assert row.value == pytest.approx(Q * L**3 / (3 * E * I), rel=1e-2)


def test_the_governing_combination_is_named_and_others_are_not_asked():
    cases = {"G": kt.LoadCase(loads={"b0": 1.0}, category="permanent"), "S": kt.LoadCase(loads={"b0": 0.5}, category="snow")}
    given = {
        "load_cases": cases,
        "combinations": {"uls": {"G": 1.35, "S": 1.5}, "sls": {"G": 1.0, "S": 1.0}, "rare": {"G": 1.0, "S": 0.5}},
        "deflections": {"girder": kt.DeflectionLimit("b0", "span/300", load_cases=("sls", "rare"))},
    }
    run = kt.run(girder(1, **given))
    assert [row.load_case for row in run.finding.quantities] == ["sls", "rare"]
    assert run.finding.quantities[0].utilisation == pytest.approx(1.5 * SAG / (L / 300), rel=1e-8)
    assert run.finding.over[0].place.endswith("%, sls")
    alone = girder(1, **given, runs={"rest": kt.Run(analysis="statics.linear", load_cases=("uls",))})
    (row,) = kt.run(alone).finding.quantities
    assert row.note == "not checked: none of its load cases is in this run"


def test_a_stored_run_says_the_same(tmp_path):
    made = kt.run(girder(2), out=tmp_path / "run")
    read = kt.runs.load(tmp_path / "run")
    assert read.finding.quantities[0].value == made.finding.quantities[0].value
    assert read.finding.quantities[0].text == made.finding.quantities[0].text
    (line,) = (one.split() for one in kt.report.summary(read).text.splitlines() if one.startswith("of girder"))
    assert line == ["of", "girder", "16.88", "mm", "span/300", "20", "mm", "84.4", "%", line[9], "3", "m", "kept"]


def test_another_configuration_is_refused():
    beam = girder()
    moved = kt.statics.linear(beam, kt.statics.equilibrium(beam))
    with pytest.raises(kt.InputError, match="another configuration"):
        kt.strength.deflections(beam, moved)


def test_not_known_is_not_checked_with_the_reason():
    rigid = girder(2).with_(
        beams={"b0": ("N0", "N1"), "b1": kt.Beam(ends=("N1", "N2"), kind="rigid")},
        loads={"P": kt.NodalForce(node="N1", force=(0, -Q))},
    )
    (row,) = kt.strength.deflections(rigid, kt.statics.linear(rigid))
    assert (row.status, row.note) == ("not checked", "not checked: b1 is rigid, or without section or material")
    crank = kt.read(kt.library.example_files()["four_bar"][0])
    moving = crank.with_(deflections={"c": kt.DeflectionLimit("coupler", "1 mm", measured_from="start")})
    run = kt.run(moving)
    assert [row.status for row in run.finding.quantities] == ["not checked"]
    assert "deflection of c not checked: deflections are known of a structure at rest" in run.finding.sentence
    assert run.finding.state == "open"
    (row,) = unchecked_rows(moving, "a mission has no histories")
    assert (row.part, row.status, row.note) == ("deflection of c", "not checked", "not checked: a mission has no histories")
    with pytest.raises(kt.InputError, match="has no deflections"):
        kt.strength.deflections(moving, run.motion)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"members": ("b0", "bx"), "limit": "span/300"}, "no member called 'bx'. Did you mean"),
        ({"members": ("b0.chord", "b1.chord"), "limit": "span/300"}, "no member called 'b0.chord'"),
        ({"members": ("b0", "b2"), "limit": "span/300"}, "b0, b2 are not in a row"),
        ({"members": ("b0", "b1", "b0"), "limit": "span/300"}, "not in a row"),
        ({"members": ("b2", "post"), "limit": "span/300"}, "do not lie on a straight line from 'N2' to 'G'"),
        ({"members": "post", "limit": "span/300"}, "'post' alone stays straight between its ends"),
        ({"members": (), "limit": "span/300"}, "members"),
        ({"members": "b0", "limit": "span/0"}, "0 must be greater than 0"),
        ({"members": "b0", "limit": "span/-300"}, "-300 must be greater than 0"),
        ({"members": "b0", "limit": "span*300"}, "no share of the span. Write for example span/300"),
        ({"members": "b0", "limit": 0}, "0 must be greater than 0"),
        ({"members": "b0", "limit": "-20 mm"}, "must be greater than 0"),
        ({"members": "b0", "limit": "20 kN"}, "length"),
        ({"members": "b0", "limit": "span/300", "measured_from": "tip"}, "measured_from"),
        ({"members": "b0", "limit": "span/300", "load_cases": ["sls"]}, "no load case called 'sls'"),
    ],
)
def test_what_is_no_limit_of_a_deflection(given, message):
    model = girder(3)
    more = {"nodes": {**model.nodes, "G": (L, -1.0)}, "bars": {"post": ("N3", "G")}}
    with pytest.raises(kt.ModelError, match=message.replace("(", r"\(").replace("*", r"\*")):
        model.with_(**more, deflections={"girder": given})


def test_it_is_written_and_read_back(tmp_path):
    model = girder(2, deflections={"g": kt.DeflectionLimit(("b0", "b1"), "span / 300"), "h": kt.DeflectionLimit("b0", "20 mm")})
    kt.write(model, tmp_path / "g.yaml")
    assert kt.read(tmp_path / "g.yaml") == model
    assert model.deflections["g"].limit == "span/300"
    assert model.deflections["h"].limit == 0.02
