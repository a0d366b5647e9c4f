"""A model from a file of another program; the suffix says which reader. Slow readers are imported when one is read."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError, ModelError
from kinetruss.exchange.imported import Imported
from kinetruss.io import MAX_SIZE


@dataclass(frozen=True, slots=True)
class Reader:
    """The module of a reader in this package, its function, and the options that it takes."""

    module: str
    function: str
    options: tuple[str, ...] = ()

    def read(self, path: Path, **options: Any) -> Imported:
        """The file as a model."""
        module = importlib.import_module(f"kinetruss.exchange.{self.module}")
        function: Callable[..., Imported] = getattr(module, self.function)
        return function(path, **options)


_ROBOT = Reader("robot_files", "robot", ("closures", "at", "floating", "progress"))
_MESH = Reader("meshes", "mesh_file", ("unit", "fixed", "thickness", "material"))

READERS: Mapping[str, Reader] = {
    ".urdf": _ROBOT,
    ".xml": _ROBOT,
    ".mjcf": _ROBOT,
    ".dxf": Reader("dxf", "dxf", ("unit", "tolerance", "active", "fixed", "motor", "skip", "arcs", "hidden")),
    ".csv": Reader("drawings", "tables", ("members", "fixed")),
    ".json": Reader("compas", "compas", ("unit", "fixed")),
    **dict.fromkeys((".vtu", ".vtk", ".msh", ".inp", ".xdmf", ".obj", ".ply", ".stl", ".bdf", ".mesh"), _MESH),
}
"""Suffix -> reader."""


# A model from a file of another program; the suffix says which.


def read(path: str | Path, *, max_size: int = MAX_SIZE, **options: Any) -> Imported:
    """Read a model from a file of another program.

    Parameters
    ----------
    path : ``.urdf``; ``.xml`` or ``.mjcf`` (MJCF, or URDF); ``.dxf``; ``.csv`` (nodes; `members` names the other table);
        ``.json`` (COMPAS); ``.vtu``, ``.vtk``, ``.msh``, ``.inp`` and other meshes (meshio).
    max_size : bytes; a larger file is refused before it is read.
    options : of the format. Robots: ``closures`` (file beside a URDF), ``at`` (joint -> value, rad or m, of the pose),
        ``floating`` (the base of a URDF is not fixed), ``progress`` (called with bodies done and all bodies). DXF: ``unit`` (of
        a drawing that names none), ``tolerance`` (m, of nodes that are one), patterns of layers ``active`` (bars whose length
        changes), ``motor`` (bars that motors turn), ``fixed`` (marks of supports) and ``skip``, ``arcs`` (bars of a whole turn
        of a curve). CSV: ``members`` (path), ``fixed`` (names of nodes). COMPAS: ``unit``, ``fixed``. Meshes: these,
        ``material``, ``thickness``.

    Returns
    -------
    Imported : the model, and all of the file that it does not have.

    Raises
    ------
    ModelError : faults of the file, with line or element. InputError : an unknown suffix or option, or a package of the extra
        ``exchange`` or ``mesh`` that is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> import kinetruss as kt
    >>> Path("arm.urdf").write_text('''<robot name="arm"><link name="base"/><link name="arm"><inertial><mass value="2"/>
    ... <origin xyz="0.3 0 0"/><inertia ixx="0.01" iyy="0.07" izz="0.07" ixy="0" ixz="0" iyz="0"/></inertial></link>
    ... <joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/></joint>
    ... </robot>''') > 0
    True
    >>> found = kt.exchange.read("arm.urdf")
    >>> found.freedoms, list(found.model.drives)
    (1, ['shoulder'])
    >>> Path("arm.urdf").unlink()
    """
    path = Path(path)
    suffix = path.suffix.lower()
    reader = READERS.get(suffix)
    if suffix == ".xacro":
        raise InputError(
            f"{path} holds macros of xacro, which are not read. Expand them first: xacro {path.name} -o robot.urdf."
        )
    if reader is None:
        raise InputError(f"{path} has the suffix {path.suffix!r}. Files that are read: {', '.join(READERS)}.")
    unknown = [name for name, value in options.items() if name not in reader.options and value not in (None, (), {}, [], False)]
    if unknown:
        has = ", ".join(reader.options) or "none"
        raise InputError(f"{path}: a {suffix} file has no option {unknown[0]!r}. It has: {has}.")
    given = {name: value for name, value in options.items() if name in reader.options and value is not None}
    try:
        return reader.read(path, max_size=max_size, **given)
    except ModelError as error:
        raise ModelError(error.faults, error.source or str(path)) from None
