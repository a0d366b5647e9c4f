"""The lines of ``kinetruss info`` on bodies."""

from __future__ import annotations

from typing import Any

from kinetruss.model import Model

__all__ = ["body_records", "body_text"]


def body_records(model: Model) -> list[dict[str, Any]]:
    """Name, nodes, mass (kg), centre (m, global), principal moments (kg m^2), normalised volume of the carriers; by body."""
    import numpy as np

    from kinetruss.library.bodies import properties_of
    from kinetruss.model.parts import principal, quality

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
