"""Free linkages: rows of four-bars through their singular positions, a bar twice, a slider-crank in space."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification._cases import stored
from kinetruss.verification._measures import drift

METHODS = {"default": None, "dop853": kt.DOP853(), "taylor": kt.Taylor()}


def row(loops: int, method: str) -> dict[str, float]:
    """How far a row of four-bars ends from where it should, m and m/s, by the settings of a method; change of energy."""
    run = kt.dynamics.simulate(kt.library.mechanisms.n_four_bar(loops=loops), 10.0, samples=1001, method=METHODS[method])
    end = run.motion.data.isel(time=-1).sel(node=[f"B{k}" for k in range(loops + 1)])
    place = end.position.values - [(float(k), 0.0) for k in range(loops + 1)]
    exact = stored("forward")["exact"]["n_four_bar"][loops]
    return {
        "energy": drift(run),
        "place": float(np.abs(place - [exact["x"], exact["y"]]).max()),
        "speed": float(np.abs(end.velocity.values - [exact["vx"], exact["vy"]]).max()),
    }


def twice() -> dict[str, float]:
    """Two windows whose middle post is there twice: largest difference of motion and forces from those without."""
    model = kt.library.mechanisms.n_four_bar(loops=2)
    again = model.bars["post1"].with_(mass=0.0)
    double = model.with_(bars=dict(model.bars) | {"again": again})
    one, two = (
        kt.dynamics.simulate(each, 2.0, samples=41, method=kt.DOP853(rtol=1e-11, atol=1e-12)) for each in (model, double)
    )
    single = one.forces.member_force
    size = float(np.abs(single.values).max())
    shares = two.forces.member_force

    def off(left: Any, right: Any) -> float:
        return float(np.abs(left.values - right.values).max()) / size

    return {
        "motion": float(np.abs(one.motion.position.values - two.motion.position.values).max()),
        "sum": off(shares.sel(member="post1") + shares.sel(member="again"), single.sel(member="post1")),
        "share": off(shares.sel(member="post1"), shares.sel(member="again")),
        "others": off(
            shares.sel(member=["post0", "post2", "beam1", "beam2"]), single.sel(member=["post0", "post2", "beam1", "beam2"])
        ),
    }


def slider() -> dict[str, float]:
    """Crank pin, slider and its speed at whole seconds."""
    method = kt.DOP853(rtol=1e-12, atol=1e-13)
    run = kt.dynamics.simulate(kt.library.mechanisms.spatial_slider_crank(), 2.0, samples=3, method=method)
    wanted = {"y_P": ("position", "P", "y"), "z_P": ("position", "P", "z"), "x_S": ("position", "S", "x")}
    wanted["v_S"] = ("velocity", "S", "x")
    return {
        f"{name}_at_{t}s": float(run.motion.data[kind].sel(node=node, axis=axis, time=float(t)))
        for t in (1, 2)
        for name, (kind, node, axis) in wanted.items()
    }
