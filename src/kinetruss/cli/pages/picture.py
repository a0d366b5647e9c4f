"""``kinetruss picture``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import HELP, PLACE, Verb, instant, json_option, max_size_option, print_json

__all__ = ["picture", "width"]

EPILOG = """\b
Examples:
  kinetruss picture bay.yaml -o bay.pdf
  kinetruss picture runs/slew -o slew.pdf --at 0s --at 6s --at 12s --colour force --width page
  kinetruss picture runs/slew -o slew.svg --at 8s --ghost --path N8
"""


def instants(ctx: click.Context, option: click.Parameter, texts: tuple[str, ...]) -> list[float]:
    """Seconds from several texts."""
    return [found for text in texts if (found := instant(ctx, option, text)) is not None]


def width(_ctx: click.Context, _option: click.Parameter, text: str | None) -> str | float | None:
    """A name, or millimetres with or without their unit."""
    if text is None:
        return None
    try:
        return float(text.strip().removesuffix("mm"))
    except ValueError:
        return text


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Draw a model or a run as a picture for print.")
@click.argument("what", metavar="MODEL|OUT", type=PLACE)
@click.option(
    "-o", "--output", "file", required=True, type=click.Path(dir_okay=False, path_type=Path), help="A .pdf, .svg or .png file."
)
@click.option(
    "--at", multiple=True, metavar="TIME", callback=instants, help="Instants of a run, side by side (default: the start)."
)
@click.option(
    "--colour",
    "--color",
    "colour",
    shell_complete=_complete.one_of("force", "stress", "utilisation"),
    help="force, stress or utilisation (default: the kinds of members).",
)
@click.option("--case", shell_complete=_complete.cases, help="Load case (default: the first).")
@click.option(
    "--width",
    default="column",
    show_default=True,
    callback=width,
    shell_complete=_complete.one_of("column", "page"),
    metavar="MM|column|page",
    help="Width on paper: 90 mm (column), 190 mm (page), or millimetres.",
)
@click.option(
    "--view",
    default="iso",
    shell_complete=_complete.one_of("iso", "front", "side", "top"),
    show_default=True,
    help="iso, front, side or top.",
)
@click.option("--ghost", is_flag=True, help="The start pose in grey.")
@click.option(
    "--path",
    "paths",
    multiple=True,
    metavar="NODE",
    shell_complete=_complete.nodes,
    help="Draw the path of a node (may be given several times).",
)
@click.option("--no-loads", is_flag=True, help="Without arrows of loads.")
@click.option("--names/--no-names", default=None, help="Names of nodes (default: up to 24 nodes).")
@click.option("--title", default="", help="A title above; journals use a caption instead.")
@json_option
@max_size_option
def picture(what: Path, file: Path, at: list[float], colour: str | None, case: str | None, width: str | float, view: str,
            ghost: bool, paths: tuple[str, ...], no_loads: bool, names: bool | None, title: str, as_json: bool,
            max_size: int) -> None:  # fmt: skip
    """Draw a model file, or a run folder at some instants, for print: vector lines and text, no pixels.

    Driven members are green, supports triangles, loads purple arrows. For shaded pictures and films: kinetruss render.
    """
    from kinetruss import report
    from kinetruss.cli.pages.view import loaded

    path = report.picture(
        loaded(what, max_size),
        file,
        at=at,
        colour=colour,
        case=case,
        width=width,
        view=view,
        ghost=ghost,
        paths=paths,
        loads=not no_loads,
        names=names,
        title=title,
    )
    if as_json:
        print_json("picture", {"file": str(path), "bytes": path.stat().st_size})
    else:
        click.echo(path)
