"""Values of a valid model that look like mistakes of units: millimetres, degrees, turns or GPa as bare SI numbers.

Such values are reported, not refused. The bounds are beyond real designs.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.data import FORCE_ELEMENTS
from kinetruss.model.drives import coordinate_kinds, turns
from kinetruss.model.links import length_along
from kinetruss.model.record import Record
from kinetruss.model.simulation import TRAJECTORY_TASKS
from kinetruss.model.trajectories import Sine, moved_by

if TYPE_CHECKING:
    from kinetruss.model.the_model import Model


SLENDER = 20_000
"""Largest plausible slenderness l/r of the shortest bar of a section, r^2 the product of its radii of gyration about both axes;
stay rods reach about 4000.
"""
SLIM = 40_000
"""The same of the longest one: a rod of 10 mm, 100 m long."""
HEAVY = 10 * 22_600.0
"""Largest plausible mass over the volume of a cube as wide as the model, kg/m^3: ten times osmium, the densest element."""
HEAVIEST = 1e9
"""Largest plausible mass, kg; the heaviest ships have 7e8."""
WIDE = 10.0
"""Largest plausible width of a section, m; legs of the largest platforms at sea have 8."""
STIFF = 2e12
"""Largest plausible modulus, Pa; diamond has 1.2e12."""

SOFT = 1e3
"""Least plausible modulus, Pa; soft gels have 1e3."""
DENSE = 25_000.0
"""Largest plausible density, kg/m^3; osmium has 22,600."""

LIGHT = 0.5
"""Least plausible density, kg/m^3; the lightest foams have 1."""
FLOPPY, COMPACT = 1e8, 2300.0
"""Least plausible modulus, Pa, of what is denser than this, kg/m^3: rubbers and gels are lighter."""
STIFF_AND_LIGHT = 1e9
"""Largest plausible ratio of modulus to density, m^2/s^2; graphene has 5e8."""
STRETCH = 10.0
"""Largest plausible ratio of yield strength to modulus; rubbers have 5."""
STRONG = 2e11
"""Largest plausible yield strength, Pa; carbon nanotubes have 1e11."""

WEAK = 1e4
"""Least plausible yield strength, Pa."""
LARGEST_GRAVITY = 300.0
"""Largest plausible gravity, m/s^2; the surface of the sun has 274."""
STEEP = 0.35
"""Largest plausible ratio of the lead (m/rad) of a screw to its mean radius; if the lead equals the diameter, it is 1/pi."""
TURNS = 10.0
"""rad; larger whole and half numbers without a unit are probably degrees."""
ROUND_RATES = (30.0, 45.0)
"""Multiples of these without a unit are probably rates in deg/s or rev/min, not in rad/s."""
TURNING = ("beta", "gamma", "roll", "pitch", "yaw")
"""Coordinates of tasks that are angles."""

Path = tuple[str | int, ...]


def plausibility(model: Model) -> list[Fault]:
    """Implausible values of a model without faults; see `kinematics.notes`.

    >>> import kinetruss as kt
    >>> tungsten = kt.Material(E=400e15, density=19300.0)  # E a million times too large
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, material=tungsten)
    >>> [fault.path for fault in kt.model.plausibility(model)]
    [('material', 'E')]
    """
    return [*_sections(model), *_materials(model), *_masses(model), *_gravity(model), *_screws(model), *_angles(model)]


def _sections(model: Model) -> Iterator[Fault]:
    """Sections wider than the longest bar that has them, or very thin for the shortest."""
    lengths: dict[Path, list[float]] = {}
    records: dict[Path, Any] = {}
    for path, part, length, stretched in _parts(model):
        if (section := model.section_of(part)) is not None and length > 0:
            own: Path = (*path, "section") if part.section is not None else ("section",)
            chosen = part.section if part.section is not None else model.section
            place = ("sections", chosen) if isinstance(chosen, str) else own
            records[place] = section
            lengths.setdefault(place, []).append(math.nan if stretched else length)
    for place, section in records.items():
        across, found = 2 * max(section.extreme_fibres), [length for length in lengths[place] if length == length]
        longest = max(found, default=math.inf)
        mend = "Write the unit, e.g. '20 mm'; a bare number is in m."
        if across > longest:
            yield Fault(place, f"is {across:g} m across, and the longest bar that has it is {longest:.3g} m long.", mend)
        elif across > WIDE:
            yield Fault(place, f"is {across:g} m across, wider than any bar or beam that is built.", mend)
        elif found:
            (I2, I3), area = section.second_moments, section.area
            radius = (I2 * I3) ** 0.25 / math.sqrt(area)
            if min(found) > SLENDER * radius or max(found) > SLIM * radius:
                yield Fault(place, f"is {across:g} m across, and a bar that has it is {max(found):.3g} m long.", mend)


def _parts(model: Model) -> Iterator[tuple[Path, Any, float, bool]]:
    """Place, record and length (m) of records that may have a section; whether it is a cable."""
    for name, bar in model.bars.items():
        yield ("bars", name), bar, bar.length or _length(model, bar), bar.kind == "cable"
    for name, active in model.active.items():
        for side in ("base", "tube"):
            part = getattr(active, side)
            yield ("active", name, side), part, part.length, False
    for name, beam in model.beams.items():
        yield ("beams", name), beam, _length(model, beam), False
    for name, link in model.links.items():
        yield ("links", name), link, length_along(model, link), False


def _length(model: Model, member: Any) -> float:
    return math.dist(*(model.nodes[end].at for end in member.ends))


def _materials(model: Model) -> Iterator[Fault]:
    found: list[tuple[Path, Any]] = [(("materials", name), one) for name, one in model.materials.items()]
    found += [((*path, "material"), one.material) for path, one in _material_fields(model)]
    rules = (
        ("E", STIFF, SOFT, "Pa", "'210 GPa'"),
        ("density", DENSE, LIGHT, "kg/m^3", "'7.85 g/cm^3'"),
        ("yield_strength", STRONG, WEAK, "Pa", "'235 MPa'"),
    )
    for path, material in found:
        alone = True
        for field, most, least, unit, example in rules:
            value = getattr(material, field, None)
            if value and not least <= value <= most:
                beyond = "more" if value > most else "less"
                mend = f"Write the unit, e.g. {example}; a bare number is in {unit}."
                yield Fault((*path, field), f"is {value:g} {unit}, {beyond} than any known material has.", mend)
                alone = False
        if alone:
            yield from _of_no_material(path, material)


def _of_no_material(path: Path, material: Any) -> Iterator[Fault]:
    """Values that are possible alone, but not together."""
    E, density, strength = (getattr(material, field, None) or 0.0 for field in ("E", "density", "yield_strength"))
    as_modulus = "Write the unit, e.g. '210 GPa'; a bare number is in Pa."
    if density > COMPACT and 0 < E < FLOPPY:
        yield Fault((*path, "E"), f"is {E:g} Pa, less than any material as dense as {density:g} kg/m^3 has.", as_modulus)
    elif strength > STRETCH * E > 0:
        yield Fault(
            (*path, "E"), f"is {E:g} Pa, and the yield strength {strength:g} Pa: no material stretches so far.", as_modulus
        )
    elif 0 < STIFF_AND_LIGHT * density < E:
        message = f"is {density:g} kg/m^3, less than any material as stiff as {E:g} Pa has."
        yield Fault((*path, "density"), message, "Write the unit, e.g. '7.85 g/cm^3'; a bare number is in kg/m^3.")


def _material_fields(model: Model) -> Iterator[tuple[Path, Any]]:
    yield (), model
    for table in ("bars", "membranes", "solids"):
        for name, one in getattr(model, table).items():
            yield (table, name), one


def _masses(model: Model) -> Iterator[Fault]:
    spans = [max(column) - min(column) for column in zip(*(node.at for node in model.nodes.values()), strict=True)]
    limit = min(HEAVIEST, HEAVY * math.hypot(*spans) ** 3)
    mend = "Write the unit, e.g. '2 kg'; a bare number is in kg."
    for table in ("nodes", "bars", "bodies"):
        for name, one in getattr(model, table).items():
            mass = getattr(one, "mass", None)
            if isinstance(mass, float) and mass > max(limit, 1.0):
                message = f"is {mass:.3g} kg, more than a structure {math.hypot(*spans):.3g} m wide has room for."
                yield Fault((table, name, "mass"), message, mend)


def _gravity(model: Model) -> Iterator[Fault]:
    if model.gravity is not None and (g := math.hypot(*model.gravity)) > LARGEST_GRAVITY:
        mend = "Write the unit, e.g. '9810 mm/s^2'; a bare number is in m/s^2."
        yield Fault(("gravity",), f"is {g:g} m/s^2, more than on the sun.", mend)


def _screws(model: Model) -> Iterator[Fault]:
    screws: list[tuple[Path, Any]] = [(("screws", name), one) for name, one in model.screws.items()]
    screws += [(("active", name, "screw"), one.screw) for name, one in model.active.items() if hasattr(one.screw, "lead")]
    for path, screw in screws:
        if (slope := screw.lead / (screw.mean_diameter / 2)) > STEEP:
            turn = 2 * math.pi * screw.lead
            message = f"is {screw.lead:g} m/rad: {turn:.3g} m a turn, a lead angle of {math.degrees(math.atan(slope)):.0f} deg."
            yield Fault((*path, "lead"), message, "Write it per turn, e.g. '5 mm/rev'; a bare number is in m/rad.")


def _angles(model: Model) -> Iterator[Fault]:
    for name, one in model.trajectories.items():
        yield from turned_far(model, one, ("trajectories", name))
    for name, run in model.runs.items():
        path: Path = ("runs", name)
        if run.trajectory is not None and not isinstance(run.trajectory, str):
            yield from turned_far(model, run.trajectory, (*path, "trajectory"))
        for drive, task in run.tasks.items():
            if isinstance(task, TRAJECTORY_TASKS):
                yield from turned_far(model, task, (*path, "tasks", drive))
        kinds = coordinate_kinds(model)
        for pose, values in run.poses.items():
            for drive, value in values.items():
                yield from _far(kinds.get(drive) == "angle", (value,), (*path, "poses", pose, drive))
        if run.targets is not None:
            yield from _of_targets(kinds, run.targets, (*path, "targets"))
    for name, (kind, one) in model.force_elements.items():
        if getattr(one, "rest", None) is not None and one.coordinate is not None:
            yield from _far(turns(one.coordinate), (one.rest,), (FORCE_ELEMENTS[kind], name, "rest"))


def _of_targets(kinds: Mapping[str, str], target: Any, path: Path) -> Iterator[Fault]:
    """Way points of tasks that are angles."""
    for index, one in enumerate(getattr(target, "tasks", ())):
        yield from _of_targets(kinds, one, (*path, "tasks", index))
    for name, course in getattr(target, "moves", {}).items():
        values = getattr(course, "values", course)
        if not callable(values) and not isinstance(values, Record):
            angle = name in TURNING if target.COORDINATES else kinds.get(name) == "angle"
            yield from _far(angle, values if isinstance(values, tuple) else (values,), (*path, "moves", name))


def turned_far(model: Model, trajectory: Any, path: Path = ()) -> Iterator[Fault]:
    """Angles and rates of a trajectory that are large round numbers without a unit: degrees that are read as radians.

    >>> import kinetruss as kt
    >>> model = kt.library.mechanisms.four_bar()
    >>> print(*turned_far(model, kt.Quintic(moves={"motor": (90, 180)}, duration=1.0)))
    moves.motor: goes to 180 rad, 28.6 turns. Write the unit, e.g. '180 deg'; a bare number is in rad.
    >>> [note.message for note in turned_far(model, kt.ConstantRate(rates={"motor": 360}, duration=1.0))]
    ['is 360 rad/s, 57.3 turns a second.']
    """
    kinds = coordinate_kinds(model)
    field, table = moved_by(trajectory)
    for name, value in table.items():
        place: Path = (*path, field, name)
        angle = kinds.get(name) == "angle"
        if field == "rates":
            if angle and _bare(value) and value and any(value % step == 0 for step in ROUND_RATES):
                message = f"is {value:g} rad/s, {abs(value) / (2 * math.pi):.3g} turns a second."
                mend = f"Write the unit, e.g. '{value:g} deg/s' or '{value:g} rev/min'; a bare number is in rad/s."
                yield Fault(place, message, mend)
        elif field != "values" or all(map(_halves, value)):
            yield from _far(angle, value if isinstance(value, tuple) else (value,), place)
    if isinstance(trajectory, Sine):
        yield from _far(True, (trajectory.phase,), (*path, "phase"))


def _far(angle: bool, values: Iterable[float], place: Path) -> Iterator[Fault]:
    """The note on the largest of some angles, if it is a large whole or half number without a unit."""
    large = [one for one in values if _bare(one) and abs(one) >= TURNS and _halves(one)] if angle else []
    if large:
        most = max(large, key=abs)
        message = f"goes to {most:g} rad, {abs(most) / (2 * math.pi):.3g} turns."
        yield Fault(place, message, f"Write the unit, e.g. '{most:g} deg'; a bare number is in rad.")


def _bare(value: float) -> bool:
    return getattr(value, "quantity", None) is None


def _halves(value: float) -> bool:
    return float(2 * value).is_integer()
