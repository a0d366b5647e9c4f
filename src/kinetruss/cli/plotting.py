"""``kinetruss plot`` and ``kinetruss compare``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from kinetruss.cli import completing
from kinetruss.cli.arguments import curves_of_runs, found_runs, opened, opened_run
from kinetruss.cli.common import HELP, Verb, json_option, print_json
from kinetruss.cli.drawing import width
from kinetruss.errors import InputError

PLOT_EXAMPLE = """\b
Quantities (several --quantity give panels above each other):
  stress     von_mises, S1, S2; axial, bending_2, bending_3, shear_2, shear_3
             (with _microstrain: as strain); components: all five
  drives     drive_position, drive_velocity, drive_acceleration (x, xd, xdd); motion: all three
  nodes      position, velocity, acceleration; --node: path, speed and acceleration of one
  members    member_force, end_force, joint_force, length, length_rate, length_acceleration,
             section_T, section_V, section_M; reaction of the supports;
             angle, angular_velocity, angular_acceleration
  quantities each quantity of the model by its name; quantity: all, quantity_rate, quantity_second_rate
  actuators  thrust (actuator_force), motor_torque (torque), current, voltage; drive: all four;
             drive_force, drive_power, interface_force, interface_moment, screw_torque, motor_speed, stroke,
             holding_torque, breakaway_torque, mechanical_power, electrical_power
  elastic    displacement, elongation; frequency, actuator_share, mac; drive_length, change, error;
             settled, difference (statics.deflection and flexible.*)
  motors     of a simulation: motor_voltage, motor_current, motor_angle, motor_speed, copper_energy
  whole      energy, power, singularity; of a simulation kinetic_energy, potential_energy, momentum,
             angular_momentum, step_size, smallest_pivot; energies: all three

\b
Examples:
  kinetruss plot runs/slew                              # all pictures, into runs/slew/pictures
  kinetruss plot runs/slew --quantity member_force --member M7 -o m7.svg
  kinetruss plot runs/slew --quantity member_force --width column -o forces.pdf     # for print
  kinetruss plot runs/slow runs/fast --quantity drive_force -o both.png
  kinetruss plot runs/compare --quantity von_mises --member follower -o compare.png
  kinetruss plot runs/compare/* --quantity motion --member actuator -o motion.png
  kinetruss plot runs/wipe --node T                                                 # where T goes
  kinetruss plot runs/frame --along                                                 # diagrams of the governing members
  kinetruss plot runs/slew --along --member M7 --at "6.5 s" -o m7.pdf
"""


@click.command(cls=Verb, context_settings=HELP, epilog=PLOT_EXAMPLE, short_help="Curves of one or more runs over time.")
@curves_of_runs(
    quantity="What to show, by name; see below (may be given several times).",
    member="Only this member, node or drive (may be given several times).",
)
@click.option("-o", "--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="A .png, .svg or .pdf file.")
@click.option(
    "--width",
    callback=width,
    metavar="MM|column|page",
    shell_complete=completing.one_of("column", "page"),
    help="For print: 90 mm (column), 190 mm (page), or millimetres.",
)
@click.option(
    "--node",
    multiple=True,
    shell_complete=completing.nodes,
    help="Path, speed and acceleration of this node (may be given several times).",
)
@click.option("--along", is_flag=True, help="Diagrams of section forces along members, at one instant.")
@click.option(
    "--at",
    metavar="TIME|POSE",
    shell_complete=completing.poses,
    help="Instant of the diagrams (default: the start, or that which governs).",
)
@json_option
def plot(
    out: tuple[Path, ...],
    quantity: tuple[str, ...],
    member: tuple[str, ...],
    case: str | None,
    station: float | None,
    file: Path | None,
    width: str | float | None,
    node: tuple[str, ...],
    along: bool,
    at: str | None,
    as_json: bool,
) -> None:
    """Draw quantities of one or more runs over time, with the same poses at rest as dashed lines; or all pictures of a run.

    OUT is a run folder, or a folder that holds runs. Labels show the differences between runs. With --along: axial force,
    shear forces, moments and torque along the members of --member, by default along those that govern and along beams.
    """
    from kinetruss import report
    from kinetruss.results.folder import PICTURES

    paths = found_runs(out)
    results = [opened_run(path) for path in paths]
    if node:
        if len(results) > 1 or quantity or member or file is not None or width is not None or along or at is not None:
            raise InputError("--node takes one run and no other option: it writes path_NODE and motion_NODE into its pictures.")
        written = report.plot_node(results[0], node, paths[0] / PICTURES)
        print_json("plot", {"files": [str(path) for path in written]}) if as_json else click.echo("\n".join(map(str, written)))
        return
    if along or at is not None:
        _diagrams(paths, results, along, (quantity, station), member, at, case, file, width, as_json)
        return
    if not quantity and (file is not None or member or width is not None or len(paths) > 1):
        quantity = ("member_force",)
    if not quantity:
        written = report.figures(results[0], paths[0] / PICTURES)
        if not written:
            raise InputError(f"{paths[0]} has no good sample to draw.")
    else:
        target = file or paths[0] / PICTURES / f"{'_'.join(quantity)}.png"
        written = [report.plot(results, quantity, target, members=member, case=case, station=station, width=width)]
    if as_json:
        print_json("plot", {"files": [str(path) for path in written]})
    else:
        click.echo("\n".join(map(str, written)))


def _diagrams(
    paths: list[Path],
    results: list[Any],
    along: bool,
    other: tuple[tuple[str, ...], float | None],
    member: tuple[str, ...],
    at: str | None,
    case: str | None,
    file: Path | None,
    width: str | float | None,
    as_json: bool,
) -> None:
    """Diagrams along members of one run."""
    from kinetruss import report
    from kinetruss.results.folder import PICTURES

    if not along:
        raise InputError("--at is the instant of diagrams. Add --along; curves over time have no instant.")
    if len(results) > 1 or any(other[0]) or other[1] is not None:
        raise InputError("--along takes one run, and neither --quantity nor --station: all section forces are shown.")
    path = file or paths[0] / PICTURES / "diagrams.png"
    found = report.diagrams_page(results[0], member, at, case).record
    report.diagrams(results[0], path, members=member, at=at, case=case, width=width or "page")
    if as_json:
        print_json("plot", {"files": [str(path)], "diagrams": found})
    else:
        click.echo(path)


# ``kinetruss compare``.

COMPARE_EXAMPLE = """\b
Examples:
  kinetruss compare runs/compare
  kinetruss compare runs/slow runs/fast --quantity von_mises --member follower -o maxima.csv
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=COMPARE_EXAMPLE, short_help="Largest values of several runs side by side."
)
@curves_of_runs(
    quantity="As for plot (may be given several times; default: the most important ones).",
    member="Only this member, node or drive (default: the largest of all).",
)
@click.option("-o", "--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="Also write a .csv file.")
@json_option
def compare(
    out: tuple[Path, ...],
    quantity: tuple[str, ...],
    member: tuple[str, ...],
    case: str | None,
    station: float | None,
    file: Path | None,
    as_json: bool,
) -> None:
    """Compare the largest values of several runs, with their times, and with the same poses at rest.

    OUT is a run folder, or a folder that holds runs. The ratio is the largest value in motion divided by the largest one at
    rest.
    """
    from kinetruss import report

    found = report.compare(opened(out), quantity, members=member, case=case, station=station)
    written = None if file is None else found.write(file)
    if as_json:
        print_json("compare", {"rows": found.record, "file": None if written is None else str(written)})
        return
    click.echo(found.text)
    if written is not None:
        click.echo(f"\n{written}")
