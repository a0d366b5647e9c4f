"""The gallery: every example with its picture and film, made from its run when the site is built."""

import re
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
    "Machines": (
        "scissor_lift", "loader_crane", "balanced_arm", "landing_gear", "press", "folding_array", "wiper",
        "double_wishbone", "jansen_leg", "four_bar", "stewart", "delta", "robot", "planar_crane", "space_crane",
    ),
    "Adaptive trusses": (
        "double_octahedral_slew", "triangular_truss", "chain_two_axis", "mast", "mast_design", "docking",
    ),
    "Buildings that adapt": ("adaptive_footbridge", "facade", "wind_tower"),
    "Drives, springs and elastic members": ("drive_train", "driven_bay", "isolator_beam"),
    "Measurements": ("slewing_experiments", "measured_slew", "strain_gauges"),
    "Linkages of the textbooks": ("peaucellier", "double_pendulum", "bricard", "andrews"),
}  # fmt: skip
"""Examples by subject, what everyone knows first."""


def names() -> list[str]:
    """All examples of the gallery."""
    return [name for group in GROUPS.values() for name in group]


def pages(moves: dict[str, bool]) -> list[tuple[str, str]]:
    """The one page; pictures and films lie beside it. moves : of each example, whether it has a film."""
    lines = [
        "# Gallery",
        "",
        "Every example that comes with kinetruss: `kinetruss examples NAME --copy my`, `kinetruss run my/NAME.yaml -o my/run`.",
        "",
    ]
    for group, several in GROUPS.items():
        lines += [f"## {group}", "", "`````{grid} 1 1 2 2", ":gutter: 3", ""]
        for name in several:
            lines += _card(name, moves[name])
        lines += ["`````", ""]
    return [("gallery/index.md", "\n".join([*lines, FILMS]))]


def drawn(name: str, made: Path) -> bool:
    """Draw an example and, if it moves, film it; whether it does."""
    model, run = _example(name)
    picture, film = made / "gallery" / f"{name}.png", made / "static" / "films" / f"{name}.mp4"
    for path in (picture, film):
        path.parent.mkdir(parents=True, exist_ok=True)
    found: Any = kt.run(model, run)
    kt.report.picture(found, picture)
    time = found.motion.arrays["time"].values
    if len(time) < 3 or "pose" in found.motion.arrays:
        film.unlink(missing_ok=True)
        return False
    kt.viewer.render(found, film, size=(640, 400), fps=FPS, speed=float(time[-1] - time[0]) / SECONDS)
    return True


def _example(name: str) -> tuple[kt.Model, str]:
    model = kt.read(kt.library.example_files()[name][0])
    return model, next(iter(model.runs))


def _card(name: str, moves: bool) -> list[str]:
    model, run = _example(name)
    shown = VIDEO.format(name=name, title=model.title) if moves else f"![{model.title}]({name}.png)\n"
    words = f"`{name}`, run `{run}`. {_comment(kt.library.example_files()[name][0])}"
    return [f"````{{grid-item-card}} {model.title}", ":class-card: example", "", shown, words, "````", ""]


def _comment(file: Path) -> str:
    """The first comment of the example that is not for editors."""
    text = re.sub(r"^# yaml-language-server.*\n", "", file.read_text("utf-8"))
    found = re.match(r"((?:#.*\n)+)", text)
    return " ".join(line.lstrip("# ").strip() for line in found[1].splitlines()) if found else ""
