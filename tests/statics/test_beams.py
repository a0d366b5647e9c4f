"""Beams: rigid motions, orders, an independent rod, groups of frames, releases, clamps on bodies, motion."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.integrate import solve_ivp
from scipy.optimize import root
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_energy, element_forces, element_tangents
from kinetruss.mechanics.tables import continua_mass

STEEL = kt.Material(E=200e9, density=7800.0, yield_strength=235e6)
BOX = kt.Rectangle(width=0.03, height=0.02)
MATTER = {"material": STEEL, "section": BOX}


def frame_in_space() -> kt.Model:
    """Three beams that meet stiffly at B, one of them released."""
    return kt.Model(
        nodes={"A": (0, 0, 0), "B": (1.0, 0.2, 0.1), "C": (1.3, 1.1, -0.2), "D": (1.2, 0.1, 0.9)},
        beams={
            "a": ("A", "B"),
            "b": kt.Beam(ends=("B", "C"), orientation=(0, 1, 3)),
            "c": kt.Beam(ends=("D", "B"), release=["D"]),
        },
        **MATTER,
    )


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(turn=st.tuples(*[st.floats(-3, 3)] * 3), shift=st.tuples(*[st.floats(-5, 5)] * 3))
def test_rigid_motions_give_no_energy_and_no_force(turn, shift):
    system = compile(frame_in_space())
    x = Rotation.from_rotvec(turn).apply(system.x0.copy()) + np.array(shift)
    assert abs(element_energy(system, x)) < 1e-12 * STEEL.E * BOX.area
    assert np.abs(element_forces(system, x)).max() < 1e-10 * STEEL.E * BOX.area


def test_mass_is_that_of_the_beams():
    """Total mass, first moments and the kinetic energy of rigid rotations about every axis."""
    model = frame_in_space()
    system = compile(model)
    M, total, inertia = continua_mass(system), 0.0, np.zeros((3, 3))
    for beam in model.beams.values():
        a, b = (np.array(model.nodes[end].at) for end in beam.ends)
        mass, d = STEEL.density * BOX.area * np.linalg.norm(b - a), b - a
        total += mass
        second = mass * (np.outer(a, a) + (np.outer(a, d) + np.outer(d, a)) / 2 + np.outer(d, d) / 3)
        inertia += np.trace(second) * np.eye(3) - second
    for axis in np.eye(3):
        v = np.tile(axis, len(system.nodes))
        assert v @ M @ v == pytest.approx(total, rel=1e-12)
        w = np.cross(axis, system.x0).reshape(-1)
        # rotary inertia of the sections: of the order (0.03 m)^2 of 1 m^2
        assert w @ M @ w == pytest.approx(inertia[np.flatnonzero(axis)[0], np.flatnonzero(axis)[0]], rel=1e-3)
        assert w @ M @ w > axis @ inertia @ axis


def test_the_tangent_is_the_derivative_of_the_forces():
    system = compile(frame_in_space())
    rng = np.random.default_rng(3)
    x = system.x0 + 0.05 * rng.standard_normal(system.x0.shape)
    u = rng.standard_normal(x.shape)
    h = 1e-4
    f = {k: element_forces(system, x + k * h * u) for k in (-2, -1, 1, 2)}
    slope = (f[-2] - 8 * f[-1] + 8 * f[1] - f[2]) / (12 * h)
    K = element_tangents(system, x, None)[0]
    assert np.allclose(-(K @ u.reshape(-1)), slope.reshape(-1), rtol=0, atol=1e-8 * np.abs(slope).max())


def rod_tip(load: float) -> np.ndarray:
    """The 45-degree bend as Kirchhoff's rod with E A: the tip at which the end of the integrated curve lies."""
    EI, GJ, EA, R = 1e7 / 12, 5e6 / 6, 1e7, 100.0

    def rates(_, y, tip, force):
        Q = y[3:].reshape(3, 3)
        n, m = Q.T @ force, Q.T @ np.cross(tip - y[:3], force)
        k = np.array([m[0] / GJ, m[1] / EI, m[2] / EI + 1 / R])
        K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
        return np.concatenate([(1 + n[0] / EA) * Q[:, 0], (Q @ K).ravel()])

    def gap(tip, force):
        start = np.concatenate([np.zeros(3), np.eye(3).ravel()])
        end = solve_ivp(rates, (0, R * math.pi / 4), start, args=(tip, force), rtol=1e-10, atol=1e-10, method="DOP853")
        return end.y[:3, -1] - tip

    tip = np.array([R * math.sin(math.pi / 4), R * (1 - math.cos(math.pi / 4)), 0.0])
    for part in np.linspace(load / 6, load, 6):
        tip = root(gap, tip, args=(np.array([0, 0, part]),), tol=1e-11).x
    return tip


@pytest.mark.slow
def test_the_bend_of_45_degrees_is_that_of_a_curved_rod():
    from kinetruss.verification.beams import bend

    wanted = rod_tip(450.0)
    found = bend(16, 450.0)
    assert [found["y"], found["x"], found["z"]] == pytest.approx(list(wanted), abs=0.02)


def test_a_rotated_frame_bends_alike():
    """Frames are along global axes: the same cantilever in any direction has the same deflection."""
    sizes = []
    for rotation in (Rotation.identity(), Rotation.from_rotvec([0.4, -1.1, 2.0])):
        tip, up, force = rotation.apply([[1.2, 0, 0], [0, 0, 1.0], [0, 30.0, 80.0]])
        model = kt.Model(
            nodes={"A": (0, 0, 0), "B": tuple(tip)},
            beams={"b": kt.Beam(ends=("A", "B"), orientation=tuple(up))},
            clamped=["A"],
            loads={"P": kt.NodalForce(node="B", force=tuple(force))},
            **MATTER,
        )
        sizes.append(rotation.inv().apply(kt.statics.equilibrium(model).position.sel(node="B").values))
    assert np.allclose(*sizes, rtol=0, atol=1e-10)


def test_rigid_beams_releases_and_clamps_on_bodies():
    EI, P = STEEL.E * BOX.second_moments[1], 10.0
    load = {"P": kt.NodalForce(node="C", force=(0, -P))}
    nodes = {"A": (0, 0), "B": (1, 0), "C": (2, 0)}
    stiff = kt.Model(
        nodes=nodes, beams={"r": kt.Beam(ends=("A", "B"), kind="rigid"), "e": ("B", "C")}, clamped=["A"], loads=load, **MATTER
    )
    assert kt.statics.linear(stiff).displacement.sel(node="C", axis="y") == pytest.approx(-P / (3 * EI), rel=1e-9)
    # a released end carries no moment: B hangs on the cantilever A-B only
    hinged = kt.Model(
        nodes=nodes,
        beams={"e": ("A", "B"), "f": kt.Beam(ends=("B", "C"), release=["B"])},
        clamped=["A"],
        fixed={"C": "xy"},
        loads={"P": kt.NodalForce(node="B", force=(0, -P))},
        **MATTER,
    )
    found = kt.statics.linear(hinged)
    assert found.displacement.sel(node="B", axis="y") == pytest.approx(-P / (3 * EI), rel=1e-9)
    M = kt.strength.beams(hinged, found, stations=2).section_M.sel(moment="3")
    assert abs(M.sel(beam="f")).max() < 1e-9 * P
    # clamped to a body that the ground holds: the same as clamped to the ground
    plate = kt.Model(
        nodes={"A": (0, 0, 0), "U": (0, 1, 0), "V": (0, 0, 1), "B": (1, 0, 0)},
        fixed=["A", "U", "V"],
        bodies={"plate": kt.Body(nodes=("A", "U", "V"))},
        beams={"e": kt.Beam(ends=("A", "B"), orientation=(0, 1, 0))},
        clamped={"A": "plate"},
        loads={"P": kt.NodalForce(node="B", force=(0, -P, 0))},
        **MATTER,
    )
    assert kt.statics.linear(plate).displacement.sel(node="B", axis="y") == pytest.approx(-P / (3 * EI), rel=1e-9)


def test_a_truss_carries_a_beam_on_its_last_plate():
    """The plate of three bars is held by six; the beam on it vibrates as a cantilever where the truss is rigid."""
    base = {"P": (1, 0, 0), "Q": (-0.5, 0.8, 0), "R": (-0.5, -0.8, 0)}
    top = {"S": (-0.6, 0, 1), "T": (0.3, 0.6, 1), "U": (0.3, -0.6, 1)}
    legs = {f"{a}{b}": (a, b) for a, b in ("PT", "PU", "QS", "QT", "RS", "RU")}
    model = kt.Model(
        nodes=base | top | {"M": (0, 0, 1), "N": (0, 0, 1.8), "X": (0, 0, 0.5)},
        fixed=[*base],
        bars=legs,
        bodies={"plate": kt.Body(nodes=("S", "T", "U", "X", "M"))},
        beams={"mast": kt.Beam(ends=("M", "N"), orientation=(1, 0, 0))},
        clamped={"M": "plate"},
        **MATTER,
    )
    assert kt.kinematics.mobility(model).degrees_of_freedom == 0  # a beam counts as rigid
    assert kt.dynamics.linearise(model).frequency.size == 6  # the freedoms of its end, which bend, stretch and twist it
    lowest = kt.dynamics.linearise(model).frequency.values[0]
    I2, A = BOX.second_moments[0], BOX.area
    weak = min(BOX.second_moments)
    exact = 1.8751040687**2 * math.sqrt(STEEL.E * weak / (STEEL.density * A * 0.8**4)) / (2 * math.pi)
    assert weak < I2 and lowest == pytest.approx(exact, rel=6e-3)  # one element: 0.5 % above, less rotary inertia


@pytest.mark.slow
def test_energy_momentum_steps_keep_the_energy_of_a_beam():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.5, 0)},
        beams={"e": ("A", "B")},
        clamped=["A"],
        velocities={"B": (0, 0.4)},
        material=kt.Material(E=2e8, density=1000.0),
        section=BOX,
    )
    run = kt.dynamics.simulate(model, 0.2, samples=21, method=kt.EnergyMomentum(step=1e-3))
    energy = run.energy.values
    assert np.abs(energy / energy[0] - 1).max() < 1e-9
    assert run.kinetic_energy.values.min() < 0.2 * energy[0]


@pytest.mark.slow
def test_section_forces_in_motion_are_in_balance():
    """A beam that swings about a pin: no moment at the pin and at the free end, and the weight and inertia in between."""
    model = kt.Model(nodes={"O": (0, 0), "B": (1, 0)}, fixed=["O"], beams={"e": ("O", "B")}, gravity=(0, -9.81), **MATTER)
    run = kt.dynamics.simulate(model, 1e-4, samples=2)
    found = kt.strength.beams(model, run, stations=5).isel(time=0, beam=0)
    m = STEEL.density * BOX.area
    # a rigid rod let go: M = m g s (L - s)^2/(4 L); the beam starts without strain, so its inertia alone is in balance
    assert found.end_force.sel(end="B").values == pytest.approx([0, 0], abs=1e-6 * m * 9.81)
    assert abs(found.section_M.sel(station=[0.0, 1.0]).values).max() < 1e-6 * m * 9.81


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"beams": {"b": ("A", "X")}}, "no node called 'X'"),
        ({"beams": {"b": ("A", "A")}}, "joins node 'A' to itself"),
        ({"section": None}, "has no section"),
        ({"section": kt.General(area=1, I2=1, I3=1, c2=1, c3=1)}, "torsion constant"),
        ({"beams": {"b": kt.Beam(ends=("A", "B"), release=["C"])}}, "no end of the beam"),
        ({"beams": {"b": kt.Beam(ends=("A", "B"), orientation="C")}}, "points along the beam"),
        ({"clamped": ["C"]}, "no beam has its rotation"),
        ({"clamped": {"A": "grund"}}, "Did you mean 'ground'"),
        ({"nodes": {"A": (0, 0, 0), "B": (1, 0, 0), "A.d1": (0, 0, 1)}}, "axis of the frame"),
        ({"beams": {"b": kt.Beam(ends=("A", "B"), kind="rigid", rotation="C")}}, "turns in space"),
    ],
)
def test_faults(change, says):
    with pytest.raises(kt.ModelError, match=says):
        kt.Model(**({"nodes": {"A": (0, 0, 0), "B": (1, 0, 0), "C": (2, 0, 0)}, "beams": {"b": ("A", "B")}, **MATTER} | change))


def test_files_and_changes_keep_what_beams_add(tmp_path):
    model = frame_in_space().with_(clamped=["A"])
    again = kt.read(kt.write(model, tmp_path / "m.yaml"))
    assert again == model and list(again.nodes) == ["A", "B", "C", "D"] and not again.bars and not again.fixed
    one, two = again.whole, model.whole
    assert list(one.nodes) == list(two.nodes) and list(one.bars) == list(two.bars) and {*model.nodes, "A.d3"} <= set(one.nodes)
    bare = model.with_(beams={}, clamped={}, bars={"one": ("A", "B")}).whole
    assert list(bare.nodes) == ["A", "B", "C", "D"] and list(bare.bars) == ["one"] and not bare.fixed
    moved = model.with_(nodes=model.nodes | {"B": (1.1, 0.2, 0.1)})
    assert moved.whole.nodes["B.d1"].at[0] > model.whole.nodes["B.d1"].at[0]


def test_a_cosine_of_a_scalar_has_exact_derivatives():
    """Values, rates and Hessians of the measures of a rigid beam with a rotation coordinate, by complex steps."""
    from kinetruss.mechanics import measure_gradients, measure_hessian, measured

    model = kt.library.mechanisms.andrews(form="beam")
    system = compile(model)
    rng = np.random.default_rng(1)
    x, v, a = (rng.standard_normal(system.x0.shape) for _ in range(3))
    m, (F, O, beta) = 0, (system.node_index(name) for name in ("F", "O", "beta"))

    def value(x):
        return x[F, 0] - x[O, 0] - 0.007 * np.cos(x[beta, 0])

    h = 1e-20
    gradient = measure_gradients(system, m, x[None])[0].reshape(x.shape)
    assert np.sum(gradient * v) == pytest.approx(value(x + 1j * h * v).imag / h, rel=1e-12)
    found = measured(system, m, x[None], v[None], a[None])[0]
    second = a[F, 0] - a[O, 0] + 0.007 * (np.sin(x[beta, 0]) * a[beta, 0] + np.cos(x[beta, 0]) * v[beta, 0] ** 2)
    assert found == pytest.approx([value(x), np.sum(gradient * v), second], rel=1e-9)
    flats, H = measure_hessian(system, m, x)
    w = v.reshape(-1)[flats]
    assert w @ H @ w == pytest.approx(0.007 * np.cos(x[beta, 0]) * v[beta, 0] ** 2, rel=1e-12)
