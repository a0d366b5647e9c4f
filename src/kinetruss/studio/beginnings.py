"""Drawings to begin with: examples, mechanisms of the library, and a few of their own."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.io import read
from kinetruss.io.emitting import plain_model
from kinetruss.io.writing import text_of
from kinetruss.library import build, example_files
from kinetruss.library.example_texts import SCHEMA
from kinetruss.model import Model, nearest
from kinetruss.studio.small_pictures import small_picture

FOLDER = Path(__file__).parent / "starters"


@dataclass(frozen=True)
class Starter:
    """A drawing to begin with.

    name : short. words : what it shows. source : an example (`example:NAME`), a mechanism of the library (`library:BUILDER`),
    or a file of the folder `starters`.
    """

    name: str
    words: str
    source: str


STARTERS = {
    one.name: one
    for one in (
        Starter("Four-bar", "a crank turns, a rocker swings", "example:four_bar"),
        Starter("Slider-crank", "turning to sliding", "library:mechanisms.slider_crank"),
        Starter("Six-bar", "Watt's, of two loops", "library:mechanisms.watt_six_bar"),
        Starter("Scissor lift", "a cylinder between its legs", "example:scissor_lift"),
        Starter("Excavator", "boom, stick and bucket", "excavator"),
        Starter("Loader crane", "two cylinders", "example:loader_crane"),
        Starter("Wiper", "one motor, two blades", "example:wiper"),
        Starter("Press", "a toggle and a workpiece", "example:press"),
        Starter("Pantograph", "draws twice as large", "pantograph"),
        Starter("Peaucellier", "an exact straight line", "example:peaucellier"),
        Starter("Chebyshev", "nearly a straight line", "library:mechanisms.chebyshev"),
        Starter("Jansen's leg", "a crank walks", "example:jansen_leg"),
        Starter("Hoberman's ring", "opens and closes", "hoberman"),
        Starter("Bennett's loop", "four skew hinges", "library:mechanisms.bennett"),
        Starter("Double pendulum", "swings, chaotically", "example:double_pendulum"),
        Starter("Truss bridge", "forces under its lane", "truss_bridge"),
        Starter("Crane of trusses", "two active chords", "example:planar_crane"),
        Starter("Landing gear", "a drop test", "example:landing_gear"),
        Starter("Stewart platform", "six legs", "example:stewart"),
        Starter("Delta robot", "three arms, six rods", "example:delta"),
        Starter("Double wishbone", "a wheel of a car", "example:double_wishbone"),
        Starter("Adaptive truss", "octahedra with active battens", "example:double_octahedral_slew"),
    )
}


@cache
def starter(name: str) -> tuple[Model, str]:
    """The model of a starter and its text.

    Raises
    ------
    InputError : there is none of this name.
    """
    if name not in STARTERS:
        raise InputError(f"No drawing to begin with is called {name!r}. {nearest(name, STARTERS)}")
    kind, _, place = STARTERS[name].source.rpartition(":")
    if kind == "library":
        model = build(place)
        return model, text_of(plain_model(model))
    file = example_files()[place][0] if kind else FOLDER / f"{place}.yaml"
    text = file.read_text(encoding="utf-8")
    first, _, rest = text.partition("\n")
    return read(file), rest if first.startswith(SCHEMA) else text


@cache
def pictures() -> tuple[dict[str, Any], ...]:
    """All starters with their small pictures."""
    return tuple(
        {"name": name, "words": one.words, "picture": small_picture(starter(name)[0])} for name, one in STARTERS.items()
    )
