"""The parts of a report, one function per part; each returns nothing if the run has no such results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, counted, element, number, quantity
from kinetruss.report.document._bars import span_bar
from kinetruss.report.document.frame import Columns
from kinetruss.report.document.parts.inputs import sources
from kinetruss.report.document.parts.methods import methods
from kinetruss.report.document.parts.words import MOST, at, is_single, left_out, named
from kinetruss.report.run_text.statics import statics_lines, statics_title

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

    Record = dict[str, Any]

__all__ = ["checked", "forces", "method", "mobility", "motion", "simulated", "standing"]


UNSURE = "† Not unique: depends on stiffness or convention."


def mobility(record: Record) -> list[Markup]:
    """Mechanisms and states of self-stress of the model in its own pose."""
    found = record["mobility"]
    if found is None:
        words = "The model has too many nodes for a rank decision in a report; use kinetruss info on the model file."
        return [element("p", words)]
    rows = [
        ("coordinates", f"{found['coordinates']}, of them {found['fixed']} fixed"),
        ("rigid bars", f"{found['bars']}, of rank {found['rank']}"),
        ("degrees of freedom", f"{found['degrees_of_freedom']}; {counted(found['drives'], 'drive')}"),
        (
            "with the drives held",
            f"{counted(found['undriven'], 'mechanism')}, {counted(found['self_stress'], 'state')} of "
            f"self-stress (Calladine's count {found['maxwell']} = {found['undriven']} − {found['self_stress']})",
        ),
        ("smallest singular value", number(found["smallest_singular_value"], 3)),
    ]
    rows += [(f"mechanism {k + 1}", text) for k, text in enumerate(found["mechanisms"][:8])]
    rows += [(f"self-stress {k + 1}", text) for k, text in enumerate(found["self_stress_states"][:8])]
    return [Table(("", ""), rows, "Mobility of the model as it stands, decided by rank").html]


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
        ("method", f"{found['method']}, equations by {found['solver']}"),
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
    rows = list(statics_lines(run))
    return [Table(("", ""), rows, statics_title(run)).html] if rows else []


def forces(record: Record) -> list[Markup]:
    """The envelope of every member, the supports, and drives that have no motor."""
    single = is_single(record)
    parts = [(_single if single else _envelope)(case, entries) for case, entries in record["envelopes"].items()]
    return [*parts, *_reactions(record["reactions"], single), *_driven(record["drive_loads"])]


def _single(case: str, entries: list[Record]) -> Markup:
    """The forces of one position."""
    shown = entries[:MOST]
    forces = [one["largest"] for one in shown]
    ends = (min(*forces, 0.0), max(*forces, 0.0)) if forces else (0.0, 0.0)
    table = Columns().words("member", [one["member"] + ("" if one["unique"] else " †") for one in shown])
    table.words("", [span_bar(min(force, 0.0), max(force, 0.0), *ends) for force in forces]).measured("force", forces, "N")
    note = left_out(entries) + ("" if all(one["unique"] for one in entries) else UNSURE)
    return table.html(f"Member forces, {named(case)}: mean axial force, tension positive", note)


def _reactions(found: Sequence[Record], single: bool) -> list[Markup]:
    if not found:
        return []
    shown, axes = found[:MOST], list(found[0]["force"])
    table = Columns().words("support", [one["support"] for one in shown])
    table.words("load case", [named(one["load_case"]) for one in shown])
    components = [[one["force"][axis] for one in shown] for axis in axes]
    table.together(["largest", *axes], [[one["magnitude"] for one in shown], *components], "N")
    if not single:
        table.measured("at (s)", [one["time"] for one in shown], "")
    return [table.html("Largest force of each support on the structure, with its components", left_out(found))]


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


def _envelope(case: str, entries: list[Record]) -> Markup:
    least = min((one["least"] for one in entries), default=0.0)
    most = max((one["largest"] for one in entries), default=0.0)
    ends = (min(least, 0.0), max(most, 0.0))
    shown = entries[:MOST]
    table = Columns().words("member", [one["member"] + ("" if one["unique"] else " †") for one in shown])
    table.words("envelope", [span_bar(one["least"], one["largest"], *ends) for one in shown])
    rest = any(one["at_rest"] is not None for one in shown)
    keys = {"least": "least", "largest": "largest"} | ({"at rest": "at_rest"} if rest else {})
    table.together(list(keys), [[one[key] for one in shown] for key in keys.values()], "N")
    table.together(
        ["least at (s)", "largest at (s)"], [[one[key] for one in shown] for key in ("least_time", "largest_time")], ""
    )
    note = (
        f"{left_out(entries)}Bars run from the least to the largest force of the run: compression to the left of the line, "
        f"tension to the right, from {quantity(least, 'N')} to {quantity(most, 'N')}. At rest: in the pose of the larger one."
    ) + ("" if all(one["unique"] for one in entries) else f" {UNSURE}")
    return table.html(f"Envelope of member forces, {named(case)}: mean axial force, tension positive", note)


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
        words = f"largest departure of a bar from its length: {closed['member']} at {at(closed['time'])}, {share}; 0 is exact"
        yield "constraint error", quantity(closed["error"], "m"), words
    if run.simulation is not None and run.simulation.data.sizes["time"]:
        drift = float(run.simulation.data["constraint_error"].values.max())
        yield "drift of a step", number(drift, 3), "largest constraint error before the projection onto the constraints"
    if gauge is not None:
        words = f"smallest at {at(gauge['time'])}; 0 is singular, 1 is as far from it as can be"
        yield "singularity margin", number(gauge["smallest"], 3), words
    if run.forces:
        names = found["not_unique"]
        words = "in a redundant structure forces depend on stiffness or convention"
        yield "unique forces", "all" if not names else f"all but {', '.join(names)}", words


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
