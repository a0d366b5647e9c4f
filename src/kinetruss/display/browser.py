"""Chromium without a screen and without a network, driven by its DevTools protocol over two pipes."""

from __future__ import annotations

import base64
import fcntl
import itertools
import json
import os
import select
import shutil
import signal
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Self

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
PLACES = ("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome", "/Applications/Chromium.app/Contents/MacOS/Chromium")
INSTALL = "Install it (Debian: apt-get install chromium)"
PATIENCE = 180.0
"""Largest time of one answer, s."""
FLAGS = (
    "--headless=new",
    "--no-first-run",
    "--no-default-browser-check",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-extensions",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--remote-debugging-pipe",
)
"""Options without network access: the page needs none, and the browser must not use any."""
PAPER = ("--disable-gpu",)
"""Options of a browser that prints."""
WEBGL = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-sandbox")
"""Options of a browser that draws by the processor: the same picture on every machine."""
READ, LEAVE = 1 << 20, 5.0  # bytes read at a time; s that a browser has to end by itself


class BrowserError(Exception):
    """Chromium cannot be started, ended, did not answer in time, or what it was asked failed."""


def chromium() -> str | None:
    """The program, or None if there is none."""
    for name in NAMES:
        if found := shutil.which(name):
            return found
    return next((place for place in PLACES if Path(place).is_file()), None)


class Browser:
    """A running Chromium with one page; a context that ends it.

    Raises
    ------
    BrowserError : from every method, with a sentence on the reason.
    """

    def __init__(self, program: str, flags: Sequence[str] = ()) -> None:
        self._program, self._flags = program, flags
        self._numbers = itertools.count(1)
        self._answers: dict[int, dict[str, Any]] = {}
        self._events: list[str] = []
        self._buffer = bytearray()
        self._session: dict[str, str] = {}

    def __enter__(self) -> Self:
        self._folder = TemporaryDirectory(prefix="kinetruss-", ignore_cleanup_errors=True)
        root = ["--no-sandbox"] if os.geteuid() == 0 else []  # needed to start as root; the pages are our own
        command = [self._program, *FLAGS, *self._flags, *root, f"--user-data-dir={self._folder.name}", "about:blank"]
        # Chromium reads requests from its file 3 and writes answers to its file 4
        (theirs, self._out), (self._in, answers) = _pipe(), _pipe()
        actions = [
            (os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0),
            (os.POSIX_SPAWN_OPEN, 2, f"{self._folder.name}/said", os.O_WRONLY | os.O_CREAT, 0o600),
            (os.POSIX_SPAWN_DUP2, theirs, 3),
            (os.POSIX_SPAWN_DUP2, answers, 4),
        ]
        try:
            self._process = os.posix_spawn(self._program, command, os.environ, file_actions=actions, setpgroup=0)
        except OSError as error:
            self._close()
            raise BrowserError(f"{self._program} cannot be started ({error.strerror}).") from None
        finally:
            os.close(theirs)
            os.close(answers)
        try:
            target = self.send("Target.createTarget", url="about:blank")["targetId"]
            self._session = {"sessionId": self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]}
            self.send("Page.enable")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        os.close(self._out)  # at which Chromium ends
        end = time.monotonic() + LEAVE
        while os.waitpid(self._process, os.WNOHANG) == (0, 0):
            if time.monotonic() > end:
                with suppress(ProcessLookupError):
                    os.killpg(self._process, signal.SIGKILL)
            time.sleep(0.005)
        os.close(self._in)
        self._folder.cleanup()

    def open(self, page: Path) -> None:
        """Open a file and wait until it is loaded."""
        self._events.clear()
        self.send("Page.navigate", url=page.resolve().as_uri())
        self._until(lambda: "Page.loadEventFired" in self._events)

    def paper(self, page: Path) -> bytes:
        """A file printed as PDF, on the paper that its style names."""
        self.open(page)
        found = self.send("Page.printToPDF", printBackground=True, preferCSSPageSize=True, generateTaggedPDF=True)
        printed = base64.b64decode(found["data"])
        if not printed.startswith(b"%PDF-") or b"%%EOF" not in printed[-64:]:
            raise BrowserError(f"{self._program} failed (what it printed is not whole).")
        return printed

    def ask(self, expression: str) -> Any:
        """The value of an expression of JavaScript in the page, of a promise what it comes to."""
        return self.answer(self.begin(expression))

    def begin(self, expression: str) -> int:
        """Ask without waiting; the number by which `answer` gives the value."""
        return self._request("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)

    def answer(self, number: int) -> Any:
        """The value of an expression asked before."""
        found = self._result(number)
        if "exceptionDetails" in found:
            told = found["exceptionDetails"]
            raise BrowserError(str(told.get("exception", {}).get("description", told["text"])).splitlines()[0])
        return found["result"].get("value")

    def send(self, method: str, **given: Any) -> dict[str, Any]:
        """The result of a method of the protocol."""
        return self._result(self._request(method, **given))

    def _request(self, method: str, **given: Any) -> int:
        number = next(self._numbers)
        message = json.dumps({"id": number, "method": method, "params": given, **self._session}).encode() + b"\0"
        try:
            while message:
                message = message[os.write(self._out, message) :]
        except OSError:
            raise self._ended() from None
        return number

    def _result(self, number: int) -> dict[str, Any]:
        self._until(lambda: number in self._answers)
        found = self._answers.pop(number)
        if "error" in found:
            raise BrowserError(str(found["error"]["message"]))
        result: dict[str, Any] = found["result"]
        return result

    def _until(self, done: Any) -> None:
        end = time.monotonic() + PATIENCE
        while not done():
            if not select.select([self._in], [], [], max(0.0, end - time.monotonic()))[0]:
                raise BrowserError(f"{self._program} did not answer within {PATIENCE:g} s.")
            piece = os.read(self._in, READ)
            if not piece:
                raise self._ended()
            start = len(self._buffer)
            self._buffer += piece
            while (stop := self._buffer.find(b"\0", start)) >= 0:
                message = json.loads(self._buffer[:stop])
                del self._buffer[: stop + 1]
                start = 0
                if "id" in message:
                    self._answers[message["id"]] = message
                else:
                    self._events.append(message["method"])

    def _ended(self) -> BrowserError:
        said = Path(self._folder.name, "said")
        lines = said.read_text(errors="replace").strip().splitlines() if said.is_file() else []
        return BrowserError(f"{self._program} failed ({lines[-1] if lines else 'it ended'}).")

    def _close(self) -> None:
        os.close(self._out)
        os.close(self._in)
        self._folder.cleanup()


def _pipe() -> tuple[int, int]:
    """Ends of a pipe to read from and to write to, numbered above those that a new process gets."""
    low = os.pipe()
    read, write = (fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in low)
    for end in low:
        os.close(end)
    return read, write
