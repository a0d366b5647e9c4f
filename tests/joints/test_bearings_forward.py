"""Friction of bearings in simulations and in hinges in space: closed forms, energy, momenta, forward against inverse."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import simpson

import kinetruss as kt

STEEL: dict[str, Any] = {"section": kt.Rod(diameter=0.03), "material": "steel_s235"}


def slowing(mu: float, radius: float, arm: float, rate: float, t: Any) -> Any:
    """|R| = m l sqrt(w^4 + w'^2) and m l^2 w' = -mu r |R|: w' = -c w^2, c = k/sqrt(1 - k^2), k = mu r/l."""
    k = mu * radius / arm
    return 1 / (1 / rate + k / np.sqrt(1 - k * k) * np.asarray(t))


def rotor(space: bool) -> kt.Model:
    """A mass on a light arm about a bearing: a pin of the plane, or a hinge of a hub in space."""
    bearing = {"pin": kt.Bearing(member="arm", node="O", radius="30 mm", friction=0.2)}
    if not space:
        return kt.Model(
            nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=3)}, fixed=["O"], bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
            bearings=bearing,
        )  # fmt: skip
    return kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(0.5, 0, 0.1), mass=3)}, fixed=["O"],
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        hubs={"O": kt.Hub(arms={"arm": (0, 0, 0.1)}, hinges={"arm": "z"})}, bearings=bearing,
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("space", [False, True])
def test_a_rotor_slows_down(space: bool) -> None:
    """Its rate is that of the closed form, its energy falls by the work of friction, inverse dynamics agrees."""
    model = rotor(space)
    run = kt.dynamics.simulate(model, 1.0, samples=101, velocities={"A": (0, 3.0, 0)[: model.dim]})
    x, v = (run.motion.data[name].sel(node="A").values for name in ("position", "velocity"))
    rate = (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]) / 0.25
    t = run.data.time.values
    assert np.allclose(rate, slowing(0.2, 0.03, 0.5, 6.0, t), rtol=1e-8)
    lost = run.data.energy.values[0] - run.data.energy.values[-1]
    assert simpson(run.forces.data.dissipation.values, x=t) == pytest.approx(lost, rel=1e-7)
    assert np.abs(run.forces.data.energy_balance).max() < 1e-9
    back = kt.dynamics.inverse(model, run.motion)
    for name in ("bearing_couple", "member_force", "reaction", "dissipation"):
        assert np.allclose(back.data[name], run.forces.data[name], atol=1e-9)


@pytest.mark.slow
def test_two_pins_that_load_each_other() -> None:
    """A double pendulum with friction in both pins: energy and inverse dynamics, while both turn."""
    model = kt.Model(
        nodes={"O": (0, 0), "A": (0.4, 0), "B": kt.Node(at=(0.9, 0.2), mass=1.5)}, fixed=["O"], gravity=(0, -9.81),
        bars={"upper": kt.Bar(ends=("O", "A"), mass=1.0), "lower": kt.Bar(ends=("A", "B"), mass=0.7)},
        bearings={
            "top": kt.Bearing(member="upper", node="O", radius=0.02, friction=0.15, slip=1e-4),
            "elbow": kt.Bearing(member="lower", node="A", radius=0.015, friction=0.1, slip=1e-4),
        },
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 0.3, samples=121, velocities={"A": (0, -0.5), "B": (0.1, -2.0)})
    t = run.data.time.values
    assert simpson(run.forces.data.dissipation.values, x=t) == pytest.approx(
        float(np.ptp(run.data.energy.values)), rel=3e-5
    )  # one pin turns back
    back = kt.dynamics.inverse(model, run.motion)
    assert np.allclose(back.data.bearing_couple, run.forces.data.bearing_couple, atol=1e-10)
    assert np.allclose(back.data.joint_force, run.forces.data.joint_force, atol=1e-8)
    with_user = kt.dynamics.simulate(model, 0.05, samples=2, user_force=lambda _t, x, v: {"B": (0.0, 1.5 * 9.81)})
    lighter = model.with_(loads={"up": kt.NodalForce(node="B", force=(0, 1.5 * 9.81))})
    same = kt.dynamics.simulate(lighter, 0.05, samples=2)
    assert np.allclose(with_user.motion.position, same.motion.position, atol=1e-10)


@pytest.mark.slow
def test_it_creeps_below_its_slip_rate() -> None:
    """A load below the friction moves the pin slowly: I w' = M - mu r |R| tanh(w/slip)."""
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0, -0.5), mass=3)}, fixed=["O"], bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        gravity=(0, -9.81), loads={"side": kt.NodalForce(node="A", force=(0.2, 0))},
        bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.03, friction=0.2, slip=0.01)},
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 1.0, samples=3, method=kt.Radau())
    x, v, a = (run.motion.data[name].sel(node="A").values[-1] for name in ("position", "velocity", "acceleration"))
    rate, gain = ((x[0] * y[1] - x[1] * y[0]) / 0.25 for y in (v, a))
    R = float(np.hypot(*(3 * a - (0.2, -3 * 9.81))))
    assert 0 < rate < 0.004 and float(np.hypot(*x)) == pytest.approx(0.5, rel=1e-12)
    moment = -x[1] * 0.2 - x[0] * 3 * 9.81
    assert 0.75 * gain == pytest.approx(moment - 0.2 * 0.03 * R * np.tanh(rate / 0.01), rel=1e-8)
    assert abs(0.75 * gain) < 0.06 * moment


def elbow(**changes: Any) -> kt.Model:
    """Crank and link with an oblique hinge at an offset joint between them, and friction in it."""
    given: dict[str, Any] = {
        "nodes": {"O": kt.Node(at=(0, 0, 0), mass=0.5), "K": (0.5, 0, 0), "T": kt.Node(at=(0.8, 0.4, 0.2), mass=1.0)},
        "bars": {"crank": ("O", "K"), "link": ("K", "T")},
        "hubs": {"K": kt.Hub(arms={"link": (0.03, 0.04, 0)}, hinges={"link": (0.4, 0.3, 1)}, clamped=["crank"])},
        "bearings": {"b": kt.Bearing(member="link", node="K", radius=0.02, friction=0.2)},
    }
    return kt.Model(**given | STEEL | changes)


@pytest.mark.slow
def test_friction_between_moving_parts_keeps_momenta() -> None:
    """Free in space: both momenta stay, the energy falls by the dissipation, every part is in balance."""
    model = elbow()
    start = {"T": (0.3, 1.0, -0.5), "O": (0, -0.4, 0.3)}
    run = kt.dynamics.simulate(model, 0.1, samples=41, velocities=start)
    for name in ("momentum", "angular_momentum"):
        values = run.data[name].values
        assert np.abs(values - values[0]).max() < 1e-9 * np.abs(values).max()
    lost = run.data.energy.values[0] - run.data.energy.values[-1]
    assert lost > 0.005
    assert simpson(run.forces.data.dissipation.values, x=run.data.time.values) == pytest.approx(lost, rel=1e-5)
    size = float(np.abs(run.forces.data.joint_force).max())
    for member in ("crank", "link", "K.link"):
        assert kt.dynamics.free_body(model, run.motion, run.forces, member=member, time=0.05).residual < 1e-9 * size
    for node in model.whole.nodes:
        assert kt.dynamics.free_body(model, run.motion, run.forces, node=node, time=0.05).residual < 1e-9 * size
    back = kt.dynamics.inverse(model, run.motion)
    assert np.allclose(back.data.bearing_couple, run.forces.data.bearing_couple, atol=1e-9)


def test_a_door_is_turned_against_its_hinge() -> None:
    """A steady turn about a vertical axis: |R| of weight and m w^2 l, so the drive has mu r |R|, all about the axis."""
    hub = kt.Hub(arms={"door": (0, 0, 0.05)}, hinges={"door": "z"})
    model = kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(0.8, 0, 0.05), mass=4.0)}, fixed=["O"], hubs={"O": hub}, gravity=(0, 0, -9.81),
        bars={"door": kt.Bar(ends=("O", "A"), mass=0)}, drives={"turn": kt.AngleDrive("door", axis="z")},
        bearings={"pin": kt.Bearing(member="door", node="O", radius=0.02, friction=0.25)},
    )  # fmt: skip
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 3.0}, duration=0.5), samples=3)
    found = kt.dynamics.inverse(model, motion)
    exact = 0.25 * 0.02 * 4.0 * np.hypot(9.81, 9.0 * 0.8)
    assert np.allclose(found.data.bearing_couple.values[:, 0], (0, 0, -exact), atol=1e-10)
    assert np.allclose(found.data.drive_force.values[:, 0], exact, rtol=1e-10)
    assert np.allclose(found.data.dissipation, 3.0 * exact, rtol=1e-10)


def test_what_a_simulation_refuses() -> None:
    """Power series; joints that jam at the start or on the way."""
    model = rotor(space=False)
    with pytest.raises(kt.InputError, match="bearings have friction"):
        kt.dynamics.simulate(model, 1.0, velocities={"A": (0, 3.0)}, method=kt.Taylor())
    tight = model.with_(bearings={"pin": model.bearings["pin"].with_(radius=2.0, friction=0.5)})
    with pytest.raises(kt.AnalysisError, match="'pin' does not settle: the joint jams"):
        kt.dynamics.simulate(tight, 1.0, velocities={"A": (0, 3.0)})
