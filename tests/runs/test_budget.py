"""Error budgets: closed forms, the linear budget against the Monte Carlo, and faults."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt

BAY = kt.library.vgt.double_octahedral(gravity=(0, 0, 9.81), tip_force=(0, 0, 46))
EACH = {"M*.length": "0.1 mm"}


def two_bars(height=1.0, half=0.75, **changes):
    """A symmetric pair of bars under a weight at its top, hanging: N = W l/(2 h)."""
    fields = {
        "nodes": {"A": (-half, 0), "B": (half, 0), "C": kt.model.Node(at=(0, -height), mass=10.0)}, "fixed": ["A", "B"],
        "bars": {"left": ("A", "C"), "right": ("B", "C")}, "gravity": (0, -9.81),
        "section": kt.Rod(diameter=0.02), "material": kt.Material(E=210e9, density=0.0),
    }  # fmt: skip
    return kt.Model(**fields | changes)


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(st.floats(0.3, 2.0), st.floats(0.3, 2.0))
def test_two_bars_in_closed_form(height, half):
    """Heron: the top of a triangle of sides l1, l2 over the base 2c; dy/dl1 = l1 (c - x)/(2 c y), dx/dl1 = l1/(2 c)."""
    found = kt.runs.budget(two_bars(height, half), ["C.x", "C.y", "left.force"], {"*.length": 1e-4}, samples=200)
    side = math.hypot(height, half)
    x, y = side / (2 * half), -side / (2 * height)
    np.testing.assert_allclose(found.sensitivity.values[0], [x, -x], rtol=1e-9)
    np.testing.assert_allclose(found.sensitivity.values[1], [y, y], rtol=1e-9)
    # N1 = W l1 (c - x)/(2 c h): with its derivatives by l1, of l1, x and h
    N = 98.1 * side / (2 * height)
    assert found.nominal.values[2] == pytest.approx(N)
    first = N * (1 / side - x / half - side / (2 * height) / height)
    other = N * (x / half - side / (2 * height) / height)
    np.testing.assert_allclose(found.sensitivity.values[2], [first, other], rtol=1e-6, atol=1e-6 * N)
    assert found.worst_case.values[0] == pytest.approx(2e-4 * x)
    assert found.root_sum_square.values[0] == pytest.approx(math.sqrt(2) * 1e-4 * x)


@pytest.mark.slow
def test_linear_budget_and_monte_carlo_agree_within_its_noise():
    of = ["bay.beta", "bay.gamma", "bay.height", "N8.x", "M6.force", "M7.drive_force"]
    found = kt.runs.budget(BAY, of, EACH, at={"bay.beta": 0.1, "bay.gamma": -0.05}, samples=4000, seed=2)
    off = (found.monte_carlo - found.root_sum_square) / found.monte_carlo_error
    assert np.abs(off).max() < 4
    assert (found.root_sum_square <= found.worst_case).all()
    # the mean of a linear model does not move
    assert (np.abs(found.monte_carlo_shift) < 4 * found.root_sum_square / 3 / math.sqrt(4000) + 1e-9).all()
    assert float((found.sensitivity_error / np.abs(found.sensitivity).max()).max()) < 1e-4


def test_pose_coordinates_turn_with_bars_that_no_drive_moves():
    """T85: d gamma/d M6 of the upright bay; the three lengths of the drives do not change."""
    found = kt.runs.budget(BAY, "bay.gamma", {"M6.length": 1e-4}, samples=10)
    exact = kt.kinematics.jacobian(BAY, of="bay.gamma", wrt="M6").item()
    assert found.sensitivity.item() == pytest.approx(exact, rel=1e-9)
    assert abs(exact) > 0.1


def test_draws_are_assembled_as_a_model_with_these_lengths():
    """The table of drive lengths and a model assembled with another length put the node at one place."""
    tolerance = 0.01
    found = kt.runs.budget(BAY, ["N8.x", "N8.y"], {"M6.length": tolerance}, samples=400, deviations=1.0)
    length = kt.kinematics.assemble(BAY)
    l6 = np.linalg.norm(length[list(BAY.nodes).index("N5")] - length[list(BAY.nodes).index("N2")])
    x = [kt.kinematics.assemble(BAY, lengths={"M6": l6 + s * tolerance})[list(BAY.nodes).index("N8")] for s in (1, -1)]
    slope = (x[0] - x[1])[:2] / 2
    np.testing.assert_allclose(found.sensitivity.values[:, 0] * tolerance, slope, rtol=2e-2)


def test_temperature_of_a_free_bar_and_of_a_similar_figure():
    """All bars of a triangle grow alike: it stays similar, and its top rises by alpha dT h, if the base grows too."""
    model = two_bars(fixed={"A": "xy", "B": "y"}, bars={"left": ("A", "C"), "right": ("B", "C"), "base": ("A", "B")})
    found = kt.runs.budget(model, ["C.y", "B.x", "left.force"], {"temperature": 20}, expansion=12e-6, samples=50)
    np.testing.assert_allclose(found.share.values[:2, 0], [-12e-6 * 20, 12e-6 * 20 * 1.5], rtol=1e-9)
    assert abs(found.share.values[2, 0]) < 1e-6  # forces of a similar figure are the same


@pytest.mark.slow
def test_forces_are_linear_in_masses():
    found = kt.runs.budget(two_bars(), "left.force", {"nodes.C.mass": "2 %"}, samples=200, seed=1)
    assert found.share.item() == pytest.approx(0.02 * found.nominal.item(), rel=1e-9)
    assert found.monte_carlo.item() == pytest.approx(found.root_sum_square.item(), abs=4 * found.monte_carlo_error.item())


def test_play_moves_every_member_of_its_node():
    found = kt.runs.budget(two_bars(), "C.y", {"C.play": "0.05 mm"}, samples=50)
    assert list(found.parameter.values) == ["C.play of left", "C.play of right"]
    assert found.worst_case.item() == pytest.approx(2 * 0.05e-3 * 1.25 / 2, rel=1e-9)


@pytest.mark.slow
def test_strain_and_friction_and_text():
    model = two_bars(gauges={"G": {"member": "left"}}, sections={"rod": kt.Rod(diameter=0.02)}, section="rod")
    found = kt.runs.budget(model, ["G.strain", "left.force"], {"sections.*.diameter": "1 %"}, samples=100)
    assert found.share.values[0, 0] == pytest.approx(-0.02 * found.nominal.values[0], rel=1e-3)  # area goes with d^2
    assert abs(found.share.values[1, 0]) < 1e-9
    assert "worst case" in found.text
    assert "sections.rod.diameter" in found.text


def test_inertia_forces_of_a_motion_count():
    slew = kt.Quintic(moves={"bay.beta": (-0.2, 0.2)}, duration=0.4)
    still = kt.runs.budget(BAY, "M7.drive_force", {"M7.length": 1e-4}, at={"bay.beta": 0.0}, samples=10)
    moving = kt.runs.budget(BAY, "M7.drive_force", {"M7.length": 1e-4}, at=(slew, 0.1), samples=10)
    motion = kt.kinematics.follow(BAY, slew, times=[0.1])
    own = kt.dynamics.inverse(BAY, motion).drive_force.sel(drive="M7").item()
    assert moving.nominal.item() == pytest.approx(own, rel=1e-9)
    assert abs(moving.nominal.item() - still.nominal.item()) > 1


@pytest.mark.parametrize(("of", "tolerances", "said"), [
    ("C.z", {"*.length": 1e-4}, "No coordinate called 'C.z'"),
    ("C.x", {"lft.length": 1e-4}, "No member fits 'lft.length'"),
    ("C.x", {"left.length": "1 kg"}, "Tolerance of left.length"),
    ("C.x", {"left.length": 0}, "expected a positive number"),
    ("C.x", {"left.length": 1e-4, "*.length": 1e-4}, "two tolerances"),
    ("C.x", {"materials.x.density": 1}, "is no number of the model"),
    ("C.x", {"temperature": 10}, "no thermal expansion"),
    ("C.x", {}, "No tolerance is given"),
    ("C", {"left.length": 1e-4}, "stands for 2 coordinates"),
])  # fmt: skip
def test_faults(of, tolerances, said):
    with pytest.raises(kt.InputError, match=said.replace("(", r"\(")):
        kt.runs.budget(two_bars(), of, tolerances)


def test_a_length_that_others_hold_too_is_refused():
    model = two_bars(bars={"left": ("A", "C"), "right": ("B", "C"), "base": ("A", "B"), "twice": ("B", "C")})
    with pytest.raises((kt.InputError, kt.AnalysisError)):
        kt.runs.budget(model, "C.x", {"twice.length": 1e-4})


@pytest.mark.slow
def test_out_of_reach_within_the_tolerances_is_said():
    with pytest.raises((kt.InputError, kt.AnalysisError)):
        kt.runs.budget(two_bars(height=0.01), "C.y", {"*.length": 0.5})


def uneven_bars(**changes):
    x = (1.7**2 - 1.4**2 + 4) / 4
    fields = {
        "nodes": {"A": (0, 0), "B": (2, 0), "C": (x, np.sqrt(1.7**2 - x * x))},
        "fixed": ["A", "B"],
        "bars": {"a": ("A", "C"), "b": ("B", "C")},
        "loads": {"P": kt.NodalForce(node="C", force=(0, 1000.0))},
    }
    return kt.Model(**fields | changes)


def uneven_bars_force(a, b):
    """N in bar a of two bars between feet 2 m apart, 1000 N upwards on top; for complex lengths too."""
    x = (a * a - b * b + 4) / 4
    y = np.sqrt(a * a - x * x)
    return (2 - x) / b * 1000.0 / ((x / a) * (y / b) + (2 - x) / b * (y / a))


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
def test_sensitivities_of_forces_are_the_derivatives_of_the_closed_form(tolerance):
    found = kt.runs.budget(uneven_bars(), ["a.force"], {"a.length": tolerance, "b.length": tolerance}, samples=4)
    step = 1e-30j
    wanted = [uneven_bars_force(1.7 + step, 1.4).imag / 1e-30, uneven_bars_force(1.7, 1.4 + step).imag / 1e-30]
    assert found.nominal.item() == pytest.approx(uneven_bars_force(1.7, 1.4), rel=1e-12)
    assert found.sensitivity.values[0] == pytest.approx(wanted, rel=1e-9)


def test_loads_in_time_are_those_of_the_instant():
    """Draws are counted along the time axis: the load must not run on with them."""
    tolerances = {"a.length": 1e-4, "b.length": 1e-4}
    timed = kt.NodalForce(node="C", times=[0, 5], forces=[(0, 1000.0), (0, 9000.0)])
    still, moving = (
        kt.runs.budget(model, ["a.force"], tolerances, samples=50) for model in (uneven_bars(), uneven_bars(loads={"P": timed}))
    )
    assert moving.nominal.item() == still.nominal.item()
    assert moving.monte_carlo.item() == pytest.approx(still.monte_carlo.item(), rel=1e-12)
    crane = kt.library.vgt.triangular(gravity=None).with_(
        loads={"push": kt.NodalForce(node="B", times=[0, 2], forces=[(0, 0), (0, -200.0)])}
    )
    rest = kt.Quintic(moves={"actuator": (2.5, 2.5)}, duration=2.0)
    half = kt.runs.budget(crane, ["follower.force"], {"actuator.length": 1e-4}, at=(rest, 1.0), samples=4)
    held = crane.with_(loads={"push": kt.NodalForce(node="B", force=(0, -100.0))})
    assert half.nominal.item() == pytest.approx(
        kt.statics.at_poses(held, [{}]).member_force.sel(member="follower").item(), rel=1e-9
    )


def test_moving_supports_are_refused():
    model = uneven_bars(support_motion={"B": kt.History(times=[0, 1], displacements=[(0.0, 0.0), (0.1, 0.0)])})
    with pytest.raises(kt.InputError, match="moving supports"):
        kt.runs.budget(model, ["a.force"], {"a.length": 1e-4}, samples=4)


@pytest.mark.slow
def test_names_with_dots_stand_for_members_nodes_and_records_of_chains():
    mast = kt.library.vgt.double_octahedral(bays=2)
    of = ["B2.N8.x", "B1.M6.force"]

    def parameters(tolerances):
        return kt.runs.budget(mast, of, tolerances, samples=10).data.parameter.values.tolist()

    assert parameters({"B2.M7.length": 1e-4, "B1.M[1-3].length": 1e-4}) == [
        f"{one}.length" for one in ("B2.M7", "B1.M1", "B1.M2", "B1.M3")
    ]
    assert parameters({"B1.N8.play": 1e-4})[0].startswith("B1.N8.play of B1.M")
    assert parameters({"active.B2.M7.base.mass": 0.1}) == ["active.B2.M7.base.mass"]
    assert parameters({"active.B2.*.base.mass": "1 %"}) == [f"active.B2.{one}.base.mass" for one in ("M7", "M9", "M11")]
    with pytest.raises(kt.InputError, match=r"No member fits 'B7\.M7\.length'"):
        parameters({"B7.M7.length": 1e-4})


def test_bars_between_fixed_nodes_move_nothing():
    """The battens on the ground: patterns, play and temperature leave them out; by name they are refused."""
    tower = kt.library.cells.stack([kt.library.cells.prism(3, side=0.6, height=0.5)] * 2)
    top = next(reversed(tower.nodes))
    ground = [name for name, one in tower.bars.items() if all(node in tower.fixed for node in one.ends)]
    found = kt.runs.budget(tower, f"{top}.z", {"*.length": "0.1 mm"}, samples=10)
    assert len(ground) == 3
    assert len(found.data.parameter) == len(tower.bars) - 3
    # closed form: heated alike, the tower on its fixed feet grows as one whose feet move, but for its lowest bay
    heated = kt.runs.budget(tower, f"{top}.z", {"temperature": 10.0}, expansion=1e-5, samples=10)
    post = float(np.linalg.norm(np.subtract(tower.nodes["B1.N4"].at, tower.nodes["B1.N1"].at)))
    assert heated.data.worst_case.item() == pytest.approx(2 * 1e-4 * post, rel=0.05)
    with pytest.raises(kt.InputError, match="joins two fixed nodes, so an error of its length moves nothing. Leave it out."):
        kt.runs.budget(tower, f"{top}.z", {f"{ground[0]}.length": 1e-4})
