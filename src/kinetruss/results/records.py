"""Results: an xarray dataset with named axes and units, a status and its provenance."""

from __future__ import annotations

import hashlib
import platform
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cache, lru_cache
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, Self

from kinetruss.errors import InputError
from kinetruss.mechanics import ByIdentity
from kinetruss.model import Model
from kinetruss.results.arrays import Arrays, Columns, columns_of
from kinetruss.results.user_parts import SHOWN, completed
from kinetruss.results.wide_tables import NOT_CHECKED, Row, rows_of, wide

if TYPE_CHECKING:
    import xarray as xr


def model_hash(model: Model) -> str:
    """SHA-256 of the whole model, first 16 hex digits.

    >>> import kinetruss as kt
    >>> light, same, heavy = (kt.library.vgt.triangular(payload_mass=mass) for mass in (10.0, 10.0, 20.0))
    >>> kt.results.model_hash(light) == kt.results.model_hash(same)
    True
    >>> kt.results.model_hash(light) == kt.results.model_hash(heavy)
    False
    """
    return _hash(ByIdentity(model))


@lru_cache(maxsize=32)
def _hash(key: ByIdentity) -> str:
    # hashing a large model takes as long as a short motion of it
    return hashlib.sha256(key.model.model_dump_json().encode()).hexdigest()[:16]


@cache
def _versions() -> dict[str, str]:
    # read once: finding the versions takes as long as the section forces of a thousand samples
    found = {name: version(name) for name in ("kinetruss", "numpy", "numba")}
    return found | {"python": platform.python_version()}


def provenance(model: Model, **options: Any) -> dict[str, Any]:
    """Versions, model title and hash, and the options of a computation.

    >>> import kinetruss as kt
    >>> found = kt.results.provenance(kt.library.vgt.triangular(), samples=201)
    >>> found["title"], found["samples"], "kinetruss" in found
    ('Triangular variable-geometry truss', 201, True)
    """
    return {
        **_versions(),
        "title": model.title,
        "model": model_hash(model),
        **options,
    }


# Results: an xarray dataset with named axes and units, a status and its provenance.

MOTORS_UNCHECKED = "motors_unchecked"
"""Attribute of a motion: the limited quantities of its motors that only forces decide."""

LONGEST = 300
"""Largest number of characters of status and message in `repr`."""


class Status(Enum):
    """How an analysis ended; the value is a sentence for the user."""

    COMPLETED = "Completed."
    NOT_CONVERGED = "The lengths cannot be closed: no configuration was found near the last good one."
    SINGULAR = "The path runs into a singular position; it was stopped at the last good state."
    OUT_OF_REACH = "The prescribed values are out of reach; the motion was stopped at the last good state."
    INCONSISTENT = "The drives contradict each other."
    SATURATED = "Completed, but the drive saturated: it did not follow its input everywhere."
    SPEED_LIMIT = "Completed, but the motor reached its largest speed."
    STALLED = "The drive is too weak: it did not move against its load while its input was not zero."
    END_OF_STROKE = "The drive ran to the end of its stroke; it was stopped there."
    NO_EQUILIBRIUM = "No equilibrium was found; this is the best state reached."
    UNSURE = "No digit of the result is certain: the equations are nearly singular."
    EVENT = "Completed: an event stopped the run as requested."
    STEP_TOO_SMALL = "No step is small enough to continue; the run was stopped at the last good state."
    STEP_NOT_CONVERGED = "The equations of an implicit step were not solved; the run was stopped. Use a smaller step."
    STIFF = "The fast vibrations of stiff bars force tiny explicit steps; the run was stopped. Use EnergyMomentum instead."
    NOT_FINITE = "A force or the motion is not finite; the run was stopped at the last good state."
    USER_FORCE = "The user's force function failed; the run was stopped at the last good state."
    ENERGY_GROWS = "The energy grows without a source; the run was stopped at the last good state."
    TOO_MANY_STEPS = "The run reached the largest number of steps and was stopped there."
    INTERRUPTED = "Interrupted; the samples so far are good."
    RUNNING = "Still being computed; the samples so far are good."

    @property
    def ok(self) -> bool:
        """True if the result is complete."""
        return self in (Status.COMPLETED, Status.EVENT)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Result:
    """Named arrays. ``result.position`` is ``result.data["position"]``.

    data : xarray.Dataset; every variable has attrs ``units`` and ``long_name``. It is made when it is first read. Its nodes,
    members and supports are those of the user, and the arms of hubs. whole : the same with the inner parts that represent
    beams, bodies and hubs (``model.whole``), with which analyses go on.
    status, message : how the analysis ended; `data` has only good samples.
    provenance : versions, options and model of the computation.
    """

    data: xr.Dataset = SHOWN
    status: Status = Status.COMPLETED
    message: str = ""
    provenance: dict[str, Any] = field(default_factory=dict)

    @property
    def whole(self) -> xr.Dataset:
        """The data with inner parts."""
        held = self.__dict__["data"]
        return held.dataset if isinstance(held, Arrays) else held

    @property
    def arrays(self) -> Columns:
        """The whole as plain arrays: name -> ``dims``, ``values``, ``attrs``. No dataset is made."""
        held = self.__dict__["data"]
        return held.columns if isinstance(held, Arrays) else columns_of(held)

    @property
    def attrs(self) -> dict[str, Any]:
        """Attributes of the whole result: ``data.attrs``."""
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

    @property
    def unchecked(self) -> str:
        """What this result alone leaves unchecked, as a sentence; empty if there is nothing."""
        return ""

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(str(name) for name in self.data.variables)]

    def __repr__(self) -> str:
        """The status, and name, axes and unit of every array; ``result.data`` shows the numbers."""
        rows = [
            (str(name), f"({', '.join(f'{axis}: {size}' for axis, size in array.sizes.items())})", array.attrs.get("units", ""))
            for name, array in self.data.data_vars.items()
        ]
        wide, deep = (max((len(row[k]) for row in rows), default=0) for k in (0, 1))
        lines = [f"  {name:{wide}}  {axes:{deep}}  {unit}".rstrip() for name, axes, unit in rows]
        head = f"{type(self).__name__}: {self.status.value} {self.message}".rstrip()
        left = [self.unchecked] if self.unchecked else []
        return "\n".join([head if len(head) <= LONGEST else f"{head[: LONGEST - 3]}...", *left, *lines])

    def to_dataframe(self) -> Any:
        """A pandas table: one row per instant (or pose), one column per value, e.g. ``member_force[M1]``; units as in
        `data`.
        """
        return wide(self.data)

    def with_(self, **changes: Any) -> Self:
        """A new result with some fields changed. To `data` that were cut or changed the inner parts are added again.

        Raises
        ------
        InputError : `data` have instants that the result lacks, and it has inner parts.
        """
        given = changes.setdefault("data", self.__dict__["data"])
        if not isinstance(given, Arrays):
            changes["data"] = completed(given, self.whole)
        return replace(self, **changes)


class Motion(Result):
    """Positions, velocities and accelerations of all nodes over time, and derived quantities."""

    @property
    def unchecked(self) -> str:
        """Limits of its motors that only forces decide, as a sentence; empty if there are none."""
        quantities = self.attrs.get(MOTORS_UNCHECKED, ())
        return (
            f"Not checked without forces: {', '.join(quantities)} of the motors (dynamics.limits_kept)." if quantities else ""
        )


def check_samples(result: Result) -> None:
    """Refuse a motion, or forces, without a single sample, as one has that ended before its first good one."""
    if not result.arrays["time"].values.size:
        ended = "" if result.status.ok else f" {result.status.value}"
        what = type(result).__name__.lower()
        raise InputError(f"The {what} has no sample.{ended} Give at least one instant.")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Forces(Result):
    """Member forces, reactions and drive forces of one load case along a motion.

    motion : their motion.
    static : the forces of the same poses at rest, or None if they were not requested.
    """

    motion: Motion
    static: Forces | None = None
    load_case: str = "all"

    def difference(self) -> xr.Dataset:
        """Total minus static: the effect of the motion alone."""
        if self.static is None:
            raise ValueError("No static forces were computed. Call dynamics.inverse(..., static=True).")
        whole = ("energy", "power", "action_place")
        kept = [name for name in self.data.data_vars if name in self.static.data and name not in whole]
        return self.data[kept] - self.static.data[kept]


class Sections(Result):
    """Section forces along members over time."""


class Verdict(Result):
    """Utilisation of every member part by every rule."""

    def __repr__(self) -> str:
        return _with_highest(super().__repr__(), self.table())

    def table(self, *, timed: bool = True) -> list[Row]:
        """Rows, highest utilisation first; entries that could not be checked are last, with the reason.

        timed : False for one pose at rest, whose time says nothing.
        """
        return rows_of(self.arrays, "part", "rule", timed=timed)

    def not_checked(self) -> dict[str, list[str]]:
        """``rule: what is missing`` -> the parts that were not checked for this reason."""
        found: dict[str, list[str]] = {}
        for row in self.table():
            if row.status == "not checked":
                found.setdefault(f"{row.rule}: {row.note.removeprefix(NOT_CHECKED)}", []).append(row.part)
        return found


class Demand(Result):
    """Forces, torques, speeds and powers that screws, gears and motors must provide."""

    def __repr__(self) -> str:
        if "active" in self.arrays and not len(self.arrays["active"].values):
            return f"Demand: {self.status.value} Empty: no active member or drive has a screw, a gear or a motor."
        return _with_highest(super().__repr__(), self.table())

    def table(self) -> list[Row]:
        """Rows of peak demand against limit, highest utilisation first."""
        return rows_of(self.arrays, "active", "quantity")


def _with_highest(text: str, rows: list[Row]) -> str:
    """The text of a result with its highest utilisation in the second line."""
    head, *arrays = text.split("\n")
    lines = [f"  highest: {rows[0].text}"] if rows and rows[0].checked else []
    return "\n".join([head, *lines, *arrays])
