"""Inverse kinematics of a docking task: ten double-octahedral bays, 30 drives, 6 coordinates.

python bench/docking.py            # a table
python bench/docking.py --json     # {"rows": [{"case", "seconds", "poses", "us_per_pose", "peak_mb"}]}
python bench/docking.py --cold 10000

`warm`: poses of a path, each from those before, with exact rates and accelerations of all drives and nodes (the kernel).
`motion`: the same by `kinematics.inverse`. `cold`: random poses that random lengths within the strokes reach, each solved from
the straight chain; all of them must be reached.
"""

import argparse
import json
import resource
import time

import numpy as np

import kinetruss as kt
from kinetruss.kinematics.task_courses import at_values, parameters_of
from kinetruss.kinematics.task_problem import drive_path, problem
from kinetruss.mechanics import compile

BAYS = 10
TOP = tuple(f"B{BAYS}.N{k}" for k in (7, 9, 8))
STROKE = ("42 in", "50 in")


def bent():
    """The chain with other lengths, so that it can do all six motions."""
    model = kt.library.vgt.double_octahedral(bays=BAYS, limits=STROKE)
    rng = np.random.default_rng(0)
    lengths = {name: 46 * 0.0254 + rng.uniform(-0.04, 0.04) for name in model.all_drives}
    x = kt.kinematics.assemble(model, lengths)
    nodes = zip(model.nodes.items(), x.tolist(), strict=True)
    return model.with_(nodes={name: node.with_(at=tuple(at)) for (name, node), at in nodes})


def row(case, seconds, poses):
    """One measurement."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return {"case": case, "seconds": seconds, "poses": poses, "us_per_pose": 1e6 * seconds / poses, "peak_mb": peak}


def best(call, repeats=5):
    """Shortest time of some calls, s."""
    found = []
    for _ in range(repeats):
        begin = time.perf_counter()
        call()
        found.append(time.perf_counter() - begin)
    return min(found)


def warm_rows(poses=1001):
    """The kernel alone, and the whole motion."""
    model = bent()
    centre = np.mean([model.nodes[name].at for name in TOP], axis=0)
    task = kt.Docking(platform=TOP, moves={"x": float(centre[0]) + 0.3, "yaw": "5 deg"}, duration=2.0)
    motion = kt.kinematics.inverse(model, task, samples=poses)
    assert motion.status.ok, motion.message
    given = problem(compile(model), task, task)
    t = np.linspace(0, 2, poses)
    parameters = parameters_of(given.tasks, given.tasks.start(given.begin.x), t)
    assert given.track(t, parameters, given.begin)[1] == poses
    yield row("docking_warm", best(lambda: _whole(given.track(t, parameters, given.begin), poses)), poses)
    yield row("docking_motion", best(lambda: kt.kinematics.inverse(model, task, samples=poses), 3), poses)


def _whole(found, poses):
    """Refuses a path that ended early."""
    assert found[1] == poses, f"the path ended after {found[1]} of {poses} poses"


def cold_row(poses=200, seed=1):
    """Random poses from the straight chain; raises where one is not reached."""
    model = kt.library.vgt.double_octahedral(bays=BAYS, limits=STROKE)
    given = problem(compile(model), task := kt.Docking(platform=TOP), task)
    rng, wanted = np.random.default_rng(seed), []
    while len(wanted) < poses:
        q = rng.uniform(given.drives.lower, given.drives.upper)
        if (x := drive_path(given.system, np.stack([given.begin.q, q]), given.begin.x)) is not None:
            wanted.append(x)
    parameters = at_values(given.tasks, given.tasks.read(np.stack(wanted)))
    given.reach(parameters[0])
    begin = time.perf_counter()
    missed = [k for k, one in enumerate(parameters) if given.reach(one).far > 1e-8 * given.scale]
    seconds = time.perf_counter() - begin
    if missed:
        raise SystemExit(f"{len(missed)} of {poses} poses were not reached: {missed[:10]}")
    return row("docking_cold", seconds, poses)


def rows(cold=200):
    """All measurements."""
    return [*warm_rows(), cold_row(cold)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--cold", type=int, default=200, help="random poses")
    options = parser.parse_args()
    found = rows(options.cold)
    if options.json:
        print(json.dumps({"rows": found}))
        return
    for one in found:
        print(f"{one['case']:16} {one['poses']:6d} poses {one['us_per_pose']:10.1f} us/pose {one['peak_mb']:8.0f} MB")


if __name__ == "__main__":
    main()
