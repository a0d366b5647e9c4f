"""What a study says: how its results are distributed, what they depend on, and what has no numbers."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Canvas

from kinetruss.display import Table, counted, number, quantity, scale
from kinetruss.display.tables import mixed, words
from kinetruss.report.page import Page
from kinetruss.report.pictures.draw import write
from kinetruss.report.pictures.specs import ACCENT, INK, QUIET, RC
from kinetruss.report.run_data import plain
from kinetruss.units import parse

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.studies import StudyResult

MOST = 12
"""Variants without numbers that are listed; most panels of a row or column of a picture."""
MOST_OPTIMA = 40
"""Optima that are listed."""
BINS = 30
MANY = 5000
"""Points from which on a vector picture has them as pixels."""


def study(found: StudyResult) -> Page:
    """The summary of a study: a table of the distributions, one of sensitivities for each result, and variants without numbers.

    Examples
    --------
    >>> import kinetruss as kt
    >>> study = kt.studies.Study(
    ...     model=kt.library.example_files()["four_bar"][0], run="turn", variables={"nodes.C.mass": ["0.5 kg", "1 kg"]},
    ...     results={"weight": "mass"},
    ... )
    >>> page = kt.report.study(kt.studies.run_study(study, workers=1))
    >>> print(page.text.splitlines()[0])
    2 variants of run turn: all have numbers.
    """
    return Page(found=found, as_record=_record, as_entries=_entries, as_rows=_rows)


def _record(found: StudyResult) -> dict[str, Any]:
    summary = {name: plain(getattr(found.summary, name), None) for name in type(found.summary).__dataclass_fields__}
    return {
        "title": found.title,
        "run": found.run,
        "variants": len(found.good),
        "done": found.done,
        "good": int(found.good.sum()),
        "failures": found.failures,
        "variables": {name: found.data[name].attrs.get("units", "") for name in found.variables},
        "results": {name: found.data[name].attrs.get("units", "") for name in found.results},
        "nominal": plain(found.nominal, None),
        "gradients": plain(found.gradients, None),
        "summary": summary,
    }


def _rows(found: StudyResult) -> Iterable[list[Any]]:
    """All variants."""
    names = [str(name) for name in found.data.data_vars]
    yield ["row", *names]
    for k, row in enumerate(found.data["row"].values.tolist()):
        yield [row, *(found.data[name].values[k].item() for name in names)]


def _entries(found: StudyResult) -> Iterable[Entry]:
    yield _said(found)
    if not found.run:
        yield _optima(found)
    spread = found.summary.spread
    rows = [
        {"result": name, "unit": found.data[name].attrs.get("units", ""), "nominal": found.nominal.get(name), **spread[name]}
        for name in found.results
        if name in spread
    ]
    heads = ("nominal", "mean", "deviation", "least", "q05", "median", "q95", "largest")
    shown = {"q05": "5 %", "q95": "95 %"}
    columns = [words("result"), *(mixed(shown.get(head, head), head, group="values") for head in heads)]
    yield Table(columns, rows, "Results")
    for name in found.results:
        if name in spread:
            yield _sensitivity(found, name)
    yield _without(found)


def _optima(found: StudyResult) -> Table:
    """Every variant that is done, and what decides its optimum."""
    rows = []
    for k in np.flatnonzero(found.status != "").tolist():
        values, message = _values(found, k, found.variables), str(found.data["message"].values[k])
        state = found.status[k].lower()
        if found.good[k]:
            first, unit = found.results[0], found.data[found.results[0]].attrs.get("units", "")
            rows.append((*values, quantity(found.data[first].values[k], unit), message))
        else:
            rows.append((*values, state, ""))
    return Table((*found.variables, *found.results[:1], "decided by"), rows, "Optima", most=(MOST_OPTIMA, MOST_OPTIMA))


def _values(found: StudyResult, k: int, names: Iterable[str]) -> list[str]:
    """The values of the variables of a row, with the units in which they were given."""
    values = ((found.data[name].values[k], found.data[name]) for name in names)
    return [f"{one:.6g} {of.attrs.get('units', '')}".strip() if of.dtype.kind == "f" else str(one) for one, of in values]


def _said(found: StudyResult) -> str:
    count, good, left = len(found.good), int(found.good.sum()), len(found.good) - found.done
    text = f"{counted(count, 'variant')} of {found.what}: "
    text += "all have numbers." if good == count else f"{good} have numbers."
    if found.failures:
        text += " " + ", ".join(f"{k} {status.lower().replace('_', ' ')}" for status, k in found.failures.items()) + "."
    return text + (f" {left} are not done: the same command goes on." if left else "")


def _sensitivity(found: StudyResult, name: str) -> Table:
    """How a result depends on every variable; with its gradient at the model as it is, if that is known."""
    one, exact = found.summary, found.gradients.get(name, {})
    rows = []
    for variable in found.variables:
        unit = found.data[variable].attrs.get("units", "")
        slope, error = (part.get(name, {}).get(variable, math.nan) for part in (one.slope, one.slope_error))
        per = f"{found.data[name].attrs.get('units', '') or '1'}/{unit or 'SI'}"
        rows.append(
            (
                variable,
                *(_with_error(part, more, name, variable) for part, more in _indices(found)),
                _number(one.rank.get(name, {}).get(variable, math.nan)),
                f"{number(slope)} +- {number(error, 2)} {per}" if math.isfinite(slope) else "-",
                *([f"{number(exact[variable] * _size(unit))} {per}" if variable in exact else "-"] if exact else []),
            )
        )
    share = one.linear.get(name, math.nan)
    note = f"A linear function of the variables explains {100 * share:.1f} % of the variance." if math.isfinite(share) else ""
    heads = ("first order", "total") if one.first else ()
    caption = f"{name}: Sobol indices, rank correlation, slope" if one.first else f"{name}: rank correlation, slope"
    return Table(("variable", *heads, "rank", "slope", *(["gradient"] if exact else [])), rows, caption, note)


def _size(unit: str) -> float:
    """One of a unit, in SI."""
    return float(parse(f"1 {unit}", "measure")) if unit else 1.0


def _indices(found: StudyResult) -> list[tuple[Mapping[str, Any], Mapping[str, Any]]]:
    one = found.summary
    return [(one.first, one.first_error), (one.total, one.total_error)] if one.first else []


def _with_error(values: Mapping[str, Any], errors: Mapping[str, Any], name: str, variable: str) -> str:
    value = values.get(name, {}).get(variable, math.nan)
    return f"{value:.3f} +- {errors[name][variable]:.3f}" if math.isfinite(value) else "-"


def _number(value: float) -> str:
    return f"{value:.3f}" if math.isfinite(value) else "-"


def _without(found: StudyResult) -> Table:
    """Variants without numbers, the first of them with their message."""
    status, rows = found.status, np.flatnonzero((found.status != "") & ~found.good)
    lines = [
        (
            str(found.data["row"].values[k]),
            ", ".join(f"{name}={found.data[name].values[k]:.6g}" if found.data[name].dtype.kind == "f" else
                      f"{name}={found.data[name].values[k]}" for name in found.variables),
            status[k].lower().replace("_", " "),
            str(found.data["message"].values[k]),
        )
        for k in rows[:MOST].tolist()
    ]  # fmt: skip
    note = f"and {len(rows) - MOST} more" if len(rows) > MOST else ""
    return Table(("row", "values", "status", "message"), lines, "Variants without numbers", note)


# Pictures of a study.


def study_figures(found: StudyResult, folder: str | Path, formats: Iterable[str] = ("png", "svg")) -> list[Path]:
    """Draw a study: ``distributions``, ``scatter`` (every result over every variable that is a number) and, of Saltelli's
    design, ``sobol`` (first and total indices with their standard errors).

    Returns
    -------
    The paths written, ``folder/NAME.FORMAT``; none if no variant has numbers.

    Raises
    ------
    StoreError : the folder cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> study = kt.studies.Study(
    ...     model=kt.library.example_files()["four_bar"][0], run="turn", variables={"nodes.C.mass": ["0.5 kg", "1 kg"]},
    ...     results={"weight": "mass"},
    ... )
    >>> found = kt.studies.run_study(study, workers=1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     [path.name for path in kt.report.study_figures(found, folder, ["svg"])]
    ['distributions.svg', 'scatter.svg']
    """
    results = [name for name in found.results if name in found.summary.spread][:MOST]
    if not results:
        return []
    with mpl.rc_context(RC):
        drawn = {"distributions": _distributions(found, results)}
        if any(found.data[name].dtype.kind == "f" for name in found.variables):
            drawn["scatter"] = _scatter(found, results)
        if found.summary.first:
            drawn["sobol"] = _sobol(found, [name for name in results if name in found.summary.first])
    written = [(canvas, Path(folder) / f"{name}.{suffix}") for name, canvas in drawn.items() for suffix in formats]
    for canvas, path in written:
        write(canvas, path)
    return [path for _, path in written]


def _canvas(rows: int, columns: int, width: float, height: float) -> tuple[Canvas, Any]:
    canvas = Canvas(figsize=(0.6 + width * columns, 0.5 + height * rows), layout="constrained")
    FigureCanvasAgg(canvas)
    return canvas, canvas.subplots(rows, columns, squeeze=False)


def _shown(found: StudyResult, name: str) -> tuple[np.ndarray, str]:
    """The finite numbers of a result (NaN elsewhere) in a unit for people, and its label."""
    values = np.where(found.good, found.data[name].values, np.nan)
    values = np.where(np.isfinite(values), values, np.nan)
    factor, unit = scale(float(np.nanmax(np.abs(values))), found.data[name].attrs.get("units", ""))
    return values * factor, f"{name} ({unit})" if unit else name


def _distributions(found: StudyResult, results: list[str]) -> Canvas:
    canvas, axes = _canvas(len(results), 1, 5.6, 1.8)
    for ax, name in zip(axes[:, 0], results, strict=True):
        values, label = _shown(found, name)
        known = values[np.isfinite(values)]
        ax.hist(known, bins=min(BINS, max(1, len(known))), color=ACCENT)
        for share in (0.05, 0.5, 0.95):
            ax.axvline(float(np.quantile(known, share)), color=INK, linewidth=0.8, linestyle=(0, (3, 2)))
        ax.set_xlabel(label)
        ax.set_ylabel("variants")
    axes[0, 0].set_title(f"{found.title or found.what}: distributions; dashed 5 %, median, 95 %")
    return canvas


def _scatter(found: StudyResult, results: list[str]) -> Canvas:
    variables = [name for name in found.variables if found.data[name].dtype.kind == "f"][:MOST]
    canvas, axes = _canvas(len(results), len(variables), 2.2, 1.8)
    for row, name in enumerate(results):
        values, label = _shown(found, name)
        for column, variable in enumerate(variables):
            ax = axes[row, column]
            ax.plot(
                found.data[variable].values, values, ".", color=ACCENT, markersize=3, alpha=0.6, rasterized=len(values) > 5000
            )
            if row == len(results) - 1:
                unit = found.data[variable].attrs.get("units", "")
                ax.set_xlabel(f"{variable} ({unit})" if unit else variable)
            if column == 0:
                ax.set_ylabel(label)
    return canvas


def _sobol(found: StudyResult, results: list[str]) -> Canvas:
    one, names = found.summary, list(found.variables)
    canvas, axes = _canvas(len(results), 1, 5.6, 0.7 + 0.35 * len(names))
    place = np.arange(len(names))
    parts = ((one.first, one.first_error, -0.2, ACCENT, "first order"), (one.total, one.total_error, 0.2, QUIET, "total"))
    for ax, name in zip(axes[:, 0], results, strict=True):
        for values, errors, shift, colour, label in parts:
            ax.barh(
                place + shift,
                [values[name][k] for k in names],
                0.36,
                xerr=[errors[name][k] for k in names],
                color=colour,
                label=label,
                ecolor=INK,
            )
        ax.set_yticks(place, names)
        ax.invert_yaxis()
        ax.set_xlabel(f"Sobol index of {name}")
    axes[0, 0].legend(loc="best")
    axes[0, 0].set_title(f"Sobol indices with standard errors, {one.base} base points")
    return canvas
