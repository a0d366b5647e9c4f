"""Paths of equilibria: the von Mises truss in closed form, bifurcations, rigid arches, domes, refusals."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError

INCH, POUND = 0.0254, 4.4482216152605


def von_mises(strain, rise=0.3, load=0.001):
    return kt.library.mechanisms.von_mises(rise=rise, strain=strain, load=load)


def closed_form(strain, y, rise=0.3):
    """P(y) of two bars of k = 1 over a half span of 1."""
    l0, length = np.hypot(1, rise), np.hypot(1, y)
    return 2 * (l0 - length) * y / length if strain == "engineering" else (rise**2 - y**2) * y / l0**2


@pytest.mark.slow
@pytest.mark.parametrize("strain", ["engineering", "green"])
def test_von_mises_truss_to_its_limit_and_beyond(strain):
    found = kt.statics.path(von_mises(strain), "load", points=60)
    y = found.position.sel(node="T", axis="y").values
    np.testing.assert_allclose(found.load_factor * 1e-3, closed_form(strain, y), atol=1e-14)
    l0 = np.hypot(1, 0.3)
    if strain == "engineering":
        limit, at = 2 * (l0 ** (2 / 3) - 1) ** 1.5, np.sqrt(l0 ** (2 / 3) - 1)
    else:
        limit, at = 2 * 0.3**3 / (3 * np.sqrt(3) * l0**2), 0.3 / np.sqrt(3)
    np.testing.assert_allclose(found.limit_points * 1e-3, [limit, -limit], rtol=1e-13)
    np.testing.assert_allclose(found.event_position.sel(node="T", axis="y"), [at, -at], rtol=1e-10)
    assert len(found.bifurcations) == 0
    # unstable between the limit points, and only there
    between = (y < at) & (y > -at)
    np.testing.assert_array_equal(found.unstable.values, between.astype(int))
    assert (np.sign(found.stiffness.values) == np.where(between, -1, 1)).all()


@pytest.mark.slow
@pytest.mark.parametrize("strain", ["engineering", "green"])
@pytest.mark.parametrize(("half", "rise", "EA"), [(1.3, 0.55, 2e5), (2.0, 0.7, 3.0), (0.4, 0.05, 1e7)])
def test_limits_where_one_freedom_is_left(strain, half, rise, EA):
    """A guided crown: at its limits the whole stiffness matrix is 0."""
    l0 = np.hypot(half, rise)
    bars = {n: kt.Bar(ends=(n, "C"), kind="elastic", stiffness=EA / l0, strain=strain, mass=0) for n in "AB"}
    model = kt.Model(
        nodes={"A": (-half, 0), "B": (half, 0), "C": (0, rise)}, fixed={"A": "xy", "B": "xy", "C": "x"}, bars=bars,
        loads={"P": kt.NodalForce(node="C", force=(0, -1.0))},
    )  # fmt: skip
    found = kt.statics.path(model, "P", points=150)
    k = EA / l0
    if strain == "engineering":
        limit = 2 * k * l0 * (1 - (half / l0) ** (2 / 3)) ** 1.5
    else:
        limit = 2 * k * rise**3 / (3 * np.sqrt(3) * l0**2)
    np.testing.assert_allclose(found.limit_points, [limit, -limit], rtol=1e-12)


@pytest.mark.slow
def test_tall_arches_bifurcate_before_their_limit():
    """The path leaves its plane of symmetry first where h/a > 2.3979160998211375."""
    low, tall = (
        kt.statics.path(von_mises("engineering", rise, 1.0), "load", points=120, largest_step=0.03) for rise in (2.39, 2.41)
    )
    assert low.event_kind.values.tolist() == ["limit", "limit"]
    assert tall.event_kind.values.tolist() == ["bifurcation", "bifurcation", "limit", "limit", "bifurcation", "bifurcation"]
    # there a sideways step costs nothing: k (1 - l0/l) + k l0/l cos^2 = 0 with cos = 1/l
    y = tall.event_position.values[:, tall.node.values.tolist().index("T"), 1]
    l0, length = np.hypot(1, 2.41), np.hypot(1, y[[0, 1]])
    np.testing.assert_allclose(1 - l0 / length + l0 / length**3, 0, atol=1e-12)
    side = tall.event_mode.sel(node="T").values[0]
    np.testing.assert_allclose(np.abs(side), [1, 0], atol=1e-12)


@pytest.mark.slow
def test_rigid_arch_on_a_spring():
    """Two rigid bars of length 1; the right foot slides against a spring: P = 2 k (cos(a0) - cos(a)) ... = 4 k s tan(a)."""
    rise = 0.5
    span = np.sqrt(1 - rise**2)
    model = kt.Model(
        nodes={"A": (-span, 0), "T": (0, rise), "B": (span, 0), "W": (span + 1, 0)}, fixed={"A": "xy", "B": "y", "W": "xy"},
        bars={"a": ("A", "T"), "b": ("T", "B"), "s": kt.Bar(ends=("B", "W"), kind="elastic", stiffness=100.0)},
        loads={"P": kt.NodalForce(node="T", force=(0, -1.0))},
    )  # fmt: skip
    found = kt.statics.path(model, "P", points=40)
    y = found.position.sel(node="T", axis="y").values
    slid = found.position.sel(node="B", axis="x").values - span
    # a spring force N pushes the foot back; P/2 = N tan(a)
    np.testing.assert_allclose(found.load_factor, 2 * 100.0 * slid * y / np.sqrt(1 - y**2), atol=1e-9)
    np.testing.assert_allclose(found.length.sel(member=["a", "b"]), 1.0, rtol=1e-13)
    assert found.event_kind.values.tolist() == ["limit", "limit"]
    # dP/da = 0: (cos a - cos a0)/cos^2 a = sin a tan a ... cos^3 a = cos a0
    assert found.limit_points[0] == pytest.approx(400 * (1 - span ** (2 / 3)) ** 1.5, rel=1e-10)


def dome(strain="engineering"):
    """24 bars (Levy & Spillers 2003, sec. 2.4.2), a unit load of 220.46 lbf on the crown."""
    at = [(0, 0, 3.2346), (4.92125, 8.5239, 2.4472), (-4.92125, 8.5239, 2.4472), (-9.8425, 0, 2.4472),
          (-4.92125, -8.5239, 2.4472), (4.92125, -8.5239, 2.4472), (9.8425, 0, 2.4472), (0, 19.685, 0),
          (-17.0472, 9.8425, 0), (-17.0472, -9.8425, 0), (0, -19.685, 0), (17.0472, -9.8425, 0),
          (17.0472, 9.8425, 0)]  # fmt: skip
    pairs = [(1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (6, 12), (7, 12), (7, 13), (2, 13), (2, 8), (3, 8), (3, 9), (4, 9),
             (4, 10), (5, 10), (5, 11), (6, 11), (2, 3), (3, 4), (4, 5), (5, 6), (6, 7), (7, 2)]  # fmt: skip
    area = 0.0155 * INCH**2
    return kt.Model(
        nodes={str(k): tuple(c * INCH for c in xyz) for k, xyz in enumerate(at, 1)}, fixed=[str(k) for k in range(8, 14)],
        bars={f"{a}-{b}": kt.Bar(ends=(str(a), str(b)), kind="elastic", mass=0.0, strain=strain) for a, b in pairs},
        section=kt.General(area=area, I2=1e-12, I3=1e-12, c2=0.001, c3=0.001),
        material=kt.Material(E=30e6 * POUND / INCH**2, density=0.0),
        loads={"crown": kt.NodalForce(node="1", force=(0, 0, -220.46 * POUND))},
    )  # fmt: skip


@pytest.mark.slow
def test_star_dome():
    model = dome()
    linear = kt.statics.linear(model).displacement.sel(node="1", axis="z").item() / INCH
    assert linear == pytest.approx(-0.20641183795, rel=1e-9)
    found = kt.statics.path(model, "crown", to=1e-4, points=5, step=1e-6)
    assert found.load_factor.values[-1] == pytest.approx(1e-4, rel=1e-12)
    sag = (found.position.sel(node="1", axis="z").values[-1] / INCH - 3.2346) / 1e-4
    assert sag == pytest.approx(linear, rel=1e-3)
    # strain measures differ by little before the crown snaps
    limits = [kt.statics.path(dome(strain), "crown", points=40).limit_points[0] for strain in ("engineering", "green")]
    assert limits[0] == pytest.approx(limits[1], rel=2e-3)


def test_ends_at_a_load_factor_and_other_loads_stay():
    model = von_mises("engineering").with_(
        loads={"load": kt.NodalForce(node="T", force=(0, -0.001)), "own": kt.NodalForce(node="T", force=(0, -0.002))}
    )
    found = kt.statics.path(model, "load", to=5.0)
    assert found.load_factor.values[-1] == pytest.approx(5.0, rel=1e-14)
    y = found.position.sel(node="T", axis="y").values
    np.testing.assert_allclose(0.002 + 0.001 * found.load_factor, closed_form("engineering", y), atol=1e-14)
    rest = kt.statics.equilibrium(model.with_(loads={"all": kt.NodalForce(node="T", force=(0, -0.007))}))
    np.testing.assert_allclose(found.position.values[-1], rest.position, atol=1e-12)
    for name in ("member_force", "reaction"):
        np.testing.assert_allclose(found.data[name].values[-1], rest.data[name], atol=1e-13)
    up = kt.statics.path(model, {"load": 2.0}, to=-3.0, sense=-1)
    y = up.position.sel(node="T", axis="y").values[-1]
    assert closed_form("engineering", y) == pytest.approx(0.002 - 0.006, rel=1e-10)
    cased = model.with_(load_cases={"down": kt.LoadCase(loads={"load": 3.0}), "rest": kt.LoadCase(loads={"own": 1.0})})
    found = kt.statics.path(cased, "down", load_case="rest", to=1.0)
    y = found.position.sel(node="T", axis="y").values[-1]
    assert closed_form("engineering", y) == pytest.approx(0.005, rel=1e-12)


@pytest.mark.slow
def test_refusals():
    model = von_mises("engineering")
    for load, fields, text in (
        ("lod", {}, "No load called 'lod' to scale. Did you mean 'load'"), ("load", {"points": 1}, "at least 2 points"),
        ("load", {"step": 0.2}, "step <= largest_step"), ("load", {"start": np.zeros((2, 2))}, "position: shape"),
        ({"load": 0.0}, {}, "has no force on a free node"), ("load", {"load_case": "x"}, "No load case called 'x'"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=text):
            kt.statics.path(model, load, **fields)
    loose = kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=1.0)}, fixed=["A"], gravity=(0, -9.81),
                     loads={"l": kt.NodalForce(node="B", force=(1.0, 0))})  # fmt: skip
    with pytest.raises(AnalysisError, match="has no equilibrium before the load"):
        kt.statics.path(loose, "l")


def arch():
    """Three hinges that sag on soft legs, between two supports; paths of its loads come near one another."""
    nodes = {"0": (0, 0), "1": (0.90961936, 0.15319132), "2": (2.05828836, 0.47395922), "3": (3.13422769, 0.27684502),
             "4": (4, 0), "5": (0.73875026, -1), "6": (2.14188719, -1), "7": (3.31726059, -1)}  # fmt: skip
    pairs = ["01", "12", "23", "34", "15", "26", "37"]
    axial = [1.94550631, 0.72578725, 1.22331858, 1.84207379, 0.04003932, 0.04887202, 0.01894984]
    forces = {"1": (0.00154208, -0.0086146), "2": (-0.00101779, -0.00728284), "3": (-0.0011533, -0.00814814)}
    length = {one: np.hypot(*np.subtract(nodes[one[1]], nodes[one[0]])) for one in pairs}
    bars = {
        one: kt.Bar(ends=tuple(one), kind="elastic", stiffness=EA / length[one]) for one, EA in zip(pairs, axial, strict=True)
    }
    loads = {f"at-{node}": kt.NodalForce(node=node, force=force) for node, force in forces.items()}
    return kt.Model(nodes=nodes, fixed=["0", "4", "5", "6", "7"], bars=bars, loads=loads)


@pytest.mark.slow
@pytest.mark.parametrize(("largest", "points"), [(0.5, 60), (0.05, 90), (0.03, 120)])
def test_long_steps_stay_on_the_branch(largest, points):
    """With steps of 0.03 a corrector that may go anywhere ends on another branch, whose limit is 40.5."""
    model = arch()
    found = kt.statics.path(
        model, dict.fromkeys(model.loads, 1.0), points=points, step=min(largest, 0.02), largest_step=largest
    )
    # by an arc-length code of its own with steps of 0.0005
    np.testing.assert_allclose(found.limit_points[:2], [10.76508, 8.46229], rtol=5e-6)
    moved = np.linalg.norm(np.diff(found.position.values, axis=0).reshape(points - 1, -1), axis=1)
    assert moved.max() < 1.01 * largest * 4
