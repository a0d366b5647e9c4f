"""A real browser: Debian's Chromium, without a screen and without a network."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from hand import Hand
from kinetruss import Model
from served import Served, serve, start

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = ("--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-sandbox")
WAIT = 60.0  # s, for a machine that is busy with other things


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Without Chromium there is nothing to test with; where everything must be tested that is a failure."""
    if CHROMIUM or os.environ.get("CI") == "true":
        return
    here = Path(__file__).parent
    for item in items:
        if here in item.path.parents:
            item.add_marker(pytest.mark.skip(reason="no chromium on this machine (apt-get install chromium)"))


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    assert CHROMIUM, "no chromium on this machine: apt-get install chromium"
    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        yield found
        found.close()


@dataclass
class Shown:
    """A page that is ready, what it asked the network for, and what it complained about."""

    page: Page
    requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)

    def js(self, expression: str, argument: Any = None) -> Any:
        """A value of the page; `app` is the page's state, `view` its first picture, `scene` what that shows."""
        names = "const app = window.kinetruss.app, view = app?.views[0], scene = view?.scene;"
        return self.page.evaluate(f"(given) => {{ {names} return {expression}; }}", argument)

    def until(self, expression: str) -> None:
        """Wait for something to become true."""
        end = time.monotonic() + WAIT
        while not self.js(expression):
            assert time.monotonic() < end, f"never came true: {expression}"
            self.page.wait_for_timeout(20)

    def press(self, *keys: str) -> None:
        for key in keys:
            self.page.keyboard.press(key)

    def drawn(self) -> None:
        """Wait until what was asked for is on the screen."""
        before = self.js("(view.request(), view.drawn || 0)")
        self.until(f"view.drawn > {before}")


@pytest.fixture
def show(browser: Browser) -> Iterator[Any]:
    """Opens a file or an address and waits until it is ready (or has said why it cannot be).

    script : runs before the page. options : of the browser's context, e.g. ``has_touch``.
    """
    contexts = []

    def opened(
        path: Path | str, width: int = 900, height: int = 600, scheme: Any = "light", script: str = "", **options: Any
    ) -> Shown:
        context = browser.new_context(viewport={"width": width, "height": height}, color_scheme=scheme, **options)
        contexts.append(context)
        page = context.new_page()
        if script:
            page.add_init_script(script)
        shown = Shown(page)
        page.on("console", lambda message: shown.complaints.append(message.text))
        page.on("pageerror", lambda error: shown.complaints.append(str(error)))
        address = path if isinstance(path, str) else path.as_uri()

        def judge(route: Any) -> None:
            if route.request.url == address:
                route.continue_()
            else:
                shown.requests.append(route.request.url)
                route.abort()

        page.route("**/*", judge)
        page.goto(address)
        page.wait_for_selector("#kinetruss[data-state]", timeout=1000 * WAIT)
        return shown

    yield opened
    for context in contexts:
        context.close()


@pytest.fixture
def served(tmp_path) -> Iterator[Served]:
    """A studio with an empty drawing."""
    one = start(tmp_path)
    yield one
    one.process.kill()
    one.process.communicate()


@pytest.fixture
def opened(show, tmp_path) -> Iterator[Any]:
    """A page of a drawing of some model."""
    studios = []

    def one(model: Model, **more) -> Hand:
        studios.append(serve(model, tmp_path))
        return Hand(show(studios[-1].address + "draw/", **{"width": 1440, "height": 900} | more))

    yield one
    for studio in studios:
        studio.process.kill()
        studio.process.communicate()
