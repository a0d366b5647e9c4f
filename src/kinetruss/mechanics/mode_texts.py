"""Mechanisms and states of self-stress in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display import counted
from kinetruss.errors import few
from kinetruss.mechanics.system import System
from kinetruss.model.beam_frames import owner_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Owner


ALIKE = 1e-9
"""Sizes that differ by less than this fraction of the largest count as equal."""

STILL = 1e-6
"""A mode in which the user's nodes move by less than this fraction of the inner ones is a rotation."""

SHOWN = 4, 6
"""Largest number of nodes or rows in a text."""


def ranked(sizes: NDArray[np.float64], least: float = 0.0) -> list[int]:
    """Indices of sizes above `least` times the largest, largest first; equal ones in their own order.

    A size counts as equal to the first of a group if it is within `ALIKE` of it: the order of two equal numbers must not
    depend on the processor.
    """
    top = float(sizes.max(initial=0.0))
    order = np.argsort(-sizes, kind="stable")
    order = order[sizes[order] > least * top].tolist()
    found: list[int] = []
    run: list[int] = []
    for i in order:
        if run and sizes[run[0]] - sizes[i] > ALIKE * top:
            found += sorted(run)
            run = []
        run.append(i)
    return found + sorted(run)


def moves_text(system: System, mode: NDArray[np.float64]) -> str:
    """A mode (n, dim) in words: which node moves in which direction, largest first; where none does, what turns.

    Nodes that the model adds itself are not named: the frame of a node turns with it, and that of a beam with the beam.
    """
    inner = system.inner.nodes
    own = np.array([name not in inner for name in system.nodes], bool)
    size = np.linalg.norm(mode, axis=1)
    moved = np.where(own, size, 0.0)
    if moved.max(initial=0.0) <= STILL * size.max(initial=0.0):
        return _turns(system, mode)
    order, most = ranked(moved, 1e-6), SHOWN[0]
    if inner:  # the largest component of the user's nodes is +1
        every = mode[own].reshape(-1)
        mode = mode / every[int(np.argmax(np.abs(every) >= (1 - ALIKE) * np.abs(every).max()))]
    shown = [f"{system.nodes[i]} moves along {_direction(mode[i])}" for i in order[:most]]
    return ", ".join(shown) + (f" and {counted(len(order) - most, 'more node')}" if len(order) > most else "")


def _turns(system: System, mode: NDArray[np.float64]) -> str:
    """The nodes, beams and hubs whose inner nodes turn, about which axis; all others stand still."""
    inner = system.inner.nodes
    found: dict[Owner, list[int]] = {}
    for name, owner in inner.items():
        found.setdefault(owner, []).append(system.node_index(name))
    turned: dict[Owner, NDArray[np.float64]] = {}
    for owner, nodes in found.items():
        arm = system.x0[nodes] - system.x0[system.node_index(owner.at)]
        moved = np.zeros((len(nodes), 3))
        moved[:, : mode.shape[1]] = mode[nodes] - mode[system.node_index(owner.at)]
        # moved = omega x arm, by least squares
        cross = np.cross(np.eye(3)[None], arm[:, None]).transpose(0, 2, 1).reshape(-1, 3)
        turned[owner] = np.asarray(np.linalg.lstsq(cross, moved.reshape(-1), rcond=1e-9)[0], float)
    sizes = np.array([float(np.linalg.norm(one)) for one in turned.values()])
    names, most = list(turned), SHOWN[0]
    order = ranked(sizes, 1e-6)
    if not order:
        return "only inner nodes move"
    way = turned[names[order[0]]]
    about = "" if system.dim == 2 else f" about {_direction(way / sizes[order[0]])}"
    parts = list(dict.fromkeys(names[i].text for i in order))
    verb = "turns" if len(parts) == 1 else "turn"
    return f"{few(parts, most)} {verb}{about}"


def self_stress_text(system: System, state: NDArray[np.float64], names: tuple[str, ...]) -> str:
    """A state of self-stress (rows,) in words: which bars are in compression or tension, largest force first; then the beams,
    bodies and hubs that take part. names (rows,) : of the rows.
    """
    inner = {**system.inner.bars, **system.inner.couplings}
    count = len(system.row_names)
    own = np.array([k < count and name not in inner for k, name in enumerate(names)], bool)
    order, most = ranked(np.where(own, np.abs(state), 0.0), 1e-6), SHOWN[1]
    largest = float(np.abs(state[own]).max(initial=0.0)) or 1.0
    shown = [f"{names[i]} {_shown(state[i] / largest)}" for i in order]
    taking = [k for k in np.flatnonzero(np.abs(state) > 1e-6 * np.abs(state).max(initial=0.0)) if not own[k]]
    beams = {name: owner_of(name, beam).text for name, beam in system.model.beams.items()}
    shown += dict.fromkeys(inner[names[k]].text if k < count else beams.get(names[k], names[k]) for k in taking)
    return few(shown, most)


def _direction(vector: NDArray[np.float64]) -> str:
    size = float(np.linalg.norm(vector))
    for axis, name in enumerate("xyz"[: len(vector)]):
        if abs(abs(vector[axis]) - size) < ALIKE * size:
            return f"{name} ({_shown(vector[axis])})"
    return "(" + ", ".join(_shown(value) for value in vector) + ")"


def _shown(value: float) -> str:
    """Three decimals, after rounding to nine: so neither -0.0000001 nor a half shows round-off."""
    return f"{round(round(float(value), 9), 3) + 0.0:+.3f}"
