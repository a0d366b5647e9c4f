"""A chain of three bays that tilts about both axes at once, against exact physics."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.library import vgt
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference
from kinetruss.verification.thesis.bay import EXACT, TILT, table_of, truss_of

__all__ = ["cases"]

TIMES = (0.0, 1.5)
TOP = {7: "B3.N7", 8: "B3.N8", 9: "B3.N9"}


def chain() -> dict[str, Any]:
    """Everything the references hold, (times, ...) arrays or tables by member, node or support."""
    model = truss_of(load("chain")["inputs"], bays=3, payload_mass=2.0)
    trajectory = vgt.slew(3, beta=(0.0, TILT), gamma=(0.0, TILT), duration=3.0)
    motion = kinematics.follow(model, trajectory, times=np.array(TIMES))
    forces = dynamics.inverse(model, motion, static=False)
    lengths = np.stack([motion.data[name].values for name in ("length", "length_rate", "length_acceleration")], -1)
    tables = {
        "reactions_N1_N2_N3": {f"N{k}": forces.reaction.sel(support=f"B1.N{k}").values for k in (1, 2, 3)},
        "tension_at_B_end": table_of(forces.end_force.sel(end="B"), "member"),
        "actuator_axial": table_of(forces.interface_force.sel(component="axial"), "active"),
        "active_L_Ld_Ldd": dict(zip(motion.data["member"].values, np.moveaxis(lengths, 1, 0), strict=True)),
    }
    for key, name in (("top_nodes", "position"), ("top_acc", "acceleration")):
        tables[key] = {f"N{k}": motion.data[name].sel(node=node).values for k, node in TOP.items()}
    return tables


def cases() -> Iterator[Case]:
    """All 54 members, reactions, actuators, lengths, top nodes at rest and in mid motion."""
    data = load("chain")
    source = Reference("independent", data["source"])
    for i, (label, stored) in enumerate(data["values"].items()):
        for quantity, expected in stored.items():
            if quantity == "cond":
                continue
            table = expected if isinstance(expected, dict) else {f"N{k + 1}": row for k, row in enumerate(expected)}
            for name, value in table.items():
                yield from _cases(f"chain.{label}.{quantity}.{name}", source, quantity, name, value, i)


def _cases(prefix: str, source: Reference, quantity: str, name: str, expected: Any, i: int) -> Iterator[Case]:
    values = np.atleast_1d(expected)
    names = ("length", "rate", "acceleration") if quantity == "active_L_Ld_Ldd" else "xyz"
    for k, value in enumerate(values):
        label = f"{prefix}.{names[k]}" if len(values) > 1 else prefix
        at = (quantity, name, (i, k) if len(values) > 1 else i)
        yield Case(label, source, float(value), EXACT, chain, at=at, scale=_scale(quantity, values, k))


def _scale(quantity: str, values: Any, k: int) -> float:
    """Largest component of the vector that a value is part of; at rest, of the same vector in mid motion."""
    if quantity == "active_L_Ld_Ldd":
        moving = load("chain")["values"]["t=1.5"][quantity].values()
        return max(float(abs(triple[k])) for triple in moving) if k else 0.0
    if quantity == "top_acc":
        return max(float(abs(a)) for vector in load("chain")["values"]["t=1.5"][quantity].values() for a in vector)
    return float(np.abs(values).max()) if len(values) > 1 else 0.0
