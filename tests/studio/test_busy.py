"""What a page is told while its answer takes long: only a page that asks for it, and before the answer."""

import asyncio
import json
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

from kinetruss.kernels.compiled.jit import keeper
from kinetruss.kernels.compiled.progress import Progress
from kinetruss.studio import app as _app
from kinetruss.studio.requested_runs import Busy


class Line:
    """A connection that keeps what is sent; the work that is awaited ends with the second message about it."""

    def __init__(self, **asked: str) -> None:
        self.query_params, self.sent, self.enough = asked, [], threading.Event()

    async def send_text(self, text: str) -> None:
        self.sent.append(json.loads(text))
        if len(self.sent) == 2:
            self.enough.set()


def answered(*given: Any) -> Any:
    """What a page gets; in a thread of its own, because a browser of other tests has a loop in this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(lambda: asyncio.run(_app._meanwhile(*given))).result()


def test_a_page_that_asks_for_it_hears_what_its_answer_waits_for(monkeypatch):
    monkeypatch.setattr(keeper, "progress", Progress())  # other tests' threads compile
    monkeypatch.setattr(_app, "SOON", 0.01)
    line = Line(busy="1")
    assert answered(line, line.enough.wait, 60.0) is True
    assert len(line.sent) >= 2
    assert {one["kind"] for one in line.sent} == {"busy"}
    assert line.sent[0]["text"] == "Computing ..."


def test_other_clients_get_one_answer_to_each_message(monkeypatch):
    monkeypatch.setattr(_app, "SOON", 0.01)
    line = Line()
    assert answered(line, line.enough.wait, 0.1) is False
    assert line.sent == []


@pytest.mark.parametrize("asked", [{}, {"busy": "1"}])
def test_an_error_of_the_work_is_raised(asked):
    with pytest.raises(ZeroDivisionError):
        answered(Line(**asked), lambda: 1 // 0)


def test_kernels_that_are_compiled_meanwhile_are_said(monkeypatch):
    monkeypatch.setattr(keeper, "progress", Progress())
    busy = Busy()
    assert busy.compiling() == ""
    keeper.progress.begin()
    assert busy.text() == "Compiling (first start only): 0 kernels, 0 s"
    keeper.progress.compiled()
    assert busy.compiling().startswith("Compiling (first start only): 1 kernel,")
    assert Busy().compiling() == ""  # what comes later does not wait for it
