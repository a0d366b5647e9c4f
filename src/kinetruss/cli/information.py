"""``kinetruss info``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import completing
from kinetruss.cli.common import HELP, PLACE, Verb, instant, json_option, max_size_option, print_json

EPILOG = """\b
Examples:
  kinetruss info slew.yaml
  kinetruss info runs/slew
  kinetruss info runs/slew --joints --member M7 --time 0.25
  kinetruss info runs/slew --joints --node N4 --axis z
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("what", metavar="MODEL|OUT", type=PLACE)
@click.option(
    "--joints", is_flag=True, help="Print the force on every member at both ends, and every support force, at one instant."
)
@click.option("--member", shell_complete=completing.members, help="With --joints: only this member.")
@click.option("--node", shell_complete=completing.nodes, help="With --joints: only this node.")
@click.option("--axis", type=click.Choice(["x", "y", "z"]), help="With --joints: only this global axis.")
@click.option(
    "--time",
    metavar="TIME",
    callback=instant,
    help="With --joints: the instant, s, or text such as '250 ms' (the nearest sample; default: of the largest force).",
)
@click.option("--case", shell_complete=completing.cases, help="With --joints: the load case (default: the first).")
@json_option
@max_size_option
def info(
    what: Path,
    joints: bool,
    member: str | None,
    node: str | None,
    axis: str | None,
    time: float | None,
    case: str | None,
    as_json: bool,
    max_size: int,
) -> None:
    """Print the contents of a model file or a run folder.

    For a model: nodes, bars, coordinates, degrees of freedom, rank. For a run: how it ended, the worst members, the motors,
    and checks (energy balance, singularity, unique forces).
    """
    if not joints and (member, node, axis, time, case) != (None,) * 5:
        raise click.UsageError("--member, --node, --axis, --time and --case go with --joints.")
    if what.is_dir():
        _run(what, (member, node, axis, time, case) if joints else None, as_json)
        return
    if joints:
        raise click.UsageError(f"--joints needs a run folder; {what} is a file.")
    _model(what, as_json, max_size)


def _run(path: Path, joints: tuple[str | None, str | None, str | None, float | None, str | None] | None, as_json: bool) -> None:
    from kinetruss import report, runs

    result = runs.load(path)
    if joints is not None:
        member, node, axis, time, case = joints
        found = report.joints(result, member=member, node=node, axis=axis, time=time, case=case)
        if as_json:
            print_json("joints", found.record)
        else:
            click.echo(found.text)
        return
    page = report.summary(result)
    if as_json:
        print_json("run", page.record)
    else:
        click.echo(page.text)


def _model(path: Path, as_json: bool, max_size: int) -> None:
    from kinetruss.io import read
    from kinetruss.report.contents import contents

    page = contents(read(path, max_size=max_size), str(path))
    if as_json:
        print_json("model", page.record)
    else:
        click.echo(page.text)
