"""What the text of a response computes, with its derivatives by the values read.

A response is read by Python's own grammar, of which a short list of constructs is taken and nothing is executed: numbers, units
(mm, kN, MPa, deg ...), variables of the result, their entries by name in brackets, + - * / and powers, and `FUNCTIONS`.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.errors import few
from kinetruss.model import nearest
from kinetruss.model.expression_kinds import CONSTANTS, FORCE_UNITS, NUMBER, Frequency, Kind, in_unit, same_unit
from kinetruss.model.measured_forces import ExpressionError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Push = Callable[[Floats], None]
    Map = Callable[[Floats], Floats]
    Seeds = dict[str, Floats]

DEEPEST = 60
"""Levels of brackets and operations in each other."""
TIE = 1e-9
"""Values that differ by less than this fraction are equally large."""
TIME = "time"
OF_MOTORS = {name: (1.0, in_unit(name)) for name in ("V", "A", "kg", "J")}

FUNCTIONS: dict[str, str] = {
    "abs": "abs(x): magnitude",
    "sqrt": "sqrt(x): square root",
    "size": "size(x): length of vectors along their components",
    "max": "max(x), max(x, y, ...): the largest",
    "min": "min(x), min(x, y, ...): the smallest",
    "sum": "sum(x): of all entries",
    "mean": "mean(x): over time, and of entries",
    "rms": "rms(x): root of the mean square over time, and of entries",
    "pnorm": "pnorm(x, p): (sum |x|^p)^(1/p), a smooth bound above max(abs(x))",
    "ks": "ks(x, r): ln(sum exp(r x))/r, a smooth bound above max(x) (Kreisselmeier & Steinhauser, 1979); r in one over x",
    "first": "first(x): at the first instant",
    "final": "final(x): at the last instant",
    "at": "at(x, t): at an instant, linear between samples",
}


class Value(NamedTuple):
    """Values over axes, what they measure, and what takes the derivatives by them back to the variables that were read."""

    array: Floats
    dims: tuple[str, ...]
    kind: Kind
    push: Push
    units: tuple[str, Sequence[str]] | None = None
    """Axis along which entries have units of their own, and these."""


@dataclass(eq=False)
class Source:
    """A result that is read: variables, names along axes; seeds and ties are gathered."""

    of: Mapping[str, Any]
    labels: Mapping[str, list[Any]]
    units: Mapping[str, tuple[str, Sequence[str]]] = field(default_factory=dict)
    seeds: Seeds = field(default_factory=dict)
    ties: list[str] = field(default_factory=list)
    sharing: bool = False


def value_of(node: Any, text: str, at: Source, depth: int) -> Value:
    """The value of a part of a response."""
    own = ast.get_source_segment(text, node) or text
    if depth > DEEPEST:
        raise ExpressionError(f"has more than {DEEPEST} operations in each other.", "Divide it.")

    def below(one: Any) -> Value:
        return value_of(one, text, at, depth + 1)

    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        return _constant(float(node.value), NUMBER)
    if isinstance(node, ast.Name):
        found = _named(node.id, at)
        if found.units is not None:
            several = few(sorted({*found.units[1]}), 4)
            raise ExpressionError(f"reads {own!r}, which is in {several}.", f"Name a {found.units[0]} in brackets.")
        return found
    if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name):
        picked = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        return _entry(_named(node.value.id, at), [_label(one, text) for one in picked], own, at)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return _elementwise(below(node.operand), lambda a: -a, lambda a: -np.ones_like(a))
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        return _power(below(node.left), node.right, own)
    if isinstance(node, ast.BinOp) and type(node.op) in (ast.Add, ast.Sub, ast.Mult, ast.Div):
        return _operation(type(node.op), below(node.left), below(node.right), own)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords and node.args:
        if node.func.id not in FUNCTIONS:
            raise ExpressionError(f"has no function {node.func.id!r}.", nearest(node.func.id, FUNCTIONS))
        return _function(node.func.id, [below(one) for one in node.args], own, at)
    raise ExpressionError(f"has {own!r}, which may not stand here.", f"Write + - * / **, names and {', '.join(FUNCTIONS)}.")


def _constant(value: float, kind: Kind) -> Value:
    return Value(np.array(value), (), kind, lambda _: None)


def _label(node: Any, text: str) -> str:
    """The name of an entry, as it is written."""
    if isinstance(node, ast.Constant):
        return str(node.value)
    return ast.get_source_segment(text, node) or text


def _named(name: str, at: Source) -> Value:
    """A variable of the result, or a unit."""
    if name in at.of:
        one = at.of[name]
        values = np.asarray(one.values, float)

        def push(g: Floats) -> None:
            at.seeds[name] = at.seeds.get(name, np.zeros_like(values)) + g

        unit = one.attrs.get("units", "")
        axis, slash, rest = unit.partition("/")
        if axis not in at.units:
            return Value(values, tuple(one.dims), in_unit(unit), push)
        dim, units = at.units[axis][0], [f"{one}{slash}{rest}" for one in at.units[axis][1]]
        if len({*units}) > 1:
            return Value(values, tuple(one.dims), NUMBER, push, (dim, units))
        return Value(values, tuple(one.dims), in_unit(next(iter(units), "")), push)
    if name in (constants := {**CONSTANTS, **FORCE_UNITS, **OF_MOTORS}):
        return _constant(*constants[name])
    raise ExpressionError(f"has {name!r}, which the result does not have.", nearest(name, at.of))


def _entry(whole: Value, names: list[str], own: str, at: Source) -> Value:
    """An entry of a variable by its name along one axis or several."""
    place: list[Any] = [slice(None)] * whole.array.ndim
    for name in names:
        found = [
            k for k, dim in enumerate(whole.dims) if isinstance(place[k], slice) and name in map(str, at.labels.get(dim, ()))
        ]
        if not found:
            known = [str(one) for dim in whole.dims if dim != TIME for one in at.labels.get(dim, ())]
            raise ExpressionError(f"has {own!r}, but no {' or '.join(whole.dims)} called {name!r}.", nearest(name, known))
        place[found[0]] = [str(one) for one in at.labels[whole.dims[found[0]]]].index(name)
    key = tuple(place)
    left = tuple(dim for dim, one in zip(whole.dims, place, strict=True) if isinstance(one, slice))

    def push(g: Floats) -> None:
        back = np.zeros_like(whole.array)
        back[key] = g
        whole.push(back)

    if whole.units is None:
        return Value(whole.array[key], left, whole.kind, push)
    dim, units = whole.units
    if dim in left:
        raise ExpressionError(f"reads {own!r}, which is in {few(sorted({*units}), 4)}.", f"Name a {dim} in brackets.")
    return Value(whole.array[key], left, in_unit(units[place[whole.dims.index(dim)]]), push)


def _elementwise(a: Value, make: Map, slope: Map, kind: Kind | None = None) -> Value:
    return Value(np.asarray(make(a.array)), a.dims, kind or a.kind, lambda g: a.push(g * slope(a.array)))


def _power(a: Value, exponent: Any, own: str) -> Value:
    sign = 1
    if isinstance(exponent, ast.UnaryOp) and isinstance(exponent.op, ast.USub):
        sign, exponent = -1, exponent.operand
    n = exponent.value if isinstance(exponent, ast.Constant) else None
    if not isinstance(n, int | float) or isinstance(n, bool):
        raise ExpressionError(f"has the power {own!r}.", "Exponents are numbers, as in a**2.")
    n = sign * n
    return _elementwise(a, lambda x: x**n, lambda x: n * x ** (n - 1), a.kind.to(Fraction(n).limit_denominator(1000)))


def _operation(op: type, a: Value, b: Value, own: str) -> Value:
    """The sum, difference, product or quotient, over the axes of both."""
    dims = (*a.dims, *(dim for dim in b.dims if dim not in a.dims))
    x, y = (_spread(one, dims) for one in (a, b))
    if op in (ast.Add, ast.Sub):
        try:
            same_unit(a.kind, b.kind)
        except ExpressionError as error:
            raise ExpressionError(f"{own!r} {error.message}", error.mend) from None
        sign = 1.0 if op is ast.Add else -1.0
        found, kind = x + sign * y, b.kind if a.kind == NUMBER or isinstance(a.kind, Frequency) else a.kind
        slopes: tuple[Any, Any] = (1.0, sign)
    elif op is ast.Mult:
        found, kind, slopes = x * y, a.kind.times(b.kind), (y, x)
    else:
        with np.errstate(divide="ignore", invalid="ignore"):
            found, kind, slopes = x / y, a.kind.times(b.kind, -1), (1.0 / y, -x / (y * y))

    def push(g: Floats) -> None:
        for one, slope in zip((a, b), slopes, strict=True):
            one.push(_gathered(g * slope, dims, one.dims))

    return Value(np.asarray(found), dims, kind, push)


def _spread(one: Value, dims: tuple[str, ...]) -> Floats:
    """Its array over these axes, of length 1 where it has none."""
    held = [dim for dim in dims if dim in one.dims]
    moved = np.transpose(one.array, [one.dims.index(dim) for dim in held])
    sizes = iter(moved.shape)
    return np.asarray(moved.reshape([next(sizes) if dim in held else 1 for dim in dims]))


def _gathered(g: Floats, dims: tuple[str, ...], to: tuple[str, ...]) -> Floats:
    """The derivatives by an operand: summed over the axes that it does not have."""
    gone = tuple(k for k, dim in enumerate(dims) if dim not in to)
    left = [dim for dim in dims if dim in to]
    return np.transpose(np.sum(g, axis=gone), [left.index(dim) for dim in to])


def _function(name: str, given: list[Value], own: str, at: Source) -> Value:
    a, rest = given[0], given[1:]
    if name in ("max", "min") and rest:
        return _largest_of(given, -1.0 if name == "min" else 1.0, own, at)
    if name in ("pnorm", "ks", "at"):
        if len(rest) != 1 or rest[0].array.ndim:
            raise ExpressionError(f"{own!r} takes an expression and one number.", f"Write {FUNCTIONS[name].split(':')[0]}.")
    elif rest:
        raise ExpressionError(f"{own!r} takes one expression.", f"Write {FUNCTIONS[name].split(':')[0]}.")
    if name == "abs":
        return _elementwise(a, np.abs, np.sign)
    if name == "sqrt":
        return _elementwise(a, np.sqrt, lambda x: 0.5 / np.sqrt(x), a.kind.to(Fraction(1, 2)))
    if name == "size":
        return _size(a, own)
    if name in ("max", "min"):
        return _largest(a, -1.0 if name == "min" else 1.0, own, at)
    if name in ("first", "final", "at"):
        return _instant(a, None if name != "at" else float(rest[0].array), name, own, at)
    return _total(name, a, float(rest[0].array) if rest else 0.0, at)


def _size(a: Value, own: str) -> Value:
    if not a.dims or a.dims[-1] == TIME:
        raise ExpressionError(f"{own!r} has no components.", "Take the size of vectors, as size(displacement[C]).")
    length = np.sqrt((a.array**2).sum(axis=-1))

    def push(g: Floats) -> None:
        with np.errstate(invalid="ignore", divide="ignore"):
            a.push(np.where(g[..., None] != 0.0, g[..., None] * a.array / length[..., None], 0.0))

    return Value(length, a.dims[:-1], a.kind, push)


def _largest(a: Value, sign: float, own: str, at: Source) -> Value:
    """The largest entry of all; equal ones elsewhere are noted as ties."""
    values = sign * a.array
    if not values.size or np.isnan(values).all():
        raise ExpressionError(f"{own!r} has no entries.", "Take a variable that has some.")
    top = np.unravel_index(int(np.nanargmax(values)), values.shape)
    near = np.argwhere(values >= values[top] - TIE * max(abs(values[top]), float(np.nanmax(np.abs(values)))))
    if len(near) > 1 and not _one_peak(near, a.dims):
        at.ties.append(f"{own} has {few([_name_of(one, a.dims, at) for one in near], 4)}")

    def push(g: Floats) -> None:
        back = np.zeros_like(a.array)
        if at.sharing:
            back[tuple(near.T)] = g * _parts(len(near))
        else:
            back[top] = g
        a.push(back)

    return Value(np.asarray(a.array[top]), (), a.kind, push)


def _parts(count: int) -> Floats:
    """Parts of 1, none a simple fraction, so that no sum of different gradients is one of them by chance."""
    found = 1.0 + np.sqrt(2.0 + np.arange(count))
    return np.asarray(found / found.sum())


def _one_peak(near: NDArray[np.int64], dims: tuple[str, ...]) -> bool:
    """Whether entries are neighbours in time of one and the same part."""
    if TIME not in dims:
        return False
    k = dims.index(TIME)
    others = np.delete(near, k, axis=1)
    return bool((others == others[0]).all() and (np.diff(np.sort(near[:, k])) == 1).all())


def _name_of(place: NDArray[np.int64], dims: tuple[str, ...], at: Source) -> str:
    words = [
        f"{at.labels[dim][k]:.6g} s" if dim == TIME else str(at.labels[dim][k]) for dim, k in zip(dims, place, strict=True)
    ]
    return " ".join(words)


def _largest_of(given: list[Value], sign: float, own: str, at: Source) -> Value:
    """The largest of several numbers."""
    for one in given:
        if one.array.ndim:
            raise ExpressionError(f"{own!r} compares what has several entries.", "Write max(max(a), max(b)).")
        same_unit(given[0].kind, one.kind)
    values = sign * np.array([float(one.array) for one in given])
    k = int(np.argmax(values))
    near = np.flatnonzero(values >= values[k] - TIE * np.abs(values).max())
    if len(near) > 1:
        at.ties.append(f"{own} has several arguments")

    def push(g: Floats) -> None:
        for j, part in zip(near, _parts(len(near)), strict=True) if at.sharing else [(k, 1.0)]:
            given[j].push(g * part)

    return given[k]._replace(push=push)


def _instant(a: Value, t: float | None, name: str, own: str, at: Source) -> Value:
    """The values at an instant."""
    if TIME not in a.dims:
        raise ExpressionError(f"{own!r} has no instants.", "Leave the instant out.")
    k, times = a.dims.index(TIME), np.asarray(at.labels[TIME], float)
    around = None
    if t is None:
        j, share = (0, 0.0) if name == "first" else (len(times) - 1, 0.0)
    elif not times[0] <= t <= times[-1]:
        raise ExpressionError(f"{own!r} is at {t:g} s.", f"The result is from {times[0]:g} s to {times[-1]:g} s.")
    else:
        j = min(int(np.searchsorted(times, t, side="right")) - 1, max(len(times) - 2, 0))
        share = (t - times[j]) / (times[j + 1] - times[j]) if len(times) > 1 else 0.0
        around = (j, j + 1) if share else (max(j - 1, 0), min(j + 1, len(times) - 1))
    parts = [(j, 1.0 - share), *([(j + 1, share)] if share else [])]
    found = sum(weight * np.take(a.array, row, axis=k) for row, weight in parts)

    def push(g: Floats) -> None:
        back = np.zeros_like(a.array)
        for row, weight in parts:
            np.moveaxis(back, k, 0)[row] = weight * g
        a.push(back)
        if around is not None and around[1] > around[0] and TIME in at.of:  # samples may move
            before, after = (np.take(a.array, row, axis=k) for row in around)
            rate = float(np.sum(g * (after - before))) / (times[around[1]] - times[around[0]])
            own = at.seeds.setdefault(TIME, np.zeros_like(times))
            for row, weight in parts:
                own[row] -= weight * rate

    return Value(np.asarray(found), a.dims[:k] + a.dims[k + 1 :], a.kind, push)


def _total(name: str, a: Value, p: float, at: Source) -> Value:
    """Sums, means and smooth maxima of all entries."""
    # entries that do not apply are NaN; of those over time all are asked for
    known = ~np.isnan(a.array) if name in ("sum", "pnorm", "ks") else np.ones(a.array.shape, np.bool_)
    x = np.where(known, a.array, 0.0)
    weight = _weights(a, at) if name in ("mean", "rms") else known * 1.0
    kind = a.kind
    if name in ("sum", "mean"):
        found, slope = float((weight * x).sum()), weight
    elif name == "rms":
        found = math.sqrt(float((weight * x * x).sum()))
        slope = weight * x / (found or 1.0)
    elif name == "pnorm":
        top = float(np.abs(x).max(initial=0.0)) or 1.0
        found = top * float(((np.abs(x) / top) ** p).sum()) ** (1.0 / p)
        slope = np.sign(x) * (np.abs(x) / (found or 1.0)) ** (p - 1.0)
    else:
        top = float(x[known].max()) if known.any() else 0.0
        raised = np.where(known, np.exp(p * (x - top)), 0.0)
        found, slope = top + math.log(float(raised.sum())) / p, raised / raised.sum()
    return Value(np.array(found), (), kind, lambda g: a.push(g * slope))


def _weights(a: Value, at: Source) -> Floats:
    """Weights of entries in a mean: over time by the trapezoidal rule."""
    weight = np.ones_like(a.array)
    for k, dim in enumerate(a.dims):
        own = np.full(a.array.shape[k], 1.0 / a.array.shape[k])
        if dim == TIME and len(own) > 1:
            times = np.asarray(at.labels[TIME], float)
            step = np.diff(times) / (times[-1] - times[0])
            own = 0.5 * (np.append(step, 0.0) + np.append(0.0, step))
        weight = weight * own.reshape([-1 if j == k else 1 for j in range(a.array.ndim)])
    return weight
