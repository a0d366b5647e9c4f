"""Loops that move against their count, let go: rows that depend on others only where the loop is closed."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.equations import equations
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.kkt import project
from kinetruss.kernels.structure.applied import no_force
from kinetruss.library import mechanisms
from kinetruss.mechanics import compile as compiled
from kinetruss.verification.mechanisms import hinge_angles
from reference.bennett import bennett_places, one_freedom

TIGHT = kt.DOP853(rtol=1e-11, atol=1e-12)
TETRAHEDRON = ("PP", "AA", "PA", "AP")


def drift(run: kt.results.Simulation) -> float:
    """Largest change of the energy, of the largest kinetic one."""
    whole = run.kinetic_energy.values + run.potential_energy.values
    return float(np.abs(whole - whole[0]).max() / run.kinetic_energy.values.max())


def loop(hinges: list[tuple[np.ndarray, np.ndarray]], extra: tuple[tuple[str, str], ...] = ()) -> kt.Model:
    """A closed loop of links between hinges (point, direction); the link of the last and the first one is fixed."""
    count, nodes = len(hinges), {}
    for k, (at, along) in enumerate(hinges, start=1):
        nodes |= {f"P{k}": tuple(at.tolist()), f"A{k}": tuple((at + 0.8 * along / np.linalg.norm(along)).tolist())}
    pairs = [(f"{a}{k}", f"{b}{k + 1}") for k in range(1, count) for a, b in TETRAHEDRON]
    pairs += [(f"P{k}", f"A{k}") for k in range(2, count)]
    bars = {f"{a}-{b}": kt.Bar(ends=(a, b), mass=1.0 if a[0] == b[0] == "P" else 0.1) for a, b in pairs}
    bars |= {f"more-{a}-{b}": kt.Bar(ends=(a, b)) for a, b in extra}
    return kt.Model(nodes=nodes, bars=bars, fixed=["P1", "A1", f"P{count}", f"A{count}"], gravity=(0.0, 0.0, -9.81))


def plane_symmetric(seed: int) -> kt.Model:
    """Bricard's loop with a plane of symmetry: hinges 1 and 4 lie in it, 2 and 3 are mirrored to 6 and 5."""
    rng = np.random.default_rng(seed)
    flat, mirror = np.array([1.0, 1.0, 0.0]), np.array([1.0, 1.0, -1.0])
    one, four = [(np.array(at), flat * rng.uniform(-1, 1, 3)) for at in ((0.0, 0.0, 0.0), (1.2, 0.3, 0.0))]
    two, three = [(np.array(at) + 0.2 * rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3))
                  for at in ((0.2, 0.5, 0.6), (0.9, 0.6, 0.7))]  # fmt: skip
    return loop([one, two, three, four, *((at * mirror, along * mirror) for at, along in (three, two))])


def line_symmetric(seed: int) -> kt.Model:
    """Bricard's loop with a line of symmetry: half a turn about z takes hinges 1, 2, 3 to 4, 5, 6."""
    rng, turned = np.random.default_rng(seed), np.array([-1.0, -1.0, 1.0])
    half = [(np.array(at) + 0.2 * rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3))
            for at in ((1.0, 0.0, 0.0), (0.6, 0.9, 0.4), (-0.5, 1.0, 0.0))]  # fmt: skip
    return loop([*half, *((at * turned, along * turned) for at, along in half)])


def parallelogram(cranks: int, more: tuple[tuple[str, str], ...] = ()) -> kt.Model:
    """One coupler on parallel cranks, of which two would do; `more` bars between nodes that have some already."""
    nodes, bars = {"T": (0.8, 1.0)}, {}
    for i, x in enumerate(np.linspace(0.0, 1.0, cranks).tolist()):
        nodes |= {f"G{i}": (x, 0.0), f"C{i}": (x + 0.3, 0.6)}
        bars |= {f"crank{i}": kt.Bar(ends=(f"G{i}", f"C{i}"), mass=1.0), f"T{i}": kt.Bar(ends=("T", f"C{i}"), mass=0.2)}
    bars |= {f"C{i}": kt.Bar(ends=(f"C{i}", f"C{i + 1}"), mass=1.0) for i in range(cranks - 1)}
    bars |= {f"more-{a}-{b}": kt.Bar(ends=(a, b)) for a, b in more}
    return kt.Model(nodes=nodes, bars=bars, fixed=[f"G{i}" for i in range(cranks)], gravity=(0.0, -9.81))


def spun(model: kt.Model, twist: float, other: float, angle: float, rate: float) -> kt.Model:
    """Bennett's linkage with a rate (rad/s) of its first hinge."""
    places, h = bennett_places(twist, other), 1e-5
    v = (8 * (places(angle + h) - places(angle - h)) - places(angle + 2 * h) + places(angle - 2 * h)) / (12 * h)
    return model.with_(velocities={n: tuple((rate * u).tolist()) for n, u in zip(("P2", "A2", "P3", "A3"), v, strict=True)})


LOOPS = {
    "bennett": lambda: mechanisms.bennett(),
    "bennett, two bars twice": lambda: mechanisms.bennett().with_(
        bars=dict(mechanisms.bennett().bars) | {"one": kt.Bar(ends=("P1", "P2")), "two": kt.Bar(ends=("A2", "P3"))}
    ),
    "orthogonal": lambda: mechanisms.bricard(),
    "threefold": lambda: mechanisms.bricard(twist=0.9, angle=1.2),
    "plane": lambda: plane_symmetric(1),
    "other plane": lambda: plane_symmetric(4),
    "line": lambda: line_symmetric(6),
    "line, through singular positions": lambda: line_symmetric(7),
    "spherical, a bar twice": lambda: mechanisms.spherical_four_bar().with_(
        bars=dict(mechanisms.spherical_four_bar().bars) | {"twice": kt.Bar(ends=("O", "B"))}
    ),
    "three cranks": lambda: parallelogram(3),
    "six cranks": lambda: parallelogram(6, (("G0", "C0"), ("C0", "C2"), ("C1", "C4"))),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", LOOPS)
def test_loops_keep_their_energy_for_seconds(name):
    model = LOOPS[name]()
    run = kt.dynamics.simulate(model, 4.0, samples=101)
    assert run.status is kt.Status.COMPLETED
    assert run.kinetic_energy.values.max() > 0.1
    assert drift(run) < 1e-8
    at = {node: run.motion.position.sel(node=node).values for node in model.nodes}
    for bar in model.bars.values():
        length = np.linalg.norm(at[bar.ends[1]] - at[bar.ends[0]], axis=1)
        assert length == pytest.approx(length[0], rel=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("twist", "other", "angle", "rate"),
    [(0.7, 1.3, 1.0, 12.0), (0.3, 1.5, 2.0, -20.0), (0.5, 2.5, 0.3, 15.0), (1.2, 0.6, -2.0, 0.0)],
)
def test_bennett_obeys_the_equation_of_its_freedom(twist, other, angle, rate):
    """m(q) q'' + m'(q) q'^2/2 + V'(q) = 0, through several turns."""
    model = spun(mechanisms.bennett(twist=twist, other_twist=other, angle=angle), twist, other, angle, rate)
    run = kt.dynamics.simulate(model, 3.0, samples=301, method=TIGHT)
    q, _ = one_freedom(bennett_places(twist, other), angle, rate, 3.0)
    end = run.motion.position.isel(time=-1).sel(node=["P2", "A2", "P3", "A3"]).values
    assert end == pytest.approx(bennett_places(twist, other)(float(q)), abs=3e-9)
    turns = np.unwrap(hinge_angles(model, run.motion.position)[:, 0])
    assert turns[-1] - turns[0] == pytest.approx(float(q) - angle, abs=1e-7)
    assert np.ptp(turns) > (12 if rate else 0.5)


@pytest.mark.slow
@pytest.mark.parametrize(
    "method", [kt.EnergyMomentum(step=1e-3), kt.GeneralizedAlpha(step=1e-3), kt.Radau()], ids=["midpoint", "alpha", "radau"]
)
@pytest.mark.parametrize("name", ["bennett", "orthogonal", "plane", "three cranks"])
def test_implicit_methods_go_along(name, method):
    model = LOOPS[name]()
    close = kt.dynamics.simulate(model, 1.0, samples=2, method=TIGHT).motion.position.isel(time=-1).values
    run = kt.dynamics.simulate(model, 1.0, samples=11, method=method)
    assert run.motion.position.isel(time=-1).values == pytest.approx(close, abs=2e-3)
    if isinstance(method, kt.EnergyMomentum):
        # a step that is carried through a singular position keeps the energy to h^4 only
        assert drift(run) < (1e-8 if len(run.passages) else 1e-9)


def test_what_is_off_the_loop_does_not_spoil_accelerations():
    """A deviation e of the positions changes the accelerations by O(e), though rows that hang on others have pivots O(e^2)."""
    system = compiled(mechanisms.bennett())
    eq, ws = equations(system)
    assert eq.solver == 0 and eq.sure == 1 and eq.redundant.sum() == 3
    size, rng = system.x0.size, np.random.default_rng(4)
    off, push = np.zeros((2, size))
    off[eq.free], push[eq.free] = rng.uniform(-1, 1, (2, len(eq.free)))
    found = []
    for e in (0.0, 1e-8, 1e-6, 1e-4):
        x, v = system.x0.reshape(-1) + e * off, push.copy()
        project(eq, ws, 0.0, system.x0.reshape(-1).copy(), v, 1e-14)
        a, N = np.zeros(size), np.zeros(len(eq.row))
        assert evaluate(eq, ws, no_force, 0.0, x, v, a, N) > 0.1
        found.append(a)
    for e, a in zip((1e-8, 1e-6, 1e-4), found[1:], strict=True):
        assert np.abs(a - found[0]).max() < 100 * e * np.abs(found[0]).max()


@pytest.mark.slow
def test_angles_obey_their_closed_form():
    """Orthogonal loop of six: angles alternate and cos t + cos u + cos t cos u = 0; its energy over ten seconds."""
    model = mechanisms.bricard()
    run = kt.dynamics.simulate(model, 10.0, samples=201)
    c = np.cos(hinge_angles(model, run.motion.position))
    assert c[:, ::2] == pytest.approx(np.repeat(c[:, :1], 3, axis=1), abs=1e-9)
    assert c[:, 1::2] == pytest.approx(np.repeat(c[:, 1:2], 3, axis=1), abs=1e-9)
    assert c[:, 0] + c[:, 1] + c[:, 0] * c[:, 1] == pytest.approx(0.0, abs=1e-9)
    assert np.ptp(c[:, 0]) > 0.5
    assert drift(run) < 1e-8


def test_self_stress_is_shared_whichever_rows_are_kept():
    """Forces of a bar that is there twice are equal halves all along the motion."""
    model = LOOPS["bennett, two bars twice"]()
    force = kt.dynamics.simulate(model, 2.0, samples=41).forces.member_force
    for once, twice in (("P1-P2", "one"), ("A2-P3", "two")):
        assert force.sel(member=once).values == pytest.approx(force.sel(member=twice).values, abs=1e-8)
        assert math.fabs(float(force.sel(member=once).max())) > 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("name", ["bennett", "plane", "line", "six cranks"])
def test_loops_asked_for_with_the_sparse_solver_get_the_one_that_chooses_rows_anew(name):
    run = kt.dynamics.simulate(LOOPS[name](), 2.0, samples=21, method=kt.DOP853(solver="sparse"))
    assert run.data.attrs["solver"] == "dense"
    assert "The dense solver is used" in run.message
    assert drift(run) < 1e-8
