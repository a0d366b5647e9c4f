"""Runs of the integrators as they are compiled, without names and records: arrays in, arrays out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from kinetruss.dynamics.equations import equations
from kinetruss.dynamics.integrators import control, integrate, start_memory
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.solve.kkt import kinetic, potential, project
from kinetruss.kernels.structure.applied import no_force
from kinetruss.mechanics import compile

__all__ = ["March", "march", "prepared"]


@dataclass
class March:
    """A run: the system, samples x, v, a (times, n, 3), N (times, rows), memory, code, samples done, energy (times,)."""

    system: Any
    times: np.ndarray
    x: np.ndarray
    v: np.ndarray
    a: np.ndarray
    N: np.ndarray
    diagnostics: np.ndarray
    memory: Any
    code: int
    done: int
    energy: np.ndarray
    kinetic: np.ndarray

    def count(self, name: str) -> int:
        return int(getattr(self.memory, name))

    def node(self, name: str) -> np.ndarray:
        return self.x[:, self.system.node_index(name)]


def prepared(model: Any, times: Any, method: Any, events: Any = (), isolated: bool = True, **options: Any) -> tuple[Any, ...]:
    """System, equations, workspace, control, memory at the start, arrays for samples."""
    times = np.array(times, float)
    system = compile(model)
    eq, ws = equations(system, solver=options.pop("solver", "auto"), t_end=times[-1], **options)
    x, v = system.x0.reshape(-1).astype(float), system.velocity0.reshape(-1).astype(float)
    project(eq, ws, times[0], x, v, 1e-14)
    told = control(eq, system, method, (times[0], times[-1]), events=events, isolated=isolated)
    memory = start_memory(eq, times[0], x, v, events=len(events), method=method)
    s, n, r = times.size, x.size, eq.A.size
    samples = m.Samples(times, *np.zeros((3, s, n)), np.zeros((s, r)), np.zeros((s, 0)), np.zeros((s, 6)))
    return system, eq, ws, told, memory, samples


def march(
    model: Any, times: Any, method: Any, events: Any = (), budgets: Any = (10**9,), user: Any = no_force, **options: Any
) -> March:
    """A run over `times`; in calls of so many steps each, the last of `budgets` again and again."""
    system, eq, ws, told, memory, samples = prepared(model, times, method, events, **options)
    first, turn, code = 0, 0, m.PAUSED
    while code == m.PAUSED:
        budget = budgets[min(turn, len(budgets) - 1)]
        code, filled = integrate(eq, ws, user, told, memory, samples.part(first), budget)
        first += filled
        if code == m.UNDETERMINED:
            # nobody here steps over singular positions from outside
            memory.alone, code = 1, m.PAUSED
        turn += 1
    done = slice(0, first)
    moving = np.array([kinetic(eq, ws, x, v) for x, v in zip(samples.x[done], samples.v[done], strict=True)])
    energy = moving + np.array([potential(eq, x) for x in samples.x[done]])
    x, v, a = (part[done].reshape(first, -1, 3) for part in (samples.x, samples.v, samples.a))
    return March(
        system, samples.times[done], x, v, a, samples.N[done], samples.diagnostics[done], memory, code, first, energy, moving
    )
