"""What has no sections, does not buckle, or has no tube: planar bodies, cables, springs of given stiffness."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.design.choices import default_groups, make_plan

STEEL = {"section": kt.Rod(diameter=0.008), "material": kt.Material(E=210e9, density=7850.0, yield_strength=240e6)}


@pytest.fixture(scope="module")
def model():
    """A four-bar: the coupler is a body, a rope and a spring of given stiffness pull at it."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0), "G": (0.3, 0.6)},
        fixed=["A", "D", "G"],
        bars={
            "crank": ("A", "B"), "rocker": ("C", "D"),
            "coupler": kt.Bar(ends=("B", "C"), body=kt.PlanarBody(mass=1.3, center=(0.12, 0.05), inertia=0.02)),
            "spring": kt.Bar(ends=("C", "G"), kind="elastic", stiffness=2e3, pretension=-30.0),
            "rope": kt.Bar(ends=("B", "G"), kind="cable", stiffness=900.0, mass=0.01),
        },
        gravity=(0, -9.81), drives={"motor": kt.AngleDrive("crank")}, **STEEL,
    )  # fmt: skip


@pytest.fixture(scope="module")
def verdict(model):
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 10.0}, duration=0.6), samples=31)
    return kt.strength.check(model, kt.dynamics.inverse(model, motion))


def test_rows_of_the_verdict(verdict):
    rows = {(row.part, row.rule): row for row in verdict.table()}
    assert rows["coupler", "yield"].note == "not checked: no section forces of a planar body"
    assert rows["rope", "buckling"].note == "a cable does not buckle"
    assert not rows["rope", "buckling"].checked
    assert ("rope", "beam-column") not in rows
    assert rows["rope", "yield"].utilisation > 0
    assert rows["spring", "buckling"].utilisation > 0
    assert np.isnan(verdict.data["utilisation"].sel(part="coupler")).all()


def test_groups_of_a_sizing(model):
    assert default_groups(model) == {"bars": ("crank", "rocker")}


@pytest.mark.parametrize(("name", "what"), [("coupler", "a planar body"), ("rope", "a cable")])
def test_a_mission_cannot_give_it_a_tube(model, name, what):
    mission = kt.Mission(catalogues={"tubes": "aluminium_tubes_inch"}, groups={"g": [name]})
    with pytest.raises(kt.ModelError, match=f"groups.g: member '{name}' is {what}, which has no tube"):
        make_plan(model, mission)


def test_bars_that_hold_a_body_together_have_no_rows():
    """They stand for the body; bars without a section of the user's own are still named."""
    ground = kt.Model(
        nodes={"O": (0, 0, 0), "G": (0, 1, 0), "H": (0, 0.5, 1)}, fixed=["O", "G", "H"], gravity=(0, 0, -9.81),
        section=kt.Tube(outer=0.03, inner=0.025), material=kt.library.materials.STEEL_S235,
    )  # fmt: skip
    body = kt.library.bodies.box(ground, "box", (0.2, 0.2, 0.2), mass=5.0, at=(1, 0.5, 0.5))
    a, b, c, _ = body.bodies["box"].nodes
    ends = {"s0": ("O", a), "s1": ("G", a), "s2": ("H", a), "s3": ("O", b), "s4": ("G", b)}
    bars = {name: kt.Bar(ends=pair) for name, pair in ends.items()} | {"bare": kt.Bar(ends=("H", c), kind="driven", mass=0)}
    model = body.with_(bars=dict(body.bars) | bars, drives={"push": kt.LengthDrive("bare")})
    still = kt.kinematics.follow(model, kt.ConstantRate(rates={"push": 0.0}, duration=1.0), samples=2)
    verdict = kt.strength.check(model, kt.dynamics.inverse(model, still))
    assert {row.part for row in verdict.table()} == set(bars)
    assert "box" not in kt.strength.table(verdict)
