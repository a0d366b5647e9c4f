"""Meshes: in by meshio; out as VTU and PVD, and bodies and bars in a pose as STL."""

from __future__ import annotations

import io
import struct
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET
from xml.etree.ElementTree import ParseError

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.exchange.drawings import length_of, model_of, supported_nodes
from kinetruss.exchange.imported import Imported, needed
from kinetruss.exchange.robots import LeftOut
from kinetruss.library.mesh_arrays import mesh
from kinetruss.limits import LARGEST
from kinetruss.model import Bar, Model
from kinetruss.model.members import Brace

if TYPE_CHECKING:
    from numpy.typing import NDArray


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
    model = model_of(str(path), places, bars, supported_nodes(fixed, places, str(path)), **tables)
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


# VTU of a model in a pose, and PVD with one VTU for each instant of a run, for ParaView and meshio.


def write_vtu(
    path: Path, model: Model, x: NDArray[np.float64], *, vectors: Mapping[str, Any], forces: Any = None
) -> list[LeftOut]:
    """Write bars and active members as lines, membranes as triangles, solids as tetrahedra. x (n, 3), m.

    vectors : name -> (n, dim) at the nodes. forces : (members,) N in bars and active members, or None. Cells have ``member``,
    the number of the member in the model (-1: none), and ``force``, N.
    """
    meshio = needed("meshio", "exchange")
    place = {name: k for k, name in enumerate(model.whole.nodes)}
    lines = np.array([[place[node] for node in member.ends] for member in model.whole.members.values()], np.int64).reshape(
        -1, 2
    )
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
    left += [LeftOut("links", name, "links are not carried") for name in model.links]
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


# STL of the bodies and bars of a model in a pose: bars as prisms, bodies as the convex hulls of their nodes.

SIDES = 16
"""Of the prism that stands for a round bar."""
THIN = 0.005
"""Radius of a bar without section, relative to the size of the model."""
_ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def stl_bytes(model: Model, x: NDArray[np.float64]) -> tuple[bytes, list[LeftOut]]:
    """A binary STL, lengths in m, and the parts without a shape. x (n, 3), m."""
    left: list[LeftOut] = []
    triangles = [*_bodies(model, x, left), *_bars(model, x, left)]
    for table in ("beams", "membranes", "solids"):
        left += [LeftOut(table, name, "only bodies and bars have a shape") for name in getattr(model, table)]
    corners = np.concatenate(triangles) if triangles else np.zeros((0, 3, 3))
    rows = np.zeros(len(corners), _ROW)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    rows["normal"] = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    rows["corners"] = corners
    head = b"kinetruss, lengths in m".ljust(80)
    return head + len(rows).to_bytes(4, "little") + rows.tobytes(), left


def _bodies(model: Model, x: Any, left: list[LeftOut]) -> Iterator[NDArray[np.float64]]:
    from scipy.spatial import ConvexHull, QhullError

    whole = model.whole
    place = {name: k for k, name in enumerate(whole.nodes)}
    for name, body in whole.bodies.items():
        points = x[[place[node] for node in body.nodes]]
        try:
            hull = ConvexHull(points)
        except (QhullError, ValueError):
            left.append(LeftOut("body", whole.inner.part_of(name), "its nodes span no volume"))
            continue
        faces = points[hull.simplices]
        outward = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
        inside = np.einsum("ij,ij->i", outward, hull.equations[:, :3]) < 0
        faces[inside] = faces[inside][:, [0, 2, 1]]
        yield faces


def _bars(model: Model, x: Any, left: list[LeftOut]) -> Iterator[NDArray[np.float64]]:
    """Prisms along bars and active members; braces are part of their body."""
    place = {name: k for k, name in enumerate(model.whole.nodes)}
    size = float(np.ptp(x, axis=0).max()) or 1.0
    for name, member in model.whole.members.items():
        if isinstance(member, Brace):
            continue
        a, b = (x[place[node]] for node in member.ends)
        if not np.linalg.norm(b - a) > 0:
            left.append(LeftOut("member", name, "has no length in this pose"))
            continue
        section = model.section_of(getattr(member, "tube", member))
        radius = _radius(section) or THIN * size
        yield _prism(a, b, radius)


def _radius(section: Any) -> float:
    """Of the circle around a section, m; 0 without one of known shape."""
    if (outer := getattr(section, "outer", None) or getattr(section, "diameter", None)) is not None:
        return 0.5 * float(outer)
    if hasattr(section, "width"):
        return 0.5 * float(np.hypot(section.width, section.height))
    return 0.0


def _prism(a: Any, b: Any, radius: float) -> NDArray[np.float64]:
    """A closed prism of `SIDES` sides between two points, all triangles outwards."""
    along = (b - a) / np.linalg.norm(b - a)
    u = np.cross(along, np.eye(3)[int(np.argmin(np.abs(along)))])
    u /= np.linalg.norm(u)
    v = np.cross(along, u)
    turns = 2 * np.pi * np.arange(SIDES) / SIDES
    ring = radius * (np.cos(turns)[:, None] * u + np.sin(turns)[:, None] * v)
    low, high = a + ring, b + ring
    low_, high_ = np.roll(low, -1, axis=0), np.roll(high, -1, axis=0)
    ends = [np.broadcast_to(point, low.shape) for point in (a, b)]
    sides = [(low, low_, high_), (low, high_, high), (ends[0], low_, low), (ends[1], high, high_)]
    return np.concatenate([np.stack(one, axis=1) for one in sides])
