"""The result of a study: a table of all its rows, and what it says."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model.table import read_only
from kinetruss.studies.ledger import Ledger, opened
from kinetruss.studies.summaries import Summary, summary_of

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray


GOOD = ("COMPLETED", "EVENT")
"""Status of a variant whose numbers count."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class StudyResult:
    """All rows of a study.

    data : over row: the variables in the units in which they were given (attribute ``units``, of bare numbers ""), texts as
        they are; the results in SI, NaN without a number; ``status``, ``message``, ``seconds`` of processor time.
        ``data.to_dataframe()`` is a table of pandas.
    variables, results : their names. nominal : results of the model as it is, if it was done; gradients : result ->
    variable -> exact derivative there, SI, where there is one. title, run : of the study; run is
    empty if each variant is an optimum, of which status ``INFEASIBLE`` is a result too, and ``UNCERTIFIED`` none.
    base_points : of Saltelli's design, else 0. path : the folder, or None.
    """

    data: xr.Dataset
    variables: tuple[str, ...]
    results: tuple[str, ...]
    nominal: Mapping[str, float] = field(default_factory=dict)
    gradients: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    run: str = ""
    title: str = ""
    base_points: int = 0
    path: Path | None = None

    def __post_init__(self) -> None:
        read_only(self)

    def __repr__(self) -> str:
        return f"<Study of {self.what}: {int(self.good.sum())} of {len(self.good)} variants have numbers>"

    @property
    def what(self) -> str:
        """What is done of every variant, in words."""
        return f"run {self.run}" if self.run else "an optimum"

    @property
    def status(self) -> NDArray[np.str_]:
        """The status of every row; empty where it is not done."""
        return np.asarray(self.data["status"].values).astype(str)

    @property
    def good(self) -> NDArray[np.bool_]:
        """The rows that have numbers."""
        return np.isin(self.status, GOOD)

    @property
    def done(self) -> int:
        """Number of rows that are done."""
        return int((self.status != "").sum())

    @property
    def failures(self) -> dict[str, int]:
        """Status of rows without numbers -> how many have it."""
        names, counts = np.unique(self.status[(self.status != "") & ~self.good], return_counts=True)
        return dict(zip(names.tolist(), counts.tolist(), strict=True))

    @cached_property
    def summary(self) -> Summary:
        """Distributions of the results, and how they depend on the variables."""
        return summary_of(self.data, self.variables, self.results, self.good, self.base_points)


def load_study(path: str | Path) -> StudyResult:
    """Open the folder of a study, also of one that is being done.

    Raises
    ------
    StoreError : no study, or a damaged one.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> study = kt.studies.Study(
    ...     model=kt.library.example_files()["four_bar"][0], run="turn", variables={"nodes.C.mass": ["0.5 kg", "1 kg"]},
    ...     results={"m": "mass"},
    ... )
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = kt.studies.run_study(study, folder + "/masses", workers=1)
    ...     kt.studies.load_study(folder + "/masses").data["m"].values.round(3).tolist()  # kg
    [1.053, 1.553]
    """
    with opened(Path(path)) as ledger:
        return result_of(ledger)


def result_of(ledger: Ledger) -> StudyResult:
    """The result of an open ledger."""
    import xarray as xr

    table, variables, results = ledger.table(), ledger.units("variables"), ledger.units("results")
    units = {**variables, **results, "seconds": "s"}
    texts = {name for name, unit in variables.items() if unit is None} | {"status", "message"}
    data = {
        name: ("row", _column(values, name in texts), {"units": units[name] or ""} if name in units else {})
        for name, values in table.items()
        if name != "row"
    }
    found = xr.Dataset(data, coords={"row": np.array(table["row"], np.int64)}, attrs={"kind": "study"})
    nominal: Any = ledger.about("nominal")
    return StudyResult(
        data=found,
        variables=tuple(variables),
        results=tuple(results),
        nominal=(nominal.get("numbers") or {}) if isinstance(nominal, dict) and nominal.get("status") in GOOD else {},
        gradients=ledger.about("gradients") or {},
        run=ledger.about("run"),
        title=ledger.about("title") or "",
        base_points=ledger.about("base points") or 0,
        path=ledger.path,
    )


def _column(values: list[Any], words: bool) -> NDArray[Any]:
    return np.array(values, dtype=object).astype(str) if words else np.array(values, float)
