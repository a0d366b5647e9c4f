"""Drawings as the studio has them, without a network."""

from __future__ import annotations

from pathlib import Path

from kinetruss.model import Model
from kinetruss.studio import Session
from kinetruss.studio.files import Drafts


def drawing(model: Model | None = None, file: Path | None = None, folder: Path | None = None, dim: int = 2) -> Session:
    """The drawing of a file of a folder, in a studio that has just been started."""
    text = "" if file is None else file.read_text(encoding="utf-8")
    drafts = None if folder is None else Drafts(folder, "untitled" if file is None else file.stem)
    return Session(model, file, folder, text=text, dim=dim, draw=True, drafts=drafts)
