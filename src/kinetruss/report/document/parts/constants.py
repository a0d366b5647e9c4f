"""Constants of the sections of a model: area, second moments, moduli, radii of gyration, torsion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup
from kinetruss.model import Active
from kinetruss.report.document.frame import Columns
from kinetruss.report.document.parts.inputs import listed, worded

if TYPE_CHECKING:
    from kinetruss.model import Model

__all__ = ["section_constants"]


def section_constants(model: Model) -> list[Markup]:
    """A table of A, I, W, r about both axes and J of every section in use; nothing without sections."""
    users: dict[str, list[str]] = {}
    sections: dict[str, Any] = {}
    for name, member in {**model.members, **model.beams}.items():
        rods = {f"{name}.base": member.base, f"{name}.tube": member.tube} if isinstance(member, Active) else {name: member}
        for label, rod in rods.items():
            section = model.section_of(rod)
            if section is not None:
                users.setdefault(worded(section), []).append(label)
                sections.setdefault(worded(section), section)
    if not sections:
        return []
    every, several = list(sections.values()), sum(map(len, users.values()))
    table = Columns().words("section", list(sections)).words("used by", [listed(users[text], several) for text in sections])
    table.measured("A (mm²)", [1e6 * one.area for one in every], "")
    seconds = [[1e12 * one.second_moments[k] for one in every] for k in (0, 1)]
    moduli = [[1e9 * one.second_moments[k] / one.extreme_fibres[1 - k] for one in every] for k in (0, 1)]
    radii = [[1e3 * math.sqrt(one.second_moments[k] / one.area) for one in every] for k in (0, 1)]
    if all(one.round for one in every):
        table.measured("I (mm⁴)", seconds[0], "").measured("W (mm³)", moduli[0], "").measured("r (mm)", radii[0], "")
    else:
        table.together(["I₂ (mm⁴)", "I₃ (mm⁴)"], seconds, "").together(["W₂ (mm³)", "W₃ (mm³)"], moduli, "")
        table.together(["r₂ (mm)", "r₃ (mm)"], radii, "")
    table.measured("J (mm⁴)", [None if one.torsion_constant is None else 1e12 * one.torsion_constant for one in every], "")
    return [table.html("Constants of the sections", "Axes 2 and 3 are across the member, 3 is z in the plane.")]
