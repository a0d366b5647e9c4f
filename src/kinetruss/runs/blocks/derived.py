"""Results of short variants that are not stored because they follow from motion and forces; computed on first access."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Demand, Forces, Motion, Sections

__all__ = ["DERIVED", "Later", "derived"]

T = TypeVar("T")
DERIVED = ("static", "sections", "demand")
"""Kinds of results that may be under ``derived`` in a ledger."""


class Later(Mapping[str, T]):
    """A mapping whose values are computed on first access."""

    def __init__(self, names: Sequence[str], make: Callable[[str], T]) -> None:
        self._names, self._make = tuple(names), make
        self._made: dict[str, T] = {}

    def __getitem__(self, name: str) -> T:
        if name not in self._names:
            raise KeyError(name)
        if name not in self._made:
            self._made[name] = self._make(name)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def derived(
    model: Model, motion: Motion, stored: Mapping[str, Forces], stations: int
) -> tuple[Mapping[str, Forces], Mapping[str, Sections], Mapping[str, Demand]]:
    """Forces with those at rest, section forces and motor demands by load case, from motion and stored forces."""

    def with_static(case: str) -> Forces:
        from kinetruss import dynamics

        again = dynamics.inverse(model, motion, case if case in model.load_cases else None)
        return stored[case].with_(static=again.static)

    def sections(case: str) -> Sections:
        from kinetruss import strength

        return strength.sections(model, stored[case], stations=stations)

    def demand(case: str) -> Demand:
        from kinetruss import actuators

        return actuators.evaluate(model, motion, stored[case])

    cases = list(stored)
    return Later(cases, with_static), Later(cases, sections), Later(cases if model.actuators else (), demand)
