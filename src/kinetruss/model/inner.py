"""The inner parts of a model: nodes, bars, bodies and couplings that it adds itself to represent beams, bodies and hubs."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, NamedTuple

from kinetruss.model.beam_frames import SHAPE, frames, hinges
from kinetruss.model.bracing import CHORD
from kinetruss.model.hub_arms import arms_of
from kinetruss.model.hub_expansion import pivots_of

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData


WORDS = {"beams": "beam", "bodies": "body", "hubs": "hub"}


class Owner(NamedTuple):
    """To what an inner part belongs: the table of the model (``nodes``, ``beams``, ``bodies``, ``hubs``), the name there, and
    the node at which it is (empty for bars).
    """

    table: Literal["nodes", "beams", "bodies", "hubs"]
    name: str
    at: str = ""

    @property
    def text(self) -> str:
        """The user's part in words; the frame of a node carries its rotation."""
        return f"rotation of {self.name}" if self.table == "nodes" else f"{WORDS[self.table]} {self.name}"


@dataclass(frozen=True, kw_only=True)
class Inner:
    """Inner parts by name, each with its owner; all other parts are the user's.

    nodes : of frames and of axes of hinges, tips of the arms of hubs, apexes. bars : chords of beams, braces, bars of hinges,
    arms of hubs. bodies : of hubs and of hinged members. couplings : of rotations of beams, of hinges.
    """

    nodes: dict[str, Owner] = field(default_factory=dict)
    bars: dict[str, Owner] = field(default_factory=dict)
    bodies: dict[str, Owner] = field(default_factory=dict)
    couplings: dict[str, Owner] = field(default_factory=dict)


def inner_parts(model: ModelData) -> Inner:
    """Which nodes, bars, bodies and couplings of a model are inner ones. Also of a model that was written out and read again.

    >>> import kinetruss as kt
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], material="steel_s235",
    ...                  section=kt.Rod(diameter=0.01), beams={"arm": ("A", "B")})
    >>> found = inner_parts(model)
    >>> [name for name in model.nodes if name not in found.nodes], found.nodes["B.d1"].at, "arm.chord" in found.bars
    (['A', 'B'], 'B', True)
    """
    found = Inner()
    _of_beams(model, found)
    _of_hubs(model, found)
    for name, node in model.nodes.items():
        if node.director:  # also one whose beam is at fault
            found.nodes.setdefault(name, Owner("nodes", name, name))
    for name, bar in model.bars.items():
        if bar.brace:
            whole = name.removesuffix(f".{bar.ends[0]}-{bar.ends[1]}")
            owner = found.bodies.get(whole) or (Owner("bodies", whole) if whole in model.bodies else _owner(found, bar.ends))
            found.bars.setdefault(name, owner._replace(at=""))
    return found


def _owner(found: Inner, ends: tuple[str, str]) -> Owner:
    """Of the bar between two nodes that of one of them."""
    return next((found.nodes[end] for end in ends if end in found.nodes), Owner("nodes", ends[0]))


def _of_beams(model: ModelData, found: Inner) -> None:
    ends = {f"{name}.{end}": Owner("beams", name, end) for name, beam in model.beams.items() for end in beam.ends}
    for name, frame in frames(model).items():
        owner = Owner("nodes", name, name) if name == frame.origin else ends[name]
        found.nodes.update((node, owner) for node in frame.nodes if node in model.nodes)
    found.nodes.update((hinge.node, ends[hinge.own]) for hinge in hinges(model) if hinge.node in model.nodes)
    found.couplings.update((name, Owner("beams", one.beam)) for name, one in model.couplings.items() if one.beam is not None)
    for name in model.bars:
        beam = name.removesuffix(CHORD) if name.endswith(CHORD) else name.partition(SHAPE)[0]
        if beam != name and beam in model.beams:
            found.bars[name] = Owner("beams", beam)


def _of_hubs(model: ModelData, found: Inner) -> None:
    for hub in model.hubs:
        for arm in arms_of(model, hub):
            if model.members[arm.member].ends[arm.end] == arm.name:
                found.nodes[arm.name], found.bars[arm.name] = Owner("hubs", hub, hub), Owner("hubs", hub)
    for pivot in pivots_of(model) if model.hubs else ():
        owner = Owner("hubs", pivot.hub, pivot.hub)
        found.nodes.update((node, owner) for node in pivot.nodes if node in model.nodes)
        found.bars.update((bar, owner._replace(at="")) for bar in pivot.bars if bar in model.bars)
        found.bodies.update({pivot.body: owner} if pivot.body in model.bodies else {})
        found.couplings.update({pivot.coupling: owner} if pivot.coupling in model.couplings else {})
    found.bodies.update((f"{hub}.hub", Owner("hubs", hub, hub)) for hub in model.hubs if f"{hub}.hub" in model.bodies)
    for name, owner in found.bodies.items():
        found.nodes.update((node, owner) for node in model.bodies[name].nodes if node.startswith(f"{name}.apex"))
