"""The report of a sizing: tubes and drives that were chosen, and the sized structure under its governing run."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from kinetruss import runs
from kinetruss.design.sizing_result import drive_table, group_tables
from kinetruss.display import Markup, element, quantity
from kinetruss.display.ranks import largest
from kinetruss.errors import InputError
from kinetruss.model import Model, TitleBlock
from kinetruss.report.document.frame import framed
from kinetruss.report.document.run_report import run_parts, run_record, short_parts
from kinetruss.report.document.title_block import front_of
from kinetruss.report.document.worked import worked
from kinetruss.report.entries import Section
from kinetruss.report.page import Page
from kinetruss.report.run_data import plain

if TYPE_CHECKING:
    from kinetruss.report.document.sheets import Sheet
    from kinetruss.report.document.title_block import Front
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult


SCHEMA = "kinetruss.size/1"
Record = Mapping[str, Any]


def read_sizing(file: str | Path) -> dict[str, Any]:
    """The record of a sizing from a file that ``kinetruss size MODEL MISSION --json`` has written.

    Raises
    ------
    InputError : the file cannot be read, or holds something else.

    Examples
    --------
    >>> import json
    >>> import tempfile
    >>> from pathlib import Path
    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> sizing = kt.design.size(kt.read(model), mission)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "sizing.json")
    ...     _ = file.write_text(json.dumps({"schema": "kinetruss.size/1", **kt.design.record(sizing)}))
    ...     kt.report.read_sizing(file)["groups"][0]["name"]
    'lower_longerons'
    """
    path = Path(file)
    if path.suffix in (".yaml", ".yml"):
        out = f"runs/{path.stem}"
        raise InputError(f"{path} is a model, not a run. Run it first: kinetruss run {path} -o {out}; kinetruss report {out}")
    try:
        found = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError) as error:
        raise InputError(f"{path} cannot be read as JSON ({error}). {_MEND}") from None
    if not isinstance(found, dict) or found.get("schema") != SCHEMA or "model" not in found:
        raise InputError(f"{path} holds no sizing. {_MEND}")
    return found


_MEND = "Write one: kinetruss size MODEL MISSION --json > sizing.json"


def sizing_page(
    record: Record,
    view: str = "",
    date: str = "",
    block: TitleBlock | None = None,
    paper: str = "a4",
    *,
    logo: str | Path | None = None,
    summary: bool = False,
) -> Page:
    """The report of a sizing. Its governing run is computed again from the sized model.

    Parameters
    ----------
    record : from `design.record` or `read_sizing`. The others : as of `document_page`.

    Raises
    ------
    InputError : unknown paper; a logo that cannot be used; the model of the record cannot be read, or it has no runs.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> record = kt.design.record(kt.design.size(kt.read(model), mission))
    >>> page = kt.report.sizing_page(record)
    >>> [row["name"] for row in page.record["sizing"]["groups"]]
    ['lower_longerons', 'upper_longerons', 'battens', 'actuators']
    """
    own = _model(record).report
    front = front_of(block, own, date, view=view, paper=paper, logo=logo, summary=summary)
    run = governing_run(record)
    return Page(found=run, as_record=partial(_record, sizing=record), as_html=partial(_html, sizing=record, front=front))


def governing_run(record: Record) -> RunResult:
    """The run of a sized model in which a member or a drive is used most; computed again."""
    model = _model(record)
    found = [runs.run(model, name) for name in record["runs"] or model.runs]
    if not found:
        raise InputError("The sized model has no runs. Give it one, and size it again.")
    return largest(found, lambda run: -1.0 if run.finding.governing is None else run.finding.governing.utilisation)


def _model(record: Record) -> Model:
    try:
        return Model.model_validate_json(record["model"])
    except ValidationError as error:
        raise InputError(f"The model of the sizing cannot be read ({error.error_count()} faults). {_MEND}") from None


def _record(run: RunResult, sizing: Record, sheets: list[Sheet] | None = None) -> dict[str, Any]:
    return run_record(run, sheets) | {"sizing": {key: one for key, one in sizing.items() if key != "model"}}


def _html(run: RunResult, sizing: Record, front: Front) -> str:
    sheets = worked(run)
    record = _record(run, sizing, sheets)
    title = run.model.title or sizing["title"] or "Sized structure"
    found = short_parts(run, record, sheets) if front.summary else run_parts(run, record, sheets, front.view)
    first, rest = found[0], found[1:]
    tubes: list[Entry] = [*group_tables(sizing["groups"])]
    drives: list[Entry] = [drive_table(sizing)]
    if front.summary:  # what was chosen, without why nothing smaller is sufficient
        tubes = tubes[:1]
    elif against := [f"{row['name']}: {row['against']}" for row in sizing["drives"] if row["against"]]:
        drives.append(element("p", f"Why no smaller motor: {' '.join(against)}"))
    state = [] if front.summary else first.content
    parts = [
        Section(first.key, first.name, first.words, [_masses(sizing), *state]),
        Section("tubes", "Tubes", "What was chosen from the catalogue, and why nothing smaller", tubes),
        Section("chosen", "Drives chosen", "Screws, gears and motors from the catalogues", drives),
        *rest,
    ]
    return framed(
        title,
        front,
        record["result"],
        parts,
        kicker="Report of a sizing",
        quiet=" · ".join(word for word in (sizing["title"], f"governing run {run.name}", front.block.date) if word),
        record=plain(record),
        foot=f"{title}, sizing",
    )


def _masses(sizing: Record) -> Markup:
    before, after, saved = (quantity(sizing[key], "kg") for key in ("mass_before", "mass_after", "mass_saved"))
    words = f"Mass of all members: {before} before, {after} after sizing; saved {saved}. {' '.join(sizing['notes'])}"
    return element("p", words.strip())
