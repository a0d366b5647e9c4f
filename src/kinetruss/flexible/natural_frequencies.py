"""Natural frequencies of the elastic structure along a motion, each mode followed from sample to sample."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.flexible.structure import Softness, instants_of, modes_of, refuse_unloaded_beams
from kinetruss.mechanics import System, compile
from kinetruss.model import Model
from kinetruss.results import Forces, Result, provenance, variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Frequencies", "frequencies"]

MORE = 4
"""Modes above the wanted ones that are computed as well, so that a mode is found again after others have crossed it."""

UNSURE = 0.5
"""Below this correlation with the sample before, a mode is not followed with certainty."""


class Frequencies(Result):
    """Natural frequencies and modes along a motion."""


@one_thread
def frequencies(
    model: Model,
    forces: Forces,
    modes: int = 6,
    *,
    stiffness: Mapping[str, float] | None = None,
    rigid: Collection[str] = (),
) -> Frequencies:
    """Lowest natural frequencies of the structure with elastic members and locked actuators, at every sample of a motion.

    Parameters
    ----------
    forces : from `dynamics.inverse` or `statics.at_poses` of the same model: its samples, and the tensions that stiffen.
    modes : number of modes, the lowest of the first sample; they keep their places when frequencies cross.
    stiffness : member -> N/m, in place of E A/l: of an actuator with its screw and nut, for example. rigid : members kept
        inextensible. Members without section or material are inextensible too.

    Returns
    -------
    Frequencies. ``frequency`` (time, mode) Hz; ``mode_shape`` (time, mode, node, axis), largest component 1, with the sign of
    the sample before; ``modal_mass`` (time, mode) kg, of that component; ``mac`` (time, mode): correlation of the mode with
    that of the sample before, weighed by the masses, 1 at the first; ``actuator_share`` (time, mode, drive): share of the
    strain energy of the mode in a driven member. The message names the first sample at which a mode is not followed with
    certainty.

    Raises
    ------
    InputError : forces of another model; a structure that is not stiff, or has no elastic member; unknown members;
        positions in which beams do not carry their loads (see docs/beams.md).

    Notes
    -----
    (K - w^2 M) phi = 0 with K of the bars' elasticity, and of their tension along the motion (geometric stiffness). Modes of
    neighbouring samples are matched by the largest sum of MAC = (phi1^T M phi2)^2/((phi1^T M phi1)(phi2^T M phi2)) (Allemang &
    Brown, IMAC 1982). Damping and gyroscopic terms do not enter.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
    ...     bars={"rod": kt.Bar(ends=("O", "A"), mass=0)},
    ... )
    >>> found = kt.flexible.frequencies(model, kt.runs.forces_at_rest(model), modes=1, stiffness={"rod": 2.0 * 100.0**2})
    >>> found.frequency.values.round(4).tolist()  # Hz: sqrt(k/m)/(2 pi), 100 rad/s
    [[15.9155]]
    """
    if isinstance(modes, bool) or not isinstance(modes, int) or modes < 1:
        raise InputError(f"modes is {modes!r}. Give a whole number from 1.")
    system = compile(model)
    refuse_unloaded_beams(model, forces)
    driven = np.flatnonzero((system.row_drive >= 0) & (system.row_kind == 0))
    w2, shapes, mac, share = [], [], [], []
    last: NDArray[np.float64] | None = None
    for here in instants_of(model, forces, Softness(stiffness=stiffness or {}, rigid=rigid)):
        squares, found, M, K = modes_of(here, modes + MORE)
        order, likeness = np.arange(min(modes, len(squares))), np.ones(min(modes, len(squares)))
        if last is not None:
            order, likeness = _matched(last, found, M)
        kept = found[:, order]
        if last is not None:
            kept = kept * np.where(np.einsum("nk,nm,mk->k", last, M, kept) < 0, -1.0, 1.0)
        last = kept
        w2.append(squares[order])
        shapes.append(kept)
        mac.append(likeness)
        share.append(_shares(here.G[driven] @ kept, here.f[driven], np.einsum("nk,nm,mk->k", kept, K, kept)))
    return _record(system, forces, np.array(w2), np.array(shapes), np.array(mac), np.array(share), driven)


def _matched(
    last: NDArray[np.float64], found: NDArray[np.float64], M: NDArray[np.float64]
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Which of the modes found continue the last ones, and their correlation."""
    from scipy.optimize import linear_sum_assignment

    size = np.einsum("nk,nm,mk->k", last, M, last)
    likeness = (last.T @ M @ found) ** 2 / size[:, None]
    rows, columns = linear_sum_assignment(-likeness)
    return columns, likeness[rows, columns]


def _shares(e: NDArray[np.float64], f: NDArray[np.float64], whole: NDArray[np.float64]) -> NDArray[np.float64]:
    """Share of twice the strain energy (modes, driven) from elongations e (driven, modes)."""
    k = np.divide(1.0, f, out=np.zeros_like(f), where=f > 0)
    return (k[:, None] * e**2 / whole).T


def _record(
    system: System,
    forces: Forces,
    w2: NDArray[np.float64],
    shapes: NDArray[np.float64],
    mac: NDArray[np.float64],
    share: NDArray[np.float64],
    driven: NDArray[np.int64],
) -> Frequencies:
    times, modes = w2.shape
    full = np.zeros((times, modes, system.x0.size))
    full[:, :, system.free] = np.swapaxes(shapes, 1, 2)
    largest = np.abs(full).max(axis=2)
    nodes = (full / largest[:, :, None]).reshape(times, modes, -1, 3)[..., : system.dim]
    per = ("time", "mode")
    data = {
        "frequency": variable(per, np.sqrt(w2) / (2 * np.pi), "Hz", "natural frequency"),
        "mode_shape": variable((*per, "node", "axis"), nodes, "", "mode, largest component 1"),
        "modal_mass": variable(per, largest**-2.0, "kg", "mass that moves with the largest component"),
        "mac": variable(per, mac, "", "correlation with the mode of the sample before"),
        "actuator_share": variable((*per, "drive"), share, "", "share of the strain energy in a driven member"),
    }
    coords = {name: forces.whole.coords[name] for name in ("time", "pose", "node", "axis") if name in forces.whole.coords}
    own = {"mode": np.arange(1, modes + 1), "drive": [system.drives[d] for d in system.row_drive[driven]]}
    frame = xr.Dataset(data, coords=own, attrs={"kind": "frequencies", "load_case": forces.load_case}).assign_coords(coords)
    at = np.flatnonzero(mac.min(axis=1) < UNSURE)
    said = (
        f"Mode {int(mac[at[0]].argmin()) + 1} is not followed with certainty at sample {at[0]} (MAC {mac[at[0]].min():.2f}). "
        "Take more samples, or more modes."
        if len(at)
        else ""
    )
    return Frequencies(
        data=frame,
        status=forces.status,
        message=" ".join(text for text in (forces.message, said) if text),
        provenance=provenance(system.given, load_case=forces.load_case),
    )
