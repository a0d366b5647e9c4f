"""A motion from a node-history table."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from kinetruss.errors import ModelError
from kinetruss.io import NodeHistory, read_history
from kinetruss.io.tables import history_faults
from kinetruss.kinematics.given.arrays import from_arrays
from kinetruss.model import Model
from kinetruss.results import Motion

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["from_csv"]


def from_csv(model: Model, path: str | Path) -> Motion:
    r"""A Motion from a CSV of node histories measured or computed elsewhere.

    Parameters
    ----------
    path : columns ``t``, ``NODE.x``, ``NODE.y``[, ``NODE.z``], ``NODE.vx`` .., ``NODE.ax`` ..; SI, or a unit in the header as
        in ``N4.x [mm]``. Nodes fixed in all axes may be left out: they are at their positions in the model.

    Returns
    -------
    Motion, as from `from_arrays`.

    Raises
    ------
    ModelError : faults of the table, each with its place; a missing moving node, no velocities or accelerations, a fixed node
        at another position.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    >>> table = "t,B.x [mm],B.y [mm],B.vx,B.vy,B.ax,B.ay\n0,2000,0,0,0,0,0\n1,2000,0,0,0,0,0\n"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "motion.csv")
    ...     _ = file.write_text(table)
    ...     motion = kt.kinematics.from_csv(model, file)
    >>> motion.length.sel(member="b").values.tolist()
    [2.0, 2.0]
    """
    history = read_history(path, dim=model.dim, nodes=model.nodes)
    if found := history_faults(model, history):
        raise ModelError(found)
    rates = (
        cast("NDArray[np.float64]", one) for one in (history.velocity, history.acceleration)
    )  # without them there are faults
    x, v, a = (_filled(model, history, one) for one in (history.position, *rates))
    for k, (name, node) in enumerate(model.nodes.items()):
        if name not in history.nodes:
            x[:, k] = node.at
    return from_arrays(model, history.times, x, v, a)


def _filled(model: Model, history: NodeHistory, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values in the order of the model's nodes; zero for those that are not in the table."""
    found = np.zeros((len(history.times), len(model.nodes), model.dim))
    for k, name in enumerate(model.nodes):
        if name in history.nodes:
            found[:, k] = values[:, history.nodes.index(name)]
    return found
