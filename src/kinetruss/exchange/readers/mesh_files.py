"""A model from a mesh that meshio reads: lines become bars, triangles a membrane, tetrahedra a solid."""

from __future__ import annotations

import io
import struct
import zlib
from collections.abc import Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import ParseError

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.exchange._imported import Imported
from kinetruss.exchange._needed import needed
from kinetruss.exchange.readers.trusses import held, length_of, model_of
from kinetruss.exchange.robots import LeftOut
from kinetruss.library.meshes import mesh
from kinetruss.limits import LARGEST
from kinetruss.model import Bar

__all__ = ["mesh_file"]

BROKEN = (
    ArithmeticError, AssertionError, AttributeError, EOFError, LookupError, MemoryError, OSError, RuntimeError, TypeError,
    ValueError, ParseError, struct.error, zlib.error,
)  # fmt: skip
"""What the readers of meshio raise for broken files, besides their own errors and the end of the program."""


def mesh_file(
    path: Path, *, max_size: int, unit: str = "m", fixed: Sequence[str] = (), thickness: str | float | None = None,
    material: str | None = None,
) -> Imported:  # fmt: skip
    """The model of a mesh. unit : of its lengths. thickness : of the membrane of its triangles. material : of the library."""
    found, scale = _opened(path, max_size), length_of(unit, "unit")
    if np.ndim(found.points) != 2 or np.shape(found.points)[1] not in (2, 3):
        raise _fault(
            path, f"has points of the shape {np.shape(found.points)}; expected three numbers each.", "Repair the mesh."
        )
    points = np.zeros((len(found.points), 3))
    points[:, : np.shape(found.points)[1]] = np.asarray(found.points, float) * scale
    cells = {kind: np.asarray(rows) for kind, rows in found.cells_dict.items()}
    for kind, rows in cells.items():
        if rows.size and (rows.dtype.kind not in "iu" or rows.min() < 0 or rows.max() >= len(points)):
            raise _fault(path, f"cells of kind {kind} name points that are not there.", "Repair the mesh.")
    if not (np.abs(points) <= LARGEST).all():
        raise _fault(path, "has points that are not finite.", "Repair the mesh.")
    tables, left = _meshes(path, points, cells, thickness, material)
    pairs = np.concatenate([cells.get("line", np.zeros((0, 2), int)), *([_sides(cells["line3"])] if "line3" in cells else [])])
    ends = dict.fromkeys(tuple(sorted(pair)) for pair in pairs.tolist() if pair[0] != pair[1])
    bars = {f"n{a}-n{b}": Bar(ends=(f"n{a}", f"n{b}")) for a, b in ends}
    used = sorted({k for pair in ends for k in pair} | {k for rows in tables.pop("used") for k in rows})
    places = {f"n{k}": points[k] for k in used}
    if len(used) < len(points):
        left.append(LeftOut("point", str(path), f"{len(points) - len(used)} points belong to no bar, membrane or solid"))
    model = model_of(str(path), places, bars, held(fixed, places, str(path)), **tables)
    return Imported(model=model, source=str(path), left_out=[*left, *_data(path, found)])


def _fault(path: Path, message: str, mend: str) -> ModelError:
    return ModelError([Fault((), message, mend, file=str(path))])


def _opened(path: Path, max_size: int) -> Any:
    meshio = needed("meshio", "exchange")
    if not path.is_file():
        raise _fault(path, "there is no such file.", "Check the name.")
    if path.stat().st_size > max_size:
        raise _fault(path, f"has more than {max_size:,} bytes.", "Raise --max-size if the file is meant.")
    corrupt: type[Exception] = needed("meshio._exceptions", "exchange").CorruptionError
    said = io.StringIO()
    try:
        with redirect_stdout(said), redirect_stderr(said):
            return meshio.read(path)
    except (*BROKEN, meshio.ReadError, corrupt, SystemExit) as error:
        words = " ".join(str(error).split()) or type(error).__name__
        raise _fault(
            path, f"is no mesh that meshio reads: {words}.", "Give a whole file in the format of its suffix."
        ) from None


def _meshes(
    path: Path, points: Any, cells: dict[str, Any], thickness: str | float | None, material: str | None
) -> tuple[dict[str, Any], list[LeftOut]]:
    """Tables of membranes and solids, with the points that they use, and the cells that no model has."""
    tables: dict[str, Any] = {"used": []}
    known = ("line", "line3", "triangle", "triangle6", "tetra")
    left = [LeftOut(f"{kind} cells", str(path), f"{len(rows)} cells of a kind that is not carried")
            for kind, rows in cells.items() if kind not in known]  # fmt: skip
    for kind in ("tetra", "triangle6", "triangle"):
        if kind not in cells or not len(cells[kind]):
            continue
        if kind != "tetra" and "solids" in tables:
            left.append(LeftOut("triangle cells", str(path), "are taken as the surface of the solid"))
            continue
        if material is None or (kind != "tetra" and thickness is None):
            wanted = "--material NAME" if kind == "tetra" else "--material NAME and --thickness"
            raise InputError(f"{path}: cells of kind {kind} need {wanted}. Materials of the library: steel_s235, ...")
        flat = kind != "tetra" and not points[:, 2].any()
        made = mesh(points[:, :2] if flat else points, cells[kind])
        number = np.unique(cells[kind])
        made = made.renamed({name: f"n{k}" for name, k in zip(made.names, number.tolist(), strict=True)})
        tables["used"].append(number.tolist())
        if kind == "tetra":
            tables["solids"] = {"solid": made.solid(material=material)}
        else:
            skin = made.membrane(material=material, thickness=length_of(thickness or 0.0, "thickness"))
            tables["membranes"] = {**tables.get("membranes", {}), "skin" if kind == "triangle" else "skin6": skin}
    return tables, left


def _sides(rows: Any) -> Any:
    """Both halves of lines with a node in their middle."""
    return np.concatenate([rows[:, [0, 2]], rows[:, [2, 1]]])


def _data(path: Path, found: Any) -> list[LeftOut]:
    names = [*found.point_data, *found.cell_data, *found.field_data]
    return [LeftOut(f"data {name}", str(path), "values on points and cells are not carried") for name in names]
