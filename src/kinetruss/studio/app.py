"""The web application: one page, protected by a token, and one live connection per open page."""

from __future__ import annotations

import asyncio
import json
import logging
import secrets
from collections.abc import Awaitable, Callable, Iterable
from typing import Any

from fastapi import FastAPI, Response, WebSocket, WebSocketDisconnect
from starlette.concurrency import run_in_threadpool
from starlette.datastructures import Headers
from starlette.responses import HTMLResponse, PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send

from kinetruss.errors import KinetrussError
from kinetruss.studio.commands import MOST
from kinetruss.studio.desk import Desk
from kinetruss.studio.messages import Busy
from kinetruss.studio.session import Session
from kinetruss.viewer import live_page

PAGES = 16
"""Largest number of open pages."""

HEADERS = {
    "Cache-Control": "no-store",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}

STALE = (
    "No studio has this address. Each start of the studio has a new one, which it prints: open that.\n"
    "A studio in which something was changed keeps its address for the next studio of the same file."
)
"""The answer to the link of an earlier start."""

SOON = 0.25
"""Seconds after which a page is told what its answer waits for, and between two such messages."""

REST = 0.4
"""Seconds without a message after which a changed pose is kept."""

log = logging.getLogger(__name__)


class Guard:
    """Accepts a request only if its host and, if given, its origin are those of this server.

    A websocket must have an origin: browsers always send one, and a page from elsewhere cannot forge it.
    """

    def __init__(self, app: ASGIApp, hosts: Iterable[str]) -> None:
        self.app = app
        self.hosts = set(hosts)
        self.origins = {f"http://{host}" for host in self.hosts}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """One request or connection."""
        if scope["type"] not in ("http", "websocket") or self.welcome(scope):
            await self.app(scope, receive, send)
        elif scope["type"] == "http":
            await PlainTextResponse("This address is not served to you.", status_code=403)(scope, receive, send)
        else:
            await receive()
            await send({"type": "websocket.close", "code": 1008, "reason": "wrong host or origin"})

    def welcome(self, scope: Scope) -> bool:
        """True if host and origin are right and each is given exactly once."""
        headers = Headers(scope=scope)
        hosts, origins = headers.getlist("host"), headers.getlist("origin")
        if len(hosts) != 1 or hosts[0] not in self.hosts:
            return False
        if not origins:
            return bool(scope["type"] == "http")
        return len(origins) == 1 and origins[0] in self.origins


def application(new: Callable[[str], Session], desk: Desk, token: str, hosts: Iterable[str], title: str) -> FastAPI:
    """The application.

    Parameters
    ----------
    new : makes the session of a live page, from its key if it has lost its studio, or from "".
    desk : the drawing that all drawing pages share. token : part of every address.
    hosts : ``127.0.0.1:PORT`` and the like.
    """
    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None, redirect_slashes=False)
    app.add_middleware(Guard, hosts=tuple(hosts))
    served = {"live": live_page(title, sorted(hosts)).encode(), "draw": live_page(title, sorted(hosts), draw=True).encode()}
    open_pages: set[WebSocket] = set()
    drawing_pages: set[WebSocket] = set()

    def answered(given: str, kind: str) -> Response:
        if not _same(given, token):
            return PlainTextResponse(STALE, status_code=404)
        return HTMLResponse(served[kind], headers=HEADERS)

    @app.get("/{given}/")
    async def page(given: str) -> Response:
        return answered(given, "live")

    @app.get("/{given}/draw/")
    async def drawing_page(given: str) -> Response:
        return answered(given, "draw")

    @app.get("/{given}/draw/result/{number}")
    async def result_page(given: str, number: int) -> Response:
        if not _same(given, token) or number not in desk.results.pages:
            return PlainTextResponse(STALE if not _same(given, token) else "This result is not kept any more.", status_code=404)
        return HTMLResponse(desk.results.pages[number], headers=HEADERS)

    async def connected(socket: WebSocket, given: str, talk: Callable[[], Awaitable[None]]) -> None:
        if not _same(given, token):
            await socket.close(1008, "wrong token")
            return
        await socket.accept()
        if len(open_pages) >= PAGES:
            await socket.close(1013, "too many pages are open")
            return
        open_pages.add(socket)
        try:
            await talk()
        except (WebSocketDisconnect, RuntimeError):
            log.debug("a page was closed")
        finally:
            open_pages.discard(socket)
            drawing_pages.discard(socket)

    @app.websocket("/{given}/live")
    async def live(socket: WebSocket, given: str) -> None:
        await connected(socket, given, lambda: _talk(socket, new))

    @app.websocket("/{given}/draw/live")
    async def draw(socket: WebSocket, given: str) -> None:
        await connected(socket, given, lambda: _draw(socket, desk, drawing_pages))

    return app


def _same(given: str, token: str) -> bool:
    return secrets.compare_digest(given.encode(), token.encode())


async def _talk(socket: WebSocket, new: Callable[[str], Session]) -> None:
    """Answer every message of a page, one after the other; the work is done in a thread outside the event loop."""
    try:
        session = await _meanwhile(socket, new, socket.query_params.get("page", ""))
        first = await _meanwhile(socket, session.first)
    except KinetrussError as error:
        await _send(socket.send_text, {"kind": "failed", "message": f"This model cannot be shown live. {error}"})
        await socket.close(1011)
        return
    await socket.send_bytes(first)
    while True:
        coming = asyncio.ensure_future(socket.receive())
        if not session.kept and not (await asyncio.wait({coming}, timeout=REST))[0]:
            await run_in_threadpool(session.rest)
        message = await coming
        if message["type"] == "websocket.disconnect":
            await run_in_threadpool(session.rest)
            return
        text = message.get("text")
        given = text if text is not None else message.get("bytes") or b""
        if len(given) > MOST:
            await socket.close(1009, "too long")
            return
        found = await _meanwhile(socket, _answer, session, given)
        if isinstance(found, bytes):
            await socket.send_bytes(found)
        else:
            await _send(socket.send_text, found)


async def _draw(socket: WebSocket, desk: Desk, pages: set[WebSocket]) -> None:
    """Answer every message of a drawing page; the other drawing pages get what was changed."""
    await _send(socket.send_text, await _meanwhile(socket, desk.first))
    pages.add(socket)
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text")
        before = desk.drawing.revision
        found = await _meanwhile(socket, _answer, desk, text if text is not None else message.get("bytes") or b"")
        await _send(socket.send_text, found)
        if desk.drawing.revision == before or found["kind"] not in ("drawing", "moved"):
            continue
        for other in pages - {socket}:
            await _send(other.send_text, {**found, "made": {}, "other": True})


async def _meanwhile(socket: WebSocket, work: Callable[..., Any], *given: Any) -> Any:
    """What the work returns, done in a thread; while that takes long, a page that asks for it is told what is done."""
    if "busy" not in socket.query_params:
        return await run_in_threadpool(work, *given)
    busy, task = Busy(), asyncio.ensure_future(run_in_threadpool(work, *given))
    while not (await asyncio.wait({task}, timeout=SOON))[0]:
        await _send(socket.send_text, {"kind": "busy", "text": busy.text()})
    return task.result()


def _answer(session: Session | Desk, text: str | bytes) -> Any:
    """The answer of the session; an unexpected error is reported too, and the page stays connected."""
    try:
        return session.answer(text)
    except Exception as error:
        log.exception("a message could not be answered")
        return {"kind": "error", "message": f"This could not be done: {type(error).__name__}. The model is unchanged."}


async def _send(send: Callable[[str], Awaitable[None]], record: dict[str, Any]) -> None:
    await send(json.dumps(record, ensure_ascii=False, allow_nan=False))
