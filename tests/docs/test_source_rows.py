"""Rows of docs/sources.md with inputs that no other test has, each against a closed form or another call.

Rows tried elsewhere: points of straining bodies and refused negative masses, tests/bodies/test_pose.py; slides at nodes of
bodies, tests/joints/test_joints.py; counts of the robot, the Delta and Andrews' mechanism and the printed numbers,
`kinetruss verify`; reach and objectives of tasks, tests/tasks; static runs by the command line, tests/runs/test_static_runs.py;
measured motions, tests/kinematics/test_measured.py and tests/runs/test_standard_errors.py; tables with fixed nodes,
tests/kinematics/test_from_csv.py; bridges, records and shear gauges, tests/strength/test_bridges_and_rosettes.py; couples of
screws, tests/joints/test_screw_torque.py; the numbers in docs/errata.md, test_sources.py.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

import kinetruss as kt
from kinetruss.library import bodies, cells, mechanisms

LIGHT = kt.Material(E=200e9, density=0.0, poisson=0.3)
TOP = ("N7", "N9", "N8")


def at_rest(model: kt.Model, x: NDArray[np.float64] | None = None) -> kt.results.Motion:
    """One instant of the model as it stands, or with its nodes at x."""
    x = kt.kinematics.assemble(model) if x is None else x
    return kt.kinematics.from_arrays(model, [0.0], x[None], 0 * x[None], 0 * x[None])


def centroid(model: kt.Model, nodes: tuple[str, ...]) -> NDArray[np.float64]:
    """m."""
    return np.mean([model.nodes[name].at for name in nodes], axis=0)


# Truss elements: Meijaard.


def test_a_dilating_body_vibrates_on_its_bar():
    """k l^2/Ip, with Ip about the fixed end: every place moves in proportion to its distance from there."""
    k, l, m, e, f, inertia = 3e4, 1.3, 2.2, 0.4, -0.25, 0.35
    model = kt.Model(
        nodes={"p": (0, 0), "q": (l, 0)}, fixed={"p": "xy", "q": "y"},
        bars={"b": kt.Bar(ends=("p", "q"), kind="elastic", stiffness=k, mass=0)},
        bodies={"d": kt.Body(nodes=("p", "q"), kind="straining", mass=m, center=(e, f), inertia=inertia)},
    )  # fmt: skip
    omega = math.sqrt(k * l**2 / (inertia + m * (e**2 + f**2)))
    assert_allclose(kt.dynamics.linearise(model).angular_frequency, [omega], rtol=1e-9)


def test_a_sled_slides_down_its_inclined_line_from_a_node_of_its_own():
    c, s = math.cos(0.6), math.sin(0.6)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1), "X": (2 * c, 2 * s), "Y": (3, 0.3), "Z": (2, 2)}, fixed=["A", "B", "C"],
        bodies={
            "base": kt.Body(nodes=("A", "B", "C"), mass=1),
            "sled": kt.Body(nodes=("X", "Y", "Z"), mass=3, center=(2.2, 0.9), inertia=0.2),
        }, gravity=(0, -9.81),
    )  # fmt: skip
    joined = kt.library.joints.prismatic(model, "s", bodies=("base", "sled"), at="X", axis=(c, s), size=0.5, form="direct")
    moved = kt.dynamics.simulate(joined, 0.3).motion.position.sel(node=["X", "Y", "Z"]).values
    way = -9.81 * s * 0.3**2 / 2
    assert_allclose(moved[-1] - moved[0], np.tile([way * c, way * s], (3, 1)), atol=1e-11)


def test_ten_masses_of_a_body_are_its_mass_and_some_are_negative():
    points = np.array([[0.9, 0.1, 0], [-0.3, 1.1, 0.2], [0, -0.8, 0.4], [0.2, 0.3, 1.2]])
    found = bodies.bar_masses(points, 4.0, (0.3, 0.1, -0.2), (0.5, 0.6, 0.7))
    assert len(found.bars) == 6 and len(found.lumped) == 4
    assert min(*found.bars.values(), *found.lumped) < 0
    back = bodies.mass_properties(points, found.bars, found.lumped)
    assert back.mass == pytest.approx(4.0)
    assert_allclose(back.center, [0.3, 0.1, -0.2], atol=1e-13)
    assert_allclose(back.inertia, np.diag([0.5, 0.6, 0.7]), atol=1e-12)


def test_andrews_with_a_beam_has_nine_bars_and_the_motion_of_the_other_form():
    ten, nine = (mechanisms.andrews(form=form, torque=0.05, duration=0.02) for form in ("bars", "beam"))
    carrying = [name for name, bar in nine.bars.items() if bar.kind != "free"]
    assert (len(ten.bars), len(carrying), len(nine.beams)) == (10, 9, 1)
    assert sum(1 if node.scalar else 2 for node in nine.nodes.values()) == 19
    assert sum(len(axes) for axes in nine.fixed.values()) == 8
    one, other = (kt.run(model, "spin").motion for model in (ten, nine))
    assert_allclose(other.position.sel(node=list(ten.nodes)), one.position, atol=1e-8)
    crank = one.position.sel(node="F").values - one.position.sel(node="O").values
    assert_allclose(other.position.sel(node="beta", axis="x"), np.unwrap(np.arctan2(*crank.T[::-1])), atol=1e-6)


def test_andrews_in_the_conventional_form_has_eleven_beams_and_31_coordinates():
    ten, eleven = (mechanisms.andrews(form=form, torque=0.05, duration=0.02) for form in ("bars", "conventional"))
    assert (len(eleven.beams), len(eleven.bars)) == (11, 1)
    assert sum(1 if node.scalar else 2 for node in eleven.nodes.values()) == 31
    assert sum(len(axes) for axes in eleven.fixed.values()) == 8
    one, other = (kt.run(model, "spin").motion for model in (ten, eleven))
    assert_allclose(other.position.sel(node=list(ten.nodes)), one.position, atol=1e-8)


# What the structure can be: Lacy.


@pytest.mark.parametrize(("kind", "nodes"), [("tetrahedron", 4), ("octahedron", 6), ("decahedron", 7)])
def test_cells_of_equal_edges_are_rigid_without_a_member_too_many(kind, nodes):
    model = cells.stack([getattr(cells, kind)()])
    edges = [np.linalg.norm(np.subtract(*(model.nodes[end].at for end in bar.ends))) for bar in model.bars.values()]
    assert (len(model.nodes), len(edges)) == (nodes, 3 * nodes - 6)
    assert_allclose(edges, edges[0], rtol=1e-12)
    assert kt.kinematics.mobility(model).degrees_of_freedom == 0


@pytest.mark.parametrize("pose", [(0.25, -0.3, 2.0), (-0.4, 0.1, 1.7)])
def test_the_closed_form_of_the_quadruple_octahedron_is_its_pose(pose):
    cell = cells.quadruple_octahedron(base=1.1, longeron=0.85, base_length=0.1, tube_length=0.1)
    model = cells.stack([cell])
    lengths = kt.kinematics.chain_lengths(1.1, 0.85, *pose, bays=2)
    still = at_rest(model, kt.kinematics.assemble(model, dict(zip(model.active, lengths.tolist(), strict=True))))
    found = kt.kinematics.platform(model, still, tuple(f"H2.{name}" for name in TOP))
    assert [found.beta.item(), found.gamma.item()] == pytest.approx(pose[:2], abs=1e-12)
    assert np.linalg.norm(found.centroid.values) == pytest.approx(pose[2], abs=1e-12)


def test_an_elastic_hinge_with_damping_passes_its_moment():
    k, c, m, l = 12.0, 0.3, 1.5, 0.7
    model = kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "P": kt.Node(at=(l, 0), mass=m)}, fixed=["O", "G"],
        bars={"arm": kt.Bar(ends=("O", "P"), mass=0)}, loads={"push": kt.NodalForce(node="P", force=(0, 0.9))},
        springs={"hinge": kt.Spring(coordinate=kt.HingeDrive(axis="O", start="G", end="P"), stiffness=k, damping=c)},
    )  # fmt: skip
    found = kt.dynamics.linearise(model.with_(loads={}))
    assert_allclose(found.angular_frequency, [math.sqrt(k / m) / l], rtol=1e-9)
    assert_allclose(found.pole_real, -c / (2 * m * l**2), rtol=1e-9)
    moved = kt.statics.equilibrium(model).position.sel(node="P").values
    angle = math.atan2(moved[1], moved[0])
    assert k * angle == pytest.approx(0.9 * l * math.cos(angle), rel=1e-8)


def test_a_beam_in_space_bends_about_both_axes():
    L, P = 0.8, 13.0
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (L, 0, 0)}, clamped=["A"], beams={"b": kt.Beam(ends=("A", "B"), orientation=(0, 0, 1))},
        section=kt.Rectangle(width=0.02, height=0.01), material=LIGHT, loads={"p": kt.NodalForce(node="B", force=(0, P, P))},
    )  # fmt: skip
    found = kt.statics.linear(model).displacement.sel(node="B").values
    soft, stiff = (P * L**3 / (3 * 200e9 * i) for i in (0.02 * 0.01**3 / 12, 0.01 * 0.02**3 / 12))
    assert sorted(found) == pytest.approx([0.0, stiff, soft], rel=1e-9, abs=1e-12)


def test_the_truss_damps_a_flexible_beam_on_its_platform():
    """Held drives: a clamped beam. Fed back through them all comes to rest but its twist: a bay cannot turn its top."""
    bay = kt.library.vgt.double_octahedral(gravity=(0, 0, 0))
    foot = centroid(bay, TOP)
    tip, apex = (tuple(np.add(foot, (0, 0, z))) for z in (1.2, -0.4))
    section, alloy = kt.Rectangle(width=0.01, height=0.01), kt.Material(E=70e9, density=2700)
    model = bay.with_(
        nodes=dict(bay.nodes) | {"R": tuple(foot), "S": tip, "P": apex},
        bodies={"plate": kt.Body(nodes=(*TOP, "P", "R"), mass=1.0, center=tuple(foot), inertia=(0.1, 0.1, 0.2))},
        clamped={"R": "plate"}, beams={"antenna": kt.Beam(ends=("R", "S"), section=section, material=alloy)},
    )  # fmt: skip
    held = kt.dynamics.linearise(model, tasks={name: kt.Hold() for name in model.all_drives})
    exact = 1.875104**2 / (2 * math.pi * 1.2**2) * math.sqrt(70e9 * 0.01**2 / (12 * 2700))
    assert_allclose(held.frequency.values[:2], exact, rtol=6e-3)
    free = kt.dynamics.linearise(model, inputs=tuple(model.all_drives), tasks={name: kt.Free() for name in model.all_drives})
    assert free.pole_real.max() > -1e-6
    fed = kt.dynamics.feedback(free, state_cost=np.eye(2 * len(free.dof)))
    poles = np.linalg.eigvals(free.A.values - free.B.values @ fed.gains.values)
    *others, twist, _ = sorted(poles, key=lambda pole: float(pole.real))
    assert max(pole.real for pole in others) < -0.1
    assert_allclose(np.sort(fed.pole_real.values), np.sort(poles.real), atol=1e-6)
    shear, ratio = 70e9 / (2 * (1 + alloy.poisson)), 6 * section.torsion_constant / 0.01**4
    assert abs(twist) == pytest.approx(math.sqrt(3 * ratio * shear / 2700) / 1.2, rel=1e-3)


def test_lengths_of_a_crane_are_corrected_for_their_own_elongation():
    """Each length is less by N l/EA, and elastic bars of these natural lengths carry the load where it was to be."""
    model = kt.Model(
        nodes={"A": (-1, 0), "B": (1, 0), "C": kt.Node(at=(0.2, 1.5), mass=40)}, fixed=["A", "B"], gravity=(0, -9.81),
        bars={name: kt.Bar(ends=(name.upper(), "C"), kind="driven", mass=0) for name in "ab"},
        section=kt.Rod(diameter=0.01), material=kt.Material(E=1e9, density=0.0),
    )  # fmt: skip
    forces = kt.statics.at_poses(model, [{}])
    found = kt.flexible.corrected(model, forces, ("C.x", "C.y"))
    N, l, EA = forces.member_force.values[0], np.hypot([1.2, 0.8], 1.5), 1e9 * math.pi * 1e-4 / 4
    assert_allclose(found.change.values[0], -N * l / EA, rtol=1e-9)
    elastic = {
        name: bar.with_(kind="elastic", stiffness=EA / l[k], natural_length=l[k] + float(found.change[0, k]))
        for k, (name, bar) in enumerate(model.bars.items())
    }
    assert_allclose(kt.statics.equilibrium(model.with_(bars=elastic)).position.sel(node="C"), [0.2, 1.5], atol=1e-10)


def test_offset_joints_bend_what_is_clamped_to_the_hub():
    """A tie that pulls beside the end of a clamped column: the moment there is its force times its distance."""
    model = kt.Model(
        nodes={"O": (0, 0), "B": (0, 1.0), "C": (0.9, 0), "D": (-0.5, 0)}, fixed=["O", "C", "D"],
        bars={"column": ("O", "B"), "tie": ("B", "C")}, section=kt.Rod(diameter=0.02), material=LIGHT,
        loads={"push": kt.NodalForce(node="B", force=(-300, 0))},
        hubs={"B": kt.Hub(arms={"tie": (0.06, 0.08)}, clamped=["column"])},
    )  # fmt: skip
    forces = kt.statics.at_poses(model, [{}])
    tip, foot = np.array([0.06, 1.08]), np.array([0.9, 0.0])
    along = (foot - tip) / np.linalg.norm(foot - tip)
    # moments about O of the push and of the pull of the tie at its tip
    pull = 300 * 1.0 / -(tip[0] * along[1] - tip[1] * along[0])
    assert float(forces.member_force.sel(member="tie").item()) == pytest.approx(pull, rel=1e-9)
    M = kt.strength.sections(model, forces, 2).data.section_M.squeeze("moment").isel(time=0)
    couple = abs(pull * (0.06 * along[1] - 0.08 * along[0]))
    assert abs(M.sel(part="column", station=1).item()) == pytest.approx(couple, rel=1e-9)
    assert abs(M.sel(part="B.tie", station=0).item()) == pytest.approx(couple, rel=1e-9)


# Tasks and motion: Lacy.


def test_the_centroid_of_one_bay_is_placed_by_its_three_drives():
    model = kt.library.vgt.double_octahedral()
    wanted = np.add(centroid(model, TOP), (0.11, -0.07, 0.05))
    motion = kt.kinematics.inverse(model, kt.Positioning(nodes=TOP, moves=dict(zip("xyz", wanted.tolist(), strict=True))))
    lengths = dict(zip(model.all_drives, motion.drive_position.values[-1].tolist(), strict=True))
    there = dict(zip(model.nodes, kt.kinematics.assemble(model, lengths), strict=True))
    assert_allclose(np.mean([there[name] for name in TOP], axis=0), wanted, atol=1e-10)


def test_two_bays_aim_their_mirror_with_its_height_free():
    """Four coordinates: two of the place, two of the direction; the normal halves the angle of the rays."""
    model = kt.library.vgt.double_octahedral(bays=2)
    top = tuple(f"B2.{name}" for name in TOP)
    source, target = (3.0, 0.0, 8.0), (-2.0, 5.0, 9.0)
    task = kt.Reflecting(platform=top, source=source, target=target, free=("z",), moves={"x": 0.2, "y": -0.1})
    motion = kt.kinematics.inverse(model, task)
    found = kt.kinematics.platform(model, motion, top)
    place = found.centroid.values[-1]
    rays = [np.subtract(end, place) / np.linalg.norm(np.subtract(end, place)) for end in (source, target)]
    assert_allclose(found.normal.values[-1], sum(rays) / np.linalg.norm(sum(rays)), atol=1e-10)
    assert_allclose(place[:2], [0.2, -0.1], atol=1e-10)


def test_docking_needs_more_than_two_bays_and_holds_what_it_is_told():
    two = kt.library.vgt.double_octahedral(bays=2)
    with pytest.raises(kt.InputError, match="cannot yaw.*rank 5"):
        kt.kinematics.inverse(two, kt.Docking(platform=tuple(f"B2.{name}" for name in TOP), moves={"x": 0.1, "yaw": 0.05}))
    three = kt.library.vgt.double_octahedral(bays=3)
    top = tuple(f"B3.{name}" for name in TOP)
    x = kt.kinematics.assemble(three, {"B1.M7": 1.1, "B2.M9": 1.25, "B3.M11": 1.08})
    bent = three.with_(nodes={name: node.with_(at=tuple(x[k])) for k, (name, node) in enumerate(three.nodes.items())})
    names = ("x", "y", "z", "roll", "pitch", "yaw")
    now = kt.kinematics.pose(bent, at_rest(bent, x), top)
    start = [*now.position.values[0], *now.euler.values[0][::-1]]
    wanted = np.add(start, [0.02, -0.03, 0.02, 0.02, -0.01, 0.01])
    task = kt.Docking(platform=top, moves=dict(zip(names, wanted.tolist(), strict=True)), hold=("B2.M9",))
    motion = kt.kinematics.inverse(bent, task, samples=21)
    there = kt.kinematics.pose(bent, motion, top)
    assert_allclose([*there.position.values[-1], *there.euler.values[-1][::-1]], wanted, atol=1e-9)
    assert np.ptp(motion.drive_position.sel(drive="B2.M9").values) == 0


@pytest.mark.parametrize("angle", [0.6, 1.4, 2.0])
def test_the_follower_turns_to_its_angle(angle):
    model = kt.library.vgt.triangular(base_length=0.9, tube_length=1.1)
    motion = kt.kinematics.inverse(model, kt.Coordinates(moves={"follower.angle": angle}))
    place = {name: motion.position.sel(node=name).values[-1] for name in model.nodes}
    assert np.arctan2(*(place["B"] - place["O1"])[::-1]) == pytest.approx(angle, abs=1e-10)
    ground, follower = np.linalg.norm(place["O1"] - place["O2"]), np.linalg.norm(place["B"] - place["O1"])
    exact = math.sqrt(ground**2 + follower**2 - 2 * ground * follower * math.cos(math.pi - angle))
    assert motion.drive_position.values[-1, 0] == pytest.approx(exact, abs=1e-10)


# Forces and experiments: Lacy.


def test_axes_of_members_over_time_are_those_of_their_free_bodies():
    model = kt.library.vgt.double_octahedral()
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-0.1, 0.2), duration=2), samples=7)
    axes = kt.kinematics.member_rates(model, motion).member_axes
    forces = kt.dynamics.inverse(model, motion)
    for member, k in (("M7", 2), ("M3", 5)):
        alone = kt.dynamics.free_body(model, motion, forces, member=member, time=float(motion.time[k]))
        assert_allclose(axes.sel(member=member).values[k], alone.axes, atol=1e-13)


@pytest.mark.parametrize("member", ["M6", "M14"])
@pytest.mark.parametrize("coordinate", ["beta", "gamma", "height"])
def test_the_pose_follows_every_length_as_differences_of_the_built_bay(member, coordinate):
    model, step, poses = kt.library.vgt.double_octahedral(), 1e-5, []
    length = float(np.linalg.norm(np.subtract(*(model.nodes[end].at for end in model.bars[member].ends))))
    for sign in (1, -1):
        bar = model.bars[member].with_(length=length + sign * step)
        changed = model.with_(bars={**model.bars, member: bar})
        poses.append(float(kt.kinematics.platform(changed, at_rest(changed), TOP)[coordinate].item()))
    exact = kt.kinematics.jacobian(model, of=f"bay.{coordinate}", wrt=member).values.item()
    assert exact == pytest.approx((poses[0] - poses[1]) / (2 * step), abs=1e-8)


def test_a_rosette_finds_the_strains_that_it_was_given():
    e1, e2, turn, E, nu = 400.0, -250.0, 0.4, 200e3, 0.3  # 1e-6, 1e-6, rad, 1e6 Pa
    angles = np.radians([10, 55, 130])
    strains = (e1 + e2) / 2 + (e1 - e2) / 2 * np.cos(2 * (angles - turn))
    found = kt.strength.rosette(strains, angles, material=LIGHT)
    assert_allclose(found.principal, [e1, e2], rtol=1e-12)
    assert float(found.angle) == pytest.approx(turn)
    assert_allclose(found.stress, E / (1 - nu**2) * np.array([e1 + nu * e2, e2 + nu * e1]), rtol=1e-12)


def test_the_first_record_lies_below_the_simulation_by_what_the_thesis_reports():
    file, first, _ = kt.library.example_files()["strain_gauges"]
    model = kt.read(file)
    record = kt.strength.measured_strains(model, first)
    simulated = kt.runs.gauge_strains(model, "experiment_1", measured=record)
    there = np.array([np.abs(simulated.time.values - t).argmin() for t in record.times])
    share = record.columns["M6.axial"] / simulated.group_strain.sel(group="M6", component="axial").values[there]
    assert share.max() < 1
    assert [share[0], share[-1]] == pytest.approx([0.87, 0.95], abs=0.02)
    with pytest.raises(kt.InputError, match="measured_strains"):
        kt.runs.gauge_strains(model, "experiment_1", measured=first)
