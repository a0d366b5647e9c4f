"""``kinetruss studio``."""

from __future__ import annotations

import os
from pathlib import Path

import click

from kinetruss.cli._verb import FILE, HELP, Verb, max_size_option

__all__ = ["studio"]

EPILOG = """\b
Examples:
  kinetruss studio
  kinetruss studio --new --space
  kinetruss studio slew.yaml
  kinetruss studio slew.yaml --no-open --port 8100
  kinetruss studio slew.yaml --folder trials
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Draw a model in the browser, or move its drives by hand."
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
