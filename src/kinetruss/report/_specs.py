"""What a figure shows, as plain arrays: collected from results in one place, drawn in another."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["Bars", "Figure", "Histories", "Panel", "Pose", "Shape"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Panel:
    """Curves over time that share one axis.

    lines : label -> values (times,), in `unit`. dashed : the same, drawn thin and dashed (a comparison).
    band : least and largest of all members at each instant. limit : largest magnitude allowed, drawn as a level line.
    times : label -> its own time axis, where it differs from the figure's.
    """

    quantity: str
    unit: str
    lines: dict[str, Array]
    dashed: dict[str, Array] = field(default_factory=dict)
    band: tuple[Array, Array] | None = None
    limit: float | None = None
    times: dict[str, Array] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Histories:
    """Panels above each other over one time axis (s)."""

    name: str
    title: str
    time: Array
    panels: tuple[Panel, ...]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Bars:
    """Level bars, worst first; `notes` stand beside them; `limit` is drawn as a line."""

    name: str
    title: str
    quantity: str
    labels: tuple[str, ...]
    values: Array
    notes: tuple[str, ...]
    limit: float = 1.0


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Pose:
    """One configuration: caption and node positions (n_nodes, dim), m."""

    caption: str
    position: Array


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Shape:
    """The structure at some instants: members as pairs of node indices, which of them are driven, held nodes."""

    name: str
    title: str
    nodes: tuple[str, ...]
    ends: tuple[tuple[int, int], ...]
    driven: tuple[bool, ...]
    held: tuple[int, ...]
    poses: tuple[Pose, ...]


Figure = Histories | Bars | Shape
