"""Runs that a page has asked for, by name or by key frames, and the pages of their results."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

from kinetruss import runs
from kinetruss.errors import InputError, KinetrussError
from kinetruss.kernels.compiled.jit import keeper
from kinetruss.model import Model, Quintic, Run, Spline, nearest
from kinetruss.model.runs import MISSION
from kinetruss.runs import MissionRun, RunResult
from kinetruss.runs.doubts import remarks
from kinetruss.studio.poses import number
from kinetruss.studio.taken import File, Form, taken
from kinetruss.viewer import page, scene

if TYPE_CHECKING:
    from kinetruss.results import Forces
    from kinetruss.studio.edits import Data


Finite = Annotated[float, Field(allow_inf_nan=False, ge=-1e15, le=1e15)]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Values = Annotated[dict[Name, Finite], Field(max_length=10_000)]


class KeyFrame(BaseModel):
    """Drive values at a time, s."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    time: Annotated[Finite, Field(ge=0, le=1e6)]
    values: Values


FrameList = Annotated[tuple[KeyFrame, ...], Field(max_length=500)]
_FRAMES: TypeAdapter[tuple[KeyFrame, ...]] = TypeAdapter(FrameList)


def frames_of(rows: Any) -> tuple[KeyFrame, ...]:
    """Key frames from plain data.

    Raises
    ------
    ValueError : they are none.
    """
    return _FRAMES.validate_python(rows)


# Runs of key frames.

NAME = "studio"
"""Name of the trajectory and of the run made from key frames."""


def way_of(frames: Sequence[KeyFrame], start: Mapping[str, float]) -> Quintic | Spline:
    """The trajectory through key frames; drives that a frame does not name keep the value of the previous frame.

    Two frames: a quintic move from rest to rest. More: a spline through all of them (with three, and the points half-way
    between them).
    """
    ordered = sorted(frames, key=lambda frame: frame.time)
    if len(ordered) < 2:
        raise InputError("Set at least two key frames, at different times.")
    times = [frame.time - ordered[0].time for frame in ordered]
    if any(b - a < 1e-6 for a, b in pairwise(times)):
        raise InputError("Two key frames have the same time. Give them different times.")
    rows, last = [], dict(start)
    for frame in ordered:
        last = last | {name: value for name, value in frame.values.items() if name in start}
        rows.append(last)
    if len(rows) == 2:
        return Quintic(moves={name: (rows[0][name], rows[1][name]) for name in start}, duration=times[1])
    t = np.array(times)
    if len(t) == 3:
        t = np.insert(t, [1, 2], (t[:-1] + t[1:]) / 2)
    values = {name: tuple(np.interp(t, times, [row[name] for row in rows]).tolist()) for name in start}
    return Spline(times=tuple(t.tolist()), values=values, largest_gap=1e9)


def with_way(model: Model, way: Quintic | Spline, samples: int = 201) -> Model:
    """The model with the key frames as a trajectory and a run, both called ``studio``."""
    run = Run(trajectory=NAME, samples=samples)
    return model.with_(trajectories={**model.trajectories, NAME: way}, runs={**model.runs, NAME: run})


def travelled(model: Model, frames: Sequence[KeyFrame], start: Mapping[str, float], samples: int) -> RunResult:
    """The run of key frames: motion, forces of all load cases, margins, motor demand."""
    if not start:
        raise InputError("This model has no drive that could follow key frames.")
    model = with_way(model, way_of(frames, start), samples)
    check(model, NAME)
    return runs.run(model, NAME)


def worst_rows(result: RunResult, most: int = 12) -> list[dict[str, Any]]:
    """The worst instants of a run: rule, member, utilisation and time; highest utilisation first.

    Then the largest tension and compression, and the pose nearest to a singularity.
    """
    table = () if result.verdict is None else result.verdict.table()
    rows = [
        _row(row.rule, row.member, row.value, row.unit, row.time, row.load_case, row.utilisation)
        for row in table
        if row.checked
    ]
    for case, demand in result.demand.items():
        data = demand.data
        for k, name in enumerate(data["active"].values):
            for q, what in enumerate(data["quantity"].values):
                used, value, time = (float(data[column].values[k, q]) for column in ("utilisation", "value", "time_of"))
                if np.isfinite(used):
                    rows.append(_row(what, name, value, data["unit"].values[q], time, case, used))
    rows.sort(key=lambda row: -float(row["used"]))
    return rows[:most] + _largest(result)


def _row(what: Any, member: Any, value: float, unit: Any, time: float, case: str, used: float | None) -> dict[str, Any]:
    """One row for JSON; a utilisation above Euler's load is infinite."""
    share = "Infinity" if used is not None and not np.isfinite(used) else used
    row = {"what": str(what), "member": str(member), "used": share, "value": number(value), "unit": str(unit)}
    return row | {"time": number(time), "case": case}


def _largest(result: RunResult) -> list[dict[str, Any]]:
    found = []
    for case, forces in result.forces.items():
        N, time, names = (forces.arrays[name].values for name in ("member_force", "time", "member"))
        for what, at in (("largest tension", N.argmax()), ("largest compression", N.argmin())):
            t, k = np.unravel_index(at, N.shape)
            found.append(_row(what, names[k], N[t, k], "N", time[t], case, None))
    gauge, time = (result.motion.arrays[name].values for name in ("singularity", "time"))
    if np.isfinite(gauge).any():
        weak = int(np.nanargmin(gauge))
        found.append(_row("nearest to singular", "", gauge[weak], "", time[weak], "", None))
    return found


# What a page is told while its answer takes long.

LATELY = 1.0
"""Seconds after a kernel within which the next one is expected."""


class Busy:
    """What is done since it was made, in words."""

    def __init__(self) -> None:
        self.began, self.before, self.spent = time.monotonic(), keeper.progress.count, keeper.progress.seconds

    def compiling(self) -> str:
        """How much was compiled; empty where nothing is compiled now."""
        found = keeper.progress
        if not found.at_work and (found.changed < self.began or found.clock() - found.changed > LATELY):
            return ""
        count, seconds = found.count - self.before, found.seconds - self.spent
        return f"Compiling (first start only): {count} kernel{'' if count == 1 else 's'}, {seconds:.0f} s"

    def text(self) -> str:
        """What is done, and for how long."""
        seconds = int(time.monotonic() - self.began)
        return self.compiling() or (f"Computing: {seconds} s" if seconds else "Computing ...")


# Runs that a page has asked for, and the pages of their results.

MOST = 4
"""Number of result pages that are kept; each holds a whole scene."""

MOST_VALUES = 4_000_000
"""Largest product of samples and members of a run from the page."""

PARTS = 50
"""Number of blocks of a run: its progress is known, and it can be stopped, after each of them."""

SMALLEST = 50
"""Samples of a block of a prescribed motion; fewer would take longer."""

SOON = 0.25
"""Seconds that the answer waits for a short run."""

LEFT = 2
"""Largest number of stopped runs that have not reached the end of their block."""

log = logging.getLogger(__name__)


class StoppedError(Exception):
    """A run that the page has stopped."""


@dataclass(eq=False)
class Work:
    """A run that is computed beside the messages.

    what : the items that are done, of all of them (0: not known yet). answer : what the page gets at its end.
    form : of the file that is made; empty for a run.
    """

    name: str
    revision: int
    total: int = 0
    what: str = "samples"
    done: int = 0
    busy: Busy = field(default_factory=Busy, repr=False)
    stopped: bool = False
    answer: dict[str, Any] | None = None
    form: str = ""
    thread: threading.Thread | None = field(default=None, repr=False)

    def progress(self, done: int, total: int) -> None:
        """Note what is done; ends the run if it was stopped."""
        if self.stopped:
            raise StoppedError
        self.done, self.total = done, total

    def record(self) -> dict[str, Any]:
        """How far it is, or its end."""
        if self.answer is not None:
            return self.answer
        return {
            "kind": "running",
            "name": self.name,
            "done": self.done,
            "total": self.total,
            "what": self.what,
            "note": self.busy.compiling(),
            "revision": self.revision,
            "form": self.form,
        }


class Results:
    """The run that is computed, and the pages of the last results, by number."""

    def __init__(self) -> None:
        self.pages: dict[int, str | File] = {}
        self.count = 0
        self.work: Work | None = None
        self.left: list[Work] = []
        self.lock = threading.Lock()

    def start(self, model: Model, name: str, revision: int = 0) -> dict[str, Any]:
        """Begin a run of the model; the record of its end if that comes soon. revision : of the drawing, kept in the records.

        Raises
        ------
        InputError : no such run, one that cannot be done from the page, or another one is computed.
        """
        check(model, name)
        run = model.runs[name]
        pairs = run.analysis == MISSION  # how many there are is known once they are spread
        work = Work(name, revision, *((0, "pairs") if pairs else (run.samples, "samples")))
        return self._begin(work, partial(self._result, work, model))

    def make(
        self, form: Form, model: Model, data: Data, text: str, name: str, run: str, revision: int = 0,
        pose: Forces | None = None,
    ) -> dict[str, Any]:  # fmt: skip
        """Begin to make a file of a drawing; the record of its end if that comes soon. The arguments are those of `taken`.

        Raises
        ------
        InputError : another one, or a run, is computed.
        """
        work = Work(name, revision, 0, "pictures", form=form)
        return self._begin(work, lambda: self._made(work, taken(form, model, data, text, name, run, work.progress, pose)))

    def _begin(self, work: Work, do: Callable[[], dict[str, Any]]) -> dict[str, Any]:
        with self.lock:
            if self.work is not None and self.work.answer is None:
                what = "file" if self.work.form else "run"
                raise InputError(f"The {what} {self.work.name!r} is being computed. Stop it, or wait for its end.")
            self.left = [one for one in self.left if one.answer is None]
            if len(self.left) >= LEFT:
                raise InputError(
                    f"Stopped runs are still busy ({len(self.left)}). Wait for the end of their step, then try again."
                )
            self.work = work
        work.thread = threading.Thread(target=self._do, args=(work, do), daemon=True)
        work.thread.start()
        work.thread.join(SOON)
        return work.record()

    def running(self) -> dict[str, Any] | None:
        """How far the run is, or its end; None if there was none, or it was stopped."""
        work = self.work
        return None if work is None else work.record()

    def stop(self) -> dict[str, Any]:
        """Give up the run; it ends after the block of samples that is computed now.

        Raises
        ------
        InputError : nothing is computed.
        """
        with self.lock:
            work = self.work
            if work is None or work.answer is not None:
                raise InputError("No run is being computed.")
            work.stopped, self.work = True, None
            self.left.append(work)
        return {"kind": "stopped", "name": work.name, "done": work.done, "total": work.total}

    def close(self, patience: float) -> None:
        """Give up all that is computed, and wait so many seconds for the end of each step."""
        with self.lock:
            works = [*self.left, *([] if self.work is None else [self.work])]
        for work in works:
            work.stopped = True
        for work in works:
            if work.thread is not None:
                work.thread.join(patience)

    def _do(self, work: Work, do: Callable[[], dict[str, Any]]) -> None:
        try:
            found = do()
        except StoppedError:
            found = {"kind": "stopped"}
        except KinetrussError as error:
            found = {"kind": "error", "message": str(error)}
        except Exception as error:
            log.exception("a run of the page failed")
            found = {"kind": "error", "message": f"This could not be done: {type(error).__name__}."}
        work.answer = found | {"name": work.name, "revision": work.revision, "form": work.form}

    def _result(self, work: Work, model: Model) -> dict[str, Any]:
        """Do the run and keep its page."""
        run = model.runs[work.name]
        least = 1 if run.analysis == "dynamics.simulate" else SMALLEST
        result = runs.run(model, work.name, progress=work.progress, block=max(least, -(-run.samples // PARTS)))
        found = result.finding
        words = [_done(result), found.text, found.governs, *found.more, *found.doubts, remarks(result)]
        shown, title = _shown(result)
        number = None if shown is None else self._kept(page(scene(shown), title=f"{model.title or 'Drawing'}: {title}"), work)
        return {"kind": "ran", "words": "\n".join(filter(None, words)), "number": number}

    def _made(self, work: Work, file: File) -> dict[str, Any]:
        return {"kind": "taken", "number": self._kept(file, work), "file": file.name, "bytes": len(file.content)}

    def _kept(self, text: str | File, work: Work) -> int:
        with self.lock:
            if work.stopped:
                raise StoppedError
            self.count += 1
            self.pages[self.count] = text
            for old in list(self.pages)[:-MOST]:
                del self.pages[old]
            return self.count


def check(model: Model, name: str) -> None:
    """Raises an InputError for a run that the page cannot do."""
    if name not in model.runs:
        raise InputError(f"No run called {name!r}. {nearest(name, model.runs)}")
    run = model.runs[name]
    for one in (run, *(model.runs[other] for other in run.motions if other in model.runs)):
        if one.motion is not None:
            raise InputError(f"{name!r} reads a file. Save the model, then: kinetruss run MODEL.yaml {name}")
        if one.samples * len(model.members) > MOST_VALUES:
            raise InputError(f"{name!r} is too long for this page: {one.samples} samples. Take fewer samples.")


def _done(result: RunResult) -> str:
    """What was done of what was asked."""
    if not isinstance(result, MissionRun):
        return f"{len(result.motion.time)} of {result.samples} samples."
    possible = int((result.pairs["samples"].values > 0).sum())
    return f"{possible} of {result.good} pairs of motion, condition and load case can be done."


def _shown(result: RunResult) -> tuple[RunResult | None, str]:
    """The run whose page shows a result: of a mission its governing pair; None if nothing could be done."""
    if not isinstance(result, MissionRun):
        return (result if len(result.motion.time) else None), result.name
    if not (result.pairs["samples"].values > 0).any():
        return None, result.name
    worst = runs.governing(result)
    label = result.pairs["label"].values[0 if result.governing is None else result.governing]
    return worst, f"{result.name}, governing pair {label}"
