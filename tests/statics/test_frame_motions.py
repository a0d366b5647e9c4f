"""Frames of beams as displacements and rotations: against the direct stiffness method, and against all their nodes."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.spatial.transform import Rotation

import kinetruss as kt
from frame_models import portal
from kinetruss.mechanics import compile, constraint_jacobian
from kinetruss.statics import small_displacements
from kinetruss.statics.frame_motions import frames_of, motions_of
from kinetruss.statics.small_displacements import stiff_rows

E, A, I = 70e9, 2e-3, 3e-6
SECTION = kt.General(area=A, I2=I, I3=I, c2=0.05, c3=0.05, J=2 * I)
MATTER = {"section": SECTION, "material": kt.Material(E=E, density=0.0, poisson=0.3)}


def direct(places, beams, held, forces):
    """Displacements and rotations (nodes, 3) of a frame in the plane by the direct stiffness method."""
    K = np.zeros((3 * len(places),) * 2)
    for a, b in beams:
        d = np.subtract(places[b], places[a])
        L, (c, s) = math.hypot(*d), d / math.hypot(*d)
        k = np.zeros((6, 6))
        k[np.ix_([0, 3], [0, 3])] = E * A / L * np.array([[1, -1], [-1, 1]])
        k[np.ix_([1, 2, 4, 5], [1, 2, 4, 5])] = (E * I / L**3) * np.array(
            [
                [12, 6 * L, -12, 6 * L],
                [6 * L, 4 * L**2, -6 * L, 2 * L**2],
                [-12, -6 * L, 12, -6 * L],
                [6 * L, 2 * L**2, -6 * L, 4 * L**2],
            ]
        )
        T = np.kron(np.eye(2), [[c, s, 0], [-s, c, 0], [0, 0, 1]])
        at = [*range(3 * a, 3 * a + 3), *range(3 * b, 3 * b + 3)]
        K[np.ix_(at, at)] += T.T @ k @ T
    free = np.setdiff1d(np.arange(len(K)), held)
    u = np.zeros(len(K))
    u[free] = np.linalg.solve(K[np.ix_(free, free)], np.asarray(forces, float).reshape(-1)[free])
    return u.reshape(-1, 3)


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 10**6), bays=st.integers(1, 3), storeys=st.integers(1, 3))
def test_random_frames_as_by_the_direct_stiffness_method(seed, bays, storeys):
    chance = np.random.default_rng(seed)
    grid = [(i, j) for i in range(bays + 1) for j in range(storeys + 1)]
    places = np.array(grid, float) * [4.0, 3.0] + 0.5 * chance.uniform(-1, 1, (len(grid), 2))
    number = {one: k for k, one in enumerate(grid)}
    beams = [(number[i, j], number[i, j + 1]) for i, j in grid if j < storeys]
    beams += [(number[i, j], number[i + 1, j]) for i, j in grid if j and i < bays]
    feet = [number[i, 0] for i in range(bays + 1)]
    forces = np.zeros((len(grid), 3))
    forces[:, :2] = 1e3 * chance.uniform(-1, 1, (len(grid), 2))
    forces[feet] = 0.0
    wanted = direct(places, beams, [3 * k + i for k in feet for i in range(3)], forces)
    model = kt.Model(
        nodes={f"N{k}": at.tolist() for k, at in enumerate(places)},
        beams={f"b{k}": (f"N{a}", f"N{b}") for k, (a, b) in enumerate(beams)},
        clamped=[f"N{k}" for k in feet],
        loads={f"P{k}": kt.NodalForce(node=f"N{k}", force=f[:2].tolist()) for k, f in enumerate(forces) if f.any()},
        **MATTER,
    )
    found = kt.statics.linear(model)
    assert found.displacement.values == pytest.approx(wanted[:, :2], abs=1e-9 * np.abs(wanted).max())
    tips = found.whole["displacement"]
    size = model.whole.inner.frames[f"N{len(grid) - 1}"].size
    turned = (tips.sel(node=f"N{len(grid) - 1}.d1") - tips.sel(node=f"N{len(grid) - 1}")).values
    assert turned == pytest.approx([0.0, size * wanted[-1, 2]], abs=1e-9 * np.abs(wanted).max())


SPACE = {"A": (0, 0, 0), "B": (1.0, 0.2, 0.1), "C": (1.3, 1.1, -0.2), "D": (1.2, 0.1, 0.9)}


def spatial(**changes) -> kt.Model:
    beams = {
        "a": ("A", "B"),
        "b": kt.Beam(ends=("B", "C"), orientation=(0, 1, 3)),
        "c": kt.Beam(ends=("D", "B"), **changes.pop("c", {})),
    }
    fields = {
        "nodes": SPACE,
        "beams": beams,
        "clamped": ["A", "D"],
        "loads": {"P": kt.NodalForce(node="C", force=(3.0, -7.0, 5.0))},
    }
    return kt.Model(**(fields | MATTER | changes))


MODELS = {
    "portal": portal,
    "space": spatial,
    "released": lambda: spatial(c={"release": ["B"]}),
    "hinged": lambda: spatial(c={"hinges": {"B": 2}}),
    "rigid": lambda: spatial(c={"kind": "rigid"}),
    "elastic foot": lambda: spatial(
        clamped=["D"], supports={"A": kt.Support(x="held", y=1e5, z="held", rotation_y=1e4, rotation_x="held", along=(1, 1, 0))}
    ),
    "pinned foot": lambda: spatial(clamped=["D"], fixed={"A": "xz", "D": "xyz"}),
}


@pytest.mark.parametrize("name", MODELS)
def test_the_same_as_with_all_nodes(name, monkeypatch):
    """Displacements, reactions, and the forces of the bars of frames, with and without."""
    model = MODELS[name]()
    found = kt.statics.linear(model)
    assert len(frames_of(stiff_rows(compile(model))).node)
    monkeypatch.setattr(small_displacements, "motions_of", lambda *_: None)
    whole = kt.statics.linear(model.with_(title="the same"))
    for key in ("displacement", "member_force", "reaction", "reaction_moment"):
        one, two = found.whole[key].values, whole.whole[key].values
        assert one == pytest.approx(two, abs=1e-8 * np.abs(two).max()), key


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (0.4, -1.0, 0.7)])
def test_motions_keep_the_bars_of_frames(turn):
    """G T = 0 in any position, and T has all motions of the frame."""
    system = stiff_rows(compile(spatial()))
    x = Rotation.from_rotvec(turn).apply(system.x0.copy())
    motions = motions_of(system, x)
    G = constraint_jacobian(system, x)[:, system.free]
    assert abs(G[~motions.kept] @ motions.to).max() < 1e-13
    tips = motions.frames.node[:, 1:].size
    assert motions.to.shape[0] - motions.to.shape[1] == 3 * tips - 3 * len(motions.frames.node)
    assert np.linalg.matrix_rank(motions.to.toarray()) == motions.to.shape[1]
