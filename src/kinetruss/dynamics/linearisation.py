"""Small motions about an equilibrium or any state: A, B, C, D, frequencies, damping, modes, responses."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.dynamics.bearing_friction import refuse_bearings
from kinetruss.dynamics.linear_state import (
    Input,
    Names,
    Output,
    State,
    compliant,
    drive_forces,
    inputs_of,
    outputs_of,
    state_at,
)
from kinetruss.dynamics.reduction import Reduced, reduced, signal_rows
from kinetruss.errors import InputError
from kinetruss.mechanics.coordinates import Basis, dof_basis
from kinetruss.model import Model, nearest
from kinetruss.results import Column, Result, provenance, variable
from kinetruss.results.user_parts import part_axes
from kinetruss.results.wide_tables import force_units
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.mechanics import System


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


# Small motions about an equilibrium or any state: A, B, C, D, frequencies, damping, modes.

NONE = 1e-13
"""Squares of frequencies below this fraction of the largest count as zero."""

MASSLESS = 1e-13
"""Eigenvalues of the reduced mass with unit diagonal below this fraction of the largest count as zero."""


@one_thread
def linearise(
    model: Model,
    state: Any = None,
    *,
    inputs: Names = (),
    outputs: Names | None = None,
    dofs: str | Iterable[str] | None = None,
    free: Iterable[str] = (),
    rigid: str | Iterable[str] = (),
    load_case: str | None = None,
    tasks: Mapping[str, Any] | None = None,
    time: float | None = None,
) -> Linearisation:
    """Linear equations of small motions, with the geometric stiffness of all bars, rigid ones included.

    Parameters
    ----------
    state : an Equilibrium; positions (n_nodes, dim) m; a pair (positions, velocities); a Motion or Simulation,
        at `time`, s; by default the model's own configuration at rest.
    inputs : names. Of a free node coordinate (``"B.x"``), of an elastic member or a released drive (``"M7"``,
        ``"crank.angle"``): a force on it, N, positive where it lengthens, or a torque, N m. Of a support or another prescribed
        coordinate (``"N1.z"``, a driven length): its motion, with three columns in B: value, rate (``'``), second rate
        (``''``). Of a held drive with a compliance: its commanded length, m, one column. A mapping gives labels, also to sums:
        ``{"base": {"N1.z": 1, "N2.z": 1, "N3.z": 1}}``.
    outputs : likewise; coordinates, with ``'`` for the rate and ``''`` for the second rate; ``"M7.force"`` tension of a member,
        ``"N1.z.force"`` force of a support on the structure. By default the degrees of freedom.
    dofs : names of node coordinates, lengths and angles, mixed; drives among them are released, with the constant force that
        holds the state. None chooses node coordinates.
    free : names of further drives that are released likewise.
    rigid : active members whose `Compliance` does not count. Other held drives with a compliance are springs in series, 1/k the
        sum of the flexibilities of screw, nut, tube and base at the length of the state; the commanded length is then the
        drive's, and holds the state.
    load_case, tasks : as in `statics.equilibrium`; those of an Equilibrium are taken from it.

    Returns
    -------
    Linearisation: A, B, C, D; reduced mass, damping and stiffness; frequencies, poles, damping ratios, mode shapes; its
    methods give frequency responses and transmissibilities. Small motions about a state that is no equilibrium are about the
    motion through it, at that instant; the message says so.

    Raises
    ------
    InputError : unknown names; dofs that are too many, too few, held or dependent; a freedom without mass; velocities that
        the structure does not allow.

    Notes
    -----
    T^T M T q'' + T^T C T q' + T^T K T q = T^T f with K = -df/dx + sum of N d2L/dx2 over all bars (null-space method; Schwab &
    Meijaard, SPACAR; Shabana, Dynamics of Multibody Systems, 2020); about a moving state with the changes of T as well.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (0, -2.0)}, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), mass=1.0)},
    ...                gravity=(0, -9.81))
    >>> found = kt.dynamics.linearise(rod, dofs="b.angle")
    >>> round(found.angular_frequency.item() ** 2, 12) == round(1.5 * 9.81 / 2, 12)
    True
    """
    refuse_bearings(model, "A linearisation")
    here = compliant(state_at(model, state, load_case, tasks, time), dofs, free, rigid)
    at = dof_basis(here.balance.system, dofs, here.x, free)
    signals = inputs_of(at.system, inputs, here.springs)
    wanted = outputs_of(at.system, [one.name for one in at.dofs] if outputs is None else outputs)
    found = reduced(here, at, signals)
    _check_mass(at, found.M[:, : len(at.dofs)])
    data = _dataset(at, here, found, signals, wanted)
    return Linearisation(
        data=data,
        message=_message(here),
        provenance=provenance(model, load_case=here.balance.name),
        basis=at,
        inputs=tuple(signals),
        outputs=tuple(wanted),
        velocity=here.v,
    )


def _check_mass(at: Basis, M: NDArray[np.float64]) -> None:
    """Refuse degrees of freedom without mass."""
    size = np.sqrt(np.abs(np.diag(M)))
    scaled = M / np.outer(np.where(size > 0, size, 1.0), np.where(size > 0, size, 1.0))
    values, vectors = np.linalg.eigh(0.5 * (scaled + scaled.T))
    if values[0] <= MASSLESS * values[-1] or values[-1] <= 0:
        named = at.dofs[int(np.abs(vectors[:, 0]).argmax())].name
        raise InputError(
            f"{named!r} can move without moving any mass, so it has no equation of motion. Give its node or a bar there a "
            "mass, or hold it."
        )


def _state_space(
    at: Basis, found: Reduced, signals: list[Input], state: State, wanted: list[Output]
) -> tuple[NDArray[np.float64], ...]:
    """A, B, C, D; columns of motions are value, rate, second rate."""
    k, count = len(at.dofs), found.M.shape[1]
    Mi = np.linalg.inv(found.M[:, :k])
    # q'' = S c + R c' + Q s'' + P f
    S, R, Q, P = -Mi @ found.K, -Mi @ found.C, -Mi @ found.M[:, k:], Mi @ found.F
    A = np.block([[np.zeros((k, k)), np.eye(k)], [S[:, :k], R[:, :k]]])
    Y0, Y1, Y2, Yf = signal_rows(state, at, found, wanted)
    C = np.hstack([Y0[:, :k] + Y2[:, :k] @ S[:, :k], Y1[:, :k] + Y2[:, :k] @ R[:, :k]])
    B, D = [], []
    forces, motions = iter(range(found.F.shape[1])), iter(range(k, count))
    for one in signals:
        if one.kind != "motion":
            j = next(forces)
            B.append(P[:, j])
            D.append(Yf[:, j] + Y2[:, :k] @ P[:, j])
            continue
        j = next(motions)
        for by, own in ((S[:, j], Y0[:, j]), (R[:, j], Y1[:, j]), (Q[:, j - k], Y2[:, j])):
            B.append(by)
            D.append(own + Y2[:, :k] @ by)
    lower = np.array(B).T if B else np.zeros((k, 0))
    return A, np.vstack([np.zeros_like(lower), lower]), C, np.array(D).T if D else np.zeros((len(wanted), 0))


def _dataset(at: Basis, state: State, found: Reduced, signals: list[Input], wanted: list[Output]) -> xr.Dataset:
    k, system = len(at.dofs), at.system
    force, named = force_units(system, "drive")
    A, B, C, D = _state_space(at, found, signals, state, wanted)
    names = [one.name for one in at.dofs]
    columns = [column for one in signals for column in one.columns]
    M, damping, K = (part[:, :k] for part in (found.M, found.C, found.K))
    data = {
        "A": variable(("state", "by_state"), A, "of the states", "state matrix"),
        "B": variable(("state", "input"), B, "of the states per input", "input matrix"),
        "C": variable(("output", "state"), C, "of the outputs per state", "output matrix"),
        "D": variable(("output", "input"), D, "of the outputs per input", "feedthrough matrix"),
        "mass": variable(("dof", "by_dof"), M, "kg m^2/dof_unit^2", "reduced mass matrix"),
        "damping": variable(("dof", "by_dof"), damping, "N m s/dof_unit^2", "reduced damping matrix"),
        "stiffness": variable(("dof", "by_dof"), K, "N m/dof_unit^2", "reduced stiffness matrix"),
        "transfer": variable(
            ("node", "axis", "dof"), found.X[0][:, :k].reshape(-1, 3, k)[:, : system.dim], "m per dof_unit", "F'"
        ),
        "member_force": variable(("member",), found.tension, "N", "mean axial force in the state, tension positive"),
        "drive_force": variable(("drive",), drive_forces(state), force["drive"], "drive force or torque in the state"),
        "position": variable(("node", "axis"), state.x[:, : system.dim], "m", "node position in the state"),
        **_modes(M, damping, K, found.X[0][:, :k], system, state.still),
        **_poles(A, k),
    }
    units = [one.unit for one in at.dofs]
    coords = {
        "state": [*names, *(f"{name}'" for name in names)],
        "by_state": [*names, *(f"{name}'" for name in names)],
        "dof": names,
        "by_dof": names,
        "dof_unit": ("dof", units),
        "input": [name for name, _ in columns],
        "input_unit": ("input", [unit for _, unit in columns]),
        "output": [one.label for one in wanted],
        "output_unit": ("output", [one.unit for one in wanted]),
        **part_axes(system),
        "drive": list(system.drives),
        **named,
    }
    attrs = {"kind": "linearisation", "load_case": state.balance.name, "at_rest": int(state.still), "left": state.left}
    return xr.Dataset(data, coords=coords, attrs=attrs)


def _modes(
    M: NDArray[np.float64], C: NDArray[np.float64], K: NDArray[np.float64], T: NDArray[np.float64], system: System, still: bool
) -> dict[str, Column]:
    """Undamped modes of K - w^2 M, slowest first. still : about an equilibrium."""
    from scipy.linalg import eigh

    squares, vectors = eigh(0.5 * (K + K.T), 0.5 * (M + M.T))
    # the square of the frequency of a mode without stiffness is round-off
    squares = np.where(np.abs(squares) <= NONE * np.abs(squares).max(), 0.0, squares)
    w = np.where(squares >= 0, np.sqrt(np.abs(squares)), np.nan)
    shapes = (T @ vectors).T.reshape(len(w), -1, 3)[:, :, : system.dim]
    largest = np.abs(shapes).max(axis=(1, 2))
    modal = np.einsum("ik,ij,jk->k", vectors, C, vectors)
    ratio = np.divide(modal, 2 * w, out=np.full_like(w, np.nan), where=w > 0)
    words = (
        f"undamped natural frequency{'' if still else ' about a state that is no equilibrium'}; NaN where the mode runs away"
    )
    return {
        "angular_frequency": variable(("mode",), w, "rad/s", words),
        "frequency": variable(("mode",), w / (2 * np.pi), "Hz", words),
        "frequency_squared": variable(("mode",), squares, "rad^2/s^2", "square of the frequency, negative where unstable"),
        "modal_damping": variable(("mode",), ratio, "", "damping ratio of the mode by itself"),
        "modal_mass": variable(("mode",), largest**-2.0, "kg", "mass that moves with the largest component"),
        "mode_shape": variable(("mode", "node", "axis"), shapes / largest[:, None, None], "", "largest component 1"),
        "mode_dofs": variable(("mode", "dof"), vectors.T / largest[:, None], "dof_unit per m", "the same in the dofs"),
    }


def _poles(A: NDArray[np.float64], k: int) -> dict[str, Column]:
    """Eigenvalues of A, slowest first."""
    if np.any(A[k:, k:]):
        poles = np.linalg.eigvals(A)
    else:
        # q'' = S q: half the size, and plus and minus alike
        squares = np.linalg.eigvals(A[k:, :k]).astype(complex)
        poles = np.concatenate([np.sqrt(squares), -np.sqrt(squares)])
    poles = poles[np.lexsort((poles.imag, np.round(np.abs(poles), 12)))]
    size = np.abs(poles)
    ratio = np.divide(-poles.real, size, out=np.full_like(size, np.nan), where=size > 0)
    return {
        "pole_real": variable(("pole",), poles.real, "1/s", "real part of the pole"),
        "pole_imag": variable(("pole",), poles.imag, "rad/s", "imaginary part of the pole"),
        "pole_damping": variable(("pole",), ratio, "", "damping ratio of the pole"),
    }


def _message(state: State) -> str:
    if state.still:
        return ""
    if np.any(state.v) or not state.left:
        return "About a moving state: the matrices hold at this instant."
    return (
        f"The state is no equilibrium (largest force left: {state.left:.3g} of the largest force): the matrices hold at this "
        f"instant of the motion that starts there. statics.equilibrium finds a state at rest.{_unloaded(state)}"
    )


def _unloaded(state: State) -> str:
    """What is missing of beams that their loads have not deformed."""
    continua = state.balance.system.continua
    if continua is None or continua.beams is None:
        return ""
    return (
        " Beams and links, which are elastic here, carry no load in it: without that equilibrium the stiffness that their "
        "tension gives, of a pendulum all of it, is missing."
    )
