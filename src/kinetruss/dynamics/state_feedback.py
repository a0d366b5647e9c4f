"""State feedback on a linearised structure: given gains, pole placement or least cost; what its inputs do not reach."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import Shape, array_of
from kinetruss.dynamics.closed_loop import Feedback, zero_order_hold
from kinetruss.dynamics.linearisation import Linearisation, chosen
from kinetruss.errors import InputError
from kinetruss.mechanics.arguments import number_of
from kinetruss.model import nearest
from kinetruss.results import variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]


TOLERANCE = 1e-11
"""Of the smallest singular value of [A - p 1, B], and of the decay -Re p, relative to the norm of the balanced A."""


def not_reached(A: Floats, B: Floats) -> tuple[Floats, NDArray[np.complex128]]:
    """Motions of z' = A z + B u that no input changes and that do not decay.

    Returns W (states, k), orthonormal columns with W'B = 0 and W'A = (W'A W) W', and their k poles. A pole p is not
    reached where a row w' has w'A = p w' and w'B = 0: [A - p 1, B] loses rank (Hautus, 1969). What remains across the rows
    found is searched again, for chains of equal poles. Units do not count: A is balanced, the columns of B have its norm.
    """
    from scipy.linalg import matrix_balance, qr

    balanced, (scale, _) = matrix_balance(A, permute=False, separate=True)
    inputs = B / scale[:, None]
    size = float(np.linalg.norm(balanced, 2))
    inputs = inputs * (size / np.maximum(np.linalg.norm(inputs, axis=0), np.finfo(float).tiny))
    basis, rest = np.zeros((len(A), 0)), np.eye(len(A))
    while rest.shape[1]:
        rows = _rows_of(rest.T @ balanced @ rest, rest.T @ inputs, TOLERANCE * size)
        if not rows.shape[1]:
            break
        basis = np.linalg.qr(np.hstack([basis, rest @ rows]))[0]
        rest = qr(basis)[0][:, basis.shape[1] :]
    W = np.linalg.qr(basis / scale[:, None])[0]
    return W, np.linalg.eigvals(W.T @ A @ W)


def _rows_of(A: Floats, B: Floats, least: float) -> Floats:
    """Orthonormal columns w with w'A = p w' and w'B = 0 of poles p that do not decay; a complex row gives two of them."""
    found = []
    for pole in np.linalg.eigvals(A):
        if pole.real >= -least and pole.imag >= -least:
            both = np.hstack([A - pole * np.eye(len(A)), B])
            if np.linalg.svd(both, compute_uv=False)[-1] > least:
                continue
            left, size, _ = np.linalg.svd(both)
            rows = left[:, size <= least].conj()
            found += [rows.real] if abs(pole.imag) <= least else [rows.real, rows.imag]
    if not found:
        return np.zeros((len(A), 0))
    left, size, _ = np.linalg.svd(np.hstack(found), full_matrices=False)
    return left[:, size > np.sqrt(np.finfo(float).eps)]


# State feedback on a linearised structure: given gains, pole placement or least cost; continuous or sampled.

Cost = float | Mapping[str, float]


@one_thread
def feedback(
    lin: Linearisation,
    *,
    inputs: str | Iterable[str] | None = None,
    gains: ArrayLike | Mapping[str, Mapping[str, float]] | None = None,
    poles: Iterable[complex] | None = None,
    state_cost: Cost | ArrayLike | None = None,
    input_cost: Cost | ArrayLike = 1.0,
    period: float | None = None,
) -> Feedback:
    """Forces u = -G z that act against the state z = (q, q') of a linearised structure.

    Parameters
    ----------
    inputs : labels of the force inputs that act; by default all force inputs. The state consists of the degrees of freedom of
        the linearisation (node coordinates, lengths, angles) and their rates: choose them there.
    gains : G (inputs, states), or a mapping input -> state -> gain (``{"M7": {"M7": 2e3, "M7'": 90.0}}``, the rest 0).
    poles : wanted poles of the closed loop, 1/s, one for each state, complex ones in pairs (of a sampled loop as well: z =
        e^(s T)).
    state_cost, input_cost : least cost of z^T Q z + u^T R u: numbers for all, mappings of states or outputs (inputs) to
        weights, or matrices.
    period : s between samples; the forces are constant in between (zero-order hold). None feeds back continuously.

    Returns
    -------
    Feedback: ``gains``, closed-loop poles, responses, and `user_force` for `dynamics.simulate`.

    Raises
    ------
    InputError : not exactly one of gains, poles and state_cost; unknown names; wrong shapes; poles that cannot be placed; a
        structure whose unstable motions the inputs do not reach.

    Notes
    -----
    An undamped motion that no input reaches stays as it is; the cost is then that of all other motions, and `message` says so.
    Poles: Kautsky, Nichols & Van Dooren (1985), `scipy.signal.place_poles`. Least cost: the algebraic Riccati equation; of a
    sampled loop the discrete one, with the same cost over all time, forces standing still in between (Van Loan, IEEE Trans.
    Automatic Control 23 (1978) 395-404). Zero-order hold: the exact exponential of A over a period.

    >>> import kinetruss as kt
    >>> mass = kt.Model(nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}}, fixed={"A": "xy", "B": "y"},
    ...                 bars={"s": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=8.0)})
    >>> lin = kt.dynamics.linearise(mass, inputs="B.x", dofs="B.x")
    >>> kt.dynamics.feedback(lin, poles=[-3, -4]).gains.values.round(9).tolist()
    [[16.0, 14.0]]
    """
    forces = [one.label for one in lin.inputs if one.kind == "force"]
    acting = chosen(inputs, forces, "force input")
    if not acting:
        raise InputError("The linearisation has no force input. Name force inputs in linearise(..., inputs=...).")
    if sum(given is not None for given in (gains, poles, state_cost)) != 1:
        raise InputError("Give one of gains, poles and state_cost.")
    if period is not None and not (np.isfinite(period) and period > 0):
        raise InputError(f"period is {period} s. Give a positive time, or None for continuous feedback.")
    A, B = lin.data["A"].values, lin.data["B"].sel(input=acting).values
    left, stay = not_reached(A, B) if state_cost is not None else (np.zeros((len(A), 0)), np.zeros(0, np.complex128))
    cheapest = None if state_cost is None else _cheapest(lin, acting, (A, B, left), state_cost, input_cost, period)
    if period is not None:
        A, B = zero_order_hold(A, B, period)
    if cheapest is not None:
        G = cheapest
    elif gains is not None:
        G = _given(lin, acting, gains)
    else:
        G = _placed(A, B, poles or (), period)
    return _record(lin, acting, G, A - B @ G, period, stay)


def _given(lin: Linearisation, acting: list[str], gains: Any) -> NDArray[np.float64]:
    """Gains as a matrix."""
    states = [str(name) for name in lin.data["state"].values]
    if not isinstance(gains, Mapping):
        rows: list[Shape] = [{"inputs": acting, "states": states}]
        if len(acting) == 1:
            rows.append({"states": states})
        return np.atleast_2d(array_of(gains, "gains", *rows))
    found = np.zeros((len(acting), len(states)))
    for name, row in gains.items():
        i = acting.index(chosen(name, acting, "force input")[0])
        for state, value in row.items():
            j = states.index(chosen(state, states, "state")[0])
            found[i, j] = number_of(value, f"gains[{name!r}][{state!r}]", "N or N m per unit of the state")
    return found


def _placed(
    A: NDArray[np.float64], B: NDArray[np.float64], poles: Iterable[complex], period: float | None
) -> NDArray[np.float64]:
    from scipy.signal import place_poles

    wanted = np.array([complex(pole) for pole in poles])
    if len(wanted) != len(A):
        raise InputError(f"{len(wanted)} poles are given, but the structure has {len(A)} states. Give one for each state.")
    wanted = wanted if period is None else np.exp(wanted * period)
    if not np.any(wanted.imag):
        wanted = wanted.real
    try:
        found = place_poles(A, B, wanted)
    except ValueError as error:
        raise InputError(f"The poles cannot be placed: {error}") from None
    reached = np.linalg.eigvals(A - B @ found.gain_matrix)
    off = max(float(np.abs(reached - pole).min()) for pole in wanted)
    if off > 1e-3 * max(1e-300, float(np.abs(wanted).max())):
        raise InputError("The poles cannot be placed: the inputs do not reach all motions. Add inputs, or give gains.")
    return np.asarray(found.gain_matrix.real)


def _cheapest(
    lin: Linearisation,
    acting: list[str],
    system: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
    state_cost: Any,
    input_cost: Any,
    period: float | None,
) -> NDArray[np.float64]:
    """Gains of least cost of the system A, B, less the motions W that no input reaches and that do not decay.

    With z = W y + V x, where y' = W'A W y is not reached, u = -G V'z is of least cost for x' = V'A V x + V'B u.
    """
    from scipy.linalg import null_space, solve_continuous_are, solve_discrete_are

    Q = _state_cost(lin, state_cost)
    R = _input_cost(acting, input_cost)
    A, B, W = system
    poles, least = np.linalg.eigvals(W.T @ A @ W), np.sqrt(np.finfo(float).eps) * np.abs(np.linalg.eigvals(A)).max(initial=0)
    if ((poles.real > least) | (np.abs(poles.imag) <= least)).any():  # W grows or moves away freely
        raise _no_feedback()
    V = null_space(W.T) if W.shape[1] else np.eye(len(A))
    A, B, Q = V.T @ A @ V, V.T @ B, V.T @ Q @ V
    try:
        if period is None:
            return np.asarray(np.linalg.solve(R, B.T @ solve_continuous_are(A, B, Q, R)) @ V.T)
        Ad, Bd = zero_order_hold(A, B, period)
        Qd, Nd, Rd = _held_cost(A, B, Q, R, period)
        P = solve_discrete_are(Ad, Bd, Qd, Rd, s=Nd)
        return np.asarray(np.linalg.solve(Rd + Bd.T @ P @ Bd, Bd.T @ P @ Ad + Nd.T) @ V.T)
    except (np.linalg.LinAlgError, ValueError):
        raise _no_feedback() from None


def _no_feedback() -> InputError:
    return InputError(
        "No feedback of least cost exists: the inputs do not reach an unstable or free motion, or an undamped motion has no "
        "cost. Add inputs, or give every state a cost."
    )


def _held_cost(
    A: NDArray[np.float64], B: NDArray[np.float64], Q: NDArray[np.float64], R: NDArray[np.float64], period: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Cost over a period as a quadratic form of its first state and its force: state part, mixed part, force part."""
    from scipy.linalg import block_diag, expm

    n, m = B.shape
    both = np.block([[A, B], [np.zeros((m, n + m))]])
    size = n + m
    grown = expm(period * np.block([[-both.T, block_diag(Q, R)], [np.zeros((size, size)), both]]))
    cost = grown[size:, size:].T @ grown[:size, size:]
    cost = 0.5 * (cost + cost.T)
    return cost[:n, :n], cost[:n, n:], cost[n:, n:]


def _state_cost(lin: Linearisation, cost: Any) -> NDArray[np.float64]:
    """Q (states, states) from a number, weights of states or outputs, or a matrix."""
    states = [str(name) for name in lin.data["state"].values]
    outputs = [str(name) for name in lin.data["output"].values]
    if not isinstance(cost, Mapping):
        return _square(cost, len(states), "state_cost")
    Q = np.zeros((len(states), len(states)))
    for name, weight in cost.items():
        if name in states:
            row = np.eye(len(states))[states.index(name)]
        elif name in outputs:
            row = lin.data["C"].values[outputs.index(name)]
        else:
            raise InputError(f"No state or output called {name!r}. {nearest(name, [*states, *outputs])}".rstrip())
        Q += weight * np.outer(row, row)
    return Q


def _input_cost(acting: list[str], cost: Any) -> NDArray[np.float64]:
    if isinstance(cost, Mapping):
        for name in cost:
            chosen(name, acting, "force input")
        cost = np.diag([cost.get(name, 1.0) for name in acting])
    R = _square(cost, len(acting), "input_cost")
    if np.linalg.eigvalsh(0.5 * (R + R.T))[0] <= 0:
        raise InputError("input_cost must be positive: a force without cost would be unbounded.")
    return R


def _square(cost: Any, size: int, name: str) -> NDArray[np.float64]:
    given = array_of(cost, name, {}, {"weights": size}, {"rows": size, "columns": size})
    return given * np.eye(size) if given.ndim == 0 else np.diag(given) if given.ndim == 1 else given


def _record(
    lin: Linearisation,
    acting: list[str],
    G: NDArray[np.float64],
    closed: NDArray[np.float64],
    period: float | None,
    stay: NDArray[np.complex128],
) -> Feedback:
    roots = np.linalg.eigvals(closed)
    with np.errstate(divide="ignore"):
        poles = roots if period is None else np.log(roots.astype(complex)) / period
    order = np.lexsort((poles.imag, np.round(np.abs(poles), 9)))
    poles, roots = poles[order], roots[order].astype(complex)
    size = np.abs(poles)
    ratio = np.divide(-poles.real, size, out=np.full_like(size, np.nan), where=size > 0)
    data = {
        "gains": variable(("input", "state"), G, "N or N m per unit of the state", "gains, u = -G z"),
        "closed_loop": variable(("state", "by_state"), closed, "of the states", "closed-loop matrix; over a period if sampled"),
        "pole_real": variable(("pole",), poles.real.copy(), "1/s", "real part of the pole"),
        "pole_imag": variable(("pole",), poles.imag.copy(), "rad/s", "imaginary part of the pole"),
        "pole_damping": variable(("pole",), ratio, "", "damping ratio of the pole"),
    }
    states = lin.data["state"].values
    coords = {"input": acting, "state": states, "by_state": states}
    attrs = {"kind": "feedback", "period": 0.0 if period is None else float(period)}
    stable = bool(np.all(poles.real < 0))
    message = "" if stable else "The closed loop is not asymptotically stable: a pole is not in the left half-plane."
    if len(stay):
        rates = ", ".join(f"{rate:.4g}" for rate in sorted({round(abs(pole.imag), 9) for pole in stay}))
        message = f"No input reaches the undamped motion of {rates} rad/s: it stays, and the cost is that of all other motions."
    return Feedback(
        data=xr.Dataset(data, coords=coords, attrs=attrs),
        message=message,
        provenance=lin.provenance,
        lin=lin,
        multipliers=None if period is None else np.asarray(roots, np.complex128),
    )
