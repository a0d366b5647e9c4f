"""The verdict: envelopes, governing places and cases, what is missing, and rows."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.results import Status
from kinetruss.strength import Options, check, critical_load, euler_load, sections, stresses, table, utilisation

G = 9.81
TUBE = kt.Tube(outer=0.0254, inner=0.022225)
SECOND, A, c = TUBE.second_moments[0], TUBE.area, 0.0127
ALUMINIUM = kt.Material(E=71e9, density=2711.5, yield_strength=240e6, poisson=0.33)
SAFETY = kt.Safety(yielding=1.5, buckling=2.0)


def beam(push=0.0, **changes):
    """A bar on a pin and a roller, 2 m, 3 kg, pushed along its axis."""
    fields = {
        "nodes": {"A": (0, 0), "B": (2.0, 0)}, "fixed": {"A": "xy", "B": "y"}, "gravity": (0.0, -G), "section": TUBE,
        "material": ALUMINIUM, "bars": {"beam": kt.Bar(ends=("A", "B"), mass=3.0)}, "safety": SAFETY,
        "loads": {"push": kt.NodalForce(node="B", force=(-push, 0.0))},
    }  # fmt: skip
    return kt.Model(**fields | changes)


def at_rest(model, load_case=None, samples=2):
    x = np.array([node.at for node in model.nodes.values()])
    still = np.zeros((samples, *x.shape))
    motion = kt.kinematics.from_arrays(model, np.arange(samples, dtype=float), still + x, still, still)
    return kt.dynamics.inverse(model, motion, load_case)


def row(verdict, part, rule):
    (found,) = [r for r in verdict.table() if (r.part, r.rule) == (part, rule)]
    return found


def test_beam_column_by_hand():
    P = 300.0
    verdict = check(beam(P), at_rest(beam(P)))
    M = 3.0 * G * 2.0 / 8
    bent = row(verdict, "beam", "yield")
    assert bent.value == pytest.approx(P / A + M * c / SECOND)
    assert (bent.limit, bent.unit) == (160e6, "Pa")
    assert (bent.station, bent.position) == (pytest.approx(0.5, abs=1e-6), pytest.approx(1.0, abs=1e-6))
    buckled = row(verdict, "beam", "buckling")
    Pe = euler_load(71e9, SECOND, 2.0)
    assert (buckled.value, buckled.limit) == (pytest.approx(P), pytest.approx(float(Pe) / 2))
    assert buckled.note == "Euler"
    both = row(verdict, "beam", "beam-column")
    expected = P / (Pe / 2) + M / ((1 - 2 * P / Pe) * 160e6 * SECOND / c)
    assert both.utilisation == pytest.approx(float(expected), rel=1e-9)
    assert both.margin == pytest.approx(1 / float(expected) - 1)
    assert [r.utilisation for r in verdict.table()] == sorted((r.utilisation for r in verdict.table()), reverse=True)


def test_moment_factor_scales_the_bending_term():
    model = beam(300.0)
    forces = at_rest(model)
    one, less = (row(check(model, forces, moment_factor=f), "beam", "beam-column").utilisation for f in (1.0, 0.6))
    axial = row(check(model, forces), "beam", "buckling").utilisation
    assert less - axial == pytest.approx(0.6 * (one - axial))


def test_beyond_the_euler_load_no_moment_can_be_carried():
    model = beam(3000.0)
    both = row(check(model, at_rest(model)), "beam", "beam-column")
    assert both.utilisation == math.inf
    assert both.margin == -1.0


def test_a_member_always_in_tension_has_no_compression():
    model = beam(-500.0)
    verdict = check(model, at_rest(model))
    buckled = row(verdict, "beam", "buckling")
    assert (buckled.value, buckled.utilisation, buckled.margin) == (0.0, 0.0, math.inf)
    assert buckled.note == "never in compression"
    assert row(verdict, "beam", "beam-column").utilisation == 0.0


def test_compression_is_the_largest_along_the_member():
    # a standing bar: its own weight presses on its foot only
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1.0)}, fixed={"A": "xy", "B": "x"}, gravity=(0, -G), section=TUBE, material=ALUMINIUM,
        bars={"post": kt.Bar(ends=("A", "B"), mass=4.0)},
    )  # fmt: skip
    buckled = row(check(model, at_rest(model)), "post", "buckling")
    assert buckled.value == pytest.approx(4.0 * G)
    assert buckled.position == pytest.approx(0.0)


def test_stocky_members_buckle_by_johnson():
    stocky = beam(
        300.0, nodes={"A": (0, 0), "B": (0.1, 0)}, bars={"beam": kt.Bar(ends=("A", "B"), mass=0.1, buckling="clamped-clamped")}
    )
    buckled = row(check(stocky, at_rest(stocky)), "beam", "buckling")
    assert buckled.note == "Johnson"
    assert buckled.limit == pytest.approx(float(critical_load(71e9, SECOND, A, 0.1, 240e6, "clamped-clamped")) / 2)


def test_the_weaker_axis_of_a_rectangle_buckles():
    flat = kt.Rectangle(width=0.02, height=0.005)
    model = beam(3.0, section=flat)
    assert row(check(model, at_rest(model)), "beam", "buckling").limit == pytest.approx(
        float(euler_load(71e9, 0.02 * 0.005**3 / 12, 2.0)) / 2
    )


def test_load_cases_are_enveloped_and_named():
    loads = {"push": kt.NodalForce(node="B", force=(-1.0, 0.0))}
    cases = {
        "calm": kt.LoadCase(loads={"push": 100.0}),
        "storm": kt.LoadCase(loads={"push": 400.0}),
        "rest": kt.LoadCase(loads={}),
    }
    model = beam(loads=loads, load_cases=cases)
    forces = {name: at_rest(model, name) for name in cases}
    verdict = check(model, forces)
    assert row(verdict, "beam", "buckling").value == pytest.approx(400.0)
    assert row(verdict, "beam", "buckling").load_case == "storm"
    listed = check(model, list(forces.values()))
    assert [r.load_case for r in listed.table()] == [r.load_case for r in verdict.table()]
    renamed = check(model, {"first": forces["storm"], "second": forces["calm"]})
    assert row(renamed, "beam", "yield").load_case == "first"
    with pytest.raises(InputError, match="no forces to check"):
        check(model, [])


def test_what_is_missing_is_said_not_dropped():
    model = beam(300.0, section=None)
    rows = check(model, at_rest(model)).table()
    assert [(r.part, r.rule, r.note, r.checked) for r in rows] == [("beam", "yield", "not checked: no section", False)]
    model = beam(300.0, material=None)
    rows = check(model, at_rest(model)).table()
    assert [(r.part, r.rule, r.note, r.checked) for r in rows] == [("beam", "yield", "not checked: no material", False)]
    assert rows[0].value > 0
    model = beam(300.0, material=ALUMINIUM.with_(yield_strength=None))
    verdict = check(model, at_rest(model))
    assert row(verdict, "beam", "yield").note == "not checked: no yield strength"
    assert row(verdict, "beam", "yield").value > 0
    assert row(verdict, "beam", "buckling").note == "Euler; no yield strength for Johnson"


def tripod(base_section=True, **changes):
    """Three active legs lifting a mass."""
    tube = {"section": TUBE, "material": ALUMINIUM}
    rod = {"section": kt.Rod(diameter=0.012), "material": ALUMINIUM} if base_section else {"mass": 0.5}
    leg = {"base": kt.Part(length=0.7, **rod), "tube": kt.Part(length=0.5, **tube)}
    feet = {"A": (0.5, 0, 0), "B": (-0.25, 0.433, 0), "C": (-0.25, -0.433, 0)}
    fields = {
        "nodes": feet | {"T": kt.Node(at=(0, 0, 0.9), mass=20.0)}, "fixed": list(feet), "gravity": (0, 0, -G),
        "active": {f"L{foot}": kt.Active(ends=(foot, "T"), **leg) for foot in feet},
    }  # fmt: skip
    return kt.Model(**fields | changes)


def lifted(model):
    trajectory = kt.Quintic(moves={"LA": (1.0296, 1.12), "LB": (1.0296, 1.08), "LC": (1.0296, 1.15)}, duration=0.8)
    return kt.dynamics.inverse(model, kt.kinematics.follow(model, trajectory, samples=21))


@pytest.fixture(scope="module")
def lift():
    model = tripod()
    return model, lifted(model)


def test_rods_of_an_active_member_yield_and_its_whole_buckles(lift):
    model, forces = lift
    verdict = check(model, forces)
    assert list(verdict.data["part"].values[:3]) == ["LA", "LA.base", "LA.tube"]
    assert {(r.part, r.rule) for r in verdict.table() if r.member == "LA"} == {
        ("LA", "buckling"), ("LA", "beam-column"), ("LA.base", "yield"), ("LA.tube", "yield"),
    }  # fmt: skip
    leg = row(verdict, "LA", "buckling")
    at = int(np.argmin(np.abs(forces.data["time"].values - leg.time)))
    length = float(forces.motion.length.sel(member="LA")[at])
    rod = kt.Rod(diameter=0.012)
    weaker = critical_load(71e9, rod.second_moments[0], rod.area, length, 240e6)
    assert leg.limit == pytest.approx(float(weaker))
    stiff = row(check(model, forces, active_section="tube"), "LA", "buckling")
    at = int(np.argmin(np.abs(forces.data["time"].values - stiff.time)))
    assert stiff.limit == pytest.approx(
        float(critical_load(71e9, SECOND, A, float(forces.motion.length.sel(member="LA")[at]), 240e6))
    )


def test_a_base_without_section_leaves_the_tube_and_says_so():
    model = tripod(base_section=False)
    verdict = check(model, lifted(model))
    assert row(verdict, "LA", "buckling").note == "Euler; base has no section, so with the tube's section"
    assert row(verdict, "LA.base", "yield").note == "not checked: no section"
    rows = check(model, lifted(model), active_section="base").table()
    assert {r.note for r in rows if (r.part, r.rule) == ("LA", "buckling")} == {"not checked: no section"}


def test_envelopes_agree_with_dense_sampling(lift):
    model, forces = lift
    verdict, dense = check(model, forces), sections(model, forces, 401)
    worst = stresses(model, dense).von_mises
    for part in dense.data["part"].values:
        found = row(verdict, part, "yield")
        sampled = float(worst.sel(part=part).max())
        assert sampled * (1 - 1e-12) <= found.value <= sampled * (1 + 1e-3)
        at = np.unravel_index(np.argmax(worst.sel(part=part).values), worst.shape[:1] + worst.shape[2:])
        assert found.time == pytest.approx(float(dense.data["time"][at[0]]))
        assert found.station == pytest.approx(float(dense.data["station"][at[1]]), abs=3e-3)
    rod = kt.Rod(diameter=0.012)
    for leg in model.active:
        P = -dense.section_T.sel(part=[f"{leg}.base", f"{leg}.tube"]).min(("part", "station")).values
        # a leg is weakest where it is longest, which need not be where it carries most
        limit = critical_load(71e9, rod.second_moments[0], rod.area, forces.motion.length.sel(member=leg).values, 240e6)
        found = row(verdict, leg, "buckling")
        assert found.utilisation == pytest.approx((P / limit).max(), rel=1e-9)
        assert found.value == pytest.approx(P[np.argmax(P / limit)], rel=1e-9)


def test_verdict_is_the_worst_of_the_histories(lift):
    model, forces = lift
    history = utilisation(model, forces)
    assert history["utilisation"].dims == ("time", "part", "rule")
    verdict = check(model, forces)
    assert np.allclose(history["utilisation"].max("time"), verdict.utilisation, equal_nan=True)
    halves = [forces.with_(data=forces.data.isel(time=s), motion=forces.motion.with_(data=forces.motion.data.isel(time=s)))
              for s in (slice(0, 8), slice(8, None))]  # fmt: skip
    assert np.allclose(check(model, halves).utilisation, verdict.utilisation, equal_nan=True)
    assert np.allclose(check(model, halves).time_of, verdict.time_of, equal_nan=True)


def test_safety_factors_scale_limits(lift):
    model, forces = lift
    safe = model.with_(safety=SAFETY)
    one, two = check(model, forces), check(safe, forces)
    ratio = (two.limit / one.limit).sel(part="LA.tube", rule="yield")
    assert float(ratio) == pytest.approx(1 / 1.5)
    assert float((two.limit / one.limit).sel(part="LA", rule="buckling")) == pytest.approx(1 / 2.0)


def test_status_of_the_forces_is_passed_on(lift):
    model, forces = lift
    stopped = forces.with_(status=Status.SINGULAR, message="stopped at .4 s")
    verdict = check(model, [forces, stopped])
    assert (verdict.status, verdict.message) == (Status.SINGULAR, "stopped at .4 s")
    assert check(model, forces).status is Status.COMPLETED


def test_a_motion_without_samples_is_refused(lift):
    model, forces = lift
    none = forces.with_(
        data=forces.data.isel(time=slice(0, 0)), motion=forces.motion.with_(data=forces.motion.data.isel(time=slice(0, 0)))
    )
    with pytest.raises(InputError, match="The motion has no sample"):
        check(model, none)


def test_text_table(lift):
    model, forces = lift
    lines = table(check(model, forces), rows=3).splitlines()
    assert lines[0].split()[:3] == ["part", "rule", "value"]
    assert len(lines) == 4


def test_options_are_checked():
    with pytest.raises(InputError, match="active_section 'screw'"):
        Options(active_section="screw")
    with pytest.raises(InputError, match="moment_factor"):
        Options(moment_factor=0.0)


def test_numbers_are_named_and_have_units(lift):
    verdict = check(*lift)
    assert all({"units", "long_name"} <= set(v.attrs) for v in verdict.data.data_vars.values())
    assert list(verdict.data["unit"].values) == ["Pa", "N", ""]
    assert verdict.provenance["load_cases"] == ["all"]
