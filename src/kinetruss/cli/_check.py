"""``kinetruss check``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli._verb import FILE, HELP, Verb, fault_record, json_option, max_size_option, print_json
from kinetruss.errors import Fault, InputError, ModelError

if TYPE_CHECKING:
    from kinetruss.model import Model

__all__ = ["check"]

EPILOG = """\b
Example:
  kinetruss check bridge.yaml
  bridge.yaml:14:11: bars.M7.section.outer: '19 kg' is not a length (m). Write for example '1.5 m', or a bare number in SI.
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("model", type=FILE)
@json_option
@max_size_option
def check(model: Path, as_json: bool, max_size: int) -> None:
    """Report every fault of a model file at once, each as FILE:LINE:COLUMN with its mend.

    Exit code 0: none found; 2: faults.
    """
    from kinetruss.io import check as check_model
    from kinetruss.io import read

    found = None
    try:
        found = read(model, max_size=max_size)
        faults = check_model(found) or _structure(found)
    except ModelError as error:
        faults = error.faults
    if as_json:
        print_json("check", {"model": str(model), "ok": not faults, "faults": [fault_record(f, str(model)) for f in faults]})
    else:
        for line in ModelError(faults, str(model)).lines() if faults else [_counts(model, found)]:
            click.echo(line)
    if faults:
        raise click.exceptions.Exit(InputError.exit_code)


def _structure(model: Model) -> list[Fault]:
    """Faults that show only when the structure is looked at as a whole: freedoms that no drive holds."""
    from kinetruss.kinematics import mobility

    driven = [run for run in model.runs.values() if run.trajectory is not None and run.analysis != "dynamics.simulate"]
    if not driven:
        return []  # nothing of it is driven by a run: a mechanism to be studied, or to be let go
    found = mobility(model)
    if not found.undriven:
        return []
    count = "one freedom that no drive holds" if found.undriven == 1 else f"{found.undriven} freedoms that no drive holds"
    moves = "; ".join(found.mechanism_texts(3))
    return [Fault(("drives",), f"the structure has {count}: {moves}.", "Drive it, add a bar, or fix a node.")]


def _counts(path: Path, model: Any) -> str:
    active = f", {len(model.active)} active members" if model.active else ""
    runs = f", runs: {', '.join(model.runs)}" if model.runs else ""
    return f"{path}: no faults. {len(model.nodes)} nodes, {len(model.bars)} bars{active}{runs}."
