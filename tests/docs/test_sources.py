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
