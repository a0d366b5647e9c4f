"""Utilisation of the members of a structure by the forces of the stiffness method, as a run of `statics.linear` finds it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, few
from kinetruss.gradients.nearness import sites
from kinetruss.mechanics import System
from kinetruss.mechanics.system import standing_for
from kinetruss.runs.at_rest import acting_between, forces_of_linear, resting
from kinetruss.statics import Linear
from kinetruss.strength.utilisations import axes_of_verdict, utilised

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def utilisation(system: System, told: tuple[dict[str, Any], dict[str, Any]], case: str | None) -> Floats:
    """Utilisation (parts, rules) by the variables of `statics.linear`.

    Raises
    ------
    AnalysisError : what else acts on members, between their joints.
    """
    if others := acting_between(system, [case or "all"]):
        raise AnalysisError(f"Section forces are not computed: {few(sorted(others), 4)} on members, between their joints.")
    model = standing_for(system)
    place = system.x0[: len(model.whole.nodes), : system.dim]
    found = Linear(data=xr.Dataset(told[0], coords=told[1]), provenance={})
    forces = forces_of_linear(model, found, resting(model, place), case or "all")
    return np.asarray(utilised(model, forces).columns["utilisation"].values[0])


def judged_axes(system: System) -> dict[str, list[str]]:
    """Names of parts and rules."""
    names = axes_of_verdict(system).names
    return {"part": [*map(str, names["part"])], "rule": [*map(str, names["rule"])]}


def judged_sites(system: System) -> NDArray[np.int64]:
    """The node (parts, rules) at which each member is, -1 unknown."""
    names, at = axes_of_verdict(system).names, dict(zip(system.members, sites(system)["member"].tolist(), strict=True))
    own = np.array([at.get(str(name), -1) for name in names["member"][1]], np.int64)
    return np.repeat(own[:, None], len(names["rule"]), axis=1)
