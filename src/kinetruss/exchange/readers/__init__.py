"""Readers of files of other programs, by suffix. What is slow to import is imported when a file of its kind is read."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.exchange._imported import Imported

__all__ = ["READERS", "Reader"]


@dataclass(frozen=True, slots=True)
class Reader:
    """The module of a reader in this folder, its function, and the options that it takes."""

    module: str
    function: str
    options: tuple[str, ...] = ()

    def read(self, path: Path, **options: Any) -> Imported:
        """The file as a model."""
        module = importlib.import_module(f"kinetruss.exchange.readers.{self.module}")
        function: Callable[..., Imported] = getattr(module, self.function)
        return function(path, **options)


_ROBOT = Reader("robot_formats.robot_files", "robot", ("closures", "at", "floating", "progress"))
_MESH = Reader("mesh_files", "mesh_file", ("unit", "fixed", "thickness", "material"))

READERS: Mapping[str, Reader] = {
    ".urdf": _ROBOT,
    ".xml": _ROBOT,
    ".mjcf": _ROBOT,
    ".dxf": Reader("dxf", "dxf", ("unit", "tolerance", "active", "fixed", "motor", "skip", "arcs", "hidden")),
    ".csv": Reader("tables", "tables", ("members", "fixed")),
    ".json": Reader("compas", "compas", ("unit", "fixed")),
    **dict.fromkeys((".vtu", ".vtk", ".msh", ".inp", ".xdmf", ".obj", ".ply", ".stl", ".bdf", ".mesh"), _MESH),
}
"""Suffix -> reader."""
