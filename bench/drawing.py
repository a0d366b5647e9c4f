"""From an empty page to a mechanism that runs and has forces, by mouse: seconds, clicks, drags, words typed.

    python bench/drawing.py [--json] [--case WORD]

Each case is drawn in Chromium through a real studio by the hand of the browser tests (``tests/hands.py``), then played. At its
end it must play, and what holds its drive must be the virtual work of its load, from the closed form of the linkage (`error`,
relative). `script_s` is what the script takes, the answers of the studio included; `human_s` what a practised person would, by
the keystroke-level model of Card, Moran and Newell (Communications of the ACM 23, 1980): 0.28 s a key, 1.1 s to point at
something, 0.1 s for a press or a release of the button, 0.4 s for the hand from mouse to keys or back, and 1.35 s of thought
before every tool, button and word, but none before places, which belong to the tool.
"""

from __future__ import annotations

import argparse
import json
import math
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
from hands import Mouse
from served import WAIT, start

KEY, POINT, BUTTON, HOME, THOUGHT = 0.28, 1.1, 0.1, 0.4, 1.35  # s
STEP = 1e-5  # rad or m, of a difference
GRAVITY = 9.81  # m/s2
Heights = Callable[[float], dict[str, float]]  # of nodes, m, by the value of the drive
JANSEN = {
    "OM": 15, "MT": 50, "TL": 55.8, "LA": 39.4, "AF": 65.7, "FK": 49, "KA": 36.7, "TP": 41.5, "PK": 39.3,
    "KM": 61.9, "LP": 40.1,
}  # fmt: skip
"""Lengths of Theo Jansen's leg, mm (The Great Pretender, 010 Publishers, 2007): O axle, P pin, F foot."""
SKETCH = {
    "O": (40, 20), "M": (40, 30), "T": (10, 60), "L": (-30, 30), "A": (-20, -10), "F": (0, -70), "K": (10, -30), "P": (0, 10),
}  # fmt: skip
"""Where the nodes of Jansen's leg are clicked, mm: the lengths that are typed bring them to their places."""
OF_EXAMPLE = "O:O P:P M:A T:B K:C L:D A:E F:F"  # names of these nodes in the picture to begin with
FRAME = {"x": "2 mm", "y": "12.2 mm"}  # of P: 38 mm left of O and 7.8 mm below


class Page:
    """What a hand needs of a page."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def until(self, expression: str) -> None:
        end = time.monotonic() + WAIT
        while not self.page.evaluate(expression):
            assert time.monotonic() < end, f"never came true: {expression}"
            self.page.wait_for_timeout(20)


class Counted(Mouse):
    """A hand with a mouse that counts what it does."""

    def __init__(self, shown: Page) -> None:
        self.clicks = self.drags = self.keys = self.words = self.thoughts = self.homes = 0
        self.typing = False
        super().__init__(shown)

    def point(self, clicks: int, drags: int, thoughts: int = 0) -> None:
        self.clicks, self.drags, self.thoughts = self.clicks + clicks, self.drags + drags, self.thoughts + thoughts
        self.homes, self.typing = self.homes + self.typing, False

    def type(self, keys: int) -> None:
        self.words, self.thoughts, self.keys = self.words + 1, self.thoughts + 1, self.keys + keys
        self.homes, self.typing = self.homes + (not self.typing), True

    def click(self, where: Any, **more: Any) -> None:
        self.point(1, 0)
        super().click(where, **more)

    def pull(self, *way: Any) -> None:
        self.point(0, 1)
        super().pull(*way)

    def touch(self, locator: Any) -> None:
        self.point(1, 0, 1)
        super().touch(locator)

    def value(self, words: str) -> None:
        self.type(len(words) + 1)
        super().value(words)

    def write(self, label: str, words: str) -> None:
        super().write(label, words)
        self.type(len(words) + 3)  # Ctrl, A, Enter

    @property
    def human(self) -> float:
        """Seconds of a practised person."""
        pointing = self.clicks * (POINT + 2 * BUTTON) + self.drags * 2 * (POINT + BUTTON)
        return pointing + self.keys * KEY + self.homes * HOME + self.thoughts * THOUGHT

    def load(self, node: str, tip: tuple[float, float]) -> None:
        """A force downward."""
        self.tool("Force")
        self.draw(node, tip)
        self.value("100 N")


def meet(a: Any, ra: float, b: Any, rb: float, near: Any) -> np.ndarray:
    """The point at the distances ra of a and rb of b, of the two the nearer one to a point."""
    d = np.subtract(b, a)
    length = np.hypot(*d)
    along = (ra**2 - rb**2 + length**2) / (2 * length)
    across = math.sqrt(ra**2 - along**2)
    foot, side = a + along * d / length, across * np.array([-d[1], d[0]]) / length
    return min((foot + side, foot - side), key=lambda point: np.hypot(*(point - near)))


def virtual_work(state: dict[str, Any], heights: Heights, at: float) -> float:
    """What holds a drive against loads and weights, from the heights of nodes by its value: N m by an angle, N by a length."""
    down = Counter[str]()  # N
    for load in state["loads"]:
        down[load["node"]] -= load["force"][1]
    for member in state["members"]:
        for end in member["ends"]:
            down[end] += GRAVITY * state["weights"]["members"].get(member["name"], 0) / 2
    for node, entry in state["data"]["nodes"].items():
        if "mass" in entry:
            down[node] += GRAVITY * float(entry["mass"].removesuffix(" kg"))

    def energy(value: float) -> float:
        now = heights(value)
        return sum(force * now.get(node, 0.0) for node, force in down.items())

    return (energy(at + STEP) - energy(at - STEP)) / (2 * STEP)


def turned(angle: float) -> np.ndarray:
    return np.array([math.cos(angle), math.sin(angle)])


def of_four_bar(at: dict[str, np.ndarray]) -> tuple[float, Heights]:
    """The angle of the crank A-B, and the height of C by it."""
    A, B, C, D = (at[name] for name in "ABCD")
    crank, rod, rocker = np.hypot(*(B - A)), np.hypot(*(C - B)), np.hypot(*(D - C))
    return math.atan2(*(B - A)[::-1]), lambda t: {"C": meet(A + crank * turned(t), rod, D, rocker, C)[1]}


def four_bar_by_tools(hand: Counted) -> None:
    hand.give((-0.3, 0), (-0.3, 0.1), (0, 0.3), (0.1, 0))
    hand.tool("Pin")
    hand.give("A", "D")
    hand.tool("Turn")
    hand.give("b1")
    hand.tool("Force")
    hand.draw("C", (0, 0.2))  # an arrow of about 100 N


def four_bar_by_next(hand: Counted) -> None:
    hand.give((-0.3, 0), (-0.3, 0.1), (0, 0.3), (0.1, 0))
    for button in ("support at A", "support at D", "drive b1 about A", "load on C"):
        hand.button(button)


def scissor_lift(hand: Counted) -> None:
    hand.tool("Link")
    hand.give((0, 0), (0.2, 0.1), (0.4, 0.2), (0.4, 0.2))
    hand.give((0.4, 0), "B", (0, 0.2), (0, 0.2))
    hand.tool("Pin")
    hand.give("A")
    hand.tool("Roller")
    hand.give("D")
    hand.tool("Push")
    hand.give("D")
    hand.load("C", (0.4, 0.1))


def of_scissor_lift(at: dict[str, np.ndarray]) -> tuple[float, Heights]:
    """The place of the roller, and the height of C by it."""
    leg = np.hypot(*at["C"])
    return at["D"][0], lambda x: {"C": math.sqrt(leg**2 - x**2)}


def quick_return(hand: Counted) -> None:
    hand.draw((0, -0.2), (0.2, 0.2))
    hand.draw((0, 0), (0.1, 0))
    hand.tool("Slider")
    hand.give("D")
    hand.tool("Pin")
    hand.give("A", "C")
    hand.tool("Turn")
    hand.give("b2")
    hand.load("B", (0.2, 0.1))


def of_quick_return(at: dict[str, np.ndarray]) -> tuple[float, Heights]:
    """The angle of the crank C-D, and the height of B, the end of the lever A-B on which D slides."""
    A, B, C, D = (at[name] for name in "ABCD")
    lever, crank = np.hypot(*(B - A)), np.hypot(*(D - C))

    def heights(t: float) -> dict[str, float]:
        x, y = C + crank * turned(t) - A
        return {"B": A[1] + lever * y / math.hypot(x, y)}

    return math.atan2(*(D - C)[::-1]), heights


def jansen(hand: Counted) -> None:
    hand.write("grid step in m", "10 mm")
    names: dict[str, str] = {}
    for trail in ("OMTLAFKA", "TPKM", "LP"):
        for k, one in enumerate(trail):
            hand.give(names.get(one) or tuple(value / 1000 for value in SKETCH[one]))
            if k:
                hand.value(f"{JANSEN[trail[k - 1] + one]:g} mm")
            names |= {new: node for new, node in zip("OMTLAFKP", hand.state()["nodes"], strict=False) if new not in names}
        hand.give(names[trail[-1]])  # the last one again ends it
    hand.tool("Pin")
    hand.give(names["O"], names["P"])
    for axis, value in FRAME.items():
        hand.write(f"{axis} of {names['P']}", value)
    hand.tool("Turn")
    hand.give("b1")
    x, y = hand.place(names["F"])
    hand.load(names["F"], (x, y - 0.02))


def of_jansen(
    at: dict[str, np.ndarray], names: str = "O:A M:B T:C L:D A:E F:F K:G P:H", scale: float = 1
) -> tuple[float, Heights]:
    """The angle of the crank, and the heights of the nodes by it. names : of the drawing's nodes."""
    called = dict(pair.split(":") for pair in names.split())
    size = {frozenset(name): scale * value / 1000 for name, value in JANSEN.items()}
    at = {one: at[name] for one, name in called.items()}

    def heights(t: float) -> dict[str, float]:
        now = {"O": at["O"], "P": at["P"], "M": at["O"] + size[frozenset("OM")] * turned(t)}
        for one, (a, b) in {"T": "MP", "L": "TP", "K": "MP", "A": "LK", "F": "AK"}.items():
            now[one] = meet(now[a], size[frozenset(a + one)], now[b], size[frozenset(b + one)], at[one])
        return {called[one]: float(place[1]) for one, place in now.items()}

    return math.atan2(*(at["M"] - at["O"])[::-1]), heights


def jansen_from_its_picture(hand: Counted) -> None:
    hand.touch(hand.page.locator(".starters .card", has_text="Jansen's leg"))
    hand.settle()


CASES = {
    "four-bar by tools": (four_bar_by_tools, of_four_bar),
    "four-bar by Next": (four_bar_by_next, of_four_bar),
    "scissor lift": (scissor_lift, of_scissor_lift),
    "quick return": (quick_return, of_quick_return),
    "Jansen's leg": (jansen, of_jansen),
    "Jansen's leg from its picture": (jansen_from_its_picture, partial(of_jansen, names=OF_EXAMPLE, scale=10)),
}
"""Of each mechanism how it is drawn, and its closed form: the value of its drive as drawn, and the heights of nodes by it."""


@contextmanager
def page_of_a_drawing() -> Iterator[Any]:
    """An empty drawing in a browser."""
    from playwright.sync_api import sync_playwright

    program = shutil.which("chromium") or shutil.which("chromium-browser")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        served = start(Path(folder))
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        try:
            page = browser.new_page(viewport={"width": 1440, "height": 900})
            page.goto(served.address)
            page.wait_for_selector("#kinetruss[data-state=ready]", timeout=300_000)
            yield page
        finally:
            browser.close()
            served.process.kill()
            served.process.communicate()


def measure(name: str) -> dict[str, Any]:
    draw, closed_form = CASES[name]
    with page_of_a_drawing() as page:
        hand = Counted(Page(page))
        began = time.perf_counter()
        draw(hand)
        if not hand.js("draw.play.playing"):
            hand.button("▶ Play")
        hand.shown.until("kinetruss.draw.play.playing && kinetruss.draw.play.film.revision === kinetruss.draw.state.revision")
        seconds = time.perf_counter() - began
        page.evaluate("kinetruss.draw.play.home()")
        state = hand.state()
    assert state["force"] is not None, state["why"]
    at, heights = closed_form({node: np.array(place) for node, place in zip(state["nodes"], state["places"], strict=True)})
    held, wanted = state["drives"][0]["force"], virtual_work(state, heights, at)
    counts = {key: getattr(hand, key) for key in ("clicks", "drags", "keys", "words")}
    return {"case": name, **counts, "script_s": seconds, "human_s": hand.human, "held": held, "error": abs(held / wanted - 1)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--case", default="", help="only those with this word in their name")
    options = parser.parse_args()
    rows = [measure(name) for name in CASES if options.case in name]
    if options.json:
        print(json.dumps({"rows": rows}))
        return
    for row in rows:
        print(", ".join(f"{key} {value:.3g}" if isinstance(value, float) else f"{key} {value}" for key, value in row.items()))


if __name__ == "__main__":
    main()
