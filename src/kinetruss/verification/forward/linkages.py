"""Linkages let go: rows of four-bars through their singular positions, a bar twice, a slider-crank in space."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, Taylor
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

LOOPS = ("1", "2", "40")
STEPS, SERIES = DOP853(), Taylor()
TWICE = Reference("agreement", "a bar twice moves as once; both carry the same")


def row(loops: str, method: DOP853 | Taylor | None = None) -> dict[str, float]:
    """End state of a row of four-bars by the settings of a method; change of energy, of the largest kinetic one."""
    run = dynamics.simulate(mechanisms.n_four_bar(loops=int(loops)), 10.0, samples=1001, method=method)
    kinetic, energy = run.kinetic_energy.values, run.kinetic_energy.values + run.potential_energy.values
    end = run.motion.data.isel(time=-1)
    base = np.array([(float(k), 0.0) for k in range(int(loops) + 1)])
    tops = [f"B{k}" for k in range(int(loops) + 1)]
    place = end.position.sel(node=tops).values - base
    speed = end.velocity.sel(node=tops).values
    exact = load("forward")["n_four_bar"]["loops"][loops]
    return {
        "energy": float(np.abs(energy - energy[0]).max() / kinetic.max()),
        "place": float(np.abs(place - [exact["x"], exact["y"]]).max()),
        "speed": float(np.abs(speed - [exact["vx"], exact["vy"]]).max()),
    }


def twice() -> dict[str, float]:
    """Two windows whose middle post is there twice: largest difference of motion and forces from those without."""
    model = mechanisms.n_four_bar(loops=2)
    again = model.bars["post1"].with_(mass=0.0)
    double = model.with_(bars=dict(model.bars) | {"again": again})
    one, two = (dynamics.simulate(each, 2.0, samples=41, method=DOP853(rtol=1e-11, atol=1e-12)) for each in (model, double))
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
    method = DOP853(rtol=1e-12, atol=1e-13)
    run = dynamics.simulate(mechanisms.spatial_slider_crank(), 2.0, samples=3, method=method)
    found: dict[str, float] = {}
    for t in (1, 2):
        now = run.motion.data.sel(time=float(t))
        found |= {
            f"y_P_at_{t}s": now.position.sel(node="P", axis="y").item(),
            f"z_P_at_{t}s": now.position.sel(node="P", axis="z").item(),
            f"x_S_at_{t}s": now.position.sel(node="S", axis="x").item(),
            f"v_S_at_{t}s": now.velocity.sel(node="S", axis="x").item(),
        }
    return found


def cases() -> Iterator[Case]:
    """Default settings through singular positions: energy 1e-8, place 1e-7."""
    data = load("forward")
    source, kept = Reference("closed-form", data["n_four_bar"]["source"]), Reference("identity", "energy is kept")
    for loops in LOOPS:
        for name, tolerance in (("energy", 1e-8), ("place", 1e-7), ("speed", 1e-6)):
            for where, method in (("forward", None), ("forward.dop853", STEPS), ("forward.taylor", SERIES)):
                key = f"{where}.n_four_bar.{loops}.{name}"
                reference = kept if name == "energy" else source
                yield Case(key, reference, 0.0, tolerance, row, (loops, method), (name,), 1.0)
    for name in ("motion", "sum", "share", "others"):
        yield Case(f"forward.bar_twice.{name}", TWICE, 0.0, 1e-9, twice, (), (name,), 1.0)
    table = data["spatial_slider_crank"]
    source = Reference("independent", table["source"])
    for t, _, _, *values in table["table"]:
        for name, value in zip(("y_P", "z_P", "x_S", "v_S"), values, strict=True):
            key = f"{name}_at_{t}s"
            yield Case(f"forward.spatial_slider_crank.{key}", source, value, 1e-9, slider, (), (key,))
