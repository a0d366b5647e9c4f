"""Screw, nut, tube and base of an active member in series."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt

EA_SCREW, NUT, BASE, TUBE = 2.5e6, 3e7, 8e6, 0.4
STEEL = kt.Material(E=2.1e11, density=7850.0)
SECTION = kt.Tube(outer=0.02, inner=0.016)


def crane(compliance: kt.Compliance | None) -> kt.Model:
    """A boom held by an active tie, under a weight."""
    active = kt.Active(
        ends=("B", "C"),
        base=kt.Part(length=0.6, mass=0.0),
        tube=kt.Part(length=TUBE, mass=0.0, section=SECTION, material=STEEL),
        compliance=compliance,
    )
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.8), "C": (0.6, 0)},
        fixed=["A", "B"],
        bars={"boom": kt.Bar(ends=("A", "C"), mass=0.0)},
        active={"tie": active},
        loads={"W": kt.NodalForce(node="C", force=(0, -500))},
    )


def flexibility(length: Any) -> Any:
    """m/N at a length, m."""
    return (length - TUBE) / EA_SCREW + TUBE / (2.1e11 * SECTION.area) + 1 / NUT + 1 / BASE


def test_the_parts_in_series() -> None:
    """Elongation N f(l) with f = (l - l_t)/E A + l_t/E A_t + 1/k_nut + 1/k_base; the tip sinks by N f/sin."""
    model = crane(kt.Compliance(screw=EA_SCREW, nut=NUT, base=BASE))
    found = kt.statics.linear(model)
    N = 500 / 0.8
    assert np.isclose(found.data.elongation.sel(member="tie"), N * flexibility(1.0), rtol=1e-12)
    assert np.isclose(found.data.displacement.sel(node="C", axis="y"), -N * flexibility(1.0) / 0.8, rtol=1e-12)


def test_it_changes_with_the_length() -> None:
    """Along a motion: the same at every length, and the work of the load is the energy."""
    model = crane(kt.Compliance(screw=EA_SCREW, nut=NUT, base=BASE))
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"tie": (1.0, 0.75)}, duration=2.0), samples=7)
    forces = kt.dynamics.inverse(model, motion)
    found = kt.statics.deflection(model, forces)
    length = motion.data.length.sel(member="tie").values
    N = forces.data.member_force.sel(member="tie").values
    assert np.allclose(found.data.elongation.sel(member="tie"), N * flexibility(length), rtol=1e-12)
    assert np.allclose(found.data.strain_energy.sel(member="tie"), 0.5 * N**2 * flexibility(length), rtol=1e-12)
    assert np.abs(found.data.work_balance).max() < 1e-12 * np.abs(found.data.energy).max()


def test_stiff_parts_tend_to_the_tube() -> None:
    """Without nut and base, and with a screw as stiff as the tube, it is l/(E A)."""
    found = kt.statics.linear(crane(kt.Compliance(screw=2.1e11 * SECTION.area)))
    plain = kt.statics.linear(crane(None))
    assert np.isclose(found.data.elongation.sel(member="tie"), plain.data.elongation.sel(member="tie"), rtol=1e-12)


def test_unknown_stiffness_is_a_fault() -> None:
    """A compliance whose screw or tube has no E and A."""
    with pytest.raises(kt.ModelError, match="E A of its screw is not known"):
        crane(kt.Compliance(nut=NUT))
    tie = crane(None).active["tie"]
    with pytest.raises(kt.ModelError, match="E A of its tube is not known"):
        bare = tie.with_(tube=kt.Part(length=TUBE, mass=0.0), compliance=kt.Compliance(screw=EA_SCREW))
        crane(None).with_(active={"tie": bare})
