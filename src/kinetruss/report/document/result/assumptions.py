"""Assumptions of an analysis and what it did not check."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, counted, element
from kinetruss.model.beams import CHORD, FRAME, shown_kinds
from kinetruss.report.document.result.lines import unchecked
from kinetruss.report.document.result.warnings import checked_words, not_held
from kinetruss.report.run_text.columns import poses_of

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["assumptions"]

NEVER = (
    "joints, pins, welds, bolts and their contact pressure",
    "local buckling of thin walls",
    "fatigue and wear",
    "limits of deflection and vibration, unless this report lists them",
    "the supports and what carries them",
)
"""Subjects that the checks do not contain."""


def assumptions(run: RunResult, record: dict[str, Any], *, condition: bool = True) -> list[Markup]:
    """What was assumed, and what was not checked, headed by the strength that was not checked.

    condition : with that of the run; a mission has several.
    """
    found = [element("ul", [element("li", words) for words in _assumed(run, record, condition=condition)])]
    left, count = unchecked(record)
    if left:
        head = f"Strength not fully checked: {len(left)} of {counted(count, 'part')}."
        found.append(element("p", element("strong", head), class_="headline"))
        missing = record["not_checked"].items()
        rows = [(checked_words(what, demands=False), str(len(parts)), ", ".join(parts)) for what, parts in missing]
        found.append(Table(("rule, and what is missing", "count", "parts"), rows, "Strength that was not checked").html)
    elif not count:
        found.append(
            element("p", element("strong", "Strength was not checked: the run has no strength check."), class_="headline")
        )
    unlimited = sorted({row["rule"] for row in record["limits"] if row["utilisation"] is None})
    never = [*([f"drives: no limit is given for {', '.join(unlimited)}"] if unlimited else []), *NEVER]
    found.append(element("p", f"Not checked: {'; '.join(never)}."))
    return found


def _assumed(run: RunResult, record: dict[str, Any], *, condition: bool) -> Iterator[str]:
    model = run.model
    chords = {f"{name}{CHORD}" for name in model.beams}
    if run.forces and any(kind != FRAME and name not in chords for name, kind in shown_kinds(model).items()):
        yield "Nodes are pins: no moment passes from bar to bar. Bars bend by their weight, inertia and the actions on them."
    if any(beam.kind == "elastic" for beam in model.beams.values()):
        yield "Beams are elastic, without shear deformation. They share the rotation of a node, but for released ends."
    if model.membranes or model.solids:
        yield "Membranes and solids are elastic (St Venant-Kirchhoff); membranes have no bending stiffness."
    if record["strength"]:
        yield "Parts are straight and prismatic; strains are small; materials are linear up to their yield strength."
        yielding, buckling = model.safety.yielding, model.safety.buckling
        yield f"Safety factors: {yielding:g} on yielding, {buckling:g} on buckling; the moment factor of beam-columns is 1."
        if min(yielding, buckling) <= 1:
            yield "A safety factor of 1 leaves no reserve: 100 % is the limit of the material or of stability itself."
        if model.active:
            yield "An active member buckles as its weaker part, base or tube, over its whole length of that instant."
    if poses_of(run):
        yield f"What was evaluated: {counted(run.good, 'pose')}; nothing was checked between and beyond."
    elif run.good > 1:
        yield f"In time, the {run.good} samples were evaluated; between them nothing was checked."
    if run.demand:
        yield "Drives: friction is that of the records, at constant coefficients; the heating of motors was not computed."
    names = [name for one in run.forces.values() for name in one.data.attrs.get("not_unique", [])]
    if names:
        yield f"The forces of {', '.join(dict.fromkeys(names))} are not unique: they depend on stiffness or convention."
    if run.verdict is not None:
        yield from map(not_held, run.verdict.data.attrs.get("not_held", []))
    if condition and run.definition.condition is not None:
        yield f"Operating condition: {run.definition.condition}."
