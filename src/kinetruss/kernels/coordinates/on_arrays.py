"""Coordinates and other expressions on NumPy's arrays, which may be complex: the code of straight_line, not compiled."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from kinetruss.kernels.coordinates.forms import FORMS
from kinetruss.kernels.coordinates.programs import Program, Scalar


def angle_of(s: Any, c: Any) -> Any:
    """atan2(s, c); of complex numbers near the real axis, as of complex steps, to first order in their imaginary parts."""
    if not (np.iscomplexobj(s) or np.iscomplexobj(c)):
        return np.arctan2(s, c)
    y, x = np.real(s), np.real(c)
    return np.arctan2(y, x) + 1j * (x * np.imag(s) - y * np.imag(c)) / (x * x + y * y)


_ON_ARRAYS = SimpleNamespace(sqrt=np.sqrt, sin=np.sin, cos=np.cos, atan2=angle_of)


@cache
def value_on_arrays(kind: int) -> Callable[..., Any]:
    """at (4,), data (7, ...), x (3 n, ...) -> factor times the value (...) of a kind of coordinate."""
    return _made(kind, -1)


@cache
def gradient_on_arrays(kind: int) -> Callable[..., None]:
    """at, data, x, out (12, ...): the gradient by P, 1, 2 and B, factor and all, into out."""
    return _made(kind, 0)


def _made(kind: int, order: int) -> Callable[..., Any]:
    from kinetruss.kernels.coordinates.straight_line import text  # it compiles; models without such coordinates do not need it

    made: dict[str, Any] = {"math": _ON_ARRAYS}
    exec(text(FORMS[kind], "made", order), made)  # noqa: S102
    function: Callable[..., Any] = made["made"]
    return function


def series_on_arrays(program: Program, results: Sequence[Scalar], known: Any, turns: Any = 0.0) -> Any:
    """Coefficients (3, results, times) of numbers of a program, from those of its coordinates, known (3, coordinates, times).

    Coefficient k is the k-th rate over k!. turns (angles, times) : whole turns that are added to the angles of the program, in
    their order; or one number.
    """
    from kinetruss.kernels.coordinates.straight_line import Lines

    lines = Lines(program.operations, len(known) - 1, lambda a, k: f"known[{k}, {a}]", "", first=0)
    lines.forward()
    out = np.zeros((len(known), len(results), known.shape[2]), known.dtype)
    for k in range(len(known)):
        for i, one in enumerate(results):
            lines.add(f"out[{k}, {i}] = {lines.of(one.index, k) or 0.0}")
    counted = iter(np.broadcast_to(2.0 * np.pi * turns, (len(program.operations), known.shape[2])) if np.ndim(turns) == 0
                   else 2.0 * np.pi * turns)  # fmt: skip
    math = SimpleNamespace(**vars(_ON_ARRAYS) | {"atan2": lambda s, c: angle_of(s, c) + next(counted)})
    with np.errstate(all="ignore"):  # what is not known, as the rate of an angle without arms, is NaN
        exec("\n".join(lines.text), {"math": math}, {"known": known, "out": out})  # noqa: S102
    return out
