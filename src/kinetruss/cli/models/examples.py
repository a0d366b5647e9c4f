"""``kinetruss examples``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import HELP, Verb, json_option, print_json
from kinetruss.errors import InputError

__all__ = ["examples", "write_new"]

EPILOG = """\b
Examples:
  kinetruss examples
  kinetruss examples double_octahedral_slew --copy my
  kinetruss run my/double_octahedral_slew.yaml -o my/run
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="List the examples, or copy one to a folder.")
@click.argument("name", required=False, shell_complete=_complete.examples)
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
    from kinetruss.results.store import whole_file

    for path, text in contents.items():
        with whole_file(path) as draft:
            draft.write_bytes(text.encode())
