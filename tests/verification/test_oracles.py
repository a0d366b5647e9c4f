"""The oracles against the stored exact-physics values, before they may judge the product."""

from __future__ import annotations

import math

import numpy as np
import pytest

from kinetruss.verification.cases import cases
from reference import newton_euler, recursive_bays, sections, triangle
from reference.octahedral import MEMBERS, Bay, bay_truss, quintic
from reference.taylor import Taylor, cos, sin

TEN_DIGITS = 1e-9  # the stored values have ten digits: half a unit of the tenth is at most 5e-10 of the value
NAMES = list(MEMBERS)


def stored(prefix: str) -> dict:
    """Expected values below a prefix, nested as their ids are."""
    found: dict = {}
    for case in CASES:
        if case.id.startswith(prefix):
            *way, last = case.id.removeprefix(prefix).split(".")
            table = found
            for part in way:
                table = table.setdefault(part, {})
            table[last] = case.expected
    return found


def vector(table: dict) -> list[float]:
    return list(table.values())


def constant(value: float) -> Taylor:
    return Taylor(np.array(value), np.array(0.0), np.array(0.0))


def agree(computed, expected, scale: float = 0.0, tolerance: float = TEN_DIGITS) -> None:
    expected = np.asarray(expected, float)
    scale = scale or np.abs(expected).max()
    np.testing.assert_allclose(computed, expected, rtol=0, atol=tolerance * scale)


CASES = list(cases())
INSTANTS = ((1.0, 0.0), (1.0, 0.25), (5.5, 0.0), (5.5, 2.75))
"""Duration of a slew and time in it, s."""
SAMPLES = (0.3, 0.6, 1.2, 1.8, 2.4)
HEIGHT = 1.1218253458835146


@pytest.fixture(scope="module", params=INSTANTS)
def slew(request):
    """One stored instant of the single-bay slews with its Newton-Euler solution."""
    duration, t = request.param
    beta = quintic(t, duration, math.radians(-10), math.radians(10))
    (motion,) = recursive_bays.bay_motions(Bay(), [(beta, constant(0.0), constant(HEIGHT))])
    truss = bay_truss(Bay(), np.array([0, 0, 9.81]))
    external = np.zeros((9, 3))
    external[6:] = 0, 0, 46.0
    return stored(f"bay.T={duration:g}.t={t:g}."), truss, motion, newton_euler.solve(truss, *motion, external)


@pytest.mark.slow
def test_one_bay_is_117_equations_of_full_rank(slew):
    _, truss, _, solution = slew
    assert newton_euler.size(truss) == (117, 117)
    assert np.linalg.cond(solution.matrix) < 100


def test_single_bay_motion(slew):
    expected, truss, motion, _ = slew
    lengths = [newton_euler.axis_motion(truss.members[NAMES.index(m)], *motion)[0] for m in ("M7", "M9", "M11")]
    agree(lengths, vector(expected["active_lengths"]))
    agree(motion[0][7], vector(expected["N8"]))
    agree(motion[2][7], vector(expected["A8"]), scale=max(1.0, *map(abs, vector(expected["A8"]))))


def test_single_bay_forces(slew):
    expected, truss, motion, solution = slew
    agree(solution.reaction[:3], [vector(one) for one in expected["reactions"].values()])
    _, at_b = sections.end_tensions(truss, solution, motion)
    mean = sections.mean_tension(truss, solution, motion)
    for number, value in expected["tension_at_B_end"].items():
        agree(at_b[NAMES.index(number)], value)
    for number, value in expected["mean_tension_lambda"].items():
        agree(mean[NAMES.index(number)], value)
    for number, value in expected["actuator_axial"].items():
        agree(mean[NAMES.index(number)], value)


def test_single_bay_sections(slew):
    expected, truss, motion, solution = slew
    k, active = NAMES.index("M6"), NAMES.index("M7")
    middle = sections.bar_section(truss, k, solution, motion, 0.5)
    cantilever = sections.interface(truss, active, solution, motion)
    for (force, moment), index, name in ((middle, k, "M6_mid"), (cantilever, active, "M7_cantilever")):
        u = newton_euler.axis_motion(truss.members[index], *motion)[2]
        values = expected[name]
        agree(force @ u, values["T"])
        agree(force - (force @ u) * u, vector(values["V"]), scale=abs(values["T"]))
        agree(moment, vector(values["M"]))


def test_base_and_tube_meet_at_the_interface(slew):
    _, truss, motion, solution = slew
    for k, member in enumerate(truss.members):
        if len(member.rods) == 2:
            root = newton_euler.axis_motion(member, *motion)[0] - member.rods[1].length
            tube = sections.interface(truss, k, solution, motion)
            # the root lies beyond the base rod: the base, drawn out without mass, carries the same
            base = sections.base_section(truss, k, solution, motion, min(root, member.rods[0].length) * (1 - 1e-15))
            np.testing.assert_allclose(base[0], tube[0], atol=1e-11)
            u = newton_euler.axis_motion(member, *motion)[2]
            reach = root - min(root, member.rods[0].length)
            np.testing.assert_allclose(base[1] - reach * np.cross(u, tube[0]), tube[1], atol=1e-11)


@pytest.fixture(scope="module", params=(0.0, 1.5))
def chain(request):
    """One stored instant of the chain of three bays: motion, bay-by-bay and whole Newton-Euler solutions."""
    t = request.param
    angle = quintic(t, 3.0, 0.0, math.radians(10))
    motions = recursive_bays.bay_motions(Bay(), [(angle, angle, constant(HEIGHT))] * 3)
    gravity = np.array([0, 0, -9.81])
    by_bay = recursive_bays.chain_forces(Bay(), motions, gravity, tip_mass=2.0)
    truss = recursive_bays.chain_truss(Bay(), 3, gravity, tip_mass=2.0)
    whole = newton_euler.solve(truss, *recursive_bays.chain_motion(motions))
    return stored(f"chain.t={t:g}."), motions, by_bay, truss, whole


def test_chain_motion(chain):
    expected, motions, *_ = chain
    for number in (7, 8, 9):
        agree(motions[2][0][number - 1], vector(expected["top_nodes"][f"N{number}"]))
        largest = max(1.0, np.abs([vector(one) for one in expected["top_acc"].values()]).max())
        agree(motions[2][2][number - 1], vector(expected["top_acc"][f"N{number}"]), scale=largest)
    one = bay_truss(Bay(), np.zeros(3))
    active = [(bay, member, values) for bay, table in expected["active_L_Ld_Ldd"].items() for member, values in table.items()]
    for bay, member, values in active:
        length, rate, u, u_rate, _ = newton_euler.axis_motion(one.members[NAMES.index(member)], *motions[int(bay[1]) - 1])
        a, b = (node - 1 for node in MEMBERS[member])
        d = motions[int(bay[1]) - 1][2]
        agree([length, rate, u @ (d[b] - d[a]) + length * u_rate @ u_rate], vector(values), scale=1.0)


def test_chain_forces_bay_by_bay_and_whole(chain):
    expected, motions, by_bay, truss, whole = chain
    reactions = [vector(one) for one in expected["reactions_N1_N2_N3"].values()]
    agree(by_bay[0].reaction[:3], reactions)
    agree(whole.reaction[:3], reactions)
    motion = recursive_bays.chain_motion(motions)
    _, at_b = sections.end_tensions(truss, whole, motion)
    mean = sections.mean_tension(truss, whole, motion)
    one = bay_truss(Bay(), np.array([0, 0, -9.81]))
    for bay, table in enumerate(expected["tension_at_B_end"].values()):
        for member, value in table.items():
            k = NAMES.index(member)
            agree(at_b[18 * bay + k], value)
            agree(sections.end_tensions(one, by_bay[bay], motions[bay])[1][k], value)
    for bay, table in enumerate(expected["actuator_axial"].values()):
        for member, value in table.items():
            agree(mean[18 * bay + NAMES.index(member)], value)


def test_recursive_and_whole_form_agree_to_rounding(chain):
    _, _, by_bay, _, whole = chain
    parts = np.concatenate([np.hstack([s.force_a, s.force_b]) for s in by_bay])
    everything = np.hstack([whole.force_a, whole.force_b])
    assert np.abs(parts - everything).max() < 1e-12 * np.abs(everything).max()


@pytest.mark.parametrize("t", SAMPLES)
def test_triangle_samples(t):
    expected = stored(f"triangle.t={t:g}.")
    truss, motion = triangle.Triangle(), triangle.step_response(t)
    pose = triangle.pose(truss, *motion)
    agree(motion, [expected[name] for name in ("x", "xd", "xdd")])
    agree(pose.phi, [expected[name] for name in ("phi", "phid", "phidd")])
    agree(pose.theta, [expected[name] for name in ("theta", "thd", "thdd")])
    found = triangle.forces(truss, pose)
    for name, key in (("R1", "R1"), ("R2", "R2"), ("F1", "F_on_follower_at_B"), ("Ft", "F_on_tube_at_B")):
        agree(found[name], vector(expected[key]))
    agree(triangle.follower_section(truss, pose, found, 1.0), vector(expected["follower_mid_T_V_M"]))
    agree(triangle.tube_section(truss, pose, found, pose.length[0] - truss.tube), vector(expected["tube_cantilever_T_V_M"]))


def test_triangle_agrees_with_newton_euler():
    truss = triangle.Triangle()
    t = 0.7
    pose = triangle.pose(truss, *triangle.step_response(t))
    follower = newton_euler.Rod(truss.line * 2, 2.0, truss.line * 2 * truss.gyration)
    bars = (
        newton_euler.Member(1, 2, (follower,)),
        newton_euler.Member(0, 2, (newton_euler.Rod(truss.rod_mass, truss.rod_length), follower)),
    )
    supported = np.array([[True, True], [True, True], [False, False]])
    down = np.array([0.0, -truss.gravity])
    whole = newton_euler.Truss(bars, supported, down, np.array([0, 0, truss.load]), np.tile(down, (3, 1)))
    phi = Taylor(*map(np.array, pose.phi))
    x, y = 2.0 - cos(phi) * 2.0, sin(phi) * 2.0
    motion = [np.array([(0, 0), (2 if i == 0 else 0, 0), (a, b)]) for i, (a, b) in enumerate(
        ((x.value, y.value), (x.rate, y.rate), (x.acceleration, y.acceleration)))]  # fmt: skip
    solution = newton_euler.solve(whole, *motion)
    found = triangle.forces(truss, pose)
    agree(solution.reaction[:2], [found["R2"], found["R1"]], tolerance=1e-12)
    agree(solution.force_b, [found["F1"], found["Ft"]], tolerance=1e-12)
