"""A mission as data and as text: pairs, envelope of members, drives and trains, each with the pair that governs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, quantity
from kinetruss.errors import one_line

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.results import Row
    from kinetruss.runs import MissionRun


MOST = 40
LONGEST = 200
"""Rows of a table, and characters of a finding."""

Record = dict[str, Any]


# A mission as a page: pairs, envelope of members, drives and trains, each with the pair that governs it.

SHOWN = 10
PAIRS = ("pair", "highest utilisation", "part", "rule", "time", "samples", "what to know")
WORST = ("part", "rule", "utilisation", "value", "limit", "time", "at", "governing pair")
EXTREMES = ("part", "what", "largest", "time", "at", "governing pair")
DRIVES = ("drive", "what", "largest", "time", "governing pair")
TRAINS = ("motor of", "what", "largest", "limit", "utilisation", "governing pair")
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
        "pairs": _plain(run.pairs),
        "envelope": [{name: getattr(row, name) for name in row.__slots__} for row in rows],
        "extremes": _plain(run.extremes),
        "drives": _plain(run.drives),
        "trains": [] if run.trains is None else _plain(run.trains),
        "findings": run.findings,
        "wall_time": run.wall_time,
        "provenance": dict(run.provenance),
    }
    clean: dict[str, Any] = _finite(found)
    return clean


def _plain(data: xr.Dataset) -> list[dict[str, Any]]:
    """One record an entry, without entries of which nothing is known."""
    frame = data.reset_coords(drop=True).to_dataframe().reset_index()
    records: list[dict[str, Any]] = frame.to_dict("records")
    return records if "value" not in data else [one for one in records if one["value"] == one["value"]]


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key): _finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(entry) for entry in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not np.isfinite(value):
        return None if np.isnan(value) else "Infinity" if value > 0 else "-Infinity"
    return value


def mission_text(run: MissionRun) -> str:
    """The page as text; the worst of everything."""
    parts = [mission_head(run)]
    for title, head, rows in mission_tables(run):
        more = f"\nand {len(rows) - SHOWN} more" if len(rows) > SHOWN else ""
        parts.append(f"{title}\n{Table(head, rows[:SHOWN]).text}{more}")
    return "\n\n".join(parts)


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


def mission_tables(run: MissionRun) -> Iterator[tuple[str, tuple[str, ...], list[tuple[str, ...]]]]:
    """Title, columns and rows of every table that has rows, worst first."""
    rows = [] if run.verdict is None else [row for row in run.verdict.table() if row.checked]
    order = np.argsort(-np.nan_to_num(run.pairs["utilisation"].values, nan=-1.0, posinf=np.inf), kind="stable")
    tables = [
        ("Worst members (utilisation: 100 % is the limit)", WORST, [_worst(row) for row in rows if row.utilisation > 0]),
        ("Extremes of members", EXTREMES, list(_extreme_rows(run.extremes))),
        ("Drives", DRIVES, list(_drive_rows(run.drives))),
        ("Motors", TRAINS, [] if run.trains is None else list(_trains(run.trains))),
        ("Pairs", PAIRS, [_pair(run.pairs, int(k)) for k in order]),
    ]
    missing = {} if run.verdict is None else run.verdict.not_checked()
    tables.append(
        ("Not checked", ("rule, and what is missing", "parts"), [(what, _few(parts)) for what, parts in missing.items()])
    )
    yield from ((title, head, lines) for title, head, lines in tables if lines)


def _few(names: Sequence[str]) -> str:
    return ", ".join(names)


def _worst(row: Row) -> tuple[str, ...]:
    value, limit = quantity(row.value, row.unit), quantity(row.limit, row.unit)
    used = quantity(row.utilisation, "%")
    return row.part, row.rule, used, value, limit, instant(row.time), quantity(row.position, "m"), row.load_case


def _pair(pairs: xr.Dataset, k: int) -> tuple[str, ...]:
    one = {name: pairs[name].values[k] for name in pairs.data_vars}
    used = "-" if np.isnan(one["utilisation"]) else quantity(float(one["utilisation"]), "%")
    when = "-" if np.isnan(one["time"]) else instant(float(one["time"]))
    texts = [str(one[name]) for name in ("label", "part", "rule", "finding")]
    return texts[0], used, texts[1], texts[2], when, f"{one['samples']:.0f}", one_line(texts[3], 200)


def _extreme_rows(data: xr.Dataset) -> Iterator[tuple[str, ...]]:
    """Extremes that are reached, part by part."""
    units = data["unit"].values
    for i, part in enumerate(data["part"].values):
        for j, what in enumerate(data["quantity"].values):
            one = {name: data[name].values[i, j] for name in data.data_vars}
            if one["value"] > 0:
                place = quantity(float(one["position"]), "m")
                largest = quantity(float(one["value"]), str(units[j]))
                yield str(part), str(what), largest, instant(float(one["time_of"])), place, str(one["label"])


def _drive_rows(data: xr.Dataset) -> Iterator[tuple[str, ...]]:
    for i, drive in enumerate(data["drive"].values):
        for j, what in enumerate(map(str, data["quantity"].values)):
            one = {name: data[name].values[i, j] for name in data.data_vars}
            if one["value"] > 0:
                when = "-" if np.isnan(one["time_of"]) else instant(float(one["time_of"]))
                yield str(drive), what, quantity(float(one["value"]), str(one["unit"])), when, str(one["label"])


def _trains(data: xr.Dataset) -> Iterator[tuple[str, ...]]:
    for i, name in enumerate(data["active"].values):
        for j, what in enumerate(map(str, data["quantity"].values)):
            one = {key: data[key].values[i, j] for key in data.data_vars}
            if one["value"] > 0:
                unit = TRAIN_UNITS[what]
                limit = "-" if np.isnan(one["limit"]) else quantity(float(one["limit"]), unit)
                used = "-" if np.isnan(one["utilisation"]) else quantity(float(one["utilisation"]), "%")
                yield str(name), what, quantity(float(one["value"]), unit), limit, used, str(one["label"])
