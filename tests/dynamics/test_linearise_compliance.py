"""Drives with a compliance in small motions: springs in series, whose commanded length is the drive's."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

STEEL = kt.Material(E=2.1e11, density=7850.0)
SECTION = kt.Tube(outer=0.02, inner=0.016)
SCREW, NUT, BASE, TUBE = 2.5e6, 3e7, 8e6, 0.4
MASS = 40.0


def actuator(compliance: kt.Compliance | None = None, **more) -> kt.Active:
    parts = {
        name: kt.Part(length=long, mass=0.0, section=SECTION, material=STEEL) for name, long in (("base", 0.5), ("tube", TUBE))
    }
    return kt.Active(ends=("A", "B"), compliance=compliance, **(parts | more))


def on_a_line(compliance: kt.Compliance | None) -> kt.Model:
    """A mass on an actuator along x, under a weight."""
    return kt.Model(
        nodes={"A": (0, 0), "B": {"at": (0.8, 0), "mass": MASS}},
        fixed={"A": "xy", "B": "y"},
        active={"act": actuator(compliance)},
        gravity=(9.81, 0),
    )


def stiffness(length: float) -> float:
    return 1 / ((length - TUBE) / SCREW + TUBE / (2.1e11 * SECTION.area) + 1 / NUT + 1 / BASE)


SOFT = kt.Compliance(screw=SCREW, nut=NUT, base=BASE)


@pytest.mark.slow
@pytest.mark.parametrize("length", [0.8, 0.6])
def test_a_mass_on_an_actuator(length):
    """w^2 = k/m with k of screw, nut, tube and base in series at the length of the state; it pulls with the weight."""
    model = on_a_line(SOFT)
    lin = kt.dynamics.linearise(
        model, np.array([[0, 0], [length, 0]]), inputs=["act", "B.x"], outputs=["B.x", "act.force", "act"]
    )
    k = stiffness(length)
    np.testing.assert_allclose(lin.angular_frequency.values, [np.sqrt(k / MASS)], rtol=1e-9)
    np.testing.assert_allclose(lin.member_force.values, [MASS * 9.81], rtol=1e-9)
    np.testing.assert_allclose(lin.drive_force.values, [-MASS * 9.81], rtol=1e-9)
    # slowly the mass follows the commanded length; a force F pushes it by F/k, and none is left in the actuator by a command
    still = lin.frequency_response(0.0).values[0]
    np.testing.assert_allclose(still, [[1, 1 / k], [0, 1], [1, 1 / k]], rtol=1e-9, atol=1e-6)
    assert list(lin.data.input_unit.values) == ["m", "N"]
    # m x'' + k (x - s) = 0, and the tension k (x - s)
    w = 0.5 * np.sqrt(k / MASS)
    at = lin.frequency_response(w, of=["B.x", "act.force"], wrt="act").values[0, :, 0]
    np.testing.assert_allclose(at, [4 / 3, k / 3], rtol=1e-9)


def test_two_actuators_under_a_mass():
    """Two legs at +-45 degrees: k of each length and direction, and the geometric stiffness N/l across it."""
    legs = {"left": actuator(SOFT).with_(ends=("A", "C")), "right": actuator(SOFT).with_(ends=("B", "C"))}
    half = 0.8 / np.sqrt(2)
    model = kt.Model(
        nodes={"A": (-half, 0), "B": (half, 0), "C": {"at": (0, half), "mass": MASS}},
        fixed=["A", "B"],
        active=legs,
        gravity=(0, -9.81),
    )
    k, N = stiffness(0.8), -MASS * 9.81 / np.sqrt(2)
    lin = kt.dynamics.linearise(model)
    np.testing.assert_allclose(lin.frequency_squared.values, (k + N / 0.8) / MASS, rtol=1e-9)
    # one leg rigid: one freedom is left, across it
    one = kt.dynamics.linearise(model, rigid="left", inputs=["left", "right"], outputs=["right.force"])
    np.testing.assert_allclose(one.frequency_squared.values, [(k + N / 0.8) / MASS], rtol=1e-6)
    assert list(one.data.input.values) == ["left", "left'", "left''", "right"]


@pytest.mark.slow
def test_it_is_the_flexible_structure():
    """`flexible.frequencies` of the same structure with only its actuators elastic."""
    model = kt.library.vgt.double_octahedral(gravity=(0, 0, -9.81), payload_mass=5.0)
    soft = {name: one.with_(compliance=kt.Compliance(screw=2e6, nut=1e7, base=5e6)) for name, one in model.active.items()}
    model = model.with_(active=soft)
    still = kt.statics.at_poses(model, [{"bay.beta": 0.1, "bay.gamma": -0.05}])
    found = kt.flexible.frequencies(model, still, 3, rigid=list(model.bars))
    lin = kt.dynamics.linearise(model, still.motion.position.values[0])
    np.testing.assert_allclose(lin.frequency.values, found.frequency.values[0], rtol=1e-8)


def test_it_tends_to_the_rigid_drive():
    """Ten times as stiff: the mass is ten times nearer to the commanded length at a given frequency."""
    off = []
    for factor in (1.0, 10.0):
        stiff = kt.Compliance(screw=SCREW * factor, nut=NUT * factor, base=BASE * factor)
        tube = kt.Part(length=TUBE, mass=0.0, section=SECTION, material=STEEL.with_(E=STEEL.E * factor))
        model = on_a_line(stiff).with_(active={"act": actuator(stiff, tube=tube)})
        lin = kt.dynamics.linearise(model, inputs="act", outputs=["B.x"])
        off.append(abs(lin.frequency_response(1.0).values[0, 0, 0] - 1))
    np.testing.assert_allclose(off[0] / off[1], 10.0, rtol=1e-3)


def test_a_released_drive_has_no_spring():
    """The motor gives a constant force: nothing holds the mass, with or without a compliance."""
    for chosen in ({"dofs": "act"}, {"free": ["act"]}):
        lin = kt.dynamics.linearise(on_a_line(SOFT), inputs="act", **chosen)
        np.testing.assert_allclose(lin.stiffness.values, [[0.0]], atol=1e-6)
        assert list(lin.data.input_unit.values) == ["N"]


def test_without_compliance_drives_are_rigid():
    for model, chosen in ((on_a_line(None), ()), (on_a_line(SOFT), "act")):
        with pytest.raises(kt.InputError, match="Nothing can move here"):
            kt.dynamics.linearise(model, rigid=chosen)
    with pytest.raises(kt.InputError, match="'arm' in rigid is no active member with a compliance"):
        kt.dynamics.linearise(on_a_line(SOFT), rigid="arm")
    with pytest.raises(kt.InputError, match="adds different quantities"):
        kt.dynamics.linearise(on_a_line(SOFT), inputs={"both": {"act": 1, "B.x": 1}})
