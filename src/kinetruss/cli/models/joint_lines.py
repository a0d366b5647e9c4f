"""The lines of ``kinetruss info`` on joints."""

from __future__ import annotations

from typing import Any

from kinetruss.library.joints import conditioning
from kinetruss.model import Model

__all__ = ["joint_records", "joint_text"]


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
