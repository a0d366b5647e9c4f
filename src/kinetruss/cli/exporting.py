"""``kinetruss export`` and ``kinetruss gauges``."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli import completing
from kinetruss.cli.arguments import opened_run
from kinetruss.cli.checking import case_of_run, model_and_run, run_option
from kinetruss.cli.common import FILE, HELP, PLACE, Verb, instant, json_option, max_size_option, print_json
from kinetruss.errors import InputError

if TYPE_CHECKING:
    from kinetruss.exchange import Written


ROUND = 1e-12
"""Offset of a drive, rad or m, that is round-off."""
EXPORT_EXAMPLE = """\b
Examples:
  kinetruss export runs/slew slew.csv
  kinetruss export runs/slew slew.nc
  kinetruss export runs/slew margins.csv --group verdict
  kinetruss export runs/wipe quantities.csv --group quantities
  kinetruss export runs/slew slew.pvd
  kinetruss export runs/slew pose.dxf --time 0.25s
  kinetruss export robot.yaml robot.urdf
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EXPORT_EXAMPLE)
@click.argument("out", metavar="OUT|MODEL", type=PLACE)
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path))
@click.option(
    "--group",
    multiple=True,
    metavar="GROUP",
    shell_complete=completing.one_of("motion", "forces", "sections", "verdict", "demand"),
    help="Tables: only motion, forces, sections, verdict or demand (may repeat).",
)
@click.option("--time", callback=instant, help="Of the pose, s or with unit (the nearest sample; default: the first).")
@click.option("--overwrite", is_flag=True, help="Replace a .pvd, .vtu, .dxf, .stl, .xml or .urdf that is there.")
@json_option
@max_size_option
def export(
    out: Path, file: Path, group: tuple[str, ...], time: float | None, overwrite: bool, as_json: bool, max_size: int
) -> None:
    """Write a run or a model to FILE for another program.

    Tables of a run: .csv (one row per instant), .parquet (one row per value), .nc (netCDF, all arrays with units); with
    --group verdict a .csv holds the utilisation table. A pose of a run or a model: .xml (MJCF), .urdf (its closures in
    NAME.closures.yaml), .dxf, .stl, .vtu; all poses of a run: .pvd. What a format cannot have is printed.
    """
    from kinetruss import exchange, io

    if file.suffix.lower() not in exchange.FORMATS or (out.is_dir() and group):
        if not out.is_dir():
            known = ", ".join(exchange.FORMATS)
            raise InputError(f"{file}: a model is written as {known}; tables are written of run folders. {out} is a file.")
        with TemporaryDirectory(prefix="kinetruss-") as scratch:
            pair = Path(scratch) / "pair"
            found = opened_run(out, pair)
            try:
                own = found.quantities.items()
                more = {f"quantities/{case}".removesuffix("/all"): one for case, one in own if "time" in one.coords}
                written = io.export(found.path or out, file, groups=group, more=more)
            except InputError as error:  # of a mission: the reader knows its folder, not that of the pair
                raise InputError(str(error).replace(str(pair), f"The governing pair of {out}")) from None
        _say(out, exchange.Written(files=(written,)), as_json)
        return
    what: Any = opened_run(out) if out.is_dir() else io.read(out, max_size=max_size)
    _say(out, exchange.write(what, file, time=time, overwrite=overwrite), as_json)


def _say(out: Path, written: Written, as_json: bool) -> None:
    if as_json:
        left = [{"what": one.what, "where": one.where, "why": one.why} for one in written.left_out]
        record = {"out": str(out), "file": str(written.files[0]), "files": [str(one) for one in written.files]}
        print_json("export", {**record, "offsets": dict(written.offsets), "left_out": left})
        return
    for name, offset in written.offsets.items():
        if abs(offset) > ROUND:
            click.echo(f"drive {name} = joint value {offset:+.9g}")
    for one in written.left_out:
        click.echo(f"left out: {one}")
    click.echo(str(written.files[0]))


# ``kinetruss gauges``.

GAUGES_EXAMPLE = """\b
Examples:
  kinetruss gauges strain_gauges.yaml --run slew
  kinetruss gauges strain_gauges.yaml --run slew --measured slew_strain.csv -o overlay.png
  kinetruss gauges runs/slew -o strain.csv
"""


@click.command(
    cls=Verb, context_settings=HELP, epilog=GAUGES_EXAMPLE, short_help="Readings of strain gauges along a run, in microstrain."
)
@click.argument("model", metavar="MODEL|OUT", type=FILE)
@run_option
@case_of_run
@click.option(
    "--measured",
    type=click.Path(path_type=Path),
    multiple=True,
    metavar="FILE",
    help="A measured record to compare with: CSV, t and columns GAUGE or GROUP.axial [microstrain], or GAUGE [mV]. Several are "
    "averaged.",
)
@click.option(
    "-o",
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Also write the histories: .csv, or a picture .png, .svg, .pdf.",
)
@json_option
@max_size_option
def gauges(
    model: Path, name: str | None, case: str | None, measured: tuple[Path, ...], file: Path | None, as_json: bool, max_size: int
) -> None:
    """Compute the readings of a model's strain gauges along a run, and compare them with a measured record.

    The run is computed exactly at the measured times.
    """
    loaded, chosen = model_and_run(model, name, max_size)
    from kinetruss import report, runs, strength

    record = strength.measured_strains(loaded, measured, max_size=max_size) if measured else None
    strains = runs.gauge_strains(loaded, chosen, load_case=case, measured=record)
    compared = None if record is None else strength.compare_gauges(strains, record)
    page = report.gauges(strains, compared)
    written = None
    if file is not None and file.suffix == ".csv":
        written = page.write(file)
    elif file is not None:
        written = report.gauges_picture(strains, compared, file, loaded.title)
    if as_json:
        print_json("gauges", {**page.record, "written": None if written is None else str(written)})
    else:
        click.echo(page.text if written is None else f"{page.text}\n\n{written}")
