"""Springs on hinges and other coordinates in motion: closed forms, balances, the same in every engine."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

import kinetruss as kt
from hinge_models import Arm
from kinetruss.dynamics import newton_euler
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_forces, named_motions
from kinetruss.mechanics.matrices import tangents
from spring_models import ARM, INERTIA, MASS, STIFFNESS, angle, flying, pendulum, rate, two_links

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)
METHODS = [(kt.DOP853(), 1e-8), (kt.Radau(), 1e-6)]
METHODS += [(method(step=1e-3), 3e-5) for method in (kt.GeneralizedAlpha, kt.EnergyMomentum, kt.Rattle)]


@pytest.mark.slow
@pytest.mark.parametrize(("method", "off"), METHODS, ids=lambda one: getattr(one, "kind", None))
def test_torsional_pendulum_swings_at_its_frequency(method, off):
    run = kt.dynamics.simulate(pendulum(), 3.0, method=method, samples=61)
    wanted = np.cos(np.sqrt(STIFFNESS / INERTIA) * run.motion.time.values)
    assert angle(run.motion) == pytest.approx(wanted, abs=off)


@pytest.mark.slow
@pytest.mark.parametrize("step", [0.02, 0.01])
def test_second_order_of_the_implicit_methods(step):
    """Half the step: a quarter of the error."""
    error = {}
    for h in (step, step / 2):
        run = kt.dynamics.simulate(pendulum(), 2.0, method=kt.EnergyMomentum(step=h), samples=11)
        error[h] = np.abs(angle(run.motion) - np.cos(np.sqrt(STIFFNESS / INERTIA) * run.motion.time.values)).max()
    assert error[step] / error[step / 2] == pytest.approx(4.0, rel=0.03)


@pytest.mark.slow
def test_large_swing_by_quadrature():
    """t = int d theta/sqrt(2 (V(theta_0) - V(theta))/I), V of spring and weight."""
    start, g = 2.5, 9.81
    run = kt.dynamics.simulate(pendulum(start, g), 0.4, method=FINE, samples=5)

    def potential(theta):
        return 0.5 * STIFFNESS * theta**2 - MASS * g * ARM * np.cos(theta)

    def pace(s, end):  # theta = start - s^2 takes the root at the start away
        return 2 * s / np.sqrt(2 * (potential(start) - potential(start - s * s)) / INERTIA)

    for t, theta in zip(run.motion.time.values[1:], angle(run.motion)[1:], strict=True):
        assert quad(pace, 0, np.sqrt(start - theta), args=(theta,), epsabs=1e-13, epsrel=1e-13)[0] == pytest.approx(t, abs=1e-9)


@pytest.mark.slow
def test_damped_oscillation():
    """theta = e^(-d t) (cos(w t) + d/w sin(w t)), d = c/(2 I)."""
    c = 4.0
    run = kt.dynamics.simulate(pendulum(damping=c), 3.0, method=FINE, samples=31)
    t, d = run.motion.time.values, c / (2 * INERTIA)
    w = np.sqrt(STIFFNESS / INERTIA - d**2)
    assert angle(run.motion) == pytest.approx(np.exp(-d * t) * (np.cos(w * t) + d / w * np.sin(w * t)), abs=1e-10)


@pytest.mark.slow
def test_friction_takes_four_times_its_share_from_the_amplitude_of_a_cycle():
    """Coulomb's friction M: every half cycle loses 2 M/k; with the slip rate towards 0."""
    M, half = 1.5, np.pi / np.sqrt(STIFFNESS / INERTIA)
    off = []
    for slip in (1e-2, 1e-3):
        run = kt.dynamics.simulate(pendulum(friction=M, slip=slip), 5 * half, times=half * np.arange(6), method=kt.Radau())
        wanted = (1.0 - 2 * M / STIFFNESS * np.arange(6)) * (-1.0) ** np.arange(6)
        off.append(np.abs(angle(run.motion) - wanted).max())
    assert off[1] < 2e-3
    assert off[1] < 0.3 * off[0]


def test_play_lets_it_fly():
    """Half a cycle outside the play takes pi/w, the way through it 2 play/v with v = w (A - play)."""
    play, w = 0.2, np.sqrt(STIFFNESS / INERTIA)
    v = w * (1.0 - play)
    period = 2 * np.pi / w + 4 * play / v
    run = kt.dynamics.simulate(pendulum(play=play), 3 * period, times=[0, np.pi / (2 * w) + play / v, period, 3 * period])
    assert angle(run.motion) == pytest.approx([1.0, 0.0, 1.0, 1.0], abs=1e-7)
    assert rate(run.motion)[1] == pytest.approx(-v, rel=1e-8)
    assert run.forces.spring_force.values[1] == 0.0


def test_a_table_on_a_line_is_a_stiffness():
    points = tuple((s, STIFFNESS * s) for s in (-1.0, -0.3, 0.5, 0.8))
    whole, pieces = (
        kt.dynamics.simulate(pendulum(1.3, **law), 2.0, samples=11) for law in ({}, {"stiffness": 0, "table": points})
    )
    assert angle(pieces.motion) == pytest.approx(angle(whole.motion), abs=1e-9)
    assert pieces.potential_energy.values == pytest.approx(whole.potential_energy.values, abs=1e-8)


def test_energy_of_a_table_is_the_integral_of_its_force():
    points = ((-1, -5), (-0.2, -1), (0.1, 0.5), (0.5, 3), (1.2, 20))
    model = pendulum(0.0, stiffness=0, table=points)
    theta = np.linspace(-1.5, 1.5, 3001)
    x = np.zeros((len(theta), 3, 3))
    x[:, 1, 0], x[:, 2, 0], x[:, 2, 1] = 1.0, ARM * np.cos(theta), ARM * np.sin(theta)
    found = named_motions(compile(model), x)
    slope = (found.energy[2:, 0] - found.energy[:-2, 0]) / (theta[2:] - theta[:-2])
    assert found.force[1:-1, 0] == pytest.approx(-slope, abs=2e-4)
    at = np.interp([s for s, _ in points], theta, found.force[:, 0])
    assert at == pytest.approx([-force for _, force in points], abs=1e-6)
    assert found.energy[1500, 0] == pytest.approx(0.0, abs=1e-12)
    assert (np.diff(found.force[:, 0]) <= 1e-12).all()


@pytest.mark.slow
def test_forces_of_inverse_and_forward_dynamics_agree():
    model = two_links()
    run = kt.dynamics.simulate(model, 2.0, samples=41)
    forces = kt.dynamics.inverse(model, run.motion)
    for name in ("member_force", "end_force", "joint_force", "reaction", "spring_force", "spring_value", "action_force"):
        assert forces.data[name].values == pytest.approx(run.forces.data[name].values, abs=1e-9), name
    assert np.abs(forces.energy_balance.values).max() < 1e-11 * np.abs(forces.power.values).max() + 1e-10
    assert forces.dissipation.values.max() > 1.0
    lost = np.trapezoid(forces.dissipation.values, forces.time.values)
    assert run.energy.values[0] - run.energy.values[-1] == pytest.approx(lost, rel=0.02)


def test_the_law_of_every_spring():
    """-(preload + k s) - c c' - M tanh(c'/slip), from angles of the bars."""
    model = two_links()
    run = kt.dynamics.simulate(model, 1.0, samples=21)
    x, v = run.motion.position.values, run.motion.velocity.values
    d, dd = np.stack([x[:, 2] - x[:, 0], x[:, 3] - x[:, 2]]), np.stack([v[:, 2] - v[:, 0], v[:, 3] - v[:, 2]])
    theta = np.unwrap(np.arctan2(d[..., 1], d[..., 0]))
    w = (d[..., 0] * dd[..., 1] - d[..., 1] * dd[..., 0]) / np.sum(d**2, axis=-1)
    start = theta[:, 0]
    found = run.forces.spring_force
    root = -20 * (theta[0] - 0.3) - w[0] - 0.5 * np.tanh(w[0] / 0.05)
    assert found.sel(spring="root").values == pytest.approx(root, abs=1e-9)
    bent = theta[1] - theta[0] - (start[1] - start[0])
    elbow = -8 * (bent - np.clip(bent, -0.1, 0.1)) - 0.2 * (w[1] - w[0])
    assert found.sel(spring="elbow").values == pytest.approx(elbow, abs=1e-9)
    total = theta[0] - 2 * theta[1] - (start[0] - 2 * start[1])
    assert found.sel(spring="sum").values == pytest.approx(-0.7 - 2.0 * total, abs=1e-9)
    assert run.forces.spring_value.sel(spring="root").values == pytest.approx(theta[0], abs=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(
    "method", [kt.Radau(), kt.EnergyMomentum(step=1e-3), kt.GeneralizedAlpha(step=1e-3)], ids=lambda m: m.kind
)
def test_every_law_in_every_engine(method):
    wanted = kt.dynamics.simulate(two_links(), 1.0, samples=11).motion.position.values
    assert kt.dynamics.simulate(two_links(), 1.0, samples=11, method=method).motion.position.values == pytest.approx(
        wanted, abs=1e-4
    )


LAWS = {
    "linear": {"stiffness": 40.0},
    "play": {"stiffness": 40.0, "play": 0.1},
    "table": {"table": ((-1, -60), (0, 0), (1, 90))},
}


@pytest.mark.slow
@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_a_spring_about_a_moving_axis_keeps_energy_and_momenta(law):
    """Energy-momentum steps keep the momenta to round-off and, on this angle, the energy to the order of the step."""
    lost = []
    for step in (0.02, 0.01):
        run = kt.dynamics.simulate(flying(**law), 2.0, method=kt.EnergyMomentum(step=step), samples=101)
        lost.append(np.ptp(run.energy.values))
        assert np.abs(run.momentum.values - run.momentum.values[0]).max() < 1e-10
        assert np.abs(run.angular_momentum.values - run.angular_momentum.values[0]).max() < 1e-9
    assert lost[1] < 0.35 * lost[0]
    exact = kt.dynamics.simulate(flying(**law), 2.0, samples=101)
    assert np.ptp(exact.energy.values) < 1e-7 * exact.energy.values[0]
    assert np.abs(run.motion.position.values - exact.motion.position.values).max() < 0.02


@pytest.mark.slow
@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_springs_in_the_plane_keep_the_energy_in_long_steps(law):
    """Two links whose hinges have springs: energy to round-off with 20 steps a swing."""
    model = two_links()
    springs = {name: kt.Spring(coordinate=model.springs[name].coordinate, **law) for name in ("root", "elbow")}
    run = kt.dynamics.simulate(model.with_(springs=springs), 5.0, method=kt.EnergyMomentum(step=0.02), samples=51)
    assert np.ptp(run.energy.values) < 1e-10 * np.abs(run.kinetic_energy.values).max()


@pytest.mark.slow
def test_a_stiff_chain_of_links_in_long_steps():
    """Bending waves a hundred times faster than the step: the slow swing stays, the energy too."""
    h = 1.0 / 30
    nodes = {"W": (-h, 0.0), "N0": (0.0, 0.0)} | {f"N{k}": kt.Node(at=(k * h, 0.0), mass=h) for k in range(1, 31)}
    ends = [("W" if k == 0 else f"N{k - 1}", f"N{k}", f"N{k + 1}") for k in range(30)]
    model = kt.Model(
        nodes=nodes, fixed=["N0", "W"], gravity=(0, -9.81),
        bars={f"b{k}": kt.Bar(ends=(f"N{k}", f"N{k + 1}"), mass=0.0) for k in range(30)},
        springs={at: kt.Spring(coordinate=kt.HingeDrive(axis=at, start=a, end=b), stiffness=5 / h) for a, at, b in ends},
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 1.0, method=kt.EnergyMomentum(step=0.01), samples=21)
    assert np.ptp(run.energy.values) < 1e-8 * np.abs(run.kinetic_energy.values).max()
    exact = kt.dynamics.simulate(model, 1.0, method=kt.Radau(), samples=21).motion.position.sel(node="N30", axis="y").values
    assert np.abs(run.motion.position.sel(node="N30", axis="y").values - exact).max() < 0.05


@pytest.mark.slow
def test_a_spring_beside_a_drive_in_space_takes_its_moment():
    """Torques of the elbow with and without the spring differ by its law; the rest of the drives' do not."""
    arm = Arm()
    plain = arm.model()
    hinge = kt.HingeDrive(axis=("S1", "S2"), start="O", end="P")
    k, c = 13.0, 0.7
    sprung = plain.with_(springs={"s": kt.Spring(coordinate=hinge, stiffness=k, damping=c)})
    base, elbow = compile(plain).drive_start
    moves = {"base": (base, base + 1.0), "elbow": (elbow, elbow + 1.2)}
    motion = kt.kinematics.follow(plain, kt.Quintic(moves=moves, duration=1.0))
    one, other = kt.dynamics.inverse(plain, motion), kt.dynamics.inverse(sprung, motion)
    more = (other.drive_force - one.drive_force).values
    q, qd = (motion.data[name].sel(drive="elbow").values for name in ("drive_position", "drive_velocity"))
    assert more[:, 0] == pytest.approx(0.0, abs=1e-11)
    assert more[:, 1] == pytest.approx(k * (q - q[0]) + c * qd, abs=1e-10)
    assert np.abs(other.energy_balance.values).max() < 1e-10
    for t in (0.0, 0.4, 0.9):
        found = newton_euler(sprung, motion, other, time=t)
        assert found.matrix @ found.product == pytest.approx(found.right, abs=1e-9)


@pytest.mark.slow
def test_bars_and_nodes_are_in_balance():
    model = two_links()
    run = kt.dynamics.simulate(model, 1.0, samples=11)
    for t in (0.0, 0.5, 1.0):
        for cut in ({"member": "a"}, {"member": "b"}, {"node": "O"}, {"node": "A"}, {"node": "B"}):
            for body in kt.dynamics.free_body(model, run.motion, run.forces, time=t, **cut).bodies:
                assert sum(term.force for term in body.terms) == pytest.approx(body.inertia.force, abs=1e-9)
                assert sum(term.moment for term in body.terms) == pytest.approx(body.inertia.moment, abs=1e-9)
        found = newton_euler(model, run.motion, run.forces, time=t)
        assert found.matrix @ found.product == pytest.approx(found.right, abs=1e-9)


def test_stops_are_given_in_the_equations_of_all_members():
    """Their forces follow from the motion, as those of springs: no unknowns, so that the equations determine the others."""
    model = kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "A": kt.Node(at=(0.6, 0.5), mass=2.0)}, fixed=["O", "G"], bars={"arm": ("O", "A")},
        section=kt.Rod(diameter=0.02), material="steel_s235", drives={"turn": kt.AngleDrive("arm")}, gravity=(0, -9.81),
        stops={"end": kt.Stop(coordinate=kt.HingeDrive(axis="O", start="G", end="A"), lower=0.5, stiffness=300.0)},
    )  # fmt: skip
    start = float(np.arctan2(0.5, 0.6))
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (start, 0.4)}, duration=0.5), samples=3)
    forces = kt.dynamics.inverse(model, motion)
    found = newton_euler(model, motion, forces, time=0.5)
    assert float(forces.data.stop_force.sel(stop="end")[-1]) == pytest.approx(30.0) and found.unique
    assert not any("end" in name for name in found.unknowns)
    assert found.solution == pytest.approx(found.product, abs=1e-9)


def test_bending_moment_at_the_root_is_that_of_the_spring():
    model = pendulum(damping=1.0).with_(section=kt.Rectangle(width=0.03, height=0.02), material=kt.library.materials.STEEL_S235)
    run = kt.dynamics.simulate(model, 0.5, samples=11)
    sections = kt.strength.sections(model, run.forces, stations=3)
    found = np.abs(sections.section_M.sel(part="arm").isel(station=0).values).reshape(11, -1).max(axis=1)
    assert found == pytest.approx(np.abs(run.forces.spring_force.values[:, 0]), abs=1e-9)


def test_joint_reaction_is_the_load_on_the_bearing():
    """A body on a pin with a spring: the force of the pin accelerates its centre; the couple is the spring's."""
    model = kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "P": (1, 1)}, fixed=["O", "G"],
        bodies={"plate": kt.Body(nodes=("O", "P"), mass=2.0, center=(0.4, 0.5), inertia=0.3)},
        springs={"s": kt.Spring(coordinate=kt.HingeDrive(axis="O", start="G", end="P"), stiffness=9.0, rest=0.0)},
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 1.0, samples=11)
    found = kt.dynamics.joint_reaction(model, run.forces, "plate", ["O"])
    x, a = (run.motion.data[name].values for name in ("position", "acceleration"))
    d, dd = x[:, 2], a[:, 2]
    polar = 0.3 + 2.0 * (0.4**2 + 0.5**2)
    wd = (d[:, 0] * dd[:, 1] - d[:, 1] * dd[:, 0]) / np.sum(d**2, axis=1)
    assert run.forces.spring_force.values[:, 0] == pytest.approx(polar * wd, abs=1e-8)
    centre = 0.45 * dd + 0.05 * np.stack([-dd[:, 1], dd[:, 0]], axis=1)  # (0.4, 0.5) by the axes of O -> P = (1, 1)
    assert found.force.values == pytest.approx(2.0 * centre, abs=1e-8)
    assert np.abs(found.moment.values).max() < 1e-12


def test_stiffness_and_damping_are_the_derivatives_of_the_force():
    """Central differences of the nodal forces; the law of friction too."""
    system = compile(two_links())
    rng = np.random.default_rng(2)
    x, v = system.x0.copy(), np.zeros_like(system.x0)
    x[:, :2] += 0.1 * rng.standard_normal((4, 2))
    v[:, :2] = 0.02 * rng.standard_normal((4, 2))
    none = np.zeros(len(system.members))
    K, C = (one.toarray() for one in tangents(system, x, none, none, np.zeros(3), v))
    for given, matrix in ((0, K), (1, C)):
        for flat in range(x.size):
            h = 1e-6
            shifted = np.zeros(x.size)
            shifted[flat] = h
            there = [
                [y + (sign * shifted.reshape(x.shape) if k == given else 0) for k, y in enumerate((x, v))] for sign in (1, -1)
            ]
            slope = (element_forces(system, *there[0]) - element_forces(system, *there[1])) / (2 * h)
            assert -slope == pytest.approx(matrix[:, flat], abs=2e-6)


def test_linearise_gives_the_frequency_and_damping_under_weight():
    """I w^2 = k + m g l at the lowest place; zeta = c/(2 I w)."""
    found = kt.dynamics.linearise(pendulum(0.0, 9.81, damping=1.2))
    w = np.sqrt((STIFFNESS + MASS * 9.81 * ARM) / INERTIA)
    assert found.angular_frequency.values == pytest.approx([w], rel=1e-12)
    assert found.modal_damping.values == pytest.approx([1.2 / (2 * INERTIA * w)], rel=1e-12)


def test_reduced_equations_of_a_pendulum():
    """I theta'' = -k theta - c theta' - m g l sin(theta), by the coordinate P.y."""
    theta, w = 0.7, 1.3
    model = pendulum(theta, 9.81, damping=1.2)
    found = kt.dynamics.reduced_equations(model, "P.y", rates={"P.y": w * ARM * np.cos(theta)})
    wd = -(STIFFNESS * theta + 1.2 * w + MASS * 9.81 * ARM * np.sin(theta)) / INERTIA
    wanted = ARM * np.array([-np.sin(theta) * wd - np.cos(theta) * w**2, np.cos(theta) * wd - np.sin(theta) * w**2])
    assert found.node_acceleration.sel(node="P").values == pytest.approx(wanted, abs=1e-9)


def test_linearised_about_a_motion():
    """A in a moving state: the derivatives of theta'' by angle and rate."""
    theta, w, k, c = 0.7, 1.3, STIFFNESS, 1.2
    velocity = {"P": (-w * ARM * np.sin(theta), w * ARM * np.cos(theta))}
    model = pendulum(theta, 9.81, damping=c, friction=0.4, slip=1.0).with_(
        drives={"d": kt.AngleDrive("arm")}, velocities=velocity
    )
    run = kt.dynamics.simulate(model, 0.1, samples=3, tasks={"d": kt.Free()})
    found = kt.dynamics.linearise(model, run, time=0.0, free=["d"], dofs="d")
    by_angle = -(k + MASS * 9.81 * ARM * np.cos(theta)) / INERTIA
    by_rate = -(c + 0.4 / np.cosh(w) ** 2) / INERTIA
    assert found.A.values[1] == pytest.approx([by_angle, by_rate], rel=1e-9)


def test_taylor_says_why_not():
    with pytest.raises(kt.InputError, match="spring 'hinge' has friction"):
        kt.dynamics.simulate(pendulum(friction=0.1), 1.0, method=kt.Taylor())


def test_beyond_half_a_turn_is_refused():
    model = pendulum(3.0, stiffness=0.01).with_(velocities={"P": (-3.0 * np.sin(3.0), 3.0 * np.cos(3.0))})
    with pytest.raises(kt.AnalysisError, match="half a turn"):
        kt.dynamics.simulate(model, 1.0)
    with pytest.raises(kt.AnalysisError, match="half a turn"):
        kt.dynamics.prepare(model, 1.0).run(1.0, samples=50)


def test_a_constant_moment_over_half_a_turn_is_named_where_the_energy_jumps():
    arm = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1.0)}, fixed=["O"], bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        springs={"coil": kt.Spring(coordinate=kt.AngleDrive("arm"), preload=-2.0)},
    )  # fmt: skip
    with pytest.raises(kt.AnalysisError, match="Spring 'coil' passes half a turn from its rest") as told:
        kt.dynamics.simulate(arm, 4.0, samples=41)
    # a = M t^2/(2 m l^2) is half a turn at sqrt(pi) s
    assert told.value.result.motion.data.time.values[-1] == pytest.approx(np.sqrt(np.pi), abs=0.1)


def test_a_wide_swing_told_by_few_samples_is_none_beyond_half_a_turn():
    run = kt.dynamics.simulate(pendulum(2.9), 3.0, samples=4)
    assert run.status.ok


@pytest.mark.slow
def test_prepared_models_and_runs_have_the_springs():
    model = pendulum(0.5, damping=0.3, friction=0.2).with_(drives={"d": kt.HingeDrive(axis="O", start="G", end="P")})
    moves = kt.Quintic(moves={"d": (0.5, 1.0)}, duration=1.0)
    wanted = kt.dynamics.inverse(model, kt.kinematics.follow(model, moves, samples=11))
    ready = kt.prepare(model)
    carried = ready.forces(ready.follow(moves, samples=11))
    assert carried.drive_force == pytest.approx(wanted.drive_force.values, abs=1e-12)
    swung = kt.dynamics.prepare(pendulum(), 2.0).run(2.0).position[-1, 2]
    assert np.arctan2(swung[1], swung[0]) == pytest.approx(np.cos(2.0 * np.sqrt(STIFFNESS / INERTIA)), abs=1e-8)


@pytest.mark.slow
def test_a_run_keeps_the_springs(tmp_path):
    model = pendulum(0.5).with_(
        drives={"d": kt.HingeDrive(axis="O", start="G", end="P")},
        runs={"turn": kt.Run(trajectory=kt.Quintic(moves={"d": (0.5, 1.0)}, duration=1.0))},
    )
    forces = next(iter(kt.run(model, "turn", tmp_path / "out").forces.values()))
    assert forces.spring_force.values[-1] == pytest.approx([-STIFFNESS * 1.0], abs=1e-9)
    assert forces.drive_force.values[0] == pytest.approx([STIFFNESS * 0.5], abs=1e-9)


SLIDING, RUB, SLIP = 2.0, 400.0, 1e-3


@pytest.mark.parametrize("method", [kt.EnergyMomentum, kt.GeneralizedAlpha], ids=lambda one: one.__name__)
@pytest.mark.parametrize("step", [1e-3, 3e-4, 1e-4, 2e-5])
@pytest.mark.parametrize("speed", [1.0, 1.05, 1.111, 0.37])
def test_dry_friction_brings_a_mass_to_rest(method, step, speed):
    """m v' = -F tanh(v/s): v falls by F t/m, then s m/F sets how it dies away, and the way is m/F (v^2/2 + (pi s)^2/12).

    Friction is damping of F/s at rest, here up to 100 times as stiff as the step. The midpoint rule, which would reverse a
    velocity in place of damping it, ends the run there; what it gives before is right.
    """
    model = kt.Model(
        nodes={"O": (-1, 0), "P": kt.Node(at=(0, 0), mass=SLIDING)},
        fixed={"O": "xy", "P": "y"},
        bars={"eye": kt.Bar(ends=("O", "P"), kind="free")},
        velocities={"P": (speed, 0.0)},
        springs={"rub": kt.Spring(coordinate=kt.CoordinateDrive(node="P", axis="x"), friction=RUB, slip=SLIP)},
    )
    run = kt.dynamics.simulate(model, 0.0125, samples=26, method=method(step=step), raise_on_failure=False)
    v, change = run.motion.velocity.sel(node="P").values[:, 0], RUB / SLIDING * step
    slides = np.maximum(speed - RUB / SLIDING * run.time.values, 0.0)
    assert v == pytest.approx(slides[: len(v)], abs=0.5 * change)
    assert run.time.values[-1] >= speed * SLIDING / RUB - step - 5e-4  # between samples
    if method is kt.EnergyMomentum and step > 2e-4 and run.status is not kt.Status.COMPLETED:
        assert "too long" in run.message
        return
    assert run.status is kt.Status.COMPLETED
    way = SLIDING / RUB * (speed**2 / 2.0 + (math.pi * SLIP) ** 2 / 12.0)
    assert run.motion.position.sel(node="P").values[-1, 0] == pytest.approx(way, abs=0.15 * change * step)
    assert abs(v[-1]) < 2e-3 * change
