"""Robots with loops from URDF and MJCF: inverse dynamics against minimal coordinates, masses against the programs."""

from pathlib import Path

import numpy as np

import kinetruss as kt
from reference.loops import MujocoTree, PinocchioTree, Tree

DATA = Path(__file__).parents[1] / "data"


def torques(model: kt.Model, moves: dict[str, tuple[float, float]]) -> tuple[np.ndarray, list[np.ndarray]]:
    """Of the drives along a motion, and their values, rates and accelerations."""
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=9)
    forces = kt.dynamics.inverse(model, motion)
    names = list(moves)
    given = [getattr(motion, key).sel(drive=names).values for key in ("drive_position", "drive_velocity", "drive_acceleration")]
    return forces.drive_force.sel(drive=names).values, given


def against(tree: Tree, model: kt.Model, moves: dict[str, tuple[float, float]]) -> None:
    found, given = torques(model, moves)
    wanted = tree.torques(*given)
    assert np.abs(wanted).max() > 1.0
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())


def test_five_bar_against_pinocchio():
    found = kt.exchange.read(DATA / "robot.urdf", closures=DATA / "robot.yaml")
    tree = PinocchioTree(DATA / "robot.urdf", [("tip_left", "tip_right")], ["motor_left", "motor_right"])
    against(tree, found.model, {"motor_left": (0.0, -0.5), "motor_right": (0.0, 0.6)})


def test_three_arms_against_mujoco():
    found = kt.exchange.read(DATA / "parallel.xml")
    tree = MujocoTree(DATA / "parallel.xml", ["motor1", "motor2", "motor3"])
    against(tree, found.model, {"motor1": (0.0, 0.4), "motor2": (0.0, -0.3), "motor3": (0.0, 0.2)})
