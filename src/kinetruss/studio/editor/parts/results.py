"""Runs that a page has asked for, and the pages of their results."""

from __future__ import annotations

import logging
import threading
from dataclasses import dataclass, field
from typing import Any

from kinetruss import runs
from kinetruss.errors import InputError, KinetrussError
from kinetruss.model import Model, nearest
from kinetruss.model.motion import MISSION
from kinetruss.runs import MissionRun, RunResult
from kinetruss.strength.verdict import headline
from kinetruss.studio._busy import Busy
from kinetruss.viewer import page, scene

__all__ = ["Results"]

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
    """

    name: str
    revision: int
    total: int = 0
    what: str = "samples"
    done: int = 0
    busy: Busy = field(default_factory=Busy, repr=False)
    stopped: bool = False
    answer: dict[str, Any] | None = None
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
        }


class Results:
    """The run that is computed, and the pages of the last results, by number."""

    def __init__(self) -> None:
        self.pages: dict[int, str] = {}
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
        with self.lock:
            if self.work is not None and self.work.answer is None:
                raise InputError(f"The run {self.work.name!r} is being computed. Stop it, or wait for its end.")
            self.left = [one for one in self.left if one.answer is None]
            if len(self.left) >= LEFT:
                raise InputError(
                    f"Stopped runs are still busy ({len(self.left)}). Wait for the end of their step, then try again."
                )
            run = model.runs[name]
            pairs = run.analysis == MISSION  # how many there are is known once they are spread
            work = self.work = Work(name, revision, *((0, "pairs") if pairs else (run.samples, "samples")))
        work.thread = threading.Thread(target=self._do, args=(work, model), daemon=True)
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

    def _do(self, work: Work, model: Model) -> None:
        try:
            found = self._result(work, model)
        except StoppedError:
            found = {"kind": "stopped"}
        except KinetrussError as error:
            found = {"kind": "error", "message": str(error)}
        except Exception as error:
            log.exception("a run of the page failed")
            found = {"kind": "error", "message": f"The run could not be done: {type(error).__name__}."}
        work.answer = found | {"name": work.name, "revision": work.revision}

    def _result(self, work: Work, model: Model) -> dict[str, Any]:
        """Do the run and keep its page."""
        run = model.runs[work.name]
        least = 1 if run.analysis == "dynamics.simulate" else SMALLEST
        result = runs.run(model, work.name, progress=work.progress, block=max(least, -(-run.samples // PARTS)))
        found = headline(result.verdict, result.demand).record
        words = [_done(result), found["text"], *found["more"], result.message]
        if found["governing"] is not None:
            words.insert(2, found["governing"]["text"])
        shown, title = _shown(result)
        number = None if shown is None else self._kept(page(scene(shown), title=f"{model.title or 'Drawing'}: {title}"), work)
        return {"kind": "ran", "words": "\n".join(filter(None, words)), "number": number}

    def _kept(self, text: str, work: Work) -> int:
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
