"""Error budgets: what tolerances of lengths, sections, masses and temperature make of a pose and its forces."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss import dynamics, kinematics, strength
from kinetruss.display import Table, number, quantity
from kinetruss.display.ranks import order_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.io import set_values
from kinetruss.kinematics.motions import Course, motion_of, path_of, sweep_path
from kinetruss.kinematics.sampling import Sampled, start_values
from kinetruss.limits import whole
from kinetruss.mechanics import compile
from kinetruss.mechanics.coordinates import Coordinate, coordinate_values, coordinates
from kinetruss.mechanics.loads import history_of
from kinetruss.mechanics.rotating_base import base_of
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Model, Quintic
from kinetruss.results import Result, variable
from kinetruss.runs.uncertain import Parameter, driven_lengths, parameters

if TYPE_CHECKING:
    from numpy.typing import NDArray


VALUES = {"forces": "force", "moments": "moment", "pressures": "pressure"}
"""Table of a load in time -> its constant value."""


def at_instant(model: Model, time: float) -> Model:
    """The model with its loads and gravity as they are at a time, s, for poses that are counted along the time axis.

    Raises
    ------
    InputError : supports that move.
    """
    if model.support_motion:
        name = next(iter(model.support_motion))
        raise InputError(f"A budget takes no moving supports, and {name!r} moves. Leave out support_motion.")
    t = np.array([time])
    loads = {name: _constant(load, t) for name, load in model.loads.items()}
    found = model.with_(loads=loads) if loads != model.loads else model
    base = base_of(compile(model))
    if base is None or not base.turns or model.base_rotation is None:
        return found

    def turned(gravity: Any) -> Any:
        if gravity is None:
            return None
        here = np.zeros(3)
        here[: model.dim] = gravity
        return tuple((here + base.gravity_change(t, here)[0])[: model.dim].tolist())

    cases = {name: case.with_(gravity=turned(case.gravity)) for name, case in model.load_cases.items()}
    still = model.base_rotation.with_(gravity_turns=False)
    return found.with_(gravity=turned(model.gravity), load_cases=cases, base_rotation=still)


def _constant(load: Any, t: Any) -> Any:
    """A load with its value at a time, (1,) s."""
    for table, value in VALUES.items():
        if getattr(load, table, None) is not None:
            here = history_of(load, t)[0].tolist()
            alone = value == "pressure" or (value == "moment" and len(here) == 1)
            return load.with_(**{"times": None, table: None, value: here[0] if alone else tuple(here)})
    return load


# Error budget of a pose: what tolerances of lengths, sections, masses and temperature make of poses, forces and strains.

Floats = Any
ROUND_OFF = 1e-12
"""Values up to this magnitude, in SI units, are round-off."""
MICROSTRAIN = "1e-6"
"""Unit of strains."""


class Budget(Result):
    """An error budget; see `budget`. ``.text``: worst case, root sum of squares and Monte Carlo side by side; ``.record``: all
    numbers as plain data.
    """

    @property
    def record(self) -> dict[str, Any]:
        """Quantities with their errors, and the share of every parameter, in SI units; strains in 1e-6."""
        data, names = self.data, [str(one) for one in self.data["parameter"].values]
        rows = []
        for i, name in enumerate(data["quantity"].values):
            row: dict[str, Any] = {"quantity": str(name), "unit": str(data["unit"].values[i])}
            row |= {str(key): float(one.values[i]) for key, one in data.data_vars.items() if one.dims == ("quantity",)}
            rows.append(row | {"share": dict(zip(names, data["share"].values[i].tolist(), strict=True))})
        return {"quantities": rows, "tolerance": dict(zip(names, data["tolerance"].values.tolist(), strict=True)), **data.attrs}

    @property
    def text(self) -> str:
        """The quantities with their errors by the three ways, and the three parameters with the largest shares."""
        data, rows = self.data, []
        keys = ("nominal", "worst_case", "root_sum_square", "monte_carlo", "monte_carlo_error")
        for i, (name, unit) in enumerate(zip(data["quantity"].values, data["unit"].values, strict=True)):
            share = np.abs(data["share"].values[i]) if data["worst_case"].values[i] > ROUND_OFF else np.zeros(0)
            first = [
                f"{data['parameter'].values[k]} {quantity(share[k] / share.sum(), '%')}"
                for k in order_of(share)[:3]
                if share[k] > ROUND_OFF
            ]
            rows.append((str(name), *(_shown(float(data[key].values[i]), str(unit)) for key in keys), ", ".join(first)))
        return Table(("quantity", "nominal", "worst case", "rss", "Monte Carlo", "+-", "largest shares"), rows).text


def _shown(value: float, unit: str) -> str:
    """A value with its unit; round-off is 0."""
    if unit != MICROSTRAIN:
        return quantity(value, unit)
    return f"{number(0.0 if abs(value) * 1e-6 < ROUND_OFF else value)} microstrain"


def budget(
    model: Model,
    of: str | Iterable[str],
    tolerances: Mapping[str, Any],
    *,
    at: Mapping[str, float | str] | tuple[Any, float] | None = None,
    load_case: str | None = None,
    samples: int = 1000,
    seed: int = 0,
    deviations: float = 3.0,
    expansion: float | None = None,
) -> Budget:
    """Errors of poses, forces and strains that tolerances cause: worst case, root sum of squares, Monte Carlo.

    Parameters
    ----------
    of : quantities: coordinates as in `kinematics.jacobian` (``N8.x``, ``bay.beta``, measured from the nodes),
        ``M8.force`` (member force), ``M7.drive_force``, ``G1.strain`` (reading of a gauge, not zeroed).
    tolerances : parameter -> half the width of its range. ``M1.length`` or ``M*.length`` m: every member by itself, of a driven
        one the error of its length; ``N4.play`` m: every member at the node sits off it by up to this; ``temperature`` K: all
        members expand; or a dotted path as for `io.set_value`, ``*`` for every name (``materials.*.density``,
        ``active.M7.base.mass``, ``screws.screw.friction``), as a number or as text, ``"2 %"``.
    at : coordinates of a pose (others as in the model), or (trajectory, time) of a motion: with its inertia forces. By default
        the model's own pose. The commanded lengths are those of the model without errors. Loads in time are those at this
        time; of a pose those at 0 s.
    samples, seed : of the Monte Carlo. deviations : standard deviations that a tolerance stands for; the draws are normal.
    expansion : 1/K, of materials without their own.

    Returns
    -------
    Budget. ``nominal``, ``worst_case`` (sum of the sizes of all shares), ``root_sum_square``, ``monte_carlo`` (`deviations`
    times the standard deviation of the draws), ``monte_carlo_error`` (its standard error), ``monte_carlo_shift`` (mean of the
    draws minus nominal) (quantity); ``sensitivity``, ``sensitivity_error``, ``share`` = sensitivity x tolerance (quantity,
    parameter); ``tolerance`` (parameter); coordinate ``unit``.

    Raises
    ------
    InputError : unknown quantities or parameters, tolerances that are not positive, a length that cannot change alone, moving
        supports.
    AnalysisError : the pose is out of reach, or not within the tolerances.

    Notes
    -----
    Coordinates have exact sensitivities to lengths. Those of forces and strains are central differences over the tolerance and
    half of it, extrapolated (Richardson); ``sensitivity_error`` is the change by the extrapolation. Masses of members stay when
    their length changes. The Monte Carlo assembles every draw anew.

    Examples
    --------
    >>> import kinetruss as kt
    >>> rod = kt.Model(
    ...     nodes={"O": (0, 0), "A": (0, -1)}, fixed={"O": "xy", "A": "x"}, bars={"rod": kt.Bar(ends=("O", "A"), kind="driven")}
    ... )
    >>> found = kt.runs.budget(rod, "A.y", {"rod.length": "1 mm"}, samples=100)
    >>> found.worst_case.values.round(9).tolist(), found.root_sum_square.values.round(9).tolist()  # m
    ([0.001], [0.001])
    """
    chosen = parameters(model, tolerances, expansion)
    names = [of] if isinstance(of, str) else list(of)
    whole(samples, "samples", least=4)
    job = _Job(model, chosen, names, at, load_case)
    zero = np.zeros(len(chosen))
    tolerance = np.array([one.tolerance for one in chosen])
    steps = np.concatenate([np.diag(s * tolerance) for s in (1.0, -1.0, 0.5, -0.5)])
    far_up, far_down, up, down = np.split(job.values(np.concatenate([steps, [zero]]))[:-1], 4)
    nominal = job.values(np.array([zero]))[0]
    coarse, fine = (far_up - far_down) / 2, up - down
    share = (4 * fine - coarse).T / 3
    error = np.abs(share - fine.T)
    exact = job.exact()
    known = ~np.isnan(exact)
    share, error = np.where(known, exact * tolerance, share), np.where(known, 0.0, error)
    draws = np.random.default_rng(seed).standard_normal((samples, len(chosen))) * tolerance / deviations
    found = job.values(draws)
    spread = deviations * found.std(axis=0, ddof=1)
    per: dict[str, tuple[Floats, str]] = {
        "nominal": (nominal, "value without errors"),
        "worst_case": (np.abs(share).sum(axis=1), "sum of the sizes of all shares"),
        "root_sum_square": (np.sqrt((share**2).sum(axis=1)), "root of the sum of the squares of all shares"),
        "monte_carlo": (spread, "standard deviation of the draws times `deviations`"),
        "monte_carlo_error": (spread / np.sqrt(2 * (samples - 1)), "its standard error"),
        "monte_carlo_shift": (found.mean(axis=0) - nominal, "mean of the draws minus nominal"),
    }
    data = {name: variable(("quantity",), values, "unit", text) for name, (values, text) in per.items()}
    both = ("quantity", "parameter")
    data["sensitivity"] = variable(both, share / tolerance, "unit per unit of the parameter", "derivative")
    data["sensitivity_error"] = variable(both, error / tolerance, "unit per unit of the parameter", "error of the derivative")
    data["share"] = variable(both, share, "unit", "sensitivity times tolerance")
    data["tolerance"] = variable(("parameter",), tolerance, "SI", "half the width of the range")
    coords = {"quantity": names, "unit": ("quantity", job.units), "parameter": [one.name for one in chosen]}
    attrs = {"kind": "budget", "samples": samples, "seed": seed, "deviations": deviations}
    return Budget(data=xr.Dataset(data, coords=coords, attrs=attrs))


class _Job:
    """The nonlinear model of a budget: values of all quantities for rows of parameters."""

    def __init__(self, model: Model, chosen: list[Parameter], of: list[str], at: Any, load_case: str | None) -> None:
        # the poses are counted along the time axis, so loads are those of the instant
        model = at_instant(model, at[1] if isinstance(at, tuple) else 0.0)
        self.model, self.drives = driven_lengths(model, chosen)
        self.chosen, self.load_case = chosen, load_case
        self.derivatives = _command(model, at)
        system = compile(self.model)
        self.own: dict[int, Coordinate] = {}
        self.kinds: list[tuple[str, str]] = []
        for k, name in enumerate(of):
            place, _, last = name.rpartition(".")
            kind = last if _offers(model, place, last) else ""
            self.kinds.append((place, kind))
            if not kind:
                several = coordinates(system, name)
                if len(several) > 1:
                    raise InputError(f"{name!r} stands for {len(several)} coordinates. Name one, e.g. {several[0].name!r}.")
                self.own[k] = several[0]
            warm = any(one.name == "temperature" for one in chosen)
            if warm and kind == "strain" and model.gauges[place].matched_expansion is not None:
                # the parameter changes lengths only
                raise InputError(f"What gauge {place!r} reads of a temperature is not in a budget. Leave one of both out.")
        self.units = [
            self.own[k].unit if k in self.own else MICROSTRAIN if kind == "strain" else "N"
            for k, (_, kind) in enumerate(self.kinds)
        ]
        self.x: Floats = None

    def values(self, rows: NDArray[np.float64]) -> NDArray[np.float64]:
        """Quantities (rows, quantities) for errors (rows, parameters): rows of equal numbers of the model at once."""
        lengths = rows @ np.stack([one.lengths for one in self.chosen])
        by_path = [k for k, one in enumerate(self.chosen) if one.path is not None]
        found = np.empty((len(rows), len(self.kinds)))
        groups: dict[bytes, list[int]] = {}
        for i, row in enumerate(rows):
            groups.setdefault(row[by_path].tobytes(), []).append(i)
        for index in groups.values():
            row = rows[index[0]]
            settings = {self.chosen[k].path: self.chosen[k].nominal + row[k] for k in by_path if row[k]}
            model = (
                set_values(self.model, {str(path): float(value) for path, value in settings.items()})
                if settings
                else self.model
            )
            found[index] = self._at(model, lengths[index])
        return found

    def exact(self) -> NDArray[np.float64]:
        """Derivatives (quantities, parameters) of coordinates; NaN for other quantities."""
        found = np.full((len(self.kinds), len(self.chosen)), np.nan)
        moved = [k for k, drive in enumerate(self.drives) if drive is not None]
        for q, one in self.own.items():
            found[q] = 0.0
            if moved:
                names = [f"{list(self.model.members)[k]}.length" for k in moved]
                J = kinematics.jacobian(self.model, self.x, of=one.name, wrt=names).values[0]
                found[q] = np.stack([p.lengths[moved] for p in self.chosen]) @ J
        return found

    def _at(self, model: Model, lengths: NDArray[np.float64]) -> NDArray[np.float64]:
        """Quantities for errors of lengths (rows, members), m, in one sweep."""
        motion = self._motion(model, lengths)
        found = np.empty((len(lengths), len(self.kinds)))
        x = flat_positions(compile(model), motion.whole["position"].values)
        if self.x is None:
            self.x = motion.whole["position"].values[-1]
        if self.own:
            values = coordinate_values(compile(model), list(self.own.values()), x)
            found[:, list(self.own)] = values
        if len(self.own) < len(self.kinds):
            forces = dynamics.inverse(model, motion, self.load_case, static=False)
            strains = strength.gauges(model, forces, zeroed=False) if any(kind == "strain" for _, kind in self.kinds) else None
            for k, (name, kind) in enumerate(self.kinds):
                if kind == "force":
                    found[:, k] = forces.whole["member_force"].sel(member=name)
                elif kind == "drive_force":
                    found[:, k] = forces.whole["drive_force"].sel(drive=name)
                elif kind == "strain" and strains is not None:
                    found[:, k] = strains["strain"].sel(gauge=name)
        return found

    def _motion(self, model: Model, lengths: NDArray[np.float64]) -> Any:
        """The poses as a motion whose instants are the rows; they have nothing to do with each other."""
        rows = np.arange(len(lengths), dtype=float)
        if not model.all_drives:
            still = np.zeros((len(rows), len(model.whole.nodes), model.dim))
            return kinematics.from_arrays(model, rows, still + kinematics.assemble(model), still, still)
        derivatives = np.array([self.derivatives.get(name, (value, 0.0, 0.0)) for name, value in start_values(model).items()])
        value, rate, acceleration = (np.repeat(one[None], len(rows), axis=0) for one in derivatives.T)
        names = list(model.all_drives)
        for k, drive in enumerate(self.drives):
            if drive is not None:
                value[:, names.index(drive)] += lengths[:, k]
        sampled = Sampled(drives=tuple(names), times=rows, value=value, rate=rate, acceleration=acceleration, space="lengths")
        system = compile(model)
        path = path_of(system, rows, sampled)
        try:
            swept = sweep_path(system, path)
        except InputError as error:
            raise InputError(
                f"With the uncertain lengths driven: {error} A length that other bars hold too cannot change alone. "
                "Leave it out."
            ) from None
        if not swept.status.ok:
            raise AnalysisError(
                "Within the tolerances the structure cannot be assembled. Give smaller tolerances, or another pose. "
                f"(Draws are counted as times.) {swept.message}"
            )
        course = Course(t=rows, x=swept.x, v=swept.v, a=swept.a, drive=path.drive, gauge=swept.gauge)
        return motion_of(system, course, sampled.space, swept.status, swept.message)


def _offers(model: Model, place: str, kind: str) -> bool:
    """Whether NAME.kind is a force or strain of the model."""
    tables: dict[str, Mapping[str, Any]] = {
        "force": model.whole.members,
        "drive_force": model.all_drives,
        "strain": model.gauges,
    }
    return place in tables.get(kind, {})


def _command(model: Model, at: Any) -> dict[str, tuple[float, float, float]]:
    """Value, rate and acceleration of every drive at the pose, in the model without errors."""
    if not model.all_drives:
        return {}
    if isinstance(at, tuple):
        trajectory, time = at
        trajectory = model.trajectories[trajectory] if isinstance(trajectory, str) else trajectory
    elif at:
        trajectory, time = Quintic(moves={name: (value, value) for name, value in at.items()}, duration=1.0), 0.0
    else:
        return {name: (value, 0.0, 0.0) for name, value in start_values(model).items()}
    found = kinematics.sample(model, trajectory, [time])
    derivatives = np.stack([found.value[0], found.rate[0], found.acceleration[0]], axis=1)
    return {name: (float(a), float(b), float(c)) for name, (a, b, c) in zip(found.drives, derivatives, strict=True)}
