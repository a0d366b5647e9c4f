"""The examples that come with the package."""

from __future__ import annotations

from pathlib import Path

__all__ = ["example_files"]

FOLDER = Path(__file__).parent / "examples"
MISSION = ".mission."
"""Part of the names of mission files, between the name of the model and the suffix."""


def example_files() -> dict[str, tuple[Path, ...]]:
    """Name of every example -> its files: the model file first, then its tables and missions."""
    found = {}
    for model in sorted(FOLDER.glob("*.yaml")):
        if MISSION in model.name:
            continue
        text = model.read_text(encoding="utf-8")
        tables = (table for table in sorted(FOLDER.glob("*.csv")) if table.name in text)
        found[model.stem] = (model, *tables, *sorted(FOLDER.glob(f"{model.stem}{MISSION}*")))
    return found
