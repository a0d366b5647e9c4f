"""``kinetruss check``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from kinetruss.cli._verb import FILE, HELP, Verb, fault_record, json_option, max_size_option, print_json
from kinetruss.errors import InputError, ModelError

__all__ = ["check"]

EPILOG = """\b
Example:
  kinetruss check bridge.yaml
  bridge.yaml:14:11: bars.M7.section.outer: '19 kg' is not a length (m). Write for example '1.5 m', or a bare number in SI.
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="All faults of a model file, each with its place and mend."
)
@click.argument("model", type=FILE)
@json_option
@max_size_option
def check(model: Path, as_json: bool, max_size: int) -> None:
    """Report all faults of a model file at once, each as FILE:LINE:COLUMN with its fix.

    Exit code 0: none found; 2: faults.
    """
    from kinetruss.io import read
    from kinetruss.kinematics import check as check_model
    from kinetruss.kinematics import notes

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
