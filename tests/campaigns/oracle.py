"""Random trusses and mechanisms against dense solvers of this script's own (NumPy, SciPy): inverse, forward, linear statics.

    python tests/campaigns/oracle.py --inverse 60 --forward 60 --linear 300 --seed 1 --out build/oracle.jsonl

A line of the output is a case: match, announced (the product said that it may be wrong, or refused what is wrong), unsure
(the reference does not know itself), MISMATCH (wrong without a word), FALSE ALARM (refused though well posed), TRACEBACK, HANG.
Exit 1 on a mismatch, traceback or hang, and where the count was not finished.
"""

from __future__ import annotations

import argparse
import collections
import json
import signal
import sys
import time
import traceback
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import lu_factor, lu_solve

import kinetruss as kt

SURE = 1e-6
"""Relative error up to which a number counts as right."""

HANG = 60
"""Seconds of processor time after which a case is given up."""

ATOL = 20 * 1e-11
"""Velocities (m/s) that some steps may lose by the absolute tolerance of the product's default."""

KINDS = ("linear", "inverse", "forward")


class Hang(BaseException):
    """A case took too long."""


@dataclass
class Truss:
    """Nodes (n, dim), supports, bars as pairs; per bar: kind, mass, stiffness, natural length, area; lumps, loads, gravity."""

    x: np.ndarray
    held: int
    ends: list[tuple[int, int]]
    mass: np.ndarray
    lump: np.ndarray
    gravity: np.ndarray
    force: np.ndarray
    size: float
    rate: float
    kinds: list[str] = field(default_factory=list)
    k: np.ndarray = field(default_factory=lambda: np.zeros(0))
    rest: np.ndarray = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        self.kinds = ["rigid"] * len(self.ends)
        self.k, self.rest = np.zeros(len(self.ends)), np.zeros(len(self.ends))

    def without(self, j: int) -> None:
        del self.ends[j], self.kinds[j]
        self.mass, self.k, self.rest = (np.delete(one, j) for one in (self.mass, self.k, self.rest))

    def added(self, a: int, b: int, kind: str = "rigid", mass: float = 0.0, k: float = 0.0, rest: float = 0.0) -> None:
        self.ends.append((a, b))
        self.kinds.append(kind)
        for name, value in (("mass", mass), ("k", k), ("rest", rest)):
            setattr(self, name, np.append(getattr(self, name), value))

    def length(self, j: int) -> float:
        a, b = self.ends[j]
        return float(np.linalg.norm(self.x[b] - self.x[a]))


def determinate(rng: np.random.Generator) -> Truss:
    """Every node beyond the supports held by as many bars as axes; sizes, masses and loads over many decades.

    In one case of four a node stands nearly in the line or plane of its feet.
    """
    dim = int(rng.integers(2, 4))
    count = int(rng.integers(4, 18))
    x = list(np.eye(dim)[:dim] + 0.1 * rng.uniform(-1, 1, (dim, dim)))
    flat = 10.0 ** rng.uniform(-8, -2) if rng.random() < 0.25 else 0.0
    odd = int(rng.integers(dim, dim + count))
    ends: list[tuple[int, int]] = []
    while len(x) < dim + count:
        k = len(x)
        feet = rng.choice(np.arange(max(0, k - 6), k), dim, replace=False)
        corner = np.array([x[i] for i in feet])
        at = corner.mean(axis=0) + rng.uniform(-1, 1, dim)
        if flat and k == odd:
            sizes, axes = np.linalg.svd(corner[1:] - corner[0])[1:]
            if sizes[-1] < 0.1:
                flat = 0.0
                continue
            at = rng.dirichlet(np.ones(dim)) @ corner + flat * axes[-1]
        arms = at - corner
        far = np.linalg.norm(arms, axis=1)
        good = far.min() > 0.2 and min(np.linalg.norm(at - one) for one in x) > 0.1
        if good and ((k == odd and flat) or abs(np.linalg.det(arms / far[:, None])) > 0.12):
            x.append(at)
            ends += [(int(i), k) for i in feet]
        elif flat and k == odd and rng.random() < 0.02:
            flat = 0.0
    size = 10.0 ** rng.uniform(-3, 3) if rng.random() < 0.5 else 1.0
    unit = 10.0 ** rng.uniform(-5, 5) if rng.random() < 0.5 else 1.0
    rate = 10.0 ** rng.uniform(-1.5, 1.5)
    spread = rng.choice([0.3, 1.0, 4.0])
    mass = unit * 10.0 ** rng.uniform(-spread, spread, len(ends))
    lump = np.where(rng.random(len(x)) < 0.4, unit * 10.0 ** rng.uniform(-spread, spread, len(x)), 0.0)
    way = rng.standard_normal(dim)
    gravity = size * rate**2 * way / np.linalg.norm(way) if rng.random() < 0.8 else np.zeros(dim)
    force = np.zeros((len(x), dim))
    for i in rng.choice(np.arange(dim, len(x)), min(3, count), replace=False):
        force[i] = unit * size * rate**2 * rng.standard_normal(dim)
    return Truss(np.array(x) * size, dim, ends, mass, lump, gravity, force, size, rate)


def model_of(truss: Truss, area: np.ndarray | None = None, E: float = 1.0) -> kt.Model:
    """The same for the product."""
    bars = {}
    for j, (a, b) in enumerate(truss.ends):
        fields: dict[str, Any] = {"ends": (f"N{a}", f"N{b}"), "kind": truss.kinds[j], "mass": float(truss.mass[j])}
        if truss.kinds[j] == "elastic":
            fields |= {"stiffness": float(truss.k[j]), "natural_length": float(truss.rest[j])}
        elif area is not None:
            fields["section"] = kt.General(area=float(area[j]), I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)
            fields["material"] = kt.Material(E=E, density=0)
        bars[f"b{j}"] = kt.Bar(**fields)
    nodes = {f"N{i}": kt.Node(at=tuple(map(float, at)), mass=float(truss.lump[i])) for i, at in enumerate(truss.x)}
    loads = {f"F{i}": kt.NodalForce(node=f"N{i}", force=tuple(map(float, f))) for i, f in enumerate(truss.force) if f.any()}
    gravity = tuple(map(float, truss.gravity))
    return kt.Model(nodes=nodes, fixed=[f"N{i}" for i in range(truss.held)], bars=bars, gravity=gravity, loads=loads)


class Dense:
    """Mechanics of a truss in free coordinates, all matrices full: M, rows J of unit size, forces, accelerations.

    twin : index of a bar that the last one doubles, or -1: both are one row here, and what it carries is their sum.
    """

    def __init__(self, truss: Truss, twin: int = -1) -> None:
        self.truss, self.dim = truss, truss.x.shape[1]
        self.A, self.B = np.array(truss.ends).T
        self.twin, rigid = twin, [j for j, kind in enumerate(truss.kinds) if kind != "elastic"]
        self.rows = np.array(rigid[:-1] if twin >= 0 else rigid)
        self.springs = np.array([j for j, kind in enumerate(truss.kinds) if kind == "elastic"], int)
        self.first = truss.held * self.dim
        one = np.diag(truss.lump)
        for (a, b), m in zip(truss.ends, truss.mass, strict=True):
            one[[a, b], [a, b]] += m / 3
            one[[a, b], [b, a]] += m / 6
        self.own = one
        self.M = np.kron(one, np.eye(self.dim))[self.first :, self.first :]

    def placed(self, q: np.ndarray, still: np.ndarray) -> np.ndarray:
        found = still.reshape(-1).copy()
        found[self.first :] = q
        return found.reshape(-1, self.dim)

    def J(self, x: np.ndarray) -> np.ndarray:
        d = x[self.B[self.rows]] - x[self.A[self.rows]]
        u = d / np.linalg.norm(d, axis=1, keepdims=True)
        found = np.zeros((len(self.rows), *x.shape))
        r = np.arange(len(self.rows))
        found[r, self.A[self.rows]] -= u
        found[r, self.B[self.rows]] += u
        return found.reshape(len(r), -1)[:, self.first :]

    def bend(self, x: np.ndarray, v: np.ndarray) -> np.ndarray:
        """What J a must be where lengths do not change at accelerated rates: minus the turning part of the second rate."""
        d, w = (y[self.B[self.rows]] - y[self.A[self.rows]] for y in (x, v))
        L = np.linalg.norm(d, axis=1)
        return -(np.sum(w * w, axis=1) - (np.sum(d * w, axis=1) / L) ** 2) / L

    def force(self, x: np.ndarray) -> np.ndarray:
        f = self.truss.force + self.own.sum(axis=1)[:, None] * self.truss.gravity
        for j in self.springs:
            d = x[self.B[j]] - x[self.A[j]]
            L = np.linalg.norm(d)
            pull = self.truss.k[j] * (L - self.truss.rest[j]) * d / L
            f[self.A[j]] += pull
            f[self.B[j]] -= pull
        return f.reshape(-1)[self.first :]

    def carried(self, tension: np.ndarray) -> np.ndarray:
        """Tensions of all bars as forces of the rows."""
        found = tension.copy()
        if self.twin >= 0:
            found[self.twin] += found[-1]
        return found[self.rows]

    def accelerations(self, x: np.ndarray, v: np.ndarray, exact: bool = False) -> tuple[np.ndarray, np.ndarray]:
        """a and tensions N from [[M, J^T], [J, 0]], scaled by the masses; `exact`: refined in extended precision."""
        J, m = self.J(x), np.sqrt(np.diag(self.M))
        Js = J / m
        row = np.linalg.norm(Js, axis=1, keepdims=True)
        Js = Js / row
        zero = np.zeros((len(Js), len(Js)))
        K = np.block([[self.M / m[:, None] / m, Js.T], [Js, zero]])
        right = np.concatenate([self.force(x) / m, self.bend(x, v) / row[:, 0]])
        factors = lu_factor(K, check_finite=False)
        y = lu_solve(factors, right, check_finite=False)
        y += lu_solve(factors, right - K @ y, check_finite=False)
        if exact:  # next to singular positions the matrix alone takes all digits
            wide = K.astype(np.longdouble)
            for _ in range(8):
                y += lu_solve(factors, (right - wide @ y).astype(float), check_finite=False)
        return y[: len(m)] / m, y[len(m) :] / row[:, 0]

    def inert(self) -> bool:
        """True if a node has neither mass nor a row that takes it along."""
        without = (self.own.diagonal() == 0)[self.truss.held :]
        rows = np.abs(self.J(self.truss.x)).sum(axis=0).reshape(-1, self.dim)
        return bool(np.any(without & (rows.sum(axis=1) == 0)))

    def energy(self, x: np.ndarray, v: np.ndarray) -> tuple[float, float]:
        L = np.linalg.norm(x[self.B[self.springs]] - x[self.A[self.springs]], axis=1)
        stored = 0.5 * float(np.sum(self.truss.k[self.springs] * (L - self.truss.rest[self.springs]) ** 2))
        still = -float(self.own.sum(axis=1) @ (x @ self.truss.gravity)) - float(np.sum(self.truss.force * x))
        return 0.5 * float(np.einsum("ia,ij,ja", v, self.own, v)), stored + still

    def least(self, x: np.ndarray) -> float:
        """The smallest singular value of the rows, of the largest."""
        values = np.linalg.svd(self.J(x), compute_uv=False)
        return float(values[-1] / values[0])


def off(found: np.ndarray, exact: np.ndarray, unit: float = 0.0) -> float:
    """Largest difference, of the largest number, which counts as no less than a unit."""
    top = max(float(np.abs(exact).max(initial=0.0)), unit)
    return float(np.abs(found - exact).max(initial=0.0)) / (top or 1.0)


def worse(errors: dict[str, float], name: str, value: float) -> None:
    """Keep the larger error; what is no number is infinitely wrong."""
    errors[name] = max(errors[name], value) if np.isfinite(value) else np.inf


def verdict(errors: dict[str, float], said: str, allowed: float) -> tuple[str, str]:
    """Outcome and what to write of it, from relative errors against what the reference itself is good for."""
    text = " ".join(f"{name} {value:.1e}" for name, value in errors.items()) + f" allowed {allowed:.1e}; said {said[:200]!r}"
    if not all(np.isfinite(value) for value in errors.values()):
        return "MISMATCH", f"not finite: {text}"
    worst = max(errors.values())
    if worst <= SURE:
        return "match", text
    if worst <= allowed:
        return "unsure", text
    return ("announced" if said.strip() else "MISMATCH"), text


def linear(rng: np.random.Generator) -> tuple[str, str]:
    """Determinate and redundant trusses of many areas, some with a bar too few, against extended precision."""
    truss = determinate(rng)
    count = len(truss.x)
    for _ in range(int(rng.integers(0, 5))):
        a, b = (int(i) for i in rng.choice(count, 2, replace=False))
        if b >= truss.held and (a, b) not in truss.ends and (b, a) not in truss.ends:
            truss.added(min(a, b), max(a, b), mass=float(truss.mass[0]))
    if rng.random() < 0.2:
        truss.without(int(rng.integers(len(truss.ends))))
    area = 1e-4 * truss.size**2 * 10.0 ** rng.uniform(0, rng.choice([0.0, 3.0, 6.0, 9.0]), len(truss.ends))
    E = 10.0 ** rng.uniform(6, 12)
    dense = Dense(truss)
    J = dense.J(truss.x)
    length = np.array([truss.length(j) for j in range(len(truss.ends))])
    values = np.linalg.svd(J, compute_uv=False)
    sigma = float(values[J.shape[1] - 1] / values[0]) if len(values) >= J.shape[1] else 0.0
    load = truss.force.copy()
    for (a, b), m in zip(truss.ends, truss.mass, strict=True):
        load[[a, b]] += 0.5 * m * truss.gravity
    load += truss.lump[:, None] * truss.gravity
    f = load.reshape(-1)[dense.first :]
    try:
        found = kt.statics.linear(model_of(truss, area, E))
    except kt.KinetrussError as error:
        return ("announced" if sigma < 1e-8 else "FALSE ALARM"), f"sigma {sigma:.1e}: {error}"
    if sigma < 1e-11:
        return ("announced" if found.message else "MISMATCH"), f"a mechanism (sigma {sigma:.1e}) was answered: {found.message}"
    N, u, rate = _mixed(J, length / (E * area), f)
    errors = {"N": off(found.member_force.values, N), "u": off(found.displacement.values[truss.held :].reshape(-1), u)}
    return verdict(errors, found.message, 100 * rate + 1e-14 / sigma)


def _mixed(J: np.ndarray, soft: np.ndarray, f: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """Forces and displacements from [[soft, J], [J^T, 0]], all pivots full, refined in extended precision; the last change."""
    unit = soft.max()
    count = len(soft)
    K = np.block([[np.diag(soft / unit), J], [J.T, np.zeros((J.shape[1],) * 2)]])
    wide = K.astype(np.longdouble)
    right = np.concatenate([np.zeros(count), f]).astype(np.longdouble)
    U, s, Vt = np.linalg.svd(K)
    y, last = np.zeros(len(K), np.longdouble), np.inf
    for _ in range(40):
        change = Vt.T @ ((U.T @ (right - wide @ y).astype(float)) / s)
        y = y + change
        size = max(
            np.abs(change[:count]).max() / np.abs(y[:count]).max(), np.abs(change[count:]).max() / np.abs(y[count:]).max()
        )
        if size <= 1e-15 or size > 0.5 * last:
            break
        last = size
    return y[:count].astype(float), -(y[count:] * unit).astype(float), float(size)


def quintic(s: float, T: float, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values and second rates of a rise from a to b in T at the share s of the time; the first rate is found alike."""
    return a + (b - a) * (10 * s**3 - 15 * s**4 + 6 * s**5), (b - a) * (60 * s - 180 * s**2 + 120 * s**3) / T**2


def inverse(rng: np.random.Generator) -> tuple[str, str]:
    """Lengths of some bars driven: motion by Newton's method in small steps of this script, forces by balance."""
    truss = determinate(rng)
    chosen = np.sort(rng.choice(len(truss.ends), int(rng.integers(1, 4)), replace=False))
    for j in chosen:
        truss.kinds[j] = "driven"
    doubled = rng.random() < 0.2
    still = next(j for j in range(len(truss.ends)) if j not in chosen)
    if doubled:
        truss.added(*truss.ends[still], mass=float(truss.mass[still]))
    dense = Dense(truss, still if doubled else -1)
    start = np.array([truss.length(j) for j in dense.rows])
    goal = start.copy()
    # moves that a badly conditioned truss can follow
    goal[chosen] *= 1 + min(0.05, dense.least(truss.x)) * rng.uniform(-1, 1, len(chosen))
    T = rng.uniform(0.3, 2.0) / truss.rate
    samples, steps = 5, 160
    moves = {f"b{j}": (float(start[j]), float(goal[j])) for j in chosen}
    model = model_of(truss)
    states, least = _followed(dense, start, goal, T, steps, samples)
    try:
        motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=T), samples=samples)
        forces = kt.dynamics.inverse(model, motion)
    except kt.KinetrussError as error:
        return ("FALSE ALARM" if len(states) == samples and least > 1e-4 else "announced"), f"least {least:.1e}: {error}"
    if len(states) < samples:
        return "unsure", f"the reference stopped after {len(states)} samples; {motion.message}"
    errors = {"x": 0.0, "v": 0.0, "a": 0.0, "N": 0.0}
    for i, (x, v, a) in enumerate(states):
        names = ("position", "velocity", "acceleration")
        place, speed, rise = (motion.data[name].values[i].reshape(-1)[dense.first :] for name in names)
        # balance at the product's own states: what their errors cost is not counted twice
        there = dense.placed(place, x)
        N = np.linalg.lstsq(dense.J(there).T, dense.force(there) - dense.M @ rise, rcond=1e-13)[0]
        worse(errors, "x", float(np.abs(place - x.reshape(-1)[dense.first :]).max()) / truss.size)
        worse(errors, "v", float(np.abs(speed - v).max()) * T / truss.size)
        worse(errors, "a", float(np.abs(rise - a).max()) / max(float(np.abs(a).max()), truss.size / T**2))
        worse(errors, "N", off(dense.carried(forces.member_force.values[i]), N))
    return verdict(errors, motion.message + forces.message, SURE + 1e-14 / least**3)


def _followed(
    dense: Dense, start: np.ndarray, goal: np.ndarray, T: float, steps: int, samples: int
) -> tuple[list[tuple[np.ndarray, np.ndarray, np.ndarray]], float]:
    """States (x, v, a) at the samples as far as they are reached, and the least singular value on the way."""
    x, out, least, limit = dense.truss.x.copy(), [], np.inf, 0.1 * dense.truss.size
    for k in range(steps + 1):
        s = k / steps
        want, second = quintic(s, T, start, goal)
        before = x
        for _ in range(50):
            d = x[dense.B[dense.rows]] - x[dense.A[dense.rows]]
            left = want - np.linalg.norm(d, axis=1)
            change = np.linalg.lstsq(dense.J(x), left, rcond=1e-12)[0]
            if np.abs(change).max() <= 1e-15 * dense.truss.size:
                break
            change *= min(1.0, limit / np.abs(change).max())
            x = dense.placed(x.reshape(-1)[dense.first :] + change, x)
        if np.abs(left / want).max() > 1e-10 or np.abs(x - before).max() > limit:
            break  # out of reach, or over to another branch
        least = min(least, dense.least(x))
        if k % (steps // (samples - 1)) == 0:
            first = (goal - start) * (30 * s**2 - 60 * s**3 + 30 * s**4) / T
            J = dense.J(x)
            v = np.linalg.lstsq(J, first, rcond=1e-13)[0]
            a = np.linalg.lstsq(J, dense.bend(x, dense.placed(v, np.zeros_like(x))) + second, rcond=1e-13)[0]
            out.append((x.copy(), v, a))
    return out, least


def forward(rng: np.random.Generator) -> tuple[str, str]:
    """A truss that a bar or more let go, some of them springs: states by SciPy, accelerations and forces at the product's."""
    truss = determinate(rng)
    for j in sorted(rng.choice(len(truss.ends), int(rng.integers(1, 4)), replace=False))[::-1]:
        if rng.random() < 0.4:
            truss.kinds[j] = "elastic"
            truss.k[j] = float(np.median(truss.mass)) * truss.rate**2 * 10.0 ** rng.uniform(0, 1.5)
            truss.rest[j] = truss.length(j) * rng.uniform(0.9, 1.1)
        elif len(truss.ends) > 2:
            truss.without(j)
    doubled = rng.random() < 0.2 and truss.kinds[0] == "rigid"
    if doubled:
        truss.added(*truss.ends[0], mass=float(truss.mass[0]))
    dense = Dense(truss, 0 if doubled else -1)
    method = [None, None, kt.DOP853(), kt.Taylor(), kt.DOP853(solver="dense"), kt.DOP853(solver="sparse")][int(rng.integers(6))]
    T, samples = rng.uniform(0.3, 1.2) / truss.rate, 5
    try:
        run = kt.dynamics.simulate(model_of(truss), T, samples=samples, method=method)
    except kt.KinetrussError as error:
        due = dense.least(truss.x) <= 1e-3 or dense.inert()
        return ("announced" if due else "FALSE ALARM"), str(error)
    names = [f"N{i}" for i in range(len(truss.x))]
    place, speed, rise = (run.motion.data[name].sel(node=names).values for name in ("position", "velocity", "acceleration"))
    tension = run.forces.data.member_force.sel(member=[f"b{j}" for j in range(len(truss.ends))]).values
    errors = {"length": 0.0, "energy": 0.0, "a": 0.0, "N": 0.0}
    energies = np.array([dense.energy(x, v) for x, v in zip(place, speed, strict=True)])
    size = max(float(energies[:, 0].max()), 1e-9 * float(np.abs(energies).max()), 1e-300)
    # round-off of a potential energy where next to nothing moves, and the absolute tolerance of velocities
    rounding = 1e-13 * float(np.abs(energies).max()) + ATOL * float(np.sqrt(2 * energies[:, 0].max() * dense.own.sum()))
    errors["energy"] = max(0.0, float(np.abs(energies.sum(axis=1) - energies[0].sum()).max()) - rounding) / size
    least = min(dense.least(x) for x in place)
    for x, v, a, got in zip(place, speed, rise, tension, strict=True):
        d = x[dense.B[dense.rows]] - x[dense.A[dense.rows]]
        start = np.array([truss.length(j) for j in dense.rows])
        worse(errors, "length", float(np.abs(np.linalg.norm(d, axis=1) / start - 1).max()))
        exact, N = dense.accelerations(x, v, exact=True)
        worse(errors, "a", off(a.reshape(-1)[dense.first :], exact, 1e-6 * truss.size * truss.rate**2))
        worse(errors, "N", off(dense.carried(got), N, 1e-9 * float(np.abs(dense.force(x)).max(initial=0.0))))
    allowed = SURE + 1e-13 / least
    place_error, own = _integrated(dense, truss, T, samples, place)
    errors["x"] = place_error
    return verdict(errors, run.message, max(allowed, 300 * own))


def _integrated(dense: Dense, truss: Truss, T: float, samples: int, place: np.ndarray) -> tuple[float, float]:
    """Difference of positions, of the size, from SciPy's DOP853, and how far that is from itself at another tolerance."""
    free = len(dense.M)
    scale = np.concatenate([np.full(free, truss.size), np.full(free, truss.size * truss.rate)])
    start = np.concatenate([truss.x.reshape(-1)[dense.first :], np.zeros(free)]) / scale
    calls = [0]

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        calls[0] += 1
        if calls[0] > 3000:
            raise StopIteration
        q, v = (y * scale)[:free], (y * scale)[free:]
        x = dense.placed(q, truss.x)
        return np.concatenate([v, dense.accelerations(x, dense.placed(v, np.zeros_like(x)))[0]]) / scale

    found = []
    try:
        for tolerance in (1e-11, 1e-9):
            calls[0] = 0
            run = solve_ivp(rates, (0, T), start, "DOP853", t_eval=np.linspace(0, T, samples), rtol=tolerance, atol=tolerance)
            found.append(run.y[:free].T)
        own = float(np.abs(found[0] - found[1]).max())
    except (StopIteration, ValueError, np.linalg.LinAlgError):
        return 0.0, 0.0  # the reference does not get through; the invariants stand
    return float(np.abs(place.reshape(samples, -1)[:, dense.first :] / truss.size - found[0]).max()), own


def judged(kind: str, seed: int, i: int) -> dict[str, Any]:
    """One case by its number; the same numbers give the same case."""
    rng = np.random.default_rng([seed, KINDS.index(kind), i])
    began = time.process_time()
    try:
        outcome, said = {"linear": linear, "inverse": inverse, "forward": forward}[kind](rng)
    except Hang:
        outcome, said = "HANG", f"no answer in {HANG} s of processor time"
    except Exception:  # noqa: BLE001 (whatever it is, it is what is looked for)
        outcome, said = "TRACEBACK", traceback.format_exc()[-1500:]
    return {"kind": kind, "case": i, "outcome": outcome, "said": said, "seconds": round(time.process_time() - began, 3)}


def campaign(counts: dict[str, int], seed: int, out: Path | None = None, wall: float = np.inf) -> collections.Counter[str]:
    """Outcomes counted by kind, for a number of cases of each; every case is a line of `out`."""
    found: collections.Counter[str] = collections.Counter()
    began, log = time.monotonic(), None if out is None else out.open("w")
    for kind in KINDS:
        for i in range(counts.get(kind, 0)):
            if time.monotonic() - began > wall:
                found["UNFINISHED"] += counts[kind] - i
                break
            row = _watched(kind, seed, i)
            found[f"{kind} {row['outcome']}"] += 1
            if log is not None:
                log.write(json.dumps(row) + "\n")
                log.flush()
            if row["outcome"].isupper():
                print(f"{kind} {i} (seed {seed}): {row['outcome']}: {row['said']}", file=sys.stderr, flush=True)
            if i % 50 == 49:
                print(f"{time.monotonic() - began:.0f} s: {dict(found)}", file=sys.stderr, flush=True)
    if log is not None:
        log.close()
    return found


def _watched(kind: str, seed: int, i: int) -> dict[str, Any]:
    """A case, given up where it hangs (where the system has such clocks)."""
    if not hasattr(signal, "setitimer"):
        return judged(kind, seed, i)

    def late(*_: Any) -> None:
        raise Hang

    before = signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, HANG)
    try:
        return judged(kind, seed, i)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def bad(found: collections.Counter[str]) -> dict[str, int]:
    """What ends a campaign with exit 1."""
    words = ("MISMATCH", "TRACEBACK", "HANG", "UNFINISHED")
    return {name: count for name, count in found.items() if name.endswith(words)}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for kind, count in (("inverse", 60), ("forward", 60), ("linear", 300)):
        parser.add_argument(f"--{kind}", type=int, default=count, help=f"cases (default: {count})")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, help="file of lines, one a case")
    parser.add_argument("--wall", type=float, default=np.inf, help="seconds after which it stops, unfinished")
    options = parser.parse_args()
    if options.out is not None:
        options.out.parent.mkdir(parents=True, exist_ok=True)
    found = campaign({kind: getattr(options, kind) for kind in KINDS}, options.seed, options.out, options.wall)
    print(json.dumps(dict(sorted(found.items())), indent=2))
    return 1 if bad(found) else 0


if __name__ == "__main__":
    sys.exit(main())
