"""Numbers and sizes beyond all measure are refused before memory is taken: in files, in library parameters, in Python."""

import subprocess
import sys

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.kinematics import follow
from kinetruss.library import builders, mechanisms, meshes, vgt
from kinetruss.limits import MOST_COUNT, MOST_ENTRIES, MOST_SAMPLES, hold, whole

BAY = vgt.double_octahedral()
SLEW = vgt.slew(beta=(0, 0.1))
HUGE = 10**9

TOO_MANY = {
    "bays": lambda: vgt.double_octahedral(HUGE),
    "bays of a slew": lambda: vgt.slew(HUGE, beta=(0, 0.1)),
    "links": lambda: mechanisms.n_pendulum(HUGE),
    "loops": lambda: mechanisms.n_four_bar(HUGE),
    "columns": lambda: meshes.rectangle(width=1, height=1, columns=HUGE, rows=1),
    "columns and rows": lambda: meshes.rectangle(width=1, height=1, columns=10**4, rows=10**4),
    "cells": lambda: meshes.box(size=(1, 1, 1), cells=(HUGE, 1, 1)),
    "samples": lambda: follow(BAY, SLEW, samples=HUGE),
    "samples held at once": lambda: follow(BAY, SLEW, samples=MOST_SAMPLES),
    "samples of a run": lambda: kt.Run(trajectory=SLEW, samples=HUGE),
    "samples of an inverse": lambda: kt.kinematics.inverse(BAY, kt.Quintic(moves={"N8.x": (0, 0.1)}, duration=1), samples=HUGE),
    "samples of a simulation": lambda: kt.dynamics.simulate(mechanisms.pendulum(), 1.0, samples=HUGE),
    "steps": lambda: kt.dynamics.simulate(mechanisms.pendulum(), 1.0, method=kt.EnergyMomentum(step=1e-20)),
    "steps of a run": lambda: kt.Run(analysis="dynamics.simulate", t_end=1, method=kt.Rattle(step=1e-20)),
    "block": lambda: kt.run(BAY.with_(runs={"go": kt.Run(trajectory=SLEW)}), block=10**12),
    "run kept in memory": lambda: kt.run(BAY.with_(runs={"go": kt.Run(trajectory=SLEW, samples=MOST_SAMPLES)})),
    "variants": lambda: kt.runs.variants(BAY, {f"nodes.N{k}.mass": range(100) for k in (7, 8, 9)}),
    "max_steps": lambda: kt.DOP853(max_steps=10**30),
}


@pytest.mark.parametrize("make", TOO_MANY.values(), ids=TOO_MANY)
def test_too_many_are_refused(make):
    with pytest.raises(kt.InputError, match=r"limit of|at most|longer steps|beyond"):
        make()


@pytest.mark.parametrize("number", ["1e200", "-1e200", "1e-200", "1e31", "9" * 400])
def test_library_numbers_beyond_measure(number):
    """Every number of every library model: an answer of kinetruss' own, whatever it is."""
    for name, record in builders().items():
        for parameter in record.model_fields:
            try:
                kt.library.build(name, {parameter: number})
            except kt.ModelError as error:
                assert error.faults[0].mend
            except TypeError as error:  # a parameter that must be given is not there
                assert "missing" in str(error)


@pytest.mark.slow
def test_tables_of_too_many_names():
    nodes = {f"N{k}": (float(k), 0.0) for k in range(MOST_ENTRIES + 1)}
    with pytest.raises(kt.ModelError, match=f"nodes: has {MOST_ENTRIES + 1} entries; expected at most {MOST_ENTRIES}"):
        kt.Model(nodes=nodes)


@pytest.mark.slow
def test_a_small_file_takes_no_memory(tmp_path):
    """Under a limit of memory that a billion of anything would break."""
    file = tmp_path / "many.yaml"
    file.write_text("kinetruss: 1\nlibrary: {name: vgt.double_octahedral, bays: 1e9}\n")
    limit = "import resource, sys, kinetruss as kt; kt.check(kt.library.vgt.double_octahedral()); "
    limit += "base = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize(); "
    limit += "resource.setrlimit(resource.RLIMIT_AS, (base + (100 << 20),) * 2); print(kt.check(sys.argv[1])[0])"
    done = subprocess.run([sys.executable, "-c", limit, str(file)], capture_output=True, text=True, timeout=100, check=False)
    assert done.stdout.startswith("library.bays: '1e9' must be at most"), done.stderr


def test_whole_numbers():
    assert whole(np.int64(7), "samples") == 7
    for value in (True, 2.0, "3", None, 0, 10**5000):
        with pytest.raises(kt.InputError, match="samples is"):
            whole(value, "samples", least=1, most=MOST_COUNT)
    with pytest.raises(kt.InputError, match=r"A run would hold 1,000 numbers, more than the limit of 10\. Take fewer\."):
        hold(1000, "A run", "Take fewer.", most=10)


@pytest.mark.slow
@pytest.mark.parametrize("name", kt.library.example_files())
def test_a_node_without_one_coordinate(name):
    """Whatever names the node: its own fault is told, and others only of what does not rest on it."""
    model = kt.read(kt.library.example_files()[name][0])
    whole_model = {key: getattr(model, key) for key in model.model_fields_set}
    for node in list(model.nodes)[:: max(1, len(model.nodes) // 5)]:
        at = model.nodes[node].at
        other = {"at": at[:2] if len(at) == 3 else (*at, 0.0)}
        if len(model.nodes) > 2:
            with pytest.raises(kt.ModelError) as caught:
                kt.Model(**whole_model | {"nodes": model.nodes | {node: other}})
            first, *rest = caught.value.faults
            assert first.path == ("nodes", node, "at")
            assert rest == []
