"""What a drawing is worth: the model, its closed pose, mobility in words, forces; nodes that only look joined."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import ValidationError

from kinetruss import statics
from kinetruss.display import quantity
from kinetruss.errors import Fault, KinetrussError, ModelError
from kinetruss.mechanics import arrange, compile
from kinetruss.mechanics.elements import has_elements
from kinetruss.mechanics.mobility import beam_deformations, mobility_at
from kinetruss.mechanics.numbers import compile_moved
from kinetruss.mechanics.positions import drive_values, row_values
from kinetruss.model import LengthDrive, Model, Node, of_file
from kinetruss.statics.search import projected, row_errors
from kinetruss.studio.edits import SOFT
from kinetruss.studio.poses import CLOSED, EXACT, LARGEST, MANY, at_rest, strength_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.mechanics.mobility import Mobility
    from kinetruss.results import Forces


NEAR = 1e-6
"""Distance of a node from a bar, as a fraction of the size of the drawing, below which it lies on it."""

MOST_PAIRS = 200_000
"""Largest number of pairs of a node and a member that are looked at."""

LISTED_NODES = 4
"""Largest number of sentences."""


def loose_ends(
    places: Mapping[str, Sequence[float]], members: Mapping[str, Sequence[str]], slides: Collection[str] = ()
) -> list[str]:
    """Sentences about nodes that lie on members, or on other nodes, without being joined to them.

    places : node -> place, m. members : name -> its two ends, or the nodes of a link. slides : nodes that may lie on members.

    >>> places = {"A": [0, 0], "B": [2, 0], "C": [1, 0], "D": [1, 1]}
    >>> loose_ends(places, {"b1": ["A", "B"], "b2": ["C", "D"]})
    ['C lies on b1 but is not joined to it. To join them, make b1 a link through C; two bars would fold there.']
    """
    if not places or len(places) * max(1, len(members)) > MOST_PAIRS:
        return []
    names, x = list(places), np.array(list(places.values()), float)
    near = NEAR * (float(np.ptp(x, axis=0).max()) or 1.0)
    same: dict[bytes, list[str]] = {}
    for name, place in zip(names, np.round(x / near), strict=True):
        same.setdefault((place + 0.0).tobytes(), []).append(name)
    found = [f"{' and '.join(some)} are at the same place but are not joined." for some in same.values() if len(some) > 1]
    for node, name in (one for one in on_members(places, members) if one[0] not in slides):
        mend = f"To join them, make {name} a link through {node}; two bars would fold there."
        found.append(f"{node} lies on {name} but is not joined to it. {mend}")
    rest = len(found) - LISTED_NODES
    return found[:LISTED_NODES] + ([f"{rest} more places where parts meet without being joined."] if rest > 0 else [])


def on_members(places: Mapping[str, Sequence[float]], members: Mapping[str, Sequence[str]]) -> list[tuple[str, str]]:
    """Nodes that lie on members without being joined to them, each with the member; arguments as of `loose_ends`."""
    if not places or len(places) * max(1, len(members)) > MOST_PAIRS:
        return []
    names, x = list(places), np.array(list(places.values()), float)
    near = NEAR * (float(np.ptp(x, axis=0).max()) or 1.0)
    index = {name: k for k, name in enumerate(names)}
    pairs = [(name, index[a], index[b]) for name, nodes in members.items() for a, b in pairwise(nodes)]
    labels, ends = [name for name, *_ in pairs], np.array([pair for _, *pair in pairs], int).reshape(-1, 2)
    start, along = x[ends[:, 0]], x[ends[:, 1]] - x[ends[:, 0]]
    square = (along**2).sum(axis=1)
    long = np.flatnonzero(square > near**2)
    start, along, size = start[long], along[long], square[long] ** 0.5
    apart = x - start[:, None]
    way = np.einsum("mnk,mk->mn", apart, along) / size[:, None]
    off = np.linalg.norm(apart - (way / size[:, None])[..., None] * along[:, None], axis=2)
    inside = (off < near) & (way > near) & (size[:, None] - way > near)
    found = [(names[node], labels[long[member]]) for member, node in np.argwhere(inside).tolist()]
    return [(node, name) for node, name in found if node not in members[name]]


# What a drawing is worth: the model, its closed pose, mobility in words, forces; or what is missing.

LISTED = 6
"""Largest number of mechanisms and of states of self-stress in words."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Judged:
    """A drawing and what is known of it.

    model : None if the data have faults. position : (n_nodes, dim), m, the drawn or closed pose. moved : nodes that
    closing has moved. apart : lengths that do not fit, name -> (drawn, given), m. mobility, forces : None if they were
    not computed; `why` says why there are no forces. warnings : kind and text. used : utilisation of the members whose strength
    was checked.
    """

    faults: list[Fault] = field(default_factory=list)
    model: Model | None = None
    position: NDArray[np.float64] | None = None
    moved: dict[str, list[float]] = field(default_factory=dict)
    apart: dict[str, tuple[float, float]] = field(default_factory=dict)
    drives: dict[str, float] = field(default_factory=dict)
    mobility: Mobility | None = None
    forces: Forces | None = None
    why: str = ""
    warnings: list[tuple[str, str]] = field(default_factory=list)
    alarms: list[str] = field(default_factory=list)
    used: dict[str, float] = field(default_factory=dict)


def judged(data: Mapping[str, Any], fine: bool = True, last: Judged | None = None) -> Judged:
    """Everything that a page shows of the data of a model.

    Parameters
    ----------
    fine : also what is slow. last : what was found of the data before a move of nodes; its records are taken over.
    """
    try:
        model = _model(data, last)
    except ModelError as error:
        if not data.get("nodes") and all(fault.path == ("nodes",) for fault in error.faults):
            return Judged(why="Nothing is drawn yet.")  # the start of every drawing, not a fault
        return Judged(faults=error.faults, why="The model has faults: see the list.")
    except KinetrussError as error:
        return Judged(faults=[Fault((), str(error), "")], why="The model has faults: see the list.")
    if not model.nodes:
        return Judged(model=model, why="Nothing is drawn yet.")
    system = compile(model)
    x, apart = _closed(system)
    position = x[:, : system.dim].copy()
    drives = _drives(system, x)
    if apart:
        worst = max(apart, key=lambda name: abs(apart[name][0] - apart[name][1]))
        drawn, given = apart[worst]
        why = f"The lengths do not close: {worst} is drawn {drawn:.6g} m long and given as {given:.6g} m."
        return Judged(model=model, position=position, apart=apart, drives=drives, why=why, warnings=[("open", why)])
    moved = {
        name: [float(value) for value in place]
        for name, place, drawn in zip(model.nodes, position, system.x0[:, : system.dim], strict=False)
        if not np.array_equal(place, drawn)
    }
    if len(model.members) > LARGEST and not fine:
        why = "Forces and mobility of this many members follow when the pointer rests."
        return Judged(model=model, position=position, moved=moved, drives=drives, why=why)
    mobility = mobility_at(system, x, beam_deformations)
    forces, why = _forces(model, system, position, mobility, fine)
    warnings = _warnings(system, mobility)
    checked = forces is not None and (fine or len(model.members) <= MANY)
    alarms, used = strength_of(model, forces) if checked and forces is not None else ([], {})
    return Judged(
        model=model, position=position, moved=moved, drives=drives, mobility=mobility, forces=forces, why=why,
        warnings=warnings, alarms=alarms, used=used,
    )  # fmt: skip


def _model(data: Mapping[str, Any], last: Judged | None) -> Model:
    """The model of the data; after a move of nodes all other records are those of before."""
    if last is not None and last.model is not None:
        nodes = _moved(data["nodes"], last.model)
        if nodes is None:
            return last.model.with_(nodes=data["nodes"])
        model = last.model.moved(nodes)
        compile_moved(model, last.model)
        return model
    with of_file():
        return Model(**data) if data.get("nodes") else Model(**{**data, "nodes": {}})


def _moved(entries: Mapping[str, Any], model: Model) -> dict[str, Node] | None:
    """The nodes of a model at the places of their entries; None if more than places differ, or some are faulty."""
    nodes: dict[str, Node] = dict(model.nodes)
    if list(entries) != list(nodes):
        return None
    for name, entry in entries.items():
        node = nodes[name]
        if isinstance(entry, list) and tuple(entry) == node.at and node.model_fields_set == {"at"}:
            continue
        try:
            own = Node.model_validate(entry)
        except ValidationError:
            return None
        if vars(own) | {"at": node.at} != vars(node):
            return None
        nodes[name] = own
    return nodes


def _closed(system: System) -> tuple[NDArray[np.float64], dict[str, tuple[float, float]]]:
    """Positions (n, 3) nearest to those drawn with all given lengths, and the lengths that cannot be satisfied."""
    x = system.x0
    if not len(system.row_member):
        return x, {}
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = system.drive_start[system.row_drive[driven]]
    size = float(np.ptp(x, axis=0).max()) or 1.0
    if np.abs(row_errors(system, x, wanted)).max() <= EXACT * size:
        return x, {}
    found, worst = projected(system, x, wanted, size) if len(system.free) else (x, np.inf)
    if worst <= CLOSED * size and np.isfinite(found).all():
        return found, {}
    drawn = row_values(system, x)
    errors = np.abs(row_errors(system, x, wanted))
    return x, {system.row_name(r): (float(drawn[r]), float(wanted[r])) for r in np.flatnonzero(errors > CLOSED * size).tolist()}


def _drives(system: System, x: NDArray[np.float64]) -> dict[str, float]:
    if not system.drives:
        return {}
    now = drive_values(system, x[None], 0 * x[None], 0 * x[None])[0][0]
    return dict(zip(system.drives, map(float, now), strict=True))


def _forces(
    model: Model, system: System, position: NDArray[np.float64], mobility: Mobility, fine: bool
) -> tuple[Forces | None, str]:
    """Forces at rest, or why there are none."""
    soft = bool(model.bending) or has_elements(system) or any(bar.kind in SOFT for bar in model.bars.values())
    try:
        if not mobility.undriven and arrange(system).plan is not None:
            return at_rest(model, position), ""
        if not soft and not (model.fixed or model.clamped or model.supports):
            return None, "No forces yet: nothing holds the drawing."
        if not soft:
            count = f"{mobility.undriven} mechanism{'s are' if mobility.undriven > 1 else ' is'} left"
            return None, f"No forces yet: {count}. Add a bar, a support or a drive for each."
        if not fine and len(model.members) > MANY:
            return None, "Forces of elastic members follow when the pointer rests."
        rest = statics.equilibrium(model, position)
        found = np.array(rest.whole["position"].values)
        size = float(np.ptp(position, axis=0).max()) or 1.0
        sag = float(np.abs(found - position).max())
        away = quantity(sag, "m")
        if not rest.stable and not (model.fixed or model.clamped or model.supports):
            return None, "No forces yet: nothing holds the drawing."
        if not rest.stable or sag > 0.2 * size:
            return None, f"No forces: the nearest equilibrium is {f'{away} away' if rest.stable else 'unstable'}."
        return at_rest(model, found), f"Forces are those of the equilibrium, up to {away} from the drawing."
    except KinetrussError as error:
        return None, f"No forces: {error}"


def _warnings(system: System, mobility: Mobility) -> list[tuple[str, str]]:
    """Mechanisms, redundancy and drives that act against the bars, in the words of `kinematics.mobility`."""
    found: list[tuple[str, str]] = []
    if mobility.undriven:
        texts = mobility.mechanism_texts(LISTED)
        found += [("mechanism", f"Mechanism {k + 1}: {text}") for k, text in enumerate(texts)]
        if mobility.undriven > LISTED:
            found.append(("mechanism", f"{mobility.undriven - LISTED} more mechanisms."))
    if mobility.self_stress:
        states = mobility.self_stress_states[:, : len(system.row_drive)]
        names = [system.drives[d] for d in sorted({int(d) for d in system.row_drive if d >= 0})
                 if np.abs(states[:, system.row_drive == d]).max() > 1e-9]  # fmt: skip
        if len(names) == 1:
            text = f"{_drive_text(system, names[0])} acts against the bars: they prescribe it already. Remove it, or a bar."
            found.append(("drive", text))
        elif names:
            them = f"{', '.join(names[:LISTED])}{' and more' if len(names) > LISTED else ''}"
            found.append(("drive", f"The drives {them} act against the bars or each other. Remove one of them, or a bar."))
        texts = mobility.self_stress_texts(LISTED)
        found += [("redundant", f"Self-stress {k + 1}: {text}") for k, text in enumerate(texts)]
        if mobility.self_stress > LISTED:
            found.append(("redundant", f"{mobility.self_stress - LISTED} more states of self-stress."))
    return found


def _drive_text(system: System, name: str) -> str:
    drive = system.model.all_drives[name]
    return f"The driven length of {name}" if isinstance(drive, LengthDrive) else f"The drive {name}"
