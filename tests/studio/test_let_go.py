"""A drawing that is let go swings and bounces as the closed forms say."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipk

import kinetruss as kt
from drawn import asked, drawing, unpacked
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.studio.let_go import let_go

G = 9.81
START = {"A": (0.0, 0.0), "B": (0.5, 0.0)}


def pendulum(**more) -> kt.Model:
    """A point of 2 kg at the end of a bar of 0.5 m that stands out level."""
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2)}, fixed={"A": "xy"}, bars={"b": ("A", "B")}, gravity=(0, -G),
        **more,
    )  # fmt: skip


def let(model: kt.Model, held: bool = True):
    return let_go(model, np.array(list(START.values())), held)


def test_a_pendulum_swings_with_the_period_of_the_elliptic_integral():
    header, arrays, _ = let(pendulum())
    assert (header["swept"], header["ends"], header["drives_hold"]) == ([], ["", ""], True)
    t, y = arrays["time"], arrays["position"][:, 1, 1]
    period = 4 * math.sqrt(0.5 / G) * ellipk(math.sin(math.pi / 4) ** 2)
    low = t[1:-1][(y[1:-1] < y[:-2]) & (y[1:-1] <= y[2:])]
    assert len(low) > 5
    assert np.allclose(low, period * (np.arange(len(low)) + 0.5) / 2, atol=t[1] - t[0])
    # at the lowest point the bar carries three times the weight; energy goes to and fro
    assert arrays["member_force"].max() == pytest.approx(3 * 2 * G, rel=1e-2)
    energy = arrays["kinetic_energy"] + arrays["potential_energy"]
    assert np.ptp(energy) < 1e-9 * np.ptp(arrays["kinetic_energy"])


def test_drives_hold_still_or_are_free():
    model = pendulum(drives={"motor": kt.AngleDrive("b")})
    _, still, _ = let(model)
    assert np.ptp(still["position"], axis=0).max() < 1e-14
    assert still["drive_force"][0, 0] == pytest.approx(2 * G * 0.5)
    header, free, _ = let(model, held=False)
    assert header["drives"] == [{"name": "motor", "unit": "rad"}]
    _, alone, _ = let(pendulum())
    np.testing.assert_allclose(free["position"], alone["position"], atol=1e-9)
    np.testing.assert_allclose(free["drive_force"], 0, atol=1e-9)
    tip = free["position"][:, 1]
    np.testing.assert_allclose(np.sin(free["drive_position"][:, 0]), tip[:, 1] / 0.5, atol=1e-9)


def test_what_has_no_mass_is_said_and_a_motion_that_takes_long_is_shown_as_far_as_it_is(monkeypatch):
    model = pendulum().with_(nodes={"A": (0, 0), "B": (0.5, 0)})
    with pytest.raises(InputError, match="mass"):
        let(model)
    link = kt.Model(nodes={"A": (0, 0), "P": (0.3, 0), "B": (0.5, 0)}, fixed={"A": "xy"}, links={"l": ("A", "P", "B")})
    with pytest.raises(InputError, match="^Nodes ('[ABP]',? )+have no mass"):  # and none of the inner ones of the link
        let_go(link, compile(link).x0[:, :2], held=True)
    monkeypatch.setattr("kinetruss.studio.let_go.PATIENCE", -1.0)
    header, arrays, _ = let(pendulum())
    assert header["ends"][1] == (
        f"Shown up to {arrays['time'][-1]:.4g} s: this motion takes long to compute. A run of its own goes on."
    )


def played(model: kt.Model, **asked_for):
    """A drawing that was let go, and its motion."""
    desk = drawing(model)
    answer = asked(desk, do="let_go", **asked_for)
    assert isinstance(answer, bytes), answer
    return desk, unpacked(answer)[1]


def test_a_pose_of_what_falls_is_drawn_with_its_lengths_and_dimensions_and_is_undone():
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2), "C": kt.Node(at=(0.9, 0.3), mass=1)}, fixed={"A": "xy"},
        bars={"b": ("A", "B"), "c": kt.Bar(ends=("B", "C"), length=0.5)}, gravity=(0, -G),
    )  # fmt: skip
    desk, arrays = played(model)
    asked(desk, do="dimension", nodes=["A", "C"])
    before, sample = desk.data, 200
    answer = asked(desk, do="put", sample=sample)
    assert (answer["kind"], answer["undo"], answer["nodes"]) == ("drawing", "the pose that was let go", ["A", "B", "C"])
    np.testing.assert_allclose(answer["places"], arrays["position"][sample], atol=1e-6)
    places = np.array([node.at for node in desk.model.nodes.values()])
    assert (places[0] == 0).all()
    assert np.linalg.norm(places[1]) == pytest.approx(0.5, rel=1e-9)
    assert np.linalg.norm(places[2] - places[1]) == pytest.approx(0.5, rel=1e-9)
    assert desk.drawing.state.dimensions == (("nodes", ("A", "C")),)
    assert asked(desk, do="put", sample=sample)["message"] == "The motion is not known any more. Play it again."
    asked(desk, do="undo")
    assert desk.data == before


def test_springs_keep_their_free_length_and_angle_where_a_pose_is_kept():
    rod = {"section": kt.Rod(diameter=0.005), "material": "steel_s235"}
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2), "C": (0.5, 0.5), "D": (0.9, 0.1)},
        fixed={"A": "xy", "C": "xy", "D": "xy"},
        bars={
            "b": ("A", "B"), "spring": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=40.0),
            "tight": kt.Bar(ends=("B", "D"), kind="elastic", stiffness=30.0, pretension=3.0),
            "heavy": kt.Bar(ends=("B", "D"), kind="free", **rod),
        },
        springs={"hinge": kt.Spring(coordinate=kt.AngleDrive("b"), stiffness=1.5)}, gravity=(0, -G),
    )  # fmt: skip
    desk, arrays = played(model)
    sample = int(np.argmin(arrays["position"][:, 1, 1]))
    answer = asked(desk, do="put", sample=sample)
    assert answer["kind"] == "drawing", answer
    B = np.array(desk.model.nodes["B"].at)
    angle = math.atan2(B[1], B[0])
    assert angle < -0.3
    far = math.hypot(0.4, 0.1)
    assert desk.model.bars["spring"].natural_length == pytest.approx(0.5, rel=1e-12)
    assert desk.model.bars["tight"].natural_length == pytest.approx(far - 3 / 30, rel=1e-12)
    assert desk.model.bars["tight"].pretension is None
    assert desk.model.springs["hinge"].rest == 0.0
    assert desk.model.bars["heavy"].mass == pytest.approx(far * 7850 * math.pi * 0.0025**2, rel=1e-9)
    # moments about A of what pulls at B, and of the hinge: the acceleration of the pose at rest, by hand
    pull = np.zeros(2)
    for end, stiffness, free in (((0.5, 0.5), 40, 0.5), ((0.9, 0.1), 30, far - 0.1)):
        way = np.array(end) - B
        pull += stiffness * (np.linalg.norm(way) - free) * way / np.linalg.norm(way)
    across = np.array([-B[1], B[0]]) / 0.5
    mass = desk.model.bars["heavy"].mass  # a uniform bar about D: half its weight and a third of its mass are at B
    still = kt.dynamics.simulate(desk.model, 1e-6, samples=2).motion.acceleration.values[0, 1]
    assert still @ B == pytest.approx(0, abs=1e-9)
    force = (pull + np.array([0, -G]) * (2 + mass / 2)) @ across - 1.5 * angle / 0.5
    assert still @ across == pytest.approx(force / (2 + mass / 3), rel=1e-6)


def test_a_pose_in_which_a_part_would_push_otherwise_is_refused_and_so_is_one_of_a_sweep():
    sprung = pendulum(supports={"B": kt.Support(y=50.0)})
    desk, arrays = played(sprung)
    before = desk.data
    sample = int(np.argmin(arrays["position"][:, 1, 1]))
    answer = asked(desk, do="put", sample=sample)
    assert answer["kind"] == "error"
    assert answer["message"].startswith("This pose is not kept: drawn so, parts that bend or stretch would have other forces")
    assert desk.data is before
    assert "not understood" in asked(desk, do="put")["message"]
    assert "not known" in asked(desk, do="put", sample=4000)["message"]
    driven = drawing(pendulum(drives={"motor": kt.AngleDrive("b")}))
    assert isinstance(asked(driven, do="sweep", drives=["motor"]), bytes)
    assert asked(driven, do="put", sample=3)["message"] == "Keep a pose of this motion by the values of its drives."


def test_a_drive_that_was_let_go_is_drawn_with_the_value_that_it_has_then():
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(1, 0.2), mass=5), "C": (0.3, -0.5)}, fixed={"A": "xy", "C": "xy"},
        bars={"boom": ("A", "B"), "jack": kt.Bar(ends=("C", "B"), kind="driven", length=math.hypot(0.7, 0.7))},
        gravity=(0, -G),
    )  # fmt: skip
    desk, arrays = played(model, held=False)
    asked(desk, do="put", sample=40)
    places = np.array([node.at for node in desk.model.nodes.values()])
    assert np.linalg.norm(places[1]) == pytest.approx(math.hypot(1, 0.2), rel=1e-12)
    length = np.linalg.norm(places[1] - places[2])
    assert desk.model.bars["jack"].length == pytest.approx(length, rel=1e-12)
    assert length == pytest.approx(arrays["drive_position"][40, 0], rel=1e-6)
    assert abs(length - math.hypot(0.7, 0.7)) > 0.01
