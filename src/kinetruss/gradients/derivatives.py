"""Gradients of responses: exact derivatives of scalars of results by numbers of the model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError
from kinetruss.gradients.analyses import name_of, point_of
from kinetruss.gradients.differences import FOUR
from kinetruss.gradients.points import gradients_at
from kinetruss.gradients.responses import Read, Sheet, read_response
from kinetruss.gradients.varied import Varied, Wrt, varied
from kinetruss.mechanics import compile
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

ALIKE = 1e-8
"""Gradients of what is equally large that differ by less than this fraction of the largest derivative are the same."""


@dataclass(frozen=True, eq=False)
class Response:
    """A scalar of the result of an analysis of a model, as text.

    Parameters
    ----------
    text : over the variables of the result, with entries by name in brackets, + - * / **, units and functions:
        ``max(abs(member_force))/kN``, ``displacement[C, y]``, ``rms(drive_force[lift])``; see `read_response`.
    analysis : `statics.linear`, `kinematics.follow`, `dynamics.inverse` or `kt.run`; arguments : those that it takes beside the
        model; of `dynamics.inverse` those of `kinematics.follow`, whose motion it takes, and its load case.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.Rod(diameter="10 mm"), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> tip = kt.Response("displacement[B, x]/mm", kt.statics.linear, rod)
    >>> round(tip.value, 4)
    0.8488
    """

    text: str
    analysis: Callable[..., Any]
    model: Model
    arguments: dict[str, Any] = field(default_factory=dict)

    def __init__(self, text: str, analysis: Callable[..., Any], model: Model, **arguments: Any) -> None:
        name_of(analysis)
        for name, value in (("text", text), ("analysis", analysis), ("model", model), ("arguments", arguments)):
            object.__setattr__(self, name, value)

    @cached_property
    def _read(self) -> Read:
        point = point_of(self.analysis)(compile(self.model), **self.arguments)
        return read_response(self.text, point.data(), getattr(point, "more", None))

    @property
    def value(self) -> float:
        """The value, in SI units if the text has none."""
        return self._read.value

    @property
    def unit(self) -> str:
        """The unit of the value."""
        return self._read.unit

    def at(self, model: Model) -> Response:
        """The same of another model."""
        return Response(self.text, self.analysis, model, **self.arguments)


def value_and_gradient(of: Response | Sequence[Response], wrt: Wrt) -> tuple[Any, xr.DataArray]:
    """The value of a response and its derivatives by numbers of the model; of several responses of one analysis arrays.

    Parameters
    ----------
    of : a response, or several of the same analysis, model and arguments, which then share the work.
    wrt : paths of numbers, as for `io.set_value`: ``bars.M7.section.area``, ``nodes.C.at.0``; with a star for all that fit; a
        list of paths inside the list is one number that all have.

    Returns
    -------
    The value, and the derivatives (number,), or (response, number), in the unit of the response over the SI unit of the number.

    Raises
    ------
    InputError : an unknown path, or one of no number. AnalysisError : there is no gradient, as at a tie of two largest values.

    Notes
    -----
    To about ten digits: the adjoint of the equations of the analysis, with differences of third order of what the elements
    compute at fixed unknowns, in as few evaluations as the colours of the numbers (Curtis, Powell & Reid, 1974).

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.Rod(diameter="10 mm"), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> tip = kt.Response("displacement[B, x]", kt.statics.linear, rod)
    >>> value, by = kt.value_and_gradient(tip, ["nodes.B.at.0"])  # u = F l/(E A)
    >>> bool(abs(by.item() - value / 2) < 1e-12)
    True
    """
    several = [of] if isinstance(of, Response) else [*of]
    if not several:
        raise InputError("No response is given. Give kt.Response('max(abs(member_force))', kt.statics.linear, model).")
    first = several[0]
    if any((one.analysis, one.model, one.arguments) != (first.analysis, first.model, first.arguments) for one in several[1:]):
        raise InputError("The responses are of several analyses or models. Take those of one at a time.")
    by = varied(first.model, wrt)
    return _found(several, by, isinstance(of, Response))


def _found(several: Sequence[Response], by: Varied, single: bool) -> tuple[Any, xr.DataArray]:
    first = several[0]
    # along a run the marks that tell the numbers of a system from each other would grow
    system = compile(first.model) if name_of(first.analysis) == "dynamics.simulate" else by.system
    point = point_of(first.analysis)(system, **first.arguments)
    sheet = Sheet.of(point.data(), getattr(point, "more", None))
    read = [read_response(one.text, sheet) for one in several]
    for one, own in zip(several, read, strict=True):
        if not all(np.isfinite(seed).all() for seed in own.seeds.values()):
            raise AnalysisError(f"{one.text} has no gradient here: it has the root or the size of 0, or divides by it.")
    tied = [k for k, own in enumerate(read) if own.ties]
    seeds = [own.seeds for own in read] + [read[k].shared for k in tied]
    found = point.gradients(by, seeds) if hasattr(point, "gradients") else gradients_at(point, by, seeds)
    for k, other in zip(tied, found[len(read) :], strict=True):
        # what is equally large may grow alike, as a member without bending by the rules of buckling and of beam-columns
        if np.abs((other - found[k]) * by.scale).max() > ALIKE * np.abs(found[k] * by.scale).max():
            raise AnalysisError(
                f"{several[k].text} has no gradient here: {'; '.join(read[k].ties)} equally large. "
                "Take pnorm(..., 8) or ks(..., r), which are smooth, or name one of them in brackets."
            )
    found = found[: len(read)]
    texts = [one.text for one in several]
    values = np.array([own.value for own in read])
    coords = {"number": list(by.names), "response": texts}
    array = xr.DataArray(found, dims=("response", "number"), coords=coords)
    return (float(values[0]), array[0]) if single else (values, array)


def gradient(of: Response | Sequence[Response], wrt: Wrt) -> xr.DataArray:
    """The derivatives of `value_and_gradient` alone.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> round(kt.gradient(kt.Response("axial_stress[b]/MPa", kt.statics.linear, rod), "section.area").item())  # -F/A^2
    -700000
    """
    return value_and_gradient(of, wrt)[1]


LITTLE = 1e-3
"""Share of the value below which derivatives count as 0 where they are compared."""


@dataclass(frozen=True, eq=False)
class Check:
    """A gradient beside differences: arrays (numbers,); error: the largest deviation over the largest derivative, in changes of
    each number by its own size; over a thousandth of the value, if that is more.
    """

    gradient: NDArray[np.float64]
    differences: NDArray[np.float64]
    error: float


def check_gradient(of: Response, wrt: Wrt, step: float = 2e-4) -> Check:
    """A gradient beside central differences of fourth order of the whole analysis, four of it for each number.

    step : as a fraction of each number, or of the size of the structure for places.

    >>> import kinetruss as kt
    >>> truss = kt.library.vgt.triangular()
    >>> force = kt.Response("max(abs(member_force))", kt.statics.linear, truss)
    >>> kt.check_gradient(force, ["nodes.B.at.0", "nodes.B.at.1"]).error < 1e-8
    True
    """
    by = varied(of.model, wrt)
    value, array = _found([of], by, single=True)
    found = np.asarray(array)
    other = np.zeros(len(by.names))
    for k in range(len(by.names)):
        for share, weight in FOUR:
            change = np.zeros(len(by.names))
            change[k] = share * step * by.scale[k]
            other[k] += weight * of.at(by.model_at(change)).value / (step * by.scale[k])
    size = max(float(np.abs(other * by.scale).max(initial=0.0)), LITTLE * abs(value)) or 1.0
    return Check(found, other, float(np.abs((found - other) * by.scale).max(initial=0.0)) / size)
