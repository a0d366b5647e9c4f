"""Random robots in MJCF and URDF, imported, and compared in motion with MuJoCo and with Pinocchio.

    python tests/campaigns/robots.py --count 300 --seed 3 [--only 17] [--keep build/robots] [--of mjcf]

A robot uses what its format has at random (`robot_files`, which knows nothing of the product). At random states the places and
velocities of all nodes on bodies, the mass matrix, the forces (gravity, motion, springs, dampers, friction, motors) and the
accelerations must be those of the other program (`robot_oracles`; closures by Lagrange's multipliers), and what the import says
that it left out must be what is missing: no more, no less. Exit 1 on a difference. --file FILE compares one file of yours.
"""

from __future__ import annotations

import argparse
import re
import shutil
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

from robot_files import Made, mjcf, planted, urdf
from robot_oracles import CARRIED, LISTED, Beside, MujocoOracle, Oracle, PinocchioOracle

import kinetruss as kt

SURE = 1e-9
"""Relative difference up to which a number counts as right."""
LOST = 1e-9
"""Singular value below which a freedom moves nothing, where the largest is about 1."""
SMALL = 1e-3
"""m: rows that are all far smaller than this are round-off, as those of a closure between two bodies that are welded."""
NOISE = 1e-3
"""Acceleration, rad/s^2 or m/s^2, beside which those of robots at rest without forces are round-off."""
TIME, SPEED = 0.25, 1.0
"""s over which a robot moves to its next pose, and rad/s or m/s of its joints on the way."""
MOVES = kt.DOP853(max_steps=2_000)
"""Next to a singular pose light bodies turn so fast that the way takes hours: a shorter one is taken instead."""
HARMLESS = (
    "geom", "site", "camera", "light", "sensor", "keyframe", "contact", "asset", "visual", "statistic", "size", "texture",
    "material", "mesh", "skin", "custom", "name", "range", "limit", "margin", "collision", "transmission", "gazebo", "safety",
    "calibration", "mass", "link", "not active", "ctrlrange", "forcerange", "joint: its two links", "without mass", "gear",
    "no force", "ctrl", "kp", "kv", "actuator", "motor", "spin", "group", "user", "timestep", "solver", "solref", "solimp",
    "integrator", "iterations", "inertia", "mimic: joint", "unnamed", "shape", "condim", "friction of contact", "flag",
    "mocap", "is switched off by the file", "springs stay elastic", "control belongs to a run",
)  # fmt: skip
"""Words of what may be left out without any influence on these comparisons."""


@dataclass
class Verdict:
    """Of one robot: what differs, and the largest relative difference of each quantity."""

    faults: list[str] = field(default_factory=list)
    worst: dict[str, float] = field(default_factory=dict)
    refused: str = ""

    def compare(self, name: str, found: Any, wanted: Any, scale: float, allowed: float = SURE) -> None:
        """Keep the difference, relative to a scale."""
        away = np.abs(np.asarray(found) - np.asarray(wanted)).max(initial=0.0) / (scale or 1.0)
        self.worst[name] = max(self.worst.get(name, 0.0), float(away))
        if not away <= allowed:
            self.faults.append(f"{name} differs by {away:.2e} of {scale:.3g}")


def judged(made: Made) -> Verdict:
    """Import a robot and compare it."""
    verdict = Verdict()
    oracle = MujocoOracle(made.path) if made.kind == "mjcf" else PinocchioOracle(made.path, made.beside, made.floating)
    options: dict[str, Any] = {"at": made.at} if made.at else {}
    if made.kind == "urdf":
        options |= {"closures": made.closures} if made.closures else {}
        options |= {"floating": True} if made.floating else {}
    try:
        found = kt.exchange.read(made.path, **options)
        compare(verdict, found, oracle, made)
    except kt.KinetrussError as error:
        verdict.refused = " ".join(str(error).split())
        verdict.faults.append(f"refused: {verdict.refused[:300]}")
    return verdict


def compare(verdict: Verdict, found: Any, oracle: Oracle, made: Made) -> None:
    """All comparisons of one import."""
    told(verdict, found, oracle)
    for word, name in made.rows:
        lines = [one for one in found.left_out if f"'{name}'" in one.where or not name]
        if not any(re.search(rf"(?<![a-z]){word}(?![a-z])", one.what) for one in lines):
            verdict.faults.append(f"{word} of {name!r} is not listed")
    drives, motors = set(found.model.all_drives), set(oracle.drives())
    gone = {
        name for name in motors - drives if idle(oracle, name) and any("with its joint" in one.why for one in found.left_out)
    } | {
        name for name in motors - drives if any("cannot move" in one.why and f"'{name}'" in one.where for one in found.left_out)
    }
    if drives != motors - gone:
        verdict.faults.append(f"drives {sorted(drives ^ (motors - gone))} are on one side only")
    for joint, ratio in made.gears.items():
        gear = getattr(found.model.drives.get(joint), "gear", None)
        if gear is not None and abs(gear.ratio - ratio) > SURE * abs(ratio):
            verdict.faults.append(f"the gear of {joint} is {gear.ratio}, not {ratio}")
    robot = Placed(found.model, oracle, oracle.at(made.at) if made.at else oracle.q0)
    if not robot.begin(verdict):
        return
    if made.at and not robot.kept(made.at) and not any("--at" in text or "kept" in text for text in found.notes):
        verdict.faults.append(f"the pose is not the one that was asked for, and no note says so: {robot.missed(made.at)}")
    rng = np.random.default_rng(made.seed)
    x = robot.x0
    for turn in range(3):
        if not robot.fitted(verdict, x):
            return
        robot.balance(verdict, x, rng)
        if turn < 2 and (x := robot.moved(verdict, x, rng)) is None:
            return


def told(verdict: Verdict, found: Any, oracle: Oracle) -> None:
    """What is left out is what the file has, and no more; the oracle forgets it too."""
    lines = [(one.what, one.where, one.why) for one in found.left_out]
    lines += [("note", "", text) for text in found.notes]
    used: set[int] = set()
    for one in oracle.influences:
        where = [k for k, line in enumerate(lines) if one.listed(*line)]
        used |= set(where)
        if where and one.expected == CARRIED:
            verdict.faults.append(f"{one.words[0]} of {one.name!r} should be carried; left out: {lines[where[0]]}")
        elif not where and one.expected == LISTED:
            verdict.faults.append(f"{one.words[0]} of {one.name!r} changes the motion, and is not listed")
        if where and one.without is not None:
            one.without()
    for k, (what, where, why) in enumerate(lines):
        if what == "spin":
            for body in re.findall(r"<body name='([^']+)'|link '([^']+)'", f"{where} {why}"):
                oracle.forget_spin(body[0] or body[1])
        if k not in used and what != "note" and not any(word in f"{what}: {why}".lower() for word in HARMLESS):
            verdict.faults.append(f"left out without being a known kind: {what}: {why}: {where}")


class Placed:
    """A model beside the oracle: its nodes as points of bodies there."""

    def __init__(self, model: kt.Model, oracle: Oracle, q: Any) -> None:
        self.model, self.oracle, self.q = model, oracle, q
        self.names = list(model.nodes)
        number = {name: k for k, name in enumerate(self.names)}
        self.x0 = np.array([node.at for node in model.nodes.values()], float)
        self.size = max(float(np.ptp(self.x0, axis=0).max()), 1e-3)
        self.pairs = [(number[n], b) for b, body in model.bodies.items() if b in oracle.bodies for n in body.nodes]
        self.sites = [(number[n], b, p) for n, (b, p) in oracle_sites(oracle).items() if n in number]
        self.local: list[Any] = []

    def begin(self, verdict: Verdict) -> bool:
        """Find the coordinates of the model's own pose, and where each node is on its bodies."""
        oracle, q = self.oracle, self.q
        oracle.place(q)
        if np.abs(oracle.rows()[0]).max(initial=0.0) > 1e-7:  # an open loop: the import closes it; sites say how
            q = self._solved(q, self.sites, self.x0)
            oracle.place(q)
        if self.sites:
            away = max(float(np.abs(self._point(b, p) - self.x0[n]).max()) for n, b, p in self.sites)
            if away > 1e-7 * self.size:
                verdict.faults.append(f"a site is {away:.2e} m from its place")
                return False
        self.q = q
        self.local = []
        for n, body in self.pairs:
            R, p = oracle.frame(body)
            self.local.append((n, body, R.T @ (self.x0[n] - p)))
        if not self.local:
            verdict.faults.append("no body of the file is in the model")
        return bool(self.local)

    def kept(self, at: Mapping[str, float]) -> bool:
        """True if joints have the values that were asked for."""
        return not self.missed(at)

    def missed(self, at: Mapping[str, float]) -> dict[str, float]:
        """Joint -> value, of those that have another one."""
        values = {name: self.oracle.value(self.q, name) for name in at}
        return {name: one for name, one in values.items() if one is not None and abs(one - at[name]) > 1e-6}

    def _point(self, body: str, local: Any) -> Any:
        R, p = self.oracle.frame(body)
        return p + R @ local

    def _solved(self, q: Any, points: Sequence[Any], x: Any) -> Any:
        """The coordinates at which points of bodies are where the nodes are, and loops are closed (Gauss, Newton)."""
        for _ in range(60):
            self.oracle.place(q)
            at = [self._point(b, p) for _, b, p in points]
            open_, rows, _ = self.oracle.rows()
            gap = np.concatenate([-open_, *(x[n] - p for (n, _, _), p in zip(points, at, strict=True))])
            J = np.vstack([rows, *(self.oracle.jacobian(b, p)[:3] for (_, b, _), p in zip(points, at, strict=True))])
            step = np.linalg.lstsq(J, gap, rcond=1e-10)[0]
            step *= min(1.0, 0.5 / max(float(np.abs(step).max()), 1e-300))
            q = self.oracle.integrate(q, step)
            if np.abs(step).max(initial=0.0) < 1e-13:
                break
        return q

    def fitted(self, verdict: Verdict, x: Any) -> bool:
        """Place the oracle where the model is; every node on every body of it is where it has to be."""
        self.q = self._solved(self.q, self.local, x)
        self.oracle.place(self.q)
        away = np.array([self._point(b, p) - x[n] for n, b, p in self.local])
        verdict.compare("places", away, 0.0, self.size)
        verdict.compare("closures", self.oracle.rows()[0], 0.0, self.size, 1e-8)
        return not verdict.faults

    def _free(self) -> Any:
        """(nv, k) velocities that the closures allow."""
        J = self.oracle.rows()[1]
        return null(J) if len(J) else np.eye(self.oracle.nv)

    def _motions(self, x: Any) -> Any:
        """(3 local, nv) velocities of the points, by the rates of all coordinates."""
        return np.vstack([self.oracle.jacobian(b, x[n])[:3] for n, b, _ in self.local])

    def moved(self, verdict: Verdict, x: Any, rng: Any) -> Any:
        """A pose further on: the model moves there by itself, without forces."""
        v = self._free() @ (SPEED * rng.uniform(-1, 1, self._free().shape[1]))
        speeds = (self._motions(x) @ v).reshape(-1, 3)
        given = {self.names[n]: tuple(one) for (n, _, _), one in zip(self.local, speeds, strict=True)}
        model = self.model.with_(springs={}, gravity=(0.0, 0.0, 0.0))
        tasks = {name: kt.Free() for name in model.all_drives}
        for span in (TIME, 0.2 * TIME, 0.02 * TIME):
            run = kt.dynamics.simulate(
                model, span, samples=2, positions=x, velocities=given, tasks=tasks, method=MOVES, raise_on_failure=False
            )
            if run.motion.position.shape[0] == 2:
                start = run.motion.velocity.values[0]
                off = np.array([start[n] - one for (n, _, _), one in zip(self.local, speeds, strict=True)])
                if not self.oracle.spun:
                    verdict.compare("start velocities", off, 0.0, float(np.abs(speeds).max()), 1e-7)
                return run.motion.position.values[1]
        verdict.faults.append(f"does not move: {run.message[:200]}")
        return None

    def balance(self, verdict: Verdict, x: Any, rng: Any) -> None:
        """Mass matrix, forces and accelerations at random velocities and random forces of the motors."""
        oracle, N = self.oracle, self._free()
        moves = self._motions(x) @ N
        sizes = np.linalg.svd(moves, compute_uv=False) if moves.size else np.zeros(0)
        k = int(np.sum(sizes > LOST * max(float(sizes.max(initial=0.0)), 1e-12)))
        M = oracle.mass()
        lost = N @ null(moves) if k < N.shape[1] else np.zeros((oracle.nv, 0))
        if lost.shape[1] and np.abs(M @ lost).max() > 1e-7 * np.abs(M).max() and not oracle.spun:
            verdict.faults.append(f"{lost.shape[1]} freedoms with mass move no node of the model")
        if not k:
            return
        rows = chosen(moves, k)
        dofs = [f"{self.names[self.local[i // 3][0]]}.{'xyz'[i % 3]}" for i in rows]
        held = list(self.model.all_drives)
        tasks: dict[str, Any] = {}
        direction = oracle.drives()
        pushes = {name: float(rng.uniform(-1, 1)) for name in held if name in direction}
        for name, push in pushes.items():
            turning = name in self.model.drives and self.model.drives[name].kind in ("hinge", "angle")
            tasks[name] = kt.GivenForce(torque=push) if turning else kt.GivenForce(push)
        rates = dict(zip(dofs, rng.uniform(-1, 1, k).tolist(), strict=True))
        S = self._motions(x)[rows]
        R = N @ np.linalg.pinv(S @ N)  # rates of all coordinates by those chosen
        speed = R @ np.array(list(rates.values()))
        for name, v, given in (("rest", np.zeros(oracle.nv), {}), ("motion", speed, rates)):
            ours = kt.dynamics.reduced_equations(
                self.model, dofs, x, given, free=held, tasks={n: t for n, t in tasks.items() if given}
            )
            oracle.place(self.q, v)
            drift = np.concatenate([oracle.drift(b, x[n])[:3] for n, b, _ in self.local])
            J, rate = oracle.rows()[1:]
            base = np.linalg.lstsq(np.vstack([J, S]), -np.concatenate([rate, drift[rows]]), rcond=1e-10)[0]
            force = oracle.force()
            if given:
                force = force + sum((push * direction[n]() for n, push in pushes.items()), np.zeros(oracle.nv))
            mass, f = R.T @ M @ R, R.T @ (force - M @ base)
            scale = float(np.abs(R.T).sum(axis=0) @ np.abs(force)) + float(np.abs(R.T @ M @ base).max())
            scale += NOISE * float(np.abs(mass).max())
            verdict.compare("mass matrix", ours.mass.values, mass, float(np.abs(mass).max()))
            verdict.compare(f"forces at {name}", ours.force.values, f, scale)
            a = np.linalg.solve(mass, f) if np.linalg.cond(mass) < 1e12 else np.linalg.lstsq(mass, f, rcond=1e-13)[0]
            node = ours.node_acceleration.values
            wanted = (self._motions(x) @ (base + R @ a) + drift).reshape(-1, 3)
            ours_a = np.array([node[n] for n, _, _ in self.local])
            terms = np.abs(np.linalg.pinv(mass)) @ np.abs(R.T) @ (np.abs(force) + np.abs(M) @ np.abs(base))
            high = max(float(np.abs(wanted).max()), float(terms.max())) + NOISE
            verdict.compare(f"accelerations at {name}", ours_a, wanted, high, SURE * (1 + 1e-6 * np.linalg.cond(mass)))
            moving = np.array([ours.velocity.values[n] for n, _, _ in self.local])
            verdict.compare("velocities", moving, (self._motions(x) @ v).reshape(-1, 3), float(np.abs(moving).max()))


def oracle_sites(oracle: Oracle) -> dict[str, tuple[str, Any]]:
    """Named sites of an MJCF, links of a URDF: body, and place there."""
    if not isinstance(oracle, MujocoOracle):
        return {name: (name, np.zeros(3)) for name in oracle.bodies}
    m = oracle.model
    names = [(m.site(k).name, m.body(m.site_bodyid[k]).name, m.site_pos[k].copy()) for k in range(m.nsite)]
    return {name: (body, at) for name, body, at in names if name and body != "world"}


def idle(oracle: Oracle, drive: str) -> bool:
    """True for a motor that moves no mass."""
    oracle.place(oracle.q0)
    direction = oracle.drives()[drive]()
    return float(direction @ oracle.mass() @ direction) == 0.0


def null(A: Any) -> Any:
    """Orthonormal basis (columns) of the null space."""
    _, s, Vt = np.linalg.svd(A)
    rank = int(np.sum(s > LOST * max(float(s.max(initial=0.0)), SMALL)))
    return Vt[rank:].T


def chosen(moves: Any, k: int) -> list[int]:
    """k rows that are far from dependent, one by one (QR with pivots)."""
    from scipy.linalg import qr

    return [int(one) for one in qr(moves.T, mode="r", pivoting=True)[1][:k]]


# ---------------------------------------------------------------------------------------------------------------- the campaign


@dataclass
class Found:
    """Of a campaign: outcomes, features that were used, faults, the worst difference of each quantity."""

    outcomes: Counter[str] = field(default_factory=Counter)
    features: Counter[str] = field(default_factory=Counter)
    faulty: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    worst: dict[str, float] = field(default_factory=dict)


def cases(count: int, seed: int, kinds: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Number and kind of each case: two of MJCF for one of URDF, and the planted ones first."""
    for number in range(count):
        yield number, "planted" if number < len(planted()) else kinds[number % len(kinds)]


def made(number: int, kind: str, seed: int, folder: Path) -> Made:
    """The files of a case."""
    rng = np.random.default_rng([seed, number])
    if kind == "planted":
        return list(planted().values())[number](folder)
    return (mjcf if kind == "mjcf" else urdf)(rng, folder, seed * 100_003 + number)


def campaign(
    count: int, seed: int, *, only: int | None = None, keep: Path | None = None, kinds: Sequence[str] = ("mjcf", "mjcf", "urdf")
) -> Found:
    """Make, import and compare robots."""
    found, begun = Found(), time.monotonic()
    for number, kind in cases(count, seed, kinds):
        if only is not None and number != only:
            continue
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            one = made(number, kind, seed, folder)
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    verdict = judged(one)
            except Exception:  # noqa: BLE001 - a traceback is what is looked for
                verdict = Verdict(faults=["traceback: " + traceback.format_exc(limit=-4)])
            found.features.update(one.features)
            outcome = "match" if not verdict.faults else "REFUSED" if verdict.refused else "DIFFERENCE"
            found.outcomes[f"{one.kind} {outcome}"] += 1
            for quantity, value in verdict.worst.items():
                found.worst[quantity] = max(found.worst.get(quantity, 0.0), value)
            if verdict.faults:
                found.faulty.update(one.features)
                found.faults.append(f"{number} {kind} {one.path.name}: " + "; ".join(verdict.faults[:4]))
                print(f"\n{found.faults[-1][:1500]}", file=sys.stderr)
                if keep is not None:
                    shutil.copytree(folder, keep / f"{seed}_{number}", dirs_exist_ok=True)
        bad = sum(n for word, n in found.outcomes.items() if "match" not in word)
        print(f"\r{number + 1} of {count}, {bad} bad, {time.monotonic() - begun:.0f} s", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return found


def single(path: Path, closures: Path | None) -> int:
    """Compare one file of the user."""
    text = path.read_text(errors="replace")
    kind = "urdf" if re.search(r"<robot[\s>]", text) else "mjcf"
    verdict = judged(Made(kind=kind, path=path, seed=1, beside=Beside(), closures=closures))
    print("\n".join(verdict.faults) or "match")
    print({name: f"{value:.1e}" for name, value in verdict.worst.items()})
    return 1 if verdict.faults else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="number of the one case that is tried")
    parser.add_argument("--keep", type=Path, help="folder for the files of cases that fail")
    parser.add_argument("--of", choices=("mjcf", "urdf"), help="robots of one format only")
    parser.add_argument("--file", type=Path, help="compare this file instead")
    options = parser.parse_args()
    if options.file is not None:
        return single(options.file, None)
    kinds = (options.of,) if options.of else ("mjcf", "mjcf", "urdf")
    found = campaign(options.count, options.seed, only=options.only, keep=options.keep, kinds=kinds)
    print("outcomes:", ", ".join(f"{n} {word}" for word, n in sorted(found.outcomes.items())))
    print("largest relative differences:", ", ".join(f"{name} {value:.1e}" for name, value in found.worst.items()))
    print("features (robots with it, of these with a fault):")
    for word, n in sorted(found.features.items()):
        print(f"  {word}: {n}" + (f", {found.faulty[word]}" if found.faulty[word] else ""))
    for line in found.faults:
        print("FAULT", line[:600])
    return 1 if found.faults or (options.only is None and sum(found.outcomes.values()) < options.count) else 0


if __name__ == "__main__":
    sys.exit(main())
