"""Results along a motion by name, and what follows from them: stresses, utilisation, section forces, demands on drive trains.

Each is found of the states and row forces of any instants by the functions that users call.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.actuators.demands import AMPLIFIED, HISTORIES, ROTARY, columns_of
from kinetruss.dynamics.force_tables import force_arrays
from kinetruss.gradients.motion_rows import Prescribed, carried, holding
from kinetruss.kernels.structure.structure import LENGTH, States
from kinetruss.kinematics.motions import Course, motion_arrays
from kinetruss.kinematics.quantity_histories import quantities, quantities_apart
from kinetruss.mechanics import compile
from kinetruss.mechanics.beam_shapes import yielding_shapes
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.results import Forces, Motion, variable
from kinetruss.results.user_parts import HELD, MARKS
from kinetruss.strength import sections
from kinetruss.strength.parts import parts_of, twisted_parts
from kinetruss.strength.section_forces import fractions_of
from kinetruss.strength.utilisations import axes_of_verdict, utilised

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Column

    Floats = NDArray[np.float64]
    Columns = Mapping[str, Column]

VERDICT = ("utilisation", "stress", "compression")
SECTIONS = ("section_T", "section_V", "section_M", "torsion")
DEMAND = (*HISTORIES, *ROTARY, *AMPLIFIED)
LEFT_OUT = ("singularity",)
"""Variables of a motion that have no gradients."""


@dataclass(frozen=True, eq=False)
class Asked:
    """What is found along a motion. forces : whether, and judged : whether what follows from them; stations : of sections."""

    forces: bool = False
    judged: bool = False
    stations: int = 7


class Along(Mapping[str, Any]):
    """The variables along a motion, each with its axes; found when they are first read.

    motion, forces : of `model`; what follows is of these. rest (times, 3 n) : what is left at the nodes, N, of instants by
    themselves.
    """

    def __init__(self, model: Model, asked: Asked, motion: Motion, forces: Forces | None, rest: Floats | None = None) -> None:
        self.rest = rest
        self.model, self.asked, self.motion, self.forces = model, asked, motion, forces
        self.system = compile(model)

    @cached_property
    def _sources(self) -> dict[str, Callable[[], Columns]]:
        """By variable what finds it among others."""
        found: dict[str, Callable[[], Columns]] = {}
        for arrays in self._arrays:
            for name, own in arrays.items():
                if own.dims[:1] == ("time",) and own.values.dtype.kind == "f" and HELD not in own.dims and name not in LEFT_OUT:
                    found[name] = partial(dict, arrays)
        if self.asked.judged and self.forces is not None:
            found |= dict.fromkeys(VERDICT, lambda: self._verdict)
            found |= dict.fromkeys(SECTIONS if twisted_parts(self.model).any() else SECTIONS[:-1], lambda: self._sections)
            found |= dict.fromkeys(DEMAND if self.model.actuators else (), lambda: self._demand)
        found |= dict.fromkeys((name for name in self.model.quantities if name not in found), lambda: self._quantities)
        return found | {"mass": lambda: self._whole, "time": partial(dict, self.motion.arrays)}

    def __getitem__(self, name: str) -> Any:
        return self._sources[name]()[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._sources)

    def __len__(self) -> int:
        return len(self._sources)

    @cached_property
    def _whole(self) -> Columns:
        return {"mass": variable((), np.asarray(mass_by_nodes(self.system).sum()), "kg", "mass of the model")}

    @cached_property
    def _quantities(self) -> Columns:
        """Those that the model defines; angles count on along the whole motion alone."""
        apart = quantities_apart(self.model, self.motion, self.forces)
        if self.rest is not None:
            return apart
        whole = quantities(self.model, self.motion, forces=self.forces).value
        names = whole.coords["quantity"].values.tolist()
        return {name: one._replace(values=whole.values[:, names.index(name)]) for name, one in apart.items()}

    @cached_property
    def _verdict(self) -> Columns:
        given = utilised(self.model, self._judged).columns
        over, value = ("time", "part"), given["value"].values
        return {
            "utilisation": given["utilisation"],
            "stress": variable(over, value[:, :, 0], "Pa", "largest von Mises stress along the part"),
            "compression": variable(over, value[:, :, 1], "N", "largest compression along the part"),
        }

    @cached_property
    def _sections(self) -> Columns:
        given = sections(self.model, self._judged, self.asked.stations).arrays
        # other names than those of the parts of the verdict, and of the moments of interfaces
        axes = {"part": "rod", "moment": "about"}
        return {
            name: variable(tuple(axes.get(dim, dim) for dim in one.dims), one.values, one.attrs["units"], "")
            for name, one in given.items()
            if name in SECTIONS
        }

    @cached_property
    def _demand(self) -> Columns:
        given = columns_of(self.model, self.motion, self._judged)
        nothing = np.full(len(self.motion.arrays["time"].values), np.nan)
        units = HISTORIES | ROTARY | AMPLIFIED
        return {
            name: variable(("time", "active"), np.stack([one.get(name, nothing) for one in given], axis=1), *units[name])
            for name in DEMAND
        }

    @property
    def _judged(self) -> Forces:
        return cast("Forces", self.forces)

    def labels(self) -> dict[str, list[Any]]:
        """Names along the axes of these variables, with inner parts."""
        found = {name: one.values.tolist() for arrays in self._arrays for name, one in arrays.items() if one.dims == (name,)}
        if self.asked.judged and self.forces is not None:
            given = axes_of_verdict(self.system).names
            found |= {"part": [*given["part"]], "rule": [*given["rule"]], "rod": [*parts_of(self.model).names]}
            found |= {"active": list(self.model.actuators), "station": fractions_of(self.asked.stations).tolist()}
            found |= {"transverse": ["2", "3"][: self.model.dim - 1], "about": ["2", "3"][1 - self.model.dim :]}
        return found

    def units(self) -> dict[str, tuple[str, list[str]]]:
        """Units of entries along an axis, by the name that a variable has in place of its unit."""
        every = {name: one for arrays in self._arrays for name, one in arrays.items()}
        names = {one.attrs.get("units", "").partition("/")[0] for one in every.values()}
        return {name: (every[name].dims[0], every[name].values.tolist()) for name in names if name in every}

    @property
    def _arrays(self) -> list[Columns]:
        return [one.arrays for one in (self.motion, self.forces) if one is not None]

    def site(self, dim: str, node: NDArray[np.int64], member: NDArray[np.int64]) -> NDArray[np.int64] | None:
        """The node at which each entry along an axis is, from those of nodes and members; -1 unknown, None none."""
        system = self.system
        if dim in ("node", "member"):
            return node if dim == "node" else member
        names = self.labels().get(dim, [])
        place = {name: k for k, name in enumerate(system.members)}
        at = {**dict(zip(system.members, member.tolist(), strict=True)), **dict(zip(system.nodes, node.tolist(), strict=True))}
        if dim in ("part", "rod"):
            given = axes_of_verdict(system).names
            owner = dict(zip([*given["part"]], [*given["member"][1]], strict=True))
            owner |= dict(zip(parts_of(self.model).names, parts_of(self.model).members, strict=True))
            return np.array([member[place[owner[name]]] if owner[name] in place else -1 for name in names], np.int64)
        if dim in ("drive", "active"):
            bars = {name: getattr(drive, "bar", getattr(drive, "node", name)) for name, drive in self.model.all_drives.items()}
            return np.array([at.get(bars.get(name, name), -1) for name in names], np.int64)
        return np.array([at.get(name, -1) for name in names], np.int64) if dim in ("support",) else None

    def kept(self, name: str) -> Any:
        """Where what users read of a variable is in all of it, as an index."""
        marks = {axis: ~one[mark].values for one in self._arrays for axis, mark in MARKS.items() if mark in one}
        own = self[name]
        found = [
            np.flatnonzero(marks[dim]) if dim in marks else np.arange(size)
            for dim, size in zip(own.dims, own.values.shape, strict=True)
        ]
        return np.ix_(*found) if found else ()


def at_states(model: Model, asked: Asked, given: Prescribed, states: States, N: Floats, case: str | None) -> Along:
    """The variables of a model at states (s, 3 n) with forces N (s, rows) of the rows, of a load case."""
    system = compile(model)
    course = Course(t=given.t, x=states.x, v=states.v, a=states.a, drive=given.drive, attrs={"misfit": np.inf})
    arrays = motion_arrays(system, course, "given")
    rows = np.flatnonzero((system.row_drive >= 0) & (system.row_kind == LENGTH))
    for name, own in zip(("length", "length_rate", "length_acceleration"), given.drive, strict=True):
        # as prescribed, so that what stands still does so whatever the velocities of its ends
        arrays.columns[name].values[:, system.row_member[rows]] = own[:, system.row_drive[rows]]
    motion, forces, rest = Motion(data=arrays.later), None, np.zeros((len(given.t), system.x0.size))
    if asked.forces:
        loads, solved = carried(holding(system), given.t, case, states, N)
        if (held := yielding_shapes(system)) is not None:  # as `dynamics.inverse` tells it
            solved["joint"][:, held.chords] = 0.0
            solved |= {"N": N[:, : held.rows[0, 0]], "mode_force": held.mode_forces(N)}
        data = force_arrays(system, motion, loads, solved, at_rest=False)
        data.attrs.update({"at_rest": 0})
        forces, rest = Forces(data=data.later, motion=motion, load_case=loads.name), solved["rest"]
    return Along(model, asked, motion, forces, rest)
