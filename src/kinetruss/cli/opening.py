"""``kinetruss studio`` and ``kinetruss view``, opened in the user's browser."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinetruss.cli import completing
from kinetruss.cli.arguments import opened_run
from kinetruss.cli.common import FILE, HELP, PLACE, Verb, json_option, max_size_option, print_json

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Result
    from kinetruss.runs import RunResult


def browsed(path: Path) -> bool:
    """Open a file in the browser; returns False if no browser can be started."""
    import webbrowser

    return webbrowser.open(path.resolve().as_uri())


# ``kinetruss studio``.

STUDIO_EXAMPLE = """\b
Examples:
  kinetruss studio
  kinetruss studio --new --space
  kinetruss studio slew.yaml
  kinetruss studio slew.yaml --no-open --port 8100
  kinetruss studio slew.yaml --folder trials
"""


@click.command(
    cls=Verb,
    context_settings=HELP,
    epilog=STUDIO_EXAMPLE,
    short_help="Draw a model in the browser, or move its drives by hand.",
)
@click.argument("file", metavar="[MODEL]", type=FILE, required=False)
@click.option("--new", is_flag=True, help="An empty drawing, also where a MODEL could be meant.")
@click.option("--plane", "dim", flag_value=2, type=int, default=2, help="The empty drawing is planar (the default).")
@click.option("--space", "dim", flag_value=3, type=int, help="The empty drawing is spatial.")
@click.option("--draw", is_flag=True, help="Open the drawing page of MODEL instead of its sliders.")
@click.option("--folder", type=FILE, help="The only folder that Save writes to (default: that of MODEL, or this one).")
@click.option("--port", type=click.IntRange(0, 65535), default=0, help="Port on 127.0.0.1 (default: a free one).")
@click.option("--no-open", is_flag=True, help="Only serve the page and print the address.")
@max_size_option
def studio(
    file: Path | None, new: bool, dim: int, draw: bool, folder: Path | None, port: int, no_open: bool, max_size: int
) -> None:
    """Draw a model in the browser, or move the drives of MODEL by sliders, and see forces and mobility at once.

    Without MODEL it opens an empty drawing. A local page, for this machine only, whose address
    holds a random token. Ctrl-C ends it.
    """
    if new and file is not None:
        raise click.UsageError(f"--new opens an empty drawing; {file} is a model. Leave one of them out.")
    # problems of a page are small: on several threads their algebra waits more than it computes
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from kinetruss.studio import serve

    def ready(address: str) -> None:
        click.echo(f"Studio of {'a new drawing' if file is None else file.name}: {address}\nCtrl-C ends it.")
        if not no_open:
            click.launch(address)

    try:
        serve(file, dim=dim, draw=draw, folder=folder, port=port, max_size=max_size, ready=ready)
    except KeyboardInterrupt:
        click.echo("Stopped.")


# ``kinetruss view``.

VIEW_EXAMPLE = """\b
Examples:
  kinetruss view slew.yaml
  kinetruss view runs/slew
  kinetruss view runs/slow --beside runs/fast
  kinetruss view runs/slew -o slew.html --no-open
  kinetruss view bay.yaml --modes
"""


@click.command(cls=Verb, context_settings=HELP, epilog=VIEW_EXAMPLE, short_help="Show a model or a run in the browser.")
@click.argument("what", metavar="MODEL|OUT", type=PLACE)
@click.option(
    "-o", "--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="Keep the page as this .html file."
)
@click.option("--no-open", is_flag=True, help="Only write the file, do not open it.")
@click.option("--beside", metavar="MODEL|OUT", type=PLACE, help="A second model or run, shown beside the first.")
@click.option("--case", shell_complete=completing.cases, help="Show only this load case (default: all, to choose from).")
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
