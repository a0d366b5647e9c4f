"""Inverse dynamics: closed forms, invariants, redundant and partly free structures."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

import kinetruss as kt

G = 9.81
TUBE = kt.Tube(outer=0.03, inner=0.026)
STEEL = kt.Material(E=210e9, density=7850)


def crank(**bar) -> kt.Model:
    return kt.Model(
        nodes={"O": (0, 0), "T": kt.Node(at=(0.8, 0), mass=bar.pop("tip", 0.0))}, fixed=["O"],
        bars={"crank": {"ends": ("O", "T"), "section": TUBE, "material": STEEL} | bar},
        drives={"motor": kt.AngleDrive("crank")}, gravity=(0, -G),
    )  # fmt: skip


SWING = kt.Quintic(moves={"motor": (0.0, 2.0)}, duration=0.7)


@pytest.mark.parametrize("rotary", [False, True])
def test_torque_of_a_swinging_crank(rotary: bool) -> None:
    """M = (m l^2/3 + m (d^2 + D^2)/16 + M l^2) theta'' + (m/2 + M) g l cos theta."""
    model = crank(tip=1.5, rotary_inertia=rotary)
    motion = kt.kinematics.follow(model, SWING, samples=51)
    forces = kt.dynamics.inverse(model, motion)
    m, l, tip = STEEL.density * TUBE.area * 0.8, 0.8, 1.5
    I = m * l**2 / 3 + tip * l**2 + rotary * m * (TUBE.outer**2 + TUBE.inner**2) / 16
    theta, second = motion.drive_position.values[:, 0], motion.drive_acceleration.values[:, 0]
    np.testing.assert_allclose(forces.drive_force.values[:, 0], I * second + (m / 2 + tip) * G * l * np.cos(theta), atol=1e-11)
    np.testing.assert_allclose(forces.static.drive_force.values[:, 0], (m / 2 + tip) * G * l * np.cos(theta), atol=1e-12)
    rate = motion.drive_velocity.values[:, 0]
    tension = forces.end_force.sel(member="crank", end="A").values
    np.testing.assert_allclose(tension, (m * l / 2 + tip * l) * rate**2 - (m + tip) * G * np.sin(theta), atol=1e-11)


def test_mean_force_is_the_mean_of_the_tension() -> None:
    """T(s) of a turning rod is quadratic; the multiplier is its mean: (T_A + T_B)/2 + m l w^2/12."""
    model = crank()
    motion = kt.kinematics.follow(model, SWING, samples=21)
    forces = kt.dynamics.inverse(model, motion)
    m = STEEL.density * TUBE.area * 0.8
    ends = forces.end_force.sel(member="crank").values
    mean = ends.mean(axis=1) + m * 0.8 * motion.drive_velocity.values[:, 0] ** 2 / 12
    np.testing.assert_allclose(forces.member_force.sel(member="crank"), mean, atol=1e-12)


def jack(**changes) -> kt.Model:
    """A vertical active member that lifts a mass between two guides."""
    fields = {
        "nodes": {"A": (0, 0, 0), "T": kt.Node(at=(0, 0, 1.0), mass=10.0)}, "fixed": {"A": "xyz", "T": "xy"},
        "active": {"jack": kt.Active(ends=("A", "T"), base={"length": 0.6, "mass": 3.0}, tube={"length": 0.5, "mass": 2.0})},
        "gravity": (0, 0, -G),
    }  # fmt: skip
    return kt.Model(**fields | changes)


def test_jack_lifts_its_tube_and_the_load() -> None:
    """Interface force = (tube + load)(g + L''); the base rests on the ground."""
    model = jack()
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"jack": (1.0, 1.4)}, duration=0.5), samples=31)
    forces = kt.dynamics.inverse(model, motion)
    second = motion.drive_acceleration.values[:, 0]
    thrust = (10.0 + 2.0) * (G + second)
    np.testing.assert_allclose(forces.drive_force.values[:, 0], thrust, rtol=1e-13)
    np.testing.assert_allclose(forces.member_force.values[:, 0], -thrust, rtol=1e-13)
    np.testing.assert_allclose(forces.interface_force.sel(component="axial").values[:, 0], -thrust, rtol=1e-13)
    np.testing.assert_allclose(forces.reaction.sel(support="A", axis="z"), thrust + 3.0 * G, rtol=1e-13)
    np.testing.assert_allclose(forces.difference()["member_force"].values[:, 0], -12.0 * second, atol=1e-11)


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(st.integers(0, 10_000))
def test_power_and_momentum_close_for_random_trusses(seed: int) -> None:
    """Three active legs and a bar frame with random numbers: power = rate of energy, reactions = rate of momentum - weight."""
    rng = np.random.default_rng(seed)
    feet = {
        f"f{i}": (*(rng.normal(size=2) + 2 * np.array([np.cos(2.1 * i), np.sin(2.1 * i)])), 0.1 * rng.normal())
        for i in range(3)
    }
    nodes = feet | {"T": kt.Node(at=(*0.3 * rng.normal(size=2), 2.0), mass=rng.uniform(0, 5), gravity=(0, 1.0, 2.0))}
    part = {"length": 0.9, "mass": 2.0, "section": TUBE, "rotary_inertia": True}
    legs = {f"leg{i}": kt.Active(ends=(f"f{i}", "T"), base=part, tube={**part, "length": 0.7}) for i in range(3)}
    nodes |= {"U": kt.Node(at=(0.5, 0.2, 3.1))}
    bars = {f"b{i}": {"ends": ("U", f"f{i}"), "section": TUBE, "material": STEEL, "rotary_inertia": i == 1} for i in range(2)}
    bars |= {"top": {"ends": ("T", "U"), "section": TUBE, "material": STEEL}}
    model = kt.Model(
        nodes=nodes, fixed=list(feet), bars=bars, active=legs, gravity=tuple(rng.normal(size=3) * 5),
        loads={"push": kt.NodalForce(node="T", force=tuple(rng.normal(size=3) * 20))},
    )  # fmt: skip
    assume(kt.kinematics.mobility(model).smallest_singular_value > 0.15)
    lengths = {name: float(np.linalg.norm(np.subtract(nodes["T"].at, feet[leg.ends[0]]))) for name, leg in legs.items()}
    moves = {name: (L, L * (1 + 0.04 * rng.uniform(-1, 1))) for name, L in lengths.items()}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=9, raise_on_failure=False)
    assume(motion.status.ok)
    forces = kt.dynamics.inverse(model, motion)
    scale = np.abs(forces.power.values).max()
    assert np.abs(forces.energy_balance.values).max() < 1e-11 * max(scale, 1.0)
    total = forces.reaction.sum("support").values + np.array(model.loads["push"].force)
    rate = forces.joint_force.sum(("member", "end")).values  # m (a - g) of all members
    lump = model.nodes["T"].mass * (motion.acceleration.sel(node="T").values - [0, 1.0, 2.0])
    np.testing.assert_allclose(total, rate + lump, atol=1e-9)


def three_bars(material: kt.Material | None = STEEL) -> kt.Model:
    """The three-bar truss that every textbook solves: outer bars at angle alpha to the middle one."""
    alpha = np.pi / 5
    return kt.Model(
        nodes={"L": (-np.tan(alpha), 1), "M": (0, 1), "R": (np.tan(alpha), 1), "P": (0, 0)}, fixed=["L", "M", "R"],
        bars={"left": ("L", "P"), "middle": ("M", "P"), "right": ("R", "P")}, section=TUBE, material=material,
        loads={"pull": kt.NodalForce(node="P", force=(0, -1000.0))},
    )  # fmt: skip


def still(model: kt.Model):
    x = np.array([[node.at for node in model.nodes.values()]])
    return kt.kinematics.from_arrays(model, [0.0], x, 0 * x, 0 * x)


def test_redundant_bars_share_by_stiffness() -> None:
    """Timoshenko (1955): N_middle = F/(1 + 2 cos^3 alpha) with equal E A; weightless here."""
    model = three_bars(STEEL.with_(density=0.0))
    forces = kt.dynamics.inverse(model, still(model))
    c = np.cos(np.pi / 5)
    middle = 1000 / (1 + 2 * c**3)
    np.testing.assert_allclose(forces.member_force.values[0], [middle * c**2, middle, middle * c**2], rtol=1e-12)
    assert forces.data.attrs["not_unique"] == ["left", "middle", "right"]
    assert "not unique" in forces.message


def test_redundant_bars_without_stiffness_share_by_least_norm() -> None:
    model = three_bars(None)
    forces = kt.dynamics.inverse(model, still(model))
    c = np.cos(np.pi / 5)
    u = np.array([[-np.sin(np.pi / 5), c], [0, 1], [np.sin(np.pi / 5), c]])
    np.testing.assert_allclose(forces.member_force.values[0], np.linalg.pinv(u.T) @ [0, 1000.0], rtol=1e-12)


@pytest.mark.slow
def test_moving_redundant_truss_balances_at_every_sample() -> None:
    """A braced square on a crank: redundant, in motion; nodes in balance and power closed."""
    s = 0.5
    nodes = {"O": (0, 0), "A": (s, 0), "B": (s, s), "C": (0, s)}
    pairs = {"OA": ("O", "A"), "AB": ("A", "B"), "BC": ("B", "C"), "CO": ("C", "O"), "OB": ("O", "B"), "AC": ("A", "C")}
    model = kt.Model(
        nodes=nodes,
        fixed=["O"],
        bars=pairs,
        section=TUBE,
        material=STEEL,
        drives={"motor": kt.AngleDrive("OA")},
        gravity=(0, -G),
    )
    assert kt.kinematics.mobility(model).self_stress == 1
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": (0.0, 6.0)}, duration=1.0), samples=61)
    forces = kt.dynamics.inverse(model, motion)
    assert np.abs(forces.energy_balance.values).max() < 1e-11
    alone = kt.dynamics.inverse(
        model.with_(bars={k: v for k, v in model.bars.items() if k != "AC"}), motion_without(model, motion)
    )
    np.testing.assert_allclose(forces.drive_force.values, alone.drive_force.values + extra_torque(model, motion), atol=1e-9)


def motion_without(model: kt.Model, motion):
    return kt.kinematics.follow(
        model.with_(bars={k: v for k, v in model.bars.items() if k != "AC"}),
        kt.Quintic(moves={"motor": (0.0, 6.0)}, duration=1.0),
        samples=61,
    )


def extra_torque(model: kt.Model, motion) -> np.ndarray:
    """What the mass of the second diagonal adds to the torque: a uniform rod turning with the square."""
    m, s = STEEL.density * TUBE.area * 0.5 * np.sqrt(2), 0.5
    centre = 0.25 * np.array([1, 1])
    theta = motion.drive_position.values
    I = m * (2 * s**2) / 12 + m * (centre @ centre)
    return I * motion.drive_acceleration.values + m * G * (np.cos(theta) * centre[0] - np.sin(theta) * centre[1])


def test_given_motion_of_a_free_pendulum() -> None:
    """Tension of a pendulum from its own exact motion: m (l w^2 + g cos); nothing is left over along the swing."""
    l, m = 0.7, 2.0
    model = kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(0, -l), mass=m)}, fixed=["O"], bars={"rod": ("O", "P")}, gravity=(0, -G)
    )
    theta, w = np.array([0.3, -0.8]), np.array([1.1, 0.4])
    second = -G / l * np.sin(theta)
    s, c = np.sin(theta), np.cos(theta)
    zero = np.zeros((2, 2))
    x = np.stack([zero, l * np.stack([s, -c], 1)], axis=1)
    v = np.stack([zero, l * w[:, None] * np.stack([c, s], 1)], axis=1)
    a = np.stack([zero, l * (second[:, None] * np.stack([c, s], 1) + w[:, None] ** 2 * np.stack([-s, c], 1))], axis=1)
    forces = kt.dynamics.inverse(model, kt.kinematics.from_arrays(model, [0.0, 1.0], x, v, a))
    np.testing.assert_allclose(forces.member_force.values[:, 0], m * (l * w**2 + G * c), rtol=1e-12)
    assert np.abs(forces.energy_balance.values).max() < 1e-12


def test_load_cases_tables_and_gravity() -> None:
    model = jack(
        loads={
            "step": kt.NodalForce(node="T", times=(0.0, 1.0), forces=((0, 0, 0), (0, 0, -100.0))),
            "side": kt.NodalForce(node="T", force=(7.0, 0, 0)),
        },
        load_cases={"half": kt.LoadCase(loads={"step": 0.5}), "space": kt.LoadCase(loads={}, gravity=(0, 0, 0))},
    )
    hold = kt.Quintic(moves={"jack": (1.0, 1.0)}, duration=1.0)
    motion = kt.kinematics.follow(model, hold, samples=3)
    thrust = {name: kt.dynamics.inverse(model, motion, name).drive_force.values[:, 0] for name in (None, "half", "space")}
    np.testing.assert_allclose(thrust[None], 12 * G + np.array([0, 50, 100]), rtol=1e-13)
    np.testing.assert_allclose(thrust["half"], 12 * G + np.array([0, 25, 50]), rtol=1e-13)
    np.testing.assert_allclose(thrust["space"], 0, atol=1e-12)
    side = kt.dynamics.inverse(model, motion).reaction.sel(support="T", axis="x")
    np.testing.assert_allclose(side, -7.0, rtol=1e-13)
    with pytest.raises(kt.InputError, match="No load case called 'full'"):
        kt.dynamics.inverse(model, motion, "full")


def test_offloaded_payload_has_no_weight_but_inertia() -> None:
    model = jack(nodes={"A": (0, 0, 0), "T": kt.Node(at=(0, 0, 1.0), mass=10.0, gravity=(0, 0, 0))})
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"jack": (1.0, 1.4)}, duration=0.5), samples=11)
    forces = kt.dynamics.inverse(model, motion)
    second = motion.drive_acceleration.values[:, 0]
    np.testing.assert_allclose(forces.drive_force.values[:, 0], 12 * second + 2 * G, atol=1e-11)
    assert np.abs(forces.energy_balance.values).max() < 1e-11


def test_elastic_bar_pulls_by_its_law() -> None:
    section, material = kt.Rod(diameter=0.002), STEEL.with_(density=0.0)
    model = jack(
        bars={
            "spring": {
                "ends": ("A", "T"),
                "kind": "elastic",
                "section": section,
                "material": material,
                "natural_length": 0.9999,
            }
        }
    )
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"jack": (1.0, 1.0002)}, duration=1.0), samples=5)
    forces = kt.dynamics.inverse(model, motion)
    pull = 210e9 * section.area / 0.9999 * (motion.drive_position.values[:, 0] - 0.9999)
    np.testing.assert_allclose(forces.member_force.sel(member="spring"), pull, rtol=1e-9)
    np.testing.assert_allclose(forces.static.drive_force.values[:, 0], 12 * G + pull, rtol=1e-12)
    assert np.abs(forces.energy_balance.values).max() < 1e-9


def test_shaken_support_does_work() -> None:
    t = np.linspace(0, 1, 41)
    lift = kt.History(times=t, displacements=np.stack([0 * t, 0 * t, 0.05 * np.sin(4 * t)], axis=1))
    model = jack(support_motion={"A": lift})
    motion = kt.kinematics.follow(model, kt.Sine(amplitudes={"jack": 0.1}, period=0.8, duration=1.0), samples=23)
    forces = kt.dynamics.inverse(model, motion)
    assert np.abs(forces.power.values).max() > 1.0
    assert np.abs(forces.energy_balance.values).max() < 1e-11 * np.abs(forces.power.values).max()


def test_motion_of_another_model_is_refused() -> None:
    motion = kt.kinematics.follow(crank(), SWING, samples=3)
    with pytest.raises(kt.InputError, match="belongs to a model with other nodes"):
        kt.dynamics.inverse(jack(), motion)
