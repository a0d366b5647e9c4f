"""Friction from the reaction of a joint: friction circles, equilibrium, energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt

MU, R = 0.2, 0.03


def pendulum(**bearing: Any) -> kt.Model:
    """A heavy bob on a driven arm."""
    given = {"member": "arm", "node": "O", "radius": R, "friction": MU} | bearing
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=3.0)},
        fixed=["O"],
        bars={"arm": kt.Bar(ends=("O", "A"), mass=1.5, section=kt.Rod(diameter=0.02))},
        gravity=(0, -9.81),
        drives={"turn": kt.AngleDrive("arm")},
        bearings={"pin": kt.Bearing(**given)},
    )


def turned(model: kt.Model, *, rate: float = 2.0) -> tuple[Any, Any]:
    """The arm at a constant rate, and the forces."""
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": rate}, duration=0.5), samples=9)
    return motion, kt.dynamics.inverse(model, motion)


@pytest.mark.parametrize("rate", [2.0, -3.0])
def test_the_drive_overcomes_mu_r_times_the_reaction(rate: float) -> None:
    """R = m (g + w^2 l): the drive's torque changes by mu r |R| against the motion, to round-off."""
    model = pendulum()
    motion, forces = turned(model, rate=rate)
    _, smooth = turned(model.with_(bearings={}), rate=rate)
    phi = rate * motion.data.time.values
    out = np.stack([np.cos(phi), np.sin(phi)], axis=1)
    reaction = -(3.0 * 0.5 + 1.5 * 0.25) * rate**2 * out + np.array([0, 4.5 * 9.81])
    extra = np.sign(rate) * MU * R * np.linalg.norm(reaction, axis=1)
    assert np.allclose(forces.data.drive_force[:, 0] - smooth.data.drive_force[:, 0], extra, rtol=1e-10)
    assert np.abs(forces.data.energy_balance).max() < 1e-11 * np.abs(forces.data.power).max()
    assert np.allclose(forces.data.dissipation, np.abs(extra * rate), rtol=1e-10)
    assert not forces.static.data.bearing_couple.any() if "bearing_couple" in forces.static.data else True


def linkage(slow: float = 1e-3) -> tuple[kt.Model, Any, Any]:
    """A four-bar linkage with a massless coupler that rubs at both ends, turned slowly against a load."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D": (0.9, 0)},
        fixed=["A", "D"],
        bars={
            name: kt.Bar(ends=ends, mass=0.0)
            for name, ends in (("crank", ("A", "B")), ("coupler", ("B", "C")), ("rocker", ("C", "D")))
        },
        drives={"motor": kt.AngleDrive("crank")},
        loads={"p": kt.NodalForce(node="C", force=(40, -25))},
        bearings={
            "b": kt.Bearing(member="coupler", node="B", radius=0.02, friction=0.15),
            "c": kt.Bearing(member="coupler", node="C", radius=0.03, friction=0.2, against="rocker"),
            "d": kt.Bearing(member="rocker", node="D", radius=0.02, friction=0.1),
        },
    )
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": slow}, duration=1 / slow), samples=9)
    return model, motion, kt.dynamics.inverse(model, motion)


def test_friction_circles() -> None:
    """The force in a massless rod is tangent to the friction circles at both ends: sin of its angle is (+-r1 +-r2)/L."""
    _, motion, forces = linkage()
    joint = forces.data.joint_force.sel(member="coupler").values
    x = motion.data.position.values
    d = x[:, 2] - x[:, 1]
    sine = (d[:, 0] * joint[:, 1, 1] - d[:, 1] * joint[:, 1, 0]) / (
        np.linalg.norm(d, axis=1) * np.linalg.norm(joint[:, 1], axis=1)
    )

    def rate(i: int, j: int) -> Any:
        v = motion.data.velocity.values
        e, w = x[:, j] - x[:, i], v[:, j] - v[:, i]
        return (e[:, 0] * w[:, 1] - e[:, 1] * w[:, 0]) / np.sum(e**2, axis=1)

    crank, coupler, rocker = rate(0, 1), rate(1, 2), rate(2, 3)
    exact = (0.003 * np.sign(coupler - crank) + 0.006 * np.sign(coupler - rocker)) / np.linalg.norm(d, axis=1)
    assert np.allclose(sine, exact, rtol=1e-9)
    assert np.allclose(joint.sum(axis=1), 0, atol=1e-10)


@pytest.mark.slow
def test_every_part_is_in_equilibrium_and_energy_is_kept() -> None:
    """Free bodies of bars and nodes; the drive's work is that of load and friction."""
    model, motion, forces = linkage()
    largest = float(np.abs(forces.data.joint_force).max())
    for time in motion.data.time.values[[0, 4, 8]]:
        for cut in [{"member": name} for name in model.whole.bars] + [{"node": name} for name in model.whole.nodes]:
            assert kt.dynamics.free_body(model, motion, forces, time=time, **cut).residual < 1e-11 * largest
        assert kt.dynamics.newton_euler(model, motion, forces, time=time).residual < 1e-11 * largest
    assert np.abs(forces.data.energy_balance).max() < 1e-10 * np.abs(forces.data.power).max()
    assert (forces.data.dissipation > 0).all()


def test_a_ball_joint_on_the_ground() -> None:
    """In space: a leg that swings on a ball joint loses mu r |R| times its turning rate."""
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "T": kt.Node(at=(0.3, 0.3, 0.8), mass=5)},
        fixed=["A", "B", "C"],
        bars={name: kt.Bar(ends=(name, "T"), kind="driven", mass=1.0) for name in "ABC"},
        gravity=(0, 0, -9.81),
        bearings={"ball": kt.Bearing(member="A", node="A", radius=R, friction=MU)},
    )
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"A": 0.1, "B": -0.2, "C": 0.05}, duration=0.5), samples=5)
    forces = kt.dynamics.inverse(model, motion)
    d, v = motion.data.position.sel(node="T").values, motion.data.velocity.sel(node="T").values
    rate = np.linalg.norm(np.cross(d, v), axis=1) / np.sum(d**2, axis=1)
    force = np.linalg.norm(forces.data.joint_force.sel(member="A", end="A"), axis=1)
    assert np.allclose(forces.data.dissipation, MU * R * force * rate, rtol=1e-10)
    assert np.abs(forces.data.energy_balance).max() < 1e-10 * np.abs(forces.data.power).max()


def test_at_the_arm_of_a_hub() -> None:
    """The bearing of a member at a hub is at the tip of its arm, and rubs on it."""
    model, *_ = linkage()
    given = {field: getattr(model, field) for field in ("nodes", "fixed", "bars", "drives", "loads", "bearings")}
    real = kt.Model(**given, hubs={"B": kt.Hub(arms={"coupler": (0.02, 0.03)}, clamped=["crank"])})
    motion = kt.kinematics.follow(real, kt.ConstantRate(rates={"motor": 1e-3}, duration=500), samples=3)
    forces = kt.dynamics.inverse(real, motion)
    assert forces.data.bearing_couple.sel(bearing="b").values.all()
    residuals = [
        kt.dynamics.free_body(real, motion, forces, time=250.0, member=name).residual for name in ("coupler", "B.coupler")
    ]
    assert max(residuals) < 1e-11 * float(np.abs(forces.data.joint_force).max())


@pytest.mark.slow
def test_many_motions_have_the_same_friction() -> None:
    """`kt.prepare` gives what the plain calls give."""
    model, motion, forces = linkage()
    ready = kt.prepare(model)
    places = ready.follow(kt.ConstantRate(rates={"motor": 1e-3}, duration=1000.0), samples=9)
    assert np.array_equal(ready.forces(places).joint_force[..., :2], forces.data.joint_force)
    assert len(motion.data.time) == 9


def test_what_is_refused() -> None:
    """Linearisations; joints that jam; bearings in the air."""
    model = pendulum()
    with pytest.raises(kt.InputError, match="does not include the friction of bearings \\(pin\\)"):
        kt.dynamics.linearise(model)
    jammed, _, _ = linkage()
    tight = jammed.bearings["c"].with_(radius=2.0, friction=1.0)
    with pytest.raises(kt.AnalysisError, match="jams"):
        moving = kt.kinematics.follow(jammed, kt.ConstantRate(rates={"motor": 1e-3}, duration=500), samples=3)
        kt.dynamics.inverse(jammed.with_(bearings={"b": tight.with_(node="B", against="crank"), "c": tight}), moving)
    for wrong, said in (
        ({"member": "leg"}, "no member called 'leg'"),
        ({"node": "X"}, "no node called 'X'"),
        ({"node": "A"}, "no other member ends"),
        ({"against": "arm"}, "does not end at 'O'"),
    ):
        with pytest.raises(kt.ModelError, match=said):
            pendulum(**wrong)
