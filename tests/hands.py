"""Hands that use the drawing page in one way alone: a mouse, keys, or fingers on a phone. What one can do the others can."""

from __future__ import annotations

from abc import ABC, abstractmethod
from itertools import pairwise
from typing import Any

from hand import Hand

ARROWS = (("ArrowLeft", "ArrowRight"), ("ArrowDown", "ArrowUp"))
Where = str | tuple[float, float]  # a node, a member (its middle), or a point of the drawing


class OneHand(Hand, ABC):
    """What all hands do; how, is their own.

    ``touch(locator)`` presses a button or gives a field the focus, ``give`` points at places for the tool in use, ``draw`` goes
    from one place to another, ``menu`` asks for the menu of a place and chooses.
    """

    def spot(self, where: Any) -> tuple[float, float]:
        self.page.locator("svg.drawing").scroll_into_view_if_needed()
        return super().spot((*self.place(where), 0) if isinstance(where, str) else (*where[:2], 0))

    def place(self, where: Where) -> tuple[float, float]:
        """Coordinates of a node, of a point, or of the middle of a member."""
        if not isinstance(where, str):
            return where[0], where[1]
        ends = self.js("state.nodes.includes(given) ? [given] : state.members.find(({ name }) => name === given).ends", where)
        x, y = (sum(axis) / len(ends) for axis in list(zip(*(self.js("draw.at(given)", end) for end in ends), strict=True))[:2])
        return x, y

    @abstractmethod
    def touch(self, locator: Any) -> None:
        """Press a button, or give a field the focus."""

    def tool(self, name: str) -> None:
        self.touch(self.page.locator(".palette").get_by_label(name, exact=True))

    def button(self, name: str) -> None:
        self.touch(self.page.get_by_role("button", name=name, exact=True))
        self.settle()

    def write(self, label: str, words: str) -> None:
        self.touch(self.page.get_by_label(label, exact=True))
        self.page.keyboard.press("Control+a")
        self.page.keyboard.type(words)
        self.page.keyboard.press("Enter")
        self.settle()

    def value(self, words: str) -> None:
        """Type into the field of what was just drawn."""
        self.shown.until("!document.querySelector('.value').hidden")
        if self.js("!document.querySelector('.value').contains(document.activeElement)"):
            self.touch(self.page.locator(".value input"))
            self.page.keyboard.press("Control+a")
        self.page.keyboard.type(words)
        self.page.keyboard.press("Enter")
        self.settle()

    def item(self, name: str) -> None:
        """Choose in the menu that is open."""
        self.touch(self.page.get_by_role("menuitem", name=name, exact=True))
        self.settle()


class Mouse(OneHand):
    def touch(self, locator: Any) -> None:
        locator.click()

    def give(self, *places: Where) -> None:
        for place in places:
            self.click(place)

    def draw(self, start: Where, end: Where) -> None:
        self.pull(start, end)

    def menu(self, where: Where, name: str) -> None:
        self.click(where, button="right")
        self.item(name)


class Keys(OneHand):
    def touch(self, locator: Any) -> None:
        locator.scroll_into_view_if_needed()
        locator.focus()  # as Tab does, which stops at what can have the focus
        assert locator.evaluate("(one) => one === document.activeElement && one.tabIndex >= 0"), locator
        if locator.evaluate("(one) => one.matches('button, summary, a')"):
            self.page.keyboard.press("Enter")

    def tool(self, name: str) -> None:
        self.reach()
        title = self.page.locator(".palette").get_by_label(name, exact=True).get_attribute("title")
        self.press(title[-2].lower())

    def reach(self) -> None:
        """Tab to the drawing."""
        if not self.js("document.activeElement === draw.canvas.node"):
            self.page.locator("svg.drawing").focus()

    def cursor(self, where: Where) -> None:
        """Bring the cursor to a place: along the grid, or from node to bar where no line of the grid leads."""
        self.reach()
        to, step = self.place(where), self.js("draw.camera.grid")
        if all(abs(value / step - round(value / step)) < 1e-6 for value in to):
            if not self.js("Boolean(draw.cursor)"):
                self.press_at_once("ArrowRight")
            if any(abs(value / step - round(value / step)) > 1e-6 for value in self.js("draw.cursor")[:2]):
                self.press_at_once("ArrowRight", "ArrowUp")
            for k, keys in enumerate(ARROWS):
                steps = round((to[k] - self.js("draw.cursor")[k]) / step)
                self.press_at_once(*[keys[steps > 0]] * abs(steps))
        else:
            for _ in range(60):
                at = self.js("draw.cursor")
                if at and max(abs(a - b) for a, b in zip(at, to, strict=False)) * self.js("draw.camera.scale") < 0.5:
                    break
                self.press_at_once("PageDown")
        here = self.js("draw.cursor")
        assert max(abs(a - b) for a, b in zip(here, to, strict=False)) < 1e-6, (where, here)

    def give(self, *places: Where) -> None:
        for place in places:
            self.cursor(place)
            self.press("Enter")

    def draw(self, start: Where, end: Where) -> None:
        self.cursor(start)
        self.press("Shift+Enter")
        self.give(end)

    def pull(self, start: Where, end: Where) -> None:
        """Take a node into the hand, move it, let it go."""
        fine = 4 / self.js("draw.camera.grid")
        self.give(start)
        if not self.js("Boolean(draw.keyboard.grabbed)"):
            self.press("Enter")  # Pick picks first
        here = self.place(start)
        for k, keys in enumerate(ARROWS):
            steps = round((self.place(end)[k] - here[k]) * fine)
            for _ in range(abs(steps)):
                self.press(keys[steps > 0])
        self.press("Enter")

    def menu(self, where: Where, name: str) -> None:
        self.cursor(where)
        self.press("Shift+F10")
        while self.js("document.activeElement.textContent") != name:
            self.press_at_once("ArrowDown")
        self.press("Enter")

    def choose(self, label: str, option: str) -> None:
        """The option with these words, from the first one on."""
        select = self.page.get_by_label(label, exact=True)
        self.touch(select)
        self.press("Home")
        for _ in range(select.locator("option").count()):
            if select.evaluate("(one) => one.selectedOptions[0].textContent") == option:
                return
            self.press("ArrowDown")
        raise AssertionError((label, option))


class Fingers(OneHand):
    def tool(self, name: str) -> None:
        own = self.page.locator(".palette").get_by_label(name, exact=True)
        if not own.is_visible():
            self.touch(
                self.page.locator(".palette .group").filter(has=self.page.get_by_label(name, exact=True)).locator(".head")
            )
        self.touch(own)

    def touch(self, locator: Any) -> None:
        hear = "one.addEventListener('click', () => (window.heard = true), { once: true, capture: true })"
        locator.evaluate(f"(one) => {{ window.heard = false; {hear}; }}")
        for _ in range(3):  # right after a pull Chromium may take a tap for the end of its swing
            locator.tap()
            for _ in range(100):
                if self.page.evaluate("window.heard"):
                    return
                self.page.wait_for_timeout(20)
        raise AssertionError(f"no tap reaches {locator}")

    def give(self, *places: Where) -> None:
        for place in places:
            self.page.touchscreen.tap(*self.spot(place))
            self.settle()

    def send(self, kind: str, *spots: tuple[float, float]) -> None:
        if not hasattr(self, "wire"):
            self.wire = self.page.context.new_cdp_session(self.page)
        points = [{"x": x, "y": y} for x, y in spots]
        self.wire.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def pull(self, *way: Where) -> None:
        spots = [self.spot(where) for where in way]
        self.send("touchStart", spots[0])
        for (x0, y0), (x1, y1) in pairwise(spots):
            for k in (1, 2, 3):
                self.send("touchMove", (x0 + (x1 - x0) * k / 3, y0 + (y1 - y0) * k / 3))
        self.send("touchEnd")
        self.settle()

    def draw(self, start: Where, end: Where) -> None:
        self.pull(start, end)

    def menu(self, where: Where, name: str) -> None:
        self.send("touchStart", self.spot(where))
        self.shown.until("!document.querySelector('.menu').hidden")
        self.send("touchEnd")
        self.item(name)


WAYS: dict[str, type[OneHand]] = {"mouse": Mouse, "keys": Keys, "fingers": Fingers}
