"""The larger of two sizes, in which a number that is not finite is never lost."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_inline

__all__ = ["larger"]


@kernel_inline
def larger(a: float, b: float) -> float:
    """The larger of a and b; NaN where either is NaN, which `max` and chains of `<` forget."""
    return a if b <= a or a != a else b
