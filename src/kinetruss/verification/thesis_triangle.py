"""The triangular truss of Lacy (1991, chapters 2 and 3): exact samples and maxima, his statics and speeds, slower motions."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.measures import Numbers, at_times, without_weight

triangular, lacy_step = kt.library.vgt.triangular, kt.library.vgt.lacy_step

SAMPLES = (0.3, 0.6, 1.2, 1.8, 2.4)
"""s, of the exact samples."""
STEP = 0.06
TIMES = np.round(np.arange(50) * STEP, 12)
"""s, his samples."""
CUTS = {"follower": ("follower", 3), "tube": ("actuator.tube", 0)}
"""Parts, and stations of seven: the middle of the follower, the clamped end of the tube."""


def analysed(times: Any, payload: float = 10.0) -> tuple[kt.Model, kt.results.Forces, list[kt.results.Sections]]:
    """Model, forces, and section forces in motion and at rest, at times of his motion."""
    model = triangular(payload_mass=payload)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, lacy_step(), times=times))
    return model, forces, [kt.strength.sections(model, one) for one in (forces, forces.static) if one is not None]


def stresses(model: kt.Model, sections: kt.results.Sections) -> dict[str, Any]:
    """Stress at S2, |T|/A + |M| c/I, of both cuts (times,), Pa."""
    found = kt.strength.stresses(model, sections)["S2"]
    return {name: found.sel(part=part).isel(station=station).values for name, (part, station) in CUTS.items()}


def history() -> Numbers:
    """Everything the samples hold, in the signs of the reference.

    phi is clockwise at O1 from O1->O2; V and M are exerted on the B-side part, along the increasing-angle normal and in
    the same sense: for the follower, which turns clockwise, that is the product's own sign (its axis 2 is the opposite
    normal), for the tube minus it.
    """
    model, forces, (sections, _) = analysed(SAMPLES)
    motion = forces.motion.data.sel(member="actuator")
    phi, theta = (kt.kinematics.platform(model, forces.motion, (pivot, "B")) for pivot in ("O1", "O2"))
    found = {"x": motion.length - 2.5, "xd": motion.length_rate, "xdd": motion.length_acceleration}
    found |= {"theta": theta.angle, "thd": theta.angle_rate, "thdd": theta.angle_acceleration}
    found |= {"phi": np.pi - phi.angle, "phid": -phi.angle_rate, "phidd": -phi.angle_acceleration}
    for k, name, member, cut, sign in ((1, "follower", "follower", "mid", 1), (2, "tube", "actuator", "cantilever", -1)):
        found[f"R{k}"] = forces.reaction.sel(support=f"O{k}")
        found[f"F_on_{name}_at_B"] = forces.joint_force.sel(member=member, end="B")
        part, station = CUTS[name]
        at = sections.data.sel(part=part).isel(station=station, transverse=0, moment=0)
        cuts = {"T": at.section_T, "V": sign * at.section_V, "M": sign * at.section_M}
        found |= {f"{name}_{cut}_T_V_M.{kind}": values for kind, values in cuts.items()}
    return at_times(SAMPLES, found)


def rates() -> Numbers:
    """Rates of both members at the times of the samples; phi is measured clockwise."""
    model = triangular()
    turning = kt.kinematics.member_rates(model, kt.kinematics.follow(model, lacy_step(), times=SAMPLES)).isel(rotation=0)
    found = {}
    for symbol, member, sign in (("phi", "follower", -1), ("th", "actuator", 1)):
        found[f"{symbol}d"] = sign * turning.angular_velocity.sel(member=member)
        found[f"{symbol}dd"] = sign * turning.angular_acceleration.sel(member=member)
    return at_times(SAMPLES, found)


def maxima() -> Numbers:
    """Largest values and their times on the grid of 1 ms, as the reference takes them."""
    times = np.round(np.arange(3000) * 1e-3, 12)
    model, _, (total, static) = analysed(times)
    moving, still = stresses(model, total), stresses(model, static)
    tension = {name: total.data.section_T.sel(part=part).isel(station=0).values for name, (part, _) in CUTS.items()}
    histories = {"follower_S2_mid_max": moving["follower"], "tube_cantilever_max": moving["tube"]}
    histories |= {f"{name}_static_max": still[name] for name in CUTS}
    histories |= {f"{name}_dyn_minus_static_max": moving[name] - still[name] for name in CUTS}
    histories |= {"follower_max_compression_at_O1_end": -tension["follower"]}
    histories |= {"tube_max_compression_at_cantilever": -tension["tube"]}
    largest = {name: values.max() for name, values in histories.items()}
    return largest | {f"{name}_time": times[values.argmax()] for name, values in histories.items()}


def massless() -> kt.Model:
    """The truss of Table 3.2: members without mass, 98.1 N at B."""
    light = kt.Material(E=71e9, density=0.0)
    return triangular(material=light, base_mass=0.0, payload_mass=0.0, tip_force=(0.0, -98.1))


def table_3_2(by: str) -> Numbers:
    """Reactions, tensions and stresses, actuator at 2.5 m."""
    reaction, tension, stress = without_weight(massless(), {"actuator": 2.5}, by)
    found = {f"R_O{k}{axis}": reaction.sel(support=f"O{k}", axis=axis) for k in (1, 2) for axis in "xy"}
    for name, member in (("follower", "follower"), ("tube", "actuator")):
        found |= {f"tension_{name}": tension.sel(member=member), f"stress_{name}": stress.sel(member=member)}
    return found


def weight(by: str) -> Numbers:
    """Reactions at O1 of the truss at rest under its own weight."""
    model = triangular()
    found = kt.statics.linear(model).data if by == "stiffness" else kt.statics.at_poses(model, [{}]).data.isel(time=0)
    return {f"R_O1{axis}": found.reaction.sel(support="O1", axis=axis) for axis in "xy"}


def drive() -> Numbers:
    """Largest actuator speed on his samples, and the gear that lets a motor of 400 rad/s follow it."""
    motion = kt.kinematics.follow(triangular(), lacy_step(), times=TIMES)
    speed = float(np.abs(motion.length_rate.sel(member="actuator").values).max())
    ratio = kt.actuators.gear_ratio_for(kt.library.drives.SCREW_LACY_PLANAR, 400.0, speed)
    return {"largest_speed": speed, "gear_ratio": ratio}


def static(payload: float) -> Numbers:
    """Sections 3.3 and 3.5: stresses at rest on his samples, the largest and that at the printed 1.80 s."""
    model, _, (_, still) = analysed(TIMES, payload)
    found = stresses(model, still)
    there = found["follower"][TIMES == 1.74].item()
    return {"follower_static_there": there} | {f"{name}_static_largest": values.max() for name, values in found.items()}


def euler_load() -> Numbers:
    """Table 3.3: of the follower, 2 m long with pinned ends."""
    model = triangular()
    bar = model.bars["follower"]
    return {"euler_load": kt.strength.euler_load(71e9, model.section_of(bar).second_moments[0], 2.0, bar.buckling)}


def slow(duration: float) -> Numbers:
    """Largest stress at rest, how far the motion lifts the stress above it, and the one over the other, by part.

    Stretched in time, the same path has rates smaller by the factor and second rates by its square, so what the motion adds
    to the forces at rest falls with the square of the duration, and so do stresses where no sign changes. The distance from
    rest follows from the reference values of the 3 s motion without any computation of this package.
    """
    step = kt.StepResponse(moves={"actuator": (2.5, 3.7)}, duration=3.0, damping=0.8, settling_factor=6.0)
    model = triangular().with_(runs={"extend": kt.Run(trajectory=step, samples=3001)})
    (run,) = kt.runs.run_variants(model, {"runs.extend.trajectory.duration": [duration]}).values()
    found = {}
    for name, (part, station) in CUTS.items():
        (curve,) = kt.report.curves(run, "S2", [part], station=station / 6)
        still: Any = curve.static
        above = curve.values - still
        values = {"static_max": still.max(), "distance": above.max(), "distance_time": curve.time[above.argmax()]}
        found[name] = values | {"distance_over_static": above.max() / still.max()}
    return found
