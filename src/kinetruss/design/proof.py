"""Proof of a sizing: every tube is strong enough, no tube one size smaller is, and the masses have converged."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from kinetruss import strength
from kinetruss.design.choices import Plan, with_tubes
from kinetruss.design.tube_choice import Loading, Selection, forces_of, scanned, telling
from kinetruss.model import Model
from kinetruss.results import Forces, Row, Verdict

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, kw_only=True)
class Smaller:
    """The tube one size smaller: its index and the worst row of the model with it; None if there is none."""

    index: int
    row: Row


def proven(
    model: Model, plan: Plan, loadings: list[Loading], selection: Selection
) -> tuple[Selection, list[Smaller | None], list[str]]:
    """The selection, with lighter tubes if they are strong enough, and for every group why one size smaller is not.

    Every smaller tube is tried in a model of its own, with its own mass, by `strength.check` itself: first at the instants
    that govern the group; if it passes, over everything. If it passes that too, it is chosen and the search continues.
    """
    notes: list[str] = []
    while True:
        found: list[Smaller | None] = []
        for g in range(len(plan.groups)):
            lighter, smaller = _tried(model, plan, loadings, selection, g)
            if lighter is not None:
                group = plan.groups[g]
                notes.append(
                    f"{group.name}: {group.tube_name(lighter)} carries after all; heavier tubes elsewhere had been against it."
                )
                selection = _lightened(model, plan, loadings, selection, g, lighter)
                break
            found.append(smaller)
        else:
            return selection, found, notes


def force_difference(forces: dict[str, Forces], others: dict[str, Forces]) -> float:
    """Largest difference of any member force, over the largest force of its loading."""
    worst = 0.0
    for name, one in forces.items():
        a, b = one.arrays["member_force"].values, others[name].arrays["member_force"].values
        size = float(np.abs(a).max(initial=0.0))
        worst = max(worst, float(np.abs(a - b).max(initial=0.0)) / size if size > 0 else 0.0)
    return worst


def _lightened(model: Model, plan: Plan, loadings: list[Loading], selection: Selection, g: int, index: int) -> Selection:
    """The selection with a lighter tube for one group, which has passed the check. Masses decrease, so the search ends."""
    choice = selection.choice.copy()
    choice[g] = index
    sized = with_tubes(model, plan, choice)
    forces = forces_of(sized, loadings)
    return Selection(
        choice=choice,
        model=sized,
        forces=forces,
        verdict=strength.check(sized, forces),
        rejected=selection.rejected,
        passes=selection.passes + 1,
    )


def _tried(
    model: Model, plan: Plan, loadings: list[Loading], selection: Selection, g: int
) -> tuple[int | None, Smaller | None]:
    """A lighter tube of a group that is strong enough, or None; and the failed check of the next smaller one."""
    chosen, first = int(selection.choice[g]), plan.groups[g].first
    if chosen == first:
        return None, None
    some = _governing(plan, loadings, selection, g)
    against = _fails(model, plan, loadings, some, selection.choice, g, chosen - 1)
    for index in range(_lightest(plan, selection, some, g), chosen - 1):
        if _fails(model, plan, loadings, some, selection.choice, g, index) is None:
            return index, None
    if against is None:
        return chosen - 1, None
    return None, Smaller(index=chosen - 1, row=against)


def _governing(plan: Plan, loadings: list[Loading], selection: Selection, g: int) -> list[Loading]:
    """The loadings at the instants that govern the members of a group, or at which the smaller tube was rejected."""
    verdict = cast("Verdict", selection.verdict)  # there is one: it is the last pass
    members, data = set(plan.groups[g].members), verdict.data
    wanted: dict[str, set[int]] = {}
    times = {one.name: one.motion.arrays["time"].values for one in loadings}
    for part in np.flatnonzero(np.isin(data["member"].values, list(members))):
        for rule in range(data.sizes["rule"]):
            case, at = str(data["load_case"].values[part, rule]), float(data["time_of"].values[part, rule])
            if case in times and at == at:
                wanted.setdefault(case, set()).add(int(np.argmin(np.abs(times[case] - at))))
    name, sample = selection.rejected.get(int(selection.choice[g]) - 1, ("", -1))
    if sample >= 0:
        wanted.setdefault(name, set()).add(sample)
    return [one.at(wanted[one.name]) for one in loadings if one.name in wanted]


def _fails(
    model: Model, plan: Plan, loadings: list[Loading], some: list[Loading], choice: NDArray[np.int64], g: int, index: int
) -> Row | None:
    """The worst row of the model with another tube for one group, None if all checks pass."""
    tried = choice.copy()
    tried[g] = index
    sized = with_tubes(model, plan, tried)
    for chosen in (some, loadings):
        if chosen:
            worst = telling(strength.check(sized, forces_of(sized, chosen)).table())
            if worst is not None and worst.utilisation > 1:
                return worst
    return None


def _lightest(plan: Plan, selection: Selection, some: list[Loading], g: int) -> int:
    """The lightest tube of a group that is strong enough for the forces of the chosen model at some instants."""
    pointer = selection.choice.copy()
    pointer[g] = plan.start[g]
    forces = forces_of(selection.model, some)
    return int(scanned(selection.model, forces, plan, pointer, {})[g])
