"""The whole of a model: the tables of the user, and behind them the inner parts that represent beams, links, bodies, hubs."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

from kinetruss.model.beam_checks import Spin, add_spins
from kinetruss.model.beam_frames import Axes, Hinge, add_chords, add_frames, rigid_groups
from kinetruss.model.body_checks import body_faults
from kinetruss.model.bracing import braces
from kinetruss.model.checks import dimension
from kinetruss.model.data import ModelData
from kinetruss.model.hub_arms import Arm, arms_of
from kinetruss.model.hub_expansion import Pivot, add_hubs
from kinetruss.model.hubs import missing_nodes
from kinetruss.model.inner import Owner
from kinetruss.model.links import add_tips, pieces
from kinetruss.model.members import Brace
from kinetruss.model.references import unknown_names
from kinetruss.model.supports import Holding, add_fixed, add_supports
from kinetruss.model.table import ReadOnly

if TYPE_CHECKING:
    from kinetruss.model.members import Active, Bar


GROWING = (
    "nodes",
    "fixed",
    "clamped",
    "bars",
    "active",
    "beams",
    "bodies",
    "support_motion",
    "couplings",
    "springs",
    "stops",
)
"""Tables to which inner parts are added; in them members of hubs end at the tips of arms."""


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


class WholeModel(ModelData):
    """A model with its inner parts (`inner`), which stand behind those of the user in every table.

    Analyses compute with it; it is made by `expanded`.

    >>> import kinetruss as kt
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], material="steel_s235",
    ...                  section=kt.Rod(diameter=0.01), beams={"arm": ("A", "B")})
    >>> list(model.nodes), list(model.whole.nodes)
    (['A', 'B'], ['A', 'B', 'A.d1', 'A.d2', 'B.d1', 'B.d2'])
    >>> model.whole.inner.nodes["B.d1"].text, model.whole.inner.bars["arm.chord"].text
    ('rotation of B', 'beam arm')
    """

    @cached_property
    def inner(self) -> Inner:
        """The inner parts, with their owners."""
        return Inner()

    @cached_property
    def members(self) -> dict[str, Bar | Active]:
        """All members by name: bars, then active members of the user, then inner bars. Results keep this order."""
        inner = self.inner.bars
        own = {name: bar for name, bar in self.bars.items() if name not in inner}
        return ReadOnly({**own, **self.active, **{name: self.bars[name] for name in inner}})

    @cached_property
    def real_members(self) -> dict[str, Bar | Active]:
        """The first of them: those of the user, and arms of hubs; the others stand for no part that bears its forces alone."""
        return ReadOnly({name: one for name, one in self.members.items() if not isinstance(one, Brace)})

    @classmethod
    def growing(cls, model: ModelData) -> WholeModel:
        """One that still grows, until it is `sealed`."""
        found = cls.model_construct(None, **vars(model))
        found.__dict__.update({name: dict(getattr(model, name)) for name in GROWING})
        return found

    def sealed(self) -> WholeModel:
        """The same, with tables that do not change any more."""
        self.__dict__.update({name: ReadOnly(self.__dict__[name]) for name in GROWING})
        for derived in ("driven_members", "force_elements"):  # meanwhile
            self.__dict__.pop(derived, None)
        return self


def expanded(model: ModelData) -> WholeModel:
    """The whole of a model. Beams, bodies and hubs that are at fault get no inner parts, or too few.

    First hubs get their arms and bodies, then links their beams, and all beams their frames, on which supports act; last the
    bars that all rigid ones still need.
    """
    whole = WholeModel.growing(model)
    whole.inner.arms.update({hub: arms_of(model, hub) for hub in model.hubs if hub in model.nodes})
    if model.hubs and missing_nodes(model):
        return whole.sealed()
    if model.hubs:
        add_hubs(model, whole)
    if model.supports:
        add_fixed(whole)
    if model.links:
        whole.beams.update(pieces(model))
    if whole.beams:
        add_frames(whole)
        add_tips(whole)
    if model.supports:
        add_supports(whole)
    if whole.beams:
        add_spins(whole)
    if whole.bodies or whole.beams:
        _add_braces(whole)
        add_chords(whole)
    return whole.sealed()


def _add_braces(whole: WholeModel) -> None:
    """The missing bars of rigid bodies and beams, and of frames."""
    inner = whole.inner
    for group, bars in braces(whole, rigid_groups(whole), _faulty_bodies(whole)).items():
        owner = inner.bodies.get(group) or (Owner("bodies", group) if group in whole.bodies else None)
        for name, bar in bars.items():
            of_ends = (inner.nodes[end] for end in bar.ends if end in inner.nodes)
            whole.bars[name] = bar
            inner.bars[name] = (owner or next(of_ends, Owner("nodes", bar.ends[0])))._replace(at="")


def _faulty_bodies(whole: WholeModel) -> set[str]:
    """Bodies that cannot be braced as given."""
    dim = dimension(len(node.at) for node in whole.nodes.values())
    unknown = unknown_names(whole, whole.bodies, ("bodies",), (ModelData, "bodies"))
    return {str(fault.path[1]) for fault in (*unknown, *body_faults(whole, dim))}
