"""A hand on mouse and keyboard of the drawing page."""

from __future__ import annotations

from itertools import pairwise


class Hand:
    """A hand on mouse and keyboard of the drawing page."""

    def __init__(self, shown) -> None:
        self.shown = shown
        self.page = shown.page
        self.settle()

    def js(self, expression: str, given=None):
        return self.page.evaluate(
            f"(given) => {{ const draw = kinetruss.draw, state = draw.state; return {expression}; }}", given
        )

    def settle(self) -> None:
        self.shown.until(
            "kinetruss.draw.state && !kinetruss.draw.waiting && !kinetruss.draw.wanted && !kinetruss.draw.queue.length"
        )

    def state(self) -> dict:
        self.settle()
        return self.js("state")

    def spot(self, where) -> tuple[float, float]:
        """Where a node, or a point of the work plane, is on the screen."""
        box = self.page.locator("svg.drawing").bounding_box()
        if isinstance(where, str):
            x, y = self.js("draw.canvas.at(given)", where)[:2]
        else:
            x, y = self.js("draw.camera.project(given)", list(where))[:2]
        return box["x"] + x, box["y"] + y

    def click(self, where, **more) -> None:
        self.page.mouse.click(*self.spot(where), **more)
        self.settle()

    def pull(self, *way) -> None:
        """Press at the first place, move over the others, and release at the last."""
        spots = [self.spot(where) for where in way]
        self.page.mouse.move(*spots[0])
        self.page.mouse.down()
        for (x0, y0), (x1, y1) in pairwise(spots):
            for k in (1, 2, 3):
                self.page.mouse.move(x0 + (x1 - x0) * k / 3, y0 + (y1 - y0) * k / 3)
        self.page.mouse.up()
        self.settle()

    def press(self, *keys: str) -> None:
        self.press_at_once(*keys)
        self.settle()

    def press_at_once(self, *keys: str) -> None:
        """Press, and wait for no answer."""
        for key in keys:
            self.page.keyboard.press(key)

    def write(self, label: str, words: str) -> None:
        """Type into a field."""
        field = self.page.get_by_label(label, exact=True)
        field.click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.type(words)
        self.page.keyboard.press("Enter")
        self.settle()

    def choose(self, label: str, option: str) -> None:
        self.page.get_by_label(label, exact=True).select_option(option)
        self.settle()

    def button(self, name: str) -> None:
        self.page.get_by_role("button", name=name, exact=True).click()
        self.settle()

    def held(self, name: str) -> None:
        self.choose("pick a node", name)
        self.button(f"hold {name}")

    def closer(self, step: str, clicks: int) -> None:
        """Approach the middle with the wheel, and choose the step of the grid."""
        box = self.page.locator("svg.drawing").bounding_box()
        self.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        for _ in range(abs(clicks)):
            self.page.mouse.wheel(0, -250 if clicks > 0 else 250)
        self.write("grid step in m", step)


def drawn(show, served, **more) -> Hand:
    return Hand(show(served.address, **{"width": 1300, "height": 900} | more))
