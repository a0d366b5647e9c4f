"""``kinetruss studio``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli._verb import FILE, HELP, Verb, max_size_option

__all__ = ["studio"]

EPILOG = """\b
Examples:
  kinetruss studio slew.yaml
  kinetruss studio slew.yaml --no-open --port 8100
  kinetruss studio slew.yaml --folder trials
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("file", metavar="MODEL", type=FILE)
@click.option("--folder", type=FILE, help="The only folder that Save writes to (default: that of MODEL).")
@click.option("--port", type=click.IntRange(0, 65535), default=0, help="Port on 127.0.0.1 (default: a free one).")
@click.option("--no-open", is_flag=True, help="Only serve the page and print the address.")
@max_size_option
def studio(file: Path, folder: Path | None, port: int, no_open: bool, max_size: int) -> None:
    """Move the drives of a model by sliders in the browser and see forces, reactions and motor demand at once.

    A local page, for this machine only; its address holds a random token. Ctrl-C ends it.
    """
    from kinetruss.studio import serve

    def ready(address: str) -> None:
        click.echo(f"Studio of {file.name}: {address}\nCtrl-C ends it.")
        if not no_open:
            click.launch(address)

    try:
        serve(file, folder=folder, port=port, max_size=max_size, ready=ready)
    except KeyboardInterrupt:
        click.echo("Stopped.")
