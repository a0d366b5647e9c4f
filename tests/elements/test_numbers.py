"""What tables keep of the numbers of a model: complex ones leave real parts as they are, one complex step gives the derivatives
by all of them, copies side by side are those one by one, and changed models have the tables of changed numbers.

A new kind needs a model here, in MODELS.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import AnalysisError
from kinetruss.mechanics import compile
from kinetruss.mechanics.numbers import numbers_of, tables_at
from kinetruss.model.drives import OffsetCoordinate

STEP = 1e-30
STEEL = kt.Material(E=2.1e11, density=7850.0, poisson=0.29)
SHEARED = kt.Rectangle(width=0.02, height=0.03, shear_coefficient=0.8)
FLAT = {"A": (0, 0), "B": (1, 0.1), "C": (0.3, 0.9), "D": (1.2, 1.1), "E": (2.1, 0.3)}
DEEP = {"A": (0, 0, 0), "B": (1, 0.1, 0), "C": (0.2, 0.9, 0.3), "D": (0.4, 0.2, 1.1), "E": (1.3, 0.7, 0.5), "F": (0.1, 0.3, -1)}
TURN, NEXT = (kt.HingeDrive(axis=(axis,), start=start, end=end) for axis, start, end in ("BAD", "DBE"))
HINGE = kt.HingeDrive(axis=("A", "B"), start="C", end="E")
LENGTH = kt.LengthDrive("de")
PART = {"section": kt.Rod(diameter=0.02), "material": STEEL}
SHEET = kt.library.meshes.rectangle(width=1.0, height=0.8, columns=2, rows=1)
SIX = kt.library.meshes.rectangle(width=1.0, height=0.8, columns=1, rows=1, six_nodes=True)
CUBE = kt.library.meshes.box(size=(1.0, 0.8, 0.9), cells=(1, 1, 1))


def _bar(ends: str, kind: str = "elastic", **fields: object) -> kt.Bar:
    return kt.Bar(ends=tuple(ends), kind=kind, **fields)


def _bars() -> kt.Model:
    nodes = {name: kt.Node(at=at, mass=0.1, gravity=(0, -1.6) if name == "C" else None) for name, at in FLAT.items()}
    bars = {
        "ab": _bar("AB", section="rod"),
        "ac": _bar("AC", "cable", pretension=500.0, section="any", damping=3.0),
        "bc": _bar("BC", strain="green", pretension=-900.0, section="box"),
        "be": _bar("BE", strain="green", pretension=300.0, stiffness=2e5),
        "ce": _bar("CE", pretension=300.0, stiffness=2e5),
        "bd": _bar("BD", stiffness=1e5, natural_length=1.02, damping=2.0),
        "cd": _bar("CD", "rigid", mass=2.0, rotary_inertia=True),
        "de": _bar("DE", "rigid", rotary_inertia=True, section="box", length=1.3),
        "ae": _bar("AE", "free", damping=4.0),
        "ad": _bar("AD", "driven", length=1.63),
    }
    sections = {
        "rod": kt.Rod(diameter=0.021), "box": kt.Rectangle(width=0.013, height=0.037),
        "any": kt.General(area=1.3e-4, I2=1e-9, I3=2e-9, c2=0.01, c3=0.02),
    }  # fmt: skip
    return kt.Model(
        nodes=nodes, fixed=["A"], gravity=(0, -9.81), velocities={"B": (0.1, 0.2)}, sections=sections, bars=bars,
        section=kt.Tube(outer=0.05, inner=0.044), material=STEEL,
    )  # fmt: skip


def _plane() -> kt.Model:
    bars = {
        "ab": _bar("AB", "rigid", body=kt.PlanarBody(mass=2.0, center=(0.4, 0.1), inertia=0.2), friction=(0.4, 0.1)),
        "bd": _bar("BD", "rigid", mass=1.0, friction=(0.2, 0)),
        "de": _bar("DE", "rigid", mass=0.3),
    }
    frame = kt.Frame(origin=(0.1, 0.05), axes=((0.8, 0.6), (-0.6, 0.8)))
    bodies = {
        "two": kt.Body(nodes=("B", "C"), mass=3.0, center=(0.6, 0.4), inertia=0.3),
        "three": kt.Body(nodes=("B", "D", "E"), mass=1.5, center=(1.5, 0.5), inertia=0.2, frame=frame),
        "even": kt.Body(nodes=("C", "D"), mass=0.7),
    }
    springs = {
        "turn": kt.Spring(coordinate=TURN, stiffness=3.0, damping=0.2, rest=0.3, preload=0.1),
        "play": kt.Spring(coordinate=LENGTH, stiffness=30.0, friction=0.3, slip=0.2, play=0.05),
        "table": kt.Spring(coordinate=LENGTH, table=((-0.1, -3.0), (0.0, 0.0), (0.2, 9.0))),
        "sum": kt.Spring(terms=((TURN, 1.0), (NEXT, -2.0)), stiffness=2.0),
        "distance": kt.Spring(coordinate=kt.DistanceCoordinate(("A", "E")), stiffness=20.0, rest=1.1),
        "offset": kt.Spring(coordinate=OffsetCoordinate(point="E", line=("A", "B")), stiffness=9.0),
    }
    stops = {
        "both": kt.Stop(coordinate=LENGTH, lower=0.5, upper=2.0, stiffness=300.0, damping=0.1, exponent=1.5),
        "one": kt.Stop(coordinate=LENGTH, upper=2.0, stiffness=300.0),
    }
    drives = {"crank": kt.AngleDrive("ab"), "slide": kt.CoordinateDrive(node="E", axis="x")}
    couplings = {"gear": kt.Coupling(terms=((TURN, 1.0), (NEXT, 2.0))), "held": kt.Coupling(terms=((TURN, 3.0),), value=2.5)}
    return kt.Model(
        nodes=FLAT, fixed=["A"], gravity=(0, -9.81), material=STEEL, bars=bars, bodies=bodies, springs=springs, stops=stops,
        drives=drives, couplings=couplings,
    )  # fmt: skip


def _in_plane(names: str) -> kt.Frame:
    """A frame whose first two axes lie in the plane of three nodes."""
    a, b, c = (np.array(DEEP[name], float) for name in names)
    one, normal = b - a, np.cross(b - a, c - a)
    one, normal = one / np.linalg.norm(one), normal / np.linalg.norm(normal)
    return kt.Frame(origin=a, axes=(one, np.cross(normal, one), normal))


def _space() -> kt.Model:
    base = kt.Part(
        length=0.8, masses=(kt.PointMass(at=0.1, mass=2.0), kt.PointMass(at=0.05, mass=1.0)), rotary_inertia=True, **PART
    )
    tube = kt.Part(length=0.7, mass=1.2, masses=(kt.PointMass(at=0.2, mass=0.5),), **PART)
    thin = kt.Part(length=0.7, section=kt.Tube(outer=0.03, inner=0.02), material=STEEL)
    active = {
        "stiff": kt.Active(ends=("F", "B"), base=base, tube=tube, compliance=kt.Compliance(nut=2e7, base=3e7)),
        "plain": kt.Active(ends=("F", "C"), base=kt.Part(length=0.8, **PART), tube=thin),
    }
    bodies = {
        "block": kt.Body(nodes=("A", "B", "C", "D"), mass=2.0, center=(0.4, 0.3, 0.35), inertia=(0.1, 0.2, 0.25)),
        "plate": kt.Body(
            nodes=("B", "C", "E"), mass=0.9, center=(0.3, 0.2, 0), inertia=(0.1, 0.05, 0.15), frame=_in_plane("BCE")
        ),
        "even": kt.Body(nodes=("C", "E"), mass=0.3),
    }
    return kt.Model(
        nodes=DEEP, fixed=["A", "F"], gravity=(0, 0, -9.81), material=STEEL, section=kt.Tube(outer=0.05, inner=0.044),
        bars={"ae": _bar("AE"), "be": _bar("BE", "rigid"), "ef": _bar("EF", "free")}, active=active, bodies=bodies,
        drives={"angle": kt.AngleDrive("be", axis=(0, 0.6, 0.8)), "hinge": HINGE},
        springs={"spring": kt.Spring(coordinate=HINGE, stiffness=3.0, rest=0.1)},
    )  # fmt: skip


def _beams(dim: int) -> kt.Model:
    beams = {
        "ab": kt.Beam(ends=("A", "B"), damping=0.02),
        "bc": kt.Beam(ends=("B", "C"), orientation="E" if dim == 3 else None, section=SHEARED),
        "ce": kt.Beam(ends=("C", "E"), orientation=(0.1, 0.2, 0.9) if dim == 3 else None, mass=2.0,
                      section=kt.Tube(outer=0.03, inner=0.02)),
    }  # fmt: skip
    if dim == 2:
        beams |= {"cd": kt.Beam(ends=("C", "D"), kind="rigid"), "de": kt.Beam(ends=("D", "E"), kind="rigid", mass=2.0)}
    return kt.Model(
        nodes={name: (DEEP if dim == 3 else FLAT)[name] for name in ("ABCE" if dim == 3 else "ABCDE")},
        clamped=["A"], material=STEEL, section=kt.Rectangle(width=0.02, height=0.03), beams=beams, bars={"ae": _bar("AE")},
    )  # fmt: skip


LIFTED = {name: kt.Node(at=(*node.at, 0.3 * node.at[0] ** 2)) for name, node in SHEET.nodes.items()}
WOOD = kt.Orthotropic(E1=2e9, E2=1e9, nu12=0.3, G12=4e8, density=900.0)
MODELS = {
    "bars": _bars(),
    "bodies, springs and stops of the plane": _plane(),
    "active members, bodies and angles in space": _space(),
    "beams of the plane": _beams(2),
    "beams in space": _beams(3),
    "orthotropic membrane": kt.Model(nodes=SHEET.nodes, membranes={"m": SHEET.membrane(thickness=0.01, orthotropic=WOOD)}),
    "six-node membrane": kt.Model(
        nodes=SIX.nodes, material=STEEL, membranes={"m": SIX.membrane(thickness=0.01, strain="linear")}
    ),
    "membrane in space": kt.Model(nodes=LIFTED, material=STEEL, membranes={"m": SHEET.membrane(thickness=0.01)}),
    "solid": kt.Model(nodes=CUBE.nodes, material=STEEL, solids={"s": CUBE.solid()}),
}


@pytest.fixture(params=MODELS)
def system(request):
    return compile(MODELS[request.param])


def steps(own, step):
    """The numbers of a model, one of them in each copy more by a step for its size, and the sizes of the steps."""
    places = [(name, k) for name, one in own.items() for k in zip(*np.nonzero(~np.isnan(one)), strict=True)]
    made = {name: np.repeat(one.astype(type(step))[None], len(places), axis=0) for name, one in own.items()}
    sizes = np.array([max(abs(own[name][k]), 1.0 if name == "place" else 1e-3) for name, k in places])
    for copy, (name, k) in enumerate(places):
        made[name][(copy, *k)] += step * sizes[copy]
    return made, sizes


@cache
def by_steps(system):
    """Derivatives of all tables by all numbers, each for its size, by one complex step."""
    made, sizes = steps(numbers_of(system), 1j * STEP)
    return tables_at(system, made), sizes


def test_real_parts_are_the_compiled_tables(system):
    for name, one in tables_at(system, {}).items():
        found = by_steps(system)[0][name].real
        np.testing.assert_allclose(
            found, np.broadcast_to(one, found.shape), rtol=4e-15, atol=4e-15 * _largest(one), err_msg=name
        )
        if hasattr(system, name):
            np.testing.assert_array_equal(one, getattr(system, name))


def test_derivatives_are_those_of_differences(system):
    own, h = numbers_of(system), 1e-5
    (up, _), (down, _) = steps(own, h), steps(own, -h)
    up, down = tables_at(system, up), tables_at(system, down)
    for name, one in by_steps(system)[0].items():
        exact, base = one.imag / STEP, one.real
        with np.errstate(invalid="ignore"):
            found = (up[name] - down[name]) / (2 * h)
        known = np.isfinite(base) & np.isfinite(found)
        bound = 1e-5 * np.abs(exact) + 1e-9 * (np.abs(base) + 0.1 * _largest(base))
        assert np.all(np.abs(found - exact)[known] <= bound[known]), name


def test_copies_are_those_one_by_one(system):
    own = numbers_of(system)
    made, _ = steps(own, 1j * STEP)
    for copy in range(0, len(made["place"]), 7):
        alone = tables_at(system, {name: one[copy] for name, one in made.items()})
        for name, one in by_steps(system)[0].items():
            np.testing.assert_allclose(
                one[copy].real, alone[name].real, rtol=4e-15, atol=4e-15 * _largest(alone[name]), err_msg=name
            )
            bound = 1e-12 * STEP * _largest(alone[name])
            np.testing.assert_allclose(one[copy].imag, alone[name].imag, rtol=1e-9, atol=bound, err_msg=name)


def _largest(values):
    return np.abs(values[np.isfinite(values)]).max(initial=0.0)


def _moved(model: kt.Model, by: float, name: str = "B") -> dict[str, object]:
    node = model.nodes[name]
    return {"nodes": {**model.nodes, name: node.with_(at=(node.at[0] + by, *node.at[1:]))}}


CHANGES = {
    "a node": ("bars", _moved),
    "a node of beams": ("beams in space", _moved),
    "a node of bodies": ("active members, bodies and angles in space", lambda model, by: _moved(model, by, "A")),
    "the material": ("beams in space", lambda model, by: {"material": STEEL.with_(E=STEEL.E * (1 + by))}),
    "a section": ("beams in space", lambda model, by: {"section": kt.Rectangle(width=0.02, height=0.03 + 0.01 * by)}),
    "a diameter": ("bars", lambda model, by: {"sections": {**model.sections, "rod": kt.Rod(diameter=0.021 + 0.01 * by)}}),
    "gravity": ("bars", lambda model, by: {"gravity": (by, -9.81)}),
}  # fmt: skip


@pytest.mark.parametrize("case", CHANGES)
def test_changed_models_have_the_tables_of_changed_numbers(case):
    """The derivative along a change of the model, whose inner parts change with it, against differences of compiled models."""
    name, change = CHANGES[case]
    model, h = MODELS[name], 1e-5
    up, down = (compile(model.with_(**change(model, by))) for by in (h, -h))
    system, along = compile(model), {key: (one - numbers_of(down)[key]) / (2 * h) for key, one in numbers_of(up).items()}
    assert any(one.any() for one in along.values())
    found = tables_at(system, {key: one + 1j * STEP * along[key] for key, one in numbers_of(system).items()})
    ups, downs = tables_at(up, {}), tables_at(down, {})
    for key, one in found.items():
        differences = (ups[key] - downs[key]) / (2 * h)
        known = np.isfinite(differences)
        bound = 1e-6 * _largest(differences) + 1e-9 * _largest(one.real)
        np.testing.assert_allclose((one.imag / STEP)[known], differences[known], rtol=1e-5, atol=bound, err_msg=key)


def test_numbers_that_are_zero_and_left_out_are_told():
    model = kt.Model(nodes=FLAT, bars={"ab": _bar("AB", "rigid"), "ac": _bar("AC", "rigid")}, material=STEEL.with_(density=0.0),
                     section=kt.Rod(diameter=0.02))  # fmt: skip
    system = compile(model)
    with pytest.raises(AnalysisError, match="Change no numbers that are 0"):
        tables_at(system, {"density": np.array([1j * STEP])})
    with pytest.raises(AnalysisError, match="differ in bars without mass"):
        tables_at(system, {"density": np.array([[0.0], [1j * STEP]])})
    with pytest.raises(AnalysisError, match="no numbers called weight"):
        tables_at(system, {"weight": np.zeros(1)})
