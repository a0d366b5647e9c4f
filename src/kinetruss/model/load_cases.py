"""Load cases and their combinations, by hand and by standards.

A combination is a load case: its loads are those of its cases times its factors. `cases_of` makes them, nothing else knows how.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag, model_validator

from kinetruss.errors import Fault, few
from kinetruss.model.common_faults import components
from kinetruss.model.load_codes import ASCE, DEAD, PERMANENT, PSI, Combined, Equation, Eurocode, Method, asce7, en1990
from kinetruss.model.record import GravityVector, Name, Number, PositiveNumber, Record
from kinetruss.model.references import LoadName, Ref
from kinetruss.model.table import ReadOnly, Table
from kinetruss.model.words import nearest

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData

Category = Literal[
    "permanent", "imposed A", "imposed B", "imposed C", "imposed D", "imposed E", "imposed F", "imposed G", "imposed H",
    "snow", "snow above 1000 m", "wind", "temperature", "D", "L", "Lr", "S", "R", "W", "E", "Ev",
]  # fmt: skip
"""What a load case is for the standards: permanent to temperature of EN 1990, D to Ev of ASCE 7-16."""

CaseName = Annotated[Name, Ref("load case", "load_cases")]
MOST = 2000
"""Combinations of a model at most."""


class LoadCase(Record):
    """Which loads act.

    loads : name of a load -> factor; all loads with factor 1 where not given.
    gravity : m/s^2, if it differs from that of the model. In a combination, cases that give none leave the weight to the
        permanent one among them.
    category : what it is for combinations by a standard, e.g. ``permanent``, ``imposed B``, ``wind`` (EN 1990), ``D``, ``Lr``
        (ASCE 7-16).
    title : what it is, in words.
    """

    loads: Table[LoadName, Number] | None = None
    gravity: GravityVector | None = None
    category: Category | None = None
    title: str = ""


class Combination(Record):
    """Load cases that act together, by hand.

    cases : name of a load case -> factor.

    >>> import kinetruss as kt
    >>> kt.Combination(cases={"G": 1.35, "Q": 1.5}).cases["Q"]
    1.5
    """

    kind: Literal["by hand"] = "by hand"
    cases: Annotated[Table[CaseName, Number], Field(min_length=1)]


class _ByCode(Record):
    """What combinations by a standard have in common."""

    cases: Annotated[tuple[CaseName, ...], Field(min_length=1)] | None = None
    exclusive: tuple[Annotated[tuple[CaseName, ...], Field(min_length=2)], ...] = ()


class En1990(_ByCode):
    """All combinations of load cases by EN 1990:2002 for buildings, by the categories of the cases.

    equations : of ultimate limit states ``6.10``, or ``6.10ab`` (6.10a and 6.10b); of serviceability ``6.14b`` characteristic,
        ``6.15b`` frequent, ``6.16b`` quasi-permanent.
    cases : names of those that it combines; by default all of the model.
    exclusive : groups of cases of which at most one acts, as wind from the left and from the right.
    unfavourable, favourable : gamma_G of permanent actions. variable : gamma_Q. xi : reduces permanent actions in 6.10b. They
        are recommended values (table A1.2(B)); a national annex may set others.
    psi : category -> psi_0, psi_1, psi_2, where they differ from the recommended values (table A1.1).

    Every permanent action is favourable and unfavourable in turn, every variable one acts and leads or does not.

    >>> import kinetruss as kt
    >>> kt.En1990(equations=["6.10ab"], psi={"wind": (0.5, 0.2, 0)}).psi["wind"]
    (0.5, 0.2, 0.0)
    """

    kind: Literal["en1990"] = "en1990"
    equations: Annotated[tuple[Equation, ...], Field(min_length=1)] = ("6.10",)
    unfavourable: PositiveNumber = 1.35
    favourable: PositiveNumber = 1.0
    variable: PositiveNumber = 1.5
    xi: PositiveNumber = 0.85
    psi: Table[Category, tuple[Number, Number, Number]] = ReadOnly()

    @model_validator(mode="after")
    def _known(self) -> En1990:
        for name in self.psi:
            if name not in PSI:
                raise ValueError(f"psi: {name!r} is no category of variable actions of EN 1990. {nearest(name, PSI)}")
        return self

    def of(self, categories: Mapping[str, str]) -> Iterator[Combined]:
        """The combinations of cases by their categories."""
        psi = PSI | {str(name): one for name, one in self.psi.items()}
        code = Eurocode(self.unfavourable, self.favourable, self.variable, self.xi, psi)
        return en1990(categories, self.exclusive, self.equations, code)


class Asce7(_ByCode):
    """All combinations of load cases by ASCE 7-16, by the categories of the cases.

    method : ``LRFD``, strength design (2.3.1, 2.3.6), or ``ASD``, allowable stress design (2.4.1, 2.4.5).
    cases : names of those that it combines; by default all of the model.
    exclusive : groups of cases of which at most one acts, as wind from the left and from the right.

    >>> import kinetruss as kt
    >>> kt.Asce7(method="ASD").method
    'ASD'
    """

    kind: Literal["asce7-16"] = "asce7-16"
    method: Method = "LRFD"

    def of(self, categories: Mapping[str, str]) -> Iterator[Combined]:
        """The combinations of cases by their categories."""
        return asce7(categories, self.exclusive, self.method)


CATEGORIES: dict[type[Record], tuple[str, tuple[str, ...]]] = {
    En1990: ("EN 1990", (PERMANENT, *PSI)),
    Asce7: ("ASCE 7-16", (DEAD, *ASCE)),
}
"""Standard -> its name and categories, the permanent one first."""


def _kind(value: Any) -> str:
    return str(value.get("kind", "by hand") if isinstance(value, dict) else getattr(value, "kind", "by hand"))


def _short(value: Any) -> Any:
    """A table of factors alone is that of a combination by hand."""
    return {"cases": value} if isinstance(value, dict) and not {"cases", "kind"} & set(value) else value


Combinations = Annotated[
    Annotated[
        Annotated[Combination, Tag("by hand")] | Annotated[En1990, Tag("en1990")] | Annotated[Asce7, Tag("asce7-16")],
        Discriminator(_kind),
    ],
    BeforeValidator(_short),
]


def of_one_code(value: Any) -> Any:
    """The combinations of one standard, without a name of their own, as a table."""
    return {value["kind"]: value} if isinstance(value, dict) and isinstance(value.get("kind"), str) else value


# What they consist of.


def cases_of(model: ModelData) -> dict[str, LoadCase]:
    """All load cases of a model by name: its own, then its combinations. Those of a standard are called
    ``NAME.LEADING.FACTORS``, for instance ``uls.wind.1.35G+1.5wind+0.75snow``; their title has the clause.
    """
    found = dict(model.load_cases)
    for name, one in model.combinations.items():
        found |= {key: _made(model, *own) for key, own in _combined(model, name, one).items()}
    return found


def sets_of(model: ModelData) -> dict[str, tuple[str, ...]]:
    """Names of the cases of every combination, and of all combinations of every standard."""
    return {name: tuple(_combined(model, name, one)) for name, one in model.combinations.items()}


def acting_cases(model: ModelData, names: Iterable[str] | None) -> tuple[str | None, ...]:
    """Cases that are computed where these are named, a standard for all of its combinations; by default all combinations, all
    load cases where there are none, and None, all loads, of a model without.
    """
    sets = sets_of(model)
    chosen = tuple(sets or model.load_cases) if names is None else tuple(names)
    return tuple(dict.fromkeys(case for name in chosen for case in sets.get(name, (name,)))) or (None,)


def applies_in(model: ModelData, names: Iterable[str] | None, case: str) -> bool:
    """Whether limits that name load cases, or a standard for its combinations, apply in one: always if they name none, or if
    that is no load case of the model.
    """
    return names is None or case not in model.cases or case in acting_cases(model, names)


def _combined(model: ModelData, name: str, one: Combination | En1990 | Asce7) -> dict[str, tuple[dict[str, float], str]]:
    """Name of a combination -> its factors and title."""
    if isinstance(one, Combination):
        factors = {case: factor for case, factor in one.cases.items() if case in model.load_cases}
        return {name: (factors, _sum(factors, " "))}
    known, found, met = CATEGORIES[type(one)][1], dict[str, tuple[dict[str, float], str]](), set[Any]()
    categories = {case: str(model.load_cases[case].category) for case in _chosen(model, one)}
    if _count(categories, known[0]) > MOST or not set(categories.values()) <= set(known):
        return found  # a fault of the model
    for own in one.of(categories):
        key = frozenset(own.factors.items())
        if key in met or not own.factors:
            continue
        met.add(key)
        label = ".".join(filter(None, (name, own.leading, _sum(own.factors, ""))))
        label = label if len(label) <= 200 and label not in found else f"{name}.{len(met)}"
        lead = f", leading {own.leading}" if own.leading else ""
        found[label] = own.factors, f"{_sum(own.factors, ' ')} ({own.clause}{lead})"
    return found


def _count(categories: Mapping[str, str], permanent: str) -> int:
    """About how many combinations there are."""
    steady = list(categories.values()).count(permanent)
    moving = len(categories) - steady
    return int(2.0 ** min(steady + moving, 60) * max(1, moving) / 2)


def _chosen(model: ModelData, one: En1990 | Asce7) -> list[str]:
    return [name for name in (model.load_cases if one.cases is None else one.cases) if name in model.load_cases]


def _sum(factors: Mapping[str, float], space: str) -> str:
    """``1.35 G + 1.5 W`` with a space, ``1.35G+1.5W`` without."""
    text = ""
    for name, factor in factors.items():
        size = "" if abs(factor) == 1.0 else f"{abs(factor):.10g}{space}"
        sign = "-" if factor < 0 else "+" if text else ""
        text += f"{space if text else ''}{sign}{space if text else ''}{size}{name}"
    return text


def _made(model: ModelData, factors: Mapping[str, float], title: str) -> LoadCase:
    """The load case that a combination is."""
    loads: dict[str, float] = {}
    for name, factor in factors.items():
        own = model.load_cases[name].loads
        for load, share in (dict.fromkeys(model.loads, 1.0) if own is None else own).items():
            loads[load] = loads.get(load, 0.0) + factor * share
    pulls = _pulls(model, factors)
    gravity = [sum(factor * vector[axis] for factor, vector in pulls) for axis in range(len(pulls[0][1]) if pulls else 0)]
    return LoadCase(loads=loads, gravity=tuple(gravity) or None, title=title)


def _pulls(model: ModelData, factors: Mapping[str, float]) -> list[tuple[float, tuple[float, ...]]]:
    """Factors and gravities of a combination: of its cases that give one, and that of the model by the case that brings it."""
    given = [(factor, one) for name, factor in factors.items() if (one := model.load_cases[name].gravity) is not None]
    bearers = _bearers(model, factors)
    return given + [(factors[name], model.gravity) for name in bearers[:1] if model.gravity is not None]


def _bearers(model: ModelData, names: Iterable[str]) -> list[str]:
    """Which of these cases may bring the weight: the permanent ones without a gravity of their own, else all without one."""
    silent = [name for name in names if model.load_cases[name].gravity is None]
    return [name for name in silent if model.load_cases[name].category in (PERMANENT, DEAD)] or silent


# What does not fit a model.


def case_faults(model: ModelData, dim: int) -> Iterator[Fault]:
    """Faults of load cases and combinations; names that are not known are found elsewhere."""
    for name, case in model.load_cases.items():
        yield from components(case.gravity, dim, ("load_cases", name, "gravity"))
    for name, condition in model.conditions.items():
        if condition.forces and model.combinations:
            message = "would act in every load case, and so several times in a combination of them."
            mend = "Give them as loads of a load case of their own."
            yield Fault(("conditions", name, "forces"), message, mend, about=(("combinations",),))
    for name, one in model.combinations.items():
        path, about = ("combinations", name), (("load_cases",), ("combinations", name))
        if name in model.load_cases:
            yield Fault(path, "is also the name of a load case.", "Give the combination another name.", about=about)
        if isinstance(one, Combination):
            yield from _weight_faults(model, [case for case in one.cases if case in model.load_cases], path, about)
            continue
        wrong = list(_code_faults(model, one, path, about))
        yield from wrong
        if not wrong:
            yield from _weight_faults(model, _permanent(model, one), path, about)


def _permanent(model: ModelData, one: En1990 | Asce7) -> list[str]:
    return [name for name in _chosen(model, one) if model.load_cases[name].category == CATEGORIES[type(one)][1][0]]


def _weight_faults(model: ModelData, names: list[str], path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    """The weight, of which each case has all, must count once."""
    heavy = any(model.gravity or ())
    if heavy and len(several := _bearers(model, names)) > 1:
        message = f"has the weight of the model in {len(several)} of its cases: {few(several, 4)}."
        mend = "Give one of them category: permanent, and gravity: 0 in all axes to other permanent ones."
        if all(model.load_cases[name].category in (PERMANENT, DEAD) for name in several):
            mend = "Give gravity: 0 in all axes to all but one of them."
        yield Fault(path, message, mend, about=about)
    own = [name for name, node in model.nodes.items() if node.gravity is not None and node.mass]
    if own and names:
        message = f"multiplies the weight, but nodes with a gravity of their own ({few(own, 4)}) would keep theirs."
        yield Fault(path, message, "Give their weights as loads, and gravity: 0 in all axes to the nodes.", about=about)


def _code_faults(model: ModelData, one: En1990 | Asce7, path: tuple[Any, ...], about: Any) -> Iterator[Fault]:
    code, known = CATEGORIES[type(one)]
    names = _chosen(model, one)
    if not names:
        yield Fault(path, "combines no load cases.", f"Give load_cases, each with a category of {code}.", about=about)
    for name in names:
        category, place = model.load_cases[name].category, ("load_cases", name, "category")
        if category is None:
            mend = f"Give it one of {', '.join(known)}, or name the cases that combinations.{path[1]} combines: cases."
            yield Fault(place, f"has no category, which {code} needs.", mend, about=about)
        elif category not in known:
            mend = f"Write one of {', '.join(known)}, or name the cases that combinations.{path[1]} combines: cases."
            yield Fault(place, f"{category!r} is no category of {code}.", mend, about=about)
    if names and any(model.gravity or ()) and not _permanent(model, one):
        mend = f"Give one category: {known[0]}; its loads may be none: loads: {{}}."
        yield Fault(path, f"has no case of category {known[0]}, so no weight.", mend, about=about)
    if (count := _count({name: str(model.load_cases[name].category) for name in names}, known[0])) > MOST:
        message = f"makes some {count:,} combinations of {len(names)} cases; {MOST:,} at most."
        yield Fault(path, message, "Name fewer cases, or put loads that act together into one case.", about=about)
    for k, group in enumerate(one.exclusive):
        fixed = [name for name in group if name in _permanent(model, one)]
        if fixed:
            place = (*path, "exclusive", k)
            yield Fault(place, f"{fixed[0]!r} is permanent: it always acts.", "Name variable actions.", about=about)
