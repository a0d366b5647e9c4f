"""The triangular truss against exact physics: samples of the motion, and the maxima on a grid of 1 ms."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import kinetruss as kt

Floats = NDArray[np.float64]

SAMPLES = (0.3, 0.6, 1.2, 1.8, 2.4)
"""s, of the reference."""


def truss(payload: float = 10.0, massless: bool = False) -> kt.Model:
    """The truss of Lacy (1991, chapters 2 and 3); massless: Table 3.2, only a force of 98.1 N at B."""
    model = kt.library.vgt.triangular(
        actuator_length=2.5,
        follower_length=2.0,
        span=2.0,
        tube_length=2.0,
        section=kt.Tube(outer=0.0254, inner=0.022225),
        material=kt.Material(E=71e9, density=0.0 if massless else 2711.5),
        base_mass=0.0 if massless else 2.4,
        base_length=2.1,
        payload_mass=0.0 if massless else payload,
        gravity=(0.0, -9.81),
    )
    weight = kt.NodalForce(node="B", force=(0.0, -payload * 9.81))
    return model.with_(loads={"weight": weight}) if massless else model


def analysed(
    times: tuple[float, ...], payload: float = 10.0, massless: bool = False
) -> tuple[kt.Model, kt.results.Forces, kt.results.Sections, kt.results.Sections]:
    """Model, forces, section forces and static section forces at the given times of the thesis' motion."""
    model = truss(payload, massless)
    motion = kt.kinematics.follow(model, kt.library.vgt.lacy_step(), times=np.array(times))
    forces = kt.dynamics.inverse(model, motion)
    total, static = (kt.strength.sections(model, one) for one in (forces, forces.static) if one is not None)
    return model, forces, total, static


def history() -> dict[str, dict[str, Any]]:
    """Everything the samples hold, in the signs of the reference.

    phi is clockwise at O1 from O1->O2; V and M are exerted on the B-side part, along the increasing-angle normal and in
    the same sense: for the follower, which turns clockwise, that is the product's own sign (its axis 2 is the opposite
    normal), for the tube minus it.
    """
    _, forces, sections, _ = analysed(SAMPLES)
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
    cuts = {"follower_mid_T_V_M": _section(sections, "follower", 3)}
    cuts["tube_cantilever_T_V_M"] = _section(sections, "actuator.tube", 0) * (1, -1, -1)
    return {
        f"t={t:g}": {name: values[i] for name, values in found.items()}
        | {name: dict(zip("TVM", values[i], strict=True)) for name, values in cuts.items()}
        for i, t in enumerate(SAMPLES)
    }


def _angle(motion: Any, pivot: str, sense: float) -> tuple[Floats, Floats, Floats]:
    """Angle at a fixed pivot to B and its derivatives; sense 1: from +x counter-clockwise, -1: from -x clockwise."""
    r, v, a = (motion[name].sel(node="B").values * (sense, 1.0) for name in ("position", "velocity", "acceleration"))
    r = r - motion["position"].sel(node=pivot).values * (sense, 1.0)
    square, turn = (r * r).sum(1), r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0]
    second = (r[:, 0] * a[:, 1] - r[:, 1] * a[:, 0]) / square - 2 * (r * v).sum(1) * turn / square**2
    return np.arctan2(r[:, 1], r[:, 0]), turn / square, second


def _section(sections: kt.results.Sections, part: str, station: int) -> Floats:
    at = sections.data.sel(part=part).isel(station=station)
    return np.stack([at["section_T"].values, at["section_V"].values[:, 0], at["section_M"].values[:, 0]], 1)


def outer_fibre(model: kt.Model, sections: kt.results.Sections, part: str, station: int) -> Floats:
    """Stress at S2 (times,), Pa: the outer fibre, |T|/A + |M| c/I."""
    found: Floats = kt.strength.stresses(model, sections)["S2"].sel(part=part).isel(station=station).values
    return found


def maxima() -> dict[str, float]:
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
    return {name: values.max() for name, values in histories.items()} | {
        f"{name}_time": times[int(values.argmax())] for name, values in histories.items()
    }
