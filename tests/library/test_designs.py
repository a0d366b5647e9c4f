"""The examples that decide: the tasks of optima beside the models, checked without the code that searched."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.library import example_files


def task_of(name):
    (file,) = [one for one in example_files()[name] if ".optimum." in one.name]
    return kt.io.read_optimum(file)


def reached(model, run):
    """Of a fresh run: the largest voltage, speed and torque of the motors (V, rad/s, N m), and the utilisation of members."""
    found = kt.run(model, run)
    (demand,) = found.demand.values()
    largest = [float(np.abs(getattr(demand, name)).max()) for name in ("voltage", "motor_speed", "motor_torque")]
    (forces,) = found.forces.values()
    return *largest, float(np.nanmax(kt.strength.check(model, forces).utilisation.values))


def widened(task, found, name, share=0.01):
    """The task with one limit moved by a share of it, searched from what was found."""
    one = task.limits[name]
    wider = {side: float(at) * (1 + share) for side in ("at_most", "at_least") if (at := getattr(one, side)) is not None}
    variables = {one: own.with_(start=found.values[one]) for one, own in task.variables.items()}
    return task.with_(variables=variables, limits={**task.limits, name: one.with_(**wider)})


def test_every_task_beside_an_example_names_it():
    tasks = {name: task_of(name) for name, files in example_files().items() if any(".optimum." in one.name for one in files)}
    assert {"double_octahedral_slew", "slewing_experiments", "triangular_truss"} <= set(tasks)
    for name, task in tasks.items():
        assert task.model == str(example_files()[name][0])
        assert task.title


@pytest.mark.slow
def test_the_triangular_truss_is_as_fast_as_its_voltage():
    task = task_of("triangular_truss")
    found = kt.design.optimise(None, task)
    assert found.certificate.first_order
    voltage, _, _, used = reached(found.model, "extend")
    assert voltage == pytest.approx(25, rel=1e-6)
    assert used < 1
    faster = kt.design.optimise(None, widened(task, found, "voltage"))
    saved = sum(one.price for one in found.active) * 0.01 * 25
    assert found.objective - faster.objective == pytest.approx(saved, rel=0.03)


@pytest.mark.slow
def test_the_slew_is_held_by_speed_and_torque_of_its_motors():
    """Members and voltage leave room; 1 % more of either limit saves what its price says; lists need a larger motor."""
    task = task_of("double_octahedral_slew")
    found = kt.design.optimise(None, task)
    assert found.certificate.first_order
    motor = found.model.motors["motor"]
    voltage, speed, torque, used = reached(found.model, "slew")
    assert voltage < 0.8 * 25
    assert speed == pytest.approx(0.8 * motor.max_speed, rel=1e-6)
    assert torque == pytest.approx(0.8 * motor.max_torque, rel=1e-6)
    assert used < 1
    price = {one.name.split()[0]: one.price for one in found.active}
    assert set(price) == {"lead", "speed", "torque"}
    assert kt.actuators.is_self_locking(found.model.screws["screw"])
    for name in ("speed", "torque"):
        faster = kt.design.optimise(None, widened(task, found, name))
        assert found.objective - faster.objective == pytest.approx(0.008 * price[name], rel=0.03)
    sized = found.listed.sizing.model
    assert found.listed.excess <= 0
    assert reached(sized, "slew")[3] <= 1
    assert not kt.actuators.exceeded(kt.run(sized, "slew").demand["all"])
    assert found.listed.sizing.drives[0].motor > "motor_d1.0"


@pytest.mark.slow
def test_the_experiments_need_no_more_than_25_volts_and_less_mass():
    """Limits are kept in both experiments and reached by members; the voltage costs no mass; lists cost little."""
    task = task_of("slewing_experiments")
    found = kt.design.optimise(None, task)
    assert found.certificate.first_order
    fresh = [reached(found.model, run) for run in ("experiment_1", "experiment_2")]
    assert max(one[0] for one in fresh) <= 25 * (1 + 1e-6)
    assert max(one[3] for one in fresh) == pytest.approx(1, abs=1e-5)
    assert not any(one.name.startswith("voltage") and one.price for one in found.active)
    wider = kt.design.optimise(None, widened(task, found, "utilisation"))
    saved = 0.01 * sum(one.price for one in found.active if one.name.startswith("utilisation"))
    assert found.objective - wider.objective == pytest.approx(saved, rel=0.05)
    sized = found.listed.sizing.model
    for run in ("experiment_1", "experiment_2"):
        voltage, _, _, used = reached(sized, run)
        assert voltage <= 25
        assert used <= 1
    assert 0 < found.listed.objective / found.objective - 1 < 0.03
