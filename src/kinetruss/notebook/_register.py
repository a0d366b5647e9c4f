"""Registers the pictures of models and runs with IPython."""

from __future__ import annotations

from typing import Any

from kinetruss.errors import KinetrussError
from kinetruss.notebook._show import show

__all__ = ["register"]

SHOWN = (("kinetruss.model._model", "Model"), ("kinetruss.runs._result", "RunResult"))
"""Modules of the types that are shown; they are not imported here."""


def register(shell: Any) -> None:
    """Show models and runs as pictures in this IPython shell; ``%load_ext kinetruss`` calls it."""
    formatter = shell.display_formatter.formatters["text/html"]
    for module, name in SHOWN:
        formatter.for_type_by_name(module, name, _html)


def _html(what: Any) -> str | None:
    """The picture as HTML; None (plain text is shown) if it cannot be drawn."""
    try:
        return show(what)._repr_html_()
    except KinetrussError:
        return None
