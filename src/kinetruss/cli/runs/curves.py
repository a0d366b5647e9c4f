"""Runs and their quantities: the common arguments of ``plot`` and ``compare``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import PLACE

__all__ = ["curves_of_runs"]

STATION = "Place along the member, 0 to 1 from its first end (default: the largest along it)."


def curves_of_runs(*, quantity: str, member: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """OUT..., --quantity, --member, --case and --station, with the command's own help for the first two."""
    given = (
        click.argument("out", type=PLACE, nargs=-1, required=True),
        click.option("--quantity", multiple=True, shell_complete=_complete.quantities, help=quantity),
        click.option("--member", multiple=True, shell_complete=_complete.parts, help=member),
        click.option("--case", shell_complete=_complete.cases, help="Load case (default: the first)."),
        click.option("--station", type=float, help=STATION),
    )

    def added(verb: Callable[..., Any]) -> Callable[..., Any]:
        for one in reversed(given):
            verb = one(verb)
        return verb

    return added
