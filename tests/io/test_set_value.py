"""One value changed by its path."""

import pytest

import kinetruss as kt
from kinetruss.io import set_value, set_values

MODEL = kt.library.vgt.double_octahedral(2, motor="motor_lacy", screw="screw_lacy_spatial").with_(
    trajectories={"lean": kt.Quintic(moves={"B1.beta": (0, 0.1)}, duration=3)},
    runs={"one": {"trajectory": "lean"}, "two": {"trajectory": kt.Quintic(moves={"B1.beta": (0, 0.1)}, duration=3)}},
)


def end(model):
    """Where the trajectory of the model ends."""
    return model.trajectories["lean"].moves["B1.beta"][1]


@pytest.mark.parametrize(
    ("path", "value", "found"),
    [
        ("runs.two.trajectory.duration", "5 s", lambda m: m.runs["two"].trajectory.duration == 5),
        ("runs.one.trajectory.duration", "5 s", lambda m: m.trajectories["lean"].duration == 5),
        (
            "trajectories.lean.moves.B1.beta.1",
            "10 deg",
            lambda m: end(m) == pytest.approx(0.17453293),
        ),
        (
            "trajectories.lean.moves.B1.beta",
            "[0, 5 deg]",
            lambda m: end(m) == pytest.approx(0.08726646),
        ),
        ("nodes.B1.N4.mass", "1 lb", lambda m: m.nodes["B1.N4"].mass == 0.45359237),
        ("nodes.B1.N4.at.2", 0.5, lambda m: m.nodes["B1.N4"].at[2] == 0.5),
        ("active.B1.M7.motor.max_current", "4 A", lambda m: m.motors["motor"].max_current == 4),
        ("active.B1.M7.base.mass", "4 kg", lambda m: m.active["B1.M7"].base.mass == 4 and m.active["B1.M9"].base.mass == 3),
        ("safety.yielding", "1.5", lambda m: m.safety == kt.Safety(yielding=1.5)),
        ("sections.bar", "{kind: rod, diameter: 1 cm}", lambda m: m.sections["bar"] == kt.Rod(diameter=0.01)),
        ("gravity", "~", lambda m: m.gravity is None),
        ("runs.one.samples", "1e3", lambda m: m.runs["one"].samples == 1000),
        ("title", "other", lambda m: m.title == "other"),
    ],
)
def test_set(path, value, found):
    before = MODEL.with_()
    assert found(set_value(MODEL, path, value))
    assert before == MODEL


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("runs.on.samples", 3, r"runs\.on: 'on' is not known here\. Did you mean 'one'"),
        ("nodes.B1.N44.mass", 3, "'B1' is not known here"),
        ("safety.yeilding", 3, "Did you mean 'yielding'"),
        ("nodes.B1.N4.at.3", 3, r"There are: 0, 1, 2\."),
        ("title.of", 3, r"title: has no parts\. End the path at title"),
        ("runs.one.load_cases.0", "a", r"runs\.one\.load_cases: is not set"),
        ("runs.one.trajectory.duration", "5 kg", r"trajectories\.lean\.duration: '5 kg' is not a time"),
        ("runs.one.trajectory", "left", r"no trajectory called 'left'"),
        ("", 3, "'' is not known here"),
    ],
)
def test_faults(path, value, message):
    with pytest.raises(kt.ModelError, match=message):
        set_value(MODEL, path, value)


def test_several_at_once_are_checked_as_a_whole():
    model = MODEL.with_(sections=MODEL.sections | {"bar": kt.Tube(outer=0.02, inner=0.018)})
    changed = set_values(model, {"sections.bar.outer": "10 mm", "sections.bar.inner": "8 mm", "nodes.B1.N4.mass": 2})
    assert (changed.sections["bar"].outer, changed.sections["bar"].inner) == (0.01, 0.008)
    assert changed.nodes["B1.N4"].mass == 2
    with pytest.raises(kt.ModelError):
        set_value(model, "sections.bar.outer", "10 mm")


@pytest.mark.parametrize(
    "paths",
    [
        ("runs.one.trajectory.duration", "trajectories.lean.duration"),
        ("trajectories.lean", "trajectories.lean.duration"),
        ("trajectories.lean.duration", "trajectories.lean"),
    ],
)
def test_two_paths_to_the_same_value(paths):
    with pytest.raises(kt.ModelError, match=f"'{paths[1]}' sets what another path sets too"):
        set_values(MODEL, dict.fromkeys(paths, "4 s"))
