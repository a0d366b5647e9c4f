"""Drawings as the studio has them, without a network, and the motions that they play."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from kinetruss.model import Model
from kinetruss.studio import Session
from kinetruss.studio.files import Drafts


def drawing(model: Model | None = None, file: Path | None = None, folder: Path | None = None, dim: int = 2) -> Session:
    """The drawing of a file of a folder, in a studio that has just been started."""
    text = "" if file is None else file.read_text(encoding="utf-8")
    drafts = None if folder is None else Drafts(folder, "untitled" if file is None else file.stem)
    return Session(model, file, folder, text=text, dim=dim, draw=True, drafts=drafts)


def asked(session: Session, **message: Any) -> bytes | dict[str, Any]:
    """The answer to a message; of a motion once it is computed."""
    answer = session.answer(json.dumps(message))
    while isinstance(answer, dict) and answer["kind"] == "computing":
        answer = session.answer(json.dumps({"do": "motion", "number": answer["number"]}))
    return answer


def unpacked(answer: bytes) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Header and arrays of a motion."""
    size = int.from_bytes(answer[:4], "little")
    header, at, found = json.loads(answer[4 : 4 + size]), 4 + size, {}
    for name, shape in header["arrays"].items():
        found[name] = np.frombuffer(answer, "<f4", math.prod(shape), at).reshape(shape)
        at += found[name].nbytes
    assert at == len(answer)
    return header, found
