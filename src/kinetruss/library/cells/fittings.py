"""Ready cells: what each takes besides its shape (sections, active members, place), and its parameters as a record."""

from __future__ import annotations

import functools
import inspect
import operator
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Annotated, Any, Literal, ParamSpec, TypedDict, get_type_hints

from pydantic import BeforeValidator, Discriminator, Tag, create_model

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.library.building import bound, named
from kinetruss.library.cells.joining import mirror
from kinetruss.library.cells.records import Axis, Cell, Triple, changed
from kinetruss.library.materials import ALUMINIUM_LACY, MATERIALS
from kinetruss.library.sections import SECTIONS, TUBE_LACY_SPATIAL
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import (
    Active,
    Bar,
    Compliance,
    Count,
    Flag,
    Gear,
    LeadScrew,
    Mass,
    Material,
    Motor,
    Name,
    Part,
    PositiveLength,
    Record,
    Whole,
    matched,
    nearest,
)
from kinetruss.model.members import EndCondition
from kinetruss.model.sections import Section


class Actuator(Record):
    """An active member of a cell, by the name or pattern of the bars that it takes the place of.

    With `base` and `tube` it becomes an `Active` member with two rods, without them a driven bar. ends : of a member that the
    cell does not have. The other fields are those of `Active`; a tube without mass and section has those of the bars.
    """

    ends: tuple[Name, Name] | None = None
    base: Part | None = None
    tube: Part | None = None
    screw: LeadScrew | Name | None = None
    gear: Gear | Name | None = None
    motor: Motor | Name | None = None
    limits: tuple[PositiveLength, PositiveLength] | None = None
    compliance: Compliance | None = None
    buckling: EndCondition | None = None


def _by_pattern(value: Any) -> Any:
    """A list of patterns: driven bars."""
    if isinstance(value, str):
        return {value: {}}
    if isinstance(value, (list, tuple)) and all(isinstance(one, str) for one in value):
        return {one: {} for one in value}
    return value


Actuators = Annotated[dict[Name, Actuator], BeforeValidator(_by_pattern)]
"""Pattern -> what drives the bars; or patterns alone."""


class Placing(TypedDict, total=False):
    """Place of a cell in an assembly, see `Cell`; mirrored : the axis along which it is mirrored, see `mirror`."""

    on: Name
    by: Name
    turn: Whole
    at: Triple
    towards: Triple
    mirrored: Axis


class Fittings(Placing, total=False):
    """Of all bars that have none of their own: section, material, mass (kg), rotary inertia, end condition; active members."""

    section: Section | Name | None
    material: Material | Name | None
    mass: Mass | None
    rotary_inertia: Flag
    buckling: EndCondition
    active: Actuators


_BARS = {"section": TUBE_LACY_SPATIAL, "material": ALUMINIUM_LACY}


def placed(cell: Cell, placing: Any) -> Cell:
    """The cell with its place in an assembly, mirrored first if wanted."""
    rest = {key: value for key, value in placing.items() if key != "mirrored" and value is not None}
    cell = mirror(cell, placing["mirrored"]) if placing.get("mirrored") else cell
    return changed(cell, **rest) if rest else cell


def dressed(cell: Cell, fittings: Fittings, groups: dict[str, tuple[str, ...]] | None = None) -> Cell:
    """A bare cell with its fittings. groups : more names for some of its bars, which `active` may use."""
    given: dict[str, Any] = {**_BARS, **fittings}
    section = named(SECTIONS, given["section"], "section")
    material = named(MATERIALS, given["material"], "material")
    own = {"section": None if section is None else "bar", "material": None if material is None else "bar"}
    own |= {key: given[key] for key in ("mass", "rotary_inertia", "buckling") if key in given}
    bars = {name: _own(bar, own) for name, bar in cell.bars.items()}
    bars, active = _driven(bars, given.get("active", {}), groups or {}, own)
    used = changed(
        cell,
        bars=bars,
        active={**cell.active, **active},
        sections=({} if section is None else {"bar": section}) | cell.sections,
        materials=({} if material is None else {"bar": material}) | cell.materials,
        poses={} if given.get("active") else cell.poses,
    )
    return placed(used, {key: given.get(key) for key in Placing.__annotations__})


def _own(bar: Bar, fields: dict[str, Any]) -> Bar:
    """A bar with what it does not have yet."""
    rest = {key: value for key, value in fields.items() if value is not None and key not in bar.model_fields_set}
    return bar if bar.body is not None else changed(bar, **rest)


def _driven(
    bars: dict[str, Bar], actuators: dict[str, Actuator], groups: dict[str, tuple[str, ...]], own: dict[str, Any]
) -> tuple[dict[str, Bar], dict[str, Active]]:
    """The bars, some of them driven now, and the active members that take the place of others."""
    bars, active = dict(bars), {}
    for pattern, actuator in actuators.items():
        names = [*matched(list(bars), pattern), *(one for group in matched(list(groups), pattern) for one in groups[group])]
        if actuator.ends is not None:
            bars[pattern] = _own(Bar(ends=actuator.ends), own)
            names = [pattern]
        if not names:
            known = [*groups, *bars]
            raise ModelError([Fault(("active", pattern), f"{shown(pattern)} matches no bar.", nearest(pattern, known))])
        for name in dict.fromkeys(names):
            if actuator.base is None and actuator.tube is None:
                bars[name] = changed(bars[name], kind="driven")
                _no_train(pattern, actuator)
            else:
                active[name] = _rods(pattern, actuator, bars.pop(name))
    return bars, active


def _rods(pattern: str, actuator: Actuator, bar: Bar) -> Active:
    if actuator.base is None or actuator.tube is None:
        lacks = "base" if actuator.base is None else "tube"
        raise ModelError([Fault(("active", pattern), f"has no {lacks}.", "Give base and tube, or neither: a driven bar.")])
    tube = actuator.tube
    if tube.mass is None and tube.section is None:
        tube = changed(tube, section=bar.section, material=bar.material)
    kept = {key: getattr(actuator, key) for key in ("base", "screw", "gear", "motor", "limits", "compliance")}
    return Active(ends=bar.ends, orientation=bar.orientation, tube=tube, buckling=actuator.buckling or bar.buckling, **kept)


def _no_train(pattern: str, actuator: Actuator) -> None:
    if odd := [key for key in ("screw", "gear", "motor", "limits", "compliance") if getattr(actuator, key) is not None]:
        mend = "Give its two rods: base: {length: .., mass: ..}, tube: {length: ..}."
        raise ModelError([Fault(("active", pattern), f"has {odd[0]}, but no rods.", mend)])


# Cells by kind: their parameters are checked like fields of a record, in Python and in model files.

P = ParamSpec("P")

KINDS: dict[str, tuple[Callable[..., Cell], type[Record]]] = {}
"""Kind -> the function that makes the cell, and the record that checks its parameters."""


def ready(kind: str, common: type = Fittings) -> Callable[[Callable[P, Cell]], Callable[P, Cell]]:
    """Register a function that makes a cell, and check its arguments by their annotations; all faults are raised at once.

    common : typed dictionary of the keyword arguments that the function does not name.
    """

    def decorate(function: Callable[P, Cell]) -> Callable[P, Cell]:
        hints = get_type_hints(function, include_extras=True)
        shape = [one for one in inspect.signature(function).parameters.values() if one.kind is not one.VAR_KEYWORD]
        rest = get_type_hints(common, include_extras=True)
        fields: dict[str, Any] = {
            one.name: (hints[one.name], ... if one.default is one.empty else one.default) for one in shape
        }
        fields |= {key: (hint, None) for key, hint in rest.items()}
        tag: dict[str, Any] = {"kind": (Literal[kind], kind), "count": (Count, 1)}
        record: type[Record] = create_model(f"cell_{kind}", __base__=Record, __doc__=function.__doc__, **fields, **tag)
        more = [inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=None) for key in rest]
        signature = inspect.Signature([*shape, *more], return_annotation=Cell)

        @functools.wraps(function)
        def checked(*args: P.args, **kwargs: P.kwargs) -> Cell:
            arguments = bound(kind, signature, args, kwargs)
            try:
                given = record(**arguments)
            except ModelError as error:
                raise ModelError([replace(fault, path=fault.path[1:]) for fault in error.faults]) from None
            make: Callable[..., Cell] = function
            return make(**{key: getattr(given, key) for key in arguments})

        checked.__signature__ = signature  # type: ignore[attr-defined]
        KINDS[kind] = checked, record
        return checked

    return decorate


def _kind_of(value: Any) -> str:
    if isinstance(value, Cell):
        return "Cell"
    kind = value.get("kind", "cell") if isinstance(value, Mapping) else getattr(value, "kind", "cell")
    return kind if isinstance(kind, str) else shown(kind)


def any_cell(*makers: Callable[..., Cell]) -> Any:
    """Annotation of a cell: a `Cell`, or the parameters of one of these functions, with its name as `kind`."""
    records = [Annotated[KINDS[make.__name__][1], Tag(make.__name__)] for make in makers]
    return Annotated[functools.reduce(operator.or_, records, Annotated[Cell, Tag("Cell")]), Discriminator(_kind_of)]


def made(given: Any, path: tuple[str | int, ...]) -> Cell:
    """The cell of the parameters in a file; faults are placed below `path`."""
    if isinstance(given, Cell):
        return given
    make, _ = KINDS[given.kind]
    try:
        return make(**{key: getattr(given, key) for key in given.model_fields_set - {"kind", "count"}})
    except ModelError as error:
        raise ModelError([replace(fault, path=(*path, *fault.path)) for fault in error.faults]) from None


def counted(given: Iterable[Any], path: tuple[str | int, ...]) -> list[Cell]:
    """The cells of a list, each as many times as its `count` says.

    Raises
    ------
    ModelError : no cell, or more than a model holds.
    """
    cells: list[Cell] = []
    for index, one in enumerate(given):
        count = getattr(one, "count", 1)
        cell = made(one, (*path, index))
        if (len(cells) + count) * len(cell.nodes) > MOST_ENTRIES:
            mend = f"Use less: a model holds at most {MOST_ENTRIES} nodes."
            raise ModelError([Fault((*path, index, "count"), f"these are {len(cells) + count} cells.", mend)])
        cells += [cell] * count
    if not cells:
        raise ModelError([Fault(path, "no cell is given.", "Give at least one, e.g. {kind: octahedron, side: 1 m}.")])
    return cells
