"""Every bar as a free body: from its end A on, all that acts on it is summed up and must give its section forces.

Forces and couples at the ends, what acts between them, and weight and inertia by quadrature of the motion itself; then nodes:
what members, supports and loads put on them must be what their own masses ask.
"""

import numpy as np
import pytest

import action_models
import kinetruss as kt
from action_models import WAYS, moved
from kinetruss.mechanics import compile, measure_gradients

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(4)
CLOSE = 1e-9


def spatial(y):
    return np.pad(np.asarray(y, float), [(0, 0)] * (np.ndim(y) - 1) + [(0, 3 - np.shape(y)[-1])])


class Cut:
    """One instant of a model and its forces."""

    def __init__(self, model, forces, i):
        self.model, self.data = model, forces.data.isel(time=i)
        motion, still = forces.motion.data.isel(time=i), bool(forces.data.attrs["at_rest"])
        self.x, self.v, self.a = (spatial(motion[name].values) for name in ("position", "velocity", "acceleration"))
        if still:
            self.v, self.a = 0 * self.v, 0 * self.a
        self.g = spatial(np.array(forces.data.attrs["gravity"]))
        self.node = {name: k for k, name in enumerate(model.nodes)}
        self.largest = max(1.0, float(np.abs(self.data.joint_force.values).max()))

    def actions(self, name, sources=False):
        """Place, force, couple and worth of what acts on a member beside its weight."""
        if "action" not in self.data.coords:
            return
        for k in np.flatnonzero(self.data.action_member.values == name):
            one = self.data.isel(action=k)
            worth, couple = spatial(one.action_force.values), one.action_couple.values
            source = (str(one.action_source.item()),) if sources else ()
            yield float(one.action_place), worth.sum(axis=0), np.pad(couple, (3 - len(couple), 0)), *source, worth

    def bend(self, u, L, A, B):
        """u', u''."""
        dv, da = self.v[B] - self.v[A], self.a[B] - self.a[A]
        u1 = (dv - (u @ dv) * u) / L
        L2 = u @ da + L * u1 @ u1
        return u1, (da - L2 * u - 2 * (u @ dv) * u1) / L

    def bar(self, name):
        """Length, ends, and (start, length, mass, rotary, acceleration at a distance) of each rod of a member."""
        member, system = self.model.members[name], compile(self.model)
        A, B = (self.node[end] for end in member.ends)
        d = self.x[B] - self.x[A]
        L = float(np.linalg.norm(d))
        u, k = d / L, system.members.index(name)
        m, l, rotary, mt, lt, rt = system.rods[k]
        if system.two_rods[k]:
            bend = self.bend(u, L, A, B)[1]
            base = (0.0, l, m, rotary, lambda s: self.a[A] + s * bend)
            rods = [base, (L - lt, lt, mt, rt, lambda s: self.a[B] - (L - s) * bend)]
        else:
            rods = [(0.0, L, m, rotary, lambda s: self.a[A] + s / L * (self.a[B] - self.a[A]))]
        return L, u, A, B, rods


def cut_at(cut, name, s, only):
    """Force and moment about the cut at s (m from A) that hold what is left of it: all but the tube, on its A side."""
    L, u, A, B, rods = cut.bar(name)
    force, moment = np.zeros(3), np.zeros(3)
    if only == "tube":
        ends = [(L, spatial(cut.data.joint_force.sel(member=name).values[1]))]
    else:
        ends = [(0.0, spatial(cut.data.joint_force.sel(member=name).values[0]))]
    for at, F in ends:
        force, moment = force + F, moment + np.cross((at - s) * u, F)
    sign = -1.0 if only == "tube" else 1.0
    for place, q, c, worth in cut.actions(name):
        if np.isnan(place):  # spread along the bar, linear
            q0, q1, r = 4 * worth[0] - 2 * worth[1], 6 * (worth[1] - worth[0]), s / L
            force = force + q0 * r + q1 * r**2 / 2
            moment = moment - np.cross(L * u, q0 * r**2 / 2 + q1 * r**3 / 6)
        elif place == 1.0 if only == "tube" else place < s / L - 1e-9 or place == 0.0:
            force, moment = force + q, moment + c + np.cross((place * L - s) * u, q)
    start, length, mass, rotary, field = rods[1 if only == "tube" else 0]
    lo, hi = (s, start + length) if only == "tube" else (start, s)
    for t, weight in zip((hi + lo) / 2 + (hi - lo) / 2 * POINTS, (hi - lo) / 2 * WEIGHTS, strict=True):
        element = weight * mass / length * (field(t) - cut.g)
        force, moment = force - element, moment - np.cross((t - s) * u, element)
    u2 = cut.bend(u, L, A, B)[1]
    moment = moment - rotary * (hi - lo) / length * np.cross(u, u2)
    return -sign * force, -sign * moment


def axes(cut, name, reference):
    u = cut.bar(name)[1]
    if cut.model.dim == 2:
        return np.array([u, [-u[1], u[0], 0], [0, 0, 1]])
    third = np.cross(u, reference)
    third /= np.linalg.norm(third)
    return np.array([u, np.cross(third, u), third])


def in_balance(model, forces):
    """Section forces of every part against the sum of all that acts on its A side (of a tube: on its B side); and all nodes."""
    xi = np.array([0.0, 0.07, 0.31, 0.5, 0.77, 1.0])
    found = kt.strength.sections(model, forces, xi).data
    for i in range(forces.data.sizes["time"]):
        cut = Cut(model, forces, i)
        for part in found.part.values:
            name = str(found.member.sel(part=part).item())
            start, h = (np.array(model.nodes[end].at, float) for end in model.members[name].ends)
            d = spatial(h - start)
            up = [1, 0, 0] if abs(d[2]) > 0.95 * np.linalg.norm(d) else [0, 0, 1]
            frame, at = axes(cut, name, np.array(up, float)), found.sel(part=part).isel(time=i)
            for n in range(len(xi)):
                s = float(at.part_start) + xi[n] * float(at.part_length)
                if str(part).endswith(".base") and s > cut.bar(name)[0] - cut.bar(name)[4][1][1]:
                    continue  # behind the nut the base hangs over
                force, moment = cut_at(cut, name, s, "tube" if str(part).endswith(".tube") else "")
                local, turning = frame @ force, frame @ moment
                got = [float(at.section_T[n]), *at.section_V[n].values]
                np.testing.assert_allclose(got, local[: model.dim], atol=CLOSE * cut.largest, err_msg=f"{part} {xi[n]}")
                wanted = turning[2:] if model.dim == 2 else turning[1:]
                np.testing.assert_allclose(at.section_M[n].values, wanted, atol=CLOSE * cut.largest, err_msg=f"{part} {xi[n]}")
        ends_meet(cut)
        nodes_meet(cut)


def ends_meet(cut):
    """Force at B, and couples at B, close the balance of every member."""
    for name in cut.model.members:
        L, u, *_, rods = cut.bar(name)
        if len(rods) == 2:
            continue
        S, M = cut_at(cut, name, L, "")
        at_b = [(q, c) for place, q, c, _ in cut.actions(name) if place == 1.0]
        F = spatial(cut.data.joint_force.sel(member=name).values[1])
        np.testing.assert_allclose(S, F + sum((q for q, _ in at_b), np.zeros(3)), atol=CLOSE * cut.largest)
        couple = sum((c for _, c in at_b), np.zeros(3))
        np.testing.assert_allclose(np.cross(u, M), np.cross(u, couple), atol=CLOSE * cut.largest)


def nodes_meet(cut):
    """Nothing is left on a node: members, supports, drives of coordinates, nodal loads and its own mass.

    Of drives of several nodes and couplings it bears what their gradient says, less what bars carry of it.
    """
    model, data = cut.model, cut.data
    left = np.zeros((len(model.nodes), 3))
    for name, member in model.members.items():
        for e, end in enumerate(member.ends):
            left[cut.node[end]] -= spatial(data.joint_force.sel(member=name).values[e])
    for name in data.support.values:
        left[cut.node[str(name)]] += spatial(data.reaction.sel(support=name).values)
    for name, drive in model.drives.items():
        if isinstance(drive, kt.CoordinateDrive):
            left[cut.node[drive.node], "xyz".index(drive.axis)] += float(data.drive_force.sel(drive=name))
    for load in model.loads.values():
        if isinstance(load, kt.NodalForce):
            left[cut.node[load.node]] += spatial(np.array(load.force))
    system = compile(model)
    for m, name in enumerate(system.measures):
        amount = data.coupling_force.sel(coupling=name) if name in model.couplings else data.drive_force.sel(drive=name)
        left += float(amount) * measure_gradients(system, m, cut.x[None])[0].reshape(-1, 3)
    for name, member in model.members.items():
        for *_, source, worth in cut.actions(name, sources=True):
            if source.startswith("coupling ") or source.removeprefix("drive ") in system.measures:
                for e, end in enumerate(member.ends):
                    left[cut.node[end]] -= worth[e]
    for name, node in model.nodes.items():
        left[cut.node[name]] += node.mass * (cut.g - cut.a[cut.node[name]])
    np.testing.assert_allclose(left, 0.0, atol=CLOSE * cut.largest)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2, 3, 4])
@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
def test_every_bar_is_in_balance(way, seed):
    rng = np.random.default_rng(seed)
    model = way(rng)
    forces = moved(model, rng)
    assert forces.status.ok
    assert not kt.dynamics.not_on_bars(model)
    in_balance(model, forces)
    in_balance(model, forces.static)


@pytest.mark.slow
@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
def test_bars_of_a_pose_at_rest_are_in_balance(way):
    model = way(np.random.default_rng(77))
    in_balance(model, kt.statics.at_poses(model, [{}]))


@pytest.mark.slow
@pytest.mark.parametrize("way", ["chain", "clamped", "loaded", "gears", "door"])
def test_bars_of_a_simulation_are_in_balance(way):
    """Let go under given torques."""
    model = getattr(action_models, way)(np.random.default_rng(77))
    run = kt.dynamics.simulate(model, 0.05, samples=4, tasks={name: kt.GivenForce(torque=2.0) for name in model.drives})
    in_balance(model, run.forces)


@pytest.mark.slow
@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
def test_free_bodies_and_equations_agree_with_the_sections(way):
    rng = np.random.default_rng(9)
    model = way(rng)
    forces = moved(model, rng, samples=2)
    time = float(forces.data.time[0])
    largest = max(1.0, float(np.abs(forces.data.joint_force.values).max()))
    for member in model.members:
        assert kt.dynamics.free_body(model, forces.motion, forces, member=member, time=time).residual < CLOSE * largest
    for node in model.nodes:
        found = kt.dynamics.free_body(model, forces.motion, forces, node=node, time=time)
        assert found.residual < CLOSE * largest
    system = kt.dynamics.newton_euler(model, forces.motion, forces, time=time)
    assert system.residual < CLOSE * largest
    assert not system.unique or system.difference < 1e-12 * system.largest * system.condition
