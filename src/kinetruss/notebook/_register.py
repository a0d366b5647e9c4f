"""Tell IPython how models and runs look."""

from __future__ import annotations

from typing import Any

from kinetruss.errors import KinetrussError
from kinetruss.notebook._show import show

__all__ = ["register"]

SHOWN = (("kinetruss.model._model", "Model"), ("kinetruss.runs._result", "RunResult"))
"""Where the types that are shown live; they are not imported for it."""


def register(shell: Any) -> None:
    """Show models and runs as pictures in this IPython shell; ``%load_ext kinetruss`` calls it."""
    formatter = shell.display_formatter.formatters["text/html"]
    for module, name in SHOWN:
        formatter.for_type_by_name(module, name, _html)


def _html(what: Any) -> str | None:
    """The picture; None (the plain text remains) of what cannot be shown."""
    try:
        return show(what)._repr_html_()
    except KinetrussError:
        return None
