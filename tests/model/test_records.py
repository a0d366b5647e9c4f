"""Records: frozen, exact in what they take, and clear in what they refuse."""

import numpy as np
import pytest

import kinetruss as kt


def refused(make):
    """The faults of a record or model that cannot be made."""
    with pytest.raises(kt.ModelError) as caught:
        make()
    return str(caught.value)


def test_records_are_frozen_and_change_by_with():
    tube = kt.Tube(outer="19 mm", inner="16 mm")
    with pytest.raises(kt.FrozenError, match=r"frozen.*with_\(outer="):
        tube.outer = 1.0
    assert tube.with_(inner=0).inner == 0
    assert tube.inner == 0.016


def test_a_record_alone_says_its_name():
    assert refused(lambda: kt.Tube(outer="16 mm", inner="19 mm")).startswith("Tube: inner diameter 0.019 m")
    assert refused(lambda: kt.Rod(diameter="1 kg")).startswith("Rod.diameter: '1 kg' is not a length")
    assert refused(lambda: kt.LengthDrive()) == "LengthDrive.bar: 'bar' is missing. Add it."
    assert refused(lambda: kt.Rod(diameter=1).with_(diameter=-1)).startswith("Rod.diameter: -1 must be greater than 0.")


def test_fields_go_by_name():
    assert kt.LengthDrive("b") == kt.LengthDrive(bar="b")
    with pytest.raises(TypeError, match=r"Rod takes its fields by name: Rod\(diameter=\.\.\., shear_coefficient=\.\.\.\)"):
        kt.Rod(0.1)


def test_arrays_do_for_lists():
    assert kt.Node(at=np.array([1, 2])).at == (1.0, 2.0)
    times = np.linspace(0, 1, 5)
    assert kt.Spline(times=times, values={"b": times}) == kt.Spline(times=times.tolist(), values={"b": times.tolist()})
    assert kt.NodalForce(node="A", times=times, forces=np.zeros((5, 2))).forces == ((0.0, 0.0),) * 5
    model = kt.Model(nodes={"A": np.zeros(2), "B": np.ones(2)}, bars={"b": np.array(["A", "B"])}, gravity=np.array([0, -9.81]))
    assert model.bars["b"].ends == ("A", "B")


@pytest.mark.parametrize("value", ["yes", "on", "1", 1, 0, "True", None], ids=repr)
def test_only_true_and_false_are_flags(value):
    assert "is not true or false" in refused(lambda: kt.Bar(ends=("A", "B"), rotary_inertia=value))


@pytest.mark.parametrize(("value", "count"), [("1e3", 1000), (7.0, 7), ("20", 20), (np.int64(5), 5)], ids=repr)
def test_counts(value, count):
    assert kt.Run(motion="m.csv", samples=value).samples == count


@pytest.mark.parametrize("value", [True, 2.5, "2.5", "many", None, 1, 10**8], ids=repr)
def test_no_counts(value):
    assert refused(lambda: kt.Run(motion="m.csv", samples=value)).startswith("Run.samples: ")


@pytest.mark.parametrize("name", [3, 3.0, True, None, "", "a b", "a/b", "a\\b", "x" * 201, b"a"], ids=repr)
def test_no_names(name):
    assert refused(lambda: kt.Bar(ends=("A", name))).startswith("Bar.ends.1: ")


@pytest.mark.parametrize("value", ["clamped-free", "1", "2.046", 4, 0.25], ids=repr)
def test_end_conditions(value):
    assert kt.Bar(ends=("A", "B"), buckling=value).buckling == (value if value == "clamped-free" else float(value))


@pytest.mark.parametrize("value", ["clamped", "-1", 0, "nan", float("inf"), True, None], ids=repr)
def test_no_end_conditions(value):
    assert refused(lambda: kt.Bar(ends=("A", "B"), buckling=value)).startswith("Bar.buckling: ")


@pytest.mark.parametrize(
    ("section", "fault"),
    [
        ({"kind": "tubee"}, "kind 'tubee' is not known. Did you mean 'tube'?"),
        ({"outer": 1}, "has no kind. Add kind: one of tube, rod, rectangle, general."),
        (3, 'is 3; expected a record. Write for example kt.Rod(diameter="10 mm").'),
        ({"kind": "tube", "outer": 1, "inner": 2}, "inner diameter 2 m must be at least 0 and less than the outer 1 m."),
        ("no such", "'no such' is no name: it is empty, or has a space, a slash or a control character."),
    ],
)
def test_one_fault_for_one_wrong_section(section, fault):
    message = refused(lambda: kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": {"ends": ("A", "B"), "section": section}}))
    assert message.startswith(f"bars.b.section: {fault}")
    assert "\n" not in message


def test_one_fault_for_one_wrong_coordinate():
    assert refused(lambda: kt.Node(at=("1,5 m", 0))) == (
        "Node.at.0: '1,5 m' is not a length: a comma in the number. Write a decimal point: '1.5 m'."
    )


def test_misspelt_fields_offer_the_right_ones():
    assert refused(lambda: kt.Motor(intertia=1, resistance=1, torque_constant=1, emf_constant=1)).splitlines() == [
        "Motor.inertia: 'inertia' is missing. Add it.",
        "Motor.intertia: 'intertia' is not known here. Did you mean 'inertia'?",
    ]
    assert refused(lambda: kt.Quintic(moves={"b": (0, 1)}, duratoin=1)).endswith("Did you mean 'duration'?")
