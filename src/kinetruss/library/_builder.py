"""Functions that build ready-made models; their arguments are checked, and accept text with units, like fields of a record."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from typing import Annotated, Any, ParamSpec, TypeVar, get_type_hints

from pydantic import create_model

from kinetruss.errors import Fault, ModelError
from kinetruss.library._arguments import bound
from kinetruss.model import Model, Of, Record

__all__ = ["BUILDERS", "Turning", "Velocity", "builder", "named"]

Turning = Annotated[float, Of("angular rate")]
"""An angular rate of either sign, rad/s."""

Velocity = Annotated[float, Of("velocity")]
"""A velocity of either sign, m/s."""

P = ParamSpec("P")
T = TypeVar("T")

BUILDERS: dict[str, tuple[Callable[..., Model], type[Record]]] = {}
"""By ``module.function``: the builder, and the record that checks its parameters."""


def builder(name: str) -> Callable[[Callable[P, Model]], Callable[P, Model]]:
    """Register a model-building function as ``module.function`` and check its arguments by their annotations.

    All faults are raised at once. A length may be ``"48 in"``, a record the name of one in the library.
    """

    def decorate(function: Callable[P, Model]) -> Callable[P, Model]:
        signature = inspect.signature(function)
        hints = get_type_hints(function, include_extras=True)
        fields: dict[str, Any] = {
            key: (hints[key], ... if parameter.default is inspect.Parameter.empty else parameter.default)
            for key, parameter in signature.parameters.items()
        }
        record: type[Record] = create_model(function.__name__, __base__=Record, __doc__=function.__doc__, **fields)

        @functools.wraps(function)
        def checked(*args: P.args, **kwargs: P.kwargs) -> Model:
            given = record(**bound(function.__name__, signature, args, kwargs))
            build: Callable[..., Model] = function
            return build(**{key: getattr(given, key) for key in fields})

        BUILDERS[name] = checked, record
        return checked

    return decorate


def named(table: Mapping[str, T], chosen: T | str | None, parameter: str) -> T | None:
    """The record of a library table that a parameter names, or a given record."""
    if not isinstance(chosen, str):
        return chosen
    if chosen not in table:
        raise ModelError([Fault((parameter,), f"there is no {chosen!r} in the library.", f"There are: {', '.join(table)}.")])
    return table[chosen]
