"""The result of a sizing, as a record, as text and as plain data."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cached_property
from typing import Any

from kinetruss.display import Table, instant, quantity
from kinetruss.display.tables import measured, together, words
from kinetruss.model import Mission, Model
from kinetruss.model.table import read_only
from kinetruss.results import Demand, Verdict
from kinetruss.strength.findings import Finding, demands, find


@dataclass(frozen=True, slots=True, kw_only=True)
class GroupRow:
    """One group of members: tube and mass (kg) before and after, the governing check, and why no smaller tube is sufficient.

    utilisation_before, utilisation : the highest of its members (NaN if nothing could be checked before), by `rule` in
    `part` at `time` s under `load_case`. smaller : the tube one size smaller, "" if the tube is the smallest of the catalogue;
    with it `smaller_part` reaches `smaller_utilisation` by `smaller_rule`.
    """

    name: str
    members: tuple[str, ...]
    tube_before: str
    tube: str
    mass_before: float
    mass: float
    utilisation_before: float
    utilisation: float
    part: str
    rule: str
    time: float
    load_case: str
    smaller: str
    smaller_utilisation: float
    smaller_part: str
    smaller_rule: str


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveRow:
    """One group of active members: screw, gear and motor by name (before and after; "" none), and the governing quantity.

    utilisation : highest demand over limit, without the margin; the required margin holds if it is at most 1/margin.
    tried : number of combinations checked. against : why no smaller motor was chosen.
    """

    name: str
    members: tuple[str, ...]
    before: tuple[str, str, str]
    screw: str
    gear: str
    motor: str
    self_locking: bool
    utilisation: float
    quantity: str
    member: str
    time: float
    load_case: str
    tried: int
    against: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Sizing:
    """A sized model with its proof.

    model : with the tubes and drives chosen, and the safety factors of the mission. groups, drives : the tables.
    mass_before, mass_after : of all members, kg (no lumped masses). iterations : number of times that masses were fed back.
    settled : largest relative difference between the member forces by which the tubes were chosen and those of the model.
    verdict : of the sized model over all runs and load cases (every utilisation is at most 1); before : of the given one.
    demand : of the sized model by loading. notes : remarks for the reader.
    """

    model: Model
    mission: Mission
    groups: tuple[GroupRow, ...]
    drives: tuple[DriveRow, ...]
    mass_before: float
    mass_after: float
    iterations: int
    settled: float
    verdict: Verdict
    before: Verdict
    demand: Mapping[str, Demand] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    provenance: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        read_only(self)

    @cached_property
    def finding(self) -> Finding:
        """What the sizing says: whether the sized model keeps all limits, what governs, what was not checked and why."""
        return find(self.verdict, demands(self.demand))

    @property
    def mass_saved(self) -> float:
        """kg; negative if the given model was too weak."""
        return self.mass_before - self.mass_after


# A sizing as tables, as text and as plain data.

NAMES = "Names of tubes are those of their catalogue; the constants of the sections, below, have their sizes in mm."


def group_tables(rows: Sequence[Mapping[str, Any]]) -> list[Table]:
    """Groups of members in a record: tubes before and after, and why no smaller tube is sufficient."""
    members = words("members", lambda row: str(len(row["members"])))
    proof = [
        words("group", "name"),
        words("tube"),
        words("one size smaller", "smaller"),
        measured("would be used", "smaller_utilisation", "%"),
        words("by", lambda row: f"{row['smaller_part']} {row['smaller_rule']}"),
    ]
    return [
        Table(
            [
                words("group", "name"),
                members,
                words("tube before", lambda row: row["tube_before"] or "-"),
                words("tube"),
                *together("kg", {"mass before": "mass_before", "mass": "mass"}),
                *together("%", {"used before": "utilisation_before", "used": "utilisation"}),
                words("governed by", lambda row: _where(row["part"], row["rule"], row)),
            ],
            rows,
            "Groups of members: tubes before and after",
            foot=f"Used: highest utilisation of the group's members. {NAMES}",
        ),
        Table(
            proof,
            [row for row in rows if row["smaller"]],
            "Why no smaller tube is sufficient",
            foot="Groups that are not listed have the smallest tube of the catalogue.",
        ),
    ]


def drive_table(sizing: Mapping[str, Any]) -> Table:
    """Groups of drives in a record: screws, gears and motors from the catalogues."""
    columns = [
        words("drives", "name"),
        words("members", lambda row: str(len(row["members"]))),
        *(words(what, lambda row, what=what: row[what] or "-") for what in ("screw", "gear", "motor")),
        words("self-locking", lambda row: "yes" if row["self_locking"] else "no"),
        measured("used", "utilisation", "%"),
        words("governed by", lambda row: _where(row["member"], row["quantity"], row) if row["quantity"] else "-"),
    ]
    allowed = quantity(1 / float(sizing["drive_margin"]), "%")
    foot = f"With the margin of {sizing['drive_margin']:g} that is required, {allowed} may be used, strokes excepted."
    return Table(columns, sizing["drives"], "Groups of drives", foot=foot)


def _where(part: str, rule: str, row: Mapping[str, Any]) -> str:
    case = "all loads" if row["load_case"] == "all" else f"load case {row['load_case']}"
    return f"{part} {rule} at {instant(row['time'])} ({case})"


def table(sizing: Sizing) -> str:
    """Tubes before and after, masses, governing checks; drives; notes.

    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> text = kt.design.table(kt.design.size(kt.read(model), mission))
    >>> [line.split()[0] for line in text.splitlines()[1:6]]
    ['group', 'lower_longerons', 'upper_longerons', 'battens', 'actuators']
    """
    found = record(sizing)
    lines = []
    for one in (*group_tables(found["groups"]), drive_table(found)):
        lines += [one.text, ""] if one else []
    before, after, saved = sizing.mass_before, sizing.mass_after, sizing.mass_saved
    share = f" ({quantity(saved / before, '%')})" if before > 0 else ""
    masses = (quantity(one, "kg") for one in (before, after, saved))
    lines.append("Members: {} before, {} after; saved {}{}.".format(*masses, share))
    if sizing.groups:
        passes = f"{sizing.iterations} pass" + ("es" if sizing.iterations != 1 else "")
        lines.append(f"Converged after {passes}: forces of the finished model differ by {sizing.settled:.1e} of the largest.")
    lines.append(f"verdict: {sizing.finding.sentence}")
    return "\n".join([*lines, *sizing.notes])


def record(sizing: Sizing) -> dict[str, Any]:
    """All values as plain data; NaN and infinity become None. With the sized model, as its file has it, and what it is sized
    for: from this a report can be made (`report.sizing_page`).

    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> found = kt.design.record(kt.design.size(kt.read(model), mission))
    >>> found["groups"][0]["name"], found["mass_after"] < found["mass_before"]
    ('lower_longerons', True)
    """
    return {
        "title": sizing.mission.title,
        "runs": list(sizing.mission.runs or ()),
        "drive_margin": sizing.mission.margin,
        "model": sizing.model.model_dump_json(),
        "provenance": dict(sizing.provenance),
        "mass_before": sizing.mass_before,
        "mass_after": sizing.mass_after,
        "mass_saved": sizing.mass_saved,
        "iterations": sizing.iterations,
        "settled": sizing.settled,
        "groups": [_finite(asdict(row)) for row in sizing.groups],
        "drives": [_finite(asdict(row)) for row in sizing.drives],
        "notes": list(sizing.notes),
        "verdict": sizing.finding.record,
    }


def _finite(row: dict[str, Any]) -> dict[str, Any]:
    """NaN and infinity are not valid JSON."""
    return {name: None if isinstance(value, float) and not math.isfinite(value) else value for name, value in row.items()}
