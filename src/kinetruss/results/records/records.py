"""Results: an xarray dataset with named axes and units, a status, and where it came from."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum
from typing import TYPE_CHECKING, Any, Self

from kinetruss.results.records.arrays import HELD, Arrays, Columns, columns_of
from kinetruss.results.records.rows import NOT_CHECKED, Row, rows_of
from kinetruss.results.records.wide import wide

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Demand", "Forces", "Motion", "Result", "Sections", "Status", "Verdict"]

LONGEST = 300
"""Characters of status and message that `repr` shows."""


class Status(Enum):
    """How an analysis ended; the value is the sentence a person reads."""

    COMPLETED = "Completed."
    NOT_CONVERGED = "The lengths cannot be closed: no configuration was found near the last good one."
    SINGULAR = "The path runs into a singular position; it was stopped at the last good state."
    OUT_OF_REACH = "What is asked for is out of reach; it was stopped at the last good state."
    INCONSISTENT = "The drives fight: the prescribed motion contradicts itself."
    SATURATED = "Completed, but the drive saturated on the way: it did not do all it was told."
    SPEED_LIMIT = "Completed, but the motor ran at its largest speed on the way."
    STALLED = "The drive is too weak: it stood still against its load while it was told to move."
    END_OF_STROKE = "The drive ran to the end of its stroke; it was stopped there."
    NO_EQUILIBRIUM = "No equilibrium was found; this is the best state reached."
    UNSURE = "No digit of the result is sure: the equations are all but singular."
    EVENT = "Completed: an event that was to stop the run did so."
    STEP_TOO_SMALL = "No step is small enough to go on; the run was stopped at the last good state."
    STEP_NOT_CONVERGED = "The equations of an implicit step were not solved; the run was stopped. Use a smaller step."
    STIFF = "The fast vibrations of stiff bars force tiny explicit steps; the run was stopped. Use EnergyMomentum instead."
    NOT_FINITE = "A force or the motion is no finite number; the run was stopped at the last good state."
    USER_FORCE = "The user's force function failed; the run was stopped at the last good state."
    ENERGY_GROWS = "The energy grows without a cause; the run was stopped at the last good state."
    TOO_MANY_STEPS = "The run took as many steps as it may; it was stopped there."
    INTERRUPTED = "Interrupted on the way; what is done is good."
    RUNNING = "Still being computed; what is done is good."

    @property
    def ok(self) -> bool:
        """True only for a complete result."""
        return self in (Status.COMPLETED, Status.EVENT)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Result:
    """Arrays with names. ``result.position`` is ``result.data["position"]``.

    data : xarray.Dataset; every variable has attrs ``units`` and ``long_name``. It is made when it is first asked for.
    status, message : how it ended; only samples that are good are in `data`.
    provenance : versions, options and model of the computation.
    """

    data: xr.Dataset = HELD
    status: Status = Status.COMPLETED
    message: str = ""
    provenance: dict[str, Any] = field(default_factory=dict)

    @property
    def arrays(self) -> Columns:
        """The same as plain arrays: name -> ``dims``, ``values``, ``attrs``. No dataset is made for it."""
        held = self.__dict__["data"]
        return held.columns if isinstance(held, Arrays) else columns_of(held)

    @property
    def attrs(self) -> dict[str, Any]:
        """What the arrays as a whole are: ``data.attrs``."""
        held = self.__dict__["data"]
        found: dict[str, Any] = held.attrs
        return found

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "data":
            raise AttributeError(name)
        try:
            return self.data[name]
        except KeyError:
            known = ", ".join(str(key) for key in self.data.data_vars)
            raise AttributeError(f"{type(self).__name__} has no {name!r}. It has: {known}.") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(str(name) for name in self.data.variables)]

    def __repr__(self) -> str:
        """How it ended, and name, axes and unit of every array; ``result.data`` shows the numbers."""
        rows = [
            (str(name), f"({', '.join(f'{axis}: {size}' for axis, size in array.sizes.items())})", array.attrs.get("units", ""))
            for name, array in self.data.data_vars.items()
        ]
        wide, deep = (max((len(row[k]) for row in rows), default=0) for k in (0, 1))
        lines = [f"  {name:{wide}}  {axes:{deep}}  {unit}".rstrip() for name, axes, unit in rows]
        head = f"{type(self).__name__}: {self.status.value} {self.message}".rstrip()
        return "\n".join([head if len(head) <= LONGEST else f"{head[: LONGEST - 3]}...", *lines])

    def to_dataframe(self) -> Any:
        """A pandas table: one row an instant (or pose), one column a value, called ``member_force[M1]``; units as in `data`."""
        return wide(self.data)

    def with_(self, **changes: Any) -> Self:
        """A new result with some fields changed."""
        changes.setdefault("data", self.__dict__["data"])
        return replace(self, **changes)


class Motion(Result):
    """Positions, velocities, accelerations of all nodes in time, and what follows from them."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Forces(Result):
    """Member forces, reactions and drive forces of one load case along a motion.

    motion : the motion they belong to.
    static : the forces of the same poses at rest, or None where they were not asked for.
    """

    motion: Motion
    static: Forces | None = None
    load_case: str = "all"

    def difference(self) -> xr.Dataset:
        """Total minus static: what the motion alone causes."""
        if self.static is None:
            raise ValueError("No static forces were computed. Call dynamics.inverse(..., static=True).")
        whole = ("energy", "power", "action_place")
        kept = [name for name in self.data.data_vars if name in self.static.data and name not in whole]
        return self.data[kept] - self.static.data[kept]


class Sections(Result):
    """Section forces along members in time."""


class Verdict(Result):
    """Utilisation of every member part by every rule."""

    def table(self) -> list[Row]:
        """Rows, highest utilisation first; what could not be checked comes last and says why."""
        return rows_of(self.arrays, "part", "rule")

    def not_checked(self) -> dict[str, list[str]]:
        """``rule: what is missing`` -> the parts that were not checked for it."""
        found: dict[str, list[str]] = {}
        for row in self.table():
            if not row.checked and row.note.startswith(NOT_CHECKED):
                found.setdefault(f"{row.rule}: {row.note.removeprefix(NOT_CHECKED)}", []).append(row.part)
        return found


class Demand(Result):
    """What screws, gears and motors must deliver."""

    def table(self) -> list[Row]:
        """Rows of peak demand against limit, highest utilisation first."""
        return rows_of(self.arrays, "active", "quantity")
