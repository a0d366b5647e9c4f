"""Creates the records of a simulation from the arrays of the integration."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.modes import unwrapped
from kinetruss.dynamics.force_tables import force_arrays, solved_in_space
from kinetruss.dynamics.least_norm import apply_loads, take_sum_forces
from kinetruss.dynamics.motors import motor_histories, motor_names
from kinetruss.dynamics.prescribed import with_bearing_friction
from kinetruss.dynamics.remarks import energy_remark
from kinetruss.errors import few
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.solve.accelerations import couples_along
from kinetruss.kernels.solve.kkt import balance
from kinetruss.kernels.structure.rows import row_forces
from kinetruss.kernels.structure.structure import LENGTH, EndForces, States
from kinetruss.kinematics.motions import Course, motion_of
from kinetruss.kinematics.turns import refined
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.positions import drive_places, drive_values
from kinetruss.mechanics.rigid_motions import scalars_of
from kinetruss.results import Arrays, Axes, Forces, Motion, Simulation, provenance, variable
from kinetruss.results.dynamic_records import happened
from kinetruss.results.wide_tables import drive_unit, force_units

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.integration import Integration
    from kinetruss.dynamics.simulation_problem import Problem
    from kinetruss.mechanics import System


TURN = 2 * np.pi


@dataclass(frozen=True, kw_only=True, eq=False)
class Trace:
    """Good samples: t (s,); x, v, a (s, 3 n); N (s, rows of the system); extra (s, k); diagnostics (s, 6)."""

    t: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    N: NDArray[np.float64]
    extra: NDArray[np.float64]
    diagnostics: NDArray[np.float64]


def simulation_of(work: Integration, trace: Trace) -> Simulation:
    """The record of consecutive samples of a simulation, with its status and message so far."""
    problem, system, status = work.problem, work.problem.system, work.status
    data = _histories(work, trace)
    kept = energy_remark(work, trace.t, data["kinetic_energy"].values, data["energy"].values)
    message = f"{work.message} {kept}".strip() if work.ended else work.message
    passed = work.passed.within(-np.inf, float(trace.t[-1]) if len(trace.t) else -np.inf)
    course = Course(t=trace.t, x=trace.x, v=trace.v, a=trace.a, drive=_turned(work, trace), passed=passed)
    motion = motion_of(system, course, "simulated", status, message)
    forces = _forces(work, motion, trace)
    data |= happened(work.happened())
    method = problem.method
    attrs = {
        "kind": "simulation",
        "method": method.kind,
        "method_options": method.model_dump_json(),
        "solver": problem.solver,
        **problem.start_attrs,
    }
    axes: dict[str, Any] = {"axis": ["x", "y", "z"][: system.dim]}
    if problem.motors is not None:
        axes |= motor_names(problem.motors)
        data |= motor_histories(problem.motors, trace.extra)
    if problem.tracker is not None:
        unit, force = drive_unit(system)[1], force_units(system)[1]
        axes |= {"drive": list(system.drives), **unit, **{k: v for k, v in force.items() if k == "drive_force_unit"}}
        data |= problem.tracker.histories(trace.t, trace.x, trace.v)
    options = {"t_end": work.t_end, "method": method.model_dump(), "load_case": forces.load_case}
    return Simulation(
        data=Arrays(Axes(axes), trace.t, data, attrs).later,
        status=status,
        message=motion.message,
        provenance=provenance(system.given, **options),
        motion=motion,
        forces=forces,
    )


def _turned(work: Integration, trace: Trace) -> tuple[NDArray[np.float64], ...]:
    """Drive histories. Their angles continue those of earlier samples; whole turns are counted from the states between samples.

    The angles of drives with motors are part of the state.
    """
    system, motors, since = work.problem.system, work.problem.motors, work.angles[2]
    begin = float(since[np.isfinite(since)].max(initial=-np.inf))
    whole = refined(trace.t, trace.x, trace.v, trace.a, work.passed, begin)
    t, shape = whole.t, (len(whole.t), len(system.nodes), 3)
    value, rate, second = drive_values(system, whole.x.reshape(shape), whole.v.reshape(shape), whole.a.reshape(shape))
    if not len(t):
        return value, rate, second
    # of each state by itself: turns counted within a block and taken off again would leave round-off
    before, at, angles = work.angles[1], work.angles[2], drive_places(system, whole.x.reshape(shape))
    for r in np.flatnonzero((system.row_kind != LENGTH) & (system.row_drive >= 0)):
        d = system.row_drive[r]
        principal = np.remainder(angles[:, d] + np.pi, TURN) - np.pi
        rates = np.concatenate([[before[d] if np.isfinite(at[d]) else rate[0, d]], rate[:, d]])
        ahead = 0.5 * (rates[1:] + rates[:-1]) * np.diff(np.concatenate([[at[d] if np.isfinite(at[d]) else t[0]], t]))
        steps = np.diff(np.concatenate([[work.angles[0, d]], principal])) - ahead
        turns = np.cumsum(-np.rint(steps / TURN).astype(np.int64))
        value[:, d] = principal + TURN * turns
        work.angles[:, d] = value[-1, d], rate[-1, d], t[-1]
    value, rate, second = value[whole.samples], rate[whole.samples], second[whole.samples]
    if motors is not None:
        own = [system.drives.index(name) for name in motors.names]
        value[:, own] = unwrapped(value[:, own], motors.values(trace.extra), motors.period)
        work.angles[0, own] = value[-1, own]
    return value, rate, second


def _forces(work: Integration, motion: Motion, trace: Trace) -> Forces:
    system = work.problem.system
    loads = case_loads(system, trace.t, work.problem.load_case, rotating=True).at(trace.x)
    loads = _with_user(work.problem, loads, trace)
    states = States(trace.x, trace.v, trace.a)
    if count := len(system.model.bearings):
        couple, eq = np.empty((len(trace.t), count, 3)), work.problem.eq
        couples_along(eq, trace.t, trace.x, trace.v, trace.a, np.ascontiguousarray(trace.N[:, eq.row]), couple)
        rubbed = with_bearing_friction(system, loads, trace.x.reshape(len(trace.t), -1, 3), couple)
        solved = solved_by(system, rubbed, states, trace.N) | {"bearing": couple}
    else:
        solved = solved_in_space(system, loads, states, lambda pushed, space: solved_by(system, pushed, space, trace.N))
    unsure, attrs = list(work.problem.not_unique), dict[str, Any]()
    if (shapes := work.problem.shapes) is not None:  # what rows do is the work of the beams of links
        solved["joint"][:, shapes.chords] = 0.0
        if undecided := [name for name in shapes.names if f"link {name}" in unsure]:
            attrs["undecided"] = undecided
        else:
            solved["mode_force"] = shapes.mode_forces(trace.N)
        solved["N"], system = trace.N[:, : shapes.rows[0, 0]], compile(system.given)
    data = force_arrays(system, motion, loads, solved, at_rest=False)
    data.attrs.update({"kind": "forces", "load_case": loads.name, "not_unique": unsure, "at_rest": 0, **attrs})
    return Forces(
        data=data.later,
        status=motion.status,
        message=motion.message,
        provenance=provenance(system.given, load_case=loads.name),
        motion=motion,
        load_case=loads.name,
    )


def solved_by(system: System, loads: Loads, states: States, N: NDArray[np.float64]) -> dict[str, Any]:
    """Joint forces and the rest at nodes, as `forces_of` takes them, of solved states and row forces N (times, rows)."""
    count = len(states.x)
    joint, rest = allocate((count, len(system.members), 2, 3), (count, system.x0.size))
    apply_loads(system, loads, states, EndForces(joint, rest))
    p, q = (3 * ends[system.row_member] for ends in (system.p, system.q))
    row_forces(system.row_member, system.row_kind, p, q, states.x, N, joint, rest)
    take_sum_forces(system, states.x, N, rest)
    return {"x": states.x, "v": states.v, "a": states.a, "N": N, "joint": joint, "rest": rest}


def _with_user(problem: Problem, loads: Loads, trace: Trace) -> Loads:
    """The loads, with the user's force as one more load at each node on which it acts."""
    user = problem.user.own
    if not user.given:
        return loads
    push = np.array([user.at(*one) for one in zip(trace.t, trace.x, trace.v, strict=True)])
    push = push.reshape(len(push), len(problem.system.nodes), 3)
    nodes = np.flatnonzero(np.abs(push).max(axis=(0, 2), initial=0.0) > 0)
    return replace(
        loads,
        loads=(*loads.loads, *(f"user force on {problem.system.nodes[i]}" for i in nodes)),
        node=np.concatenate([loads.node, nodes]),
        force=np.concatenate([loads.force, push[:, nodes]], axis=1),
    )


def _histories(work: Integration, trace: Trace) -> dict[str, Any]:
    """Energies, momenta, extra states and diagnostics of the integration."""
    books, unknown = _books(work.problem, trace)
    kinetic, potential, momentum, spin = books[:, 0], books[:, 1], books[:, 2:5], books[:, 5:]
    time, dim = ("time",), work.problem.system.dim
    found = {
        "energy": variable(time, kinetic + potential, "J", "kinetic and potential energy"),
        "kinetic_energy": variable(time, kinetic, "J", "kinetic energy"),
        "potential_energy": variable(
            time, potential, "J", "potential energy of weight, of elastic bars, springs, membranes and solids"
        ),
        "momentum": variable((*time, "axis"), momentum[:, :dim], "kg m/s", f"linear momentum{unknown}"),
    }
    about = ("time",) if dim == 2 else ("time", "axis")
    turning = spin[:, 2] if dim == 2 else spin
    found["angular_momentum"] = variable(about, turning, "kg m^2/s", f"moment of momentum about the origin{unknown}")
    for k, (name, unit, words) in enumerate(work.problem.extra):
        found[name] = variable(time, trace.extra[:, k], unit, words)
    for k, (name, unit, words) in enumerate(DIAGNOSTICS):
        found[name] = variable(time, trace.diagnostics[:, k], unit, words)
    return found


def _books(problem: Problem, trace: Trace) -> tuple[NDArray[np.float64], str]:
    """Energies and momenta (times, 8) as of `balance`, and why the momenta are not known, NaN.

    A scalar is no place, and its mass times its rate no momentum along x: of a rotation it is one about z, of others nobody
    can say.
    """
    system, books = problem.system, np.empty((len(trace.t), 8))
    balance(problem.eq, problem.ws, trace.x, trace.v, books)
    scalars = scalars_of(system)
    if not len(scalars.all):
        return books, ""
    if unknown := scalars.not_known(system):
        books[:, 2:] = np.nan
        named = few([repr(name) for name in unknown], 1)
        return books, f"; not known: the scalar {named} has a mass, and nothing says what it moves along or about"
    placed, without = trace.v.copy(), np.empty_like(books)
    placed[:, 3 * scalars.all] = 0.0
    balance(problem.eq, problem.ws, trace.x, placed, without)
    books[:, 2:] = without[:, 2:]
    books[:, 7] += trace.v[:, 3 * scalars.rotations] @ system.node_mass[scalars.rotations]
    return books, ""


DIAGNOSTICS = (
    ("step_size", "s", "size of the step at the sample"),
    ("smallest_pivot", "", "smallest scaled pivot of the equations (0 is singular)"),
    ("constraint_error", "", "largest error of a length before the projection of the last step, share of it"),
    ("steps", "", "steps so far"),
    ("rejected", "", "rejected steps so far"),
    ("evaluations", "", "evaluations of the equations so far"),
)
