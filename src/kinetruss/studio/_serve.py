"""Run the studio of a model file until Ctrl-C."""

from __future__ import annotations

import secrets
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.io import MAX_SIZE, read

__all__ = ["serve"]

HOST = "127.0.0.1"


def serve(
    path: str | Path,
    *,
    folder: str | Path | None = None,
    port: int = 0,
    token: str | None = None,
    max_size: int = MAX_SIZE,
    ready: Callable[[str], Any] | None = None,
) -> None:
    """Serve the live page of a model file to browsers of this machine, until interrupted.

    Parameters
    ----------
    path : the model file; it is read once, and every new page starts from it.
    folder : the only folder in which pages can save; by default the folder of the model file.
    port : on 127.0.0.1; 0 selects a free one. token : part of the address; by default 32 random characters.
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
    file = Path(path).resolve()
    target = file.parent if folder is None else Path(folder).resolve()
    if not target.is_dir():
        raise InputError(f"There is no folder {target}. Make it, or name another one.")
    from kinetruss.studio._save import seen_now

    seen = seen_now(file)  # before the file is read: a later change is by another program
    model = read(file, max_size=max_size)
    uvicorn, application, session = _packages()
    token = token or secrets.token_urlsafe(24)
    with _listening(port) as listener:
        here = listener.getsockname()[1]
        hosts = [f"{HOST}:{here}", f"localhost:{here}"]
        app = application(lambda: session(model, file, target, seen), token, hosts, model.title or file.stem)
        config = uvicorn.Config(
            app,
            log_level="error",
            access_log=False,
            ws="websockets-sansio",
            ws_max_size=_longest(),
            ws_per_message_deflate=False,
            server_header=False,
            date_header=False,
            lifespan="off",
            timeout_graceful_shutdown=2,
            proxy_headers=False,
        )
        if ready is not None:
            ready(f"http://{HOST}:{here}/{token}/")
        uvicorn.Server(config).run(sockets=[listener])


def _packages() -> tuple[Any, Any, Any]:
    try:
        import uvicorn
        import websockets as _  # noqa: F401 - uvicorn looks for it only when a page connects

        from kinetruss.studio._app import application
    except ImportError as error:
        raise InputError(
            f"The studio needs the package {error.name}. Install what it needs: pip install 'kinetruss[studio]'"
        ) from None
    from kinetruss.studio._session import Session

    return uvicorn, application, Session


def _longest() -> int:
    from kinetruss.studio._commands import MOST

    return MOST


def _listening(port: int) -> socket.socket:
    """A socket that listens on this machine only."""
    found = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        found.bind((HOST, port))
        found.listen(64)
    except OSError as error:
        found.close()
        raise InputError(f"Port {port} of {HOST} cannot be used: {error.strerror}. Name another one, or none.") from None
    return found
