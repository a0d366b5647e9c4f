"""The model reference: every table of a model in YAML and in Python, and the fields of its records."""

import inspect
import re
import typing
from collections.abc import Iterator
from pathlib import Path

import yaml
from api import text_of

import kinetruss as kt
from kinetruss.model import Record, drives, field_texts, joints, record as types, references
from kinetruss.model.data import ModelData
from kinetruss.units import unit_of

SOURCE = yaml.safe_load((Path(__file__).parent / "tables.yaml").read_text("utf-8"))
INTRODUCTION = """# Model reference

Every table of a model file, with the same in Python. `kt.read(FILE)` reads a file; `kinetruss check FILE` lists all its faults.
In Python, tables are arguments of `kt.Model`. Numbers without a unit are SI; text may have a unit, in Python too (`"100 mm"`).
A name of a section, material, screw, gear, motor or amplifier refers to the model's own table, or to the library.
"""


def pages(made: Path) -> Iterator[tuple[str, str]]:
    """The one page."""
    lines = [INTRODUCTION]
    shown: set[type[Record]] = set()
    hints = typing.get_type_hints(ModelData, include_extras=True)
    for table, field in ModelData.model_fields.items():
        if table == "kinetruss":
            continue
        lines += [f"## {table}", "", field.description or "", ""]
        if (example := SOURCE["tables"].get(table)) and example["yaml"]:
            lines += _beside(table, example, made)
        own = list(dict.fromkeys(_records(hints[table])))
        for record in own:
            lines += _record(record) if record not in shown else []
        if again := [f"[{one.__name__}](#{one.__name__.lower()})" for one in own if one in shown]:
            lines += [f"Its records are described above: {', '.join(again)}.", ""]
        shown |= set(own)
    yield "model_reference.md", "\n".join(lines)


def model_of(table: str, folder: Path) -> kt.Model:
    """The model in which the example of a table stands."""
    example = SOURCE["tables"][table]
    data = {"kinetruss": 1, **SOURCE["bases"][example["in"]], **yaml.safe_load(example["yaml"])}
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{table}.yaml"
    file.write_text(yaml.safe_dump(data, sort_keys=False), "utf-8")
    return kt.read(file)


def _beside(table: str, example: dict, made: Path) -> list[str]:
    """YAML and Python in two columns."""
    model = model_of(table, made / "models")
    given = yaml.safe_load(example["yaml"])
    parts = [_python(key, getattr(model, key), given[key]) for key in given]
    return ["::::{grid} 1 1 2 2", ":gutter: 2", ":::{grid-item}", "```yaml", example["yaml"], "```", ":::", ":::{grid-item}",
            "```python", *parts, "```", ":::", "::::", ""]  # fmt: skip


def _python(key: str, value: object, given: object) -> str:
    if isinstance(value, dict):
        names = given if isinstance(given, (dict, list)) else value
        inner = ",\n".join(f'    "{name}": {_called(value[name])}' for name in names)
        return f"{key}={{\n{inner},\n}}"
    return f"{key}={_called(value)}"


def _called(value: object) -> str:
    """A record as it is written in Python: with `kt.` before every noun."""
    return re.sub(r"\b([A-Z]\w+)\(", r"kt.\1(", repr(value)).replace("'", '"')


def _records(hint: object) -> Iterator[type[Record]]:
    if isinstance(hint, type) and issubclass(hint, Record):
        yield hint
    for part in typing.get_args(hint):
        yield from _records(part)


def _record(record: type[Record]) -> list[str]:
    words = {"kind": "chooses this record"} | field_texts(record)
    lines = [
        f"### {record.__name__}",
        "",
        *text_of(_head(record)),
        "",
        "| field | type | default | meaning |",
        "|---|---|---|---|",
    ]
    for name, parameter in record.__signature__.parameters.items():
        default = (
            "required"
            if parameter.default is parameter.empty
            else f"`{parameter.default!r}`"
            if parameter.default not in (None, ())
            else ""
        )
        kind = _kind(str(parameter.annotation)).replace("|", "\\|")
        said = words.get(name, "").replace("|", "\\|")
        lines.append(f"| `{name}` | {kind} | {default} | {said} |")
    return [*lines, ""]


WORDS = {
    "Flag": "true or false", "Name": "name", "Nodes": "list of node names", "str": "text", "Whole": "whole number",
    "Point": "coordinates (m)", "Vector": "vector", "ForceVector": "vector (N)", "GravityVector": "vector (m/s^2)",
    "_Moment": "moment (N m)", "_Stress": "stress (Pa)", "_Times": "list of times (s)", "Direction": "x, y, z or a vector",
    "Axis": "vector", "Shape": "`spline`, `monotone`", "Points": "pairs of numbers",
    "Moves": "coordinate → two values (m or rad)",
    "RotaryFrictions": "one or two numbers (N m s)", "InertiaTensor": "number, three numbers or matrix (kg m^2)",
    "Spin": "number or vector (rad/s)", "SpinRate": "number or vector (rad/s^2)", "Offset": "vector (m)",
    "HingeAxis": "1, 2, 3 or a vector", "EndCondition": "word or number", "Measured": "coordinate", "Analysis": "word",
}  # fmt: skip
"""Names of types that are no records -> words."""
TYPES = (types, references, drives, joints)
"""Modules with types of fields that hold quantities and names."""
MOVES = "dict[CoordinateName, tuple[Coordinate, Coordinate]]"


def _kind(annotation: str) -> str:
    """A type in words: quantities with their unit in place of the names of types."""
    if annotation.startswith("Literal["):
        return ", ".join(f"`{word}`" for word in re.findall(r"'([^']*)'", annotation))
    text = annotation.replace(" | None", "").replace("Literal[1, 2, 3]", "1, 2, 3").replace(MOVES, "Moves")
    text = re.sub(r"([A-Z]\w+) \| Name\b", r"\1OrName", text)
    text = re.sub(r"\w+", lambda found: _quantity(found[0]), text)
    before = ""
    while text != before:  # from the inside out
        before = text
        text = re.sub(r"tuple\[([\w ]*\bname), \.\.\.\]", r"list of \1s", text)
        text = re.sub(r"tuple\[([^\[\]]*?), \.\.\.\]", r"list of \1", text)
        text = re.sub(r"tuple\[([^\[\]]*)\]", r"(\1)", text)
        text = re.sub(r"dict\[([\w ]*), ([^\[\]]*)\]", r"\1 → \2", text)
    return text.replace(" | ", " or ")


def _quantity(word: str) -> str:
    for one in (mark for module in TYPES for mark in getattr(getattr(module, word, None), "__metadata__", ())):
        if isinstance(one, types.Of):
            unit = unit_of(one.quantity)
            return f"{one.quantity} ({unit})" if unit else one.quantity
        if isinstance(one, references.Ref):
            name = one.word if one.word.endswith("coordinate") else f"{one.word} name"
            return " or ".join([name, *(f"`{other}`" for other in one.also)])
    if word.endswith("OrName"):
        return f"{word.removesuffix('OrName').lower()} or its name"
    return WORDS.get(word, word)


def _head(record: type[Record]) -> str:
    """The docstring without its lists of fields and its examples."""
    field = re.compile(rf"(?m)(?:^|[.;:] )(?:{'|'.join(record.model_fields)})(?:, \\w+)* : ")
    blocks = re.split(r"\n[ \t]*\n", inspect.getdoc(record) or "")
    return "\n\n".join(block for block in blocks if not field.search(block) and not block.startswith(">>>"))
