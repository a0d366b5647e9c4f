"""``kinetruss new``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import click

from kinetruss.cli._verb import HELP, Verb, json_option, print_json
from kinetruss.errors import InputError

__all__ = ["new"]

EPILOG = """\b
Examples:
  kinetruss new leg --like four_bar
  kinetruss check leg.yaml && kinetruss run leg.yaml -o runs/leg
`kinetruss examples` lists what a model can be like.
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("name")
@click.option("--like", default="four_bar", show_default=True, metavar="EXAMPLE", help="The example to start from.")
@json_option
def new(name: str, like: str, as_json: bool) -> None:
    """Make a model file NAME.yaml to work on: an example, with a comment above every table."""
    from kinetruss.library import example_files, example_text

    shelf = example_files()
    if like not in shelf:
        raise InputError(f"No example called {like!r}. There are: {', '.join(shelf)}.")
    file = Path(name) if Path(name).suffix == ".yaml" else Path(f"{name}.yaml")
    if file.exists():
        raise InputError(f"{file} exists already. Give another name; no file is replaced.")
    model, *others = shelf[like]
    text = "\n".join(_commented(file, example_text(model))) + "\n"
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
