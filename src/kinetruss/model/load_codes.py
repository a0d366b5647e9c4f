"""Rules of standards for combinations of load cases: which act together, and with which factors.

EN 1990:2002, Eurocode: Basis of structural design, for buildings. Equations 6.10, 6.10a and 6.10b (persistent and transient
design situations) with gamma and xi of table A1.2(B); 6.14b (characteristic), 6.15b (frequent) and 6.16b (quasi-permanent
combination); psi of table A1.1. All are the recommended values: national annexes may set others.

ASCE/SEI 7-16, Minimum Design Loads and Associated Criteria for Buildings and Other Structures. Strength design: 2.3.1, and
2.3.6 with seismic effects; allowable stress design: 2.4.1, and 2.4.5 with seismic effects. Without fluid, flood, ice and
self-straining loads, and without the exceptions that allow smaller factors.

Variable actions that are favourable are left out: of each combination there is one for every subset of them that can act
together.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import product
from typing import Literal, NamedTuple

Psi = tuple[float, float, float]

PERMANENT = "permanent"
PSI: dict[str, Psi] = {
    "imposed A": (0.7, 0.5, 0.3),
    "imposed B": (0.7, 0.5, 0.3),
    "imposed C": (0.7, 0.7, 0.6),
    "imposed D": (0.7, 0.7, 0.6),
    "imposed E": (1.0, 0.9, 0.8),
    "imposed F": (0.7, 0.7, 0.6),
    "imposed G": (0.7, 0.5, 0.3),
    "imposed H": (0.0, 0.0, 0.0),
    "snow": (0.5, 0.2, 0.0),
    "snow above 1000 m": (0.7, 0.5, 0.2),
    "wind": (0.6, 0.2, 0.0),
    "temperature": (0.6, 0.5, 0.0),
}
"""Category -> psi_0, psi_1, psi_2 (EN 1990:2002, table A1.1, recommended values). Imposed loads: A dwellings, B offices, C
congregation, D shops, E storage, F vehicles up to 30 kN, G vehicles from 30 kN to 160 kN, H roofs. Snow: sites up to 1000 m,
and above; those of Finland, Iceland, Norway and Sweden have the values of sites above.
"""

DEAD = "D"
ASCE = {
    "L": "live load",
    "Lr": "roof live load",
    "S": "snow load",
    "R": "rain load",
    "W": "wind load",
    "E": "horizontal seismic load effect E_h",
    "Ev": "vertical seismic load effect E_v",
}
"""Categories of ASCE 7-16 besides the dead load D."""

Equation = Literal["6.10", "6.10ab", "6.14b", "6.15b", "6.16b"]
Method = Literal["LRFD", "ASD"]


class Combined(NamedTuple):
    """factors : case -> factor, without those that are 0. clause : of the standard. leading : the variable action (cases joined
    by "+") on which the combination turns; empty of one without.
    """

    factors: dict[str, float]
    clause: str
    leading: str


Acting = Sequence[tuple[str, ...]]
"""Sets of variable actions that can act together."""


def together(cases: Sequence[str], exclusive: Sequence[Sequence[str]]) -> Iterator[tuple[str, ...]]:
    """All subsets of these cases, in their order, with at most one case of each group that excludes each other.

    >>> list(together(["S", "W", "w"], [["W", "w"]]))
    [(), ('S',), ('W',), ('S', 'W'), ('w',), ('S', 'w')]
    """
    found: list[tuple[str, ...]] = [()]
    for case in cases:
        against = {other for group in exclusive if case in group for other in group}
        found += [(*some, case) for some in found if not against.intersection(some)]
    yield from found


class Eurocode(NamedTuple):
    """Numbers of EN 1990: gamma_G of unfavourable and favourable permanent actions, gamma_Q, xi (table A1.2(B)), and psi."""

    unfavourable: float = 1.35
    favourable: float = 1.0
    variable: float = 1.5
    xi: float = 0.85
    psi: Mapping[str, Psi] = PSI


def en1990(
    categories: Mapping[str, str], exclusive: Sequence[Sequence[str]], equations: Sequence[Equation], code: Eurocode
) -> Iterator[Combined]:
    """The combinations of cases by their categories, for the equations of EN 1990.

    Each permanent action is unfavourable or favourable by itself.

    >>> found = en1990({"G": "permanent", "Q": "imposed A"}, [], ["6.10"], Eurocode())
    >>> [one.factors for one in found if one.leading]
    [{'G': 1.35, 'Q': 1.5}, {'G': 1.0, 'Q': 1.5}]
    """
    fixed = [name for name, category in categories.items() if category == PERMANENT]
    acting = list(together([name for name in categories if name not in fixed], exclusive))
    psi = [{name: code.psi[categories[name]][k] for name in categories if name not in fixed} for k in (0, 1, 2)]
    high, low, q = code.unfavourable, code.favourable, code.variable

    def permanent(above: float) -> list[dict[str, float]]:
        sides = product(*(((above, low) if above != low else (low,)) for _ in fixed))
        return [dict(zip(fixed, some, strict=True)) for some in sides]

    steady = [dict.fromkeys(fixed, 1.0)]
    for equation in equations:
        if equation == "6.10":
            yield from _led("EN 1990 6.10", permanent(high), acting, lambda _: q, lambda name: q * psi[0][name])
        elif equation == "6.10ab":
            yield from _all("EN 1990 6.10a", permanent(high), acting, lambda name: q * psi[0][name])
            yield from _led("EN 1990 6.10b", permanent(code.xi * high), acting, lambda _: q, lambda name: q * psi[0][name])
        elif equation == "6.14b":
            yield from _led("EN 1990 6.14b", steady, acting, lambda _: 1.0, psi[0].__getitem__)
        elif equation == "6.15b":
            yield from _led("EN 1990 6.15b", steady, acting, psi[1].__getitem__, psi[2].__getitem__)
        else:
            yield from _all("EN 1990 6.16b", steady, acting, psi[2].__getitem__)


Factor = Callable[[str], float]


def _led(clause: str, permanent: list[dict[str, float]], acting: Acting, first: Factor, others: Factor) -> Iterator[Combined]:
    """Each variable action that acts is the leading one in turn."""
    for some, steady in product(acting, permanent):
        for leading in some or ("",):
            moving = {name: first(name) if name == leading else others(name) for name in some}
            yield _combined(steady | moving, clause, leading)


def _all(clause: str, permanent: list[dict[str, float]], acting: Acting, factor: Factor) -> Iterator[Combined]:
    """All variable actions alike."""
    for some, steady in product(acting, permanent):
        yield _combined(steady | {name: factor(name) for name in some}, clause, "")


def _combined(factors: Mapping[str, float], clause: str, leading: str) -> Combined:
    """Without actions of factor 0, and without the round-off of products."""
    kept = {name: round(factor, 10) for name, factor in factors.items() if factor}
    return Combined(kept, clause, leading if leading in kept else "")


Terms = tuple[tuple[tuple[str, float], ...], ...]

ROOF = ("Lr", "S", "R")


def _roof(factor: float) -> tuple[tuple[str, float], ...]:
    """L_r or S or R."""
    return tuple((name, factor) for name in ROOF)


RULES: dict[Method, tuple[tuple[str, float, Terms, tuple[str, ...]], ...]] = {
    "LRFD": (
        ("2.3.1-1", 1.4, (), ()),
        ("2.3.1-2", 1.2, ((("L", 1.6),), _roof(0.5)), ("L",)),
        ("2.3.1-3", 1.2, (_roof(1.6), (("L", 1.0), ("W", 0.5))), ROOF),
        ("2.3.1-4", 1.2, ((("W", 1.0),), (("L", 1.0),), _roof(0.5)), ("W",)),
        ("2.3.1-5", 0.9, ((("W", 1.0),),), ("W",)),
        ("2.3.6-6", 1.2, ((("Ev", 1.0),), (("E", 1.0),), (("L", 1.0),), (("S", 0.2),)), ("E", "Ev")),
        ("2.3.6-7", 0.9, ((("Ev", -1.0),), (("E", 1.0),)), ("E", "Ev")),
    ),
    "ASD": (
        ("2.4.1-1", 1.0, (), ()),
        ("2.4.1-2", 1.0, ((("L", 1.0),),), ("L",)),
        ("2.4.1-3", 1.0, (_roof(1.0),), ROOF),
        ("2.4.1-4", 1.0, ((("L", 0.75),), _roof(0.75)), ("L",)),
        ("2.4.1-5", 1.0, ((("W", 0.6),),), ("W",)),
        ("2.4.1-6", 1.0, ((("L", 0.75),), (("W", 0.45),), _roof(0.75)), ("W",)),
        ("2.4.1-7", 0.6, ((("W", 0.6),),), ("W",)),
        ("2.4.5-8", 1.0, ((("Ev", 0.7),), (("E", 0.7),)), ("E", "Ev")),
        ("2.4.5-9", 1.0, ((("Ev", 0.525),), (("E", 0.525),), (("L", 0.75),), (("S", 0.75),)), ("E", "Ev")),
        ("2.4.5-10", 0.6, ((("Ev", -0.7),), (("E", 0.7),)), ("E", "Ev")),
    ),
}
"""Of each combination the clause, the factor of D, terms (each one of some categories with its factor), and what leads."""


def asce7(categories: Mapping[str, str], exclusive: Sequence[Sequence[str]], method: Method) -> Iterator[Combined]:
    """The combinations of cases by their categories, of ASCE 7-16.

    >>> found = asce7({"D": "D", "W": "W"}, [], "LRFD")
    >>> [(one.clause, one.factors) for one in found if one.leading]
    [('ASCE 7-16 2.3.1-4', {'D': 1.2, 'W': 1.0}), ('ASCE 7-16 2.3.1-5', {'D': 0.9, 'W': 1.0})]
    """
    dead = [name for name, category in categories.items() if category == DEAD]
    for clause, steady, terms, first in RULES[method]:
        met = set[tuple[str, ...]]()  # where a category does not act, it does not matter which of several it is
        for chosen in product(*terms):
            factor = dict(chosen)
            moving = [name for name, category in categories.items() if category in factor]
            for some in together(moving, exclusive):
                leading = "+".join(name for name in some if categories[name] in first)
                if (terms and not leading) or some in met:
                    continue  # another combination, or less of this one than the first: 1.4 D, D
                met.add(some)
                found = dict.fromkeys(dead, steady) | {name: factor[categories[name]] for name in some}
                yield Combined({name: round(one, 10) for name, one in found.items()}, f"ASCE 7-16 {clause}", leading)
