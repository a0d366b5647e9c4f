"""Invariants of the trusses among the examples: weight, work, mobility, forward after inverse, limits."""

import numpy as np
import pytest

import kinetruss as kt

NAMES = (
    "facade",
    "mast",
    "planar_crane",
    "slewing_experiments",
    "space_crane",
    "wind_tower",
)


def example(name):
    model = kt.read(kt.library.example_files()[name][0])
    run = next(iter(model.runs.values()))
    if run.targets is not None:
        return model, kt.kinematics.inverse(model, run.targets, samples=241)
    return model, kt.kinematics.follow(model, run.trajectory, samples=241)


def weights(model):
    """Masses of points of every member and node: (mass, {node: share of its place}, (node, towards, distance))."""

    def per_length(part):
        return model.materials[part.material].density * model.sections[part.section].area

    for name, node in model.nodes.items():
        yield node.mass, lambda x, name=name: x[name]
    for bar in model.bars.values():
        a, b = bar.ends
        long = np.linalg.norm(np.subtract(model.nodes[b].at, model.nodes[a].at))
        mass = per_length(bar) * long if bar.mass is None else bar.mass
        yield mass, lambda x, a=a, b=b: (x[a] + x[b]) / 2
    for member in model.active.values():
        (a, b), base, tube = member.ends, member.base, member.tube
        for part, first, second in ((base, a, b), (tube, b, a)):
            mass = per_length(part) * part.length if part.mass is None else part.mass

            def centre(x, p=first, q=second, half=part.length / 2):
                along = x[q] - x[p]
                return x[p] + half * along / np.linalg.norm(along, axis=-1, keepdims=True)

            yield mass, centre


def moments(model, motion):
    """Whole mass, kg, and its first moment along the motion, (n_times, dim) kg m."""
    x = {name: motion.position.sel(node=name).values for name in model.nodes}
    found = [(mass, mass * centre(x)) for mass, centre in weights(model) if mass]
    return sum(mass for mass, _ in found), sum(moment for _, moment in found)


@pytest.fixture(scope="module", params=NAMES)
def followed(request):
    model, motion = example(request.param)
    case = next(iter(model.load_cases), None)
    return request.param, model, motion, kt.dynamics.inverse(model, motion, load_case=case), case


def acting(model, case):
    """Forces of the loads that act, N: node -> vector."""
    factors = dict.fromkeys(model.loads, 1.0) if case is None else model.load_cases[case].loads
    return [(model.loads[name].node, factor * np.array(model.loads[name].force)) for name, factor in factors.items()]


def crossed(at, force):
    """Moment about the origin; vectors of the plane are taken in space."""
    return np.cross(*(np.pad(one, (0, 3 - len(one))) for one in (at, force)))


@pytest.mark.slow
def test_every_freedom_has_its_drive(followed):
    _, model, _, _, _ = followed
    found = kt.kinematics.mobility(model)
    assert (found.undriven, found.self_stress) == (0, 0)


@pytest.mark.slow
def test_supports_bear_the_weight_and_the_loads(followed):
    """At rest in three poses: forces and moments of the supports, from masses that the test counts itself."""
    _, model, motion, _, case = followed
    chosen = [0, 100, 240]
    gravity = np.array(model.gravity)
    mass, moment = moments(model, motion)
    rest = kt.statics.at_poses(model, motion.position.values[chosen], load_case=case)
    for k, sample in enumerate(chosen):
        x = {name: motion.position.sel(node=name).values[sample] for name in model.nodes}
        loads = acting(model, case)
        force = mass * gravity + sum((value for _, value in loads), np.zeros(model.dim))
        turn = crossed(moment[sample], gravity) + sum(crossed(x[node], value) for node, value in loads)
        reaction = rest.reaction.isel(time=k)
        got = [(x[str(one)], reaction.sel(support=one).values) for one in reaction.support.values]
        scale = np.linalg.norm(force)
        np.testing.assert_allclose(sum(value for _, value in got), -force, atol=1e-9 * scale, rtol=0)
        np.testing.assert_allclose(sum(crossed(at, value) for at, value in got), -turn, atol=1e-8 * scale, rtol=0)


@pytest.mark.slow
def test_drives_do_the_work_of_lifting(followed):
    """Virtual work in the large: work of the drives = - work of weight and loads, between rest and rest."""
    name, model, motion, forces, case = followed
    power = (forces.drive_force * motion.drive_velocity).sum("drive").values
    _, moment = moments(model, motion)
    potential = -moment @ np.array(model.gravity)
    for node, force in acting(model, case):
        potential = potential - motion.position.sel(node=node).values @ force
    t = motion.time.values
    work = np.concatenate(([0.0], np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(t))))
    kinetic = work - (potential - potential[0])
    span = np.ptp(potential)
    assert span > 0
    assert abs(kinetic[-1]) < 2e-3 * span, name
    assert kinetic.min() > -2e-3 * span


def test_power_is_the_rate_of_energy_at_every_instant(followed):
    _, _, _, forces, _ = followed
    assert abs(forces.energy_balance).max() < 1e-10 * abs(forces.power).max()


def test_forward_after_inverse(followed):
    """Lengths of the motion, put into the model at its start, bring all nodes to where the motion has them."""
    _, model, motion, _, _ = followed
    lengths = {
        str(name): motion.drive_position.sel(drive=name).values[120].item() for name in motion.drive_position.drive.values
    }
    found = kt.kinematics.assemble(model, lengths=lengths)
    np.testing.assert_allclose(found, motion.position.values[120], atol=1e-9)


@pytest.mark.slow
def test_limits(followed):
    """Every member holds with its factors of safety; motors too, but for those of the thesis."""
    name, model, motion, forces, _ = followed
    verdict = kt.strength.check(model, forces)
    assert 0.03 < verdict.utilisation.max() < 0.7
    assert not verdict.not_checked()
    exceeded = kt.actuators.exceeded(kt.actuators.evaluate(model, motion, forces))
    assert {one.quantity for one in exceeded} == ({"voltage"} if name == "slewing_experiments" else set())


def test_the_crane_lifts_along_a_vertical_line():
    """The lengths of the task, given as a table, bring the load back to the line: forward after inverse along the whole way."""
    model, motion = example("planar_crane")
    lengths = {str(name): tuple(motion.drive_position.sel(drive=name).values) for name in motion.drive_position.drive.values}
    again = kt.kinematics.follow(model, kt.Spline(times=tuple(motion.time.values), values=lengths), samples=481)
    load = again.position.sel(node="B8.N3").values
    assert np.ptp(load[:, 0]) < 1e-7
    assert load[-1, 1] - load[0, 1] == pytest.approx(2.0, abs=1e-5)


def test_records_of_the_experiments_are_labelled():
    model, *others = kt.library.example_files()["slewing_experiments"]
    tables = [path for path in others if path.suffix == ".csv"]
    for path in (model, *tables):
        assert "constructed, not measured" in path.read_text(encoding="utf-8").lower()
    rows = {path.stem: len(path.read_text().splitlines()) - 5 for path in tables}
    assert (rows["slewing_experiment_1"], rows["slewing_experiment_2"]) == (110, 80)
