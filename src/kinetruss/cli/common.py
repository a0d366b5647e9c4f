"""Common parts of all commands: errors as one text, JSON on stdout, the exit code, progress on stderr."""

from __future__ import annotations

import json
import logging
import re
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import click

from kinetruss.cli.codes import INTERRUPTED
from kinetruss.errors import InputError, KinetrussError, ModelError

KERNELS = "kinetruss.kernels"
"""The logger that hears of every kernel that is compiled; while it has a handler, nothing else is written about them."""
OFTEN = 15.0
"""Seconds between two lines where there is no terminal."""

Shown = Callable[[int, int | None], None]


@contextmanager
def bar(silent: bool, what: str = "samples", *, first: str = "", kernels: bool = True) -> Iterator[Shown | None]:
    """A function to call with the number of items done and of all items (None: not known), or None.

    silent : show nothing. first : text shown until the first item is done; without a terminal a line. kernels : a bar says too
    that kernels are compiled. Without a terminal a line is written now and then, from `OFTEN` seconds on.
    """
    if silent:
        yield None
    elif not sys.stderr.isatty():
        if first:
            click.echo(f"kinetruss: {what}{first} ...", err=True)
        yield _lines(what)
    else:
        with _on_terminal(what, first, kernels) as shown:
            yield shown


@contextmanager
def _on_terminal(what: str, first: str, kernels: bool) -> Iterator[Shown]:
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[count]}"), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as found:
        task = found.add_task(f"{what}{first}", total=None, count="")
        seen: list[int] = []

        def shown(done: int, total: int | None) -> None:
            count = f"{done}/{total}" if total is not None else str(done)
            found.update(task, completed=done, total=total, description=what, count=count)

        class Compiled(logging.Handler):
            def emit(self, record: logging.LogRecord) -> None:  # noqa: ARG002
                seen.append(1)
                found.update(task, description="compiling (first start only)", count=f"{len(seen)} kernels")

        with heard(Compiled()) if kernels else nullcontext():
            yield shown


def _lines(what: str) -> Shown:
    """A function that writes a line now and then; the last one is that of the end."""
    began = last = time.monotonic()
    told = False

    def shown(done: int, total: int | None) -> None:
        nonlocal last, told
        _compiled()
        now = time.monotonic()
        if not (told if done == total else now - last >= OFTEN):
            return
        last, told = now, True
        of = "" if total is None else f" of {total}"
        click.echo(f"kinetruss: {done}{of} {what}, {now - began:.0f} s", err=True)

    return shown


@contextmanager
def compiling(silent: bool) -> Iterator[None]:
    """Within it, lines on stderr say that kernels are compiled, and how many they were; none if silent."""
    if silent:
        with heard(logging.NullHandler()):
            yield
        return
    try:
        yield
    finally:
        _compiled()


def _compiled() -> None:
    """Say how much was compiled, if a line said that it began."""
    jit: Any = sys.modules.get("kinetruss.kernels.compiled.jit")  # a command that computes nothing has not loaded it
    if jit is not None:
        jit.keeper.progress.end()


@contextmanager
def heard(handler: logging.Handler) -> Iterator[None]:
    """Within it the handler hears of every kernel that is compiled."""
    logger = logging.getLogger(KERNELS)
    level = logger.level
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.setLevel(level)
        logger.removeHandler(handler)


# Common parts of all commands: errors as one text, one JSON object on stdout, the exit code.

HELP = {"help_option_names": ["-h", "--help"]}
RUNS = "The analyses of a model are its runs: kinetruss run MODEL -o OUT."
OTHER = {
    "help": "Write kinetruss -h, or kinetruss COMMAND -h.",
    "version": "Write kinetruss --version.",
    "simulate": RUNS, "solve": RUNS, "analyse": RUNS, "analyze": RUNS, "dynamics": RUNS, "kinematics": RUNS, "statics": RUNS,
    "show": "Write kinetruss view MODEL, or kinetruss picture MODEL -o FILE.",
    "draw": "Write kinetruss studio, or kinetruss picture MODEL -o FILE.",
    "edit": "Write kinetruss studio MODEL.", "gui": "Write kinetruss studio.", "open": "Write kinetruss view MODEL.",
    "init": "Write kinetruss new NAME.", "create": "Write kinetruss new NAME.",
    "convert": "Write kinetruss import, or kinetruss export.",
    "validate": "Write kinetruss check MODEL.", "lint": "Write kinetruss check MODEL.", "test": "Write kinetruss verify.",
}  # fmt: skip
"""Words that are no commands -> what to write."""
FILE = click.Path(path_type=Path)  # the reader of a model file reports its faults better
FOLDER = click.Path(exists=True, file_okay=False, path_type=Path)


class Place(click.Path):
    """A file or folder that is there."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path; an error with the most similar name beside it."""
        path = Path(value)
        if not path.exists() and path.parent.is_dir():
            beside = [str(path.parent / one.name) for one in path.parent.iterdir() if not one.name.startswith(".")]
            near = [one for one in beside if Path(one).stem == path.name] or get_close_matches(str(path), beside, n=1)
            if near:
                self.fail(f"{self.name.title()} {str(path)!r} does not exist. Did you mean {near[0]!r}?", param, ctx)
        return super().convert(value, param, ctx)


PLACE = Place(exists=True, path_type=Path)


class Group(click.Group):
    """The commands; of a word that is none it says which to take."""

    def resolve_command(self, ctx: click.Context, args: list[str]) -> Any:
        """The command of the first word."""
        if args and args[0] in OTHER and self.get_command(ctx, args[0]) is None:
            raise click.UsageError(f"No such command {args[0]!r}. {OTHER[args[0]]}", ctx)
        return super().resolve_command(ctx, args)


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
            with warnings.catch_warnings(), compiling(bool(ctx.params.get("quiet"))):
                warnings.showwarning = _warned  # type: ignore[assignment]
                return super().invoke(ctx)
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
        except (KeyboardInterrupt, Exception) as error:
            if isinstance(error, click.exceptions.Exit) or not _interrupted(error):
                raise
            if ctx.params.get("as_json"):
                print_json("error", {"error": "Interrupted.", "exit_code": INTERRUPTED})
            else:
                click.echo("Interrupted.", err=True)
            ctx.exit(INTERRUPTED)


def _interrupted(error: BaseException | None) -> bool:
    """Whether an error is Ctrl-C or came of it: a library whose import was cut cannot be imported again."""
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__context__
    return error is not None


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


json_option = click.option("--json", "as_json", is_flag=True, help="Print the result as one JSON object.")


def size(_ctx: click.Context, _option: click.Parameter, text: str) -> int:
    """Bytes from a text such as ``64MB``."""
    match = re.fullmatch(r"\s*(\d+(?:\.\d+)?)\s*(|B|kB|MB|GB)\s*", text)
    if match is None:
        raise click.BadParameter(f"{text!r} is not a size. Write for example 64MB.")
    return int(float(match[1]) * {"": 1, "B": 1, "kB": 10**3, "MB": 10**6, "GB": 10**9}[match[2]])


max_size_option = click.option(
    "--max-size", default="64MB", show_default=True, callback=size, help="Refuse a larger model file before reading it."
)
