"""The double-octahedral bay with offset joints: freedoms, places and forces computed independently, ideal beside real."""

import numpy as np
import pytest

import kinetruss as kt
from reference.hub_bay import ThreeFold

OFFSET, LOAD = 0.04, 200.0
vgt = kt.library.vgt


@pytest.fixture(scope="module")
def bay() -> kt.Model:
    """Without mass, a load on each corner of its top."""
    light = kt.Material(E=71e9, density=0.0)
    return vgt.double_octahedral(
        joint_offset=OFFSET, material=light, base_mass=0.0, tube_mass=0.0, gravity=None, tip_force=(0, 0, -LOAD)
    )


@pytest.mark.parametrize("stroke", [-0.05, 0.06])
def test_equal_strokes_as_by_symmetry(bay, stroke):
    """Places of the corners, and forces of the actuators by virtual work: F dl = P dz."""
    own = ThreeFold({name: node.at for name, node in bay.nodes.items()}, OFFSET)
    assert own.length(0.0) == pytest.approx(1.1684 - 2 * OFFSET, rel=1e-12)
    assert np.abs(own.start[:3]).max() < 1e-12
    found = kt.statics.at_poses(bay, [dict.fromkeys(("M7", "M9", "M11"), own.length(0.0) + stroke)])
    corner, rise = own.moved(stroke)
    x = found.motion.position
    np.testing.assert_allclose(x.sel(node="N7").values[0], corner, atol=1e-10)
    np.testing.assert_allclose(x.sel(node="N9").values[0], own.C.apply(corner), atol=1e-10)
    np.testing.assert_allclose(found.drive_force.values[0], np.full(3, LOAD * rise), rtol=1e-9)


def test_three_freedoms_a_bay_and_no_state_of_self_stress():
    for bays, pose in ((1, {"beta": 0.15, "gamma": -0.1}), (3, {})):
        model = vgt.double_octahedral(bays, joint_offset="30 mm", **pose)
        found = kt.kinematics.mobility(model)
        assert (found.degrees_of_freedom, found.undriven, found.self_stress) == (3 * bays, 0, 0)
        assert kt.check(model) == []


def both(offset: float) -> tuple[tuple[kt.Model, kt.results.Forces], ...]:
    """Ideal and real bay with the same strokes in time."""
    ideal = vgt.double_octahedral(payload_mass=5.0)
    lengths = kt.kinematics.follow(ideal, vgt.slew(beta=("0 deg", "10 deg"), gamma=("0 deg", "4 deg")), samples=2).length
    found = []
    for model, less in ((ideal, 0.0), (vgt.double_octahedral(payload_mass=5.0, joint_offset=offset), 2 * offset)):
        moves = {name: tuple((lengths.sel(member=name).values - less).tolist()) for name in ("M7", "M9", "M11")}
        motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), samples=5)
        found.append((model, kt.dynamics.inverse(model, motion)))
    return tuple(found)


def test_smaller_offsets_lead_to_the_ideal_bay():
    """Forces of all members and drives differ by what is linear in the offset; halving it leaves a quarter of the rest."""
    differ = []
    for offset in (0.02, 0.01, 0.005):
        (ideal, one), (_, other) = both(offset)
        names = list(ideal.members)
        differ.append((other.member_force.sel(member=names) - one.member_force.sel(member=names)).values)
    first, second = 2 * differ[1] - differ[0], 2 * differ[2] - differ[1]
    assert np.abs(differ[0]).max() > 1.0
    assert np.abs(second).max() < 0.3 * np.abs(first).max()
    assert np.abs(second).max() < 0.02 * np.abs(differ[2]).max()


def test_the_real_bay_is_in_balance_and_its_hubs_bend_the_leaves():
    (ideal, plain), (model, forces) = both(0.03)
    assert forces.status.ok
    assert "not unique" not in forces.message
    assert np.abs(forces.energy_balance).max() < 1e-11 * np.abs(forces.power).max()
    cuts = [{"member": name} for name in model.whole.real_members] + [{"node": name} for name in model.whole.nodes]
    left = [kt.dynamics.free_body(model, forces.motion, forces, time=0.25, **cut).residual for cut in cuts]
    assert max(left) < 1e-9
    verdict = kt.strength.check(model, forces)
    assert "Not included" not in verdict.message
    bent = [
        np.abs(kt.strength.sections(one, two).data.section_M.sel(part="M3")).max().item()
        for one, two in ((ideal, plain), (model, forces))
    ]
    assert bent[1] > 3 * bent[0]
    page = kt.report.beside((ideal, plain), (model, forces))
    assert "M3" in page.text
