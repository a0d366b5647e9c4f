"""Section forces over the structure in pictures and reports: their words and values."""

import re

import pytest
from click.testing import CliRunner

import kinetruss as kt
import loaded_frames as frames
from kinetruss import io, report
from kinetruss.cli import main
from kinetruss.errors import InputError
from kinetruss.report.pictures.over_structure import of_run
from kinetruss.runs import run


def words(path) -> str:
    text = path.read_text(encoding="utf-8")
    return " ".join(re.findall(r"<text[^>]*>([^<]*)<", text)).replace("\u2212", "-")


@pytest.fixture(scope="module")
def portal():
    return run(frames.portal(), "rest")


def test_a_picture_writes_w_l_squared_over_8_and_names_the_sign(tmp_path):
    path = report.picture(run(frames.simple(), "rest"), tmp_path / "M.svg", show="M")
    assert "20 kN m" in words(path)  # 10 kN/m (4 m)^2/8
    assert "drawn on the side in tension" in words(path)
    assert "2.381 mm" in words(report.picture(run(frames.simple(), "rest"), tmp_path / "w.svg", show="deflection"))
    assert "drawn 200 times" in words(tmp_path / "w.svg")
    assert "zero everywhere" in words(report.picture(run(frames.simple(), "rest"), tmp_path / "N.svg", show="N"))


def test_what_has_no_section_forces_is_refused(tmp_path):
    with pytest.raises(InputError, match="M cannot be drawn of a Model"):
        report.picture(frames.simple(), tmp_path / "M.svg", show="M")


@pytest.mark.slow
def test_the_command_line_draws_a_load_case(tmp_path, portal):
    io.write(portal.model, tmp_path / "m.yaml")
    made = CliRunner().invoke(main, ["run", str(tmp_path / "m.yaml"), "rest", "-o", str(tmp_path / "out")])
    assert made.exit_code == 0, made.output
    path = tmp_path / "V.svg"
    drawn = CliRunner().invoke(main, ["picture", str(tmp_path / "out"), "-o", str(path), "--show", "V", "--case", "wind"])
    assert drawn.exit_code == 0, drawn.output
    found = of_run(portal, "V", "wind")
    assert found.largest != pytest.approx(of_run(portal, "V", "snow").largest)
    assert f"{found.largest / 1e3:.4g} kN" in words(path)


@pytest.mark.slow
def test_a_report_has_the_governing_case_over_the_structure(portal):
    html = report.document_page(portal).html
    case = portal.finding.governing.load_case
    figure = re.search(r"<figure(?:(?!</figure>).)*Section forces over the structure.*?</figure>", html, re.DOTALL)[0]
    text = figure.replace("\u2212", "-").replace("\u00a0", " ").replace("\u202f", " ")
    assert f"load case {case}" in text
    for show, unit in (("N", "kN"), ("V", "kN"), ("M", "kN m")):
        found = of_run(portal, show, case)
        one = max((one for one in found.curves if one.extremes), key=lambda one: abs(one.values[list(one.extremes)]).max())
        value = max((one.values[k] for k in one.extremes), key=abs) / 1e3
        assert f"{value:.4g} {unit}" in text


def test_an_equilibrium_has_the_deflection_of_small_displacements_where_they_are_small():
    here = {"rest": kt.Run(analysis="statics.equilibrium")}
    bent = of_run(run(frames.simple(runs=here), "rest"), "deflection")
    assert bent.largest == pytest.approx(of_run(run(frames.simple(), "rest"), "deflection").largest, rel=1e-4)
    (one,) = bent.curves
    assert one.base[:, 1] == pytest.approx(0.0, abs=1e-12)  # drawn from the beam without loads
