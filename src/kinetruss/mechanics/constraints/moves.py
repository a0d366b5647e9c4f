"""Mechanisms and states of self-stress in words, in an order that does not depend on rounding."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import few

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["moves_text", "self_stress_text", "ranked"]

ALIKE = 1e-9
"""Sizes that differ by less than this fraction of the largest count as equal."""

SHOWN = 4, 6
"""Largest number of nodes or rows in a text."""


def ranked(sizes: NDArray[np.float64], least: float = 0.0) -> list[int]:
    """Indices of sizes above `least` times the largest, largest first; equal ones in their own order.

    A size counts as equal to the first of a group if it is within `ALIKE` of it: the order of two equal numbers must not
    depend on the processor.
    """
    top = float(sizes.max(initial=0.0))
    order = [int(i) for i in np.argsort(-sizes, kind="stable") if sizes[i] > least * top]
    found: list[int] = []
    run: list[int] = []
    for i in order:
        if run and sizes[run[0]] - sizes[i] > ALIKE * top:
            found += sorted(run)
            run = []
        run.append(i)
    return found + sorted(run)


def moves_text(mode: NDArray[np.float64], names: tuple[str, ...]) -> str:
    """A mode (n, dim) in words: which node moves in which direction, largest first."""
    order, most = ranked(np.linalg.norm(mode, axis=1), 1e-6), SHOWN[0]
    shown = [f"{names[i]} moves along {_direction(mode[i])}" for i in order[:most]]
    return ", ".join(shown) + (f" and {len(order) - most} more nodes" if len(order) > most else "")


def self_stress_text(state: NDArray[np.float64], names: tuple[str, ...]) -> str:
    """A state of self-stress (rows,) in words: which bars are in compression or tension, largest force first."""
    order, most = ranked(np.abs(state), 1e-6), SHOWN[1]
    return few([f"{names[i]} {_shown(state[i])}" for i in order], most)


def _direction(vector: NDArray[np.float64]) -> str:
    size = float(np.linalg.norm(vector))
    for axis, name in enumerate("xyz"[: len(vector)]):
        if abs(abs(vector[axis]) - size) < ALIKE * size:
            return f"{name} ({_shown(vector[axis])})"
    return "(" + ", ".join(_shown(value) for value in vector) + ")"


def _shown(value: float) -> str:
    """Three decimals, after rounding to nine: so neither -0.0000001 nor a half shows round-off."""
    return f"{round(round(float(value), 9), 3) + 0.0:+.3f}"
