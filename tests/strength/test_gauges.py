"""Strain gauges: closed forms, groups, zero, measured against simulated, faults."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.io import read_strains
from kinetruss.runs import gauge_strains

E, G = 70e9, 9.81
TUBE = kt.Tube(outer=0.03, inner=0.026)
ROSETTE = {f"G{k}": {"member": "bar", "angle": 2 * math.pi * k / 3, "factor": 2.1, "group": "mid"} for k in range(3)}


def beam(gauges=ROSETTE, mass=2.0, pull=100.0, section=TUBE, **changes):
    """A level bar on a pin and a roller, in the x-y plane of space, with a pull along it; gravity along -z."""
    fields = {
        "nodes": {"A": (0, 0, 0), "B": (2, 0, 0)}, "fixed": {"A": "xyz", "B": "yz"}, "gravity": (0, 0, -G),
        "bars": {"bar": kt.Bar(ends=("A", "B"), mass=mass)}, "section": section, "material": kt.Material(E=E, density=0),
        "loads": {"pull": kt.NodalForce(node="B", force=(pull, 0, 0))}, "gauges": gauges,
    }  # fmt: skip
    return kt.Model(**fields | changes)


def at_rest(model):
    still = np.zeros((1, len(model.nodes), model.dim))
    motion = kt.kinematics.from_arrays(model, [0.0], kt.kinematics.assemble(model)[None], still, still)
    return kt.dynamics.inverse(model, motion)


def read(model, **options):
    return kt.strength.gauges(model, at_rest(model), **options)


def group(strains, component):
    return strains["group_strain"].sel(component=component).isel(time=0, group=0).item()


def test_level_bar_in_closed_form():
    """Axial P/(E A); midspan moment m g L/8 puts +-M c/(E I) on the lowest and highest fibre (axis 2 points up)."""
    gauges = {name: {"member": "bar", "angle": f"{angle} deg"} for name, angle in (("top", 0), ("side", 90), ("low", 180))}
    found = read(beam(gauges))["strain"].isel(time=0)
    axial = 1e6 * 100 / (E * TUBE.area)
    bending = 1e6 * (2.0 * G * 2 / 8) * 0.015 / (E * TUBE.second_moments[0])
    assert found.values == pytest.approx([axial - bending, axial, axial + bending], rel=1e-12)


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(st.floats(0, 1), st.floats(-3, 3), st.lists(st.floats(0, 6.28), min_size=3, max_size=6, unique=True))
def test_groups_are_the_components_of_the_section(at, tilt, angles):
    """However many gauges stand anywhere around, their group gives T/(E A), M2 c/(E I) and M3 c/(E I) of that section."""
    turns = np.sort(np.array(angles))
    if np.min(np.diff([*turns, turns[0] + 2 * math.pi])) < 0.1:
        return
    gauges = {f"G{k}": {"member": "bar", "at": at, "angle": angle, "group": "g"} for k, angle in enumerate(angles)}
    model = beam(gauges, gravity=(0, G * math.sin(tilt), -G * math.cos(tilt)))
    strains = read(model)
    truth = kt.strength.components(model, kt.strength.sections(model, at_rest(model), [at])).isel(time=0, station=0, part=0)
    for component in ("axial", "bending_2", "bending_3"):
        assert group(strains, component) == pytest.approx(truth[f"{component}_microstrain"].item(), abs=1e-7)


def test_three_gauges_average_to_axial_strain():
    strains = read(beam())
    assert group(strains, "axial") == pytest.approx(strains["strain"].values.mean(), rel=1e-12)
    assert group(strains, "axial") == pytest.approx(1e6 * 100 / (E * TUBE.area), rel=1e-12)


def test_two_opposite_gauges_tell_axial_and_one_bending():
    gauges = {n: {"member": "bar", "angle": f"{a} deg", "group": "g"} for n, a in (("up", 0), ("down", 180))}
    strains = read(beam(gauges))
    assert group(strains, "axial") == pytest.approx(1e6 * 100 / (E * TUBE.area))
    assert abs(group(strains, "bending_3")) == pytest.approx(1e6 * 2 * G * 2 / 8 * 0.015 / (E * TUBE.second_moments[0]))
    assert math.isnan(group(strains, "bending_2"))


def test_bridge_is_the_divider_of_four_resistors():
    strains = read(beam())
    change = 2.1e-6 * strains["strain"].values
    divider = (1 + change) / (2 + change) - 0.5
    assert strains["bridge"].values == pytest.approx(divider, rel=1e-9)
    assert strains["bridge"].attrs["units"] == "V/V"


def test_rectangle_and_own_radius():
    flat = kt.Rectangle(height=0.04, width=0.01)  # height along axis 2
    gauges = {
        "edge": {"member": "bar", "angle": "180 deg"},
        "face": {"member": "bar", "angle": "90 deg"},
        "corner": {"member": "bar", "angle": math.pi - math.atan2(0.005, 0.02)},
        "inside": {"member": "bar", "angle": "180 deg", "radius": "10 mm"},
    }
    found = read(beam(gauges, section=flat, pull=0.0))["strain"].isel(time=0).values
    edge = 1e6 * (2.0 * G * 2 / 8) * 0.02 / (E * flat.second_moments[1])
    assert found == pytest.approx([edge, 0, edge, edge / 2], abs=1e-9)


def test_distance_and_fraction_are_one_place():
    gauges = {"a": {"member": "bar", "at": 0.25}, "b": {"member": "bar", "distance": "500 mm"}}
    found = read(beam(gauges))["strain"].isel(time=0).values
    assert found[0] == pytest.approx(found[1], rel=1e-12)


def test_planar_member():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, gravity=(0, -G), section=TUBE,
        bars={"bar": kt.Bar(ends=("A", "B"), mass=2.0)}, material=kt.Material(E=E, density=0),
        gauges={n: {"member": "bar", "angle": a, "group": "g"} for n, a in (("top", 0.0), ("low", math.pi))},
    )  # fmt: skip
    strains = read(model)
    bending = 1e6 * (2.0 * G * 2 / 8) * 0.015 / (E * TUBE.second_moments[0])
    assert strains["strain"].isel(time=0).values == pytest.approx([-bending, bending])
    assert list(strains["component"].values) == ["axial", "bending_3"]


@pytest.mark.parametrize("part", ["base", "tube"])
def test_rods_of_an_active_member(part):
    section = {"section": TUBE, "material": kt.Material(E=E, density=2700, poisson=0.3)}
    gauges = {f"G{k}": {"member": "M7", "part": part, "at": 0.3, "angle": k, "group": "g"} for k in range(3)}
    model = kt.library.vgt.double_octahedral(tip_force=(0, 0, 46), base_section=TUBE)
    active = {
        name: one.with_(base=one.base.with_(**section), tube=one.tube.with_(**section)) for name, one in model.active.items()
    }
    model = model.with_(active=active, gauges=gauges)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, kt.library.vgt.slew(beta=(0, 0.1)), times=[0.3]))
    strains = kt.strength.gauges(model, forces)
    truth = kt.strength.components(model, kt.strength.sections(model, forces, [0.3])).sel(part=f"M7.{part}")
    assert list(strains["part"].values) == [f"M7.{part}"] * 3
    for component in ("axial", "bending_2", "bending_3"):
        assert group(strains, component) == pytest.approx(truth[f"{component}_microstrain"].item(), rel=1e-9)


def hanging(**zero):
    model = kt.read(kt.library.example_files()["strain_gauges"][0])
    return model.with_(gauge_zero=zero or None)


def test_zero_at_a_pose_is_what_the_gauges_read_there():
    """Held upright, without load, everything reads zero; the load alone is what remains of it with load."""
    model = hanging(at={"bay.beta": "0 deg"})
    upright = kt.Quintic(moves={"bay.beta": (0.0, 0.0)}, duration=1)
    bare = model.with_(loads={})
    nothing = kt.strength.gauges(bare, kt.dynamics.inverse(bare, kt.kinematics.follow(bare, upright, times=[0.5])))
    assert nothing["strain"].values == pytest.approx(0, abs=1e-12)
    assert np.abs(nothing["zero"].values).min() > 0.1
    loaded = kt.dynamics.inverse(model, kt.kinematics.follow(model, upright, times=[0.5]))
    floating = model.with_(gravity=None, gauge_zero=None)
    weightless = kt.dynamics.inverse(floating, kt.kinematics.follow(floating, upright, times=[0.5]))
    found = kt.strength.gauges(model, loaded)["strain"].values
    assert found == pytest.approx(kt.strength.gauges(floating, weightless)["strain"].values, rel=1e-9)
    raw = kt.strength.gauges(model, loaded, zeroed=False)["strain"].values
    assert np.abs(raw - found).min() > 0.1


def test_zero_at_a_time_of_the_run():
    """At that time, at rest and without load; with the load case named it reads what the motion alone adds."""
    model = hanging(time=1.0).with_(load_cases={"loaded": kt.LoadCase()})
    named = model.with_(gauge_zero={"time": 1.0, "load_case": "loaded"})
    strains = gauge_strains(named, "experiment_1")
    at = int(np.abs(strains["time"].values - 1.0).argmin())
    assert strains["time"].values[at] == pytest.approx(1.0)  # the run is followed to that instant, too
    assert np.abs(strains["strain"].values[at]).max() < 0.05
    assert np.abs(gauge_strains(model, "experiment_1")["strain"].values[at]).min() > 1
    with pytest.raises(kt.InputError, match=r"gauge_zero\.time 9 s is outside the motion"):
        gauge_strains(hanging(time=9.0), "experiment_1")


def test_zero_of_the_model_as_it_stands():
    model = kt.read(kt.library.example_files()["strain_gauges"][0])
    stands = model.with_(gauge_zero={"load_case": None})
    assert gauge_strains(stands, "experiment_2")["zero"].values == pytest.approx(
        gauge_strains(model, "experiment_2")["zero"].values
    )


# -- measured against simulated ------------------------------------------------------------------------------------


def written(tmp_path, text):
    path = tmp_path / "measured.csv"
    path.write_text(text)
    return path


@pytest.fixture(scope="module")
def model():
    return kt.read(kt.library.example_files()["strain_gauges"][0])


def test_a_record_of_the_simulation_itself_agrees(tmp_path, model):
    """At times between the samples of the run, because the run is followed to them."""
    times = [0.01, 0.5, 2.22, 5.0]
    truth = gauge_strains(model, "experiment_1", measured=None)
    rows = "".join(f"{t},0,0\n" for t in times)
    blank = read_strains(written(tmp_path, f"t,G2,M6.bending_3\n{rows}"), model)
    strains = gauge_strains(model, "experiment_1", measured=blank)
    assert strains.sizes["time"] == truth.sizes["time"] + len(times)
    there = strains.sel(time=times)
    values = zip(
        times,
        there["strain"].sel(gauge="G2").values,
        there["group_strain"].sel(component="bending_3").values[:, 0],
        strict=True,
    )
    rows = "".join(f"{t},{a!r},{b!r}\n" for t, a, b in ((t, float(a), float(b)) for t, a, b in values))
    record = read_strains(written(tmp_path, f"t,G2 [microstrain],M6.bending_3 [microstrain]\n{rows}"), model)
    found = kt.strength.compare_gauges(strains, record)
    assert np.abs(found["difference"].values).max() < 1e-9
    assert found["correlation"].values == pytest.approx(1)
    between = kt.strength.compare_gauges(truth, record)  # a spline between the samples; 0.5 s is near a jump of acceleration
    assert np.abs(between["difference"].values).max() < 1e-2
    assert np.abs(between["difference"].values[2:]).max() < 1e-9


def test_offset_rms_and_correlation(tmp_path, model):
    strains = gauge_strains(model, "experiment_2")
    axial = strains["group_strain"].sel(group="M6", component="axial").values
    times = strains["time"].values
    wave = 0.1 * (-1.0) ** np.arange(len(times))
    rows = "".join(f"{t!r},{y!r},{-y!r}\n" for t, y in zip(times.tolist(), (axial + 0.5 + wave).tolist(), strict=True))
    text = rows.replace("--", "")
    record = read_strains(written(tmp_path, f"t,M6.axial [microstrain],G1 [microstrain]\n{text}"), model)
    found = kt.strength.compare_gauges(strains, record).sel(column="M6.axial")
    assert found["offset"].item() == pytest.approx(0.5, abs=2e-3)
    assert found["scatter"].item() == pytest.approx(0.1, rel=1e-3)
    assert found["rms"].item() == pytest.approx(math.hypot(found["offset"].item(), found["scatter"].item()))
    assert found["correlation"].item() == pytest.approx(np.corrcoef(axial, axial + wave)[0, 1])
    opposite = kt.strength.compare_gauges(strains, record).sel(column="G1")
    assert opposite["correlation"].item() < -0.9


def test_a_steady_record_has_no_correlation(tmp_path, model):
    record = read_strains(written(tmp_path, "t,G1\n0,1e-6\n1,1e-6\n2,1e-6\n"), model)
    found = kt.strength.compare_gauges(gauge_strains(model, "experiment_1"), record)
    assert math.isnan(found["correlation"].item())


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        (
            "t,M6.axail\n0,1e-6\n1,1e-6\n",
            "1:3",
            r"column 'M6\.axail' is not a gauge or group of the model\. Did you mean 'M6\.axial'",
        ),
        ("t,G1\n0,5.3\n1,5.4\n", "2:1", r"holds a strain of 5\.3 m/m\. Give the unit in the header: G1 \[microstrain\]"),
        ("t,G1 [mm]\n0,5.3\n1,5.4\n", "1:3", r"has the unit \[mm\], which is not a unit of strain"),
        ("t,G1\n1,1e-6\n0,2e-6\n", "3:1", "time does not increase"),
        ("t\n0\n1\n", "1:1", "has no column but t"),
        ("t,G1\n0,\n1,2e-6\n", "2:3", "the cell is empty"),
    ],
)
def test_faulty_records(tmp_path, model, text, place, said):
    path = written(tmp_path, text)
    with pytest.raises(kt.ModelError, match=said) as caught:
        read_strains(path, model)
    assert f"{path}:{place}: measured: " in str(caught.value)


def test_times_outside_the_run(tmp_path, model):
    path = written(tmp_path, "# measured\nt,G1\n0,1e-6\n6,1e-6\n7,1e-6\n8,1e-6\n")
    record = read_strains(path, model)
    said = r":5:1: measured: t = 7 s and 1 more rows are outside the run, 0 s to 6\.431 s\. Start the record's clock"
    with pytest.raises(kt.ModelError, match=said):
        gauge_strains(model, "experiment_1", measured=record)
    with pytest.raises(kt.ModelError, match=said):
        kt.strength.compare_gauges(gauge_strains(model, "experiment_1"), record)


# -- faults of the model -------------------------------------------------------------------------------------------

M7 = {"member": "M7", "angle": 0.0}


@pytest.mark.parametrize(
    ("gauges", "said"),
    [
        ({"G": {"member": "M66"}}, r"gauges\.G\.member: no member called 'M66'\. Did you mean 'M6'"),
        ({"G": {"member": "M7"}}, "sits on the active member 'M7', which has two rods. Say part: base, or part: tube."),
        ({"G": {"member": "M7", "part": "base"}}, r"sits on 'M7\.base', which has no section and no material\. Give"),
        ({"G": {"member": "M6", "part": "tube"}}, "is given, but 'M6' is a bar. Remove it."),
        ({"G": {"member": "M6", "at": 1.5}}, "must be at most 1|1.5"),
        ({"G": {"member": "M6", "radius": "1 m"}}, r"gauges\.G\.radius: 1 m is not in the section of 'M6'\. Give"),
        ({"G": {"member": "M6", "radius": "1 um"}}, r"is not in the section of 'M6'\. Give .* m to .* m"),
        ({"G": {"member": "M6", "at": 0.5, "distance": "1 mm"}}, "has both at and distance"),
        ({"G": {"member": "M6", "distance": "1 m"}}, r"1 m is beyond 'M6', which is 0\.9017 m long"),
        ({"G": {"member": "M6", "distance": "-1 mm"}}, "must not be negative"),
        ({"G": {"member": "M6", "factor": 0}}, "greater than 0"),
        ({"G": {"member": "M6", "angle": "3 mm"}}, "is not an angle"),
        ({"G": {"member": "M6", "group": "g"}}, r"group 'g': axial strain cannot be distinguished from bending with gauges at"),
        ({"G": {"member": "M6", "group": "g"}, "H": {"member": "M6", "angle": 1, "group": "g"}}, "Add gauges: two opposite"),
        ({"G": {"member": "M6", "group": "g"}, "H": {"member": "M5", "angle": math.pi, "group": "g"}}, "sits at another place"),
    ],
)  # fmt: skip
def test_faulty_gauges(model, gauges, said):
    with pytest.raises(kt.ModelError, match=said):
        model.with_(gauges=gauges)


def test_the_bars_of_a_beam_have_no_strain():
    """The chord shows a beam and carries nothing: a gauge on it read 0 whatever the beam did."""
    for name in ("b.chord", "B.B-B.d1"):
        with pytest.raises(kt.ModelError, match="only holds or shows a beam or a body: it has no strain. Put it on a bar"):
            kt.Model(
                nodes={"A": (0, 0), "B": (1, 0)},
                clamped=["A"],
                beams={"b": ("A", "B")},
                section=kt.Rod(diameter=0.02),
                material="steel_s235",
                gauges={"G": kt.Gauge(member=name, factor=2.0)},
            )


@pytest.mark.parametrize(
    ("zero", "said"),
    [
        ({"at": {"bay.bta": 0.0}}, r"no drive or pose coordinate called 'bay\.bta'\. Did you mean 'bay\.beta'"),
        ({"at": {"bay.beta": "3 mm"}}, r"is given as a length, but 'bay\.beta' is an angle"),
        ({"load_case": "empty"}, "no load case called 'empty'"),
        ({"at": {"bay.beta": 0.0}, "time": 1.0}, "has both at and time"),
    ],
)
def test_faulty_zero(model, zero, said):
    with pytest.raises(kt.ModelError, match=said):
        model.with_(gauge_zero=zero)


def test_other_faults(model):
    with pytest.raises(kt.InputError, match="The model has no gauges"):
        read(beam(gauges={}))
    with pytest.raises(kt.ModelError, match="sits on a general section, whose surface is not known"):
        beam({"G": {"member": "bar"}}, section=kt.General(area=1e-4, I2=1e-8, I3=1e-8, c2=0.01, c3=0.01))
    with pytest.raises(kt.ModelError, match="is given on 'bar', whose length changes"):
        beam({"G": {"member": "bar", "distance": 0.1}}, bars={"bar": {"ends": ("A", "B"), "kind": "driven"}})
    with pytest.raises(kt.InputError, match="lie on one line"):
        faces = {f"G{k}": {"member": "bar", "angle": a, "group": "g"} for k, a in enumerate((1.5, 1.57, 1.65))}
        read(beam(faces, section=kt.Rectangle(height=0.04, width=0.01)))
