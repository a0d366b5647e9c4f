"""Limits of the rates, accelerations and forces of drives, and how much of them a motion uses."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.shafts import parts_of
from kinetruss.display import number
from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.kinematics.jacobians import sensitivities
from kinetruss.mechanics import jacobian
from kinetruss.mechanics.arguments import number_of
from kinetruss.mechanics.balance import balance_of
from kinetruss.mechanics.coordinates import coordinates
from kinetruss.mechanics.elements import has_elements
from kinetruss.model import Active, LengthDrive, nearest
from kinetruss.results.records import MOTORS_UNCHECKED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System


def holding(system: System) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
    """The drive forces (times, d), N or N m, that hold gravity and all loads at rest, as a function of positions (times, 3 n).

    By virtual work: F = -(dx/dq)^T f. Positive if they do positive work when the coordinate grows.
    """
    balance, drives = balance_of(system), coordinates(system, system.drives)

    def at(x: NDArray[np.float64]) -> NDArray[np.float64]:
        f = np.stack([balance.applied(one.reshape(-1, 3)) for one in x])
        return np.asarray(-np.einsum("ti,tid->td", f, sensitivities(system, x, drives)))

    return at


def holding_rates(
    system: System,
) -> Callable[[NDArray[np.float64]], tuple[NDArray[np.float64], NDArray[np.float64]]] | None:
    """Drive forces F (d,) as by `holding`, and their derivatives dF_i/dq_j (d, d) by the drives, at positions x (3 n,).

    dF/dq = (dx/dq)^T K dx/dq with the stiffness K of loads and row forces N, J^T N = f: from f = J^T N and J dx/dq_i = e_i in
    all configurations. None for redundant structures, for elements besides bars, and for driven angles of bars.
    """
    angles = system.row_kind == ANGLE
    if len(system.row_member) != len(system.free) or has_elements(system) or angles.any():
        return None
    balance, drives = balance_of(system), coordinates(system, system.drives)

    def at(x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        place = x.reshape(-1, 3)
        f, columns = balance.applied(place), sensitivities(system, x[None], drives)[0]
        N = np.asarray(np.linalg.solve(jacobian(system, place).T, f[system.free]), np.float64)
        return -columns.T @ f, columns.T @ (balance.stiffness(place, N) @ columns)

    return at


# Limits of drives, and how much of them a motion uses.

LIMIT_ATTRS = ("limits_kept", "worst_limit", "worst_drive", "worst_time", "worst_ratio")
"""Attributes of a motion that has limits."""
AT_REST = "force at rest"
SLACK = 1e-9
"""Excess, as a share of a limit, that is round-off."""
JUMP = 3.0
"""Mean acceleration between two samples over that at both of them, above which the rate jumps."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Limits:
    """Largest magnitudes (d,) of the drives, infinite where there is none: rate m/s or rad/s, acceleration m/s^2 or rad/s^2,
    force N or N m. others : quantities of motors with limits that only forces can tell.
    """

    rate: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    force: NDArray[np.float64]
    others: tuple[str, ...]

    @property
    def moving(self) -> bool:
        """Whether any rate or acceleration has a limit."""
        return bool(np.isfinite(self.rate).any() or np.isfinite(self.acceleration).any())


@dataclass(frozen=True, kw_only=True)
class Use:
    """Largest use of one limit of one drive: `value` at `time` (s) against `most`, their `ratio`.

    jump : the rate jumps there, so that no acceleration is large enough.
    """

    limit: str
    drive: str
    time: float
    value: float
    most: float
    jump: bool = False

    @property
    def ratio(self) -> float:
        """Value over limit."""
        return self.value / self.most

    @property
    def kept(self) -> bool:
        """Whether it is within the limit, to round-off."""
        return self.ratio <= 1.0 + SLACK

    def __str__(self) -> str:
        over = f"{number(self.value)} at t = {self.time:g} s, limit {number(self.most)} ({self.ratio:.4g} times)"
        return f"{self.limit} of {self.drive} {over}{', where its rate jumps' if self.jump else ''}"


def limits_of(system: System, choice: Any) -> Limits:
    """The limits that a task and the motors of a model give: of rates, the smaller of both."""
    names = system.drives
    found = {what: limit_values(names, getattr(choice, what, None), what) for what in ("rate", "acceleration", "force")}
    others: dict[str, None] = {}
    for d, name in enumerate(names):
        motor_rate, quantities = _of_motor(system, name)
        found["rate"][d] = min(found["rate"][d], motor_rate)
        others |= dict.fromkeys(quantities)
    return Limits(**found, others=tuple(others))


def limit_values(names: Sequence[str], given: Any, what: str) -> NDArray[np.float64]:
    """Limits (d,) from one for all drives or a table by name; infinite where there is none.

    Raises
    ------
    InputError : unknown names, numbers that are not positive.
    """
    found = np.full(len(names), np.inf)
    table = given if isinstance(given, Mapping) else {} if given is None else dict.fromkeys(names, given)
    for name, value in table.items():
        if name not in names:
            raise InputError(f"No drive called {name!r} in {what}. {nearest(name, names)}".rstrip())
        if not (most := number_of(value, f"{what} of {name}", "SI")) > 0:
            raise InputError(f"The largest {what} of {name!r} is {most:g}. Give a positive number.")
        found[names.index(name)] = most
    return found


def _of_motor(system: System, name: str) -> tuple[float, list[str]]:
    """Largest rate of a drive at the largest speed of its motor; other limited quantities of its motor and amplifier."""
    model, drive = system.given, system.given.all_drives[name]
    one = model.actuators.get(drive.bar if isinstance(drive, LengthDrive) else name)
    if one is None:
        return np.inf, []
    screw, gear, motor, amplifier = parts_of(model, one)
    if motor is None or (isinstance(one, Active) and screw is None):
        return np.inf, []
    lead = screw.lead if screw is not None else 1.0
    rate = np.inf if motor.max_speed is None else motor.max_speed * lead / (gear.ratio if gear else 1.0)
    fields = {"voltage": "max_voltage", "current": "max_current", "torque": "max_torque", "input": "max_input",
              "rms current": "rated_current", "rms torque": "rated_torque"}  # fmt: skip
    limited = [
        what for what, field in fields.items() if any(getattr(part, field, None) is not None for part in (motor, amplifier))
    ]
    return rate, limited


def motion_uses(
    limits: Limits,
    names: Any,
    t: NDArray[np.float64],
    moved: tuple[Any, Any],
    force: NDArray[np.float64] | None = None,
    what: str = AT_REST,
) -> list[Use]:
    """Largest use of every limit, worst first.

    moved : rates and accelerations (times, d); force (times, d), and what it is called. A difference of rates between two
    samples counts as an acceleration too, so that jumps do not hide between samples.
    """
    rate, acceleration = moved
    found = _largest("rate", names, t, np.abs(rate), limits.rate) + _accelerations(limits, names, t, rate, acceleration)
    if force is not None:
        found += _largest(what, names, t, np.abs(force), limits.force)
    return sorted(found, key=lambda one: -one.ratio)


def _largest(what: str, names: Any, t: Any, size: NDArray[np.float64], limit: NDArray[np.float64]) -> list[Use]:
    at = np.argmax(size, axis=0)
    return [
        Use(limit=what, drive=str(names[d]), time=float(t[at[d]]), value=float(size[at[d], d]), most=float(limit[d]))
        for d in np.flatnonzero(np.isfinite(limit))
    ]


def _accelerations(limits: Limits, names: Any, t: Any, rate: Any, acceleration: Any) -> list[Use]:
    size, found = np.abs(acceleration), []
    steps = np.abs(np.diff(rate, axis=0)) / np.diff(t)[:, None] if len(t) > 1 else np.zeros((0, rate.shape[1]))
    ends = np.maximum(size[1:], size[:-1])
    for one in _largest("acceleration", names, t, size, limits.acceleration):
        d = list(names).index(one.drive)
        jumps = np.flatnonzero((steps[:, d] > JUMP * ends[:, d]) & (steps[:, d] > one.most))
        if not len(jumps):
            found.append(one)
            continue
        k = int(jumps[np.argmax(steps[jumps, d])])
        value = max(float(steps[k, d]), one.value)
        found.append(Use(limit=one.limit, drive=one.drive, time=float(t[k + 1]), value=value, most=one.most, jump=True))
    return found


def slower(uses: list[Use]) -> float:
    """The factor of time with which rates and accelerations keep their limits; infinite where a rate jumps."""
    powers = {"rate": 1.0, "acceleration": 0.5}
    factors = [np.inf if one.jump else one.ratio ** powers[one.limit] for one in uses if one.limit in powers]
    return max(factors, default=0.0)


def uses_text(uses: list[Use], t: NDArray[np.float64], why: str) -> str:
    """What of the limits is not kept, and the mend; empty if all are kept. why : they are not."""
    over = [one for one in uses if not one.kept]
    if not over:
        return ""
    more = f" {len(over) - 1} more {'limit is' if len(over) == 2 else 'limits are'} exceeded." if len(over) > 1 else ""
    said = [f"Limits are not kept ({why}): {over[0]}.{more}"]
    factor = slower(over)
    if any(one.limit == AT_REST for one in over):
        said.append("A force at rest does not depend on time: raise its limit, or lower the load.")
    if np.isinf(factor):
        said.append("A jump of rates exceeds any acceleration: give longer strokes, or a law without jumps.")
    elif factor > 0.0:
        said.append(
            f"Slowed down by the factor {factor:.6g}, to {factor * float(t[-1] - t[0]):.6g} s, this motion keeps those of "
            "rates and accelerations (dynamics.quickest)."
        )
    return " ".join(said)


# What a motion says about the limits of its drives.


def reported(
    system: System, limits: Limits, why: str, t: NDArray[np.float64], x: NDArray[np.float64], drives: Any
) -> dict[str, Any]:
    """`LIMIT_ATTRS` and `MOTORS_UNCHECKED` of a motion, and `words`, what is to be said; empty if there are no limits.

    why : limits that are not kept are not; x (times, 3 n) of the good samples; drives : values, rates and second rates.
    """
    good = len(x)
    if not good:
        return {}
    t, force = t[:good], holding(system)(x) if np.isfinite(limits.force).any() else None
    uses = motion_uses(limits, system.drives, t, (drives[1][:good], drives[2][:good]), force)
    words = [uses_text(uses, t, why)]
    data: dict[str, Any] = {"words": " ".join(one for one in words if one)}
    if limits.others:
        data[MOTORS_UNCHECKED] = list(limits.others)
    if uses:
        worst = uses[0]
        values = (int(worst.kept), worst.limit, worst.drive, worst.time, worst.ratio)
        data |= dict(zip(LIMIT_ATTRS, values, strict=True))
    return data
