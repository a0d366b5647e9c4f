"""Common parts of all commands: errors as one text, one JSON object on stdout, the exit code."""

from __future__ import annotations

import json
import re
import warnings
from pathlib import Path
from typing import Any

import click

from kinetruss.cli._codes import INTERRUPTED
from kinetruss.errors import InputError, KinetrussError, ModelError

__all__ = ["FILE", "FOLDER", "HELP", "Verb", "fault_record", "instant", "json_option", "max_size_option", "print_json", "size"]

HELP = {"help_option_names": ["-h", "--help"]}
FILE = click.Path(path_type=Path)  # the reader of a model file reports its faults better
FOLDER = click.Path(exists=True, file_okay=False, path_type=Path)


class Verb(click.Command):
    """A command whose errors end as a text on stderr (with ``--json``: an object on stdout), never a traceback."""

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any) -> click.Context:
        """Read the arguments; with ``--json`` wrong usage is reported as an object too."""
        wanted = "--json" in args
        try:
            return super().make_context(info_name, args, parent, **extra)
        except click.ClickException as error:
            if wanted:
                _echo(error)
            raise

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; turn an error into its text and exit code, and a warning into a line on stderr."""
        try:
            with warnings.catch_warnings():
                warnings.showwarning = _warned  # type: ignore[assignment]
                return super().invoke(ctx)
        except KeyboardInterrupt:
            if ctx.params.get("as_json"):
                print_json("error", {"error": "Interrupted.", "exit_code": INTERRUPTED})
            else:
                click.echo("Interrupted.", err=True)
            ctx.exit(INTERRUPTED)
        except click.ClickException as error:
            if ctx.params.get("as_json"):
                _echo(error)
            raise
        except KinetrussError as error:
            if ctx.params.get("as_json"):
                print_json("error", {"error": str(error), "exit_code": error.exit_code, **_faults(error)})
            else:
                click.echo(str(error), err=True)
            ctx.exit(error.exit_code)


def _warned(message: Warning | str, *_place: Any) -> None:
    click.echo(f"Warning: {message}", err=True)


def _echo(error: click.ClickException) -> None:
    """Report wrong usage, or Ctrl-C, as the one object, and end the command."""
    print_json("error", {"error": error.format_message(), "exit_code": error.exit_code})
    raise click.exceptions.Exit(error.exit_code) from None


def _faults(error: KinetrussError) -> dict[str, Any]:
    if not isinstance(error, ModelError):
        return {}
    return {"faults": [fault_record(fault, error.source) for fault in error.faults]}


def fault_record(fault: Any, source: str | None) -> dict[str, Any]:
    """One fault as plain data."""
    return {
        "file": fault.file or source,
        "line": fault.line,
        "column": fault.column,
        "path": list(fault.path),
        "message": fault.message,
        "mend": fault.mend,
    }


def print_json(kind: str, record: dict[str, Any]) -> None:
    """Print the one object of ``--json``; `schema` names its format."""
    click.echo(json.dumps({"schema": f"kinetruss.{kind}/1", **record}, ensure_ascii=False, allow_nan=False))


def instant(_ctx: click.Context, _option: click.Parameter, text: str | None) -> float | None:
    """Seconds from a text such as ``250 ms``."""
    if text is None:
        return None
    from kinetruss.units import parse

    try:
        return parse(text, "time")
    except InputError as error:
        raise click.BadParameter(str(error)) from None


json_option = click.option("--json", "as_json", is_flag=True, help="Print exactly one JSON object on stdout.")


def size(_ctx: click.Context, _option: click.Parameter, text: str) -> int:
    """Bytes from a text such as ``64MB``."""
    match = re.fullmatch(r"\s*(\d+(?:\.\d+)?)\s*(|B|kB|MB|GB)\s*", text)
    if match is None:
        raise click.BadParameter(f"{text!r} is not a size. Write for example 64MB.")
    return int(float(match[1]) * {"": 1, "B": 1, "kB": 10**3, "MB": 10**6, "GB": 10**9}[match[2]])


max_size_option = click.option(
    "--max-size", default="64MB", show_default=True, callback=size, help="Refuse a larger model file before reading it."
)
