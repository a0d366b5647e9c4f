"""What the pages on the two sources say: the entries they name exist, and kinetruss' own numbers are what it gives."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.verification.cases import cases
from kinetruss.verification.thesis_bay import END, START, bay_of, pose

DOCS = Path(__file__).parents[2] / "docs"
SOURCES, ERRATA = ((DOCS / name).read_text(encoding="utf-8") for name in ("sources.md", "errata.md"))
IDS = [case.id for case in cases()]


@pytest.mark.parametrize("text", sorted(set(re.findall(r"--filter ([\w.]+)", SOURCES + ERRATA))))
def test_the_entries_that_are_named_exist(text):
    assert any(text in one for one in IDS)


def largest(model: kt.Model, forces: kt.results.Forces) -> float:
    """Largest normal stress of the tube M8 over its length and time, Pa."""
    found = kt.strength.stresses(model, kt.strength.sections(model, forces))["S2"].sel(part="M7.tube")
    return float(found.max())


def test_the_largest_stress_in_m8_is_what_the_errata_say():
    bay = bay_of("C")
    own = largest(bay, kt.statics.at_poses(bay, [pose(START), pose(END)]))
    assert f"{own / 1e6:.2f} MPa with the sizes of section 5.7" in ERRATA
    assert f"{own / 1e6:.2f} MPa with the sizes of that section" in SOURCES
    model = kt.library.vgt.double_octahedral(gravity=(0, 0, 9.81), tip_force=(0, 0, 46))
    slew = kt.library.vgt.slew(beta=(-math.radians(10), math.radians(10)), duration=5.5)
    moving = largest(model, kt.dynamics.inverse(model, kt.kinematics.follow(model, slew, samples=101), static=False))
    assert f"{moving / 1e6:.2f} MPa with the default sizes" in ERRATA
    assert f"{moving / 1e6:.2f} MPa with the default sizes" in SOURCES


def test_the_jacobian_of_a_pose_is_what_the_page_says():
    found = kt.kinematics.jacobian(kt.library.vgt.double_octahedral(), of="bay.gamma", wrt="M6")
    assert np.isclose(float(found.values.item()), 0.885, atol=5e-4)


@pytest.mark.parametrize("duration", [1.0, 5.5])
def test_what_two_slips_of_his_program_amount_to(duration):
    """The inertia of M7 in the equation of M9, and the acceleration of a length without the square of the rate of turn."""
    model = kt.library.vgt.double_octahedral(gravity=(0, 0, 9.81), tip_force=(0, 0, 46), beta=-math.radians(10))
    slew = kt.library.vgt.slew(beta=(-math.radians(10), math.radians(10)), duration=duration)
    motion = kt.kinematics.follow(model, slew, samples=401)
    rates = kt.kinematics.member_rates(model, motion)
    active = model.active["M9"]
    base, tube, metal = active.base, model.sections["tube"], model.materials["bar"]
    (m, l), (n, s) = (base.mass, base.length), (metal.density * tube.area * active.tube.length, active.tube.length)

    def inertia(length):
        """Of both rods about their centre (eq. 4.61 with the right distances)."""
        return (m * l**2 + n * s**2) / 12 + m * n / (m + n) * (length - (l + s) / 2) ** 2

    L7, L9 = (motion.length.sel(member=name).values for name in ("M7", "M9"))
    assert abs(inertia(1.1684) - 0.14991) < 1e-5  # as independently computed
    turning = np.linalg.norm(rates.angular_acceleration.sel(member="M9").values, axis=1)
    force = np.abs(inertia(L9) - inertia(L7)) * turning / L9
    text = f"at most {force.max():.3f} N (T = 1 s)" if duration == 1 else f"{1e4 * force.max():.1f}e-4 N (5.5 s)"
    assert text in ERRATA
    square = (rates.angular_velocity.values**2).sum(axis=2)
    places = motion.position, motion.acceleration
    for name in ("M7", "M9", "M11"):
        k, (a, b) = list(motion.member.values).index(name), model.members[name].ends
        d, dd = (history.sel(node=b).values - history.sel(node=a).values for history in places)
        L = np.linalg.norm(d, axis=1)
        whole = np.vecdot(d, dd) / L + square[:, k] * L
        np.testing.assert_allclose(motion.length_acceleration.sel(member=name), whole, atol=1e-12)
        if name == "M7":
            assert (square[:, k] * L).max() < 1e-20
        elif duration == 1:
            most = (square[:, k] * L).max(), np.abs(whole).max()
            assert "{:.3f} m/s² where L'' is up to {:.3f} m/s²".format(*most) in ERRATA
