"""The parts of a report, one function per part; each returns nothing if the run has no such results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, element, number, quantity
from kinetruss.report.document._bars import span_bar
from kinetruss.report.document.parts.inputs import sources
from kinetruss.report.document.parts.methods import methods
from kinetruss.report.document.parts.words import MOST, at, counted, left_out, long, named
from kinetruss.report.run_text.drives import drive_cells
from kinetruss.report.run_text.statics import statics_lines, statics_title

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

    Record = dict[str, Any]

__all__ = ["checked", "forces", "method", "mobility", "motion", "simulated", "standing"]


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
    """Range, rate and acceleration of the drives."""
    heads = ("drive", "kind", "least", "largest", "largest rate", "largest acceleration", "travel allowed")
    rows = [_drive(one) for one in record["drives"][:MOST]]
    return [Table(heads, rows, "Drives: range, rate, acceleration", left_out(record["drives"])).html] if rows else []


def _drive(one: Record) -> tuple[str, ...]:
    unit, travel = one["unit"], one["travel"]
    allowed = "-" if travel is None else f"{quantity(travel[0], unit)} to {quantity(travel[1], unit)}"
    rates = (quantity(one["rate"], f"{unit}/s"), quantity(one["acceleration"], f"{unit}/s²"))
    return one["drive"], one["kind"], long(one["least"], unit), long(one["largest"], unit), *rates, allowed


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
    parts = [_envelope(case, entries) for case, entries in record["envelopes"].items()]
    found = record["reactions"]
    if found:
        axes = list(found[0]["force"])
        rows = [
            (
                one["support"],
                named(one["load_case"]),
                quantity(one["magnitude"], "N"),
                at(one["time"]),
                *(quantity(one["force"][axis], "N") for axis in axes),
            )
            for one in found[:MOST]
        ]
        heads = ("support", "load case", "largest", "at", *axes)
        parts.append(Table(heads, rows, "Largest force of each support on the structure", left_out(found)).html)
    return parts + _driven(record["drive_loads"])


def _driven(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    heads = ("drive", "force or torque", "at", "rate", "power", "load case")
    lines = [(*drive_cells(one)[:-1], named(one["load_case"])) for one in found[:MOST]]
    return [Table(heads, lines, "Drives without a motor: largest values of the motion, with their signs", left_out(found)).html]


def _envelope(case: str, entries: list[Record]) -> Markup:
    least = min((one["least"] for one in entries), default=0.0)
    most = max((one["largest"] for one in entries), default=0.0)
    ends = (min(least, 0.0), max(most, 0.0))
    rows = [
        (
            one["member"] + ("" if one["unique"] else " †"),
            span_bar(one["least"], one["largest"], *ends),
            quantity(one["least"], "N"),
            at(one["least_time"]),
            quantity(one["largest"], "N"),
            at(one["largest_time"]),
            "-" if one["at_rest"] is None else quantity(one["at_rest"], "N"),
        )
        for one in entries[:MOST]
    ]
    heads = ("member", "envelope", "least", "at", "largest", "at", "same pose at rest")
    note = (
        f"{left_out(entries)}Bars run from the least to the largest force of the run: compression to the left of the line, "
        f"tension to the right, from {quantity(least, 'N')} to {quantity(most, 'N')}. At rest: at the larger of the two."
    ) + ("" if all(one["unique"] for one in entries) else " † Not unique: depends on stiffness or convention.")
    return Table(heads, rows, f"Envelope of member forces, {named(case)}: mean axial force, tension positive", note).html


def checked(run: RunResult, record: Record) -> list[Markup]:
    """Checks, each with its result and the exact value."""
    rows = [*_numeric(run, record), _model(record)]
    return [Table(("check", "result", "what it says"), rows, "What was checked, and how it came out").html]


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
    words = f"SHA-256 {short}… of the model below"
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
