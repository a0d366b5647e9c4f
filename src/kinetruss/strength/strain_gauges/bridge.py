"""Strain from the voltages of Wheatstone bridges: arms, shunt calibration, leads, zero and its drift."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import Bridge

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["bridge_output", "bridge_strain", "shunt_strain"]

Floats = Any


def _arms(bridge: Bridge) -> tuple[float, float, float, float]:
    """Strain of the four arms over that of the first; arms 1 and 3 are opposite."""
    nu = bridge.poisson
    return {
        "quarter": (1.0, 0.0, 0.0, 0.0),
        "half_bending": (1.0, -1.0, 0.0, 0.0),
        "half_axial": (1.0, -nu, 0.0, 0.0),
        "half_opposite": (1.0, 0.0, 1.0, 0.0),
        "full_bending": (1.0, -1.0, 1.0, -1.0),
        "full_axial": (1.0, -nu, 1.0, -nu),
    }[bridge.kind]


def bridge_output(strain: ArrayLike, bridge: Bridge, factor: float) -> NDArray[np.float64]:
    """Output over excitation, V/V, at a strain (m/m): R1/(R1 + R2) - R4/(R3 + R4) with R_i = R (1 + k a_i e).

    k is the gauge factor, less the share of the leads, R/(R + R_lead); of a ``linear`` bridge the first-order part.

    >>> import kinetruss as kt
    >>> quarter = kt.Bridge(kind="quarter", excitation=5.0, linear=True)
    >>> kt.strength.bridge_output(1e-3, quarter, factor=2.0).round(9).item()  # V/V: k e/4
    0.0005
    """
    a, b, c, d = _arms(bridge)
    x = _seen(bridge, factor) * np.asarray(strain, float)
    if bridge.linear:
        return np.asarray(x * (a - b + c - d) / 4)
    return np.asarray((1 + a * x) / (2 + (a + b) * x) - (1 + d * x) / (2 + (c + d) * x))


def bridge_strain(volts: ArrayLike, bridge: Bridge, factor: float, times: ArrayLike | None = None) -> NDArray[np.float64]:
    """Strain (m/m) of readings (n,) V of a bridge; the inverse of `bridge_output`.

    Parameters
    ----------
    volts : readings, amplified by ``bridge.gain``. times : (n,) s, for a zero that drifts from ``zero`` at the first to
        ``zero_end`` at the last. factor : gauge factor.

    Raises
    ------
    InputError : a drift without times; a reading that no strain gives.

    Notes
    -----
    r = (V - zero)/(gain excitation). With x = k e and the arms a..d, r is a quotient of quadratics in x, solved for the root
    that is 0 with r. With a shunt, all readings are first scaled by what it should read over what it reads; it is across one
    arm, so that is the output of a quarter bridge. Source: Window, Strain Gauge Technology (1992); Hoffmann, An Introduction
    to Stress Analysis and Transducer Design (1989).

    Examples
    --------
    >>> import kinetruss as kt
    >>> full = kt.Bridge(kind="full_bending", excitation=5.0, gain=100.0)
    >>> volts = kt.strength.bridge_output(1e-3, full, factor=2.0) * full.excitation * full.gain
    >>> kt.strength.bridge_strain([volts], full, factor=2.0).round(9).tolist()  # m/m
    [0.001]
    """
    readings = np.asarray(volts, float)
    zero: Floats = bridge.zero
    if bridge.zero_end is not None:
        if times is None:
            raise InputError("The bridge has zero_end, a drifting zero: give the times of the readings.")
        t = np.asarray(times, float)
        zero = bridge.zero + (bridge.zero_end - bridge.zero) * (t - t[0]) / (t[-1] - t[0])
    readings = readings - zero
    if bridge.shunt is not None and bridge.shunt_reading is not None:
        # the resistor changes one arm, whatever the others carry
        alone = bridge.with_(kind="quarter")
        stands_for = shunt_strain(bridge.resistance or 0.0, bridge.shunt, factor)
        expected = bridge.gain * bridge.excitation * float(bridge_output(stands_for, alone, factor))
        readings = readings * (expected / bridge.shunt_reading)
    return _solved(readings, bridge, factor)


def shunt_strain(resistance: float, shunt: float, factor: float) -> float:
    """Strain (m/m, negative) that a resistor across an arm stands for: -R/(k (R + R_shunt)), both in ohm.

    >>> import kinetruss as kt
    >>> round(kt.strength.shunt_strain(120.0, 59880.0, 2.0), 9)  # m/m: -120/(2 * 60000)
    -0.001
    """
    return -resistance / (factor * (resistance + shunt))


def _seen(bridge: Bridge, factor: float) -> float:
    """Gauge factor of the arm with its lead."""
    return factor if bridge.resistance is None else factor * bridge.resistance / (bridge.resistance + bridge.lead)


def _solved(volts: Floats, bridge: Bridge, factor: float) -> NDArray[np.float64]:
    a, b, c, d = _arms(bridge)
    r = np.asarray(volts, float) / (bridge.gain * bridge.excitation)
    slope, k = a - b + c - d, _seen(bridge, factor)
    if bridge.linear:
        return np.asarray(4 * r / (slope * k))
    # (a c - b d) x^2 + slope x = r (2 + (a + b) x)(2 + (c + d) x)
    second = (a * c - b * d) - r * (a + b) * (c + d)
    first = slope - 2 * r * (a + b + c + d)
    inside = first**2 + 16 * r * second
    if np.any(inside < 0) or np.any(first <= 0):
        worst = float(np.abs(r).max())
        raise InputError(f"A reading of {worst:.3g} V/V is no strain of this bridge. Check excitation, gain and kind.")
    return np.asarray(8 * r / (first + np.sqrt(inside)) / k)
