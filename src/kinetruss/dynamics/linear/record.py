"""The record of a linearisation: labelled matrices, and responses computed from them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.dynamics.linear.signals import Input, Output
from kinetruss.errors import InputError
from kinetruss.mechanics.freedom import Basis
from kinetruss.model import nearest
from kinetruss.results import Result

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Linearisation", "chosen", "response_of"]


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Linearisation(Result):
    """Small motions z' = A z + B u, y = C z + D u, z = (q, q'), about a state.

    ``A`` (state, by_state), ``B`` (state, input), ``C`` (output, state), ``D`` (output, input); ``mass``, ``damping``,
    ``stiffness`` (dof, by_dof) reduced; ``transfer`` F' (node, axis, dof). Undamped modes, slowest first:
    ``frequency`` Hz, ``angular_frequency`` rad/s (NaN where the mode runs away), ``frequency_squared``, ``modal_damping``,
    ``modal_mass`` kg (mode), ``mode_shape`` (mode, node, axis). Poles of A: ``pole_real``, ``pole_imag``, ``pole_damping``.
    ``position``, ``member_force`` and ``drive_force`` of the state.
    """

    basis: Basis
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]
    velocity: NDArray[np.float64]

    @property
    def poles(self) -> NDArray[np.complex128]:
        """Eigenvalues of A (states,), 1/s, slowest first."""
        return np.asarray(self.data["pole_real"].values + 1j * self.data["pole_imag"].values)

    @property
    def stable(self) -> bool:
        """True if no small motion grows."""
        size = float(np.abs(self.poles).max())
        return bool(np.all(self.poles.real <= 1e-7 * size)) and bool(np.all(self.data["frequency_squared"] >= 0))

    def frequency_response(
        self, w: ArrayLike, of: str | Iterable[str] | None = None, wrt: str | Iterable[str] | None = None
    ) -> xr.DataArray:
        """Complex response (w, output, input) of outputs to inputs at angular frequencies w, rad/s.

        of, wrt : labels of outputs and inputs; by default all. Motions count as one input: value, rate and second rate go
        together.

        Raises
        ------
        InputError : unknown labels; a frequency at which an undamped mode resonates without bound.
        """
        return response_of(self, self.data["A"].values, w, of, wrt)

    def transmissibility(
        self, w: ArrayLike, of: str | Iterable[str] | None = None, wrt: str | Iterable[str] | None = None
    ) -> xr.DataArray:
        """Size of the frequency response: how much of a motion (or force) of `wrt` arrives at `of`; (w, output, input)."""
        return abs(self.frequency_response(w, of, wrt)).rename("transmissibility")


def response_of(
    lin: Linearisation, A: NDArray[np.float64], w: ArrayLike, of: Any, wrt: Any, C: NDArray[np.float64] | None = None
) -> xr.DataArray:
    """C (i w - A)^-1 B + D of the chosen outputs and inputs, motions joined: (w, output, input)."""
    at = np.atleast_1d(array_of(w, "w", {}, {"w": None}, unit="rad/s"))
    outputs = chosen(of, [one.label for one in lin.outputs], "output")
    wanted = chosen(wrt, [one.label for one in lin.inputs], "input")
    rows = [[one.label for one in lin.outputs].index(name) for name in outputs]
    C = (lin.data["C"].values if C is None else C)[rows]
    found = np.empty((len(at), len(rows), len(wanted)), complex)
    names = list(lin.data["input"].values)
    for j, label in enumerate(wanted):
        one = next(one for one in lin.inputs if one.label == label)
        columns = [names.index(name) for name, _ in one.columns]
        B, D = lin.data["B"].values[:, columns], lin.data["D"].values[rows][:, columns]
        for k, s in enumerate(1j * at):
            powers = s ** np.arange(len(columns))
            found[k, :, j] = C @ _solved(s, A, B @ powers) + D @ powers
    coords = {"w": at, "output": outputs, "input": wanted}
    return xr.DataArray(found, coords=coords, dims=("w", "output", "input"), name="frequency_response")


def _solved(s: complex, A: NDArray[np.float64], b: NDArray[np.complex128]) -> NDArray[np.complex128]:
    try:
        return np.asarray(np.linalg.solve(s * np.eye(len(A)) - A, b))
    except np.linalg.LinAlgError:
        raise InputError(
            f"An undamped mode resonates at w = {s.imag:g} rad/s, so its response has no bound. Leave that frequency out."
        ) from None


def chosen(given: Any, known: list[str], what: str) -> list[str]:
    """Labels by name, or all of them."""
    if given is None:
        return known
    names = [given] if isinstance(given, str) else list(given)
    for name in names:
        if name not in known:
            raise InputError(f"No {what} called {name!r}. {nearest(name, known)}".rstrip())
    return names
