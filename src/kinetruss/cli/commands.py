"""The group of all commands. Their modules import nothing slow: a command loads what it needs when it runs."""

from __future__ import annotations

import click

from kinetruss import __version__
from kinetruss.cli.checking import check, explain
from kinetruss.cli.common import HELP, Group
from kinetruss.cli.compiling import compile_kernels
from kinetruss.cli.creating import examples, import_file, new
from kinetruss.cli.drawing import picture, render
from kinetruss.cli.exporting import export, gauges
from kinetruss.cli.information import info
from kinetruss.cli.opening import studio, view
from kinetruss.cli.optimising import optimise
from kinetruss.cli.plotting import compare, plot
from kinetruss.cli.reporting import report
from kinetruss.cli.running import run
from kinetruss.cli.sizing import budget, size
from kinetruss.cli.studying import study
from kinetruss.cli.verifying import verify

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
    new, check, run, study, info, verify, examples, import_file, export, plot, compare, size, optimise, budget, explain, gauges,
    view, picture, render, report, studio, compile_kernels,
):  # fmt: skip
    main.add_command(_verb)
