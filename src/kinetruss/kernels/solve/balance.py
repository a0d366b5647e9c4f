"""Energies and momenta of the samples of a simulation."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F2
from kinetruss.kernels.solve.kkt import kinetic, momenta, potential
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["balance"]


@kernel
def balance(eq: Equations, ws: Workspace, x: F2, v: F2, out: F2) -> None:
    """Kinetic and potential energy (J), momentum (kg m/s), its moment about the origin (kg m^2/s) into out (samples, 8).

    x, v (samples, 3 n).
    """
    # T, V, p and the angular momentum of each sample
    for i in range(x.shape[0]):
        out[i, 0] = kinetic(eq, ws, x[i], v[i])
        out[i, 1] = potential(eq, x[i])
        momenta(eq, ws, x[i], v[i], out[i, 2:])
