"""``kinetruss compare``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli._verb import HELP, Verb, json_option, print_json
from kinetruss.cli.runs.curves import curves_of_runs
from kinetruss.cli.runs.run_folders import opened

__all__ = ["compare"]

EPILOG = """\b
Examples:
  kinetruss compare runs/compare
  kinetruss compare runs/slow runs/fast --quantity von_mises --member follower -o maxima.csv
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Largest values of several runs side by side.")
@curves_of_runs(
    quantity="As for plot (may be given several times; default: the most important ones).",
    member="Only this member, node or drive (default: the largest of all).",
)
@click.option("-o", "--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="Also write a .csv file.")
@json_option
def compare(
    out: tuple[Path, ...],
    quantity: tuple[str, ...],
    member: tuple[str, ...],
    case: str | None,
    station: float | None,
    file: Path | None,
    as_json: bool,
) -> None:
    """Compare the largest values of several runs, with their times, and with the same poses at rest.

    OUT is a run folder, or a folder that holds runs. The ratio is the largest value in motion divided by the largest one at
    rest.
    """
    from kinetruss import report

    found = report.compare(opened(out), quantity, members=member, case=case, station=station)
    written = None if file is None else found.write(file)
    if as_json:
        print_json("compare", {"rows": found.record, "file": None if written is None else str(written)})
        return
    click.echo(found.text)
    if written is not None:
        click.echo(f"\n{written}")
