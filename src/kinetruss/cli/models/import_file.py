"""``kinetruss import``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli import _complete
from kinetruss.cli._progress import bar
from kinetruss.cli._verb import FILE, HELP, Verb, json_option, max_size_option, print_json
from kinetruss.errors import InputError, UnitError

if TYPE_CHECKING:
    from kinetruss.exchange import Imported

__all__ = ["import_file"]

UNITS = ("m", "mm", "cm", "in", "ft")
"""Of lengths, as the tab key offers them."""
ROBOTS = (".urdf", ".xml", ".mjcf")
EPILOG = """\b
Examples:
  kinetruss import robot.urdf --closures robot.yaml -o robot_model.yaml
  kinetruss import arm.xml --at elbow="20 deg" -o arm.yaml
  kinetruss import tower.dxf --unit mm --active JACKS --fixed SUPPORTS -o tower.yaml
  kinetruss import nodes.csv --members members.csv --fixed A --fixed B:y -o truss.yaml
"""


def _values(_ctx: click.Context, _option: click.Parameter, texts: tuple[str, ...]) -> dict[str, float]:
    """Joint -> rad or m, from texts such as ``elbow=20 deg``."""
    from kinetruss.units import parse

    found = {}
    for text in texts:
        name, sign, value = text.partition("=")
        if not (name and sign):
            raise click.BadParameter(f"{text!r} is no JOINT=VALUE. Write for example elbow=20deg.")
        try:
            found[name.strip()] = parse(value.strip(), "angle")
        except UnitError:
            try:
                found[name.strip()] = parse(value.strip(), "length")
            except UnitError as error:
                raise click.BadParameter(str(error)) from None
    return found


@click.command("import", cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("file", type=FILE)
@click.option(
    "-o", "--out", required=True, type=click.Path(dir_okay=False, path_type=Path), help="Model file (.yaml or .json)."
)
@click.option("--overwrite", is_flag=True, help="Replace a file that is there.")
@click.option("--closures", type=FILE, help="URDF: the YAML file with closed_loop, type and name_mot.")
@click.option(
    "--at", multiple=True, metavar="JOINT=VALUE", callback=_values, help="Robots: pose of the model (rad, m, or with unit)."
)
@click.option("--floating", is_flag=True, help="URDF: the base floats; by default the ground holds it.")
@click.option("--unit", shell_complete=_complete.one_of(*UNITS), help="Of lengths, where the file names none, e.g. mm.")
@click.option("--tolerance", help="DXF: ends within this distance are one node, e.g. '1 mm'.")
@click.option("--arcs", type=int, metavar="N", help="DXF: circles, arcs and splines become N bars for a whole turn.")
@click.option("--hidden", is_flag=True, help="DXF: take what is on layers that are off or frozen, and what is invisible, too.")
@click.option("--skip", multiple=True, metavar="LAYER", help="DXF: leave these layers out, e.g. centre lines.")
@click.option("--active", multiple=True, metavar="LAYER", help="DXF: lines on these layers (with * and ?) change their length.")
@click.option(
    "--motor", multiple=True, metavar="LAYER", help="DXF: lines on these layers are turned by a motor (in the plane)."
)
@click.option("--fixed", multiple=True, metavar="NAME", help="Layers of supports (DXF), or names of fixed nodes (others).")
@click.option("--thickness", help="Meshes: of the membrane of the triangles, e.g. '2 mm'.")
@click.option("--material", shell_complete=_complete.materials, help="Meshes: of membranes and solids, a name of the library.")
@click.option("--members", type=FILE, help="CSV: the table of members that belongs to the nodes.")
@json_option
@max_size_option
def import_file(file: Path, out: Path, overwrite: bool, as_json: bool, max_size: int, **options: Any) -> None:
    """Make a model from a FILE of another program.

    URDF (.urdf), MJCF (.xml), DXF lines (.dxf), tables of nodes and members (.csv), COMPAS (.json), meshes (.vtu, .msh, ...).
    Prints what the model has, its loops and freedoms, and everything of the file that it does not have.

    Tables have a header: node, x [mm], y [mm], and if wanted z [mm], mass [kg]; member, from, to, and if wanted kind (rigid,
    driven, elastic, cable, free), section, material, mass [kg]. Cells are separated by commas, semicolons or tabs.
    """
    if out.exists() and not overwrite:
        raise InputError(f"{out} is there already. Name another file, or give --overwrite.")
    if out.exists() and file.exists() and out.samefile(file):
        raise InputError(f"{out} is the file to import itself. Name another one.")
    if out.suffix.lower() not in (".yaml", ".yml", ".json"):
        raise InputError(f"{out} has the suffix {out.suffix!r}. Name a file that ends in .yaml, .yml, .json.")
    from kinetruss import exchange, io

    with bar(as_json, "bodies", kernels=False) as shown:
        if shown is None and not as_json:
            click.echo(f"Reading {file.name} ...", err=True)
        progress = {} if file.suffix.lower() not in ROBOTS else {"progress": shown}
        found = exchange.read(file, max_size=max_size, **progress, **options)
        lines = found.lines()
    written = io.write(found.model, out)
    if as_json:
        print_json("import", {"file": str(file), "model": str(written), **_record(found)})
    else:
        click.echo("\n".join([*lines, str(written), *_next(found)]))


def _next(found: Imported) -> list[str]:
    """A run that the file may have next: the first drive moves, the others hold; what drives do not hold falls."""
    from kinetruss.model import turns

    model = found.model
    if found.mobility.undriven:
        run = "fall: {analysis: dynamics.simulate, t_end: 1 s}"
        return [f"next: check it, and add a drive for each freedom, or a run: runs: {{{run}}}"]
    name = next(iter(model.all_drives), None)
    if name is None:
        return ["next: check it, and add loads and a run: runs: {stand: {analysis: statics.linear}}"]
    drive = model.drives.get(name)
    rate = "0.1 rad/s" if drive is not None and turns(drive) else "1 mm/s"
    run = f"analysis: dynamics.inverse, trajectory: {{kind: constant_rate, rates: {{{name}: {rate}}}, duration: 1 s}}"
    return [f"next: check it, and add a run: runs: {{try: {{{run}}}}}"]


def _record(found: Imported) -> dict[str, Any]:
    from kinetruss.model import inner_parts

    mobility, inner = found.mobility, inner_parts(found.model)
    return {
        "nodes": sum(name not in inner.nodes for name in found.model.nodes),
        "bars": sum(name not in inner.bars for name in found.model.bars),
        "bodies": sum(name not in inner.bodies for name in found.model.bodies),
        "drives": list(found.model.all_drives),
        "degrees_of_freedom": mobility.degrees_of_freedom,
        "undriven": mobility.undriven,
        "self_stress": mobility.self_stress,
        "freedoms_of_the_file": found.freedoms,
        "redundant_conditions": dict(found.closures),
        "gap": found.gap,
        "offsets": dict(found.offsets),
        "notes": list(found.notes),
        "left_out": [{"what": one.what, "where": one.where, "why": one.why} for one in found.left_out],
    }
