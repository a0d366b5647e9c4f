"""Links: one stiff member through two pins or more, straight or bent; the beams between its pins that represent it."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, model_validator

from kinetruss.errors import Fault, ModelError, few, shown
from kinetruss.model.beams import Beam, Vector
from kinetruss.model.inner import Owner
from kinetruss.model.members import Brace, EndCondition, Node
from kinetruss.model.record import Delay, Distance, Flag, Mass, Name, Record, Series, short_form
from kinetruss.model.references import NodeName, matched, names_in
from kinetruss.model.sections import MaterialOrName, SectionOrName
from kinetruss.model.table import ReadOnly, Table
from kinetruss.model.words import nearest

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from kinetruss.model.data import ModelData
    from kinetruss.model.members import Bar
    from kinetruss.model.the_model import Model
    from kinetruss.model.whole import WholeModel


class Link(Record):
    """One member through two pins or more, straight or bent: a boom, a rocker, the leg of a scissor, a bell crank.

    It runs straight from each node to the next and does not fold there. At its nodes it is pinned (in space: by ball joints)
    to all other parts: two links that name one node cross there and turn freely against each other. The start configuration is
    free of stress.

    nodes : names of its pins, in the order in which it runs through them. The first may be named again at the end: a frame.
    kind : ``rigid`` keeps its shape in all motions, simulated ones too; ``elastic`` vibrates in simulations. With section and
        material either bends in statics, and has section forces, stresses and a row in the verdict in every analysis.
    section, material : names or records, by default those of the model; an elastic link needs both. A rigid one without them
        is not checked for strength.
    mass : total, kg; by default density x area x length. It is spread evenly along it, with the rotary inertia of the section.
    hinges : in space, by node the one axis about which it turns against the rotation of the node, which a clamp or a beam
        gives: a local axis of the link there, or a vector in global axes, as of a `Beam`. Other nodes are ball joints.
    weld : of its nodes, those at which it shares the rotation of the node with clamps, with beams and with other links that
        are welded there.
    orientation : of its section in space, as of a `Beam`; a node, or a vector.
    damping : of an elastic link, s, as of a `Beam`.
    buckling : how the ends of a straight one are held for buckling over its whole length, as of a `Bar`; by default
        ``pinned-pinned`` where other parts or supports hold both, ``clamped-free`` where one end is a free tip. Pins between
        them, which shorten what buckles, are left out of account.

    >>> import kinetruss as kt
    >>> crane = kt.Model(nodes={"O": (0, 0), "M": (1, 0), "T": (2, 0), "P": (1, -1)}, fixed=["O", "P"], material="steel_s235",
    ...                  section=kt.Rectangle(width=0.05, height=0.1), links={"boom": ("O", "M", "T")},
    ...                  bars={"ram": kt.Bar(ends=("P", "M"), kind="driven")},
    ...                  loads={"hook": kt.NodalForce(node="T", force=(0, -1e3))})
    >>> along = kt.strength.beams(crane, kt.statics.linear(crane), stations=[0.5])
    >>> along.section_M.sel(beam="boom", moment="3").values.round(6).tolist()
    [-1000.0]
    """

    nodes: Annotated[tuple[NodeName, ...], Field(min_length=2), Series]
    kind: Literal["rigid", "elastic"] = "rigid"
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    mass: Mass | None = None
    weld: Annotated[tuple[Name, ...], Series] = ()
    hinges: Table[Name, Literal[1, 2, 3] | Vector] = ReadOnly()
    orientation: NodeName | Vector | None = None
    damping: Delay = 0.0
    buckling: EndCondition | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_nodes(cls, value: Any) -> Any:
        return short_form(value, "nodes")

    @property
    def ends(self) -> tuple[str, str]:
        """Its first and its last node, or of a closed one the last but one."""
        last = self.nodes[-1] if self.nodes[-1] != self.nodes[0] else self.nodes[-2]
        return self.nodes[0], last


class StiffLink(Link):
    """A link of which only the shape and the mass are asked: without section forces, whatever its section (inner)."""


def with_stiff_links(model: Model) -> Model:
    """The model with links that are rigid parts of it."""
    if not model.links:
        return model
    stiff = {"kind": "rigid", "damping": 0.0}
    return model.with_(links={name: StiffLink(**(dict(one) | stiff)) for name, one in model.links.items()})


def bars_as_links(model: Model, *bars: str, **fields: Any) -> Model:
    """The model with some of its bars as links, which bend: in statics, as elastic ones also in simulations.

    They have the ends, section, material, mass, orientation and buckling of the bar. Beams give them section forces at all
    stations (`strength.beams`), deflections, and loads and pins between their ends.

    Parameters
    ----------
    bars : names or patterns (``*``, ``?``, ``[..]``) of rigid bars. fields : of all these links: `kind`, `damping`, ...

    Raises
    ------
    ModelError : a pattern that no bar has; a bar that is not rigid, or has what links do not have; all faults of the result.

    Examples
    --------
    >>> import kinetruss as kt
    >>> bay = kt.library.vgt.double_octahedral()
    >>> soft = bars_as_links(bay, "M1?", "M6", kind="elastic")
    >>> list(soft.links), soft.links["M6"].nodes
    (['M13', 'M14', 'M15', 'M16', 'M17', 'M18', 'M19', 'M6'], ('N5', 'N2'))
    """
    chosen: dict[str, Bar] = {}
    for pattern in bars:
        names = matched(list(model.bars), pattern)
        if not names:
            raise ModelError([Fault(("bars",), f"none is called {shown(pattern)}.", nearest(pattern, model.bars))])
        chosen |= {name: model.bars[name] for name in names}
    if faults := [fault for name, bar in chosen.items() for fault in _no_link(name, bar)]:
        raise ModelError(faults)
    kept = ("section", "material", "mass", "orientation", "buckling")
    links = {
        name: Link(**{"nodes": bar.ends} | {key: getattr(bar, key) for key in kept if key in bar.model_fields_set} | fields)
        for name, bar in chosen.items()
    }
    return model.with_(bars={name: bar for name, bar in model.bars.items() if name not in chosen}, links=model.links | links)


def _no_link(name: str, bar: Bar) -> Iterator[Fault]:
    """What a bar has and a link has not."""
    path = ("bars", name)
    if bar.kind != "rigid":
        yield Fault((*path, "kind"), f"is {bar.kind}: a link keeps its length.", "Name rigid bars.")
    for field in ("body", "length"):
        if getattr(bar, field) is not None:
            yield Fault((*path, field), "is given, which links do not have.", "Leave the bar as it is, or the field out.")
    if any(bar.friction):
        yield Fault((*path, "friction"), "is given, which links do not have.", "Leave the bar as it is, or the field out.")


class Piece(Beam):
    """The part of a link between two of its pins that follow each other (inner).

    link : its name. own : those of its ends at which it has the rotation of the link, and not that of the node. start : where
    the part begins, m along the link. held : it keeps its shape in simulations.
    """

    link: Name
    own: Annotated[tuple[Name, ...], Series] = ()
    start: Distance = 0.0
    held: Flag = False


TIP = "tip"
"""End of the name of the node towards which the direction of a link counts."""


def _lengths(model: ModelData, link: Link) -> list[float]:
    """Lengths of the parts of a link, m."""
    return [math.dist(model.nodes[a].at, model.nodes[b].at) for a, b in pairwise(link.nodes)]


def is_sound(model: ModelData, link: Link) -> bool:
    """False if its nodes cannot be those of a link: a fault."""
    places = [model.nodes[node].at for node in link.nodes if node in model.nodes and not model.nodes[node].scalar]
    open_nodes = link.nodes[:-1] if link.nodes[0] == link.nodes[-1] else link.nodes
    return (
        len(places) == len(link.nodes)
        and len(set(open_nodes)) == len(open_nodes) >= (2 if open_nodes == link.nodes else 3)
        and all(len(at) == model.dim for at in places)
        and all(length > 0 for length in _lengths(model, link))
    )


def pieces(model: ModelData) -> dict[str, Piece]:
    """The parts of all sound links, by name: ``LINK.A-B``. Of a link without section or material rigid ones."""
    found = {}
    for name, link in model.links.items():
        if not is_sound(model, link):
            continue
        lengths, at, seen = _lengths(model, link), 0.0, set[str]()
        known = bends(model, link)
        for (a, b), length in zip(pairwise(link.nodes), lengths, strict=True):
            found[f"{name}.{a}-{b}"] = Piece.model_construct(
                ends=(a, b),
                kind="elastic" if known else "rigid",
                section=link.section,
                material=link.material,
                mass=None if link.mass is None else link.mass * length / sum(lengths),
                orientation=_orientation(model, link, a, b),
                release=tuple(end for end in (a, b) if end not in link.weld and end not in link.hinges),
                # of both parts at a pin the first has its hinge
                hinges={end: link.hinges[end] for end in (a, b) if end in link.hinges and end not in seen},
                own=tuple(end for end in (a, b) if end not in link.weld),
                damping=link.damping,
                link=name,
                start=at,
                held=link.kind == "rigid",
            )
            at += length
            seen |= {a, b}
    return found


def bends(model: ModelData, one: Beam | Link) -> bool:
    """Whether a beam or link has section forces: an elastic beam, a link with section and material."""
    if isinstance(one, StiffLink):
        return False
    if isinstance(one, Link):
        return _known(model, one, "section") and _known(model, one, "material")
    return one.kind == "elastic"


def length_along(model: ModelData, one: Beam | Link) -> float:
    """Length of a beam or link, m."""
    nodes = one.nodes if isinstance(one, Link) else one.ends
    return sum(math.dist(model.nodes[a].at, model.nodes[b].at) for a, b in pairwise(nodes))


def is_straight(model: ModelData, link: Link) -> bool:
    """Whether the nodes of a link lie on one line, in order."""
    if not is_sound(model, link):
        return False
    return length_along(model, link) <= (1 + LINE) * math.dist(
        *(model.nodes[node].at for node in (link.nodes[0], link.nodes[-1]))
    )


def _known(model: ModelData, link: Link, field: str) -> bool:
    """Whether the section or material of a link is known."""
    chosen = getattr(link, field) if getattr(link, field) is not None else getattr(model, field)
    return chosen is not None and (not isinstance(chosen, str) or chosen in getattr(model, f"{field}s"))


def _orientation(model: ModelData, link: Link, a: str, b: str) -> Any:
    """That of the link, unless it lies along this part of it."""
    given: Any = link.orientation
    if given is None or model.dim != 3:
        return None
    if isinstance(given, str):
        if given not in model.nodes or given in (a, b):
            return None
        given = tuple(v - u for u, v in zip(model.nodes[a].at, model.nodes[given].at, strict=True))
    d = [v - u for u, v in zip(model.nodes[a].at, model.nodes[b].at, strict=True)]
    if len(given) != 3:
        return None
    cross = (d[1] * given[2] - d[2] * given[1], d[2] * given[0] - d[0] * given[2], d[0] * given[1] - d[1] * given[0])
    return link.orientation if math.hypot(*cross) > LINE * math.hypot(*d) * math.hypot(*given) else None


def column_ends(model: Model, name: str) -> str | float:
    """The end condition of a link for buckling: its own, else by what else is at its first and its last node."""
    link = model.links[name]
    if link.buckling is not None:
        return link.buckling
    held = {*model.fixed, *model.clamped, *model.supports}
    tables: tuple[Mapping[str, Record], ...] = (
        model.bars, model.active, model.beams, model.bodies, model.cylinders, model.springs, model.stops, model.drives,
        model.couplings, model.membranes, model.solids, {key: one for key, one in model.links.items() if key != name},
    )  # fmt: skip
    for table in tables:
        held |= {node for record in table.values() for ref, node, _ in names_in(record) if "nodes" in ref.tables}
    return "pinned-pinned" if set(link.ends) <= held else "clamped-free"


LINE = 1e-6
"""Sine of the angle below which a part of a link and its orientation are parallel; and how much longer than the distance of its
ends a straight link may be, as a fraction.
"""


def piece_at(model: Model, name: str, place: float) -> str:
    """The name of the part of a link at a place (m along it)."""
    own = [(key, one.start) for key, one in model.whole.beams.items() if isinstance(one, Piece) and one.link == name]
    return [key for key, start in own if start <= max(place, 0.0)][-1]


def turned_links(model: ModelData) -> list[str]:
    """The links to whose angle something refers: drives, couplings, springs, stops."""
    records = [*model.drives.values(), *model.couplings.values(), *(one for _, one in model.force_elements.values())]
    named = {name for record in records for ref, name, _ in names_in(record) if "links" in ref.tables}
    return [name for name, link in model.links.items() if name in named and is_sound(model, link)]


def add_tips(whole: WholeModel) -> None:
    """Add the direction of each link to whose angle something refers: a bar from its first node to a node of its frame there,
    so that a couple on the angle acts at the first pin.
    """
    for name in turned_links(whole):
        a, b = whole.links[name].ends
        frame = whole.inner.frames.get(frame_at(whole.links[name], name, a))
        if frame is None:
            continue
        p, q = whole.nodes[a].at, whole.nodes[b].at
        reach = 0.6 * frame.size / math.dist(p, q)
        tip = f"{name}.{TIP}"
        whole.nodes[tip] = Node.model_construct(
            at=tuple(u + reach * (v - u) for u, v in zip(p, q, strict=True)), coincident=True
        )
        whole.inner.nodes[tip] = Owner("links", name, a)
        whole.inner.tips[f"{frame_at(whole.links[name], name, a)}"] = tip
        whole.bars[name] = Brace.model_construct(ends=(a, tip), kind="free", mass=0.0)
        whole.inner.bars[name] = Owner("links", name)


def frame_at(link: Link, name: str, node: str) -> str:
    """Name of the frame that carries the rotation of a link at one of its nodes."""
    return node if node in link.weld else f"{name}.{node}"


# Cross-checks.


def link_faults(model: WholeModel, dim: int) -> Iterator[Fault]:
    """Faults of all links of a model with `dim` axes."""
    for name, link in model.links.items():
        path = ("links", name)
        for table in ("bars", "active", "beams", "bodies"):
            if name in getattr(model, table) and not (table == "bars" and name in model.inner.bars):
                what = {"bars": "a bar", "active": "an active member", "beams": "a beam", "bodies": "a body"}[table]
                message = f"{name!r} is also the name of {what}."
                yield Fault(path, message, "Give each its own name.", about=((table, name),))
        yield from _pins(model, link, path)
        yield from _matter(model, link, path, dim)
        for node in link.hinges:
            if node not in link.nodes:
                yield Fault((*path, "hinges", node), f"{node!r} is no node of the link.", f"Name one of {few(link.nodes, 6)}.")
            elif node in link.weld:
                yield Fault(
                    (*path, "hinges", node), f"{node!r} is welded too.", "Name it in one of both.", about=((*path, "weld"),)
                )
        for k, node in enumerate(link.weld):
            if node not in link.nodes:
                yield Fault((*path, "weld", k), f"{node!r} is no node of the link.", f"Name one of {few(link.nodes, 6)}.")
        if link.kind == "rigid" and link.damping:
            yield Fault(
                (*path, "damping"), "is given for a rigid link, which does not vibrate.", "Leave it out, or kind: elastic."
            )
        if link.orientation is not None and dim == 2:
            yield Fault((*path, "orientation"), "is given in a planar model.", "Leave it out: axis 2 lies in the plane.")
    yield from _doubled(model)


def _pins(model: WholeModel, link: Link, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Nodes that cannot be those of one link."""
    place = (*path, "nodes")
    inner = [
        (k, node)
        for k, node in enumerate(link.nodes)
        if node in model.nodes and (model.nodes[node].scalar or node in model.inner.nodes)
    ]
    for k, node in inner:
        yield Fault((*place, k), f"{node!r} is no place that a link can join.", "Name a node.", about=(("nodes", node),))
    if inner or not all(node in model.nodes for node in link.nodes):
        return
    open_nodes = link.nodes[:-1] if link.nodes[0] == link.nodes[-1] else link.nodes
    twice = next((node for k, node in enumerate(open_nodes) if node in open_nodes[:k]), None)
    if twice is not None:
        mend = "Name each pin once, in the order in which the link runs through them."
        if len(link.nodes) > 3:
            closed = ", ".join((*dict.fromkeys(link.nodes), link.nodes[0]))
            mend += f" A closed frame names its first node again at its end: nodes: [{closed}]."
        yield Fault(place, f"names {twice!r} twice.", mend)
        return
    if len(open_nodes) < (2 if open_nodes == link.nodes else 3):
        yield Fault(place, f"goes from {link.nodes[0]!r} and back.", "Name two nodes; a closed frame has at least three.")
        return
    places: dict[tuple[float, ...], str] = {}
    for node in open_nodes:
        other = places.setdefault(model.nodes[node].at, node)
        if other != node:
            about = (("nodes", other), ("nodes", node))
            message = f"has two pins at one place: {other!r} and {node!r} stand at {model.nodes[node].at}."
            yield Fault(place, message, "Move one of them, or leave one out.", about=about)


def _matter(model: WholeModel, link: Link, path: tuple[Any, ...], dim: int) -> Iterator[Fault]:
    """An elastic link needs a section and a material; in space a section needs a torsion constant."""
    lacks = []
    for field in ("section", "material"):
        chosen = getattr(link, field) if getattr(link, field) is not None else getattr(model, field)
        if chosen is None:
            lacks.append(field)
        elif isinstance(chosen, str) and chosen not in getattr(model, f"{field}s"):
            return
    about = tuple((*place, field) for place in (path, ()) for field in ("section", "material"))
    if link.kind == "elastic" and lacks:
        yield Fault(path, f"is elastic but has no {' and no '.join(lacks)}.", "Give both, or kind: rigid.", about=about)
    elif not lacks and dim == 3 and model.section_of(link).torsion_constant is None:
        message = "has a section without a torsion constant."
        yield Fault((*path, "section"), message, "Give the section J, m^4.", about=(*about, ("nodes",)))


def _doubled(model: WholeModel) -> Iterator[Fault]:
    """Two rigid links with two common pins: how they share what acts on these is not known."""
    rigid = [(name, link) for name, link in model.links.items() if link.kind == "rigid" and is_sound(model, link)]
    pairs: dict[frozenset[str], str] = {}
    for name, link in rigid:
        every = dict.fromkeys(link.nodes)
        own = [frozenset((a, b)) for a in every for b in every if a < b]
        if other := next((pairs[pair] for pair in own if pair in pairs), None):
            pair = next(pair for pair in own if pairs.get(pair) == other)
            a, b = sorted(pair, key=list(every).index)
            message = f"has two pins, {a} and {b}, in common with the rigid link {other!r}: who carries what is not known."
            mend = "Make one link of both, with the section of both; or make both kind: elastic; or pin one of them elsewhere."
            yield Fault(("links", name, "nodes"), message, mend, about=(("links", other),))
        pairs |= {pair: name for pair in own if pair not in pairs}
