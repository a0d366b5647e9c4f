"""The model: everything the user describes, by name, checked."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Any, Self

from pydantic import BaseModel, ValidationError, model_validator

from kinetruss.errors import Fault, ModelError
from kinetruss.model.beam_checks import spins
from kinetruss.model.beam_frames import chords, expanded, rigid_groups
from kinetruss.model.body_checks import body_faults
from kinetruss.model.bracing import braced
from kinetruss.model.checks import dimension, faults, misfits
from kinetruss.model.collecting import Lost, collect, rests_on, with_library_records
from kinetruss.model.data import AXES, ModelData
from kinetruss.model.description import described
from kinetruss.model.hub_expansion import with_arms
from kinetruss.model.hubs import hub_faults, missing_nodes
from kinetruss.model.members import Node
from kinetruss.model.references import unknown_names
from kinetruss.model.table import ReadOnly


class Model(ModelData):
    """A mechanism, robot or adaptive structure made of bars.

    Every argument is a mapping from names to records; plain lists stand for nodes and bars
    (``nodes={"A": (0, 0)}``, ``bars={"crank": ("A", "B")}``). Faults are collected and raised at once as `ModelError`.

    fixed : names of nodes held in all axes, or a mapping node -> axes, e.g. ``{"A": "xy"}``.
    bodies : masses in the plane or in space carried by nodes; the bars that hold rigid ones together are added to `bars`.
    beams : members that bend; those that meet at a node share its rotation. clamped : nodes of beams whose position and
        rotation the ground holds, or a mapping node -> body whose rotation it shares.
    joints : records of the joints that `library.joints` has built from nodes and bars.
    bearings : pins and balls whose friction follows from their force.
    hubs : nodes of finite size, by node; their arms are added to `nodes`, `bars` and `bodies` (see `Hub`).
    membranes, solids : meshes of elastic triangles and tetrahedra on nodes.
    section, material : used by every bar that names none. Here and in its records a name refers to a table of the model,
    or to the library: ``material="steel_s235"``.
    velocities : of nodes at the start of a simulation, m/s; other nodes are at rest, or move as the constraints require.

    >>> import kinetruss as kt
    >>> roof = kt.Model(
    ...     nodes={"A": (0, 0), "B": (4, 0), "C": (2, 1.5)}, fixed=["A", "B"],
    ...     bars={"left": ("A", "C"), "right": ("B", "C")},
    ...     section=kt.Rod(diameter="20 mm"), material="steel_s235",
    ...     loads={"snow": kt.NodalForce(node="C", force=(0, "-2 kN"))},
    ... )
    >>> roof.bars["left"].ends
    ('A', 'C')
    """

    @classmethod
    def _faults(cls, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
        return collect(cls, error, data)

    @model_validator(mode="before")
    @classmethod
    def _fixed_names(cls, value: Any) -> Any:
        fixed = value.get("fixed") if isinstance(value, dict) else None
        if isinstance(fixed, (list, tuple, set, frozenset)) and all(isinstance(name, Hashable) for name in fixed):
            axes = AXES[: _dimension_of(value.get("nodes"))]
            return value | {"fixed": dict.fromkeys(fixed, axes)}
        return value

    @model_validator(mode="before")
    @classmethod
    def _library_names(cls, value: Any) -> Any:
        return with_library_records(ModelData, value) if isinstance(value, dict) else value

    @model_validator(mode="after")
    def _consistent(self) -> Model:
        odd, fitting = misfits(self)
        # data that no longer name a node of another dimension can still be checked
        judged = self if not odd else BaseModel.model_copy(self, update={"nodes": fitting})
        if wrong := hub_faults(judged):
            raise ModelError([*odd, *wrong])
        whole = not judged.hubs or not missing_nodes(judged)
        for field, table in (with_arms(judged) if judged.hubs and whole else {}).items():
            judged.__dict__[field] = ReadOnly(table)
            judged.__pydantic_fields_set__.add(field)
            _forget(judged)
        if whole and (judged.beams or any(node.director for node in judged.nodes.values())):
            _take(judged, expanded(judged))
            _take(judged, {"couplings": judged.couplings | {one.coupling: one.held(judged) for one in spins(judged)}})
        if whole and (judged.bodies or judged.beams or any(bar.brace for bar in judged.bars.values())):
            _take(judged, {"bars": braced(judged, rigid_groups(judged), _faulty_bodies(judged)) | chords(judged)})
            _forget(judged)  # what was derived during the checks
        lost = Lost(("nodes", str(fault.path[1])) for fault in odd)
        if found := [*odd, *(fault for fault in faults(judged) if not rests_on(fault, lost))]:
            raise ModelError(found)
        return self

    def __repr__(self) -> str:
        """The title, and the number of each kind of part; drives by name."""
        return described(self)

    __str__ = __repr__

    def with_(self, **changes: Any) -> Self:
        """A new model with some fields changed; all checks run again.

        >>> import kinetruss as kt
        >>> one = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"])
        >>> one.with_(title="a bar").title
        'a bar'
        """
        fields = {name: getattr(self, name) for name in self.model_fields_set}
        return type(self)(**fields | changes)


def _forget(model: Model) -> None:
    """Drop what is derived from bars that have changed since."""
    for name in ("members", "driven_members"):
        model.__dict__.pop(name, None)


def _take(model: Model, tables: dict[str, Any]) -> None:
    """Set tables that are completed from others."""
    for name, table in tables.items():
        if table or name in model.__pydantic_fields_set__:
            model.__dict__[name] = ReadOnly(table)
            model.__pydantic_fields_set__.add(name)


def _faulty_bodies(model: Model) -> set[str]:
    """Bodies that cannot be braced as given."""
    dim = dimension(len(node.at) for node in model.nodes.values())
    unknown = unknown_names(model, model.bodies, ("bodies",), (ModelData, "bodies"))
    return {str(fault.path[1]) for fault in (*unknown, *body_faults(model, dim))}


def _dimension_of(nodes: Any) -> int:
    """2 or 3, from nodes given in any form; 3 if it cannot be determined."""
    counts = []
    for node in nodes.values() if isinstance(nodes, dict) else ():
        at: Any = node.at if isinstance(node, Node) else node.get("at") if isinstance(node, dict) else node
        if hasattr(at, "__len__") and not isinstance(at, str):
            counts.append(len(at))
    return dimension(counts) if counts else 3
