"""Random trusses for tests, by public names alone."""

from __future__ import annotations

import numpy as np

import kinetruss as kt


def truss(seed, dim, *, massless, driven, braced=False, sized=False, length=None):
    """A chain of triangles (tetrahedra) that grows node by node, hung up at one end, with some bars left out or driven.

    braced: bars that are redundant. sized: all bars with E and A. Returns model, tasks, trajectory.
    """
    rng = np.random.default_rng(seed)
    count = length or int(rng.integers(2, 6))
    per = 2 if dim == 2 else 3
    nodes = {
        f"N{i}": tuple(np.append(np.eye(dim)[i][: dim - 1] if i < dim - 1 else np.zeros(dim - 1), 0.0)) for i in range(per)
    }
    bars, mass = {}, {"section": "s", "material": "m"} if sized else {"mass": 0.5}
    names = list(nodes)
    for layer in range(1, count + 1):
        old = names[-per:]
        for i in range(per):
            at = np.array(nodes[f"N{i}"]) + rng.uniform(-0.15, 0.15, dim)
            at[-1] = layer + rng.uniform(-0.15, 0.15)
            nodes[f"N{len(nodes)}"] = tuple(at)
        new = list(nodes)[-per:]
        names += new
        pairs = [(old[i], new[j]) for i in range(per) for j in range(per) if braced or (i + layer) % per != j or i == 0]
        pairs += [(new[i], new[j]) for i in range(per) for j in range(i)]
        for p, q in pairs:
            bars[f"{p}{q}"] = {"ends": (p, q), **mass}
    fixed = tuple(names[:per])
    if not braced:
        bars = _independent(rng, nodes, bars, fixed, dim)
    records = {name: {"at": at, "mass": 0.0 if sized else float(rng.uniform(0, 1))} for name, at in nodes.items()}
    if massless:
        _bare_node(rng, records, bars, names, dim)
    last, drives, tasks, trajectory = list(bars)[-1], {}, {}, None
    if driven:
        drives["d"] = kt.LengthDrive(last)
        trajectory = kt.Sine(amplitudes={"d": 0.02}, period=1.0, duration=1.0)
    else:
        bars[last] = {"ends": bars[last]["ends"], "kind": "elastic", "stiffness": 100.0, "damping": 1.0}
    extra = {"sections": {"s": kt.Rod(diameter=0.02)}, "materials": {"m": kt.library.materials.STEEL_S235}} if sized else {}
    model = kt.Model(
        nodes=records, bars=bars, fixed=fixed, drives=drives, gravity=(0.0,) * (dim - 1) + (-9.81,),
        loads={"push": {"node": names[-1], "times": [0.0, 1.0], "forces": [[1.0] * dim, [3.0] * dim]}}, **extra,
    )  # fmt: skip
    return model, tasks, trajectory


def _independent(rng, nodes, bars, fixed, dim):
    """A random set of independent bars that leaves a few motions."""
    free = {name: i for i, name in enumerate(name for name in nodes if name not in fixed)}
    kept, rows = {}, np.zeros((0, dim * len(free)))
    wanted = dim * len(free) - int(rng.integers(1, 4))
    for name in rng.permutation(list(bars)):
        p, q = bars[name]["ends"]
        d = np.array(nodes[q]) - np.array(nodes[p])
        row = np.zeros(dim * len(free))
        for node, sign in ((p, -1), (q, 1)):
            if node in free:
                row[dim * free[node] : dim * free[node] + dim] = sign * d / np.linalg.norm(d)
        more = np.vstack([rows, row])
        if len(kept) < wanted and np.linalg.svd(more, compute_uv=False)[-1] > 0.05:
            kept[str(name)], rows = bars[name], more
    return kept


def _bare_node(rng, records, bars, names, dim):
    """A node without mass, held by bars without mass at nodes in general position."""
    ends = [names[k] for k in rng.permutation(len(names))[:dim]]
    at = np.mean([records[n]["at"] for n in ends], axis=0) + 0.7 * (1 + np.arange(dim)) / dim
    records["bare"] = {"at": tuple(at), "mass": 0.0}
    bare = {f"bare{n}": {"ends": (n, "bare"), "mass": 0.0} for n in ends}
    rest = dict(bars)
    bars.clear()
    bars.update(bare | rest)
