"""A model with changed values, named by their paths."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, cast

from kinetruss.errors import Fault, InputError, ModelError, UnitError, few
from kinetruss.io.library_models import fields
from kinetruss.io.yaml_text import parse_yaml, plain
from kinetruss.model import Model, Record, nearest
from kinetruss.model.recipes import Keys, Recipe
from kinetruss.model.references import matched, names_in
from kinetruss.units import NUMBER, parse


def set_value(model: Model, path: str, value: Any) -> Model:
    """A new model with the value at a dotted path changed; all checks run again.

    Parameters
    ----------
    model : the model; it is not changed.
    path : e.g. ``runs.extend.trajectory.duration`` or ``nodes.N4.at.0``. Names may contain dots; the longest match
    is used. If a path continues after the name of an entry of a table (here a trajectory), that entry is changed. If it
    continues inside the section or material of a part that has the model's, the part gets a copy of its own.
    value : as in a model file; text with units, and lists in brackets, are read as in a file. ``~`` removes the value.

    Raises
    ------
    ModelError : an unknown path (the message offers the nearest names); faults of the changed model.

    Examples
    --------
    >>> import kinetruss as kt
    >>> one = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"])
    >>> set_value(one, "nodes.B.at", "[36 in, 0]").nodes["B"].at
    (0.9144, 0.0)
    """
    return set_values(model, {path: value})


def set_values(model: Model, settings: Mapping[str, Any]) -> Model:
    """A new model with several values changed at once; only the final model is checked.

    Parameters
    ----------
    settings : dotted path -> value, as for `set_value`.

    Raises
    ------
    ModelError : as for `set_value`; two paths of which one is inside the other.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> heavier = kt.io.set_values(model, {"nodes.B.mass": "20 kg", "title": "Heavier"})
    >>> heavier.nodes["B"].mass, heavier.title
    (20.0, 'Heavier')
    """
    return changed(model, [(resolved(model, path), given(value)) for path, value in settings.items()])


def changed(model: Model, settings: Iterable[tuple[Keys, Any]]) -> Model:
    """`set_values` with paths as they are `resolved`, and values that are no text."""
    settings, recipe, first = list(settings), model.recipe, origin(model)
    parameters: dict[str | int, Any] = {}
    changes: dict[str | int, Any] = {}
    for keys, value in settings:
        if recipe is not None and keys[0] == recipe.name:
            _noted(parameters, keys[1:], _New(value))
        else:
            _noted(changes, keys, _New(value))
    if recipe is not None and parameters:
        built = recipe.build({**recipe.parameters, **_below(model, recipe.all, parameters)})
        model = changed(built, recipe.changes) if recipe.changes else built
        recipe = replace(recipe, parameters=cast("Recipe", built.recipe).parameters)
    found = Model(**_changed(model, model, changes)) if changes or not parameters else model
    if recipe is not None:
        recipe.noted(found, tuple((keys, value) for keys, value in settings if keys[0] != recipe.name))
    found.__dict__["origin"] = first[0], first[1].union(keys for keys, _ in settings)
    return found


def origin(model: Model) -> tuple[Model, frozenset[Keys]]:
    """The model from which another came by `changed` alone, and the keys of what is not as there; of others itself and none.

    >>> import kinetruss as kt
    >>> model = kt.library.mechanisms.four_bar()
    >>> first, keys = origin(set_value(set_value(model, "nodes.B.mass", 1), "nodes.B.mass", 2))
    >>> first is model, list(keys)
    (True, [('nodes', 'B', 'mass')])
    """
    found: tuple[Model, frozenset[Keys]] = model.__dict__.get("origin", (model, frozenset()))
    return found


@dataclass(frozen=True, slots=True)
class _New:
    """A new value for a place in the data."""

    value: Any


def _noted(changes: dict[str | int, Any], keys: Keys, new: _New) -> None:
    *before, last = keys
    here: Any = changes
    for key in before:
        here = here if isinstance(here, _New) else here.setdefault(key, {})
    if isinstance(here, _New) or last in here:
        raise ModelError(
            [Fault(keys, f"{'.'.join(map(str, keys))!r} sets what another path sets too.", "Leave one of them out.")]
        )
    here[last] = new


def given(value: Any) -> Any:
    """A value as read from a file."""
    if not isinstance(value, str):
        return value
    if value.strip() in ("~", "null"):
        return None
    if value.lstrip()[:1] in ("[", "{"):
        tree, _ = parse_yaml(value)
        return plain(tree) if tree is not None else None
    return value


def resolved(model: Model, path: str) -> Keys:
    """The keys of a path, with names that contain dots joined, and names of other tables resolved."""
    here: Any = model
    keys: list[str | int] = []
    rest = path.split(".")
    if len(rest) > 1 and (recipe := model.recipe) is not None and rest[0] == recipe.name:
        return _parameter(recipe, rest)
    if rest[0] in ("library", "parameters"):
        what = "a library model" if rest[0] == "library" else "parameters"
        mend = "Set a value of the model itself, e.g. nodes.B.mass; in Python: kt.library.parametric."
        raise ModelError([Fault((rest[0],), f"the model was not built from {what}.", mend)])
    while rest:
        key, rest = _next(here, rest, keys)
        keys.append(key)
        if not isinstance(here, Record):
            here = here[key]
            continue
        record, here = here, within(model, here, str(key)) if rest else getattr(here, str(key))
        named = [one for one, _, place in names_in(record) if place == (key,)] if rest and isinstance(here, str) else []
        if named and (home := [table for table in named[0].tables if here in getattr(model, table)]):
            keys, here = [home[0], here], getattr(model, home[0])[here]
    return tuple(keys)


def within(model: Model, record: Record, key: str) -> Any:
    """The value of a field; of a section or material that is not given that of the model, which then applies."""
    own = getattr(record, key)
    return getattr(model, f"{key}_of")(record) if own is None and key in ("section", "material") else own


def _parameter(recipe: Recipe, path: Sequence[str]) -> Keys:
    """The keys of the path of a parameter."""
    keys: list[str | int] = [recipe.name]
    here: Any = recipe.all
    for name in path[1:]:
        key: str | int = int(name) if isinstance(here, Sequence) and not isinstance(here, str) and name.isdecimal() else name
        if isinstance(key, int) and key < len(here):
            here = here[key]
        elif isinstance(here, Mapping) and (key in here or len(keys) > 1):
            here = here.get(key)
        elif isinstance(here, Record) and key in type(here).model_fields:
            here = getattr(here, str(key))
        elif isinstance(here, Mapping | Record):
            known = here if isinstance(here, Mapping) else type(here).model_fields
            raise ModelError([Fault((*keys, key), f"{name!r} is not known here.", nearest(name, known))])
        else:
            mend = f"Set it as a whole: {'.'.join(map(str, keys))}={{...}}."
            what = "is not a table in the file." if recipe.name == "library" else "has no parts."
            raise ModelError([Fault(tuple(keys), what, mend)])
        keys.append(key)
    return tuple(keys)


def _next(here: Any, rest: list[str], before: Sequence[str | int]) -> tuple[str | int, list[str]]:
    """The longest known name at the start of the rest of a path, and the remaining parts."""
    if isinstance(here, Sequence) and not isinstance(here, str):
        if rest[0].isdecimal() and int(rest[0]) < len(here):
            return int(rest[0]), rest[1:]
        known: Any = range(len(here))
    elif isinstance(here, Record):
        known = type(here).model_fields
    elif isinstance(here, Mapping):
        known = here
    else:
        message = "is not set." if here is None else "has no parts."
        mend = "Set it as a whole, e.g. '{...}'." if here is None else f"End the path at {'.'.join(map(str, before))}."
        raise ModelError([Fault(tuple(before), message, mend)])
    for count in range(len(rest), 0, -1):
        name = ".".join(rest[:count])
        if name in known:
            return name, rest[count:]
    places = [] if before else list(_places(here, ".".join(rest)))
    mend = f"Did you mean {', '.join(places[:3])}?" if places else nearest(rest[0], known)
    raise ModelError([Fault((*before, rest[0]), f"{rest[0]!r} is not known here.", mend)])


def fitting(model: Model, pattern: str) -> list[str]:
    """The paths that fit a pattern: its second word may have stars and [..] choices, which stand for the names of a table.

    Raises
    ------
    InputError : none fits.

    >>> import kinetruss as kt
    >>> fitting(kt.library.mechanisms.four_bar(), "bars.c*.length")
    ['bars.crank.length', 'bars.coupler.length']
    """
    if not isinstance(pattern, str):
        raise InputError(f"{pattern!r} is no path. Write for example 'bars.M1.section.area'.")
    if not any(sign in pattern for sign in "*?["):
        return [pattern]
    table, _, rest = pattern.partition(".")
    names, parts = list(getattr(model, table, ()) or ()), rest.split(".")
    for count in range(len(parts), 0, -1):  # names may have dots
        if found := matched(names, ".".join(parts[:count])):
            return [".".join([table, name, *parts[count:]]) for name in found]
    raise InputError(f"No part of the model fits {pattern!r}. {table} has: {few(names, 8) or 'nothing'}.")


def number_at(model: Model, path: str, keys: Keys) -> float:
    """The number at a path, whose keys are `resolved`.

    Raises
    ------
    InputError : there is none.

    >>> import kinetruss as kt
    >>> number_at(kt.library.mechanisms.four_bar(), "nodes.B.at.1", ("nodes", "B", "at", 1))
    0.1
    """
    here: Any = model
    recipe = model.recipe
    if recipe is not None and keys[0] == recipe.name:
        here, keys = recipe.all, keys[1:]
    for key in keys:
        here = within(model, here, str(key)) if hasattr(type(here), "model_fields") else here[key]
    if isinstance(here, str) and NUMBER.match(here):  # of a parameter, as a file has it
        with suppress(UnitError):
            return float(parse(here, "measure"))
    if isinstance(here, bool) or not isinstance(here, int | float):
        said = "is not set" if here is None else "is no number"
        raise InputError(f"{path} {said}, so it cannot vary. Name one number that the model has.")
    return float(here)


def _places(here: Any, end: str, path: str = "") -> Iterator[str]:
    """Paths in a model that end with a text."""
    entries = {name: getattr(here, name) for name in type(here).model_fields} if isinstance(here, Record) else here
    if isinstance(entries, Mapping):
        for name, one in entries.items():
            whole = f"{path}.{name}".lstrip(".")
            if whole.endswith(f".{end}"):
                yield whole
            yield from _places(one, end, whole)


def _below(model: Model, here: Mapping[str, Any], changes: Mapping[Any, Any]) -> dict[str, Any]:
    """The changed ones of some parameters."""
    return {key: _changed(model, here.get(key), below) for key, below in changes.items()}


def _changed(model: Model, here: Any, changes: Any) -> Any:
    """The data of a record, table or list of a model with the changes."""
    if isinstance(changes, _New):
        return changes.value
    if isinstance(here, Record):
        own = {str(key): _changed(model, within(model, here, str(key)), below) for key, below in changes.items()}
        return fields(here) | own
    if isinstance(here, Mapping):
        return {**here, **_below(model, here, changes)}
    return [_changed(model, item, changes[index]) if index in changes else item for index, item in enumerate(here)]
