"""Cross-sections and materials. Local axes: 1 along the member, 2 and 3 across it (in the plane, 2 lies in the plane)."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, Tag, field_validator, model_validator

from kinetruss.model.record import (
    Area,
    Density,
    Length,
    NameOrRecord,
    Number,
    PositiveLength,
    PositiveNumber,
    Record,
    SecondMoment,
    Stress,
)
from kinetruss.model.references import MaterialName, SectionName


class _Shape(Record):
    """A section that is known by its dimensions; what is here follows from them."""

    @property
    def shear_areas(self) -> tuple[float, float] | None:
        """(A2, A3) for shear forces along 2 and 3, m^2; None of sections that are not flexible in shear."""
        given: Any = self
        found = None if given.shear_coefficient is None else given.shear_coefficient * given.area
        return None if found is None else (found, found)


class _Round(_Shape):
    """A round section."""

    @property
    def area(self) -> float:
        """m^2."""
        outer, inner = _diameters(self)
        return math.pi / 4 * (outer**2 - inner**2)

    @property
    def second_moments(self) -> tuple[float, float]:
        """(I2, I3), about axes 2 and 3, m^4."""
        outer, inner = _diameters(self)
        value = math.pi / 64 * (outer**4 - inner**4)
        return value, value

    @property
    def torsion_constant(self) -> float:
        """J, m^4: the polar second moment."""
        return 2 * self.second_moments[0]

    @property
    def torsion_arm(self) -> float:
        """Largest shear stress of torsion over torque/J, m: the outer radius."""
        return _diameters(self)[0] / 2

    @property
    def extreme_fibres(self) -> tuple[float, float]:
        """(c2, c3): largest distance from the axis along 2 and along 3, m."""
        return _diameters(self)[0] / 2, _diameters(self)[0] / 2

    @property
    def round(self) -> bool:
        """True: bending about any axis meets the same section."""
        return True


def _diameters(of: Any) -> tuple[float, float]:
    """Outer and inner one of a round section, m."""
    return (of.outer, of.inner) if hasattr(of, "outer") else (of.diameter, 0.0)


class Tube(_Round):
    """Round tube.

    outer, inner : diameters, m.
    shear_coefficient : shear area over area; with it, beams are flexible in shear (about 0.5 of a thin tube).

    >>> import kinetruss as kt
    >>> kt.Tube(outer="50 mm", inner="44 mm")
    Tube(outer=0.05, inner=0.044)
    """

    kind: Literal["tube"] = "tube"
    outer: PositiveLength
    inner: Length
    shear_coefficient: PositiveNumber | None = None

    @model_validator(mode="after")
    def _hollow(self) -> Tube:
        if not 0 <= self.inner < self.outer:
            raise ValueError(
                f"inner diameter {self.inner:g} m must be at least 0 and less than the outer {self.outer:g} m. "
                "Give outer > inner (a solid bar is a rod)."
            )
        return self

    @property
    def shear_factor(self) -> float:
        """Largest shear stress over mean shear stress: 2 for a thin tube, 4/3 for a solid rod (exact between)."""
        ratio = self.inner / self.outer
        return 4 / 3 * (1 + ratio + ratio**2) / (1 + ratio**2)


class Rod(_Round):
    """Solid round bar.

    diameter : m.
    shear_coefficient : shear area over area; with it, beams are flexible in shear (0.9 of a solid circle).

    >>> import kinetruss as kt
    >>> kt.Rod(diameter="20 mm")
    Rod(diameter=0.02)
    """

    kind: Literal["rod"] = "rod"
    diameter: PositiveLength
    shear_coefficient: PositiveNumber | None = None

    @property
    def shear_factor(self) -> float:
        """Largest over mean shear stress of a solid circle."""
        return 4 / 3


class Rectangle(_Shape):
    """Solid rectangle.

    height : along axis 2 (in the plane, for a planar model), m.
    width : along axis 3, m.
    shear_coefficient : shear area over area; with it, beams are flexible in shear (5/6).

    >>> import kinetruss as kt
    >>> kt.Rectangle(width="20 mm", height="60 mm")
    Rectangle(width=0.02, height=0.06)
    """

    kind: Literal["rectangle"] = "rectangle"
    width: PositiveLength
    height: PositiveLength
    shear_coefficient: PositiveNumber | None = None

    @property
    def area(self) -> float:
        """m^2."""
        return self.width * self.height

    @property
    def second_moments(self) -> tuple[float, float]:
        """(I2, I3): I2 = height width^3/12 about axis 2, I3 = width height^3/12 about axis 3, m^4."""
        return self.height * self.width**3 / 12, self.width * self.height**3 / 12

    @property
    def torsion_constant(self) -> float:
        """J, m^4, of Saint-Venant's torsion: a b^3/3 (1 - 192 b/(pi^5 a) sum tanh(n pi a/(2 b))/n^5), n odd, a >= b (Timoshenko
        and Goodier, Theory of Elasticity, section 109).
        """
        b, a = (self.width, self.height) if np.all(np.real(self.width) <= np.real(self.height)) else (self.height, self.width)
        # the sides may be complex, or many
        tanh = math.tanh if isinstance(a / b, float) else np.tanh
        series = sum(tanh(n * math.pi * a / (2 * b)) / n**5 for n in range(1, 40, 2))
        return a * b**3 / 3 * (1 - 192 * b / (math.pi**5 * a) * series)

    @property
    def torsion_arm(self) -> float:
        """Largest shear stress of torsion over torque/J, m, at the middle of the long sides: b (1 - 8/pi^2 sum 1/(n^2
        cosh(n pi a/(2 b)))), n odd (Timoshenko and Goodier, section 109).
        """
        b, a = sorted((self.width, self.height))
        waves = [min(n * math.pi * a / (2 * b), 700.0) for n in range(1, 40, 2)]
        series = sum(1 / (n**2 * math.cosh(wave)) for n, wave in zip(range(1, 40, 2), waves, strict=True))
        return b * (1 - 8 / math.pi**2 * series)

    @property
    def extreme_fibres(self) -> tuple[float, float]:
        """(c2, c3), m."""
        return self.height / 2, self.width / 2

    @property
    def round(self) -> bool:
        """False: two bendings add at a corner."""
        return False

    @property
    def shear_factor(self) -> float:
        """Largest over mean shear stress of a rectangle."""
        return 1.5


class General(Record):
    """Any section given by its numbers.

    area : m^2.
    I2, I3 : second moments of area about the principal axes 2 and 3, m^4.
    c2, c3 : distance of the extreme fibres from the centroid along axes 2 and 3, m.
    J : torsion constant, m^4, of a beam in space.
    shear_factor : largest shear stress over shear force/area.
    A2, A3 : shear areas for forces along axes 2 and 3, m^2; with them, beams are flexible in shear.
    """

    kind: Literal["general"] = "general"
    area: Area
    I2: SecondMoment
    I3: SecondMoment
    c2: PositiveLength
    c3: PositiveLength
    shear_factor: Number = 1.5
    J: SecondMoment | None = None
    A2: Area | None = None
    A3: Area | None = None

    @model_validator(mode="after")
    def _both(self) -> General:
        if (self.A2 is None) != (self.A3 is None):
            raise ValueError("a section that is flexible in shear has two shear areas. Give A2 and A3.")
        return self

    @property
    def shear_areas(self) -> tuple[float, float] | None:
        """(A2, A3), m^2; None of sections that are not flexible in shear."""
        return None if self.A2 is None or self.A3 is None else (self.A2, self.A3)

    @property
    def torsion_constant(self) -> float | None:
        """J, m^4, or None if it is not known."""
        return self.J

    @property
    def torsion_arm(self) -> float | None:
        """None: the shear stress of torsion is not known from these numbers."""
        return None

    @property
    def second_moments(self) -> tuple[float, float]:
        """(I2, I3), m^4."""
        return self.I2, self.I3

    @property
    def extreme_fibres(self) -> tuple[float, float]:
        """(c2, c3), m."""
        return self.c2, self.c3

    @property
    def round(self) -> bool:
        """False: two bendings add at a corner (safe side)."""
        return False


Section = Annotated[Tube | Rod | Rectangle | General, Field(discriminator="kind")]
SectionOrName = Annotated[Annotated[Section, Tag("record")] | Annotated[SectionName, Tag("name")], NameOrRecord]


class Material(Record):
    """Elastic material.

    E : Young's modulus, Pa.
    density : kg/m^3.
    yield_strength : Pa; without it, strength is not checked.
    poisson : Poisson's ratio.
    source : where the values are from.
    thermal_expansion : coefficient of linear expansion, 1/K, as conditions with a temperature need it.
    """

    E: Stress
    density: Density
    yield_strength: Stress | None = None
    poisson: Number = 0.3
    thermal_expansion: Number | None = None
    source: str = ""

    @field_validator("poisson")
    @classmethod
    def _poisson(cls, value: float) -> float:
        if not -1 < value <= 0.5:
            raise ValueError(f"Poisson's ratio {value:g} must lie above -1 and at most 0.5. Steel: 0.3.")
        return value

    @field_validator("thermal_expansion")
    @classmethod
    def _expansion(cls, value: float | None) -> float | None:
        if value is not None and not abs(value) < 1e-3:
            raise ValueError(f"{value:g} is no coefficient of expansion, 1/K. Steel: 12e-6.")
        return value


MaterialOrName = Annotated[Annotated[Material, Tag("record")] | Annotated[MaterialName, Tag("name")], NameOrRecord]
