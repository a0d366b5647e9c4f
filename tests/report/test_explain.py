"""Free bodies and labelled systems as pages, data and tables."""

import csv
import json

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report
from kinetruss.runs import forces_at, forces_at_peak, forces_at_rest
from samples import fourbar, tripod


@pytest.fixture(scope="module")
def legs():
    model = tripod()
    forces = forces_at(model, "lift", [0.4])
    return model, forces


def free_body(model, forces, **what):
    return kt.dynamics.free_body(model, forces.motion, forces, **what)


def column(text, symbol, head):
    """Number of the line that starts with a symbol, under the end of a heading; the first table that has it."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if head in line)
    at = lines[start].index(head) + len(head)
    line = next(line for line in lines[start:] if line.split("  ")[0].strip() == symbol)
    return float(line[:at].split()[-1])


def test_page_of_an_active_member(legs):
    model, forces = legs
    found = free_body(model, forces, member="LA")
    text = report.explain(found).text
    assert text.startswith("Free body of active member LA, A = A to B = T; t = 0.4 s, load case standing")
    for words in ("Base rod LA.base: mass 2 kg", "Tube LA.tube: mass", "tube, at the nut", "All 10 close to", "N at the nut"):
        assert words in text
    joint = forces.joint_force.sel(member="LA", end="A").values[0]
    for axis, value in zip("xyz", joint, strict=True):
        assert column(text, "F_A", f"  {axis}") == pytest.approx(value, abs=1e-4)
    assert column(text, "F_A", "along 1") == pytest.approx(-forces.end_force.sel(member="LA", end="A").item(), abs=1e-4)
    moment = forces.interface_moment.sel(active="LA", moment="moment_2").item()
    assert column(text, "M", "about 2") == pytest.approx(moment, abs=1e-4)
    assert max(map(len, text.splitlines())) < 150


def test_pages_of_a_bar_and_of_nodes():
    model = fourbar()
    forces = forces_at(model, "turn", [0.1])
    text = report.explain(free_body(model, forces, member="crank")).text
    assert "drive motor" in text
    assert "All 3 close to" in text
    page = report.explain(free_body(model, forces, node="A")).text
    assert "-F_A  crank, end A" in page
    assert "R     support" in page
    assert "about" not in page


def test_page_of_a_moving_mass(legs):
    text = report.explain(free_body(*legs, node="T")).text
    assert "mass 20 kg, acceleration (" in text
    assert column(text, "m g", "  z") == pytest.approx(-20 * 9.81)


def test_free_body_as_data_and_table(legs, tmp_path):
    model, forces = legs
    found = free_body(model, forces, member="LB")
    record = json.loads(json.dumps(report.explain(found).record, allow_nan=False))
    assert record["ends"] == ["B", "T"]
    assert record["residual"] < 1e-12 * record["largest_force"]
    for body in record["bodies"]:
        for k in range(3):
            total = sum(term["force"][k] for term in body["terms"])
            assert total == pytest.approx(body["inertia"]["force"][k], abs=1e-11)
    path = report.explain(found).write(tmp_path / "new" / "body.csv")
    rows = list(csv.DictReader(path.read_text().splitlines()))
    assert [row["symbol"] for row in rows] == ["F_A", "S", "M", "m g", "m a", "-S", "-M", "F_B", "m g", "m a"]
    assert sum(float(row["force_z [N]"]) for row in rows[:4]) == pytest.approx(float(rows[4]["force_z [N]"]))


@pytest.mark.slow
def test_small_system_is_a_matrix_large_one_is_written():
    truss = kt.library.vgt.triangular()
    forces = forces_at_rest(truss)
    system = kt.dynamics.newton_euler(truss, forces.motion, forces)
    text = report.explain(system).text
    assert "11 equations, 11 unknowns" in text
    assert "held by one member alone: O1, O2" in text
    line = next(line for line in text.splitlines() if line.startswith("follower force x"))
    assert line.split()[3:14] == ["1", ".", "1", *["."] * 8]
    bay = kt.library.vgt.double_octahedral()
    forces = forces_at_rest(bay)
    text = report.explain(kt.dynamics.newton_euler(bay, forces.motion, forces)).text
    assert "117 equations, 117 unknowns" in text
    assert "M6 force x       [M6 A x] + [M6 B x] = 0" in text
    assert "node N5 force z  " in text
    assert sum(line.startswith("117  ") for line in text.splitlines()) == 1


@pytest.mark.slow
def test_system_as_data_and_table_can_be_solved_again(tmp_path):
    model = kt.library.vgt.double_octahedral()
    forces = forces_at_rest(model)
    system = kt.dynamics.newton_euler(model, forces.motion, forces)
    rows = list(csv.reader(report.explain(system).write(tmp_path / "s.csv").read_text().splitlines()))
    matrix = np.array([row[1:-1] for row in rows[1:118]], float)
    right = np.array([row[-1] for row in rows[1:118]], float)
    assert np.linalg.solve(matrix, right) == pytest.approx(np.array(rows[119][1:-1], float), abs=1e-11)
    record = json.loads(json.dumps(report.explain(system).record, allow_nan=False))
    assert record["size"] == [117, 117]
    value = {one["name"]: one["solution"] for one in record["unknowns"]}
    for equation in record["equations"]:
        left = sum(coefficient * value[name] for name, coefficient in equation["terms"].items())
        assert left == pytest.approx(equation["right"], abs=1e-11)


def test_exactly_at_the_instant():
    """Not the nearest sample of the run; and the run's own load case where none is named."""
    model = tripod(samples=5)
    forces = forces_at(model, "lift", [0.3, 0.37])
    motion = kt.kinematics.follow(model, model.runs["lift"].trajectory, times=[0.3, 0.37])
    assert forces.motion.position.values == pytest.approx(motion.position.values, abs=1e-13)
    assert forces.load_case == "standing"
    assert forces_at(model, "lift", [0.3], load_case="pushed").load_case == "pushed"
    with pytest.raises(kt.InputError, match=r"1\.5 s is outside the run 'lift', 0 s to 1 s"):
        forces_at(model, "lift", [1.5])
    with pytest.raises(kt.InputError, match="no run called"):
        forces_at(model, "lit", [0.5])
    with pytest.raises(kt.InputError, match="No load case"):
        forces_at(model, "lift", [0.5], load_case="psuhed")


def test_at_the_peak():
    model = tripod(samples=41)
    whole = kt.run(model).forces["standing"]
    for members in ((), ("LB",)):
        found = forces_at_peak(model, None, members)
        wanted = abs(whole.member_force.sel(member=list(members) or list(model.members))).max().item()
        assert abs(found.member_force.sel(member=list(members) or list(model.members))).max().item() == pytest.approx(wanted)
        assert found.static is not None
        assert found.data.sizes["time"] == found.motion.data.sizes["time"] == 1


def test_a_table_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    model = kt.library.vgt.triangular()
    page = report.explain(free_body(model, forces_at_rest(model), member="actuator"))
    with pytest.raises(kt.StoreError, match="cannot be written"):
        page.write(tmp_path / "file" / "x.csv")
    with pytest.raises(kt.InputError, match=r"written as \.csv"):
        page.write(tmp_path / "x.xls")
