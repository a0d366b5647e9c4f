"""``kinetruss verify``."""

from __future__ import annotations

from typing import Any

import click

from kinetruss.cli._verb import HELP, Verb, json_option, print_json

__all__ = ["verify"]

EPILOG = """\b
Examples:
  kinetruss verify
  kinetruss verify --filter "Table 5.2"
  kinetruss verify --json > verification.json
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@json_option
@click.option("--filter", "wanted", metavar="TEXT", help="Only cases whose id or source contains TEXT.")
def verify(as_json: bool, wanted: str | None) -> None:
    """Compare this installation with every published and exact reference that kinetruss claims.

    Exit code 0: all agree; 1: at least one does not.
    """
    from kinetruss.verification import verify as compare

    found = compare(wanted)
    if as_json:
        print_json("verify", found.as_dict())
    else:
        _print(found)
    if found.failed:
        raise click.exceptions.Exit(1)


def _print(found: Any) -> None:
    from kinetruss.report import number, table

    head = ("case", "expected", "computed", "relative difference", "tolerance", "")
    rows = [
        (e.id, number(e.expected, 8), number(e.computed, 8), number(e.relative_difference, 2), number(e.tolerance, 2),
         "ok" if e.passed else "MISSED")
        for e in found.entries
    ]  # fmt: skip
    click.echo(table(head, rows))
    click.echo(f"\n{found.passed} passed, {found.failed} failed")
