"""Drives with a `Compliance` in small motions: a spring in series, between the commanded length and that of the member."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from kinetruss.dynamics.linear.state import State
from kinetruss.errors import InputError
from kinetruss.kernels.structure.plan import LENGTH
from kinetruss.mechanics import ELASTIC, ENGINEERING, ends_of
from kinetruss.mechanics.freedom import chosen_dofs
from kinetruss.model import Active, nearest

__all__ = ["compliant"]


def compliant(state: State, dofs: str | Iterable[str] | None, free: str | Iterable[str], rigid: str | Iterable[str]) -> State:
    """The state with springs in place of the rows of held drives that have a compliance, except those named in `rigid`.

    A drive with flexibility f (m/N) is N = (l - l0)/f, with the commanded length l0 that gives the N of the state.

    Raises
    ------
    InputError : a name in `rigid` that is no drive with a compliance.
    """
    system = state.balance.system
    soft = [name for name, one in system.model.members.items() if isinstance(one, Active) and one.compliance is not None]
    stiff = [rigid] if isinstance(rigid, str) else list(rigid)
    if unknown := [name for name in stiff if name not in soft]:
        raise InputError(f"{unknown[0]!r} in rigid is no active member with a compliance. {nearest(unknown[0], soft)}".rstrip())
    if not soft:
        return state
    gone = {*stiff, *([free] if isinstance(free, str) else free), *(() if dofs is None else chosen_dofs(system, dofs)[1])}
    held = np.flatnonzero((system.row_kind == LENGTH) & (system.row_drive >= 0))
    names = [(system.members[system.row_member[r]], system.drives[system.row_drive[r]]) for r in held]
    rows = held[[member in soft and drive not in gone for member, drive in names]]
    i = system.row_member[rows]
    length = ends_of(system, state.x)[1][i]
    f = np.nan_to_num(system.compliance[i]) * length + system.yielding[i]
    kind, law, spring, natural = (one.copy() for one in (system.kind, system.law, system.spring, system.natural))
    # N = (l - l0)/f with l0 = l - N f
    kind[i], law[i], spring[i], natural[i] = ELASTIC, ENGINEERING, 1 / f, length - state.N[rows] * f
    rest = np.setdiff1d(np.arange(len(system.row_kind)), rows)
    changed = system.with_rows(rest, kind=kind, law=law, spring=spring, natural=natural)
    return replace(
        state,
        balance=replace(state.balance, system=changed),
        N=state.N[rest],
        springs={int(member): float(1 / one) for member, one in zip(i, f, strict=True)},
    )
