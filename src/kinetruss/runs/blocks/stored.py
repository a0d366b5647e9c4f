"""Reads the blocks of a stored run, from which results known only at the end (the worst entries) are recomputed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from kinetruss.results import Status
from kinetruss.runs._result import RunResult
from kinetruss.runs.blocks.block import Block, judged
from kinetruss.runs.blocks.planned import Plan

__all__ = ["stored_blocks"]


def stored_blocks(plan: Plan, run: RunResult) -> Iterator[Block]:
    """The committed blocks of a run, one at a time."""
    for first in range(0, run.good, plan.block):
        part = slice(first, min(first + plan.block, run.good))
        motion = _cut(run.motion, part)
        forces = {
            case: _cut(one, part).with_(motion=motion, static=None if one.static is None else _cut(one.static, part))
            for case, one in run.forces.items()
        }
        yield judged(plan, motion, forces)


def _cut(result: Any, part: slice) -> Any:
    # the interruption after the blocks is not a status of the blocks
    return result.with_(data=result.data.isel(time=part).load(), status=Status.COMPLETED, message="")
