"""Draws the pictures under docs/pictures: `make pictures`, or this file with the names of some.

Needs chromium and pdftoppm (Debian: poppler-utils).
"""

import subprocess
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import kinetruss as kt
from kinetruss.runs import RunResult

FOLDER = Path(__file__).parents[1] / "pictures"
EXAMPLES = kt.library.example_files()
COLOURS = 256
"""Colours of a picture's table."""
FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-sandbox"]

EXAMPLE: dict[str, dict[str, Any]] = {
    "slewing_experiments": {"run": "experiment_1", "at": (0, 0.5, 1), "width": 110},
    "mast": {"at": (0, 0.5, 1), "width": 110},
    "balanced_arm": {"at": (0, 0.25, 0.5), "width": 90, "paths": ["T"]},
    "planar_crane": {"at": (0, 0.5, 1), "width": 90, "paths": ["B8.N3"]},
    "facade": {"at": (0, 1), "width": 90, "case": "wind"},
    "wind_tower": {"at": (1,), "width": 90, "colour": "force"},
    "docking": {"at": (0, 0.85, 1), "width": 90, "case": "latching"},
    "space_crane": {"run": "lift", "at": (0, 1), "width": 90, "paths": ["B5.N8"], "colour": "force"},
}
"""Pictures of examples: fractions of the run that are shown, and how."""


@cache
def ran(name: str, run: str | None = None) -> RunResult:
    """A run of an example."""
    return kt.run(kt.read(EXAMPLES[name][0]), run)


def example(name: str, path: Path) -> None:
    """One of the pictures of `EXAMPLE`."""
    given = dict(EXAMPLE[name])
    found = ran(name, given.pop("run", None))
    time = found.motion.time.values
    at = [float(time[0] + part * (time[-1] - time[0])) for part in given.pop("at")]
    if given.get("case") not in found.forces:
        given.pop("case", None)
    kt.report.picture(found, path, at=at, names=False, **given)


def wiper(path: Path) -> None:
    """The windscreen wiper at three instants."""
    kt.report.picture(ran("wiper"), path, at=[0.12, 0.47, 1.13], colour="force", width="page", names=False, paths=["T", "U"])
    with Image.open(path) as drawn:
        drawn.convert("RGB").reduce(2).save(path)


def figure(name: str) -> Callable[[Path], None]:
    """A figure of the run of the slew."""

    def draw(path: Path) -> None:
        with tempfile.TemporaryDirectory() as folder:
            kt.report.figures(ran("double_octahedral_slew"), folder, formats=["png"])
            (Path(folder) / f"{name}.png").replace(path)

    return draw


def picture(path: Path) -> None:
    """The slew at three instants."""
    kt.report.picture(ran("double_octahedral_slew"), path, at=[0, 6, 12], colour="force", width="page")
    with Image.open(path) as drawn:
        drawn.convert("RGB").reduce(2).save(path)


def render(path: Path) -> None:
    """The slew, lit."""
    kt.viewer.render(ran("double_octahedral_slew"), path, at=8.0, size=(960, 600))


def isolator(path: Path) -> None:
    """The isolator with its beam."""
    kt.report.picture(kt.read(EXAMPLES["isolator_beam"][0]), path, width=90)


def moments(path: Path) -> None:
    """Bending moments of the portal frame of docs/pictures.md."""
    frame = kt.Model(
        nodes={"A": (0, 0), "B": (0, 4), "C": (6, 4), "D": (6, 0)}, material="steel_s235",
        section=kt.Rectangle(width=0.1, height=0.2), clamped=["A"], fixed=["D"],
        beams={"left": ("A", "B"), "rafter": ("B", "C"), "right": ("D", "C")},
        loads={"wind": kt.NodalForce(node="B", force=("15 kN", 0))}, runs={"rest": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    kt.report.picture(kt.run(frame), path, show="M", width=110)


def supports(path: Path) -> None:
    """A row of beams with a support of every kind."""
    names = "ABCDEFGHI"
    contact, soft = "1 MN/mm", "50 kN m/rad"
    held = {
        "A": kt.Support(x="held", y="held", rotation="held"), "B": kt.Support(x="held", y="held"), "C": kt.Support(y="held"),
        "D": kt.Support(y="held", turned="30 deg"), "E": kt.Support(y="2 kN/mm"), "F": kt.Support(y="2 kN/mm", rotation=soft),
        "G": kt.Support(y={"stiffness": contact, "gap": (0, None)}), "H": kt.Support(y="held", rotation="held"),
        "I": kt.Support(rotation={"stiffness": soft, "gap": "1 mrad"}),
    }  # fmt: skip
    row = kt.Model(
        nodes={name: (2.0 * k, 0.0) for k, name in enumerate(names)}, supports=held, material="steel_s235",
        beams={f"b{a}": (a, b) for a, b in pairwise(names)}, section=kt.Rectangle(width=0.1, height=0.2),
    )  # fmt: skip
    kt.report.picture(row, path, width="page", names=False)


@cache
def compared() -> dict[str, RunResult]:
    """The runs of docs/comparing.md, by duration and payload."""
    chosen = {"runs.extend.trajectory.duration": ["3", "5", "10"], "library.payload_mass": ["10 kg", "40 kg"]}
    folder = Path(tempfile.mkdtemp()) / "compare"
    words = [f"{key}={','.join(values)}" for key, values in chosen.items()]
    sets = [part for one in words for part in ("--set", one)]
    command = [
        str(Path(sys.executable).with_name("kinetruss")),
        "run",
        str(EXAMPLES["triangular_truss"][0]),
        *sets,
        "-o",
        str(folder),
    ]
    subprocess.run(command, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # 1: some are over a limit
    return {one.name: kt.runs.load(one) for one in sorted(folder.iterdir()) if one.is_dir()}


def compare(quantity: str, member: str, only: str = "") -> Callable[[Path], None]:
    """Curves of several runs."""

    def draw(path: Path) -> None:
        runs = [run for name, run in compared().items() if name.endswith(only)]
        kt.report.plot(runs, quantity, path, members=[member])

    return draw


def view(path: Path) -> None:
    """The page of the slew in a browser, with a member cut free."""
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as player:
        page = kt.viewer.write(ran("double_octahedral_slew"), Path(folder) / "view.html")
        browser = player.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        tab = browser.new_page(viewport={"width": 1280, "height": 880})
        tab.goto(page.as_uri())
        tab.wait_for_selector("#kinetruss[data-state=ready]")
        tab.evaluate(
            "() => { const { app } = kinetruss; app.toggle('names'); app.goTo(160); app.pick({type: 'member', name: 'M7'}); }"
        )
        tab.wait_for_timeout(500)
        tab.screenshot(path=path)
        browser.close()


def report(path: Path) -> None:
    """The first two pages of the report of the slew, beside each other on grey."""
    with tempfile.TemporaryDirectory() as folder:
        run = kt.run(kt.read(EXAMPLES["double_octahedral_slew"][0]), out=Path(folder) / "run")
        kt.report.write_document(run, Path(folder) / "report")
        paper = next((Path(folder) / "report").glob("*.pdf"))
        subprocess.run(["pdftoppm", "-png", "-r", "66", "-l", "2", str(paper), f"{folder}/page"], check=True)
        pages = [Image.open(one).convert("RGB") for one in sorted(Path(folder).glob("page*.png"))]
        width, height = pages[0].size
        sheet = Image.new("RGB", (2 * width + 18, height + 12), "#d0d3d8")
        for k, one in enumerate(pages):
            sheet.paste(one, (6 + k * (width + 6), 6))
        sheet.save(path)


def diagrams(path: Path) -> None:
    """Section forces along the beams of a portal frame under weight, wind and a load."""
    frame = kt.Model(
        nodes={"A": (0, 0), "B": (0, 3), "M": (2, 3), "C": (4, 3), "D": (4, 0)},
        clamped=["A", "D"],
        beams={"left": ("A", "B"), "top1": ("B", "M"), "top2": ("M", "C"), "right": ("D", "C")},
        section=kt.Rectangle(width=0.1, height=0.1),
        material=kt.library.materials.STEEL_S235,
        gravity=(0, -9.81),
        loads={"wind": kt.NodalForce(node="B", force=(4e3, 0)), "crane": kt.NodalForce(node="M", force=(0, -12e3))},
        runs={"load": kt.Run(analysis="statics.linear")},
    )
    kt.report.diagrams(kt.run(frame), path, width="page")


def links(path: Path) -> None:
    """Section forces along the legs of a scissor lift at the start of its motion."""
    lift = kt.Model(
        nodes={"A": (0, 0), "B": (0.8, 0), "M": (0.4, 0.3), "C": (0.8, 0.6), "D": (0, 0.6)},
        fixed={"A": "xy", "B": "y"},
        links={"front": ("A", "M", "C"), "back": ("B", "M", "D")},
        section=kt.Rectangle(width=0.02, height=0.06),
        material=kt.library.materials.STEEL_S235,
        gravity=(0, -9.81),
        drives={"push": kt.CoordinateDrive(node="B", axis="x")},
        loads={side: kt.NodalForce(node=side, force=(0, -1e3)) for side in ("C", "D")},
        runs={"up": kt.Run(trajectory=kt.Quintic(moves={"push": (0.8, 0.5)}, duration=4.0))},
    )
    kt.report.diagrams(kt.run(lift), path, members=["front", "back"], at=0.0, width="page")


PICTURES: dict[str, Callable[[Path], None]] = {
    "wiper": wiper,
    "shape": figure("shape"),
    "forces": figure("forces"),
    "picture": picture,
    "render": render,
    "isolator_beam": isolator,
    "moments": moments,
    "supports": supports,
    "compare_stress": compare("von_mises", "follower"),
    "compare_components": compare("components", "follower", "10kg"),
    "compare_motion": compare("motion", "actuator", "10kg"),
    "compare_drive": compare("drive", "actuator", "10kg"),
    "view": view,
    "report": report,
    "diagrams": diagrams,
    "links": links,
    **{f"example_{name}": lambda path, name=name: example(name, path) for name in EXAMPLE},
}


def main(names: list[str]) -> None:
    """Draw the pictures named, or all."""
    for name in names or list(PICTURES):
        path = FOLDER / f"{name}.png"
        PICTURES[name](path)
        with Image.open(path) as drawn:
            few = drawn.convert("RGB").quantize(COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
            if np.abs(np.asarray(few.convert("RGB"), int) - np.asarray(drawn.convert("RGB"), int)).mean() < 1.0:
                few.save(path, optimize=True)
        sys.stderr.write(f"{path}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
