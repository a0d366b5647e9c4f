"""Optima of models: closed forms with their prices, words, units, lists, stops; what is refused before anything is computed."""

from __future__ import annotations

import json
import math
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.design.model_function import ModelFunction
from kinetruss.design.optimum_result import active_words
from kinetruss.verification import optima

STILL = {"arguments": {"weight": False}}


def rod(section=None, pull=7e3):
    """A rod of 2 m under a force at its end."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")}, material="steel_s235",
        section=section or kt.General(area=1e-3, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
        loads={"pull": kt.NodalForce(node="B", force=(pull, 0))},
    )  # fmt: skip


AREA = {"area": {"of": "section.area", "between": ("10 mm^2", "20 cm^2")}}


def test_a_rod_has_the_area_of_its_stress_and_its_price():
    """A = F/s; 1 MPa more saves rho l F/s^2 kg."""
    found = kt.design.optimise(rod(), AREA, "mass", {"stress": {"of": "axial_stress", "at_most": "100 MPa"}}, **STILL)
    density = rod().material_of(rod().bars["b"]).density
    assert found.values["area"] == pytest.approx(70e-6, rel=1e-6)
    assert found.certificate.first_order
    (active,) = found.active
    assert active.price == pytest.approx(density * 2 * 7e3 / 1e8**2, rel=1e-6)
    assert (active.name, active.side, active.unit) == ("stress of b", "most", "Pa")
    saved = 1e3 * active.price * 1e6  # g for 1 % of 100 MPa
    assert active_words(active, "kg") == f"stress of b reaches 100 MPa; 1 % more would save {saved:.4g} g"
    assert found.model.section_of(found.model.bars["b"]).area == pytest.approx(70e-6, rel=1e-6)


def test_the_largest_load_is_asked_for_by_a_minus():
    """F = s A, and 1 MPa more carries A more."""
    wanted = {"load": {"of": "loads.pull.force.0", "between": ("1 kN", "1 MN")}}
    found = kt.design.optimise(rod(), wanted, "-load", {"stress": {"of": "axial_stress", "at_most": "100 MPa"}}, **STILL)
    assert found.values["load"] == pytest.approx(1e5, rel=1e-6)
    assert found.objective == -found.values["load"]
    assert found.active[0].price == pytest.approx(1e-3, rel=1e-6)


def test_a_strut_has_the_diameter_of_eulers_load():
    """P = pi^2 E pi d^4/64/l^2 with a safety of 2, pinned ends."""
    strut = rod(kt.Rod(diameter="60 mm"), pull=-7e3)
    limits = {"buckling": {"of": "member_force/buckling_load", "at_least": -0.5}}
    found = kt.design.optimise(strut, {"d": {"of": "section.diameter", "between": ("10 mm", "80 mm")}}, "mass", limits, **STILL)
    E = strut.material_of(strut.bars["b"]).E
    assert found.values["d"] == pytest.approx((2 * 7e3 * 4 * 64 / (math.pi**3 * E)) ** 0.25, rel=1e-6)
    assert found.certificate.first_order


def test_a_limit_on_a_frequency_is_in_hertz():
    """f = sqrt(k/m)/(2 pi): the least stiffness for 3 cycles in a second."""
    hanging = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"},
        bars={"rod": kt.Bar(ends=("O", "A"), mass=0, kind="elastic", stiffness=200.0)},
    )  # fmt: skip
    wanted = {"stiffness": {"of": "bars.rod.stiffness", "between": ("100 N/m", "10 kN/m")}}
    limits = {"first": {"of": "frequency[1]", "at_least": "3 Hz", "analysis": "flexible.frequencies"}}
    found = kt.design.optimise(hanging, wanted, "stiffness", limits)
    assert found.values["stiffness"] == pytest.approx(2.0 * (2 * math.pi * 3.0) ** 2, rel=1e-6)
    assert [one.unit for one in found.limits] == ["Hz"]
    assert active_words(found.active[0], found.unit).startswith("first reaches 3 Hz; 1 % less would save ")
    for text, unit in (("max(frequency)", "Hz"), ("2*pi*frequency[1]", "1/s"), ("frequency[1] + 1/s", "1/s")):
        assert kt.Response(text, kt.flexible.frequencies, hanging).unit == unit


def test_a_node_is_moved_to_the_least_weight():
    """Two bars of one area to a load at a fixed depth: the least length of both is straight above it."""
    pair = kt.Model(
        nodes={"A": (-1, 0), "B": (1, 0), "C": (0.4, -1)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")},
        section=kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), material="steel_s235",
        loads={"load": kt.NodalForce(node="C", force=(0, -1e3))},
    )  # fmt: skip
    found = kt.design.optimise(pair, {"x": {"of": "nodes.C.at.0", "between": (-0.8, 0.8)}}, "mass", **STILL)
    assert found.values["x"] == pytest.approx(0, abs=1e-4)
    assert found.active == ()
    assert found.certificate.first_order


def test_gradients_of_limits_are_those_of_their_values():
    """Stresses, displacements, buckling and frequencies of the published tasks, by differences of fourth order."""
    tower, task = optima.twenty_five_bar_task()
    buckling = {"of": "member_force/buckling_load", "at_least": -0.5}
    tasks = [(tower, task.with_(limits={**task.limits, "buckling": buckling})), optima.frequency_task(69.8e9)]
    for model, one in tasks:
        function = ModelFunction(model, one)
        p = np.linspace(0.3, 0.7, len(function.problem)) * function.problem.upper
        rows = np.arange(len(function.problem.limits))
        slope = np.vstack(function.gradients(p, rows))
        for k in (0, len(p) - 1):
            found = np.zeros(len(rows) + 1)
            for share, weight in ((1, 2 / 3), (-1, -2 / 3), (2, -1 / 12), (-2, 1 / 12)):
                moved = p.copy()
                moved[k] *= 1 + 1e-3 * share
                value, excess = function.values(moved, None)
                found += weight * np.append(value, excess) / (1e-3 * p[k])
            assert slope[:, k] == pytest.approx(found, abs=1e-7 * np.abs(found).max())


def test_sections_from_a_list_are_proven_or_said_not_to_be():
    """The lightest of a list by branch and bound; with weight, which changes the loads, improved step by step."""
    truss, task = optima.ten_bar_task("displacements")
    listed = {
        name: {"of": one.of, "choose": [f"{area} in^2" for area in (1.62, 5.0, 10.0, 15.0, 24.0, 33.5)]}
        for name, one in task.variables.items()
    }
    proven = kt.design.optimise(truss, task.with_(variables=listed))
    assert proven.proof.closed
    assert "proven by branch and bound" in proven.sentence
    assert kt.design.optimise(truss, task).objective < proven.objective
    weighing = kt.design.optimise(truss, task.with_(variables=listed, arguments={"weight": True}))
    assert weighing.proof is None
    assert "not proven" in weighing.sentence
    assert weighing.certificate.feasible
    assert weighing.objective >= proven.objective * (1 - 1e-9)


def test_limits_that_exclude_each_other_are_named():
    limits = {
        "stress": {"of": "axial_stress", "at_most": "100 MPa"},
        "soft": {"of": "displacement[B, x]", "at_least": "2 mm"},
        "idle": {"of": "displacement[B, y]", "at_most": "1 m"},
    }
    with pytest.raises(kt.errors.AnalysisError, match="These 2 limits exclude each other") as error:
        kt.design.optimise(rod(), AREA, "mass", limits, **STILL)
    assert "stress of b" in str(error.value)
    assert "soft" in str(error.value)
    assert "idle" not in str(error.value)


@pytest.mark.parametrize(
    ("variables", "limits", "said"),
    [
        ({"a": {"of": "bars.c.section.area", "between": (1, 2)}}, {}, "variables.a.of: bars.c: 'c' is not known here"),
        ({"a": {"of": "section.area", "between": (-1, 2)}}, {}, "variables.a.of"),
        ({**AREA, "b": {"of": "section.I2", "between": (1e-9, 1e-8)}}, {}, "variables.b: changes neither"),
        ({**AREA, "b": {"of": "section.area", "between": (1e-5, 1e-4)}}, {}, "which 'area' changes too"),
        (AREA, {"s": {"of": "axial_stres", "at_most": 1}}, "Did you mean 'axial_stress'"),
        (AREA, {"s": {"of": "axial_stress", "at_most": "1 mm"}}, "limits.s.at_most: is in m, but axial_stress in Pa"),
        (AREA, {"s": {"of": "axial_stress", "at_most": 1, "load_cases": "wind"}}, "no load case called 'wind'"),
        (AREA, {"s": {"of": "axial_stress", "at_most": 1, "analysis": "statics.liner"}}, "Did you mean 'statics.linear'"),
        (AREA, {"s": {"of": "axial_stress", "at_most": 1, "at_least": 2}}, "no value keeps both"),
        ({"a": {"of": "section.area"}}, {}, "needs bounds or a list"),
    ],
)
def test_faults_are_told_before_anything_is_computed(variables, limits, said):
    with pytest.raises(kt.errors.InputError) as error:
        kt.design.optimise(rod(), variables, "mass", limits, **STILL)
    assert said in str(error.value)


# The command, stopped and gone on with.

TASK = """\
kinetruss_optimum: 1
model: truss.yaml
arguments: {weight: false}
variables:
  top: {of: [bars.5-3.section.area, bars.3-1.section.area], between: [0.1 in^2, 40 in^2]}
  bottom: {of: [bars.6-4.section.area, bars.4-2.section.area], between: [0.1 in^2, 40 in^2]}
  diagonals: {of: [bars.5-4.section.area, bars.6-3.section.area, bars.3-2.section.area], between: [0.1 in^2, 40 in^2]}
limits:
  stress: {of: axial_stress, at_most: 25 ksi, at_least: -25 ksi}
  displacement: {of: displacement, at_most: 2 in, at_least: -2 in}
"""


@pytest.fixture
def folder(tmp_path):
    kt.write(optima.ten_bars(), tmp_path / "truss.yaml")
    (tmp_path / "task.yaml").write_text(TASK)
    return tmp_path


def command(folder, *arguments):
    return subprocess.Popen(
        [sys.executable, "-c", "from kinetruss.cli.start import start; start()", "optimise", *arguments], cwd=folder, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={**os.environ, "NO_COLOR": "1"},
    )  # fmt: skip


def wait_for(file, lines, process):
    """Until a file has so many lines, or the process has ended."""
    for _ in range(6000):
        if process.poll() is not None or (file.exists() and file.read_bytes().count(b"\n") >= lines):
            return
        time.sleep(0.05)


@pytest.mark.slow
def test_a_killed_command_goes_on_where_it_was(folder):
    whole = command(folder, "task.yaml", "--json")
    expected = json.loads(whole.communicate()[0])
    assert whole.returncode == 0
    first = command(folder, "task.yaml", "-o", "out")
    wait_for(folder / "out" / "evaluations.jsonl", 9, first)
    first.kill()
    first.communicate()
    known = (folder / "out" / "evaluations.jsonl").read_bytes().count(b"\n")
    again = command(folder, "task.yaml", "-o", "out", "--json")
    found = json.loads(again.communicate()[0])
    assert again.returncode == 0
    assert found["values"] == expected["values"]  # to the last bit
    assert found["computed"] <= expected["computed"] - known + 1
    assert kt.read(folder / "out" / "optimum.yaml").bars["5-3"].section.area == expected["values"]["top"]


@pytest.mark.slow
def test_an_interrupted_command_keeps_the_best_design(folder):
    process = command(folder, "task.yaml", "-o", "out", "--json")
    wait_for(folder / "out" / "evaluations.jsonl", 12, process)
    process.send_signal(signal.SIGINT)
    text, _ = process.communicate()
    found = json.loads(text)
    if process.returncode == 1:  # with a design that keeps all limits, or 130 without
        assert found["state"] == "interrupted"
        assert found["certificate"]["feasible"]
        assert kt.read(folder / "out" / "optimum.yaml")


def test_a_model_has_its_task_beside_it(folder):
    """MODEL.optimum.yaml; a model with none or with several is refused, and they are named."""
    from click.testing import CliRunner

    from kinetruss.cli import main

    def said(*arguments):
        return CliRunner().invoke(main, ["optimise", str(folder / "truss.yaml"), *arguments])

    assert said().exit_code == 2
    assert "no task stands beside it as truss.optimum.yaml" in said().stderr
    (folder / "truss.optimum.yaml").write_text(TASK)
    found = json.loads(said("--json").stdout)
    assert found["objective"] == kt.design.optimise(None, folder / "task.yaml").objective
    (folder / "truss.stiff.optimum.yaml").write_text(TASK)
    assert "2 tasks beside it: truss.optimum.yaml, truss.stiff.optimum.yaml" in said().stderr


def test_whole_numbers_of_a_file_stay_whole(folder):
    """Arguments of an analysis: three modes are not 3.0 of them."""
    (folder / "task.yaml").write_text(TASK.replace("{weight: false}", "{weight: false, modes: 3, damping: 0.5, size: 1e3}"))
    given = kt.io.read_optimum(folder / "task.yaml").arguments
    assert given == {"weight": False, "modes": 3, "damping": 0.5, "size": 1000.0}
    assert {name: type(one) for name, one in given.items()} == {"weight": bool, "modes": int, "damping": float, "size": float}


def test_a_value_that_is_infinite_exceeds_its_limit():
    """A column beyond Euler's load that its weight bends: it is said, and no variable is called idle because of it."""
    column = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")}, section=kt.Rod(diameter=0.01),
        material="steel_s235", loads={"push": kt.NodalForce(node="B", force=(-9e3, 0))}, gravity=(0, -9.81),
    )  # fmt: skip
    with pytest.raises(kt.errors.AnalysisError, match="Limits are infinite near the start of the search"):
        kt.design.optimise(column, {"d": {"of": "section.diameter", "between": ("5 mm", "80 mm")}}, "mass",
                           {"all": {"of": "utilisation", "at_most": 1}})  # fmt: skip


def test_only_the_same_task_goes_on_in_a_folder(folder):
    """Another task's folder, and one that holds anything else, are refused and stay as they are."""
    task, out = kt.io.read_optimum(folder / "task.yaml"), folder / "out"
    first = kt.design.optimise(None, task, out=out)
    again = kt.design.optimise(None, task, out=out)
    assert again.values == first.values
    assert again.computed == 0
    before = (out / "optimum.json").read_bytes()
    other = task.with_(limits={"stress": {"of": "axial_stress", "at_most": "24 ksi", "at_least": "-24 ksi"}})
    with pytest.raises(kt.errors.InputError, match="another model or task"):
        kt.design.optimise(None, other, out=out)
    with pytest.raises(kt.errors.InputError, match="holds no optimum"):
        kt.design.optimise(None, task, out=folder)
    assert (out / "optimum.json").read_bytes() == before
    assert kt.design.optimise(None, other, out=out, overwrite=True).computed > 0


def test_faults_of_a_file_have_their_place(folder):
    (folder / "task.yaml").write_text(TASK.replace("of: axial_stress,", "of: axial_stres,"))
    process = command(folder, "task.yaml")
    assert "task.yaml:9:16: limits.stress.of" in process.communicate()[1]
    assert process.returncode == 2


def test_limits_over_the_instants_of_a_motion_are_kept_at_all_of_them():
    """The heaviest payload within a drive force: of 2,001 instants the worst is reached and named, and has the price."""
    truss = kt.library.vgt.triangular().with_(
        trajectories={"move": kt.Quintic(moves={"actuator": (2.0, 2.5)}, duration=2.0)}, gravity=(0, -9.81)
    )
    moving = {"analysis": "dynamics.inverse", "arguments": {"trajectory": "move", "samples": 2001}}

    def heaviest(limit):
        limits = {"force": {"of": "drive_force", "at_most": limit, "at_least": -limit}}
        return kt.design.optimise(truss, {"mass": {"of": "nodes.B.mass", "between": (5, 20)}}, "-mass", limits, **moving)

    found, wider = heaviest(100.0), heaviest(100.1)
    motion = kt.kinematics.follow(found.model, "move", samples=2001)
    force = kt.dynamics.inverse(found.model, motion).drive_force.values[:, 0]
    assert np.abs(force).max() == pytest.approx(100, rel=1e-6)
    (active,) = found.active
    assert active.name.startswith("force of actuator at ")
    at = float(active.name.split()[-2])
    assert np.interp(at, motion.time.values, np.abs(force)) == pytest.approx(100, rel=1e-5)
    assert found.objective - wider.objective == pytest.approx(0.1 * active.price, rel=1e-3)
    assert found.certificate.first_order


def closed(coupler, rocker=0.25, crank=0.1, ground=0.28):
    """A four-bar whose crank makes a whole turn, if the coupler reaches: crank + ground <= coupler + rocker."""
    d = ground - crank
    x = (d * d + coupler**2 - rocker**2) / (2 * d)
    turn = kt.ConstantRate(rates={"motor": 6.4}, duration=1.0)
    return kt.Model(
        nodes={"A": (0, 0), "B": (crank, 0), "C": (crank + x, math.sqrt(coupler**2 - x * x)), "D": (ground, 0)},
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}, drives={"motor": kt.AngleDrive("crank")},
        fixed=["A", "D"], runs={"turn": kt.Run(analysis="kinematics.follow", trajectory=turn, samples=61)},
    )  # fmt: skip


TURNS = {"analysis": "runs.run", "arguments": {"run": "turn"}}


@pytest.mark.parametrize("method", ["slsqp", "highs", "trust-constr"])
def test_a_search_turns_back_where_the_analysis_fails(method):
    """The shortest coupler, 0.13 m, with which the crank still turns, but for dead centres between samples."""
    model = kt.library.parametric(closed, coupler=0.3)
    wanted = {"coupler": {"of": "parameters.coupler", "between": (0.08, 0.42)}}
    limits = {"swing": {"of": "position[C, y]", "at_most": 0.3}}
    found = kt.design.optimise(model, wanted, "coupler", limits, **TURNS, method=method)
    assert 0.1298 <= found.values["coupler"] < 0.1305
    assert not found.certificate.first_order
    assert "the analysis fails" in " ".join(found.notes)


def test_a_search_that_only_passes_where_the_analysis_fails_is_certified():
    """The coupler with which the rocker rises to 0.22 m lies inside."""
    model = kt.library.parametric(closed, coupler=0.4)
    wanted = {"coupler": {"of": "parameters.coupler", "between": (0.08, 0.42)}}
    least = "(max(position[C, y])/m - 0.22)**2"
    found = kt.design.optimise(model, wanted, least, {}, **TURNS, tolerance=1e-9)
    assert found.objective == pytest.approx(0, abs=1e-8)
    assert 0.13 < found.values["coupler"] < 0.42


def other_closed(coupler):
    """The same model as `closed` at 0.3 m, and another one elsewhere."""
    return closed(0.6 - coupler)


def test_another_function_that_gives_the_same_model_is_another_task(tmp_path):
    wanted = {"coupler": {"of": "parameters.coupler", "between": (0.25, 0.35)}}
    for _ in range(2):
        kt.design.optimise(kt.library.parametric(closed, coupler=0.3), wanted, "coupler", {}, **TURNS, out=tmp_path)
    with pytest.raises(kt.errors.InputError, match="another model or task"):
        kt.design.optimise(kt.library.parametric(other_closed, coupler=0.3), wanted, "coupler", {}, **TURNS, out=tmp_path)


def test_bounds_at_which_a_function_gives_no_model_are_refused():
    model = kt.library.parametric(closed, coupler=0.3)
    with pytest.raises(kt.ModelError, match=r"the function gives no model at coupler 0.5: "):
        kt.design.optimise(model, {"coupler": {"of": "parameters.coupler", "between": (0.1, 0.5)}}, "coupler", {}, **TURNS)


def test_the_buckling_load_of_a_member_that_a_drive_moves_is_refused_along_a_motion():
    """It is that of the length in the model; the load at which a member yields is the same at all lengths."""
    file = kt.library.example_files()["triangular_truss"][0]
    wanted = {"load": {"of": "nodes.B.mass", "between": (1.0, 100.0)}}
    found = []
    for kind in ("yield_load", "buckling_load"):
        limits = {"force": {"of": f"member_force/{kind}", "at_least": -0.5}}
        try:
            found.append(kt.design.optimise(file, wanted, "-mass", limits, analysis="runs.run", arguments={"run": "extend"}))
        except kt.ModelError as error:
            found.append(str(error))
    assert found[0].certificate.first_order
    assert "buckling_load of actuator changes with the length along a motion" in found[1]
