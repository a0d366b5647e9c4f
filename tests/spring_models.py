"""Models with springs whose motion is known by other means."""

from __future__ import annotations

import numpy as np

import kinetruss as kt

MASS, ARM, STIFFNESS = 2.0, 1.5, 30.0
INERTIA = MASS * ARM**2
HINGE = kt.HingeDrive(axis="O", start="G", end="P")


def pendulum(start=1.0, gravity=0.0, **law):
    """A point mass on a massless arm about O, at an angle from +x; gravity along +x, so that 0 is its lowest place."""
    return kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "P": kt.Node(at=(ARM * np.cos(start), ARM * np.sin(start)), mass=MASS)},
        fixed=["O", "G"],
        bars={"arm": kt.Bar(ends=("O", "P"), mass=0.0)},
        gravity=(gravity, 0.0),
        springs={"hinge": kt.Spring(coordinate=HINGE, **({"stiffness": STIFFNESS, "rest": 0.0} | law))},
    )


def angle(motion):
    """Angle of the arm along a motion, unwrapped."""
    x = motion.position.sel(node="P").values
    return np.unwrap(np.arctan2(x[:, 1], x[:, 0]))


def rate(motion):
    x, v = (motion.data[name].sel(node="P").values for name in ("position", "velocity"))
    return (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]) / ARM**2


def two_links(**more):
    """Two links in the plane with every kind of law: linear, with play, damped, rubbing, by a table, on sums."""
    springs = {
        "root": kt.Spring(coordinate=kt.HingeDrive(axis="O", start="G", end="A"), stiffness=20, rest=0.3, damping=1.0,
                          friction=0.5, slip=0.05),
        "elbow": kt.Spring(coordinate=kt.HingeDrive(axis="A", start="O", end="B"), stiffness=8, damping=0.2, play=0.1),
        "height": kt.Spring(coordinate=kt.CoordinateDrive(node="B", axis="y"), table=((-1, -5), (0, 0), (0.5, 3), (1, 20))),
        "sum": kt.Spring(terms=((kt.AngleDrive("a"), 1.0), (kt.AngleDrive("b"), -2.0)), stiffness=2.0, preload=0.7),
    }  # fmt: skip
    return kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "A": kt.Node(at=(0.6, 0.8), mass=1.0), "B": kt.Node(at=(1.5, 1.3), mass=0.7)},
        fixed=["O", "G"], gravity=(0, -9.81), springs=springs,
        bars={"a": kt.Bar(ends=("O", "A"), mass=1.0), "b": kt.Bar(ends=("A", "B"), mass=0.5)}, **more,
    )  # fmt: skip


def flying(**law):
    """Two triangles of point masses that share an edge, free in space, with a spring about this moving axis."""
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0.4, 0.8, 0.1), "D": (0.5, -0.3, 0.7)}
    masses = dict(zip(nodes, (1.0, 0.7, 1.3, 0.9), strict=True))
    rng = np.random.default_rng(4)
    return kt.Model(
        nodes={name: kt.Node(at=at, mass=masses[name]) for name, at in nodes.items()},
        bars={one + two: kt.Bar(ends=(one, two), mass=0.0) for one, two in ("AB", "AC", "BC", "AD", "BD")},
        velocities={name: tuple(rng.normal(size=3)) for name in nodes},
        springs={"fold": kt.Spring(coordinate=kt.HingeDrive(axis=("A", "B"), start="C", end="D"), **law)},
    )


def hencky(count, stiffness, length=1.0):
    """A column of links between pins, compressed from above, with a spring about every inner pin."""
    h = length / count
    inner = range(1, count)
    return kt.Model(
        nodes={f"N{k}": (0, k * h) for k in range(count + 1)},
        fixed={"N0": "xy", f"N{count}": "x"},
        bars={f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(count)},
        springs={
            f"s{k}": kt.Spring(coordinate=kt.HingeDrive(axis=f"N{k}", start=f"N{k - 1}", end=f"N{k + 1}"), stiffness=stiffness)
            for k in inner
        },
        loads={"P": kt.NodalForce(node=f"N{count}", force=(0, -1.0))},
    )


def elastic(kind="elastic", strain="engineering", damping=0.0):
    """A double pendulum whose second bar is a spring."""
    law = {"kind": kind, "strain": strain, "stiffness": 200.0, "natural_length": 0.8, "damping": damping}
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1, 0), mass=1.0), "Q": kt.Node(at=(1.8, 0.3), mass=0.5)},
        bars={"rod": kt.Bar(ends=("O", "P"), mass=0.3), "spring": kt.Bar(ends=("P", "Q"), **law)},
        fixed=["O"], gravity=(0, -9.81),
    )  # fmt: skip
