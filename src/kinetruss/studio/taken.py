"""What one takes away from a drawing: its text, Python, a picture, a film of its motion, a page, a report; each one file."""

from __future__ import annotations

import math
import pprint
import re
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Literal

import numpy as np

from kinetruss import report, runs, viewer
from kinetruss.errors import InputError, KinetrussError
from kinetruss.kinematics import follow
from kinetruss.model import ConstantRate, Model, Run, turns
from kinetruss.studio.new_parts import new_run

if TYPE_CHECKING:
    from collections.abc import Callable

    from kinetruss.results import Forces
    from kinetruss.runs import RunResult
    from kinetruss.studio.edits import Data

Form = Literal["yaml", "python", "svg", "png", "pdf", "gif", "mp4", "page", "report", "paper"]

MEDIA = {
    "yaml": ("yaml", "application/yaml"),
    "python": ("py", "text/x-python"),
    "svg": ("svg", "image/svg+xml"),
    "png": ("png", "image/png"),
    "pdf": ("pdf", "application/pdf"),
    "gif": ("gif", "image/gif"),
    "mp4": ("mp4", "video/mp4"),
    "page": ("html", "text/html"),
    "report": ("html", "text/html"),
    "paper": ("pdf", "application/pdf"),
}
"""Form -> suffix of the file and its media type."""

FILM, RATE = (720, 540), 20.0
"""Width and height of a film, pixels, and its frames a second."""

TURN = 4.0
"""Duration of a turn of a drawing without a run, s."""


@dataclass(frozen=True)
class File:
    """A file to take away."""

    name: str
    media: str
    content: bytes


def taken(
    form: Form,
    model: Model,
    data: Data,
    text: str,
    name: str,
    run: str = "",
    progress: Callable[[int, int], None] | None = None,
    pose: Forces | None = None,
) -> File:
    """A file of a drawing.

    Parameters
    ----------
    text : of its model file. name : of the file, without suffix. run : whose motion and result films, page and report show; by
        default the first one that moves, else a turn of its drives. pose : of a motion, one sample, that a picture shows in
        place of the one that is drawn.

    Raises
    ------
    InputError : a film or report of what does not move or cannot be computed; no Chromium, or no encoder.
    """
    suffix, media = MEDIA[form]
    stem = re.sub(r"[^\w.-]+", "_", name) or "drawing"
    stem = f"{stem}_report" if form in ("report", "paper") else stem
    if form == "yaml":
        content = text.encode()
    elif form == "python":
        content = python_of(data, stem).encode()
    else:
        content = _computed(form, model, run, f"{stem}.{suffix}", progress, pose)
    return File(f"{stem}.{suffix}", media, content)


def _computed(
    form: Form, model: Model, run: str, name: str, progress: Callable[[int, int], None] | None, pose: Forces | None
) -> bytes:  # fmt: skip
    with TemporaryDirectory() as folder:
        path = Path(folder) / name
        if form in ("svg", "png", "pdf"):
            report.picture(model if pose is None else pose, path, model=model)
        elif form == "page":
            result = None if not run and not (model.runs or model.all_drives) else _result(model, run)
            viewer.write(model if result is None else result, path)
        elif form == "report":
            path.write_text(report.document_page(_result(model, run)).html, encoding="utf-8")
        elif form == "paper":
            written = report.write_document(_result(model, run), folder)
            if written.paper is None:
                raise InputError(written.note)
            path = written.paper
        else:
            moving, camera = _moving(model, run), "top" if model.dim == 2 else "iso"
            loaded = any(np.nan_to_num(one.arrays["member_force"].values).any() for one in moving.forces.values())
            colour = None if loaded else "kind"
            viewer.render(moving, path, size=FILM, fps=RATE, camera=camera, colour=colour, progress=progress)
        return path.read_bytes()


def _result(model: Model, run: str) -> RunResult:
    """The result of a run; of a drawing without runs that of a turn of its drives, or of its equilibrium."""
    if run or model.runs:
        name = run or next(iter(model.runs))
        if name not in model.runs:
            raise InputError(f"No run called {name!r}. There are: {', '.join(model.runs) or 'none'}.")
        if model.runs[name].motion is not None:
            raise InputError(f"{name!r} reads a file. Save the model, then: kinetruss run MODEL.yaml {name}")
        return runs.run(model, name)
    return runs.run(model.with_(runs={"motion": _own_run(model)}), "motion")


def _moving(model: Model, run: str) -> RunResult:
    if not run and (moving := [name for name, one in model.runs.items() if not one.analysis.startswith("statics.")]):
        run = moving[0]
    result = _result(model, run)
    if len(result.motion.time) < 2:
        raise InputError(f"{result.name} does not move: there is no film of it. Choose a run with a motion, or drive a bar.")
    return result


def _own_run(model: Model) -> Run:
    """A whole turn of the one drive if it can turn, else a small motion of all drives, or the equilibrium."""
    drives = model.all_drives
    if len(drives) == 1:
        ((name, drive),) = drives.items()
        if turns(drive):
            turn = ConstantRate(rates={name: 2 * math.pi / TURN}, duration=TURN)
            try:
                follow(model, turn, samples=73)
            except KinetrussError:
                pass
            else:
                return Run(trajectory=turn, samples=121)
    return Run(**new_run(_values(model)))


def _values(model: Model) -> dict[str, tuple[float, str]]:
    from kinetruss.mechanics import compile

    system = compile(model)
    starts = zip(system.drives, map(float, system.drive_start), strict=True)
    return {name: (value, "rad" if turns(model.all_drives[name]) else "m") for name, value in starts}


def python_of(data: Data, name: str) -> str:
    """The model as Python code that makes it again: its data as in the file, units too.

    >>> print(python_of({"kinetruss": 1, "nodes": {"A": [0, 0], "B": ["20 mm", 0]}, "bars": {"b": ["A", "B"]}}, "bar"))
    \"\"\"The model bar, from a drawing.\"\"\"
    <BLANKLINE>
    import kinetruss as kt
    <BLANKLINE>
    model = kt.Model(
        nodes={'A': [0, 0], 'B': ['20 mm', 0]},
        bars={'b': ['A', 'B']},
    )
    <BLANKLINE>
    """
    lines = [f'"""The model {name}, from a drawing."""', "", "import kinetruss as kt", "", "model = kt.Model("]
    for key, value in data.items():
        if key == "kinetruss":
            continue
        shown = pprint.pformat(value, width=110, sort_dicts=False)
        lines.append("    {}={},".format(key, shown.replace("\n", "\n    ")))
    return "\n".join([*lines, ")", ""])
