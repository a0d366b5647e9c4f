"""The triangular truss against the numbers of Lacy (1991), chapter 3, that only his own program gives.

`differences` repeats his finite differences and his slip, along the product's motion. Beside each number stands
what the product itself gives on the same samples.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.thesis.differences import Setup, stresses
from kinetruss.verification.thesis.triangle import analysed, outer_fibre
from kinetruss.verification.thesis.triangle_printed import STEP, TIMES


def numbers(payload: float) -> dict[str, float]:
    """Sections 3.3, 3.5 and Table 3.3: by his formulas, and (``.product``) by the product."""
    model, forces, total, static = analysed(TIMES, payload)
    motion = forces.motion.data.sel(member="actuator")
    length = motion["length"].values, motion["length_rate"].values, motion["length_acceleration"].values
    still, still_tube = outer_fibre(model, static, "follower", 3), outer_fibre(model, static, "actuator.tube", 0)
    own = (
        outer_fibre(model, total, "follower", 3),
        outer_fibre(model, total, "actuator.tube", 0),
        _compression(total, "follower"),
        _compression(total, "actuator.tube"),
    )
    his = _largest(stresses(_setup(model), length, STEP), still, still_tube, STEP)
    return his | {f"{name}.product": value for name, value in _largest(own, still, still_tube, 0.0).items()}


def _compression(sections: kt.results.Sections, part: str) -> Any:
    """Largest over the stations, at every sample, N."""
    return -sections.data["section_T"].sel(part=part).min("station").values


def _largest(found: tuple[Any, ...], still: Any, still_tube: Any, late: float) -> dict[str, float]:
    """Largest values and their times; `late`: how much later than the samples the times are printed, s."""
    follower, tube, follower_compression, tube_compression = found
    moved, moved_tube = follower - still, tube - still_tube
    times = np.array(TIMES) + late
    return {
        "follower_largest": follower.max(),
        "follower_largest_time": times[follower.argmax()],
        "follower_motion_largest": moved.max(),
        "follower_motion_largest_time": times[moved.argmax()],
        "tube_largest": tube.max(),
        "tube_motion_largest": moved_tube.max(),
        "tube_motion_largest_time": times[moved_tube.argmax()],
        "follower_largest_compression": follower_compression.max(),
        "tube_largest_compression": tube_compression.max(),
    }


def _setup(model: kt.Model) -> Setup:
    bar = model.bars["follower"]
    return Setup(
        section=model.section_of(bar),
        density=2711.5,
        member=2.0,
        ground=2.0,
        shortest=0.5,
        rod_mass=2.4,
        rod_length=2.1,
        load=model.nodes["B"].mass,
        gravity=9.81,
    )
