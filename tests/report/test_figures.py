"""Pictures: what they show is tested on their specifications, that they are drawn on the files."""

import itertools
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from kinetruss import report
from kinetruss.display import COLOURS
from kinetruss.errors import InputError, StoreError
from kinetruss.report.pictures.specs import Bars, Drawing, Histories, pen
from kinetruss.report.pictures.stands import projected
from kinetruss.report.plots import specification
from kinetruss.report.run_figures import specifications
from kinetruss.runs import run
from samples import tripod


@pytest.mark.slow
def test_all_pictures_are_drawn(lift, tmp_path):
    written = report.figures(lift, tmp_path / "new" / "pictures")
    names = {path.name for path in written}
    assert {"shape.png", "shape.svg", "lengths.png", "forces_pushed.svg", "utilisation.png", "stresses.png",
            "motors_standing.png"} <= names  # fmt: skip
    for path in written:
        if path.suffix == ".png":
            assert path.read_bytes().startswith(b"\x89PNG")
        else:
            assert ET.parse(path).getroot().tag.endswith("svg")


@pytest.mark.slow
def test_the_same_run_gives_the_same_bytes(turn, tmp_path):
    one, two = (report.figures(turn, tmp_path / name, formats=["svg"]) for name in "ab")
    assert [path.read_bytes() for path in one] == [path.read_bytes() for path in two]


def test_every_axis_has_its_unit(lift):
    for figure in specifications(lift):
        if isinstance(figure, Histories):
            assert all(panel.unit for panel in figure.panels)
        elif isinstance(figure, Bars):
            assert figure.unit


def test_the_band_holds_every_curve(lift):
    (panel,) = next(figure for figure in specifications(lift) if figure.name == "forces_pushed").panels
    low, high = panel.band
    for values in panel.lines.values():
        assert np.all((low <= values) & (values <= high))
    assert panel.dashed.keys() == panel.lines.keys()


def test_motors_show_their_limit(lift):
    figure = next(figure for figure in specifications(lift) if figure.name == "motors_pushed")
    limits = {panel.quantity: panel.limit for panel in figure.panels}
    assert limits == {"thrust": None, "motor torque": None, "current": 10.0, "voltage": 25.0}


def test_the_shape_of_a_full_turn_is_shown_at_the_start_and_at_the_extremes(turn):
    shape = next(figure for figure in specifications(turn) if isinstance(figure, Drawing))
    assert len(shape.stands) == 3
    assert tuple(kind == "driven" for kind in shape.kinds) == (True, False, False)
    first, *others = (stand.dots for stand in shape.stands)
    every = turn.motion.position.values
    np.testing.assert_array_equal(first, every[0])
    reach = np.abs(every - first).max()
    assert all(np.abs(other - first).max() > 0.25 * reach for other in others)
    assert np.abs(others[0] - others[1]).max() > 0.25 * reach
    # one of them has the rocker near an end of its sweep
    joint = every[:, 2, 0]
    ends = [min(abs(other[2, 0] - joint.min()), abs(other[2, 0] - joint.max())) for other in others]
    assert min(ends) < 0.05 * np.ptp(joint)


def test_space_is_seen_without_distortion_along_the_vertical():
    up = projected(np.array([[0, 0, 0], [0, 0, 1.0]]))
    assert up[1, 0] == pytest.approx(0)
    assert 0.9 < up[1, 1] <= 1


def test_no_two_curves_look_the_same():
    pens = [tuple(map(str, pen(k).values())) for k in range(21)]
    assert len(set(pens)) == 21


@pytest.mark.parametrize("lost", ["protan", "deutan", "tritan"])
def test_colours_stay_apart_for_colour_blind_readers(lost):
    """Simulation of full dichromacy after Machado, Oliveira & Fernandes (2009), table 1, on linear RGB."""
    seen = {
        "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        "tritan": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    }[lost]
    shown = [np.clip(np.array(seen) @ np.array(to_rgb(colour)) ** 2.2, 0, 1) ** (1 / 2.2) for colour in COLOURS]
    assert min(np.linalg.norm(a - b) for a, b in itertools.combinations(shown, 2)) > 0.1


def test_one_quantity_of_several_runs(lift, tmp_path):
    other = run(tripod(21))
    figure = specification([lift, other], "member_force", ["LA"], "pushed")
    assert list(figure.panels[0].lines) == ["samples 41", "samples 21"]
    assert len(figure.panels[0].times["samples 21"]) == 21
    assert figure.panels[0].dashed.keys() == figure.panels[0].lines.keys()
    path = report.plot([lift], "position", tmp_path / "deep" / "p.svg", members=["T"])
    assert path.exists()


@pytest.mark.parametrize(
    ("quantity", "file", "members", "message"),
    [
        ("forces", "a.png", (), "no quantity called 'forces'. Did you mean 'force'"),
        ("member_force", "a.jpeg", (), "pictures end in .png, .svg, .pdf"),
        ("member_force", "a.png", ("LX",), "'LX' is not in member_force. Did you mean 'L"),
    ],
)
def test_what_cannot_be_drawn_is_said(lift, tmp_path, quantity, file, members, message):
    with pytest.raises(InputError, match=message):
        report.plot([lift], quantity, tmp_path / file, members=members)


def test_a_folder_that_cannot_be_written_is_said(turn, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match="cannot be written"):
        report.figures(turn, tmp_path / "file" / "pictures")
