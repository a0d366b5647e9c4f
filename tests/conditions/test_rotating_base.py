"""A base that rotates, against the same structure moved in a frame that does not rotate, and against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235
TUBE = kt.Tube(outer=0.03, inner=0.026)
SPIN, RATE, CENTER = np.array([0.7, -1.1, 1.9]), np.array([-0.4, 0.8, 0.5]), np.array([0.3, -0.2, 0.4])


def cross(w):
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def tripod(**changes):
    """Three active members on a base, a body on top, a mass, and a lever with an elastic tie."""
    active = {
        name: kt.Active(
            ends=(foot, "T"),
            base=kt.Part(section=TUBE, length=0.7),
            tube=kt.Part(section=kt.Tube(outer=0.02, inner=0.016), length=0.7),
        )
        for name, foot in {"l1": "A", "l2": "B", "l3": "C"}.items()
    }
    fields = {
        "nodes": {
            "A": (1, 0, 0),
            "B": (-0.5, 0.8, 0),
            "C": (-0.5, -0.8, 0),
            "T": {"at": (0.1, 0, 0.9), "mass": 3.0},
            "E": (1.5, 0.2, 1.0),
        },
        "fixed": ["A", "B", "C"],
        "active": active,
        "bars": {"tie": kt.Bar(ends=("T", "E"), rotary_inertia=True), "stay": ("A", "E"), "stay2": ("B", "E")},
        "section": TUBE,
        "material": STEEL,
    }
    return kt.Model(**fields | changes)


def moved(model, samples=7):
    reach = kt.Quintic(moves={"l1": (model_length(model, "l1"), 1.25), "l2": (model_length(model, "l2"), 1.1)}, duration=0.8)
    return kt.kinematics.follow(model, reach, samples=samples)


def model_length(model, name):
    p, q = model.members[name].ends
    return float(np.linalg.norm(np.subtract(model.nodes[q].at, model.nodes[p].at)))


def in_space(model, motion, spin, rate, center):
    """The motion in a frame that does not rotate: product rule on c + R (x - c), R' = R [w], R'' = R ([w]^2 + [alpha])."""
    t = motion.time.values
    x, v, a = (motion.data[name].values for name in ("position", "velocity", "acceleration"))
    W, turn = cross(spin), [expm(s * cross(spin)) for s in t]
    X = np.stack([center + (x[i] - center) @ R.T for i, R in enumerate(turn)])
    V = np.stack([(x[i] - center) @ (R @ W).T + v[i] @ R.T for i, R in enumerate(turn)])
    A = np.stack([
        (x[i] - center) @ (R @ (W @ W + cross(rate))).T + 2 * v[i] @ (R @ W).T + a[i] @ R.T for i, R in enumerate(turn)
    ])  # fmt: skip
    return kt.kinematics.from_arrays(model, t, X, V, A), np.array(turn)


@pytest.mark.slow
@pytest.mark.parametrize(("gravity", "rate"), [(None, RATE), ((1.0, 2.0, -9.81), np.zeros(3))])
def test_forces_are_those_of_the_same_motion_in_a_frame_that_does_not_rotate(gravity, rate):
    """Members, joints, supports, interfaces and section forces; gravity keeps its direction in space."""
    plain = tripod(gravity=gravity)
    base = kt.BaseRotation(angular_velocity=SPIN, angular_acceleration=rate, center=CENTER, gravity_turns=gravity is not None)
    model = kt.under(plain, kt.Condition(base_rotation=base))
    motion = moved(model)
    found = kt.dynamics.inverse(model, motion)
    space, turn = in_space(plain, motion, SPIN, rate, CENTER)
    wanted = kt.dynamics.inverse(plain, space)
    size = np.abs(wanted.member_force.values).max()
    for name in ("member_force", "end_force", "drive_force"):
        assert np.abs(found.data[name].values - wanted.data[name].values).max() < 1e-10 * size, name
    for name, axes in (("reaction", "tsc"), ("joint_force", "tmec")):
        back = np.einsum(f"{axes},tcd->{axes[:-1]}d", wanted.data[name].values, turn)
        assert np.abs(found.data[name].values - back).max() < 1e-10 * size, name
    left, right = (kt.strength.sections(one, forces) for one, forces in ((model, found), (plain, wanted)))
    assert np.abs(left.section_T.values - right.section_T.values).max() < 1e-10 * size
    for name in ("section_V", "section_M"):  # the axes across a member may differ
        a, b = (np.linalg.norm(getattr(one, name).values, axis=-1) for one in (left, right))
        assert np.abs(a - b).max() < 1e-10 * max(b.max(), 1.0), name
    for name in ("interface_force", "interface_moment"):
        a, b = (np.linalg.norm(one.data[name].values, axis=-1) for one in (found, wanted))
        assert np.abs(a - b).max() < 1e-10 * size, name
    assert np.abs(found.energy_balance.values).max() < 1e-10 * np.abs(found.power.values).max()
    other = kt.dynamics.inverse(plain, motion).member_force.values
    assert np.abs(found.member_force.values - other).max() > 0.05 * size  # the rotation matters


def test_planar_bodies_and_joints_have_the_forces_of_the_same_motion_in_space():
    """A four-bar with planar bodies and a body on two nodes, driven by an angle; the base turns about a point off it."""
    spin, center, gravity = 2.3, np.array([0.1, -0.3]), (1.0, -9.81)
    fourbar = kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)},
        fixed=("A", "D"),
        bars={
            "crank": kt.Bar(ends=("A", "B"), body=kt.PlanarBody(mass=1.5, center=(0.04, 0.02), inertia=0.01)),
            "coupler": kt.Bar(ends=("B", "C"), rotary_inertia=True),
            "rocker": ("C", "D"),
        },
        bodies={"plate": kt.Body(nodes=["C", "D"], mass=2.0, center=(0.32, 0.1), inertia=0.02)},
        section=TUBE, material=STEEL, gravity=gravity, drives={"motor": kt.AngleDrive("crank")},
    )  # fmt: skip
    base = kt.BaseRotation(angular_velocity=[spin], center=center, gravity_turns=True)
    model = kt.under(fourbar, kt.Condition(base_rotation=base))
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 10.0}, duration=0.3), samples=7)
    found = kt.dynamics.inverse(model, motion)
    t, W = motion.time.values, np.array([[0, -spin], [spin, 0]])
    turn = np.array([expm(s * W) for s in t])
    x, v, a = (motion.data[name].values for name in ("position", "velocity", "acceleration"))
    r = x - center
    space = kt.kinematics.from_arrays(
        fourbar, t, center + np.einsum("tab,tnb->tna", turn, r), np.einsum("tab,tnb->tna", turn, v + r @ W.T),
        np.einsum("tab,tnb->tna", turn, a + 2 * v @ W.T + r @ (W @ W).T),
    )  # fmt: skip
    wanted = kt.dynamics.inverse(fourbar, space)
    size = np.abs(wanted.joint_force.values).max()
    for name in ("member_force", "drive_force"):
        assert np.abs(found.data[name].values - wanted.data[name].values).max() < 1e-10 * size, name
    for name in ("reaction", "joint_force", "action_force"):
        back = np.einsum("t...c,tcd->t...d", wanted.data[name].values, turn)
        assert np.abs(found.data[name].values - back).max() < 1e-10 * size, name
    joints = [kt.dynamics.joint_reaction(*one, "plate", ["C"]) for one in ((model, found), (fourbar, wanted))]
    back = np.einsum("tc,tcd->td", joints[1].force.values, turn)
    assert np.abs(joints[0].force.values - back).max() < 1e-10 * size
    assert np.abs(found.energy_balance.values).max() < 1e-10 * np.abs(found.power.values).max()
    ready = kt.prepare(model)
    places = ready.follow(kt.ConstantRate(rates={"motor": 10.0}, duration=0.3), samples=7)
    assert np.abs(ready.forces(places).drive_force - found.drive_force.values).max() < 1e-12 * size


def test_a_rotating_bar_has_the_tension_of_the_closed_form():
    """Uniform bar of mass m about its end: T(s) = m w^2 (L^2 - s^2)/(2 L) + m_tip w^2 L, mean m w^2 L/3 + m_tip w^2 L."""
    length, tip, spin = 1.2, 0.5, 9.0
    mass = STEEL.density * TUBE.area * length
    bar = kt.Model(nodes={"O": (0, 0), "P": {"at": (length, 0), "mass": tip}}, fixed={"O": "xy", "P": "y"},
                   bars={"b": ("O", "P")}, section=TUBE, material=STEEL)  # fmt: skip
    model = kt.under(bar, kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=[spin])))
    forces = kt.statics.at_poses(model, [{}])
    ends = [mass * spin**2 * length / 2 + tip * spin**2 * length, tip * spin**2 * length]
    assert forces.end_force.values[0, 0] == pytest.approx(ends, rel=1e-12)
    assert forces.reaction.sel(support="O").values[0] == pytest.approx([-ends[0], 0], rel=1e-12, abs=1e-9)
    assert forces.member_force.item() == pytest.approx(mass * spin**2 * length / 3 + ends[1], rel=1e-12)
    at = np.array([0.0, 0.25, 0.8, 1.0])
    tension = kt.strength.sections(model, forces, stations=at).section_T.values.reshape(-1)
    assert tension == pytest.approx(mass * spin**2 * length * (1 - at**2) / 2 + ends[1], rel=1e-12)


def test_an_angular_acceleration_loads_a_bar_across():
    """Euler's forces -rho A alpha s across a bar from the centre: their moment about it is rho A alpha L^3/3."""
    length, rate = 1.2, 7.0
    line = STEEL.density * TUBE.area
    bar = kt.Model(nodes={"O": (0, 0), "P": (length, 0), "Q": (0, 1)}, fixed=["O", "Q"],
                   bars={"b": ("O", "P"), "c": kt.Bar(ends=("Q", "P"), mass=0)}, section=TUBE, material=STEEL)  # fmt: skip
    base = kt.BaseRotation(angular_acceleration=[rate])
    forces = kt.statics.at_poses(kt.under(bar, kt.Condition(base_rotation=base)), [{}])
    moment = length * forces.joint_force.sel(member="b", end="B", axis="y").item()
    assert moment == pytest.approx(line * rate * length**3 / 3, rel=1e-12)


def test_coriolis_force_on_a_mass_that_slides_outwards():
    """At radius r with rates r' and r'': the guide feels 2 m w r', the drive m (r'' - w^2 r)."""
    mass, spin = 2.0, 3.0
    slide = kt.Model(nodes={"O": (0, 0), "S": {"at": (0.5, 0), "mass": mass}}, fixed={"O": "xy", "S": "y"},
                     bars={"b": kt.Bar(ends=("O", "S"), kind="driven", mass=0)})  # fmt: skip
    model = kt.under(slide, kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=[spin])))
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"b": (0.5, 0.9)}, duration=1.0), samples=9)
    forces = kt.dynamics.inverse(model, motion)
    r, rate, second = (motion.data[name].sel(member="b").values for name in ("length", "length_rate", "length_acceleration"))
    assert forces.reaction.sel(support="S", axis="y").values == pytest.approx(2 * mass * spin * rate, rel=1e-12, abs=1e-12)
    assert forces.drive_force.values[:, 0] == pytest.approx(mass * (second - spin**2 * r), rel=1e-12, abs=1e-12)
    assert np.abs(forces.energy_balance.values).max() < 1e-10
    assert forces.static.drive_force.values[:, 0] == pytest.approx(-mass * spin**2 * r, rel=1e-12)


def test_a_swinging_pendulum_seen_from_a_turntable_needs_no_force():
    """Foucault: what a pendulum does in space, seen from a base that rotates below it, is free motion with the same tension."""
    rod = kt.Model(nodes={"O": (0, 0, 2), "P": {"at": (0.6, 0, 0.3), "mass": 4.0}}, fixed=["O"], bars={"b": ("O", "P")},
                   gravity=(0, 0, -9.81), section=TUBE, material=STEEL, velocities={"P": (0, 0.8, 0)})  # fmt: skip
    run = kt.dynamics.simulate(rod, t_end=2.0, samples=21)
    spin = np.array([0, 0, 1.3])
    t = run.motion.time.values
    space = [run.motion.data[name].values for name in ("position", "velocity", "acceleration")]
    x, v, a = (np.empty_like(one) for one in space)
    for i, s in enumerate(t):
        R, W = expm(s * cross(spin)), cross(spin)  # x = R^T X and its rates
        X, V, A = (one[i] for one in space)
        x[i], v[i] = X @ R, V @ R - X @ R @ W.T
        a[i] = A @ R - 2 * V @ R @ W.T + X @ R @ (W @ W).T
    model = kt.under(rod, kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=spin)))
    seen = kt.kinematics.from_arrays(model, t, x, v, a)
    forces = kt.dynamics.inverse(model, seen)
    wanted = run.forces.member_force.values
    assert np.abs(forces.member_force.values - wanted).max() < 1e-10 * wanted.max()
    assert (
        np.abs(
            forces.reaction.sum("support").values
            - np.einsum("tc,tcd->td", run.forces.reaction.sum("support").values, np.array([expm(s * cross(spin)) for s in t]))
        ).max()
        < 1e-10 * wanted.max()
    )
    assert np.abs(forces.energy_balance.values).max() < 1e-9 * np.abs(forces.power.values).max()
    assert np.abs(kt.dynamics.inverse(rod, seen).member_force.values - wanted).max() > 1.0  # without the base it is another


def test_friction_resists_the_rates_relative_to_the_base():
    """A damped hinge on the ground does not feel the rotation of the base; a lever at rest on it rests."""
    lever = kt.Model(nodes={"O": (0, 0), "P": {"at": (1, 0), "mass": 2.0}}, fixed=["O"],
                     bars={"b": kt.Bar(ends=("O", "P"), friction=(0.7, 0.0))}, drives={"turn": kt.AngleDrive("b")})  # fmt: skip
    model = kt.under(lever, kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=[2.0])))
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 0.5}, duration=1.0), samples=3)
    forces = kt.dynamics.inverse(model, motion)
    assert forces.drive_force.values[:, 0] == pytest.approx([0.7 * 0.5] * 3, rel=1e-12)
    assert forces.member_force.values[:, 0] == pytest.approx([2.0 * 2.5**2] * 3, rel=1e-12)
    assert np.abs(forces.energy_balance.values).max() < 1e-12


def test_free_bodies_and_newton_euler_close_in_a_rotating_base():
    base = kt.BaseRotation(angular_velocity=SPIN, center=CENTER, gravity_turns=True)
    model = kt.under(tripod(gravity=(1.0, 2.0, -9.81)), kt.Condition(base_rotation=base))
    motion = moved(model)
    forces = kt.dynamics.inverse(model, motion)
    equations = kt.dynamics.newton_euler(model, motion, forces, time=float(motion.time[3]))
    residual = equations.matrix @ equations.product - equations.right
    assert np.abs(residual).max() < 1e-10 * np.abs(forces.member_force.values).max()
    for part in ({"member": "l1"}, {"member": "tie"}, {"node": "T"}):
        body = kt.dynamics.free_body(model, motion, forces, **part, time=float(motion.time[3]))
        assert body.residual < 1e-10 * body.largest


def test_a_mission_takes_the_worst_over_a_base_that_rotates():
    """The governing pair is the fast one, with the tension of a single run; both orders of magnitude are known."""
    model = tripod(
        trajectories={"reach": kt.Quintic(moves={"l1": (1.26, 1.2)}, duration=1.0)},
        conditions={
            "still": kt.Condition(),
            "spun": kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=(0, 0, 12.0))),
        },
        runs={"all": kt.Run(analysis="mission", motions=("reach",), conditions=("still", "spun"), samples=11)},
    )
    mission = kt.run(model, "all")
    assert mission.pairs.sizes["pair"] == 2
    one = kt.runs.governing(mission)
    changed = kt.under(model, "spun")
    forces = kt.dynamics.inverse(changed, kt.kinematics.follow(changed, model.trajectories["reach"], samples=11))
    alone = kt.strength.check(changed, forces)
    assert mission.verdict.table()[0].utilisation == pytest.approx(alone.table()[0].utilisation, rel=1e-12)
    assert one.verdict.table()[0].utilisation == pytest.approx(alone.table()[0].utilisation, rel=1e-12)


def test_forces_in_a_rotating_base_have_no_deflection():
    plain = tripod(gravity=(0, 0, -9.81))
    model = kt.under(plain, kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=SPIN)))
    forces = kt.statics.at_poses(model, [{}])
    for one in (model, plain):
        with pytest.raises(kt.InputError, match="base rotates"):
            kt.statics.deflection(one, forces)
        with pytest.raises(kt.InputError, match="base rotates"):
            kt.flexible.frequencies(one, forces)


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_stored_run_keeps_the_rotation_and_its_pages_show_it(tmp_path):
    """Section forces from the folder, those of the viewer's arrays, and the table of inputs."""
    model = tripod(
        trajectories={"reach": kt.Quintic(moves={"l1": (1.26, 1.2)}, duration=1.0)},
        conditions={"spun": kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=SPIN, center=CENTER))},
        runs={"one": kt.Run(trajectory="reach", samples=5, condition="spun")},
    )
    run = kt.run(model, out=tmp_path / "run")
    stored = kt.runs.load(tmp_path / "run")
    for one in (run, stored):
        again = kt.strength.sections(one.model, one.forces["all"], stations=run.definition.stations)
        assert again.section_M.values == pytest.approx(run.sections["all"].section_M.values, rel=1e-12, abs=1e-12)
    scene = kt.viewer.scene(stored)
    r = stored.motion.position.values - CENTER
    moving = stored.motion.velocity.values + np.cross(SPIN, r)
    assert np.asarray(scene.arrays["velocity"], float) == pytest.approx(moving, rel=1e-5, abs=1e-6)
    assert "base rotation" in kt.report.document_page(stored).html


@pytest.mark.parametrize(
    ("analysis", "words"),
    [
        (lambda model: kt.statics.linear(model), "base rotates"),
        (lambda model: kt.statics.equilibrium(model), "base rotates"),
        (lambda model: kt.dynamics.linearise(model), "base rotates"),
        (lambda model: kt.statics.at_poses(model, [{}], weight=False), "rotate with the base"),
    ],
    ids=["linear", "equilibrium", "linearise", "massless"],
)
def test_what_takes_no_account_of_the_rotation_says_so(analysis, words):
    model = tripod(base_rotation=kt.BaseRotation(angular_velocity=(0, 0, 1)))
    with pytest.raises(kt.InputError, match=words):
        analysis(model)


@pytest.mark.parametrize(
    ("base", "words"),
    [
        ({"center": (0, 0, 1)}, "angular_velocity"),
        ({"angular_acceleration": (0, 0, 1), "gravity_turns": True}, "gravity_turns"),
        ({"angular_velocity": (0, 0, 1), "angular_acceleration": (0, 0, 1), "gravity_turns": True}, "gravity_turns"),
    ],
)
def test_a_faulty_rotation_is_refused(base, words):
    with pytest.raises(kt.ModelError, match=words):
        kt.BaseRotation(**base)


def test_a_rotation_with_the_components_of_another_dimension_is_refused():
    with pytest.raises(kt.ModelError, match="has 1 components, the model has 3 in space"):
        tripod(base_rotation=kt.BaseRotation(angular_velocity=[1.0]))


@pytest.mark.slow
@pytest.mark.parametrize("turns", [False, True])
def test_a_simulation_in_a_rotating_base_is_the_one_in_space(turns):
    """A chain of a driven-out rod and a swinging one, with masses along them: places, forces and the motion of its energy."""
    spin = np.array([0.3, -0.4, 0.9]) if turns else np.array([0, 0, 0.9])
    chain = kt.Model(
        nodes={"O": (0, 0, 2), "P": {"at": (0.6, 0, 1.3), "mass": 1.0}, "Q": {"at": (0.9, 0.2, 0.7), "mass": 2.0}}, fixed=["O"],
        bars={"a": ("O", "P"), "b": kt.Bar(ends=("P", "Q"), kind="elastic", stiffness=4e3, damping=3.0)},
        gravity=(0, 0, -9.81), section=TUBE, material=STEEL,
    )  # fmt: skip
    start = {"P": np.array([0, 0.8, 0.0]), "Q": np.array([0.1, 0.5, -0.2])}
    base = kt.BaseRotation(angular_velocity=spin, center=(0, 0, 2), gravity_turns=turns)
    seen = {name: tuple(v - np.cross(spin, np.subtract(chain.nodes[name].at, (0, 0, 2)))) for name, v in start.items()}
    options = {"t_end": 0.6, "samples": 7, "method": kt.DOP853(rtol=1e-12, atol=1e-13)}
    space = kt.dynamics.simulate(chain, velocities={name: tuple(v) for name, v in start.items()}, **options)
    model = chain.with_(base_rotation=base)
    found = kt.dynamics.simulate(model, velocities=seen, **options)
    turn = np.array([expm(s * cross(spin)) for s in space.motion.time.values])
    top = np.array((0.0, 0.0, 2.0))
    back = top + np.einsum("tnc,tcd->tnd", space.motion.position.values - top, turn)
    assert np.abs(found.motion.position.values - back).max() < 1e-9
    size = np.abs(space.forces.member_force.values).max()
    assert np.abs(found.forces.member_force.values - space.forces.member_force.values).max() < 1e-7 * size
    pulled = np.einsum("tsc,tcd->tsd", space.forces.reaction.values, turn)
    assert np.abs(found.forces.reaction.values - pulled).max() < 1e-7 * size
    assert np.abs(found.forces.energy_balance.values).max() < 1e-7 * np.abs(found.forces.power.values).max()
    if not turns:  # T + V less the energy of the centrifugal field is Jacobi's integral where nothing is lost
        inverse = kt.dynamics.inverse(model, found.motion)
        assert np.abs(inverse.member_force.values - found.forces.member_force.values).max() < 1e-6 * size


@pytest.mark.slow
def test_a_simulated_motion_of_drives_has_the_forces_of_inverse_dynamics():
    """With a force of the user on it, which is a load beside the fictitious forces."""
    base = kt.BaseRotation(angular_velocity=SPIN, angular_acceleration=RATE, center=CENTER)
    model = tripod(gravity=(0, 0, -9.81), base_rotation=base)
    reach = kt.Quintic(moves={"l1": (model_length(model, "l1"), 1.25)}, duration=0.4)
    tie = tripod(gravity=(0, 0, -9.81), base_rotation=base, loads={"push": kt.NodalForce(node="T", force=(5.0, -3.0, 20.0))})
    run = kt.dynamics.simulate(
        model, t_end=0.4, trajectory=reach, samples=5, user_force=lambda t, x, v: {"T": np.array((5.0, -3.0, 20.0))}
    )
    wanted = kt.dynamics.inverse(tie, kt.kinematics.follow(tie, reach, samples=5))
    size = np.abs(wanted.member_force.values).max()
    for name in ("member_force", "drive_force", "reaction", "interface_force"):
        assert np.abs(run.forces.data[name].values - wanted.data[name].values).max() < 1e-7 * size, name
    again = kt.dynamics.simulate(model, t_end=0.4, trajectory=reach, samples=5)
    twice = kt.dynamics.simulate(model, t_end=0.4, trajectory=reach, samples=5)
    assert np.array_equal(again.forces.member_force.values, twice.forces.member_force.values)
    ready = kt.dynamics.prepare(model, t_end=0.4, trajectory=reach).run(0.4, samples=5)
    assert np.abs(ready.position[:, :, : model.dim] - again.motion.position.values).max() < 1e-9


@pytest.mark.slow
def test_a_run_of_a_simulation_under_the_condition_goes_on_where_it_stopped(tmp_path):
    model = tripod(
        gravity=(0, 0, -9.81),
        conditions={"spun": kt.Condition(base_rotation=kt.BaseRotation(angular_velocity=SPIN, center=CENTER))},
        trajectories={"reach": kt.Quintic(moves={"l1": (1.26, 1.2)}, duration=0.2)},
        runs={"one": kt.Run(analysis="dynamics.simulate", t_end=0.2, trajectory="reach", samples=5, condition="spun")},
    )
    run = kt.run(model, out=tmp_path / "run", block=2)
    alone = kt.dynamics.simulate(kt.under(model, "spun"), t_end=0.2, trajectory=model.trajectories["reach"], samples=5)
    wanted = alone.forces.member_force.values
    assert np.abs(run.forces["all"].member_force.values - wanted).max() < 1e-8 * np.abs(wanted).max()


def test_a_rotating_base_has_no_power_series():
    rod = kt.Model(nodes={"O": (0, 0), "P": {"at": (1, 0), "mass": 1.0}}, fixed=["O"], bars={"b": ("O", "P")},
                   base_rotation=kt.BaseRotation(angular_velocity=[1.0]))  # fmt: skip
    with pytest.raises(kt.InputError, match="the base rotates"):
        kt.dynamics.simulate(rod, t_end=0.1, method=kt.Taylor())
