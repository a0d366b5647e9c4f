"""Draws diagrams of section forces into a file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from kinetruss.errors import InputError
from kinetruss.report._page import Page
from kinetruss.report.along.chosen import Subject, asked, diagrams_record, governing_diagrams
from kinetruss.report.along.drawing import drawn
from kinetruss.report.document._record import limits, plain, strength
from kinetruss.report.pictures.draw import SUFFIXES, write
from kinetruss.report.pictures.picture import width_of

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["diagrams", "diagrams_page"]

INCH = 25.4


def diagrams(
    run: RunResult,
    file: str | Path,
    *,
    members: Sequence[str] = (),
    at: float | str | None = None,
    case: str | None = None,
    width: str | float = "page",
) -> Path:
    """Draw axial force, shear forces, bending moments and torque along members and beams at one instant.

    Parameters
    ----------
    file : ``.png``, ``.svg`` or ``.pdf``.
    members : members, base rods and tubes (``M7.tube``), elastic beams; by default the governing members, each at the instant
        of its governing entry, and the 12 beams of the highest stress at that of the worst one, as in a report.
    at : instant, s or text with a unit (the nearest computed sample is shown), or the name of a pose; by default the start.
        case : load case, by default the first. width : mm, or ``column`` (90 mm), ``page`` (190 mm).

    Raises
    ------
    InputError : an unknown member, instant, load case, suffix or width; section forces that are not known.
    StoreError : the file cannot be written.

    Notes
    -----
    Values are those of `strength.sections` and `strength.beams`, with their signs and member axes. A panel has the least and
    the largest value with its place from end A; a dotted line marks the section of the governing check. Round-off is 0.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.diagrams(kt.run(model), f"{folder}/crank.svg", members=["crank"], at="250 ms").name
    'crank.svg'
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: pictures end in {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    write(drawn(_subjects(run, members, at, case), width_of(width) / INCH), path, dots=300)
    return path


def diagrams_page(run: RunResult, members: Sequence[str] = (), at: float | str | None = None, case: str | None = None) -> Page:
    """The extreme values of `diagrams`, which has the same arguments, as a page: `record` of plain data, SI.

    >>> import kinetruss as kt
    >>> steel = kt.Material(E=200e9, density=0.0)
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], material=steel, section=kt.Rod(diameter=0.01),
    ...                  beams={"arm": ("A", "B")}, loads={"P": kt.NodalForce(node="B", force=(0, -10))},
    ...                  runs={"rest": kt.Run(analysis="statics.linear")})
    >>> one = kt.report.diagrams_page(kt.run(model), ["arm"]).record[-1]
    >>> one["symbol"], round(one["least"], 9), one["least_at"], one["largest"]
    ('M3', -10.0, 0.0, 0.0)
    """
    return Page(found=_subjects(run, members, at, case), as_record=diagrams_record)


def _subjects(run: RunResult, members: Sequence[str], at: float | str | None, case: str | None) -> list[Subject]:
    if members:
        return asked(run, members, at, case)
    if at is not None or case is not None:
        raise InputError("Name the members too: without them the governing ones are shown, each at its own instant.")
    record = plain({"strength": strength(run), "limits": limits(run)})
    found = [one for group in governing_diagrams(run, record) for one in group]
    if not found:
        raise InputError("No member governs and there are no beams. Name members: members=['M1'].")
    return found
