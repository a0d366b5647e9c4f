"""Active damping: actuators of an elastic structure that yield to their own force, or resist their own rate."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Literal

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.errors import InputError
from kinetruss.flexible.structure import Instant, Softness, instants_of, modes_of, refuse_unloaded_beams
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics import System, compile
from kinetruss.model import Model, nearest
from kinetruss.results import Forces, Result, provenance, variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["ActiveDamping", "active_damping"]

MASSLESS = 1e-10
"""Square of the period of a mode below this fraction of the largest: it has no mass."""


class ActiveDamping(Result):
    """Poles of an elastic structure with collocated feedback in its members, over gains."""


@one_thread
def active_damping(
    model: Model,
    forces: Forces,
    gains: ArrayLike,
    *,
    actuators: str | Iterable[str] | None = None,
    kind: Literal["force", "rate"] = "force",
    sample: int = 0,
    modes: int = 6,
    stiffness: Mapping[str, float] | None = None,
    rigid: Collection[str] = (),
) -> ActiveDamping:
    """Damping that actuators add to an elastic structure by feedback of their own force or rate, over gains.

    Parameters
    ----------
    forces : from `statics.at_poses` or `dynamics.inverse`; the structure is taken at one `sample`, without its own damping.
    gains : one, or several (gains,). actuators : members; by default all driven lengths.
    kind : ``"force"``, integral force feedback: the natural length of each actuator grows at the rate gain T/k, T its dynamic
        tension and k its stiffness; gain in 1/s. ``"rate"``: each resists its elongation e like a damper, with the force
        gain e'; gain in N s/m.
    modes : how many modes are reported; all count. stiffness, rigid : as in `frequencies`.

    Returns
    -------
    ActiveDamping. ``pole_real``, ``pole_imag`` (gain, pole) 1/s: every pole with a frequency once, slowest first; beyond them
    NaN. ``damping`` (gain, pole), the damping ratio. ``frequency`` (mode) Hz without feedback; ``share`` (mode): share of the
    strain energy in the actuators; ``first_order_damping`` (gain, mode), for small gains: gain share/(2 w), or gain sum
    (g . phi)^2/(2 w) with unit modal mass.

    Raises
    ------
    InputError : members that are inextensible or unknown; negative gains; nothing elastic.

    Notes
    -----
    Both feedbacks only take energy from the structure, whatever the gains, if they are collocated. One mode: s (s^2 + w^2) + g
    (s^2 + z^2) = 0, z its frequency with the actuators left out; the largest damping ratio is (w - z)/(2 z), at g = w sqrt(w/z)
    (Preumont, Vibration Control of Active Structures, 2018, chapter 7).

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
    ...     bars={"rod": kt.Bar(ends=("O", "A"), kind="driven", mass=0)},
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.flexible.active_damping(model, forces, gains=[2.0, 20.0], modes=1, stiffness={"rod": 20e3})
    >>> found.damping.values.round(6).tolist()  # all energy is in the actuator: gain/(2 w), w = 100 rad/s
    [[0.01], [0.1]]
    """
    if kind not in ("force", "rate"):
        raise InputError(f"kind is {kind!r}. Give 'force' or 'rate'.")
    at = np.atleast_1d(array_of(gains, "gains", {}, {"gains": None}))
    if np.any(at < 0):
        raise InputError(f"A gain is {at.min():g}. Give 0 or more: a negative gain feeds energy into the structure.")
    count = forces.whole.sizes["time"] if isinstance(forces, Forces) else 1
    if not 0 <= sample < count:
        raise InputError(f"sample is {sample}, but the forces have samples 0 to {count - 1}.")
    system = compile(model)
    refuse_unloaded_beams(model, forces)
    (here,) = islice(instants_of(model, forces, Softness(stiffness=stiffness or {}, rigid=rigid)), sample, sample + 1)
    rows = _rows(system, here, actuators)
    modal = _modal(here, rows)
    poles = [_poles(modal, gain, kind, modes) for gain in at]
    return _record(system, forces, modal, at, kind, np.array(poles), min(modes, len(modal.w)))


def _rows(system: System, here: Instant, names: str | Iterable[str] | None) -> NDArray[np.int64]:
    """Rows of the actuators."""
    lengths = np.flatnonzero(system.row_kind == LENGTH)
    known = [system.members[i] for i in system.row_member[lengths]]
    driven = [system.members[system.row_member[r]] for r in lengths if system.row_drive[r] >= 0]
    given = driven if names is None else [names] if isinstance(names, str) else list(names)
    if not given:
        raise InputError("No length is driven. Name the members that act in actuators.")
    for name in given:
        if name not in known:
            raise InputError(f"{name!r} is no rigid or driven member. {nearest(name, known)}".rstrip())
        if here.f[lengths[known.index(name)]] == 0:
            raise InputError(f"{name!r} is inextensible. Give it a section and a material, or a stiffness.")
    return lengths[[known.index(name) for name in given]]


@dataclass(frozen=True, kw_only=True, eq=False)
class Modal:
    """w (modes,) rad/s; e (actuators, modes) elongations in modes of unit modal mass; k (actuators,) N/m; soft (actuators,
    actuators) m/N: elongations by forces of the actuators through motions without mass.
    """

    w: NDArray[np.float64]
    e: NDArray[np.float64]
    k: NDArray[np.float64]
    soft: NDArray[np.float64]


def _modal(here: Instant, rows: NDArray[np.int64]) -> Modal:
    squares, shapes, _, K = modes_of(here, here.M.shape[0])
    kept = squares < squares[0] / MASSLESS
    e = here.G[rows].toarray() @ shapes
    # motions without mass: the whole compliance less that of the modes
    soft = _compliance(here, K, rows) - (e[:, kept] / squares[kept]) @ e[:, kept].T
    return Modal(w=np.sqrt(squares[kept]), e=e[:, kept], k=1.0 / here.f[rows], soft=soft)


def _compliance(here: Instant, K: NDArray[np.float64], rows: NDArray[np.int64]) -> NDArray[np.float64]:
    """Elongations of the actuators by their own unit forces (actuators, actuators), m/N."""
    hard = here.G.toarray()[here.f == 0]
    g = here.G[rows].toarray().T
    matrix = np.block([[K, hard.T], [hard, np.zeros((len(hard), len(hard)))]])
    found = np.linalg.lstsq(matrix, np.vstack([g, np.zeros((len(hard), len(rows)))]), rcond=None)[0]
    return np.asarray(g.T @ found[: len(K)])


def _poles(modal: Modal, gain: float, kind: str, most: int) -> NDArray[np.complex128]:
    """Poles with a frequency, slowest first (most,), NaN beyond them."""
    n, m = modal.e.shape[1], modal.e.shape[0]
    w2, e, k = modal.w**2, modal.e, modal.k
    if kind == "rate":
        if np.abs(modal.soft).max() > 1e-6 * (1.0 / k).max() and gain:
            raise InputError("The actuators move nodes without mass: the rates there have no equation. Give their bars a mass.")
        A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.diag(w2), -gain * e.T @ e]])
    else:
        # natural lengths d: e_i = modes + soft k d; d' = gain (e - d)
        A = np.block(
            [
                [np.zeros((n, n)), np.eye(n), np.zeros((n, m))],
                [-np.diag(w2), np.zeros((n, n)), e.T * k],
                [gain * e, np.zeros((m, n)), gain * (modal.soft * k - np.eye(m))],
            ]
        )
    roots = np.linalg.eigvals(A)
    roots = roots[roots.imag > 1e-9 * modal.w[0]]
    roots = roots[np.argsort(roots.imag)][:most]
    return np.concatenate([roots, np.full(most - len(roots), complex(np.nan, np.nan))])


def _record(
    system: System,
    forces: Forces,
    modal: Modal,
    gains: NDArray[np.float64],
    kind: str,
    poles: NDArray[np.complex128],
    modes: int,
) -> ActiveDamping:
    w = modal.w[:modes]
    share = (modal.k[:, None] * modal.e[:, :modes] ** 2).sum(axis=0) / w**2
    taken = share if kind == "force" else (modal.e[:, :modes] ** 2).sum(axis=0)
    per = ("gain", "pole")
    data = {
        "pole_real": variable(per, poles.real.copy(), "1/s", "real part of the pole"),
        "pole_imag": variable(per, poles.imag.copy(), "rad/s", "imaginary part of the pole"),
        "damping": variable(per, -poles.real / np.abs(poles), "", "damping ratio"),
        "frequency": variable(("mode",), w / (2 * np.pi), "Hz", "frequency without feedback"),
        "share": variable(("mode",), share, "", "share of the strain energy in the actuators"),
        "first_order_damping": variable(
            ("gain", "mode"), gains[:, None] * taken / (2 * w), "", "damping ratio for small gains"
        ),
    }
    coords = {"gain": gains, "mode": np.arange(1, modes + 1)}
    frame = xr.Dataset(data, coords=coords, attrs={"kind": "active_damping", "feedback": kind})
    return ActiveDamping(data=frame, message="", provenance=provenance(system.given, load_case=forces.load_case))
