"""Rows whose law has kinks, in small displacements: cables that pull, struts and stops that press, springs with play.

Each has the force k (e - upper) where its elongation e is above `upper`, k (e - lower) where it is below `lower`, and none
between. Which of the three holds is found by solving, changing and solving again (an active set). Where the energy has one
minimum, as of a structure that is stable without prestress, there is one such state.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError, InputError, few
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics import CABLE, System, constraint_jacobian, ends_of
from kinetruss.mechanics.elements import named_motions
from kinetruss.statics.search import row_errors
from kinetruss.statics.small_displacements import Solved, element_rows, solve

if TYPE_CHECKING:
    from numpy.typing import NDArray


REACHED = 1e-12
"""What is short of its kink by less than this fraction of the length, or m, touches before the load."""

PULLS = 1e-9
"""A force below this fraction of the largest one is none."""

WEAK = 1e-6
"""Fraction of its stiffness that a row without force has while it is looked for what it touches."""

FAR = 0.01
"""What a mechanism may move until something holds it, of its size: displacements are small."""

MOST = 100
"""Largest number of solutions, and of changes of one row at a time for each row."""

OFF = 1e-13
"""A coupling that is off its value by less than this, relative to the value, or m, is at it."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Kinks:
    """Rows with kinks: their indices (k,), elongations `lower`, `upper` (k,) m from the configuration, infinite where there is
    none, and stiffness (k,) N/m. curved : elements whose law has another form, so that it is taken with its slope.
    """

    row: NDArray[np.int64]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    stiffness: NDArray[np.float64]
    curved: tuple[str, ...]

    def laws(
        self, state: NDArray[np.int64], flexible: NDArray[np.float64], tension: NDArray[np.float64], weak: float = 0.0
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Flexibility and tension (rows,) at x, in place of the given ones, of rows in this state (k,).

        weak : fraction of its stiffness that a row between its kinks has.
        """
        now, before, k = flexible.copy(), tension.copy(), self.stiffness
        end = np.where(state > 0, self.upper, np.where(state < 0, self.lower, 0.0))
        now[self.row] = np.where(state != 0, 1.0 / k, 1.0 / (weak * k) if weak else np.inf)
        before[self.row] = np.where(state != 0, -k * end, 0.0)
        return now, before

    @property
    def before(self) -> NDArray[np.int64]:
        """1 of those above their upper kink before the load, or on it, -1 below the lower one, 0 between."""
        return np.where(self.upper <= REACHED, 1, np.where(self.lower >= -REACHED, -1, 0))


@dataclass(frozen=True, kw_only=True, eq=False)
class OneSided:
    """The solution, with the flexibility and the tension (rows,) in the configuration that rows have under this load; stored
    (rows,) J : energy that the load adds; slack : names of members that carry nothing; given (rows,) m : displacements that
    couplings prescribe; state (k,) of the rows with kinks: 1 above the upper one, -1 below the lower one, 0 between.
    """

    solved: Solved
    flexible: NDArray[np.float64]
    tension: NDArray[np.float64]
    stored: NDArray[np.float64]
    slack: tuple[str, ...]
    given: NDArray[np.float64]
    state: NDArray[np.int64]


def kinks_of(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64]) -> Kinks:
    """Those of the rows of `stiff_rows` at positions x (n, 3) that are not kept inextensible."""
    i = held.row_member
    cable = np.flatnonzero((held.row_kind == LENGTH) & (held.law[i] == CABLE) & (flexible != 0))
    length = ends_of(held, x, i[cable])[1]
    short = held.natural[i[cable]] - length
    # before the load a cable within round-off of its natural length pulls
    short[np.abs(short) <= REACHED * held.natural[i[cable]]] = 0.0
    rows, lower, upper = [*cable.tolist()], [np.full(len(cable), -np.inf)], [short]
    stiff, curved = [held.spring[i[cable]]], []
    if held.force_elements:
        here = named_motions(held, x[None]).value[0]
        scale = held.measure_scale[held.force_element_measure]
        places = element_rows(held).tolist()
        for k, (name, (kind, record)) in enumerate(held.model.force_elements.items()):
            one = _Numbered(held, kind, k - held.force_element_spans[kind].start, record)
            start = held.measure_start[held.force_element_measure[k]]
            ends = _ends(kind, one, float(start))
            if ends is None:
                curved += [name] if getattr(one, "exponent", 1.0) != 1.0 or getattr(one, "table", None) else []
                continue
            rows.append(places[k])
            off = [scale[k] * (end - here[k]) for end in ends]
            lower.append(np.array(off[:1]))
            upper.append(np.array(off[1:]))
            stiff.append(np.array([one.stiffness / scale[k] ** 2]))
    return Kinks(
        row=np.array(rows, np.int64),
        lower=np.concatenate(lower),
        upper=np.concatenate(upper),
        stiffness=np.concatenate(stiff),
        curved=tuple(curved),
    )


class _Numbered:
    """An element on a coordinate with the numbers that the system has of it, where it has some, in place of its record's."""

    def __init__(self, held: System, kind: str, place: int, record: Any) -> None:
        own = {name: held.element_numbers.get(f"{kind} {name}") for name in type(record).model_fields}
        numbers = {name: float(one[place]) for name, one in own.items() if one is not None}
        self.__dict__.update(vars(record) | {name: None if np.isnan(one) else one for name, one in numbers.items()})

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name)


def _ends(kind: str, one: Any, start: float) -> tuple[float, float] | None:
    """The values of the coordinate between which an element has no force, if it has a constant stiffness beyond them."""
    if kind == "stop" and one.exponent == 1.0:
        return (-np.inf if one.lower is None else float(one.lower), np.inf if one.upper is None else float(one.upper))
    if kind == "spring" and one.play and one.table is None:
        rest = start if one.rest is None else float(one.rest)
        return rest - float(one.play), rest + float(one.play)
    return None


def given_displacements(held: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Displacements (rows,) m from x (n, 3) that couplings with a value prescribe."""
    found = np.zeros(len(held.row_kind))
    names = [name for name, one in held.model.couplings.items() if one.value is not None]
    if not names:
        return found
    measures = [held.measures.index(name) for name in names]
    rows = np.flatnonzero(np.isin(held.row_measure, measures) & (held.row_drive < 0))
    off = -row_errors(held, x, held.row_value)[rows]
    size = np.maximum(1.0, np.abs(held.row_value[rows])) * held.measure_scale[held.row_measure[rows]]
    found[rows] = np.where(np.abs(off) > OFF * size, off, 0.0)
    return found


def solve_one_sided(
    held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], tension: NDArray[np.float64], load: NDArray[np.float64]
) -> OneSided:
    """`solve` with the rows that pull or press under nodal forces load (3 n,), N, at positions x (n, 3).

    flexible, tension (rows,) : flexibility and force of the rows in the configuration itself.

    Raises
    ------
    InputError : as `solve`; the message names slack members. A mechanism that moves far until it is held is one.
    AnalysisError : no set is consistent.
    """
    kinks, given = kinks_of(held, x, flexible), given_displacements(held, x)
    known = held, x, flexible, tension, load, kinks, given
    try:
        return _searched(*known, kinks.before)[0]
    except InputError as mechanism:
        if not len(kinks.row):
            raise
        # a mechanism until some of them touch: where it goes is found with weak springs in place of nothing
        found, state = _searched(*known, _searched(*known, kinks.before, WEAK)[1])
        way = np.where(state > 0, kinks.upper, np.where(state < 0, kinks.lower, 0.0))
        if np.abs(way).max() > FAR * np.ptp(x, axis=0).max():
            raise mechanism from None
        return found


def _searched(
    held: System,
    x: NDArray[np.float64],
    flexible: NDArray[np.float64],
    tension: NDArray[np.float64],
    load: NDArray[np.float64],
    kinks: Kinks,
    given: NDArray[np.float64],
    state: NDArray[np.int64],
    weak: float = 0.0,
) -> tuple[OneSided, NDArray[np.int64]]:
    """The solution and the state of the rows: 1 above the upper kink, -1 below the lower one, 0 between, where a row then has
    this fraction of its stiffness.
    """
    G, row, k = constraint_jacobian(held, x), kinks.row, kinks.stiffness
    seen, alone = set(), False
    for _ in range(MOST + MOST * len(row)):
        now, before = kinks.laws(state, flexible, tension, weak)
        on = state != 0
        solved = solve(held, x, now, load - G.T @ before, given)
        total = before + solved.force
        least = PULLS * float(np.abs(total).max(initial=0.0))
        e = np.where(on, solved.force[row] / k, solved.elongation[row])
        wanted = np.where(k * (e - kinks.upper) > least, 1, np.where(k * (e - kinks.lower) < -least, -1, 0))
        # at a kink both are right
        kept = on & (state * total[row] >= -least)
        wrong = np.where(on, ~kept, wanted != 0)
        if not wrong.any():
            slack = _slack(held, row[~on])
            stored = stored_energy(kinks, solved, before, given)
            found = OneSided(solved=solved, flexible=now, tension=before, stored=stored, slack=slack, given=given, state=state)
            return found, state
        key = state.tobytes()
        if key in seen:  # one at a time, the first wrong one, so that it does not go round (Murty, 1974)
            alone = True
        if alone:
            wrong = np.arange(len(wrong)) == int(np.flatnonzero(wrong)[0])
        seen.add(key)
        state = np.where(wrong, wanted, state)
    among = few(list(dict.fromkeys(held.part_of(r) for r in row)), 6)
    raise AnalysisError(f"It was not found which of {among} pull or press under this load. See statics.equilibrium.")


def stored_energy(
    kinks: Kinks,
    solved: Solved,
    before: NDArray[np.float64],
    given: NDArray[np.float64],
    first: NDArray[np.int64] | None = None,
) -> NDArray[np.float64]:
    """The energy (rows,) J that the load adds to the rows, with the tension `before` (rows,) that they have at x, and the state
    `first` (k,) there of those with kinks, by default `Kinks.before`.
    """
    first = kinks.before if first is None else first
    k, row = kinks.stiffness, kinks.row
    stored = np.where(given != 0.0, 0.0, (0.5 * solved.force + before) * solved.elongation)
    was = np.where(first > 0, -k * kinks.upper, np.where(first < 0, -k * kinks.lower, 0.0))
    stored[row] = 0.5 * ((before + solved.force)[row] ** 2 - np.nan_to_num(was) ** 2) / k
    return stored


def changed(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], e: NDArray[np.float64]) -> tuple[str, ...]:
    """Cables, stops and supports that elongations e (rows,) m of the rows from positions x (n, 3) tighten or slacken, so that
    they do not keep the flexibility that they have there.
    """
    kinks = kinks_of(held, x, flexible)
    if not len(kinks.row):
        return ()
    to = e[kinks.row]
    far = PULLS * float(np.abs(e).max(initial=0.0))
    on, state = np.isfinite(flexible[kinks.row]), kinks.before
    gone = on & (((state > 0) & (to < kinks.upper - far)) | ((state < 0) & (to > kinks.lower + far)))
    come = ~on & ((to > kinks.upper + far) | (to < kinks.lower - far))
    rows = kinks.row[gone | come]
    return tuple(dict.fromkeys(held.part_of(r) for r in rows))


def _slack(held: System, rows: NDArray[np.int64]) -> tuple[str, ...]:
    """Members, springs and stops of the user that carry nothing; those of supports are listed by themselves."""
    names: Sequence[str] = [held.row_name(r) for r in rows]
    return tuple(name for name in names if name not in held.inner.elements)
