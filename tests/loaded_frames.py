"""Frames under loads, whose section forces are drawn."""

from itertools import pairwise

import kinetruss as kt

WIDE, HIGH, LONG, LOAD = 0.1, 0.2, 4.0, 10e3
MATTER = {"section": kt.Rectangle(width=WIDE, height=HIGH), "material": "steel_s235", "gravity": (0, 0)}
EI = 210e9 * WIDE * HIGH**3 / 12
REST = {"rest": kt.Run(analysis="statics.linear")}


def simple(**changes) -> kt.Model:
    """A beam on a pin and a roller under a uniform load: w L^2/8 in the middle."""
    given = {
        "nodes": {"A": (0, 0), "B": (LONG, 0)},
        "beams": {"beam": ("A", "B")},
        "supports": {"A": kt.Support(x="held", y="held"), "B": kt.Support(y="held")},
        "loads": {"q": kt.MemberLoad(member="beam", force=(0, -LOAD))},
        "runs": REST,
    }
    return kt.Model(**MATTER | given | changes)


def portal() -> kt.Model:
    """A portal frame, clamped at A and elastically at D, in two load cases."""
    return kt.Model(
        **MATTER, title="Portal frame",
        nodes={"A": (0, 0), "B": (0, 4), "C": (6, 4), "D": (6, 0)},
        beams={"left": ("A", "B"), "rafter": ("B", "C"), "right": ("D", "C")},
        supports={
            "A": kt.Support(x="held", y="held", rotation="held"),
            "D": kt.Support(x="held", y="held", rotation="2 MN m/rad"),
        },
        loads={"q": kt.MemberLoad(member="rafter", force=(0, -12e3)), "H": kt.NodalForce(node="B", force=(15e3, 0))},
        load_cases={"snow": kt.LoadCase(loads={"q": 1}), "wind": kt.LoadCase(loads={"H": 1})},
        runs={"rest": kt.Run(analysis="statics.linear", load_cases=["snow", "wind"])},
    )  # fmt: skip


def space() -> kt.Model:
    """A frame in space that bends about both axes and twists."""
    return kt.Model(
        **MATTER | {"gravity": (0, 0, 0)},
        nodes={"A": (0, 0, 0), "B": (0, 0, 3), "C": (4, 0, 3), "D": (4, 3, 3), "E": (4, 3, 0)},
        beams={"ab": ("A", "B"), "bc": ("B", "C"), "cd": ("C", "D"), "de": ("D", "E")},
        clamped=["A", "E"],
        loads={"P": kt.NodalForce(node="C", force=(0, 6e3, -20e3)), "q": kt.MemberLoad(member="cd", force=(0, 0, -5e3))},
        runs=REST,
    )


def every_support() -> kt.Model:
    """A row of beams with a support of every kind."""
    names = "ABCDEFGHI"
    soft, contact = "50 kN m/rad", "1 MN/mm"
    return kt.Model(
        **MATTER,
        nodes={name: (2.0 * k, 0.0) for k, name in enumerate(names)},
        beams={f"b{a}": (a, b) for a, b in pairwise(names)},
        supports={
            "A": kt.Support(x="held", y="held", rotation="held"),
            "B": kt.Support(y="held"),
            "C": kt.Support(y="2 kN/mm", rotation=soft),
            "D": kt.Support(y="held", turned="30 deg"),
            "E": kt.Support(y={"stiffness": contact, "gap": (0, None)}),
            "F": kt.Support(x="held", y={"settlement": "-5 mm"}),
            "G": kt.Support(y="held", rotation="held"),
            "H": kt.Support(y={"stiffness": contact, "gap": "2 mm"}),
            "I": kt.Support(rotation={"stiffness": soft, "gap": "1 mrad"}),
        },
        loads={"P": kt.NodalForce(node="I", force=(0, -1e3))},
        runs=REST,
    )
