"""Studies of which each variant is an optimum."""

import re
import sqlite3
from contextlib import closing

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.errors import InputError, ModelError

FORCE, LENGTH = 7e3, 2.0
TASK = """\
kinetruss_optimum: 1
model: rod.yaml
arguments: {weight: false}
variables:
  area: {of: section.area, between: [10 mm^2, 10 cm^2]}
limits:
  stress: {of: axial_stress, at_most: 100 MPa}
  stretch: {of: "displacement[B, x]", at_most: 10 mm}
"""
STUDY = """\
kinetruss_study: 1
model: rod.yaml
optimum: rod.optimum.yaml
variables:
  stress: {paths: [optimum.limits.stress.at_most], values: [50 MPa, 100 MPa, 1 MPa]}
  force: {paths: [loads.pull.force.0], values: [7 kN, 14 kN]}
"""


@pytest.fixture
def folder(tmp_path):
    rod = kt.Model(
        nodes={"A": (0, 0), "B": (LENGTH, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
        section=kt.General(area=2e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), material="steel_s235",
        loads={"pull": kt.NodalForce(node="B", force=(FORCE, 0))},
    )  # fmt: skip
    kt.write(rod, tmp_path / "rod.yaml")
    (tmp_path / "rod.optimum.yaml").write_text(TASK)
    (tmp_path / "rod.study.yaml").write_text(STUDY)
    return tmp_path


def test_the_least_mass_over_a_limit_and_a_load(folder):
    """A = F/sigma, m = rho L F/sigma, and the price of the stress is m/sigma; 1 MPa needs more than the largest area."""
    found = kt.studies.run_study(folder / "rod.study.yaml", folder / "out", workers=0)
    sigma, force = 1e6 * found.data["stress"].values, 1e3 * found.data["force"].values
    assert found.status.tolist() == ["COMPLETED"] * 4 + ["INFEASIBLE"] * 2
    assert found.failures == {"INFEASIBLE": 2}
    mass = kt.library.materials.MATERIALS["steel_s235"].density * LENGTH * force / sigma
    np.testing.assert_allclose(found.data["objective"].values[:4], mass[:4], rtol=1e-7)
    np.testing.assert_allclose(found.data["area"].values[:4], (force / sigma)[:4], rtol=1e-7)
    np.testing.assert_allclose(found.data["price_stress"].values[:4], (mass / sigma)[:4], rtol=1e-5)
    assert found.data["price_stretch"].values[:4].tolist() == [0] * 4
    assert found.data["certified"].values[:4].tolist() == [1] * 4
    assert {name: found.data[name].attrs["units"] for name in ("objective", "price_stress")} == {
        "objective": "kg", "price_stress": "kg/Pa"
    }  # fmt: skip
    assert "stress of b at most 1 MPa cannot be kept" in str(found.data["message"].values[4])
    text = kt.report.study(found).text
    assert text.startswith("6 variants of an optimum: 4 have numbers. 2 infeasible.")
    assert "decided by" in text


def test_what_is_not_certified_does_not_count(folder):
    """A search that may not go on: its numbers are kept, and are in no distribution. A step of Newton's method towards the root
    of a convex function, from above, ends above it: the limit is kept, and not reached.
    """
    limits = TASK[TASK.index("limits:") :]
    other = 'limits: {square: {of: "(100e6/axial_stress)**2", at_least: 1}}\niterations: 1\n'
    (folder / "rod.optimum.yaml").write_text(TASK.replace(limits, other))
    (folder / "rod.study.yaml").write_text(re.sub(r"  stress: .*\n", "", STUDY))
    found = kt.studies.run_study(folder / "rod.study.yaml", workers=0)
    assert "UNCERTIFIED" in found.status
    k = found.status.tolist().index("UNCERTIFIED")
    assert found.data["certified"].values[k] == 0
    assert found.data["objective"].values[k] > 0
    assert not found.good[k]
    assert "No optimum is certified" in str(found.data["message"].values[k])


def test_only_what_is_missing_is_computed_again(folder):
    """And limits that no design keeps are a result: the command ends well."""
    first = kt.studies.run_study(folder / "rod.study.yaml", folder / "out", workers=0)
    with closing(sqlite3.connect(folder / "out" / "study.sqlite")) as ledger:
        ledger.execute("update rows set status = null, numbers = null where row = 2")
        ledger.commit()
    done = CliRunner().invoke(main, ["study", str(folder / "rod.study.yaml"), "-o", str(folder / "out"), "--workers", "1"])
    assert done.exit_code == 0, done.output
    again = kt.studies.load_study(folder / "out")
    np.testing.assert_array_equal(again.data["objective"].values, first.data["objective"].values)
    same = again.data["seconds"].values == first.data["seconds"].values
    assert same.tolist() == [True, True, False, True, True, True]
    (folder / "rod.optimum.yaml").write_text(TASK.replace("100 MPa", "90 MPa"))
    with pytest.raises(InputError, match="another study, with other optimum"):
        kt.studies.run_study(folder / "rod.study.yaml", folder / "out", workers=0)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("limits.stress.at_most", "limits.stres.at_most", "'stres' is not in the task of the optimum. Did you mean 'stress'"),
        ("50 MPa, 100 MPa, 1 MPa", "50 mm, 100 mm, 1 mm", "is in m, but axial_stress in Pa"),
        ("optimum: rod", "run: turn\noptimum: rod", "has a run and an optimum"),
        ("variables:\n", "results: {m: mas}\nvariables:\n", "results.m: 'mas' is not known of an optimum"),
    ],
)
def test_faults_are_told(folder, old, new, said):
    (folder / "rod.study.yaml").write_text(STUDY.replace(old, new))
    with pytest.raises((InputError, ModelError)) as error:
        found = kt.studies.run_study(folder / "rod.study.yaml", workers=0)
        raise InputError(str(found.data["message"].values))  # a fault of every variant is told by each
    assert said in str(error.value)
