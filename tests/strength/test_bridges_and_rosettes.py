"""Bridges, shunts, rosettes, shear gauges and repeated records, against closed forms."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.io import read_strains
from kinetruss.strength import bridge_output, bridge_strain, measured_strains, rosette, shunt_strain

E, NU = 70e9, 0.3
TUBE = kt.Tube(outer=0.03, inner=0.0295)
KINDS = ["quarter", "half_bending", "half_axial", "half_opposite", "full_bending", "full_axial"]


@given(st.sampled_from(KINDS), st.floats(-0.01, 0.01), st.floats(1.5, 3), st.booleans(), st.sampled_from([0.0, 0.4, 5.0]))
def test_strain_of_the_output_is_the_strain(kind, strain, factor, linear, lead):
    bridge = kt.Bridge(kind=kind, excitation=5, gain=200, linear=linear, resistance=120, lead=lead)
    volts = 5 * 200 * bridge_output(strain, bridge, factor)
    assert float(bridge_strain(volts, bridge, factor)) == pytest.approx(strain, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize(("kind", "output"), [
    ("quarter", lambda x, nu: x / (4 + 2 * x)),
    ("half_bending", lambda x, nu: x / 2),
    ("half_axial", lambda x, nu: x * (1 + nu) / (4 + 2 * x * (1 - nu))),
    ("half_opposite", lambda x, nu: x / (2 + x)),
    ("full_bending", lambda x, nu: x),
    ("full_axial", lambda x, nu: x * (1 + nu) / (2 + x * (1 - nu))),
])  # fmt: skip
def test_outputs_are_the_known_formulas(kind, output):
    bridge = kt.Bridge(kind=kind, excitation=5)
    for strain in (-2e-3, 1e-5, 4e-3):
        assert float(bridge_output(strain, bridge, 2.0)) == pytest.approx(output(2 * strain, 0.3), rel=1e-12)


def test_a_shunt_is_the_divider_of_its_resistors():
    """A resistor across the gauge changes the arm to R Rs/(R + Rs); the bridge reads the strain that it stands for."""
    R, Rs, k = 120.0, 59880.0, 2.0
    arm = R * Rs / (R + Rs)
    volts = 5 * (arm / (arm + R) - 0.5)
    assert shunt_strain(R, Rs, k) == pytest.approx(-0.001, rel=1e-12)  # -120/(2 x 60,000)
    assert float(bridge_strain(volts, kt.Bridge(excitation=5), k)) == pytest.approx(-0.001, rel=1e-9)


@pytest.mark.parametrize("wrong", [1.07, -0.9])
@pytest.mark.parametrize("linear", [True, False])
@pytest.mark.parametrize("kind", KINDS)
def test_a_shunt_across_one_arm_mends_gain_and_sign(kind, linear, wrong):
    """The divider of the shunted arm and an equal one, or its linear part: the other arms rest while it is on."""
    true = kt.Bridge(kind=kind, excitation=5, gain=100, resistance=350, linear=linear)
    arm = 350 * 100e3 / (350 + 100e3)
    output = (arm / 350 - 1) / 4 if linear else arm / (arm + 350) - 0.5
    bridge = true.with_(shunt=100e3, shunt_reading=5 * 100 * wrong * output)
    volts = 5 * 100 * wrong * bridge_output([2e-3, -3e-4], true, 2.1)
    np.testing.assert_allclose(bridge_strain(volts, bridge, 2.1), [2e-3, -3e-4], rtol=1e-11)


def test_drift_and_offset_are_taken_off():
    bridge = kt.Bridge(excitation=5, zero=1e-3, zero_end=3e-3)
    t = np.array([0.0, 1.0, 4.0])
    volts = 5 * bridge_output(1e-4, bridge, 2.0) + 1e-3 + 2e-3 * t / 4
    np.testing.assert_allclose(bridge_strain(volts, bridge, 2.0, t), 1e-4, rtol=1e-10)
    with pytest.raises(kt.InputError, match="times"):
        bridge_strain(volts, bridge, 2.0)


@given(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-3, 3), st.floats(0, 0.05))
def test_principal_strains_do_not_turn_with_the_rosette(x, y, shear, turn, transverse):
    def read(a):
        across = x * np.sin(a) ** 2 + y * np.cos(a) ** 2 - shear * np.sin(a) * np.cos(a)
        along = x * np.cos(a) ** 2 + y * np.sin(a) ** 2 + shear * np.sin(a) * np.cos(a)
        return (along + transverse * across) / (1 - 0.285 * transverse)

    circle = np.array([(x + y) / 2 + s * math.hypot(x - y, shear) / 2 for s in (1, -1)])
    for angles in (
        np.radians([0, 45, 90]),
        np.radians([0, 60, 120]),
        np.radians([0, 36, 72, 108, 144]),
        np.radians([10, 70, 95]),
    ):
        found = rosette(read(angles + turn), angles + turn, transverse=transverse)
        np.testing.assert_allclose(found.principal, circle, atol=1e-8)
        assert found.x == pytest.approx(x, abs=1e-8)
        own = rosette(read(angles + turn), angles, transverse=transverse)  # seen from the rosette itself
        np.testing.assert_allclose(own.principal, circle, atol=1e-8)
        if math.hypot(x - y, shear) > 1:
            assert math.sin(2 * (own.angle + turn - found.angle)) == pytest.approx(0, abs=1e-7)


def test_rosette_of_a_bar_in_tension_has_its_uniaxial_stress():
    """Principal stresses P/A and 0 from gauges at any angles on a bar of the model (T105)."""
    turns = [20, 65, 110]
    gauges = {f"R{k}": {"member": "bar", "direction": f"{a} deg"} for k, a in enumerate(turns)}
    strains = kt.strength.gauges(cantilever(gauges, pull=500.0, push=0.0), forces(gauges, pull=500.0, push=0.0))
    material = kt.Material(E=E, density=0, poisson=NU)
    found = rosette(strains.strain.values[0], np.radians(turns), material=material)
    np.testing.assert_allclose(found.stress, [500 / TUBE.area, 0], atol=1e-4)
    assert float(found.von_mises) == pytest.approx(500 / TUBE.area)
    assert abs(float(found.angle)) < 1e-9


def cantilever(gauges, pull=0.0, push=30.0):
    """A bar on pin and roller with forces across it at a third: shear 2/3 F before, and moment."""
    return kt.Model(
        nodes={"A": (0, 0, 0), "B": (3, 0, 0)}, fixed={"A": "xyz", "B": "yz"}, gravity=(0, 0, -9.81),
        bars={"bar": kt.Bar(ends=("A", "B"), mass=push)}, section=TUBE, material=kt.Material(E=E, density=0, poisson=NU),
        loads={"pull": kt.NodalForce(node="B", force=(pull, 0, 0))}, gauges=gauges,
    )  # fmt: skip


def forces(gauges, **loads):
    model = cantilever(gauges, **loads)
    still = np.zeros((1, 2, 3))
    motion = kt.kinematics.from_arrays(model, [0.0], kt.kinematics.assemble(model)[None], still, still)
    return kt.dynamics.inverse(model, motion)


@pytest.mark.parametrize("section", [TUBE, kt.Rectangle(width=0.01, height=0.03)])
@pytest.mark.parametrize("at", [0.1, 0.25])
def test_gauges_measure_all_forces_of_a_section(section, at):
    """T, M2, M3, V2, V3 from eight gauges equal the section forces; shear by pairs at +-45 degrees on the neutral axes."""
    around = {f"A{k}": {"member": "bar", "at": at, "angle": f"{90 * k} deg", "group": "g"} for k in range(4)}
    pairs = {
        f"S{k}{sign}": {"member": "bar", "at": at, "angle": f"{90 * k} deg", "direction": f"{sign}45 deg", "group": "g"}
        for k in (0, 1) for sign in ("+", "-")
    }  # fmt: skip
    gauges = around | pairs
    model = cantilever(gauges, pull=200.0).with_(section=section, gravity=(0, 3.0, -9.81))
    still = np.zeros((1, 2, 3))
    motion = kt.kinematics.from_arrays(model, [0.0], kt.kinematics.assemble(model)[None], still, still)
    found = kt.dynamics.inverse(model, motion)
    got = kt.strength.gauges(model, found).group_force.sel(group="g").isel(time=0)
    truth = kt.strength.sections(model, found, [at]).data.isel(time=0, part=0, station=0)
    wanted = [truth.section_T.item(), *truth.section_M.values, *truth.section_V.values]
    np.testing.assert_allclose(got.values, wanted, rtol=1e-9, atol=1e-9)
    assert abs(wanted[-1]) > 10  # there is shear to be measured


def test_shear_strain_of_a_thin_tube():
    """At the neutral axis gamma = 2 V/(A G), read as its half by each gauge of a pair at +-45 degrees."""
    gauges = {s: {"member": "bar", "at": 0.1, "angle": "0 deg", "direction": f"{s}45 deg"} for s in ("+", "-")}
    found = forces(gauges)
    got = kt.strength.gauges(cantilever(gauges), found).strain.values[0]
    V = kt.strength.sections(cantilever(gauges), found, [0.1]).data.section_V.values[0, 0, 0, 1]
    factor = TUBE.shear_factor
    gamma = 1e6 * factor * abs(V) / TUBE.area / (E / (2 * (1 + NU)))
    assert abs(got[0] - got[1]) == pytest.approx(gamma, rel=1e-9)
    assert factor == pytest.approx(2, rel=1e-3)


def write(path, head, rows):
    np.savetxt(path, rows, delimiter=",", header=head, comments="")
    return path


MODEL = cantilever(
    {"G1": {"member": "bar", "factor": 2.1, "bridge": {"excitation": "5 V", "gain": 100}}, "G2": {"member": "bar"}}
)


def test_repeated_readings_are_means_with_standard_errors(tmp_path):
    rng = np.random.default_rng(0)
    t = np.repeat([0.0, 1.0, 2.0], 100)
    y = 10 * t + rng.standard_normal(300)
    record = read_strains(write(tmp_path / "r.csv", "t,G1 [microstrain]", np.column_stack([t, y])), MODEL)
    np.testing.assert_allclose(record.times, [0, 1, 2])
    for k in range(3):
        part = y[100 * k : 100 * (k + 1)]
        assert record.columns["G1"][k] == pytest.approx(part.mean())
        assert record.errors["G1"][k] == pytest.approx(part.std(ddof=1) / 10)


def test_volts_become_strain(tmp_path):
    volts = 500 * bridge_output([1e-4, 2e-4], MODEL.gauges["G1"].bridge, 2.1)
    path = write(tmp_path / "v.csv", "t,G1 [mV]", np.column_stack([[0, 1], 1e3 * volts]))
    np.testing.assert_allclose(measured_strains(MODEL, path).columns["G1"], [100, 200], rtol=1e-9)
    other = write(tmp_path / "w.csv", "t,G2 [mV]", np.column_stack([[0, 1], [1, 2]]))
    with pytest.raises(kt.ModelError, match="G2.*no bridge.*bridge: {kind: quarter"):
        measured_strains(MODEL, other)


def test_repeated_records_are_averaged(tmp_path):
    t = np.linspace(0, 1, 11)
    paths = [write(tmp_path / f"{k}.csv", "t,G1 [microstrain]", np.column_stack([t, 5 * t + k])) for k in range(3)]
    mean = measured_strains(MODEL, paths)
    np.testing.assert_allclose(mean.columns["G1"], 5 * t + 1)
    np.testing.assert_allclose(mean.errors["G1"], 1 / math.sqrt(3))
    odd = write(tmp_path / "odd.csv", "t,G2 [microstrain]", np.column_stack([t, t]))
    with pytest.raises(kt.InputError, match="other columns"):
        measured_strains(MODEL, [paths[0], odd])


@pytest.mark.slow
def test_comparison_finds_scale_offset_and_lag():
    file, *_ = kt.library.example_files()["strain_gauges"]
    model = kt.read(file)
    strains = kt.runs.gauge_strains(model, "experiment_2")
    t = np.linspace(1, 8.5, 60)
    from scipy.interpolate import make_interp_spline

    curve = make_interp_spline(strains.time.values, strains.group_strain.values[:, 0, 0], k=3)
    history = kt.io.StrainHistory(times=t, columns={"M6.axial": 0.9 * curve(t - 0.2) + 0.4}, source="x", lines=tuple(range(60)))
    found = kt.strength.compare_gauges(strains, history).sel(column="M6.axial")
    assert found["shift"].item() == pytest.approx(0.2, abs=1e-3)
    straight = kt.strength.compare_gauges(
        strains, kt.io.StrainHistory(times=t, columns={"M6.axial": 0.9 * curve(t) + 0.4}, source="x", lines=tuple(range(60)))
    ).sel(column="M6.axial")  # fmt: skip
    assert straight["scale"].item() == pytest.approx(0.9, rel=1e-6)
    assert straight["correlation"].item() == pytest.approx(1)


@pytest.mark.parametrize(("fields", "said"), [
    ({"shunt": 1e5}, "Give both"),
    ({"lead": 2}, "no resistance"),
    ({"kind": "third"}, "kind"),
    ({"shunt": 1e5, "shunt_reading": 0.0, "resistance": 120}, "did nothing"),
])  # fmt: skip
def test_faulty_bridges(fields, said):
    with pytest.raises(kt.ModelError, match=said):
        kt.Bridge(**{"excitation": 5} | fields)


def test_directions_that_do_not_determine_the_strain():
    with pytest.raises(kt.InputError, match="three different directions"):
        rosette([1, 2, 3], np.radians([0, 180, 45]))
    with pytest.raises(kt.InputError, match="expected"):
        rosette([1, 2], np.radians([0, 60, 120]))


def test_a_direction_without_a_known_surface_is_a_fault():
    gauge = {"member": "bar", "direction": "45 deg", "radius": "5 mm"}
    with pytest.raises(kt.ModelError, match="not known"):
        cantilever({"G": gauge})
