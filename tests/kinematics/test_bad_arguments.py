"""Arguments of another kind than is wanted end in an error of kinetruss' own, before any work."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import KinetrussError

K = kt.kinematics
BAY = kt.library.vgt.double_octahedral()
MOVE = kt.Quintic(moves={"M7": (1.1684, 1.2)}, duration=1)
MOTION = K.follow(BAY, MOVE, samples=3)
GRID = {"across": ("x", [0, 0.1]), "along": ("y", [0.6, 0.7])}
SINE = kt.Sine(amplitudes={"M7": 0.01}, period=1.0, duration=1.0)


def cut(**changes):
    return lambda: K.workspace(BAY, changes.pop("point", "N8"), **GRID | changes)


CALLS = {
    "workspace at a pair": cut(at=("z", 1.1)),
    "workspace at text": cut(at="z"),
    "workspace at a number": cut(at=1.1),
    "workspace at a value as text": cut(at={"z": "1.1 m"}),
    "workspace at another key": cut(at={3: 1.0}),
    "workspace across text": cut(across="xy"),
    "workspace across words": cut(across=("x", "abc")),
    "workspace across nothing": cut(across=None),
    "workspace along not a number": cut(along=("y", [0.6, np.nan])),
    "workspace limits as text": cut(limits="M7"),
    "workspace limits of one number": cut(limits={"M7": 1.0}),
    "workspace limits as a list": cut(limits=[("M7", (0, 1))]),
    "workspace limits of text": cut(limits={"M7": ("a", "b")}),
    "workspace least": cut(least="small"),
    "workspace of two points": cut(point=["N8"]),
    "assemble text": lambda: K.assemble(BAY, {"M7": "1.2 m"}),
    "assemble a name": lambda: K.assemble(BAY, "M7"),
    "modes of text": lambda: K.assembly_modes(BAY, {"M7": "1.2"}),
    "follow a mapping": lambda: K.follow(BAY, {"M7": SINE}),
    "follow a function": lambda: K.follow(BAY, lambda t: t),
    "follow nothing": lambda: K.follow(BAY, None),
    "follow a list": lambda: K.follow(BAY, [MOVE, SINE]),
    "follow least": lambda: K.follow(BAY, MOVE, least="small"),
    "follow start": lambda: K.follow(BAY, MOVE, start="there"),
    "sample times": lambda: K.sample(BAY, MOVE, "now"),
    "sample a mapping": lambda: K.sample(BAY, {"M7": SINE}, [0]),
    "inverse of a mapping": lambda: K.inverse(BAY, {"N8.x": (0, 1)}),
    "inverse of a function": lambda: K.inverse(BAY, max),
    "inverse of platform 5": lambda: K.inverse(BAY, MOVE, platform=5),
    "simulate a mapping": lambda: kt.dynamics.simulate(BAY, 1.0, trajectory={"M7": SINE}),
    "simulate a function": lambda: kt.dynamics.simulate(BAY, 1.0, trajectory=lambda t: t),
    "simulate tasks of a function": lambda: kt.dynamics.simulate(BAY, 1.0, tasks={"M7": lambda t: t}),
    "simulate a function as tasks": lambda: kt.dynamics.simulate(BAY, 1.0, tasks=lambda t: t),
    "jacobian of a number": lambda: K.jacobian(BAY, of=3),
    "jacobian by a number": lambda: K.jacobian(BAY, of="N8", wrt=["M7", 3]),
    "pose of a number": lambda: K.pose(BAY, MOTION, 3),
    "pose in text": lambda: K.pose(BAY, MOTION, ("N7", "N8", "N9"), frame="x"),
    "pose along a model": lambda: K.pose(BAY, BAY, ("N7", "N8", "N9")),
    "platform of a number": lambda: K.platform(BAY, MOTION, 7),
    "platform of text": lambda: K.platform(BAY, "m", ("N7", "N9", "N8")),
    "dynamics of text": lambda: kt.dynamics.inverse(BAY, "motion"),
    "dynamics of nothing": lambda: kt.dynamics.inverse(BAY, None),
    "arrays of text": lambda: K.from_arrays(BAY, [0, 1], "x", 2, 3),
    "gimbal of text": lambda: K.gimbal_lengths("a", 1, 0, 0, 1),
    "gimbal pose of text": lambda: K.gimbal_pose(1.2192, 0.889, "abc"),
    "platform jacobian length": lambda: K.platform_jacobian(BAY, ("N7", "N9", "N8"), length="long"),
}


@pytest.mark.parametrize("name", CALLS)
def test_is_refused(name):
    with pytest.raises(KinetrussError):
        CALLS[name]()


def test_a_function_as_a_task_is_called_one():
    with pytest.raises(kt.KinetrussError, match="is a function.*Spline"):
        kt.dynamics.simulate(BAY, 1.0, tasks={"M7": lambda t: t})


def test_a_mapping_of_trajectories_is_told_where_to_go():
    with pytest.raises(kt.InputError, match=r"one record moves all its coordinates.*tasks="):
        K.follow(BAY, {"M7": SINE, "M9": SINE})
