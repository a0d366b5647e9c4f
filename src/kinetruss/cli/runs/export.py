"""``kinetruss export``."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli import _complete
from kinetruss.cli._verb import HELP, PLACE, Verb, instant, json_option, max_size_option, print_json
from kinetruss.cli.runs.run_folders import opened_run
from kinetruss.errors import InputError

if TYPE_CHECKING:
    from kinetruss.exchange import Written

__all__ = ["export"]

ROUND = 1e-12
"""Offset of a drive, rad or m, that is round-off."""
EPILOG = """\b
Examples:
  kinetruss export runs/slew slew.csv
  kinetruss export runs/slew slew.nc
  kinetruss export runs/slew margins.csv --group verdict
  kinetruss export runs/slew slew.pvd
  kinetruss export runs/slew pose.dxf --time 0.25s
  kinetruss export robot.yaml robot.urdf
"""


@click.command(cls=Verb, context_settings=HELP, epilog=EPILOG)
@click.argument("out", metavar="OUT|MODEL", type=PLACE)
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path))
@click.option(
    "--group",
    multiple=True,
    metavar="GROUP",
    shell_complete=_complete.one_of("motion", "forces", "sections", "verdict", "demand"),
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
                written = io.export(found.path or out, file, groups=group)
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
