"""Inputs of the integrators: memory, control data, events and times of jumps; one call of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinetruss.elements.kinds import on_coordinates
from kinetruss.elements.scalars import linear_laws
from kinetruss.errors import InputError
from kinetruss.kernels.coordinates.programs import Program
from kinetruss.kernels.coordinates.straight_line import addresses_of
from kinetruss.kernels.coordinates.tape import tape_of
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import asking
from kinetruss.kernels.integrate.dop853_step import aside
from kinetruss.kernels.integrate.events import watching
from kinetruss.kernels.integrate.loop import march, steps
from kinetruss.kernels.integrate.state import COORDINATE, FORCE, LENGTH, SUM, Control, Memory, Samples, new_memory
from kinetruss.kernels.series.measured import measured
from kinetruss.kernels.structure.equations import DENSE, SUM_FORCE
from kinetruss.kernels.structure.rows import POLYNOMIAL
from kinetruss.kernels.structure.structure import CABLE, ENGINEERING, GREEN, LENGTH as LENGTH_KIND
from kinetruss.mechanics import System
from kinetruss.mechanics.measure_arrays import period_of, terms_of
from kinetruss.mechanics.measures import measure_of, terms_sum
from kinetruss.mechanics.sparse_plan import tangent_record
from kinetruss.model import DOP853, ERROR_CONTROLLED, EnergyMomentum, GeneralizedAlpha, Radau, Rattle, Taylor
from kinetruss.model.simulation import WATCHED

if TYPE_CHECKING:
    from kinetruss.kernels.structure.equations import Equations, Workspace


Floats = NDArray[np.float64]
Terms = list[tuple[int, list[int], list[float]]]


class Watched(NamedTuple):
    """A watched quantity: kind (LENGTH, COORDINATE, FORCE, SUM), flat coordinates or constraint a, b, value, direction
    (1, -1, 0), whether it stops the run; the terms of a sum, and after what it is the same (0: never).
    """

    kind: int
    a: int
    b: int
    value: float
    direction: int
    stops: bool
    terms: Terms = []
    period: float = 0.0


METHODS: dict[type, int] = {
    DOP853: m.EXPLICIT_RK,
    EnergyMomentum: m.MIDPOINT,
    GeneralizedAlpha: m.ALPHA,
    Radau: m.RADAU,
    Rattle: m.RATTLE,
    Taylor: m.TAYLOR,
}
PIVOT_LIMIT = 0.3
"""Scaled pivot, as a fraction of the largest one so far, above which no position is near a singular one."""
ROUND_OFF = 8 * 2.2e-16
"""Residual of a constraint as a fraction of the coordinates. Near a singular position of pivot p, 1/p^2 multiplies it."""


def integrate(
    eq: Equations, ws: Workspace, user: int, told: Control, memory: Memory, samples: Samples, budget: int
) -> tuple[int, int]:
    """Go on from `memory` and fill the samples, in at most `budget` steps. Returns a code and how many are filled.

    The run in any number of calls is bit for bit that in one.
    """
    before = memory.steps
    code, filled = march(eq, ws, user, told, memory, samples, budget)
    if code != m.ASIDE:
        return code, filled
    told.aside_at = int(aside.addresses()[0])
    code, more = march(eq, ws, user, told, memory, samples.part(filled), budget - (memory.steps - before))
    return code, filled + more


def start_memory(
    eq: Any, t0: float, x: Floats, v: Floats, z: Floats | None = None, events: int = 0, method: Any = None
) -> Memory:
    """Memory of a run that starts at t0 (s) with consistent positions x (3 n,), velocities v (3 n,) and extra states z."""
    extra = np.zeros(0) if z is None else np.asarray(z, float)
    rows = max(8, orders_of(method) + 1) if isinstance(method, Taylor) else 8
    memory = new_memory(eq.free.size, extra.size, eq.A.size, events, orders=rows)
    restart_memory(memory, t0, np.concatenate([x[eq.free], v[eq.free], extra]))
    return memory


def restart_memory(memory: Memory, t0: float, state: Floats) -> None:
    """Put memory back to a start at t0 (s) in a state (see kernels.integrate.state)."""
    memory.clear_numbers()
    for values in (memory.y, memory.dense, memory.multiplier, memory.watched, memory.between):
        values.fill(0)
    memory.t = t0
    memory.y[0] = state


def control(
    eq: Any,
    system: System,
    method: Any,
    span: tuple[float, float],
    *,
    events: Sequence[Watched] = (),
    breaks: Sequence[float] = (),
    isolated: bool = False,
    turns: bool = False,
) -> Control:
    """The control data of an integrator.

    Parameters
    ----------
    method : DOP853, EnergyMomentum, GeneralizedAlpha, Radau, Rattle or Taylor.
    span : start and end, s. breaks : times at which a load, a drive or its rates jump, s; a step ends there.
    isolated : energy is conserved or lost: no moving drive, no time-dependent load, no user force.
    turns : states between samples are kept if something turns far.
    """
    t0, t_end = span
    inner = sorted({float(t) for t in breaks if t0 < t < t_end})
    times = np.array([t0, *inner, t_end])
    table = np.stack([times, times, np.append(times[1:], t_end)])
    table[1, 1:] = np.nextafter(times[1:], np.inf)
    table[2, :-2] = np.nextafter(times[1:-1], -np.inf)
    length = _member_lengths(system)[eq.free]
    stiff = eq.law_A.size or eq.element.size
    pattern = tangent_record(eq, system) if isinstance(method, EnergyMomentum | GeneralizedAlpha | Radau) and stiff else {}
    reach = float(np.abs(system.x0).max(initial=0.0))
    return Control.of_method(
        pattern,
        {
            **_numbers(method, t_end, isolated, float(length.min(initial=np.inf)), reach, _chosen_anew(eq)),
            "stand": system.x0.reshape(-1).astype(float),
            "free": np.ascontiguousarray(eq.free, np.int64),
            "length": length,
            "breaks": table,
            **_watches(eq, events),
            **(_turning(system) if turns else {}),
            **(_tape(eq, system) if isinstance(method, Taylor) else {}),
        },
    )


def _watches(eq: Any, events: Sequence[Watched]) -> dict[str, Any]:
    """The entries of `Control` for watched quantities, for those that are not polynomials within a step, and their places in
    a state.
    """
    at, sampled = np.full((len(events), 6), -1), np.zeros(len(events), bool)
    for k, (kind, a, b, *_) in enumerate(events):
        flat = {m.COORDINATE: [a], m.LENGTH: [*range(a, a + 3), *range(b, b + 3)]}.get(kind, [])
        at[k, : len(flat)] = eq.local[flat]
        sampled[k] = kind in (m.FORCE, m.SUM) or np.isin(flat, eq.held).any()
    columns = zip(*(one[:6] for one in events), strict=True) if events else [()] * 6
    names = ("event_kind", "event_A", "event_B", "event_value", "event_direction", "event_stops")
    terms = [one.terms for one in events]
    kinds, places, data = zip(*(term for own in terms for term in own), strict=True) if any(terms) else ((), (), ())
    return {
        **dict(zip(names, columns, strict=True)),
        "watching": watching.addresses() if events else [],
        "event_sampled": sampled,
        "event_at": at,
        "event_ptr": np.cumsum([0, *map(len, terms)]),
        "event_form": addresses_of(np.array(kinds, np.int64)),
        "event_term": np.array(places, np.int64).reshape(-1, 4),
        "event_data": np.array(data, float).reshape(-1, 7),
        "event_period": [one.period for one in events],
    }


def _turning(system: System) -> dict[str, NDArray[Any]]:
    """All that may turn: members, edges of membranes and solids, and angles about axes."""
    p, q = system.p, system.q
    if system.continua is not None:
        p, q = np.concatenate([p, system.continua.p]), np.concatenate([q, system.continua.q])
    moving = [j for j in range(len(system.measures)) if system.measure_period[j] > 0.0]
    terms = [np.arange(system.measure_ptr[j], system.measure_ptr[j + 1]) for j in moving]
    chosen = np.concatenate([*terms, np.zeros(0)]).astype(np.int64)
    return {
        "pairs": 3 * np.stack([p, q], axis=1).astype(np.int64),
        "angle_ptr": np.cumsum([0, *map(len, terms)]).astype(np.int64),
        "angle_form": system.term_form[chosen],
        "angle_at": system.term_at[chosen],
        "angle_data": system.term_data[chosen],
    }


def _tape(eq: Any, system: System) -> dict[str, NDArray[Any]]:
    """All sums of terms that rows hold, elements resist and given torques turn, as kernels.series.measured takes them."""
    pushed = eq.force_A[eq.force_kind == SUM_FORCE] - eq.sum_ptr[-1]
    program, laws = Program(), np.zeros((0, 5))
    for one in system.row_measure[eq.row[eq.sum_row]].tolist():
        program.result(measure_of(system, program, one))
    if (resisting := on_coordinates(system)) is not None:
        for first, last in pairwise(resisting.ptr):
            part = slice(first, last)
            program.result(terms_sum(program, system.dim, resisting.kind[part], resisting.at[part], resisting.data[part]))
        found = np.empty((len(resisting.law), 3))
        linear_laws(resisting, found)
        laws = np.column_stack([resisting.rest, resisting.period, found])
    for one in (np.searchsorted(system.measure_ptr, pushed, side="right") - 1).tolist():
        program.result(measure_of(system, program, one))
    if not program.results:
        return {}
    tape = tape_of(program, 0).with_(series=measured.addresses())
    return {"tape_ints": tape.ints, "tape_reals": tape.reals, "tape_laws": laws}


def _steps_of(method: Any) -> int:
    """Address of the steps of a method, which are compiled when they are first asked for."""
    if isinstance(method, DOP853):
        from kinetruss.kernels.integrate.dop853_step import dop853_steps as found
    elif isinstance(method, Taylor):
        from kinetruss.kernels.integrate.taylor_step import taylor_steps as found
    elif isinstance(method, Radau):
        from kinetruss.kernels.integrate.radau_step import radau_steps as found
    else:
        from kinetruss.kernels.integrate.fixed_run import steps_of_fixed_size as found
    return steps.address(found)


def _chosen_anew(eq: Any) -> bool:
    """True if every factorisation chooses the independent constraints: if loops do not close exactly, each choice gives other
    accelerations.
    """
    return bool(eq.solver == DENSE and eq.redundant.any())


def _numbers(method: Any, t_end: float, isolated: bool, size: float, reach: float, projected: bool) -> dict[str, float]:
    """The numbers in `Control`. size : length of the shortest members, m. reach : largest coordinate, m. projected : True if
    stages are projected onto the constraints.
    """
    found = {
        "t_end": t_end,
        "isolated": float(isolated),
        "size": size,
        "pivot_limit": PIVOT_LIMIT,
        "method": METHODS[type(method)],
        "steps_at": _steps_of(method),
        "find_at": asking.addresses()[0],
        "aside_at": aside.addresses()[0] if isinstance(method, DOP853 | Radau) else 0,
    }
    if isinstance(method, ERROR_CONTROLLED):
        found |= {
            "max_steps": method.max_steps,
            "fixed_step": method.step or 0.0,
            "rtol": method.rtol,
            "atol": method.atol,
            "first_step": method.first_step or 0.0,
            "tolerance": ROUND_OFF * (1.0 + reach / size),
            "stages_projected": float(projected),
        }
    else:
        found |= {"max_steps": np.inf, "fixed_step": method.step, "tolerance": method.tolerance}
    if isinstance(method, GeneralizedAlpha):
        found["rho"] = method.rho
    if isinstance(method, Taylor):
        found["orders"] = orders_of(method)
    return found


def orders_of(method: Taylor) -> int:
    """Orders of the power series by its length. Small tolerances need more terms; round-off at a singularity allows fewer.

    Near a singular position the series of the constraint residual left by round-off converges only up to that position. At c
    times its distance the term of order j grows by c^j. The position is passed if the term is below the tolerance at c = 1.5.
    """
    if method.order is not None:
        return method.order + 1
    wanted, safe = 9.0 - 0.5 * np.log(method.rtol), np.log(method.rtol / 1e-15) / np.log(1.5)
    return int(max(7, min(wanted, safe)))


def _member_lengths(system: System) -> Floats:
    """Mean length (m) of the members at the node of every flat coordinate (3 n,); the mean of all members if it has none."""
    p, q, n = system.p, system.q, system.x0.shape[0]
    if system.continua is not None:
        p, q = np.concatenate([p, system.continua.p]), np.concatenate([q, system.continua.q])
    span = np.linalg.norm(system.x0[q] - system.x0[p], axis=1)
    total = np.bincount(p, span, n) + np.bincount(q, span, n)
    count = np.bincount(p, minlength=n) + np.bincount(q, minlength=n)
    everywhere = float(span.mean()) if span.size else 1.0
    return np.repeat(np.where(count > 0, total / np.maximum(count, 1), everywhere), 3)


# Events as the integrators need them, and the times of jumps.

WAYS = {"rising": 1, "falling": -1, "both": 0}
SAME = 1e-9
"""Relative tolerance below which two adjacent segments of a motion count as continuous."""


def watched(system: System, eq: Equations, events: Mapping[str, Any]) -> list[Watched]:
    """Kind, coordinates or constraint, value, direction and stop flag of every event.

    The force of an elastic bar is a function of its length, so its length is watched instead.

    Raises
    ------
    InputError : the force of a damped, slack or free bar, or of a free drive: no multiplier of the equations gives it.
    """
    return [
        Watched(*_quantity(system, eq, name, event), WAYS[event.direction], bool(event.stop), *_terms(system, event))
        for name, event in events.items()
    ]


def _terms(system: System, event: Any) -> tuple[Terms, float]:
    """The terms of the coordinate of an event, and after what it is the same (0: never)."""
    if event.terms is None and (event.coordinate is None or isinstance(event.coordinate, str)):
        return [], 0.0
    index = {name: i for i, name in enumerate(system.nodes)}
    parts = event.terms or ((event.coordinate, 1.0),)
    found = [term for one, factor in parts for term in terms_of(system.model, index, system.x0, one, factor)]
    if (period := period_of(parts)) is None:
        raise InputError("events: the factors of the angles of a sum are in no ratio of whole numbers. Mend the factors.")
    return found, period


def _quantity(system: System, eq: Equations, name: str, event: Any) -> tuple[int, int, int, float]:
    if event.terms is not None or not isinstance(event.coordinate, str | None):
        return SUM, 0, 0, event.value
    if event.coordinate is not None:
        node, _, axis = event.coordinate.rpartition(".")
        return COORDINATE, 3 * system.node_index(node) + "xyz".index(axis), 0, event.value
    i = system.members.index(event.length if event.length is not None else event.force)
    a, b = 3 * int(system.p[i]), 3 * int(system.q[i])
    if event.length is not None:
        return LENGTH, a, b, event.value
    rows = np.flatnonzero((system.row_member[eq.row] == i) & (system.row_kind[eq.row] == LENGTH_KIND))
    if len(rows):
        return FORCE, int(rows[0]), 0, event.value
    return LENGTH, a, b, _length_at(system, i, name, event)


def _length_at(system: System, i: int, name: str, event: Any) -> float:
    """The length at which an elastic bar has the force of the event."""
    k, l0, law, N = system.spring[i], system.natural[i], system.law[i], event.value
    if law == ENGINEERING and not system.damping[i]:
        return float(l0 + N / k)
    if law == CABLE and not system.damping[i] and N >= 0:
        return float(l0 + N / k)
    if law == GREEN and not system.damping[i]:
        # N = k (l^2 - l0^2) l/(2 l0^2) has one root above the length of greatest compression
        roots = np.roots([1.0, 0.0, -(l0**2), -2.0 * N * l0**2 / k])
        real = roots[np.abs(roots.imag) < 1e-9 * l0].real
        if real.max() > l0 / np.sqrt(3.0):
            return float(real.max())
    raise InputError(
        f"events.{name}: the force of {event.force!r} cannot be watched. "
        "Forces of rigid and driven members, of undamped elastic bars and, from 0 N on, of cables can be. "
        "Watch a length or a coordinate instead."
    )


def described(name: str, event: Any) -> str:
    """An event as text."""
    what = next(field for field in WATCHED if getattr(event, field) is not None)
    way = {"rising": "rises through", "falling": "falls through", "both": "crosses"}[event.direction]
    quantity = getattr(event, what)
    if what == "terms":
        what, quantity = "sum", " + ".join(" ".join(_named(one)) for one, _ in quantity)
    elif not isinstance(quantity, str):
        what, quantity = quantity.kind, ", ".join(_named(quantity))
    return f"{name} ({what} {quantity} {way} {event.value:g} {event.unit})"


def _named(coordinate: Any) -> list[str]:
    """The bars and nodes that a coordinate names."""
    given = (getattr(coordinate, name, ()) for name in ("bar", "node", "axis", "start", "end", "line", "point", "nodes"))
    return [one for part in given for one in ((part,) if isinstance(part, str) else part or ()) if isinstance(one, str)]


def jumps(eq: Equations, all_pieces: bool = False) -> list[float]:
    """Times (s) at which the slope of a load, or the value, rate or acceleration of a drive or support, may jump."""
    found = {float(t) for t in (*eq.force_time, *eq.load_time)}
    for d in range(len(eq.motion_kind)):
        if eq.motion_kind[d] != POLYNOMIAL:
            continue
        first, last = eq.motion_ptr[d], eq.motion_ptr[d + 1]
        for k in range(first, last - 1):
            curve = np.polynomial.Polynomial(eq.piece[k])
            s = eq.piece_start[k + 1] - eq.piece_start[k]
            if all_pieces:
                found.add(float(eq.piece_start[k + 1]))
            for order in range(0 if all_pieces else 3):
                before, after = curve.deriv(order)(s) if order else curve(s), eq.piece[k + 1, order] * (1, 1, 2)[order]
                if abs(after - before) > SAME * max(1.0, abs(before), abs(after)):
                    found.add(float(eq.piece_start[k + 1]))
    return sorted(found)
