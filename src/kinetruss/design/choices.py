"""The candidates of a sizing: groups, tubes, catalogues, and a model with those that were chosen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.errors import Fault, ModelError
from kinetruss.io import read_catalogue
from kinetruss.kernels.sections.sizing import Sized
from kinetruss.model import Active, Bar, Catalogue, Gear, LeadScrew, Material, Mission, Model, Safety, Tube, matched, nearest
from kinetruss.strength import end_condition
from kinetruss.strength.parts import parts_of

if TYPE_CHECKING:
    from numpy.typing import NDArray


FOLDER = Path(__file__).parent / "catalogues"


def catalogue_names() -> tuple[str, ...]:
    """Names of the catalogues that are shipped."""
    return tuple(path.stem for path in sorted(FOLDER.glob("*.yaml")))


def catalogue(chosen: Catalogue | str | Path, place: tuple[str, ...] = ()) -> Catalogue:
    """A catalogue by its name, from a YAML or JSON file, or as it is; its material is a record.

    Parameters
    ----------
    place : the place of its name in the mission, for the fault of an unknown one.

    Raises
    ------
    ModelError : neither the name of one that is shipped nor a file; all faults of the file with line and column.

    Examples
    --------
    >>> len(catalogue("aluminium_tubes_inch").tubes)
    60
    """
    if isinstance(chosen, Catalogue):
        return chosen
    shipped = FOLDER / f"{chosen}.yaml"
    if str(chosen) in catalogue_names():
        return read_catalogue(shipped)
    if Path(chosen).suffix in (".yaml", ".yml", ".json", ".toml"):
        return read_catalogue(chosen)
    raise ModelError([Fault(place, f"no catalogue called {str(chosen)!r}.", nearest(chosen, catalogue_names()))])


# Groups of a mission that names none.

BAY = {
    "lower_longerons": ("M1", "M2", "M3", "M4", "M5", "M6"),
    "upper_longerons": ("M13", "M14", "M15", "M16", "M17", "M18"),
    "battens": ("M19", "M20", "M21"),
    "actuators": ("M7", "M9", "M11"),
}
"""Members of a double-octahedral bay that are alike by symmetry; names of Lacy (1991), table 4.1."""


def default_groups(model: Model) -> dict[str, tuple[str, ...]]:
    """Members that share a tube: longerons, battens and actuators of every bay; in other structures, members of one section.

    >>> from kinetruss.library import vgt
    >>> list(default_groups(vgt.double_octahedral(bays=2)))[:4]
    ['B1.lower_longerons', 'B1.upper_longerons', 'B1.battens', 'B1.actuators']
    """
    members = model.whole.real_members
    prefixes = dict.fromkeys(_prefix(name) for name in members)
    chains = {prefix + name for prefix in prefixes for names in BAY.values() for name in names}
    if chains == set(members):
        return {prefix + group: tuple(prefix + name for name in names) for prefix in prefixes for group, names in BAY.items()}
    return _by_section(model)


def default_drives(model: Model) -> dict[str, tuple[str, ...]]:
    """Active members that share screw, gear and motor: those of a bay (the part of the name before its last dot)."""
    found: dict[str, list[str]] = {}
    for name in model.active:
        found.setdefault(f"{_prefix(name)}drives", []).append(name)
    return {name: tuple(members) for name, members in found.items()}


def _prefix(name: str) -> str:
    return name[: name.rfind(".") + 1]


def untubed(member: Bar | Active) -> str | None:
    """The kind of a member that cannot have a tube, in words, or None."""
    if not isinstance(member, Bar):
        return None
    return "a planar body" if member.body is not None else "a cable" if member.kind == "cable" else None


def _by_section(model: Model) -> dict[str, tuple[str, ...]]:
    """Bars of one section, and active members whose tubes have one.

    Members without a section, planar bodies, cables and springs of given stiffness are not sized.
    """
    kinds: dict[tuple[str, str], list[str]] = {}
    for name, member in model.whole.real_members.items():
        part = member.tube if isinstance(member, Active) else member
        section = model.section_of(part)
        if section is not None and untubed(member) is None and getattr(member, "stiffness", None) is None:
            kind = "actuators" if isinstance(member, Active) else "bars"
            kinds.setdefault((kind, section.model_dump_json()), []).append(name)
    several = {kind: sum(other == kind for other, _ in kinds) > 1 for kind, _ in kinds}
    found: dict[str, tuple[str, ...]] = {}
    for (kind, _), members in kinds.items():
        number = sum(name.startswith(kind) for name in found) + 1
        found[f"{kind}_{number}" if several[kind] else kind] = tuple(members)
    return found


# The candidate tubes of every member, by name and as arrays for the kernels.


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
        members = dict.fromkeys(one for pattern in patterns for one in matched(list(model.whole.real_members), pattern))
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
    _whole_hubs(model, groups)
    return _arrays(model, mission, tuple(groups))


def _whole_hubs(model: Model, groups: Sequence[SizedGroup]) -> None:
    """Refuse to size some arms of a hub, or in several groups: all have its section.

    Raises
    ------
    ModelError : with the hub, and all its arms.
    """
    for hub, arms in model.whole.inner.arms.items():
        names = [arm.name for arm in arms]
        sized = [group for group in groups if not set(names).isdisjoint(group.members)]
        if sized and not set(names) <= set(sized[0].members):
            mend = f"Name all of them in one group, or none: {', '.join(names)}."
            raise ModelError(
                [Fault(("groups", sized[0].name), f"has not all arms of hub {hub!r}, which have one section.", mend)]
            )


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
        if what := untubed(model.whole.members[name]):
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
    member = model.whole.members[name]
    return member.tube if isinstance(member, Active) else member


def _arrays(model: Model, mission: Mission, groups: tuple[SizedGroup, ...]) -> Plan:
    parts, index = parts_of(model), {name: k for k, name in enumerate(model.whole.members)}
    rows = [(name, g) for g, group in enumerate(groups) for name in group.members]
    member = np.array([index[name] for name, _ in rows], np.int64)
    active = np.array([name in model.active for name, _ in rows], np.bool_)
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
    member: Bar | Active = model.whole.members[name]
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


# A model with the chosen tubes and drives.


def with_tubes(model: Model, plan: Plan, choice: NDArray[np.int64]) -> Model:
    """The model with a tube for every group; the masses of its members are those of the tubes."""
    bars, active, hubs = dict(model.bars), dict(model.active), dict(model.hubs)
    sections, materials = dict(model.sections), dict(model.materials)
    for group, index in zip(plan.groups, choice, strict=True):
        section = _entry(sections, group.tube_name(int(index)), group.tube(int(index)))
        changes: dict[str, Any] = {"section": section, "mass": None}
        if group.material is not None:
            changes["material"] = _entry(materials, "sized", group.material)
        for name in group.members:
            if name in active:
                active[name] = active[name].with_(tube=active[name].tube.with_(**changes))
            elif name in bars:
                bars[name] = bars[name].with_(**changes)
            else:
                hub = model.whole.inner.bars[name].name
                hubs[hub] = hubs[hub].with_(**{key: one for key, one in changes.items() if key != "mass"})
    changed: dict[str, Any] = {"bars": bars, "active": active, "hubs": hubs, "safety": plan.safety}
    changed["sections"] = _used(model, sections, {**bars, **hubs}, active, "section")
    changed["materials"] = _used(model, materials, {**bars, **hubs}, active, "material")
    return model.with_(**changed)


def with_drives(model: Model, chosen: Mapping[str, tuple[tuple[str, Any], ...]]) -> Model:
    """The model with screws, gears and motors: member -> (name, record) of each chosen one."""
    tables: dict[str, dict[str, Any]] = {kind: dict(getattr(model, kind)) for kind in ("screws", "gears", "motors")}
    active = dict(model.active)
    for member, records in chosen.items():
        changes = {}
        for name, one in records:
            kind = "screw" if isinstance(one, LeadScrew) else "gear" if isinstance(one, Gear) else "motor"
            changes[kind] = _entry(tables[f"{kind}s"], name, one)
        active[member] = active[member].with_(**changes)
    for kind, table in tables.items():
        named = {getattr(member, kind[:-1]) for member in active.values()}
        tables[kind] = {name: one for name, one in table.items() if name in named or name not in _named_before(model, kind)}
    return model.with_(active=active, **tables)


def _named_before(model: Model, kind: str) -> set[Any]:
    return {getattr(member, kind[:-1]) for member in model.active.values()}


def _entry(table: dict[str, Any], name: str, record: Any) -> str:
    """The name of a record in a table; the record is added under a free name if the table does not have it."""
    while name in table and table[name] != record:
        name += "_"
    table[name] = record
    return name


def _used(
    model: Model, table: dict[str, Any], bars: Mapping[str, Any], active: dict[str, Active], field: str
) -> dict[str, Any]:
    """The table without entries that only sized members used before."""

    def names(some_bars: Mapping[str, Any], some_active: Mapping[str, Active]) -> set[Any]:
        parts = [*some_bars.values(), *(part for one in some_active.values() for part in (one.base, one.tube))]
        return {getattr(part, field) for part in parts if isinstance(getattr(part, field), str)}

    before, now = names({**model.bars, **model.hubs}, model.active), names(bars, active)
    default = getattr(model, field)
    return {name: one for name, one in table.items() if name in now or name not in before or name == default}
