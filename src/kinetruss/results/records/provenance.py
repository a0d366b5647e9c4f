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
    """SHA-256 of the whole model, first 16 hex digits.

    >>> import kinetruss as kt
    >>> light, same, heavy = (kt.library.vgt.triangular(payload_mass=mass) for mass in (10.0, 10.0, 20.0))
    >>> kt.results.model_hash(light) == kt.results.model_hash(same)
    True
    >>> kt.results.model_hash(light) == kt.results.model_hash(heavy)
    False
    """
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
    """Versions, model title and hash, and the options of a computation.

    >>> import kinetruss as kt
    >>> found = kt.results.provenance(kt.library.vgt.triangular(), samples=201)
    >>> found["title"], found["samples"], "kinetruss" in found
    ('Triangular variable-geometry truss', 201, True)
    """
    return {
        **_versions(),
        "title": model.title,
        "model": model_hash(model),
        **options,
    }
