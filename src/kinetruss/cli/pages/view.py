"""``kinetruss view``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import HELP, PLACE, Verb, json_option, max_size_option, print_json
from kinetruss.cli.pages.browser import browsed
from kinetruss.cli.runs.run_folders import opened_run

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Result
    from kinetruss.runs import RunResult

__all__ = ["loaded", "vibrating", "view"]

EPILOG = """\b
Examples:
  kinetruss view slew.yaml
  kinetruss view runs/slew
  kinetruss view runs/slow --beside runs/fast
  kinetruss view runs/slew -o slew.html --no-open
  kinetruss view bay.yaml --modes
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Show a model or a run in the browser.")
@click.argument("what", metavar="MODEL|OUT", type=PLACE)
@click.option(
    "-o", "--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="Keep the page as this .html file."
)
@click.option("--no-open", is_flag=True, help="Only write the file, do not open it.")
@click.option("--beside", metavar="MODEL|OUT", type=PLACE, help="A second model or run, shown beside the first.")
@click.option("--case", shell_complete=_complete.cases, help="Show only this load case (default: all, to choose from).")
@click.option("--frames", type=click.IntRange(min=2), default=600, show_default=True, help="Samples kept at most.")
@click.option("--modes", is_flag=True, help="For a model: show its vibration modes about its own pose.")
@json_option
@max_size_option
def view(
    what: Path,
    file: Path | None,
    no_open: bool,
    beside: Path | None,
    case: str | None,
    frames: int,
    modes: bool,
    as_json: bool,
    max_size: int,
) -> None:
    """Show a model file or a run folder in the browser: one page that works without a network and can be sent by mail.

    Press ? in the page for its keys. Without -o the page goes to a temporary file.
    """
    if no_open and file is None:
        raise click.UsageError("--no-open needs -o FILE: otherwise the page would be lost.")
    if modes and (what.is_dir() or case is not None or beside is not None):
        raise click.UsageError("--modes goes with one model file, alone.")
    from kinetruss import viewer

    shown, model = vibrating(what, max_size) if modes else (loaded(what, max_size), None)
    other = None if beside is None else loaded(beside, max_size)
    labels = [] if beside is None else _labels(what, beside)
    target = file or _temporary(what)
    path = viewer.write(shown, target, model=model, beside=other, case=case, frames=frames, labels=labels)
    opened = not no_open and browsed(path)
    if as_json:
        print_json("view", {"file": str(path), "bytes": path.stat().st_size, "opened": opened})
    else:
        click.echo(path if no_open or opened else f"{path}\nNo browser could be started. Open the file yourself.")


def loaded(path: Path, max_size: int) -> Model | RunResult:
    """The model of a file, or the run of a folder."""
    if path.is_dir():
        return opened_run(path)
    from kinetruss.io import read

    return read(path, max_size=max_size)


def vibrating(path: Path, max_size: int) -> tuple[Result, Model]:
    """Small motions of the model of a file about its own pose."""
    from kinetruss.dynamics import linearise
    from kinetruss.io import read

    model = read(path, max_size=max_size)
    return linearise(model), model


def _labels(what: Path, beside: Path) -> list[str]:
    """Names that distinguish two files or folders."""
    paths = [what.resolve(), beside.resolve()]
    short = [path.stem for path in paths]
    return short if short[0] != short[1] else ["/".join(path.parts[-2:]) for path in paths]


def _temporary(what: Path) -> Path:
    import tempfile

    return Path(tempfile.mkdtemp(prefix="kinetruss-")) / f"{what.resolve().stem}.html"
