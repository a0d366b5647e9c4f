"""The deflections to which a model gives limits: how large they are in a result, where, and whether the limits are kept."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.errors import InputError, few
from kinetruss.mechanics import System, compile
from kinetruss.model import Piece
from kinetruss.model.deflection_limits import nodes_of, row_nodes, row_of
from kinetruss.model.links import bends
from kinetruss.model.load_cases import applies_in
from kinetruss.results import Result, Row
from kinetruss.results.wide_tables import NOT_CHECKED
from kinetruss.strength.beam_stresses import along_elements
from kinetruss.strength.beam_verdict import SECTIONS, stations_of
from kinetruss.strength.curves import extremes
from kinetruss.strength.element_stresses import positions_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import DeflectionLimit, Model

    Array = NDArray[np.float64]

BARS = "bars count by their nodes, between which they stay straight"
KINDS = ("linear", "equilibrium")
"""Kinds of results of which deflections are known."""


def deflections(model: Model, result: Result) -> list[Row]:
    """Whether the deflections to which the model gives limits (`Model.deflections`) keep them in one load case.

    Parameters
    ----------
    result : of `statics.linear` or `statics.equilibrium`, from the configuration of the model.

    Returns
    -------
    A row for each limit that applies in the load case of the result: ``value`` and ``limit``, m, ``utilisation`` = value/limit,
    ``member`` and ``position``, m from the first end of the row, of the largest deflection, ``station``, the same over the
    span. Not checked, with the reason in ``note``, where a deflection is not known: of rigid beams, and of links without
    section or material.

    Raises
    ------
    InputError : a result of another kind, of another model, or from another configuration.

    Notes
    -----
    Of small displacements u the deflection is the part of u - (1 - s) u_A - s u_B across the row A B, at the fraction s of its
    length (of ``measured_from="start"`` that of u); of an equilibrium the distance from the line through the displaced ends.
    The axis of beams is in closed form (see `strength.beams`), its largest deflection that of a parabola through three of 97
    stations.

    Examples
    --------
    >>> import kinetruss as kt
    >>> beam = kt.Model(
    ...     nodes={"A": (0, 0), "B": (6, 0)}, fixed={"A": "xy", "B": "y"}, beams={"rafter": ("A", "B")},
    ...     section=kt.General(area=4e-3, I2=2e-5, I3=2e-5, c2=0.1, c3=0.1), material=kt.Material(E=200e9, density=0.0),
    ...     loads={"snow": kt.MemberLoad(member="rafter", force=(0, -4e3))},
    ...     deflections={"rafter": kt.DeflectionLimit("rafter", "span/300")},
    ... )
    >>> (row,) = kt.strength.deflections(beam, kt.statics.linear(beam))
    >>> round(row.value, 6), row.limit, row.position  # m: 5 w L^4/(384 E I) of L/300, in the middle
    (0.016875, 0.02, 3.0)
    """
    system = compile(model)
    kind = result.attrs.get("kind") if isinstance(result, Result) else None
    if kind not in KINDS:
        raise InputError(
            f"A {type(result).__name__} has no deflections. Give the result of statics.linear or statics.equilibrium."
        )
    if not result.attrs.get("at_model", 1):
        raise InputError("The result is from another configuration than the model's. Give a model that stands there.")
    case = str(result.attrs.get("load_case", "all"))
    wanted = {name: one for name, one in model.deflections.items() if applies_in(model, one.load_cases, case)}
    if not wanted:
        return []
    moved, xi, bent = _moved(system, model, result, case)
    found = []
    for name, one in wanted.items():
        if rigid := [member for member in one.members if _keeps_its_shape(model, member)]:
            why = f"{few(rigid, 4)} {'is' if len(rigid) == 1 else 'are'} rigid, or without section or material"
            found.append(unchecked_row(name, one, why, case))
        else:
            found.append(_checked(system, model, name, one, (moved, xi, bent), case, small=kind == "linear"))
    return found


def unchecked_row(name: str, one: DeflectionLimit, why: str, case: str = "") -> Row:
    """The row of a limit of a deflection that is not known."""
    none: dict[str, Any] = dict.fromkeys(("value", "limit", "utilisation", "margin", "time"), math.nan)
    note = f"{NOT_CHECKED}{why}"
    return Row(part=_called(name), member=one.members[0], rule=_rule(one), unit="m", load_case=case, note=note, **none)


def _called(name: str) -> str:
    return f"deflection of {name}"


def _rule(one: DeflectionLimit) -> str:
    return one.limit if isinstance(one.limit, str) else "limit"


def _keeps_its_shape(model: Model, member: str) -> bool:
    return member in model.bending and not bends(model, model.bending[member])


def _moved(system: System, model: Model, result: Result, case: str) -> tuple[Array, Array, Array | None]:
    """Displacements of nodes (n, dim), m; fractions of the lengths of elements (s,) and displacements there (k, s, dim)."""
    x = positions_of(system, result)[0][:, :, : model.dim]
    xi = stations_of(system, case, SECTIONS)
    beams = None if system.continua is None else cast("Any", system.continua).beams
    bent = None if beams is None else along_elements(model, result, xi, deflected=True)[0]["displacement"][0]
    return x[0] - system.x0[:, : model.dim], xi, bent


def _checked(
    system: System,
    model: Model,
    name: str,
    one: DeflectionLimit,
    known: tuple[Array, Array, Array | None],
    case: str,
    *,
    small: bool,
) -> Row:
    moved, dim = known[0], model.dim
    row = cast("list[tuple[str, bool]]", row_of(model, one.members))  # a row, as the checks of the model have found
    ends = [system.node_index(node) for node in (row_nodes(model, row)[at] for at in (0, -1))]
    (A, B), (u_A, u_B) = system.x0[ends, :dim], moved[ends]
    span = float(np.linalg.norm(B - A))
    axis, limit = (B - A) / span, one.limit_of(span)
    best, at, where = -math.inf, 0.0, one.members[0]
    for member, place, u, x, edges in _parts(system, model, row, A, axis, known):
        if one.measured_from == "ends" and small:
            u = u - (1.0 - place[:, None] / span) * u_A - (place[:, None] / span) * u_B
        elif one.measured_from == "ends":
            u = A + place[:, None] * axis + u - (A + u_A)
        line = axis if one.measured_from == "start" or small else (B + u_B - A - u_A) / np.linalg.norm(B + u_B - A - u_A)
        size = np.linalg.norm(u - (u @ line)[:, None] * line, axis=1)
        value, local = extremes(x, size, edges)[2:] if len(x) > 2 else (size.max(), x[size.argmax()])
        if np.isnan(value):
            return unchecked_row(name, one, f"the deflection of {member!r} is not known", case)
        if value > best:
            best, at, where = float(value), float(np.interp(local, x, place)), member
    used = best / limit
    return Row(
        part=_called(name),
        member=where,
        rule=_rule(one),
        value=best,
        limit=limit,
        unit="m",
        utilisation=used,
        margin=math.inf if used == 0 else 1 / used - 1,
        time=math.nan,
        station=at / span,
        position=at,
        load_case=case,
        note="" if all(member in model.bending for member in one.members) else BARS,
    )


def _parts(
    system: System, model: Model, row: list[tuple[str, bool]], A: Array, axis: Array, known: tuple[Array, Array, Array | None]
) -> Iterator[tuple[str, Array, Array, Array, Array]]:
    """Of each element of a row its member, places (s,) along the row, m, displacements (s, dim), m, fractions (s,) of its
    length, and those of them at which loads begin, end or act.
    """
    moved, xi, bent = known
    for member, _ in row:
        if member not in model.bending:
            ends = [system.node_index(node) for node in nodes_of(model, member)]
            yield member, (system.x0[ends, : model.dim] - A) @ axis, moved[ends], np.array([0.0, 1.0]), np.zeros(0)
            continue
        beams, displaced = cast("Any", system.continua).beams, cast("Array", bent)
        for k, name in enumerate(beams.names):
            record = model.whole.beams[name]
            if (record.link if isinstance(record, Piece) else name) != member:
                continue
            a, b = ((system.x0[system.node_index(node), : model.dim] - A) @ axis for node in record.ends)
            yield member, a + xi * (b - a), displaced[k], xi, np.setdiff1d(xi, np.linspace(0.0, 1.0, SECTIONS))
