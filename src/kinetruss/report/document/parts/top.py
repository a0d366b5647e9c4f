"""The top of the report: title, state of the run, main results, warnings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, instant, number, quantity
from kinetruss.report.document.parts.words import at, is_over, named, share_of

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

    Record = dict[str, Any]

__all__ = ["top"]


def top(run: RunResult, record: Record, title: str, date: str) -> list[Markup]:
    """The head of a report."""
    words = (f"Run {run.name}", _span(record), f"kinetruss {run.provenance.get('kinetruss', '')}".strip(), date)
    line = element("p", " · ".join(word for word in words if word), class_="quiet")
    kicker = element("p", "Report of a structural analysis", class_="kicker")
    found = [element("header", kicker, element("h1", title), line)]
    if not run.whole:
        found.append(_not_whole(run))
    tiles = element("div", list(_tiles(record)), class_="tiles")
    found.append(element("section", element("h2", "Result"), tiles, _verdict(record), id="result"))
    if record["warnings"]:
        told = element("ul", [element("li", one) for one in record["warnings"]])
        kind = "warnings" if record["whole"] and not any(map(is_over, _held(record))) else "warnings grave"
        found.append(element("section", element("h2", "Warnings"), told, id="warnings", class_=kind))
    return found


def _span(record: Record) -> str:
    """Time range and number of samples."""
    span = record["time"]
    return f"t = {number(span[0])} to {instant(span[1])}, {record['samples']['good']} samples" if span else "no good sample"


def _not_whole(run: RunResult) -> Markup:
    """The note on a run that is not complete, with the command to resume it."""
    name = "RUN" if run.path is None else run.path.resolve().name
    what, mend = {
        "running": ("It is still being computed.", "Make the report again when it has ended."),
        "incomplete": ("It was interrupted.", f"Continue with: kinetruss run --resume {name}"),
        "finished": (run.status.value, ""),
    }[run.state]
    count = f"{run.good} of {run.samples} samples are good, and this report uses only these."
    words = " ".join(word for word in (what, count, run.message, mend) if word)
    return element("div", element("strong", "This run is not complete. "), words, class_="alarm", role="alert")


def _tiles(record: Record) -> Iterator[Markup]:
    """The main results."""
    for one in record["worst"][:1]:
        words = f"{one['part']}, {one['rule']}, t = {at(one['time'])}"
        yield _tile("Highest utilisation", share_of(one["utilisation"]), words, is_over(one))
    for one in record["largest_forces"][:1]:
        words = f"{'tension' if one['force'] > 0 else 'compression'}, {one['member']}, t = {at(one['time'])}"
        words += "" if one["unique"] else "; not unique"
        yield _tile("Largest member force", quantity(abs(one["force"]), "N"), words)
    held = [one for one in record["limits"] if one["utilisation"] is not None]
    for one in held[:1]:
        value = share_of(one["utilisation"])
        yield _tile(
            "Nearest limit of a drive", value, f"{one['rule']} of {one['part']}, {named(one['load_case'])}", is_over(one)
        )
    gauge, balance = record["checks"]["singularity"], record["checks"]["energy_balance"]
    if gauge is not None:
        yield _tile("Singularity margin", number(gauge["smallest"], 3), f"t = {at(gauge['time'])}; 0 is singular")
    if balance is not None:
        yield _tile("Energy balance", number(balance["relative"], 2), "of the largest power; 0 is exact")


def _tile(name: str, value: str, words: str, alarming: bool = False) -> Markup:
    inside = (element("span", name), element("b", value), element("small", words))
    return element("div", inside, class_="tile over" if alarming else "tile")


def _held(record: Record) -> list[Record]:
    """Entries of strength and drives with a limit."""
    return [row for row in (*record["strength"], *record["limits"]) if row["utilisation"] is not None]


def _verdict(record: Record) -> Markup:
    """One sentence on the limits that were checked."""
    held = _held(record)
    over = sum(map(is_over, held))
    scope = "" if record["whole"] else " in the part that was computed"
    if not held:
        words = "No limit was checked: strengths of members and limits of drives are not known here."
    elif over:
        words = f"{over} of {len(held)} limits that were checked are exceeded{scope}; see the warnings."
    else:
        words = f"None of the {len(held)} limits that were checked is exceeded{scope}."
    return element("p", words, class_="verdict")
