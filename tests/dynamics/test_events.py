"""Events: as many as the closed form has, at its times, whatever the method, the end of the run and the samples."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.dynamics import simulate

G = 9.81
METHODS = {
    "taylor": None,
    "dop853": kt.DOP853(),
    "energy_momentum": kt.EnergyMomentum(step=0.02),
    "radau": kt.Radau(),
    "rattle": kt.Rattle(step=0.002),
    "alpha": kt.GeneralizedAlpha(step=0.004),
}


def ball(speed):
    return kt.Model(nodes={"P": kt.Node(at=(0, 0), mass=1)}, velocities={"P": (1.0, speed)}, gravity=(0, -G))


def rotor(angle, rate, length=1.0, gravity=0.0):
    """A bob on a rod, and a bar without stiffness from it to a point above the pivot."""
    c, s = math.cos(angle), math.sin(angle)
    return kt.Model(
        nodes={"O": (0, 0), "E": (0, 3 * length), "A": kt.Node(at=(length * c, length * s), mass=2.0)}, fixed=["O", "E"],
        bars={"rod": kt.Bar(ends=("O", "A"), mass=0), "eye": kt.Bar(ends=("E", "A"), kind="elastic", stiffness=1e-12, mass=0)},
        velocities={"A": (-rate * length * s, rate * length * c)}, gravity=(0, -gravity),
    )  # fmt: skip


def times(run, name):
    return np.array([one.time for one in run.events if one.name == name])


def recorded(**fields):
    return kt.Event(**fields, stop=False)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["taylor", "dop853"])
@settings(max_examples=25, deadline=None)
@given(share=st.floats(-3.0, 0.99999), end=st.floats(0.05, 60.0), speed=st.floats(1.0, 40.0))
def test_a_throw_passes_a_level_as_often_as_its_parabola(method, share, end, speed):
    level = share * speed**2 / (2 * G)
    if abs(level) < 1e-6:
        return
    root = math.sqrt(speed**2 - 2 * G * level)
    wanted = [t for t in ((speed - root) / G, (speed + root) / G) if 0 < t < end and abs(t - end) > 1e-7]
    run = simulate(ball(speed), end, samples=3, events={"g": recorded(coordinate="P.y", value=level)}, method=METHODS[method])
    found = times(run, "g")
    found = found[np.abs(found - end) > 1e-7]
    assert len(found) == len(wanted)
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9 * speed / max(root, 1e-3))
    assert [one.direction for one in run.events][: len(found)] == [1 if t < speed / G else -1 for t in found]


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("seed", range(4))
def test_a_rotor_passes_levels_as_often_as_its_circle(method, seed):
    rng = np.random.default_rng(seed)
    angle, rate, length = rng.uniform(0, 6), rng.uniform(1.0, 9.0) * rng.choice([-1, 1]), rng.uniform(0.3, 2.0)
    end = rng.uniform(0.5, 12.0)
    levels = {f"e{k}": level for k, level in enumerate(rng.uniform(-1, 1, 3) * length)}
    wanted = {}
    for name, level in levels.items():
        roots = [
            (sign * math.acos(level / length) + 2 * math.pi * k - angle) / rate for sign in (-1, 1) for k in range(-30, 31)
        ]
        wanted[name] = np.sort([t for t in roots if 0 < t < end])
        end_gap = min((abs(t - end) for t in roots), default=1.0)
        assert end_gap > 1e-9
    events = {name: recorded(coordinate="A.x", value=level) for name, level in levels.items()}
    run = simulate(rotor(angle, rate, length), end, samples=int(rng.choice([2, 7, 301])), events=events, method=METHODS[method])
    near = 1e-8 if method in ("taylor", "dop853") else 0.05
    for name, exact in wanted.items():
        inside = exact[np.abs(exact - end) > near]
        found = times(run, name)
        found = found[np.abs(found - end) > near]
        assert len(found) == len(inside), (name, found, inside)
        np.testing.assert_allclose(found, inside, atol=near)


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("seed", range(3))
def test_coordinate_length_and_force_come_to_the_same_instant_together(method, seed):
    """N = m (v0^2 + 2 g y0 - 3 g y)/l and |EA|^2 = l^2 + 9 l^2 - 6 l y of a pendulum depend on y alone."""
    rng = np.random.default_rng(10 + seed)
    angle, rate, length = rng.uniform(-2.5, -0.6), rng.uniform(-4.0, 4.0), rng.uniform(0.5, 1.5)
    model = rotor(angle, rate, length, G)
    y0, energy = length * math.sin(angle), (rate * length) ** 2 + 2 * G * length * math.sin(angle)
    top = min(energy / (2 * G), length) if energy / (2 * G) < length else length
    level = rng.uniform(0.2, 0.8) * (top + length) - length
    events = {
        "y": recorded(coordinate="A.y", value=level),
        "L": recorded(length="eye", value=math.sqrt(10 * length**2 - 6 * length * level)),
        "N": recorded(force="rod", value=2.0 * (energy - 3 * G * level) / length),
    }
    run = simulate(model, 5.0, samples=11, events=events, method=METHODS[method])
    exact = method in ("taylor", "dop853")
    y, L, N = (times(run, name) for name in "yLN")
    assert len(y) > 1 and abs(y0 - level) > 1e-6
    assert len(y) == len(L) == len(N)
    np.testing.assert_allclose(L, y, atol=1e-9)
    np.testing.assert_allclose(N, y, atol=2e-7 if exact else 0.05)


@pytest.mark.slow
def test_an_apex_on_the_level_is_one_event_and_a_level_above_it_none():
    apex = 12.0**2 / (2 * G)
    for end in (3.0, 7.0, 40.0):
        for offset, count in ((0.0, 1), (1e-9, 0), (-1e-9, 2)):
            run = simulate(ball(12.0), end, samples=2, events={"g": recorded(coordinate="P.y", value=apex + offset)})
            assert len(run.events) == count, (end, offset)
            assert abs(times(run, "g") - 12.0 / G).max(initial=0.0) < 2e-5


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
def test_a_run_restarted_at_an_event_finds_the_next_one_and_not_the_same_again(method):
    event = {"e": kt.Event(coordinate="A.x", value=0.25)}
    model, t, found = rotor(0.3, 5.0), 0.0, []
    x, v = None, None
    for _ in range(5):
        run = simulate(model, 10.0, samples=3, positions=x, velocities=v, events=event, method=METHODS[method])
        assert run.status is kt.results.Status.EVENT
        t += float(run.events[0].time)
        found.append(t)
        x, v = run.motion.position.values[-1], run.motion.velocity.values[-1]
    turns = [(sign * math.acos(0.25) + 2 * math.pi * k - 0.3) / 5.0 for sign in (-1, 1) for k in range(4)]
    wanted = sorted(t for t in turns if t > 0)[:5]
    np.testing.assert_allclose(found, wanted, atol=1e-8 if method in ("taylor", "dop853") else 0.02)


@pytest.mark.slow
def test_arriving_at_a_value_and_resting_there_is_one_event():
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=1.0)}, fixed={"A": "xy", "B": "y"},
        bars={"jack": kt.Bar(ends=("A", "B"), kind="driven", mass=0)},
    )  # fmt: skip
    there = kt.Quintic(moves={"jack": (1.0, 1.5)}, duration=1.0)
    run = simulate(model, 4.0, samples=5, trajectory=there, events={"at": recorded(length="jack", value=1.5)})
    assert len(run.events) == 1 and run.events[0].direction == 1
    assert run.events[0].time == pytest.approx(1.0, abs=1e-3)


@pytest.mark.slow
def test_thousands_of_events_are_all_kept():
    run = simulate(rotor(0.1, 2 * math.pi), 2600.0, samples=2, events={"e": recorded(coordinate="A.y", value=0.0)})
    assert len(run.events) == 5200
    assert run.events[-1].time == pytest.approx(2600.0 - 0.1 / (2 * math.pi), abs=1e-4)


@pytest.mark.slow
def test_events_behind_the_one_that_stops_do_not_happen():
    events = {"stop": kt.Event(coordinate="P.y", value=3.0, direction="falling"), "more": recorded(coordinate="P.y", value=2.0)}
    run = simulate(ball(12.0), 30.0, samples=4, events=events)
    assert [one.name for one in run.events] == ["more", "stop"]
    assert float(run.motion.time[-1]) == run.events[-1].time


@pytest.mark.parametrize("method", METHODS)
def test_an_angle_arrives_once_a_turn(method):
    """A rotor at a constant rate w, from the angle a: at v after (v - a + 2 pi k)/w."""
    rate, start, value = 7.0, 0.4, -2.0
    watched = kt.Event(coordinate=kt.HingeDrive(axis=("O",), start="E", end="A"), value=value - math.pi / 2, stop=False)
    run = simulate(rotor(start, rate), 3.0, samples=5, events={"mark": watched}, method=METHODS[method])
    wanted = [(value - start + 2 * math.pi * k) / rate for k in range(1, 5) if (value - start + 2 * math.pi * k) / rate < 3.0]
    # a midpoint step of the angle w h turns by 2 atan(w h/2), (w h)^2/12 too little; the others are finer
    coarse = method in ("energy_momentum", "rattle", "alpha")
    np.testing.assert_allclose(times(run, "mark"), wanted, rtol=(rate * 0.02) ** 2 / 11 if coarse else 1e-8)
    assert {one.direction for one in run.events} == {1}


@pytest.mark.parametrize("method", ["taylor", "dop853", "radau"])
def test_lengths_offsets_and_hinges_in_space_arrive_where_samples_do(method):
    """Of a tumbling tetrahedron, by the values along many samples."""
    places = {"A": (0, 0, 0), "B": (1, 0, 0.1), "C": (0.4, 0.8, 0.1), "D": (0.5, -0.3, 0.7)}
    dice = np.random.default_rng(4)
    model = kt.Model(
        nodes={name: kt.Node(at=at, mass=1.0) for name, at in places.items()},
        bars={one + two: kt.Bar(ends=(one, two), mass=0.0) for one, two in ("AB", "AC", "BC", "AD", "BD")},
        velocities={name: tuple(dice.normal(size=3)) for name in places},
    )
    hinge = kt.HingeDrive(axis=("A", "B"), start="C", end="D")
    fine = simulate(model, 2.0, samples=2001, method=METHODS[method])
    x = fine.motion.position.values
    b, p, q = x[:, 1] - x[:, 0], x[:, 2] - x[:, 0], x[:, 3] - x[:, 0]
    angle = np.unwrap(np.arctan2(np.einsum("tc,tc->t", np.cross(np.cross(b, p), np.cross(b, q)), b) / np.linalg.norm(b, axis=1),
                                 np.einsum("tc,tc->t", np.cross(b, p), np.cross(b, q))))  # fmt: skip
    value = float(angle.min() + 0.4 * np.ptp(angle))
    sides = np.sign(angle - value)
    wanted = fine.time.values[:-1][sides[:-1] != sides[1:]] + 0.5 * (fine.time.values[1] - fine.time.values[0])
    run = simulate(model, 2.0, samples=3, events={"at": kt.Event(coordinate=hinge, value=value, stop=False)},
                   method=METHODS[method])  # fmt: skip
    np.testing.assert_allclose(times(run, "at"), wanted, atol=5.1e-4)


def test_an_angle_is_given_in_its_unit_and_told_with_it():
    hinge = kt.HingeDrive(axis=("O",), start="E", end="A")
    event = kt.Event(coordinate=hinge, value="-90 deg")
    assert (event.value, event.unit) == (pytest.approx(-math.pi / 2), "rad")
    run = simulate(rotor(1.2, 1.0), 5.0, events={"down": event})
    assert "down (hinge O, E, A" in run.message
    assert "rad" in run.message


def test_a_coordinate_of_unknown_nodes_is_a_fault_with_its_place():
    hinge = kt.HingeDrive(axis=("O",), start="E", end="Z")
    with pytest.raises(kt.KinetrussError, match=r"events\.down\.coordinate.*'Z'"):
        simulate(rotor(1.2, 1.0), 5.0, events={"down": kt.Event(coordinate=hinge, value=0.0)})
