"""Pictures and films: size, what is seen where, in which colours, at which instants."""

import itertools
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import imageio_ffmpeg
import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

import kinetruss as kt
from kinetruss import io, kinematics, runs, viewer
from kinetruss.cli import main
from kinetruss.display import OVER, SKINS, browser, colours_of, limits_of, rgb
from kinetruss.dynamics import linearise
from kinetruss.errors import AnalysisError, InputError, StoreError
from kinetruss.viewer import pictures
from kinetruss.viewer.picture_frame import strips
from kinetruss.viewer.pictures import PRESETS, _direction, _opened
from samples import fourbar

pytestmark = pytest.mark.slow

SIZE = (480, 360)
FFMPEG = re.compile(
    r"Duration: 00:00:(?P<seconds>[\d.]+).*?Video: (?P<codec>\w+).*?, (?P<pixels>\w+)\(.*?"
    r", (?P<size>\d+x\d+).*?, (?P<fps>[\d.]+) fps", re.DOTALL,
)  # fmt: skip


def pixels(path: Path | str) -> np.ndarray:
    with Image.open(path) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


def decoded(path: Path) -> tuple[dict[str, str], np.ndarray]:
    """What ffmpeg says of a film, and its frames (frames, height, width, 3)."""
    command = [
        imageio_ffmpeg.get_ffmpeg_exe(),
        "-i",
        path,
        "-fps_mode",
        "passthrough",
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgb24",
        "-",
    ]
    done = subprocess.run(command, capture_output=True, check=True)
    words = done.stderr.decode()
    told = FFMPEG.search(words).groupdict()
    width, height = map(int, told["size"].split("x"))
    return told, np.frombuffer(done.stdout, np.uint8).reshape(-1, height, width, 3).astype(int)


@contextmanager
def drawn(shown: viewer.Scene, size: tuple[int, int] = SIZE, camera="iso", **chosen) -> Iterator[Callable[[str], Any]]:
    """A question to the page that draws a bare picture; `film` is what it draws, `view` with which camera."""
    look = {"mode": None, "paths": [], "colour": None, "ghost": False, "faces": False, "loads": True, "grid": False}
    look |= {"width": size[0], "height": size[1], "direction": _direction(camera, shown.header["dim"]).tolist()} | chosen
    with _opened(shown) as browser:
        browser.ask(f"kinetruss.film({json.dumps(look)})")
        yield lambda asked: browser.ask(f"(() => {{ const film = kinetruss.shown, {{ view }} = film; return {asked}; }})()")


def places(ask: Callable[[str], Any], points: np.ndarray) -> np.ndarray:
    """Pixels (n, 2) of points (n, 3)."""
    return np.array(ask(f"{points.tolist()}.map((point) => view.project(point))"))[:, :2]


@pytest.mark.parametrize("size", [(480, 360), (361, 641)])
def test_a_picture_has_the_size_asked_for_and_shows_something(lift, tmp_path, size):
    shown = pixels(viewer.render(lift, tmp_path / "lift.png", size=size))
    assert shown.shape == (size[1], size[0], 3)
    above, below = strips(*size)[1:]
    middle = shown[above : size[1] - below]
    painted = (np.ptp(middle, axis=2) > 30).any(axis=0)
    assert painted.sum() > 0.1 * size[0]  # bars from left to right
    assert len(np.unique(middle.reshape(-1, 3), axis=0)) > 50
    assert (shown[:above].min(axis=2) < 128).sum() > 50  # letters of the title
    assert (shown[-below:].min(axis=2) < 128).sum() > 100  # the legend


@pytest.mark.parametrize("frame", [0, 13, 30])
def test_colours_are_those_of_the_forces(turn, tmp_path, frame):
    one = viewer.scene(turn)
    middles = np.pad(turn.motion.position.values[frame][one.arrays["ends"]].mean(axis=1), ((0, 0), (0, 1)))
    with drawn(one) as ask:
        where = places(ask, middles).round().astype(int)
    time = float(turn.motion.time.values[frame])
    shown = pixels(viewer.render(turn, tmp_path / "t.png", size=SIZE, at=time, bare=True, grid=False))
    force = next(iter(turn.forces.values())).member_force.values
    wanted = colours_of("diverging", force[frame], limits_of("diverging", force)).astype(int)
    for (x, y), colour in zip(where, wanted, strict=True):
        # a little to the side of the axis it is darker; on the axis it is the colour itself
        near = shown[y - 2 : y + 3, x - 2 : x + 3].reshape(-1, 3)
        assert np.abs(near - colour).max(axis=1).min() <= 6
    assert len(np.unique(wanted, axis=0)) == 3


def test_members_beyond_capacity_and_unknown_ones_have_colours_of_their_own():
    found = colours_of("capacity", np.array([0.0, 1.0, 1.01, np.nan]), (0.0, 1.0))
    assert np.array_equal(found, np.array([rgb("#482878"), rgb("#fde725"), rgb(OVER), rgb("#8a8a8a")]))
    assert limits_of("capacity", np.array([0.2, np.nan])) == limits_of("capacity", np.array([0.2, 7.0])) == (0.0, 1.0)
    assert limits_of("diverging", np.array([-3.0, 2.0])) == (-3.2, 3.2)
    assert limits_of("sequential", np.array([np.nan, 0.93])) == (0.0, 1.0)


@pytest.mark.parametrize("camera", [*PRESETS, (1, 2, -0.5)])
@pytest.mark.parametrize("wide", [0.5, 2.0])
def test_the_eye_sees_everything_as_large_as_can_be(lift, camera, wide):
    nodes = lift.motion.position.values.reshape(-1, 3)
    with drawn(viewer.scene(lift), (round(600 * wide), 600), camera) as ask:
        points = np.array(ask("film.places"))
        seen = places(ask, points) / (600 * wide, 600) * 1000
    assert (points.min(axis=0) <= nodes.min(axis=0)).all()
    assert (points.max(axis=0) >= nodes.max(axis=0)).all()
    assert seen.min() >= 20
    assert seen.max() <= 980
    spread = np.ptp(seen, axis=0)
    assert spread.max() > 850


def test_a_film_has_its_frames_and_its_length(lift, tmp_path):
    done: list[tuple[int, int]] = []
    path = viewer.render(
        lift, tmp_path / "new" / "lift.mp4", size=(320, 240), fps=20, speed=1.0, progress=lambda *n: done.append(n)
    )
    told, frames = decoded(path)
    assert (told["size"], told["fps"], told["codec"], told["pixels"]) == ("320x240", "20", "h264", "yuv420p")
    assert len(frames) == 21  # 1 s, both ends
    assert float(told["seconds"]) == pytest.approx(21 / 20, abs=0.01)
    assert done == [(k + 1, 21) for k in range(21)]
    assert np.abs(frames[0] - frames[-1]).max() > 100
    assert [one.name for one in path.parent.iterdir()] == ["lift.mp4"]


def test_frames_of_a_film_are_the_pictures_of_their_instants(lift, tmp_path):
    _, frames = decoded(viewer.render(lift, tmp_path / "lift.mp4", size=(320, 240), fps=10, speed=0.5))
    assert len(frames) == 21
    for k in (0, 7, 20):
        still = pixels(viewer.render(lift, tmp_path / "still.png", size=(320, 240), at=k * 0.05))
        apart = np.abs(frames - still).mean(axis=(1, 2, 3))
        assert apart.argmin() == k
        assert apart[k] < 1.5


def test_a_film_without_a_speed_takes_five_to_eight_seconds(lift, tmp_path):
    told, frames = decoded(viewer.render(lift, tmp_path / "lift.mp4", size=(240, 180), fps=6))
    assert 5 <= float(told["seconds"]) <= 8 + 1 / 6
    assert len(frames) == 41  # 1 s at 0.15 times real time


def test_rectangles_are_boxes_with_the_sides_of_their_section(tmp_path):
    """A flat bar in space: what is drawn has its height along axis 2, and its width along axis 3."""
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (1, 1, 0)}
    flat = kt.Bar(ends=("A", "B"), section=kt.Rectangle(width=0.03, height=0.06))
    round_ = kt.Bar(ends=("B", "C"), section=kt.Rod(diameter=0.04))
    model = kt.Model(nodes=nodes, bars={"flat": flat, "round": round_})
    with drawn(viewer.scene(model)) as ask:
        rods, boxes, bar = ask("[view.bars.rods.count, view.bars.boxes.count, [...view.bars.boxes.instanceMatrix.array]]")
        rims = ask("view.bars.rims.meshes.filter((rim) => rim.instanceMatrix === view.bars.boxes.instanceMatrix).length")
    assert (rods, boxes, rims) == (1, 1, 1)
    corners = np.array(list(itertools.product((-1, 1), (-0.5, 0.5), (-1, 1)))) @ np.reshape(bar, (4, 4))[:3, :3]
    assert np.ptp(corners, axis=0) == pytest.approx([1.0, 0.03, 0.06])  # axis 2 is upright: z is in the plane of axes 1 and 2
    shown = pixels(viewer.render(model, tmp_path / "flat.png", camera="front", size=(480, 360), bare=True, grid=False))
    assert (np.ptp(shown, axis=2) > 5).any()


def test_a_gif_plays_as_long_as_the_run(lift, tmp_path):
    path = viewer.render(lift, tmp_path / "lift.gif", size=(320, 240), fps=30, speed=1.0)
    lasts = []
    with Image.open(path) as film:
        for k in range(film.n_frames):
            film.seek(k)
            lasts.append(film.info["duration"])
        assert film.info["loop"] == 0
        film.seek(0)
        first = np.asarray(film.convert("RGB")).astype(int)
    # delays are whole hundredths: 33 frames a second; equal frames may be told as one that lasts longer
    assert sum(lasts) == pytest.approx(1000, abs=40)
    still = pixels(viewer.render(lift, tmp_path / "still.png", size=(320, 240)))
    assert np.abs(first - still).mean() < 4


def test_what_can_be_added_is_seen(lift, tmp_path):
    def shown(**chosen):
        return pixels(viewer.render(lift, tmp_path / "x.png", size=SIZE, at=1.0, bare=True, case="pushed", **chosen))

    plain = shown(grid=False, loads=False)
    for more in ({"ghost": True}, {"paths": ["T"]}, {"loads": True}, {"grid": True}):
        assert (np.abs(shown(**{"grid": False, "loads": False} | more) - plain).max(axis=2) > 20).sum() > 30, more


def test_a_model_stands_and_its_modes_swing(tmp_path):
    model = fourbar(drives={}, runs={}, gravity=(0, -9.81))
    assert pixels(viewer.render(model, tmp_path / "m.png", size=SIZE)).shape == (360, 480, 3)
    modes = linearise(model)
    _, frames = decoded(viewer.render(modes, tmp_path / "m.mp4", model=model, mode=0, size=(320, 240), fps=12))
    assert len(frames) == 30
    quarter = np.abs(frames[7] - frames[0]).mean()
    assert np.abs(frames[15] - frames[0]).mean() < 0.5 * quarter
    _, swung = decoded(viewer.render(model, tmp_path / "n.mp4", mode=0, size=(320, 240), fps=4))
    assert len(swung) == 10  # the mechanism of the model


def test_bodies_have_faces_and_nodes_alone_are_drawn(tmp_path):
    corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    solid = kt.Model(nodes=corners, bodies={"b": kt.Body(nodes=tuple(corners), mass=2.0)})
    bare = kt.Model(nodes=corners, bars={name: bar.ends for name, bar in solid.bars.items()})
    one, two = (pixels(viewer.render(model, tmp_path / "x.png", size=SIZE, bare=True)) for model in (solid, bare))
    assert (np.abs(one - two).max(axis=2) > 20).mean() > 0.03
    nodes = pixels(viewer.render(kt.Model(nodes=corners), tmp_path / "x.png", size=SIZE, bare=True, grid=False))
    assert (nodes.max(axis=2) < 200).sum() > 50


def test_a_membrane_has_the_colour_of_its_stress(tmp_path):
    mesh = kt.library.meshes.rectangle(width=1.0, height=1.0, columns=1, rows=1)
    model = kt.Model(
        nodes=mesh.nodes, membranes={"web": mesh.membrane(thickness=0.01)}, material=kt.Material(E=1e9, density=0.0)
    )
    start = np.array([node.at for node in model.nodes.values()])
    with drawn(viewer.scene(model)) as ask:
        assert ask("[0, 1].map((face) => view.skins.colourOf(face))") == [rgb(SKINS["membrane"]).tolist()] * 2
    held = model.with_(fixed=mesh.at(x=0.0), loads={n: kt.NodalForce(node=n, force=(1e4, 0.0)) for n in mesh.at(x=1.0)})
    rest = kt.statics.equilibrium(held)
    assert np.ptp(rest.data["position"].values[:, 0]) > np.ptp(start[:, 0])
    picture = pixels(viewer.render(rest, tmp_path / "x.png", model=held, size=SIZE, bare=True, loads=False, grid=False))
    shown = viewer.scene(rest, model=held)
    stress = shown.arrays["skin_stress"][0]
    colours = colours_of("sequential", stress, limits_of("sequential", shown.arrays["skin_stress"]))
    faces = np.pad(shown.arrays["position"][0], ((0, 0), (0, 1)))[shown.arrays["skin"]].mean(axis=1)
    with drawn(shown, colour="stress", loads=False) as ask:
        where = places(ask, faces).round().astype(int)
    for (x, y), colour in zip(where, colours, strict=True):
        assert picture[y, x] == pytest.approx(colour, abs=12)


def test_the_same_film_is_the_same_file(turn, tmp_path):
    one, two = (viewer.render(turn, tmp_path / name, size=(320, 240), fps=5) for name in ("one.gif", "two.gif"))
    assert one.read_bytes() == two.read_bytes()


def test_a_motion_without_forces_is_coloured_by_speed_or_kind(lift, tmp_path):
    motion = kinematics.follow(lift.model, lift.model.runs["lift"].trajectory)
    for colour in ("speed", "kind"):
        assert viewer.render(motion, tmp_path / "x.png", model=lift.model, colour=colour, size=SIZE).is_file()
    with pytest.raises(InputError, match=r"nothing to colour by force here. What can be shown: speed, kind"):
        viewer.render(motion, tmp_path / "x.png", model=lift.model, colour="force")


def test_a_film_cut_off_leaves_no_file_and_keeps_the_one_before(lift, tmp_path):
    class Cut(KeyboardInterrupt):
        pass

    def cut(done: int, total: int) -> None:
        if done == 5:
            raise Cut

    for name in ("film.mp4", "film.gif"):
        (tmp_path / name).write_text("before")
        with pytest.raises(Cut):
            viewer.render(lift, tmp_path / name, size=(320, 240), progress=cut)
        assert (tmp_path / name).read_text() == "before"
    assert sorted(one.name for one in tmp_path.iterdir()) == ["film.gif", "film.mp4"]


@pytest.mark.parametrize(
    ("name", "chosen", "words"),
    [
        ("x.jpg", {}, r"pictures end in \.png, films in \.mp4 or \.gif"),
        ("x.png", {"at": 1.5}, r"at=1\.5 s: the run goes from 0 to 1 s"),
        ("x.mp4", {"at": 0.5}, "goes with a picture"),
        ("x.mp4", {"size": (321, 240)}, "even width and height"),
        ("x.png", {"size": (10, 10)}, "240x180"),
        ("x.mp4", {"fps": 0}, "1 to 240"),
        ("x.mp4", {"speed": 0}, "positive"),
        ("x.png", {"colour": "forces"}, "No colour called 'forces'. Did you mean 'force'"),
        ("x.png", {"camera": "up"}, "No camera called 'up'"),
        ("x.png", {"camera": (0, 0, 0)}, "a direction"),
        ("x.png", {"paths": ["Z"]}, "No node called 'Z'"),
        ("x.png", {"case": "puhed"}, "No load case called 'puhed'"),
        ("x.png", {"mode": 0}, "there are 0 modes"),
    ],
)
def test_what_cannot_be_drawn_is_said(lift, tmp_path, name, chosen, words):
    with pytest.raises(InputError, match=words):
        viewer.render(lift, tmp_path / name, **chosen)
    assert list(tmp_path.iterdir()) == []


def test_what_stands_still_makes_no_film(lift, tmp_path):
    with pytest.raises(InputError, match="no motion to film"):
        viewer.render(lift.model, tmp_path / "x.gif")


def test_what_is_missing_is_named(lift, tmp_path, monkeypatch):
    monkeypatch.setattr(pictures, "chromium", lambda: None)
    with pytest.raises(InputError, match=r"Chromium, and none was found.*apt-get install chromium"):
        viewer.render(lift, tmp_path / "x.png")
    monkeypatch.undo()
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(InputError, match=r"pip install 'kinetruss\[render\]'"):
        viewer.render(lift, tmp_path / "x.mp4")
    monkeypatch.undo()
    monkeypatch.setenv("IMAGEIO_FFMPEG_EXE", str(tmp_path / "none"))
    with pytest.raises(InputError, match=r"No program ffmpeg.*or write a \.gif"):
        viewer.render(lift, tmp_path / "x.mp4")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "cannot be started"),
        ("#!/bin/sh\necho out of memory >&2\nexit 3\n", "out of memory"),
        ("#!/bin/sh\nexec sleep 60 3<&- 4>&-\n", "it ended"),
        ("#!/bin/sh\nexec sleep 60\n", "did not answer within 1 s"),
    ],
)
def test_a_browser_that_fails_is_told_and_ended(lift, tmp_path, monkeypatch, text, words):
    program = tmp_path / "browser"
    if text:
        program.write_text(text)
        program.chmod(0o755)
    monkeypatch.setattr(pictures, "chromium", lambda: str(program))
    monkeypatch.setattr(browser, "PATIENCE", 1.0)
    monkeypatch.setattr(browser, "LEAVE", 0.1)
    started, plain = [], os.posix_spawn
    monkeypatch.setattr(os, "posix_spawn", lambda *given, **more: started.append(plain(*given, **more)) or started[-1])
    with pytest.raises(AnalysisError, match=f"Nothing was drawn: .*{words}"):
        viewer.render(lift, tmp_path / "film.mp4")
    assert not (tmp_path / "film.mp4").exists()
    assert len(started) == bool(text)
    for one in started:
        with pytest.raises(ChildProcessError):  # it is not left
            os.waitpid(one, os.WNOHANG)


def test_a_file_that_cannot_be_written_is_named(lift, tmp_path):
    (tmp_path / "file").write_text("")
    for name in ("x.png", "x.mp4", "x.gif"):
        with pytest.raises(StoreError, match="cannot be written"):
            viewer.render(lift, tmp_path / "file" / name, size=(320, 240))


def test_the_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    io.write(fourbar(), tmp_path / "model.yaml")
    runs.run(fourbar(), "turn", tmp_path / "out")

    def call(text: str):
        return CliRunner().invoke(main, text.split())

    done = call("render out -o a.png --at 100ms --color utilisation --size 400x300 --camera 0,-1,2 --ghost --path B --json")
    assert done.exit_code == 0, done.output
    record = json.loads(done.stdout)
    assert (record["schema"], record["file"]) == ("kinetruss.render/1", "a.png")
    assert pixels("a.png").shape == (300, 400, 3)
    assert call("render model.yaml -o b.png --size 320x240 --bare").stdout == "b.png\n"
    io.write(fourbar(drives={}, runs={}, gravity=(0, -9.81)), tmp_path / "free.yaml")
    assert call("render free.yaml -o c.gif --mode 1 --fps 5 --size 320x240").exit_code == 0
    for text, words in (
        ("render out -o x.png --size big", "not a size"),
        ("render out -o x.png --camera 1,a,2", "is not a direction"),
        ("render out -o x.png --at 3kg", "not a time"),
        ("render out -o x.gif --mode 1", "--mode goes with"),
        ("render out -o x.bmp", "films in .mp4"),
        ("render nowhere -o x.png", "does not exist"),
    ):
        done = call(text)
        assert done.exit_code == 2, text
        assert words in done.stderr
