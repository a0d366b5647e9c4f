"""VTU of a model in a pose, and PVD with one VTU for each instant of a run, for ParaView and meshio."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import numpy as np

from kinetruss.exchange._needed import needed
from kinetruss.exchange.robots import LeftOut
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["pvd_text", "write_vtu"]


def write_vtu(
    path: Path, model: Model, x: NDArray[np.float64], *, vectors: Mapping[str, Any], forces: Any = None
) -> list[LeftOut]:
    """Write bars and active members as lines, membranes as triangles, solids as tetrahedra. x (n, 3), m.

    vectors : name -> (n, dim) at the nodes. forces : (members,) N in bars and active members, or None. Cells have ``member``,
    the number of the member in the model (-1: none), and ``force``, N.
    """
    meshio = needed("meshio", "exchange")
    place = {name: k for k, name in enumerate(model.nodes)}
    lines = np.array([[place[node] for node in member.ends] for member in model.members.values()], np.int64).reshape(-1, 2)
    cells: list[tuple[str, Any]] = [("line", lines)] if len(lines) else []
    number = [np.arange(len(lines), dtype=float)] if len(lines) else []
    force = [np.full(len(lines), np.nan) if forces is None else np.asarray(forces, float)] if len(lines) else []
    for table, kinds in ((model.membranes, {3: "triangle", 6: "triangle6"}), (model.solids, {4: "tetra"})):
        for one in table.values():
            rows = np.array([place[node] for node in one.nodes])[np.array(one.elements)]
            cells.append((kinds[rows.shape[1]], rows))
            number.append(np.full(len(rows), -1.0))
            force.append(np.full(len(rows), np.nan))
    if not cells:
        cells, number, force = [("vertex", np.arange(len(x))[:, None])], [np.full(len(x), -1.0)], [np.full(len(x), np.nan)]
    points = {name: _spatial(value) for name, value in vectors.items()}
    data = {"member": number} | ({"force": force} if forces is not None else {})
    meshio.Mesh(x, cells, point_data=points, cell_data=data).write(path, file_format="vtu", binary=True)
    left = [LeftOut("beams", name, "beams are not carried") for name in model.beams]
    return left + [LeftOut("bodies", name, "is carried as the lines of its bars") for name in model.bodies]


def _spatial(value: Any) -> NDArray[np.float64]:
    found = np.zeros((len(value), 3))
    found[:, : np.shape(value)[1]] = value
    return found


def pvd_text(times: Any, names: list[str]) -> str:
    """The collection of the files of all instants; times s."""
    root = ET.Element("VTKFile", type="Collection", version="0.1", byte_order="LittleEndian")
    group = ET.SubElement(root, "Collection")
    for time, name in zip(times, names, strict=True):
        ET.SubElement(group, "DataSet", timestep=repr(float(time)), group="", part="0", file=name)
    ET.indent(root)
    return '<?xml version="1.0"?>\n' + ET.tostring(root, encoding="unicode") + "\n"
