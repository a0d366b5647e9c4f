"""The triangular truss the way Lacy (1991, appendix A) computed it: the only road to his dynamic figures.

What differs from the physics, and from the product: 50 samples 0.06 s apart; x and its derivatives exact, the angles
exact, but their rates by a backward difference applied twice, zero at the first sample (first order, one step late); the
inertia of a cut-off part of the follower taken with the whole length, Iz = m (3 (od^2 + id^2) + 4 L^2)/48. Gravity acts
downward, as in the published figures (the listing's sign is wrong), and printed times are one step late.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

import kinetruss as kt

Record = tuple[np.ndarray, np.ndarray, np.ndarray]
"""A quantity, its rate and its acceleration (n,)."""
Axes = tuple[np.ndarray, np.ndarray]
"""Unit vectors (n, 2) along a member and along its increasing angle."""
SECTIONS = np.linspace(0.0, 1.0, 7)


@dataclass(frozen=True)
class Setup:
    """Sizes and masses, SI. Follower (O1 to B) and tube are of one section and one length; the base rod (from O2) is thin."""

    section: kt.Tube
    density: float
    member: float
    ground: float
    shortest: float
    rod_mass: float
    rod_length: float
    load: float
    gravity: float

    @property
    def line(self) -> float:
        """Mass a metre."""
        return self.density * float(self.section.area)

    def inertia(self, piece: Any, length: Any) -> Any:
        """Of a piece about its centre, its length entering as `length` (the piece's own, if right)."""
        diameters = self.section.outer**2 + self.section.inner**2
        return self.line * piece * (3 * diameters + 4 * length**2) / 48


def stresses(setup: Setup, length: Record, step: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """S2 stress (n,) at mid follower and at the tube's clamped end, largest compression of both over seven sections.

    length : of the active member, with its rate and acceleration, `step` seconds apart.
    """
    a, g, x = setup.member, setup.ground, length[0]
    # exact angles by the law of cosines, their rates by backward differences
    phi = _differences(np.arccos((a**2 + g**2 - x**2) / (2 * a * g)), step)
    theta = _differences(np.arccos((x**2 + g**2 - a**2) / (2 * x * g)), step)
    first = _axes(-np.cos(phi[0]), np.sin(phi[0]), clockwise=True)
    second = _axes(np.cos(theta[0]), np.sin(theta[0]), clockwise=False)
    on_follower, on_tube = _at_b(setup, (length, phi, theta), first, second)
    fixed = (np.full_like(x, a), np.zeros_like(x), np.zeros_like(x))
    follower = [_section(setup, (first, phi, fixed), on_follower, s * a, whole=True) for s in SECTIONS]
    tube = [_section(setup, (second, theta, length), on_tube, x - (1 - s) * a, whole=False) for s in SECTIONS]
    return (
        _outer_fibre(setup, *follower[3]),
        _outer_fibre(setup, *tube[0]),
        np.max([-tension for tension, _ in follower], axis=0),
        np.max([-tension for tension, _ in tube], axis=0),
    )


def _differences(angle: np.ndarray, step: float) -> Record:
    rate = np.concatenate([[0.0], np.diff(angle) / step])
    return angle, rate, np.concatenate([[0.0], np.diff(rate) / step])


def _axes(x: np.ndarray, y: np.ndarray, *, clockwise: bool) -> Axes:
    return np.stack([x, y], 1), np.stack([y, -x] if clockwise else [-y, x], 1)


def _at_b(setup: Setup, motion: tuple[Record, Record, Record], first: Axes, second: Axes) -> tuple[np.ndarray, np.ndarray]:
    """Forces (n, 2) on follower and tube at B: moments about O1 and O2, balance of the load; its acceleration by phi."""
    (length, rate, _), phi, theta = motion
    m, a, k2 = setup.line * setup.member, setup.member, float(setup.inertia(setup.member, 0.0)) / (setup.line * setup.member)
    down, centre = np.array([0.0, -setup.gravity]), length - setup.member / 2
    follower = m * (a**2 / 3 + k2) * phi[2] - m * a / 2 * (first[1] @ down)
    inertia = setup.rod_mass * setup.rod_length**2 / 3 + m * (centre**2 + a**2 / 12 + k2)
    moment = setup.rod_mass * setup.rod_length / 2 + m * centre
    active = inertia * theta[2] + 2 * m * centre * rate * theta[1] - moment * (second[1] @ down)
    acceleration = -a * phi[1][:, None] ** 2 * first[0] + a * phi[2][:, None] * first[1]
    across = (follower / a)[:, None] * first[1], (active / length)[:, None] * second[1]
    axial = setup.load * (down - acceleration) - across[0] - across[1]
    shares = np.linalg.solve(np.stack([first[0], second[0]], 2), axial[:, :, None])[:, :, 0]
    return across[0] + shares[:, :1] * first[0], across[1] + shares[:, 1:] * second[0]


def _section(
    setup: Setup, member: tuple[Axes, Record, Record], at_b: np.ndarray, s: float | np.ndarray, *, whole: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Tension and moment (n,) at distance s from the pin, from the balance of the piece on the B side."""
    (along, normal), angle, length = member
    down = np.array([0.0, -setup.gravity])
    piece, centre = length[0] - s, (length[0] + s) / 2
    radial = length[2] - centre * angle[1] ** 2 - along @ down
    around = centre * angle[2] + 2 * length[1] * angle[1] - normal @ down
    tension = (at_b * along).sum(1) - setup.line * piece * radial
    pin = (at_b * normal).sum(1)
    shear = setup.line * piece * around - pin
    inertia = setup.inertia(piece, setup.member if whole else piece)
    return tension, inertia * angle[2] + piece / 2 * (shear - pin)


def _outer_fibre(setup: Setup, tension: np.ndarray, moment: np.ndarray) -> np.ndarray:
    """Stress at S2: |T|/A + |M| c/I."""
    section = setup.section
    fibre: np.ndarray = np.abs(tension) / section.area + np.abs(moment) * section.extreme_fibres[0] / section.second_moments[0]
    return fibre
