"""Threads of the linear algebra behind NumPy and SciPy: an analysis has one.

Its dense solves have some dozens of unknowns. Threads of OpenBLAS wait for each other at every one of them, in vain where other
programs take the processor of the one that is waited for (25 points of Lee's frame: 0.4 s by one thread, 7 s by two).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import Any, TypeVar, cast

__all__ = ["one_thread"]

F = TypeVar("F", bound=Callable[..., Any])

WHERE = ("numpy.linalg._umath_linalg", "scipy.linalg._flapack")
"""Modules that are linked with OpenBLAS; NumPy and SciPy each bring their own."""
NAMES = tuple(f"{before}openblas_{{}}_num_threads{behind}" for before in ("scipy_", "") for behind in ("64_", ""))
"""What its functions are called there."""


class _Setting:
    """The number of threads of each library, one of the process: the first call takes it, the last one gives it back."""

    def __init__(self) -> None:
        self.lock = Lock()
        self.calls, self.kept = 0, list[int]()
        self.known: list[tuple[Callable[[], int], Callable[[int], None]]] | None = None

    def __enter__(self) -> None:
        with self.lock:
            self.calls += 1
            if self.calls > 1:
                return
            if self.known is None:
                self.known = _libraries()
            self.kept = [get() for get, _ in self.known]
            for _, put in self.known:
                put(1)

    def __exit__(self, *problem: object) -> None:
        with self.lock:
            self.calls -= 1
            if self.calls == 0 and self.known is not None:
                for (_, put), count in zip(self.known, self.kept, strict=True):
                    put(count)


_SETTING = _Setting()


def one_thread(function: F) -> F:
    """A function whose linear algebra has one thread; behind it the user's number is as it was.

    Calls within calls and in several threads of Python are counted. Libraries other than OpenBLAS keep their setting.
    """

    @wraps(function)
    def alone(*args: Any, **kwargs: Any) -> Any:
        with _SETTING:
            return function(*args, **kwargs)

    return cast("F", alone)


def _libraries() -> list[tuple[Callable[[], int], Callable[[int], None]]]:
    """The functions that get and set the number of threads, of each library."""
    from ctypes import CDLL  # all this with the first analysis, which needs both modules
    from importlib import import_module

    found: list[tuple[Callable[[], int], Callable[[int], None]]] = []
    for module in WHERE:
        library = CDLL(import_module(module).__file__ or "")
        name = next((one for one in NAMES if hasattr(library, one.format("set"))), None)
        if name is not None:
            found.append((getattr(library, name.format("get")), getattr(library, name.format("set"))))
    return found
