"""Cuts through welds, and free bodies and labelled equations with hinges, couplings, membranes and solids."""

import numpy as np
import pytest

import kinetruss as kt
from hinge_models import Arm, DoublePendulum
from kinetruss.errors import InputError
from kinetruss.mechanics import compile

G = 9.81
JOINTS, BODIES = kt.library.joints, kt.library.bodies


def standing(model):
    at = np.array([node.at for node in model.nodes.values()])[None]
    motion = kt.kinematics.from_arrays(model, [0.0], at, 0 * at, 0 * at)
    return motion, kt.dynamics.inverse(model, motion)


def cantilever(order=("a", "b"), size=None):
    """Two boxes of 1 m welded to each other and to the ground."""
    grounds = {"O": (0, 0, 0), "E": (0, 0.3, 0), "F": (0, 0, 0.3), "H": (-0.2, 0.1, 0.1)}
    model = kt.Model(nodes=grounds, fixed=list(grounds), gravity=(0, 0, -G))
    made = {"a": (4.0, 0.5), "b": (3.0, 1.5)}
    for name in order:
        mass, middle = made[name]
        model = BODIES.rigid(model, name, BODIES.box_properties((1.0, 0.2, 0.1), mass=mass, at=(middle, 0, 0)))
    model = JOINTS.weld(model, "root", bodies=("ground", "a"), at=(0, 0, 0))
    return JOINTS.weld(model, "mid", bodies=order, at=(1, 0, 0), size=size)


@pytest.mark.slow
@pytest.mark.parametrize("order", [("a", "b"), ("b", "a")])
@pytest.mark.parametrize("size", [None, 0.3])
def test_welds_of_a_cantilever_carry_what_hangs_on_them(order, size):
    model = cantilever(order, size)
    _, forces = standing(model)
    for body, at, mass, middle in (("b", "mid", 3.0, 1.5), ("b", "a", 3.0, 1.5), ("a", "root", 7.0, (4 * 0.5 + 3 * 1.5) / 7)):
        found = kt.dynamics.joint_reaction(model, forces, body, at, point="O")
        np.testing.assert_allclose(found.force.values, [[0, 0, mass * G]], atol=1e-11)
        np.testing.assert_allclose(found.moment.values, [[0, -mass * G * middle, 0]], atol=1e-11)
        assert found.attrs["unique"] == 1
    other = kt.dynamics.joint_reaction(model, forces, "a", "mid", point="O")
    np.testing.assert_allclose(other.force.values, [[0, 0, -3 * G]], atol=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("order", [("a", "b"), ("b", "a")])
def test_the_weld_of_a_swinging_pendulum(order):
    """Two welded planar bodies let go level: F = m (a - g), M = I alpha about the second's centre, by the compound pendulum."""
    m1, c1, I1, m2, c2, I2 = 2.0, 0.4, 0.1, 1.5, 1.3, 0.2
    model = kt.Model(nodes={"O": (0, 0)}, fixed=["O"], gravity=(0, -G))
    given = {"a": ((m1, (c1, 0), I1), {"nodes": ["O"]}), "b": ((m2, (c2, 0), I2), {})}
    for name in order:
        (mass, center, inertia), more = given[name]
        model = BODIES.rigid(model, name, mass=mass, center=center, inertia=inertia, **more)
    model = JOINTS.weld(model, "w", bodies=order, at=(0.9, 0))
    run = kt.dynamics.simulate(model, 0.5, samples=6, method=kt.DOP853(rtol=1e-11, atol=1e-12))
    found = kt.dynamics.joint_reaction(model, run, "b", "w")
    pose = kt.kinematics.pose(model, run.motion, "b")
    angle = pose.angle.values - pose.angle.values[0]
    whole, arm = I1 + m1 * c1**2 + I2 + m2 * c2**2, m1 * c1 + m2 * c2
    rate2, alpha = -2 * arm * G * np.sin(angle) / whole, -arm * G * np.cos(angle) / whole
    along, across = np.stack([np.cos(angle), np.sin(angle)], 1), np.stack([-np.sin(angle), np.cos(angle)], 1)
    force = m2 * (c2 * (alpha[:, None] * across - rate2[:, None] * along) + [0, G])
    middle = run.motion.data["position"].sel(node=found.attrs["nodes"]).values.mean(axis=1)
    r = c2 * along - middle
    moment = I2 * alpha + r[:, 0] * force[:, 1] - r[:, 1] * force[:, 0]
    np.testing.assert_allclose(found.force.values, force, atol=1e-8)
    np.testing.assert_allclose(found.moment.values[:, 0], moment, atol=1e-8)


@pytest.mark.slow
def test_a_loop_of_welds_is_told_as_undetermined():
    """Held at both ends the beam is statically indeterminate, whatever bars were saved; a sum over its ends is not."""
    model = JOINTS.weld(cantilever(), "end", bodies=("b", "ground"), at=(2, 0, 0))
    _, forces = standing(model)
    cuts = (("a", "root"), ("b", "mid"), ("b", "end"))
    found = [kt.dynamics.joint_reaction(model, forces, *cut, point="O") for cut in cuts]
    assert [one.attrs["unique"] for one in found] == [0, 0, 0]
    assert "do not determine force and moment" in found[1].attrs["message"]
    np.testing.assert_allclose(found[0].force.values + found[2].force.values, [[0, 0, 7 * G]], atol=1e-10)
    hinged = JOINTS.revolute(cantilever(), "end", bodies=("b", "ground"), at=(2, 0, 0), axis="y")
    assert kt.dynamics.joint_reaction(hinged, standing(hinged)[1], "b", "mid").attrs["unique"] == 0


def test_a_cut_through_part_of_a_common_edge_is_refused():
    nodes = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1), "P": (1, 1, 1), "Q": (2, 1, 0)}
    bodies = {"a": kt.Body(nodes=("O", "X", "Y", "Z"), mass=1.0), "b": kt.Body(nodes=("X", "Y", "P", "Q"), mass=1.0)}
    model = kt.Model(nodes=nodes, fixed=["O"], bodies=bodies)
    _, forces = standing(model)
    with pytest.raises(InputError, match=r"share X, Y, so a bar between these belongs to both; X cuts it. Name all of them"):
        kt.dynamics.joint_reaction(model, forces, "a", ["X"])


def closes(model, motion, forces, time):
    system = kt.dynamics.newton_euler(model, motion, forces, time=time)
    assert system.unique
    assert system.residual < 1e-11 * system.largest
    assert system.difference < 1e-12 * system.largest * system.condition
    for node in model.whole.nodes:
        found = kt.dynamics.free_body(model, motion, forces, node=node, time=time)
        assert found.residual < 1e-11 * system.largest
    for member in model.whole.members:
        found = kt.dynamics.free_body(model, motion, forces, member=member, time=time)
        assert found.residual < 1e-11 * system.largest
    return system


@pytest.mark.slow
@pytest.mark.parametrize("source", [Arm, DoublePendulum])
def test_hinges_stand_in_the_equations(source):
    model = source().model()
    start = compile(model).drive_start
    moves = {drive: (start[k], start[k] + 0.6 - 0.2 * k) for k, drive in enumerate(model.drives)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), times=[0.0, 0.3])
    forces = kt.dynamics.inverse(model, motion)
    system = closes(model, motion, forces, 0.3)
    assert system.matrix.shape[0] == system.matrix.shape[1]
    assert "elbow torque" in system.unknowns
    value = dict(zip(system.unknowns, system.solution, strict=True))
    assert value["elbow torque"] == pytest.approx(forces.drive_force.sel(time=0.3, drive="elbow").item(), rel=1e-11)
    for end in ("O", "P") if source is Arm else ("A", "C"):  # it turns one bar and reacts on the other
        bars = [name for name, bar in model.bars.items() if end in bar.ends and set(bar.ends) & set(model.drives["elbow"].axis)]
        for name in bars:
            turned = kt.dynamics.free_body(model, motion, forces, member=name, time=0.3).bodies[0]
            assert "drive elbow" in [term.source for term in turned.terms if term.symbol == "T"]


@pytest.mark.slow
def test_the_force_of_a_coupling_is_told():
    """A box that sinks on a screw: the coupling turns it by I times its angular acceleration, and closes in every equation."""
    mass, pitch = 3.0, 0.3
    model = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"], gravity=(0, 0, -G))
    model = BODIES.box(model, "b", (0.2, 0.2, 0.4), mass=mass)
    model = JOINTS.screw(model, "s", bodies=("ground", "b"), at=(0, 0, 0), axis="z", pitch=pitch)
    run = kt.dynamics.simulate(model, 0.2, samples=5, method=kt.DOP853(rtol=1e-11, atol=1e-12))
    inertia, k = mass * 0.08 / 12, 2 * np.pi / pitch
    turning = inertia * k * mass * G / (mass + inertia * k**2)
    (name,) = model.couplings
    np.testing.assert_allclose(np.abs(run.forces.coupling_force.sel(coupling=name)), turning, rtol=1e-9)
    assert f"{name} coupling" in closes(model, run.motion, run.forces, 0.15).unknowns
    np.testing.assert_array_equal(kt.dynamics.joint_reaction(model, run, "b", "s").coupling_force, run.forces.coupling_force)


@pytest.mark.slow
def test_the_guide_of_a_slider_is_its_couplings():
    """A block on an incline, held on it by two couplings: together they push it with m g cos(tilt) across the line."""
    tilt, mass = np.radians(30), 2.0
    along = (np.cos(tilt), np.sin(tilt))
    model = kt.Model(nodes={"O": (0, 0), "A": along}, fixed=["O", "A"], gravity=(0, -G))
    model = BODIES.rigid(model, "block", mass=mass, center=along, inertia=0.02)
    model = JOINTS.prismatic(model, "guide", bodies=("ground", "block"), at=along, axis=along, form="direct")
    run = kt.dynamics.simulate(model, 0.3, samples=4)
    found = kt.dynamics.joint_reaction(model, run, "block", "guide")
    np.testing.assert_allclose(found.coupling_force.values.sum(axis=1), mass * G * np.cos(tilt), rtol=1e-9)
    across = mass * G * np.cos(tilt) * np.array([-along[1], along[0]])
    np.testing.assert_allclose(found.force.values, np.tile(across, (4, 1)), atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("dim", [2, 3])
def test_membranes_and_solids_stand_in_the_equations(dim):
    """With them every node balances in motion and at rest; their own weight is in the supports."""
    material = kt.Material(E=1e6, poisson=0.3, density=1000.0)
    if dim == 2:
        grid = kt.library.meshes.rectangle(width=1.0, height=1.0, columns=2, rows=2)
        parts = {"membranes": {"skin": grid.membrane(thickness=0.01)}}
    else:
        grid = kt.library.meshes.box(size=(1.0, 0.5, 0.5), cells=(2, 1, 1))
        parts = {"solids": {"block": grid.solid()}}
    down = (0, -G, 0)[:dim]
    stay = kt.Bar(ends=(grid.names[-1], grid.names[-3]), kind="elastic", stiffness=1e3, mass=0.2)
    model = kt.Model(nodes=grid.nodes, fixed=grid.at(x=0.0), material=material, gravity=down, bars={"stay": stay}, **parts)
    run = kt.dynamics.simulate(model, 0.01, samples=3, method=kt.EnergyMomentum(step=1e-4))
    closes(model, run.motion, run.forces, 0.01)
    tip = kt.dynamics.free_body(model, run.motion, run.forces, node=grid.names[-1], time=0.01).bodies[0]
    assert "membranes and solids" in [term.source for term in tip.terms]
    rest = kt.statics.equilibrium(model)
    still = np.zeros((1, len(model.nodes), dim))
    motion = kt.kinematics.from_arrays(model, [0.0], rest.position.values[None], still, still)
    forces = kt.dynamics.inverse(model, motion)
    for node in model.nodes:
        assert kt.dynamics.free_body(model, motion, forces, node=node).residual < 1e-6
