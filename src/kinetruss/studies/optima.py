"""Variants of which each is an optimum: a model and a task with the values of the variant, and the numbers that are kept."""

from __future__ import annotations

from collections.abc import Mapping
from copy import deepcopy
from pathlib import Path
from typing import Any

from kinetruss.design import Optimum, optimise
from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.io.values import given
from kinetruss.io.yaml_text import parse, plain
from kinetruss.model import Model, OptimumTask, nearest, of_file
from kinetruss.runs.variant_sets import Base
from kinetruss.threads import one_thread

OPTIMUM = "optimum."
"""Start of the path of a value of the task: ``optimum.limits.sag.at_most``."""
OBJECTIVE, CERTIFIED, PRICE = "objective", "certified", "price_"


class Tasks:
    """The base of such variants. base : of their models. text : the file of their task.

    Raises
    ------
    ModelError : faults of the task.
    """

    def __init__(self, base: Base, text: str) -> None:
        self.base = base
        tree, faults = parse(Path("task.yaml"), text)
        if tree is None or faults:
            raise ModelError(faults or [Fault((), "The task is empty.", "Start with kinetruss_optimum: 1.")])
        self._data: dict[str, Any] = plain(tree)
        self.task = self.task_with({})

    def task_with(self, values: Mapping[str, Any]) -> OptimumTask:
        """The task with the values whose paths are in it."""
        data = deepcopy(self._data)
        for path, value in values.items():
            if path.startswith(OPTIMUM):
                _put(data, path, value)
        with of_file():
            return OptimumTask(**data)

    def with_(self, values: Mapping[str, Any]) -> tuple[Model, OptimumTask]:
        """The model and the task of a variant."""
        own = {path: value for path, value in values.items() if not path.startswith(OPTIMUM)}
        return self.base.with_(own), self.task_with(values)


def _put(data: dict[str, Any], path: str, value: Any) -> None:
    """Change a value that the task has."""
    *before, last = path.removeprefix(OPTIMUM).split(".")
    here: Any = data
    for k, key in enumerate([*before, last]):
        place: Any = int(key) if isinstance(here, list) and key.isdecimal() else key
        known = range(len(here)) if isinstance(here, list) else here if isinstance(here, dict) else ()
        if place not in known:
            mend = nearest(key, list(map(str, known)))
            raise ModelError([Fault((*path.split(".")[: k + 2],), f"{key!r} is not in the task of the optimum.", mend)])
        if k == len(before):
            here[place] = given(value)
        here = here[place]


class Numbers:
    """The numbers that are kept of an optimum: ``objective``, the variables, ``certified`` (1 or 0), and ``price_LIMIT``, by
    how much the objective falls if that limit is moved by one of its unit.

    texts : name of a result -> which of these. units : of the results, known from the first optimum on.

    Raises
    ------
    InputError : a result that is none of these.
    """

    judged = False

    def __init__(self, task: OptimumTask, results: Mapping[str, str]) -> None:
        known = [OBJECTIVE, *task.variables, CERTIFIED, *(f"{PRICE}{name}" for name in task.limits)]
        if other := [f"results.{name}: {text!r} is not known of an optimum. {nearest(text, known)}"
                     for name, text in results.items() if text not in known]:  # fmt: skip
            raise InputError(" ".join(other))
        self.texts = dict(results) or {name: name for name in known}
        self.units: dict[str, str] = {}

    def __call__(self, found: Optimum) -> dict[str, float]:
        """The numbers of an optimum."""
        prices = {one.name: (one.unit, 0.0) for one in found.limits}
        for one in found.active:
            name = one.name.partition(" ")[0]
            if not one.bound and found.certificate.first_order:
                prices[name] = one.unit, prices[name][1] + one.price
        of_limits = {f"{PRICE}{name}": (price, _per(found.unit, unit)) for name, (unit, price) in prices.items()}
        own = {name: (value, found.variable_unit(name)) for name, value in found.values.items()}
        every = {OBJECTIVE: (found.objective, found.unit), CERTIFIED: (float(found.certified), ""), **of_limits, **own}
        self.units = {name: every[text][1] for name, text in self.texts.items()}
        return {name: every[text][0] for name, text in self.texts.items()}


def _per(unit: str, of: str) -> str:
    return f"{unit or '1'}/{of if of.isalpha() else f'({of})'}" if of else unit


@one_thread
def optimum_of(pair: tuple[Model, OptimumTask]) -> tuple[Optimum, str]:
    """The optimum of a variant, and what it says: the limits and bounds that are reached, or that nothing is certified.

    Raises
    ------
    InfeasibleError : no design keeps all limits. KeyboardInterrupt : an interrupted search is no result of a variant.
    """
    model, task = pair
    found = optimise(model, task)
    if found.state:
        raise KeyboardInterrupt
    if not found.certified:
        return found, found.sentence
    return found, "; ".join(one.name for one in found.active if one.price > 0) or "no limit is reached"
