"""Linear buckling: columns of rigid bars in closed form, prestress, agreement with paths, refusals."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError


def column(pretension=0.0, **fields):
    """Two rigid links of 1 m, held sideways by a spring (10 N/m) and a taut wire of 1 m at the middle."""
    nodes = {"A": (0, 0), "B": (0, 1), "C": (0, 2), "W": (1, 1), "E": (-1, 1)}
    spring = {"kind": "elastic", "stiffness": 5.0, "pretension": pretension}
    return kt.Model(**{"nodes": nodes, "fixed": {"A": "xy", "C": "x", "W": "xy", "E": "xy"},
                       "bars": {"a": ("A", "B"), "b": ("B", "C"), "s": kt.Bar(ends=("B", "W"), **spring),
                                "t": kt.Bar(ends=("E", "B"), **spring)},
                       "loads": {"P": kt.NodalForce(node="C", force=(0, -2.0))}} | fields)  # fmt: skip


def test_two_links_in_closed_form():
    """P = k l/2; the load of the model is 2 N."""
    found = kt.statics.buckling(column(), "P")
    assert found.load_factor.item() == pytest.approx(10.0 / 2 / 2, rel=1e-13)
    np.testing.assert_allclose(np.abs(found.mode_shape.sel(mode=0, node="B")), [1, 0], atol=1e-12)
    np.testing.assert_allclose(found.member_force_of_load.sel(member=["a", "b"]), -2.0)
    # pulled up it never buckles
    up = kt.statics.buckling(column(), {"P": -1.0})
    assert up.data.sizes["mode"] == 0 and up.message == "No factor of this load makes the structure unstable."


def test_own_load_counts_before():
    """A weight w on top of the column takes its share: P + w = k l/2."""
    heavy = column(loads={"P": kt.NodalForce(node="C", force=(0, -2.0)), "w": kt.NodalForce(node="C", force=(0, -1.0))})
    assert kt.statics.buckling(heavy, "P").load_factor.item() == pytest.approx((5.0 - 1.0) / 2, rel=1e-12)


def test_three_links_have_two_modes():
    """Springs k at two inner joints, links l: P = k l/3 (antisymmetric) and k l (symmetric)."""
    nodes = {f"N{i}": (0, float(i)) for i in range(4)} | {"W1": (1, 1), "W2": (1, 2)}
    bars = {f"b{i}": (f"N{i}", f"N{i + 1}") for i in range(3)}
    bars |= {f"s{i}": kt.Bar(ends=(f"N{i}", f"W{i}"), kind="elastic", stiffness=12.0) for i in (1, 2)}
    model = kt.Model(nodes=nodes, fixed={"N0": "xy", "N3": "x", "W1": "xy", "W2": "xy"}, bars=bars,
                     loads={"P": kt.NodalForce(node="N3", force=(0, -1.0))})  # fmt: skip
    found = kt.statics.buckling(model, "P")
    np.testing.assert_allclose(found.load_factor, [12.0 / 3, 12.0], rtol=1e-12)
    np.testing.assert_allclose(found.mode_shape.sel(node="N1", axis="x") / found.mode_shape.sel(node="N2", axis="x"), [-1, 1])


@pytest.mark.slow
def test_agrees_with_the_bifurcation_of_the_path():
    model = column()
    path = kt.statics.path(model, "P", to=4.0)
    assert path.bifurcations[0] == pytest.approx(kt.statics.buckling(model, "P").load_factor.item(), rel=1e-10)


def test_prestress_along_the_way_it_gives_changes_nothing_and_refusals():
    taut = kt.statics.buckling(column(pretension=3.0), "P").load_factor.item()
    assert taut == pytest.approx(10.0 / 2 / 2, rel=1e-12)  # the wires pull along the way it gives
    with pytest.raises(InputError, match="unstable, or left free, already without the load"):
        kt.statics.buckling(column(bars={"a": ("A", "B"), "b": ("B", "C")}), "P")
    with pytest.raises(InputError, match="No load called 'Q' to scale"):
        kt.statics.buckling(column(), "Q")
