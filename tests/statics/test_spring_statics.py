"""Springs on hinges at rest: columns that buckle, arms that bend, chains that tend to elastic beams."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipk, ellipkinc

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_forces, named_motions
from spring_models import STIFFNESS, hencky, pendulum, two_links

SOLID = {"section": kt.Rectangle(width=0.03, height=0.02), "material": kt.library.materials.STEEL_S235}


def column(k=100.0, L=2.0, **law):
    """A rigid column on a rotational spring at its foot, pressed from above."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, L), "G": (1, 0)}, fixed=["A", "G"], bars={"a": ("A", "B")},
        springs={"s": kt.Spring(coordinate=kt.HingeDrive(axis="A", start="G", end="B"), stiffness=k, **law)},
        loads={"P": kt.NodalForce(node="B", force=(0, -1.0))},
    )  # fmt: skip


def test_column_on_a_rotational_spring_buckles_at_k_over_length():
    assert kt.statics.buckling(column(), "P").load_factor.values == pytest.approx([50.0], rel=1e-12)


@pytest.mark.parametrize("count", [2, 3, 7])
def test_chain_of_links_buckles_as_henckys(count):
    """P_j = 4 k/h sin^2(j pi/(2 n)) (H. Hencky, 1920); two links: 2 k/h."""
    k, h = 12.0, 1.0 / count
    wanted = 4 * k / h * np.sin(np.arange(1, count) * np.pi / (2 * count)) ** 2
    assert kt.statics.buckling(hencky(count, k), "P").load_factor.values == pytest.approx(wanted[:6], rel=1e-9)


@pytest.mark.slow
def test_post_buckled_path_of_the_column():
    """P = k (phi - phi_0)/(L sin(phi)) from the vertical, with an imperfection phi_0."""
    k, L, off = 100.0, 2.0, 0.02
    model = column(k, L, rest=np.pi / 2 - off).with_(loads={"P": kt.NodalForce(node="B", force=(0, -50.0))})
    found = kt.statics.path(model, "P", points=60)
    x = found.position.sel(node="B").values
    phi = np.arctan2(x[:, 0], x[:, 1])
    assert phi[0] == pytest.approx(off, abs=1e-9)
    assert phi.max() > 1.0
    some = phi > 1.5 * off
    assert 50 * found.load_factor.values[some] == pytest.approx((k * (phi - off) / (L * np.sin(phi)))[some], rel=1e-7)
    assert found.spring_force.values[some, 0] == pytest.approx(k * (phi - off)[some], rel=1e-7)


def test_a_wound_spring_alone_finds_its_rest():
    found = kt.statics.equilibrium(pendulum(1.0, gravity=0.0, rest=0.25))
    x = found.position.sel(node="P").values
    assert np.arctan2(x[1], x[0]) == pytest.approx(0.25, abs=1e-9)
    assert found.spring_force.values == pytest.approx([0.0], abs=1e-7)


def test_two_springs_that_pull_against_each_other():
    model = pendulum(0.3, rest=-0.5)
    other = kt.Spring(coordinate=model.springs["hinge"].coordinate, stiffness=60.0, rest=1.0)
    found = kt.statics.equilibrium(model.with_(springs=model.springs | {"other": other}))
    assert found.spring_value.values == pytest.approx([0.5, 0.5], abs=1e-9)
    assert found.spring_force.values == pytest.approx([-30.0, 30.0], abs=1e-7)


def test_equilibrium_of_an_arm_under_weight():
    g = 9.81
    model = pendulum(0.4, stiffness=10.0, rest=1.2, gravity=g)
    found = kt.statics.equilibrium(model)
    theta = brentq(lambda q: 10.0 * (q - 1.2) + 2.0 * g * 1.5 * np.sin(q), 0, 1.2, xtol=1e-14)
    x = found.position.sel(node="P").values
    assert np.arctan2(x[1], x[0]) == pytest.approx(theta, abs=1e-9)
    assert found.spring_value.values == pytest.approx([theta], abs=1e-9)
    assert found.spring_force.values == pytest.approx([-10.0 * (theta - 1.2)], abs=1e-8)
    assert found.member_force.values == pytest.approx([2.0 * g * np.cos(theta)], abs=1e-8)


def test_within_the_play_nothing_holds():
    with pytest.raises(kt.InputError, match="mechanism"):
        kt.statics.linear(pendulum(0.05, play=0.1).with_(**SOLID))


def test_small_displacements_are_the_limit_of_large_ones():
    """Linear statics against the nonlinear equilibrium under a small load; energy is work."""
    model = pendulum(0.6, rest=0.6).with_(gravity=None, loads={"P": kt.NodalForce(node="P", force=(0.0, -1e-3))}, **SOLID)
    small = kt.statics.linear(model)
    moved = kt.statics.equilibrium(model).position.values - np.array([node.at for node in model.nodes.values()])
    assert small.displacement.values == pytest.approx(moved, abs=1e-8)
    assert small.spring_force.values == pytest.approx([1e-3 * 1.5 * np.cos(0.6)], rel=1e-12)
    assert small.energy.item() == pytest.approx(small.work.item(), rel=1e-12)


def test_prestress_of_a_spring_moves_the_structure_under_linear_statics():
    model = pendulum(0.6, rest=0.5).with_(gravity=None, **SOLID)
    small = kt.statics.linear(model)
    d = small.displacement.sel(node="P").values
    assert d == pytest.approx(-0.1 * 1.5 * np.array([-np.sin(0.6), np.cos(0.6)]), abs=1e-7)


def test_deflection_along_a_motion_counts_the_springs():
    hinge = kt.HingeDrive(axis="A", start="O", end="B")
    model = kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "A": (1, 0.1), "B": kt.Node(at=(2, 0.3), mass=1.0)}, fixed=["O", "G"],
        gravity=(0, -9.81), bars={"a": ("O", "A"), "b": ("A", "B")},
        drives={"root": kt.HingeDrive(axis="O", start="G", end="A")},
        springs={"soft": kt.Spring(coordinate=hinge, stiffness=1e4)}, **SOLID,
    )  # fmt: skip
    forces = kt.statics.at_poses(model.with_(drives=model.drives | {"stiff": hinge}), [{}])
    found = kt.statics.deflection(model, kt.statics.at_poses(model, np.array([[node.at for node in model.nodes.values()]])))
    linear = kt.statics.linear(model)
    assert found.displacement.values[0] == pytest.approx(linear.displacement.values, abs=1e-12)
    assert np.abs(found.work_balance.values).max() < 1e-9 * found.work.values.max()
    assert linear.spring_force.values == pytest.approx([forces.drive_force.sel(drive="stiff").item()], rel=1e-9)


def test_energy_and_force_agree_at_rest():
    """The work of the forces of springs along a small displacement is minus the change of their energy."""
    system = compile(two_links())
    rng = np.random.default_rng(3)
    step = np.zeros((4, 3))
    step[2:, :2] = 1e-6 * rng.standard_normal((2, 2))
    x = system.x0 + 1e5 * step
    force = element_forces(system, x)
    energy = named_motions(system, np.stack([x - step, x + step])).energy.sum(axis=1)
    assert energy[1] - energy[0] == pytest.approx(-2 * force @ step.reshape(-1), rel=1e-7)


def cantilever(count, load, stiffness=1.0):
    """Links of equal length with springs EI/h between them and 2 EI/h at the clamped end: an elastic line of length 1."""
    h = 1.0 / count
    nodes = {f"N{k}": (k * h, 0.0) for k in range(count + 1)} | {"W": (-h, 0.0)}
    springs = {"s0": kt.Spring(coordinate=kt.HingeDrive(axis="N0", start="W", end="N1"), stiffness=2 * stiffness / h)}
    springs |= {
        f"s{k}": kt.Spring(coordinate=kt.HingeDrive(axis=f"N{k}", start=f"N{k - 1}", end=f"N{k + 1}"), stiffness=stiffness / h)
        for k in range(1, count)
    }
    return kt.Model(
        nodes=nodes, fixed=["N0", "W"], bars={f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(count)}, springs=springs,
        loads={"tip": kt.NodalForce(node=f"N{count}", force=(0.0, load))},
    )  # fmt: skip


def elastica_slope(load):
    """Tip slope of a clamped elastic line of length 1 and stiffness 1 under a dead load across it (Frisch-Fay 1962, ch. 2)."""

    def length(tip):
        p = np.sqrt((1 + np.sin(tip)) / 2)
        return ellipk(p**2) - ellipkinc(np.arcsin(1 / (p * np.sqrt(2))), p**2) - np.sqrt(load)

    return brentq(length, 1e-6, np.pi / 2 - 1e-9, xtol=1e-14)


def test_a_chain_of_links_tends_to_the_elastica():
    """The error of the slope at the tip falls with the square of the number of links."""
    wanted, error = elastica_slope(2.0), []
    for count in (8, 16):
        x = kt.statics.equilibrium(cantilever(count, 2.0)).position
        d = (x.sel(node=f"N{count}") - x.sel(node=f"N{count - 1}")).values
        # the slope at the tip: that of the last link, to second order as there is no moment there
        error.append(abs(np.arctan2(d[1], d[0]) - wanted))
    assert error[0] < 5e-3
    assert error[0] / error[1] == pytest.approx(4.0, rel=0.15)


def test_stiffness_k_of_a_spring_alone():
    found = kt.statics.equilibrium(pendulum(0.0))
    assert found.stiffness.values == pytest.approx([STIFFNESS / 1.5**2], rel=1e-9)


def test_stiffness_of_a_platform_refuses_springs():
    driven = pendulum().with_(drives={"d": kt.AngleDrive("arm")})
    with pytest.raises(kt.InputError, match="not the spring 'hinge'"):
        kt.statics.platform_stiffness(driven, ["O", "P"], 1e3)
