"""Warnings as sentences."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinetruss.display import number, quantity
from kinetruss.report.document.parts.words import cased, exceeds
from kinetruss.report.run_text.columns import moment, poses_of
from kinetruss.report.run_text.summary import checks
from kinetruss.report.run_text.trains import exceeded

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["UNCHECKED", "checked_words", "not_held", "warnings"]

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
