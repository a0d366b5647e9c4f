"""Loops with redundant rigid rows come to rest on all of their rows, wherever they hang to."""

from itertools import combinations

import numpy as np
import pytest

import kinetruss as kt
import loop_models


@pytest.mark.slow
@pytest.mark.parametrize("name", loop_models.STARTS)
@pytest.mark.parametrize("gravity", [(0.0, 0.0, -9.81), (9.81, 0.0, 0.0), (0.0, -6.0, 7.0)])
def test_all_lengths_are_kept_and_weight_does_no_work(name, gravity):
    data = getattr(loop_models, name)()
    model = loop_models.loop(data, loop_models.angles_at(data, 1.0, np.array(loop_models.STARTS[name])))
    rest = kt.statics.equilibrium(model.with_(drives={}, gravity=gravity))
    names, x = list(model.nodes), rest.position.values
    start = np.array([model.nodes[n].at for n in names])
    rows, weight = [], np.zeros(x.size)
    for body in model.bodies.values():
        places = [names.index(n) for n in body.nodes]
        for i, j in combinations(places, 2):
            assert np.linalg.norm(x[i] - x[j]) == pytest.approx(np.linalg.norm(start[i] - start[j]), abs=1e-11)
            row = np.zeros(x.shape)
            row[i], row[j] = x[i] - x[j], x[j] - x[i]
            rows.append(row.reshape(-1))
        for i in places:  # the mass is spread evenly over the four carriers of a body
            weight[3 * i : 3 * i + 3] += body.mass / 4 * np.array(gravity)
    free = [3 * i + k for i, n in enumerate(names) if n not in model.fixed for k in range(3)]
    way = np.linalg.svd(np.array(rows)[:, free])[2][-1]
    assert abs(way @ weight[free]) < 1e-8 * np.abs(weight).max()
    assert rest.stable
