"""Named Jacobians: complex step, differences of assembled configurations, inverses, refusals."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.kernels.motion.placement import place_bay

BASE, LONGERON = 48 * 0.0254, 35 * 0.0254
POSE = ["bay.beta", "bay.gamma", "bay.height"]
ROOM = st.floats(-0.2, 0.2), st.floats(-0.2, 0.2), st.floats(0.8, 1.05)


def bay(beta=0.1, gamma=0.05, height=1.1):
    return kt.library.vgt.double_octahedral(beta=beta, gamma=gamma, height=height)


def fourbar():
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)},
        fixed=("A", "D"),
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        drives={"motor": kt.AngleDrive("crank")},
    )


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(*ROOM)
def test_nodes_and_lengths_by_pose_against_complex_step(beta, gamma, height):
    h, pose = 1e-30, (beta, gamma, height)
    found = kt.kinematics.jacobian(bay(*pose), of=["N8", "N4", "M9"], wrt=POSE).values
    for k in range(3):
        nodes = place_bay(BASE, LONGERON, *(q + 1j * h * (k == j) for j, q in enumerate(pose)))
        between = nodes[4] - nodes[5]
        expected = np.r_[nodes[7], nodes[3], np.sqrt(between @ between)].imag / h
        np.testing.assert_allclose(found[:, k], expected, atol=1e-13)


def test_every_row_length_against_differences_of_configurations():
    model, h = bay(), 1e-5
    names = ["M7", "M9", "M11", "M2", "M16", "M19"]
    found = kt.kinematics.jacobian(model, of=list(model.nodes), wrt=names)
    for name in names:
        member = model.members[name]
        ends = [np.array(model.nodes[end].at) for end in member.ends]
        L = np.linalg.norm(ends[1] - ends[0])
        ahead, back = (kt.kinematics.assemble(model, {name: L + s * h}) for s in (1, -1))
        np.testing.assert_allclose(found.sel(wrt=name).values, ((ahead - back) / (2 * h)).reshape(-1), atol=2e-8)


def test_lengths_by_node_is_the_inverse_of_node_by_lengths():
    model = bay()
    there = kt.kinematics.jacobian(model, of="N8").values
    back = kt.kinematics.jacobian(model, of=["M7", "M9", "M11"], wrt="N8").values
    np.testing.assert_allclose(back @ there, np.eye(3), atol=1e-13)


def test_pose_by_lengths_is_the_inverse_of_lengths_by_pose():
    model = bay()
    there = kt.kinematics.jacobian(model, of=POSE).values
    back = kt.kinematics.jacobian(model, of=["M7", "M9", "M11"], wrt=POSE).values
    np.testing.assert_allclose(back @ there, np.eye(3), atol=1e-12)
    one = kt.kinematics.jacobian(model, of=["M7", "M9", "M11"], wrt="bay.gamma").values
    np.testing.assert_allclose(one[:, 0], back[:, 1], atol=1e-14)


def test_chain_rule_along_a_motion():
    """J times the drive rates is the velocity, at every sample."""
    model = kt.library.vgt.double_octahedral(3)
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(3, beta=(0, 0.15), gamma=(0, 0.1)), samples=7)
    J = kt.kinematics.jacobian(model, motion, of="B3.N8")
    assert J.dims == ("time", "of", "wrt")
    v = np.einsum("tow,tw->to", J.values, motion.drive_velocity.values)
    np.testing.assert_allclose(v, motion.velocity.sel(node="B3.N8").values, atol=1e-13)


def test_a_settling_support_and_a_rigid_turn():
    """Supports that all move alike carry every node along; a turned base turns it."""
    model = bay()
    J = kt.kinematics.jacobian(model, of="N8", wrt=["N1", "N2", "N3"]).values
    np.testing.assert_allclose(J.reshape(3, 3, 3).sum(axis=1), np.eye(3), atol=1e-13)
    spin = np.cross([0.2, -0.1, 0.3], [model.nodes[f"N{k}"].at for k in (1, 2, 3)])
    expected = np.cross([0.2, -0.1, 0.3], model.nodes["N8"].at)
    np.testing.assert_allclose(J @ spin.reshape(-1), expected, atol=1e-13)


def test_angles_of_a_four_bar():
    """Angle of the coupler by the crank's: the relative instantaneous centre (Kennedy)."""
    model = fourbar()
    J = kt.kinematics.jacobian(model, of=["coupler.angle", "rocker.angle", "motor", "C.x"])
    A, B, C, D = (np.array(model.nodes[n].at) for n in "ABCD")
    # instantaneous centre of the coupler: where crank line and rocker line meet
    s, _ = np.linalg.solve(np.stack([B - A, C - D], axis=1), D - A)
    P = A + s * (B - A)
    ratio = -np.linalg.norm(B - A) / np.linalg.norm(B - P) * np.sign((B - A) @ (P - B))
    assert J.sel(of="coupler.angle").item() == pytest.approx(ratio, rel=1e-13)
    speed = ratio * np.array([-(C - P)[1], (C - P)[0]])
    assert J.sel(of="C.x").item() == pytest.approx(speed[0], rel=1e-13)
    assert J.sel(of="motor").item() == 1.0
    assert list(J.of_unit.values) == ["rad", "rad", "rad", "m"]
    turned = kt.kinematics.jacobian(model, of="motor", wrt="rocker.angle").item()
    assert turned * J.sel(of="rocker.angle").item() == pytest.approx(1, rel=1e-13)


def test_coordinate_drive_and_state_given_as_positions():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 1), "C": (2, 0)},
        fixed={"A": "xy", "C": "y"},
        bars={"a": ("A", "B"), "b": ("B", "C")},
        drives={"slide": kt.CoordinateDrive(node="C", axis="x")},
    )
    J = kt.kinematics.jacobian(model, of="B", wrt="slide").values
    np.testing.assert_allclose(J[:, 0], [0.5, -0.5], atol=1e-15)
    moved = [[0, 0], [np.sqrt(2) * 0.6, np.sqrt(2) * 0.8], [2 * np.sqrt(2) * 0.6, 0]]
    J = kt.kinematics.jacobian(model, moved, of="B", wrt="C.x").values
    np.testing.assert_allclose(J[:, 0], [0.5, -0.5 * 0.6 / 0.8], atol=1e-15)


@pytest.mark.parametrize(
    ("of", "wrt", "message"),
    [
        ("N88", None, r"No coordinate called 'N88'. Did you mean"),
        ("bay.betta", None, "'bay.beta'"),
        ("N8", ["N7", "N8.x"], "are 4, wanted are 3"),
        ("N8", ["M7", "M7.length"], "named twice"),
        ("N8", ["N7.x", "N7.y", "M19.length"], "are 3, wanted are 4"),
        ([], None, "No coordinate is named"),
    ],
)
def test_refusals(of, wrt, message):
    with pytest.raises(InputError, match=message):
        kt.kinematics.jacobian(bay(), of=of, wrt=wrt)


def test_names_that_are_a_node_and_a_member():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)},
        fixed=["A"],
        bars={"B": {"ends": ("A", "B"), "kind": "driven", "length": 2.0}},
        drives={"turn": kt.AngleDrive("B"), "B2": kt.LengthDrive("B")},
    )
    with pytest.raises(InputError, match=r"a node and a member. Write B\.x"):
        kt.kinematics.jacobian(model, of="B")
    assert kt.kinematics.jacobian(model, of=["B.x", "B.length"], wrt="B2").values.tolist() == [[1.0], [1.0]]


def test_rows_held_twice_cannot_change_alone():
    square = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    bars = {"b": ("B", "C"), "c": ("C", "D"), "d": ("D", "A"), "e": ("A", "C"), "f": ("B", "D")}
    model = kt.Model(nodes=square, fixed=["A", "B"], bars=bars)
    with pytest.raises(InputError, match="held by other bars"):
        kt.kinematics.jacobian(model, of="C", wrt="e")
    with pytest.raises(InputError, match="freedom"):
        kt.kinematics.jacobian(model.with_(bars={k: bars[k] for k in "bcd"}), of="C", wrt="b")
    flat = fourbar().with_(nodes={"A": (0, 0), "B": (0.1, 0), "C": (0.3, 0.2), "D": (0.4, 0)})
    with pytest.raises(InputError, match="do not fix the configuration"):
        kt.kinematics.jacobian(flat, of="C", wrt="B.x")


# -- every kind of coordinate by every kind of parameter, against differences of models that are built and closed again --------


def slider():
    """A crank that drives a block on the x axis; the foot of the crank is a coordinate drive of its own."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0.1, 0.2), "C": (0.6, 0)}, fixed={"A": "y", "C": "y"},
        bars={"crank": ("A", "B"), "rod": ("B", "C")},
        drives={"foot": kt.CoordinateDrive(node="A", axis="x"), "motor": kt.AngleDrive("crank")},
    )  # fmt: skip


def elbow():
    """Two bars with a hinge drive between them; the first is turned against the ground."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0.4, 0.1), "C": (0.7, 0.4)}, fixed=["A"], bars={"upper": ("A", "B"), "lower": ("B", "C")},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.HingeDrive(axis="B", start="A", end="C")},
    )  # fmt: skip


def rows_at(model):
    """All prescribed lengths and angles of a model as it stands, to be kept while something else changes."""
    turned = [name for name, drive in model.all_drives.items() if isinstance(drive, (kt.AngleDrive, kt.HingeDrive))]
    names = [*model.members, *turned]
    return dict(zip(names, measured(model, names, np.array([node.at for node in model.nodes.values()])), strict=True))


def positions_after(model, name, step):
    """Node positions with one parameter changed by `step`, everything else that is prescribed held."""
    drive, (whole, _, axis) = model.all_drives.get(name), name.rpartition(".")
    if isinstance(drive, (kt.AngleDrive, kt.HingeDrive, kt.CoordinateDrive)):
        start = float(measured(model, [name], np.array([node.at for node in model.nodes.values()]))[0])
        motion = kt.kinematics.follow(model, kt.Quintic(moves={name: (start, start + step)}, duration=1), samples=2)
        return motion.position.values[-1]
    if whole in model.fixed:
        at = list(model.nodes[whole].at)
        at["xyz".index(axis)] += step
        moved = model.with_(nodes=dict(model.nodes) | {whole: model.nodes[whole].with_(at=at)})
        return kt.kinematics.assemble(moved, rows_at(model))
    return kt.kinematics.assemble(model, {name: rows_at(model)[name] + step})


def measured(model, names, position):
    """Values of coordinates at positions (n, dim), found without the code under test: from nodes, `platform`, NumPy."""
    at = dict(zip(model.nodes, position, strict=True))
    still = np.zeros((1, *position.shape))
    motion = kt.kinematics.from_arrays(model, [0.0], position[None], still, still)
    found = []
    for name in names:
        whole, _, part = name.rpartition(".")
        if whole in model.poses:
            seen = kt.kinematics.platform(model, motion, ("N7", "N9", "N8"), base=("N1", "N2", "N3"))
            found.append(float(seen[part][0]))
        elif part == "angle" or isinstance(model.all_drives.get(name), kt.AngleDrive):
            p, q = (at[end] for end in model.members[whole or model.all_drives[name].bar].ends)
            found.append(float(np.arctan2(*(q - p)[::-1])))
        elif isinstance(drive := model.all_drives.get(name), kt.HingeDrive):
            one, other = (at[end] - at[drive.axis[0]] for end in (drive.start, drive.end))
            found.append(float(np.arctan2(one[0] * other[1] - one[1] * other[0], one @ other)))
        elif isinstance(drive, kt.CoordinateDrive):
            found.append(float(at[drive.node]["xyz".index(drive.axis)]))
        elif name in model.members:
            p, q = (at[end] for end in model.members[name].ends)
            found.append(float(np.linalg.norm(q - p)))
        else:
            found.append(float(at[whole]["xyz".index(part)]))
    return np.array(found)


CASES = {
    "bay": (
        lambda: kt.library.vgt.double_octahedral(beta=0.1, gamma=-0.07, height=1.05),
        [*POSE, "N8.x", "N4.z", "M9", "M6", "N1.x"],
        ["M6", "M1", "M20", "M15", "M7", "M11", "N1.x", "N2.z", "N3.y"],
    ),
    "fourbar": (
        fourbar, ["rocker.angle", "C.x", "motor", "crank", "D.x"], ["crank", "coupler", "rocker", "motor", "A.x", "D.y", "D.x"],
    ),
    "slider": (slider, ["C.x", "rod.angle", "foot", "motor", "B.y"], ["foot", "motor", "crank", "rod", "C.y", "A.y"]),
    "elbow": (elbow, ["C.x", "C.y", "lower.angle", "elbow", "shoulder"], ["shoulder", "elbow", "upper", "lower", "A.x"]),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_every_kind_of_coordinate_by_every_kind_of_parameter(case):
    """Central differences of models that are built anew: a support moved, a rigid bar lengthened, a drive turned."""
    make, of, wrt = CASES[case]
    model, h = make(), 1e-5
    found = kt.kinematics.jacobian(model, of=of, wrt=wrt)
    for name in wrt:
        ahead, back = (measured(model, of, positions_after(model, name, s * h)) for s in (1, -1))
        np.testing.assert_allclose(found.sel(wrt=name).values, (ahead - back) / (2 * h), atol=3e-8, err_msg=f"by {name}")


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(*ROOM, st.sampled_from(["M1", "M2", "M3", "M4", "M5", "M6", "M13", "M14", "M15", "M16", "M17", "M18", "M19", "M21"]))
def test_pose_by_any_rigid_bar_of_any_bay(beta, gamma, height, bar):
    model, h = bay(beta, gamma, height), 1e-5
    found = kt.kinematics.jacobian(model, of=POSE, wrt=bar).values[:, 0]
    ahead, back = (measured(model, POSE, positions_after(model, bar, s * h)) for s in (1, -1))
    np.testing.assert_allclose(found, (ahead - back) / (2 * h), atol=1e-6 * max(1.0, np.abs(found).max()))


def test_pose_of_a_bay_that_stands_askew():
    """Supports turned as one leave the pose as it is: its gradient is seen from its own base."""
    model = bay()
    at = np.array([node.at for node in model.nodes.values()])
    spin = np.cross([0.3, -0.2, 0.5], at).reshape(-1)
    supports = [f"{name}.{axis}" for name in ("N1", "N2", "N3") for axis in "xyz"]
    by = kt.kinematics.jacobian(model, of=[*POSE, "N8"], wrt=supports).values
    np.testing.assert_allclose(by[:3] @ spin[:9], 0.0, atol=1e-13)
    np.testing.assert_allclose(by[3:] @ spin[:9], spin[21:24], atol=1e-13)


@pytest.mark.slow
@pytest.mark.parametrize("make", [elbow, slider, fourbar])
def test_a_platform_by_the_drives_against_differences(make):
    model, h = make(), 1e-5
    nodes = ("B", "C")
    found = kt.kinematics.platform_jacobian(model, nodes).jacobian.values
    for k, name in enumerate(model.all_drives):
        pair = np.stack([positions_after(model, name, s * h)[[1, 2]] for s in (1, -1)])
        middle = (pair[0] - pair[1]).mean(axis=0) / (2 * h)
        ends = pair[:, 1] - pair[:, 0]
        turned = np.arctan2(ends[1, 0] * ends[0, 1] - ends[1, 1] * ends[0, 0], ends[0] @ ends[1]) / (2 * h)
        np.testing.assert_allclose(found[:, k], [*middle, turned], atol=3e-8)


def test_a_support_that_a_rigid_bar_holds_to_another_cannot_move_alone():
    """A bar between two supports adds no rank, yet what stretches it is no motion: along it refused, across it allowed."""
    tied = bay().with_(bars=dict(bay().bars) | {"tie": kt.Bar(ends=("N1", "N2"), mass=0)})
    with pytest.raises(InputError, match="'N1.x' cannot change alone: 'tie' holds it"):
        kt.kinematics.jacobian(tied, of="bay.gamma", wrt="N1.x")
    with pytest.raises(InputError, match="'tie' is held by other bars"):
        kt.kinematics.jacobian(tied, of="bay.gamma", wrt="tie")
    across = (kt.kinematics.jacobian(model, of=POSE, wrt=["N1.z", "M6"]).values for model in (tied, bay()))
    np.testing.assert_allclose(*across, atol=1e-13)
