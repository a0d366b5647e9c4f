"""Histories of no, one or two samples, and times that are none: a right result or a clear error, from every public function."""

import inspect
import math
import warnings

import numpy as np
import pytest

import kinetruss as kt

HISTORIES = {"motion", "forces", "demand", "sections", "state", "result", "verdict"}
"""Parameters that take a result along time."""
NOT_WALKED = {
    "kinematics.transfer_functions", "statics.equilibrium", "strength.table", "strength.beams", "strength.elements",
    "strength.deflections", "dynamics.reduced_equations",
}  # fmt: skip
"""Functions whose parameter of such a name is a single configuration, or a table without time."""
NAN = math.nan


def ring(letter, radius, turn):
    angles = [k * math.pi / 3 + turn * (-1) ** k for k in range(6)]
    return {f"{letter}{k}": (radius * math.cos(a), radius * math.sin(a), 0.0) for k, a in enumerate(angles)}


def hexapod():
    """A platform of one node with a hub on six legs; one leg is an active member with screw, gear and motor."""
    part = kt.Part(length=0.5, section=kt.Tube(outer=0.02, inner=0.016), material="steel_s235")
    motor = kt.Motor(inertia=1e-5, resistance=1.0, torque_constant=0.1, emf_constant=0.1, max_voltage=20.0, inductance=1e-3)
    screw = kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.1)
    leg = kt.Active(ends=("F0", "C"), base=part, tube=part, screw=screw, gear=kt.Gear(ratio=3.0), motor=motor)
    feet = ring("F", 0.5, 0.4)
    return kt.Model(
        nodes={"C": kt.Node(at=(0, 0, 0.8), mass=20.0), **feet}, fixed=list(feet), gravity=(0, 0, -9.81), active={"L0": leg},
        bars={f"L{k}": kt.Bar(ends=(f"F{k}", "C"), kind="driven", mass=0) for k in range(1, 6)},
        hubs={"C": kt.Hub(arms=ring("L", 0.2, -0.4))},
    )  # fmt: skip


MODEL = hexapod()
ROAD = kt.ConstantRate(rates={"L0": 0.01}, duration=1.0)
FEET = ("F0", "F1", "F2")


@pytest.fixture(scope="module")
def whole():
    return kt.dynamics.inverse(MODEL, kt.kinematics.follow(MODEL, ROAD, samples=3))


def cut(forces, count):
    """The first samples of forces, with their motion and static forces."""
    motion = forces.motion.with_(data=forces.motion.data.isel(time=slice(count)))
    static = forces.static.with_(data=forces.static.data.isel(time=slice(count)), motion=motion)
    return forces.with_(data=forces.data.isel(time=slice(count)), motion=motion, static=static)


def demand_of(forces):
    return kt.actuators.evaluate(MODEL, forces.motion, forces)


def sections_of(forces):
    return kt.strength.sections(MODEL, forces)


WALK = {
    "kinematics.conditioning": lambda f: kt.kinematics.conditioning(MODEL, f.motion),
    "kinematics.first_order": lambda f: kt.kinematics.first_order(MODEL, f.motion),
    "kinematics.freedoms": lambda f: kt.kinematics.freedoms(MODEL, f.motion),
    "kinematics.jacobian": lambda f: kt.kinematics.jacobian(MODEL, f.motion, of="C.x"),
    "kinematics.joint": lambda f: kt.kinematics.joint(MODEL, f.motion, FEET),
    "kinematics.member_rates": lambda f: kt.kinematics.member_rates(MODEL, f.motion),
    "kinematics.platform": lambda f: kt.kinematics.platform(MODEL, f.motion, FEET),
    "kinematics.platform_jacobian": lambda f: kt.kinematics.platform_jacobian(MODEL, FEET, f.motion),
    "kinematics.quantities": lambda f: kt.kinematics.quantities(MODEL, f.motion, {"height": "C.z"}),
    "kinematics.pose": lambda f: kt.kinematics.pose(MODEL, f.motion, FEET),
    "dynamics.free_body": lambda f: kt.report.explain(kt.dynamics.free_body(MODEL, f.motion, f, node="C")).text,
    "dynamics.inverse": lambda f: kt.dynamics.inverse(MODEL, f.motion),
    "dynamics.joint_reaction": lambda f: kt.dynamics.joint_reaction(MODEL, f, "C.hub", "C"),
    "dynamics.limits_kept": lambda f: str(kt.dynamics.limits_kept(MODEL, f.motion, f, rate=1.0, acceleration=1.0)),
    "dynamics.linearise": lambda f: kt.dynamics.linearise(MODEL, f.motion, free=["L0"]),
    "dynamics.newton_euler": lambda f: kt.dynamics.newton_euler(MODEL, f.motion, f),
    "dynamics.quickest": lambda f: kt.dynamics.quickest(MODEL, f.motion, rate=1.0),
    "statics.deflection": lambda f: kt.statics.deflection(MODEL, f),
    "statics.platform_stiffness": lambda f: kt.statics.platform_stiffness(MODEL, FEET, 1e6, f.motion),
    "strength.check": lambda f: kt.strength.check(MODEL, f).table(),
    "strength.components": lambda f: kt.strength.components(MODEL, sections_of(f)),
    "strength.gauges": lambda f: kt.strength.gauges(MODEL, f),
    "strength.sections": sections_of,
    "strength.stresses": lambda f: kt.strength.stresses(MODEL, sections_of(f)),
    "strength.utilisation": lambda f: kt.strength.utilisation(MODEL, f),
    "actuators.evaluate": lambda f: demand_of(f).table(),
    "actuators.exceeded": lambda f: kt.actuators.exceeded(demand_of(f)),
    "actuators.moves": lambda f: kt.actuators.moves(demand_of(f)),
    "actuators.power_flow": lambda f: kt.actuators.power_flow(MODEL, f.motion, demand_of(f)),
    "actuators.screw_couples": lambda f: kt.actuators.screw_couples(MODEL, f.motion, demand_of(f)),
    "actuators.summarise": lambda f: kt.actuators.summarise(MODEL, demand_of(f)),
    "flexible.active_damping": lambda f: kt.flexible.active_damping(MODEL, f, [1.0]),
    "flexible.corrected": lambda f: kt.flexible.corrected(MODEL, f, "C.x"),
    "flexible.frequencies": lambda f: kt.flexible.frequencies(MODEL, f),
    "flexible.vibration": lambda f: kt.flexible.vibration(MODEL, f),
    "strength.find": lambda f: kt.strength.find(kt.strength.check(MODEL, f)).sentence,
    "report.beside": lambda f: kt.report.beside((MODEL, f), (MODEL, f)).text,
    "report.histories_svg": lambda f: [kt.report.histories_svg(one) for one in (f, f.motion)],
    "viewer.scene": lambda f: kt.viewer.pack(kt.viewer.scene(f, model=MODEL)),
    "Result.to_dataframe": lambda f: [len(one.to_dataframe()) for one in (f, f.motion, f.static)],
    "Forces.difference": lambda f: f.difference(),
}
"""Every public function of a result along time."""


def tried(function, *args):
    """A result, or None if it was refused in words; warnings of NumPy and inner errors fail the test."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        try:
            return function(*args)
        except kt.KinetrussError as error:
            assert len(str(error)) > 20
            return None


@pytest.mark.slow
@pytest.mark.parametrize("name", WALK)
def test_histories_of_no_one_and_two_samples(name, whole):
    for count in (0, 1, 2):
        tried(WALK[name], cut(whole, count))


def test_no_sample_is_said_and_one_sample_is_enough(whole):
    for name in ("dynamics.inverse", "dynamics.quickest", "kinematics.platform", "strength.sections", "report.beside"):
        with pytest.raises(kt.InputError, match="has no sample"):
            WALK[name](cut(whole, 0))
    (couple,) = kt.actuators.screw_couples(MODEL, cut(whole, 1).motion, demand_of(cut(whole, 1))).values()
    several = kt.actuators.screw_couples(MODEL, whole.motion, demand_of(whole))["L0.torque.B"]
    np.testing.assert_allclose(couple.moment, several.moments[0], rtol=1e-12)


def test_the_walk_has_every_public_function_of_histories():
    found = set()
    for package in ("kinematics", "dynamics", "statics", "strength", "actuators", "flexible"):
        module = getattr(kt, package)
        for name in module.__all__:
            function = getattr(module, name)
            if inspect.isfunction(function) and HISTORIES & set(inspect.signature(function).parameters):
                found.add(f"{package}.{name}")
    assert found - NOT_WALKED <= set(WALK)


TIMES = {
    "none": [], "unsorted": [0.0, 1.0, 0.5], "twice": [0.0, 0.5, 0.5, 1.0], "not a number": [0.0, NAN, 1.0],
    "infinite": [0.0, math.inf], "two axes": [[0.0, 1.0]], "text": "ab", "gap": [None, 1.0],
}  # fmt: skip
STILL = np.broadcast_to([(0.0, 0.0), (1.0, 0.0)], (4, 2, 2))
CRANK = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")},
                 trajectories={"road": kt.ConstantRate(rates={"turn": 1.0}, duration=1.0)},
                 runs={"go": kt.Run(trajectory="road", samples=3)})  # fmt: skip
OF_TIMES = {
    "follow": lambda t: kt.kinematics.follow(CRANK, "road", times=t),
    "inverse": lambda t: kt.kinematics.inverse(CRANK, CRANK.trajectories["road"], times=t),
    "inverse_along": lambda t: kt.dynamics.inverse_along(CRANK, CRANK.trajectories["road"], times=t),
    "simulate": lambda t: kt.dynamics.simulate(CRANK, 1.0, times=t),
    "forces_at": lambda t: kt.runs.forces_at(CRANK, "go", t),
    "from_arrays": lambda t: kt.kinematics.from_arrays(CRANK, t, STILL, 0 * STILL, 0 * STILL),
    "measured": lambda t: kt.kinematics.measured(kt.Measured(times=t, values={"turn": [0.0] * np.size(t)})),
    "load": lambda t: kt.NodalForce(node="B", times=t, forces=[(0.0, 1.0)] * np.size(t)),
}  # fmt: skip


@pytest.mark.parametrize("function", OF_TIMES)
def test_times_that_are_none_are_refused(function):
    for name, times in TIMES.items():
        assert tried(OF_TIMES[function], times) is None, name


@pytest.mark.slow
def test_one_instant_of_a_task_is_enough():
    """Also where the second rate of the drive is zero, at any pace."""
    model = kt.read(kt.library.example_files()["four_bar"][0])
    for duration in (0.01, 1.0, 100.0):
        task = kt.ConstantRate(rates={"motor": 1.0 / duration}, duration=duration)
        for share in (0.3, 0.33, 0.5):
            motion = kt.kinematics.inverse(model, task, times=[share * duration])
            assert motion.drive_position.values.item() == pytest.approx(math.pi / 2 + share, abs=1e-12)
            assert abs(motion.drive_acceleration.values.item()) * duration**2 < 1e-9


def test_a_bar_without_length_in_a_given_motion_is_refused():
    with pytest.raises(kt.InputError, match="'b' has no length at t = 0 s"):
        kt.kinematics.from_arrays(CRANK, [0.0], *[np.zeros((1, 2, 2))] * 3)
