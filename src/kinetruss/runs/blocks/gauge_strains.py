"""Gauge readings of a run, at its own samples or at those of a measured record."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss import strength
from kinetruss.model import Model
from kinetruss.runs.blocks.forces_at import forces_at
from kinetruss.runs.blocks.planned import plan
from kinetruss.strength.strain_gauges import inside

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.io import StrainHistory

__all__ = ["gauge_strains"]


def gauge_strains(
    model: Model, name: str | None = None, *, load_case: str | None = None, measured: StrainHistory | None = None
) -> xr.Dataset:
    """Readings of a model's gauges along a named run; see `strength.gauges`.

    Parameters
    ----------
    name : a run of the model; may be omitted if there is only one. load_case : by default the run's first.
    measured : the run is also computed exactly at the times of this record.

    Raises
    ------
    InputError : no such run or load case, no gauges, `measured` is no record. ModelError : measured times outside the run.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["strain_gauges"][0])
    >>> strains = kt.runs.gauge_strains(model, "experiment_1")
    >>> dict(strains.strain.sizes)
    {'time': 110, 'gauge': 3}
    """
    job = plan(model, name)
    times = job.times
    if measured is not None:
        inside(measured, float(times[0]), float(times[-1]))
        times = _also(times, measured.times)
    zero = model.gauge_zero
    if zero is not None and zero.time is not None and times[0] <= zero.time <= times[-1]:
        times = _also(times, np.array([zero.time]))
    return strength.gauges(model, forces_at(model, name, times, load_case=load_case))


def _also(times: np.ndarray, more: np.ndarray) -> np.ndarray:
    """The times of both, without duplicates up to round-off."""
    inner = np.clip(more, times[0], times[-1])
    new = [t for t in inner if np.abs(times - t).min() > 1e-9 * (times[-1] - times[0])]
    return np.unique(np.concatenate([times, new]))
