"""The labelled systems: their size, their names, and that they give the product's forces."""

import math

import numpy as np
import pytest

import kinetruss as kt
from reference import newton_euler as oracle
from reference.of_model import external_forces, truss_of
from samples import fourbar, tripod

TILT = math.radians(10)


def solved(model, trajectory, times):
    motion = kt.kinematics.follow(model, trajectory, times=times)
    return motion, kt.dynamics.inverse(model, motion)


def agrees(system, forces=None):
    """Solved by itself it gives the forces of inverse dynamics."""
    assert system.unique
    assert system.difference < 1e-12 * system.largest * system.condition
    assert system.residual < 1e-12 * system.largest


@pytest.fixture(scope="module")
def slewed():
    model = kt.library.vgt.double_octahedral(beta=-TILT, gravity=(0, 0, 9.81), tip_force=(0, 0, 46), payload_mass=3.0)
    return model, *solved(model, kt.library.vgt.slew(beta=(-TILT, TILT)), [0.0, 0.25, 0.6])


@pytest.fixture(scope="module")
def triangle():
    model = kt.library.vgt.triangular()
    return model, *solved(model, kt.library.vgt.lacy_step(), [0.3, 0.6, 1.8])


@pytest.mark.parametrize("time", [0.3, 0.6, 1.8])
def test_triangle_has_eleven_equations(triangle, time):
    model, motion, forces = triangle
    system = kt.dynamics.newton_euler(model, motion, forces, time=time)
    assert system.matrix.shape == (11, 11)
    assert system.joints == ("O1", "O2")
    assert system.equations[:3] == ("follower force x", "follower force y", "follower moment 3")
    assert system.unknowns[-3:] == ("actuator interface axial", "actuator interface shear_2", "actuator interface moment_3")
    agrees(system)
    value = dict(zip(system.unknowns, system.solution, strict=True))
    reaction = forces.reaction.sel(time=time, support="O1").values
    assert (value["follower A x"], value["follower A y"]) == pytest.approx(tuple(reaction))


@pytest.mark.slow
@pytest.mark.parametrize("time", [0.0, 0.25, 0.6])
def test_bay_has_117_equations(slewed, time):
    model, motion, forces = slewed
    system = kt.dynamics.newton_euler(model, motion, forces, time=time)
    assert system.matrix.shape == (117, 117)
    assert len(set(system.equations)) == len(set(system.unknowns)) == 117
    agrees(system)
    assert system.condition == pytest.approx(43, abs=1)
    apart = kt.dynamics.newton_euler(model, motion, forces, time=time, rods="apart")
    assert apart.matrix.shape == (132, 132)
    agrees(apart)
    agrees(kt.dynamics.newton_euler(model, motion, forces.static, time=time))


@pytest.mark.slow
def test_against_the_oracle(slewed):
    """The tests' own 117 equations, which write the moments of active members in another way."""
    model, motion, forces = slewed
    system = kt.dynamics.newton_euler(model, motion, forces, time=0.25)
    sample = [motion.data[name].sel(time=0.25).values for name in ("position", "velocity", "acceleration")]
    truth = oracle.solve(truss_of(model), *sample, external_forces(model))
    value = dict(zip(system.unknowns, system.solution, strict=True))
    for i, member in enumerate(model.members):
        for end, force in (("A", truth.force_a[i]), ("B", truth.force_b[i])):
            assert [value[f"{member} {end} {axis}"] for axis in "xyz"] == pytest.approx(force, abs=1e-11)


def test_motor_torque_and_rods_apart_in_the_plane():
    model = fourbar()
    system = kt.dynamics.newton_euler(model, *solved(model, kt.ConstantRate(rates={"motor": 5.0}, duration=1), [0.2]))
    assert system.matrix.shape == (13, 13)
    agrees(system)
    assert "motor torque" in system.unknowns


@pytest.mark.slow
def test_chain_and_tripod():
    chain = kt.library.vgt.double_octahedral(2, payload_mass=2.0)
    system = kt.dynamics.newton_euler(
        chain, *solved(chain, kt.library.vgt.slew(2, beta=(0, 0.1), gamma=(0, 0.1)), [0.4])
    )  # fmt: skip
    assert system.matrix.shape == (225, 225)
    agrees(system)
    legs = tripod()
    motion, forces = solved(legs, kt.Quintic(moves={"LA": (1.0295630, 1.15)}, duration=1), [0.4])
    together = kt.dynamics.newton_euler(legs, motion, forces, time=0.4)
    assert together.joints == ("A", "B", "C")
    assert together.matrix.shape == (18, 18)
    agrees(together)
    agrees(kt.dynamics.newton_euler(legs, motion, forces, time=0.4, rods="apart"))


def test_pushed_node_and_elastic_bar():
    """A coordinate drive's push; an elastic stay adds its law, a free sensor the absence of one."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0.5), "C": (2, 0), "D": (1, 2)}, fixed={"A": "xy", "C": "y", "D": "xy"},
        gravity=(0, -9.81), section=kt.Rod(diameter=0.01), material=kt.Material(E=2e11, density=7850),
        bars={"a": ("A", "B"), "b": ("B", "C"), "stay": {"ends": ("D", "B"), "kind": "elastic", "natural_length": 1.499},
              "gauge": {"ends": ("A", "C"), "kind": "free"}},
        drives={"push": kt.CoordinateDrive(node="C", axis="x")},
    )  # fmt: skip
    system = kt.dynamics.newton_euler(model, *solved(model, kt.Quintic(moves={"push": (2, 1.9)}, duration=1), [0.3]))
    assert {"stay law", "gauge law"} <= set(system.equations)
    assert "push push" in system.unknowns
    assert system.matrix.shape[0] == system.matrix.shape[1]
    agrees(system)


@pytest.mark.slow
def test_redundant_structure_is_not_determined_but_closes():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}, fixed={"A": "xy", "B": "y"},
        bars={"ab": ("A", "B"), "bc": ("B", "C"), "cd": ("C", "D"), "da": ("D", "A"), "ac": ("A", "C"), "bd": ("B", "D")},
        section=kt.Rod(diameter=0.01), material=kt.Material(E=2e11, density=7850), gravity=(0, -9.81),
        loads={"p": kt.NodalForce(node="C", force=(100, 0))},
    )  # fmt: skip
    still = np.zeros((1, 4, 2))
    motion = kt.kinematics.from_arrays(model, [0.0], kt.kinematics.assemble(model)[None], still, still)
    system = kt.dynamics.newton_euler(model, motion, kt.dynamics.inverse(model, motion))
    assert not system.unique
    assert system.residual < 1e-11
    assert system.matrix @ system.solution == pytest.approx(system.right, abs=1e-10)


@pytest.mark.slow
def test_a_system_too_large_to_read_is_refused():
    chain = kt.library.vgt.double_octahedral(24)
    motion, forces = solved(chain, kt.library.vgt.slew(24, beta=(0, 0.01)), [0.0])
    with pytest.raises(kt.InputError, match="more than 2500"):
        kt.dynamics.newton_euler(chain, motion, forces)
