"""The cases as data, the numbers that their functions compute, the comparison of both, and the report of it.

A file of ``data`` has `references`, which later files may use too, each with `class` (a key of `CLAIMS`), `source` and, where
needed, `note` and `inferred`; `exact`, values with which functions compare whole histories; and `cases`, a list of records:

id : of each case; ``{name}`` stands for the name of a value, ``{given}`` for the first argument.
compute : ``module.function`` of this package; given : its arguments; each : first arguments, with cases for each of them.
reference, tolerance : common to all values of the record; scale : see `Case`.
values : name -> expected; or ``[expected, scale]``; or ``{x: .., y: ..}``, components of a vector, whose scale is the largest.

``models.yaml`` holds models by name, as in files of models.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal

import yaml

import kinetruss as kt

Kind = Literal[
    "printed",
    "printed-inferred",
    "thesis-formulas",
    "closed-form",
    "independent",
    "count",
    "identity",
    "agreement",
    "input-check",
]
INPUT_CHECK: Kind = "input-check"

CLAIMS: dict[Kind, str] = {
    "printed": "A number printed in the source. Its inputs are printed there too. Where the print contradicts itself or "
    "rounds a size, the note says what was taken.",
    "printed-inferred": "A printed number. At least one input is not the printed one; `inferred` names each. Where inputs were "
    "fitted to the numbers compared, the note says so: agreement then shows less.",
    "thesis-formulas": "A printed number that only the thesis' own formulas give, errors included. `computed` repeats his "
    "program along the product's motion; `product` is what the product itself gives. Agreement shows "
    "where the number comes from, not that it is right.",
    "closed-form": "A formula, evaluated apart from the analysis that is tested.",
    "independent": "A number from a separate computation that shares no analysis with the product.",
    "count": "A whole number, or an order of convergence, that theory or a publication gives for any sizes.",
    "identity": "A law that must hold: energy, momentum, equilibrium, a constraint. The expected value is the residual: 0.",
    "agreement": "Two ways of the product to one number. It shows that they agree, not that both are right.",
    "input-check": "A number that went into the model. It shows that the model is the one meant; not counted as verified.",
}
"""The claim of an entry, by class."""


@dataclass(frozen=True)
class Reference:
    """The source of an expected value.

    kind : its class, one of `CLAIMS`.
    note : how to read the number, and which of two conflicting statements of the source is used.
    inferred : inputs that differ from the printed ones, each with the printed one.
    """

    kind: Kind
    source: str
    note: str = ""
    inferred: tuple[str, ...] = ()


@dataclass(frozen=True)
class Entry:
    """One scalar compared, SI.

    kind : its class, a key of `CLAIMS`, which says what agreement shows.
    source, note, inferred : source of the expected value, how to read it, and the inputs that differ from the printed ones.
    product : the product's own result, if `computed` repeats wrong formulas or inputs of the source.
    tolerance : the largest allowed `relative_difference`.
    """

    id: str
    kind: Kind
    source: str
    note: str
    inferred: tuple[str, ...]
    expected: float
    computed: float
    product: float | None
    relative_difference: float
    tolerance: float
    passed: bool

    def as_dict(self) -> dict[str, Any]:
        """Plain values by name, `kind` as ``"class"``; a number that is not finite becomes None."""
        return {"class" if name == "kind" else name: _plain(value) for name, value in vars(self).items()}


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return list(value)
    return None if isinstance(value, float) and not math.isfinite(value) else value


@dataclass(frozen=True)
class Report:
    """All entries of a verification."""

    entries: tuple[Entry, ...]

    @property
    def passed(self) -> int:
        """Number of entries that agree."""
        return sum(entry.passed for entry in self.entries)

    @property
    def failed(self) -> int:
        """Number of entries that do not agree."""
        return len(self.entries) - self.passed

    @property
    def verified(self) -> int:
        """Number of entries that agree, without checks of inputs, which are true by construction."""
        return sum(entry.passed for entry in self.entries if entry.kind != INPUT_CHECK)

    @property
    def classes(self) -> dict[Kind, tuple[int, int]]:
        """Number of entries, and of those that agree, by class."""
        found = {kind: [entry.passed for entry in self.entries if entry.kind == kind] for kind in CLAIMS}
        return {kind: (len(agrees), sum(agrees)) for kind, agrees in found.items() if agrees}

    def as_dict(self) -> dict[str, Any]:
        """``{"entries": [...], "classes": {...}, "verified": k, "passed": n, "failed": m}``, plain values."""
        classes = {
            kind: {"claim": CLAIMS[kind], "entries": number, "passed": agree} for kind, (number, agree) in self.classes.items()
        }
        return {
            "entries": [entry.as_dict() for entry in self.entries],
            "classes": classes,
            "verified": self.verified,
            "passed": self.passed,
            "failed": self.failed,
        }


@dataclass(frozen=True)
class Case:
    """An expected value and the function that computes the value to compare.

    make, arguments : function, ``"group.module.function"`` below this package, and its arguments; key : name of the number
    in its result.
    scale : 0, or the largest component of the vector of the value, so that a component that is zero by symmetry is compared
    relative to the vector instead of itself.
    """

    id: str
    reference: Reference
    expected: float
    tolerance: float
    make: str
    arguments: tuple[Any, ...]
    key: str
    scale: float = 0.0

    def entry(self, found: Mapping[str, float]) -> Entry:
        """Compare with the numbers of the function, by name; ``KEY.product`` is the product's own result, if there is one."""
        computed, ref = float(found[self.key]), self.reference
        difference = relative_difference(computed, self.expected, self.scale)
        return Entry(
            self.id,
            ref.kind,
            ref.source,
            ref.note,
            ref.inferred,
            self.expected,
            computed,
            found.get(f"{self.key}.product"),
            difference,
            self.tolerance,
            difference <= self.tolerance,
        )


def relative_difference(computed: float, expected: float, scale: float = 0.0) -> float:
    """|c - e|/max(|e|, scale); 0 if both are equal.

    >>> relative_difference(1.01, 1.0)
    0.010000000000000009
    >>> relative_difference(1e-12, 0.0, scale=10.0)
    1e-13
    """
    distance = abs(computed - expected)
    if distance == 0:
        return 0.0
    size = max(abs(expected), scale)
    return distance / size if size > 0 else math.inf


GROUPS = (
    "thesis",
    "drive_trains",
    "structures",
    "forward",
    "solids",
    "mechanisms",
    "flexible",
    "members",
    "tasks",
    "textbooks",
    "optima",
)
_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@cache
def stored(name: str) -> dict[str, Any]:
    """A data file, read once and never changed."""
    text = (files("kinetruss.verification") / "data" / f"{name}.yaml").read_text(encoding="utf-8")
    data: dict[str, Any] = yaml.load(text, Loader=_LOADER)
    return data


def model(name: str) -> kt.Model:
    """A model of ``models.yaml``."""
    return kt.Model(**stored("models")[name])


def cases() -> Iterator[Case]:
    """All cases, before any computation."""
    references: dict[str, Reference] = {}
    for group in GROUPS:
        data = stored(group)
        references |= {
            name: Reference(one["class"], one["source"], one.get("note", ""), tuple(one.get("inferred", ())))
            for name, one in data["references"].items()
        }
        for record in data["cases"]:
            for first in record.get("each", [None]):
                arguments = tuple(record.get("given", ())) if first is None else (first, *record.get("given", ()))
                for name, expected, scale in _values(record["values"], float(record.get("scale", 0))):
                    yield Case(
                        record["id"].format(name=name, given=arguments[0] if arguments else ""),
                        references[record["reference"]],
                        expected,
                        float(record["tolerance"]),
                        record["compute"],
                        arguments,
                        name,
                        scale,
                    )


def _values(values: Mapping[str, Any], scale: float) -> Iterator[tuple[str, float, float]]:
    """Name, expected value and scale of each."""
    for name, value in values.items():
        if isinstance(value, dict):
            largest = max(abs(float(one)) for one in value.values())
            yield from ((f"{name}.{part}" if name else part, float(one), largest) for part, one in value.items())
        elif isinstance(value, list):
            yield name, float(value[0]), float(value[1])
        else:
            yield name, float(value), scale


def numbers(make: str, arguments: tuple[Any, ...]) -> dict[str, float]:
    """The results of a function, by dotted names."""
    module, function = make.split(".")
    return dict(_flat(getattr(importlib.import_module(f"kinetruss.verification.{module}"), function)(*arguments)))


def _flat(found: Any, name: str = "") -> Iterator[tuple[str, float]]:
    """Numbers by dotted names: of mappings, and of labelled arrays by their labels; components of other arrays by axes."""
    items: Iterable[tuple[Any, Any]]
    if isinstance(found, Mapping):
        items = found.items()
    elif getattr(found, "ndim", 0):
        labels = found[found.dims[0]].values if hasattr(found, "dims") else "xyz"
        items = zip(labels, found, strict=False)
    else:
        yield name, float(found)
        return
    for key, value in items:
        yield from _flat(value, f"{name}.{key}" if name else str(key))


def verify(filter: str | None = None, progress: Callable[[int, int], None] | None = None) -> Report:
    """Compare kinetruss with all its references.

    The class of an entry says what its agreement shows; inputs that differ from the printed ones are named. Computed
    values come from the public API; those of the class "thesis-formulas" from the thesis' own formulas, along a motion
    from the public API. A case agrees if |computed - expected|/max(|expected|, scale) is within the tolerance, which is the
    accuracy of the reference itself: 1e-8 for exact values of ten digits, 1e-6 for maxima on a grid, more for
    printed tables.

    Parameters
    ----------
    filter : run only cases whose id, class or source contains this text (any case of letters).
    progress : called with the number of cases that are done, and of all.

    Returns
    -------
    Report, with one entry per scalar; `classes` counts them.

    Examples
    --------
    >>> import kinetruss as kt
    >>> report = kt.verification.verify("gauges.rosette")
    >>> report.passed, report.failed
    (3, 0)
    """
    wanted = (filter or "").casefold()
    made: dict[str, dict[str, float]] = {}
    chosen = [
        one for one in cases() if any(wanted in text.casefold() for text in (one.id, one.reference.kind, one.reference.source))
    ]
    entries = []
    for case in chosen:
        call = f"{case.make}{case.arguments}"
        if call not in made:
            made[call] = numbers(case.make, case.arguments)
        entries.append(case.entry(made[call]))
        if progress:
            progress(len(entries), len(chosen))
    return Report(tuple(entries))
