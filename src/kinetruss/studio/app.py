"""The web application: one page, protected by a token, and one live connection per open page."""

from __future__ import annotations

import asyncio
import json
import logging
import secrets
from collections.abc import Callable, Iterable
from typing import Any
from urllib.parse import quote

from fastapi import FastAPI, Response, WebSocket, WebSocketDisconnect
from starlette.concurrency import run_in_threadpool
from starlette.datastructures import Headers
from starlette.responses import HTMLResponse, PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send

from kinetruss.errors import KinetrussError
from kinetruss.studio.messages import Session
from kinetruss.studio.requested_runs import Busy
from kinetruss.studio.session import Answer
from kinetruss.studio.taken import File
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


def application(new: Callable[[str], Session], drawing: Session, token: str, hosts: Iterable[str], title: str) -> FastAPI:
    """The application.

    Parameters
    ----------
    new : makes the session of a page with sliders, from its key if it has lost its studio, or from "".
    drawing : the session that all drawing pages share. token : part of every address.
    hosts : ``127.0.0.1:PORT`` and the like.
    """
    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None, redirect_slashes=False)
    app.add_middleware(Guard, hosts=tuple(hosts))
    live, draw = (live_page(title, sorted(hosts), draw=kind).encode() for kind in (False, True))
    pages: dict[WebSocket, Session | None] = {}

    def answered(given: str, found: str | bytes | File | None) -> Response:
        if not _same(given, token) or found is None:
            words = "This result is not kept any more." if _same(given, token) else STALE
            return PlainTextResponse(words, status_code=404)
        if isinstance(found, File):
            kept = {"Content-Disposition": f"attachment; filename*=UTF-8''{quote(found.name)}"}
            return Response(found.content, media_type=found.media, headers=HEADERS | kept)
        return HTMLResponse(found, headers=HEADERS)

    @app.get("/{given}/")
    async def live_address(given: str) -> Response:
        return answered(given, live)

    @app.get("/{given}/draw/")
    async def draw_address(given: str) -> Response:
        return answered(given, draw)

    @app.get("/{given}/draw/result/{number}")
    async def result_address(given: str, number: int) -> Response:
        return answered(given, drawing.results.pages.get(number))

    async def connected(socket: WebSocket, given: str, session_of: Callable[[str], Session]) -> None:
        if not _same(given, token):
            await socket.close(1008, "wrong token")
            return
        await socket.accept()
        if len(pages) >= PAGES:
            await socket.close(1013, "too many pages are open")
            return
        pages[socket] = None
        try:
            await _talk(socket, session_of, pages)
        except (WebSocketDisconnect, RuntimeError):
            log.debug("a page was closed")
        finally:
            del pages[socket]

    @app.websocket("/{given}/live")
    async def live_socket(socket: WebSocket, given: str) -> None:
        await connected(socket, given, new)

    @app.websocket("/{given}/draw/live")
    async def draw_socket(socket: WebSocket, given: str) -> None:
        await connected(socket, given, lambda _: drawing)

    return app


def _same(given: str, token: str) -> bool:
    return secrets.compare_digest(given.encode(), token.encode())


async def _talk(socket: WebSocket, session_of: Callable[[str], Session], pages: dict[WebSocket, Session | None]) -> None:
    """Answer every message of a page, one after the other; the work is done in a thread outside the event loop.

    Other pages of the same session get what was changed.
    """
    try:
        session: Session = await _meanwhile(socket, session_of, socket.query_params.get("page", ""))
        await _send(socket, await _meanwhile(socket, session.first))
    except KinetrussError as error:
        await _send(socket, {"kind": "failed", "message": f"This model cannot be shown live. {error}"})
        await socket.close(1011)
        return
    pages[socket] = session
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
        if len(given) > session.most:
            await socket.close(1009, "too long")
            return
        before = session.drawing.state
        found = await _meanwhile(socket, _answer, session, given)
        await _send(socket, found)
        if session.drawing.state is not before and isinstance(found, dict) and found["kind"] in ("drawing", "moved"):
            for other in [one for one, of in pages.items() if of is session and one is not socket]:
                await _send(other, {**found, "made": {}, "other": True})


async def _meanwhile(socket: WebSocket, work: Callable[..., Any], *given: Any) -> Any:
    """What the work returns, done in a thread; while that takes long, a page that asks for it is told what is done."""
    if "busy" not in socket.query_params:
        return await run_in_threadpool(work, *given)
    busy, task = Busy(), asyncio.ensure_future(run_in_threadpool(work, *given))
    while not (await asyncio.wait({task}, timeout=SOON))[0]:
        await _send(socket, {"kind": "busy", "text": busy.text()})
    return task.result()


def _answer(session: Session, text: str | bytes) -> Answer:
    """The answer of the session; an unexpected error is reported too, and the page stays connected."""
    try:
        return session.answer(text)
    except Exception as error:
        log.exception("a message could not be answered")
        return {"kind": "error", "message": f"This could not be done: {type(error).__name__}. The model is unchanged."}


async def _send(socket: WebSocket, answer: Answer) -> None:
    if isinstance(answer, bytes):
        await socket.send_bytes(answer)
    else:
        await socket.send_text(json.dumps(answer, ensure_ascii=False, allow_nan=False))
