"""Registers the pictures of models, runs and results with IPython."""

from __future__ import annotations

from typing import Any

from kinetruss.display import Markup, element
from kinetruss.errors import KinetrussError

__all__ = ["register"]

FRAMED = (("kinetruss.model.the_model", "Model"), ("kinetruss.runs.results", "RunResult"))
"""Modules of the types that are shown in a frame; they are not imported here."""
RESULT = ("kinetruss.results.records", "Result")
"""The base of motions, forces and all other results; shown by curves."""


def register(shell: Any) -> None:
    """Show models, runs and results as pictures in this IPython shell.

    ``import kinetruss`` in a notebook calls it, and so does ``%load_ext kinetruss``.

    >>> import kinetruss as kt
    >>> from IPython.core.interactiveshell import InteractiveShell
    >>> shell = InteractiveShell()
    >>> kt.notebook.register(shell)
    >>> shell.display_formatter.formatters["text/html"](kt.library.vgt.triangular())[:7]
    '<iframe'
    """
    formatter = shell.display_formatter.formatters["text/html"]
    for module, name in FRAMED:
        formatter.for_type_by_name(module, name, _framed)
    formatter.for_type_by_name(*RESULT, _drawn)


def _framed(what: Any) -> str | None:
    """The page of a model or run; None (plain text is shown) if it cannot be drawn."""
    from kinetruss.notebook._show import show

    try:
        return show(what)._repr_html_()
    except KinetrussError:
        return None


def _drawn(result: Any) -> str:
    """The curves of a result, and below them what it holds."""
    from kinetruss.report import histories_svg

    drawn = histories_svg(result)
    text = element("pre", repr(result), style="font-family:monospace")
    if drawn is None:
        return text
    picture = Markup(drawn[drawn.index("<svg") :])
    return element("div", element("div", picture, style="max-width:900px;background:#fff"), element("details", text, open=True))
