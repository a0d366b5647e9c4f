"""The shaded picture of a scene, drawn by VTK without a display, and its camera."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from kinetruss.display import KINDS, THEMES
from kinetruss.errors import InputError
from kinetruss.model import nearest
from kinetruss.viewer.films.copies import Turned, ball, box, cone, rod

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.viewer.films.copies import Copies
    from kinetruss.viewer.films.shown import Subject

    Array = NDArray[np.float64]


PRESETS = {
    "iso": (0.72, -1.0, 0.42),
    "corner": (0.72, -1.0, 0.42),
    "front": (0.0, -1.0, 0.0),
    "side": (1.0, 0.0, 0.0),
    "top": (0.0, 0.0, 1.0),
}
"""Directions of the presets; ``corner`` is ``iso`` in the page."""
ANGLE = np.radians(24.0)
MARGIN = 0.94


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Camera:
    """A camera at `eye` (m) that looks at `target`; right, upward and backward are unit vectors; wide : width over height."""

    eye: Array
    target: Array
    right: Array
    upward: Array
    backward: Array
    wide: float

    def seen(self, points: Array, width: int, height: int) -> Array:
        """Pixel coordinates (n, 2), from the left and from the top, of points (n, 3)."""
        apart = points - self.eye
        depth = -(apart @ self.backward) * np.tan(ANGLE / 2)
        x, y = apart @ self.right / (depth * self.wide), apart @ self.upward / depth
        return np.column_stack([(1 + x) * width / 2, (1 - y) * height / 2])


def aimed(camera: str | Sequence[float], points: Array, wide: float, dim: int) -> Camera:
    """A camera that shows all points (n, 3) as large as possible.

    camera : a preset, or the direction from the structure to the eye.

    Raises
    ------
    InputError : no such preset; a direction without length.
    """
    backward = _direction(camera, dim)
    up = np.array([0.0, 1.0, 0.0]) if abs(backward[2]) > 0.999 else np.array([0.0, 0.0, 1.0])
    right = np.cross(up, backward)
    right /= np.linalg.norm(right)
    upward = np.cross(backward, right)
    axes = np.stack([right, upward, backward])
    flat = points @ axes.T
    centre = (flat.min(axis=0) + flat.max(axis=0)) / 2
    for _ in range(4):  # in perspective near points look larger, so that the middle of the picture is not that of the box
        x, y, w = (flat - centre).T
        steep = np.tan(ANGLE / 2) * MARGIN
        far = max(float(np.max(np.abs(x) / (steep * wide) + w)), float(np.max(np.abs(y) / steep + w)), 1e-6)
        depth = far - w
        centre[0] += _middle(x / depth) * far
        centre[1] += _middle(y / depth) * far
    x, y, w = (flat - centre).T
    far = max(float(np.max(np.abs(x) / (steep * wide) + w)), float(np.max(np.abs(y) / steep + w)), 1e-6)
    target = centre @ axes
    return Camera(eye=target + far * backward, target=target, right=right, upward=upward, backward=backward, wide=wide)


def _middle(seen: Array) -> float:
    return float(seen.min() + seen.max()) / 2


def _direction(camera: str | Sequence[float], dim: int) -> Array:
    if isinstance(camera, str):
        if camera not in PRESETS:
            raise InputError(f"No camera called {camera!r}. {nearest(camera, PRESETS)}")
        # a plane structure is seen along the normal of its plane by default
        camera = (0.0, 0.0, 1.0) if dim == 2 and camera in ("iso", "corner") else PRESETS[camera]
    found = np.array(camera, float)
    if found.shape != (3,) or not np.isfinite(found).all() or not np.linalg.norm(found) > 0:
        raise InputError(f"camera {tuple(camera)}: give a preset ({', '.join(PRESETS)}) or a direction (x, y, z).")
    direction: Array = found / np.linalg.norm(found)
    return direction


# The shaded picture of a scene, drawn by VTK without a display.

WINDOW = "VTK_DEFAULT_OPENGL_WINDOW"
LARGEST = 8192
"""Largest width and height of a window that all systems support, pixels."""
SEVERAL = 800
"""Number of members above which rods have fewer sides."""
FACE, BODY, EDGE = KINDS["rigid"], THEMES["light"]["body"], THEMES["light"]["edge"]
FINE = 20_000
"""Number of faces above which element edges are not drawn."""


class Stage:
    """An off-screen window; `shoot` returns its picture."""

    def __init__(self, pyvista: Any, subject: Subject, width: int, height: int, fine: int) -> None:
        self._pv = pyvista
        # drawn larger and reduced: smoother than VTK's own methods without a graphics card, in half the time
        self._fine = max(1, min(fine, LARGEST // max(width, height)))
        self._subject = subject
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(self._fine * width, self._fine * height), lighting="none")
        self.plotter.set_background("white")
        self.plotter.add_light(pyvista.Light(light_type="headlight"))
        many = len(subject.ends) > SEVERAL
        sides = 8 if many else 20
        self._shapes = {
            "lines": rod(6),
            "rods": rod(sides),
            "rims": rod(sides, closed=False),
            "cones": cone(sides),
            "balls": ball(sides),
        }
        self._shapes |= {"boxes": box(), "box rims": box(closed=False)}
        self._meshes: dict[str, Any] = {}
        self._faces: dict[str, Any] = {}
        self._skin: Any = None
        self._put("lines", subject.lines(), lit=False)

    def look_from(self, camera: Camera, angle: float) -> None:
        """Set the camera."""
        eye = self.plotter.camera
        eye.position, eye.focal_point, eye.up = (tuple(map(float, one)) for one in (camera.eye, camera.target, camera.upward))
        eye.view_angle = float(np.degrees(angle))

    def shoot(
        self, frame: int, colours: NDArray[np.uint8], skin: NDArray[np.uint8], hatched: NDArray[np.bool_], swing: float = 0.0
    ) -> NDArray[np.uint8]:
        """The picture (height, width, 3) at a frame, members in colours (members, 3), faces of meshes in skin (f, 3).

        hatched : mask (frames, members) of striped members.
        """
        subject = self._subject
        x = subject.points(frame, swing)
        rods, boxes = subject.rods(frame, x, colours, hatched)
        self._put("rods", rods)
        self._put("boxes", boxes)
        for name, rims in zip(("rims", "box rims"), subject.bars.rims(x), strict=True):
            self._put(name, rims, lit=False)
        self._put("cones", subject.cones(frame, x))
        self._put("balls", subject.balls(x))
        self._put_faces("bodies", subject.bodies(x), BODY, 1.0)
        self._put_faces("triangles", subject.triangles(x), FACE, 0.4)
        self._put_skin(x, skin)
        self.plotter.reset_camera_clipping_range()
        self.plotter.render()
        drawn = Image.fromarray(np.ascontiguousarray(self.plotter.screenshot(None, return_img=True)[:, :, :3]))
        return np.asarray(drawn.reduce(self._fine))

    def _put(self, name: str, several: Copies, *, lit: bool = True) -> None:
        shape: Turned = self._shapes[name]
        if not len(several.radius):
            return
        points, normals = shape.placed(several)
        if name not in self._meshes:
            mesh = self._pv.PolyData(points, shape.faces(len(several.radius)))
            mesh.point_data.active_normals = normals
            mesh.point_data["colour"] = shape.spread(several.colour)
            actor = self.plotter.add_mesh(mesh, scalars="colour", rgb=True, copy_mesh=False)
            _matt(actor, 0.58 if lit else 0.0)
            if name.endswith("rims"):
                actor.prop.culling = "front"
            self._meshes[name] = mesh
            return
        mesh = self._meshes[name]
        mesh.points = points
        mesh.point_data["Normals"] = normals
        mesh.point_data["colour"] = shape.spread(several.colour)

    def _put_faces(self, name: str, corners: NDArray[np.float64], colour: str, opacity: float) -> None:
        if not len(corners):
            return
        if name not in self._faces:
            count = len(corners)
            faces = np.column_stack([np.full(count, 3), np.arange(3 * count).reshape(count, 3)]).ravel()
            self._faces[name] = self._pv.PolyData(corners.reshape(-1, 3), faces)
            _matt(self.plotter.add_mesh(self._faces[name], color=colour, opacity=opacity), flat=True)
        self._faces[name].points = corners.reshape(-1, 3)

    def _put_skin(self, x: NDArray[np.float64], colours: NDArray[np.uint8]) -> None:
        """Membranes and the surface of solids, with the edges of their elements."""
        nodes = self._subject.skin
        if not len(nodes):
            return
        if self._skin is None:
            self._skin = self._pv.PolyData(x.copy(), np.column_stack([np.full(len(nodes), 3), nodes]).ravel())
            self._skin.cell_data["colour"] = colours
            edges = {"show_edges": len(nodes) <= FINE, "edge_color": EDGE, "edge_opacity": 0.4}
            _matt(self.plotter.add_mesh(self._skin, scalars="colour", rgb=True, copy_mesh=False, **edges), 0.4, flat=True)
        self._skin.points = x.copy()
        self._skin.cell_data["colour"] = colours


def _matt(actor: Any, lit: float = 0.58, *, flat: bool = False) -> None:
    """Set a matt surface: faces towards the camera have their own colour."""
    actor.prop.interpolation = "Flat" if flat else "Phong"
    actor.prop.ambient, actor.prop.diffuse, actor.prop.specular = 1 - lit, lit, 0.0


@contextmanager
def stage(subject: Subject, width: int, height: int, fine: int) -> Iterator[Stage]:
    """A temporary stage. fine : number of drawn pixels per final pixel, in each direction.

    Raises
    ------
    InputError : PyVista is not installed, or the machine has no library that draws.
    """
    pyvista = _pyvista()
    with _window():
        found = Stage(pyvista, subject, width, height, fine)
    try:
        yield found
    finally:
        found.plotter.close()


def _pyvista() -> Any:
    try:
        import pyvista
    except ImportError as error:
        raise InputError(
            f"Pictures in three dimensions and films need the package {error.name}. "
            "Install what they need: pip install 'kinetruss[render]'"
        ) from None
    return pyvista


@contextmanager
def _window() -> Iterator[None]:
    """Choose an off-screen library on Linux; a missing library would end the process inside VTK."""
    if not sys.platform.startswith("linux"):
        yield
        return
    before = os.environ.get(WINDOW)
    os.environ[WINDOW] = before or _drawing(("libEGL.so.1", "libOSMesa.so.8", "libOSMesa.so.6"))
    try:
        yield
    finally:
        if before is None:
            del os.environ[WINDOW]


def _drawing(libraries: Sequence[str]) -> str:
    """The window class of VTK for the first available library."""
    for library in libraries:
        with suppress(OSError):
            ctypes.CDLL(library)
            return "vtkEGLRenderWindow" if "EGL" in library else "vtkOSOpenGLRenderWindow"
    if os.environ.get("DISPLAY"):
        return "vtkXOpenGLRenderWindow"
    raise InputError(
        "Nothing on this machine draws without a screen: neither libEGL nor libOSMesa is found. "
        "On Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri (or libosmesa6)"
    )
