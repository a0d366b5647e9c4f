"""What people read: reports, summaries, JSON, scenes, sizings of the examples, messages of files put wrong; texts in a folder.

    python tests/campaigns/base/shown.py FOLDER --examples N [--wrong FILES]

Through the public interface alone, so that the same script asks any revision. What depends on the machine or the hour is
written as '-': seconds taken, dates, versions, places of files.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import kinetruss as kt

VOLATILE = ("wall_time", "provenance", "out")
"""Keys of records whose values depend on the machine or the hour."""
TAKEN = re.compile(r"(?<=; )\d[\d.]* (?:ms|s|min|h)$|(?<=computing took</th>\n<td>)[^<]*", re.MULTILINE)
"""What the last words of a summary's line, and a row of the report, say that a run took."""
DATA = re.compile(r"<script type=.application/json.*?</script>", re.DOTALL)
"""The record of a report in its page: it is compared by itself."""


DRAWING = re.compile(r"<svg\b.*?</svg>", re.DOTALL)
LETTERS = re.compile(r"<text\b[^>]*>([^<]*)</text>")
"""A drawing in a page, of which the letters are compared: where a line goes is for tests of drawings, and for eyes."""


def readable(html: str) -> str:
    """A page in lines, of its drawings the letters."""

    def letters(drawing: re.Match[str]) -> str:
        return "\n".join(f"drawn: {words}" for words in ["", *sorted(LETTERS.findall(drawing[0]))])

    bare = DRAWING.sub(letters, DATA.sub("", html))
    return TAKEN.sub("-", re.sub(r">\s*<", ">\n<", bare))


def steady(value: Any) -> Any:
    """A record without what depends on the machine or the hour."""
    if isinstance(value, dict):
        return {key: "-" if key in VOLATILE else steady(one) for key, one in value.items()}
    return [steady(one) for one in value] if isinstance(value, list | tuple) else value


def as_text(record: Any) -> str:
    """A record as lines."""
    return json.dumps(steady(json.loads(json.dumps(record, default=str))), indent=0, ensure_ascii=False)


def of_example(name: str) -> Iterator[tuple[str, str]]:
    """Texts of an example by what they are: of its model, and of each of its runs."""
    model = kt.read(kt.library.example_files()[name][0])
    yield "model", str(model) + "\n" + as_text(model.model_dump(mode="json"))
    yield "mobility", str(kt.kinematics.mobility(model))
    for run in model.runs:
        try:
            result = kt.run(model, run)
        except kt.KinetrussError as error:
            yield run, f"{type(error).__name__}: {error}"
            continue
        yield f"{run} lines", "\n".join(kt.report.lines(result))
        summary = kt.report.summary(result)
        yield f"{run} summary", TAKEN.sub("-", summary.text) + "\n" + as_text(summary.record)
        page = kt.report.document_page(result, date="1 January 2000")
        yield f"{run} report", as_text(page.record)
        yield f"{run} page", readable(page.html)
        scene = kt.viewer.scene(result, frames=20)
        sums = {key: [list(one.shape), float(np.abs(one).sum())] for key, one in sorted(scene.arrays.items())}
        yield f"{run} scene", as_text(scene.header) + "\n" + as_text(sums)


def of_sizing(model: Path, mission: Path) -> Iterator[tuple[str, str]]:
    """Texts of a sizing by a mission file."""
    record = kt.design.record(kt.design.size(kt.read(model), mission))
    yield "sizing", as_text(record)
    page = kt.report.sizing_page(record, date="1 January 2000")
    yield "sizing page", readable(page.html)


def of_wrong(path: Path) -> str:
    """What is said of a model file that was put wrong."""
    try:
        model = kt.read(path)
    except Exception as error:  # noqa: BLE001 - what an older revision makes of a file is shown too
        return f"{type(error).__name__}:\n{error}".replace(str(path.parent), "-")
    return f"accepted: {model}"


def write(folder: Path, name: str, text: str) -> None:
    """A text in a file of its own, which takes its name when it is whole."""
    draft = folder / "draft.part"
    draft.write_text(text, encoding="utf-8", errors="surrogatepass")
    draft.replace(folder / f"{name.replace(' ', '-')}.txt")


def main() -> int:
    """Write the texts of the first examples, of all sizings, and of the files in a folder."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--examples", type=int, required=True)
    parser.add_argument("--wrong", type=Path, help="folder of model files that were put wrong")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    kt.errors.MOST_LINES = sys.maxsize  # all faults are compared, however many
    given.folder.mkdir(parents=True, exist_ok=True)
    for name in list(kt.library.example_files())[: given.examples]:
        for what, text in of_example(name):
            write(given.folder, f"{name} {what}", text)
        print(f"{name} is shown", file=sys.stderr, flush=True)
    for name, (model, *others) in kt.library.example_files().items() if given.examples else ():
        for mission in (path for path in others if path.stem.endswith(".mission")):
            for what, text in of_sizing(model, mission):
                write(given.folder, f"{name} {what}", text)
    for path in sorted(given.wrong.iterdir()) if given.wrong else []:
        if path.suffix in (".yaml", ".json"):
            write(given.folder, f"wrong {path.stem}", of_wrong(path))
    return 0


if __name__ == "__main__":
    sys.exit(main())
