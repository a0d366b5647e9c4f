"""The numbers of a model by which results are differentiated: where they stand among the numbers of a `System`.

A number of the model, named by its path, usually stands as it is in one place or several of the numbers of `mechanics.numbers`,
from which all tables of the elements follow. The places are found by changing all of them together, each by another small
amount. Numbers that a model computes from it (places of inner nodes, of hubs, of bodies) have derivatives by differences.
Where an analysis reads a number of the model beside those of the system, as `points.gradients_at` finds out, changed models are
compiled instead.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import keep
from kinetruss.errors import InputError
from kinetruss.gradients.differences import FOUR
from kinetruss.gradients.nearness import Near, near_nodes, parts_of, sites
from kinetruss.io.values import changed, fitting, number_at, origin, resolved
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.numbers import numbers_of, system_at, system_of
from kinetruss.mechanics.system import ByIdentity
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Keys = tuple[str | int, ...]

APART = 1e-14
"""Relative distance of the values by which numbers are told from each other."""
TRIED = 1e-7
"""Step of the one other model that is compiled, as a fraction of a number or of its scale."""
STEP = 1e-4
"""Step of differences, as a fraction of a number or of its scale."""

Wrt = Sequence[str | Sequence[str]]
Through = Callable[[Model], Model]


@dataclass(frozen=True, eq=False)
class Varied:
    """names (K,) of the numbers; paths : of each, which all have its value; keys, as `resolved`. value, scale (K,): values, and
    what a change is compared with. system : the model with each of them in a place of its own, at these values. base, places :
    by name the numbers of the system that depend on them, at these values; their flat places, on which (K) they do, and how.
    trial (K,) : a small change of all of them. through : what makes of the model with these numbers the one that is analysed,
    as under a condition.
    """

    model: Model
    names: tuple[str, ...]
    paths: tuple[tuple[str, ...], ...]
    keys: tuple[tuple[Keys, ...], ...]
    value: NDArray[np.float64]
    scale: NDArray[np.float64]
    system: System
    base: Mapping[str, NDArray[np.float64]]
    places: Mapping[str, tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]]
    trial: NDArray[np.float64]
    through: Through | None = None

    @cached_property
    def tried(self) -> System:
        """The system of the model with all of them changed by `trial`."""
        return self.compiled(self.trial)

    def changed(self, change: NDArray[np.float64]) -> System:
        """The system with the numbers changed by (K,)."""
        changes = {name: own.copy() for name, own in self.base.items()}
        for name, (flat, which, slope) in self.places.items():
            np.add.at(changes[name].reshape(-1), flat, slope * change[which])
        return system_at(self.system, changes)

    def compiled(self, change: NDArray[np.float64]) -> System:
        """The system of the model with the numbers changed by (K,)."""
        return compile(self.model_at(change))

    def model_at(self, change: NDArray[np.float64]) -> Model:
        """The model, as it is analysed, with the numbers changed by (K,)."""
        at = self.value + change
        found = changed(self.model, [(keys, float(at[k])) for k in np.flatnonzero(change) for keys in self.keys[k]])
        return found if self.through is None else self.through(found)

    @cached_property
    def kinds(self) -> list[NDArray[np.bool_]]:
        """Which (K,) of the numbers are the same field of a table, for each such field."""
        kind = [(own[0][0], *(key for key in own[0][2:] if isinstance(key, str))) for own in self.keys]
        return [np.array([one == each for one in kind]) for each in dict.fromkeys(kind)]

    @cached_property
    def of_records(self) -> NDArray[np.bool_]:
        """Which (K,) of the numbers have no place among those of a system."""
        found = np.ones(len(self.names), np.bool_)
        for _, which, slope in self.places.values():
            found[which[slope != 0.0]] = False
        return found

    @cached_property
    def near(self) -> list[Near]:
        """For each number the nodes of the parts on which it acts; None: everywhere."""
        return near_nodes(parts_of(self.system), self.keys)


def varied(model: Model, wrt: Wrt, through: Through | None = None) -> Varied:
    """The numbers of a model named by paths, or by groups of paths that have one value together.

    Parameters
    ----------
    wrt : dotted paths as for `io.set_value`, such as ``bars.M7.section.area`` or ``nodes.C.at.0``; a star stands for all that
        fit, each a number of its own; a tuple or list of paths is one number. through : as of `Varied`; it must be hashable.

    Raises
    ------
    InputError : an unknown path; what is there is no number; members of a group with different values; a number given twice.
    """
    wrt = [wrt] if isinstance(wrt, str) else wrt
    return _varied(ByIdentity(model), tuple(one if isinstance(one, str) else tuple(one) for one in wrt), through)


_last: dict[tuple[ByIdentity, Any], Varied] = {}
"""What was found last, by the `origin` of its model and by `wrt`."""


@lru_cache(maxsize=4)
def _varied(key: ByIdentity, wrt: tuple[str | tuple[str, ...], ...], through: Through | None) -> Varied:
    model, (first, other) = key.model, origin(key.model)
    known = ByIdentity(first), wrt
    alike = through is None and known in _last and other <= set(chain.from_iterable(_last[known].keys))
    if alike and (found := _moved(_last[known], model)) is not None:
        return found
    groups = [group for one in wrt for group in _groups(model, one)]
    if not groups:
        raise InputError("No number is named by which to differentiate. Give paths, such as 'bars.M1.section.area'.")
    keys = tuple(tuple(resolved(model, path) for path in group) for group in groups)
    flat = [one for own in keys for one in own]
    if len(set(flat)) < len(flat):
        twice = next(".".join(map(str, one)) for one in flat if flat.count(one) > 1)
        raise InputError(f"{twice} is named twice, by two paths or by one name. Leave one out.")
    value = np.array([_value(model, group, own) for group, own in zip(groups, keys, strict=True)])
    names = tuple(group[0] if len(group) == 1 else f"{group[0]} and {len(group) - 1} more" for group in groups)
    scale = _scales(model, keys, value)
    trial = TRIED * scale * np.random.default_rng(1).uniform(0.5, 1.0, len(scale))
    system, base, places, tried = _placed(model, keys, value, scale, trial, through)
    found = Varied(model, names, tuple(map(tuple, groups)), keys, value, scale, system, base, places, trial, through)
    vars(found)["tried"] = tried
    if through is None and other <= set(flat):
        _last.pop(known, None)
        _last[known] = found
        for oldest in list(_last)[:-4]:
            _last.pop(oldest, None)
    return found


def _moved(known: Varied, model: Model) -> Varied | None:
    """The same numbers of a model that differs in them alone; None if they do not all stand in it as they are, or it has other
    parts.
    """
    value = np.array([_value(model, group, own) for group, own in zip(known.paths, known.keys, strict=True)])
    copied = all((slope == 1.0).all() for _, _, slope in known.places.values())
    if not copied or not (value * known.value).all():
        return None
    base = {name: own.copy() for name, own in known.base.items()}
    for name, (flat, which, _) in known.places.items():
        base[name].reshape(-1)[flat] = value[which]
    if (system := system_of(known.system, base, model)) is None:
        return None
    scale = _scales(model, known.keys, value)
    found = replace(
        known, model=model, value=value, scale=scale, system=system, base=base, trial=known.trial / known.scale * scale
    )
    for one in (parts_of, sites):  # by names alone
        keep(one, system, one(known.system))
    vars(found).update({name: getattr(known, name) for name in ("kinds", "of_records", "near")})
    return found


def _groups(model: Model, one: str | Sequence[str]) -> list[list[str]]:
    """The groups that an entry of `wrt` names: one of all its paths, or one for each that fits a pattern."""
    if not isinstance(one, str):
        return [[path for pattern in one for path in fitting(model, pattern)]]
    return [[path] for path in fitting(model, one)]


def _value(model: Model, group: Sequence[str], keys: Sequence[Keys]) -> float:
    """The value that all paths of a group have."""
    found = [number_at(model, path, own) for path, own in zip(group, keys, strict=True)]
    if any(abs(one - found[0]) > 1e-12 * abs(found[0]) for one in found):
        raise InputError(f"{group[0]} and {group[-1]} are to be one number, but have different values. Name them apart.")
    return found[0]


def _scales(model: Model, keys: Sequence[Sequence[Keys]], value: NDArray[np.float64]) -> NDArray[np.float64]:
    """What changes are compared with: the size of the structure for places, else the value, or 1."""
    places: list[tuple[float, ...]] = [node.at for node in model.nodes.values() if not node.scalar]
    at = np.array(places or [(1.0,)])
    size = float(np.ptp(at, axis=0).max(initial=0.0)) or 1.0
    placing = np.array([own[0][0] == "nodes" and "at" in own[0] for own in keys])
    return np.where(placing, size / np.sqrt(len(at)), np.where(value != 0.0, np.abs(value), 1.0))


Places = dict[str, tuple["NDArray[np.int64]", "NDArray[np.int64]", "NDArray[np.float64]"]]


def _placed(
    model: Model,
    groups: Sequence[Sequence[Keys]],
    value: NDArray[np.float64],
    scale: NDArray[np.float64],
    trial: NDArray[np.float64],
    through: Through | None,
) -> tuple[System, dict[str, NDArray[np.float64]], Places, System]:
    """The system with each number in a place of its own, the numbers that depend on them, their places, and that of a trial.

    Of values that all differ a little from those of the model, entries that are one of them follow it; others are computed.
    """
    mark = APART * (1.0 + np.arange(len(groups))) * scale

    def at(values: NDArray[np.float64]) -> System:
        pairs = zip(groups, values, strict=True)
        found = changed(model, [(path, float(one)) for group, one in pairs for path in group])
        return compile(found if through is None else through(found))

    analysed = model if through is None else through(model)
    system, other = at(value + mark), at(value + trial)
    for zero in np.flatnonzero(value == 0.0).tolist() if _another(system, analysed) else ():
        if _another(at(np.where(np.arange(len(value)) == zero, mark, 0.0) + value), analysed):
            named = ".".join(map(str, groups[zero][0]))
            raise InputError(f"{named} is 0, and the model has other parts where it is not. Give it a value, or leave it out.")
    a, b = numbers_of(system), numbers_of(other)
    index = {float(one): k for k, one in enumerate(value + mark)}
    base: dict[str, NDArray[np.float64]] = {}
    places: Places = {}
    computed: dict[str, NDArray[np.int64]] = {}
    for name, own in a.items():
        flat, moved = own.reshape(-1), b[name].reshape(-1)
        if flat.shape != moved.shape:
            raise InputError("Numbers named here change which parts the model has: by value or because it is 0. Name others.")
        where = np.flatnonzero((flat != moved) & ~np.isnan(flat))
        which = np.array([index.get(float(one), -1) for one in flat[where]], np.int64)
        same = (which >= 0) & (moved[where] == (value + trial)[which])
        if len(where):
            base[name] = own.copy()
            base[name].reshape(-1)[where[same]] = value[which[same]]
            places[name] = (where[same], which[same], np.ones(int(same.sum())))
        if not same.all():
            computed[name] = where[~same]
    for k in range(len(groups) if computed else 0):
        slopes = _by_differences(lambda values: numbers_of(at(values)), value + mark, STEP * scale, k, computed)
        for name, slope in slopes.items():
            base[name].reshape(-1)[computed[name]] -= slope * mark[k]
            on = slope != 0.0
            new = computed[name][on], np.full(int(on.sum()), k), slope[on]
            places[name] = tuple(np.concatenate(pair) for pair in zip(places[name], new, strict=True))  # type: ignore[assignment]
    return replace(system_at(system, base), given=analysed), base, places, other


def _another(system: System, model: Model) -> bool:
    """Whether a system has other parts than a model."""
    own = compile(model)
    same = (system.nodes, system.members, system.measures) == (own.nodes, own.members, own.measures)
    return not (same and np.array_equal(system.prescribed, own.prescribed) and len(system.row_kind) == len(own.row_kind))


def _by_differences(
    numbers: Any, value: NDArray[np.float64], step: NDArray[np.float64], k: int, where: Mapping[str, NDArray[np.int64]]
) -> dict[str, NDArray[np.float64]]:
    """Derivatives by number k of those numbers that a model computes from it."""
    found = {name: np.zeros(len(own)) for name, own in where.items()}
    for share, weight in FOUR:
        changed = value.copy()
        changed[k] += share * step[k]
        at = numbers(changed)
        for name, own in where.items():
            found[name] += weight * at[name].reshape(-1)[own] / step[k]
    return found
