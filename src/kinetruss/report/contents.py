"""The contents of a model: counts, degrees of freedom by rank, beams, bodies and joints."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, counted
from kinetruss.display.tables import measured, words
from kinetruss.errors import one_line
from kinetruss.kinematics import mobility
from kinetruss.library.bodies import properties_of
from kinetruss.library.joints import conditioning
from kinetruss.model import ALONG
from kinetruss.model.beam_frames import frame_of
from kinetruss.model.bodies import principal, quality
from kinetruss.model.data import ELEMENT_FIELDS
from kinetruss.model.links import length_along
from kinetruss.model.load_cases import sets_of
from kinetruss.report.document.inputs import worded
from kinetruss.report.page import Page

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.report.entries import Entry


def contents(model: Model, name: str = "") -> Page:
    """What a model contains, as a page. name : of its file."""
    return Page(found=model, as_record=partial(_record, name=name), as_entries=partial(_entries, name=name))


def counts(model: Model) -> dict[str, Any]:
    """Numbers of nodes, bars, active members and beams that the user wrote."""
    return {
        "nodes": len(model.nodes),
        "bars": len(model.bars),
        "beams": len(model.beams),
        "links": len(model.links),
        "active_members": len(model.active),
    }


def counted_parts(model: Model) -> str:
    """The same in words.

    >>> import kinetruss as kt
    >>> counted_parts(kt.read(kt.library.example_files()["four_bar"][0]))
    '4 nodes, 3 bars'
    """
    found = counts(model)
    parts = [counted(found["nodes"], "node"), counted(found["bars"], "bar")]
    several = (("active_members", "active member"), ("beams", "beam"), ("links", "link"))
    return ", ".join([*parts, *(counted(found[key], word) for key, word in several if found[key])])


def _record(model: Model, name: str) -> dict[str, Any]:
    found = mobility(model)
    known = counts(model)
    keys = ("coordinates", "fixed", "rank", "degrees_of_freedom", "drives", "undriven", "self_stress")
    return {
        "model": name,
        "title": model.title,
        **{key: known[key] for key in ("nodes", "bars", "active_members")},
        "dimension": model.dim,
        **{key: getattr(found, key) for key in keys},
        "runs": list(model.runs),
        "bodies": _bodies(model),
        "joints": _joints(model),
        "beams": _beams(model),
        "links": _links(model),
        "loads_on_members": _loads(model),
        "combinations": {name: list(cases) for name, cases in sets_of(model).items()},
        **{field: list(getattr(model, field)) for field in ELEMENT_FIELDS.values()},
        "mechanisms": found.mechanism_texts(),
        "self_stress_states": found.self_stress_texts(),
    }


def _entries(model: Model, name: str) -> Iterator[Entry]:
    kind = "planar" if model.dim == 2 else "spatial"
    yield f"{one_line(model.title or name, 200)}\n{kind}: {counted_parts(model)}\n{mobility(model)}"
    columns = [
        words("beam", "name"),
        words("kind"),
        words("ends", lambda one: " to ".join(one["ends"])),
        measured("length", unit="m"),
        words("section", lambda one: one["section"] or "-"),
        *(words(f"{key} at", lambda one, key=word: ", ".join(one[key])) for key, word in ENDS.items()),
    ]
    yield Table(columns, _beams(model), "Beams")
    columns = [
        words("link", "name"),
        words("kind"),
        words("nodes", lambda one: ", ".join(one["nodes"])),
        measured("length", unit="m"),
        words("section", lambda one: one["section"] or "-"),
        words("welded at", lambda one: ", ".join(one["weld"])),
        words("hinged at", lambda one: ", ".join(one["hinges"])),
    ]
    yield Table(columns, _links(model), "Links")
    columns = [
        words("body", "name"),
        words("kind"),
        words("nodes", lambda one: ", ".join(one["nodes"])),
        measured("mass", lambda one: one["mass"] or None, "kg"),
        words("centre (m)", lambda one: _listed(one, "center")),
        words("principal moments (kg m²)", lambda one: _listed(one, "principal_moments")),
        measured("normalised volume", "normalised_volume"),
    ]
    yield Table(columns, _bodies(model), "Bodies")
    columns = [
        words("joint", "name"),
        words("kind"),
        words("of", lambda one: " and ".join(one["bodies"])),
        words("freedoms", lambda one: str(one["freedoms"])),
        measured("smallest singular value", "smallest_singular_value"),
    ]
    yield Table(columns, _joints(model), "Joints")
    columns = [words("load", "name"), words("member"), words("what")]
    yield Table(columns, _loads(model), "Loads between the ends of members")
    several = [f"{name} ({len(cases)})" if cases != (name,) else name for name, cases in sets_of(model).items()]
    if several:
        yield f"combinations of load cases: {', '.join(several)}"
    own = {field: list(getattr(model, field)) for field in ELEMENT_FIELDS.values()}
    elements = "".join(f"{field}: {', '.join(names)}\n" for field, names in own.items() if names)
    yield f"{elements}runs: {', '.join(model.runs) or 'none'}"


ENDS = {"hinged": "hinges", "released": "release", "clamped": "clamped"}
"""What is said of the ends of beams: words and keys."""


def _listed(one: Mapping[str, Any], key: str) -> str:
    return ", ".join(f"{value:.6g}" for value in one[key]) if one["mass"] else "-"


def _beams(model: Model) -> list[dict[str, Any]]:
    """Name, kind, ends, length (m), section, released and clamped ends of every beam."""
    found = []
    for name, beam in model.beams.items():
        section = model.section_of(beam)
        found.append(
            {
                "name": name,
                "kind": beam.kind,
                "ends": list(beam.ends),
                "length": math.dist(*(model.whole.nodes[end].at for end in beam.ends)),
                "section": None if section is None else section.kind,
                "release": list(beam.release),
                "hinges": dict(beam.hinges),
                "clamped": [end for end in beam.ends if end in model.clamped and frame_of(name, beam, end) == end],
            }
        )
    return found


def _links(model: Model) -> list[dict[str, Any]]:
    """Name, kind, nodes, length (m), section, welded and hinged nodes of every link."""
    return [
        {
            "name": name,
            "kind": link.kind,
            "nodes": list(link.nodes),
            "length": length_along(model, link),
            "section": None if (section := model.section_of(link)) is None else section.kind,
            "weld": list(link.weld),
            "hinges": dict(link.hinges),
        }
        for name, link in model.links.items()
    ]


def _loads(model: Model) -> list[dict[str, Any]]:
    """Name, member and the rest in words of every load between the ends of a member."""
    return [
        {"name": name, "member": load.member, "what": worded(load).partition(", ")[2]}
        for name, load in model.loads.items()
        if isinstance(load, ALONG)
    ]


def _bodies(model: Model) -> list[dict[str, Any]]:
    """Name, nodes, mass (kg), centre (m, global), principal moments (kg m^2), normalised volume of the carriers; by body."""
    found = []
    for name, body in model.bodies.items():
        carriers = body.carried_by(model.dim)
        own = properties_of(model, body)
        moments = np.linalg.eigvalsh(own.inertia) if model.dim == 3 else np.atleast_1d(own.inertia)
        if body.inertia is not None:
            moments = principal(body, model.dim)
        found.append(
            {
                "name": name,
                "kind": body.kind,
                "nodes": list(body.nodes),
                "carriers": list(carriers),
                "mass": body.mass,
                "center": [float(x) for x in own.center],
                "principal_moments": [float(x) for x in moments],
                "normalised_volume": quality([model.whole.nodes[node].at for node in carriers]),
            }
        )
    return found


def _joints(model: Model) -> list[dict[str, Any]]:
    """Kind, bodies, relative degrees of freedom and smallest singular value of every joint."""
    return [
        {
            "name": name,
            "kind": joint.kind,
            "bodies": list(joint.bodies),
            "freedoms": joint.freedoms,
            "smallest_singular_value": conditioning(model, name),
        }
        for name, joint in model.joints.items()
    ]
