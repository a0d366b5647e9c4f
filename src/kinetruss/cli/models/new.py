"""``kinetruss new``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import HELP, Verb, json_option, print_json
from kinetruss.errors import InputError

if TYPE_CHECKING:
    from kinetruss.model import Model

__all__ = ["new"]

EPILOG = """\b
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


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Make a model file to start from.")
@click.argument("name")
@click.option(
    "--like",
    default="four_bar",
    show_default=True,
    metavar="EXAMPLE",
    shell_complete=_complete.sources,
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
    from kinetruss.cli.models.examples import write_new

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
    from kinetruss.io.models import text_of
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
