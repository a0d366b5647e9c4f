"""Small motions of links: a pendulum, a cantilever that a drive holds; and what cannot be asked of them."""

import math

import numpy as np
import pytest

import kinetruss as kt

E, DENSITY = 210e9, 7850.0
WIDTH, HEIGHT, LENGTH = 0.02, 0.06, 1.0
AREA, EI = WIDTH * HEIGHT, E * WIDTH * HEIGHT**3 / 12
MASS = DENSITY * AREA * LENGTH


def arm(nodes, kind, **more):
    return kt.Model(
        nodes=nodes,
        fixed=["O"],
        links={"arm": kt.Link(nodes=tuple(nodes), kind=kind)},
        section=kt.Rectangle(width=WIDTH, height=HEIGHT),
        material="steel_s235",
        gravity=(0, -9.81),
        **more,
    )


@pytest.mark.parametrize("kind", ["rigid", "elastic"])
def test_a_link_swings_as_a_pendulum(kind):
    """w^2 = m g (L/2)/J with J = m L^2/3 and the rotary inertia of the section; from 0.61 Hz bending is 360 times away."""
    model = arm({"O": (0, 0), "M": (0, -0.4), "T": (0, -LENGTH)}, kind)
    J = MASS * LENGTH**2 / 3 + DENSITY * WIDTH * HEIGHT**3 / 12 * LENGTH
    exact = math.sqrt(MASS * 9.81 * LENGTH / 2 / J) / (2 * math.pi)
    rest = kt.statics.equilibrium(model)
    assert kt.dynamics.linearise(model, rest).frequency[0].item() == pytest.approx(exact, rel=1e-6)
    found = kt.flexible.frequencies(model, kt.statics.at_poses(model, [{}]), 1)
    assert found.frequency.item() == pytest.approx(exact, rel=1e-5)
    # not where its own weight has not stretched it, and the message says why
    assert "Beams and links, which are elastic here, carry no load" in kt.dynamics.linearise(model).message


@pytest.mark.parametrize("kind", ["rigid", "elastic"])
def test_a_link_that_a_drive_holds_is_a_cantilever(kind):
    """Its tip sinks by q L^4/(8 EI), and it vibrates with 1.8751^2 sqrt(EI/(mu L^4)), here as one beam: 0.5 % more."""
    model = arm({"O": (0, 0), "T": (LENGTH, 0)}, kind, drives={"motor": kt.AngleDrive("arm")})
    forces = kt.runs.forces_at_rest(model)
    sunk = kt.statics.deflection(model, forces).displacement.sel(node="T", axis="y").item()
    assert sunk == pytest.approx(-MASS / LENGTH * 9.81 * LENGTH**4 / (8 * EI), rel=1e-6)
    exact = 1.8751041**2 * math.sqrt(EI / (DENSITY * AREA * LENGTH**4)) / (2 * math.pi)
    assert 1.0 < kt.flexible.frequencies(model, forces, 1).frequency.item() / exact < 1.005


def test_the_stiffness_of_a_link_is_that_of_its_section():
    """`rigid` and `stiffness` are of bars; the refusal offers no inner part."""
    model = arm({"O": (0, 0), "T": (LENGTH, 0)}, "rigid", drives={"motor": kt.AngleDrive("arm")})
    forces = kt.runs.forces_at_rest(model)
    for more in ({"rigid": ["arm"]}, {"stiffness": {"arm": 1e6}}):
        with pytest.raises(kt.InputError, match="'arm' is a link, which bends as its section and material say"):
            kt.flexible.frequencies(model, forces, 1, **more)
    with pytest.raises(kt.InputError) as caught:
        kt.flexible.frequencies(model, forces, 1, rigid=["motor"])
    assert "arm.O" not in str(caught.value)


def braced(push, brace, tie):
    """A frame that one diagonal holds; the other is a cable."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)},
        fixed=["A", "B"],
        bars={
            "ad": kt.Bar(ends=("A", "D"), kind="driven"),
            "bc": ("B", "C"),
            "dc": ("D", "C"),
            "ac": kt.Bar(ends=("A", "C"), kind=brace),
            "bd": kt.Bar(ends=("B", "D"), kind=tie),
        },
        section=kt.Rod(diameter=0.01),
        material="steel_s235",
        loads={"P": kt.NodalForce(node="D", force=(push, 0))},
    )


def test_deflections_in_which_cables_begin_to_pull_are_refused():
    """Away from the cable a deflection is that of linear statics; into it, it is refused."""
    slack = braced(1e3, "rigid", "cable")
    forces = kt.runs.forces_at_rest(slack)
    sunk = kt.statics.deflection(slack, forces).displacement[0]
    np.testing.assert_allclose(sunk, kt.statics.linear(slack).displacement, atol=1e-15)
    pulls = braced(-1e3, "rigid", "cable")
    assert kt.statics.linear(pulls).member_force.sel(member="bd").item() > 700
    with pytest.raises(kt.InputError, match="tightens or slackens bd"):
        kt.statics.deflection(pulls, kt.runs.forces_at_rest(pulls))


def test_a_support_that_the_deflection_comes_to_is_refused():
    """One that touches before presses as in linear statics; one behind a gap is found by that alone."""

    def held(gap):
        return braced(1e3, "rigid", "free").with_(
            supports={"C": kt.Support(x=kt.Restraint(stiffness="1 MN/m", gap=(None, gap)))}
        )

    touches, behind = held(0.0), held("0.1 mm")
    sunk = kt.statics.deflection(touches, kt.runs.forces_at_rest(touches)).displacement[0]
    np.testing.assert_allclose(sunk, kt.statics.linear(touches).displacement, rtol=1e-9, atol=1e-15)
    with pytest.raises(kt.InputError, match="tightens or slackens support C"):
        kt.statics.deflection(behind, kt.runs.forces_at_rest(behind))
