"""Beams that turn about one axis at an end: closed forms by axis, a pendulum, large rotations, faults, files."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import ModelError
from kinetruss.model import beam_frames

STEEL = kt.Material(E=200e9, density=7800.0)
BOX = kt.Rectangle(width=0.02, height=0.03)
P, L = 10.0, 1.0
ACROSS = np.array([[0, 1.0, 0], [0, 0, 1.0]])


def clamped_beam(about, force) -> kt.Model:
    """A beam along (1, 2, 2)/3 or x, clamped at both ends but for a hinge at the second, loaded in the middle."""
    return kt.Model(
        nodes={"A": (0, 0, 0), "M": (L / 2, 0, 0), "B": (L, 0, 0)},
        beams={
            "a": kt.Beam(ends=("A", "M"), orientation=(0, 1, 0)),
            "b": kt.Beam(ends=("M", "B"), orientation=(0, 1, 0), hinges={"B": about}),
        },
        clamped=["A", "B"],
        material=STEEL,
        section=BOX,
        loads={"P": kt.NodalForce(node="M", force=tuple(force))},
    )


def middle(model: kt.Model) -> np.ndarray:
    return kt.statics.linear(model).displacement.sel(node="M").values


@pytest.mark.slow
def test_a_hinge_frees_the_bending_about_its_axis_only():
    """P L^3/(192 E I) with both ends clamped, 7 P L^3/(768 E I) with one of them on a hinge."""
    I2, I3 = BOX.second_moments
    stiff, loose = P * L**3 / 192 / STEEL.E, 7 * P * L**3 / 768 / STEEL.E
    # axis 3 is z: a force along y bends about it
    for about, expected in {1: (stiff / I3, stiff / I2), 2: (stiff / I3, loose / I2), 3: (loose / I3, stiff / I2)}.items():
        for k, force in enumerate(ACROSS):
            moved = middle(clamped_beam(about, P * force))
            assert moved[k + 1] == pytest.approx(expected[k], rel=1e-9)
    np.testing.assert_allclose(
        middle(clamped_beam((0, 0, -2.0), (0, P, 0))), middle(clamped_beam(3, (0, P, 0))), rtol=1e-9, atol=1e-20
    )


def test_an_oblique_hinge_has_no_moment_about_its_axis():
    axis = np.array([0.0, 0.6, 0.8])
    model = clamped_beam(tuple(axis), (0, P, 0.5 * P))
    along = kt.strength.beams(model, kt.statics.linear(model))
    moment = along.end_moment.sel(beam="b", end="B").values
    assert abs(moment @ axis) < 1e-9 * np.abs(moment).max()
    assert np.abs(moment).max() > 0.05 * P * L


def test_a_hinge_along_the_beam_lets_it_twist():
    """A couple at the middle goes to the clamped end alone: T l/(G J); between two clamps half of it."""
    G, turns = STEEL.E / (2 * (1 + STEEL.poisson)), {}
    for about in (1, 3):
        model = clamped_beam(about, (0, 0, 0)).with_(loads={"T": kt.BodyCouple(body="M", moment=(2.0, 0, 0))})
        moved = kt.statics.linear(model).whole["displacement"]
        turn = (moved.sel(node="M.d2") - moved.sel(node="M")).sel(axis="z").item() / (model.whole.nodes["M.d2"].at[1])
        turns[about] = turn * G * BOX.torsion_constant / (2.0 * L / 2)
    assert turns == pytest.approx({1: 1.0, 3: 0.5}, rel=1e-9)


@pytest.mark.slow
def test_a_rigid_beam_on_a_hinge_is_a_pendulum_in_its_plane():
    axis = np.array([1.0, 1.0, 0.0]) / math.sqrt(2)
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (0, 0, -L)},
        beams={"rod": kt.Beam(ends=("A", "B"), kind="rigid", mass=3.0, hinges={"A": tuple(axis)})},
        clamped=["A"],
        gravity=(0, 0, -9.81),
    )
    found = kt.dynamics.linearise(model)
    assert found.frequency.values == pytest.approx([math.sqrt(1.5 * 9.81 / L) / (2 * math.pi)], rel=1e-9)
    push = np.cross(axis, (0, 0, -1.0))
    speeds = {name: tuple(2.0 * np.cross(axis, np.array(node.at))) for name, node in model.whole.nodes.items() if name != "A"}
    held = {name: v for name, v in speeds.items() if name not in model.whole.fixed}
    run = kt.dynamics.simulate(model.with_(velocities=held), 1.0, samples=21)
    place = run.motion.position.sel(node="B").values
    assert np.abs(place @ axis).max() < 1e-8
    assert np.abs(place @ push).max() > 0.3 * L


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"hinges": {"X": 3}}, "no end of the beam"),
        ({"hinges": {"B": 3}, "release": ["B"]}, "released about all axes too"),
        ({"hinges": {"B": (0, 0, 0)}}, "zero vector"),
        ({"hinges": {"B": (0, 1)}}, "components"),
        ({"hinges": {"B": 4}}, "not one of 1, 2, 3"),
        ({"kind": "rigid", "damping": 1e-4}, "rigid beam"),
    ],
)
def test_faults(change, says):
    model = clamped_beam(3, (0, P, 0))
    beams = dict(model.beams) | {"b": {"ends": ["M", "B"], "orientation": [0, 1, 0]} | change}
    with pytest.raises(ModelError, match=says):
        model.with_(beams=beams)


def test_a_hinge_needs_a_rotation_at_its_node_and_a_model_in_space():
    model = clamped_beam(3, (0, P, 0))
    with pytest.raises(ModelError, match="no rotation that the hinge could hold"):
        model.with_(clamped=["A"], fixed={"B": "xyz"})
    with pytest.raises(ModelError, match=r'release=\["B"\]'):
        kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A", "B"], beams={"b": kt.Beam(ends=("A", "B"), hinges={"B": 3})})


def post_on_an_arm(hinge, kind="elastic"):
    """A post between ball joints, welded to the end N of an arm that is hinged there; a force pushes N aside."""
    return kt.Model(
        nodes={"A": (0, 0, 0), "N": (0, L, 0), "T": (0, L, 2.0)},
        beams={
            "arm": kt.Beam(ends=("A", "N"), hinges={"N": hinge}),
            "post": kt.Beam(ends=("N", "T"), release=["T"], kind=kind),
        },
        clamped=["A"],
        fixed={"T": "xyz"},
        material=STEEL,
        section=kt.Rod(diameter=0.02),
        loads={"P": kt.NodalForce(node="N", force=(P, 0, 0))},
    )


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["elastic", "rigid"])
def test_a_beam_that_a_hinge_holds_does_not_spin_freely(kind):
    """Hinged about its own axis: if the arm bends, the post turns with it, which takes no force. P L^3/(3 E I) of the arm."""
    model = post_on_an_arm(1, kind)
    found = kt.statics.linear(model)
    bends = P * L**3 / (3 * STEEL.E * model.section.second_moments[0])
    assert found.displacement.sel(node="N", axis="x").item() == pytest.approx(bends, rel=1e-9)
    assert "spin" not in found.message


def test_a_hinge_along_its_neighbour_lets_it_spin():
    """Hinged about the axis of the post: the post spins freely, and is held without a force."""
    model = post_on_an_arm((0, 0, 1))
    found = kt.statics.linear(model)
    I, J = model.section.second_moments[0], model.section.torsion_constant
    # the post tilts by x/2 m, against the torsion of the arm and its own bending, in series
    tilts = 1 / (L / (STEEL.E / (2 * (1 + STEEL.poisson)) * J) + 2.0 / (3 * STEEL.E * I)) / 2.0**2
    bends = 3 * STEEL.E * I / L**3
    assert found.displacement.sel(node="N", axis="x").item() == pytest.approx(P / (bends + tilts), rel=1e-9)
    assert "held: post." in found.message


def test_free_spins_are_sought_as_often_in_many_beams_as_in_few(monkeypatch):
    sought, plain = [], beam_frames.frames
    monkeypatch.setattr(beam_frames, "frames", lambda model: sought.append(len(model.beams)) or plain(model))
    for count in (2, 20):
        ends = {f"{end}{k}": (float(k), y, 0.5 * (k % 3)) for k in range(count) for end, y in (("A", 0.0), ("B", 1.0))}
        beams = {f"b{k}": kt.Beam(ends=(f"A{k}", f"B{k}"), release=[f"A{k}", f"B{k}"]) for k in range(count)}
        model = kt.Model(nodes=ends, beams=beams, material=STEEL, section=kt.Rod(diameter=0.02))
        assert len(model.whole.inner.spins) == count
    assert sought.count(2) == sought.count(20) > 0


def test_files_keep_hinges(tmp_path):
    model = clamped_beam((0, 0.6, 0.8), (0, P, 0))
    kt.write(model, tmp_path / "hinge.yaml")
    again = kt.read(tmp_path / "hinge.yaml")
    assert again == model
    assert again.with_(title="again").nodes == model.nodes
    np.testing.assert_array_equal(middle(again), middle(model))
