"""Angles and slides of joints by name, along motions that were let go."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.library import joints
from kinetruss.library.mechanisms import delta

AXIS = np.array([0.0, 0.6, 0.8])
SHIFT = {"A": np.zeros(3), "B": np.array([1.2, 0.3, 0.1])}


def released(kind):
    """Two free bodies with a joint between them, thrown with some velocities, and what became of them."""
    nodes = {f"{b}{k}": tuple(SHIFT[b] + (np.eye(3)[k - 1] if k else 0.0)) for b in "AB" for k in range(4)}
    bodies = {b: kt.Body(nodes=[f"{b}{k}" for k in range(4)], mass=m) for b, m in (("A", 1.5), ("B", 2.0))}
    model = getattr(joints, kind)(kt.Model(nodes=nodes, bodies=bodies), "j", bodies=("A", "B"), at=(1.1, 0.2, 0.1), axis=AXIS)
    thrown = np.random.default_rng(3)
    model = model.with_(velocities={name: tuple(thrown.normal(size=3)) for name in nodes})
    return model, kt.dynamics.simulate(model, 1.0, samples=101).motion  # the slider would run out of its stroke at 1.5 s


def test_revolute_by_name_and_by_bodies_agree():
    model, motion = released("revolute")
    named, pair = kt.kinematics.joint(model, motion, "j"), kt.kinematics.joint(model, motion, "A", "B")
    sign = np.sign(named.angle_rate.values[0, 0] * pair.angle_rate.values[0])  # the hinge has an axis of its own order
    turned = named.angle.values[:, 0] - named.angle.values[0, 0]
    assert np.abs(turned).max() > 0.5
    assert np.abs(turned - sign * (pair.angle.values - pair.angle.values[0])).max() < 1e-8
    assert np.abs(named.angle_rate.values[:, 0] - sign * pair.angle_rate.values).max() < 1e-8
    assert np.abs(named.angle_acceleration.values[:, 0] - sign * pair.angle_acceleration.values).max() < 1e-6
    assert pair.play.values.max() < 1e-8


@pytest.mark.slow
def test_slide_of_a_prismatic_joint_is_what_the_bodies_do():
    model, motion = released("prismatic")
    found = kt.kinematics.joint(model, motion, "j")
    seen = kt.kinematics.pose(model, motion, "B", seen_from="A")
    path = seen.position.values - seen.position.values[0]
    along = path @ AXIS
    assert np.abs(path - along[:, None] * AXIS).max() < 1e-7
    assert np.abs(seen.angular_velocity.values).max() < 1e-7
    slide = found.slide.values - found.slide.values[0]
    assert np.abs(slide).max() > 0.05
    assert np.abs(np.abs(slide) - np.abs(along)).max() < 1e-7
    assert np.abs(np.abs(found.slide_rate.values) - np.abs(seen.velocity.values @ AXIS)).max() < 1e-7


@pytest.mark.slow
def test_joints_without_angle_are_told():
    model, motion = released("revolute")
    with pytest.raises(InputError, match="No joint called 'k'"):
        kt.kinematics.joint(model, motion, "k")
    with pytest.raises(InputError, match="without angle or slide"):
        kt.kinematics.joint(joints.weld(two_free(), "w", bodies=("A", "B"), at=(1.1, 0.2, 0.1)), motion, "w")


def two_free():
    nodes = {f"{b}{k}": tuple(SHIFT[b] + (np.eye(3)[k - 1] if k else 0.0)) for b in "AB" for k in range(4)}
    bodies = {b: kt.Body(nodes=[f"{b}{k}" for k in range(4)], mass=m) for b, m in (("A", 1.5), ("B", 2.0))}
    return kt.Model(nodes=nodes, bodies=bodies)


@pytest.mark.slow
def test_workspace_of_a_delta_ends_where_its_rods_do_not_reach():
    model = delta()
    u = np.linspace(-0.9, 0.9, 19)
    found = kt.kinematics.workspace(model, "Q", ("x", u), ("y", u))
    z = np.mean([model.nodes[f"P{k}{s}"].at[2] for k in (1, 2, 3) for s in "ab"])
    wanted = np.array([[_reaches(x, y, z, 0.0) for x in u] for y in u])
    sure = np.array([[_reaches(x, y, z, 0.02) == _reaches(x, y, z, -0.02) for x in u] for y in u])
    assert np.array_equal(found.reachable.values[sure], wanted[sure])
    assert 20 < wanted.sum() < wanted.size


def _reaches(x, y, z, margin):
    """Closed form: 2 L (a cos t - z sin t) = |d|^2 + L^2 - l^2 has a solution for every arm."""
    L, rod, base, side = 0.35, 0.8, 0.2, 0.09 * np.sqrt(3) / 2
    for azimuth in (0, 2 * np.pi / 3, 4 * np.pi / 3):
        c, s = np.cos(azimuth), np.sin(azimuth)
        radial, tangent = c * x + s * y + side - base, -s * x + c * y
        reach = np.hypot(radial, z)
        if abs((reach**2 + tangent**2 + L**2 - rod**2) / (2 * L * reach)) > 1 - margin:
            return False
    return True
