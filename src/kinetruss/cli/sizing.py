"""``kinetruss size`` and ``kinetruss budget``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import completing
from kinetruss.cli.arguments import pairs
from kinetruss.cli.common import FILE, HELP, Verb, json_option, max_size_option, print_json

SIZE_EXAMPLE = """\b
Examples:
  kinetruss examples double_octahedral_slew --copy my
  kinetruss size my/double_octahedral_slew.yaml my/double_octahedral_slew.mission.yaml -o my/sized.yaml
  kinetruss check my/sized.yaml
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=SIZE_EXAMPLE, short_help="Lightest tubes and smallest drives that are enough."
)
@click.argument("model", type=FILE)
@click.argument("mission", type=FILE)
@click.option("-o", "--out", type=click.Path(dir_okay=False, path_type=Path), help="File for the sized model (.yaml or .json).")
@json_option
@max_size_option
def size(model: Path, mission: Path, out: Path | None, as_json: bool, max_size: int) -> None:
    """Choose the lightest tubes and the smallest drives with which a MODEL fulfils a MISSION.

    A mission names runs and load cases, member groups, catalogues and safety factors. Exit code 0: done; 1: no part in
    the catalogues is strong enough, or the sizing does not converge; 2: wrong usage, or faults of model, mission or catalogues.
    """
    from kinetruss.io import read, read_mission, write

    given = read(model, max_size=max_size)
    task = read_mission(mission, given, max_size=max_size)
    from kinetruss import design

    sizing = design.size(given, task)
    written = None if out is None else write(sizing.model, out)
    if as_json:
        print_json("size", {**design.record(sizing), "file": None if written is None else str(written)})
        return
    click.echo(design.table(sizing))
    if written is not None:
        click.echo(f"The sized model is in {written}.")


# ``kinetruss budget``.

BUDGET_EXAMPLE = """\b
Examples:
  kinetruss budget bay.yaml --of bay.beta --tolerance "M*.length=0.1 mm"
  kinetruss budget bay.yaml --of N8.x --of M6.force --tolerance "sections.*.diameter=1 %" --at "bay.beta=5 deg"
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=BUDGET_EXAMPLE, short_help="Pose, force and strain errors from length tolerances."
)
@click.argument("model", metavar="MODEL", type=FILE)
@click.option(
    "--of",
    "of",
    multiple=True,
    required=True,
    metavar="NAME",
    shell_complete=completing.results,
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
    shell_complete=completing.drives,
    help="Drive or pose coordinate of the pose (default: the model's own).",
)
@click.option("--case", metavar="CASE", shell_complete=completing.cases, help="Load case of forces and strains.")
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
