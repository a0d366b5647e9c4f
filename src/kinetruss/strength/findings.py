"""What a result says, decided once: whether limits are kept, what governs, what was not checked and why, what is unsure."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from kinetruss.display import counted
from kinetruss.display.ranks import largest, largest_first
from kinetruss.results.wide_tables import NOT_CHECKED

if TYPE_CHECKING:
    from kinetruss.results import Demand, Row, Verdict


@dataclass(frozen=True, kw_only=True, eq=False)
class Finding:
    """What a result says: terminal, report, page and studio show these words.

    members, drives, quantities : every check of a part, of a drive and of a quantity of the model, worst first; `Row.status`
    is whether its limit is kept.
    left_out : sentences on actions that no check includes. partial : why the result is not that which was asked for; empty if
    it is. doubts : sentences on what makes its numbers unsure.
    """

    members: tuple[Row, ...] = ()
    drives: tuple[Row, ...] = ()
    quantities: tuple[Row, ...] = ()
    left_out: tuple[str, ...] = ()
    partial: str = ""
    doubts: tuple[str, ...] = ()

    @property
    def state(self) -> Literal["over", "open", "ok", "none"]:
        """``over`` : a limit is exceeded. ``open`` : none of those checked is, but something was not checked, or the result is
        not that which was asked for. ``ok`` : all limits are kept. ``none`` : there was nothing to check.
        """
        if self.over:
            return "over"
        if self.partial or self.unchecked or self.left_out or self.unknown:
            return "open"
        return "none" if self.governing is None else "ok"

    @cached_property
    def governing(self) -> Row | None:
        """The check of the highest utilisation, a member's before one of a drive or a quantity; None if nothing was checked."""
        # an infinite one follows the finite one of its part that says by how much
        most = [row for rows in self._kinds.values() for row in rows[:1] if row.checked]
        return largest(most, lambda row: row.utilisation) if most else None

    @property
    def _kinds(self) -> dict[Literal["member", "drive", "quantity"], tuple[Row, ...]]:
        return {"member": self.members, "drive": self.drives, "quantity": self.quantities}

    @property
    def kind(self) -> Literal["member", "drive", "quantity"]:
        """Of what governs."""
        return next((kind for kind, rows in reversed(self._kinds.items()) if self.governing in rows[:1]), "member")

    @cached_property
    def over(self) -> tuple[Row, ...]:
        """The worst check of each part, drive and quantity beyond a limit."""
        kinds = self._kinds.values()
        first = [{row.part: row for row in reversed(rows) if row.status == "exceeded"} for rows in kinds]
        return tuple(largest_first((row for one in first for row in one.values()), lambda row: row.utilisation))

    @cached_property
    def unchecked(self) -> dict[str, tuple[str, ...]]:
        """Part with a rule that was not checked -> rules, and why."""
        found: dict[str, tuple[str, ...]] = {}
        for row in self.members:
            if row.status == "not checked":
                found[row.part] = (*found.get(row.part, ()), f"{row.rule}: {row.note.removeprefix(NOT_CHECKED)}")
        return found

    @property
    def unknown(self) -> tuple[str, ...]:
        """Quantities with limits that were not checked everywhere, and why."""
        return tuple(f"{row.part} {row.note}" for row in self.quantities if row.status == "not checked")

    @cached_property
    def parts(self) -> tuple[str, ...]:
        """Parts of members that have a rule."""
        return tuple(dict.fromkeys(row.part for row in self.members))

    @cached_property
    def unlimited(self) -> tuple[str, ...]:
        """Drives of which no limit is known."""
        checked = {row.part for row in self.drives if row.checked}
        return tuple(dict.fromkeys(row.part for row in self.drives if row.part not in checked))

    @property
    def lacking(self) -> str:
        """How much of the strength was not checked, in words; empty if all was."""
        if not self.parts:
            return f"Strength was not checked{'' if self.partial else ': no member has forces'}"
        if self.unchecked:
            return f"Strength not fully checked: {len(self.unchecked)} of {counted(len(self.parts), 'part')} unchecked"
        return "Strength not fully checked: not every action is included" if self.left_out else ""

    @property
    def text(self) -> str:
        """The state in words, without what governs."""
        over = "Over capacity" if {row.part for row in self.over} - {row.part for row in self.quantities} else "Beyond a limit"
        lacking = self.lacking or ("Limits of quantities not fully checked" if self.unknown else "")
        return {"over": over, "ok": "OK"}.get(self.state) or self.partial or lacking

    @property
    def governs(self) -> str:
        """What governs, in words; empty if nothing was checked."""
        if self.governing is None:
            return ""
        return f"{'highest of what was checked: ' if self.state == 'open' else ''}{self.governing.place}"

    @property
    def more(self) -> list[str]:
        """What else to know of the limits: others exceeded, what was not checked, what no check includes."""
        others, drives = len(self.over) - 1, len(self.unlimited)
        lacking = self.lacking if self.unchecked else ""
        found = [
            f"{others} more over" if others > 0 else "",
            *(one for one in (self.partial, lacking) if one != self.text),
            f"{counted(drives, 'drive')} without limits" if drives else "",
            *self.left_out,
            *self.unknown,
        ]
        return [one for one in found if one]

    @property
    def sentence(self) -> str:
        """The verdict in one line.

        >>> import kinetruss as kt
        >>> model = kt.read(kt.library.example_files()["four_bar"][0])
        >>> kt.run(model).finding.sentence
        'OK; crank, yield: 3.6 % at 0.6083 s'
        """
        return "; ".join(filter(None, [self.text, self.governs, *self.more]))

    @property
    def record(self) -> dict[str, Any]:
        """Plain data for JSON."""
        one = self.governing
        return {
            "state": self.state,
            "text": self.text,
            "more": self.more,
            "warnings": list(self.doubts),
            "governing": None
            if one is None
            else {
                "kind": self.kind,
                "name": one.part,
                "member": one.member,
                "text": one.place,
                "used": one.utilisation if math.isfinite(one.utilisation) else None,
                "time": one.time if math.isfinite(one.time) else None,
                "load_case": one.load_case,
            },
        }


def find(
    verdict: Verdict | None,
    drives: Iterable[Row] = (),
    *,
    partial: str = "",
    doubts: Iterable[str] = (),
    timed: bool = True,
    quantities: Iterable[Row] = (),
) -> Finding:
    """What a verdict and the checks of drives say.

    Parameters
    ----------
    drives : checks of drives, of `demands` or others. partial : why the result is only a part of what was asked for; by default
    how the forces of the verdict ended, if not well. doubts : sentences on what makes the numbers unsure. timed : False for one
    pose at rest, whose time says nothing. quantities : checks of the quantities of a model.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> found = kt.strength.find(kt.strength.check(model, kt.runs.forces_at_rest(model)), timed=False)
    >>> found.state, found.sentence
    ('ok', 'OK; strut, buckling: 6.14 %')
    """
    rows = (
        [] if verdict is None or "utilisation" not in verdict.arrays else verdict.table(timed=timed)
    )  # a run's, before its end
    if verdict is not None and not verdict.status.ok:
        partial = partial or verdict.status.value.rstrip(".")
    others, measured = (
        [row if timed else replace(row, time=math.nan) for row in largest_first(some, _by_use)] for some in (drives, quantities)
    )
    return Finding(
        members=tuple(rows),
        drives=tuple(others),
        quantities=tuple(measured),
        left_out=() if verdict is None else tuple(map(str, verdict.attrs.get("not_held", []))),
        partial=partial,
        doubts=tuple(doubts),
    )


def _by_use(row: Row) -> float:
    return row.utilisation if row.checked else -math.inf


def demands(demand: Mapping[str, Demand]) -> list[Row]:
    """The checks of drives, of the demand by load case."""
    cases = ((case, one) for case, one in demand.items() if "utilisation" in one.arrays)
    return [replace(row, load_case=case) for case, one in cases for row in one.table()]
