"""Which variable of a result the functions of expressions read: forces of parts, reactions of supports, pressures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from kinetruss.model.drives import turns
from kinetruss.model.words import nearest

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


class ExpressionError(Exception):
    """A fault of an expression: the message, and how to mend it."""

    def __init__(self, message: str, mend: str) -> None:
        super().__init__(f"{message} {mend}")
        self.message, self.mend = message, mend


class Variable(NamedTuple):
    """An entry of a variable of a result with forces. vector : of all axes."""

    name: str
    axis: str
    entry: str
    unit: str
    vector: bool = False


FUNCTIONS = {
    "force": "force(A)",
    "torque": "torque(motor)",
    "power": "power(motor)",
    "reaction": "reaction(A), or reaction(A, ex)",
    "reaction_moment": "reaction_moment(A)",
    "thrust": "thrust(lift)",
    "pressure_A": "pressure_A(lift)",
    "pressure_B": "pressure_B(lift)",
    "flow_A": "flow_A(lift)",
    "flow_B": "flow_B(lift)",
}
"""Functions that read from forces, as they are written."""
OF_SUPPORTS = ("reaction", "reaction_moment")


def variable_of(model: ModelData, function: str, table: str | None, part: str) -> Variable:
    """What a function of `FUNCTIONS` reads of a part. table : of which the part is, as ``drive``; None for any.

    ``power`` of a drive reads its force or torque.

    Raises
    ------
    ExpressionError : there is no such part, several have the name, or it has another quantity.
    """
    if function in OF_SUPPORTS:
        return _of_support(model, function, table, part)
    known = _tables(model)
    if table is not None and table not in known:
        raise ExpressionError(f"has no kind of part {table!r}.", nearest(table, known))
    parts = known if table is None else {table: known[table]}
    found = {kind: own[part] for kind, own in parts.items() if part in own}
    if list(found)[:2] == ["member", "drive"] and part not in model.drives:
        del found["drive" if function != "power" else "member"]  # the drive of a member, of its own name
    if not found:
        if part in model.bending:
            mend = "Section forces along it are in kinetruss.strength.beams; take a drive, a spring or a reaction here."
            raise ExpressionError(f"{function}({part}): beams and links have no single force.", mend)
        names = [name for own in parts.values() for name in own]
        raise ExpressionError(f"has no {table or 'part with a force'} called {part!r}.", nearest(part, names))
    if len(found) > 1:
        mend = f"Write {' or '.join(f'{function}({kind}({part}))' for kind in found)}."
        raise ExpressionError(f"{part!r} is a {' and a '.join(found)}.", mend)
    ((kind, record),) = found.items()
    return _of_part(function, kind, part, record)


def _tables(model: ModelData) -> dict[str, Any]:
    """The parts that have forces, by the axis of results along which they are."""
    own: dict[str, dict[str, Any]] = {
        "member": {**model.members},
        "drive": {**model.all_drives},
        "coupling": {**model.couplings},
    }
    for name, (kind, one) in model.force_elements.items():
        own.setdefault(kind, {})[name] = one
    return own | {"cylinder": {**model.cylinders}}


def _of_part(function: str, kind: str, part: str, record: Any) -> Variable:
    if kind == "cylinder":
        values = record.measured | {"force": record.measured["thrust"]}
        if function in values:
            return Variable(f"cylinder_{'thrust' if function == 'force' else function}", kind, part, values[function])
        raise ExpressionError(f"the cylinder {part!r} has no {function}.", f"It has {', '.join(values)}.")
    if kind == "member":
        unit = "N"
    else:
        first = record if kind == "drive" else record.terms[0][0] if kind == "coupling" else record.parts[0][0]
        unit = "N m" if turns(first) or first.kind == "cosine" else "N"
    has = "torque" if unit == "N m" else "force"
    if function != has and not (function == "power" and kind == "drive"):
        more = f" or power({part})" if kind == "drive" else ""
        raise ExpressionError(f"the {kind} {part!r} has a {has}, no {function}.", f"Write {has}({part}){more}.")
    return Variable(f"{kind}_force", kind, part, unit)


def _of_support(model: ModelData, function: str, table: str | None, part: str) -> Variable:
    if table not in (None, "node"):
        raise ExpressionError(f"{function} is that of a supported node, not of a {table}.", f"Write {FUNCTIONS[function]}.")
    turning = {name for name, one in model.supports.items() if one.turns} | set(model.clamped)
    held = turning if function == "reaction_moment" else {*model.fixed, *model.supports, *model.clamped}
    if part not in held:
        what = "moment of a support" if function == "reaction_moment" else "reaction"
        raise ExpressionError(f"there is no {what} at {part!r}.", nearest(part, held))
    if function == "reaction":
        return Variable(function, "support", part, "N", vector=True)
    return Variable(function, "support", part, "N m", vector=model.dim == 3)
