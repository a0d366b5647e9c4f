"""``kinetruss info`` tells every body in a line."""

import json

from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main


def test_info(tmp_path):
    ground = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    model = kt.library.bodies.box(ground, "crate", (1, 2, 3), mass=12.0, at=(0, 0, 1), nodes=["O"])
    path = str(kt.write(model, tmp_path / "m.yaml"))
    line = "body crate: mass 12 kg, centre (0, 0, 1) m, principal moments 5, 10, 13 kg m^2, rigid, nodes "
    assert line in CliRunner().invoke(main, ["info", path]).output
    told = json.loads(CliRunner().invoke(main, ["info", path, "--json"]).output)["bodies"]
    assert told[0]["name"] == "crate"
    assert 0.5 < told[0]["normalised_volume"] <= 1
