"""The stored numbers of the verification, recomputed: closed forms, and independent formulations in `reference`."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.verification import solids
from kinetruss.verification.cases import cases, model, stored
from kinetruss.verification.mechanisms import BENNETT
from reference import (
    andrews,
    bennett,
    closed_forms,
    hub_bay,
    linkages,
    pendulums,
    recursive_bays,
    rods,
    spring_forms,
    total_lagrange,
)
from reference.octahedral import Bay, quintic
from reference.taylor import Taylor

CASES = {case.id: case for case in cases()}
PRINTED = recursive_bays.PrintedFrame
DIGITS = 1e-13
"""Of the value, or of the vector it belongs to: sixteen digits are stored."""


def near(case_id: str, value: float, tolerance: float = DIGITS) -> None:
    case = CASES[case_id]
    size = max(abs(case.expected), case.scale)
    assert tolerance <= 0.1 * (case.tolerance or 1.0), f"{case_id}: a check this loose says little"
    assert abs(value - case.expected) <= tolerance * size, f"{case_id}: {value!r}, stored is {case.expected!r}"


@pytest.mark.parametrize("subject", closed_forms.ALL, ids=lambda subject: subject.__name__)
def test_closed_forms_give_what_is_stored(subject):
    for name, value in subject().items():
        near(name, value, min(DIGITS, 0.1 * (CASES[name].tolerance or 1.0)))


OTHERWISE = ("drive.", "pose.", "delta.", "equilibrium.rhombus", "frequencies.rhombus")
"""Closed forms solved at more digits than a double has, or of few digits: stored as they came."""


def test_every_closed_form_that_is_stored_is_recomputed():
    known = {name for subject in closed_forms.ALL for name in subject()}
    left = {
        name
        for name, case in CASES.items()
        if case.reference.kind == "closed-form" and case.expected != 0 and not name.startswith(OTHERWISE)
    }
    assert left <= known, sorted(left - known)


@pytest.mark.parametrize(("name", "stroke"), [("shorter", -0.05), ("longer", 0.06)])
def test_the_bay_with_offset_joints(name, stroke):
    nodes = kt.library.vgt.double_octahedral().nodes
    place, rise = hub_bay.ThreeFold({name: node.at for name, node in nodes.items()}, 0.04).moved(stroke)
    near(f"hub.bay.{name}.height", place[2], 1e-13)
    # by a difference of fourth order
    near(f"hub.bay.{name}.force", 200 * rise, 1e-11)


@pytest.mark.parametrize("kind", total_lagrange.KINDS)
def test_elements_by_the_total_lagrangian_formulas(kind):
    start = solids.drawn(model(f"element.{kind}"))
    for state in stored("solids")["exact"][kind]:
        x = np.array(state["at"])
        assert np.abs(x - start).max() > 0.1
        force, K = total_lagrange.forces(kind, start, x), total_lagrange.tangent(kind, start, x)
        assert np.abs(force - state["force"]).max() < 1e-14 * np.abs(force).max()
        assert np.abs(K - K.T).max() < 1e-14 * np.abs(K).max()
        along = K @ solids.moved(x.size)
        assert np.abs(along - state["tangent"]).max() < 1e-14 * np.abs(along).max()


@pytest.mark.parametrize("name", BENNETT)
def test_bennett_by_the_equation_of_its_one_freedom(name):
    own = dict(BENNETT[name])
    angle = own.pop("angle")
    places = bennett.bennett_places(own["twist"], own["other_twist"])
    q, _ = bennett.one_freedom(places, angle, 0.0, 3.0)
    assert np.abs(places(float(q)) - stored("mechanisms")["exact"]["bennett"][name]).max() < 1e-12


def test_symmetric_top_by_its_two_turns():
    """Rotation about the constant momentum with |L|/A, after one about the figure's axis (Euler; Goldstein, ch. 5.6)."""
    top = model("bipyramid")
    at, drift = solids.drawn(top), np.array([0.3, 0.2, -0.1])
    spin, A, C = np.array([1.5, -0.4, 4.0]), 0.0, 0.0
    for bar in top.bars.values():
        p, q = (np.array(top.nodes[end].at) for end in bar.ends)
        own = np.outer(p, p) + np.outer(q, q) + np.outer(p + q, p + q)  # 6/m times the second moments of a uniform rod
        A, C = A + bar.mass / 6 * (own[1, 1] + own[2, 2]), C + bar.mass / 6 * (own[0, 0] + own[1, 1])
    for name, velocity in top.velocities.items():
        assert np.abs(drift + np.cross(spin, top.nodes[name].at) - velocity).max() < 1e-14
    momentum = np.array([A, A, C]) * spin / A
    for t, stored_places in zip((5.0, 10.0), stored("forward")["exact"]["bipyramid"], strict=True):
        turn = Rotation.from_rotvec(momentum * t) * Rotation.from_rotvec([0.0, 0.0, (1 - C / A) * spin[2] * t])
        assert np.abs(drift * t + turn.apply(at) - stored_places).max() < 1e-13


def test_loads_of_the_leaning_truss_belong_to_the_heights():
    """The force of both bars on the apex at the expected height: N = E A (l0 - l)/l0, or of Green's strain, E A = l0."""
    rest = math.hypot(1.0, 0.3)
    for case in CASES.values():
        if case.make == "statics.leaning" and case.key == "height":
            (strain, load), y = case.arguments, case.expected
            green, length = (0.3**2 - y**2) * y / rest**2, math.hypot(1.0, y)
            assert load == pytest.approx(green if strain == "green" else 2 * (rest - length) * y / length, rel=1e-13)


def test_three_rods_by_lagrange_in_angles():
    rods = pendulums.Chain((1.0,) * 3, (1.0,) * 3, (0.0,) * 3)
    theta, rate = rods.run(np.full(3, math.pi / 2), np.zeros(3), np.array([0.0, 0.5, 1.0, 2.0]))
    for k, t in enumerate((0.5, 1.0, 2.0), start=1):
        x, y = rods.joints(theta[k], rate[k])[0][-1]
        for where in ("forward", "forward.taylor"):
            near(f"{where}.triple_pendulum.x_at_{t:g}s", x, 1e-11)
            near(f"{where}.triple_pendulum.y_at_{t:g}s", y, 1e-11)
    places = rods.joints(theta[1], rate[1])[0]
    assert np.abs(places - stored("forward")["exact"]["triple_pendulum"]).max() < 1e-12


def test_row_of_four_bars_by_elliptic_functions():
    for loops, end in stored("forward")["exact"]["n_four_bar"].items():
        (theta,), (rate,) = linkages.row_of_four_bars(loops, np.array([10.0]))
        assert abs(math.sin(theta) - end["x"]) + abs(math.cos(theta) - end["y"]) < 1e-11
        assert abs(rate * math.cos(theta) - end["vx"]) + abs(rate * math.sin(theta) + end["vy"]) < 1e-10


def test_spatial_slider_crank_by_lagrange():
    crank = linkages.SlidingCrank()
    theta, rate = crank.run(np.array([0.0, 1.0, 2.0]))
    for k, t in enumerate((1, 2), start=1):
        where, (s, slope, _) = f"forward.spatial_slider_crank.{{}}_at_{t}s", crank.slide(theta[k])
        near(where.format("y_P"), 0.1 - 0.08 * math.sin(theta[k]), 1e-10)
        near(where.format("z_P"), 0.12 + 0.08 * math.cos(theta[k]), 1e-10)
        near(where.format("x_S"), s, 1e-10)
        near(where.format("v_S"), slope * rate[k], 1e-10)


@pytest.mark.slow
def test_andrews_by_its_crank_alone():
    names = ("beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon")
    q, v = (history[-1] for history in andrews.run(np.array([0.0, andrews.END])))
    w = andrews.acceleration(q, v)
    for kind, values, tolerance in (("angle", q, 1e-12), ("rate", v, 1e-10), ("acceleration", w, 1e-9)):
        for name, value in zip(names, values, strict=True):
            near(f"forward.andrews.exact.{kind}.{name}", value, tolerance)
    for node, place in andrews.points(q).items():
        near(f"forward.andrews.{node}.x", place[0], 1e-12)
        near(f"forward.andrews.{node}.y", place[1], 1e-12)
    start = andrews.acceleration(andrews.START, np.zeros(7))
    for name, value in zip(names, start, strict=True):
        near(f"forward.andrews.start.acceleration.{name}", value)
    motion = andrews.nodes(q, v)
    for name, (x, *rates) in stored("forward")["exact"]["andrews"].items():
        assert np.abs(motion[0][name] - x).max() < 1e-13, name
        for own, value, size in zip(motion[1:], rates, (10.0, 1e4), strict=True):
            assert np.abs(own[name] - value).max() < 1e-10 * size, name


def test_transfer_functions_of_andrews_by_its_crank():
    """Slopes of the places by the angle of the crank, and their slopes by a central difference of fourth order."""

    def slopes(beta: float) -> dict[str, np.ndarray]:
        q = andrews.closed(beta, andrews.START)
        return andrews.nodes(q, andrews.rates(q, 1.0))[1]

    h, beta = 1e-3, andrews.START[0]
    first, sides = slopes(beta), {k: slopes(beta + k * h) for k in (-2, -1, 1, 2)}
    for node in "FEDGH":
        second = (sides[-2][node] - 8 * sides[-1][node] + 8 * sides[1][node] - sides[2][node]) / (12 * h)
        for k, axis in enumerate("xy"):
            near(f"transfer_functions.andrews.first_{node}{axis}", first[node][k], 1e-14)
            case = CASES[f"transfer_functions.andrews.second_{node}{axis}"]
            assert abs(second[k] - case.expected) < 1e-8 * case.scale


@pytest.mark.parametrize("masses", ["consistent", "lumped"])
def test_ten_bars_by_assembled_matrices(masses):
    from scipy.linalg import eigh

    truss, E, area, density = model("ten_bars"), 70e9, 1e-3, 2700.0
    at, order = solids.drawn(truss), list(truss.nodes)
    K, M = np.zeros((12, 12)), np.zeros((12, 12))
    for i, j in ([order.index(end) for end in bar.ends] for bar in truss.bars.values()):
        d = at[j] - at[i]
        l = float(np.linalg.norm(d))
        dofs = [2 * i, 2 * i + 1, 2 * j, 2 * j + 1]
        along = np.concatenate([-d, d]) / l
        K[np.ix_(dofs, dofs)] += E * area / l * np.outer(along, along)
        m = density * area * l
        own = np.kron([[2, 1], [1, 2]], np.eye(2)) * m / 6 if masses == "consistent" else np.eye(4) * m / 2
        M[np.ix_(dofs, dofs)] += own
    squares = eigh(K[:8, :8], M[:8, :8], eigvals_only=True)
    for k, value in enumerate(np.sqrt(squares) / (2 * math.pi), start=1):
        near(f"frequencies.ten_bars.{masses}.mode_{k}", value)


def test_a_number_that_serves_two_analyses_is_one_number():
    """The equations of Newton and Euler, and the rates of members, are compared with the samples of the inverse dynamics."""
    pairs = {"follower.A": "R1", "actuator.A": "R2", "follower.B": "F_on_follower_at_B"}
    for name in CASES:
        if found := re.fullmatch(r"explain\.triangle\.(t=[\d.]+)\.(follower\.A|actuator\.A|follower\.B)\.([xy])", name):
            t, force, axis = found.groups()
            assert CASES[name].expected == CASES[f"triangle.{t}.{pairs[force]}.{axis}"].expected
        if found := re.fullmatch(r"explain\.bay\.(T=.*)\.(N\d\.[xyz]|M\d+\.tension_B)", name):
            t, force = found.groups()
            other = f"tension_at_B_end.{force.removesuffix('.tension_B')}" if force.endswith("B") else f"reactions.{force}"
            assert CASES[name].expected == CASES[f"bay.{t}.{other}"].expected
        if name.startswith("rates.triangle."):
            assert CASES[name].expected == CASES[name.removeprefix("rates.")].expected
        for other in ("statics.linear.", "statics.at_poses."):
            if name.startswith(other):
                assert CASES[name].expected == CASES[name.removeprefix(other)].expected


TOGETHER, DELAYED = (0.75, 1.5, 2.25), (0.5, 1.0, 1.5, 2.0, 2.5)
SIZES = {"velocity": (4e-4, 1.7e-2), "acceleration": (5e-4, 2.6e-2), "force": (8e-3, 0.74)}
"""Differences of equations 6.9 and 6.14 as printed, to one or two digits: both angles together, gamma 0.75 s later."""


@pytest.mark.slow
@pytest.mark.parametrize(("move", "start", "instants"), [("together", 0.0, TOGETHER), ("delayed", 0.75, DELAYED)])
def test_the_frames_of_a_chain_as_printed_by_the_recursive_form(move, start, instants):
    found = dict.fromkeys(SIZES, 0.0)
    for t in instants:
        tilt = math.radians(10)
        gamma = quintic(t - start, 3.0 - start, 0.0, tilt) if t > start else Taylor(np.array(0.0), np.array(0.0), np.array(0.0))
        height = Taylor(np.array(1.1218253458835146), np.array(0.0), np.array(0.0))
        poses = [(quintic(t, 3.0, 0.0, tilt), gamma, height)] * 3
        gravity = np.array([0.0, 0.0, -9.81])
        right, printed = (recursive_bays.bay_motions(Bay(), poses, kind) for kind in (recursive_bays.Frame, PRINTED))
        forces = [recursive_bays.chain_forces(Bay(), motions, gravity, tip_mass=2.0) for motions in (right, printed)]
        for k in range(3):
            for key, i in (("velocity", 1), ("acceleration", 2)):
                found[key] = max(found[key], float(np.abs(right[k][i] - printed[k][i]).max()))
            both = [(getattr(forces[0][k], end), getattr(forces[1][k], end)) for end in ("force_a", "force_b")]
            found["force"] = max(found["force"], *(float(np.linalg.norm(a - b, axis=1).max()) for a, b in both))
    for name, value in found.items():
        near(f"chain.eq_6_9_6_14.{move}.{name}", value, 1e-8)
        assert round(value / SIZES[name][move == "delayed"], 1) in (0.9, 1.0), name


def test_rods_as_boundary_value_problems():
    """The product is given 9 digits or so, and agrees to fewer: 1e-8 is what shooting and the extremes of loads leave."""
    strip, leaf = kt.Rectangle(width=rods.STRIP["thickness"], height=rods.STRIP["width"]), kt.Rectangle(width=0.6, height=30.0)
    vectors = {"thick": rods.heavy(), "sheared": rods.sheared()}
    for name, (x, y) in vectors.items():
        near(f"beams.{name}.x", x, 1e-9)
        near(f"beams.{name}.y", y, 1e-9)
    for name, load in (("compressed", -2.0), ("pulled", 4.0)):
        top, side = rods.diamond(load)
        near(f"beams.diamond.{name}.top", top, 1e-8)
        near(f"beams.diamond.{name}.side", side, 1e-8)
    high, low = rods.turning_points(rods.toggle, (0.15, 0.3), (0.3, 0.5))
    near("beams.toggle.high", high, 1e-8)
    near("beams.toggle.low", low, 1e-8)
    near("beams.lee.high", rods.turning_points(rods.Lee().force, (46.0, 51.0))[0], 1e-8)
    wide, narrow = rods.princeton(strip.torsion_constant, 8.896, 45.0)
    near("beams.princeton.wide", wide, 1e-9)
    near("beams.princeton.narrow", narrow, 1e-9)
    near("beams.right_angle.load", rods.right_angle(leaf.torsion_constant), 1e-7)


def test_springs_by_quadrature_and_by_the_elastica():
    near("spring.large.time", spring_forms.way_to_rest(), 1e-12)
    near("spring.elastica.slope", spring_forms.tip_slope(2.0), 1e-12)
