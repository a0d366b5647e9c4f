"""How a model was built from parameters, so that these can change like its own values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.model.the_model import Model

Keys = tuple[str | int, ...]


@dataclass(frozen=True, eq=False)
class Recipe:
    """A function of parameters that gives a model, and what was changed in the model since.

    name : of the parameters in paths: ``library.arm``, ``parameters.arm``. build : takes all parameters by name.
    parameters : as given. defaults : of those that are not. changes : keys of values of the model, and the values.
    """

    name: str
    build: Callable[[Mapping[str, Any]], Model]
    parameters: Mapping[str, Any]
    defaults: Mapping[str, Any]
    changes: tuple[tuple[Keys, Any], ...] = ()

    @property
    def all(self) -> dict[str, Any]:
        """All parameters."""
        return {**self.defaults, **self.parameters}

    def noted(self, model: Model, changes: tuple[tuple[Keys, Any], ...] = ()) -> Model:
        """The model, which from now on knows that it was built so and changed."""
        model.__dict__["recipe"] = replace(self, changes=(*self.changes, *changes))
        return model
