"""``kinetruss report``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli.common import HELP, PLACE, Verb, json_option, print_json
from kinetruss.cli.opening import browsed

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from kinetruss.report import Page

    Made = tuple[Page, str, Sequence[str], str]
    """A page, its view, its result in lines, and what it lacks, in words."""


EPILOG = """\b
Examples:
  kinetruss report runs/slew
  kinetruss report runs/slew -o slew --no-open --paper letter
  kinetruss report runs/slew --project Footbridge --author "B. Lee" --revision B
  kinetruss report runs/lightest                        # the folder of kinetruss optimise
  kinetruss report runs/slew --summary --logo logo.svg
  kinetruss size truss.yaml task.yaml --json > sizing.json && kinetruss report sizing.json
"""
BLOCK = {
    "project": "Name of the project.",
    "client": "Client.",
    "number": "Number of the document.",
    "author": "Author.",
    "checker": "Checker.",
    "revision": "Revision.",
    "date": "Date of the report (default: today).",
}
"""Entries of the title block and the help of their options."""


def _title_block(command: Callable[..., None]) -> Callable[..., None]:
    """The options of the title block."""
    for name, words in reversed(BLOCK.items()):
        command = click.option(f"--{name}", metavar="TEXT", default="", help=words)(command)
    return command


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Report of a run, optimum or sizing as HTML and PDF.")
@click.argument("run", metavar="RUN", type=PLACE)
@click.option(
    "-o",
    "--output",
    "folder",
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder for the report (default: RUN/report).",
)
@click.option("--paper", type=click.Choice(["a4", "letter"]), default="a4", show_default=True, help="Paper of the PDF.")
@click.option("--no-open", is_flag=True, help="Only write it, do not open it.")
@click.option("--no-pdf", is_flag=True, help="Do not write report.pdf.")
@click.option("--no-view", is_flag=True, help="Show a still picture instead of the three-dimensional view.")
@click.option("--frames", type=click.IntRange(min=2), default=600, show_default=True, help="Samples in the view at most.")
@click.option("--summary", is_flag=True, help="Only result, figure, governing calculation, assumptions: one or two sheets.")
@click.option("--logo", metavar="FILE", type=click.Path(path_type=Path), help="Logo above the title block: PNG or SVG.")
@_title_block
@json_option
def report(
    run: Path,
    folder: Path | None,
    paper: str,
    no_open: bool,
    no_pdf: bool,
    no_view: bool,
    frames: int,
    summary: bool,
    logo: Path | None,
    as_json: bool,
    **entries: str,
) -> None:
    """Write a report of the folder of a run or an optimum, or of a sizing in a JSON file: report.html and, if Chromium is
    installed, report.pdf.

    The result with the governing member or drive comes first, also on stdout. Then assumptions and what was not checked, the
    structure with its loads, worked calculations, tables, plots, checks, sources, and the model itself. Empty entries of the
    title block are those of `report` in the model, or lines to fill in. The page works without a network. A summary is
    summary.html and summary.pdf, beside those of the whole report.
    """
    from datetime import date

    from kinetruss import report as reports
    from kinetruss.model import TitleBlock
    from kinetruss.results.folder import REPORT

    asked = {"date": date.today().isoformat(), "block": TitleBlock(**entries), "paper": paper, "logo": logo}
    from kinetruss.design.optimum_folder import is_optimum

    make = _of_sizing if run.is_file() else _of_optimum if is_optimum(run) else _of_run
    page, view, lines, lacking = make(run, 0 if no_view or summary else frames, asked | {"summary": summary})
    place = folder or (run.with_suffix("") if run.is_file() else run) / REPORT
    written = reports.write_page(page, place, view=view, pdf=not no_pdf, summary=summary)
    shown = not no_open and browsed(written.page)
    if as_json:
        pdf = None if written.paper is None else str(written.paper)
        fields = {"html": str(written.page), "pdf": pdf, "note": written.note, "whole": not lacking, "opened": shown}
        print_json("report", fields | {"result": list(lines)})
        return
    click.echo("\n".join([*lines, *(str(path) for path in (written.page, written.paper) if path is not None)]))
    if written.note:
        click.echo(written.note, err=True)
    if lacking:
        click.echo(f"{lacking} The report says so.", err=True)
    if not no_open and not shown:
        click.echo("No browser could be started. Open the file yourself.", err=True)


def _of_run(path: Path, frames: int, asked: dict[str, Any]) -> Made:
    """The report of a run folder."""
    from kinetruss import report, runs

    found = runs.load(path)
    seen = runs.governing(found) if isinstance(found, runs.MissionRun) and frames else found
    view = _view(seen, frames)
    return report.document_page(found, view, **asked), view, report.lines(found), _lacking(found)


def _lacking(run: Any) -> str:
    return "" if run.whole else f"The run is not complete: {run.good} of {run.samples} samples are good."


def _of_optimum(path: Path, _frames: int, asked: dict[str, Any]) -> Made:
    """The report of the folder of an optimum."""
    from kinetruss import design, report

    if asked.pop("summary"):
        raise click.UsageError("The report of an optimum has no summary. Leave --summary out.")
    found = design.load_optimum(path)
    page = report.optimum_page(found, **asked)
    lacking = {"finished": "", "interrupted": "The search was interrupted.", "searching": "The search is not finished."}
    return page, "", page.record["result"], lacking.get(found.state, "There is no optimum.")


def _of_sizing(path: Path, frames: int, asked: dict[str, Any]) -> Made:
    """The report of a sizing, with the view of its governing run."""
    from kinetruss import report

    found = report.read_sizing(path)
    page = report.sizing_page(found, **asked)
    if not frames:
        return page, "", report.lines(page.found), _lacking(page.found)
    view = _view(page.found, frames)
    return report.sizing_page(found, view, **asked), view, report.lines(page.found), _lacking(page.found)


def _view(run: Any, frames: int) -> str:
    from kinetruss import viewer

    return viewer.page(viewer.scene(run, frames=frames)) if frames else ""
