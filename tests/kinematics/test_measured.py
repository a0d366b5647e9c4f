"""Measured records: noise, outliers, rates and accelerations with standard errors, against motions that are known."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.io import read_measured
from kinetruss.kinematics.measured_motions import outlying

NOISE = 5e-5


def tones(t, *waves):
    """Value, rate and acceleration (rows, 3) of a sum of sines (amplitude m, rad/s)."""
    parts = [np.stack([a * np.sin(w * t), a * w * np.cos(w * t), -a * w * w * np.sin(w * t)], axis=1) for a, w in waves]
    return sum(parts) + np.array([1.1, 0.0, 0.0])


def smoothed(t, y, **options):
    return kt.kinematics.measured(kt.Measured(times=t, values={"M7": y}, **options))


def uneven(rng, n, end=5.5):
    return np.sort(np.concatenate([[0.0, end], rng.uniform(0, end, n - 2)]))


@pytest.mark.slow
@pytest.mark.parametrize("even", [True, False])
@pytest.mark.parametrize(("rows", "waves"), [(60, [(0.05, 1.3)]), (150, [(0.05, 1.3), (0.004, 5.0)])])
def test_standard_errors_cover_the_truth_in_95_percent_and_noise_is_found(even, rows, waves):
    rng = np.random.default_rng(rows + even)
    inside, scores = [], []
    for _ in range(16):
        t = np.linspace(0, 5.5, rows) if even else uneven(rng, rows)
        truth = tones(t, *waves)
        got = smoothed(t, truth[:, 0] + NOISE * rng.standard_normal(rows), largest_gap=1e9)
        words = ("value", "rate", "acceleration")
        off = [np.abs(got.data[word].values[:, 0] - truth[:, k]) for k, word in enumerate(words)]
        inside.append(
            [(one < 1.96 * got.data[f"{word}_error"].values[:, 0]).mean() for one, word in zip(off, words, strict=True)]
        )
        scores.append((got.noise.item() - NOISE) / got.noise_error.item())
    value, rate, acceleration = np.mean(inside, axis=0)
    assert 0.93 < value < 0.98
    assert rate > 0.94  # on the safe side for derivatives
    assert acceleration > 0.94
    assert abs(np.mean(scores)) < 0.7
    assert 0.5 < np.std(scores) < 1.5  # three deviations of 16 draws


@pytest.mark.slow
def test_errors_of_a_filter_of_one_length_in_time_fall_with_the_root_of_the_rows():
    got = []
    for rows, window in ((201, 61), (801, 241)):
        t = np.linspace(0, 5.5, rows)
        y = tones(t, (0.05, 1.3))[:, 0] + NOISE * np.random.default_rng(3).standard_normal(rows)
        one = smoothed(t, y, smoothing="savitzky_golay", window=window)
        got.append(float(one.acceleration_error.values[rows // 2, 0] / one.noise.item()))
    assert got[0] / got[1] == pytest.approx(2, rel=0.03)


@pytest.mark.slow
def test_savitzky_golay_covers_within_its_window():
    rng, t = np.random.default_rng(5), np.linspace(0, 5.5, 221)
    truth, inside = tones(t, (0.05, 1.3)), []
    for _ in range(16):
        got = smoothed(t, truth[:, 0] + NOISE * rng.standard_normal(221), smoothing="savitzky_golay", window=41)
        inside.append((np.abs(got.acceleration.values[:, 0] - truth[:, 2]) < 1.96 * got.acceleration_error.values[:, 0]).mean())
    assert 0.93 < np.mean(inside) < 0.97


@pytest.mark.slow
def test_savitzky_golay_is_that_of_scipy():
    from scipy.signal import savgol_filter

    t = np.linspace(0, 2, 60)
    y = np.random.default_rng(0).standard_normal(60) * 1e-3 + 1
    got = smoothed(t, y, smoothing="savitzky_golay", window=15)
    for order, word in enumerate(("value", "rate", "acceleration")):
        wanted = savgol_filter(y, 15, 5, deriv=order, delta=t[1])
        np.testing.assert_allclose(got.data[word].values[:, 0], wanted, rtol=1e-8, atol=1e-9 * np.abs(wanted).max())


@pytest.mark.slow
def test_outliers_nine_rows_apart_are_found_where_they_are():
    """Of 200 records with one to three outliers of 30 to 60 standard deviations, at most one is not told in full."""
    t, missed, extra = np.linspace(0, 5.5, 120), 0, 0
    for seed in range(200):
        rng = np.random.default_rng(seed)
        places = {4 + 13 * int(k) for k in rng.choice(9, rng.integers(1, 4), replace=False)}
        y = tones(t, (0.05, 1.3))[:, 0] + NOISE * rng.standard_normal(120)
        for k in places:
            y[k] += rng.choice([-1, 1]) * rng.uniform(30, 60) * NOISE
        found = set(np.flatnonzero(outlying(t, y)).tolist())
        missed, extra = missed + (not places <= found), extra + len(found - places)
    assert missed <= 1
    assert extra <= 3


@pytest.mark.slow
@pytest.mark.parametrize("replace", [False, True])
def test_outliers_are_replaced_only_if_asked(replace):
    t = np.linspace(0, 5.5, 120)
    truth = tones(t, (0.05, 1.3))[:, 0]
    y = truth + NOISE * np.random.default_rng(8).standard_normal(120)
    y[[30, 70]] += 50 * NOISE
    got = smoothed(t, y, outliers="replace" if replace else "keep")
    assert [(name, round(when / t[1])) for name, when, _ in got.outliers()] == [("M7", 30), ("M7", 70)]
    assert ("They are replaced" in got.message) == replace
    if replace:
        assert np.abs(got.value.values[[30, 70], 0] - truth[[30, 70]]).max() < 3 * NOISE
        assert got.noise.item() == pytest.approx(NOISE, rel=0.3)


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(st.integers(40, 200), st.floats(0.5, 3.0), st.floats(0, 6.28))
def test_a_record_without_noise_is_its_own_curve_and_has_no_outliers(rows, rate, phase):
    t = np.linspace(0, 3, rows)
    y = 1 + 0.1 * np.sin(rate * t + phase)
    got = smoothed(t, y)
    assert not got.outliers()
    assert np.abs(got.value.values[:, 0] - y).max() < 1e-7
    assert got.noise.item() < 1e-6


@pytest.mark.slow
def test_false_outliers_are_rare():
    rng, t = np.random.default_rng(11), np.linspace(0, 5.5, 200)
    count = sum(outlying(t, 1 + NOISE * rng.standard_normal(200)).sum() for _ in range(25))
    assert count <= 3  # of 5000 readings


def test_given_rates_and_accelerations_are_used_as_given():
    t = np.linspace(0, 5.5, 56)
    truth = tones(t, (0.05, 1.3))
    record = kt.Measured(times=t, values={"M7": truth[:, 0]}, rates={"M7": truth[:, 1]}, accelerations={"M7": truth[:, 2]})
    assert kt.kinematics.measured(record).message == ""
    model = kt.Model(nodes={"A": (0, 0), "B": (1.1, 0)}, fixed=["A"], bars={"M7": {"ends": ("A", "B"), "kind": "driven"}},
                     drives={"turn": kt.AngleDrive("M7")})  # fmt: skip
    motion = kt.kinematics.follow(model, record, times=t)
    np.testing.assert_allclose(motion.velocity.sel(node="B", axis="x"), truth[:, 1], atol=1e-12)
    np.testing.assert_allclose(motion.acceleration.sel(node="B", axis="x"), truth[:, 2], atol=1e-12)
    between = kt.kinematics.sample(model, record, t[:-1] + 0.05)
    exact = tones(t[:-1] + 0.05, (0.05, 1.3))
    assert np.abs(between.acceleration[:, 0] - exact[:, 2]).max() < 1e-4


@pytest.mark.parametrize(("rate", "second", "said"), [
    (1e3, 1.0, "The rates of M7 are not those of its values"),
    (1.0, 1e3, "The accelerations of M7 are not those of its rates"),
])  # fmt: skip
def test_given_rates_in_other_units_are_reported(rate, second, said):
    t = np.linspace(0, 5.5, 56)
    q = tones(t, (0.05, 1.3)) * (1.0, rate, rate * second)
    record = kt.Measured(times=t, values={"M7": q[:, 0]}, rates={"M7": q[:, 1]}, accelerations={"M7": q[:, 2]})
    assert said in kt.kinematics.measured(record).message


@pytest.mark.slow
def test_noisy_values_with_their_own_rates_agree():
    """Noise in the lengths, at many rows, is no misfit of the rates."""
    t, rng = np.linspace(0, 5.5, 2000), np.random.default_rng(2)
    q = tones(t, (0.05, 1.3))
    record = kt.Measured(times=t, values={"M7": q[:, 0] + 1e-4 * rng.standard_normal(2000)}, rates={"M7": q[:, 1]})
    got = kt.kinematics.measured(record)
    assert "not those" not in got.message
    assert np.abs(got.acceleration.values[:, 0] - q[:, 2]).max() < 1e-5
    assert np.isnan(got.value_error.values).all()


@pytest.mark.slow
def test_coloured_noise_is_reported():
    rng, t = np.random.default_rng(4), np.linspace(0, 5.5, 800)
    white = rng.standard_normal(800)
    slow = np.zeros(800)
    for k in range(1, 800):
        slow[k] = 0.7 * slow[k - 1] + white[k]
    y = tones(t, (0.05, 1.3))[:, 0]
    message = smoothed(t, y + NOISE * slow, smoothing="savitzky_golay", window=151).message
    assert "not white" in message
    assert "not white" not in smoothed(t, y + NOISE * white).message


@pytest.mark.slow
def test_a_motion_faster_than_its_rows_is_reported():
    t = np.linspace(0, 5.5, 60)
    noise = NOISE * np.random.default_rng(1).standard_normal(60)
    assert "cannot be distinguished from its motion" in smoothed(t, tones(t, (0.05, 1.3), (0.01, 12.0))[:, 0] + noise).message
    assert "not white" in smoothed(t, tones(t, (0.05, 1.3), (0.01, 25.0))[:, 0] + noise).message


FILE = """kinetruss: 1
library: {name: vgt.double_octahedral}
runs:
  slew: {trajectory: {kind: measured, file: record.csv, outliers: replace}, samples: 31}
"""


@pytest.mark.slow
def test_a_run_from_a_file(tmp_path):
    t = np.linspace(0, 4, 81)
    rng = np.random.default_rng(9)
    model = kt.library.vgt.double_octahedral()
    slew = kt.Quintic(moves={"bay.beta": (-0.1, 0.1)}, duration=4)
    lengths = kt.kinematics.sample(model, slew, t)
    rows = 1e3 * lengths.value + 0.02 * rng.standard_normal(lengths.value.shape)
    rows[40, 1] += 2
    head = "t," + ",".join(f"{name} [mm]" for name in lengths.drives)
    np.savetxt(tmp_path / "record.csv", np.column_stack([t, rows]), delimiter=",", header=head, comments="")
    (tmp_path / "m.yaml").write_text(FILE, encoding="utf-8")
    assert kt.check(tmp_path / "m.yaml") == []
    run = kt.run(kt.read(tmp_path / "m.yaml"))
    assert run.motion.status.ok
    assert "Noise of M7" in run.motion.message
    assert "M9 has 1 outlier, at t = 2 s" in run.motion.message
    truth = kt.kinematics.follow(model, slew, samples=31)
    assert float(np.abs(run.motion.position - truth.position).max()) < 1e-4
    assert float(np.abs(run.motion.acceleration - truth.acceleration).max()) < 0.2 * float(np.abs(truth.acceleration).max())


def test_a_record_simulates_as_it_is_followed():
    model = kt.Model(nodes={"A": (0, 0), "B": (1.1, 0)}, fixed={"A": "xy", "B": "y"}, section=kt.Rod(diameter=0.01),
                     bars={"M7": {"ends": ("A", "B"), "kind": "driven"}}, material="steel_s235")  # fmt: skip
    t = np.linspace(0, 2, 41)
    q = tones(t, (0.05, 1.3))
    record = kt.Measured(times=t, values={"M7": q[:, 0]}, rates={"M7": q[:, 1]}, accelerations={"M7": q[:, 2]})
    got = kt.dynamics.simulate(model, 2.0, trajectory=record, samples=11)
    followed = kt.kinematics.follow(model, record, samples=11)
    np.testing.assert_allclose(got.motion.position, followed.position, atol=1e-9)


@pytest.mark.parametrize(("head", "said"), [
    ("t,M7 [mm],M7.acceleration [mm/s^2]", "column 'M7.rate' is missing; 'M7.acceleration' needs it"),
    ("t,M9.rate [mm/s],M9 [mm/s]", "which is not a unit of coordinate"),
    ("t,M7 [mm],M7.rate [mm]", "which is not a unit of rate"),
    ("t,M7.rate,M9", "column 'M7' is missing"),
])  # fmt: skip
def test_faulty_tables_say_what_is_missing(tmp_path, head, said):
    path = tmp_path / "r.csv"
    path.write_text("\n".join([head, *(f"{k},1,1" for k in range(20))]), encoding="utf-8")
    with pytest.raises(kt.ModelError, match=said.replace("(", r"\(")) as caught:
        read_measured(path)
    assert "r.csv:1" in str(caught.value)


@pytest.mark.parametrize(("fields", "said"), [
    ({"rates": {"M9": [0.0] * 20}}, "there are no values of 'M9'"),
    ({"accelerations": {"M7": [0.0] * 20}}, "without its rates"),
    ({"rates": {"M7": [0.0] * 3}}, "has 3 values for 20 times"),
    ({"window": 9}, "Set smoothing: savitzky_golay"),
    ({"smoothing": "savitzky_golay", "window": 8}, "not an odd number"),
])  # fmt: skip
def test_faulty_records(fields, said):
    with pytest.raises(kt.ModelError, match=said):
        kt.Measured(times=np.arange(20.0), values={"M7": [1.0] * 20}, **fields)


def test_uneven_steps_and_short_records_are_refused():
    rng = np.random.default_rng(0)
    with pytest.raises(kt.InputError, match="needs even steps"):
        smoothed(uneven(rng, 40), np.ones(40), smoothing="savitzky_golay", largest_gap=1e9)
    with pytest.raises(kt.InputError, match="10 rows; smoothing needs at least 16"):
        smoothed(np.arange(10.0), np.ones(10))
    with pytest.raises(kt.InputError, match="not a measured record"):
        kt.kinematics.measured(math.pi)
