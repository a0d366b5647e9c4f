"""The report of an optimum: what it says is the result's, and nothing else than an optimum is called one."""

import json
import re
from dataclasses import replace

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.design.optimum_folder import STATE

FORCE, LENGTH, STRESS = 7e3, 2.0, 100e6
LIMITS = {
    "stress": {"of": "axial_stress", "at_most": "100 MPa"},
    "stretch": {"of": "displacement[B, x]", "at_most": "10 mm"},
}


def rod():
    return kt.Model(
        title="Rod", nodes={"A": (0, 0), "B": (LENGTH, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
        section=kt.General(area=2e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01), material="steel_s235",
        loads={"pull": kt.NodalForce(node="B", force=(FORCE, 0))},
    )  # fmt: skip


def search(folder, limits=LIMITS, most="10 cm^2"):
    return kt.design.optimise(
        rod(), {"area": {"of": "section.area", "between": ("10 mm^2", most)}}, "mass", limits, arguments={"weight": False},
        out=folder,
    )  # fmt: skip


def told(folder):
    """Lines and page of the command."""
    done = CliRunner().invoke(main, ["report", str(folder), "--no-open", "--no-pdf", "-o", str(folder / "report")])
    assert done.exit_code == 0, done.output
    page = (folder / "report" / "report.html").read_text("utf-8")
    data = json.loads(re.search(r'id="kinetruss-report">(.*?)</script>', page, re.DOTALL)[1])
    assert data["result"] == done.stdout.splitlines()[: len(data["result"])]
    return page, data, done.stderr


def test_what_it_says_is_the_result(tmp_path):
    """A = F/sigma; the price of the stress is m/sigma, and the rod stretches by sigma L/E."""
    found = search(tmp_path / "out")
    page, data, lacking = told(tmp_path / "out")
    assert lacking == ""
    assert data["found"]["objective"] == found.objective
    assert data["found"]["values"]["area"] == pytest.approx(FORCE / STRESS, rel=1e-8)
    assert data["result"][0].endswith("at the optimum.")
    assert [len(re.findall(f'<section id="{key}"', page)) for key in ("question", "design", "certificate", "history")] == [
        1
    ] * 4
    (price,) = (one["price"] for one in data["found"]["active"])
    assert price == pytest.approx(found.objective / STRESS, rel=1e-6)
    used = {one.name: one for one in found.limits}
    E = kt.library.materials.MATERIALS["steel_s235"].E
    assert used["stretch"].value == pytest.approx(STRESS * LENGTH / E, rel=1e-8)
    assert used["stretch"].before == pytest.approx(FORCE * LENGTH / (E * 2e-4), rel=1e-12)
    assert used["stretch"].left == pytest.approx(1 - used["stretch"].value / 0.01, rel=1e-9)
    assert used["stress"].left == pytest.approx(0, abs=1e-7)
    assert "This is no optimum" not in page
    assert str(tmp_path) not in page
    assert not re.search(r'(src|href)="https?:', page)


@pytest.mark.parametrize("state", ["searching", "interrupted"])
def test_a_search_that_has_not_ended_is_no_optimum(tmp_path, state):
    found = search(tmp_path / "out")
    file = tmp_path / "out" / STATE
    record = json.loads(file.read_text("utf-8"))
    record["state"] = state
    if state == "searching":  # as a killed process leaves it
        del record["result"]
    else:
        record["result"] = json.loads(json.dumps(replace(found, state=state).record))
    file.write_text(json.dumps(record), encoding="utf-8")
    page, data, lacking = told(tmp_path / "out")
    assert "The report says so" in lacking
    assert "This is no optimum." in page
    assert not re.search("at the optimum|local optimum", " ".join(data["result"]))
    assert ("goes on" in data["result"][0]) == (state == "searching")
    assert "saved</th>" not in page  # no prices


def test_limits_that_exclude_each_other_are_named(tmp_path):
    with pytest.raises(kt.errors.InfeasibleError) as error:
        search(tmp_path / "out", most="50 mm^2")
    assert kt.design.load_optimum(tmp_path / "out").state == "infeasible"
    page, data, lacking = told(tmp_path / "out")
    assert data["result"] == ["There is no optimum: the limits cannot be kept together.", str(error.value)]
    assert "stress of b at most 100 MPa cannot be kept" in data["message"]
    assert "This is no optimum." in page
    assert lacking.startswith("There is no optimum.")


def test_another_folder_is_refused(tmp_path):
    with pytest.raises(kt.errors.StoreError, match="holds no optimum that can be read"):
        kt.design.load_optimum(tmp_path)
