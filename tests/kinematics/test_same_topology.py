"""Models that differ in places and lengths only share their plans, and nothing else."""

from __future__ import annotations

import math
from dataclasses import fields

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import dynamics, kinematics
from kinetruss.library import example_files
from kinetruss.mechanics import compile
from kinetruss.mechanics.numbers import compile_moved


def arch(height: float, **bars: object) -> kt.Model:
    """Two struts over supports 2 m apart, 1 kN on top."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (1, height)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")} | bars,
        loads={"top": kt.NodalForce(node="C", force=(0, -1000.0))},
    )  # fmt: skip


@pytest.mark.parametrize("height", [0.2, 1.0, 3.0, 0.7])
def test_forces_are_those_of_its_own_places(height):
    model = arch(height)
    x = kinematics.assemble(model)[None]
    forces = dynamics.inverse(model, kinematics.from_arrays(model, [0.0], x, 0 * x, 0 * x), static=False)
    wanted = -500 * math.hypot(1, height) / height
    np.testing.assert_allclose(forces.arrays["member_force"].values[0], wanted, rtol=1e-14)


@pytest.mark.parametrize("length", [1.2, 1.5, 1.3])
def test_lengths_are_its_own(length):
    bars = {name: kt.Bar(ends=ends, length=length) for name, ends in {"a": ("A", "C"), "b": ("B", "C")}.items()}
    np.testing.assert_allclose(kinematics.assemble(arch(0.7, **bars))[2], (1, math.sqrt(length**2 - 1)), rtol=1e-14)


@pytest.mark.parametrize(("height", "loose"), [(1e-3, 0), (1e-5, 0), (1e-7, 0), (3e-9, 0), (1e-10, 1), (0.0, 1)])
def test_the_rank_beside_a_flat_position_is_that_of_the_singular_values(height, loose):
    assert kinematics.mobility(arch(height)).undriven == loose


@pytest.mark.parametrize("name", ["four_bar", "loader_crane", "planar_crane", "stewart", "landing_gear", "adaptive_footbridge"])
def test_a_model_whose_nodes_move_compiles_to_the_arrays_that_it_has_by_itself(name):
    model = kt.read(example_files()[name][0])
    nodes = {
        one: node.with_(at=tuple(1e-3 * k + value for value in node.at)) for k, (one, node) in enumerate(model.nodes.items())
    }
    alone, moved = model.with_(nodes=nodes), model.moved(nodes)
    compile_moved(moved, model)
    assert moved == alone
    one, other = compile(alone), compile(moved)
    assert other.given is moved
    for field in fields(one):
        wanted = getattr(one, field.name)
        if isinstance(wanted, np.ndarray):
            np.testing.assert_array_equal(getattr(other, field.name), wanted, field.name)


def test_a_model_whose_nodes_move_has_the_faults_of_their_places():
    model = arch(1.0)
    nodes = model.nodes | {"C": kt.Node(at=(2, 0))}
    with pytest.raises(kt.ModelError) as alone:
        model.with_(nodes=nodes)
    with pytest.raises(kt.ModelError, match="zero length") as moved:
        model.moved(nodes)
    assert moved.value.faults == alone.value.faults
