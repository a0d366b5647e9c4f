"""The examples that come with the package."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parent / "examples"
SCHEMA = "# yaml-language-server: $schema="
"""Start of the first line of every example: editors complete and check the file by the schema that it names."""


def example_files() -> dict[str, tuple[Path, ...]]:
    """Name of every example -> its files: the model file first, then its tables and its companions, NAME.WHAT.yaml beside
    NAME.yaml: a mission, the task of an optimum, a study.

    >>> import kinetruss as kt
    >>> [file.name for file in kt.library.example_files()["double_octahedral_slew"]]
    ['double_octahedral_slew.yaml', 'double_octahedral_slew.mission.yaml', 'double_octahedral_slew.optimum.yaml']
    """
    found = {}
    for model in sorted(FOLDER.glob("*.yaml")):
        if "." in model.stem:
            continue
        text = model.read_text(encoding="utf-8")
        tables = (table for table in sorted(FOLDER.glob("*.csv")) if table.name in text)
        found[model.stem] = (model, *tables, *sorted(FOLDER.glob(f"{model.stem}.*.yaml")))
    return found


def example_text(file: Path) -> str:
    """Text of a file of an example, for a copy in another folder: its first line names the schema by its full address.

    >>> first = example_text(example_files()["four_bar"][0]).splitlines()[0]
    >>> first.startswith("# yaml-language-server: $schema=file:///") and first.endswith("/kinetruss.schema.json")
    True
    """
    text = file.read_text(encoding="utf-8")
    first, _, rest = text.partition("\n")
    if not first.startswith(SCHEMA):
        return text
    return f"{SCHEMA}{(FOLDER / first.removeprefix(SCHEMA)).resolve().as_uri()}\n{rest}"
