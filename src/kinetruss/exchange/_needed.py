"""Packages of extras, imported when they are needed."""

from __future__ import annotations

import importlib
from typing import Any

from kinetruss.errors import InputError

__all__ = ["needed"]


def needed(package: str, extra: str) -> Any:
    """A package; InputError with the command that installs it if it is missing."""
    try:
        return importlib.import_module(package)
    except ImportError:
        raise InputError(f"This format needs the package {package}. Install it: pip install 'kinetruss[{extra}]'") from None
