"""Opening a page in the user's browser."""

from __future__ import annotations

from pathlib import Path

__all__ = ["browsed"]


def browsed(path: Path) -> bool:
    """Open a file in the browser; returns False if no browser can be started."""
    import webbrowser

    return webbrowser.open(path.resolve().as_uri())
