"""The parts of a report, one function per part; each returns nothing if the run has no such results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, counted, element, number, quantity
from kinetruss.report.document.checks import methods
from kinetruss.report.document.columns import Columns, span_bar
from kinetruss.report.document.demands import MOST, at, cased, is_single, left_out, named
from kinetruss.report.document.inputs import WORDS, sources
from kinetruss.report.run_lines import statics_lines, statics_record, statics_title
from kinetruss.report.run_tables import moment, poses_of

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

    Record = dict[str, Any]


BESIDE = 6
"""Number of load cases beside each other in a table."""
SOLVERS = {
    "dense": "equations of motion solved with a dense matrix",
    "sparse": "equations of motion solved with a sparse matrix",
    "sweep": "equations of motion solved along the chain",
}
UNSURE = "† Not unique: depends on stiffness or convention."


def mobility(record: Record) -> list[Markup]:
    """Mechanisms and states of self-stress of the model in its own pose, with and without elastic bars as rigid ones."""
    found = record["mobility"]
    if found is None:
        words = "The model has too many nodes for a rank decision in a report; use kinetruss info on the model file."
        return [element("p", words)]
    rows = list(_counts(found, "rigid bars"))
    held = found["elastic_as_rigid"]
    if held is not None:
        rows += [(f"elastic bars as rigid: {name}", words) for name, words in list(_counts(held, "bars"))[1:]]
    if found["elastic"]:
        words = "elastic members, beams, membranes and solids fix no length: their stiffness holds the mechanisms of rigid bars"
        rows.append(("meaning", words))
    else:
        rows += [(f"mechanism {k + 1}", text) for k, text in enumerate(found["mechanisms"][:8])]
    rows += [(f"self-stress {k + 1}", text) for k, text in enumerate((held or found)["self_stress_states"][:8])]
    return [Table(("", ""), rows, "Mobility of the model as it stands, decided by rank").html]


def _counts(found: Record, bars: str) -> Iterator[tuple[str, str]]:
    yield "coordinates", f"{found['coordinates']}, of them {found['fixed']} fixed"
    yield bars, f"{found['bars']}, of rank {found['rank']}"
    yield "degrees of freedom", f"{found['degrees_of_freedom']}; {counted(found['drives'], 'drive')}"
    yield (
        "with the drives held" if found["drives"] else "without drives",
        f"{counted(found['undriven'], 'mechanism')}, {counted(found['self_stress'], 'state')} of "
        f"self-stress (Calladine's count {found['maxwell']} = {found['undriven']} − {found['self_stress']})",
    )
    yield "smallest singular value", number(found["smallest_singular_value"], 3)


def motion(record: Record) -> list[Markup]:
    """Range, rate and acceleration of the drives, in one table for those of lengths and one for those of angles."""
    return [table for unit in ("m", "rad") if (table := _spans([one for one in record["drives"] if one["unit"] == unit], unit))]


def _spans(drives: Sequence[Record], unit: str) -> Markup | None:
    if not drives:
        return None
    shown = drives[:MOST]
    table = Columns().words("drive", [one["drive"] for one in shown]).words("kind", [one["kind"] for one in shown])
    ends = [[one["travel"] and one["travel"][k] for one in shown] for k in (0, 1)]
    spans = [[one[key] for one in shown] for key in ("least", "largest")]
    limited = any(one["travel"] for one in shown)
    names = ["least", "largest", *(["allowed from", "allowed to"] if limited else [])]
    table.together(names, [*spans, *(ends if limited else [])], unit)
    table.measured("largest rate", [one["rate"] for one in shown], f"{unit}/s")
    table.measured("largest acceleration", [one["acceleration"] for one in shown], f"{unit}/s²")
    what = "lengths" if unit == "m" else "angles"
    return table.html(f"Drives of {what}: range, rate, acceleration", left_out(drives))


def simulated(run: RunResult, record: Record) -> list[Markup]:
    """Method and steps of a simulation, and its events."""
    found = record["simulation"]
    if found is None or run.simulation is None:
        return []
    energy = found["energy"]
    rows = [
        ("method", f"{WORDS.get(found['method'], found['method'])}; {SOLVERS.get(found['solver'], found['solver'])}"),
        ("steps", f"{found['steps']}, {found['rejected']} rejected, {found['evaluations']} evaluations"),
        (
            "energy",
            f"{quantity(energy['start'], 'J')} at the start, {quantity(energy['end'], 'J')} at the end, largest change "
            f"{quantity(energy['largest_change'], 'J')}; largest kinetic energy {quantity(energy['largest_kinetic'], 'J')}",
        ),
    ]
    parts = [Table(("", ""), rows, "Integration").html]
    if found["events"]:
        lines = [
            (one["name"], f"{number(one['time'], 9)} s", "rising" if one["direction"] > 0 else "falling")
            for one in found["events"][:MOST]
        ]
        parts.append(Table(("event", "time", "direction"), lines, "Events", left_out(found["events"])).html)
    if found["passages"]:
        lines = [
            (f"{number(one['time'], 6)} s", number(one["pivot"], 3), "certain" if one["certain"] else "not certain")
            for one in found["passages"][:MOST]
        ]
        heads = ("time", "smallest pivot", "branch")
        parts.append(Table(heads, lines, "Singular positions passed (pivot 0 is singular)", left_out(found["passages"])).html)
    return parts


def standing(run: RunResult) -> list[Markup]:
    """Displacements, energies and stability of a static analysis; what elastic members do along a motion."""
    record = statics_record(run)
    if record is None:
        return []
    moved = {case: one for case, one in record["cases"].items() if "displacement" in one}
    listed = ("displacement,", "strain energy,") if moved else ()
    rows = [row for row in statics_lines(run) if not row[0].startswith(listed)]
    lines = [Table(("", ""), rows, statics_title(run)).html] if rows else []
    return [*lines, *([_displaced(run, moved)] if moved else [])]


def _displaced(run: RunResult, cases: dict[str, Record]) -> Markup:
    """The largest displacement of each load case, with its components."""
    far = [one["displacement"] for one in cases.values()]
    table = Columns().words("load case", [named(case) for case in cases]).words("node", [one["node"] for one in far])
    axes = [f"along {axis}" for axis in "xyz"[: run.model.dim]]
    sides = [[one["vector"][k] for one in far] for k in range(run.model.dim)]
    table.together(["largest", *axes], [[one["size"] for one in far], *sides], "m")
    if run.good > 1:
        _times(table, {"at": [one["time"] for one in far]}, poses_of(run))
    if all("strain_energy" in one for one in cases.values()):
        table.measured("strain energy", [one["strain_energy"] for one in cases.values()], "J")
    return table.html("Largest displacement of a node, with its components")


def forces(record: Record) -> list[Markup]:
    """The envelope of every member, the supports, and drives that have no motor."""
    single = is_single(record)
    inner = set(record["inner"])
    cases = {case: [one for one in found if one["member"] not in inner] for case, found in record["envelopes"].items()}
    cases = {case: found for case, found in cases.items() if found}
    every = [one[key] for entries in cases.values() for one in entries for key in ("least", "largest")]
    poses = record["poses"]
    parts = list(_singles(cases)) if single else [_envelope(case, entries, every, poses) for case, entries in cases.items()]
    inside = {one["member"] for found in record["envelopes"].values() for one in found} & inner
    if inside:
        words = f"Forces in the {len(inside)} bars that hold bodies together are in the data of this page."
        parts.append(element("p", words, class_="note"))
    return [*parts, *_reactions(record["reactions"], single, record["poses"]), *_driven(record["drive_loads"])]


def _singles(cases: dict[str, list[Record]]) -> Iterator[Markup]:
    """The forces of one position: load cases beside each other, the largest member of any first."""
    names = list(cases)
    for k in range(0, len(names), BESIDE):
        yield _single({name: cases[name] for name in names[k : k + BESIDE]})


def _single(cases: dict[str, list[Record]]) -> Markup:
    by_case = {case: {one["member"]: one for one in entries} for case, entries in cases.items()}
    first = next(iter(by_case.values()))
    order = sorted(first, key=lambda name: -max(abs(one[name]["largest"]) for one in by_case.values()))
    shown = order[:MOST]
    unsure = {name for name in shown if not all(one[name]["unique"] for one in by_case.values())}
    columns = [[one[name]["largest"] for name in shown] for one in by_case.values()]
    worst = [max(values, key=abs) for values in zip(*columns, strict=True)]
    ends = (min(*worst, 0.0), max(*worst, 0.0)) if worst else (0.0, 0.0)
    table = Columns().words("member", [name + (" †" if name in unsure else "") for name in shown])
    table.words("" if len(cases) == 1 else "largest", [span_bar(min(one, 0.0), max(one, 0.0), *ends) for one in worst])
    table.together(["force"] if len(cases) == 1 else list(cases), columns, "N")
    if len(cases) == 1:
        table.words("", ["tension" if one > 0 else "compression" if one < 0 else "" for one in worst])
    words = cased(next(iter(cases))) if len(cases) == 1 else f"load cases {', '.join(cases)}"
    note = left_out(order) + (UNSURE if unsure else "")
    return table.html(f"Member forces, {words}: mean axial force, tension positive", note)


def _times(table: Columns, columns: dict[str, list[float]], poses: Sequence[str]) -> None:
    """Columns of times, s, or of the poses that they number."""
    if poses:
        for head, values in columns.items():
            table.words(f"{head.removesuffix('at').strip()} in pose".strip(), [poses[round(one)] for one in values])
    else:
        table.together([f"{head} (s)" for head in columns], list(columns.values()), "")


def _reactions(found: Sequence[Record], single: bool, poses: Sequence[str]) -> list[Markup]:
    if not found:
        return []
    shown, axes = found[:MOST], list(found[0]["force"])
    table = Columns().words("support", [one["support"] for one in shown])
    table.words("load case", [named(one["load_case"]) for one in shown])
    components = [[one["force"][axis] for one in shown] for axis in axes]
    table.together(["largest", *axes], [[one["magnitude"] for one in shown], *components], "N")
    about = next((list(one["moment"]) for one in shown if "moment" in one), [])
    if about:
        turned = [[one["moment"][axis] if "moment" in one else None for one in shown] for axis in about]
        table.together([f"moment about {axis}" for axis in about], turned, "N m")
    if not single:
        _times(table, {"at": [one["time"] for one in shown]}, poses)
    words = f", and the moment of a clamp{'' if single else ' at that instant'}" if about else ""
    return [table.html(f"Largest force of each support on the structure, with its components{words}", left_out(found))]


def _driven(found: Sequence[Record]) -> list[Markup]:
    shown = [one for one in found if one["load"]][:MOST]
    if not shown:
        return []
    table = Columns().words("drive", [one["drive"] for one in shown])
    units = [one["unit"] for one in shown]
    table.mixed(["force or torque"], [[one["load"] for one in shown]], units)
    table.words("at", [one["pose"] or at(one["time"]) for one in shown])
    table.mixed(["rate"], [[one["rate"] for one in shown]], ["rad/s" if unit == "N m" else "m/s" for unit in units])
    table.measured("power", [one["power"] for one in shown], "W")
    table.words("load case", [named(one["load_case"]) for one in shown])
    return [table.html("Drives without a motor: largest values of the motion, with their signs", left_out(found))]


def _envelope(case: str, entries: list[Record], every: list[float], poses: Sequence[str]) -> Markup:
    """The envelope of a load case. every : forces of all of them, which share their unit."""
    least = min((one["least"] for one in entries), default=0.0)
    most = max((one["largest"] for one in entries), default=0.0)
    ends = (min(least, 0.0), max(most, 0.0))
    shown = entries[:MOST]
    table = Columns().words("member", [one["member"] + ("" if one["unique"] else " †") for one in shown])
    table.words("envelope", [span_bar(one["least"], one["largest"], *ends) for one in shown])
    rest = any(one["at_rest"] is not None for one in shown)
    keys = {"least": "least", "largest": "largest"} | ({"at rest": "at_rest"} if rest else {})
    table.together(list(keys), [[one[key] for one in shown] for key in keys.values()], "N", every)
    times = {"least at": "least_time", "largest at": "largest_time"}
    _times(table, {head: [one[key] for one in shown] for head, key in times.items()}, poses)
    note = (
        f"{left_out(entries)}Bars run from the least to the largest force of the run: compression to the left of the line, "
        f"tension to the right, from {quantity(least, 'N')} to {quantity(most, 'N')}. At rest: in the pose of the larger one."
    ) + ("" if all(one["unique"] for one in entries) else f" {UNSURE}")
    return table.html(f"Envelope of member forces, {cased(case)}: mean axial force, tension positive", note)


def checked(run: RunResult, record: Record) -> list[Markup]:
    """Checks, each with its result and the exact value."""
    rows = [*_numeric(run, record), _model(record)]
    return [Table(("check", "result", "meaning"), rows, "What was checked, and the result").html]


def _numeric(run: RunResult, record: Record) -> Iterator[tuple[str, str, str]]:
    found, closed = record["checks"], record["closure"]
    balance, gauge = found["energy_balance"], found["singularity"]
    if balance is not None:
        miss, largest = quantity(balance["largest_miss"], "W"), quantity(balance["largest_power"], "W")
        words = f"power not accounted for is at most {miss}, largest power {largest}; 0 is exact"
        yield "energy balance", f"{number(balance['relative'], 3)} of the largest power", words
    if closed is not None:
        share = f"{number(closed['relative'], 2)} of its length"
        when = moment(closed["time"], record["poses"])
        words = f"largest departure of a bar from its length: {closed['member']} at {when}, {share}; 0 is exact"
        yield "constraint error", quantity(closed["error"], "m"), words
    if run.simulation is not None and run.simulation.data.sizes["time"]:
        drift = float(run.simulation.data["constraint_error"].values.max())
        yield "drift of a step", number(drift, 3), "largest constraint error before the projection onto the constraints"
    if gauge is not None:
        words = f"smallest at {moment(gauge['time'], record['poses'])}; 0 is singular, 1 is as far from it as can be"
        yield "singularity margin", number(gauge["smallest"], 3), words
    if record["envelopes"] and any(record["envelopes"].values()):
        names = found["not_unique"]
        words = "in a redundant structure forces depend on stiffness or convention"
        yield "unique forces", "all" if not names else f"all but {', '.join(names)}", words
    if found["motors"]:
        yield "motors", "checked", f"limits that only forces decide: {', '.join(found['motors'])}"


def _model(record: Record) -> tuple[str, str, str]:
    """Check that the model in the page is the one of the run."""
    short = record["model_sha256"][:16]
    noted = str(record["provenance"].get("model", short))
    words = f"SHA-256 {short}… of the model in this report"
    if noted == short:
        return "model", "unchanged", words
    return "model", "not the one that was run", f"{words}; the run has {noted}…"


def method(run: RunResult) -> list[Markup]:
    """The methods and their publications."""
    parts = []
    for name, words, published in methods(run):
        cited = element("cite", f" {published}.") if published else None
        parts.append(element("p", element("b", f"{name}. "), words, cited))
    given = sources(run.model)
    if given:
        parts.append(element("p", element("b", "Data of the model. "), "As its records say:"))
        parts.append(element("ul", [element("li", text) for text in given[:MOST]]))
    return parts
