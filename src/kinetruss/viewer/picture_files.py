"""Pictures and films as files, each of which appears completely or not at all."""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from kinetruss.errors import InputError
from kinetruss.results.folder import whole_file

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Frames = Iterable[NDArray[np.uint8]]


PALE = 248
"""Least part of red, green and blue of a colour that a GIF shows as white: Pillow finds the colours of its table by steps of 4,
and would take a pale one for the paper."""


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
    found = sample.quantize(255, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    entries = np.reshape(found.getpalette() or [], (-1, 3))
    entries[(entries >= PALE).all(axis=1)] = 255
    table = Image.new("P", (1, 1))
    table.putpalette(entries.ravel().tolist())
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
