"""The frames of a chain of bays as Lacy (1991, chapter 6) prints them, beside the product's own motion and forces.

Equation 6.9 turns the spin of a bay's top relative to its base by the orientation of the top instead of that of the base;
equation 6.14 leaves out the cross product of the two spins. Each bay moves in its base frame as the product's single bay
does. Forces follow from the tip down: bays on base nodes that move as given, loaded by the reactions of the bay above.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import kinetruss as kt
from kinetruss.verification.thesis.bay import TILT, truss_of

Floats = NDArray[np.float64]
Motion = tuple[Floats, Floats, Floats]
"""Positions, velocities and accelerations (nodes, 3) at an instant."""

BAYS = 3
BELOW = {"N1": "N7", "N2": "N9", "N3": "N8"}
"""Base nodes of a bay -> the top nodes of the bay below that they are."""

SPAN = 3.0  # s, of the motion
MOVES: dict[str, tuple[float | None, tuple[tuple[float, float, tuple[float, ...]], ...]]] = {
    "together": (0.0, ((0.0, SPAN, (0.75, 1.5, 2.25)),)),
    "delayed": (0.75, ((0.0, 0.75, (0.5,)), (0.75, SPAN, (1.0, 1.5, 2.0, 2.5)))),
    "one_axis": (None, ((0.0, SPAN, (0.75, 1.5, 2.25)),)),
}
"""Name -> start of gamma (s; None: it stays 0), and pieces: first and last time, and the instants compared."""


@dataclass(frozen=True)
class Frame:
    """A bay's base frame in global axes: origin with its derivatives, rotation (global from bay), spin and its rate."""

    origin: Motion
    rotation: Floats
    spin: Floats
    spin_rate: Floats

    def carry(self, r: Motion) -> Motion:
        """Global motion of nodes given in the frame (eq. 6.3, 6.7, 6.11)."""
        w = self.spin
        x, v, a = (one @ self.rotation.T for one in r)
        return (
            self.origin[0] + x,
            self.origin[1] + v + np.cross(w, x),
            self.origin[2] + a + 2 * np.cross(w, v) + np.cross(self.spin_rate, x) + np.cross(w, np.cross(w, x)),
        )

    def next(self, origin: Motion, turn: Motion) -> Frame:
        """The frame of the bay above, by eq. 6.9 and 6.14 as printed."""
        cross = turn[1] @ turn[0].T
        rate = turn[2] @ turn[0].T - cross @ cross
        rotation = self.rotation @ turn[0]
        spin, spin_rate = (rotation @ np.array([m[2, 1], m[0, 2], m[1, 0]]) for m in (cross, rate))
        return Frame(origin, rotation, self.spin + spin, self.spin_rate + spin_rate)


def differences(move: str) -> dict[str, float]:
    """Largest differences from the product over the instants: components of velocity and acceleration, sizes of forces."""
    start, pieces = MOVES[move]
    found = {"velocity": 0.0, "acceleration": 0.0, "force": 0.0}
    for first, last, times in pieces:
        chain = _followed(truss_of(BAYS, payload_mass=2.0), start, first, last, times)
        forces = kt.dynamics.inverse(chain.model, chain.motion, static=False)
        bay = _followed(truss_of(), start, first, last, times)
        for i in range(len(times)):
            for key, off in _off(forces, bay, i).items():
                found[key] = max(found[key], off)
    return found


@dataclass(frozen=True)
class Followed:
    """A model and its motion."""

    model: kt.Model
    motion: kt.results.Motion


def _followed(model: kt.Model, start: float | None, first: float, last: float, times: tuple[float, ...]) -> Followed:
    """Every bay from 0 to 10 degrees: beta in 3 s, gamma from `start` on; a piece of it that is a polynomial, by a table."""
    t = np.linspace(first, last, 13)
    beta, gamma = _tilt(t / SPAN), 0.0 * t if start is None else _tilt((t - start) / (SPAN - start))
    values = {f"{pose}.{angle}": tuple(law) for pose in model.poses for angle, law in (("beta", beta), ("gamma", gamma))}
    motion = kt.kinematics.follow(model, kt.Spline(times=tuple(t), values=values), times=np.array(times) - first)
    return Followed(model, motion)


def _tilt(s: Floats) -> Floats:
    s = np.maximum(s, 0.0)
    return TILT * s**3 * (10 - 15 * s + 6 * s**2)


def _off(forces: kt.results.Forces, bay: Followed, i: int) -> dict[str, float]:
    """Differences at an instant, the chain as printed minus the product."""
    his = _as_printed(bay, i)
    ours = forces.motion.data.isel(time=i)
    found = {"velocity": 0.0, "acceleration": 0.0, "force": 0.0}
    load = np.zeros((3, 3))
    for k in range(BAYS, 0, -1):
        at = [_node(k, name) for name in bay.model.nodes]
        for key, values in zip(("velocity", "acceleration"), his[k - 1][1:], strict=True):
            found[key] = max(found[key], float(np.abs(values - ours[key].sel(node=at).values).max()))
        force, load = _forces(bay.model, his[k - 1], 2.0 if k == BAYS else 0.0, load)
        of_chain = forces.joint_force.isel(time=i).sel(member=[f"B{k}.{name}" for name in bay.model.members]).values
        found["force"] = max(found["force"], float(np.linalg.norm(force - of_chain, axis=-1).max()))
    return found


def _node(k: int, name: str) -> str:
    """The node of the chain that a node of bay k is: base nodes belong to the bay below."""
    return f"B{k - 1}.{BELOW[name]}" if k > 1 and name in BELOW else f"B{k}.{name}"


def _as_printed(bay: Followed, i: int) -> list[Motion]:
    """Global motion of the nodes of every bay, base first."""
    now = bay.motion.data.isel(time=i)
    x, v, a = (now[name].values for name in ("position", "velocity", "acceleration"))
    names = [str(node) for node in now["node"].values]
    own = [names.index(name) for name in BELOW]
    top = [names.index(name) for name in BELOW.values()]
    turn = _turn(x[own], (x[top], v[top], a[top]))
    still = np.zeros(3)
    frame = Frame((still, still, still), np.eye(3), still, still)
    found = []
    for _ in range(BAYS):
        motion = frame.carry((x, v, a))
        found.append(motion)
        centre = (motion[0][top].mean(0), motion[1][top].mean(0), motion[2][top].mean(0))
        frame = frame.next(centre, turn)
    return found


def _turn(base: Floats, top: Motion) -> Motion:
    """Rotation of the top triangle from the base triangle, with derivatives."""
    flat = base[1:] - base[0]
    frame = np.linalg.inv(np.vstack([flat, np.cross(flat[0], flat[1])]))
    (p, q), (pv, qv), (pa, qa) = ((one[1] - one[0], one[2] - one[0]) for one in top)
    thirds = np.cross(p, q), np.cross(pv, q) + np.cross(p, qv), np.cross(pa, q) + 2 * np.cross(pv, qv) + np.cross(p, qa)
    x, v, a = ((frame @ np.vstack(rows)).T for rows in ((p, q, thirds[0]), (pv, qv, thirds[1]), (pa, qa, thirds[2])))
    return x, v, a


def _forces(bay: kt.Model, motion: Motion, tip: float, load: Floats) -> tuple[Floats, Floats]:
    """Forces on the members (member, end, axis) of a bay whose base moves as given; and its load on the bay below."""
    nodes = list(bay.nodes)
    placed = {
        name: kt.Node(at=tuple(x), mass=tip if name in BELOW.values() else 0.0)
        for name, x in zip(nodes, motion[0], strict=True)
    }
    pushed = {
        f"on_{name}": kt.NodalForce(node=name, force=tuple(force)) for name, force in zip(BELOW.values(), load, strict=True)
    }
    drives = {f"{name}.{axis}": kt.CoordinateDrive(node=name, axis=axis) for name in BELOW for axis in "xyz"}
    model = bay.with_(nodes=placed, fixed={}, poses={}, loads=pushed, drives=drives, gravity=(0.0, 0.0, -9.81))
    given = kt.kinematics.from_arrays(model, [0.0], *(one[None] for one in motion))
    forces = kt.dynamics.inverse(model, given, static=False)
    held = forces.drive_force.sel(drive=list(drives)).values.reshape(3, 3)
    return forces.joint_force.isel(time=0).values, -held
