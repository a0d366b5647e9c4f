"""The model: everything the user describes, by name, checked."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from functools import cached_property
from typing import Any, Self, cast

from pydantic import BaseModel, ValidationError, model_validator

from kinetruss.errors import Fault, ModelError
from kinetruss.model.checks import dimension, faults_of, misfits
from kinetruss.model.collecting import Lost, collect, rests_on, with_library_records
from kinetruss.model.data import AXES, ModelData
from kinetruss.model.description import described
from kinetruss.model.hubs import hub_faults
from kinetruss.model.members import Node
from kinetruss.model.recipes import Recipe
from kinetruss.model.table import ReadOnly
from kinetruss.model.whole import WholeModel, expanded


class Model(ModelData):
    """A mechanism, robot or adaptive structure made of bars.

    Every argument is a mapping from names to records; plain lists stand for nodes and bars
    (``nodes={"A": (0, 0)}``, ``bars={"crank": ("A", "B")}``). Faults are collected and raised at once as `ModelError`.

    fixed : names of nodes held in all axes, or a mapping node -> axes, e.g. ``{"A": "xy"}``.
    bodies : masses in the plane or in space carried by nodes.
    beams : members that bend; those that meet at a node share its rotation. clamped : nodes of beams whose position and
        rotation the ground holds, or a mapping node -> body whose rotation it shares.
    joints : records of the joints that `library.joints` has built from nodes and bars.
    bearings : pins and balls whose friction follows from their force.
    hubs : nodes of finite size, by node (see `Hub`).
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
        self._check()
        return self

    def _check(self, named: bool = False) -> None:
        """Refuse faults of the model as a whole, and keep its inner parts. named : the names in its records are known."""
        odd, fitting = misfits(self)
        # data that no longer name a node of another dimension can still be checked
        judged = self if not odd else BaseModel.model_copy(self, update={"nodes": fitting})
        if wrong := hub_faults(judged):
            raise ModelError([*odd, *wrong])
        whole = expanded(judged)
        lost = Lost(("nodes", str(fault.path[1])) for fault in odd)
        if found := [*odd, *(fault for fault in faults_of(whole, named) if not rests_on(fault, lost))]:
            raise ModelError(found)
        self.__dict__["whole"] = whole

    @cached_property
    def whole(self) -> WholeModel:
        """The model with the inner parts that represent its beams, bodies and hubs: what analyses compute with."""
        return expanded(self)

    @property
    def recipe(self) -> Recipe | None:
        """How the model was built from parameters, if it was."""
        found: Recipe | None = self.__dict__.get("recipe")
        return found

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
        found = type(self)(**self._given() | changes)
        if self.recipe is not None:
            self.recipe.noted(found, tuple(((name,), value) for name, value in changes.items()))
        return found

    def moved(self, nodes: Mapping[str, Node]) -> Self:
        """The model with its nodes at other places: the same nodes but for `at`. Other records are not looked at again, and all
        that depends on places is checked.

        Raises
        ------
        ModelError : faults of these places.

        >>> import kinetruss as kt
        >>> one = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"])
        >>> one.moved(one.nodes | {"B": kt.Node(at=(2, 0))}).nodes["B"].at
        (2.0, 0.0)
        """
        fields = self._given() | {"nodes": ReadOnly(nodes)}
        found = cast("Self", type(self).model_construct(self.model_fields_set, **fields))
        try:
            found._check(named=True)
        except ModelError:
            return self.with_(nodes=nodes)  # which tells the faults as those of a new model
        if self.recipe is not None:
            self.recipe.noted(found, ((("nodes",), nodes),))
        return found

    def _given(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in self.model_fields_set}


def _dimension_of(nodes: Any) -> int:
    """2 or 3, from nodes given in any form; 3 if it cannot be determined."""
    counts = []
    for node in nodes.values() if isinstance(nodes, dict) else ():
        at: Any = node.at if isinstance(node, Node) else node.get("at") if isinstance(node, dict) else node
        if hasattr(at, "__len__") and not isinstance(at, str):
            counts.append(len(at))
    return dimension(counts) if counts else 3
