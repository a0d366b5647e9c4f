"""Linkages that were found: each a model in its first position, proved by following it; and what cannot be reached."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from kinetruss.errors import AnalysisError, InputError, shown
from kinetruss.kinematics.motions import follow
from kinetruss.kinematics.redundant import LEAST
from kinetruss.kinematics.synthesis.chains import PLACES
from kinetruss.model import AngleDrive, Bar, ConstantRate, Link, Model, Quintic, Run, Support

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from numpy.typing import NDArray

    from kinetruss.kinematics.synthesis.chains import Chains

Kind = Literal["four-bar", "slider-crank"]

SECONDS = 4.0
"""Duration of the run of a linkage."""

FLAT = 0.05
"""A coupler less wide than this fraction of its length runs along itself, a wider one around itself."""

APART = 1e-3
"""Least distance of two pins, of the size of the linkage."""

DIGITS = 15
"""Digits of a place, of the size of the linkage: those behind are round-off."""

STEPS = 90
"""Samples of the motion that is followed, between and beside those at the positions."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Linkage:
    """A linkage for a task.

    Attributes
    ----------
    model : in the first position. Bar `crank` A-B, link `coupler` through B, C and the point P, bar `rocker` D-C or a roller
        at C; drive ``motor`` turns the crank; run ``through`` moves it through the task.
    kind : ``four-bar`` or ``slider-crank``. type : by the rule of Grashof: crank-rocker, ...
    error : largest distance of P from what is asked, m. turn_error : largest angle of the coupler from what is asked, rad; nan
        where none is asked.
    transmission : smallest transmission angle along the motion, rad; pi/2 is best.
    size : longest link, m. angles (n,) : of the crank where P is nearest to what is asked, rad.
    """

    model: Model
    kind: str
    type: str
    error: float
    turn_error: float
    transmission: float
    size: float
    angles: NDArray[np.float64]

    def __str__(self) -> str:
        angle = math.degrees(self.transmission)
        good = f"transmission angle at least {angle:.0f} deg, longest link {self.size:.3g} m"
        return f"{self.type}, error {self.error:.3g} m, {good}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Linkages:
    """What was found, best first, and in words what was not.

    Iterating gives each `Linkage`. message : what cannot be reached, and why others were left out.
    """

    found: tuple[Linkage, ...]
    message: str

    def __iter__(self) -> Iterator[Linkage]:
        return iter(self.found)

    def __len__(self) -> int:
        return len(self.found)

    def __getitem__(self, at: int) -> Linkage:
        return self.found[at]

    def __str__(self) -> str:
        rows = [f"{k + 1}. {one}" for k, one in enumerate(self.found)]
        return "\n".join([*rows, self.message])


def check_kinds(kinds: Any) -> None:
    """Refuse kinds of linkages that there are not.

    Raises
    ------
    InputError : none, or an unknown one.
    """
    if isinstance(kinds, str) or not kinds or not set(kinds) <= set(get_args(Kind)):
        raise InputError(f"kinds: {shown(kinds)}, expected ('four-bar',), ('slider-crank',) or both.")


def proved(
    chains: Chains, at: int, angles: NDArray[np.float64], wanted: NDArray[np.complex128], turns: NDArray[np.complex128] | None,
    *, closed: bool, extra: Mapping[str, complex],
) -> Linkage | None:  # fmt: skip
    """One linkage as a model, followed through all crank angles (n,); None if it cannot be made, or does not come along.

    wanted (n,) : places of P, m. turns (n,) : directions of the coupler's own frame at B, unit numbers. closed : full turns.
    extra : further points of the coupler, from B along B -> C, m.
    """
    model = _model_of(chains[at : at + 1], angles, extra, closed=closed)
    if model is None:
        return None
    travel = angles[-1] - angles[0]
    sense, duration = math.copysign(1.0, travel), 2 * math.pi if closed else abs(travel)
    asked = abs(angles - angles[0])
    times = np.union1d(asked, np.linspace(0, duration, STEPS))
    try:
        motion = follow(model, ConstantRate(rates={"motor": sense}, duration=duration), times=times, least=LEAST)
    except (AnalysisError, InputError):
        return None
    places = motion.position.sel(node=["B", "C", "P"]).values[np.searchsorted(times, asked)]
    B, C, P = (places[..., 0] + 1j * places[..., 1]).T
    off = np.nan if turns is None else float(abs(np.angle((C - B) / turns)).max())
    every = np.angle(np.exp(1j * (angles[0] + sense * np.linspace(0, duration, PLACES))))
    return Linkage(
        model=model,
        kind="four-bar" if chains.along is None else "slider-crank",
        type=chains.words(at),
        error=float(abs(P - wanted).max()),
        turn_error=off,
        transmission=math.asin(min(1.0, float(chains[at : at + 1].transmission(every[None]).min()))),
        size=float(chains.size[at]),
        angles=angles,
    )


def _model_of(one: Chains, angles: NDArray[np.float64], extra: Mapping[str, complex], *, closed: bool) -> Model | None:
    """The model of one linkage at the first of its crank angles; None if two of its pins coincide."""
    B, turn, P = (complex(values[0, 0]) for values in one.moved(angles[None, :1]))
    coupler = {"B": B, "C": B + float(one.h[0]) * turn, "P": P} | {name: B + point * turn for name, point in extra.items()}
    links = [one.a[0], *([] if one.along is not None else [one.r[0]])]
    if min(*links, *(abs(p - q) for p, q in combinations(coupler.values(), 2))) < APART * one.size[0]:
        return None
    digits = DIGITS - math.ceil(math.log10(one.size[0]))
    start, travel = float(np.angle(np.exp(1j * angles[0]))), float(angles[-1] - angles[0])
    run = ConstantRate(rates={"motor": math.copysign(2 * math.pi / SECONDS, travel)}, duration=SECONDS) if closed else Quintic(
        moves={"motor": (start, start + travel)}, duration=SECONDS
    )  # fmt: skip
    ground: dict[str, Any] = (
        {"fixed": ["A", "D"]}
        if one.along is None
        else {"fixed": ["A"], "supports": {"C": Support(y="held", turned=float(np.angle(one.along[0])))}}
    )
    rocker = {"rocker": Bar(ends=("D", "C"))} if one.along is None else {}
    places = {"A": complex(one.A[0])} | coupler | ({"D": complex(one.D[0])} if one.along is None else {})
    return Model(
        nodes={name: (round(place.real, digits), round(place.imag, digits)) for name, place in places.items()},
        bars={"crank": Bar(ends=("A", "B"))} | rocker,
        links={"coupler": Link(nodes=_around(coupler))},
        drives={"motor": AngleDrive("crank")},
        runs={"through": Run(trajectory=run)},
        **ground,
    )


def _around(places: Mapping[str, complex]) -> tuple[str, ...]:
    """The pins of a coupler in the order in which it runs through them: around, or along if it is thin."""
    at = np.array(list(places.values()))
    at = at - at.mean()
    way = np.exp(0.5j * np.angle((at**2).sum()))  # the principal axis
    along, across = (at / way).real, (at / way).imag
    if np.ptp(across) < FLAT * np.ptp(along):
        return tuple(list(places)[k] for k in np.argsort(along))
    names = tuple(list(places)[k] for k in np.argsort(np.angle(at)))
    return (*names, names[0])
