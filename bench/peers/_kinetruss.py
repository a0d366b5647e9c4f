"""kinetruss itself, under the same rules: stepping of a prepared system, and the whole public `simulate` beside it.

The steps are error-controlled: tolerances take the place of step sizes.
"""

from __future__ import annotations

import time

import numpy as np
from _cases import ANDREWS, Bars, andrews_angles, andrews_frames_of_points, bars_of

import kinetruss as kt

VERSION = kt.__version__
DECADES = tuple(10.0**-k for k in range(3, 12))
HALVES = tuple(sorted((*DECADES, *(0.3 * rtol for rtol in DECADES)), reverse=True))
METHODS = {"Taylor": kt.Taylor, "DOP853": kt.DOP853}
PREPARED, PUBLIC = "kinetruss", "kinetruss.simulate"


def settings(case: str, n: int) -> list[dict]:
    del case, n
    grid = ((PREPARED, "Taylor", HALVES), (PREPARED, "DOP853", DECADES), (PUBLIC, "Taylor", DECADES))
    return [{"code": code, "name": name, "rtol": rtol, "steps": 50} for code, name, rtols in grid for rtol in rtols]


def prepare(case: str, n: int, setting: dict):
    rtol = setting["rtol"]
    method = METHODS[setting["name"]](
        rtol=rtol, atol=rtol * (0.01 if case == "andrews" else 1.0)
    )  # lengths of centimetres, of metres
    model, tasks, t_end = model_of(case, n)
    read = _reader(case, model)
    if setting["code"] == PUBLIC:

        def run():
            began = time.perf_counter()
            found = kt.dynamics.simulate(model, t_end, samples=2, method=method, tasks=tasks)
            seconds = time.perf_counter() - began
            return seconds, int(found.data["steps"][-1]), read(found.motion.data["position"].values[-1])

        return run
    prepared = kt.dynamics.prepare(model, t_end, method=method, tasks=tasks)

    def stepping():
        began = time.perf_counter()
        found = prepared.run(t_end)
        seconds = time.perf_counter() - began
        if not found.status.ok:
            raise ArithmeticError(found.message)
        return seconds, found.steps + found.rejected, read(found.position[-1])

    return stepping


def model_of(case: str, n: int):
    """The model, what its drives do, and the end, s."""
    if case == "andrews":
        return kt.library.mechanisms.andrews(), {"motor": kt.GivenForce(torque=ANDREWS["mom"])}, ANDREWS["t_end"]
    bars = bars_of(case, n)
    return model_of_bars(bars), None, bars.t_end


def model_of_bars(bars: Bars) -> kt.Model:
    names = [f"N{i}" for i in range(len(bars.points))]
    soft = {"kind": "elastic", "stiffness": bars.stiffness, "damping": bars.damping}
    places = zip(names, bars.points.tolist(), bars.lump.tolist(), strict=True)
    members = enumerate(zip(bars.ends.tolist(), bars.mass.tolist(), bars.rigid, strict=True))
    moving = zip(names, bars.velocity.tolist(), strict=True)
    pushed = zip(names, bars.force.tolist(), strict=True)
    return kt.Model(
        nodes={name: kt.Node(at=tuple(at), mass=m) for name, at, m in places},
        fixed=[name for name, held in zip(names, bars.fixed, strict=True) if held],
        bars={
            f"M{k}": kt.Bar(ends=(names[i], names[j]), mass=mass, **({} if rigid else soft))
            for k, ((i, j), mass, rigid) in members
        },
        velocities={name: tuple(v) for name, v in moving if any(v)},
        loads={f"L{name}": kt.NodalForce(node=name, force=tuple(f)) for name, f in pushed if any(f)},
        gravity=tuple(bars.gravity.tolist()),
    )


def _reader(case: str, model: kt.Model):
    """What is compared, of the positions of all nodes at the end."""
    dim = model.dim
    if case == "andrews":
        places = [list(model.nodes).index(name) for name in ("F", "E", "G", "H")]
        return lambda x: andrews_angles(andrews_frames_of_points(*x[places, :2]))
    free = [i for i, name in enumerate(model.nodes) if name not in model.fixed]
    return lambda x: np.asarray(x)[free, :dim]
