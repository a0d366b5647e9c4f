"""``kinetruss check`` and ``kinetruss explain``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli import completing
from kinetruss.cli.common import FILE, HELP, Verb, fault_record, instant, json_option, max_size_option, print_json
from kinetruss.errors import InputError, ModelError

if TYPE_CHECKING:
    from kinetruss.model import Model

run_option = click.option(
    "--run", "name", metavar="RUN", shell_complete=completing.runs,
    help="A run of the model (may be omitted if there is only one).",
)  # fmt: skip
case_of_run = click.option(
    "--case", metavar="CASE", shell_complete=completing.cases, help="Load case (default: the run's first)."
)

CHECK_EXAMPLE = """\b
Example:
  kinetruss check bridge.yaml
  bridge.yaml:14:11: bars.M7.section.outer: '19 kg' is not a length (m). Write for example '1.5 m', or a bare number in SI.
"""


@click.command(
    cls=Verb,
    context_settings=HELP,
    epilog=CHECK_EXAMPLE,
    short_help="All faults of a model file, each with its place and mend.",
)
@click.argument("model", type=FILE)
@json_option
@max_size_option
def check(model: Path, as_json: bool, max_size: int) -> None:
    """Report all faults of a model file at once, each as FILE:LINE:COLUMN with its fix.

    Exit code 0: none found; 2: faults.
    """
    from kinetruss.io import read
    from kinetruss.kinematics import check as check_model, notes

    faults = check_model(model, max_size=max_size)
    remarks = [] if faults else notes(model, max_size=max_size)
    if as_json:
        found, doubts = ([fault_record(fault, str(model)) for fault in these] for these in (faults, remarks))
        print_json("check", {"model": str(model), "ok": not faults, "faults": found, "notes": doubts})
    else:
        lines = ModelError(faults, str(model)).lines() if faults else [_counts(model, read(model, max_size=max_size))]
        for line in [*lines, *(f"note: {line}" for line in ModelError(remarks, str(model)).lines())]:
            click.echo(line)
    if faults:
        raise click.exceptions.Exit(InputError.exit_code)


def _counts(path: Path, model: Any) -> str:
    from kinetruss.model import contents

    runs = f", runs: {', '.join(model.runs)}" if model.runs else ""
    return f"{path}: no faults. {contents(model)}{runs}."


# ``kinetruss explain``.

EXPLAIN_EXAMPLE = """\b
Examples:
  kinetruss explain slew.yaml --member M6 --time 0.25
  kinetruss explain slew.yaml --node N5 --time "250 ms"
  kinetruss explain triangle.yaml --system --time 0.6
  kinetruss explain slew.yaml --system --time 0.25 --csv system.csv
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EXPLAIN_EXAMPLE, short_help="Free body of a member or node at one instant."
)
@click.argument("model", metavar="MODEL|OUT", type=FILE)
@click.option(
    "--member", shell_complete=completing.members, help="Cut this member free (for an active member: base rod and tube)."
)
@click.option("--node", shell_complete=completing.nodes, help="Cut this node free.")
@click.option("--system", is_flag=True, help="The equations of Newton and Euler of the whole model, with names.")
@run_option
@click.option(
    "--time", metavar="TIME", callback=instant, help="The instant, s, or text such as '250 ms' (default: of the largest force)."
)
@case_of_run
@click.option("--rest", is_flag=True, help="The same pose at rest.")
@click.option("--rods", type=click.Choice(["together", "apart"]), help="With --system: base and tube as one body, or as two.")
@click.option("--csv", "file", type=click.Path(dir_okay=False, path_type=Path), help="Also write the table to this file.")
@json_option
@max_size_option
def explain(
    model: Path,
    member: str | None,
    node: str | None,
    system: bool,
    name: str | None,
    time: float | None,
    case: str | None,
    rest: bool,
    rods: Any,
    file: Path | None,
    as_json: bool,
    max_size: int,
) -> None:
    """Show the free body of one member or node at one instant, and its equations, in numbers.

    The instant is computed exactly, independent of the run's samples. A model without runs is shown in its own pose, at rest.
    """
    if (member is not None) + (node is not None) + system != 1:
        raise click.UsageError("Give one of --member NAME, --node NAME, --system.")
    if rods is not None and not system:
        raise click.UsageError("--rods goes with --system.")
    loaded, chosen = model_and_run(model, name, max_size)
    _check_name(loaded, member, node)
    forces = _forces(loaded, chosen, time, case, member, node)
    if rest:
        forces = forces.static
    from kinetruss import dynamics, report

    pose = str(forces.whole["pose"].values[0]) if "pose" in forces.whole.coords else ""
    if system:
        page = report.explain(dynamics.newton_euler(loaded, forces.motion, forces, rods=rods), pose)
    else:
        page = report.explain(dynamics.free_body(loaded, forces.motion, forces, member=member, node=node), pose)
    written = None if file is None else page.write(file)
    if as_json:
        print_json("system" if system else "free_body", {**page.record, "csv": None if written is None else str(written)})
    else:
        click.echo(page.text if written is None else f"{page.text}\n\n{written}")


def model_and_run(path: Path, name: str | None, max_size: int) -> tuple[Model, str | None]:
    """The model of a file, or the model and run of a run folder."""
    if path.is_dir():
        from kinetruss import runs

        stored = runs.load(path)
        return stored.model, name or stored.name
    from kinetruss.io import read

    return read(path, max_size=max_size), name


def _check_name(model: Model, member: str | None, node: str | None) -> None:
    """Report a wrong name before anything is computed."""
    from kinetruss.model import nearest

    if member in model.beams:
        raise InputError(
            f"{member!r} is a beam, and free bodies are of bars and nodes. Its end forces and section forces are those of "
            f"strength.beams; the free body of its end: --node {model.beams[member].ends[0]}."
        )
    if member in model.links:
        raise InputError(
            f"{member!r} is a link, and free bodies are of bars and nodes. What its nodes exert on it, and its section forces, "
            "are those of strength.beams."
        )
    for what, given, known in (("member", member, model.whole.members), ("node", node, model.whole.nodes)):
        if given is not None and given not in known:
            raise InputError(f"No {what} called {given!r}. {nearest(given, known)}")


def _forces(model: Model, name: str | None, time: float | None, case: str | None, member: str | None, node: str | None) -> Any:
    from kinetruss import runs

    if not model.runs and name is None:
        if time:
            raise InputError("The model has no run, so it is at rest. Leave out --time, or add a run.")
        return runs.forces_at_rest(model, load_case=case)
    if time is not None:
        return runs.forces_at(model, name, [time], load_case=case)
    members = model.members if node in model.nodes else model.whole.members
    around = () if node is None else tuple(key for key, one in members.items() if node in one.ends)
    return runs.forces_at_peak(model, name, around if member is None else (member,), load_case=case)
