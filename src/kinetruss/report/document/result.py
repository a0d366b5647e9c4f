"""The result of a run in words: three lines, tiles, warnings, assumptions and what was not checked."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, counted, element, instant, number, quantity
from kinetruss.model.beam_frames import FRAME, shown_kinds
from kinetruss.model.bracing import CHORD
from kinetruss.report.drive_data import exceeded
from kinetruss.report.run_data import checks, moment, poses_of
from kinetruss.report.tables import cased, exceeds, is_over, is_single, not_checked, share_of, used_of, value_of

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult

    Record = dict[str, Any]


POOR_BALANCE = 1e-6
"""Largest relative error of the energy balance without a warning; for computed motions it is near round-off."""
NEAR_SINGULAR = 0.01
MOST = 12
UNCHECKED = "Not everything could be checked"
MOTORS = re.compile(r"\s*Not checked without forces: [^.]* of the motors(?: \([a-z_.]+\))?\.")
INNER = re.compile(r" \((?:[a-z_]+\.)+[a-z_]+\)")
"""What a motion says of motors before its forces are known; the name of a function in brackets."""


def warnings(run: RunResult) -> list[str]:
    """The warnings, most serious first."""
    return [*_ending(run), *_limits(run), *_unsure(run), *_incomplete(run)]


def _ending(run: RunResult) -> Iterator[str]:
    if run.whole and run.message:  # the top of the report says it if a run is not complete
        yield from [given] if (given := checked_words(run.message, bool(run.demand))) else []


def checked_words(message: str, demands: bool) -> str:
    """A message of a motion without names of functions; with demands, without that it did not check the motors: they are.

    >>> checked_words("Not checked without forces: voltage of the motors (dynamics.limits_kept).", demands=False)
    'Not checked without forces: voltage of the motors.'
    """
    text = MOTORS.sub("", message) if demands else message
    return INNER.sub("", text).strip()


def not_held(words: str) -> str:
    """What the strength check leaves out, as a reader of a report needs it."""
    return words.replace("Not held: ", "Not included in the strength check: ", 1)


def _limits(run: RunResult) -> Iterator[str]:
    rows = [] if run.verdict is None else [row for row in run.verdict.table() if row.checked and exceeds(row.utilisation)]
    for row in rows[:MOST]:
        when = f" at {f'pose {row.pose}' if row.pose else moment(row.time, ())}" if run.good > 1 else ""
        words = f"{row.rule} is at {quantity(row.utilisation, '%')} of what is allowed{when}"
        if math.isinf(row.utilisation):
            words = f"{row.note.partition(';')[0]}{when}, so {row.rule} has no finite utilisation"
        yield f"{row.part}: {words} ({cased(row.load_case)})."
    if len(rows) > MOST:
        yield f"{len(rows) - MOST} more entries of the strength table are above 100 %."
    found = exceeded(run)
    for one in found[:MOST]:
        yield f"{one['sentence'].rstrip('.')} ({cased(one['load_case'])})."
    if len(found) > MOST:
        yield f"Limits of drives are exceeded in {len(found) - MOST} more intervals."


def _unsure(run: RunResult) -> Iterator[str]:
    found = checks(run)
    balance, gauge = found["energy_balance"], found["singularity"]
    if balance is not None and balance["relative"] > POOR_BALANCE:
        yield (
            f"The energy balance closes only to {number(balance['relative'], 2)} of the largest power: the motion does not "
            "fit its own velocities and accelerations (measured records do not quite)."
        )
    if gauge is not None and gauge["smallest"] < NEAR_SINGULAR:
        yield (
            f"The structure comes near a singular position: measure {number(gauge['smallest'], 3)} at "
            f"{moment(gauge['time'], poses_of(run))} (0 is singular). Forces there are large and sensitive."
        )
    if found["not_unique"]:
        yield (
            f"The force is not unique in {', '.join(found['not_unique'])}: the structure is redundant, and the distribution "
            "depends on stiffness or convention."
        )
    for one in () if run.simulation is None else run.simulation.passages:
        if not one.certain:
            yield f"At the singular position passed at {one} the tolerance cannot distinguish the branches."


def _incomplete(run: RunResult) -> Iterator[str]:
    if run.good and run.forces and run.verdict is None:
        yield "Strength was not checked: utilisation is known only when a run has ended."
    if run.verdict is not None:
        yield from map(not_held, run.verdict.data.attrs.get("not_held", []))
        parts = dict.fromkeys(part for parts in run.verdict.not_checked().values() for part in parts)
        if parts:
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


def assumptions(run: RunResult, record: dict[str, Any], *, condition: bool = True) -> list[Entry]:
    """What was assumed, and what was not checked, headed by the strength that was not checked.

    condition : with that of the run; a mission has several.
    """
    found: list[Entry] = [element("ul", [element("li", words) for words in _assumed(run, record, condition=condition)])]
    left, count = unchecked(record)
    if left:
        head = f"Strength not fully checked: {len(left)} of {counted(count, 'part')}."
        found.append(element("p", element("strong", head), class_="headline"))
        missing = ((checked_words(what, demands=False), parts) for what, parts in record["not_checked"].items())
        found.append(not_checked(missing, "Strength that was not checked"))
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


# The result in three lines: what governs, whether a limit is exceeded, and what was checked.


def result_lines(record: Mapping[str, Any]) -> tuple[str, str, str]:
    """Three lines of a report, from its record: the governing member or drive first."""
    return _governing(record), _limits_line(record), _checked(record)


def governing_entry(record: Mapping[str, Any]) -> dict[str, Any] | None:
    """The entry of highest utilisation of members and drives; None if no limit was checked."""
    # entries of strength are worst first, a finite number before one that has none
    held = [row for row in (*record["strength"][:1], *record["limits"]) if row["utilisation"] is not None]
    return max(held, key=lambda row: value_of(row["utilisation"]), default=None)


def _governing(record: Mapping[str, Any]) -> str:
    count = record["samples"]
    part = f"{count['good']} of {count['asked']} {count.get('what', 'samples')}"
    begin = "" if record["whole"] else f"Not complete ({part}). "
    worst = governing_entry(record)
    if worst is None:
        return f"{begin}No limit was checked. {_largest(record)}".strip()
    drive = worst in record["limits"]
    what = f"{worst['rule']} of {'the drive of ' if drive else ''}{worst['part']}"
    when = ""
    if worst.get("pose"):
        when = f"pose {worst['pose']}"
    elif worst["time"] is not None and not is_single(record):
        when = f"t = {instant(worst['time'])}"
    case = ""
    if worst["load_case"]:
        case = f"pair {worst['load_case']}" if count.get("what") == "pairs" else cased(worst["load_case"])
    place = ", ".join(words for words in (when, case) if words)
    amounts = ""
    if worst["unit"]:
        value, limit = (quantity(value_of(worst[key]), worst["unit"]) for key in ("value", "limit"))
        amounts = f": {value} of {limit}"
    return f"{begin}Governing: {what}, {used_of(worst['utilisation'])}{amounts}{f' ({place})' if place else ''}."


def _largest(record: Mapping[str, Any]) -> str:
    """The largest force of a member or drive, where nothing was checked."""
    for one in record["largest_forces"][:1]:
        kind = "tension" if one["force"] > 0 else "compression"
        return f"Largest member force: {quantity(abs(one['force']), 'N')} ({kind}, {one['member']})."
    loads = [one for one in record["drive_loads"] if one["load"]]
    if loads:
        most = max(loads, key=lambda one: abs(one["load"]))
        return f"Largest load of a drive: {quantity(abs(most['load']), most['unit'])} ({most['drive']})."
    for one in record.get("skins", [])[:1]:
        return f"Highest stress: {quantity(one['von_mises'], 'Pa')} (von Mises, {one['part']})."
    return ""


def _limits_line(record: Mapping[str, Any]) -> str:
    held = [row for row in (*record["strength"], *record["limits"]) if row["utilisation"] is not None]
    over = sum(map(is_over, held))
    scope = "" if record["whole"] else " in the part that was computed"
    if not held:
        return "No limit was checked: strengths of members and limits of drives are not known here."
    if over:
        return f"{over} of {counted(len(held), 'limit')} that were checked {'is' if over == 1 else 'are'} exceeded{scope}."
    return f"None of the {counted(len(held), 'limit')} that were checked is exceeded{scope}."


def unchecked(record: Mapping[str, Any]) -> tuple[list[str], int]:
    """Parts with a rule that was not checked, and the number of all parts."""
    parts = list(dict.fromkeys(row["part"] for row in record["strength"]))
    left = dict.fromkeys(part for names in record["not_checked"].values() for part in names)
    return list(left), len(parts)


def _checked(record: Mapping[str, Any]) -> str:
    left, count = unchecked(record)
    if not count:
        return "Strength was not checked: the run has no strength check."
    if left:
        return f"Strength not fully checked: {len(left)} of {counted(count, 'part')} ({', '.join(left)})."
    without = ", without every action" if record["checks"]["not_held"] else ""
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
