"""Hinges and couplings in forward dynamics: minimal coordinates, energy, momentum, couplings in closed form, linearisation."""

import numpy as np
import pytest

import kinetruss as kt
from hinge_models import Arm, DoublePendulum
from kinetruss.library import mechanisms
from kinetruss.mechanics import compile
from kinetruss.verification.cases import cases

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)


def angles(run, model):
    return run.motion.data["drive_position"].values - compile(model).drive_start


@pytest.mark.slow
def test_arm_under_torques_moves_as_by_minimal_coordinates():
    arm = Arm()
    model = arm.model()
    t, torque = np.linspace(0, 1.0, 41), np.array([9.0, -7.0])
    tasks = {"base": kt.GivenForce(torque=9.0), "elbow": kt.GivenForce(torque=-7.0)}
    run = kt.dynamics.simulate(model, 1.0, times=t, tasks=tasks, method=FINE)
    assert np.abs(angles(run, model) - arm.simulate(t, torque)).max() < 1e-10
    # work of the torques is all that energy gains
    done = run.motion.data["drive_position"].values @ torque
    energy = run.data["energy"].values
    assert np.abs(energy - energy[0] - done + done[0]).max() < 1e-10 * np.ptp(done)
    assert np.abs(run.forces.data["drive_force"].values - torque).max() < 1e-12
    assert np.abs(run.forces.data["energy_balance"].values).max() < 1e-9 * np.abs(run.forces.data["power"].values).max()


@pytest.mark.parametrize("solver", ["dense", "sparse"])
def test_prescribed_hinges_move_as_followed(solver):
    arm = Arm()
    model = arm.model()
    start = compile(model).drive_start
    path = kt.Quintic(moves={"base": (start[0], start[0] + 7.0), "elbow": (start[1], start[1] - 8.0)}, duration=1.0)
    motion = kt.kinematics.follow(model, path, samples=41)
    forces = kt.dynamics.inverse(model, motion)
    run = kt.dynamics.simulate(model, 1.0, samples=41, trajectory=path, method=kt.DOP853(solver=solver))
    assert np.abs(run.motion.data["position"].values - motion.data["position"].values).max() < 1e-10
    size = np.abs(forces.data["drive_force"].values).max()
    assert np.abs(run.forces.data["drive_force"].values - forces.data["drive_force"].values).max() < 1e-9 * size
    assert np.abs(run.motion.data["drive_position"].values - motion.data["drive_position"].values).max() < 1e-10


def test_torques_of_inverse_dynamics_reproduce_the_motion():
    one = DoublePendulum()
    model = one.model()
    path = kt.Quintic(moves={"shoulder": (0.0, 2.0), "elbow": (np.pi, np.pi - 3.0)}, duration=1.0)
    off = []
    for count in (201, 401):
        motion = kt.kinematics.follow(model, path, samples=count)
        torque = kt.dynamics.inverse(model, motion).data["drive_force"].values
        tasks = {name: kt.GivenForce(times=motion.data["time"].values, torques=torque[:, k])
                 for k, name in enumerate(("shoulder", "elbow"))}  # fmt: skip
        run = kt.dynamics.simulate(model, 1.0, samples=count, tasks=tasks)
        off.append(np.abs(run.motion.data["position"].values - motion.data["position"].values).max())
    # tables are linear between their times: the error falls by four
    assert off[1] < 1e-3 and 3.8 < off[0] / off[1] < 4.2


@pytest.mark.slow
def test_double_pendulum_under_torques():
    one = DoublePendulum()
    model = one.model()
    t = np.linspace(0, 2.0, 41)
    tasks = {"shoulder": kt.GivenForce(torque=80.0), "elbow": kt.GivenForce(torque=4.0)}
    run = kt.dynamics.simulate(model, 2.0, times=t, tasks=tasks, method=FINE)
    exact = one.simulate(t, np.array([80.0, 4.0]))
    assert np.abs(exact).max() > 2 * np.pi
    assert np.abs(angles(run, model) - exact).max() < 1e-9 * np.abs(exact).max()


def test_a_free_hinge_keeps_energy_and_momentum():
    arm = Arm()
    model = arm.model().with_(gravity=None)
    tasks = {"base": kt.Free(), "elbow": kt.GivenForce(torque=3.0)}
    run = kt.dynamics.simulate(model, 3.0, samples=31, tasks=tasks)
    # the inner torque does not change the moment of momentum about the first axis
    spin = run.data["angular_momentum"].sel(axis="z").values
    assert np.abs(spin).max() < 1e-9 * run.data["kinetic_energy"].values.max()


def screw(pitch=0.02):
    """A nut of 3 kg on a fixed axis, with 0.5 kg at its rim of 0.3 m, on a thread; it falls."""
    return kt.Model(
        nodes={"A": (0, 0, 0), "C": kt.Node(at=(0, 0, 1.0), mass=3.0), "E": (0, 0, 1.2),
               "D": kt.Node(at=(0.3, 0, 1.0), mass=0.5)},
        fixed={"A": "xyz", "C": "xy", "E": "xy"}, gravity=(0, 0, -9.81),
        bars={"CD": kt.Bar(ends=("C", "D"), mass=0.0), "CE": kt.Bar(ends=("C", "E"), mass=0.0),
              "ED": kt.Bar(ends=("E", "D"), mass=0.0), "drop": kt.Bar(ends=("A", "C"), kind="free")},
        couplings={"thread": kt.Coupling(terms=(
            (kt.CoordinateDrive(node="C", axis="z"), 2 * np.pi / pitch), (kt.AngleDrive("CD", axis="z"), -1.0)))},
    )  # fmt: skip


def test_screw_pair_falls_and_spins():
    pitch = 0.02
    model = screw(pitch)
    assert kt.kinematics.mobility(model).undriven == 1
    run = kt.dynamics.simulate(model, 3.0, samples=21, method=FINE)
    k = 2 * np.pi / pitch
    fall = -3.5 * 9.81 / (3.5 + 0.5 * 0.3**2 * k**2)
    t = run.data["time"].values
    z = run.motion.data["position"].sel(node="C", axis="z").values
    assert np.abs(z - 1.0 - 0.5 * fall * t**2).max() < 1e-11
    angle = k * 0.5 * fall * t**2
    rim = run.motion.data["position"].sel(node="D").values
    assert abs(angle[-1]) > 2 * np.pi
    assert np.abs(rim[:, :2] - 0.3 * np.stack([np.cos(angle), np.sin(angle)], 1)).max() < 1e-9
    assert np.ptp(run.data["energy"].values) < 1e-9 * run.data["kinetic_energy"].values.max()


def test_screw_pair_in_inverse_dynamics():
    pitch = 0.02
    model = screw(pitch).with_(drives={"lift": kt.CoordinateDrive(node="C", axis="z")})
    path = kt.Quintic(moves={"lift": (1.0, 1.05)}, duration=1.0)
    motion = kt.kinematics.follow(model, path, samples=51)
    force = kt.dynamics.inverse(model, motion).data["drive_force"].values[:, 0]
    k, a = 2 * np.pi / pitch, motion.data["drive_acceleration"].values[:, 0]
    exact = (3.5 + 0.5 * 0.3**2 * k**2) * a + 3.5 * 9.81
    assert np.abs(force - exact).max() < 1e-9 * np.abs(exact).max()
    # two and a half turns
    D = motion.data["position"].sel(node="D").values
    assert D[-1, :2] == pytest.approx([-0.3, 0.0], abs=1e-10)


def gears(one=-1.0, two=2.0):
    """Two arms in the plane on fixed centres, 2 kg at 0.5 m and 1 kg at 0.3 m, whose angles are geared."""
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2.0), "C": (1, 0), "D": kt.Node(at=(1, 0.3), mass=1.0)},
        fixed=["A", "C"], bars={"a": kt.Bar(ends=("A", "B"), mass=0.0), "c": kt.Bar(ends=("C", "D"), mass=0.0)},
        drives={"motor": kt.AngleDrive("a")},
        couplings={"mesh": kt.Coupling(terms=((kt.HingeDrive(axis="A", start="C", end="B"), one),
                                               (kt.HingeDrive(axis="C", start="A", end="D"), two)))},
    )  # fmt: skip


def test_gear_pair_turns_round_under_a_torque():
    model = gears()
    run = kt.dynamics.simulate(model, 3.0, samples=61, tasks={"motor": kt.GivenForce(torque=4.0)}, method=FINE)
    t, inertia = run.data["time"].values, 2.0 * 0.5**2 + 0.25 * 1.0 * 0.3**2
    angle = 0.5 * 4.0 / inertia * t**2
    assert angle[-1] > 4 * np.pi
    assert np.abs(run.motion.data["drive_position"].values[:, 0] - angle).max() < 1e-9 * angle[-1]
    other = np.pi / 2 + angle / 2
    D = run.motion.data["position"].sel(node="D").values - [1.0, 0.0]
    assert np.abs(D - 0.3 * np.stack([np.cos(other), np.sin(other)], 1)).max() < 1e-9


def slider():
    """Two masses that slide along a massless rod A-B; the rod turns."""
    line = ("A", "B")
    return kt.Model(
        nodes={"A": (0, 0), "B": (1.0, 0), "C": kt.Node(at=(0.4, 0), mass=2.0), "D": kt.Node(at=(0.6, 0), mass=1.0)},
        fixed=["A"], bars={"rod": kt.Bar(ends=("A", "B"), mass=0.0), "body": kt.Bar(ends=("C", "D"), mass=0.0)},
        drives={"motor": kt.AngleDrive("rod")},
        couplings={"left": kt.Coupling(terms=((kt.OffsetCoordinate(line=line, point="C"), 1.0),), value=0.0),
                   "right": kt.Coupling(terms=((kt.OffsetCoordinate(line=line, point="D"), 1.0),), value=0.0)},
    )  # fmt: skip


def test_planar_slider_flies_out_of_a_turning_rod():
    model, w = slider(), 3.0
    mobility = kt.kinematics.mobility(model)
    assert mobility.degrees_of_freedom == 2 and mobility.undriven == 1
    place = np.array([[0, 0], [1.0, 0], [0.4, 0], [0.6, 0]])
    velocities = w * place @ np.array([[0, 1], [-1, 0]])
    path = kt.ConstantRate(rates={"motor": w}, duration=0.8)
    run = kt.dynamics.simulate(model, 0.8, samples=17, trajectory=path, velocities=velocities, method=FINE)
    t = run.data["time"].values
    # centre of mass: r'' = w^2 r from rest
    c = 1.4 / 3.0
    r = c * np.cosh(w * t)
    x = run.motion.data["position"]
    centre = (2.0 * x.sel(node="C").values + x.sel(node="D").values) / 3.0
    assert np.abs(centre - r[:, None] * np.stack([np.cos(w * t), np.sin(w * t)], 1)).max() < 1e-10
    torque = run.forces.data["drive_force"].values[:, 0]
    assert torque == pytest.approx(2 * 3.0 * r * c * w * np.sinh(w * t) * w, abs=1e-8)


def test_slider_keeps_its_momentum():
    run = kt.dynamics.simulate(
        slider(), 2.0, samples=21, tasks={"motor": kt.Free()},
        velocities={"B": (0.0, 1.0), "C": (0.0, 0.4), "D": (0.0, 0.6)},
    )  # fmt: skip
    spin, energy = run.data["angular_momentum"].values, run.data["energy"].values
    assert spin == pytest.approx(2.0 * 0.16 + 0.36, rel=1e-9)
    assert energy == pytest.approx(energy[0], rel=1e-9)


def sprung_arm():
    """The arm with a spring from its tip, its base turned by a torque, its elbow held."""
    model = Arm().model()
    spring = kt.Bar(ends=("T", "P"), kind="elastic", stiffness=400.0, natural_length=1.5, mass=0.0)
    return model.with_(bars=dict(model.bars) | {"spring": spring}), {"base": kt.GivenForce(torque=5.0), "elbow": kt.Hold()}


@pytest.mark.slow
@pytest.mark.parametrize("method", [kt.EnergyMomentum(0.002), kt.GeneralizedAlpha(0.002), kt.Rattle(0.002)])
def test_implicit_methods_take_hinges_and_springs(method):
    model, tasks = sprung_arm()
    fine = kt.dynamics.simulate(model, 0.5, samples=6, tasks=tasks, method=FINE)
    run = kt.dynamics.simulate(model, 0.5, samples=6, tasks=tasks, method=method)
    half = kt.dynamics.simulate(model, 0.5, samples=6, tasks=tasks, method=method.with_(step=0.001))
    off = [np.abs(one.motion.data["position"].values - fine.motion.data["position"].values).max() for one in (run, half)]
    assert off[1] < 1e-4 and 3.0 < off[0] / off[1] < 5.0


def test_radau_takes_hinges_and_springs():
    model, tasks = sprung_arm()
    fine, run = (kt.dynamics.simulate(model, 0.5, samples=6, tasks=tasks, method=one) for one in (FINE, kt.Radau()))
    np.testing.assert_allclose(run.motion.data["position"].values, fine.motion.data["position"].values, atol=1e-8)


def test_linearised_arm_is_that_of_minimal_coordinates():
    arm = Arm()
    model, torque = arm.model(), np.array([2.0, -3.0])
    start = compile(model).x0
    qd = np.array([1.2, -0.7])
    v = np.zeros_like(start)
    index = list(model.nodes).index
    v[[index("S1"), index("S2"), index("P")]] = arm.state(np.zeros(2), qd, np.zeros(2))[1]
    tasks = {"base": kt.GivenForce(torque=2.0), "elbow": kt.GivenForce(torque=-3.0)}
    lin = kt.dynamics.linearise(model, (start, v), dofs=("base", "elbow"), tasks=tasks)
    h = 1e-5
    by_q = [(arm.acceleration(h * e, qd, torque) - arm.acceleration(-h * e, qd, torque)) / (2 * h) for e in np.eye(2)]
    by_rate = [(arm.acceleration(0 * e, qd + h * e, torque) - arm.acceleration(0 * e, qd - h * e, torque)) / (2 * h)
               for e in np.eye(2)]  # fmt: skip
    A = lin.data["A"].values
    assert np.abs(A[2:, :2] - np.array(by_q).T).max() < 1e-7 * np.abs(A).max()
    assert np.abs(A[2:, 2:] - np.array(by_rate).T).max() < 1e-7 * np.abs(A).max()


def test_couplings_that_depend_on_each_other_are_found_by_rank():
    model = gears()
    twice = model.couplings["mesh"].with_(terms=tuple((one, 3.0 * factor) for one, factor in model.couplings["mesh"].terms))
    doubled = model.with_(couplings={**model.couplings, "again": twice})
    found = kt.kinematics.mobility(doubled)
    assert found.self_stress == 1 and found.undriven == 0
    assert {"mesh", "again"} <= set(found.row_names)
    run = kt.dynamics.simulate(doubled, 0.5, samples=6, tasks={"motor": kt.GivenForce(torque=4.0)})
    assert "not unique" in run.message
    single = kt.dynamics.simulate(model, 0.5, samples=6, tasks={"motor": kt.GivenForce(torque=4.0)})
    assert np.abs(run.motion.data["position"].values - single.motion.data["position"].values).max() < 1e-9


@pytest.mark.parametrize(
    ("terms", "says"),
    [
        (((kt.AngleDrive("zz"), 1.0),), "no member called 'zz'"),
        (((kt.AngleDrive("a"), 0.0),), "has the factor 0"),
        (((kt.AngleDrive("a"), 1.0), (kt.AngleDrive("a"), 2.0)), "names a coordinate twice"),
        (((kt.OffsetCoordinate(line=("A", "B"), point="B"), 1.0),), "names a node twice"),
        (((kt.AngleDrive("a", axis="z"), 1.0),), "gives an axis in a planar model"),
    ],
)
def test_faults_of_couplings(terms, says):
    with pytest.raises(kt.ModelError, match=says):
        gears().with_(couplings={"mesh": kt.Coupling(terms=terms)})


def test_andrews_crank_with_a_rotation_coordinate():
    beam, bars = mechanisms.andrews(form="beam"), mechanisms.andrews()
    found = kt.kinematics.mobility(beam)
    # the rigid beam is two couplings: cosine and sine of its rotation; the ninth bar is the spring
    assert (found.coordinates, found.fixed, found.bars, found.couplings) == (19, 8, 8, 2)
    assert (found.rank, found.degrees_of_freedom) == (10, 1)
    tasks = {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
    one, two = (kt.dynamics.simulate(model, 0.03, samples=31, tasks=tasks, method=kt.DOP853(rtol=1e-13, atol=1e-15))
                for model in (beam, bars))  # fmt: skip
    rotation = one.motion.data["position"].sel(node="beta", axis="x").values
    (exact,) = (case.expected for case in cases() if case.id == "rows.andrews.beta.position")
    assert rotation[-1] == pytest.approx(exact, rel=1e-11)
    assert rotation == pytest.approx(two.motion.data["drive_position"].values[:, 0], rel=2e-11)
    # its rotation is a degree of freedom that any position has
    for k in (0, 9, 17, 30):
        place = one.motion.data["position"].values[k]
        by_beam = kt.kinematics.transfer_functions(beam, "beta.x", place, free=("motor",))
        by_angle = kt.kinematics.transfer_functions(bars, "motor", place[:-1])
        for name in ("first", "second"):
            mine, other = by_beam[name].sel(node=by_angle["node"]).values, by_angle[name].values
            assert np.abs(mine - other).max() < 1e-11 * max(1.0, np.abs(other).max())
        assert float(by_beam["first"].sel(node="beta", axis="x").item()) == pytest.approx(1.0)


def test_the_inertia_of_a_rotation_has_no_weight():
    """Gravity along x on a crank that points up: a = -m g l/(m l^2 + I), whatever I is held by the rotation."""
    mass, length, inertia, g = 2.0, 0.5, 0.3, 9.81
    crank = kt.Model(
        nodes={
            "O": (0, 0), "F": kt.Node(at=(0, length), mass=mass), "b": kt.Node(at=(np.pi / 2, 0), scalar=True, mass=inertia),
        },
        fixed=["O"], beams={"OF": kt.Beam(ends=("O", "F"), kind="rigid", rotation="b", mass=0)}, gravity=(g, 0),
    )  # fmt: skip
    start = kt.dynamics.simulate(crank, 1e-3, samples=2).motion.acceleration[0].sel(node="b", axis="x").item()
    assert start == pytest.approx(-mass * g * length / (mass * length**2 + inertia), rel=1e-12)


def spun(**more):
    """A free rigid beam between two masses that turns at 1.5 rad/s about its middle, with a rotation that has inertia."""
    nodes = {"A": kt.Node(at=(0.2, 0.5), mass=2), "B": kt.Node(at=(1.2, 0.5), mass=2)}
    nodes |= {"b": kt.Node(at=(0, 0.7), scalar=True, mass=0.3)} | more.pop("nodes", {})
    beam, start = kt.Beam(ends=("A", "B"), kind="rigid", rotation="b"), {"A": (1, -0.75), "B": (1, 0.75), "b": (1.5, 0)}
    return kt.Model(nodes=nodes, beams={"r": beam}, velocities=start | more.pop("velocities", {}), gravity=(0, 0), **more)


def test_the_inertia_of_a_rotation_is_no_mass_along_x():
    """p = 2 m v, and L about the origin = 2 m (l/2)^2 w + I w - y 2 m v; both stay."""
    data = kt.dynamics.simulate(spun(), 1.0, samples=3).data
    assert np.abs(data["momentum"].values - (4.0, 0.0)).max() < 1e-12
    assert np.abs(data["angular_momentum"].values - (2 * 2 * 0.25 * 1.5 + 0.3 * 1.5 - 0.5 * 4.0)).max() < 1e-11
    assert np.abs(data["kinetic_energy"].values - (0.5 * 4 * 1 + 0.5 * (2 * 2 * 0.25 + 0.3) * 1.5**2)).max() < 1e-11


def test_momenta_with_a_scalar_that_may_be_anything_are_not_known():
    """A rotor geared to the rotation: nothing says about what it turns. Without a mass it has no momentum."""
    for mass in (0.1, 0.0):
        rotor, pair = (
            kt.Node(at=(0, 0), scalar=True, mass=mass),
            [(kt.CoordinateDrive(node="g", axis="x"), 1), (kt.CoordinateDrive(node="b", axis="x"), 3)],
        )
        geared = spun(nodes={"g": rotor}, velocities={"g": (-4.5, 0)}, couplings={"gear": kt.Coupling(terms=pair)})
        data = kt.dynamics.simulate(geared, 0.1, samples=2).data
        unknown = [bool(np.isnan(data[name]).all()) for name in ("momentum", "angular_momentum")]
        assert unknown == [mass > 0] * 2 and ("'g'" in data["momentum"].attrs["long_name"]) == (mass > 0)
        assert np.abs(data["kinetic_energy"].values - (2 + 0.5 * 1.3 * 1.5**2 + 0.5 * mass * 4.5**2)).max() < 1e-11


def test_fault_of_a_bar_to_a_scalar():
    with pytest.raises(kt.ModelError, match="joins a scalar"):
        kt.Model(nodes={"A": (0, 0), "s": kt.Node(at=(1, 0), scalar=True)}, bars={"b": ("A", "s")})
