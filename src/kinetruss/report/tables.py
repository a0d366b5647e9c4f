"""The tables of a run, each once, for the summary in the terminal and for the report; rows are those of `run_data`."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from kinetruss.display import Table, margin, moment, number, quantity
from kinetruss.display.ranks import largest_first
from kinetruss.display.tables import MOST, Column, Of, bar, drawn, measured, mixed, seconds, span_bar, together, words
from kinetruss.model.data import FORCE_ELEMENTS
from kinetruss.results.wide_tables import exceeds

Record = dict[str, Any]
Rows = Sequence[Record]

BEYOND = 1.5
ROUND_OFF = 1e-9
"""Utilisation below which it counts as zero; excess over a limit, and margin, that count as none."""


# Cells.


def named(case: str) -> str:
    """A load case as text."""
    return "all loads" if case == "all" else case


def cased(case: str) -> str:
    """A load case within a sentence."""
    return "all loads" if case == "all" else f"load case {case}"


def is_single(record: Mapping[str, Any]) -> bool:
    """True for results of one position: they have no times."""
    return bool(record["samples"]["good"] == 1 and "what" not in record["samples"])


def value_of(value: Any) -> float:
    """A number from a record: NaN for None, infinity for its text."""
    return math.nan if value is None else float(value)


def rank_of(value: Any) -> float:
    """A number by which rows are sorted: what is not known is last."""
    return -1.0 if value is None or math.isnan(float(value)) else float(value)


def share_of(value: Any) -> str:
    """A utilisation as text."""
    share = value_of(value)
    return quantity(0.0 if abs(share) < ROUND_OFF else share, "%")


def used_of(value: Any) -> str:
    """A utilisation within a sentence."""
    return f"{share_of(value)} of what is allowed"


def margin_of(row: Record) -> str:
    """A margin as text, if there is a demand."""
    used = value_of(row["utilisation"])
    if used < ROUND_OFF or math.isinf(used):
        return "-"
    left = value_of(row["margin"])
    return margin(0.0 if abs(left) < ROUND_OFF else left)


def is_over(row: Record) -> bool:
    """True if a limit is exceeded by more than round-off."""
    return exceeds(value_of(row["utilisation"]))


# Columns.


def case_column(head: str = "load case") -> Column:
    """The load case of each row; nothing if all rows have all loads."""
    return words(head, lambda row: named(row["load_case"]), idle="all loads")


def used_columns(rows: Iterable[Record]) -> list[Column]:
    """Utilisations as bars on one scale, up to the limit, or 1.5 times the limit if one exceeds it; and in percent."""
    most = BEYOND if any(value_of(row["utilisation"]) > 1 for row in rows) else 1.0
    return [drawn(lambda row: bar(value_of(row["utilisation"]), most)), measured("utilisation", unit="%")]


def demand_columns() -> list[Column]:
    """What is asked and what is allowed, each row in its own unit."""
    return [mixed(head, key, group="demand") for head, key in (("demand", "value"), ("allowed", "limit"))]


def when(rows: Iterable[Record], *, timed: bool = True) -> list[Column]:
    """The poses of the rows, or their times; nothing for a single position."""
    if any(row.get("pose") for row in rows):
        return [words("pose")]
    return [seconds("time")] if timed else []


def numbered(heads: Mapping[str, str], poses: Sequence[str]) -> list[Column]:
    """Times, s, or the poses that they number: heads and keys."""
    if not poses:
        return [seconds(head, key, group="time") for head, key in heads.items()]
    said = {f"{head.removesuffix('at').removesuffix('time').strip()} in pose".strip(): key for head, key in heads.items()}
    return [words(head, lambda row, key=key: poses[round(row[key])]) for head, key in said.items()]


def marked(row: Record) -> str:
    """A member, with a mark if its force is not unique."""
    return str(row["member"]) + ("" if row["unique"] else " †")


UNSURE = "† Not unique: depends on stiffness or convention."


def unsure(rows: Iterable[Record]) -> str:
    """The note on members whose forces are not unique."""
    return "" if all(row["unique"] for row in rows) else UNSURE


# Forces of members and supports.


def largest_forces(rows: Rows, *, timed: bool = True) -> Table:
    """The members with the largest forces of all load cases."""
    columns = [words("member", marked), measured("force", unit="N"), measured("of it by motion", "by_motion", "N")]
    caption = "Largest member forces (tension positive)"
    return Table([*columns, *when(rows, timed=timed), case_column()], rows, caption, unsure(rows))


def envelope(case: str, rows: Rows, every: Rows, poses: Sequence[str]) -> Table:
    """The envelope of member forces of a load case. every : rows of all of them, which share their unit."""
    least, most = min(row["least"] for row in rows), max(row["largest"] for row in rows)
    ends = (min(least, 0.0), max(most, 0.0))
    columns = [
        words("member", marked),
        drawn(lambda row: span_bar(row["least"], row["largest"], *ends), "envelope"),
        *together("N", {"least": "least", "largest": "largest", "at rest": "at_rest"}),
        *numbered({"least at": "least_time", "largest at": "largest_time"}, poses),
    ]
    caption = f"Envelope of member forces, {cased(case)}: mean axial force, tension positive"
    foot = (
        "Bars run from the least to the largest force of the run: compression to the left of the line, tension to the right, "
        f"from {quantity(least, 'N')} to {quantity(most, 'N')}. At rest: in the pose of the larger one. {unsure(rows)}"
    )
    return Table(columns, rows, caption, foot=foot.strip(), most=MOST, among=every)


def still_forces(cases: Mapping[str, Rows]) -> Table:
    """The forces of one position: load cases beside each other, the largest member of any first."""
    by_case = {case: {row["member"]: row for row in rows} for case, rows in cases.items()}
    rows = [
        {"member": name, "unique": all(found[name]["unique"] for found in by_case.values())}
        | {case: found[name]["largest"] for case, found in by_case.items()}
        for name in next(iter(by_case.values()))
    ]
    for row in rows:
        row["worst"] = max((row[case] for case in cases), key=abs)
    rows = largest_first(rows, lambda row: abs(row["worst"]))
    ends = (min(0.0, *(row["worst"] for row in rows)), max(0.0, *(row["worst"] for row in rows)))
    single = len(cases) == 1
    columns = [
        words("member", marked),
        drawn(lambda row: span_bar(min(row["worst"], 0.0), max(row["worst"], 0.0), *ends), "" if single else "largest"),
        *together("N", {"force": next(iter(cases))} if single else {case: case for case in cases}),
    ]
    if single:
        columns.append(words("", lambda row: "tension" if row["worst"] > 0 else "compression" if row["worst"] < 0 else ""))
    of = cased(next(iter(cases))) if single else f"load cases {', '.join(cases)}"
    caption = f"Member forces, {of}: mean axial force, tension positive"
    return Table(columns, rows, caption, unsure(rows), most=MOST)


def reactions(rows: Rows, *, single: bool, poses: Sequence[str]) -> Table:
    """The supports: the largest force of each on the structure."""
    axes = list(rows[0]["force"]) if rows else []
    about = next((list(row["moment"]) for row in rows if "moment" in row), [])
    columns = [
        words("support"),
        case_column(),
        *together("N", {"largest": "magnitude"} | {axis: ("force", axis) for axis in axes}),
        *together("N m", {f"moment about {axis}": ("moment", axis) for axis in about}),
        *([] if single else numbered({"time": "time"}, poses)),
    ]
    moments = f", and the moment of a clamp{'' if single else ' at that instant'}" if about else ""
    return Table(columns, rows, f"Largest force of each support on the structure, with its components{moments}", most=MOST)


# Drives and springs.


def drives(rows: Rows, *, timed: bool = True) -> Table:
    """Drives that have no motor: forces and torques, rates, powers."""
    rows = [row | {"rate_unit": "rad/s" if row["unit"] == "N m" else "m/s"} for row in rows if row["load"]]
    posed = any(row["pose"] for row in rows)
    over_time = timed and not posed
    mean = [mixed("rms", "rms")] if over_time else []
    power = [measured("power", unit="W"), seconds("at", "power_time")] if over_time else []
    moving = [*mean, mixed("rate", "rate", "rate_unit"), *power] if over_time else []
    columns = [words("drive"), mixed("force or torque", "load"), *when(rows, timed=timed), *moving, case_column()]
    what = ", held" if posed or not timed else ""
    scope = " (largest values of the poses)" if posed else " (largest values of the motion)" if timed else ""
    return Table(columns, rows, f"Drives without a motor{what}{scope}", most=MOST)


def elements(kind: str, rows: Rows) -> Table:
    """Elements of a kind, of those on coordinates the largest forces first."""
    if kind not in FORCE_ELEMENTS:
        columns = [words(kind), words("what"), mixed("largest", "load"), seconds("time"), case_column()]
        return Table(columns, rows, f"{kind.capitalize()} (largest values of the motion)", most=MOST)
    units = {True: ("N m", "rad"), False: ("N", "m")}
    found = [row | dict(zip(("unit", "of"), units[row["angle"]], strict=True)) for row in rows if row["load"]]
    found = largest_first(found, lambda row: abs(row["load"]))
    columns = [
        words(kind),
        mixed("force or moment", "load"),
        mixed("at value", "value", "of"),
        seconds("time"),
        case_column(),
    ]
    return Table(columns, found, f"{kind.capitalize()}s (largest values of the motion)", most=MOST)


def spans(rows: Rows, unit: str) -> Table:
    """Range, rate and acceleration of the drives of lengths or of angles."""
    ends = {f"allowed {word}": ("travel", k) for k, word in enumerate(("from", "to"))}
    columns = [
        words("drive"),
        words("kind"),
        *together(unit, {"least": "least", "largest": "largest", **ends}),
        measured("largest rate", "rate", f"{unit}/s"),
        measured("largest acceleration", "acceleration", f"{unit}/s²"),
    ]
    what = "lengths" if unit == "m" else "angles"
    return Table(
        columns, [row for row in rows if row["unit"] == unit], f"Drives of {what}: range, rate, acceleration", most=MOST
    )


# Motors and drive trains.


def motors(rows: Rows) -> Table:
    """The largest demands on motors; of many those nearest to a limit."""
    found = []
    for row in rows:
        turning = not math.isnan(value_of(row["drive_torque"]))
        found.append(row | {"load": row["drive_torque" if turning else "thrust"], "unit": "N m" if turning else "N"})
    units = {row["unit"] for row in found}
    columns = [
        words("motor of", "active"),
        mixed("load" if len(units) != 1 else "thrust" if units == {"N"} else "torque on the angle", "load"),
        measured("speed", "motor_speed", "rad/s"),
        measured("torque", "motor_torque", "N m"),
        measured("current", unit="A"),
        measured("voltage", unit="V"),
        measured("power", "electrical_power", "W"),
        measured("energy drawn", "drawn_energy", "J"),
        words("nearest limit", _nearest, only="texts"),
        case_column(),
    ]
    caption = "Motors (largest values of the motion, with their signs)"
    return Table(columns, found, caption, most=MOST, rank=_near, rest=lambda _: ", farther from their limits")


def _nearest(row: Record) -> str:
    limit = row["nearest_limit"]
    return f"{limit['quantity']} {quantity(limit['utilisation'], '%')}" if limit else "-"


def _near(row: Record) -> tuple[float, float]:
    """How near a motor is to its limits, then its torque: strokes of equal cells are equal."""
    limit = row["nearest_limit"]
    return (round(value_of(limit["utilisation"]), 6) if limit else 0.0, abs(rank_of(row["motor_torque"])))


def trains(rows: Rows) -> list[Table]:
    """Torques at the motors; their energies, gears and leads."""
    torques = {
        "moving": "motor_torque",
        "without friction": "motor_torque_frictionless",
        "break-away": "breakaway_torque",
        "holding": "holding_torque",
        "rms": "rms_torque",
    }
    leads = {"lead": "lead", "self-locking up to": "largest_self_locking_lead"}
    tables = (
        ("Drive trains (largest torques at the motor)", together("N m", torques)),
        (
            "Drive trains: energies, gear and lead",
            [
                *together("J", {"energy drawn": "drawn_energy", "fed back": "returned_energy"}),
                measured("gear for top speed", "gear_ratio"),
                *(
                    measured(head, lambda row, key=key: None if row[key] is None else 1e3 * row[key], "mm/rad", group="lead")
                    for head, key in leads.items()
                ),
            ],
        ),
    )
    return [
        Table(
            [words("motor of", "active"), *columns, case_column()],
            rows,
            caption,
            most=MOST,
            rank=lambda row: rank_of(row["motor_torque"]),
            rest=lambda _: ", with less torque",
        )
        for caption, columns in tables
    ]


# Demand and capacity: strength of members, limits of drives.

SCALE = "Utilisation is demand over capacity, safety factors included; at 100 %, the mark, the limit is reached."


def strength(rows: Rows, note: str = "", *, timed: bool = True) -> Table:
    """The governing entry of each part. note : on entries without a finite value."""
    columns = [
        words("part"),
        words("rule"),
        *used_columns(rows),
        *demand_columns(),
        words("margin", margin_of),
        *when(rows, timed=timed),
        measured("station", "position", "m"),
        case_column(),
    ]
    foot = f"{SCALE} Station: distance from the member's first end."
    caption = "Worst members, each by its governing rule (utilisation: 100 % is the limit)"
    return Table(columns, rows, caption, note, foot=foot, most=(8, 1000))


def limits(rows: Rows, *, timed: bool = True) -> Table:
    """Demands on drives against their limits, worst first."""
    held = [row for row in rows if row["utilisation"] is not None]
    unlimited = sorted({row["rule"] for row in rows if row["utilisation"] is None})
    columns = [
        words("member", "part"),
        words("rule"),
        *used_columns(held),
        *demand_columns(),
        words("margin", margin_of),
        *when(held, timed=timed),
        case_column(),
    ]
    foot = f"No limit is given for: {', '.join(unlimited)}." if unlimited else ""
    return Table(columns, held, "Demands on the actuators against their limits, worst first", foot=foot, most=MOST)


def exceeded(rows: Rows) -> Table:
    """Every limit of a drive that is exceeded."""

    def rest(left: Rows) -> str:
        counts = Counter(row["quantity"] for row in left)
        return f": {', '.join(f'{what} {count}' for what, count in counts.items())}"

    columns = [words("limit exceeded", "sentence"), case_column()]
    return Table(columns, rows, "Limits of drives exceeded, worst first", most=MOST, rest=rest)


def not_checked(missing: Iterable[tuple[str, Sequence[str]]], caption: str = "Not checked") -> Table:
    """Rules that were not checked, and for which parts."""
    rows = [{"what": what, "count": str(len(parts)), "parts": ", ".join(parts)} for what, parts in missing]
    return Table([words("rule, and what is missing", "what"), words("count"), words("parts")], rows, caption)


def skins(rows: Rows, *, timed: bool = True) -> Table:
    """The highest stresses of membranes and solids, beside the yield strength of their materials."""
    columns = [
        words("part"),
        *together("Pa", {"highest stress": "von_mises", "yield strength": "yield_strength"}),
        *when(rows, timed=timed),
        case_column(),
        words("element (from 0), and its nodes", lambda row: f"{row['element']}: {', '.join(row['nodes'])}"),
    ]
    foot = "Not part of the checks: no safety factor is applied, and corners and supports concentrate stress."
    return Table(columns, rows, "Highest von Mises stress in membranes and solids", foot=foot, most=MOST)


def displacements(cases: Mapping[str, Record], dim: int, *, timed: bool, poses: Sequence[str]) -> Table:
    """The largest displacement of a node in each load case, with its components."""
    rows = [one["displacement"] | {"load_case": case, "energy": one.get("strain_energy")} for case, one in cases.items()]
    sides: dict[str, Of] = {f"along {axis}": ("vector", k) for k, axis in enumerate("xyz"[:dim])}
    columns = [
        case_column(),
        words("node"),
        *together("m", {"largest": "size", **sides}),
        *(numbered({"time": "time"}, poses) if timed else []),
        measured("strain energy", "energy", "J"),
    ]
    return Table(columns, rows, "Largest displacement of a node, with its components")


# Simulations, and checks that need no other program.

NOTHING = 1e-20
"""Kinetic energy (J), or fraction of the initial energy, that counts as zero."""
METHODS = {"taylor": "Taylor series"}
SOLVERS = {
    "dense": "equations of motion solved with a dense matrix",
    "sparse": "equations of motion solved with a sparse matrix",
    "sweep": "equations of motion solved along the chain",
}


def simulation(found: Record | None) -> list[Table]:
    """Method, steps and energy of a simulation; what its motors did; its events and singular positions."""
    if found is None:
        return []
    energy = found["energy"]
    rows = [
        ("method", f"{METHODS.get(found['method'], found['method'])}; {SOLVERS.get(found['solver'], found['solver'])}"),
        ("steps", f"{found['steps']}, {found['rejected']} rejected, {found['evaluations']} evaluations"),
        (
            "energy",
            f"{quantity(energy['start'], 'J')} at the start, {quantity(energy['end'], 'J')} at the end, largest change "
            f"{quantity(energy['largest_change'], 'J')}; {_change(energy)}",
        ),
    ]
    motors = [
        words("motor"),
        *(measured(head, unit=unit) for head, unit in (("current", "A"), ("voltage", "V"), ("torque", "N m"))),
        measured("turned", unit="rad"),
        *together("J", {"fed": "electrical_energy", "of it heat in the winding": "copper_energy"}),
        measured("samples at rest", lambda one: one["still"] or None, "%"),
    ]
    fed_back = [
        words("drive"),
        mixed("error", "error"),
        mixed("force or torque", "force", "force_unit"),
        measured("samples at its limit", lambda one: one["limited"] or None, "%"),
    ]
    events = [
        words("event", "name"),
        words("time", lambda one: f"{number(one['time'], 9)} s"),
        words("direction", lambda one: "rising" if one["direction"] > 0 else "falling"),
    ]
    passages = [
        words("time", lambda one: f"{number(one['time'], 6)} s"),
        words("smallest pivot", lambda one: number(one["pivot"], 3)),
        words("branch", lambda one: "certain" if one["certain"] else "not certain"),
    ]
    return [
        Table(("", ""), rows, "Simulation"),
        Table(motors, found["motors"], "Motors of the simulation: largest values with their signs, and totals", most=MOST),
        Table(fed_back, found.get("feedback", []), "Drives fed back: largest values with their signs", most=MOST),
        Table(events, found["events"], "Events", most=MOST),
        Table(passages, found["passages"], "Singular positions passed (pivot 0 is singular)", most=MOST),
    ]


def _change(energy: dict[str, float]) -> str:
    """Change of the energy: where nothing feeds it or takes from it the error, as a fraction of the largest kinetic energy if
    anything moves; else what does. (What damping takes is no error, and no fraction of the kinetic energy.)
    """
    change, kinetic = energy["largest_change"], energy["largest_kinetic"]
    if kinetic <= NOTHING * max(1.0, abs(energy["start"])):
        return f"nothing moves; changes by at most {quantity(change, 'J')}"
    sources = [
        *([f"drives and loads feed or take up to {quantity(energy['fed'], 'W')}"] if energy["fed"] else []),
        *([f"elements give up to {quantity(energy['given'], 'W')}"] if energy.get("given") else []),
        *([f"dampers and friction take up to {quantity(energy['dissipation'], 'W')}"] if energy["dissipation"] else []),
    ]
    if sources:
        return f"{'; '.join(sources)}; largest kinetic energy {quantity(kinetic, 'J')}"
    return f"changes by at most {number(change / kinetic, 2)} of the largest kinetic energy ({quantity(kinetic, 'J')})"


def checks(found: Record, closed: Record | None, poses: Sequence[str], *more: tuple[str, str, str], forces: bool) -> Table:
    """Checks, each with its result and what that means. forces : whether there are any. more : further rows."""
    rows = []
    balance, gauge = found["energy_balance"], found["singularity"]
    if balance is not None:
        miss, largest = quantity(balance["largest_miss"], "W"), quantity(balance["largest_power"], "W")
        whose = f", that of {balance['of']}" if balance["largest_power"] else ""
        said = f"power not accounted for is at most {miss}, largest power {largest}{whose}; 0 is exact"
        rows.append(("energy balance", f"{number(balance['relative'], 3)} of the largest power", said))
    if closed is not None:
        share = f"{number(closed['relative'], 2)} of its length"
        where = f"{closed['member']} at {moment(closed['time'], poses)}, {share}"
        said = f"largest departure of a bar from its length: {where}; 0 is exact"
        rows.append(("constraint error", quantity(closed["error"], "m"), said))
    if gauge is not None:
        said = f"smallest at {moment(gauge['time'], poses)}; 0 is singular, 1 is as far from it as can be"
        rows.append(("singularity margin", number(gauge["smallest"], 3), said))
    if forces:
        names = found["not_unique"]
        said = "in a redundant structure forces depend on stiffness or convention"
        rows.append(("unique forces", "all" if not names else f"all but {', '.join(names)}", said))
    if found["motors"]:
        rows.append(("motors", "checked", f"limits that only forces decide: {', '.join(found['motors'])}"))
    return Table(("check", "result", "meaning"), [*rows, *more], "What was checked, and the result")
