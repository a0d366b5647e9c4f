"""Standard errors of forces along a measured motion, against closed forms and against repeated noise."""

import numpy as np
import pytest

import kinetruss as kt

T = np.linspace(0, 4, 81)
NOISE = 2e-5
MASS = 3.0


def slider(**bar):
    """A mass at the end of a driven bar along x: N = -m x''."""
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.model.Node(at=(1.0, 0), mass=MASS)}, fixed={"A": "xy", "B": "y"},
        bars={"M7": {"ends": ("A", "B"), "kind": "driven", **bar}},
    )  # fmt: skip


@pytest.mark.slow
def test_force_of_a_mass_is_mass_times_the_error_of_its_acceleration():
    y = 1 + 0.1 * np.sin(T) + NOISE * np.random.default_rng(1).standard_normal(81)
    record = kt.Measured(times=T, values={"M7": y})
    got = kt.runs.standard_errors(slider(), record)
    smooth = kt.kinematics.measured(record)
    np.testing.assert_allclose(got.drive_force_error[:, 0], MASS * smooth.acceleration_error[:, 0], rtol=1e-7)
    np.testing.assert_allclose(got.position_error.sel(node="B", axis="x"), smooth.value_error[:, 0], rtol=1e-7)
    assert got.attrs["curvature"] < 1e-6


def test_given_accelerations_count_as_exact():
    q = [1 + 0.1 * np.sin(T), 0.1 * np.cos(T), -0.1 * np.sin(T)]
    record = kt.Measured(times=T, values={"M7": q[0]}, rates={"M7": q[1]}, accelerations={"M7": q[2]})
    assert float(kt.runs.standard_errors(slider(), record).drive_force_error.max()) == 0


@pytest.mark.slow
def test_repeated_noise_scatters_as_the_standard_errors_say():
    """A bay: forces of 40 records of one motion, each with its own noise, lie within 1.96 standard errors in 95 %."""
    model = kt.library.vgt.double_octahedral()
    lengths = kt.kinematics.sample(model, kt.Quintic(moves={"bay.beta": (-0.15, 0.1)}, duration=4), T)
    truth = kt.dynamics.inverse(model, kt.kinematics.follow(model, kt.Quintic(moves={"bay.beta": (-0.15, 0.1)}, duration=4),
                                                            times=T), static=False)  # fmt: skip
    rng, inside = np.random.default_rng(3), []
    for _ in range(5):
        rows = lengths.value + NOISE * rng.standard_normal(lengths.value.shape)
        record = kt.Measured(times=T, values=dict(zip(lengths.drives, rows.T, strict=True)))
        got = kt.runs.standard_errors(model, record)
        off = np.abs(got.member_force.values - truth.member_force.values)
        moving = got.member_force_error.values > 1e-9
        inside.append((off < 1.96 * got.member_force_error.values)[moving].mean())
    assert np.mean(inside) > 0.9


def test_a_record_of_what_the_model_does_not_have_is_refused():
    with pytest.raises(kt.ModelError, match="M8"):
        kt.runs.standard_errors(slider(), kt.Measured(times=T, values={"M8": np.ones(81) + 1e-6 * np.sin(9 * T)}))


@pytest.mark.slow
def test_currents_carry_the_errors_of_the_forces():
    """Without friction the current is linear in the motor's torque: J a N-fold and the thrust; it has a standard error."""
    model = kt.read(kt.library.example_files()["measured_slew"][0])
    lengths = kt.kinematics.sample(model, model.trajectory_of(model.runs["slew"]), T)
    rows = lengths.value + NOISE * np.random.default_rng(0).standard_normal(lengths.value.shape)
    record = kt.Measured(times=T, values=dict(zip(lengths.drives, rows.T, strict=True)))
    got = kt.runs.standard_errors(model, record, load_case="loaded")
    share = got.motor_torque_error / got.current_error
    np.testing.assert_allclose(share, 0.0398, rtol=1e-6)  # torque constant, N m/A
    assert (got.current_error > 0).all()
