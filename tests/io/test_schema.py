"""The shipped JSON Schema is that of the records, and allows what files may hold."""

import json
import re
from pathlib import Path

import pytest
import yaml
from jsonschema import Draft202012Validator

import kinetruss as kt
from kinetruss.io import schema, schema_file

FAULTY = Path(__file__).parents[1] / "data" / "faulty"
SCHEMA = schema()
JUDGE = Draft202012Validator(SCHEMA)


WHOLE = [("tag:yaml.org,2002:int", re.compile(r"[-+]?[0-9]+$"))]


def raw(path):
    """A file as an editor sees it: YAML 1.2, where no, on and 12:30 are text."""
    with path.open(encoding="utf-8") as file:
        loader = yaml.SafeLoader(file)
        loader.yaml_implicit_resolvers = {
            first: [(tag, rule) for tag, rule in rules if not tag.endswith((":timestamp", ":bool", ":int"))] + WHOLE
            for first, rules in loader.yaml_implicit_resolvers.items()
        }
        return loader.get_single_data()


def test_is_a_schema():
    Draft202012Validator.check_schema(SCHEMA)


def test_shipped_file_is_up_to_date():
    text = json.dumps(SCHEMA, indent=1, ensure_ascii=False) + "\n"
    assert schema_file().read_text(encoding="utf-8") == text, "write io.schema() into io.schema_file() again"


def test_every_field_of_every_record_is_described():
    """Editors show these words: those of the docstrings."""
    tube = SCHEMA["$defs"]["Tube"]["properties"]
    assert tube["outer"]["description"] == "diameters, m. Length: a number in m, or text with a unit"
    fields = {
        f"{name}.{field}": one
        for name, record in SCHEMA["$defs"].items()
        for field, one in record.get("properties", {}).items()
    }
    assert len(fields) > 400
    assert [name for name, one in fields.items() if not one.get("description") and not name.endswith(".kind")] == []


@pytest.mark.parametrize("name", kt.library.example_files())
def test_examples(name):
    assert list(JUDGE.iter_errors(raw(kt.library.example_files()[name][0]))) == []


@pytest.mark.parametrize(
    "part",
    [
        {"nodes": {"A": [0, "100 mm"], "B": {"at": ["1e3", 0], "coincident": True}}},
        {"bars": {"b": ["A", "B"], "c": {"ends": ["A", "B"], "rotary_inertia": "true"}}},
        {"fixed": ["A"]},
        {"fixed": {"A": "xy"}},
        {"section": "tube", "material": {"E": "71 GPa", "density": 2700}},
        {"loads": {"l": {"node": "A", "file": "l.csv"}, "m": {"node": "A", "force": [0, "1 kN"]}}},
        {"support_motion": {"A": {"file": "a.csv"}}},
        {"trajectories": {"t": {"kind": "spline", "file": "t.csv"}}},
        {"runs": {"r": {"trajectory": "t", "samples": "1e3"}}},
        {"links": {"l": ["A", "B", "A"]}},
        {"quantities": {"q": "length(l)"}},
        {"deflections": {"d": {"members": "b", "limit": "span/300"}, "e": {"members": ["b", "c"], "limit": 0.02}}},
        {"supports": {"A": {"x": "held", "y": "2 kN/mm", "rotation": {"stiffness": 3, "gap": [0, None]}}}},
        {"combinations": {"lifting": {"G": 1.35, "west": 1.5}}},
        {"combinations": {"kind": "en1990"}},
    ],
)
def test_short_forms(part):
    assert list(JUDGE.iter_errors({"nodes": {"A": [0, 0]}} | part)) == []


@pytest.mark.parametrize(
    "part",
    [
        {"nodes": {"A": [0]}},
        {"nodes": {"A B": [0, 0]}},
        {"nodes": {"A": [0, "no"]}},
        {"nodes": {"A": [0, "1,5 m"]}},
        {"bars": {"b": ["A"]}},
        {"bars": {"b": {"ends": ["A", "B"], "colour": "red"}}},
        {"section": {"outer": 1, "inner": 0}},
        {"section": {"kind": "tube", "outer": 1}},
        {"trajectories": {"t": {"kind": "spline"}}},
        {"fixed": {"A": "up"}},
        {"kinetruss": 2},
        {"materiel": "steel"},
    ],
)
def test_what_an_editor_marks(part):
    assert list(JUDGE.iter_errors({"nodes": {"A": [0, 0]}} | part))


def test_nodes_are_needed_unless_there_is_a_library_model():
    assert list(JUDGE.iter_errors({}))
    assert not list(
        JUDGE.iter_errors({"library": "vgt.triangular", "motors": {"motor": {"max_voltage": 9}}, "loads": {"a": None}})
    )
