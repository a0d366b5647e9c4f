"""An arm balanced by springs: the optimum finds ideal springs that balance it exactly, in closed form."""

import numpy as np
import pytest

import kinetruss as kt

g, L1, L2, LOAD = 9.81, 0.7, 0.6, 8.0
UPPER, ROD, FORE = 3.0, 1.0, 2.0


def balanced() -> kt.Model:
    """Two bars in series; a rod keeps the head of the elbow upright; springs without free length from S to E, from K to T."""

    def ideal(a: str, b: str) -> kt.Spring:
        return kt.Spring(coordinate={"kind": "distance", "nodes": (a, b)}, stiffness=500.0, rest=0.0)

    return kt.Model(
        nodes={
            "O": (0, 0), "H": (-0.15, 0.1), "S": (0, 0.2), "E": (L1, 0), "R": (L1 - 0.15, 0.1), "K": (L1, 0.2),
            "T": kt.Node(at=(L1 + L2, 0), mass=LOAD),
        },
        fixed=["O", "H", "S"], gravity=(0, -g),
        bars={
            "upper": kt.Bar(ends=("O", "E"), mass=UPPER), "rod": kt.Bar(ends=("H", "R"), mass=ROD),
            "fore": kt.Bar(ends=("E", "T"), mass=FORE),
            **{a + b: kt.Bar(ends=(a, b), mass=0.0) for a, b in ("ER", "EK", "RK")},
        },
        springs={"lower": ideal("S", "E"), "higher": ideal("K", "T")},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.HingeDrive(axis="E", start="K", end="T")},
        trajectories={  # so slow that inertia does not count
            "bend": kt.Spline(times=(0, 1e6, 2e6, 3e6, 4e6), values={"shoulder": (0.4, 1.7, 1.2, 0.6, 1.0),
                                                                      "elbow": (3.8, 4.5, 5.0, 4.2, 4.8)}),
        },
    )  # fmt: skip


def test_ideal_springs_balance_the_arm():
    """k a b = m g l of each spring (French & Widden 2000; Herder 2001): no torque is left, whatever the pose."""
    arm = balanced()
    variables = {
        "lower": {"of": "springs.lower.stiffness", "between": (50.0, 5000.0), "scale": "log"},
        "post": {"of": "nodes.S.at.1", "between": (0.05, 0.4)},
        "higher": {"of": "springs.higher.stiffness", "between": (50.0, 5000.0), "scale": "log"},
        "head": {"of": "nodes.K.at.1", "between": (0.05, 0.4)},
    }
    motion = {"trajectory": "bend", "samples": 9}
    found = kt.design.optimise(
        arm, variables, "mean(drive_force**2)", analysis="dynamics.inverse", arguments=motion, tolerance=1e-14
    )
    value = found.values
    # what turns with the upper arm carries head, forearm and load at E; half of the rod hangs at R
    assert value["lower"] * value["post"] * L1 == pytest.approx(g * (UPPER / 2 + ROD / 2 + FORE + LOAD) * L1, rel=1e-4)
    assert value["higher"] * value["head"] * L2 == pytest.approx(g * (FORE / 2 + LOAD) * L2, rel=1e-4)
    before, after = (
        np.abs(kt.dynamics.inverse(one, kt.kinematics.follow(one, "bend", samples=41)).drive_force).max().item()
        for one in (arm, found.model)
    )
    assert before > 10
    assert after < 1e-4 * before
