"""Faults of many cross-checks: a vector of another dimension, an angle in place of a length."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from kinetruss.errors import Fault


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
