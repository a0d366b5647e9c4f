"""The group of all commands. Their modules import nothing slow: a command loads what it needs when it runs."""

from __future__ import annotations

import click

from kinetruss import __version__
from kinetruss.cli._compile import compile_kernels
from kinetruss.cli._verb import HELP, Group
from kinetruss.cli._verify import verify
from kinetruss.cli.models.check import check
from kinetruss.cli.models.examples import examples
from kinetruss.cli.models.explain import explain
from kinetruss.cli.models.import_file import import_file
from kinetruss.cli.models.info import info
from kinetruss.cli.models.new import new
from kinetruss.cli.models.size import size
from kinetruss.cli.pages.picture import picture
from kinetruss.cli.pages.render import render
from kinetruss.cli.pages.studio import studio
from kinetruss.cli.pages.view import view
from kinetruss.cli.runs.budget import budget
from kinetruss.cli.runs.compare import compare
from kinetruss.cli.runs.export import export
from kinetruss.cli.runs.gauges import gauges
from kinetruss.cli.runs.plot import plot
from kinetruss.cli.runs.report import report
from kinetruss.cli.runs.run import run

__all__ = ["main"]

EPILOG = """\b
Example:
  kinetruss examples double_octahedral_slew --copy my
  kinetruss check my/double_octahedral_slew.yaml
  kinetruss run my/double_octahedral_slew.yaml -o my/run
  kinetruss plot my/run -o my/forces.png

Exit codes: 0 done; 1 not converged, or a check failed; 2 wrong usage or a faulty model; 130 Ctrl-C.
"""


FIRST = """\
kinetruss computes mechanisms, parallel robots and adaptive structures made of bars. To start:

  kinetruss new leg --like four_bar          a model file with comments, to change
  kinetruss run leg.yaml -o runs/leg         its motion, forces, stresses and motors
  kinetruss view runs/leg                    the same in the browser
  kinetruss studio leg.yaml                  move its drives by hand; draw

  kinetruss examples                         models to learn from
  kinetruss -h                               all commands
"""


@click.group(cls=Group, context_settings=HELP, epilog=EPILOG, invoke_without_command=True)
@click.version_option(__version__, "--version", prog_name="kinetruss")
@click.pass_context
def main(context: click.Context) -> None:
    """Motion, member forces, stresses, margins and motor demands of structures made of bars."""
    if context.invoked_subcommand is None:
        click.echo(FIRST, nl=False)


for _verb in (
    new, check, run, info, verify, examples, import_file, export, plot, compare, size, budget, explain, gauges, view, picture,
    render, report, studio, compile_kernels,
):  # fmt: skip
    main.add_command(_verb)
