"""Scalars of results as text, ``max(abs(member_force))`` or ``displacement[C, y]``, with their derivatives by the values read.

What may stand in one: `response_grammar`.
"""

from __future__ import annotations

import ast
import re
from collections import ChainMap
from collections.abc import Callable, Iterator, Mapping, MutableMapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from keyword import kwlist
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.errors import InputError, shown
from kinetruss.gradients.response_grammar import TIME, Source, Value, value_of
from kinetruss.model.measured_forces import ExpressionError

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

LONGEST = 1000
"""Characters of a response."""
KEYWORD = re.compile(rf"""(?<=[\[, ])({"|".join(kwlist)})(?=\s*[,\]])""")
"""Names of entries, like yield, that are words of the grammar."""


@dataclass(frozen=True, eq=False)
class Read:
    """The value of a response, its unit, the derivatives by the variables read, in their shape, and what is equally large."""

    value: float
    unit: str
    seeds: dict[str, NDArray[np.float64]]
    ties: tuple[str, ...] = ()
    shared: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    """The seeds where all that is equally large has a part: with the same gradient if it grows alike."""


@dataclass(frozen=True, eq=False)
class Entries:
    """All values of a response that may have several: values (of its axes), labels along them, unit; and by `seeds` the
    derivatives of one of them by the variables that it reads.
    """

    values: NDArray[np.float64]
    dims: tuple[str, ...]
    labels: tuple[tuple[str, ...], ...]
    unit: str
    _value: Value = field(repr=False)
    _at: Source = field(repr=False)

    def name(self, k: int) -> str:
        """What entry k, of the values in a row, is of: ``M7 at 1.2 s``; empty for a single number."""
        place = dict(zip(self.dims, np.unravel_index(k, self.values.shape), strict=True)) if self.dims else {}
        at = f"at {self._at.labels[TIME][place[TIME]]:.6g} s" if TIME in place else ""
        return " ".join(filter(None, [self.part(k), at]))

    def part(self, k: int) -> str:
        """The same without the instant."""
        place = np.unravel_index(k, self.values.shape) if self.dims else ()
        return " ".join(self.labels[i][j] for i, j in enumerate(place) if self.dims[i] != TIME)

    def seeds(self, k: int) -> dict[str, NDArray[np.float64]]:
        """Of entry k, by variable."""
        one = np.zeros(self.values.shape)
        one.reshape(-1)[k] = 1.0
        self._at.seeds.clear()
        self._value.push(one)
        return dict(self._at.seeds)


class Beside(Mapping[str, Any]):
    """Variables beside those of a result, with ``dims``, ``values`` and ``attrs``: by name what finds it, maybe among others,
    when it is first read.
    """

    def __init__(self, sources: Mapping[str, Callable[[], Mapping[str, Any]]]) -> None:
        self._sources, self._found = sources, dict[str, Any]()

    def __getitem__(self, name: str) -> Any:
        if name not in self._found:
            self._found |= self._sources[name]()
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._sources)

    def __len__(self) -> int:
        return len(self._sources)


@dataclass(frozen=True, eq=False)
class Sheet:
    """What responses read of a result: variables by name, with ``dims``, ``values`` and ``attrs``, and names along axes, which
    stand by themselves (`labels`) or are units of what has their axis (`units`).
    """

    variables: MutableMapping[str, Any]
    coords: MutableMapping[str, Any]

    @classmethod
    def of(cls, data: xr.Dataset | Sheet, more: Mapping[str, Any] | None = None) -> Sheet:
        """That of a dataset, with further variables."""
        if isinstance(data, Sheet):
            return data if more is None else Sheet(ChainMap(data.variables, cast("Any", more)), data.coords)
        every = {str(name): one for name, one in data.variables.items()}
        coords = {str(name): every.pop(str(name)) for name in data.coords}
        return cls.of(cls(every, coords), more)

    @cached_property
    def labels(self) -> dict[str, list[Any]]:
        """The names along each axis."""
        return {name: [*one.values.tolist()] for name, one in self.coords.items() if one.dims == (name,)}

    @cached_property
    def units(self) -> dict[str, tuple[str, list[str]]]:
        """By name the axis and the units along it."""
        return {name: (str(one.dims[0]), one.values.tolist()) for name, one in self.coords.items() if len(one.dims) == 1}


def read_response(text: str, data: xr.Dataset | Sheet, more: Mapping[str, Any] | None = None) -> Read:
    """The value of a response of a result, and its derivatives by what it reads.

    Parameters
    ----------
    text : the response. data : the result, or its `Sheet`. more : further variables by name, with ``dims``, ``values`` and
    ``attrs``.

    Raises
    ------
    InputError : it is no response, or names what the result does not have; it is no single number.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.Rod(diameter="10 mm"), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> found = read_response("max(abs(member_force)) / kN", kt.statics.linear(rod).data)
    >>> round(found.value, 9), found.unit, found.seeds["member_force"].round(6).tolist()
    (7.0, '', [0.001])
    """
    found, at = _parsed(text, data, more)
    if found.array.ndim:
        free = ", ".join(found.dims)
        raise InputError(
            f"The response {shown(text)} is no single number: it has one for each {free}. "
            "Name an entry in brackets, or take max(...), min(...), rms(...) of it."
        )
    found.push(np.ones(()))
    seeds = at.seeds
    if at.ties:
        at.sharing, at.seeds = True, {}
        found.push(np.ones(()))
    return Read(float(found.array), found.kind.unit, seeds, tuple(at.ties), at.seeds if at.ties else {})


def read_entries(text: str, data: xr.Dataset | Sheet, more: Mapping[str, Any] | None = None) -> Entries:
    """All values of a response, one or several, as `read_response` reads it.

    Raises
    ------
    InputError : it is no response, or names what the result does not have.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.Rod(diameter="10 mm"), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> found = read_entries("member_force/kN", kt.statics.linear(rod).data)
    >>> found.values.round(9).tolist(), found.name(0), found.seeds(0)["member_force"].tolist()
    ([7.0], 'b', [0.001])
    """
    found, at = _parsed(text, data, more)
    labels = tuple(tuple(map(str, at.labels.get(dim, range(n)))) for dim, n in zip(found.dims, found.array.shape, strict=True))
    return Entries(found.array, found.dims, labels, found.kind.unit, found, at)


def _parsed(text: str, data: xr.Dataset | Sheet, more: Mapping[str, Any] | None) -> tuple[Value, Source]:
    """The value of a whole response."""
    if len(text) > LONGEST:
        raise InputError(f"The response has {len(text)} characters, more than {LONGEST}. Make it shorter.")
    text = KEYWORD.sub(r'"\1"', text.strip())
    sheet = Sheet.of(data, more)
    at = Source(sheet.variables, sheet.labels, sheet.units)
    try:
        found = value_of(_tree(text), text, at, 0)
    except ExpressionError as error:
        raise InputError(f"The response {shown(text)} {error.message} {error.mend}") from None
    return found, at


@lru_cache(maxsize=1000)
def _tree(text: str) -> ast.expr:
    try:
        return ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise InputError(f"{shown(text)} is no response. Write for example max(abs(member_force)).") from None
