"""Stored reference values, shipped with the package."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any

__all__ = ["load"]


def load(name: str) -> dict[str, Any]:
    """The data file `name`, e.g. ``"triangle"``; every file has a ``source``."""
    text = (files("kinetruss.verification") / "data" / f"{name}.json").read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data
