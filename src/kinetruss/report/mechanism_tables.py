"""The tables of what a mechanism does: paths, angles of members, transmission, quantities of the model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kinetruss.display import Table, instant, quantity
from kinetruss.display.tables import MOST, Column, measured, mixed, seconds, together, words
from kinetruss.report.tables import case_column
from kinetruss.results.wide_tables import NOT_CHECKED

Record = dict[str, Any]
Rows = Sequence[Record]


def quantities(rows: Rows, *, timed: bool = True) -> Table:
    """The quantities that the model defines."""
    moving = timed and any(row["largest_time"] for row in rows)
    poses = any(row["largest_pose"] for row in rows)

    def at(end: str) -> Column:
        return words("in pose", f"{end}_pose") if poses else seconds("at", f"{end}_time")

    columns = [
        words("quantity"),
        words("what", "words"),
        *([mixed("start", "start", group="values")] if moving and not poses else []),
        mixed("least" if moving else "value", "least", group="values"),
        *([at("least")] if moving else []),
        *([mixed("largest", "largest", group="values"), at("largest")] if moving else []),
        *([mixed("largest rate", "rate", "rate_unit")] if moving else []),
        words("limits", _limits),
        words("status", lambda row: {"exceeded": "beyond", "": ""}.get(row["status"], row["status"])),
        words("not known", lambda row: f"{row['unknown']} samples" if row["unknown"] else ""),
        case_column(),
    ]
    caption = "Quantities of the model" + (f", extremes of the {'poses' if poses else 'samples'}" if moving else "")
    return Table(columns, rows, caption, most=MOST)


def deflections(rows: Rows) -> Table:
    """The deflections to which the model gives limits."""
    columns = [
        words("deflection", lambda row: str(row["part"]).removeprefix("deflection ")),
        measured("largest", "value", "m"),
        words("limit", lambda row: "" if row["rule"] == "limit" else row["rule"]),
        measured("allowed", "limit", "m"),
        measured("utilisation", unit="%"),
        words("in", "member"),
        measured("from the first end", "position", "m"),
        words("status", lambda row: {"exceeded": "beyond"}.get(row["status"], row["status"])),
        words("note", lambda row: row["note"].removeprefix(NOT_CHECKED)),
        case_column(),
    ]
    return Table(columns, rows, "Deflections", most=MOST)


def _limits(row: Record) -> str:
    if row["limits"] is None:
        return ""
    low, high = (None if one is None else str(quantity(one, row["unit"])) for one in row["limits"])
    return f"{low} to {high}" if low and high else f"up to {high}" if high else f"from {low}"


def paths(rows: Rows, dim: int) -> Table:
    """Where nodes go."""
    box = {
        f"{axis} {end}": (key, k) for k, axis in enumerate("xyz"[:dim]) for end, key in (("from", "least"), ("to", "largest"))
    }
    columns = [
        words("node"),
        *together("m", {**box, "path": "path"}),
        measured("speed", unit="m/s"),
        seconds("at", "speed_time"),
        measured("acceleration", unit="m/s²"),
        seconds("at", "acceleration_time"),
    ]
    return Table(columns, rows, "Nodes that move: extent, length of the path, largest speed and acceleration", most=MOST)


def turned(rows: Rows, dim: int) -> Table:
    """How members turn."""
    ratios = [one for row in rows for one in [row.get("ratio")] if one]
    units = {row.get("ratio_unit", "") for row in rows if row.get("ratio")}
    columns = [
        words("member"),
        *(
            together("rad", {"from": "least", "to": "largest", "sweep": "sweep"})
            if dim == 2
            else [measured("sweep", unit="rad")]
        ),
        measured("rate", unit="rad/s"),
        seconds("at", "rate_time"),
        measured("acceleration", unit="rad/s²"),
        seconds("at", "acceleration_time"),
        *(
            [
                measured("ratio from", lambda row: _ratio(row, 0), units.copy().pop()),
                measured("to", lambda row: _ratio(row, 1), units.copy().pop()),
                words("dead points", lambda row: dead(row.get("dead"))),
            ]
            if ratios
            else []
        ),
    ]
    drive = next((row["drive"] for row in rows if row.get("drive")), "")
    foot = (
        f"Ratio: angular velocity of the member over the rate of {drive}. Dead points: it stands while {drive} moves."
        if drive
        else ""
    )
    what = "Members that turn: angle, largest angular velocity and acceleration" if dim == 2 else (
        "Members that turn: angle from the direction at the start, largest angular velocity and acceleration"
    )  # fmt: skip
    return Table(columns, rows, what, foot if not drive else "", foot=foot, most=MOST)


def _ratio(row: Record, k: int) -> float | None:
    return row["ratio"][k] if row.get("ratio") else None


def dead(times: Sequence[float] | None) -> str:
    """Times of dead points, the first few."""
    if not times:
        return ""
    return ", ".join(instant(one) for one in times[:3]) + (f" and {len(times) - 3} more" if len(times) > 3 else "")


def transmission(rows: Rows) -> Table:
    """Transmission angles."""
    columns = [
        words("at", "node"),
        words("of", "member"),
        words("and", "with"),
        *together("rad", {"least": "least", "largest": "largest"}),
        seconds("least at", "time"),
    ]
    foot = "90 degrees transmit best; near 0 the output jams."
    return Table(columns, rows, "Transmission angles", foot=foot, most=MOST)


def entries(record: Mapping[str, Any], dim: int) -> list[Table]:
    """Where nodes go, how members turn, how well they transmit."""
    found = (paths(record["paths"], dim), turned(record["turns"], dim), transmission(record["transmission"]))
    return [one for one in found if one]


def of_node(row: Record) -> Table:
    """What one node does, as pairs."""
    axes = "xyz"[: len(row["least"])]
    spans = (
        f"{axis} from {quantity(low, 'm')} to {quantity(high, 'm')}"
        for axis, low, high in zip(axes, row["least"], row["largest"], strict=True)
    )

    def point(values: Sequence[float]) -> str:
        return f"({', '.join(str(quantity(one, 'm')) for one in values)})"

    rows = [
        ("start and end", f"{point(row['start'])} to {point(row['end'])}"),
        ("extent", "; ".join(spans)),
        ("length of the path", str(quantity(row["path"], "m"))),
        ("largest speed", f"{quantity(row['speed'], 'm/s')} at {instant(row['speed_time'])}"),
        ("largest acceleration", f"{quantity(row['acceleration'], 'm/s^2')} at {instant(row['acceleration_time'])}"),
    ]
    return Table(("", ""), rows, f"Node {row['node']}")


def of_member(row: Record, angles: Rows, dim: int) -> Table:
    """What one member does, as pairs; angles : its transmission angles."""
    span = f"{quantity(row['least'], 'rad')} to {quantity(row['largest'], 'rad')}"
    rows = [
        (
            "angle",
            f"{span}, from +x" if dim == 2 else f"up to {quantity(row['largest'], 'rad')} from the direction at the start",
        ),
        ("sweep", str(quantity(row["sweep"], "rad"))),
        ("largest angular velocity", f"{quantity(row['rate'], 'rad/s')} at {instant(row['rate_time'])}"),
        ("largest angular acceleration", f"{quantity(row['acceleration'], 'rad/s^2')} at {instant(row['acceleration_time'])}"),
    ]
    if row["length"]:
        rows.append(("length", f"{quantity(row['length'][0], 'm')} to {quantity(row['length'][1], 'm')}"))
    if row.get("ratio"):
        unit = row["ratio_unit"]
        low, high = (quantity(one, unit) for one in row["ratio"])
        rows.append((f"rate over that of {row['drive']}", f"{low} to {high}"))
        gain = quantity(abs(row["advantage"]), row["advantage_unit"])
        words_ = f"{gain} in magnitude at the least, at {instant(row['advantage_time'])}" + (
            "; without bound at dead points" if row["dead"] else ""
        )
        rows.append(
            ("mechanical advantage", f"torque on it over that of {row['drive']}: {words_} (without friction, weight, inertia)")
        )
        rows.append(("dead points", f"it stands while {row['drive']} moves: {dead(row['dead'])}" if row["dead"] else "none"))
    rows += [
        (
            f"transmission angle at {one['node']}",
            f"{quantity(one['least'], 'rad')} to {quantity(one['largest'], 'rad')} with {one['with']}, "
            f"least at {instant(one['time'])}",
        )
        for one in angles
    ]
    return Table(("", ""), rows, f"Member {row['member']}")
