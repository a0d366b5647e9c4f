"""What one node or member does along a motion, and what the whole mechanism does, as pages."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from kinetruss.report import mechanism_tables as shown
from kinetruss.report.mechanism_data import mechanism_record, member_turns, node_paths, quantity_rows, transmission_angles
from kinetruss.report.page import Page
from kinetruss.report.run_data import plain
from kinetruss.runs.mission_results import check_histories

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult


def motion(run: RunResult, nodes: Sequence[str] = (), members: Sequence[str] = ()) -> Page:
    """What a mechanism does: paths, speeds and accelerations of nodes; angles, sweeps and angular velocities of members, with
    ratios, mechanical advantage and dead points of mechanisms that one drive moves; transmission angles; the quantities of the
    model.

    nodes, members : only these, in more detail; by default all that move.

    Raises
    ------
    InputError : unknown names; a run without a motion over time, if names are given; a mission.

    Examples
    --------
    >>> import kinetruss as kt
    >>> run = kt.run(kt.read(kt.library.example_files()["wiper"][0]))
    >>> print(kt.report.motion(run, members=["arm1"]).text.partition("largest")[0].rstrip())
    Member arm1
    angle                         92.08 deg to 181.4 deg, from +x
    sweep                         89.32 deg
    """
    check_histories(run)
    chosen: dict[str, Any] = {"nodes": tuple(nodes), "members": tuple(members)}
    return Page(found=run, as_record=partial(_record, **chosen), as_entries=partial(_entries, **chosen))


def _record(run: RunResult, nodes: Sequence[str], members: Sequence[str]) -> dict[str, Any]:
    if not nodes and not members:
        whole = mechanism_record(run) | {"quantities": quantity_rows(run)}
    else:
        whole = {
            "nodes": node_paths(run, nodes) if nodes else [],
            "members": member_turns(run, members) if members else [],
            "transmission": [one for one in transmission_angles(run) if one["member"] in members],
        }
    found: dict[str, Any] = plain(whole, None)
    return found


def _entries(run: RunResult, nodes: Sequence[str], members: Sequence[str]) -> Iterator[Entry]:
    dim = run.model.dim
    if not nodes and not members:
        rows = shown.entries(mechanism_record(run), dim)
        yield from rows
        yield shown.quantities(quantity_rows(run), timed=run.timed)
        if not rows:
            yield "The run has no motion over time, so there are no paths and no sweeps."
        return
    for row in node_paths(run, nodes) if nodes else ():
        yield shown.of_node(row)
    angles = transmission_angles(run) if members else []
    for row in member_turns(run, members) if members else ():
        own = [one for one in angles if row["member"] in (one["member"], one["with"])]
        yield shown.of_member(row, own, dim)
