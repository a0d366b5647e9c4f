"""Inverse dynamics against the Newton-Euler form and against the bay-by-bay form."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from reference import newton_euler, recursive_bays, sections
from reference.octahedral import ACTIVE, BARS, Bay, quintic
from reference.of_model import external_forces, truss_of
from reference.taylor import Taylor

ROUNDING = 1e-12  # of the largest force
HEIGHT = 1.1218253458835146
GRAVITY = (1.0, -2.0, -9.81)


def constant(value: float) -> Taylor:
    return Taylor(np.array(value), np.array(0.0), np.array(0.0))


def chain_model(bays: int, tip_mass: float = 2.0, tip_force: tuple[float, float, float] = (3.0, -5.0, 46.0)) -> kt.Model:
    """The chain of the oracle as a model, with a pose a bay; names B1.M6, B1.N4."""
    bay = Bay()
    rest = recursive_bays.bay_motions(bay, [(constant(0.0), constant(0.0), constant(HEIGHT))] * bays)
    nodes, bars, active, poses = {}, {}, {}, {}
    low = {1: "N1", 2: "N2", 3: "N3"}
    for k, (x, _, _) in enumerate(rest):
        name = low | {number: f"B{k + 1}.N{number}" for number in range(4, 10)}
        nodes |= {name[i + 1]: kt.Node(at=tuple(x[i])) for i in range(9) if name[i + 1] not in nodes}
        bars |= {f"B{k + 1}.{m}": (name[a], name[b]) for m, (a, b) in BARS.items()}
        rods = {"base": {"mass": bay.rod_mass, "length": bay.rod_length}, "tube": {"length": bay.tube_length}}
        active |= {f"B{k + 1}.{m}": kt.Active(ends=(name[a], name[b]), **rods) for m, (a, b) in ACTIVE.items()}
        drives = tuple(f"B{k + 1}.{m}" for m in ("M7", "M9", "M11"))
        poses[f"pose{k + 1}"] = kt.GimbalPose(base=bay.base, longeron=bay.longeron, drives=drives)
        low = {1: name[7], 2: name[9], 3: name[8]}
    for tip in low.values():
        nodes[tip] = nodes[tip].with_(mass=tip_mass)
    return kt.Model(
        nodes=nodes, fixed=["N1", "N2", "N3"], bars=bars, active=active, poses=poses, gravity=GRAVITY,
        section=kt.Tube(outer=bay.outer, inner=bay.inner), material=kt.Material(E=71e9, density=bay.density),
        loads={f"tip{i}": kt.NodalForce(node=node, force=tip_force) for i, node in enumerate(low.values())},
    )  # fmt: skip


def pose_quintic(model: kt.Model, ends: list[tuple[float, float, float]], duration: float = 2.0) -> kt.Quintic:
    """From upright to (beta, gamma, height) of every bay."""
    moves = {}
    for pose, (beta, gamma, height) in zip(model.poses, ends, strict=True):
        moves |= {f"{pose}.beta": (0.0, beta), f"{pose}.gamma": (0.0, gamma), f"{pose}.height": (HEIGHT, height)}
    return kt.Quintic(moves=moves, duration=duration)


def solved(model: kt.Model, motion) -> list[tuple]:
    """The oracle's solution at every sample of a product motion: (truss, (x, v, a), Solution)."""
    truss, external = truss_of(model), external_forces(model)
    histories = [motion.data[name].values for name in ("position", "velocity", "acceleration")]
    out = []
    for i in range(len(histories[0])):
        sample = tuple(history[i] for history in histories)
        out.append((truss, sample, newton_euler.solve(truss, *sample, external)))
    return out


def compare(model: kt.Model, motion, forces) -> None:
    """Joint forces, reactions, member forces, interface forces of every sample."""
    supports = list(forces.data["support"].values)
    nodes = [list(model.nodes).index(name) for name in supports]
    for i, (truss, sample, oracle) in enumerate(solved(model, motion)):
        largest = max(np.abs(oracle.force_a).max(), np.abs(oracle.force_b).max())
        joint = forces.joint_force.values[i]
        np.testing.assert_allclose(joint[:, 0], oracle.force_a, rtol=0, atol=ROUNDING * largest)
        np.testing.assert_allclose(joint[:, 1], oracle.force_b, rtol=0, atol=ROUNDING * largest)
        held = truss.supported[nodes]
        np.testing.assert_allclose(
            forces.reaction.values[i][held], oracle.reaction[nodes][held], rtol=0, atol=ROUNDING * largest
        )
        ends = np.stack(sections.end_tensions(truss, oracle, sample), 1)
        np.testing.assert_allclose(forces.end_force.values[i], ends, rtol=0, atol=ROUNDING * largest)
        mean = sections.mean_tension(truss, oracle, sample)
        np.testing.assert_allclose(forces.member_force.values[i], mean, rtol=0, atol=ROUNDING * largest)


@pytest.fixture(scope="module", params=[1, 2, 3])
def chain(request):
    model = chain_model(request.param)
    ends = [(0.17, -0.1, HEIGHT), (-0.05, 0.2, HEIGHT + 0.03), (0.12, 0.08, HEIGHT - 0.02)][: request.param]
    motion = kt.kinematics.follow(model, pose_quintic(model, ends), samples=6)
    return model, ends, motion, kt.dynamics.inverse(model, motion)


@pytest.mark.slow
def test_chain_agrees_with_newton_euler(chain):
    model, _, motion, forces = chain
    compare(model, motion, forces)


@pytest.mark.slow
def test_statics_agree_with_newton_euler(chain):
    model, _, motion, forces = chain
    still = kt.kinematics.from_arrays(
        model, motion.data["time"].values, motion.position.values, *([np.zeros_like(motion.velocity.values)] * 2)
    )
    compare(model, still, forces.static)


@pytest.mark.slow
def test_chain_agrees_with_bay_by_bay_form(chain):
    model, ends, motion, forces = chain
    nodes = list(model.nodes)
    order = [nodes.index(f"N{n}") for n in (1, 2, 3)]
    order += [nodes.index(f"B{k + 1}.N{n}") for k in range(len(ends)) for n in range(4, 10)]
    tip = np.tile([3.0, -5.0, 46.0], (3, 1))
    for i, t in enumerate(motion.data["time"].values):
        poses = [(quintic(t, 2.0, 0, b), quintic(t, 2.0, 0, g), quintic(t, 2.0, HEIGHT, h)) for b, g, h in ends]
        motions = recursive_bays.bay_motions(Bay(), poses)
        for name, expected in zip(("position", "velocity", "acceleration"), recursive_bays.chain_motion(motions), strict=True):
            np.testing.assert_allclose(motion.data[name].values[i][order], expected, rtol=0, atol=2e-12)
        by_bay = recursive_bays.chain_forces(Bay(), motions, np.array(GRAVITY), 2.0, tip)
        expected = np.concatenate([np.stack([s.force_a, s.force_b], 1) for s in by_bay])
        names = [f"B{k + 1}.{m}" for k in range(len(ends)) for m in (*BARS, *ACTIVE)]
        joint = forces.joint_force.sel(member=names).values[i]
        np.testing.assert_allclose(joint, expected, rtol=0, atol=1e-11 * np.abs(expected).max())


@pytest.mark.slow
def test_renumbered_chain_is_the_same_structure():
    model = chain_model(3)
    rng = np.random.default_rng(7)

    def shuffled(table: dict) -> dict:
        names = list(table)
        rng.shuffle(names)
        return {name: table[name] for name in names}

    mixed = model.with_(nodes=shuffled(model.nodes), bars=shuffled(model.bars), active=shuffled(model.active))
    ends = [(0.17, -0.1, HEIGHT), (-0.05, 0.2, HEIGHT), (0.12, 0.08, HEIGHT)]
    results = []
    for one in (model, mixed):
        motion = kt.kinematics.follow(one, pose_quintic(one, ends), samples=4)
        forces = kt.dynamics.inverse(one, motion, static=False)
        compare(one, motion, forces)
        results.append(forces)
    straight = results[0].joint_force
    other = results[1].joint_force.sel(member=straight["member"])
    np.testing.assert_allclose(other, straight, rtol=0, atol=1e-11 * float(np.abs(straight).max()))


angles = st.floats(-0.25, 0.25)
heights = st.floats(0.95, 1.1)  # higher up, a tilted bay is out of reach


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(st.lists(st.tuples(angles, angles, heights), min_size=2, max_size=2), st.floats(0.5, 5.0))
def test_random_poses_agree_with_newton_euler(ends, duration):
    model = chain_model(2)
    motion = kt.kinematics.follow(model, pose_quintic(model, ends, duration), times=np.array([0.3, 0.62, 0.9]) * duration)
    compare(model, motion, kt.dynamics.inverse(model, motion, static=False))


@pytest.mark.slow
def test_planar_truss_with_rotary_inertia_and_its_own_load_gravity():
    tube = kt.Tube(outer=0.0254, inner=0.022225)
    model = kt.Model(
        nodes={"O2": (0, 0), "O1": (2, 0), "B": kt.Node(at=(1.6, 1.7), mass=10.0, gravity=(0.5, -3.0))},
        fixed=["O1", "O2"],
        bars={"follower": kt.Bar(ends=("O1", "B"), rotary_inertia=True)},
        active={"drive": kt.Active(ends=("O2", "B"), base={"mass": 2.4, "length": 2.1, "section": tube, "rotary_inertia": True},
                                   tube={"length": 2.0, "rotary_inertia": True})},
        section=tube, material=kt.Material(E=71e9, density=2711.5), gravity=(0.0, -9.81),
    )  # fmt: skip
    start = math.hypot(1.6, 1.7)
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"drive": (start, start + 0.9)}, duration=0.8), samples=7)
    compare(model, motion, kt.dynamics.inverse(model, motion))


@pytest.mark.slow
def test_turned_crank_and_pushed_slider():
    rod = kt.Material(E=200e9, density=7850.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.1, 0.2), "C": kt.Node(at=(0.6, 0.1), mass=1.5), "D": (0.9, -0.2)},
        fixed={"A": "xy", "D": "y"},
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "link": ("C", "D")},
        section=kt.Rod(diameter=0.02), material=rod, gravity=(0.0, -9.81),
        drives={"motor": kt.AngleDrive("crank"), "slide": kt.CoordinateDrive(node="D", axis="x")},
    )  # fmt: skip
    angle = math.atan2(0.2, 0.1)
    moves = {"motor": (angle, angle - 0.6), "slide": (0.9, 0.95)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=5)
    forces = kt.dynamics.inverse(model, motion, static=False)
    compare(model, motion, forces)
    for i, (_, _, oracle) in enumerate(solved(model, motion)):
        largest = np.abs(oracle.force_b).max()
        np.testing.assert_allclose(forces.drive_force.sel(drive="motor").values[i], oracle.torque[0], atol=ROUNDING * largest)
        np.testing.assert_allclose(forces.drive_force.sel(drive="slide").values[i], oracle.push[0], atol=ROUNDING * largest)


@pytest.mark.slow
def test_interface_between_base_and_tube():
    model = chain_model(1)
    motion = kt.kinematics.follow(model, pose_quintic(model, [(0.2, -0.15, HEIGHT)], 1.0), samples=5)
    forces = kt.dynamics.inverse(model, motion, static=False)
    names = list(model.members)
    for i, (truss, sample, oracle) in enumerate(solved(model, motion)):
        largest = np.abs(oracle.force_b).max()
        for name in model.active:
            force, moment = sections.interface(truss, names.index(name), oracle, sample)
            found = forces.interface_force.sel(active=name).values[i]
            turning = forces.interface_moment.sel(active=name).values[i]
            u = newton_euler.axis_motion(truss.members[names.index(name)], *sample)[2]
            assert found[0] == pytest.approx(force @ u, abs=ROUNDING * largest)
            # the shears and moments are in member axes: their size does not depend on how these are turned
            assert np.hypot(*found[1:]) == pytest.approx(np.linalg.norm(force - (force @ u) * u), abs=ROUNDING * largest)
            assert np.hypot(*turning) == pytest.approx(np.linalg.norm(moment), abs=ROUNDING * largest)
