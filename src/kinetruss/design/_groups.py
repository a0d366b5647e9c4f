"""Groups of a mission that names none."""

from __future__ import annotations

from kinetruss.model import Active, Bar, Model

__all__ = ["default_drives", "default_groups", "untubed"]

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
    prefixes = dict.fromkeys(_prefix(name) for name in model.members)
    chains = {prefix + name for prefix in prefixes for names in BAY.values() for name in names}
    if chains == set(model.members):
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
    for name, member in model.members.items():
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
