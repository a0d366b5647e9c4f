"""A flyball governor whose rods are thin bodies, against its equations in three coordinates."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.results import Status
from reference.governor import AXIAL, governor, reference, seen


@pytest.mark.slow
@pytest.mark.parametrize("axial", [None, 1e-7, 1e-9])
def test_an_undamped_governor_with_thin_rods(axial):
    run = kt.dynamics.simulate(governor(0.0, axial), 1.0, samples=51)
    assert run.status is Status.COMPLETED
    assert np.ptp(run.energy.values) < 1e-8 * run.kinetic_energy.values.max()
    expected = reference(run.time.values, 0.0, AXIAL if axial is None else axial)
    np.testing.assert_allclose(seen(run), expected, atol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("method", "error"),
    [
        (None, 1e-9),
        (kt.Radau(), 1e-7),
        (kt.Radau(rtol=1e-10, atol=1e-11), 1e-9),
        (kt.EnergyMomentum(step=2e-3), 2e-3),
        (kt.GeneralizedAlpha(step=1e-3), 2e-3),
    ],
)
def test_a_stiff_governor_is_stepped_through_as_long_as_the_steps_allowed_do(method, error):
    run = kt.dynamics.simulate(governor(4e4), 1.0, samples=51, method=method)
    assert run.status is Status.COMPLETED
    np.testing.assert_allclose(seen(run), reference(run.time.values, 4e4, AXIAL), atol=error)


@pytest.mark.slow
def test_too_few_steps_for_a_stiff_governor_are_told_with_the_methods_for_it():
    few = kt.dynamics.simulate(governor(4e4), 10.0, method=kt.DOP853(max_steps=20_000), raise_on_failure=False)
    assert few.status is Status.STIFF
    assert "Radau()" in few.message and "EnergyMomentum" in few.message
