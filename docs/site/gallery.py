"""The gallery: every example with its picture and film, made from its run when the site is built."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import kinetruss as kt

SECONDS, FPS = 4.0, 18.0
"""Length of a film, and its frames per second."""
VIDEO = """```{{raw}} html
<video class="film" title="{title}" tabindex="0" loop muted playsinline preload="metadata"
  src="../../_static/films/{name}.mp4"></video>
```
"""
FILMS = """```{raw} html
<script>
// A film plays while the pointer or the focus is on it, and stops at a click; its controls are there meanwhile.
document.querySelectorAll("video.film").forEach((film) => {
  const on = () => { film.controls = true; film.play().catch(() => {}); };
  const off = () => { film.controls = false; film.pause(); };
  film.addEventListener("pointerenter", on); film.addEventListener("focus", on);
  film.addEventListener("pointerleave", off); film.addEventListener("blur", off);
});
</script>
```
"""
GROUPS = {
    "Machines": ("wiper", "four_bar", "stewart", "delta", "robot", "planar_crane", "space_crane"),
    "Adaptive trusses": (
        "double_octahedral_slew", "double_octahedral_fast", "triangular_truss", "chain_two_axis", "mast", "serpentine_arm",
        "docking", "opposed_trusses",
    ),
    "Buildings that adapt": ("facade", "wind_tower"),
    "Drives, springs and elastic members": ("drive_train", "driven_bay", "elastic_bay", "isolator", "isolator_beam"),
    "Measurements": ("slewing_experiments", "measured_slew", "strain_gauges"),
    "Linkages of the textbooks": ("peaucellier", "double_pendulum", "bricard", "andrews"),
}  # fmt: skip
"""Examples by subject, what everyone knows first."""


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
    files = {name: file for name, (file, *_) in kt.library.example_files().items()}
    for group, names in GROUPS.items():
        lines += [f"## {group}", "", "`````{grid} 1 1 2 2", ":gutter: 3", ""]
        for name in names:
            lines += _card(name, files[name], folder)
        lines += ["`````", ""]
    yield "gallery/index.md", "\n".join([*lines, FILMS])


def _card(name: str, file: Path, folder: Path) -> list[str]:
    model = kt.read(file)
    run = next(iter(model.runs))
    newer = max(file.stat().st_mtime, Path(kt.__file__).stat().st_mtime)
    moves = _drawn(name, model, run, folder, newer)
    shown = VIDEO.format(name=name, title=model.title) if moves else f"![{model.title}]({name}.png)\n"
    words = f"`{name}`, run `{run}`. {_comment(file)}"
    return [f"````{{grid-item-card}} {model.title}", ":class-card: example", "", shown, words, "````", ""]


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
