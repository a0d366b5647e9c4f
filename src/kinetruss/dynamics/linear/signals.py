"""Inputs and outputs of a linearised structure, by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics.freedom import Coordinate, coordinates, derivatives_of, is_prescribed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["Input", "Names", "Output", "inputs_of", "outputs_of", "unit_load_of"]

Names = str | Iterable[str] | Mapping[str, str | Mapping[str, float]]
"""Names, or labels of names, or labels of sums: {"base": {"N1.z": 1, "N2.z": 1}}."""


@dataclass(frozen=True, slots=True)
class Input:
    """A force on coordinates, the motion of prescribed ones, or the commanded length of drives that give way.

    Each has a factor; that of a commanded length is the stiffness in series, N/m: it acts as this force on its member.
    """

    label: str
    kind: Literal["force", "motion", "command"]
    parts: tuple[tuple[Coordinate, float], ...]

    @property
    def unit(self) -> str:
        """SI unit."""
        own = self.parts[0][0].unit
        return "N m" if self.kind == "force" and own == "rad" else "N" if self.kind == "force" else own

    @property
    def columns(self) -> list[tuple[str, str]]:
        """Name and unit of its columns in B: one force or commanded length, or value, rate and second rate."""
        if self.kind != "motion":
            return [(self.label, self.unit)]
        return [(self.label + mark, self.unit + per) for mark, per in (("", ""), ("'", "/s"), ("''", "/s^2"))]


@dataclass(frozen=True, slots=True)
class Output:
    """A coordinate (order 0), its rate (1) or second rate (2), or the force of a member, a drive or a support."""

    label: str
    kind: Literal["motion", "force"]
    order: int
    parts: tuple[tuple[Coordinate, float], ...]

    @property
    def unit(self) -> str:
        """SI unit."""
        own = self.parts[0][0].unit
        if self.kind == "force":
            return "N m" if own == "rad" else "N"
        return own + ("", "/s", "/s^2")[self.order]


def inputs_of(system: System, names: Names, springs: Mapping[int, float]) -> list[Input]:
    """Inputs of a system without the rows of released drives; springs : stiffness of drives that give way, by member, N/m.

    Raises
    ------
    InputError : unknown names; a sum of forces and prescribed motions, or of metres and radians.
    """
    found = []
    for label, parts in _listed(system, names):
        kinds = {_kind(system, one, springs) for one, _ in parts}
        if len(kinds) > 1 or len({one.unit for one, _ in parts}) > 1:
            raise InputError(
                f"Input {label!r} adds different quantities (forces, prescribed motions, angles). Make separate inputs of them."
            )
        if any(one.kind == "pose" for one, _ in parts):
            raise InputError(f"Input {label!r} is a pose coordinate. Name nodes, lengths or angles.")
        kind = kinds.pop()
        if kind == "command":
            parts = [(one, factor * springs[one.index]) for one, factor in parts]
        found.append(Input(label, kind, tuple(parts)))
    return found


def _kind(system: System, one: Coordinate, springs: Mapping[int, float]) -> Literal["force", "motion", "command"]:
    if one.kind == "length" and one.index in springs:
        return "command"
    return "motion" if is_prescribed(system, one) else "force"


def outputs_of(system: System, names: Names) -> list[Output]:
    """Outputs: coordinates, with ' and '' for rates, or NAME.force.

    Raises
    ------
    InputError : unknown names; a force that nothing carries.
    """
    found: list[Output] = []
    for label, given in _items(names):
        sums = [(_signal(system, text), factor) for text, factor in given]
        (ones, kind, order), factor = sums[0]
        if len(given) == 1 and label == given[0][0] and len(ones) > 1:
            mark = label[label.index(".force") :] if kind == "force" else "'" * order
            found += [Output(one.name + mark, kind, order, ((one, factor),)) for one in ones]
            continue
        parts = tuple((one, factor) for (ones, _, _), factor in sums for one in ones)
        if len({(kind, order) for (_, kind, order), _ in sums}) > 1 or len({one.unit for one, _ in parts}) > 1:
            raise InputError(
                f"Output {label!r} adds different quantities (forces, rates, angles). Make separate outputs of them."
            )
        found.append(Output(label, kind, order, parts))
    if len({one.label for one in found}) < len(found):
        raise InputError("An output is named twice. Name each once.")
    return found


def unit_load_of(system: System, one: Input, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Nodal forces (3 n,) of a unit of a force input, at positions x (n, 3)."""
    found = derivatives_of(system, [part for part, _ in one.parts], x)
    factor = np.array([factor for _, factor in one.parts])
    return np.asarray(found.g[0].T @ (factor / found.r[:, 0]))


def _signal(system: System, text: str) -> tuple[list[Coordinate], Literal["motion", "force"], int]:
    """Coordinates, kind and order of an output by name."""
    name = text.rstrip("'")
    order = len(text) - len(name)
    force = name.endswith(".force")
    if order > 2 or (force and order):
        raise InputError(f"Output {text!r}: write a coordinate, with ' for its rate or '' for its second rate, or NAME.force.")
    ones = coordinates(system, name.removesuffix(".force"))
    for one in ones:
        if force and one.kind != "length" and (one.kind == "pose" or not is_prescribed(system, one)):
            raise InputError(f"Output {text!r}: nothing carries a force there. Name a member, a support or a held drive.")
    return ones, "force" if force else "motion", order


def _items(names: Names) -> list[tuple[str, list[tuple[str, float]]]]:
    """Labels with their names and factors."""
    if isinstance(names, str):
        return [(names, [(names, 1.0)])]
    if not isinstance(names, Mapping):
        return [(name, [(name, 1.0)]) for name in names]
    found = []
    for label, given in names.items():
        parts = [(given, 1.0)] if isinstance(given, str) else [(name, float(factor)) for name, factor in given.items()]
        if not parts:
            raise InputError(f"{label!r} names nothing. Give at least one coordinate.")
        found.append((label, parts))
    return found


def _listed(system: System, names: Names) -> list[tuple[str, list[tuple[Coordinate, float]]]]:
    """Labels with their coordinates; a node without an axis stands for one entry an axis."""
    found: list[tuple[str, list[tuple[Coordinate, float]]]] = []
    for label, given in _items(names):
        ones = [(one, factor) for name, factor in given for one in coordinates(system, name)]
        if len(given) == 1 and label == given[0][0] and len(ones) > 1:
            found += [(one.name, [(one, factor)]) for one, factor in ones]
        else:
            found.append((label, ones))
    if len({label for label, _ in found}) < len(found):
        raise InputError("An input is named twice. Name each once.")
    return found
