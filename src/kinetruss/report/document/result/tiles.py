"""The first part of a report: state of the run, main results, warnings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, instant, number, quantity
from kinetruss.report.document.parts.words import cased, is_over, is_single, share_of
from kinetruss.report.run_text.columns import moment

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

    Record = dict[str, Any]

__all__ = ["not_whole", "span_of", "tiles", "warned"]


def span_of(record: Record) -> str:
    """Time range and number of samples."""
    span = record["time"]
    if is_single(record):
        return "one position"
    if record["poses"]:
        return f"poses {', '.join(record['poses'])}"
    return f"t = {number(span[0])} to {instant(span[1])}, {record['samples']['good']} samples" if span else "no good sample"


def not_whole(run: RunResult) -> list[Markup]:
    """The note on a run that is not complete, with the command to resume it; nothing for a complete one."""
    if run.whole:
        return []
    name = "RUN" if run.path is None else run.path.resolve().name
    what, mend = {
        "running": ("It is still being computed.", "Make the report again when it has ended."),
        "incomplete": ("It was interrupted.", f"Continue with: kinetruss run --resume {name}"),
        "finished": (run.status.value, ""),
    }[run.state]
    count = f"{run.good} of {run.samples} samples are good, and this report uses only these."
    words = " ".join(word for word in (what, count, run.message, mend) if word)
    return [element("div", element("strong", "This run is not complete. "), words, class_="alarm", role="alert")]


def tiles(record: Record) -> Markup:
    """The main results."""
    return element("div", list(_tiles(record)), class_="tiles")


def warned(record: Record) -> list[Markup]:
    """The warnings; nothing without any."""
    if not record["warnings"]:
        return []
    listed = element("ul", [element("li", one) for one in record["warnings"]])
    held = [row for row in (*record["strength"], *record["limits"]) if row["utilisation"] is not None]
    kind = "warnings" if record["whole"] and not any(map(is_over, held)) else "warnings grave"
    return [element("div", element("h3", "Warnings"), listed, class_=kind)]


def _tiles(record: Record) -> Iterator[Markup]:
    for one in record["worst"][:1]:
        words = f"{one['part']}, {one['rule']}{_when(one, record)}"
        yield _tile("Highest utilisation of a member", share_of(one["utilisation"]), words, is_over(one))
    held = [one for one in record["limits"] if one["utilisation"] is not None]
    for one in held[:1]:
        value = share_of(one["utilisation"])
        words = f"{one['rule']} of {one['part']}, {cased(one['load_case'])}"
        yield _tile("Highest utilisation of a drive", value, words, is_over(one))
    for one in record["largest_forces"][:1]:
        words = f"{'tension' if one['force'] > 0 else 'compression'}, {one['member']}{_when(one, record)}"
        words += "" if one["unique"] else "; not unique"
        yield _tile("Largest member force", quantity(abs(one["force"]), "N"), words)
    gauge, balance = record["checks"]["singularity"], record["checks"]["energy_balance"]
    if gauge is not None:
        yield _tile("Singularity margin", number(gauge["smallest"], 3), f"0 is singular{_when(gauge, record)}")
    if balance is not None:
        yield _tile("Energy balance", number(balance["relative"], 2), "of the largest power; 0 is exact")


def _when(one: Record, record: Record) -> str:
    if one.get("pose"):
        return f", pose {one['pose']}"
    when = moment(one["time"], record["poses"]).replace(" = ", "\u00a0=\u00a0").replace(" s", "\u00a0s")
    return "" if is_single(record) else f", {when}"


def _tile(name: str, value: str, words: str, alarming: bool = False) -> Markup:
    inside = (element("span", name), element("b", value), element("small", words))
    return element("div", inside, class_="tile over" if alarming else "tile")
