"""Optima for missions: limits in all runs, limits of motors, multiples, values set, parts of catalogues at the end."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt

USED = {"utilisation": {"of": "utilisation", "at_most": 1}}
DENSITY, DENSITY_6082 = 2711.5, 2700.0


def bracket():
    """Two bars from walls 1 m apart in height to a node that is pushed sideways."""
    return kt.Model(
        nodes={"A": (-0.4, 1), "B": (0.4, 1), "C": (0, 0)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")},
        section=kt.General(area=1e-3, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), material="steel_s235",
        loads={"push": kt.NodalForce(node="C", force=(7e3, 0))},
    )  # fmt: skip


def test_what_is_symmetric_is_one_variable():
    """Bars at x = +-h have the least volume: H (x^2 + h^2)/(s x), with the areas H sqrt(x^2 + h^2)/(2 s x)."""
    found = kt.design.optimise(
        bracket(),
        {
            "x": {"of": "nodes.B.at.0", "multiples": {"nodes.A.at.0": -1}, "between": (0.2, 3.0)},
            "area": {"of": "section.area", "between": ("10 mm^2", "20 cm^2"), "scale": "log"},
        },
        "mass",
        {"stress": {"of": "axial_stress", "at_most": "100 MPa", "at_least": "-100 MPa"}},
        arguments={"weight": False},
    )
    assert found.values["x"] == pytest.approx(1, rel=1e-4)
    assert found.values["area"] == pytest.approx(7e3 / math.sqrt(2) / 1e8, rel=1e-4)
    assert found.model.nodes["A"].at[0] == -found.values["x"]
    density = bracket().material_of(bracket().bars["a"]).density
    assert found.objective == pytest.approx(density * 2 * 7e3 / 1e8, rel=1e-7)
    assert found.certificate.first_order


def test_a_search_comes_back_from_members_beyond_their_buckling_load():
    """A strut under its own weight: the diameter at which its beam-column reaches 1, by bisection; on the way it is inf."""
    strut = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")}, material="steel_s235",
        section=kt.Tube(outer=0.06, inner=0.048), loads={"push": kt.NodalForce(node="B", force=(-7e3, 0))}, gravity=(0, -9.81),
        safety=kt.Safety(buckling=2), runs={"rest": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    tube = {"of": "section.outer", "multiples": {"section.inner": 0.8}, "between": ("5 mm", "80 mm"), "scale": "log"}
    found = kt.design.optimise(strut, {"d": tube}, "mass", USED)

    def used_at(d):
        model = kt.io.set_values(strut, {"section.outer": d, "section.inner": 0.8 * d})
        return float(np.nanmax(kt.run(model).verdict.utilisation.values))

    assert used_at(0.02) == np.inf
    low, high = 0.02, 0.06
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if used_at(middle) > 1 else (low, middle)
    assert found.values["d"] == pytest.approx(high, rel=1e-6)
    assert found.certificate.first_order
    with pytest.raises(kt.errors.AnalysisError, match="infinite near the start"):
        kt.design.optimise(strut, {"d": {**tube, "start": "8 mm"}}, "mass", USED)


def lifting():
    """The triangular truss with a drive, lifted quickly and slowly, and two load cases."""
    truss = kt.library.vgt.triangular(
        payload_mass=10.0, base_section=kt.Rod(diameter=0.0254),
        material=kt.Material(E=71e9, density=DENSITY, yield_strength=240e6, poisson=0.33),
    )  # fmt: skip
    runs = {
        name: kt.Run(trajectory=kt.Quintic(moves={"actuator": (2.5, 2.9)}, duration=duration), samples=21)
        for name, duration in (("slow", 16.0), ("fast", 8.0))
    }
    return truss.with_(
        runs=runs, loads={"push": kt.NodalForce(node="B", force=(0, -50.0))},
        load_cases={"empty": kt.LoadCase(loads={}), "pushed": kt.LoadCase(loads={"push": 1.0})},
    )  # fmt: skip


def mission(**more):
    return kt.Mission(
        runs=["slow", "fast"], load_cases=["empty", "pushed"], groups={"follower": ["follower"]},
        catalogues={"tubes": "aluminium_tubes_metric"}, safety=kt.Safety(yielding=2, buckling=3), **more,
    )  # fmt: skip


def used(model, run, case):
    """Largest utilisation of members, from an analysis of its own."""
    motion = kt.kinematics.follow(model, model.runs[run].trajectory, samples=21)
    verdict = kt.strength.check(model, kt.dynamics.inverse(model, motion, case, static=False))
    return float(np.nanmax(verdict.utilisation))


TUBE = {"tube": {"of": "bars.follower.section.outer", "multiples": {"bars.follower.section.inner": 0.9},
                 "between": ("16 mm", "40 mm"), "scale": "log"}}  # fmt: skip
OWN = {"bars.follower.section": {"kind": "tube", "outer": "25 mm", "inner": "22.5 mm"}}


def test_limits_hold_in_all_runs_and_load_cases_of_a_mission():
    """Kept everywhere and reached in the worst, with its safety factors; the tube of the list is the next one, and kept too."""
    found = kt.design.optimise(lifting(), TUBE, "mass", USED, mission=mission(), set=OWN)
    assert found.certificate.first_order
    assert found.model.safety == kt.Safety(yielding=2, buckling=3)
    reached = {(run, case): used(found.model, run, case) for run in ("slow", "fast") for case in ("empty", "pushed")}
    assert reached["fast", "pushed"] == max(reached.values()) == pytest.approx(1, abs=1e-6)
    assert found.active[0].name.startswith("utilisation.fast of pushed follower")
    listed = found.listed
    (row,) = listed.sizing.groups
    assert listed.excess <= 0
    assert used(listed.sizing.model, "fast", "pushed") <= 1
    before, after = (model.section_of(model.bars["follower"]) for model in (found.model, listed.sizing.model))
    more = 2.0 * (DENSITY_6082 * after.area - DENSITY * before.area)  # the follower is 2 m long
    assert listed.objective - found.objective == pytest.approx(more, rel=1e-6)
    assert row.tube in found.text
    assert "All limits of the task are kept" in found.text


def test_parts_of_catalogues_that_exceed_a_limit_are_told():
    limits = {**USED, "mass": {"of": "mass", "at_most": "13.45 kg"}}
    found = kt.design.optimise(lifting(), TUBE, "mass", limits, mission=mission(), set=OWN)
    assert found.objective < 13.45 < found.listed.objective
    assert found.listed.excess == pytest.approx(found.listed.objective / 13.45 - 1, rel=1e-6)
    assert "But mass." in found.text


def test_values_are_set_before_the_search(tmp_path):
    """Those of the library model of a file, too, and of a model that was read from it."""
    file = tmp_path / "bay.yaml"
    file.write_text("kinetruss: 1\nlibrary: {name: vgt.triangular, payload_mass: 10 kg}\n")
    task = kt.OptimumTask(
        model=str(file), set={"library.payload_mass": "20 kg", "nodes.B.at": "[2 m, 1.5 m]"},
        variables={"x": {"of": "nodes.B.at.0", "between": (1.5, 3.0)}}, least="mass",
    )  # fmt: skip
    from kinetruss.design.optimal_design import model_for

    for given in (str(file), kt.read(file)):
        model = model_for(task, given)
        assert (model.nodes["B"].mass, model.nodes["B"].at) == (20.0, (2.0, 1.5))


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"analysis": "kinematics.follow"}, "analysis: is given by the runs of the mission"),
        ({"arguments": {"run": "slow"}}, "arguments: is given by the runs"),
        ({"load_cases": ["empty"]}, "load_cases: are those of the mission"),
        ({"mission": mission().with_(runs=["lift"])}, "no run called 'lift'"),
        ({"mission": mission().with_(groups={"g": ["beam"]})}, "no member fits 'beam'"),
    ],
)
def test_what_a_mission_says_is_not_said_twice(more, said):
    with pytest.raises(kt.errors.ModelError) as error:
        kt.design.optimise(lifting(), TUBE, "mass", USED, **{"mission": mission(), **more})
    assert said in str(error.value)
