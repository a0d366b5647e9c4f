"""Tables as spreadsheets write them: semicolons and decimal commas, supports in some axes."""

from __future__ import annotations

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main

NODES = "node,x [m],y [m]\nA,0,0\nB,1.5,2\nC,3,0\n"
MEMBERS = "member,from,to,kind\nleft,A,B,\nright,B,C,\nlow,A,C,driven\n"


def _written(folder, name, text):
    (folder / name).write_text(text, "utf-8-sig")  # as a spreadsheet does
    return folder / name


@pytest.mark.parametrize("separator", [";", "\t"])
def test_semicolons_and_decimal_commas_say_the_same(tmp_path, separator):
    plain = kt.exchange.read(
        _written(tmp_path, "n.csv", NODES), members=_written(tmp_path, "m.csv", MEMBERS), fixed=["A", "C:y"]
    )
    nodes, members = (text.replace(",", separator).replace("1.5", "1,5") for text in (NODES, MEMBERS))
    other = kt.exchange.read(
        _written(tmp_path, "o.csv", nodes), members=_written(tmp_path, "p.csv", members), fixed=["A", "C:y"]
    )
    assert other.model == plain.model
    assert dict(plain.model.fixed) == {"A": "xy", "C": "y"}
    assert plain.model.nodes["B"].at == (1.5, 2.0)


def test_a_support_in_some_axes_on_the_command_line(tmp_path):
    nodes, members = _written(tmp_path, "n.csv", NODES), _written(tmp_path, "m.csv", MEMBERS)
    out = tmp_path / "roof.yaml"
    command = ["import", str(nodes), "--members", str(members), "-o", str(out)]
    done = CliRunner().invoke(main, [*command, "--fixed", "C:q"])
    assert done.exit_code == 2 and "no node called 'C:q' to fix. Did you mean 'C'?" in done.stderr
    assert CliRunner().invoke(main, [*command, "--fixed", "A", "--fixed", "C:y"]).exit_code == 0
    assert dict(kt.read(out).fixed) == {"A": "xy", "C": "y"}


@pytest.mark.parametrize(("text", "fault"), [
    ("node,x [m],y [m]\nA," + "9" * 200_000 + ",0\n", r"n.csv:2:1: .*a cell has more than 131,072 characters"),
    ("node,x [m],y [m]\nA,0,0\n" + "B" * 200_000 + ",0,0\n", r"n.csv:3:1: .*a cell has more than 131,072 characters"),
    ("node,x [m],y [m]," + "z" * 200_000 + "\nA,0,0,0\n", r"n.csv:1:1: .*a cell has more than 131,072 characters"),
    ("node,x [m],y [m]\n\"A,0,0\n" + "B,1,0\n" * 40_000, r"n.csv:2:1: .*close the quote that opens in it"),
    ("node,x [m],y [m]\n# one, \"two\n\nA,0,0\n\"B,1,0\nC,3,0\n", r"n.csv:5:1: .*A quote that opens here"),
    ("node,x [m],y [m]\nA,0\0,0\n", r"n.csv:2:1: .*is not a number, in column 'x'"),
    ("node,x [m],y [m],face.base\nA,0,0,\u00b2\n", r"n.csv:2:1: .*no free number of a corner"),
    ("node,x [m],y [m],face.base\nA,0,0," + "9" * 5000 + "\n", r"n.csv:2:1: .*no free number of a corner"),
], ids=range(8))  # fmt: skip
def test_any_cell_is_read_or_a_fault_with_its_line(tmp_path, text, fault):
    with pytest.raises(kt.ModelError, match=fault):
        kt.exchange.read(_written(tmp_path, "n.csv", text), members=_written(tmp_path, "m.csv", MEMBERS))


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_quoted_cells_and_comments(tmp_path, end):
    nodes = 'node,"x [m]",y [m]\n# a comment, "with a quote\nA,"0",0\n\n"B",1.5,"2"\nC,3,0\n'.replace("\n", end)
    (tmp_path / "n.csv").write_bytes(nodes.encode("utf-8-sig"))
    model = kt.exchange.read(tmp_path / "n.csv", members=_written(tmp_path, "m.csv", MEMBERS)).model
    assert [node.at for node in model.nodes.values()] == [(0, 0), (1.5, 2), (3, 0)]
