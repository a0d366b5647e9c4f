"""Materials, sections, drive trains and the small mechanisms of the library."""

import math

import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.errors import ModelError
from kinetruss.library import drives, materials, sections
from kinetruss.library.mechanisms import four_bar


def test_every_material_has_a_source_and_plausible_values():
    assert len(materials.MATERIALS) >= 12
    for name, material in materials.MATERIALS.items():
        assert getattr(materials, name.upper()) is material
        assert material.source, name
        assert 1e6 < material.E / material.density < 1e8, name  # m^2/s^2: structural metals lie near 2.6e7
        assert material.yield_strength is None or 1e-3 < material.yield_strength / material.E < 1e-2, name


def test_metric_and_inch_values_agree():
    steel = materials.STEEL_4130
    assert pytest.approx(199.9e9, rel=1e-3) == steel.E
    assert steel.density == pytest.approx(7833, rel=1e-3)
    assert materials.TITANIUM_6AL4V.yield_strength == pytest.approx(827e6, rel=1e-3)


def test_sections_of_the_thesis():
    assert sections.TUBE_LACY_SPATIAL.area == pytest.approx(8.391e-5, rel=1e-3)
    assert sections.TUBE_LACY_SPATIAL_THICK.area == pytest.approx(9.024460202726433e-05, rel=1e-14)
    # Euler load of the thesis' table 3.3 values: 1481.2 N over 2 m
    inertia = sections.TUBE_LACY_PLANAR.second_moments[0]
    assert math.pi**2 * materials.ALUMINIUM_LACY.E * inertia / 4 == pytest.approx(1481.196, rel=1e-6)
    thick = sections.TUBE_LACY_SPATIAL_THICK.second_moments[0]
    assert math.pi**2 * 71e9 * thick / 0.889**2 == pytest.approx(3055.11, rel=1e-5)


def test_drive_train_of_the_thesis():
    assert drives.SCREW_LACY_SPATIAL.lead == pytest.approx(2.5266e-4, rel=1e-4)
    planar = drives.SCREW_LACY_PLANAR
    assert planar.lead == pytest.approx(planar.friction * planar.mean_diameter / 2)  # just self-locking
    slewing = drives.MOTOR_LACY_SLEWING
    assert slewing.inertia * slewing.resistance / (slewing.torque_constant * slewing.emf_constant) == pytest.approx(0.0164)
    assert set(drives.MOTORS) == {"motor_lacy", "motor_lacy_slewing"}


@given(st.floats(-7, 7))
def test_four_bar_closes_at_every_crank_angle(angle):
    model = four_bar(angle=angle)
    lengths = [math.dist(*(model.nodes[end].at for end in bar.ends)) for bar in model.bars.values()]
    assert lengths == pytest.approx([0.1, 0.35, 0.25], rel=1e-13)
    b, c, d = (model.nodes[name].at for name in "BCD")
    assert (d[0] - b[0]) * (c[1] - b[1]) - (d[1] - b[1]) * (c[0] - b[0]) > 0


def test_four_bar_that_does_not_close():
    with pytest.raises(ModelError, match="coupler: the linkage does not close at 180 deg"):
        four_bar(angle="180 deg", rocker=0.1)
    with pytest.raises(ModelError, match="coupler: "):
        four_bar(ground=0.1, crank=0.1, angle=0)


def test_library_is_imported_when_used():
    assert kt.library.materials.STEEL_S235.yield_strength == 235e6
    with pytest.raises(AttributeError, match="no attribute 'cheese'"):
        _ = kt.library.cheese
