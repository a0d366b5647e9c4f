"""What was found of a System is kept with it, and goes when it goes."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import update_wrapper
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

System = Any
"""`mechanics.System`, whose file imports this one."""

Key = ParamSpec("Key")
Found = TypeVar("Found")
Finder = Callable[Concatenate["System", Key], Found]


OF_RECORDS: set[Any] = set()
"""Functions that read records and connections alone, and find the same whatever numbers the arrays of a System have."""


def cached(most: int = 32, *, of_records: bool = False) -> Callable[[Finder[Key, Found]], Finder[Key, Found]]:
    """Keep what a function finds of a System, for the last `most` values of its other arguments, which can be hashed.

    A System never changes, and the same model has the same System: so plans, tables and checks of a model are made once.
    What is found must not be written to. of_records : it is the same for all numbers that the arrays may have.
    """

    def decorated(find: Finder[Key, Found]) -> Finder[Key, Found]:
        if of_records:
            OF_RECORDS.add(find)

        def remembered(system: System, *key: Key.args, **named: Key.kwargs) -> Found:
            own: dict[tuple[Hashable, ...], Any] = system.memory.setdefault(find, {})
            place = (*key, *named.items()) if named else key
            if place in own:
                return cast("Found", own[place])
            found = own[place] = find(system, *key, **named)
            for oldest in list(own)[:-most]:
                own.pop(oldest, None)
            return found

        return cast("Finder[Key, Found]", update_wrapper(remembered, find))

    return decorated


def keep(find: Any, system: System, found: Any) -> None:
    """Let a function that is `cached`, of a System alone, find this of it."""
    system.memory.setdefault(find.__wrapped__, {})[()] = found
