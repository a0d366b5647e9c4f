"""The parts of a report, one function per part; each returns nothing if the run has no such results."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, counted, element, number
from kinetruss.model.data import ELEMENT_FIELDS
from kinetruss.report import tables
from kinetruss.report.document.checks import methods
from kinetruss.report.document.inputs import sources
from kinetruss.report.run_lines import statics_lines, statics_record, statics_title
from kinetruss.report.tables import is_single
from kinetruss.runs.doubts import poses_of

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult

    Record = dict[str, Any]


BESIDE = 6
"""Number of load cases beside each other in a table."""
SOURCES = 40
"""Largest number of sources that are listed."""


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
    cases = {case: found for case, found in record["envelopes"].items() if found}
    every = [one for entries in cases.values() for one in entries]
    names = list(cases)
    parts: list[Entry] = [tables.envelope(case, entries, every, poses) for case, entries in cases.items()]
    if single:
        beside = (names[k : k + BESIDE] for k in range(0, len(names), BESIDE))
        parts = [tables.still_forces({name: cases[name] for name in some}) for some in beside]
    return [
        *parts,
        tables.reactions(record["reactions"], single=single, poses=poses),
        tables.drives(record["drive_loads"], timed=not single),
        *(tables.elements(kind, record[f"{kind}_loads"]) for kind in ELEMENT_FIELDS),
    ]


def checked(run: RunResult, record: Record) -> Table:
    """Checks, with the drift of a simulation and that of the model."""
    rows = [unchanged(record)]
    if run.simulation is not None and run.simulation.data.sizes["time"]:
        drift = float(run.simulation.data["constraint_error"].values.max())
        said = "largest constraint error before the projection onto the constraints"
        rows.insert(0, ("drift of a step", number(drift, 3), said))
    forces = any(record["envelopes"].values())
    return tables.checks(record["checks"], record["closure"], record["poses"], *rows, forces=forces)


def unchanged(record: Record) -> tuple[str, str, str]:
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
