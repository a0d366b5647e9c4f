"""All faults of a model or a model file, those of its structure included; what it says in silence."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from kinetruss.errors import Fault, ModelError
from kinetruss.io import MAX_SIZE, check as data_faults, placed, read
from kinetruss.mechanics import compile
from kinetruss.mechanics.mobility import afloat, beam_deformations, mobility_at
from kinetruss.mechanics.rigid_motions import floats
from kinetruss.model import Model, in_python, loads_along_beams, plausibility
from kinetruss.model.beam_frames import owner_of
from kinetruss.threads import one_thread


@one_thread
def check(model: Model | str | Path, *, max_size: int = MAX_SIZE) -> list[Fault]:
    """All faults of a model at once, each with its mend; an empty list where there are none.

    Where a run moves drives of the model, every freedom must be held by a drive.

    Parameters
    ----------
    model : a model, or the path of a model file; faults of a file carry line and column, and the motions its runs follow
        are read as well.
    max_size : bytes; a larger file is refused before it is read.

    Examples
    --------
    >>> import kinetruss as kt
    >>> check(kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"]))
    []
    """
    try:
        found = model if isinstance(model, Model) else read(model, max_size=max_size)
    except ModelError as error:
        return error.faults
    faults = data_faults(found) or [*loads_along_beams(found), *_freedoms(found)]
    return (
        [replace(one, mend=in_python(one.mend)) for one in faults]
        if isinstance(model, Model)
        else placed(model, faults, max_size=max_size)
    )


def notes(model: Model | str | Path, *, max_size: int = MAX_SIZE) -> list[Fault]:
    """What of a sound model looks like a slip, e.g. millimetres given as metres; each with what may be meant.

    Nothing of it is wrong by itself, and nothing is refused for it. Of a file each has line and column.

    Raises
    ------
    ModelError : the model has faults.

    Examples
    --------
    >>> import kinetruss as kt
    >>> wide = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"], section=kt.Rod(diameter=20))
    >>> print(notes(wide)[0])
    section: is 20 m across, and the longest bar that has it is 1 m long. Write the unit, e.g. '20 mm'; a bare number is in m.
    """
    found = model if isinstance(model, Model) else read(model, max_size=max_size)
    remarks = [*plausibility(found), *_spins(found)]
    return remarks if isinstance(model, Model) else placed(model, remarks, max_size=max_size)


def _spins(model: Model) -> list[Fault]:
    """Members that are held against a spin about their own axis."""
    said = "is free to spin about its own axis; nothing drives or loads this, so it is held."
    mend = "If it should turn, clamp or drive it, or put a hinge at one end."
    owners = {owner_of(name, model.whole.beams[name]) for one in model.whole.inner.spins for name in one.beams[:1]}
    # a straight link between ball joints has no other spin than this, and no need of it
    return [Fault((owner.table, owner.name), said, mend) for owner in owners if owner.table != "links"]


def _freedoms(model: Model) -> list[Fault]:
    """Freedoms that no drive holds, reported at the first run that moves drives.

    A model without one is a mechanism to be studied, or to be released.
    """
    driven = [
        name
        for name, run in model.runs.items()
        if (run.trajectory or run.targets) is not None and run.analysis != "dynamics.simulate"
    ]
    if not driven:
        return []
    system = compile(model)
    system = floats(system) or system
    if not (found := mobility_at(system, system.x0, beam_deformations)).undriven:
        return []
    if (free := afloat(model)) is not None and not system.prescribed.reshape(-1, 3)[:, : system.dim].any():
        return [replace(free, path=("runs", driven[0]))]
    count = "one freedom that no drive holds" if found.undriven == 1 else f"{found.undriven} freedoms that no drive holds"
    moves = "; ".join(found.mechanism_texts(3))
    return [Fault(("runs", driven[0]), f"the structure has {count}: {moves}.", "Drive it, add a bar, or fix a node.")]
