"""Sets up a simulation: equations, a consistent start, a method; all errors of its inputs are found here."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.equations import equations, not_prescribed
from kinetruss.dynamics.joint_loads import jammed, with_bearings
from kinetruss.dynamics.motors import motors_of, refuse_method, with_motors_fixed
from kinetruss.dynamics.simulation_problem import Problem
from kinetruss.dynamics.singular_starts import by_default, refuse_series, singular_note, singular_start
from kinetruss.dynamics.starting import given_positions, given_velocities, start_notes
from kinetruss.dynamics.tracking import tracker_of
from kinetruss.dynamics.user_forces import user_force_of
from kinetruss.elements.kinds import switches
from kinetruss.errors import InputError, ModelError, few, shown
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.kkt import project
from kinetruss.kernels.structure.equations import DENSE
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics.time_tables import table_notes
from kinetruss.mechanics import ByIdentity, System, cached, compile, not_unique_note, rearrange
from kinetruss.mechanics.beam_shapes import rigid_links
from kinetruss.mechanics.coordinates import released
from kinetruss.mechanics.mobility import mobility_at
from kinetruss.mechanics.mode_texts import moves_text
from kinetruss.mechanics.solvers import LARGEST_DENSE
from kinetruss.mechanics.undetermined import refuse_massless
from kinetruss.mechanics.velocities import completed_velocities, named_coordinates
from kinetruss.model import (
    DOP853,
    TRAJECTORY_TASKS,
    Free,
    GivenForce,
    Hold,
    Model,
    Run,
    Taylor,
    Tracking,
    event_faults,
    nearest,
    task_faults,
    trajectory_faults,
)
from kinetruss.model.beam_checks import spin_note
from kinetruss.model.references import unknown_names
from kinetruss.model.tracking import tracking_rules
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


LARGEST = 2000
"""Number of constraints up to which all states of self-stress are computed."""
NO_INPUT = (Free, GivenForce, Hold, *TRAJECTORY_TASKS)
"""Tasks that need no motor."""
TOLERANCE = 1e-13
"""Tolerance of the start, as a fraction of a length and of the largest speed."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Options:
    """The options of a simulation; see `dynamics.simulate`."""

    method: Any = None
    tasks: Mapping[str, Any] | None = None
    trajectory: Any = None
    load_case: str | None = None
    velocities: Mapping[str, Sequence[float]] | ArrayLike | None = None
    positions: ArrayLike | None = None
    user_force: Any = None
    events: Mapping[str, Any] | None = None
    feedback: Tracking | None = None

    def __post_init__(self) -> None:
        for name in ("tasks", "events"):
            if isinstance(given := getattr(self, name), Mapping):
                object.__setattr__(self, name, dict(given))

    @property
    def repeatable(self) -> bool:
        """True if the options are records only, which never change, and no motor has an input: then the set-up can be
        reused.
        """
        own = (self.velocities, self.positions, self.user_force, self.feedback)
        plain = isinstance(self.events, dict | None) and isinstance(self.load_case, str | None)
        has_input = not isinstance(self.tasks, dict | None) or any(
            not isinstance(one, NO_INPUT) for one in (self.tasks or {}).values()
        )
        return plain and not has_input and all(one is None for one in own)

    def _key(self) -> tuple[Hashable, ...]:
        named = (tuple((name, ByIdentity(one)) for name, one in (given or {}).items()) for given in (self.tasks, self.events))
        trajectory = self.trajectory if isinstance(self.trajectory, str) else ByIdentity(self.trajectory)
        return self.load_case, trajectory, ByIdentity(self.method), *named

    def __hash__(self) -> int:
        return hash(self._key())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Options) and self._key() == other._key()


def problem_of(model: Model, t_end: float, options: Options) -> Problem:
    """Set up a simulation to t_end (s).

    Raises
    ------
    InputError : an option cannot be used.
    """
    if options.repeatable:
        return _kept(compile(model), seconds(t_end), options).fresh()
    return _set_up(model, t_end, options)


@cached(4)
def _kept(system: System, t_end: float, options: Options) -> Problem:
    return _set_up(system.given, t_end, options)


def _set_up(model: Model, t_end: float, options: Options) -> Problem:
    """`problem_of` without reuse of an earlier set-up."""
    given = _checked(model, t_end, options)
    run = _with_released(model, given)
    chosen, method = run.method is None, DOP853() if run.method is None else run.method
    shapes, load_case = rigid_links(compile(model)), options.load_case
    system = compile(model) if shapes is None else shapes.system
    x, v = given_positions(system, options.positions), given_velocities(system, options.velocities)
    held = with_motors_fixed(model, run.tasks)
    reduced = released(system, not_prescribed(system, held))
    refuse_massless(reduced, _massive(system), x.reshape(-1, 3))
    eq, ws = equations(system, load_case, held, model.trajectory_of(run), method.solver, t_end)
    eq, ws = with_bearings(system, eq, ws, load_case, held)
    before = x.copy(), v.copy()
    v[np.setdiff1d(np.arange(v.size), eq.free)] = 0.0  # velocities of supports come from their own motion only
    _project(system, eq, ws, x, v)
    completed = completed_velocities(reduced, x, before[1], v, named_coordinates(system, options.velocities))
    if completed is not None:
        before, v = (before[0], completed.copy()), completed
        _project(system, eq, ws, x, v)
    tracker = tracker_of(model, system, given, options.user_force)
    user = user_force_of(system, tracker or options.user_force, x, v, load_case)
    _refuse_jammed(system, eq, ws, user, x, v)
    # held constraints would stop the motors
    free = before[1].copy()
    refuse_method(model, run.tasks, method)
    motors = motors_of(system, eq, ws, user, run.tasks, x, free, t_end)
    v = v if motors is None else free
    notes, attrs = start_notes(system, before, (x, v), float(np.max(np.ptp(x.reshape(-1, 3), axis=0))))
    notes += tuple(filter(None, [table_notes(model, model.trajectory_of(run), *held.values())]))
    unsure = _not_unique(system, reduced, eq, x)
    notes += [not_unique_note(unsure)] if unsure else []
    notes += [] if motors is not None else _still_note(model, system, eq)
    notes += [spins] if (spins := spin_note(model.whole)) else []
    if method.solver == "sparse" and eq.solver == DENSE:
        notes += ["The dense solver is used: only it chooses the independent constraints anew during the motion."]
    found = Problem(
        system=system,
        shapes=shapes,
        eq=eq,
        ws=ws,
        user=user,
        method=method,
        events={**run.events, **_switches(system, run, motors)},
        tasks=dict(run.tasks),
        load_case=load_case,
        x0=x,
        v0=v,
        z0=np.zeros(motors.recorded if motors else 0),
        notes=tuple(notes),
        start_attrs=attrs,
        not_unique=unsure,
        motors=motors,
        tracker=tracker,
    )
    if chosen:
        found = replace(found, method=by_default(found))
    elif isinstance(method, Taylor):
        refuse_series(found)
    found = replace(found, singular=singular_start(found))
    said = singular_note(found) if found.singular and found.singular.near else _soft_note(reduced, eq, x)
    return replace(found, notes=(*found.notes, *said))


def _switches(system: System, run: Run, motors: Any) -> dict[str, Any]:
    """Events of elements, besides those of the run; beside motors, no angles."""
    own = {name: one for name, one in switches(system).items() if name not in run.events}
    return {name: one for name, one in own.items() if motors is None or one.unit != "rad"}


def _checked(model: Model, t_end: float, options: Options) -> Run:
    """The options as a run of the model, with the checks of a run: unknown names, tasks that do not fit their drive."""
    for name, given in (("tasks", options.tasks), ("events", options.events)):
        if given is not None and not isinstance(given, Mapping):
            raise InputError(f"{name} is {shown(given)}. Give name -> record, e.g. {{'M7': kt.Free()}}.")
    for name, task in (options.tasks or {}).items():
        if callable(task):
            raise InputError(
                f"tasks[{name!r}] is a function. Give a record: Free(), Hold(), GivenForce(...), an input of its "
                "motor (StepInput, TableInput, PositionLoop, ...), or a trajectory (Quintic, Spline, ...). Pass your own force "
                "as a function of t, x and v by user_force."
            )
    run = Run(
        analysis="dynamics.simulate",
        t_end=seconds(t_end),
        trajectory=options.trajectory,
        tasks=dict(options.tasks or {}),
        method=options.method,
        load_cases=None if options.load_case is None else (options.load_case,),
        events=dict(options.events or {}),
        feedback=options.feedback,
    )
    if isinstance(run.trajectory, str) and run.trajectory not in model.trajectories:
        raise InputError(f"No trajectory called {run.trajectory!r}. {nearest(run.trajectory, model.trajectories)}")
    moving = model.trajectory_of(run)
    found = [*task_faults(model, run.tasks), *event_faults(model, run.events)]
    if run.feedback is not None:
        found += [*unknown_names(model.whole, run.feedback, ("feedback",)), *tracking_rules(model.whole, run, ())]
    found += [] if moving is None else trajectory_faults(model, moving)
    if found:
        raise ModelError(found)
    return run


def _with_released(model: Model, run: Run) -> Run:
    """The run, with the drives that are fed back released."""
    if run.feedback is None:
        return run
    return run.with_(tasks={**run.tasks, **dict.fromkeys(run.feedback.chosen(model.all_drives, run.tasks), Free())})


def seconds(t_end: Any) -> float:
    """The end of a run, s.

    Raises
    ------
    InputError : not a number or a text such as ``"2 s"``, or not after the start at 0.
    """
    if isinstance(t_end, str):
        t_end = parse(t_end, "time")
    if isinstance(t_end, bool) or not isinstance(t_end, (int, float, np.integer, np.floating)):
        raise InputError(f"t_end is {t_end!r}. Give a number (s).")
    if not (np.isfinite(t_end) and t_end > 0):
        raise InputError(f"t_end is {t_end:g} s, not after the start at 0 s. Give a positive time (s).")
    return float(t_end)


def _massive(system: System) -> NDArray[np.bool_]:
    """Nodes with mass."""
    massive = system.node_mass > 0
    heavy = (system.rods[:, 0] > 0) | (system.rods[:, 3] > 0)
    if system.is_body.any():
        heavy |= system.is_body
    massive[system.p[heavy]] = True
    massive[system.q[heavy]] = True
    if system.continua is not None:
        massive |= system.continua.lump > 0
    return massive


def _project(system: System, eq: Any, ws: Any, x: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Project the start onto the constraints; InputError if no configuration near it satisfies them."""
    good, _, _ = project(eq, ws, 0.0, x, v, TOLERANCE)
    if good and np.isfinite(x).all() and np.isfinite(v).all():
        return
    d = (system.x0[system.q] - system.x0[system.p])[system.row_member[eq.row]]
    off = np.where(eq.kind == LENGTH, np.abs(np.linalg.norm(d, axis=1) - eq.value), -1.0)
    worst = system.part_of(eq.row[int(np.argmax(off))])
    raise InputError(
        "The start cannot be closed: no configuration near it has the lengths of bars and drives; "
        f"the largest error is at {worst}. "
        "Change its length, or move its nodes."
    )


def _refuse_jammed(system: System, eq: Any, ws: Any, user: Any, x: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Raise AnalysisError if a joint jams at the start."""
    if system.model.bearings:
        evaluate(eq, ws, user.call, 0.0, x.copy(), v.copy(), np.empty(x.size), np.empty(len(eq.row)))
        if (error := jammed(system, ws)) is not None:
            raise error


def _still_note(model: Model, system: System, eq: Any) -> list[str]:
    """A note if nothing can move, because all drives are held and no degree of freedom is left."""
    if not len(system.drives) or len(eq.motion_kind) or len(eq.free) > int((~eq.redundant).sum()):
        return []
    names = ", ".join(list(model.all_drives)[:3]) + (" ..." if len(model.all_drives) > 3 else "")
    return [f"Nothing can move: all drives ({names}) are held. Give one a task: Free(), GivenForce(...) or a trajectory."]


def _soft_note(reduced: System, eq: Any, x: NDArray[np.float64]) -> tuple[str, ...]:
    """A note on infinitesimal mechanisms that a self-stress makes stiff, e.g. those of a flat structure normal to its plane."""
    if not eq.redundant.any() or len(eq.free) > LARGEST_DENSE:
        return ()
    there = mobility_at(reduced, x.reshape(-1, 3))
    ways = [moves_text(reduced, mode) for mode, soft in zip(there.mechanisms, there.second_order, strict=True) if soft]
    if not ways:
        return ()
    stiff = "Stiff to second order only, so that small loads cause large motions and the result is uncertain"
    return (f"{stiff}: {few(ways, 3, '; ')}. Connect a node outside the plane by bars, or add a support.",)


def _not_unique(system: System, reduced: System, eq: Any, x: NDArray[np.float64]) -> tuple[str, ...]:
    """Members in a state of self-stress at the start; for a large structure, the redundant ones."""
    if not eq.redundant.any():
        return ()
    rows = eq.row[eq.redundant]
    if len(eq.row) <= LARGEST:
        unsure = rearrange(reduced, x.reshape(-1, 3), reduced.drive_start).not_unique
        rows = np.sort(eq.row)[unsure]
    return tuple(system.parts_of(rows))
