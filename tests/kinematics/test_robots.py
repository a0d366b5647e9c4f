"""Jacobians, gauges, stiffness and workspaces of parallel robots against closed forms."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.library import mechanisms


def five_bar():
    """Two legs of changing length to one point: everything about it is a triangle."""
    leg = {"kind": "driven"}
    return kt.Model(nodes={"A": (0, 0), "B": (1, 0), "P": (0.5, 1)}, fixed=["A", "B"],
                    bars={"a": {"ends": ("A", "P"), **leg}, "b": {"ends": ("B", "P"), **leg}})  # fmt: skip


def stewart(turned=(0.1, -0.2, 0.3), at=(0.05, -0.02, 0.62)):
    model = mechanisms.stewart(turned=turned, at=at)
    return model, [name for name in model.nodes if name.startswith("P")]


def test_legs_of_a_stewart_platform_move_by_u_and_b_cross_u():
    model, platform = stewart()
    found = kt.kinematics.platform_jacobian(model, platform)
    middle = np.mean([model.nodes[name].at for name in platform], axis=0)
    rows = []
    for name in found["drive"].values:
        a, b = (np.array(model.nodes[end].at) for end in model.bars[str(name)].ends)
        u = (b - a) / np.linalg.norm(b - a)
        rows.append(np.r_[u, np.cross(b - middle, u)])
    assert np.abs(found.inverse.values - np.array(rows)).max() < 1e-11
    assert np.abs(found.jacobian.values @ np.array(rows) - np.eye(6)).max() < 1e-11


def test_a_stewart_platform_turned_by_a_right_angle_is_singular():
    # Fichter (1986): a platform over its base, turned 90 deg about the vertical, has a screw motion with all legs held
    model, platform = stewart(turned=(0, 0, np.pi / 2 - 0.02), at=(0, 0, 0.6))
    near = kt.kinematics.platform_jacobian(model, platform)
    far = kt.kinematics.platform_jacobian(*stewart(turned=(0, 0, 0.0), at=(0, 0, 0.6)))
    assert near.parallel < 0.1 * far.parallel


def test_stiffness_is_that_of_springs_in_the_legs():
    model, platform = stewart()
    k = dict(zip([f"leg{i}" for i in range(1, 7)], np.linspace(1e5, 6e5, 6), strict=True))
    found = kt.statics.platform_stiffness(model, platform, k)
    rows = kt.kinematics.platform_jacobian(model, platform).inverse.values
    K = rows.T @ np.diag(list(k.values())) @ rows
    assert np.abs(found.stiffness.values - K).max() < 1e-9 * np.abs(K).max()
    # against the stiffness method: the legs as elastic bars, a small force at the platform
    bars = model.bars | {name: model.bars[name].model_copy(update={"kind": "elastic", "stiffness": k[name]}) for name in k}
    plain = model.with_(bars=bars, gravity=None, drives={}, runs={}, trajectories={})
    share = {f"f{n}": kt.NodalForce(node=n, force=(3.0, -2.0, 5.0)) for n in platform}
    moved = kt.statics.linear(plain.with_(loads=share))
    at = moved.data["displacement"].sel(node=platform).values.reshape(-1, len(platform), 3).mean(axis=1)[0]
    wanted = found.compliance.values[:3, :3] @ np.array([3.0, -2.0, 5.0]) * len(platform)
    assert np.abs(at - wanted).max() < 1e-9 * np.abs(wanted).max()


@pytest.mark.slow
def test_workspace_of_two_legs_is_two_circles():
    model = five_bar()
    u, v = np.linspace(-0.6, 1.6, 23), np.linspace(0.05, 1.5, 15)
    found = kt.kinematics.workspace(model, "P", ("x", u), ("y", v), limits={"a": (0.4, 1.3), "b": (0.4, 1.3)})
    x, y = np.meshgrid(u, v)
    a, b = np.hypot(x, y), np.hypot(x - 1, y)
    assert found.reachable.values.all()
    assert np.array_equal(found.within.values, (a >= 0.4) & (a <= 1.3) & (b >= 0.4) & (b <= 1.3))
    assert np.abs(found.drive_position.sel(drive="a").values - a).max() < 1e-13
    sine = np.abs(x * y - (x - 1) * y) / (a * b)  # angle between the legs: the smallest singular value of two unit rows
    assert np.abs(found.parallel.values - np.sqrt(1 - np.sqrt(1 - sine**2))).max() < 1e-7


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda m: kt.kinematics.workspace(m, "X", ("x", [0]), ("y", [1])), "No node called 'X'"),
        (lambda m: kt.kinematics.workspace(m, "P", ("x", [0]), ("x", [1])), "different axes"),
        (lambda m: kt.kinematics.workspace(m, "P", ("x", [1, 0]), ("y", [1])), "increasing"),
        (lambda m: kt.kinematics.workspace(m, "P", ("x", [0]), ("y", [1]), limits={"a": (2, 1)}), "least, largest"),
        (lambda m: kt.kinematics.workspace(m.with_(fixed=["A"]), "P", ("x", [0]), ("y", [1]), limits={"q": (0, 1)}), "drive"),
        (lambda m: kt.kinematics.platform_jacobian(m, ("A", "B", "X")), "No node"),
        (lambda m: kt.statics.platform_stiffness(m, ("A", "P"), {"a": -1.0}), "above 0"),
        (lambda m: kt.statics.platform_stiffness(m, ("A", "P"), {"c": 1.0}), "No drive"),
        (lambda m: kt.statics.platform_stiffness(m, ("A", "P"), np.inf), "finite"),
        (lambda m: kt.kinematics.platform_jacobian(m, ("A", "P"), length=-1.0), "length=-1 must be greater than 0"),
        (lambda m: kt.kinematics.platform_jacobian(m, ("A", "P"), [(0, 0), (1, 0), (0.5, np.nan)]), r"\['P', 1\]: nan"),
        (lambda m: kt.kinematics.assembly_modes(m, {"a": -1.0}), "of a length above 0"),
    ],
)
def test_faults_are_told(call, words):
    with pytest.raises(InputError, match=words):
        call(five_bar())


def test_a_grid_out_of_reach_is_told_as_such():
    found = kt.kinematics.workspace(mechanisms.delta(), "Q", ("x", [50.0, 60.0]), ("y", [50.0]))
    assert not found.reachable.any() and np.isnan(found.drive_position).all()
