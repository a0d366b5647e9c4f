"""Hinges between hubs in space and their members: motion, moments and torsion against free bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import kinetruss as kt
from kinetruss.model.members import Brace

STEEL: dict[str, Any] = {"section": kt.Rod(diameter=0.03), "material": "steel_s235"}
G = np.array((1.0, -3.0, -9.81))


def arm(kind: str = "rigid", axis: Any = (0.2, 1.0, 0.1), **changes: Any) -> kt.Model:
    """A heavy arm with a mass at its end, on a hinge at the offset arm of a hub on the ground."""
    given = {
        "nodes": {"O": (0, 0, 0), "A": kt.Node(at=(1, 0, 0.3), mass=2.0)},
        "fixed": ["O"],
        "bars": {"arm": kt.Bar(ends=("O", "A"), mass=1.5, kind=kind)},
        "gravity": tuple(G),
        "hubs": {"O": kt.Hub(arms={"arm": (0.1, 0.05, 0.02)}, hinges={"arm": axis})},
        "loads": {"f": kt.NodalForce(node="A", force=(3, 4, 5))},
    }
    return kt.Model(**given | STEEL | changes)


def square() -> tuple[float, ...]:
    """The axis of `arm` across it."""
    d = np.array((0.9, -0.05, 0.28))
    axis = np.array((0.2, 1.0, 0.1))
    return tuple((axis - (axis @ d) / (d @ d) * d).tolist())


def all_balanced(model: kt.Model, motion: Any, forces: Any, time: float, skip: tuple[str, ...] = ()) -> None:
    """Every member and node as a free body."""
    size = float(np.abs(forces.data.joint_force).max())
    for name, member in model.whole.members.items():
        if not isinstance(member, Brace) and name not in skip:
            assert kt.dynamics.free_body(model, motion, forces, member=name, time=time).residual < 1e-9 * size, name
    for name in model.whole.nodes:
        assert kt.dynamics.free_body(model, motion, forces, node=name, time=time).residual < 1e-9 * size, name


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "axis"), [("rigid", (0.2, 1.0, 0.1)), ("driven", square())])
def test_a_pendulum_on_an_offset_hinge(kind: str, axis: tuple[float, ...]) -> None:
    """It swings about the axis alone; the moment at the joint is that of its free body, and none of it is about the axis."""
    model = arm(kind, axis)
    freedoms = kt.kinematics.mobility(model)
    assert freedoms.degrees_of_freedom == (1 if kind == "rigid" else 2) and freedoms.undriven == 1
    ball = arm(kind, axis, hubs={"O": kt.Hub(arms={"arm": (0.1, 0.05, 0.02)})})
    assert kt.kinematics.mobility(ball).undriven == 2
    run = kt.dynamics.simulate(model, 0.3, samples=7)
    motion, forces, nodes = run.motion, run.forces, list(model.whole.nodes)
    x, a = (motion.data[name].values for name in ("position", "acceleration"))
    P, A = nodes.index("O.arm"), nodes.index("A")
    u = np.array(axis) / np.linalg.norm(axis)
    d = x[:, A] - x[:, P]
    assert np.allclose(d @ u, d[0] @ u, atol=1e-9) and np.ptp(d, axis=0).max() > 0.05
    assert np.abs(forces.data.energy_balance).max() < 1e-9
    # b - g of every point is linear along the arm: its moment about P is m/6 d x (b_P + 2 b_A)
    needed = np.cross(d, 2.0 * (G - a[:, A]) + (3, 4, 5)) + 1.5 / 6 * np.cross(d, 3 * G - a[:, P] - 2 * a[:, A])
    assert np.abs(needed @ u).max() < 1e-9 * np.abs(needed).max()
    sections = kt.strength.sections(model, forces)
    axes = kt.kinematics.member_rates(model, motion).member_axes
    M = sections.data.section_M.sel(station=0.0)
    exact = np.einsum("tij,tj->ti", axes.sel(member="arm").values, needed)[:, 1:]
    assert np.allclose(M.sel(part="arm"), exact, atol=1e-9 * np.abs(needed).max())
    assert np.abs(sections.data.section_M.sel(part="arm", station=1.0)).max() < 1e-9 * np.abs(needed).max()
    all_balanced(model, motion, forces, 0.15)
    back = kt.dynamics.inverse(model, motion)
    assert np.allclose(back.data.member_force, forces.data.member_force, atol=1e-8)


def test_torsion_of_an_arm_and_its_root() -> None:
    """At rest, about a vertical axis: the weight W at l bends the member by W l at the joint, and twists an arm across it."""
    hub = kt.Hub(arms={"arm": (0, 0.1, 0)}, hinges={"arm": "z"})
    model = kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(1, 0.1, 0), mass=2.0)}, fixed=["O"], hubs={"O": hub},
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        drives={"turn": kt.HingeDrive(axis=("O.arm", "O.arm.axis1"), start="O", end="A")},
        **STEEL | {"material": kt.Material(E=2e11, density=0.0, yield_strength=2.35e8)}, gravity=(0, 0, -10.0),
    )  # fmt: skip
    forces = kt.statics.at_poses(model, [{}])
    sections = kt.strength.sections(model, forces).data
    assert np.abs(sections.section_M.sel(part="arm", station=0.0)).max() == pytest.approx(20.0, rel=1e-12)
    assert np.abs(sections.torsion.sel(part="O.arm")).values == pytest.approx(20.0, rel=1e-12)
    assert np.abs(sections.torsion.sel(part="arm")).max() == 0
    assert np.abs(sections.section_M.sel(part="O.arm", station=0.0)).max() == pytest.approx(2.0, rel=1e-12)
    verdict = kt.strength.check(model, forces)
    bending, torsion = (32 * 2.0 / (np.pi * 0.03**3)), 16 * 20.0 / (np.pi * 0.03**3)
    least = np.sqrt(bending**2 + 3 * torsion**2)
    found = float(verdict.data["value"].sel(part="O.arm", rule="yield"))
    shear = 4 / 3 * 20.0 / (np.pi / 4 * 0.03**2)
    assert least <= found <= np.sqrt(bending**2 + 3 * (torsion + shear) ** 2)


def crank_and_rocker() -> kt.Model:
    """A spatial four-bar: crank and rocker on hinges of skew axes at offset hubs, a coupler between ball joints."""
    return kt.Model(
        nodes={"O": (0, 0, 0), "A": (0.25, 0, 0.05), "B": (0.6, 0.5, 0.5), "Q": (0.6, 0.45, 0.1)}, fixed=["O", "Q"],
        bars={"crank": ("O", "A"), "coupler": ("A", "B"), "rocker": ("B", "Q")},
        hubs={
            "O": kt.Hub(arms={"crank": (0, 0, 0.05)}, hinges={"crank": "z"}),
            "Q": kt.Hub(arms={"rocker": (0.04, 0, 0)}, hinges={"rocker": "x"}),
        },
        drives={"motor": kt.AngleDrive("crank", axis="z")},
        gravity=(0, 0, -9.81), **STEEL,
    )  # fmt: skip


def test_a_spatial_four_bar_linkage() -> None:
    """The rocker's angle is that of the distance condition |A B| = l; forces by virtual work; all free bodies."""
    model = crank_and_rocker()
    assert kt.kinematics.mobility(model).degrees_of_freedom == 1
    balls = model.with_(hubs={name: hub.with_(hinges={}) for name, hub in model.hubs.items()})
    assert kt.kinematics.mobility(balls).degrees_of_freedom == 3
    assert not any(".axis" in node or ".hinges" in node for node in balls.whole.nodes)
    start = float(np.arctan2(0, 0.25))
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": (start, start + 0.8)}, duration=0.5), samples=11)
    nodes, x = list(model.nodes), motion.data.position.values
    A, B = x[:, nodes.index("A")], x[:, nodes.index("B")]
    length = np.linalg.norm(B[0] - A[0])
    foot = np.array((0.64, 0.45, 0.1))
    radius, first = np.hypot(*(B[0] - foot)[1:]), np.arctan2(*(B[0] - foot)[:0:-1])

    def place(angle: float) -> Any:
        return np.array((B[0, 0], foot[1] + radius * np.cos(angle), foot[2] + radius * np.sin(angle)))

    for k in (3, 7, 10):
        turn = 0.8 * (10 * (k / 10) ** 3 - 15 * (k / 10) ** 4 + 6 * (k / 10) ** 5)
        tip = np.array((0.25 * np.cos(turn), 0.25 * np.sin(turn), 0.05))
        assert np.allclose(A[k], tip, atol=1e-9)
        angle = brentq(lambda one, tip=tip: np.linalg.norm(place(one) - tip) - length, first - 0.5, first + 0.5, xtol=1e-14)
        assert np.allclose(B[k], place(angle), atol=1e-8)
    forces = kt.dynamics.inverse(model, motion)
    assert forces.status.ok and np.abs(forces.data.energy_balance).max() < 1e-9 * np.abs(forces.data.power).max()
    all_balanced(model, motion, forces, 0.3)
    assert "Not included" not in kt.strength.check(model, forces).message


def test_a_member_between_two_hinges_is_twisted() -> None:
    """A rigid member between hinges of two hubs: what the second hub exerts about the member is its torsion."""
    model = kt.Model(
        nodes={"O": (0, 0, 0), "K": kt.Node(at=(1, 0, 0)), "T": kt.Node(at=(1.2, 0.5, 0.1), mass=3.0)},
        fixed=["O"], bars={"link": ("O", "K"), "tail": ("K", "T")}, gravity=(0, 0, -9.81), **STEEL,
        hubs={
            "O": kt.Hub(arms={"link": (0.1, 0.0, 0.0)}, hinges={"link": "z"}),
            "K": kt.Hub(arms={"link": (-0.05, 0, 0.0)}, hinges={"link": "y"}, clamped=["tail"]),
        },
    )  # fmt: skip
    assert kt.kinematics.mobility(model).degrees_of_freedom == 2
    run = kt.dynamics.simulate(model, 0.2, samples=5)
    forces, motion = run.forces, run.motion
    all_balanced(model, motion, forces, 0.1)
    data = kt.strength.sections(model, forces).data
    x, a, nodes = motion.data.position.values, motion.data.acceleration.values, list(model.whole.nodes)
    # all that hangs at the joint at K but the moment about the member, by its free body: tail, hub, mass
    P, K, T = (nodes.index(name) for name in ("K.link", "K", "T"))
    g = np.array((0, 0, -9.81))
    moment = np.cross(x[:, T] - x[:, P], 3.0 * (g - a[:, T]))
    per = float(np.pi / 4 * 0.03**2 * 7850.0)
    for one, two in ((K, P), (K, T)):
        m = per * np.linalg.norm(x[:, two] - x[:, one], axis=1)[:, None]
        for s, w in zip((0.0, 0.5, 1.0), (1 / 6, 4 / 6, 1 / 6), strict=True):
            at = (1 - s) * x[:, one] + s * x[:, two] - x[:, P]
            moment += np.cross(at, w * m * (g - (1 - s) * a[:, one] - s * a[:, two]))
    along = x[:, P] - x[:, nodes.index("O.link")]
    along /= np.linalg.norm(along, axis=1)[:, None]
    torsion = data.torsion.sel(part="link").values
    assert np.allclose(torsion, np.einsum("tc,tc->t", moment, along)[:, None], rtol=1e-9)
    assert np.abs(run.forces.data.energy_balance).max() < 1e-9


def test_clamped_at_one_hub_and_hinged_at_the_other() -> None:
    """A spatial crank: hinged to the ground, clamped to a hub that hinges a second link; moments hold every body."""
    model = kt.Model(
        nodes={"O": (0, 0, 0), "K": (0.5, 0, 0), "T": kt.Node(at=(0.8, 0.4, 0.2), mass=1.0)}, fixed=["O"],
        bars={"crank": ("O", "K"), "link": ("K", "T")}, gravity=(0, 0, -9.81), **STEEL,
        hubs={
            "O": kt.Hub(arms={"crank": (0, 0, 0.06)}, hinges={"crank": (0, 0.2, 1)}),
            "K": kt.Hub(arms={"link": (0.03, 0.04, 0)}, hinges={"link": (0, 0, 1)}, clamped=["crank"]),
        },
    )  # fmt: skip
    assert kt.kinematics.mobility(model).degrees_of_freedom == 2
    run = kt.dynamics.simulate(model, 0.2, samples=5)
    all_balanced(model, run.motion, run.forces, 0.1)
    assert np.abs(run.forces.data.energy_balance).max() < 1e-9
    assert "Not included" not in kt.strength.check(model, run.forces).message


def test_an_overconstrained_linkage_says_so() -> None:
    """Parallel hinges all round: it moves with one freedom, one member force of each loop is not unique."""
    corners = {"A": (0, 0, 0), "B": (0.05, 0.15, 0), "C": (0.75, 0.45, 0), "D": (0.9, 0, 0)}
    model = kt.Model(
        nodes=corners, fixed=["A", "D"], bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}, **STEEL,
        hubs={
            "A": kt.Hub(arms={"crank": (0, 0, 0.02)}, hinges={"crank": "z"}),
            "B": kt.Hub(arms={"coupler": (0, 0, 0.03)}, hinges={"coupler": "z"}, clamped=["crank"]),
            "C": kt.Hub(arms={"coupler": (0, 0, 0.03)}, hinges={"coupler": "z"}, clamped=["rocker"]),
            "D": kt.Hub(arms={"rocker": (0, 0, 0.02)}, hinges={"rocker": "z"}),
        },
    )  # fmt: skip
    found = kt.kinematics.mobility(model)
    # four hinges of one loop in space: 6 (4 - 4 - 1) + 4 = -2 by count, 1 by rank: three dependent conditions
    assert (found.degrees_of_freedom, found.self_stress) == (1, 3)


@pytest.mark.parametrize(
    ("hub", "bar", "said"),
    [
        ({"arms": {"arm": 0.1}, "hinges": {"arm": "x"}}, {}, "axis along the member"),
        ({"clamped": ["arm"], "hinges": {"arm": "y"}, "turns": True}, {}, "clamped and has a hinge"),
        ({"arms": {"arm": 0.1}, "hinges": {"arm": (0.3, 1, 0)}}, {"kind": "driven"}, "not square to the member"),
        ({"arms": {"arm": 0.1}, "hinges": {"arm": "y"}}, {"kind": "cable", "stiffness": 1e4}, "bears no moment"),
        ({"reach": 0.1, "hinges": {"rod": "y"}}, {}, "no member called 'rod'"),
        ({"reach": 0.1, "hinges": {"arm": (0, 0, 0)}}, {}, "no axis in space"),
    ],
)
def test_faults(hub: dict[str, Any], bar: dict[str, Any], said: str) -> None:
    """What is wrong, and what to do."""
    with pytest.raises((kt.ModelError, ValueError), match=said):
        kt.Model(
            nodes={"O": (0, 0, 0), "A": (1, 0, 0)},
            fixed=["O"],
            bars={"arm": {"ends": ("O", "A"), **bar}},
            hubs={"O": kt.Hub(**hub)},
        )


def test_hinges_come_and_go(tmp_path: Any) -> None:
    """Written, read, changed and taken away; axes follow their hub."""
    model = arm()
    kt.write(model, tmp_path / "arm.yaml")
    assert kt.read(tmp_path / "arm.yaml") == model
    assert model.with_(title="same").whole.nodes == model.whole.nodes
    driven = model.with_(bars=model.bars | {"arm": model.bars["arm"].with_(kind="driven")}, hubs=arm("driven", square()).hubs)
    assert set(driven.whole.couplings) == {"O.arm.hinge"} and not driven.whole.bodies
    again = driven.with_(bars=driven.bars | {"arm": model.bars["arm"]}, hubs=model.hubs)
    assert not again.whole.couplings and set(again.whole.nodes) == set(model.whole.nodes)
    without = again.with_(hubs={"O": kt.Hub(arms={"arm": (0.1, 0.05, 0.02)})})
    assert set(without.nodes) == {"O", "A"} and set(without.bars) == {"arm"}
    assert set(without.whole.nodes) == {"O", "A", "O.arm"} and set(without.whole.bars) == {"arm", "O.arm"}
