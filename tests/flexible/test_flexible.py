"""Elastic members and actuators: against linearisation, nonlinear simulation, equilibrium and the laws they must obey."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt

SECTION = kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)
TILT = math.radians(10)
TOP = ("N7.z", "N8.z", "N9.z")


def bay(E: float = 71e9, **more) -> kt.Model:
    material = kt.Material(E=E, density=2711.5)
    return kt.library.vgt.double_octahedral(gravity=(0, 0, -9.81), payload_mass=5.0, material=material, **more)


def slewed(model: kt.Model, samples: int = 101, duration: float = 0.5) -> kt.results.Forces:
    slew = kt.library.vgt.slew(beta=(-TILT, TILT), duration=duration)
    return kt.dynamics.inverse(model, kt.kinematics.follow(model, slew, samples=samples), static=False)


@pytest.fixture(scope="module")
def along() -> tuple[kt.Model, kt.results.Forces]:
    model = bay()
    return model, slewed(model)


def frame(kind: str = "rigid") -> kt.Model:
    """A redundant planar frame with a driven bar, a spring and a cable."""
    bars = {
        name: kt.Bar(ends=ends, kind=kind, stiffness=None if kind == "rigid" else 7e6 / length)
        for name, ends, length in (("low", ("A", "C"), 1.0), ("up", ("B", "D"), 1.0), ("post", ("C", "D"), 1.0))
    }
    bars |= {
        "cross": kt.Bar(ends=("A", "D"), kind="driven" if kind == "rigid" else "elastic", section=SECTION),
        "spring": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=2e6, pretension=3e3),
        "rope": kt.Bar(ends=("D", "E"), kind="cable", stiffness=1e6, pretension=2e3),
    }
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": {"at": (1, 0), "mass": 2.0}, "D": {"at": (1, 1), "mass": 3.0}, "E": (2, 2)},
        fixed=("A", "B", "E"),
        bars=bars,
        section=SECTION,
        material=kt.Material(E=70e9, density=2700.0),
        gravity=(0, -9.81),
    )


def test_frequencies_are_those_of_the_linearised_elastic_structure():
    rigid = frame()
    still = kt.statics.at_poses(rigid, [{}])
    found = kt.flexible.frequencies(rigid, still, 4, stiffness=dict.fromkeys(("low", "up", "post"), 7000000.0))
    soft = frame("elastic")
    # the same tensions: natural lengths such that the bars carry them where they stand
    force = {name: float(still.member_force.sel(member=name).values[0]) for name in ("low", "up", "post", "cross")}
    tight = {name: soft.bars[name] for name in soft.bars}
    for name, N in force.items():
        k = 7e6 if name != "cross" else 70e9 * 1e-4 / math.sqrt(2)
        length = math.sqrt(2) if name == "cross" else 1.0
        bar = tight[name]
        tight[name] = kt.Bar(ends=bar.ends, kind="elastic", section=SECTION, stiffness=k, natural_length=length - N / k)
    lin = kt.dynamics.linearise(soft.with_(bars=tight), inputs=())
    np.testing.assert_allclose(found.frequency.values[0], lin.frequency.values, rtol=1e-9)


@pytest.mark.slow
def test_modes_are_orthogonal_and_energy_shares_add_up(along):
    model, forces = along
    found = kt.flexible.frequencies(model, forces, 5)
    assert np.all(np.diff(found.frequency.values[0]) > 0)
    assert found.mac.values.min() > 0.9
    share = found.actuator_share.values.sum(axis=2)
    assert np.all((share > 0) & (share < 1 + 1e-9))


def two_springs() -> kt.Model:
    """Two masses on bars of their own; the first becomes slower as it is lengthened."""
    return kt.Model(
        nodes={"A": (0, 0), "P": {"at": (1, 0), "mass": 1.0}, "B": (0, 1), "Q": {"at": (1.2, 1), "mass": 1.0}},
        fixed={"A": "xy", "B": "xy", "P": "y", "Q": "y"},
        bars={"a": kt.Bar(ends=("A", "P"), kind="driven"), "b": kt.Bar(ends=("B", "Q"), kind="driven")},
        section=SECTION,
        material=kt.Material(E=70e9, density=0.0),
    )


def test_modes_keep_their_places_where_frequencies_cross():
    model = two_springs()
    move = kt.Quintic(moves={"a": (1.0, 1.5)}, duration=1.0)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, move, samples=40), static=False)
    found = kt.flexible.frequencies(model, forces, 2)
    length = forces.motion.length.values
    expected = np.sqrt(70e9 * 1e-4 / length) / (2 * math.pi)
    assert expected[0, 0] > expected[0, 1]
    assert expected[-1, 0] < expected[-1, 1]
    np.testing.assert_allclose(found.frequency.values, expected[:, ::-1], rtol=1e-12)
    np.testing.assert_allclose(found.actuator_share.values[:, :, ::-1], np.tile(np.eye(2), (40, 1, 1)), atol=1e-12)


@pytest.mark.slow
def test_what_is_settled_is_the_deflection(along):
    model, forces = along
    shaken = kt.flexible.vibration(model, forces, tolerance=0.1)
    small = kt.statics.deflection(model, forces).displacement.values
    # geometric stiffness of the members' own tension is all that differs
    assert np.abs(shaken.settled.values - small).max() < 1e-3 * np.abs(small).max()


@pytest.mark.slow
def test_vibration_is_the_simulation_to_second_order():
    off, size, slew = [], [], kt.library.vgt.slew(beta=(-TILT, TILT), duration=0.5)
    for E in (71e8, 71e9):
        model = bay(E)
        begun = kt.kinematics.follow(model, slew, times=np.linspace(0.0, 0.15, 31))
        forces = kt.dynamics.inverse(model, begun, static=False)
        shaken = kt.flexible.vibration(model, forces, tolerance=1e-4).displacement.values[:21]
        run = kt.flexible.simulate(model, slew, 0.1, samples=21)
        own = run.motion.position.values - forces.motion.position.values[:21]
        off.append(np.abs(own - shaken).max())
        size.append(np.abs(own).max())
    assert off[0] < 0.01 * size[0]
    assert off[1] < 0.001 * size[1]
    # ten times as stiff: u a tenth, the difference about a hundredth
    assert 40 < off[0] / off[1] < 250


@pytest.mark.slow
def test_vibration_of_what_has_inextensible_members(along):
    model, forces = along
    stiff = tuple(name for name in model.bars if name.startswith("M1"))
    some = kt.flexible.vibration(model, forces, rigid=stiff, tolerance=1e-3)
    assert np.abs(some.elongation.sel(member=list(stiff)).values).max() < 1e-12
    near = kt.flexible.vibration(model, forces, stiffness=dict.fromkeys(stiff, 1e13), tolerance=1e-3)
    size = np.abs(near.displacement.values).max()
    assert np.abs(some.displacement.values - near.displacement.values).max() < 5e-3 * size


@pytest.mark.slow
def test_damping_takes_the_residual_vibration_away(along):
    model, forces = along
    quiet, loud = (kt.flexible.vibration(model, forces, damping=z, rest=0.2, tolerance=1e-2) for z in (0.1, 0.0))
    assert loud.attrs["overshoot"] >= 1.0 - 1e-9
    left = np.abs(quiet.displacement.values[-5:] - quiet.settled.values[-5:]).max()
    # ten per cent of critical in seven periods: exp(-0.1 x 2 pi x 7) = 0.012
    assert left < 0.03 * loud.attrs["residual"]


@pytest.mark.slow
def test_damped_vibration_and_simulation_agree_on_a_line():
    model = two_springs()
    move = kt.Quintic(moves={"a": (1.0, 1.02)}, duration=0.02)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, move, samples=81), static=False)
    given = {"a": 7e6, "b": 7e6}
    shaken = kt.flexible.vibration(model, forces, damping=0.2, stiffness=given, tolerance=1e-6)
    run = kt.flexible.simulate(model, move, damping=2 * 0.2 / math.sqrt(7e6), stiffness=given, samples=81)
    off = run.motion.position.values - forces.motion.position.values
    assert np.abs(off).max() > 1e-6
    np.testing.assert_allclose(shaken.displacement.values, off, atol=1e-6 * np.abs(off).max())


def test_a_drive_that_is_no_elastic_length_is_told():
    crank = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 1.0}},
        fixed=("A",),
        bars={"b": ("A", "B")},
        section=SECTION,
        material=kt.Material(E=70e9, density=0.0),
        drives={"motor": kt.AngleDrive("b")},
    )
    with pytest.raises(kt.InputError, match="Drive 'motor' is no length of an elastic member"):
        kt.flexible.simulate(crank, kt.Quintic(moves={"motor": (0.0, 0.1)}, duration=0.1))


def test_poses_do_not_vibrate():
    model = two_springs()
    with pytest.raises(kt.InputError, match="do not vibrate"):
        kt.flexible.vibration(model, kt.statics.at_poses(model, [{}] * 4))


@pytest.mark.slow
def test_the_slow_motion_gives_the_rigid_forces(along):
    """The difference is inertia of the vibration: it falls with the square of the duration at least."""
    model, _ = along
    sizes = []
    for duration in (1.0, 2.0):
        forces = slewed(model, 101, duration)
        sizes.append(np.abs(kt.flexible.vibration(model, forces, tolerance=1e-3).difference.values[20:80]).max())
    assert sizes[0] / sizes[1] > 3.5


@pytest.mark.slow
def test_corrected_lengths_bring_the_bay_to_its_pose(along):
    model, forces = along
    found = kt.flexible.corrected(model, forces, TOP)
    assert np.abs(found.error.values).max() < 1e-13
    top = found.displacement.sel(node=["N7", "N8", "N9"], axis="z").values
    assert np.abs(top).max() < 1e-13
    # first order: what statics.deflection has, taken back through the Jacobian
    jacobian = kt.kinematics.jacobian(model, forces.motion.position.values[0], of=TOP, wrt=("M7", "M9", "M11")).values
    u = kt.statics.deflection(model, forces).displacement.isel(time=0).sel(node=["N7", "N8", "N9"], axis="z").values
    np.testing.assert_allclose(found.change.values[0], -np.linalg.solve(jacobian, u), rtol=2e-3)
    moved = kt.kinematics.follow(model, found.trajectory, times=forces.motion.time.values)
    np.testing.assert_allclose(moved.length.sel(member="M7").values, found.drive_length.sel(drive="M7").values, rtol=1e-12)


@pytest.mark.slow
def test_fewer_coordinates_than_drives_take_the_least_change(along):
    model, forces = along
    one = kt.flexible.corrected(model, forces, "N7.z")
    all_three = kt.flexible.corrected(model, forces, TOP)
    assert np.abs(one.error.values).max() < 1e-13
    least, other = (np.linalg.norm(found.change.values, axis=1) for found in (one, all_three))
    assert np.all(least <= other * (1 + 1e-9))


def test_feedback_of_force_and_rate_only_takes_energy(along):
    model, forces = along
    for kind, gains in (("force", (1.0, 30.0, 1e3, 1e5)), ("rate", (1.0, 1e3, 1e5))):
        found = kt.flexible.active_damping(model, forces, gains, kind=kind, modes=4)
        real = found.pole_real.values
        assert np.all(real[np.isfinite(real)] < 1e-6)
        small = found.damping.values[0] / found.first_order_damping.values[0]
        np.testing.assert_allclose(small, 1.0, rtol=1e-2)
    modes = kt.flexible.frequencies(model, forces, 4)
    np.testing.assert_allclose(found.frequency.values, modes.frequency.values[0], rtol=1e-9)
    assert np.all(found.share.values < 1)


def test_feedback_counts_motions_without_mass():
    """A node without mass between the actuator and a spring: the series is one spring."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": {"at": (2, 0), "mass": 2.0}, "D": (3, 0)},
        fixed={"A": "xy", "B": "y", "C": "y", "D": "xy"},
        bars={
            "act": kt.Bar(ends=("A", "B"), kind="driven"),
            "link": kt.Bar(ends=("B", "C")),
            "side": kt.Bar(ends=("C", "D"), kind="elastic", stiffness=1e6),
        },
        section=SECTION,
        material=kt.Material(E=70e9, density=0.0),
    )
    forces = kt.statics.at_poses(model, [{}])
    given = {"act": 6e6, "link": 6e6}
    g = 200.0
    found = kt.flexible.active_damping(model, forces, g, stiffness=given, modes=1)
    # T = 6e6 (e_act - d), in series with the link: T = 3e6 (x - d); d' = g T/6e6
    roots = np.roots([2.0, 2.0 * g / 2, 4e6, 1e6 * g / 2])
    root = roots[roots.imag > 0][0]
    np.testing.assert_allclose(found.pole_real.values[0, 0] + 1j * found.pole_imag.values[0, 0], root, rtol=1e-9)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda m, f: kt.flexible.frequencies(m, f, 0), "whole number"),
        (lambda m, f: kt.flexible.frequencies(m, f, stiffness={"M99": 1e6}), "'M99' is no rigid or driven member"),
        (lambda m, f: kt.flexible.frequencies(m, f, stiffness={"M7": -1.0}), "positive"),
        (lambda m, f: kt.flexible.frequencies(m, f, rigid=[*m.bars, *m.active]), "No member is elastic|Nothing can move"),
        (lambda m, f: kt.flexible.frequencies(two_springs(), f), "other members"),
        (lambda m, f: kt.flexible.vibration(m, f, damping=2.0), "ratio"),
        (lambda m, f: kt.flexible.vibration(m, f, rest=-1.0), "rest"),
        (lambda m, f: kt.flexible.corrected(m, f, ("N7", "N8.z")), "4 coordinates cannot be held by 3 drives"),
        (lambda m, f: kt.flexible.corrected(m, f, "N1.x"), "do not move 'N1.x'"),
        (lambda m, f: kt.flexible.corrected(m, f, ("N7.z", "N7.x", "N9.x")), "do not move 'N[79].x' independently"),
        (lambda m, f: kt.flexible.corrected(m, f, "N7.z", drives="M1"), "'M1' is no driven length"),
        (lambda m, f: kt.flexible.active_damping(m, f, -1.0), "0 or more"),
        (lambda m, f: kt.flexible.active_damping(m, f, 1.0, sample=101), "samples 0 to 100"),
        (lambda m, f: kt.flexible.active_damping(m, f, 1.0, rigid=["M7"]), "'M7' is inextensible"),
        (lambda m, f: kt.flexible.active_damping(m, f, 1.0, kind="speed"), "'force' or 'rate'"),
    ],
)
def test_what_cannot_be_is_told(along, call, said):
    with pytest.raises(kt.InputError, match=said):
        call(*along)


def test_a_crane_that_is_too_soft_is_told():
    bars = {"boom": ("A", "C"), "tie": ("B", "C"), "jib": ("C", "D"), "stay": ("B", "D")}
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 2), "C": (2, 0.5), "D": {"at": (3, 1.5), "mass": 200.0}},
        fixed=("A", "B"),
        bars={name: kt.Bar(ends=ends, kind="driven" if name in ("tie", "stay") else "rigid") for name, ends in bars.items()},
        section=SECTION,
        material=kt.Material(E=1e9, density=0.0),
        gravity=(0, -9.81),
    )
    with pytest.raises(kt.AnalysisError, match="sample 1"):
        kt.flexible.corrected(model, kt.statics.at_poses(model, [{}, {"tie": 2.6, "stay": 3.2}]), ("D.x", "D.y"))


def test_the_top_of_a_mast_has_five_freedoms_not_nine():
    model = kt.library.vgt.double_octahedral(3, gravity=(0, 0, -9.81), payload_mass=5.0)
    forces = kt.statics.at_poses(model, [{}, {"B1.beta": 0.1}])
    with pytest.raises(kt.InputError, match="independently of the other coordinates"):
        kt.flexible.corrected(model, forces, ("B3.N7", "B3.N8", "B3.N9"))
    found = kt.flexible.corrected(model, forces, ("B3.N7", "B3.N8.z", "B3.N9.z"))
    assert np.abs(found.error.values).max() < 1e-12


def swinging(**spring: float) -> kt.Model:
    """A rigid bar that only a hinge spring holds, with a mass at its tip."""
    return kt.Model(
        nodes={"A": (0, 0), "B": {"at": (0.8, 0), "mass": 2.0}},
        fixed=["A"],
        bars={"b": kt.Bar(ends=("A", "B"), mass=0.6)},
        springs={"hinge": kt.Spring(coordinate=kt.AngleDrive("b"), **spring)},
        gravity=(0, -9.81),
    )


def test_where_only_a_hinge_spring_gives_way():
    """w^2 = k/J with J = (m + m_bar/3) l^2, and the weight's moment over k as the settled angle."""
    model, k, J = swinging(stiffness=500.0), 500.0, (2.0 + 0.2) * 0.64
    found = kt.flexible.frequencies(model, kt.statics.at_poses(model, [{}]), 1)
    np.testing.assert_allclose(2 * math.pi * found.frequency.values, math.sqrt(k / J), rtol=1e-12)
    x = np.tile(np.array([[0.0, 0.0], [0.8, 0.0]]), (5, 1, 1))
    still = kt.kinematics.from_arrays(model, np.linspace(0, 0.1, 5), x, 0 * x, 0 * x)
    shaken = kt.flexible.vibration(model, kt.dynamics.inverse(model, still, static=False), tolerance=1e-6)
    sunk = -(2.0 + 0.3) * 9.81 * 0.8 / k * 0.8
    np.testing.assert_allclose(shaken.settled.sel(node="B", axis="y").values, sunk, rtol=1e-9)
    np.testing.assert_allclose(shaken.displacement.sel(node="B", axis="y").values, sunk, rtol=1e-6)
    # a spring without stiffness leaves a mechanism
    loose = swinging(damping=1.0)
    with pytest.raises(kt.InputError, match="not stiff in this position"):
        kt.flexible.frequencies(loose, kt.statics.at_poses(loose, [{}]), 1)


LEAD = kt.Compliance(screw=2.5e6, nut=3e7, base=8e6)


def lifted() -> tuple[kt.Model, kt.Quintic]:
    """A mass on an actuator with a compliance, moved along x."""
    rod = {"mass": 0.0, "section": SECTION, "material": kt.Material(E=70e9, density=0.0)}
    lift = kt.Active(
        ends=("A", "B"), base=kt.Part(length=0.5, **rod), tube=kt.Part(length=0.4, **rod), compliance=LEAD, limits=(0.55, 1.2)
    )
    model = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (0.6, 0), "mass": 40.0}},
        fixed={"A": "xy", "B": "y"},
        active={"lift": lift},
        gravity=(-9.81, 0),
    )
    return model, kt.Quintic(moves={"lift": (0.6, 0.9)}, duration=0.2)


def lead_flexibility(length: np.ndarray) -> np.ndarray:
    """Screw, tube, nut and base in series, m/N."""
    return (length - 0.4) / 2.5e6 + 0.4 / 7e6 + 1 / 3e7 + 1 / 8e6


@pytest.mark.slow
def test_an_actuator_gives_way_by_its_compliance():
    """Frequencies, corrected lengths, settled displacements and the deflection of a mass, at every length."""
    model, move = lifted()
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, move, samples=41), static=False)
    length = forces.motion.length.sel(member="lift").values
    f = lead_flexibility(length)
    load = -40.0 * (9.81 + forces.motion.acceleration.sel(node="B", axis="x").values)
    found = kt.flexible.frequencies(model, forces, 1)
    np.testing.assert_allclose(2 * math.pi * found.frequency.values[:, 0], 1 / np.sqrt(40.0 * f), rtol=1e-12)
    np.testing.assert_allclose(found.actuator_share.values[:, 0, 0], 1.0, rtol=1e-12)
    lin = kt.dynamics.linearise(model, forces.motion, time=0.1)
    np.testing.assert_allclose(lin.frequency.values, found.frequency.values[20], rtol=1e-9)
    change = kt.flexible.corrected(model, forces, "B.x").change.values[:, 0]
    np.testing.assert_allclose(change, -load * f, rtol=1e-9, atol=1e-15)
    small = kt.statics.deflection(model, forces).displacement.sel(node="B", axis="x").values
    np.testing.assert_allclose(small, load * f, rtol=1e-12, atol=1e-18)
    shaken = kt.flexible.vibration(model, forces, tolerance=1e-4)
    np.testing.assert_allclose(shaken.settled.sel(node="B", axis="x").values, load * f, rtol=1e-9, atol=1e-15)


@pytest.mark.slow
def test_a_compliant_actuator_in_simulation():
    """m x'' = -m g - (x - l0)/f(l0), integrated by another method; `vibration` agrees to first order."""
    from scipy.integrate import solve_ivp

    model, move = lifted()
    run = kt.flexible.simulate(model, move, 0.25, samples=26)
    t = run.time.values

    def natural(s: float) -> float:
        # quintic from 0.6 to 0.9 m
        r = min(s / 0.2, 1.0)
        return 0.6 + 0.3 * r**3 * (10 - 15 * r + 6 * r * r)

    def rates(s: float, y: np.ndarray) -> list[float]:
        l0 = natural(s)
        return [y[1], -9.81 - (y[0] - l0) / (40.0 * float(lead_flexibility(l0)))]

    own = solve_ivp(rates, (0, 0.25), [0.6 - 40 * 9.81 * lead_flexibility(0.6), 0.0], t_eval=t, rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(run.motion.position.sel(node="B", axis="x").values, own.y[0], atol=1e-9)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, move, samples=81), static=False)
    shaken = kt.flexible.vibration(model, forces, tolerance=1e-4)
    off = np.interp(t[:21], forces.time.values, shaken.displacement.sel(node="B", axis="x").values)
    bent = own.y[0][:21] - np.array([natural(s) for s in t[:21]])
    assert np.abs(off - bent).max() < 0.01 * np.abs(bent).max()
