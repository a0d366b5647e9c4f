"""The candidate tubes of every member, by name and as arrays for the kernels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.design._catalogue import catalogue
from kinetruss.design._groups import default_groups, untubed
from kinetruss.errors import Fault, ModelError
from kinetruss.kernels.sections.sizing import Sized
from kinetruss.model import Active, Bar, Catalogue, Material, Mission, Model, Safety, Tube, matched
from kinetruss.strength import end_condition
from kinetruss.strength.members import parts_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Plan", "SizedGroup", "make_plan"]


@dataclass(frozen=True, kw_only=True)
class SizedGroup:
    """Members that share a tube, and the tubes to choose from, lightest first.

    first : index of the lightest in the tubes of all groups. material : of the catalogue, or None: members keep theirs.
    """

    name: str
    members: tuple[str, ...]
    catalogue: str
    names: tuple[str, ...]
    tubes: tuple[Tube, ...]
    material: Material | None
    first: int

    def tube(self, index: int) -> Tube:
        """A tube by its index in the tubes of all groups."""
        return self.tubes[index - self.first]

    def tube_name(self, index: int) -> str:
        """Its name in the catalogue."""
        return self.names[index - self.first]


@dataclass(frozen=True, kw_only=True, eq=False)
class Plan:
    """Groups, and their arrays for kernels; group_of : member -> index of its group."""

    groups: tuple[SizedGroup, ...]
    group_of: dict[str, int]
    safety: Safety
    sized: Sized

    @property
    def start(self) -> NDArray[np.int64]:
        """(groups,): the lightest tube of each."""
        return self.sized.start

    @property
    def stop(self) -> NDArray[np.int64]:
        """(groups,): the index after the last tube of each."""
        return self.sized.stop


def make_plan(model: Model, mission: Mission) -> Plan:
    """The groups of a mission with their tubes.

    Raises
    ------
    ModelError : an unknown or faulty catalogue, one without tubes, members without material or yield strength.
    """
    groups, faults, first = [], [], 0
    shelf: dict[int | str, Catalogue] = {}
    for name, patterns, chosen, place in _wanted(model, mission):
        key = chosen if isinstance(chosen, str) else id(chosen)
        if key not in shelf:
            shelf[key] = catalogue(chosen, place)
        stock = shelf[key]
        if not stock.tubes:
            raise ModelError([Fault(place, "the catalogue has no tubes.", "Name one with a table tubes.")])
        weights = {name: _weight(tube.section) for name, tube in stock.tubes.items()}
        order = sorted(weights, key=weights.__getitem__)
        label = stock.title or (chosen if isinstance(chosen, str) else "the catalogue")
        members = dict.fromkeys(one for pattern in patterns for one in matched(list(model.members), pattern))
        material = stock.material if isinstance(stock.material, Material) else None
        faults += list(_lacking(model, name, tuple(members), material))
        groups.append(
            SizedGroup(
                name=name,
                members=tuple(members),
                catalogue=label,
                names=tuple(order),
                tubes=tuple(stock.tubes[one].section for one in order),
                material=material,
                first=first,
            )
        )
        first += len(order)
    if faults:
        raise ModelError(faults)
    return _arrays(model, mission, tuple(groups))


def _wanted(model: Model, mission: Mission) -> list[tuple[str, tuple[str, ...], Catalogue | str, tuple[str, ...]]]:
    """Name, members and catalogue of every group, and the place of the name of the catalogue."""
    general, place = mission.catalogues.tubes, ("catalogues", "tubes")
    if mission.groups is None:
        return [] if general is None else [(name, one, general, place) for name, one in default_groups(model).items()]
    found: list[tuple[str, tuple[str, ...], Catalogue | str, tuple[str, ...]]] = []
    for name, group in mission.groups.items():
        if group.tubes is not None:
            found.append((name, group.members, group.tubes, ("groups", name, "tubes")))
        elif general is not None:
            found.append((name, group.members, general, place))
    return found


def _weight(tube: Tube) -> tuple[float, float]:
    """Order of tubes: by area, which is mass per length in one material; then the slimmer one first."""
    return tube.area, tube.outer


def _lacking(model: Model, group: str, members: tuple[str, ...], material: Material | None) -> list[Fault]:
    """Faults of members that cannot be checked without a material."""
    for name in members:
        if what := untubed(model.members[name]):
            mend = "Leave it out; only bars and active members have tubes."
            return [Fault(("groups", group), f"member {name!r} is {what}, which has no tube.", mend)]
        stuff = material or model.material_of(_part(model, name))
        if stuff is None or stuff.yield_strength is None:
            what = "material" if stuff is None else "yield strength"
            mend = "Give the catalogue a material, or the member one with a yield strength."
            return [Fault(("groups", group), f"member {name!r} has no {what}, so no tube can be judged.", mend)]
    return []


def _part(model: Model, name: str) -> Any:
    """The record that gets the tube: a bar, or the tube of an active member."""
    member = model.members[name]
    return member.tube if isinstance(member, Active) else member


def _arrays(model: Model, mission: Mission, groups: tuple[SizedGroup, ...]) -> Plan:
    parts, index = parts_of(model), {name: k for k, name in enumerate(model.members)}
    rows = [(name, g) for g, group in enumerate(groups) for name in group.members]
    member = np.array([index[name] for name, _ in rows], np.int64)
    active = np.array([isinstance(model.members[name], Active) for name, _ in rows], np.bool_)
    first = parts.first[member] if rows else np.zeros(0, np.int64)
    tubes = [tube for group in groups for tube in group.tubes]
    start = np.array([group.first for group in groups], np.int64)
    safety = mission.safety or model.safety
    stuff = np.array([_stuff(model, name, groups[g].material) for name, g in rows]).reshape(-1, 5).T
    sized = Sized.of(
        {
            "n_yield": safety.yielding,
            "n_buckling": safety.buckling,
            "moment_factor": 1.0,
            "part": np.where(active, first + 1, first),
            "base": np.where(active, first, -1),
            "member": member,
            "group": [g for _, g in rows],
            "start": start,
            "stop": np.append(start[1:], len(tubes)) if groups else start,
            **dict(zip(("E", "strength", "base_least", "base_largest", "base_squash"), stuff, strict=True)),
            "area": [tube.area for tube in tubes],
            "inertia": [tube.second_moments[0] for tube in tubes],
            "fibre": [tube.extreme_fibres[0] for tube in tubes],
            "factor": [tube.shear_factor for tube in tubes],
        }
    )
    return Plan(groups=groups, group_of=dict(rows), safety=safety, sized=sized)


def _stuff(model: Model, name: str, material: Material | None) -> tuple[float, ...]:
    """E, strength, base_least, base_largest, base_squash of `Sized`."""
    member: Bar | Active = model.members[name]
    C = end_condition(member.buckling)
    # members without a material, or without its yield strength, are refused before
    own = cast("Material", material or model.material_of(_part(model, name)))
    base = (0.0, 0.0, 0.0)
    if isinstance(member, Active):
        section, stuff = model.section_of(member.base), model.material_of(member.base)
        if section is not None and stuff is not None:
            stiff = [C * stuff.E * moment for moment in section.second_moments]
            base = (min(stiff), max(stiff), section.area * (stuff.yield_strength or 0.0))
    return C * own.E, cast("float", own.yield_strength), *base
