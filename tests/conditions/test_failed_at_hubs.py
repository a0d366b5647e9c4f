"""Members with hubs that fail, and what a temperature or positions out of balance do not silently pass over."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235
ROD = kt.Rod(diameter=0.02)


def square(hubs: dict[str, kt.Hub]) -> kt.Model:
    """A square on two supports with both diagonals."""
    sides = {"ab": ("A", "B"), "bc": ("B", "C"), "cd": ("C", "D"), "da": ("D", "A"), "ac": ("A", "C"), "bd": ("B", "D")}
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)},
        fixed={"A": "xy", "B": "y"},
        bars=sides,
        hubs=hubs,
        section=ROD,
        material=STEEL,
        gravity=(0, -9.81),
        loads={"push": kt.NodalForce(node="C", force=(300.0, -500.0))},
        conditions={"failed": kt.Condition(failed=("bd",)), "whole": kt.Condition()},
    )


@pytest.mark.parametrize(
    "hubs",
    [
        {"D": kt.Hub(arms={"bd": 0.04}, clamped=["cd", "da"])},
        {"D": kt.Hub(arms={"bd": 0.04}, clamped=["cd"]), "C": kt.Hub(arms={"cd": 0.05}, clamped=["bc"])},
    ],
)
def test_a_member_that_fails_takes_its_arms_with_it(hubs: dict[str, kt.Hub]) -> None:
    """What is left is the model written without the member: the same members and the same forces."""
    model = square(hubs)
    found = kt.under(model, "failed")
    bare = {
        name: hub.with_(arms={member: arm for member, arm in hub.arms.items() if member != "bd"}) for name, hub in hubs.items()
    }
    ideal = square({})
    bars = {name: bar for name, bar in ideal.bars.items() if name != "bd"}
    by_hand = ideal.with_(bars=bars, conditions={}).with_(hubs=bare)
    assert sorted(found.nodes) == sorted(by_hand.nodes) and sorted(found.bars) == sorted(by_hand.bars)
    assert sorted(found.bodies) == sorted(by_hand.bodies)
    forces, wanted = (kt.runs.forces_at_rest(one).data.member_force for one in (found, by_hand))
    assert forces.sel(member=wanted.member).values == pytest.approx(wanted.values, rel=1e-9, abs=1e-7)


def test_a_failed_member_of_a_hinge_takes_bearing_and_drive_with_it() -> None:
    """Nothing that names its joint is left, and the run of a mission goes on."""
    model = kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(0.6, 0, 0.1), mass=2), "E": (0.6, 1, 0)},
        fixed=["O", "E"],
        bars={"arm": ("O", "A"), "tie": ("A", "E")},
        hubs={"O": kt.Hub(arms={"arm": (0.05, 0, 0.1)}, hinges={"arm": (0, 1, 0.2)})},
        drives={"turn": kt.HingeDrive(axis=("O.arm", "O.arm.axis1"), start="O", end="A")},
        bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.02, friction=0.1)},
        section=ROD,
        material=STEEL,
        conditions={"failed": kt.Condition(failed=("arm",))},
    )
    left = kt.under(model, "failed")
    assert list(left.whole.nodes) == ["O", "A", "E"] and list(left.whole.bars) == ["tie"]
    assert not left.hubs and not left.whole.bodies and not left.drives and not left.bearings


def test_a_beam_under_a_temperature_is_refused() -> None:
    """Clamped at both ends it would have -E A alpha dT; no force at all was shown."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)},
        clamped=["A", "B"],
        beams={"b": ("A", "B")},
        section=kt.Rectangle(width=0.02, height=0.02),
        material=STEEL,
        conditions={"hot": kt.Condition(temperature=50.0)},
        runs={"stand": kt.Run(analysis="statics.linear", condition="hot")},
    )
    for asked in (lambda: kt.under(model, "hot"), lambda: kt.run(model, "stand")):
        with pytest.raises(kt.InputError, match="'b' is a beam or a link, which has no thermal strain here"):
            asked()


def elastic(**changes: Any) -> kt.Model:
    """Three elastic bars to one node."""
    return kt.Model(
        nodes={"A": (-1, 0), "B": (0, 0), "C": (1.5, 0), "T": (0.2, 1.0)},
        fixed=["A", "B", "C"],
        bars={name.lower(): kt.Bar(ends=(name, "T"), kind="elastic", mass=0) for name in "ABC"},
        section=ROD,
        material=STEEL,
        **changes,
    )


@pytest.mark.slow
def test_elastic_bars_out_of_balance_say_so() -> None:
    """In the pose without load they have no force, whatever the load is: the message tells what is missing, also of a pair."""
    model = elastic(
        loads={"push": kt.NodalForce(node="T", force=(100.0, -1000.0))},
        conditions={"hot": kt.Condition(temperatures={"b": 60.0}), "none": kt.Condition()},
        runs={
            "pose": kt.Run(analysis="statics.at_poses", poses={"own": {}}),
            "stand": kt.Run(analysis="statics.equilibrium"),
            "all": kt.Run(analysis="mission", motions=("pose", "stand"), conditions=("hot", "none")),
        },
    )
    found = kt.statics.at_poses(model, [{}])
    assert "Not in balance: elastic bars in these positions leave up to 1e+03 N" in found.message
    assert "Not in balance" in kt.run(model, "pose").message
    mission = kt.run(model, "all")
    told = ["Not in balance" in str(text) for text in mission.pairs["finding"].values]
    assert told == [True, True, False, False]
    # in equilibrium nothing is missing, nor along a simulated motion, nor where there is no load
    place = kt.statics.equilibrium(model).data.position.values[None]
    assert "Not in balance" not in kt.statics.at_poses(model, place).message
    assert "Not in balance" not in kt.statics.at_poses(elastic(), [{}]).message
    heavy = elastic(gravity=(0, -9.81)).with_(nodes={**elastic().nodes, "T": kt.Node(at=(0.2, 1.0), mass=3.0)})
    run = kt.dynamics.simulate(heavy, 0.002, samples=5)
    assert "Not in balance" not in kt.dynamics.inverse(heavy, run.motion).message
    # the whole answer, by the stiffness method
    d = np.array([[1.2, 1.0], [0.2, 1.0], [-1.3, 1.0]])
    l = np.linalg.norm(d, axis=1)
    G, EA = d / l[:, None], STEEL.E * np.pi * 1e-4
    u = np.linalg.solve(G.T @ np.diag(EA / l) @ G, [100.0, -1000.0])
    assert kt.statics.linear(model).data.member_force.values == pytest.approx(EA / l * (G @ u), rel=1e-9)
