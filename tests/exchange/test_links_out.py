"""Links in robot files: one rigid part each, with their mass and moment of inertia."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest

import kinetruss as kt

SECTION = kt.Rectangle(width=0.05, height=0.1)
STEEL = kt.library.materials.STEEL_S235


def crane(**changes) -> kt.Model:
    fields = {
        "nodes": {"A": (0, 0), "B": (1, 0), "C": (2, 0), "D": (1, -1), "E": (3, 0)},
        "fixed": ["A", "D"],
        "links": {"boom": ("A", "B", "C"), "jib": kt.Link(nodes=("C", "E"), mass=3.0)},
        "bars": {"ram": kt.Bar(ends=("D", "B"), kind="driven", mass=0)},
        "section": SECTION,
        "material": STEEL,
    }
    return kt.Model(**fields | changes)


BARE = {
    "section": None,
    "material": None,
    "links": {
        "boom": kt.Link(nodes=("A", "B", "C"), mass=2 * SECTION.area * STEEL.density),
        "jib": kt.Link(nodes=("C", "E"), mass=3.0),
    },
}


@pytest.mark.parametrize("changes", [{}, BARE])
def test_a_link_is_one_body_with_its_mass(tmp_path, changes):
    path = tmp_path / "crane.xml"
    written = kt.exchange.write(crane(**changes), path)
    assert not [one for one in written.left_out if "mass" in one.what]
    bodies = {one.get("name"): one.find("inertial") for one in ET.parse(path).iter("body")}
    boom, jib = bodies["boom"], bodies["jib"]
    mass = 2 * SECTION.area * STEEL.density
    assert float(boom.get("mass")) == pytest.approx(mass, rel=1e-12)
    assert float(jib.get("mass")) == pytest.approx(3.0, rel=1e-12)
    given = boom.get("diaginertia") or boom.get("fullinertia")
    about = sorted(map(float, given.split()))[-1]
    assert about == pytest.approx(mass * 4 / 12, rel=1e-3)


def test_elastic_beams_are_told_as_left_out(tmp_path):
    model = crane(beams={"mast": ("E", "F")}, nodes={**crane().nodes, "F": (3, 1)})
    written = kt.exchange.write(model, tmp_path / "crane.urdf")
    assert [(one.what, one.where) for one in written.left_out if one.what == "beams"] == [("beams", "mast")]


def test_the_motion_of_a_tip_by_its_ram():
    """C = 2 B of a boom that turns about A: dC = 2 (-B_y, B_x) dl/(u . (-B_y, B_x))."""
    found = kt.kinematics.jacobian(
        crane(links={"boom": ("A", "B", "C")}, nodes={k: v for k, v in crane().nodes.items() if k != "E"}), of=["C"]
    )
    np.testing.assert_allclose(found.values.ravel(), [0.0, 2.0], atol=1e-12)
