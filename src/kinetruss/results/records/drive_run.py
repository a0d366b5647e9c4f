"""The response of a drive train to its input: histories, episodes, a trajectory."""

from __future__ import annotations

from dataclasses import dataclass

from kinetruss.display import instant, quantity
from kinetruss.model import Spline
from kinetruss.results.records.records import Result

__all__ = ["DriveRun", "Episode"]


@dataclass(frozen=True, slots=True)
class Episode:
    """An interval in which a drive could not follow its input, or moved without it.

    kind : ``input saturated``, ``voltage saturated``, ``current saturated``, ``speed limit``, ``too fast``, ``stuck``,
    ``driven back``, ``end of stroke``.
    start, end : s. time : s, of the worst. wanted, possible : in `unit`, there; for ``stuck`` the torque that would start it
    and the torque given.
    """

    kind: str
    start: float
    end: float
    time: float
    wanted: float
    possible: float
    unit: str

    @property
    def ratio(self) -> float:
        """Ratio of wanted to possible."""
        return self.wanted / self.possible if self.possible else float("inf")

    def __str__(self) -> str:
        possible = quantity(self.possible, self.unit)
        when = f"from {instant(self.start)} to {instant(self.end)}"
        if self.kind == "end of stroke":
            moved = "angle" if self.unit == "rad" else "length"
            return f"end of stroke at {instant(self.start)}: {moved} {quantity(self.possible, self.unit, 6)}."
        if self.kind == "driven back":
            return f"the load drives the motor {when}."
        if self.kind == "stuck":
            return self._stuck(when)
        if self.kind == "speed limit":
            return f"the motor runs at its largest speed of {possible} {when}."
        if not self.ratio > 1 + 1e-6:
            return f"{self.kind} {when}: at its limit of {possible}."
        more = f"{quantity(self.ratio - 1, '%')} more than {possible}"
        return f"{self.kind} {when}: at {instant(self.time)} it would take {quantity(self.wanted, self.unit)}, {more}."

    def _stuck(self, when: str) -> str:
        missing = self.wanted - self.possible
        wanted, possible, less = (quantity(one, "N m") for one in (self.wanted, self.possible, missing))
        if missing <= 1e-6 * self.wanted:
            return f"stuck {when}, until the motor has the {wanted} that start it."
        return f"stuck {when}: starting takes {wanted} at the motor, it has {possible}, {less} less."


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class DriveRun(Result):
    """Histories of a drive train over time; see `actuators.simulate_drive`.

    episodes : intervals in which it was limited, in order of time.
    """

    episodes: tuple[Episode, ...] = ()

    def trajectory(self, drive: str) -> Spline:
        """The history of the length or angle as a trajectory of a drive or active member: a quintic spline through samples.

        If the acceleration jumps (a step input, a reversal of friction), the spline smooths the jump between two samples.
        """
        moved = "angle" if "angle" in self.data else "length"
        rows, values = (tuple(self.data[name].values.tolist()) for name in ("time", moved))
        # the user chooses the sample spacing; a long interval is not a gap of a measured record
        return Spline(times=rows, values={drive: values}, largest_gap=1e9)
