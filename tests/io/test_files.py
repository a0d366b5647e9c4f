"""Tables beside a model file, and node histories."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.io import read_history

MODEL = """
kinetruss: 1
nodes: {A: [0, 0], B: [1 m, 0], C: [0, 1 m]}
fixed: [A, B]
bars: {ac: {ends: [A, C], kind: driven}, bc: [B, C]}
"""


@pytest.fixture
def folder(tmp_path):
    """Write files by name, the model first."""

    def write(model, **tables):
        for name, text in tables.items():
            (tmp_path / f"{name}.csv").write_text(text)
        path = tmp_path / "model.yaml"
        path.write_text(MODEL + model)
        return path

    return write


def test_spline(folder):
    table = "# measured\nt [ms], ac [mm]\n\n0, 1000\n100,1010\n 200 ,1e3\n300,+990.5\n"
    path = folder("trajectories:\n  seen: {kind: spline, file: seen.csv, largest_gap: 3}\n", seen=table)
    assert kt.read(path).trajectories["seen"] == kt.Spline(
        times=[0, 0.1, 0.2, 0.3], values={"ac": [1.0, 1.01, 1.0, 0.9905]}, largest_gap=3
    )


def test_unit_of_a_column_is_held_against_its_coordinate(folder):
    table = "t,ac [deg]\n0,1\n1,2\n2,3\n3,4\n"
    path = folder("runs:\n  r: {trajectory: {kind: spline, file: seen.csv}}\n", seen=table)
    assert [fault.message for fault in kt.check(path)] == ["is given as an angle, but 'ac' is a length."]


def test_forces_and_supports(folder):
    path = folder(
        "loads: {tip: {node: C, file: tip.csv}}\nsupport_motion: {A: {file: quake.csv}}\n",
        tip="t,fx [kN],fy\n0,0,-5\n1,2,-5\n",
        quake="time,y [mm],x\n0,0,0\n1,2,0.5\n",
    )
    model = kt.read(path)
    assert model.loads["tip"] == kt.NodalForce(node="C", times=[0, 1], forces=[(0, -5), (2000, -5)])
    assert model.support_motion["A"] == kt.History(times=[0, 1], displacements=[(0, 0), (0.5, 0.002)])


def test_gap_may_be_meant(folder):
    table = "t,ac\n0,1\n1,1\n2,1\n3,1\n50,1\n"
    path = folder("trajectories: {seen: {kind: spline, file: seen.csv, largest_gap: 60}}\n", seen=table)
    assert kt.read(path).trajectories["seen"].duration == 50


def test_file_and_table_together(folder):
    path = folder("loads: {tip: {node: C, file: tip.csv, force: [0, 1]}}\n", tip="t,x,y\n0,0,1\n1,0,2\n")
    assert [fault.message for fault in kt.check(path)] == ["has both a force and a table of forces."]


def test_file_that_is_no_name(folder):
    path = folder("loads: {tip: {node: C, file: [a]}}\n")
    assert [str(fault) for fault in kt.check(path)] == [
        "loads.tip.file: does not name a file. Write for example file: table.csv."
    ]


def test_faults_of_a_table_are_few(folder):
    table = "t,ac\n" + "".join(f"{k},x\n" for k in range(1000))
    path = folder("trajectories: {seen: {kind: spline, file: seen.csv}}\n", seen=table)
    assert len(kt.check(path)) == 20


def test_history(tmp_path):
    path = tmp_path / "seen.csv"
    path.write_text("t,N.4.x [mm],N.4.y,B.y,B.x,N.4.vx,N.4.vy,B.vx,B.vy\n0,500,0,1,2,0,0,0,0\n0.5,510,0,1,2,0,0,3,0\n")
    seen = read_history(path)
    assert seen.nodes == ("N.4", "B")
    assert seen.times.tolist() == [0, 0.5]
    assert np.array_equal(seen.position, [[[0.5, 0], [2, 1]], [[0.51, 0], [2, 1]]])
    assert np.array_equal(seen.velocity, [[[0, 0], [0, 0]], [[0, 0], [3, 0]]])
    assert seen.acceleration is None
    assert seen.source == str(path)


@pytest.mark.parametrize(
    ("header", "options", "message"),
    [
        ("t,A.x,A.y,B.x", {}, r"1:1: model: B\.y missing"),
        ("t,A.x,A.y,A.vx", {}, r"1:1: model: A\.vy missing"),
        ("t,A.x,A.y,B.x,B.y,B.vx,B.vy", {}, r"A\.vx, A\.vy missing"),
        ("t,A.x,A.y,A.z,B.x,B.y", {}, r"B\.z missing"),
        ("t,A.x,A.y,A.z", {"dim": 2}, r"1:11: model: column 'A\.z' has an axis too many"),
        ("t,A.x,A.y", {"dim": 3}, r"A\.z missing"),
        ("t,A.x,A.y,Q.x,Q.y", {"nodes": ["A"]}, r"1:11: model: column 'Q\.x' is not known here"),
        ("t,A.x,A.y,speed", {}, r"column 'speed' is not known here"),
        ("t,A.x,A.y,A.x", {}, r"column 'A\.x' is given twice"),
        ("x,A.x,A.y", {}, r"the first column is called 'x'; expected t"),
        ("0,1,2", {}, r"Give a header such as"),
        ("t", {}, r"has no column but t"),
    ],
)
def test_history_columns(tmp_path, header, options, message):
    path = tmp_path / "seen.csv"
    row = ",".join("1" for _ in header.split(","))
    path.write_text(f"{header}\n{row.replace('1', '0', 1)}\n{row}\n")
    with pytest.raises(kt.ModelError, match=message):
        read_history(path, **options)
