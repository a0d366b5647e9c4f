"""Coordinates on NumPy's arrays, which may be complex: the code of straight_line, run without a compiler."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from kinetruss.kernels.coordinates.forms import FORMS


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
