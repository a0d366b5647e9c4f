"""Which parts of a model a number acts on: the nodes near it, by the names that records have of each other.

Numbers of which no part is near both act on different rows of the equations, so that one evaluation gives the differences by
all of them: the numbers of one colour (Curtis, Powell & Reid, IMA J. Appl. Math. 13 (1974) 117).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics import System, cached
from kinetruss.model import Model
from kinetruss.model.record import Record
from kinetruss.model.references import names_in

if TYPE_CHECKING:
    from numpy.typing import NDArray

Entry = tuple[str, str]
Near = frozenset[int] | None

STILL = ("runs", "missions", "conditions", "combinations", "load_cases", "deflections", "gauges", "trajectories", "poses")
"""Tables whose entries join no parts with each other."""


class Parts:
    """The entries of the tables of a model and the nodes to which each is attached."""

    def __init__(self, model: Model) -> None:
        self.index = {name: i for i, name in enumerate(model.nodes)}
        self.named: dict[Entry, list[Entry]] = {}
        for table in type(model).model_fields:
            own = getattr(model, table)
            if table in STILL or not isinstance(own, Mapping):
                continue
            for name, record in own.items():
                refs = names_in(record) if isinstance(record, Record) else ()
                self.named[table, name] = [
                    (home, one) for ref, one, _ in refs for home in ref.tables if one in (getattr(model, home, None) or ())
                ]
                if table in ("fixed", "clamped", "supports", "hubs"):
                    self.named[table, name].append(("nodes", name))
        self.by: dict[Entry, list[Entry]] = {}
        for entry, named in self.named.items():
            for one in named:
                self.by.setdefault(one, []).append(entry)
        self._nodes: dict[Entry, frozenset[int]] = {}
        self._around: dict[Entry, frozenset[int]] = {}

    def nodes(self, entry: Entry) -> frozenset[int]:
        """The nodes of an entry, and of what it names."""
        if entry not in self._nodes:
            self._nodes[entry] = frozenset()  # names may go round
            table, name = entry
            own = {self.index[name]} if table == "nodes" else set[int]()
            self._nodes[entry] = frozenset(own.union(*(self.nodes(one) for one in self.named.get(entry, ()))))
        return self._nodes[entry]

    def around(self, entry: Entry) -> frozenset[int]:
        """These, and those of all that name it; of what has no nodes those of all that name these."""
        if entry not in self._around:
            self._around[entry] = frozenset()
            found = set(self.nodes(entry))
            for one in self.by.get(entry, ()):
                found |= self.nodes(one) or self.around(one)
            self._around[entry] = frozenset(found)
        return self._around[entry]


def near_nodes(parts: Parts, keys: Sequence[Sequence[Sequence[str | int]]]) -> list[Near]:
    """For each number, by its keys in the data of the model, the nodes near it; None: it may act everywhere."""
    found: list[Near] = []
    for group in keys:
        own: set[int] | None = set()
        for path in group:
            entry = (str(path[0]), str(path[1])) if len(path) > 1 else ("", "")
            near = parts.around(entry) if entry in parts.named else frozenset()
            own = None if own is None or not near or len(near) > len(parts.index) // 2 else own | near
        found.append(None if own is None else frozenset(own))
    return found


def colours(near: Sequence[Near], count: int) -> list[list[int]]:
    """Groups of numbers of which no two are near one node; each that acts everywhere is alone. count : of nodes."""
    used, found, alone = [0] * count, list[list[int]](), list[list[int]]()
    for k, nodes in enumerate(near):
        if nodes is None:
            alone.append([k])
            continue
        taken = 0
        for node in nodes:
            taken |= used[node]
        colour = (~taken & (taken + 1)).bit_length() - 1  # the lowest that is free
        for node in nodes:
            used[node] |= 1 << colour
        found.extend([] for _ in range(colour + 1 - len(found)))
        found[colour].append(k)
    return found + alone


@cached()
def sites(system: System) -> dict[str, NDArray[np.int64]]:
    """A node of the user for what a system has: ``node`` (n,) of all nodes, ``member``, ``measure``; -1 unknown.

    An inner node is at the node, or at an end of the part, to which it belongs.
    """
    parts, model = parts_of(system), system.given
    inner = system.inner
    node = np.full(len(system.nodes), -1)
    for i, name in enumerate(system.nodes):
        if name in parts.index:
            node[i] = parts.index[name]
        elif (owner := inner.nodes.get(name)) is not None:
            own = parts.nodes((owner.table, owner.name))
            at = owner.at if owner.at in parts.index else owner.name
            node[i] = parts.index[at] if at in parts.index else min(own, default=-1)
    member = node[system.p]
    measure = np.full(len(system.measures), -1)
    tables = [one for one in type(model).model_fields if isinstance(getattr(model, one), Mapping)]
    for k, name in enumerate(system.measures):
        owner = inner.couplings.get(name) or inner.elements.get(name)
        entries: list[Entry] = [(table, name) for table in tables] if owner is None else [(owner.table, owner.name)]
        measure[k] = next((min(own) for one in entries if one in parts.named and (own := parts.nodes(one))), -1)
    return {"node": node, "member": member, "measure": measure}


@cached()
def parts_of(system: System) -> Parts:
    """The parts of the model of a system."""
    return Parts(system.given)


def site_of_rows(system: System) -> NDArray[np.int64]:
    """A node for each row of prescribed lengths, angles and sums."""
    at: dict[str, Any] = sites(system)
    rows = at["member"][system.row_member] if len(system.members) else np.full(len(system.row_member), -1)
    on = system.row_measure >= 0
    rows = rows.copy()
    rows[on] = at["measure"][system.row_measure[on]]
    # sums that keep a beam in its shape are along its chord; those of coordinates have no member (0)
    shape = on & (rows < 0) & (system.row_member > 0)
    rows[shape] = at["member"][system.row_member[shape]]
    return np.asarray(rows)


def sites_along(system: System, one: Any) -> NDArray[np.int64]:
    """A node for each value of a variable of a result of a system, -1 where none is known, in its shape."""
    at = sites(system)
    found = np.full(one.shape, -1)
    for k, dim in enumerate(one.dims):
        names = [str(name) for name in one.coords[dim].values] if dim in one.coords else []
        if dim in ("node", "member") and len(names) == len(at[dim]):
            own = at[dim]
        elif dim in ("support", "held", "frame"):
            origin = system.inner.frames if dim == "frame" else {}
            node = [system.node_index(origin[name].origin if name in origin else name) for name in names]
            own = at["node"][node]
        elif dim in ("coupling", "spring", "stop", "drive"):
            of = dict(zip(system.measures, at["measure"].tolist(), strict=True))
            own = np.array([of.get(name, -1) for name in names], np.int64)
        else:
            continue
        found[...] = own.reshape([-1 if j == k else 1 for j in range(found.ndim)])
    return found
