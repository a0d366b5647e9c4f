"""Models of beams, hinges in space, hubs, bearings, couplings and springs on coordinates, for `against` and `cold_start`."""

from __future__ import annotations

from typing import Any

STEEL = "steel_s235"


def frame(storeys: int) -> Any:
    """A frame of beams in the plane, pushed from the side; a storey has three beams."""
    import kinetruss as kt

    nodes = {f"{side}{k}": (3.0 * (side == "R"), 3.0 * k) for k in range(storeys + 1) for side in "LR"}
    beams = {f"{side}{k}{k + 1}": (f"{side}{k}", f"{side}{k + 1}") for k in range(storeys) for side in "LR"}
    beams |= {f"floor{k}": (f"L{k}", f"R{k}") for k in range(1, storeys + 1)}
    loads = {f"wind{k}": kt.NodalForce(node=f"L{k}", force=(500.0, 0.0)) for k in range(1, storeys + 1)}
    return kt.Model(
        nodes=nodes,
        clamped=["L0", "R0"],
        beams=beams,
        section=kt.Rectangle(width=0.1, height=0.1),
        material=STEEL,
        gravity=(0, -9.81),
        loads=loads,
    )


def elastic_crank(count: int) -> Any:
    """A driven crank in the plane, and an arm of beams that is clamped to its end."""
    import kinetruss as kt

    nodes = {"O": (0, 0), "A": (0.5, 0)} | {f"B{k}": (0.5 + 0.4 * k, 0.05 * k * k) for k in range(1, count + 1)}
    pairs = zip(("A", *(f"B{k}" for k in range(1, count))), (f"B{k}" for k in range(1, count + 1)), strict=True)
    return kt.Model(
        nodes=nodes,
        fixed=["O"],
        bars={"crank": kt.Bar(ends=("O", "A"), mass=1.0)},
        bodies={"hub": kt.Body(nodes=("O", "A"))},
        beams={f"b{k}": pair for k, pair in enumerate(pairs)},
        clamped={"A": "hub"},
        section=kt.Rectangle(width=0.02, height=0.02),
        material=STEEL,
        gravity=(0, -9.81),
        drives={"motor": kt.AngleDrive("crank")},
    )


def crank_in_space(friction: float = 0.0) -> Any:
    """A crank and a rocker on hinges of skew axes at hubs, a coupler between ball joints; with friction in a bearing."""
    import kinetruss as kt

    hubs = {
        "O": kt.Hub(arms={"crank": (0, 0, 0.05)}, hinges={"crank": "z"}),
        "Q": kt.Hub(arms={"rocker": (0.04, 0, 0)}, hinges={"rocker": "x"}),
    }
    rubs = {"q": kt.Bearing(member="rocker", node="Q", radius=0.02, friction=friction)} if friction else {}
    return kt.Model(
        nodes={"O": (0, 0, 0), "A": (0.25, 0, 0.05), "B": (0.6, 0.5, 0.5), "Q": (0.6, 0.45, 0.1)},
        fixed=["O", "Q"],
        bars={"crank": ("O", "A"), "coupler": ("A", "B"), "rocker": ("B", "Q")},
        hubs=hubs,
        bearings=rubs,
        gravity=(0, 0, -9.81),
        section=kt.Rod(diameter=0.03),
        material=STEEL,
        drives={"motor": kt.AngleDrive("crank", axis="z")},
    )


def hinged_arm() -> Any:
    """Two links in space: the first turns about z, the second about an axis that the first carries, both driven."""
    import kinetruss as kt

    at = {"O": (0, 0, 0), "T": (0, 0, 1), "F": (1, 0, 0), "S": (0.9, 0.1, 0.4), "R": (0.8, 0.7, 0.6), "P": (1.6, 0.5, 0.2)}
    pairs = (("O", "S"), ("O", "R"), ("T", "S"), ("T", "R"), ("S", "R"), ("S", "P"), ("R", "P"))
    drives = {
        "base": kt.HingeDrive(axis=("O", "T"), start="F", end="S"),
        "elbow": kt.HingeDrive(axis=("S", "R"), start="O", end="P"),
    }
    return kt.Model(
        nodes=at,
        fixed=["O", "T", "F"],
        bars={a + b: kt.Bar(ends=(a, b), mass=0.2) for a, b in pairs},
        drives=drives,
        gravity=(0, 0, -9.81),
    )


def sprung_links(count: int) -> Any:
    """A chain of links in the plane with a damped spring about every pin, and a coupling of its first two angles."""
    import kinetruss as kt

    nodes = {f"N{k}": (0.3 * k, 0.02 * k * k) for k in range(count + 1)}
    springs = {
        f"s{k}": kt.Spring(
            coordinate=kt.HingeDrive(axis=f"N{k}", start=f"N{k - 1}", end=f"N{k + 1}"), stiffness=20.0, damping=0.1
        )
        for k in range(1, count)
    }
    gear = kt.Coupling(terms=((kt.AngleDrive("b0"), 2.0), (kt.AngleDrive("b1"), -1.0)))
    return kt.Model(
        nodes=nodes,
        fixed=["N0"],
        bars={f"b{k}": kt.Bar(ends=(f"N{k}", f"N{k + 1}"), mass=0.5) for k in range(count)},
        springs=springs,
        couplings={"gear": gear},
        gravity=(0, -9.81),
    )
