"""``kinetruss size``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli._verb import FILE, HELP, Verb, json_option, max_size_option, print_json

__all__ = ["size"]

EPILOG = """\b
Examples:
  kinetruss examples double_octahedral_slew --copy my
  kinetruss size my/double_octahedral_slew.yaml my/double_octahedral_slew.mission.yaml -o my/sized.yaml
  kinetruss check my/sized.yaml
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Lightest tubes and smallest drives that are enough.")
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
