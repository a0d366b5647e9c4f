"""The lightest tube of every group that carries, masses fed back into the forces until nothing changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss import strength
from kinetruss.design._apply import with_tubes
from kinetruss.design._loads import Loading, forces_of
from kinetruss.design._plan import Plan
from kinetruss.errors import AnalysisError
from kinetruss.kernels._sections import COEFFICIENTS, section_polynomials
from kinetruss.kernels._sizing import assess, scan
from kinetruss.model import Model
from kinetruss.results import Forces, Verdict
from kinetruss.strength._histories import histories
from kinetruss.strength._parts import parts_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

__all__ = ["Selection", "scanned", "select"]

BATCH = 256  # samples whose coefficients are held at a time


@dataclass(frozen=True, kw_only=True, eq=False)
class Selection:
    """Tubes that carry: choice (groups,) indices, the model with them, its forces and verdict.

    seen : tube -> (loading, sample) at which it was turned down. passes : how often the masses were fed back.
    """

    choice: NDArray[np.int64]
    model: Model
    forces: dict[str, Forces]
    verdict: Verdict
    seen: dict[int, tuple[str, int]]
    passes: int


def select(model: Model, plan: Plan, loadings: list[Loading], passes: int, start: NDArray[np.int64] | None = None) -> Selection:
    """Start from the lightest tubes; in every pass move each group past the tubes that do not carry its forces.

    Forces grow with masses, so a tube turned down in one pass stays turned down: no tube is taken back here, and no cycle can
    arise (where forces fall with masses, `settled` looks for lighter tubes afterwards).

    Raises
    ------
    AnalysisError : a group runs out of tubes, passes run out, or a part that no group sizes does not carry.
    """
    choice = (plan.start if start is None else start).copy()
    seen: dict[int, tuple[str, int]] = {}
    for number in range(1, passes + 1):
        sized = with_tubes(model, plan, choice)
        forces = forces_of(sized, loadings)
        moved = scanned(sized, forces, plan, choice, seen)
        if np.any(moved >= plan.stop):
            raise _out_of_tubes(model, sized, forces, plan, loadings, int(np.argmax(moved >= plan.stop)), number)
        if not np.array_equal(moved, choice):
            choice = moved
            continue
        verdict = strength.check(sized, forces)
        pushed = _pushed(verdict, plan, choice)
        if pushed is None:
            return Selection(choice=choice, model=sized, forces=forces, verdict=verdict, seen=seen, passes=number)
        choice = pushed
        if np.any(choice >= plan.stop):
            raise _out_of_tubes(model, sized, forces, plan, loadings, int(np.argmax(choice >= plan.stop)), number)
    growing = [group.name for group, a, b in zip(plan.groups, choice, moved, strict=True) if a != b] or ["all"]
    raise AnalysisError(
        f"The sizing does not settle within {passes} passes: {', '.join(growing[:6])} still grow. "
        "Raise settle.passes in the mission, or give larger steps between the tubes."
    )


def scanned(
    model: Model, forces: dict[str, Forces], plan: Plan, choice: NDArray[np.int64], seen: dict[int, tuple[str, int]]
) -> NDArray[np.int64]:
    """The choice moved past the tubes that do not carry these forces; `seen` learns where each was turned down."""
    pointer, safety = choice.copy(), _safety(plan)
    for name, one in forces.items():
        before, at = pointer.copy(), np.full(len(plan.tube), -1, np.int64)

        def step(coef: NDArray[np.float64], nut: NDArray[np.float64], length: NDArray[np.float64], offset: int,
                 at: NDArray[np.int64] = at) -> None:  # fmt: skip
            scan(coef, nut, length, plan.part, plan.base, plan.member, plan.group, plan.stuff, plan.tube, plan.stop, safety,
                 offset, pointer, at)  # fmt: skip

        _batches(model, one, step)
        for old, new in zip(before, pointer, strict=True):
            seen.update({tube: (name, int(at[tube])) for tube in range(int(old), int(new))})
    return pointer


def _safety(plan: Plan) -> NDArray[np.float64]:
    return np.array([plan.safety.yielding, plan.safety.buckling, 1.0])


def _batches(
    model: Model, forces: Forces,
    take: Callable[[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], int], None],
) -> None:  # fmt: skip
    """Coefficients of all parts, some samples at a time."""
    given, count = histories(model, forces), len(parts_of(model).names)
    length = np.ascontiguousarray(forces.motion.data["length"].values)
    coef, nut = np.empty((BATCH, count, 2, COEFFICIENTS)), np.empty((BATCH, count))
    for begin in range(0, len(length), BATCH):
        end = min(begin + BATCH, len(length))
        size = end - begin
        section_polynomials(*given.cut(slice(begin, end)), coef[:size], nut[:size])
        take(coef[:size], nut[:size], length[begin:end], begin)


def _pushed(verdict: Verdict, plan: Plan, choice: NDArray[np.int64]) -> NDArray[np.int64] | None:
    """The next tube for groups that the check itself turns down (its base takes part in the bending), None where none is.

    Raises
    ------
    AnalysisError : a part that no group sizes.
    """
    over = [row for row in verdict.table() if row.checked and row.utilisation > 1]
    if not over:
        return None
    other = [row for row in over if row.member not in plan.group_of or row.part.endswith(".base")]
    if other:
        row = other[0]
        raise AnalysisError(
            f"{row.part} is in no group and does not carry: {row.rule} reaches {row.utilisation:.4g} of what is allowed at "
            f"{row.time:.4g} s ({row.load_case}). Put it into a group, or make it stronger in the model.", verdict
        )  # fmt: skip
    pushed = choice.copy()
    pushed[sorted({plan.group_of[row.member] for row in over})] += 1
    return pushed


def _out_of_tubes(
    model: Model, sized: Model, forces: dict[str, Forces], plan: Plan, loadings: list[Loading], g: int, number: int
) -> AnalysisError:
    """What to say when a group has no tube left: which member, which rule, how far off."""
    group, choice = plan.groups[g], plan.start.copy()
    now = _assessed(sized, forces, plan, g)
    best = int(np.argmin(now))
    choice[g] = group.first + best
    tried = with_tubes(model, plan, choice)
    verdict = strength.check(tried, forces_of(tried, loadings))
    rows = [row for row in verdict.table() if row.checked and row.member in group.members]
    row, worst = rows[0], max(rows[0].utilisation, float(now[best]))
    off = "more than it can bear at any section" if np.isinf(worst) else f"{worst:.4g} times what is allowed"
    where = f"{row.part} reaches {off} by {row.rule} at {row.time:.4g} s ({row.load_case})"
    if number > 1:
        light = with_tubes(model, plan, plan.start)
        if float(np.min(_assessed(light, forces_of(light, loadings), plan, g))) <= 1:
            return AnalysisError(
                "The sizing does not settle: the masses run away. With the lightest tubes everywhere "
                f"{group.name!r} could be carried, but under the masses of pass {number} no tube of {group.catalogue!r} "
                f"carries it: with {group.names[best]}, {where}. Take stronger tubes.", verdict
            )  # fmt: skip
    return AnalysisError(
        f"No tube of {group.catalogue!r} carries group {group.name!r}: with the best of them, {group.names[best]}, {where}. "
        "Take a catalogue with stronger tubes, or ask for less.", verdict
    )  # fmt: skip


def _assessed(model: Model, forces: dict[str, Forces], plan: Plan, g: int) -> NDArray[np.float64]:
    """Highest utilisation of every tube of a group under the forces of a model."""
    most, safety = np.zeros(len(plan.tube)), _safety(plan)
    first, last = int(plan.start[g]), int(plan.stop[g])

    def step(coef: NDArray[np.float64], nut: NDArray[np.float64], length: NDArray[np.float64], offset: int) -> None:
        del offset
        assess(coef, nut, length, plan.part, plan.base, plan.member, plan.group, plan.stuff, plan.tube, first, last, g,
               safety, most)  # fmt: skip

    for one in forces.values():
        _batches(model, one, step)
    return most[first:last]
