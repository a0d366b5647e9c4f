"""The lines of ``kinetruss info`` on beams."""

from __future__ import annotations

import math
from typing import Any

from kinetruss.display import quantity
from kinetruss.model import Model
from kinetruss.model.beams import frame_of

__all__ = ["beam_records", "beam_text"]


def beam_records(model: Model) -> list[dict[str, Any]]:
    """Name, kind, ends, length (m), section, released and clamped ends of every beam."""
    found = []
    for name, beam in model.beams.items():
        section = model.section_of(beam)
        found.append(
            {
                "name": name,
                "kind": beam.kind,
                "ends": list(beam.ends),
                "length": math.dist(*(model.nodes[end].at for end in beam.ends)),
                "section": None if section is None else section.kind,
                "release": list(beam.release),
                "hinges": dict(beam.hinges),
                "clamped": [end for end in beam.ends if end in model.clamped and frame_of(name, beam, end) == end],
            }
        )
    return found


def beam_text(one: dict[str, Any]) -> str:
    """The line of a beam."""
    lines = [f"beam {one['name']}: {one['kind']}, {one['ends'][0]} to {one['ends'][1]}, length {quantity(one['length'], 'm')}"]
    lines += [one["section"]] if one["section"] else []
    lines += [f"hinged at {', '.join(one['hinges'])}"] if one["hinges"] else []
    lines += [f"{word} at {', '.join(one[key])}" for key, word in (("release", "released"), ("clamped", "clamped")) if one[key]]
    return ", ".join(lines)
