"""Joints in more than name: hubs and their arms, friction of bearings, screws in series, springs about hinges, columns."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, change, modes, share

simulate, follow, at_poses = kt.dynamics.simulate, kt.kinematics.follow, kt.statics.at_poses

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)


def _size(vector: Any) -> float:
    return float(np.linalg.norm(vector))


def _roots(name: str) -> Any:
    """Section forces and von Mises stresses at the A ends of the parts of a model at rest."""
    held = model(name)
    sections = kt.strength.sections(held, at_poses(held, [{}]), 2)
    stress = kt.strength.stresses(held, sections).von_mises
    return sections.data.assign(von_mises=stress).isel(time=0, station=0)


def bracket() -> Numbers:
    """Moment of a member at its vertical hinge, torsion and moment of the arm across it, under 20 N at 1 m."""
    found = _roots("bracket_on_a_hinge")
    member, arm = (_size(found.section_M.sel(part=part)) for part in ("arm", "O.arm"))
    return {"member": member, "arm": arm, "torsion": abs(found.torsion.sel(part="O.arm"))}


def slowing(form: str) -> Numbers:
    """Rate of a mass on a light arm after 1 s in a bearing, from 6 rad/s: a pin of the plane, or a hinge in space."""
    run = simulate(model(f"slowing.{form}"), 1.0, samples=2)
    return {"rate": _size(run.motion.velocity.sel(node="A")[-1]) / 0.5}


def door() -> Numbers:
    """Torque that turns a door steadily against the friction of its hinge."""
    leaf = model("door")
    motion = follow(leaf, kt.ConstantRate(rates={"turn": 3.0}, duration=0.5), samples=3)
    return {"torque": kt.dynamics.inverse(leaf, motion).drive_force[1, 0]}


def twisted() -> Numbers:
    """Torsion and moment of an arm at 45 degrees to a couple of 30 N m that enters at its joint, and its stress."""
    found = _roots("twisted_arm").sel(part="O.rod")
    return {"torsion": found.torsion, "moment": _size(found.section_M), "stress": found.von_mises}


def masses() -> Numbers:
    """Axial forces of an active member that turns at 3 rad/s: at the clamped end of its base, behind the mass on it, at the
    nut, and in the tube up to its mass.
    """
    rods = model("masses_on_rods")
    motion = follow(rods, kt.ConstantRate(rates={"turn": 3.0, "a": 0.0}, duration=0.5), samples=3)
    forces = kt.dynamics.inverse(rods, motion)
    T = kt.strength.sections(rods, forces, [0.0, 0.5, 1.0]).data.section_T[1]
    base, tube = T.sel(part="a.base"), T.sel(part="a.tube")
    return {"base": base[0], "behind": base[1], "drive": forces.drive_force.sel(drive="a")[1], "tube": tube[1]}


def arm_of_hub() -> Numbers:
    """Couple and stress at the root of an arm of 50 mm from which 200 N hang."""
    found = _roots("bracket_of_a_hub").sel(part="A.rod")
    return {"couple": abs(found.section_M[0]), "stress": found.von_mises}


def linkage() -> Numbers:
    """A heavy four-bar linkage with hubs: residuals of all free bodies and of the energy, relative."""
    four, start = model("heavy_linkage"), math.atan2(0.15, 0.05)
    motion = follow(four, kt.Quintic(moves={"motor": (start, start + 1.0)}, duration=0.4), samples=9)
    return _left(four, kt.dynamics.inverse(four, motion), (0.1, 0.2, 0.25))


def _left(held: kt.Model, forces: kt.results.Forces, times: tuple[float, ...]) -> Numbers:
    """Residuals of the free bodies of all members and nodes, over the largest joint force, and of the energy."""
    cuts = [{"member": name} for name in held.whole.real_members]
    cuts += [{"node": name} for name in held.whole.nodes]
    left = [kt.dynamics.free_body(held, forces.motion, forces, time=t, **cut).residual for t in times for cut in cuts]
    data = forces.data
    return {"free_bodies": max(left) / abs(data.joint_force).max(), "energy": share(data.energy_balance, data.power)}


def bay_with_hubs(stroke: float) -> Numbers:
    """The massless bay with joints 40 mm off its nodes, 200 N on each corner, its actuators longer by a stroke: height of its
    top, force of an actuator.
    """
    light = kt.Material(E=71e9, density=0.0)
    none: dict[str, Any] = {"material": light, "base_mass": 0.0, "tube_mass": 0.0, "gravity": None}
    bay = kt.library.vgt.double_octahedral(joint_offset=0.04, tip_force=(0, 0, -200.0), **none)
    found = at_poses(bay, [dict.fromkeys(("M7", "M9", "M11"), 1.1684 - 0.08 + stroke)])
    return {"height": found.motion.position.sel(node="N7", axis="z")[0], "force": found.drive_force[0, 0]}


def slewed_bay_with_hubs() -> Numbers:
    """A bay with heavy members and joints 30 mm off its nodes in a slew: as `linkage`."""
    bay = kt.library.vgt.double_octahedral(joint_offset=0.03, payload_mass=5.0)
    slew = kt.Quintic(moves={"M7": (1.1084, 1.05), "M9": (1.1084, 1.13), "M11": (1.1084, 1.14)}, duration=1.0)
    forces = kt.dynamics.inverse(bay, follow(bay, slew, samples=5))
    return _left(bay, forces, (0.25, 0.75))


def pendulum() -> Numbers:
    """Additional torque of the drive of a pendulum by its pin, at both ends of a turn of 1 rad at 2 rad/s."""
    smooth = model("driven_pendulum")
    rough = smooth.with_(bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.03, friction=0.2)})
    motion = follow(smooth, kt.ConstantRate(rates={"turn": 2.0}, duration=0.5), samples=3)
    more, less = (kt.dynamics.inverse(one, motion).drive_force for one in (rough, smooth))
    return {"start": more[0, 0] - less[0, 0], "end": more[-1, 0] - less[-1, 0]}


def circles() -> Numbers:
    """Sine of the angle between a massless rod and its force, less that of the tangent to both friction circles."""
    four = model("linkage_with_friction")
    motion = follow(four, kt.ConstantRate(rates={"motor": 1e-3}, duration=1000.0), samples=9)
    push = kt.dynamics.inverse(four, motion).joint_force.sel(member="coupler", end="B").values
    rates = kt.kinematics.member_rates(four, motion)
    crank, coupler, rocker = rates.angular_velocity.values[:, :, 0].T
    (x, y), length = rates.direction.sel(member="coupler").values.T, motion.length.sel(member="coupler").values
    sine = (x * push[:, 1] - y * push[:, 0]) / np.linalg.norm(push, axis=1)
    exact = (0.003 * np.sign(coupler - crank) + 0.006 * np.sign(coupler - rocker)) / length
    return {"angle": np.abs(sine - exact).max()}


def in_series() -> Numbers:
    """Elongation of a tie with screw and nut, and how far the load under it sinks."""
    found = kt.statics.linear(model("crane_on_a_screw"))
    return {"elongation": found.elongation.sel(member="tie"), "sinks": -found.displacement.sel(node="C", axis="y")}


def screw() -> Numbers:
    """Torque of the screw about the axis of the tie as it starts to lift the load (in tension: negative)."""
    crane = model("crane_on_a_screw")
    crane = crane.with_(active={"tie": crane.active["tie"].with_(compliance=None)})
    motion = follow(crane, kt.ConstantRate(rates={"tie": -0.01}, duration=1.0), samples=3)
    demand = kt.actuators.evaluate(crane, motion, kt.dynamics.inverse(crane, motion))
    return {"torque": demand.data.axis_torque.sel(active="tie")[0]}


def _arm(start: float, gravity: float = 0.0, **law: Any) -> kt.Model:
    """2 kg on an arm of 1.5 m about O, at an angle from +x, with a spring of 30 N m/rad about O; gravity along +x."""
    drawn = model("sprung_arm")
    place = drawn.nodes["P"].with_(at=(1.5 * math.cos(start), 1.5 * math.sin(start)))
    springs = {"hinge": drawn.springs["hinge"].with_(**law)}
    return drawn.with_(nodes=dict(drawn.nodes) | {"P": place}, gravity=(gravity, 0.0), springs=springs)


def swing(damping: float) -> Numbers:
    """Angle of the arm, from rest at 1 rad."""
    times = (0.5, 1.0, 2.5, 5.0)
    run = simulate(_arm(1.0, damping=damping), 5.0, times=[0.0, *times], method=FINE)
    return {f"{t:g}s": run.forces.spring_value.sel(spring="hinge", time=t) for t in times}


def crossing(start: float, gravity: float, play: float) -> Numbers:
    """When the arm first passes its rest."""
    passed = {"rest": kt.Event(coordinate="P.y", value=0.0, direction="falling")}
    return {"time": simulate(_arm(start, gravity, play=play), 5.0, method=FINE, events=passed).events[0].time}


def friction() -> Numbers:
    """Angles at the turns of an arm that friction of 1.5 N m slows down."""
    half = math.pi / math.sqrt(30.0 / (2.0 * 1.5**2))
    stiff, times = kt.Radau(rtol=1e-9, atol=1e-10), [half * k for k in range(5)]
    run = simulate(_arm(1.0, friction=1.5, slip=1e-5), 4 * half, times=times, method=stiff)
    return {f"turn_{k}": angle for k, angle in enumerate(run.forces.spring_value.sel(spring="hinge")) if k}


def torque() -> Numbers:
    """Torque of a motor about the hinge against spring, damper and friction, from rest to rest and back."""
    found: Numbers = {}
    turn = kt.HingeDrive(axis="O", start="G", end="P")
    arm = _arm(0.0, damping=0.7, friction=0.4).with_(drives={"motor": turn})
    for name, move in (("out", (0.0, 1.0)), ("back", (1.0, 0.0))):
        forces = kt.dynamics.inverse(arm, follow(arm, kt.Quintic(moves={"motor": move}, duration=1.0), samples=5))
        found |= {f"{name}.{t:g}s": forces.drive_force.sel(time=t, drive="motor") for t in (0.25, 0.5)}
        found[f"{name}.power"] = abs(forces.energy_balance).max()
    return found


def small() -> Numbers:
    """Frequency and damping about the lowest place."""
    found = kt.dynamics.linearise(_arm(0.0, 9.81, damping=1.2))
    return {"frequency": found.angular_frequency.item(), "damping": found.modal_damping.item()}


def post_buckled() -> Numbers:
    """Lean of a column of 2 m on a spring of 100 N m/rad, from 0.02 rad on, under the load that leans it by 1 rad."""
    load = kt.NodalForce(node="B", force=(0.0, -100.0 * (1.0 - 0.02) / (2.0 * math.sin(1.0))))
    found = kt.statics.equilibrium(model("leaning_column").with_(loads={"P": load}))
    x, y = found.position.sel(node="B").values
    return {"lean": math.atan2(x, y), "moment": found.spring_force.item()}


def folding() -> Numbers:
    """Two free triangles with a spring about their common edge: what energy and momenta change by in 10 s."""
    triangles = model("folding_triangles")
    run = simulate(triangles, 10.0, method=FINE, samples=51)
    again = kt.dynamics.inverse(triangles, run.motion)
    changes = {name: change(run.data[name].values) for name in ("momentum", "angular_momentum")}
    force = np.abs(again.spring_force.values - run.forces.spring_force.values).max()
    return changes | {"energy": np.ptp(run.energy.values), "inverse": force}


def _links(places: Any, nodes: dict[str, Any], bars: dict[str, Any], **fields: Any) -> kt.Model:
    """A chain of rigid links from place to place; more nodes and bars."""
    names = [f"N{k}" for k in range(len(places))]
    links = {f"b{k}": (names[k], names[k + 1]) for k in range(len(places) - 1)}
    return kt.Model(nodes=dict(zip(names, places, strict=True)) | nodes, bars=links | bars, **fields)


def _about(node: str, start: str, end: str, stiffness: float) -> kt.Spring:
    return kt.Spring(coordinate=kt.HingeDrive(axis=node, start=start, end=end), stiffness=stiffness)


def links(count: int) -> Numbers:
    """Buckling factors of a column of rigid links of 1 m on springs of 12 N/m from the side."""
    inner = range(1, count)
    walls = {f"W{i}": (1.0, float(i)) for i in inner}
    springs = {f"s{i}": kt.Bar(ends=(f"N{i}", f"W{i}"), kind="elastic", stiffness=12.0) for i in inner}
    fixed = {"N0": "xy", f"N{count}": "x"} | dict.fromkeys(walls, "xy")
    loads = {"P": kt.NodalForce(node=f"N{count}", force=(0.0, -1.0))}
    column = _links([(0.0, float(i)) for i in range(count + 1)], walls, springs, fixed=fixed, loads=loads)
    return modes(kt.statics.buckling(column, "P").load_factor)


def column(count: int) -> Numbers:
    """Loads at which a column of links of 0.5 m buckles; springs of 12 N m/rad between them, or about the foot of one."""
    springs = {f"s{k}": _about(f"N{k}", f"N{k - 1}", f"N{k + 1}", 12.0) for k in range(1, count)}
    fixed = {"N0": "xy", "W": "xy"} | ({f"N{count}": "x"} if count > 1 else {})
    loads = {"P": kt.NodalForce(node=f"N{count}", force=(0.0, -1.0))}
    places, springs = [(0.0, 0.5 * k) for k in range(count + 1)], springs or {"foot": _about("N0", "W", "N1", 12.0)}
    upright = _links(places, {"W": (1.0, 0.0)}, {}, fixed=fixed, loads=loads, springs=springs)
    return modes(kt.statics.buckling(upright, "P").load_factor)


def elastica() -> Numbers:
    """Slope at the tip of a clamped chain of links under a load across it, by the number of links; the order of its error."""
    coarse, middle, fine = (_tip(count) for count in (8, 16, 32))
    return {"order": math.log2((coarse - middle) / (middle - fine)), "slope": (4 * fine - middle) / 3}


def _tip(count: int) -> float:
    """Slope of the last link of an elastic line of length 1 and E I = 1 under 2 N, as `count` links."""
    h = 1.0 / count
    springs = {"N0": _about("N0", "W", "N1", 2.0 / h)}
    springs |= {f"N{k}": _about(f"N{k}", f"N{k - 1}", f"N{k + 1}", 1.0 / h) for k in range(1, count)}
    loads, places = {"tip": kt.NodalForce(node=f"N{count}", force=(0.0, 2.0))}, [(k * h, 0.0) for k in range(count + 1)]
    chain = _links(places, {"W": (-h, 0.0)}, {}, fixed=["N0", "W"], springs=springs, loads=loads)
    x = kt.statics.equilibrium(chain).position
    dx, dy = (x.sel(node=f"N{count}") - x.sel(node=f"N{count - 1}")).values
    return math.atan2(dy, dx)
