"""What motors keep whatever they drive, members through screws or angles: inverse dynamics and the demand of a motion give back
what they were fed with, no energy is lost, and a run in pieces is the unbroken one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kinetruss as kt
from kinetruss import actuators, dynamics
from kinetruss.dynamics.simulation import stepper_for
from kinetruss.dynamics.simulation_setup import Options, problem_of
from kinetruss.library import drives, mechanisms, vgt
from kinetruss.mechanics import compile

pytestmark = pytest.mark.slow

G = 9.81
GEAR = kt.Gear(ratio=12.0, efficiency=0.85, inertia=3e-6)
MOTOR = kt.Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06, friction_torque=0.004)


def bays(count=1, **more):
    train = {"screw": drives.SCREW_LACY_SPATIAL, "gear": drives.GEAR_LACY, "motor": drives.MOTOR_LACY}
    return vgt.double_octahedral(bays=count, **train, **more)


def loaded():
    return bays(tip_force=(0.0, 0.0, -46.0))


def robot():
    """Three of the five axes have motors."""
    plain = mechanisms.robot(gravity=(0.0, 0.0, -G))
    motor = MOTOR.with_(inertia=1e-4, torque_constant=0.1, emf_constant=0.1, resistance=0.5)
    train = {"gear": kt.Gear(ratio=80.0, efficiency=0.8, inertia=1e-5), "motor": motor}
    return plain.with_(drives={n: d.with_(**train) if n in TURNS else d for n, d in plain.drives.items()})


TURNS = {"swing": 0.6, "shoulder": -0.3, "wrist": -1.0}


def turning():
    start = dict(zip(robot().all_drives, compile(robot()).drive_start, strict=True))
    loops = {name: kt.PositionLoop(target=start[name] + way, settling_time=0.15) for name, way in TURNS.items()}
    return loops | {"lift": kt.Hold()}


def links():
    bars = {"a": kt.Bar(ends=("A", "B"), mass=0), "b": kt.Bar(ends=("B", "C"), mass=0)}
    shoulder = kt.AngleDrive("a", gear=GEAR.with_(ratio=100.0), motor=MOTOR)
    elbow = kt.HingeDrive(axis="B", start="A", end="C", gear=GEAR.with_(ratio=60.0), motor=MOTOR)
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(1.0, 0), mass=2.0), "C": kt.Node(at=(1.7, 0), mass=1.5)}, fixed=["A"],
        gravity=(0, -G), bars=bars, drives={"shoulder": shoulder, "elbow": elbow},
    )  # fmt: skip


def loop():
    """Bennett's four-bar: three rows depend on others where the loop is closed, and no bar holds the driven hinge."""
    turn = kt.HingeDrive(axis=("P1", "A1"), start="P4", end="P2", gear=GEAR, motor=MOTOR)
    return mechanisms.bennett().with_(gravity=(0, 0, -G), drives={"turn": turn})


def sprung():
    """The line of the driven angle is a spring: its row lacks 2 w l'/l, which inverse dynamics has from elsewhere."""
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=1.7)}, fixed=["O"], gravity=(0, -G),
        bars={"crank": kt.Bar(ends=("O", "A"), kind="elastic", stiffness=300.0, mass=0)},
        drives={"turn": kt.AngleDrive("crank", gear=GEAR, motor=MOTOR)},
    )  # fmt: skip


@dataclass(frozen=True)
class Case:
    """A model, its tasks, and how near its inputs come back where the drives move faster than `still`, at `moving` samples of
    its motors at least; `forces` : how near the forces of members do.
    """

    model: Callable[[], kt.Model]
    tasks: Callable[[], dict[str, object]]
    duration: float
    samples: int
    within: float = 1e-8
    still: float = 1e-8
    method: kt.DOP853 = field(default_factory=kt.DOP853)
    moving: int = 9
    forces: float = 1e-8


POSE = {"M7": 1.160, "M9": 1.175, "M11": 1.172}
STEP = {"turn": kt.StepInput(voltage=24.0)}
EXACT = kt.DOP853(rtol=1e-11, atol=1e-12)
CASES = {
    "screws of a bay": Case(
        loaded, lambda: {name: kt.PositionLoop(target=target, settling_time=0.4) for name, target in POSE.items()}, 1.0, 101,
        forces=1e-9,
    ),
    "a screw beside held and moving drives": Case(
        loaded, lambda: {"M7": kt.StepInput(voltage=8.0), "M9": kt.Quintic(moves={"M9": (1.1684, 1.17)}, duration=0.3),
                         "M11": kt.Hold()}, 0.3, 31,
    ),
    **{f"nine screws of three bays, {solver}": Case(
        lambda: bays(3), lambda: {name: kt.StepInput(voltage=8.0 * (-1) ** k, end=0.02)
                                  for k, name in enumerate(bays(3).all_drives)},
        0.04, 11, still=1e-7, method=kt.DOP853(solver=solver),
    ) for solver in ("dense", "sweep", "sparse")},
    "angles of a robot": Case(robot, turning, 0.8, 41, 1e-7, 1e-6, moving=51),
    **{f"two geared links, {solver}": Case(
        links, lambda: {"shoulder": kt.StepInput(voltage=20.0), "elbow": kt.SineInput(voltage=15.0, period=0.4)}, 0.5, 26,
        1e-7, 1e-6, kt.DOP853(solver=solver), moving=41,
    ) for solver in ("dense", "sparse")},
    "an angle of an overconstrained loop": Case(loop, lambda: STEP, 1.0, 26, moving=25),
    "an angle of a line whose length changes": Case(sprung, lambda: STEP, 0.6, 31, method=EXACT),
}  # fmt: skip


@cache
def moved(name):
    """The model, its motion by motors, the drives that have one, and inverse dynamics of that motion."""
    case = CASES[name]
    model = case.model()
    run = dynamics.simulate(model, case.duration, samples=case.samples, tasks=case.tasks(), method=case.method)
    return model, run, list(run.data.motor.values), dynamics.inverse(model, run.motion, static=False)


@pytest.mark.parametrize("name", CASES)
def test_inverse_dynamics_and_the_demand_give_the_inputs_back(name):
    model, run, motors, forces = moved(name)
    case = CASES[name]
    for force, within in (("member_force", case.forces), ("drive_force", 1e-8)):
        scale = np.abs(forces.data[force]).max()
        assert_allclose(run.forces.data[force], forces.data[force], rtol=0, atol=within * scale)
    demand = actuators.evaluate(model, run.motion, forces).data.sel(active=motors)
    moving = np.abs(run.motion.drive_velocity.sel(drive=motors).values) > case.still
    assert moving.sum() >= case.moving
    if name.startswith("nine"):
        assert moving[5].all()
    for what in ("current", "voltage"):
        given = run.data[f"motor_{what}"].values
        assert_allclose(demand[what].values[moving], given[moving], rtol=0, atol=case.within * np.abs(given).max())


@pytest.mark.parametrize("name", CASES)
def test_energy_goes_where_it_is_told(name):
    model, run, motors, forces = moved(name)
    assert np.abs(run.data.motor_energy_balance).max() < 1e-8 * run.data.electrical_energy.max()
    assert np.abs(forces.energy_balance).max() < 1e-8 * np.abs(forces.power).max()
    if len(motors) < len(model.all_drives) and name.startswith("a screw"):
        return  # another drive works, too
    work = run.data.actuator_work.sum("motor").values
    for load in model.loads.values():
        at = run.motion.position.sel(node=load.node).values
        work = work + (at - at[0]) @ np.array(load.force)
    energy = run.data.energy.values
    assert_allclose(energy - energy[0], work, rtol=0, atol=1e-8 * np.ptp(energy))


def test_loops_bring_a_bay_to_a_pose():
    _, run, *_ = moved("screws of a bay")
    lengths = run.motion.length.sel(member=list(POSE)).values
    wanted = np.array(list(POSE.values()))
    # Coulomb friction leaves an error: there is no integral part
    assert np.abs(lengths[-1] - wanted).max() < 0.1 * np.abs(wanted - lengths[0]).max()
    assert not run.data.motor_direction.values[-1].any()
    assert run.status is kt.Status.COMPLETED


def test_loops_bring_a_robot_to_its_angles():
    model, run, motors, _ = moved("angles of a robot")
    assert motors == list(TURNS)
    start = dict(zip(model.all_drives, compile(model).drive_start, strict=True))
    for name, way in TURNS.items():
        found = run.motion.drive_position.sel(drive=name).values
        assert found[0] == pytest.approx(start[name], abs=1e-12)
        assert abs(found[-1] - start[name] - way) < 0.1 * abs(way)
    assert_allclose(run.motion.drive_position.sel(drive="reach"), start["reach"], atol=1e-12)


def test_drives_without_a_motor_go_as_they_are_told():
    _, run, motors, _ = moved("a screw beside held and moving drives")
    assert motors == ["M7"]
    assert_allclose(run.motion.length.sel(member="M11"), 1.1684, atol=1e-13)
    assert_allclose(run.motion.length.sel(member="M9").values[-1], 1.17, atol=1e-12)


def test_a_loop_turns_round_and_a_spring_is_stretched():
    assert np.ptp(moved("an angle of an overconstrained loop")[1].motion.drive_position.values) > 2 * np.pi
    assert np.ptp(moved("an angle of a line whose length changes")[1].motion.length.values) > 0.05


def hinge():
    """A mass on a crank about a slanted axis in space."""
    e = np.array([1.0, 2.0, 2.0]) / 3
    r = 0.4 * np.cross(e, [0.0, 0.0, 1.0]) / np.linalg.norm(np.cross(e, [0.0, 0.0, 1.0]))
    return kt.Model(
        nodes={"O": (0, 0, 0), "E": tuple(e), "F": tuple(2 * r), "A": kt.Node(at=tuple(r), mass=1.7)}, fixed=["O", "E", "F"],
        bars={"near": kt.Bar(ends=("O", "A"), mass=0), "far": kt.Bar(ends=("E", "A"), mass=0)},
        drives={"turn": kt.HingeDrive(axis=("O", "E"), start="F", end="A", gear=GEAR, motor=MOTOR)},
    )  # fmt: skip


RESUMED = {
    "screws": (loaded, 0.15, 17, {"M7": kt.PositionLoop(target=1.16, settling_time=0.3),
                                  "M9": kt.SineInput(voltage=12.0, period=0.1)}),
    "an angle": (hinge, 0.4, 23, {"turn": kt.PositionLoop(times=(0.0, 0.2), targets=(0.0, 9.0), settling_time=0.1)}),
}  # fmt: skip


@pytest.mark.parametrize("name", RESUMED)
def test_a_resumed_run_is_the_unbroken_one_bit_for_bit(name):
    make, end, cut, tasks = RESUMED[name]
    times, model = np.linspace(0.0, end, 41), make()

    def fresh():
        return stepper_for(problem_of(model, end, Options(tasks=tasks)), end)

    whole, first, second = fresh().advance(times), fresh(), fresh()
    head = first.advance(times[:cut])
    second.restore({column: np.array(values) for column, values in first.arrays().items()})
    tail = second.advance(times[cut:])
    for column in ("x", "v", "a", "N", "extra", "diagnostics"):
        joined = np.concatenate([getattr(head, column), getattr(tail, column)])
        assert np.array_equal(joined, getattr(whole, column), equal_nan=True), column
    assert name != "an angle" or whole.extra[-1, 4] / 12 > 2 * np.pi
