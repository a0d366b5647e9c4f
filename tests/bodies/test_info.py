"""``kinetruss info`` tells every body in a line."""

import json
import re
from itertools import pairwise

from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main


def test_info(tmp_path):
    ground = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    model = kt.library.bodies.box(ground, "crate", (1, 2, 3), mass=12.0, at=(0, 0, 1), nodes=["O"])
    path = str(kt.write(model, tmp_path / "m.yaml"))
    text = CliRunner().invoke(main, ["info", path]).output
    head, row = next(pair for pair in pairwise(text.splitlines()) if pair[1].startswith("crate  "))
    heads = ["body", "kind", "nodes", "mass", "centre (m)", "principal moments (kg m²)", "normalised volume"]
    assert re.split(" {2,}", head) == heads
    cells = dict(zip(heads, re.split(" {2,}", row), strict=True))
    assert (cells["kind"], cells["mass"], cells["centre (m)"]) == ("rigid", "12 kg", "0, 0, 1")
    assert cells["principal moments (kg m²)"] == "5, 10, 13"
    told = json.loads(CliRunner().invoke(main, ["info", path, "--json"]).output)["bodies"]
    assert told[0]["name"] == "crate"
    assert 0.5 < told[0]["normalised_volume"] <= 1
