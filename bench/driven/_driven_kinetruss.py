"""kinetruss: positions, rates and accelerations from the lengths, then all bar forces, by the public calls."""

from __future__ import annotations

import time

import numpy as np
from _case import DURATION, STEPS, changes, driven, truss

import kinetruss as kt

VERSION = kt.__version__


def settings(case: str, n: int) -> list[dict]:
    del case, n
    return [{"name": "follow and inverse", "steps": STEPS}]


def prepare(case: str, n: int, setting: dict):
    del case, setting
    bars, moved = truss(n), driven(truss(n)).tolist()
    names = [f"N{i}" for i in range(len(bars.points))]
    model = kt.Model(
        nodes={name: kt.Node(at=tuple(at), mass=m) for name, at, m in zip(names, bars.points.tolist(), bars.lump.tolist(), strict=True)},
        fixed=[name for name, held in zip(names, bars.fixed, strict=True) if held],
        bars={f"M{k}": kt.Bar(ends=(names[i], names[j]), mass=0.0) for k, (i, j) in enumerate(bars.ends.tolist())},
        drives={f"M{k}": kt.LengthDrive(f"M{k}") for k in moved},
        loads={f"L{name}": kt.NodalForce(node=name, force=tuple(f)) for name, f in zip(names, bars.force.tolist(), strict=True) if any(f)},
        gravity=tuple(bars.gravity.tolist()),
    )  # fmt: skip
    start, end = bars.lengths, bars.lengths + changes(bars)
    trajectory = kt.Quintic(moves={f"M{k}": (start[k], end[k]) for k in moved}, duration=DURATION)
    order = [f"M{k}" for k in range(len(bars.ends))]

    def run():
        began = time.perf_counter()
        motion = kt.kinematics.follow(model, trajectory, samples=STEPS + 1)
        forces = kt.dynamics.inverse(model, motion, static=False)
        seconds = time.perf_counter() - began
        return seconds, STEPS, np.asarray(forces.member_force.sel(member=order))

    return run
