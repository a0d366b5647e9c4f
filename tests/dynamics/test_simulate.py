"""What `dynamics.simulate` takes, gives and says; the physics is compared elsewhere with closed forms and other methods."""

import math
import re

import numba
import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError, Interrupted, ModelError
from kinetruss.kernels.structure.applied import USER_FORCE
from kinetruss.results import Status

simulate = kt.dynamics.simulate


def pendulum(**changes: object) -> kt.Model:
    fields = {"nodes": {"O": (0, 0), "A": kt.Node(at=(1, 0), mass=2.0)}, "fixed": ["O"], "bars": {"rod": ("O", "A")},
              "gravity": (0, -9.81)}  # fmt: skip
    return kt.Model(**fields | changes)


def oscillator(k: float = 100.0, **bar: object) -> kt.Model:
    """A mass on a spring along x."""
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1.0)}, fixed={"O": "xy", "A": "y"},
        bars={"spring": kt.Bar(ends=("O", "A"), kind="elastic", stiffness=k, **bar)},
    )  # fmt: skip


def thrown(**changes: object) -> kt.Model:
    """A mass in free flight, with a bar that only measures."""
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=2.0)}, fixed=["O"], bars={"eye": kt.Bar(ends=("O", "A"), kind="free")},
        **changes,
    )  # fmt: skip


def test_a_fall_has_the_speed_and_the_tension_of_the_closed_form():
    run = simulate(pendulum(), 0.6, samples=31)
    height = -run.motion.position.sel(node="A", axis="y").values
    speed2 = (run.motion.velocity.sel(node="A") ** 2).sum("axis").values
    np.testing.assert_allclose(speed2, 2 * 9.81 * height, atol=1e-8)
    # m v^2/l + m g sin(angle below the level), both from the height fallen
    np.testing.assert_allclose(run.forces.member_force.sel(member="rod").values, 3 * 2.0 * 9.81 * height, atol=1e-7)
    np.testing.assert_allclose(run.forces.reaction.sel(support="O").values[0], (0, 0), atol=1e-12)
    assert (run.status, run.message, run.motion.status) == (Status.COMPLETED, "", Status.COMPLETED)


def test_records_are_those_of_the_other_analyses():
    run = simulate(pendulum(velocities={"A": (0, 1.0)}), 1.0, samples=11)
    given = kt.kinematics.from_arrays(pendulum(), *(run.motion.data[name].values for name in
                                      ("time", "position", "velocity", "acceleration")))  # fmt: skip
    again = kt.dynamics.inverse(pendulum(), given, static=False)
    assert set(again.data.variables) == set(run.forces.data.variables)
    for name in ("member_force", "end_force", "joint_force", "reaction", "energy"):
        np.testing.assert_allclose(run.forces.data[name], again.data[name], atol=1e-9)
    for data in (run.data, run.motion.data, run.forces.data):
        assert all("units" in one.attrs and "long_name" in one.attrs for one in data.data_vars.values())
    np.testing.assert_allclose(run.energy, run.forces.energy, atol=1e-12)


def test_instants_choose_what_is_told_not_how_it_is_stepped():
    model = kt.library.mechanisms.n_four_bar(loops=2)
    many, few = simulate(model, 1.0, samples=1001), simulate(model, 1.0, samples=2)
    for name in ("position", "velocity", "acceleration"):
        np.testing.assert_array_equal(many.motion.data[name][-1], few.motion.data[name][-1])
    assert many.steps[-1] == few.steps[-1]
    odd = simulate(model, 1.0, times=[0.25, 0.5])
    np.testing.assert_array_equal(odd.motion.position[1], many.motion.position[500])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("call", "words"),
    [
        ({"t_end": -1.0}, "t_end is -1 s, not after the start"),
        ({"t_end": 0.0}, "not after the start"),
        ({}, "Give the end of the simulation"),
        ({"t_end": 1.0, "times": [-0.5, 1.0]}, "go outside the run"),
        ({"t_end": 1.0, "times": [0.0, 2.0]}, "go outside the run"),
        ({"t_end": 1.0, "samples": 1}, "at least 2"),
        ({"t_end": 1.0, "tasks": {"motor": kt.Free()}}, "no drive called 'motor'"),
        ({"t_end": 1.0, "events": {"e": kt.Event(coordinate="B.x", value=0)}}, "no coordinate called 'B.x'"),
        ({"t_end": 1.0, "trajectory": "slew"}, "No trajectory called 'slew'"),
        ({"t_end": 1.0, "load_case": "wind"}, "wind"),
        ({"t_end": 1.0, "velocities": {"B": (0, 1)}}, "no node called 'B'"),
        ({"t_end": 1.0, "velocities": {"A": (0, 1, 0)}}, "Give 2 numbers"),
        ({"t_end": 1.0, "velocities": np.zeros((3, 2))}, r"expected \(n_nodes = 2, dim = 2\)"),
        ({"t_end": 1.0, "velocities": {"A": (0, math.nan)}}, r"start velocity\['A', 1\]: nan"),
        ({"t_end": 1.0, "positions": np.zeros((3, 2))}, r"expected \(n_nodes = 2, dim = 2\)"),
        ({"t_end": 1.0, "user_force": 3}, "not a function"),
        ({"t_end": 1.0, "user_force": lambda t, x, v: {"B": (0, 0)}}, "no node called 'B'"),
        ({"t_end": 1.0, "user_force": lambda t, x, v: np.zeros(3)}, r"shape \(3,\)"),
        ({"t_end": 1.0, "user_force": lambda t, x, v: {"A": (math.nan, 0)}}, "on 'A' is no finite number at the start"),
        ({"t_end": 1.0, "user_force": lambda t, x, v: 1 / 0}, "fails at the start: ZeroDivisionError"),
    ],
)
def test_what_cannot_be_used_is_refused_with_its_name(call, words):
    with pytest.raises(InputError, match=words):
        simulate(pendulum(), **call)


@pytest.mark.parametrize("options", [{"rtol": 0}, {"rtol": -1e-6}, {"atol": 0}, {"max_steps": 0}])
def test_tolerances_are_positive(options):
    with pytest.raises(ModelError):
        kt.DOP853(**options)
    with pytest.raises(ModelError):
        kt.EnergyMomentum(0.0)


def test_velocities_that_contradict_the_bars_are_projected_and_it_is_said():
    run = simulate(pendulum(), 0.1, samples=3, velocities={"A": (3.0, 1.0)})
    np.testing.assert_allclose(run.motion.velocity.sel(node="A")[0], (0.0, 1.0), atol=1e-12)
    assert "most at node A: by 3 m/s, to (" in run.message
    assert run.data.attrs["start_velocity_changed"] == pytest.approx(3.0)
    assert simulate(pendulum(), 0.1, samples=3, velocities={"A": (0.0, 1.0)}).message == ""


def test_positions_that_contradict_the_bars_are_projected_and_it_is_said():
    longer = pendulum(bars={"rod": kt.Bar(ends=("O", "A"), length=1.01)})
    run = simulate(longer, 0.1, samples=3)
    assert run.motion.length[0, 0].item() == pytest.approx(1.01, abs=1e-13)
    assert "moved by the smallest change that fits, most at node A by 0.01 m" in run.message
    far = kt.Model(nodes={"A": (0, 0), "B": (3, 0), "C": kt.Node(at=(1.5, 1), mass=1)}, fixed=["A", "B"],
                   bars={"a": kt.Bar(ends=("A", "C"), length=1.0), "b": kt.Bar(ends=("B", "C"), length=1.0)})  # fmt: skip
    with pytest.raises(InputError, match="cannot be closed"):
        simulate(far, 1.0)


def test_a_massless_node_that_nothing_holds_is_named():
    nodes = {"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1), "P": (2, 0.5)}
    loose = pendulum(nodes=nodes, bars={"rod": ("O", "A"), "p": ("A", "P")})
    with pytest.raises(InputError, match=r"Node 'P' has no mass, and no rigid bar holds it in every direction"):
        simulate(loose, 1.0)
    held = loose.with_(bars={"rod": ("O", "A"), "p": ("A", "P"), "q": ("O", "P")})
    assert simulate(held, 0.1, samples=2).status.ok


def test_events_stop_or_are_recorded_and_those_that_never_come_are_named():
    model = thrown(gravity=(0, -10.0), velocities={"A": (0, 5.0)})
    watched = {
        "up": kt.Event(coordinate="A.y", value=0.8, direction="rising", stop=False),
        "half": kt.Event(coordinate="A.y", value=0.45, direction="falling"),
        "never": kt.Event(length="eye", value=9.0),
    }
    run = simulate(model, 2.0, samples=21, events=watched)
    assert run.status is Status.EVENT
    assert run.status.ok
    # 5 t - 5 t^2 = y
    times = [0.5 - math.sqrt(0.25 - 0.16), 0.5 + math.sqrt(0.25 - 0.09)]
    assert [event.name for event in run.events] == ["up", "half"]
    assert [event.time for event in run.events] == pytest.approx(times, abs=1e-9)
    assert [event.direction for event in run.events] == [1, -1]
    assert run.time[-1].item() == pytest.approx(times[1], abs=1e-9)
    assert run.motion.position.sel(node="A", axis="y")[-1].item() == pytest.approx(0.45, abs=1e-9)
    assert "Stopped by half (coordinate A.y falls through 0.45 m) at t = 0.9" in run.message
    assert "Did not come up to t = 0.9 s: never (length eye crosses 9 m)." in run.message


def test_forces_are_watched_of_rigid_and_of_elastic_bars():
    run = simulate(pendulum(), 2.0, samples=11, events={"strong": kt.Event(force="rod", value=2 * 9.81 * 1.5)})
    # the tension is 3 m g times the height fallen
    assert run.motion.position.sel(node="A", axis="y")[-1].item() == pytest.approx(-0.5, abs=1e-8)
    pulled = oscillator(natural_length=0.9)
    run = simulate(pulled, 2.0, samples=11, events={"zero": kt.Event(force="spring", value=0.0)})
    assert run.time[-1].item() == pytest.approx(math.pi / 20, abs=1e-8)
    damped = oscillator(damping=1.0, natural_length=0.9)
    with pytest.raises(InputError, match=r"events\.zero: the force of 'spring' cannot be watched"):
        simulate(damped, 1.0, events={"zero": kt.Event(force="spring", value=0.0)})


@pytest.mark.slow
def test_a_user_force_may_be_a_function_of_python_or_a_compiled_one():
    def drag(t, x, v):
        return {"A": -0.5 * v[1]}

    def as_array(t, x, v):
        return np.array([[0, 0], -0.5 * v[1]])

    @numba.njit
    def compiled(t, x, v, f):
        f[3] -= 0.5 * v[3]
        f[4] -= 0.5 * v[4]

    as_pointer = numba.cfunc(USER_FORCE)(compiled.py_func)
    model = thrown(velocities={"A": (3.0, 0.0)})
    runs = [simulate(model, 2.0, samples=5, user_force=one) for one in (drag, as_array, compiled, as_pointer)]
    # m v' = -c v
    exact = 3.0 * np.exp(-0.25 * runs[0].time.values)
    for run in runs:
        np.testing.assert_allclose(run.motion.velocity.sel(node="A", axis="x"), exact, atol=1e-8)
        np.testing.assert_array_equal(run.motion.position, runs[0].motion.position)
        np.testing.assert_allclose(run.forces.power, -0.5 * exact**2, atol=1e-7)
        np.testing.assert_allclose(run.forces.energy_balance, 0, atol=1e-9)


@pytest.mark.slow
def test_a_user_force_that_raises_or_gives_no_number_ends_the_run_with_what_is_good():
    def trips(t, x, v):
        if t > 0.5:
            raise ValueError("no more")
        return {"A": (1.0, 0.0)}

    with pytest.raises(AnalysisError, match="raised ValueError: no more; good up to t = 0") as caught:
        simulate(pendulum(), 1.0, samples=101, user_force=trips)
    kept = caught.value.result
    assert kept.status is Status.USER_FORCE
    assert 0.2 < kept.time[-1] <= 0.5
    assert np.isfinite(kept.motion.position).all()

    def vanishes(t, x, v):
        return {"A": (math.nan if t > 0.5 else 0.0, 0.0)}

    kept = simulate(pendulum(), 1.0, samples=101, user_force=vanishes, raise_on_failure=False)
    assert kept.status is Status.NOT_FINITE
    assert "user's force on A" in kept.message
    assert 0.2 < kept.time[-1] <= 0.5


def test_an_interrupt_in_the_middle_carries_what_is_good():
    def stops(t, x, v):
        if t > 0.5:
            raise KeyboardInterrupt
        return {}

    with pytest.raises(KeyboardInterrupt) as caught:
        simulate(pendulum(), 1.0, samples=101, user_force=stops)
    assert isinstance(caught.value, Interrupted)
    assert caught.value.result.status is Status.INTERRUPTED
    assert caught.value.result.time[-1] > 0.2


def test_progress_is_told_and_an_interrupt_there_is_seen():
    told: list[tuple[int, int]] = []
    simulate(pendulum(), 1.0, samples=11, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (11, 11)


def test_too_many_steps_end_the_run_with_a_mend():
    run = simulate(pendulum(), 100.0, method=kt.DOP853(max_steps=50), raise_on_failure=False)
    assert run.status is Status.TOO_MANY_STEPS
    assert "Raise max_steps" in run.message
    assert 0 < run.time[-1] < 100


@pytest.mark.slow
def test_a_stiff_bar_with_explicit_steps_names_the_method_to_use():
    stiff = pendulum(bars={"rod": kt.Bar(ends=("O", "A"), kind="elastic", stiffness=1e13)})
    run = simulate(stiff, 10.0, method=kt.DOP853(), raise_on_failure=False)
    assert run.status is Status.STIFF
    assert "The stiffest bar is rod (1e+13 N/m, vibrating at about 2.24e+06 rad/s)" in run.message
    assert "EnergyMomentum" in run.message
    done = simulate(stiff, 0.5, samples=3, method=kt.EnergyMomentum(1e-3))
    assert done.motion.position.sel(node="A", axis="y")[-1].item() == pytest.approx(
        simulate(pendulum(), 0.5, samples=3).motion.position.sel(node="A", axis="y")[-1].item(), abs=1e-4
    )


@pytest.mark.parametrize("method", [kt.Rattle(0.03), kt.DOP853(step=0.08)], ids=lambda one: one.kind)
def test_energy_that_grows_without_a_cause_stops_the_run(method):
    fast = oscillator(1e4, natural_length=0.9)  # 100 rad/s: these steps are beyond what is stable
    run = simulate(fast, 5.0, method=method, raise_on_failure=False)
    assert run.status is Status.ENERGY_GROWS
    assert "use a smaller step" in run.message
    assert np.isfinite(run.energy).all()
    # what is fed may grow
    pushed = fast.with_(loads={"push": kt.NodalForce(node="A", force=(100.0, 0))})
    assert simulate(pushed, 1.0, samples=11).status.ok


def test_a_method_may_be_given_as_a_file_has_it():
    one = simulate(pendulum(), 0.1, samples=3, method=kt.EnergyMomentum(step=1e-3))
    two = simulate(pendulum(), 0.1, samples=3, method={"kind": "energy_momentum", "step": "1 ms"})
    assert two.data.attrs["method"] == "energy_momentum"
    np.testing.assert_array_equal(one.motion.position, two.motion.position)


@pytest.mark.slow
@pytest.mark.parametrize(
    "method",
    [kt.EnergyMomentum(1e-3), kt.GeneralizedAlpha(1e-3), kt.Radau(), kt.Rattle(1e-3), kt.DOP853(step=1e-2)],
    ids=lambda one: one.kind,
)
def test_every_method_gives_the_same_records(method):
    one, two = simulate(pendulum(), 1.0, samples=11), simulate(pendulum(), 1.0, samples=11, method=method)
    assert set(one.data.variables) == set(two.data.variables)
    np.testing.assert_allclose(two.motion.position, one.motion.position, atol=2e-5)
    np.testing.assert_allclose(two.forces.member_force, one.forces.member_force, atol=2e-3)
    assert two.data.attrs["method"] == method.kind


@pytest.mark.slow
def test_tasks_of_drives():
    model = thrown().with_(bars={"leg": kt.Bar(ends=("O", "A"), kind="driven")}, fixed={"O": "xy", "A": "y"})
    held = simulate(model, 1.0, samples=3)
    np.testing.assert_allclose(held.motion.length, 1.0, atol=1e-13)
    free = simulate(model, 1.0, samples=3, tasks={"leg": kt.Free()}, velocities={"A": (0.5, 0)})
    np.testing.assert_allclose(free.motion.length[:, 0], 1 + 0.5 * free.time, atol=1e-12)
    np.testing.assert_allclose(free.forces.drive_force, 0, atol=1e-12)
    pushed = simulate(model, 1.0, samples=3, tasks={"leg": kt.GivenForce(4.0)})
    np.testing.assert_allclose(pushed.motion.length[:, 0], 1 + pushed.time**2, atol=1e-11)
    np.testing.assert_allclose(pushed.forces.drive_force, 4.0, atol=1e-12)
    np.testing.assert_allclose(pushed.forces.member_force, -4.0, atol=1e-12)
    np.testing.assert_allclose(pushed.forces.energy_balance, 0, atol=1e-10)
    moved = simulate(model, 1.0, samples=5, trajectory=kt.Quintic(moves={"leg": (1.0, 2.0)}, duration=1.0))
    path = kt.kinematics.follow(model, kt.Quintic(moves={"leg": (1.0, 2.0)}, duration=1.0), samples=5)
    np.testing.assert_allclose(moved.motion.position, path.position, atol=1e-12)
    np.testing.assert_allclose(moved.forces.drive_force, kt.dynamics.inverse(model, path).drive_force, atol=1e-10)


def test_a_crank_goes_on_counting_its_turns():
    model = pendulum(drives={"motor": kt.AngleDrive("rod")})
    run = simulate(model, 3.0, samples=61, trajectory=kt.ConstantRate(rates={"motor": 10.0}, duration=3.0))
    np.testing.assert_allclose(run.motion.drive_position[:, 0], 10 * run.time, atol=1e-9)
    torque = simulate(model, 1.0, samples=3, tasks={"motor": kt.GivenForce(torque=2.0)}).forces
    np.testing.assert_allclose(torque.drive_force, 2.0, atol=1e-10)


def test_prepared_runs_give_the_same_numbers_without_records():
    model = kt.library.mechanisms.n_four_bar(loops=2)
    ready = kt.dynamics.prepare(model, 2.0)
    run = simulate(model, 2.0, samples=21)
    for _ in range(2):
        arrays = ready.run(2.0, samples=21)
        np.testing.assert_array_equal(arrays.position[:, :, :2], run.motion.position)
        np.testing.assert_array_equal(arrays.acceleration[:, :, :2], run.motion.acceleration)
        assert (arrays.status, arrays.steps) == (Status.COMPLETED, run.steps[-1])
    with pytest.raises(InputError, match="prepared for 2 s"):
        ready.run(3.0)


@pytest.mark.slow
def test_strength_and_sections_take_the_forces_as_they_are():
    model = kt.read(kt.library.example_files()["double_pendulum"][0])
    run = simulate(model, 1.0, samples=51)
    verdict = kt.strength.check(model, run.forces)
    assert verdict.table()[0].utilisation > 0.005
    assert kt.strength.sections(model, run.forces).section_M.notnull().all()


def test_redundant_bars_share_their_force_and_are_named():
    twice = pendulum(bars={"rod": ("O", "A"), "twin": ("O", "A")})
    one, two = simulate(pendulum(), 0.5, samples=6), simulate(twice, 0.5, samples=6)
    np.testing.assert_allclose(two.motion.position, one.motion.position, atol=1e-9)
    np.testing.assert_allclose(two.forces.member_force, one.forces.member_force.values / 2 * np.ones(2), atol=1e-8)
    assert two.forces.data.attrs["not_unique"] == ["rod", "twin"]
    assert "not unique (redundant structure): rod, twin" in two.message


def test_a_run_that_ends_before_its_first_instant_has_no_samples_but_a_status():
    run = simulate(pendulum(), times=[5.0, 6.0], method=kt.DOP853(max_steps=3), raise_on_failure=False)
    assert run.status is Status.TOO_MANY_STEPS
    assert run.motion.data.sizes["time"] == run.forces.data.sizes["time"] == run.data.sizes["time"] == 0


TWO = kt.library.mechanisms.double_pendulum(angles=(2.0, 1.0), rates=(3.0, -2.0))


@pytest.mark.parametrize(
    ("model", "method", "mend"),
    [
        (TWO, kt.DOP853(rtol=1e-9, atol=1e-3), "tighten rtol and atol"),
        (TWO, kt.DOP853(rtol=1e-9, atol=1e-5), "tighten rtol and atol"),
        (oscillator().with_(velocities={"A": (1.0, 0.0)}), kt.DOP853(step=0.3), "use smaller ones, or EnergyMomentum"),
        (oscillator().with_(velocities={"A": (1.0, 0.0)}), kt.GeneralizedAlpha(step=0.02, rho=0.5), "damps fast vibrations"),
    ],
)
def test_energy_that_is_not_kept_is_told_with_its_share_and_time(model, method, mend):
    run = simulate(model, 4.0, samples=81, method=method)
    off = np.abs(run.energy.values - run.energy.values[0])
    told = re.search(r"The energy is off by (\S+) of the largest kinetic energy at t = (\S+) s", run.message)
    assert told is not None and mend in run.message
    assert float(told[1]) == pytest.approx(off.max() / run.kinetic_energy.values.max(), rel=0.1)
    assert float(told[2]) == pytest.approx(run.time.values[int(off.argmax())])


@pytest.mark.parametrize(
    "method", [None, kt.DOP853(step=0.002), kt.EnergyMomentum(step=0.001), kt.Radau(), kt.Rattle(step=0.0005)]
)
def test_nothing_is_said_of_energy_that_is_kept(method):
    run = simulate(TWO, 1.0, samples=21, method=method)
    assert "energy" not in run.message


FOUR = kt.Model(
    nodes={"A": (0, 0), "B": (0, 1), "C": (2, 1.5), "D": (2, 0)}, fixed=["A", "D"], gravity=(0, -9.81),
    bars={name: kt.Bar(ends=ends, mass=1.0) for name, ends in {"a": ("A", "B"), "b": ("B", "C"), "c": ("C", "D")}.items()},
)  # fmt: skip


@pytest.mark.slow
def test_a_force_that_raises_from_some_time_on_leaves_the_run_up_to_there():
    with pytest.raises(kt.AnalysisError, match="ZeroDivisionError") as caught:
        kt.dynamics.simulate(FOUR, 1.0, user_force=lambda t, x, v: 1 / 0 if t > 0.3 else {})
    found = caught.value.result
    assert found.status is Status.USER_FORCE
    assert found.motion.data.time[-1] == pytest.approx(0.3, abs=0.006)
    plain = kt.dynamics.simulate(FOUR, 0.29, times=[0.29]).motion.position.values[-1]
    np.testing.assert_allclose(found.motion.data.position.sel(time=0.29, method="nearest"), plain, atol=1e-7)


def test_a_force_that_raises_only_in_steps_that_reach_too_far_harms_nothing():
    def wall(t, x, v):
        if x[1, 0] > 0.5:  # B never comes here
            raise ValueError("beyond the table")
        return {"B": (-20.0 / (0.5 - x[1, 0]) + 40.0, 0.0)}

    assert kt.dynamics.simulate(FOUR, 0.4, user_force=wall).status is Status.COMPLETED


def test_velocities_of_supports_are_none():
    moved = kt.dynamics.simulate(FOUR, 0.1, velocities={"A": (0, 5.0)})
    assert "contradicted" in moved.message
    np.testing.assert_allclose(moved.motion.velocity.values[0], 0, atol=1e-15)


@pytest.mark.parametrize("given", ["2 m", None, True, [1.0]])
def test_an_end_or_samples_that_are_no_numbers(given):
    if given is not None:
        with pytest.raises(kt.InputError, match="t_end is .* Give a number|is not a time"):
            kt.dynamics.simulate(FOUR, given)
    with pytest.raises(kt.InputError, match="samples is .* whole number"):
        kt.dynamics.simulate(FOUR, 1.0, samples=2.5 if given is None else given)


def test_a_node_without_mass_between_springs_is_told():
    springs = {n: kt.Bar(ends=e, kind="elastic", stiffness=10.0, mass=0) for n, e in {"s": ("A", "B"), "r": ("B", "C")}.items()}
    model = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": kt.Node(at=(2, 0), mass=1.0)}, fixed=["A"], bars=springs)
    with pytest.raises(kt.InputError, match="Node 'B' has no mass, and no rigid bar holds it"):
        kt.dynamics.simulate(model, 1.0)


@pytest.mark.slow
def test_velocities_of_some_nodes_take_the_others_along():
    model = kt.library.mechanisms.four_bar()
    turning = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 5.0}, duration=0.1), samples=2).velocity
    one = {"B": tuple(turning.sel(node="B").values[0])}
    run = kt.dynamics.simulate(model.with_(velocities=one), 0.05, tasks={"motor": kt.Free()}, samples=2)
    np.testing.assert_allclose(run.motion.velocity.values[0], turning.values[0], atol=1e-12)
    assert run.message == ""
    # a top on its tip: two of its nodes fix how it turns, a third cannot but follow
    ground = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"], gravity=(0, 0, -9.81))
    top = kt.library.bodies.cylinder(ground, "top", 0.02, 0.08, mass=0.5, at=(0, 0, 0.1), nodes=["O"])
    w = np.array([1.0, 0.0, 50.0])
    every = {name: np.cross(w, top.nodes[name].at) for name in top.bodies["top"].nodes if name != "O"}
    some = dict(list(every.items())[:2])
    run = kt.dynamics.simulate(top, 0.01, velocities=some, samples=2)
    for name, vector in every.items():
        np.testing.assert_allclose(run.motion.velocity.sel(node=name).values[0], vector, atol=1e-10)
    # what contradicts itself is still brought to the nearest that does not, and told
    run = kt.dynamics.simulate(FOUR, 0.01, velocities={"B": (0, 5.0)}, samples=2)
    assert "contradicted" in run.message
    np.testing.assert_allclose(run.motion.velocity.values[0], 0, atol=1e-12)
