"""``kinetruss gauges``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import FILE, HELP, Verb, json_option, max_size_option, print_json
from kinetruss.cli.models.explain import model_and_run

__all__ = ["gauges"]

EPILOG = """\b
Examples:
  kinetruss gauges strain_gauges.yaml --run slew
  kinetruss gauges strain_gauges.yaml --run slew --measured slew_strain.csv -o overlay.png
  kinetruss gauges runs/slew -o strain.csv
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Readings of strain gauges along a run, in microstrain."
)
@click.argument("model", metavar="MODEL|OUT", type=FILE)
@click.option(
    "--run",
    "name",
    metavar="RUN",
    shell_complete=_complete.runs,
    help="A run of the model (may be omitted if there is only one).",
)
@click.option("--case", metavar="CASE", shell_complete=_complete.cases, help="Load case (default: the run's first).")
@click.option(
    "--measured",
    type=click.Path(path_type=Path),
    multiple=True,
    metavar="FILE",
    help="A measured record to compare with: CSV, t and columns GAUGE or GROUP.axial [microstrain], or GAUGE [mV]. Several are "
    "averaged.",
)
@click.option(
    "-o",
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Also write the histories: .csv, or a picture .png, .svg, .pdf.",
)
@json_option
@max_size_option
def gauges(
    model: Path, name: str | None, case: str | None, measured: tuple[Path, ...], file: Path | None, as_json: bool, max_size: int
) -> None:
    """Compute the readings of a model's strain gauges along a run, and compare them with a measured record.

    The run is computed exactly at the measured times.
    """
    loaded, chosen = model_and_run(model, name, max_size)
    from kinetruss import report, runs, strength

    record = strength.measured_strains(loaded, measured, max_size=max_size) if measured else None
    strains = runs.gauge_strains(loaded, chosen, load_case=case, measured=record)
    compared = None if record is None else strength.compare_gauges(strains, record)
    page = report.gauges(strains, compared)
    written = None
    if file is not None and file.suffix == ".csv":
        written = page.write(file)
    elif file is not None:
        written = report.gauges_picture(strains, compared, file, loaded.title)
    if as_json:
        print_json("gauges", {**page.record, "written": None if written is None else str(written)})
    else:
        click.echo(page.text if written is None else f"{page.text}\n\n{written}")
