"""``kinetruss examples``, ``kinetruss new`` and ``kinetruss import``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli import completing
from kinetruss.cli.common import FILE, HELP, Verb, bar, json_option, max_size_option, print_json
from kinetruss.errors import InputError, UnitError

if TYPE_CHECKING:
    from kinetruss.exchange import Imported
    from kinetruss.model import Model


EXAMPLES_EXAMPLE = """\b
Examples:
  kinetruss examples
  kinetruss examples double_octahedral_slew --copy my
  kinetruss run my/double_octahedral_slew.yaml -o my/run
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=EXAMPLES_EXAMPLE, short_help="List the examples, or copy one to a folder."
)
@click.argument("name", required=False, shell_complete=completing.examples)
@click.option("--copy", "folder", type=click.Path(path_type=Path), metavar="DIR", help="Copy the example's files into DIR.")
@json_option
def examples(name: str | None, folder: Path | None, as_json: bool) -> None:
    """List the examples that come with kinetruss, or copy one to work on."""
    from kinetruss.library import example_files

    shelf = example_files()
    listed = {key: _title(paths[0]) for key, paths in shelf.items()}
    if name is not None and name not in listed:
        raise InputError(f"No example called {name!r}. There are: {', '.join(listed)}.")
    if name is None and folder is not None:
        raise click.UsageError("Name the example to copy: kinetruss examples NAME --copy DIR")
    if name is not None and folder is not None:
        written = _copy(shelf[name], folder)
        if as_json:
            print_json("examples", {"name": name, "files": [str(path) for path in written]})
        else:
            click.echo("\n".join(str(path) for path in written))
        return
    chosen = listed if name is None else {name: listed[name]}
    if as_json:
        print_json("examples", {"examples": [{"name": key, "title": title} for key, title in chosen.items()]})
        return
    from kinetruss.display import Table

    click.echo(Table(("", ""), chosen.items()).text)


def _title(model: Path) -> str:
    found = re.search(r"^title:\s*(.+?)\s*$", model.read_text("utf-8"), re.MULTILINE)
    return found[1].strip("\"'") if found else ""


def _copy(sources: tuple[Path, ...], folder: Path) -> list[Path]:
    """Write files into a folder; an existing file with different contents is never replaced."""
    from kinetruss.library import example_text

    contents = {folder / source.name: example_text(source) for source in sources}
    write_new(contents)
    return list(contents)


def write_new(contents: Mapping[Path, str]) -> None:
    """Write files; one that exists with different contents is never replaced."""
    for path, text in contents.items():
        if path.exists() and path.read_bytes() != text.encode():
            raise InputError(f"{path} exists already, with different contents. Move it away, or give another name.")
    from kinetruss.results.folder import whole_file

    for path, text in contents.items():
        with whole_file(path) as draft:
            draft.write_bytes(text.encode())


# ``kinetruss new``.

NEW_EXAMPLE = """\b
Examples:
  kinetruss new leg --like four_bar
  kinetruss new press --like slider_crank
  kinetruss check leg.yaml && kinetruss run leg.yaml -o runs/leg
`kinetruss examples` lists the examples; the mechanisms are those of the library: four_bar, slider_crank, watt_six_bar, ...
"""


MECHANISMS = "mechanisms."
"""Start of the names of mechanisms of the library."""

ROUND_OFF = 1e-14
"""Coordinates below this fraction of the largest are written as 0."""
SCHEMA = "# yaml-language-server: $schema="


@click.command(cls=Verb, context_settings=HELP, epilog=NEW_EXAMPLE, short_help="Make a model file to start from.")
@click.argument("name")
@click.option(
    "--like",
    default="four_bar",
    show_default=True,
    metavar="EXAMPLE",
    shell_complete=completing.sources,
    help="An example, or a mechanism of the library.",
)
@json_option
def new(name: str, like: str, as_json: bool) -> None:
    """Make a model file NAME.yaml to work on: an example or a mechanism, with a comment above every table."""
    from kinetruss.library import example_text

    source, others = _source(like)
    file = Path(name) if Path(name).suffix == ".yaml" else Path(f"{name}.yaml")
    if file.exists():
        raise InputError(f"{file} exists already. Give another name; no file is replaced.")
    text = "\n".join(_commented(file, source)) + "\n"
    tables = {file.parent / other.name: example_text(other) for other in others if other.suffix == ".csv"}

    write_new({**tables, file: text})
    if as_json:
        print_json("new", {"file": str(file), "like": like, "files": [str(path) for path in (file, *tables)]})
        return
    run = re.search(r"^runs:", text, re.MULTILINE)
    click.echo(f"{file}: {like}, with comments. Next:")
    click.echo(f"  kinetruss check {file}")
    click.echo(f"  kinetruss run {file} -o runs/{file.stem}" if run else f"  kinetruss view {file}")
    click.echo(f"  kinetruss studio {file}")


def _source(like: str) -> tuple[str, list[Path]]:
    """Text of an example or of a mechanism of the library, and the other files of an example."""
    from kinetruss.library import builders, example_files, example_text
    from kinetruss.model import nearest

    shelf = example_files()
    if like in shelf:
        model, *others = shelf[like]
        return example_text(model), list(others)
    mechanisms = [name.removeprefix(MECHANISMS) for name in builders() if name.startswith(MECHANISMS)]
    if like.removeprefix(MECHANISMS) in mechanisms:
        return _built(like.removeprefix(MECHANISMS)), []
    known = list(dict.fromkeys([*shelf, *mechanisms]))
    fix = nearest(like, known)
    offer = fix if fix.startswith("Did") else f"There are: {', '.join(known)}."
    raise InputError(f"No example or mechanism called {like!r}. {offer}")


def _built(name: str) -> str:
    """A mechanism of the library as a model file; its crank, if it has one drive of an angle, makes a turn."""
    from kinetruss.io import schema_file
    from kinetruss.io.writing import text_of
    from kinetruss.library import build

    model = _without_round_off(build(f"{MECHANISMS}{name}"))
    text = text_of(model)
    if not model.runs and [one.kind for one in model.all_drives.values()] == ["angle"]:
        rates = f"{{{next(iter(model.drives))}: 1 rev/s}}"
        text += f"runs:\n  turn: {{trajectory: {{kind: constant_rate, rates: {rates}, duration: 1 s}}, samples: 361}}\n"
    return f"{SCHEMA}{schema_file().as_uri()}\n{text}"


def _without_round_off(model: Model) -> Model:
    """The model with 0 in place of coordinates of nodes that are round-off: cos(pi/2) is 6.1e-17."""
    least = ROUND_OFF * max(abs(x) for node in model.nodes.values() for x in node.at)
    places = {name: tuple(0.0 if abs(x) < least else x for x in node.at) for name, node in model.nodes.items()}
    return model.with_(nodes={name: node.with_(at=places[name]) for name, node in model.nodes.items()})


def _commented(file: Path, text: str) -> Iterator[str]:
    """Lines of a new model file: its own title, and above every table what it is for."""
    from kinetruss.model import Model

    described = False
    for k, line in enumerate(text.rstrip("\n").split("\n")):
        table = re.match(r"(\w+):", line)
        field = Model.model_fields.get(table[1]) if table else None
        if field is not None and field.description and not described and table and table[1] != "kinetruss":
            yield f"# {field.description}"
        yield f"title: {file.stem}" if line.startswith("title:") else line
        if k == 0:
            yield f"# Check it: kinetruss check {file.name}. Do its runs: kinetruss run {file.name} -o runs/{file.stem}"
        described = line.startswith("#")


# ``kinetruss import``.

UNITS = ("m", "mm", "cm", "in", "ft")
"""Of lengths, as the tab key offers them."""
ROBOTS = (".urdf", ".xml", ".mjcf")
IMPORT_EXAMPLE = """\b
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


@click.command("import", cls=Verb, context_settings=HELP, epilog=IMPORT_EXAMPLE)
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
@click.option("--unit", shell_complete=completing.one_of(*UNITS), help="Of lengths, where the file names none, e.g. mm.")
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
@click.option("--material", shell_complete=completing.materials, help="Meshes: of membranes and solids, a name of the library.")
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
    mobility = found.mobility
    return {
        "nodes": len(found.model.nodes),
        "bars": len(found.model.bars),
        "bodies": len(found.model.bodies),
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
