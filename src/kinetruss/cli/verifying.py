"""``kinetruss verify``."""

from __future__ import annotations

from typing import Any

import click

from kinetruss.cli import completing
from kinetruss.cli.common import HELP, Verb, bar, json_option, print_json
from kinetruss.errors import InputError

EPILOG = """\b
Examples:
  kinetruss verify
  kinetruss verify --filter "Table 5.2"
  kinetruss verify --filter printed
  kinetruss verify --json > verification.json
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Recompute published and exact results on this machine."
)
@json_option
@click.option(
    "--filter",
    "wanted",
    metavar="TEXT",
    shell_complete=completing.tests,
    help="Only cases whose id, class or source contains TEXT.",
)
def verify(as_json: bool, wanted: str | None) -> None:
    """Compare this installation with all published and exact references of kinetruss.

    The class of a case says what its agreement shows. Inputs that differ from the printed ones are named.

    Exit code 0: all agree; 1: at least one does not; 2: no case has the text.
    """
    from kinetruss.verification import verify as compare

    with bar(as_json, "values") as progress:
        found = compare(wanted, progress)
    if not found.entries:
        raise InputError(f"No case has {wanted!r} in its id, class or source. `kinetruss verify` lists all of them.")
    if as_json:
        print_json("verify", found.as_dict())
    else:
        _print(found)
    if found.failed:
        raise click.exceptions.Exit(1)


def _print(found: Any) -> None:
    from kinetruss.display import Table, number

    head = ("case", "class", "expected", "computed", "relative difference", "tolerance", "")
    rows = [
        (
            e.id,
            e.kind,
            number(e.expected, 8),
            number(e.computed, 8),
            number(e.relative_difference, 2),
            number(e.tolerance, 2),
            "ok" if e.passed else "MISSED",
        )
        for e in found.entries
    ]
    click.echo(Table(head, rows).text)
    _print_own(found)
    _print_texts(found, "Inputs that are not the printed ones", lambda entry: entry.inferred)
    _print_texts(found, "Notes", lambda entry: (entry.note,) if entry.note else ())
    _print_classes(found)
    kept = found.passed - found.verified
    checks = f" ({kept} more only check inputs)" if kept else ""
    click.echo(f"\n{found.passed} passed, {found.failed} failed; {found.verified} verified{checks}")


def _print_own(found: Any) -> None:
    """Print the product's own values next to those of wrong formulas or inputs of the source."""
    from kinetruss.display import Table, number

    rows = [
        (e.id, number(e.expected, 5), number(e.computed, 8), number(e.product, 8))
        for e in found.entries
        if e.product is not None
    ]
    if rows:
        click.echo("\nPrinted, repeated as the source has it, and what kinetruss itself gives:\n")
        click.echo(Table(("case", "printed", "as the source has it", "kinetruss"), rows).text)


def _print_texts(found: Any, title: str, texts: Any) -> None:
    """Print every text once, with its cases."""
    cases: dict[str, list[str]] = {}
    for entry in found.entries:
        for text in texts(entry):
            cases.setdefault(text, []).append(entry.id)
    if cases:
        click.echo(f"\n{title}:")
    for text, ids in cases.items():
        click.echo(f"- {text}\n  {', '.join(ids)}")


def _print_classes(found: Any) -> None:
    from kinetruss.display import Table
    from kinetruss.verification import CLAIMS

    rows = [(kind, str(number), str(agree), CLAIMS[kind]) for kind, (number, agree) in found.classes.items()]
    if rows:
        click.echo("\nWhat agreement shows, by class:\n")
        click.echo(Table(("class", "entries", "agree", "claim"), rows).text)
