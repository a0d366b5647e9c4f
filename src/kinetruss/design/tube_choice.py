"""The lightest sufficient tube of every group, with masses fed back, under all motions and load cases."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from kinetruss import dynamics, kinematics, strength
from kinetruss.design.choices import Plan, with_tubes
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.sections.records import Polynomials
from kinetruss.kernels.sections.sizing import assess, scan
from kinetruss.model import Active, Mission, Model
from kinetruss.model.load_cases import acting_cases
from kinetruss.model.runs import FLEXIBLE, MISSION, STATIC
from kinetruss.results import Forces, Motion, Row, Verdict
from kinetruss.runs.plans import SIMULATED, plan
from kinetruss.strength.parts import histories

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray


MOVING = ("dynamics.inverse", "kinematics.follow")
"""Analyses whose motion does not depend on the sections."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Loading:
    """A motion under a load case. name : of the case, with the run before it where there are several runs."""

    name: str
    run: str
    case: str | None
    motion: Motion

    def at(self, samples: Iterable[int]) -> Loading:
        """The same at some samples only."""
        chosen = np.array(sorted(samples), np.int64)
        return Loading(
            name=self.name,
            run=self.run,
            case=self.case,
            motion=self.motion.with_(data=self.motion.whole.isel(time=chosen)),
        )


def loadings(model: Model, mission: Mission) -> list[Loading]:
    """Every run of a mission under every load case.

    Raises
    ------
    AnalysisError : the path of a run ends early.
    InputError : a run is a simulation.
    """
    found = []
    names = runs_of(model, mission)
    for name in names:
        job = plan(model, name)
        motion = job.given
        if job.run.analysis == SIMULATED:
            raise InputError(
                f"Run {name!r} is a simulation, whose motion depends on the sections. Name runs with a prescribed motion."
            )
        if motion is None:
            motion = kinematics.follow(model, model.trajectory_of(job.run), times=job.times, raise_on_failure=False)
        if not motion.status.ok:
            raise AnalysisError(f"Run {name!r} ends early: {motion.message or motion.status.value}", motion)
        for case in acting_cases(model, mission.load_cases) if mission.load_cases else job.cases:
            label = case or "all"
            found.append(Loading(name=f"{name}/{label}" if len(names) > 1 else label, run=name, case=case, motion=motion))
    return found


def runs_of(model: Model, mission: Mission) -> tuple[str, ...]:
    """Names of the runs of a mission.

    Raises
    ------
    InputError : a run stands still, or has conditions.
    """
    names = mission.runs or tuple(name for name, run in model.runs.items() if run.analysis in MOVING)
    return tuple(dict.fromkeys(one for name in names for one in _moving(model, name)))


def _moving(model: Model, name: str) -> tuple[str, ...]:
    """A run, or the runs that a mission run names as motions."""
    run = model.runs.get(name)
    if run is None or run.analysis != MISSION:
        if run is not None and (run.analysis in (*STATIC, *FLEXIBLE) or run.condition is not None):
            still = "stands still" if run.analysis in STATIC else f"is {run.analysis}"
            what = still if run.condition is None else f"has the condition {run.condition!r}"
            raise InputError(f"Run {name!r} {what}, so it cannot be sized for. Name runs of dynamics.inverse.")
        return (name,)
    if run.conditions:
        raise InputError(f"Run {name!r} has conditions, which a sizing does not take. Name its motions, or make runs of them.")
    if lacking := [motion for motion in run.motions if motion not in model.runs]:
        raise InputError(f"Run {name!r} moves along {lacking[0]!r}, which is a trajectory. Make a run of it, to be sized for.")
    return run.motions


def forces_of(model: Model, loadings: Iterable[Loading]) -> dict[str, Forces]:
    """Forces of every loading by its name."""
    return {one.name: dynamics.inverse(model, one.motion, one.case, static=False) for one in loadings}


# The lightest sufficient tube of every group, with masses fed back into the forces until convergence.

BATCH = 256  # samples in one batch
TRIED = 5  # number of the best tubes of a group that are checked before it is reported that none is sufficient


@dataclass(frozen=True, kw_only=True, eq=False)
class Selection:
    """Sufficient tubes: choice (groups,) indices, the model with them, its forces and verdict.

    verdict : None for all passes but the last. rejected : tube -> (loading, sample) at which it failed. passes : number of
        times that the masses were fed back.
    """

    choice: NDArray[np.int64]
    model: Model
    forces: dict[str, Forces]
    verdict: Verdict | None
    rejected: dict[int, tuple[str, int]]
    passes: int


def select(model: Model, plan: Plan, loadings: list[Loading], passes: int) -> Selection:
    """Start from the lightest tubes; in every pass move each group past the tubes that are too weak for its forces.

    Forces grow with masses, so a tube rejected in one pass stays rejected, and no cycle can occur (if forces decrease with
    masses, `proven` searches for lighter tubes afterwards).

    Raises
    ------
    AnalysisError : no tube of a group is sufficient, no convergence within the passes, or a part outside all groups fails.
    """
    choice = plan.start.copy()
    rejected: dict[int, tuple[str, int]] = {}
    moved = choice
    for number in range(1, passes + 1):
        sized = with_tubes(model, plan, choice)
        forces = forces_of(sized, loadings)
        moved = scanned(sized, forces, plan, choice, rejected)
        if np.array_equal(moved, choice):
            verdict = strength.check(sized, forces)
            advanced = _advanced(verdict, plan, choice)
            if advanced is None:
                return Selection(choice=choice, model=sized, forces=forces, verdict=verdict, rejected=rejected, passes=number)
            moved = advanced
        if np.any(moved >= plan.stop):
            last = Selection(choice=choice, model=sized, forces=forces, verdict=None, rejected=rejected, passes=number)
            raise _out_of_tubes(model, last, plan, loadings, int(np.argmax(moved >= plan.stop)))
        before, choice = choice, moved
    growing = [group.name for group, a, b in zip(plan.groups, before, moved, strict=True) if a != b]
    raise AnalysisError(
        f"The sizing does not converge within {passes} passes: {', '.join(growing[:6])} "
        f"{'still grows' if len(growing) == 1 else 'still grow'}. Raise settle.passes in the mission."
    )


def scanned(
    model: Model, forces: dict[str, Forces], plan: Plan, choice: NDArray[np.int64], rejected: dict[int, tuple[str, int]]
) -> NDArray[np.int64]:
    """The choice moved past the tubes that are too weak for these forces; `rejected` records where each was rejected."""
    pointer = choice.copy()
    for name, one in forces.items():
        before, at = pointer.copy(), np.full(len(plan.sized.area), -1, np.int64)
        for along, length, offset in _batches(model, one):
            scan(plan.sized, along, length, offset, pointer, at)
        for old, new in zip(before, pointer, strict=True):
            rejected.update({tube: (name, int(at[tube])) for tube in range(int(old), int(new))})
    return pointer


def _batches(model: Model, forces: Forces) -> Iterator[tuple[Polynomials, NDArray[np.float64], int]]:
    """Section forces of all parts and lengths of all members in batches of samples, with the first sample of each."""
    given = histories(model, forces)
    length = np.ascontiguousarray(forces.motion.arrays["length"].values)
    for begin in range(0, len(length), BATCH):
        cut = slice(begin, begin + BATCH)
        yield given.polynomials(cut), length[cut], begin


def _advanced(verdict: Verdict, plan: Plan, choice: NDArray[np.int64]) -> NDArray[np.int64] | None:
    """The choice with the next tube for groups that fail the check (with the bending of their bases), None if all pass.

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
            f"{row.time:.4g} s ({row.load_case}). Put it into a group, or make it stronger in the model.",
            verdict,
        )
    advanced = choice.copy()
    advanced[sorted({plan.group_of[row.member] for row in over})] += 1
    return advanced


def _out_of_tubes(model: Model, sized: Selection, plan: Plan, loadings: list[Loading], g: int) -> AnalysisError:
    """The message for a group without a sufficient tube: member, rule and utilisation.

    sized : the pass in which this happens; it has no verdict yet.
    """
    group = plan.groups[g]
    now = _assessed(sized.model, sized.forces, plan, g)
    best = int(np.argmin(now))
    verdict = _with(model, plan, sized.choice, loadings, g, best)
    row = cast("Row", telling(_rows_of(verdict, group.members)))  # there is one: members of groups have materials
    where = f"{row.part} reaches {row.utilisation:.4g} times what is allowed by {row.rule}"
    where += f" at {row.time:.4g} s ({row.load_case})"
    member = model.whole.members[row.member]
    if isinstance(member, Active) and model.section_of(member.base) is not None:
        where += "; its base rod counts too, the weaker of base and tube buckles"
    if sized.passes > 1 and _sufficient_alone(model, plan, loadings, g):
        return AnalysisError(
            f"The sizing does not settle: the masses run away. With the lightest tubes everywhere else {group.name!r} could be "
            f"carried, but under the masses of pass {sized.passes} no tube of {group.catalogue} carries it: with "
            f"{group.names[best]}, {where}. Take stronger tubes, or ask for less.",
            verdict,
        )
    return AnalysisError(
        f"No tube of {group.catalogue} carries group {group.name!r}: with the best of them, {group.names[best]}, {where}. "
        "Take a catalogue with stronger tubes, or ask for less.",
        verdict,
    )


def _sufficient_alone(model: Model, plan: Plan, loadings: list[Loading], g: int) -> bool:
    """True if some tube is sufficient for a group while all other groups have their lightest."""
    light = with_tubes(model, plan, plan.start)
    found = _assessed(light, forces_of(light, loadings), plan, g)
    for index in np.argsort(found)[:TRIED]:
        rows = _rows_of(_with(model, plan, plan.start, loadings, g, int(index)), plan.groups[g].members)
        if found[index] <= 1 and all(row.utilisation <= 1 for row in rows):
            return True
    return False


def _with(model: Model, plan: Plan, choice: NDArray[np.int64], loadings: list[Loading], g: int, index: int) -> Verdict:
    """The verdict on a choice with another tube for one group, by its place in the catalogue."""
    changed = choice.copy()
    changed[g] = plan.start[g] + index
    tried = with_tubes(model, plan, changed)
    return strength.check(tried, forces_of(tried, loadings))


def _rows_of(verdict: Verdict, members: tuple[str, ...]) -> list[Row]:
    """The checked rows of the tubes of some members."""
    return [row for row in verdict.table() if row.checked and row.member in members and not row.part.endswith(".base")]


def telling(rows: list[Row]) -> Row | None:
    """The worst of the checked rows, which are in the order of `Verdict.table`."""
    return next((row for row in rows if row.checked), None)


def _assessed(model: Model, forces: dict[str, Forces], plan: Plan, g: int) -> NDArray[np.float64]:
    """Highest utilisation of every tube of a group under the forces of a model."""
    most = np.zeros(len(plan.sized.area))
    for one in forces.values():
        for along, length, _ in _batches(model, one):
            assess(plan.sized, along, length, g, most)
    return most[plan.start[g] : plan.stop[g]]
