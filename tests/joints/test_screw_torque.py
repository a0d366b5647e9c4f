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
        name: float(np.linalg.norm(np.subtract(*(model.nodes[n].at for n in member.ends))))
        for name, member in model.members.items()
        if name in model.driven_members
    }
    moves = {name: (one, one + 0.03 + 0.005 * k) for k, (name, one) in enumerate(start.items())}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=2.0), samples=9)
    forces = kt.dynamics.inverse(model, motion)
    return motion, forces, kt.actuators.evaluate(model, motion, forces)


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
    nodes = list(model.nodes)
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
    assert "Not held" not in kt.strength.check(loaded, found).message
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
