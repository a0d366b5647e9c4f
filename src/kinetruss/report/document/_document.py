"""The report of a run as one self-contained page."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, html_page, joined
from kinetruss.report._page import Page
from kinetruss.report.document._record import document_record
from kinetruss.report.document.parts import demands as demands
from kinetruss.report.document.parts import sections as parts
from kinetruss.report.document.parts.inputs import inputs
from kinetruss.report.document.parts.pictures import picture
from kinetruss.report.document.parts.recompute import recompute
from kinetruss.report.document.parts.top import top
from kinetruss.report.missions import mission_html, mission_record
from kinetruss.report.pictures.figures import specifications
from kinetruss.runs import MissionRun

if TYPE_CHECKING:
    from kinetruss.report.pictures.specs import Figure
    from kinetruss.runs import RunResult

__all__ = ["document_page"]

STYLE = Path(__file__).with_name("style.css")


def document_page(run: RunResult, view: str = "", date: str = "") -> Page:
    """The report of a run as HTML, and the numbers of all its tables as plain data.

    Parameters
    ----------
    view : a page that shows the run in three dimensions (`viewer.page`), included in the report; on paper a still picture
    replaces it.
    date : date of the report, as text; none by default, so that the same run gives the same text.
    """
    if isinstance(run, MissionRun):
        return Page(found=run, as_record=mission_record, as_html=partial(mission_html, view=view, date=date))
    return Page(found=run, as_record=document_record, as_html=partial(_html, view=view, date=date))


def _html(run: RunResult, view: str = "", date: str = "") -> str:
    """The report of a run as HTML text, with all data that a reviewer needs to repeat the computation.

    Notes
    -----
    The page also has the numbers of all tables as JSON, at full precision: element ``kinetruss-report``.
    """
    record = document_record(run)
    title = run.model.title or f"Run {run.name}"
    main = [top(run, record, title, date), _sectioned(run, record, view)]
    kept = element("script", Markup(_data(record)), type="application/json", id="kinetruss-report")
    mark = "" if run.whole else " (not complete)"
    style = f"{STYLE.read_text('utf-8')}{_footer(f'{title}, run {run.name}{mark.upper()}')}"
    head = f'<meta name="color-scheme" content="light dark">\n<style>{style}</style>\n'
    return html_page(f"{title}{mark}: report", head, f"<main>\n{joined(main)}\n</main>\n{kept}")


def _data(record: dict[str, Any]) -> str:
    """JSON text that cannot close the element around it."""
    return json.dumps(record, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")


def _footer(words: str) -> str:
    """The footer of printed pages; every character of the title is escaped."""
    text = "".join(sign if sign.isascii() and sign.isalnum() else f"\\{ord(sign):x} " for sign in words[:90])
    return f'@page {{ @bottom-left {{ content: "{text}"; }} }}\n'


def _sectioned(run: RunResult, record: dict[str, Any], view: str) -> list[Markup]:
    drawn = _Drawn(specifications(run))
    found = [
        ("structure", "Structure in motion", _shown(view, drawn.of("shape"))),
        ("inputs", "What was analysed", inputs(run)),
        ("mobility", "Mobility", parts.mobility(record)),
        ("motion", "Motion", [*parts.motion(record), *(drawn.of("lengths") if _changes(run) else ())]),
        ("simulation", "Simulation", [*parts.simulated(run, record), *drawn.of("energies")]),
        ("statics", "Displacements and stability", parts.standing(run)),
        ("forces", "Member forces", [*parts.forces(record), *drawn.of("forces")]),
        ("strength", "Strength", [*demands.strength(record), *drawn.of("stresses")]),
        ("drives", "Actuators", [*demands.drives(record), *drawn.of("motors")]),
        ("checks", "Checks", parts.checked(run, record)),
        ("method", "Method and sources", parts.method(run)),
        ("again", "To compute it again", recompute(run, record)),
    ]
    shown = [(key, name, inside) for key, name, inside in found if inside]
    links = [element("a", name, href=f"#{key}") for key, name, _ in shown]
    return [
        element("nav", links, aria_label="Contents"),
        *(element("section", element("h2", name), inside, id=key) for key, name, inside in shown),
    ]


def _changes(run: RunResult) -> bool:
    """True if lengths are driven or can change; lengths of rigid bars need no figure."""
    return bool(run.model.all_drives) or any(bar.kind != "rigid" for bar in run.model.bars.values())


def _shown(view: str, still: list[Markup]) -> list[Markup]:
    """The view on a screen, its still picture on paper; only the picture if there is no view."""
    if not view:
        return still
    frame = element("iframe", title="the run in three dimensions", sandbox="allow-scripts", srcdoc=view, loading="lazy")
    words = "Click into the picture, then press ? for its keys: play, colours, picking members, diagrams along them."
    return [element("div", frame, element("p", words, class_="note"), class_="screen"), element("div", still, class_="paper")]


class _Drawn:
    """Figures of a run by the beginning of their names, each numbered once."""

    def __init__(self, figures: list[Figure]) -> None:
        self._figures = list(enumerate(figures))

    def of(self, name: str) -> list[Markup]:
        return [picture(one, k, one.title) for k, one in self._figures if one.name == name or one.name.startswith(f"{name}_")]
