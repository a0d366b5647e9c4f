"""``kinetruss plot``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli._verb import FOLDER, HELP, Verb, json_option, print_json
from kinetruss.errors import InputError

__all__ = ["plot"]

EPILOG = """\b
Examples:
  kinetruss plot runs/slew                              # all pictures, into runs/slew/pictures
  kinetruss plot runs/slew --quantity member_force --member M7 -o m7.svg
  kinetruss plot runs/slow runs/fast --quantity drive_force -o both.png
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("out", type=FOLDER, nargs=-1, required=True)
@click.option("--quantity", help="A result by name, e.g. member_force, length, drive_force, position.")
@click.option("--member", multiple=True, help="Only this member, node or drive (may be given several times).")
@click.option("--case", help="Load case (default: the first).")
@click.option("-o", "--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="A .png, .svg or .pdf file.")
@json_option
def plot(out: tuple[Path, ...], quantity: str | None, member: tuple[str, ...], case: str | None, file: Path | None,
         as_json: bool) -> None:  # fmt: skip
    """Draw one quantity of one or more runs over time, or all pictures of a run."""
    from kinetruss import report, runs

    results = [runs.load(path) for path in out]
    if quantity is None and (file is not None or member or len(out) > 1):
        quantity = "member_force"
    if quantity is None:
        written = report.figures(results[0], out[0] / report.PICTURES)
    else:
        target = file or out[0] / report.PICTURES / f"{quantity}.png"
        written = [report.plot(results, quantity, target, members=member, case=case)]
    if not written:
        raise InputError(f"{out[0]} has no good sample to draw.")
    if as_json:
        print_json("plot", {"files": [str(path) for path in written]})
    else:
        click.echo("\n".join(map(str, written)))
