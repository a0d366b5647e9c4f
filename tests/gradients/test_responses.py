"""Responses: what a text reads, its derivatives, what is equally large, and texts that are refused."""

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.gradients.responses import read_response

TIME = np.array([0.0, 0.1, 0.3, 0.6, 1.0])


def result(force=None, place=None):
    """A result with forces (time, member) and positions (time, node, axis)."""
    rng = np.random.default_rng(3)
    force = rng.normal(size=(5, 3)) if force is None else force
    place = rng.normal(size=(5, 2, 2)) if place is None else place
    return xr.Dataset(
        {
            "force": (("time", "member"), force, {"units": "N"}),
            "position": (("time", "node", "axis"), place, {"units": "m"}),
            "mass": ((), np.array(2.0), {"units": "kg"}),
        },
        coords={"time": TIME, "member": ["M1", "M2.base", "M3"], "node": ["A", "B"], "axis": ["x", "y"]},
    )


TEXTS = [
    "max(abs(force))/kN",
    "min(force[M1])",
    "sum(force)/mass",
    "mean(force[M3])",
    "rms(force)",
    "pnorm(force/N, 6)",
    "ks(force/N, 3)",
    "final(size(position[B]))/mm",
    "at(force[M1], 0.45*s) - first(force['M2.base'])",
    "max(size(position))**2",
    "sqrt(rms(position[A, x])*max(position)) + 3*mm",
    "max(max(force), -1*N)",
    "sum(force*position[A, x])",
    "-rms(force[M1]/position[B, y])",
]


@pytest.mark.parametrize("text", TEXTS)
@settings(max_examples=10)
@given(seed=st.integers(0, 2**31))
def test_derivatives_are_those_of_differences(text, seed):
    rng = np.random.default_rng(seed)
    # entries of all different sizes, none near 0: no kink and no tie
    force, place = (rng.permutation(np.linspace(0.5, 2.0, n)) * rng.choice([-1, 1], n) for n in (15, 20))
    force, place = force.reshape(5, 3), place.reshape(5, 2, 2)
    toward = {"force": rng.normal(size=force.shape), "position": rng.normal(size=place.shape), "mass": np.array(0.3)}

    def at(h):
        data = result(force + h * toward["force"], place + h * toward["position"])
        return read_response(text, data.assign(mass=data.mass.copy(data=2.0 + h * 0.3)))

    h = 1e-4
    slope = (8 * (at(h).value - at(-h).value) - (at(2 * h).value - at(-2 * h).value)) / (12 * h)
    found = sum(float((seed * toward[name]).sum()) for name, seed in at(0.0).seeds.items())
    assert found == pytest.approx(slope, rel=1e-6, abs=1e-8 * max(1.0, abs(at(0.0).value)))


def test_values_by_hand():
    data = result(np.array([[1.0, -7.0, 2.0], [2, 3, 1], [3, 0, 1], [4, 1, 1], [5, 2, -6]]))
    assert read_response("max(abs(force))", data).value == 7
    assert read_response("force[M1]*0.5", data.isel(time=0)).value == 0.5
    assert read_response("at(force[M1], 0.2)", data).value == 2.5
    assert read_response("final(force[M3])", data).value == -6
    # trapezoidal over uneven instants
    assert read_response("mean(force[M1])", data).value == pytest.approx(np.trapezoid([1, 2, 3, 4, 5], TIME))
    assert read_response("mass", data).value == 2


@pytest.mark.parametrize(
    ("text", "unit"),
    [("max(force[M1])", "N"), ("max(force)*max(position)", "J"), ("final(position[A, x])/mm", ""), ("max(force)/kN", "")],
)
def test_units(text, unit):
    data = result()
    found = read_response(text, data).unit
    assert found == unit or kt.units.dimension_of(found) == kt.units.dimension_of(unit)


def test_equal_values_are_named():
    force = np.zeros((5, 3))
    force[2, 0] = force[4, 2] = 4.0
    assert read_response("max(force)", result(force)).ties == ("max(force) has 0.3 s M1, 1 s M3",)
    force[3, 0], force[4, 2] = 4.0, 0.0  # neighbours in time of one member are one peak
    assert read_response("max(force)", result(force)).ties == ()
    assert read_response("pnorm(force/N, 8)", result(force)).ties == ()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("forc[M1]", "Did you mean 'force'"),
        ("force[M9]", "no time or member called 'M9'"),
        ("force[M1]", "one for each time"),
        ("force", "Name an entry in brackets"),
        ("max(force) + 1", "puts together what is in N and what is in plain"),
        ("maximum(force)", "no function 'maximum'"),
        ("pnorm(force)", "takes an expression and one number"),
        ("at(force[M1], 2*s)", "from 0 s to 1 s"),
        ("final(mass)", "has no instants"),
        ("__import__('os')", "no function '__import__'"),
        ("force.values", "may not stand here"),
        ("max(force", "no response"),
        ("1" * 1001, "1001 characters"),
        ("-" * 200 + "mass", "operations in each other"),
    ],
)
def test_refused(text, said):
    with pytest.raises(kt.InputError, match=said.replace("(", r"\(").replace("'", "['\"]?")):
        read_response(text, result())
