"""Many variants of a small mechanism in one sweep: copies beside each other in one model, each with its own numbers.

A kernel takes each block of a structure by itself, so that copies that share nothing but time cost what they cost alone; the
calls around the kernels are made once for all. The model of the copies is compiled once. Variants are numbers of its tables,
found by their paths (`gradients.varied`). It is for mechanisms of nodes, bars, active members, loads on nodes and drives in a
prescribed motion, of which forces are kept; every variant is still checked as a model. Others are done one after the other.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from kinetruss.dynamics.prepared import PreparedModel
from kinetruss.errors import InputError
from kinetruss.gradients.varied import varied
from kinetruss.io.values import resolved
from kinetruss.kinematics.sampling import start_values
from kinetruss.mechanics import arrange, compile
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.model import ConstantRate, Cyclic, Model, Quintic, Sine, Trapezoid
from kinetruss.model.references import names_in
from kinetruss.runs.plans import plan
from kinetruss.runs.results import RunResult
from kinetruss.studies.brief_runs import run_of_arrays
from kinetruss.threads import one_thread

COPIES = 64
MOST = 400
"""Most members of all copies together: the plan of a structure takes longer than in proportion to them."""
OWN = ("nodes", "bars", "active", "sections", "materials", "loads", "drives")
"""Tables of which each copy has its own."""
SHARED = (
    "kinetruss", "title", "fixed", "section", "material", "screws", "gears", "motors", "gravity", "trajectories", "runs",
    "safety", "report",
)  # fmt: skip
"""What else such a model may have."""
LAWS = (Quintic, Trapezoid, ConstantRate, Sine, Cyclic)
"""Trajectories that all copies can follow together."""
NEAR = 1e-6
"""Relative change by which is found whether the start of a drive depends on a value."""


class Copies:
    """Copies of a mechanism beside each other.

    model : one alone. paths : of its values that change.

    Raises
    ------
    InputError, ModelError : it cannot be done in this way.
    """

    def __init__(self, model: Model, run: str, paths: Sequence[str]) -> None:
        job = plan(model, run)
        law, alone = job.run.trajectory, compile(model)
        known = job.run.analysis == "dynamics.inverse" and isinstance(law, LAWS) and job.given is None and job.condition is None
        plain = job.cases == (None,) and len(job.times) <= job.block and not alone.inner.nodes
        if not known or not plain or len(arrange(alone).redundant):
            raise InputError("This is no prescribed motion of a plain mechanism under one load case.")
        if other := [name for name in type(model).model_fields if name not in (*OWN, *SHARED) and getattr(model, name)]:
            raise InputError(f"The model has {', '.join(other)}.")
        self.run, self.times = run, job.times
        self.count = max(2, min(COPIES, MOST // max(1, len(alone.members))))
        self.keys = [resolved(model, path) for path in paths]
        if wrong := [path for path, keys in zip(paths, self.keys, strict=True) if keys[0] not in OWN]:
            raise InputError(f"{wrong[0]} is no value of a part.")
        self.value = np.array([_number(model, keys) for keys in self.keys])
        self.whole, self.trajectory = side_by_side(model, law, self.count)
        self.varied = varied(self.whole, [_named(keys, k) for k in range(self.count) for keys in self.keys])
        if any((slope != 1.0).any() for _, _, slope in self.varied.places.values()):
            raise InputError("A value is not a number of the tables as it stands.")
        moved = self.varied.model_at(NEAR * self.varied.scale)
        if start_values(moved) != start_values(self.whole):
            raise InputError("A value changes where a drive begins.")
        system = compile(self.whole)
        self.place = [
            np.array([[names.index(f"{_mark(k)}{name}") for name in own] for k in range(self.count)], int)
            for names, own in (
                (system.nodes, alone.nodes),
                (system.members, alone.members),
                (system.drives, alone.drives),
            )
        ]

    @one_thread
    def runs(self, models: Sequence[Model]) -> list[tuple[RunResult, float]] | None:
        """The run and the mass, kg, of each of up to `count` variants; None if not all of them are complete."""
        change = np.zeros((self.count, len(self.keys)))
        for k, model in enumerate(models):
            change[k] = [_number(model, keys) for keys in self.keys] - self.value
        system = self.varied.changed(change.reshape(-1))
        ready = PreparedModel(self.whole, None, system)
        places = ready.follow(self.trajectory, times=self.times)
        if not places.status.ok or len(places.t) < len(self.times):
            return None
        forces, mass = ready.forces(places), mass_by_nodes(system)
        if forces.not_unique.any():
            return None
        found = []
        for k, model in enumerate(models):
            node, member, drive = (place[k] for place in self.place)
            cut = places._replace(
                **{name: getattr(places, name)[:, node] for name in ("position", "velocity", "acceleration")},
                **{name: getattr(places, name)[:, drive] for name in ("drive_position", "drive_velocity")},
            )
            carried = {"all": (forces.member_force[:, member], forces.drive_force[:, drive])}
            found.append((run_of_arrays(model, self.run, cut, carried), float(mass[node].sum())))
        return found


def side_by_side(model: Model, trajectory: Any, count: int) -> tuple[Model, Any]:
    """Copies of a model beside each other, as one model, and the trajectory of all of them."""
    text = model.with_(runs={}, trajectories={}, title="").model_dump_json()
    law = json.loads(trajectory.model_dump_json())
    names = [(ref, name, place) for ref, name, place in names_in(model.with_(runs={}, trajectories={}))]
    whole: dict[str, Any] = json.loads(text) | {table: {} for table in (*OWN, "fixed")}
    moves = {field for field, value in law.items() if isinstance(value, dict)}
    laws: dict[str, Any] = law | {field: {} for field in moves}
    for k in range(count):
        copy = json.loads(text)
        for ref, name, place in sorted(names, key=lambda one: -len(one[2])):
            if set(ref.tables) & set(OWN) and any(name in getattr(model, table) for table in ref.tables if table in OWN):
                _rename(copy, place, name, f"{_mark(k)}{name}")
        for table in OWN:
            whole[table] |= {f"{_mark(k)}{name}": entry for name, entry in copy[table].items()}
        for name in model.nodes:
            whole["nodes"][f"{_mark(k)}{name}"]["coincident"] = True  # with that of the other copies
        whole["fixed"] |= copy["fixed"]
        for field in moves:
            laws[field] |= {f"{_mark(k)}{name}": value for name, value in law[field].items()}
    return Model.model_validate(whole), type(trajectory).model_validate(laws)


def _mark(k: int) -> str:
    return f"{k}~"


def _rename(data: Any, place: Sequence[Any], old: str, new: str) -> None:
    """Change a name where it stands: a text, or the key of a table."""
    *before, last = place
    for key in before:
        data = data[key]
    if isinstance(data, dict) and last == old and data[last] != old:
        data[new] = data.pop(old)
    else:
        data[last] = new


def _named(keys: Sequence[Any], k: int) -> str:
    table, name, *rest = keys
    return ".".join(map(str, (table, f"{_mark(k)}{name}", *rest)))


def _number(model: Model, keys: Sequence[Any]) -> float:
    here: Any = model
    for key in keys:
        here = getattr(here, str(key)) if hasattr(type(here), "model_fields") else here[key]
    if isinstance(here, bool) or not isinstance(here, int | float):
        raise InputError(f"{'.'.join(map(str, keys))} is no number.")
    return float(here)
