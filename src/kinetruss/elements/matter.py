"""Sections and materials of a model, each once: places by part, numbers, and sections whose dimensions may be complex."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from kinetruss.elements.numbers import Array, Numbers
    from kinetruss.model import WholeModel

_OF_MATERIALS = ("E", "density", "poisson")


class Shape:
    """A section with dimensions by name; its formulas are those of its record."""

    def __init__(self, record: type, dimensions: Mapping[str, Any]) -> None:
        self.__dict__.update(dimensions, record=record)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.__dict__["record"], name).fget(self)


class Matter:
    """Sections and materials of the parts of a model, in the order in which parts are asked for."""

    def __init__(self, model: WholeModel) -> None:
        self.model = model
        self.sections: list[Any] = []
        self.materials: list[Any] = []
        self._sizes: list[tuple[type, dict[str, float | None]]] = []
        self._places: dict[int, int] = {id(None): -1}
        self._kinds: list[tuple[Any, tuple[str, ...], Array, Array]] | None = None
        self._known: dict[tuple[int, int, type], tuple[int, int]] = {}

    def of(self, part: Any) -> tuple[int, int]:
        """The places of section and material of a part; -1 is none."""
        shared = id(part.section), id(part.material), type(part)  # what many parts have in common
        if (found := self._known.get(shared)) is None:
            section, material = self.model.section_of(part), self.model.material_of(part)
            found = self._known[shared] = self._put(self.sections, section), self._put(self.materials, material)
            for one in self.sections[len(self._sizes) :]:
                self._sizes.append((type(one), {name: value for name, value in vars(one).items() if name != "kind"}))
        return found

    def material_of(self, part: Any) -> int:
        """The place of the material of a part without a section."""
        return self._put(self.materials, self.model.material_of(part))

    def _put(self, records: list[Any], one: Any) -> int:
        if id(one) not in self._places:
            self._places[id(one)] = len(records)
            records.append(one)
        return self._places[id(one)]

    def numbers(self) -> dict[str, Any]:
        """section : the dimensions of all sections, one behind the other; E (Pa), density (kg/m^3), poisson of materials."""
        sizes = [value for _, own in self._sizes for value in own.values() if value is not None]
        own = {name: np.array([getattr(one, name) for one in self.materials], float) for name in _OF_MATERIALS}
        return {"section": np.array(sizes, float), **own}

    def shapes(self, numbers: Numbers) -> list[Any]:
        """The sections with the dimensions that `numbers` has."""
        given, found = iter(numbers.each("section")), []
        for record, own in self._sizes:
            found.append(Shape(record, {name: None if value is None else next(given) for name, value in own.items()}))
        return found

    def areas(self, numbers: Numbers) -> Array:
        """Areas of the sections, (copies, sections), m^2: one formula for all sections of a kind."""
        found, given = numbers.full(len(self.sections)), numbers["section"]
        for record, names, places, first in self._alike():
            columns = {name: given[..., first + k] for k, name in enumerate(names)}
            found[..., places] = Shape(record, dict.fromkeys(record.model_fields) | columns).area
        return found

    def _alike(self) -> list[tuple[Any, tuple[str, ...], Array, Array]]:
        """Sections with the same dimensions given: their class, these, their places, and where their numbers begin."""
        if self._kinds is None:
            groups: dict[Any, tuple[list[int], list[int]]] = {}
            start = 0
            for place, (record, own) in enumerate(self._sizes):
                names = tuple(name for name, value in own.items() if value is not None)
                places, first = groups.setdefault((record, names), ([], []))
                places.append(place)
                first.append(start)
                start += len(names)
            self._kinds = [(*key, np.array(places), np.array(first)) for key, (places, first) in groups.items()]
        return self._kinds
