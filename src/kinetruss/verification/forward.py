"""Forward dynamics: pendulums, bars of each law, free linkages and bodies, Andrews' mechanism, orders of convergence."""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model, stored
from kinetruss.verification.measures import Numbers, change, drift

simulate, mechanisms = kt.dynamics.simulate, kt.library.mechanisms

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)
METHODS: dict[str, Any] = {"dop853": kt.DOP853, "radau": kt.Radau, "taylor": kt.Taylor}


def pendulum(method: str) -> Numbers:
    """Places of the bob at whole seconds, from horizontal; tension of the bar less its closed form 3 m g cos(angle)."""
    hung = mechanisms.pendulum(angle=-math.pi / 2)
    run = simulate(hung, 10.0, samples=11, method=METHODS[method](rtol=1e-12, atol=1e-13))
    at, weight = run.motion.position.sel(node="P1").values, 9.81
    tension = run.forces.member_force.sel(member="link1").values
    found = {f"{axis}_at_{k}s": at[k, i] for k in range(1, 11) for i, axis in enumerate("xy")}
    return found | {"tension": np.abs(tension + 3 * weight * at[:, 1]).max() / (3 * weight)}


def triple(method: str) -> Numbers:
    """Places of the tip of three rods."""
    fine, times = METHODS[method](rtol=1e-12, atol=1e-13), (0.5, 1.0, 2.0)
    tip = simulate(mechanisms.n_pendulum(links=3), 2.0, times=[0.0, *times], method=fine).motion.position.sel(node="P3")
    return {f"{axis}_at_{t:g}s": tip.sel(time=t, axis=axis) for t in times for axis in "xy"}


def order(method: str) -> Numbers:
    """log2 of the ratio of the errors (root mean square over the nodes) with a step and half of it, of three rods at 0.5 s."""
    exact, errors = stored("forward")["exact"]["triple_pendulum"], []
    for steps in {"dop853": (12, 24), "radau": (25, 50), "taylor": (50, 100)}.get(method, (200, 400)):
        h = 0.5 / steps
        chosen = {
            "dop853": kt.DOP853(step=h),
            "energy_momentum": kt.EnergyMomentum(h),
            "generalized_alpha": kt.GeneralizedAlpha(h),
            "radau": kt.Radau(rtol=1e-12, step=h),
            "rattle": kt.Rattle(h),
            "taylor": kt.Taylor(order=6, step=h),
        }[method]
        run = simulate(mechanisms.n_pendulum(links=3), 0.5, times=[0.0, 0.5], method=chosen)
        errors.append(np.sqrt(np.mean((run.motion.position.values[-1, 1:] - exact) ** 2)))
    return {"order": math.log2(errors[0] / errors[1])}


def chaotic() -> Numbers:
    """Change of energy, relative to the largest kinetic one, and elongation of the bars, of a double pendulum released from a
    high position, over 1,000 s.
    """
    run = simulate(mechanisms.double_pendulum(angles=(2.0, 2.5)), 1000.0, samples=2001, method=kt.EnergyMomentum(0.01))
    return {"energy": drift(run), "length": abs(run.motion.length - 1).max()}


def stiff() -> Numbers:
    """Change of energy, of the largest kinetic one, of a stiff pendulum (Green's strain) over 1,000 swings of its bar."""
    return {"energy": drift(simulate(model("stiff_pendulum"), 10.0, samples=101, method=kt.EnergyMomentum(0.01)))}


def swing(law: str) -> Numbers:
    """Distance of a mass on a bar with a law; it starts from rest at 1.3 m."""
    laws: Any = {"engineering": {"mass": 1.5}, "damped": {"damping": 3.0}, "green": {"strain": "green"}}
    plain, times = model("mass_on_a_spring"), (0.5, 1.0, 2.5, 5.0)
    spring = plain.with_(bars={"bar": plain.bars["bar"].with_(**laws[law])})
    x = simulate(spring, 5.0, times=[0.0, *times], method=FINE).motion.position.sel(node="P", axis="x")
    return {f"{t:g}s": x.sel(time=t) for t in times}


def afloat() -> Numbers:
    """Net turns, rad, of what floats without momentum: two bodies whose hinge makes a full turn, and a body that swings two
    masses out, turns them, takes them in and turns them back.
    """
    pair, cat = model("two_bodies_afloat"), model("body_with_arms")
    start, turn = 0.5 * math.pi, np.array([0, 0, 1.2, 1.2, 0.0])
    full = kt.Quintic(moves={"turn": (start, start + 2 * math.pi)}, duration=3.0)
    arm = (0.5, 1.4, 1.4, 0.5, 0.5)
    values = {"left": tuple(start + turn), "right": tuple(turn - start), "up": arm, "down": arm}
    cycle = kt.Spline(times=(0, 1, 2, 3, 4), values=values, shape="monotone")

    def turned(of: kt.Model, along: Any) -> float:
        motion = kt.kinematics.follow(of, along, samples=41)
        d = motion.position.sel(node="P").values - motion.position.sel(node="O").values
        return float(np.unwrap(np.arctan2(d[:, 1], d[:, 0]))[-1])

    return {"hinge": turned(pair, full), "cycle": turned(cat, cycle)}


def tracked() -> Numbers:
    """Error, m, of a mass that follows 0.2 m/s from rest by feedback of 50 N/m and 4 N s/m, and with at most 0.3 N."""
    mass, away = model("driven_mass"), kt.ConstantRate(rates={"jack": 0.2}, duration=2.0)
    times = [0.0, 0.5, 1.0, 2.0]
    fed = kt.Tracking(stiffness=50.0, damping=4.0, feedforward=False)
    error = simulate(mass, 2.0, times=times, trajectory=away, method=FINE, feedback=fed).data["tracking_error"].values[:, 0]
    found = {f"error_at_{t:g}s": error[k] for k, t in enumerate(times) if t}
    fast, weak = kt.ConstantRate(rates={"jack": 5.0}, duration=1.0), kt.Tracking(damping=10.0, limits=0.3, feedforward=False)
    run = simulate(mass, 1.0, samples=2, trajectory=fast, method=FINE, feedback=weak)
    return found | {"limited": run.motion.position.sel(node="B", axis="x")[-1]}


def caught() -> Numbers:
    """Height under the hook while falling, held and thrown back; when the cable becomes tight and slack."""
    # s, w: the elongation g/w^2 (1 - cos) + g t/w sin is zero again at tan(w tau/2) = -w t
    tight, w = math.sqrt(2 * 0.6 / 9.81), math.sqrt(2000.0 / 2.0)
    slack = tight + 2 * (math.pi - math.atan(tight * w)) / w
    watched = {
        "tight": kt.Event(length="cable", value=1.0, direction="rising", stop=False),
        "slack": kt.Event(length="cable", value=1.0, direction="falling", stop=False),
    }
    times = [0.0, 0.3, 0.5 * (tight + slack), slack + 0.2]
    run = simulate(model("caught_mass"), times[-1], times=times, method=FINE, events=watched)
    _, falling, lowest, thrown = run.motion.position.sel(node="P", axis="y")
    first = {event.name: event.time for event in reversed(run.events)}
    tension = run.forces.member_force.sel(member="cable")[2]
    return first | {"falling": falling, "lowest": lowest, "tension": tension, "thrown": thrown}


def row(loops: int, method: str) -> Numbers:
    """How far a row of four-bars ends from where it should, m and m/s, by the settings of a method; change of energy."""
    chosen = None if method == "default" else METHODS[method]()
    run = simulate(mechanisms.n_four_bar(loops=loops), 10.0, samples=1001, method=chosen)
    end = run.motion.data.isel(time=-1).sel(node=[f"B{k}" for k in range(loops + 1)])
    place = end.position.values - [(float(k), 0.0) for k in range(loops + 1)]
    exact = stored("forward")["exact"]["n_four_bar"][loops]
    return {
        "energy": drift(run),
        "place": np.abs(place - [exact["x"], exact["y"]]).max(),
        "speed": np.abs(end.velocity.values - [exact["vx"], exact["vy"]]).max(),
    }


def twice() -> Numbers:
    """Two windows whose middle post is there twice: largest difference of motion and forces from those without."""
    windows = mechanisms.n_four_bar(loops=2)
    double = windows.with_(bars=dict(windows.bars) | {"again": windows.bars["post1"].with_(mass=0.0)})
    one, two = (simulate(each, 2.0, samples=41, method=kt.DOP853(rtol=1e-11, atol=1e-12)) for each in (windows, double))
    forces = (run.forces.member_force for run in (one, two))
    single, both = (dict(zip(force.member.values, force.values.T, strict=True)) for force in forces)
    misses = {
        "sum": both["post1"] + both["again"] - single["post1"],
        "share": both["post1"] - both["again"],
        "others": np.array([both[name] - single[name] for name in single if name != "post1"]),
    }
    largest = abs(one.forces.member_force).max()
    motion = abs(one.motion.position - two.motion.position).max()
    return {name: np.abs(values).max() / largest for name, values in misses.items()} | {"motion": motion}


def slider() -> Numbers:
    """Crank pin, slider and its speed, of a slider-crank in space, at whole seconds."""
    motion = simulate(mechanisms.spatial_slider_crank(), 2.0, samples=3, method=FINE).motion
    wanted = {"y_P": ("position", "P", "y"), "z_P": ("position", "P", "z"), "x_S": ("position", "S", "x")}
    wanted["v_S"] = ("velocity", "S", "x")
    values = {name: motion.data[kind].sel(node=node, axis=axis) for name, (kind, node, axis) in wanted.items()}
    return {f"{name}_at_{t}s": value.sel(time=t) for t in (1, 2) for name, value in values.items()}


def tumble() -> Numbers:
    """Largest distance of the nodes of a symmetric top from the closed form at 5 and 10 s, m."""
    run = simulate(model("bipyramid"), 10.0, samples=3, method=kt.DOP853(rtol=1e-12, atol=1e-13))
    return {"place": np.abs(run.motion.position.values[1:] - stored("forward")["exact"]["bipyramid"]).max()}


def conserved(method: str) -> Numbers:
    """Changes over 10 s: of energy as a fraction of the largest kinetic one, of momenta as a fraction of their size."""
    chosen = kt.EnergyMomentum(0.002) if method == "energy_momentum" else None
    run = simulate(model("hinged_tetrahedra"), 10.0, samples=201, method=chosen)
    momenta = {name: run.data[name].values for name in ("momentum", "angular_momentum")}
    return {"energy": drift(run)} | {name: change(p) / np.linalg.norm(p[0]) for name, p in momenta.items()}


TURNS = {
    "beta": ("OF", 0.0),
    "beta+Theta": ("EF", 0.0),
    "gamma": ("BE", math.pi / 2),
    "Phi+delta": ("GE", math.pi / 2),
    "delta": ("AG", 0.0),
    "Omega+epsilon": ("HE", 0.0),
    "epsilon": ("AH", math.pi / 2),
}
"""Sums of angles that are directions of Andrews' bars, first to second letter, and what they differ by."""


def andrews(method: str) -> Numbers:
    """Angles with rates, places, forces and multipliers of Andrews' mechanism at the start (``start.``) and at 0.03 s."""
    rtol, atol = (1e-12, 1e-14) if method == "radau" else (1e-13, 1e-15)
    squeezer = mechanisms.andrews()
    tasks = {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
    run = simulate(squeezer, 0.03, samples=301, tasks=tasks, method=METHODS[method](rtol=rtol, atol=atol))
    found: Numbers = {"": run.motion.position.isel(time=-1).sel(node=list("FEDGH"))}
    angles, kinds = {}, {"angle": "angle", "rate": "angle_rate", "acceleration": "angle_acceleration"}
    for name, (bar, turn) in TURNS.items():
        one = kt.kinematics.platform(squeezer, run.motion, tuple(bar))
        one["angle"] = one.angle + turn
        for kind, key in kinds.items():
            angles[f"{kind}.{name}"] = one[key].values
    for kind in kinds:
        for name, other in (("beta+Theta", "beta"), ("Phi+delta", "delta"), ("Omega+epsilon", "epsilon")):
            single = name.replace(other, "").strip("+")
            angles[f"{kind}.{single}"] = angles[f"{kind}.{name}"] - angles[f"{kind}.{other}"]
    for prefix, i in (("start.", 0), ("", -1)):
        found |= {f"{prefix}{name}": values[i] for name, values in angles.items()}
        found |= {f"{prefix}force": run.forces.member_force.isel(time=i)}
        found |= {f"{prefix}{name}": value for name, value in multipliers(run.forces, i).items()}
    return found


def multipliers(forces: kt.results.Forces, i: int) -> Numbers:
    """Forces at joint E on the bodies of B, G and H: the multipliers of the three loops."""
    end = forces.joint_force.isel(time=i)
    found: Numbers = {}
    for k, bars in enumerate((("BE", "ED"), ("GE",), ("HE",))):
        # E is the second end of all bars but ED, which belongs to the body of BE
        x, y = sum(end.sel(member=bar, end="A" if bar == "ED" else "B").values for bar in bars)
        found |= {f"multiplier.{2 * k + 1}": x, f"multiplier.{2 * k + 2}": y}
    return found


def andrews_backwards() -> Numbers:
    """Torque of the motor and multipliers of the three loops at 0.03 s, from the exact motion of the nodes."""
    squeezer, exact = mechanisms.andrews(), stored("forward")["exact"]["andrews"]
    motion = np.array([exact[name] for name in squeezer.nodes])
    given = kt.kinematics.from_arrays(squeezer, [0.0, 1.0], *(np.stack([motion[:, k]] * 2) for k in range(3)))
    forces = kt.dynamics.inverse(squeezer, given, static=False)
    return {"torque": forces.drive_force.sel(drive="motor")[0]} | multipliers(forces, 0)


def beam(form: Literal["beam", "conventional"] = "beam") -> Numbers:
    """Andrews' mechanism with the rotation of its crank as a coordinate, at 0.03 s; and the coordinates counted."""
    squeezer, tasks = mechanisms.andrews(form=form), {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
    counts = kt.kinematics.mobility(squeezer)
    run = simulate(squeezer, 0.03, samples=31, tasks=tasks, method=kt.DOP853(rtol=1e-13, atol=1e-15))
    at = run.motion.data.isel(time=-1)
    found = {name: at[name].sel(node="beta", axis="x") for name in ("position", "velocity", "acceleration")}
    places = {"": at["position"].sel(node=list("FEDGH"))}
    return found | places | {"coordinates": counts.coordinates, "fixed": counts.fixed, "freedoms": counts.degrees_of_freedom}
