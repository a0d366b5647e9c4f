"""A model or a run as a picture in a separate frame."""

from __future__ import annotations

import html
from typing import Any

from kinetruss.viewer import page, scene

__all__ = ["HEIGHT", "framed", "show"]

HEIGHT = 560
"""Default height of the frame, pixels."""


class Picture:
    """An object that a notebook shows as HTML."""

    def __init__(self, text: str) -> None:
        self.text = text

    def _repr_html_(self) -> str:
        return self.text


def show(what: Any, height: int = HEIGHT, **options: Any) -> Picture:
    """Show the page of `viewer.page` in a frame: a model, a run, or with ``model=...`` a motion, forces or a simulation.

    height : pixels. options : as for `viewer.scene`.

    Raises
    ------
    InputError : as for `viewer.scene`.

    Examples
    --------
    >>> import kinetruss as kt
    >>> picture = kt.notebook.show(kt.library.vgt.triangular(), height=400)
    >>> picture.text[:31]
    '<iframe sandbox="allow-scripts"'
    """
    return Picture(framed(page(scene(what, **options)), height))


def framed(text: str, height: int = HEIGHT) -> str:
    """A page in a frame that may run scripts and nothing else."""
    style = f"width:100%;height:{height}px;border:0"
    return f'<iframe sandbox="allow-scripts" style="{style}" srcdoc="{html.escape(text)}"></iframe>'
