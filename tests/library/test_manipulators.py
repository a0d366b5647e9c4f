"""Examples whose drives bring a platform or a hook to a place: docking with eighteen drives, a crane that gives way."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.library import example_files

HOOK = "B5.N8"


def read(name):
    model = kt.read(example_files()[name][0])
    return model, next(iter(model.runs.values()))


@pytest.fixture(scope="module")
def docked():
    model, run = read("docking")
    return model, run.targets, kt.kinematics.inverse(model, run.targets, samples=run.samples)


def frame(places, drawn):
    """Centroid and rotation matrix of three points from where they are drawn: frames by Gram and Schmidt, no angles."""

    def axes(points):
        first, second = points[1] - points[0], points[2] - points[0]
        one = first / np.linalg.norm(first)
        three = np.cross(first, second) / np.linalg.norm(np.cross(first, second))
        return np.stack([one, np.cross(three, one), three], axis=1)

    return places.mean(axis=0), axes(places) @ axes(drawn).T


def turned(roll, pitch, yaw):
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (a, b, c), (d, e, f) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    about_x = np.array([[1, 0, 0], [0, a, -d], [0, d, a]])
    about_y = np.array([[b, 0, e], [0, 1, 0], [-e, 0, b]])
    about_z = np.array([[c, -f, 0], [f, c, 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


@pytest.mark.slow
@pytest.mark.parametrize("held", [(), ("B3.M9",), ("B1.M7", "B4.M11")])
def test_lengths_of_the_end_dock(docked, held):
    """Forward after inverse: the eighteen lengths alone, put into the model, bring the platform to the port."""
    model, task, motion = docked
    motion = kt.kinematics.inverse(model, task.with_(hold=held), samples=31) if held else motion
    ends = dict(zip(motion.drive_position.drive.values.tolist(), motion.drive_position.values[-1].tolist(), strict=True))
    found = dict(zip(model.nodes, kt.kinematics.assemble(model, lengths=ends), strict=True))
    drawn = np.array([model.nodes[name].at for name in task.platform])
    place, turn = frame(np.array([found[name] for name in task.platform]), drawn)
    np.testing.assert_allclose(place, [0.2, -0.8, 5.75], rtol=0, atol=1e-9)
    np.testing.assert_allclose(turn, turned(*np.radians([-11.3344, 23.8335, 12])), rtol=0, atol=1e-9)
    for name in held:
        np.testing.assert_allclose(motion.drive_position.sel(drive=name).values, ends[name], rtol=0, atol=1e-12)
    level = turn @ np.cross(drawn[1] - drawn[0], drawn[2] - drawn[0])
    assert np.linalg.norm(level[:2]) < 1e-6 * abs(level[2])


@pytest.mark.slow
def test_docking_keeps_strokes_and_takes_the_least_change(docked):
    """All drives stay 10 mm from the ends of their strokes; with a drive held, or another objective, lengths change by more."""
    model, task, motion = docked
    lengths = motion.drive_position
    assert len(lengths.drive) == 18
    least, most = model.active["B1.M7"].limits
    assert least + 0.01 < lengths.min() < lengths.max() < most - 0.01
    assert not motion.message and "Not checked without forces:" in motion.unchecked  # of motors; strokes and speeds are kept
    change = (lengths - lengths.isel(time=0)).values[-1]
    for other in (task.with_(hold=("B3.M9",)), task.with_(objective="stroke_ends")):
        again = kt.kinematics.inverse(model, other, samples=31).drive_position.sel(drive=lengths.drive)
        assert np.linalg.norm(again.values[-1] - lengths.values[0]) > np.linalg.norm(change)


@pytest.mark.slow
def test_a_push_on_the_docked_tool_is_held_by_the_base(docked):
    model, _, motion = docked
    rest = kt.statics.at_poses(model, motion.position.values[-1:], load_case="latching")
    np.testing.assert_allclose(rest.reaction.values[0].sum(axis=0), [0, 0, 300], atol=1e-9)
    for case in model.load_cases:
        forces = kt.dynamics.inverse(model, motion, load_case=case)
        assert kt.strength.check(model, forces).utilisation.max() < 0.7
        demand = kt.actuators.evaluate(model, motion, forces)
        assert not kt.actuators.exceeded(demand)
        assert demand.self_locking.all()


def mass(model, part, length):
    """Mass of a bar or rod, kg."""
    return (
        part.mass
        if part.mass is not None
        else model.materials[part.material].density * model.sections[part.section].area * length
    )


def weights(model, x):
    """Weight at each node at positions x, N. A rod of an active member is clamped at one end; its lever shares the rest."""
    gravity = np.array(model.gravity)
    drawn = {name: np.array(node.at) for name, node in model.nodes.items()}
    force = {name: node.mass * gravity for name, node in model.nodes.items()}
    for bar in model.bars.values():
        half = mass(model, bar, np.linalg.norm(drawn[bar.ends[1]] - drawn[bar.ends[0]])) / 2 * gravity
        force |= {end: force[end] + half for end in bar.ends}
    for member in model.active.values():
        a, b = member.ends
        along = x[b] - x[a]
        across = gravity - along * (along @ gravity) / (along @ along)
        for rod, near, far in ((member.base, a, b), (member.tube, b, a)):
            shared = mass(model, rod, rod.length) * rod.length / (2 * np.linalg.norm(along)) * across
            force[far] = force[far] + shared
            force[near] = force[near] + mass(model, rod, rod.length) * gravity - shared
    return {name: kt.NodalForce(node=name, force=tuple(one)) for name, one in force.items()}


def hangs(model, rigid, lengths, x):
    """From where the rigid crane has its hook to where it hangs on springs of the given natural lengths; weights as at x."""
    bars = {}
    for name, member in model.members.items():
        long = np.linalg.norm(rigid[member.ends[1]] - rigid[member.ends[0]])
        part = member.tube if name in model.active else member  # the weaker of the two rods
        stiffness = model.materials[part.material].E * model.sections[part.section].area / long
        bars[name] = kt.Bar(ends=member.ends, kind="elastic", stiffness=stiffness, natural_length=lengths.get(name, long))
    nodes = {name: tuple(at) for name, at in rigid.items()}
    springs = kt.Model(nodes=nodes, bars=bars, fixed=model.fixed, loads=weights(model, x))
    return kt.statics.equilibrium(springs).position.sel(node=HOOK).values - rigid[HOOK]


@pytest.mark.slow
def test_the_corrected_crane_is_where_the_rigid_one_would_be():
    """Another model, of springs with the corrected natural lengths, in equilibrium with large displacements."""
    model, run = read("space_crane")
    motion = kt.kinematics.inverse(model, run.targets, samples=3)
    forces = kt.statics.at_poses(model, motion.position.values)
    found = kt.flexible.corrected(model, forces, at=HOOK)
    lowered = kt.statics.deflection(model, forces).displacement.sel(node=HOOK).values
    least, most = model.active["B1.M7"].limits
    assert least < found.drive_length.min() < found.drive_length.max() < most
    for k, rigid in enumerate(motion.position.values):
        places = [dict(zip(model.nodes, x, strict=True)) for x in (rigid, rigid + found.displacement.values[k])]
        lengths = dict(zip(found.drive.values.tolist(), found.drive_length.values[k].tolist(), strict=True))
        before = hangs(model, places[0], {}, places[0])
        after = hangs(model, places[0], lengths, places[1])
        assert np.linalg.norm(before) > 0.015
        assert np.linalg.norm(lowered[k] - before) < 0.01 * np.linalg.norm(before)
        assert np.linalg.norm(after) < 1e-10
