"""The parts of a report, one function per part; each returns nothing if the run has no such results."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, counted, element, number, quantity
from kinetruss.display.tables import MOST, words
from kinetruss.report import tables
from kinetruss.report.document.checks import methods
from kinetruss.report.document.inputs import WORDS, sources
from kinetruss.report.run_data import moment, poses_of
from kinetruss.report.run_lines import statics_lines, statics_record, statics_title
from kinetruss.report.tables import is_single

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult

    Record = dict[str, Any]


BESIDE = 6
"""Number of load cases beside each other in a table."""
SOURCES = 40
"""Largest number of sources that are listed."""
SOLVERS = {
    "dense": "equations of motion solved with a dense matrix",
    "sparse": "equations of motion solved with a sparse matrix",
    "sweep": "equations of motion solved along the chain",
}


def mobility(record: Record) -> list[Entry]:
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
    return [Table(("", ""), rows, "Mobility of the model as it stands, decided by rank")]


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


def motion(record: Record) -> list[Table]:
    """Range, rate and acceleration of the drives, in one table for those of lengths and one for those of angles."""
    return [tables.spans(record["drives"], unit) for unit in ("m", "rad")]


def simulated(run: RunResult, record: Record) -> list[Table]:
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
        Table(("", ""), rows, "Integration"),
        Table(events, found["events"], "Events", most=MOST),
        Table(passages, found["passages"], "Singular positions passed (pivot 0 is singular)", most=MOST),
    ]


def standing(run: RunResult) -> list[Table]:
    """Displacements, energies and stability of a static analysis; what elastic members do along a motion."""
    record = statics_record(run)
    if record is None:
        return []
    moved = {case: one for case, one in record["cases"].items() if "displacement" in one}
    listed = ("displacement,", "strain energy,") if moved else ()
    rows = [row for row in statics_lines(run) if not row[0].startswith(listed)]
    far = tables.displacements(moved, run.model.dim, timed=run.good > 1, poses=poses_of(run))
    return [Table(("", ""), rows, statics_title(run)), far]


def forces(record: Record) -> list[Entry]:
    """The envelope of every member, the supports, drives that have no motor, and springs."""
    single, poses = is_single(record), record["poses"]
    inner = set(record["inner"])
    cases = {case: [one for one in found if one["member"] not in inner] for case, found in record["envelopes"].items()}
    cases = {case: found for case, found in cases.items() if found}
    every = [one for entries in cases.values() for one in entries]
    names = list(cases)
    parts: list[Entry] = [tables.envelope(case, entries, every, poses) for case, entries in cases.items()]
    if single:
        beside = (names[k : k + BESIDE] for k in range(0, len(names), BESIDE))
        parts = [tables.still_forces({name: cases[name] for name in some}) for some in beside]
    inside = {one["member"] for found in record["envelopes"].values() for one in found} & inner
    if inside:
        said = f"Forces in the {len(inside)} bars that hold bodies together are in the data of this page."
        parts.append(element("p", said, class_="note"))
    return [
        *parts,
        tables.reactions(record["reactions"], single=single, poses=poses),
        tables.drives(record["drive_loads"], timed=not single),
        tables.springs(record["spring_loads"]),
    ]


def checked(run: RunResult, record: Record) -> list[Table]:
    """Checks, each with its result and the exact value."""
    rows = [*_numeric(run, record), _model(record)]
    return [Table(("check", "result", "meaning"), rows, "What was checked, and the result")]


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
    for name, said, published in methods(run):
        cited = element("cite", f" {published}.") if published else None
        parts.append(element("p", element("b", f"{name}. "), said, cited))
    given = sources(run.model)
    if given:
        parts.append(element("p", element("b", "Data of the model. "), "As its records say:"))
        parts.append(element("ul", [element("li", text) for text in given[:SOURCES]]))
    return parts
