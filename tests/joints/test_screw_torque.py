"""The torque of a screw about the axis of its member, held by hubs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt

SCREW = kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.12)


def lift(**hubs: kt.Hub) -> kt.Model:
    """A platform on five passive driven legs and an active one."""
    feet = {f"F{k}": (0.5 * np.cos(a), 0.5 * np.sin(a), 0.0) for k, a in enumerate(np.radians([5, 115, 125, 235, 245, 355]))}
    length = float(np.linalg.norm(np.subtract((0, 0, 0.8), feet["F0"])))
    part = {"section": kt.Tube(outer=0.02, inner=0.016), "material": "steel_s235"}
    active = kt.Active(
        ends=("F0", "C"), base=kt.Part(length=0.55 * length, **part), tube=kt.Part(length=0.5 * length, **part), screw=SCREW
    )
    return kt.Model(
        nodes={"C": kt.Node(at=(0, 0, 0.8), mass=20.0), **feet},
        fixed=list(feet),
        bars={f"L{k}": kt.Bar(ends=(f"F{k}", "C"), kind="driven", mass=0.3) for k in range(1, 6)},
        active={"L0": active},
        gravity=(0, 0, -9.81),
        hubs=hubs,
    )


def tips() -> dict[str, Any]:
    """Arms of the platform."""
    return {f"L{k}": (0.2 * np.cos(a), 0.2 * np.sin(a), 0.0) for k, a in enumerate(np.radians([55, 65, 175, 185, 295, 305]))}


def raised(model: kt.Model) -> tuple[Any, Any, Any]:
    """All legs grow."""
    start = {
        name: float(np.linalg.norm(np.subtract(*(model.whole.nodes[n].at for n in member.ends))))
        for name, member in model.whole.members.items()
        if name in model.driven_members
    }
    moves = {name: (one, one + 0.03 + 0.005 * k) for k, (name, one) in enumerate(start.items())}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=2.0), samples=9)
    forces = kt.dynamics.inverse(model, motion)
    return motion, forces, kt.actuators.evaluate(model, motion, forces)


@pytest.mark.slow
def test_the_torque_about_the_axis() -> None:
    """T = F d/2 (l + pi mu d)/(pi d - mu l) where it raises; the other hand turns it round; work plus friction is T w."""
    model = lift(C=kt.Hub(arms=tips(), section=kt.Rod(diameter=0.02), material=kt.Material(E=2e11, density=7850.0)))
    motion, forces, demand = raised(model)
    F = -forces.data.member_force.sel(member="L0").values[1:-1]
    assert (F > 0).all()
    l, d, mu = 2 * np.pi * 0.001, 0.02, 0.12
    exact = F * d / 2 * (l + np.pi * mu * d) / (np.pi * d - mu * l)
    assert np.allclose(demand.data.axis_torque.sel(active="L0")[1:-1], exact, rtol=1e-12)
    left = model.active["L0"].with_(screw=SCREW.with_(hand="left"))
    turned = kt.actuators.evaluate(model.with_(active={"L0": left}), motion, forces)
    assert np.allclose(turned.data.axis_torque, -demand.data.axis_torque, equal_nan=True)


@pytest.mark.slow
def test_hubs_carry_it() -> None:
    """The couple on the hub changes the forces of the legs by what its free body asks, and no arm's free body."""
    model = lift(C=kt.Hub(arms=tips(), section=kt.Rod(diameter=0.02), material=kt.Material(E=2e11, density=7850.0)))
    motion, forces, demand = raised(model)
    couples = kt.actuators.screw_couples(model, motion, demand)
    assert list(couples) == ["L0.torque.B"]
    loaded = model.with_(loads=couples)
    found = kt.dynamics.inverse(loaded, motion)
    # the legs' additional forces make the opposite couple about the centre and no force
    x = motion.data.position.values
    nodes = list(model.whole.nodes)
    change = (found.data.joint_force - forces.data.joint_force).values
    push, turn = np.zeros((len(x), 3)), np.zeros((len(x), 3))
    for k in range(6):
        i = list(model.members).index(f"L{k}")
        on_hub = -change[:, i, 1]
        push += on_hub
        turn += np.cross(x[:, nodes.index(f"C.L{k}")] - x[:, nodes.index("C")], on_hub)
    given = np.array(couples["L0.torque.B"].moments)
    assert np.allclose(turn, -given, atol=1e-9 * np.abs(given).max())
    assert np.abs(push).max() < 1e-9 * np.abs(change).max()
    d = x[:, nodes.index("C.L0")] - x[:, nodes.index("F0")]
    assert np.allclose(
        given, -demand.data.axis_torque.sel(active="L0").values[:, None] * d / np.linalg.norm(d, axis=1)[:, None]
    )
    for member in ("C.L0", "C.L3", "L2"):
        cut = kt.dynamics.free_body(loaded, motion, found, member=member, time=1.0)
        assert cut.residual < 1e-10 * float(np.abs(found.data.joint_force).max())
    assert "Not included" not in kt.strength.check(loaded, found).message
    said = "Not included: the torque of the screw of L0 about the axis"
    assert said in kt.strength.check(model, forces).message
    start = dict(zip(model.all_drives, motion.data.drive_position.values[0].tolist(), strict=True))
    mission = model.with_(
        trajectories={"up": kt.Quintic(moves={name: (one, one + 0.02) for name, one in start.items()}, duration=1.0)},
        runs={"all": kt.Run(analysis="mission", motions=("up",), samples=5)},
    )
    assert said in kt.run(mission).verdict.message
    assert np.abs(found.data.energy_balance).max() < 1e-8 * np.abs(found.data.power).max()


def test_what_is_refused() -> None:
    """Ends that pass no moment; planar models."""
    model = lift(C=kt.Hub(arms={name: arm for name, arm in tips().items() if name != "L0"}))
    motion, forces, demand = raised(model)
    with pytest.raises(kt.InputError, match="'L0' ends at node 'C', which passes no moment"):
        kt.actuators.screw_couples(model, motion, demand)
    flat = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    with pytest.raises(kt.InputError, match="planar"):
        kt.actuators.screw_couples(flat, motion, demand)
    assert forces.status.ok


def slanted(section: Any) -> kt.Model:
    """The lift with a hub at the foot of the active member too, on the ground, and arms of this section."""
    arms = tips() | {"L0": (0.2, 0.1, -0.05)}
    steel = kt.Material(E=2e11, density=7850.0, yield_strength=2.5e8)
    return lift(
        C=kt.Hub(arms=arms, section=section, material=steel), F0=kt.Hub(arms={"L0": 0.06}, section=section, material=steel)
    )


def test_arms_and_members_are_twisted_and_bent() -> None:
    """At the root of an arm e the couple C of the joint leaves C . e/e of torsion and C - (C . e) e/e^2 of bending."""
    model = slanted(kt.Rod(diameter=0.02))
    motion, forces, demand = raised(model)
    couples = kt.actuators.screw_couples(model, motion, demand)
    assert list(couples) == ["L0.torque.A", "L0.torque.B"] and couples["L0.torque.B"].member == "L0"
    loaded = model.with_(loads=couples)
    found = kt.dynamics.inverse(loaded, motion)
    torque = demand.data.axis_torque.sel(active="L0").values
    sections, plain = kt.strength.sections(loaded, found), kt.strength.sections(model, forces)
    assert "torsion" not in plain.data
    x, nodes = motion.data.position.values, list(model.whole.nodes)
    place = {name: x[:, nodes.index(name)] for name in ("C", "C.L0", "F0", "F0.L0")}
    along = place["C.L0"] - place["F0.L0"]
    along /= np.linalg.norm(along, axis=1)[:, None]
    e = place["C.L0"] - place["C"]
    reach = np.linalg.norm(e, axis=1)
    e /= reach[:, None]
    C = -torque[:, None] * along
    twist = sections.data.torsion
    assert np.allclose(twist.sel(part="C.L0"), np.einsum("tc,tc->t", C, e)[:, None], rtol=1e-12)
    for part in ("L0.base", "L0.tube"):
        assert np.allclose(twist.sel(part=part), torque[:, None], rtol=1e-12)
    # the arm on the ground lies along the member at the start
    assert twist.sel(part="F0.L0").values[0, 0] == pytest.approx(torque[0], rel=1e-12)
    assert not twist.sel(part=["L1", "C.L1"]).values.any()
    # bending at the root, free body of the arm: F at the tip, its own weight (the hub hardly turns), and C
    axes = kt.kinematics.member_rates(loaded, motion).member_axes.sel(member="C.L0").values
    F = found.data.joint_force.sel(member="L0").values[:, 1]
    moment = np.cross(reach[:, None] * e, -F) + C
    own = -9.81 * float(np.pi / 4 * 0.02**2 * 7850.0) * reach
    a = motion.data.acceleration.values
    lever = (a[:, nodes.index("C")] / 2 + (a[:, nodes.index("C.L0")] - a[:, nodes.index("C")]) / 3) * (own / 9.81)[:, None]
    moment += np.cross(reach[:, None] * e, np.stack([0 * own, 0 * own, own / 2], axis=1) + lever)
    M = sections.data.section_M.sel(part="C.L0", station=0.0).values
    exact = np.einsum("tij,tj->ti", axes, moment)
    assert np.allclose(M, exact[:, 1:], atol=1e-9 * np.abs(exact).max())
    for member in ("C.L0", "F0.L0", "L0"):
        assert kt.dynamics.free_body(loaded, motion, found, member=member, time=1.0).residual < 1e-9 * np.abs(F).max()
    for node in ("C", "C.L0", "F0"):
        assert kt.dynamics.free_body(loaded, motion, found, node=node, time=1.0).residual < 1e-9 * np.abs(F).max()


def test_torsion_counts_in_strength() -> None:
    """tau = 16 T/(pi d^3) of a rod; the check finds the stress of the sections; a general section is not checked."""
    model = slanted(kt.Rod(diameter=0.02))
    motion, _, demand = raised(model)
    demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    couples = {
        name: one.with_(moments=[[100 * c for c in m] for m in one.moments])
        for name, one in kt.actuators.screw_couples(model, motion, demand).items()
    }
    loaded = model.with_(loads=couples)
    found = kt.dynamics.inverse(loaded, motion)
    sections = kt.strength.sections(loaded, found, 101)
    stress = kt.strength.stresses(loaded, sections).von_mises.sel(part="F0.L0")
    tau = 16 * sections.data.torsion.sel(part="F0.L0") / (np.pi * 0.02**3)
    parts = kt.strength.components(loaded, sections).sel(part="F0.L0")
    k = np.hypot(parts.shear_2, parts.shear_3)
    fibre = np.abs(parts.axial) + np.hypot(parts.bending_2, parts.bending_3)
    assert (stress >= np.sqrt(fibre**2 + 3 * tau**2) * (1 - 1e-12)).all()
    assert (stress <= np.sqrt(fibre**2 + 3 * (np.abs(tau) + k) ** 2) * (1 + 1e-12)).all()
    worst = kt.strength.check(loaded, found).data["value"].sel(part="F0.L0", rule="yield")
    assert float(worst) == pytest.approx(float(stress.max()), rel=1e-6)
    flat = kt.General(area=3e-4, I2=8e-9, I3=8e-9, c2=0.01, c3=0.01)
    hubs = {name: hub.with_(section=flat) for name, hub in slanted(flat).hubs.items()}
    general = slanted(flat).with_(loads=couples, hubs=hubs)
    verdict = kt.strength.check(general, kt.dynamics.inverse(general, motion))
    rows = {row.part: row for row in verdict.table() if row.rule == "yield"}
    assert not rows["C.L0"].checked and "torsion" in rows["C.L0"].note and rows["C.L1"].checked


def test_a_couple_through_a_member_that_has_no_arm() -> None:
    """The fault names the member."""
    couple = kt.BodyCouple(body="C.hub", member="L9", moment=(0, 0, 1))
    with pytest.raises(kt.ModelError, match="'L9'"):
        slanted(kt.Rod(diameter=0.02)).with_(loads={"c": couple})
