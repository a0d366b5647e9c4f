"""All faults of a model or a model file."""

from __future__ import annotations

from pathlib import Path

from kinetruss.errors import Fault, ModelError
from kinetruss.io.histories import history_faults, read_history
from kinetruss.io.reading import read
from kinetruss.io.yaml_text import MAX_SIZE
from kinetruss.model import Model, faults


def check(model: Model | str | Path, *, max_size: int = MAX_SIZE) -> list[Fault]:
    """All faults in the data of a model at once; `kinematics.check` also checks the structure.

    Parameters
    ----------
    model : a model, or the path of a model file; faults of a file have line and column, and the motion files of its runs
    are read as well.
    max_size : bytes; a larger file is not read.

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
    listed = faults(found)
    for name, run in found.runs.items():
        if run.motion is not None:
            listed += _motion_faults(name, run.motion, found)
    return listed


def _motion_faults(name: str, path: str, model: Model) -> list[Fault]:
    try:
        found = history_faults(model, read_history(path, dim=model.dim, nodes=model.whole.nodes))
    except ModelError as error:
        found = error.faults
    return [Fault(("runs", name, "motion"), f.message, f.mend, f.line, f.column, f.file) for f in found]
