"""The examples that come with the package."""

from __future__ import annotations

from pathlib import Path

__all__ = ["example_files"]

FOLDER = Path(__file__).parent / "examples"


def example_files() -> dict[str, tuple[Path, ...]]:
    """Name of every example -> its files: the model file first, then the tables it reads."""
    found = {}
    for model in sorted(FOLDER.glob("*.yaml")):
        text = model.read_text(encoding="utf-8")
        tables = (table for table in sorted(FOLDER.glob("*.csv")) if table.name in text)
        found[model.stem] = (model, *tables)
    return found
