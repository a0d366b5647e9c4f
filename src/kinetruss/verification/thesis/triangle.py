"""The triangular truss against exact physics: samples of the motion, and the maxima on a grid of 1 ms."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss import dynamics, kinematics, strength
from kinetruss.library import vgt
from kinetruss.model import Material, Model, NodalForce, Tube
from kinetruss.results import Forces, Sections
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["analysed", "cases", "history", "outer_fibre", "truss"]

Floats = NDArray[np.float64]

EXACT = 1e-8
"""Ten digits are stored."""

GRID = 1e-6
"""Seven digits are stored, of maxima on a grid of 1 ms."""

VECTORS = {
    "R1": "xy",
    "R2": "xy",
    "F_on_follower_at_B": "xy",
    "F_on_tube_at_B": "xy",
    "follower_mid_T_V_M": "TVM",
    "tube_cantilever_T_V_M": "TVM",
}


def truss(payload: float = 10.0, massless: bool = False) -> Model:
    """The truss of Lacy (1991, chapters 2 and 3); massless: Table 3.2, only a force of 98.1 N at B."""
    inputs = load("triangle")["inputs"]
    density = 0.0 if massless else inputs["rho"]
    model = vgt.triangular(
        actuator_length=inputs["L2"] + inputs["L3min"],
        follower_length=inputs["L1"],
        span=inputs["L4"],
        tube_length=inputs["L2"],
        section=Tube(outer=inputs["OD"], inner=inputs["ID"]),
        material=Material(E=inputs["E"], density=density),
        base_mass=0.0 if massless else inputs["m_base"],
        base_length=inputs["L3max_base_length"],
        payload_mass=0.0 if massless else payload,
        gravity=(0.0, -inputs["g"]),
    )
    weight = NodalForce(node="B", force=(0.0, -payload * inputs["g"]))
    return model.with_(loads={"weight": weight}) if massless else model


def analysed(
    times: tuple[float, ...], payload: float = 10.0, massless: bool = False
) -> tuple[Model, Forces, Sections, Sections]:
    """Model, forces, section forces and static section forces at the given times of the thesis' motion."""
    model = truss(payload, massless)
    motion = kinematics.follow(model, vgt.lacy_step(), times=np.array(times))
    forces = dynamics.inverse(model, motion)
    total, static = (strength.sections(model, one) for one in (forces, forces.static) if one is not None)
    return model, forces, total, static


def history(times: tuple[float, ...]) -> dict[str, Floats]:
    """Everything the samples hold, (times,) or (times, k), in the signs of the reference.

    phi is clockwise at O1 from O1->O2; V and M are exerted on the B-side part, along the increasing-angle normal and in
    the same sense: for the follower, which turns clockwise, that is the product's own sign (its axis 2 is the opposite
    normal), for the tube minus it.
    """
    _, forces, sections, _ = analysed(times)
    motion = forces.motion.data
    found: dict[str, Floats] = {
        "x": motion["length"].sel(member="actuator").values - 2.5,
        "xd": motion["length_rate"].sel(member="actuator").values,
        "xdd": motion["length_acceleration"].sel(member="actuator").values,
    }
    found |= dict(zip(("theta", "thd", "thdd"), _angle(motion, "O2", 1.0), strict=True))
    found |= dict(zip(("phi", "phid", "phidd"), _angle(motion, "O1", -1.0), strict=True))
    found |= {f"R{k}": forces.reaction.sel(support=f"O{k}").values for k in (1, 2)}
    for name, member in (("F_on_follower_at_B", "follower"), ("F_on_tube_at_B", "actuator")):
        found[name] = forces.joint_force.sel(member=member, end="B").values
    found["follower_mid_T_V_M"] = _section(sections, "follower", 3)
    found["tube_cantilever_T_V_M"] = _section(sections, "actuator.tube", 0) * (1, -1, -1)
    return found


def _angle(motion: Any, pivot: str, sense: float) -> tuple[Floats, Floats, Floats]:
    """Angle at a fixed pivot to B and its derivatives; sense 1: from +x counter-clockwise, -1: from -x clockwise."""
    r, v, a = (motion[name].sel(node="B").values * (sense, 1.0) for name in ("position", "velocity", "acceleration"))
    r = r - motion["position"].sel(node=pivot).values * (sense, 1.0)
    square, turn = (r * r).sum(1), r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0]
    second = (r[:, 0] * a[:, 1] - r[:, 1] * a[:, 0]) / square - 2 * (r * v).sum(1) * turn / square**2
    return np.arctan2(r[:, 1], r[:, 0]), turn / square, second


def _section(sections: Sections, part: str, station: int) -> Floats:
    at = sections.data.sel(part=part).isel(station=station)
    return np.stack([at["section_T"].values, at["section_V"].values[:, 0], at["section_M"].values[:, 0]], 1)


def outer_fibre(model: Model, sections: Sections, part: str, station: int) -> Floats:
    """Stress at S2 (times,), Pa: the outer fibre, |T|/A + |M| c/I."""
    found: Floats = strength.stresses(model, sections)["S2"].sel(part=part).isel(station=station).values
    return found


def maxima() -> dict[str, tuple[float, float]]:
    """Largest values and their times on the grid of 1 ms, as the reference takes them."""
    times = tuple(np.round(np.arange(3000) * 1e-3, 12).tolist())
    model, _, total, static = analysed(times)
    follower, follower_static = (outer_fibre(model, one, "follower", 3) for one in (total, static))
    tube, tube_static = (outer_fibre(model, one, "actuator.tube", 0) for one in (total, static))
    histories = {
        "follower_S2_mid_max": follower,
        "tube_cantilever_max": tube,
        "follower_static_max": follower_static,
        "tube_static_max": tube_static,
        "follower_dyn_minus_static_max": follower - follower_static,
        "tube_dyn_minus_static_max": tube - tube_static,
        "follower_max_compression_at_O1_end": -_section(total, "follower", 0)[:, 0],
        "tube_max_compression_at_cantilever": -_section(total, "actuator.tube", 0)[:, 0],
    }
    return {name: (float(values.max()), times[int(values.argmax())]) for name, values in histories.items()}


def cases() -> Iterator[Case]:
    """Samples to 1e-8, maxima to 1e-6."""
    data = load("triangle")
    source = Reference("independent", data["source"])
    times = tuple(float(t) for t in data["samples"])
    for i, (t, values) in enumerate(data["samples"].items()):
        for name, expected in values.items():
            yield from _sample_cases(f"triangle.t={t}.{name}", source, expected, times, i, name)
    for name, pair in data["maxima"].items():
        for k, what in enumerate(("", "_time")):
            yield Case(f"triangle.maximum.{name}{what}", source, pair[k], GRID, maxima, at=(name, k))


def _sample_cases(label: str, source: Reference, expected: Any, times: tuple[float, ...], i: int, name: str) -> Iterator[Case]:
    if name not in VECTORS:
        yield Case(label, source, expected, EXACT, history, (times,), (name, i))
        return
    for k, component in enumerate(VECTORS[name]):
        # T and V are the components of one force; the moment stands alone
        scale = 0.0 if component == "M" else max(map(abs, expected[:2]))
        yield Case(f"{label}.{component}", source, expected[k], EXACT, history, (times,), (name, (i, k)), scale)
