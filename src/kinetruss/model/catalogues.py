"""Catalogues of parts: tubes, lead screws, gears and motors by name, with the source of the values."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, ValidationError, field_validator, model_validator

from kinetruss.errors import Fault
from kinetruss.model.collecting import from_library
from kinetruss.model.drivetrain import Gear, LeadScrew, Motor
from kinetruss.model.record import Length, Name, PositiveLength, Record
from kinetruss.model.sections import Material, Tube
from kinetruss.model.table import ReadOnly, Table
from kinetruss.model.words import faults_of


class TubeStock(Record):
    """A round tube: outer diameter, and either wall or inner diameter, m."""

    outer: PositiveLength
    inner: Length | None = None
    wall: PositiveLength | None = None

    @model_validator(mode="after")
    def _possible(self) -> TubeStock:
        if (self.inner is None) == (self.wall is None):
            has = "neither wall nor inner diameter" if self.wall is None else "both wall and inner diameter"
            raise ValueError(f"has {has}. Give one of them.")
        if self.wall is not None and 2 * self.wall >= self.outer:
            raise ValueError(
                f"a wall of {self.wall:g} m leaves no bore in an outer diameter of {self.outer:g} m. Give less than half of it."
            )
        if self.inner is not None and not 0 < self.inner < self.outer:
            raise ValueError(
                f"inner diameter {self.inner:g} m must be greater than 0 and less than the outer {self.outer:g} m. "
                "Give outer > inner."
            )
        return self

    @property
    def section(self) -> Tube:
        """The tube as a cross-section."""
        return Tube(outer=self.outer, inner=self.outer - 2 * self.wall if self.wall is not None else self.inner or 0.0)


class ScrewStock(LeadScrew):
    """A lead screw with the core diameter of its thread (m).

    With a yield strength of the catalogue's material, the stress in this core is checked as well.
    """

    core_diameter: PositiveLength | None = None

    @model_validator(mode="after")
    def _cored(self) -> ScrewStock:
        if self.core_diameter is not None and self.core_diameter >= self.mean_diameter:
            raise ValueError(
                f"core diameter {self.core_diameter:g} m must be less than the mean one, {self.mean_diameter:g} m. "
                "Mend one of them."
            )
        return self

    @property
    def screw(self) -> LeadScrew:
        """As a record of a model."""
        return LeadScrew(**{name: getattr(self, name) for name in self.model_fields_set if name != "core_diameter"})


class Catalogue(Record):
    """Parts of one or more kinds, by name.

    Tubes may be in any order: they are sorted by mass per length. Screws, gears and motors must be in order from the smallest
    to the largest: the first sufficient one is chosen.

    source : where the values come from, or that they were made up. material : of the tubes (else members keep their
        own), or of the screws; a record, or the name of a library material.
    """

    title: str = ""
    source: str
    material: Annotated[Material | None, BeforeValidator(partial(from_library, table="materials"))] = None
    tubes: Table[Name, TubeStock] = ReadOnly()
    screws: Table[Name, ScrewStock] = ReadOnly()
    gears: Table[Name, Gear] = ReadOnly()
    motors: Table[Name, Motor] = ReadOnly()

    @field_validator("source")
    @classmethod
    def _sourced(cls, value: str) -> str:
        if not value.strip():
            raise ValueError("is empty. Say where the values come from, or that they were made up.")
        return value

    @model_validator(mode="after")
    def _filled(self) -> Catalogue:
        if not (self.tubes or self.screws or self.gears or self.motors):
            raise ValueError("holds nothing. Add tables tubes, screws, gears or motors.")
        return self

    @classmethod
    def _faults(cls, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
        return faults_of(error, data, cls)


CatalogueText = Annotated[str, Field(min_length=1, max_length=1000)]
"""Name of a built-in catalogue, or path of a TOML file."""
