"""Faults of a whole model: told at once, none of them twice, none that only follows from another."""

import pytest

import kinetruss as kt

PLANE = {"nodes": {"A": (0, 0), "B": (1, 0), "C": (0, 1)}, "fixed": ["A", "B"], "bars": {"ac": ("A", "C"), "bc": ("B", "C")}}
SPACE = {
    "nodes": {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0)},
    "fixed": ["A"],
    "bars": {"ab": ("A", "B"), "bc": ("B", "C")},
}
PART = {"length": 1, "mass": 1}
QUINTIC = {"kind": "quintic", "duration": 1}


def told(base, **changes):
    """The lines of all faults of a model."""
    try:
        kt.Model(**base | changes)
    except kt.ModelError as error:
        return str(error).splitlines()
    return []


def active(**changes):
    return {"M": {"ends": ("A", "B"), "base": PART, "tube": PART} | changes}


@pytest.mark.parametrize(
    ("base", "changes", "fault"),
    [
        (PLANE, {"gravity": (0, 0, -9.81)}, "gravity: has 3 components, the model has 2 axes. Give 2."),
        (PLANE, {"fixed": {"A": "xyz"}}, "fixed.A: fixes z in a planar model. Leave out z."),
        (PLANE, {"bars": {"a": {"ends": ("A", "B"), "orientation": "D"}}}, "bars.a.orientation: no node called 'D'."),
        (SPACE, {"bars": {"a": {"ends": ("A", "B"), "orientation": "B"}}}, "bars.a.orientation: is one of the bar's own ends."),
        (
            SPACE | {"nodes": SPACE["nodes"] | {"D": (3, 0, 0)}},
            {"bars": {"a": {"ends": ("A", "B"), "orientation": "D"}}},
            "bars.a.orientation: stands on the bar's line",
        ),
        (PLANE, {"bars": {"a": {"ends": ("A", "B"), "natural_length": 1}}}, "bars.a.natural_length: is given for a rigid bar."),
        (PLANE, {"bars": {"a": {"ends": ("A", "B"), "kind": "free", "length": 1}}}, "bars.a.length: is given for a free bar"),
        (PLANE, {"bars": {"a": {"ends": ("A", "B"), "rotary_inertia": True}}}, "bars.a.rotary_inertia: needs a section."),
        (
            SPACE,
            {
                "bars": {"a": {"ends": ("A", "B"), "rotary_inertia": True}},
                "section": kt.Rectangle(width=1, height=2),
            },
            "bars.a.rotary_inertia: needs a section with I2 = I3 in space.",
        ),
        (SPACE, {"active": active(base={"length": 1})}, "active.M.base: has no mass, and no section and no material"),
        (SPACE, {"active": active(gear="m")}, "active.M.gear: no gear called 'm'."),
        (SPACE, {"active": active(length=3, limits=(1, 2))}, "active.M.length: 3 m is outside the limits, 1 to 2 m."),
        (SPACE, {"active": active(), "bars": {"M": ("A", "B")}}, "active.M: 'M' is also the name of a bar."),
        (PLANE, {"loads": {"f": {"node": "C", "force": (1, 2, 3)}}}, "loads.f.force: has 3 components"),
        (
            PLANE,
            {"loads": {"f": {"node": "C", "times": (0, 1), "forces": ((1, 2), (1, 2, 3))}}},
            "loads.f.forces.1: has 3 components",
        ),
        (PLANE, {"loads": {"f": {"node": "C"}}}, "loads.f: has neither a force nor a table of forces."),
        (PLANE, {"load_cases": {"c": {"loads": {"f": 1}}}}, "load_cases.c.loads.f: no load called 'f'."),
        (PLANE, {"support_motion": {"D": {"times": (0, 1), "displacements": ((0, 0), (0, 0))}}}, "support_motion.D: no node"),
        (
            PLANE,
            {"support_motion": {"C": {"times": (0, 1), "displacements": ((0, 0), (0, 0))}}},
            'support_motion.C: is not a fixed node. Fix it first: fixed={"C": "xy"}.',
        ),
        (PLANE, {"drives": {"d": {"kind": "coordinate", "node": "C", "axis": "z"}}}, "drives.d.axis: is z in a planar model."),
        (SPACE, {"drives": {"d": kt.AngleDrive("ab")}}, "drives.d: drives an angle in space without an axis."),
        (
            PLANE | {"bars": {"f": {"ends": ("A", "C"), "kind": "free"}}},
            {"drives": {"d": kt.LengthDrive("f")}},
            "drives.d: drives the length of a free bar.",
        ),
        (SPACE, {"active": active(), "drives": {"M": kt.LengthDrive("bc")}}, "drives.M: is also the name of the driven member"),
        (
            PLANE | {"drives": {"d": kt.LengthDrive("ac")}},
            {"poses": {"p": {"base": 1, "longeron": 1, "drives": ("d", "e", "d")}}},
            "poses.p.drives.1: no drive called 'e'.",
        ),
    ],
)
def test_one_fault(base, changes, fault):
    (line,) = told(base, **changes)
    assert line.startswith(fault)


def test_own_drive_of_a_member_may_be_renamed():
    model = kt.Model(**SPACE | {"active": active(), "drives": {"extend": kt.LengthDrive("M")}})
    assert list(model.all_drives) == ["extend"]


def test_coincident_nodes_need_a_word():
    nodes = PLANE["nodes"] | {"D": (0, 1)}
    assert told(PLANE, nodes=nodes)[0].startswith("nodes.D: stands where node 'C' stands")
    assert '"coincident": True' in told(PLANE, nodes=nodes)[0]
    assert told(PLANE, nodes=nodes | {"D": {"at": (0, 1), "coincident": True}}) == []
    assert told(PLANE, nodes=nodes | {"C": {"at": (0, 1), "coincident": "true"}}) == []


def test_one_node_of_another_dimension_does_not_accuse_the_others():
    (line,) = told(PLANE, nodes={"A": (0, 5, 0), "B": (1, 0), "C": (0, 1)})
    assert line.startswith("nodes.A.at: has 3 coordinates, other nodes have 2.")


@pytest.mark.parametrize(
    ("changes", "places"),
    [
        # a faulty node is no unknown node
        ({"nodes": {"A": (0, 0), "B": (1, "x"), "C": (0, 1)}}, ["nodes.B.at.1"]),
        # a table that is faulty as a whole has lost all its names
        ({"bars": 5, "drives": {"d": kt.LengthDrive("ac")}}, ["bars"]),
        # nor is a bar that lost its kind no drive
        (
            {
                "bars": {"ac": {"ends": ("A", "C"), "kind": "drivn"}},
                "trajectories": {"t": QUINTIC | {"moves": {"ac": (1, 2)}}},
            },
            ["bars.ac.kind"],
        ),
        # faults of one entry beside each other: field, name, unknown key
        (
            {"bars": {"ac": {"ends": ("A", "Q"), "mass": "1 m", "color": 1}}},
            ["bars.ac.mass", "bars.ac.color", "bars.ac.ends.1"],
        ),
        # a needed field that is faulty does not hide the rest of its record
        (
            {"trajectories": {"t": QUINTIC | {"moves": {"q": (1, 2)}, "duration": "1 kg"}}},
            ["trajectories.t.duration", "trajectories.t.moves.q"],
        ),
        # what is elastic by a section that is faulty has a section
        (
            {
                "bars": {"ac": {"ends": ("A", "C"), "kind": "elastic", "section": "s"}},
                "material": {"E": 1, "density": 1},
                "sections": {"s": {"kind": "rod", "diameter": 0}},
            },
            ["sections.s.diameter"],
        ),
        # neither is an unknown section reported twice
        (
            {"bars": {"ac": {"ends": ("A", "C"), "kind": "elastic", "section": "s", "material": "m"}}},
            ["bars.ac.section", "bars.ac.material"],
        ),
        # a fixed list of unknown nodes
        ({"fixed": ["A", "Q", "R"]}, ["fixed.Q", "fixed.R"]),
        ({"nodes": {}}, ["nodes"]),
        ({"nodes": None}, ["nodes"]),
        # a list that is too short, of names that are none: what one fault takes out another cannot put back
        (
            {"poses": {"p": {"kind": "gimbal", "base": 1.2, "longeron": 0.9, "drives": ["0.9 m", "1.3 m"]}}},
            ["poses.p.drives.0", "poses.p.drives.1", "poses.p.drives"],
        ),
    ],
)
def test_all_at_once_and_none_that_only_follows(changes, places):
    assert [line.split(": ")[0] for line in told(PLANE, **changes)] == places


def test_names_of_two_members_come_in_the_order_of_the_file():
    names = [f"M{number}" for number in (7, 3, 9, 1, 8, 2, 6, 4)]
    lines = told(SPACE, active={name: active()["M"] for name in names}, bars=dict.fromkeys(reversed(names), ("A", "B")))
    assert [line.split(":")[0] for line in lines if "also the name of a bar" in line] == [f"active.{name}" for name in names]


def test_thousands_of_faults_are_found_in_a_moment():
    nodes = {f"n{i}": (i, 0) for i in range(2000)}
    bars = {f"b{i}": {"ends": (f"n{i}", f"n{i + 1}"), "mass": "1 m"} for i in range(1999)}
    lines = told({"nodes": nodes, "bars": bars})
    assert len(lines) == 201  # the text tells the first; all are data
    assert lines[-1] == "... and 1,799 faults more."


def test_every_fault_has_a_mend():
    with pytest.raises(kt.ModelError) as caught:
        kt.Model(
            nodes={"A": (0,), "B": 3}, fixed={"A": ""}, bars={"b": ()}, drives={"d": {}}, safety={"yielding": 0}, kinetruss=3
        )
    assert len(caught.value.faults) == 7
    assert all(fault.mend for fault in caught.value.faults)


@pytest.mark.slow
def test_thousands_of_faults_are_told_in_short():
    """All of them as data; the text tells the first. No table is copied for each."""
    stray = {f"k{k}": 1 for k in range(3000)}
    bars = {f"b{k}": {"ends": ["A", "B"], **stray} for k in range(5)}
    with pytest.raises(kt.ModelError) as caught:
        kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars=bars, fixed=["A"])
    assert len(caught.value.faults) == 15_000
    assert str(caught.value).endswith("... and 14,800 faults more.")
    assert len(str(caught.value)) < 50_000


ODD = [
    "x" * 10**6,
    "\x1b[31mred\x1b[0m",
    "a\nb",
    "\u202eABC",
    "\x07",
    b"\xff" * 10**6,
    [0] * 10**5,
    10**5000,
    {"a": "x" * 10**6},
]
QUOTING = {
    "end": lambda odd: kt.Bar(ends=("A", odd)),
    "kind": lambda odd: kt.Bar(ends=("A", "B"), kind=odd),
    "mass": lambda odd: kt.Bar(ends=("A", "B"), mass=odd),
    "axes": lambda odd: kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed={"A": odd}),
    "version": lambda odd: kt.Model(kinetruss=odd, nodes={"A": (0, 0)}),
    "name": lambda odd: kt.Model(
        nodes={"A": (0, 0), str(odd)[:9999] if odd != 10**5000 else "": (1, 0)}, bars={"b": ("A", "C")}
    ),
    "builder": lambda odd: kt.library.build(odd if isinstance(odd, str) else "x", {}),
    "field": lambda odd: kt.Node(at=(0, 0), **{odd if isinstance(odd, str) else "q": 1}),
    "tag": lambda odd: kt.Model(nodes={"A": (0, 0)}, section={"kind": odd if isinstance(odd, str) else "x"}),
}


@pytest.mark.parametrize("make", QUOTING.values(), ids=QUOTING)
def test_messages_are_short_and_can_be_printed(make):
    for odd in ODD:
        with pytest.raises(kt.ModelError) as caught:
            make(odd)
        for line in str(caught.value).split("\n"):
            assert line.isprintable()
            assert len(line) < 800
