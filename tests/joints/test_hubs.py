"""Hubs with arms: against bodies made by hand, closed forms, and the free body of every bar and node."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.model.members import Brace

START = float(np.arctan2(0.15, 0.05))
STEEL: dict[str, Any] = {"section": kt.Rod(diameter=0.02), "material": kt.library.materials.STEEL_S235}


def four_bar(**hubs: kt.Hub) -> kt.Model:
    """A four-bar linkage with heavy links and a load; its joints at nodes, or at the arms of hubs."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D": (0.9, 0)},
        fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        drives={"motor": kt.AngleDrive("crank")},
        loads={"p": kt.NodalForce(node="C", force=(40, -25))},
        gravity=(0, -9.81),
        hubs=hubs,
        **STEEL,
    )


REAL = {
    "B": kt.Hub(arms={"coupler": (0.03, 0.04)}, clamped=["crank"]),
    "C": kt.Hub(arms={"coupler": "40 mm"}, clamped=["rocker"], section=kt.Rectangle(width=0.01, height=0.03)),
    "D": kt.Hub(arms={"rocker": (-0.02, 0.05)}),
}


def moved(model: kt.Model) -> tuple[Any, Any]:
    """A motion of the linkage and its forces."""
    trajectory = kt.Quintic(moves={"motor": (START, START + 1.0)}, duration=0.4)
    motion = kt.kinematics.follow(model, trajectory, samples=21)
    return motion, kt.dynamics.inverse(model, motion)


def residuals(model: kt.Model, motion: Any, forces: Any) -> float:
    """The largest residual of the free bodies of all bars and nodes, N or N m."""
    found = [0.0]
    for time in motion.arrays["time"].values[[0, 7, 13]]:
        cuts = [{"member": name} for name, bar in model.whole.members.items() if not isinstance(bar, Brace)]
        cuts += [{"node": name} for name in model.whole.nodes if "apex" not in name]
        found += [kt.dynamics.free_body(model, motion, forces, time=time, **cut).residual for cut in cuts]
    return max(found)


def test_a_hub_is_the_body_made_by_hand() -> None:
    """Joint forces, drive torque and motion are those of bodies with nodes where the members end."""
    model = four_bar(**REAL)
    motion, forces = moved(model)
    centre, other = np.array([0.75, 0.45]), np.array([0.05, 0.15])
    at = centre + 0.04 * (other - centre) / np.linalg.norm(other - centre)
    arm = kt.Bar(ends=("B", "B.coupler"), **STEEL)
    by_hand = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D.rocker": (0.88, 0.05)}
        | {"B.coupler": (0.08, 0.19), "C.coupler": tuple(at)},
        fixed=["A", "D.rocker"],
        bars={"crank": ("A", "B"), "coupler": ("B.coupler", "C.coupler"), "rocker": ("C", "D.rocker"), "b": arm}
        | {"c": kt.Bar(ends=("C", "C.coupler"), section=REAL["C"].section, material=STEEL["material"])}
        | {"b2": kt.Bar(ends=("A", "B.coupler"), mass=0.0), "c2": kt.Bar(ends=("D.rocker", "C.coupler"), mass=0.0)},
        drives={"motor": kt.AngleDrive("crank")},
        loads={"p": kt.NodalForce(node="C", force=(40, -25))},
        gravity=(0, -9.81),
        **STEEL,
    )
    same, there = moved(by_hand)
    assert np.allclose(same.data.position.sel(node="C"), motion.data.position.sel(node="C"), atol=1e-12)
    assert np.allclose(there.data.drive_force, forces.data.drive_force, rtol=1e-10)
    both = [one.data.joint_force.sel(member="coupler") for one in (forces, there)]
    assert np.allclose(*both, rtol=1e-9, atol=1e-9)


@pytest.mark.slow
def test_every_bar_and_node_is_in_equilibrium() -> None:
    """Arms clamped at the centre, members pinned at the tips: forces and moments balance, and so does the energy."""
    model = four_bar(**REAL)
    motion, forces = moved(model)
    largest = float(np.abs(forces.data.joint_force).max())
    assert residuals(model, motion, forces) < 1e-11 * largest
    assert float(np.abs(forces.data.energy_balance).max()) < 1e-9 * float(np.abs(forces.data.power).max())
    # the couples at the centre of the hub at C balance: arm and clamped rocker
    M = kt.strength.sections(model, forces, 2).data.section_M.squeeze("moment")
    assert np.allclose(M.sel(part="C.coupler", station=0), -M.sel(part="rocker", station=0), rtol=1e-9, atol=1e-12)
    assert float(np.abs(M.sel(part="C.coupler", station=1)).max()) < 1e-12 * float(np.abs(M).max())


def test_the_arm_of_a_bracket() -> None:
    """A weight hung on a bracket: the root moment is W e, its stress 32 W e/(pi d^3) + T/A."""
    W, e, d = 200.0, 0.05, 0.02
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, -0.5)},
        fixed={"A": "xy", "B": "x"},
        bars={"rod": kt.Bar(ends=("A", "B"), mass=0.0)},
        loads={"W": kt.NodalForce(node="B", force=(0, -W))},
        hubs={"A": kt.Hub(arms={"rod": (e, 0)}, section=kt.Rod(diameter=d), material=kt.Material(E=2e11, density=0.0))},
    )
    straight = model.with_(nodes=model.nodes | {"B": (e, -0.5)})
    x = np.array([[node.at for node in straight.whole.nodes.values()]] * 2)
    forces = kt.dynamics.inverse(straight, kt.kinematics.from_arrays(straight, [0.0, 1.0], x, 0 * x, 0 * x))
    found = kt.strength.sections(straight, forces, 2)
    M = found.data.section_M.sel(part="A.rod", station=0)
    assert np.allclose(np.abs(M), W * e, rtol=1e-12)
    assert np.allclose(np.abs(found.data.section_V.sel(part="A.rod")), W, rtol=1e-12)
    worst = kt.strength.stresses(straight, found).von_mises.sel(part="A.rod", station=0)
    assert np.allclose(worst, 32 * W * e / (np.pi * d**3), rtol=1e-9)


def stewart() -> kt.Model:
    """A spatial hub on six driven legs, with a clamped mast that carries a load."""
    feet = {f"F{k}": (0.5 * np.cos(a), 0.5 * np.sin(a), 0.0) for k, a in enumerate(np.radians([5, 115, 125, 235, 245, 355]))}
    tips = {f"L{k}": (0.2 * np.cos(a), 0.2 * np.sin(a), 0.0) for k, a in enumerate(np.radians([55, 65, 175, 185, 295, 305]))}
    return kt.Model(
        nodes={"C": (0, 0, 0.6), "D": (0.1, 0.05, 1.0), **feet},
        fixed=list(feet),
        bars={f"L{k}": kt.Bar(ends=(f"F{k}", "C"), kind="driven") for k in range(6)} | {"mast": ("C", "D")},
        loads={"p": kt.NodalForce(node="D", force=(100, 40, -200))},
        gravity=(0, 0, -9.81),
        hubs={"C": kt.Hub(arms=tips, clamped=["mast"]), "F0": kt.Hub(reach=0.03)},
        **STEEL,
    )


@pytest.mark.slow
def test_a_hub_in_space() -> None:
    """Six arms of vectors and a clamped mast on driven legs: determinate, every free body in equilibrium."""
    model = stewart()
    whole = model.whole
    ready = kt.kinematics.mobility(model)
    assert (ready.degrees_of_freedom, ready.undriven) == (6, 0)
    start = {
        f"L{k}": float(np.linalg.norm(np.subtract(*(whole.nodes[n].at for n in whole.bars[f"L{k}"].ends)))) for k in range(6)
    }
    moves = {name: (length, length + 0.02 * (-1) ** k) for k, (name, length) in enumerate(start.items())}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.3), samples=21)
    forces = kt.dynamics.inverse(model, motion)
    assert residuals(model, motion, forces) < 1e-10 * float(np.abs(forces.data.joint_force).max())
    assert float(np.abs(forces.data.energy_balance).max()) < 1e-8 * float(np.abs(forces.data.power).max())
    # virtual work: the drives' work is that of weight and load at rest
    assert not forces.data.attrs["not_unique"]
    checked = kt.strength.check(model, forces)
    assert np.isfinite(checked.data.utilisation.sel(part=["mast", "C.L0", "F0.L0"], rule="yield")).all()
    assert "Not included" not in checked.message


def test_closed_frames_are_not_held() -> None:
    """Statics alone does not give the moments of two members clamped at a hub whose far ends a third bar joins."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0.5, 0.6)},
        fixed={"A": "xy", "B": "y"},
        bars={"a": ("A", "C"), "b": ("B", "C"), "tie": ("A", "B")},
        hubs={"C": kt.Hub(clamped=["a", "b"])},
        loads={"p": kt.NodalForce(node="C", force=(0, -10))},
        **STEEL,
    )
    x = np.array([[node.at for node in model.whole.nodes.values()]] * 2)
    forces = kt.dynamics.inverse(model, kt.kinematics.from_arrays(model, [0.0, 1.0], x, 0 * x, 0 * x))
    assert "Not included: bending by hub 'C'" in kt.strength.check(model, forces).message


@pytest.mark.slow
def test_simulation_agrees_with_inverse_dynamics() -> None:
    """A pendulum whose hub turns about a fixed node: forward and inverse dynamics, and energy."""
    model = kt.Model(
        nodes={"O": (0, 0), "P": (0.5, 0), "Q": (0.5, -0.4)},
        fixed=["O"],
        bars={"arm": ("O", "P"), "bob": kt.Bar(ends=("P", "Q"), mass=2.0)},
        hubs={"P": kt.Hub(arms={"bob": (0.02, -0.06)}, clamped=["arm"])},
        gravity=(0, -9.81),
        **STEEL,
    )
    run = kt.dynamics.simulate(model, t_end=1.0)
    energy = run.data.energy.values
    assert np.abs(energy - energy[0]).max() < 1e-8 * np.abs(energy).max()
    found = kt.dynamics.inverse(model, run.motion)
    assert residuals(model, run.motion, found) < 1e-9 * float(np.abs(found.data.joint_force).max())


@pytest.mark.parametrize(
    ("hubs", "said"),
    [
        ({"Z": kt.Hub(reach=0.1)}, "no node called 'Z'"),
        ({"B": kt.Hub(arms={"rod": 0.1})}, "no member called 'rod'"),
        ({"B": kt.Hub(arms={"rocker": 0.1})}, "does not end at 'B' but at C and D"),
        ({"B": kt.Hub(arms={"coupler": (0.1, 0, 0)})}, "has 3 components in a model of dimension 2"),
        ({"B": kt.Hub(reach=0.5), "C": kt.Hub(reach=0.5)}, "overlaps that of 'C'"),
        ({"B": kt.Hub(arms={"coupler": 0.8})}, "overlaps its other node"),
        ({"A": kt.Hub(clamped=["crank"])}, "is clamped to a hub on the ground"),
    ],
)
def test_faults_name_the_thing_and_the_mend(hubs: dict[str, kt.Hub], said: str) -> None:
    """Before any work."""
    with pytest.raises(kt.ModelError, match=said):
        four_bar(**hubs)


def test_faults_of_the_record() -> None:
    """A hub without arms, a member twice, no length."""
    with pytest.raises(kt.ModelError, match="has no arms"):
        kt.Hub()
    with pytest.raises(kt.ModelError, match="is clamped and has an arm"):
        kt.Hub(arms={"a": 0.1}, clamped=["a"])
    with pytest.raises(kt.ModelError, match="must be greater than 0"):
        kt.Hub(arms={"a": "0 mm"})


def test_members_that_change_their_length() -> None:
    """Driven members cannot be clamped; rods and lengths must fit between the joints."""
    nodes = {"A": (0, 0), "B": (1, 0)}
    with pytest.raises(kt.ModelError, match="whose length changes"):
        kt.Model(
            nodes=nodes, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), kind="driven")}, hubs={"B": kt.Hub(clamped=["b"])}
        )
    active = kt.Active(ends=("A", "B"), base=kt.Part(length=0.95, mass=1), tube=kt.Part(length=0.3, mass=1))
    with pytest.raises(kt.ModelError, match="its base is 0.95 m long"):
        kt.Model(nodes=nodes, fixed=["A"], active={"m": active}, hubs={"B": kt.Hub(reach=0.1)})
    with pytest.raises(kt.ModelError, match="from node to node"):
        kt.Model(nodes=nodes, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), length=1)}, hubs={"B": kt.Hub(reach=0.1)})


def test_arms_are_those_of_the_hubs() -> None:
    """The model stays as it was given, and its whole is that of its hubs, whatever they were before."""
    model = four_bar(**REAL)
    again = model.with_(title="again")
    for field in ("nodes", "bars", "bodies"):
        assert getattr(model, field) == getattr(four_bar(), field)
        assert list(getattr(again.whole, field).items()) == list(getattr(model.whole, field).items())
    space = stewart()
    assert list(space.with_(title="again").whole.nodes) == list(space.whole.nodes)
    pinned = model.with_(hubs=model.hubs | {"C": kt.Hub(clamped=["rocker"])})
    assert pinned.whole.bars["coupler"].ends == ("B.coupler", "C") and "C.coupler" not in pinned.whole.nodes
    thick = model.with_(hubs=model.hubs | {"B": REAL["B"].with_(section=kt.Rod(diameter=0.05))})
    assert thick.whole.bars["B.coupler"].section == kt.Rod(diameter=0.05)
    later = four_bar(B=REAL["B"]).with_(hubs=REAL)
    assert list(later.whole.bars.items()) == list(model.whole.bars.items())


def test_a_file_with_hubs(tmp_path: Any) -> None:
    """The YAML form, with units and library names."""
    text = """
    kinetruss: 1
    nodes: {A: [0, 0], B: [1, 0], C: [500 mm, 500 mm]}
    fixed: [A, B]
    bars: {a: [A, C], b: [B, C]}
    hubs:
      A: {reach: 50 mm, material: steel_s235, section: {kind: rod, diameter: 12 mm}}
      C: {arms: {a: [-20 mm, 0]}, clamped: [b]}
    """
    path = tmp_path / "hubs.yaml"
    path.write_text("\n".join(line[4:] for line in text.splitlines()))
    model = kt.read(path)
    assert model.bars["a"].ends == ("A", "C") and "A.a" not in model.bars
    assert model.whole.bars["a"].ends == ("A.a", "C.a")
    assert model.whole.bars["A.a"].material == "steel_s235"
    assert kt.read(kt.write(model, tmp_path / "again.yaml")) == model


def test_a_hub_on_a_line_in_space() -> None:
    """Nothing would keep it from turning about that line."""
    with pytest.raises(kt.ModelError, match="all its joints on one line"):
        kt.Model(
            nodes={"A": (0, 0, 0), "M": (0.4, 0, 0), "B": (1, 0, 0)},
            bars={"left": ("A", "M"), "right": ("M", "B")},
            hubs={"M": kt.Hub(clamped=["left", "right"])},
        )


def test_hubs_are_rigid_in_elastic_analyses() -> None:
    """Two ties on the arms of a hub that guides hold: the hub sinks by N l/(E A) of the ties, and its arms add nothing."""
    tie: dict[str, Any] = {"section": kt.Rod(diameter=0.004), "material": STEEL["material"], "mass": 0.0}
    model = kt.Model(
        nodes={"A": (-0.1, 1), "B": (0.1, 1), "C": (0, 0)},
        fixed={"A": "xy", "B": "xy", "C": "x"},
        bars={"a": kt.Bar(ends=("A", "C"), **tie), "b": kt.Bar(ends=("B", "C"), **tie)},
        hubs={"C": kt.Hub(arms={"a": (-0.1, 0.2), "b": (0.1, 0.2)}, section=kt.Rod(diameter=0.02), material=STEEL["material"])},
        loads={"W": kt.NodalForce(node="C", force=(0, -1000))},
    )
    found = kt.statics.linear(model)
    exact = 500 * 0.8 / (STEEL["material"].E * tie["section"].area)
    assert np.isclose(-found.data.displacement.sel(node="C", axis="y"), exact, rtol=1e-9)
    assert not found.data.elongation.sel(member=["C.a", "C.b"]).values.any()


def test_joints_follow_their_hub() -> None:
    """Another arm, or another place of the node, moves the joints, and the apex of a hub in space."""
    model = four_bar(**REAL)
    moved = model.with_(
        hubs=model.hubs | {"B": kt.Hub(arms={"coupler": (0.01, 0.02)}, clamped=["crank"])},
        nodes=model.nodes | {"C": (0.7, 0.4)},
    )
    assert np.allclose(moved.whole.nodes["B.coupler"].at, (0.06, 0.17))
    fresh = four_bar().with_(nodes=four_bar().nodes | {"C": (0.7, 0.4)}, hubs=moved.hubs)
    assert moved.whole.nodes == fresh.whole.nodes
    space = stewart()
    higher = space.with_(nodes=space.nodes | {"C": (0, 0, 0.7)})
    x, y, z = space.whole.nodes["C.L3"].at
    assert np.allclose(higher.whole.nodes["C.L3"].at, (x, y, z + 0.1))


def test_what_a_hub_clamps_may_change() -> None:
    """Its body is the one that it now has; a hub that comes off the ground moves."""
    model = four_bar(**REAL)
    loose = model.with_(hubs=model.hubs | {"B": kt.Hub(arms={"coupler": (0.03, 0.04)})})
    assert loose.whole.bodies["B.hub"].nodes == ("B", "B.coupler")
    assert kt.kinematics.mobility(loose).degrees_of_freedom == kt.kinematics.mobility(model).degrees_of_freedom + 1
    assert model.whole.bars["D.rocker"].kind == "free" and "D.rocker" in model.whole.fixed
    off = model.with_(fixed={"A": "xy", "D": "x"})
    assert off.whole.bars["D.rocker"].kind == "rigid" and "D.rocker" not in off.whole.fixed


def test_a_load_on_a_hub_is_not_in_its_arms() -> None:
    """It acts at the centre: a massless arm has what its member does to its tip, -N u . u_arm, by every kind of statics."""
    push = kt.BodyForce(body="C.hub", at=(0.72, 0.4), force=(300, 200))
    model = four_bar(**REAL).with_(loads={"push": push}, material=kt.Material(E=2e11, density=0.0))
    path = kt.statics.path(model, "push", points=3).data
    found = [kt.statics.linear(model).data, kt.statics.equilibrium(model).data, path.isel(point=-1)]
    assert abs(path.load_factor.values[-1]) > 0
    B, C = (np.array(model.whole.nodes[f"{hub}.coupler"].at) for hub in "BC")
    along, arm = C - B, C - np.array(model.nodes["C"].at)
    for data in found:
        N = float(data.member_force.sel(member="coupler"))
        exact = -N * (along @ arm) / (np.linalg.norm(along) * np.linalg.norm(arm))
        assert abs(N) > 1 and float(data.member_force.sel(member="C.coupler")) == pytest.approx(exact, rel=1e-9)
