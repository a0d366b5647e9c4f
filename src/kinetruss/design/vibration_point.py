"""Natural frequencies of an unloaded elastic structure at rest, so that limits on them have gradients.

    (K - w_j^2 M) f_j = 0,  f_j^T M f_j = 1,   K = G^T f^-1 G of elastic bars

dw_j^2/dp = f_j^T (dK/dp - w_j^2 dM/dp) f_j (Fox and Kapoor, AIAA J. 6 (1968) 2426), here by the equations of `gradients.points`
with frequencies and shapes as unknowns. Of frequencies that meet, each keeps the derivative along its own shape: a certificate
with multipliers of these alone is sufficient (of all shapes of the pair, a positive semidefinite one would be).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from scipy.linalg import eigh
from scipy.sparse import diags_array

from kinetruss.errors import InputError
from kinetruss.gradients.nearness import sites
from kinetruss.mechanics import System, constraint_jacobian
from kinetruss.mechanics.matrices import mass_by_nodes, mass_matrix
from kinetruss.results import variable
from kinetruss.statics.small_displacements import flexibility, stiff_rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


class VibrationPoint:
    """A `Point` of `flexible.frequencies` for bars without load: ``frequency`` (mode) Hz and ``mass``.

    modes : number of the lowest ones.
    """

    linear = False

    def __init__(self, system: System, modes: int = 3) -> None:
        model = system.given
        if model.loads or model.gravity is not None:
            raise InputError(
                "Frequencies have gradients only without loads and gravity, which would stiffen or soften them. Set gravity "
                "to null and leave the loads out."
            )
        self.system, self.modes = system, int(modes)
        K, M = self._matrices(system)
        if not 1 <= self.modes <= len(K):
            raise InputError(f"modes is {modes}, but the structure has {len(K)}. Give a number from 1 to {len(K)}.")
        square, shape = eigh(K, M)
        self.square, self.shape = square[: self.modes], shape[:, : self.modes]
        n = len(K)
        self.unknown = np.concatenate([np.append(self.shape[:, k], self.square[k]) for k in range(self.modes)])
        self.size = np.concatenate(
            [np.append(np.full(n, np.abs(self.shape[:, k]).max()), self.square[k]) for k in range(self.modes)]
        )
        node = np.repeat(sites(system)["node"], 3)[stiff_rows(system).free]
        self.at = np.tile(np.append(node, -1), self.modes).astype(np.int64)
        self.row = self.at

    def _matrices(self, system: System) -> tuple[Floats, Floats]:
        """K and M, dense, of the free coordinates."""
        held, x = stiff_rows(system), system.x0
        soft = flexibility(held, x)
        if not (np.isfinite(soft).all() and (soft > 0).all() and (held.row_kind == 0).all()):
            raise InputError(
                "Frequencies have gradients only of structures of elastic bars, with a section and a material each."
            )
        G = constraint_jacobian(held, x)[:, held.free]
        K = np.asarray((G.T @ diags_array(1.0 / soft) @ G).toarray())
        return K, mass_matrix(system, x)[held.free][:, held.free].toarray()

    def data(self) -> xr.Dataset:
        """Frequencies by mode, from 1; the mass of the model."""
        own = self.columns(self.system, self.unknown, ("frequency", "mass"))
        modes = np.arange(1, self.modes + 1).astype(str)
        return xr.Dataset(
            {"frequency": variable(("mode",), own["frequency"], "Hz", "natural frequency"),
             "mass": variable((), np.asarray(own["mass"].sum()), "kg", "mass of the model")},
            coords={"mode": modes},
        )  # fmt: skip

    def columns(self, system: System, unknown: Floats, names: Sequence[str]) -> dict[str, Floats]:
        """The named results at other numbers and unknowns."""
        found: dict[str, Any] = {}
        if "frequency" in names:
            found["frequency"] = np.sqrt(unknown.reshape(self.modes, -1)[:, -1]) / (2 * np.pi)
        if "mass" in names:
            found["mass"] = mass_by_nodes(system)
        return found

    def sites(self, name: str) -> NDArray[np.int64]:
        """Frequencies are nowhere in particular."""
        return np.full(self.modes, -1) if name == "frequency" else sites(self.system)["node"]

    def refuse(self, seeds: Any) -> None:
        """Of frequencies that meet, each keeps its own: nothing is refused."""

    def residual(self, system: System) -> Floats:
        """The equations of every mode at other numbers."""
        K, M = self._matrices(system)
        parts = []
        for k in range(self.modes):
            shape, square = self.shape[:, k], self.square[k]
            parts.append(np.append(K @ shape - square * (M @ shape), 0.5 * (1 - shape @ M @ shape)))
        return np.concatenate(parts)

    def transposed(self, right: Floats) -> Floats:
        """z (k, m), of responses of the frequencies: the shapes themselves. Of equal frequencies one pair of shapes of many."""
        found = np.zeros_like(right)
        n = self.shape.shape[0]
        for k in range(self.modes):
            found[:, k * (n + 1) : k * (n + 1) + n] = -right[:, (k + 1) * (n + 1) - 1, None] * self.shape[:, k]
        return found
