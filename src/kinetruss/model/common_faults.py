"""Faults of many cross-checks: an unknown name, a vector of another dimension."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from kinetruss.errors import Fault, shown
from kinetruss.model.words import SECTIONS, nearest
from kinetruss.shelves import shelf

# tables that may define a name of each kind
_TABLES = {
    "node": ("nodes",),
    "member": ("bars", "active"),
    "body": ("bodies",),
    "section": ("sections",),
    "material": ("materials",),
    "screw": ("screws",),
    "gear": ("gears",),
    "motor": ("motors",),
    "amplifier": ("amplifiers",),
    "load": ("loads",),
    "load case": ("load_cases",),
    "trajectory": ("trajectories",),
    "condition": ("conditions",),
    "run or trajectory": ("runs", "trajectories"),
    "drive": ("drives", "bars", "active"),
    "coordinate": ("drives", "bars", "active"),
    "drive or pose coordinate": ("drives", "bars", "active"),
}


def unknown(what: str, name: str, known: Iterable[str], path: tuple[Any, ...]) -> Fault:
    """The fault of an unknown name, with the most similar ones, those of the library included."""
    known = [*known, *(one for table in _TABLES[what] for one in shelf(table) if one not in known)]
    about = [(table, name) for table in _TABLES[what]]
    if what == "drive or pose coordinate":
        about.append(("poses", name.rpartition(".")[0]))
    mend = nearest(name, known)
    if what == "section" and not mend.startswith("Did"):
        mend = f"{SECTIONS} By name, {mend[0].lower()}{mend[1:]}"
    return Fault(path, f"no {what} called {shown(name)}.", mend, about=tuple(about))


def components(vector: Sequence[float] | None, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:
    """The fault of a vector with more or fewer components than the model has axes."""
    if vector is not None and len(vector) != dim:
        yield Fault(path, f"has {len(vector)} components, the model has {dim} axes.", f"Give {dim}.", about=(("nodes",),))


def a_bar(kind: str) -> str:
    """A bar of this kind in words: ``a cable``, ``an elastic bar``, ``a free bar``."""
    return "a cable" if kind == "cable" else f"{'an' if kind == 'elastic' else 'a'} {kind} bar"


def other_quantity(place: tuple[Any, ...], field: str, given: str, kind: str) -> Fault:
    """A length where an angle is moved, or the other way round."""
    what, wanted = (f"{'an' if one == 'angle' else 'a'} {one}" for one in (given, kind))
    per = "/s" if field == "rates" else ""
    mend = f"Write for example {('10 deg' if kind == 'angle' else '1.2 m') + per!r}."
    return Fault(place, f"is given as {f'a rate of {given}' if per else what}, but {place[-1]!r} is {wanted}.", mend)
