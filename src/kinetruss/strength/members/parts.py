"""Parts of members: every bar, and the base and tube of every active member, with their sections and materials."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.sections.stress import GENERAL, RECTANGLE, ROUND, UNKNOWN
from kinetruss.mechanics import CABLE, System, compile, kept
from kinetruss.model import Active, Bar, Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Parts", "parts_of"]

_SHAPES = {"tube": ROUND, "rod": ROUND, "rectangle": RECTANGLE, "general": GENERAL}


@dataclass(frozen=True, kw_only=True, eq=False)
class Parts:
    """Parts in the order of the members; the base of an active member before its tube.

    names, members (parts,): names of parts and of their members. member (parts,): index of the member. first (members,):
    index of each member's first part. two (members,): active members. cable (members,). body (parts,): planar bodies.
    length (parts,): m, NaN for bars. shape (parts,): codes of `kernels.sections.stress`. area m^2, I2, I3 m^4, c2, c3 m, factor
    (shear), E, G, yield_strength Pa: NaN where not known. twist: largest shear stress of torsion over torque, 1/m^3.
    """

    names: tuple[str, ...]
    members: tuple[str, ...]
    member: NDArray[np.int64]
    first: NDArray[np.int64]
    two: NDArray[np.bool_]
    cable: NDArray[np.bool_]
    body: NDArray[np.bool_]
    length: NDArray[np.float64]
    shape: NDArray[np.int64]
    area: NDArray[np.float64]
    I2: NDArray[np.float64]
    I3: NDArray[np.float64]
    c2: NDArray[np.float64]
    c3: NDArray[np.float64]
    factor: NDArray[np.float64]
    E: NDArray[np.float64]
    G: NDArray[np.float64]
    yield_strength: NDArray[np.float64]
    twist: NDArray[np.float64]

    @property
    def judged(self) -> tuple[str, ...]:
        """Names of the members that have a section in one of their parts."""
        return tuple(dict.fromkeys(name for name, shape in zip(self.members, self.shape, strict=True) if shape != UNKNOWN))

    @cached_property
    def base(self) -> NDArray[np.bool_]:
        """(parts,): base rods of active members, which overhang beyond the interface to the tube."""
        found = np.zeros(len(self.names), np.bool_)
        found[self.first[self.two]] = True
        return found

    @property
    def scale(self) -> NDArray[np.float64]:
        """(parts, 4): factors from T, M2, M3 and V to nominal stresses: 1/A, c3/I2, c2/I3, shear factor/A."""
        return np.stack([1 / self.area, self.c3 / self.I2, self.c2 / self.I3, self.factor / self.area], axis=1)

    def lengths(self, member_length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Lengths of all parts (times, parts), m, from those of the members (times, members)."""
        found = member_length[:, self.member]
        known = ~np.isnan(self.length)
        found[:, known] = self.length[known]
        return found

    def starts(self, member_length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Distance (times, parts), m, of each part's end towards A from the member's end A."""
        tube = self.first[self.two] + 1
        found = np.zeros((len(member_length), len(self.names)))
        found[:, tube] = member_length[:, self.two] - self.length[tube]
        return found


def parts_of(model: Model) -> Parts:
    """The parts of a model."""
    return _parts(compile(model))


@kept()
def _parts(system: System) -> Parts:
    model = system.model
    rows: list[tuple[str, str, int, float, tuple[float, ...]]] = []
    first = []
    for k, (name, member) in enumerate(model.members.items()):
        first.append(len(rows))
        if isinstance(member, Active):
            for role, part in (("base", member.base), ("tube", member.tube)):
                rows.append((f"{name}.{role}", name, k, part.length, _numbers(model, part)))
        else:
            rows.append((name, name, k, np.nan, _numbers(model, member)))
    numbers = np.array([row[4] for row in rows]).reshape(len(rows), 11)
    area, I2, I3, c2, c3, factor, E, poisson, strength, shape, twist = numbers.T
    return Parts(
        names=tuple(row[0] for row in rows),
        members=tuple(row[1] for row in rows),
        member=np.array([row[2] for row in rows], np.int64),
        first=np.array(first, np.int64),
        cable=system.law == CABLE,
        body=system.is_body[[row[2] for row in rows]],
        two=np.array([isinstance(member, Active) for member in model.members.values()], np.bool_),
        length=np.array([row[3] for row in rows], float),
        shape=shape.astype(np.int64),
        area=area,
        I2=I2,
        I3=I3,
        c2=c2,
        c3=c3,
        factor=factor,
        E=E,
        G=E / (2 * (1 + poisson)),
        yield_strength=strength,
        twist=twist,
    )


def _numbers(model: Model, part: Any) -> tuple[float, ...]:
    section, material = model.section_of(part), model.material_of(part)
    if isinstance(part, Bar) and part.body is not None:
        section = material = None
    shape = (np.nan,) * 6
    if section is not None:
        shape = (section.area, *section.second_moments, *section.extreme_fibres, section.shear_factor)
    stuff = (np.nan,) * 3
    if material is not None:
        stuff = (material.E, material.poisson, material.yield_strength or np.nan)
    known = section is not None and section.torsion_arm is not None
    twist = section.torsion_arm / section.torsion_constant if known else np.nan
    return (*shape, *stuff, UNKNOWN if section is None else _SHAPES[section.kind], twist)
