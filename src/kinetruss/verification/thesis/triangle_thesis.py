"""The triangular truss against the numbers of Lacy (1991), chapter 3, that only his own program gives.

`_thesis_differences` repeats his finite differences and his slip, along the product's motion. Beside each number stands
what the product itself gives on the same samples.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss.model import Model
from kinetruss.results import Sections
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification.thesis import differences as thesis
from kinetruss.verification.thesis.printed import printed
from kinetruss.verification.thesis.triangle import analysed, outer_fibre
from kinetruss.verification.thesis.triangle_printed import STEP, TIMES, payload_of

__all__ = ["cases"]


def numbers(payload: float) -> dict[str, dict[str, float]]:
    """Sections 3.3, 3.5 and Table 3.3: by his formulas (``thesis``) and by the product (``product``)."""
    model, forces, total, static = analysed(TIMES, payload)
    motion = forces.motion.data.sel(member="actuator")
    x, rate, acceleration = (motion[name].values for name in ("length", "length_rate", "length_acceleration"))
    setup = _setup(model)
    his = thesis.stresses(setup, thesis.record(setup, x - setup.member - setup.shortest, rate, acceleration, STEP))
    still, still_tube = outer_fibre(model, static, "follower", 3), outer_fibre(model, static, "actuator.tube", 0)
    own = thesis.Stresses(
        outer_fibre(model, total, "follower", 3),
        outer_fibre(model, total, "actuator.tube", 0),
        _compression(total, "follower"),
        _compression(total, "actuator.tube"),
    )
    return {"thesis": _largest(his, still, still_tube, STEP), "product": _largest(own, still, still_tube, 0.0)}


def _compression(sections: Sections, part: str) -> Any:
    """Largest over the stations, at every sample, N."""
    return -sections.data["section_T"].sel(part=part).min("station").values


def _largest(found: thesis.Stresses, still: Any, still_tube: Any, late: float) -> dict[str, float]:
    """Largest values and their times; `late`: how much later than the samples the times are printed, s."""
    moved, moved_tube = found.follower - still, found.tube - still_tube
    times = np.array(TIMES) + late
    return {
        "follower_largest": found.follower.max(),
        "follower_largest_time": times[found.follower.argmax()],
        "follower_motion_largest": moved.max(),
        "follower_motion_largest_time": times[moved.argmax()],
        "tube_largest": found.tube.max(),
        "tube_motion_largest": moved_tube.max(),
        "tube_motion_largest_time": times[moved_tube.argmax()],
        "follower_largest_compression": found.follower_compression.max(),
        "tube_largest_compression": found.tube_compression.max(),
    }


def _setup(model: Model) -> thesis.Setup:
    inputs = load("triangle")["inputs"]
    bar = model.bars["follower"]
    return thesis.Setup(
        section=model.section_of(bar),
        density=inputs["rho"],
        member=inputs["L1"],
        ground=inputs["L4"],
        shortest=inputs["L3min"],
        rod_mass=inputs["m_base"],
        rod_length=inputs["L3max_base_length"],
        load=model.nodes["B"].mass,
        gravity=inputs["g"],
    )


def cases() -> Iterator[Case]:
    """One case a printed number of the class "thesis-formulas"."""
    for one in printed("triangle"):
        if one.reference.kind == "thesis-formulas":
            name, payload = payload_of(one.id)
            yield Case(
                one.id,
                one.reference,
                one.expected,
                one.tolerance,
                numbers,
                (payload,),
                ("thesis", name),
                product=("product", name),
            )
