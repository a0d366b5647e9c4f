"""Temperature of gauges: thermal strain, compensating gauges, conditions, zero, and records in volts, by closed form."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError, ModelError

ALPHA, MATCHED, WARM, FACTOR, LOAD = 23e-6, 11e-6, 40.0, 2.1, 1e3
METAL = kt.Material(E=70e9, density=0.0, thermal_expansion=ALPHA)
THERMAL = (ALPHA - MATCHED) * WARM
KINDS = {
    "quarter": 1,
    "half_bending": 0,
    "half_axial": 0,
    "half_opposite": 1,
    "half_dummy": 0,
    "full_bending": 0,
    "full_axial": 0,
}
"""Kind -> how much of a thermal strain a linear bridge reads, as a share of that of a quarter bridge for equal sensitivity."""
READ = {"half_axial": 1 / 1.3, "full_axial": 1 / 1.3}


def hanger(**more):
    """A rod under its load, with gauges of several kinds: strain P/(E A) of each."""
    bridge = {"excitation": 5.0, "gain": 100.0}
    gauges = {
        "free": kt.Gauge(member="rod", factor=FACTOR),
        "matched": kt.Gauge(member="rod", factor=FACTOR, matched_expansion=ALPHA),
        "other": kt.Gauge(member="rod", factor=FACTOR, matched_expansion=MATCHED),
        "dummy": kt.Gauge(
            member="rod", factor=FACTOR, matched_expansion=MATCHED, bridge=kt.Bridge(kind="half_dummy", **bridge)
        ),
        "volts": kt.Gauge(member="rod", factor=FACTOR, matched_expansion=MATCHED, bridge=kt.Bridge(**bridge)),
    }
    return kt.Model(
        nodes={"A": (0, 0), "B": (1.0, 0)}, fixed={"A": "xy", "B": "y"}, bars={"rod": kt.Bar(ends=("A", "B"))},
        section=kt.Rod(diameter=0.01), material=METAL, loads={"pull": kt.NodalForce(node="B", force=(LOAD, 0))},
        gauges=gauges, **more,
    )  # fmt: skip


def strained(model):
    return LOAD / (METAL.E * model.section.area)


def test_a_gauge_reads_strain_and_what_the_expansions_differ_by():
    model = hanger()
    warm = kt.under(model, kt.Condition(temperature=WARM))
    read = 1e-6 * kt.strength.gauges(warm, kt.runs.forces_at_rest(warm)).strain[0]
    e = strained(model)
    for name, more in {"free": 0, "matched": 0, "other": THERMAL, "volts": THERMAL}.items():
        assert read.sel(gauge=name).item() == pytest.approx(e + more, rel=1e-12), name
    # (1 + x + t)/(2 + x + 2 t) of the arms with the dummy is what (1 + x')/(2 + x') gives with x' = x/(1 + t)
    assert read.sel(gauge="dummy").item() == pytest.approx(e / (1 + FACTOR * THERMAL), rel=1e-12)
    cold = 1e-6 * kt.strength.gauges(model, kt.runs.forces_at_rest(model)).strain[0]
    assert cold.values == pytest.approx(np.full(5, e), rel=1e-12)


def test_each_member_has_its_own_temperature_and_a_gauge_its_own_besides():
    model = hanger()
    own = model.with_(gauges={"other": model.gauges["other"].with_(temperature=5.0)})
    for condition, warm in (
        (kt.Condition(temperature=WARM), WARM + 5),
        (kt.Condition(temperature=WARM, temperatures={"rod": 10}), 15),
        (kt.Condition(), 5),
    ):
        under = kt.under(own, condition)
        read = 1e-6 * kt.strength.gauges(under, kt.runs.forces_at_rest(under)).strain.item()
        assert read == pytest.approx(strained(model) + (ALPHA - MATCHED) * warm, rel=1e-12)


def test_a_gauge_without_compensation():
    """Its resistance changes by (a_R + k (alpha - alpha of the grid)) T: matched to alpha of the grid - a_R/k."""
    a_R, grid = 20e-6, 15e-6
    model = hanger().with_(gauges={"G": kt.Gauge(member="rod", factor=FACTOR, matched_expansion=grid - a_R / FACTOR)})
    warm = kt.under(model, kt.Condition(temperature=WARM))
    data = kt.strength.gauges(warm, kt.runs.forces_at_rest(warm))
    change = FACTOR * strained(model) + (a_R + FACTOR * (ALPHA - grid)) * WARM
    assert data.bridge.item() == pytest.approx(change / (4 + 2 * change), rel=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_bridges_are_dividers_of_warm_resistors(kind):
    """Exact by Kirchhoff; linear: the thermal strain adds up or cancels."""
    bridge, e, t = kt.Bridge(kind=kind, excitation=5.0), 3e-3, -2e-3
    nu = bridge.poisson
    strains = {
        "quarter": (e, None, None, None), "half_bending": (e, -e, None, None), "half_axial": (e, -nu * e, None, None),
        "half_opposite": (e, None, e, None), "half_dummy": (e, 0.0, None, None), "full_bending": (e, -e, e, -e),
        "full_axial": (e, -nu * e, e, -nu * e),
    }[kind]  # fmt: skip
    R1, R2, R3, R4 = (120.0 if one is None else 120.0 * (1 + FACTOR * (one + t)) for one in strains)
    output = R1 / (R1 + R2) - R4 / (R3 + R4)
    assert kt.strength.bridge_output(e, bridge, FACTOR, t).item() == pytest.approx(output, rel=1e-12)
    # the strain that such a reading stands for is what measured records in volts become
    read = kt.strength.bridge_reading(e, t, bridge, FACTOR).item()
    assert kt.strength.bridge_strain([5.0 * output], bridge, FACTOR)[0] == pytest.approx(read, rel=1e-12)
    assert kt.strength.bridge_output(read, bridge, FACTOR).item() == pytest.approx(output, rel=1e-10)
    assert kt.strength.bridge_reading(e, t, bridge.with_(linear=True), FACTOR).item() == pytest.approx(e + KINDS[kind] * t)
    assert kt.strength.bridge_reading(0.0, t, bridge, FACTOR).item() == pytest.approx(KINDS[kind] * t, rel=5e-3, abs=1e-15)


def test_bending_of_a_group_keeps_free_of_the_temperature():
    """Three gauges around a warm level tube: axial strain has all of it."""
    turns = {f"G{k}": 120 * k for k in range(3)}
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (2.0, 0, 0)}, fixed={"A": "xyz", "B": "yz"}, bars={"tube": ("A", "B")},
        section=kt.Tube(outer=0.02, inner=0.016), material=METAL.with_(density=2700.0), gravity=(0, 0, -9.81),
        gauges={name: kt.Gauge(member="tube", angle=f"{turn} deg", group="g", matched_expansion=MATCHED)
                for name, turn in turns.items()},
    )  # fmt: skip
    warm = kt.under(model, kt.Condition(temperature=WARM))
    cold_read, read = (kt.strength.gauges(one, kt.runs.forces_at_rest(one)).group_strain[0, 0] for one in (model, warm))
    share = 1 + ALPHA * WARM  # m g L: the mass stays
    assert read.sel(component="axial").item() == pytest.approx(1e6 * THERMAL, rel=1e-9)
    for component in ("bending_2", "bending_3"):
        bent = cold_read.sel(component=component).item()
        assert read.sel(component=component).item() == pytest.approx(bent * share, rel=1e-9, abs=1e-9)


def test_stress_of_a_warm_bar_between_walls_is_not_taken_off_by_the_zero():
    """-E alpha T of the elastic bar, and what the gauge reads of the temperature, from a zero without it."""
    bar = kt.Bar(ends=("A", "B"), kind="elastic")
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1.0, 0)}, fixed=["A", "B"], bars={"bar": bar}, section=kt.Rod(diameter=0.01), material=METAL,
        gauges={"G": kt.Gauge(member="bar", matched_expansion=MATCHED)}, gauge_zero=kt.GaugeZero(),
        conditions={"hot": kt.Condition(temperature=WARM)},
        runs={"rest": kt.Run(analysis="statics.equilibrium", condition="hot")},
    )  # fmt: skip
    wanted = -ALPHA * WARM / (1 + ALPHA * WARM) + THERMAL
    read = kt.runs.gauge_strains(model, "rest").strain.values.ravel()
    assert 1e-6 * read == pytest.approx(np.full(len(read), wanted), rel=1e-9)
    warm = kt.under(model, "hot")
    forces = kt.statics.equilibrium(warm)
    with pytest.raises(InputError, match="zero_of=model"):
        kt.strength.gauges(warm, kt.runs.forces_at_rest(warm))
    assert forces.member_force.item() == pytest.approx((wanted - THERMAL) * METAL.E * model.section.area, rel=1e-9)


def test_a_measured_record_in_volts_of_a_warm_run(tmp_path):
    """Readings of the warm resistors become the simulated strain of the run under its temperature; without it, they do not."""
    arm = kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1.0, 0), mass=3.0)}, fixed=["O"], bars={"arm": ("O", "P")},
        drives={"turn": kt.AngleDrive("arm")},
        section=kt.Rod(diameter=0.008), material=METAL, gravity=(0, -9.81),
        gauges={"G": kt.Gauge(member="arm", factor=FACTOR, matched_expansion=MATCHED,
                              bridge=kt.Bridge(excitation=5.0, gain=1e3))},
        gauge_zero=kt.GaugeZero(at={"turn": 0.0}), conditions={"hot": kt.Condition(temperature=WARM)},
        trajectories={"up": kt.Quintic(moves={"turn": (0.0, 1.5)}, duration=1.0)},
        runs={name: kt.Run(trajectory="up", samples=21, condition=under) for name, under in (("cold", None), ("warm", "hot"))},
    )  # fmt: skip
    plain = 1e-6 * kt.runs.gauge_strains(arm, "cold").strain.values[:, 0]
    R = 120.0 * (1 + FACTOR * (plain + THERMAL))
    volts = 5.0 * 1e3 * (R / (R + 120.0) - 0.5)
    file = tmp_path / "record.csv"
    times = np.linspace(0, 1, 21)
    file.write_text("t [s],G [V]\n" + "".join(f"{t!r},{v!r}\n" for t, v in zip(times.tolist(), volts.tolist(), strict=True)))
    record = kt.strength.measured_strains(arm, file)
    for run, left in (("warm", 0.0), ("cold", 1e6 * THERMAL)):
        found = kt.strength.compare_gauges(kt.runs.gauge_strains(arm, run, measured=record), record)
        # the arm is longer by 9e-4 when warm
        assert found.offset.item() == pytest.approx(left, abs=1e-2 * np.ptp(1e6 * plain))
        assert found.scatter.item() < 2e-3 * np.ptp(1e6 * plain)


def test_a_zero_in_the_run_has_the_temperature_too():
    model = hanger(gauge_zero=kt.GaugeZero(time=0.0))
    warm = kt.under(model, kt.Condition(temperature=WARM))
    found = kt.strength.gauges(warm, kt.runs.forces_at_rest(warm))
    assert found.zero.sel(gauge="other").item() == pytest.approx(1e6 * THERMAL, rel=1e-9)
    assert 1e-6 * found.strain.sel(gauge="other").item() == pytest.approx(strained(model), rel=1e-9)


def test_faults():
    model = hanger()
    cold = model.with_(material=METAL.with_(thermal_expansion=None))
    with pytest.raises(ModelError, match=r"gauges\.other.*has no thermal expansion"):
        cold.with_(gauges={"other": model.gauges["other"].with_(temperature=5.0)})
    with pytest.raises(ModelError, match="no coefficient of expansion"):
        kt.Gauge(member="rod", matched_expansion=11.0)
    with pytest.raises(InputError, match="What gauge 'other' reads of a temperature is not in a budget"):
        kt.runs.budget(model, of=["other.strain"], tolerances={"temperature": 5.0})
