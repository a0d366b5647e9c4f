"""Sizing: the lightest tubes and the smallest drives for a mission."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from kinetruss import actuators, strength
from kinetruss.design.choices import Plan, SizedGroup, make_plan
from kinetruss.design.drive_choice import choose_drives, make_shelves
from kinetruss.design.proof import Smaller, force_difference, proven
from kinetruss.design.sizing_result import DriveRow, GroupRow, Sizing
from kinetruss.design.tube_choice import Loading, Selection, forces_of, loadings, select
from kinetruss.errors import AnalysisError, ModelError, few
from kinetruss.io import read_mission
from kinetruss.mechanics import compile
from kinetruss.model import Active, Mission, Model, mission_faults
from kinetruss.results import Row, Verdict, provenance
from kinetruss.strength.verdict import highest


def size(model: Model, mission: Mission | str | Path) -> Sizing:
    """The lightest tube for every member group, then the smallest motor, screw and gear for every drive group.

    Motions are found once; masses are fed back into the forces until no group changes any more. A tube is sufficient if yield,
    buckling and beam-column (all rules of `strength.check`) hold with the safety factors at every sample of every run under
    every load case.

    Parameters
    ----------
    model : the structure, with runs; sections of the sized members may be missing. The masses of sized members follow from
        their tubes and replace given ones.
    mission : a Mission, or the path of a mission file.

    Returns
    -------
    Sizing. Proven by `strength.check` on the finished model (every utilisation is at most 1) and on a model for every group
    with its tube one size smaller (which fails, or there is none).

    Raises
    ------
    ModelError : faults of mission and catalogues, all of one kind at once.
    AnalysisError : no tube or drive of the catalogues is sufficient for a group (member, rule and utilisation are named); the
        sizing does not converge; a part outside all groups fails; a run whose path ends early.

    Limits
    ------
    The result is the lightest combination if forces grow with masses, as they do in trusses under their own weight and a
    payload. In any structure no single group can have the tube one size smaller. Local buckling of thin walls, joints and
    deflections are not checked. Bars that are `elastic` change the motion only through their loads, not their stiffness.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> sizing = kt.design.size(kt.read(model), mission)
    >>> [group.name for group in sizing.groups]
    ['lower_longerons', 'upper_longerons', 'battens', 'actuators']
    >>> sizing.mass_after < sizing.mass_before
    True
    """
    mission = mission if isinstance(mission, Mission) else read_mission(mission, model)
    if found := mission_faults(model, mission):
        raise ModelError(found)
    plan, shelves = make_plan(model, mission), make_shelves(model, mission)
    given = model.with_(safety=plan.safety)
    tasks = loadings(given, mission)
    before = strength.check(given, forces_of(given, tasks))
    chosen, smaller, notes = _tubes(given, mission, plan, tasks, before)
    sized = chosen.model
    drives: list[DriveRow] = []
    if not shelves.empty or (mission.self_locking and model.active):
        sized, drives = choose_drives(sized, mission, shelves, tasks, chosen.forces)
    # the finished model is compiled and computed again
    forces = forces_of(sized, tasks)
    settled = force_difference(forces, chosen.forces)
    if settled > mission.settle.tolerance:
        raise AnalysisError(f"The sizing has not converged: forces still differ by {settled:.2g} of the largest.")
    verdict = strength.check(sized, forces)
    rows, earlier = verdict.table(), before.table()
    groups = [_row(given, plan, chosen, g, earlier, rows, smaller[g]) for g in range(len(plan.groups))]
    return Sizing(
        model=sized,
        mission=mission,
        groups=tuple(groups),
        drives=tuple(drives),
        mass_before=_mass(given),
        mass_after=_mass(sized),
        iterations=chosen.passes,
        settled=settled,
        verdict=verdict,
        before=before,
        demand={one.name: actuators.evaluate(sized, one.motion, forces[one.name]) for one in tasks if sized.actuators},
        notes=(*_replaced(given, plan), *notes),
        provenance=provenance(sized, before=provenance(model)["model"]),
    )


def _tubes(
    model: Model, mission: Mission, plan: Plan, tasks: list[Loading], before: Verdict
) -> tuple[Selection, list[Smaller | None], list[str]]:
    if not plan.groups:  # only drives are sized
        forces = forces_of(model, tasks)
        none = np.zeros(0, np.int64)
        return Selection(choice=none, model=model, forces=forces, verdict=before, rejected={}, passes=0), [], []
    return proven(model, plan, tasks, select(model, plan, tasks, mission.settle.passes))


def _mass(model: Model, members: tuple[str, ...] | None = None) -> float:
    """Mass of all members, or of the bars and tubes (not the base rods) of some, kg."""
    system = compile(model)
    rods = system.rods
    if members is None:
        return float(rods[:, 0].sum() + rods[:, 3].sum() + system.body[:, 0].sum())
    index = {name: k for k, name in enumerate(model.whole.members)}
    return float(sum(rods[index[name], 3 if name in model.active else 0] for name in members))


def _row(
    model: Model, plan: Plan, chosen: Selection, g: int, before: list[Row], after: list[Row], smaller: Smaller | None
) -> GroupRow:
    group = plan.groups[g]
    worst = next(row for row in after if row.checked and row.member in group.members and not row.part.endswith(".base"))
    earlier = highest(row for row in before if row.member in group.members)
    return GroupRow(
        name=group.name,
        members=group.members,
        tube_before=_tube_before(model, group),
        tube=group.tube_name(int(chosen.choice[g])),
        mass_before=_mass(model, group.members),
        mass=_mass(chosen.model, group.members),
        utilisation_before=earlier,
        utilisation=worst.utilisation,
        part=worst.part,
        rule=worst.rule,
        time=worst.time,
        load_case=worst.load_case,
        smaller=group.tube_name(smaller.index) if smaller else "",
        smaller_utilisation=smaller.row.utilisation if smaller else math.nan,
        smaller_part=smaller.row.part if smaller else "",
        smaller_rule=smaller.row.rule if smaller else "",
    )


def _tube_before(model: Model, group: SizedGroup) -> str:
    """The sections of a group as they were, by name or size."""
    found = []
    for name in group.members:
        member = model.whole.members[name]
        section = model.section_of(member.tube if isinstance(member, Active) else member)
        if section is None:
            found.append("-")
        elif section.kind == "tube":
            found.append(f"{1e3 * section.outer:.4g}x{1e3 * (section.outer - section.inner) / 2:.3g} mm")
        else:
            found.append(section.kind)
    return ", ".join(dict.fromkeys(found))


def _replaced(model: Model, plan: Plan) -> list[str]:
    """Masses given in numbers, which the masses of the tubes replace."""
    given = []
    for name in plan.group_of:
        member = model.whole.members[name]
        if (member.tube if isinstance(member, Active) else member).mass is not None:
            given.append(name)
    if not given:
        return []
    return [f"Masses given in the model were replaced by those of the tubes: {few(given, 6)}. Lump fittings at nodes."]
