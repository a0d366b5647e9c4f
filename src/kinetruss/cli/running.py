"""``kinetruss run``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from kinetruss.cli import completing
from kinetruss.cli.codes import INTERRUPTED
from kinetruss.cli.common import FILE, FOLDER, HELP, Verb, bar, json_option, max_size_option, print_json

EPILOG = """\b
Examples:
  kinetruss run slew.yaml -o runs/slew --pictures
  kinetruss run slew.yaml fast -o runs/fast --json
  kinetruss run double_pendulum.yaml fall -o runs/fall      # a simulation: the motion after release
  kinetruss run --resume runs/slew
  kinetruss run slew.yaml --set runs.slew.trajectory.duration=3,5,10 --set "library.payload_mass=2 kg,5 kg" -o runs/compare
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Do a run of a model file and store it in a folder.")
@click.argument("model", type=FILE, required=False)
@click.argument("name", metavar="[RUN]", required=False, shell_complete=completing.runs)
@click.option("-o", "--out", type=click.Path(path_type=Path), help="Folder to write the run to.")
@click.option(
    "--set",
    "texts",
    multiple=True,
    metavar="PATH=V1,V2,...",
    shell_complete=completing.paths,
    help="Set a value of the model by its dotted path; several values, and several --set, give all combinations.",
)
@click.option("--resume", "resumed", type=FOLDER, metavar="OUT", help="Continue an interrupted run.")
@click.option("--overwrite", is_flag=True, help="Replace the kinetruss run in OUT. No other folder is ever changed.")
@click.option("--pictures", is_flag=True, help="Also draw the pictures into OUT/pictures (PNG, SVG).")
@json_option
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
@max_size_option
def run(
    model: Path | None,
    name: str | None,
    out: Path | None,
    texts: tuple[str, ...],
    resumed: Path | None,
    overwrite: bool,
    pictures: bool,
    as_json: bool,
    quiet: bool,
    max_size: int,
) -> None:
    """Do the run RUN of a MODEL file: motion (prescribed, or simulated), member forces, stresses, margins, motor demands.

    RUN may be omitted if the model has only one. Exit code 0: done; 1: the path ended early (good samples are kept);
    2: wrong usage or a faulty model.

    PATH is a path in the model (runs.slew.trajectory.duration, nodes.N4.mass, sections.tube.outer; after the name of a
    record it continues in that record), or library.NAME, a parameter of the library model that the file starts from. Each
    combination becomes a run folder OUT/NAME=VALUE_NAME=VALUE; a single one becomes OUT itself.
    """
    if resumed is not None and (model, name, out, texts) != (None, None, None, ()):
        raise click.UsageError("--resume OUT takes no model, --set or -o: the run folder has all data.")
    if resumed is None and (model is None or out is None):
        raise click.UsageError("Give a MODEL file and -o OUT, or --resume OUT.")
    if texts:
        assert model is not None and out is not None  # noqa: S101 - for mypy; checked above
        if pictures:
            raise click.UsageError("--pictures goes with one run. For several: kinetruss plot OUT --quantity Q -o FILE")
        _variants(model, name, out, texts, overwrite, as_json, quiet, max_size)
        return
    result = _compute(model, name, out, resumed, overwrite, quiet or as_json, max_size)
    from kinetruss import report, runs
    from kinetruss.results.folder import PICTURES

    seen = runs.governing(result) if pictures and isinstance(result, runs.MissionRun) else result
    written = report.figures(seen, result.path / PICTURES) if pictures else []
    if as_json:
        print_json("run", {**report.summary(result).record, "pictures": [str(path) for path in written]})
    elif not quiet:
        click.echo(report.summary(result).text)
        if written:
            click.echo(f"\n{len(written)} pictures in {written[0].parent}")
    if not result.whole:
        raise click.exceptions.Exit(1)


def _compute(
    model: Path | None, name: str | None, out: Path | None, resumed: Path | None, overwrite: bool, silent: bool, max_size: int
) -> Any:
    where = resumed or out
    try:
        if resumed is not None:
            from kinetruss import runs

            with bar(silent) as progress:
                return runs.resume(resumed, progress=progress)
        from kinetruss.io import read
        from kinetruss.results.folder import check_target
        from kinetruss.results.lock import check_unlocked

        assert model is not None and out is not None  # noqa: S101 - for mypy; the verb has checked it
        check_unlocked(out)  # printed before the model is read and the kernels are loaded
        check_target(out, overwrite)
        loaded = read(model, max_size=max_size)
        from kinetruss import runs

        with bar(silent) as progress:
            return runs.run(loaded, name, out, overwrite=overwrite, progress=progress)
    except KeyboardInterrupt:
        raise _interrupted(where) from None


class _Nothing(click.ClickException):
    """Ctrl-C, and nothing was written that could be continued."""

    exit_code = INTERRUPTED


def _interrupted(out: Path | None) -> click.ClickException:
    """Report what was kept after Ctrl-C; the exit code is that of an early end if samples were kept."""
    from kinetruss.errors import StoreError
    from kinetruss.results.store import open_store

    try:
        ledger = None if out is None else open_store(out).ledger
    except StoreError:
        ledger = None
    if ledger is not None and ledger.state == "finished":
        return click.ClickException(f"Interrupted after the end of the run; {out} is finished.")
    if ledger is None or not ledger.committed:
        return _Nothing("Interrupted before the first samples were written.")
    kept = f"{ledger.committed} of {ledger.samples} samples are kept"
    return click.ClickException(f"Interrupted; {kept}. Continue with: kinetruss run --resume {out}")


def _variants(
    model: Path, name: str | None, out: Path, texts: tuple[str, ...], overwrite: bool, as_json: bool, quiet: bool, max_size: int
) -> None:
    from kinetruss.cli.arguments import settings

    chosen = settings(texts)
    from kinetruss import report, runs

    with bar(quiet or as_json, "variants") as progress:
        found = runs.run_variants(model, chosen, name, out, overwrite=overwrite, progress=progress, max_size=max_size)
    if as_json:
        print_json("variants", {"out": str(out), "variants": report.variants(found).record})
    elif not quiet:
        click.echo(report.variants(found).text)
    for variant, why in found.refused.items():
        click.echo(f"{variant}: {why}", err=True)
    if found.refused or not all(found.whole.values()):
        raise click.exceptions.Exit(1)
