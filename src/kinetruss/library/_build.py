"""A library model by name, for model files."""

from __future__ import annotations

import importlib
from difflib import get_close_matches
from typing import Any

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.library._arguments import own_arguments
from kinetruss.library._builder import BUILDERS
from kinetruss.model import Model, Record

__all__ = ["build", "builders"]

MODULES = ("cells", "mechanisms", "vgt")


def builders() -> dict[str, type[Record]]:
    """Names of all library models (``vgt.double_octahedral``) with the record that checks their parameters.

    >>> import kinetruss as kt
    >>> builders = kt.library.builders()
    >>> "vgt.triangular" in builders, "payload_mass" in builders["vgt.triangular"].model_fields
    (True, True)
    """
    for module in MODULES:
        importlib.import_module(f"kinetruss.library.{module}")
    return {name: record for name, (_, record) in sorted(BUILDERS.items())}


@own_arguments
def build(name: str, parameters: dict[str, Any] | None = None) -> Model:
    """Build a library model from parameters that may be text with units.

    Parameters
    ----------
    name : ``module.function``, e.g. ``vgt.double_octahedral``.
    parameters : arguments of the function by name.

    Raises
    ------
    ModelError : an unknown name, or faults of the parameters; the path of each fault starts with the parameter.

    Examples
    --------
    >>> build("vgt.double_octahedral", {"bays": 2, "longeron": "35 in"}).title
    'Double-octahedral truss, 2 bays'
    """
    known = builders()
    if name not in known:
        near = get_close_matches(name[:200], known, n=1)
        offer = f"Did you mean {near[0]!r}?" if near else f"There are: {', '.join(known)}."
        raise ModelError([Fault(("name",), f"no library model called {shown(name)}.", offer)])
    function = BUILDERS[name][0]
    record = known[name](**(parameters or {}))
    return function(**{key: getattr(record, key) for key in record.model_fields_set})
