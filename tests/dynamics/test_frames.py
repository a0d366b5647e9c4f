"""Sides of coordinates: what each does to one frame, and that they are all that a coordinate does; resultants on frames."""

from typing import Any

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.bar_actions import actions_of
from kinetruss.mechanics import compile, measure_gradients
from kinetruss.mechanics.frames import bar_pushes, resultant, side_forces, sides_of

HINGE, COORDINATE = kt.HingeDrive, kt.CoordinateDrive
PLANE: dict[str, Any] = {
    "hinge": {"coordinate": HINGE(axis="O", start="G", end="P")},
    "between": {"coordinate": HINGE(axis="P", start="O", end="Q")},
    "offset": {"coordinate": kt.OffsetCoordinate(line=("O", "P"), point="Q")},
    "length": {"coordinate": kt.LengthDrive("b")},
    "angle": {"coordinate": kt.AngleDrive("b")},
    "places": {"terms": ((COORDINATE(node="P", axis="x"), 1.0), (COORDINATE(node="Q", axis="y"), -0.4))},
    "sum": {"terms": ((kt.AngleDrive("a"), 1.0), (kt.AngleDrive("b"), -1.0))},
}
SPACE: dict[str, Any] = {
    "hinge": {"coordinate": HINGE(axis=("O", "P"), start="G", end="Q")},
    "angle": {"coordinate": kt.AngleDrive("b", axis=(0.1, 0.2, 1.0))},
    "length": {"coordinate": kt.LengthDrive("b")},
}


def sprung(dim: int) -> kt.Model:
    """Two bars with a spring on every kind of coordinate."""
    at = {"O": (0, 0, 0), "G": (1, -0.4, 0.3), "P": (0.5, 0.6, 0.2), "Q": (1.2, 0.4, -0.5)}
    return kt.Model(
        nodes={name: place[:dim] for name, place in at.items()},
        fixed=["O", "G"],
        bars={"a": ("O", "P"), "b": ("P", "Q")},
        springs={name: kt.Spring(stiffness=1.0, **on) for name, on in (PLANE if dim == 2 else SPACE).items()},
    )


@pytest.mark.parametrize("dim", [2, 3])
def test_the_sides_of_a_coordinate_are_its_gradient(dim: int) -> None:
    """Added up at the nodes; and each but those of places is in balance, a couple about its axis where it turns."""
    system = compile(sprung(dim))
    x = np.random.default_rng(4).normal(size=(5, *system.x0.shape)) * (np.arange(3) < dim)
    for m, name in enumerate(system.measures):
        found = np.zeros_like(x)
        own = [side for side in sides_of(system) if side.source == ("spring", name)]
        assert own
        for side in own:
            forces, place = side_forces(system, side, x), x[:, list(side.nodes)]
            np.add.at(found, (slice(None), list(side.nodes)), forces)
            if side.weights is not None:
                continue
            force, couple = resultant(place, forces, place[:, 1])
            size = np.abs(forces).max()
            assert np.abs(force).max() < 1e-12 * size
            if side.turns and len(side.nodes) == 3:
                axis = place[:, 2] - place[:, 1]
                axis /= np.linalg.norm(axis, axis=1)[:, None]
                # 1 N m about the axis, on either side
                assert np.abs(np.einsum("tc,tc->t", couple, axis)) == pytest.approx(1.0)
            elif side.turns and dim == 2:
                assert np.abs(couple[:, 2]) == pytest.approx(1.0)
        assert found == pytest.approx(measure_gradients(system, m, x).reshape(x.shape), abs=1e-12 * np.abs(found).max())


def test_bars_pull_on_nodes_and_their_resultant_is_that_of_a_cut() -> None:
    """Of a triangle cut through two bars: the forces of both, and their moment about the third node."""
    model = kt.Model(nodes={"A": (0, 0), "B": (3, 0), "C": (0, 4)}, fixed=["A", "B"], bars={"b": ("C", "B"), "a": ("A", "C")})
    system = compile(model)
    x = np.broadcast_to(system.x0, (2, 3, 3))
    tension = np.array([[10.0, 1.0], [-5.0, 0.0]])
    push = bar_pushes(system, x, [0, 1], tension, [2, 0])
    assert push[0] == pytest.approx(np.array([[6.0, -9.0, 0.0], [0.0, 1.0, 0.0]]))
    force, couple = resultant(x[:, [2]], push[:, :1], x[:, 0])
    assert force == pytest.approx(np.array([[6.0, -9.0, 0.0], [-3.0, 4.0, 0.0]]))
    assert couple[:, 2] == pytest.approx([-24.0, 12.0])


def test_couples_of_a_hinge_act_on_the_bars_from_its_axis() -> None:
    """In the plane on both bars at the joint, turned against each other; of a fixed side there is no bar."""
    system = compile(sprung(2))
    found = {
        name: (system.members[one.member], one.place)
        for name, one in zip(actions_of(system, "").names, actions_of(system, "").actions, strict=True)
    }
    assert found["hinge on a"] == ("a", 0.0)
    assert found["between on a"] == ("a", 1.0) and found["between on b"] == ("b", 0.0)
