"""Shaded pictures and films, drawn by the viewer's own page in Chromium without a screen."""

from __future__ import annotations

import base64
import io
import itertools
import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from kinetruss.display import DRIVEN, KINDS, LOAD, OVER, SKINS, THEMES, colours_of, number, quantity, rgb
from kinetruss.display.browser import INSTALL, WEBGL, Browser, BrowserError, chromium
from kinetruss.errors import AnalysisError, InputError
from kinetruss.model import nearest
from kinetruss.viewer.moving import CHANNELS
from kinetruss.viewer.picture_files import check_encoder, rate_of, write_film, write_picture
from kinetruss.viewer.picture_frame import Frame, strips
from kinetruss.viewer.scenes import scene
from kinetruss.viewer.self_contained import film_page

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Result
    from kinetruss.runs import RunResult
    from kinetruss.viewer.moving import Mode, Scene


ROUND = (1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0)
SHORT, LONG = 5.0, 8.0
"""Length, s, of a film whose speed is not given; as in the page (`usualSpeed`)."""


def usual_speed(duration: float) -> float:
    """The round speed at which a run of a duration, s, takes 5 to 8 s."""
    if not 0 < duration < np.inf:
        return 1.0
    power = int(np.floor(np.log10(duration / LONG)))
    several = [float(f"{one * tens:g}e{power}") for tens in (1, 10) for one in ROUND]
    return next((one for one in several if SHORT <= duration / one <= LONG), 1.0)


SUFFIXES = (".png", ".mp4", ".gif")
SWINGING = 2.5
"""Period of an animated mode, s."""
LEAST, MOST = (240, 180), (7680, 7680)
PRESETS = {
    "iso": (0.72, -1.0, 0.42),
    "corner": (0.72, -1.0, 0.42),
    "front": (0.0, -1.0, 0.0),
    "side": (1.0, 0.0, 0.0),
    "top": (0.0, 0.0, 1.0),
}
"""Directions of the presets; ``corner`` is ``iso`` in the page."""
AHEAD = 3
"""Pictures that the page is asked for at a time."""
READY = "new Promise((done) => { const wait = () => (window.kinetruss?.film ? done() : setTimeout(wait, 5)); wait(); })"


def render(
    what: Model | Result | RunResult,
    file: str | Path,
    *,
    model: Model | None = None,
    colour: str | None = None,
    camera: str | Sequence[float] = "iso",
    size: tuple[int, int] = (1280, 720),
    at: float | None = None,
    fps: float = 30.0,
    speed: float | None = None,
    case: str | None = None,
    mode: int | None = None,
    modes: Sequence[Mode] = (),
    ghost: bool = False,
    faces: bool | None = None,
    loads: bool = True,
    grid: bool = True,
    paths: Sequence[str] = (),
    bare: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> Path:
    """Write a shaded picture (``.png``) or a film (``.mp4``, ``.gif``) of a model, a run, or another result with its model.

    Parameters
    ----------
    colour : ``force``, ``stress``, ``utilisation``, ``buckling``, ``speed``, or ``kind``; by default axial force if forces
    are known. The scale covers the whole run, in every picture of it.
    camera : ``iso``, ``front``, ``side``, ``top``, or the direction (x, y, z) from the structure to the camera.
    size : width and height, pixels; even numbers for MP4.
    at : instant of a picture, s; by default the start. The nearest computed sample is shown.
    fps, speed : frames per second, and how much faster than in reality; by default a film of a run takes 5 to 8 s. Films show
    the nearest computed samples too.
    case : load case, by default the first. mode : the mode or mechanism to animate (0: the first); modes : additional ones.
    ghost : the start pose as thin lines. faces : show rigid triangles as faces; by default if no member has a section.
    paths : nodes whose path is drawn.
    bare : no text around the picture.
    progress : called with the number of frames done and of all frames.

    Returns
    -------
    The path written. An interrupted film leaves no file.

    Raises
    ------
    InputError : an unknown suffix, size, colour, camera, instant or name; a film of a model without motion; Chromium or
    ffmpeg is missing. AnalysisError : Chromium failed. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.viewer.render(kt.library.vgt.triangular(), f"{folder}/truss.png", size=(320, 240)).name
    'truss.png'
    """
    path = Path(file)
    _check(path, size, fps, speed)
    shown = scene(what, model=model, case=case, modes=modes, instants=() if at is None else (at,))
    look = {
        "direction": _direction(camera, int(shown.header["dim"])).tolist(),
        "colour": _channel(shown, colour),
        "mode": _mode(shown, mode),
        "paths": _nodes(shown, paths),
        "ghost": ghost,
        "faces": _bodily(shown) if faces is None else faces,
        "loads": loads,
        "grid": grid,
    }
    pace = 1.0
    if path.suffix == ".png":
        shots = _picture(shown, at, mode)
    else:
        time = shown.arrays["time"]
        pace = speed or (usual_speed(float(time[-1] - time[0])) if mode is None else 1.0)
        shots = _film(shown, path, at, mode, fps, pace)
    job = _Job(scene=shown, look=look, size=size, bare=bare, pace=pace)
    pictures = job.pictures(shots, progress)
    first = next(pictures)  # all input errors are raised before a file is started
    if path.suffix == ".png":
        write_picture(first, path)
    else:
        write_film(itertools.chain([first], pictures), path, size, rate_of(path.suffix, fps), job.palette())
    return path


@dataclass(frozen=True, slots=True)
class _Shot:
    """Sample of the scene, phase of the mode, and text of the instant."""

    sample: int
    phase: float
    words: str


@dataclass(frozen=True, kw_only=True)
class _Job:
    """What is drawn; look : options of the page, as `viewer-src/src/film.js` has them."""

    scene: Scene
    look: dict[str, Any]
    size: tuple[int, int]
    bare: bool
    pace: float = 1.0

    def pictures(self, shots: Sequence[_Shot], progress: Callable[[int, int], None] | None) -> Iterator[NDArray[np.uint8]]:
        """Draw each shot (height, width, 3); the page draws the next ones meanwhile."""
        width, height = self.size
        high = height if self.bare else height - sum(strips(width, height)[1:])
        with _opened(self.scene) as browser:
            said = browser.ask(f"kinetruss.film({json.dumps({**self.look, 'width': width, 'height': high})})")
            frame = None if self.bare else self.frame(said)
            waiting: list[int] = []
            for k, shot in enumerate(shots):
                soon = shots[k + len(waiting) : k + AHEAD]
                waiting += [browser.begin(f"kinetruss.shown.shoot({one.sample}, {one.phase})") for one in soon]
                drawn = Image.open(io.BytesIO(base64.b64decode(browser.answer(waiting.pop(0)).partition(",")[2])))
                picture = np.asarray(drawn.convert("RGB"))
                yield picture if frame is None else frame.around(picture, shot.words)
                if progress is not None:
                    progress(k + 1, len(shots))

    @property
    def channel(self) -> dict[str, Any] | None:
        """The channel that colours the members; None: their kinds."""
        return next((one for one in self.scene.header["channels"] if one["id"] == self.look["colour"]), None)

    def frame(self, said: dict[str, Any]) -> Frame:
        """The text around the picture. said : what the page tells of its colours."""
        header, channel = self.scene.header, self.channel
        kinds = [*header["kinds"], *(one["kind"] for one in header["skins"])]
        notes = ["worst of the whole run"] * bool(channel and channel.get("over_run"))
        notes += ["striped: not unique"] * bool(channel and channel["id"] != "speed" and said["unsure"])
        notes += [f"{number(self.pace)} × real time"] * (self.pace != 1)
        notes += [f"grid {quantity(said['step'], 'm')}"] * self.look["grid"]
        return Frame(
            width=self.size[0],
            height=self.size[1],
            title=str(header["title"] or header["name"]),
            note=", ".join(notes),
            channel=channel,
            limits=said["limits"],
            largest=said["largest"],
            kinds=kinds,
            gravity=header["gravity"],
            dim=int(header["dim"]),
            over=said["over"],
            missing=said["missing"],
            single=len(self.scene.arrays["time"]) < 2,
            backward=np.array(self.look["direction"]),
        )

    def palette(self) -> NDArray[np.uint8]:
        """All colours of members."""
        if self.channel is None:
            return np.array([rgb(one) for one in (*KINDS.values(), *SKINS.values())], np.uint8)
        limits = (-1.0, 1.0) if self.channel["scale"] == "diverging" else (0.0, 1.0)
        colours, light = colours_of(self.channel["scale"], np.linspace(*limits, 48), limits), THEMES["light"]
        return np.concatenate(
            [colours, [rgb(one) for one in (LOAD, DRIVEN, OVER, light["node"], light["body"], light["outline"])]]
        ).astype(np.uint8)


def _check(path: Path, size: tuple[int, int], fps: float, speed: float | None) -> None:
    if path.suffix not in SUFFIXES:
        raise InputError(f"{path}: pictures end in .png, films in .mp4 or .gif. (Vector drawings: kinetruss picture)")
    if not all(low <= one <= high for low, one, high in zip(LEAST, size, MOST, strict=True)):
        raise InputError(f"size {size[0]}x{size[1]}: give {LEAST[0]}x{LEAST[1]} to {MOST[0]}x{MOST[1]} pixels.")
    if path.suffix == ".mp4" and any(one % 2 for one in size):
        raise InputError(f"size {size[0]}x{size[1]}: MP4 needs an even width and height.")
    if not 1 <= fps <= 240:
        raise InputError(f"fps={fps:g}: give 1 to 240 frames a second.")
    if speed is not None and not 0 < speed < np.inf:
        raise InputError(f"speed={speed:g}: give a positive number, e.g. 0.5 for half as fast.")
    if path.suffix != ".png":
        check_encoder(path.suffix)


def _bodily(shown: Scene) -> bool:
    """Whether a structure is one of bodies only: no member has a section."""
    return bool(np.isnan(np.asarray(shown.arrays["radius"], float)).all())


def _nodes(shown: Scene, names: Sequence[str]) -> tuple[int, ...]:
    known = list(shown.header["nodes"])
    for name in names:
        if name not in known:
            raise InputError(f"No node called {name!r}. {nearest(name, known)}")
    return tuple(known.index(name) for name in names)


def _mode(shown: Scene, mode: int | None) -> int | None:
    count = len(shown.header["modes"])
    if mode is not None and not 0 <= mode < count:
        raise InputError(f"mode {mode}: there are {count} modes or mechanisms to swing (0 is the first).")
    return mode


def _channel(shown: Scene, colour: str | None) -> str | None:
    """The channel that colours the members; None: their kinds."""
    known = [str(one["id"]) for one in shown.header["channels"]]
    if colour is None:
        return next((one for one in ("force", *(["stress"] if shown.header["skins"] else [])) if one in known), None)
    if colour == "kind":
        return None
    if colour not in CHANNELS:
        raise InputError(f"No colour called {colour!r}. {nearest(colour, [*CHANNELS, 'kind'])}")
    if colour not in known:
        there = ", ".join([*known, "kind"])
        raise InputError(f"There is nothing to colour by {colour} here. What can be shown: {there}.")
    return colour


def _direction(camera: str | Sequence[float], dim: int) -> NDArray[np.float64]:
    """The unit vector towards the eye."""
    if isinstance(camera, str):
        if camera not in PRESETS:
            raise InputError(f"No camera called {camera!r}. {nearest(camera, PRESETS)}")
        # a plane structure is seen along the normal of its plane by default
        camera = (0.0, 0.0, 1.0) if dim == 2 and camera in ("iso", "corner") else PRESETS[camera]
    found = np.array(camera, float)
    if found.shape != (3,) or not np.isfinite(found).all() or not np.linalg.norm(found) > 0:
        raise InputError(f"camera {tuple(camera)}: give a preset ({', '.join(PRESETS)}) or a direction (x, y, z).")
    direction: NDArray[np.float64] = found / np.linalg.norm(found)
    return direction


@contextmanager
def _opened(shown: Scene) -> Iterator[Browser]:
    """A browser with the page that draws a scene.

    Raises
    ------
    InputError : no Chromium is installed. AnalysisError : it failed.
    """
    program = chromium()
    if program is None:
        raise InputError(f"Shaded pictures and films are drawn by Chromium, and none was found. {INSTALL}.")
    try:
        with TemporaryDirectory(prefix="kinetruss-") as folder, Browser(program, WEBGL) as browser:
            page = Path(folder, "film.html")
            page.write_text(film_page(shown), encoding="utf-8")
            browser.open(page)
            browser.ask(READY)
            yield browser
    except BrowserError as error:
        raise AnalysisError(f"Nothing was drawn: {error}") from None


def _picture(shown: Scene, at: float | None, mode: int | None) -> list[_Shot]:
    time = shown.arrays["time"]
    frame = 0
    if at is not None:
        apart = 1e-9 * float(time[-1] - time[0])
        if not time[0] - apart <= at <= time[-1] + apart:
            raise InputError(f"at={at:g} s: the run goes from {time[0]:g} to {time[-1]:g} s.")
        frame = int(np.abs(time - at).argmin())
    return [_Shot(frame, 0.0 if mode is None else 1.0, _words(shown, frame, mode))]


def _film(shown: Scene, path: Path, at: float | None, mode: int | None, fps: float, speed: float) -> list[_Shot]:

    if at is not None:
        raise InputError("at=... goes with a picture (.png); a film shows the whole run.")
    time, rate = shown.arrays["time"], rate_of(path.suffix, fps)
    if mode is not None:
        count = round(SWINGING * rate / speed)
        return [_Shot(0, float(np.sin(2 * np.pi * k / count)), _words(shown, 0, mode)) for k in range(count)]
    if len(time) < 2:
        raise InputError("There is no motion to film. Give a run, or a mode to swing; or write a .png.")
    instants = time[0] + np.arange(int((time[-1] - time[0]) * rate / speed + 1e-9) + 1) * speed / rate
    right = np.clip(np.searchsorted(time, instants), 1, len(time) - 1)
    frames = np.where(instants - time[right - 1] <= time[right] - instants, right - 1, right)
    return [_Shot(int(k), 0.0, _words(shown, int(k), None)) for k in frames]


def _words(shown: Scene, frame: int, mode: int | None) -> str:
    if mode is not None:
        one = shown.header["modes"][mode]
        return str(one["name"]) + (f", {quantity(one['frequency'], 'Hz')}" if one["frequency"] is not None else "")
    time = shown.arrays["time"]
    if len(time) < 2:
        return ""
    decimals = min(6, max(0, int(np.ceil(-np.log10(float(np.diff(time).min())) - 1e-9))))
    return f"t = {time[frame]:.{decimals}f} s"
