"""The report of a run as one self-contained page, and its result in three lines."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, element
from kinetruss.model import TitleBlock
from kinetruss.report import mechanism_tables, tables
from kinetruss.report.document import sections as parts
from kinetruss.report.document.checks import recompute
from kinetruss.report.document.data import document_record
from kinetruss.report.document.figure import deflected_figure, loaded_figure, over_structure
from kinetruss.report.document.frame import framed, summary_parts
from kinetruss.report.document.inputs import inputs, lists, section_constants
from kinetruss.report.document.mission_report import mission_html, mission_lines
from kinetruss.report.document.result import UNCHECKED, assumptions, not_whole, result_lines, span_of, tiles, warned
from kinetruss.report.document.run_pictures import diagrams_of, picture
from kinetruss.report.document.title_block import front_of
from kinetruss.report.document.worked import shown, worked, worked_record
from kinetruss.report.entries import Section
from kinetruss.report.member_diagrams import diagrams_record, governing_diagrams
from kinetruss.report.mission_tables import mission_record
from kinetruss.report.page import Page
from kinetruss.report.pictures.specs import Histories
from kinetruss.report.run_data import governing, plain
from kinetruss.report.run_figures import specifications
from kinetruss.runs import MissionRun

if TYPE_CHECKING:
    from pathlib import Path

    from kinetruss.report.document.sheets import Sheet
    from kinetruss.report.document.title_block import Front
    from kinetruss.report.entries import Entry
    from kinetruss.report.pictures.specs import Figure
    from kinetruss.runs import RunResult


def lines(run: RunResult) -> tuple[str, str, str]:
    r"""Three lines: the governing member or drive with its demand and limit; limits exceeded; what strength was checked.

    They are the first lines of a report (`document_page`). Of a mission they are those of all its pairs.

    >>> import kinetruss as kt
    >>> bar = kt.Bar(ends=("A", "B"), section=kt.Rod(diameter=0.01), material="steel_s235")
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed={"A": "xy", "B": "y"}, bars={"bar": bar},
    ...                  loads={"P": kt.NodalForce(node="B", force=(1e3, 0))}, runs={"pull": kt.Run(analysis="statics.linear")})
    >>> print("\n".join(kt.report.lines(kt.run(model, "pull"))))
    Governing: yield of bar, 5.42 % of what is allowed: 12.73 MPa of 235 MPa (all loads).
    None of the 3 limits that were checked is exceeded.
    Strength checked by every rule: 1 part.
    """
    return mission_lines(run) if isinstance(run, MissionRun) else result_lines(run, document_record(run, []))


# The report of a run as one self-contained page.

SHOWN = "The structure with its supports and loads"


def document_page(
    run: RunResult,
    view: str = "",
    date: str = "",
    block: TitleBlock | None = None,
    paper: str = "a4",
    *,
    logo: str | Path | None = None,
    summary: bool = False,
) -> Page:
    """The report of a run as HTML, and the numbers of all its tables as plain data.

    Parameters
    ----------
    view : a page that shows the run in three dimensions (`viewer.page`), included in the report; on paper a still picture
    replaces it.
    date : date of the report, as text; none by default, so that the same run gives the same text.
    block : the title block; its empty entries are those of the model's `report`. paper : ``a4`` or ``letter``.
    logo : a PNG or SVG file, which the page carries. summary : only title block, result, figure, governing calculation and
    assumptions, one or two sheets.

    Raises
    ------
    InputError : unknown paper; a logo that is damaged, or that refers to other files.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.document_page(kt.run(model))
    >>> "Four-bar linkage" in page.html, page.record["title"]
    (True, 'Four-bar linkage')
    """
    front = front_of(block, run.model.report, date, view=view, paper=paper, logo=logo, summary=summary)
    if isinstance(run, MissionRun):
        return Page(found=run, as_record=mission_record, as_html=partial(mission_html, front=front))
    return Page(found=run, as_record=run_record, as_html=partial(_html, front=front))


def run_record(run: RunResult, sheets: list[Sheet] | None = None) -> dict[str, Any]:
    """All numbers of the report of a run. sheets : its worked calculations."""
    record = document_record(run, worked_record(worked(run) if sheets is None else sheets))
    members, beams = governing_diagrams(run, record)
    extremes: dict[str, Any] = plain({"diagrams": diagrams_record([*members, *beams])})
    return record | extremes


def _html(run: RunResult, front: Front) -> str:
    """The report of a run as HTML text, with all data that a reviewer needs to repeat the computation.

    Notes
    -----
    The page also has the numbers of all tables as JSON, at full precision: element ``kinetruss-report``.
    """
    sheets = worked(run)
    record = run_record(run, sheets)
    title = run.model.title or f"Run {run.name}"
    mark = "" if run.whole else " (not complete)"
    version = f"kinetruss {run.provenance.get('kinetruss', '')}".strip()
    words = (f"Run {run.name}", span_of(record), version, front.block.date)
    parts = short_parts(run, record, sheets) if front.summary else run_parts(run, record, sheets, front.view)
    return framed(
        title,
        front,
        record["result"],
        parts,
        kicker="Report of a structural analysis",
        quiet=" · ".join(word for word in words if word),
        above=not_whole(run),
        record=record,
        foot=f"{title}, run {run.name}{mark.upper()}",
        mark=mark,
    )


def short_parts(run: RunResult, record: dict[str, Any], sheets: list[Sheet]) -> list[Section]:
    """The sections of a summary: result, figure, the governing calculation, assumptions."""
    # what was not checked is in the result and in the assumptions
    graver = [one for one in record["warnings"] if not one.startswith(UNCHECKED)]
    result = [tiles(record), *warned(record | {"warnings": graver})]
    return summary_parts(result, loaded_figure(run, record, small=True), sheets, assumptions(run, record, run.finding))


def run_parts(run: RunResult, record: dict[str, Any], sheets: list[Sheet], view: str) -> list[Section]:
    """The sections of the report of a run, in their order."""
    drawn, assumed = _Drawn(run), assumptions(run, record, run.finding)
    changes = drawn.of("lengths") if _changes(run) else ()
    stressed = "Every part by its governing rule" if record["strength"] else "Stresses"
    deflected = deflected_figure(run, record)
    timed = not tables.is_single(record)
    checks: list[Entry] = [tables.strength(governing(record["strength"]), timed=timed), *drawn.of("stresses")]
    checks.append(tables.skins(record["skins"], timed=timed))
    actuators: list[Entry] = [
        tables.limits(record["limits"], timed=timed),
        tables.motors(record["motors"]),
        *tables.trains(record["trains"]),
        tables.exceeded(record["exceeded"]),
        *drawn.of("motors"),
    ]
    quantities = [
        mechanism_tables.quantities(record["quantities"], timed=timed),
        mechanism_tables.deflections(record["deflections"]),
        *drawn.of("quantities"),
    ]
    moving = [*parts.motion(record), *changes, *mechanism_tables.entries(record["mechanism"], run.model.dim)]
    moving += [one for name in ("turning", "paths", "speeds") for one in drawn.of(name)]
    simulated = [*tables.simulation(record["simulation"]), *drawn.of("energies")]
    along = [*over_structure(run, record), *diagrams_of(run, record)]
    forces = [*parts.forces(record), *drawn.of("forces"), *drawn.of("drives")]
    calculations = "Each governing check, with the numbers of the run at that instant"
    return [
        Section("result", "Result", "", [tiles(record), *warned(record)]),
        Section("assumed", "Assumptions, and what was not checked", "What the results rest on", assumed),
        Section(
            "structure",
            "Structure and loads",
            "The structure with its supports and loads, and its shape along the run" if run.good > 1 else SHOWN,
            _shown(run, record, view, drawn),
        ),
        Section("inputs", "Basis of the analysis", "What was computed, and the data of the structure", basis(run)),
        Section("worked", "Worked calculations", calculations, shown(sheets)),
        Section("diagrams", "Diagrams along members", "Section forces with their extreme values", along),
        Section("strength", "Strength", stressed, checks),
        Section("drives", "Actuators", "What motors, gears and screws deliver", actuators),
        Section("forces", "Member forces", "Axial forces and supports", forces),
        Section("quantities", "Quantities of the model", "What the model defines to be measured, with limits", quantities),
        Section(
            "motion",
            "Motion",
            "Drives, or the lengths that change most; where nodes go and how members turn",
            moving,
        ),
        Section("simulation", "Simulation", "Integration, events, energies", simulated),
        Section("statics", "Displacements and stability", "The static analysis", [*parts.standing(run), *deflected]),
        Section("mobility", "Mobility", "Freedoms and states of self-stress of the model as it stands", parts.mobility(record)),
        Section("checks", "Checks", "Checks that need no other program", [parts.checked(run, record)]),
        Section("method", "Method and sources", "", parts.method(run)),
        Section("again", "How to repeat the computation", "Versions and the model itself", recompute(run, record)),
    ]


def basis(run: RunResult) -> list[Table]:
    """The tables of inputs, with the nodes, the members and the constants of sections."""
    return [*inputs(run), *lists(run.model), *section_constants(run.model)]


def _changes(run: RunResult) -> bool:
    """True if lengths are driven or can change; lengths of rigid bars need no figure, and drives of constant rates none."""
    rates = run.motion.whole["drive_velocity"].values if run.model.all_drives and run.good else np.zeros((1, 0))
    if rates.shape[1] and np.ptp(rates, axis=0).max() <= 1e-12 * np.abs(rates).max():
        return False
    return bool(run.model.all_drives or run.model.bending) or any(bar.kind != "rigid" for bar in run.model.bars.values())


def _shown(run: RunResult, record: dict[str, Any], view: str, drawn: _Drawn) -> list[Entry]:
    """The view on a screen; the figure with loads, and the shape at several instants."""
    moved = drawn.of("shape") if run.good > 1 and _moves(run) else []
    figures = [*loaded_figure(run, record), *moved]
    if not view:
        return figures
    frame = element("iframe", title="the run in three dimensions", sandbox="allow-scripts", srcdoc=view, loading="lazy")
    words = "Click into the picture, then press ? for its keys: play, colours, picking members, diagrams along them."
    return [element("div", frame, element("p", words, class_="note"), class_="screen"), *figures]


def _moves(run: RunResult) -> bool:
    """True if the structure moves by more than round-off."""
    position = run.motion.whole["position"].values
    size = float((position[0].max(axis=0) - position[0].min(axis=0)).max())
    return float(abs(position - position[0]).max()) > 1e-3 * size


class _Drawn:
    """Figures of a run by the beginning of their names, each numbered once; curves over time only of runs over time."""

    def __init__(self, run: RunResult) -> None:
        self._figures: list[tuple[int, Figure]] = list(enumerate(specifications(run)))
        self._timed = run.good > 1 and "pose" not in run.motion.whole.coords

    def of(self, name: str) -> list[Entry]:
        named = [(k, one) for k, one in self._figures if one.name == name or one.name.startswith(f"{name}_")]
        return [picture(one, k, one.title) for k, one in named if self._timed or not isinstance(one, Histories)]
