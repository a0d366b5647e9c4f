"""Rates of planes, members and centres of mass; prediction and conditioning along a motion."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.mechanics import compile

STENCIL = np.array([1, -8, 0, 8, -1]) / 12
TOP, BASE = ("N7", "N9", "N8"), ("N1", "N2", "N3")


@pytest.fixture(scope="module")
def slewed():
    """A bay that tilts about both axes and rises, sampled for differences of order 4 about t = 0.4."""
    h = 2e-3
    model = kt.library.vgt.double_octahedral(height=1.05)
    moves = {"bay.beta": (0.0, 0.2), "bay.gamma": (0.0, -0.15), "bay.height": (1.05, 1.1)}
    times = 0.4 + h * np.arange(-2, 3)
    return model, kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), times=times), h


def slope(values, h):
    return np.einsum("t,t...->...", STENCIL, values) / h


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "rate"),
    [
        ("beta", "beta_rate"), ("beta_rate", "beta_acceleration"), ("gamma", "gamma_rate"),
        ("gamma_rate", "gamma_acceleration"), ("height", "height_rate"), ("height_rate", "height_acceleration"),
        ("centroid", "centroid_velocity"),
        ("centroid_velocity", "centroid_acceleration"), ("angular_velocity", "angular_acceleration"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("nodes", [TOP, ("N4", "N6", "N5")])
def test_platform_rates_are_derivatives(slewed, name, rate, nodes):
    """Also for the middle plane, whose nodes move against each other."""
    model, motion, h = slewed
    found = kt.kinematics.platform(model, motion, nodes, base=BASE)
    np.testing.assert_allclose(found[rate].values[2], slope(found[name].values, h), atol=2e-9)


def test_platform_meets_the_trajectory_and_the_top_is_rigid(slewed):
    model, motion, _ = slewed
    found = kt.kinematics.platform(model, motion, TOP, base=BASE)
    s = motion.time.values
    q = 10 * s**3 - 15 * s**4 + 6 * s**5
    qd = 30 * s**2 - 60 * s**3 + 30 * s**4
    np.testing.assert_allclose(found.beta, 0.2 * q, atol=1e-13)
    np.testing.assert_allclose(found.gamma_rate, -0.15 * qd, atol=1e-13)
    np.testing.assert_allclose(found.height, 1.05 + 0.05 * q, atol=1e-13)
    assert found.stretch.max() < 1e-13
    middle = kt.kinematics.platform(model, motion, ("N4", "N6", "N5"))
    assert middle.stretch.min() > 1e-3


def test_a_level_top_that_passes_through_level():
    """One sample alone, with all nodes of the top at one height, tilts as fast as any other."""
    model = kt.library.vgt.double_octahedral()
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-0.2, 0.2)), times=[0.5])
    found = kt.kinematics.platform(model, motion, TOP)
    np.testing.assert_allclose(found.angular_velocity.values[0], [0.4 * 1.875, 0, 0], atol=1e-13)


def test_angular_velocity_is_that_of_the_rotation_matrix(slewed):
    """w x = R' R^T with R the product of the two reflections; R' by differences of order 4."""
    model, motion, h = slewed
    found = kt.kinematics.platform(model, motion, TOP, base=BASE)
    z = np.array([0, 0, 1.0])
    u = found.normal.values + z
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    R = (np.eye(3) - 2 * np.einsum("ti,tj->tij", u, u)) @ np.diag([1, 1, -1.0])
    W = slope(R, h) @ R[2].T
    np.testing.assert_allclose(found.angular_velocity.values[2], [W[2, 1], W[0, 2], W[1, 0]], atol=2e-9)


def test_upper_bay_seen_from_the_lower_has_its_own_angles():
    model = kt.library.vgt.double_octahedral(2)
    moves = {"B1.beta": (0, 0.15), "B1.gamma": (0, 0.1), "B2.beta": (0, -0.1), "B2.gamma": (0, 0.2)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), samples=6)
    s = motion.time.values
    found = kt.kinematics.platform(model, motion, ("B2.N7", "B2.N9", "B2.N8"), base=("B1.N7", "B1.N9", "B1.N8"))
    for name, size in (("beta", -0.1), ("gamma", 0.2)):
        np.testing.assert_allclose(found[name], size * (10 * s**3 - 15 * s**4 + 6 * s**5), atol=1e-13)
        np.testing.assert_allclose(found[f"{name}_rate"], size * (30 * s**2 - 60 * s**3 + 30 * s**4), atol=1e-13)
        np.testing.assert_allclose(found[f"{name}_acceleration"], size * (60 * s - 180 * s**2 + 120 * s**3), atol=1e-11)


def test_platform_in_the_plane():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (2, 1), "D": (2, 0)},
        fixed=("A", "D"),
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        drives={"motor": kt.AngleDrive("crank")},
    )
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 2.0}, duration=0.2), samples=5)
    crank = kt.kinematics.platform(model, motion, ("A", "B"))
    np.testing.assert_allclose(crank.angle, np.pi / 2 + 2.0 * motion.time, atol=1e-13)
    np.testing.assert_allclose(crank.angular_velocity.values[:, 0], 2.0, atol=1e-13)
    np.testing.assert_allclose(crank.angular_acceleration.values, 0.0, atol=1e-12)
    # a parallelogram's coupler only translates
    coupler = kt.kinematics.platform(model, motion, ("B", "C"), base=("A", "D"))
    np.testing.assert_allclose([coupler.angle, coupler.angle_rate], 0.0, atol=1e-13)
    np.testing.assert_allclose(coupler.height, 1.0, atol=1e-13)


@pytest.mark.parametrize(
    ("nodes", "message"),
    [
        (("N7", "N8"), "at least 3"), (("N7", "N8", "N8"), "different nodes"), (("N7", "N8", "N99"), "Did you mean"),
        ("N78", "no plane"),
    ],
)  # fmt: skip
def test_platform_refusals(slewed, nodes, message):
    with pytest.raises(InputError, match=message):
        kt.kinematics.platform(*slewed[:2], nodes)


def test_platform_on_a_line():
    model = kt.Model(nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (2, 0, 0)}, fixed=["A", "B", "C"], bars={"a": ("A", "B")})
    still = np.zeros((1, 3, 3))
    motion = kt.kinematics.from_arrays(model, [0.0], [[n.at for n in model.nodes.values()]], still, still)
    with pytest.raises(InputError, match="one line"):
        kt.kinematics.platform(model, motion, ("A", "B", "C"))


@pytest.mark.parametrize(
    ("name", "rate"),
    [
        ("angular_velocity", "angular_acceleration"), ("centre", "centre_velocity"), ("centre_velocity", "centre_acceleration"),
        ("part_centre", "part_centre_velocity"), ("part_centre_velocity", "part_centre_acceleration"),
    ],
)  # fmt: skip
def test_member_rates_are_derivatives(slewed, name, rate):
    model, motion, h = slewed
    found = kt.kinematics.member_rates(model, motion)
    np.testing.assert_allclose(found[rate].values[2], slope(found[name].values, h), atol=2e-9)


def test_directions_turn_with_their_angular_velocity(slewed):
    model, motion, h = slewed
    found = kt.kinematics.member_rates(model, motion)
    u, w = found.direction.values, found.angular_velocity.values[2]
    np.testing.assert_allclose(np.cross(w, u[2]), slope(u, h), atol=2e-9)
    np.testing.assert_allclose(np.einsum("mc,mc->m", w, u[2]), 0.0, atol=1e-15)


def test_centres_carry_the_inertia_of_inverse_dynamics(slewed):
    """Sum of m (a - g) over all parts is the sum of the supports' forces: no node carries mass here."""
    model, motion, _ = slewed
    forces = kt.dynamics.inverse(model, motion)
    found = kt.kinematics.member_rates(model, motion)
    system = compile(model)
    mass = {}
    for i, name in enumerate(system.members):
        rods = system.rods[i]
        mass |= {f"{name}.base": rods[0], f"{name}.tube": rods[3]} if system.two_rods[i] else {name: rods[0]}
    weights = np.array([mass[str(part)] for part in found.part.values])
    inertia = np.einsum("p,tpc->tc", weights, found.part_centre_acceleration.values - np.array([0, 0, -9.81]))
    np.testing.assert_allclose(forces.reaction.sum(dim="support").values, inertia, atol=1e-11)
    whole = np.einsum("m,tmc->tc", system.rods[:, 0] + system.rods[:, 3], found.centre_acceleration.values)
    np.testing.assert_allclose(whole + weights.sum() * np.array([0, 0, 9.81]), inertia, atol=1e-11)


def test_active_member_is_no_fixed_fraction_of_its_length():
    """Closed form on a straight line: base fixed at A, tube moves with B."""
    part = {"section": kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)}
    model = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)},
        fixed={"A": "xy", "B": "y"},
        active={"s": kt.Active(ends=("A", "B"), base=kt.Part(length=1.0, mass=3.0, **part),
                               tube=kt.Part(length=0.8, mass=1.0, **part))},
    )  # fmt: skip
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"s": (2.0, 2.5)}, duration=1.0), samples=5)
    found = kt.kinematics.member_rates(model, motion).sel(member="s", axis="x")
    L = motion.length.sel(member="s")
    np.testing.assert_allclose(found.centre.values, (3 * 0.5 + L - 0.4) / 4, atol=1e-14)
    np.testing.assert_allclose(found.centre_acceleration.values, motion.length_acceleration.sel(member="s") / 4, atol=1e-14)


def test_first_order_prediction():
    model = kt.library.vgt.double_octahedral(beta=0.1)
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(0.1, 0.12)), samples=5)
    found = kt.kinematics.first_order(model, motion)
    assert found.largest_error[0] == 0
    assert 0 < found.largest_error[-1] < 1e-3
    np.testing.assert_allclose(found.predicted - found.error, found.exact, atol=1e-15)
    # lengths are straight in themselves: predicted by them, a driven node on a line is exact
    assert found.attrs["wrt"] == ["M7", "M9", "M11"]
    other = kt.kinematics.first_order(model, motion, ["bay.beta", "bay.gamma", "bay.height"])
    assert other.largest_error[-1] != found.largest_error[-1]


def test_first_order_takes_moving_supports_along():
    """A truss that is only carried along by its supports is predicted exactly."""
    shift = kt.History(times=(0.0, 1.0, 2.0), displacements=((0, 0), (0.1, 0.2), (0.3, 0.1)))
    model = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (1, 1)}, fixed=["A", "B"], support_motion={"A": shift, "B": shift},
        bars={"a": {"ends": ("A", "C"), "kind": "driven"}, "b": ("B", "C")},
    )  # fmt: skip
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"a": 0.0}, duration=2.0), samples=9)
    assert kt.kinematics.first_order(model, motion).largest_error.max() < 1e-14


def test_conditioning_of_a_two_bar_crane_in_closed_form():
    """Unit rows that enclose the angle c: singular values sqrt(1 +- cos c)."""
    model = kt.Model(
        nodes={"A": (-1, 0), "B": (1, 0), "C": (0, 1)}, fixed=["A", "B"],
        bars={"a": {"ends": ("A", "C"), "kind": "driven"}, "b": {"ends": ("B", "C"), "kind": "driven"}},
    )  # fmt: skip
    moves = {name: (np.sqrt(2), 1.2) for name in "ab"}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=1.0), samples=7)
    found = kt.kinematics.conditioning(model, motion)
    u = kt.kinematics.member_rates(model, motion).direction.values
    cosine = np.abs(np.einsum("tc,tc->t", u[:, 0], u[:, 1]))
    np.testing.assert_allclose(found.singular_value.values, np.sqrt(1 + np.outer(cosine, [1, -1])), atol=1e-14)
    np.testing.assert_allclose(found.condition, np.sqrt((1 + cosine) / (1 - cosine)), rtol=1e-13)
    dexterity = kt.kinematics.conditioning(model, motion, of="C", wrt=["a", "b"])
    np.testing.assert_allclose(dexterity.condition, found.condition, rtol=1e-12)
    with pytest.raises(InputError, match="wrt is given without of"):
        kt.kinematics.conditioning(model, motion, wrt="a")


def test_axes_and_inertia_of_members_over_time():
    """The cosine matrix is orthonormal with u first; the inertia of an active member is that of its rods at every length."""
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (0, 1, 0), "C": (0, 0, 1), "D": (1, 0.2, 0.3)},
        fixed=["A", "B", "C"],
        bars={"b": kt.Bar(ends=("B", "D"), mass=1.2), "c": kt.Bar(ends=("C", "D"), mass=0.6)},
        active={"a": kt.Active(ends=("A", "D"), base=kt.Part(length=0.7, mass=3.0), tube=kt.Part(length=0.5, mass=1.0))},
    )
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"a": 0.05}, duration=1.0), samples=5)
    found = kt.kinematics.member_rates(model, motion)
    axes = found.member_axes.values
    assert np.allclose(np.einsum("tmij,tmkj->tmik", axes, axes), np.eye(3), atol=1e-14)
    assert np.allclose(axes[:, :, 0], found.direction, atol=1e-14)
    L = motion.data.length
    along = L.sel(member="a").values
    centre = (3.0 * 0.35 + 1.0 * (along - 0.25)) / 4.0
    exact = 3 * 0.7**2 / 12 + 3 * (centre - 0.35) ** 2 + 0.5**2 / 12 + (along - 0.25 - centre) ** 2
    assert np.allclose(found.moment_of_inertia.sel(member="a"), exact, rtol=1e-13)
    assert np.allclose(found.moment_of_inertia.sel(member="b"), 1.2 * L.sel(member="b") ** 2 / 12, rtol=1e-13)
