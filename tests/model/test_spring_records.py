"""Springs as data: units, faults with their mends, files."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from spring_models import HINGE, pendulum, two_links


def test_units_are_those_of_the_coordinate():
    one = kt.Spring(coordinate=HINGE, stiffness="2 N m/deg", rest="90 deg", damping="3 N m s/rad", preload="5 N m")
    assert one.stiffness == pytest.approx(2 * 180 / np.pi)
    assert (one.rest, one.damping, one.preload) == (pytest.approx(np.pi / 2), 3.0, 5.0)
    line = kt.Spring(coordinate=kt.CoordinateDrive(node="A", axis="x"), stiffness="2 N/m", play="3 mm")
    assert (line.stiffness, line.play) == (2.0, 0.003)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"stiffness": "2 N/m"}, "stiffness has the unit of a length"),
        ({"stiffness": 1.0, "rest": "2 mm"}, "rest has the unit of a length"),
        ({}, "has no force"),
        ({"stiffness": -1.0}, "must not be negative"),
        ({"stiffness": 1.0, "friction": 0.1, "slip": 0.0}, "must be greater than 0"),
        ({"damping": 1.0, "play": 0.1}, "dead band of a stiffness"),
        ({"stiffness": 1.0, "play": 0.1, "preload": 1.0}, "closes the play"),
        ({"stiffness": 1.0, "table": ((0, 0), (1, 1))}, "Leave one out"),
        ({"table": ((0, 0), (0, 1))}, "ascending"),
        ({"table": ((0, 1), (1, 0))}, "do not fall"),
        ({"stiffness": 1.0, "terms": ((HINGE, 1.0),)}, "Give coordinate, or terms"),
    ],
)
def test_faults_of_a_spring(given, said):
    with pytest.raises(kt.ModelError, match=said):
        kt.Spring(coordinate=HINGE, **given)


@pytest.mark.parametrize(
    ("springs", "said"),
    [
        ({"arm": kt.Spring(coordinate=HINGE, stiffness=1.0)}, "also the name"),
        ({"s": kt.Spring(coordinate=kt.HingeDrive(axis="Q", start="G", end="P"), stiffness=1.0)}, "no node called 'Q'"),
        ({"s": kt.Spring(coordinate=kt.HingeDrive(axis="O", start="G", end="G"), stiffness=1.0)}, "names a node twice"),
        ({"s": kt.Spring(coordinate=kt.LengthDrive("rod"), stiffness=1.0)}, "no member called 'rod'"),
        ({"s": kt.Spring(coordinate=HINGE.with_(gear=kt.Gear(ratio=2.0)), stiffness=1.0)}, "only measures"),
        ({"s": kt.Spring(terms=((HINGE, 0.0),), stiffness=1.0)}, "factor 0"),
    ],
)
def test_faults_in_a_model(springs, said):
    with pytest.raises(kt.ModelError, match=said):
        pendulum().with_(springs=springs)


def test_factors_of_angles_in_no_ratio():
    terms = ((kt.AngleDrive("a"), 1.0), (kt.AngleDrive("b"), np.sqrt(2.0)))
    model = two_links().with_(springs={"s": kt.Spring(terms=terms, stiffness=1.0)})
    with pytest.raises(kt.InputError, match="no ratio of whole numbers"):
        kt.statics.equilibrium(model)
