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
