"""Ready-made trusses and mechanisms, materials, sections, drive trains; examples. The parts are imported at first use."""

from __future__ import annotations

from kinetruss.late import late

__all__ = [
    "bodies",
    "build",
    "builders",
    "cells",
    "drives",
    "example_files",
    "example_text",
    "joints",
    "materials",
    "mechanisms",
    "meshes",
    "sections",
    "vgt",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "_build": "build builders",
        "_examples": "example_files example_text",
    },
    modules="bodies cells drives joints materials mechanisms meshes sections vgt",
)
