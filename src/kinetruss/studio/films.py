"""What a drawing shows beside itself: motions to be played, and diagrams over it or over a pose of the motion."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError, UnitError
from kinetruss.model import turns
from kinetruss.strength.curves import curves, factor_of, only, sentence
from kinetruss.studio import sweeps
from kinetruss.studio.let_go import kept, let_go
from kinetruss.studio.shown import framed, places_of
from kinetruss.units import parse

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from kinetruss.model import Model
    from kinetruss.results import Forces
    from kinetruss.strength.curves import Curve
    from kinetruss.studio.edits import Data
    from kinetruss.studio.motions import Asked, Compute
    from kinetruss.studio.shown import Record, Shown

    Answer = bytes | Record


UNKNOWN = "The motion is not known any more. Play it again."


def film_of(session: Shown, drives: Sequence[str], rate: float | str | None, at_speed: bool, strength: bool) -> Answer:
    """A motion of drives through their range; the answer of `motion_of`."""
    with session.lock:
        model, position = session.closed()
        forces, revision = session.drawing.found.forces, session.drawing.revision
    first = next((model.all_drives.get(name) for name in drives), None)  # `swept` refuses a drive that is not there
    wanted = None if rate is None or first is None else _rate(rate, turns(first))
    bent = forces is not None and not np.array_equal(forces.motion.whole["position"].values[0], position)
    if bent and at_speed:
        raise InputError("Parts that bend or stretch are shown in equilibrium, at rest. Their inertia needs a run.")

    def compute(look: Callable[[], None]) -> sweeps.Film:
        found = sweeps.swept(model, position, drives, rate=wanted, samples=sweeps.FEWEST if bent else sweeps.SAMPLES)
        look()
        return sweeps.film(sweeps.settled(found, model, look) if bent else found, model, at_speed)

    asked = (revision, "sweep", tuple(drives), wanted, at_speed, bent)
    return _begun(session, asked, compute, model if strength else None, bent=bent)


def fall_of(session: Shown, held: bool, strength: bool) -> Answer:
    """The motion of a drawing that is let go, like that of its drives."""
    with session.lock:
        (model, position), revision = session.closed(), session.drawing.revision
    compute = partial(let_go, model, position, held)
    return _begun(session, (revision, "let go", held), compute, model if strength else None)


def fallen(session: Shown, sample: int) -> Data:
    """The data of a drawing in the pose of a sample of the motion that was let go last.

    Raises
    ------
    InputError : another motion was played last; the pose cannot be drawn.
    """
    return kept(session.drawing.state.data, session.closed()[0], _played(session, sample), sample)


def pose_of(session: Shown, sample: int) -> Forces:
    """The motion and the forces of a sample of the motion that was played last.

    Raises
    ------
    InputError : it is not known any more.
    """
    return only(_played(session, sample).forces, sample)


def _played(session: Shown, sample: int) -> sweeps.Film:
    film = session.motions.of(session.drawing.revision)
    if film is None or sample >= len(film.arrays["time"]):
        raise InputError(UNKNOWN)
    return film


def _begun(session: Shown, asked: Asked, compute: Compute, judged: Model | None, *, bent: bool = False) -> Answer:
    """The answer of `motion_of` to a new request. judged : the model whose strength is asked for."""
    more = {"kind": "sweep", "revision": asked[0], "bent": bent}

    def named(look: Callable[[], None]) -> sweeps.Film:
        film = compute(look)
        return film._replace(header=more | film.header)

    judge = None if judged is None else partial(sweeps.with_strength, model=judged)
    return motion_of(session, session.motions.begin(asked, named, judge))


def motion_of(session: Shown, number: int) -> Answer:
    """A motion that was asked for: names and words in the header, float32 arrays over time after it.

    A record instead: it is still computed, or it is not the motion of this drawing, or not the newest request.
    """
    film = session.motions.answer(number)
    if isinstance(film, dict):
        return film
    blocks = {name: np.ascontiguousarray(values, "<f4") for name, values in film.arrays.items()}
    table = {name: list(values.shape) for name, values in blocks.items()}
    return framed(film.header | {"arrays": table}, *(values.tobytes() for values in blocks.values()))


def _rate(given: float | str, turning: bool) -> float:
    """A rate of a drive, rad/s or m/s."""
    kind, example = ("an angular rate", "60 deg/s or 10 rpm") if turning else ("a speed", "50 mm/s or 0.1 m/s")
    try:
        return float(parse(given, kind.split(" ", 1)[1]))
    except UnitError:
        raise InputError(f"{given!r} is not {kind}. Write for example {example}.") from None


EACH = 4
"""Of so many places of a curve a page gets one, besides its extremes."""


def over_of(session: Shown, show: str, sample: int | None) -> Record:
    """Section forces or the deflection of all loads over the drawing: curves in m, with the factor by which values are drawn;
    or why there are none. sample : of the motion that was played last; None for the pose that is drawn.
    """
    found, forces = session.drawing.found, session.drawing.found.forces
    record: Record = {"kind": "over", "show": show, "curves": [], "why": found.why or "There are no forces."}
    try:
        forces = forces if sample is None else pose_of(session, sample)
        if found.model is None or forces is None:
            return record
        every = curves(found.model, forces, show, from_model=sample is None)
    except InputError as error:
        return record | {"why": str(error)}
    extent = float(np.linalg.norm(np.ptp(list(places_of(session.drawing).values()), axis=0)))
    return record | {
        "why": "" if every.largest else f"{sentence(every)}; zero everywhere.",
        "unit": every.quantity.unit,
        "sentence": sentence(every),
        "factor": factor_of([every], extent),
        "curves": [_points(one) for one in every.curves if one.values.any()],
    }


def _points(one: Curve) -> Record:
    """Some of the places of a curve, and all that are written."""
    kept = sorted({*range(0, len(one.x), EACH), len(one.x) - 1, *one.extremes})
    space = [np.pad(values[kept], ((0, 0), (0, 3 - values.shape[1]))).tolist() for values in (one.base, one.shift)]
    return {
        "part": one.part,
        "base": space[0],
        "shift": space[1],
        "values": one.values[kept].tolist(),
        "extremes": [kept.index(k) for k in one.extremes],
    }
