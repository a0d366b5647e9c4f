"""The lines of ``kinetruss info`` on beams, bodies and joints."""

from __future__ import annotations

import math
from typing import Any

from kinetruss.display import quantity
from kinetruss.library.joints import conditioning
from kinetruss.model import Model
from kinetruss.model.beam_frames import frame_of


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


# The lines of ``kinetruss info`` on bodies.


def body_records(model: Model) -> list[dict[str, Any]]:
    """Name, nodes, mass (kg), centre (m, global), principal moments (kg m^2), normalised volume of the carriers; by body."""
    import numpy as np

    from kinetruss.library.bodies import properties_of
    from kinetruss.model.bodies import principal, quality

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
                "normalised_volume": quality([model.nodes[node].at for node in carriers]),
            }
        )
    return found


def body_text(one: dict[str, Any]) -> str:
    """The line of a body."""
    center, moments = (", ".join(f"{x:.6g}" for x in one[key]) for key in ("center", "principal_moments"))
    mass = f"mass {one['mass']:.6g} kg, centre ({center}) m, principal moments {moments} kg m^2" if one["mass"] else "no mass"
    nodes = f"{one['kind']}, nodes {', '.join(one['nodes'])}"
    return f"body {one['name']}: {mass}, {nodes}, normalised volume {one['normalised_volume']:.3g}"


# The lines of ``kinetruss info`` on joints.


def joint_records(model: Model) -> list[dict[str, Any]]:
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


def joint_text(one: dict[str, Any]) -> str:
    """The line of a joint."""
    freedoms = f"{one['freedoms']} freedom{'' if one['freedoms'] == 1 else 's'}"
    first, second = one["bodies"]
    value = one["smallest_singular_value"]
    return f"joint {one['name']}: {one['kind']} of {first} and {second}, {freedoms}, smallest singular value {value:.3g}"
