"""Tables of records are read-only, so that nothing changes a model behind its checks; else they are dictionaries."""

import copy
import json
import pickle

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.model import ReadOnly, Record

EXAMPLES = [kt.read(paths[0]) for paths in kt.library.example_files().values()]

CHANGES = {
    "set": lambda table: table.__setitem__("A", 1),
    "delete": lambda table: table.__delitem__("A"),
    "pop": lambda table: table.pop("A", None),
    "popitem": lambda table: table.popitem(),
    "clear": lambda table: table.clear(),
    "update": lambda table: table.update(A=1),
    "setdefault": lambda table: table.setdefault("Z", 1),
    "or": lambda table: table.__ior__({"A": 1}),
}


def parts(value):
    """Everything in a record, to any depth."""
    yield value
    if isinstance(value, Record):
        below = [getattr(value, name) for name in type(value).model_fields]
    elif isinstance(value, dict):
        below = list(value.values())
    else:
        below = list(value) if isinstance(value, (list, tuple, set, frozenset)) else []
    for one in below:
        yield from parts(one)


@pytest.mark.parametrize("model", EXAMPLES, ids=lambda model: model.title[:30])
def test_nothing_in_a_model_can_be_changed(model):
    for part in [*parts(model), model.members, model.all_drives, model.actuators]:
        assert not isinstance(part, (list, set, bytearray))
        if isinstance(part, np.ndarray):
            assert not part.flags.writeable
        if isinstance(part, dict):
            assert isinstance(part, ReadOnly)
        if isinstance(part, Record):
            name = next(iter(type(part).model_fields))
            with pytest.raises(kt.FrozenError, match="with_"):
                setattr(part, name, getattr(part, name))
            with pytest.raises(kt.FrozenError, match="with_"):
                delattr(part, name)


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_changes_are_refused_and_leave_the_table(change):
    model = EXAMPLES[0]
    before = dict(model.nodes)
    with pytest.raises(kt.FrozenError, match=r"model\.with_"):
        change(model.nodes)
    assert model.nodes == before


@pytest.mark.slow
@pytest.mark.parametrize("model", EXAMPLES, ids=lambda model: model.title[:30])
def test_copies_are_equal_and_read_only(model, tmp_path):
    copies = [
        copy.copy(model), copy.deepcopy(model), pickle.loads(pickle.dumps(model)), model.model_copy(deep=True),
        model.with_(), kt.Model.model_validate_json(model.model_dump_json()), kt.Model(**model.model_dump()),
        kt.read(kt.write(model, tmp_path / "one.yaml")), kt.read(kt.write(model, tmp_path / "one.json")),
    ]  # fmt: skip
    for one in copies:
        assert one == model
        assert isinstance(one.nodes, ReadOnly)


def test_a_table_is_a_dictionary_otherwise():
    fixed = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"]).fixed
    assert fixed == {"A": "xy"}
    assert fixed == {"A": "xy"}
    assert type(fixed | {"B": "x"}) is type(dict(fixed)) is type(fixed.copy()) is dict
    assert json.dumps(fixed) == '{"A": "xy"}'
    assert repr(fixed) == "{'A': 'xy'}"


def test_long_tables_are_printed_short():
    nodes = {f"N{k}": (float(k), 0.0) for k in range(1000)}
    model = kt.Model(nodes=nodes, bars={"b": ("N0", "N1")}, fixed=["N0"])
    assert len(repr(model.nodes)) < 500
    assert repr(model.nodes).endswith("... 1,000 in all}")


def test_long_lists_are_printed_in_short():
    times = np.arange(2001.0)
    for long in (
        kt.Spline(times=times, values={"motor": times}),
        kt.Measured(times=times, values={"motor": times}, rates={"motor": times}),
        kt.TableInput(times=times, voltages=times),
        kt.NodalForce(node="A", times=times, forces=np.zeros((2001, 2))),
        kt.History(times=times, displacements=np.zeros((2001, 2))),
    ):
        assert "times=(0.0, 1.0, 2.0, ..., 2000.0; 2,001 in all)" in repr(long)
        assert len(repr(long)) < 250
    short = kt.Spline(times=times[:12], values={"motor": times[:12]})
    assert repr(short) == f"Spline(times={tuple(times[:12].tolist())}, values={{'motor': {tuple(times[:12].tolist())}}})"


def test_a_copy_with_an_update_is_checked():
    model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"])
    assert model.members["b"].mass is None
    longer = model.model_copy(update={"bars": {"b": kt.Bar(ends=("A", "B"), mass=2.0)}})
    assert longer.members["b"].mass == 2.0
    with pytest.raises(kt.ModelError, match="no node called 'C'"):
        model.model_copy(update={"bars": {"b": ("A", "C")}})
