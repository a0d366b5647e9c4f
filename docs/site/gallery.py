"""The gallery: every example with its picture and film, made from its run when the site is built."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import kinetruss as kt

SECONDS, FPS = 4.0, 18.0
"""Length of a film, and its frames per second."""
VIDEO = """```{{raw}} html
<video class="film" src="../../_static/films/{name}.mp4" controls loop muted preload="metadata"></video>
```
"""


def pages(made: Path) -> Iterator[tuple[str, str]]:
    """The one page; pictures and films lie beside it."""
    folder = made / "gallery"
    folder.mkdir(parents=True, exist_ok=True)
    lines = [
        "# Gallery",
        "",
        "Every example that comes with kinetruss: `kinetruss examples NAME --copy my`, `kinetruss run my/NAME.yaml -o my/run`.",
        "",
    ]
    lines += ["`````{grid} 1 1 2 2", ":gutter: 3", ""]
    for name, (file, *_) in kt.library.example_files().items():
        lines += _card(name, file, folder)
    yield "gallery/index.md", "\n".join([*lines, "`````", ""])


def _card(name: str, file: Path, folder: Path) -> list[str]:
    model = kt.read(file)
    run = next(iter(model.runs))
    newer = max(file.stat().st_mtime, Path(kt.__file__).stat().st_mtime)
    film = VIDEO.format(name=name) if _drawn(name, model, run, folder, newer) else ""
    words = f"`{name}`, run `{run}`. {_comment(file)}"
    return [f"````{{grid-item-card}} {model.title}", "", f"![{model.title}]({name}.png)", "", film, words, "````", ""]


def _drawn(name: str, model: kt.Model, run: str, folder: Path, newer: float) -> bool:
    """Picture and, of runs that move, film; files that are newer than the example are kept."""
    picture, film = folder / f"{name}.png", folder.parent / "static" / "films" / f"{name}.mp4"
    film.parent.mkdir(parents=True, exist_ok=True)
    if picture.is_file() and picture.stat().st_mtime > newer:
        return film.is_file()
    found: Any = kt.run(model, run)
    kt.report.picture(found, picture)
    time = found.motion.arrays["time"].values
    if len(time) < 3 or "pose" in found.motion.arrays:
        return False
    kt.viewer.render(found, film, size=(640, 400), fps=FPS, speed=float(time[-1] - time[0]) / SECONDS)
    return True


def _comment(file: Path) -> str:
    """The first comment of the example that is not for editors."""
    text = re.sub(r"^# yaml-language-server.*\n", "", file.read_text("utf-8"))
    found = re.match(r"((?:#.*\n)+)", text)
    return " ".join(line.lstrip("# ").strip() for line in found[1].splitlines()) if found else ""
