"""Cells by kind: their parameters are checked like fields of a record, in Python and in model files."""

from __future__ import annotations

import functools
import inspect
import operator
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Annotated, Any, Literal, ParamSpec, get_type_hints

from pydantic import Discriminator, Tag, create_model

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.library._arguments import bound
from kinetruss.library.cells.fittings import Fittings
from kinetruss.library.cells.records import Cell
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import Count, Record

__all__ = ["any_cell", "counted", "made", "ready"]

P = ParamSpec("P")

KINDS: dict[str, tuple[Callable[..., Cell], type[Record]]] = {}
"""Kind -> the function that makes the cell, and the record that checks its parameters."""


def ready(kind: str, common: type = Fittings) -> Callable[[Callable[P, Cell]], Callable[P, Cell]]:
    """Register a function that makes a cell, and check its arguments by their annotations; all faults are raised at once.

    common : typed dictionary of the keyword arguments that the function does not name.
    """

    def decorate(function: Callable[P, Cell]) -> Callable[P, Cell]:
        hints = get_type_hints(function, include_extras=True)
        shape = [one for one in inspect.signature(function).parameters.values() if one.kind is not one.VAR_KEYWORD]
        rest = get_type_hints(common, include_extras=True)
        fields: dict[str, Any] = {
            one.name: (hints[one.name], ... if one.default is one.empty else one.default) for one in shape
        }
        fields |= {key: (hint, None) for key, hint in rest.items()}
        tag: dict[str, Any] = {"kind": (Literal[kind], kind), "count": (Count, 1)}
        record: type[Record] = create_model(f"cell_{kind}", __base__=Record, __doc__=function.__doc__, **fields, **tag)
        more = [inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=None) for key in rest]
        signature = inspect.Signature([*shape, *more], return_annotation=Cell)

        @functools.wraps(function)
        def checked(*args: P.args, **kwargs: P.kwargs) -> Cell:
            arguments = bound(kind, signature, args, kwargs)
            try:
                given = record(**arguments)
            except ModelError as error:
                raise ModelError([replace(fault, path=fault.path[1:]) for fault in error.faults]) from None
            make: Callable[..., Cell] = function
            return make(**{key: getattr(given, key) for key in arguments})

        checked.__signature__ = signature  # type: ignore[attr-defined]
        KINDS[kind] = checked, record
        return checked

    return decorate


def _kind_of(value: Any) -> str:
    if isinstance(value, Cell):
        return "Cell"
    kind = value.get("kind", "cell") if isinstance(value, Mapping) else getattr(value, "kind", "cell")
    return kind if isinstance(kind, str) else shown(kind)


def any_cell(*makers: Callable[..., Cell]) -> Any:
    """Annotation of a cell: a `Cell`, or the parameters of one of these functions, with its name as `kind`."""
    records = [Annotated[KINDS[make.__name__][1], Tag(make.__name__)] for make in makers]
    return Annotated[functools.reduce(operator.or_, records, Annotated[Cell, Tag("Cell")]), Discriminator(_kind_of)]


def made(given: Any, path: tuple[str | int, ...]) -> Cell:
    """The cell of the parameters in a file; faults are placed below `path`."""
    if isinstance(given, Cell):
        return given
    make, _ = KINDS[given.kind]
    try:
        return make(**{key: getattr(given, key) for key in given.model_fields_set - {"kind", "count"}})
    except ModelError as error:
        raise ModelError([replace(fault, path=(*path, *fault.path)) for fault in error.faults]) from None


def counted(given: Iterable[Any], path: tuple[str | int, ...]) -> list[Cell]:
    """The cells of a list, each as many times as its `count` says.

    Raises
    ------
    ModelError : no cell, or more than a model holds.
    """
    cells: list[Cell] = []
    for index, one in enumerate(given):
        count = getattr(one, "count", 1)
        cell = made(one, (*path, index))
        if (len(cells) + count) * len(cell.nodes) > MOST_ENTRIES:
            mend = f"Use less: a model holds at most {MOST_ENTRIES} nodes."
            raise ModelError([Fault((*path, index, "count"), f"these are {len(cells) + count} cells.", mend)])
        cells += [cell] * count
    if not cells:
        raise ModelError([Fault(path, "no cell is given.", "Give at least one, e.g. {kind: octahedron, side: 1 m}.")])
    return cells
