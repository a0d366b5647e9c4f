"""A chain of double-octahedral bays, bay by bay (Lacy 1991, chapter 6, with 6.3, 6.7, 6.9, 6.11 and 6.14 put right).

Kinematics from the base up: each bay by its closed form in its own base frame, carried by that frame's motion.
Forces from the tip down: the 117 equations of one bay, its reactions loading the bay below.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from reference import newton_euler
from reference.newton_euler import Solution, Truss
from reference.octahedral import Bay, bay_nodes, bay_truss, members, turn
from reference.taylor import Taylor

__all__ = ["Frame", "PrintedFrame", "bay_motions", "chain_forces", "chain_motion", "chain_truss"]

Motion = tuple[np.ndarray, np.ndarray, np.ndarray]


@dataclass(frozen=True)
class Frame:
    """Motion of a bay's base frame, global axes: origin and its derivatives, rotation C (global from bay), w, alpha."""

    origin: Motion
    rotation: np.ndarray
    spin: np.ndarray
    spin_rate: np.ndarray

    def carry(self, p: Taylor) -> Motion:
        """Global position, velocity, acceleration (k, 3) of points given in the frame (6.3, 6.7, 6.11)."""
        c, w, alpha = self.rotation.T, self.spin, self.spin_rate
        r, r_rate, r_acceleration = p.value @ c, p.rate @ c, p.acceleration @ c
        return (
            self.origin[0] + r,
            self.origin[1] + r_rate + np.cross(w, r),
            self.origin[2] + r_acceleration + 2 * np.cross(w, r_rate) + np.cross(alpha, r) + np.cross(w, np.cross(w, r)),
        )

    def next(self, origin: Motion, rotation: Taylor) -> Frame:
        """The frame of the bay above. Relative spin is given in this frame, so it is premultiplied by this C (6.9);
        its rate seen from outside adds w x (C w_rel) (6.14)."""
        # R' = W R with W the cross matrix of w_rel; R'' = (A + W W) R
        cross = rotation.rate @ rotation.value.T
        rate = rotation.acceleration @ rotation.value.T - cross @ cross
        spin, spin_rate = (self.rotation @ np.array([m[2, 1], m[0, 2], m[1, 0]]) for m in (cross, rate))
        return Frame(
            origin, self.rotation @ rotation.value, self.spin + spin, self.spin_rate + spin_rate + np.cross(self.spin, spin)
        )


class PrintedFrame(Frame):
    """With 6.9 and 6.14 as they are printed: the wrong C, and no w x (C w_rel)."""

    def next(self, origin: Motion, rotation: Taylor) -> Frame:
        right = super().next(origin, rotation)
        relative = right.spin - self.spin
        rate = right.spin_rate - self.spin_rate - np.cross(self.spin, relative)
        # from the base's axes, as they should be, to the same components on the axes of the top
        again = right.rotation @ self.rotation.T
        return PrintedFrame(origin, right.rotation, self.spin + again @ relative, self.spin_rate + again @ rate)


def bay_motions(bay: Bay, poses: list[tuple[Taylor, Taylor, Taylor]], kind: type[Frame] = Frame) -> list[Motion]:
    """Global x, v, a (9, 3) of the nodes 1 to 9 of every bay, base first; poses are (beta, gamma, height) a bay."""
    still = np.zeros(3)
    frame = kind((still, still, still), np.eye(3), still, still)
    motions = []
    for beta, gamma, height in poses:
        motion = frame.carry(bay_nodes(bay, beta, gamma, height))
        motions.append(motion)
        centroid = tuple(w[6:9].mean(0) for w in motion)
        frame = frame.next((centroid[0], centroid[1], centroid[2]), turn(beta, gamma))
    return motions


def chain_forces(
    bay: Bay, motions: list[Motion], gravity: np.ndarray, tip_mass: float = 0.0, tip_force: np.ndarray | None = None
) -> list[Solution]:
    """The 117 equations of every bay, from the tip down; base first in the list. `tip_force` acts on nodes 7, 8, 9 (3, 3)."""
    external = np.zeros((9, 3))
    external[6:] = 0.0 if tip_force is None else tip_force
    lump = np.array([0.0] * 6 + [tip_mass] * 3)
    solutions: list[Solution] = []
    for x, v, a in reversed(motions):
        solution = newton_euler.solve(bay_truss(bay, gravity, lump), x, v, a, external)
        solutions.insert(0, solution)
        # N1, N2, N3 stand on N7, N9, N8 of the bay below
        external, lump = np.zeros((9, 3)), np.zeros(9)
        external[[6, 8, 7]] = -solution.reaction[:3]
    return solutions


def chain_motion(motions: list[Motion]) -> Motion:
    """Nodes of the whole chain (3 + 6 bays, 3): base 1, 2, 3, then 4 to 9 of every bay."""
    return tuple(np.vstack([motions[0][i][:3], *(motion[i][3:] for motion in motions)]) for i in range(3))  # type: ignore[return-value]


def chain_truss(bay: Bay, bays: int, gravity: np.ndarray, tip_mass: float = 0.0) -> Truss:
    """The whole chain as one set of members, bay by bay in the order of `octahedral.MEMBERS`."""
    count = 3 + 6 * bays
    everything = []
    low = {1: 0, 2: 1, 3: 2}
    for k in range(bays):
        node_of = low | {number: 3 + 6 * k + number - 4 for number in range(4, 10)}
        everything += members(bay, node_of)
        low = {1: node_of[7], 2: node_of[9], 3: node_of[8]}
    supported = np.zeros((count, 3), bool)
    supported[:3] = True
    lump = np.zeros(count)
    lump[-3:] = tip_mass
    return Truss(tuple(everything), supported, gravity, lump, np.tile(gravity, (count, 1)))
