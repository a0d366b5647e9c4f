"""``kinetruss study``."""

from __future__ import annotations

from pathlib import Path

import click

from kinetruss.cli import completing
from kinetruss.cli.codes import INTERRUPTED
from kinetruss.cli.common import FILE, HELP, Verb, bar, json_option, max_size_option, print_json

EPILOG = """\b
A study file, mass.study.yaml:
  model: slew.yaml
  run: slew
  variables:
    nodes.N4.mass: {between: [10 kg, 40 kg]}
    runs.slew.trajectory.duration: [3 s, 5 s]
  sample: {sobol: 256}
Examples:
  kinetruss study mass.study.yaml -o studies/mass
  kinetruss study mass.study.yaml -o studies/mass            # after a kill or Ctrl-C: goes on
  kinetruss study mass.study.yaml -o studies/mass --cluster tcp://127.0.0.1:8786
  kinetruss study slew.yaml slew --set nodes.N4.mass=10kg,20kg,40kg -o studies/three
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG, short_help="Do many variants of a run, and summarise them.")
@click.argument("model", metavar="FILE", type=FILE)
@click.argument("name", metavar="[RUN]", required=False, shell_complete=completing.runs)
@click.option("-o", "--out", type=click.Path(path_type=Path), required=True, help="Folder of the study.")
@click.option(
    "--set",
    "texts",
    multiple=True,
    metavar="PATH=V1,V2,...",
    shell_complete=completing.paths,
    help="FILE is a model: the study of all combinations of these values.",
)
@click.option("--workers", type=click.IntRange(min=1), help="Processes on this machine (default: its processors).")
@click.option("--cluster", metavar="ADDRESS", help="Use the workers of this Dask scheduler, e.g. tcp://127.0.0.1:8786.")
@click.option("--overwrite", is_flag=True, help="Replace another study in OUT. No other folder is ever changed.")
@click.option("--check/--no-check", default=True, show_default=True, help="Refuse variables that change none of the results.")
@click.option("--pictures", is_flag=True, help="Also draw the pictures into OUT/pictures (PNG, SVG).")
@json_option
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
@max_size_option
def study(
    model: Path,
    name: str | None,
    out: Path,
    texts: tuple[str, ...],
    workers: int | None,
    cluster: str | None,
    overwrite: bool,
    check: bool,
    pictures: bool,
    as_json: bool,
    quiet: bool,
    max_size: int,
) -> None:
    """Do the study in FILE: a run of a model in many variants, of which some numbers are kept.

    OUT gets a ledger, in which every variant is kept as it is done, and results.parquet. The same study goes on in its folder,
    and computes nothing twice. Exit code 0: done; 1: some variants have no numbers (they are listed by what became of them);
    2: wrong usage, or faults of study or model.
    """
    if name is not None and not texts:
        raise click.UsageError("A study file names its run. RUN goes with a model and --set PATH=V1,V2.")
    from kinetruss import studies

    given: object = model
    if texts:
        from kinetruss.cli.arguments import settings

        given = studies.Study(model=str(model), run=name, variables=settings(texts))
    try:
        with bar(quiet or as_json, "variants") as progress:
            found = studies.run_study(
                given,  # type: ignore[arg-type]
                out,
                workers=workers,
                cluster=cluster,
                overwrite=overwrite,
                check=check,
                progress=progress,
                max_size=max_size,
            )
    except KeyboardInterrupt:
        raise _interrupted(out) from None
    from kinetruss import report
    from kinetruss.results.folder import PICTURES
    from kinetruss.studies.evaluating import INFEASIBLE

    page = report.study(found)
    written = report.study_figures(found, out / PICTURES) if pictures else []
    if as_json:
        print_json("study", {**page.record, "path": str(out), "pictures": [str(path) for path in written]})
    elif not quiet:
        click.echo(page.text)
        if written:
            click.echo(f"\n{len(written)} pictures in {written[0].parent}")
    if not (found.good | (found.status == INFEASIBLE)).all():
        raise click.exceptions.Exit(1)


class _Interrupted(click.ClickException):
    exit_code = INTERRUPTED


def _interrupted(out: Path) -> click.ClickException:
    """Report what was kept after Ctrl-C."""
    from kinetruss.errors import StoreError
    from kinetruss.studies import load_study

    try:
        found = load_study(out)
    except StoreError:
        return _Interrupted("Interrupted before the study was begun.")
    return _Interrupted(
        f"Interrupted; {found.done} of {len(found.good)} variants are kept. The same command goes on with them."
    )
