"""Drawings and curves for print: widths, letters as letters, colours of the forces, what is where."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pypdf
import pytest
from click.testing import CliRunner
from matplotlib.colors import to_hex
from PIL import Image

import kinetruss as kt
from kinetruss import io, report, viewer
from kinetruss.cli import main
from kinetruss.display import palettes as _colours
from kinetruss.errors import InputError, StoreError
from kinetruss.report.pictures.draw import draw
from kinetruss.report.pictures.specs import Histories
from kinetruss.report.plots import specification
from kinetruss.runs import run
from kinetruss.viewer.scenes import snapshots
from samples import fourbar, tripod

SVG = "{http://www.w3.org/2000/svg}"


def texts(path: Path) -> list[str]:
    return ["".join(one.itertext()).strip() for one in ET.parse(path).iter(f"{SVG}text")]


def strokes(path: Path) -> list[str]:
    """Colours of all lines of an SVG."""
    return re.findall(r"stroke: (#\w{6})", path.read_text())


def pixels(path: Path) -> tuple[np.ndarray, float]:
    with Image.open(path) as found:
        return np.asarray(found.convert("RGB")).astype(int), found.info["dpi"][0]


@pytest.mark.slow
@pytest.mark.parametrize(("width", "millimetres"), [("column", 90), ("page", 190), (60.0, 60)])
def test_it_is_as_wide_as_asked_for(turn, tmp_path, width, millimetres):
    shown, dots = pixels(report.picture(turn, tmp_path / "x.png", width=width))
    assert dots == pytest.approx(300, abs=0.1)
    assert shown.shape[1] / dots * 25.4 == pytest.approx(millimetres, abs=0.2)
    page = pypdf.PdfReader(report.picture(turn, tmp_path / "x.pdf", width=width)).pages[0]
    assert float(page.mediabox.width) / 72 * 25.4 == pytest.approx(millimetres, abs=0.2)
    assert len(np.unique(shown.reshape(-1, 3), axis=0)) > 10


@pytest.mark.slow
def test_letters_are_letters(lift, tmp_path):
    chosen = {"at": [0, 1.0], "colour": "force", "title": "Lift", "width": "page"}
    wanted = {"A", "B", "C", "T", "t = 0 s", "t = 1 s", "Lift", "Axial force (N)", "compression", "tension"}
    assert wanted <= set(texts(report.picture(lift, tmp_path / "x.svg", **chosen)))
    page = pypdf.PdfReader(report.picture(lift, tmp_path / "x.pdf", **chosen)).pages[0]
    assert "Axial force (N)" in page.extract_text()
    fonts = [one.get_object() for one in page["/Resources"]["/Font"].values()]
    assert {font["/BaseFont"].split("+")[-1] for font in fonts} == {"DejaVuSans", "DejaVuSans-Bold"}
    assert all(font["/Subtype"] in ("/Type0", "/TrueType") for font in fonts)  # outlines; journals refuse Type 3
    assert all(one.get_object()["/Subtype"] != "/Image" for one in page["/Resources"]["/XObject"].values())


@pytest.mark.slow
@pytest.mark.parametrize("frame", [0, 17, 40])
def test_colours_are_those_of_the_forces(turn, tmp_path, frame):
    force = next(iter(turn.forces.values())).member_force.values
    wanted = _colours.colours_of("diverging", force[frame], _colours.limits_of("diverging", force)) / 255
    path = report.picture(turn, tmp_path / "x.svg", at=float(turn.motion.time.values[frame]), colour="force", names=False)
    found = [np.array([int(one[k : k + 2], 16) for k in (1, 3, 5)]) / 255 for one in strokes(path)]
    for colour in wanted:
        assert min(np.abs(one - colour).max() for one in found) < 0.02, to_hex(colour)


def test_kinds_loads_ghost_and_ways_have_their_lines(lift, tmp_path):
    plain = strokes(report.picture(lift, tmp_path / "a.svg", loads=False, names=False))
    assert _colours.DRIVEN in plain  # active legs
    assert _colours.LOAD not in plain
    more = strokes(report.picture(lift, tmp_path / "b.svg", case="pushed", ghost=True, at=1.0))
    assert {_colours.LOAD, "#a8b0b9"} <= set(more)
    way = report.picture(lift, tmp_path / "c.svg", paths=["T"], case="standing")
    assert way.read_text().count("<path") > (tmp_path / "a.svg").read_text().count("<path")


@pytest.mark.slow
def test_the_same_drawing_has_the_same_bytes(turn, tmp_path):
    one, two = (report.picture(turn, tmp_path / name, at=0.1, colour="utilisation").read_bytes() for name in ("a.svg", "b.svg"))
    assert one == two


@pytest.mark.slow
@pytest.mark.parametrize("view", ["iso", "front", "side", "top"])
def test_views_show_what_lies_across_them(tmp_path, view):
    from kinetruss.report.pictures.stands import projected

    seen = projected(np.eye(3), view)
    flat = {"front": [[1, 0], [0, 0], [0, 1]], "side": [[0, 0], [1, 0], [0, 1]], "top": [[1, 0], [0, 1], [0, 0]]}
    if view in flat:
        np.testing.assert_allclose(seen, flat[view], atol=1e-12)
    assert np.linalg.norm(seen) == pytest.approx(np.sqrt(2))  # a parallel projection of an orthonormal frame
    assert report.picture(tripod(), tmp_path / "x.svg", view=view).is_file()


def test_bodies_of_the_plane_are_faces(tmp_path):
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=("A",), gravity=(0, -9.81),
        bars={"body": kt.Bar(ends=("A", "B"), body=kt.PlanarBody(mass=1.0, inertia=0.1, center=(0.5, 0.3)))},
    )  # fmt: skip
    assert "#dde3ea" in report.picture(model, tmp_path / "x.svg").read_text()


@pytest.mark.slow
def test_bodies_in_space_membranes_and_hinges_are_drawn(tmp_path):
    corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    model = kt.Model(nodes=corners, bodies={"b": kt.Body(nodes=tuple(corners), mass=2.0)})
    faces = re.findall(r'<path d="[^"]*" clip-path[^>]*fill: #dde3ea', report.picture(model, tmp_path / "x.svg").read_text())
    assert len(faces) == 4
    mesh = kt.library.meshes.rectangle(width=2.0, height=1.0, columns=2, rows=1)
    sheet = kt.Model(
        nodes=mesh.nodes, membranes={"web": mesh.membrane(thickness=0.01)}, material=kt.Material(E=1e9, density=0.0)
    )
    drawn = report.picture(sheet, tmp_path / "y.svg").read_text()
    assert drawn.count("fill: #c9d4de") == len(sheet.membranes["web"].elements)
    robot = kt.library.mechanisms.robot()
    ring = "stroke-width: 1.4"  # drawn at hinges only, where there is nothing elastic
    assert ring in report.picture(robot, tmp_path / "z.svg").read_text()
    assert ring not in report.picture(robot.with_(drives={}, runs={}), tmp_path / "w.svg").read_text()


@pytest.mark.slow
@pytest.mark.parametrize("width", ["column", 190])
def test_curves_for_print(lift, tmp_path, width):
    path = report.plot([lift], ["member_force", "drive_position"], tmp_path / "x.svg", width=width)
    words = texts(path)
    assert {"time (s)", "member force (N)", "LA", "LB", "LC"} <= set(words)
    assert sum("lift" in word or "tripod" in word for word in words) == 0  # no title: papers have captions
    millimetres = float(re.search(r'width="([\d.]+)pt"', path.read_text())[1]) / 72 * 25.4
    assert millimetres == pytest.approx(90 if width == "column" else 190, abs=0.2)


@pytest.mark.slow
def test_nothing_overlaps_in_curves_for_print(lift):
    figure = specification([lift], ["member_force", "drive_position"])
    canvas = draw(Histories(name="x", title="", time=figure.time, panels=figure.panels, width=90.0))
    canvas.draw_without_rendering()
    legend = canvas.legends[0].get_window_extent()
    label = canvas.axes[-1].xaxis.label.get_window_extent()
    assert legend.y1 <= label.y0
    whole = canvas.bbox
    for box in [legend, label, *(ax.yaxis.label.get_window_extent() for ax in canvas.axes)]:
        assert box.x0 >= 0
        assert box.y0 >= 0
        assert box.x1 <= whole.x1 + 0.5
    for ax in canvas.axes:
        assert ax.get_position().height * whole.height > 40
    # one legend for both panels: every name has one look, every look one name
    looks = {(line.get_color(), str(line.get_linestyle())) for line in canvas.legends[0].get_lines()}
    assert len(looks) == len(canvas.legends[0].get_texts())


def test_what_cannot_be_drawn_is_said(lift, tmp_path):
    for chosen, words in (
        ({"at": 2.0}, r"at=2 s: the run goes from 0 to 1 s"),
        ({"colour": "blue"}, "No colour called 'blue'"),
        ({"case": "pusht"}, "No load case called 'pusht'"),
        ({"paths": ["X"]}, "No node called 'X'"),
        ({"width": "wide"}, "No width called 'wide'"),
        ({"width": 5.0}, "30 to 1000 mm"),
        ({"view": "below"}, "No view called 'below'"),
    ):
        with pytest.raises(InputError, match=words):
            report.picture(lift, tmp_path / "x.png", **chosen)
    with pytest.raises(InputError, match=r"drawings end in \.png, \.svg, \.pdf"):
        report.picture(lift, tmp_path / "x.mp4")
    with pytest.raises(InputError, match="no forces"):
        report.picture(lift.model, tmp_path / "x.png", colour="force")
    with pytest.raises(InputError, match="no instants"):
        report.picture(lift.model, tmp_path / "x.png", at=0.0)
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match="cannot be written"):
        report.picture(lift, tmp_path / "file" / "x.png")


@pytest.mark.slow
def test_the_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    io.write(fourbar(), "model.yaml")
    run(fourbar(), "turn", tmp_path / "out")

    def call(text: str):
        return CliRunner().invoke(main, text.split())

    assert call("picture model.yaml -o a.pdf --width 90mm").stdout == "a.pdf\n"
    done = call("picture out -o b.svg --at 0s --at 100ms --colour force --ghost --path B --no-names --width page --json")
    assert done.exit_code == 0, done.output
    assert {"t = 0 s", "Axial force (N)"} <= set(texts(Path("b.svg")))
    assert "A" not in texts(Path("b.svg"))
    assert call("plot out --quantity member_force --width column -o c.pdf").exit_code == 0
    faults = {"picture out -o x.pdf --at 3kg": "not a time", "picture out -o x.pdf --width 3": "30 to 1000",
              "picture out -o x.gif": "kinetruss render", "plot out --width thin -o x.pdf": "No width"}  # fmt: skip
    for text, words in faults.items():
        done = call(text)
        assert done.exit_code == 2, text
        assert words in done.stderr


def test_the_page_and_the_drawing_say_the_same_of_strength(lift):
    scene = viewer.scene(lift, case="pushed")
    samples = range(len(scene.arrays["time"]))
    for colour, array in (("force", "member_force"), ("stress", "stress"), ("utilisation", "utilisation")):
        drawn = snapshots(lift, case="pushed", samples=samples, colour=colour)
        assert np.array_equal(drawn.arrays[array], scene.arrays[array], equal_nan=True)


@pytest.mark.slow
@pytest.mark.parametrize("width", ["page", "column", 120.0])
def test_a_tall_figure_stays_on_the_sheet(tmp_path, width):
    nodes = {"A": (0, 0), "B": (0.2, 0)} | {f"T{k}": (0.1, 0.5 * k) for k in range(1, 9)}
    bars = {"a": ("A", "T1"), "b": ("B", "T1")} | {f"c{k}": (f"T{k}", f"T{k + 1}") for k in range(1, 8)}
    path = report.picture(kt.Model(nodes=nodes, fixed=("A", "B"), bars=bars), tmp_path / "tall.png", width=width, title="tall")
    size, dots = pixels(path)
    high, wide = (25.4 * one / dots for one in size.shape[:2])
    assert wide <= 190.5
    assert high <= 1.4 * 190 + 0.5 < 297 - 2 * 10


@pytest.mark.slow
def test_results_are_drawn_with_their_model(lift, tmp_path):
    forces, model = lift.forces["pushed"], lift.model
    drawn = report.picture(lift, tmp_path / "run.svg", colour="force", case="pushed", at=0.5).read_text()
    assert report.picture(forces, tmp_path / "f.svg", model=model, colour="force", at=0.5).read_text() == drawn
    assert report.picture(lift.motion, tmp_path / "m.svg", model=model, at=[0, 1]).is_file()
    held = kt.statics.equilibrium(model)
    assert "compression" in report.picture(held, tmp_path / "e.svg", model=model, colour="force").read_text()
    with pytest.raises(InputError, match="Give its model too"):
        report.picture(held, tmp_path / "e.svg")
    with pytest.raises(InputError, match="cannot be drawn"):
        report.picture(lift.verdict, tmp_path / "e.svg", model=model)
    with pytest.raises(InputError, match="no utilisation of a state at rest"):
        report.picture(held, tmp_path / "e.svg", model=model, colour="utilisation")


@pytest.mark.slow
def test_forces_that_are_not_unique_are_marked(tmp_path):
    """A braced square: the six bars share what five could carry."""
    corners = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    bars = {a + b: (a, b) for a, b in ("AB", "BC", "CD", "DA", "AC", "BD")}
    loads = {"pull": kt.NodalForce(node="C", force=(100.0, 0))}
    model = kt.Model(nodes=corners, fixed={"A": "xy", "B": "y"}, bars=bars, loads=loads)
    forces = kt.statics.at_poses(model, [{}])
    assert set(forces.data.attrs["not_unique"]) == set(bars)
    assert "broken: not unique" in report.picture(forces, tmp_path / "a.svg", model=model, colour="force").read_text()
    assert "not unique" not in report.picture(forces, tmp_path / "b.svg", model=model).read_text()
