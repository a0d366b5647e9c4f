"""The text around a picture: title, time, legend, axes. Drawn by Pillow, in the font of all figures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from kinetruss.display import KINDS, MISSING, OVER, SKINS, THEMES, colours_of
from kinetruss.viewer.self_contained import ends, heading, ticks

if TYPE_CHECKING:
    from numpy.typing import NDArray

INK, QUIET = THEMES["light"]["ink"], THEMES["light"]["faint"]
KIND_WORDS = {
    "rigid": "rigid",
    "driven": "driven",
    "active": "active",
    "elastic": "elastic",
    "beam": "elastic beam",
    "cable": "cable",
    "free": "free sensor",
}
AXES = (("x", (1.0, 0, 0), "#c0392b"), ("y", (0, 1.0, 0), "#2e8b57"), ("z", (0, 0, 1.0), "#2f6fc1"))


def strips(width: int, height: int) -> tuple[int, int, int]:
    """Font size, and heights of the strips above and below the picture, pixels."""
    letter = max(11, round(min(height / 36, width / 52)))
    return letter, round(1.9 * letter), round(4.6 * letter)


@dataclass(frozen=True, kw_only=True, eq=False)
class Frame:
    """The strips around pictures of one size. title : above; note : text below it on the right; backward : unit vector towards
    the eye.
    """

    width: int
    height: int
    title: str
    note: str
    channel: dict[str, Any] | None
    limits: Sequence[float]
    largest: float
    kinds: Sequence[str]
    over: bool
    missing: bool
    single: bool
    gravity: Sequence[float]
    dim: int
    backward: NDArray[np.float64]

    def around(self, picture: NDArray[np.uint8], time: str) -> NDArray[np.uint8]:
        """The picture with its strips (height, width, 3)."""
        letter, above, _ = strips(self.width, self.height)
        sheet = self._sheet.copy()
        sheet.paste(Image.fromarray(picture), (0, above))
        draw = ImageDraw.Draw(sheet)
        draw.text((self.width - letter, letter), time, fill=INK, font=_font(letter), anchor="rm")
        return np.asarray(sheet)

    @cached_property
    def _sheet(self) -> Any:
        """The parts that are the same at every instant."""
        letter, _, below = strips(self.width, self.height)
        sheet = Image.new("RGB", (self.width, self.height), "white")
        draw = ImageDraw.Draw(sheet)
        room = self.width - 2 * letter - _font(letter).getlength("t = 00.000 s  ")
        draw.text(
            (letter, letter),
            _cut(self.title, _font(letter, bold=True), room),
            fill=INK,
            font=_font(letter, bold=True),
            anchor="lm",
        )
        top = self.height - below
        if self.channel is None:
            self._kinds(draw, letter, top)
        else:
            self._scale(sheet, draw, letter, top)
        self._axes(draw, letter, top)
        return sheet

    def _scale(self, sheet: Any, draw: Any, letter: int, top: int) -> None:
        assert self.channel is not None  # noqa: S101 - for mypy
        small, wide = _font(round(0.85 * letter)), min(20 * letter, round(0.55 * self.width))
        draw.text((letter, top + letter * 0.7), heading(self.channel, self.limits), fill=INK, font=_font(letter), anchor="lm")
        bar = colours_of(self.channel["scale"], np.linspace(self.limits[0], self.limits[1], wide), self.limits)
        level, high = top + round(1.4 * letter), max(4, round(0.6 * letter))
        sheet.paste(Image.fromarray(np.tile(bar[None], (high, 1, 1))), (letter, level))
        texts = ticks(self.channel, self.limits)
        for k, text in enumerate(texts):
            anchor = "l" if k == 0 else "r" if k == len(texts) - 1 else "m"
            draw.text((letter + k * wide / 4, level + high + 0.55 * letter), text, fill=INK, font=small, anchor=anchor + "m")
        for k, text in enumerate(ends(self.channel, self.largest, self.single)):
            draw.text((letter + k * wide, level + high + 1.6 * letter), text, fill=QUIET, font=small, anchor="lr"[k] + "m")
        aside = [(OVER, "buckles" if self.channel["scale"] == "margin" else "above 100 %")] * self.over
        missing = "not checked" if self.channel["scale"] in ("capacity", "margin") else "not known"
        aside += [(MISSING, missing)] * self.missing
        self._swatches(draw, letter, aside, letter + wide + 2 * letter, top + round(1.4 * letter))
        draw.text((letter + wide + 2 * letter, top + 0.7 * letter), self.note, fill=QUIET, font=small, anchor="lm")

    def _kinds(self, draw: Any, letter: int, top: int) -> None:
        found = [(KINDS[kind], words) for kind, words in KIND_WORDS.items() if kind in self.kinds]
        found += [(SKINS[kind], kind) for kind in SKINS if kind in self.kinds]
        if not found:
            return
        draw.text((letter, top + 0.7 * letter), "Kinds of members", fill=INK, font=_font(letter), anchor="lm")
        self._swatches(draw, letter, found[:3], letter, top + round(1.4 * letter))
        self._swatches(draw, letter, found[3:], 9 * letter, top + round(1.4 * letter))

    def _swatches(self, draw: Any, letter: int, rows: Sequence[tuple[str, str]], left: int, top: int) -> None:
        small = _font(round(0.85 * letter))
        for k, (colour, words) in enumerate(rows):
            level = top + k * round(1.1 * letter)
            draw.rectangle((left, level, left + letter, level + 0.7 * letter), fill=colour)
            draw.text((left + 1.5 * letter, level + 0.35 * letter), words, fill=INK, font=small, anchor="lm")

    def _axes(self, draw: Any, letter: int, top: int) -> None:
        """The axes as the camera sees them, and next to them the direction of gravity."""
        backward = self.backward
        right = np.cross((0.0, 1.0, 0.0) if abs(backward[2]) > 0.999 else (0.0, 0.0, 1.0), backward)
        right /= np.linalg.norm(right)
        upward = np.cross(backward, right)
        reach, level = 1.35 * letter, top + 2.3 * letter
        shown = [(name, np.array(axis, float), colour, self.width - 3.2 * letter) for name, axis, colour in AXES[: self.dim]]
        down = np.zeros(3)
        down[: len(self.gravity)] = self.gravity
        if np.linalg.norm(down) > 0:
            shown.append(("g", down / np.linalg.norm(down), QUIET, self.width - 7.4 * letter))
        for name, axis, colour, left in sorted(shown, key=lambda one: float(one[1] @ backward)):
            tip = np.array([axis @ right, -(axis @ upward)]) * reach
            start = (left, level) if name != "g" else (left - tip[0] / 2, level - 0.3 * letter - tip[1] / 2)
            _arrow(draw, start, tip, colour, letter)
            size = float(np.hypot(*tip))
            out = tip * (1 + 0.55 * letter / size) if size > 0.3 * reach else tip + 0.6 * letter
            draw.text((start[0] + out[0], start[1] + out[1]), name, fill=INK, font=_font(round(0.85 * letter)), anchor="mm")


def _arrow(draw: Any, start: tuple[float, float], along: NDArray[np.float64], colour: str, letter: int) -> None:
    size = float(np.hypot(*along))
    broad = max(2, round(letter / 7))
    if size < 0.2 * letter:
        draw.ellipse((start[0] - broad, start[1] - broad, start[0] + broad, start[1] + broad), fill=colour)
        return
    head = min(0.45 * letter, size)
    tip, u = np.array(start) + along, along / size
    neck, aside = tip - head * u, 0.5 * head * np.array([-u[1], u[0]])
    draw.line((*start, *neck), fill=colour, width=broad)
    draw.polygon([tuple(tip), tuple(neck + aside), tuple(neck - aside)], fill=colour)


def _cut(text: str, font: Any, room: float) -> str:
    """The text, shortened to fit."""
    if font.getlength(text) <= room:
        return text
    while text and font.getlength(text + "…") > room:
        text = text[:-1]
    return text.rstrip() + "…"


@cache
def _font(size: int, *, bold: bool = False) -> Any:
    """DejaVu Sans, as all figures have it; it comes with Matplotlib, which is not imported for it."""
    spec = find_spec("matplotlib")
    folder = Path((spec and spec.origin) or "").parent / "mpl-data" / "fonts" / "ttf"
    return ImageFont.truetype(str(folder / f"DejaVuSans{'-Bold' if bold else ''}.ttf"), size)
