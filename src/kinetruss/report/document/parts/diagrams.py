"""Diagrams along the governing members and the beams, as part of a page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, quantity
from kinetruss.report.along import drawn, governing_diagrams, scales_of
from kinetruss.report.document.parts.pictures import embedded, lines_of

if TYPE_CHECKING:
    from kinetruss.report.along import Subject
    from kinetruss.runs import RunResult

__all__ = ["diagrams_of"]

SIGNS = (
    "Tension is positive (orange), compression blue; the B side exerts shear forces and moments on the A side, along and about "
    "the axes of the member."
)
ZERO = {"V2": "shear forces V₂", "V3": "V₃", "M2": "bending moments M₂", "M3": "M₃", "T_t": "torques"}


def diagrams_of(run: RunResult, record: Mapping[str, Any]) -> list[Markup]:
    """The diagrams of governing members and of beams, each as a figure that may stand on several sheets."""
    members, beams = governing_diagrams(run, record)
    count = sum(beam.kind == "elastic" for beam in run.model.beams.values())
    found = []
    if members:
        words = "Section forces along the governing members, each at the instant of its governing entry."
        found.append(_figure(members, f"{words} {SIGNS}", "members"))
    if beams:
        most = f"the {len(beams)} beams of the highest stress, of {count}" if count > len(beams) else "the beams"
        when = beams[0].moment
        words = f"Section forces along {most}{f' ({when})' if when else ''}, the most stressed first."
        found.append(_figure(beams, words if members else f"{words} {SIGNS}", "beams"))
    return found


def _figure(subjects: Sequence[Subject], words: str, number: str) -> Markup:
    scales = scales_of(subjects)
    zero = [name for key, name in ZERO.items() if key not in scales and key in subjects[0].along.lines]
    caption = words
    if any(one.place is not None for one in subjects):
        caption += " Dotted: the section of the governing check."
    if zero:
        caption += f" Zero in all of them: {', '.join(zero)}."
    panels = [lines_of(drawn([one], scales=scales), f"{number}{k}", _told(one)) for k, one in enumerate(subjects)]
    return embedded(panels, caption, rows=True)


def _told(one: Subject) -> str:
    """A diagram in words."""
    ends = [
        f"{line.words} {quantity(line.least[0], line.unit)} to {quantity(line.largest[0], line.unit)}"
        for line in one.along.lines.values()
    ]
    return f"{one.along.part}: {'; '.join(ends)}"
