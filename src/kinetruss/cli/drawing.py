"""``kinetruss picture`` and ``kinetruss render``."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import click

from kinetruss.cli import completing
from kinetruss.cli.common import HELP, PLACE, Verb, bar, instant, json_option, max_size_option, print_json

PICTURE_EXAMPLE = """\b
Examples:
  kinetruss picture bay.yaml -o bay.pdf
  kinetruss picture runs/slew -o slew.pdf --at 0s --at 6s --at 12s --colour force --width page
  kinetruss picture runs/slew -o slew.svg --at 8s --ghost --path N8
  kinetruss picture runs/frame -o moments.pdf --show M
"""

paths_option = click.option(
    "--path", "paths", multiple=True, metavar="NODE", shell_complete=completing.nodes,
    help="Draw the path of a node (may be given several times).",
)  # fmt: skip


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


@click.command(
    cls=Verb, context_settings=HELP, epilog=PICTURE_EXAMPLE, short_help="Draw a model or a run as a picture for print."
)
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
    shell_complete=completing.one_of("force", "stress", "utilisation"),
    help="force, stress or utilisation (default: the kinds of members).",
)
@click.option(
    "--show",
    shell_complete=completing.one_of("N", "V", "M", "V2", "V3", "M2", "M3", "torque", "deflection"),
    help="Draw over the structure: N, V, M (in space N, V2, V3, M2, M3, torque) or deflection.",
)
@click.option("--case", shell_complete=completing.cases, help="Load case (default: the first).")
@click.option(
    "--width",
    default="column",
    show_default=True,
    callback=width,
    shell_complete=completing.one_of("column", "page"),
    metavar="MM|column|page",
    help="Width on paper: 90 mm (column), 190 mm (page), or millimetres.",
)
@click.option(
    "--view",
    default="iso",
    shell_complete=completing.one_of("iso", "front", "side", "top"),
    show_default=True,
    help="iso, front, side or top.",
)
@click.option("--ghost", is_flag=True, help="The start pose in grey.")
@paths_option
@click.option("--no-loads", is_flag=True, help="Without arrows of loads.")
@click.option("--names/--no-names", default=None, help="Names of nodes (default: up to 24 nodes).")
@click.option("--title", default="", help="A title above; journals use a caption instead.")
@json_option
@max_size_option
def picture(what: Path, file: Path, at: list[float], colour: str | None, show: str | None, case: str | None,
            width: str | float, view: str, ghost: bool, paths: tuple[str, ...], no_loads: bool, names: bool | None,
            title: str, as_json: bool, max_size: int) -> None:  # fmt: skip
    """Draw a model file, or a run folder at some instants, for print: vector lines and text, no pixels.

    Driven members are green, supports have the usual symbols, loads are purple arrows. For shaded pictures and films:
    kinetruss render.
    """
    from kinetruss import report
    from kinetruss.cli.opening import loaded

    path = report.picture(
        loaded(what, max_size),
        file,
        at=at,
        colour=colour,
        show=show,
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


# ``kinetruss render``.

RENDER_EXAMPLE = """\b
Examples:
  kinetruss render slew.yaml -o bay.png
  kinetruss render runs/slew -o worst.png --at 6s --colour utilisation --ghost
  kinetruss render runs/slew -o slew.mp4
  kinetruss render runs/slew -o slew.gif --size 640x360 --speed 2 --path N8
  kinetruss render bay.yaml -o mode1.gif --mode 1

Needs Chromium (Debian: apt-get install chromium), and for MP4 pip install 'kinetruss[render]' (ffmpeg); no display.
"""


def _size(_ctx: click.Context, _option: click.Parameter, text: str) -> tuple[int, int]:
    found = re.fullmatch(r"\s*(\d{1,5})\s*[x×]\s*(\d{1,5})\s*", text)
    if found is None:
        raise click.BadParameter(f"{text!r} is not a size. Write width x height in pixels, e.g. 1280x720.")
    return int(found[1]), int(found[2])


def _camera(_ctx: click.Context, _option: click.Parameter, text: str) -> str | tuple[float, ...]:
    if "," not in text:
        return text
    try:
        return tuple(float(one) for one in text.split(","))
    except ValueError:
        raise click.BadParameter(f"{text!r} is not a direction. Write three numbers, e.g. 1,-1,0.5.") from None


@click.command(cls=Verb, context_settings=HELP, epilog=RENDER_EXAMPLE, short_help="Shaded picture or film of a model or a run.")
@click.argument("what", metavar="MODEL|OUT", type=PLACE)
@click.option(
    "-o",
    "--output",
    "file",
    required=True,
    type=click.Path(dir_okay=False, path_type=Path),
    help="A picture (.png) or a film (.mp4, .gif).",
)
@click.option(
    "--colour",
    "--color",
    "colour",
    help="force, stress, utilisation, buckling, speed or kind (default: force, if known).",
    shell_complete=completing.one_of("force", "stress", "utilisation", "buckling", "speed", "kind"),
)
@click.option(
    "--camera",
    default="iso",
    show_default=True,
    callback=_camera,
    shell_complete=completing.one_of("iso", "front", "side", "top"),
    help="iso, front, side, top, or the direction X,Y,Z from the structure to the eye.",
)
@click.option("--size", default="1280x720", show_default=True, callback=_size, help="Width x height, pixels.")
@click.option("--at", metavar="TIME", callback=instant, help="Instant of a picture (default: the start).")
@click.option("--fps", type=float, default=30.0, show_default=True, help="Frames per second of a film.")
@click.option("--speed", type=float, help="How much faster than in reality (default: a film of 5 to 8 s).")
@click.option("--case", shell_complete=completing.cases, help="Load case (default: the first).")
@click.option("--mode", type=click.IntRange(min=1), help="For a model: its vibration mode with this number.")
@click.option("--ghost", is_flag=True, help="The start pose as thin lines.")
@paths_option
@click.option(
    "--faces/--no-faces", default=None, help="Triangles of rigid bars as faces (default: if no member has a section)."
)
@click.option("--no-loads", is_flag=True, help="Without arrows of loads.")
@click.option("--no-grid", is_flag=True, help="Without the grid.")
@click.option("--bare", is_flag=True, help="Without title, time, legend and axes.")
@json_option
@max_size_option
def render(
    what: Path, file: Path, as_json: bool, max_size: int, mode: int | None, no_loads: bool, no_grid: bool, **chosen: Any
) -> None:
    """Write a shaded picture or a film of a model file or a run folder. No display is needed.

    Each frame shows the nearest computed sample. An interrupted film leaves no file.
    """
    if mode is not None and what.is_dir():
        raise click.UsageError("--mode goes with a model file.")
    from kinetruss import viewer
    from kinetruss.cli.opening import loaded, vibrating

    shown, model = (loaded(what, max_size), None) if mode is None else vibrating(what, max_size)
    with bar(as_json, "frames") as progress:
        path = viewer.render(
            shown,
            file,
            model=model,
            mode=None if mode is None else mode - 1,
            loads=not no_loads,
            grid=not no_grid,
            progress=progress,
            **chosen,
        )
    if as_json:
        print_json("render", {"file": str(path), "bytes": path.stat().st_size})
    else:
        click.echo(path)
