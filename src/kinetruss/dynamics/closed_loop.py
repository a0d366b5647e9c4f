"""The record of a state feedback: closed loop, responses, and the force function for simulations."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.dynamics.linear_state import Input
from kinetruss.dynamics.linearisation import Linearisation, response_of
from kinetruss.mechanics import measure_gradients, measured
from kinetruss.model import GivenForce, turns
from kinetruss.results import Result

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.mechanics import System
    from kinetruss.mechanics.coordinates import Coordinate


def zero_order_hold(
    A: NDArray[np.float64], B: NDArray[np.float64], period: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A and B over a period with constant inputs (zero-order hold)."""
    from scipy.linalg import expm

    n, m = B.shape
    both = expm(period * np.block([[A, B], [np.zeros((m, n + m))]]))
    return both[:n, :n], both[:n, n:]


@dataclass(frozen=True, kw_only=True, eq=False)
class Feedback(Result):
    """State feedback u = -G z.

    ``gains`` G (input, state); ``closed_loop`` (state, by_state): A - B G, or over a period where sampled; ``pole_real``,
    ``pole_imag``, ``pole_damping`` (pole), slowest first; of a sampled loop log(z)/T.
    lin : what it acts on. multipliers : (poles,) z of a sampled loop, else None.
    """

    lin: Linearisation
    multipliers: NDArray[np.complex128] | None = None

    @property
    def poles(self) -> NDArray[np.complex128]:
        """Closed-loop poles (states,), 1/s."""
        return np.asarray(self.data["pole_real"].values + 1j * self.data["pole_imag"].values)

    @property
    def stable(self) -> bool:
        """True if all poles are in the left half-plane."""
        return bool(np.all(self.poles.real < 0))

    @property
    def period(self) -> float | None:
        """s between samples, or None."""
        return self.data.attrs["period"] or None

    def frequency_response(
        self, w: ArrayLike, of: str | Iterable[str] | None = None, wrt: str | Iterable[str] | None = None
    ) -> xr.DataArray:
        """Complex response (w, output, input) with the loop closed, at angular frequencies w, rad/s.

        Of a sampled loop: the component of the output at the frequency of the input (the hold adds others).
        """
        lin, acting = self.lin, list(self.data["input"].values)
        A, G = lin.data["A"].values, self.data["gains"].values
        B, D = (lin.data[name].sel(input=acting).values for name in ("B", "D"))
        if self.period is None:
            return response_of(lin, A - B @ G, w, of, wrt, C=lin.data["C"].values - D @ G)
        at = np.atleast_1d(array_of(w, "w", {}, {"w": None}, unit="rad/s"))
        given = response_of(lin, A, at, of, wrt)
        names = list(given["input"].values)
        by = response_of(lin, A, at, of, acting)
        Ad, Bd = zero_order_hold(A, B, self.period)
        for j, label in enumerate(names):
            one = next(one for one in lin.inputs if one.label == label)
            columns = lin.data["B"].sel(input=[name for name, _ in one.columns]).values
            for k, s in enumerate(1j * at):
                # x = e^{st} X: steady response X_s to the input, and z of the samples with u = -G z held over T
                turn = np.exp(s * self.period)
                steady = np.linalg.solve(s * np.eye(len(A)) - A, columns @ s ** np.arange(columns.shape[1]))
                z = np.linalg.solve(turn * np.eye(len(A)) - Ad + Bd @ G, turn * steady - Ad @ steady)
                # component of the held input at s: (1 - e^{-sT})/(s T)
                hold = 1.0 if s == 0 else (1 - 1 / turn) / (s * self.period)
                given[k, :, j] += by.values[k] @ (-G @ z) * hold
        return given

    def transmissibility(
        self, w: ArrayLike, of: str | Iterable[str] | None = None, wrt: str | Iterable[str] | None = None
    ) -> xr.DataArray:
        """Size of the frequency response with the loop closed: (w, output, input)."""
        return abs(self.frequency_response(w, of, wrt)).rename("transmissibility")

    def tasks(self) -> dict[str, GivenForce]:
        """Tasks for a simulation: the drives that the linearisation releases get the force that holds its state."""
        system, force = self.lin.basis.system, self.lin.data["drive_force"].values
        held = {*system.row_drive.tolist(), *system.coordinate_drive[:, 1].tolist()}
        return {
            name: GivenForce(torque=float(force[d])) if turns(drive) else GivenForce(float(force[d]))
            for d, (name, drive) in enumerate(system.model.all_drives.items())
            if d not in held
        }

    def user_force(self) -> Callable[[float, NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]:
        """A function f(t, x, v) -> nodal forces (n_nodes, dim), N, for ``dynamics.simulate(..., user_force=...)``.

        x, v (n_nodes, dim), m and m/s. A sampled loop reads the state at the first evaluation at or after each sampling
        instant and holds its forces from there. Fixed steps should be well below the period. One function serves one
        simulation.
        """
        lin = self.lin
        reader = _Reader(lin)
        acting = [next(one for one in lin.inputs if one.label == name) for name in self.data["input"].values]
        pusher = _Pusher(lin.basis.system, acting)
        G, period = self.data["gains"].values, self.period
        if period is None:
            return lambda _t, x, v: pusher(x, -(G @ reader(x, v)))
        hold = _Hold(period)
        return lambda t, x, v: pusher(x, hold(t, lambda: -(G @ reader(x, v))))


class _Hold:
    """Values held between sampling instants; a repeated step reads them again."""

    def __init__(self, period: float) -> None:
        self.period = period
        self.read: dict[int, tuple[float, NDArray[np.float64]]] = {}

    def __call__(self, t: float, value: Callable[[], NDArray[np.float64]]) -> NDArray[np.float64]:
        k = int(np.floor(t / self.period + 1e-9))
        if k not in self.read or t < self.read[k][0]:
            self.read = {j: kept for j, kept in self.read.items() if k - 64 < j <= k}
            self.read[k] = (t, value())
        return self.read[k][1]


class _Reader:
    """Degrees of freedom and their rates, relative to the state of a linearisation."""

    def __init__(self, lin: Linearisation) -> None:
        self.system, self.dofs, self.x0 = lin.basis.system, lin.basis.dofs, lin.basis.x
        dim = self.system.dim
        self.q0 = self._values(self.x0[:, :dim], lin.velocity[:, :dim])

    def __call__(self, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
        return self._values(x, v) - self.q0

    def _values(self, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
        found = [value_of(self.system, one, x) for one in self.dofs]
        for k, one in enumerate(self.dofs):
            if one.kind in ("angle", "sum"):
                # on the turn nearest to that of the state
                start = value_of(self.system, one, self.x0)
                found[k] = start + np.remainder(found[k] - start + np.pi, 2 * np.pi) - np.pi
        return np.array(found + [rate_of(self.system, one, x, v) for one in self.dofs])


class _Pusher:
    """Nodal forces of force inputs."""

    def __init__(self, system: System, acting: list[Input]) -> None:
        self.system, self.acting = system, acting

    def __call__(self, x: NDArray[np.float64], u: NDArray[np.float64]) -> NDArray[np.float64]:
        out = np.zeros_like(x)
        for value, one in zip(u, self.acting, strict=True):
            for part, factor in one.parts:
                push(self.system, part, x, factor * float(value), out)
        return out


def _full(y: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, dim) as (n, 3)."""
    return np.hstack([y, np.zeros((len(y), 3 - y.shape[1]))])


def value_of(system: System, one: Coordinate, x: NDArray[np.float64]) -> float:
    """The value of a coordinate, m or rad, at x (n, dim)."""
    if one.kind == "node":
        return float(x[one.index // 3, one.index % 3])
    if one.kind == "sum":
        return float(measured(system, one.index, _full(x)[None])[0, 0])
    d = x[system.q[one.index]] - x[system.p[one.index]]
    return float(np.sqrt(d @ d)) if one.kind == "length" else float(np.arctan2(d[1], d[0]))


def rate_of(system: System, one: Coordinate, x: NDArray[np.float64], v: NDArray[np.float64]) -> float:
    """Its rate, m/s or rad/s, at x and v (n, dim)."""
    if one.kind == "node":
        return float(v[one.index // 3, one.index % 3])
    if one.kind == "sum":
        return float(measured(system, one.index, _full(x)[None], _full(v)[None])[0, 1])
    d, dv = (y[system.q[one.index]] - y[system.p[one.index]] for y in (x, v))
    if one.kind == "length":
        return float(d @ dv / np.sqrt(d @ d))
    return float((d[0] * dv[1] - d[1] * dv[0]) / (d @ d))


def push(system: System, one: Coordinate, x: NDArray[np.float64], value: float, out: NDArray[np.float64]) -> None:
    """Add the nodal forces of a force (N) or torque (N m) on a coordinate."""
    if one.kind == "node":
        out[one.index // 3, one.index % 3] += value
        return
    if one.kind == "sum":
        out += value * measure_gradients(system, one.index, _full(x)[None])[0].reshape(-1, 3)[:, : out.shape[1]]
        return
    p, q = system.p[one.index], system.q[one.index]
    # gradient of the length, d/L, or of the angle, d turned by 90 degrees over L^2
    d = x[q] - x[p]
    if one.kind == "length":
        force = value / np.sqrt(d @ d) * d
    else:
        force = value / (d @ d) * np.array([-d[1], d[0]])
    out[q] += force
    out[p] -= force
