"""What every code is asked: the mechanisms as plain data, in two forms, and the state that is compared at the end.

`Bars` is a mechanism of nodes and straight bars (natural coordinates), `Linkage` the same as a tree of planar bodies with
closed loops, for codes without bars. Needs NumPy alone: the peers may live in an interpreter of their own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

G = 9.81
BAY_RADIUS, BAY_HEIGHT = 1.0, 1.0  # of the triangles; between one triangle and the next, m
BAR_MASS, STIFFNESS, DAMPING, SIDE = 1.0, 2e4, 100.0, 100.0  # kg/m, N/m, N s/m, N


@dataclass(frozen=True, kw_only=True)
class Bars:
    """points (n, dim) m; fixed (n,); ends (m, 2); rigid (m,), the others are spring-dampers unstressed at the start;
    mass (m,) of uniform bars, kg; lump (n,) kg; velocity (n, dim); force (n, dim) constant, N, without weight; gravity (dim,).
    """

    points: np.ndarray
    fixed: np.ndarray
    ends: np.ndarray
    rigid: np.ndarray
    mass: np.ndarray
    lump: np.ndarray
    velocity: np.ndarray
    force: np.ndarray
    gravity: np.ndarray
    stiffness: float = STIFFNESS
    damping: float = DAMPING
    t_end: float = 1.0

    @property
    def lengths(self) -> np.ndarray:
        return np.linalg.norm(self.points[self.ends[:, 1]] - self.points[self.ends[:, 0]], axis=1)


@dataclass(frozen=True, kw_only=True)
class Body:
    """A planar body, numbered depth first. parent : -1 ground. hinge : in the parent's frame. angle, rate : absolute, at the
    start. centre : of mass, in its own frame, whose origin is the hinge. inertia : central."""

    parent: int
    hinge: tuple[float, float]
    angle: float
    rate: float
    mass: float
    centre: tuple[float, float]
    inertia: float


@dataclass(frozen=True, kw_only=True)
class Linkage:
    """loops: (body, point, body, point) that coincide; spring: (body, point, ground point, N/m, m); torque on body 0, N m."""

    bodies: tuple[Body, ...]
    loops: tuple[tuple[int, tuple[float, float], int, tuple[float, float]], ...]
    gravity: float = 0.0
    torque: float = 0.0
    spring: tuple[int, tuple[float, float], tuple[float, float], float, float] | None = None
    t_end: float = 1.0

    def relative(self) -> tuple[np.ndarray, np.ndarray]:
        """Angles and rates of the bodies against their parents."""
        angle, rate = np.array([(b.angle, b.rate) for b in self.bodies]).T
        parent = np.array([b.parent for b in self.bodies])
        return angle - np.where(parent < 0, 0.0, angle[parent]), rate - np.where(parent < 0, 0.0, rate[parent])

    def absolute(self, relative: np.ndarray) -> np.ndarray:
        angle = np.array(relative, float)
        for i, body in enumerate(self.bodies):
            if body.parent >= 0:
                angle[i] += angle[body.parent]
        return angle


# N-four-bar (IFToMM A02): n windows, cranks A_i B_i, couplers B_i B_i+1, links of 1 m and 1 kg, standing up, B moves to +x


def n_four_bar_bars(n: int) -> Bars:
    count = n + 1
    x = np.arange(count, dtype=float)
    points = np.concatenate([np.stack([x, 0 * x], 1), np.stack([x, 0 * x + 1], 1)])
    k = np.arange(count)
    ends = np.concatenate([np.stack([k, k + count], 1), np.stack([k[:-1] + count, k[1:] + count], 1)])
    velocity = np.where(np.arange(2 * count)[:, None] >= count, [1.0, 0.0], 0.0)
    return Bars(
        points=points, fixed=np.arange(2 * count) < count, ends=ends, rigid=np.ones(len(ends), bool), mass=np.ones(len(ends)),
        lump=np.zeros(2 * count), velocity=velocity, force=np.zeros((2 * count, 2)), gravity=np.array([0.0, -G]),
    )  # fmt: skip


def n_four_bar_linkage(n: int) -> Linkage:
    """Crank 0, coupler 0, crank 1, coupler 1, .. crank n."""
    bodies: list[Body] = []
    for i in range(n + 1):
        bodies.append(_link(-1, (float(i), 0.0), math.pi / 2, -1.0))
        if i < n:
            bodies.append(_link(2 * i, (1.0, 0.0), 0.0, 0.0))
    loops = tuple((2 * i + 1, (1.0, 0.0), 2 * i + 2, (1.0, 0.0)) for i in range(n))
    return Linkage(bodies=tuple(bodies), loops=loops, gravity=G)


def _link(parent: int, hinge: tuple[float, float], angle: float, rate: float) -> Body:
    return Body(parent=parent, hinge=hinge, angle=angle, rate=rate, mass=1.0, centre=(0.5, 0.0), inertia=1 / 12)


def tips_of_angles(angles: np.ndarray) -> np.ndarray:
    """B_i of the absolute angles of the linkage."""
    crank = angles[::2]
    return np.stack([np.arange(len(crank)) + np.cos(crank), np.sin(crank)], 1)


# Andrews' mechanism: parameters and start of the IVP test set (Mazzia & Magherini; Hairer & Wanner II, VII.7); SI

ANDREWS = {
    "m": (0.04325, 0.00365, 0.02373, 0.00706, 0.0705, 0.00706, 0.05498),
    "I": (2.194e-06, 4.41e-07, 5.255e-06, 5.667e-07, 1.169e-05, 5.667e-07, 1.912e-05),
    "A": (-0.06934, -0.00227), "B": (-0.03635, 0.03273), "C": (0.014, 0.072),
    "c0": 4530.0, "l0": 0.07785, "d": 0.028, "da": 0.0115, "e": 0.02, "ea": 0.01421, "rr": 0.007, "ra": 0.00092,
    "ss": 0.035, "sa": 0.01874, "sb": 0.01043, "sc": 0.018, "sd": 0.02, "ta": 0.02308, "tb": 0.00916, "u": 0.04,
    "ua": 0.01228, "ub": 0.00449, "zf": 0.02, "zt": 0.04, "fa": 0.01421, "mom": 0.033, "t_end": 0.03,
}  # fmt: skip
ANDREWS_START = (  # beta, Theta, gamma, Phi, delta, Omega, epsilon
    -0.0617138900142764496358948458001, 0.0, 0.455279819163070380255912382449, 0.222668390165885884674473185609,
    0.487364979543842550225598953530, -0.222668390165885884674473185609, 1.23054744454982119249735015568,
)  # fmt: skip
ANDREWS_END = (  # at 0.03 s: energy quadrature of the one degree of freedom in 40 digits (28 of them here)
    15.8107711951537070971193873, -15.75637105841183946972775284, 0.04082224011964580485828231959,
    -0.5347301163420795937701850311, 0.5244099658799540693716557999, 0.5347301163420795937701850311,
    1.048080741041937873068515472,
)  # fmt: skip


ANDREWS_ORDER = (0, 1, 2, 4, 3, 6, 5)  # bodies 1, 2, 3, 5, 4, 7, 6 of the test set: each branch in one go


def andrews_linkage() -> Linkage:
    """Own frames: 1 (the crank) along O-F, 2 along F-E, 3 with E at (0, -ss), 5 with G on its axis, 4 along G-E, 7 along
    A-H, 6 along H-E."""
    c = ANDREWS
    places = (
        (-1, (0.0, 0.0), (c["ra"], 0.0)), (0, (c["rr"], 0.0), (c["da"], 0.0)), (-1, c["B"], (c["sb"], -c["sa"])),
        (-1, c["A"], (c["ta"], c["tb"])), (3, (c["zt"], 0.0), (c["e"] - c["ea"], 0.0)),
        (-1, c["A"], (c["ua"], -c["ub"])), (5, (c["u"], 0.0), (c["zf"] - c["fa"], 0.0)),
    )  # fmt: skip
    angles = andrews_frames(np.array(ANDREWS_START))
    bodies = tuple(
        Body(parent=parent, hinge=hinge, angle=float(angles[k]), rate=0.0, mass=c["m"][k], centre=centre, inertia=c["I"][k])
        for (parent, hinge, centre), k in zip(places, ANDREWS_ORDER, strict=True)
    )
    meet = (0.0, -c["ss"])
    loops = ((1, (c["d"], 0.0), 2, meet), (4, (c["e"], 0.0), 2, meet), (6, (c["zf"], 0.0), 2, meet))
    spring = (2, (c["sd"], -c["sc"]), c["C"], c["c0"], c["l0"])
    return Linkage(bodies=bodies, loops=loops, torque=c["mom"], spring=spring, t_end=c["t_end"])


def andrews_frames(q: np.ndarray) -> np.ndarray:
    """Absolute angles of the frames of bodies 1 .. 7, of the seven angles of the test set."""
    beta, theta, gamma, phi, delta, omega, epsilon = q
    half = math.pi / 2
    return np.array([beta, beta + theta + 2 * half, gamma, phi + delta - half, delta, omega + epsilon, epsilon - half])


def andrews_angles(frames: np.ndarray) -> np.ndarray:
    """The other way round."""
    half = math.pi / 2
    one, two, three, four, five, six, seven = frames
    epsilon = seven + half
    return np.array([one, two - one - 2 * half, three, four + half - five, five, six - epsilon, epsilon])


def andrews_frames_of_points(F, E, G_, H) -> np.ndarray:
    """The same frames of the places of four nodes."""
    A, B = ANDREWS["A"], ANDREWS["B"]
    half = math.pi / 2
    return np.array(
        [_angle((0, 0), F), _angle(F, E), _angle(B, E) + half, _angle(G_, E), _angle(A, G_), _angle(H, E), _angle(A, H)]
    )


def _angle(p, q) -> float:
    return math.atan2(q[1] - p[1], q[0] - p[0])


# A chain of double-octahedral bays: base triangle fixed, middle triangles of spring-dampers, all other bars rigid


def chain_bars(bays: int, *, lumped: bool) -> Bars:
    """Released at rest under its weight and a side load on a top node. Bars of 1 kg/m, or their halves at the nodes."""
    level = np.arange(2 * bays + 1)
    turn = np.pi / 3 * (level % 2)[:, None] + 2 * np.pi / 3 * np.arange(3)
    points = np.stack(
        [BAY_RADIUS * np.cos(turn), BAY_RADIUS * np.sin(turn), np.tile(BAY_HEIGHT * level[:, None], 3)], 2
    ).reshape(-1, 3)
    ends: list[tuple[int, int]] = []
    soft: list[bool] = []
    for k in range(1, 2 * bays + 1):
        here, below = 3 * k, 3 * (k - 1)
        shift = (0, 1) if k % 2 else (0, 2)  # the two nodes below between which a node stands
        ends += [(below + (i + s) % 3, here + i) for i in range(3) for s in shift]
        ends += [(here + i, here + (i + 1) % 3) for i in range(3)]
        soft += [False] * 6 + [bool(k % 2)] * 3
    pairs, count = np.array(ends), len(points)
    mass = BAR_MASS * np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1)
    lump = np.zeros(count)
    if lumped:
        np.add.at(lump, pairs.reshape(-1), np.repeat(mass / 2, 2))
        mass = 0 * mass
    force = np.zeros((count, 3))
    force[-1, 0] = SIDE
    return Bars(
        points=points, fixed=np.arange(count) < 3, ends=pairs, rigid=~np.array(soft), mass=mass, lump=lump,
        velocity=np.zeros((count, 3)), force=force, gravity=np.array([0.0, 0.0, -G]),
    )  # fmt: skip


def bars_of(case: str, n: int) -> Bars:
    """The case as nodes and bars (Andrews' mechanism needs bodies)."""
    if case == "n_four_bar":
        return n_four_bar_bars(n)
    return chain_bars(n, lumped=case == "chain_lumped")


def linkage_of(case: str, n: int) -> Linkage:
    """The case as bodies and loops (only planar ones)."""
    return n_four_bar_linkage(n) if case == "n_four_bar" else andrews_linkage()


def state_of_angles(case: str, frames: np.ndarray) -> np.ndarray:
    """What is compared, of the absolute angles of a linkage's bodies."""
    if case == "n_four_bar":
        return tips_of_angles(frames)
    numbered = np.empty(7)
    numbered[list(ANDREWS_ORDER)] = frames
    return andrews_angles(numbered)
