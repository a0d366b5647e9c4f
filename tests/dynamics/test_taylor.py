"""Steps by power series: closed forms, order, every kind of force and motion beside DOP853, singular positions, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from hinge_models import Arm
from kinetruss.errors import InputError
from kinetruss.library import mechanisms
from kinetruss.results import Status

simulate = kt.dynamics.simulate
TIGHT = kt.DOP853(rtol=1e-12, atol=1e-13)


def pendulum(**changes: object) -> kt.Model:
    fields = {"nodes": {"O": (0, 0), "A": kt.Node(at=(1, 0), mass=2.0)}, "fixed": ["O"], "bars": {"rod": ("O", "A")},
              "gravity": (0, -9.81)}  # fmt: skip
    return kt.Model(**fields | changes)


def hanging(**bar: object) -> kt.Model:
    """Two masses on an elastic and a rigid bar, in space."""
    return kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(1, 0.2, -0.3), mass=2.0), "B": kt.Node(at=(1.5, 0.4, -1.0), mass=1.0)},
        fixed=["O"], gravity=(0, 0, -9.81), velocities={"B": (0.3, 0.8, 0.2)},
        bars={"spring": kt.Bar(ends=("O", "A"), kind="elastic", mass=0.5, **bar), "rod": kt.Bar(ends=("A", "B"), mass=0.7)},
    )  # fmt: skip


def crane() -> kt.Model:
    """A load that swings from an arm, which an angle drive turns, on two driven legs."""
    return kt.Model(
        nodes={"O": (0, 0), "P": (2, 0), "A": kt.Node(at=(1, 1), mass=2.0), "B": kt.Node(at=(1.5, 2.0), mass=1.0),
               "C": kt.Node(at=(2.0, 1.5), mass=3.0)},
        fixed=["O", "P"], gravity=(0, -9.81), drives={"turn": kt.AngleDrive("arm")},
        bars={
            "left": kt.Bar(ends=("O", "A"), kind="driven", mass=1.0), "right": kt.Bar(ends=("P", "A"), kind="driven", mass=1.0),
            "arm": kt.Bar(ends=("A", "B"), mass=1.0), "rope": kt.Bar(ends=("B", "C"), mass=0.2),
        },
    )  # fmt: skip


def off(model: kt.Model, t_end: float, **options: object) -> tuple[float, float, object]:
    """Largest difference of positions and of member forces (in parts of the largest) from tight DOP853; the run."""
    one = simulate(model, t_end, samples=41, method=kt.Taylor(rtol=1e-12, atol=1e-13), **options)
    two = simulate(model, t_end, samples=41, method=TIGHT, **options)
    pulls = two.forces.member_force
    return (
        float(np.abs(one.motion.position - two.motion.position).max()),
        float(np.abs(one.forces.member_force - pulls).max() / np.abs(pulls).max()),
        one,
    )


def test_a_throw_is_a_polynomial_and_takes_one_step():
    model = kt.Model(nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=2.0)}, fixed=["O"], gravity=(0, -9.81),
                     bars={"eye": kt.Bar(ends=("O", "A"), kind="free")}, velocities={"A": (3.0, 4.0)})  # fmt: skip
    run = simulate(model, 2.0, samples=21, method=kt.Taylor())
    t = run.time.values
    np.testing.assert_allclose(
        run.motion.position.sel(node="A"), np.stack([1 + 3 * t, 4 * t - 0.5 * 9.81 * t**2], 1), atol=1e-13
    )
    assert int(run.steps[-1]) == 1


@pytest.mark.slow
@pytest.mark.parametrize(("order", "fewest"), [(4, 32), (6, 16), (8, 12), (10, 8)])
def test_the_error_falls_with_the_order_of_the_series(order, fewest):
    model, steps = mechanisms.pendulum(angle=2.0), fewest * np.array([1.0, 1.5, 2.0])
    exact = simulate(model, 1.0, samples=2, method=TIGHT).motion.position[-1]
    errors = [
        float(
            np.abs(simulate(model, 1.0, samples=2, method=kt.Taylor(order=order, step=1 / n)).motion.position[-1] - exact).max()
        )
        for n in steps
    ]
    assert errors[-1] > 1e-11
    assert -np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(order, abs=0.4)


@pytest.mark.slow
@pytest.mark.parametrize(
    "bar",
    [{"stiffness": 400.0}, {"stiffness": 400.0, "damping": 6.0}, {"stiffness": 400.0, "strain": "green"},
     {"stiffness": 400.0, "strain": "green", "damping": 3.0}, {"stiffness": 400.0, "natural_length": 0.8}],
)  # fmt: skip
def test_elastic_and_damped_bars(bar):
    place, force, run = off(hanging(**bar), 3.0)
    assert place < 1e-10 and force < 1e-9
    if "damping" not in bar:
        energy = run.kinetic_energy + run.potential_energy
        assert float(np.abs(energy - energy[0]).max()) < 1e-11 * float(run.kinetic_energy.max())


@pytest.mark.slow
@pytest.mark.parametrize(
    "trajectory",
    [
        kt.Quintic(moves={"left": (1.4, 1.9), "right": (1.4, 1.2), "turn": (1.1, 2.4)}, duration=1.0),
        kt.Cyclic(moves={"left": (1.4142135623730951, 1.7), "turn": (1.1071487177940904, 2.0)}, period=0.7, cycles=2),
    ],
)
def test_driven_lengths_and_angles(trajectory):
    place, force, _ = off(crane(), 1.0, trajectory=trajectory)
    assert place < 1e-10 and force < 1e-9


def test_an_angle_drive_that_rests_holds_its_line():
    place, force, run = off(crane(), 1.0, tasks={"left": kt.Free(), "right": kt.Hold()})
    arm = run.motion.position.sel(node="B") - run.motion.position.sel(node="A")
    np.testing.assert_allclose(arm - arm[0], 0, atol=1e-12)
    assert place < 1e-10 and force < 1e-9


def test_supports_that_move():
    t = np.linspace(0.0, 1.0, 11)
    shake = kt.History(times=t, displacements=np.stack([0.1 * np.sin(6 * t), 0.05 * t**2], 1))
    place, force, _ = off(pendulum(support_motion={"O": shake}), 1.0)
    assert place < 1e-10 and force < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changes", "tasks"),
    [
        ({"loads": {"push": kt.NodalForce(node="A", times=(0, 0.4, 0.7), forces=((0, 3), (5, -2), (5, 9)))}}, {}),
        ({"drives": {"motor": kt.AngleDrive("rod")}}, {"motor": kt.GivenForce(times=(0, 0.5, 0.8), torques=(0.0, 8.0, -3.0))}),
        ({"bars": {"rod": kt.Bar(ends=("O", "A"), kind="driven", mass=1.0)}},
         {"rod": kt.GivenForce(times=(0, 1), forces=(3.0, 9.0))}),
    ],
    ids=["force", "torque", "thrust"],
)  # fmt: skip
def test_forces_in_time(changes, tasks):
    place, force, _ = off(pendulum(velocities={"A": (0, 1.0)}, **changes), 1.2, tasks=tasks)
    assert place < 1e-10 and force < 1e-9


@pytest.mark.slow
def test_the_mechanism_of_andrews():
    place, force, _ = off(mechanisms.andrews(), 0.03, tasks={"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)})
    assert place < 1e-10 and force < 1e-7


@pytest.mark.slow
@pytest.mark.parametrize("loops", [1, 2, 10])
@pytest.mark.parametrize("rtol", [1e-6, 1e-10, 1e-12])
def test_a_series_goes_through_singular_positions(loops, rtol):
    model = mechanisms.n_four_bar(loops=loops)
    run = simulate(model, 5.0, samples=201, method=kt.Taylor(rtol=rtol, atol=rtol / 10))
    right = simulate(model, 5.0, samples=201, method=TIGHT)
    assert run.status is Status.COMPLETED
    energy = run.kinetic_energy + run.potential_energy
    assert float(np.abs(energy - energy[0]).max() / run.kinetic_energy.max()) < 100 * rtol + 1e-8
    assert float(np.abs(run.motion.position - right.motion.position).max()) < 1000 * rtol + 1e-7
    when = [one.time for one in right.passages]
    assert len(when) > 2
    np.testing.assert_allclose([one.time for one in run.passages], when, atol=1e-4 + 1000 * rtol)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(
    st.lists(st.tuples(st.floats(0.3, 1.5), st.floats(0.2, 3.0), st.floats(-3, 3), st.floats(0.5, 3)), min_size=2, max_size=5),
)
def test_chains_of_rods_keep_energy(links):
    nodes, bars, speeds, at = {"P0": (0.0, 0.0)}, {}, {}, np.zeros(2)
    for k, (length, mass, angle, speed) in enumerate(links, start=1):
        at = at + length * np.array([math.sin(angle), -math.cos(angle)])
        nodes[f"P{k}"], bars[f"L{k}"], speeds[f"P{k}"] = tuple(at), kt.Bar(ends=(f"P{k - 1}", f"P{k}"), mass=mass), (speed, 0.0)
    model = kt.Model(nodes=nodes, fixed=["P0"], bars=bars, gravity=(0, -9.81), velocities=speeds)
    run = simulate(model, 2.0, samples=41, method=kt.Taylor())
    energy = run.kinetic_energy + run.potential_energy
    assert float(np.abs(energy - energy[0]).max()) < 1e-8 * float(run.kinetic_energy.max())


def test_redundant_bars_share_their_force():
    twice = pendulum(bars={"rod": ("O", "A"), "twin": ("O", "A")})
    run = simulate(twice, 1.0, samples=11, method=kt.Taylor())
    alone = simulate(pendulum(), 1.0, samples=11, method=kt.Taylor())
    np.testing.assert_allclose(run.motion.position, alone.motion.position, atol=1e-10)
    np.testing.assert_allclose(2 * run.forces.member_force[:, 0], alone.forces.member_force[:, 0], atol=1e-8)


ARM = Arm().model()
SUMS = {
    "a hinge that moves as wanted, one under a torque in time": (
        ARM,
        kt.Quintic(moves={"base": (0.0, 1.2)}, duration=1.0),
        {"elbow": kt.GivenForce(times=(0.0, 0.4, 1.0), torques=(3.0, -2.0, 4.0))},
    ),
    "two free hinges with damped springs": (
        ARM.with_(springs={
            f"{name}-spring": kt.Spring(coordinate=ARM.drives[name], stiffness=9.0, rest=0.3, damping=0.2, preload=-1.0)
            for name in ARM.drives
        }),
        None,
        {name: kt.Free() for name in ARM.drives},
    ),
    "a chain with springs about its pins and a coupling of angles": (
        kt.Model(
            nodes={f"N{k}": kt.Node(at=(0.3 * k, 0.02 * k * k), mass=0.2) for k in range(5)},
            fixed=["N0"],
            bars={f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(4)},
            springs={
                f"s{k}": kt.Spring(
                    coordinate=kt.HingeDrive(axis=f"N{k}", start=f"N{k - 1}", end=f"N{k + 1}"), stiffness=8.0, damping=0.02
                )
                for k in range(1, 4)
            },
            couplings={"gear": kt.Coupling(terms=((kt.AngleDrive("b0"), 2.0), (kt.AngleDrive("b1"), -1.0)))},
            gravity=(0, -9.81),
        ),
        None,
        {},
    ),
}  # fmt: skip


@pytest.mark.parametrize("which", SUMS)
def test_sums_of_terms_beside_dop853(which):
    model, trajectory, tasks = SUMS[which]
    method = kt.Taylor(rtol=1e-12, atol=1e-13)
    one, two = (simulate(model, 1.0, samples=21, trajectory=trajectory, tasks=tasks, method=k) for k in (method, TIGHT))
    np.testing.assert_allclose(one.motion.position, two.motion.position, atol=2e-10)
    pulls = two.forces.member_force
    np.testing.assert_allclose(one.forces.member_force, pulls, atol=2e-8 * float(np.abs(pulls).max()))


@pytest.mark.slow
@pytest.mark.parametrize(("order", "fewest"), [(4, 48), (6, 20), (8, 16)])
def test_the_error_of_sums_falls_with_the_order_of_the_series(order, fewest):
    model, trajectory, tasks = SUMS["two free hinges with damped springs"]
    steps = fewest * np.array([1.0, 1.5, 2.0])

    def end(method):
        return simulate(model, 0.3, samples=2, trajectory=trajectory, tasks=tasks, method=method).motion.position[-1]

    exact = end(kt.DOP853(rtol=1e-14, atol=1e-15))
    errors = [float(np.abs(end(kt.Taylor(order=order, step=0.3 / n)) - exact).max()) for n in steps]
    assert errors[-1] > 1e-12
    assert -np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(order, abs=0.25)


def test_a_singular_start_is_left_with_other_steps():
    model = mechanisms.n_four_bar(loops=1, angle=math.pi / 2, rate=2.0)
    run, right = (simulate(model, 1.0, samples=11, method=method) for method in (kt.Taylor(), kt.DOP853()))
    assert run.status is Status.COMPLETED
    np.testing.assert_allclose(run.motion.position, right.motion.position, atol=1e-6)


def test_numbers_that_overflow_end_the_run_before_they_are_shown():
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1e-30)}, fixed={"O": "xy", "A": "y"}, velocities={"A": (1.0, 0)},
        bars={"spring": kt.Bar(ends=("O", "A"), kind="elastic", stiffness=1e30, strain="green")},
    )  # fmt: skip
    run = simulate(model, 1.0, method=kt.Taylor(), raise_on_failure=False)
    assert run.status is Status.NOT_FINITE
    assert np.isfinite(run.motion.position).all()


@pytest.mark.parametrize(
    ("model", "options", "words"),
    [
        (
            hanging(stiffness=100.0).with_(bars={"spring": kt.Bar(ends=("O", "A"), kind="cable", stiffness=100.0)}),
            {},
            "'spring'",
        ),
        (
            SUMS["two free hinges with damped springs"][0].with_(
                springs={"rub": kt.Spring(coordinate=ARM.drives["base"], stiffness=9.0, friction=0.3)}
            ),
            {},
            "'rub' has friction",
        ),
        (pendulum(), {"user_force": lambda t, x, v: {"A": (0, 1.0)}}, "user force"),
    ],
)
def test_what_has_no_series_is_refused_with_the_mend(model, options, words):
    with pytest.raises(InputError, match=rf"no power series of this motion: .*{words}.* Use DOP853\(\)"):
        simulate(model, 1.0, method=kt.Taylor(), **options)
