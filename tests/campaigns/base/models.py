"""Random models and states by number: every kind of element, load, drive and law, through the public interface alone.

Case k of a seed is always the same question, in every process and for every revision; `fingerprint` says so.
"""

from __future__ import annotations

import hashlib
import json
import sys
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))  # a script finds what stands beside it, and the models of the tests
sys.path.insert(0, str(Path(__file__).parents[2]))

from continua import block, planar_bodies, skin, spatial_bodies
from frames import FRAMES, frame, rubbing, sprung, turned
from webs import Dice, braced, carried, large_web, planar_web, spatial_web

import kinetruss as kt
from action_models import WAYS
from kinetruss.library import joints, mechanisms, vgt
from random_trusses import truss


def _told(value: Any) -> Any:
    """A task or trajectory by its kind and the fields that are not at their default, in the order of their names."""
    if isinstance(value, dict):
        return {name: _told(one) for name, one in value.items()}
    if not hasattr(value, "model_dump"):
        return value
    return type(value).__name__, sorted(value.model_dump(exclude_defaults=True).items())


@dataclass(frozen=True, kw_only=True, eq=False)
class Case:
    """A question: a model at positions x, velocities v, accelerations a (n, dim) in the order of its nodes, at time t, s.

    tasks : of drives; those without one follow the trajectory, or are held. name : of the kind of model.
    """

    number: int
    name: str
    model: kt.Model
    x: np.ndarray
    v: np.ndarray
    a: np.ndarray
    t: float
    tasks: dict[str, Any] = field(default_factory=dict)
    trajectory: Any = None
    load_case: str | None = None

    @property
    def fingerprint(self) -> str:
        """The same where the question is the same."""
        tables = whole(self.model).model_dump(mode="json", exclude_defaults=True)
        for table, mark in (("nodes", "director"), ("bars", "brace"), ("couplings", "beam")):  # in older revisions
            for record in tables.get(table, {}).values():
                record.pop(mark, None)
        parts = [json.dumps(tables, sort_keys=True, default=str).encode(), *(y.tobytes() for y in (self.x, self.v, self.a))]
        return hashlib.sha256(
            b" ".join([*parts, repr((self.t, _told(self.tasks), _told(self.trajectory))).encode()])
        ).hexdigest()[:16]


def ways(dice: Dice) -> kt.Model:
    """One of the models of the tests that load or drive bars."""
    made: kt.Model = WAYS[int(dice.integers(len(WAYS)))](dice)
    return made


def _pairs(dice: Dice) -> kt.Model:
    """Two bodies and a joint between them, or to the ground."""
    dim = int(dice.integers(2, 4))
    nodes: dict[str, Any] = {}
    for name, corner, size in (("A", np.zeros(dim), 1.0), ("B", np.array([1.2, 0.3, 0.1])[:dim], dice.uniform(0.6, 1.0))):
        nodes |= {f"{name}0": tuple(corner)} | {f"{name}{k + 1}": tuple(corner + size * np.eye(dim)[k]) for k in range(dim)}
    held = {name: kt.Body(nodes=[node for node in nodes if node[0] == name], mass=dice.uniform(1, 2)) for name in "AB"}
    model = kt.Model(nodes=nodes, bodies=held, gravity=tuple(4 * dice.normal(size=dim)))
    pair = [("A", "B"), ("ground", "B")][int(dice.integers(2))]
    place, axis = (1.1, 0.2, 0.1)[:dim], (0.0, 0.6, 0.8)[-dim:]
    flat: list[tuple[str, dict[str, Any]]] = [("pin", {}), ("weld", {}), ("prismatic", {"axis": axis}),
                                              ("parallelogram", {"axis": axis})]  # fmt: skip
    deep: list[tuple[str, dict[str, Any]]] = [
        ("spherical", {}), ("weld", {}), ("universal", {"axes": (axis, (1.0, 0.0, 0.0))}),
        *((kind, {"axis": axis}) for kind in ("revolute", "prismatic", "cylindrical", "planar")),
        ("screw", {"axis": axis, "pitch": 0.1}),
    ]  # fmt: skip
    options = flat if dim == 2 else deep
    kind, given = options[int(dice.integers(len(options)))]
    made: kt.Model = getattr(joints, kind)(model, "j", bodies=pair, at=place, **given)
    return made


def _chain(dice: Dice) -> kt.Model:
    """A chain of triangles or tetrahedra, with nodes without mass, redundant bars, a driven bar or a spring."""
    options = {name: bool(dice.random() < 0.5) for name in ("massless", "driven", "braced", "sized")}
    return truss(int(dice.integers(1 << 30)), int(dice.integers(2, 4)), **options)[0]


TRAIN: dict[str, Any] = {"screw": "screw_lacy_spatial", "gear": "gear_lacy", "motor": "motor_lacy"}


def _train(dice: Dice) -> dict[str, Any]:
    """Screws, gears and motors, or none."""
    return TRAIN if dice.random() < 0.5 else {}


LIBRARY: dict[str, Callable[[Dice], kt.Model]] = {
    "four_bar": lambda d: mechanisms.four_bar(crank=d.uniform(0.05, 0.12), angle=d.uniform(0.5, 2.5)),
    "slider_crank": lambda d: mechanisms.slider_crank(offset=d.uniform(-0.05, 0.05), angle=d.uniform(0.3, 2.8)),
    "spatial_slider_crank": lambda d: mechanisms.spatial_slider_crank(angle=d.uniform(0, 6)),
    "six_bar": lambda d: mechanisms.watt_six_bar() if d.random() < 0.5 else mechanisms.stephenson_six_bar(),
    "peaucellier": lambda d: mechanisms.peaucellier(angle=d.uniform(0.3, 0.8)),
    "hart": lambda d: mechanisms.hart(angle=d.uniform(0.3, 0.8)),
    "n_pendulum": lambda d: mechanisms.n_pendulum(int(d.integers(2, 9)), bob=d.uniform(0, 2), angle=d.uniform(0.2, 2)),
    "n_four_bar": lambda d: mechanisms.n_four_bar(int(d.integers(2, 7)), angle=d.uniform(0.2, 0.8)),
    "rhombus": lambda d: mechanisms.rhombus_with_spring(stiffness=d.uniform(20, 90), angle=d.uniform(0.8, 1.3)),
    "von_mises": lambda d: mechanisms.von_mises(rise=d.uniform(0.2, 0.6), strain=d.choice(["engineering", "green"]).item()),
    "andrews": lambda d: mechanisms.andrews(form=d.choice(["bars", "beam"]).item()),
    "delta": lambda d: mechanisms.delta(at=(*d.uniform(-0.1, 0.1, 2), -0.75), platform_mass=d.uniform(0.2, 2)),
    "stewart": lambda d: mechanisms.stewart(kind=d.choice(["6-6", "6-3", "3-3"]).item(), leg_mass=d.uniform(0, 2),
                                            platform_mass=d.uniform(1, 5), turned=tuple(d.uniform(-0.2, 0.2, 3))),
    "robot": lambda d: mechanisms.robot(swing=d.uniform(-1, 1), shoulder=d.uniform(-0.5, 0.5), wrist=d.uniform(0.2, 1)),
    "bennett": lambda d: mechanisms.bennett(angle=d.uniform(0.6, 1.6), mass=d.uniform(0.5, 2)),
    "bricard": lambda d: mechanisms.bricard(mass=d.uniform(0.5, 2)),
    "spherical": lambda d: mechanisms.spherical_four_bar(angle=d.uniform(0.6, 1.4)),
    "sarrus": lambda d: mechanisms.sarrus(height=d.uniform(0.2, 0.4)),
    "triangular": lambda d: vgt.triangular(payload_mass=d.uniform(1, 20)),
    "octahedral": lambda d: vgt.double_octahedral(int(d.integers(1, 4)), beta=d.uniform(-0.1, 0.1), **_train(d)),
}  # fmt: skip


def _library(dice: Dice) -> tuple[str, kt.Model]:
    name = list(LIBRARY)[int(dice.integers(len(LIBRARY)))]
    return name, LIBRARY[name](dice)


def _driven(dice: Dice) -> kt.Model:
    """A mechanism of the library that has drives."""
    while not (model := _library(dice)[1]).all_drives:
        pass
    return model


KINDS: dict[str, Callable[[Dice], kt.Model]] = {
    "planar web": planar_web, "spatial web": spatial_web, "planar bodies": planar_bodies, "spatial bodies": spatial_bodies,
    "skin": skin, "block": block, "way": ways, "library": lambda dice: _library(dice)[1], "chain": _chain, "braced": braced,
    "planar web again": planar_web, "spatial web again": spatial_web, "way again": ways, "joint": _pairs,
    "driven": _driven, "skin again": skin, "spatial bodies again": spatial_bodies, **FRAMES, "frame again": frame,
    "rubbing again": rubbing, "sprung again": sprung,
}  # fmt: skip
"""As many as have no divisor with `EVERY`, so that each gets its share."""
DRIVEN: dict[str, Callable[[Dice], kt.Model]] = {
    "turned": turned, **KINDS, "turned again": turned, "driven again": _driven, "driven once more": _driven,
    "way once more": ways, "way then": ways,
    "carried": carried, "carried again": carried,
    "motors": lambda dice: vgt.double_octahedral(1, beta=dice.uniform(-0.1, 0.1), payload_mass=dice.uniform(0, 5), **TRAIN),
    "sized": lambda dice: truss(int(dice.integers(1 << 30)), 3, massless=False, driven=False, braced=True, sized=True)[0],
}  # fmt: skip
"""Those of runs: more of them move by their drives alone. Their number has no divisor with that of the methods."""
SELDOM: dict[str, Callable[[Dice], kt.Model]] = {
    "large web": large_web,
    "large bays": lambda dice: vgt.double_octahedral(8, **TRAIN),
    "large loops": lambda dice: mechanisms.n_four_bar(40, angle=0.4),
    "large truss": lambda dice: truss(int(dice.integers(1 << 30)), 3, massless=True, driven=True, length=18)[0],
}
EVERY = 20
"""One case in so many is large."""


def cases(seed: int, first: int, last: int) -> Iterator[Case]:
    """Cases first:last of a seed."""
    for number in range(first, last):
        yield case(seed, number)


def case(seed: int, number: int, kinds: dict[str, Callable[[Dice], kt.Model]] = KINDS) -> Case:
    """One case; drafts that the model's own checks refuse are drawn again."""
    large = number % EVERY == EVERY - 1
    table = SELDOM if large else kinds
    name = list(table)[(number // EVERY if large else number) % len(table)]
    for trial in range(200):
        dice = np.random.default_rng([seed, number, trial])
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # joints that are badly conditioned say so
                model = table[name](dice)
        except kt.KinetrussError:
            continue
        return _asked(number, name.split(" again")[0].split(" once more")[0].split(" then")[0], model, dice)
    raise RuntimeError(f"No model of kind {name} is accepted: seed {seed}, case {number}.")


def whole(model: kt.Model) -> Any:
    """The model with its inner parts; older revisions wrote them into the model itself."""
    return getattr(model, "whole", model)


def is_brace(bar: Any) -> bool:
    """Whether a bar stands for no bar of the user."""
    return bool(getattr(bar, "brace", type(bar).__name__ == "Brace"))


def _asked(number: int, name: str, model: kt.Model, dice: Dice) -> Case:
    """A state of the model near its own configuration (one in five in it), and what its drives do."""
    tables = whole(model)
    x0 = np.array([node.at for node in tables.nodes.values()], float)
    loose = np.ones(x0.shape, bool)
    for i, (node, record) in enumerate(tables.nodes.items()):
        loose[i, ["xyz".index(axis) for axis in tables.fixed.get(node, "")]] = False
        loose[i, 1:] &= not record.scalar
    lengths = [np.linalg.norm(np.subtract(*(tables.nodes[end].at for end in one.ends))) for one in tables.members.values()]
    size = float(np.median(lengths)) if lengths else 1.0
    spread = 0.0 if dice.random() < 0.2 else 0.03 * size
    shifts = dice.normal(size=(3, *x0.shape)) * loose
    speed = size * 10.0 ** dice.uniform(-1, 1)
    return Case(
        number=number, name=name, model=model, x=x0 + spread * shifts[0], v=speed * shifts[1], a=5 * speed * shifts[2],
        t=float(dice.uniform(0.05, 0.95)), tasks=_tasks(model, dice), trajectory=trajectory(model, dice),
        load_case=next(iter(model.load_cases), None) if dice.random() < 0.6 else None,
    )  # fmt: skip


def _tasks(model: kt.Model, dice: Dice) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, drive in model.all_drives.items():
        push, many = ("torque", "torques") if drive.kind in ("angle", "hinge") else ("force", "forces")
        amount = float(20 * dice.normal())
        options = [None, None, None, None, kt.Free(), kt.Hold(), kt.GivenForce(**{push: amount}),
                   kt.GivenForce(times=(0.0, 0.4, 1.0), **{many: (amount, -amount, 0.3 * amount)})]  # fmt: skip
        if (task := options[int(dice.integers(len(options)))]) is not None:
            found[name] = task
    return found


def trajectory(model: kt.Model, dice: Dice) -> Any:
    """A small motion of all drives over 1 s, of any kind that they allow; None without drives."""
    starts = {name: start(model, drive) for name, drive in model.all_drives.items()}
    if not starts:
        return None
    known = {name: one for name, one in starts.items() if one is not None}
    kinds = ["sine", "rate"] if len(known) < len(starts) else ["sine", "rate", "moves", "moves", "moves", "moves", "table"]
    kind = kinds[int(dice.integers(len(kinds)))]
    by = {name: float(0.05 * dice.uniform(-1, 1) * abs(starts[name] or 1.0)) for name in starts}
    if kind == "sine":
        return kt.Sine(amplitudes=by, period=0.7, phase=float(dice.uniform(0, 1)), duration=1.0)
    if kind == "rate":
        return kt.ConstantRate(rates=by, duration=1.0)
    if kind == "table":
        times = tuple(np.linspace(0.0, 1.0, 9).tolist())
        columns = {name: tuple(known[name] + by[name] * np.sin(3 * t) for t in times) for name in known}
        return kt.Spline(times=times, values=columns, shape=["spline", "monotone"][int(dice.integers(2))])
    moves = {name: (known[name], known[name] + by[name]) for name in known}
    given: dict[Any, dict[str, Any]] = {
        kt.Quintic: {"duration": 1.0}, kt.Trapezoid: {"duration": 1.0, "ramp": 0.3},
        kt.Cyclic: {"period": 0.5, "cycles": 2.0}, kt.StepResponse: {"duration": 1.0},
    }  # fmt: skip
    kind_of = list(given)[int(dice.choice(4, p=(0.3, 0.3, 0.3, 0.1)))]  # the last one takes seconds to be tabled
    return kind_of(moves=moves, **given[kind_of])


def start(model: kt.Model, drive: Any) -> float | None:
    """Where a drive stands in the model; None where it is not told by two nodes alone."""
    tables = whole(model)
    if drive.kind == "coordinate":
        return float(tables.nodes[drive.node].at["xyz".index(drive.axis)])
    if drive.kind == "hinge" or (drive.kind == "angle" and model.dim == 3):
        return None
    member = tables.members[drive.bar]
    d = np.subtract(*(tables.nodes[end].at for end in reversed(member.ends)))
    if drive.kind == "angle":
        return float(np.arctan2(d[1], d[0]))
    return float(np.linalg.norm(d) if member.length is None else member.length)
