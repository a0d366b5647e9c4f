"""Sections of whole models: closed forms, and what must hold between section forces."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.strength import components, sections, stresses

G = 9.81
TUBE = kt.Tube(outer=0.0254, inner=0.022225)
ALUMINIUM = kt.Material(E=71e9, density=2711.5, yield_strength=240e6, poisson=0.33)


def beam(tilt=0.0, length=2.0, mass=3.0, **changes):
    """A rigid bar of given mass on a pin and a roller, in the plane, tilted, at rest."""
    at = (length * math.cos(tilt), length * math.sin(tilt))
    fields = {
        "nodes": {"A": (0, 0), "B": at}, "fixed": {"A": "xy", "B": "y"}, "gravity": (0.0, -G), "section": TUBE,
        "material": ALUMINIUM, "bars": {"beam": kt.Bar(ends=("A", "B"), mass=mass)},
    }  # fmt: skip
    return kt.Model(**fields | changes)


def at_rest(model, samples=2, load_case=None):
    """Forces of a model that stands still."""
    x = np.array([node.at for node in model.nodes.values()])
    still = np.zeros((samples, *x.shape))
    motion = kt.kinematics.from_arrays(model, np.arange(samples, dtype=float), still + x, still, still)
    return kt.dynamics.inverse(model, motion, load_case)


def test_beam_under_its_own_weight():
    found = sections(beam(), at_rest(beam()), 5)
    xi = np.array([0, 0.25, 0.5, 0.75, 1])
    weight = 3.0 * G
    assert np.allclose(found.section_M.values[0, 0, :, 0], weight * 2.0 / 2 * xi * (1 - xi))
    assert found.section_M.values[0, 0, 2, 0] == pytest.approx(weight * 2.0 / 8)
    assert np.allclose(found.section_V.values[0, 0, :, 0], -weight * (0.5 - xi))
    assert np.allclose(found.section_T.values[0, 0], 0)
    assert found.section_M.dims == ("time", "part", "station", "moment")
    assert list(found.data["moment"].values) == ["3"]
    assert list(found.data["transverse"].values) == ["2"]
    assert found.section_M.attrs["units"] == "N m"


@pytest.mark.parametrize("tilt", np.radians([-70, -20, 35, 80, 120]))
def test_midspan_moment_at_any_angle(tilt):
    model = beam(tilt)
    found = sections(model, at_rest(model), [0.5])
    assert found.section_M.values[0, 0, 0, 0] == pytest.approx(3.0 * G * 2.0 * math.cos(tilt) / 8)


def test_weight_across_a_bar_in_space_bends_it_by_its_cosine():
    rng = np.random.default_rng(5)
    for _ in range(5):
        u = rng.normal(size=3)
        u /= np.linalg.norm(u)
        model = kt.Model(
            nodes={"A": (0, 0, 0), "B": tuple(1.5 * u)}, fixed=["A", "B"], gravity=(0, 0, -G),
            bars={"b": kt.Bar(ends=("A", "B"), kind="elastic", mass=2.0)}, section=TUBE, material=ALUMINIUM,
        )  # fmt: skip
        M = sections(model, at_rest(model), [0.5]).section_M.values[0, 0, 0]
        assert np.linalg.norm(M) == pytest.approx(2.0 * G * 1.5 * math.hypot(u[0], u[1]) / 8)
        # axis 2 is the upward one, so weight bends about axis 3
        assert abs(M[0]) < 1e-12
        assert M[1] > 0


def test_hanging_rod():
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0, -1.2), mass=4.0)}, fixed={"A": "xy", "B": "x"}, gravity=(0, -G),
        bars={"rod": kt.Bar(ends=("A", "B"), mass=2.0)},
    )  # fmt: skip
    found = sections(model, at_rest(model), 4)
    s = np.array([0, 1, 2, 3]) / 3
    assert np.allclose(found.section_T.values[0, 0], 4.0 * G + 2.0 * G * (1 - s))
    assert np.allclose(found.section_V.values, 0)
    assert np.allclose(found.section_M.values, 0)


def test_spinning_rod():
    # pinned at A, turned at a constant rate: T = m w^2 (L^2 - s^2)/(2 L)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.8, 0)}, fixed=["A"], bars={"rod": kt.Bar(ends=("A", "B"), mass=1.5)},
        drives={"turn": kt.AngleDrive("rod")},
    )  # fmt: skip
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 12.0}, duration=0.5), samples=7)
    found = sections(model, kt.dynamics.inverse(model, motion), 5)
    s = 0.8 * np.linspace(0, 1, 5)
    assert np.allclose(found.section_T.values[:, 0], 1.5 * 144 * (0.8**2 - s**2) / 1.6, rtol=1e-9)
    assert np.allclose(found.section_M.values, 0, atol=1e-9)


def bay(**changes):
    model = kt.library.vgt.double_octahedral(bays=1)
    part = {"section": TUBE, "material": ALUMINIUM, "rotary_inertia": True}
    rods = {name: a.with_(base=kt.Part(length=0.95, mass=3.0, **part), tube=kt.Part(length=0.4, **part))
            for name, a in model.active.items()}  # fmt: skip
    bars = {name: bar.with_(rotary_inertia=True) for name, bar in model.bars.items()}
    return model.with_(active=rods, bars=bars, gravity=(1.0, -2.0, -G), material=ALUMINIUM, **changes)


@pytest.fixture(scope="module")
def slew():
    model = bay()
    moves = {"bay.beta": (-0.17, 0.17), "bay.gamma": (0.0, 0.1)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.6), samples=9)
    return model, kt.dynamics.inverse(model, motion)


def test_pins_carry_no_moment_and_free_ends_nothing(slew):
    model, forces = slew
    found = sections(model, forces, 3)
    M = np.abs(found.section_M.values)
    bars = [name in model.bars for name in found.data["part"].values]
    assert M[:, bars][:, :, [0, -1]].max() < 1e-12 * M.max()
    bases = [name.endswith(".base") for name in found.data["part"].values]
    tubes = [name.endswith(".tube") for name in found.data["part"].values]
    assert M[:, bases, 0].max() < 1e-12 * M.max()
    assert M[:, tubes, -1].max() < 1e-12 * M.max()
    # the base reaches beyond the nut: its end is free
    assert np.abs(found.section_T.values[:, bases, -1]).max() < 1e-12
    assert M[:, bases, -1].max() < 1e-12 * M.max()


def test_ends_of_a_bar_are_its_joint_forces(slew):
    model, forces = slew
    found = sections(model, forces, 2)
    bars = list(model.bars)
    T = found.section_T.sel(part=bars).values
    assert np.allclose(T, forces.end_force.sel(member=bars).values, atol=1e-10)
    V = np.linalg.norm(found.section_V.sel(part=bars).values, axis=-1)
    across = np.sqrt(np.maximum(0, np.sum(forces.joint_force.sel(member=bars).values ** 2, axis=-1) - T**2))
    assert np.allclose(V, across, atol=1e-6)


def test_mean_tension_over_a_bar_is_the_member_force(slew):
    model, forces = slew
    points, weights = np.polynomial.legendre.leggauss(3)
    found = sections(model, forces, (1 + points) / 2)
    bars = list(model.bars)
    mean = found.section_T.sel(part=bars).values @ weights / 2
    assert np.allclose(mean, forces.member_force.sel(member=bars).values, atol=1e-10)


def test_clamped_end_of_the_tube_is_the_interface(slew):
    model, forces = slew
    active = list(model.active)
    found = sections(model, forces, [0.0])
    tubes = found.data.sel(part=[f"{name}.tube" for name in active]).isel(station=0)
    tube = {key: tubes[key].values for key in tubes}
    force, moment = forces.interface_force.values, forces.interface_moment.values
    assert np.allclose(tube["section_T"], force[..., 0], atol=1e-10)
    assert np.allclose(tube["section_V"], force[..., 1:], atol=1e-10)
    assert np.allclose(tube["section_M"], moment, atol=1e-10)
    # what the base carries jumps at the nut by what the tube puts in
    nut = found.part_start.sel(part=[f"{name}.tube" for name in active]).values[0] / 0.95
    for k, name in enumerate(active):
        sides = sections(model, forces, [nut[k] - 1e-9, nut[k] + 1e-9]).data.sel(part=f"{name}.base").isel(time=0)
        jump = sides.isel(station=0) - sides.isel(station=1)
        assert float(jump.section_T) == pytest.approx(force[0, k, 0], abs=1e-6)
        assert np.allclose(jump.section_V.values, force[0, k, 1:], atol=1e-6)
        assert np.allclose(jump.section_M.values, moment[0, k], atol=1e-6)


def test_shear_is_the_slope_of_the_moment(slew):
    model, forces = slew
    flat = model.with_(
        bars={name: bar.with_(rotary_inertia=False) for name, bar in model.bars.items()},
        active={name: a.with_(base=a.base.with_(rotary_inertia=False), tube=a.tube.with_(rotary_inertia=False))
                for name, a in model.active.items()},
    )  # fmt: skip
    found = sections(flat, kt.dynamics.inverse(flat, forces.motion), np.linspace(0, 1, 201))
    s = found.data["station"].values * found.part_length.values[:, :, None]
    slope = np.gradient(found.section_M.values, axis=2) / np.gradient(s, axis=2)[..., None]
    V = found.section_V.values
    inner = slice(2, -2)
    tubes = np.array([not name.endswith(".base") for name in found.data["part"].values])  # bases jump at the nut
    assert np.allclose(slope[:, tubes, inner, 1], -V[:, tubes, inner, 0], atol=2e-3)
    assert np.allclose(slope[:, tubes, inner, 0], V[:, tubes, inner, 1], atol=2e-3)


def test_sections_at_rest_come_from_the_static_forces(slew):
    model, forces = slew
    x = forces.motion.position.values
    still = kt.kinematics.from_arrays(model, forces.motion.time.values, x, 0 * x, 0 * x)
    expected = sections(model, kt.dynamics.inverse(model, still), 5)
    found = sections(model, forces.static, 5)
    for name in ("section_T", "section_V", "section_M"):
        assert np.allclose(found.data[name].values, expected.data[name].values, atol=1e-10)
    assert found.data.attrs["at_rest"] == 1


def test_parts_lie_where_they_are_said_to(slew):
    model, forces = slew
    found = sections(model, forces)
    assert list(found.data["part"].values[-2:]) == ["M11.base", "M11.tube"]
    assert list(found.data["member"].values[-2:]) == ["M11", "M11"]
    L = forces.motion.length.sel(member="M11").values
    assert np.allclose(found.part_start.sel(part="M11.tube").values + 0.4, L)
    assert np.allclose(found.part_length.sel(part="M11.base").values, 0.95)
    assert found.data.sizes == {"time": 9, "part": 21, "station": 7, "transverse": 2, "moment": 2}


def test_components_and_strains_by_hand():
    model = beam(section=kt.Rectangle(width=0.02, height=0.005), loads={"pull": kt.NodalForce(node="B", force=(700.0, 0.0))})
    found = sections(model, at_rest(model), [0.0, 0.5])
    parts = components(model, found)
    assert set(parts.data_vars) == {
        f"{name}{tail}" for name in ("axial", "bending_3", "shear_2") for tail in ("", "_microstrain")
    }
    assert parts.axial.values[0, 0, 1] == pytest.approx(700.0 / 1e-4)
    moment = 3.0 * G * 2.0 / 8
    assert parts.bending_3.values[0, 0, 1] == pytest.approx(moment * 0.0025 / (0.02 * 0.005**3 / 12))
    assert parts.shear_2.values[0, 0, 0] == pytest.approx(-1.5 * (3.0 * G / 2) / 1e-4)
    assert parts.axial_microstrain.values[0, 0, 1] == pytest.approx(1e6 * 7e6 / 71e9)
    assert parts.shear_2_microstrain.values[0, 0, 0] == pytest.approx(1e6 * parts.shear_2.values[0, 0, 0] * 2 * 1.33 / 71e9)


def test_classical_points_by_hand():
    model = beam()
    found = sections(model, at_rest(model), [0.0, 0.5])
    point = stresses(model, found)
    modulus, A = math.pi / 64 * (0.0254**4 - 0.022225**4) / 0.0127, math.pi / 4 * (0.0254**2 - 0.022225**2)
    bending, shear = 3.0 * G * 2.0 / 8 / modulus, 3.0 * G / 2 / A
    assert point.S2.values[0, 0, 1] == pytest.approx(bending)
    assert point.S1.values[0, 0, 0] == pytest.approx(math.sqrt(3) * TUBE.shear_factor * shear)
    lacy = stresses(model, found, shear_factor=2.0)
    assert lacy.S1.values[0, 0, 0] == pytest.approx(math.sqrt(3) * 2 * shear)
    assert np.all(stresses(model, found, bending="2").S2.values[0, 0] == pytest.approx(0.0))
    with pytest.raises(InputError, match="bending 'both'"):
        stresses(model, found, bending="both")


def test_the_true_maximum_is_never_below_the_points(slew):
    model, forces = slew
    point = stresses(model, sections(model, forces, 13))
    assert np.all(point.von_mises >= point.S1 * (1 - 1e-12))
    assert np.all(point.von_mises >= point.S2 * (1 - 1e-12))


def test_a_part_without_section_has_no_stress():
    model = beam(section=None)
    point = stresses(model, sections(model, at_rest(model)))
    assert np.isnan(point.von_mises.values).all()
    assert np.isnan(point.S2.values).all()


@pytest.mark.parametrize("stations", [1, 0, [0.5, 0.2], [-0.1], [1.2], [], [np.nan]])
def test_stations_that_make_no_sense_are_refused(stations):
    with pytest.raises(InputError, match="stations"):
        sections(beam(), at_rest(beam()), stations)


def test_forces_of_another_model_are_refused(slew):
    with pytest.raises(InputError, match="other nodes or members"):
        sections(beam(), slew[1])
    with pytest.raises(InputError, match="other members"):
        components(beam(), sections(*slew))
    cut = slew[1].with_(data=slew[1].data.isel(time=slice(0, 3)))
    with pytest.raises(InputError, match="3 samples of forces but 9"):
        sections(slew[0], cut)
