"""PyNite: linear statics of the pose at every fiftieth sample, with own inertia loads. It gets the motion from elsewhere."""

from __future__ import annotations

import time
from importlib.metadata import version

import numpy as np
from _case import STEPS, right, truss
from Pynite import FEModel3D

VERSION = version("PyNiteFEA")
EVERY = 50


def settings(case: str, n: int) -> list[dict]:
    del case, n
    return [{"name": "statics of every fiftieth pose, motion and inertia loads given", "steps": STEPS // EVERY}]


def prepare(case: str, n: int, setting: dict):
    del case, setting
    bars = truss(n)
    position, _, acceleration, _ = right(n)
    loads = bars.force + bars.lump[:, None] * (bars.gravity - acceleration)

    def run():
        tension = np.full((STEPS + 1, len(bars.ends)), np.nan)
        began = time.perf_counter()
        for step in range(EVERY, STEPS + 1, EVERY):
            tension[step] = _forces(bars, position[step].tolist(), loads[step].tolist())
        return time.perf_counter() - began, STEPS // EVERY, tension

    return run


def _forces(bars, position, loads) -> list[float]:
    model = FEModel3D()
    model.add_material("steel", 1e11, 4e10, 0.3, 0.0)
    model.add_section("rod", 1e-2, 1e-6, 1e-6, 1e-6)
    for i, (at, load, held) in enumerate(zip(position, loads, bars.fixed, strict=True)):
        model.add_node(f"N{i}", *at)
        model.def_support(f"N{i}", held, held, held, True, True, True)
        for axis, value in zip("XYZ", load, strict=True):
            model.add_node_load(f"N{i}", f"F{axis}", value)
    for k, (i, j) in enumerate(bars.ends.tolist()):
        model.add_member(f"M{k}", f"N{i}", f"N{j}", "steel", "rod")
        model.def_releases(f"M{k}", Ryi=True, Rzi=True, Ryj=True, Rzj=True)
    model.analyze_linear(log=False)
    return [-model.members[f"M{k}"].axial(0.0, "Combo 1") for k in range(len(bars.ends))]
