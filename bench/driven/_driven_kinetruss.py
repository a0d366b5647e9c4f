"""kinetruss: positions, rates and accelerations from the lengths, then all bar forces, by the public calls."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
from _case import DURATION, STEPS, changes, driven, truss
from _kinetruss import model_of_bars

import kinetruss as kt

VERSION = kt.__version__


def settings(case: str, n: int) -> list[dict]:
    del case, n
    return [{"name": "follow and inverse", "steps": STEPS}]


def prepare(case: str, n: int, setting: dict):
    del case, setting
    bars, moved = truss(n), driven(truss(n)).tolist()
    rigid = model_of_bars(replace(bars, rigid=np.ones_like(bars.rigid)))
    model = rigid.with_(drives={f"M{k}": kt.LengthDrive(f"M{k}") for k in moved})
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
