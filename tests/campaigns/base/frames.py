"""Random structures of beams, hubs, bearings, springs on coordinates and hinges in space; some on a base that turns."""

from __future__ import annotations

from typing import Any

import numpy as np
from webs import STEEL, Dice, planar_web, spatial_web

import kinetruss as kt

SECTIONS = (
    kt.Rectangle(width=0.03, height=0.05),
    kt.Tube(outer=0.05, inner=0.04),
    kt.Rod(diameter=0.04),
)


def _some(dice: Dice, share: float) -> bool:
    return bool(dice.random() < share)


def _near(dice: Dice, nodes: dict[str, tuple[float, ...]]) -> dict[str, Any]:
    """The same nodes a little elsewhere, some with a lump."""
    return {
        name: kt.Node(
            at=tuple(x + 0.04 * float(dice.normal()) for x in at), mass=float(dice.uniform(0.1, 1.5)) * _some(dice, 0.5)
        )
        for name, at in nodes.items()
    }


def _force(dice: Dice, node: str, dim: int) -> kt.NodalForce:
    """A constant force, or one in time."""
    if _some(dice, 0.6):
        return kt.NodalForce(node=node, force=tuple(map(float, 40 * dice.normal(size=dim))))
    rows = tuple(tuple(map(float, row)) for row in 40 * dice.normal(size=(3, dim)))
    return kt.NodalForce(node=node, times=(0.0, 0.4, 1.0), forces=rows)


def frame(dice: Dice) -> kt.Model:
    """A portal of beams with a strut and a cable: clamps, pins, releases, hinges about an axis, damping, rigid ones."""
    dim = int(dice.integers(2, 4))
    at: dict[str, tuple[float, ...]] = {
        "A": (0, 0, 0),
        "B": (0, 0, 1),
        "C": (1.2, 0.1, 1.1),
        "D": (1.3, 0, 0),
        "E": (0.6, 0.7, 0.5),
    }
    if dim == 2:
        at = {name: (x, z) for name, (x, _, z) in at.items() if name != "E"}
    beams: dict[str, Any] = {}
    for name, ends in (("left", ("A", "B")), ("top", ("B", "C")), ("right", ("D", "C"))):
        more: dict[str, Any] = {"section": SECTIONS[int(dice.integers(3))]}
        if _some(dice, 0.2):
            more["kind"] = "rigid"
        elif _some(dice, 0.4):
            more["damping"] = float(dice.uniform(1e-4, 1e-2))
        if name != "left" and _some(dice, 0.5):
            more |= {"release": (ends[1],)} if dim == 2 or _some(dice, 0.2) else {"hinges": {ends[1]: int(dice.integers(2, 4))}}
        if dim == 3 and _some(dice, 0.3):
            more["orientation"] = tuple(map(float, dice.normal(size=3)))
        if _some(dice, 0.3):
            more["mass"] = float(dice.uniform(0.5, 3.0))
        beams[name] = kt.Beam(ends=ends, **more)
    bars: dict[str, Any] = {"strut": kt.Bar(ends=("A", "C"), kind="elastic", section=kt.Rod(diameter=0.01), damping=2.0)}
    if dim == 3:
        bars["guy"] = kt.Bar(ends=("E", "B"), kind="cable", stiffness=2e4, pretension=30.0)
    fixed = ["E"] * (dim == 3) + ["D"] * _some(dice, 0.5)
    return kt.Model(
        nodes=_near(dice, at),
        clamped=["A"] if "D" in fixed else ["A", "D"],
        fixed=fixed,
        beams=beams,
        bars=bars,
        material=STEEL,
        gravity=tuple(map(float, 5 * dice.normal(size=dim))),
        loads={"push": _force(dice, "C", dim), "side": _force(dice, "B", dim)},
    )


def _four_bar(dice: Dice, **fields: Any) -> kt.Model:
    """A crank and a rocker in the plane with what is between and at them, driven at the crank and pushed."""
    at = {"O": (0, 0), "A": (0.15, 0.25), "B": (0.95, 0.45), "Q": (1.05, 0)}
    return kt.Model(
        nodes=_near(dice, at),
        fixed=["O", "Q"],
        section=SECTIONS[int(dice.integers(3))],
        material=STEEL,
        drives={"motor": kt.AngleDrive("crank")},
        gravity=(0, -9.81),
        loads={"push": _force(dice, "B", 2)},
        **fields,
    )


def driven_frame(dice: Dice) -> kt.Model:
    """A four-bar whose coupler is an elastic beam: a beam in given motion."""
    beam = kt.Beam(ends=("A", "B"), release=("A", "B"), damping=1e-3 * _some(dice, 0.5))
    return _four_bar(dice, bars={"crank": ("O", "A"), "rocker": ("B", "Q")}, beams={"coupler": beam})


def rubbing(dice: Dice) -> kt.Model:
    """A four-bar with friction in its bearings, a hub that clamps the rocker, or both."""
    bearings = {
        "b": kt.Bearing(member="coupler", node="A", radius=0.02, friction=float(dice.uniform(0.05, 0.3))),
        "q": kt.Bearing(member="rocker", node="Q", radius=0.03, friction=0.15, slip=0.02),
    }
    hubs: dict[str, Any] = {}
    if _some(dice, 0.5):
        hubs["B"] = kt.Hub(arms={"coupler": (0.03, 0.02)}, clamped=["rocker"])
    else:
        bearings["a"] = kt.Bearing(member="coupler", node="B", radius=0.02, friction=0.1, against="rocker")
    rubs = {} if hubs and _some(dice, 0.3) else bearings
    bars = {"crank": ("O", "A"), "coupler": ("A", "B"), "rocker": ("B", "Q")}
    return _four_bar(dice, bars=bars, hubs=hubs, bearings=rubs)


def hinged_hubs(dice: Dice) -> kt.Model:
    """A crank and a link on hubs in space whose hinges have any axis, driven, with friction or a spring in the second."""
    at = {"O": (0, 0, 0), "K": (0.5, 0, 0.1), "T": (0.8, 0.5, 0.3)}
    axis = tuple(map(float, dice.normal(size=3) + np.array([0, 0, 2])))
    hubs = {
        "O": kt.Hub(arms={"crank": (0, 0, 0.05)}, hinges={"crank": "z"}),
        "K": kt.Hub(arms={"link": (0.03, 0.04, 0.0)}, hinges={"link": axis}, clamped=["crank"]),
    }
    rub = {"b": kt.Bearing(member="link", node="K", radius=0.02, friction=0.2)} if _some(dice, 0.5) else {}
    return kt.Model(
        nodes=_near(dice, at),
        fixed=["O"],
        bars={"crank": ("O", "K"), "link": ("K", "T")},
        hubs=hubs,
        bearings=rub,
        section=kt.Rod(diameter=0.03),
        material=STEEL,
        drives={"motor": kt.AngleDrive("crank", axis="z")},
        gravity=(0, 0, -9.81),
        loads={"push": _force(dice, "T", 3)},
    )


def sprung(dice: Dice) -> kt.Model:
    """Two links in the plane with springs of every law on hinges, coordinates and sums; some coupled, some driven."""
    hinge = lambda axis, start, end: kt.HingeDrive(axis=axis, start=start, end=end)  # noqa: E731
    springs = {
        "root": kt.Spring(coordinate=hinge("O", "G", "A"), stiffness=20, rest=0.3, damping=1.0, friction=0.5, slip=0.05),
        "elbow": kt.Spring(coordinate=hinge("A", "O", "B"), stiffness=8, damping=0.2, play=0.1),
        "height": kt.Spring(coordinate=kt.CoordinateDrive(node="B", axis="y"), table=((-1, -5), (0, 0), (0.5, 3), (1, 20))),
        "sum": kt.Spring(terms=((kt.AngleDrive("a"), 1.0), (kt.AngleDrive("b"), -2.0)), stiffness=2.0, preload=0.7),
        "tilt": kt.Spring(coordinate=kt.AngleDrive("a"), stiffness=3.0, rest=0.4),
        "tie": kt.Spring(coordinate=kt.LengthDrive("c"), stiffness=50.0, damping=0.3),
    }
    chosen = {name: springs[name] for name in dice.permutation(list(springs))[: int(dice.integers(2, 6))]}
    way = int(dice.integers(3))
    drives = {"motor": kt.AngleDrive("a")} if way == 0 else {}
    couplings = {"gear": kt.Coupling(terms=((kt.AngleDrive("a"), 1.0), (kt.AngleDrive("b"), 2.0)))} if way == 1 else {}
    return kt.Model(
        nodes=_near(dice, {"O": (0, 0), "G": (1, 0), "A": (0.6, 0.8), "B": (1.5, 1.3)}),
        fixed=["O", "G"],
        gravity=(0, -9.81),
        bars={
            "a": kt.Bar(ends=("O", "A"), mass=1.0),
            "b": kt.Bar(ends=("A", "B"), mass=0.5),
            "c": kt.Bar(ends=("G", "B"), kind="free"),
        },
        springs=chosen,
        drives=drives,
        couplings=couplings,
        loads={"push": _force(dice, "B", 2)},
    )


def hinged_arm(dice: Dice) -> kt.Model:
    """Two links in space: the first turns about z, the second about an axis that the first carries; with springs, or driven."""
    at = {"O": (0, 0, 0), "T": (0, 0, 1), "F": (1, 0, 0), "S": (0.9, 0.1, 0.4), "R": (0.8, 0.7, 0.6), "P": (1.6, 0.5, 0.2)}
    pairs = (("O", "S"), ("O", "R"), ("T", "S"), ("T", "R"), ("S", "R"), ("S", "P"), ("R", "P"))
    base = kt.HingeDrive(axis=("O", "T"), start="F", end="S")
    elbow = kt.HingeDrive(axis=("S", "R"), start="O", end="P")
    springs = {"fold": kt.Spring(coordinate=elbow, stiffness=30.0, damping=0.4, friction=0.3)} if _some(dice, 0.5) else {}
    return kt.Model(
        nodes=_near(dice, at),
        fixed=["O", "T", "F"],
        bars={a + b: kt.Bar(ends=(a, b), mass=0.2) for a, b in pairs},
        drives={"base": base} | ({} if springs else {"elbow": elbow}),
        springs=springs,
        gravity=(0, 0, -9.81),
        loads={"push": _force(dice, "P", 3)},
    )


def turned(dice: Dice) -> kt.Model:
    """A web on a base that turns, evenly or not, with the gravity of a condition."""
    model = (planar_web if _some(dice, 0.5) else spatial_web)(dice)
    size = 1 if model.dim == 2 else 3
    spin, more = (tuple(map(float, dice.normal(size=size))) for _ in range(2))
    base = kt.BaseRotation(angular_velocity=list(spin), angular_acceleration=list(more) if _some(dice, 0.5) else None)
    gravity = {"gravity": tuple(map(float, 3 * dice.normal(size=model.dim)))} if _some(dice, 0.5) else {}
    return kt.under(model, kt.Condition(base_rotation=base, **gravity))


def conditioned(dice: Dice) -> kt.Model:
    """A redundant truss under a condition: warmer, laden, a bar failed."""
    at = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1), "E": (2, 0.1), "F": (2, 1.2)}
    pairs = ("AB", "BC", "CD", "DA", "AC", "BD", "BE", "CF", "EF", "BF", "CE")
    steel = kt.Material(E=210e9, density=7850.0, yield_strength=235e6, thermal_expansion=1.2e-5)
    model = kt.Model(
        nodes=_near(dice, at),
        fixed=["A", "D"],
        section=kt.Tube(outer=0.03, inner=0.026),
        material=steel,
        gravity=(0, -9.81),
        bars={pair: kt.Bar(ends=tuple(pair), kind="elastic") for pair in pairs},
        loads={"push": _force(dice, "F", 2)},
    )
    options: list[dict[str, Any]] = [
        {"temperature": 60.0},
        {"temperatures": {"AC": 30.0, "BF": -10.0}},
        {"payloads": {"F": 8.0}},
        {"failed": ("CE",)},
        {"temperature": -20.0, "payloads": {"E": 3.0}, "failed": ("BD",)},
    ]
    return kt.under(model, kt.Condition(**options[int(dice.integers(len(options)))]))


FRAMES = {
    "frame": frame,
    "driven frame": driven_frame,
    "rubbing": rubbing,
    "hinged hubs": hinged_hubs,
    "sprung": sprung,
    "hinged arm": hinged_arm,
    "conditioned": conditioned,
}
