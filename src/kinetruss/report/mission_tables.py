"""A mission as data and in tables: pairs, envelope of members, drives and motors, each with the pair that governs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Table, quantity
from kinetruss.display.ranks import largest_first
from kinetruss.display.tables import Column, measured, mixed, seconds, words
from kinetruss.errors import one_line
from kinetruss.report.run_data import entry, governing, plain
from kinetruss.report.tables import demand_columns, not_checked, rank_of, used_columns

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.report.entries import Entry
    from kinetruss.runs import MissionRun


MOST = 10, 40
LONGEST = 200
"""Rows of a table in a text and in a page, and characters of a finding."""

Record = dict[str, Any]
Rows = Sequence[Record]

TRAIN_UNITS = {
    "voltage": "V", "current": "A", "speed": "rad/s", "torque": "N m", "stroke": "m", "break-away": "N m", "input": "V",
    "rms current": "A", "rms torque": "N m", "holding torque": "N m", "electrical power": "W", "drawn energy": "J",
}  # fmt: skip


def mission_record(run: MissionRun) -> dict[str, Any]:
    """The page as plain data, SI; NaN becomes None, infinity the text ``Infinity``."""
    rows = [] if run.verdict is None else run.verdict.table()
    found: dict[str, Any] = {
        "schema": "kinetruss.mission/1",
        "run": run.name,
        "title": run.model.title,
        "out": None if run.path is None else str(run.path),
        "state": run.state,
        "status": run.status.name,
        "message": run.message,
        "whole": run.whole,
        "verdict": run.finding.record,
        "pairs_asked": run.samples,
        "pairs_done": run.good,
        "governing": run.governing,
        "pairs": _records(run.pairs),
        "envelope": [entry(row) for row in rows],
        "extremes": _records(run.extremes),
        "drives": _records(run.drives),
        "trains": [] if run.trains is None else _records(run.trains),
        "findings": run.findings,
        "wall_time": run.wall_time,
        "provenance": dict(run.provenance),
    }
    clean: dict[str, Any] = plain(found)
    return clean


def _records(data: xr.Dataset) -> list[Record]:
    """One record an entry, without entries of which nothing is known."""
    frame = data.reset_coords(drop=True).to_dataframe().reset_index()
    records: list[Record] = frame.to_dict("records")
    return records if "value" not in data else [one for one in records if one["value"] == one["value"]]


def lined(run: MissionRun, record: Record) -> Record:
    """What the lines of a result need: entries of members and drives, as in the record of a run."""
    trains = [
        {
            "part": one["active"],
            "rule": one["quantity"],
            "unit": TRAIN_UNITS[one["quantity"]],
            "value": one["value"],
            "limit": one["limit"],
            "utilisation": one["utilisation"],
            "time": one["time_of"],
            "load_case": one["label"],
            "pair": one["pair"],
        }
        for one in record["trains"]
    ]
    return {
        "whole": record["whole"],
        "samples": {"good": record["pairs_done"], "asked": record["pairs_asked"], "what": "pairs"},
        "strength": record["envelope"],
        "limits": trains,
        "not_checked": {} if run.verdict is None else run.verdict.not_checked(),
        "checks": {"not_held": [] if run.verdict is None else list(run.verdict.data.attrs.get("not_held", []))},
        "largest_forces": [],
        "drive_loads": [],
    }


def mission_entries(run: MissionRun) -> Iterator[Entry]:
    """The page in the terminal: the worst of everything."""
    record = mission_record(run)
    yield mission_head(run)
    for tables in mission_tables(run, record, lined(run, record)["limits"], run.findings).values():
        yield from tables
    yield not_checked(() if run.verdict is None else run.verdict.not_checked().items())


def mission_head(run: MissionRun) -> str:
    """Title, state, number of pairs and governing pair, a line each."""
    state = {
        "finished": "Completed.",
        "running": "Still running: these are the pairs so far.",
        "incomplete": f"Incomplete: it was interrupted. Continue with: kinetruss run --resume {run.path}",
    }[run.state]
    lines = [one_line(run.model.title, 200) or "(no title)", f"mission {run.name}: {state}"]
    lines.append(f"verdict: {run.finding.sentence}")
    lines += [f"warning: {one}" for one in run.finding.doubts]
    if run.message:
        lines.append(run.message)
    lines.append(
        f"{run.good} of {run.samples} pairs of a motion, a condition and a load case; {quantity(run.wall_time, 's', 3)}"
    )
    if run.governing is not None:
        lines.append(f"governing pair: {run.pairs['label'].values[run.governing]}")
    return "\n".join(lines)


def mission_tables(run: MissionRun, record: Record, limits: Rows, findings: Mapping[str, str]) -> dict[str, list[Table]]:
    """The tables of members, extremes, drives, motors and pairs, worst first.

    limits : the entries of the motors (`lined`). findings : what to know of pairs, by their labels.
    """
    of = run.extremes
    units = dict(zip(map(str, of["quantity"].values), map(str, of["unit"].values), strict=True)) if "unit" in of else {}
    extremes = [one | {"unit": units[one["quantity"]]} for one in record["extremes"]]
    held = largest_first((one for one in limits if one["utilisation"] is not None), lambda one: rank_of(one["utilisation"]))
    free = [one for one in limits if one["utilisation"] is None]
    pairs = largest_first(
        (one | {"finding": one_line(findings.get(one["label"], ""), LONGEST)} for one in record["pairs"]),
        lambda one: rank_of(one["utilisation"]),
    )
    station = measured("station", "position", "m")
    return {
        "members": [_limits("part", governing(record["envelope"]), "Worst members, each by its governing rule", station)],
        "extremes": [_largest("part", "quantity", extremes, "Extremes of members", station)],
        "drives": [_largest("drive", "quantity", record["drives"], "Demands on the drives")],
        "motors": [
            _limits("motor of", held, "Demands on the motors against their limits, worst first"),
            _largest("motor of", "rule", free, "Demands on the motors without a limit"),
        ],
        "pairs": [
            Table(
                [
                    words("pair", "label"),
                    measured("utilisation", unit="%"),
                    words("part"),
                    words("rule"),
                    seconds("time"),
                    measured("samples"),
                    words("what to know", "finding"),
                ],
                pairs,
                "Pairs, by their highest utilisation of a member",
                most=MOST,
            )
        ],
    }


def _limits(what: str, rows: Rows, caption: str, *more: Column) -> Table:
    columns = [
        words(what, "part"),
        words("rule"),
        *used_columns(rows),
        *demand_columns(),
        seconds("time"),
        *more,
        words("governing pair", "load_case"),
    ]
    return Table(columns, rows, f"{caption} (utilisation: 100 % is the limit)", most=MOST)


def _largest(what: str, of: str, rows: Rows, caption: str, *more: Column) -> Table:
    """The largest values of each quantity; of many rows the largest of every quantity."""
    found: dict[str, list[Record]] = {}
    for row in largest_first(rows, lambda row: rank_of(row["value"])):
        if rank_of(row["value"]) > 0:
            found.setdefault(row[of], []).append(row)
    order = [row | {"place": -place} for name in sorted(found) for place, row in enumerate(found[name])]
    part, time, pair = ("part", "time", "load_case") if of == "rule" else (what, "time_of", "label")
    columns = [words(what, part), words("what", of), mixed("largest", "value"), seconds("time", time), *more]
    caption = f"{caption}, the largest of each quantity"
    return Table([*columns, words("governing pair", pair)], order, caption, most=MOST, rank=lambda row: row["place"])
