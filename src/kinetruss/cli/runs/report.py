"""``kinetruss report``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli._verb import FOLDER, HELP, Verb, json_option, print_json
from kinetruss.cli.pages.browser import browsed

__all__ = ["report"]

EPILOG = """\b
Examples:
  kinetruss report runs/slew
  kinetruss report runs/slew -o slew --no-open
  kinetruss report runs/slew --no-pdf --frames 200
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("run", metavar="RUN", type=FOLDER)
@click.option(
    "-o",
    "--output",
    "folder",
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder for the report (default: RUN/report).",
)
@click.option("--no-open", is_flag=True, help="Only write it, do not open it.")
@click.option("--no-pdf", is_flag=True, help="Do not write report.pdf.")
@click.option("--no-view", is_flag=True, help="Show a still picture instead of the three-dimensional view.")
@click.option("--frames", type=click.IntRange(min=2), default=600, show_default=True, help="Samples in the view at most.")
@json_option
def report(run: Path, folder: Path | None, no_open: bool, no_pdf: bool, no_view: bool, frames: int, as_json: bool) -> None:
    """Write a report of a run folder: FOLDER/report.html and, if Chromium is installed, FOLDER/report.pdf.

    What was analysed, mobility, worst members, envelopes, actuator demands, plots, checks, warnings, method and sources, and
    the model itself. The page works without a network. If the run is not complete, the top of the report says so.
    """
    from datetime import date

    from kinetruss import report as reports
    from kinetruss import runs, viewer
    from kinetruss.results.store import REPORT

    found = seen = runs.load(run)
    if isinstance(found, runs.MissionRun) and not no_view:
        seen = runs.governing(found)
    view = "" if no_view else viewer.page(viewer.scene(seen, frames=frames))
    written = reports.write_document(found, folder or run / REPORT, view=view, date=date.today().isoformat(), pdf=not no_pdf)
    shown = not no_open and browsed(written.page)
    if as_json:
        paper = None if written.paper is None else str(written.paper)
        print_json(
            "report", {"html": str(written.page), "pdf": paper, "note": written.note, "whole": found.whole, "opened": shown}
        )
        return
    click.echo("\n".join(str(path) for path in (written.page, written.paper) if path is not None))
    if written.note:
        click.echo(written.note, err=True)
    if not found.whole:
        click.echo(f"The run is not complete: {found.good} of {found.samples} samples are good. The report says so.", err=True)
    if not no_open and not shown:
        click.echo("No browser could be started. Open the file yourself.", err=True)
