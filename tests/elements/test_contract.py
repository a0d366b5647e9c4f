"""What every kind of element keeps: its force is the derivative of its energy, its tangents those of its force, power is loss
and change of energy, rigid motions do not matter, momentum is kept, steps by the midpoint rule keep the energy, and the three
engines agree.

A new kind needs a model here, in MODELS; it fails by its name. One whose forces depend on places or velocities against the
ground has its name in GROUNDED, one that feeds in FEEDING.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.equations import equations
from kinetruss.elements.kinds import ELEMENTS, ON_COORDINATES, compile_kinds, present
from kinetruss.kernels.structure.applied import applied, no_force
from kinetruss.kernels.structure.element_table import ENERGY, FORCE, SWAP, TANGENT
from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.kernels.sweep.forces import applied as swept, energies
from kinetruss.mechanics import compile
from kinetruss.mechanics.balance import balance_of
from kinetruss.mechanics.elements import fed
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.matrices import mass_matrix, tangents
from kinetruss.mechanics.tables import nodal_loads, structure_of
from kinetruss.model.drives import OffsetCoordinate

SPACE = kt.Model(
    nodes={name: kt.Node(at=at, mass=0.5) for name, at in
           {"A": (0, 0, 0), "B": (1, 0.1, 0), "C": (0.2, 0.9, 0.3), "D": (0.4, 0.2, 1.1), "E": (1.3, 0.7, 0.5)}.items()},
    bars={one + two: kt.Bar(ends=(one, two), kind="free") for one, two in ("AB", "AC", "AD", "BC", "BD", "CD", "CE", "BE")},
)  # fmt: skip
PLANE = kt.Model(
    nodes={
        name: kt.Node(at=at, mass=0.5) for name, at in {"A": (0, 0), "B": (1, 0.1), "C": (1.7, 0.6), "D": (0.4, 1.0)}.items()
    },
    bars={one + two: kt.Bar(ends=(one, two), kind="free") for one, two in ("AB", "BC", "BD")},
)
HINGE = kt.HingeDrive(axis=("A", "B"), start="C", end="D")
TURN = kt.HingeDrive(axis=("B",), start="A", end="C")


def _spring(coordinate: object, **numbers: float) -> dict[str, object]:
    return {"springs": {"law": kt.Spring(coordinate=coordinate, **numbers)}}


def _near(coordinate: object, **numbers: float) -> kt.Stop:
    """A stop so near on both sides that the places at random are beyond it."""
    model = PLANE if coordinate is TURN else SPACE
    value = float(compile(model.with_(**_spring(coordinate, stiffness=1.0))).measure_start[-1])
    return kt.Stop(coordinate=coordinate, lower=value - 1e-4, upper=value + 1e-4, **numbers)


def _meshed(grid: object, **parts: object) -> kt.Model:
    return kt.Model(nodes=grid.nodes, material=SOFT, **parts)


def _beams(dim: int, **more: object) -> kt.Model:
    """Two beams, of which one has damping."""
    at = {"A": (0, 0, 0), "B": (1, 0.1, 0), "C": (1.4, 0.9, 0.3)}
    beams = {"one": kt.Beam(ends=("A", "B"), damping=0.02), "two": kt.Beam(ends=("B", "C"))}
    section = kt.Rectangle(width=0.2, height=0.3, **more)
    return kt.Model(nodes={name: place[:dim] for name, place in at.items()}, beams=beams, material=SOFT, section=section)


SOFT = kt.Material(E=2000.0, poisson=0.3, density=3.0)
SQUARE = kt.library.meshes.rectangle(width=1.0, height=0.8, columns=2, rows=1)
SIX = kt.library.meshes.rectangle(width=1.0, height=0.8, columns=1, rows=1, six_nodes=True)
CUBE = kt.library.meshes.box(size=(1.0, 0.8, 0.9), cells=(1, 1, 1))
LIFTED = {name: kt.Node(at=(*node.at, 0.3 * node.at[0] ** 2)) for name, node in SQUARE.nodes.items()}

MODELS = {
    "spring": {
        "on a hinge": SPACE.with_(**_spring(HINGE, stiffness=3.0, damping=0.4, preload=0.2, rest=0.9)),
        "on a length": SPACE.with_(**_spring(kt.LengthDrive("CE"), stiffness=30.0, friction=0.3, slip=0.2, rest=0.7)),
        "on a distance": SPACE.with_(**_spring(kt.DistanceCoordinate(("A", "E")), stiffness=30.0, damping=0.5, rest=1.2)),
        "with play": SPACE.with_(**_spring(kt.LengthDrive("CE"), stiffness=30.0, damping=2.0, play=0.05, rest=0.7)),
        "of two terms": SPACE.with_(
            springs={"law": kt.Spring(terms=((HINGE, 1.0), (kt.HingeDrive(axis=("B", "C"), start="D", end="E"), -2.0)),
                                      stiffness=2.0, damping=0.1, rest=0.1)}
        ),
        "on an angle of the plane": PLANE.with_(**_spring(TURN, stiffness=3.0, damping=0.4, rest=0.3)),
        "on an offset": PLANE.with_(**_spring(OffsetCoordinate(point="C", line=("A", "B")), stiffness=9.0, damping=0.2)),
    },
    "stop": {
        "on a hinge": SPACE.with_(stops={"ends": _near(HINGE, stiffness=300.0, damping=0.1, exponent=1.5)}),
        "on a length": SPACE.with_(stops={"ends": _near(kt.LengthDrive("CE"), stiffness=300.0, damping=0.1)}),
        "on an angle of the plane": PLANE.with_(stops={"ends": _near(TURN, stiffness=300.0, exponent=2.0)}),
    },
    "membrane": {
        "of three nodes": _meshed(SQUARE, membranes={"m": SQUARE.membrane(thickness=0.01)}),
        "of six nodes": _meshed(SIX, membranes={"m": SIX.membrane(thickness=0.01, strain="linear")}),
        "in space": kt.Model(nodes=LIFTED, material=SOFT, membranes={"m": SQUARE.membrane(thickness=0.01)}),
    },
    "cylinder": {
        "of given pressures": SPACE.with_(
            cylinders={"ram": kt.Cylinder(nodes=("A", "E"), bore=0.02, rod=0.01, pressure_A=1e4, flow_limit=1e-3)}
        ),
        "of a given flow": SPACE.with_(
            cylinders={"ram": kt.Cylinder(member="CE", bore=0.02, rod=0.01, flow=1e-4, leak=3e-8, relief=1e6)}
        ),
    },
    "solid": {"of four nodes": _meshed(CUBE, solids={"s": CUBE.solid()})},
    "beam": {
        "in the plane": _beams(2), "in space": _beams(3), "that shears": _beams(3, shear_coefficient=0.1),
        "that shears in the plane": _beams(2, shear_coefficient=0.1),
    },
    "friction": {
        "about pins": PLANE.with_(
            bars={one + two: kt.Bar(ends=(one, two), mass=0.0, friction=0.3) for one, two in ("AB", "BC", "BD")}
        )
    },
}  # fmt: skip
CASES = [(kind, name) for kind, models in MODELS.items() for name in models]
STEP = 1e-6
GROUNDED: tuple[str, ...] = ()
"""Kinds to which rigid motions matter; there are none."""
FEEDING = ("cylinder",)
"""Kinds that give energy which they do not store."""
STORING = [one for one in CASES if one[0] not in FEEDING]
BY_THE_MIDDLE = ("on a hinge", "of two terms", "on an offset")
"""Steps by the midpoint rule keep the energy of these to the order of the step alone."""


def test_kernels_of_all_kinds_compile_when_they_are_asked_for():
    compile_kinds()
    assert all(interface.address(kernel) for one in ELEMENTS for interface, kernel in one.kernels.values())


def test_every_kind_has_a_model():
    assert ON_COORDINATES.keys() <= MODELS.keys()
    systems = [compile(model) for models in MODELS.values() for model in models.values()]
    assert all(any(one.table(system) is not None for system in systems) for one in ELEMENTS)


@pytest.fixture(params=CASES, ids="-".join)
def case(request):
    """The compiled model, and places and velocities (n, 3) at random."""
    kind, name = request.param
    system, dice = compile(MODELS[kind][name]), np.random.default_rng(len(name))
    plane = [1.0, 1.0, system.dim - 2.0]
    x = system.x0 + 0.05 * dice.standard_normal(system.x0.shape) * plane
    assert present(system)
    return system, x, dice.standard_normal(x.shape) * plane


@cache
def equations_of(system):
    return equations(system)[0]


def forward(system, x, v):
    """Forces on the nodes (3 n,) in the equations of motion."""
    eq = equations_of(system)
    f = np.zeros(x.size)
    applied(eq, no_force, 0.0, x.reshape(-1), v.reshape(-1), f)
    return f


def along(system, x, v):
    """Energy, its rate and the power taken by the sweeps, and forces on the nodes; all masses are at rest in the sums."""
    states = States(*(np.ascontiguousarray(y.reshape(1, -1)) for y in (x, v, np.zeros_like(x))))
    loads, out = nodal_loads(case_loads(system, np.zeros(1), None)), np.zeros((1, 3))
    energies(structure_of(system), loads, states, out)
    rest = np.zeros((1, x.size))
    swept(structure_of(system), loads, states, EndForces(np.zeros((1, len(system.members), 2, 3)), rest))
    out[0, 0] -= 0.5 * float(v.reshape(-1) @ (mass_matrix(system, x) @ v.reshape(-1)))
    return out[0], rest[0]


def stored(system, x):
    return along(system, x, np.zeros_like(x))[0][0]


def slopes(of, y):
    """Derivatives (3 n, k) of a function of places or velocities by each coordinate."""
    found = []
    for k in range(y.size):
        step = np.zeros(y.size)
        step[k] = STEP
        found.append((of(y + step.reshape(y.shape)) - of(y - step.reshape(y.shape))) / (2 * STEP))
    return np.array(found)


@pytest.mark.parametrize("case", STORING, indirect=True, ids="-".join)
def test_the_force_is_the_derivative_of_the_energy(case):
    system, x, _ = case
    force = forward(system, x, np.zeros_like(x))
    assert -slopes(lambda y: stored(system, y), x) == pytest.approx(force, abs=1e-7 * (1 + np.abs(force).max()))


def test_the_tangents_are_those_of_the_force(case):
    system, x, v = case
    none = np.zeros(len(system.members))
    K, C = (one.toarray() for one in tangents(system, x, none, none, np.zeros(3), v))
    inner = np.flatnonzero(np.tile(np.arange(3) < system.dim, len(system.nodes)))
    for matrix, numbers in ((K, slopes(lambda y: forward(system, y, v), x)), (C, slopes(lambda y: forward(system, x, y), v))):
        found = -numbers.T
        assert matrix[np.ix_(inner, inner)] == pytest.approx(found[np.ix_(inner, inner)], abs=1e-6 * (1 + np.abs(found).max()))


def test_power_is_the_change_of_the_energy_and_what_is_taken(case):
    system, x, v = case
    (_, rate, taken), force = along(system, x, v)
    assert float(force @ v.reshape(-1)) == pytest.approx(-(rate + taken), abs=1e-12 * (1 + np.abs(force).max()))
    change = (stored(system, x + STEP * v) - stored(system, x - STEP * v)) / (2 * STEP)
    assert rate == pytest.approx(change, abs=1e-7 * (1 + abs(rate)))
    assert taken >= -1e-12 or fed(system)


def test_the_engines_agree(case):
    system, x, v = case
    force = forward(system, x, v)
    scale = 1e-13 * (1 + np.abs(force).max())
    assert along(system, x, v)[1] == pytest.approx(force, abs=scale)
    still = balance_of(system).applied(x)
    assert still == pytest.approx(forward(system, x, np.zeros_like(x)), abs=scale)


@pytest.mark.parametrize("case", [one for one in CASES if one[0] not in GROUNDED], indirect=True, ids="-".join)
def test_rigid_motions_do_not_matter_and_momentum_is_kept(case):
    system, x, v = case
    force = forward(system, x, v).reshape(-1, 3)
    size = 1e-12 * (1 + np.abs(force).max())
    assert force.sum(axis=0) == pytest.approx(np.zeros(3), abs=size)
    assert np.cross(x, force).sum(axis=0) == pytest.approx(np.zeros(3), abs=size)
    angle, axis = 0.7, np.array([0.0, 0.0, 1.0]) if system.dim == 2 else np.array([2.0, -1.0, 2.0]) / 3.0
    cross = np.cross(np.eye(3), axis)
    R = np.eye(3) - np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    shift, spin = np.array([0.3, -0.2, 0.0 if system.dim == 2 else 0.5]), 1.3 * axis
    turned = x @ R.T + shift
    rates = v @ R.T + np.cross(spin, turned) + 0.4 * shift
    assert forward(system, turned, rates) == pytest.approx((force @ R.T).reshape(-1), abs=100 * size)


def places(coordinates, size):
    """Places (elements, w w) of the lower triangle of a matrix (size, size), its last one of what no coordinate has."""
    w = coordinates.shape[1]
    i, j = np.repeat(coordinates, w, axis=1), np.tile(coordinates, (1, w))
    at = np.maximum(i, j) * size + np.minimum(i, j)
    return np.ascontiguousarray(np.where((i < 0) | (j < 0), size * size, at))


def test_the_tangents_of_implicit_methods_are_those_of_the_force_at_rest(case):
    system, x, _ = case
    x, still = x.reshape(-1), np.zeros(x.size)
    for one, record in present(system):

        def force(place, rate, kernel=one.kernels[FORCE][1], record=record):
            f = np.zeros(x.size)
            kernel(record, 0.0, place, rate, f)
            return f

        at = places(one.coordinates(record), x.size)
        stiff, damping = slopes(lambda y: force(y, still), x), slopes(lambda y: force(x, y), still)
        for weights, numbers in (((1.0, 0.0), stiff), ((0.0, 1.0), damping)):
            value = np.zeros(x.size**2 + 1)
            one.kernels[TANGENT][1](record, at, x, still, *weights, value)
            lower = value[:-1].reshape(x.size, x.size)
            inner = np.flatnonzero(np.tile(np.arange(3) < system.dim, len(system.nodes)))
            found = (lower + lower.T - np.diag(np.diag(lower)))[np.ix_(inner, inner)]
            wanted = -numbers.T[np.ix_(inner, inner)]
            assert found == pytest.approx(wanted, abs=1e-6 * (1 + np.abs(numbers).max()))


@pytest.mark.parametrize("case", STORING, indirect=True, ids="-".join)
def test_a_step_by_the_midpoint_rule_keeps_the_energy(case, request):
    """To the last digits, or, of coordinates whose gradient in the middle is taken, to the third order of the step."""
    system, x, v = case
    _, name = request.node.callspec.params["case"]
    for one, record in present(system):
        kernels, lacking = {column: kernel for column, (_, kernel) in one.kernels.items()}, []
        for size in (0.02, 0.01):
            # so slow that nothing is lost
            h, (x0, x1) = 1e12, ((x - 0.5 * size * v).reshape(-1), (x + 0.5 * size * v).reshape(-1))
            f, xe, ve = np.zeros(x.size), 0.5 * (x0 + x1), (x1 - x0) / h
            kernels[FORCE](record, 0.0, xe, ve, f)
            kernels[SWAP](record, 0.0, x0, x1, xe, ve, h, f)
            lacking.append(abs(float(f @ (x1 - x0)) + kernels[ENERGY](record, x1) - kernels[ENERGY](record, x0)))
        scale = 1.0 + abs(kernels[ENERGY](record, x.reshape(-1))) + float(np.abs(f).max())
        assert lacking[0] > 6.0 * lacking[1] if name in BY_THE_MIDDLE else max(lacking) <= 1e-12 * scale
