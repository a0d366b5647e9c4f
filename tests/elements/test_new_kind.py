"""A kind of element that is not on a coordinate: a record, a file of `elements`, a field of the model, an entry in the list.

All analyses, results and pages then know it. Tried with drag on nodes, in a copy of the package.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
OWN = Path(__file__).parent / "new_kind"
C = 1.225 * 0.5 * 0.8 / 2
FIELD = "    poses: Table[Name, Pose] = ReadOnly()\n"
KIND = """    Element(
        drag.table,
        drag.coordinates,
        drag.KERNELS,
        drag.tangents,
        without_series=lambda system: "drag resists" if system.model.drags else None,
        loses=lambda s: True,
        results=drag.results,
        fields=drag.fields,
    ),
"""
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
    """A copy of the package that has drags."""
    folder = tmp_path_factory.mktemp("new_kind")
    package = folder / "kinetruss"
    shutil.copytree(ROOT / "src" / "kinetruss", package)
    shutil.copy(OWN / "record.py", package / "model" / "drag.py")
    shutil.copy(OWN / "element.py", package / "elements" / "drag.py")
    data, kinds = package / "model" / "data.py", package / "elements" / "kinds.py"
    text = data.read_text("utf-8").replace(
        "from kinetruss.model.drives", "from kinetruss.model.drag import Drag\nfrom kinetruss.model.drives", 1
    )
    data.write_text(
        text.replace(FIELD, f'    drags: Table[Name, Drag] = ReadOnly()\n    """Nodes that a fluid resists."""\n{FIELD}', 1),
        "utf-8",
    )
    text = kinds.read_text("utf-8").replace("import beam_kernels,", "import drag, beam_kernels,", 1)
    kinds.write_text(text.replace(')\n"""All kinds', f'{KIND})\n"""All kinds', 1), "utf-8")
    return folder


def answers(folder, *code):
    environment = os.environ | {"PYTHONPATH": str(folder), "NO_COLOR": "1"}
    found = subprocess.run(
        [sys.executable, "-c", "\n".join(code)], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert found.returncode == 0, found.stderr
    return found.stdout


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
def test_a_ball_falls_as_the_closed_form_says(package, method, within):
    """v = u tanh(g t/u), u^2 = m g/c, and z = u^2/g ln cosh(g t/u)."""
    code = f"""
run = kt.dynamics.simulate(ball, t_end=2.0, samples=21, method=kt.{method})
data = run.motion.data.sel(node="ball", axis="y")
print(json.dumps([float(data.velocity[-1]), float(data.position[-1])]))
"""
    speed, place = json.loads(answers(package, FALL, code))
    u = np.sqrt(2.0 * 9.81 / C)
    assert speed == pytest.approx(-u * np.tanh(9.81 * 2.0 / u), rel=within)
    assert place - 10.0 == pytest.approx(-(u**2) / 9.81 * np.log(np.cosh(9.81 * 2.0 / u)), rel=within)


def test_results_have_its_columns_along_a_motion_and_at_rest(package):
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
    dims, attrs, names, apart, still = json.loads(answers(package, FALL, code))
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


def test_statics_count_on_its_stiffness_as_on_that_of_springs(package):
    code = """
one, two_ = (kt.statics.linear(model) for model in (two, spring))
three, four = (kt.statics.deflection(model, kt.runs.forces_at_rest(model)) for model in (two, spring))
print(json.dumps([one.displacement.values.tolist(), two_.displacement.values.tolist(), one.reaction.values.tolist(),
                  two_.reaction.values.tolist(), float(one.energy), float(two_.energy), float(one.work),
                  three.displacement.values.tolist(), four.displacement.values.tolist(), three.energy.values.tolist()]))
"""
    u, v, left, right, stored, same, work, bent, like, held = json.loads(answers(package, BEDDED, code))
    np.testing.assert_allclose(u, v, rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(left, right, rtol=1e-9, atol=1e-9)
    assert stored == pytest.approx(same, rel=1e-9)
    assert stored == pytest.approx(work, rel=1e-9)
    np.testing.assert_allclose(bent[0], like[0], rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(bent[0], u, rtol=1e-9, atol=1e-16)
    assert held[0] == pytest.approx(work, rel=1e-9)


def test_free_bodies_have_its_force(package):
    code = """
model = ball.with_(drags={"air": Drag(node="ball", area=0.5, coefficient=0.8, bedding=7.0)})
run = kt.dynamics.simulate(model, 1.0, samples=3)
node = kt.dynamics.free_body(model, run.motion, run.forces, node="ball", time=1.0)
equations = kt.dynamics.newton_euler(model, run.motion, run.forces, time=1.0)
print(json.dumps([node.residual, equations.residual, [t.source for b in node.bodies for t in b.terms if t.symbol == "E"]]))
"""
    node, whole, sources = json.loads(answers(package, FALL, code))
    assert node < 1e-9
    assert whole < 1e-9
    assert sources == ["drag"]


def test_small_motions_are_damped_by_it(package):
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
    along, across = json.loads(answers(package, FALL, code))
    assert along == pytest.approx(2 * C * 3.0)
    assert across == pytest.approx(C * 3.0)


def test_its_table_has_derivatives_by_its_numbers(package):
    code = """
from kinetruss.mechanics import compile
from kinetruss.mechanics.numbers import numbers_of, tables_at
system = compile(ball)
area = numbers_of(system)["drag area"]
print(json.dumps(float(tables_at(system, {"drag area": area + 1e-30j})["drag c"].imag[0] / 1e-30)))
"""
    assert json.loads(answers(package, FALL, code)) == pytest.approx(C / 0.5)


def test_power_series_are_refused_by_name(package):
    code = """
try:
    kt.dynamics.simulate(ball, t_end=1.0, method={"kind": "taylor"})
except kt.errors.KinetrussError as why:
    print(why)
"""
    assert "drag resists" in answers(package, FALL, code)


def test_a_file_has_it_and_pages_show_it(package):
    (package / "ball.yaml").write_text(MODEL, "utf-8")
    run = "import sys; from kinetruss.cli.start import start; sys.argv = ['kinetruss', *{!r}]; start()"
    said = answers(package, run.format(["run", "ball.yaml", "-o", "out"]))
    assert "Drag (largest values of the motion)" in said
    assert "resistance on the node" in said
    assert "drags: air, fluid" in answers(package, run.format(["info", "ball.yaml"]))
