"""The page of examples: every example has a question and an answer that is computed again here, or is a named benchmark."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import kinetruss as kt
from kinetruss.design.optimal_design import model_for

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "examples.md").read_text(encoding="utf-8")
SHELF = kt.library.example_files()
ROWS = {row[0]: row[1:] for row in re.findall(r"^\| `(\w+)` \| ([^|]*\?) \| ([^|]*) \|$", PAGE, re.MULTILINE)}
"""Example -> question and answer."""
BENCHMARKS = {
    "andrews", "bricard", "peaucellier", "delta", "robot", "stewart", "four_bar", "double_pendulum",  # known results
    "measured_slew", "strain_gauges",  # what pages show how to do
}  # fmt: skip
EVERYDAY = set(re.findall(r'\bsaid\("(\w+)"\)', (ROOT / "tests" / "library" / "test_everyday.py").read_text(encoding="utf-8")))
"""Examples whose answers `tests/library/test_everyday.py` computes."""


def read(name: str) -> kt.Model:
    return kt.read(SHELF[name][0])


def governs(model: kt.Model, run: str | None = None) -> Iterator[str]:
    """What governs of members and of motors, in the words of the page."""
    told = kt.report.summary(kt.run(model, run)).record
    for worst in told["worst"][:1]:
        yield f"{worst['part']}, {worst['rule']}, {100 * worst['utilisation']:.1f} %"
    nearest = max((one["nearest_limit"] for one in told["motors"]), key=lambda one: one["utilisation"])
    yield f"{nearest['quantity']}, {100 * nearest['utilisation']:.1f} %"


def volts(model: kt.Model, run: str | None = None) -> float:
    """The largest voltage of a motor, V."""
    return max(np.abs(demand.voltage).max().item() for demand in kt.run(model, run).demand.values())


def double_wishbone() -> Iterator[str]:
    run = kt.run(read("double_wishbone"))
    found = run.quantities["all"].value
    assert run.finding.state == "ok"
    for name in ("camber", "toe"):
        low, high = np.degrees([found.sel(quantity=name).min(), found.sel(quantity=name).max()])
        yield f"{name} {low:.2f}° to {high:.2f}°".replace("-", "−")
    centre = 1e3 * found.sel(quantity="roll_centre")
    yield f"from {centre.min().item():.0f} mm to {centre.max().item():.0f} mm"


def wiper() -> Iterator[str]:
    run = kt.run(read("wiper"))
    assert run.finding.state == "ok"
    yield f"{np.abs(run.forces['all'].drive_force).max().item():.2f} N m"
    angle = np.degrees(run.quantities["all"].value.sel(quantity="transmission"))
    yield f"{angle.min().item():.1f}° to {angle.max().item():.1f}°"


def jansen_leg() -> Iterator[str]:
    run = kt.run(read("jansen_leg"))
    height = run.quantities["all"].value.sel(quantity="foot_y").values
    yield f"{100 * (height < height.min() + 0.01).mean():.0f} % of a turn"
    yield f"{np.abs(run.forces['all'].drive_force).max().item():.1f} N m"


def planar_crane() -> Iterator[str]:
    model = read("planar_crane")
    yield from governs(model)

    def excess(load: float) -> float:
        told = kt.report.summary(kt.run(kt.io.set_values(model, {"nodes.B8.N3.mass": load}))).record
        nearest = max((one["nearest_limit"] for one in told["motors"]), key=lambda one: one["utilisation"])
        assert told["worst"][0]["utilisation"] < 1
        assert nearest["quantity"] == "rms current"
        return float(nearest["utilisation"]) - 1

    yield f"At most {brentq(excess, 740, 760, xtol=0.1):.0f} kg, by the rms current"


def facade() -> Iterator[str]:
    """Forces are linear in the wind: what it needs to reach 1 follows from calm air and one wind."""
    model = read("facade")
    yield from governs(model)
    found = kt.design.optimise(None, kt.io.read_optimum(SHELF["facade"][1]))
    run = kt.run(found.model)
    assert run.finding.state == "ok"
    worst = run.verdict.table()[0]
    assert (worst.part, worst.rule) == ("B1.post4", "buckling")
    assert worst.utilisation == pytest.approx(1, abs=1e-6)
    post = {
        push: kt.run(kt.io.set_values(model, {f"loads.{name}.force.1": -push for name in model.loads}))
        .forces["wind"].member_force.sel(member="B1.post4").values[-1]
        for push in (0.0, 225.0)
    }  # fmt: skip
    push = 225 * (-worst.limit - post[0.0]) / (post[225.0] - post[0.0])
    assert push == pytest.approx(-found.values["wind"], rel=1e-3)
    yield f"up to {0.5 * push / 225:.2f} kN/m²"


def docking() -> Iterator[str]:
    model = read("docking")
    run = model.runs["dock"]
    yield from governs(model)
    for words, task in (("", run.targets), ("jammed ", run.targets.with_(hold=("B3.M9",)))):
        lengths = kt.kinematics.inverse(model, task, samples=run.samples).drive_position
        yield f"{words}{lengths.min().item():.3f} m to {lengths.max().item():.3f} m"


def space_crane() -> Iterator[str]:
    model = read("space_crane")
    yield from governs(model, "lift")
    run = model.runs["lift"]
    motion = kt.kinematics.inverse(model, run.targets, samples=run.samples)
    forces = kt.statics.at_poses(model, motion.position.values[[0, 30, 60]])
    low = -1e3 * kt.statics.deflection(model, forces).displacement.sel(node="B5.N8", axis="z").values
    yield f"{low[0]:.3f} mm"
    yield f"at most {1e3 * abs(kt.flexible.corrected(model, forces, at='B5.N8').change).max().item():.3f} mm"


def wind_tower() -> Iterator[str]:
    model = read("wind_tower")
    yield from governs(model)
    forces = kt.statics.at_poses(model, [{}], load_case="wind")
    lean = kt.statics.deflection(model, forces).displacement.isel(time=0).sel(node=["B8.N4", "B8.N5", "B8.N6"], axis="y")
    change = 1e3 * kt.flexible.corrected(model, forces, at=("B8.N4", "B8.N5.y", "B8.N5.z", "B8.N6.z")).change
    yield f"{change.min().item():.1f} mm to +{change.max().item():.1f} mm".replace("-", "−")
    assert f"by {1e3 * lean.mean().item():.1f} mm" in ROWS["wind_tower"][0]


def isolator_beam() -> Iterator[str]:
    """The gains are those of the isolator without the beam, at the least cost of 4e5 v^2 + f^2."""
    model, legs = read("isolator_beam"), ("M7", "M9", "M11")
    bare = model.with_(nodes={n: node for n, node in model.nodes.items() if n[0] == "N"}, beams={}, bodies={}, clamped={})
    alone, whole = (kt.dynamics.linearise(one, kt.statics.equilibrium(one), inputs=legs) for one in (bare, model))
    gains = kt.dynamics.feedback(alone, inputs=legs, state_cost={f"{node}.z'": 4e5 for node in ("N7", "N8", "N9")}).gains
    states = [str(name) for name in gains.state.values]
    for share, words in ((1.0, "ratio of {:.4f}"), (0.0, "place of {:.4f}"), (4.0, "but {:.4f} with four times")):
        table = {leg: dict(zip(states, share * row, strict=True)) for leg, row in zip(legs, gains.values, strict=True)}
        poles = np.asarray(kt.dynamics.feedback(whole, inputs=legs, gains=table).poles)
        near = poles[(np.abs(poles) > 2 * np.pi * 11) & (np.abs(poles) < 2 * np.pi * 12.5)]
        yield words.format((-near.real / np.abs(near)).max())


def double_octahedral_slew() -> Iterator[str]:
    model = read("double_octahedral_slew")
    yield [*governs(model)][-1]
    yield f"{volts(kt.io.set_values(model, {'trajectories.tilt.duration': 1.0})):.0f} V"


def driven_bay() -> Iterator[str]:
    model = read("driven_bay")
    tasks, run = model.runs["pose"].tasks, kt.run(model, "pose")
    for name, task in tasks.items():
        length = run.motion.length.sel(member=name).values
        wanted, left = 1e3 * abs(task.target - length[0]), 1e3 * abs(task.target - length[-1])
        yield f"{left:.3f} mm of {wanted:.1f} mm ({name})"


def slewing_experiments() -> Iterator[str]:
    model = read("slewing_experiments")
    for run in ("experiment_1", "experiment_2"):
        yield f"{volts(model, run):.1f} V"
        yield f"{kt.run(model, run).verdict.table()[0].utilisation * 100:.1f} %"


def chain_two_axis() -> Iterator[str]:
    """The optimum of the page, run afresh: both limits that hold it are reached, and members have room."""
    task = kt.io.read_optimum(SHELF["chain_two_axis"][1])
    model = kt.io.set_values(
        model_for(task, SHELF["chain_two_axis"][0]),
        {"trajectories.lean.duration": 3.008, "gears.gear.ratio": 26.55, "screws.screw.lead": "3.9 mm/rev"},
    )
    run = kt.run(model, "lean")
    torque = np.nanmax(np.abs(run.demand["all"].motor_torque.values))
    assert max(one.utilisation for one in run.verdict.table()) < 0.5
    yield f"{volts(model, 'lean'):.1f} V and {torque:.3f} N m"


ANSWERS: dict[str, Callable[[], Iterator[str]]] = {
    "mast": lambda: governs(read("mast")),
    "drive_train": lambda: iter([[*governs(read("drive_train"))][-1]]),
    "triangular_truss": lambda: iter([f"no: {volts(read('triangular_truss')):.1f} V"]),
    **{
        one.__name__: one
        for one in (double_wishbone, wiper, jansen_leg, planar_crane, facade, docking, space_crane, wind_tower,
                    isolator_beam, double_octahedral_slew, driven_bay, slewing_experiments, chain_two_axis)
    },
}  # fmt: skip
"""What an answer of the page must say, computed."""


SCRIPTED = {"mast_design": "98.7"}
"""Examples whose answers their scripts compute and assert."""


def test_every_example_has_a_question_that_is_answered_or_is_a_benchmark():
    assert set(ROWS) | BENCHMARKS == set(SHELF)
    assert not set(ROWS) & BENCHMARKS
    assert set(ANSWERS) | EVERYDAY | set(SCRIPTED) == set(ROWS)
    for name, answer in SCRIPTED.items():
        assert answer in ROWS[name][1]
        assert f'"{answer}"' in (ROOT / "examples" / f"{name}.py").read_text(encoding="utf-8")
    assert set(re.findall(r"`(\w+)`", PAGE.split("## Benchmarks")[1].split("## More")[0])) == BENCHMARKS
    for name in ROWS:
        head = re.match(r"(?:#.*\n)+", SHELF[name][0].read_text(encoding="utf-8"))
        assert head is not None and "?" in head[0], f"{name}.yaml asks nothing in its first comment"


def test_pictures_are_those_of_examples():
    assert set(re.findall(r"\(pictures/example_(\w+)\.png\)", PAGE)) <= set(SHELF)


@pytest.mark.slow
@pytest.mark.parametrize("name", ANSWERS)
def test_the_page_says_what_the_numbers_decide(name):
    answer = ROWS[name][1]
    told = [*ANSWERS[name]()]
    assert told
    assert [text for text in told if text not in answer] == [], answer


@pytest.mark.slow
def test_the_page_tells_the_strokes_of_docking():
    model = read("docking")
    run = model.runs["dock"]
    for task in (run.targets, run.targets.with_(hold=("B3.M9",))):
        lengths = kt.kinematics.inverse(model, task, samples=run.samples).drive_position
        assert f"between {lengths.min().item():.3f} m and {lengths.max().item():.3f} m" in PAGE


@pytest.mark.slow
def test_the_page_tells_more_of_the_crane():
    model: Any = read("space_crane")
    run = model.runs["lift"]
    motion = kt.kinematics.inverse(model, run.targets, samples=run.samples)
    forces = kt.statics.at_poses(model, motion.position.values[[0, 60]])
    low = -1e3 * kt.statics.deflection(model, forces).displacement.sel(node="B5.N8", axis="z").values
    assert f"{low[0]:.3f} mm at the start and {low[1]:.3f} mm at the end" in PAGE
    change = 1e3 * abs(kt.flexible.corrected(model, forces, at="B5.N8").change).max().item()
    assert f"change by {change:.3f} mm at most" in PAGE
    first = kt.flexible.frequencies(model, forces, modes=1).frequency.values[0, 0]
    assert f"with the load is {first:.2f} Hz" in PAGE
