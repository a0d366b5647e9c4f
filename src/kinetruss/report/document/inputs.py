"""Tables of the inputs of a run: structure, supports, loads, materials, sections, drive trains, lists of nodes and members."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, get_args

from kinetruss.display import Table, counted, quantity
from kinetruss.display.tables import measured, together, words
from kinetruss.mechanics import compile
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.model import Active, Link, Model, Of, Record, Run
from kinetruss.model.data import ELEMENT_FIELDS, FORCE_ELEMENTS
from kinetruss.model.in_time import MomentOf
from kinetruss.model.links import length_along
from kinetruss.model.load_cases import sets_of
from kinetruss.model.loads_along import PlaceOf
from kinetruss.model.supports import support_words
from kinetruss.report.tables import METHODS
from kinetruss.units import EITHER, unit_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kinetruss.runs import RunResult

    Row = dict[str, Any]


def section_constants(model: Model) -> list[Table]:
    """A table of A, I, W, r about both axes and J of every section in use; nothing without sections."""
    users: dict[str, list[str]] = {}
    sections: dict[str, Any] = {}
    for name, member in {**model.whole.real_members, **model.bending}.items():
        rods = {f"{name}.base": member.base, f"{name}.tube": member.tube} if isinstance(member, Active) else {name: member}
        for label, rod in rods.items():
            section = model.section_of(rod)
            if section is not None:
                users.setdefault(worded(section), []).append(label)
                sections.setdefault(worded(section), section)
    if not sections:
        return []
    several = sum(map(len, users.values()))
    rows = [_constants(one) | {"section": text, "users": listed(users[text], several)} for text, one in sections.items()]
    axes = [""] if all(one.round for one in sections.values()) else ["₂", "₃"]
    columns = [words("section"), words("used by", "users"), measured("A (mm²)", "A")]
    for symbol, unit in (("I", "mm⁴"), ("W", "mm³"), ("r", "mm")):
        columns += together("", {f"{symbol}{axis} ({unit})": f"{symbol}{k}" for k, axis in enumerate(axes)})
    columns.append(measured("J (mm⁴)", "J"))
    foot = "Axes 2 and 3 are across the member, 3 is z in the plane."
    return [Table(columns, rows, "Constants of the sections", foot=foot)]


def _constants(section: Any) -> Row:
    """A, J and, about axes 2 and 3, I, W and r, in mm."""
    found = {"A": 1e6 * section.area, "J": None if section.torsion_constant is None else 1e12 * section.torsion_constant}
    for k, (I, c) in enumerate(zip(section.second_moments, reversed(section.extreme_fibres), strict=True)):
        found |= {f"I{k}": 1e12 * I, f"W{k}": 1e9 * I / c, f"r{k}": 1e3 * math.sqrt(I / section.area)}
    return found


# Lists of a structure: its nodes, its members with length, section and mass, and the mass of the whole.


def lists(model: Model) -> list[Table]:
    """The tables of nodes and of members of the model as it stands."""
    return [_nodes(model), _members(model)]


def nodes_of(model: Model) -> list[Row]:
    """Every node: name, place (m), supported axes and lumped mass (kg)."""
    return [
        {"node": name, "at": list(node.at), "support": _support(model, name), "mass": node.mass or 0.0}
        for name, node in model.nodes.items()
    ]


def _support(model: Model, name: str) -> str:
    if name in model.clamped:
        return "clamped" if model.clamped[name] == "ground" else f"clamped to {model.clamped[name]}"
    if name in model.supports:
        return support_words(model.supports[name])
    return model.fixed.get(name, "")


def members_of(model: Model) -> list[Row]:
    """Every bar, active member, beam and link, and arms of hubs with a mass: name, kind, ends, length (m), section and mass
    (kg), without masses on its nodes. A bar that stands for a planar body has the mass of the body.
    """
    system = compile(model)
    mass = system.rods[:, 0] + system.rods[:, 3] + system.body[:, 0]
    found = []
    for k, (name, member) in enumerate({**system.model.real_members, **model.members}.items()):
        if name not in model.members and not mass[k]:
            continue
        rods = (member.base, member.tube) if isinstance(member, Active) else (member,)
        kind = "active" if isinstance(member, Active) else str(member.kind)
        found.append(_entry(name, kind, member.ends, float(system.length0[k]), _sections(model, rods), float(mass[k])))
    for name, beam in model.bending.items():
        length = length_along(model, beam)
        section, material = model.section_of(beam), model.material_of(beam)
        own = beam.mass
        if own is None:
            own = 0.0 if section is None or material is None else material.density * section.area * length
        kind, ends = ("link", beam.nodes) if isinstance(beam, Link) else ("beam", beam.ends)
        kind = kind if (beam.kind == "elastic") == (kind == "beam") else f"{beam.kind} {kind}"
        found.append(_entry(name, kind, ends, length, _sections(model, (beam,)), float(own)))
    return found


def _entry(name: str, kind: str, ends: Sequence[str], length: float, section: str, mass: float) -> Row:
    return {"member": name, "kind": kind, "ends": list(ends), "length": length, "section": section, "mass": mass}


def _sections(model: Model, rods: Sequence[Any]) -> str:
    """The sections in words, of an active member those of base and tube."""
    return "; ".join(worded(one) for rod in rods if (one := model.section_of(rod)) is not None)


def total_mass(model: Model) -> float:
    """Mass of everything in a model, kg."""
    return float(mass_by_nodes(compile(model)).sum())


def _nodes(model: Model) -> Table:
    columns = [
        words("node"),
        *together("m", {axis: ("at", k) for k, axis in enumerate("xyz"[: model.dim])}),
        words("support"),
        measured("mass on it", lambda row: row["mass"] or None, "kg"),
    ]
    return Table(columns, nodes_of(model), "Nodes, in the position of the model")


def _members(model: Model) -> Table:
    rows = members_of(model)
    columns = [
        words("member"),
        words("kind"),
        words("ends", lambda row: " – ".join(row["ends"])),
        measured("length", unit="m"),
        words("section"),
        measured("mass", unit="kg"),
    ]
    own, whole = sum(row["mass"] for row in rows), total_mass(model)
    foot = f"Total of {counted(len(rows), 'member')}: {quantity(own, 'kg')}."
    others = [
        *(["masses on nodes"] if any(node.mass for node in model.nodes.values()) else []),
        *(["bodies"] if model.bodies else []),
        *(["membranes and solids"] if model.membranes or model.solids else []),
    ]
    if others:
        foot += f" With {', '.join(others)}, everything in the model: {quantity(whole, 'kg')}."
    return Table(columns, rows, "Members, in the position of the model", foot=foot)


# Tables of the inputs: run, structure, supports and loads, materials, sections and drive trains.

NAMES = 8
"""Largest number of values of a table in a record that are shown; the page includes the whole model."""
DIGITS = 6
"""Significant digits of the model's numbers."""
WORDS = {
    "poisson": "Poisson's ratio",
    "emf_constant": "back-emf constant",
    "rtol": "relative tolerance",
    "atol": "absolute tolerance",
    "max_steps": "at most this many steps:",
    "max_voltage": "highest voltage",
    "max_current": "highest current",
    "max_speed": "highest speed",
    "max_torque": "largest torque",
    "flank": "half-angle of the thread",
    "source": "source:",
    **METHODS,
}
"""Names of fields and kinds that are not words."""
UNITLESS = {"thermal_expansion": "1/K", "matched_expansion": "1/K", "temperature": "K"}
"""Units that fields do not carry."""
ANALYSES = {
    "dynamics.inverse": "inverse dynamics: a given motion, and all forces that it needs",
    "kinematics.follow": "kinematics: a given motion, without forces",
    "statics.linear": "statics: small displacements of an elastic structure, and its forces",
    "statics.equilibrium": "statics: the equilibrium with large displacements, its forces and its stability",
    "statics.at_poses": "statics: the forces of poses at rest",
    "statics.deflection": "inverse dynamics, and the small displacements of elastic members along the motion",
    "flexible.corrected": "inverse dynamics, and the drive lengths with which the loaded elastic structure has the rigid pose",
    "flexible.frequencies": "inverse dynamics, and the natural frequencies of the elastic structure along the motion",
    "flexible.vibration": "inverse dynamics, and the vibration of elastic members that the motion excites",
    "mission": "a mission: all motions under all conditions and load cases, and their envelope",
    "dynamics.simulate": "forward dynamics: the motion caused by weight, loads, springs and motors, and its forces",
}


def inputs(run: RunResult, name: str = "") -> list[Table]:
    """The tables that are not empty. name : of the run, if it has another one for readers."""
    model = run.model
    found = [
        Table(("", ""), _run_rows(run, name or run.name), "What was computed"),
        Table(("", ""), _structure_rows(model), "The structure"),
    ]
    lists: tuple[tuple[str, str, Iterable[tuple[str, str]]], ...] = (
        ("Materials and sections", "used by", _parts(model)),
        ("Drive trains", "used by", _trains(model)),
        *(
            (f"{one.capitalize()}{' on coordinates' * (kind in FORCE_ELEMENTS)} (SI)", "name", _named(getattr(model, one)))
            for kind, one in ELEMENT_FIELDS.items()
        ),
        ("Loads and load cases", "name", [*_named(model.loads), *_named(model.load_cases, "load case ")]),
        ("Combinations of load cases", "name", [*_combinations(model)]),
        ("Tasks of drives and events", "name", [*_named(run.definition.tasks), *_named(run.definition.events, "event ")]),
    )
    return [*found, *(Table((head, "what"), rows, caption) for caption, head, rows in lists)]


def _combinations(model: Model) -> Iterator[tuple[str, str]]:
    """Combinations and the factors of their cases; those that standards make, with their clauses."""
    for one, names in sets_of(model).items():
        if names != (one,):
            yield one, worded(model.combinations[one])
        yield from ((name, model.cases[name].title) for name in names)


def _run_rows(run: RunResult, name: str) -> Iterator[tuple[str, str]]:
    definition = run.definition
    yield "run", name
    yield "analysis", f"{ANALYSES[definition.analysis]} (in the model file: {definition.analysis})"
    if definition.motion is not None:
        yield "motion", f"node histories from the file {definition.motion.replace(chr(92), '/').rpartition('/')[2]}"
    elif definition.targets is not None:
        yield "task (m, rad, s)", worded(definition.targets)
    elif definition.trajectory is not None:
        yield "trajectory (m, rad, s)", worded(definition.trajectory)
    if definition.condition is not None:
        yield "condition", f"{definition.condition}: {worded(run.origin.conditions[definition.condition])}"
    if definition.t_end is not None:
        yield "simulated time", quantity(definition.t_end, "s")
        yield "method", _method(run, definition)
    yield "samples", f"{run.samples} requested, {run.good} good"
    if run.forces:
        yield "load cases", ", ".join("all loads" if case == "all" else case for case in run.forces)
        yield "stations along members", str(definition.stations)
    for path, value in run.settings.items():
        yield f"set: {path}", str(value)


def _method(run: RunResult, definition: Run) -> str:
    """The method used, with all its options, or its name if the run was stored without them."""
    taken = {} if run.simulation is None else run.simulation.data.attrs
    if "method_options" in taken:
        definition = definition.with_(method=json.loads(taken["method_options"]))
    if definition.method is not None:
        return worded(definition.method, whole=True)
    return str(taken.get("method") or "chosen for the motion")


def _structure_rows(model: Model) -> Iterator[tuple[str, str]]:
    kinds = [bar.kind for bar in model.bars.values()]
    counts = ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))
    yield "nodes", f"{len(model.nodes)}, in {'the plane' if model.dim == 2 else 'space'}"
    if kinds or not model.bending:
        yield "bars", f"{len(kinds)}" + (f" ({counts})" if kinds else "")
    if model.beams:
        yield "beams", f"{len(model.beams)}: {listed(_ended(model))}"
    if model.links:
        links = (
            f"{name} ({'' if one.kind == 'rigid' else 'elastic, '}{'-'.join(one.nodes)})" for name, one in model.links.items()
        )
        yield "links", f"{len(model.links)}: {listed(links)}"
    for what, records in (("membranes", model.membranes), ("solids", model.solids)):
        if records:
            yield what, f"{len(records)}: {listed(records)}"
    if model.active:
        yield "active members", f"{len(model.active)}: {listed(model.active)}"
    if model.bodies:
        yield "bodies", f"{len(model.bodies)}: {listed(model.bodies)}"
    yield "drives", listed(f"{name} ({drive.kind})" for name, drive in model.all_drives.items()) or "none"
    held = [f"{name} ({axes})" for name, axes in model.fixed.items() if name not in model.clamped]
    held += [f"{name} (clamped{'' if one == 'ground' else f' to {one}'})" for name, one in model.clamped.items()]
    held += [f"{name} ({support_words(one)})" for name, one in model.supports.items()]
    yield "supports", listed(held) or "none"
    masses = [f"{name} {quantity(node.mass, 'kg')}" for name, node in model.nodes.items() if node.mass]
    if masses:
        yield "lumped masses", listed(masses)
    yield "gravity", _vector(model.gravity, "m/s²") if model.gravity else "none"
    if model.base_rotation is not None:
        yield "rotation of the base", worded(model.base_rotation)
    if model.support_motion:
        yield "moving supports", listed(model.support_motion)
    yield "safety factors", f"{model.safety.yielding:g} on yielding, {model.safety.buckling:g} on buckling"


def _ended(model: Model) -> Iterator[str]:
    """Beams with what is not plain of them: their kind, ends that turn."""
    for name, beam in model.beams.items():
        words = [*(["rigid"] if beam.kind == "rigid" else []), *(f"pinned at {end}" for end in beam.release)]
        words += [f"hinged at {end}" for end in beam.hinges]
        yield f"{name} ({', '.join(words)})" if words else name


def _parts(model: Model) -> Iterator[tuple[str, str]]:
    """Materials and sections with the parts that use them."""
    users: dict[str, list[str]] = {}
    for name, member in {**model.whole.real_members, **model.bending}.items():
        parts = {f"{name}.base": member.base, f"{name}.tube": member.tube} if isinstance(member, Active) else {name: member}
        for label, part in parts.items():
            for record in (model.material_of(part), model.section_of(part)):
                if record is not None:
                    users.setdefault(worded(record), []).append(label)
    for name, skin in (model.membranes | model.solids).items():
        material = model.material_of(skin)
        if material is not None:
            users.setdefault(worded(material), []).append(name)
    several = len({name for names in users.values() for name in names})
    for text, names in users.items():
        yield listed(names, several), text


def _trains(model: Model) -> Iterator[tuple[str, str]]:
    """Screws, gears, motors, amplifiers with the members and drives that use them."""
    users: dict[str, list[str]] = {}
    homes: dict[str, Mapping[str, Any]] = {
        "screw": model.screws,
        "gear": model.gears,
        "motor": model.motors,
        "amplifier": model.amplifiers,
    }
    for kind, home in homes.items():
        for name, member in model.actuators.items():
            given = getattr(member, kind, None)
            record = home[given] if isinstance(given, str) else given
            if record is not None:
                users.setdefault(f"{kind}: {worded(record)}", []).append(name)
    for text, names in users.items():
        yield listed(names), text


def _named(records: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, str]]:
    for name, record in records.items():
        yield f"{before}{name}", worded(record) or "gravity only"


def worded(record: Any, whole: bool = False) -> str:
    """A record as text: its fields without defaults (with `whole`, all fields), with units.

    >>> import kinetruss as kt
    >>> worded(kt.Tube(outer=0.019, inner=0.016))
    'tube, outer 19 mm, inner 16 mm'
    """
    parts = [_spaced(str(record.kind))] if "kind" in type(record).model_fields else []
    for name, field in type(record).model_fields.items():
        value = getattr(record, name)
        if name != "kind" and (whole or field.is_required() or value != field.get_default()) and value is not None:
            unit = _unit(field.metadata, field.annotation) or UNITLESS.get(name, "")
            parts.append(f"{_spaced(name)} {_valued(value, unit)}".strip())
    return ", ".join(parts)


def _spaced(name: str) -> str:
    return WORDS.get(name) or name.replace("_", " ")


def _unit(metadata: Iterable[Any], annotation: Any) -> str:
    """The unit of a field, or of the numbers in it."""
    for rule in metadata:
        if isinstance(rule, (Of, MomentOf, PlaceOf)):
            # what a trajectory moves or a spring holds may be a length or an angle
            return "" if rule.quantity in EITHER else unit_of(rule.quantity)
    return next((found for one in get_args(annotation) if (found := _unit(getattr(one, "__metadata__", ()), one))), "")


def _valued(value: Any, unit: str) -> str:
    if isinstance(value, Record):
        return f"({worded(value)})"
    if isinstance(value, Mapping):
        return "; ".join(f"{key}: {_valued(one, unit)}" for key, one in value.items()) or "none"
    if isinstance(value, (list, tuple)):
        if len(value) > NAMES:
            return f"a table of {len(value)}"
        return f"[{', '.join(_valued(one, '') for one in value)}] {_marked(unit)}".rstrip()
    if isinstance(value, bool):
        return "yes" if value else "no"
    return _numbered(value, unit) if isinstance(value, float) else str(value)


def _numbered(value: float, unit: str) -> str:
    """A number of the model; the model file at the end of the report has all digits."""
    if unit == "m/rad":
        return quantity(1e3 * value, "mm/rad", DIGITS)
    return quantity(value, unit, DIGITS)


def _marked(unit: str) -> str:
    return unit.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")


def _vector(values: Iterable[float], unit: str) -> str:
    return f"({', '.join(f'{value:g}' for value in values)}) {unit}"


def listed(names: Iterable[str], every: int = 0) -> str:
    """All names; that they are all, if they are `every` one of many: another table names each."""
    shown = list(names)
    return f"all {every} parts" if every == len(shown) > NAMES else ", ".join(shown)


def sources(model: Model) -> list[str]:
    """Sources of the model's numbers, as given in their records, without duplicates."""
    return list(dict.fromkeys(_sources(model.model_dump())))


def _sources(value: Any) -> Iterator[str]:
    if isinstance(value, Mapping):
        if isinstance(value.get("source"), str) and value["source"]:
            yield value["source"]
        for one in value.values():
            yield from _sources(one)
    elif isinstance(value, (list, tuple)):
        for one in value[:1000]:
            yield from _sources(one)
