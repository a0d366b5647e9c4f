"""Every public function shows in its docstring how it is called, and what comes back; the doctests run it."""

from __future__ import annotations

import doctest
import inspect
import re
from collections.abc import Iterator, Mapping
from types import FunctionType, ModuleType

import pytest

import kinetruss as kt

PARSER = doctest.DocTestParser()
SKIPPED = {"kinetruss.studio.serve"}  # serves until it is interrupted


def functions(module: ModuleType) -> Iterator[tuple[str, FunctionType]]:
    """The functions that a module shows, and those of the modules that it shows, by name."""
    for name in getattr(module, "__all__", ()):
        one = getattr(module, name)
        if inspect.isfunction(one):
            yield f"{module.__name__}.{name}", one
        elif inspect.ismodule(one) and one.__name__.startswith("kinetruss."):
            yield from functions(one)


def without_example(found: Mapping[str, FunctionType]) -> set[str]:
    """The names of those whose docstring has no example that is run and calls them."""
    return {name for name, one in found.items() if all(example.options.get(doctest.SKIP) for example in calls(one))}


def calls(function: FunctionType) -> list[doctest.Example]:
    """The lines of its examples that call it."""
    own = re.compile(rf"\b{function.__name__}\(")
    return [example for example in PARSER.get_examples(function.__doc__ or "") if own.search(example.source)]


@pytest.mark.slow
def test_every_public_function_has_an_example_that_is_run() -> None:
    found = dict(functions(kt))
    assert len(found) > 200
    assert {"kinetruss.run", "kinetruss.dynamics.inverse", "kinetruss.library.cells.cube"} <= set(found)
    assert without_example(found) == SKIPPED


def test_the_gate_catches_a_function_without_an_example() -> None:
    def half(x: float) -> float:
        """Half of it."""
        return x / 2

    def double(x: float) -> float:
        """Twice.

        >>> 1 + 1
        2
        """
        return 2 * x

    def third(x: float) -> float:
        """A third.

        >>> third(3.0)
        1.0
        """
        return x / 3

    assert without_example({"half": half, "double": double, "third": third}) == {"half", "double"}
