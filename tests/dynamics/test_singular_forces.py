"""Forces in singular positions: loads along what still holds have many sets of forces, and none of them is the answer.

Two links of lengths p and q on one line, on fixed supports, carry F along the line at their joint with N_a - N_c = F: the set
of least norm is F/2, -F/2. Out of line by h the forces are unique: F sqrt(p^2 + h^2)/(p + q) and -F sqrt(q^2 + h^2)/(p + q).
"""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.report.run_data import largest_forces
from kinetruss.runs.doubts import doubts, remarks

NOT_UNIQUE = "the force of these members is not unique there: {}."


def turned(points, scale, turn, away):
    """Points (k, 3) turned about z by `turn`, scaled and moved."""
    return scale * np.asarray(points, float) @ Rotation.from_euler("z", turn).as_matrix().T + away


def links(points, force):
    """Massless links a, c from node 0 to 1 and from 1 to 2, with a force on node 1."""
    names = ["A", "M", "C"]
    return kt.Model(
        nodes={name: tuple(at[:2]) for name, at in zip(names, points, strict=True)},
        fixed=["A", "C"],
        bars={"a": kt.Bar(ends=("A", "M"), mass=0), "c": kt.Bar(ends=("M", "C"), mass=0)},
        loads={"F": kt.NodalForce(node="M", force=tuple(force[:2]))},
    )


def inverse_at(model, position):
    """Inverse dynamics of positions (times, nodes, dim) at rest."""
    position = np.asarray(position, float)
    still = np.zeros_like(position)
    motion = kt.kinematics.from_arrays(model, np.arange(len(position), dtype=float), position, still, still)
    return kt.dynamics.inverse(model, motion, static=False)


def at_start(model):
    return inverse_at(model, [[model.nodes[name].at for name in model.nodes]])


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("turn", [0.0, 0.3, np.pi / 3, 2.0])
@pytest.mark.parametrize("away", [0.0, 7.0])
def test_links_on_one_line_are_told(scale, turn, away):
    points = turned([(0, 0, 0), (1, 0, 0), (2, 0, 0)], scale, turn, scale * away * np.array([1.0, 2.0, 0.0]))
    model = links(points, turned([(3.0, 0, 0)], 1.0, turn, 0.0)[0])
    for found in (kt.statics.at_poses(model, [{}]), at_start(model)):
        np.testing.assert_allclose(found.member_force.values, [[1.5, -1.5]], rtol=0, atol=1e-12)
        assert NOT_UNIQUE.format("a, c") in found.message
    with pytest.raises(kt.InputError, match="mechanism"):
        kt.statics.linear(model)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(
    st.floats(-3, 3), st.floats(0, 6.3), st.floats(0.3, 0.7),
    st.tuples(*[st.floats(-5, 5)] * 3), st.tuples(*[st.floats(-3, 3)] * 3),
)  # fmt: skip
def test_what_is_told_does_not_depend_on_axes_or_units(power, turn, share, away, vector):
    """In space: three links in a plane, loaded in it."""
    flat = np.array([(0, 0, 0), (1, 0, 0), (-share, 0.8, 0), (0.2, -1, 0)], float)
    size, R = 10.0**power, Rotation.from_rotvec(vector) * Rotation.from_euler("z", turn)
    at = size * (R.apply(flat) + away)
    force = R.apply([0.3, -0.7, 0.0])
    model = kt.Model(
        nodes={name: tuple(x) for name, x in zip("MABC", at, strict=True)}, fixed=["A", "B", "C"],
        bars={name.lower(): kt.Bar(ends=("M", name), mass=0) for name in "ABC"},
        loads={"F": kt.NodalForce(node="M", force=tuple(force))},
    )  # fmt: skip
    found = at_start(model)
    # least norm of the three forces whose directions add up to minus the load
    u = (flat[1:] - flat[0]) / np.linalg.norm(flat[1:] - flat[0], axis=1)[:, None]
    expected = np.linalg.pinv(u[:, :2].T) @ [-0.3, 0.7]
    np.testing.assert_allclose(found.member_force.values[0], expected, rtol=0, atol=1e-10)
    assert NOT_UNIQUE.format("a, b, c") in found.message


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("turn", [0.0, 0.3, np.pi / 3])
@pytest.mark.parametrize("h", [1e-12, 1e-10, 1e-7, 1e-4, 0.1])
def test_beside_the_line_forces_are_unique(scale, turn, h):
    """No alarm; where fewer than seven digits are left, their number is told, and they are as good as that."""
    points = turned([(0, 0, 0), (1, h, 0), (3, 0, 0)], scale, turn, 0.0)
    found = at_start(links(points, turned([(1.0, 0, 0)], 1.0, turn, 0.0)[0]))
    # N_a cos - N_c cos' = F and N_a sin + N_c sin' = 0
    a, c = np.hypot(1, h), np.hypot(2, h)
    expected = np.array([a, -c]) / 3.0
    error = np.abs(found.member_force.values[0] - expected).max()
    assert "not unique" not in found.message
    if h >= 1e-7:
        assert not found.message and error < 1e-7
    else:
        assert "Forces are sure to about" in found.message and error < 1e-14 / h


def test_a_force_across_has_no_answer():
    points = turned([(0, 0, 0), (1, 0, 0), (2, 0, 0)], 1.0, 0.3, 0.0)
    for across in (1.0, 1e-6):
        force = turned([(1.0, across, 0)], 1.0, 0.3, 0.0)[0]
        with pytest.raises(kt.AnalysisError, match="Position 0 of 1 is singular: drives and bars leave a motion free there"):
            at_start(links(points, force))


def test_a_weight_that_a_load_carries_is_in_balance():
    model = links([(0, 0, 0), (1, 0, 0), (2, 0, 0)], (4.0, 3 * 9.81, 0.0)).with_(gravity=(0, -9.81))
    model = model.with_(nodes=model.nodes | {"M": kt.Node(at=(1, 0), mass=3.0)})
    found = at_start(model)
    np.testing.assert_allclose(found.member_force.values, [[2.0, -2.0]], rtol=0, atol=1e-12)
    assert NOT_UNIQUE.format("a, c") in found.message


def test_in_a_chain_those_that_share_the_self_stress_are_named():
    """C hangs on d and e, so that they carry what a and c do; f only what hangs on it."""
    model = kt.Model(
        nodes={"A": (0, 0), "M": (1, 0), "C": (2, 0), "D": (3, 1), "E": (3, -2), "P": (2, -1), "Q": (4, -1)},
        fixed=["A", "D", "E", "Q"],
        bars={
            name: kt.Bar(ends=tuple(ends), mass=0)
            for name, ends in {"a": "AM", "c": "MC", "d": "CD", "e": "CE", "f": "CP", "g": "PQ"}.items()
        },
        loads={"F": kt.NodalForce(node="M", force=(1.0, 0.0)), "G": kt.NodalForce(node="P", force=(1.0, -2.0))},
    )
    found = kt.statics.at_poses(model, [{}])
    assert NOT_UNIQUE.format("a, c, d, e") in found.message
    N = dict(zip(found.member.values.tolist(), found.member_force.values[0], strict=True))
    assert N["a"] - N["c"] == pytest.approx(1.0, abs=1e-12)
    assert [N["f"], N["g"]] == pytest.approx([2.0, -1.0], abs=1e-12)


def passing(h, **more):
    """Driven links whose joint is at (1, h) at each time."""
    model = kt.Model(
        nodes={"A": (0, 0), "M": (1, 0.5), "C": (3, 0)}, fixed=["A", "C"],
        bars={name: kt.Bar(ends=tuple(ends), mass=0) for name, ends in {"a": "AM", "c": "MC", **more}.items()},
        drives={f"d{name}": kt.LengthDrive(name) for name in ("a", "c", *more)},
        loads={"F": kt.NodalForce(node="M", force=(3.0, 0.0))},
    )  # fmt: skip
    return model, np.array([[(0, 0), (1, y), (3, 0)] for y in h], float)


def test_a_run_through_the_position_tells_that_instant_only():
    h = np.array([-0.5, -0.25, 0.0, 0.25, 0.5])
    model, position = passing(h)
    found = inverse_at(model, position)
    unique = h != 0
    expected = np.stack([np.hypot(1, h), -np.hypot(2, h)], axis=1)
    np.testing.assert_allclose(found.member_force.values[unique], expected[unique], rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.member_force.values[~unique], [[1.5, -1.5]], rtol=0, atol=1e-12)
    assert found.message == "Singular position at t = 2 s: the force of these members is not unique there: a, c."
    assert found.attrs["not_unique"] == []


def test_several_instants_are_told_together():
    model, position = passing([0.1, 0.0, 0.1, 0.0, 0.0, 0.1])
    assert "Singular position at t = 1 s, t = 3 s, t = 4 s: the force" in inverse_at(model, position).message


def test_a_redundant_structure_tells_what_the_position_adds():
    """Two links side by side share their force everywhere; c joins them where all are on one line."""
    model, position = passing([0.3, 0.0, 0.2], b="AM")
    found = inverse_at(model, position)
    assert "The force of these members is not unique (redundant structure): a, b." in found.message
    assert "Singular position at t = 1 s: the force of these members is not unique there: c." in found.message
    half = np.hypot(1, 0.3) / 2
    by = list(found.member.values)
    np.testing.assert_allclose(
        found.member_force.values[0][[by.index("a"), by.index("b"), by.index("c")]], [half, half, -np.hypot(2, 0.3)],
        rtol=0, atol=1e-12,
    )  # fmt: skip


@pytest.mark.parametrize("first", [0, 1])
def test_a_mechanism_tells_its_singular_instants(first):
    """A pendulum beside the links is free, so that forces follow from singular values, also where the run starts singular."""
    h = [0.0, 0.4, 0.2] if first == 0 else [0.4, 0.0, 0.2]
    model, position = passing(h)
    model = model.with_(nodes=model.nodes | {"P": (0, -1)}, bars=model.bars | {"p": kt.Bar(ends=("A", "P"), mass=0)})
    position = np.concatenate([position, np.tile([[[0.0, -1.0]]], (3, 1, 1))], axis=1)
    found = inverse_at(model, position)
    at = h.index(0.0)
    by = list(found.member.values)
    N = found.member_force.values[:, [by.index("a"), by.index("c")]]
    np.testing.assert_allclose(N[at], [1.5, -1.5], rtol=0, atol=1e-12)
    np.testing.assert_allclose(N[2], [np.hypot(1, 0.2), -np.hypot(2, 0.2)], rtol=0, atol=1e-12)
    assert f"Singular position at t = {at} s: the force of these members is not unique there: a, c." in found.message
    assert found.attrs["not_unique"] == []


def test_positions_have_no_derivatives_in_a_singular_position():
    """Beside it, x = (L_a^2 - L_c^2 + 9)/6 and y^2 = L_a^2 - x^2: dy/dL grows as 1/h."""
    model, position = passing([0.0])
    with pytest.raises(
        kt.AnalysisError, match="singular: drives and bars leave a motion free there, so that positions have no"
    ):
        kt.kinematics.jacobian(model, position[0], of="M")
    h = 1e-6
    model, position = passing([h])
    found = kt.kinematics.jacobian(model, position[0], of="M").values
    a, c = np.hypot(1, h), np.hypot(2, h)
    np.testing.assert_allclose(found, [[a / 3, -c / 3], [2 * a / (3 * h), c / (3 * h)]], rtol=1e-9)


def test_a_run_warns_and_names_the_pose():
    model = links([(0, 0, 0), (1, 0, 0), (3, 0, 0)], (3.0, 0.0)).with_(
        runs={"still": kt.Run(analysis="statics.at_poses", poses={"Flat": {}})}
    )
    run = kt.run(model, "still")
    said = "Singular position at pose 'Flat': the force of these members is not unique there: a, c."
    assert said in list(doubts(run))
    assert said not in remarks(run)
    assert [one["unique"] for one in largest_forces(run)] == [False, False]
