"""``kinetruss optimise``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli.common import FILE, HELP, Verb, bar, json_option, max_size_option, print_json

EPILOG = """\b
Examples:
  kinetruss optimise lightest.yaml -o runs/lightest      # the file names model, variables, limits
  kinetruss optimise lightest.yaml -o runs/lightest      # the same again goes on where it was stopped
  kinetruss optimise mast.yaml -o runs/mast              # a model: the task beside it, mast.optimum.yaml
  kinetruss report runs/mast
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Least mass or force within limits, certified.")
@click.argument("task", metavar="FILE", type=FILE)
@click.option("-o", "--out", type=click.Path(path_type=Path), help="Folder for every analysis, the result and the model.")
@click.option("--overwrite", is_flag=True, help="Replace the search of another task in OUT. No other folder is ever changed.")
@json_option
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
@max_size_option
def optimise(task: Path, out: Path | None, overwrite: bool, as_json: bool, quiet: bool, max_size: int) -> None:
    """Find the least of a response by numbers of a model, within limits on others, and certify it.

    FILE names the model, the response that is made small, variables and limits; or it is a model, and its task stands beside it
    as MODEL.optimum.yaml. Ctrl-C keeps the best design so far; the same command goes on in OUT. Exit code 0: an optimum is
    certified; 1: limits exclude each other, nothing is certified, or interrupted; 2: wrong usage, or faults of the file.
    """
    from kinetruss.errors import InputError, ModelError
    from kinetruss.io import read_optimum
    from kinetruss.io.optima import optimum_file, placed_in

    task = optimum_file(task, max_size)
    asked = read_optimum(task, max_size=max_size)
    if asked.model is None:
        raise InputError(f"{task} names no model. Add model: FILE.")
    from kinetruss import design
    from kinetruss.design.optimal_design import model_for

    model = model_for(asked, asked.model, max_size)

    with bar(quiet or as_json, "analyses") as shown:
        progress = None if shown is None else lambda analyses, _objective, _worst: shown(analyses, None)
        try:
            found = design.optimise(model, asked.with_(set={}), out=out, overwrite=overwrite, progress=progress)
        except ModelError as error:
            raise ModelError(placed_in(task, error.faults), str(task)) from None
    if as_json:
        print_json("optimum", {**found.record, "out": None if out is None else str(out)})
    elif not quiet:
        click.echo(found.text)
        if out is not None:
            click.echo(f"The model with these values is in {out / 'optimum.yaml'}.")
            if found.listed is not None:
                click.echo(f"With parts of the catalogues it is in {out / 'listed.yaml'}.")
    if not found.certified:
        raise click.exceptions.Exit(1)
