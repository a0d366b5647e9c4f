"""Geometric transfer functions: closed forms, differences of assembled configurations, inverse relations, refusals."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import InputError


def fourbar(**fields):
    shared = {"nodes": {"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)}, "fixed": ("A", "D"),
              "bars": {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
              "drives": {"motor": kt.AngleDrive("crank")}}  # fmt: skip
    return kt.Model(**shared | fields)


def crossed(system_of, values, step):
    """First and second central differences of positions by several values."""
    k = len(values)
    E = np.eye(k) * step
    at = np.asarray(values)
    first = np.stack([(system_of(at + E[i]) - system_of(at - E[i])) / (2 * step) for i in range(k)], axis=-1)
    second = np.stack(
        [
            np.stack(
                [
                    system_of(at + E[i] + E[j])
                    - system_of(at + E[i] - E[j])
                    - system_of(at - E[i] + E[j])
                    + system_of(at - E[i] - E[j])
                    for j in range(k)
                ],
                axis=-1,
            )
            / (4 * step**2)
            for i in range(k)
        ],
        axis=-2,
    )
    return first, second


def test_turning_bar_in_closed_form():
    angle, size = 0.7, 1.7
    model = kt.Model(nodes={"A": (0, 0), "B": (size * np.cos(angle), size * np.sin(angle))}, fixed=["A"],
                     bars={"b": ("A", "B")})  # fmt: skip
    found = kt.kinematics.transfer_functions(model, "b.angle")
    np.testing.assert_allclose(
        found.first.sel(node="B").values[:, 0], [-size * np.sin(angle), size * np.cos(angle)], rtol=1e-14
    )
    expected = [-size * np.cos(angle), -size * np.sin(angle)]
    np.testing.assert_allclose(found.second.sel(node="B").values[:, 0, 0], expected, rtol=1e-14)
    # by a coordinate instead: y = sqrt(L^2 - x^2)
    x, y = model.nodes["B"].at
    found = kt.kinematics.transfer_functions(model, "B.x")
    np.testing.assert_allclose(found.first.sel(node="B").values[:, 0], [1, -x / y], rtol=1e-14)
    np.testing.assert_allclose(found.second.sel(node="B").values[:, 0, 0], [0, -(size**2) / y**3], rtol=1e-13)


def test_mixed_freedoms_in_the_plane_in_closed_form():
    """One node on two bars, one of them elastic: by its length and the other's angle, as polar coordinates."""
    model = kt.Model(nodes={"A": (0, 0), "B": (1.2, 0.9)}, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), kind="driven")},
                     drives={"turn": kt.AngleDrive("b")})  # fmt: skip
    found = kt.kinematics.transfer_functions(model, ["b", "b.angle"])
    u, n = np.array([0.8, 0.6]), np.array([-0.6, 0.8])
    np.testing.assert_allclose(found.first.sel(node="B"), np.stack([u, 1.5 * n], axis=1), atol=1e-15)
    second = found.second.sel(node="B").values
    np.testing.assert_allclose(second[:, 0, 0], 0, atol=1e-15)
    np.testing.assert_allclose(second[:, 0, 1], n, atol=1e-15)
    np.testing.assert_allclose(second[:, 1, 0], n, atol=1e-15)
    np.testing.assert_allclose(second[:, 1, 1], -1.5 * u, atol=1e-15)
    assert found.dof_unit.values.tolist() == ["m", "rad"]
    np.testing.assert_allclose(found.length_first.values, [[1, 0]], atol=1e-15)
    np.testing.assert_allclose(found.length_second.values, 0, atol=1e-15)


def test_a_motion_is_its_transfer_functions_times_its_rates():
    model = fourbar()
    motion = kt.kinematics.follow(model, kt.Sine(amplitudes={"motor": 0.3}, period=0.7, duration=0.7), samples=9)
    for i in range(9):
        found = kt.kinematics.transfer_functions(model, "motor", motion.position.values[i])
        rate, second = (motion.data[name].values[i, 0] for name in ("drive_velocity", "drive_acceleration"))
        v = found.first.values[..., 0] * rate
        a = found.first.values[..., 0] * second + found.second.values[..., 0, 0] * rate**2
        np.testing.assert_allclose(v, motion.velocity.values[i], atol=1e-12)
        np.testing.assert_allclose(a, motion.acceleration.values[i], atol=1e-10)


@pytest.mark.slow
@settings(max_examples=4, deadline=None)
@given(st.lists(st.floats(-0.08, 0.08), min_size=3, max_size=3))
def test_lengths_of_a_bay_against_differences(change):
    model = kt.library.vgt.double_octahedral()
    drives = list(model.all_drives)
    values = np.array([1.1684 + shift for shift in change])

    def positions(lengths):
        return kt.kinematics.assemble(model, dict(zip(drives, lengths, strict=True)))

    found = kt.kinematics.transfer_functions(model, drives, positions(values))
    first, second = crossed(positions, values, 2e-4)
    np.testing.assert_allclose(found.first, first, atol=3e-6 * np.abs(first).max())
    np.testing.assert_allclose(found.second, second, atol=3e-6 * np.abs(second).max())


def test_other_freedoms_are_the_inverse_function():
    """q(p(q)) = q: the chain rule joins the transfer functions by lengths and by node coordinates."""
    model = kt.library.vgt.double_octahedral(beta=0.1, gamma=-0.05)
    drives, nodes = ["M7", "M9", "M11"], ["N8.x", "N8.y", "N8.z"]
    one, two = (kt.kinematics.transfer_functions(model, names, free=drives) for names in (drives, nodes))
    J = one.first.sel(node="N8").values
    H = one.second.sel(node="N8").values
    L, S = two.length_first.sel(member=drives).values, two.length_second.sel(member=drives).values
    np.testing.assert_allclose(J @ L, np.eye(3), atol=1e-12)
    both = np.einsum("aij,ip,jq->apq", H, L, L) + np.einsum("ai,ipq->apq", J, S)
    np.testing.assert_allclose(both, 0, atol=1e-10 * np.abs(H).max())
    np.testing.assert_allclose(two.second, two.second.values.swapaxes(2, 3), atol=1e-12 * np.abs(two.second.values).max())


def test_first_order_is_the_jacobian():
    model = kt.library.vgt.double_octahedral(2, beta=0.05)
    found = kt.kinematics.transfer_functions(model, list(model.all_drives))
    by = kt.kinematics.jacobian(model, of=list(model.nodes)).values
    np.testing.assert_allclose(found.first.values.reshape(-1, 6), by, atol=1e-12)


def test_chosen_freedoms_and_redundant_bars():
    model = kt.library.vgt.double_octahedral()
    found = kt.kinematics.transfer_functions(model, free=["M7", "M9"])
    assert found.sizes["dof"] == 2
    twice = model.with_(bars=model.bars | {"again": ("N1", "N4")})
    assert np.isfinite(kt.kinematics.transfer_functions(twice, ["M7"]).first.values).all()
    np.testing.assert_allclose(
        kt.kinematics.transfer_functions(twice, ["M7"]).first, kt.kinematics.transfer_functions(model, ["M7"]).first, atol=1e-12
    )


def test_refusals():
    model = fourbar()
    for names, text in (
        ("crank", "'crank' is a rigid bar"), ("A.x", "'A.x' is held by a support"), ("Q.x", "No coordinate called 'Q.x'"),
        (["C.x", "motor"], "has 1 freedom here, but 2 are named"), (["C.x", "C.x"], "named twice"),
        ("coupler", "'coupler' is a rigid bar"), ("C.y", "Nothing can move"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=text):
            kt.kinematics.transfer_functions(model, names)
    with pytest.raises(InputError, match="No drive called 'rotor' to release. There are: motor"):
        kt.kinematics.transfer_functions(model, free=["rotor"])
    # crank and coupler in one line: the rocker's end cannot move the crank
    flat = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (3, 0)}, fixed={"A": "xy", "C": "y"},
                    bars={"crank": ("A", "B"), "rod": ("B", "C")})  # fmt: skip
    with pytest.raises(
        InputError, match=r"C.x does not fix the configuration: B moves along y .*while it stands still. Name others, e.g. B.y"
    ):
        kt.kinematics.transfer_functions(flat, "C.x")
    bay = kt.library.vgt.double_octahedral()
    with pytest.raises(InputError, match="'bay.beta' is a pose coordinate"):
        kt.kinematics.transfer_functions(bay, "bay.beta")
