"""Models that load or drive bars in every way there is, of random size; each with the moves of its drives."""

import numpy as np

import kinetruss as kt

STEEL = {"section": kt.Rod(diameter=0.02), "material": kt.library.materials.STEEL_S235}


def ends(rng, a, b):
    return (a, b) if rng.random() < 0.5 else (b, a)


def bar(rng, a, b, **more):
    mass = {} if "kind" in more else {"mass": rng.uniform(0.5, 2.0), "rotary_inertia": bool(rng.random() < 0.5)}
    return kt.Bar(ends=ends(rng, a, b), **mass | more)


def plane(rng, **fields):
    return kt.Model(**({"gravity": tuple(5 * rng.normal(size=2))} | STEEL | fields))


def crank(rng, **more):
    """A bar on a fixed pin, its free end loaded and heavy."""
    tip = kt.Node(at=tuple(rng.uniform(0.4, 1.0, 2)), mass=rng.uniform(0.1, 1.0))
    fields = {"nodes": {"O": (0, 0), "A": tip, "G": (0.1, -1)}, "fixed": ["O", "G"], "bars": {"crank": bar(rng, "O", "A")},
              "loads": {"tip": kt.NodalForce(node="A", force=tuple(9 * rng.normal(size=2)))}}  # fmt: skip
    return plane(rng, **fields | more)


def by_angle(rng):
    return crank(rng, drives={"motor": kt.AngleDrive("crank")})


def by_hinge(rng):
    start, end = ends(rng, "G", "A")
    return crank(rng, drives={"motor": kt.HingeDrive(axis="O", start=start, end=end)})


def clamped(rng):
    place = tuple(rng.uniform(0.1, 0.6, 2))
    body = kt.Body(nodes=ends(rng, "O", "A"), mass=rng.uniform(1, 3), center=place, inertia=rng.uniform(0, 0.3))
    return crank(rng, drives={"motor": kt.AngleDrive("crank")}, bodies={"clamp": body})


def covered(rng):
    """A body without a centre, spread along its bar."""
    body = kt.Body(nodes=ends(rng, "O", "A"), mass=rng.uniform(1, 3))
    return crank(rng, drives={"motor": kt.AngleDrive("crank")}, bodies={"cover": body})


def loaded(rng):
    force = {"force": tuple(8 * rng.normal(size=2)), "follows": bool(rng.random() < 0.5)}
    loads = {
        "wind": kt.BodyForce(body="crank", at=(rng.uniform(0.1, 0.5), rng.normal() * 0.2), **force),
        "middle": kt.BodyForce(body="crank", **force),
        "twist": kt.BodyCouple(body="crank", moment=rng.normal()),
        "gas": kt.Pressure(face=ends(rng, "O", "A"), pressure=rng.uniform(10, 90), depth=0.1),
    }
    return crank(rng, drives={"motor": kt.AngleDrive("crank")}, loads=loads)


def loaded_along(rng):
    """Forces and couples along parts of a bar and at places of it."""
    low, high = np.sort(rng.uniform(0.0, 0.5, 2))
    span = {"member": "crank", "start": low, "end": high + 0.05}
    loads = {
        "along": kt.MemberLoad(**span, force=tuple(20 * rng.normal(size=2)), shape=(1, rng.normal()), axes="member"),
        "snow": kt.MemberLoad(member="crank", force=(0, -9.0), start="40 %", per="projection"),
        "drag": kt.MemberCouple(**span, moment=rng.normal(), shape=(1, 0.3)),
        "push": kt.MemberPointForce(member="crank", force=tuple(8 * rng.normal(size=2)), at="36 %"),
        "twist": kt.MemberPointCouple(member="crank", moment=rng.normal(), at="61 %"),
    }
    return crank(rng, drives={"motor": kt.AngleDrive("crank")}, loads=loads)


def polar(rng):
    """Length and angle of one bar are driven."""
    bars = {"crank": bar(rng, "O", "A", kind="driven", mass=1.5)}
    return crank(rng, bars=bars, drives={"motor": kt.AngleDrive("crank"), "out": kt.LengthDrive("crank")})


def telescope(rng):
    rods = {"base": kt.Part(length=0.5, mass=1.2), "tube": kt.Part(length=0.4, mass=0.7, rotary_inertia=True)}
    active = {"leg": kt.Active(ends=ends(rng, "O", "A"), **rods)}
    return crank(rng, bars={}, active=active, drives={"motor": kt.AngleDrive("leg")})


def loaded_telescope(rng):
    """A telescope with masses on its rods, on either side of the nut."""
    model = telescope(rng)
    leg, at = model.active["leg"], (0.0, 0.2, 0.49)
    rods = {
        "base": leg.base.with_(masses=[{"at": place, "mass": rng.uniform(0.2, 1)} for place in at]),
        "tube": leg.tube.with_(masses=[{"at": 0.7 * place, "mass": rng.uniform(0.2, 1)} for place in at]),
    }
    return model.with_(active={"leg": leg.with_(**rods)})


def telescope_under_a_load(rng):
    """The same with forces along the whole of it."""
    loads = {
        "along": kt.MemberLoad(member="leg", force=tuple(9 * rng.normal(size=2)), shape=(1, 0.2), axes="member"),
        "ice": kt.MemberLoad(member="leg", force=(1.0, -9.0)),
    }
    return loaded_telescope(rng).with_(loads=loads)


def chain(rng):
    """Three links: a motor at the base, two at elbows that react on the link before."""
    x = np.cumsum(rng.uniform(0.3, 0.8, (4, 2)) * [[1, 1], [1, -1], [1, 1], [1, -1]], axis=0)
    nodes = {name: kt.Node(at=tuple(place), mass=rng.uniform(0, 0.5)) for name, place in zip("OEFT", x, strict=True)}
    bars = {"upper": bar(rng, "O", "E"), "fore": bar(rng, "E", "F"), "hand": bar(rng, "F", "T")}
    wrist = kt.AngleDrive("hand") if rng.random() < 0.5 else kt.HingeDrive(axis="F", start="T", end="E")
    drives = {"shoulder": kt.AngleDrive("upper"), "elbow": kt.HingeDrive(axis="E", start="O", end="F"), "wrist": wrist}
    return plane(rng, nodes=nodes, fixed=["O"], bars=bars, drives=drives)


def gears(rng):
    """Two arms geared at their pins, the first one driven; a third couples by a hinge between the two."""
    nodes = {"O": (0, 0), "A": (0.7, 0.2), "P": (1.5, 0), "B": (1.9, 0.6), "C": (2.2, 0.3)}
    bars = {"one": bar(rng, "O", "A"), "two": bar(rng, "P", "B"), "three": bar(rng, "B", "C")}
    mesh = kt.Coupling(terms=((kt.AngleDrive("one"), 2.0), (kt.AngleDrive("two"), 3.0)))
    follow = kt.Coupling(terms=((kt.HingeDrive(axis="B", start="P", end="C"), 1.0), (kt.AngleDrive("one"), -2.0)))
    drives = {"motor": kt.AngleDrive("one")}
    return plane(rng, nodes=nodes, fixed=["O", "P"], bars=bars, couplings={"mesh": mesh, "follow": follow}, drives=drives)


def _scissor():
    nodes = {"A": (0, 0), "B": (1, 0), "C": (1.1, 0.8), "D": (-0.1, 0.8)}
    return nodes, {"drives": {"push": kt.CoordinateDrive(node="B", axis="x")}, "fixed": {"A": "xy", "B": "y"},
                   "loads": {"top": kt.NodalForce(node="D", force=(3.0, -80.0))}}  # fmt: skip


def scissor_by_coordinates(rng):
    """The pin of two arms as a coupling of their four ends."""
    nodes, more = _scissor()
    s = _crossing(nodes)
    bars = {"ac": bar(rng, "A", "C"), "bd": bar(rng, "B", "D")}
    couplings = {
        f"pin_{axis}": kt.Coupling(terms=tuple(
            (kt.CoordinateDrive(node=node, axis=axis), factor)
            for node, factor in zip("ACBD", (1 - s[0], s[0], s[1] - 1, -s[1]), strict=True)
        ))
        for axis in "xy"
    }  # fmt: skip
    return plane(rng, nodes=nodes, bars=bars, couplings=couplings, **more)


def _crossing(nodes):
    """Fractions of AC and BD at which they cross."""
    A, B, C, D = (np.array(nodes[name]) for name in "ABCD")
    return np.linalg.solve(np.stack([C - A, B - D], axis=1), B - A)


def scissor_by_a_node(rng):
    """A node kept on one arm by its coordinates; the other arm is two bars that an angle keeps straight."""
    nodes, more = _scissor()
    s = _crossing(nodes)
    nodes["P"] = tuple((1 - s[0]) * np.array(nodes["A"]) + s[0] * np.array(nodes["C"]))
    bars = {"ac": bar(rng, "A", "C"), "bp": bar(rng, "B", "P"), "pd": bar(rng, "P", "D")}
    couplings = {
        f"pin_{axis}": kt.Coupling(terms=tuple(
            (kt.CoordinateDrive(node=node, axis=axis), factor)
            for node, factor in zip("PAC", (1.0, s[0] - 1, -s[0]), strict=True)
        ))
        for axis in "xy"
    } | {"straight": kt.Coupling(terms=((kt.HingeDrive(axis="P", start="B", end="D"), 1.0),))}  # fmt: skip
    return plane(rng, nodes=nodes, bars=bars, couplings=couplings, **more)


def slotted(rng):
    """A crank whose pin slides along a lever, also where it leads beyond the lever's end."""
    nodes = {"O": (0, 0), "P": (0.2, 0.35), "G": (0, -0.6)}
    nodes["L"] = tuple(np.array(nodes["G"]) + rng.choice([0.7, 1.4]) * (np.array(nodes["P"]) - np.array(nodes["G"])))
    bars = {"crank": bar(rng, "O", "P"), "lever": bar(rng, "G", "L")}
    slot = kt.Coupling(terms=((kt.OffsetCoordinate(line=ends(rng, "G", "L"), point="P"), 1.0),), value=0.0)
    drives = {"motor": kt.AngleDrive("crank")}
    return plane(rng, nodes=nodes, fixed=["O", "G"], bars=bars, couplings={"slot": slot}, drives=drives)


def beam_in_two(rng):
    """Two bars that an offset keeps in line: a beam with a node on it."""
    nodes = {"O": (0, 0), "M": kt.Node(at=(0.5, 0.4), mass=2.0), "A": (1.25, 1.0)}
    bars = {"near": bar(rng, "O", "M"), "far": bar(rng, "M", "A")}
    line = kt.Coupling(terms=((kt.OffsetCoordinate(line=("O", "A"), point="M"), 1.0),))
    return plane(rng, nodes=nodes, fixed=["O"], bars=bars, couplings={"line": line}, drives={"motor": kt.AngleDrive("near")})


def screw(rng):
    """A bar whose length is coupled to the angle of a crank: it pulls as the coupling asks."""
    nodes = {"O": (0, 0), "A": (0.5, 0.1), "G": (-0.3, 0.9), "T": kt.Node(at=(0.2, 1.3), mass=1.0), "H": (0.9, 1.2)}
    bars = {"crank": bar(rng, "O", "A"), "strut": bar(rng, "G", "T", kind="free", mass=0.4), "stay": bar(rng, "H", "T")}
    pair = kt.Coupling(terms=((kt.LengthDrive("strut"), 1.0), (kt.AngleDrive("crank"), -0.1)))
    drives = {"motor": kt.AngleDrive("crank")}
    return plane(rng, nodes=nodes, fixed=["O", "G", "H"], bars=bars, couplings={"pair": pair}, drives=drives)


def shaken(rng):
    """A motor on a support that moves."""
    model = chain(rng)
    times = tuple(np.linspace(0, 1, 11))
    moved = tuple(tuple(row) for row in 0.02 * np.sin(3 * np.array(times))[:, None] * rng.normal(size=2))
    return model.with_(support_motion={"O": kt.History(times=times, displacements=moved)})


def space(rng, **fields):
    return kt.Model(**({"gravity": tuple(5 * rng.normal(size=3))} | STEEL | fields))


def door(rng):
    """A panel of two bars about a slanted axis of two nodes, at the foot of neither."""
    far = kt.Node(at=tuple(rng.uniform(0.3, 0.9, 3)), mass=1.0)
    nodes = {"A": (0, 0, 0), "B": (0.1, 0.2, 1), "S": (0.3, -1, 0.2), "C": far}
    bars = {"low": bar(rng, "A", "C"), "high": bar(rng, "B", "C")}
    turn = kt.HingeDrive(axis=ends(rng, "A", "B"), start=ends(rng, "S", "C")[0], end="C")
    if turn.start == turn.end:
        turn = kt.HingeDrive(axis=turn.axis, start="C", end="S")
    return space(rng, nodes=nodes, fixed=["A", "B", "S"], bars=bars, drives={"turn": turn})


def elbow(rng):
    """A second panel hinged on the first along one of its edges."""
    model = door(rng)
    nodes = dict(model.nodes) | {"D": kt.Node(at=tuple(rng.uniform(0.8, 1.4, 3)), mass=0.5)}
    bars = dict(model.bars) | {"near": bar(rng, "C", "D"), "far": bar(rng, "B", "D")}
    drives = dict(model.drives) | {"elbow": kt.HingeDrive(axis=("B", "C"), start="A", end="D")}
    return model.with_(nodes=nodes, bars=bars, drives=drives)


def about_an_axis(rng):
    """A bar turned about a fixed axis that it does not stand across, held by another bar."""
    nodes = {"O": (0, 0, 0), "S": (0.1, 1, 0.2), "A": kt.Node(at=(0.9, 0.1, 0.3), mass=1.0)}
    bars = {"arm": bar(rng, "O", "A"), "side": bar(rng, "S", "A")}
    axis = tuple(rng.normal(size=3) + np.array([0, 3, 0]))
    return space(rng, nodes=nodes, fixed=["O", "S"], bars=bars, drives={"motor": kt.AngleDrive("arm", axis=axis)})


def clamped_in_space(rng):
    nodes = {"P": (0, 0, 0), "Q": (1, 0, 0), "R": (0, 1, 0), "T": kt.Node(at=(0.3, 0.4, 0.9), mass=0.5)}
    bars = {name: bar(rng, name, "T", kind="driven", mass=0.6) for name in "PQR"}
    bars["Q"] = bar(rng, "Q", "T")
    at = tuple(np.array(nodes["Q"]) + rng.uniform(0.1, 0.9) * (np.array([0.3, 0.4, 0.9]) - np.array(nodes["Q"])))
    body = kt.Body(nodes=ends(rng, "Q", "T"), mass=2.0, center=at, inertia=[0, 0, 0])
    return space(rng, nodes=nodes, fixed=["P", "Q", "R"], bars=bars, bodies={"clamp": body})


WAYS = (
    by_angle, by_hinge, clamped, covered, loaded, polar, telescope, chain, gears, scissor_by_coordinates, scissor_by_a_node,
    slotted, beam_in_two, screw, shaken, door, elbow, about_an_axis, clamped_in_space,
)  # fmt: skip


def moved(model, rng, samples=4):
    """A motion of all drives by up to a tenth, and its forces."""
    from kinetruss.mechanics import compile  # here: the models above serve revisions that have it elsewhere

    start = compile(model).drive_start
    moves = {name: (start[k], start[k] + 0.1 * rng.uniform(-1, 1)) for k, name in enumerate(model.all_drives)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=samples)
    return kt.dynamics.inverse(model, motion)
