"""Whatever happens to a model file, the answer is a model or its faults, never a crash."""

import copy
import json

import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.io.emitting import plain_model

FULL = plain_model(
    kt.library.vgt.double_octahedral(
        2, tip_force=(0, 0, 46), payload_mass=1, motor="motor_lacy", screw="screw_lacy_spatial", gear="gear_lacy"
    ).with_(
        title="all tables",
        load_cases={"full": {"loads": {"tip_N7": 1.5}, "gravity": (0, 0, 1)}},
        support_motion={"B1.N1": {"times": (0, 1), "displacements": ((0, 0, 0), (0, 0, 1))}},
        trajectories={
            "lean": kt.Quintic(moves={"B1.beta": (0, 0.1)}, duration=3),
            "seen": kt.Spline(times=(0, 1, 2, 3), values={"B1.M7": (1, 1.1, 1.2, 1.1)}),
            "turn": kt.ConstantRate(rates={"B1.M7": "1 mm/s"}, duration=1),
        },
        runs={"one": {"trajectory": "lean", "load_cases": ["full"]}, "two": {"motion": "none.csv"}},
    )
)


def places(data, path=()):
    """Paths of all parts of plain data."""
    yield path
    entries = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in entries:
        yield from places(value, (*path, key))


PLACES = [path for path in places(FULL) if path]
junk = st.one_of(
    st.none(), st.booleans(), st.integers(-3, 3), st.just(10**400), st.just(1e308),
    st.sampled_from(["", "no", "1 kg", "1 m", "N1", "lean", "tube", "[", "x" * 300]),
    st.just([]), st.just([[1]]), st.just([{}]), st.just({}), st.just({"kind": []}), st.just({"kind": "tube"}), st.just({"": 1}),
)  # fmt: skip


def damaged(data, damages):
    """Data with some parts replaced, taken out, renamed or moved."""
    data = copy.deepcopy(data)
    for path, what, how in damages:
        here = data
        try:
            for part in path[:-1]:
                here = here[part]
            if how == "replace" or isinstance(here, list):
                here[path[-1]] = copy.deepcopy(what)  # junk is shared between examples
            elif how == "remove":
                del here[path[-1]]
            else:
                here[str(what)[:9]] = here.pop(path[-1])
        except (KeyError, IndexError, TypeError, AttributeError):
            continue  # an earlier damage took this place away
    return data


ways = st.sampled_from(["replace", "remove", "rename"])
damages = st.lists(st.tuples(st.sampled_from(PLACES), junk, ways), min_size=1, max_size=4)


def told(make):
    """Faults, each with a mend, or none."""
    try:
        make()
    except kt.ModelError as error:
        assert error.faults
        for fault in error.faults:
            assert fault.message
            assert fault.mend
        assert len(set(error.faults)) == len(error.faults)
        return error.faults
    return []


@pytest.mark.slow
@settings(max_examples=150)
@given(damages)
def test_damaged_data(damages):
    told(lambda: kt.Model(**damaged(FULL, damages)))


@pytest.mark.slow
@settings(max_examples=100)
@given(damages)
def test_damaged_file(tmp_path_factory, damages):
    path = tmp_path_factory.getbasetemp() / "damaged.json"
    path.write_text(json.dumps(damaged(FULL, damages)))
    for fault in told(lambda: kt.read(path)):
        assert fault.line
        assert fault.column


@pytest.mark.slow
@settings(max_examples=60)
@given(damages)
def test_damage_over_a_library_model(tmp_path_factory, damages):
    path = tmp_path_factory.getbasetemp() / "over.json"
    over = {"library": {"name": "vgt.double_octahedral", "bays": 2, "tip_force": [0, 0, 46]}} | damaged(FULL, damages)
    path.write_text(json.dumps(over))
    for fault in told(lambda: kt.read(path)):
        assert fault.line
        assert fault.column


@pytest.mark.slow
@pytest.mark.parametrize("path", [path for path in PLACES if len(path) <= 2], ids=repr)
@pytest.mark.parametrize("what", [None, 5, "text", [[1]], {"kind": [], "file": 3}], ids=repr)
def test_each_table_and_entry(path, what):
    told(lambda: kt.Model(**damaged(FULL, [(path, what, "replace")])))
