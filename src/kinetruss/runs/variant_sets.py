"""Variants of a model: all combinations of values, set by path."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError, ModelError
from kinetruss.io import MAX_SIZE, read, set_values
from kinetruss.limits import MOST_VARIANTS, hold
from kinetruss.model import Model

Settings = Mapping[str, Sequence[Any]]

LONGEST = 100
"""Largest number of characters in a variant's name, which is the name of a folder."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """One combination of values. name : also the name of its folder. settings : path -> value as text."""

    name: str
    settings: Mapping[str, str]
    model: Model


def variants(model: Model | str | Path, settings: Settings) -> dict[str, Model]:
    """All combinations of values for some settings, each as a model.

    Parameters
    ----------
    model : a model, or a model file.
    settings : dotted path -> values, as for `io.set_value`, e.g. ``{"runs.extend.trajectory.duration": [3, "5 s"]}``.

    Returns
    -------
    Name -> model, the last path varying fastest. A name has the values of the paths with several values, e.g.
    ``duration=3_payload_mass=10kg``; each path is shortened to its shortest unique end.

    Raises
    ------
    ModelError : an unknown path (the message offers the nearest names); a value that does not fit, with its fix.
    InputError : a path without values, or a value given twice.

    Examples
    --------
    >>> import kinetruss as kt
    >>> found = variants(kt.library.vgt.triangular(), {"nodes.B.mass": ["10 kg", "40 kg"], "gravity": ["~"]})
    >>> [(name, one.nodes["B"].mass, one.gravity) for name, one in found.items()]
    [('mass=10kg', 10.0, None), ('mass=40kg', 40.0, None)]
    """
    return {variant.name: variant.model for variant in spread(model, settings)}


def spread(model: Model | str | Path, settings: Settings, max_size: int = MAX_SIZE) -> list[Variant]:
    """The combinations of `variants`, with the values set in each."""
    for path, values in settings.items():
        if isinstance(values, str) or not len(values):
            raise InputError(f"{path} has no list of values. Give for example {path}=3,5,10.")
        if len(set(map(str, values))) < len(values):
            raise InputError(f"{path} has a value twice: {', '.join(map(str, values))}. Leave one out.")
    count = math.prod(len(values) for values in settings.values())
    hold(count, "This grid of settings", "Give fewer values.", most=MOST_VARIANTS, of="variants")
    base = Base(model, max_size)
    chosen = [dict(zip(settings, values, strict=True)) for values in itertools.product(*settings.values())]
    names = _names(settings, chosen)
    return [
        Variant(name=name, settings={path: str(value) for path, value in values.items()}, model=base.with_(values))
        for name, values in zip(names, chosen, strict=True)
    ]


class Base:
    """The base of the variants."""

    def __init__(self, model: Model | str | Path, max_size: int) -> None:
        # reports faults of the file itself before anything is set
        self._model = model if isinstance(model, Model) else read(model, max_size=max_size)

    def with_(self, values: Mapping[str, Any]) -> Model:
        """The model with these values."""
        try:
            return self._changed(values)
        except ModelError as error:
            raise _blamed(error, values, self._changed) from None

    def _changed(self, values: Mapping[str, Any]) -> Model:
        return set_values(self._model, values) if values else self._model


def _blamed(error: ModelError, values: Mapping[str, Any], change: Any) -> ModelError:
    """The faults, assigned to the setting that causes them by itself, or to all settings."""
    for path, value in values.items():
        try:
            change({path: value})
        except ModelError as alone:
            return _with_setting(alone, f"{path}={value}")
    return _with_setting(error, ", ".join(f"{path}={value}" for path, value in values.items()))


def _with_setting(error: ModelError, setting: str) -> ModelError:
    # no position in the file: the file has another value there
    return ModelError([replace(fault, line=None, column=None, file=None) for fault in error.faults], setting)


def _names(settings: Settings, chosen: Sequence[Mapping[str, Any]]) -> list[str]:
    """A name for each combination: valid as a folder, and unique also on file systems that ignore case."""
    several = [path for path, values in settings.items() if len(values) > 1] or list(settings)
    keys = short_paths(several)
    found: list[str] = []
    taken: set[str] = set()
    for values in chosen:
        name = stem = "_".join(f"{_safe(keys[path])}={_safe(str(values[path]))}" for path in several)[:LONGEST]
        count = 1
        while name.casefold() in taken:
            count += 1
            name = f"{stem}~{count}"
        taken.add(name.casefold())
        found.append(name)
    return found


def short_paths(paths: Sequence[str]) -> dict[str, str]:
    """For each path its shortest end that is not only a number and that no other path has.

    >>> short_paths(["nodes.B.mass", "nodes.C.mass", "runs.a.trajectory.duration", "nodes.B.at.0"])
    {'nodes.B.mass': 'B.mass', 'nodes.C.mass': 'C.mass', 'runs.a.trajectory.duration': 'duration', 'nodes.B.at.0': 'at.0'}
    """
    found = {}
    for path in paths:
        parts = path.split(".")
        others = [other.split(".") for other in paths if other != path]
        for count in range(1, len(parts) + 1):
            end = parts[-count:]
            if not end[0].isdecimal() and all(other[-count:] != end for other in others):
                break
        found[path] = ".".join(end)
    return found


def _safe(text: str) -> str:
    """A text as part of a folder name: letters, digits, signs, dots, commas; no special character of a shell or file system."""
    return re.sub(r"[^\w.,+-]+", "-", re.sub(r"\s+", "", text).strip("[]{}~")).rstrip("-.") or "none"
