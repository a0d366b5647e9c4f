"""Worked calculations: their result is that of the run, their printed numbers give their result, and they say where not."""

from __future__ import annotations

import dataclasses
import math
import re

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report
from kinetruss.report.document.sheets import evaluate, in_numbers, in_symbols
from kinetruss.report.document.worked import demand_sheet, member_sheet, shown, worked
from kinetruss.runs import run
from samples import ALUMINIUM, MOTOR, SCREW, fourbar, tripod

ROUND_OFF = 1e-11
PREFIX = {"": 1.0, "n": 1e-9, "µ": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6, "G": 1e9}
PLAIN = {"mm²": 1e-6, "mm³": 1e-9, "mm⁴": 1e-12, "mm/rad": 1e-3, "deg": math.pi / 180, "%": 0.01}
WHOLE = ("N m/A", "V s/rad", "rad/s²", "rad/s", "kg m²", "m/s²", "m/s", "N m", "A² s", "N·m² s", "ohm", "Pa", "A/s", "H",
         "N", "V", "A", "W", "m", "s")  # fmt: skip
UNITS = PLAIN | {prefix + unit: size for unit in WHOLE for prefix, size in PREFIX.items() if unit not in PLAIN}
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
NAMES = "|".join(map(re.escape, sorted(UNITS, key=len, reverse=True)))
NUMBER = rf"(?P<value>\d[\d.]*)(?P<power>·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?(?: (?P<unit>{NAMES})(?![A-Za-z²]))?"


def computed(numbers: str) -> float:
    """The value of what is printed, by its own numbers and units."""

    def number(found: re.Match[str]) -> str:
        power = found["power"][3:].translate(RAISED) if found["power"] else "0"
        return f"({float(found['value']) * 10.0 ** int(power) * UNITS.get(found['unit'], 1.0)!r})"

    text = re.sub(NUMBER, number, numbers.replace("\u00a0", " "))
    text = re.sub(r"\|([^|]*)\|", r"abs(\1)", text).replace("√", "sqrt").replace("·", "*").replace("−", "-").replace("π", "pi")
    text = text.replace("²", "**2").replace("³", "**3").replace("⁴", "**4")
    names = {"sqrt": math.sqrt, "pi": math.pi, "cos": math.cos, "sin": math.sin, "abs": abs, "min": min}
    names |= {"sec": lambda angle: 1 / math.cos(angle), "sign": lambda value: math.copysign(1.0, value)}
    return float(eval(text, {"__builtins__": {}}, names))


def geared(**motor: object) -> kt.Model:
    """A four-bar linkage behind a lossy gear."""
    train = {"gear": kt.Gear(ratio=30.0, efficiency=0.8, inertia=1e-6), "motor": MOTOR.with_(friction_torque=1e-3, **motor)}
    return fourbar(drives={"motor": kt.AngleDrive("crank", **train)})


def twisted() -> kt.Model:
    """A boom on an upright hinge beside the middle of a hub: its weight twists the arm."""
    return kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(1, 0.1, 0), mass=2.0)}, fixed=["O"],
        hubs={"O": kt.Hub(arms={"boom": (0, 0.1, 0)}, hinges={"boom": "z"})},
        bars={"boom": kt.Bar(ends=("O", "A"), mass=0.3)}, section=kt.Rod(diameter=0.03), material=ALUMINIUM,
        drives={"turn": kt.HingeDrive(axis=("O.boom", "O.boom.axis1"), start="O", end="A")}, gravity=(0, 0, -9.81),
        runs={"stand": kt.Run(analysis="statics.at_poses", poses={"drawn": {}})},
    )  # fmt: skip


def sticking(**gear: object) -> kt.Model:
    """The tripod with screws that take more torque to start than to run, and motors with a limit of torque."""
    model = tripod()
    train = {"screw": SCREW.with_(static_friction=0.16), "motor": MOTOR.with_(max_torque=0.1, friction_torque=2e-4)}
    train["gear"] = kt.Gear(ratio=5.2, efficiency=0.8, **gear)
    return model.with_(active={name: leg.with_(**train) for name, leg in model.active.items()})


MODELS = {
    "screws": lambda: tripod(),
    "screws at rest": sticking,
    "torsion": twisted,
    "poses": lambda: tripod(
        safety=kt.Safety(yielding=1.5, buckling=2.0),
        runs={"stand": kt.Run(analysis="statics.at_poses", poses={"rest": {}, "high": {"LA": 1.1}})},
    ),
    "angle behind a gear": lambda: geared(max_torque=1.0, max_speed=700.0, rated_current=2.0),
    "with inductance": lambda: geared(inductance=2e-3),
    "rectangle in the plane": lambda: fourbar(),
    "general section": lambda: fourbar(
        section=kt.General(area=1e-4, I2=2e-9, I3=1e-9, c2=0.01, c3=0.01, J=3e-9, shear_factor=1.5)
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", MODELS)
def test_every_entry_can_be_worked_and_agrees(kind):
    done = run(MODELS[kind]())
    count, symbols = 0, set()
    for row in done.verdict.table():
        if row.checked and row.utilisation > 1e-9:
            sheet, count = member_sheet(done, row), count + 1
            symbols |= {step.symbol for step in sheet.steps}
            assert sheet.difference < ROUND_OFF, (row.part, row.rule)
    for case, demand in done.demand.items():
        for row in demand.table():
            if row.checked and row.utilisation > 1e-9:
                sheet, count = demand_sheet(done, row, case), count + 1
                assert sheet.difference < ROUND_OFF, (row.part, row.rule)
    assert count >= 2
    assert ("σ_t" in symbols) == (kind == "torsion")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["screws", "screws at rest", "angle behind a gear", "rectangle in the plane"])
def test_printed_numbers_give_the_printed_result(kind):
    """Five digits are printed; differences of nearly equal numbers lose some of them."""
    for sheet in worked(run(MODELS[kind]())):
        assert sheet.steps
        for step in sheet.steps:
            if np.isfinite(step.value) and step.value:
                assert computed(step.numbers) == pytest.approx(step.value, rel=2e-3, abs=1e-9), (
                    sheet.title,
                    step.symbol,
                    step.numbers,
                )


def test_break_away_by_hand():
    """Every break-away torque of the run, by the formula of a screw with its static friction."""
    done = run(sticking())
    rows = [(row, case) for case, demand in done.demand.items() for row in demand.table() if row.rule == "break-away"]
    assert len(rows) == 6
    for row, case in rows:
        sheet = demand_sheet(done, row, case)
        assert sheet.difference < ROUND_OFF
        F, slope = sheet.values["F"], 2 * 2.5266e-4 / 0.0127
        up, down = (
            0.00635 * abs(F) * one for one in ((slope + 0.16) / (1 - 0.16 * slope), (0.16 - slope) / (1 + 0.16 * slope))
        )
        expected = {up / (5.2 * 0.8) + 2e-4, down / (5.2 * 0.8) + 2e-4}
        assert min(abs(sheet.demand - one) for one in expected) < 1e-12
        assert "μ_0" in {one.symbol for one in sheet.given}
    running = next(sheet for sheet in worked(done) if sheet.row.rule == "voltage")
    assert "T_0" in {step.symbol for step in running.steps}  # told beside the running torque, where the record has it


def test_an_integral_lists_its_samples():
    done = run(geared(rated_current=2.0))
    row = next(row for row in done.demand["all"].table() if row.rule == "rms current")
    (_, _, time), (_, _, current) = demand_sheet(done, row, "all").samples
    total = sum((b - a) * (p**2 + q**2) / 2 for a, b, p, q in zip(time, time[1:], current, current[1:], strict=False))
    assert math.sqrt(total / time[-1]) == pytest.approx(row.value, rel=1e-12)


@pytest.mark.slow
def test_a_column_by_hand():
    """A strut under its load: Euler's load, Johnson's below the transition, and the interaction without bending."""
    for length, johnson in ((1.5, False), (0.2, True)):
        rod = kt.Rod(diameter=0.02)
        model = kt.Model(
            nodes={"A": (0, 0), "B": (length, 0)}, fixed={"A": "xy", "B": "y"}, material=ALUMINIUM, section=rod,
            bars={"strut": ("A", "B")}, safety=kt.Safety(yielding=1.5, buckling=2.0),
            loads={"push": kt.NodalForce(node="B", force=(-1000.0, 0))}, runs={"stand": kt.Run(analysis="statics.linear")},
        )  # fmt: skip
        sheets = {sheet.row.rule: sheet for sheet in worked(run(model, "stand"))}
        euler = math.pi**2 * 71e9 * math.pi * 0.02**4 / 64 / length**2
        squash = 240e6 * math.pi * 0.01**2
        critical = squash * (1 - squash / (4 * euler)) if johnson else euler
        assert (euler > squash / 2) == johnson
        assert sheets["buckling"].capacity == pytest.approx(critical / 2, rel=1e-13)
        assert sheets["buckling"].demand == pytest.approx(1000.0, rel=1e-12)
        assert sheets["beam-column"].demand == pytest.approx(2000 / critical, rel=1e-12)
        assert any("Johnson" in step.meaning for step in sheets["buckling"].steps) == johnson


def test_a_result_that_differs_is_not_shown_as_good(lift):
    sheet = worked(lift)[0]
    assert sheet.agrees
    assert "The run has the same values." in "".join(one for one in shown([sheet]) if isinstance(one, str))
    sheet.row = dataclasses.replace(sheet.row, value=sheet.row.value * (1 + 1e-6))
    assert not sheet.agrees
    assert "The two differ: clarify this before use." in "".join(one for one in shown([sheet]) if isinstance(one, str))


@pytest.mark.slow
def test_the_governing_entries_are_worked(lift):
    record = report.document_page(lift).record
    assert [one["title"] for one in record["worked"]] == [sheet.title for sheet in worked(lift)]
    used = [one["utilisation"] for one in record["worked"]]
    assert used == sorted(used, reverse=True)
    first = record["worked"][0]
    assert first["rule"] == "voltage"
    assert {"T_s", "η_s", "T_m", "i", "U"} <= {step["symbol"] for step in first["steps"]}
    assert record["result"][0].startswith(f"Governing: voltage of the drive of {first['part']}, ")


def test_formulas_are_computed_as_printed():
    values = {"A": 2.0, "b": 3.0, "c": -4.0}
    for text, symbols in (("A - (b - c)", "A − (b − c)"), ("A/(b/c)", "A/(b/c)"), ("-A*b**2", "−A b²"), ("(A*b)**2", "(A b)²")):
        assert evaluate(text, values) == eval(text, {}, dict(values))
        assert in_symbols(text) == symbols
        assert computed(in_numbers(text, values, {})) == pytest.approx(eval(text, {}, dict(values)))
    assert evaluate("A/z", {"A": 1.0, "z": 0.0}) == math.inf
