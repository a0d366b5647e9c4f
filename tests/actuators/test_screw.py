"""Lead screws: closed forms and the balance of power."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from kinetruss.actuators import (
    gear_ratio_for,
    is_self_locking,
    largest_self_locking_lead,
    lowering_torque,
    raising_torque,
    screw_torque,
)
from kinetruss.errors import InputError
from kinetruss.model import LeadScrew

screws = st.builds(
    LeadScrew,
    lead=st.floats(1e-5, 4e-3),
    mean_diameter=st.floats(5e-3, 5e-2),
    friction=st.floats(0, 0.4),
    flank=st.floats(0, 0.5),
)
thrusts = st.floats(-1e4, 1e4, allow_subnormal=False)


def by_hand(screw: LeadScrew) -> tuple[float, float]:
    """Raising and lowering torque a newton, in the words of machine-design books (lead a turn, not a radian)."""
    lead, d, mu, sec = 2 * math.pi * screw.lead, screw.mean_diameter, screw.friction, 1 / math.cos(screw.flank)
    up = d / 2 * (lead + math.pi * mu * d * sec) / (math.pi * d - mu * lead * sec)
    down = d / 2 * (math.pi * mu * d * sec - lead) / (math.pi * d + mu * lead * sec)
    return up, down


@given(screws)
def test_textbook_formulas(screw):
    up, down = by_hand(screw)
    assert raising_torque(screw, 1.0) == pytest.approx(up, rel=1e-12)
    assert lowering_torque(screw, 1.0) == pytest.approx(down, rel=1e-12, abs=1e-16)


@given(screws, thrusts, st.sampled_from([-1.0, 1.0]))
def test_friction_only_ever_takes_power(screw, thrust, direction):
    turn = direction / screw.lead
    put_in = screw_torque(screw, thrust, direction) * turn
    assert put_in >= thrust * direction - 1e-9 * abs(thrust)


@given(screws, st.floats(1.0, 1e4))
def test_power_through_a_raising_screw_closes_with_its_efficiency(screw, thrust):
    # efficiency of a screw: tan(lambda)/tan(lambda + rho) with tan(rho) = mu/cos(flank)
    slope, rho = math.atan(screw.lead / (screw.mean_diameter / 2)), math.atan(screw.friction / math.cos(screw.flank))
    efficiency = math.tan(slope) / math.tan(slope + rho)
    speed = 0.02
    assert raising_torque(screw, thrust) * speed / screw.lead == pytest.approx(thrust * speed / efficiency, rel=1e-10)


@given(screws.map(lambda screw: screw.with_(friction=0.0)), thrusts, st.sampled_from([-1.0, 0.0, 1.0]))
def test_without_friction_the_screw_passes_all_power_both_ways(screw, thrust, direction):
    assert screw_torque(screw, thrust, direction) == pytest.approx(thrust * screw.lead, rel=1e-12)


@given(screws)
def test_holding_needs_no_torque_exactly_where_the_screw_locks(screw):
    held = float(screw_torque(screw, 1.0, 0.0))
    assert held == pytest.approx(max(0.0, -by_hand(screw)[1]), abs=1e-16)
    assert is_self_locking(screw) == (held <= 1e-12 * screw.mean_diameter)


@given(screws.filter(lambda screw: screw.friction > 1e-3))
def test_the_largest_self_locking_lead_is_the_limit(screw):
    lead = largest_self_locking_lead(screw)
    assert is_self_locking(screw.with_(lead=lead))
    assert not is_self_locking(screw.with_(lead=lead * 1.0001))
    assert lowering_torque(screw.with_(lead=lead), 1.0) == pytest.approx(0.0, abs=1e-15)


def test_lead_of_mu_d_over_2_needs_exactly_no_lowering_torque():
    # Lacy (1991), triangular truss: lead 3 mm/rad, mean diameter 20 mm, friction .3
    assert lowering_torque(LeadScrew(lead=0.003, mean_diameter=0.02, friction=0.3), 1000.0) == 0.0


def test_raising_or_lowering_is_decided_by_the_sign_of_the_power():
    # M7 shortens under a compression of 74.5 N: with the load. Raising would need .0664 N m
    screw = LeadScrew(lead=2.5266e-4, mean_diameter=0.0127, friction=0.1)
    assert float(screw_torque(screw, 74.5, -1.0)) == pytest.approx(-0.0284, abs=5e-5)
    assert float(screw_torque(screw, 74.5, 1.0)) == pytest.approx(0.0664, abs=5e-5)


def test_torque_is_odd_under_reversal_of_thrust_and_motion():
    screw = LeadScrew(lead=1e-3, mean_diameter=0.012, friction=0.12, flank="14.5 deg")
    thrust, moving = np.array([5.0, 5.0, -3.0, 0.0]), np.array([1.0, -1.0, 1.0, 1.0])
    assert np.allclose(screw_torque(screw, -thrust, -moving), -screw_torque(screw, thrust, moving))


def test_acme_costs_more_than_square():
    square = LeadScrew(lead=5e-4, mean_diameter=0.012, friction=0.12)
    assert raising_torque(square.with_(flank="14.5 deg"), 1.0) > raising_torque(square, 1.0)


def test_a_jamming_screw_is_refused():
    with pytest.raises(InputError, match="jams"):
        raising_torque(LeadScrew(lead=0.06, mean_diameter=0.02, friction=0.3), 1.0)


def test_gear_ratio_of_the_triangular_truss():
    screw = LeadScrew(lead=0.003, mean_diameter=0.02, friction=0.3)
    assert gear_ratio_for(screw, 400.0, 1.2477) == pytest.approx(0.961770, rel=1e-6)
    with pytest.raises(InputError, match="other than zero"):
        gear_ratio_for(screw, 400.0, 0.0)
