"""Mistakes that everybody makes once: each message says what is wrong, where, and what to write instead."""

from __future__ import annotations

import json
import pydoc
import types

import pytest
import yaml

import kinetruss as kt

TURN = {"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": 1.0}, duration=1.0), samples=5)}


def _four_bar() -> kt.Model:
    return kt.library.mechanisms.four_bar(title="leg")


def _turn(model: kt.Model) -> tuple[kt.results.Motion, kt.results.Forces]:
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": "60 rpm"}, duration="1 s"), samples=5)
    return motion, kt.dynamics.inverse(model, motion)


WRONG_FIELDS = [
    (lambda m: kt.NodalForce("C", (1, 0)), "NodalForce(node=..., force=..., times=..., ...)"),
    (lambda m: kt.Model({"A": (0, 0)}), "Model(nodes=..., title=..., fixed=..., ...)"),
    (lambda m: m.with_(load={}), "'load' is not known here. Did you mean 'loads'?"),
    (lambda m: m.with_(gravity=9.81), "Write for example [0, -9.81]."),
    (lambda m: m.with_(fixed="A"), 'fixed=["A", "D"], or fixed={"A": "xy", "D": "xy"}'),
    (lambda m: m.with_(bars=[("A", "B")]), '{"crank": ["A", "B"]}'),
    (
        lambda m: m.with_(loads=[kt.NodalForce(node="C", force=(1, 0))]),
        '{"weight": kt.NodalForce(node="B", force=[0, "-100 N"])}',
    ),
    (lambda m: kt.NodalForce(node="C", force=50), 'Write for example [0, "-100 N"].'),
    (lambda m: kt.Quintic(moves={"motor": "90 deg"}, duration=1), '[0, "90 deg"], the first and the last value'),
    (lambda m: kt.strength.check(_turn(m)[1], m), "A model is expected first, not a Forces."),
    (lambda m: kt.strength.check(m, _turn(m)[0]), "A Motion is not forces. Give the result of dynamics.inverse"),
    (lambda m: kt.dynamics.inverse(_turn(m)[0], m), "A model is expected first, not a Motion."),
    (lambda m: kt.kinematics.mobility("leg.yaml"), "A model is expected first, not 'leg.yaml'. Give a kt.Model, or kt.read("),
    (lambda m: kt.report.picture(m, "leg.png", at="3 kg"), "'3 kg' is not a time (s)"),
    (lambda m: m.with_(section="circle"), "section: no section called 'circle'. Give a solid round bar as kt.Rod("),
    (lambda m: m.with_(section=kt.Circle(centre=(0, 0))), "kind 'circle' is not known. Give a solid round bar as kt.Rod("),
    (lambda m: m.with_(section={"kind": "pipe"}), 'a round tube as kt.Tube(outer="20 mm", inner="16 mm")'),
    (lambda m: kt.dynamics.simulate(m, "1 m"), "'1 m' is not a time (s)"),
]


@pytest.mark.slow
@pytest.mark.parametrize("k", range(len(WRONG_FIELDS)))
def test_the_message_says_what_to_write(k):
    mistake, told = WRONG_FIELDS[k]
    with pytest.raises(kt.InputError) as found:
        mistake(_four_bar())
    assert told in str(found.value)


def test_a_wrong_name_offers_the_right_one():
    for wrong, right in (("simulate", "kinetruss.dynamics.simulate"), ("Moddel", "Model"), ("kinematic", "kinematics")):
        with pytest.raises(AttributeError, match=rf"{wrong}'\. Did you mean '{right}'\?$"):
            getattr(kt, wrong)
    with pytest.raises(AttributeError, match=r"'_secret'$"):
        kt._secret  # noqa: B018
    with pytest.raises(KeyError, match="Did you mean 'crank'"):
        _four_bar().bars["crnk"]
    assert "crnk" not in _four_bar().bars and _four_bar().bars.get("crnk") is None


@pytest.mark.slow
def test_units_are_read_where_a_file_reads_them(tmp_path):
    model = _four_bar()
    free = {"motor": kt.GivenForce(torque=0.0)}
    fall, same = (kt.dynamics.simulate(model, end, tasks=free, samples=3) for end in ("50 ms", 0.05))
    assert fall.motion.position.equals(same.motion.position)
    kt.write(model.with_(runs=TURN), tmp_path / "leg.yaml")
    run = kt.run(tmp_path / "leg.yaml")
    assert kt.report.picture(run, tmp_path / "leg.svg", at=["0 s", "500 ms"]).exists()
    assert kt.report.plot(run, "drive_force", tmp_path / "torque.svg").exists()  # one run needs no list


def test_results_are_shown_by_what_they_say():
    model = _four_bar()
    motion, forces = _turn(model)
    verdict = kt.strength.check(model, forces)
    worst = verdict.table()[0]
    assert repr(verdict).splitlines()[1] == f"  highest: {worst.text}"
    assert repr(worst) == f"<Row {worst.text}>" and worst.text.startswith("crank, yield: ") and " MPa of 235 MPa)" in worst.text
    assert repr(kt.actuators.evaluate(model, motion, forces)).endswith(
        "Empty: no active member or drive has a screw, a gear or a motor."
    )
    run = kt.run(model.with_(runs=TURN))
    told = repr(run).splitlines()
    assert told[0] == "<Run 'turn' of 'leg': Completed." and told[1].startswith("  OK; crank, ") and len(told) == 3


def test_completion_and_help_show_no_internals():
    shelves = [one for name in dir(kt.library) if isinstance(one := getattr(kt.library, name), types.ModuleType)]
    packages = [one for name in kt.__all__ if isinstance(one := getattr(kt, name), types.ModuleType)]
    single = {kt.errors, kt.units}  # modules, not packages
    for module in {*packages, *shelves} - single:
        assert set(dir(module)) <= set(module.__all__), module.__name__
    text = pydoc.render_doc(kt.NodalForce, renderer=pydoc.plaintext)
    assert "model_dump" not in text and "with_" in text and len(text.splitlines()) < 40


LIVE = {
    "rates of a trajectory": lambda: kt.ConstantRate(rates=10.0, duration=1),
    "a drive": lambda: kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"crank": ("A", "B")}, drives={"motor": "crank"}),
    "a load": lambda: kt.Model(nodes={"A": (0, 0)}, loads={"x": 5}),
    "a run": lambda: kt.Model(nodes={"A": (0, 0)}, runs={"x": 5}),
    "a material": lambda: kt.Model(nodes={"A": (0, 0)}, material=5),
    "a section": lambda: kt.Model(nodes={"A": (0, 0)}, section=5),
}  # fmt: skip


@pytest.mark.parametrize("wrong", LIVE.values(), ids=LIVE)
def test_what_python_is_told_to_write_is_python(wrong):
    with pytest.raises(kt.ModelError) as error:
        wrong()
    (fault,) = error.value.faults
    given = fault.mend.removeprefix("Write for example ").removesuffix(".")
    assert eval(given, {"kt": kt})


def test_a_file_is_told_to_write_yaml(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text("kinetruss: 1\nnodes: {A: [0, 0], B: [1, 0]}\nbars: {crank: [A, B]}\nfixed: A, B\ndrives: {motor: crank}\n")
    fixed, drive = kt.check(path)
    assert fixed.mend == "Write for example fixed: [A, D], or fixed: {A: xy, D: xy}."
    assert drive.mend == "Write for example {kind: angle, bar: crank}."


WRONG = {
    "beams": {"b": "A"}, "bodies": {"b": 3}, "conditions": {"c": 3}, "couplings": {"c": ["motor", 1]}, "drives": {"m": "crank"},
    "load_cases": {"a": ["f"]}, "loads": {"f": (0, -1)}, "runs": {"r": 5}, "safety": 2, "springs": {"s": 4}, "section": 0.02,
    "clamped": 7, "fixed": 7, "nodes": 3, "bars": 3, "trajectories": {"t": 4},
}  # fmt: skip


@pytest.mark.parametrize("field", WRONG)
def test_what_an_error_offers_is_python_in_python_and_yaml_in_files(field, tmp_path):
    with pytest.raises(kt.ModelError) as caught:
        kt.Model(**{"nodes": {"A": (0, 0), "B": (1, 0)}, field: WRONG[field]})
    (fault,) = [one for one in caught.value.faults if one.path[0] == field]
    offered = fault.mend.removeprefix("Write for example ").rstrip(".").split(", or ")
    for one in offered:
        value = eval(one.removeprefix(f"{field}="), {"kt": kt})
        assert value == {"A": "BODY"} or not isinstance(value, str)
    file = tmp_path / "model.json"
    file.write_text(json.dumps({"kinetruss": 1, "nodes": {"A": (0, 0), "B": (1, 0)}} | {field: WRONG[field]}))
    (placed,) = [one for one in kt.check(file) if one.path[0] == field]
    for one in placed.mend.removeprefix("Write for example ").rstrip(".").split(", or "):
        assert isinstance(yaml.safe_load(one.removeprefix(f"{field}: ")), (dict, list))


@pytest.mark.parametrize(
    ("record", "given", "meant"),
    [
        (kt.Run, "duration", "t_end"),
        (kt.Node, "weight", "mass"),
        (kt.Material, "rho", "density"),
    ],
)
def test_words_of_other_programs_are_understood(record, given, meant):
    with pytest.raises(kt.ModelError, match=f"{given}: '{given}' is not known here. Did you mean '{meant}'"):
        record(**{given: 3})


@pytest.mark.parametrize("load", [{"node": "C", "force": (0, -5), "at": 3}, {"face": ("A", "B"), "pressure": 1, "at": 1}])
def test_what_is_refused_is_not_offered(load):
    """A field of another kind of load is none of this kind."""
    with pytest.raises(kt.ModelError, match=r"'at' is not known here\. There are: (node|face), "):
        _four_bar().with_(loads={"push": load})


def test_a_structure_without_supports_is_told_so():
    model = kt.library.mechanisms.four_bar().with_(fixed={}, runs={"go": TURN["turn"]})
    (fault,) = kt.check(model)
    assert str(fault) == (
        "runs.go: no node is fixed, so that the structure moves as a whole. Name the nodes at its supports in 'fixed'."
    )
    with pytest.raises(kt.InputError, match="No node is fixed"):
        kt.kinematics.follow(model, TURN["turn"].trajectory)
