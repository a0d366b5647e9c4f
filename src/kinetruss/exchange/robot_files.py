"""Robots from URDF and MJCF files as models."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from kinetruss.errors import InputError
from kinetruss.exchange.closing import closed
from kinetruss.exchange.drawings import text_of
from kinetruss.exchange.imported import Imported
from kinetruss.exchange.mjcf import read_mjcf
from kinetruss.exchange.robot_models import assemble
from kinetruss.exchange.robots import Robot
from kinetruss.exchange.urdf import read_closures, read_urdf


def robot_of(
    path: Path,
    *,
    max_size: int,
    closures: str | Path | None = None,
    at: Mapping[str, float] | None = None,
    floating: bool = False,
) -> Robot:
    """The links, joints and closures of a URDF or MJCF file."""
    text = text_of(path, max_size)
    if path.suffix.lower() != ".urdf" and "<mujoco" in text:
        if closures is not None:
            raise InputError(f"{path} is MJCF, which has its closures in <equality>. Leave out {closures}.")
        if floating:
            raise InputError(f"{path} is MJCF, which says itself what floats: <freejoint/>. Leave out --floating (floating).")
        return read_mjcf(path, text, at, max_size=max_size)
    beside = None if closures is None else read_closures(Path(closures), max_size)
    return read_urdf(path, text, beside, at, floating=floating)


def robot(
    path: Path,
    *,
    max_size: int,
    closures: str | Path | None = None,
    at: Mapping[str, float] | None = None,
    floating: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> Imported:
    """The model of a URDF or MJCF file. progress : called with (bodies done, all bodies)."""
    found = robot_of(path, max_size=max_size, closures=closures, at=at, floating=floating)
    posed = closed(found)
    made = assemble(posed, progress)
    return Imported(
        model=made.model,
        source=str(path),
        left_out=(*found.left_out, *made.left_out),
        closures=posed.redundant,
        gap=posed.gap,
        offsets=made.offsets,
        freedoms=posed.freedoms,
        notes=[
            _gravity(found, path),
            *found.notes,
            *posed.moved,
            *made.notes,
            *(f"coupling {name}: the rest of the robot implies it" for name in posed.implied),
        ],
    )


def _gravity(found: Robot, path: Path) -> str:
    value = ", ".join(f"{g:g}" for g in found.gravity)
    assumed = "; a URDF names none: change it in the model file" if path.suffix.lower() == ".urdf" else ""
    return f"gravity is ({value}) m/s^2{assumed}"
