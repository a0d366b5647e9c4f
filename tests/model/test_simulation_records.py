"""Records of simulations: what they accept, what they refuse in which words, and that files hold all of it."""

import json

import pytest
from jsonschema import Draft202012Validator

import kinetruss as kt
from kinetruss.io import schema

PLANE = {
    "nodes": {"A": (0, 0), "B": (1, 0), "C": (0, 1)},
    "fixed": ["A"],
    "bars": {"ab": ("A", "B"), "bc": ("B", "C"), "ac": ("A", "C")},
    "drives": {"turn": kt.AngleDrive("ab"), "slide": kt.CoordinateDrive(node="C", axis="x")},
}
SPACE = {"nodes": {"A": (0, 0, 0), "B": (1, 0, 0)}, "fixed": ["A"], "bars": {"ab": ("A", "B")}}
BODY = {"mass": 1, "center": (0.5, 0.1), "inertia": 0.1}
PART = {"length": 0.7, "mass": 1}


def told(base, **changes):
    """The lines of all faults of a model."""
    try:
        kt.Model(**base | changes)
    except kt.ModelError as error:
        return str(error).splitlines()
    return []


def bar(**fields):
    return {"bars": PLANE["bars"] | {"s": {"ends": ("A", "C")} | fields}}


def simulated(**fields):
    return {"runs": {"r": {"analysis": "dynamics.simulate", "t_end": "1 s"} | fields}}


@pytest.mark.parametrize(
    ("fields", "fault"),
    [
        ({"kind": "elastic"}, "bars.s: is elastic but has no section and no material. Give both, for E A, or give stiffness"),
        ({"kind": "cable"}, "bars.s: is a cable but has no section and no material."),
        ({"stiffness": 1}, "bars.s.stiffness: is given for a rigid bar. Only elastic bars and cables have one."),
        ({"pretension": 1}, "bars.s.pretension: is given for a rigid bar."),
        ({"kind": "driven", "damping": 1}, "bars.s.damping: is given for a driven bar, whose length is prescribed."),
        ({"kind": "elastic", "stiffness": 1, "damping": -1}, "bars.s.damping: -1 must not be negative."),
        ({"kind": "elastic", "stiffness": 0}, "bars.s.stiffness: 0 must be greater than 0."),
        ({"kind": "elastic", "stiffness": "1 N"}, "bars.s.stiffness: '1 N' is not a stiffness (N/m)."),
        ({"kind": "cable", "stiffness": 1, "strain": "green"}, "bars.s.strain: is given for a cable."),
        ({"strain": "green"}, "bars.s.strain: is given for a rigid bar."),
        (
            {"kind": "cable", "stiffness": 1, "pretension": -1},
            "bars.s.pretension: -1 N is compression; a cable carries tension only.",
        ),
        ({"kind": "elastic", "stiffness": 1, "pretension": 2}, "bars.s.pretension: 2 N is more than the bar can carry"),
        (
            {"kind": "elastic", "stiffness": 1, "pretension": 0.1, "natural_length": 1},
            "bars.s.pretension: is given together with natural_length.",
        ),
        ({"kind": "cable", "stiffness": 1, "length": 1}, "bars.s.length: is given for a cable, which keeps none."),
        ({"body": BODY, "mass": 2}, "bars.s.body: is given together with mass."),
        ({"body": BODY, "section": kt.Rod(diameter=0.01)}, "bars.s.body: is given together with section."),
        ({"body": BODY, "kind": "elastic", "stiffness": 1}, "bars.s.body: is given for an elastic bar, whose length changes."),
        ({"body": BODY | {"inertia": -1}}, "bars.s.body.inertia: -1 must not be negative."),
    ],
)
def test_one_fault_of_a_bar(fields, fault):
    (line,) = told(PLANE, **bar(**fields))
    assert line.startswith(fault)


@pytest.mark.parametrize(
    ("base", "changes", "fault"),
    [
        (SPACE, {"bars": {"ab": {"ends": ("A", "B"), "body": BODY}}}, "bars.ab.body: is a planar body in space."),
        (
            PLANE,
            bar(body=BODY) | {"drives": {"d": kt.LengthDrive("s")}},
            "bars.s.body: is given for a bar whose length 'd' drives.",
        ),
        (PLANE, bar(body=BODY) | {"gauges": {"g": {"member": "s"}}}, "gauges.g: sits on 's', a planar body"),
        (PLANE, {"velocities": {"Z": (0, 1)}}, "velocities.Z: no node called 'Z'."),
        (PLANE, {"velocities": {"B": (0, 1, 0)}}, "velocities.B: has 3 components, the model has 2 axes. Give 2."),
        (PLANE, simulated(t_end=0), "runs.r.t_end: 0 must be greater than 0."),
        (PLANE, {"runs": {"r": {"analysis": "dynamics.simulate"}}}, "runs.r: has no t_end."),
        (PLANE, simulated(load_cases=("a", "b")), "runs.r: has 2 load cases; a simulation has one motion."),
        (PLANE, simulated(motion="m.csv"), "runs.r: has motion, which dynamics.simulate does not use."),
        (
            PLANE,
            {"runs": {"r": {"trajectory": kt.ConstantRate(rates={"turn": 1}, duration=1), "t_end": 1}}},
            "runs.r: has t_end, which dynamics.inverse does not use.",
        ),
        (PLANE, simulated(method={"kind": "dop853", "rtol": 0}), "runs.r.method.rtol: 0 must be greater than 0."),
        (PLANE, simulated(method={"kind": "dop853", "atol": -1}), "runs.r.method.atol: -1 must be greater than 0."),
        (PLANE, simulated(method={"kind": "rattle"}), "runs.r.method.step: 'step' is missing."),
        (PLANE, simulated(method={"kind": "euler"}), "runs.r.method: kind 'euler' is not known."),
        (PLANE, simulated(tasks={"trun": {"kind": "free"}}), "runs.r.tasks.trun: no drive called 'trun'. Did you mean 'turn'?"),
        (PLANE, simulated(tasks={"turn": {"kind": "fre"}}), "runs.r.tasks.turn: kind 'fre' is not known. Did you mean 'free'"),
        (PLANE, simulated(tasks={"turn": {}}), "runs.r.tasks.turn: has no kind. Add kind: one of free, hold, force"),
        (PLANE, simulated(tasks={"turn": kt.GivenForce(2)}), "runs.r.tasks.turn: has a force, but 'turn' drives an angle."),
        (
            PLANE,
            simulated(tasks={"slide": kt.GivenForce(torque=2)}),
            "runs.r.tasks.slide: has a torque, but 'slide' drives a coordinate.",
        ),
        (
            PLANE,
            simulated(tasks={"turn": {"kind": "force", "torque": "1 N"}}),
            "runs.r.tasks.turn.torque: '1 N' is not",
        ),
        (
            PLANE,
            simulated(tasks={"turn": kt.StepInput(voltage=1)}),
            "runs.r.tasks.turn: feeds a motor, but 'turn' has none.",
        ),
        (
            SPACE | {"bars": {}, "active": {"M": {"ends": ("A", "B"), "base": PART, "tube": PART}}},
            simulated(tasks={"M": kt.SineInput(voltage=1, period=1)}),
            "runs.r.tasks.M: feeds the motor of 'M', which has no screw and no motor.",
        ),
        (
            PLANE,
            simulated(tasks={"turn": kt.ConstantRate(rates={"slide": 1}, duration=1)}),
            "runs.r.tasks.turn: moves slide, not 'turn' alone.",
        ),
        (PLANE, simulated(events={"e": {"length": "xy", "value": 1}}), "runs.r.events.e.length: no member called 'xy'."),
        (PLANE, simulated(events={"e": {"coordinate": "Z.x", "value": 1}}), "runs.r.events.e.coordinate: no coordinate called"),
        (
            PLANE,
            simulated(events={"e": {"coordinate": "C.z", "value": 1}}),
            "runs.r.events.e.coordinate: 'z' is no axis",
        ),
        (PLANE, simulated(events={"e": {"value": 1}}), "runs.r.events.e: watches nothing."),
        (
            PLANE,
            simulated(events={"e": {"length": "ab", "force": "ab", "value": 1}}),
            "runs.r.events.e: has length and force.",
        ),
        (PLANE, simulated(events={"e": {"force": "ab", "value": "1 m"}}), "runs.r.events.e.value: '1 m' is not a force (N)."),
    ],
)
def test_one_fault(base, changes, fault):
    (line,) = told(base, **changes)
    assert line.startswith(fault)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({}, "has no force"),
        ({"force": 1, "torque": 1}, "has force and torque"),
        ({"forces": (1, 2)}, "a table needs times and forces"),
        ({"force": 1, "times": (0, 1)}, "a table needs times and forces"),
        ({"forces": (1, 2, 3), "times": (0, 1)}, "2 times but 3 forces"),
        ({"forces": (1, 2), "times": (1, 0)}, "time goes back"),
    ],
)
def test_given_force_has_one_form(fields, message):
    with pytest.raises(kt.ModelError, match=message):
        kt.GivenForce(**fields)


def test_given_force_tells_what_it_is():
    assert kt.GivenForce("2 kN").constant == 2000
    assert kt.GivenForce(torque="2 N m").turns
    assert kt.GivenForce(times=(0, 1), torques=(1, 2)).table == (1, 2)


def test_an_event_reads_its_value_in_its_own_unit():
    assert kt.Event(force="a", value="2 kN").value == 2000
    assert kt.Event(length="a", value="2 mm").value == 0.002


def test_a_sine_is_a_motion_or_an_input():
    run = kt.Run(
        analysis="dynamics.simulate", t_end=1,
        tasks={"a": {"kind": "sine", "amplitudes": {"a": 1}, "period": 1, "duration": 1},
               "b": {"kind": "sine", "voltage": 2, "period": 1}},
    )  # fmt: skip
    assert isinstance(run.tasks["a"], kt.Sine)
    assert isinstance(run.tasks["b"], kt.SineInput)


def whole():
    """A model with one of everything that belongs to simulations."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1), "D": (1, 1)},
        fixed=["A"],
        bars={
            "body": kt.Bar(ends=("A", "B"), body=kt.PlanarBody(**BODY)),
            "spring": kt.Bar(ends=("B", "C"), kind="elastic", stiffness="2 kN/m", pretension="1 N", damping="3 N s/m"),
            "green": kt.Bar(ends=("B", "D"), kind="elastic", stiffness=2.0, strain="green", natural_length=0.9),
            "cable": kt.Bar(ends=("A", "C"), kind="cable", stiffness=3.0),
            "damper": kt.Bar(ends=("A", "D"), kind="free", damping=2.0),
            "jack": kt.Bar(ends=("C", "D"), kind="driven"),
        },
        velocities={"C": (1, "2 mm/s")},
        drives={"turn": kt.AngleDrive("body"), "slide": kt.CoordinateDrive(node="C", axis="x")},
        loads={"push": kt.NodalForce(node="D", force=(1, 0))},
        load_cases={"pushed": kt.LoadCase(loads={"push": 2.0})},
        runs={
            "free": kt.Run(analysis="dynamics.simulate", t_end=2, tasks={"turn": kt.Free(), "slide": kt.Hold()}),
            "pushed": kt.Run(
                analysis="dynamics.simulate", t_end=2, load_cases=("pushed",), samples=11,
                trajectory=kt.ConstantRate(rates={"slide": 0.1}, duration=2),
                tasks={"turn": kt.GivenForce(times=(0, 1), torques=(0, 3)),
                       "jack": kt.Sine(amplitudes={"jack": 0.1}, period=1, duration=2)},
                method=kt.GeneralizedAlpha(1e-3, rho=0.8),
                events={"high": kt.Event(coordinate="D.y", value="1.2 m", direction="rising", stop=False),
                        "hard": kt.Event(force="cable", value="2 kN")},
            ),
            "long": kt.Run(analysis="dynamics.simulate", t_end=2, method=kt.EnergyMomentum("1 ms")),
            "steady": kt.Run(analysis="dynamics.simulate", t_end=2, method=kt.Rattle(1e-3, solver="sparse")),
            "stiff": kt.Run(analysis="dynamics.simulate", t_end=2, method=kt.Radau(rtol=1e-6, atol=1e-5, max_steps=1000)),
        },
    )  # fmt: skip


@pytest.mark.parametrize("suffix", ["yaml", "json"])
def test_files_hold_it(tmp_path, suffix):
    model = whole()
    path = kt.write(model, tmp_path / f"m.{suffix}")
    assert kt.read(path) == model
    if suffix == "json":
        assert list(Draft202012Validator(schema()).iter_errors(json.loads(path.read_text()))) == []
    assert kt.Model.model_validate_json(model.model_dump_json()) == model


@pytest.mark.slow
@pytest.mark.parametrize("name", ["kind", "analysis", "tasks", "method", "events"])
def test_an_editor_marks_what_is_wrong(name):
    judge = Draft202012Validator(schema())
    run = {"analysis": "dynamics.simulate", "t_end": "1 s"}
    wrong = {"kind": {"bars": {"b": {"ends": ["A", "B"], "kind": "rope"}}},
             "analysis": {"runs": {"r": {"analysis": "simulate"}}},
             "tasks": {"runs": {"r": run | {"tasks": {"d": {"kind": "fre"}}}}},
             "method": {"runs": {"r": run | {"method": {"kind": "rattle"}}}},
             "events": {"runs": {"r": run | {"events": {"e": {"length": "b"}}}}}}[name]  # fmt: skip
    assert list(judge.iter_errors({"nodes": {"A": [0, 0], "B": [1, 0]}} | wrong))
