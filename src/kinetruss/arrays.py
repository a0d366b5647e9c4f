"""Arrays that users give, checked once at the public border: they hold numbers, of an expected shape, and all finite."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, shown
from kinetruss.limits import LARGEST

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Shape", "array_of"]

Shape = Mapping[str, "int | Sequence[str] | None"]
"""The axes of an array by name. The size of an axis is a number, the names of its entries, or None for any size. A first axis
``"..."`` stands for any number of axes."""


def array_of(given: Any, name: str, *shapes: Shape, unit: str = "") -> NDArray[np.float64]:
    """The argument `name` as an array of float64 in one of some shapes; without shapes, in any.

    The array is the given one itself if that is float64 already.

    Raises
    ------
    InputError : text, objects, ragged rows or complex numbers; another shape; a number that is not finite, or larger than
        `limits.LARGEST`. The message says what was given and what is expected.

    Examples
    --------
    >>> array_of([[0, 1], [2, 3]], "position", {"n_nodes": ("A", "B"), "dim": 2}, unit="m").tolist()
    [[0.0, 1.0], [2.0, 3.0]]
    >>> array_of([[0, 1]], "position", {"n_nodes": ("A", "B"), "dim": 2}, unit="m")
    Traceback (most recent call last):
    ...
    kinetruss.errors.InputError: position: shape (1, 2), expected (n_nodes = 2, dim = 2), m.
    """
    found = _numbers(given)
    if found is None:
        raise InputError(f"{name}: {shown(given)}, expected {_expected(shapes, unit)}.")
    fitting = [shape for shape in shapes if _fits(found.shape, shape)]
    if shapes and not fitting:
        raise InputError(f"{name}: shape {found.shape}, expected {_expected(shapes, unit)}.")
    if not (np.abs(found) <= LARGEST).all():
        _refuse_number(found, name, fitting[0] if fitting else {}, unit)
    return found


def _numbers(given: Any) -> NDArray[np.float64] | None:
    """The numbers as an array; None if they are no real numbers, or rows of different lengths."""
    try:
        found = np.asarray(given)
        if found.dtype.kind == "O" and all(isinstance(one, Real) for one in found.flat):
            return found.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        return None
    if found.dtype.kind not in "iuf":
        return None
    with np.errstate(over="ignore"):  # what overflows becomes infinite, and is refused as such
        return np.asarray(found, np.float64)


def _size(axis: int | Sequence[str] | None) -> int | None:
    return axis if axis is None or isinstance(axis, int) else len(axis)


def _fits(sizes: tuple[int, ...], shape: Shape) -> bool:
    wanted = [_size(axis) for name, axis in shape.items() if name != "..."]
    if len(sizes) < len(wanted) or (len(sizes) > len(wanted) and "..." not in shape):
        return False
    own = sizes[len(sizes) - len(wanted) :]
    return all(size is None or size == one for size, one in zip(wanted, own, strict=True))


def _expected(shapes: tuple[Shape, ...], unit: str) -> str:
    """The shapes in words, e.g. ``(n_nodes = 4, dim = 2), m``."""
    words = " or ".join(_words(shape) for shape in shapes) or "numbers"
    return f"{words}, {unit}" if unit else words


def _words(shape: Shape) -> str:
    sizes = {name: _size(axis) for name, axis in shape.items()}
    axes = [name if size is None else f"{name} = {size}" for name, size in sizes.items()]
    return f"({', '.join(axes)}{',' if len(axes) == 1 else ''})" if axes else "one number"


def _refuse_number(found: NDArray[np.float64], name: str, shape: Shape, unit: str) -> None:
    """Refuse the first number that is not finite or too large, with its place."""
    place = tuple(int(i) for i in np.argwhere(~(np.abs(found) <= LARGEST))[0])
    axes = list(shape.values())[-len(place) :] if place else []
    lead: list[int | Sequence[str] | None] = [None] * (len(place) - len(axes))
    words = [repr(axis[i]) if isinstance(axis, Sequence) else str(i) for i, axis in zip(place, [*lead, *axes], strict=True)]
    at = f"[{', '.join(words)}]" if words else ""
    wanted = f"numbers of at most {LARGEST:g}" if np.isfinite(found[place]) else "finite numbers"
    raise InputError(f"{name}{at}: {found[place]:g}, expected {wanted}{f' ({unit})' if unit else ''}.")
