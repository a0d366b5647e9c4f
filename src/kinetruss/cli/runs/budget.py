"""``kinetruss budget``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import FILE, HELP, Verb, json_option, max_size_option, print_json
from kinetruss.cli.runs.settings import pairs

__all__ = ["budget"]

EPILOG = """\b
Examples:
  kinetruss budget bay.yaml --of bay.beta --tolerance "M*.length=0.1 mm"
  kinetruss budget bay.yaml --of N8.x --of M6.force --tolerance "sections.*.diameter=1 %" --at "bay.beta=5 deg"
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Pose, force and strain errors from length tolerances."
)
@click.argument("model", metavar="MODEL", type=FILE)
@click.option(
    "--of",
    "of",
    multiple=True,
    required=True,
    metavar="NAME",
    shell_complete=_complete.results,
    help="Coordinate, M8.force, M7.drive_force or G1.strain.",
)
@click.option(
    "--tolerance",
    "tolerances",
    multiple=True,
    required=True,
    metavar="PARAMETER=VALUE",
    help="Half the width of its range: M*.length, N4.play, temperature [K], or a path of the model.",
)
@click.option(
    "--at",
    multiple=True,
    metavar="NAME=VALUE",
    shell_complete=_complete.drives,
    help="Drive or pose coordinate of the pose (default: the model's own).",
)
@click.option("--case", metavar="CASE", shell_complete=_complete.cases, help="Load case of forces and strains.")
@click.option("--samples", default=1000, show_default=True, help="Draws of the Monte Carlo.")
@click.option("--seed", default=0, show_default=True, help="Of the draws.")
@json_option
@max_size_option
def budget(
    model: Path,
    of: tuple[str, ...],
    tolerances: tuple[str, ...],
    at: tuple[str, ...],
    case: str | None,
    samples: int,
    seed: int,
    as_json: bool,
    max_size: int,
) -> None:
    """Errors of poses, forces and strains that tolerances cause: worst case, root sum of squares, Monte Carlo."""
    asked, pose = pairs("--tolerance", tolerances), pairs("--at", at)
    from kinetruss import runs
    from kinetruss.io import read

    loaded = read(model, max_size=max_size)
    found = runs.budget(loaded, of, asked, at=pose or None, load_case=case, samples=samples, seed=seed)
    if as_json:
        print_json("budget", found.record)
    else:
        click.echo(found.text)
