"""Every tool of the palette, in the plane and in space, by mouse, keys, menu and finger: it does what it says or says why."""

from __future__ import annotations

from typing import Any, NamedTuple

import pytest

from hand import Hand, drawn

pytestmark = pytest.mark.slow

PLACES = {"A": (0.0, 0.0), "B": (0.4, 0.0), "C": (0.4, 0.3), "D": (0.2, 0.0), "E": (0.2, 0.3)}
BARS = {"b1": "AB", "b2": "BC", "b3": "DE"}
HEIGHT = 0.1
"""Of all nodes in space, and of the work plane: not that of the start."""
B1, B2, B3 = (0.1, 0.0), (0.4, 0.1), (0.2, 0.1)
"""Places on the bars."""
FREE, NOWHERE = (0.1, 0.2), (0.3, 0.2)
"""Places where nothing is."""

Place = str | tuple[float, float]


class Use(NamedTuple):
    """One use of a tool: what it is given, and what of the data is another afterwards.

    pull : the first two are given by a pull. made : path -> value in the data, in space `space` if that is another.
    again : whether the same once more takes it back.
    """

    tool: str
    given: tuple[Place, ...]
    made: dict[str, Any]
    space: dict[str, Any] | None = None
    pull: bool = False
    again: bool = False


def offset(**way: str) -> dict[str, Any]:
    return {"terms": [[{"kind": "offset", "line": ["A", "B"], "point": "D", **way}, 1]], "value": 0}


def about(bar: str, **axis: str) -> dict[str, str]:
    return {"kind": "angle", "bar": bar, **axis}


HINGE = {"kind": "hinge", "axis": ["B"], "start": "A", "end": "C"}
USES = (
    Use("node", (FREE,), {"nodes.F": [0.1, 0.2]}, {"nodes.F": [0.1, 0.2, HEIGHT]}),
    Use("bar", ("C", FREE), {"bars.b4": ["C", "F"]}),
    Use("link", ("C", "E", FREE, FREE), {"links.link1": ["C", "E", "F"]}),
    Use("pin", ("C",), {"fixed.C": "xy"}, {"fixed.C": "xyz"}, again=True),
    Use("roller", ("C",), {"fixed.C": "y"}, {"fixed.C": "z"}, again=True),
    Use("roller", ("C", (0.5, 0.3)), {"fixed.C": "y"}, {"fixed.C": "yz"}, pull=True, again=True),
    Use("roller", ("E", (0.3, 0.4)), {"supports.E": {"y": "held", "turned": "45 deg"}},
        {"supports.E": {"along": [0.707106781187, 0.707106781187, 0], "y": "held", "z": "held"}}, pull=True, again=True),
    Use("clamp", ("A",), {"clamped": ["A"], "links.b1": {"nodes": ["A", "B"], "weld": ["A"]}}),
    Use("foot", ("C",), {"supports.C": {"x": "held", "y": "10 kN/m"}},
        {"supports.C": {"x": "held", "y": "held", "z": "10 kN/m"}}, again=True),
    Use("turn", (B2,), {"drives.motor": about("b2")}, {"drives.motor": about("b2", axis="z")}, again=True),
    Use("stroke", (B2,), {"bars.b2": {"ends": ["B", "C"], "kind": "driven"}}, again=True),
    Use("push", ("E",), {"drives.slide": {"kind": "coordinate", "node": "E", "axis": "x"}}, again=True),
    Use("cylinder", ("C", "E"), {"active.cylinder1.ends": ["C", "E"], "active.cylinder1.limits": [0.16, 0.28]}),
    Use("force", ("E", (0.3, 0.3)), {"loads.F_E.node": "E"}),
    Use("force", (B2, (0.5, 0.1)), {"loads.F_b2.member": "b2", "loads.F_b2.at": "33.3 %"}),
    Use("load", (B2, (0.5, 0.1)), {"loads.q_b2.member": "b2"}),
    Use("mass", ("C",), {"nodes.C.mass": "1 kg"}),
    Use("slider", ("D",), {"couplings": {"block": offset()}},
        {"couplings": {"block": offset(axis="z"), "block.along": offset(along="z")}}, again=True),
    Use("gear", (B2, B3), {"couplings.gear.terms": [[about("b2"), -1], [about("b3"), -1]]},
        {"couplings.gear.terms": [[about("b2", axis="z"), -1], [about("b3", axis="z"), -1]]}),
    Use("spring", ("C", "E"), {"bars.spring1": {"ends": ["C", "E"], "kind": "elastic", "stiffness": "1 kN/m"}}),
    Use("rope", ("C", "E"), {"bars.rope1": {"ends": ["C", "E"], "kind": "cable", "stiffness": "100 kN/m"}}),
    Use("hinge", (B2,), {"springs.spring1.coordinate": about("b2")}, {"springs.spring1.coordinate": about("b2", axis="z")}),
    Use("hinge", (B1, B2, "E"), {"springs.spring1.coordinate": HINGE},
        {"springs.spring1.coordinate": {**HINGE, "axis": ["B", "E"]}}, pull=True),
)  # fmt: skip
NODE, MEMBER = ("pin", "roller", "clamp", "foot", "push", "mass", "slider"), ("turn", "stroke", "load", "gear", "hinge")
REFUSED = (
    *((tool, (NOWHERE,), False, "a node is wanted here") for tool in NODE),
    *((tool, (NOWHERE,), False, "a bar, beam or link is wanted here") for tool in MEMBER),
    *((tool, (NOWHERE,), False, "a node or a bar is wanted here") for tool in ("force", "dimension")),
    *((tool, ("C", "C"), False, "two different places") for tool in ("bar", "spring", "rope", "cylinder")),
    ("link", ("C", "C", "C"), False, "two different places"),
    ("clamp", ("B",), False, "Nothing at B has a rotation to hold"),
    ("push", ("A",), False, "A is held in all directions"),
    ("slider", ("E", B3), True, "E is an end of b3"),
    ("gear", (B2, B2), False, "Gear wheels need two bars"),
    ("force", ("E", "E"), False, "Pull the arrow away"),
    ("load", (B2, B2), False, "Pull the arrow away"),
    ("hinge", (B2, B3, "A"), True, "Pick the two members that meet"),
    ("dimension", (B1, B3), True, "b1 and b3 do not meet"),
    ("dimension", ("C", "C"), False, "Pull from one node to another"),
)
LEFT = {"pick", "move", "dimension", "positions", "path"}
"""Tools that change places, or what belongs to the page."""
WAYS = ((2, "mouse"), (2, "keys"), (2, "finger"), (3, "mouse"), (3, "keys"), (3, "menu"))
FINGER = """(() => { const sheet = draw.canvas.node, [kinds, spots] = given;
  sheet.setPointerCapture = () => {};
  kinds.forEach((kind, k) => sheet.dispatchEvent(new PointerEvent(kind,
    { pointerType: 'touch', pointerId: 7, clientX: spots[k][0], clientY: spots[k][1], bubbles: true }))); })()"""
"""All at once: a finger that rests would open the menu."""


def text_of(dim: int) -> str:
    nodes = {name: [*place, *[HEIGHT] * (dim - 2)] for name, place in PLACES.items()}
    lines = ["kinetruss: 1", "nodes:", *[f"  {name}: {place}" for name, place in nodes.items()]]
    lines += [f"fixed: {{A: {'xyz'[:dim]}}}", "bars:", *[f"  {name}: [{a}, {b}]" for name, (a, b) in BARS.items()]]
    return "\n".join([*lines, ""])


class Way:
    """A drawing, and one way to give a tool what it wants."""

    def __init__(self, hand: Hand, dim: int, way: str) -> None:
        self.hand, self.dim, self.way = hand, dim, way
        self.keys = hand.js("Object.fromEntries([...draw.rail.tools.keys()].map((name) => [name, "
                            "draw.rail.tools.get(name).title.at(-2).toLowerCase()]))")  # fmt: skip
        self.words = hand.js("Object.fromEntries([...draw.rail.tools].map(([name, one]) => [name, one.textContent]))")
        self.anew()
        hand.js("draw.fit()")
        hand.write("grid step in m", "0.1")
        if dim == 3:
            hand.page.locator("svg.drawing").focus()
            hand.press("Shift+PageUp")
            assert hand.js("draw.camera.plane") == {"axis": 2, "at": HEIGHT}

    def anew(self) -> dict[str, Any]:
        """The drawing of the beginning."""
        self.hand.js("(draw.keyboard.escape(), draw.task.clear(), draw.setTool('pick'), draw.tell(''))")
        self.hand.js("draw.ask({ do: 'text', text: given })", text_of(self.dim))
        return self.data()

    def data(self) -> dict[str, Any]:
        return self.hand.state()["data"]

    def point(self, where: Place) -> tuple[float, ...]:
        return (*(PLACES[where] if isinstance(where, str) else where), *[HEIGHT] * (self.dim - 2))

    def spot(self, where: Place) -> tuple[float, float]:
        return self.hand.spot(self.point(where))

    def banner(self) -> str:
        return self.hand.js("draw.banner.hidden ? '' : draw.banner.textContent")

    def use(self, tool: str, given: tuple[Place, ...], pull: bool = False) -> None:
        """Give a tool what it wants."""
        if self.way == "keys":
            self.by_keys(tool, given, pull)
        elif self.way == "menu":
            self.by_menu(tool, given)
        else:
            self.hand.js("draw.setTool(given)", tool)
            if pull:
                self.pulled(given[0], given[1])
            for where in given[2 if pull else 0 :]:
                self.clicked(where)
        self.hand.settle()
        self.hand.js("(draw.value.close(false), draw.canvas.node.focus({ preventScroll: true }))")

    def by_keys(self, tool: str, given: tuple[Place, ...], pull: bool) -> None:
        hand = self.hand
        hand.page.locator("svg.drawing").focus()
        hand.press(self.keys[tool])
        for k, where in enumerate(given):
            if not hand.js("Boolean(draw.cursor)"):
                hand.press("ArrowRight")
            here, to = hand.js("draw.cursor"), self.point(where)
            for one, two, names in zip(here, to, (("ArrowLeft", "ArrowRight"), ("ArrowDown", "ArrowUp")), strict=False):
                steps = round((two - one) / 0.1)
                hand.press_at_once(*[names[steps > 0]] * abs(steps))
            hand.press("Shift+Enter" if pull and k == 0 else "Enter")

    def by_menu(self, tool: str, given: tuple[Place, ...]) -> None:
        self.hand.page.mouse.click(*self.spot(given[0]), button="right")
        self.hand.page.get_by_role("menuitem", name=self.words[tool], exact=True).click()
        self.hand.settle()
        for where in given[1:]:
            self.clicked(where)

    def clicked(self, where: Place) -> None:
        if self.way == "finger":
            self.hand.js(FINGER, [["pointerdown", "pointerup"], [self.spot(where)] * 2])
        else:
            self.hand.page.mouse.click(*self.spot(where))
        self.hand.settle()

    def pulled(self, first: Place, last: Place) -> None:
        if self.way == "finger":
            spots = [self.spot(first), self.spot(last), self.spot(last)]
            self.hand.js(FINGER, [["pointerdown", "pointermove", "pointerup"], spots])
            self.hand.settle()
        else:
            self.hand.pull(self.point(first), self.point(last))


def opened(show: Any, served: Any, dim: int, way: str) -> Way:
    return Way(drawn(show, served, width=1440, has_touch=way == "finger"), dim, way)


def value_at(data: Any, path: str) -> Any:
    for key in path.split("."):
        data = data[key]
    return data


@pytest.mark.parametrize(("dim", "way"), WAYS)
def test_every_tool_changes_the_model_as_it_says_or_says_why_not(show, served, dim, way):
    own = opened(show, served, dim, way)
    assert {use.tool for use in USES} | LEFT == set(own.keys)
    failed = []
    for use in USES:
        if way == "menu" and use.pull:
            continue  # a menu has no pull: what begins in it is done by a click
        before, given = own.anew(), use.given[: 2 if use.pull and dim == 2 else None]
        own.use(use.tool, given, use.pull)
        data, expected = own.data(), use.made if dim == 2 or use.space is None else use.space
        try:
            assert {path: value_at(data, path) for path in expected} == expected
            if use.again:
                own.use(use.tool, given, use.pull)
                assert own.data() == before
        except (AssertionError, KeyError) as error:
            failed.append((use.tool, given, repr(error)[:400], own.banner()))
    for tool, given, pull, words in () if way == "menu" else REFUSED:
        before = own.anew()
        own.use(tool, given[: 2 if pull and dim == 2 else None], pull)
        if words not in own.banner() or own.data() != before:
            failed.append((tool, given, words, own.banner()))
    assert not failed, failed
    assert (own.hand.shown.requests, own.hand.shown.complaints) == ([], [])


@pytest.mark.parametrize(("dim", "way"), [(2, "mouse"), (2, "keys"), (3, "mouse"), (3, "keys")])
def test_the_tools_of_the_page_itself(show, served, dim, way):
    own, up = opened(show, served, dim, way), [HEIGHT] * (dim - 2)
    own.anew()
    if way == "mouse":
        own.use("pick", ("C", (0.5, 0.4)), pull=True)
        assert own.data()["nodes"]["C"] == [0.5, 0.4, *up]
        own.anew()
        own.use("move", ("B", (0.3, 0.3)), pull=True)
    else:
        own.use("pick", ("C",))
        assert own.hand.js("[...draw.picked.nodes]") == ["C"]
        own.use("move", ("B",))
        own.hand.press("Shift+ArrowUp", "Enter")
    x, y, *z = own.data()["nodes"]["B"]
    assert (x**2 + y**2, z) == (pytest.approx(0.16), up)  # b1 keeps its length
    assert y > 0.05
    for given, pull, made in (((B2,), False, {"members": ["b2"]}), ((B1, B2), True, {"members": ["b1", "b2"]}),
                              (("C", "E"), False, {"nodes": ["C", "E"]})):  # fmt: skip
        own.anew()
        own.use("dimension", given, pull)
        assert own.hand.state()["dimensions"] == [made]
        own.use("dimension", given, pull)
        assert own.hand.state()["dimensions"] == []
    own.anew()
    if dim == 3:
        for tool in ("positions", "path"):
            own.hand.press(own.keys[tool])
            assert "in the plane" in own.banner()
            assert own.hand.js("draw.tool") == "pick"
        return
    own.use("positions", (FREE, NOWHERE), pull=way == "mouse")
    assert own.hand.js("draw.task.positions") == [[0.1, 0.2, 0]]
    own.use("path", (FREE, NOWHERE, B1), pull=way == "mouse")
    assert len(own.hand.js("draw.task.path")) >= 3
    assert (own.hand.shown.requests, own.hand.shown.complaints) == ([], [])


def test_in_space_axes_are_normals_of_the_work_plane_and_one_seen_edge_on_is_said_to_be(show, served):
    own = opened(show, served, 3, "mouse")
    hand = own.hand
    hand.choose("work plane", "1")  # x-z
    for tool, given in (("turn", (B2,)), ("gear", (B1, B2)), ("hinge", (B2,))):
        before = own.anew()
        own.use(tool, given)
        assert "b2 points along y" in own.banner()
        assert "choose another Plane" in own.banner()
        assert own.data() == before
    own.use("turn", (B1,))
    assert own.data()["drives"] == {"motor": about("b1", axis="y")}
    hand.choose("work plane", "2")
    own.use("gear", (B1, B2))
    assert own.data()["couplings"]["gear"]["terms"] == [[about("b1", axis="y"), -1], [about("b2", axis="z"), -1]]
    own.anew()
    for tool, given in (("hinge", (B1,)), ("spring", ("C", "E")), ("hinge", (B3,))):  # of which no two have one name
        own.use(tool, given)
    assert (list(own.data()["springs"]), list(own.data()["bars"])) == (["spring1", "spring3"], [*BARS, "spring2"])
    own.anew()
    hand.js("draw.camera.look('front')")
    hand.js("draw.canvas.update()")
    box = hand.page.locator("svg.drawing").bounding_box()
    for tool in ("node", "bar", "link", "spring", "rope", "cylinder"):
        hand.js("(draw.setTool(given), draw.tell(''))", tool)
        hand.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 3)
        assert "edge-on" in own.banner(), tool
    for tool, first in (("force", "E"), ("load", B3)):
        hand.js("(draw.setTool(given), draw.tell(''))", tool)
        hand.page.mouse.click(*own.spot(first))
        hand.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 3)
        assert "edge-on" in own.banner(), tool
    hand.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 3, button="right")
    hand.page.get_by_role("menuitem", name="Node", exact=True).click()
    assert "edge-on" in own.banner()
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
