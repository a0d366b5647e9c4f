"""Data to repeat a run: the model, its hash, versions, commands."""

from __future__ import annotations

import base64
import hashlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, element, quantity

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.runs import RunResult

__all__ = ["recompute"]

PRINTED = 400
"""Number of lines up to which a model file is printed; a longer one is shown only in the page."""
NARROW, FEW = 58, 20
"""Characters of a line in half of a sheet; number of lines from twice which on two columns are worth while."""
SHOWN = 300_000
"""Number of characters up to which a model file is shown; a larger one can only be saved."""


def recompute(run: RunResult, record: dict[str, Any]) -> list[Markup]:
    """Versions and hash, commands, and the model file."""
    given = {key: value for key, value in record["provenance"].items() if key not in ("title", "model", "run")}
    rows: list[tuple[str, Any]] = [("run folder", record["out"])] if record["out"] else []
    rows += [("versions", ", ".join(f"{key} {value}" for key, value in given.items()))]
    rows += [("model.json, SHA-256", element("code", record["model_sha256"]))]
    rows += [(f"{name}, SHA-256", text) for name, text in _motion(run)]
    rows += [("computing took", quantity(run.wall_time, "s"))]
    saved = element("a", "Save model.json", href=_address(record["model"]), download="model.json", class_="screen save")
    steps = f"kinetruss check model.json\nkinetruss run model.json {run.name} -o again\nkinetruss info again"
    parts = [
        Table(("", ""), rows, "Provenance").html,
        element(
            "p",
            "The file report.html holds the model, byte by byte; save it as model.json. ",
            saved,
            " Then, with the versions above:",
            class_="where",
        ),
        element("pre", element("code", steps), class_="short"),
    ]
    return [*parts, *_listing(run.model)]


def _motion(run: RunResult) -> list[tuple[str, Any]]:
    """The present hash of the motion's file."""
    given = run.definition.motion
    if given is None:
        return []
    path = Path(given)
    if not path.is_file():
        return [(path.name, "not where it was; its motion is in the run folder")]
    return [(path.name, element("code", hashlib.sha256(path.read_bytes()).hexdigest()))]


def _listing(model: Model) -> list[Markup]:
    """The model as YAML text."""
    from kinetruss.io.formats import plain_model, to_yaml

    text = to_yaml(plain_model(model))
    if len(text) > SHOWN:
        return [element("p", "The model is too long to be shown here; save it to read it.", class_="note")]
    long = text.count("\n") > PRINTED
    note = element("p", "The model file is printed in the page only: it is long.", class_="paper note") if long else None
    words = element("h3", "The model file (SI units; default values are omitted)")
    return [
        words,
        *([note] if note else []),
        element(
            "pre",
            element("code", text),
            class_=" ".join(["model", *(["screen"] if long else []), *(["wide"] if _is_narrow(text) else [])]),
            tabindex="0",
            role="region",
            aria_label="the model",
        ),
    ]


def _is_narrow(text: str) -> bool:
    """True if nearly all lines fit into half of the sheet: then it is printed in two columns."""
    lines = text.splitlines()
    return sum(len(line) <= NARROW for line in lines) >= 0.9 * len(lines) and len(lines) > 2 * FEW


def _address(text: str) -> str:
    return f"data:application/json;base64,{base64.b64encode(text.encode()).decode('ascii')}"
