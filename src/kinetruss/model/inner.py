"""The inner parts of a model: nodes, bars, bodies and couplings that represent beams, bodies and hubs, and whose they are."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, NamedTuple

if TYPE_CHECKING:
    from kinetruss.model.beam_checks import Spin
    from kinetruss.model.beam_frames import Axes, Hinge
    from kinetruss.model.hub_arms import Arm
    from kinetruss.model.hub_expansion import Pivot
    from kinetruss.model.supports import Holding


WORDS = {"beams": "beam", "links": "link", "bodies": "body", "hubs": "hub", "supports": "support"}


class Owner(NamedTuple):
    """To what an inner part belongs: the table of the model (``nodes``, ``beams``, ``links``, ``bodies``, ``hubs``,
    ``supports``), the name there, and the node at which it is (empty for bars).
    """

    table: Literal["nodes", "beams", "links", "bodies", "hubs", "supports"]
    name: str
    at: str = ""

    @property
    def text(self) -> str:
        """The user's part in words; the frame of a node carries its rotation."""
        return f"rotation of {self.name}" if self.table == "nodes" else f"{WORDS[self.table]} {self.name}"


@dataclass(frozen=True, kw_only=True)
class Inner:
    """Inner parts by name, each with its owner, and what they were made for; all other parts are the user's.

    nodes : of frames and of axes of hinges, tips of the arms of hubs, apexes. bars : chords of beams, braces, bars of hinges,
    arms of hubs. bodies : of hubs and of hinged members. couplings : of rotations of beams, of hinges, of supports.
    elements : springs and stops of supports. frames, hinges, spins : of beams and links; tips : by frame of a link the node
    towards which its direction counts. arms : of each hub. pivots : the hinges of hubs.
    twice : supports whose node the user also fixed or clamped, with the table. holdings : what holds the directions of
    supports. arms_of_supports : nodes of a frame along the axes of a turned support.
    """

    nodes: dict[str, Owner] = field(default_factory=dict)
    bars: dict[str, Owner] = field(default_factory=dict)
    bodies: dict[str, Owner] = field(default_factory=dict)
    couplings: dict[str, Owner] = field(default_factory=dict)
    elements: dict[str, Owner] = field(default_factory=dict)
    frames: dict[str, Axes] = field(default_factory=dict)
    hinges: list[Hinge] = field(default_factory=list)
    spins: list[Spin] = field(default_factory=list)
    tips: dict[str, str] = field(default_factory=dict)
    arms: dict[str, list[Arm]] = field(default_factory=dict)
    pivots: list[Pivot] = field(default_factory=list)
    twice: dict[str, str] = field(default_factory=dict)
    holdings: list[Holding] = field(default_factory=list)
    arms_of_supports: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def part_of(self, name: str) -> str:
        """The user's part to which a bar, coupling or body belongs: itself, or of an inner one its owner in words."""
        owner = self.bars.get(name) or self.couplings.get(name) or self.bodies.get(name) or self.elements.get(name)
        return name if owner is None else owner.text
