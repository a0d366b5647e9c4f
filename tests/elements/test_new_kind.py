"""A kind of element that is not on a coordinate: a record, a file of `elements`, a field of the model, an entry in the list.

All analyses, results and pages then know it. Tried, in a copy of the package, with drag on nodes and with the contact of a
sphere and the ground, which has events and rules of its own, and the example of CONTRIBUTING.md.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
FILES = ("record", "element")
KINDS = "from kinetruss.elements import "
IMPORT = "from kinetruss.model.drives import (\n"
OWN = Path(__file__).parent / "new_kind"
C = 1.225 * 0.5 * 0.8 / 2
FIELD = "    poses: Table[Name, Pose] = ReadOnly()\n"
ENTRY = "ON_NODES: tuple[Callable[[System], on_nodes.Part | None], ...] = ("
MODEL = """kinetruss: 1
title: A ball that falls, and a pendulum in a fluid
nodes:
  ball: {at: [0, 10, 0], mass: 2}
  A: [0, 0, 0]
  B: {at: [1, 0, 0], mass: 1}
fixed: [A]
bars:
  arm: [A, B]
  line: {ends: [B, ball], kind: free}
gravity: [0, -9.81, 0]
drags:
  air: {node: ball, area: 0.5, coefficient: 0.8}
  fluid: {node: B, area: 2 cm^2, density: 1000}
runs:
  fall: {analysis: dynamics.simulate, t_end: 2, samples: 41}
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """A copy of the package that has drags, contacts, and the magnets of CONTRIBUTING.md."""
    folder = tmp_path_factory.mktemp("new_kind")
    package = folder / "kinetruss"
    shutil.copytree(ROOT / "src" / "kinetruss", package)
    data, kinds = package / "model" / "data.py", package / "elements" / "kinds.py"
    fields, entries = data.read_text("utf-8"), kinds.read_text("utf-8")
    shown = re.findall(r"```python\n(.*?)```", (ROOT / "CONTRIBUTING.md").read_text("utf-8"), re.DOTALL)
    for kind in ("drag", "contact", "magnet"):
        name, field = kind.capitalize(), f'    {kind}s: Table[Name, {kind.capitalize()}] = ReadOnly()\n    """Trial."""\n'
        record, element = ((OWN / kind / f"{part}.py").read_text("utf-8") if kind != "magnet" else "" for part in FILES)
        if kind == "magnet":
            record, element, field = shown
        (package / "model" / f"{kind}.py").write_text(record, "utf-8")
        (package / "elements" / f"{kind}.py").write_text(element, "utf-8")
        fields = fields.replace(IMPORT, f"from kinetruss.model.{kind} import {name}\n{IMPORT}", 1)
        fields = fields.replace(FIELD, f"{field}{FIELD}", 1)
        entries = entries.replace(KINDS, f"{KINDS}{kind}, ", 1).replace(ENTRY, f"{ENTRY}{kind}.{kind}s, ", 1)
    data.write_text(fields, "utf-8")
    kinds.write_text(entries, "utf-8")
    return folder


CHILD = """
import contextlib, io, json, sys, traceback
for line in sys.stdin:
    said, wrong = io.StringIO(), ""
    try:
        with contextlib.redirect_stdout(said):
            exec(json.loads(line), {"__name__": "__main__"})
    except SystemExit as end:
        wrong = f"ended with {end.code}" if end.code else ""
    except Exception:
        wrong = traceback.format_exc()
    print(json.dumps([said.getvalue(), wrong]), flush=True)
"""


@pytest.fixture(scope="module")
def answers(package):
    """What some lines of code print in a process that has the copy."""
    environment = os.environ | {"PYTHONPATH": str(package), "NO_COLOR": "1"}
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True, "cwd": package, "env": environment}
    with subprocess.Popen([sys.executable, "-c", CHILD], **pipes) as child:

        def answer(*code):
            child.stdin.write(json.dumps("\n".join(code)) + "\n")
            child.stdin.flush()
            said, wrong = json.loads(child.stdout.readline())
            assert not wrong, wrong
            return said

        yield answer


FALL = """
import json
import numpy as np
import kinetruss as kt
from kinetruss.model.drag import Drag
ball = kt.Model(
    nodes={"ball": kt.Node(at=(0, 10, 0), mass=2.0), "A": (0, 0, 0), "B": kt.Node(at=(1, 0, 0), mass=1.0)}, fixed=["A"],
    bars={"one": kt.Bar(ends=("A", "B"), kind="free"), "two": kt.Bar(ends=("B", "ball"), kind="free")},
    gravity=(0, -9.81, 0), drags={"air": Drag(node="ball", area=0.5, coefficient=0.8)},
)
"""


@pytest.mark.parametrize(
    ("method", "within"),
    [("DOP853()", 1e-9), ("Radau()", 1e-6), ("EnergyMomentum(1e-3)", 1e-5), ("GeneralizedAlpha(1e-3)", 1e-5)],
)
def test_a_ball_falls_as_the_closed_form_says(answers, method, within):
    """v = u tanh(g t/u), u^2 = m g/c, and z = u^2/g ln cosh(g t/u)."""
    code = f"""
run = kt.dynamics.simulate(ball, t_end=2.0, samples=21, method=kt.{method})
data = run.motion.data.sel(node="ball", axis="y")
print(json.dumps([float(data.velocity[-1]), float(data.position[-1])]))
"""
    speed, place = json.loads(answers(FALL, code))
    u = np.sqrt(2.0 * 9.81 / C)
    assert speed == pytest.approx(-u * np.tanh(9.81 * 2.0 / u), rel=within)
    assert place - 10.0 == pytest.approx(-(u**2) / 9.81 * np.log(np.cosh(9.81 * 2.0 / u)), rel=within)


def test_results_have_its_columns_along_a_motion_and_at_rest(answers):
    code = """
run = kt.dynamics.simulate(ball, t_end=1.0, samples=11)
forces = kt.dynamics.inverse(ball, run.motion)
speed = run.motion.data.velocity.sel(node="ball").values
said = -1.225 * 0.5 * 0.8 / 2 * np.linalg.norm(speed, axis=1)[:, None] * speed
column = forces.data.drag_force
still = kt.runs.forces_at_rest(ball.with_(fixed=["A", "B", "ball"])).data.drag_force
print(json.dumps([list(column.dims), column.attrs, list(map(str, column["drag"].values)),
                  float(abs(column.sel(drag="air").values - said).max()), float(abs(still).max())]))
"""
    dims, attrs, names, apart, still = json.loads(answers(FALL, code))
    assert dims == ["time", "drag", "axis"]
    assert attrs == {"units": "N", "long_name": "resistance on the node"}
    assert names == ["air"]
    assert apart < 1e-12
    assert still == 0.0


BEDDED = """
import json
import numpy as np
import kinetruss as kt
from kinetruss.model.drag import Drag
steel = {"section": kt.Rod(diameter=0.02), "material": kt.Material(E=2e11, density=0.0)}
two = kt.Model(
    nodes={"A": (-1, 1), "B": (1, 1), "P": (0, 0)}, fixed=["A", "B"], bars={"a": ("A", "P"), "b": ("B", "P")}, **steel,
    loads={"W": kt.NodalForce(node="P", force=(30.0, -2000.0))}, drags={"bed": Drag(node="P", area=0.5, bedding=3e7)},
)
spring = two.with_(drags={}, springs={
    axis: kt.Spring(coordinate=kt.CoordinateDrive(node="P", axis=axis), stiffness=3e7, rest=0.0) for axis in "xy"})
"""


def test_statics_count_on_its_stiffness_as_on_that_of_springs(answers):
    code = """
one, two_ = (kt.statics.linear(model) for model in (two, spring))
three, four = (kt.statics.deflection(model, kt.runs.forces_at_rest(model)) for model in (two, spring))
print(json.dumps([one.displacement.values.tolist(), two_.displacement.values.tolist(), one.reaction.values.tolist(),
                  two_.reaction.values.tolist(), float(one.energy), float(two_.energy), float(one.work),
                  three.displacement.values.tolist(), four.displacement.values.tolist(), three.energy.values.tolist()]))
"""
    u, v, left, right, stored, same, work, bent, like, held = json.loads(answers(BEDDED, code))
    np.testing.assert_allclose(u, v, rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(left, right, rtol=1e-9, atol=1e-9)
    assert stored == pytest.approx(same, rel=1e-9)
    assert stored == pytest.approx(work, rel=1e-9)
    np.testing.assert_allclose(bent[0], like[0], rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(bent[0], u, rtol=1e-9, atol=1e-16)
    assert held[0] == pytest.approx(work, rel=1e-9)


def test_free_bodies_have_its_force(answers):
    code = """
model = ball.with_(drags={"air": Drag(node="ball", area=0.5, coefficient=0.8, bedding=7.0)})
run = kt.dynamics.simulate(model, 1.0, samples=3)
node = kt.dynamics.free_body(model, run.motion, run.forces, node="ball", time=1.0)
equations = kt.dynamics.newton_euler(model, run.motion, run.forces, time=1.0)
print(json.dumps([node.residual, equations.residual, [t.source for b in node.bodies for t in b.terms if t.symbol == "E"]]))
"""
    node, whole, sources = json.loads(answers(FALL, code))
    assert node < 1e-9
    assert whole < 1e-9
    assert sources == ["drag"]


def test_small_motions_are_damped_by_it(answers):
    """-d/dv of -c |v| v along v: 2 c |v|."""
    code = """
from kinetruss.mechanics import compile
from kinetruss.mechanics.matrices import tangents
system = compile(ball)
v = np.zeros_like(system.x0)
v[0] = 0.0, -3.0, 0.0
none = np.zeros(len(system.members))
K, C = tangents(system, system.x0, none, none, np.zeros(3), v)
print(json.dumps([C[1, 1], C[0, 0]]))
"""
    along, across = json.loads(answers(FALL, code))
    assert along == pytest.approx(2 * C * 3.0)
    assert across == pytest.approx(C * 3.0)


def test_its_table_has_derivatives_by_its_numbers(answers):
    code = """
from kinetruss.mechanics import compile
from kinetruss.mechanics.numbers import numbers_of, tables_at
system = compile(ball)
area = numbers_of(system)["drag area"]
numbers = tables_at(system, {"drag area": area + 1e-30j})["drag numbers"]
print(json.dumps(float(numbers.imag[0, 0] / 1e-30)))
"""
    assert json.loads(answers(FALL, code)) == pytest.approx(C / 0.5)


def test_power_series_are_refused_by_name(answers):
    code = """
try:
    kt.dynamics.simulate(ball, t_end=1.0, method={"kind": "taylor"})
except kt.errors.KinetrussError as why:
    print(why)
"""
    assert "the drag 'air' has a law without one" in answers(FALL, code)


def test_a_file_has_it_and_pages_show_it(package, answers):
    (package / "ball.yaml").write_text(MODEL, "utf-8")
    run = "import sys; from kinetruss.cli.start import start; sys.argv = ['kinetruss', *{!r}]; start()"
    said = answers(run.format(["run", "ball.yaml", "-o", "out"]))
    assert "Drag (largest values of the motion)" in said
    assert "resistance on the node" in said
    assert "drags: air, fluid" in answers(run.format(["info", "ball.yaml"]))


BOUNCE = """
import json
import numpy as np
import kinetruss as kt
from kinetruss.model.contact import Contact
def ball(gravity=(0, 0, 0), velocities={"ball": (0, 0, -3.0)}, **more):
    return kt.Model(
        nodes={"ball": kt.Node(at=(0, 0, 0.7), mass=2.0), "A": (-1, 0, 0), "B": (1, 0, 0)}, fixed=["A", "B"],
        bars={"one": kt.Bar(ends=("A", "ball"), kind="free"), "two": kt.Bar(ends=("B", "ball"), kind="free")},
        gravity=gravity, velocities=velocities,
        contacts={"floor": Contact(**({"node": "ball", "radius": 0.1, "stiffness": 800.0, "exponent": 1.0} | more))})
"""
TIGHT = "DOP853(rtol=1e-11, atol=1e-12)"
METHODS = [(TIGHT, 1e-8), ("Radau()", 1e-6), ("EnergyMomentum(1e-4)", 1e-5), ("GeneralizedAlpha(1e-4)", 1e-4)]


@pytest.mark.parametrize(("method", "within"), METHODS)
def test_a_linear_bounce_lasts_half_a_period_and_is_told(answers, method, within):
    code = f"""
run = kt.dynamics.simulate(ball(), 0.5, samples=3, method=kt.{method})
speeds = run.motion.velocity.sel(node="ball", axis="z").values.tolist()
print(json.dumps([[[e.name, e.time, e.direction] for e in run.events], speeds]))
"""
    ((first, begin, way), (second, end, back)), speeds = json.loads(answers(BOUNCE, code))
    assert (first, way, second, back) == ("floor.contact", -1, "floor.contact", 1)
    assert begin == pytest.approx(0.2, abs=1e-6)
    assert end - begin == pytest.approx(np.pi * np.sqrt(2.0 / 800.0), abs=10 * within)
    assert speeds[-1] == pytest.approx(3.0, rel=within)


def test_restitution_is_that_of_hunt_and_crossley_and_friction_slows(answers):
    """c (v + w) = ln((1 + c v)/(1 - c w)), whatever n; a ball that slides under its weight loses mu g t of its speed."""
    code = """
tight = kt.DOP853(rtol=1e-12, atol=1e-13)
run = kt.dynamics.simulate(ball(exponent=1.5, damping=0.3, stiffness=5e3), 0.6, samples=3, method=tight)
slide = ball(gravity=(0, 0, -9.81), velocities={"ball": (2.0, 0, 0)}, friction=0.2, slip=1e-6, radius=0.7, damping=5.0)
slid = kt.dynamics.simulate(slide, 0.9, samples=901, method=kt.Radau())
floor = slid.forces.data
print(json.dumps([float(run.motion.velocity.sel(node="ball", axis="z")[-1]),
    float(slid.motion.velocity.sel(node="ball", axis="x")[-1]), float(floor.contact_pressure.integrate("time")[0]),
    float(abs(kt.dynamics.inverse(slide, slid.motion).energy_balance).max()), float(floor.contact_gap[-1, 0]),
    floor.contact_gap.attrs, float(slid.motion.velocity.sel(node="ball", axis="z")[-1])]))
"""
    after, slid, impulse, balance, gap, attrs, falling = json.loads(answers(BOUNCE, code))
    assert 0.3 * (3.0 + after) == pytest.approx(np.log((1 + 0.3 * 3.0) / (1 - 0.3 * after)), rel=1e-7)
    assert impulse == pytest.approx(2.0 * (9.81 * 0.9 + falling), rel=1e-4)
    assert slid == pytest.approx(2.0 - 0.2 * impulse / 2.0, rel=1e-4)
    assert balance < 1e-8
    assert gap == pytest.approx(-2.0 * 9.81 / 800.0, rel=0.1)
    assert attrs == {"units": "m", "long_name": "from the sphere to the ground"}


def test_it_rests_in_equilibrium_and_small_displacements_have_its_columns(answers):
    code = """
model = ball(gravity=(0, 0, -9.81), velocities={}).with_(fixed={"A": "xyz", "B": "xyz", "ball": "xy"})
rest = kt.statics.equilibrium(model)
pushed = model.with_(loads={"W": kt.NodalForce(node="ball", force=(0, 0, -5.0))})
linear = kt.statics.linear(pushed, position=rest.data.position.values, weight=False)
found = linear.data
print(json.dumps([float(rest.data.position.sel(node="ball", axis="z")), float(rest.data.contact_pressure[0]),
    float(linear.displacement.sel(node="ball", axis="z")), float(found.contact_pressure[0]), float(found.contact_gap[0]),
    found.contact_force.values.tolist()]))
"""
    z, pressure, moved, after, gap, force = json.loads(answers(BOUNCE, code))
    sunk = 2.0 * 9.81 / 800.0
    assert z == pytest.approx(0.1 - sunk, rel=1e-9)
    assert pressure == pytest.approx(2.0 * 9.81, rel=1e-9)
    # the forces of the configuration count as loads that its elements answer: the weight is left out, so they push it back
    assert moved == pytest.approx((2.0 * 9.81 - 5.0) / 800.0, rel=1e-9)
    assert after == pytest.approx(5.0, rel=1e-9)
    assert gap == pytest.approx(-5.0 / 800.0, rel=1e-9)
    assert force[0] == pytest.approx([0.0, 0.0, 5.0], abs=1e-9)


def test_rules_of_its_own_come_before_the_run(answers):
    code = """
for bad in ({"radius": 0.9}, {"node": "bal"}, {"damping": -1.0}):
    try:
        ball(**bad)
    except kt.ModelError as why:
        print(why)
"""
    said = answers(BOUNCE, code)
    assert "contacts.floor.radius: the sphere reaches down to -0.2 m, below the ground at 0 m. Raise the node" in said
    assert "contacts.floor.node: no node called 'bal'" in said
    assert "damping -1 is negative" in said


def test_the_example_of_the_page_is_an_element(answers):
    """Two masses that attract each other: speeds from their energy, momenta kept, force C/d^4."""
    code = """
import json
import numpy as np
import kinetruss as kt
from kinetruss.model.magnet import Magnet
pair = kt.Model(
    nodes={"A": kt.Node(at=(0, 0), mass=2.0), "B": kt.Node(at=(1, 0.5), mass=1.0)},
    bars={"line": kt.Bar(ends=("A", "B"), kind="free")},
    magnets={"pair": Magnet(nodes=("A", "B"), strength=0.6)})
found = []
for method in (kt.DOP853(), kt.Radau(), kt.EnergyMomentum(1e-3)):
    run = kt.dynamics.simulate(pair, 0.8, samples=9, method=method)
    v, data = run.motion.velocity.values, run.forces.data
    d = data.magnet_distance.values[:, 0]
    balance = float(abs(kt.dynamics.inverse(pair, run.motion).energy_balance).max())
    energy = (v**2).sum(axis=2) @ [1.0, 0.5] - 0.2 / d**3 + 0.2 / 1.25**1.5
    force = np.linalg.norm(data.magnet_force.values[:, 0], axis=1) - 0.6 / d**4
    found.append([*(float(abs(one).max()) for one in (energy, np.array([2.0, 1.0]) @ v, force)), balance])
kt.io.write(pair, "pair.yaml")
assert kt.io.read("pair.yaml") == pair
print(json.dumps(found))
"""
    for (energy, momentum, force, balance), within in zip(json.loads(answers(code)), (1e-9, 1e-7, 1e-9), strict=True):
        assert energy < within
        assert momentum < 1e-10
        assert force < 1e-12
        assert balance < (1e-9 if within < 1e-7 else 1e-5)
