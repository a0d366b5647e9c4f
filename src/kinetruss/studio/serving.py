"""Run the studio of a model file until Ctrl-C."""

from __future__ import annotations

import gc
import secrets
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.io import MAX_SIZE, read

HOST = "127.0.0.1"

PATIENCE = 5.0
"""Seconds that the end of a studio waits for the step of what it computes."""


def serve(
    path: str | Path | None = None,
    *,
    dim: int = 2,
    draw: bool = False,
    folder: str | Path | None = None,
    port: int = 0,
    token: str | None = None,
    max_size: int = MAX_SIZE,
    ready: Callable[[str], Any] | None = None,
) -> None:
    """Serve the live page and the drawing page of a model to browsers of this machine, until interrupted.

    Parameters
    ----------
    path : the model file; it is read once. None: an empty drawing.
    dim : of the empty drawing, 2 or 3. draw : open the drawing page first; so it is without a file.
    folder : the only folder in which pages can save; by default that of the model file, or the working folder.
    port : on 127.0.0.1; 0 selects a free one. token : part of the address; by default 32 random characters, or those of the
        last studio of this file if a page of it has changed anything.
    ready : called with the address once the server listens.

    Raises
    ------
    InputError : missing packages of the studio, a faulty model, no such folder, a port in use.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model_file = kt.library.example_files()["four_bar"][0]
    >>> kt.studio.serve(model_file, ready=print)  # serves until it is interrupted  # doctest: +SKIP
    """
    file = None if path is None else Path(path).resolve()
    target = Path(folder).resolve() if folder is not None else Path.cwd() if file is None else file.parent
    if not target.is_dir():
        raise InputError(f"There is no folder {target}. Make it, or name another one.")
    from kinetruss.studio.files import Drafts, seen_now

    seen = seen_now(file)  # before the file is read: a later change is by another program
    model = None if file is None else read(file, max_size=max_size)
    text = "" if file is None or file.suffix.lower() == ".json" else file.read_text(encoding="utf-8-sig")
    uvicorn, application = _packages()
    from kinetruss.studio.messages import Session
    from kinetruss.studio.session import LARGE

    drafts = Drafts(target, "untitled" if file is None else file.stem)
    drawing = Session(model, file, target, seen, text, dim=dim, draw=True, drafts=drafts)
    last = drafts.last_address()
    with _listening(port, last[1] if last is not None and token is None else 0) as listener:
        here = listener.getsockname()[1]
        token = token or (last[0] if last is not None and last[1] == here else secrets.token_urlsafe(24))
        drafts.address = token, here
        hosts = [f"{HOST}:{here}", f"localhost:{here}"]
        title = "kinetruss" if model is None or file is None else model.title or file.stem

        def new(key: str) -> Session:
            now, words = drawing.opened()
            return Session(now, file, target, seen, words, drafts=drafts, results=drawing.results, key=key)

        app = application(new, drawing, token, hosts, title)
        config = uvicorn.Config(
            app,
            log_level="error",
            access_log=False,
            ws="websockets-sansio",
            ws_max_size=LARGE,
            ws_per_message_deflate=False,
            server_header=False,
            date_header=False,
            lifespan="off",
            timeout_graceful_shutdown=2,
            proxy_headers=False,
        )
        gc.collect()
        gc.freeze()  # what is loaded stays: to look through it again takes as long as twenty edits
        if ready is not None:
            ready(f"http://{HOST}:{here}/{token}/{'draw/' if draw or model is None else ''}")
        try:
            uvicorn.Server(config).run(sockets=[listener])
        finally:  # Python may abort where it ends while a thread is within a compiled library
            drawing.motions.close(PATIENCE)
            drawing.results.close(PATIENCE)


def _packages() -> tuple[Any, Any]:
    try:
        import uvicorn
        import websockets as _  # noqa: F401 - uvicorn looks for it only when a page connects

        from kinetruss.studio.app import application
    except ImportError as error:
        raise InputError(
            f"The studio needs the package {error.name}. Install what it needs: pip install 'kinetruss[studio]'"
        ) from None
    return uvicorn, application


def _listening(port: int, wished: int) -> socket.socket:
    """A socket that listens on this machine only: at a port, or at a wished one if it is free, or at any."""
    if not port and wished:
        try:
            return _listening(wished, 0)
        except InputError:  # another program has it
            return _listening(0, 0)
    found = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        found.bind((HOST, port))
        found.listen(64)
    except OSError as error:
        found.close()
        raise InputError(f"Port {port} of {HOST} cannot be used: {error.strerror}. Name another one, or none.") from None
    return found
