"""What makes the numbers of a run unsure: an energy balance that does not close, a singular position, forces not unique; and
load cases that no check includes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from kinetruss.display import counted, moment, number
from kinetruss.display.ranks import largest
from kinetruss.mechanics import not_unique_at_notes, not_unique_note

if TYPE_CHECKING:
    from kinetruss.results import Forces, Motion, Result, Simulation


POOR_BALANCE = 1e-6
"""Largest relative error of the energy balance without a doubt; for computed motions it is near round-off."""
NEAR_SINGULAR = 0.01
STILL = 1e-12
"""Displacement, as a fraction of the structure's size, below which a motion is round-off."""


class Ran(Protocol):
    """What of a run its doubts rest on."""

    @property
    def motion(self) -> Motion: ...  # noqa: D102

    @property
    def forces(self) -> Mapping[str, Forces]: ...  # noqa: D102

    @property
    def statics(self) -> Mapping[str, Result]: ...  # noqa: D102

    @property
    def simulation(self) -> Simulation | None: ...  # noqa: D102

    @property
    def message(self) -> str: ...  # noqa: D102


def poses_of(run: Ran) -> list[str]:
    """Names of the poses of a run at rest; empty for a motion, whose samples have times."""
    data = run.motion.whole
    return [str(name) for name in data["pose"].values] if "pose" in data.coords else []


def doubts(run: Ran) -> Iterator[str]:
    """Sentences on what makes the numbers of a run unsure, most serious first."""
    balance, gauge = energy_balance(run), singularity(run)
    if balance is not None and balance["relative"] > POOR_BALANCE:
        yield (
            f"The energy balance closes only to {number(balance['relative'], 2)} of the largest power: the motion does not "
            "fit its own velocities and accelerations (measured records do not quite)."
        )
    if gauge is not None and gauge["smallest"] < NEAR_SINGULAR:
        yield (
            f"The structure comes near a singular position: measure {number(gauge['smallest'], 3)} at "
            f"{moment(gauge['time'], poses_of(run))} (0 is singular). Forces there are large and sensitive."
        )
    if names := not_unique(run):
        yield (
            f"The force is not unique in {', '.join(names)}: the structure is redundant, and the distribution "
            "depends on stiffness or convention."
        )
    yield from _not_unique_at(run)
    for case, found in run.statics.items():
        soft = {"unstable": "of negative stiffness", "neutral": "without stiffness"}
        if ways := [f"{counted(k, 'mode')} {what}" for name, what in soft.items() if (k := int(found.attrs.get(name, 0)))]:
            yield f"The equilibrium under {'all loads' if case == 'all' else case} is not stable: {' and '.join(ways)}."
    for one in () if run.simulation is None else run.simulation.passages:
        if not one.certain:
            yield f"At the singular position passed at {one} the tolerance cannot distinguish the branches."


def remarks(run: Ran) -> str:
    """The message of a run without what its doubts say."""
    left = run.message
    for said in (not_unique_note(not_unique(run)), *_not_unique_at(run)):
        left = left.replace(said, "") if said else left
    return " ".join(left.split())


def not_unique(run: Ran) -> list[str]:
    """Members whose force is not unique in a load case."""
    return list(dict.fromkeys(name for forces in run.forces.values() for name in forces.attrs.get("not_unique", [])))


def _not_unique_at(run: Ran) -> list[str]:
    """Sentences on singular positions in which forces are not unique, in a load case."""
    poses = [repr(name) for name in poses_of(run)]
    found = (not_unique_at_notes(forces.attrs.get("not_unique_at", {}), poses) for forces in run.forces.values())
    return list(dict.fromkeys(note for notes in found for note in notes))


def singularity(run: Ran) -> dict[str, float] | None:
    """The smallest measure of singularity and its time; None where it is not known."""
    gauge = run.motion.arrays["singularity"].values if "singularity" in run.motion.arrays else np.zeros(0)
    if not len(gauge) or np.isnan(gauge).all():
        return None
    at = int(np.nanargmin(gauge))
    return {"smallest": float(gauge[at]), "time": float(run.motion.whole["time"].values[at])}


def energy_balance(run: Ran) -> dict[str, Any] | None:
    """The power balance of the load case that closes worst: its largest error and the largest power, W, whose it is, and their
    ratio; None for poses at rest, which have no power.
    """
    still, exchanged = _stands_still(run), _exchanged(run)
    moving = [forces for forces in run.forces.values() if forces.whole.sizes["time"] and "energy_balance" in forces.whole]
    found = [_balance(forces, exchanged, still) for forces in moving]
    return largest(found, lambda entry: float(entry["relative"])) if found else None


def _exchanged(run: Ran) -> float:
    """Largest power between kinetic and potential energy of a simulation, W; a free mechanism may have no other power."""
    if run.simulation is None or run.simulation.data.sizes["time"] < 2:
        return 0.0
    data = run.simulation.data
    return float(np.max(np.abs(np.diff(data["kinetic_energy"].values) / np.diff(data["time"].values))))


def _stands_still(run: Ran) -> bool:
    """True if all motion is round-off, so that fractions of the largest power have no meaning."""
    data = run.motion.whole
    if not data["time"].size:
        return True
    way = float(np.max(np.abs(data["velocity"].values), initial=0.0)) * float(data["time"][-1] - data["time"][0])
    return way <= STILL * float(np.ptp(data["position"].values[0], axis=0).max())


def _balance(forces: Forces, exchanged: float, still: bool) -> dict[str, Any]:
    """Largest error of the power balance, and its ratio to the largest power: that of a single drive, of drives and loads
    together, of dampers and friction, or between kinetic and potential energy.
    """
    data = forces.whole
    miss = float(np.max(np.abs(data["energy_balance"].values)))
    powers = {"drives and loads together": data["power"].values, "the change of energy": data["energy_rate"].values}
    if data.sizes.get("drive"):
        drives = data["drive_force"].values * forces.motion.whole["drive_velocity"].values
        names = map(str, data["drive"].values)
        # a drive before the sum that it is alone
        powers = {f"drive {name}": drives[:, k] for k, name in enumerate(names)} | powers
    if "dissipation" in data:
        powers["dampers and friction"] = data["dissipation"].values
    sizes = {whose: float(np.nanmax(np.abs(one), initial=0.0)) for whose, one in powers.items()}
    sizes["kinetic and potential energy, one into the other"] = exchanged
    whose = max(sizes, key=lambda one: sizes[one] * (1 + 1e-9 * one.startswith("drive ")))
    largest = sizes[whose]
    relative = miss / largest if largest and not still else 0.0
    return {"largest_miss": miss, "largest_power": largest, "of": whose, "relative": relative}
