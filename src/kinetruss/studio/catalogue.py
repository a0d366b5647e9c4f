"""What a drawing may take from a list: sections with their numbers; and what its members weigh."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from kinetruss.design.choices import catalogue, catalogue_names
from kinetruss.mechanics import compile
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.model import Tube
from kinetruss.model.links import length_along
from kinetruss.shelves import shelf

if TYPE_CHECKING:
    from kinetruss.model import Model


@cache
def sections() -> tuple[dict[str, Any], ...]:
    """Sections of the library and tubes of all catalogues: `name`, `of` which list, what to write into a model (`section`),
    area (m^2) and the smaller second moment (m^4), lightest first within a list.
    """
    rows = [_row(name, "library", name, section) for name, section in shelf("sections").items()]
    for title in catalogue_names():
        own = catalogue(title)
        tubes = sorted(own.tubes.items(), key=lambda one: one[1].section.area)
        rows += [_row(name, own.title or title, _written(one.section), one.section) for name, one in tubes]
    return tuple(rows)


def _row(name: str, of: str, written: Any, section: Any) -> dict[str, Any]:
    return {"name": name, "of": of, "section": written, "area": section.area, "inertia": min(section.second_moments)}


def _written(tube: Tube) -> dict[str, str]:
    return {"kind": "tube", "outer": f"{1000 * tube.outer:.6g} mm", "inner": f"{1000 * tube.inner:.6g} mm"}


def densities() -> dict[str, float]:
    """Of the materials of the library, kg/m^3."""
    return {name: material.density for name, material in shelf("materials").items()}


def weights(model: Model) -> dict[str, Any]:
    """Mass (kg) of each member by name, without masses on its nodes, and of the whole."""
    system = compile(model)
    found = dict(zip(system.members, (system.rods[:, 0] + system.rods[:, 3] + system.body[:, 0]).tolist(), strict=True))
    for name, one in model.bending.items():
        section, material = model.section_of(one), model.material_of(one)
        area = 0.0 if section is None or material is None else material.density * section.area
        found[name] = area * length_along(model, one) if one.mass is None else one.mass
    known = {*model.members, *model.bending}
    return {"members": {name: mass for name, mass in found.items() if name in known}, "all": float(mass_by_nodes(system).sum())}
