"""The motion that a drawing plays: computed beside what else is done, for the newest request, and kept with its forces."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError, KinetrussError
from kinetruss.studio.requested_runs import Busy, StoppedError

if TYPE_CHECKING:
    from kinetruss.studio.sweeps import Film

WAIT = 0.1
"""Seconds that an answer waits for a motion; what else a page asks for waits as long."""

CHANGED = "The drawing has changed since this motion was asked for. Play it again."
NEWER = "Another motion was asked for since. Play it again."

Asked = tuple[object, ...]
"""What motion is asked for, and of which revision of the drawing, which is its first entry."""

Compute = Callable[[Callable[[], None]], "Film"]
"""Computes a motion from a function that it calls now and then, and which ends it where it is not wanted any more."""

log = logging.getLogger(__name__)


@dataclass(eq=False)
class _Request:
    """What is computed for one or several pages, and what came of it: a film, or an error, or nothing if it was stopped."""

    number: int
    asked: Asked
    strength: bool
    found: Film | KinetrussError | None = None
    done: threading.Event = field(default_factory=threading.Event)
    busy: Busy = field(default_factory=Busy)


class Motions:
    """The motions of a drawing. revision : the present one of the drawing.

    A newer request stops the one before, and so does a change of the drawing; nothing of these is kept or shown.
    """

    def __init__(self, revision: Callable[[], int]) -> None:
        self.revision = revision
        self._played: tuple[Asked, Film] | None = None  # the last one that was computed, without its strength
        self._last = _Request(0, (), strength=False)
        self._last.done.set()
        self._thread: threading.Thread | None = None  # of the newest request; those before it are waited for
        self._lock = threading.Lock()

    def begin(self, asked: Asked, compute: Compute, judge: Callable[[Film], Film] | None) -> int:
        """Begin to compute a motion, or take the one that is known; the number with which its answer is asked for.

        judge : gives a film its strength, if that is asked for.
        """
        with self._lock:
            before, strength = self._last, judge is not None
            if (before.asked, before.strength) == (asked, strength) and not isinstance(before.found, KinetrussError):
                return before.number
            request = self._last = _Request(before.number + 1, asked, strength)

        def look() -> None:
            if self._last is not request or self.revision() != asked[0]:
                raise StoppedError

        def work() -> Film:
            before.done.wait()  # one at a time
            look()
            played = self._played
            if played is None or played[0] != asked:
                played = asked, compute(look)
                look()
                self._played = played
            return played[1] if judge is None else judge(played[1])

        self._thread = threading.Thread(target=self._do, args=(request, work), daemon=True)
        self._thread.start()
        return request.number

    def answer(self, number: int) -> Film | dict[str, Any]:
        """The film of a request; or that it is still computed, or that it is that of another drawing or another motion.

        Raises
        ------
        KinetrussError : those of the computation.
        """
        request = self._last
        if request.number != number:
            return {"kind": "replaced", "message": NEWER}
        if self.revision() == request.asked[0] and not request.done.wait(WAIT):
            return {"kind": "computing", "number": number, "text": request.busy.text()}
        if request.found is None or self.revision() != request.asked[0]:
            return {"kind": "replaced", "message": CHANGED if self._last is request else NEWER}
        if isinstance(request.found, KinetrussError):
            raise request.found
        return request.found

    def of(self, revision: int) -> Film | None:
        """The motion that was computed last, if it is that of a revision of the drawing."""
        return self._played[1] if self._played is not None and self._played[0][0] == revision else None

    def close(self, patience: float) -> None:
        """Give up what is computed, and wait so many seconds for the end of its step."""
        with self._lock:
            self._last = _Request(self._last.number + 1, (), strength=False)
            self._last.done.set()
        if self._thread is not None:
            self._thread.join(patience)

    def _do(self, request: _Request, work: Callable[[], Film]) -> None:
        try:
            request.found = work()
        except StoppedError:
            pass
        except KinetrussError as error:
            request.found = error
        except Exception as error:
            log.exception("a motion could not be computed")
            request.found = InputError(f"This could not be done: {type(error).__name__}. The model is unchanged.")
        finally:
            request.done.set()
