"""Every field of a model with a unit reads the units that its schema, its messages and its own description offer."""

import importlib
import inspect
import pkgutil
import re
from typing import get_args

import pytest

import kinetruss as kt
from kinetruss.errors import UnitError
from kinetruss.model.record import Of, Record
from kinetruss.units import EITHER, QUANTITIES, dimension_of, parse, unit_of

PACKAGE = {f"kinetruss.model.{one.name}" for one in pkgutil.iter_modules(kt.model.__path__)}
for name in PACKAGE:  # also those that no other test has asked for yet
    importlib.import_module(name)
MIXED = {"rtol", "atol"}
"""Fields that one text describes together, in two units at once: plain numbers."""


def records(base=Record):
    """The records of the package; other tests of the same process have records of their own."""
    for one in base.__subclasses__():
        if one.__module__ in PACKAGE:
            yield one
        yield from records(one)


def quantities_of(*annotations):
    for one in annotations:
        if isinstance(one, Of):
            yield one.quantity
        yield from quantities_of(*get_args(one))


def fields():
    assert kt.Model  # the records are those that a model imports
    for record in sorted(set(records()), key=lambda one: one.__name__):
        for name, field in record.model_fields.items():
            for quantity in dict.fromkeys([*quantities_of(field.annotation), *quantities_of(*field.metadata)]):
                yield record, name, quantity


FIELDS = sorted({(record.__name__, name, quantity) for record, name, quantity in fields()})
USED = sorted({quantity for _, _, quantity in FIELDS})


def offered(quantity):
    """Units that the schema of a quantity names."""
    found = [one for one in re.split(r", or |, ", EITHER.get(quantity, unit_of(quantity))) if one]
    return [one for one in found if "what is measured" not in one]


@pytest.mark.parametrize("quantity", USED)
def test_the_units_that_schema_and_messages_offer_are_read(quantity):
    for unit in offered(quantity):
        assert parse(f"2.5 {unit}", quantity) == 2.5
    if quantity == "measure":  # has any unit
        assert parse("200 bar", quantity) == 200e5
        return
    with pytest.raises(UnitError) as caught:
        parse("1 V A s kg m", quantity)
    examples = re.findall(r"'(\d[^']*)'", str(caught.value).split(". ", 1)[1]) or re.findall(
        r"e\.g\. (\S+)\.$", str(caught.value)
    )
    assert examples
    for text in examples:
        parse(text, quantity)


def described(record, name):
    """What the description of a record says of a field."""
    text = " ".join((inspect.getdoc(record) or "").split())
    following = r"(?=[.;] \w+(?:, \w+)* : |$)"
    found = re.search(rf"\b{name}(?:, \w+)* : (.*?){following}", text)
    return found[1] if found else ""


def units_in(text):
    for piece in re.split(r"[,;.:()]| or | and ", text):
        try:
            dimension = dimension_of(piece.strip())
        except UnitError:
            continue
        if any(dimension):
            yield piece.strip(), dimension


def test_fields_whose_description_names_a_unit_read_it():
    """A number that is described in m, or in s/rad, must not refuse this unit."""
    refused = [
        (record.__name__, name, unit)
        for record, name, quantity in fields()
        if quantity == "number" and name not in MIXED
        for unit, _ in list(units_in(described(record, name)))[:1]
    ]
    # a fraction of the length, from the end at A; beside it stands a distance in m
    assert [one for one in refused if one != ("Gauge", "at", "m")] == []
    assert ("Stop", "damping") in {(record.__name__, name) for record, name, _ in fields() if described(record, name)}


LENGTH, TURN = kt.LengthDrive("strut"), kt.AngleDrive("strut")
SPRING = {
    "stiffness": ("2 N/m", "2 N m/rad"),
    "rest": ("2 m", "2 rad"),
    "damping": ("2 N s/m", "2 N m s/rad"),
    "friction": ("2 N", "2 N m"),
    "slip": ("2 m/s", "2 rad/s"),
    "play": ("2 m", "2 rad"),
    "preload": ("2 N", "2 N m"),
}
STOP = {
    "lower": ("-2 m", "-2 rad"),
    "upper": ("2 m", "2 rad"),
    "stiffness": SPRING["stiffness"],
    "damping": ("2 s/m", "2 s/rad"),
}
SUPPORT = {"stiffness": SPRING["stiffness"], "damping": SPRING["damping"], "settlement": ("2 m", "2 rad")}


def test_elements_on_coordinates_take_the_units_of_their_coordinate_and_no_others():
    cases = [(kt.Spring, {"stiffness": 1.0}, SPRING), (kt.Stop, {"lower": 0.0, "stiffness": 1.0}, STOP)]
    for record, needed, units in cases:
        assert set(units) == set(record.plain)
        for name, both in units.items():
            for k, coordinate in enumerate((LENGTH, TURN)):
                assert abs(getattr(record(coordinate=coordinate, **(needed | {name: both[k]})), name)) == 2.0
                with pytest.raises(kt.ModelError, match=rf"{name} has the unit of {('an angle', 'a length')[k]}\. Use"):
                    record(coordinate=coordinate, **(needed | {name: both[1 - k]}))
    for name, both in SUPPORT.items():
        for k, axis in enumerate(("x", "rotation")):
            given = {"stiffness": 1.0} if name == "damping" else {}
            assert getattr(getattr(kt.Support(**{axis: given | {name: both[k]}}), axis), name) == 2.0
            with pytest.raises(kt.ModelError, match=f"{name} is not that of a"):
                kt.Support(**{axis: given | {name: both[1 - k]}})


def test_the_sum_of_a_coupling_has_the_unit_of_its_coordinates(tmp_path):
    """Two gears that begin with 30 degrees between them; the file says so, and reads back."""
    gears = {"nodes": {"A": (0, 0), "B": (0.1, 0), "C": (1, 0), "D": (1, 0.1)}, "fixed": ["A", "C"]}
    gears |= {"bars": {"one": ("A", "B"), "other": ("C", "D")}}
    terms = ((kt.AngleDrive("one"), 1.0), (kt.AngleDrive("other"), 1.0))
    model = kt.Model(**gears, couplings={"mesh": kt.Coupling(terms=terms, value="90 deg")})
    assert model.couplings["mesh"].value == pytest.approx(1.5707963267948966)
    path = tmp_path / "gears.yaml"
    kt.write(model, path)
    assert kt.read(path).couplings == model.couplings
    with pytest.raises(kt.ModelError, match=r"value has the unit of a length\. Use rad or deg"):
        kt.Coupling(terms=terms, value="90 mm")
    screw = ((LENGTH, 1.0), (TURN, -0.005))
    assert kt.Coupling(terms=screw, value="3 mm").value == pytest.approx(0.003)


def test_every_quantity_of_the_fields_is_known():
    assert set(USED) <= set(QUANTITIES)
    assert len(FIELDS) > 200
