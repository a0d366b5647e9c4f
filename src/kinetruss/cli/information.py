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
  kinetruss info runs/wipe --motion                     # paths, sweeps, ratios, transmission angles
  kinetruss info runs/wipe --node T --member arm1       # where T goes, how arm1 turns
  kinetruss info runs/slew --joints --member M7 --time 0.25
  kinetruss info runs/slew --joints --node N4 --axis z
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("what", metavar="MODEL|OUT", type=PLACE)
@click.option(
    "--joints", is_flag=True, help="Print the force on every member at both ends, and every support force, at one instant."
)
@click.option(
    "--motion", is_flag=True, help="Print paths of nodes, sweeps and ratios of members, transmission angles, quantities."
)
@click.option("--member", shell_complete=completing.members, help="How this member turns. With --joints: only this member.")
@click.option("--node", shell_complete=completing.nodes, help="Where this node goes. With --joints: only this node.")
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
    motion: bool,
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
    and checks (energy balance, singularity, unique forces); with --motion, --node or --member what the mechanism does.
    """
    if not joints and (axis, time, case) != (None,) * 3:
        raise click.UsageError("--axis, --time and --case go with --joints.")
    if joints and motion:
        raise click.UsageError("--joints and --motion are two pages. Give one of them.")
    if motion and (member, node) != (None, None):
        raise click.UsageError("--motion shows all that move. Leave it out to see one node or member.")
    if what.is_dir():
        if motion or (not joints and (member, node) != (None, None)):
            _motion(what, node, member, as_json)
        else:
            _run(what, (member, node, axis, time, case) if joints else None, as_json)
        return
    if joints or motion or (member, node) != (None, None):
        raise click.UsageError(f"--joints, --motion, --node and --member need a run folder; {what} is a file.")
    _model(what, as_json, max_size)


def _motion(path: Path, node: str | None, member: str | None, as_json: bool) -> None:
    from kinetruss import report, runs

    page = report.motion(runs.load(path), nodes=[node] if node else (), members=[member] if member else ())
    if as_json:
        print_json("motion", page.record)
    else:
        click.echo(page.text)


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
