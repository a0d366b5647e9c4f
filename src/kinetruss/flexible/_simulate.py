"""Simulation of the structure with elastic members, whose actuators follow a trajectory as springs do."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics import inverse, simulate as simulated
from kinetruss.errors import InputError
from kinetruss.flexible._vibration import settled_of
from kinetruss.flexible.structure import Instant, Softness, instants_of
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics import follow, sample
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.arguments import number_of
from kinetruss.model import Bar, Free, Model
from kinetruss.model.links import bends
from kinetruss.results import Simulation
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["simulate"]

TABLE = 4001
"""Instants at which the trajectory is tabulated; in between, cubics with the same rates."""


@one_thread
def simulate(
    model: Model,
    trajectory: Any,
    t_end: float | None = None,
    *,
    damping: float = 0.0,
    load_case: str | None = None,
    stiffness: Mapping[str, float] | None = None,
    rigid: Collection[str] = (),
    **options: Any,
) -> Simulation:
    """Forward dynamics with elastic members; the actuators are springs whose natural lengths follow a trajectory.

    Parameters
    ----------
    trajectory : of driven lengths or pose coordinates, as in `kinematics.follow`. After its end the lengths stay.
    t_end : s; by default its duration.
    damping : s, damping coefficient of every elastic member over its stiffness: c = damping k. A mode of angular frequency w
        has the ratio w damping/2.
    stiffness, rigid : as in `frequencies`.
    options : of `dynamics.simulate` (``samples``, ``times``, ``method``, ``positions``, ...). The default method is DOP853.

    Returns
    -------
    Simulation of a model whose elastic bars are ``kind="elastic"``. The springs of the actuators act as nodal forces on their
    ends: the ``member_force`` of these members is without them. Compare its motion with `kinematics.follow` of the rigid model,
    and with `vibration`, which agrees to first order in the displacements.

    Raises
    ------
    InputError : a drive that is no length; as in `frequencies`. AnalysisError : as in `dynamics.simulate`.

    Notes
    -----
    N = k (l - l0) + c (l' - l0') of every member, with the l0(t) of the trajectory for actuators, whose k follows l0 if it is
    not given: E A/l0, or that of its `Compliance` at l0; large displacements. It starts at rest in the settled state
    of the first instant (first order), unless ``positions`` are given. Steps follow the fastest vibration of the members: short
    runs.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
    ...     bars={"rod": kt.Bar(ends=("O", "A"), kind="driven", mass=0)},
    ... )
    >>> lift = kt.Quintic(moves={"rod": (1.0, 0.9)}, duration=0.1)
    >>> run = kt.flexible.simulate(model, lift, samples=3, stiffness={"rod": 20e3})
    >>> run.motion.position.sel(node="A", axis="y").values[0].round(6).item()  # m: settled under the load, m g/k lower
    -1.001
    """
    delay = number_of(damping, "damping", "s")
    if delay < 0:
        raise InputError(f"damping is {damping} s. Give 0 or more.")
    system = compile(model)
    soft = Softness(stiffness=stiffness or {}, rigid=rigid)
    start = follow(model, trajectory, times=np.array([0.0]))
    (here,) = instants_of(model, inverse(model, start, load_case=load_case, static=False), soft)
    f = soft.flexibility(system, system.x0)
    duration = float(trajectory.duration) if t_end is None else number_of(t_end, "t_end", "s")
    springs = _Springs(system, trajectory, f, delay, soft.stiffness)
    options.setdefault("positions", _settled(system, here))
    return simulated(
        _soft_model(system, model, f, delay),
        duration,
        tasks={name: Free() for name in springs.drives},
        user_force=springs.force,
        load_case=load_case,
        **options,
    )


def _settled(system: System, here: Instant) -> NDArray[np.float64]:
    x = here.x.copy()
    x.reshape(-1)[system.free] += settled_of(here)[0]
    return x[:, : system.dim]


def _soft_model(system: System, model: Model, f: NDArray[np.float64], delay: float) -> Model:
    """The model with elastic bars in place of rigid ones, and with the damping of beams."""
    bars = dict(model.bars)
    for r in np.flatnonzero((system.row_kind == LENGTH) & (system.row_drive < 0) & (f > 0)):
        name = system.members[system.row_member[r]]
        bar, k = bars[name], float(1.0 / f[r])
        mass = None if bar.body is not None else bar.mass
        changes = {"kind": "elastic", "length": None, "natural_length": float(system.row_value[r]), "stiffness": k}
        bars[name] = Bar(**(dict(bar) | changes | {"damping": delay * k, "mass": mass}))
    beams = {
        name: beam.with_(damping=beam.damping + delay) if beam.kind == "elastic" else beam for name, beam in model.beams.items()
    }
    links = {
        name: link.with_(kind="elastic", damping=link.damping + delay) if bends(model, link) else link
        for name, link in model.links.items()
    }
    return model.with_(bars=bars, beams=beams, links=links)


class _Springs:
    """The actuators: forces on their ends at any instant."""

    def __init__(self, system: System, trajectory: Any, f: NDArray[np.float64], delay: float, given: Collection[str]) -> None:
        from scipy.interpolate import CubicHermiteSpline

        rows = np.flatnonzero((system.row_drive >= 0) & (f > 0))
        driven = np.unique(system.row_drive[system.row_drive >= 0])
        if len(rows) < len(driven):
            name = next(system.drives[d] for d in driven if d not in system.row_drive[rows])
            raise InputError(
                f"Drive {name!r} is no length of an elastic member. Give its member a section and a material, or a stiffness."
            )
        t = np.linspace(0.0, float(trajectory.duration), TABLE)
        found, drives = sample(system.given, trajectory, t), system.row_drive[rows]
        self.length = CubicHermiteSpline(t, found.value[:, drives], found.rate[:, drives])
        self.rate, self.last = self.length.derivative(), float(t[-1])
        self.drives = [system.drives[d] for d in drives]
        members = system.row_member[rows]
        self.p, self.q = system.p[members], system.q[members]
        self.f, self.delay, self.dim = f[rows], delay, system.dim
        self.given = np.isin([system.members[i] for i in members], list(given))
        # f = compliance l0 + yielding
        self.per_length, self.fixed = np.nan_to_num(system.compliance[members]), system.yielding[members]

    @property
    def force(self) -> Callable[[float, Any, Any], NDArray[np.float64]]:
        """f(t, x, v) for `dynamics.simulate`."""
        return self._at

    def _at(self, t: float, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
        d, rate = x[self.q] - x[self.p], v[self.q] - v[self.p]
        L = np.sqrt((d * d).sum(axis=1))
        u = d / L[:, None]
        now = min(max(t, 0.0), self.last)
        own = self.rate(now) if 0.0 <= t <= self.last else np.zeros(len(L))
        natural = self.length(now)
        k = 1.0 / np.where(self.given, self.f, self.per_length * natural + self.fixed)
        tension = (k * (L - natural + self.delay * ((u * rate).sum(axis=1) - own)))[:, None] * u
        found = np.zeros((len(x), self.dim))
        np.add.at(found, self.p, tension)
        np.subtract.at(found, self.q, tension)
        return found
