"""Three-dimensional pictures and films, written without a display to a file that appears completely or not at all."""

from __future__ import annotations

import itertools
import shutil
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from kinetruss.display import DRIVEN, KINDS, LOAD, OVER, SKINS, THEMES, colours_of, limits_of, number, quantity, rgb
from kinetruss.errors import InputError
from kinetruss.model import nearest
from kinetruss.results.folder import whole_file
from kinetruss.viewer.films.shown import Look, Subject
from kinetruss.viewer.films.stage import ANGLE, Camera, aimed
from kinetruss.viewer.moving import CHANNELS
from kinetruss.viewer.scenes import scene

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Result
    from kinetruss.runs import RunResult
    from kinetruss.viewer.moving import Mode, Scene

    Frames = Iterable[NDArray[np.uint8]]


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


# Writes frames to a file that appears completely or not at all.


def rate_of(suffix: str, fps: float) -> float:
    """Possible frames per second: delays in a GIF are whole hundredths of a second, at least two."""
    return fps if suffix == ".mp4" else 100.0 / max(2, round(100.0 / fps))


def check_encoder(suffix: str) -> None:
    """Raise an error for missing packages before anything is drawn.

    Raises
    ------
    InputError : MP4 without imageio-ffmpeg, or without a program ffmpeg.
    """
    if suffix == ".mp4":
        _ffmpeg()


def write_picture(picture: NDArray[np.uint8], path: Path) -> None:
    """Write one PNG file."""
    with whole_file(path) as part:
        Image.fromarray(picture).save(part, format="PNG", dpi=(300, 300))


def write_film(frames: Frames, path: Path, size: tuple[int, int], fps: float, colours: NDArray[np.uint8]) -> None:
    """Write frames (height, width, 3), 0 to 255, as MP4 (H.264, plays everywhere) or as GIF (endless).

    colours : (n, 3), all colours of the frames; a GIF has one table of 255 for all frames, to avoid flicker.

    Raises
    ------
    StoreError : the file cannot be written.
    """
    with whole_file(path) as part:
        if path.suffix.lower() == ".mp4":
            _mp4(frames, part, size, fps)
        else:
            _gif(frames, part, fps, colours)


def _mp4(frames: Frames, part: Path, size: tuple[int, int], fps: float) -> None:
    part.touch()  # report here that the file cannot be written; ffmpeg takes twenty lines for it
    writer = _ffmpeg().write_frames(
        part,
        size,
        fps=fps,
        codec="libx264",
        macro_block_size=2,
        output_params=["-preset", "veryfast", "-crf", "18", "-movflags", "+faststart"],
        ffmpeg_log_level="error",
    )
    writer.send(None)
    try:
        for frame in frames:
            writer.send(frame)
    finally:
        writer.close()


def _gif(frames: Frames, part: Path, fps: float, colours: NDArray[np.uint8]) -> None:
    pictures = (Image.fromarray(frame) for frame in frames)
    first = next(pictures)
    # half of the table for the shaded colours, half for the first frame
    shades = (np.linspace(0.4, 1.0, 24)[:, None, None] * colours).astype(np.uint8)
    swatches = Image.fromarray(shades).resize((first.width, first.height // 2), Image.Resampling.NEAREST)
    sample = Image.new("RGB", (first.width, first.height + swatches.height))
    sample.paste(first)
    sample.paste(swatches, (0, first.height))
    table = sample.quantize(255, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    begin = first.quantize(palette=table, dither=Image.Dither.NONE)
    rest = (one.quantize(palette=table, dither=Image.Dither.NONE) for one in pictures)
    with part.open("wb") as stream:
        begin.save(stream, format="GIF", save_all=True, append_images=rest, duration=round(1000 / fps), loop=0, optimize=False)


def _ffmpeg() -> Any:
    try:
        import imageio_ffmpeg
    except ImportError as error:
        raise InputError(
            f"Films as MP4 need the package {error.name}. Install what they need: pip install 'kinetruss[render]' "
            "(or write a .gif)"
        ) from None
    try:
        program = shutil.which(imageio_ffmpeg.get_ffmpeg_exe())
    except RuntimeError:
        program = None
    if program is None:
        raise InputError(
            "No program ffmpeg is found. Install it (apt-get install ffmpeg), or name it in IMAGEIO_FFMPEG_EXE; "
            "or write a .gif, which needs none."
        )
    return imageio_ffmpeg


# Three-dimensional pictures and films, written without a display.

SUFFIXES = (".png", ".mp4", ".gif")
SWINGING = 2.5
"""Period of an animated mode, s."""
LEAST, MOST = (240, 180), (7680, 7680)


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
    InputError : an unknown suffix, size, colour, camera, instant or name; a film of a model without motion; PyVista, ffmpeg
    or a library that draws without a display is missing. StoreError : the file cannot be written.

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
    subject = Subject(
        shown,
        Look(
            ghost=ghost,
            faces=_bodily(shown) if faces is None else faces,
            loads=loads,
            grid=grid,
            paths=_nodes(shown, paths),
            mode=_mode(shown, mode),
        ),
    )
    channel = _channel(shown, colour)
    limits = (0.0, 1.0) if channel is None else limits_of(channel["scale"], subject.shown_values(channel))
    pace = 1.0
    if path.suffix == ".png":
        shots = _picture(shown, at, mode)
    else:
        time = shown.arrays["time"]
        pace = speed or (usual_speed(float(time[-1] - time[0])) if mode is None else 1.0)
        shots = _film(shown, path, at, mode, fps, pace)
    job = _Job(subject=subject, channel=channel, limits=limits, size=size, camera=camera, bare=bare, pace=pace)
    pictures = job.pictures(shots, progress)
    first = next(pictures)  # all input errors are raised before a file is started
    from kinetruss.viewer.films import render as files

    if path.suffix == ".png":
        files.write_picture(first, path)
    else:
        frames = itertools.chain([first], pictures)
        files.write_film(frames, path, size, files.rate_of(path.suffix, fps), job.palette())
    return path


@dataclass(frozen=True, slots=True)
class _Shot:
    """Frame of the scene, phase of the mode, and text of the instant."""

    frame: int
    swing: float
    words: str


@dataclass(frozen=True, kw_only=True)
class _Job:
    subject: Subject
    channel: dict[str, Any] | None
    limits: tuple[float, float]
    size: tuple[int, int]
    camera: str | Sequence[float]
    bare: bool
    pace: float = 1.0

    def pictures(self, shots: Sequence[_Shot], progress: Callable[[int, int], None] | None) -> Iterator[NDArray[np.uint8]]:
        """Draw each shot."""
        from kinetruss.viewer.films.frame import strips
        from kinetruss.viewer.films.stage import stage

        width, height = self.size
        high = height if self.bare else height - sum(strips(width, height)[1:])
        camera = self.eye(width / high)
        frame = None if self.bare else self.frame(camera)
        hatched = self.subject.hatched(self.channel)
        with stage(self.subject, width, high, 3 if len(shots) == 1 else 2) as scenery:
            scenery.look_from(camera, ANGLE)
            for k, shot in enumerate(shots):
                colours = self.subject.colours(shot.frame, self.channel, self.limits)
                skin = self.subject.skin_colours(shot.frame, self.channel, self.limits)
                picture = scenery.shoot(shot.frame, colours, skin, hatched, shot.swing)
                yield picture if frame is None else frame.around(picture, shot.words)
                if progress is not None:
                    progress(k + 1, len(shots))

    def eye(self, wide: float) -> Camera:
        """The camera that shows all of every frame."""
        points = np.concatenate([self.subject.places.reshape(-1, 3), self.subject.tips()])
        around = 2 * self.subject.ball * np.array([[-1, -1, -1], [1, 1, 1]])
        return aimed(self.camera, np.concatenate([points + one for one in around]), wide, self.subject.dim)

    def frame(self, camera: Camera) -> Any:
        """The text around the picture."""
        from kinetruss.viewer.films.frame import Frame

        header, channel = self.subject.scene.header, self.channel
        values = np.zeros(1) if channel is None else self.subject.shown_values(channel)
        kinds = [*header["kinds"], *(one["kind"] for one in header["skins"])]
        notes = ["worst of the whole run"] * bool(channel and channel.get("over_run"))
        notes += ["striped: not unique"] * bool(channel and channel["id"] != "speed" and self.subject.unsure)
        notes += [f"{number(self.pace)} × real time"] * (self.pace != 1)
        notes += [f"grid {quantity(self.subject.step, 'm')}"] * self.subject.look.grid
        return Frame(
            width=self.size[0],
            height=self.size[1],
            title=str(header["title"] or header["name"]),
            note=", ".join(notes),
            channel=channel,
            limits=self.limits,
            largest=float(np.nanmax(np.abs(values), initial=0.0)),
            kinds=kinds,
            gravity=header["gravity"],
            dim=self.subject.dim,
            over=channel is not None and channel["scale"] in ("capacity", "margin") and bool((np.nan_to_num(values) > 1).any()),
            missing=bool(np.isnan(values).any()),
            single=len(self.subject.places) < 2,
            camera=camera,
        )

    def palette(self) -> NDArray[np.uint8]:
        """All colours of members."""
        if self.channel is None:
            return np.array([rgb(one) for one in (*KINDS.values(), *SKINS.values())], np.uint8)
        colours, light = colours_of(self.channel["scale"], np.linspace(*self.limits, 48), self.limits), THEMES["light"]
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


def _channel(shown: Scene, colour: str | None) -> dict[str, Any] | None:
    """The channel that colours the members; None: their kinds."""
    known: dict[str, dict[str, Any]] = {str(one["id"]): one for one in shown.header["channels"]}
    if colour is None:
        return known.get("force", known.get("stress") if shown.header["skins"] else None)
    if colour == "kind":
        return None
    if colour not in CHANNELS:
        raise InputError(f"No colour called {colour!r}. {nearest(colour, [*CHANNELS, 'kind'])}")
    if colour not in known:
        there = ", ".join([*known, "kind"])
        raise InputError(f"There is nothing to colour by {colour} here. What can be shown: {there}.")
    return known[colour]


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
