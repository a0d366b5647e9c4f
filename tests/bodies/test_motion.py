"""Bodies in motion: flat ones on nodes beside their plane, planar ones that grow."""

import numpy as np
import pytest

import kinetruss as kt

bodies = kt.library.bodies
TIGHT = {"rtol": 1e-11, "atol": 1e-11}


@pytest.mark.parametrize("solver", ["dense", "sparse"])
def test_a_plate_swings_alike_on_three_nodes_and_on_four(solver):
    """The mass matrix of the four is singular; the motion is not."""
    ground = kt.Model(nodes={"O": (0.0, 0, 0)}, fixed=["O"], gravity=(0, 0, -9.81))
    plate, nodes = bodies.plate_properties((1, 2), mass=2.0, at=(0.3, 0.2, 0.1)), {"O": None, "P": (1, 0.3, 0.5)}
    points = np.array([[0.1, 0, -0.3], [1.1, 0, -0.3], [0.3, 1, -0.3], [0.2, 0.2, 0.7]])
    end = []
    for places in (None, points):
        model = bodies.rigid(ground, "b", plate, nodes=nodes, points=places)
        run = kt.dynamics.simulate(model, t_end=0.5, method=kt.DOP853(solver=solver, **TIGHT))
        end.append(run.motion.position.sel(node="P").values[-1])
    assert np.abs(end[0] - end[1]).max() < 1e-11


def test_a_planar_body_grows_with_its_bar():
    model = kt.Model(
        nodes={"A": (0.0, 0), "B": (1.0, 0.5)}, fixed={"A": "xy"}, bars={"s": kt.Bar(ends=("A", "B"), kind="driven")},
        bodies={"b": kt.Body(nodes=("A", "B"), mass=1.5, center=(0.2, 0.3), inertia=0.4, kind="straining")},
        drives={"turn": kt.AngleDrive("s")}, gravity=(0, -9.81),
    )  # fmt: skip
    start = {"s": (float(np.hypot(1, 0.5)), 1.6), "turn": (float(np.arctan2(0.5, 1)), 1.2)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=start, duration=1.0), samples=21)
    forces = kt.dynamics.inverse(model, motion)
    assert float(abs(forces.data["energy_balance"]).max()) < 1e-13 * float(abs(forces.data["power"]).max())
