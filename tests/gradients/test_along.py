"""Gradients along given motions: closed forms, complex steps of a four-bar's own equations, differences, refusals."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError
from kinetruss.gradients.differences import Weighed, differences
from kinetruss.gradients.stacked import Unknowns, Weights, by_states

RUN = {"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": 3.0}, duration=1.0), samples=41)}


def crank(**more):
    """A mass of 2 kg at the end of a massless rod of 0.5 m, turned from the horizontal."""
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=2.0)}, fixed=["O"],
        bars={"crank": kt.Bar(ends=("O", "A"), mass=0.0, section=kt.Rod(diameter=0.01), material="steel_s235")},
        drives={"motor": kt.AngleDrive("crank")}, runs=RUN, **more,
    )  # fmt: skip


def test_a_crank_by_mass_length_speed_section_and_safety():
    # at the start N = m r w^2, and the couple of the motor bends the rod at its axle by m g r
    model = crank(safety=kt.Safety(yielding=1.5), gravity=(0, -9.81)).with_(
        runs={"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": 3.0}, duration=1.0), samples=3)}
    )
    wrt = [
        "nodes.A.mass", "nodes.A.at.0", "runs.turn.trajectory.rates.motor", "bars.crank.section.diameter", "safety.yielding",
    ]  # fmt: skip
    value, by = kt.value_and_gradient(kt.Response("first(utilisation[crank, yield])", kt.run, model), wrt)
    area, modulus, allowed = math.pi * 0.005**2, math.pi * 0.01**3 / 32, 235e6 / 1.5
    pull, bend = 2.0 * 0.5 * 9.0 / area / allowed, 2.0 * 9.81 * 0.5 / modulus / allowed
    assert value == pytest.approx(pull + bend, rel=1e-12)
    expected = [value / 2, value / 0.5, 2 * pull / 3, -(2 * pull + 3 * bend) / 0.01, value / 1.5]
    assert by.values == pytest.approx(expected, rel=1e-9)


def test_the_torque_of_a_pendulum_at_an_instant():
    # T = m l (l theta'' + g cos theta), theta from 0.2 to 1.4 in 2 s; the start turns with the place
    model = crank(gravity=(0, -9.81))
    move = kt.Quintic(moves={"motor": (0.2, 1.4)}, duration=2.0)
    torque = kt.Response("at(drive_force[motor], 0.5*s)", kt.dynamics.inverse, model, trajectory=move, samples=5)
    value, by = kt.value_and_gradient(torque, ["nodes.A.mass", "nodes.A.at.0"])
    s = 0.25
    theta = 0.2 + 1.2 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    second = 1.2 * (60 * s - 180 * s**2 + 120 * s**3) / 4.0
    assert value == pytest.approx(2 * 0.5 * (0.5 * second + 9.81 * math.cos(theta)), rel=1e-12)
    assert by.values == pytest.approx([value / 2.0, 2 * (second + 9.81 * math.cos(theta))], rel=1e-9)


def test_accelerations_go_with_the_square_of_the_duration():
    model = crank().with_(runs={"turn": kt.Run(trajectory=kt.Quintic(moves={"motor": (0.0, 1.0)}, duration=2.0), samples=41)})
    top = kt.Response("max(abs(drive_acceleration))", kt.run, model)
    value, by = kt.value_and_gradient(top, ["runs.turn.trajectory.duration"])
    assert by.item() == pytest.approx(-2 * value / 2.0, rel=1e-9)  # of both ends of the symmetric move, which are tied
    top = kt.Response("max(drive_acceleration)", kt.run, model)
    value, by = kt.value_and_gradient(top, ["runs.turn.trajectory.duration", "runs.turn.trajectory.moves.motor.1"])
    assert by.values == pytest.approx([-2 * value / 2.0, value], rel=1e-9)


def test_quantities_that_the_model_defines():
    # lever = y'/theta' = l cos theta; the angle counts on over a turn, along the whole motion alone
    model = crank(quantities={"lever": "rate(A.y)/rate(motor)", "turned": "angle(crank)"})
    move = kt.Quintic(moves={"motor": (0.2, 1.4)}, duration=2.0)
    model = model.with_(runs={"turn": kt.Run(analysis="kinematics.follow", trajectory=move, samples=9)})
    value, by = kt.value_and_gradient(kt.Response("at(lever, 0.5*s)", kt.run, model), ["nodes.A.at.0"])
    s = 0.25
    theta = 0.2 + 1.2 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    assert value == pytest.approx(0.5 * math.cos(theta), rel=1e-12)
    assert by.item() == pytest.approx(math.cos(theta), rel=1e-9)
    value, by = kt.value_and_gradient(kt.Response("final(turned)", kt.run, model), ["runs.turn.trajectory.moves.motor.1"])
    assert (value, by.item()) == (pytest.approx(1.4, rel=1e-12), pytest.approx(1.0, rel=1e-9))
    wishbone = kt.read(kt.library.example_files()["double_wishbone"][0])
    for response in ("max(camber)", "max(roll_centre)"):
        assert kt.check_gradient(kt.Response(response, kt.run, wishbone), ["nodes.UF.at.1", "nodes.LB.at.1"]).error < 1e-8


def test_a_run_under_a_condition():
    # a payload and another gravity: T = (m + p) l (g cos theta + l theta'')
    model = crank(
        conditions={"laden": kt.Condition(payloads={"A": 1.0}, gravity=(0, -4.0))}, gravity=(0, -9.81),
        loads={"pull": kt.NodalForce(node="A", force=(0.0, -3.0))},
    ).with_(runs={"turn": kt.Run(trajectory="rise", samples=5, condition="laden")},
            trajectories={"rise": kt.Quintic(moves={"motor": (0.0, 1.0)}, duration=2.0)})  # fmt: skip
    wrt = ["conditions.laden.payloads.A", "nodes.A.mass", "conditions.laden.gravity.1", "loads.pull.force.1", "nodes.A.at.0"]
    value, by = kt.value_and_gradient(kt.Response("first(drive_force[motor])", kt.run, model), wrt)
    assert value == pytest.approx(3.0 * 0.5 * 4.0 + 3.0 * 0.5, rel=1e-12)
    assert by.values == pytest.approx([0.5 * 4.0, 0.5 * 4.0, -3.0 * 0.5, -0.5, value / 0.5], rel=1e-9)
    hot = model.with_(conditions={"laden": kt.Condition(temperature=50.0)})
    with pytest.raises(AnalysisError, match="which changes the motion"):
        kt.gradient(kt.Response("first(drive_force[motor])", kt.run, hot), ["nodes.A.mass"])


def test_a_bell_crank_by_its_arms():
    # a cylinder straight below A holds 100 N at B: F = W x_B/x_A
    model = kt.Model(
        nodes={"O": (0, 0), "G": (0.3, -0.4), "A": (0.3, 0), "B": (0.5, 0.2)}, fixed=["O", "G"],
        links={"bell": kt.Link(nodes=("O", "A", "B"), section=kt.Rod(diameter=0.02), mass=0.0)},
        bars={"cylinder": kt.Bar(ends=("G", "A"), kind="driven", section=kt.Rod(diameter=0.02), mass=0.0)},
        material="steel_s235", loads={"pull": kt.NodalForce(node="B", force=(0, -100.0))},
        runs={"lift": kt.Run(trajectory=kt.ConstantRate(rates={"cylinder": 1e-3}, duration=1.0), samples=3)},
    )  # fmt: skip
    wrt = ["nodes.B.at.0", "nodes.A.at.0", "loads.pull.force.1"]
    value, by = kt.value_and_gradient(kt.Response("first(drive_force[cylinder])", kt.run, model), wrt)
    assert value == pytest.approx(100 * 0.5 / 0.3, rel=1e-12)
    assert by.values == pytest.approx([100 / 0.3, -100 * 0.5 / 0.09, -0.5 / 0.3], rel=1e-9)


@pytest.mark.parametrize(
    ("name", "run", "response", "wrt"),
    [
        ("loader_crane", "load", "max(utilisation)", ["nodes.M.at.0", "nodes.J.at.1"]),
        ("loader_crane", "load", "max(abs(mode_force))", ["nodes.M.at.0", "nodes.J.at.1"]),
        ("scissor_lift", "lift", "max(abs(drive_force[edge]))", ["nodes.M.at.0", "nodes.G.at.0"]),
    ],
)
def test_links_that_keep_their_shape(name, run, response, wrt):
    model = kt.read(kt.library.example_files()[name][0])
    assert kt.check_gradient(kt.Response(response, kt.run, model, run=run), wrt).error < 1e-8


def test_a_task_that_leads_two_cylinders():
    # at the end P is where the task asks: lengths |P - A| and |P - B|, and forces that hold the weight of 3 kg
    rods = {name: kt.Bar(ends=(name.upper(), "P"), kind="driven", section=kt.Rod(diameter=0.02), mass=0.0) for name in "ab"}
    model = kt.Model(
        nodes={"A": (-1, 0), "B": (1, 0), "P": kt.Node(at=(0.2, -1.5), mass=3.0)}, fixed=["A", "B"], bars=rods,
        material="steel_s235", gravity=(0, -9.81),
        runs={"go": kt.Run(targets=kt.Positioning(node="P", moves={"x": 0.5, "y": -1.0}, duration=1.0), samples=11)},
    )  # fmt: skip
    wrt = ["runs.go.targets.moves.x", "nodes.A.at.0", "nodes.A.at.1", "nodes.P.at.0", "nodes.P.mass"]

    def at_end(x, ax, ay):
        """Length of a, and its drive force, by complex numbers."""
        d, e = np.array([x - ax, -1.0 - ay]), np.array([x - 1.0, -1.0])
        q, p = (d @ d) ** 0.5, (e @ e) ** 0.5
        # tensions N balance the weight: -N_a d/q - N_b e/p = (0, 3 g)
        N = np.linalg.solve(-np.array([d / q, e / p]).T, [0.0, 3.0 * 9.81])
        return np.array([q, -N[0]])

    step = 1e-30j
    expected = [at_end(*np.array([0.5, -1.0, 0.0]) + step * one).imag / 1e-30 for one in np.eye(3)]
    final = [kt.Response(f"final({name}[a])", kt.run, model) for name in ("drive_position", "drive_force")]
    values, by = kt.value_and_gradient(final, wrt)
    length, force = at_end(0.5, -1.0, 0.0)
    assert values == pytest.approx([length, force], rel=1e-9)
    assert by.values[0] == pytest.approx([*(one[0] for one in expected), 0.0, 0.0], rel=1e-9, abs=1e-11)
    assert by.values[1] == pytest.approx([*(one[1] for one in expected), 0.0, force / 3.0], rel=1e-8, abs=1e-9)


def test_tasks_that_lead_a_delta_robot_and_a_platform():
    wrt = ["nodes.B1a.at.0", "nodes.A2a.at.2", "gravity.2"]
    delta = kt.read(kt.library.example_files()["delta"][0])
    pick = kt.Positioning(node="Q", moves={"x": 0.15, "y": 0.1, "z": -0.7}, duration=0.4)
    delta = delta.with_(runs={"pick": kt.Run(targets=pick, samples=21)})
    for response in ("max(abs(drive_force))", "rms(drive_force[arm1])"):
        assert kt.check_gradient(kt.Response(response, kt.run, delta), wrt).error < 1e-9
    stewart = kt.read(kt.library.example_files()["stewart"][0])
    turn = kt.Docking(platform=["P1", "P2", "P3"], moves={"z": 0.1, "roll": 0.1, "x": 0.02, "yaw": 0.1}, duration=1.0)
    stewart = stewart.with_(runs={"up": kt.Run(targets=turn, samples=11)})
    response = kt.Response("max(member_force)", kt.run, stewart)
    assert kt.check_gradient(response, ["nodes.B1.at.0", "nodes.P2.at.2"]).error < 1e-9


def test_which_drives_do_a_task_is_a_choice():
    model = kt.read(kt.library.example_files()["docking"][0])
    with pytest.raises(AnalysisError, match="18 drives do a task of 6 coordinates"):
        kt.gradient(kt.Response("max(abs(drive_velocity))", kt.run, model, run="dock"), ["nodes.B1.N1.at.0"])


# A four-bar with all its lengths given, beside its own equations in complex numbers.

LENGTHS = {"crank": 0.1, "coupler": 0.3, "rocker": 0.25}
GROUND, RATE, MASS = 0.28, 6.0, {"B": 0.7, "C": 1.3}


def four_bar():
    x = (0.3**2 - 0.25**2 + 0.18**2) / (2 * 0.18)
    return kt.Model(
        nodes={
            "A": (0, 0), "B": kt.Node(at=(0.1, 0), mass=MASS["B"]),
            "C": kt.Node(at=(0.1 + x, math.sqrt(0.3**2 - x * x)), mass=MASS["C"]), "D": (GROUND, 0),
        },
        fixed=["A", "D"], gravity=(0, -9.81), drives={"motor": kt.AngleDrive("crank")},
        bars={
            name: kt.Bar(ends=ends, length=LENGTHS[name], mass=0.0)
            for name, ends in {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("D", "C")}.items()
        },
        trajectories={"turn": kt.ConstantRate(rates={"motor": RATE}, duration=1.0)},
    )  # fmt: skip


def by_hand(numbers, t):
    """C, its acceleration, the torque and the coupler's force at an instant; complex numbers pass through."""
    l1, l2, l3, ground, w, m_b, m_c = numbers
    angle = w * t
    e, n = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    B, D = l1 * e, np.array([ground, 0.0 * w])
    span = D - B
    d = np.sqrt(span @ span)
    x = (l2**2 - l3**2 + d**2) / (2 * d)
    u = span / d
    C = B + x * u + np.sqrt(l2**2 - x * x) * np.array([-u[1], u[0]])
    J = np.array([C - B, C - D])
    vB, aB = l1 * w * n, -l1 * w * w * e
    v = np.linalg.solve(J, np.array([(C - B) @ vB, 0.0 * w]))
    rel = v - vB
    a = np.linalg.solve(J, np.array([(C - B) @ aB - rel @ rel, -(v @ v)]))
    push = m_c * (a - np.array([0.0, -9.81]))
    forces = np.linalg.solve(np.array([(B - C) / l2, (D - C) / l3]).T, push)
    power = m_b * ((aB - np.array([0.0, -9.81])) @ vB) + push @ v
    return C[0], a[1], power / w, forces[0]


@pytest.mark.parametrize("at", [0.15, 0.4, 0.85])
def test_a_four_bar_by_lengths_masses_and_speed(at):
    numbers = np.array([*LENGTHS.values(), GROUND, RATE, *MASS.values()])
    wrt = [*(f"bars.{name}.length" for name in LENGTHS), "nodes.D.at.0", "nodes.B.mass", "nodes.C.mass"]
    texts = ["position[C, x]", "acceleration[C, y]", "drive_force[motor]", "member_force[coupler]"]
    responses = [
        kt.Response(f"at({text}, {at})", kt.dynamics.inverse, four_bar(), trajectory="turn", samples=21) for text in texts
    ]
    values, by = kt.value_and_gradient(responses, wrt)
    assert values == pytest.approx(np.real(by_hand(numbers, at)), rel=1e-9)
    kept = [0, 1, 2, 3, 5, 6]
    steps = [by_hand(numbers + 1e-30j * np.eye(7)[k], at) for k in kept]
    exact = np.array(steps).T.imag / 1e-30
    assert np.abs(by.values - exact).max() < 1e-9 * np.abs(exact).max()
    for own, true in zip(by.values, exact, strict=True):
        assert own == pytest.approx(true, rel=1e-8, abs=1e-9 * np.abs(true).max())


def test_forces_along_a_slow_motion_are_those_of_virtual_work():
    # at rest T d(theta) = sum m g dy: so d/dm of the torque is g times the rate of the height by the angle
    model = four_bar()
    slow = kt.ConstantRate(rates={"motor": 1e-6}, duration=1.0)
    torque = kt.Response("at(drive_force[motor], 0.5)", kt.dynamics.inverse, model, trajectory=slow, samples=3)
    by = kt.gradient(torque, ["nodes.B.mass", "nodes.C.mass"])
    motion = kt.kinematics.follow(model, slow, times=[0.5])
    assert by.values == pytest.approx(9.81 * motion.velocity.sel(node=["B", "C"], axis="y").values[0] / 1e-6, rel=1e-9)


# Beside differences of the whole analysis.


def chain():
    """Two bays that all lengthen by other amounts in two seconds."""
    model = kt.library.vgt.double_octahedral(bays=2, screw="screw_lacy_spatial", gear="gear_lacy", motor="motor_lacy")
    first = kt.kinematics.follow(model, kt.ConstantRate(rates={next(iter(model.active)): 0.01}, duration=0.1), samples=2)
    length = {name: first.length.sel(member=name).values[0].item() for name in model.active}
    moves = {name: (one, one + 0.01 + 0.002 * k) for k, (name, one) in enumerate(length.items())}
    run = kt.Run(trajectory=kt.Quintic(moves=moves, duration=2.0), samples=11)
    return model.with_(runs={"extend": run}, safety=kt.Safety(yielding=1.5, buckling=2.0), gravity=(0, 0, -9.81))


@pytest.mark.parametrize(
    "text",
    [
        "max(utilisation)",
        "max(motor_torque)",
        "max(abs(voltage))",
        "rms(current)",
        "max(abs(section_M))",
        "max(energy)",
        "mass",
    ],
)
def test_a_chain_of_bays(text):
    model = chain()
    nodes = list(model.nodes)
    names = list(model.active)
    numbers = [
        f"nodes.{nodes[4]}.at.2", f"nodes.{nodes[-1]}.at.0", "sections.bar.outer", "gravity.2", "safety.buckling",
        "runs.extend.trajectory.duration", f"runs.extend.trajectory.moves.{names[0]}.1", f"active.{names[0]}.base.length",
    ]  # fmt: skip
    found = kt.check_gradient(kt.Response(text, kt.run, model), numbers, step=1e-5)
    assert found.error < 1e-9


def test_redundant_rows_share_forces_by_stiffness():
    # a driven bar carries a braced square, whose six bars bear one state of self-stress
    square = {"S": (1, 0), "T": (2, 0), "U": (2, 1), "V": (1, 1)}
    bars = {f"{a}{b}": kt.Bar(ends=(a, b), section=kt.Rod(diameter=0.01 + 0.001 * k), material="steel_s235")
            for k, (a, b) in enumerate(("ST", "TU", "UV", "VS", "SU", "TV"))}  # fmt: skip
    model = kt.Model(
        nodes={"O": (0, 0), "P": (0, 2), **square}, fixed={"O": "xy", "P": "xy", "S": "y"},
        bars={**bars, "push": kt.Bar(ends=("O", "S"), kind="driven"), "hold": kt.Bar(ends=("P", "V"), kind="driven")},
        section=kt.Rod(diameter=0.02), material="steel_s235", gravity=(0, -9.81),
        trajectories={"go": kt.Quintic(moves={"push": (1.0, 1.2), "hold": (math.sqrt(2), 1.6)}, duration=1.0)},
    )  # fmt: skip
    force = kt.Response("at(member_force[SU], 0.3)", kt.dynamics.inverse, model, trajectory="go", samples=11)
    numbers = ["bars.TV.section.diameter", "bars.SU.section.diameter", "bars.ST.section.diameter", "nodes.P.at.0"]
    found = kt.check_gradient(force, numbers)
    assert found.error < 1e-9
    assert np.abs(found.gradient).min() > 0


def test_load_cases_are_an_axis():
    model = crank(
        loads={"up": kt.NodalForce(node="A", force=(0, 30.0)), "aside": kt.NodalForce(node="A", force=(10.0, 0))},
        load_cases={"wind": kt.LoadCase(loads={"up": 1.0}), "push": kt.LoadCase(loads={"aside": 2.0})},
    )  # fmt: skip
    for text in ("max(abs(drive_force))", "max(drive_force[motor, push]) - 2*min(drive_force[motor, wind])"):
        found = kt.check_gradient(
            kt.Response(text, kt.run, model), ["loads.up.force.1", "load_cases.push.loads.aside", "nodes.A.at.0"], step=1e-5
        )
        assert found.error < 1e-9, text


def test_equal_parts_do_not_cancel_unseen_in_what_all_share():
    # two numbers near other nodes each, of one colour, with opposite effects on a sum that is nowhere
    near, step = [frozenset({0}), frozenset({1})], np.full(2, 1e-3)
    weighed = Weighed(lambda change: np.array([change[0] - change[1] + 5.0]), np.ones((1, 1)), np.array([-1]))
    assert differences(weighed, near, step, 2, few_act=True)[0] == pytest.approx([1, -1], rel=1e-9)
    unknowns = Unknowns(np.zeros((1, 2)), near, step, 2)
    weights = Weights(np.ones((1, 1, 1)), np.array([-1]))
    found = by_states(lambda x: x[..., :1] - x[..., 1:] + 5.0, weights, unknowns)
    assert found[0, 0] == pytest.approx([1, -1], rel=1e-9)


def test_rows_of_a_smoothed_record_act_strongly_nonlinear():
    model = kt.read(kt.library.example_files()["slewing_experiments"][0])
    second = kt.Response("at(drive_acceleration[M9], 1.0)", kt.run, model, run="experiment_1")
    assert kt.check_gradient(second, ["runs.experiment_1.trajectory.values.M9.80"], step=1e-6).error < 1e-4


def test_what_has_no_gradient_is_refused():
    model = crank()
    floating = kt.Model(
        nodes={"A": kt.Node(at=(0, 0), mass=1), "B": kt.Node(at=(1, 0), mass=1)},
        bars={"b": kt.Bar(ends=("A", "B"), kind="driven")},
        trajectories={"go": kt.ConstantRate(rates={"b": 0.1}, duration=1.0)},
    )  # fmt: skip
    with pytest.raises(AnalysisError, match="nothing holds the structure"):
        kt.gradient(kt.Response("max(velocity[B, x])", kt.kinematics.follow, floating, trajectory="go"), ["nodes.A.mass"])
    heavy = model.with_(gravity=(0, -9.81))
    with pytest.raises(AnalysisError, match="cannot change both ways"):
        kt.gradient(kt.Response("first(utilisation[crank, yield])", kt.run, heavy), ["safety.yielding"])
    with pytest.raises(AnalysisError, match="kink"):  # the couple that bends it is 0
        kt.gradient(kt.Response("first(utilisation[crank, yield])", kt.run, model), ["nodes.A.mass"])
    rubbing = model.with_(bearings={"pin": kt.Bearing(member="crank", node="O", radius=0.01, friction=0.2)})
    with pytest.raises(AnalysisError, match="bearings have friction"):
        kt.gradient(kt.Response("first(drive_force[motor])", kt.run, rubbing), ["nodes.A.mass"])
    simulated = model.with_(runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=0.1)})
    with pytest.raises(InputError, match="have no responses yet"):
        kt.gradient(kt.Response("max(energy)", kt.run, simulated), ["nodes.A.mass"])
    with pytest.raises(InputError, match="does not have"):
        kt.gradient(kt.Response("max(nothing)", kt.run, model), ["nodes.A.mass"])


def test_a_strut_past_its_buckling_load_is_named():
    """Its utilisation as a beam-column is infinite: refused, with what to do; below that load it has a gradient."""
    model = kt.Model(
        nodes={"O": (0, 0), "A": (2.0, 0)}, fixed=["O"], bars={"strut": ("O", "A")}, section=kt.Rod(diameter=0.01),
        material="steel_s235", drives={"motor": kt.AngleDrive("strut")}, gravity=(0, -9.81),
        loads={"push": kt.NodalForce(node="A", force=(-100.0, 0))},
        runs={"turn": kt.Run(trajectory=kt.Quintic(moves={"motor": (0, 0.1)}, duration=1.0), samples=5)},
    )  # fmt: skip
    used = kt.Response("first(utilisation[strut, beam-column])", kt.run, model, run="turn")
    assert kt.check_gradient(used, ["loads.push.force.0"]).error < 1e-8
    euler = np.pi**2 * kt.library.materials.STEEL_S235.E * np.pi * 0.01**4 / 64 / 2.0**2
    past = kt.io.set_values(model, {"loads.push.force.0": -1.1 * euler})
    with pytest.raises(AnalysisError, match="infinite at an instant"):
        kt.gradient(kt.Response("first(utilisation[strut, beam-column])", kt.run, past, run="turn"), ["loads.push.force.0"])
