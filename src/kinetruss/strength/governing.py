"""The verdict on a run in one line: is it strong enough, what governs, how much was checked."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import counted, instant, quantity
from kinetruss.results.wide_tables import NOT_CHECKED, most_used

if TYPE_CHECKING:
    from kinetruss.results import Columns, Demand, Verdict


SLACK = 1e-9
"""A limit reached to round-off is not exceeded."""

NO_RULE = NOT_CHECKED + "a cable does not buckle"
"""Note of a rule that does not apply: the part counts as checked."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Governing:
    """The highest utilisation. kind : ``member`` or ``drive``; member : the one that a part belongs to. time : s, or NaN.
    over : True if a limit of the part or drive is exceeded.
    """

    kind: str
    name: str
    member: str
    rule: str
    used: float
    time: float = math.nan
    pose: str = ""
    load_case: str = ""
    over: bool = False

    @property
    def text(self) -> str:
        """``M7, voltage: 93.1 % at 6.55 s``; at rest the load case in place of the time."""
        case = f", {self.load_case}" if self.load_case not in ("", "all") else ""
        when = f", pose {self.pose}" if self.pose else f" at {instant(self.time)}" if math.isfinite(self.time) else case
        return f"{self.name}, {self.rule}: {quantity(self.used, '%')}{when}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Headline:
    """state : ``ok``, ``over``, ``open`` (some part was not checked) or ``none`` (nothing was).

    checked, parts : number of parts of members that were checked completely, and of all. others : number of further parts and
    drives over their capacity. without : number of drives with a motor and no limit. held : sentences on what is not included.
    """

    state: str
    governing: Governing | None
    checked: int
    parts: int
    others: int = 0
    without: int = 0
    held: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The state in words, without what governs."""
        if self.state == "over":
            return "Over capacity"
        if self.state == "ok":
            return "OK"
        if not self.parts:
            return "Not checked: no member has forces"
        if self.checked < self.parts:
            return f"Strength not fully checked: {self.checked} of {counted(self.parts, 'part')} checked"
        return "Strength not fully checked: not every action is included"

    @property
    def record(self) -> dict[str, Any]:
        """Plain data for JSON."""
        one = self.governing
        lacking = self.parts - self.checked if self.state == "over" else 0
        more = [
            f"{self.others} more over" if self.others else "",
            f"{lacking} of {self.parts} parts not checked" if lacking else "",
        ]
        more.append(f"{self.without} {'drive' if self.without == 1 else 'drives'} without limits" if self.without else "")
        return {
            "state": self.state,
            "text": self.text,
            "more": [*filter(None, more), *self.held],
            "governing": None
            if one is None
            else {
                "kind": one.kind,
                "name": one.name,
                "member": one.member,
                "text": one.text,
                "used": one.used if math.isfinite(one.used) else None,
                "time": one.time if math.isfinite(one.time) else None,
                "load_case": one.load_case,
            },
        }


def headline(
    verdict: Verdict | None, demand: Mapping[str, Demand] | None = None, drives: Iterable[Governing] = (), *, timed: bool = True
) -> Headline:
    """The state of a verdict and of the demand on drives, by load case.

    drives : utilisations known otherwise. timed : False for one pose at rest, whose time says nothing.
    A part counts as checked if every rule that applies to it was; limits reached to round-off are not exceeded.
    """
    # a run that was interrupted has no summary yet
    columns = None if verdict is None or "utilisation" not in verdict.arrays else verdict.arrays
    lacking, parts = (set(), 0) if columns is None else _lacking(columns)
    held = () if verdict is None else tuple(map(str, verdict.data.attrs.get("not_held", [])))
    found = [*([] if columns is None else _worst(columns, "part", "member")), *drives]
    without: set[str] = set()
    for case, one in (demand or {}).items():
        if "utilisation" not in one.arrays:
            continue
        some = list(_worst(one.arrays, "active", "drive", case))
        without |= {str(name) for name in one.arrays["active"].values} - {row.name for row in some}
        found += some
    found = found if timed else [replace(one, time=math.nan) for one in found]
    over = {(row.kind, row.name) for row in found if row.over or row.used > 1 + SLACK}
    state = "over" if over else "open" if lacking or held else "ok" if found else "none"
    return Headline(
        state=state,
        governing=max(found, key=lambda row: row.used, default=None),
        checked=parts - len(lacking),
        parts=parts,
        others=max(0, len(over) - 1),
        without=len(without),
        held=held,
    )


def _lacking(columns: Columns) -> tuple[set[str], int]:
    """The parts that were not checked completely, and the number of all that have a rule or a note."""
    used, names = columns["utilisation"].values, columns["part"].values.tolist()
    notes = columns["note"].values.tolist() if "note" in columns else np.full(used.shape, "").tolist()
    texts = [[str(note) for note in row] for row in notes]
    listed = [k for k in range(len(names)) if any(texts[k]) or np.isfinite(used[k]).any() or np.isposinf(used[k]).any()]
    return {str(names[k]) for k in listed if any(note.startswith(NOT_CHECKED) and note != NO_RULE for note in texts[k])}, len(
        listed
    )


def _worst(columns: Columns, subject: str, kind: str, case: str = "") -> Iterator[Governing]:
    """The highest utilisation of each part or drive that has one."""
    used, rules = (
        columns["utilisation"].values,
        [str(one) for one in columns["rule" if kind == "member" else "quantity"].values],
    )
    names = columns[subject].values.tolist()
    members = columns["member"].values.tolist() if "member" in columns else names
    for k in np.flatnonzero(~np.isnan(used).all(axis=1)).tolist():
        j = used[k].tolist().index(most_used(used[k].tolist()))
        yield Governing(
            kind=kind,
            name=str(names[k]),
            member=str(members[k]),
            rule=rules[j],
            used=float(used[k, j]),
            over=bool(np.nanmax(used[k]) > 1 + SLACK),
            time=float(columns["time_of"].values[k, j]),
            pose=str(columns["pose"].values[k, j]) if "pose" in columns else "",
            load_case=case or (str(columns["load_case"].values[k, j]) if "load_case" in columns else ""),
        )
