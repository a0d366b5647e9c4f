"""What users read of an analysis at its solution: its variables, the mass of the model and mean stresses of bars."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import xarray as xr

from kinetruss.gradients.nearness import sites, sites_along
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.results import variable
from kinetruss.results.user_parts import users, users_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

    Floats = NDArray[np.float64]
    Terms = tuple[Floats, NDArray[np.int64]]


class Told(ABC):
    """The results of a `Point`. An analysis says its variables, and of sums their terms and where they are."""

    system: System
    unknown: Floats
    sums: ClassVar[Mapping[str, tuple[Callable[..., Any], str, str]]] = {}
    """Results that are sums, by name: the method for terms and sites at a system and unknowns, the unit, and words."""

    @abstractmethod
    def told(self, system: System, unknown: Floats) -> tuple[dict[str, Any], dict[str, Any]]:
        """The variables with other numbers and unknowns, and the names along their axes."""

    @cached_property
    def here(self) -> xr.Dataset:
        """The variables at the solution."""
        columns, coords = self.told(self.system, self.unknown)
        return xr.Dataset({name: one for name, one in columns.items() if name not in self.sums}, coords=coords)

    def data(self) -> xr.Dataset:
        """The results as users read them, with what follows from them for a design."""
        found = users(self.here)
        for name, (_, unit, words) in {**self.sums, "mass": (None, "kg", "mass of the model")}.items():
            terms = self.columns(self.system, self.unknown, (name,))[name]
            found[name] = variable((), np.asarray(terms.sum()), unit, words)
        if "member_force" in found:
            stress = self.columns(self.system, self.unknown, ("axial_stress",))["axial_stress"]
            found["axial_stress"] = variable(("member",), stress, "Pa", "axial force over the area")
        return found

    def columns(self, system: System, unknown: Floats, names: Sequence[str]) -> dict[str, Floats]:
        """The named results."""
        found = {"mass": mass_by_nodes(system)} if "mass" in names else {}
        found |= {name: self.sums[name][0](self, system, unknown)[0] for name in names if name in self.sums}
        if others := [name for name in names if name not in found]:
            data = self.told(system, unknown)[0]
            for name in others:
                if name == "axial_stress":
                    found[name] = (data["member_force"].values / system.area)[self.kept("member_force")]
                else:
                    found[name] = np.asarray(data[name].values[self.kept(name)])
        return found

    def sites(self, name: str) -> NDArray[np.int64]:
        """By the node, member or support of each value."""
        if name == "mass":
            return sites(self.system)["node"]
        if name in self.sums:
            return np.asarray(self.sums[name][0](self, self.system, self.unknown)[1])
        of = "member_force" if name == "axial_stress" else name
        return np.asarray(sites_along(self.system, self.here[of])[self.kept(of)])

    def kept(self, name: str) -> Any:
        """Where the values of a variable that users read are among all."""
        kept: dict[str, Any] = self.__dict__.setdefault("_kept", {})
        if name not in kept:
            kept[name] = users_of(self.here, name)
        return kept[name]
