"""Joints by name: the freedoms that they leave, and that the bodies move as the classical joint lets them."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt

AXIS, OTHER = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.0, 0.0])
PLACE = {2: np.array([1.1, 0.2]), 3: np.array([1.1, 0.2, 0.1])}
JOINTS: dict[str, tuple[int, str, dict[str, Any]]] = {
    "spherical": (3, "spherical", {}),
    "revolute": (3, "revolute", {"axis": AXIS}),
    "universal": (3, "universal", {"axes": (AXIS, OTHER)}),
    "prismatic": (3, "prismatic", {"axis": AXIS}),
    "cylindrical": (3, "cylindrical", {"axis": AXIS}),
    "planar": (3, "planar", {"axis": AXIS}),
    "weld": (3, "weld", {}),
    "plane.pin": (2, "pin", {}),
    "plane.weld": (2, "weld", {}),
    "plane.prismatic": (2, "prismatic", {"axis": AXIS[1:]}),
    "plane.parallelogram": (2, "parallelogram", {"axis": AXIS[1:]}),
    "plane.double_parallelogram": (2, "parallelogram", {"axis": AXIS[1:], "double": True}),
}
"""Dimension, function, arguments."""


def pair(name: str) -> kt.Model:
    """Two free bodies with the joint between them."""
    dim, function, given = JOINTS[name]
    corners = np.vstack([np.zeros(dim), np.eye(dim)])
    places = {"A": corners, "B": np.array([1.2, 0.3, 0.1])[:dim] + 0.8 * corners}
    model = kt.Model(
        nodes={f"{body}{k}": tuple(at) for body, table in places.items() for k, at in enumerate(table)},
        bodies={
            body: kt.Body(nodes=[f"{body}{k}" for k in range(dim + 1)], mass=mass) for body, mass in (("A", 1.5), ("B", 2.0))
        },
    )
    made: kt.Model = getattr(kt.library.joints, function)(model, "joint", bodies=("A", "B"), at=PLACE[dim], **given)
    return made


def freedoms(name: str) -> dict[str, float]:
    """Relative degrees of freedom by rank, and number of redundant bars."""
    model = pair(name)
    found = kt.kinematics.mobility(model)
    return {"freedoms": found.degrees_of_freedom - (3 if model.dim == 2 else 6), "redundant": found.self_stress}


def motion(name: str) -> dict[str, float]:
    """Largest deviation from the classical joint, m and rad, while the bodies move."""
    model = pair(name)
    found = kt.kinematics.mobility(model)
    modes = found.mechanisms.reshape(len(found.mechanisms), -1)
    basis = np.linalg.qr(modes.T)[0]
    speed = (basis @ np.cos(1.0 + np.arange(basis.shape[1]))).reshape(found.mechanisms.shape[1:])
    moving = {node: tuple(v) for node, v in zip(found.node_names, speed, strict=True) if v.any()}
    run = kt.dynamics.simulate(model.with_(velocities=moving), 0.3, samples=4)
    (R, d), (S, e) = (_moved(run.motion.data, model, body) for body in "AB")
    place = PLACE[model.dim]
    way = S @ place + e - R @ place - d
    kept = _kept(name, model, np.swapaxes(R, 1, 2) @ S, np.einsum("tji,tj->ti", R, way))
    return {"deviation": float(max(np.abs(part).max() for part in kept))}


def _moved(data: Any, model: kt.Model, body: str) -> tuple[Any, Any]:
    """Rotation and displacement of a body, x = R x0 + d."""
    names = [f"{body}{k}" for k in range(model.dim + 1)]
    start = np.array([model.nodes[name].at for name in names])
    x = data.position.sel(node=names).values
    R = np.swapaxes(x[:, 1:] - x[:, :1], 1, 2) @ np.linalg.inv((start[1:] - start[0]).T)
    return R, x[:, 0] - R @ start[0]


def _kept(name: str, model: kt.Model, Q: Any, p: Any) -> list[Any]:
    """What the classical joint keeps at 0: Q turns the second body in the first, p moves its point at the joint there."""
    u, v = AXIS[-model.dim :], OTHER[: model.dim]
    turned, off = Q - np.eye(model.dim), p - (p @ u)[:, None] * u
    kind = name.removeprefix("plane.")
    if kind == "parallelogram":
        link = np.subtract(model.nodes["joint.3"].at, model.nodes["joint.1"].at)
        return [turned, np.linalg.norm(p + link, axis=1) - np.linalg.norm(link)]
    return {
        "spherical": [p],
        "pin": [p],
        "revolute": [p, turned @ u],
        "weld": [p, turned],
        "universal": [p, (Q @ v) @ u],
        "prismatic": [turned, off],
        "cylindrical": [turned @ u, off],
        "planar": [turned @ u, p @ u],
        "double_parallelogram": [turned],
    }[kind]


def fall(name: str) -> dict[str, float]:
    """How far a body on the ground has slid down a steep axis, or in an upright plane, after 0.2 s, m."""
    axis = {"prismatic": (0.6, 0.0, 0.8), "cylindrical": (0.0, 0.0, 1.0), "planar": (0.0, 1.0, 0.0)}[name]
    corners = np.array([1.2, 0.3, 0.1]) + 0.8 * np.vstack([np.zeros(3), np.eye(3)])
    model = kt.Model(
        nodes={f"B{k}": tuple(at) for k, at in enumerate(corners)},
        bodies={"B": kt.Body(nodes=[f"B{k}" for k in range(4)], mass=2.0)},
        gravity=(0.0, 0.0, -9.81),
    )
    hung = getattr(kt.library.joints, name)(model, "joint", bodies=("ground", "B"), at=PLACE[3], axis=axis)
    x = kt.dynamics.simulate(hung, 0.2, samples=2).motion.position.sel(node=[f"B{k}" for k in range(4)]).mean("node").values
    return {"z": float(x[1, 2] - x[0, 2])}
