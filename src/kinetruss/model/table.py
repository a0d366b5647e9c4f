"""Read-only tables: the dictionaries of a frozen record, which cannot change after its checks."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields
from typing import Annotated, Any, NoReturn, TypeVar

from pydantic import AfterValidator, BeforeValidator, Field, GetCoreSchemaHandler
from pydantic_core import core_schema

from kinetruss.errors import FrozenError, shown
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model.words import nearest

K = TypeVar("K")
V = TypeVar("V")

_SHOWN = 12
"""Largest number of entries of a table or a list that are printed; of a longer one, the first few."""


class _Shown(str):
    """Text that is shown without quotes."""

    __slots__ = ()
    __repr__ = str.__str__


def brief(value: Any) -> Any:
    """A value for `repr`: of a long list, the first and the last entries and how many there are; others as they are.

    >>> brief((0.0, 0.5, 1.0)), brief(tuple(range(2001)))
    ((0.0, 0.5, 1.0), (0, 1, 2, ..., 2000; 2,001 in all))
    """
    if not isinstance(value, tuple) or len(value) <= _SHOWN:
        return value
    return _Shown(f"({', '.join(map(repr, value[:3]))}, ..., {value[-1]!r}; {len(value):,} in all)")


def missing(key: object, table: Iterable[object], more: str = "") -> KeyError:
    """The error of a name that a table does not have: it offers the nearest. more : what else to say.

    >>> missing("crnk", ["crank", "rocker"])
    KeyError("'crnk' is not in this table. Did you mean 'crank'?")
    """
    return KeyError(" ".join(filter(None, [f"{shown(key)} is not in this table. {nearest(key, table)}", more])))


class ReadOnly(dict[K, V]):
    """A dictionary that cannot be changed; ``|``, ``dict(...)`` and ``.copy()`` give plain ones that can.

    >>> import kinetruss as kt
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"])
    >>> model.with_(nodes=model.nodes | {"B": (2, 0)}).nodes["B"].at
    (2.0, 0.0)
    >>> model.nodes["B"] = (2, 0)
    Traceback (most recent call last):
    ...
    kinetruss.errors.FrozenError: A record's tables are read-only. Make a new record with other ones, e.g. \
model.with_(nodes=model.nodes | {...}).
    """

    __slots__ = ()

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise FrozenError(
            "A record's tables are read-only. Make a new record with other ones, e.g. model.with_(nodes=model.nodes | {...})."
        )

    def __missing__(self, key: object) -> NoReturn:
        raise missing(key, self)

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_after_validator_function(cls, handler(dict))

    def __copy__(self) -> ReadOnly[K, V]:
        return self

    def __deepcopy__(self, memo: Any) -> ReadOnly[K, V]:
        return self  # its values are frozen too

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self),)

    def __repr__(self) -> str:
        whole = len(self) <= _SHOWN
        first = ", ".join(f"{key!r}: {brief(value)!r}" for key, value in list(self.items())[: None if whole else _SHOWN // 3])
        return f"{{{first}}}" if whole else f"{{{first}, ... {len(self):,} in all}}"


def _plain(value: Any) -> Any:
    """A plain dictionary: pydantic reads it twice as fast as a subclass."""
    return dict(value) if type(value) is ReadOnly else value


Table = Annotated[dict[K, V], Field(max_length=MOST_ENTRIES), BeforeValidator(_plain), AfterValidator(ReadOnly)]
"""A table of a record: name -> value."""

Filled = Annotated[dict[K, V], Field(min_length=1, max_length=MOST_ENTRIES), BeforeValidator(_plain), AfterValidator(ReadOnly)]
"""A table that is not empty."""


def read_only(record: Any) -> None:
    """Make read-only tables of the dictionaries in the fields of a dataclass: a wrong name then says which there are."""
    for field in fields(record):
        value = getattr(record, field.name)
        if type(value) is dict:
            object.__setattr__(record, field.name, ReadOnly(value))
