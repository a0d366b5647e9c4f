"""Arrays of users at the public border: accepted as they are, or refused with what was given and what is expected."""

import math
from fractions import Fraction

import hypothesis.extra.numpy as drawn
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.arrays import array_of
from kinetruss.errors import InputError

NODES = {"n_nodes": ("A", "B", "C"), "dim": 2}

FOURBAR = kt.Model(
    nodes={"A": (0, 0), "B": (0, 0.1), "C": (0.3, 0.25), "D": (0.4, 0)},
    fixed=["A", "D"],
    bars={"a": {"ends": ("A", "B"), "mass": 1.0}, "b": ("B", "C"), "c": ("C", "D")},
    drives={"crank": kt.AngleDrive("a")},
)
TIMES = [0.0, 1.0]
GOOD = np.array([[(0, 0), (0, 0.1), (0.3, 0.25), (0.4, 0)]] * 2)

# what each public function does with an array in place of one of its arguments, and the shapes that it accepts
BORDER = {
    "mobility": (lambda given: kt.kinematics.mobility(FOURBAR, given), [(4, 2)]),
    "jacobian": (lambda given: kt.kinematics.jacobian(FOURBAR, given, of="C"), [(4, 2)]),
    "platform_jacobian": (lambda given: kt.kinematics.platform_jacobian(FOURBAR, ("B", "C"), given), [(4, 2)]),
    "transfer_functions": (lambda given: kt.kinematics.transfer_functions(FOURBAR, "a.angle", given), [(4, 2)]),
    "from_arrays": (lambda given: kt.kinematics.from_arrays(FOURBAR, TIMES, GOOD, given, GOOD), [(2, 4, 2)]),
    "gimbal_pose": (lambda given: kt.kinematics.gimbal_pose(1.0, 0.9, given), "last axis of 3"),
    "workspace": (lambda given: kt.kinematics.workspace(FOURBAR, "C", ("x", given), ("y", [0.1, 0.2])), "one axis"),
    "linear": (lambda given: kt.statics.linear(FOURBAR, given), [(4, 2)]),
    "equilibrium": (lambda given: kt.statics.equilibrium(FOURBAR, given), [(4, 2)]),
    "at_poses": (lambda given: kt.statics.at_poses(FOURBAR, given), "rows of 1, or of (4, 2)"),
    "linearise": (lambda given: kt.dynamics.linearise(FOURBAR, given), [(4, 2)]),
    "reduced_equations": (lambda given: kt.dynamics.reduced_equations(FOURBAR, "a.angle", position=given), [(4, 2)]),
}


def accepted(name, shape):
    """Whether a shape is one that the function takes."""
    if name == "gimbal_pose":
        return len(shape) > 0 and shape[-1] == 3
    if name == "workspace":
        return len(shape) == 1
    if name == "at_poses":
        return shape[1:] in ((1,), (4, 2))
    return shape in BORDER[name][1]


def test_arrays_keep_their_numbers_and_float64_is_not_copied():
    own = np.zeros((3, 2))
    assert array_of(own, "position", NODES) is own
    for like in ([[0, 1], [2, 3], [4, 5]], np.arange(6, dtype=np.int16).reshape(3, 2), [[Fraction(0), 1], [2, 3], [4, 5]]):
        np.testing.assert_array_equal(array_of(like, "position", NODES), [[0, 1], [2, 3], [4, 5]])
    assert array_of(2, "w", {}, {"w": None}).shape == ()
    assert array_of(np.zeros((5, 1, 3)), "lengths", {"...": None, "lengths": 3}).shape == (5, 1, 3)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (np.zeros((2, 3)), r"position: shape \(2, 3\), expected \(n_nodes = 3, dim = 2\), m\.$"),
        (np.zeros(6), r"position: shape \(6,\), expected"),
        ([[0, 1], [2]], r"position: \[\[0, 1\], \[2\]\], expected \(n_nodes = 3, dim = 2\), m\.$"),
        ("1 m", r"position: '1 m', expected"),
        ([["0", "1"]] * 3, "position: .*expected"),
        (np.zeros((3, 2), complex), "position: .*expected"),
        (np.zeros((3, 2), bool), "position: .*expected"),
        ([[10**400, 0]] * 3, "position: .*expected"),
        ([[0, 1], [math.nan, 3], [4, 5]], r"position\['B', 0\]: nan, expected finite numbers \(m\)\.$"),
        ([[0, 1], [2, 3], [4, 1e40]], r"position\['C', 1\]: 1e\+40, expected numbers of at most 1e\+30 \(m\)\.$"),
        (np.full((3, 2), np.inf), r"position\['A', 0\]: inf, expected finite"),
    ],
)
def test_refusals_say_what_where_got_expected(value, message):
    with pytest.raises(InputError, match=message):
        array_of(value, "position", NODES, unit="m")


def test_alternative_shapes_are_all_named():
    with pytest.raises(
        InputError, match=r"cost: shape \(4,\), expected one number or \(weights = 2,\) or \(poses, dim = 3\)\.$"
    ):
        array_of(np.zeros(4), "cost", {}, {"weights": 2}, {"poses": None, "dim": 3})
    with pytest.raises(InputError, match=r"lengths: shape \(3, 4\), expected \(\.\.\., lengths = 3\)\.$"):
        array_of(np.zeros((3, 4)), "lengths", {"...": None, "lengths": 3})
    with pytest.raises(InputError, match=r"lengths\[1, 0, 2\]: nan"):
        array_of([[[1, 1, 1]], [[1, 1, math.nan]]], "lengths", {"...": None, "lengths": 3})


ANYTHING = st.one_of(
    drawn.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5).flatmap(
        lambda shape: st.sampled_from([np.zeros(shape, kind) for kind in (float, "f4", "i4", complex, bool, "U3", "M8[s]")])
    ),
    st.recursive(st.one_of(st.floats(), st.integers(), st.text(max_size=3), st.none()), st.lists, max_leaves=8),
)


@given(ANYTHING)
@settings(deadline=None)
def test_whatever_is_given_is_an_array_of_that_shape_or_an_input_error(value):
    try:
        found = array_of(value, "position", NODES, {}, {"...": None, "turns": 3})
    except InputError as error:
        assert str(error).startswith("position")
        return
    assert found.dtype == np.float64
    assert found.shape in ((3, 2), ()) or found.shape[-1] == 3
    assert np.isfinite(found).all()


@pytest.mark.parametrize("name", BORDER)
@given(shape=drawn.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5))
@settings(deadline=None, max_examples=25)
def test_a_wrong_shape_is_an_input_error_of_every_public_function(name, shape):
    if accepted(name, shape):
        return
    with pytest.raises(InputError, match="shape|No pose|expected|increasing|not a state"):
        BORDER[name][0](np.zeros(shape))


@pytest.mark.parametrize("name", BORDER)
@pytest.mark.parametrize("value", ["1 m", [[0, 1], [2]], [["0", "1"]] * 4, np.zeros((4, 2), complex), {"A": (0, 0)}, object()])
def test_what_is_no_array_of_numbers_is_an_input_error_of_every_public_function(name, value):
    with pytest.raises(InputError):
        BORDER[name][0](value)
