"""What the public interface answers for a model, and how much it changes when the model changes by next to nothing.

The scale of a part is the largest value in it plus its change a unit of relative change of the model: its condition.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import models
import numpy as np
from answers import Answer, Part, Refused
from covers import covers
from models import Case, is_brace, whole

import kinetruss as kt

SHIFT = 1e-10
"""Relative change of the model by which conditions are found."""
T_END = 0.02
METHODS: tuple[Callable[[str], Any], ...] = (
    lambda _: None, lambda solver: kt.Taylor(solver=solver), lambda solver: kt.DOP853(solver=solver, max_steps=3000),
    lambda solver: kt.EnergyMomentum(step=1e-3, solver=solver), lambda solver: kt.GeneralizedAlpha(step=1e-3, solver=solver),
    lambda solver: kt.Rattle(step=1e-3, solver=solver),
)  # fmt: skip
SOLVERS = ("auto", "dense", "sparse", "sweep")
ALLOWED = {
    "follow": 1e-12,
    "inverse": 1e-12,
    "linear": 1e-13,
    "equilibrium": 1e-10,
    "buckling": 1e-10,
    "linearise": 1e-12,
    "simulate": 1e-9,
    "strength": 1e-12,
    "beams": 1e-12,
    "flexible": 1e-9,
    "drive": 1e-9,
}
"""Allowed differences, of the scale: iterations end a little above round-off, and runs within their tolerances."""
NOTHING = 1e-3
"""In SI: what is smaller is measured as if it were as large."""
FIRST = 1_000_000
"""Runs are of other cases than those that are assembled."""


def run(seed: int, number: int, conditions: bool) -> Answer:
    """Everything that is solved for one case; `conditions` also finds how sure it is."""
    case = models.case(seed, FIRST + number, models.DRIVEN)
    answer = Answer(number, case.name, case.fingerprint, covers(case))
    for name, question in QUESTIONS.items():
        here = _parts(case.model, case, question)
        there = _parts(_shifted(case.model), case, question) if conditions else here
        errors = here.pop(" errors", None)  # what rounding may do, as the answer itself says
        loose = float(errors.value.max()) if isinstance(errors, Part) else 0.0
        for key, part in here.items():
            scaled = part if isinstance(part, Refused) else _scaled(part, there.get(key), ALLOWED.get(name), loose)
            answer.parts[f"{name}{key}"] = scaled
    return answer


Found = Iterator[tuple[str, Any, tuple[tuple[str, ...], ...]]]


def _parts(model: kt.Model, case: Case, question: Callable[[kt.Model, Case], Found]) -> dict[str, Part | Refused]:
    found: dict[str, Part | Refused] = {}
    try:
        for key, value, places in question(model, case):
            found[f" {key}"] = Part(np.asarray(value, float), places)
    except Exception as error:  # noqa: BLE001 - compared by its kind
        found[""] = Refused(type(error).__name__)
    return found


def _scaled(part: Part, shifted: Any, allowed: float | None, loose: float = 0.0) -> Part:
    """The part with its scale; counts are compared exactly."""
    if allowed is None:
        return Part(part.value, part.places, 1.0, 0.0)
    known = np.isfinite(part.value)
    scale = float(np.abs(part.value[known]).max(initial=0.0)) + NOTHING
    if isinstance(shifted, Part) and shifted.value.shape == part.value.shape:
        known &= np.isfinite(shifted.value)
        scale += float(np.abs(shifted.value[known] - part.value[known]).max(initial=0.0)) / SHIFT
    return Part(part.value, part.places, scale, allowed + loose)


def _shifted(model: kt.Model) -> kt.Model:
    """The model with its nodes, and what pulls on them, changed by a little."""
    dice = np.random.default_rng(5)
    nodes = {
        name: node.with_(at=tuple(float(y * (1 + SHIFT * dice.normal())) for y in node.at), mass=node.mass * (1 + SHIFT))
        for name, node in model.nodes.items()
    }
    gravity = None if model.gravity is None else tuple(g * (1 + SHIFT * dice.normal()) for g in model.gravity)
    try:
        return model.with_(nodes=nodes, gravity=gravity)
    except kt.KinetrussError:
        return model  # what is given beside the nodes fits to them alone


def _data(data: Any, *names: str, last: bool = False) -> Found:
    """Variables of a dataset by their coordinates; `last`: of the last sample."""
    for name in names:
        if name not in data:
            continue
        one = data[name].isel(time=-1) if last else data[name]
        places = tuple(
            tuple(map(str, one.coords[dim].values)) if dim in one.coords else tuple(map(str, range(one.sizes[dim])))
            for dim in one.dims
        )
        yield name, one.values, places


def mobility(model: kt.Model, case: Case) -> Found:
    """Counts."""
    found = kt.kinematics.mobility(model)
    names = ("rank", "degrees_of_freedom", "undriven", "self_stress", "bars", "couplings")
    yield "counts", [getattr(found, name) for name in names], (names,)


def follow(model: kt.Model, case: Case) -> Found:
    """A motion of all drives."""
    motion = kt.kinematics.follow(model, case.trajectory, samples=5)
    yield from _data(motion.whole, "position", "velocity", "acceleration", "length")


def inverse(model: kt.Model, case: Case) -> Found:
    """The forces of that motion, moving and at rest."""
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, case.trajectory, samples=5), case.load_case)
    names = "member_force", "end_force", "drive_force", "reaction", "held_force", "energy", "energy_rate"
    yield from _data(forces.whole, *names)
    for name, value, places in _data(forces.static.whole, "member_force", "reaction", "held_force") if forces.static else ():
        yield f"static {name}", value, places


def _stands(model: kt.Model) -> None:
    """Refuse what has no unique answer: the factors of singular matrices are at the mercy of round-off, and may be worse."""
    bars = {name: kt.Bar(ends=bar.ends) for name, bar in model.bars.items() if bar.kind != "free" and not is_brace(bar)}
    if not (model.membranes or model.solids) and kt.kinematics.mobility(model.with_(bars=model.bars | bars)).undriven:
        raise kt.InputError("a mechanism")
    rigid = [one for one in whole(model).bars.values() if one.kind in ("rigid", "driven")]
    parts = [*rigid, *(part for one in model.active.values() for part in (one.base, one.tube))]
    hard = any(model.section_of(part) is None or model.material_of(part) is None for part in parts)
    if hard and kt.kinematics.mobility(model).self_stress:
        raise kt.InputError("inextensible bars share a force")


def linear(model: kt.Model, case: Case) -> Found:
    """Small displacements."""
    _stands(model)
    found = kt.statics.linear(model, load_case=case.load_case)
    yield "errors", [found.data.attrs["force_error"], found.data.attrs["displacement_error"]], (("force", "displacement"),)
    yield from _data(found.whole, "member_force", "displacement", "reaction", "held_force")


def equilibrium(model: kt.Model, case: Case) -> Found:
    """Rest."""
    if case.name != "library":
        _stands(model)
    found = kt.statics.equilibrium(model, load_case=case.load_case, max_steps=200)
    yield from _data(found.whole, "position", "member_force", "reaction", "held_force", "drive_force")


def buckling(model: kt.Model, case: Case) -> Found:
    """The least factors of all loads at which a structure at rest buckles."""
    _stands(model)
    found = kt.statics.buckling(model, dict.fromkeys(model.loads, 1.0), modes=2)
    yield from _data(found.whole, "load_factor", "member_force_of_load")


def linearise(model: kt.Model, case: Case) -> Found:
    """Squares of the frequencies about the model's own configuration; degrees of freedom may be chosen otherwise."""
    found = kt.dynamics.linearise(model, case.x if case.name == "skin" else None, load_case=case.load_case)
    squares = np.linalg.eigvals(np.linalg.solve(found.data["mass"].values, found.data["stiffness"].values))
    both = np.stack([np.sort(squares.real), np.sort(np.abs(squares.imag))])
    yield "squares", both, (("real", "imaginary"), tuple(map(str, range(len(squares)))))


def simulate(model: kt.Model, case: Case) -> Found:
    """The end of a short run by a method and a solver that the number of the case says."""
    fed = {name: kt.StepInput(voltage=3.0) for name, one in model.actuators.items() if one.motor is not None}
    # a motor keeps to the methods that choose their steps
    method = METHODS[case.number % 6](SOLVERS[case.number // 6 % 4]) if not fed else None
    tasks = case.tasks | dict(list(fed.items())[:2])
    run = kt.dynamics.simulate(model, T_END, samples=3, method=method, tasks=tasks, trajectory=case.trajectory,
                               load_case=case.load_case)  # fmt: skip
    yield from _data(run.motion.whole, "position", "velocity", "acceleration", last=True)
    yield from _data(run.forces.whole, "member_force", "drive_force", "reaction", "held_force", last=True)
    yield from _data(run.data, "energy", last=True)


def strength(model: kt.Model, case: Case) -> Found:
    """Utilisations of members and drives along a motion, by every rule."""
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, case.trajectory, samples=5), case.load_case)
    found, bars = kt.strength.check(model, forces, stations=5).data, whole(model).bars
    real = [not is_brace(bars.get(str(member))) for member in found["member"].values]  # older revisions list braces too
    yield from _data(found.isel(part=real), "value", "limit", "utilisation")


def beams(model: kt.Model, case: Case) -> Found:
    """Section forces of beams under a small load."""
    found = kt.strength.beams(model, kt.statics.linear(model, load_case=case.load_case), stations=5)
    yield from _data(found, "section_T", "section_V", "section_M", "end_force", "end_moment")


def flexible(model: kt.Model, case: Case) -> Found:
    """The end of a short run of elastic members on a prescribed motion."""
    run = kt.flexible.simulate(model, case.trajectory, T_END, samples=3, load_case=case.load_case)
    yield from _data(run.motion.whole, "position", "velocity", last=True)
    yield from _data(run.forces.whole, "member_force", "drive_force", last=True)


def drive(model: kt.Model, case: Case) -> Found:
    """The end of a short run of each drive train by itself."""
    for name, one in model.actuators.items():
        if one.motor is None:
            continue
        train = kt.actuators.train_of(model, name)
        load = (0.3 if case.number % 2 else -0.2) * (50.0 if train.screw is not None else 0.05)
        found = kt.actuators.simulate_drive(train, kt.StepInput(voltage=4.0), load=load, duration=0.05, samples=6)
        for key, value, places in _data(found.data, "current", "motor_speed", "thrust", "drive_torque", "length", "angle"):
            yield f"{name} {key}", value, places


QUESTIONS: dict[str, Callable[[kt.Model, Case], Found]] = {
    "mobility": mobility, "follow": follow, "inverse": inverse, "linear": linear, "equilibrium": equilibrium,
    "buckling": buckling, "linearise": linearise, "simulate": simulate, "strength": strength,
    "beams": beams, "flexible": flexible, "drive": drive,
}  # fmt: skip
