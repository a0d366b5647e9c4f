"""How a model was built from parameters, so that these can change like its own values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from types import CodeType
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

    @property
    def source(self) -> str:
        """What tells the function from others, also after it was edited: its name, its code, and what it was given."""
        return " ".join(_source(one) for one in (getattr(self.build, "func", self.build), *getattr(self.build, "args", ())))

    def noted(self, model: Model, changes: tuple[tuple[Keys, Any], ...] = ()) -> Model:
        """The model, which from now on knows that it was built so and changed."""
        model.__dict__["recipe"] = replace(self, changes=(*self.changes, *changes))
        return model


def _source(one: Any) -> str:
    code = getattr(one, "__code__", None)
    if code is None:  # a project may move to another folder
        return "" if isinstance(one, Path) else repr(one)
    return f"{one.__module__}.{one.__qualname__} {sha256(repr(_parts(code)).encode()).hexdigest()}"


def _parts(code: CodeType) -> tuple[Any, ...]:
    """What a function does, by its code and that of the functions within it."""
    within = [_parts(one) if isinstance(one, CodeType) else repr(one) for one in code.co_consts]
    return code.co_code, code.co_names, code.co_varnames, within
