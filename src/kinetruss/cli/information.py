"""``kinetruss info``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import completing
from kinetruss.cli.common import HELP, PLACE, Verb, instant, json_option, max_size_option, print_json
from kinetruss.errors import one_line

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
    from kinetruss.cli.model_lines import beam_records, beam_text, body_records, body_text, joint_records, joint_text
    from kinetruss.display import counted
    from kinetruss.io import read
    from kinetruss.kinematics import mobility
    from kinetruss.model import inner_parts

    model = read(path, max_size=max_size)
    found = mobility(model)
    inner = inner_parts(model)
    nodes, bars = sum(name not in inner.nodes for name in model.nodes), sum(name not in inner.bars for name in model.bars)
    counts = {
        "nodes": nodes,
        "bars": bars,
        "active_members": len(model.active),
        "dimension": model.dim,
        "coordinates": found.coordinates,
        "fixed": found.fixed,
        "rank": found.rank,
        "degrees_of_freedom": found.degrees_of_freedom,
        "drives": found.drives,
        "undriven": found.undriven,
        "self_stress": found.self_stress,
    }
    if as_json:
        texts = {"mechanisms": found.mechanism_texts(), "self_stress_states": found.self_stress_texts()}
        lists = {"runs": list(model.runs), "bodies": body_records(model), "joints": joint_records(model)}
        lists["beams"] = beam_records(model)
        lists["springs"] = list(model.springs)
        print_json("model", {"model": str(path), "title": model.title, **counts, **lists, **texts})
        return
    click.echo(one_line(model.title or str(path), 200))
    active = f", {counted(len(model.active), 'active member')}" if model.active else ""
    active += f", {counted(len(model.beams), 'beam')}" if model.beams else ""
    parts = f"{counted(nodes, 'node')}, {counted(bars, 'bar')}{active}"
    click.echo(f"{'planar' if model.dim == 2 else 'spatial'}: {parts}")
    click.echo(str(found))
    for one in beam_records(model):
        click.echo(beam_text(one))
    for one in body_records(model):
        click.echo(body_text(one))
    for one in joint_records(model):
        click.echo(joint_text(one))
    if model.springs:
        click.echo(f"springs: {', '.join(model.springs)}")
    click.echo(f"runs: {', '.join(model.runs) or 'none'}")
