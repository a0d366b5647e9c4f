"""Arguments of library functions: an unknown or missing one is an `ArgumentError` that names the most similar one."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from typing import Any, ParamSpec, TypeVar

from kinetruss.errors import ArgumentError
from kinetruss.model import nearest

__all__ = ["bound", "own_arguments"]

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
