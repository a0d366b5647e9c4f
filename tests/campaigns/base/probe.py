"""What the engines of a revision assemble for a case, by its own modules: BASE is asked by its own copy of this file.

    python tests/campaigns/base/probe.py FOLDER --seed N --count N --runs N

All is by names: coordinates NODE.axis, rows by what they hold. Rows are divided by the size of their gradient. Differences
are measured by the sums of the absolute values of what is added up at a node (`Question.size`).
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from answers import SOLVED, Answer, Part, asked
from asking import main
from models import Case

from kinetruss.dynamics.equations import equations
from kinetruss.dynamics.least_norm import apply_loads as left_over
from kinetruss.dynamics.linear_state import moving_forces
from kinetruss.kernels.solve import accelerations, kkt
from kinetruss.kernels.structure.applied import applied, no_force
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, EndForces, States
from kinetruss.kernels.sweep.forces import energies
from kinetruss.mechanics import GREEN, System, compile, jacobian, measured
from kinetruss.mechanics.balance import Balance, balance_of, balanced_rows, measure_forces, row_tensions, sum_stiffness
from kinetruss.mechanics.elements import material_stiffness
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.matrices import bar_laws, mass_matrix, tangents
from kinetruss.mechanics.rows import row_derivatives
from kinetruss.mechanics.tables import nodal_loads, structure_of
from kinetruss.statics.small_displacements import flexibility, stiff_rows

SOLVERS = ("dense", "sparse", "sweep")
SHIFT = 1e-9
"""Relative change of positions and velocities by which the condition of what is solved is found."""


class Question:
    """A case as arrays: x, v, a (n, 3), names `at` of the flat coordinates."""

    def __init__(self, case: Case) -> None:
        self.case, self.system = case, compile(case.model)
        dim, count = self.system.dim, len(self.system.nodes)
        self.x, self.v, self.a = (np.zeros((count, 3)) for _ in range(3))
        for own, given in ((self.x, case.x), (self.v, case.v), (self.a, case.a)):
            own[:, :dim] = given
        self.at = tuple(f"{node}.{axis}" for node in self.system.nodes for axis in "xyz")
        self.loads = case_loads(self.system, np.array([case.t]), case.load_case).at(self.x[None])
        self.reach = float(np.ptp(self.x, axis=0).max()) or 1.0
        self.pace = float(np.abs(self.v).max())
        self.turn = self.pace / float(self.ends()[0].min(initial=1.0))

    def row_names(self, system: System, rows: Any) -> tuple[str, ...]:
        """Names of rows."""
        kinds = {LENGTH: "length of ", ANGLE: ""}
        return tuple(kinds.get(int(system.row_kind[r]), "sum ") + system.row_name(r) for r in rows)

    def ends(self) -> tuple[np.ndarray, np.ndarray]:
        """Lengths of all members and their rates, (m,)."""
        d = self.x[self.system.q] - self.x[self.system.p]
        L = np.linalg.norm(d, axis=1)
        return L, np.sum((self.v[self.system.q] - self.v[self.system.p]) * d, axis=1) / L

    def pulls(self) -> np.ndarray:
        """Sums of the absolute terms of the laws of bars, (m,) N."""
        s, (L, Ld) = self.system, self.ends()
        green = s.law == GREEN
        spring = np.where(green, 0.5 * s.spring * (L**2 + s.natural**2) * L / s.natural**2, s.spring * (L + s.natural))
        return np.where(s.law != 0, spring + s.damping * np.abs(Ld), 0.0)

    def size(self) -> np.ndarray:
        """What meets at every node as a sum of absolute values, for its three coordinates, (3 n,) N."""
        s, loads = self.system, self.loads
        L, _ = self.ends()
        weight = float(np.abs(loads.gravity).sum()) + float(np.abs(self.a).max()) + self.pace**2 / L
        rods = s.rods
        inertia = (rods[:, 0] + rods[:, 3] + (rods[:, 2] + rods[:, 5]) / L**2 + s.body[:, 0]) * (1 + s.length0 / L) ** 2
        own = self.pulls() + inertia * weight + np.abs(s.body[:, 3]) / L**2 * weight
        found = s.lump * (np.abs(loads.lump_gravity).sum(axis=1) + np.abs(self.a).max())
        for ends in (s.p, s.q):
            np.add.at(found, ends, own)
        for ends in (s.pair_p, s.pair_q):
            np.add.at(found, ends, (s.pair_mass + np.abs(s.pair_skew)) * float(weight.max()))
        np.add.at(found, loads.node, np.abs(loads.force[0]).sum(axis=1))
        for task in self.case.tasks.values():
            found += max(np.abs([getattr(task, "constant", 0.0) or 0.0, *(getattr(task, "table", None) or ())])) * self.steep()
        if s.continua is not None:
            K = abs(material_stiffness(s, self.x)).max(axis=1).toarray().reshape(-1, 3).max(axis=1)
            found += K * self.reach + s.continua.lump * float(weight.max())
        own, turn = list(s.model.springs.values()), 2.0 * np.pi + self.reach
        starts = s.measure_start[len(s.measure_start) - len(own) :]
        sprung = [
            one.stiffness * (abs(here if one.rest is None else one.rest) + turn)
            + one.damping * self.pace + one.friction + abs(one.preload)
            for one, here in zip(own, starts, strict=True)
        ]  # fmt: skip
        table = sum(abs(force) for one in own for _, force in one.table or ())
        found += float(sum(sprung) + table) * self.steep()
        return np.repeat(found, 3)

    def steep(self) -> float:
        """The largest gradient of a drive's coordinate."""
        L, _ = self.ends()
        sums = np.abs(row_derivatives(self.system, self.x).g[0]).max() if len(self.system.row_member) else 1.0
        return max(1.0, 1.0 / float(L.min(initial=1.0)), sums)

    def energy_size(self, mass: np.ndarray) -> float:
        """Sum of the absolute values of what energies are made of, J."""
        y = np.abs(self.v).reshape(-1)
        return float(y @ np.abs(mass) @ y + self.size() @ (np.abs(self.x).reshape(-1) + self.reach)) + 1e-300


def of_nodes(matrix: np.ndarray) -> np.ndarray:
    """The scale of the entries of a matrix over coordinates: the smaller of the largest entries at the two nodes."""
    largest = np.abs(matrix).max(axis=1).reshape(-1, 3).max(axis=1)
    return np.repeat(np.repeat(np.minimum.outer(largest, largest), 3, axis=0), 3, axis=1)


def drawn(names: tuple[str, ...]) -> np.ndarray:
    """Numbers that belong to names, whatever their order."""
    return np.array([np.random.default_rng(crc32(name.encode())).normal() for name in names])


class Forward:
    """The equations of forward dynamics."""

    def __init__(self, q: Question, solver: str = "auto") -> None:
        self.q, case = q, q.case
        self.eq, self.ws = equations(q.system, case.load_case, case.tasks, case.trajectory, solver=solver, t_end=1.0)
        self.x, self.v = q.x.reshape(-1).copy(), q.v.reshape(-1).copy()
        kkt.prepare_rows(self.eq, self.ws, case.t, self.x, self.v)
        kkt.row_gradients(self.eq, self.ws, self.x)
        self.rows = q.row_names(q.system, self.eq.row)
        self.unit = np.maximum(np.linalg.norm(self.J(), axis=1), 1e-300)

    def J(self) -> np.ndarray:
        """Gradients of the rows, (r, 3 n)."""
        found, y = np.zeros((self.eq.row.size, self.x.size)), np.zeros(self.x.size)
        for c in range(self.x.size):
            y[:], y[c] = 0.0, 1.0
            kkt.row_along(self.eq, self.ws, y, column := np.zeros(len(found)))
            found[:, c] = column
        return found

    def M(self) -> np.ndarray:
        """Mass matrix, (3 n, 3 n)."""
        found, y = np.zeros((self.x.size,) * 2), np.zeros(self.x.size)
        for c in range(self.x.size):
            y[:], y[c] = 0.0, 1.0
            kkt.kinetic(self.eq, self.ws, self.x, y)  # leaves M y in its workspace
            found[:, c] = self.ws.h
        return found

    def by_row(self, values: np.ndarray, scale: float) -> Part:
        """A quantity of the rows, for gradients of size 1."""
        return Part(values / self.unit, (self.rows,), scale + np.abs(values / self.unit))

    def gaps(self) -> Part:
        """How far the rows are from what they hold."""
        kkt.row_gaps(self.eq, self.x, self.ws.target, out := np.zeros(len(self.rows)))
        return self.by_row(out, self.q.reach)

    def rate_gaps(self) -> Part:
        """The same of their rates."""
        kkt.row_rate_gaps(self.eq, self.ws, self.x, self.v, self.ws.target, out := np.zeros(len(self.rows)))
        return self.by_row(out, 6 * self.q.pace)

    def right_sides(self) -> Part:
        """gamma of J a = gamma."""
        accelerations.row_gammas(self.eq, self.ws, self.x, self.v, out := np.zeros(len(self.rows)))
        return self.by_row(out, 10 * self.q.pace * self.q.turn)

    def met(self, a: np.ndarray) -> bool:
        """Whether accelerations meet all rows."""
        gamma = self.right_sides().value
        off = np.abs(self.J() @ a / self.unit - gamma).max(initial=0.0)
        return bool(off <= 1e-6 * (np.abs(gamma).max(initial=0.0) + np.abs(a).max(initial=0.0)))

    def forces(self, share: float) -> Part:
        """f(t, x, v) with this share of the velocities."""
        applied(self.eq, no_force, self.q.case.t, self.x, share * self.v, out := np.zeros(self.x.size))
        return Part(out, (self.q.at,), self.q.size())

    def energies(self) -> Part:
        """Kinetic and potential energy."""
        found = np.array([kkt.kinetic(self.eq, self.ws, self.x, self.v), kkt.potential(self.eq, self.x)])
        return Part(found, (("kinetic", "potential"),), self.q.energy_size(self.M()))

    def momenta(self) -> Part:
        """Momentum, and its moment about the origin."""
        kkt.momenta(self.eq, self.ws, self.x, self.v, out := np.zeros(6))
        size = float((np.abs(self.M()) @ np.abs(self.v)).sum())
        names = tuple(f"{kind} {axis}" for kind in ("linear", "angular") for axis in "xyz")
        return Part(out, (names,), size * np.repeat([1.0, 1.0 + np.abs(self.x).max()], 3))

    def assembled(self, answer: Answer) -> None:
        """All that is put together without solving."""
        M = self.M()
        answer.parts["forward mass"] = Part(M, (self.q.at, self.q.at), of_nodes(M))
        J = self.J() / self.unit[:, None]
        answer.parts["forward rows"] = Part(J, (self.rows, self.q.at), 1.0)
        for name, question in (
            ("gaps", self.gaps), ("rate gaps", self.rate_gaps), ("right sides", self.right_sides),
            ("forces", lambda: self.forces(1.0)), ("forces at rest", lambda: self.forces(0.0)), ("energies", self.energies),
            ("momenta", self.momenta),
        ):  # fmt: skip
            asked(answer, f"forward {name}", question)

    def solved(self) -> tuple[np.ndarray, np.ndarray, float]:
        """Accelerations, what the rows pull with on gradients of size 1, and the smallest pivot."""
        x, v, a, N = self.x.copy(), self.v.copy(), np.zeros(self.x.size), np.zeros(len(self.rows))
        pivot = accelerations.evaluate(self.eq, self.ws, no_force, self.q.case.t, x, v, a, N)
        return a, N * self.unit, pivot


def solved_parts(answer: Answer, q: Question, solver: str) -> None:
    """Accelerations and row forces by one solver; their scale is how they change with positions and velocities."""
    name = f"forward {solver} solved"
    try:
        one = Forward(q, solver)
        *first, pivot = one.solved()
        # redundant rows of a state that no structure can be in: every choice of rows gives another answer
        met = one.met(first[0])
        least = [q.pace * q.turn, float(q.size().max()) + 1.0]
        change = list(least)
        for turn in range(2):
            dice = np.random.default_rng(turn)
            one.x *= 1 + SHIFT * dice.normal(size=one.x.size)
            one.v *= 1 + SHIFT * dice.normal(size=one.x.size)
            kkt.row_gradients(one.eq, one.ws, one.x)
            for k, (new, old) in enumerate(zip(one.solved()[:2], first, strict=True)):
                change[k] = max(change[k], float(np.abs(new - old).max(initial=0.0)) / SHIFT)
        for k, (kind, names) in enumerate((("accelerations", q.at), ("row forces", one.rows))):
            largest = float(np.abs(first[k]).max(initial=0.0))
            sure = met and largest < 1e12 * least[k]
            scale = (largest + change[k]) / max(min(pivot, 1.0), 1e-16) if sure else np.inf
            answer.parts[f"{name} {kind}"] = Part(first[k], (names,), scale, SOLVED)
    except Exception as error:  # noqa: BLE001 - compared by its kind
        answer.refuse(f"{name} accelerations", error)


class Inverse:
    """What inverse dynamics takes off: f - M a by its own kernels."""

    def __init__(self, q: Question) -> None:
        self.q = q

    def left(self, v: float, a: float) -> tuple[np.ndarray, np.ndarray]:
        """f - M a over coordinates, and the forces on the ends of members, with these shares of v and a."""
        q = self.q
        x, w, b = (np.ascontiguousarray(y.reshape(1, -1)) for y in (q.x, v * q.v, a * q.a))
        joint, rest = np.zeros((1, len(q.system.members), 2, 3)), np.zeros((1, q.x.size))
        left_over(q.system, q.loads, States(x, w, b), EndForces(joint, rest))
        return rest[0], joint[0]

    def joints(self) -> Part:
        """Forces on the ends of members."""
        s = self.q.system
        size = self.q.size().reshape(-1, 3)
        scale = np.stack([np.maximum(size[s.p], size[s.q])] * 2, axis=1)
        names = tuple(f"{name}.{end}" for name in s.members for end in "AB")
        return Part(self.left(1.0, 1.0)[1].reshape(-1, 3), (names, tuple("xyz")), scale.reshape(-1, 3))

    def rows(self) -> Part:
        """The Jacobian by which redundant rows are chosen."""
        s = self.q.system
        J = jacobian(s, self.q.x, s.drive_start)
        names = self.q.row_names(s, range(len(J)))
        return Part(J, (names, tuple(self.q.at[c] for c in s.free)), np.abs(J).max(initial=0.0) + 1.0)

    def energies(self, mass: np.ndarray) -> Part:
        """Energy, its rate, dissipation."""
        q, s, l = self.q, self.q.system, self.q.loads
        x, v, a = (np.ascontiguousarray(y.reshape(1, -1)) for y in (q.x, q.v, q.a))
        out = np.zeros((1, 3))
        energies(structure_of(s), nodal_loads(l), States(x, v, a), out)
        power = float(q.size() @ np.abs(q.v).reshape(-1)) * 3
        return Part(out[0], (("energy", "rate", "lost"),), np.array([q.energy_size(mass), power, power]) + 1e-300)

    def assembled(self, answer: Answer, mass: np.ndarray) -> None:
        """All of it."""
        for v, a in ((1.0, 1.0), (1.0, 0.0), (0.0, 0.0)):
            answer.parts[f"inverse left {v:g} {a:g}"] = Part(self.left(v, a)[0], (self.q.at,), self.q.size())
        asked(answer, "inverse joints", self.joints)
        asked(answer, "inverse rows", self.rows)
        asked(answer, "inverse energies", lambda: self.energies(mass))


class Still:
    """Matrices and forces of statics and linearisation."""

    def __init__(self, q: Question) -> None:
        self.q, case = q, q.case
        self.balance: Balance = balance_of(q.system, case.load_case, case.tasks, case.t)
        self.rows = q.row_names(self.balance.system, range(len(self.balance.system.row_member)))
        self.N = 20 * drawn(self.rows)

    def matrix(self, matrix: Any) -> Part:
        """A matrix over coordinates."""
        dense = matrix.toarray() if hasattr(matrix, "toarray") else np.asarray(matrix)
        return Part(dense, (self.q.at, self.q.at), of_nodes(dense))

    def moving(self, which: int) -> Part:
        """Stiffness or damping of a moving state."""
        q, b = self.q, self.balance
        tension, torque = row_tensions(b.system, q.x, self.N)
        tension = tension + bar_laws(b.system, *q.ends()).tension - b.push
        return self.matrix(tangents(b.system, q.x, tension, b.torque + torque, b.gravity, q.v, q.a)[which])

    def curved(self) -> Part:
        """Geometric stiffness of sums."""
        return self.matrix(sum_stiffness(self.balance.system, self.q.x, measure_forces(self.balance.system, self.N)))

    def turning(self) -> list[Part]:
        """Gradients of rows, how they turn, and what rates are multiplied with."""
        found = row_derivatives(self.balance.system, self.q.x, self.q.v)
        g, turned = found.g[0].toarray(), found.g[1].toarray()
        unit = np.maximum(np.linalg.norm(g, axis=1, keepdims=True), 1e-300)
        places, fast = (self.rows, self.q.at), 10 * self.q.turn
        scale = fast + np.abs(turned / unit).max(initial=0.0)
        r = Part(found.r / unit, (self.rows, ("r", "r'", "r''")), np.abs(found.r / unit) + np.array([0, 1, fast]) * self.q.pace)
        return [Part(g / unit, places, 1.0), Part(turned / unit, places, scale), r]

    def laws(self) -> Part:
        """Tension, slope and damping of all members."""
        s, (L, Ld) = self.q.system, self.q.ends()
        found = np.stack(bar_laws(s, L, Ld)[:3], axis=1)
        slope = np.where(s.law != 0, s.spring * (1 + (L / np.where(s.natural > 0, s.natural, 1)) ** 2), 0)
        return Part(found, (s.members, ("pull", "slope", "damping")), np.stack([self.q.pulls(), slope, s.damping], axis=1))

    def soft(self) -> Part:
        """1/(E A), or one over the slope of a law, of all that carries force."""
        held = stiff_rows(self.q.system)
        found = flexibility(held, self.q.x)
        return Part(found, (self.q.row_names(held, range(len(found))),), np.abs(found))

    def values(self) -> Part:
        """Value, rate and second rate of all sums."""
        s, q = self.q.system, self.q
        found = np.array([measured(s, m, q.x[None], q.v[None], q.a[None])[0] for m in range(len(s.measures))]).reshape(-1, 3)
        scale = np.abs(found).max(initial=0.0) + np.array([q.reach + 7, q.pace, q.pace**2]) * self.q.steep() ** 2
        return Part(found, (s.measures, ("value", "rate", "second")), scale)

    def shared(self) -> Part:
        """Row forces that carry what is applied, redundant ones shared."""
        b, x = self.balance, self.q.x
        N = balanced_rows(b, x, b.applied(x))
        J = row_derivatives(b.system, x).g[0][:, b.system.free].toarray()
        values = np.linalg.svd(J, compute_uv=False)
        least = float(values[values > 1e-10].min(initial=1.0))
        return Part(N, (self.rows,), (np.abs(N).max(initial=0.0) + self.q.size().max()) / least**2, SOLVED)

    def assembled(self, answer: Answer) -> None:
        """All of it."""
        b, q, size = self.balance, self.q, self.q.size()
        M = mass_matrix(q.system, q.x).toarray()
        for name, part in zip(("rows", "turning rows", "rates of rows"), self.turning(), strict=True):
            answer.parts[f"still {name}"] = part
        energy = lambda: Part(np.array(b.energy_change(q.system.x0, q.x)), (), q.energy_size(M))  # noqa: E731
        for name, question in (
            ("mass", lambda: self.matrix(M)), ("forces", lambda: Part(b.applied(q.x), (q.at,), size)),
            ("moving forces", lambda: Part(moving_forces(b, q.x, q.v), (q.at,), size)),
            ("following", lambda: Part(b.following(q.x), (q.at,), size)),
            ("stiffness", lambda: self.matrix(b.stiffness(q.x, self.N))),
            ("following stiffness", lambda: self.matrix(b.following_stiffness(q.x))),
            ("moving stiffness", lambda: self.moving(0)), ("moving damping", lambda: self.moving(1)), ("curved", self.curved),
            ("energy change", energy), ("laws", self.laws), ("flexibility", self.soft), ("values", self.values),
            ("row forces", self.shared),
        ):  # fmt: skip
            asked(answer, f"still {name}", question)


def assembled(case: Case, answer: Answer) -> None:
    """All quantities of a case that are not asked through the public interface."""
    q = Question(case)
    try:
        Forward(q).assembled(answer)
    except Exception as error:  # noqa: BLE001 - compared by its kind
        answer.refuse("forward", error)
    try:
        Still(q).assembled(answer)
    except Exception as error:  # noqa: BLE001 - compared by its kind
        answer.refuse("still", error)
    Inverse(q).assembled(answer, mass_matrix(q.system, q.x).toarray())
    solved_parts(answer, q, SOLVERS[case.number % 3])


if __name__ == "__main__":
    sys.exit(main(assembled))
