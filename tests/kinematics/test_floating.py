"""Structures that nothing holds: their drives give their shape, their momentum the way they move as a whole."""

import math

import numpy as np
import pytest
import scipy.integrate

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235


def two_bodies(a=0.0, b=0.0, m=(3.0, 2.0), inertia=(0.2, 0.5)):
    """Two planar bodies on a hinge O, with their centres at a and b m from it."""
    nodes = {"O": (0.3, -0.2), "P": (1.3, -0.2), "Q": (0.3, 0.8)}
    bodies = {
        "one": kt.Body(nodes=("O", "P"), mass=m[0], center=(0.3 + a, -0.2), inertia=inertia[0]),
        "two": kt.Body(nodes=("O", "Q"), mass=m[1], center=(0.3, -0.2 + b), inertia=inertia[1]),
    }
    return kt.Model(nodes=nodes, bodies=bodies, drives={"turn": kt.HingeDrive(axis="O", start="P", end="Q")})


def direction(motion, a="O", b="P"):
    d = motion.position.sel(node=b).values - motion.position.sel(node=a).values
    return np.unwrap(np.arctan2(d[:, 1], d[:, 0]))


def cat(ratio=2.0):
    """A body on a hub that turns two opposite masses, on arms of variable length."""
    nodes = {"O": (0, 0), "P": (1, 0), "A": kt.Node(at=(0, 0.5), mass=1.5), "B": kt.Node(at=(0, -0.5), mass=1.5)}
    arms = {name: kt.Bar(ends=("O", end), kind="driven", mass=0) for name, end in (("up", "A"), ("down", "B"))}
    drives = {name: kt.HingeDrive(axis="O", start="P", end=end) for name, end in (("left", "A"), ("right", "B"))}
    body = kt.Body(nodes=("O", "P"), mass=4.0, center=(0, 0), inertia=0.9)
    return kt.Model(nodes=nodes, bars=arms, bodies={"body": body}, drives=drives)


def truss(**changes):
    """A double-octahedral bay whose base is three bars, afloat."""
    bay = kt.library.vgt.double_octahedral()
    side = {"section": "bar", "material": "bar"}
    base = {f"B{k}": kt.Bar(ends=ends, **side) for k, ends in enumerate([("N1", "N2"), ("N2", "N3"), ("N1", "N3")])}
    return bay.with_(**({"bars": {**bay.bars, **base}, "fixed": {}, "gravity": (0, 0, 0), "runs": {}} | changes))


MOVE = kt.Quintic(moves={"M7": (1.1684, 1.28), "M9": (1.1684, 1.05)}, duration=2.0)


def spinning(model, u, w):
    """Velocities of a rigid motion of all nodes."""
    at = {name: np.array(node.at) for name, node in model.nodes.items()}
    return {name: tuple(np.asarray(u) + np.cross(w, x)) for name, x in at.items()}


def momenta(model, motion):
    """Momentum and angular momentum about the origin by the rods of all members: centres, rates, moments of inertia."""
    rates = kt.kinematics.member_rates(model, motion)
    x = {name: motion.position.sel(node=name).values for name in motion.position.node.values}
    v = {name: motion.velocity.sel(node=name).values for name in x}
    p, L = np.zeros((2, len(motion.position), 3))
    for name, bar in {**model.bars, **model.active}.items():
        A, B = bar.ends
        d, dv = x[B] - x[A], v[B] - v[A]
        length = np.linalg.norm(d, axis=1)[:, None]
        e = d / length
        w, along = np.cross(d, dv) / length**2, (dv * e).sum(axis=1, keepdims=True)
        if name in model.active:
            rods = [(bar.base.mass, 0.5 * bar.base.length, bar.base.length, 0.0)]
            area = model.sections["tube"].area
            tube = bar.tube.length * area * model.materials["bar"].density
            rods.append((tube, length - 0.5 * bar.tube.length, bar.tube.length, 1.0))
        else:
            rods = [(model.sections["bar"].area * model.materials["bar"].density * length, 0.5 * length, length, 0.0)]
        for mass, s, own, moves in rods:
            centre, speed = x[A] + s * e, v[A] + s * np.cross(w, e) + moves * along * e
            p += mass * speed
            L += mass * np.cross(centre, speed) + mass * own**2 / 12 * w
    assert rates.sizes["time"] == len(p)
    return p, L


def test_two_balanced_bodies_share_the_turn_of_their_hinge_by_their_inertias():
    model = two_bodies()
    move = kt.Quintic(moves={"turn": (math.pi / 2, math.pi / 2 + 2.5)}, duration=1.0)
    motion = kt.kinematics.follow(model, move, samples=11)
    turned = motion.drive_position.values[:, 0] - math.pi / 2
    np.testing.assert_allclose(direction(motion), -0.5 / 0.7 * turned, rtol=0, atol=1e-13)
    np.testing.assert_allclose(motion.position.sel(node="O").values, [[0.3, -0.2]] * 11, rtol=0, atol=1e-14)
    torque = kt.dynamics.inverse(model, motion).drive_force.values[:, 0]
    np.testing.assert_allclose(torque, 0.2 * 0.5 / 0.7 * motion.drive_acceleration.values[:, 0], rtol=0, atol=1e-12)


def test_a_full_turn_of_a_hinge_turns_two_bodies_by_a_closed_form():
    # (J1 - k cos) w1 + (J2 - k cos)(w1 + turn') = 0 with J = I + mu a^2, k = mu a b
    a, b, mu = 0.4, 0.6, 3.0 * 2.0 / 5.0
    J1, J2, k = 0.2 + mu * a**2, 0.5 + mu * b**2, mu * a * b
    move = kt.Quintic(moves={"turn": (math.pi / 2, math.pi / 2 + 2 * math.pi)}, duration=3.0)
    motion = kt.kinematics.follow(two_bodies(a, b), move, samples=7)
    net = -math.pi * (1 + (J2 - J1) / math.sqrt((J1 + J2) ** 2 - 4 * k**2))
    assert direction(motion)[-1] == pytest.approx(net, abs=1e-12)
    few = kt.kinematics.follow(two_bodies(a, b), move, times=[0.9, 3.0])
    assert direction(few)[-1] % math.tau == pytest.approx(net % math.tau, abs=1e-12)
    error = float(motion.message.split("error about ")[1].split(" rad")[0])
    assert error <= 1e-12


def test_a_cycle_of_shapes_turns_a_body_without_momentum():
    A, near, far, I, m = 1.2, 0.5, 1.4, 0.9, 3.0
    turn, arm = np.array([0, 0, A, A, 0.0]), (near, far, far, near, near)
    start = math.pi / 2
    values = {"left": start + turn, "right": turn - start, "up": arm, "down": arm}
    cycle = kt.Spline(times=(0, 1, 2, 3, 4), values={k: tuple(v) for k, v in values.items()}, shape="monotone")
    motion = kt.kinematics.follow(cat(), cycle, samples=9)
    share = [m * r**2 / (I + m * r**2) for r in (near, far)]
    assert direction(motion)[-1] == pytest.approx(-A * (share[1] - share[0]), abs=1e-12)
    assert abs(motion.drive_position.values[-1] - motion.drive_position.values[0]).max() < 1e-12


@pytest.mark.parametrize("u, w", [((0, 0, 0), (0, 0, 0)), ((0.2, -0.1, 0.3), (0.7, -1.1, 0.4))])
def test_momentum_and_angular_momentum_of_a_truss_stay(u, w):
    model = truss()
    model = model.with_(velocities=spinning(model, u, w))
    motion = kt.kinematics.follow(model, MOVE, samples=21)
    p, L = momenta(model, motion)
    speed = float(np.abs(motion.velocity.values).max())
    assert np.abs(p - p[0]).max() < 1e-13 * 15 * speed
    assert np.abs(L - L[0]).max() < 1e-13 * 15 * speed
    if any(w):
        assert np.abs(L[0]).max() > 1.0
    else:
        assert max(np.abs(p).max(), np.abs(L).max()) < 1e-14
    # velocities and accelerations are rates of the positions
    t = np.array([0.9, 0.9 + 1e-3, 0.9 + 2e-3, 0.9 + 3e-3, 0.9 + 4e-3])
    near = kt.kinematics.follow(model, MOVE, times=t)
    five = np.array([1, -8, 0, 8, -1]) / 12e-3
    for of, rate in (("position", "velocity"), ("velocity", "acceleration")):
        slope = np.tensordot(five, near.data[of].values, 1)
        np.testing.assert_allclose(slope, near.data[rate].values[2], rtol=0, atol=1e-10)


def test_loads_and_gravity_move_it_as_in_a_simulation_and_forces_agree():
    model = truss(gravity=(0, 0, -9.81), loads={"F": kt.NodalForce(node="N8", force=(3.0, 1.0, -2.0))})
    model = model.with_(velocities=spinning(model, (0.1, 0, 0), (0.3, -0.2, 0.5)))
    motion = kt.kinematics.follow(model, MOVE, samples=11)
    run = kt.dynamics.simulate(model, 2.0, trajectory=MOVE, samples=11, method=kt.DOP853(rtol=1e-12, atol=1e-13))
    for name in ("position", "velocity", "acceleration"):
        np.testing.assert_allclose(motion.data[name].values, run.motion.data[name].values, rtol=0, atol=1e-9)
    forces = kt.dynamics.inverse(model, motion)
    np.testing.assert_allclose(forces.member_force.values, run.forces.member_force.values, rtol=0, atol=1e-9)
    assert np.abs(forces.data["energy_balance"].values).max() < 1e-11 * np.abs(forces.power.values).max() + 1e-11
    assert forces.attrs.get("not_balanced") is None
    assert "cannot be at rest" in forces.static.message
    assert kt.strength.check(model, forces).table()


def test_some_velocities_are_completed_as_in_a_simulation():
    model = truss(velocities={"N7": (0.3, 0.0, 0.0), "N8": (0.3, 0.0, 0.1)})
    motion = kt.kinematics.follow(model, MOVE, samples=3)
    run = kt.dynamics.simulate(model, 2.0, trajectory=MOVE, samples=3)
    np.testing.assert_allclose(motion.position.values, run.motion.position.values, rtol=0, atol=1e-8)


def test_a_heavy_base_is_as_good_as_the_ground():
    held = kt.library.vgt.double_octahedral().with_(gravity=(0, 0, 0))
    floats = truss(bodies={"ship": kt.Body(nodes=("N1", "N2", "N3"), mass=1e9, kind="rigid", brace=False)})
    moved, fixed = (kt.kinematics.follow(model, MOVE, samples=5) for model in (floats, held))
    np.testing.assert_allclose(moved.position.values, fixed.position.values, rtol=0, atol=1e-7)
    across, along = (kt.dynamics.inverse(model, motion) for model, motion in ((floats, moved), (held, fixed)))
    np.testing.assert_allclose(across.drive_force.values, along.drive_force.values, rtol=0, atol=1e-6)


def test_jumps_of_accelerations_at_unknown_instants_are_found(monkeypatch):
    a, b, mu = 0.4, 0.6, 1.2
    J1, J2, k = 0.2 + mu * a**2, 0.5 + mu * b**2, mu * a * b
    monkeypatch.setattr("kinetruss.kinematics.motions.edges_of", lambda _: np.zeros(0))
    move = kt.Trapezoid(moves={"turn": (math.pi / 2, 4.0)}, duration=1.0, ramp=0.23)
    motion = kt.kinematics.follow(two_bodies(a, b), move, times=[0.0, 0.3, 1.0])
    at = motion.drive_position.values[:, 0]
    turned = [
        scipy.integrate.quad(lambda q: -(J2 - k * math.cos(q)) / (J1 + J2 - 2 * k * math.cos(q)), at[0], end, epsabs=1e-14)[0]
        for end in at
    ]
    np.testing.assert_allclose(direction(motion), turned, rtol=0, atol=2e-12)


def test_a_motion_ends_where_its_shape_cannot_go_on():
    far = kt.Quintic(moves={"M7": (1.1684, 1.9)}, duration=1.0)
    with pytest.raises(kt.AnalysisError) as caught:
        kt.kinematics.follow(truss(), far, samples=21)
    kept = caught.value.result
    assert 3 < len(kept.position) < 21
    assert np.abs(momenta(truss(), kept)[1]).max() < 1e-12


def test_a_run_of_a_floating_structure_has_forces_and_a_verdict():
    model = truss(runs={"go": kt.Run(trajectory=MOVE, samples=11)}, materials={**truss().materials, "bar": STEEL})
    assert kt.check(model) == []
    result = kt.run(model, "go", block=4)
    assert "floats" in result.message
    direct = kt.dynamics.inverse(model, kt.kinematics.follow(model, MOVE, samples=11))
    (forces,) = result.forces.values()
    np.testing.assert_allclose(forces.member_force.values, direct.member_force.values, rtol=0, atol=1e-12)


def test_what_does_not_float_freely_is_refused_with_the_way_out():
    absolute = two_bodies().with_(drives={}, bars={"bar": kt.Bar(ends=("O", "P"), mass=1.0)}, bodies={})
    absolute = absolute.with_(nodes={"O": (0, 0), "P": (1, 0)}, drives={"turn": kt.AngleDrive("bar")})
    with pytest.raises(kt.InputError, match="No node is fixed"):
        kt.kinematics.follow(absolute, kt.Quintic(moves={"turn": (0.0, 1.0)}, duration=1.0))
    loose = truss(bars=kt.library.vgt.double_octahedral().bars)
    with pytest.raises(kt.InputError, match="leave 3 freedoms of the mechanism"):
        kt.kinematics.follow(loose, MOVE)
    weightless = two_bodies().with_(bodies={name: kt.Body(nodes=("O", end)) for name, end in (("one", "P"), ("two", "Q"))})
    with pytest.raises(kt.InputError, match="has no mass"):
        kt.kinematics.follow(weightless, kt.Quintic(moves={"turn": (math.pi / 2, 2.0)}, duration=1.0))
    cases = truss(load_cases={"a": kt.LoadCase(), "b": kt.LoadCase()}, runs={"go": kt.Run(trajectory=MOVE, samples=3)})
    with pytest.raises(kt.InputError, match="every load case moves it otherwise"):
        kt.run(cases, "go")


def test_forces_of_a_motion_that_loads_do_not_make_are_marked():
    still = truss()
    motion = kt.kinematics.follow(still, MOVE, samples=5)
    heavy = truss(gravity=(0, 0, -9.81))
    forces = kt.dynamics.inverse(heavy, motion)
    assert "nothing holds the structure" in forces.message
    assert forces.attrs["not_balanced"] > 1.0
