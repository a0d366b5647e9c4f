"""Andrews' mechanism: inverse dynamics along the motion of the angle formulation gives its torque and its multipliers."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.library import mechanisms
from reference import andrews

TIMES = np.linspace(0, andrews.END, 7)


@pytest.fixture(scope="module")
def motion():
    model = mechanisms.andrews()
    states = [andrews.nodes(q, v) for q, v in zip(*andrews.run(TIMES), strict=True)]
    histories = (np.array([[state[k][name] for name in model.nodes] for state in states]) for k in range(3))
    return kt.kinematics.from_arrays(model, TIMES, *histories)


@pytest.mark.slow
def test_torque_and_energy_come_back(motion):
    forces = kt.dynamics.inverse(mechanisms.andrews(), motion, static=False)
    np.testing.assert_allclose(forces.drive_force.values, andrews.TORQUE, rtol=1e-10)
    turned = forces.motion.drive_position.values[:, 0]
    total = forces.energy.values - andrews.TORQUE * np.unwrap(turned)
    assert np.ptp(forces.energy.values) > 0.5
    # the crank turns by less than pi from one sample to the next only at first
    assert np.ptp(total[:2]) < 1e-10


@pytest.mark.slow
def test_forces_at_the_joint_of_four_bodies(motion):
    """At the start only the spring and the crank's rod act on the body of B; the rods of G and H carry nothing."""
    end = kt.dynamics.inverse(mechanisms.andrews(), motion, static=False).joint_force.isel(time=0)
    on_body = end.sel(member="BE", end="B").values + end.sel(member="ED", end="A").values
    np.testing.assert_allclose(on_body, [98.5668703962410896, -6.12268834425566], rtol=1e-12)
    for rod in ("GE", "HE"):
        np.testing.assert_allclose(end.sel(member=rod, end="B").values, 0, atol=1e-12)
