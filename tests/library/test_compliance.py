"""Compliance of active members as a fitting of cells and library trusses."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.library import cells

SOFT = kt.Compliance(screw="4 MN", nut=6e7, base=3e7)
RODS = {"base": {"length": 0.3, "mass": 1.0}, "tube": {"length": 0.3}}


def test_the_elongation_of_an_actuator_is_that_of_its_parts_in_series():
    """N ((l - l_t)/E A + l_t/E A_t + 1/k_nut + 1/k_base), of the truss of one actuator."""
    model = kt.library.vgt.triangular(compliance=SOFT, tube_length=1.5)
    forces = kt.statics.at_poses(model, [{}])
    found = kt.statics.deflection(model, forces)
    tube = model.section_of(model.active["actuator"].tube).area * model.material_of(model.active["actuator"].tube).E
    flexibility = (2.5 - 1.5) / 4e6 + 1.5 / tube + 1 / 6e7 + 1 / 3e7
    tension = forces.member_force.sel(member="actuator").item()
    assert found.elongation.sel(member="actuator").item() == pytest.approx(tension * flexibility, rel=1e-9)


@pytest.mark.parametrize("build", [lambda **own: kt.library.vgt.double_octahedral(2, **own),
                                   lambda **own: cells.stack([cells.double_octahedron(**own)] * 2),
                                   lambda **own: cells.stack([cells.quadruple_octahedron(**own)])],
                         ids=["vgt", "stack", "quadruple"])  # fmt: skip
def test_all_active_members_of_a_bay_have_it(build):
    soft, stiff = build(compliance=SOFT), build()
    assert all(one.compliance == SOFT for one in soft.active.values()) and len(soft.active) == 6
    assert soft == stiff.with_(active={name: one.with_(compliance=SOFT) for name, one in stiff.active.items()})


def test_it_is_a_field_of_active_members_by_pattern_in_files_too(tmp_path):
    rods = RODS | {"compliance": {"screw": 4e6, "nut": 6e7}}
    cell = cells.prism(3, side=0.6, height=0.5, active={"longeron*": rods})
    file = tmp_path / "mast.yaml"
    file.write_text(
        "kinetruss: 1\nlibrary:\n  name: cells.stack\n  cells:\n"
        "    - {kind: prism, sides: 3, side: 0.6 m, height: 0.5 m, active: {'longeron*': {base: {length: 0.3 m, mass: 1 kg}, "
        "tube: {length: 0.3 m}, compliance: {screw: 4 MN, nut: 60 kN/mm}}}}\n"
    )
    for model in (cells.stack([cell]), kt.read(file)):
        assert {one.compliance for one in model.active.values()} == {kt.Compliance(screw=4e6, nut=6e7)}
        assert len(model.active) == 3


def test_a_driven_bar_without_rods_has_none():
    with pytest.raises(kt.ModelError, match="has compliance, but no rods"):
        cells.prism(3, active={"longeron*": {"compliance": {"nut": 6e7}}})


def test_a_bay_gives_way_more_with_it():
    tip = {}
    for name, compliance in (("stiff", None), ("soft", kt.Compliance(screw=4e6, nut=1e6))):
        model = kt.library.vgt.double_octahedral(gravity=(0, 0, -9.81), payload_mass=20.0, compliance=compliance)
        forces = kt.statics.at_poses(model, [{}])
        tip[name] = -kt.statics.deflection(model, forces).displacement.sel(node="N8", axis="z").item()
    assert tip["soft"] > 2 * tip["stiff"] > 0
    assert np.isfinite(list(tip.values())).all()
