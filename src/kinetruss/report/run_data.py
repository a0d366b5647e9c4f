"""What a run says, as plain rows, SI, NaN for what is not known: forces, supports, strength, checks; plain data for JSON."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display.ranks import largest_first, place_of_largest
from kinetruss.mechanics import compile
from kinetruss.model import LengthDrive
from kinetruss.model.bracing import CHORD
from kinetruss.model.members import Brace
from kinetruss.results.records import MOTORS_UNCHECKED
from kinetruss.results.user_parts import clamps
from kinetruss.runs.doubts import energy_balance, not_unique, singularity
from kinetruss.strength import elements
from kinetruss.strength.beam_verdict import middle_forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]


WORST = 8


def pose_at(forces: Forces, at: int) -> str:
    """Name of the pose of a sample; empty for instants of a motion."""
    return str(forces.whole["pose"].values[at]) if "pose" in forces.whole.coords else ""


def peak(values: Any) -> float:
    """The value of largest magnitude, with its sign; NaN if none is known."""
    return math.nan if np.isnan(values).all() else float(values[int(np.nanargmax(np.abs(values)))])


def entry(row: Any) -> dict[str, Any]:
    """The fields of a record, such as an entry of a table of utilisations."""
    return {name: getattr(row, name) for name in row.__slots__}


def plain(value: Any, infinite: str | None = "Infinity") -> Any:
    """Tables, lists, texts and numbers that JSON can hold: NaN becomes None. infinite : what infinity becomes."""
    if isinstance(value, Mapping):
        return {str(key): plain(one, infinite) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one, infinite) for one in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None if math.isnan(value) or infinite is None else infinite if value > 0 else f"-{infinite}"
    return value


# Forces.


def largest_forces(run: RunResult, count: int = 5) -> list[dict[str, Any]]:
    """The members with the largest force of all load cases, largest first, without bars that represent bodies.

    ``unique`` : False if the structure is redundant, or then in a singular position, and the force of the member depends on
    stiffness or convention.
    """
    found: list[dict[str, Any]] = []
    members = run.model.whole.members
    for case, forces in run.forces.items():
        values = forces.whole["member_force"].values
        if not len(values):
            continue
        static = None if forces.static is None else forces.static.whole["member_force"].values
        unsure, at_times = set(forces.whole.attrs.get("not_unique", [])), forces.whole.attrs.get("not_unique_at", {})
        for i, member in enumerate(map(str, forces.whole["member"].values)):
            if isinstance(members[member], Brace):
                continue
            at = place_of_largest(np.abs(values[:, i]))
            share = math.nan if static is None else float(values[at, i] - static[at, i])
            when = float(forces.whole["time"].values[at])
            found.append(
                {
                    "member": member,
                    "force": float(values[at, i]),
                    "by_motion": share,
                    "time": when,
                    "pose": pose_at(forces, at),
                    "load_case": case,
                    "unique": member not in unsure and when not in at_times.get(member, ()),
                }
            )
    return largest_first(found, lambda entry: abs(entry["force"]))[:count]


def envelopes(run: RunResult) -> dict[str, list[dict[str, Any]]]:
    """Smallest and largest mean axial force (N), with times (s), by load case and member, largest magnitude first; of elastic
    beams that in their middle. Beams whose forces are not known are left out.

    ``at_rest`` is the force in the same pose at rest at the time of the larger of the two.
    """
    found: dict[str, list[dict[str, Any]]] = {}
    members, beams = run.model.whole.members, {f"{name}{CHORD}": name for name in run.model.whole.beams}
    for case, forces in run.forces.items():
        data = forces.whole
        if not data.sizes["time"]:
            continue
        time, values = data["time"].values, middle_forces(run.model, forces)
        still = None if forces.static is None else middle_forces(run.model, forces.static)
        low, high = place_of_largest(-values, axis=0), place_of_largest(values, axis=0)
        unsure, at_times = set(data.attrs.get("not_unique", [])), data.attrs.get("not_unique_at", {})
        entries = []
        for k, name in enumerate(map(str, data["member"].values)):
            if (isinstance(members[name], Brace) and name not in beams) or np.isnan(values[:, k]).any():
                continue
            least, largest = values[low[k], k], values[high[k], k]
            at = int(low[k] if -least > largest else high[k])
            entries.append(
                {
                    "member": beams.get(name, name),
                    "least": float(least),
                    "least_time": float(time[low[k]]),
                    "largest": float(largest),
                    "largest_time": float(time[high[k]]),
                    "at_rest": None if still is None else float(still[at, k]),
                    "unique": name not in unsure and not {time[low[k]], time[high[k]]} & {*at_times.get(name, ())},
                }
            )
        found[case] = largest_first(entries, lambda entry: max(-entry["least"], entry["largest"]))
    return found


def reactions(run: RunResult) -> list[dict[str, Any]]:
    """Force of largest magnitude on the structure (N), its time (s) and its components, by support and load case.

    A clamp has also ``moment`` (N m) about its node at that time, by axis.
    """
    found = []
    for case, forces in run.forces.items():
        data = forces.whole
        if not data.sizes["time"] or not data.sizes["support"]:
            continue
        time, axes = data["time"].values, [str(axis) for axis in data["axis"].values]
        several = clamps(compile(run.model))
        for k, name in enumerate(map(str, data["support"].values)):
            values = data["reaction"].values[:, k]
            size = np.linalg.norm(np.nan_to_num(values), axis=1)
            at = place_of_largest(size)
            entry = {
                "support": name,
                "load_case": case,
                "magnitude": float(size[at]),
                "time": float(time[at]),
                "force": dict(zip(axes, values[at].tolist(), strict=True)),
            }
            if name in several:
                moment = data["reaction_moment"][at, k]
                entry["moment"] = dict(zip(moment["rotation"].values.tolist(), moment.values.tolist(), strict=True))
            found.append(entry)
    return found


# Strength.


def strength(run: RunResult) -> list[dict[str, Any]]:
    """All entries of the verdict, worst first; entries not checked are last, with the missing data."""
    return [] if run.verdict is None else [entry(row) for row in run.verdict.table()]


def worst(run: RunResult) -> list[dict[str, Any]]:
    """The governing entry of each part, worst part first."""
    return governing(strength(run))


def governing(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The first entry of each part that has a demand."""
    first: dict[str, Any] = {}
    for row in rows:
        if row["utilisation"] is not None and (row["utilisation"] == "Infinity" or row["utilisation"] > 0):
            first.setdefault(row["part"], row)
    return list(first.values())


def skins(run: RunResult) -> list[dict[str, Any]]:
    """Highest von Mises stress (Pa) of each membrane and solid and load case, its element (from 0) and nodes, its time (s), and
    the yield strength of the material, highest first. They are not part of the verdict. Only of positions that loads deform.
    """
    found = []
    for name, record in (run.model.membranes | run.model.solids).items() if run.good else ():
        material = run.model.material_of(record)
        for case, result in _deformed(run).items():
            data = elements(run.model, result, name)["von_mises"]
            stress = data.max([one for one in data.dims if one not in ("time", "element")]).transpose("element", ...)
            at = np.unravel_index(place_of_largest(stress.values), stress.shape)
            entry = {
                "part": name,
                "load_case": case,
                "von_mises": float(stress.values[at]),
                "element": int(at[0]),
                "nodes": [str(record.nodes[k]) for k in np.asarray(record.elements)[at[0]]],
                "time": float(run.motion.whole["time"].values[at[1]]) if stress.ndim > 1 else 0.0,
                "yield_strength": None if material is None else getattr(material, "yield_strength", None),
            }
            found.append(entry)
    return largest_first(found, lambda one: one["von_mises"])


def _deformed(run: RunResult) -> dict[str, Any]:
    """Results by load case whose positions or displacements are those under load."""
    if run.simulation is not None:
        return {next(iter(run.forces), ""): run.simulation}
    return {case: one for case, one in run.statics.items() if {"displacement", "position"} & set(one.data)}


# Checks.


def checks(run: RunResult) -> dict[str, Any]:
    """Energy balance, singularity measure, members whose force is not unique, limits of motors that the motion alone left
    open and the forces decided, missing strength checks.
    """
    return {
        "singularity": singularity(run),
        "energy_balance": energy_balance(run),
        "not_unique": not_unique(run),
        "not_held": list(run.finding.left_out),
        "motors": list(run.motion.attrs.get(MOTORS_UNCHECKED, ())) if run.demand else [],
    }


def closure(run: RunResult) -> dict[str, Any] | None:
    """Largest error of a bar length, m, recomputed from the node positions.

    Rigid bars are compared with their given or first length, driven ones with the drive. None without such bars or samples.
    """
    data = run.motion.whole
    if not data.sizes["time"]:
        return None
    time, position = data["time"].values, data["position"].values
    place = {str(name): k for k, name in enumerate(data["node"].values)}
    worst: dict[str, Any] | None = None
    whole = run.model.whole
    for name, wanted in _wanted(run):
        a, b = (position[:, place[end]] for end in whole.members[name].ends)
        length = np.linalg.norm(b - a, axis=1)
        error = np.abs(length - (length[0] if wanted is None else wanted))
        at = int(error.argmax())
        if worst is None or error[at] > worst["error"]:
            share = float(error[at] / length[at]) if length[at] else 0.0
            part = whole.inner.part_of(name)
            worst = {"error": float(error[at]), "relative": share, "member": part, "time": float(time[at])}
    return worst


def _wanted(run: RunResult) -> list[tuple[str, NDArray[np.float64] | float | None]]:
    """Members with a required length: over time, or one for all times (None: that of the start)."""
    data = run.motion.whole
    driven = {drive.bar: name for name, drive in run.model.all_drives.items() if isinstance(drive, LengthDrive)}
    columns = {str(name): k for k, name in enumerate(data["drive"].values)} if "drive" in data.coords else {}
    found: list[tuple[str, NDArray[np.float64] | float | None]] = []
    for name, member in run.model.whole.members.items():
        if name in driven:
            if driven[name] in columns:
                found.append((name, data["drive_position"].values[:, columns[driven[name]]]))
        elif getattr(member, "kind", "") == "rigid":
            found.append((name, member.length))
    return found
