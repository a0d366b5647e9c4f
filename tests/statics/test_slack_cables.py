"""Cables of `statics.linear`: which pull and which are slack, against every set of cables tried by hand."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import kinetruss as kt

STEEL = kt.Material(E=210e9, density=0.0)
MAST, GUY = kt.Tube(outer=0.1, inner=0.09), kt.Rod(diameter=0.01)
HIGH = 3.0


def guyed(rng: np.random.Generator, dim: int) -> kt.Model:
    """A clamped mast with two to six guys: at their natural length, pretensioned, or too long by up to 5e-4."""
    around = rng.uniform(0, 2 * math.pi, int(rng.integers(2, 7)))
    if dim == 2:
        feet = [(2.0 * math.copysign(1.0, math.cos(angle)) + 0.2 * math.sin(angle), 0.0) for angle in around]
    else:
        feet = [(2 * math.cos(angle), 2 * math.sin(angle), 0.0) for angle in around]
    top = (*(0,) * (dim - 1), HIGH)
    natural = [math.dist(foot, top) * (1 + rng.choice([0, -1e-5, 5e-4]) * rng.random()) for foot in feet]
    ends = [(f"F{k}", "T") for k in range(len(feet))]
    return kt.Model(
        nodes={"O": (0,) * dim, "T": top} | {f"F{k}": foot for k, foot in enumerate(feet)},
        clamped=["O"],
        fixed=[f"F{k}" for k in range(len(feet))],
        beams={"mast": ("O", "T")},
        bars={f"g{k}": kt.Bar(ends=ends[k], kind="cable", section=GUY, natural_length=one) for k, one in enumerate(natural)},
        section=MAST,
        material=STEEL,
        loads={"wind": kt.NodalForce(node="T", force=tuple(300 * rng.normal(size=dim)))},
    )


def by_trial(model: kt.Model) -> tuple[np.ndarray, np.ndarray, float]:
    """Displacement of the top, tensions, and the energy that the load adds, by the set of cables that is consistent."""
    top, I = np.array(model.nodes["T"].at), MAST.second_moments[0]
    rods = np.array([top - np.array(model.nodes[bar.ends[0]].at) for bar in model.bars.values() if bar.kind == "cable"])
    length = np.linalg.norm(rods, axis=1)
    u, natural = rods / length[:, None], np.array([bar.natural_length for bar in model.bars.values() if bar.kind == "cable"])
    k = STEEL.E * GUY.area / natural
    mast = np.diag([3 * STEEL.E * I / HIGH**3] * (len(top) - 1) + [STEEL.E * MAST.area / HIGH])
    for on in itertools.product([0, 1], repeat=len(k)):
        pull = np.array(on) * k
        x = np.linalg.solve(
            mast + u.T @ (pull[:, None] * u), np.array(model.loads["wind"].force) - u.T @ (pull * (length - natural))
        )
        T = k * (length - natural + u @ x)
        if np.all(np.where(on, T > -1e-9, T < 1e-9)):
            before, T = k * np.maximum(length - natural, 0), np.maximum(T, 0)
            return x, T, float(0.5 * x @ mast @ x + ((T**2 - before**2) / (2 * k)).sum())
    raise AssertionError("no set is consistent")


@pytest.mark.slow
@pytest.mark.parametrize("dim", [2, 3])
def test_cables_pull_or_are_slack_as_every_set_tried_says(dim):
    rng, slackened, tautened = np.random.default_rng(dim), 0, 0
    for _ in range(25):
        model = guyed(rng, dim)
        x, T, energy = by_trial(model)
        found = kt.statics.linear(model)
        cables = [name for name, bar in model.bars.items() if bar.kind == "cable"]
        np.testing.assert_allclose(found.displacement.sel(node="T").values, x, rtol=1e-8, atol=1e-8 * np.abs(x).max())
        np.testing.assert_allclose(found.member_force.sel(member=cables).values, T, atol=1e-6 + 1e-8 * T.max())
        assert found.energy.item() == pytest.approx(energy, rel=1e-6, abs=1e-9)
        slack = [name for name, tension in zip(cables, T, strict=True) if not tension]
        assert (f"Slack, so that {'it carries' if len(slack) == 1 else 'they carry'} nothing: " in found.message) == bool(slack)
        assert all(name in found.message for name in slack)
        at = {name: math.dist(*(model.nodes[end].at for end in model.bars[name].ends)) for name in cables}
        loose = {name for name in cables if model.bars[name].natural_length > at[name] * (1 + 1e-9)}
        slackened += len(set(slack) - loose)
        tautened += len(loose - set(slack))
    assert slackened > 3
    assert tautened > 3


def test_a_mechanism_names_its_slack_cables():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "N": (0.5, -0.5)},
        fixed=["A", "B"],
        bars={name: kt.Bar(ends=(name.upper(), "N"), kind="cable", section=GUY) for name in ("a", "b")},
        material=STEEL,
        loads={"P": kt.NodalForce(node="N", force=(0, 5.0))},
    )
    with pytest.raises(kt.KinetrussError, match=r"Slack here, so that they hold nothing: a, b\."):
        kt.statics.linear(model)
