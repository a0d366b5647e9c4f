"""``kinetruss export``."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

import click

from kinetruss.cli._verb import FOLDER, HELP, Verb, json_option, print_json
from kinetruss.cli.runs.run_folders import opened_run

__all__ = ["export"]

EPILOG = """\b
Examples:
  kinetruss export runs/slew slew.csv
  kinetruss export runs/slew slew.nc
  kinetruss export runs/slew margins.csv --group verdict
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("out", type=FOLDER)
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path))
@click.option("--group", multiple=True, metavar="GROUP", help="Only motion, forces, sections, verdict or demand (may repeat).")
@json_option
def export(out: Path, file: Path, group: tuple[str, ...], as_json: bool) -> None:
    """Write a run to FILE: .csv (one row per instant), .parquet (one row per value) or .nc (netCDF, all arrays with units).

    With --group verdict a .csv holds the utilisation table.
    """
    from kinetruss.io import export as write

    with TemporaryDirectory(prefix="kinetruss-") as scratch:
        found = opened_run(out, Path(scratch) / "pair")
        written = write(found.path or out, file, groups=group)
    if as_json:
        print_json("export", {"out": str(out), "file": str(written)})
    else:
        click.echo(str(written))
