"""A beam on a truss of driven bars: deflection, correction and frequencies."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

BARS = ("left", "right", "cross")


def truss(force: tuple[float, float]) -> kt.Model:
    """A plate on two driven bars and a rigid one; a beam stands on it and carries a force at its tip."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (0.7, 1), "D": (1.3, 1), "T": (0.7, 2.5)},
        fixed=["A", "B"],
        bars={
            "left": kt.Bar(ends=("A", "C"), kind="driven"),
            "right": kt.Bar(ends=("B", "D"), kind="driven"),
            "cross": ("A", "D"),
        },
        bodies={"plate": kt.Body(nodes=("C", "D"))},
        beams={"arm": ("C", "T")},
        clamped={"C": "plate"},
        section=kt.Tube(outer=0.03, inner=0.026),
        material=kt.library.materials.STEEL_S235,
        loads={"tip": kt.NodalForce(node="T", force=force)},
    )


def test_deflection_of_a_pose_is_that_of_the_stiffness_method_with_its_energy():
    model = truss((10.0, -20.0))
    found, alone = kt.statics.deflection(model, kt.statics.at_poses(model, [{}])), kt.statics.linear(model)
    largest = float(np.abs(alone.displacement).max())
    np.testing.assert_allclose(found.displacement.values[0], alone.displacement.values, rtol=0, atol=1e-9 * largest)
    assert float(found.energy[0]) == pytest.approx(float(found.work[0]), rel=1e-9)
    assert "Work and strain energy differ" not in found.message


@pytest.mark.parametrize("force", [(10.0, 0.0), (0.0, -300.0)])
def test_corrected_lengths_bring_the_tip_back_in_the_large_equilibrium(force):
    model = truss(force)
    found = kt.flexible.corrected(model, kt.statics.at_poses(model, [{}]), at=["T.x"])
    bars = {name: bar.with_(kind="elastic") for name, bar in model.bars.items()}
    for name in ("left", "right"):
        bars[name] = bars[name].with_(natural_length=float(found.drive_length.sel(drive=name)[0]))
    loaded = kt.statics.equilibrium(model.with_(bars=bars)).position.sel(node="T").values
    # the equilibrium is found to 1e-9 m or so; without correction the tip is off by 4.5 mm under the force across
    assert loaded == pytest.approx((0.7, 2.5) + found.displacement.sel(node="T").values[0], abs=1e-8)
    assert loaded[0] == pytest.approx(0.7, abs=1e-8)


def test_frequencies_of_a_loaded_beam_are_those_of_its_equilibrium():
    """Under 300 N, 15 % of its Euler load, the first frequency falls by 4 %."""
    model = truss((0.0, -300.0))
    rest = kt.statics.equilibrium(model)
    forces = kt.statics.at_poses(model, rest)
    found = kt.flexible.frequencies(model, forces, rigid=BARS).frequency.values[0]
    assert found == pytest.approx(kt.dynamics.linearise(model, rest).frequency.values, rel=1e-8)
    free = truss((0.0, 0.0))
    unloaded = kt.flexible.frequencies(free, kt.statics.at_poses(free, [{}]), rigid=BARS).frequency.values[0]
    assert 0.95 < found[0] / unloaded[0] < 0.97
