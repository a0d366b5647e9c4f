"""The quantities that a model defines, along a motion or in a position at rest, with their rates.

Positions, velocities and accelerations of nodes are series in time; the expressions are evaluated on these, so that rates are
exact: nothing is differenced (kernels.coordinates.programs). A rate within an expression takes one order from what is known.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kernels.coordinates.on_arrays import series_on_arrays
from kinetruss.kernels.coordinates.programs import ANGLE_OF, Program, Scalar, minus, root
from kinetruss.kinematics.turns import Passed, refined
from kinetruss.mechanics import compile
from kinetruss.mechanics.measure_arrays import terms_of
from kinetruss.mechanics.measures import terms_sum
from kinetruss.model.expression_kinds import AXES, CONSTANTS, FORCE_UNITS, FUNCTIONS, Kind, function_of
from kinetruss.model.expressions import Tree, forces_in, kind_of, looked_up, read_expression
from kinetruss.model.measured_forces import ExpressionError
from kinetruss.model.quantities import kinds_of
from kinetruss.results import Column, Motion, Simulation, variable
from kinetruss.results.wide_tables import unit_along

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.model import Model
    from kinetruss.results import Forces, Result

    Array = NDArray[np.float64]

TURN = 2.0 * math.pi
PASSES = 4
"""Angles of angles, at most, whose turns are counted one after the other."""


def quantities(
    model: Model, result: Result, expressions: Mapping[str, str] | None = None, *, forces: Forces | None = None
) -> xr.Dataset:
    """The quantities of a model (`Model.quantities`) in a result, with their first and second rates.

    Parameters
    ----------
    result : a motion, forces, a simulation; or a position at rest: an equilibrium, forces of poses, `statics.linear`.
    expressions : others by name, in place of those of the model.
    forces : those of `result`, if it has none itself, for expressions that read them.

    Returns
    -------
    Dataset over (time,) quantity: ``value`` in the unit of each (coordinate ``quantity_unit``: m, rad, m/rad, ...); along a
    motion ``rate``, per s, and ``second_rate``, per s^2. Angles count on over full turns; in the first sample they are the
    nearest to those of the model. Of `statics.linear` the value is that of the model plus its change to first order. NaN : what
    is not known, as a rate at rest, the second rate of an expression that has rates, an angle between directions of which one
    vanishes, the value of an angle from an instant on before which the samples are too far apart to count its turns; values
    with forces where none are known, and their rates.

    Raises
    ------
    InputError : a result without positions; an expression at fault; forces at other instants.

    Notes
    -----
    Truncated series (Griewank & Walther, Evaluating derivatives, 2008, chapter 13): with x(t + h) = x + v h + a h^2/2 every
    operation gives the same three coefficients of its result.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.mechanisms.four_bar().with_(quantities={"rocker_angle": "angle(rocker)"})
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 1.0}, duration=1.0), samples=3)
    >>> found = kt.kinematics.quantities(model, motion, {"ratio": "rate(rocker_angle)/rate(angle(crank))"})
    >>> found.value.sel(quantity="ratio").values.round(4).tolist(), found.quantity_unit.item()
    ([0.3692, 0.4007, 0.3461], '')
    """
    trees, kinds = _read(model, expressions)
    system = compile(model)
    states, time, samples, linear, coords = _states(system, result)
    start = np.zeros((3, system.x0.size, 1))
    start[0, :, 0] = system.x0.reshape(-1)
    slots = _slots(system, trees.values())
    read = _values(slots, forces or (result.forces if isinstance(result, Simulation) else result), states[..., samples])
    start = _joined(start, np.full((len(read), 1), np.nan), None, slice(None), linear)
    states = _joined(states, read, time, samples, linear)
    before = _evaluated(system, trees, start, None, None, slots)[1]
    found = _evaluated(system, trees, states, time, before, slots)[0][:, :, samples]
    value = found[0] + found[1] if linear else found[0]
    over = ("time", "quantity") if "time" in coords else ("quantity",)
    names = np.array(list(trees), dtype=object).astype(str)
    more: dict[str, Any] = {"quantity": names, "quantity_unit": ("quantity", np.array([kind.unit for kind in kinds], str))}
    columns = {}
    values = {"value": value} | ({} if time is None else {"rate": found[1], "second_rate": 2.0 * found[2]})
    for order, (name, one) in enumerate(values.items()):
        per = [kind._replace(time=kind.time - order).unit for kind in kinds]
        unit, own = unit_along("quantity", per, "quantity_unit" if order == 0 else f"{name}_unit", "")
        more |= own
        said = "quantity" if order == 0 else f"{name.replace('_', ' ')} of the quantity"
        columns[name] = variable(over, one.T if "time" in coords else one[:, 0], unit, said)
    words = [model.quantities[name].words if expressions is None else "" for name in trees]
    more["words"] = ("quantity", np.array(words, str))
    return xr.Dataset(columns, coords=coords | more, attrs={"kind": "quantities"})


def quantities_apart(model: Model, motion: Motion, forces: Forces | None = None) -> dict[str, Column]:
    """The quantities of a model at each instant of a motion by itself, each over (time,): angles are nearest to those of the
    model, and do not count on.
    """
    trees, kinds = _read(model, None)
    system = compile(model)
    states = _coefficients(*(_flat(system, motion.arrays[name].values) for name in ("position", "velocity", "acceleration")))
    start = np.zeros((3, system.x0.size, 1))
    start[0, :, 0] = system.x0.reshape(-1)
    slots = _slots(system, trees.values())
    read = _values(slots, forces or motion, states)
    start = _joined(start, np.full((len(read), 1), np.nan), None, slice(None), linear=False)
    before = _evaluated(system, trees, start, None, None, slots)[1]
    found = _evaluated(system, trees, _joined(states, read, None, slice(None), linear=False), None, before, slots)[0][0]
    return {
        name: variable(("time",), one, kind.unit, model.quantities[name].words)
        for name, kind, one in zip(trees, kinds, found, strict=True)
    }


def _read(model: Model, expressions: Mapping[str, str] | None) -> tuple[dict[str, Tree], list[Kind]]:
    """The trees, names looked up, and what they measure."""
    if expressions is None:
        return {name: looked_up(model, one.tree) for name, one in model.quantities.items()}, list(kinds_of(model).values())
    trees, kinds = {}, []
    for name, text in expressions.items():
        try:
            trees[name] = looked_up(model, read_expression(text))
            kinds.append(kind_of(model, trees[name]))
            if kinds[-1].vector:
                raise ExpressionError(f"{text!r} is a vector.", "Take a component, as in (B - A).x, its length, or an angle.")
        except ExpressionError as error:
            raise InputError(f"{name}: {error}") from None
    return trees, kinds


# What is known.

Known = tuple["Array", "Array | None", Any, bool, dict[str, Any]]


def _states(system: System, result: Result) -> Known:
    """Coefficients (3, 3 n, times) of the positions; times, s, or None at rest; the samples among them; whether the second are
    displacements; coordinates of the result.
    """
    held = getattr(result, "motion", None)
    held = held if isinstance(held, Motion) else result
    arrays = held.arrays
    if "position" not in arrays and "displacement" not in arrays:
        raise InputError(
            f"{type(result).__name__} has no positions of nodes. Give a motion, forces, a simulation or a position."
        )
    linear = "position" not in arrays
    place = arrays["displacement" if linear else "position"].values
    timed = place.ndim == 3
    x = _flat(system, place if timed else place[None])
    coords: dict[str, Any] = {}
    if timed:
        coords["time"] = variable(("time",), arrays["time"].values, "s", "time")
        if "pose" in arrays:
            coords["pose"] = ("time", arrays["pose"].values)
    if linear:
        return _coefficients(np.broadcast_to(system.x0.reshape(1, -1), x.shape), x, None), None, slice(None), True, coords
    if not timed or "pose" in arrays or "velocity" not in arrays or result.attrs.get("at_rest", 0):
        return _coefficients(x, None, None), None, slice(None), False, coords
    v, a = (_flat(system, arrays[name].values) for name in ("velocity", "acceleration"))
    whole = refined(arrays["time"].values, x, v, a, Passed.of(system, held) if isinstance(held, Motion) else Passed.none(0))
    return _coefficients(whole.x, whole.v, whole.a), whole.t, whole.samples, False, coords


def _flat(system: System, values: Array) -> Array:
    """(times, 3 n) of vectors of all nodes (times, n, dim)."""
    if values.shape[1] != len(system.nodes):
        raise InputError(f"The result has {values.shape[1]} nodes, the model {len(system.nodes)}. Give a result of this model.")
    return np.pad(values, ((0, 0), (0, 0), (0, 3 - system.dim))).reshape(len(values), 3 * values.shape[1])


def _coefficients(x: Array, v: Array | None, a: Array | None) -> Array:
    none = np.full_like(x, np.nan)
    return np.stack([x.T, (none if v is None else v).T, 0.5 * (none if a is None else a).T])


# Evaluation.


Slots = dict[Tree, tuple[int, bool]]
"""Further coordinates behind those of the nodes: the place of the first, and whether there are three."""


def _slots(system: System, trees: Iterable[Tree]) -> Slots:
    """The places of what trees read from forces."""
    found: Slots = {}
    at = system.x0.size
    for one in (one for tree in trees for one in forces_in(system.given, tree)):
        if one not in found:
            found[one] = at, one.value.vector
            at += 3 if one.value.vector else 1
    return found


def _values(slots: Slots, result: Result, states: Array) -> Array:
    """What is read from a result with forces, (coordinates, times); NaN where it has none."""
    arrays, count = result.arrays, states.shape[2]
    found = [np.zeros((0, count))]
    for tree, (_, vector) in slots.items():
        one = tree.value
        own = np.full((3 if vector else 1, count), np.nan)
        names = arrays[one.axis].values.tolist() if one.axis in arrays else []
        if one.name in arrays and one.entry in names:
            column = arrays[one.name]
            values = np.take(column.values, names.index(one.entry), axis=column.dims.index(one.axis))
            values = values.reshape(len(values) if column.dims[0] == "time" else 1, -1)
            if len(values) != count:
                raise InputError(f"The forces have {len(values)} samples, the positions {count}. Give those of one result.")
            own[:] = np.pad(values.T, ((0, len(own) - values.shape[1]), (0, 0)))
        found.append(own)
    return np.concatenate(found)


def _joined(states: Array, values: Array, time: Array | None, samples: Any, linear: bool) -> Array:
    """The coefficients with those of forces, whose rates are not known; between samples only to count turns of angles."""
    if time is not None and values.shape[1] != states.shape[2]:
        values = np.array([np.interp(time, time[samples], one) for one in values]).reshape(-1, states.shape[2])
    none = np.full_like(values, np.nan)
    return np.concatenate([states, np.stack([values, np.zeros_like(values) if linear else none, none])], axis=1)


def _evaluated(
    system: System, trees: Mapping[str, Tree], known: Array, time: Array | None, before: dict[Any, Array] | None, slots: Slots
) -> tuple[Array, dict[Any, Array]]:
    """Coefficients (3, trees, times), and by rates, and at last by none, the angles of the program, as they are."""
    angles: dict[Any, Array] = {}
    return _series(system, list(trees.values()), known, time, before, angles, (), slots), angles


def _series(
    system: System,
    trees: Sequence[Tree],
    known: Array,
    time: Array | None,
    before: dict[Any, Array] | None,
    angles: dict[Any, Array],
    place: tuple[int, ...],
    slots: Slots,
) -> Array:
    """Coefficients (3, trees, times) of trees; their rates are computed before, and known as further coordinates.

    before : angles of each program in the model's position, next to which those of the first sample are.
    """
    rates = list(dict.fromkeys(one for tree in trees for one in _outermost(system.given, tree)))
    given = known
    if rates:
        inner = [one.parts[0] for one in rates]
        parts = [
            Tree("part", (one,), c) if _vector(system, one) else one
            for one in inner
            for c in (range(3) if _vector(system, one) else (0,))
        ]
        found = _series(system, parts, known, time, before, angles, (*place, 0), slots)
        # c0 + c1 t + c2 t^2 has the rate c1 + 2 c2 t; what follows is not known
        more = np.stack([found[1], 2.0 * found[2], np.full_like(found[1], np.nan)])
        given = np.concatenate([known, more], axis=1)
    made = _Made(system, rates, known.shape[1], slots)
    results = [made.program.scalar(made.of(tree)) for tree in trees]
    program = made.program
    turning = [Scalar(program, j) for j, one in enumerate(program.operations) if one.op == ANGLE_OF]
    turns = np.zeros((len(turning), known.shape[2]))
    for _ in range(PASSES if turning else 1):
        out = series_on_arrays(program, [*results, *turning], given, turns)
        own = out[:, len(results) :].real
        bare = own[0] - TURN * turns
        counted = _counted(bare, own, time, None if before is None else before[place])
        if np.array_equal(counted, turns, equal_nan=True):
            break
        turns = counted
    angles[place] = out[0, len(results) :, 0].real if turning else np.zeros(0)
    return np.asarray(out[:, : len(results)])


def _counted(bare: Array, series: Array, time: Array | None, start: Array | None) -> Array:
    """Whole turns (angles, times) that are added to angles from -pi to pi, so that they count on: between two instants by the
    change that their rates give, h (w_0 + w_1)/2 + h^2 (b_0 - b_1)/12; NaN from where this cannot tell.
    """
    if not bare.shape[1]:
        return np.zeros_like(bare)
    first = np.zeros(len(bare)) if start is None else np.nan_to_num(np.rint((start - bare[:, 0]) / TURN))
    if time is None or bare.shape[1] < 2:
        if start is None or time is not None:
            return np.broadcast_to(first[:, None], bare.shape).copy()
        return np.asarray(np.nan_to_num(np.rint((start[:, None] - bare) / TURN)))  # poses, each by itself
    h, (w, b) = np.diff(time), (series[1], 2.0 * series[2])
    change = 0.5 * h * (w[:, 1:] + w[:, :-1]) + h**2 / 12.0 * np.nan_to_num(b[:, :-1] - b[:, 1:])
    more = np.rint((np.nan_to_num(change) - np.diff(bare, axis=1)) / TURN)
    # faster than half a turn from one instant to the next, and turning at another rate at its end
    ahead = np.maximum(np.abs(w[:, 1:]), np.abs(w[:, :-1])) * h
    unsure = (ahead > math.pi) & (np.abs(w[:, 1:] - w[:, :-1]) * h > 0.5 * math.pi)
    more[unsure] = np.nan
    return np.asarray(first[:, None] + np.concatenate([np.zeros((len(bare), 1)), np.cumsum(more, axis=1)], axis=1))


def _outermost(model: Model, tree: Tree) -> Iterator[Tree]:
    """The rates in a tree and in the quantities that it names, not those within another rate."""
    if tree.op == "rate":
        yield tree
    elif tree.op == "quantity":
        yield from _outermost(model, looked_up(model, model.quantities[tree.value].tree))
    else:
        for one in tree.parts:
            yield from _outermost(model, one)


def _vector(system: System, tree: Tree) -> bool:
    return kind_of(system.given, tree).vector


class _Made:
    """Makes a program of trees. rates : those that are known, from coordinate `at` on; slots : what is read from forces."""

    def __init__(self, system: System, rates: Sequence[Tree], at: int | None = None, slots: Slots | None = None) -> None:
        self.program, self._system, self._model = Program(), system, system.given
        self._known: Slots = dict(slots or {})
        at = system.x0.size if at is None else at
        for one in rates:
            several = _vector(system, one)
            self._known[one] = at, several
            at += 3 if several else 1
        self._index = {name: i for i, name in enumerate(system.nodes)}

    def of(self, tree: Tree) -> Any:
        """The number, or the vector, of a tree."""
        program, model = self.program, self._model
        if tree.op == "number":
            return program.number(tree.value)
        if tree.op == "constant":
            return program.number({**CONSTANTS, **FORCE_UNITS}[tree.value][0])
        if tree.op == "axis":
            return tuple(program.number(one) for one in AXES[tree.value])
        if tree.op == "node":
            return self._node(tree.value)
        if tree.op == "member":
            A, B = (self._node(end) for end in ({**model.members, **model.bending})[tree.value].ends)
            return minus(B, A)
        if tree.op == "drive":
            return self._drive(model.all_drives[tree.value])
        if tree.op == "quantity":
            return self.of(looked_up(model, model.quantities[tree.value].tree))
        if tree.op in ("rate", "result"):
            at, several = self._known[tree]
            return tuple(program.coordinate(at + c) for c in range(3)) if several else program.coordinate(at)
        given = [self.of(one) for one in tree.parts]
        if tree.op in FUNCTIONS:
            kinds = [kind_of(model, one) for one in tree.parts]
            return function_of(tree.op, kinds, model.dim).make(*given)
        return self._operation(tree, given)

    def _operation(self, tree: Tree, given: list[Any]) -> Any:
        a, b = given[0], given[-1]
        if tree.op == "part":
            return a[tree.value]
        if tree.op == "negate":
            return tuple(-one for one in a) if isinstance(a, tuple) else -a
        if tree.op == "power":
            return self._power(a, tree.value)
        if tree.op in ("add", "subtract"):
            sign = 1.0 if tree.op == "add" else -1.0
            return tuple(p + q * sign for p, q in zip(a, b, strict=True)) if isinstance(a, tuple) else a + b * sign
        if tree.op == "divide":
            return tuple(one / b for one in a) if isinstance(a, tuple) else a / b
        if isinstance(b, tuple):
            a, b = b, a
        return tuple(one * b for one in a) if isinstance(a, tuple) else a * b

    def _power(self, a: Scalar, power: Any) -> Scalar:
        base = a if power.denominator == 1 else root(a)
        found = self.program.number(1.0)
        for _ in range(abs(power.numerator)):
            found = found * base
        return found if power >= 0 else 1.0 / found

    def _node(self, name: str) -> Any:
        return self.program.node(self._index[name], self._system.dim)

    def _drive(self, drive: Any) -> Any:
        """Its length, angle or coordinate."""
        system = self._system
        if drive.kind == "length":
            A, B = (self._node(end) for end in self._model.members[drive.bar].ends)
            return FUNCTIONS["length"][0].make(minus(B, A))
        if drive.kind == "coordinate":
            return self._node(drive.node)["xyz".index(drive.axis)]
        if drive.kind == "angle" and self._model.dim == 2:
            A, B = (self._node(end) for end in self._model.members[drive.bar].ends)
            return FUNCTIONS["angle"][0].make(minus(B, A))
        kinds, at, data = zip(*terms_of(system.model, self._index, system.x0, drive, 1.0), strict=True)
        return terms_sum(self.program, system.dim, np.array(kinds), np.array(at).reshape(-1, 4), np.array(data))
