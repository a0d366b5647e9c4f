"""The origin of a result."""

from __future__ import annotations

import hashlib
import platform
from functools import cache, lru_cache
from importlib.metadata import version
from typing import Any

from kinetruss.mechanics import ByIdentity
from kinetruss.model import Model

__all__ = ["model_hash", "provenance"]


def model_hash(model: Model) -> str:
    """SHA-256 of the whole model, first 16 hex digits."""
    return _hash(ByIdentity(model))


@lru_cache(maxsize=32)
def _hash(key: ByIdentity) -> str:
    # hashing a large model takes as long as a short motion of it
    return hashlib.sha256(key.model.model_dump_json().encode()).hexdigest()[:16]


@cache
def _versions() -> dict[str, str]:
    # read once: finding the versions takes as long as the section forces of a thousand samples
    found = {name: version(name) for name in ("kinetruss", "numpy", "numba")}
    return found | {"python": platform.python_version()}


def provenance(model: Model, **options: Any) -> dict[str, Any]:
    """Versions, model title and hash, and the options of a computation."""
    return {
        **_versions(),
        "title": model.title,
        "model": model_hash(model),
        **options,
    }
