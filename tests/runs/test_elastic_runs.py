"""Runs of elastic members along a motion: the numbers of the calls themselves, stored, read again, reported, drawn."""

from __future__ import annotations

import json

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main

SLEW = kt.Quintic(moves={"bay.beta": (0.0, 0.1)}, duration=0.5)
OPTIONS = {
    "corrected": kt.Elastic(at=("N7.z", "N8.z", "N9.z"), stiffness={"M7": 2e6}),
    "frequencies": kt.Elastic(modes=3, rigid=("M1",)),
    "vibration": kt.Elastic(damping=0.02, rest=0.05),
}


@pytest.fixture(scope="module")
def model():
    bay = kt.library.vgt.double_octahedral(gravity=(0, 0, -9.81), payload_mass=5.0)
    runs = {
        name: kt.Run(analysis=f"flexible.{name}", trajectory=SLEW, samples=13, elastic=one) for name, one in OPTIONS.items()
    }
    return bay.with_(runs=runs)


@pytest.fixture(scope="module")
def file(model, tmp_path_factory):
    path = tmp_path_factory.mktemp("elastic") / "bay.yaml"
    kt.write(model, path)
    return path


def told(*arguments):
    result = CliRunner().invoke(main, list(map(str, arguments)), catch_exceptions=False)
    assert result.exit_code == 0, result.output
    return result.output


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "names"),
    [
        ("corrected", ("drive_length", "change", "displacement", "error")),
        ("frequencies", ("frequency", "mac", "actuator_share")),
        ("vibration", ("displacement", "settled", "difference")),
    ],
)
@pytest.mark.usefixtures("undrawn")
def test_a_run_from_a_file_is_the_call_itself(model, file, tmp_path, name, names):
    out = tmp_path / name
    told("run", file, name, "-o", out)
    stored = kt.runs.load(out)
    motion = kt.kinematics.follow(model, SLEW, samples=13)
    forces = kt.dynamics.inverse(model, motion)
    alone = getattr(kt.flexible, name)(model, forces, **OPTIONS[name].arguments(f"flexible.{name}"))
    found = stored.statics["all"]
    for one in names:
        wanted = alone.data[one].values[:13]
        assert found.data[one].values == pytest.approx(wanted, rel=1e-9, abs=1e-12 * np.abs(wanted).max()), one
    assert stored.whole and stored.forces["all"].member_force.values == pytest.approx(forces.member_force.values, rel=1e-12)
    assert stored.verdict is not None
    record = json.loads(told("info", out, "--json"))["statics"]["cases"]["all"]
    if name == "corrected":
        drive = record["change"]
        assert drive["value"] == pytest.approx(float(alone.change.sel(drive=drive["of"], time=drive["time"])), rel=1e-9)
        assert abs(drive["value"]) == pytest.approx(float(np.abs(alone.change.values).max()), rel=1e-9)
    elif name == "frequencies":
        assert record["frequencies"][0]["least"] == pytest.approx(float(alone.frequency.values[:, 0].min()), rel=1e-12)
        assert len(record["frequencies"]) == 3
    else:
        assert record["overshoot"] == pytest.approx(alone.attrs["overshoot"], rel=1e-9)
        assert record["residual"] == pytest.approx(alone.attrs["residual"], rel=1e-9)
    page = told("info", out)
    assert {"corrected": "change of length", "frequencies": "Hz", "vibration": "overshoot"}[name] in page
    picture = tmp_path / "one.svg"
    told("plot", out, "--quantity", names[0], "-o", picture)
    assert picture.stat().st_size > 1000
    told("report", out, "-o", tmp_path / "page")
    assert f"flexible.{name}" in (tmp_path / "page" / "report.html").read_text()


@pytest.mark.slow
def test_a_run_of_blocks_is_whole(model):
    """Modes are followed from sample to sample: the block does not matter."""
    cut, whole = (kt.run(model, "frequencies", block=block) for block in (7, None))
    assert np.array_equal(cut.statics["all"].frequency.values, whole.statics["all"].frequency.values)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"analysis": "flexible.corrected", "trajectory": SLEW}, "elastic.at"),
        ({"analysis": "flexible.frequencies", "trajectory": SLEW, "elastic": {"damping": 0.1}}, "flexible.vibration"),
        ({"analysis": "dynamics.inverse", "trajectory": SLEW, "elastic": {"modes": 2}}, "has elastic, which dynamics.inverse"),
        ({"analysis": "flexible.vibration"}, "neither trajectory nor motion"),
    ],
)
def test_options_that_do_not_fit_are_refused(fields, words):
    with pytest.raises(kt.ModelError, match=words):
        kt.Run(**fields)


def test_unknown_members_and_drives_are_found_by_the_check(model):
    elastic = kt.Elastic(at=("N8.z",), drives=("M77",), stiffness={"M8x": 1e6}, rigid=("M99",))
    with pytest.raises(kt.ModelError) as error:
        model.with_(runs={"one": kt.Run(analysis="flexible.corrected", trajectory=SLEW, elastic=elastic)})
    assert all(name in str(error.value) for name in ("M77", "M8x", "M99"))


def test_an_unknown_coordinate_is_refused_before_the_folder_is_made(model, tmp_path):
    run = model.runs["corrected"].with_(elastic=kt.Elastic(at=("N88.z",)))
    with pytest.raises(kt.InputError, match="N88"):
        kt.run(model.with_(runs={"one": run}), out=tmp_path / "out")
    assert not (tmp_path / "out").exists()
