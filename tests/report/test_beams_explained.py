"""Free bodies and joint tables of nodes of beams."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from frame_models import portal
from kinetruss import report


def test_the_free_body_of_a_node_of_beams_closes():
    run = kt.run(portal())
    for node in ("B", "M", "C"):
        found = kt.dynamics.free_body(run.model, run.motion, run.forces["all"], node=node, time=0.0)
        assert found.residual < 1e-9 * found.largest


def test_joint_tables_have_the_users_members_and_whole_reactions():
    run = kt.run(portal())
    page = report.joints(run)
    assert ".d1" not in page.text
    assert ".chord" not in page.text
    down = sum(force[1] for _, force in page.found.supports)
    weight = sum(run.model.section.area * run.model.material.density * 9.81 * length for length in (3.0, 4.0, 3.0))
    assert [name for name, _ in page.found.supports] == ["A", "D"]
    assert down == pytest.approx(12e3 + weight, rel=1e-9)
    assert np.isclose(sum(force[0] for _, force in page.found.supports), -4e3, rtol=1e-9)
