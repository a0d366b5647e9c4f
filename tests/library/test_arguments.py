"""Every builder of the library and every record refuses what it does not know, by an error that names the nearest."""

import inspect

import pytest

import kinetruss as kt
from kinetruss.errors import ArgumentError, KinetrussError
from kinetruss.model import Record

PARTS = ("joints", "bodies", "meshes", "vgt", "mechanisms")
FUNCTIONS = {
    f"{part}.{name}": one
    for part in PARTS
    for name, one in vars(getattr(kt.library, part)).items()
    if inspect.isfunction(one) and name in getattr(kt.library, part).__all__
}
RECORDS = [name for name in dir(kt) if isinstance(getattr(kt, name), type) and issubclass(getattr(kt, name), Record)]


def needed(function):
    """Stand-ins for the arguments that have no default."""
    kinds = (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)
    given = inspect.signature(function).parameters.items()
    return {name: None for name, one in given if one.default is inspect.Parameter.empty and one.kind not in kinds}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_unknown_and_missing_arguments_of_builders(name):
    function = FUNCTIONS[name]
    parameters = inspect.signature(function).parameters
    if not any(one.kind is one.VAR_KEYWORD for one in parameters.values()):
        with pytest.raises(ArgumentError, match="'no_such_argument' is not known here"):
            function(**needed(function), no_such_argument=1)
        last = list(parameters)[-1]
        if parameters[last].kind is not inspect.Parameter.VAR_POSITIONAL:
            with pytest.raises(ArgumentError, match=f"Did you mean .*{last!r}"):
                function(**{key: value for key, value in needed(function).items() if key != last}, **{f"{last}_": 1})
    if needed(function):
        with pytest.raises(ArgumentError):
            function()


def test_what_is_passed_on_is_checked_as_well():
    model = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    with pytest.raises(ArgumentError, match="'masss' is not known here. Did you mean 'mass'"):
        kt.library.bodies.box(model, "crate", (1, 2, 3), masss=1.0)
    with pytest.raises(ArgumentError, match="'payload' is not known here. Did you mean 'payload_mass'"):
        kt.library.vgt.double_octahedral(payload=3.0)


@pytest.mark.parametrize("name", RECORDS)
def test_unknown_fields_of_records(name):
    with pytest.raises(KinetrussError, match="'no_such_field' is not known here"):
        getattr(kt, name)(no_such_field=1)
    with pytest.raises(KinetrussError):
        getattr(kt, name)(*["A"] * 9)


def test_a_field_given_twice():
    with pytest.raises(ArgumentError, match="'bar' is given twice"):
        kt.AngleDrive("crank", bar="rocker")
