"""A drawing that is let go swings and bounces as the closed forms say."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipk

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.studio.let_go import let_go

G = 9.81
START = {"A": (0.0, 0.0), "B": (0.5, 0.0)}


def pendulum(**more) -> kt.Model:
    """A point of 2 kg at the end of a bar of 0.5 m that stands out level."""
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2)}, fixed={"A": "xy"}, bars={"b": ("A", "B")}, gravity=(0, -G),
        **more,
    )  # fmt: skip


def let(model: kt.Model, held: bool = True):
    return let_go(model, np.array(list(START.values())), held)


def test_a_pendulum_swings_with_the_period_of_the_elliptic_integral():
    header, arrays, _ = let(pendulum())
    assert (header["swept"], header["ends"], header["drives_hold"]) == ([], ["", ""], True)
    t, y = arrays["time"], arrays["position"][:, 1, 1]
    period = 4 * math.sqrt(0.5 / G) * ellipk(math.sin(math.pi / 4) ** 2)
    low = t[1:-1][(y[1:-1] < y[:-2]) & (y[1:-1] <= y[2:])]
    assert len(low) > 5
    assert np.allclose(low, period * (np.arange(len(low)) + 0.5) / 2, atol=t[1] - t[0])
    # at the lowest point the bar carries three times the weight; energy goes to and fro
    assert arrays["member_force"].max() == pytest.approx(3 * 2 * G, rel=1e-2)
    energy = arrays["kinetic_energy"] + arrays["potential_energy"]
    assert np.ptp(energy) < 1e-9 * np.ptp(arrays["kinetic_energy"])


def test_drives_hold_still_or_are_free():
    model = pendulum(drives={"motor": kt.AngleDrive("b")})
    _, still, _ = let(model)
    assert np.ptp(still["position"], axis=0).max() < 1e-14
    assert still["drive_force"][0, 0] == pytest.approx(2 * G * 0.5)
    header, free, _ = let(model, held=False)
    assert header["drives"] == [{"name": "motor", "unit": "rad"}]
    _, alone, _ = let(pendulum())
    np.testing.assert_allclose(free["position"], alone["position"], atol=1e-9)
    np.testing.assert_allclose(free["drive_force"], 0, atol=1e-9)
    tip = free["position"][:, 1]
    np.testing.assert_allclose(np.sin(free["drive_position"][:, 0]), tip[:, 1] / 0.5, atol=1e-9)


def test_what_has_no_mass_is_said_and_a_motion_that_takes_long_is_shown_as_far_as_it_is(monkeypatch):
    model = pendulum().with_(nodes={"A": (0, 0), "B": (0.5, 0)})
    with pytest.raises(InputError, match="mass"):
        let(model)
    link = kt.Model(nodes={"A": (0, 0), "P": (0.3, 0), "B": (0.5, 0)}, fixed={"A": "xy"}, links={"l": ("A", "P", "B")})
    with pytest.raises(InputError, match="^Nodes ('[ABP]',? )+have no mass"):  # and none of the inner ones of the link
        let_go(link, compile(link).x0[:, :2], held=True)
    monkeypatch.setattr("kinetruss.studio.let_go.PATIENCE", -1.0)
    header, arrays, _ = let(pendulum())
    assert header["ends"][1] == (
        f"Shown up to {arrays['time'][-1]:.4g} s: this motion takes long to compute. A run of its own goes on."
    )
