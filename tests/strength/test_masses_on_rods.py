"""Masses clamped on the rods of active members: free bodies of two rods and point masses, written out."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

BASE, TUBE, OWN, SLEEVE, TIP = 0.6, 0.5, 1.1, 0.5, 2.0
MASSES = ((0.1, 0.4), (0.25, 0.7), (0.55, 0.3))
ON_TUBE = ((0.0, 0.5), (0.12, 0.6), (0.38, 0.9))
STATIONS = np.array([0.0, 0.1, 0.16, 0.17, 0.3, 0.41, 0.42, 0.5, 0.6, 0.8, 0.9, 0.92, 1.0])
FEET = {"A": (0.0, 0.0, 0.0), "C": (1.0, 0.1, 0.0), "D": (0.4, 0.9, 0.1)}
TOP = (0.45, 0.35, 0.65)


def tripod(dim: int, masses=MASSES, tip: float = TIP, on_tube=()) -> kt.Model:
    """A mass carried by two or three active members, with masses on the base, and on the tube, of the first."""
    feet = dict(list(FEET.items())[:dim])
    if dim == 2:
        feet, top = {name: at[:2] for name, at in feet.items()}, (0.45, 0.65)
    else:
        top = TOP
    clamped, worn = ([{"at": at, "mass": m} for at, m in reversed(each)] for each in (masses, on_tube))
    legs = {
        name.lower(): kt.Active(
            ends=(name, "B"),
            base=kt.Part(length=BASE, mass=OWN, masses=clamped if name == "A" else ()),
            tube=kt.Part(length=TUBE, mass=SLEEVE, masses=worn if name == "A" else ()),
        )
        for name in feet
    }
    return kt.Model(nodes={**feet, "B": {"at": top, "mass": tip}}, fixed=list(feet), active=legs, gravity=(0, -9.81, 0)[:dim])


def moved(model: kt.Model) -> kt.results.Forces:
    size = {
        name: float(np.linalg.norm(np.subtract(model.nodes["B"].at, model.nodes[one.ends[0]].at)))
        for name, one in model.active.items()
    }
    moves = {name: (length, length + change) for (name, length), change in zip(size.items(), (0.15, -0.05, 0.1), strict=False)}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.4), samples=9)
    return kt.dynamics.inverse(model, motion)


class Leg:
    """One leg at one instant, as particles: Gauss points of its two uniform rods, and the point masses."""

    def __init__(self, foot, top, v, a, g, masses, on_tube=()):
        d = top - foot
        self.L = np.linalg.norm(d)
        self.u = d / self.L
        rate = self.u @ v
        turn = (v - rate * self.u) / self.L
        second = self.u @ a + self.L * turn @ turn
        # d = L u: d'' = L'' u + 2 L' u' + L u''
        bend = (a - second * self.u - 2 * rate * turn) / self.L
        self.g, self.a, self.bend, self.masses, self.on_tube = g, a, bend, masses, on_tube

    def base(self, start: float, end: float, closed: bool):
        """Force and moment about A that the base from `start` to `end`, m, needs: sums of m b and of r x m b."""
        x, w = np.polynomial.legendre.leggauss(4)
        at = 0.5 * (start + end) + 0.5 * (end - start) * x
        parts = list(zip(at, OWN / BASE * 0.5 * (end - start) * w, strict=True))
        parts += [one for one in self.masses if start < one[0] < end or (closed and one[0] == end)]
        return self._sum((s, m, s * self.bend - self.g) for s, m in parts)

    def tube(self, reach: float = TUBE, closed: bool = True):
        """Likewise of the tube up to this distance from B, with a mass right there if `closed`."""
        x, w = np.polynomial.legendre.leggauss(4)
        parts = list(zip(0.5 * reach * (1 + x), SLEEVE / TUBE * 0.5 * reach * w, strict=True))
        parts += [one for one in self.on_tube if one[0] < reach or (closed and one[0] == reach)]
        return self._sum((self.L - s, m, self.a - s * self.bend - self.g) for s, m in parts)

    def _sum(self, parts):
        force, moment = np.zeros(3), np.zeros(3)
        for s, m, b in parts:
            force, moment = force + m * b, moment + np.cross(s * self.u, m * b)
        return force, moment


def full(y):
    return np.pad(y, (0, 3 - len(y)))


def legs_at(model: kt.Model, forces: kt.results.Forces, i: int, on_tube=()):
    """The legs, and the forces on them at B, by equilibrium of legs and tip."""
    arrays = [full(forces.motion.data[name].sel(node="B").values[i]) for name in ("position", "velocity", "acceleration")]
    g = full(np.array(model.gravity))
    legs = [
        Leg(full(np.array(model.nodes[one.ends[0]].at)), *arrays, g, *((MASSES, on_tube) if name == "a" else ((), ())))
        for name, one in model.active.items()
    ]
    across = []
    for leg in legs:
        moment = leg.base(0.0, BASE, True)[1] + leg.tube()[1]
        across.append(np.cross(moment, leg.u) / leg.L)
    along = np.stack([leg.u for leg in legs], axis=1)
    pull = np.linalg.lstsq(along, -TIP * (arrays[2] - g) - sum(across), rcond=None)[0]
    return legs, [side + N * leg.u for side, N, leg in zip(across, pull, legs, strict=True)]


@pytest.mark.slow
@pytest.mark.parametrize(("dim", "on_tube"), [(2, ()), (3, ()), (2, ON_TUBE), (3, ON_TUBE)])
def test_forces_are_those_of_two_rods_and_point_masses(dim, on_tube):
    model = tripod(dim, on_tube=on_tube)
    forces = moved(model)
    found = kt.strength.sections(model, forces, STATIONS)
    parts = found.data["part"].values.tolist()
    for i in (0, 2, 4, 7):
        legs, at_top = legs_at(model, forces, i, on_tube)
        for leg, F, name in zip(legs, at_top, model.active, strict=True):
            needed = [leg.base(0.0, BASE, True), leg.tube()]
            # on the member at its ends
            joint = np.stack([needed[0][0] + needed[1][0] - F, F])[:, :dim]
            np.testing.assert_allclose(forces.joint_force.sel(member=name).values[i], joint, rtol=1e-9, atol=1e-9)
            # tube on base: F_B less what the tube needs
            inner = F - needed[1][0]
            shear = np.linalg.norm(inner - (inner @ leg.u) * leg.u)
            passed = forces.interface_force.sel(active=name).values[i]
            np.testing.assert_allclose([passed[0], np.linalg.norm(passed[1:])], [inner @ leg.u, shear], rtol=1e-9, atol=1e-9)
            np.testing.assert_allclose(forces.drive_force.sel(drive=name).values[i], -passed[0], rtol=1e-9, atol=1e-9)
            _compare_sections(found, parts.index(f"{name}.base"), i, leg, joint[0])
            _compare_tube(found, parts.index(f"{name}.tube"), i, leg, F)
        when = float(forces.data["time"].values[i])
        for name in model.active:
            assert kt.dynamics.free_body(model, forces.motion, forces, member=name, time=when).residual < 1e-9
    assert np.abs(forces.data.energy_balance.values).max() < 1e-9 * np.abs(forces.data.power.values).max()


def _compare_sections(found, part: int, i: int, leg: Leg, foot) -> None:
    """T, |V| and |M| of the base at all stations: from A up to the nut, from its free end beyond."""
    nut = leg.L - TUBE
    assert found.data.part_length.values[i, part] == pytest.approx(BASE, rel=1e-12)
    for n, xi in enumerate(STATIONS):
        s = xi * BASE
        if s <= nut:
            force, moment = leg.base(0.0, s, False)
            S = force - full(foot)
            # moment about A of all that acts on the A-side part: M + s u x S = sum of r x m b
            M = moment - np.cross(s * leg.u, S)
        else:
            whole, spin = leg.base(0.0, BASE, True)
            force, moment = leg.base(0.0, s, False)
            S = force - whole
            M = -(spin - moment) - np.cross(s * leg.u, S)
        T, V, K = (found.data[f"section_{name}"].values[i, part, n] for name in "TVM")
        wanted = [S @ leg.u, np.linalg.norm(S - (S @ leg.u) * leg.u), np.linalg.norm(M)]
        np.testing.assert_allclose([T, np.linalg.norm(V), np.linalg.norm(K)], wanted, rtol=1e-8, atol=1e-8)


def _compare_tube(found, part: int, i: int, leg: Leg, top) -> None:
    """T, |V| and |M| of the tube at all stations, from B."""
    assert found.data.part_length.values[i, part] == pytest.approx(TUBE, rel=1e-12)
    for n, xi in enumerate(STATIONS):
        s = TUBE * (1 - xi)
        force, moment = leg.tube(s)
        S = full(top) - force
        # moment about A of all that acts on the B-side part: (L u) x F_B - M - (L - s) u x S = sum of r x m b
        M = np.cross(leg.L * leg.u, full(top)) - np.cross((leg.L - s) * leg.u, S) - moment
        T, V, K = (found.data[f"section_{name}"].values[i, part, n] for name in "TVM")
        wanted = [S @ leg.u, np.linalg.norm(S - (S @ leg.u) * leg.u), np.linalg.norm(M)]
        np.testing.assert_allclose([T, np.linalg.norm(V), np.linalg.norm(K)], wanted, rtol=1e-8, atol=1e-8)


def test_axial_force_jumps_by_the_weight_of_a_mass():
    """At rest, upright: T falls by m g behind each mass; nothing else changes."""
    clamped = [{"at": at, "mass": m} for at, m in MASSES]
    model = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (0, 1.05), "mass": TIP}},
        fixed={"A": "xy", "B": "x"},
        active={
            "a": kt.Active(
                ends=("A", "B"), base=kt.Part(length=BASE, mass=0.0, masses=clamped), tube=kt.Part(length=TUBE, mass=0.0)
            )
        },
        gravity=(0, -9.81),
    )
    forces = kt.statics.at_poses(model, [{}])
    T = kt.strength.sections(model, forces, [0.05, 0.3, 0.6, 0.92, 0.95]).data.section_T.sel(part="a.base").values[0]
    # at 0.03, 0.18, 0.36 m below three, two and one of them; the nut is at 0.55 m, where the last one sits
    weight = 9.81 * np.array([TIP + 1.4, TIP + 1.0, TIP + 0.3, 0.0, 0.0])
    reaction = 9.81 * (TIP + 1.4)
    assert forces.reaction.sel(support="A", axis="y").values[0] == pytest.approx(reaction, rel=1e-12)
    np.testing.assert_allclose(T, -weight, atol=1e-9)


def test_a_mass_at_the_clamped_end_is_a_mass_at_the_node():
    """Of all forces only the reaction knows of it."""
    plain, loaded = tripod(3, ()), tripod(3, ((0.0, 3.0),))
    one, other = moved(plain), moved(loaded)
    np.testing.assert_allclose(other.drive_force.values, one.drive_force.values, rtol=1e-9)
    more = (other.reaction - one.reaction).sel(support="A").values
    np.testing.assert_allclose(more, np.tile([0, 3 * 9.81, 0], (9, 1)), atol=1e-9)


def test_the_reduced_mass_is_that_of_the_particles():
    """Kinetic energy of unit speeds of the tip, with all drives released."""
    model = tripod(2)
    forces = moved(model)
    lin = kt.dynamics.linearise(model, forces.motion, time=0.0, free=list(model.active))
    legs, _ = legs_at(model, forces, 0)
    mass = TIP * np.eye(2)
    for leg in legs:
        across = np.eye(2) - np.outer(leg.u[:2], leg.u[:2])
        own = OWN * BASE**2 / 3 + sum(m * s * s for s, m in leg.masses)
        mass += own / leg.L**2 * across
        # tube: v_B less s' of the turning
        mass += SLEEVE * (np.outer(leg.u[:2], leg.u[:2]) + (1 - TUBE / leg.L + TUBE**2 / (3 * leg.L**2)) * across)
    np.testing.assert_allclose(lin.mass.values, mass, rtol=1e-10)


def test_strength_finds_the_largest_stress_between_masses():
    """The largest stress of the check is that of dense stations."""
    section, steel = kt.Tube(outer=0.03, inner=0.024), kt.Material(E=2.1e11, density=7850.0, yield_strength=2.5e8)
    model = tripod(2)
    legs = {
        name: one.with_(
            base=one.base.with_(section=section, material=steel), tube=one.tube.with_(section=section, material=steel)
        )
        for name, one in model.active.items()
    }
    model = model.with_(active=legs)
    forces = moved(model)
    stresses = kt.strength.stresses(model, kt.strength.sections(model, forces, np.linspace(0, 1, 2001)))
    dense = stresses["von_mises"].sel(part="a.base").max()
    found = kt.strength.check(model, forces).data["value"].sel(part="a.base", rule="yield")
    assert float(dense) <= float(found) * (1 + 1e-9) and float(found) == pytest.approx(float(dense), rel=1e-4)


@pytest.mark.parametrize(
    ("base", "tube", "said"),
    [
        ({"masses": [{"at": 0.7, "mass": 1.0}]}, {}, "0.7 m is not on the base"),
        ({"masses": [{"at": -0.1, "mass": 1.0}]}, {}, "-0.1 m is not on the base"),
        ({"masses": [{"at": 0.1, "mass": -1.0}]}, {}, "negative"),
        ({}, {"masses": [{"at": 0.6, "mass": 1.0}]}, "0.6 m is not on the tube"),
    ],
)
def test_masses_beside_their_rod_are_refused(base, tube, said):
    with pytest.raises(kt.ModelError, match=said):
        kt.Model(
            nodes={"A": (0, 0), "B": (1, 0)},
            fixed=["A"],
            active={
                "a": kt.Active(
                    ends=("A", "B"), base={"length": BASE, "mass": 1.0} | base, tube={"length": TUBE, "mass": 1.0} | tube
                )
            },
        )


def test_compression_behind_a_mass_counts_for_buckling():
    """Weight upwards relieves the base up to its masses; the largest compression is between the last of them and the nut."""
    clamped = [{"at": at, "mass": m} for at, m in MASSES[:2]]
    part = {"mass": 0.0, "section": kt.Rod(diameter=0.01), "material": kt.Material(E=2e11, density=0.0, yield_strength=2e8)}
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1.05)},
        fixed={"A": "xy", "B": "x"},
        active={
            "a": kt.Active(
                ends=("A", "B"), base=kt.Part(length=BASE, masses=clamped, **part), tube=kt.Part(length=TUBE, **part)
            )
        },
        gravity=(0, 9.81),
        loads={"push": kt.NodalForce(node="B", force=(0, -100.0))},
    )
    forces = kt.statics.at_poses(model, [{}])
    found = kt.strength.check(model, forces).data["value"].sel(part="a", rule="buckling")
    assert float(found) == pytest.approx(100.0, rel=1e-12)
    foot = kt.strength.sections(model, forces, [0.0]).data.section_T.sel(part="a.base")
    assert float(foot[0, 0]) == pytest.approx(-100.0 + 9.81 * 1.1, rel=1e-12)
