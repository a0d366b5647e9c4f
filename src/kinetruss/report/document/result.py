"""The result of a run in words: three lines, tiles, warnings, assumptions and what was not checked."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, counted, element, instant, moment, number, quantity
from kinetruss.display.ranks import largest
from kinetruss.model.links import bends
from kinetruss.report.drive_data import exceeded
from kinetruss.report.tables import cased, is_over, is_single, not_checked, share_of, used_of
from kinetruss.runs import MissionRun
from kinetruss.runs.doubts import not_unique, poses_of, remarks

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult
    from kinetruss.strength import Finding

    Record = dict[str, Any]


MOST = 12
UNCHECKED = "Not everything could be checked"
MOTORS = re.compile(r"\s*Not checked without forces: [^.]* of the motors(?: \([a-z_.]+\))?\.")
INNER = re.compile(r" \((?:[a-z_]+\.)+[a-z_]+\)")
"""What a motion says of motors before its forces are known; the name of a function in brackets."""


def warnings(run: RunResult) -> list[str]:
    """The warnings, most serious first."""
    return [*_ending(run), *_limits(run), *run.finding.doubts, *_incomplete(run)]


def _ending(run: RunResult) -> Iterator[str]:
    if run.whole and (said := remarks(run)):  # the top of the report says it if a run is not complete
        yield from [given] if (given := checked_words(said, bool(run.demand))) else []


def checked_words(message: str, demands: bool) -> str:
    """A message of a motion without names of functions; with demands, without that it did not check the motors: they are.

    >>> checked_words("Not checked without forces: voltage of the motors (dynamics.limits_kept).", demands=False)
    'Not checked without forces: voltage of the motors.'
    """
    text = MOTORS.sub("", message) if demands else message
    return INNER.sub("", text).strip()


def _limits(run: RunResult) -> Iterator[str]:
    rows = [row for row in run.finding.members if row.status == "exceeded"]
    for row in rows[:MOST]:
        when = f" at {f'pose {row.pose}' if row.pose else moment(row.time, ())}" if run.good > 1 else ""
        words = f"{row.rule} is at {quantity(row.utilisation, '%')} of what is allowed{when}"
        if math.isinf(row.utilisation):
            words = f"{row.note.partition(';')[0]}{when}, so {row.rule} has no finite utilisation"
        yield f"{row.part}: {words} ({cased(row.load_case)})."
    if len(rows) > MOST:
        yield f"{len(rows) - MOST} more entries of the strength table are above 100 %."
    for row in run.finding.quantities:
        if row.status == "exceeded":
            when = f" at {moment(row.time, ())}" if math.isfinite(row.time) else ""
            value, limit = quantity(row.value, row.unit), quantity(row.limit, row.unit)
            yield f"{row.part} is {value}{when}, beyond its limit of {limit} ({cased(row.load_case)})."
    found = exceeded(run)
    for one in found[:MOST]:
        yield f"{one['sentence'].rstrip('.')} ({cased(one['load_case'])})."
    if len(found) > MOST:
        yield f"Limits of drives are exceeded in {len(found) - MOST} more intervals."


def _incomplete(run: RunResult) -> Iterator[str]:
    if run.good and run.forces and run.verdict is None:
        yield "Strength was not checked: utilisation is known only when a run has ended."
    yield from run.finding.left_out
    yield from (f"{one[:1].upper()}{one[1:]}." for one in run.finding.unknown)
    if parts := run.finding.unchecked:
        yield f"{UNCHECKED}: see the table of what was not, for {', '.join(parts)}."


# Assumptions of an analysis and what it did not check.

NEVER = (
    "joints, pins, welds, bolts and their contact pressure",
    "local buckling of thin walls",
    "fatigue and wear",
    "limits of deflection and vibration, unless this report lists them",
    "the supports and what carries them",
)
"""Subjects that the checks do not contain."""


def assumptions(run: RunResult, record: dict[str, Any], finding: Finding, *, condition: bool = True) -> list[Entry]:
    """What was assumed, and what was not checked, headed by the strength that was not checked.

    run, finding : that of a mission is the run of its governing pair, and what all pairs say. condition : with that of the run;
    a mission has several.
    """
    items = [element("li", words) for words in _assumed(run, record, finding, condition=condition)]
    found: list[Entry] = [element("ul", items)]
    if finding.unchecked or not finding.parts:
        found.append(element("p", element("strong", f"{finding.lacking}."), class_="headline"))
    if finding.unchecked:
        missing = ((checked_words(what, demands=False), parts) for what, parts in record["not_checked"].items())
        found.append(not_checked(missing, "Strength that was not checked"))
    unlimited = sorted({row["rule"] for row in record["limits"] if row["utilisation"] is None})
    never = [*([f"drives: no limit is given for {', '.join(unlimited)}"] if unlimited else []), *NEVER]
    found.append(element("p", f"Not checked: {'; '.join(never)}."))
    return found


UNSHEARED = "without shear deformation, unless their section has a shear coefficient or shear areas"


def _assumed(run: RunResult, record: dict[str, Any], finding: Finding, *, condition: bool) -> Iterator[str]:
    model = run.model
    if run.forces and model.members:
        yield "Nodes are pins: no moment passes from bar to bar. Bars bend by their weight, inertia and the actions on them."
    if any(beam.kind == "elastic" for beam in model.beams.values()):
        yield f"Beams are elastic, {UNSHEARED}. They share the rotation of a node, but for released ends."
    if any(bends(model, link) for link in model.links.values()):
        yield f"Links are pinned at their nodes, unless welded there, and stiff between; they bend {UNSHEARED}."
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
    if names := not_unique(run):
        yield f"The forces of {', '.join(names)} are not unique: they depend on stiffness or convention."
    yield from finding.left_out
    if condition and run.definition.condition is not None:
        yield f"Operating condition: {run.definition.condition}."


# The result in three lines: what governs, whether a limit is exceeded, and what was checked.


def result_lines(run: RunResult, record: Mapping[str, Any]) -> tuple[str, str, str]:
    """Three lines of a report, the governing member or drive first. record : what tells the largest force, if nothing was
    checked.
    """
    found = run.finding
    checked = [row.status for row in (*found.members, *found.drives, *found.quantities) if row.checked]
    return _governing(run, found, record), _limits_line(found, checked), _checked(found)


def _governing(run: RunResult, found: Finding, record: Mapping[str, Any]) -> str:
    begin = f"{found.partial}. " if found.partial else ""
    worst = found.governing
    if worst is None:
        return f"{begin}No limit was checked. {_largest(record)}".strip()
    pairs = isinstance(run, MissionRun)
    what = f"{worst.rule} of {'the drive of ' * (found.kind == 'drive')}{worst.part}"
    when = f"pose {worst.pose}" if worst.pose else ""
    if not when and worst.time == worst.time and (pairs or run.good > 1):
        when = f"t = {instant(worst.time)}"
    case = f"pair {worst.load_case}" if pairs else cased(worst.load_case)
    place = ", ".join(words for words in (when, case if worst.load_case else "") if words)
    amounts = f": {quantity(worst.value, worst.unit)} of {quantity(worst.limit, worst.unit)}" if worst.unit else ""
    return f"{begin}Governing: {what}, {used_of(worst.utilisation)}{amounts}{f' ({place})' if place else ''}."


def _largest(record: Mapping[str, Any]) -> str:
    """The largest force of a member or drive, where nothing was checked."""
    for one in record["largest_forces"][:1]:
        kind = "tension" if one["force"] > 0 else "compression"
        return f"Largest member force: {quantity(abs(one['force']), 'N')} ({kind}, {one['member']})."
    loads = [one for one in record["drive_loads"] if one["load"]]
    if loads:
        most = largest(loads, lambda one: abs(one["load"]))
        return f"Largest load of a drive: {quantity(abs(most['load']), most['unit'])} ({most['drive']})."
    for one in record.get("skins", [])[:1]:
        return f"Highest stress: {quantity(one['von_mises'], 'Pa')} (von Mises, {one['part']})."
    return ""


def _limits_line(found: Finding, checked: Sequence[str]) -> str:
    over, scope = checked.count("exceeded"), " in the part that was computed" if found.partial else ""
    if not checked:
        return "No limit was checked: strengths of members and limits of drives are not known here."
    if over:
        return f"{over} of {counted(len(checked), 'limit')} that were checked {'is' if over == 1 else 'are'} exceeded{scope}."
    return f"None of the {counted(len(checked), 'limit')} that were checked is exceeded{scope}."


def _checked(found: Finding) -> str:
    if not found.parts:
        return f"{found.lacking}."
    if found.unchecked:
        return f"{found.lacking} ({', '.join(found.unchecked)})."
    count, without = len(found.parts), ", without every action" if found.left_out else ""
    return f"Strength checked by every rule: {'all ' if count > 1 else ''}{counted(count, 'part')}{without}."


# The first part of a report: state of the run, main results, warnings.


def span_of(record: Record) -> str:
    """Time range and number of samples."""
    span = record["time"]
    if is_single(record):
        return "one position"
    if record["poses"]:
        return f"poses {', '.join(record['poses'])}"
    return f"t = {number(span[0])} to {instant(span[1])}, {record['samples']['good']} samples" if span else "no good sample"


def not_whole(run: RunResult) -> list[Markup]:
    """The note on a run that is not complete, with the command to resume it; nothing for a complete one."""
    if run.whole:
        return []
    name = "RUN" if run.path is None else run.path.resolve().name
    what, mend = {
        "running": ("It is still being computed.", "Make the report again when it has ended."),
        "incomplete": ("It was interrupted.", f"Continue with: kinetruss run --resume {name}"),
        "finished": (run.status.value, ""),
    }[run.state]
    count = f"{run.good} of {run.samples} samples are good, and this report uses only these."
    words = " ".join(word for word in (what, count, run.message, mend) if word)
    return [element("div", element("strong", "This run is not complete. "), words, class_="alarm", role="alert")]


def tiles(record: Record) -> Markup:
    """The main results."""
    return element("div", list(_tiles(record)), class_="tiles")


def warned(record: Record) -> list[Markup]:
    """The warnings; nothing without any."""
    if not record["warnings"]:
        return []
    listed = element("ul", [element("li", one) for one in record["warnings"]])
    held = [row for row in (*record["strength"], *record["limits"]) if row["utilisation"] is not None]
    kind = "warnings" if record["whole"] and not any(map(is_over, held)) else "warnings grave"
    return [element("div", element("h3", "Warnings"), listed, class_=kind)]


def _tiles(record: Record) -> Iterator[Markup]:
    for one in record["worst"][:1]:
        words = f"{one['part']}, {one['rule']}{_when(one, record)}"
        yield _tile("Highest utilisation of a member", share_of(one["utilisation"]), words, is_over(one))
    held = [one for one in record["limits"] if one["utilisation"] is not None]
    for one in held[:1]:
        value = share_of(one["utilisation"])
        words = f"{one['rule']} of {one['part']}, {cased(one['load_case'])}"
        yield _tile("Highest utilisation of a drive", value, words, is_over(one))
    for one in record["largest_forces"][:1]:
        words = f"{'tension' if one['force'] > 0 else 'compression'}, {one['member']}{_when(one, record)}"
        words += "" if one["unique"] else "; not unique"
        yield _tile("Largest member force", quantity(abs(one["force"]), "N"), words)
    gauge, balance = record["checks"]["singularity"], record["checks"]["energy_balance"]
    if gauge is not None:
        yield _tile("Singularity margin", number(gauge["smallest"], 3), f"0 is singular{_when(gauge, record)}")
    if balance is not None:
        yield _tile("Energy balance", number(balance["relative"], 2), "of the largest power; 0 is exact")


def _when(one: Record, record: Record) -> str:
    if one.get("pose"):
        return f", pose {one['pose']}"
    when = moment(one["time"], record["poses"]).replace(" = ", "\u00a0=\u00a0").replace(" s", "\u00a0s")
    return "" if is_single(record) else f", {when}"


def _tile(name: str, value: str, words: str, alarming: bool = False) -> Markup:
    inside = (element("span", name), element("b", value), element("small", words))
    return element("div", inside, class_="tile over" if alarming else "tile")
