"""What help and a console show of records and results is short and says what there is."""

from __future__ import annotations

import inspect
import pydoc
import re

import pytest
from pydantic import BaseModel

import kinetruss as kt

RECORDS = [one for name in dir(kt) if inspect.isclass(one := getattr(kt, name)) and issubclass(one, BaseModel)]


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.__name__)
def test_signatures_name_every_field_with_a_short_type(record):
    found = inspect.signature(record)
    assert set(found.parameters) == set(record.model_fields)
    assert len(str(found)) <= max(750, 37 * len(found.parameters))  # a line and a half for six fields
    for name, one in found.parameters.items():
        assert not re.search(r"Annotated|Filled|Table|Moves|OrName", one.annotation)
        assert one.annotation.count("[") == one.annotation.count("]")
        assert (one.default is inspect.Parameter.empty) == record.model_fields[name].is_required()


def test_help_shows_a_trajectory_and_how_it_is_written():
    for name in ("Quintic", "Trapezoid", "ConstantRate", "Sine", "Cyclic", "StepResponse", "Spline"):
        assert f">>> kt.{name}(" in inspect.getdoc(getattr(kt, name))
    text = pydoc.plain(pydoc.render_doc(kt.ConstantRate))
    assert "rates: 'dict[CoordinateName, Rate]'" in text


def test_signatures_bind_like_calls():
    assert inspect.signature(kt.LengthDrive).bind("M7").arguments == {"bar": "M7"}
    with pytest.raises(TypeError):
        inspect.signature(kt.Bar).bind("A", "B")


def test_a_result_is_shown_by_its_arrays():
    model = kt.library.mechanisms.four_bar()
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 1.0}, duration=1.0), samples=11)
    forces = kt.dynamics.inverse(model, motion)
    for result in (
        motion,
        forces,
        kt.strength.check(model, forces),
        kt.dynamics.linearise(kt.library.mechanisms.pendulum(angle=0.0)),
    ):
        lines = repr(result).splitlines()
        assert lines[0] == f"{type(result).__name__}: {result.status.value} {result.message}".rstrip()[:300]
        assert [line.split()[0] for line in lines[1:] if "highest:" not in line] == [
            str(name) for name in result.data.data_vars
        ]
        assert len(repr(result)) < 2500
    assert "  reaction        (time: 11, support: 2, axis: 2)         N" in repr(forces).splitlines()


def test_a_long_message_is_cut():
    motion = kt.kinematics.follow(
        kt.library.mechanisms.four_bar(), kt.ConstantRate(rates={"motor": 1.0}, duration=1.0), samples=2
    )
    first = repr(motion.with_(message="x" * 5000)).splitlines()[0]
    assert len(first) == 300 and first.endswith("...")
