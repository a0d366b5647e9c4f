"""Functions that build ready-made models: checked arguments, text with units, and models by name."""

from __future__ import annotations

import functools
import importlib
import inspect
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Annotated, Any, ParamSpec, TypeVar, get_type_hints

from pydantic import create_model

from kinetruss.errors import ArgumentError, Fault, ModelError, shown
from kinetruss.model import Model, Of, Record, nearest
from kinetruss.model.recipes import Recipe
from kinetruss.units import NUMBER, parse

P = ParamSpec("P")
T = TypeVar("T")


def own_arguments(function: Callable[P, T]) -> Callable[P, T]:
    """The function; it raises `ArgumentError` for unknown or missing arguments."""
    signature = inspect.signature(function)

    @functools.wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> T:
        bound(function.__name__, signature, args, kwargs)
        return function(*args, **kwargs)

    return checked


def bound(name: str, signature: inspect.Signature, args: tuple[Any, ...], kwargs: Mapping[str, Any]) -> dict[str, Any]:
    """Arguments by name.

    Raises
    ------
    ArgumentError : an unknown argument, one given twice, too many of them, one that is missing.
    """
    try:
        return dict(signature.bind(*args, **kwargs).arguments)
    except TypeError as error:
        known = [key for key, one in signature.parameters.items() if one.kind not in (one.VAR_POSITIONAL, one.VAR_KEYWORD)]
        if unknown := [key for key in kwargs if key not in known]:
            raise ArgumentError(f"{name}: {unknown[0]!r} is not known here. {nearest(unknown[0], known)}") from None
        raise ArgumentError(f"{name}: {error}. Its arguments are: {', '.join(known)}.") from None


# Functions that build ready-made models; their arguments are checked, and accept text with units, like fields of a record.

Turning = Annotated[float, Of("angular rate")]
"""An angular rate of either sign, rad/s."""

Velocity = Annotated[float, Of("velocity")]
"""A velocity of either sign, m/s."""


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
            make: Callable[..., Model] = function
            every = {key: getattr(given, key) for key in fields}
            return Recipe("library", functools.partial(build, name), every, {}).noted(make(**every))

        BUILDERS[name] = checked, record
        return checked

    return decorate


def parametric(build: Callable[..., Model], /, **parameters: Any) -> Model:
    """The model that a function builds of parameters, which can change like its own values: by paths ``parameters.NAME``.

    So gradients, optima, studies and `io.set_value` take lengths of a mechanism or heights of cells, on which many places
    depend. Of library models the paths are ``library.NAME``.

    Parameters
    ----------
    build : gives a `Model`; what a study sends to other processes must be found there by its name.

    Examples
    --------
    >>> import kinetruss as kt
    >>> def roof(span, rise):
    ...     return kt.Model(nodes={"A": (0, 0), "B": (span, 0), "C": (span / 2, rise)}, fixed=["A", "B"],
    ...                     bars={"left": ("A", "C"), "right": ("B", "C")})
    >>> model = parametric(roof, span=4.0, rise=1.5)
    >>> kt.io.set_value(model, "parameters.span", "6 m").nodes["C"].at
    (3.0, 1.5)
    """
    arguments = inspect.signature(build).parameters.items()
    defaults = {key: one.default for key, one in arguments if one.default is not inspect.Parameter.empty}
    return Recipe("parameters", functools.partial(_built, build), parameters, defaults).noted(build(**parameters))


def _built(build: Callable[..., Model], parameters: Mapping[str, Any]) -> Model:
    """The model of other parameters."""
    given = {key: _in_si(one) for key, one in parameters.items()}
    try:
        return parametric(build, **given)
    except (ValueError, ArithmeticError) as error:
        at = ", ".join(f"{key} {shown(one)}" for key, one in given.items())
        raise ModelError([Fault(("parameters",), f"the function gives no model at {at}: {error}.", "Change them.")]) from error


def _in_si(value: Any) -> Any:
    return parse(value, "measure") if isinstance(value, str) and NUMBER.match(value) else value


def named(table: Mapping[str, T], chosen: T | str | None, parameter: str) -> T | None:
    """The record of a library table that a parameter names, or a given record."""
    if not isinstance(chosen, str):
        return chosen
    if chosen not in table:
        raise ModelError([Fault((parameter,), f"there is no {chosen!r} in the library.", f"There are: {', '.join(table)}.")])
    return table[chosen]


# A library model by name, for model files.

MODULES = ("cells", "mechanisms", "vgt")


def builders() -> dict[str, type[Record]]:
    """Names of all library models (``vgt.double_octahedral``) with the record that checks their parameters.

    >>> import kinetruss as kt
    >>> builders = kt.library.builders()
    >>> "vgt.triangular" in builders, "payload_mass" in builders["vgt.triangular"].model_fields
    (True, True)
    """
    for module in MODULES:
        package = importlib.import_module(f"kinetruss.library.{module}")
        for name in package.__all__:
            getattr(package, name)  # importing a builder enters it in the table
    return {name: record for name, (_, record) in sorted(BUILDERS.items())}


@own_arguments
def build(name: str, parameters: dict[str, Any] | None = None) -> Model:
    """Build a library model from parameters that may be text with units.

    Parameters
    ----------
    name : ``module.function``, e.g. ``vgt.double_octahedral``.
    parameters : arguments of the function by name.

    Raises
    ------
    ModelError : an unknown name, or faults of the parameters; the path of each fault starts with the parameter.

    Examples
    --------
    >>> build("vgt.double_octahedral", {"bays": 2, "longeron": "35 in"}).title
    'Double-octahedral truss, 2 bays'
    """
    known = builders()
    if name not in known:
        near = get_close_matches(name[:200], known, n=1)
        offer = f"Did you mean {near[0]!r}?" if near else f"There are: {', '.join(known)}."
        raise ModelError([Fault(("name",), f"no library model called {shown(name)}.", offer)])
    function = BUILDERS[name][0]
    record = known[name](**(parameters or {}))
    return function(**{key: getattr(record, key) for key in record.model_fields_set})
