"""What presses a bearing in a simulation: the joint force of its record, whatever acts on its member; motors with bearings."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.bearing_friction import relative_rates, seats_of
from kinetruss.mechanics import compile

STEEL: dict[str, Any] = {"section": kt.Rod(diameter=0.03), "material": "steel_s235"}
THROWN = {"A": (0.1, -0.5), "B": (0.3, -2.0)}
SPUN = {"T": (0.3, 1.0, -0.5), "O": (0, -0.4, 0.3)}


def hinge(axis: str, start: str, end: str) -> kt.HingeDrive:
    return kt.HingeDrive(axis=axis, start=start, end=end)


def _made(given: dict[str, Any], more: dict[str, Any]) -> kt.Model:
    """A model of fields; tables of the second come to those of the first."""
    joined = {name: given[name] | one if isinstance(given.get(name), dict) else one for name, one in more.items()}
    return kt.Model(**given | joined)


def pendulum(**more: Any) -> kt.Model:
    """Two links on pins with friction, a mass at the end."""
    given = {
        "nodes": {"O": (0, 0), "A": (0.4, 0.1), "B": kt.Node(at=(0.9, 0.4), mass=1.5), "G": (1.0, -0.3)},
        "fixed": ["O", "G"],
        "gravity": (0, -9.81),
        "bars": {"upper": kt.Bar(ends=("O", "A"), mass=1.0), "lower": kt.Bar(ends=("A", "B"), mass=0.7)},
        "bearings": {
            "top": kt.Bearing(member="upper", node="O", radius=0.02, friction=0.15),
            "elbow": kt.Bearing(member="lower", node="A", radius=0.03, friction=0.2),
        },
    }
    return _made(given, more)


def four_bar(**more: Any) -> kt.Model:
    """A four-bar with three bearings, or a hub that clamps the rocker."""
    given = {
        "nodes": {"O": (0, 0), "A": (0.1, 0.3), "B": (0.9, 0.6), "Q": (1.0, 0)},
        "fixed": ["O", "Q"],
        "gravity": (0, -9.81),
        "bars": {"crank": ("O", "A"), "coupler": ("A", "B"), "rocker": ("B", "Q")},
        "bearings": {
            "a": kt.Bearing(member="coupler", node="A", radius=0.02, friction=0.2),
            "q": kt.Bearing(member="rocker", node="Q", radius=0.03, friction=0.15, slip=0.02),
        },
    }
    return _made(given | STEEL, more)


def elbow(**more: Any) -> kt.Model:
    """Crank and link free in space, with an oblique hinge at an offset joint between them."""
    given = {
        "nodes": {"O": kt.Node(at=(0, 0, 0), mass=0.5), "K": (0.5, 0, 0), "T": kt.Node(at=(0.8, 0.4, 0.2), mass=1.0)},
        "bars": {"crank": ("O", "K"), "link": ("K", "T")},
        "gravity": (0, 0, -9.81),
        "hubs": {"K": kt.Hub(arms={"link": (0.03, 0.04, 0)}, hinges={"link": (0.4, 0.3, 1)}, clamped=["crank"])},
        "bearings": {"b": kt.Bearing(member="link", node="K", radius=0.02, friction=0.2)},
    }
    return _made(given | STEEL, more)


def crank_in_space() -> kt.Model:
    """A crank and a rocker on hinges of hubs on the ground; a spring on the crank."""
    turn = kt.AngleDrive("crank", axis="z")
    return kt.Model(
        nodes={"O": (0, 0, 0), "A": (0.25, 0, 0.05), "B": (0.6, 0.5, 0.5), "Q": (0.6, 0.45, 0.1)}, fixed=["O", "Q"],
        bars={"crank": ("O", "A"), "coupler": ("A", "B"), "rocker": ("B", "Q")}, gravity=(0, 0, -9.81), drives={"motor": turn},
        hubs={
            "O": kt.Hub(arms={"crank": (0, 0, 0.05)}, hinges={"crank": "z"}),
            "Q": kt.Hub(arms={"rocker": (0.04, 0, 0)}, hinges={"rocker": "x"}),
        },
        springs={"coil": kt.Spring(coordinate=turn, stiffness=5.0, rest=0.2)},
        bearings={
            "q": kt.Bearing(member="rocker", node="Q", radius=0.02, friction=0.2),
            "o": kt.Bearing(member="crank", node="O", radius=0.02, friction=0.2),
        },
        **STEEL,
    )  # fmt: skip


def jack() -> kt.Model:
    """A pendulum on an active member, whose inertia turns with it."""
    base, tube = (kt.Part(length=0.6, section=kt.Rod(diameter=d), material="steel_s235") for d in (0.05, 0.03))
    return kt.Model(
        nodes={"O": (0, 0), "A": (0.4, 0.0), "B": kt.Node(at=(0.9, 0.5), mass=2.0), "P": (0.0, 0.9)}, fixed=["O", "P"],
        bars={"lower": kt.Bar(ends=("A", "B"), mass=0.7), "upper": kt.Bar(ends=("O", "A"), mass=1.0)}, gravity=(0, -9.81),
        active={"jack": kt.Active(ends=("P", "A"), base=base, tube=tube)},
        bearings={
            "p": kt.Bearing(member="jack", node="P", radius=0.02, friction=0.2),
            "a": kt.Bearing(member="jack", node="A", radius=0.02, friction=0.1, against="upper"),
        },
    )  # fmt: skip


def pinned(**couplings: kt.Coupling) -> kt.Model:
    """A pin at a place of a heavy bar, kept there by couplings."""
    return kt.Model(
        nodes={"O": (0, 0), "A": (1.0, 0.2), "M": (0.4, 0.08), "E": kt.Node(at=(0.9, -0.5), mass=1.0)}, fixed=["O"],
        bars={"a": kt.Bar(ends=("O", "A"), mass=1.0), "e": kt.Bar(ends=("M", "E"), mass=0.5)}, gravity=(0, -9.81),
        couplings=couplings, bearings={"o": kt.Bearing(member="a", node="O", radius=0.02, friction=0.2)},
    )  # fmt: skip


def at(node: str, axis: Any, share: float) -> tuple[kt.CoordinateDrive, float]:
    return kt.CoordinateDrive(node=node, axis=axis), share


def links(upper: tuple[str, str], lower: tuple[str, str], **more: Any) -> dict[str, kt.Bar]:
    return {"upper": kt.Bar(ends=upper, mass=1.0, **more), "lower": kt.Bar(ends=lower, mass=0.7, **more)}


AGAINST = kt.Bearing(member="coupler", node="B", radius=0.02, friction=0.1, against="rocker")
SPRINGS = {
    "root": kt.Spring(coordinate=hinge("O", "G", "A"), stiffness=20, rest=0.3, damping=1.0, friction=0.5, slip=0.05),
    "elbow": kt.Spring(coordinate=hinge("A", "O", "B"), stiffness=8, damping=0.2, play=0.1),
    "sum": kt.Spring(terms=((kt.AngleDrive("upper"), 1.0), (kt.AngleDrive("lower"), -2.0)), stiffness=2.0, preload=0.7),
}
LOADS = {
    "along": kt.MemberLoad(member="upper", force=(3.0, -20)),
    "turning": kt.MemberLoad(member="lower", force=(0, 30), axes="member", shape=(0, 1)),
    "couple": kt.MemberCouple(member="lower", moment=4.0),
    "following": kt.BodyForce(body="upper", at=(0.2, 0.1), force=(5, 8), follows=True),
    "moment": kt.BodyCouple(body="lower", moment=3.0),
}
TABLE = kt.MemberLoad(member="lower", times=(0, 0.02, 0.1), forces=((0, 30), (5, 3), (0, 0)))
CLAMPING = {"B": kt.Hub(arms={"coupler": (0.03, 0.02)}, clamped=["rocker"])}
ON_HUB = {
    "couple": kt.BodyCouple(body="B.hub", moment=20.0),
    "force": kt.BodyForce(body="B.hub", at=(0.95, 0.6), force=(30.0, -50.0), follows=True),
}
SQUARE = kt.Hub(arms={"link": (0.03, 0.04, 0)}, hinges={"link": (-0.0862613, -0.433615, 0.89696)}, clamped=["crank"])
TIP = kt.Hub(arms={"tip": (0.05, 0, 0.01)}, hinges={"tip": (0, 1, 0.2)}, clamped=["link"])
BALL = kt.Model(
    nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "T": kt.Node(at=(0.3, 0.3, 0.8), mass=5)}, fixed=["A", "B", "C"],
    bars={name: kt.Bar(ends=(name, "T"), kind="driven", mass=1.0) for name in "ABC"}, gravity=(0, 0, -9.81),
    bearings={"ball": kt.Bearing(member="A", node="A", radius=0.03, friction=0.2)},
)  # fmt: skip


def turned(**rates: float) -> dict[str, Any]:
    return {"trajectory": kt.ConstantRate(rates=rates, duration=1.0)}


CASES: dict[str, tuple[kt.Model, dict[str, Any]]] = {
    "masses": (pendulum(), {}),
    "the other end": (pendulum(bars=links(("A", "O"), ("B", "A"))), {}),
    "an elastic bar": (
        pendulum(bars={"lower": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=2e4, mass=0.7)}),
        {"velocities": THROWN},
    ),
    "loads": (pendulum(loads=LOADS), {"velocities": THROWN}),
    "a load case": (
        pendulum(loads={"on": LOADS["along"], "table": TABLE}, load_cases={"one": kt.LoadCase(loads={"table": 2.0})}),
        {"velocities": THROWN, "load_case": "one"},
    ),
    "viscous pins": (
        pendulum(bars=links(("O", "A"), ("A", "B"), friction=(0.3, 0.2))),
        {"velocities": THROWN},
    ),
    "springs": (pendulum(springs=SPRINGS), {"velocities": THROWN}),
    "a given torque": (pendulum(drives={"t": kt.AngleDrive("upper")}), {"tasks": {"t": kt.GivenForce(torque=12.0)}}),
    "a given torque of a hinge": (
        pendulum(drives={"t": hinge("A", "O", "B")}),
        {"tasks": {"t": kt.GivenForce(times=(0, 0.1), torques=(2.0, 9.0))}},
    ),
    "a driven angle": (pendulum(drives={"t": kt.AngleDrive("lower")}), turned(t=3.0)),
    "a driven hinge": (pendulum(drives={"t": hinge("A", "O", "B")}), turned(t=3.0)),
    "gears": (pendulum(couplings={"g": kt.Coupling(terms=((kt.AngleDrive("upper"), 1.0), (kt.AngleDrive("lower"), 2.0)))}), {}),
    "gears of hinges": (
        pendulum(couplings={"g": kt.Coupling(terms=((hinge("O", "G", "A"), 1.0), (hinge("A", "O", "B"), 0.5)))}),
        {},
    ),
    "a force of the user": (pendulum(), {"user_force": lambda _t, _x, v: {"B": (3.0, -4 * v[2][1])}}),
    "a body on a bar": (pendulum(bodies={"lump": kt.Body(nodes=("B", "A"), mass=2.0, center=(0.7, 0.5), inertia=0.3)}), {}),
    "a pin on a bar": (
        pinned(**{f"pin_{c}": kt.Coupling(terms=(at("M", c, 1.0), at("O", c, -0.6), at("A", c, -0.4))) for c in "xy"}),
        {},
    ),
    "a slide on a bar": (
        pinned(slide=kt.Coupling(terms=((kt.OffsetCoordinate(point="M", line=("O", "A")), 1.0),))),
        {"velocities": {"E": (1.0, 0.0)}},
    ),
    "an active member": (jack(), {"velocities": {"B": (0.3, -1.0)}, "tasks": {"jack": kt.GivenForce(50.0)}}),
    "a driven active member": (jack(), {"velocities": {"B": (0.3, -1.0)}, **turned(jack=0.2)}),
    "a four-bar": (four_bar(bearings={"b": AGAINST}), {"velocities": {"A": (-1.0, 0.3), "B": (-1.0, 0.0)}}),
    "a hub that clamps": (four_bar(hubs=CLAMPING, loads=ON_HUB), {"velocities": {"A": (-1.0, 0.3), "B": (-1.0, 0.0)}}),
    "a hub that hinges": (elbow(loads={"on": kt.MemberLoad(member="link", force=(3.0, -20, 7))}), {"velocities": SPUN}),
    "hinged and clamped": (
        elbow(
            nodes={"T": kt.Node(at=(0.8, 0.4, 0.2)), "E": kt.Node(at=(1.2, 0.5, 0.1), mass=2)},
            bars={"tip": ("T", "E")},
            hubs={"T": TIP},
            bearings={"e": kt.Bearing(member="tip", node="T", radius=0.03, friction=0.2)},
        ),
        {"velocities": SPUN | {"E": (0, 1, 2)}},
    ),
    "hinged, of changing length": (
        elbow(bars={"link": kt.Bar(ends=("K", "T"), kind="driven", mass=1.0)}, hubs={"K": SQUARE}),
        {"velocities": SPUN, **turned(link=0.3)},
    ),
    "hubs on the ground": (crank_in_space(), {"tasks": {"motor": kt.GivenForce(torque=3.0)}}),
    "driven on the ground": (crank_in_space(), turned(motor=3.0)),
    "a ball joint": (BALL, {**turned(A=0.1, B=-0.2), "tasks": {"C": kt.GivenForce(30.0)}}),
    "Radau": (pendulum(), {"method": kt.Radau()}),
    "midpoint": (pendulum(), {"method": kt.EnergyMomentum(step=1e-3)}),
    "alpha": (pendulum(), {"method": kt.GeneralizedAlpha(step=1e-3)}),
    "RATTLE": (pendulum(), {"method": kt.Rattle(step=1e-3)}),
    "sparse": (pendulum(), {"method": kt.DOP853(solver="sparse")}),
    "sweep": (pendulum(), {"method": kt.DOP853(solver="sweep")}),
}  # fmt: skip
QUICK = ("masses", "a given torque")


@pytest.mark.parametrize("name", [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in CASES])
def test_the_joint_force_of_the_record_presses_the_bearing(name: str) -> None:
    """C = -mu r |R| tanh(w/slip) w/|w| with R and w of the record, and energy is balanced."""
    model, options = CASES[name]
    run = kt.dynamics.simulate(model, 0.03, samples=4, **options)
    forces, motion, system = run.forces.data, run.motion.whole, compile(model)
    x, v = (np.pad(motion[one].values, ((0, 0), (0, 0), (0, 3 - model.dim))) for one in ("position", "velocity"))
    w = relative_rates(system, x, v)
    couple = forces.bearing_couple.values if model.dim == 3 else forces.bearing_couple.values * [0.0, 0.0, 1.0]
    for k, seat in enumerate(seats_of(system)):
        R = np.linalg.norm(run.forces.whole.joint_force.values[:, seat.member, seat.end], axis=1)
        size = np.linalg.norm(w[:, k], axis=1)
        assert size.max() > 0.05  # it turns
        way = w[:, k] / np.where(size > 0, size, 1.0)[:, None]
        exact = -(seat.arm * R * np.tanh(size / seat.slip))[:, None] * way
        assert np.abs(couple[:, k] - exact).max() < 1e-11 * seat.arm * R.max()
    if getattr(options.get("method"), "kind", "") != "energy_momentum":  # it solves for forces in the middle of its steps
        lost = np.abs(forces.dissipation.values).max()
        assert np.abs(forces.energy_balance.values).max() < 1e-11 * lost


def test_a_given_torque_turns_a_rotor_on_a_bearing() -> None:
    """m l^2 w' = T - mu r |R|, R = m l (w^2, w') of a light arm: the torque itself is no force in the joint."""
    mu, radius, arm, mass, torque = 0.2, 0.03, 0.5, 3.0, 2.0
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(arm, 0), mass=mass)}, fixed=["O"], bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        drives={"t": kt.AngleDrive("arm")}, bearings={"pin": kt.Bearing(member="arm", node="O", radius=radius, friction=mu)},
    )  # fmt: skip
    run = kt.dynamics.simulate(
        model,
        0.4,
        samples=5,
        velocities={"A": (0, 3.0)},
        tasks={"t": kt.GivenForce(torque=torque)},
        method=kt.DOP853(rtol=1e-11),
    )
    x, v, a = (run.motion.data[name].sel(node="A").values for name in ("position", "velocity", "acceleration"))
    rate, gain = ((x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]) / arm**2 for y in (v, a))
    R = mass * np.linalg.norm(a, axis=1)  # a massless arm: what the joint exerts is what the mass needs
    assert np.allclose(mass * arm**2 * gain, torque - mu * radius * R, rtol=1e-12)
    # w' = (T - k sqrt((I w^2)^2 + (I w')^2))/I, k = mu r/l, integrated by Gauss and Legendre: t = int dw/w'
    inertia, k = mass * arm**2, mu * radius / arm
    nodes, weights = np.polynomial.legendre.leggauss(40)
    w = rate[0] + (rate[-1] - rate[0]) * (nodes + 1) / 2
    # (1 - k^2) g^2 - 2 T g + T^2 - (k I w^2)^2 = 0, g = I w'
    g = (torque - np.sqrt(torque**2 - (1 - k**2) * (torque**2 - (k * inertia * w**2) ** 2))) / (1 - k**2)
    assert np.sum(weights * inertia / g) * (rate[-1] - rate[0]) / 2 == pytest.approx(0.4, rel=1e-9)


@pytest.mark.slow
def test_a_motor_turns_a_rotor_on_a_bearing() -> None:
    """The joint force has the acceleration that the motor gives: m l^2 w' + mu r |R| is its torque, inverse dynamics agrees."""
    mu, radius, arm, mass = 0.5, 0.03, 0.4, 1.7
    motor = kt.Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06)
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(arm, 0), mass=mass)}, fixed=["O"], bars={"crank": kt.Bar(ends=("O", "A"), mass=0)},
        drives={"turn": kt.AngleDrive("crank", gear=kt.Gear(ratio=12.0, inertia=3e-6), motor=motor)},
        bearings={"pin": kt.Bearing(member="crank", node="O", radius=radius, friction=mu)},
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 0.6, samples=13, tasks={"turn": kt.StepInput(current=1.5)}, method=kt.DOP853(rtol=1e-10))
    x, v, a = (run.motion.data[name].sel(node="A").values for name in ("position", "velocity", "acceleration"))
    rate, gain = ((x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]) / arm**2 for y in (v, a))
    rubbed = mu * radius * mass * np.linalg.norm(a, axis=1) * np.tanh(rate / 1e-3)
    torque = run.forces.data.drive_force.values[:, 0]
    assert rate[-1] > 2 and np.allclose(mass * arm**2 * gain + rubbed, torque, rtol=1e-12)
    assert np.allclose(run.forces.data.bearing_couple.values[:, 0, 0], -rubbed, atol=1e-12)
    back = kt.dynamics.inverse(model, run.motion)
    assert np.allclose(back.data.drive_force.values[1:, 0], torque[1:], rtol=1e-12)
