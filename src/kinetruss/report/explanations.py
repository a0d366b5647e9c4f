"""Free bodies and labelled systems as text, as plain data and as tables."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, number, quantity
from kinetruss.report.page import Page

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics import Body, FreeBody, LabelledSystem
    from kinetruss.report.entries import Entry


SMALL = 20
"""Number of equations up to which a system is shown as a matrix; larger ones are shown equation by equation."""

COUPLES = ("M", "-M", "T")
"""Symbols of terms that are moments."""

Row = tuple[str, str, Sequence[float] | None]  # symbol, words, numbers (None: a rule)


def explain(found: FreeBody | LabelledSystem, pose: str = "") -> Page:
    r"""A free body (`dynamics.free_body`) or the equations of a whole model (`dynamics.newton_euler`), in numbers.

    pose : name of the pose, for forces of poses at rest, whose times are numbers of poses.

    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> page = kt.report.explain(kt.dynamics.free_body(model, forces.motion, forces, node="C"))
    >>> print("\n".join(page.text.splitlines()[3:7]))
    Forces (N)                  x          y
    -F_B  strut, end B   1000.000      0.000
    -F_B  tie, end B    -1000.000   1000.000
    P     load hook         0.000  -1000.000
    """
    if hasattr(found, "bodies"):
        return Page(
            found=found, as_record=_free_body_record, as_entries=partial(_free_body, pose=pose), as_rows=_free_body_rows
        )
    return Page(found=found, as_record=_system_record, as_entries=partial(_system, pose=pose), as_rows=_system_rows)


def _when(found: FreeBody | LabelledSystem, pose: str) -> str:
    return f"pose {pose}" if pose else f"t = {number(found.time, 9)} s"


def _free_body(found: FreeBody, pose: str) -> Iterator[Entry]:
    """The free body: all forces, their sum, mass times acceleration, and the difference of the two."""
    at = f"{_when(found, pose)}, load case {found.load_case}"
    if found.kind == "node":
        yield _node_head(found, at)
        yield _forces(found.bodies[0])
        yield _closing(found)
        return
    yield _member_head(found, at)
    for body in found.bodies:
        own = [_place("centre of mass", body.centre, "m"), _place("its acceleration a =", body.acceleration, "m/s^2")]
        title = "" if len(found.bodies) == 1 else f"{'Base rod' if body is found.bodies[0] else 'Tube'} {body.name}: "
        yield f"{title}mass {quantity(body.mass, 'kg', 6)}, {', '.join(own)}"
        yield _forces(body)
        yield _moments(body)
    yield _closing(found)


def _node_head(found: FreeBody, at: str) -> str:
    (body,) = found.bodies
    head = f"Free body of node {found.name}; {at}\n{_place('at', body.centre, 'm')}"
    if body.mass:
        head += f", mass {quantity(body.mass, 'kg')}, {_place('acceleration', body.acceleration, 'm/s^2')}"
    return head


def _member_head(found: FreeBody, at: str) -> str:
    what = "bar" if found.kind == "bar" else "active member"
    axes = [] if found.axes is None else [f"axis {k} = {_vector(e)}" for k, e in enumerate(found.axes, 1)]
    a, mean, b = (quantity(value, "N", 6) for value in found.tension)
    return "\n".join(
        [
            f"Free body of {what} {found.name}, A = {found.ends[0]} to B = {found.ends[1]}; {at}",
            "; ".join([f"length {quantity(found.length or 0.0, 'm', 9)}", *axes]),
            f"tension {a} at A, {mean} {'mean' if found.kind == 'bar' else 'at the nut'}, {b} at B",
        ]
    )


def _forces(body: Body) -> Table:
    local = len(body.inertia.local)
    axes = list("xyz"[: len(body.inertia.force)])
    head = axes + ["along 1", "across 2", "across 3"][:local]
    rows: list[Row] = [(t.symbol, t.source, [*t.force, *t.local]) for t in body.terms if t.symbol not in COUPLES]
    total = [*body.force_sum, *sum((t.local for t in body.terms), np.zeros(local))]
    push = [*body.inertia.force, *body.inertia.local]
    right = "mass times acceleration" if body.mass else "no mass"
    return _sheet("Forces (N)", head, [*rows, ("", "", None), ("sum", "of all", total), ("m a", right, push)], total, push)


def _moments(body: Body) -> Table:
    head = [f"about {k}" for k in "23"[-len(body.inertia.moment) :]]
    rows: list[Row] = [(t.symbol, t.source, list(t.moment)) for t in body.terms if t.source != "weight"]
    total, right = list(body.moment_sum), list(body.inertia.moment)
    rows += [("", "", None), ("sum", "of all", total), ("H'", "I u x u''", right)]
    return _sheet("Moments about the centre of mass (N m)", head, rows, total, right)


def _sheet(title: str, head: Sequence[str], rows: Iterable[Row], left: Sequence[float], right: Sequence[float]) -> Table:
    """Numbers in columns with equal decimals, and a last line with the difference of two rows."""
    rows = list(rows)
    largest = max((abs(x) for _, _, values in rows for x in values or ()), default=0.0)
    decimals = 6 if largest == 0 else min(9, max(0, 6 - math.floor(math.log10(largest))))
    floor = 0.5 * 10.0**-decimals
    lines = [(s, w, None if v is None else [f"{0.0 if abs(x) < floor else x:.{decimals}f}" for x in v]) for s, w, v in rows]
    lines.append(("", "difference", [_miss(a - b) for a, b in zip(left, right, strict=True)]))
    wide = [cell for _, _, cells in lines for cell in cells or ()]
    rule = "-" * max(9, *map(len, wide), *map(len, head))
    first = max(len(s) for s, _, _ in lines)
    filled = [(f"{symbol.ljust(first)}  {words}".rstrip(), *(cells or [rule] * len(head))) for symbol, words, cells in lines]
    return Table((title, *head), filled)


def _closing(found: FreeBody) -> str:
    miss = f"to {_miss(found.residual)} (largest force {quantity(found.largest, 'N')})"
    if found.kind == "node":
        return f"Equations: sum of forces = m a. They close {miss}."
    count = sum(len(body.equations) for body in found.bodies)
    return f"Equations: sum of forces = m a; sum of r x F + M = H'. All {count} close {miss}."


def _miss(value: float) -> str:
    return "0" if value == 0 else f"{value:.1e}"


def _place(word: str, vector: NDArray[np.float64], unit: str) -> str:
    return f"{word} {_vector(vector)} {unit}"


def _vector(vector: NDArray[np.float64]) -> str:
    return f"({', '.join(number(0.0 if abs(x) < 5e-13 else x, 6) for x in vector)})"


def _free_body_record(found: FreeBody) -> dict[str, Any]:
    """The free body as plain data."""
    bodies = [
        {
            "name": body.name,
            "mass": body.mass,
            "centre": body.centre.tolist(),
            "acceleration": body.acceleration.tolist(),
            "terms": [_term(term) for term in body.terms],
            "inertia": _term(body.inertia),
            "equations": [equation._asdict() for equation in body.equations],
        }
        for body in found.bodies
    ]
    record = {
        "kind": found.kind,
        "name": found.name,
        "time": found.time,
        "load_case": found.load_case,
        "bodies": bodies,
        "largest_force": found.largest,
        "residual": found.residual,
    }
    if found.kind != "node":
        record |= {
            "ends": list(found.ends),
            "length": found.length,
            "axes": None if found.axes is None else found.axes.tolist(),
            "tension": dict(zip(("A", "mean", "B"), found.tension, strict=True)),
        }
    return record


def _term(term: Any) -> dict[str, Any]:
    return {
        "symbol": term.symbol,
        "source": term.source,
        "force": term.force.tolist(),
        "member_axes": term.local.tolist(),
        "moment": term.moment.tolist(),
    }


def _free_body_rows(found: FreeBody) -> list[list[Any]]:
    """The free body as a table: one row per term, the inertia of each body last."""
    inertia = found.bodies[0].inertia
    axes, local, moments = len(inertia.force), len(inertia.local), len(inertia.moment)
    head = ["body", "symbol", "source", *(f"force_{axis} [N]" for axis in "xyz"[:axes])]
    head += [*(f"force_{k} [N]" for k in range(1, local + 1)), *(f"moment_{k} [N m]" for k in "23"[2 - moments :])]
    rows: list[list[Any]] = [head]
    for body in found.bodies:
        for term in (*body.terms, body.inertia):
            source = term.source or "right side: mass times acceleration, rate of angular momentum"
            rows.append([body.name, term.symbol, source, *map(float, (*term.force, *term.local, *term.moment))])
    return rows


def _system(found: LabelledSystem, pose: str) -> list[Entry]:
    """The system: a small one as a matrix, a larger one equation by equation; then unknowns and solution."""
    rows, columns = found.matrix.shape
    head = [f"Equations of Newton and Euler; {_when(found, pose)}, load case {found.load_case}"]
    condition = f", condition number {number(found.condition)}" if math.isfinite(found.condition) else ""
    head.append(f"{rows} equations, {columns} unknowns{condition}")
    if found.unique:
        head.append(f"solution and inverse dynamics agree to {_miss(found.difference)} (largest {number(found.largest, 6)})")
    else:
        head.append(
            "the equations alone do not determine the forces; those of inverse dynamics satisfy them to "
            f"{_miss(found.residual)} (largest {number(found.largest, 6)})"
        )
    if found.joints:
        head.append(f"held by one member alone: {', '.join(found.joints)}; the member's end force there is the reaction")
    body = _matrix(found) if max(rows, columns) <= SMALL else _written(found)
    return ["\n".join(head), body, _solution(found)]


def _matrix(found: LabelledSystem) -> Table:
    head = ("equation", *map(str, range(1, len(found.unknowns) + 1)), "", "right side")
    rows = [
        (name, *map(_cell, row), "=", number(right, 6))
        for name, row, right in zip(found.equations, found.matrix, found.right, strict=True)
    ]
    return Table(head, rows)


def _cell(value: float) -> str:
    return "." if abs(value) < 1e-15 else number(value, 5)


def _written(found: LabelledSystem) -> str:
    width = max(map(len, found.equations))
    lines = ["Equations (forces in N, moments in N m)"]
    for name, row, right in zip(found.equations, found.matrix, found.right, strict=True):
        terms = [_summand(row[k], found.unknowns[k]) for k in np.flatnonzero(np.abs(row) > 1e-15)]
        left = " ".join(terms).removeprefix("+ ") or "0"
        lines.append(f"{name.ljust(width)}  {left} = {number(right if abs(right) > 1e-15 else 0.0, 6)}")
    return "\n".join(lines)


def _summand(coefficient: float, unknown: str) -> str:
    size = "" if abs(abs(coefficient) - 1) < 1e-15 else f"{number(abs(coefficient), 5)} "
    return f"{'-' if coefficient < 0 else '+'} {size}[{unknown}]"


def _solution(found: LabelledSystem) -> Table:
    head = ("#", "unknown", "solution", "inverse dyn.", "difference", "")
    rows = [
        (str(k), name, _fixed(x), _fixed(y), _miss(x - y), _unit(name))
        for k, (name, x, y) in enumerate(zip(found.unknowns, found.solution, found.product, strict=True), 1)
    ]
    return Table(head, rows)


def _fixed(value: float) -> str:
    return f"{0.0 if abs(value) < 5e-9 else value:.8f}"


def _unit(unknown: str) -> str:
    last = unknown.rsplit(" ", 1)[1]
    return "N m" if last.startswith(("moment", "torque")) else "N"


def _system_record(found: LabelledSystem) -> dict[str, Any]:
    """The system as plain data, with the nonzero entries of the matrix."""
    equations = [
        {"name": name, "terms": {found.unknowns[k]: float(row[k]) for k in np.flatnonzero(row)}, "right": float(right)}
        for name, row, right in zip(found.equations, found.matrix, found.right, strict=True)
    ]
    unknowns = [
        {"name": name, "unit": _unit(name), "solution": float(x), "inverse_dynamics": float(y)}
        for name, x, y in zip(found.unknowns, found.solution, found.product, strict=True)
    ]
    return {
        "time": found.time,
        "load_case": found.load_case,
        "size": list(found.matrix.shape),
        "condition": found.condition if math.isfinite(found.condition) else None,
        "unique": found.unique,
        "difference": found.difference,
        "residual": found.residual,
        "largest": found.largest,
        "equations": equations,
        "unknowns": unknowns,
        "joints": list(found.joints),
    }


def _system_rows(found: LabelledSystem) -> list[list[Any]]:
    """The system as a table: one row per equation, one column per unknown, the right side; last the solution and product."""
    rows: list[list[Any]] = [["equation", *found.unknowns, "right side"]]
    for name, row, right in zip(found.equations, found.matrix, found.right, strict=True):
        rows.append([name, *row.tolist(), float(right)])
    rows.append(["solution", *found.solution.tolist(), ""])
    rows.append(["inverse dynamics", *found.product.tolist(), ""])
    return rows
