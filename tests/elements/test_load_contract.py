"""What every kind of load keeps: its derivatives and compiled forces are those of its formula, a load that turns does so with
its body, one that does not is the same everywhere, and it acts on members that there are.

A new kind needs a model here, in MODELS, and nothing else; it fails by its name.
"""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.elements.kinds import LOADS
from kinetruss.elements.loads.load import OnMember, OnOthers, Spread, Turning
from kinetruss.mechanics import compile
from kinetruss.mechanics.bars import bars_of
from kinetruss.mechanics.loads import history_of, unit_loads_of
from kinetruss.mechanics.numbers import load_tables_at, numbers_of

RODS = {"section": kt.Rod(diameter=0.02), "material": "steel_s235"}
PLANE = kt.Model(
    nodes={"A": (0, 0), "B": (1, 0.1), "C": (0.3, 0.9), "D": (1.2, 1.1)}, fixed=["A"], **RODS,
    bars={one + two: (one, two) for one, two in ("AB", "AC", "BC", "BD")},
    bodies={"plate": kt.Body(nodes=("A", "B", "C"), mass=1.0)},
)  # fmt: skip
SPACE = kt.Model(
    **RODS, nodes={"A": (0, 0, 0), "B": (1, 0.1, 0), "C": (0.2, 0.9, 0.3), "D": (0.4, 0.2, 1.1), "E": (1.4, 1, 0.8)},
    fixed=["A"],
    bars={"AE": kt.Bar(ends=("A", "E"), orientation="D")}, bodies={"block": kt.Body(nodes=("A", "B", "C", "D"), mass=2.0)},
)  # fmt: skip
BEAMS = [
    kt.Model(nodes={"A": (0, 0, 0)[:dim], "B": (1, 0.2, 0.5)[:dim]}, clamped=["A"], beams={"arm": ("A", "B")}, **RODS)
    for dim in (2, 3)
]
VGT = kt.library.vgt.triangular(payload_mass=10.0)

MODELS = {
    kt.NodalForce: [(PLANE, {"node": "B", "force": (3, -2)}), (SPACE, {"node": "B", "force": (3, -2, 1)})],
    kt.BodyForce: [
        (PLANE, {"body": "plate", "force": (3, -2), "at": (0.2, 0.3)}),
        (PLANE, {"body": "BD", "force": (3, -2), "at": (0.3, 0.1), "follows": True}),
        (SPACE, {"body": "block", "force": (1, 2, 3), "at": (0.2, 0.3, 0.1), "follows": True}),
    ],
    kt.BodyCouple: [
        (PLANE, {"body": "BD", "moment": 2.0}),
        (SPACE, {"body": "block", "moment": (1, 2, 3)}),
        (SPACE, {"body": "block", "moment": (1, 2, 3), "follows": True}),
    ],
    kt.Pressure: [(PLANE, {"face": ("B", "D"), "pressure": 9.0}), (SPACE, {"face": ("A", "B", "C"), "pressure": 9.0})],
    kt.MemberLoad: [
        (PLANE, {"member": "BD", "force": (3, -2), "shape": (1, 0.2), "start": 0.1}),
        (PLANE, {"member": "BD", "force": (3, -2), "axes": "member"}),
        (SPACE, {"member": "AE", "force": (3, -2, 1), "axes": "member", "end": 1.0}),
        (BEAMS[0], {"member": "arm", "force": (3, -2), "shape": (0, 1)}),
        (BEAMS[1], {"member": "arm", "force": (3, -2, 1), "axes": "member"}),
        (PLANE, {"member": "BD", "force": (3, -2), "start": "10 %", "per": "projection"}),
        (SPACE, {"member": "AE", "force": (3, -2, 1), "per": "projection"}),
        (BEAMS[1], {"member": "arm", "force": (3, -2, 1), "per": "projection", "end": 0.5}),
        (VGT, {"member": "actuator", "force": (3, -2), "shape": (1, 0.2)}),
        (VGT, {"member": "actuator", "force": (3, -2), "axes": "member"}),
        (VGT, {"member": "actuator", "force": (3, -2), "per": "projection"}),
    ],
    kt.MemberCouple: [
        (PLANE, {"member": "BD", "moment": 3.0, "shape": (2, 1), "start": 0.2}),
        (BEAMS[0], {"member": "arm", "moment": 3.0, "shape": (2, 1), "start": 0.2}),
        (BEAMS[1], {"member": "arm", "moment": (3, -2, 1)}),
        (BEAMS[1], {"member": "arm", "moment": (3, -2, 1), "axes": "member", "end": "70 %"}),
    ],
    kt.MemberPointForce: [
        (PLANE, {"member": "BD", "force": (3, -2), "at": 0.3}),
        (SPACE, {"member": "AE", "force": (3, -2, 1), "axes": "member", "at": "20 %"}),
        (BEAMS[0], {"member": "arm", "force": (3, -2), "at": 0.3, "axes": "member"}),
        (BEAMS[1], {"member": "arm", "force": (3, -2, 1), "at": 0.3}),
    ],
    kt.MemberPointCouple: [
        (PLANE, {"member": "BD", "moment": 3.0, "at": 0.3}),
        (BEAMS[0], {"member": "arm", "moment": 3.0, "at": 0.3}),
        (BEAMS[1], {"member": "arm", "moment": (3, -2, 1), "at": "20 %"}),
    ],
}


def test_every_kind_has_a_model():
    assert MODELS.keys() == LOADS.keys()


CASES = [pytest.param((kind, *one), id=f"{kind.__name__}-{k}") for kind, ones in MODELS.items() for k, one in enumerate(ones)]


@pytest.fixture(params=CASES)
def case(request):
    """Compiled model, record, its unit loads with amounts, and places (n, 3) near those of the model."""
    kind, model, fields = request.param
    system = compile(model.with_(loads={"q": kind(**fields)}))
    load = system.model.loads["q"]
    dice = np.random.default_rng(5)
    x = system.x0.copy()
    if (
        not isinstance(load, (kt.MemberCouple, kt.MemberPointCouple)) or load.member not in model.beams
    ):  # whose frames are rigid
        x += 0.05 * dice.standard_normal(x.shape) * [1, 1, system.dim - 2]
    amounts = history_of(load, np.zeros(1))[0]
    return system, load, list(zip(unit_loads_of(system, "q"), amounts, strict=True)), x


def forces(units, x):
    """Nodal forces (n, 3) of a load at places x."""
    found = np.zeros_like(x)
    for unit, amount in units:
        np.add.at(found, unit.nodes, amount * unit.forces(x[unit.nodes]))
    return found


def rotation(dim):
    c, s = np.cos(0.7), np.sin(0.7)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    return about_z if dim == 2 else about_z @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def test_derivatives_and_compiled_forces_are_those_of_the_formula(case):
    _, _, units, x = case
    dice = np.random.default_rng(2)
    for unit, _ in units:
        r = x[unit.nodes]
        y = dice.standard_normal(r.shape)
        slope = (unit.forces(r + 1e-5 * y) - unit.forces(r - 1e-5 * y)).reshape(-1) / 2e-5
        np.testing.assert_allclose(unit.tangent(r) @ y.reshape(-1), slope, atol=1e-8 * (1 + np.abs(slope).max()))
        assert unit.constant == (not unit.tangent(r).any() and not unit.tangent(r + y).any())
        f = np.zeros(x.size)
        record = type(unit).table([Turning(unit, (0.0, 2.0), np.array([1.0, 3.0]))])
        type(unit).kernel(record, 0.5, x.reshape(-1), np.zeros(x.size), f)
        wanted = np.zeros_like(x)
        np.add.at(wanted, unit.nodes, 1.5 * unit.forces(r))
        np.testing.assert_allclose(f.reshape(-1, 3), wanted, atol=1e-13 * (1 + np.abs(wanted).max()))


def test_a_load_that_turns_does_so_with_its_body(case):
    """At places turned about the origin the forces are turned, or the same; in either case they do not notice a shift."""
    system, load, units, x = case
    R = rotation(system.dim)
    f, turned = forces(units, x), forces(units, x @ R.T)
    scale = np.abs(f).max()
    np.testing.assert_allclose(forces(units, x + np.array([0.3, -0.2, 0.5 * (system.dim - 2)])), f, atol=1e-12 * scale)
    if isinstance(load, kt.Pressure) or getattr(load, "follows", False) or getattr(load, "axes", "") == "member":
        np.testing.assert_allclose(turned, f @ R.T, atol=1e-12 * scale)
    elif isinstance(load, (kt.BodyCouple, kt.MemberCouple, kt.MemberPointCouple)):
        moment = [np.cross(y, one).sum(axis=0) for y, one in ((x, f), (x @ R.T, turned))]
        np.testing.assert_allclose(moment[1], moment[0], atol=1e-12 * scale)
        np.testing.assert_allclose(f.sum(axis=0), 0.0, atol=1e-12 * scale)
    elif all(unit.constant for unit, _ in units):
        np.testing.assert_allclose(turned, f, atol=1e-12 * scale)
    else:  # it depends on the angle between force and member: both are turned
        other = load.with_(force=tuple((R[: system.dim, : system.dim] @ np.array(load.force)).tolist()))
        both = compile(system.given.with_(loads={"q": other}))
        amounts = history_of(other, np.zeros(1))[0]
        found = forces(list(zip(unit_loads_of(both, "q"), amounts, strict=True)), x @ R.T)
        np.testing.assert_allclose(found, f @ R.T, atol=1e-12 * scale)


def test_places_are_on_members_that_there_are(case):
    system, load, _, _ = case
    for one in LOADS[type(load)].places(system, bars_of(system), load):
        if isinstance(one, OnOthers):
            assert set(one.nodes) <= set(system.nodes)
            assert set(one.members) <= {*system.members, *system.model.beams}
            continue
        assert isinstance(one, OnMember)
        assert 0 <= one.member < len(system.members)
        ends = (one.place.begin, one.place.end) if isinstance(one.place, Spread) else (one.place, 1.0)
        assert 0.0 <= ends[0] <= ends[1] <= 1.0


def test_tables_have_the_derivatives_of_differences_by_all_numbers(case):
    """One complex step with each number in a copy of its own, against differences of tables of changed numbers."""
    agree_with_differences(case[0])


def test_cases_and_tables_in_time_have_them_too():
    forces = {"times": (0.0, 1.0), "forces": ((1.0, 2.0), (3.0, -1.0))}
    loads = {"push": kt.NodalForce(node="B", **forces), "along": kt.MemberLoad(member="BD", force=(3, -2))}
    cases = {"both": kt.LoadCase(loads={"push": 1.5, "along": 0.7}, gravity=(0, -1.6))}
    agree_with_differences(compile(PLANE.with_(loads=loads, load_cases=cases)), "both")


def test_loads_at_the_centre_of_a_body_follow_its_numbers():
    body = kt.Body(nodes=("A", "B", "C"), mass=1.0, center=(0.4, 0.3), inertia=0.1)
    system = compile(PLANE.with_(bodies={"plate": body}, loads={"q": kt.BodyForce(body="plate", force=(1, 0))}))
    agree_with_differences(system)
    moved = {"body_center": numbers_of(system)["body_center"] + [0.1, 0.0]}
    assert np.any(load_tables_at(system, moved, np.zeros(1))["q 0 data"] != load_tables_at(system, {}, np.zeros(1))["q 0 data"])


def agree_with_differences(system, case=None):
    own, t, h, tiny = numbers_of(system), np.array([0.0, 0.3]), 1e-6, 1e-30
    places = [(name, k) for name, one in own.items() for k in zip(*np.nonzero(~np.isnan(one)), strict=True)]
    made = {}
    for step in (1j * tiny, h, -h):
        copies = {name: np.repeat(one.astype(type(step))[None], len(places), axis=0) for name, one in own.items()}
        for copy, (name, k) in enumerate(places):
            copies[name][(copy, *k)] += step
        made[step] = load_tables_at(system, copies, t, case)
    for name, one in made[1j * tiny].items():
        difference = (made[h][name] - made[-h][name]) / (2 * h)
        np.testing.assert_allclose(one.imag / tiny, difference, rtol=1e-6, atol=1e-7, err_msg=name)
        base = load_tables_at(system, {}, t, case)[name]
        np.testing.assert_allclose(one.real, np.broadcast_to(base, one.shape), rtol=1e-14, atol=1e-14, err_msg=name)
